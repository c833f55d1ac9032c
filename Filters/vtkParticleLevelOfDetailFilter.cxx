// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkParticleLevelOfDetailFilter.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/Blocks.h"
#include "Data/FrameArrays.h"
#include "Data/Inputs.h"
#include "Data/PickedTuples.h"
#include "Data/SeaStateTable.h"
#include "Data/Tables.h"
#include "Geometry/ViewFrustum.h"
#include "Numerics/ParameterCheck.h"
#include "Particles/ParticleGroups.h"
#include "Particles/ParticleLevels.h"
#include "Particles/ParticleMotion.h"
#include "Pipeline/Pipeline.h"
#include "Pipeline/Ranges.h"
#include "Sea/TrainSelection.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
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
#include <cstring>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkParticleLevelOfDetailFilter);

namespace
{

/// Memory of a particle here and in the output at most, without its own arrays [bytes].
constexpr double BytesAParticle = 400.0;

/// The levels of the output.
enum class LevelKind
{
  Near,
  Middle,
  Far
};

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

/// An array as it was.
struct Stamp
{
  vtkAbstractArray* Array = nullptr; ///< compared, never used
  vtkMTimeType Time = 0;
};

bool operator==(const Stamp& a, const Stamp& b)
{
  return a.Array == b.Array && a.Time == b.Time;
}

Stamp StampOf(vtkAbstractArray* array)
{
  return { array, array->GetMTime() };
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

/// Parts of a selection that are written at once by a thread.
constexpr std::size_t PartsAtOnce = 16;

/// A selection with what tells where its particles are.
struct Shown
{
  const littoral::ParticleSelection& Selection;
  const littoral::ParticleGroups& Groups;
  const littoral::PlaceList& Places;
};

std::size_t SizeOf(const littoral::ParticleSelection& selection, LevelKind kind)
{
  const long long middle = selection.Masters + selection.Slaves;
  return static_cast<std::size_t>(kind == LevelKind::Near ? selection.Near
      : kind == LevelKind::Far                            ? selection.Far
                                                          : middle);
}

/// Calls `whole(begin, end, place, trains)` for the runs of a part in a level, and `one(particle, place, master)` for
/// its other particles, with their places in the block; slaves have the index of their master there, and its particle.
template <typename Whole, typename One>
void VisitPart(
  const Shown& shown, const littoral::ParticlePart& part, LevelKind kind, const Whole& whole, const One& one)
{
  if (kind != LevelKind::Middle)
  {
    const bool isNear = kind == LevelKind::Near;
    const auto first = static_cast<std::size_t>(isNear ? part.Before.Near : part.Before.Far);
    (isNear ? part.Near : part.Far)
      .ForEach([&](std::size_t begin, std::size_t end, std::size_t place,
                 int trains) { whole(begin, end, first + place, trains); },
        [&](const littoral::ShownParticle& particle, std::size_t place) { one(particle, first + place, -1); });
    return;
  }
  auto place = static_cast<std::size_t>(part.Before.Masters);
  for (const littoral::ShownParticle& master : part.Masters)
  {
    one(master, place++, -1);
  }
  place = static_cast<std::size_t>(shown.Selection.Masters + part.Before.Slaves);
  for (littoral::ShownParticle slave : part.Slaves)
  {
    const int master = part.Masters[slave.Master].Particle;
    slave.Master += static_cast<int>(part.Before.Masters);
    one(slave, place++, master);
  }
}

/// The same for all parts, on all threads where they are worth calling.
template <typename Whole, typename One>
void Visit(const Shown& shown, LevelKind kind, const Whole& whole, const One& one)
{
  const std::vector<littoral::ParticlePart>& parts = shown.Selection.Parts;
  littoral::ForRanges(littoral::SmpFor, parts.size(), PartsAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t part = begin; part < end; ++part)
    {
      VisitPart(shown, parts[part], kind, whole, one);
    }
  });
}

/// Copies a tuple of a number of bytes, of the usual ones without a call.
inline void CopyTuple(const unsigned char* from, unsigned char* to, std::size_t bytes)
{
  switch (bytes)
  {
    case 1:
      *to = *from;
      return;
    case 3:
      std::memcpy(to, from, 3);
      return;
    case 4:
      std::memcpy(to, from, 4);
      return;
    case 8:
      std::memcpy(to, from, 8);
      return;
    default:
      std::memcpy(to, from, bytes);
  }
}

