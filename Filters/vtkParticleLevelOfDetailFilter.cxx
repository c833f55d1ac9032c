// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkParticleLevelOfDetailFilter.h"

#include "Data/ArrayReader.h"
#include "Data/ArrayStamp.h"
#include "Data/Arrays.h"
#include "Data/Blocks.h"
#include "Data/CommonWay.h"
#include "Data/FrameArrays.h"
#include "Data/Inputs.h"
#include "Data/ParticleBlocks.h"
#include "Data/PickedTuples.h"
#include "Data/SeaStateTable.h"
#include "Data/Tables.h"
#include "Geometry/ViewFrustum.h"
#include "Numerics/ParameterCheck.h"
#include "Numerics/ShiftedTriples.h"
#include "Particles/ParticleGroups.h"
#include "Particles/ParticleLevels.h"
#include "Particles/ParticleMotion.h"
#include "Pipeline/Pipeline.h"
#include "Pipeline/Ranges.h"
#include "Sea/TrainSelection.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkParticleLevelOfDetailFilter);

namespace
{

/// Memory of a particle here and in the output at most, without its own arrays [bytes].
constexpr double BytesAParticle = 400.0;

/// Groups by where particles began hold as long as their ways differ by no more than this part of the largest offset.
constexpr double LargestSpread = 0.25;

[[noreturn]] void RefuseInfinite(const littoral::PlaceList& places)
{
  std::size_t n = 0;
  while (littoral::IsFinite(places[n]))
  {
    ++n;
  }
  littoral::Refuse("point ", n, " has a coordinate that is no finite number.");
}

/// Levels are chosen for all ways of particles between multiples of this length, so that they stay for some frames of a
/// current [m].
constexpr double WayStep = 0.2;

/// Ways that are below a multiple by no more count as those from it on: sums are rounded, and a choice of levels holds
/// within as much [m].
constexpr double WaySlack = 1e-6;

/// Maximum length of the steps of fog, much less than its cells [m].
constexpr double LargestFogStep = 0.02;

/// Length of the steps by which particles that are fog go where all go the same way: so many pixels where fog is
/// nearest [m].
double FogStep(const littoral::View& view, const littoral::ParticleLevelOptions& options, double pixels)
{
  const double nearest = view.DetailFactor * std::max(0.0, options.FarDistance - options.BlendDistance);
  return std::min(LargestFogStep, pixels * 2.0 * nearest * std::tan(0.5 * view.Angle) / view.Height);
}

/// The ways between multiples of WayStep about some ways. A multiple but 0 counts to those above it: one that all have
/// gone asks for no choice of its own.
littoral::Box RoundedWays(const littoral::Box& ways)
{
  const auto floor = [](const littoral::Vector3& way) { return WayStep * glm::floor((way + WaySlack) / WayStep); };
  littoral::Box rounded{ floor(ways.Low), littoral::Vector3(0.0) };
  for (int axis = 0; axis < 3; ++axis)
  {
    rounded.High[axis] = ways.High[axis] == 0.0 ? 0.0 : floor(ways.High)[axis] + WayStep;
  }
  return rounded;
}

/// The way that all particles have gone from their points, where they began; none where they are in place.
std::optional<littoral::Vector3> ToldWay(vtkPointSet* particles)
{
  const auto fields = littoral::ArrayReader::OfFields(particles, "Input", 1);
  vtkDataArray* way = fields.Find(littoral::sea::Way, 3);
  fields.NeedFinite(way);
  return way
    ? std::optional(littoral::Vector3(way->GetComponent(0, 0), way->GetComponent(0, 1), way->GetComponent(0, 2)))
    : std::nullopt;
}

/// Points that all have gone a way.
template <typename Array>
vtkSmartPointer<vtkDataArray> Shifted(vtkDataArray* points, const littoral::Vector3& way)
{
  const auto shifted = littoral::NewArray<Array>("Points", 3, points->GetNumberOfTuples());
  littoral::ShiftTriples(Array::SafeDownCast(points)->GetPointer(0),
    static_cast<std::size_t>(points->GetNumberOfTuples()), way, shifted->GetPointer(0));
  return shifted;
}

/// Places in single or double precision.
littoral::PlaceList ListOf(vtkDataArray* places)
{
  const auto count = static_cast<std::size_t>(places->GetNumberOfTuples());
  if (auto* singles = vtkFloatArray::SafeDownCast(places))
  {
    return { singles->GetPointer(0), count };
  }
  return { vtkDoubleArray::SafeDownCast(places)->GetPointer(0), count };
}

constexpr littoral::ParticleLevel Levels[] = { littoral::ParticleLevel::Near, littoral::ParticleLevel::Middle,
  littoral::ParticleLevel::Far };

/// Numbers from 0 on, of which all blocks show the first ones.
class CountingArray
{
public:
  /// One vertex for each point.
  vtkSmartPointer<vtkCellArray> Vertices(vtkIdType count)
  {
    const vtkIdType had = this->Numbers->GetNumberOfTuples();
    if (had < count + 1)
    {
      // New memory: that of the blocks before stays as it is.
      this->Numbers = littoral::NewArray<vtkIdTypeArray>("", 1, count + 1);
      std::iota(this->Numbers->GetPointer(0), this->Numbers->GetPointer(0) + count + 1, vtkIdType{ 0 });
    }
    auto vertices = vtkSmartPointer<vtkCellArray>::New();
    vertices->SetData(this->First(count + 1), this->First(count));
    return vertices;
  }

private:
  vtkSmartPointer<vtkIdTypeArray> First(vtkIdType count) const
  {
    auto first = vtkSmartPointer<vtkIdTypeArray>::New();
    if (count > 0) // VTK would free the memory of an array of no tuples
    {
      first->ShallowCopy(this->Numbers);
      littoral::SetTuples(first, count);
    }
    return first;
  }

