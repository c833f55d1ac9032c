// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkParticleOrbitFilter.h"

#include "Data/Arrays.h"
#include "Data/Followers.h"
#include "Data/SeaStateTable.h"
#include "Data/Tables.h"
#include "Pipeline/Pipeline.h"
#include "Pipeline/Ranges.h"
#include "Sea/Dispersion.h"
#include "Sea/TrainSelection.h"
#include "Sea/WaveOrbits.h"

#include "vtkCompositeDataIterator.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataObjectTree.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
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
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkParticleOrbitFilter);

namespace
{

/// Points that one thread moves at a time.
constexpr vtkIdType PointsAtOnce = 1 << 13;
/// How far from sea level the points of its surface may lie [m].
constexpr double SurfaceTolerance = 1e-3;

bool IsAtSeaLevel(vtkPoints* points, double level)
{
  double bounds[6];
  points->GetBounds(bounds);
  const double single = 2e-7 * std::abs(level);
  return std::abs(bounds[4] - level) <= SurfaceTolerance + single &&
    std::abs(bounds[5] - level) <= SurfaceTolerance + single;
}

std::string ReadTrainCounts(vtkPointSet* input, std::vector<int>& counts)
{
  vtkDataArray* array = input->GetPointData()->GetArray(littoral::sea::TrainCount);
  if (!array)
  {
    return "";
  }
  if (array->GetNumberOfComponents() != 1)
  {
    return "the point array TrainCount must have one component.";
  }
  counts.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t id = 0; id < counts.size(); ++id)
  {
    const double count = array->GetTuple1(static_cast<vtkIdType>(id));
    if (!(count >= 0.0))
    {
      return "the point array TrainCount is negative at point " + std::to_string(id) + ".";
    }
    counts[id] = static_cast<int>(std::min(count, 1e9));
  }
  return "";
}

/// The order in which trains are taken; empty where they come as they are.
std::string ReadTrainOrder(vtkPointSet* input, std::size_t trains, std::vector<int>& order)
{
  vtkDataArray* array = input->GetFieldData()->GetArray(littoral::sea::TrainOrder);
  for (vtkIdType n = 0; array && n < array->GetNumberOfTuples(); ++n)
  {
    order.push_back(static_cast<int>(array->GetComponent(n, 0)));
  }
  if (!order.empty() && (order.size() != trains || !littoral::IsPermutation(order)))
  {
    return "the field array TrainOrder is no order of the " + std::to_string(trains) +
      " trains of the sea state; it belongs to another one.";
  }
  return "";
}

}

/// The sea at the requested time.
class vtkParticleOrbitFilter::Sea
{
public:
  Sea(const littoral::SeaState& state, const littoral::WaveOrbitOptions& options, double time)
    : Orbits(state, options, time)
    , State(state)
    , Options(options)
    , Time(time)
  {
  }

  /// The same with its trains in an order.
  Sea InOrder(const std::vector<int>& order) const
  {
    return Sea(littoral::Ordered(this->State, order), this->Options, this->Time);
  }

  littoral::WaveOrbits Orbits;
  littoral::SeaState State;
  littoral::WaveOrbitOptions Options;
  double Time;
};

//----------------------------------------------------------------------------
vtkParticleOrbitFilter::vtkParticleOrbitFilter()
  : StokesDrift(false)
  , DopplerShift(false)
  , Current{ 0.0, 0.0 }
  , Choppiness(1.0)
  , GenerateVelocity(false)
  , GenerateAcceleration(false)
  , GenerateSurface(true)
  , TimeRange{ 0.0, 60.0 }
{
  this->SetNumberOfInputPorts(2);
}

//----------------------------------------------------------------------------
vtkParticleOrbitFilter::~vtkParticleOrbitFilter() = default;

//----------------------------------------------------------------------------
int vtkParticleOrbitFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
    return 1;
  }
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkMultiBlockDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPartitionedDataSetCollection");
  return 1;
}

//----------------------------------------------------------------------------
int vtkParticleOrbitFilter::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  littoral::AnnounceTimes(outputVector->GetInformationObject(0), this->TimeRange);
  return 1;
}

//----------------------------------------------------------------------------
int vtkParticleOrbitFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  littoral::RequestAll(inputVector[1]->GetInformationObject(0));
  return 1;
}

