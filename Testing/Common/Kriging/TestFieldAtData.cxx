// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../OnThreads.h"

#include "Kriging/FieldAtData.h"
#include "Kriging/Kriging.h"
#include "Numerics/Constants.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace littoral;

namespace
{

const PlaneGrid Grid{ { 100.0, -50.0 }, { 2.0, 3.0 } };
const GridWindow Window{ { 0, 0 }, { 30, 20 } };

TurningBandsParameters Parameters(CovarianceModel model, int seed, double shortest = 0.0)
{
  TurningBandsParameters parameters;
  parameters.Field.Model = model;
  parameters.Field.Variance = 9.0;
  parameters.Field.Range = model == CovarianceModel::Fractal ? 200.0 : 6.0;
  parameters.Field.FractalDimension = 2.5;
  parameters.AnisotropyRatio = 1.6;
  parameters.AnisotropyAngle = 0.5;
  parameters.MinimumWavelength = shortest;
  parameters.NumberOfHarmonics = 60;
  parameters.Seed = seed;
  return parameters;
}

struct Grown
{
  TurningBandsField Field;
  std::vector<float> Values;

  explicit Grown(const TurningBandsParameters& parameters)
    : Field(parameters, Grid, Window)
    , Values(31 * 21)
  {
    for (std::size_t line = 0; line < this->Field.GetNumberOfLines(); ++line)
    {
      this->Field.TabulateLine(line);
    }
    this->Field.FillRows(0, 20, 1.0, 0.0, this->Values.data());
  }
};

}

TEST(FieldAtData, IsTheGridsAtItsPoints)
{
  for (const double shortest : { 0.0, 8.0 })
  {
    const TurningBandsParameters parameters = Parameters(CovarianceModel::SimpleExponential, 3, shortest);
    const Grown grown(parameters);
    std::vector<KrigingPlace> places;
    for (const auto& [i, j] : { std::pair(0, 0), std::pair(30, 20), std::pair(7, 13) })
    {
      places.push_back({ 100.0 + 2.0 * i + 1e-7, -50.0 + 3.0 * j, 0.0 });
    }
    SnapToGrid(Grid, places);
    EXPECT_EQ(places[2].X, 114.0);
    std::vector<KrigingPlace> off{ { 114.0002, -11.0, 0.0 } };
    SnapToGrid(Grid, off);
    EXPECT_EQ(off[0].X, 114.0002); // not within a millionth of the spacing
    const std::vector<double> values = FieldAtData(grown.Field, parameters, Grid, Window, places);
    EXPECT_EQ(values[0], grown.Values[0]);
    EXPECT_EQ(values[1], grown.Values[20 * 31 + 30]);
    EXPECT_EQ(values[2], grown.Values[13 * 31 + 7]);
  }
}

TEST(FieldAtData, IsTheSumOfHarmonicsBetweenThem)
{
  // A field without short waves: lines carry all, at the points and between.
  const TurningBandsParameters parameters = Parameters(CovarianceModel::SimpleExponential, 3, 24.0);
  const Grown grown(parameters);
  const std::vector<KrigingPlace> places{ { 111.3, -33.1, 0.0 }, { 150.9, 1.7, 0.0 }, { 500.0, 900.0, 0.0 } };
  const std::vector<double> values =
    FieldAtData(grown.Field, parameters, Grid, Window, places, littoral::testing::OnThreads(2));
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    EXPECT_NEAR(values[n], grown.Field.ValueAt(places[n].X, places[n].Y), 0.02 * 3.0);
  }
  EXPECT_THROW(FieldAtData(grown.Field, parameters, Grid, Window, { { 1e12, 0.0, 0.0 } }), KrigingFailure);
}

