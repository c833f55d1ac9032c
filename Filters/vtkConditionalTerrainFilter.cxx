// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkConditionalTerrainFilter.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/FieldStatistics.h"
#include "Data/Georeference.h"
#include "Data/Inputs.h"
#include "Data/Survey.h"
#include "Data/SurveyTable.h"
#include "Data/Tables.h"
#include "Kriging/ConditionalField.h"
#include "Kriging/CrossValidation.h"
#include "Kriging/DataVariogram.h"
#include "Kriging/FieldAtData.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Mistakes.h"
#include "Pipeline/Pipeline.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

vtkStandardNewMacro(vtkConditionalTerrainFilter);

namespace
{

/// Standard deviations whose squares are sensible.
constexpr littoral::ValueInterval Deviations = littoral::ValueInterval::From(1e-15, 3e7);

/// Image at the first port, null for other data.
vtkImageData* ImageAmongData(vtkInformationVector* inputs)
{
  return vtkImageData::SafeDownCast(vtkDataObject::GetData(inputs));
}

/// The image whose points the field has; null where it spans the data.
vtkImageData* GridAmongInputs(vtkInformationVector** inputs)
{
  auto* grid = vtkImageData::SafeDownCast(vtkDataObject::GetData(inputs[1]));
  return grid ? grid : ImageAmongData(inputs[0]);
}

}

