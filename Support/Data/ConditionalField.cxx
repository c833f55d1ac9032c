// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/ConditionalField.h"

#include "Data/Arrays.h"
#include "Data/Tables.h"
#include "Kriging/FieldAtData.h"
#include "Numerics/RandomStream.h"
#include "Pipeline/Pipeline.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace littoral
{

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
/// Rows of the grid that one thread fills at a time.
constexpr int RowsAtOnce = 16;

/// The data without the mean that is known.
KrigingData WithoutMean(const Survey& survey)
{
  KrigingData data = survey.Data;
  for (double& value : data.Values)
  {
    value -= survey.Mean;
  }
  return data;
}

/// Adds a column whose value for each datum is told by its index.
template <typename ValueOf>
void AddDatumColumn(vtkTable* table, const char* name, std::size_t count, const ValueOf& valueOf)
{
  std::vector<std::size_t> rows(count);
  std::iota(rows.begin(), rows.end(), std::size_t{ 0 });
  AddColumn(table, name, rows, valueOf);
}

}

//----------------------------------------------------------------------------
double MemoryOf(const Survey& survey, double points, bool variance)
{
  return points * sizeof(double) * (variance ? 2 : 1) +
    Kriging::MemoryFor(survey.Data.Places.size(), survey.Neighbors);
}

//----------------------------------------------------------------------------
ConditionalField::ConditionalField(const Survey& survey, const ConditionalWish& wish, vtkAlgorithm* algorithm)
  : Data(survey)
  , Wish(wish)
  , Algorithm(algorithm)
  , AtData(survey.Data.Places.size(), 0.0)
{
}

//----------------------------------------------------------------------------
bool ConditionalField::Simulate()
{
  const Survey& survey = this->Data;
  TurningBandsParameters bands;
  bands.Field = survey.Model.Field;
  bands.AnisotropyRatio = survey.Model.AnisotropyRatio;
  bands.AnisotropyAngle = survey.Model.AnisotropyAngle;
  bands.Seed = this->Wish.Seed;
  const int lines = this->Wish.NumberOfLines;
  bands.NumberOfLines = lines > 0 ? lines : 1;
  const std::string reason = WhyInvalid(bands, survey.Grid);
  if (!reason.empty())
  {
    throw KrigingFailure(reason);
  }
  bands.NumberOfLines = lines > 0 ? lines : EnoughLines(bands, survey.Grid, survey.Window);
  TurningBandsField& field = this->Field.emplace(bands, survey.Grid, survey.Window);
  if (!RunWithProgress(this->Algorithm, field.GetNumberOfLines(), 0.0, 0.2,
        [&](std::size_t line) { field.TabulateLine(line); }))
  {
    return false;
  }
  this->AtData =
    FieldAtData(field, bands, survey.Grid, survey.Window, survey.Data.Places, AbortableFor(this->Algorithm));
  return true;
}

//----------------------------------------------------------------------------
bool ConditionalField::Solve()
{
  const Survey& survey = this->Data;
  KrigingData differences = survey.Data;
  if (this->Wish.Simulates)
  {
    if (!this->Simulate())
    {
      return false;
    }
    // What a measurement would have read of the simulated field
    const RandomStream errors(this->Wish.Seed, RandomPurpose::DatumErrors);
    for (std::size_t n = 0; n < this->AtData.size(); ++n)
    {
      const double noise = survey.Model.Nugget + survey.Data.ErrorVariance(n);
      differences.Values[n] -= this->AtData[n] + (noise > 0.0 ? std::sqrt(noise) * errors.NormalPair(n, 0)[0] : 0.0);
    }
  }
  for (double& value : differences.Values)
  {
    value -= survey.Mean;
  }
  KrigingOptions options;
  options.Type = survey.Type;
  options.Neighbors = survey.Neighbors;
  options.Low = PlaceOfPoint(survey.Grid, survey.Window.First[0], survey.Window.First[1]);
  options.High = PlaceOfPoint(survey.Grid, survey.Window.Last[0], survey.Window.Last[1]);
  this->Differences =
    std::make_unique<Kriging>(survey.Model, std::move(differences), options, AbortableFor(this->Algorithm));
  this->Algorithm->UpdateProgress(0.3);
  return true;
}

