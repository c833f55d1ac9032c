// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Windows: areas, distances, circles and moved windows against closed forms and samples; every bad polygon and pattern.
#include "Numerics/Constants.h"
#include "Patterns/ObservationWindow.h"
#include "Patterns/WindowSections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

using namespace littoral;

namespace
{

const double NaN = std::numeric_limits<double>::quiet_NaN();

ObservationWindow Triangle(double leg)
{
  return ObservationWindow::Polygon({ { 0.0, 0.0 }, { leg, 0.0 }, { 0.0, leg } });
}

/// A rectangle with a corner too many, so that it is measured as a polygon.
ObservationWindow RectangleAsPolygon(double width, double height)
{
  return ObservationWindow::Polygon(
    { { 0.0, 0.0 }, { 0.3 * width, 0.0 }, { width, 0.0 }, { width, height }, { 0.0, height } });
}

/// A square of 4 m without its upper middle.
ObservationWindow Horseshoe()
{
  return ObservationWindow::Polygon(
    { { 0.0, 0.0 }, { 4.0, 0.0 }, { 4.0, 4.0 }, { 3.0, 4.0 }, { 3.0, 1.0 }, { 1.0, 1.0 }, { 1.0, 4.0 }, { 0.0, 4.0 } });
}

/// The part of a circle in a window, by samples.
double SampledCircle(const ObservationWindow& window, const PlanePosition& center, double radius)
{
  constexpr int Samples = 200000;
  int inside = 0;
  for (int n = 0; n < Samples; ++n)
  {
    const double angle = TwoPi * (n + 0.5) / Samples;
    inside += window.Contains({ center[0] + radius * std::cos(angle), center[1] + radius * std::sin(angle) });
  }
  return static_cast<double>(inside) / Samples;
}

TEST(ObservationWindow, MeasuresAreaAndBoxOfPolygonsInBothSenses)
{
  const ObservationWindow shoe = Horseshoe();
  EXPECT_EQ(shoe.WhyInvalid(), "");
  EXPECT_FALSE(shoe.IsRectangle());
  EXPECT_DOUBLE_EQ(shoe.GetArea(), 10.0);
  std::vector<PlanePosition> corners = shoe.GetCorners();
  std::reverse(corners.begin(), corners.end());
  corners.push_back(corners.front()); // closed
  const ObservationWindow reversed = ObservationWindow::Polygon(corners);
  EXPECT_EQ(reversed.WhyInvalid(), "");
  EXPECT_DOUBLE_EQ(reversed.GetArea(), 10.0);
  EXPECT_EQ(reversed.GetCorners().size(), 8u);
  EXPECT_EQ(reversed.GetHigh(), (PlanePosition{ 4.0, 4.0 }));
}

TEST(ObservationWindow, KnowsRectangles)
{
  const ObservationWindow box = ObservationWindow::Rectangle({ -1.0, 2.0 }, { 4.0, 3.0 });
  EXPECT_TRUE(box.IsRectangle());
  EXPECT_DOUBLE_EQ(box.GetArea(), 5.0);
  EXPECT_TRUE(ObservationWindow::Polygon({ { 0, 0 }, { 0, 2 }, { 3, 2 }, { 3, 0 } }).IsRectangle());
  EXPECT_FALSE(ObservationWindow::Polygon({ { 0, 0 }, { 3, 0 }, { 4, 2 }, { 1, 2 } }).IsRectangle());
  EXPECT_FALSE(ObservationWindow::Polygon({ { 0, 0 }, { 3, 1 }, { 3, 3 }, { 0, 2 } }).IsRectangle());
  EXPECT_FALSE(RectangleAsPolygon(3.0, 2.0).IsRectangle());
}

TEST(ObservationWindow, ContainsItsEdgesAndNoMore)
{
  const ObservationWindow shoe = Horseshoe();
  for (const PlanePosition& point :
    { PlanePosition{ 0.0, 0.0 }, { 0.5, 3.9 }, { 3.0, 2.0 }, { 2.0, 1.0 }, { 4.0, 4.0 } })
  {
    EXPECT_TRUE(shoe.Contains(point)) << point[0] << " " << point[1];
  }
  for (const PlanePosition& point :
    { PlanePosition{ 2.0, 1.01 }, { 2.0, 4.0 }, { -0.01, 1.0 }, { NaN, 1.0 }, { 1.0, NaN } })
  {
    EXPECT_FALSE(shoe.Contains(point)) << point[0] << " " << point[1];
  }
  EXPECT_FALSE(ObservationWindow().Contains({ NaN, 0.5 }));
  EXPECT_TRUE(ObservationWindow().Contains({ 1.0, 0.0 }));
  EXPECT_FALSE(ObservationWindow().Contains({ 1.001, 0.0 }));
}

TEST(ObservationWindow, MeasuresDistancesToTheEdge)
{
  const ObservationWindow box = ObservationWindow::Rectangle({ 0.0, 0.0 }, { 3.0, 2.0 });
  const ObservationWindow same = RectangleAsPolygon(3.0, 2.0);
  for (const PlanePosition& point :
    { PlanePosition{ 0.2, 1.0 }, { 2.9, 0.5 }, { 1.0, 0.1 }, { 1.0, 1.8 }, { 3.0, 1.0 } })
  {
    EXPECT_NEAR(box.DistanceToEdge(point), same.DistanceToEdge(point), 1e-14);
  }
  EXPECT_DOUBLE_EQ(box.DistanceToEdge({ 0.2, 1.0 }), 0.2);
  EXPECT_DOUBLE_EQ(Horseshoe().DistanceToEdge({ 0.5, 2.0 }), 0.5);
  EXPECT_NEAR(Horseshoe().DistanceToEdge({ 0.5, 0.5 }), 0.5, 1e-14);
  EXPECT_NEAR(Triangle(1.0).DistanceToEdge({ 0.3, 0.4 }), 0.3 / std::sqrt(2.0), 1e-14);
}

TEST(ObservationWindow, MeasuresCircles)
{
  const ObservationWindow box = ObservationWindow::Rectangle({ 0.0, 0.0 }, { 3.0, 2.0 });
  const ObservationWindow same = RectangleAsPolygon(3.0, 2.0);
  EXPECT_DOUBLE_EQ(box.CircleInside({ 1.5, 1.0 }, 0.9), 1.0);
  EXPECT_NEAR(box.CircleInside({ 0.0, 0.0 }, 1.0), 0.25, 1e-15);
  EXPECT_NEAR(box.CircleInside({ 0.0, 1.0 }, 0.5), 0.5, 1e-15);
  EXPECT_NEAR(box.CircleInside({ 1.5, 0.5 }, 1.0), 1.0 - std::acos(0.5) / Pi, 1e-15);
  EXPECT_EQ(box.CircleInside({ 1.5, 1.0 }, 4.0), 0.0);
  for (const PlanePosition& center : { PlanePosition{ 0.2, 0.3 }, { 1.4, 1.9 }, { 2.9, 0.05 }, { 1.5, 1.0 } })
  {
    for (const double radius : { 0.1, 0.5, 1.3, 2.1 })
    {
      EXPECT_NEAR(box.CircleInside(center, radius), SampledCircle(box, center, radius), 5e-5);
      EXPECT_NEAR(same.CircleInside(center, radius), box.CircleInside(center, radius), 1e-9);
      EXPECT_NEAR(Horseshoe().CircleInside(center, radius), SampledCircle(Horseshoe(), center, radius),
        1e-3); // samples close to the edge count
    }
  }
  EXPECT_NEAR(Triangle(1.0).CircleInside({ 0.0, 0.0 }, 0.8), SampledCircle(Triangle(1.0), { 0.0, 0.0 }, 0.8), 5e-5);
  EXPECT_EQ(Triangle(1.0).CircleInside({ 0.2, 0.2 }, 0.05), 1.0);
  EXPECT_EQ(Triangle(1.0).CircleInside({ 0.2, 0.2 }, 3.0), 0.0);
}

/// Two triangles with right angles have one in common.
double CommonTriangle(double leg, double dx, double dy)
{
  const double side = std::min(leg, leg + dx + dy) - std::max(0.0, dx) - std::max(0.0, dy);
  return side > 0.0 ? 0.5 * side * side : 0.0;
}

TEST(ObservationWindow, MeasuresWhatMovedWindowsHaveInCommon)
{
  const ObservationWindow box = ObservationWindow::Rectangle({ 1.0, 1.0 }, { 4.0, 3.0 });
  EXPECT_DOUBLE_EQ(box.CommonArea(-1.0, 0.5), 3.0);
  EXPECT_EQ(box.CommonArea(3.5, 0.0), 0.0);
  for (const double dx : { -1.2, -0.4, 0.0, 0.3, 0.9 })
  {
    for (const double dy : { -0.8, -0.1, 0.0, 0.5, 1.4 })
    {
      EXPECT_NEAR(Triangle(2.0).CommonArea(dx, dy), CommonTriangle(2.0, dx, dy), 2e-6);
      EXPECT_NEAR(RectangleAsPolygon(3.0, 2.0).CommonArea(dx, dy), box.CommonArea(dx, dy), 1e-12);
    }
  }
  // The arms of the horseshoe fall upon each other again.
  EXPECT_NEAR(Horseshoe().CommonArea(3.0, 0.0), 4.0, 1e-12);
}

TEST(CommonAreaTable, FollowsTheClosedForm)
{
  const CommonAreaTable triangle(Triangle(2.0), 0.7);
  const CommonAreaTable box(ObservationWindow::Rectangle({ 0.0, 0.0 }, { 3.0, 2.0 }), 0.7);
  const CommonAreaTable large(Triangle(2.0), 5.0); // larger than the window
  for (int n = 0; n < 1000; ++n)
  {
    const double r = 0.7 * n / 999.0;
    const double dx = r * std::cos(0.7 * n);
    const double dy = r * std::sin(0.7 * n);
    EXPECT_NEAR(triangle(dx, dy), CommonTriangle(2.0, dx, dy), 2.5e-3);
    EXPECT_DOUBLE_EQ(box(dx, dy), (3.0 - std::abs(dx)) * (2.0 - std::abs(dy)));
    EXPECT_NEAR(large(7.0 * dx, 7.0 * dy), CommonTriangle(2.0, 7.0 * dx, 7.0 * dy), 2e-2);
  }
}

std::string WhyPolygon(std::vector<PlanePosition> corners)
{
  return ObservationWindow::Polygon(std::move(corners)).WhyInvalid();
}

bool Has(const std::string& text, const char* words)
{
  return text.find(words) != std::string::npos;
}

TEST(ObservationWindow, RefusesBadPolygons)
{
  EXPECT_TRUE(Has(WhyPolygon({}), "0 corners"));
  EXPECT_TRUE(Has(WhyPolygon({ { 0, 0 }, { 1, 0 } }), "2 corners"));
  EXPECT_TRUE(Has(WhyPolygon({ { 0, 0 }, { 1, 0 }, { 1, 0 }, { 1, 1 } }), "one place"));
  EXPECT_TRUE(Has(WhyPolygon({ { 0, 0 }, { 1, 0 }, { NaN, 1 } }), "not finite"));
  EXPECT_TRUE(Has(WhyPolygon({ { 0, 0 }, { 1, 1 }, { 2, 2 } }), "no area"));
  EXPECT_TRUE(Has(WhyPolygon({ { 0, 0 }, { 2, 2 }, { 2, 0 }, { 0, 3 } }), "crosses"));                    // a bow tie
  EXPECT_TRUE(Has(WhyPolygon({ { 0, 0 }, { 2, 0 }, { 2, 2 }, { 1, 0 }, { 0, 2 } }), "touches"));          // at an edge
  EXPECT_TRUE(Has(WhyPolygon({ { 0, 0 }, { 2, 0 }, { 2, 2 }, { 2, 3 }, { 2, 1 }, { 0, 2 } }), "itself")); // folded
  EXPECT_TRUE(Has(ObservationWindow::Rectangle({ 0, 0 }, { 1, 0 }).WhyInvalid(), "one place"));
  EXPECT_EQ(WhyPolygon({ { 0, 0 }, { 1, 0 }, { 2, 0 }, { 2, 2 } }), ""); // a corner on a straight edge
  // The same far from the origin, as coordinates of a survey are.
  EXPECT_EQ(WhyPolygon({ { 500000, 5e6 }, { 500200, 5e6 }, { 500200, 5e6 + 100 }, { 500050, 5e6 + 30 } }), "");
}

TEST(ObservationWindow, RefusesBadPatterns)
{
  const ObservationWindow window;
  const std::vector<PlanePosition> points{ { 0.1, 0.1 }, { 0.2, 0.9 }, { 0.5, 0.5 }, { 0.7, 0.2 }, { 1.0, 1.0 } };
  EXPECT_EQ(WhyInvalid(points, window), "");
  std::vector<PlanePosition> bad(points.begin(), points.end() - 1);
  EXPECT_TRUE(Has(WhyInvalid(bad, window), "4 points"));
  bad = points;
  bad.push_back({ 0.5, 0.5 });
  EXPECT_TRUE(Has(WhyInvalid(bad, window), "Points 2 and 5 are at one place"));
  EXPECT_EQ(WhyInvalid(bad, window, 5, true), "");
  bad = points;
  bad[3] = { 0.7, 1.2 };
  EXPECT_TRUE(Has(WhyInvalid(bad, window), "Point 3"));
  bad[3] = { NaN, 0.2 };
  EXPECT_TRUE(Has(WhyInvalid(bad, window), "outside"));
}

}
