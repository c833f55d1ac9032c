// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// What a trend takes of a field, against the matrices of all values of a small window, and against fields that are
// drawn with their Cholesky factor; and the plane of a grown field against one that is fitted to its values.
#include "Terrain/DetrendedWindow.h"

#include "Terrain/TurningBands.h"
#include "Terrain/VariogramFit.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace littoral;

namespace
{

/// A window of unequal spacing, with a corner and some more values missing on request.
GridSamples Window(int width, int height, bool holes)
{
  GridSamples samples;
  samples.Width = width;
  samples.Height = height;
  samples.Spacing = { 30.0, 20.0 };
  for (int n = 0; n < width * height; ++n)
  {
    const int i = n % width;
    const int j = n / width;
    const bool missing = holes && ((i > width / 2 && j > 2 * height / 3) || (7 * i + 11 * j) % 5 == 0);
    samples.Values.push_back(missing ? std::numeric_limits<double>::quiet_NaN() : 1.0);
  }
  return samples;
}

/// All values of a window: their places, covariances, and the matrix that removes the trend.
struct Dense
{
  std::vector<std::array<double, 2>> Places;
  Eigen::MatrixXd Covariances;
  Eigen::MatrixXd Remove;

  Dense(const GridSamples& samples, Trend trend, const DetrendedWindow::CovarianceFunction& covariance)
  {
    for (int n = 0; n < samples.Width * samples.Height; ++n)
    {
      if (!std::isnan(samples.Values[n]))
      {
        this->Places.push_back(
          { n % samples.Width * samples.Spacing[0], n / samples.Width * samples.Spacing[1] }); // NOLINT
      }
    }
    const int count = this->Count();
    this->Covariances.resize(count, count);
    Eigen::MatrixXd functions = Eigen::MatrixXd::Ones(count, trend == Trend::Plane ? 3 : 1);
    for (int a = 0; a < count; ++a)
    {
      for (int b = 0; b < count; ++b)
      {
        this->Covariances(a, b) =
          covariance(this->Places[b][0] - this->Places[a][0], this->Places[b][1] - this->Places[a][1]);
      }
      if (trend == Trend::Plane)
      {
        functions(a, 1) = this->Places[a][0];
        functions(a, 2) = this->Places[a][1];
      }
    }
    for (int column = 0; column < functions.cols(); ++column)
    {
      for (int before = 0; before < 2 * column; ++before) // twice, for the rounding of the first time
      {
        functions.col(column) -=
          functions.col(before % column).dot(functions.col(column)) * functions.col(before % column);
      }
      functions.col(column).normalize();
    }
    this->Remove = Eigen::MatrixXd::Identity(count, count) - functions * functions.transpose();
  }

  int Count() const { return static_cast<int>(this->Places.size()); }

  /// Mean of half the squared differences that the residuals are expected to have, over the pairs with a separation.
  double Semivariance(const Eigen::MatrixXd& residual, double x, double y) const
  {
    double sum = 0.0;
    int pairs = 0;
    for (int a = 0; a < this->Count(); ++a)
    {
      for (int b = 0; b < this->Count(); ++b)
      {
        if (std::hypot(this->Places[b][0] - this->Places[a][0] - x, this->Places[b][1] - this->Places[a][1] - y) < 1e-6)
        {
          sum += 0.5 * (residual(a, a) + residual(b, b)) - residual(a, b);
          ++pairs;
        }
      }
    }
    return sum / pairs;
  }
};

VariogramFit Field(CovarianceModel model, double range, double ratio)
{
  VariogramFit field;
  field.Field.Model = model;
  field.Field.Range = range;
  field.Field.SecondRange = 0.2 * range;
  field.Field.FractalDimension = 2.3;
  field.AnisotropyRatio = ratio;
  field.AnisotropyAngle = 0.7;
  return field;
}

}

