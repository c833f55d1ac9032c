// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCurrentDriftFilter.h"

#include "Currents/DriftHistory.h"
#include "Data/Arrays.h"
#include "Data/CommonWay.h"
#include "Data/CurrentInputs.h"
#include "Data/Followers.h"
#include "Data/FrameArrays.h"
#include "Data/Inputs.h"
#include "Data/SeaStateTable.h"
#include "Data/Tables.h"
#include "Numerics/ParameterCheck.h"
#include "Numerics/ShiftedTriples.h"
#include "Pipeline/MarchingRequests.h"
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
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkCurrentDriftFilter);

namespace
{

constexpr int CurrentsPort = 1;

using Pipeline = vtkStreamingDemandDrivenPipeline;
using littoral::Vector3;

/// Points that one thread carries at a time.
constexpr std::size_t PointsAtOnce = 1 << 12;
/// Points that go the same way, likewise: some 0.3 ms.
constexpr std::size_t ShiftedAtOnce = 1 << 19;

/// Adds the points of a leaf where they start.
void AddPoints(vtkPointSet* leaf, const littoral::WaterLayer& layer, littoral::Drifters& points)
{
  const littoral::Slaves slaves = littoral::ReadSlaves(leaf);
  for (vtkIdType id = 0; id < leaf->GetNumberOfPoints(); ++id)
  {
    Vector3 position;
    leaf->GetPoint(id, &position[0]);
    if (!littoral::IsFinite(position))
    {
      littoral::Refuse("point ", id, " is not finite.");
    }
    const bool isSlave = !slaves.Master.empty() && slaves.Master[id] >= 0;
    const bool isCarried = !isSlave && layer.Holds(position.z);
    points.Positions.push_back(position);
    points.Fates.push_back(isCarried ? littoral::DriftFate::Free : littoral::DriftFate::Still);
  }
}

/// Places of the points from begin up to end that have gone a way, of those that are free.
template <typename Real>
void Shift(const littoral::Drifters& start, std::size_t first, const Vector3& way, std::size_t begin, std::size_t end,
  Real* places)
{
  for (std::size_t id = begin; id < end; ++id)
  {
    const bool isFree = start.Fates[first + id] == littoral::DriftFate::Free;
    const Vector3& from = start.Positions[first + id];
    places[3 * id] = static_cast<Real>(isFree ? from.x + way.x : from.x);
    places[3 * id + 1] = static_cast<Real>(isFree ? from.y + way.y : from.y);
    places[3 * id + 2] = static_cast<Real>(isFree ? from.z + way.z : from.z);
  }
}

/// Runs a task on all points, some at a time, with progress from first to last. False when aborted.
bool RunOnPoints(vtkAlgorithm* algorithm, std::size_t count, double first, double last, const littoral::RangeTask& task,
  std::size_t atOnce = PointsAtOnce)
{
  const std::size_t batches = (count + atOnce - 1) / atOnce;
  return littoral::RunWithProgress(algorithm, batches, first, last,
    [&](std::size_t batch) { task(batch * atOnce, std::min(count, (batch + 1) * atOnce)); });
}

}

namespace
{

/// Arrays of a leaf that stay while its points are carried.
struct StillPoints
{
  vtkPointSet* Leaf = nullptr; ///< compared, never used
  vtkMTimeType Time = 0;
  vtkSmartPointer<vtkDataArray> Start;
  vtkSmartPointer<vtkUnsignedCharArray> Captured; ///< where no point is ever captured
};

}

/// State that is kept between requests.
class vtkCurrentDriftFilter::vtkInternals
  : public littoral::MarchingRequests<littoral::DriftHistory>
  , public littoral::LeafFrames<StillPoints>
{
public:
  bool AreFree = false; ///< all points, where they start

  /// Arrays of the next leaf that stay as long as the leaf does.
  template <typename Array>
  StillPoints& NextStill(vtkPointSet* leaf)
  {
    StillPoints& still = this->NextEntry();
    if (still.Leaf != leaf || still.Time != leaf->GetMTime())
    {
      const auto start = vtkSmartPointer<littoral::SharedArray<Array>>::New();
      start->Share(littoral::WithType<Array>(leaf->GetPoints()->GetData()));
      start->SetName(littoral::sea::Start);
      still = { leaf, leaf->GetMTime(), start, nullptr };
    }
    return still;
  }
};

