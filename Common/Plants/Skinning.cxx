// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/Skinning.h"

#include "Numerics/SimdDouble4.h"

#include <cmath>
#include <cstring>

namespace littoral
{

namespace
{

/// A column of a change.
LITTORAL_INLINE SimdDouble4 LoadColumn(const std::array<double, 4>& column)
{
  SimdDouble4 four;
  std::memcpy(&four.Values, column.data(), sizeof(four.Values));
  return four;
}

/// Three numbers of an array; the fourth lane is 0.
LITTORAL_INLINE SimdDouble4 Load(const float* from)
{
  const SimdFloat4 four{ from[0], from[1], from[2], 0.0f };
  return SimdDouble4(__builtin_convertvector(four, SimdDouble4::Register));
}

LITTORAL_INLINE void Store(const SimdDouble4& from, float* to)
{
  const SimdFloat4 four = __builtin_convertvector(from.Values, SimdFloat4);
  to[0] = four[0];
  to[1] = four[1];
  to[2] = four[2];
}

/// One lane in all.
template <int Lane>
LITTORAL_INLINE SimdDouble4 All(const SimdDouble4& a)
{
  return SimdDouble4(__builtin_shufflevector(a.Values, a.Values, Lane, Lane, Lane, Lane));
}

/// Matrix times vector.
LITTORAL_INLINE SimdDouble4 Turned(const SimdDouble4* columns, const SimdDouble4& vector)
{
  return columns[0] * All<0>(vector) + columns[1] * All<1>(vector) + columns[2] * All<2>(vector);
}

/// (R - 1) p.
Vector3 Turned(const JointChange& change, const Vector3& p)
{
  const auto row = [&](int i) {
    return change.Columns[0][i] * p.x + change.Columns[1][i] * p.y + change.Columns[2][i] * p.z;
  };
  return { row(0), row(1), row(2) };
}

LITTORAL_INLINE double SquareOf(const SimdDouble4& a)
{
  const SimdDouble4 squares = a * a;
  return squares.Values[0] + squares.Values[1] + squares.Values[2];
}

template <typename Number>
LITTORAL_INLINE bool IsSame(const Number* a, const Number* b)
{
  return std::memcmp(a, b, 4 * sizeof(Number)) == 0;
}

/// The mean change of four joints by their weights.
LITTORAL_INLINE void Blend(const int* ids, const float* weights, const JointChange* joints, SimdDouble4* columns)
{
  // Linear blend skinning: [R - 1 | t] = sum over joints of w_i [R_i - 1 | t_i]
  for (int column = 0; column < 4; ++column)
  {
    columns[column] = SimdDouble4(weights[0]) * LoadColumn(joints[ids[0]].Columns[column]);
  }
  for (int i = 1; i < 4; ++i)
  {
    if (weights[i] != 0.0f)
    {
      for (int column = 0; column < 4; ++column)
      {
        columns[column] += SimdDouble4(weights[i]) * LoadColumn(joints[ids[i]].Columns[column]);
      }
    }
  }
}

/// Normals that wait for their lengths: roots and divisions are slow one by one.
struct TurnedNormals
{
  static constexpr std::size_t Most = 64;
  SimdDouble4 Turned[Most];
  double Before[Most]; ///< squares of lengths
  double After[Most];
  std::size_t Count = 0;

  LITTORAL_INLINE void Add(const SimdDouble4& before, const SimdDouble4& turned)
  {
    this->Turned[this->Count] = turned;
    this->Before[this->Count] = SquareOf(before);
    this->After[this->Count] = SquareOf(turned);
    ++this->Count;
  }

  /// Stores them, with the lengths that they had.
  LITTORAL_INLINE void Store(float* to)
  {
    double factors[Most]; // all of them: without conditions the compiler takes four at a time
    for (std::size_t i = 0; i < Most; ++i)
    {
      factors[i] = std::sqrt(this->Before[i] / (this->After[i] + 1e-300));
    }
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      littoral::Store(SimdDouble4(factors[i]) * this->Turned[i], to + 3 * i);
    }
    this->Count = 0;
  }
};

}

//----------------------------------------------------------------------------
JointChange ChangeOf(const JointPose& pose, const Vector3& rest)
{
  const glm::dquat& q = pose.Rotation;
  JointChange change;
  change.Columns[0] = { -2.0 * (q.y * q.y + q.z * q.z), 2.0 * (q.x * q.y + q.w * q.z), 2.0 * (q.x * q.z - q.w * q.y),
    0.0 };
  change.Columns[1] = { 2.0 * (q.x * q.y - q.w * q.z), -2.0 * (q.x * q.x + q.z * q.z), 2.0 * (q.y * q.z + q.w * q.x),
    0.0 };
  change.Columns[2] = { 2.0 * (q.x * q.z + q.w * q.y), 2.0 * (q.y * q.z - q.w * q.x), -2.0 * (q.x * q.x + q.y * q.y),
    0.0 };
  // The shift of the rest position itself is that of the pose: t - (R - 1) p.
  const Vector3 turned = Turned(change, rest);
  change.Columns[3] = { pose.Shift.x - turned.x, pose.Shift.y - turned.y, pose.Shift.z - turned.z, 0.0 };
  return change;
}

Vector3 JointChange::Of(const Vector3& place) const
{
  const std::array<double, 4>& shift = this->Columns[3];
  return Turned(*this, place) + Vector3(shift[0], shift[1], shift[2]);
}

//----------------------------------------------------------------------------
LITTORAL_SIMD_CLONES void MoveSkin(
  const RestSkin& rest, const JointChange* joints, std::size_t begin, std::size_t end, float* points, float* normals)
{
  SimdDouble4 columns[4]{ 0.0, 0.0, 0.0, 0.0 };
  TurnedNormals waiting{};
  for (std::size_t vertex = begin; vertex < end; ++vertex)
  {
    // Vertices around a branch follow the same joints alike.
    const float* weights = rest.JointWeights + 4 * vertex;
    const int* ids = rest.JointIds + 4 * vertex;
    if (vertex == begin || !IsSame(ids, ids - 4) || !IsSame(weights, weights - 4))
    {
      Blend(ids, weights, joints, columns);
    }
    const SimdDouble4 place = Load(rest.Points + 3 * vertex);
    Store(place + (Turned(columns, place) + columns[3]), points + 3 * vertex);
    if (rest.Normals)
    {
      const SimdDouble4 normal = Load(rest.Normals + 3 * vertex);
      waiting.Add(normal, normal + Turned(columns, normal));
      if (waiting.Count == TurnedNormals::Most || vertex + 1 == end)
      {
        waiting.Store(normals + 3 * (vertex + 1 - waiting.Count));
      }
    }
  }
}

}
