// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TreeLevels.h"

#include "Constants.h"

#include <cmath>

namespace littoral
{

namespace
{

constexpr int CornersOfEllipse = 24;

/// Adds a polygon in the vertical plane through the axis, given by distances from the axis and heights [m].
void AddUpright(
  PlantMesh& mesh, const std::vector<std::array<double, 2>>& outline, const Vector3& across, const Colour& colour)
{
  std::vector<int> corners;
  for (const auto& corner : outline)
  {
    corners.push_back(static_cast<int>(mesh.Points.size()));
    mesh.Points.push_back({ corner[0] * across[0], corner[0] * across[1], corner[1] });
    mesh.Normals.push_back({ across[1], -across[0], 0.0 });
    mesh.Colours.push_back(colour);
  }
  mesh.AddPolygon(corners);
}

std::vector<std::array<double, 2>> CrownOutline(const ReevesTreeParameters& p)
{
  if (p.Shape == CrownShape::Cone)
  {
    return { { -p.CrownRadius, p.CrownBase }, { p.CrownRadius, p.CrownBase }, { 0.0, p.Height } };
  }
  std::vector<std::array<double, 2>> outline;
  for (int corner = 0; corner < CornersOfEllipse; ++corner)
  {
    const double angle = TwoPi * corner / CornersOfEllipse;
    outline.push_back({ p.CrownRadius * std::cos(angle),
      0.5 * (p.Height + p.CrownBase) + 0.5 * (p.Height - p.CrownBase) * std::sin(angle) });
  }
  return outline;
}

}

PlantMesh LowTree(const ReevesTreeParameters& p)
{
  const double r = p.TrunkRadius;
  const double top = p.Height * p.TrunkReach;
  const std::vector<std::array<double, 2>> trunk{ { -r, 0.0 }, { r, 0.0 }, { r, top }, { -r, top } };
  const std::vector<std::array<double, 2>> crown = CrownOutline(p);
  PlantMesh mesh;
  for (const Vector3& across : { Vector3{ 1.0, 0.0, 0.0 }, Vector3{ 0.0, 1.0, 0.0 } })
  {
    AddUpright(mesh, trunk, across, p.Bark);
    AddUpright(mesh, crown, across, p.Leaf);
  }
  return mesh;
}

}