/// Copies numbers that lie in the order of the groups to a level.
void CopyNumbers(const Shown& shown, LevelKind kind, vtkAbstractArray* ordered, vtkAbstractArray* level)
{
  const auto* from = static_cast<const unsigned char*>(ordered->GetVoidPointer(0));
  auto* to = static_cast<unsigned char*>(level->GetVoidPointer(0));
  const std::size_t bytes = static_cast<std::size_t>(ordered->GetNumberOfComponents()) * ordered->GetDataTypeSize();
  Visit(
    shown, kind,
    [=](std::size_t begin, std::size_t end, std::size_t place, int) {
      std::memcpy(to + place * bytes, from + begin * bytes, (end - begin) * bytes);
    },
    [=](const littoral::ShownParticle& particle, std::size_t place, int) {
      CopyTuple(from + particle.Place * bytes, to + place * bytes, bytes);
    });
}

/// Copies what are no numbers, or lie otherwise in memory, one after the other.
void CopyOthers(const Shown& shown, LevelKind kind, vtkAbstractArray* ordered, vtkAbstractArray* level)
{
  for (const littoral::ParticlePart& part : shown.Selection.Parts)
  {
    VisitPart(
      shown, part, kind,
      [=](std::size_t begin, std::size_t end, std::size_t place, int) {
        for (std::size_t n = begin; n < end; ++n)
        {
          level->SetTuple(static_cast<vtkIdType>(place + n - begin), static_cast<vtkIdType>(n), ordered);
        }
      },
      [=](const littoral::ShownParticle& particle, std::size_t place, int) {
        level->SetTuple(static_cast<vtkIdType>(place), particle.Place, ordered);
      });
  }
}

/// The arrays of the input, in the order of the groups, at the particles of a level.
void CarryArrays(
  const Shown& shown, LevelKind kind, vtkPointData* ordered, littoral::FrameArrays& memory, vtkPointData* to)
{
  const auto count = static_cast<vtkIdType>(SizeOf(shown.Selection, kind));
  for (int index = 0; index < ordered->GetNumberOfArrays(); ++index)
  {
    vtkAbstractArray* whole = ordered->GetAbstractArray(index);
    auto* numbers = vtkDataArray::SafeDownCast(whole);
    const bool isPlain = numbers && numbers->HasStandardMemoryLayout() && numbers->GetDataType() != VTK_BIT;
    vtkSmartPointer<vtkAbstractArray> array;
    if (isPlain)
    {
      array = memory.Like(numbers, count);
      CopyNumbers(shown, kind, whole, array);
    }
    else
    {
      array = vtkSmartPointer<vtkAbstractArray>::Take(whole->NewInstance());
      array->SetName(whole->GetName());
      array->SetNumberOfComponents(whole->GetNumberOfComponents());
      littoral::SetTuples(array, count);
      CopyOthers(shown, kind, whole, array);
    }
    array->CopyComponentNames(whole);
    const int attribute = ordered->IsArrayAnAttribute(index);
    const int added = to->AddArray(array);
    if (attribute >= 0)
    {
      to->SetActiveAttribute(added, attribute);
    }
  }
}

/// The points of a level; those of scattered slaves about their masters.
template <typename Array>
vtkSmartPointer<vtkPoints> PointsOf(const Shown& shown, LevelKind kind, bool scattered, littoral::FrameArrays& memory)
{
  using Real = typename Array::ValueType;
  const auto points = memory.New<Array>("Points", 3, static_cast<vtkIdType>(SizeOf(shown.Selection, kind)));
  Real* values = points->GetPointer(0);
  const std::vector<int>& order = shown.Groups.GetOrder();
  const auto put = [values](std::size_t place, const littoral::Vector3& center) {
    for (int axis = 0; axis < 3; ++axis)
    {
      values[3 * place + axis] = static_cast<Real>(center[axis]);
    }
  };
  Visit(
    shown, kind,
    [&](std::size_t begin, std::size_t end, std::size_t place, int) {
      for (std::size_t n = begin; n < end; ++n)
      {
        put(place + n - begin, shown.Places[order[n]]);
      }
    },
    [&](const littoral::ShownParticle& particle, std::size_t place, int master) {
      put(place,
        scattered && master >= 0 ? shown.Places[master] + shown.Groups.OffsetOf(particle.Particle)
                                 : shown.Places[particle.Particle]);
    });
  auto all = vtkSmartPointer<vtkPoints>::New();
  all->SetData(points);
  return all;
}

/// The offset that a slave keeps from its master; zero without one.
littoral::Vector3 OffsetOf(const Shown& shown, int particle, int master)
{
  littoral::Vector3 offset(0.0);
  if (master >= 0)
  {
    shown.Groups.Follows(particle, shown.Places[particle], shown.Places[master], offset);
  }
  return offset;
}

