// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGroundStatisticsFilter.h"

#include "Data/Inputs.h"
#include "Data/Tables.h"
#include "Data/TerrainHeights.h"
#include "Drainage/GroundStatistics.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Pipeline.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkGroundStatisticsFilter);

namespace
{

/// Heights, spill elevations, routing, areas and sorted copies of a cell.
constexpr littoral::CellMemory Memory{ 100.0, "measuring" };
/// Quantiles of the distributions: a row a percent.
constexpr int NumberOfQuantiles = 101;
/// Largest stream threshold [cells].
constexpr long long MaximumStreamThreshold = 1000000000;

void WriteNumbers(const littoral::GroundStatistics& ground, double cellArea, vtkTable* table)
{
  using Ground = littoral::GroundStatistics;
  const std::vector<Ground> row{ ground };
  const auto column = [&](const char* name, auto valueOf) { littoral::AddColumn(table, name, row, valueOf); };
  column("DepressionFraction", [](const Ground& of) { return of.Measures.DepressionFraction; });
  column("RelativeFillDepth", [](const Ground& of) { return of.Measures.RelativeFillDepth; });
  column("HypsometricIntegral", [](const Ground& of) { return of.Measures.HypsometricIntegral; });
  column("ElevationSkewness", [](const Ground& of) { return of.Measures.ElevationSkewness; });
  column("ElevationStandardDeviation", [](const Ground& of) { return of.Measures.StandardDeviation; });
  column("MeanSlope", [](const Ground& of) { return of.Slopes.Mean; });
  column("SlopeSkewness", [](const Ground& of) { return of.Slopes.Skew; });
  column("CurvatureStandardDeviation", [](const Ground& of) { return of.Curvature.StandardDeviation; });
  column("CurvatureSkewness", [](const Ground& of) { return of.Curvature.Skew; });
  column("Concavity", [](const Ground& of) { return of.Measures.Concavity; });
  column("Steepness", [](const Ground& of) { return of.Steepness; });
  column("HackExponent", [](const Ground& of) { return of.Hack; });
  column("BifurcationRatio", [](const Ground& of) { return of.Horton.Bifurcation; });
  column("LengthRatio", [](const Ground& of) { return of.Horton.Length; });
  column("AreaRatio", [](const Ground& of) { return of.Horton.Area; });
  column("ThresholdSlope", [](const Ground& of) { return of.ThresholdSlope; });
  column("HeadArea", [=](const Ground& of) { return of.Channels.HeadCells * cellArea; });
  column("ChannelHeads", [](const Ground& of) { return of.Channels.Heads; });
  column("DrainageDensity", [](const Ground& of) { return of.Channels.Density; });
}

void WriteProfile(const littoral::GroundStatistics& ground, double cellArea, vtkTable* table)
{
  using Bin = littoral::SlopeAreaBin;
  const auto column = [&](const char* name, auto valueOf) {
    littoral::AddColumn(table, name, ground.Measures.SlopeArea, valueOf);
  };
  column("DrainageArea", [=](const Bin& bin) { return bin.Cells * cellArea; });
  column("Slope", [](const Bin& bin) { return bin.Slope; });
  column("PowerLaw",
    [&](const Bin& bin) { return ground.Steepness * std::pow(bin.Cells * cellArea, -ground.Measures.Concavity); });
  column("Cells", [](const Bin& bin) { return static_cast<int>(bin.Count); });
}

void WriteDistributions(const littoral::GridSamples& heights, vtkTable* table)
{
  std::vector<double> fractions;
  for (int k = 0; k < NumberOfQuantiles; ++k)
  {
    fractions.push_back(k / (NumberOfQuantiles - 1.0));
  }
  const auto column = [&](const char* name, const std::vector<double>& values) {
    littoral::AddColumn(table, name, values, [](double value) { return value; });
  };
  column("Fraction", fractions);
  column("Elevation", littoral::EvenQuantiles(heights.Values, NumberOfQuantiles));
  column("Slope", littoral::EvenQuantiles(littoral::GradientsOf(heights), NumberOfQuantiles));
  column("Curvature", littoral::EvenQuantiles(littoral::LaplaciansOf(heights), NumberOfQuantiles));
}

void WriteStreams(const std::vector<littoral::StreamOrderClass>& streams, vtkTable* table)
{
  using Class = littoral::StreamOrderClass;
  littoral::AddColumn(table, "Order", streams, [](const Class& of) { return of.Order; });
  littoral::AddColumn(table, "Streams", streams, [](const Class& of) { return of.Streams; });
  littoral::AddColumn(table, "MeanLength", streams, [](const Class& of) { return of.MeanLength; });
  littoral::AddColumn(table, "MeanArea", streams, [](const Class& of) { return of.MeanArea; });
}

void WriteForms(const std::array<double, littoral::GeomorphonForms>& shares, vtkTable* table)
{
  std::vector<int> forms(shares.size());
  std::iota(forms.begin(), forms.end(), 1);
  littoral::AddColumn(table, "Form", forms, [](int form) { return form; });
  littoral::AddColumn(table, "Name", forms, [](int form) { return littoral::NameOf(form); });
  littoral::AddColumn(table, "Share", shares, [](double share) { return share; });
}

void WriteRelief(const std::vector<littoral::StreamDistanceBin>& relief, vtkTable* table)
{
  using Bin = littoral::StreamDistanceBin;
  littoral::AddColumn(table, "Distance", relief, [](const Bin& bin) { return bin.Distance; });
  littoral::AddColumn(table, "Height", relief, [](const Bin& bin) { return bin.Height; });
  littoral::AddColumn(table, "Cells", relief, [](const Bin& bin) { return static_cast<int>(bin.Count); });
}

}

