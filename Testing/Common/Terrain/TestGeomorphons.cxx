// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Geomorphons of planes, cones, folds and edges, whose lines of sight are known in closed form.
#include "../Drainage/RandomGround.h"
#include "../OnThreads.h"
#include "Numerics/Constants.h"
#include "Terrain/Geomorphons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace littoral;
using namespace littoral::testing;

namespace
{

constexpr int Side = 21;
constexpr int Middle = 10;

/// Form of the middle cell of square ground of 10 m cells; (x, y) are from there [m].
template <typename Function>
Geomorphon FormOfMiddle(const Function& heightAt, const GeomorphonSearch& search = {})
{
  const GridSamples ground = Ground(
    Side, Side, { 10.0, 10.0 }, [&](double x, double y) { return heightAt(x - 10.0 * Middle, y - 10.0 * Middle); });
  return GeomorphonsOf(ground, search)[Middle * Side + Middle];
}

}

TEST(Geomorphons, KnowConesFoldsAndPlanes)
{
  EXPECT_EQ(FormOfMiddle([](double x, double y) { return -0.5 * std::hypot(x, y); }), Geomorphon::Peak);
  EXPECT_EQ(FormOfMiddle([](double x, double y) { return 0.5 * std::hypot(x, y); }), Geomorphon::Pit);
  EXPECT_EQ(FormOfMiddle([](double, double y) { return -0.5 * std::abs(y); }), Geomorphon::Ridge);
  EXPECT_EQ(FormOfMiddle([](double x, double) { return 0.5 * std::abs(x); }), Geomorphon::Valley);
  EXPECT_EQ(FormOfMiddle([](double, double) { return 7.0; }), Geomorphon::Flat);
  EXPECT_EQ(FormOfMiddle([](double x, double y) { return 0.5 * x + 0.1 * y; }), Geomorphon::Slope);
  // a level shelf that ends here, above a slope and below one: three directions lower, three higher
  EXPECT_EQ(FormOfMiddle([](double x, double) { return 0.5 * std::min(x, 0.0); }), Geomorphon::Shoulder);
  EXPECT_EQ(FormOfMiddle([](double x, double) { return 0.5 * std::max(x, 0.0); }), Geomorphon::Footslope);
  // a blunt ridge that falls to the east: five directions lower, three higher
  EXPECT_EQ(FormOfMiddle([](double x, double y) { return -0.3 * x - 0.2 * std::abs(y); }), Geomorphon::Spur);
  EXPECT_EQ(FormOfMiddle([](double x, double y) { return 0.3 * x + 0.2 * std::abs(y); }), Geomorphon::Hollow);
}

TEST(Geomorphons, TurnOverWithTheGround)
{
  // ground upside down has pits for peaks, valleys for ridges, hollows for spurs, footslopes for shoulders
  const std::array<int, GeomorphonForms + 1> turned{ 0, 1, 10, 9, 8, 7, 6, 5, 4, 3, 2 };
  GridSamples ground = RandomGround(60, 50, { 20.0, 30.0 }, 3);
  const std::vector<Geomorphon> forms = GeomorphonsOf(ground, { 5, 2.0 });
  for (double& height : ground.Values)
  {
    height = -height;
  }
  const std::vector<Geomorphon> others = GeomorphonsOf(ground, { 5, 2.0 }, OnThreads(3));
  for (std::size_t n = 0; n < forms.size(); ++n)
  {
    EXPECT_EQ(static_cast<int>(others[n]), turned[static_cast<int>(forms[n])]);
  }
}

TEST(Geomorphons, SeeAsFarAsTheRadiusAndAboveTheFlatness)
{
  // walls 60 m to the east and to the west, 30 m high
  const auto walls = [](double x, double) { return std::abs(x) > 55.0 ? 30.0 : 0.0; };
  EXPECT_EQ(FormOfMiddle(walls, { 8, 1.0 }), Geomorphon::Flat); // two directions alone
  // the diagonal sees it at 84.9 m under 19.5 degrees, which is nearer than 90 m
  EXPECT_EQ(FormOfMiddle(walls, { 9, 1.0 }), Geomorphon::Valley);
  EXPECT_EQ(FormOfMiddle(walls, { 9, 19.4 }), Geomorphon::Valley);
  EXPECT_EQ(FormOfMiddle(walls, { 9, 19.6 }), Geomorphon::Flat);
  const auto ring = [](double x, double y) { return std::hypot(x, y) > 55.0 ? 30.0 : 0.0; };
  EXPECT_EQ(FormOfMiddle(ring, { 3, 1.0 }), Geomorphon::Flat);
  EXPECT_EQ(FormOfMiddle(ring, { 6, 1.0 }), Geomorphon::Footslope); // the four diagonals
  EXPECT_EQ(FormOfMiddle(ring, { 7, 1.0 }), Geomorphon::Pit);
  EXPECT_EQ(FormOfMiddle(ring, { 7, 26.6 }), Geomorphon::Footslope); // the diagonals see it under 27.9 degrees
  // on a plane a direction of slope s is level where atan(s) is below the flatness: diagonals have s / sqrt(2)
  const auto plane = [](double x, double) { return 0.1 * x; };
  const double diagonal = std::atan(0.1 / std::sqrt(2.0)) * 180.0 / Pi;
  EXPECT_EQ(FormOfMiddle(plane, { 3, diagonal - 0.01 }), Geomorphon::Slope);
  EXPECT_EQ(FormOfMiddle(plane, { 3, diagonal + 0.01 }), Geomorphon::Flat);
}

TEST(Geomorphons, LeaveOutTheBorderAndWhatIsMissing)
{
  GridSamples ground = Ground(9, 8, { 1.0, 1.0 }, [](double x, double y) { return -std::hypot(x - 4.0, y - 4.0); });
  ground.At(5, 4) = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Geomorphon> forms = GeomorphonsOf(ground, {});
  EXPECT_EQ(forms[4 * 9 + 5], Geomorphon::None);
  EXPECT_EQ(forms[4 * 9 + 4], Geomorphon::Peak);
  EXPECT_EQ(std::count(forms.begin(), forms.end(), Geomorphon::None), 9 * 8 - 7 * 6 + 1);
  const std::array<double, GeomorphonForms> shares = SharesOf(forms);
  EXPECT_DOUBLE_EQ(shares[1], 1.0 / 41.0);
  double sum = 0.0;
  for (const double share : shares)
  {
    sum += share;
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

TEST(Geomorphons, RefuseWhatIsNoSearch)
{
  EXPECT_EQ(WhyInvalid(GeomorphonSearch{}), "");
  EXPECT_NE(WhyInvalid(GeomorphonSearch{ 0, 1.0 }).find("SearchRadius"), std::string::npos);
  EXPECT_NE(WhyInvalid(GeomorphonSearch{ 3, 46.0 }).find("Flatness"), std::string::npos);
}
