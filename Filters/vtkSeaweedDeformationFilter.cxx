// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSeaweedDeformationFilter.h"

#include "Data/Blocks.h"
#include "Data/CurrentInputs.h"
#include "Data/Inputs.h"
#include "Data/PlantBlocks.h"
#include "Data/SeaStateTable.h"
#include "Data/SeaweedSceneBlocks.h"
#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/DataStamp.h"
#include "Pipeline/MarchingRequests.h"
#include "Pipeline/Mistakes.h"
#include "Pipeline/Pipeline.h"
#include "Seaweed/SeaweedScene.h"

#include "vtkDemandDrivenPipeline.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkSeaweedDeformationFilter);

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

constexpr int PlantsPort = 0;
constexpr int SeaPort = 1;
constexpr int CurrentsPort = 2;

void AddCounter(vtkDataObject* data, const char* name, std::int64_t value)
{
  vtkNew<vtkTypeInt64Array> array;
  array->SetName(name);
  array->InsertNextValue(value);
  data->GetFieldData()->AddArray(array);
}

}

/// The scene, and what it was read from.
class vtkSeaweedDeformationFilter::vtkInternals : public littoral::MarchingRequests<littoral::SeaweedScene>
{
public:
  std::vector<littoral::DataStamp> Plants; ///< of the blocks in full, which alone are read
  std::vector<littoral::SeaweedSkinBlock> Skins;
  littoral::SeaweedFrames Frames;
};

//----------------------------------------------------------------------------
vtkSeaweedDeformationFilter::vtkSeaweedDeformationFilter()
  : Method(Physical)
  , Joint(Bending)
  , Load(Morison)
  , Integrator(Implicit)
  , StartTime(-5.0)
  , TimeStep(1.0 / 48.0)
  , WaterDensity(1025.0)
  , DragCoefficient(1.95)
  , FrictionCoefficient(0.02)
  , AddedMassCoefficient(1.0)
  , DampingFactor(1.0)
  , ForceFactor(1.0)
  , LeverArm(0.5)
  , MaximumAngle(60.0)
  , UseLevels(false)
  , BlendDistance(12.0)
  , BlendTime(0.0)
  , ViewSpeed(1.0)
  , PixelError(0.5)
  , GenerateMotion(false)
  , GenerateJoints(false)
  , VelocityArray(nullptr)
  , TimeRange{ 0.0, 60.0 }
  , Internals(new vtkInternals)
{
  this->NearDistance = 5.0;
  this->FarDistance = 20.0;
  this->SetNumberOfInputPorts(3);
}

//----------------------------------------------------------------------------
vtkSeaweedDeformationFilter::~vtkSeaweedDeformationFilter()
{
  this->SetVelocityArray(nullptr);
}

//----------------------------------------------------------------------------
int vtkSeaweedDeformationFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  if (port == PlantsPort)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkMultiBlockDataSet");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPartitionedDataSetCollection");
    return 1;
  }
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  if (port == SeaPort)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
    return 1;
  }
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

//----------------------------------------------------------------------------
int vtkSeaweedDeformationFilter::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  littoral::AnnounceTimes(outputVector->GetInformationObject(0), this->TimeRange);
  return 1;
}

//----------------------------------------------------------------------------
/// All that a state depends on; no camera.
std::vector<double> vtkSeaweedDeformationFilter::StateKey(vtkInformationVector** inputVector, vtkInformation* output)
{
  std::vector<double> key{ static_cast<double>(this->Method), static_cast<double>(this->Joint),
    static_cast<double>(this->Load), static_cast<double>(this->Integrator), this->StartTime, this->TimeStep,
    this->WaterDensity, this->DragCoefficient, this->FrictionCoefficient, this->AddedMassCoefficient,
    this->DampingFactor, this->ForceFactor, this->LeverArm, this->MaximumAngle,
    static_cast<double>(output->Get(Pipeline::UPDATE_PIECE_NUMBER())),
    static_cast<double>(output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())) };
  for (int port : { SeaPort, CurrentsPort })
  {
    for (int connection = 0; connection < inputVector[port]->GetNumberOfInformationObjects(); ++connection)
    {
      key.push_back(static_cast<double>(port));
      key.push_back(static_cast<double>(littoral::PipelineTime(this, port, connection)));
    }
  }
  for (const char* letter = this->VelocityArray; letter && *letter; ++letter)
  {
    key.push_back(static_cast<double>(*letter));
  }
  return key;
}

