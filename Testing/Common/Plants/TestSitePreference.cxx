// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/Constants.h"
#include "Numerics/InvalidInput.h"
#include "Plants/SiteGround.h"
#include "Plants/SitePreference.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

using namespace littoral;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr int Classes = 10;

std::vector<SpeciesPreference> Read(const char* text)
{
  return ReadPreferences(ReadTable(text));
}

std::string WhyNot(const char* text)
{
  return WhyRefused([&] { Read(text); });
}

/// The value of a factor in the middle of a class.
GroundFactors GroundOf(GroundFactor factor, int group, double low, double high)
{
  GroundFactors ground{ 100.0, 0.5, 20.0, 180.0, 6.0 };
  ground[static_cast<int>(factor)] = low + (high - low) * (group + 0.5) / Classes;
  return ground;
}

/// Whether p-values are uniform: the largest deviation of their distribution (Kolmogorov), critical at 0.1 %.
bool AreUniform(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const auto count = static_cast<double>(values.size());
  double worst = 0.0;
  for (std::size_t index = 0; index < values.size(); ++index)
  {
    const auto before = static_cast<double>(index);
    worst = std::max({ worst, values[index] - before / count, (before + 1.0) / count - values[index] });
  }
  return worst < 1.95 / std::sqrt(count);
}

}

TEST(SitePreference, CountsByClassFollowThePreferences)
{
  // Two species and bare ground in ten classes of a factor: chi-squared of the counts against a_s p_s / (a_1 + a_2).
  const auto species = Read("species,abundance,elevation,elevation_tolerance,slope,slope_tolerance,aspect,"
                            "aspect_tolerance,wetness,wetness_tolerance\n"
                            "high,2,140,40,,,200,60,,\nlow,1,60,50,10,20,,,7,2\n");
  const struct
  {
    GroundFactor Factor;
    double Low;
    double High;
  } factors[] = { { GroundFactor::Elevation, 0.0, 200.0 }, { GroundFactor::Slope, 0.0, 40.0 },
    { GroundFactor::Aspect, 0.0, 360.0 }, { GroundFactor::Wetness, 3.0, 12.0 } };
  constexpr int sites = 4000;
  for (const auto& [factor, low, high] : factors)
  {
    std::vector<double> values;
    for (int seed = 1; seed <= 200; ++seed)
    {
      double chi = 0.0;
      for (int group = 0; group < Classes; ++group)
      {
        const GroundFactors ground = GroundOf(factor, group, low, high);
        double counts[3] = { 0.0, 0.0, 0.0 };
        for (int site = group; site < sites; site += Classes)
        {
          const int found = SpeciesAt(species, ground, { true, seed }, site);
          counts[found < 0 ? 2 : found] += 1.0;
        }
        const double shares[2] = { 2.0 / 3.0 * PreferenceFor(species[0], ground),
          1.0 / 3.0 * PreferenceFor(species[1], ground) };
        const double wanted[3] = { shares[0], shares[1], 1.0 - shares[0] - shares[1] };
        for (int kind = 0; kind < 3; ++kind)
        {
          const double expected = wanted[kind] * sites / Classes;
          chi += std::pow(counts[kind] - expected, 2) / expected;
        }
      }
      const boost::math::chi_squared law(2.0 * Classes);
      values.push_back(boost::math::cdf(boost::math::complement(law, chi)));
    }
    EXPECT_TRUE(AreUniform(values)) << static_cast<int>(factor);
  }
}

TEST(SitePreference, ResponsesAreGaussian)
{
  const auto species =
    Read("species,elevation,elevation_tolerance,aspect,aspect_tolerance\nfir,500,100,10,30\n").front();
  EXPECT_DOUBLE_EQ(PreferenceFor(species, { 500.0, 0.5, 20.0, 10.0, NaN }), 1.0);
  EXPECT_NEAR(PreferenceFor(species, { 600.0, 0.5, 20.0, 10.0, NaN }), std::exp(-0.5), 1e-15);
  // Aspects are apart the short way round, and count in part on nearly level ground.
  EXPECT_NEAR(PreferenceFor(species, { 500.0, 0.5, 20.0, 340.0, NaN }), std::exp(-0.5), 1e-12);
  EXPECT_DOUBLE_EQ(PreferenceFor(species, { 500.0, 0.5, 0.0, 190.0, NaN }), 1.0);
  EXPECT_NEAR(PreferenceFor(species, { 500.0, 0.5, 2.5, 340.0, NaN }), 0.5 + 0.5 * std::exp(-0.5), 1e-12);
}

TEST(SitePreference, KeepsAllSitesWhereAsked)
{
  const auto species = Read("species,elevation,elevation_tolerance\na,0,100\nb,200,100\n");
  const GroundFactors ground{ 80.0, 0.5, 0.0, 0.0, NaN };
  int first = 0;
  constexpr int sites = 20000;
  for (int site = 0; site < sites; ++site)
  {
    const int found = SpeciesAt(species, ground, { false, 3 }, site);
    ASSERT_GE(found, 0);
    first += found == 0;
    EXPECT_TRUE(StaysAt(species[0], ground, { false, 3 }, site));
  }
  const double a = std::exp(-0.5 * 0.64);
  const double share = a / (a + std::exp(-0.5 * 1.44));
  EXPECT_NEAR(static_cast<double>(first) / sites, share, 4.0 * std::sqrt(share * (1.0 - share) / sites));
  int stays = 0;
  for (int site = 0; site < sites; ++site)
  {
    stays += StaysAt(species[0], ground, { true, 3 }, site);
  }
  EXPECT_NEAR(static_cast<double>(stays) / sites, a, 4.0 * std::sqrt(a * (1.0 - a) / sites));
}

