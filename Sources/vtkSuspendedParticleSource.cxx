// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSuspendedParticleSource.h"

#include "Data/Arrays.h"
#include "Data/PlantBlocks.h"
#include "Data/SeaStateTable.h"
#include "Geometry/TextureAtlas.h"
#include "Numerics/ParameterTraits.h"
#include "Particles/SuspendedParticles.h"
#include "Pipeline/Pipeline.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSuspendedParticleSource);

namespace
{

/// More particles than this in a box are hardly meant.
constexpr double MostParticles = 1e11;
/// Particles that one thread places at a time.
constexpr long long ParticlesAtOnce = 1 << 13;
/// Points of a particle that is a square: itself and the corners.
constexpr int QuadPoints = 5;
constexpr int Corners[QuadPoints - 1][2] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };

/// The pictures of all kinds in one, which are always the same.
const littoral::TextureAtlas& Pictures()
{
  static const littoral::TextureAtlas atlas = [] {
    std::vector<littoral::TextureImage> pictures;
    pictures.reserve(littoral::ParticleKinds);
    for (int kind = 0; kind < littoral::ParticleKinds; ++kind)
    {
      pictures.push_back(littoral::ParticlePicture(static_cast<littoral::ParticleKind>(kind)));
    }
    return littoral::StackTextures(pictures);
  }();
  return atlas;
}

std::array<long long, 2> PicturesSize()
{
  constexpr int Side = littoral::ParticlePictureSize;
  return littoral::AtlasSize(std::vector<std::array<int, 2>>(littoral::ParticleKinds, { Side, Side }));
}

/// Cells of `size` points each, from the first of each `stride` points after `skip`.
vtkSmartPointer<vtkCellArray> EvenCells(vtkIdType cells, int size, int stride, int skip)
{
  vtkNew<vtkIdTypeArray> offsets;
  littoral::SetTuples(offsets, cells + 1);
  vtkNew<vtkIdTypeArray> corners;
  littoral::SetTuples(corners, cells * size);
  for (vtkIdType cell = 0; cell <= cells; ++cell)
  {
    offsets->SetValue(cell, cell * size);
    for (int corner = 0; cell < cells && corner < size; ++corner)
    {
      corners->SetValue(cell * size + corner, cell * stride + skip + corner);
    }
  }
  auto array = vtkSmartPointer<vtkCellArray>::New();
  array->SetData(offsets, corners);
  return array;
}

/// The arrays of particles that are points, or squares of several points each.
template <typename Array>
class ParticleArrays
{
public:
  ParticleArrays(vtkIdType particles, bool quads, int seed)
    : Quads(quads)
    , Stride(quads ? QuadPoints : 1)
    , Seed(seed)
    , Particles(particles)
    , Position(littoral::NewArray<Array>("Points", 3, particles * this->Stride))
    , Id(littoral::NewArray<vtkIdTypeArray>(littoral::sea::ParticleId, 1, particles * this->Stride))
    , BoxId(littoral::NewArray<vtkIntArray>(littoral::sea::BoxId, 1, particles * this->Stride))
    , Type(littoral::NewArray<vtkIntArray>(littoral::sea::ParticleType, 1, particles * this->Stride))
    , Radius(littoral::NewArray<vtkFloatArray>(littoral::sea::Radius, 1, particles * this->Stride))
    , Color(littoral::NewArray<vtkUnsignedCharArray>(littoral::sea::RGB, 3, particles * this->Stride))
    , Master(littoral::NewArray<vtkIdTypeArray>(littoral::sea::MasterId, 1, quads ? particles * QuadPoints : 0))
    , Offset(littoral::NewArray<vtkFloatArray>(littoral::sea::Offset, 3, quads ? particles * QuadPoints : 0))
    , Coordinates(littoral::NewArray<vtkFloatArray>("TCoords", 2, quads ? particles * QuadPoints : 0))
    , Areas(quads ? Pictures().Areas : std::vector<littoral::AtlasArea>{})
  {
  }