//----------------------------------------------------------------------------
vtkCurrentDriftFilter::vtkCurrentDriftFilter()
  : StartTime(0.0)
  , TimeStep(0.1)
  , KeepInWater(true)
  , SeaLevel(0.0)
  , WaterDepth(0.0)
  , VelocityInterpolation(CubicSpline)
  , Coast(Stop)
  , VelocityArray(nullptr)
  , GenerateCurrent(false)
  , WayAsField(false)
  , TimeRange{ 0.0, 60.0 }
  , Internals(new vtkInternals)
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
  if (port == CurrentsPort)
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

  const std::vector<littoral::CurrentSeries> currents = littoral::AnnouncedCurrents(inputVector[CurrentsPort]);
  std::vector<double> key{ static_cast<double>(this->GetMTime()),
    static_cast<double>(littoral::PipelineTime(this, 0, 0)),
    static_cast<double>(output->Get(Pipeline::UPDATE_PIECE_NUMBER())),
    static_cast<double>(output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())) };
  for (std::size_t connection = 0; connection < currents.size(); ++connection)
  {
    key.push_back(static_cast<double>(littoral::PipelineTime(this, CurrentsPort, static_cast<int>(connection))));
  }
  littoral::AddTimes(currents, key);
  littoral::DriftHistory& history = this->Internals->Scene;
  if (this->Internals->BeginsAnew(key))
  {
    history = littoral::DriftHistory({ this->StartTime, this->TimeStep }, currents);
    history.Currents.Layer = this->GetWaterLayer();
  }
  const double time = littoral::RequestedTime(output);
  if (!this->WhyInvalid(time).empty())
  {
    return 1; // said when data are asked for
  }
  history.SetGoal(time);
  littoral::AskForSnapshots(history.Currents, history.GetGrid(), history.NextMoments(), inputVector[CurrentsPort]);
  return 1;
}

//----------------------------------------------------------------------------
std::string vtkCurrentDriftFilter::WhyInvalid(double time) const
{
  littoral::ParameterCheck check;
  check.Finite("the requested time", time, "s");
  check.Finite("StartTime", this->StartTime, "s");
  check.Positive("TimeStep", this->TimeStep, "s");
  if (this->KeepInWater)
  {
    check.Finite("SeaLevel", this->SeaLevel, "m");
    check.NotNegative("WaterDepth", this->WaterDepth, "m"); // 0 for none
  }
  check.Choice("VelocityInterpolation", this->VelocityInterpolation, { "linear", "cubic spline" });
  check.Choice("Coast", this->Coast, { "stop", "slide" });
  check.Increasing("TimeRange", this->TimeRange, "s");
  return check.Reason();
}

//----------------------------------------------------------------------------
littoral::WaterLayer vtkCurrentDriftFilter::GetWaterLayer() const
{
  littoral::WaterLayer layer;
  if (this->KeepInWater)
  {
    layer.Surface = this->SeaLevel;
    layer.Bed = this->WaterDepth > 0.0 ? this->SeaLevel - this->WaterDepth : layer.Bed;
  }
  return layer;
}

//----------------------------------------------------------------------------
void vtkCurrentDriftFilter::TakeInputs(vtkInformationVector** inputVector, double time)
{
  littoral::Require(this->WhyInvalid(time));
  littoral::DriftHistory& history = this->Internals->Scene;
  littoral::TakeSnapshots(history.Currents, history.GetGrid(), history.NextMoments(), inputVector[CurrentsPort],
    this->VelocityArray, static_cast<littoral::VelocityInterpolation>(this->VelocityInterpolation),
    static_cast<littoral::CoastBehaviour>(this->Coast));
  if (!history.IsBegun())
  {
    this->TakePoints(vtkDataObject::GetData(inputVector[0]));
  }
  littoral::Require(history.IsClosed() ? "" : littoral::WhyTooFar(history.GetGrid(), time));
}

