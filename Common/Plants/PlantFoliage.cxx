// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/PlantFoliage.h"

#include "Numerics/Rotation.h"

namespace littoral
{

namespace
{

/// Twice the area of a triangle, along its normal.
Vector3 NormalOf(const FoliageTriangle& triangle)
{
  const auto& corners = triangle.Corners;
  return glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
}

CutPolygon PolygonOf(const FoliageTriangle& triangle)
{
  return TriangleOf(triangle.Corners[0], triangle.Corners[1], triangle.Corners[2]);
}

FoliageTriangle Placed(const FoliageTriangle& triangle, const FoliagePlace& place)
{
  FoliageTriangle placed = triangle;
  for (Vector3& corner : placed.Corners)
  {
    corner = place.Apply(corner);
  }
  return placed;
}

}

double CountedArea(const FoliageTriangle& triangle)
{
  return 0.5 * triangle.Part * glm::length(NormalOf(triangle));
}

double CountedArea(const std::vector<FoliageTriangle>& triangles)
{
  double sum = 0.0;
  for (const FoliageTriangle& triangle : triangles)
  {
    sum += CountedArea(triangle);
  }
  return sum;
}

Vector3 FoliagePlace::Apply(const Vector3& point) const
{
  return this->Foot + Rotated(this->Rotation, this->Scale * point);
}

void AddLeaf(const FoliageTriangle& triangle, int kind, CanopyDensity& density)
{
  CutToCells(density.GetGrid(), PolygonOf(triangle),
    [&](std::size_t cell, const CutPolygon& part) { density.AddLeaf(kind, cell, triangle.Part * part.Area()); });
}

void AddWood(const FoliageTriangle& triangle, CanopyDensity& density)
{
  CutToCells(density.GetGrid(), PolygonOf(triangle),
    [&](std::size_t cell, const CutPolygon& part) { density.AddWood(cell, triangle.Part * part.Area()); });
}

void AddPlant(const PlantFoliage& plant, const FoliagePlace& place, CanopyDensity& density)
{
  for (const FoliageTriangle& leaf : plant.Leaves)
  {
    AddLeaf(Placed(leaf, place), place.Kind, density);
  }
  for (const FoliageTriangle& bark : plant.Wood)
  {
    AddWood(Placed(bark, place), density);
  }
}

void AddInclination(const std::vector<FoliageTriangle>& leaves, LeafInclination& inclination)
{
  for (const FoliageTriangle& leaf : leaves)
  {
    inclination.Add(NormalOf(leaf), CountedArea(leaf));
  }
}

}
