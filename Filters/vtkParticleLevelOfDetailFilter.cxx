// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkParticleLevelOfDetailFilter.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/Blocks.h"
#include "Data/Inputs.h"
#include "Data/PickedTuples.h"
#include "Data/SeaStateTable.h"
#include "Data/Tables.h"
#include "Geometry/ViewFrustum.h"
#include "Numerics/ParameterCheck.h"
#include "Particles/ParticleGroups.h"
#include "Particles/ParticleLevels.h"
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

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkParticleLevelOfDetailFilter);

/// State that does not depend on the view, and its inputs.
class vtkParticleLevelOfDetailFilter::vtkInternals
{
public:
  std::vector<littoral::Vector3> Places;
  std::unique_ptr<littoral::ParticleGroups> Groups;
  double Lowest = 0.0; ///< lowest height of the center of a particle, as a slave too [m]
  double Highest = 0.0;
  double MeanHeight = 0.0;
  vtkDataArray* Points = nullptr; ///< compared, never used
  vtkMTimeType PointsTime = 0;
  std::vector<double> Numbers;
};

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

template <typename Array>
Array* AddArray(vtkPointData* arrays, const char* name, int components, vtkIdType tuples)
{
  const auto array = littoral::NewArray<Array>(name, components, tuples);
  arrays->AddArray(array);
  return array;
}

/// Calls a function for each place in a level, on all threads where they are worth calling.
template <typename Function>
void ForEach(vtkIdType count, const Function& function)
{
  constexpr std::size_t atOnce = 1 << 14;
  littoral::ForRanges(
    littoral::SmpFor, static_cast<std::size_t>(count), atOnce, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
      {
        function(static_cast<vtkIdType>(n));
      }
    });
}

/// One vertex for each point.
vtkSmartPointer<vtkCellArray> VerticesOf(vtkIdType count)
{
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> connectivity;
  littoral::SetTuples(offsets, count + 1);
  littoral::SetTuples(connectivity, count);
  ForEach(count, [&](vtkIdType n) {
    offsets->SetValue(n, n);
    connectivity->SetValue(n, n);
  });
  offsets->SetValue(count, count);
  auto vertices = vtkSmartPointer<vtkCellArray>::New();
  vertices->SetData(offsets, connectivity);
  return vertices;
}

/// The arrays of the input at the particles of a level, but for those that are made here.
void CarryArrays(vtkPointSet* input, const std::vector<littoral::ShownParticle>& level, vtkPointData* to)
{
  const vtkIdType count = static_cast<vtkIdType>(level.size());
  std::vector<vtkIdType> particles(level.size());
  std::transform(
    level.begin(), level.end(), particles.begin(), [](const littoral::ShownParticle& shown) { return shown.Particle; });
  vtkNew<vtkPointData> carried;
  carried->ShallowCopy(input->GetPointData());
  for (const char* name : { littoral::sea::Alpha, littoral::sea::TrainCount, littoral::sea::ErrorBound,
         littoral::sea::MasterId, littoral::sea::Offset })
  {
    carried->RemoveArray(name);
  }
  littoral::PickTuples(carried, particles, to);
  if (!littoral::ArrayReader::OfPoints(input, "").Has(littoral::sea::ParticleId))
  {
    auto* ids = AddArray<vtkIdTypeArray>(to, littoral::sea::ParticleId, 1, count);
    ForEach(count, [&](vtkIdType n) { ids->SetValue(n, level[n].Particle); });
  }
}

/// The points of a level; those of scattered slaves about their masters.
template <typename Array>
vtkSmartPointer<vtkPoints> PointsOf(const std::vector<littoral::ShownParticle>& level,
  const std::vector<littoral::Vector3>& places, const littoral::ParticleGroups& groups, bool scattered)
{
  using Real = typename Array::ValueType;
  const vtkIdType count = static_cast<vtkIdType>(level.size());
  vtkNew<Array> points;
  points->SetNumberOfComponents(3);
  littoral::SetTuples(points, count);
  Real* values = points->GetPointer(0);
  ForEach(count, [&](vtkIdType n) {
    const littoral::ShownParticle& particle = level[n];
    littoral::Vector3 place = places[particle.Particle];
    if (scattered && particle.Master >= 0)
    {
      place = places[groups.MasterOf(particle.Particle)] + groups.OffsetOf(particle.Particle);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      values[3 * n + axis] = static_cast<Real>(place[axis]);
    }
  });
  auto all = vtkSmartPointer<vtkPoints>::New();
  all->SetData(points);
  return all;
}