  vtkSmartPointer<vtkIdTypeArray> Numbers = vtkSmartPointer<vtkIdTypeArray>::New();
};

/// Arrays that are made here, whatever the input has of that name.
const char* const MadeHere[] = { littoral::sea::Alpha, littoral::sea::TrainCount, littoral::sea::ErrorBound,
  littoral::sea::MasterId, littoral::sea::Offset, littoral::sea::Start };

bool IsMadeHere(const char* name)
{
  return name && std::any_of(std::begin(MadeHere), std::end(MadeHere), [name](const char* own) {
    return std::strcmp(own, name) == 0;
  });
}

/// The order in which the trains of the sea state are taken, as a field array.
vtkSmartPointer<vtkIntArray> OrderArray(const std::vector<int>& order)
{
  auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName(littoral::sea::TrainOrder);
  for (const int train : order)
  {
    array->InsertNextValue(train);
  }
  return array;
}

/// Counters of a selection as field data, where this many particles could have been shown.
vtkSmartPointer<vtkFieldData> CountersOf(
  const littoral::ParticleSelection& selection, double particles, std::size_t trains)
{
  vtkNew<vtkDataObject> counters;
  const auto add = [&counters](const char* name, double value) { littoral::AddField(counters, name, { value }); };
  add("ParticlesInAll", particles);
  add("ParticlesShown", static_cast<double>(selection.Shown));
  add("ParticlesFar", static_cast<double>(selection.Far));
  add("Masters", static_cast<double>(selection.Masters));
  add("Slaves", static_cast<double>(selection.Slaves));
  add("CellsInAll", static_cast<double>(selection.CellsInAll));
  add("CellsShown", static_cast<double>(selection.CellsShown));
  add("Orbits", static_cast<double>(selection.Orbits()));
  add("TrainSums", static_cast<double>(selection.TrainSum));
  add("TrainSumsInAll", particles * static_cast<double>(trains));
  add("MaximumSlaveError", selection.MaximumSlaveError);
  return counters->GetFieldData();
}

/// Particles in some of the cells.
double ParticlesIn(const littoral::ParticleGroups& groups, const littoral::PieceRange& cells)
{
  long long particles = 0;
  for (long long cell = cells.Begin; cell < cells.End; ++cell)
  {
    particles += static_cast<long long>(groups.GetCells()[cell].Size());
  }
  return static_cast<double>(particles);
}

/// Tells where the particles of a block are.
struct PlacesKey
{
  littoral::ArrayStamp Source;
  bool IsSorted = false;
  littoral::Vector3 Way{ 0.0 };
  std::size_t Selection = 0;
};

bool operator==(const PlacesKey& a, const PlacesKey& b)
{
  return a.Source == b.Source && a.IsSorted == b.IsSorted && a.Way == b.Way && a.Selection == b.Selection;
}

/// A block of the output.
struct LevelBlock
{
  vtkSmartPointer<vtkPolyData> Data;       ///< null: to be made
  vtkSmartPointer<vtkIdTypeArray> Masters; ///< of Middle
  bool IsAsBefore = true;                  ///< with trains and weights as when it was made
  PlacesKey Key;
  std::optional<littoral::TupleRanges> Ranges; ///< of its sorted places, as long as they stay
  littoral::LevelBlends Blends;                ///< of the selection in the key
};

}

