// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../OnThreads.h"

#include "Kriging/DataVariogram.h"
#include "Kriging/Kriging.h"
#include "Numerics/RandomStream.h"
#include "Terrain/ReducedDistance.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace littoral;

namespace
{

/// Data at random places of a rectangle of 100 x 60 m, with values that mean nothing.
KrigingData SomeData(std::size_t count, bool withErrors, int seed = 5)
{
  const RandomStream random(seed, RandomPurpose::QuadratPositions);
  KrigingData data;
  for (std::size_t n = 0; n < count; ++n)
  {
    const auto place = random.UniformPair(n, 0);
    const auto value = random.NormalPair(n, 1);
    data.Places.push_back({ 100.0 * place[0], 60.0 * place[1], 7.0 + 3.0 * value[1] });
    data.Values.push_back(20.0 + 2.0 * value[0]);
    if (withErrors)
    {
      data.ErrorVariances.push_back(n % 3 == 0 ? 0.0 : 0.1 * static_cast<double>(n % 5));
    }
  }
  return data;
}

KrigingModel ModelOf(CovarianceModel kind, double nugget = 0.0, double ratio = 1.0)
{
  KrigingModel model;
  model.Field.Model = kind;
  model.Field.Variance = 4.0;
  model.Field.Range = kind == CovarianceModel::Fractal ? 300.0
    : kind == CovarianceModel::DoubleExponential       ? 8.0
                                                       : 25.0;
  model.Field.SecondRange = 4.0;
  model.Field.FractalDimension = 2.4;
  model.Nugget = nugget;
  model.AnisotropyRatio = ratio;
  model.AnisotropyAngle = 0.4;
  return model;
}

KrigingOptions OptionsOf(KrigingType type, std::size_t neighbors = 0)
{
  KrigingOptions options;
  options.Type = type;
  options.Neighbors = neighbors;
  options.Low = { -20.0, -20.0, 0.0 };
  options.High = { 120.0, 80.0, 0.0 };
  return options;
}

Eigen::VectorXd Functions(KrigingType type, const KrigingPlace& p)
{
  std::vector<double> f;
  switch (type)
  {
    case KrigingType::Simple:
      break;
    case KrigingType::Ordinary:
      f = { 1.0 };
      break;
    case KrigingType::LinearDrift:
      f = { 1.0, p.X, p.Y };
      break;
    case KrigingType::QuadraticDrift:
      f = { 1.0, p.X, p.Y, p.X * p.X, p.X * p.Y, p.Y * p.Y };
      break;
    case KrigingType::ExternalDrift:
      f = { 1.0, p.External };
      break;
  }
  return Eigen::Map<Eigen::VectorXd>(f.data(), static_cast<Eigen::Index>(f.size()));
}

/// The kriging system with Lagrange factors, written down from the models' own covariances and solved as a whole.
LeaveOneOutEstimate Dense(const KrigingModel& model, const KrigingData& data, KrigingType type,
  const KrigingPlace& target, long long without = -1)
{
  std::vector<std::size_t> used;
  for (std::size_t n = 0; n < data.Places.size(); ++n)
  {
    if (static_cast<long long>(n) != without)
    {
      used.push_back(n);
    }
  }
  const ReducedDistance distance(model.AnisotropyRatio, model.AnisotropyAngle);
  const auto covariance = [&](const KrigingPlace& a, const KrigingPlace& b) {
    return Covariance(model.Field, distance(a.X - b.X, a.Y - b.Y));
  };
  const Eigen::VectorXd f = Functions(type, target);
  const auto count = static_cast<Eigen::Index>(used.size());
  const Eigen::Index all = count + f.size();
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(all, all);
  Eigen::VectorXd right(all);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const KrigingPlace& p = data.Places[used[i]];
    for (Eigen::Index j = 0; j < count; ++j)
    {
      system(i, j) = covariance(p, data.Places[used[j]]);
    }
    system(i, i) += model.Nugget + data.ErrorVariance(used[i]);
    right(i) = covariance(p, target);
    const Eigen::VectorXd at = Functions(type, p);
    system.block(i, count, 1, f.size()) = at.transpose();
    system.block(count, i, f.size(), 1) = at;
  }
  right.tail(f.size()) = f;
  const Eigen::VectorXd weights = system.fullPivLu().solve(right);
  LeaveOneOutEstimate found{ 0.0, model.Field.Variance - weights.dot(right) };
  for (Eigen::Index i = 0; i < count; ++i)
  {
    found.Estimate += weights(i) * data.Values[used[i]];
  }
  return found;
}

