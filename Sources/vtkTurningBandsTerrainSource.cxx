// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTurningBandsTerrainSource.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/FieldStatistics.h"
#include "Data/Georeference.h"
#include "Data/Inputs.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Mistakes.h"
#include "Pipeline/Pipeline.h"
#include "Terrain/FieldWithTrend.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

vtkStandardNewMacro(vtkTurningBandsTerrainSource);

namespace
{
/// Standard deviations whose squares are sensible, besides 0.
constexpr littoral::ValueInterval Deviations = littoral::ValueInterval::From(1e-15, 3e7);

littoral::PlaneGrid PlaneOf(const double origin[3], const double spacing[3])
{
  return { { origin[0], origin[1] }, { spacing[0], spacing[1] } };
}

littoral::GridWindow WindowOf(const int extent[6])
{
  return { { extent[0], extent[2] }, { extent[1], extent[3] } };
}
}

/// One field in full: the numerics' parameters, and what is added to them.
class vtkTurningBandsTerrainSource::Recipe
{
public:
  littoral::TurningBandsParameters Bands;
  littoral::FieldTrend Trend;
  const char* Name = "";
  std::string Prefix;              ///< of the properties that each field has for itself
  const char* Unit = "";           ///< of its values
  std::optional<double> Deviation; ///< the standard deviation; none where a table gives the variance

  void Take(const littoral::FieldStatistics& statistics)
  {
    this->Bands.Field = statistics.Field;
    this->Bands.AnisotropyRatio = statistics.AnisotropyRatio;
    this->Bands.AnisotropyAngle = statistics.AnisotropyAngle;
    this->Trend = { statistics.Mean, statistics.Slope, statistics.TrendSides };
  }
};

//----------------------------------------------------------------------------
vtkTurningBandsTerrainSource::vtkTurningBandsTerrainSource()
  : WholeExtent{ 0, 500, 0, 500, 0, 0 }
  , Origin{ 0.0, 0.0, 0.0 }
  , Spacing{ 2.0, 2.0, 1.0 }
  , UseMeasuredGrid(false)
  , Slope{ 0.0, 0.0 }
  , NumberOfHarmonics(300)
  , HarmonicSpacing(Adaptive)
  , MinimumWavelength(0.0)
  , Reflectance(false)
  , ReflectanceModel(SimpleExponential)
  , ReflectanceRange(100.0)
  , ReflectanceMean(0.5)
  , ReflectanceStandardDeviation(0.15)
  , Grid{}
{
  this->SetNumberOfInputPorts(1);
}

//----------------------------------------------------------------------------
vtkTurningBandsTerrainSource::~vtkTurningBandsTerrainSource() = default;

//----------------------------------------------------------------------------
int vtkTurningBandsTerrainSource::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//----------------------------------------------------------------------------
std::string vtkTurningBandsTerrainSource::TakeGrid(vtkInformationVector* fits)
{
  std::copy_n(this->WholeExtent, 6, this->Grid.WholeExtent);
  std::copy_n(this->Origin, 3, this->Grid.Origin);
  std::copy_n(this->Spacing, 3, this->Grid.Spacing);
  vtkInformation* info = fits->GetInformationObject(0);
  if (!this->UseMeasuredGrid || !info)
  {
    return {};
  }
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (info->Has(Pipeline::WHOLE_EXTENT()) && info->Has(vtkDataObject::ORIGIN()) && info->Has(vtkDataObject::SPACING()))
  {
    info->Get(Pipeline::WHOLE_EXTENT(), this->Grid.WholeExtent);
    info->Get(vtkDataObject::ORIGIN(), this->Grid.Origin);
    info->Get(vtkDataObject::SPACING(), this->Grid.Spacing);
    return {};
  }
  // A table without the pipeline that made it.
  vtkDataObject* table = info->Get(vtkDataObject::DATA_OBJECT());
  const auto take = [table](const char* name, int count, auto* numbers) {
    vtkDataArray* array =
      table ? littoral::ArrayReader::OfFields(table, "The table of fits", 1).Seek(name, count) : nullptr;
    for (int i = 0; array && i < count; ++i)
    {
      numbers[i] = static_cast<std::decay_t<decltype(*numbers)>>(array->GetComponent(0, i));
    }
    return array != nullptr;
  };
  const bool isTaken = take("GridExtent", 6, this->Grid.WholeExtent) && take("GridOrigin", 3, this->Grid.Origin) &&
    take("GridSpacing", 3, this->Grid.Spacing);
  return isTaken ? "" : "UseMeasuredGrid is on, but the table of fits names no grid; connect a covariance fit.";
}

