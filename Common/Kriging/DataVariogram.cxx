// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Kriging/DataVariogram.h"

#include "Kriging/DriftFunctions.h"
#include "Numerics/InvalidInput.h"
#include "Terrain/VariogramFit.h"

#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>

namespace littoral
{

namespace
{

constexpr std::size_t MaximumDataForVariogram = 4000;
constexpr int Classes = 15;

/// Distances, half squared differences and numbers of the pairs of each class.
struct PairSums
{
  std::array<double, Classes> Distance{};
  std::array<double, Classes> Difference{};
  std::array<double, Classes> Count{};
};

/// Residuals of the values from the drift by ordinary least squares.
std::vector<double> Residuals(const KrigingData& data, KrigingType type)
{
  const DriftFunctions functions(
    type == KrigingType::Simple ? KrigingType::Ordinary : type, data.Places, nullptr, data.Places.size());
  const auto rows = static_cast<Eigen::Index>(data.Places.size());
  Eigen::MatrixXd matrix(rows, static_cast<Eigen::Index>(functions.GetCount()));
  for (Eigen::Index n = 0; n < rows; ++n)
  {
    const DriftFunctions::Values values = functions.At(data.Places[n]);
    for (Eigen::Index m = 0; m < matrix.cols(); ++m)
    {
      matrix(n, m) = values[m];
    }
  }
  const Eigen::VectorXd values = Eigen::Map<const Eigen::VectorXd>(data.Values.data(), rows);
  const Eigen::VectorXd rest = values - matrix * matrix.colPivHouseholderQr().solve(values);
  return { rest.data(), rest.data() + rest.size() };
}

}

std::vector<LagBin> DataVariogram(const KrigingData& data, KrigingType type, const ParallelFor& parallel)
{
  const std::vector<double> values = Residuals(data, type);
  const std::size_t stride = (values.size() + MaximumDataForVariogram - 1) / MaximumDataForVariogram;
  const std::size_t count = (values.size() + stride - 1) / stride;
  KrigingPlace low = data.Places[0];
  KrigingPlace high = low;
  for (const KrigingPlace& place : data.Places)
  {
    low.X = std::min(low.X, place.X);
    low.Y = std::min(low.Y, place.Y);
    high.X = std::max(high.X, place.X);
    high.Y = std::max(high.Y, place.Y);
  }
  const double longest = 0.5 * std::hypot(high.X - low.X, high.Y - low.Y);
  const double classes = Classes / (longest > 0.0 ? longest : 1.0);
  std::vector<PairSums> sums(count); // of each datum with those after it, so that their order is fixed
  parallel(count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t a = begin; a < end; ++a)
    {
      const KrigingPlace& p = data.Places[a * stride];
      for (std::size_t b = a + 1; b < count; ++b)
      {
        const KrigingPlace& q = data.Places[b * stride];
        const double distance = std::hypot(p.X - q.X, p.Y - q.Y);
        const double position = distance * classes;
        if (position < Classes)
        {
          // gamma(h) = sum of squared differences / (2 pairs)
          const double difference = values[a * stride] - values[b * stride];
          const auto index = static_cast<std::size_t>(position);
          sums[a].Distance[index] += distance;
          sums[a].Difference[index] += 0.5 * difference * difference;
          sums[a].Count[index] += 1.0;
        }
      }
    }
  });
  std::vector<LagBin> bins;
  for (int index = 0; index < Classes; ++index)
  {
    LagBin bin;
    for (const PairSums& part : sums)
    {
      bin.Lag += part.Distance[index];
      bin.Semivariance += part.Difference[index];
      bin.Pairs += part.Count[index];
    }
    if (bin.Pairs > 0.0)
    {
      bin.Lag /= bin.Pairs;
      bin.Semivariance /= bin.Pairs;
      bin.Separation = { bin.Lag, 0.0 };
      bin.Ring = index;
      bins.push_back(bin);
    }
  }
  return bins;
}

std::vector<KrigingModel> FitToData(
  const KrigingData& data, const std::vector<LagBin>& variogram, const ParallelFor& parallel)
{
  const std::size_t count = data.Places.size();
  if (count < MinimumDataForVariogram)
  {
    Refuse("There ", count == 1 ? "is" : "are", " only ", count, count == 1 ? " datum" : " data",
      ", and a model is fitted to at least ", MinimumDataForVariogram, "; choose a Model or connect a table of fits.");
  }
  const bool varies =
    std::any_of(variogram.begin(), variogram.end(), [](const LagBin& bin) { return bin.Semivariance > 0.0; });
  Require(varies ? ""
                 : "The data do not vary about their drift, so that no model can be fitted to them; choose a Model or "
                   "connect a table of fits.");
  VariogramFitOptions options;
  options.Nugget = true;
  options.MaximumRange = variogram.back().Lag;
  options.FractalRange = 4.0 * variogram.back().Lag;
  std::vector<KrigingModel> models;
  for (const VariogramFit& fit : FitAllModels(variogram, options, parallel))
  {
    if (std::isfinite(fit.AICc))
    {
      models.push_back({ fit.Field, fit.Nugget, 1.0, 0.0 });
    }
  }
  Require(models.empty()
      ? "No model could be fitted to the variogram of the data; choose a Model or connect a table of fits."
      : "");
  return models;
}

}