/// State that does not depend on the view, and what one frame leaves to the next one.
class vtkParticleLevelOfDetailFilter::vtkInternals
{
public:
  littoral::ArrayStamp Grouped; ///< the places of the grouping
  vtkSmartPointer<vtkDataArray> GroupedPlaces;
  std::vector<double> Numbers; ///< properties of the grouping
  std::unique_ptr<littoral::ParticleGroups> Groups;
  littoral::Box Bounds; ///< of all cells

  littoral::ArrayStamp Moved;            ///< the points of now
  std::optional<littoral::Vector3> Told; ///< way of all from these points to their places [m]
  vtkSmartPointer<vtkDataArray> Places;  ///< as long as they are read
  littoral::ArrayStamp SortedSource;
  littoral::ArrayStamp RestingPlaces;
  littoral::ParticleMotion Resting;     ///< of places that all go one way, without it
  bool AreNew = false;                  ///< the places, since the last frame
  std::optional<littoral::Vector3> Way; ///< of all from the places of the grouping [m]
  vtkSmartPointer<vtkDataArray> Sorted; ///< the latter in the order of the groups; null where they are not needed
  littoral::ParticleMotion Motion;      ///< since the grouping
  littoral::Box Ways;                   ///< for which levels are chosen: between multiples of WayStep

  std::vector<double> TableKey;
  std::vector<int> Order; ///< of the trains
  std::unique_ptr<littoral::TrainTable> Table;

  std::vector<littoral::ArrayStamp> CarriedKey;
  vtkSmartPointer<vtkPointData> Carried; ///< arrays of the input in the order of the groups

  littoral::FrameArrays Memory;
  CountingArray Counting;
  std::vector<double> SelectionKey;
  std::unique_ptr<littoral::ParticleSelection> Selection; ///< of the last frame
  std::size_t Selections = 0;                             ///< until now; 0: none
  vtkSmartPointer<vtkFieldData> Counters;                 ///< of the selection; null: to be made
  LevelBlock Blocks[3];                                   ///< that show it

  void ForgetFrames()
  {
    this->Selection = nullptr;
    this->SelectionKey.clear();
    std::fill(std::begin(this->Blocks), std::end(this->Blocks), LevelBlock());
  }

  void Group(const littoral::ArrayStamp& source, vtkDataArray* places, const std::vector<double>& numbers,
    const littoral::GroupOptions& options, vtkAlgorithm* owner);
  void FindMotion(vtkDataArray* from, const littoral::ParallelFor& parallel);
  void Carry(vtkPointSet* input);
  void Sort();
  void MakeTable(const littoral::SeaState& sea, const littoral::View& view, littoral::TrainRule rule, double error);
  void Select(const littoral::View& view, const littoral::ParticleLevelOptions& options,
    const littoral::PieceRange& cells, vtkAlgorithm* owner);
  void AddCounters(vtkDataObject* output, const littoral::PieceRange& cells, std::size_t trains);
  template <typename Array>
  vtkPolyData* Block(const littoral::ShownParticles& shown, littoral::ParticleLevel kind);
};

/// Groups particles anew by where they are.
void vtkParticleLevelOfDetailFilter::vtkInternals::Group(const littoral::ArrayStamp& source, vtkDataArray* places,
  const std::vector<double>& numbers, const littoral::GroupOptions& options, vtkAlgorithm* owner)
{
  // Particles that drift keep most of their order, and the groups are found faster from it.
  std::vector<int> former = this->Groups ? this->Groups->GetTree() : std::vector<int>();
  this->Groups = nullptr;
  this->ForgetFrames();
  this->Carried = nullptr;
  this->Sorted = nullptr;
  this->Groups =
    std::make_unique<littoral::ParticleGroups>(ListOf(places), options, static_cast<std::size_t>(numbers.back()),
      littoral::AbortableFor(owner), littoral::PollOf(owner), std::move(former));
  this->Bounds = this->Groups->GetClusters().front().Bounds;
  for (const littoral::ParticleRegion& cluster : this->Groups->GetClusters())
  {
    this->Bounds.Low = glm::min(this->Bounds.Low, cluster.Bounds.Low);
    this->Bounds.High = glm::max(this->Bounds.High, cluster.Bounds.High);
  }
  this->Grouped = source;
  this->GroupedPlaces = places;
  this->Numbers = numbers;
}

