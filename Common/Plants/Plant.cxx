// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/Plant.h"

#include "Numerics/RandomStream.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

double Depth(const CrownVolume& crown, const Vector3& position)
{
  const Vector3 away = position - crown.Foot;
  const double outward = std::hypot(away.x, away.y) / crown.Radius;
  const double up = away.z / crown.Height;
  if (crown.Shape == CrownShape::Cone)
  {
    return up < 0.0 || up >= 1.0 ? -1.0 : 1.0 - outward / (1.0 - up);
  }
  return 1.0 - std::hypot(outward, 2.0 * up - 1.0);
}

Vector3 Outward(const CrownVolume& crown, const Vector3& position)
{
  const Vector3 away = position - crown.Foot;
  if (crown.Shape == CrownShape::Cone)
  {
    const Vector3 flat = Normalised({ away.x, away.y, 0.0 });
    return Normalised({ flat.x * crown.Height, flat.y * crown.Height, crown.Radius });
  }
  const double across = crown.Radius * crown.Radius;
  const double along = 0.25 * crown.Height * crown.Height;
  return Normalised({ away.x / across, away.y / across, (away.z - 0.5 * crown.Height) / along });
}

Vector3 LitNormal(const CrownVolume& crown, const Vector3& position, const Vector3& facing)
{
  return Normalised(facing + 0.6 * Normalised(Outward(crown, position) + Vector3(0.0, 0.0, 0.55)));
}

CrownVolume VolumeAround(const std::vector<Vector3>& positions, CrownShape shape)
{
  CrownVolume crown;
  crown.Shape = shape;
  if (positions.empty())
  {
    return crown;
  }
  Vector3 sum{ 0.0, 0.0, 0.0 };
  double low = positions.front().z;
  double high = low;
  for (const Vector3& position : positions)
  {
    sum += position;
    low = std::min(low, position.z);
    high = std::max(high, position.z);
  }
  const Vector3 mean = sum / static_cast<double>(positions.size());
  // Room above and below, since a volume that touches both ends would have to be infinitely wide there.
  const double slack = 0.1 * std::max(high - low, 1e-3);
  crown.Foot = { mean.x, mean.y, low - (shape == CrownShape::Ellipsoid ? slack : 0.0) };
  crown.Height = high + slack - crown.Foot.z;
  crown.Radius = 1e-3;
  for (const Vector3& position : positions)
  {
    const Vector3 away = position - crown.Foot;
    const double up = away.z / crown.Height;
    const double widest = shape == CrownShape::Cone ? 1.0 - up : std::sqrt(1.0 - (2.0 * up - 1.0) * (2.0 * up - 1.0));
    crown.Radius = std::max(crown.Radius, 1.0000001 * std::hypot(away.x, away.y) / widest);
  }
  return crown;
}

Color TintOf(const Color& leaf, const CrownVolume& crown, const Vector3& position, const LeafLight& light)
{
  const double depth = std::clamp(Depth(crown, position), 0.0, 1.0);
  const double height = std::clamp((position.z - crown.Foot.z) / crown.Height, 0.0, 1.0);
  const double strength = std::clamp(
    (0.62 + 0.28 * height) * (1.0 - 0.4 * depth) * (1.0 + 0.08 * light.OfLeaf[0] + 0.06 * light.OfTwig[0]), 0.3, 1.6);
  const double warm = std::clamp(0.05 * light.OfLeaf[1] + 0.05 * light.OfTwig[1], -0.2, 0.2);
  const double gains[3] = { strength * (1.0 + warm), strength, strength * (1.0 - warm) };
  Color tint{};
  for (int i = 0; i < 3; ++i)
  {
    tint[i] = static_cast<unsigned char>(std::clamp(gains[i] * leaf[i], 1.0, 255.0));
  }
  return tint;
}

void FinishLeaf(
  LeafParticle& leaf, const Plant& plant, const RandomStream& random, std::uint64_t index, std::uint64_t twig)
{
  const std::vector<SkeletonNode>& nodes = plant.Wood.Nodes;
  const Vector3 along = Normalised(nodes[leaf.Node + 1].Position - nodes[leaf.Node].Position);
  const Vector3 outward = Outward(plant.Crown, leaf.Position);
  const auto first = random.NormalPair(index, 5);
  const auto second = random.NormalPair(index, 6);
  const auto third = random.NormalPair(index, 7);
  leaf.Axis = Normalised(along + 0.5 * outward + 0.5 * Vector3(first[0], first[1], second[0]));
  const Vector3 towards = outward + 0.5 * Vector3(second[1], third[0], third[1]);
  const Vector3 flat = towards - glm::dot(towards, leaf.Axis) * leaf.Axis;
  leaf.Facing = glm::length(flat) > 1e-6 ? glm::normalize(flat) : Perpendicular(leaf.Axis);
  leaf.Normal = LitNormal(plant.Crown, leaf.Position, leaf.Facing);

  const auto own = random.NormalPair(index, 3);
  const auto ofTwig = random.NormalPair(twig, 4);
  leaf.Tint = TintOf(plant.Leaf, plant.Crown, leaf.Position, { { own[0], own[1] }, { ofTwig[0], ofTwig[1] } });
}

}