//----------------------------------------------------------------------------
vtkGroundStatisticsFilter::vtkGroundStatisticsFilter()
  : StreamThreshold(100)
  , UseSeaLevel(false)
  , SeaLevel(0.0)
  , SearchRadius(10)
  , Flatness(1.0)
{
  this->SetNumberOfOutputPorts(6);
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

//----------------------------------------------------------------------------
vtkGroundStatisticsFilter::~vtkGroundStatisticsFilter() = default;

//----------------------------------------------------------------------------
int vtkGroundStatisticsFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//----------------------------------------------------------------------------
int vtkGroundStatisticsFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // Flow is not local.
  littoral::RequestAll(inputVector[0]->GetInformationObject(0));
  return 1;
}

//----------------------------------------------------------------------------
int vtkGroundStatisticsFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (littoral::AsksForLaterPiece(request, outputVector))
  {
    return 1;
  }
  littoral::ParameterCheck check;
  check.Count("StreamThreshold", this->StreamThreshold, 2, MaximumStreamThreshold);
  check.Finite("SeaLevel", this->SeaLevel, "m");
  littoral::Require(check.Reason());
  const littoral::GeomorphonSearch search{ this->SearchRadius, this->Flatness };
  littoral::Require(littoral::WhyInvalid(search));
  auto* image = littoral::InputOf<vtkImageData>(inputVector[0], "Input");
  const littoral::GridSamples heights = littoral::ReadHeights(
    image, this->GetInputArrayToProcess(0, inputVector), this->GetInputArrayInformation(0), "Input", Memory);
  const littoral::OutletMask outlets =
    this->UseSeaLevel ? littoral::SeaOutlets(heights, this->SeaLevel) : littoral::RimOutlets(heights);
  littoral::Require(littoral::WhyUndrainable(heights, outlets));
  littoral::RequireRelief(heights, "Input");
  this->SetProgressText("Measuring ground");
  const littoral::GroundStatistics ground = littoral::DescribeGround(
    heights, outlets, this->StreamThreshold, littoral::AbortableFor(this), littoral::PollOf(this), search);
  this->UpdateProgress(0.8);
  const double cellArea = heights.Spacing[0] * heights.Spacing[1];
  WriteNumbers(ground, cellArea, vtkTable::GetData(outputVector, 0));
  WriteProfile(ground, cellArea, vtkTable::GetData(outputVector, 1));
  WriteDistributions(heights, vtkTable::GetData(outputVector, 2));
  WriteStreams(ground.Streams, vtkTable::GetData(outputVector, 3));
  WriteForms(ground.Forms, vtkTable::GetData(outputVector, 4));
  WriteRelief(ground.Relief, vtkTable::GetData(outputVector, 5));
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
int vtkGroundStatisticsFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(this, request, outputs,
    "Cannot measure ground: ", [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkGroundStatisticsFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "StreamThreshold: " << this->StreamThreshold << "\n";
  os << indent << "UseSeaLevel: " << (this->UseSeaLevel ? "on" : "off") << "\n";
  os << indent << "SeaLevel: " << this->SeaLevel << "\n";
  os << indent << "SearchRadius: " << this->SearchRadius << "\n";
  os << indent << "Flatness: " << this->Flatness << "\n";
}