/// Finds the motion of the places from others. Where all have gone one way, the others alone are looked at, and once.
void vtkParticleLevelOfDetailFilter::vtkInternals::FindMotion(vtkDataArray* from, const littoral::ParallelFor& parallel)
{
  this->Way = this->Told ? this->Told : littoral::CommonWayOf(this->Places, from);
  if (!this->Way)
  {
    this->Motion = littoral::MotionOf(ListOf(from), ListOf(this->Places), parallel);
    return;
  }
  if (!(this->RestingPlaces == littoral::StampOf(from)))
  {
    this->Resting = littoral::MotionOf(ListOf(from), ListOf(from), parallel);
    this->RestingPlaces = littoral::StampOf(from);
  }
  double box[6];
  littoral::PointsWithRanges(from)->GetBounds(box);
  this->Motion =
    littoral::Shifted(this->Resting, *this->Way, { { box[0], box[2], box[4] }, { box[1], box[3], box[5] } });
}

/// Puts the arrays of the input in the order of the groups, but for those that are made here.
void vtkParticleLevelOfDetailFilter::vtkInternals::Carry(vtkPointSet* input)
{
  vtkPointData* given = input->GetPointData();
  std::vector<littoral::ArrayStamp> key;
  for (int index = 0; index < given->GetNumberOfArrays(); ++index)
  {
    if (!IsMadeHere(given->GetArrayName(index)))
    {
      key.push_back(littoral::StampOf(given->GetAbstractArray(index)));
    }
  }
  if (this->Carried && key == this->CarriedKey)
  {
    return;
  }
  vtkNew<vtkPointData> carried;
  carried->ShallowCopy(given);
  std::for_each(std::begin(MadeHere), std::end(MadeHere), [&](const char* name) { carried->RemoveArray(name); });
  this->ForgetFrames();
  const std::vector<int>& order = this->Groups->GetOrder();
  this->Carried = vtkSmartPointer<vtkPointData>::New();
  littoral::PickTuples(carried, { order.begin(), order.end() }, this->Carried);
  if (!this->Carried->HasArray(littoral::sea::ParticleId))
  {
    const auto ids =
      littoral::NewArray<vtkIdTypeArray>(littoral::sea::ParticleId, 1, static_cast<vtkIdType>(order.size()));
    std::copy(order.begin(), order.end(), ids->GetPointer(0));
    this->Carried->AddArray(ids);
  }
  this->CarriedKey = key;
}

/// Puts places that stay, or go one way, in the order of the groups; of places that change otherwise from frame to
/// frame only those that are shown are looked at.
void vtkParticleLevelOfDetailFilter::vtkInternals::Sort()
{
  const littoral::ArrayStamp source = this->Way ? this->Grouped : this->Moved;
  if (this->AreNew && !this->Way)
  {
    this->Sorted = nullptr;
  }
  else if (!this->Sorted || !(this->SortedSource == source))
  {
    this->SortedSource = source;
    const littoral::PlaceList places = ListOf(this->Way ? this->GroupedPlaces : this->Places);
    this->Sorted = places.GetSingles() ? littoral::SortedPlaces<vtkFloatArray>(places, *this->Groups)
                                       : littoral::SortedPlaces<vtkDoubleArray>(places, *this->Groups);
  }
  this->AreNew = false;
}

/// The trains in their order, and how many of them matter where, as long as neither sea nor lens nor heights change.
void vtkParticleLevelOfDetailFilter::vtkInternals::MakeTable(
  const littoral::SeaState& sea, const littoral::View& view, littoral::TrainRule rule, double error)
{
  const double lowest = this->Bounds.Low.z + this->Ways.Low.z;
  const double highest = this->Bounds.High.z + this->Ways.High.z;
  std::vector<int> order = littoral::OrderAt(sea, this->Motion.MeanHeight);
  std::vector<double> key{ lowest, highest, view.Angle, view.AspectRatio, view.Height, view.Margin,
    static_cast<double>(rule), error, sea.Depth, sea.SeaLevel };
  for (const littoral::WaveTrain& train : sea.Trains)
  {
    key.insert(key.end(), { train.Amplitude, train.WaveNumber });
  }
  key.insert(key.end(), order.begin(), order.end());
  if (!this->Table || key != this->TableKey)
  {
    this->Table =
      std::make_unique<littoral::TrainTable>(littoral::Ordered(sea, order), lowest, highest, view, rule, error);
    this->TableKey = std::move(key);
    this->Order = std::move(order);
    this->ForgetFrames();
  }
}