const std::vector<KrigingPlace> Targets{ { 10.0, 20.0, 5.0 }, { 99.0, 1.0, 9.0 }, { -15.0, 70.0, 6.0 },
  { 50.3, 30.1, 4.0 } };

std::string FailureOf(const KrigingModel& model, const KrigingData& data, const KrigingOptions& options)
{
  try
  {
    const Kriging kriging(model, data, options);
    double estimate;
    kriging.Estimate(Targets.data(), 1, &estimate);
    return "";
  }
  catch (const KrigingFailure& failure)
  {
    return failure.what();
  }
}

}

TEST(Kriging, SolvesTheSystemOfEveryModel)
{
  for (int kind = 0; kind < NumberOfCovarianceModels; ++kind)
  {
    for (int type = 0; type < NumberOfKrigingTypes; ++type)
    {
      const KrigingModel model = ModelOf(static_cast<CovarianceModel>(kind), kind % 2 ? 0.3 : 0.0, 2.5);
      const KrigingData data = SomeData(40, kind % 3 == 0);
      const auto kriged = static_cast<KrigingType>(type);
      const Kriging kriging(model, data, OptionsOf(kriged));
      std::vector<double> estimates(Targets.size());
      std::vector<double> variances(Targets.size());
      kriging.Estimate(Targets.data(), Targets.size(), estimates.data(), variances.data());
      for (std::size_t n = 0; n < Targets.size(); ++n)
      {
        const LeaveOneOutEstimate truth = Dense(model, data, kriged, Targets[n]);
        EXPECT_NEAR(estimates[n], truth.Estimate, 3e-6) << kind << " " << type << " " << n;
        EXPECT_NEAR(variances[n], truth.Variance, 3e-6 * std::max(1.0, truth.Variance)) << kind << " " << type;
      }
    }
  }
}

TEST(Kriging, MeetsExactData)
{
  for (const std::size_t neighbors : { 0, 12 })
  {
    for (int kind = 0; kind < NumberOfCovarianceModels; ++kind)
    {
      const KrigingModel model = ModelOf(static_cast<CovarianceModel>(kind), 0.0, 1.5);
      const KrigingData data = SomeData(200, false);
      const Kriging kriging(model, data, OptionsOf(KrigingType::LinearDrift, neighbors));
      std::vector<double> estimates(200);
      std::vector<double> variances(200);
      kriging.Estimate(data.Places.data(), 200, estimates.data(), variances.data());
      for (std::size_t n = 0; n < 200; ++n)
      {
        EXPECT_NEAR(estimates[n], data.Values[n], 1e-9 * 2.0) << kind << " " << neighbors;
        EXPECT_NEAR(variances[n], 0.0, 1e-9) << kind << " " << neighbors;
        EXPECT_GE(variances[n], 0.0) << kind << " " << neighbors;
      }
    }
  }
}

TEST(Kriging, NoVarianceIsNegative)
{
  const KrigingData data = SomeData(80, false);
  for (const std::size_t neighbors : { 0, 12 })
  {
    for (int kind = 0; kind < NumberOfCovarianceModels; ++kind)
    {
      const KrigingModel model = ModelOf(static_cast<CovarianceModel>(kind));
      const Kriging kriging(model, data, OptionsOf(KrigingType::Simple, neighbors));
      std::vector<double> estimates(80);
      std::vector<double> variances(80);
      kriging.Estimate(data.Places.data(), 80, estimates.data(), variances.data());
      EXPECT_GE(*std::min_element(variances.begin(), variances.end()), 0.0) << kind << " " << neighbors;
    }
  }
}