TEST(DetrendedWindow, AgreesWithTheMatricesOfAllValues)
{
  // 22 x 19 values, 660 x 380 m. Fields from shorter than the spacing to longer than the window.
  const VariogramFit fields[] = { Field(CovarianceModel::SimpleExponential, 10.0, 1.0),
    Field(CovarianceModel::SimpleExponential, 300.0, 3.0), Field(CovarianceModel::DoubleExponential, 150.0, 1.0),
    Field(CovarianceModel::Spherical, 2000.0, 1.0), Field(CovarianceModel::Telis, 800.0, 2.0),
    Field(CovarianceModel::Fractal, 4000.0, 1.0) };
  for (const bool holes : { false, true })
  {
    const GridSamples samples = Window(22, 19, holes);
    for (const Trend trend : { Trend::Mean, Trend::Plane })
    {
      const DetrendedWindow window(samples, trend);
      for (const VariogramFit& field : fields)
      {
        SCOPED_TRACE(testing::Message() << CovarianceModelName(field.Field.Model) << " range " << field.Field.Range
                                        << " holes " << holes << " plane " << (trend == Trend::Plane));
        const auto covariance = [&](double x, double y) { return Covariance(field, x, y); };
        const Dense dense(samples, trend, covariance);
        const Eigen::MatrixXd residual = dense.Remove * dense.Covariances * dense.Remove;
        const double variance = residual.trace() / dense.Count();
        const std::vector<double> cells = window.CellCovariances(covariance);
        EXPECT_NEAR(1.0 - window.LostVariance(cells), variance, 0.005);
        const double deviation = std::sqrt(2.0 * residual.squaredNorm()) / dense.Count();
        EXPECT_NEAR(window.VarianceDeviation(covariance), deviation, 0.005 + 0.05 * deviation);

        std::vector<LagBin> lags;
        for (const std::array<int, 2>& cell :
          std::vector<std::array<int, 2>>{ { 2, 1 }, { 9, 0 }, { 0, 8 }, { -7, 8 } })
        {
          LagBin lag;
          lag.Separation = { cell[0] * samples.Spacing[0], cell[1] * samples.Spacing[1] };
          lag.Lag = std::hypot(lag.Separation[0], lag.Separation[1]);
          lags.push_back(lag);
        }
        const std::vector<std::vector<double>> change = window.SemivarianceChange(lags, 12);
        for (std::size_t n = 0; n < lags.size(); ++n)
        {
          double semivariance = Semivariance(field, lags[n].Separation[0], lags[n].Separation[1]);
          for (std::size_t m = 0; m < cells.size(); ++m)
          {
            semivariance += change[n][m] * cells[m];
          }
          EXPECT_NEAR(semivariance, dense.Semivariance(residual, lags[n].Separation[0], lags[n].Separation[1]), 0.012)
            << "lag " << lags[n].Lag;
        }
      }
    }
  }
}

