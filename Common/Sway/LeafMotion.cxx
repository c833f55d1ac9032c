// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sway/LeafMotion.h"

#include "Numerics/SimdRotation.h"
#include "Numerics/SmoothStep.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// The draw that sets a leaf's own place in the sequence of its angles; cells of times after 0 lie far from it.
constexpr std::uint64_t PhaseDraw = ~std::uint64_t(0);
/// Cells are numbered up to this, where doubles end to tell them apart; the last one holds beyond.
constexpr double MostCells = 0x1p53;

template <typename Real>
using VectorOf = glm::vec<3, Real>;

/// The direction of a vector; up for the zero vector.
template <typename Real>
LITTORAL_INLINE VectorOf<Real> DirectionOf(const VectorOf<Real>& a)
{
  const Real none(0.0);
  const Real length = Length(a);
  const Real factor = Real(1.0) / SelectLess(none, length, length, Real(1.0));
  return { factor * a.x, factor * a.y, SelectLess(none, length, factor * a.z, Real(1.0)) };
}

/// Cosine and sine of an angle from 0 to pi [rad].
template <typename Real>
struct CosineAndSine
{
  Real Cosine;
  Real Sine;

  LITTORAL_INLINE explicit CosineAndSine(const Real& angle)
  {
    const Real quarter = Real(0.25) * angle;
    const Real square = quarter * quarter;
    this->Cosine = CosineOfSmall(square);
    this->Sine = quarter * SineRatioOfSmall(square);
    for (int doubling = 0; doubling < 2; ++doubling)
    {
      // sin 2a = 2 sin a cos a, cos 2a = 1 - 2 sin2 a
      const Real twice = Real(2.0) * this->Sine;
      const Real sine = twice * this->Cosine;
      this->Cosine = Real(1.0) - twice * this->Sine;
      this->Sine = sine;
    }
  }
};

/// A part of the way from one unit vector to another, along the great circle; the side tells which, from opposite ones.
template <typename Real>
LITTORAL_INLINE VectorOf<Real> Towards(
  const VectorOf<Real>& from, const VectorOf<Real>& to, const Real& part, const VectorOf<Real>& side)
{
  const Real cosine = glm::dot(from, to);
  const VectorOf<Real> flat = to - cosine * from;
  const Real sine = Length(flat);
  const CosineAndSine<Real> way(part * AngleOf(sine, cosine));
  const Real least(1e-9);
  const Real factor = way.Sine / Max(sine, least);
  const VectorOf<Real> across(SelectLess(least, sine, factor * flat.x, way.Sine * side.x),
    SelectLess(least, sine, factor * flat.y, way.Sine * side.y),
    SelectLess(least, sine, factor * flat.z, way.Sine * side.z));
  return way.Cosine * from + across;
}

/// LeafRotation, with the angles of the flutter [rad].
template <typename Real>
LITTORAL_INLINE glm::qua<Real> RotationOf(const VectorOf<Real>& main, const VectorOf<Real>& facing,
  const VectorOf<Real>& wind, const Real& alignment, const Real& forth, const Real& aside)
{
  const VectorOf<Real> aligned = Towards(main, wind, alignment, facing);
  // The leaf's own axes, and not those of spherical coordinates, which have poles.
  const glm::qua<Real> turn = RotationBetween(main, aligned);
  const VectorOf<Real> front = Rotated(turn, facing);
  const VectorOf<Real> across = Rotated(turn, glm::cross(main, facing));
  // m + tan a f + tan b s, times both cosines
  const Real cosines[2] = { CosineOfSmall(forth * forth), CosineOfSmall(aside * aside) };
  const Real sines[2] = { forth * SineRatioOfSmall(forth * forth), aside * SineRatioOfSmall(aside * aside) };
  const VectorOf<Real> swung =
    (cosines[0] * cosines[1]) * aligned + (sines[0] * cosines[1]) * front + (cosines[0] * sines[1]) * across;
  return RotationBetween(aligned, swung) * turn;
}