TEST(Kriging, OfOneDatum)
{
  KrigingData data;
  data.Places = { { 3.0, 4.0, 0.0 } };
  data.Values = { 7.0 };
  const KrigingModel model = ModelOf(CovarianceModel::SimpleExponential);
  const KrigingPlace origin;
  const double c = 4.0 * std::exp(-ReducedDistance(1.0, 0.0)(3.0, 4.0) / 25.0);
  double estimate;
  double variance;
  // z* = z C(r) / C(0), variance C(0) - C(r)^2 / C(0); with an unknown mean z* = z, variance 2 (C(0) - C(r))
  Kriging(model, data, OptionsOf(KrigingType::Simple)).Estimate(&origin, 1, &estimate, &variance);
  EXPECT_NEAR(estimate, 7.0 * c / 4.0, 1e-8);
  EXPECT_NEAR(variance, 4.0 - c * c / 4.0, 1e-8);
  const Kriging ordinary(model, data, OptionsOf(KrigingType::Ordinary));
  ordinary.Estimate(&origin, 1, &estimate, &variance);
  EXPECT_NEAR(estimate, 7.0, 1e-9);
  EXPECT_NEAR(variance, 2.0 * (4.0 - c), 1e-8);
  EXPECT_TRUE(std::isnan(ordinary.LeaveOneOut()[0].Estimate));
}

TEST(Kriging, LeavesOneOut)
{
  for (int type = 0; type < NumberOfKrigingTypes; ++type)
  {
    const auto kriged = static_cast<KrigingType>(type);
    const KrigingModel model = ModelOf(CovarianceModel::Bessel1, 0.1, 2.0);
    const KrigingData data = SomeData(70, true);
    const std::vector<LeaveOneOutEstimate> closed =
      Kriging(model, data, OptionsOf(kriged)).LeaveOneOut(littoral::testing::OnThreads(3));
    for (std::size_t n = 0; n < data.Places.size(); ++n)
    {
      const LeaveOneOutEstimate truth = Dense(model, data, kriged, data.Places[n], static_cast<long long>(n));
      EXPECT_NEAR(closed[n].Estimate, truth.Estimate, 1e-6) << type;
      EXPECT_NEAR(closed[n].Variance, truth.Variance + 0.1 + data.ErrorVariances[n], 1e-6) << type;
    }
  }
}

// Without the only datum beside a line no plane is determined; without another one it is.
TEST(Kriging, LeavesOutNoDatumThatTheDriftNeeds)
{
  KrigingData data;
  data.Places = { { 0.0, 5.0, 0.0 }, { 10.0, 5.0, 0.0 }, { 20.0, 5.0, 0.0 }, { 7.0, 9.0, 0.0 } };
  data.Values = { 1.0, 3.0, 2.0, 4.0 };
  const Kriging kriging(ModelOf(CovarianceModel::SimpleExponential), data, OptionsOf(KrigingType::LinearDrift));
  const std::vector<LeaveOneOutEstimate> left = kriging.LeaveOneOut();
  for (int n = 0; n < 3; ++n)
  {
    EXPECT_TRUE(std::isfinite(left[n].Estimate) && left[n].Variance > 0.0) << n;
  }
  EXPECT_TRUE(std::isnan(left[3].Estimate) && std::isnan(left[3].Variance));
}

TEST(Kriging, LeavesOneOutOfNeighborhoods)
{
  // With all but one as neighbours, each datum has all the others.
  const KrigingModel model = ModelOf(CovarianceModel::Spherical, 0.0, 2.0);
  const KrigingData data = SomeData(30, true);
  const std::vector<LeaveOneOutEstimate> all = Kriging(model, data, OptionsOf(KrigingType::LinearDrift)).LeaveOneOut();
  const std::vector<LeaveOneOutEstimate> near =
    Kriging(model, data, OptionsOf(KrigingType::LinearDrift, 29)).LeaveOneOut();
  for (std::size_t n = 0; n < data.Places.size(); ++n)
  {
    EXPECT_NEAR(near[n].Estimate, all[n].Estimate, 1e-6);
    EXPECT_NEAR(near[n].Variance, all[n].Variance, 1e-6);
  }
}

