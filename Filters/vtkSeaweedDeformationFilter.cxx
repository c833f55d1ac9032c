// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSeaweedDeformationFilter.h"

#include "Data/Blocks.h"
#include "Data/SeaStateTable.h"
#include "Data/SeaweedForest.h"
#include "Numerics/Constants.h"
#include "Numerics/ParameterRange.h"
#include "Pipeline/Pipeline.h"

#include "vtkDemandDrivenPipeline.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <cmath>

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

/// Plants, their state, and the currents, with the clock of the state.
class vtkSeaweedDeformationFilter::Internals
{
public:
  std::vector<double> Key; // what all of this depends on
  vtkSmartPointer<vtkDataObject> Plants;
  vtkMTimeType PlantsTime = 0;
  littoral::SeaweedForest Forest;
  bool IsRead = false;
  littoral::DriftHistory Clock; // of currents; carries no points
  bool IsPhysical = true;
  bool IsLooping = false;
  int Restarts = 0;

  /// The moment at which loads of a step, or of a picture, are those.
  littoral::DriftMoment Moment(long long step, double length) const
  {
    const double half = this->IsPhysical ? 0.5 : 1.0;
    return { step, length == this->Clock.Clock.Step ? half : half * length / this->Clock.Clock.Step };
  }
  bool FindMissing(const littoral::CurrentSeries& current, double& time) const
  {
    const bool advances = this->IsPhysical && this->Clock.NowStep < this->Clock.Step;
    const double length = advances || this->WantsFullStep ? this->Clock.Clock.Step : this->Clock.Rest;
    if (current.FindMissing(this->Clock.Clock, this->Moment(this->Clock.NowStep, length), time))
    {
      return true;
    }
    return !advances &&
      current.FindMissing(this->Clock.Clock, this->Moment(this->Clock.NowStep, this->Clock.Rest), time);
  }
  bool AnyMissing() const
  {
    double time = 0.0;
    return std::any_of(this->Clock.Currents.begin(), this->Clock.Currents.end(),
      [&](const littoral::CurrentSeries& current) { return this->FindMissing(current, time); });
  }
  /// Currents at the moment of the loads, as stage 1.
  littoral::StepCurrents CurrentsOf(double length) const
  {
    littoral::StepCurrents currents;
    std::vector<littoral::FlowPrimitive> steady;
    for (const littoral::CurrentSeries& current : this->Clock.Currents)
    {
      const littoral::CurrentMixture mixture = current.At(this->Clock.Clock, this->Moment(this->Clock.NowStep, length));
      if (!current.IsConstant())
      {
        currents.Changing[1].push_back(mixture);
        continue;
      }
      steady.insert(steady.end(), mixture.First->GetPrimitives().begin(), mixture.First->GetPrimitives().end());
      if (mixture.First->HasGrids())
      {
        currents.SteadyGrids.push_back(mixture.First);
      }
    }
    currents.Steady = littoral::FlowField(steady);
    return currents;
  }
  bool WantsFullStep = false;
};

//----------------------------------------------------------------------------
vtkSeaweedDeformationFilter::vtkSeaweedDeformationFilter()
  : Method(1)
  , Joint(0)
  , Load(0)
  , Integrator(0)
  , StartTime(-5.0)
  , TimeStep(1.0 / 48.0)
  , WaterDensity(1025.0)
  , DragCoefficient(1.0)
  , FrictionCoefficient(0.02)
  , AddedMassCoefficient(1.0)
  , DampingFactor(1.0)
  , ForceFactor(1.0)
  , LeverArm(0.5)
  , LargestAngle(60.0)
  , UseLevels(false)
  , BlendDistance(12.0)
  , BlendTime(0.0)
  , ViewSpeed(1.0)
  , PixelError(0.5)
  , GenerateMotion(false)
  , VelocityArray(nullptr)
  , TimeRange{ 0.0, 60.0 }
  , State(new Internals)
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
    this->DampingFactor, this->ForceFactor, this->LeverArm, this->LargestAngle,
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
  Internals& state = *this->State;
  std::vector<double> key = this->StateKey(inputVector, output);
  if (vtkInformation* sea = inputVector[SeaPort]->GetInformationObject(0))
  {
    littoral::RequestAll(sea);
  }
  const std::vector<littoral::CurrentSeries> currents = littoral::AnnouncedCurrents(inputVector[CurrentsPort]);
  littoral::AddTimes(currents, key);
  // A pipeline that changes whenever it is asked must not keep this one from ever coming to an end.
  constexpr int MostRestarts = 2;
  state.Restarts = state.IsLooping ? state.Restarts : 0;
  if (key != state.Key && state.Restarts < MostRestarts)
  {
    const int restarts = state.Restarts + 1;
    state = Internals();
    state.Restarts = restarts;
    state.Key = key;
    state.Clock.Currents = currents;
    state.Clock.Clock = { this->StartTime, this->TimeStep };
    state.IsPhysical = this->Method == 1;
  }
  const double time = littoral::RequestedTime(output);
  if (!this->WhyInvalid(time).empty())
  {
    return 1; // said when data are asked for
  }
  state.WantsFullStep = this->GenerateMotion && state.IsPhysical;
  state.Clock.SetGoal(time);
  state.Clock.NowStep = state.Clock.Step;
  if (state.IsPhysical && state.IsRead)
  {
    state.Forest.Resume(state.Clock.Step);
    state.Clock.NowStep = state.Forest.GetStep();
  }
  else if (state.IsPhysical)
  {
    state.Clock.NowStep = 0;
  }
  for (littoral::CurrentSeries& current : state.Clock.Currents)
  {
    state.FindMissing(current, current.Asked);
  }
  littoral::AskForTimes(state.Clock.Currents, inputVector[CurrentsPort]);
  return 1;
}

