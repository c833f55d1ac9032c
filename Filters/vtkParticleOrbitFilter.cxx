// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkParticleOrbitFilter.h"

#include "Data/ArrayReader.h"
#include "Data/ArraySearch.h"
#include "Data/ArrayStamp.h"
#include "Data/Arrays.h"
#include "Data/CommonWay.h"
#include "Data/Followers.h"
#include "Data/FrameArrays.h"
#include "Data/Inputs.h"
#include "Data/LeafCopy.h"
#include "Data/SeaStateTable.h"
#include "Data/Tables.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Mistakes.h"
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
#include <optional>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkParticleOrbitFilter);

namespace
{

/// Points that one thread moves at a time.
constexpr std::size_t PointsAtOnce = 1 << 13;
/// Points that follow others, likewise.
constexpr std::size_t FollowersAtOnce = 1 << 17;
/// Maximum distance of points of the surface from sea level [m].
constexpr double SurfaceTolerance = 1e-3;

bool IsAtSeaLevel(vtkDataArray* centers, double level)
{
  const double tolerance = SurfaceTolerance + 2e-7 * std::abs(level); // of single precision
  const auto isNear = [=](double height) { return std::abs(height - level) <= tolerance; };
  // One point tells for most: ranges are not asked for where few points have none.
  return isNear(centers->GetComponent(0, 2)) && isNear(centers->GetRange(2)[0]) && isNear(centers->GetRange(2)[1]);
}

/// Numbers of trains, as they lie in memory or as a copy.
struct TrainCounts
{
  std::vector<int> Copy;
  const int* Values = nullptr; ///< null where all trains act
};

TrainCounts ReadTrainCounts(vtkPointSet* input)
{
  vtkDataArray* array = littoral::ArrayReader::OfPoints(input, "a set of particles").Find(littoral::sea::TrainCount, 1);
  const vtkIdType bad = littoral::FirstOutside(array, [](auto count) { return count >= 0; });
  if (bad >= 0)
  {
    littoral::Refuse("the point array TrainCount is negative at point ", bad, ".");
  }
  TrainCounts counts;
  auto* whole = vtkIntArray::SafeDownCast(array);
  counts.Values = whole ? whole->GetPointer(0) : nullptr;
  if (array && !whole)
  {
    littoral::SetSize(counts.Copy, array->GetNumberOfTuples());
    for (std::size_t id = 0; id < counts.Copy.size(); ++id)
    {
      counts.Copy[id] = static_cast<int>(std::min(array->GetComponent(static_cast<vtkIdType>(id), 0), 1e9));
    }
    counts.Values = counts.Copy.data();
  }
  return counts;
}

/// The order in which trains are taken; empty where they come as they are.
std::vector<int> ReadTrainOrder(vtkPointSet* input, std::size_t trains)
{
  std::vector<int> order;
  vtkDataArray* array = littoral::ArrayReader::OfFields(input, "a set of particles").Find(littoral::sea::TrainOrder, 1);
  for (vtkIdType n = 0; array && n < array->GetNumberOfTuples(); ++n)
  {
    littoral::ReadWhole("TrainOrder", array->GetComponent(n, 0), 0, VTK_INT_MAX, order.emplace_back());
  }
  if (!order.empty() && (order.size() != trains || !littoral::IsPermutation(order)))
  {
    littoral::Refuse(
      "the field array TrainOrder is no order of the ", trains, " trains of the sea state; it belongs to another one.");
  }
  return order;
}

/// Points that follow others, numbers of trains that act on the others, and the point from which on none acts.
struct Following
{
  TrainCounts Counts;
  littoral::Slaves Slaves;
  std::size_t Moving = 0;
  bool AnyRests = false; ///< of those behind, that is no slave
};

/// Number of the first points behind which no train acts on any.
std::size_t CountMoving(const TrainCounts& counts, std::size_t points)
{
  std::size_t moving = points;
  while (counts.Values && moving > 0 && counts.Values[moving - 1] == 0)
  {
    --moving;
  }
  return moving;
}

/// The same with the number of moving points, and whether others rest.
Following WithMoving(Following following, std::size_t points)
{
  following.Moving = CountMoving(following.Counts, points);
  const std::vector<vtkIdType>& masters = following.Slaves.Master;
  following.AnyRests = masters.empty() ? following.Moving < points
                                       : std::any_of(masters.begin() + static_cast<std::ptrdiff_t>(following.Moving),
                                           masters.end(), [](vtkIdType master) { return master < 0; });
  return following;
}

/// Reads the points that move with another one, and the numbers of trains of the others.
Following ReadFollowers(vtkPointSet* input)
{
  Following following{ ReadTrainCounts(input), littoral::ReadSlaves(input) };
  TrainCounts& counts = following.Counts;
  const littoral::Slaves& slaves = following.Slaves;
  // A slave needs no orbit. With masters first, whole blocks of slaves are passed over.
  const auto isIdle = [&](
                        std::size_t id) { return slaves.Master[id] < 0 || (counts.Values && counts.Values[id] == 0); };
  std::size_t id = 0;
  while (id < slaves.Master.size() && isIdle(id))
  {
    ++id;
  }
  const auto points = static_cast<std::size_t>(input->GetNumberOfPoints());
  if (id == slaves.Master.size()) // as written by vtkParticleLevelOfDetailFilter
  {
    return WithMoving(std::move(following), points);
  }
  std::vector<int> copy(slaves.Master.size(), std::numeric_limits<int>::max());
  for (id = 0; id < copy.size(); ++id)
  {
    copy[id] = slaves.Master[id] >= 0 ? 0 : counts.Values ? counts.Values[id] : copy[id];
  }
  counts.Copy = std::move(copy);
  counts.Values = counts.Copy.data();
  return WithMoving(std::move(following), points);
}

/// The points at rest, with their ranges, in the type of the moved ones.
template <typename Array>
vtkSmartPointer<Array> CentersOf(vtkPointSet* input)
{
  auto centers = vtkSmartPointer<littoral::SharedArray<Array>>::New();
  centers->Share(littoral::WithType<Array>(input->GetPoints()->GetData()));
  centers->SetName("Center");
  littoral::ShareRanges(input->GetPoints()->GetData(), centers);
  if (!littoral::AreWithin(centers, littoral::MaximumMagnitude))
  {
    littoral::ArrayReader::OfPoints(input, "a set of particles").NeedFinite(input->GetPoints()->GetData());
  }
  return centers;
}

/// The points of a leaf at rest, and what was read of its arrays: both are looked at again only when they have changed.
struct RestingPoints
{
  vtkPointSet* Leaf = nullptr; ///< compared, never used
  vtkMTimeType Time = 0;
  vtkSmartPointer<vtkDataArray> Centers;
  std::vector<littoral::ArrayStamp> Read;
  vtkIdType Points = 0; ///< when it was read
  Following Followed;
};

/// The arrays of moved points.
template <typename Array>
struct MovedArrays
{
  using Real = typename Array::ValueType;

