// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VariogramFit.h"

#include "Constants.h"

#include <Eigen/Dense>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

#include <algorithm>
#include <cmath>
#include <limits>

namespace littoral
{

namespace
{

/// Distance in the space where an anisotropic field is isotropic.
double ReducedDistance(double ratio, double angle, double x, double y)
{
  const double along = std::cos(angle) * x + std::sin(angle) * y;
  const double across = -std::sin(angle) * x + std::cos(angle) * y;
  return std::hypot(along, ratio * across);
}

/// The unknowns of a fit, each mapped to the whole real line so that no bound can be violated.
class Unknowns
{
public:
  Unknowns(CovarianceModel model, const VariogramFitOptions& options)
    : Model(model)
    , Options(options)
  {
  }

  int Count() const
  {
    return 2 + (this->Model == CovarianceModel::Telis) + this->Options.Nugget + 2 * this->Options.Anisotropy;
  }

  Eigen::VectorXd Pack(const VariogramFit& fit) const
  {
    Eigen::VectorXd unknowns(this->Count());
    int n = 0;
    unknowns[n++] = std::log(fit.Field.Variance);
    if (this->Model == CovarianceModel::Fractal)
    {
      unknowns[n++] = std::log((fit.Field.FractalDimension - 2.0) / (3.0 - fit.Field.FractalDimension));
    }
    else
    {
      unknowns[n++] = this->RangeToUnknown(fit.Field.Range);
    }
    if (this->Model == CovarianceModel::Telis)
    {
      unknowns[n++] = this->RangeToUnknown(fit.Field.SecondRange);
    }
    if (this->Options.Nugget)
    {
      unknowns[n++] = std::sqrt(fit.Nugget / fit.Field.Variance);
    }
    if (this->Options.Anisotropy)
    {
      unknowns[n++] = std::log(fit.AnisotropyRatio);
      unknowns[n++] = fit.AnisotropyAngle;
    }
    return unknowns;
  }

  VariogramFit Unpack(const Eigen::VectorXd& unknowns) const
  {
    // Far beyond any data the exponential is held, so that no step overflows.
    const auto expHeld = [](double x) { return std::exp(std::clamp(x, -300.0, 300.0)); };
    VariogramFit fit;
    fit.Field.Model = this->Model;
    int n = 0;
    fit.Field.Variance = expHeld(unknowns[n++]);
    if (this->Model == CovarianceModel::Fractal)
    {
      fit.Field.Range = this->Options.FractalRange;
      const double dimension = 2.0 + 1.0 / (1.0 + expHeld(-unknowns[n++]));
      fit.Field.FractalDimension = std::clamp(dimension, 2.0001, 2.9999);
    }
    else
    {
      fit.Field.Range = this->LongestRange() / (1.0 + expHeld(-unknowns[n++]));
    }
    if (this->Model == CovarianceModel::Telis)
    {
      fit.Field.SecondRange = this->LongestRange() / (1.0 + expHeld(-unknowns[n++]));
    }
    if (this->Options.Nugget)
    {
      fit.Nugget = fit.Field.Variance * unknowns[n] * unknowns[n];
      ++n;
    }
    if (this->Options.Anisotropy)
    {
      fit.AnisotropyRatio = expHeld(unknowns[n++]);
      fit.AnisotropyAngle = unknowns[n++];
      // The range in hand is the longest, also where that lies across the angle: so the bound holds for both.
      const double across = std::min(1.0, fit.AnisotropyRatio);
      fit.Field.Range *= across;
      fit.Field.SecondRange *= across;
    }
    return fit;
  }

private:
  /// The spherical model's range is where correlation ends, the others' where it has fallen to about a third.
  double LongestRange() const
  {
    return (this->Model == CovarianceModel::Spherical ? 2.0 : 1.0) * this->Options.LongestRange;
  }

  /// Ranges lie between 0 and the longest.
  double RangeToUnknown(double range) const
  {
    const double part = std::clamp(range / this->LongestRange(), 1e-12, 1.0 - 1e-12);
    return std::log(part / (1.0 - part));
  }

  CovarianceModel Model;
  VariogramFitOptions Options;
};

/// Residuals in the form that Eigen's least squares wants.
struct Residuals
{
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  enum
  {
    InputsAtCompileTime = Eigen::Dynamic,
    ValuesAtCompileTime = Eigen::Dynamic
  };

  const Unknowns& Map;
  const std::vector<LagBin>& Bins;
  const std::vector<double>& RootWeights;

  int inputs() const { return this->Map.Count(); }
  int values() const { return static_cast<int>(this->Bins.size()); }

