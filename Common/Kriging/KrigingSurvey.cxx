// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Kriging/KrigingSurvey.h"

#include "Kriging/DataVariogram.h"
#include "Numerics/InvalidInput.h"
#include "Numerics/ParameterCheck.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace littoral
{

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
/// Data of which all take part in each estimate, at most, and neighbours where there are more.
constexpr std::size_t MaximumGlobalData = 2000;
constexpr std::size_t UsualNeighbors = 50;
/// Data at which neighbourhoods are tried with a fitted model, at most.
constexpr std::size_t PlacesTried = 500;
/// Margin around the bounds of the data, in parts of their longer side.
constexpr double Margin = 0.05;

/// The value of a raster between its points, x fastest, bilinear; NaN outside and beside NaN.
double BetweenPoints(
  const std::vector<double>& values, const PlaneGrid& grid, const GridWindow& window, const KrigingPlace& place)
{
  const std::array<double, 2> at{ (place.X - grid.Origin[0]) / grid.Spacing[0] - window.First[0],
    (place.Y - grid.Origin[1]) / grid.Spacing[1] - window.First[1] };
  std::size_t cell[2];
  double part[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    const double last = window.Last[axis] - window.First[axis];
    if (!(at[axis] >= -1e-6 && at[axis] <= last + 1e-6))
    {
      return NaN;
    }
    const double index = std::clamp(std::floor(at[axis]), 0.0, std::max(0.0, last - 1.0));
    cell[axis] = static_cast<std::size_t>(index);
    part[axis] = std::clamp(at[axis] - index, 0.0, last > 0.0 ? 1.0 : 0.0);
  }
  const auto width = static_cast<std::size_t>(window.Last[0] - window.First[0]) + 1;
  double sum = 0.0;
  for (std::size_t corner = 0; corner < 4; ++corner)
  {
    const std::size_t i = corner & 1;
    const std::size_t j = corner >> 1;
    const double weight = (i ? part[0] : 1.0 - part[0]) * (j ? part[1] : 1.0 - part[1]);
    sum += weight > 0.0 ? weight * values[(cell[1] + j) * width + cell[0] + i] : 0.0;
  }
  return sum;
}

}

KrigingOptions KrigingSurvey::OptionsAtData() const
{
  KrigingOptions options;
  options.Type = this->Type;
  options.Neighbors = this->Neighbors;
  options.Low = options.High = this->Data.Places[0];
  return options;
}

void SpanGrid(const std::array<int, 2>& dimensions, double reach, KrigingSurvey& survey)
{
  const auto& places = survey.Data.Places;
  Require(places.empty() ? "There are no data; at least one is needed." : "");
  std::array<double, 2> low{ places[0].X, places[0].Y };
  std::array<double, 2> high = low;
  for (const KrigingPlace& place : places)
  {
    low = { std::min(low[0], place.X), std::min(low[1], place.Y) };
    high = { std::max(high[0], place.X), std::max(high[1], place.Y) };
  }
  const double longer = std::max(high[0] - low[0], high[1] - low[1]);
  const double margin = longer > 0.0 ? Margin * longer : reach;
  for (int axis = 0; axis < 2; ++axis)
  {
    survey.Window.Last[axis] = dimensions[axis] - 1;
    survey.Grid.Origin[axis] = low[axis] - margin;
    survey.Grid.Spacing[axis] = (high[axis] - low[axis] + 2.0 * margin) / survey.Window.Last[axis];
  }
}

void TakeDrift(std::vector<double> drift, KrigingSurvey& survey)
{
  survey.Drift = std::move(drift);
  for (std::size_t n = 0; n < survey.Drift.size(); ++n)
  {
    if (!IsSensible(survey.Drift[n]))
    {
      Refuse("The drift at point ", n, " of the Grid is ", TextOf(survey.Drift[n]), "; it must be finite.");
    }
  }
  for (std::size_t n = 0; n < survey.Data.Places.size(); ++n)
  {
    KrigingPlace& place = survey.Data.Places[n];
    place.External = BetweenPoints(survey.Drift, survey.Grid, survey.Window, place);
    if (std::isnan(place.External))
    {
      Refuse("Datum ", n, " is outside the Grid, where there is no external drift.");
    }
  }
}

void TakeScores(KrigingSurvey& survey)
{
  survey.Scores.emplace(survey.Data.Values);
  Require(
    survey.Scores->IsEmpty() ? "All data have the same value, which has no normal score; turn NormalScores off." : "");
  for (double& value : survey.Data.Values)
  {
    value = survey.Scores->ScoreOf(value);
  }
}

void FitModel(KrigingSurvey& survey, const ParallelFor& parallel)
{
  std::string first;
  const KrigingOptions options = survey.OptionsAtData();
  survey.Variogram = DataVariogram(survey.Data, survey.Type, parallel);
  const std::size_t step = (survey.Data.Places.size() + PlacesTried - 1) / PlacesTried;
  for (const KrigingModel& model : FitToData(survey.Data, survey.Variogram, parallel))
  {
    survey.Model = model;
    try
    {
      const Kriging kriging(model, survey.Data, options, parallel);
      double estimate = 0.0;
      for (std::size_t n = 0; kriging.GetNeighbors() < survey.Data.Places.size() && n < survey.Data.Places.size();
           n += step)
      {
        kriging.Estimate(&survey.Data.Places[n], 1, &estimate);
      }
      return;
    }
    catch (const KrigingFailure& failure)
    {
      if (first.empty())
      {
        first = failure.what();
      }
    }
  }
  throw KrigingFailure(first);
}

void TakeMean(bool ofData, KrigingSurvey& survey)
{
  const std::vector<double>& values = survey.Data.Values;
  if (survey.Type != KrigingType::Simple || survey.Scores)
  {
    survey.Mean = 0.0;
  }
  else if (ofData)
  {
    survey.Mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  }
}

void TakeNeighbors(int number, KrigingSurvey& survey)
{
  const std::size_t count = survey.Data.Places.size();
  const auto asked = static_cast<std::size_t>(number);
  survey.Neighbors = asked > 0 ? std::min(asked, count) : count <= MaximumGlobalData ? count : UsualNeighbors;
}

}