  vtkSmartPointer<Array> Positions;
  vtkSmartPointer<Array> Normals;  ///< null unless a surface moves
  vtkSmartPointer<Array> Jacobian; ///< null unless a surface moves
  std::vector<Real> Gradient;      ///< of the surface, five numbers a point
  littoral::OrbitRequest<Real> Request;
  std::vector<Real*> Vectors;                ///< vectors that slaves take over from their masters
  std::vector<littoral::TupleRanges> Ranges; ///< of PointsAtOnce positions each

  /// Adds the arrays that are wanted.
  MovedArrays(
    littoral::FrameArrays& memory, Array* centers, bool velocity, bool acceleration, bool surface, vtkPointData* arrays)
    : Positions(memory.New<Array>("Points", 3, centers->GetNumberOfTuples()))
  {
    const vtkIdType count = centers->GetNumberOfTuples();
    arrays->AddArray(centers);
    this->Request.Centers = centers->GetPointer(0);
    this->Request.Displacement = this->Positions->GetPointer(0);
    this->Request.AddsCenters = true;
    this->Ranges.resize((static_cast<std::size_t>(count) + PointsAtOnce - 1) / PointsAtOnce);
    this->Vectors = { this->Request.Displacement };
    const auto add = [&](const char* name) {
      const auto array = memory.New<Array>(name, 3, count);
      arrays->AddArray(array);
      this->Vectors.push_back(array->GetPointer(0));
      return array->GetPointer(0);
    };
    this->Request.Velocity = velocity ? add("Velocity") : nullptr;
    this->Request.Acceleration = acceleration ? add("Acceleration") : nullptr;
    if (surface)
    {
      this->Normals = memory.New<Array>("Normals", 3, count);
      this->Jacobian = memory.New<Array>("Jacobian", 1, count);
      littoral::SetSize(this->Gradient, 5 * count);
      this->Request.Gradient = this->Gradient.data();
      arrays->SetNormals(this->Normals);
      arrays->AddArray(this->Jacobian);
    }
  }