/// Whether runs hold the same particles, whatever is told of them.
bool HoldTheSame(const littoral::ShownRuns& some, const littoral::ShownRuns& others)
{
  const auto joined = [](const littoral::ShownRuns& runs) {
    std::vector<std::pair<std::size_t, std::size_t>> ranges;
    for (const littoral::ShownRun& run : runs)
    {
      const bool goesOn = !ranges.empty() && ranges.back().second == run.Begin;
      goesOn ? static_cast<void>(ranges.back().second = run.End) : ranges.push_back({ run.Begin, run.End });
    }
    return ranges;
  };
  return joined(some) == joined(others);
}

/// Whether all parts of two selections have runs in a level of which a condition is true.
template <typename Condition>
bool AreAll(const littoral::ParticleSelection& some, const littoral::ParticleSelection& others,
  littoral::ParticleLevel kind, const Condition& condition)
{
  const auto areGood = [&](const littoral::ParticlePart& a, const littoral::ParticlePart& b) {
    return a.Cluster == b.Cluster &&
      (kind == littoral::ParticleLevel::Near     ? condition(a.Near, b.Near)
          : kind == littoral::ParticleLevel::Far ? condition(a.Far, b.Far)
                                                 : condition(a.Orbits, b.Orbits) && condition(a.Slaves, b.Slaves));
  };
  return std::equal(some.Parts.begin(), some.Parts.end(), others.Parts.begin(), others.Parts.end(), areGood);
}

/// Chooses the particles that a view needs, unless that has been done; levels in which they are others lose their
/// blocks.
void vtkParticleLevelOfDetailFilter::vtkInternals::Select(const littoral::View& view,
  const littoral::ParticleLevelOptions& options, const littoral::PieceRange& cells, vtkAlgorithm* owner)
{
  std::vector<double> key{ view.Angle, static_cast<double>(view.IsParallel), view.ParallelScale, view.AspectRatio,
    view.Height, view.DetailFactor, view.Near, view.Far, view.Margin, view.AngleMargin,
    static_cast<double>(options.UseLevels), static_cast<double>(options.UseCulling), options.MiddleDistance,
    options.FarDistance, options.BlendDistance, options.VisibleDistance, options.Margin, options.FogMargin,
    static_cast<double>(cells.Begin), static_cast<double>(cells.End) };
  for (const littoral::Vector3& each : { view.Point, view.Direction, view.Up, this->Ways.Low, this->Ways.High })
  {
    key.insert(key.end(), &each.x, &each.x + 3);
  }
  if (this->Selection && key == this->SelectionKey)
  {
    return;
  }
  auto selection = std::make_unique<littoral::ParticleSelection>(littoral::SelectParticles(*this->Groups, *this->Table,
    littoral::ViewFrustum(view), options, static_cast<std::size_t>(cells.Begin), static_cast<std::size_t>(cells.End),
    littoral::AbortableFor(owner), this->Ways));
  for (const littoral::ParticleLevel kind : Levels)
  {
    LevelBlock& block = this->Blocks[static_cast<int>(kind)];
    if (!this->Selection || !AreAll(*selection, *this->Selection, kind, HoldTheSame))
    {
      block = {};
    }
    else
    {
      block.IsAsBefore =
        block.IsAsBefore && AreAll(*selection, *this->Selection, kind, std::equal_to<littoral::ShownRuns>());
    }
  }
  this->Selection = std::move(selection);
  this->SelectionKey = std::move(key);
  this->Counters = nullptr;
  ++this->Selections;
}

/// Adds the counters of the selection, which stay as long as it does.
void vtkParticleLevelOfDetailFilter::vtkInternals::AddCounters(
  vtkDataObject* output, const littoral::PieceRange& cells, std::size_t trains)
{
  if (!this->Counters)
  {
    this->Counters = CountersOf(*this->Selection, ParticlesIn(*this->Groups, cells), trains);
  }
  for (int index = 0; index < this->Counters->GetNumberOfArrays(); ++index)
  {
    output->GetFieldData()->AddArray(this->Counters->GetAbstractArray(index));
  }
}

