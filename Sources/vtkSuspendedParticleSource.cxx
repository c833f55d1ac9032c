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

/// The pictures of all kinds in one.
littoral::TextureAtlas Pictures()
{
  std::vector<littoral::TextureImage> pictures;
  for (int kind = 0; kind < littoral::ParticleKinds; ++kind)
  {
    pictures.push_back(littoral::ParticlePicture(static_cast<littoral::ParticleKind>(kind)));
  }
  return littoral::StackTextures(pictures);
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
  offsets->SetNumberOfValues(cells + 1);
  vtkNew<vtkIdTypeArray> corners;
  corners->SetNumberOfValues(cells * size);
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

}

/// What the user's boxes are.
class vtkSuspendedParticleSource::BoxList
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
  , Boxes(new BoxList)
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
  this->Boxes->Boxes.push_back(added);
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
  std::vector<std::string>& names = this->Boxes->Names;
  names.resize(std::max<std::size_t>(names.size(), static_cast<std::size_t>(index) + 1));
  names[index] = name ? name : "";
  this->Modified();
}

//----------------------------------------------------------------------------
void vtkSuspendedParticleSource::RemoveAllBoxes()
{
  this->Boxes->Boxes.clear();
  this->Modified();
}

//----------------------------------------------------------------------------
void vtkSuspendedParticleSource::ClearBoxNames()
{
  this->Boxes->Names.clear();
  this->Modified();
}