//----------------------------------------------------------------------------
int vtkTurningBandsTerrainSource::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  littoral::Require(this->TakeGrid(inputVector[0]));
  const int* extent = this->Grid.WholeExtent;
  if (extent[1] < extent[0] || extent[3] < extent[2])
  {
    littoral::Refuse("WholeExtent ", extent[0], " ", extent[1], " ", extent[2], " ", extent[3],
      " is empty: the last index of an axis must not be below the first.");
  }
  if (extent[5] != extent[4])
  {
    littoral::Refuse("WholeExtent has ", extent[5] - static_cast<long long>(extent[4]) + 1,
      " layers in z: a terrain has exactly one.");
  }
  littoral::ParameterCheck check;
  check.Positive("Spacing[0]", this->Grid.Spacing[0]);
  check.Positive("Spacing[1]", this->Grid.Spacing[1]);
  check.Finite("Spacing[2]", this->Grid.Spacing[2]);
  check.Finite("Origin[2]", this->Grid.Origin[2]);
  littoral::Require(check.Reason());
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), this->Grid.WholeExtent, 6);
  info->Set(vtkDataObject::ORIGIN(), this->Grid.Origin, 3);
  info->Set(vtkDataObject::SPACING(), this->Grid.Spacing, 3);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 1);
  return 1;
}

//----------------------------------------------------------------------------
int vtkTurningBandsTerrainSource::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // Each piece of the terrain needs the whole table, also on the ranks beyond the first.
  littoral::RequestAll(inputVector[0]->GetInformationObject(0));
  return 1;
}

//----------------------------------------------------------------------------
vtkTurningBandsTerrainSource::Recipe vtkTurningBandsTerrainSource::ElevationRecipe() const
{
  Recipe recipe;
  recipe.Name = "Elevation";
  recipe.Unit = "m";
  recipe.Deviation = this->StandardDeviation;
  littoral::FieldStatistics statistics = this->OwnStatistics();
  statistics.Slope = { this->Slope[0], this->Slope[1] };
  recipe.Take(statistics);
  littoral::TurningBandsParameters& bands = recipe.Bands;
  bands.NumberOfLines = this->NumberOfLines;
  bands.NumberOfHarmonics = this->NumberOfHarmonics;
  bands.Bins = this->HarmonicSpacing == Uniform ? littoral::HarmonicBins::Uniform : littoral::HarmonicBins::Adaptive;
  bands.MinimumWavelength = this->MinimumWavelength;
  bands.Seed = this->Seed;
  bands.Purpose = littoral::RandomPurpose::ElevationLines;
  return recipe;
}

//----------------------------------------------------------------------------
vtkTurningBandsTerrainSource::Recipe vtkTurningBandsTerrainSource::ReflectanceRecipe() const
{
  Recipe recipe = this->ElevationRecipe();
  recipe.Name = "Reflectance";
  recipe.Prefix = recipe.Name;
  recipe.Unit = "";
  recipe.Deviation = this->ReflectanceStandardDeviation;
  recipe.Trend.Mean = this->ReflectanceMean;
  recipe.Trend.Slope = { 0.0, 0.0 };
  littoral::TurningBandsParameters& bands = recipe.Bands;
  bands.Field.Model = static_cast<littoral::CovarianceModel>(this->ReflectanceModel);
  bands.Field.Variance = this->ReflectanceStandardDeviation * this->ReflectanceStandardDeviation;
  bands.Field.Range = this->ReflectanceRange;
  bands.Field.SecondRange = std::max(0.1 * this->ReflectanceRange, littoral::MinimumMagnitude);
  bands.AnisotropyRatio = 1.0;
  bands.Purpose = littoral::RandomPurpose::ReflectanceLines;
  return recipe;
}