TEST(FieldAtData, HasTheModelsCovariance)
{
  // Over many seeds: variances at two data between the points, their covariance, and that with the nearest point.
  for (const CovarianceModel model : { CovarianceModel::SimpleExponential, CovarianceModel::Fractal })
  {
    const std::vector<KrigingPlace> places{ { 120.7, -18.8, 0.0 }, { 121.6, -19.9, 0.0 } };
    const KrigingPlace point = PlaceOfPoint(Grid, 10, 10); // (120, -20)
    constexpr int seeds = 700;
    double a2 = 0.0, b2 = 0.0, ab = 0.0, ap = 0.0;
    for (int seed = 1; seed <= seeds; ++seed)
    {
      TurningBandsParameters parameters = Parameters(model, seed);
      parameters.NumberOfLines = 16;
      const Grown grown(parameters);
      const std::vector<double> v = FieldAtData(grown.Field, parameters, Grid, Window, places);
      const double p = grown.Values[10 * 31 + 10];
      a2 += v[0] * v[0];
      b2 += v[1] * v[1];
      ab += v[0] * v[1];
      ap += v[0] * p;
    }
    const TurningBandsParameters parameters = Parameters(model, 1);
    const auto covariance = [&](const KrigingPlace& p, const KrigingPlace& q) {
      const double x = p.X - q.X, y = p.Y - q.Y;
      const double c = std::cos(0.5), s = std::sin(0.5);
      return Covariance(parameters.Field, std::hypot(c * x + s * y, 1.6 * (c * y - s * x)));
    };
    // The standard error of a product's mean is at most sqrt(2) variance / sqrt(seeds), here 0.48.
    const double error = 9.0 * std::sqrt(2.0 / seeds);
    EXPECT_NEAR(a2 / seeds, 9.0, 3.0 * error);
    EXPECT_NEAR(b2 / seeds, 9.0, 3.0 * error);
    EXPECT_NEAR(ab / seeds, covariance(places[0], places[1]), 3.0 * error);
    EXPECT_NEAR(ap / seeds, covariance(places[0], point), 3.0 * error);
    // Semivariances, whose errors are their own: sqrt(2 / seeds) of each, 5.3 %.
    const double near = 0.5 * (a2 + b2) / seeds - ab / seeds;
    const double truth = 9.0 - covariance(places[0], places[1]);
    EXPECT_NEAR(near / truth, 1.0, 3.0 * std::sqrt(2.0 / seeds)) << static_cast<int>(model);
  }
}

// Beside a point of the grid a field has nearly the value there, whichever way its axes point: the difference has the
// variance 2 gamma(h).
TEST(FieldAtData, IsContinuousAtThePoints)
{
  for (const double angle : { 0.0, 0.5, 0.25 * Pi, 0.75 * Pi, 2.0 })
  {
    TurningBandsParameters parameters = Parameters(CovarianceModel::SimpleExponential, 7);
    parameters.AnisotropyAngle = angle;
    const Grown grown(parameters);
    std::vector<KrigingPlace> places;
    for (int n = 0; n < 60; ++n)
    {
      places.push_back(PlaceOfPoint(Grid, n % 31, n % 21));
      places.back().X += n % 31 == 30 ? -0.002 : 0.002;
    }
    const std::vector<double> values = FieldAtData(grown.Field, parameters, Grid, Window, places);
    double squares = 0.0;
    for (int n = 0; n < 60; ++n)
    {
      squares += std::pow(values[n] - grown.Values[(n % 21) * 31 + n % 31], 2);
    }
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double variance = 2.0 * (9.0 - Covariance(parameters.Field, 0.002 * std::hypot(c, 1.6 * s)));
    EXPECT_NEAR(squares / 60.0, variance, 4.0 * variance * std::sqrt(2.0 / 60.0)) << angle;
  }
}

// So have data that are beside each other between the points.
TEST(FieldAtData, IsContinuousBetweenThePoints)
{
  const TurningBandsParameters parameters = Parameters(CovarianceModel::SimpleExponential, 7);
  const Grown grown(parameters);
  std::vector<KrigingPlace> places;
  for (int n = 0; n < 60; ++n)
  {
    places.push_back(PlaceOfPoint(Grid, (n / 2) % 30, (n / 2) % 20));
    places.back().X += n % 2 == 0 ? 1.0 : 1.002;
    places.back().Y += 1.5;
  }
  const std::vector<double> values = FieldAtData(grown.Field, parameters, Grid, Window, places);
  double squares = 0.0;
  for (int n = 0; n < 60; n += 2)
  {
    squares += std::pow(values[n] - values[n + 1], 2);
  }
  const double variance =
    2.0 * (9.0 - Covariance(parameters.Field, 0.002 * std::hypot(std::cos(0.5), 1.6 * std::sin(0.5))));
  EXPECT_NEAR(squares / 30.0, variance, 4.0 * variance * std::sqrt(2.0 / 30.0));
}
