// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/RigidSkinning.h"

#include "Numerics/SimdDouble4.h"

#include <algorithm>
#include <cstring>

namespace littoral
{

namespace
{

/// Four vertices as they follow each other in memory: x0 y0 z0 x1, y1 z1 x2 y2, z2 x3 y3 z3.
struct FourVectors
{
  SimdFloat4 Parts[3];

  LITTORAL_INLINE static FourVectors At(const float* from)
  {
    return { { LoadFloats(from), LoadFloats(from + 4), LoadFloats(from + 8) } };
  }
  /// The same vector four times.
  LITTORAL_INLINE static FourVectors All(float x, float y, float z)
  {
    return { { SimdFloat4{ x, y, z, x }, SimdFloat4{ y, z, x, y }, SimdFloat4{ z, x, y, z } } };
  }
  LITTORAL_INLINE void Store(float* to) const { std::memcpy(to, this->Parts, sizeof this->Parts); }

  /// Each component of a vector in the places of all three.
  LITTORAL_INLINE FourVectors Xs() const
  {
    const auto& p = this->Parts;
    return { { __builtin_shufflevector(p[0], p[0], 0, 0, 0, 3), __builtin_shufflevector(p[0], p[1], 3, 3, 6, 6),
      __builtin_shufflevector(p[1], p[2], 2, 5, 5, 5) } };
  }
  LITTORAL_INLINE FourVectors Ys() const
  {
    const auto& p = this->Parts;
    return { { __builtin_shufflevector(p[0], p[1], 1, 1, 1, 4), __builtin_shufflevector(p[1], p[1], 0, 0, 3, 3),
      __builtin_shufflevector(p[1], p[2], 3, 6, 6, 6) } };
  }
  LITTORAL_INLINE FourVectors Zs() const
  {
    const auto& p = this->Parts;
    return { { __builtin_shufflevector(p[0], p[1], 2, 2, 2, 5), __builtin_shufflevector(p[1], p[2], 1, 1, 4, 4),
      __builtin_shufflevector(p[2], p[2], 0, 3, 3, 3) } };
  }

  friend LITTORAL_INLINE FourVectors operator+(const FourVectors& a, const FourVectors& b)
  {
    return { { a.Parts[0] + b.Parts[0], a.Parts[1] + b.Parts[1], a.Parts[2] + b.Parts[2] } };
  }
  friend LITTORAL_INLINE FourVectors operator-(const FourVectors& a, const FourVectors& b)
  {
    return { { a.Parts[0] - b.Parts[0], a.Parts[1] - b.Parts[1], a.Parts[2] - b.Parts[2] } };
  }
  friend LITTORAL_INLINE FourVectors operator*(const FourVectors& a, const FourVectors& b)
  {
    return { { a.Parts[0] * b.Parts[0], a.Parts[1] * b.Parts[1], a.Parts[2] * b.Parts[2] } };
  }
};

/// The change of one joint, for four vertices at a time.
struct OneChange
{
  FourVectors Columns[3]; ///< of R - 1
  FourVectors Place;      ///< r
  FourVectors Shift;      ///< s

  LITTORAL_INLINE static FourVectors Column(const JointChange& change, int index)
  {
    const auto& column = change.Columns[index];
    return FourVectors::All(column[0], column[1], column[2]);
  }
  LITTORAL_INLINE explicit OneChange(const JointChange& change)
    : Columns{ Column(change, 0), Column(change, 1), Column(change, 2) }
    , Place(FourVectors::All(change.Columns[0][3], change.Columns[1][3], change.Columns[2][3]))
    , Shift(Column(change, 3))
  {
  }
  /// (R - 1) v
  LITTORAL_INLINE FourVectors Turned(const FourVectors& v) const
  {
    return this->Columns[0] * v.Xs() + this->Columns[1] * v.Ys() + this->Columns[2] * v.Zs();
  }
  // p + ((R - 1) (p - r) + s), n + (R - 1) n
  LITTORAL_INLINE FourVectors PointsOf(const FourVectors& p) const
  {
    return p + (this->Turned(p - this->Place) + this->Shift);
  }
  LITTORAL_INLINE FourVectors NormalsOf(const FourVectors& n) const { return n + this->Turned(n); }
};

/// Calls a move with four vectors at a time; the last ones are copied to a full four.
template <typename Move>
LITTORAL_INLINE void MoveVectors(const float* from, std::size_t count, float* to, const Move& move)
{
  std::size_t next = 0;
  for (; next + 4 <= count; next += 4)
  {
    move(FourVectors::At(from + 3 * next)).Store(to + 3 * next);
  }
  if (next < count)
  {
    float rest[12] = {};
    std::copy_n(from + 3 * next, 3 * (count - next), rest);
    move(FourVectors::At(rest)).Store(rest);
    std::copy_n(rest, 3 * (count - next), to + 3 * next);
  }
}

struct PointMove
{
  const OneChange& Change;
  LITTORAL_INLINE FourVectors operator()(const FourVectors& p) const { return this->Change.PointsOf(p); }
};

struct NormalMove
{
  const OneChange& Change;
  LITTORAL_INLINE FourVectors operator()(const FourVectors& n) const { return this->Change.NormalsOf(n); }
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
LITTORAL_SIMD_CLONES void MoveRigidly(const RestSkin& rest, const RigidBinding& binding, const JointChange* joints,
  std::size_t begin, std::size_t end, float* points, float* normals)
{
  const RigidBinding::Run* run = binding.RunOf(begin);
  while (begin < end)
  {
    const OneChange change(joints[run->Joint]);
    const std::size_t count = std::min(end, run->End) - begin;
    MoveVectors(rest.Points + 3 * begin, count, points + 3 * begin, PointMove{ change });
    if (rest.Normals)
    {
      MoveVectors(rest.Normals + 3 * begin, count, normals + 3 * begin, NormalMove{ change });
    }
    begin += count;
    ++run;
  }
}

}