/// The particles of a level, with all that tells how they are drawn and moved. What has not changed since the last
/// frame is that of the last frame.
template <typename Array>
vtkPolyData* vtkParticleLevelOfDetailFilter::vtkInternals::Block(
  const littoral::ShownParticles& shown, littoral::ParticleLevel kind)
{
  LevelBlock& block = this->Blocks[static_cast<int>(kind)];
  const PlacesKey key{ shown.Sorted ? this->SortedSource : this->Moved, shown.Sorted != nullptr, shown.Way,
    this->Selections };
  const bool isEmpty = littoral::SizeOf(shown.Selection, kind) == 0;
  if (block.Data && (block.Key == key || (isEmpty && block.IsAsBefore)))
  {
    return block.Data;
  }
  const bool isNew = !block.Data;
  // A block that nobody else holds any more is filled again.
  const bool isOwn = !isNew && block.Data->GetReferenceCount() == 1;
  const auto data = isOwn ? block.Data : vtkSmartPointer<vtkPolyData>::New();
  vtkPointData* arrays = data->GetPointData();
  if (!(block.Key.Source == key.Source))
  {
    block.Ranges.reset();
  }
  data->SetPoints(littoral::PointsOf<Array>(shown, kind, block.Ranges, this->Memory));
  if (isNew)
  {
    data->SetVerts(this->Counting.Vertices(static_cast<vtkIdType>(littoral::SizeOf(shown.Selection, kind))));
    littoral::CarryArrays(shown, kind, this->Carried, this->Memory, arrays);
    if (kind == littoral::ParticleLevel::Middle)
    {
      block.Masters = littoral::MastersOf(shown, this->Memory);
      arrays->AddArray(block.Masters);
    }
    data->GetFieldData()->AddArray(OrderArray(this->Order));
  }
  else if (!isOwn)
  {
    data->SetVerts(block.Data->GetVerts());
    data->GetFieldData()->ShallowCopy(block.Data->GetFieldData());
    arrays->ShallowCopy(block.Data->GetPointData());
  }
  const bool isOther = isNew || !block.IsAsBefore;
  if (isOther)
  {
    littoral::AddLevelArrays(shown, kind, this->Memory, arrays);
    block.IsAsBefore = true;
  }
  if (block.Key.Selection != this->Selections)
  {
    block.Blends = littoral::BlendsOf(shown, kind);
  }
  if (isOther || !block.Blends.Runs.empty())
  {
    const std::size_t state = std::size(Levels) * this->Selections + static_cast<std::size_t>(kind);
    arrays->AddArray(littoral::AlphasOf<Array>(shown, kind, block.Blends, state, this->Memory));
  }
  const bool haveStayed = !isNew && shown.Sorted && block.Key.IsSorted && block.Key.Source == key.Source;
  if (kind == littoral::ParticleLevel::Middle && !haveStayed)
  {
    arrays->AddArray(littoral::OffsetsOf<Array>(shown, data->GetPoints(), block.Masters, this->Memory));
  }
  block.Data = data;
  block.Key = key;
  return data;
}

//----------------------------------------------------------------------------
vtkParticleLevelOfDetailFilter::vtkParticleLevelOfDetailFilter()
  : UseLevels(true)
  , BlendDistance(0.5)
  , VisibleDistance(60.0)
  , SlavesPerMaster(3)
  , OffsetRange{ 0.0, 0.5 }
  , SlavePlacement(OwnPlace)
  , Seed(1)
  , TrainSelection(TailSum)
  , PixelError(1.0)
  , UseCulling(true)
  , ParticlesPerCell(64)
  , Margin(0.01)
  , FogMargin(1.0)
  , Internals(new vtkInternals)
{
  this->NearDistance = 2.0;
  this->FarDistance = 12.0;
  this->SetNumberOfInputPorts(2);
}

//----------------------------------------------------------------------------
vtkParticleLevelOfDetailFilter::~vtkParticleLevelOfDetailFilter() = default;

//----------------------------------------------------------------------------
int vtkParticleLevelOfDetailFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPointSet" : "vtkTable");
  // Whole, not a block at a time: levels of several blocks do not go into one output, which is then said once.
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  if (port == 1)
  {
    // So that its absence gets a message of ours.
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkParticleLevelOfDetailFilter::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//----------------------------------------------------------------------------
int vtkParticleLevelOfDetailFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (int port = 0; port < 2; ++port)
  {
    littoral::RequestAll(inputVector[port]->GetInformationObject(0));
  }
  return 1;
}

//----------------------------------------------------------------------------
std::string vtkParticleLevelOfDetailFilter::WhyBadProperties() const
{
  littoral::ParameterCheck check;
  check.Choice("TrainSelection", this->TrainSelection, { "per train", "tail sum", "all" });
  check.Choice("SlavePlacement", this->SlavePlacement, { "own place", "scattered" });
  check.Positive("PixelError", this->PixelError, "pixels");
  check.PositiveCount("ParticlesPerCell", this->ParticlesPerCell);
  return check.Reason();
}

