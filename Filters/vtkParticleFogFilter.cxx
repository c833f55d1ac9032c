// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkParticleFogFilter.h"

#include "Data/ArrayReader.h"
#include "Data/ArrayStamp.h"
#include "Data/Arrays.h"
#include "Data/Blocks.h"
#include "Data/Inputs.h"
#include "Data/SeaStateTable.h"
#include "Data/Tables.h"
#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Particles/ParticleFog.h"
#include "Pipeline/Mistakes.h"
#include "Pipeline/Pipeline.h"
#include "Pipeline/Ranges.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <deque>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkParticleFogFilter);

namespace
{

/// Memory of a particle and a sample at most [bytes].
constexpr double BytesAParticle = 50.0;
constexpr double BytesASample = 24.0;
constexpr double MostSamplesAlong = 1e6;
constexpr std::size_t MostKept = 4000000; // particles whose memory is kept for the next frame: 160 MB

/// The point sets that become fog: those of the block Far if there is one, else all.
std::vector<vtkPointSet*> FogOf(vtkDataObject* input)
{
  vtkDataObject* far = littoral::FindBlock(vtkMultiBlockDataSet::SafeDownCast(input), littoral::sea::Far);
  if (!far)
  {
    far = littoral::FindDataSet(vtkPartitionedDataSetCollection::SafeDownCast(input), littoral::sea::Far);
  }
  std::vector<vtkPointSet*> sets = littoral::PointSetsOf(far ? far : input, "Input");
  const auto isEmpty = [](vtkPointSet* set) { return !set->GetPoints() || set->GetNumberOfPoints() == 0; };
  sets.erase(std::remove_if(sets.begin(), sets.end(), isEmpty), sets.end());
  return sets;
}

/// Refuses a point that is no particle.
void RequirePoint(vtkIdType n, double radius, double alpha)
{
  const std::string ofPoint = " of point " + std::to_string(n);
  littoral::ParameterCheck check;
  check.NotNegative("Radius" + ofPoint, radius, "m");
  check.Range("Alpha" + ofPoint, alpha, 0.0, 1.0);
  littoral::Require(check.Reason());
}

/// The values of an array of single precision; null of any other.
const float* FloatsOf(vtkDataArray* array)
{
  auto* floats = vtkFloatArray::SafeDownCast(array);
  return floats ? floats->GetPointer(0) : nullptr;
}

/// The particles of a point set, as the fog takes them.
class ParticleReader
{
public:
  ParticleReader(vtkPointSet* set, std::size_t first, double radius, double efficiency)
    : First(first)
    , Count(static_cast<std::size_t>(set->GetNumberOfPoints()))
    , Places(set->GetPoints()->GetData())
    , SinglePlaces(FloatsOf(Places))
    , Efficiency(efficiency)
  {
    const littoral::ArrayReader points = littoral::ArrayReader::OfPoints(set, "a set of particles");
    this->Radius = { points.Find(littoral::sea::Radius, 1), radius };
    this->Alpha = { points.Find(littoral::sea::Alpha, 1), 1.0 };
    if (!(this->SinglePlaces && littoral::AreWithin(this->Places, littoral::MaximumMagnitude)))
    {
      points.NeedFinite(this->Places);
    }
  }

  std::size_t End() const { return this->First + this->Count; }

  /// Adds what tells whether they are those of the last time.
  void AddStamps(std::vector<littoral::ArrayStamp>& stamps) const
  {
    for (vtkDataArray* array : { this->Places, this->Radius.Array, this->Alpha.Array })
    {
      stamps.push_back(littoral::StampOf(array));
    }
  }

  /// Adds to bounds.
  void AddBounds(std::array<double, 6>& bounds) const
  {
    littoral::KeepRanges(this->Places);
    for (int axis = 0; axis < 3; ++axis)
    {
      double range[2];
      this->Places->GetRange(range, axis);
      bounds[2 * axis] = std::min(bounds[2 * axis], range[0]);
      bounds[2 * axis + 1] = std::max(bounds[2 * axis + 1], range[1]);
    }
  }

  /// Writes those of the particles [begin, end) that are of this set.
  void Read(std::size_t begin, std::size_t end, littoral::FogParticle* particles)
  {
    const std::size_t from = std::max(begin, this->First);
    const std::size_t to = std::min(end, this->End());
    if (from < to)
    {
      this->ReadPlaces(from - this->First, to - from, particles + (from - begin));
      this->ReadSections(from - this->First, to - from, particles + (from - begin));
    }
  }

