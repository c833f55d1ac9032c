// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/Skinning.h"

#include "Numerics/SimdDouble4.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace littoral
{

namespace
{

/// Four floats; `isLast`: behind the first three there may be no memory.
template <bool IsLast>
LITTORAL_INLINE SimdFloat4 Load(const float* from)
{
  SimdFloat4 four{};
  std::memcpy(&four, from, (IsLast ? 3 : 4) * sizeof(float));
  return four;
}

/// Stores three floats; unless it is the last, a fourth one that the next vertex replaces.
template <bool IsLast>
LITTORAL_INLINE void Store(const SimdFloat4& from, float* to)
{
  std::memcpy(to, &from, (IsLast ? 3 : 4) * sizeof(float));
}

LITTORAL_INLINE SimdFloat4 Column(const JointChange& change, int index)
{
  return Load<false>(change.Columns[index].data());
}

/// One number in all lanes.
template <int Lane>
LITTORAL_INLINE SimdFloat4 All(const SimdFloat4& a)
{
  return __builtin_shufflevector(a, a, Lane, Lane, Lane, Lane);
}

/// Matrix times vector.
LITTORAL_INLINE SimdFloat4 Turned(const SimdFloat4* columns, const SimdFloat4& vector)
{
  return columns[0] * All<0>(vector) + columns[1] * All<1>(vector) + columns[2] * All<2>(vector);
}

/// The joints that a vertex follows, about the place of the first one.
struct FollowedJoints
{
  const JointChange* Changes[4]{};
  SimdFloat4 Center{};
  SimdFloat4 Shifts[4]{};

  LITTORAL_INLINE static SimdFloat4 PlaceOf(const JointChange& change)
  {
    const auto& c = change.Columns;
    return SimdFloat4{ c[0][3], c[1][3], c[2][3], 0.0f };
  }

  LITTORAL_INLINE void Take(const SkinBinding::Run& run, const JointChange* joints)
  {
    this->Center = PlaceOf(joints[run.Joints[0]]);
    for (int i = 0; i < run.Count; ++i)
    {
      // s_i + (R_i - 1) (c - r_i)
      const JointChange& change = joints[run.Joints[i]];
      const SimdFloat4 columns[3] = { Column(change, 0), Column(change, 1), Column(change, 2) };
      this->Changes[i] = &change;
      this->Shifts[i] = Column(change, 3) + Turned(columns, this->Center - PlaceOf(change));
    }
  }
};

/// Asks for the memory of a value that is read soon.
template <typename Value>
LITTORAL_INLINE void Prefetch(const Value* value)
{
#if defined(__GNUC__)
  __builtin_prefetch(value);
#endif
}

/// Weights that move towards the largest one alone.
LITTORAL_INLINE void Stiffen(float rigidity, int count, float* weights)
{
  const auto largest = std::max_element(weights, weights + count) - weights;
  for (int i = 0; i < count; ++i)
  {
    weights[i] += rigidity * ((i == largest ? 1.0f : 0.0f) - weights[i]);
  }
}

/// The mean change of the joints of one vertex after the other, about the place of the first joint of each.
class Blend
{
public:
  SimdFloat4 Columns[3]{}; // of R - 1
  SimdFloat4 Shift{};
  SimdFloat4 Center{};

  LITTORAL_INLINE Blend(const SkinBinding& binding, const JointChange* changes, float rigidity, std::size_t begin,
    const SkinBinding::Run* run)
    : Binding(binding)
    , Changes(changes)
    , Rigidity(rigidity)
    , Next(run ? run : binding.RunOf(begin))
    , End(binding.EndOfRuns())
    , Until(begin)
  {
  }

  LITTORAL_INLINE void Enter(std::size_t vertex)
  {
    if (vertex == this->Until)
    {
      this->Run = this->Next++;
      this->FetchAhead();
      this->Until = this->Run->End;
      this->Joints.Take(*this->Run, this->Changes);
      this->Center = this->Joints.Center;
    }
    else if (!this->Run->Varies)
    {
      return;
    }
    float weights[4];
    std::copy_n(this->Binding.WeightsOf(*this->Run, vertex), this->Run->Count, weights);
    if (this->Rigidity > 0.0f)
    {
      Stiffen(this->Rigidity, this->Run->Count, weights);
    }
    // Linear blend skinning about c: [R - 1 | t] = sum over joints of w_i [R_i - 1 | s_i + (R_i - 1) (c - r_i)].
    SimdFloat4 sums[4]{};
    for (int i = 0; i < this->Run->Count; ++i)
    {
      const SimdFloat4 weight = weights[i] - SimdFloat4{};
      const JointChange& change = *this->Joints.Changes[i];
      sums[0] += weight * Column(change, 0);
      sums[1] += weight * Column(change, 1);
      sums[2] += weight * Column(change, 2);
      sums[3] += weight * this->Joints.Shifts[i];
    }
    std::copy(sums, sums + 3, this->Columns);
    this->Shift = sums[3];
  }

private:
  static constexpr std::ptrdiff_t RunsAhead = 8;

  /// Has the changes of a later run brought near: all of a stand are more than the cache of a core holds.
  LITTORAL_INLINE void FetchAhead() const
  {
    if (this->End - this->Run > RunsAhead)
    {
      const SkinBinding::Run& run = this->Run[RunsAhead];
      Prefetch(this->Changes + run.Joints[0]);
      Prefetch(this->Changes + run.Joints[run.Count - 1]);
    }
  }

  const SkinBinding& Binding;
  const JointChange* Changes;
  float Rigidity;
  const SkinBinding::Run* Run = nullptr;
  const SkinBinding::Run* Next;
  const SkinBinding::Run* End;
  std::size_t Until; ///< the first vertex of the next run
  FollowedJoints Joints;
};

/// Moves a vertex; its normal gets its length later.
template <bool IsLast>
LITTORAL_INLINE void MoveVertex(
  const RestSkin& rest, const Blend& blend, std::size_t vertex, float* points, float* normals)
{
  // p + ((R - 1) (p - c) + t), n + (R - 1) n
  const SimdFloat4 place = Load<IsLast>(rest.Points + 3 * (vertex - rest.First));
  Store<IsLast>(place + (Turned(blend.Columns, place - blend.Center) + blend.Shift), points + 3 * vertex);
  if (rest.Normals)
  {
    const SimdFloat4 normal = Load<IsLast>(rest.Normals + 3 * (vertex - rest.First));
    Store<IsLast>(normal + Turned(blend.Columns, normal), normals + 3 * vertex);
  }
}

/// Gives normals the lengths that they had.
LITTORAL_INLINE void KeepLengths(const float* before, std::size_t count, float* normals)
{
  constexpr std::size_t Most = 64; // a fixed number at a time, in which the compiler takes several side by side
  constexpr float least = 1e-37f;
  float factors[Most];
  for (std::size_t begin = 0; begin < count; begin += Most)
  {
    const std::size_t some = std::min(Most, count - begin);
    const float* b = before + 3 * begin;
    float* n = normals + 3 * begin;
    for (std::size_t i = 0; i < some; ++i)
    {
      const float was = b[3 * i] * b[3 * i] + b[3 * i + 1] * b[3 * i + 1] + b[3 * i + 2] * b[3 * i + 2];
      const float is = n[3 * i] * n[3 * i] + n[3 * i + 1] * n[3 * i + 1] + n[3 * i + 2] * n[3 * i + 2];
      factors[i] = std::sqrt(was / (is + least));
    }
    for (std::size_t i = 0; i < some; ++i)
    {
      n[3 * i] *= factors[i];
      n[3 * i + 1] *= factors[i];
      n[3 * i + 2] *= factors[i];
    }
  }
}

/// A place in single precision. Apart from those that widen it again: GCC 12 would drop both conversions together.
[[gnu::noinline]] std::array<float, 3> Rounded(const Vector3& place)
{
  return { static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(place.z) };
}

}

//----------------------------------------------------------------------------
JointChange ChangeOf(const JointPose& pose, const Vector3& rest)
{
  const glm::dquat& q = pose.Rotation;
  const std::array<float, 3> center = Rounded(rest);
  // The rounded place r' of the joint moves by s + (R - 1) (r' - r).
  const Vector3 shift = pose.Shift + RotationOffset(q, Vector3(center[0], center[1], center[2]) - rest);
  const auto column = [](double x, double y, double z, float last) {
    return std::array<float, 4>{ static_cast<float>(x), static_cast<float>(y), static_cast<float>(z), last };
  };
  JointChange change;
  change.Columns[0] =
    column(-2.0 * (q.y * q.y + q.z * q.z), 2.0 * (q.x * q.y + q.w * q.z), 2.0 * (q.x * q.z - q.w * q.y), center[0]);
  change.Columns[1] =
    column(2.0 * (q.x * q.y - q.w * q.z), -2.0 * (q.x * q.x + q.z * q.z), 2.0 * (q.y * q.z + q.w * q.x), center[1]);
  change.Columns[2] =
    column(2.0 * (q.x * q.z + q.w * q.y), 2.0 * (q.y * q.z - q.w * q.x), -2.0 * (q.x * q.x + q.y * q.y), center[2]);
  change.Columns[3] = column(shift.x, shift.y, shift.z, 0.0f);
  return change;
}

Vector3 JointChange::Of(const Vector3& place) const
{
  const auto& c = this->Columns;
  const Vector3 p = place - Vector3(c[0][3], c[1][3], c[2][3]);
  const auto row = [&](int i) { return c[0][i] * p.x + c[1][i] * p.y + c[2][i] * p.z + c[3][i]; };
  return { row(0), row(1), row(2) };
}

//----------------------------------------------------------------------------
LITTORAL_SIMD_CLONES void MoveSkin(const RestSkin& rest, const SkinBinding& binding, const JointChange* joints,
  std::size_t begin, std::size_t end, float* points, float* normals, float rigidity, const SkinBinding::Run* run)
{
  constexpr std::size_t Block = 256; // vertices whose normals are still near when they get their lengths
  Blend blend(binding, joints, rigidity, begin, run);
  for (std::size_t block = begin; block < end; block += Block)
  {
    const std::size_t last = std::min(end, block + Block) - 1;
    for (std::size_t vertex = block; vertex < last; ++vertex)
    {
      blend.Enter(vertex);
      MoveVertex<false>(rest, blend, vertex, points, normals);
    }
    blend.Enter(last);
    MoveVertex<true>(rest, blend, last, points, normals);
    if (rest.Normals)
    {
      KeepLengths(rest.Normals + 3 * (block - rest.First), last + 1 - block, normals + 3 * block);
    }
  }
}

}
