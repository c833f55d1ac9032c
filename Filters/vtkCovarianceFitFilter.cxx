// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCovarianceFitFilter.h"

#include "Data/Arrays.h"
#include "Data/Georeference.h"
#include "Data/Inputs.h"
#include "Data/Tables.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Pipeline.h"
#include "Terrain/DetrendedWindow.h"
#include "Terrain/FractalDimension.h"
#include "Terrain/GridSamples.h"
#include "Terrain/Variogram.h"
#include "Terrain/VariogramFit.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkCovarianceFitFilter);

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
/// Memory of a point: its value, and the correlations of all that are padded [bytes].
constexpr double BytesOfPoint = 120.0;
/// Fewer points along a side have no lags to speak of.
constexpr int SmallestSide = 8;
constexpr std::size_t FewestSamples = SmallestSide * SmallestSide;

littoral::GridSamples ReadSamples(vtkImageData* image, vtkDataArray* array, bool useNoData, double noData)
{
  littoral::GridSamples samples;
  int dimensions[3];
  image->GetDimensions(dimensions);
  samples.Width = dimensions[0];
  samples.Height = dimensions[1];
  samples.Spacing = { image->GetSpacing()[0], image->GetSpacing()[1] };
  littoral::SetSize(samples.Values, image->GetNumberOfPoints());
  for (std::size_t i = 0; i < samples.Values.size(); ++i)
  {
    const double value = array->GetComponent(static_cast<vtkIdType>(i), 0);
    const bool missing = !std::isfinite(value) || (useNoData && value == noData);
    samples.Values[i] = missing ? NaN : value;
  }
  return samples;
}

/// The trend that was removed, and the sides of the rectangle [m] over which; 0 for a mean alone.
struct RemovedTrend
{
  littoral::PlaneTrend Plane;
  double Width;
  double Height;
};

void WriteFits(const std::vector<littoral::VariogramFit>& fits, const RemovedTrend& trend,
  const littoral::DetrendedWindow& window, vtkTable* table)
{
  using Fit = littoral::VariogramFit;
  const auto column = [&](const char* name, auto valueOf) { littoral::AddColumn(table, name, fits, valueOf); };
  column("Model", [](const Fit& fit) { return std::string(littoral::CovarianceModelName(fit.Field.Model)); });
  column("ModelId", [](const Fit& fit) { return static_cast<int>(fit.Field.Model); });
  for (const auto* parameter : littoral::AllCovarianceParameters())
  {
    column(parameter->Name, [&](const Fit& fit) {
      return littoral::TraitsOf(fit.Field.Model).Parameters.Has(parameter->Name) ? parameter->Get(fit.Field) : NaN;
    });
  }
  column("Nugget", [](const Fit& fit) { return fit.Nugget; });
  column("AnisotropyRatio", [](const Fit& fit) { return fit.AnisotropyRatio; });
  column("AnisotropyAngle", [](const Fit& fit) { return fit.AnisotropyAngle; });
  column("Mean", [&](const Fit&) { return trend.Plane.Mean; });
  column("SlopeX", [&](const Fit&) { return trend.Plane.Slope[0]; });
  column("SlopeY", [&](const Fit&) { return trend.Plane.Slope[1]; });
  column("TrendWidth", [&](const Fit&) { return trend.Width; });
  column("TrendHeight", [&](const Fit&) { return trend.Height; });
  column("VarianceDeviation", [&](const Fit& fit) {
    return window.VarianceDeviation([&](double x, double y) { return littoral::Covariance(fit, x, y); });
  });
  column("AtBound", [](const Fit& fit) { return static_cast<int>(fit.AtBound); });
  column("WeightedSSE", [](const Fit& fit) { return fit.WeightedSSE; });
  column("AICc", [](const Fit& fit) { return fit.AICc; });
}