//----------------------------------------------------------------------------
std::string vtkSeaweedDeformationFilter::WhyInvalid(double time) const
{
  using littoral::OutOfRange;
  for (const std::string& reason : { OutOfRange("Method", this->Method, 0, 1), OutOfRange("Joint", this->Joint, 0, 1),
         OutOfRange("Load", this->Load, 0, 1), OutOfRange("Integrator", this->Integrator, 0, 1),
         OutOfRange("StartTime", this->StartTime, -1e9, 1e9), OutOfRange("TimeStep", this->TimeStep, 1e-5, 1.0),
         OutOfRange("LargestAngle", this->LargestAngle, 0.0, 180.0),
         OutOfRange("BlendDistance", this->BlendDistance, 0.0, 1e9), OutOfRange("BlendTime", this->BlendTime, 0.0, 1e9),
         OutOfRange("ViewSpeed", this->ViewSpeed, 0.0, 1e9), OutOfRange("PixelError", this->PixelError, 0.0, 1e9),
         littoral::WhyInvalid(this->MakeOptions()) })
  {
    if (!reason.empty())
    {
      return reason;
    }
  }
  if (!(this->TimeRange[0] < this->TimeRange[1]))
  {
    return "TimeRange must be increasing.";
  }
  if (!(std::abs(time) <= 1e9))
  {
    return "the requested time is " + std::to_string(time) + " s; it must be from -1e9 to 1e9.";
  }
  if (this->Method == 1 && (time - this->StartTime) / this->TimeStep > littoral::MostDriftSteps)
  {
    return "time " + std::to_string(time) + " is more than 10 million times TimeStep after StartTime.";
  }
  return {};
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
  options.LargestAngle = this->LargestAngle * littoral::Pi / 180.0;
  return options;
}

//----------------------------------------------------------------------------
std::string vtkSeaweedDeformationFilter::TakeInputs(vtkInformationVector** inputVector, vtkMultiBlockDataSet* blocks)
{
  Internals& state = *this->State;
  const std::string name = this->VelocityArray ? this->VelocityArray : "";
  for (std::size_t connection = 0; connection < state.Clock.Currents.size(); ++connection)
  {
    littoral::CurrentSeries& current = state.Clock.Currents[connection];
    double time = 0.0;
    if (!state.FindMissing(current, time))
    {
      continue;
    }
    auto snapshot = std::make_shared<littoral::CurrentSnapshot>();
    const std::string reason =
      snapshot->Take(vtkDataObject::GetData(inputVector[CurrentsPort], static_cast<int>(connection)), name);
    if (!reason.empty())
    {
      return reason;
    }
    current.Keep(current.Asked, snapshot);
  }
  vtkDataObject* plants = vtkDataObject::GetData(inputVector[PlantsPort]);
  const vtkMTimeType plantsTime = std::max(plants->GetMTime(), plants->GetUpdateTime());
  if (state.IsRead && state.Plants == plants && state.PlantsTime == plantsTime)
  {
    return {};
  }
  this->SetProgressText("Reading plants");
  littoral::SeaState sea;
  if (inputVector[SeaPort]->GetNumberOfInformationObjects() > 0)
  {
    const std::string reason = littoral::ReadSeaState(vtkTable::GetData(inputVector[SeaPort]), sea);
    if (!reason.empty())
    {
      return reason;
    }
  }
  else if (state.Clock.Currents.empty())
  {
    return "there is no sea state and no current; connect one of them.";
  }
  littoral::SeaweedOptions options = this->MakeOptions();
  options.SeaLevel = sea.SeaLevel;
  state.Forest = littoral::SeaweedForest();
  const std::string reason = state.Forest.Read(blocks, options);
  if (!reason.empty())
  {
    return reason;
  }
  state.Forest.SetSea(sea, state.IsPhysical);
  state.Plants = plants;
  state.PlantsTime = plantsTime;
  state.IsRead = true;
  state.Clock.NowStep = state.IsPhysical ? 0 : state.Clock.Step;
  this->WarnOfLimits();
  return {};
}

