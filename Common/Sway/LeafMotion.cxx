// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sway/LeafMotion.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// The draw that sets a leaf's own place in the sequence of its angles; cells lie far from it.
constexpr std::uint64_t PhaseDraw = ~std::uint64_t(0);

/// A part of the way from one unit vector to another, along the great circle; the side tells which, from opposite ones.
Vector3 Towards(const Vector3& from, const Vector3& to, double part, const Vector3& side)
{
  const Vector3 flat = to - glm::dot(from, to) * from;
  const double sine = glm::length(flat);
  const double angle = part * std::atan2(sine, glm::dot(from, to));
  return std::cos(angle) * from + std::sin(angle) * (sine > 1e-9 ? flat / sine : side);
}

}

double RiseBetween(double speed, const std::array<double, 2>& speeds)
{
  const double part = std::clamp((speed - speeds[0]) / (speeds[1] - speeds[0]), 0.0, 1.0);
  return part * part * (3.0 - 2.0 * part);
}

LeafFlutter::LeafFlutter(const LeafMotionOptions& options)
  : Random(options.Seed, RandomPurpose::LeafFlutter)
  , Rate(options.FlutterRate)
  , Cells(0.0)
  , Period(options.Period)
{
  if (options.Period > 0.0)
  {
    this->Cells = std::max(1.0, std::round(options.Period * options.FlutterRate));
    this->Rate = this->Cells / options.Period;
  }
}

std::array<double, 2> LeafFlutter::At(std::uint64_t leaf, double time) const
{
  const double reduced = this->Cells > 0.0 ? time - this->Period * std::floor(time / this->Period) : time;
  const double place = this->Rate * reduced + this->Random.UniformPair(leaf, PhaseDraw)[0];
  const double below = std::floor(place);
  const auto anglesOf = [&](double cell) {
    const double wrapped = this->Cells > 0.0 ? cell - this->Cells * std::floor(cell / this->Cells) : cell;
    return this->Random.UniformPair(leaf, static_cast<std::uint64_t>(static_cast<std::int64_t>(wrapped)));
  };
  const auto before = anglesOf(below);
  const auto after = anglesOf(below + 1.0);
  const double f = place - below;
  const double part = f * f * f * (10.0 + f * (6.0 * f - 15.0));
  return { before[0] + part * (after[0] - before[0]) - 0.5, before[1] + part * (after[1] - before[1]) - 0.5 };
}

glm::dquat LeafRotation(
  const LeafAxes& leaf, const Vector3& wind, const std::array<double, 2>& flutter, const LeafMotionOptions& options)
{
  const double speed = glm::length(wind);
  const double aligned = options.LargestAlignment * RiseBetween(speed, options.AligningSpeeds);
  const double range = options.FlutterAngle * RiseBetween(speed, options.FlutteringSpeeds);
  if (aligned <= 0.0 && range <= 0.0)
  {
    return { 1.0, 0.0, 0.0, 0.0 };
  }
  const Vector3 side = glm::cross(leaf.Main, leaf.Facing);
  const Vector3 main = Towards(leaf.Main, wind / speed, aligned, leaf.Facing);
  // The leaf's own axes, and not those of spherical coordinates, which have poles.
  const glm::dquat turn = RotationBetween(leaf.Main, main);
  const Vector3 facing = leaf.Facing + RotationOffset(turn, leaf.Facing);
  const Vector3 across = side + RotationOffset(turn, side);
  return RotationBetween(main, main + std::tan(range * flutter[0]) * facing + std::tan(range * flutter[1]) * across) *
    turn;
}

void TurnLeaf(const std::array<int, 4>& corners, const Vector3& wind, const std::array<double, 2>& flutter,
  const LeafMotionOptions& options, float* points, float* normals)
{
  Vector3 at[4];
  for (int i = 0; i < 4; ++i)
  {
    const float* p = points + 3 * corners[i];
    at[i] = { p[0], p[1], p[2] };
  }
  const LeafAxes axes{ Normalised(at[2] - at[0]), Normalised(glm::cross(at[2] - at[0], at[3] - at[1])) };
  const glm::dquat turn = LeafRotation(axes, wind, flutter, options);
  const auto add = [&](float* to, const Vector3& vector) {
    const Vector3 change = RotationOffset(turn, vector);
    for (int axis = 0; axis < 3; ++axis)
    {
      to[axis] += static_cast<float>(change[axis]);
    }
  };
  for (int i = 0; i < 4; ++i)
  {
    add(points + 3 * corners[i], at[i] - at[0]);
    float* normal = normals ? normals + 3 * corners[i] : nullptr;
    if (normal)
    {
      add(normal, { normal[0], normal[1], normal[2] });
    }
  }
}

}