TEST(SitePreference, AspectOfAPlane)
{
  // z = 0.3 x + 0.4 y faces south-west: 180 + atan(3 / 4) degrees, of slope atan(0.5).
  HeightGrid plane;
  plane.Count[0] = plane.Count[1] = 5;
  plane.Spacing[0] = plane.Spacing[1] = 2.0;
  plane.HeightOf = [](long long point) {
    return 0.6 * static_cast<double>(point % 5) + 0.8 * static_cast<double>(point / 5);
  };
  const GroundPoint ground = plane.At(3.3, 4.1);
  EXPECT_NEAR(ground.Gradient[0], 0.3, 1e-12);
  EXPECT_NEAR(ground.Gradient[1], 0.4, 1e-12);
  EXPECT_NEAR(AspectOf(ground), 180.0 + 180.0 / Pi * std::atan(0.75), 1e-9);
  EXPECT_NEAR(std::tan(ground.Slope), 0.5, 1e-12);
  EXPECT_EQ(plane.Nearest(3.3, 4.1), 2 * 5 + 2);
  EXPECT_EQ(plane.Nearest(8.4, -0.4), 4);
  EXPECT_EQ(AspectOf(GroundPoint()), 0.0);
}

TEST(SitePreference, OneMessageEach)
{
  const auto says = [](const std::string& reason, const char* words) {
    EXPECT_NE(reason.find(words), std::string::npos) << reason;
  };
  says(WhyNot("kind\noak\n"), "needs the column species");
  says(WhyNot("species\n"), "needs the column species");
  says(WhyNot("species,abundance\noak,-1\n"), "abundance of oak is -1");
  says(WhyNot("species,abundance\noak,0\n"), "the abundance of all species is 0");
  says(WhyNot("species,slope,slope_tolerance\noak,10,0\n"), "slope_tolerance of oak is 0");
  says(WhyNot("species,slope\noak,10\n"), "slope_tolerance of oak is nan");
  says(WhyNot("species,slope,slope_tolerance\noak,steep,3\n"), "slope of row 1 is 'steep'");
  EXPECT_TRUE(AnyResponds(DefaultPreferences(), GroundFactor::Slope));
  EXPECT_FALSE(AnyResponds(DefaultPreferences(), GroundFactor::Wetness));
  EXPECT_TRUE(AnyResponds(DefaultPreferences(true), GroundFactor::Wetness));
}

// A plane that rises by 1 m in 4 m to the north-east, with a hole.
TEST(SiteGround, FactorsOfAPlane)
{
  HeightGrid grid;
  grid.Spacing[0] = grid.Spacing[1] = 2.0;
  grid.Count[0] = 6;
  grid.Count[1] = 5;
  grid.HeightOf = [](long long point) {
    return point == 29 ? NaN : 100.0 + 0.5 * static_cast<double>(point % 6) + 0.5 * static_cast<double>(point / 6);
  };
  const SiteGround ground(grid);
  EXPECT_FALSE(ground.HasWetness());
  const std::optional<GroundFactors> factors = ground.At(3.0, 4.6);
  ASSERT_TRUE(factors);
  EXPECT_NEAR((*factors)[0], 101.9, 1e-12);
  EXPECT_NEAR((*factors)[1], 1.9 / 4.0, 1e-12); // the highest point is at 104 m
  EXPECT_NEAR((*factors)[2], 180.0 / Pi * std::atan(std::sqrt(0.125)), 1e-12);
  EXPECT_NEAR((*factors)[3], 225.0, 1e-9);
  EXPECT_TRUE(std::isnan((*factors)[4]));
  EXPECT_FALSE(ground.At(9.5, 7.5)); // beside the hole
  EXPECT_FALSE(ground.At(-0.1, 3.0));
}

TEST(SiteGround, WetnessIsThatOfTheNearestPoint)
{
  HeightGrid grid;
  grid.Count[0] = grid.Count[1] = 3;
  grid.HeightOf = [](long long) { return 7.0; };
  const SiteGround ground(grid, [](long long point, double slope) {
    EXPECT_EQ(slope, 0.0);
    return point == 0 ? -std::numeric_limits<double>::infinity() : static_cast<double>(point);
  });
  EXPECT_TRUE(ground.HasWetness());
  const std::optional<GroundFactors> factors = ground.At(1.6, 1.4);
  ASSERT_TRUE(factors);
  EXPECT_EQ((*factors)[4], 5.0);
  EXPECT_EQ((*factors)[1], 0.5); // level ground
  EXPECT_FALSE(ground.At(0.2, 0.2));
}