//----------------------------------------------------------------------------
void vtkParticleLevelOfDetailFilter::RememberGroups(vtkPointSet* particles)
{
  vtkInternals& internals = *this->Internals;
  const vtkIdType count = particles->GetPoints() ? particles->GetNumberOfPoints() : 0;
  littoral::Require(count == 0 ? "there are no particles in the input." : "");
  vtkDataArray* points = particles->GetPoints()->GetData();
  const littoral::ArrayStamp moved{ points, std::max(points->GetMTime(), particles->GetPoints()->GetMTime()) };
  vtkDataArray* start = littoral::ArrayReader::OfPoints(particles, "Input").Find(littoral::sea::Start, 3);
  const bool knowsStart = start && (vtkFloatArray::SafeDownCast(start) || vtkDoubleArray::SafeDownCast(start));
  const std::vector<double> numbers{ static_cast<double>(this->SlavesPerMaster), this->OffsetRange[0],
    this->OffsetRange[1], static_cast<double>(this->SlavePlacement), static_cast<double>(this->Seed),
    static_cast<double>(knowsStart), static_cast<double>(this->ParticlesPerCell) };
  const littoral::ArrayStamp source = knowsStart ? littoral::StampOf(start) : moved;
  const bool areGrouped = internals.Groups && internals.Numbers == numbers;
  const bool isPlain = vtkFloatArray::SafeDownCast(points) || vtkDoubleArray::SafeDownCast(points);
  const std::optional<littoral::Vector3> told = knowsStart && isPlain ? ToldWay(particles) : std::nullopt;
  if (!told)
  {
    littoral::RequireInPlace(particles);
  }
  internals.Places = isPlain ? points : internals.Places.Get();
  if (told && this->SlavePlacement == Scattered) // about the places of their masters
  {
    internals.Places = vtkFloatArray::SafeDownCast(points) ? Shifted<vtkFloatArray>(points, *told)
                                                           : Shifted<vtkDoubleArray>(points, *told);
  }
  if (areGrouped && internals.Moved == moved && internals.Told == told &&
    (internals.Grouped == source || internals.Grouped == moved))
  {
    return;
  }
  littoral::GroupOptions options;
  options.Slaves = this->SlavesPerMaster;
  options.NearestOffset = this->OffsetRange[0];
  options.MaximumOffset = this->OffsetRange[1];
  options.Scatter = this->SlavePlacement == Scattered;
  options.Seed = this->Seed;
  littoral::Require(littoral::WhyInvalid(options));
  littoral::Require(count > std::numeric_limits<int>::max() ? "More particles than 2147483647 have no levels." : "");
  if (!areGrouped || internals.Grouped.Array == nullptr)
  {
    littoral::RequireMemory(
      BytesAParticle * static_cast<double>(count), "A water of " + std::to_string(count) + " particles", "take fewer");
  }
  internals.Moved = {};
  internals.Told = told;
  internals.Places = isPlain ? internals.Places.Get() : littoral::WithType<vtkDoubleArray>(points).Get();
  const littoral::PlaceList places = ListOf(internals.Places);
  const littoral::ParallelFor parallel = littoral::AbortableFor(this);
  internals.FindMotion(knowsStart ? start : internals.Places.Get(), parallel);
  if (!internals.Motion.IsFinite)
  {
    RefuseInfinite(places);
  }
  // Groups that have been torn apart are no groups.
  const bool areTogether = knowsStart && internals.Motion.Spread() <= LargestSpread * this->OffsetRange[1];
  vtkDataArray* from = areTogether ? start : internals.Places.Get();
  const littoral::ArrayStamp wanted = areTogether ? source : moved;
  if (!areGrouped || !(internals.Grouped == wanted))
  {
    internals.Group(wanted, from, numbers, options, this);
  }
  internals.Ways = areTogether ? RoundedWays(internals.Motion.Shift) : littoral::Box{};
  internals.Way = areTogether ? internals.Way : std::nullopt;
  internals.Moved = moved;
  internals.AreNew = true;
}