  /// Writes a particle: `at` is its place among those of this piece, `id` its number among all, `index` in its box.
  void Write(vtkIdType at, long long id, int boxId, const littoral::ParticleBox& box, long long index,
    const littoral::SuspendedParticle& particle)
  {
    const vtkIdType first = at * this->Stride;
    for (vtkIdType point = first; point < first + this->Stride; ++point)
    {
      this->Id->SetValue(point, id);
      this->BoxId->SetValue(point, boxId);
      this->Type->SetValue(point, static_cast<int>(box.Kind));
      this->Radius->SetValue(point, static_cast<float>(particle.Radius));
      this->Color->SetTypedTuple(point, particle.Color.data());
    }
    if (!this->Quads)
    {
      this->SetPosition(first, particle.Place);
      return;
    }
    const littoral::PictureAxes axes = littoral::OrientationOf(boxId, index, this->Seed);
    const littoral::AtlasArea& area = this->Areas[static_cast<std::size_t>(box.Kind)];
    this->WriteCorner(first, 0, 0.0, 0.0, particle, axes, area);
    for (int corner = 1; corner < QuadPoints; ++corner)
    {
      this->WriteCorner(first, corner, Corners[corner - 1][0], Corners[corner - 1][1], particle, axes, area);
    }
  }

  void AddTo(vtkPolyData* output) const
  {
    vtkNew<vtkPoints> positions;
    positions->SetData(this->Position);
    output->SetPoints(positions);
    vtkPointData* arrays = output->GetPointData();
    arrays->AddArray(this->Id);
    arrays->AddArray(this->BoxId);
    arrays->AddArray(this->Type);
    arrays->AddArray(this->Radius);
    arrays->SetScalars(this->Color);
    if (this->Quads)
    {
      arrays->AddArray(this->Master);
      arrays->AddArray(this->Offset);
      arrays->SetTCoords(this->Coordinates);
      output->SetPolys(EvenCells(this->Particles, QuadPoints - 1, QuadPoints, 1));
    }
    else
    {
      output->SetVerts(EvenCells(this->Particles, 1, 1, 0));
    }
  }

private:
  using Real = typename Array::ValueType;

  void SetPosition(vtkIdType point, const littoral::Vector3& at)
  {
    const Real tuple[3] = { static_cast<Real>(at.x), static_cast<Real>(at.y), static_cast<Real>(at.z) };
    this->Position->SetTypedTuple(point, tuple);
  }

  /// The middle of a square (corner 0) or a corner, which is its slave.
  void WriteCorner(vtkIdType middle, int corner, double across, double along,
    const littoral::SuspendedParticle& particle, const littoral::PictureAxes& axes, const littoral::AtlasArea& area)
  {
    const vtkIdType point = middle + corner;
    const littoral::Vector3 shift = particle.Radius * (across * axes.Right + along * axes.Up);
    this->SetPosition(point, particle.Place + shift);
    this->Master->SetValue(point, corner == 0 ? -1 : middle);
    this->Offset->SetTuple3(point, shift.x, shift.y, shift.z);
    const std::array<double, 2> uv = area.Map(0.5 + 0.5 * across, 0.5 + 0.5 * along);
    this->Coordinates->SetTuple2(point, uv[0], uv[1]);
  }

  bool Quads;
  int Stride; ///< points a particle
  int Seed;
  vtkIdType Particles;
  vtkSmartPointer<Array> Position;
  vtkSmartPointer<vtkIdTypeArray> Id;
  vtkSmartPointer<vtkIntArray> BoxId;
  vtkSmartPointer<vtkIntArray> Type;
  vtkSmartPointer<vtkFloatArray> Radius;
  vtkSmartPointer<vtkUnsignedCharArray> Color;
  vtkSmartPointer<vtkIdTypeArray> Master;
  vtkSmartPointer<vtkFloatArray> Offset;
  vtkSmartPointer<vtkFloatArray> Coordinates;
  std::vector<littoral::AtlasArea> Areas; ///< of the pictures, by kind
};

}

/// Boxes of the user.
class vtkSuspendedParticleSource::vtkInternals
{
public:
  std::vector<littoral::ParticleBox> Boxes;
  std::vector<std::string> Names;
};

/// Boxes and the first particle of each, and of what would come after the last.
class vtkSuspendedParticleSource::Recipe
{
public:
  std::vector<littoral::ParticleBox> Boxes;
  std::vector<long long> First{ 0 };
};

//----------------------------------------------------------------------------
vtkSuspendedParticleSource::vtkSuspendedParticleSource()
  : Preset(CoastalSea)
  , Bounds{ -10.0, 10.0, -10.0, 10.0, -10.0, 0.0 }
  , Density(1.0)
  , AmountIs(Concentration)
  , SizeSpread(0.3)
  , Mode(Points)
  , OutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION)
  , Seed(1)
  , Internals(new vtkInternals)
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

//----------------------------------------------------------------------------
vtkSuspendedParticleSource::~vtkSuspendedParticleSource() = default;

