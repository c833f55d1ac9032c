// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Frames on the earth: places whose coordinates are known, normals, and ways there and back.
#include "Geometry/EarthFrame.h"

#include "Numerics/Constants.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace littoral;

TEST(EarthFrame, PlacesOfTheAxesAreThoseOfTheEllipsoid)
{
  constexpr double a = 6378137.0;
  constexpr double b = 6356752.314245179; // of WGS 84
  const Vector3 gulf = EarthCentred({ 0.0, 0.0 }, 10.0);
  EXPECT_NEAR(gulf.x, a + 10.0, 1e-6);
  EXPECT_NEAR(EarthCentred({ 90.0, 0.0 }, -3.0).y, a - 3.0, 1e-6);
  EXPECT_NEAR(EarthCentred({ 12.0, 90.0 }, 5.0).z, b + 5.0, 1e-6);
  EXPECT_NEAR(EarthCentred({ 12.0, -90.0 }, 5.0).z, -b - 5.0, 1e-6);
}

TEST(EarthFrame, PlacesLieOnTheEllipsoidAndUpIsItsNormal)
{
  constexpr double a = 6378137.0;
  constexpr double b = 6356752.314245179;
  for (const EarthPlace& place : { EarthPlace{ 9.0, 48.0 }, EarthPlace{ -70.0, -33.0 }, EarthPlace{ 179.0, 71.0 } })
  {
    const Vector3 at = EarthCentred(place, 0.0);
    EXPECT_NEAR((at.x * at.x + at.y * at.y) / (a * a) + at.z * at.z / (b * b), 1.0, 1e-14);
    const Vector3 gradient(at.x / (a * a), at.y / (a * a), at.z / (b * b));
    EXPECT_NEAR(glm::dot(glm::normalize(gradient), UpAt(place)), 1.0, 1e-14);
    EXPECT_NEAR(glm::length(EarthCentred(place, 100.0) - at - 100.0 * UpAt(place)), 0.0, 1e-6);
  }
}

TEST(EarthFrame, TakesPlacesThereAndBack)
{
  const EarthPlace place{ 9.0, 48.0 };
  const Vector3 origin = EarthCentred(place, 300.0);
  const EarthFrame frame(origin, UpAt(place), EarthCentred({ 9.001, 48.0 }, 300.0));
  const Vector3 local(3.0, -40.0, 500.0);
  EXPECT_NEAR(glm::length(frame.ToLocal(frame.ToEarth(local)) - local), 0.0, 1e-8);
  // x to the east, y to the north.
  EXPECT_NEAR(frame.X.z, 0.0, 1e-4);
  EXPECT_GT(frame.Y.z, 0.6);
  EXPECT_NEAR(glm::dot(glm::cross(frame.X, frame.Y), frame.Up), 1.0, 1e-14);
  const EarthFrame other(EarthCentred({ 9.1, 48.1 }, 0.0), UpAt({ 9.1, 48.1 }), origin);
  const std::array<double, 16> matrix = frame.MatrixTo(other);
  const Vector3 wanted = other.ToLocal(frame.ToEarth(local));
  for (int row = 0; row < 3; ++row)
  {
    double sum = matrix[12 + row];
    for (int column = 0; column < 3; ++column)
    {
      sum += matrix[4 * column + row] * local[column];
    }
    EXPECT_NEAR(sum, wanted[row], 1e-7);
  }
}
