// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of rivers that are known: straight ones, circles, stairs of cells, confluences.
#include "Drainage/RiverSurface.h"
#include "Numerics/Constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>

using namespace littoral;

namespace
{

/// A river through places, which drains an area.
RiverNetwork RiverThrough(int nodes, double area, const std::function<Vector3(int)>& placeOf)
{
  RiverNetwork network;
  for (int k = 0; k < nodes; ++k)
  {
    network.Places.push_back(placeOf(k));
    network.Areas.push_back(area + k);
  }
  network.Courses.emplace_back(static_cast<std::size_t>(nodes));
  std::iota(network.Courses[0].begin(), network.Courses[0].end(), std::size_t(0));
  return network;
}

/// Area of a band, of the triangles between its sections seen from above.
double AreaOf(const std::vector<RiverSection>& sections)
{
  const auto twice = [](const Vector3& a, const Vector3& b, const Vector3& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  };
  double area = 0.0;
  for (std::size_t k = 1; k < sections.size(); ++k)
  {
    const auto& above = sections[k - 1].Banks;
    const auto& here = sections[k].Banks;
    area += 0.5 * (twice(above[1], here[1], here[0]) + twice(above[1], here[0], above[0]));
  }
  return area;
}

double LengthOf(const RiverNetwork& network)
{
  double length = 0.0;
  for (std::size_t k = 1; k < network.Places.size(); ++k)
  {
    length += glm::distance(network.Places[k - 1], network.Places[k]);
  }
  return length;
}

}

TEST(RiverSurface, WidthFollowsTheLaw)
{
  RiverShape shape;
  shape.WidthOfUnitArea = 3.0;
  shape.WidthExponent = 0.5;
  EXPECT_DOUBLE_EQ(RiverWidth(shape, 1e6), 3.0);
  EXPECT_DOUBLE_EQ(RiverWidth(shape, 1e8), 30.0);
  shape.WidthExponent = 0.0;
  EXPECT_DOUBLE_EQ(RiverWidth(shape, 5.0), 3.0);
}

TEST(RiverSurface, StraightRiverIsARectangle)
{
  // 200 m to the north-east down a slope of 0.02, 10 m wide
  const double diagonal = std::sqrt(0.5);
  const RiverNetwork network =
    RiverThrough(21, 1e8, [&](int k) { return Vector3(10.0 * diagonal * k, 10.0 * diagonal * k, 5.0 - 0.2 * k); });
  RiverShape shape;
  shape.WidthOfUnitArea = 1.0;
  shape.WidthExponent = 0.5;
  const auto rivers = RiverSections(network, shape);
  ASSERT_EQ(rivers.size(), 1U);
  ASSERT_EQ(rivers[0].size(), 81U);
  EXPECT_NEAR(AreaOf(rivers[0]), 2000.0, 1e-3);
  const Vector3 normal = glm::normalize(Vector3(0.02 * diagonal, 0.02 * diagonal, 1.0));
  for (const RiverSection& section : rivers[0])
  {
    EXPECT_EQ(section.Banks[0].z, section.Banks[1].z);
    EXPECT_NEAR(section.Banks[0].z, 5.0 - 0.01 * (section.Banks[0].x + section.Banks[0].y) / diagonal, 1e-9);
    EXPECT_GT(section.Banks[0].y - section.Banks[0].x, section.Banks[1].y - section.Banks[1].x); // left, downstream
    EXPECT_NEAR(glm::distance(section.Normal, normal), 0.0, 1e-9);
  }
}

TEST(RiverSurface, RoundRiverIsARing)
{
  // Three quarters of a circle of 100 m in steps of 7.5 degrees: 3/4 2 pi R w
  const RiverNetwork network = RiverThrough(37, 1e8, [](int k) {
    const double angle = TwoPi * k / 48.0;
    return Vector3(100.0 * std::cos(angle), 100.0 * std::sin(angle), 0.0);
  });
  RiverShape shape;
  shape.WidthOfUnitArea = 1.0;
  shape.WidthExponent = 0.5;
  const double wanted = 0.75 * TwoPi * 100.0 * 10.0;
  EXPECT_NEAR(AreaOf(RiverSections(network, shape)[0]), wanted, 2e-3 * wanted);
}

TEST(RiverSurface, SmoothingTakesTheCornersOfCells)
{
  // Along a direction of 1 in 3 by cells: a straight line is 1.073 times as short. Its ends stay.
  RiverNetwork network = RiverThrough(121, 1e6, [](int k) { return Vector3(k, (k + 1) / 3, 0.0); });
  const Vector3 head = network.Places.front();
  const Vector3 end = network.Places.back();
  const double straight = glm::distance(head, end);
  EXPECT_GT(LengthOf(network), 1.07 * straight);
  SmoothCourses(network, RiverShape().Smoothing);
  EXPECT_LT(LengthOf(network), 1.002 * straight);
  EXPECT_EQ(network.Places.front(), head);
  EXPECT_EQ(network.Places.back(), end);
}

