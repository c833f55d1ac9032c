// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/Constants.h"
#include "Terrain/TurningBands.h"
#include "Terrain/VariogramFit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace littoral;

namespace
{

/// Bins that hold a model's own semivariances.
std::vector<LagBin> ExactBins(const VariogramFit& truth, int directions)
{
  std::vector<LagBin> bins;
  for (int direction = 0; direction < directions; ++direction)
  {
    for (int n = 1; n <= 40; ++n)
    {
      const double angle = Pi * direction / directions;
      LagBin bin;
      bin.Lag = 0.1 * n * n;
      bin.Separation = { bin.Lag * std::cos(angle), bin.Lag * std::sin(angle) };
      bin.Semivariance = Semivariance(truth, bin.Separation[0], bin.Separation[1]);
      bin.Pairs = 1000.0 * n;
      bin.Direction = direction;
      bins.push_back(bin);
    }
  }
  return bins;
}

VariogramFit Truth(int model)
{
  VariogramFit truth;
  truth.Field.Model = static_cast<CovarianceModel>(model);
  truth.Field.Variance = 3.7;
  const CovarianceTraits& traits = TraitsOf(truth.Field.Model);
  truth.Field.Range = traits.LowestWaveNumber ? 700.0 : traits.RangeScale > 1.0 ? 45.0 : 10.0;
  truth.Field.SecondRange = 1.5;
  truth.Field.FractalDimension = 2.35;
  return truth;
}

VariogramFitOptions Options()
{
  VariogramFitOptions options;
  options.MaximumRange = 400.0;
  options.FractalRange = 700.0;
  return options;
}

GridSamples Grow(TurningBandsParameters parameters, int size)
{
  GridWindow window;
  window.Last = { size - 1, size - 1 };
  TurningBandsField field(parameters, PlaneGrid{}, window);
  for (std::size_t line = 0; line < field.GetNumberOfLines(); ++line)
  {
    field.TabulateLine(line);
  }
  std::vector<float> values(static_cast<std::size_t>(size) * size);
  field.FillRows(0, size - 1, 1.0, 0.0, values.data());
  GridSamples samples;
  samples.Width = samples.Height = size;
  samples.Values.assign(values.begin(), values.end());
  return samples;
}

std::vector<VariogramFit> FitGrown(const GridSamples& samples, bool anisotropy)
{
  const double maximumLag = 0.5 * samples.Width;
  const VariogramMap map = ComputeVariogramMap(samples, maximumLag);
  VariogramFitOptions options;
  options.Anisotropy = anisotropy;
  options.MaximumRange = 0.5 * maximumLag;
  options.FractalRange = 4.0 * samples.Width;
  return FitAllModels(BinVariogram(map, maximumLag, 40, anisotropy ? 12 : 1), options);
}

class EveryModel : public testing::TestWithParam<int>
{
};

}

// The starts lie all over the lags, so that most of them are poor.
TEST_P(EveryModel, ExactVariogramIsRefitted)
{
  const VariogramFit truth = Truth(GetParam());
  const VariogramFit fit = FitVariogram(truth.Field.Model, ExactBins(truth, 1), Options());
  EXPECT_TRUE(fit.Converged);
  EXPECT_NEAR(fit.Field.Variance, truth.Field.Variance, 1e-6 * truth.Field.Variance);
  EXPECT_NEAR(fit.Field.Range, truth.Field.Range, 1e-6 * truth.Field.Range);
  if (TraitsOf(truth.Field.Model).Parameters.Has("SecondRange"))
  {
    EXPECT_NEAR(fit.Field.SecondRange, truth.Field.SecondRange, 1e-6 * truth.Field.SecondRange);
  }
  if (TraitsOf(truth.Field.Model).Parameters.Has("FractalDimension"))
  {
    EXPECT_NEAR(fit.Field.FractalDimension, truth.Field.FractalDimension, 1e-6);
  }
}

