// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Skins of joints whose turns are known.
#include "Numerics/Constants.h"
#include "Plants/Skinning.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace littoral;

namespace
{

/// A turn about the vertical through a place, which moves by a shift.
JointPose TurnedBy(double angle, const Vector3& shift)
{
  return { { std::cos(0.5 * angle), 0.0, 0.0, std::sin(0.5 * angle) }, shift };
}

}

TEST(Skinning, AJointTurnsAboutItsPlace)
{
  const Vector3 rest{ 2.0, 1.0, 5.0 };
  const Vector3 shift{ 0.5, -0.25, 1.0 };
  const JointChange change = ChangeOf(TurnedBy(0.5 * Pi, shift), rest);
  const Vector3 own = change.Of(rest);
  const Vector3 east = change.Of(rest + Vector3(3.0, 0.0, 2.0)); // goes to the north
  const Vector3 wanted = shift + Vector3(-3.0, 3.0, 0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(own[axis], shift[axis], 1e-12);
    EXPECT_NEAR(east[axis], wanted[axis], 1e-12);
  }
}

// Half of a turn to the left and half of one to the right: a place is drawn in by the cosine, a normal keeps its
// length.
TEST(Skinning, NormalsOfBlendedTurnsKeepTheirLengths)
{
  const int count = 100; // more than are stored at once
  std::vector<float> points;
  std::vector<float> normals;
  std::vector<int> ids;
  std::vector<float> weights;
  for (int n = 0; n < count; ++n)
  {
    points.insert(points.end(), { 1.0f, 0.0f, static_cast<float>(n) });
    normals.insert(normals.end(), { n % 2 ? 1.0f : 2.0f, 0.0f, 0.0f });
    ids.insert(ids.end(), { 0, 1, 0, 0 });
    weights.insert(weights.end(), { 0.5f, 0.5f, 0.0f, 0.0f });
  }
  const double angle = Pi / 3.0;
  const std::vector<JointChange> joints{ ChangeOf(TurnedBy(angle, Vector3(0.0)), Vector3(0.0)),
    ChangeOf(TurnedBy(-angle, Vector3(0.0)), Vector3(0.0)) };
  std::vector<float> movedPoints(points.size());
  std::vector<float> movedNormals(normals.size());
  MoveSkin({ points.data(), normals.data(), ids.data(), weights.data() }, joints.data(), 0, count, movedPoints.data(),
    movedNormals.data());
  for (int n = 0; n < count; ++n)
  {
    EXPECT_NEAR(movedPoints[3 * n], 0.5, 1e-6);
    EXPECT_NEAR(movedPoints[3 * n + 1], 0.0, 1e-6);
    EXPECT_NEAR(movedPoints[3 * n + 2], n, 1e-5);
    EXPECT_NEAR(movedNormals[3 * n], n % 2 ? 1.0 : 2.0, 1e-6);
    EXPECT_NEAR(movedNormals[3 * n + 1], 0.0, 1e-6);
  }
}
