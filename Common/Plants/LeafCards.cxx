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
constexpr double Hang = 0.45;     ///< tangent of the angle of a leaf's tip and edges to its middle

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

/// A blade of a spray; lengths are in that of the spray.
struct SprayBlade
{
  double Foot;  ///< on the twig
  double Angle; ///< from the twig, to the right
  double Length;
  double Shade;
  std::array<double, 2> Ahead{ std::sin(Angle), std::cos(Angle) }; ///< along the blade
};

/// Blades from the front to the back: each lies upon the next one below it.
const SprayBlade Spray[] = { { 0.585, 0.02, 0.38, 1.0 }, { 0.47, 0.72, 0.33, 0.97 }, { 0.43, -0.80, 0.34, 0.98 },
  { 0.27, 1.02, 0.34, 0.93 }, { 0.24, -1.05, 0.345, 0.95 }, { 0.10, 0.72, 0.31, 0.89 }, { 0.06, -0.62, 0.31, 0.91 } };
/// Opacity of what is not a blade: cut out by itself, but not in a mean with the blades around it, so that a spray that
/// is seen from afar fills its kite.
constexpr int GapOfSpray = 70;
constexpr double ShadeOfSpray = 0.86; ///< mean of its blades
constexpr double SprayWidth = 0.7;    ///< of the kite for which its blades have their forms, over its length
constexpr double BladeWidth = 0.59;   ///< over its length

/// Shade of a lobed blade with its veins, half of which is turned from the light; 0 beside it.
double LobedShade(const SprayBlade& blade, double x, double y)
{
  const std::array<double, 2>& ahead = blade.Ahead;
  const double along = (x * ahead[0] + (y - blade.Foot) * ahead[1]) / blade.Length;
  const double across = (x * ahead[1] - (y - blade.Foot) * ahead[0]) / (0.5 * BladeWidth * blade.Length);
  const double side = std::abs(across);
  if (along <= 0.0 || along >= 1.0 || side > 1.0) // the blade is at most 1 wide
  {
    return 0.0;
  }
  const double half = along < 0.45 ? std::sin(0.5 * Pi * along / 0.45) : std::cos(0.5 * Pi * (along - 0.45) / 0.55);
  const double lobe = std::sin(4.0 * Pi * along + 0.6);
  if (side > std::pow(half, 0.8) * (1.0 - 0.16 * lobe * lobe))
  {
    return 0.0;
  }
  const bool onVein = side < 0.07 || std::abs(std::remainder(5.0 * along - 1.1 * side, 1.0)) < 0.06;
  return blade.Shade * (onVein ? 0.87 : 1.0 - 0.08 * (1.0 - side)) * (across > 0.0 ? 1.0 : 0.95);
}

/// The same for a spray: blades on both sides of a twig.
double SprayShade(double across, double along)
{
  const double x = 0.5 * SprayWidth * across;
  for (const SprayBlade& blade : Spray)
  {
    if (const double shade = LobedShade(blade, x, along); shade > 0.0)
    {
      return shade;
    }
  }
  return std::abs(x) < 0.012 && along < Spray[0].Foot ? 0.5 : 0.0;
}

double ShadeOf(LeafForm form, double across, double along)
{
  switch (form)
  {
    case LeafForm::Needle:
      return NeedleShade(across, along);
    case LeafForm::Spray:
      return SprayShade(across, along);
    default:
      return BladeShade(across, along);
  }
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
      mesh.Normals.push_back(
        Normalised(leaf.Normal + Hang * (across * side + (along > Broadest ? along : 0.0) * leaf.Axis)));
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
        const double shade = ShadeOf(form, 2.0 * u - 1.0, v);
        shades += shade;
        hits += shade > 0.0 ? 1 : 0;
      }
      const bool isSpray = form == LeafForm::Spray;
      const double beside = isSpray ? ShadeOfSpray : 0.9;
      const auto grey = static_cast<unsigned char>(std::lround(255.0 * (hits > 0 ? shades / hits : beside)));
      const int gap = isSpray ? GapOfSpray : 0;
      const auto opacity = static_cast<unsigned char>(gap + (255 - gap) * hits / (Samples * Samples));
      picture.At(column, row) = { grey, grey, grey, opacity };
    }
  }
  return picture;
}

}