//----------------------------------------------------------------------------
void vtkCurrentDriftFilter::TakePoints(vtkDataObject* input)
{
  std::vector<vtkPointSet*> leaves = littoral::PointSetsOf(input, "Input");
  const auto isEmpty = [](vtkPointSet* leaf) { return !leaf->GetPoints() || leaf->GetNumberOfPoints() == 0; };
  leaves.erase(std::remove_if(leaves.begin(), leaves.end(), isEmpty), leaves.end());
  double count = 0.0;
  for (vtkPointSet* leaf : leaves)
  {
    littoral::RequireInPlace(leaf);
    count += static_cast<double>(leaf->GetNumberOfPoints());
  }
  const double bytesOfPoint = (littoral::DriftHistory::MaximumCheckpoints + 4.0) * (sizeof(Vector3) + 1.0);
  littoral::RequireMemory(count * bytesOfPoint, "The drift of " + littoral::TextOf(count) + " points", "take fewer");
  littoral::Drifters start;
  for (vtkPointSet* leaf : leaves)
  {
    AddPoints(leaf, this->Internals->Scene.Currents.Layer, start);
  }
  this->Internals->AreFree = std::all_of(
    start.Fates.begin(), start.Fates.end(), [](littoral::DriftFate fate) { return fate == littoral::DriftFate::Free; });
  this->Internals->Scene.Begin(std::move(start));
}

//----------------------------------------------------------------------------
littoral::MarchEnd vtkCurrentDriftFilter::March(vtkInformationVector** inputVector, double time)
{
  this->SetProgressText("Drifting");
  littoral::DriftHistory& history = this->Internals->Scene;
  const auto advance = [&](const auto& progress) {
    const long long first = history.GetStep();
    const long long last = history.NextStop();
    const littoral::StepCurrents currents = history.NextCurrents();
    const auto carry = [&](std::size_t begin, std::size_t end) { history.Carry(currents, last, begin, end); };
    const bool isDone = RunOnPoints(this, history.Size(), progress(first), progress(last), carry);
    if (isDone)
    {
      history.Reach(last);
    }
    return isDone;
  };
  const auto ask = [&] {
    littoral::AskForSnapshots(history.Currents, history.GetGrid(), history.NextMoments(), inputVector[CurrentsPort]);
  };
  return this->Internals->March(this, CurrentsPort, 0.98, advance, ask, [&] { this->TakeInputs(inputVector, time); });
}

//----------------------------------------------------------------------------
int vtkCurrentDriftFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  const double time = littoral::RequestedTime(outputVector->GetInformationObject(0));
  if (inputVector[CurrentsPort]->GetNumberOfInformationObjects() == 0 && this->WhyInvalid(time).empty())
  {
    output->ShallowCopy(input);
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    return 1;
  }
  auto end = littoral::MarchEnd::Goal;
  try
  {
    this->TakeInputs(inputVector, time);
    end = this->March(inputVector, time);
  }
  catch (const littoral::InvalidInput&)
  {
    this->Internals->Fail(output);
    throw;
  }
  if (end != littoral::MarchEnd::Goal || !this->WriteAll(input, output))
  {
    this->Internals->Fail(output); // what was carried halfway is of no use
    return end == littoral::MarchEnd::FailedInput ? littoral::FailedRequest(this) : 1;
  }
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  littoral::KeepRanges(output);
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
bool vtkCurrentDriftFilter::WriteAll(vtkDataObject* input, vtkDataObject* output)
{
  this->Internals->BeginFrame();
  const bool isDone = this->WriteLeaves(input, output);
  this->Internals->EndFrame();
  return isDone;
}