//----------------------------------------------------------------------------
int vtkSeaweedDeformationFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* output = outputVector->GetInformationObject(0);
  std::vector<double> key = this->StateKey(inputVector, output);
  if (vtkInformation* sea = inputVector[SeaPort]->GetInformationObject(0))
  {
    littoral::RequestAll(sea);
  }
  const std::vector<littoral::CurrentSeries> currents = littoral::AnnouncedCurrents(inputVector[CurrentsPort]);
  littoral::AddTimes(currents, key);
  littoral::SeaweedScene& scene = this->Internals->Scene;
  if (this->Internals->BeginsAnew(key))
  {
    scene =
      littoral::SeaweedScene({ this->StartTime, this->TimeStep }, currents, this->Method == Physical, littoral::SmpFor);
  }
  const double time = littoral::RequestedTime(output);
  if (!this->WhyInvalid(time).empty())
  {
    return 1; // said when data are asked for
  }
  scene.NeedsMotion = this->GenerateMotion;
  scene.SetGoal(time);
  littoral::AskForSnapshots(scene.Currents, scene.GetGrid(), scene.NextMoments(), inputVector[CurrentsPort]);
  return 1;
}

//----------------------------------------------------------------------------
std::string vtkSeaweedDeformationFilter::WhyInvalid(double time) const
{
  littoral::ParameterCheck check;
  check.Choice("Method", this->Method, { "procedural", "physical" });
  check.Choice("Joint", this->Joint, { "bending", "tilting" });
  check.Choice("Load", this->Load, { "Morison", "direct" });
  check.Choice("Integrator", this->Integrator, { "implicit", "explicit Euler" });
  check.Range("StartTime", this->StartTime, -1e9, 1e9, "s");
  check.Range("TimeStep", this->TimeStep, 1e-5, 1.0, "s");
  check.Range("MaximumAngle", this->MaximumAngle, 0.0, 180.0, "degrees");
  check.Range("BlendDistance", this->BlendDistance, 0.0, 1e9, "m");
  check.Range("BlendTime", this->BlendTime, 0.0, 1e9, "s");
  check.Range("ViewSpeed", this->ViewSpeed, 0.0, 1e9, "m/s");
  check.Range("PixelError", this->PixelError, 0.0, 1e9, "pixels");
  check.Require(littoral::WhyInvalid(this->MakeOptions()));
  check.Increasing("TimeRange", this->TimeRange, "s");
  check.Range("the requested time", time, -1e9, 1e9, "s");
  if (this->Method == Physical && check.IsGood())
  {
    check.Require(littoral::WhyTooFar({ this->StartTime, this->TimeStep }, time));
  }
  return check.Reason();
}

//----------------------------------------------------------------------------
littoral::SeaweedOptions vtkSeaweedDeformationFilter::MakeOptions() const
{
  littoral::SeaweedOptions options;
  options.Joint = static_cast<littoral::SeaweedJoint>(this->Joint);
  options.Load = static_cast<littoral::SeaweedLoad>(this->Load);
  options.Integrator = static_cast<littoral::SeaweedIntegrator>(this->Integrator);
  options.WaterDensity = this->WaterDensity;
  options.DragCoefficient = this->DragCoefficient;
  options.FrictionCoefficient = this->FrictionCoefficient;
  options.AddedMassCoefficient = this->AddedMassCoefficient;
  options.DampingFactor = this->DampingFactor;
  options.ForceFactor = this->ForceFactor;
  options.LeverArm = this->LeverArm;
  options.MaximumAngle = this->MaximumAngle * littoral::Pi / 180.0;
  return options;
}

//----------------------------------------------------------------------------
void vtkSeaweedDeformationFilter::TakeInputs(vtkInformationVector** inputVector, vtkMultiBlockDataSet* blocks)
{
  littoral::SeaweedScene& scene = this->Internals->Scene;
  littoral::TakeSnapshots(scene.Currents, scene.GetGrid(), scene.NextMoments(), inputVector[CurrentsPort],
    this->VelocityArray, littoral::VelocityInterpolation::Linear);
  std::vector<littoral::DataStamp> plants;
  for (const char* name : { littoral::plant::Skeleton, littoral::plant::Skin, littoral::plant::Leaves })
  {
    plants.push_back(littoral::StampOf(littoral::PlantPartOf(blocks, littoral::plant::High, name)));
  }
  if (scene.HasPlants() && this->Internals->Plants == plants)
  {
    return;
  }
  this->Internals->Plants = plants;
  this->TakePlants(inputVector[SeaPort], blocks);
}