TEST(Kriging, NeighborhoodsAreTheNearestData)
{
  // The neighbours found by sorting all distances, and their system solved as a whole.
  const KrigingModel model = ModelOf(CovarianceModel::SimpleExponential, 0.2, 3.0);
  const KrigingData data = SomeData(300, true);
  const Kriging kriging(model, data, OptionsOf(KrigingType::QuadraticDrift, 20));
  const ReducedDistance distance(model.AnisotropyRatio, model.AnisotropyAngle);
  for (const KrigingPlace& target : Targets)
  {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t n = 0; n < data.Places.size(); ++n)
    {
      order.emplace_back(distance(data.Places[n].X - target.X, data.Places[n].Y - target.Y), n);
    }
    std::sort(order.begin(), order.end());
    KrigingData near;
    for (std::size_t n = 0; n < 20; ++n)
    {
      near.Places.push_back(data.Places[order[n].second]);
      near.Values.push_back(data.Values[order[n].second]);
      near.ErrorVariances.push_back(data.ErrorVariances[order[n].second]);
    }
    const LeaveOneOutEstimate truth = Dense(model, near, KrigingType::QuadraticDrift, target);
    double estimate;
    double variance;
    kriging.Estimate(&target, 1, &estimate, &variance);
    EXPECT_NEAR(estimate, truth.Estimate, 1e-5 * std::max(1.0, std::abs(truth.Estimate)));
    EXPECT_NEAR(variance, truth.Variance, 1e-5 * std::max(1.0, truth.Variance));
  }
}

TEST(Kriging, SameBytesInAnyCall)
{
  const KrigingModel model = ModelOf(CovarianceModel::Fractal, 0.0, 2.0);
  const KrigingData data = SomeData(151, false);
  std::vector<KrigingPlace> places;
  for (int n = 0; n < 200; ++n)
  {
    places.push_back({ 0.5 * n, 0.3 * n, 0.1 * n });
  }
  for (const std::size_t neighbors : { 0, 15 })
  {
    const Kriging one(model, data, OptionsOf(KrigingType::ExternalDrift, neighbors));
    const Kriging other(model, data, OptionsOf(KrigingType::ExternalDrift, neighbors), littoral::testing::OnThreads(3));
    std::vector<double> whole(400);
    std::vector<double> parts(400);
    one.Estimate(places.data(), 200, whole.data(), whole.data() + 200);
    for (std::size_t n = 0; n < 200; ++n)
    {
      const std::size_t count = n == 7 ? 5 : 1;
      other.Estimate(&places[n], count, &parts[n], &parts[200 + n]);
    }
    EXPECT_EQ(whole, parts);
  }
}

TEST(Kriging, ConstantDataStayConstant)
{
  KrigingData data = SomeData(50, false);
  data.Values.assign(50, 12.5);
  for (const KrigingType type : { KrigingType::Ordinary, KrigingType::QuadraticDrift, KrigingType::ExternalDrift })
  {
    const Kriging kriging(ModelOf(CovarianceModel::Bessel2), data, OptionsOf(type));
    std::vector<double> estimates(Targets.size());
    kriging.Estimate(Targets.data(), Targets.size(), estimates.data());
    for (const double estimate : estimates)
    {
      EXPECT_NEAR(estimate, 12.5, 1e-7);
    }
  }
}

