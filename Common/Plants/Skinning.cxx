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

/// Two vertices side by side, four floats each, of which the last means nothing.
typedef float SimdPair __attribute__((vector_size(2 * sizeof(SimdFloat4))));

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

LITTORAL_INLINE SimdPair Join(const SimdFloat4& first, const SimdFloat4& second)
{
  return __builtin_shufflevector(first, second, 0, 1, 2, 3, 4, 5, 6, 7);
}

/// The same for both.
LITTORAL_INLINE SimdPair Both(const std::array<float, 4>& numbers)
{
  const SimdFloat4 four = Load<false>(numbers.data());
  return Join(four, four);
}

/// One number of each in all of its lanes.
template <int Lane>
LITTORAL_INLINE SimdPair All(const SimdPair& a)
{
  return __builtin_shufflevector(a, a, Lane, Lane, Lane, Lane, 4 + Lane, 4 + Lane, 4 + Lane, 4 + Lane);
}

/// Matrix times vector.
LITTORAL_INLINE SimdPair Turned(const SimdPair* columns, const SimdPair& vector)
{
  return columns[0] * All<0>(vector) + columns[1] * All<1>(vector) + columns[2] * All<2>(vector);
}

template <typename Number>
LITTORAL_INLINE bool IsSame(const Number* a, const Number* b)
{
  return std::memcmp(a, b, 4 * sizeof(Number)) == 0; // NOLINT(bugprone-suspicious-memory-comparison): bit by bit
}

/// The joints that vertices follow, about the place of the first one.
struct FollowedJoints
{
  const JointChange* Changes[4]{};
  SimdPair Center{};
  SimdPair Shifts[4]{};
  std::size_t Count = 0;
  const int* Ids = nullptr;

  LITTORAL_INLINE static SimdPair PlaceOf(const JointChange& change)
  {
    const auto& c = change.Columns;
    const SimdFloat4 place{ c[0][3], c[1][3], c[2][3], 0.0f };
    return Join(place, place);
  }

  /// The first joints of a vertex, unless they are those of the vertex before.
  LITTORAL_INLINE void Take(const int* ids, std::size_t count, const JointChange* joints)
  {
    if (this->Count >= count && IsSame(ids, this->Ids))
    {
      return;
    }
    this->Ids = ids;
    this->Count = count;
    this->Center = PlaceOf(joints[ids[0]]);
    for (std::size_t i = 0; i < count; ++i)
    {
      // s_i + (R_i - 1) (c - r_i)
      const JointChange& change = joints[ids[i]];
      const SimdPair columns[3] = { Both(change.Columns[0]), Both(change.Columns[1]), Both(change.Columns[2]) };
      this->Changes[i] = &change;
      this->Shifts[i] = Both(change.Columns[3]) + Turned(columns, this->Center - PlaceOf(change));
    }
  }
};

/// Joints up to the last one with a weight.
LITTORAL_INLINE std::size_t JointsOf(const float* weights)
{
  std::size_t count = 4;
  while (count > 1 && weights[count - 1] == 0.0f)
  {
    --count;
  }
  return count;
}

/// The mean changes of the joints of two vertices, about the place of the first joint of each.
struct Blend
{
  SimdPair Columns[3]{}; // of R - 1
  SimdPair Shift{};
  SimdPair Center{};

  Blend() = default;
  LITTORAL_INLINE Blend(const FollowedJoints& joints, const float* first, const float* second)
    : Center(joints.Center)
  {
    // Linear blend skinning about c: [R - 1 | t] = sum over joints of w_i [R_i - 1 | s_i + (R_i - 1) (c - r_i)].
    // A joint without weight changes no byte of a sum that began with 0.
    for (std::size_t i = 0; i < joints.Count; ++i)
    {
      const SimdPair weight = Join(first[i] - SimdFloat4{}, second[i] - SimdFloat4{});
      this->Columns[0] += weight * Both(joints.Changes[i]->Columns[0]);
      this->Columns[1] += weight * Both(joints.Changes[i]->Columns[1]);
      this->Columns[2] += weight * Both(joints.Changes[i]->Columns[2]);
      this->Shift += weight * joints.Shifts[i];
    }
  }

