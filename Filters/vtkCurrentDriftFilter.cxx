// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCurrentDriftFilter.h"

#include "Data/Arrays.h"
#include "Data/DriftHistory.h"
#include "Data/Followers.h"
#include "Data/SeaStateTable.h"
#include "Pipeline/Pipeline.h"
#include "Pipeline/Ranges.h"

#include "vtkCompositeDataIterator.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataSet.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkCurrentDriftFilter);

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;
using littoral::Vector3;

/// Points that one thread carries at a time.
constexpr std::size_t PointsAtOnce = 1 << 10;

/// The leaves of an input that have points.
std::vector<vtkPointSet*> LeavesOf(vtkDataObject* data)
{
  std::vector<vtkPointSet*> leaves;
  const auto add = [&](vtkDataObject* leaf) {
    auto* points = vtkPointSet::SafeDownCast(leaf);
    if (points && points->GetPoints() && points->GetNumberOfPoints() > 0)
    {
      leaves.push_back(points);
    }
  };
  if (auto* blocks = vtkDataObjectTree::SafeDownCast(data))
  {
    auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      add(iterator->GetCurrentDataObject());
    }
  }
  else
  {
    add(data);
  }
  return leaves;
}

}

/// What is kept between requests.
class vtkCurrentDriftFilter::Internals : public littoral::DriftHistory
{
};

//----------------------------------------------------------------------------
vtkCurrentDriftFilter::vtkCurrentDriftFilter()
  : StartTime(0.0)
  , TimeStep(0.1)
  , KeepInWater(true)
  , SeaLevel(0.0)
  , WaterDepth(0.0)
  , VelocityInterpolation(CubicSpline)
  , VelocityArray(nullptr)
  , GenerateCurrent(false)
  , TimeRange{ 0.0, 60.0 }
  , State(new Internals)
{
  this->SetNumberOfInputPorts(2);
}

//----------------------------------------------------------------------------
vtkCurrentDriftFilter::~vtkCurrentDriftFilter()
{
  this->SetVelocityArray(nullptr);
}

//----------------------------------------------------------------------------
int vtkCurrentDriftFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  if (port == 1)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    return 1;
  }
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkMultiBlockDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPartitionedDataSetCollection");
  return 1;
}

//----------------------------------------------------------------------------
int vtkCurrentDriftFilter::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  littoral::AnnounceTimes(outputVector->GetInformationObject(0), this->TimeRange);
  return 1;
}

//----------------------------------------------------------------------------
int vtkCurrentDriftFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* output = outputVector->GetInformationObject(0);
  vtkInformation* particles = inputVector[0]->GetInformationObject(0);
  // Points start where they are at StartTime, whatever time is asked for.
  particles->Set(Pipeline::UPDATE_TIME_STEP(), this->StartTime);

  const std::vector<littoral::CurrentSeries> currents = littoral::AnnouncedCurrents(inputVector[1]);
  std::vector<double> key{ static_cast<double>(this->GetMTime()),
    static_cast<double>(littoral::PipelineTime(this, 0, 0)),
    static_cast<double>(output->Get(Pipeline::UPDATE_PIECE_NUMBER())),
    static_cast<double>(output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())) };
  for (std::size_t connection = 0; connection < currents.size(); ++connection)
  {
    key.push_back(static_cast<double>(littoral::PipelineTime(this, 1, static_cast<int>(connection))));
  }
  littoral::AddTimes(currents, key);
  Internals& state = *this->State;
  // A pipeline that changes whenever it is asked must not keep this one from ever coming to an end.
  constexpr int MostRestarts = 2;
  state.Restarts = state.IsLooping ? state.Restarts : 0;
  if (key != state.Key && state.Restarts < MostRestarts)
  {
    const int restarts = state.Restarts + 1;
    state.Forget();
    state.Restarts = restarts;
    state.Key = key;
    state.Currents = currents;
    state.Clock = { this->StartTime, this->TimeStep };
  }
  const double time = littoral::RequestedTime(output);
  if (!this->WhyInvalid(time).empty())
  {
    return 1; // said when data are asked for
  }
  state.SetGoal(time);
  for (littoral::CurrentSeries& current : state.Currents)
  {
    state.FindMissing(current, current.Asked);
  }
  littoral::AskForTimes(state.Currents, inputVector[1]);
  return 1;
}