  MovedArrays(const MovedArrays&) = delete;
  MovedArrays& operator=(const MovedArrays&) = delete;

  /// Finds the ranges of points that are in place, while they are in the cache.
  void AddRanges(bool areInPlace, std::size_t begin, std::size_t end)
  {
    if (areInPlace)
    {
      const Real* values = this->Request.Displacement;
      this->Ranges[begin / PointsAtOnce].AddTuples(values + 3 * begin, values + 3 * end, 3);
    }
  }

  /// The moved points, with their ranges.
  vtkSmartPointer<vtkPoints> Points() const
  {
    littoral::KeepRangesOfParts(this->Positions, this->Ranges);
    return littoral::PointsWithRanges(this->Positions);
  }

  /// Normals and Jacobians of a surface from its gradients.
  void FinishSurface(std::size_t begin, std::size_t end)
  {
    for (std::size_t id = begin; this->Normals && id < end; ++id)
    {
      const Real* from = &this->Gradient[5 * id];
      const double slope[5] = { from[0], from[1], from[2], from[3], from[4] };
      const littoral::Vector3 normal = littoral::SurfaceNormal(slope);
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Normals->SetValue(3 * id + axis, static_cast<Real>(normal[axis]));
      }
      this->Jacobian->SetValue(id, static_cast<Real>(littoral::SurfaceJacobian(slope)));
    }
  }

  /// Leaves points where they are on which no train acts, but for slaves.
  void Rest(const littoral::Slaves& slaves, std::size_t begin, std::size_t end)
  {
    for (std::size_t id = begin; id < end; ++id)
    {
      if (!slaves.Master.empty() && slaves.Master[id] >= 0)
      {
        continue;
      }
      for (Real* values : this->Vectors)
      {
        std::fill_n(values + 3 * id, 3, Real(0.0));
      }
      std::copy_n(this->Request.Centers + 3 * id, 3, this->Request.Displacement + 3 * id);
    }
  }

