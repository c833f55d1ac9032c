// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSeaStateSource.h"

#include "Data/ArrayReader.h"
#include "Data/Inputs.h"
#include "Data/SeaStateTable.h"
#include "Data/Tables.h"
#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Mistakes.h"
#include "Pipeline/Pipeline.h"
#include "Sea/SeaPeriods.h"
#include "Sea/SeaStatistics.h"
#include "Sea/SecondOrder.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSeaStateSource);

namespace
{

/// Part of a spectrum's energy that may be left out without a word.
constexpr double EnergyLeftOutInSilence = 0.02;
/// Circular spread of a mean vector of length 0, sqrt(2), and a hair [degrees].
constexpr double MostSpread = 81.03;

/// A column of numbers; empty if there is none of that name.
std::vector<double> ColumnOf(vtkTable* table, const char* name)
{
  std::vector<double> values;
  vtkDataArray* array = littoral::ArrayReader::OfRows(table, "the table of the spectrum").Seek(name, 1);
  for (vtkIdType row = 0; array && row < array->GetNumberOfTuples(); ++row)
  {
    values.push_back(array->GetComponent(row, 0));
  }
  return values;
}

/// Mean vectors of directions by frequency; none unless both columns are there.
std::vector<littoral::DirectionAt> DirectionsOf(vtkTable* table)
{
  using namespace littoral;
  const std::vector<double> hertz = ColumnOf(table, "Frequency");
  const std::vector<double> densities = ColumnOf(table, "Density");
  const std::vector<double> towards = ColumnOf(table, sea::DirectionTowards);
  const std::vector<double> spread = ColumnOf(table, sea::DirectionalSpread);
  std::vector<DirectionAt> directions;
  for (std::size_t row = 0; towards.size() == hertz.size() && spread.size() == hertz.size() && row < hertz.size();
       ++row)
  {
    ParameterCheck check;
    const std::string inRow = " in row " + std::to_string(row) + " of the spectrum";
    check.Finite(sea::DirectionTowards + inRow, towards[row], "degrees");
    check.Range(sea::DirectionalSpread + inRow, spread[row], 0.0, MostSpread, "degrees");
    Require(check.Reason());
    const double angle = spread[row] * Pi / 180.0;
    // r = 1 - s2 / 2
    directions.push_back(
      { TwoPi * hertz[row], towards[row] * Pi / 180.0, std::max(0.0, 1.0 - 0.5 * angle * angle), densities[row] });
  }
  return directions;
}

/// Names of the columns of a spectrum that are not used.
std::string UnusedColumns(vtkTable* table, bool hasDirections)
{
  std::string names;
  for (vtkIdType index = 0; index < table->GetNumberOfColumns(); ++index)
  {
    const std::string name = table->GetColumnName(index) ? table->GetColumnName(index) : "";
    const bool isDirection =
      hasDirections && (name == littoral::sea::DirectionTowards || name == littoral::sea::DirectionalSpread);
    if (!name.empty() && name != "Frequency" && name != "Density" && !isDirection)
    {
      names += (names.empty() ? "" : ", ") + name;
    }
  }
  return names;
}

}

//----------------------------------------------------------------------------
vtkSeaStateSource::vtkSeaStateSource()
  : Spectrum(PiersonMoskowitz)
  , SeaBy(Wind)
  , WindSpeed(10.0)
  , SignificantWaveHeight(2.0)
  , PeakPeriod(7.0)
  , PeakEnhancement(3.3)
  , WindSeaShape(1.5)
  , SwellHeight(1.0)
  , SwellPeriod(13.0)
  , SwellShape(4.0)
  , SwellDirection(0.0)
  , SwellSpreading(50.0)
  , WaterDepth(0.0)
  , SeaLevel(0.0)
  , Order(First)
  , NumberOfTrains(30)
  , FrequencyRange{ 0.0, 0.0 }
  , MeanDirection(0.0)
  , Spreading(10.0)
  , SpreadingModel(Constant)
  , EqualSpacing(false)
  , Seed(1)
{
  this->SetNumberOfInputPorts(1);
}

//----------------------------------------------------------------------------
vtkSeaStateSource::~vtkSeaStateSource() = default;

//----------------------------------------------------------------------------
int vtkSeaStateSource::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//----------------------------------------------------------------------------
int vtkSeaStateSource::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  littoral::RequestAll(inputVector[0]->GetInformationObject(0));
  return 1;
}

//----------------------------------------------------------------------------
littoral::SpectrumParameters vtkSeaStateSource::MakeSpectrum(vtkTable* measured) const
{
  littoral::SpectrumParameters spectrum;
  spectrum.Kind = static_cast<littoral::SpectrumKind>(this->Spectrum);
  spectrum.FromWind = this->SeaBy == Wind;
  spectrum.WindSpeed = this->WindSpeed;
  spectrum.SignificantHeight = this->SignificantWaveHeight;
  spectrum.PeakPeriod = this->PeakPeriod;
  spectrum.PeakEnhancement = this->PeakEnhancement;
  spectrum.Shape = this->WindSeaShape;
  spectrum.SwellHeight = this->SwellHeight;
  spectrum.SwellPeriod = this->SwellPeriod;
  spectrum.SwellShape = this->SwellShape;
  spectrum.Depth = this->WaterDepth == 0.0 ? std::numeric_limits<double>::infinity() : this->WaterDepth;
  if (this->Spectrum == Table && measured)
  {
    spectrum.Frequencies = ColumnOf(measured, "Frequency");
    spectrum.Densities = ColumnOf(measured, "Density");
  }
  return spectrum;
}

