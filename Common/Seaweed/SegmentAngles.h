// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSegmentAngles_h
#define LittoralSegmentAngles_h

#include "Plants/Skeleton.h"

#include <vector>

namespace littoral
{

/**
 * A segment in the words of Coulais et al. (section 4.2, figure 7), with right-handed local bases X, Y, Z and Y along
 * the segment. A segment starts Attachment along its parent segment from the parent's foot; its base is that of its
 * parent turned by Theta about the parent's Y and then by Phi about its own X. The first segment of a plant has for a
 * parent the ground, with X = x, Y = up and Z = -y, and starts on it.
 */
struct SegmentAngles
{
  double Attachment = 0.0; ///< h [m]
  double Theta = 0.0;      ///< azimuth [rad], -pi to pi
  double Phi = 0.0;        ///< tilt [rad], 0 to pi
};

/// The angles of the segment that starts at each node; a tip has those of the segment that ends there. Theta is 0 where
/// Phi is. The skeleton must be valid.
std::vector<SegmentAngles> AnglesOf(const Skeleton& skeleton);

}

#endif
