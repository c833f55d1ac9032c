// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/LeafCards.h"

#include "Numerics/Constants.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr int Samples = 4;        ///< along an edge of a texel
constexpr double Broadest = 0.42; ///< where the kite is widest, from its foot

/// Shade of a leaf at a place across (-1 to 1) and along (0 to 1) the kite, 0 where there is none.
double BladeShade(double across, double along)
{
  const double x = std::abs(across);
  const double half = along < Broadest ? std::sin(0.5 * Pi * along / Broadest)
                                       : std::cos(0.5 * Pi * (along - Broadest) / (1.0 - Broadest));
  const double lobes = 1.0 - 0.1 * std::abs(std::sin(9.0 * Pi * along));
  if (x > 0.97 * half * lobes)
  {
    return 0.0;
  }
  const bool onVein = x < 0.035 || std::abs(std::remainder(7.0 * along - 2.2 * x, 1.0)) < 0.06;
  return onVein ? 0.84 : 1.0 - 0.12 * (1.0 - x);
}

/// The same for a tuft: a stalk with needles that point forward.
double NeedleShade(double across, double along)
{
  const double x = std::abs(across);
  const double stalk = 0.05 * (1.0 - along);
  if (x < stalk)
  {
    return 0.6;
  }
  const double reach = std::min(1.0, 2.4 * (1.0 - along)) * std::min(1.0, 0.35 + 3.0 * along);
  const double needle = std::abs(std::remainder(11.0 * along - 2.6 * x, 1.0));
  return x < reach && needle < 0.27 * (1.0 - 0.6 * x) ? 1.0 - 0.25 * needle : 0.0;
}

}

PlantMesh LeafCards(const Plant& plant, const Poll& poll)
{
  PlantMesh mesh;
  const std::size_t vertices = 4 * plant.Leaves.size();
  mesh.Points.reserve(vertices);
  mesh.Normals.reserve(vertices);
  SteppedPoll steps(poll);
  for (const LeafParticle& leaf : plant.Leaves)
  {
    steps.Step();
    const Vector3 side = glm::cross(leaf.Axis, leaf.Facing);
    const int first = static_cast<int>(mesh.Points.size());
    const double half = 0.5 * leaf.Width * leaf.Size;
    const auto add = [&](double across, double along, double u, double v) {
      mesh.Points.push_back(leaf.Position + across * half * side + along * leaf.Size * leaf.Axis);
      mesh.Normals.push_back(leaf.Normal);
      mesh.TCoords.push_back({ u, v });
      mesh.Colors.push_back(leaf.Tint);
      mesh.JointIds.push_back({ leaf.Node, leaf.Node, leaf.Node, leaf.Node });
      mesh.JointWeights.push_back({ 1.0, 0.0, 0.0, 0.0 });
    };
    add(0.0, 0.0, 0.5, 0.0);
    add(1.0, Broadest, 1.0, Broadest);
    add(0.0, 1.0, 0.5, 1.0);
    add(-1.0, Broadest, 0.0, Broadest);
    mesh.AddPolygon(std::array<int, 4>{ first, first + 1, first + 2, first + 3 });
  }
  return mesh;
}

TextureImage LeafPicture(LeafForm form)
{
  TextureImage picture(LeafPictureSize, LeafPictureSize);
  for (int row = 0; row < LeafPictureSize; ++row)
  {
    for (int column = 0; column < LeafPictureSize; ++column)
    {
      double shades = 0.0;
      int hits = 0;
      for (int sample = 0; sample < Samples * Samples; ++sample)
      {
        const int across = sample % Samples;
        const int down = sample / Samples;
        const double u = (column + (across + 0.5) / Samples) / LeafPictureSize;
        const double v = (row + (down + 0.5) / Samples) / LeafPictureSize;
        const double shade = form == LeafForm::Blade ? BladeShade(2.0 * u - 1.0, v) : NeedleShade(2.0 * u - 1.0, v);
        shades += shade;
        hits += shade > 0.0 ? 1 : 0;
      }
      const auto grey = static_cast<unsigned char>(std::lround(255.0 * (hits > 0 ? shades / hits : 0.9)));
      const auto opacity = static_cast<unsigned char>(255 * hits / (Samples * Samples));
      picture.At(column, row) = { grey, grey, grey, opacity };
    }
  }
  return picture;
}

}