/// The arrays that tell how a level is drawn and moved.
void AddLevelArrays(
  const Shown& shown, LevelKind kind, bool needsIds, littoral::FrameArrays& memory, vtkPointData* arrays)
{
  const auto count = static_cast<vtkIdType>(SizeOf(shown.Selection, kind));
  const auto add = [&](auto* type, const char* name, int components) {
    const auto array = memory.New<std::decay_t<decltype(*type)>>(name, components, count);
    arrays->AddArray(array);
    return array->GetPointer(0);
  };
  auto* ids = needsIds ? add(static_cast<vtkIdTypeArray*>(nullptr), littoral::sea::ParticleId, 1) : nullptr;
  auto* alpha = add(static_cast<vtkFloatArray*>(nullptr), littoral::sea::Alpha, 1);
  auto* trains = add(static_cast<vtkIntArray*>(nullptr), littoral::sea::TrainCount, 1);
  const bool isFar = kind == LevelKind::Far;
  auto* error = isFar ? nullptr : add(static_cast<vtkFloatArray*>(nullptr), littoral::sea::ErrorBound, 1);
  const bool isMiddle = kind == LevelKind::Middle;
  auto* masters = isMiddle ? add(static_cast<vtkIdTypeArray*>(nullptr), littoral::sea::MasterId, 1) : nullptr;
  auto* offsets = isMiddle ? add(static_cast<vtkDoubleArray*>(nullptr), littoral::sea::Offset, 3) : nullptr;
  const std::vector<int>& order = shown.Groups.GetOrder();
  Visit(
    shown, kind,
    [=, &order](std::size_t begin, std::size_t end, std::size_t place, int all) {
      const std::size_t size = end - begin;
      std::fill_n(alpha + place, size, 1.0f);
      std::fill_n(trains + place, size, all);
      std::fill_n(error ? error + place : nullptr, error ? size : 0, 0.0f);
      std::copy_n(order.begin() + static_cast<std::ptrdiff_t>(begin), ids ? size : 0, ids ? ids + place : nullptr);
    },
    [=, &shown](const littoral::ShownParticle& particle, std::size_t place, int master) {
      alpha[place] = particle.Weight;
      trains[place] = particle.Trains;
      if (ids)
      {
        ids[place] = particle.Particle;
      }
      if (error)
      {
        error[place] = particle.Error;
      }
      if (masters)
      {
        masters[place] = particle.Master;
        const littoral::Vector3 offset = OffsetOf(shown, particle.Particle, master);
        std::copy_n(&offset.x, 3, offsets + 3 * place);
      }
    });
}

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

/// Counters as field data, where this many particles could have been shown.
void AddCounters(
  vtkDataObject* output, const littoral::ParticleSelection& selection, double particles, std::size_t trains)
{
  const auto add = [output](const char* name, double value) { littoral::AddField(output, name, { value }); };
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
}

/// Particles in some of the cells.
double ParticlesIn(const littoral::ParticleGroups& groups, const littoral::PieceRange& cells)
{
  long long particles = 0;
  for (long long cell = cells.Begin; cell < cells.End; ++cell)
  {
    particles += static_cast<long long>(groups.GetCells()[cell].End - groups.GetCells()[cell].Begin);
  }
  return static_cast<double>(particles);
}

}

/// State that does not depend on the view, and what one frame leaves to the next one.
class vtkParticleLevelOfDetailFilter::vtkInternals
{
public:
  Stamp Grouped;               ///< the places of the grouping
  std::vector<double> Numbers; ///< properties of the grouping
  std::unique_ptr<littoral::ParticleGroups> Groups;
  littoral::Box Bounds; ///< of all cells

  Stamp Moved; ///< the places of now
  vtkSmartPointer<vtkDataArray> Places;
  littoral::ParticleMotion Motion; ///< since the grouping

  std::vector<double> TableKey;
  std::vector<int> Order; ///< of the trains
  std::unique_ptr<littoral::TrainTable> Table;

  std::vector<Stamp> CarriedKey;
  vtkSmartPointer<vtkPointData> Carried; ///< arrays of the input in the order of the groups

  littoral::FrameArrays Memory;
  CountingArray Counting;
  std::unique_ptr<littoral::ParticleSelection> Selection; ///< of the last frame
  vtkSmartPointer<vtkPolyData> Blocks[3];                 ///< that show it

  void ForgetFrames()
  {
    this->Selection = nullptr;
    std::fill(std::begin(this->Blocks), std::end(this->Blocks), nullptr);
  }

