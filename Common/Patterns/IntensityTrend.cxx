// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/IntensityTrend.h"

#include <Eigen/Dense>

#include <array>
#include <cmath>

namespace littoral
{

namespace
{

/// Cells along each side of the bounding box.
constexpr int CellsOfSide = 128;
/// Newton's steps, of which most fits need six.
constexpr int MaximumIterations = 50;
/// Tolerance of the last step of the logarithms of the intensity.
constexpr double StepTolerance = 1e-10;
/// A trend that spans more than this factor within the window is that of points on a part of it.
constexpr double MaximumLogSpan = 40.0;

/// The terms of the polynomial at a place.
Eigen::VectorXd TermsAt(const ObservationWindow& window, const PlanePosition& place, int degree)
{
  std::array<double, 2> u{};
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const double low = window.GetLow()[axis];
    u[axis] = 2.0 * (place[axis] - low) / (window.GetHigh()[axis] - low) - 1.0;
  }
  Eigen::VectorXd terms(TermsOfTrend(degree));
  int term = 0;
  for (int sum = 0; sum <= degree; ++sum)
  {
    for (int power = 0; power <= sum; ++power)
    {
      terms[term++] = std::pow(u[0], sum - power) * std::pow(u[1], power);
    }
  }
  return terms;
}

PlanePosition CellCenter(const ObservationWindow& window, int cell)
{
  const auto at = [&](std::size_t axis, int index) {
    const double low = window.GetLow()[axis];
    return low + (window.GetHigh()[axis] - low) * (index + 0.5) / CellsOfSide;
  };
  return { at(0, cell % CellsOfSide), at(1, cell / CellsOfSide) };
}

/// The log-likelihood of a trend by its coefficients, with gradient and curvature.
class TrendLikelihood
{
public:
  TrendLikelihood(const std::vector<PlanePosition>& points, const ObservationWindow& window, int degree)
    : OfPoints(Eigen::VectorXd::Zero(TermsOfTrend(degree)))
  {
    for (const PlanePosition& point : points)
    {
      this->OfPoints += TermsAt(window, point, degree);
    }
    for (int cell = 0; cell < CellsOfSide * CellsOfSide; ++cell)
    {
      const PlanePosition center = CellCenter(window, cell);
      if (window.Contains(center))
      {
        this->Cells.push_back(TermsAt(window, center, degree));
      }
    }
    this->CellArea = window.GetArea() / static_cast<double>(this->Cells.size());
  }

  /// sum of b . t(x_i) - integral of exp(b . t); its derivatives are sum of t(x_i) - integral of t exp(b . t), and
  /// - integral of t t^T exp(b . t).
  double operator()(const Eigen::VectorXd& b, Eigen::VectorXd& gradient, Eigen::MatrixXd& curvature) const
  {
    double value = b.dot(this->OfPoints);
    gradient = this->OfPoints;
    curvature = Eigen::MatrixXd::Zero(b.size(), b.size());
    for (const Eigen::VectorXd& terms : this->Cells)
    {
      const double expected = this->CellArea * std::exp(b.dot(terms));
      value -= expected;
      gradient -= expected * terms;
      curvature.noalias() += expected * terms * terms.transpose();
    }
    return value;
  }

  /// Range of the logarithm of the intensity over the window.
  double SpanOf(const Eigen::VectorXd& b) const
  {
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (const Eigen::VectorXd& terms : this->Cells)
    {
      low = std::min(low, b.dot(terms));
      high = std::max(high, b.dot(terms));
    }
    return high - low;
  }

private:
  Eigen::VectorXd OfPoints;
  std::vector<Eigen::VectorXd> Cells;
  double CellArea = 0.0;
};

/// Newton's method from a level intensity on, each step halved until the likelihood grows; false where it has no end.
bool Climb(const TrendLikelihood& likelihood, Eigen::VectorXd& b)
{
  Eigen::VectorXd gradient;
  Eigen::MatrixXd curvature;
  double value = likelihood(b, gradient, curvature);
  for (int steps = 0; steps < MaximumIterations; ++steps)
  {
    const Eigen::LDLT<Eigen::MatrixXd> system(curvature);
    Eigen::VectorXd step = system.solve(gradient);
    if (system.info() != Eigen::Success || !step.allFinite() || likelihood.SpanOf(b) > MaximumLogSpan)
    {
      return false;
    }
    if (step.lpNorm<Eigen::Infinity>() < StepTolerance)
    {
      return true;
    }
    double next = likelihood(b + step, gradient, curvature);
    for (int halving = 0; halving < 30 && !(next >= value - StepTolerance * std::abs(value)); ++halving)
    {
      step *= 0.5;
      next = likelihood(b + step, gradient, curvature);
    }
    b += step;
    value = next;
  }
  return false;
}

}

double IntensityTrend::At(const ObservationWindow& window, const PlanePosition& place) const
{
  const auto terms = TermsAt(window, place, this->Degree);
  return std::exp(terms.dot(Eigen::Map<const Eigen::VectorXd>(this->Coefficients.data(), terms.size())));
}

IntensityTrend FitTrend(const std::vector<PlanePosition>& points, const ObservationWindow& window, int degree)
{
  IntensityTrend trend;
  trend.Degree = degree;
  const int terms = TermsOfTrend(degree);
  if (points.size() < static_cast<std::size_t>(terms))
  {
    return trend;
  }
  Eigen::VectorXd b = Eigen::VectorXd::Zero(terms);
  b[0] = std::log(static_cast<double>(points.size()) / window.GetArea());
  if (Climb(TrendLikelihood(points, window, degree), b))
  {
    trend.Coefficients.assign(b.data(), b.data() + b.size());
  }
  return trend;
}

IntensityRaster RasterOf(const IntensityTrend& trend, const ObservationWindow& window)
{
  IntensityRaster raster;
  raster.Count = { CellsOfSide, CellsOfSide };
  raster.Center = CellCenter(window, 0);
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    raster.Spacing[axis] = (window.GetHigh()[axis] - window.GetLow()[axis]) / CellsOfSide;
  }
  raster.Values.assign(static_cast<std::size_t>(CellsOfSide) * CellsOfSide, 0.0);
  double sum = 0.0;
  std::size_t inside = 0;
  for (std::size_t cell = 0; cell < raster.Values.size(); ++cell)
  {
    const PlanePosition center = CellCenter(window, static_cast<int>(cell));
    if (window.Contains(center))
    {
      raster.Values[cell] = trend.At(window, center);
      sum += raster.Values[cell];
      ++inside;
    }
  }
  const double mean = sum / static_cast<double>(inside);
  for (double& value : raster.Values)
  {
    value = value > 0.0 ? value : mean;
  }
  return raster;
}

}