//----------------------------------------------------------------------------
int vtkSuspendedParticleSource::GetNumberOfBoxes()
{
  return static_cast<int>(this->Boxes->Boxes.size());
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
std::string vtkSuspendedParticleSource::MakeRecipe(Recipe& recipe) const
{
  if (std::string none = littoral::WhyNoRow("Preset", this->Preset, littoral::NumberOfParticleScenes + 1);
      !none.empty())
  {
    return none;
  }
  if (this->Mode != Points && this->Mode != Quads)
  {
    return "Mode is " + std::to_string(this->Mode) + "; it must be 0 or 1.";
  }
  if (this->AmountIs != Concentration && this->AmountIs != Count)
  {
    return "AmountIs is " + std::to_string(this->AmountIs) + "; it must be 0 or 1.";
  }
  if (this->OutputPointsPrecision != vtkAlgorithm::SINGLE_PRECISION &&
    this->OutputPointsPrecision != vtkAlgorithm::DOUBLE_PRECISION)
  {
    return "OutputPointsPrecision must be single or double.";
  }
  if (!(this->SizeSpread >= 0.0 && this->SizeSpread <= 2.0))
  {
    return "SizeSpread is " + std::to_string(this->SizeSpread) + "; it must be 0 to 2.";
  }
  if (!(this->Density >= 0.0 && std::isfinite(this->Density)))
  {
    return "Density is " + std::to_string(this->Density) + "; it must not be negative.";
  }
  if (this->Preset == Custom)
  {
    recipe.Boxes = this->Boxes->Boxes;
    if (recipe.Boxes.empty())
    {
      return "there are no boxes; add one, or take another Preset.";
    }
  }
  else
  {
    const double* b = this->Bounds;
    if (!(b[0] < b[1] && b[2] < b[3] && b[4] < b[5]) ||
      !std::all_of(b, b + 6, [](double x) { return std::isfinite(x); }))
    {
      return "Bounds must be finite and increasing along each axis.";
    }
    recipe.Boxes =
      littoral::BoxesOf(static_cast<littoral::ParticleScene>(this->Preset), { b[0], b[2], b[4] }, { b[1], b[3], b[5] });
  }
  for (littoral::ParticleBox& box : recipe.Boxes)
  {
    const int index = static_cast<int>(recipe.First.size()) - 1;
    const std::string reason = littoral::WhyInvalid(box, index);
    if (!reason.empty())
    {
      return reason;
    }
    box.Amount *= this->Density;
    const double count = littoral::NumberIn(box, this->Preset == Custom && this->AmountIs == Count);
    if (!(count < MostParticles))
    {
      return "box " + std::to_string(index) + " would hold more than 1e11 particles.";
    }
    recipe.First.push_back(recipe.First.back() + static_cast<long long>(count));
  }
  return "";
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
    if (this->Preset == Custom && index < this->Boxes->Names.size())
    {
      name = this->Boxes->Names[index];
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
  Recipe recipe;
  std::string reason = this->MakeRecipe(recipe);
  vtkInformation* info = outputVector->GetInformationObject(0);
  const int piece = std::max(0, info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()));
  const int pieces = std::max(1, info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()));
  const auto bound = [&](int part) {
    return static_cast<long long>(static_cast<double>(recipe.First.back()) * part / pieces);
  };
  const long long first = bound(std::min(piece, pieces));
  const long long last = bound(std::min(piece + 1, pieces));
  const double bytes = this->Mode == Quads ? 5.0 * 88.0 + 40.0 : 64.0;
  if (reason.empty() && bytes * static_cast<double>(last - first) > littoral::AvailableMemory())
  {
    reason = std::to_string(last - first) + " particles are more than this machine has memory for.";
  }
  if (!reason.empty())
  {
    vtkErrorMacro("Cannot make particles: " << reason);
    return 0;
  }
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
  using Real = typename Array::ValueType;
  const bool quads = this->Mode == Quads;
  const int stride = quads ? QuadPoints : 1;
  const vtkIdType count = last - first;
  const vtkIdType points = count * stride;
  auto place = littoral::NewArray<Array>("Points", 3, points);
  auto id = littoral::NewArray<vtkIdTypeArray>(littoral::sea::ParticleId, 1, points);
  auto boxId = littoral::NewArray<vtkIntArray>(littoral::sea::BoxId, 1, points);
  auto type = littoral::NewArray<vtkIntArray>(littoral::sea::ParticleType, 1, points);
  auto radius = littoral::NewArray<vtkFloatArray>(littoral::sea::Radius, 1, points);
  auto color = littoral::NewArray<vtkUnsignedCharArray>(littoral::sea::RGB, 3, points);
  const vtkIdType corners = quads ? points : 0;
  auto master = littoral::NewArray<vtkIdTypeArray>(littoral::sea::MasterId, 1, corners);
  auto offset = littoral::NewArray<vtkFloatArray>(littoral::sea::Offset, 3, corners);
  auto coordinates = littoral::NewArray<vtkFloatArray>("TCoords", 2, corners);
  const std::vector<littoral::AtlasArea> areas = quads ? Pictures().Areas : std::vector<littoral::AtlasArea>{};

  const auto write = [&](vtkIdType point, long long number, int box, const littoral::SuspendedParticle& particle) {
    id->SetValue(point, number);
    boxId->SetValue(point, box);
    type->SetValue(point, static_cast<int>(recipe.Boxes[box].Kind));
    radius->SetValue(point, static_cast<float>(particle.Radius));
    color->SetTypedTuple(point, particle.Color.data());
  };
  const auto setPlace = [&](vtkIdType point, const littoral::Vector3& at) {
    const Real tuple[3] = { static_cast<Real>(at.x), static_cast<Real>(at.y), static_cast<Real>(at.z) };
    place->SetTypedTuple(point, tuple);
  };
  const auto writeSquare = [&](
                             vtkIdType middle, int box, const littoral::SuspendedParticle& particle, long long index) {
    const littoral::PictureAxes axes = littoral::OrientationOf(box, index, this->Seed);
    const littoral::AtlasArea& area = areas[static_cast<std::size_t>(recipe.Boxes[box].Kind)];
    const auto slave = [&](int corner, double across, double along) {
      const vtkIdType point = middle + corner;
      const littoral::Vector3 shift = particle.Radius * (across * axes.Right + along * axes.Up);
      setPlace(point, particle.Place + shift);
      master->SetValue(point, corner == 0 ? -1 : middle);
      offset->SetTuple3(point, shift.x, shift.y, shift.z);
      const std::array<double, 2> uv = area.Map(0.5 + 0.5 * across, 0.5 + 0.5 * along);
      coordinates->SetTuple2(point, uv[0], uv[1]);
    };
    slave(0, 0.0, 0.0);
    for (int corner = 1; corner < QuadPoints; ++corner)
    {
      slave(corner, Corners[corner - 1][0], Corners[corner - 1][1]);
    }
  };
  const std::size_t batches = static_cast<std::size_t>((count + ParticlesAtOnce - 1) / ParticlesAtOnce);
  const bool done = littoral::RunWithProgress(this, batches, 0.0, 1.0, [&](std::size_t batch) {
    const long long begin = first + static_cast<long long>(batch) * ParticlesAtOnce;
    const long long end = std::min(begin + ParticlesAtOnce, last);
    int box =
      static_cast<int>(std::upper_bound(recipe.First.begin(), recipe.First.end(), begin) - recipe.First.begin());
    --box;
    for (long long number = begin; number < end; ++number)
    {
      while (number >= recipe.First[box + 1])
      {
        ++box;
      }
      const long long index = number - recipe.First[box];
      const littoral::SuspendedParticle particle =
        littoral::ParticleOf(recipe.Boxes[box], box, index, this->SizeSpread, this->Seed);
      const vtkIdType at = (number - first) * stride;
      for (int copy = 0; copy < stride; ++copy)
      {
        write(at + copy, number, box, particle);
      }
      if (quads)
      {
        writeSquare(at, box, particle, index);
      }
      else
      {
        setPlace(at, particle.Place);
      }
    }
  });
  if (!done)
  {
    return false;
  }
  vtkNew<vtkPoints> positions;
  positions->SetData(place);
  output->SetPoints(positions);
  vtkPointData* arrays = output->GetPointData();
  arrays->AddArray(id);
  arrays->AddArray(boxId);
  arrays->AddArray(type);
  arrays->AddArray(radius);
  arrays->SetScalars(color);
  if (quads)
  {
    arrays->AddArray(master);
    arrays->AddArray(offset);
    arrays->SetTCoords(coordinates);
    output->SetPolys(EvenCells(count, QuadPoints - 1, QuadPoints, 1));
  }
  else
  {
    output->SetVerts(EvenCells(count, 1, 1, 0));
  }
  return true;
}

//----------------------------------------------------------------------------
const char* vtkSuspendedParticleSource::GetPresetAsString() const
{
  return this->Preset == Custom ? "Custom"
                                : littoral::NameOfRow<littoral::ParticleScene>(
                                    this->Preset, littoral::NumberOfParticleScenes + 1, littoral::ParticleSceneName);
}

//----------------------------------------------------------------------------
void vtkSuspendedParticleSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Preset: " << this->Preset << "\n";
  os << indent << "Bounds: " << this->Bounds[0] << " " << this->Bounds[1] << " " << this->Bounds[2] << " "
     << this->Bounds[3] << " " << this->Bounds[4] << " " << this->Bounds[5] << "\n";
  os << indent << "Density: " << this->Density << "\n";
  os << indent << "Boxes: " << this->Boxes->Boxes.size() << "\n";
  os << indent << "AmountIs: " << this->AmountIs << "\n";
  os << indent << "SizeSpread: " << this->SizeSpread << "\n";
  os << indent << "Mode: " << this->Mode << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