/// The grid that was measured, as field data.
void AddGrid(vtkImageData* image, vtkTable* table)
{
  int extent[6];
  image->GetExtent(extent);
  const double* origin = image->GetOrigin();
  const double* spacing = image->GetSpacing();
  littoral::AddField(table, "GridExtent",
    { double(extent[0]), double(extent[1]), double(extent[2]), double(extent[3]), double(extent[4]),
      double(extent[5]) });
  littoral::AddField(table, "GridOrigin", { origin[0], origin[1], origin[2] });
  littoral::AddField(table, "GridSpacing", { spacing[0], spacing[1], spacing[2] });
}

/// Fractal dimensions by two methods, as field data.
void AddDimensions(const littoral::GridSamples& samples, const littoral::VariogramMap& map,
  const littoral::ParallelFor& parallel, vtkTable* table)
{
  const littoral::DimensionEstimate periodogram = littoral::DimensionFromPeriodogram(samples, parallel);
  const littoral::DimensionEstimate slope = littoral::DimensionFromVariogram(map);
  littoral::AddField(table, "PeriodogramDimension", { periodogram.Dimension, periodogram.StandardError });
  littoral::AddField(table, "VariogramDimension", { slope.Dimension, slope.StandardError });
}

/// Semivariances in rings by the distance of pairs, and in sectors by their direction too.
struct MeasuredVariogram
{
  std::vector<littoral::LagBin> Rings;
  std::vector<littoral::LagBin> Sectors;
  int Directions; ///< 0: no sectors

  MeasuredVariogram(const littoral::VariogramMap& map, double maximumLag, int lags, int directions,
    const littoral::ParallelFor& parallel)
    : Rings(littoral::BinVariogram(map, maximumLag, lags, 1, parallel))
    , Directions(directions)
  {
    if (directions > 0)
    {
      this->Sectors = littoral::BinVariogram(map, maximumLag, lags, directions, parallel);
    }
  }

  const std::vector<littoral::LagBin>& GetBins() const { return this->Directions > 0 ? this->Sectors : this->Rings; }
};

void WriteVariogram(const MeasuredVariogram& variogram, const std::vector<littoral::VariogramFit>& fits,
  const littoral::DetrendedWindow& window, vtkTable* table)
{
  using littoral::LagBin;
  const std::vector<LagBin>& rings = variogram.Rings;
  const int directions = variogram.Directions;
  const auto column = [&](const char* name, auto valueOf) { littoral::AddColumn(table, name, rings, valueOf); };
  column("Lag", [](const LagBin& ring) { return ring.Lag; });
  column("Semivariance", [](const LagBin& ring) { return ring.Semivariance; });
  column("Pairs", [](const LagBin& ring) { return ring.Pairs; });
  const std::vector<std::vector<double>> change = window.SemivarianceChange(rings, 1);
  for (const littoral::VariogramFit& fit : fits)
  {
    const std::vector<double> covariances =
      window.CellCovariances([&](double x, double y) { return littoral::Covariance(fit, x, y); });
    column(littoral::CovarianceModelName(fit.Field.Model), [&](const LagBin& ring) {
      const std::vector<double>& weights = change[&ring - rings.data()];
      return std::inner_product(
        weights.begin(), weights.end(), covariances.begin(), littoral::MeanSemivariance(fit, ring.Lag));
    });
  }
  std::map<std::pair<int, int>, double> measured; // by direction and ring; a short ring may miss some directions
  for (const LagBin& sector : variogram.Sectors)
  {
    measured[{ sector.Direction, sector.Ring }] = sector.Semivariance;
  }
  for (int direction = 0; direction < directions; ++direction)
  {
    const std::string degrees = std::to_string(std::lround(180.0 * direction / directions)); // 0 to 180
    column(("Semivariance_" + std::string(3 - degrees.size(), '0') + degrees).c_str(), [&](const LagBin& ring) {
      const auto found = measured.find({ direction, ring.Ring });
      return found == measured.end() ? NaN : found->second;
    });
  }
}

}

/// Samples without their trend.
struct vtkCovarianceFitFilter::Detrended
{
  littoral::GridSamples Samples;
  littoral::SampleMoments Moments; ///< with the trend
  RemovedTrend Trend{ {}, 0.0, 0.0 };
  double Variance = 0.0;

  /// Length of a side [m].
  double Side(int axis) const
  {
    return ((axis == 0 ? this->Samples.Width : this->Samples.Height) - 1) * this->Samples.Spacing[axis];
  }
};