//----------------------------------------------------------------------------
std::string vtkCurrentDriftFilter::WhyInvalid(double time) const
{
  if (!std::isfinite(time))
  {
    return "the requested time is no number.";
  }
  if (!std::isfinite(this->StartTime))
  {
    return "StartTime must be finite.";
  }
  if (!(this->TimeStep > 0.0 && std::isfinite(this->TimeStep)))
  {
    return "TimeStep is " + std::to_string(this->TimeStep) + " s; it must be positive.";
  }
  if (this->KeepInWater && !std::isfinite(this->SeaLevel))
  {
    return "SeaLevel must be finite.";
  }
  if (this->KeepInWater && !(this->WaterDepth >= 0.0 && std::isfinite(this->WaterDepth)))
  {
    return "WaterDepth is " + std::to_string(this->WaterDepth) + " m; it must be positive, or 0 for none.";
  }
  if (this->VelocityInterpolation != Linear && this->VelocityInterpolation != CubicSpline)
  {
    return "VelocityInterpolation is " + std::to_string(this->VelocityInterpolation) +
      "; it must be 0 (linear) or 1 (cubic spline).";
  }
  if (!(this->TimeRange[0] < this->TimeRange[1]))
  {
    return "TimeRange must be increasing.";
  }
  return "";
}

//----------------------------------------------------------------------------
std::string vtkCurrentDriftFilter::TakeInputs(vtkInformationVector** inputVector)
{
  Internals& state = *this->State;
  state.Layer = {};
  if (this->KeepInWater)
  {
    state.Layer.Surface = this->SeaLevel;
    state.Layer.Bed = this->WaterDepth > 0.0 ? this->SeaLevel - this->WaterDepth : state.Layer.Bed;
  }
  const std::string name = this->VelocityArray ? this->VelocityArray : "";
  for (std::size_t connection = 0; connection < state.Currents.size(); ++connection)
  {
    littoral::CurrentSeries& current = state.Currents[connection];
    double time = 0.0;
    if (!state.FindMissing(current, time))
    {
      continue;
    }
    auto snapshot = std::make_shared<littoral::CurrentSnapshot>();
    const std::string reason = snapshot->Take(vtkDataObject::GetData(inputVector[1], static_cast<int>(connection)),
      name, state.Layer, static_cast<littoral::VelocityInterpolation>(this->VelocityInterpolation));
    if (!reason.empty())
    {
      return reason;
    }
    current.Keep(current.Asked, snapshot);
  }
  if (state.HasStart)
  {
    return "";
  }
  const std::vector<vtkPointSet*> leaves = LeavesOf(vtkDataObject::GetData(inputVector[0]));
  double count = 0.0;
  for (vtkPointSet* leaf : leaves)
  {
    count += static_cast<double>(leaf->GetNumberOfPoints());
  }
  if (count * (littoral::MostDriftCheckpoints + 4.0) * (sizeof(Vector3) + 1.0) > littoral::AvailableMemory())
  {
    return std::to_string(static_cast<long long>(count)) + " points are more than this machine has memory for.";
  }
  for (vtkPointSet* leaf : leaves)
  {
    littoral::Slaves slaves;
    const std::string reason = littoral::ReadSlaves(leaf, slaves);
    if (!reason.empty())
    {
      return reason;
    }
    for (vtkIdType id = 0; id < leaf->GetNumberOfPoints(); ++id)
    {
      Vector3 place;
      leaf->GetPoint(id, &place[0]);
      const bool isSlave = !slaves.Master.empty() && slaves.Master[id] >= 0;
      const bool isInWater = place.z >= state.Layer.Bed && place.z <= state.Layer.Surface;
      if (!littoral::IsFinite(place))
      {
        return "point " + std::to_string(id) + " is not finite.";
      }
      state.Start.Places.push_back(place);
      state.Start.Fates.push_back(isSlave || !isInWater ? littoral::Still : littoral::Free);
    }
  }
  state.HasStart = true;
  state.Now = state.Start;
  state.NowStep = 0;
  return "";
}

