// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPlantFoliage_h
#define LittoralPlantFoliage_h

#include "Numerics/Vector3.h"
#include "Plants/CanopyDensity.h"
#include "Plants/LeafInclination.h"

#include <glm/gtc/quaternion.hpp>

#include <array>
#include <vector>

namespace littoral
{

/// A triangle of a leaf or of bark.
struct FoliageTriangle
{
  std::array<Vector3, 3> Corners;
  double Part = 1.0; ///< of its area that counts: what its picture covers of a leaf; half of the surface of bark
};

/// Area of a triangle that counts [m2].
double CountedArea(const FoliageTriangle& triangle);

/// A plant of a kind with all its triangles.
struct PlantFoliage
{
  std::vector<FoliageTriangle> Leaves;
  std::vector<FoliageTriangle> Wood;
};

/// Sum of the counted areas [m2].
double CountedArea(const std::vector<FoliageTriangle>& triangles);

/// A plant in a stand: scaled, rotated and moved.
struct FoliagePlace
{
  int Kind = 0;
  Vector3 Foot{ 0.0, 0.0, 0.0 }; ///< [m]
  glm::dquat Rotation{ 1.0, 0.0, 0.0, 0.0 };
  Vector3 Scale{ 1.0, 1.0, 1.0 };

  Vector3 Apply(const Vector3& point) const;
};

/// Shares a leaf or a piece of bark between the cells that it lies in.
void AddLeaf(const FoliageTriangle& triangle, int kind, CanopyDensity& density);
void AddWood(const FoliageTriangle& triangle, CanopyDensity& density);

/// All leaves and all bark of a plant, each shared between the cells that it lies in.
void AddPlant(const PlantFoliage& plant, const FoliagePlace& place, CanopyDensity& density);

/// The angles of leaves.
void AddInclination(const std::vector<FoliageTriangle>& leaves, LeafInclination& inclination);

}

#endif