  int operator()(const Eigen::VectorXd& unknowns, Eigen::VectorXd& residuals) const
  {
    const VariogramFit fit = this->Map.Unpack(unknowns);
    for (std::size_t i = 0; i < this->Bins.size(); ++i)
    {
      const LagBin& bin = this->Bins[i];
      const double model = Semivariance(fit, bin.Separation[0], bin.Separation[1]);
      const double floor = 1e-300;
      residuals[static_cast<int>(i)] = this->RootWeights[i] * std::log(bin.Semivariance / std::max(model, floor));
    }
    return 0;
  }
};

/// Longest range first, angle in [0, pi), the longer scale of Telis first.
void Normalise(VariogramFit& fit)
{
  if (fit.AnisotropyRatio < 1.0)
  {
    fit.Field.Range /= fit.AnisotropyRatio;
    fit.Field.SecondRange /= fit.AnisotropyRatio;
    fit.AnisotropyRatio = 1.0 / fit.AnisotropyRatio;
    fit.AnisotropyAngle += 0.5 * Pi;
  }
  fit.AnisotropyAngle -= Pi * std::floor(fit.AnisotropyAngle / Pi);
  if (fit.Field.Model == CovarianceModel::Telis && fit.Field.SecondRange > fit.Field.Range)
  {
    std::swap(fit.Field.Range, fit.Field.SecondRange);
  }
}

/// Ranges tried as a start, geometric over all lags; for Fractal, dimensions.
constexpr int NumberOfStarts = 6;

VariogramFit StartingPoint(
  CovarianceModel model, const std::vector<LagBin>& bins, const VariogramFitOptions& options, int start)
{
  const auto byLag = [](const LagBin& a, const LagBin& b) { return a.Lag < b.Lag; };
  const auto bySemivariance = [](const LagBin& a, const LagBin& b) { return a.Semivariance < b.Semivariance; };
  const double shortest = std::min_element(bins.begin(), bins.end(), byLag)->Lag;
  const double longest = std::max_element(bins.begin(), bins.end(), byLag)->Lag;
  const double part = (start + 0.5) / NumberOfStarts;
  VariogramFit fit;
  fit.Field.Model = model;
  fit.Field.Variance = std::max_element(bins.begin(), bins.end(), bySemivariance)->Semivariance;
  fit.Field.Range = shortest * std::pow(longest / shortest, part);
  fit.Field.SecondRange = 0.1 * fit.Field.Range;
  fit.Field.FractalDimension = 2.0 + part;
  fit.Nugget = 0.05 * fit.Field.Variance;
  fit.AnisotropyRatio = options.Anisotropy ? 1.5 : 1.0;
  fit.AnisotropyAngle = Pi * start / NumberOfStarts;
  if (model == CovarianceModel::Fractal)
  {
    fit.Field.Range = options.FractalRange;
    fit.Field.Variance *= fit.Field.Variance / std::max(Semivariance(fit, longest, 0.0), 1e-300);
  }
  return fit;
}

}

double Semivariance(const VariogramFit& fit, double x, double y)
{
  const double r = ReducedDistance(fit.AnisotropyRatio, fit.AnisotropyAngle, x, y);
  return (r > 0.0 ? fit.Nugget : 0.0) + Semivariance(fit.Field, r);
}

double MeanSemivariance(const VariogramFit& fit, double distance)
{
  const int directions = fit.AnisotropyRatio > 1.0 ? 36 : 1;
  double sum = 0.0;
  for (int i = 0; i < directions; ++i)
  {
    const double angle = Pi * i / directions;
    sum += Semivariance(fit, distance * std::cos(angle), distance * std::sin(angle));
  }
  return sum / directions;
}

VariogramFit FitVariogram(CovarianceModel model, const std::vector<LagBin>& allBins, const VariogramFitOptions& options)
{
  std::vector<LagBin> bins;
  std::copy_if(allBins.begin(), allBins.end(), std::back_inserter(bins),
    [](const LagBin& bin) { return bin.Semivariance > 0.0 && bin.Lag > 0.0; });

  const Unknowns map(model, options);
  VariogramFit best;
  best.Field.Model = model;
  best.WeightedSSE = std::numeric_limits<double>::infinity();
  best.AICc = std::numeric_limits<double>::infinity();
  const int n = static_cast<int>(bins.size());
  const int parameters = map.Count();
  if (n < parameters + 2)
  {
    return best;
  }

  std::vector<double> rootWeights;
  double sum = 0.0;
  for (const LagBin& bin : bins)
  {
    rootWeights.push_back(std::sqrt(bin.Pairs) / bin.Lag);
    sum += rootWeights.back() * rootWeights.back();
  }
  for (double& weight : rootWeights)
  {
    weight *= std::sqrt(n / sum);
  }

  using Problem = Eigen::NumericalDiff<Residuals, Eigen::Central>;
  Problem problem(Residuals{ map, bins, rootWeights });
  for (int start = 0; start < NumberOfStarts; ++start)
  {
    Eigen::VectorXd unknowns = map.Pack(StartingPoint(model, bins, options, start));
    Eigen::LevenbergMarquardt<Problem> solver(problem);
    solver.parameters.factor = 0.5; // the default of 100 can step out of the basin at once
    solver.parameters.ftol = 1e-13;
    solver.parameters.xtol = 1e-13;
    solver.parameters.maxfev = 400;
    const auto status = solver.minimize(unknowns);
    const double error = solver.fvec.squaredNorm();
    if (std::isfinite(error) && error < best.WeightedSSE)
    {
      best = map.Unpack(unknowns);
      best.WeightedSSE = error;
      best.Converged = status != Eigen::LevenbergMarquardtSpace::TooManyFunctionEvaluation &&
        status != Eigen::LevenbergMarquardtSpace::ImproperInputParameters;
    }
  }
  Normalise(best);
  const double tiny = std::numeric_limits<double>::min();
  best.AICc = n * std::log(std::max(best.WeightedSSE / n, tiny)) + 2.0 * parameters +
    2.0 * parameters * (parameters + 1.0) / (n - parameters - 1.0);
  return best;
}

std::vector<VariogramFit> FitAllModels(
  const std::vector<LagBin>& bins, const VariogramFitOptions& options, const std::function<bool(double)>& progress)
{
  std::vector<VariogramFit> fits;
  for (int model = 0; model < NumberOfCovarianceModels; ++model)
  {
    if (progress && !progress(static_cast<double>(model) / NumberOfCovarianceModels))
    {
      return fits;
    }
    fits.push_back(FitVariogram(static_cast<CovarianceModel>(model), bins, options));
  }
  std::stable_sort(
    fits.begin(), fits.end(), [](const VariogramFit& a, const VariogramFit& b) { return a.AICc < b.AICc; });
  return fits;
}

}