//----------------------------------------------------------------------------
bool vtkCurrentDriftFilter::Advance()
{
  Internals& state = *this->State;
  const std::size_t count = state.Now.Size();
  while (state.NowStep < state.Step && !state.AnyMissing())
  {
    // Constant currents: up to the next checkpoint at once.
    const long long next = (state.NowStep / state.Stride + 1) * state.Stride;
    const long long last = state.IsConstant() ? std::min(state.Step, next) : state.NowStep + 1;
    const double length = state.Clock.Step;
    const littoral::StepCurrents currents = state.CurrentsOf(state.NowStep, length);
    const std::size_t batches = (count + PointsAtOnce - 1) / PointsAtOnce;
    const double first = static_cast<double>(state.NowStep) / static_cast<double>(state.Step + 1);
    const double end = static_cast<double>(last) / static_cast<double>(state.Step + 1);
    const bool done = littoral::RunWithProgress(this, batches, first, end, [&](std::size_t batch) {
      for (std::size_t id = batch * PointsAtOnce; id < std::min(count, (batch + 1) * PointsAtOnce); ++id)
      {
        for (long long step = state.NowStep; step < last; ++step)
        {
          state.Carry(currents, length, state.Now.Places[id], state.Now.Fates[id]);
        }
      }
    });
    if (!done)
    {
      return false;
    }
    state.NowStep = last;
    state.KeepCheckpoint();
  }
  return true;
}

//----------------------------------------------------------------------------
int vtkCurrentDriftFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  Internals& state = *this->State;
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  vtkInformation* info = outputVector->GetInformationObject(0);
  const double time = littoral::RequestedTime(info);
  const auto stop = [&](bool good) {
    request->Remove(Pipeline::CONTINUE_EXECUTING());
    state.IsLooping = false;
    if (!good)
    {
      state.Forget();
      state.Key.clear();
      output->Initialize();
    }
    return good ? 1 : 0;
  };
  std::string reason = this->WhyInvalid(time);
  if (reason.empty() && inputVector[1]->GetNumberOfInformationObjects() == 0)
  {
    output->ShallowCopy(input);
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    return stop(true);
  }
  if (reason.empty())
  {
    state.SetGoal(time);
    reason = this->TakeInputs(inputVector);
  }
  if (reason.empty())
  {
    const bool isUniform = std::all_of(state.Currents.begin(), state.Currents.end(),
      [](const littoral::CurrentSeries& current) { return current.IsUniform(); });
    state.IsClosed = isUniform; // and level wherever there is a wall
    if (state.IsClosed && state.NowStep > 0)
    {
      state.NowStep = 0;
      state.Now = state.Start;
    }
    if (!state.IsClosed && (time - this->StartTime) / this->TimeStep > littoral::MostDriftSteps)
    {
      reason = "time " + std::to_string(time) + " is more than 10 million times TimeStep after StartTime.";
    }
  }
  if (!reason.empty())
  {
    vtkErrorMacro("Cannot carry points: " << reason);
    return stop(false);
  }
  this->SetProgressText("Drifting");
  if (!state.IsClosed && !this->Advance())
  {
    stop(false); // aborted: what was carried halfway is of no use
    return 1;
  }
  if (!state.IsClosed && (state.NowStep < state.Step || state.AnyMissing()))
  {
    request->Set(Pipeline::CONTINUE_EXECUTING(), 1);
    state.IsLooping = true;
    return 1;
  }
  if (!this->WriteAll(input, output))
  {
    stop(false);
    return 1;
  }
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  littoral::KeepRanges(output);
  this->UpdateProgress(1.0);
  return stop(true);
}

//----------------------------------------------------------------------------
bool vtkCurrentDriftFilter::WriteAll(vtkDataObject* input, vtkDataObject* output)
{
  auto* blocks = vtkDataObjectTree::SafeDownCast(input);
  std::size_t first = 0;
  if (!blocks)
  {
    output->ShallowCopy(input);
    return this->WriteLeaf(vtkPointSet::SafeDownCast(input), vtkPointSet::SafeDownCast(output), first);
  }
  auto* moved = vtkDataObjectTree::SafeDownCast(output);
  moved->CopyStructure(blocks);
  auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkDataObject* leaf = iterator->GetCurrentDataObject();
    auto copy = vtkSmartPointer<vtkDataObject>::Take(leaf->NewInstance());
    copy->ShallowCopy(leaf);
    moved->SetDataSet(iterator, copy);
    auto* points = vtkPointSet::SafeDownCast(leaf);
    if (points && !this->WriteLeaf(points, vtkPointSet::SafeDownCast(copy), first))
    {
      return false;
    }
    first += points && points->GetPoints() ? static_cast<std::size_t>(points->GetNumberOfPoints()) : 0;
  }
  return true;
}

