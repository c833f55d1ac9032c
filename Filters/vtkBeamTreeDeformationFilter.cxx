// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBeamTreeDeformationFilter.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/Blocks.h"
#include "Data/Inputs.h"
#include "Data/SwayBlocks.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/DataStamp.h"
#include "Pipeline/Mistakes.h"
#include "Pipeline/Pipeline.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkBeamTreeDeformationFilter);

namespace
{

constexpr int PlantsPort = 0;
constexpr int WindPort = 1;
constexpr int PrototypesPort = 2;
constexpr int MostPictures = 16; // a species, as pictures of more than 16384 texels cannot be shown everywhere

void AttachFrequencies(const std::vector<double>& frequencies, vtkDataObject* plants)
{
  auto array = littoral::NewArray<vtkDoubleArray>("Frequency", 1, static_cast<vtkIdType>(frequencies.size()));
  std::copy(frequencies.begin(), frequencies.end(), array->GetPointer(0));
  vtkNew<vtkFieldData> fields;
  fields->ShallowCopy(plants->GetFieldData());
  fields->AddArray(array);
  plants->SetFieldData(fields);
}

}

//----------------------------------------------------------------------------
class vtkBeamTreeDeformationFilter::vtkInternals
{
public:
  littoral::DataStamp Input;
  std::vector<littoral::DataStamp> Others; // of the wind and the prototypes
  vtkMTimeType Properties = 0;
  littoral::SwayBlocks Plants;
};

//----------------------------------------------------------------------------
vtkBeamTreeDeformationFilter::vtkBeamTreeDeformationFilter()
  : NumberOfModes(1)
  , Response(Interpolated)
  , DragCoefficient(1.1)
  , LiftCoefficient(0.0)
  , DragLaw(Projection)
  , Gravity(false)
  , WoodFromPlants(true)
  , YoungModulus(5.1e9)
  , WoodDensity(950.0)
  , DampingRatio(0.08)
  , LeafFlutter(1.0)
  , NumberOfTextures(8)
  , TextureSize{ 256, 128 }
  , Seed(1)
  , GenerateJoints(false)
  , OverwriteFrames(false)
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

//----------------------------------------------------------------------------
vtkBeamTreeDeformationFilter::~vtkBeamTreeDeformationFilter() = default;

//----------------------------------------------------------------------------
int vtkBeamTreeDeformationFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == WindPort ? "vtkImageData" : "vtkMultiBlockDataSet");
  if (port != WindPort)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPartitionedDataSetCollection");
  }
  if (port != PlantsPort)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // no wind: our own message, once
  }
  if (port == PrototypesPort)
  {
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkBeamTreeDeformationFilter::FillOutputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillOutputPortInformation(port, info);
  }
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

//----------------------------------------------------------------------------
int vtkBeamTreeDeformationFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // Times are those of the wind; of a wind that does not tell them, all.
  vtkInformation* wind = inputVector[WindPort]->GetInformationObject(0);
  vtkInformation* output = outputVector->GetInformationObject(0);
  if (wind)
  {
    output->CopyEntry(wind, vtkStreamingDemandDrivenPipeline::TIME_STEPS());
    output->CopyEntry(wind, vtkStreamingDemandDrivenPipeline::TIME_RANGE());
  }
  if (!output->Has(vtkStreamingDemandDrivenPipeline::TIME_RANGE()))
  {
    double range[2] = { 0.0, 600.0 };
    vtkDataObject* image = wind ? vtkDataObject::GetData(wind) : nullptr;
    vtkDataArray* period = image ? littoral::ArrayReader::OfFields(image, "the wind", 1).Seek("Period", 1) : nullptr;
    if (period && period->GetComponent(0, 0) > 0.0 && std::isfinite(period->GetComponent(0, 0)))
    {
      range[1] = period->GetComponent(0, 0);
    }
    output->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
  }
  const int species = std::max(1, inputVector[PrototypesPort]->GetNumberOfInformationObjects());
  const int pictures = species * std::clamp(this->NumberOfTextures, 1, MostPictures);
  const std::array<long long, 2> size = littoral::AtlasSize(std::vector<std::array<int, 2>>(
    pictures, { std::max(1, this->TextureSize[0]), std::max(1, this->TextureSize[1]) }));
  const int extent[6] = { 0, static_cast<int>(size[0]) - 1, 0, static_cast<int>(size[1]) - 1, 0, 0 };
  outputVector->GetInformationObject(1)->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

