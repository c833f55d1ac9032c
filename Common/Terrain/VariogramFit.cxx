// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/VariogramFit.h"

#include "Numerics/Constants.h"
#include "Numerics/SimdClones.h"
#include "Terrain/DetrendedWindow.h"

#include <Eigen/Dense>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace littoral
{

namespace
{

/// Distances in the space where an anisotropic field is isotropic.
class ReducedDistance
{
public:
  explicit ReducedDistance(const VariogramFit& fit)
    : Cosine(std::cos(fit.AnisotropyAngle))
    , Sine(std::sin(fit.AnisotropyAngle))
    , Ratio(fit.AnisotropyRatio)
  {
  }

  double operator()(double x, double y) const
  {
    const double along = this->Cosine * x + this->Sine * y;
    const double across = -this->Sine * x + this->Cosine * y;
    return std::hypot(along, this->Ratio * across);
  }

private:
  double Cosine;
  double Sine;
  double Ratio;
};

/// Adds multiples of a row to sums.
LITTORAL_WIDE_SIMD_CLONES void AddMultiple(
  const double* __restrict row, double factor, std::size_t count, double* __restrict sums)
{
  for (std::size_t n = 0; n < count; ++n)
  {
    sums[n] += factor * row[n];
  }
}

double SemivarianceAt(const VariogramFit& fit, double r)
{
  return (r > 0.0 ? fit.Nugget : 0.0) + Semivariance(fit.Field, r);
}

/// The unknowns of a fit, each mapped to the whole real line so that no bound can be violated.
class Unknowns
{
public:
  Unknowns(CovarianceModel model, const VariogramFitOptions& options)
    : Model(model)
    , Options(options)
    , HasSecondRange(TraitsOf(model).Parameters.Has("SecondRange"))
    , HasDimension(TraitsOf(model).Parameters.Has("FractalDimension"))
  {
  }

  int Count() const
  {
    return 1 + this->HasVariance() + this->HasSecondRange + this->Options.Nugget + 2 * this->Options.Anisotropy;
  }

  Eigen::VectorXd Pack(const VariogramFit& fit) const
  {
    Eigen::VectorXd unknowns(this->Count());
    int n = 0;
    if (this->HasVariance())
    {
      unknowns[n++] = std::log(fit.Field.Variance);
    }
    if (this->HasDimension)
    {
      unknowns[n++] = std::log((fit.Field.FractalDimension - 2.0) / (3.0 - fit.Field.FractalDimension));
    }
    else
    {
      unknowns[n++] = this->RangeToUnknown(fit.Field.Range);
    }
    if (this->HasSecondRange)
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
    fit.Field.Variance = this->HasVariance() ? expHeld(unknowns[n++]) : 1.0;
    if (this->HasDimension)
    {
      fit.Field.Range = this->Options.FractalRange;
      const double dimension = 2.0 + 1.0 / (1.0 + expHeld(-unknowns[n++]));
      fit.Field.FractalDimension = std::clamp(dimension, 2.0001, 2.9999);
    }
    else
    {
      fit.Field.Range = this->MaximumRange() / (1.0 + expHeld(-unknowns[n++]));
    }
    if (this->HasSecondRange)
    {
      fit.Field.SecondRange = this->MaximumRange() / (1.0 + expHeld(-unknowns[n++]));
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

  /// Whether the fit is held by a bound; of a fit as it was unpacked, with the longest range in hand.
  bool IsAtBound(const VariogramFit& fit, double shortestLag) const
  {
    if (this->HasDimension)
    {
      return std::abs(fit.Field.FractalDimension - 2.5) > 0.49;
    }
    const double longest = std::max(1.0, 1.0 / fit.AnisotropyRatio);
    const double shortest = std::min(1.0, 1.0 / fit.AnisotropyRatio);
    const auto isHeld = [=](double range) {
      return range * longest > 0.99 * this->MaximumRange() || range * shortest < 0.25 * shortestLag;
    };
    return isHeld(fit.Field.Range) || (this->HasSecondRange && isHeld(fit.Field.SecondRange));
  }

private:
  /// The variance of a window that is known follows from the other unknowns.
  bool HasVariance() const { return this->Options.Window == nullptr; }

  /// A model's range is a distance where correlation has fallen to about a third, or some multiple of it.
  double MaximumRange() const { return TraitsOf(this->Model).RangeScale * this->Options.MaximumRange; }

  /// Ranges lie between 0 and the longest.
  double RangeToUnknown(double range) const
  {
    const double part = std::clamp(range / this->MaximumRange(), 1e-12, 1.0 - 1e-12);
    return std::log(part / (1.0 - part));
  }

  CovarianceModel Model;
  VariogramFitOptions Options;
  bool HasSecondRange;
  bool HasDimension; ///< then the range is that of the options
};

/// What a field is expected to show in the lags.
class Expectation
{
public:
  Expectation(const std::vector<LagBin>& bins, const VariogramFitOptions& options)
    : Bins(bins)
    , Options(options)
  {
    if (options.Window)
    {
      const std::vector<std::vector<double>> change = options.Window->SemivarianceChange(bins, options.Directions);
      for (int lag = 0; lag < options.Window->NumberOfLags(); ++lag)
      {
        std::transform(change.begin(), change.end(), std::back_inserter(this->Change),
          [lag](const std::vector<double>& weights) { return weights[lag]; });
      }
    }
  }

  /// Semivariances at the lags. Where the window is known, variance and nugget are scaled to the sample's.
  void Evaluate(VariogramFit& fit, std::vector<double>& semivariances) const
  {
    const ReducedDistance distance(fit);
    semivariances.clear();
    for (const LagBin& bin : this->Bins)
    {
      semivariances.push_back(SemivarianceAt(fit, distance(bin.Separation[0], bin.Separation[1])));
    }
    if (!this->Options.Window)
    {
      return;
    }
    const DetrendedWindow& window = *this->Options.Window;
    const std::vector<double> covariances =
      window.CellCovariances([&](double x, double y) { return Covariance(fit.Field, distance(x, y)); });
    const double variance = fit.Field.Variance + fit.Nugget - window.LostVariance(covariances);
    const double scale = this->Options.SampleVariance / variance;
    fit.Field.Variance *= scale;
    fit.Nugget *= scale;
    // gamma(h) + sum over the lags of cells of w(h) C
    const std::size_t count = semivariances.size();
    for (std::size_t lag = 0; lag < covariances.size(); ++lag)
    {
      AddMultiple(this->Change.data() + lag * count, covariances[lag], count, semivariances.data());
    }
    for (double& semivariance : semivariances)
    {
      semivariance *= scale;
    }
  }

private:
  const std::vector<LagBin>& Bins;
  const VariogramFitOptions& Options;
  std::vector<double> Change; ///< of the bins by each lag of cells
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
  const Expectation& Expected;
  const std::vector<LagBin>& Bins;
  const std::vector<double>& RootWeights;

  int inputs() const { return this->Map.Count(); }
  int values() const { return static_cast<int>(this->Bins.size()); }

  int operator()(const Eigen::VectorXd& unknowns, Eigen::VectorXd& residuals) const
  {
    VariogramFit fit = this->Map.Unpack(unknowns);
    std::vector<double> model;
    this->Expected.Evaluate(fit, model);
    for (std::size_t i = 0; i < this->Bins.size(); ++i)
    {
      const double floor = 1e-300;
      residuals[static_cast<int>(i)] =
        this->RootWeights[i] * std::log(this->Bins[i].Semivariance / std::max(model[i], floor));
    }
    return 0;
  }
};

/// Longest range first, angle in [0, pi), the longer of two scales first.
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
  if (TraitsOf(fit.Field.Model).Parameters.Has("SecondRange") && fit.Field.SecondRange > fit.Field.Range)
  {
    std::swap(fit.Field.Range, fit.Field.SecondRange);
  }
}

/// Ranges tried as a start, geometric over all lags, and dimensions.
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
  if (TraitsOf(model).Parameters.Has("FractalDimension"))
  {
    fit.Field.Range = options.FractalRange;
    fit.Field.Variance *= fit.Field.Variance / std::max(Semivariance(fit, longest, 0.0), 1e-300);
  }
  return fit;
}

VariogramFit FailedFit(CovarianceModel model)
{
  VariogramFit fit;
  fit.Field.Model = model;
  fit.WeightedSSE = std::numeric_limits<double>::infinity();
  fit.AICc = std::numeric_limits<double>::infinity();
  return fit;
}

/// A nugget is taken for real where it lowers the least AICc of all models by this much a lag. In fields without noise
/// some other model with a nugget can look like the true one, and lowers it by up to 0.37: lags are not independent.
constexpr double NuggetGain = 0.4;

/// The lags that have a logarithm.
std::vector<LagBin> UsedBins(const std::vector<LagBin>& bins)
{
  std::vector<LagBin> used;
  std::copy_if(bins.begin(), bins.end(), std::back_inserter(used),
    [](const LagBin& bin) { return bin.Semivariance > 0.0 && bin.Lag > 0.0; });
  return used;
}

/// Roots of the weights N(h) / h^2 of the bins, scaled to a mean weight of 1.
std::vector<double> RootWeights(const std::vector<LagBin>& bins)
{
  std::vector<double> weights;
  double sum = 0.0;
  for (const LagBin& bin : bins)
  {
    weights.push_back(std::sqrt(bin.Pairs) / bin.Lag);
    sum += weights.back() * weights.back();
  }
  const int n = static_cast<int>(bins.size());
  for (double& weight : weights)
  {
    weight *= std::sqrt(n / sum);
  }
  return weights;
}

/// Where least squares end from one start.
struct Solution
{
  Eigen::VectorXd Unknowns;
  double Error = std::numeric_limits<double>::infinity();
  bool Converged = false;
};

/// The fit of one model, with or without nugget as the options say, by least squares of Levenberg and Marquardt from
/// several starts.
class ModelFit
{
public:
  ModelFit(CovarianceModel model, const std::vector<LagBin>& bins, const Expectation& expected,
    const VariogramFitOptions& options)
    : Model(model)
    , Bins(bins)
    , Expected(expected)
    , Options(options)
    , Map(model, options)
    , Weights(RootWeights(bins))
    // The variance comes from the sample's where the window is known.
    , Parameters(this->Map.Count() + (options.Window ? 1 : 0))
  {
  }

  /// What is found from one of the starts, 0 to NumberOfStarts-1; nothing if the bins are too few.
  Solution FromStart(int start) const
  {
    Solution found;
    if (static_cast<int>(this->Bins.size()) < this->Parameters + 2)
    {
      return found;
    }
    using Problem = Eigen::NumericalDiff<Residuals, Eigen::Central>;
    Problem problem(Residuals{ this->Map, this->Expected, this->Bins, this->Weights });
    found.Unknowns = this->Map.Pack(StartingPoint(this->Model, this->Bins, this->Options, start));
    Eigen::LevenbergMarquardt<Problem> solver(problem);
    solver.parameters.factor = 0.5; // the default of 100 can step out of the basin at once
    solver.parameters.ftol = 1e-13;
    solver.parameters.xtol = 1e-13;
    solver.parameters.maxfev = 400;
    const auto status = solver.minimize(found.Unknowns);
    const double error = solver.fvec.squaredNorm();
    found.Error = std::isfinite(error) ? error : found.Error;
    found.Converged = status != Eigen::LevenbergMarquardtSpace::TooManyFunctionEvaluation &&
      status != Eigen::LevenbergMarquardtSpace::ImproperInputParameters;
    return found;
  }

  /// The best of the solutions from all starts.
  VariogramFit Best(const Solution* solutions) const
  {
    const Solution& best = *std::min_element(
      solutions, solutions + NumberOfStarts, [](const Solution& a, const Solution& b) { return a.Error < b.Error; });
    if (std::isinf(best.Error))
    {
      return FailedFit(this->Model);
    }
    VariogramFit fit = this->Map.Unpack(best.Unknowns);
    std::vector<double> semivariances;
    this->Expected.Evaluate(fit, semivariances);
    const auto shortest = std::min_element(
      this->Bins.begin(), this->Bins.end(), [](const LagBin& a, const LagBin& b) { return a.Lag < b.Lag; });
    fit.AtBound = this->Map.IsAtBound(fit, shortest->Lag);
    fit.WeightedSSE = best.Error;
    fit.Converged = best.Converged;
    Normalise(fit);
    const double tiny = std::numeric_limits<double>::min();
    const auto n = static_cast<double>(this->Bins.size());
    const double p = this->Parameters;
    // AICc = n ln(SSE / n) + 2 p + 2 p (p + 1) / (n - p - 1)
    fit.AICc = n * std::log(std::max(fit.WeightedSSE / n, tiny)) + 2.0 * p + 2.0 * p * (p + 1.0) / (n - p - 1.0);
    return fit;
  }

private:
  CovarianceModel Model;
  const std::vector<LagBin>& Bins;
  const Expectation& Expected;
  VariogramFitOptions Options;
  Unknowns Map;
  std::vector<double> Weights;
  int Parameters;
};

/// The best of several fits' solutions, from all starts of each.
std::vector<VariogramFit> SolveAll(const std::vector<ModelFit>& models, const ParallelFor& parallelFor)
{
  std::vector<Solution> solutions(models.size() * NumberOfStarts);
  parallelFor(solutions.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      solutions[n] = models[n / NumberOfStarts].FromStart(static_cast<int>(n % NumberOfStarts));
    }
  });
  std::vector<VariogramFit> fits;
  fits.reserve(models.size());
  for (const ModelFit& model : models)
  {
    fits.push_back(model.Best(solutions.data() + fits.size() * NumberOfStarts));
  }
  return fits;
}

}