//----------------------------------------------------------------------------
bool ConditionalField::Fill(const int extent[6], vtkImageData* output) const
{
  const auto width = static_cast<vtkIdType>(std::max(0, extent[1] - extent[0] + 1));
  const auto height = static_cast<vtkIdType>(std::max(0, extent[3] - extent[2] + 1));
  auto values = NewArray<vtkDoubleArray>(this->Data.Name.c_str(), 1, width * height);
  auto variances = NewArray<vtkDoubleArray>("KrigingVariance", 1, this->Wish.Variance ? width * height : 0);
  const std::size_t pieces = width > 0 ? (height + RowsAtOnce - 1) / RowsAtOnce : 0;
  const bool done = RunWithProgress(this->Algorithm, pieces, 0.3, 0.95, [&](std::size_t piece) {
    const int first = extent[2] + static_cast<int>(piece) * RowsAtOnce;
    this->FillRows(extent, first, std::min(first + RowsAtOnce - 1, extent[3]), values, variances);
  });
  if (done)
  {
    output->GetPointData()->SetScalars(values);
    if (this->Wish.Variance)
    {
      output->GetPointData()->AddArray(variances);
    }
    AddField(output, "KrigingNeighbors", { static_cast<double>(this->Data.Neighbors) });
  }
  return done;
}

//----------------------------------------------------------------------------
void ConditionalField::FillRows(
  const int extent[6], int first, int last, vtkDoubleArray* values, vtkDoubleArray* variances) const
{
  const Survey& survey = this->Data;
  const auto width = static_cast<vtkIdType>(extent[1] - extent[0] + 1);
  const auto fullWidth = static_cast<std::size_t>(survey.Window.Last[0] - survey.Window.First[0]) + 1;
  std::vector<float> simulated;
  if (this->Field)
  {
    simulated.resize(fullWidth * (last - first + 1));
    this->Field->FillRows(first, last, 1.0, 0.0, simulated.data());
  }
  std::vector<KrigingPlace> places;
  std::vector<vtkIdType> ids;
  std::vector<double> offsets;
  for (int j = first; j <= last; ++j)
  {
    for (int i = extent[0]; i <= extent[1]; ++i)
    {
      const vtkIdType id = (j - extent[2]) * width + (i - extent[0]);
      const std::size_t whole = survey.Index(i, j);
      if (survey.IsRaster && !std::isnan(survey.Raster[whole]))
      {
        values->SetValue(id, survey.Raster[whole]);
        if (this->Wish.Variance)
        {
          variances->SetValue(id, 0.0);
        }
        continue;
      }
      places.push_back(PlaceOfPoint(survey.Grid, i, j));
      places.back().External = survey.Drift.empty() ? 0.0 : survey.Drift[whole];
      ids.push_back(id);
      offsets.push_back(this->Field ? simulated[(j - first) * fullWidth + (i - survey.Window.First[0])] : 0.0);
    }
  }
  std::vector<double> kriged(places.size());
  std::vector<double> own(this->Wish.Variance ? places.size() : 0);
  this->Differences->Estimate(
    places.data(), places.size(), kriged.data(), this->Wish.Variance ? own.data() : nullptr);
  for (std::size_t n = 0; n < ids.size(); ++n)
  {
    values->SetValue(ids[n], survey.Back(survey.Mean + offsets[n] + kriged[n]));
    if (this->Wish.Variance)
    {
      variances->SetValue(ids[n], own[n]);
    }
  }
}

