// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindStatisticsFilter.h"

#include "Data/Inputs.h"
#include "Data/Tables.h"
#include "Data/WindImage.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Pipeline.h"
#include "Wind/WindStatistics.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkWindStatisticsFilter);

namespace
{

/// Memory of a point: its velocity, and the Fourier components of it [bytes].
constexpr double BytesOfPoint = 40.0;

constexpr const char* Components[littoral::WindComponents] = { "Along", "Across", "Up" };

void WriteBands(const std::vector<littoral::WindBand>& bands, vtkTable* table)
{
  using littoral::WindBand;
  littoral::AddColumn(table, "Frequency", bands, [](const WindBand& band) { return band.Frequency; });
  for (int k = 0; k < littoral::WindComponents; ++k)
  {
    littoral::AddColumn(table, Components[k], bands, [=](const WindBand& band) { return band.Measured[k]; });
  }
  for (int k = 0; k < littoral::WindComponents; ++k)
  {
    const std::string name = std::string(Components[k]) + "Model";
    littoral::AddColumn(table, name.c_str(), bands, [=](const WindBand& band) { return band.Model[k]; });
  }
}

void WriteProfile(const std::vector<littoral::WindLayer>& layers, vtkTable* table)
{
  using littoral::WindLayer;
  const auto column = [&](const std::string& name, auto valueOf) {
    littoral::AddColumn(table, name.c_str(), layers, valueOf);
  };
  column("Height", [](const WindLayer& layer) { return layer.Height; });
  column("Speed", [](const WindLayer& layer) { return layer.Speed; });
  column("SpeedModel", [](const WindLayer& layer) { return layer.ModelSpeed; });
  for (int k = 0; k < littoral::WindComponents; ++k)
  {
    const std::string name = std::string(Components[k]) + "Deviation";
    column(name, [=](const WindLayer& layer) { return layer.Deviation[k]; });
    column(name + "Model", [=](const WindLayer& layer) { return layer.ModelDeviation[k]; });
  }
}

}

//----------------------------------------------------------------------------
vtkWindStatisticsFilter::vtkWindStatisticsFilter()
  : Height(10.0)
  , Separation{ 4.0, 0.0 }
  , NumberOfBands(30)
{
  this->SetNumberOfOutputPorts(3);
}

//----------------------------------------------------------------------------
vtkWindStatisticsFilter::~vtkWindStatisticsFilter() = default;

//----------------------------------------------------------------------------
int vtkWindStatisticsFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//----------------------------------------------------------------------------
int vtkWindStatisticsFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // Lines are transformed whole.
  littoral::RequestAll(inputVector[0]->GetInformationObject(0));
  return 1;
}

//----------------------------------------------------------------------------
int vtkWindStatisticsFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (littoral::AsksForLaterPiece(request, outputVector))
  {
    return 1;
  }
  littoral::ParameterCheck check;
  check.Finite("Height", this->Height, "m");
  check.NotNegative("Separation[0]", this->Separation[0], "m");
  check.NotNegative("Separation[1]", this->Separation[1], "m");
  check.Count("NumberOfBands", this->NumberOfBands, 2, 10000);
  littoral::Require(check.Reason());
  auto* image = littoral::InputOf<vtkImageData>(inputVector[0], "Input");
  littoral::RequireMemory(BytesOfPoint * static_cast<double>(image->GetNumberOfPoints()), "The wind", "take a part of it");
  const littoral::ModelledWind wind =
    littoral::ReadModelledWind(image);
  const littoral::WindGrid& grid = wind.Grid;
  const littoral::WindPlaces places =
    littoral::FindPlaces(grid, this->Height, { this->Separation[0], this->Separation[1] });
  this->SetProgressText("Measuring wind");
  const littoral::WindStatistics statistics(wind.Velocities.data(), grid, wind.Model, littoral::PollOf(this));
  WriteBands(statistics.Spectra(places.Layer, this->NumberOfBands), vtkTable::GetData(outputVector, 0));
  this->UpdateProgress(0.4);
  WriteBands(statistics.Coherence(places.Layer, places.Columns, places.Layers, this->NumberOfBands),
    vtkTable::GetData(outputVector, 1));
  this->UpdateProgress(0.8);
  WriteProfile(statistics.Profile(), vtkTable::GetData(outputVector, 2));
  for (const int port : { 0, 1 })
  {
    vtkTable* table = vtkTable::GetData(outputVector, port);
    littoral::AddField(table, "Height", { grid.Height(places.Layer) });
    littoral::AddField(
      table, "Separation", { places.Columns * grid.LateralSpacing, std::abs(places.Layers) * grid.VerticalSpacing });
  }
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
int vtkWindStatisticsFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(
    this, request, outputs, [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkWindStatisticsFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Height: " << this->Height << "\n";
  os << indent << "Separation: " << this->Separation[0] << " " << this->Separation[1] << "\n";
  os << indent << "NumberOfBands: " << this->NumberOfBands << "\n";
}