  /// Takes slaves along. Masters are no slaves: what is read here is not written here.
  void Follow(const littoral::Slaves& slaves, std::size_t begin, std::size_t end)
  {
    const auto at = [&](std::size_t n) {
      return slaves.OffsetAt(static_cast<vtkIdType>(n / 3), static_cast<int>(n % 3));
    };
    const vtkIdType* masters = slaves.Master.data();
    slaves.SingleOffsets ? this->FollowBy(
                             masters, [from = slaves.SingleOffsets](std::size_t n) { return from[n]; }, begin, end)
                         : this->FollowBy(masters, at, begin, end);
  }

private:
  /// The same with an offset for each coordinate. A sum of two numbers in single precision is the same in both
  /// precisions.
  template <typename OffsetAt>
  void FollowBy(const vtkIdType* masters, const OffsetAt& offsetAt, std::size_t begin, std::size_t end)
  {
    using Sum = decltype(Real(0.0) + offsetAt(0));
    Real* places = this->Request.Displacement;
    for (std::size_t id = begin; id < end; ++id)
    {
      if (masters[id] < 0)
      {
        continue;
      }
      // Read all before writing any: the compiler cannot know that a master is no slave.
      const Real* own = places + 3 * masters[id];
      const Sum moved[3] = { static_cast<Sum>(own[0]) + static_cast<Sum>(offsetAt(3 * id)),
        static_cast<Sum>(own[1]) + static_cast<Sum>(offsetAt(3 * id + 1)),
        static_cast<Sum>(own[2]) + static_cast<Sum>(offsetAt(3 * id + 2)) };
      std::transform(moved, moved + 3, places + 3 * id, [](Sum place) { return static_cast<Real>(place); });
    }
    std::for_each(this->Vectors.begin() + 1, this->Vectors.end(), [=](Real* values) {
      for (std::size_t id = begin; id < end; ++id)
      {
        std::copy_n(values + 3 * std::max<vtkIdType>(0, masters[id]), masters[id] >= 0 ? 3 : 0, values + 3 * id);
      }
    });
  }
};

/// Adds the depth regimes of the trains, and the highest of them, as field data.
void AddRegimes(const littoral::SeaState& state, vtkDataObject* output)
{
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
}

}

/// The sea at the requested time.
class vtkParticleOrbitFilter::Sea
{
public:
  Sea(const littoral::SeaState& state, const littoral::WaveOrbitOptions& options, double time)
    : State(state)
    , Options(options)
    , Time(time)
  {
  }

  /// The orbits in it, with its trains in an order; leaves mostly have one order.
  const littoral::WaveOrbits& InOrder(const std::vector<int>& order)
  {
    if (!this->Orbits || order != this->Order)
    {
      this->Orbits.emplace(littoral::Ordered(this->State, order), this->Options, this->Time);
      this->Order = order;
    }
    return *this->Orbits;
  }

  littoral::SeaState State;

private:
  littoral::WaveOrbitOptions Options;
  double Time;
  std::vector<int> Order;
  std::optional<littoral::WaveOrbits> Orbits;
};

/// State that one frame leaves to the next one.
class vtkParticleOrbitFilter::vtkInternals : public littoral::LeafFrames<RestingPoints>
{
public:
  std::vector<littoral::LeafCopy> Copies; ///< of the leaves of a composite

  /// Refuses more points than there is memory for. As many as before have theirs.
  void RequireRoom(double bytesOfPoint, vtkIdType count)
  {
    if (count > this->Granted)
    {
      littoral::RequireMemory(
        bytesOfPoint * static_cast<double>(count), "the motion of " + std::to_string(count) + " points", "take fewer");
      this->Granted = count;
    }
  }

  /// The points at rest of the next leaf.
  template <typename Array>
  RestingPoints& RestOf(vtkPointSet* leaf)
  {
    RestingPoints& rest = this->NextEntry();
    if (rest.Leaf != leaf || rest.Time != leaf->GetMTime() || !Array::SafeDownCast(rest.Centers))
    {
      rest.Leaf = leaf;
      rest.Time = leaf->GetMTime();
      rest.Centers = ::CentersOf<Array>(leaf);
    }
    return rest;
  }