TEST(Kriging, RefusesSingularSystems)
{
  const auto simple = OptionsOf(KrigingType::Simple);
  // A smooth field with data far closer than its range.
  KrigingModel smooth = ModelOf(CovarianceModel::DoubleExponential);
  smooth.Field.Range = 3000.0;
  EXPECT_NE(FailureOf(smooth, SomeData(100, false), simple).find("singular"), std::string::npos);
  EXPECT_NE(
    FailureOf(smooth, SomeData(100, false), OptionsOf(KrigingType::Simple, 40)).find("singular"), std::string::npos);
  smooth.Nugget = 0.01;
  EXPECT_EQ(FailureOf(smooth, SomeData(100, false), simple), "");
  // Data on a line tell no plane; an external drift that is constant is no second function.
  const KrigingModel model = ModelOf(CovarianceModel::SimpleExponential);
  KrigingData line = SomeData(20, false);
  for (KrigingPlace& place : line.Places)
  {
    place.Y = 0.5 * place.X;
    place.External = 3.0;
  }
  EXPECT_NE(FailureOf(model, line, OptionsOf(KrigingType::LinearDrift)).find("tell"), std::string::npos);
  EXPECT_NE(FailureOf(model, line, OptionsOf(KrigingType::ExternalDrift)).find("tell"), std::string::npos);
  EXPECT_EQ(FailureOf(model, line, OptionsOf(KrigingType::Ordinary)), "");
  EXPECT_NE(
    FailureOf(model, SomeData(2, false), OptionsOf(KrigingType::LinearDrift)).find("only 2 data"), std::string::npos);
}

TEST(Kriging, RefusesBadData)
{
  const KrigingModel model = ModelOf(CovarianceModel::SimpleExponential);
  KrigingData data = SomeData(20, false);
  EXPECT_EQ(WhyInvalid(data, model), "");
  data.Places[11] = data.Places[3];
  EXPECT_NE(WhyInvalid(data, model).find("3 and 11"), std::string::npos);
  EXPECT_NE(WhyInvalid(data, model).find("contradict"), std::string::npos);
  data.Values[11] = data.Values[3];
  EXPECT_NE(WhyInvalid(data, model).find("same value"), std::string::npos);
  EXPECT_EQ(WhyInvalid(data, ModelOf(CovarianceModel::SimpleExponential, 0.1)), "");
  data.ErrorVariances.assign(20, 0.0);
  data.ErrorVariances[11] = 0.5;
  EXPECT_EQ(WhyInvalid(data, model), "");
  EXPECT_EQ(FailureOf(model, data, OptionsOf(KrigingType::Ordinary)), "");
  data.ErrorVariances[2] = -1.0;
  EXPECT_NE(WhyInvalid(data, model).find("Datum 2"), std::string::npos);
  data.ErrorVariances.clear();
  data.Values[5] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(WhyInvalid(data, model).find("Datum 5"), std::string::npos);
  EXPECT_NE(WhyInvalid(KrigingData{}, model), "");
}

TEST(DataVariogram, OfAPlaneIsFlatWithoutIt)
{
  KrigingData data = SomeData(300, false);
  for (std::size_t n = 0; n < 300; ++n)
  {
    data.Values[n] = 3.0 + 0.2 * data.Places[n].X - 0.1 * data.Places[n].Y;
  }
  // Of a plane with slope s, pairs h apart differ by s . h: gamma is about s^2 h^2 / 4 in all directions together.
  const auto tilted = DataVariogram(data, KrigingType::Ordinary);
  EXPECT_NEAR(tilted[2].Semivariance, 0.25 * 0.05 * tilted[2].Lag * tilted[2].Lag, 0.15 * tilted[2].Semivariance);
  for (const LagBin& bin : DataVariogram(data, KrigingType::LinearDrift, littoral::testing::OnThreads(2)))
  {
    EXPECT_NEAR(bin.Semivariance, 0.0, 1e-20);
  }
  const auto why = [](const KrigingData& some) {
    return WhyRefused([&] { FitToData(some, DataVariogram(some, KrigingType::Ordinary)); });
  };
  EXPECT_NE(why(SomeData(10, false)).find("only 10 data"), std::string::npos);
  data.Values.assign(300, 1.0);
  EXPECT_NE(why(data).find("do not vary"), std::string::npos);
}

