// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/VariogramFit.h"

#include "Numerics/Constants.h"
#include "Numerics/ResidualForm.h"
#include "Terrain/DetrendedWindow.h"
#include "Terrain/ExpectedVariogram.h"
#include "Terrain/ReducedDistance.h"

#include <Eigen/Dense>
#include <unsupported/Eigen/NonLinearOptimization>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace littoral
{

namespace
{

ReducedDistance DistanceOf(const VariogramFit& fit)
{
  return ReducedDistance(fit.AnisotropyRatio, fit.AnisotropyAngle);
}

double SemivarianceAt(const VariogramFit& fit, double r)
{
  return (r > 0.0 ? fit.Nugget : 0.0) + Semivariance(fit.Field, r);
}

/// Dimensions are held so far from 2 and 3.
constexpr double DimensionMargin = 1e-4;

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
      fit.Field.FractalDimension = std::clamp(dimension, 2.0 + DimensionMargin, 3.0 - DimensionMargin);
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

  /// A field at some separations, and its change with each unknown.
  struct Table
  {
    ExpectedVariogram::Field Field;
    std::vector<ExpectedVariogram::Field> Changes;
  };
  Table Tabulate(const Eigen::VectorXd& unknowns, const std::vector<std::array<double, 2>>& separations) const
  {
    const VariogramFit fit = this->Unpack(unknowns);
    const ReducedDistance distance = DistanceOf(fit);
    std::vector<double> distances;
    distances.reserve(separations.size());
    for (const auto& [x, y] : separations)
    {
      distances.push_back(distance(x, y));
    }
    const CorrelationTable correlation = TabulateCorrelation(fit.Field, distances);
    const double variance = fit.Field.Variance;
    const auto field = [&](auto correlationAt) {
      ExpectedVariogram::Field result;
      result.Semivariances.reserve(separations.size());
      for (std::size_t n = 0; n < separations.size(); ++n)
      {
        result.Semivariances.push_back(-variance * correlationAt(n));
      }
      return result;
    };

    Table table;
    const auto change = [&](auto correlationAt) { table.Changes.push_back(field(correlationAt)); };
    table.Field = field([&](std::size_t n) { return -correlation.Uncorrelation[n]; });
    table.Field.Variance = variance;
    table.Field.Nugget = fit.Nugget;
    if (this->HasVariance())
    {
      table.Changes.push_back(table.Field); // with the logarithm of the variance, a part of which is the nugget
    }
    if (this->HasDimension)
    {
      const double part = fit.Field.FractalDimension - 2.0;
      const bool isHeld = part <= DimensionMargin || part >= 1.0 - DimensionMargin;
      const double slope = isHeld ? 0.0 : part * (1.0 - part);
      change([&](std::size_t n) { return slope * correlation.ByDimension[n]; });
    }
    else
    {
      // Range dc/dRange = -r dc/dr - Range2 dc/dRange2
      const double slope = this->RangeSlope(fit, fit.Field.Range);
      change([&](std::size_t n) { return -slope * (correlation.ByDistance[n] + correlation.BySecondRange[n]); });
    }
    if (this->HasSecondRange)
    {
      const double slope = this->RangeSlope(fit, fit.Field.SecondRange);
      change([&](std::size_t n) { return slope * correlation.BySecondRange[n]; });
    }
    if (this->Options.Nugget)
    {
      const double root = unknowns[static_cast<int>(table.Changes.size())];
      change([](std::size_t) { return 0.0; });
      table.Changes.back().Nugget = 2.0 * variance * root;
    }
    if (this->Options.Anisotropy)
    {
      std::vector<ReducedDistance::Changes> changes;
      changes.reserve(separations.size());
      for (const auto& [x, y] : separations)
      {
        changes.push_back(distance.ChangesAt(x, y));
      }
      const double ofRanges = fit.AnisotropyRatio < 1.0 ? 1.0 : 0.0; // then they are multiplied by the ratio
      change([&](std::size_t n) { return correlation.ByDistance[n] * (changes[n].ByRatio - ofRanges); });
      change([&](std::size_t n) { return correlation.ByDistance[n] * changes[n].ByAngle; });
    }
    return table;
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

  /// Change of a range's logarithm with its unknown.
  double RangeSlope(const VariogramFit& fit, double range) const
  {
    return 1.0 - range / (this->MaximumRange() * std::min(1.0, fit.AnisotropyRatio));
  }

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

/// The smallest semivariance of a model that has a logarithm.
constexpr double SmallestSemivariance = 1e-300;

/// Residuals sqrt(weight) ln(measured / model).
class Residuals : public ResidualForm
{
public:
  Residuals(const Unknowns& map, const ExpectedVariogram& expected, const std::vector<LagBin>& bins,
    const std::vector<double>& rootWeights, const VariogramFitOptions& options)
    : Map(map)
    , Expected(expected)
    , Bins(bins)
    , RootWeights(rootWeights)
    , Options(options)
  {
  }

  int inputs() const { return this->Map.Count(); }
  int values() const { return static_cast<int>(this->Bins.size()); }

  int operator()(const Eigen::VectorXd& unknowns, Eigen::VectorXd& residuals)
  {
    this->Evaluate(unknowns);
    for (int i = 0; i < this->values(); ++i)
    {
      residuals[i] = this->RootWeights[i] *
        std::log(
          this->Bins[i].Semivariance / std::max(this->Scale * this->View.Semivariances[i], SmallestSemivariance));
    }
    return 0;
  }

  /// The Jacobian. With g = s a, a what is seen and s the sample's variance over that seen:
  /// d ln g = da / a + d ln s.
  int df(const Eigen::VectorXd& unknowns, Eigen::MatrixXd& jacobian)
  {
    if (unknowns != this->Evaluated)
    {
      this->Evaluate(unknowns);
    }
    const std::vector<ExpectedVariogram::View> changes = this->Expected.Of(this->Table.Changes);
    for (int n = 0; n < this->inputs(); ++n)
    {
      const ExpectedVariogram::View& change = changes[n];
      const double ofScale = this->Options.Window ? -change.Variance / this->View.Variance : 0.0;
      for (int i = 0; i < this->values(); ++i)
      {
        const double seen = this->View.Semivariances[i];
        const double slope = change.Semivariances[i] / seen + ofScale;
        jacobian(i, n) = this->Scale * seen > SmallestSemivariance ? -this->RootWeights[i] * slope : 0.0;
      }
    }
    return 0;
  }

  /// Factor of the variance and the nugget of the unknowns.
  double ScaleAt(const Eigen::VectorXd& unknowns)
  {
    this->Evaluate(unknowns);
    return this->Scale;
  }

private:
  void Evaluate(const Eigen::VectorXd& unknowns)
  {
    this->Evaluated = unknowns;
    this->Table = this->Map.Tabulate(unknowns, this->Expected.GetSeparations());
    this->View = std::move(this->Expected.Of({ this->Table.Field }).front());
    // Where the window is known, variance and nugget are scaled to the sample's.
    this->Scale = this->Options.Window ? this->Options.SampleVariance / this->View.Variance : 1.0;
  }

  const Unknowns& Map;
  const ExpectedVariogram& Expected;
  const std::vector<LagBin>& Bins;
  const std::vector<double>& RootWeights;
  const VariogramFitOptions& Options;
  Eigen::VectorXd Evaluated; ///< unknowns for which the following are
  Unknowns::Table Table;
  ExpectedVariogram::View View;
  double Scale = 1.0;
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

/// End of least squares from one start.
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
  ModelFit(CovarianceModel model, const std::vector<LagBin>& bins, const ExpectedVariogram& expected,
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

  /// Solution from one of the starts, 0 to NumberOfStarts-1; none if the bins are too few.
  Solution FromStart(int start) const
  {
    if (static_cast<int>(this->Bins.size()) < this->Parameters + 2)
    {
      return {};
    }
    const Solution found =
      this->Minimise(this->Map, this->Map.Pack(StartingPoint(this->Model, this->Bins, this->Options, start)));
    return this->Options.Anisotropy ? this->WithoutCorner(found) : found;
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
    const double scale =
      Residuals(this->Map, this->Expected, this->Bins, this->Weights, this->Options).ScaleAt(best.Unknowns);
    fit.Field.Variance *= scale;
    fit.Nugget *= scale;
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
  Solution Minimise(const Unknowns& map, const Eigen::VectorXd& start) const
  {
    Residuals problem(map, this->Expected, this->Bins, this->Weights, this->Options);
    Solution found;
    found.Unknowns = start;
    Eigen::LevenbergMarquardt<Residuals> solver(problem);
    solver.parameters.factor = 0.5; // the default of 100 can step out of the basin at once
    solver.parameters.ftol = 1e-13;
    solver.parameters.xtol = 1e-13;
    solver.parameters.maxfev = 100; // a nugget that goes to zero takes ever smaller steps
    const auto status = solver.minimize(found.Unknowns);
    const double error = solver.fvec.squaredNorm();
    found.Error = std::isfinite(error) ? error : found.Error;
    found.Converged = status != Eigen::LevenbergMarquardtSpace::TooManyFunctionEvaluation &&
      status != Eigen::LevenbergMarquardtSpace::ImproperInputParameters;
    return found;
  }

  /// Solution without the corner that the bound on the longest range has at the ratio 1, in which steps can end early:
  /// from there on the other unknowns are moved alone.
  Solution WithoutCorner(const Solution& found) const
  {
    const int others = this->Map.Count() - 2;
    if (!(std::abs(found.Unknowns[others]) < 1e-3))
    {
      return found;
    }
    VariogramFitOptions options = this->Options;
    options.Anisotropy = false;
    const Unknowns isotropic(this->Model, options);
    Solution round = this->Minimise(isotropic, found.Unknowns.head(others));
    round.Unknowns.conservativeResizeLike(found.Unknowns);
    round.Unknowns.tail(2) << 0.0, found.Unknowns[others + 1];
    return round.Error < found.Error ? round : found;
  }

  CovarianceModel Model;
  const std::vector<LagBin>& Bins;
  const ExpectedVariogram& Expected;
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
  return SemivarianceAt(fit, DistanceOf(fit)(x, y));
}

double Covariance(const VariogramFit& fit, double x, double y)
{
  return Covariance(fit.Field, DistanceOf(fit)(x, y));
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
  const ExpectedVariogram expected(used, options.Window, options.Directions);
  return SolveAll({ ModelFit(model, used, expected, options) }, SerialFor).front();
}

std::vector<VariogramFit> FitAllModels(
  const std::vector<LagBin>& bins, const VariogramFitOptions& options, const ParallelFor& parallelFor)
{
  const std::vector<LagBin> used = UsedBins(bins);
  const ExpectedVariogram expected(used, options.Window, options.Directions);
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
