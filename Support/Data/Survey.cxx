// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Survey.h"

#include "Data/ArrayReader.h"
#include "Kriging/DataVariogram.h"
#include "Kriging/FieldAtData.h"
#include "Numerics/ParameterCheck.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace littoral
{

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
/// Data of which all take part in each estimate, at most, and neighbours where there are more.
constexpr std::size_t MostForAll = 2000;
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

//----------------------------------------------------------------------------
std::string TakeData(vtkDataSet* data, vtkDataArray* values, vtkDataArray* errors, Survey& survey)
{
  survey.Name = values && values->GetName() && *values->GetName() ? values->GetName() : "Elevation";
  for (vtkIdType n = 0; n < data->GetNumberOfPoints(); ++n)
  {
    double point[3];
    data->GetPoint(n, point);
    const double value = values ? values->GetComponent(n, 0) : point[2];
    if (survey.IsRaster)
    {
      survey.Raster.push_back(std::isfinite(value) ? value : NaN);
    }
    if (survey.IsRaster && !std::isfinite(value))
    {
      continue; // a hole
    }
    survey.Data.Places.push_back({ point[0], point[1], 0.0 });
    survey.Data.Values.push_back(value);
    if (errors)
    {
      const double error = errors->GetComponent(n, 0);
      if (!(error >= 0.0))
      {
        return "Datum " + std::to_string(n) + " has the error " + TextOf(error) +
          "; standard deviations of errors must be at least 0.";
      }
      survey.Data.ErrorVariances.push_back(error * error);
    }
  }
  survey.Measured = survey.Data.Values;
  return "";
}

//----------------------------------------------------------------------------
void TakeGrid(vtkImageData* grid, Survey& survey)
{
  const int* extent = grid->GetExtent();
  survey.Window = { { extent[0], extent[2] }, { extent[1], extent[3] } };
  survey.Grid = { { grid->GetOrigin()[0], grid->GetOrigin()[1] }, { grid->GetSpacing()[0], grid->GetSpacing()[1] } };
  survey.OriginZ = grid->GetOrigin()[2];
  survey.SpacingZ = grid->GetSpacing()[2];
}

//----------------------------------------------------------------------------
std::string SpanGrid(const std::array<int, 2>& dimensions, double reach, Survey& survey)
{
  const auto& places = survey.Data.Places;
  if (places.empty())
  {
    return "There are no data; at least one is needed.";
  }
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
  return "";
}

//----------------------------------------------------------------------------
std::string TakeDrift(vtkDataArray* drift, Survey& survey)
{
  survey.Drift.resize(static_cast<std::size_t>(drift->GetNumberOfTuples()));
  for (std::size_t n = 0; n < survey.Drift.size(); ++n)
  {
    survey.Drift[n] = drift->GetComponent(static_cast<vtkIdType>(n), 0);
    if (!IsSensible(survey.Drift[n]))
    {
      return "The drift at point " + std::to_string(n) + " of the Grid is " + TextOf(survey.Drift[n]) +
        "; it must be finite.";
    }
  }
  for (std::size_t n = 0; n < survey.Data.Places.size(); ++n)
  {
    KrigingPlace& place = survey.Data.Places[n];
    place.External = BetweenPoints(survey.Drift, survey.Grid, survey.Window, place);
    if (std::isnan(place.External))
    {
      return "Datum " + std::to_string(n) + " is outside the Grid, where there is no external drift.";
    }
  }
  return "";
}

//----------------------------------------------------------------------------
std::string TakeModel(const FieldStatistics& statistics, Survey& survey)
{
  survey.Model.Field = statistics.Field;
  survey.Model.Nugget = statistics.Nugget;
  survey.Model.AnisotropyRatio = statistics.AnisotropyRatio;
  survey.Model.AnisotropyAngle = statistics.AnisotropyAngle;
  survey.Mean = statistics.Mean;
  ParameterCheck check;
  check.Require(WhyInvalid(survey.Model));
  return check.IsGood() ? WhyInvalid(survey.Data, survey.Model) : check.Reason();
}

//----------------------------------------------------------------------------
std::string TakeScores(Survey& survey)
{
  survey.Scores.emplace(survey.Data.Values);
  if (survey.Scores->IsEmpty())
  {
    return "All data have the same value, which has no normal score; turn NormalScores off.";
  }
  for (double& value : survey.Data.Values)
  {
    value = survey.Scores->ScoreOf(value);
  }
  return "";
}

//----------------------------------------------------------------------------
void TakeNeighbors(int number, Survey& survey)
{
  const std::size_t count = survey.Data.Places.size();
  const auto asked = static_cast<std::size_t>(number);
  survey.Neighbors = asked > 0 ? std::min(asked, count) : count <= MostForAll ? count : UsualNeighbors;
}

//----------------------------------------------------------------------------
std::string FitModel(Survey& survey, const ParallelFor& parallel)
{
  std::string why;
  KrigingOptions options;
  options.Type = survey.Type;
  options.Neighbors = survey.Neighbors;
  options.Low = options.High = survey.Data.Places[0];
  const std::size_t step = (survey.Data.Places.size() + PlacesTried - 1) / PlacesTried;
  for (const KrigingModel& model : FitToData(survey.Data, options.Type, parallel))
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
      return "";
    }
    catch (const KrigingFailure& failure)
    {
      why = why.empty() ? failure.what() : why;
    }
  }
  return why;
}

}