// Pairs up to half the diagonal, in 15 classes of equal width, one by one.
TEST(DataVariogram, CountsThePairsOfItsClasses)
{
  const KrigingData data = SomeData(200, false);
  double low[2] = { 1e300, 1e300 };
  double high[2] = { -1e300, -1e300 };
  for (const KrigingPlace& place : data.Places)
  {
    low[0] = std::min(low[0], place.X);
    low[1] = std::min(low[1], place.Y);
    high[0] = std::max(high[0], place.X);
    high[1] = std::max(high[1], place.Y);
  }
  const double width = std::hypot(high[0] - low[0], high[1] - low[1]) / 30.0;
  const std::vector<LagBin> bins = DataVariogram(data, KrigingType::Simple);
  ASSERT_EQ(bins.size(), 15u);
  for (int index = 0; index < 15; ++index)
  {
    double pairs = 0.0;
    double lags = 0.0;
    double squares = 0.0;
    for (std::size_t a = 0; a < 200; ++a)
    {
      for (std::size_t b = 0; b < a; ++b)
      {
        const double lag = std::hypot(data.Places[a].X - data.Places[b].X, data.Places[a].Y - data.Places[b].Y);
        if (lag >= index * width && lag < (index + 1) * width)
        {
          pairs += 1.0;
          lags += lag;
          squares += std::pow(data.Values[a] - data.Values[b], 2);
        }
      }
    }
    EXPECT_EQ(bins[index].Pairs, pairs);
    EXPECT_NEAR(bins[index].Lag, lags / pairs, 1e-9);
    EXPECT_NEAR(bins[index].Semivariance, 0.5 * squares / pairs, 1e-9);
  }
}

// Of 4001 data every second is taken, with its own place and value.
TEST(DataVariogram, ThinsManyDataEvenly)
{
  KrigingData all = SomeData(4001, false);
  all.Places[0] = { 0.0, 0.0, 0.0 };
  all.Places[2] = { 100.0, 60.0, 0.0 };
  KrigingData half;
  for (std::size_t n = 0; n < all.Places.size(); n += 2)
  {
    half.Places.push_back(all.Places[n]);
    half.Values.push_back(all.Values[n]);
  }
  const std::vector<LagBin> bins = DataVariogram(all, KrigingType::Simple);
  const std::vector<LagBin> wanted = DataVariogram(half, KrigingType::Simple);
  ASSERT_EQ(bins.size(), wanted.size());
  for (std::size_t n = 0; n < bins.size(); ++n)
  {
    EXPECT_EQ(bins[n].Pairs, wanted[n].Pairs);
    EXPECT_EQ(bins[n].Semivariance, wanted[n].Semivariance);
  }
}

// Data that rise all the way have no range within reach: ranges stop at the last lag, that of a sphere, its diameter,
// at two and that of a fractal at four of them.
TEST(DataVariogram, RangesEndWhereItsLagsEnd)
{
  KrigingData data = SomeData(300, false);
  for (std::size_t n = 0; n < 300; ++n)
  {
    data.Values[n] = 0.3 * data.Places[n].X + 0.1 * data.Places[n].Y;
  }
  const std::vector<LagBin> variogram = DataVariogram(data, KrigingType::Ordinary);
  const double last = variogram.back().Lag;
  double longest = 0.0;
  double fractal = 0.0;
  for (const KrigingModel& model : FitToData(data, variogram))
  {
    const bool isFractal = model.Field.Model == CovarianceModel::Fractal;
    const double part = model.Field.Model == CovarianceModel::Spherical ? 0.5 : 1.0;
    double& range = isFractal ? fractal : longest;
    range = std::max(range, part * model.Field.Range);
  }
  EXPECT_NEAR(longest, last, 1e-6 * last);
  EXPECT_NEAR(fractal, 4.0 * last, 1e-6 * last);
}