//----------------------------------------------------------------------------
int vtkBeamTreeDeformationFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  if (vtkInformation* wind = inputVector[WindPort]->GetInformationObject(0))
  {
    littoral::RequestAll(wind);
    wind->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), 0.0);
  }
  for (int index = 0; index < inputVector[PrototypesPort]->GetNumberOfInformationObjects(); ++index)
  {
    littoral::RequestAll(inputVector[PrototypesPort]->GetInformationObject(index));
  }
  return 1;
}

//----------------------------------------------------------------------------
std::string vtkBeamTreeDeformationFilter::WhyInvalid(double time) const
{
  littoral::ParameterCheck check;
  check.Count("NumberOfModes", this->NumberOfModes, 1, littoral::MaximumModes);
  check.Choice("Response", this->Response, { "interpolated", "direct" });
  check.Range("DragCoefficient", this->DragCoefficient, 0.0, 10.0);
  check.Range("LiftCoefficient", this->LiftCoefficient, -10.0, 10.0);
  check.Choice("DragLaw", this->DragLaw, { "projection", "cross-flow" });
  check.Range("LeafFlutter", this->LeafFlutter, 0.0, 2.0);
  check.Count("NumberOfTextures", this->NumberOfTextures, 1, MostPictures);
  check.Count("TextureSize[0]", this->TextureSize[0], 4, 4096);
  check.Count("TextureSize[1]", this->TextureSize[1], 4, 4096);
  check.Range("the requested time", time, -1e12, 1e12, "s");
  check.Require(
    littoral::WhyInvalid(littoral::WoodParameters{ this->YoungModulus, this->WoodDensity, this->DampingRatio }));
  return check.Reason();
}

//----------------------------------------------------------------------------
littoral::SwaySettings vtkBeamTreeDeformationFilter::MakeSettings() const
{
  littoral::SwaySettings settings;
  settings.Options.NumberOfModes = this->NumberOfModes;
  settings.Options.Response = static_cast<littoral::SwayResponse>(this->Response);
  settings.Options.Load.DragCoefficient = this->DragCoefficient;
  settings.Options.Load.LiftCoefficient = this->LiftCoefficient;
  settings.Options.Load.Law = static_cast<littoral::DragLaw>(this->DragLaw);
  settings.Options.Gravity = this->Gravity;
  settings.Options.Wood = { this->YoungModulus, this->WoodDensity, this->DampingRatio };
  settings.WoodFromPlants = this->WoodFromPlants;
  settings.Leaves.MaximumAlignment = std::min(1.0, settings.Leaves.MaximumAlignment * this->LeafFlutter);
  settings.Leaves.FlutterAngle *= this->LeafFlutter;
  settings.Leaves.Seed = this->Seed;
  settings.Pictures = this->NumberOfTextures;
  settings.TextureSize = { this->TextureSize[0], this->TextureSize[1] };
  return settings;
}