/// The arrays that tell how a level is drawn and moved.
void AddLevelArrays(vtkPointData* arrays, const std::vector<littoral::ShownParticle>& level, LevelKind kind,
  const littoral::ParticleGroups& groups)
{
  const vtkIdType count = static_cast<vtkIdType>(level.size());
  auto* alpha = AddArray<vtkFloatArray>(arrays, littoral::sea::Alpha, 1, count);
  auto* trains = AddArray<vtkIntArray>(arrays, littoral::sea::TrainCount, 1, count);
  ForEach(count, [&](vtkIdType n) {
    alpha->SetValue(n, level[n].Weight);
    trains->SetValue(n, level[n].Trains);
  });
  if (kind != LevelKind::Far)
  {
    auto* error = AddArray<vtkFloatArray>(arrays, littoral::sea::ErrorBound, 1, count);
    ForEach(count, [&](vtkIdType n) { error->SetValue(n, level[n].Error); });
  }
  if (kind == LevelKind::Middle)
  {
    auto* masters = AddArray<vtkIdTypeArray>(arrays, littoral::sea::MasterId, 1, count);
    auto* offsets = AddArray<vtkDoubleArray>(arrays, littoral::sea::Offset, 3, count);
    ForEach(count, [&](vtkIdType n) {
      masters->SetValue(n, level[n].Master);
      const bool follows = level[n].Master >= 0;
      const littoral::Vector3 offset = follows ? groups.OffsetOf(level[n].Particle) : littoral::Vector3(0.0);
      std::copy_n(&offset.x, 3, offsets->GetPointer(3 * n));
    });
  }
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

/// The particles of a level, with all that tells how they are drawn and moved.
vtkSmartPointer<vtkPolyData> LevelBlock(vtkPointSet* input, const std::vector<littoral::ShownParticle>& level,
  LevelKind kind, const std::vector<littoral::Vector3>& places, const littoral::ParticleGroups& groups, bool scattered)
{
  auto block = vtkSmartPointer<vtkPolyData>::New();
  const bool isDouble = input->GetPoints()->GetDataType() == VTK_DOUBLE;
  block->SetPoints(isDouble ? PointsOf<vtkDoubleArray>(level, places, groups, scattered)
                            : PointsOf<vtkFloatArray>(level, places, groups, scattered));
  block->SetVerts(VerticesOf(static_cast<vtkIdType>(level.size())));
  CarryArrays(input, level, block->GetPointData());
  AddLevelArrays(block->GetPointData(), level, kind, groups);
  return block;
}

/// Counters as field data, where this many particles could have been shown.
void AddCounters(
  vtkDataObject* output, const littoral::ParticleSelection& selection, double particles, std::size_t trains)
{
  const auto slaves = std::count_if(selection.Middle.begin(), selection.Middle.end(),
    [](const littoral::ShownParticle& particle) { return particle.Master >= 0; });
  const auto add = [output](const char* name, double value) { littoral::AddField(output, name, { value }); };
  add("ParticlesInAll", particles);
  add("ParticlesShown", static_cast<double>(selection.Shown));
  add("ParticlesFar", static_cast<double>(selection.Far.size()));
  add("Masters", static_cast<double>(static_cast<long long>(selection.Middle.size()) - slaves));
  add("Slaves", static_cast<double>(slaves));
  add("CellsInAll", static_cast<double>(selection.CellsInAll));
  add("CellsShown", static_cast<double>(selection.CellsShown));
  add("Orbits", static_cast<double>(selection.Orbits));
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
  const std::vector<double> numbers{ static_cast<double>(this->SlavesPerMaster), this->OffsetRange[0],
    this->OffsetRange[1], static_cast<double>(this->SlavePlacement), static_cast<double>(this->Seed),
    static_cast<double>(this->ParticlesPerCell) };
  const vtkMTimeType time = std::max(points->GetMTime(), particles->GetPoints()->GetMTime());
  if (internals.Groups && internals.Points == points && internals.PointsTime == time && internals.Numbers == numbers)
  {
    return;
  }
  // Particles that drift keep most of their order, and the groups are found faster from it.
  std::vector<int> former = internals.Groups ? internals.Groups->GetOrder() : std::vector<int>();
  internals = vtkInternals();
  littoral::GroupOptions options;
  options.Slaves = this->SlavesPerMaster;
  options.NearestOffset = this->OffsetRange[0];
  options.MaximumOffset = this->OffsetRange[1];
  options.Scatter = this->SlavePlacement == Scattered;
  options.Seed = this->Seed;
  littoral::Require(littoral::WhyInvalid(options));
  littoral::Require(count > std::numeric_limits<int>::max() ? "More particles than 2147483647 have no levels." : "");
  littoral::RequireMemory(
    BytesAParticle * static_cast<double>(count), "A water of " + std::to_string(count) + " particles", "take fewer");
  std::vector<littoral::Vector3> places;
  littoral::SetSize(places, count);
  const littoral::Poll poll = littoral::PollOf(this);
  littoral::SteppedPoll steps(poll);
  auto* single = vtkFloatArray::SafeDownCast(points);
  ForEach(count, [&](vtkIdType n) {
    single ? static_cast<void>(std::copy_n(single->GetPointer(3 * n), 3, &places[n].x))
           : points->GetTuple(n, &places[n].x);
  });
  for (vtkIdType n = 0; n < count; ++n)
  {
    steps.Step();
    if (!littoral::IsFinite(places[n]))
    {
      littoral::Refuse("point ", n, " has a coordinate that is no finite number.");
    }
    internals.MeanHeight += places[n].z / static_cast<double>(count);
  }
  internals.Groups =
    std::make_unique<littoral::ParticleGroups>(places, options, static_cast<std::size_t>(this->ParticlesPerCell),
      littoral::AbortableFor(this), littoral::PollOf(this), std::move(former));
  internals.Lowest = std::numeric_limits<double>::infinity();
  internals.Highest = -internals.Lowest;
  for (const littoral::ParticleGroups::Cell& cell : internals.Groups->GetCells())
  {
    internals.Lowest = std::min(internals.Lowest, cell.Bounds.Low.z);
    internals.Highest = std::max(internals.Highest, cell.Bounds.High.z);
  }
  internals.Places = std::move(places);
  internals.Points = points;
  internals.PointsTime = time;
  internals.Numbers = numbers;
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
  const vtkInternals& internals = *this->Internals;
  const std::vector<int> order = littoral::OrderAt(state, internals.MeanHeight);
  const littoral::TrainTable table(littoral::Ordered(state, order), internals.Lowest, internals.Highest, view,
    static_cast<littoral::TrainRule>(this->TrainSelection), this->PixelError / this->DetailFactor);
  const littoral::PieceRange cells = littoral::RequestedPart(
    outputVector->GetInformationObject(0), static_cast<long long>(internals.Groups->GetCells().size()));
  const littoral::ParticleSelection selection =
    littoral::SelectParticles(internals.Places, *internals.Groups, table, littoral::ViewFrustum(view), options,
      static_cast<std::size_t>(cells.Begin), static_cast<std::size_t>(cells.End), littoral::AbortableFor(this));
  this->UpdateProgress(0.5);

  vtkMultiBlockDataSet* output = vtkMultiBlockDataSet::GetData(outputVector);
  const auto trainOrder = OrderArray(order);
  const auto addLevel = [&](const char* name, LevelKind kind, const std::vector<littoral::ShownParticle>& particles) {
    const auto block =
      LevelBlock(input, particles, kind, internals.Places, *internals.Groups, this->SlavePlacement == Scattered);
    block->GetFieldData()->AddArray(trainOrder);
    littoral::AddBlock(output, name, block);
  };
  addLevel(littoral::sea::Near, LevelKind::Near, selection.Near);
  addLevel(littoral::sea::MasterSlave, LevelKind::Middle, selection.Middle);
  addLevel(littoral::sea::Far, LevelKind::Far, selection.Far);
  AddCounters(output, selection, ParticlesIn(*internals.Groups, cells), state.Trains.size());
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