  /// The second vertex of another pair.
  LITTORAL_INLINE void TakeSecond(const Blend& other)
  {
    const auto take = [](SimdPair& own, const SimdPair& from) {
      own = __builtin_shufflevector(own, from, 0, 1, 2, 3, 12, 13, 14, 15);
    };
    take(this->Columns[0], other.Columns[0]);
    take(this->Columns[1], other.Columns[1]);
    take(this->Columns[2], other.Columns[2]);
    take(this->Shift, other.Shift);
    take(this->Center, other.Center);
  }
};

/// The blends of one pair of vertices after the other. Vertices around a branch follow the same joints alike, those of
/// a crown the same joints.
class BlendWalk
{
public:
  Blend Now;

  LITTORAL_INLINE BlendWalk(const RestSkin& rest, const JointChange* changes)
    : Rest(rest)
    , Changes(changes)
  {
  }

  LITTORAL_INLINE void Enter(std::size_t first, std::size_t second)
  {
    const int* ids[2] = { this->Rest.JointIds + 4 * first, this->Rest.JointIds + 4 * second };
    const float* weights[2] = { this->Rest.JointWeights + 4 * first, this->Rest.JointWeights + 4 * second };
    const bool isAlike = IsSame(ids[0], ids[1]);
    const bool isOne = isAlike && IsSame(weights[0], weights[1]);
    if (isOne && this->Weights && IsSame(ids[0], this->Joints.Ids) && IsSame(weights[0], this->Weights))
    {
      return;
    }
    this->Weights = isOne ? weights[0] : nullptr;
    const std::size_t counts[2] = { JointsOf(weights[0]), JointsOf(weights[1]) };
    this->Joints.Take(ids[0], isAlike ? std::max(counts[0], counts[1]) : counts[0], this->Changes);
    this->Now = Blend(this->Joints, weights[0], weights[1]);
    if (!isAlike)
    {
      this->Joints.Take(ids[1], counts[1], this->Changes);
      this->Now.TakeSecond(Blend(this->Joints, weights[1], weights[1]));
    }
  }

private:
  const RestSkin& Rest;
  const JointChange* Changes;
  FollowedJoints Joints;
  const float* Weights = nullptr; // of all vertices of Now, where they are the same
};

/// Moves two vertices; their normals get lengths later. The last pair of a range may be one vertex twice.
template <bool IsLast>
LITTORAL_INLINE void MovePair(
  const RestSkin& rest, const Blend& blend, std::size_t first, std::size_t second, float* points, float* normals)
{
  const auto load = [&](const float* from) {
    return Join(Load<IsLast>(from + 3 * first), Load<IsLast>(from + 3 * second));
  };
  const auto store = [&](const SimdPair& pair, float* to) {
    Store<IsLast>(__builtin_shufflevector(pair, pair, 0, 1, 2, 3), to + 3 * first);
    Store<IsLast>(__builtin_shufflevector(pair, pair, 4, 5, 6, 7), to + 3 * second);
  };
  // p + ((R - 1) (p - c) + t), n + (R - 1) n
  const SimdPair place = load(rest.Points);
  store(place + (Turned(blend.Columns, place - blend.Center) + blend.Shift), points);
  if (rest.Normals)
  {
    const SimdPair normal = load(rest.Normals);
    store(normal + Turned(blend.Columns, normal), normals);
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
LITTORAL_SIMD_CLONES void MoveSkin(
  const RestSkin& rest, const JointChange* joints, std::size_t begin, std::size_t end, float* points, float* normals)
{
  constexpr std::size_t Block = 256; // vertices whose normals are still near when they get their lengths
  BlendWalk walk(rest, joints);
  for (std::size_t block = begin; block < end; block += Block)
  {
    const std::size_t last = std::min(end, block + Block);
    for (std::size_t vertex = block; vertex < last; vertex += 2)
    {
      const std::size_t second = std::min(vertex + 1, last - 1);
      walk.Enter(vertex, second);
      if (second + 1 < last)
      {
        MovePair<false>(rest, walk.Now, vertex, second, points, normals);
      }
      else
      {
        MovePair<true>(rest, walk.Now, vertex, second, points, normals);
      }
    }
    if (rest.Normals)
    {
      KeepLengths(rest.Normals + 3 * block, last - block, normals + 3 * block);
    }
  }
}

}