//----------------------------------------------------------------------------
void vtkTurningBandsTerrainSource::TakeFit(vtkTable* fits, Recipe& recipe)
{
  littoral::FieldStatistics statistics = this->OwnStatistics();
  statistics.Slope = { this->Slope[0], this->Slope[1] };
  littoral::TakeFit(fits, statistics);
  recipe.Take(statistics);
  recipe.Deviation = statistics.HasFittedVariance ? std::nullopt : recipe.Deviation;
}

//----------------------------------------------------------------------------
void vtkTurningBandsTerrainSource::CheckRecipe(Recipe& recipe)
{
  const littoral::PlaneGrid grid = PlaneOf(this->Grid.Origin, this->Grid.Spacing);
  littoral::TurningBandsParameters& bands = recipe.Bands;
  const bool automatic = bands.NumberOfLines == 0;
  bands.NumberOfLines = automatic ? 1 : bands.NumberOfLines; // until the rest is known to be good
  const double deviation = recipe.Deviation.value_or(0.0);
  littoral::ParameterCheck check;
  check.Require(deviation == 0.0 || Deviations.Contains(deviation), recipe.Prefix + "StandardDeviation", deviation,
    recipe.Unit, "0, or " + Deviations.Words(recipe.Unit));
  check.Require(bands.NumberOfLines > 0, "NumberOfLines", bands.NumberOfLines, "", "positive, or 0 for enough");
  check.Require(littoral::WhyInvalid(bands, grid, recipe.Prefix));
  check.Finite(recipe.Prefix + "Mean", recipe.Trend.Mean);
  check.Finite("Slope[0]", recipe.Trend.Slope[0]);
  check.Finite("Slope[1]", recipe.Trend.Slope[1]);
  check.NotNegative("TrendWidth", recipe.Trend.Sides[0]);
  check.NotNegative("TrendHeight", recipe.Trend.Sides[1]);
  littoral::Require(check.Reason());
  if (automatic)
  {
    // By the whole grid, not by the part that is asked for, so that all parts belong to one terrain.
    bands.NumberOfLines = littoral::EnoughLines(bands, grid, WindowOf(this->Grid.WholeExtent));
  }
}

//----------------------------------------------------------------------------
void vtkTurningBandsTerrainSource::Grow(
  const Recipe& recipe, const int extent[6], double first, double last, float* values)
{
  littoral::FieldWithTrend field(recipe.Bands, recipe.Trend, PlaneOf(this->Grid.Origin, this->Grid.Spacing),
    WindowOf(this->Grid.WholeExtent), WindowOf(extent));
  const double middle = 0.5 * (first + last);
  field.Tabulate(littoral::AbortableFor(this, first, middle));
  field.Fill(values, littoral::AbortableFor(this, middle, last));
}

//----------------------------------------------------------------------------
void vtkTurningBandsTerrainSource::CheckMemory(const int extent[6])
{
  const double width = extent[1] - static_cast<double>(extent[0]) + 1.0;
  const double height = extent[3] - static_cast<double>(extent[2]) + 1.0;
  littoral::RequireGridPoints("A terrain of WholeExtent", { width, height });
  const double bytes = width * height * sizeof(float) * (this->Reflectance ? 2 : 1);
  littoral::RequireMemory(bytes,
    "A terrain of " + littoral::TextOf(width) + " x " + littoral::TextOf(height) + " points",
    "take a smaller WholeExtent, or ask for a part of it");
}