/// The part of the way from the angle before to that after: a step with continuous acceleration.
template <typename Real>
LITTORAL_INLINE Real Step(const Real& f)
{
  return f * f * f * (Real(10.0) + f * (Real(6.0) * f - Real(15.0)));
}

using Four = SimdDouble4;
using FourVectors = VectorOf<SimdDouble4>;

/// Four leaves, which may be the same, a lane each.
struct FourLeaves
{
  std::array<FlutteringLeaf*, LaneCount> Leaves;

  /// Numbers of the leaves.
  template <typename Number>
  LITTORAL_INLINE Four Each(const Number& number) const
  {
    const SimdFloat4 four{ number(*this->Leaves[0]), number(*this->Leaves[1]), number(*this->Leaves[2]),
      number(*this->Leaves[3]) };
    return Four(__builtin_convertvector(four, Four::Register));
  }

  /// Parts of the vectors at a corner.
  LITTORAL_INLINE Four PartAt(int corner, int axis, const float* vectors) const
  {
    return this->Each([&](const FlutteringLeaf& leaf) { return vectors[3 * leaf.Corners[corner] + axis]; });
  }

  /// Vectors at a corner.
  LITTORAL_INLINE FourVectors At(int corner, const float* vectors) const
  {
    return { this->PartAt(corner, 0, vectors), this->PartAt(corner, 1, vectors), this->PartAt(corner, 2, vectors) };
  }

  /// Adds to vectors at a corner, of the first leaves.
  LITTORAL_INLINE void Add(const FourVectors& change, int corner, std::size_t count, float* vectors) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const SimdFloat4 four = __builtin_convertvector(change[axis].Values, SimdFloat4);
      for (std::size_t lane = 0; lane < count; ++lane)
      {
        vectors[3 * this->Leaves[lane]->Corners[corner] + axis] += four[lane];
      }
    }
  }

  /// Angle before, angle after: an angle of the flutter [rad].
  LITTORAL_INLINE Four Angle(int index, const Four& part, const Four& range) const
  {
    const Four before = this->Each([&](const FlutteringLeaf& leaf) { return leaf.Before[index]; });
    const Four after = this->Each([&](const FlutteringLeaf& leaf) { return leaf.After[index]; });
    return range * (before + part * (after - before) - Four(0.5));
  }

  /// The rotations of the leaves, whose angles are drawn.
  LITTORAL_INLINE glm::qua<Four> Rotations(
    double passed, const LeafWind* winds, const FourVectors& main, const FourVectors& facing) const
  {
    const LaneIndices plants{ static_cast<std::size_t>(this->Leaves[0]->Plant),
      static_cast<std::size_t>(this->Leaves[1]->Plant), static_cast<std::size_t>(this->Leaves[2]->Plant),
      static_cast<std::size_t>(this->Leaves[3]->Plant) };
    const Four one(1.0);
    const Four place = Four(passed) + this->Each([](const FlutteringLeaf& leaf) { return leaf.Phase; });
    const Four part = Step(SelectLess(place, one, place, place - one));
    const Four range = GatherNumber(winds, plants, &LeafWind::Range);
    return RotationOf(main, facing, GatherVector(winds, plants, &LeafWind::Direction),
      GatherNumber(winds, plants, &LeafWind::Alignment), this->Angle(0, part, range), this->Angle(1, part, range));
  }
};

}

double RiseBetween(double speed, const std::array<double, 2>& speeds)
{
  return SmoothStep(speeds[0], speeds[1], speed);
}

//----------------------------------------------------------------------------
LeafFlutter::LeafFlutter(const LeafMotionOptions& options)
  : Random(options.Seed, RandomPurpose::LeafFlutter)
  , Rate(options.FlutterRate)
  , Cells(0)
  , Period(options.Period)
{
  if (options.Period > 0.0)
  {
    const double cells = std::max(1.0, std::round(options.Period * options.FlutterRate));
    if (cells <= MostCells)
    {
      this->Cells = static_cast<std::int64_t>(cells);
      this->Rate = cells / options.Period;
    }
  }
}

