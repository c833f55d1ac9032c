// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Skinning.h"

#include <cstring>

namespace littoral
{

namespace
{

/// Matrix times vector.
template <typename Number>
LITTORAL_INLINE Lanes Turned(const Lanes* columns, const Number* vector)
{
  return columns[0] * Lanes(vector[0]) + columns[1] * Lanes(vector[1]) + columns[2] * Lanes(vector[2]);
}

LITTORAL_INLINE double SquareOf(const double* vector)
{
  return vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2];
}

template <typename Number>
LITTORAL_INLINE bool IsSame(const Number* a, const Number* b)
{
  return std::memcmp(a, b, 4 * sizeof(Number)) == 0;
}

/// The mean change of four joints by their weights.
template <typename Real>
LITTORAL_INLINE void Blend(const int* ids, const Real* weights, const JointChange* joints, Lanes* columns)
{
  for (int column = 0; column < 4; ++column)
  {
    columns[column] = Lanes(weights[0]) * joints[ids[0]].Columns[column];
  }
  for (int i = 1; i < 4; ++i)
  {
    if (weights[i] != Real(0))
    {
      for (int column = 0; column < 4; ++column)
      {
        columns[column] += Lanes(weights[i]) * joints[ids[i]].Columns[column];
      }
    }
  }
}

template <typename Real>
LITTORAL_INLINE void MoveVertices(const RestSkin<Real>& rest, const JointChange* joints, std::size_t begin,
  std::size_t end, Real* points, Real* normals)
{
  Lanes columns[4]{ 0.0, 0.0, 0.0, 0.0 };
  for (std::size_t vertex = begin; vertex < end; ++vertex)
  {
    // Vertices around a branch follow the same joints alike.
    const Real* weights = rest.JointWeights + 4 * vertex;
    const int* ids = rest.JointIds + 4 * vertex;
    if (vertex == begin || !IsSame(ids, ids - 4) || !IsSame(weights, weights - 4))
    {
      Blend(ids, weights, joints, columns);
    }
    const Real* p = rest.Points + 3 * vertex;
    const Lanes moved = Turned(columns, p) + columns[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      points[3 * vertex + axis] = static_cast<Real>(p[axis] + moved.Values[axis]);
    }
    if (!rest.Normals)
    {
      continue;
    }
    const Real* n = rest.Normals + 3 * vertex;
    const Lanes change = Turned(columns, n);
    const double before[3] = { n[0], n[1], n[2] };
    const double after[3] = { n[0] + change.Values[0], n[1] + change.Values[1], n[2] + change.Values[2] };
    const double square = SquareOf(after);
    const double factor = square > 0.0 ? std::sqrt(SquareOf(before) / square) : 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      normals[3 * vertex + axis] = static_cast<Real>(factor * after[axis]);
    }
  }
}

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
  const Vector3& shift = pose.Shift;
  change.Columns[3] = Lanes(shift.x, shift.y, shift.z, 0.0) - Turned(change.Columns.data(), &rest.x);
  return change;
}

Vector3 JointChange::Of(const Vector3& place) const
{
  const Lanes moved = Turned(this->Columns.data(), &place.x) + this->Columns[3];
  return { moved.Values[0], moved.Values[1], moved.Values[2] };
}

//----------------------------------------------------------------------------
LITTORAL_SIMD_CLONES void MoveSkin(const RestSkin<float>& rest, const JointChange* joints, std::size_t begin,
  std::size_t end, float* points, float* normals)
{
  MoveVertices(rest, joints, begin, end, points, normals);
}

LITTORAL_SIMD_CLONES void MoveSkin(const RestSkin<double>& rest, const JointChange* joints, std::size_t begin,
  std::size_t end, double* points, double* normals)
{
  MoveVertices(rest, joints, begin, end, points, normals);
}

}
