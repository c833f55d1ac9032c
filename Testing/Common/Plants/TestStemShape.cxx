// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/Constants.h"
#include "Plants/StemShape.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace littoral;

namespace
{

constexpr int Sides = 360;

/// A cone without an end about an upright axis, with a radius at its foot and none at its top [m].
struct Cone
{
  std::vector<Vector3> Points;
  std::vector<std::array<int, 3>> Triangles;

  void Add(const Vector3& foot, double radius, double height)
  {
    const int first = static_cast<int>(this->Points.size());
    for (int side = 0; side <= Sides; ++side) // the last place is the first one again
    {
      const double angle = 2.0 * Pi * (side % Sides) / Sides;
      this->Points.push_back(foot + radius * Vector3(std::cos(angle), std::sin(angle), 0.0));
    }
    this->Points.push_back(foot + Vector3(0.0, 0.0, height));
    for (int side = 0; side < Sides; ++side)
    {
      this->Triangles.push_back({ first + side, first + side + 1, first + Sides + 1 });
    }
  }
};

/// A cone 20 m high and 0.8 m thick at the foot, with a branch through breast height, and leaves up to 25 m.
StemShape Tree()
{
  Cone cone;
  cone.Add({ 3.0, 0.0, 0.5 }, 2.0, 4.0);
  cone.Add({ 0.0, 0.0, 0.0 }, 0.4, 20.0);
  return { cone.Points, cone.Triangles, 25.0 };
}

}

TEST(StemShape, GirthOfACone)
{
  const StemShape stem = Tree();
  ASSERT_TRUE(stem.IsThere());
  for (const double height : { 0.1, 1.3, 7.0, 19.5 })
  {
    EXPECT_NEAR(stem.DiameterAt(height) / (0.8 * (1.0 - height / 20.0)), 1.0, 2e-5) << height;
  }
  EXPECT_EQ(stem.DiameterAt(-0.1), 0.0);
  EXPECT_EQ(stem.DiameterAt(20.1), 0.0);
}

TEST(StemShape, FitsHeightAndDiameter)
{
  const StemShape stem = Tree();
  for (const auto& [height, diameter] : { std::pair(10.0, 0.1), { 25.0, 0.9 }, { 60.0, 2.0 }, { 1.9, 0.01 } })
  {
    PlantPlace place;
    EXPECT_EQ(stem.Fit({ height, diameter }, place), "");
    EXPECT_NEAR(place.Scale * 25.0, height, 1e-12);
    // The diameter of the scaled cone where it is measured: D = s g 0.8 (1 - h / (20 s)).
    const double at = height < 2.6 ? 0.5 * height : 1.3;
    const double own = place.Scale * place.WidthScale * 0.8 * (1.0 - at / (20.0 * place.Scale));
    EXPECT_NEAR(own / diameter, 1.0, 2e-5) << height;
  }
}

TEST(StemShape, OneMeasureKeepsProportions)
{
  const StemShape stem = Tree();
  PlantPlace place;
  EXPECT_EQ(stem.Fit({ 12.5, 0.0 }, place), "");
  EXPECT_DOUBLE_EQ(place.Scale, 0.5);
  EXPECT_EQ(place.WidthScale, 1.0);
  EXPECT_EQ(stem.Fit({ 0.0, 0.3 }, place), "");
  EXPECT_EQ(place.WidthScale, 1.0);
  // s 0.8 (1 - 1.3 / (20 s)) = 0.3
  EXPECT_NEAR(place.Scale, (0.3 + 0.8 * 1.3 / 20.0) / 0.8, 2e-5);
}

TEST(StemShape, NoStem)
{
  PlantPlace place;
  EXPECT_NE(StemShape().Fit({ 10.0, 0.3 }, place).find("no stem"), std::string::npos);
  EXPECT_FALSE(StemShape().IsThere());
  EXPECT_NE(
    WhyInvalid(TreeDimensions{ 200.0, 0.3 }, " of site 3").find("Height of site 3 is 200 m"), std::string::npos);
  EXPECT_NE(WhyInvalid(TreeDimensions{ 20.0, -0.3 }, " of site 3").find("DBH of site 3"), std::string::npos);
}

TEST(StemShape, NormalsOfAnEllipsoid)
{
  // A sphere that is wider by g is an ellipsoid, x^2 / g^2 + y^2 / g^2 + z^2 = 1, with normals along (x/g^2, y/g^2, z).
  PlantPlace place;
  place.WidthScale = 2.5;
  place.Scale = 0.4;
  place.Azimuth = 0.9;
  const PlantPlacement placement(place);
  for (double z = -0.95; z < 1.0; z += 0.19)
  {
    const double r = std::sqrt(1.0 - z * z);
    const float own[3] = { static_cast<float>(0.6 * r), static_cast<float>(-0.8 * r), static_cast<float>(z) };
    float point[3];
    float normal[3];
    float length = 0.0f;
    placement.Points(own, 1, point);
    placement.Directions(own, 1, normal);
    placement.Lengths(own + 2, 1, &length);
    const Vector3 wanted = glm::normalize(Vector3(point[0], point[1], 0.0) / 6.25 + Vector3(0.0, 0.0, point[2]));
    EXPECT_NEAR(glm::distance(wanted, Vector3(normal[0], normal[1], normal[2])), 0.0, 1e-6) << z;
    EXPECT_NEAR(std::hypot(point[0], point[1]), r, 1e-6);
    EXPECT_NEAR(length, z, 1e-6);
  }
  Skeleton trunk;
  trunk.StartBranch(-1, { 0.5, 0.0, 0.0 }, 0.3);
  trunk.Grow({ 0.5, 0.0, 4.0 }, 0.2);
  const Skeleton placed = Placed(trunk, place);
  EXPECT_DOUBLE_EQ(placed.Nodes[1].Radius, 0.2 * 0.4 * 2.5);
  EXPECT_NEAR(glm::length(placed.Nodes[1].Position), std::hypot(0.5, 1.6), 1e-12);
  const Box box = BoxOf(place, { 3.0, -1.0, 4.0 });
  EXPECT_DOUBLE_EQ(box.High.x, 3.0);
  EXPECT_DOUBLE_EQ(box.High.z, 1.6);
}