TEST_P(EveryModel, ExactVariogramWithNuggetIsRefitted)
{
  VariogramFit truth = Truth(GetParam());
  truth.Nugget = 0.6;
  VariogramFitOptions options = Options();
  options.Nugget = true;
  const VariogramFit fit = FitVariogram(truth.Field.Model, ExactBins(truth, 1), options);
  EXPECT_NEAR(fit.Nugget, truth.Nugget, 1e-5);
  EXPECT_NEAR(fit.Field.Variance, truth.Field.Variance, 1e-5 * truth.Field.Variance);
}

TEST_P(EveryModel, ExactEllipseIsRefitted)
{
  VariogramFit truth = Truth(GetParam());
  truth.AnisotropyRatio = 4.0;
  truth.AnisotropyAngle = Pi / 6.0;
  VariogramFitOptions options = Options();
  options.Anisotropy = true;
  const VariogramFit fit = FitVariogram(truth.Field.Model, ExactBins(truth, 6), options);
  EXPECT_NEAR(fit.AnisotropyRatio, 4.0, 1e-5);
  EXPECT_NEAR(fit.AnisotropyAngle, Pi / 6.0, 1e-5);
}

TEST_P(EveryModel, ExactVariogramPicksItsModel)
{
  const std::vector<VariogramFit> fits = FitAllModels(ExactBins(Truth(GetParam()), 1), Options());
  ASSERT_EQ(static_cast<int>(fits.size()), NumberOfCovarianceModels);
  EXPECT_EQ(static_cast<int>(fits[0].Field.Model), GetParam());
  for (std::size_t i = 1; i < fits.size(); ++i)
  {
    EXPECT_LE(fits[i - 1].AtBound, fits[i].AtBound);
    EXPECT_TRUE(fits[i - 1].AICc <= fits[i].AICc || fits[i].AtBound > fits[i - 1].AtBound);
  }
}

INSTANTIATE_TEST_SUITE_P(VariogramFit, EveryModel, testing::Range(0, NumberOfCovarianceModels),
  [](const auto& one) { return CovarianceModelName(static_cast<CovarianceModel>(one.param)); });

TEST(VariogramFit, GrownFieldsGiveBackModelAndParameters)
{
  for (CovarianceModel model :
    { CovarianceModel::SimpleExponential, CovarianceModel::DoubleExponential, CovarianceModel::Spherical })
  {
    for (int seed = 1; seed <= 4; ++seed)
    {
      TurningBandsParameters parameters;
      parameters.Field.Model = model;
      parameters.Field.Range = model == CovarianceModel::Spherical ? 40.0 : 10.0;
      parameters.Seed = seed;
      const std::vector<VariogramFit> fits = FitGrown(Grow(parameters, 512), false);
      EXPECT_EQ(fits[0].Field.Model, model) << CovarianceModelName(model) << " seed " << seed;
      EXPECT_NEAR(fits[0].Field.Variance, 1.0, 0.2);
      EXPECT_NEAR(fits[0].Field.Range / parameters.Field.Range, 1.0, 0.2);
    }
  }
}

TEST(VariogramFit, GrownEllipseIsFound)
{
  for (int seed = 1; seed <= 3; ++seed)
  {
    TurningBandsParameters parameters;
    parameters.Field.Range = 40.0;
    parameters.AnisotropyRatio = 4.0;
    parameters.AnisotropyAngle = Pi / 6.0;
    parameters.Seed = seed;
    const VariogramFit best = FitGrown(Grow(parameters, 512), true)[0];
    EXPECT_NEAR(best.AnisotropyRatio, 4.0, 0.12 * 4.0) << "seed " << seed;
    EXPECT_NEAR(best.AnisotropyAngle, Pi / 6.0, 3.0 * Pi / 180.0) << "seed " << seed;
  }
}

