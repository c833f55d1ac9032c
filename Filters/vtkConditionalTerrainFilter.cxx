// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkConditionalTerrainFilter.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/Inputs.h"
#include "Data/Tables.h"
#include "Kriging/DataVariogram.h"
#include "Kriging/FieldAtData.h"
#include "Kriging/Kriging.h"
#include "Kriging/NormalScores.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Mistakes.h"
#include "Pipeline/Pipeline.h"
#include "Terrain/TurningBands.h"

#include "vtkCellArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkConditionalTerrainFilter);

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
/// Data of which all take part in each estimate, at most, and neighbours where there are more.
constexpr std::size_t MostForAll = 2000;
constexpr std::size_t UsualNeighbors = 50;
/// Data at which neighbourhoods are tried with a fitted model, at most.
constexpr std::size_t PlacesTried = 500;
/// Rows of the grid that one thread fills at a time.
constexpr int RowsAtOnce = 16;
/// Margin around the bounds of the data, in parts of their longer side.
constexpr double Margin = 0.05;

/// Standard deviations whose squares are sensible.
constexpr littoral::ValueInterval Deviations = littoral::ValueInterval::From(1e-15, 3e7);

/// What the image at the first port is, null for other data.
vtkImageData* ImageAmongData(vtkInformationVector* inputs)
{
  return vtkImageData::SafeDownCast(vtkDataObject::GetData(inputs));
}

/// The value of a raster between its points, x fastest, bilinear; NaN outside and beside NaN.
double BetweenPoints(const std::vector<double>& values, const littoral::PlaneGrid& grid,
  const littoral::GridWindow& window, const littoral::KrigingPlace& place)
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

/// Data, grid and model of one request.
class vtkConditionalTerrainFilter::Survey
{
public:
  littoral::KrigingData Data;
  std::vector<double> Measured; ///< values as they came, Data has their scores
  std::string Name = "Elevation";
  bool IsRaster = false; ///< the data are points of the grid, which keep their values

  littoral::PlaneGrid Grid;
  littoral::GridWindow Window; ///< the whole grid
  double OriginZ = 0.0;
  double SpacingZ = 1.0;
  int Layer = 0;
  std::vector<double> Drift;  ///< at the points of the grid
  std::vector<double> Raster; ///< values at the points of the grid, NaN in holes, where the data are its points

  littoral::KrigingModel Model;
  double Mean = 0.0; ///< that is known
  std::optional<littoral::NormalScores> Scores;
  std::size_t Neighbors = 0;

  std::size_t Index(int column, int row) const
  {
    const auto width = static_cast<std::size_t>(this->Window.Last[0] - this->Window.First[0]) + 1;
    return static_cast<std::size_t>(row - this->Window.First[1]) * width + (column - this->Window.First[0]);
  }

  double Back(double value) const { return this->Scores ? this->Scores->ValueOf(value) : value; }
};

/// The simulated field and the kriged differences.
class vtkConditionalTerrainFilter::Simulation
{
public:
  std::optional<littoral::TurningBandsField> Field;
  std::vector<double> AtData;
  std::unique_ptr<littoral::Kriging> Differences;
};

//----------------------------------------------------------------------------
vtkConditionalTerrainFilter::vtkConditionalTerrainFilter()
  : ErrorArray("None")
  , Result(ConditionalField)
  , KrigingType(Ordinary)
  , Model(FittedToData)
  , StandardDeviation(40.0)
  , Mean(200.0)
  , Range(1000.0)
  , SecondRange(50.0)
  , FractalDimension(2.15)
  , Nugget(0.0)
  , AnisotropyRatio(1.0)
  , AnisotropyAngle(0.0)
  , Dimensions{ 301, 301 }
  , NumberOfNeighbors(0)
  , NormalScores(false)
  , KrigingVariance(false)
  , CrossValidation(false)
  , NumberOfLines(0)
  , Seed(1)
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(3);
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  this->SetInputArrayToProcess(1, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

//----------------------------------------------------------------------------
vtkConditionalTerrainFilter::~vtkConditionalTerrainFilter() = default;

//----------------------------------------------------------------------------
void vtkConditionalTerrainFilter::SetErrorArray(const char* name)
{
  const std::string text = name ? name : "None";
  if (this->ErrorArray != text)
  {
    this->ErrorArray = text;
    this->Modified();
  }
}

//----------------------------------------------------------------------------
int vtkConditionalTerrainFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  if (port == 0)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  }
  else
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 1 ? "vtkImageData" : "vtkTable");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkConditionalTerrainFilter::FillOutputPortInformation(int port, vtkInformation* info)
{
  constexpr const char* types[] = { "vtkImageData", "vtkTable", "vtkPolyData" };
  info->Set(vtkDataObject::DATA_TYPE_NAME(), types[port]);
  return 1;
}