//----------------------------------------------------------------------------
void vtkSuspendedParticleSource::AddBox(const double box[12])
{
  littoral::ParticleBox added;
  added.Lower = { box[0], box[2], box[4] };
  added.Upper = { box[1], box[3], box[5] };
  const bool isKind = box[6] >= 0.0 && box[6] < littoral::ParticleKinds && box[6] == std::floor(box[6]);
  added.Kind = static_cast<littoral::ParticleKind>(isKind ? static_cast<int>(box[6]) : -1);
  added.Diameter = box[7];
  added.Amount = box[8];
  std::copy(box + 9, box + 12, added.Color);
  this->Internals->Boxes.push_back(added);
  this->Modified();
}

//----------------------------------------------------------------------------
void vtkSuspendedParticleSource::SetBoxName(int index, const char* name)
{
  if (index < 0 || index > 1000000)
  {
    vtkErrorMacro("There is no box " << index << ".");
    return;
  }
  std::vector<std::string>& names = this->Internals->Names;
  names.resize(std::max<std::size_t>(names.size(), static_cast<std::size_t>(index) + 1));
  names[index] = name ? name : "";
  this->Modified();
}

//----------------------------------------------------------------------------
void vtkSuspendedParticleSource::RemoveAllBoxes()
{
  this->Internals->Boxes.clear();
  this->Modified();
}

//----------------------------------------------------------------------------
void vtkSuspendedParticleSource::ClearBoxNames()
{
  this->Internals->Names.clear();
  this->Modified();
}

//----------------------------------------------------------------------------
int vtkSuspendedParticleSource::GetNumberOfBoxes()
{
  return static_cast<int>(this->Internals->Boxes.size());
}

//----------------------------------------------------------------------------
int vtkSuspendedParticleSource::FillOutputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillOutputPortInformation(port, info);
  }
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

//----------------------------------------------------------------------------
int vtkSuspendedParticleSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  const std::array<long long, 2> size = PicturesSize();
  const int whole[6] = { 0, static_cast<int>(size[0]) - 1, 0, static_cast<int>(size[1]) - 1, 0, 0 };
  outputVector->GetInformationObject(1)->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole, 6);
  return 1;
}

//----------------------------------------------------------------------------
std::string vtkSuspendedParticleSource::WhyBadProperties() const
{
  littoral::ParameterCheck check;
  check.Choice("Preset", this->Preset, littoral::NumberOfParticleScenes + 1);
  check.Choice("Mode", this->Mode, { "points", "quads" });
  check.Choice("AmountIs", this->AmountIs, { "concentration", "count" });
  check.Choice("OutputPointsPrecision", this->OutputPointsPrecision, { "single", "double" });
  check.Range("SizeSpread", this->SizeSpread, 0.0, 2.0);
  check.NotNegative("Density", this->Density);
  return check.Reason();
}

//----------------------------------------------------------------------------
vtkSuspendedParticleSource::Recipe vtkSuspendedParticleSource::MakeRecipe() const
{
  littoral::Require(this->WhyBadProperties());
  Recipe recipe;
  if (this->Preset == Custom)
  {
    recipe.Boxes = this->Internals->Boxes;
    littoral::Require(recipe.Boxes.empty() ? "there are no boxes; add one, or take another Preset." : "");
  }
  else
  {
    const double* b = this->Bounds;
    if (!(b[0] < b[1] && b[2] < b[3] && b[4] < b[5]) ||
      !std::all_of(b, b + 6, [](double x) { return littoral::IsSensible(x); }))
    {
      littoral::Refuse("Bounds must be finite and increasing along each axis.");
    }
    recipe.Boxes =
      littoral::BoxesOf(static_cast<littoral::ParticleScene>(this->Preset), { b[0], b[2], b[4] }, { b[1], b[3], b[5] });
  }
  for (littoral::ParticleBox& box : recipe.Boxes)
  {
    const int index = static_cast<int>(recipe.First.size()) - 1;
    littoral::Require(littoral::WhyInvalid(box, index));
    box.Amount *= this->Density;
    const double count = littoral::NumberIn(box, this->Preset == Custom && this->AmountIs == Count);
    if (!(count < MostParticles))
    {
      littoral::Refuse("box ", index, " would hold more than 1e11 particles.");
    }
    recipe.First.push_back(recipe.First.back() + static_cast<long long>(count));
  }
  return recipe;
}

