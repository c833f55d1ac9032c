// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralRiverSurface_h
#define LittoralRiverSurface_h

#include "Numerics/Vector3.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace littoral
{

/// Rivers that share their confluences.
struct RiverNetwork
{
  std::vector<Vector3> Places; ///< of nodes [m]
  std::vector<double> Areas;   ///< that drain to them [m^2]
  /// Nodes of each river downstream, two or more: the last may be one of another river, as may the first.
  std::vector<std::vector<std::size_t>> Courses;
};

/// Form of the surface of rivers.
struct RiverShape
{
  double WidthOfUnitArea = 2.8; ///< of a river that drains 1 km^2 [m]
  double WidthExponent = 0.45;  ///< w ~ A^b, as of discharge (Leopold and Maddock 1953)
  int Smoothing = 6;            ///< times that courses are smoothed, over sqrt(times / 2) cells
  int Subdivision = 4;          ///< parts of a step from node to node
};

/// Why a shape is invalid; empty if it is valid.
std::string WhyInvalid(const RiverShape& shape);

/// Width of a river [m], w = w1 (A / 1 km^2)^b
double RiverWidth(const RiverShape& shape, double area);

/// Moves the nodes of courses, but for heads and ends, so that the corners of cells go: p = p(up)/4 + p/2 + p(down)/4,
/// with the larger river upstream of a confluence.
void SmoothCourses(RiverNetwork& network, int times);

/// Raises places until each is at least as high as that downstream of it.
void LetFlow(RiverNetwork& network);

/// Section across a river: its left and right bank, looking downstream, at one height.
struct RiverSection
{
  std::array<Vector3, 2> Banks;
  Vector3 Normal; ///< of the surface, upward
  double Area;    ///< that drains there [m^2]
  double Width;   ///< [m]
};

/// Sections of each river along a cubic curve through its nodes (Catmull and Rom 1974).
std::vector<std::vector<RiverSection>> RiverSections(const RiverNetwork& network, const RiverShape& shape);

}

#endif