double Semivariance(const VariogramFit& fit, double x, double y)
{
  return SemivarianceAt(fit, ReducedDistance(fit)(x, y));
}

double Covariance(const VariogramFit& fit, double x, double y)
{
  return Covariance(fit.Field, ReducedDistance(fit)(x, y));
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

VariogramFit FitVariogram(CovarianceModel model, const std::vector<LagBin>& bins, const VariogramFitOptions& options)
{
  const std::vector<LagBin> used = UsedBins(bins);
  const Expectation expected(used, options);
  return SolveAll({ ModelFit(model, used, expected, options) }, SerialFor).front();
}

std::vector<VariogramFit> FitAllModels(
  const std::vector<LagBin>& bins, const VariogramFitOptions& options, const ParallelFor& parallelFor)
{
  const std::vector<LagBin> used = UsedBins(bins);
  const Expectation expected(used, options);
  std::vector<ModelFit> models; // without nugget, then with
  for (int pass = 0; pass < (options.Nugget ? 2 : 1); ++pass)
  {
    VariogramFitOptions wanted = options;
    wanted.Nugget = pass == 1;
    for (int model = 0; model < NumberOfCovarianceModels; ++model)
    {
      models.emplace_back(static_cast<CovarianceModel>(model), used, expected, wanted);
    }
  }
  const std::vector<VariogramFit> all = SolveAll(models, parallelFor);
  const auto middle = all.begin() + NumberOfCovarianceModels;
  std::vector<VariogramFit> fits[2] = { { all.begin(), middle }, { middle, all.end() } };
  const auto least = [](const std::vector<VariogramFit>& of) {
    const auto byCriterion = [](const VariogramFit& a, const VariogramFit& b) { return a.AICc < b.AICc; };
    return std::min_element(of.begin(), of.end(), byCriterion)->AICc;
  };
  const bool noisy = options.Nugget && least(fits[1]) < least(fits[0]) - NuggetGain * static_cast<double>(used.size());
  std::vector<VariogramFit>& ranked = fits[noisy ? 1 : 0];
  // A fit that failed has an infinite criterion and comes last.
  const auto rank = [](
                      const VariogramFit& fit) { return std::make_tuple(std::isinf(fit.AICc), fit.AtBound, fit.AICc); };
  std::stable_sort(
    ranked.begin(), ranked.end(), [&](const VariogramFit& a, const VariogramFit& b) { return rank(a) < rank(b); });
  return ranked;
}

}