//----------------------------------------------------------------------------
bool vtkConditionalTerrainFilter::Refuse(const std::string& reason)
{
  if (!reason.empty())
  {
    littoralErrorMacro(<< reason);
  }
  return reason.empty();
}

//----------------------------------------------------------------------------
int vtkConditionalTerrainFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* output = outputVector->GetInformationObject(0);
  vtkInformation* grid = inputVector[1]->GetNumberOfInformationObjects() > 0 ? inputVector[1]->GetInformationObject(0)
    : ImageAmongData(inputVector[0])                                         ? inputVector[0]->GetInformationObject(0)
                                                                             : nullptr;
  if (!grid)
  {
    littoral::ParameterCheck check;
    check.Count("Dimensions[0]", this->Dimensions[0], 2, 1000000);
    check.Count("Dimensions[1]", this->Dimensions[1], 2, 1000000);
    if (!this->Refuse(check.Reason()))
    {
      return littoral::FailedInformation(this, outputVector);
    }
  }
  int whole[6] = { 0, this->Dimensions[0] - 1, 0, this->Dimensions[1] - 1, 0, 0 };
  double origin[3] = { 0.0, 0.0, 0.0 };
  double spacing[3] = { 1.0, 1.0, 1.0 };
  if (grid)
  {
    grid->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
    grid->Get(vtkDataObject::ORIGIN(), origin);
    grid->Get(vtkDataObject::SPACING(), spacing);
  }
  if (whole[1] < whole[0] || whole[3] < whole[2] || whole[5] < whole[4])
  {
    this->Refuse("The grid has no points.");
    return littoral::FailedInformation(this, outputVector);
  }
  output->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole, 6);
  output->Set(vtkDataObject::ORIGIN(), origin, 3);
  output->Set(vtkDataObject::SPACING(), spacing, 3);
  output->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  vtkDataObject::SetPointDataActiveScalarInfo(output, VTK_DOUBLE, 1);
  return 1;
}

//----------------------------------------------------------------------------
int vtkConditionalTerrainFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // Each part of the field needs all data, the drift at all of them, and the whole table.
  for (int port = 0; port < 3; ++port)
  {
    littoral::RequestAll(inputVector[port]->GetInformationObject(0));
  }
  return 1;
}

//----------------------------------------------------------------------------
bool vtkConditionalTerrainFilter::CheckProperties()
{
  littoral::ParameterCheck check;
  check.Choice("Result", this->Result, { "conditional field", "kriging estimate" });
  check.Choice(
    "KrigingType", this->KrigingType, { "simple", "ordinary", "linear drift", "quadratic drift", "external drift" });
  check.Count("Model", this->Model, FittedToData, littoral::NumberOfCovarianceModels - 1);
  check.Within("StandardDeviation", this->StandardDeviation, Deviations);
  check.Finite("Mean", this->Mean);
  check.Count("NumberOfNeighbors", this->NumberOfNeighbors, 0, std::numeric_limits<int>::max());
  check.Count("NumberOfLines", this->NumberOfLines, 0, 100000);
  return this->Refuse(check.Reason());
}

//----------------------------------------------------------------------------
vtkDataArray* vtkConditionalTerrainFilter::ChosenArray(
  int index, vtkInformationVector** inputVector, vtkDataSet* data, std::string& reason)
{
  vtkInformation* choice = this->GetInputArrayInformation(index);
  vtkDataArray* array = this->GetInputArrayToProcess(index, inputVector);
  if (!array && littoral::NamesDefaultElevation(choice))
  {
    array = data->GetPointData()->GetScalars();
  }
  const char* name = choice->Get(vtkDataObject::FIELD_NAME());
  const char* owner = index == 1 ? "The Grid" : "Data";
  if (!array && name && !littoral::NamesNoArray(choice) && !littoral::NamesDefaultElevation(choice))
  {
    reason = std::string(owner) + (index == 1 ? " has" : " have") + " no array '" + name + "'.";
  }
  littoral::ArrayReader reader = littoral::ArrayReader::OfPoints(data, owner);
  array = array ? reader.Fit(array, 1) : nullptr;
  reason = reason.empty() ? reader.Reason() : reason;
  return array;
}

