// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportJointBlock_h
#define LittoralSupportJointBlock_h

// The joints of moving plants as a block, for those who move skins elsewhere. Private: never installed, never wrapped.

#include "Plants/Skinning.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace littoral
{

/// Names of the block and its arrays.
namespace joint
{
constexpr const char* Joints = "Joints";
constexpr const char* ParentId = "ParentId";
constexpr const char* RestPosition = "RestPosition";
constexpr const char* Rotation = "Rotation";
}

/// A point for each joint where it is [m], with its parent (-1: none), its position at rest [m], and its rotation since
/// then as a quaternion w, x, y, z.
vtkSmartPointer<vtkPolyData> JointBlock(const std::vector<JointChange>& changes, const std::vector<int>& parents);

}

#endif