  /// Refuses points that were read and are no particles.
  void RequireParticles() const
  {
    const vtkIdType id = this->Mistake;
    if (id < static_cast<vtkIdType>(this->Count))
    {
      RequirePoint(id, this->Radius.At(id), this->Alpha.At(id));
    }
  }

private:
  void ReadPlaces(std::size_t first, std::size_t count, littoral::FogParticle* particles) const
  {
    for (std::size_t n = 0; n < count; ++n)
    {
      littoral::Vector3& place = particles[n].Place;
      if (!this->SinglePlaces)
      {
        this->Places->GetTuple(static_cast<vtkIdType>(first + n), &place.x);
        continue;
      }
      const float* own = this->SinglePlaces + 3 * (first + n);
      place = { own[0], own[1], own[2] };
    }
  }

  void ReadSections(std::size_t first, std::size_t count, littoral::FogParticle* particles)
  {
    if (!this->Radius.Array && !this->Alpha.Array)
    {
      const double section = this->Efficiency * littoral::Pi * this->Radius.All * this->Radius.All;
      std::for_each(particles, particles + count, [=](littoral::FogParticle& one) { one.CrossSection = section; });
      return;
    }
    for (std::size_t n = 0; n < count; ++n)
    {
      const auto id = static_cast<vtkIdType>(first + n);
      const double radius = this->Radius.At(id);
      const double alpha = this->Alpha.At(id);
      particles[n].CrossSection = alpha * this->Efficiency * littoral::Pi * radius * radius;
      if (!(radius >= 0.0 && radius <= std::numeric_limits<double>::max() && alpha >= 0.0 && alpha <= 1.0))
      {
        this->AddMistake(id);
      }
    }
  }

  /// Numbers of points, or one of all.
  struct Numbers
  {
    vtkDataArray* Array;
    double All;
    const float* Single;

    Numbers(vtkDataArray* array = nullptr, double all = 0.0)
      : Array(array)
      , All(all)
      , Single(FloatsOf(array))
    {
    }
    double At(vtkIdType n) const
    {
      return this->Single ? static_cast<double>(this->Single[n])
        : this->Array     ? this->Array->GetComponent(n, 0)
                          : this->All;
    }
  };

  std::size_t First;
  std::size_t Count;
  vtkDataArray* Places;
  const float* SinglePlaces;
  double Efficiency;
  Numbers Radius;
  Numbers Alpha;
  std::atomic<vtkIdType> Mistake{ VTK_ID_MAX }; ///< the first of them

  void AddMistake(vtkIdType id)
  {
    vtkIdType former = this->Mistake;
    while (id < former && !this->Mistake.compare_exchange_weak(former, id))
    {
    }
  }
};

/// Bounds of all particles; 0 to 1 without any.
std::array<double, 6> BoundsOf(const std::deque<ParticleReader>& readers)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  std::array<double, 6> bounds{ none, -none, none, -none, none, -none };
  for (const ParticleReader& reader : readers)
  {
    reader.AddBounds(bounds);
  }
  return readers.empty() ? std::array<double, 6>{ 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 } : bounds;
}

/// The samples of an extent, with the extinction of the water itself.
void CopyExtinction(const littoral::FogGrid& grid, const littoral::ParticleFog& fog, float water, const int extent[6],
  vtkImageData* output, const littoral::Poll& onRow)
{
  output->SetExtent(extent[0], extent[1], extent[2], extent[3], extent[4], extent[5]);
  output->SetOrigin(&grid.Origin.x);
  output->SetSpacing(&grid.Spacing.x);
  if (extent[1] < extent[0] || extent[3] < extent[2] || extent[5] < extent[4])
  {
    return; // a rank with nothing to do
  }
  auto extinction = littoral::NewArray<vtkFloatArray>(littoral::sea::Extinction, 1, output->GetNumberOfPoints());
  float* sample = extinction->GetPointer(0);
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      onRow();
      const std::size_t row = (static_cast<std::size_t>(k) * grid.Count[1] + j) * grid.Count[0];
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        *sample++ = fog.GetExtinction()[row + i] + water;
      }
    }
  }
  output->GetPointData()->SetScalars(extinction);
}

}