//----------------------------------------------------------------------------
bool vtkConditionalTerrainFilter::ReadData(vtkInformationVector** inputVector, Survey& survey)
{
  std::string reason;
  vtkDataSet* data = nullptr;
  survey.IsRaster = ImageAmongData(inputVector[0]) != nullptr;
  if (survey.IsRaster)
  {
    auto* image = littoral::InputOf<vtkImageData>(inputVector[0], "Data", reason);
    reason = image ? littoral::WhyNoRaster(image, 1) : reason;
    data = image;
  }
  else
  {
    data = littoral::InputOf<vtkPointSet>(inputVector[0], "Data", reason);
  }
  vtkDataArray* values = data && reason.empty() ? this->ChosenArray(0, inputVector, data, reason) : nullptr;
  vtkDataArray* errors = nullptr;
  if (data && reason.empty() && !this->ErrorArray.empty() && this->ErrorArray != "None")
  {
    littoral::ArrayReader reader = littoral::ArrayReader::OfPoints(data, "Data");
    errors = reader.Need(this->ErrorArray.c_str(), 1);
    reason = reader.Reason();
  }
  if (survey.IsRaster && !values && reason.empty())
  {
    reason = "Data is an image without a point array of values.";
  }
  if (errors && this->NormalScores && reason.empty())
  {
    reason = "Measurement errors have no meaning for normal scores; set ErrorArray to None, or turn NormalScores off.";
  }
  if (!this->Refuse(reason))
  {
    return false;
  }
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
        return this->Refuse("Datum " + std::to_string(n) + " has the error " + littoral::TextOf(error) +
          "; standard deviations of errors must be at least 0.");
      }
      survey.Data.ErrorVariances.push_back(error * error);
    }
  }
  survey.Measured = survey.Data.Values;
  return true;
}

//----------------------------------------------------------------------------
bool vtkConditionalTerrainFilter::ReadGrid(vtkInformationVector** inputVector, Survey& survey)
{
  std::string reason;
  auto* grid = littoral::OptionalInputOf<vtkImageData>(inputVector[1], "Grid", reason);
  reason = grid ? littoral::WhyNoRaster(grid, 1) : reason;
  if (!this->Refuse(reason))
  {
    return false;
  }
  survey.IsRaster = survey.IsRaster && !grid;
  grid = survey.IsRaster ? ImageAmongData(inputVector[0]) : grid;
  if (grid)
  {
    const int* extent = grid->GetExtent();
    survey.Window = { { extent[0], extent[2] }, { extent[1], extent[3] } };
    survey.Layer = extent[4];
    survey.Grid = { { grid->GetOrigin()[0], grid->GetOrigin()[1] }, { grid->GetSpacing()[0], grid->GetSpacing()[1] } };
    survey.OriginZ = grid->GetOrigin()[2];
    survey.SpacingZ = grid->GetSpacing()[2];
    return true;
  }
  const auto& places = survey.Data.Places;
  if (places.empty())
  {
    return this->Refuse("There are no data; at least one is needed.");
  }
  std::array<double, 2> low{ places[0].X, places[0].Y };
  std::array<double, 2> high = low;
  for (const littoral::KrigingPlace& place : places)
  {
    low = { std::min(low[0], place.X), std::min(low[1], place.Y) };
    high = { std::max(high[0], place.X), std::max(high[1], place.Y) };
  }
  const double longer = std::max(high[0] - low[0], high[1] - low[1]);
  // Around one place alone: as far as the field is correlated.
  const double margin = longer > 0.0 ? Margin * longer : this->Range;
  for (int axis = 0; axis < 2; ++axis)
  {
    survey.Window.Last[axis] = this->Dimensions[axis] - 1;
    survey.Grid.Origin[axis] = low[axis] - margin;
    survey.Grid.Spacing[axis] = (high[axis] - low[axis] + 2.0 * margin) / survey.Window.Last[axis];
  }
  return true;
}