//----------------------------------------------------------------------------
vtkCovarianceFitFilter::vtkCovarianceFitFilter()
  : MaximumLag(0.0)
  , NumberOfLags(40)
  , RemoveTrend(true)
  , FitNugget(true)
  , FitAnisotropy(true)
  , NumberOfDirections(12)
  , MaximumRange(0.0)
  , FractalWavelength(0.0)
  , UseNoDataValue(false)
  , NoDataValue(-9999.0)
{
  this->SetNumberOfOutputPorts(2);
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

//----------------------------------------------------------------------------
vtkCovarianceFitFilter::~vtkCovarianceFitFilter() = default;

//----------------------------------------------------------------------------
int vtkCovarianceFitFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//----------------------------------------------------------------------------
int vtkCovarianceFitFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // Statistics of a part are not those of the whole: every rank reads all of the image.
  littoral::RequestAll(inputVector[0]->GetInformationObject(0));
  return 1;
}

//----------------------------------------------------------------------------
void vtkCovarianceFitFilter::CheckProperties()
{
  littoral::ParameterCheck check;
  check.NotNegative("MaximumLag", this->MaximumLag, "m");
  check.NotNegative("MaximumRange", this->MaximumRange, "m");
  check.NotNegative("FractalWavelength", this->FractalWavelength, "m");
  check.Count("NumberOfLags", this->NumberOfLags, 6, 10000);
  check.Count("NumberOfDirections", this->NumberOfDirections, 4, 90);
  littoral::Require(check.Reason());
}

//----------------------------------------------------------------------------
vtkDataArray* vtkCovarianceFitFilter::FindArray(vtkImageData* image, vtkInformationVector** inputVector)
{
  littoral::RequireRaster(image, SmallestSide);
  vtkDataArray* array = this->GetInputArrayToProcess(0, inputVector);
  vtkInformation* choice = this->GetInputArrayInformation(0);
  if (!array && littoral::NamesDefaultElevation(choice))
  {
    array = image->GetPointData()->GetScalars();
  }
  const char* name = choice->Get(vtkDataObject::FIELD_NAME());
  if (!array && name && !littoral::NamesNoArray(choice))
  {
    littoral::Refuse("The image has no array '", name, "' to fit.");
  }
  if (!array || array->GetNumberOfTuples() != image->GetNumberOfPoints() || array->GetNumberOfComponents() != 1)
  {
    littoral::Refuse(
      "The image has no scalar point array to fit", array ? ": the chosen one is a vector or lies on cells." : ".");
  }
  return array;
}

//----------------------------------------------------------------------------
void vtkCovarianceFitFilter::Detrend(vtkImageData* image, vtkDataArray* array, Detrended& field)
{
  littoral::GridSamples& samples = field.Samples;
  samples = ReadSamples(image, array, this->UseNoDataValue, this->NoDataValue);
  field.Moments = littoral::Moments(samples);
  const littoral::SampleMoments& moments = field.Moments;
  if (moments.Count < FewestSamples)
  {
    littoral::Refuse("The image has only ", moments.Count, " of ", samples.Values.size(),
      " values, the others are NaN or no-data; a fit needs at least ", FewestSamples, ".");
  }
  if (this->RemoveTrend)
  {
    field.Trend = { littoral::RemovePlane(samples), samples.Width * samples.Spacing[0],
      samples.Height * samples.Spacing[1] };
  }
  else
  {
    field.Trend.Plane = littoral::RemoveMean(samples);
  }
  field.Variance = littoral::Moments(samples).Variance;
  if (field.Variance <= 1e-20 * (moments.Variance + moments.Mean * moments.Mean))
  {
    littoral::Refuse(
      "The image is ", moments.Variance > 0.0 ? "a plane" : "constant", ": there is no variation to fit.");
  }
}