class vtkParticleFogFilter::vtkInternals
{
public:
  littoral::FogMemory Memory;
  vtkMTimeType Time = 0; ///< modification time of the filter for the fog at hand
  std::vector<littoral::ArrayStamp> Read;
  littoral::FogGrid Grid;
  std::unique_ptr<littoral::ParticleFog> Fog; ///< null: none is at hand
};

//----------------------------------------------------------------------------
vtkParticleFogFilter::vtkParticleFogFilter()
  : GridBy(ByDimensions)
  , Dimensions{ 64, 64, 64 }
  , Spacing(0.5)
  , UseBounds(false)
  , Bounds{ -10.0, 10.0, -10.0, 10.0, -10.0, 0.0 }
  , ParticleRadius(0.005)
  , ExtinctionEfficiency(1.0)
  , WaterExtinction(0.0)
  , Internals(new vtkInternals)
{
}

//----------------------------------------------------------------------------
vtkParticleFogFilter::~vtkParticleFogFilter() = default;

//----------------------------------------------------------------------------
int vtkParticleFogFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkMultiBlockDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPartitionedDataSetCollection");
  return 1;
}

//----------------------------------------------------------------------------
void vtkParticleFogFilter::CheckProperties() const
{
  const bool bySpacing = this->GridBy == BySpacing;
  littoral::ParameterCheck check;
  check.Choice("GridBy", this->GridBy, 2);
  for (int axis = 0; axis < 3 && !bySpacing; ++axis)
  {
    check.Count("Dimensions[" + std::to_string(axis) + "]", this->Dimensions[axis], 2, VTK_INT_MAX);
  }
  if (bySpacing)
  {
    check.Positive("Spacing", this->Spacing, "m");
    check.Require(this->UseBounds, "GridBy spacing needs UseBounds: the size of the image must be known beforehand.");
  }
  check.Positive("ParticleRadius", this->ParticleRadius, "m");
  check.NotNegative("ExtinctionEfficiency", this->ExtinctionEfficiency);
  check.NotNegative("WaterExtinction", this->WaterExtinction, "1/m");
  littoral::Require(check.Reason());
  for (int axis = 0; axis < 3 && this->UseBounds; ++axis)
  {
    const double low = this->Bounds[2 * axis];
    const double high = this->Bounds[2 * axis + 1];
    if (!(littoral::IsSensible(low) && littoral::IsSensible(high) && low < high))
    {
      littoral::Refuse(
        "Bounds along ", "xyz"[axis], " are ", low, " to ", high, " m; they must be finite and increasing.");
    }
    if (bySpacing && (high - low) / this->Spacing > MostSamplesAlong)
    {
      littoral::Refuse("Spacing is ", this->Spacing, " m, too little for Bounds that are ", high - low, " m apart.");
    }
  }
  const double samples = static_cast<double>(this->MakeGrid(this->Bounds).NumberOfSamples());
  littoral::RequireMemory(BytesASample * samples, "the image of " + littoral::TextOf(samples) + " samples",
    "take fewer Dimensions or more Spacing");
}

//----------------------------------------------------------------------------
littoral::FogGrid vtkParticleFogFilter::MakeGrid(const double box[6]) const
{
  littoral::FogGrid grid;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double side = box[2 * axis + 1] - box[2 * axis];
    grid.Origin[axis] = box[2 * axis];
    if (this->GridBy == BySpacing)
    {
      constexpr double rounding = 1e-9;
      grid.Spacing[axis] = this->Spacing;
      grid.Count[axis] = static_cast<int>(std::max(1.0, std::ceil(side / this->Spacing - rounding))) + 1;
    }
    else
    {
      grid.Count[axis] = this->Dimensions[axis];
      grid.Spacing[axis] = side / (this->Dimensions[axis] - 1);
    }
  }
  return grid;
}

//----------------------------------------------------------------------------
int vtkParticleFogFilter::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  this->CheckProperties();
  const littoral::FogGrid grid = this->MakeGrid(this->Bounds);
  const int whole[6] = { 0, grid.Count[0] - 1, 0, grid.Count[1] - 1, 0, grid.Count[2] - 1 };
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole, 6);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 1);
  if (this->UseBounds)
  {
    info->Set(vtkDataObject::ORIGIN(), &grid.Origin.x, 3);
    info->Set(vtkDataObject::SPACING(), &grid.Spacing.x, 3);
  }
  else
  {
    // Known only with the particles.
    info->Remove(vtkDataObject::ORIGIN());
    info->Remove(vtkDataObject::SPACING());
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkParticleFogFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  littoral::RequestAll(inputVector[0]->GetInformationObject(0));
  return 1;
}