//----------------------------------------------------------------------------
bool vtkCurrentDriftFilter::WriteLeaf(vtkPointSet* input, vtkPointSet* output, std::size_t first)
{
  if (!input->GetPoints() || input->GetNumberOfPoints() == 0)
  {
    return true;
  }
  return input->GetPoints()->GetDataType() == VTK_DOUBLE ? this->WriteLeafAs<vtkDoubleArray>(input, output, first)
                                                         : this->WriteLeafAs<vtkFloatArray>(input, output, first);
}

//----------------------------------------------------------------------------
template <typename Array>
bool vtkCurrentDriftFilter::WriteLeafAs(vtkPointSet* input, vtkPointSet* output, std::size_t first)
{
  using Real = typename Array::ValueType;
  const Internals& state = *this->State;
  const vtkIdType count = input->GetNumberOfPoints();
  const auto places = littoral::NewArray<Array>("Points", 3, count);
  const auto captured = littoral::NewArray<vtkUnsignedCharArray>(littoral::sea::Captured, 1, count);
  const auto flow = littoral::NewArray<vtkFloatArray>(littoral::sea::Current, 3, this->GenerateCurrent ? count : 0);
  littoral::Slaves slaves;
  littoral::ReadSlaves(input, slaves);
  const littoral::StepCurrents currents = state.CurrentsOf(state.NowStep, state.IsClosed ? 0.0 : state.Rest);
  const std::size_t batches = (static_cast<std::size_t>(count) + PointsAtOnce - 1) / PointsAtOnce;
  const bool done = littoral::RunWithProgress(this, batches, 0.98, 1.0, [&](std::size_t batch) {
    const vtkIdType begin = static_cast<vtkIdType>(batch * PointsAtOnce);
    for (vtkIdType id = begin; id < std::min<vtkIdType>(count, begin + PointsAtOnce); ++id)
    {
      const vtkIdType master = slaves.Master.empty() ? -1 : slaves.Master[id];
      Vector3 place;
      unsigned char fate = littoral::Free;
      state.Finish(currents, first + static_cast<std::size_t>(master >= 0 ? master : id), place, fate);
      if (master >= 0)
      {
        Vector3 offset;
        slaves.Offset->GetTuple(id, &offset[0]);
        place += offset;
      }
      const Real tuple[3] = { static_cast<Real>(place.x), static_cast<Real>(place.y), static_cast<Real>(place.z) };
      places->SetTypedTuple(id, tuple);
      captured->SetValue(id, fate == littoral::Captured ? 1 : 0);
      if (this->GenerateCurrent)
      {
        const Vector3 velocity = currents.Velocity(place, 2);
        flow->SetTuple3(id, velocity.x, velocity.y, velocity.z);
      }
    }
  });
  if (!done)
  {
    return false;
  }
  vtkNew<vtkPoints> points;
  points->SetData(places);
  output->SetPoints(points);
  output->GetPointData()->AddArray(captured);
  if (this->GenerateCurrent)
  {
    output->GetPointData()->AddArray(flow);
  }
  return true;
}

//----------------------------------------------------------------------------
void vtkCurrentDriftFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "StartTime: " << this->StartTime << "\n";
  os << indent << "TimeStep: " << this->TimeStep << "\n";
  os << indent << "KeepInWater: " << this->KeepInWater << "\n";
  os << indent << "SeaLevel: " << this->SeaLevel << "\n";
  os << indent << "WaterDepth: " << this->WaterDepth << "\n";
  os << indent << "VelocityInterpolation: " << this->VelocityInterpolation << "\n";
  os << indent << "VelocityArray: " << (this->VelocityArray ? this->VelocityArray : "(none)") << "\n";
  os << indent << "GenerateCurrent: " << this->GenerateCurrent << "\n";
  os << indent << "TimeRange: " << this->TimeRange[0] << " " << this->TimeRange[1] << "\n";
}