  void Group(const Stamp& source, vtkDataArray* places, const std::vector<double>& numbers,
    const littoral::GroupOptions& options, vtkAlgorithm* owner);
  void Carry(vtkPointSet* input);
  void MakeTable(const littoral::SeaState& sea, const littoral::View& view, littoral::TrainRule rule, double error);
  bool IsSame(const littoral::ParticleSelection& selection, LevelKind kind) const;
  vtkSmartPointer<vtkPolyData> Block(const Shown& shown, LevelKind kind, bool scattered);
};

/// Groups particles anew by where they are.
void vtkParticleLevelOfDetailFilter::vtkInternals::Group(const Stamp& source, vtkDataArray* places,
  const std::vector<double>& numbers, const littoral::GroupOptions& options, vtkAlgorithm* owner)
{
  // Particles that drift keep most of their order, and the groups are found faster from it.
  std::vector<int> former = this->Groups ? this->Groups->GetOrder() : std::vector<int>();
  this->Groups = nullptr;
  this->ForgetFrames();
  this->CarriedKey.clear();
  this->Groups =
    std::make_unique<littoral::ParticleGroups>(ListOf(places), options, static_cast<std::size_t>(numbers.back()),
      littoral::AbortableFor(owner), littoral::PollOf(owner), std::move(former));
  this->Bounds = this->Groups->GetCells().front().Bounds;
  for (const littoral::ParticleGroups::Cell& cell : this->Groups->GetCells())
  {
    this->Bounds.Low = glm::min(this->Bounds.Low, cell.Bounds.Low);
    this->Bounds.High = glm::max(this->Bounds.High, cell.Bounds.High);
  }
  this->Grouped = source;
  this->Numbers = numbers;
}

/// Puts the arrays of the input in the order of the groups, but for those that are made here.
void vtkParticleLevelOfDetailFilter::vtkInternals::Carry(vtkPointSet* input)
{
  vtkNew<vtkPointData> carried;
  carried->ShallowCopy(input->GetPointData());
  for (const char* name : { littoral::sea::Alpha, littoral::sea::TrainCount, littoral::sea::ErrorBound,
         littoral::sea::MasterId, littoral::sea::Offset, littoral::sea::Start })
  {
    carried->RemoveArray(name);
  }
  std::vector<Stamp> key;
  for (int index = 0; index < carried->GetNumberOfArrays(); ++index)
  {
    key.push_back(StampOf(carried->GetAbstractArray(index)));
  }
  if (this->Carried && key == this->CarriedKey)
  {
    return;
  }
  this->ForgetFrames();
  const std::vector<int>& order = this->Groups->GetOrder();
  this->Carried = vtkSmartPointer<vtkPointData>::New();
  littoral::PickTuples(carried, { order.begin(), order.end() }, this->Carried);
  this->CarriedKey = key;
}

/// The trains in their order, and how many of them matter where, as long as neither sea nor lens nor heights change.
void vtkParticleLevelOfDetailFilter::vtkInternals::MakeTable(
  const littoral::SeaState& sea, const littoral::View& view, littoral::TrainRule rule, double error)
{
  const double lowest = this->Bounds.Low.z + this->Motion.Shift.Low.z;
  const double highest = this->Bounds.High.z + this->Motion.Shift.High.z;
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
  }
}

/// Whether a level has the same particles as in the last frame, shown alike.
bool vtkParticleLevelOfDetailFilter::vtkInternals::IsSame(
  const littoral::ParticleSelection& selection, LevelKind kind) const
{
  const auto areSame = [kind](const littoral::ParticlePart& a, const littoral::ParticlePart& b) {
    return kind == LevelKind::Near ? a.Near == b.Near : a.Far == b.Far;
  };
  return kind != LevelKind::Middle && this->Selection && this->Blocks[static_cast<int>(kind)] &&
    std::equal(selection.Parts.begin(), selection.Parts.end(), this->Selection->Parts.begin(),
      this->Selection->Parts.end(), areSame);
}

