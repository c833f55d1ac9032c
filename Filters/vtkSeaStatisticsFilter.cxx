// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSeaStatisticsFilter.h"

#include "Data/Inputs.h"
#include "Data/SeaStateTable.h"
#include "Data/Tables.h"
#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Pipeline.h"
#include "Sea/SeaStatistics.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <string>
#include <vector>

vtkStandardNewMacro(vtkSeaStatisticsFilter);

namespace
{

void WriteSpectrumCurve(const std::vector<littoral::FrequencyDensity>& curve, vtkTable* table)
{
  using Row = littoral::FrequencyDensity;
  littoral::AddColumn(table, "Frequency", curve, [](const Row& row) { return row.Frequency; });
  littoral::AddColumn(table, "Spectrum", curve, [](const Row& row) { return row.Spectrum; });
  littoral::AddColumn(table, "Trains", curve, [](const Row& row) { return row.Trains; });
}

void WriteDirections(const std::vector<littoral::DirectionDensity>& curve, vtkTable* table)
{
  using Row = littoral::DirectionDensity;
  littoral::AddColumn(table, "Direction", curve, [](const Row& row) { return row.Direction; });
  littoral::AddColumn(table, "Spreading", curve, [](const Row& row) { return row.Spreading; });
  littoral::AddColumn(table, "Trains", curve, [](const Row& row) { return row.Trains; });
}

}

//----------------------------------------------------------------------------
vtkSeaStatisticsFilter::vtkSeaStatisticsFilter()
  : NumberOfSectors(24)
{
  this->SetNumberOfOutputPorts(2);
}

//----------------------------------------------------------------------------
vtkSeaStatisticsFilter::~vtkSeaStatisticsFilter() = default;

//----------------------------------------------------------------------------
int vtkSeaStatisticsFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  return 1;
}

//----------------------------------------------------------------------------
int vtkSeaStatisticsFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  littoral::RequestAll(inputVector[0]->GetInformationObject(0));
  return 1;
}

//----------------------------------------------------------------------------
int vtkSeaStatisticsFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (littoral::AsksForLaterPiece(request, outputVector))
  {
    return 1;
  }
  littoral::ParameterCheck check;
  check.Count("NumberOfSectors", this->NumberOfSectors, 4, 3600);
  littoral::Require(check.Reason());
  auto* input = littoral::InputOf<vtkTable>(inputVector[0], "Input");
  const littoral::SeaState sea = littoral::ReadSeaState(input);
  const littoral::SampledSpectrum spectrum = littoral::ReadSpectrum(input);
  WriteSpectrumCurve(
    littoral::SpectrumOfTrains(sea.Trains, spectrum.Edges, spectrum.Densities), vtkTable::GetData(outputVector, 0));
  WriteDirections(littoral::SpreadingOfTrains(sea.Trains, this->NumberOfSectors), vtkTable::GetData(outputVector, 1));
  const double direction = littoral::MeanVectorOf(sea.Trains).Direction * 180.0 / littoral::Pi;
  for (const int port : { 0, 1 })
  {
    vtkTable* table = vtkTable::GetData(outputVector, port);
    table->GetFieldData()->PassData(input->GetFieldData());
    table->GetFieldData()->RemoveArray(littoral::sea::BinEdges);
    table->GetFieldData()->RemoveArray(littoral::sea::SpectralDensity);
    littoral::AddField(table, "MeanDirection", { direction });
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkSeaStatisticsFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(this, request, outputs,
    "Cannot analyze: ", [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkSeaStatisticsFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSectors: " << this->NumberOfSectors << "\n";
}