//----------------------------------------------------------------------------
void vtkSeaweedDeformationFilter::WarnOfLimits()
{
  const double cauchy = this->State->Forest.GetUngradedCauchyNumber();
  if (this->Method == 1 && this->Load == 0 && cauchy < 1e4)
  {
    vtkWarningMacro("Segments of blades do not get shorter towards their foot: drag is right up to a Cauchy number of "
      << cauchy << " (density of the water, coefficient of drag, width, speed squared and length cubed, over twice the "
      << "bending stiffness). Beyond, limp blades bend too much. vtkSeaweedSource grows graded ones.");
  }
  if (this->Method != 1 || this->Integrator != 1 || this->State->Forest.GetNumberOfLinks() == 0)
  {
    return;
  }
  const double limit = littoral::ExplicitLimit(this->State->Forest.GetLinks());
  if (this->TimeStep > limit)
  {
    vtkWarningMacro("TimeStep is " << this->TimeStep << " s; with Integrator Explicit Euler these plants blow up above "
                                   << limit << " s.");
  }
}

//----------------------------------------------------------------------------
/// As far as the currents are known. False when aborted.
bool vtkSeaweedDeformationFilter::Advance()
{
  Internals& state = *this->State;
  const double step = state.Clock.Clock.Step;
  const long long first = state.Clock.NowStep;
  while (state.Clock.NowStep < state.Clock.Step && !state.AnyMissing())
  {
    if (littoral::IsAborted(this))
    {
      return false;
    }
    this->UpdateProgress(
      0.9 * static_cast<double>(state.Clock.NowStep - first) / static_cast<double>(state.Clock.Step - first + 1));
    state.Forest.Advance(state.Clock.Clock.TimeOf(state.Clock.NowStep), step, state.CurrentsOf(step));
    ++state.Clock.NowStep;
  }
  return true;
}

//----------------------------------------------------------------------------
int vtkSeaweedDeformationFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  Internals& state = *this->State;
  std::string reason;
  const auto plants = littoral::BlocksOf(vtkDataObject::GetData(inputVector[PlantsPort]), reason);
  auto* output = vtkMultiBlockDataSet::GetData(outputVector, 0);
  const double time = littoral::RequestedTime(outputVector->GetInformationObject(0));
  const auto stop = [&](bool good) {
    request->Remove(Pipeline::CONTINUE_EXECUTING());
    state.IsLooping = false;
    if (!good)
    {
      state = Internals();
      output->Initialize();
    }
    return good ? 1 : 0;
  };
  littoral::SeaweedLevels levels;
  levels.UseLevels = this->UseLevels;
  if (this->UseLevels && !this->GetView(levels.Seen))
  {
    return stop(false);
  }
  reason = reason.empty() ? this->WhyInvalid(time) : reason;
  reason = reason.empty() ? this->TakeInputs(inputVector, plants) : reason;
  if (!reason.empty())
  {
    vtkErrorMacro("Cannot move seaweeds: " << reason);
    return stop(false);
  }
  output->ShallowCopy(plants);
  if (state.Forest.GetNumberOfLinks() == 0)
  {
    return stop(true);
  }
  this->SetProgressText("Moving plants");
  if (state.IsPhysical && !this->Advance())
  {
    stop(false); // aborted: what was moved halfway is of no use
    return 1;
  }
  if (state.Clock.NowStep < state.Clock.Step || state.AnyMissing())
  {
    request->Set(Pipeline::CONTINUE_EXECUTING(), 1);
    state.IsLooping = true;
    return 1;
  }
  levels.NearDistance = this->NearDistance;
  levels.FarDistance = this->FarDistance;
  levels.BlendDistance = this->BlendDistance + this->ViewSpeed * this->BlendTime;
  levels.PixelError = this->PixelError;
  const double rest = state.Clock.Rest;
  const littoral::SeaweedCounters counters = state.Forest.Show(time, rest, state.CurrentsOf(rest), levels);
  if (this->GenerateMotion)
  {
    const double length = state.IsPhysical ? this->TimeStep : rest;
    state.Forest.FindMotion(time, rest, this->TimeStep, state.CurrentsOf(length));
  }
  state.Forest.Write(plants, output);
  vtkNew<vtkFieldData> fields;
  fields->ShallowCopy(plants->GetFieldData());
  output->SetFieldData(fields);
  AddCounter(output, "PlantsInAll", static_cast<std::int64_t>(state.Forest.GetNumberOfPlants()));
  AddCounter(output, "PlantsShown", counters.Shown);
  AddCounter(output, "SegmentsInAll", static_cast<std::int64_t>(state.Forest.GetNumberOfLinks()));
  AddCounter(output, "SegmentsMoved", counters.Segments);
  AddCounter(output, "TrainEvaluations", counters.TrainEvaluations);
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  this->UpdateProgress(1.0);
  return stop(true);
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
  os << indent << "LargestAngle: " << this->LargestAngle << "\n";
  os << indent << "UseLevels: " << this->UseLevels << "\n";
  os << indent << "BlendDistance: " << this->BlendDistance << "\n";
  os << indent << "BlendTime: " << this->BlendTime << "\n";
  os << indent << "ViewSpeed: " << this->ViewSpeed << "\n";
  os << indent << "PixelError: " << this->PixelError << "\n";
  os << indent << "GenerateMotion: " << this->GenerateMotion << "\n";
  os << indent << "VelocityArray: " << (this->VelocityArray ? this->VelocityArray : "(none)") << "\n";
  os << indent << "TimeRange: " << this->TimeRange[0] << " " << this->TimeRange[1] << "\n";
}