TEST(DetrendedWindow, FitsOfWhatAPlaneLeavesFindTheField)
{
  // The semivariances and the variance that are expected of 24 x 20 values less their plane, by the matrices of all
  // values, give back the field that they are those of: also one so long that the plane takes most of its variance.
  GridSamples samples = Window(24, 20, false);
  samples.Spacing = { 1.0, 1.0 };
  for (const double range : { 4.0, 12.0, 40.0 })
  {
    const VariogramFit truth = Field(CovarianceModel::SimpleExponential, range, 1.0);
    const Dense dense(samples, Trend::Plane, [&](double x, double y) { return Covariance(truth, x, y); });
    const Eigen::MatrixXd residual = dense.Remove * dense.Covariances * dense.Remove;
    VariogramMap map;
    map.LagWidth = map.LagHeight = 12;
    map.Semivariance.resize(25 * 13);
    map.Pairs.resize(25 * 13);
    for (int a = 0; a < dense.Count(); ++a)
    {
      for (int b = 0; b < dense.Count(); ++b)
      {
        const int i = static_cast<int>(dense.Places[b][0] - dense.Places[a][0]);
        const int j = static_cast<int>(dense.Places[b][1] - dense.Places[a][1]);
        if (std::abs(i) <= 12 && j >= 0 && j <= 12)
        {
          map.Semivariance[map.Index(i, j)] += 0.5 * (residual(a, a) + residual(b, b)) - residual(a, b);
          map.Pairs[map.Index(i, j)] += 1.0;
        }
      }
    }
    std::transform(map.Semivariance.begin(), map.Semivariance.end(), map.Pairs.begin(), map.Semivariance.begin(),
      std::divides<double>());
    const DetrendedWindow window(samples, Trend::Plane);
    VariogramFitOptions options;
    options.MaximumRange = 1000.0;
    options.Window = &window;
    options.SampleVariance = residual.trace() / dense.Count();
    const std::vector<LagBin> bins = BinVariogram(map, 10.0, 20, 1);
    const VariogramFit fit = FitVariogram(truth.Field.Model, bins, options);
    // At 40 the plane leaves 0.12 of the variance, and what is left tells little but the rise near zero. Without
    // account of the plane the range comes out as 8.4 and the variance as 0.22.
    const double tolerance = range > 20.0 ? 0.2 : 0.02;
    EXPECT_NEAR(fit.Field.Range / range, 1.0, tolerance);
    EXPECT_NEAR(fit.Field.Variance, 1.0, tolerance);
    EXPECT_NEAR(fit.Field.Variance * range / fit.Field.Range, 1.0, 0.02);
  }
}

TEST(TurningBandsPlane, IsTheOneFittedToTheField)
{
  for (const double ratio : { 1.0, 4.0 })
  {
    TurningBandsParameters parameters;
    parameters.Field.Model = CovarianceModel::SimpleExponential;
    parameters.Field.Range = 200.0;
    parameters.NumberOfLines = 24;
    parameters.NumberOfHarmonics = 60;
    parameters.AnisotropyRatio = ratio;
    parameters.AnisotropyAngle = 0.4;
    parameters.MinimumWavelength = 20.0;
    const PlaneGrid grid{ { 5.0, -7.0 }, { 10.0, 5.0 } };
    const TurningBandsField field(parameters, grid, GridWindow{});

    // A rectangle somewhere, longer than the field's range, cut into small cells whose middles are sampled.
    GridSamples samples;
    samples.Width = 90;
    samples.Height = 70;
    samples.Spacing = { 6.0, 5.0 };
    const std::array<double, 2> center{ 730.0, -410.0 };
    const std::array<double, 2> sides{ samples.Width * samples.Spacing[0], samples.Height * samples.Spacing[1] };
    for (int n = 0; n < samples.Width * samples.Height; ++n)
    {
      samples.Values.push_back(
        field.ValueAt(center[0] + (n % samples.Width + 0.5) * samples.Spacing[0] - 0.5 * sides[0],
          center[1] + (n / samples.Width + 0.5) * samples.Spacing[1] - 0.5 * sides[1]));
    }
    const PlaneTrend fitted = RemovePlane(samples);
    PlaneTrend plane;
    for (std::size_t line = 0; line < field.GetNumberOfLines(); ++line)
    {
      const PlaneTrend part = field.PlaneOfLine(line, center, sides);
      plane.Mean += part.Mean;
      plane.Slope[0] += part.Slope[0];
      plane.Slope[1] += part.Slope[1];
    }
    EXPECT_GT(std::abs(fitted.Mean), 0.05);
    EXPECT_NEAR(plane.Mean, fitted.Mean, 1e-3);
    EXPECT_NEAR(plane.Slope[0] * sides[0], fitted.Slope[0] * sides[0], 2e-3);
    EXPECT_NEAR(plane.Slope[1] * sides[1], fitted.Slope[1] * sides[1], 2e-3);
  }
}