//----------------------------------------------------------------------------
int vtkParticleOrbitFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  littoral::SeaState state;
  std::string reason = littoral::ReadSeaState(vtkTable::GetData(inputVector[1]), state);
  if (reason.empty() && !(this->Choppiness >= 0.0 && this->Choppiness <= 1.0))
  {
    reason = "Choppiness is " + std::to_string(this->Choppiness) + "; it must be 0 to 1.";
  }
  if (reason.empty() && this->DopplerShift && !(std::isfinite(this->Current[0]) && std::isfinite(this->Current[1])))
  {
    reason = "Current must be finite.";
  }
  if (reason.empty() && !(this->TimeRange[0] < this->TimeRange[1]))
  {
    reason = "TimeRange must be increasing.";
  }
  const double time = littoral::RequestedTime(outputVector->GetInformationObject(0));
  if (reason.empty() && !std::isfinite(time))
  {
    reason = "the requested time is no number.";
  }
  if (!reason.empty())
  {
    vtkErrorMacro("Cannot move points: " << reason);
    return 0;
  }
  littoral::WaveOrbitOptions options;
  options.StokesDrift = this->StokesDrift;
  options.DopplerShift = this->DopplerShift;
  std::copy(this->Current, this->Current + 2, options.Current);
  options.Choppiness = this->Choppiness;
  const Sea sea(state, options, time);

  this->SetProgressText("Moving points");
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  bool good = true;
  if (auto* blocks = vtkDataObjectTree::SafeDownCast(input))
  {
    auto* moved = vtkDataObjectTree::SafeDownCast(output);
    moved->CopyStructure(blocks);
    auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    for (iterator->InitTraversal(); good && !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      vtkDataObject* leaf = iterator->GetCurrentDataObject();
      auto copy = vtkSmartPointer<vtkDataObject>::Take(leaf->NewInstance());
      copy->ShallowCopy(leaf);
      auto* points = vtkPointSet::SafeDownCast(leaf);
      good = !points || this->Move(sea, points, vtkPointSet::SafeDownCast(copy));
      moved->SetDataSet(iterator, copy);
    }
  }
  else
  {
    output->ShallowCopy(input);
    good = this->Move(sea, vtkPointSet::SafeDownCast(input), vtkPointSet::SafeDownCast(output));
  }
  if (!good)
  {
    output->Initialize();
    return 0;
  }
  double regimes[3] = { 0.0, 0.0, 0.0 };
  const littoral::WaveTrain* highest = &state.Trains.front();
  for (const littoral::WaveTrain& train : state.Trains)
  {
    regimes[static_cast<int>(littoral::RegimeOf(train.WaveNumber, state.Depth))] += 1.0;
    highest = train.Amplitude > highest->Amplitude ? &train : highest;
  }
  const auto regime = littoral::RegimeOf(highest->WaveNumber, state.Depth);
  littoral::AddText(output, "DepthRegime", littoral::RegimeName(regime));
  littoral::AddField(output, "RegimeTrains", { regimes[0], regimes[1], regimes[2] });
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  littoral::KeepRanges(output);
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
bool vtkParticleOrbitFilter::Move(const Sea& sea, vtkPointSet* input, vtkPointSet* output)
{
  if (!input->GetPoints() || input->GetNumberOfPoints() == 0)
  {
    return true;
  }
  std::vector<int> order;
  const std::string reason = ReadTrainOrder(input, sea.State.Trains.size(), order);
  if (!reason.empty())
  {
    vtkErrorMacro("Cannot move points: " << reason);
    return false;
  }
  const Sea ordered = sea.InOrder(order);
  return input->GetPoints()->GetDataType() == VTK_DOUBLE ? this->MoveAs<vtkDoubleArray>(ordered, input, output)
                                                         : this->MoveAs<vtkFloatArray>(ordered, input, output);
}