  /// Followers in the leaf of an entry.
  static const Following& FollowingOf(vtkPointSet* leaf, RestingPoints& rest)
  {
    std::vector<littoral::ArrayStamp> read;
    const auto arrays = littoral::ArrayReader::OfPoints(leaf, "a set of particles");
    for (const char* name : { littoral::sea::TrainCount, littoral::sea::MasterId, littoral::sea::Offset })
    {
      read.push_back(littoral::StampOf(arrays.Any(name)));
    }
    if (rest.Read != read || rest.Points != leaf->GetNumberOfPoints())
    {
      rest.Read.clear();
      rest.Followed = ReadFollowers(leaf);
      rest.Read = std::move(read);
      rest.Points = leaf->GetNumberOfPoints();
    }
    return rest.Followed;
  }

private:
  vtkIdType Granted = 0; ///< most points that had memory
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
  , Internals(new vtkInternals)
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
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet"); // whole, to say once that it is none
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // no sea state: our own message, once
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
std::string vtkParticleOrbitFilter::WhyBadProperties(double time) const
{
  littoral::ParameterCheck check;
  check.Range("Choppiness", this->Choppiness, 0.0, 1.0);
  if (this->DopplerShift)
  {
    check.Finite("Current[0]", this->Current[0], "m/s");
    check.Finite("Current[1]", this->Current[1], "m/s");
  }
  check.Increasing("TimeRange", this->TimeRange, "s");
  check.Finite("the requested time", time, "s");
  return check.Reason();
}

//----------------------------------------------------------------------------
int vtkParticleOrbitFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (inputVector[1]->GetNumberOfInformationObjects() == 0)
  {
    vtkDataObject::GetData(outputVector)->ShallowCopy(vtkDataObject::GetData(inputVector[0]));
    return littoral::FailedBy(this, "There is no sea state: connect one to Sea State. The points stay where they are.");
  }
  const double time = littoral::RequestedTime(outputVector->GetInformationObject(0));
  const littoral::SeaState state = littoral::ReadSeaState(littoral::InputOf<vtkTable>(inputVector[1], "Sea State"));
  littoral::PointSetsOf(vtkDataObject::GetData(inputVector[0]), "Input");
  littoral::Require(this->WhyBadProperties(time));
  littoral::WaveOrbitOptions options;
  options.StokesDrift = this->StokesDrift;
  options.DopplerShift = this->DopplerShift;
  std::copy(this->Current, this->Current + 2, options.Current);
  options.Choppiness = this->Choppiness;

  this->SetProgressText("Moving points");
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  Sea sea(state, options, time);
  this->Internals->BeginFrame();
  this->MoveAll(sea, vtkDataObject::GetData(inputVector[0]), output);
  this->Internals->EndFrame();
  AddRegimes(state, output);
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  littoral::KeepRanges(output, littoral::PollOf(this));
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
void vtkParticleOrbitFilter::MoveAll(Sea& sea, vtkDataObject* input, vtkDataObject* output)
{
  auto* blocks = vtkDataObjectTree::SafeDownCast(input);
  if (!blocks)
  {
    this->Internals->Copies.clear();
    output->ShallowCopy(input);
    this->Move(sea, littoral::PointsIn(input), littoral::PointsIn(output));
    return;
  }
  auto* moved = vtkDataObjectTree::SafeDownCast(output);
  moved->CopyStructure(blocks);
  auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
  std::vector<littoral::LeafCopy>& copies = this->Internals->Copies;
  std::size_t leaves = 0;
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem(), ++leaves)
  {
    vtkDataObject* leaf = iterator->GetCurrentDataObject();
    copies.resize(std::max(copies.size(), leaves + 1));
    vtkDataObject* copy = copies[leaves].Of(leaf);
    this->Move(sea, littoral::PointsIn(leaf), littoral::PointsIn(copy));
    moved->SetDataSet(iterator, copy);
  }
  copies.resize(leaves);
}