//----------------------------------------------------------------------------
void ConditionalField::AddRows(vtkTable* table) const
{
  const Survey& survey = this->Data;
  const std::vector<KrigingPlace>& places = survey.Data.Places;
  std::vector<double> field(places.size());
  AbortableFor(this->Algorithm)(places.size(), [&](std::size_t begin, std::size_t end) {
    this->Differences->Estimate(&places[begin], end - begin, &field[begin]);
    for (std::size_t n = begin; n < end; ++n)
    {
      field[n] = survey.Back(survey.Mean + this->AtData[n] + field[n]);
    }
  });
  const auto column = [&](const char* name, auto valueOf) { AddDatumColumn(table, name, places.size(), valueOf); };
  column("X", [&](std::size_t n) { return places[n].X; });
  column("Y", [&](std::size_t n) { return places[n].Y; });
  column("Value", [&](std::size_t n) { return survey.Measured[n]; });
  column("Field", [&](std::size_t n) { return field[n]; });
}

//----------------------------------------------------------------------------
void AddModel(const Survey& survey, vtkTable* table)
{
  const CovarianceParameters& field = survey.Model.Field;
  AddText(table, "Model", CovarianceModelName(field.Model));
  AddField(table, "ModelId", { static_cast<double>(field.Model) });
  for (const auto* parameter : AllCovarianceParameters())
  {
    const bool has = TraitsOf(field.Model).Parameters.Has(parameter->Name);
    AddField(table, parameter->Name, { has ? parameter->Get(field) : NaN });
  }
  AddField(table, "Nugget", { survey.Model.Nugget });
}

//----------------------------------------------------------------------------
void AddCrossValidation(const Survey& survey, vtkAlgorithm* algorithm, vtkTable* table)
{
  // Of the data themselves, not of their differences from the simulated field
  KrigingOptions options;
  options.Type = survey.Type;
  options.Neighbors = survey.Neighbors;
  options.Low = options.High = survey.Data.Places[0];
  const auto parallel = AbortableFor(algorithm);
  const Kriging kriging(survey.Model, WithoutMean(survey), options, parallel);
  std::vector<LeftOut> left = kriging.LeaveOneOut(parallel);
  std::vector<double> errors(left.size(), NaN); // in standard deviations
  double sum = 0.0;
  double squares = 0.0;
  double standardized = 0.0;
  double known = 0.0;
  for (std::size_t n = 0; n < left.size(); ++n)
  {
    left[n].Estimate += survey.Mean;
    errors[n] = (survey.Data.Values[n] - left[n].Estimate) / std::sqrt(left[n].Variance);
    if (std::isfinite(errors[n]))
    {
      const double measured = survey.Measured[n] - survey.Back(left[n].Estimate);
      known += 1.0;
      sum += measured;
      squares += measured * measured;
      standardized += errors[n] * errors[n];
    }
  }
  const auto column = [&](const char* name, auto valueOf) { AddDatumColumn(table, name, left.size(), valueOf); };
  column("LeftOutEstimate",
    [&](std::size_t n) { return std::isnan(left[n].Estimate) ? NaN : survey.Back(left[n].Estimate); });
  column("LeftOutDeviation", [&](std::size_t n) { return std::sqrt(left[n].Variance); });
  column("StandardizedError", [&](std::size_t n) { return errors[n]; });
  AddField(table, "MeanError", { sum / known });
  AddField(table, "RootMeanSquareError", { std::sqrt(squares / known) });
  AddField(table, "MeanSquaredStandardizedError", { standardized / known });
}

//----------------------------------------------------------------------------
void WriteData(const Survey& survey, vtkTable* table, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  for (std::size_t n = 0; n < survey.Measured.size(); ++n)
  {
    const KrigingPlace& place = survey.Data.Places[n];
    const vtkIdType point = points->InsertNextPoint(place.X, place.Y, survey.Measured[n]);
    vertices->InsertNextCell(1, &point);
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  for (vtkIdType n = 2; n < table->GetNumberOfColumns(); ++n) // after X and Y
  {
    output->GetPointData()->AddArray(table->GetColumn(n));
  }
}

}