//----------------------------------------------------------------------------
bool vtkCurrentDriftFilter::WriteLeaves(vtkDataObject* input, vtkDataObject* output)
{
  auto* blocks = vtkDataObjectTree::SafeDownCast(input);
  std::size_t first = 0;
  if (!blocks)
  {
    output->ShallowCopy(input);
    return this->WriteLeaf(littoral::PointsIn(input), littoral::PointsIn(output), first);
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
    auto* points = littoral::PointsIn(leaf);
    if (!this->WriteLeaf(points, littoral::PointsIn(copy), first))
    {
      return false;
    }
    first += points->GetPoints() ? static_cast<std::size_t>(points->GetNumberOfPoints()) : 0;
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
  const littoral::DriftHistory& history = this->Internals->Scene;
  const vtkIdType count = input->GetNumberOfPoints();
  StillPoints& still = this->Internals->NextStill<Array>(input);
  auto* start = this->Internals->AreFree ? Array::SafeDownCast(input->GetPoints()->GetData()) : nullptr;
  const littoral::Slaves slaves = littoral::ReadSlaves(input);
  const littoral::StepCurrents currents = history.NextCurrents();
  // Where all points go the same way, nothing else is asked of them.
  const bool isShift = history.IsClosed() && slaves.Master.empty() && !this->GenerateCurrent;
  const Vector3 way = isShift ? history.ClosedWay(currents) : Vector3(0.0);
  const bool isTold = this->WayAsField && isShift && start; // not applied
  const auto places = this->Internals->Arrays.New<Array>("Points", 3, isTold ? 0 : count);
  const auto flow = littoral::NewArray<vtkFloatArray>(littoral::sea::Current, 3, this->GenerateCurrent ? count : 0);
  auto captured = isShift ? still.Captured : nullptr;
  if (!captured)
  {
    captured = littoral::NewArray<vtkUnsignedCharArray>(littoral::sea::Captured, 1, count);
  }
  const auto write = [&](vtkIdType id) {
    const vtkIdType master = slaves.Master.empty() ? -1 : slaves.Master[id];
    Vector3 place;
    littoral::DriftFate fate = littoral::DriftFate::Free;
    history.At(currents, first + static_cast<std::size_t>(master >= 0 ? master : id), place, fate);
    if (master >= 0)
    {
      Vector3 offset;
      slaves.Offset->GetTuple(id, &offset[0]);
      place += offset;
    }
    const Real tuple[3] = { static_cast<Real>(place.x), static_cast<Real>(place.y), static_cast<Real>(place.z) };
    places->SetTypedTuple(id, tuple);
    captured->SetValue(id, fate == littoral::DriftFate::Captured ? 1 : 0);
    if (this->GenerateCurrent)
    {
      const Vector3 velocity = currents.Velocity(place, 2);
      flow->SetTuple3(id, velocity.x, velocity.y, velocity.z);
    }
  };
  const bool done = isShift
    ? RunOnPoints(
        this, static_cast<std::size_t>(isTold ? 0 : count), 0.98, 1.0,
        [&](std::size_t begin, std::size_t end) {
          Real* to = places->GetPointer(0);
          start ? littoral::ShiftTriples(start->GetPointer(0) + 3 * begin, end - begin, way, to + 3 * begin)
                : Shift(history.GetStart(), first, way, begin, end, to);
        },
        ShiftedAtOnce)
    : RunOnPoints(this, static_cast<std::size_t>(count), 0.98, 1.0, [&](std::size_t begin, std::size_t end) {
        for (std::size_t id = begin; id < end; ++id)
        {
          write(static_cast<vtkIdType>(id));
        }
      });
  if (!done)
  {
    return false;
  }
  if (isShift && !still.Captured)
  {
    std::fill_n(captured->GetPointer(0), count, static_cast<unsigned char>(0));
    still.Captured = captured;
  }
  if (isTold)
  {
    littoral::AddField(output, littoral::sea::Way, { way.x, way.y, way.z });
  }
  else
  {
    if (isShift && start)
    {
      littoral::KeepShiftedRanges(start, way, places);
      littoral::KeepCommonWay(places, still.Start, way);
    }
    output->SetPoints(littoral::PointsWithRanges(places));
  }
  output->GetPointData()->AddArray(still.Start);
  output->GetPointData()->AddArray(captured);
  if (this->GenerateCurrent)
  {
    output->GetPointData()->AddArray(flow);
  }
  return true;
}

//----------------------------------------------------------------------------
int vtkCurrentDriftFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(this, request, outputs,
    "Cannot carry points: ", [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
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
  os << indent << "Coast: " << this->Coast << "\n";
  os << indent << "VelocityArray: " << (this->VelocityArray ? this->VelocityArray : "(none)") << "\n";
  os << indent << "GenerateCurrent: " << this->GenerateCurrent << "\n";
  os << indent << "WayAsField: " << this->WayAsField << "\n";
  os << indent << "TimeRange: " << this->TimeRange[0] << " " << this->TimeRange[1] << "\n";
}