//----------------------------------------------------------------------------
template <typename Array>
bool vtkParticleOrbitFilter::MoveAs(const Sea& sea, vtkPointSet* input, vtkPointSet* output)
{
  using Real = typename Array::ValueType;
  const vtkIdType count = input->GetNumberOfPoints();
  std::vector<int> trainCounts;
  littoral::Slaves slaves;
  std::string reason = ReadTrainCounts(input, trainCounts);
  if (reason.empty())
  {
    reason = littoral::ReadSlaves(input, slaves);
  }
  if (reason.empty() && !slaves.Master.empty())
  {
    // A slave needs no orbit. With masters first, whole blocks of slaves are passed over.
    trainCounts.resize(slaves.Master.size(), std::numeric_limits<int>::max());
    for (std::size_t id = 0; id < slaves.Master.size(); ++id)
    {
      trainCounts[id] = slaves.Master[id] >= 0 ? 0 : trainCounts[id];
    }
  }
  if (reason.empty() && 17.0 * sizeof(Real) * static_cast<double>(count) > littoral::AvailableMemory())
  {
    reason = std::to_string(count) + " points are more than this machine has memory for.";
  }
  if (!reason.empty())
  {
    vtkErrorMacro("Cannot move points: " << reason);
    return false;
  }

  const bool surface = this->GenerateSurface && IsAtSeaLevel(input->GetPoints(), sea.State.SeaLevel);
  auto center = vtkSmartPointer<Array>::New();
  if (Array* own = Array::SafeDownCast(input->GetPoints()->GetData()))
  {
    center->ShallowCopy(own);
  }
  else
  {
    center->DeepCopy(input->GetPoints()->GetData());
  }
  center->SetName("Center");
  vtkSmartPointer<Array> place = littoral::NewArray<Array>("Points", 3, count);
  vtkPointData* arrays = output->GetPointData();
  arrays->AddArray(center);
  littoral::OrbitRequest<Real> request;
  request.Centers = center->GetPointer(0);
  request.TrainCounts = trainCounts.empty() ? nullptr : trainCounts.data();
  request.Displacement = place->GetPointer(0);
  std::vector<Real*> vectors{ request.Displacement };
  const auto add = [&](const char* name) {
    vtkSmartPointer<Array> array = littoral::NewArray<Array>(name, 3, count);
    arrays->AddArray(array);
    vectors.push_back(array->GetPointer(0));
    return array->GetPointer(0);
  };
  if (this->GenerateVelocity)
  {
    request.Velocity = add("Velocity");
  }
  if (this->GenerateAcceleration)
  {
    request.Acceleration = add("Acceleration");
  }
  vtkSmartPointer<Array> normals;
  vtkSmartPointer<Array> jacobian;
  std::vector<Real> gradient;
  if (surface)
  {
    normals = littoral::NewArray<Array>("Normals", 3, count);
    jacobian = littoral::NewArray<Array>("Jacobian", 1, count);
    gradient.resize(5 * static_cast<std::size_t>(count));
    request.Gradient = gradient.data();
    arrays->SetNormals(normals);
    arrays->AddArray(jacobian);
  }

  const auto forAll = [&](double first, double last, const auto& task) {
    const std::size_t batches = static_cast<std::size_t>((count + PointsAtOnce - 1) / PointsAtOnce);
    return littoral::RunWithProgress(this, batches, first, last, [&](std::size_t batch) {
      const std::size_t begin = batch * PointsAtOnce;
      task(begin, std::min<std::size_t>(begin + PointsAtOnce, static_cast<std::size_t>(count)));
    });
  };
  const bool anySlaves = !slaves.Master.empty();
  const auto shift = [&](std::size_t begin, std::size_t end) {
    for (std::size_t value = 3 * begin; value < 3 * end; ++value)
    {
      const double moved = static_cast<double>(request.Displacement[value]) + request.Centers[value];
      request.Displacement[value] = static_cast<Real>(moved);
    }
  };
  bool done = forAll(0.0, 0.8, [&](std::size_t begin, std::size_t end) {
    sea.Orbits.Evaluate(request, begin, end);
    shift(begin, end);
    for (std::size_t id = begin; surface && id < end; ++id)
    {
      const Real* from = &gradient[5 * id];
      const double slope[5] = { from[0], from[1], from[2], from[3], from[4] };
      const littoral::Vector3 normal = littoral::SurfaceNormal(slope);
      for (int axis = 0; axis < 3; ++axis)
      {
        normals->SetValue(3 * id + axis, static_cast<Real>(normal[axis]));
      }
      jacobian->SetValue(id, static_cast<Real>(littoral::SurfaceJacobian(slope)));
    }
  });
  if (done && anySlaves)
  {
    // Masters are no slaves: what is read here is not written here.
    done = forAll(0.8, 1.0, [&](std::size_t begin, std::size_t end) {
      for (std::size_t id = begin; id < end; ++id)
      {
        const vtkIdType master = slaves.Master[id];
        for (int axis = 0; master >= 0 && axis < 3; ++axis)
        {
          for (Real* values : vectors)
          {
            values[3 * id + axis] = values[3 * master + axis];
          }
          const double offset = slaves.Offset->GetComponent(static_cast<vtkIdType>(id), axis);
          Real& value = request.Displacement[3 * id + axis];
          value = static_cast<Real>(static_cast<double>(value) + offset);
        }
      }
    });
  }
  if (!done) // aborted
  {
    output->Initialize();
    return true;
  }
  vtkNew<vtkPoints> points;
  points->SetData(place);
  output->SetPoints(points);
  if (surface)
  {
    const double folded = jacobian->GetRange()[0];
    if (folded <= 0.0)
    {
      vtkWarningMacro("The surface folds over itself (smallest Jacobian " << folded << "): take less Choppiness.");
    }
  }
  return true;
}

//----------------------------------------------------------------------------
void vtkParticleOrbitFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "StokesDrift: " << this->StokesDrift << "\n";
  os << indent << "DopplerShift: " << this->DopplerShift << "\n";
  os << indent << "Current: " << this->Current[0] << " " << this->Current[1] << "\n";
  os << indent << "Choppiness: " << this->Choppiness << "\n";
  os << indent << "GenerateVelocity: " << this->GenerateVelocity << "\n";
  os << indent << "GenerateAcceleration: " << this->GenerateAcceleration << "\n";
  os << indent << "GenerateSurface: " << this->GenerateSurface << "\n";
  os << indent << "TimeRange: " << this->TimeRange[0] << " " << this->TimeRange[1] << "\n";
}