TEST(VariogramFit, BoundsAreMarkedAndRankedLast)
{
  // An exponential variogram of 10 m against bounds on both sides of it; a sharp parabola has no dimension but 2.
  const VariogramFit truth = Truth(1);
  VariogramFitOptions options = Options();
  EXPECT_FALSE(FitVariogram(truth.Field.Model, ExactBins(truth, 1), options).AtBound);
  options.MaximumRange = 8.0;
  const std::vector<VariogramFit> fits = FitAllModels(ExactBins(truth, 1), options);
  const auto isTruth = [&](const VariogramFit& fit) { return fit.Field.Model == truth.Field.Model; };
  const auto held = std::find_if(fits.begin(), fits.end(), isTruth);
  ASSERT_NE(held, fits.end());
  EXPECT_TRUE(held->AtBound);
  EXPECT_FALSE(fits.front().AtBound);
  EXPECT_LT(held->AICc, fits.front().AICc) << "the best is the one that the bound makes wrong";
  EXPECT_TRUE(std::is_sorted(
    fits.begin(), fits.end(), [](const VariogramFit& a, const VariogramFit& b) { return a.AtBound < b.AtBound; }));

  VariogramFit smooth = Truth(2);
  smooth.Field.Range = 5000.0;
  const VariogramFit fractal = FitVariogram(CovarianceModel::Fractal, ExactBins(smooth, 1), Options());
  EXPECT_TRUE(fractal.AtBound);
  EXPECT_GE(fractal.Field.FractalDimension, 2.0);
  VariogramFit noise = Truth(1);
  noise.Field.Range = 0.005; // the shortest lag is 0.1
  EXPECT_TRUE(FitVariogram(CovarianceModel::SimpleExponential, ExactBins(noise, 1), Options()).AtBound);
  EXPECT_TRUE(FitVariogram(CovarianceModel::Fractal, ExactBins(noise, 1), Options()).AtBound);
}

namespace
{

/// The best fit of a grown field with white noise of a part of its variance, drawn by the standard library.
VariogramFit FitNoisy(CovarianceModel model, int size, double noise, int seed)
{
  TurningBandsParameters parameters;
  parameters.Field.Model = model;
  parameters.Field.Range = 12.0;
  parameters.Seed = seed;
  GridSamples samples = Grow(parameters, size);
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  for (double& value : samples.Values)
  {
    value += std::sqrt(noise) * normal(engine);
  }
  const double half = 0.5 * size;
  VariogramFitOptions options;
  options.Nugget = true;
  options.MaximumRange = half;
  options.FractalRange = 4.0 * size;
  return FitAllModels(BinVariogram(ComputeVariogramMap(samples, half), half, 40, 1), options).front();
}

}

// Of smooth fields the noise is found. That of rough ones is fitted by another rough model too, with twice as much.
TEST(VariogramFit, NuggetIsThereWhereNoiseIs)
{
  for (const double noise : { 0.0, 0.05 })
  {
    for (int seed = 1; seed <= 3; ++seed)
    {
      const VariogramFit best = FitNoisy(CovarianceModel::DoubleExponential, 256, noise, seed);
      EXPECT_EQ(best.Field.Model, CovarianceModel::DoubleExponential) << "noise " << noise << " seed " << seed;
      EXPECT_NEAR(best.Nugget, noise, 0.003);
      EXPECT_EQ(best.Nugget > 0.0, noise > 0.0);
    }
  }
  for (int seed = 1; seed <= 6; ++seed)
  {
    const VariogramFit best = FitNoisy(CovarianceModel::SimpleExponential, 128, 0.05, seed);
    const bool isTheirs = best.Field.Model == CovarianceModel::SimpleExponential;
    EXPECT_NEAR(best.Nugget, isTheirs ? 0.05 : 0.1, isTheirs ? 0.014 : 0.016) << "seed " << seed;
  }
}

TEST(VariogramFit, TooFewLagsFitNothing)
{
  const std::vector<LagBin> bins(3, LagBin{ 1.0, { 1.0, 0.0 }, 1.0, 10.0, 0, 0 });
  EXPECT_TRUE(std::isinf(FitVariogram(CovarianceModel::Bessel1, bins).AICc));
}