//----------------------------------------------------------------------------
void vtkSuspendedParticleSource::NameBoxes(const Recipe& recipe, vtkPolyData* output) const
{
  vtkNew<vtkStringArray> kinds;
  kinds->SetName(littoral::sea::ParticleTypes);
  for (int kind = 0; kind < littoral::ParticleKinds; ++kind)
  {
    kinds->InsertNextValue(littoral::ParticleKindName(static_cast<littoral::ParticleKind>(kind)));
  }
  vtkNew<vtkStringArray> names;
  names->SetName(littoral::sea::BoxNames);
  for (std::size_t index = 0; index < recipe.Boxes.size(); ++index)
  {
    std::string name = recipe.Boxes[index].Name;
    if (this->Preset == Custom && index < this->Internals->Names.size())
    {
      name = this->Internals->Names[index];
    }
    names->InsertNextValue(
      name.empty() ? littoral::ParticleKindName(recipe.Boxes[index].Kind) + std::to_string(index) : name);
  }
  output->GetFieldData()->AddArray(kinds);
  output->GetFieldData()->AddArray(names);
}

//----------------------------------------------------------------------------
int vtkSuspendedParticleSource::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  const Recipe recipe = this->MakeRecipe();
  const auto [first, last] = littoral::RequestedPart(outputVector->GetInformationObject(0), recipe.First.back());
  const double bytes = this->Mode == Quads ? QuadPoints * 88.0 + 40.0 : 64.0;
  const auto count = last - first;
  littoral::RequirePoints(
    static_cast<double>(count) * (this->Mode == Quads ? QuadPoints : 1.0), "Density", this->Density);
  littoral::RequireMemory(bytes * static_cast<double>(count), "The water with " + std::to_string(count) + " particles",
    "take a smaller Density or fewer boxes");
  this->SetProgressText("Placing particles");
  this->NameBoxes(recipe, output);
  const bool done = this->OutputPointsPrecision == vtkAlgorithm::DOUBLE_PRECISION
    ? this->Scatter<vtkDoubleArray>(recipe, first, last, output)
    : this->Scatter<vtkFloatArray>(recipe, first, last, output);
  if (!done) // aborted
  {
    output->Initialize();
    return 1;
  }
  littoral::CopyToImage(Pictures().Image, vtkImageData::GetData(outputVector, 1));
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
template <typename Array>
bool vtkSuspendedParticleSource::Scatter(const Recipe& recipe, long long first, long long last, vtkPolyData* output)
{
  const long long count = last - first;
  ParticleArrays<Array> arrays(static_cast<vtkIdType>(count), this->Mode == Quads, this->Seed);
  const std::size_t batches = static_cast<std::size_t>((count + ParticlesAtOnce - 1) / ParticlesAtOnce);
  const bool done = littoral::RunWithProgress(this, batches, 0.0, 1.0, [&](std::size_t batch) {
    const long long begin = first + static_cast<long long>(batch) * ParticlesAtOnce;
    const long long end = std::min(begin + ParticlesAtOnce, last);
    int box =
      static_cast<int>(std::upper_bound(recipe.First.begin(), recipe.First.end(), begin) - recipe.First.begin()) - 1;
    for (long long id = begin; id < end; ++id)
    {
      while (id >= recipe.First[box + 1])
      {
        ++box;
      }
      const long long index = id - recipe.First[box];
      const littoral::SuspendedParticle particle =
        littoral::ParticleOf(recipe.Boxes[box], box, index, this->SizeSpread, this->Seed);
      arrays.Write(static_cast<vtkIdType>(id - first), id, box, recipe.Boxes[box], index, particle);
    }
  });
  if (done)
  {
    arrays.AddTo(output);
  }
  return done;
}

//----------------------------------------------------------------------------
const char* vtkSuspendedParticleSource::GetPresetAsString() const
{
  return this->Preset == Custom ? "Custom"
                                : littoral::NameOfRow<littoral::ParticleScene>(
                                    this->Preset, littoral::NumberOfParticleScenes + 1, littoral::ParticleSceneName);
}

//----------------------------------------------------------------------------
int vtkSuspendedParticleSource::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(this, request, outputs,
    "Cannot make particles: ", [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkSuspendedParticleSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Preset: " << this->Preset << "\n";
  os << indent << "Bounds: " << this->Bounds[0] << " " << this->Bounds[1] << " " << this->Bounds[2] << " "
     << this->Bounds[3] << " " << this->Bounds[4] << " " << this->Bounds[5] << "\n";
  os << indent << "Density: " << this->Density << "\n";
  os << indent << "Boxes: " << this->Internals->Boxes.size() << "\n";
  os << indent << "AmountIs: " << this->AmountIs << "\n";
  os << indent << "SizeSpread: " << this->SizeSpread << "\n";
  os << indent << "Mode: " << this->Mode << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