//----------------------------------------------------------------------------
bool vtkConditionalTerrainFilter::ReadDrift(vtkInformationVector** inputVector, Survey& survey)
{
  littoral::SnapToGrid(survey.Grid, survey.Data.Places);
  if (this->KrigingType != ExternalDrift)
  {
    return true;
  }
  std::string reason;
  auto* grid = littoral::OptionalInputOf<vtkImageData>(inputVector[1], "Grid", reason);
  vtkDataArray* drift = grid ? this->ChosenArray(1, inputVector, grid, reason) : nullptr;
  reason = reason.empty() && !drift ? "An external drift needs a Grid with a point array." : reason;
  if (!this->Refuse(reason))
  {
    return false;
  }
  survey.Drift.resize(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  for (std::size_t n = 0; n < survey.Drift.size(); ++n)
  {
    survey.Drift[n] = drift->GetComponent(static_cast<vtkIdType>(n), 0);
    if (!littoral::IsSensible(survey.Drift[n]))
    {
      return this->Refuse("The drift at point " + std::to_string(n) + " of the Grid is " +
        littoral::TextOf(survey.Drift[n]) + "; it must be finite.");
    }
  }
  for (std::size_t n = 0; n < survey.Data.Places.size(); ++n)
  {
    littoral::KrigingPlace& place = survey.Data.Places[n];
    place.External = BetweenPoints(survey.Drift, survey.Grid, survey.Window, place);
    if (std::isnan(place.External))
    {
      return this->Refuse("Datum " + std::to_string(n) + " is outside the Grid, where there is no external drift.");
    }
  }
  return true;
}

//----------------------------------------------------------------------------
bool vtkConditionalTerrainFilter::TakeFit(vtkTable* fits, Survey& survey)
{
  if (fits->GetNumberOfRows() == 0)
  {
    return this->Refuse("The table of fits is empty; connect the first output of a covariance fit.");
  }
  littoral::ArrayReader rows = littoral::ArrayReader::OfRows(fits, "The table of fits");
  const auto take = [&rows](const char* column, double& value) {
    vtkDataArray* array = rows.Find(column, 1);
    value = array ? array->GetComponent(0, 0) : value;
  };
  double model = -1.0;
  take("ModelId", model);
  if (!(model >= 0.0) && rows.IsGood())
  {
    return this->Refuse(
      "The table of fits has no column ModelId with a model; connect the first output of a covariance fit.");
  }
  std::string reason = rows.Reason();
  littoral::ReadWhole("ModelId", model, 0, littoral::NumberOfCovarianceModels - 1, survey.Model.Field.Model, reason);
  take("Variance", survey.Model.Field.Variance);
  take("Range", survey.Model.Field.Range);
  take("SecondRange", survey.Model.Field.SecondRange);
  take("FractalDimension", survey.Model.Field.FractalDimension);
  take("Nugget", survey.Model.Nugget);
  take("AnisotropyRatio", survey.Model.AnisotropyRatio);
  take("AnisotropyAngle", survey.Model.AnisotropyAngle);
  take("Mean", survey.Mean);
  return this->Refuse(reason.empty() ? rows.Reason() : reason);
}

//----------------------------------------------------------------------------
bool vtkConditionalTerrainFilter::FindModel(vtkInformationVector** inputVector, Survey& survey)
{
  littoral::KrigingModel& model = survey.Model;
  model.Field.Model = static_cast<littoral::CovarianceModel>(std::max(0, this->Model));
  model.Field.Variance = this->NormalScores ? 1.0 : this->StandardDeviation * this->StandardDeviation;
  model.Field.Range = this->Range;
  model.Field.SecondRange = this->SecondRange;
  model.Field.FractalDimension = this->FractalDimension;
  model.Nugget = this->Nugget;
  model.AnisotropyRatio = this->AnisotropyRatio;
  model.AnisotropyAngle = vtkMath::RadiansFromDegrees(this->AnisotropyAngle);
  survey.Mean = this->Mean;

  std::string reason;
  auto* fits = littoral::OptionalInputOf<vtkTable>(inputVector[2], "Fits", reason);
  if (!this->Refuse(reason) || (fits && !this->TakeFit(fits, survey)) ||
    !this->Refuse(littoral::WhyInvalid(survey.Model)) || !this->Refuse(littoral::WhyInvalid(survey.Data, survey.Model)))
  {
    return false;
  }
  if (this->NormalScores)
  {
    survey.Scores.emplace(survey.Data.Values);
    if (survey.Scores->IsEmpty())
    {
      return this->Refuse("All data have the same value, which has no normal score; turn NormalScores off.");
    }
    for (double& value : survey.Data.Values)
    {
      value = survey.Scores->ScoreOf(value);
    }
  }
  survey.Mean = this->KrigingType != Simple || survey.Scores ? 0.0 : survey.Mean;
  const std::size_t count = survey.Data.Places.size();
  const auto asked = static_cast<std::size_t>(this->NumberOfNeighbors);
  survey.Neighbors = asked > 0 ? std::min(asked, count) : count <= MostForAll ? count : UsualNeighbors;
  return fits || this->Model != FittedToData || this->TakeFitted(survey);
}

//----------------------------------------------------------------------------
bool vtkConditionalTerrainFilter::TakeFitted(Survey& survey)
{
  const auto parallel = littoral::AbortableFor(this);
  std::string reason;
  littoral::KrigingOptions options;
  options.Type = static_cast<littoral::KrigingType>(this->KrigingType);
  options.Neighbors = survey.Neighbors;
  options.Low = options.High = survey.Data.Places[0];
  const std::size_t step = (survey.Data.Places.size() + PlacesTried - 1) / PlacesTried;
  for (const littoral::KrigingModel& model : littoral::FitToData(survey.Data, options.Type, reason, parallel))
  {
    survey.Model = model;
    try
    {
      const littoral::Kriging kriging(model, survey.Data, options, parallel);
      double estimate = 0.0;
      for (std::size_t n = 0; kriging.GetNeighbors() < survey.Data.Places.size() && n < survey.Data.Places.size();
           n += step)
      {
        kriging.Estimate(&survey.Data.Places[n], 1, &estimate);
      }
      return true;
    }
    catch (const littoral::KrigingFailure& failure)
    {
      reason = reason.empty() ? failure.what() : reason;
    }
  }
  return this->Refuse(reason);
}

//----------------------------------------------------------------------------
bool vtkConditionalTerrainFilter::CheckMemory(const Survey& survey, const int extent[6])
{
  const double width = std::max(0.0, extent[1] - static_cast<double>(extent[0]) + 1.0);
  const double height = std::max(0.0, extent[3] - static_cast<double>(extent[2]) + 1.0);
  const double grid = width * height * sizeof(double) * (this->KrigingVariance ? 2 : 1);
  const double data = littoral::Kriging::MemoryFor(survey.Data.Places.size(), survey.Neighbors);
  if (grid + data <= littoral::AvailableMemory())
  {
    return true;
  }
  return this->Refuse("A field of " + littoral::TextOf(width) + " x " + littoral::TextOf(height) + " points from " +
    std::to_string(survey.Data.Places.size()) + " data needs " + littoral::TextOf((grid + data) / 0x1p30) +
    " GiB, more than this machine has free. Take fewer points, or a NumberOfNeighbors.");
}

//----------------------------------------------------------------------------
bool vtkConditionalTerrainFilter::Make(Survey& survey, const int extent[6], vtkImageData* output, vtkTable* table)
{
  const bool simulates = this->Result == ConditionalField;
  const auto parallel = littoral::AbortableFor(this);
  Simulation simulation;
  littoral::KrigingData differences = survey.Data;
  std::vector<double>& atData = simulation.AtData;
  atData.assign(survey.Data.Places.size(), 0.0);
  if (simulates)
  {
    littoral::TurningBandsParameters bands;
    bands.Field = survey.Model.Field;
    bands.AnisotropyRatio = survey.Model.AnisotropyRatio;
    bands.AnisotropyAngle = survey.Model.AnisotropyAngle;
    bands.Seed = this->Seed;
    bands.NumberOfLines = this->NumberOfLines > 0 ? this->NumberOfLines : 1;
    const std::string reason = littoral::WhyInvalid(bands, survey.Grid);
    if (!reason.empty())
    {
      throw littoral::KrigingFailure(reason);
    }
    bands.NumberOfLines =
      this->NumberOfLines > 0 ? this->NumberOfLines : littoral::EnoughLines(bands, survey.Grid, survey.Window);
    littoral::TurningBandsField& field = simulation.Field.emplace(bands, survey.Grid, survey.Window);
    if (!littoral::RunWithProgress(
          this, field.GetNumberOfLines(), 0.0, 0.2, [&](std::size_t line) { field.TabulateLine(line); }))
    {
      return false;
    }
    atData = littoral::FieldAtData(field, bands, survey.Grid, survey.Window, survey.Data.Places, parallel);
    // What a measurement would have read of the simulated field
    const littoral::RandomStream errors(this->Seed, littoral::RandomPurpose::DatumErrors);
    for (std::size_t n = 0; n < atData.size(); ++n)
    {
      const double noise = survey.Model.Nugget + survey.Data.ErrorVariance(n);
      differences.Values[n] -= atData[n] + (noise > 0.0 ? std::sqrt(noise) * errors.NormalPair(n, 0)[0] : 0.0);
    }
  }
  for (double& value : differences.Values)
  {
    value -= survey.Mean;
  }
  littoral::KrigingOptions options;
  options.Type = static_cast<littoral::KrigingType>(this->KrigingType);
  options.Neighbors = survey.Neighbors;
  options.Low = littoral::PlaceOfPoint(survey.Grid, survey.Window.First[0], survey.Window.First[1]);
  options.High = littoral::PlaceOfPoint(survey.Grid, survey.Window.Last[0], survey.Window.Last[1]);
  simulation.Differences = std::make_unique<littoral::Kriging>(survey.Model, std::move(differences), options, parallel);
  this->UpdateProgress(0.3);

  const auto width = static_cast<std::size_t>(std::max(0, extent[1] - extent[0] + 1));
  const auto height = static_cast<std::size_t>(std::max(0, extent[3] - extent[2] + 1));
  const auto points = static_cast<vtkIdType>(width) * static_cast<vtkIdType>(height);
  auto values = littoral::NewArray<vtkDoubleArray>(survey.Name.c_str(), 1, points);
  auto variances = littoral::NewArray<vtkDoubleArray>("KrigingVariance", 1, this->KrigingVariance ? points : 0);
  const auto fullWidth = static_cast<std::size_t>(survey.Window.Last[0] - survey.Window.First[0]) + 1;
  const bool done = littoral::RunWithProgress(
    this, width > 0 ? (height + RowsAtOnce - 1) / RowsAtOnce : 0, 0.3, 0.95, [&](std::size_t piece) {
      const int first = extent[2] + static_cast<int>(piece) * RowsAtOnce;
      const int last = std::min(first + RowsAtOnce - 1, extent[3]);
      std::vector<float> simulated;
      if (simulates)
      {
        simulated.resize(fullWidth * (last - first + 1));
        simulation.Field->FillRows(first, last, 1.0, 0.0, simulated.data());
      }
      std::vector<littoral::KrigingPlace> places;
      std::vector<vtkIdType> ids;
      std::vector<double> offsets;
      for (int j = first; j <= last; ++j)
      {
        for (int i = extent[0]; i <= extent[1]; ++i)
        {
          const vtkIdType id = (j - extent[2]) * static_cast<vtkIdType>(width) + (i - extent[0]);
          const std::size_t whole = survey.Index(i, j);
          if (survey.IsRaster && !std::isnan(survey.Raster[whole]))
          {
            values->SetValue(id, survey.Raster[whole]);
            if (this->KrigingVariance)
            {
              variances->SetValue(id, 0.0);
            }
            continue;
          }
          places.push_back(littoral::PlaceOfPoint(survey.Grid, i, j));
          places.back().External = survey.Drift.empty() ? 0.0 : survey.Drift[whole];
          ids.push_back(id);
          offsets.push_back(simulates ? simulated[(j - first) * fullWidth + (i - survey.Window.First[0])] : 0.0);
        }
      }
      std::vector<double> kriged(places.size());
      std::vector<double> own(this->KrigingVariance ? places.size() : 0);
      simulation.Differences->Estimate(
        places.data(), places.size(), kriged.data(), this->KrigingVariance ? own.data() : nullptr);
      for (std::size_t n = 0; n < ids.size(); ++n)
      {
        values->SetValue(ids[n], survey.Back(survey.Mean + offsets[n] + kriged[n]));
        if (this->KrigingVariance)
        {
          variances->SetValue(ids[n], own[n]);
        }
      }
    });
  if (!done)
  {
    return false;
  }
  if (table)
  {
    this->WriteTable(survey, simulation, table);
  }
  output->GetPointData()->SetScalars(values);
  if (this->KrigingVariance)
  {
    output->GetPointData()->AddArray(variances);
  }
  littoral::AddField(output, "KrigingNeighbors", { static_cast<double>(survey.Neighbors) });
  return true;
}

//----------------------------------------------------------------------------
void vtkConditionalTerrainFilter::WriteTable(const Survey& survey, const Simulation& simulation, vtkTable* table)
{
  const std::size_t count = survey.Data.Places.size();
  const auto parallel = littoral::AbortableFor(this);
  struct Row
  {
    std::size_t Index;
    double Field;
    littoral::LeftOut Left;
    double Error;
  };
  std::vector<Row> rows(count);
  parallel(count, [&](std::size_t begin, std::size_t end) {
    std::vector<double> kriged(end - begin);
    simulation.Differences->Estimate(&survey.Data.Places[begin], end - begin, kriged.data());
    for (std::size_t n = begin; n < end; ++n)
    {
      rows[n] = { n, survey.Back(survey.Mean + simulation.AtData[n] + kriged[n - begin]), { NaN, NaN }, NaN };
    }
  });
  const auto column = [&](const char* name, auto valueOf) { littoral::AddColumn(table, name, rows, valueOf); };
  column("X", [&](const Row& row) { return survey.Data.Places[row.Index].X; });
  column("Y", [&](const Row& row) { return survey.Data.Places[row.Index].Y; });
  column("Value", [&](const Row& row) { return survey.Measured[row.Index]; });
  column("Field", [](const Row& row) { return row.Field; });
  const littoral::CovarianceParameters& field = survey.Model.Field;
  littoral::AddText(table, "Model", littoral::CovarianceModelName(field.Model));
  littoral::AddField(table, "ModelId", { static_cast<double>(field.Model) });
  for (const auto* parameter : littoral::AllCovarianceParameters())
  {
    const bool has = littoral::TraitsOf(field.Model).Parameters.Has(parameter->Name);
    littoral::AddField(table, parameter->Name, { has ? parameter->Get(field) : NaN });
  }
  littoral::AddField(table, "Nugget", { survey.Model.Nugget });
  if (!this->CrossValidation)
  {
    return;
  }
  // Of the data themselves, not of their differences from the simulated field
  littoral::KrigingOptions options;
  options.Type = static_cast<littoral::KrigingType>(this->KrigingType);
  options.Neighbors = survey.Neighbors;
  options.Low = options.High = survey.Data.Places[0];
  littoral::KrigingData data = survey.Data;
  for (double& value : data.Values)
  {
    value -= survey.Mean;
  }
  const littoral::Kriging kriging(survey.Model, std::move(data), options, parallel);
  const std::vector<littoral::LeftOut> left = kriging.LeaveOneOut(parallel);
  double sum = 0.0;
  double squares = 0.0;
  double standardized = 0.0;
  double known = 0.0;
  for (Row& row : rows)
  {
    row.Left = left[row.Index];
    row.Left.Estimate += survey.Mean;
    const double error = survey.Data.Values[row.Index] - row.Left.Estimate;
    row.Error = error / std::sqrt(row.Left.Variance);
    if (std::isfinite(row.Error))
    {
      const double measured = survey.Measured[row.Index] - survey.Back(row.Left.Estimate);
      known += 1.0;
      sum += measured;
      squares += measured * measured;
      standardized += row.Error * row.Error;
    }
  }
  column("LeftOutEstimate",
    [&](const Row& row) { return std::isnan(row.Left.Estimate) ? NaN : survey.Back(row.Left.Estimate); });
  column("LeftOutDeviation", [](const Row& row) { return std::sqrt(row.Left.Variance); });
  column("StandardizedError", [](const Row& row) { return row.Error; });
  littoral::AddField(table, "MeanError", { sum / known });
  littoral::AddField(table, "RootMeanSquareError", { std::sqrt(squares / known) });
  littoral::AddField(table, "MeanSquaredStandardizedError", { standardized / known });
}

//----------------------------------------------------------------------------
void vtkConditionalTerrainFilter::WritePoints(const Survey& survey, vtkTable* table, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  for (std::size_t n = 0; n < survey.Measured.size(); ++n)
  {
    const littoral::KrigingPlace& place = survey.Data.Places[n];
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

//----------------------------------------------------------------------------
int vtkConditionalTerrainFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  littoral::ForgetExtent(info);
  vtkImageData* output = vtkImageData::GetData(outputVector, 0);
  vtkTable* table = vtkTable::GetData(outputVector, 1);
  vtkPolyData* points = vtkPolyData::GetData(outputVector, 2);
  output->Initialize();
  table->Initialize();
  points->Initialize();
  if (littoral::IsAnnouncedEmpty(info))
  {
    return littoral::FailedRequest(this);
  }
  Survey survey;
  if (!this->CheckProperties() || !this->ReadData(inputVector, survey) || !this->ReadGrid(inputVector, survey) ||
    !this->ReadDrift(inputVector, survey) || !this->FindModel(inputVector, survey))
  {
    return littoral::FailedRequest(this);
  }
  std::array<int, 6> extent = littoral::RequestedExtent(info);
  if (!this->CheckMemory(survey, extent.data()))
  {
    return littoral::FailedRequest(this);
  }
  output->SetExtent(extent.data());
  output->SetOrigin(survey.Grid.Origin[0], survey.Grid.Origin[1], survey.OriginZ);
  output->SetSpacing(survey.Grid.Spacing[0], survey.Grid.Spacing[1], survey.SpacingZ);
  info->Set(vtkDataObject::ORIGIN(), output->GetOrigin(), 3);
  info->Set(vtkDataObject::SPACING(), output->GetSpacing(), 3);
  this->SetProgressText("Making a field through data");
  bool done = false;
  try
  {
    done =
      this->Make(survey, extent.data(), output, littoral::AsksForLaterPiece(request, outputVector) ? nullptr : table);
  }
  catch (const littoral::KrigingFailure& failure)
  {
    output->Initialize();
    table->Initialize();
    this->Refuse(failure.what());
    return littoral::FailedRequest(this);
  }
  if (!done) // aborted
  {
    output->Initialize();
    table->Initialize();
    return 1;
  }
  if (table->GetNumberOfRows() > 0)
  {
    this->WritePoints(survey, table, points);
  }
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
int vtkConditionalTerrainFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(
    this, request, [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkConditionalTerrainFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ErrorArray: " << this->ErrorArray << "\n";
  os << indent << "Result: " << this->Result << "\n";
  os << indent << "KrigingType: " << this->KrigingType << "\n";
  os << indent << "Model: " << this->Model << "\n";
  os << indent << "StandardDeviation: " << this->StandardDeviation << "\n";
  os << indent << "Mean: " << this->Mean << "\n";
  os << indent << "Range: " << this->Range << "\n";
  os << indent << "SecondRange: " << this->SecondRange << "\n";
  os << indent << "FractalDimension: " << this->FractalDimension << "\n";
  os << indent << "Nugget: " << this->Nugget << "\n";
  os << indent << "AnisotropyRatio: " << this->AnisotropyRatio << "\n";
  os << indent << "AnisotropyAngle: " << this->AnisotropyAngle << "\n";
  os << indent << "Dimensions: " << this->Dimensions[0] << " " << this->Dimensions[1] << "\n";
  os << indent << "NumberOfNeighbors: " << this->NumberOfNeighbors << "\n";
  os << indent << "NormalScores: " << (this->NormalScores ? "on" : "off") << "\n";
  os << indent << "KrigingVariance: " << (this->KrigingVariance ? "on" : "off") << "\n";
  os << indent << "CrossValidation: " << (this->CrossValidation ? "on" : "off") << "\n";
  os << indent << "NumberOfLines: " << this->NumberOfLines << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