//----------------------------------------------------------------------------
void vtkTurningBandsTerrainSource::GrowAll(
  const Recipe& elevation, const Recipe& reflectance, const int extent[6], vtkImageData* output)
{
  const vtkIdType count = output->GetNumberOfPoints();
  const auto grow = [&](const Recipe& recipe, double first, double last) {
    vtkNew<vtkFloatArray> values;
    values->SetName(recipe.Name);
    littoral::SetTuples(values, count);
    output->GetPointData()->AddArray(values);
    vtkNew<vtkIntArray> lines;
    lines->SetName((std::string(recipe.Name) + "Lines").c_str());
    lines->InsertNextValue(recipe.Bands.NumberOfLines);
    output->GetFieldData()->AddArray(lines);
    this->Grow(recipe, extent, first, last, values->GetPointer(0));
    return values.Get();
  };
  const double half = this->Reflectance ? 0.5 : 1.0;
  grow(elevation, 0.0, half);
  if (this->Reflectance)
  {
    vtkFloatArray* values = grow(reflectance, half, 1.0);
    for (vtkIdType i = 0; i < count; ++i)
    {
      values->SetValue(i, vtkMath::ClampValue(values->GetValue(i), 0.0f, 1.0f));
    }
  }
}

//----------------------------------------------------------------------------
int vtkTurningBandsTerrainSource::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  littoral::ForgetExtent(info);
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  if (littoral::IsAnnouncedEmpty(info))
  {
    return littoral::FailedRequest(this);
  }

  Recipe elevation = this->ElevationRecipe();
  Recipe reflectance = this->ReflectanceRecipe();
  vtkTable* fits = nullptr;
  littoral::InContext(std::string("Cannot grow ") + elevation.Name + ": ", [&] {
    fits = littoral::OptionalInputOf<vtkTable>(inputVector[0], "Input");
    if (fits)
    {
      this->TakeFit(fits, elevation);
    }
    this->CheckRecipe(elevation);
  });
  if (this->Reflectance)
  {
    littoral::InContext(std::string("Cannot grow ") + reflectance.Name + ": ", [&] { this->CheckRecipe(reflectance); });
  }

  std::array<int, 6> extent = littoral::RequestedExtent(info);
  this->CheckMemory(extent.data());
  output->SetExtent(extent.data());
  output->SetOrigin(this->Grid.Origin);
  output->SetSpacing(this->Grid.Spacing);
  if (fits && this->UseMeasuredGrid)
  {
    littoral::PassGeoreference(fits, output);
  }
  if (extent[1] < extent[0] || extent[3] < extent[2])
  {
    return 1; // a rank with nothing to do
  }
  this->SetProgressText("Growing terrain");
  this->GrowAll(elevation, reflectance, extent.data(), output);
  output->GetPointData()->SetActiveScalars(elevation.Name);
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
void vtkTurningBandsTerrainSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const int* extent = this->WholeExtent;
  os << indent << "WholeExtent: " << extent[0] << " " << extent[1] << " " << extent[2] << " " << extent[3] << " "
     << extent[4] << " " << extent[5] << "\n";
  os << indent << "Origin: " << this->Origin[0] << " " << this->Origin[1] << " " << this->Origin[2] << "\n";
  os << indent << "Spacing: " << this->Spacing[0] << " " << this->Spacing[1] << " " << this->Spacing[2] << "\n";
  os << indent << "UseMeasuredGrid: " << (this->UseMeasuredGrid ? "on" : "off") << "\n";
  os << indent << "Slope: " << this->Slope[0] << " " << this->Slope[1] << "\n";
  os << indent << "NumberOfHarmonics: " << this->NumberOfHarmonics << "\n";
  os << indent << "HarmonicSpacing: " << this->HarmonicSpacing << "\n";
  os << indent << "MinimumWavelength: " << this->MinimumWavelength << "\n";
  os << indent << "Reflectance: " << (this->Reflectance ? "on" : "off") << "\n";
  os << indent << "ReflectanceModel: " << this->ReflectanceModel << "\n";
  os << indent << "ReflectanceRange: " << this->ReflectanceRange << "\n";
  os << indent << "ReflectanceMean: " << this->ReflectanceMean << "\n";
  os << indent << "ReflectanceStandardDeviation: " << this->ReflectanceStandardDeviation << "\n";
}