//----------------------------------------------------------------------------
littoral::VariogramFitOptions vtkCovarianceFitFilter::MakeOptions(
  const Detrended& field, const littoral::DetrendedWindow& window, double maximumLag)
{
  const double longestSide = std::max(field.Side(0), field.Side(1));
  littoral::VariogramFitOptions options;
  options.Nugget = this->FitNugget;
  options.Anisotropy = this->FitAnisotropy;
  options.MaximumRange = this->MaximumRange > 0.0 ? this->MaximumRange : maximumLag;
  options.FractalRange = this->FractalWavelength > 0.0 ? this->FractalWavelength : 4.0 * longestSide;
  options.Window = &window;
  options.SampleVariance = field.Variance;
  options.Directions = this->FitAnisotropy ? this->NumberOfDirections : 1;
  return options;
}

//----------------------------------------------------------------------------
int vtkCovarianceFitFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (littoral::AsksForLaterPiece(request, outputVector))
  {
    return 1;
  }
  auto* image =
    littoral::InContext("Cannot fit: ", [&] { return littoral::InputOf<vtkImageData>(inputVector[0], "Input"); });
  littoral::InContext("Cannot fit: ", [&] { littoral::RequireUpright(image, "Input"); });
  this->CheckProperties();
  vtkDataArray* array = this->FindArray(image, inputVector);
  littoral::RequireMemory(BytesOfPoint * static_cast<double>(image->GetNumberOfPoints()),
    "The image: its variogram takes all of it at once and", "take a part of it or a coarser one");
  this->SetProgressText("Fitting covariance models");
  Detrended field;
  this->Detrend(image, array, field);
  const double maximumLag = this->MaximumLag > 0.0 ? this->MaximumLag : 0.5 * std::min(field.Side(0), field.Side(1));
  const littoral::VariogramMap map =
    littoral::ComputeVariogramMap(field.Samples, maximumLag, littoral::AbortableFor(this));
  this->UpdateProgress(0.3);
  if (littoral::IsAborted(this))
  {
    return 1;
  }
  const MeasuredVariogram variogram(map, maximumLag, this->NumberOfLags,
    this->FitAnisotropy ? this->NumberOfDirections : 0, littoral::AbortableFor(this));
  const littoral::DetrendedWindow window(
    field.Samples, this->RemoveTrend ? littoral::Trend::Plane : littoral::Trend::Mean);
  const std::vector<littoral::VariogramFit> fits = littoral::FitAllModels(
    variogram.GetBins(), this->MakeOptions(field, window, maximumLag), littoral::AbortableFor(this, 0.3, 0.9));
  if (!std::isfinite(fits.front().AICc))
  {
    littoral::Refuse("No model could be fitted: only ", variogram.Rings.size(), " lags up to ", maximumLag,
      " have pairs. Take a longer MaximumLag.");
  }
  vtkTable* table = vtkTable::GetData(outputVector, 0);
  WriteFits(fits, field.Trend, window, table);
  WriteVariogram(variogram, fits, window, vtkTable::GetData(outputVector, 1));
  AddGrid(image, table);
  littoral::PassGeoreference(image, table);
  littoral::AddField(table, "SampleVariance", { field.Variance });
  littoral::AddField(table, "NumberOfValues", { static_cast<double>(field.Moments.Count) });
  AddDimensions(field.Samples, map, littoral::AbortableFor(this), table);
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
int vtkCovarianceFitFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(
    this, request, outputs, [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkCovarianceFitFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumLag: " << this->MaximumLag << "\n";
  os << indent << "NumberOfLags: " << this->NumberOfLags << "\n";
  os << indent << "RemoveTrend: " << (this->RemoveTrend ? "on" : "off") << "\n";
  os << indent << "FitNugget: " << (this->FitNugget ? "on" : "off") << "\n";
  os << indent << "FitAnisotropy: " << (this->FitAnisotropy ? "on" : "off") << "\n";
  os << indent << "NumberOfDirections: " << this->NumberOfDirections << "\n";
  os << indent << "MaximumRange: " << this->MaximumRange << "\n";
  os << indent << "FractalWavelength: " << this->FractalWavelength << "\n";
  os << indent << "UseNoDataValue: " << (this->UseNoDataValue ? "on" : "off") << "\n";
  os << indent << "NoDataValue: " << this->NoDataValue << "\n";
}