//----------------------------------------------------------------------------
littoral::ParticleLevelOptions vtkParticleLevelOfDetailFilter::MakeOptions() const
{
  littoral::ParticleLevelOptions options;
  options.UseLevels = this->UseLevels;
  options.UseCulling = this->UseCulling;
  options.MiddleDistance = this->NearDistance;
  options.FarDistance = this->FarDistance;
  options.BlendDistance = this->BlendDistance;
  options.VisibleDistance = this->VisibleDistance;
  options.Margin = this->Margin;
  options.FogMargin = this->FogMargin;
  return options;
}

//----------------------------------------------------------------------------
littoral::SeaState vtkParticleLevelOfDetailFilter::ReadInputs(vtkInformationVector** inputVector)
{
  auto* input = littoral::InputOf<vtkPointSet>(inputVector[0], "Input");
  littoral::Require(littoral::WhyInvalid(this->MakeOptions()));
  littoral::Require(this->WhyBadProperties());
  const bool hasSea = inputVector[1]->GetNumberOfInformationObjects() > 0;
  littoral::Require(hasSea ? "" : "there is no sea state; connect one to Sea State.");
  littoral::SeaState state = littoral::ReadSeaState(littoral::InputOf<vtkTable>(inputVector[1], "Sea State"));
  this->RememberGroups(input);
  return state;
}

//----------------------------------------------------------------------------
int vtkParticleLevelOfDetailFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const littoral::SeaState state =
    littoral::InContext("Cannot choose levels of detail: ", [&] { return this->ReadInputs(inputVector); });
  const littoral::View view = this->GetView();
  vtkPointSet* input = littoral::PointsIn(vtkDataObject::GetData(inputVector[0]));
  const littoral::ParticleLevelOptions options = this->MakeOptions();
  this->SetProgressText("Choosing levels of detail");
  vtkInternals& internals = *this->Internals;
  internals.MakeTable(
    state, view, static_cast<littoral::TrainRule>(this->TrainSelection), this->PixelError / this->DetailFactor);
  const littoral::PieceRange cells = littoral::RequestedPart(
    outputVector->GetInformationObject(0), static_cast<long long>(internals.Groups->GetCells().size()));
  internals.Carry(input);
  internals.Select(view, options, cells, this);
  this->UpdateProgress(0.5);

  internals.Sort();
  internals.Memory.BeginFrame();
  vtkMultiBlockDataSet* output = vtkMultiBlockDataSet::GetData(outputVector);
  const littoral::PlaceList places = ListOf(internals.Places);
  littoral::ShownParticles shown{ *internals.Selection, *internals.Groups, places, internals.Sorted,
    internals.Way.value_or(littoral::Vector3(0.0)), this->SlavePlacement == Scattered, view, options };
  const char* const names[] = { littoral::sea::Near, littoral::sea::MasterSlave, littoral::sea::Far };
  const double step = FogStep(view, options, this->PixelError);
  for (const littoral::ParticleLevel kind : Levels)
  {
    if (kind == littoral::ParticleLevel::Far && step > 0.0)
    {
      shown.Way = step * glm::round(shown.Way / step);
    }
    littoral::AddBlock(output, names[static_cast<int>(kind)],
      places.GetSingles() ? internals.Block<vtkFloatArray>(shown, kind) : internals.Block<vtkDoubleArray>(shown, kind));
  }
  internals.Memory.EndFrame();
  if (internals.Told)
  {
    output->GetFieldData()->RemoveArray(littoral::sea::Way); // all are in place
  }
  internals.AddCounters(output, cells, state.Trains.size());
  if (internals.Places == input->GetPoints()->GetData())
  {
    internals.Places = nullptr; // free for the next frame of the input
  }
  littoral::KeepRanges(output, littoral::PollOf(this));
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
void vtkParticleLevelOfDetailFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UseLevels: " << this->UseLevels << "\n";
  os << indent << "BlendDistance: " << this->BlendDistance << "\n";
  os << indent << "VisibleDistance: " << this->VisibleDistance << "\n";
  os << indent << "SlavesPerMaster: " << this->SlavesPerMaster << "\n";
  os << indent << "OffsetRange: " << this->OffsetRange[0] << " " << this->OffsetRange[1] << "\n";
  os << indent << "SlavePlacement: " << this->SlavePlacement << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "TrainSelection: " << this->TrainSelection << "\n";
  os << indent << "PixelError: " << this->PixelError << "\n";
  os << indent << "UseCulling: " << this->UseCulling << "\n";
  os << indent << "ParticlesPerCell: " << this->ParticlesPerCell << "\n";
  os << indent << "Margin: " << this->Margin << "\n";
  os << indent << "FogMargin: " << this->FogMargin << "\n";
}