//----------------------------------------------------------------------------
littoral::TrainParameters vtkSeaStateSource::MakeTrainParameters() const
{
  littoral::TrainParameters cut;
  cut.Count = this->NumberOfTrains;
  cut.Lowest = this->FrequencyRange[0];
  cut.Highest = this->FrequencyRange[1];
  cut.MeanDirection = this->MeanDirection * littoral::Pi / 180.0;
  cut.Spreading = this->Spreading;
  cut.Model = static_cast<littoral::SpreadingModel>(this->SpreadingModel);
  cut.SwellDirection = this->SwellDirection * littoral::Pi / 180.0;
  cut.SwellSpreading = this->SwellSpreading;
  cut.EqualSpacing = this->EqualSpacing;
  cut.Seed = this->Seed;
  return cut;
}

//----------------------------------------------------------------------------
int vtkSeaStateSource::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using namespace littoral;
  if (AsksForLaterPiece(request, outputVector))
  {
    return 1;
  }
  auto* measured = OptionalInputOf<vtkTable>(inputVector[0], "Input");
  const SpectrumParameters spectrum = this->MakeSpectrum(measured);
  TrainParameters cut = this->MakeTrainParameters();
  ParameterCheck check;
  check.Require(WhyInvalid(spectrum));
  check.Choice("SeaBy", this->SeaBy, 2);
  check.Finite("SeaLevel", this->SeaLevel, "m");
  check.Range("Order", this->Order, 1, 2);
  check.Require(WhyInvalid(cut));
  Require(check.Reason());
  if (measured && this->Spectrum == Table)
  {
    cut.Directions = DirectionsOf(measured);
  }
  const SeaSpectrum density(spectrum);
  Require(WhyBroken(density, spectrum.Depth));
  const SeaState state{ TrainsOf(density, spectrum.Depth, cut), spectrum.Depth, this->SeaLevel, PeriodOf(density, cut),
    static_cast<SeaOrder>(this->Order) };
  Require(state.Trains.empty() ? "FrequencyRange holds no energy of the spectrum." : WhyInvalid(state));
  const double energy = EnergyOf(state.Trains);
  const double leftOut = std::max(0.0, 1.0 - energy / density.TotalEnergy());
  vtkTable* output = vtkTable::GetData(outputVector);
  WriteSpectrum(density, cut, output);
  WriteSeaState(state, output);
  AddField(output, sea::SignificantWaveHeight, { 4.0 * std::sqrt(energy) });
  AddField(output, sea::PeakPeriod, { TwoPi / density.PeakFrequency() });
  AddField(output, sea::EnergyLeftOut, { leftOut });
  WritePeriods(PeriodsOf(state.Trains), output);
  WriteDirection(MeanVectorOf(state.Trains), output);
  if (state.Order == SeaOrder::Second)
  {
    AddField(output, sea::Skewness, { SkewnessOf(state) });
  }
  const std::string unused =
    measured && this->Spectrum == Table ? UnusedColumns(measured, !cut.Directions.empty()) : std::string();
  if (!unused.empty())
  {
    littoralWarningMacro("Columns of the spectrum not used: "
      << unused << (cut.Directions.empty() ? "; set MeanDirection and Spreading." : "."));
  }
  if (leftOut > EnergyLeftOutInSilence)
  {
    littoralWarningMacro("FrequencyRange leaves out " << 100.0 * leftOut << " % of the energy of the spectrum.");
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkSeaStateSource::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(this, request, outputs,
    "Cannot make a sea: ", [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkSeaStateSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Spectrum: " << this->Spectrum << "\n";
  os << indent << "SeaBy: " << this->SeaBy << "\n";
  os << indent << "WindSpeed: " << this->WindSpeed << "\n";
  os << indent << "SignificantWaveHeight: " << this->SignificantWaveHeight << "\n";
  os << indent << "PeakPeriod: " << this->PeakPeriod << "\n";
  os << indent << "PeakEnhancement: " << this->PeakEnhancement << "\n";
  os << indent << "WindSeaShape: " << this->WindSeaShape << "\n";
  os << indent << "SwellHeight: " << this->SwellHeight << "\n";
  os << indent << "SwellPeriod: " << this->SwellPeriod << "\n";
  os << indent << "SwellShape: " << this->SwellShape << "\n";
  os << indent << "SwellDirection: " << this->SwellDirection << "\n";
  os << indent << "SwellSpreading: " << this->SwellSpreading << "\n";
  os << indent << "WaterDepth: " << this->WaterDepth << "\n";
  os << indent << "SeaLevel: " << this->SeaLevel << "\n";
  os << indent << "Order: " << this->Order << "\n";
  os << indent << "NumberOfTrains: " << this->NumberOfTrains << "\n";
  os << indent << "FrequencyRange: " << this->FrequencyRange[0] << " " << this->FrequencyRange[1] << "\n";
  os << indent << "MeanDirection: " << this->MeanDirection << "\n";
  os << indent << "Spreading: " << this->Spreading << "\n";
  os << indent << "SpreadingModel: " << this->SpreadingModel << "\n";
  os << indent << "EqualSpacing: " << this->EqualSpacing << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