//----------------------------------------------------------------------------
void vtkSeaweedDeformationFilter::TakePlants(vtkInformationVector* seas, vtkMultiBlockDataSet* blocks)
{
  littoral::SeaweedScene& scene = this->Internals->Scene;
  this->SetProgressText("Reading plants");
  littoral::SeaState sea;
  if (seas->GetNumberOfInformationObjects() > 0)
  {
    sea = littoral::ReadSeaState(littoral::InputOf<vtkTable>(seas, "Sea State"));
  }
  littoral::SeaweedOptions options = this->MakeOptions();
  options.SeaLevel = sea.SeaLevel;
  this->Internals->Frames = {};
  littoral::ReadSeaweeds(blocks, options, sea, scene, this->Internals->Skins);
  this->WarnOfLimits();
}

//----------------------------------------------------------------------------
void vtkSeaweedDeformationFilter::WarnOfLimits()
{
  const double cauchy = this->Internals->Scene.GetUngradedCauchyNumber();
  if (this->Method == Physical && this->Load == Morison && cauchy < 1e4)
  {
    littoralWarningMacro(
      "Segments of blades do not get shorter towards their foot: drag is right up to a Cauchy number of "
      << cauchy << " (density of the water, coefficient of drag, width, speed squared and length cubed, over twice the "
      << "bending stiffness). Beyond, limp blades bend too much. vtkSeaweedSource grows graded ones.");
  }
  if (this->Method != Physical || this->Integrator != ExplicitEuler || this->Internals->Scene.GetNumberOfLinks() == 0)
  {
    return;
  }
  const double limit = littoral::ExplicitLimit(this->Internals->Scene.GetLinks());
  if (this->TimeStep > limit)
  {
    littoralWarningMacro("TimeStep is " << this->TimeStep
                                        << " s; with Integrator Explicit Euler these plants blow up above " << limit
                                        << " s.");
  }
}

//----------------------------------------------------------------------------
littoral::SeaweedLevels vtkSeaweedDeformationFilter::FindLevels()
{
  littoral::SeaweedLevels levels;
  levels.UseLevels = this->UseLevels;
  levels.NearDistance = this->NearDistance;
  levels.FarDistance = this->FarDistance;
  levels.BlendDistance = this->BlendDistance + this->ViewSpeed * this->BlendTime;
  levels.PixelError = this->PixelError / this->DetailFactor;
  levels.Seen = this->UseLevels ? this->GetView() : levels.Seen;
  return levels;
}

//----------------------------------------------------------------------------
littoral::MarchEnd vtkSeaweedDeformationFilter::March(vtkInformationVector** inputVector, vtkMultiBlockDataSet* plants)
{
  this->SetProgressText("Moving plants");
  littoral::SeaweedScene& scene = this->Internals->Scene;
  const auto advance = [&scene](const auto&) {
    scene.Advance();
    return true;
  };
  const auto ask = [&] {
    littoral::AskForSnapshots(scene.Currents, scene.GetGrid(), scene.NextMoments(), inputVector[CurrentsPort]);
  };
  return this->Internals->March(this, CurrentsPort, 0.9, advance, ask, [&] { this->TakeInputs(inputVector, plants); });
}

