// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportSeaweedBlocks_h
#define LittoralSupportSeaweedBlocks_h

// Segments of seaweeds between the numerics and VTK: the one place that knows names and types of their arrays. They are
// point arrays of High/Skeleton; a node has the values of the segment that starts there, a tip those of the segment
// that ends there. Private: never installed, never wrapped.

#include "Plants/SeaweedSegment.h"
#include "Plants/Skeleton.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace littoral
{

/// Names of arrays, of one number each, float but for Tissue (int), and Across (three).
namespace seaweed
{
constexpr const char* Tissue = "Tissue";             ///< a SeaweedTissue
constexpr const char* Width = "Width";               ///< [m]
constexpr const char* Thickness = "Thickness";       ///< [m]
constexpr const char* YoungModulus = "YoungModulus"; ///< [Pa]
constexpr const char* DampingRatio = "DampingRatio"; ///< of critical
constexpr const char* Density = "Density";           ///< [kg/m3]
constexpr const char* Across = "Across";             ///< unit vector along Width
constexpr const char* Length = "Length";             ///< [m]
constexpr const char* Attachment = "Attachment";     ///< h of the paper [m]
constexpr const char* RestTheta = "RestTheta";       ///< of the paper [rad]
constexpr const char* RestPhi = "RestPhi";           ///< of the paper [rad]
}

/// Adds the arrays to the skeleton as a block.
void AddSegments(const Skeleton& skeleton, const std::vector<SeaweedSegment>& segments, vtkPolyData* block);

/// Reads what AddSegments wrote, but for what follows from the skeleton. Throws InvalidInput.
std::vector<SeaweedSegment> ReadSegments(vtkPolyData* block);

}

#endif