/// The particles of a level, with all that tells how they are drawn and moved.
vtkSmartPointer<vtkPolyData> vtkParticleLevelOfDetailFilter::vtkInternals::Block(
  const Shown& shown, LevelKind kind, bool scattered)
{
  auto block = vtkSmartPointer<vtkPolyData>::New();
  const bool isDouble = this->Places->GetDataType() == VTK_DOUBLE;
  block->SetPoints(isDouble ? PointsOf<vtkDoubleArray>(shown, kind, scattered, this->Memory)
                            : PointsOf<vtkFloatArray>(shown, kind, scattered, this->Memory));
  vtkSmartPointer<vtkPolyData>& former = this->Blocks[static_cast<int>(kind)];
  if (this->IsSame(shown.Selection, kind))
  {
    block->SetVerts(former->GetVerts());
    block->GetPointData()->ShallowCopy(former->GetPointData());
  }
  else
  {
    former = nullptr;
    block->SetVerts(this->Counting.Vertices(static_cast<vtkIdType>(SizeOf(shown.Selection, kind))));
    CarryArrays(shown, kind, this->Carried, this->Memory, block->GetPointData());
    AddLevelArrays(
      shown, kind, !this->Carried->HasArray(littoral::sea::ParticleId), this->Memory, block->GetPointData());
  }
  return block;
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
  const Stamp moved{ points, std::max(points->GetMTime(), particles->GetPoints()->GetMTime()) };
  vtkDataArray* start = littoral::ArrayReader::OfPoints(particles, "Input").Find(littoral::sea::Start, 3);
  const bool knowsStart = start && (vtkFloatArray::SafeDownCast(start) || vtkDoubleArray::SafeDownCast(start));
  const std::vector<double> numbers{ static_cast<double>(this->SlavesPerMaster), this->OffsetRange[0],
    this->OffsetRange[1], static_cast<double>(this->SlavePlacement), static_cast<double>(this->Seed),
    static_cast<double>(knowsStart), static_cast<double>(this->ParticlesPerCell) };
  const Stamp source = knowsStart ? StampOf(start) : moved;
  const bool areGrouped = internals.Groups && internals.Numbers == numbers;
  if (areGrouped && internals.Moved == moved && (internals.Grouped == source || internals.Grouped == moved))
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
  const bool isPlain = vtkFloatArray::SafeDownCast(points) || vtkDoubleArray::SafeDownCast(points);
  internals.Places = isPlain ? points : littoral::WithType<vtkDoubleArray>(points).Get();
  const littoral::PlaceList places = ListOf(internals.Places);
  const littoral::ParallelFor parallel = littoral::AbortableFor(this);
  internals.Motion = littoral::MotionOf(knowsStart ? ListOf(start) : places, places, parallel);
  if (!internals.Motion.IsFinite)
  {
    RefuseInfinite(places);
  }
  // Groups that have been torn apart are no groups.
  const bool areTogether = knowsStart && internals.Motion.Spread() <= LargestSpread * this->OffsetRange[1];
  vtkDataArray* from = areTogether ? start : internals.Places.Get();
  const Stamp wanted = areTogether ? source : moved;
  if (!areGrouped || !(internals.Grouped == wanted))
  {
    internals.Group(wanted, from, numbers, options, this);
  }
  internals.Motion.Shift = areTogether ? internals.Motion.Shift : littoral::Box{};
  internals.Moved = moved;
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
  const littoral::PlaceList places = ListOf(internals.Places);
  auto selection = std::make_unique<littoral::ParticleSelection>(littoral::SelectParticles(places, *internals.Groups,
    *internals.Table, littoral::ViewFrustum(view), options, static_cast<std::size_t>(cells.Begin),
    static_cast<std::size_t>(cells.End), littoral::AbortableFor(this), internals.Motion.Shift));
  this->UpdateProgress(0.5);

  internals.Carry(input);
  internals.Memory.BeginFrame();
  vtkMultiBlockDataSet* output = vtkMultiBlockDataSet::GetData(outputVector);
  const auto trainOrder = OrderArray(internals.Order);
  const Shown shown{ *selection, *internals.Groups, places };
  const auto addLevel = [&](const char* name, LevelKind kind) {
    const auto block = internals.Block(shown, kind, this->SlavePlacement == Scattered);
    block->GetFieldData()->AddArray(trainOrder);
    littoral::AddBlock(output, name, block);
    internals.Blocks[static_cast<int>(kind)] = vtkSmartPointer<vtkPolyData>::New();
    internals.Blocks[static_cast<int>(kind)]->SetVerts(block->GetVerts());
    internals.Blocks[static_cast<int>(kind)]->GetPointData()->ShallowCopy(block->GetPointData());
  };
  addLevel(littoral::sea::Near, LevelKind::Near);
  addLevel(littoral::sea::MasterSlave, LevelKind::Middle);
  addLevel(littoral::sea::Far, LevelKind::Far);
  internals.Memory.EndFrame();
  AddCounters(output, *selection, ParticlesIn(*internals.Groups, cells), state.Trains.size());
  internals.Selection = std::move(selection);
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
