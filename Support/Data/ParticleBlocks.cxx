// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/ParticleBlocks.h"

#include "Data/SeaStateTable.h"
#include "Geometry/ViewFrustum.h"
#include "Numerics/ShiftedTriples.h"
#include "Particles/LevelWeights.h"
#include "Pipeline/Pipeline.h"
#include "Pipeline/Ranges.h"

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <type_traits>
#include <vector>

namespace littoral
{
namespace
{

/// Parts of a selection that are written at once by a thread: a hundred thousand particles.
constexpr std::size_t PartsAtOnce = 128;

/// Runs of opacities that go by distance, likewise: some ten thousand particles.
constexpr std::size_t RunsAtOnce = 512;

/// The opacity of particles for which it does not go by distance.
float WholeWeight(const ShownRun& run)
{
  return run.Weight == RunWeight::None ? 0.0f : 1.0f;
}

/// Calls a task with each of some runs and the place of its first particle in a block.
template <typename Task>
void ForRuns(const ShownRuns& runs, std::size_t place, const Task& task)
{
  for (const ShownRun& run : runs)
  {
    task(run, place);
    place += run.Size();
  }
}

/// Calls a task with each list of runs of a part in a level, and with the place of its first particle in the block.
template <typename Task>
void VisitLists(const ParticleSelection& selection, const ParticlePart& part, ParticleLevel kind, const Task& task)
{
  const ParticleCounts& before = part.Before;
  if (kind == ParticleLevel::Middle)
  {
    task(part.Orbits, static_cast<std::size_t>(before.Masters));
    task(part.Slaves, static_cast<std::size_t>(selection.Masters + before.Slaves));
    return;
  }
  const bool isNear = kind == ParticleLevel::Near;
  task(isNear ? part.Near : part.Far, static_cast<std::size_t>(isNear ? before.Near : before.Far));
}

/// Calls a task with the runs of a part in a level, in their places in the block.
template <typename Task>
void VisitPart(const ParticleSelection& selection, const ParticlePart& part, ParticleLevel kind, const Task& task)
{
  VisitLists(selection, part, kind, [&](const ShownRuns& runs, std::size_t place) { ForRuns(runs, place, task); });
}

/// The same with runs of one weight that follow each other as one, whatever else is told of them.
template <typename Task>
void VisitWeights(const ParticleSelection& selection, const ParticlePart& part, ParticleLevel kind, const Task& task)
{
  VisitLists(selection, part, kind, [&](const ShownRuns& runs, std::size_t place) {
    for (auto run = runs.begin(); run != runs.end();)
    {
      ShownRun joined = *run;
      while (++run != runs.end() && run->Begin == joined.End && run->Weight == joined.Weight)
      {
        joined.End = run->End;
      }
      task(joined, place);
      place += joined.Size();
    }
  });
}

/// Calls a task with all parts, on all threads where they are worth calling, and with the number of its batch.
template <typename Task>
void ForBatchedParts(const ParticleSelection& selection, const Task& task)
{
  ForRanges(SmpFor, selection.Parts.size(), PartsAtOnce, [&](std::size_t begin, std::size_t end) {
    std::for_each(selection.Parts.data() + begin, selection.Parts.data() + end,
      [&](const ParticlePart& part) { task(part, begin / PartsAtOnce); });
  });
}

/// The same without the number.
template <typename Task>
void ForParts(const ParticleSelection& selection, const Task& task)
{
  ForBatchedParts(selection, [&](const ParticlePart& part, std::size_t) { task(part); });
}

/// Calls a task with the runs of a level.
template <typename Task>
void Visit(const ShownParticles& shown, ParticleLevel kind, const Task& task)
{
  ForParts(shown.Selection, [&](const ParticlePart& part) { VisitPart(shown.Selection, part, kind, task); });
}

/// Copies tuples that lie in the order of the groups to a level.
void CopyTuples(const ShownParticles& shown, ParticleLevel kind, vtkAbstractArray* ordered, vtkAbstractArray* level)
{
  const auto* from = static_cast<const unsigned char*>(ordered->GetVoidPointer(0));
  auto* to = static_cast<unsigned char*>(level->GetVoidPointer(0));
  const std::size_t bytes = static_cast<std::size_t>(ordered->GetNumberOfComponents()) * ordered->GetDataTypeSize();
  Visit(shown, kind, [=](const ShownRun& run, std::size_t place) {
    std::memcpy(to + place * bytes, from + run.Begin * bytes, run.Size() * bytes);
  });
}

/// Copies what are no numbers, or lie otherwise in memory, one after the other.
void CopyOthers(const ShownParticles& shown, ParticleLevel kind, vtkAbstractArray* ordered, vtkAbstractArray* level)
{
  for (const ParticlePart& part : shown.Selection.Parts)
  {
    VisitPart(shown.Selection, part, kind, [=](const ShownRun& run, std::size_t place) {
      for (std::size_t n = 0; n < run.Size(); ++n)
      {
        level->SetTuple(static_cast<vtkIdType>(place + n), static_cast<vtkIdType>(run.Begin + n), ordered);
      }
    });
  }
}

/// Copies places by their numbers.
template <typename Real>
void PickPlaces(const Real* from, const int* numbers, std::size_t count, Real* to)
{
  for (std::size_t n = 0; n < count; ++n)
  {
    const Real* place = from + 3 * static_cast<std::size_t>(numbers[n]);
    to[3 * n] = place[0];
    to[3 * n + 1] = place[1];
    to[3 * n + 2] = place[2];
  }
}

template <typename Real>
const Real* NumbersOf(const PlaceList& places)
{
  if constexpr (std::is_same_v<Real, float>)
  {
    return places.GetSingles();
  }
  else
  {
    return places.GetDoubles();
  }
}

/// Ranges of the sorted places of a level.
template <typename Real>
TupleRanges RangesOfSorted(const ShownParticles& shown, ParticleLevel kind, const Real* sorted)
{
  std::vector<TupleRanges> ranges(shown.Selection.Parts.size() / PartsAtOnce + 1);
  ForBatchedParts(shown.Selection, [&](const ParticlePart& part, std::size_t batch) {
    VisitPart(shown.Selection, part, kind, [&](const ShownRun& run, std::size_t) {
      ranges[batch].AddTuples(sorted + 3 * run.Begin, sorted + 3 * run.End, 3);
    });
  });
  std::for_each(ranges.begin() + 1, ranges.end(), [&](const TupleRanges& part) { ranges[0].Add(part); });
  return ranges[0];
}

/// Puts particles of a level where they have gone from their sorted places, and keeps their ranges.
template <typename Real>
void ShiftSorted(const ShownParticles& shown, ParticleLevel kind, const Real* sorted,
  std::optional<TupleRanges>& ranges, vtkDataArray* points)
{
  Real* values = static_cast<Real*>(points->GetVoidPointer(0));
  Visit(shown, kind, [&](const ShownRun& run, std::size_t place) {
    ShiftTriples(sorted + 3 * run.Begin, run.Size(), shown.Way, values + 3 * place);
  });
  if (!ranges)
  {
    ranges = RangesOfSorted(shown, kind, sorted);
  }
  KeepRangesOfParts(points, { ShiftedRanges(*ranges, shown.Way, std::is_same_v<Real, float>) });
}

/// Puts scattered slaves about their masters.
template <typename Real>
void ScatterSlaves(const ShownParticles& shown, Real* values)
{
  const std::vector<int>& order = shown.Groups.GetOrder();
  for (const ParticlePart& part : shown.Selection.Parts)
  {
    const auto first = static_cast<std::size_t>(shown.Selection.Masters + part.Before.Slaves);
    ForRuns(part.Slaves, first, [&](const ShownRun& run, std::size_t place) {
      for (std::size_t n = run.Begin; n < run.End; ++n, ++place)
      {
        const Vector3 at = shown.Places[order[shown.Groups.MasterAt(n)]] + shown.Groups.OffsetOf(order[n]);
        std::transform(&at.x, &at.x + 3, values + 3 * place, [](double x) { return static_cast<Real>(x); });
      }
    });
  }
}

/// Weights of masters at places from begin up to end in the order of the groups, or of their slaves.
template <typename Real>
void BlendMasters(const ShownParticles& shown, ParticleLevel kind, bool areSlaves, const PlaceRange& masters,
  const Real* sorted, float* weights)
{
  std::vector<Vector3> places;
  for (std::size_t n = masters.Begin; !sorted && n < masters.End; ++n)
  {
    places.push_back(shown.Places[shown.Groups.GetOrder()[n]]);
  }
  const PlaceList list = sorted ? PlaceList(sorted + 3 * masters.Begin, masters.Size()) : PlaceList(places);
  WeighAll(kind, areSlaves, list, sorted ? shown.Way : Vector3(0.0), shown.View, shown.Options, weights);
}

/// Weights of some particles of a cluster, by the distances of their masters, which come in the order of their slaves.
template <typename Real>
void Blend(const ShownParticles& shown, ParticleLevel kind, const ShownRun& run, const ParticleRegion& cluster,
  const Real* sorted, float* alpha)
{
  const std::size_t slaves = std::clamp(cluster.Slaves.Begin, run.Begin, run.End);
  BlendMasters(shown, kind, false, { run.Begin, slaves }, sorted, alpha);
  if (slaves == run.End)
  {
    return;
  }
  const std::size_t first = shown.Groups.MasterAt(slaves);
  std::vector<float> weights(shown.Groups.MasterAt(run.End - 1) + 1 - first);
  BlendMasters(shown, kind, true, { first, first + weights.size() }, sorted, weights.data());
  for (std::size_t n = slaves; n < run.End; ++n)
  {
    alpha[n - run.Begin] = weights[shown.Groups.MasterAt(n) - first];
  }
}

}

//----------------------------------------------------------------------------
std::size_t SizeOf(const ParticleSelection& selection, ParticleLevel kind)
{
  const long long middle = selection.Masters + selection.Slaves;
  return static_cast<std::size_t>(kind == ParticleLevel::Near ? selection.Near
      : kind == ParticleLevel::Far                            ? selection.Far
                                                              : middle);
}

//----------------------------------------------------------------------------
void CarryArrays(
  const ShownParticles& shown, ParticleLevel kind, vtkPointData* ordered, FrameArrays& memory, vtkPointData* to)
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
      CopyTuples(shown, kind, whole, array);
    }
    else
    {
      array = vtkSmartPointer<vtkAbstractArray>::Take(whole->NewInstance());
      array->SetName(whole->GetName());
      array->SetNumberOfComponents(whole->GetNumberOfComponents());
      SetTuples(array, count);
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

//----------------------------------------------------------------------------
template <typename Array>
vtkSmartPointer<vtkDataArray> SortedPlaces(const PlaceList& places, const ParticleGroups& groups)
{
  const auto sorted = NewArray<Array>("", 3, static_cast<vtkIdType>(places.Size()));
  PickPlaces(
    NumbersOf<typename Array::ValueType>(places), groups.GetOrder().data(), places.Size(), sorted->GetPointer(0));
  return sorted;
}

//----------------------------------------------------------------------------
template <typename Array>
vtkSmartPointer<vtkPoints> PointsOf(
  const ShownParticles& shown, ParticleLevel kind, std::optional<TupleRanges>& sorted, FrameArrays& memory)
{
  using Real = typename Array::ValueType;
  const auto points = memory.New<Array>("Points", 3, static_cast<vtkIdType>(SizeOf(shown.Selection, kind)));
  Real* values = points->GetPointer(0);
  if (shown.Sorted)
  {
    ShiftSorted<Real>(shown, kind, Array::SafeDownCast(shown.Sorted)->GetPointer(0), sorted, points);
  }
  else
  {
    const int* order = shown.Groups.GetOrder().data();
    const auto* from = NumbersOf<Real>(shown.Places);
    Visit(shown, kind, [=](const ShownRun& run, std::size_t place) {
      PickPlaces(from, order + run.Begin, run.Size(), values + 3 * place);
    });
  }
  if (shown.AreScattered && kind == ParticleLevel::Middle)
  {
    ScatterSlaves(shown, values);
    points->Modified();
  }
  return PointsWithRanges(points);
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkIdTypeArray> MastersOf(const ShownParticles& shown, FrameArrays& memory)
{
  auto array = memory.New<vtkIdTypeArray>(
    sea::MasterId, 1, static_cast<vtkIdType>(SizeOf(shown.Selection, ParticleLevel::Middle)));
  vtkIdType* masters = array->GetPointer(0);
  std::fill_n(masters, shown.Selection.Masters, -1);
  ForParts(shown.Selection, [&](const ParticlePart& part) {
    const ParticleRegion& cluster = shown.Groups.GetClusters()[part.Cluster];
    std::vector<vtkIdType> places(cluster.Orbits.Size());
    ForRuns(part.Orbits, static_cast<std::size_t>(part.Before.Masters), [&](const ShownRun& run, std::size_t at) {
      std::iota(&places[run.Begin - cluster.Orbits.Begin], &places[run.Begin - cluster.Orbits.Begin] + run.Size(),
        static_cast<vtkIdType>(at));
    });
    vtkIdType* next = masters + shown.Selection.Masters + part.Before.Slaves;
    for (const ShownRun& run : part.Slaves)
    {
      for (std::size_t n = run.Begin; n < run.End; ++n)
      {
        *next++ = places[shown.Groups.MasterAt(n) - cluster.Orbits.Begin];
      }
    }
  });
  return array;
}

//----------------------------------------------------------------------------
LevelBlends BlendsOf(const ShownParticles& shown, ParticleLevel kind)
{
  LevelBlends blends;
  for (const ParticlePart& part : shown.Selection.Parts)
  {
    VisitWeights(shown.Selection, part, kind, [&](const ShownRun& run, std::size_t place) {
      run.Weight == RunWeight::ByDistance ? blends.Runs.push_back({ run, part.Cluster, place })
                                          : blends.Others.Add(WholeWeight(run));
    });
  }
  return blends;
}

//----------------------------------------------------------------------------
template <typename Array>
vtkSmartPointer<vtkFloatArray> AlphasOf(
  const ShownParticles& shown, ParticleLevel kind, const LevelBlends& blends, std::size_t state, FrameArrays& memory)
{
  auto array = memory.New<vtkFloatArray>(sea::Alpha, 1, static_cast<vtkIdType>(SizeOf(shown.Selection, kind)), state);
  float* alpha = array->GetPointer(0);
  if (!memory.IsFormer(array))
  {
    Visit(shown, kind, [=](const ShownRun& run, std::size_t place) {
      std::fill_n(alpha + place, run.Weight == RunWeight::ByDistance ? 0 : run.Size(), WholeWeight(run));
    });
  }
  const auto* sorted = shown.Sorted ? Array::SafeDownCast(shown.Sorted)->GetPointer(0) : nullptr;
  std::vector<TupleRanges> ranges(blends.Runs.size() / RunsAtOnce + 1);
  ranges[0].Components[0].Add(blends.Others);
  ForRanges(SmpFor, blends.Runs.size(), RunsAtOnce, [&](std::size_t begin, std::size_t end) {
    std::for_each(blends.Runs.data() + begin, blends.Runs.data() + end, [&](const BlendedRun& blended) {
      float* own = alpha + blended.Place;
      Blend(shown, kind, blended.Run, shown.Groups.GetClusters()[blended.Cluster], sorted, own);
      ranges[begin / RunsAtOnce].AddNumbers(own, own + blended.Run.Size());
    });
  });
  KeepRangesOfParts(array, ranges);
  return array;
}

//----------------------------------------------------------------------------
void AddLevelArrays(const ShownParticles& shown, ParticleLevel kind, FrameArrays& memory, vtkPointData* arrays)
{
  const auto count = static_cast<vtkIdType>(SizeOf(shown.Selection, kind));
  const auto trains = memory.New<vtkIntArray>(sea::TrainCount, 1, count);
  const auto errors = kind == ParticleLevel::Far ? nullptr : memory.New<vtkFloatArray>(sea::ErrorBound, 1, count);
  int* firstTrains = trains->GetPointer(0);
  float* firstError = errors ? errors->GetPointer(0) : nullptr;
  Visit(shown, kind, [=](const ShownRun& run, std::size_t place) {
    std::fill_n(firstTrains + place, run.Size(), run.Trains);
    std::fill_n(firstError ? firstError + place : nullptr, firstError ? run.Size() : 0, run.Error);
  });
  // All of a run are alike.
  TupleRanges ofTrains;
  TupleRanges ofErrors;
  for (const ParticlePart& part : shown.Selection.Parts)
  {
    VisitPart(shown.Selection, part, kind, [&](const ShownRun& run, std::size_t) {
      ofTrains.Components[0].Add(run.Trains);
      ofErrors.Components[0].Add(run.Error);
    });
  }
  KeepRangesOfParts(trains, { ofTrains });
  arrays->AddArray(trains);
  if (errors)
  {
    KeepRangesOfParts(errors, { ofErrors });
    arrays->AddArray(errors);
  }
}

//----------------------------------------------------------------------------
template <typename Array>
vtkSmartPointer<Array> OffsetsOf(
  const ShownParticles& shown, vtkPoints* places, vtkIdTypeArray* masterIds, FrameArrays& memory)
{
  using Real = typename Array::ValueType;
  const Real* points = Array::SafeDownCast(places->GetData())->GetPointer(0);
  const Real* resting =
    shown.Sorted && !shown.AreScattered ? Array::SafeDownCast(shown.Sorted)->GetPointer(0) : nullptr;
  const auto array = memory.New<Array>(sea::Offset, 3, places->GetNumberOfPoints());
  Real* offsets = array->GetPointer(0);
  const vtkIdType* masters = masterIds->GetPointer(0);
  std::fill_n(offsets, 3 * shown.Selection.Masters, Real(0.0));
  ForParts(shown.Selection, [&](const ParticlePart& part) {
    const auto first = static_cast<std::size_t>(shown.Selection.Masters + part.Before.Slaves);
    ForRuns(part.Slaves, first, [&](const ShownRun& run, std::size_t place) {
      for (std::size_t n = run.Begin; n < run.End; ++n, ++place)
      {
        const Real* slave = resting ? resting + 3 * n : points + 3 * place;
        const Real* master = resting ? resting + 3 * shown.Groups.MasterAt(n) : points + 3 * masters[place];
        for (int axis = 0; axis < 3; ++axis)
        {
          offsets[3 * place + axis] = slave[axis] - master[axis];
        }
      }
    });
  });
  return array;
}

template vtkSmartPointer<vtkDataArray> SortedPlaces<vtkFloatArray>(
  const PlaceList& places, const ParticleGroups& groups);
template vtkSmartPointer<vtkDataArray> SortedPlaces<vtkDoubleArray>(
  const PlaceList& places, const ParticleGroups& groups);
template vtkSmartPointer<vtkPoints> PointsOf<vtkFloatArray>(
  const ShownParticles& shown, ParticleLevel kind, std::optional<TupleRanges>& sorted, FrameArrays& memory);
template vtkSmartPointer<vtkPoints> PointsOf<vtkDoubleArray>(
  const ShownParticles& shown, ParticleLevel kind, std::optional<TupleRanges>& sorted, FrameArrays& memory);
template vtkSmartPointer<vtkFloatArray> AlphasOf<vtkFloatArray>(
  const ShownParticles& shown, ParticleLevel kind, const LevelBlends& blends, std::size_t state, FrameArrays& memory);
template vtkSmartPointer<vtkFloatArray> AlphasOf<vtkDoubleArray>(
  const ShownParticles& shown, ParticleLevel kind, const LevelBlends& blends, std::size_t state, FrameArrays& memory);
template vtkSmartPointer<vtkFloatArray> OffsetsOf<vtkFloatArray>(
  const ShownParticles& shown, vtkPoints* places, vtkIdTypeArray* masterIds, FrameArrays& memory);
template vtkSmartPointer<vtkDoubleArray> OffsetsOf<vtkDoubleArray>(
  const ShownParticles& shown, vtkPoints* places, vtkIdTypeArray* masterIds, FrameArrays& memory);

}