//----------------------------------------------------------------------------
void vtkParticleOrbitFilter::Move(Sea& sea, vtkPointSet* input, vtkPointSet* output)
{
  if (!input->GetPoints() || input->GetNumberOfPoints() == 0)
  {
    return;
  }
  littoral::RequireInPlace(input);
  const littoral::WaveOrbits& orbits = sea.InOrder(ReadTrainOrder(input, sea.State.Trains.size()));
  input->GetPoints()->GetDataType() == VTK_DOUBLE
    ? this->MoveAs<vtkDoubleArray>(orbits, sea.State.SeaLevel, input, output)
    : this->MoveAs<vtkFloatArray>(orbits, sea.State.SeaLevel, input, output);
}

//----------------------------------------------------------------------------
template <typename Array>
void vtkParticleOrbitFilter::MoveAs(
  const littoral::WaveOrbits& orbits, double seaLevel, vtkPointSet* input, vtkPointSet* output)
{
  const vtkIdType count = input->GetNumberOfPoints();
  this->Internals->RequireRoom(17.0 * sizeof(typename Array::ValueType), count);
  RestingPoints& rest = this->Internals->RestOf<Array>(input);
  auto* centers = Array::SafeDownCast(rest.Centers);
  const Following& following = this->Internals->FollowingOf(input, rest);
  const littoral::Slaves& slaves = following.Slaves;
  const bool surface = this->GenerateSurface && IsAtSeaLevel(centers, seaLevel);
  if (following.Moving == 0 && slaves.Master.empty() && !this->GenerateVelocity && !this->GenerateAcceleration &&
    !surface)
  {
    output->GetPointData()->AddArray(centers);
    auto* places = Array::SafeDownCast(input->GetPoints()->GetData());
    output->SetPoints(littoral::PointsWithRanges(places ? places : centers));
    return;
  }
  MovedArrays<Array> moved(this->Internals->Arrays, centers, this->GenerateVelocity, this->GenerateAcceleration,
    surface, output->GetPointData());
  moved.Request.TrainCounts = following.Counts.Values;
  const auto forAll = [&](double first, double last, std::size_t points, std::size_t atOnce, const auto& task) {
    const std::size_t batches = (points + atOnce - 1) / atOnce;
    return littoral::RunWithProgress(this, batches, first, last,
      [&](std::size_t batch) { task(batch * atOnce, std::min((batch + 1) * atOnce, points)); });
  };
  // Slaves come last, as written by vtkParticleLevelOfDetailFilter: their orbits are not evaluated.
  const std::size_t evaluated = surface ? static_cast<std::size_t>(count) : following.Moving;
  bool done = forAll(0.0, 0.8, evaluated, PointsAtOnce, [&](std::size_t begin, std::size_t end) {
    orbits.Evaluate(moved.Request, begin, end);
    moved.FinishSurface(begin, end);
    moved.AddRanges(slaves.Master.empty() && evaluated == static_cast<std::size_t>(count), begin, end);
  });
  if (done && !(slaves.Master.empty() && evaluated == static_cast<std::size_t>(count)))
  {
    done = forAll(0.8, 1.0, static_cast<std::size_t>(count), FollowersAtOnce, [&](std::size_t first, std::size_t last) {
      for (std::size_t begin = first; begin < last; begin += PointsAtOnce)
      {
        const std::size_t end = std::min(begin + PointsAtOnce, last);
        if (following.AnyRests)
        {
          moved.Rest(slaves, std::max(begin, evaluated), end);
        }
        if (!slaves.Master.empty())
        {
          moved.Follow(slaves, begin, end);
        }
        moved.AddRanges(true, begin, end);
      }
    });
  }
  if (!done) // aborted
  {
    output->Initialize();
    return;
  }
  output->SetPoints(moved.Points());
  const double folded = surface ? moved.Jacobian->GetRange()[0] : 1.0;
  if (folded <= 0.0)
  {
    littoralWarningMacro("The surface folds over itself (smallest Jacobian " << folded << "): take less Choppiness.");
  }
}

//----------------------------------------------------------------------------
int vtkParticleOrbitFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(this, request, outputs,
    "Cannot move points: ", [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
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