//----------------------------------------------------------------------------
vtkConditionalTerrainFilter::vtkConditionalTerrainFilter()
  : ErrorArray("None")
  , Result(ConditionalField)
  , KrigingType(Ordinary)
  , UseDataMean(true)
  , Nugget(0.0)
  , Dimensions{ 301, 301 }
  , NumberOfNeighbors(0)
  , NormalScores(false)
  , KrigingVariance(false)
  , CrossValidation(false)
{
  this->Model = FittedToData;
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(4);
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

//----------------------------------------------------------------------------
vtkConditionalTerrainFilter::~vtkConditionalTerrainFilter() = default;

//----------------------------------------------------------------------------
const char* vtkConditionalTerrainFilter::GetModelAsString() const
{
  return this->Model == FittedToData ? "FittedToData" : this->Superclass::GetModelAsString();
}

//----------------------------------------------------------------------------
void vtkConditionalTerrainFilter::SetErrorArray(const char* name)
{
  this->SetName(this->ErrorArray, name ? name : "None");
}

//----------------------------------------------------------------------------
void vtkConditionalTerrainFilter::SetDriftArray(const char* name)
{
  this->SetName(this->DriftArray, name ? name : "");
}

//----------------------------------------------------------------------------
void vtkConditionalTerrainFilter::SetName(std::string& own, const std::string& name)
{
  if (own != name)
  {
    own = name;
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
  constexpr const char* types[] = { "vtkImageData", "vtkTable", "vtkPolyData", "vtkTable" };
  info->Set(vtkDataObject::DATA_TYPE_NAME(), types[port]);
  return 1;
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
    littoral::Require(check.Reason());
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
    littoral::Refuse("The grid has no points.");
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
void vtkConditionalTerrainFilter::CheckProperties()
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
  littoral::Require(check.Reason());
}

//----------------------------------------------------------------------------
vtkDataArray* vtkConditionalTerrainFilter::ValueArray(vtkInformationVector** inputVector, vtkDataSet* data)
{
  vtkInformation* choice = this->GetInputArrayInformation(0);
  vtkDataArray* array = this->GetInputArrayToProcess(0, inputVector);
  if (!array && littoral::NamesDefaultElevation(choice))
  {
    array = data->GetPointData()->GetScalars();
  }
  const char* name = choice->Get(vtkDataObject::FIELD_NAME());
  if (!array && name && !littoral::NamesNoArray(choice) && !littoral::NamesDefaultElevation(choice))
  {
    littoral::Refuse("Data have no array '", name, "'.");
  }
  return littoral::ArrayReader::OfPoints(data, "Data").Fit(array, 1);
}

//----------------------------------------------------------------------------
void vtkConditionalTerrainFilter::ReadData(vtkInformationVector** inputVector, littoral::Survey& survey)
{
  vtkDataSet* data = nullptr;
  survey.IsRaster = ImageAmongData(inputVector[0]) != nullptr;
  if (survey.IsRaster)
  {
    auto* image = littoral::InputOf<vtkImageData>(inputVector[0], "Data");
    littoral::RequireRaster(image, 1);
    data = image;
  }
  else
  {
    data = littoral::InputOf<vtkPointSet>(inputVector[0], "Data");
  }
  vtkDataArray* values = this->ValueArray(inputVector, data);
  const bool hasErrors = !this->ErrorArray.empty() && this->ErrorArray != "None";
  vtkDataArray* errors =
    hasErrors ? littoral::ArrayReader::OfPoints(data, "Data").Need(this->ErrorArray.c_str(), 1) : nullptr;
  littoral::Require(survey.IsRaster && !values ? "Data is an image without a point array of values." : "");
  littoral::Require(errors && this->NormalScores
      ? "Measurement errors have no meaning for normal scores; set ErrorArray to None, or turn NormalScores off."
      : "");
  littoral::TakeData(data, values, errors, survey);
}

//----------------------------------------------------------------------------
void vtkConditionalTerrainFilter::ReadGrid(vtkInformationVector** inputVector, littoral::Survey& survey)
{
  auto* grid = littoral::OptionalInputOf<vtkImageData>(inputVector[1], "Grid");
  if (grid)
  {
    littoral::RequireRaster(grid, 1);
    survey.Raster.clear();
  }
  else if (survey.IsRaster)
  {
    grid = ImageAmongData(inputVector[0]);
  }
  if (grid)
  {
    littoral::TakeGrid(grid, survey);
    return;
  }
  // Around one place alone: as far as the field is correlated.
  littoral::SpanGrid({ this->Dimensions[0], this->Dimensions[1] }, this->Range, survey);
}

//----------------------------------------------------------------------------
void vtkConditionalTerrainFilter::ReadDrift(vtkInformationVector** inputVector, littoral::Survey& survey)
{
  littoral::SnapToGrid(survey.Grid, survey.Data.Places);
  if (this->KrigingType != ExternalDrift)
  {
    return;
  }
  auto* grid = littoral::OptionalInputOf<vtkImageData>(inputVector[1], "Grid");
  vtkDataArray* drift = nullptr;
  if (grid)
  {
    const littoral::ArrayReader reader = littoral::ArrayReader::OfPoints(grid, "The Grid");
    vtkDataArray* scalars = grid->GetPointData()->GetScalars();
    const bool isNamed = !this->DriftArray.empty();
    drift = isNamed ? reader.Need(this->DriftArray.c_str(), 1) : scalars ? reader.Fit(scalars, 1) : nullptr;
  }
  littoral::Require(drift
      ? ""
      : "An external drift is a point array of the Grid, but there is none; connect an image that has one as Grid.");
  littoral::TakeDrift(drift, survey);
}

//----------------------------------------------------------------------------
void vtkConditionalTerrainFilter::FindModel(vtkInformationVector** inputVector, littoral::Survey& survey)
{
  littoral::FieldStatistics statistics = this->OwnStatistics();
  statistics.Field.Model = static_cast<littoral::CovarianceModel>(std::max(0, this->Model));
  statistics.Field.Variance = this->NormalScores ? 1.0 : statistics.Field.Variance;
  statistics.Nugget = this->Nugget;
  auto* fits = littoral::OptionalInputOf<vtkTable>(inputVector[2], "Fits");
  if (fits)
  {
    littoral::TakeFit(fits, statistics);
  }
  littoral::TakeModel(statistics, survey);
  if (this->NormalScores)
  {
    littoral::TakeScores(survey);
  }
  littoral::TakeMean(this->UseDataMean && !fits, survey);
  littoral::TakeNeighbors(this->NumberOfNeighbors, survey);
  const littoral::ParallelFor parallel = littoral::AbortableFor(this);
  if (!fits && this->Model == FittedToData)
  {
    littoral::FitModel(survey, parallel);
  }
  else
  {
    survey.Variogram = littoral::DataVariogram(survey.Data, survey.Type, parallel);
  }
}

//----------------------------------------------------------------------------
void vtkConditionalTerrainFilter::CheckMemory(const littoral::Survey& survey, const int extent[6])
{
  const double width = std::max(0.0, extent[1] - static_cast<double>(extent[0]) + 1.0);
  const double height = std::max(0.0, extent[3] - static_cast<double>(extent[2]) + 1.0);
  littoral::RequireGridPoints("A field of " + std::to_string(survey.Data.Places.size()) + " data on " +
      (this->GetNumberOfInputConnections(1) > 0 || survey.IsRaster ? "a Grid of" : "Dimensions"),
    { width, height }, littoral::CostOfPoint(survey, this->KrigingVariance));
  const double bytes = littoral::MemoryOf(survey, width * height, this->KrigingVariance);
  littoral::RequireMemory(bytes,
    "A field of " + littoral::TextOf(width) + " x " + littoral::TextOf(height) + " points from " +
      std::to_string(survey.Data.Places.size()) + " data",
    "take fewer points, or a NumberOfNeighbors");
}

//----------------------------------------------------------------------------
void vtkConditionalTerrainFilter::Make(const littoral::Survey& survey, vtkImageData* output, vtkTable* table)
{
  littoral::ConditionalOptions options;
  options.Simulates = this->Result == ConditionalField;
  options.NumberOfLines = this->NumberOfLines;
  options.Seed = this->Seed;
  littoral::ConditionalField field(survey, options);
  field.Tabulate(littoral::AbortableFor(this, 0.0, 0.2));
  const littoral::ParallelFor parallel = littoral::AbortableFor(this);
  field.Solve(parallel);
  this->UpdateProgress(0.3);
  const vtkIdType points = output->GetNumberOfPoints();
  auto values = littoral::NewArray<vtkDoubleArray>(survey.Name.c_str(), 1, points);
  auto variances = littoral::NewArray<vtkDoubleArray>("KrigingVariance", 1, this->KrigingVariance ? points : 0);
  const int* extent = output->GetExtent();
  field.Fill({ { extent[0], extent[2] }, { extent[1], extent[3] } }, values->GetPointer(0),
    this->KrigingVariance ? variances->GetPointer(0) : nullptr, littoral::AbortableFor(this, 0.3, 0.95));
  output->GetPointData()->SetScalars(values);
  if (this->KrigingVariance)
  {
    output->GetPointData()->AddArray(variances);
  }
  littoral::AddField(output, "KrigingNeighbors", { static_cast<double>(survey.Neighbors) });
  if (table)
  {
    littoral::AddRows(survey, field.AtData(parallel), table);
    littoral::AddModel(survey, table);
  }
  if (table && this->CrossValidation)
  {
    littoral::AddCrossValidation(littoral::CrossValidate(survey, parallel), table);
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
  vtkTable* variogram = vtkTable::GetData(outputVector, 3);
  output->Initialize();
  table->Initialize();
  points->Initialize();
  variogram->Initialize();
  if (littoral::IsAnnouncedEmpty(info))
  {
    return littoral::FailedRequest(this);
  }
  littoral::Survey survey;
  survey.Type = static_cast<littoral::KrigingType>(this->KrigingType);
  this->CheckProperties();
  this->ReadData(inputVector, survey);
  this->ReadGrid(inputVector, survey);
  this->ReadDrift(inputVector, survey);
  this->FindModel(inputVector, survey);
  std::array<int, 6> extent = littoral::RequestedExtent(info);
  this->CheckMemory(survey, extent.data());
  output->SetExtent(extent.data());
  output->SetOrigin(survey.Grid.Origin[0], survey.Grid.Origin[1], survey.OriginZ);
  output->SetSpacing(survey.Grid.Spacing[0], survey.Grid.Spacing[1], survey.SpacingZ);
  info->Set(vtkDataObject::ORIGIN(), output->GetOrigin(), 3);
  info->Set(vtkDataObject::SPACING(), output->GetSpacing(), 3);
  if (vtkImageData* grid = GridAmongInputs(inputVector))
  {
    littoral::PassGeoreference(grid, output);
  }
  this->SetProgressText("Making a field through data");
  this->Make(survey, output, littoral::AsksForLaterPiece(request, outputVector) ? nullptr : table);
  if (table->GetNumberOfRows() > 0)
  {
    littoral::AddVariogram(survey, variogram);
  }
  if (table->GetNumberOfRows() > 0 && !survey.IsRaster) // an image shows its own points
  {
    littoral::WriteData(survey, table, points);
  }
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
void vtkConditionalTerrainFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ErrorArray: " << this->ErrorArray << "\n";
  os << indent << "DriftArray: " << this->DriftArray << "\n";
  os << indent << "Result: " << this->Result << "\n";
  os << indent << "KrigingType: " << this->KrigingType << "\n";
  os << indent << "UseDataMean: " << (this->UseDataMean ? "on" : "off") << "\n";
  os << indent << "Nugget: " << this->Nugget << "\n";
  os << indent << "Dimensions: " << this->Dimensions[0] << " " << this->Dimensions[1] << "\n";
  os << indent << "NumberOfNeighbors: " << this->NumberOfNeighbors << "\n";
  os << indent << "NormalScores: " << (this->NormalScores ? "on" : "off") << "\n";
  os << indent << "KrigingVariance: " << (this->KrigingVariance ? "on" : "off") << "\n";
  os << indent << "CrossValidation: " << (this->CrossValidation ? "on" : "off") << "\n";
}