//----------------------------------------------------------------------------
/// Reads the inputs, unless they are those of the last time.
void vtkBeamTreeDeformationFilter::Remember(vtkInformationVector** inputVector, vtkMultiBlockDataSet* plants)
{
  auto internals = std::make_unique<vtkInternals>();
  internals->Properties = this->GetMTime();
  internals->Input = littoral::StampOf(vtkDataObject::GetData(inputVector[PlantsPort]));
  for (int port : { WindPort, PrototypesPort })
  {
    for (int index = 0; index < inputVector[port]->GetNumberOfInformationObjects(); ++index)
    {
      internals->Others.push_back(littoral::StampOf(vtkDataObject::GetData(inputVector[port], index)));
    }
  }
  const bool areKindsKnown = this->Internals && this->Internals->Plants.IsWhole() &&
    this->Internals->Others == internals->Others && this->Internals->Properties == internals->Properties;
  if (areKindsKnown && this->Internals->Input == internals->Input)
  {
    return;
  }
  std::shared_ptr<littoral::SwayKinds> known = areKindsKnown ? this->Internals->Plants.GetKinds() : nullptr;
  this->Internals.reset();
  std::vector<vtkSmartPointer<vtkMultiBlockDataSet>> prototypes;
  for (int index = 0; index < inputVector[PrototypesPort]->GetNumberOfInformationObjects(); ++index)
  {
    prototypes.push_back(littoral::BlocksOf(vtkDataObject::GetData(inputVector[PrototypesPort], index), "Prototypes"));
  }
  auto* wind = littoral::InputOf<vtkImageData>(inputVector[WindPort], "Wind");
  this->SetProgressText("Reading plants");
  internals->Plants.Read(
    plants, { prototypes.begin(), prototypes.end() }, wind, this->MakeSettings(), std::move(known), this);
  this->Internals = std::move(internals);
}

//----------------------------------------------------------------------------
int vtkBeamTreeDeformationFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const double time = littoral::RequestedTime(outputVector->GetInformationObject(0));
  vtkImageData::GetData(outputVector, 1)->Initialize(); // VTK leaves it as it was
  littoral::Require(this->WhyInvalid(time));
  const auto plants = littoral::BlocksOf(vtkDataObject::GetData(inputVector[PlantsPort]), "Input");
  if (inputVector[WindPort]->GetNumberOfInformationObjects() == 0)
  {
    vtkMultiBlockDataSet::GetData(outputVector, 0)->ShallowCopy(plants);
    return littoral::FailedBy(this, "There is no wind: connect a wind field to Wind. The plants stay as they are.");
  }
  this->Remember(inputVector, plants);
  auto* output = vtkMultiBlockDataSet::GetData(outputVector, 0);
  output->ShallowCopy(plants);
  if (this->Internals->Plants.IsWhole())
  {
    this->SetProgressText("Moving plants");
    this->Internals->Plants.SetOverwritesFrames(this->OverwriteFrames);
    this->Internals->Plants.Move(time, plants, output, this);
    if (this->GenerateJoints && !littoral::IsAborted(this))
    {
      this->Internals->Plants.AddJoints(output);
    }
    AttachFrequencies(this->Internals->Plants.GetFrequencies(), output);
    vtkImageData::GetData(outputVector, 1)->ShallowCopy(this->Internals->Plants.GetPictures());
  }
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
int vtkBeamTreeDeformationFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(
    this, request, outputs, [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkBeamTreeDeformationFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfModes: " << this->NumberOfModes << "\n";
  os << indent << "Response: " << this->Response << "\n";
  os << indent << "DragCoefficient: " << this->DragCoefficient << "\n";
  os << indent << "LiftCoefficient: " << this->LiftCoefficient << "\n";
  os << indent << "DragLaw: " << this->DragLaw << "\n";
  os << indent << "Gravity: " << this->Gravity << "\n";
  os << indent << "WoodFromPlants: " << this->WoodFromPlants << "\n";
  os << indent << "YoungModulus: " << this->YoungModulus << "\n";
  os << indent << "WoodDensity: " << this->WoodDensity << "\n";
  os << indent << "DampingRatio: " << this->DampingRatio << "\n";
  os << indent << "LeafFlutter: " << this->LeafFlutter << "\n";
  os << indent << "NumberOfTextures: " << this->NumberOfTextures << "\n";
  os << indent << "TextureSize: " << this->TextureSize[0] << " " << this->TextureSize[1] << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "GenerateJoints: " << this->GenerateJoints << "\n";
  os << indent << "OverwriteFrames: " << this->OverwriteFrames << "\n";
}
