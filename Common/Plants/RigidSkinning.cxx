// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/RigidSkinning.h"

#include "Numerics/VectorRangeLanes.h"

#include <algorithm>
#include <cstring>

namespace littoral
{

namespace
{

/// The change of one joint, for eight vertices at a time.
struct OneChange
{
  EightVectors Columns[3]; ///< of R - 1
  EightVectors Place;      ///< r
  EightVectors Shift;      ///< s

  LITTORAL_INLINE static EightVectors All(float x, float y, float z)
  {
    return { AllFloats(x), AllFloats(y), AllFloats(z) };
  }
  LITTORAL_INLINE static EightVectors Column(const JointChange& change, int index)
  {
    const auto& column = change.Columns[index];
    return All(column[0], column[1], column[2]);
  }
  LITTORAL_INLINE explicit OneChange(const JointChange& change)
    : Columns{ Column(change, 0), Column(change, 1), Column(change, 2) }
    , Place(All(change.Columns[0][3], change.Columns[1][3], change.Columns[2][3]))
    , Shift(Column(change, 3))
  {
  }
  /// (R - 1) v
  LITTORAL_INLINE EightVectors Turned(const EightVectors& v) const
  {
    return this->Columns[0] * v.X + this->Columns[1] * v.Y + this->Columns[2] * v.Z;
  }
  // p + ((R - 1) (p - r) + s), n + (R - 1) n
  LITTORAL_INLINE EightVectors PointsOf(const EightVectors& p) const
  {
    return p + (this->Turned(p - this->Place) + this->Shift);
  }
  LITTORAL_INLINE EightVectors NormalsOf(const EightVectors& n) const { return n + this->Turned(n); }
};

/// Calls a move with eight vectors at a time, and adds what it makes to the ranges.
template <typename Move>
LITTORAL_INLINE void MoveVectors(
  const float* from, std::size_t count, float* to, VectorRangeLanes& ranges, const Move& move)
{
  constexpr std::size_t eight = EightVectors::Count;
  if (count < eight)
  {
    float few[3 * eight];
    FillEight(from, count, few);
    const EightVectors moved = move(EightVectors::At(few));
    ranges.Add(moved);
    moved.Store(few);
    std::memcpy(to, few, 3 * count * sizeof(float));
    return;
  }
  // The last eight go back to vectors before, which are moved twice.
  for (std::size_t next = 0; next < count; next += eight)
  {
    const std::size_t first = std::min(next, count - eight);
    const EightVectors moved = move(EightVectors::At(from + 3 * first));
    ranges.Add(moved);
    moved.Store(to + 3 * first);
  }
}

struct PointMove
{
  const OneChange& Change;
  LITTORAL_INLINE EightVectors operator()(const EightVectors& p) const { return this->Change.PointsOf(p); }
};

struct NormalMove
{
  const OneChange& Change;
  LITTORAL_INLINE EightVectors operator()(const EightVectors& n) const { return this->Change.NormalsOf(n); }
};

int MainJointOf(const SkinBinding& binding, const SkinBinding::Run& run, std::size_t vertex)
{
  const float* weights = binding.WeightsOf(run, vertex);
  return run.Joints[std::max_element(weights, weights + run.Count) - weights];
}

}

//----------------------------------------------------------------------------
RigidBinding::RigidBinding(const SkinBinding& binding, const std::vector<int>& carriers)
{
  for (const SkinBinding::Run* run = binding.RunOf(0); run != binding.EndOfRuns(); ++run)
  {
    for (std::size_t vertex = run->Begin; vertex < run->End; ++vertex)
    {
      const int main = MainJointOf(binding, *run, vertex);
      const int joint = carriers.empty() ? main : carriers[static_cast<std::size_t>(main)];
      if (this->Runs.empty() || this->Runs.back().Joint != joint)
      {
        this->Runs.push_back({ vertex, joint });
      }
      this->Runs.back().End = vertex + 1;
    }
  }
  this->Runs.shrink_to_fit();
}

const RigidBinding::Run* RigidBinding::RunOf(std::size_t vertex) const
{
  const auto run = std::upper_bound(
    this->Runs.begin(), this->Runs.end(), vertex, [](std::size_t own, const Run& one) { return own < one.End; });
  return this->Runs.data() + (run - this->Runs.begin());
}

//----------------------------------------------------------------------------
LITTORAL_SIMD_CLONES void MoveRigidly(const RestSkin& rest, const RigidBinding::Run* run, const JointChange* joints,
  std::size_t begin, std::size_t end, float* points, float* normals, SkinRanges& ranges)
{
  VectorRangeLanes pointRanges(ranges.Points);
  VectorRangeLanes normalRanges(ranges.Normals);
  while (begin < end)
  {
    const OneChange change(joints[run->Joint]);
    const std::size_t count = std::min(end, run->End) - begin;
    MoveVectors(rest.Points + 3 * begin, count, points + 3 * begin, pointRanges, PointMove{ change });
    if (rest.Normals)
    {
      MoveVectors(rest.Normals + 3 * begin, count, normals + 3 * begin, normalRanges, NormalMove{ change });
    }
    begin += count;
    ++run;
  }
  pointRanges.Store(ranges.Points);
  normalRanges.Store(ranges.Normals);
}

}