//----------------------------------------------------------------------------
/// Makes the fog of particles, which stays until they change.
template <typename Readers>
void vtkParticleFogFilter::MakeFog(Readers& readers)
{
  vtkInternals& internals = *this->Internals;
  const std::size_t number = readers.empty() ? 0 : readers.back().End();
  const auto read = [&readers](std::size_t begin, std::size_t end, littoral::FogParticle* particles) {
    for (ParticleReader& reader : readers)
    {
      reader.Read(begin, end, particles);
    }
  };
  this->UpdateProgress(0.1);
  const std::array<double, 6> bounds = littoral::Thickened(BoundsOf(readers), 2.0 * this->ParticleRadius);
  const littoral::FogGrid grid = this->MakeGrid(this->UseBounds ? this->Bounds : bounds.data());
  auto fog = std::make_unique<littoral::ParticleFog>(
    grid, number, read, internals.Memory, littoral::AbortableFor(this), littoral::PollOf(this));
  internals.Memory.Limit(MostKept);
  for (const ParticleReader& reader : readers)
  {
    reader.RequireParticles();
  }
  internals.Grid = grid;
  internals.Fog = std::move(fog);
}

//----------------------------------------------------------------------------
int vtkParticleFogFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  littoral::ForgetExtent(info);
  if (littoral::IsAnnouncedEmpty(info))
  {
    return littoral::FailedRequest(this);
  }
  const std::vector<vtkPointSet*> sets = FogOf(vtkDataObject::GetData(inputVector[0]));
  double count = 0.0;
  for (vtkPointSet* set : sets)
  {
    count += static_cast<double>(set->GetNumberOfPoints());
  }
  littoral::RequireMemory(BytesAParticle * count, "fog of " + littoral::TextOf(count) + " particles", "take fewer");
  this->SetProgressText("Making fog");
  std::deque<ParticleReader> readers;
  for (vtkPointSet* set : sets)
  {
    readers.emplace_back(
      set, readers.empty() ? 0 : readers.back().End(), this->ParticleRadius, this->ExtinctionEfficiency);
  }
  vtkInternals& internals = *this->Internals;
  std::vector<littoral::ArrayStamp> arrays;
  std::for_each(readers.begin(), readers.end(), [&](const ParticleReader& reader) { reader.AddStamps(arrays); });
  if (!internals.Fog || internals.Time != this->GetMTime() || internals.Read != arrays)
  {
    internals.Fog = nullptr;
    this->MakeFog(readers);
    internals.Time = this->GetMTime();
    internals.Read = std::move(arrays);
  }
  this->UpdateProgress(0.8);

  const littoral::FogGrid& grid = internals.Grid;
  const littoral::ParticleFog& fog = *internals.Fog;
  vtkImageData* output = vtkImageData::GetData(info);
  const std::array<int, 6> extent = littoral::RequestedExtent(info);
  CopyExtinction(grid, fog, static_cast<float>(this->WaterExtinction), extent.data(), output, littoral::PollOf(this));
  littoral::AddField(output, "ParticlesInFog", { count - static_cast<double>(fog.GetOutside()) });
  littoral::AddField(output, "ParticlesOutside", { static_cast<double>(fog.GetOutside()) });
  littoral::AddField(
    output, "CrossSection", { littoral::TotalCrossSection(grid, fog.GetExtinction(), littoral::PollOf(this)) });
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
int vtkParticleFogFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(this, request, outputs,
    "Cannot make fog: ", [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkParticleFogFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "GridBy: " << this->GridBy << "\n";
  os << indent << "Dimensions: " << this->Dimensions[0] << " " << this->Dimensions[1] << " " << this->Dimensions[2]
     << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "UseBounds: " << this->UseBounds << "\n";
  os << indent << "Bounds:";
  for (const double bound : this->Bounds)
  {
    os << " " << bound;
  }
  os << "\n";
  os << indent << "ParticleRadius: " << this->ParticleRadius << "\n";
  os << indent << "ExtinctionEfficiency: " << this->ExtinctionEfficiency << "\n";
  os << indent << "WaterExtinction: " << this->WaterExtinction << "\n";
}