LeafFlutter::Moment LeafFlutter::MomentOf(double time) const
{
  const double reduced = this->Cells > 0 ? time - this->Period * std::floor(time / this->Period) : time;
  const double place = this->Rate * reduced;
  const double below = std::clamp(std::floor(place), -MostCells, MostCells);
  return { this->Wrapped(static_cast<std::int64_t>(below)), std::clamp(place - below, 0.0, 1.0) };
}

FlutteringLeaf LeafFlutter::Leaf(const std::array<int, 4>& corners, int plant, std::uint64_t identity) const
{
  FlutteringLeaf leaf;
  leaf.Corners = corners;
  leaf.Plant = plant;
  leaf.Identity = identity;
  leaf.Phase = static_cast<float>(this->Random.UniformPair(identity, PhaseDraw)[0]);
  return leaf;
}

std::array<float, 2> LeafFlutter::Angles(std::uint64_t identity, std::int64_t cell) const
{
  const auto angles = this->Random.UniformPair(identity, static_cast<std::uint64_t>(cell));
  return { static_cast<float>(angles[0]), static_cast<float>(angles[1]) };
}

void LeafFlutter::Draw(std::int64_t cell, FlutteringLeaf& leaf) const
{
  const bool isNext = leaf.Cell != FlutteringLeaf::NoCell && this->Wrapped(leaf.Cell + 1) == cell;
  leaf.Before = isNext ? leaf.After : this->Angles(leaf.Identity, cell);
  leaf.After = this->Angles(leaf.Identity, this->Wrapped(cell + 1));
  leaf.Cell = cell;
}

std::array<double, 2> LeafFlutter::At(std::uint64_t leaf, double time) const
{
  FlutteringLeaf own = this->Leaf({}, 0, leaf);
  const Moment moment = this->MomentOf(time);
  this->Follow(moment, own);
  const double place = moment.Part + own.Phase;
  const double part = Step(place < 1.0 ? place : place - 1.0);
  const auto angle = [&](int i) { return own.Before[i] + part * (double(own.After[i]) - own.Before[i]) - 0.5; };
  return { angle(0), angle(1) };
}

//----------------------------------------------------------------------------
LeafWind LeafWindOf(const Vector3& wind, const LeafMotionOptions& options)
{
  const double speed = glm::length(wind);
  return { Normalised(wind), options.MaximumAlignment * RiseBetween(speed, options.AligningSpeeds),
    options.FlutterAngle * RiseBetween(speed, options.FlutteringSpeeds) };
}

glm::dquat LeafRotation(const LeafAxes& leaf, const LeafWind& wind, const std::array<double, 2>& flutter)
{
  return RotationOf(
    leaf.Main, leaf.Facing, wind.Direction, wind.Alignment, wind.Range * flutter[0], wind.Range * flutter[1]);
}

LITTORAL_SIMD_CLONES void TurnLeaves(const LeafFlutter& flutter, const LeafFlutter::Moment& moment,
  const LeafWind* winds, std::size_t begin, std::size_t end, FlutteringLeaf* leaves, float* points, float* normals)
{
  for (std::size_t first = begin; first < end; first += LaneCount)
  {
    const std::size_t count = std::min<std::size_t>(LaneCount, end - first);
    FourLeaves four;
    for (std::size_t lane = 0; lane < LaneCount; ++lane)
    {
      four.Leaves[lane] = leaves + first + std::min(lane, count - 1);
      flutter.Follow(moment, *four.Leaves[lane]);
    }
    const FourVectors foot = four.At(0, points);
    const FourVectors arms[3] = { four.At(1, points) - foot, four.At(2, points) - foot, four.At(3, points) - foot };
    const glm::qua<Four> turn =
      four.Rotations(moment.Part, winds, DirectionOf(arms[1]), DirectionOf(glm::cross(arms[1], arms[2] - arms[0])));
    for (int corner = 1; corner < 4; ++corner)
    {
      four.Add(RotationOffset(turn, arms[corner - 1]), corner, count, points);
    }
    for (int corner = 0; corner < 4 && normals; ++corner)
    {
      four.Add(RotationOffset(turn, four.At(corner, normals)), corner, count, normals);
    }
  }
}

}