//----------------------------------------------------------------------------
int vtkSeaweedDeformationFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* output = vtkMultiBlockDataSet::GetData(outputVector, 0);
  const double time = littoral::RequestedTime(outputVector->GetInformationObject(0));
  const bool isInWater = inputVector[SeaPort]->GetNumberOfInformationObjects() > 0 ||
    inputVector[CurrentsPort]->GetNumberOfInformationObjects() > 0;
  littoral::SeaweedLevels levels;
  vtkSmartPointer<vtkMultiBlockDataSet> plants;
  try
  {
    levels = this->FindLevels();
    littoral::InContext("Cannot move seaweeds: ", [&] {
      plants = littoral::BlocksOf(vtkDataObject::GetData(inputVector[PlantsPort]), "Input");
      littoral::Require(this->WhyInvalid(time));
      if (isInWater)
      {
        this->TakeInputs(inputVector, plants);
      }
    });
  }
  catch (const littoral::InvalidInput&)
  {
    this->Fail(output);
    throw;
  }
  if (!isInWater)
  {
    this->Fail(output);
    output->ShallowCopy(plants);
    return littoral::FailedBy(this,
      "There is no sea state and no current: connect one to Sea State or Currents. The seaweeds stay as they are.");
  }
  output->ShallowCopy(plants);
  if (this->Internals->Scene.GetNumberOfLinks() == 0)
  {
    return 1;
  }
  auto end = littoral::MarchEnd::Goal;
  try
  {
    littoral::InContext("Cannot move seaweeds: ", [&] { end = this->March(inputVector, plants); });
  }
  catch (const littoral::InvalidInput&)
  {
    this->Fail(output);
    throw;
  }
  if (end != littoral::MarchEnd::Goal)
  {
    this->Fail(output); // what was moved halfway is of no use
    return end == littoral::MarchEnd::FailedInput ? littoral::FailedRequest(this) : 1;
  }
  this->Write(levels, plants, output);
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
void vtkSeaweedDeformationFilter::Write(
  const littoral::SeaweedLevels& levels, vtkMultiBlockDataSet* plants, vtkMultiBlockDataSet* output)
{
  littoral::SeaweedScene& scene = this->Internals->Scene;
  scene.NeedsJoints = this->GenerateJoints;
  const littoral::SeaweedCounters counters = scene.Show(levels);
  if (this->GenerateMotion)
  {
    scene.FindMotion();
  }
  // What is written halfway is never used again.
  littoral::SeaweedFrames frames = std::move(this->Internals->Frames);
  littoral::WriteSeaweeds(scene, this->Internals->Skins, frames, plants, output);
  this->Internals->Frames = std::move(frames);
  if (this->GenerateJoints)
  {
    littoral::AddSeaweedJoints(scene, output);
  }
  vtkNew<vtkFieldData> fields;
  fields->ShallowCopy(plants->GetFieldData());
  output->SetFieldData(fields);
  AddCounter(output, "PlantsInAll", static_cast<std::int64_t>(scene.GetStand().GetPlants().size()));
  AddCounter(output, "PlantsShown", counters.Plants);
  AddCounter(output, "SegmentsInAll", static_cast<std::int64_t>(scene.GetNumberOfLinks()));
  AddCounter(output, "SegmentsMoved", counters.Segments);
  AddCounter(output, "TrainEvaluations", counters.TrainEvaluations);
}

//----------------------------------------------------------------------------
void vtkSeaweedDeformationFilter::Fail(vtkDataObject* output)
{
  this->Internals->Plants.clear();
  this->Internals->Skins.clear();
  this->Internals->MarchingRequests::Fail(output);
}

//----------------------------------------------------------------------------
void vtkSeaweedDeformationFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "Joint: " << this->Joint << "\n";
  os << indent << "Load: " << this->Load << "\n";
  os << indent << "Integrator: " << this->Integrator << "\n";
  os << indent << "StartTime: " << this->StartTime << "\n";
  os << indent << "TimeStep: " << this->TimeStep << "\n";
  os << indent << "WaterDensity: " << this->WaterDensity << "\n";
  os << indent << "DragCoefficient: " << this->DragCoefficient << "\n";
  os << indent << "FrictionCoefficient: " << this->FrictionCoefficient << "\n";
  os << indent << "AddedMassCoefficient: " << this->AddedMassCoefficient << "\n";
  os << indent << "DampingFactor: " << this->DampingFactor << "\n";
  os << indent << "ForceFactor: " << this->ForceFactor << "\n";
  os << indent << "LeverArm: " << this->LeverArm << "\n";
  os << indent << "MaximumAngle: " << this->MaximumAngle << "\n";
  os << indent << "UseLevels: " << this->UseLevels << "\n";
  os << indent << "BlendDistance: " << this->BlendDistance << "\n";
  os << indent << "BlendTime: " << this->BlendTime << "\n";
  os << indent << "ViewSpeed: " << this->ViewSpeed << "\n";
  os << indent << "PixelError: " << this->PixelError << "\n";
  os << indent << "GenerateMotion: " << this->GenerateMotion << "\n";
  os << indent << "GenerateJoints: " << this->GenerateJoints << "\n";
  os << indent << "VelocityArray: " << (this->VelocityArray ? this->VelocityArray : "(none)") << "\n";
  os << indent << "TimeRange: " << this->TimeRange[0] << " " << this->TimeRange[1] << "\n";
}