TEST(RiverSurface, SmoothingSpreadsAsItsBinomialTellsIt)
{
  // One place off a straight line by 1: n times 1/4, 1/2, 1/4 are the binomial coefficients of 2n, over 4^n.
  RiverNetwork network = RiverThrough(31, 1e6, [](int k) { return Vector3(k, k == 15 ? 1.0 : 0.0, 0.0); });
  SmoothCourses(network, 4);
  const double binomial[] = { 70.0, 56.0, 28.0, 8.0, 1.0, 0.0 };
  for (int off = 0; off < 6; ++off)
  {
    EXPECT_NEAR(network.Places[15 + off].y, binomial[off] / 256.0, 1e-12);
    EXPECT_NEAR(network.Places[15 - off].y, binomial[off] / 256.0, 1e-12);
  }
}

TEST(RiverSurface, TributaryStaysAtItsConfluence)
{
  // A corner of the larger river is a confluence, which moves, and the tributary's end with it.
  RiverNetwork network;
  for (int k = 0; k <= 10; ++k)
  {
    network.Places.emplace_back(k, std::max(0, k - 5), 10.0 - k);
    network.Areas.push_back(1e6 + 1e5 * k);
  }
  for (int k = 0; k < 5; ++k)
  {
    network.Places.emplace_back(5.0, k - 5.0, 10.0 - k);
    network.Areas.push_back(1e4 + k);
  }
  network.Courses = { { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10 }, { 11, 12, 13, 14, 15, 5 } };
  SmoothCourses(network, 1);
  EXPECT_NEAR(network.Places[5].y, 0.25, 1e-12);
  EXPECT_NEAR(network.Places[15].y, 0.25 * -2.0 + 0.5 * -1.0, 1e-12);
  const auto rivers = RiverSections(network, RiverShape());
  const Vector3 end = 0.5 * (rivers[1].back().Banks[0] + rivers[1].back().Banks[1]);
  EXPECT_NEAR(glm::distance(end, network.Places[5]), 0.0, 1e-12);
  // It is as wide there as it was before, not as the river that it has reached.
  EXPECT_NEAR(rivers[1].back().Width, RiverWidth(RiverShape(), 1e4 + 4), 1e-12);
  EXPECT_NEAR(rivers[0].front().Width, RiverWidth(RiverShape(), 1e6), 1e-12);
}

TEST(RiverSurface, WaterFallsAllTheWay)
{
  // Behind each hump it stands as high as the hump, also up a tributary.
  RiverNetwork network =
    RiverThrough(40, 1e6, [](int k) { return Vector3(k, 0.0, 20.0 - 0.5 * k + 3.0 * std::sin(0.9 * k)); });
  network.Places.emplace_back(20.0, 5.0, 0.0);
  network.Areas.push_back(1e3);
  network.Courses.push_back({ 40, 20 });
  const RiverNetwork before = network;
  LetFlow(network);
  for (const auto& course : network.Courses)
  {
    for (std::size_t k = 1; k < course.size(); ++k)
    {
      EXPECT_GE(network.Places[course[k - 1]].z, network.Places[course[k]].z);
    }
  }
  double highest = -1e9;
  for (int k = 39; k >= 0; --k)
  {
    highest = std::max(highest, before.Places[static_cast<std::size_t>(k)].z);
    EXPECT_EQ(network.Places[static_cast<std::size_t>(k)].z, highest);
  }
  EXPECT_EQ(network.Places[40].z, network.Places[20].z);
}

TEST(RiverSurface, DirectionsAreAlike)
{
  const auto bend = [](int k) { return Vector3(10.0 * k, 30.0 * std::sin(0.4 * k), -0.1 * k); };
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  const auto turned = [&](const Vector3& p) { return Vector3(c * p.x - s * p.y + 1e5, s * p.x + c * p.y - 2e5, p.z); };
  const auto one = RiverSections(RiverThrough(30, 2e6, bend), RiverShape());
  const auto other = RiverSections(RiverThrough(30, 2e6, [&](int k) { return turned(bend(k)); }), RiverShape());
  for (std::size_t k = 0; k < one[0].size(); ++k)
  {
    for (int side = 0; side < 2; ++side)
    {
      EXPECT_NEAR(glm::distance(turned(one[0][k].Banks[side]), other[0][k].Banks[side]), 0.0, 1e-8);
    }
  }
}

TEST(RiverSurface, ShapesAreChecked)
{
  EXPECT_EQ(WhyInvalid(RiverShape()), "");
  RiverShape shape;
  shape.WidthOfUnitArea = 0.0;
  EXPECT_NE(WhyInvalid(shape).find("WidthOfUnitArea"), std::string::npos);
  shape = RiverShape();
  shape.WidthExponent = std::nan("");
  EXPECT_NE(WhyInvalid(shape).find("WidthExponent"), std::string::npos);
  shape = RiverShape();
  shape.Subdivision = 0;
  EXPECT_NE(WhyInvalid(shape).find("Subdivision"), std::string::npos);
}
