// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkParticleFogFilter.h"

#include "Data/ArrayReader.h"
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
#include <limits>
#include <sstream>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkParticleFogFilter);

namespace
{

/// Memory of a particle and a sample at most [bytes].
constexpr double BytesAParticle = 150.0;
constexpr double BytesASample = 24.0;
constexpr double MostSamplesAlong = 1e6;

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

/// Adds the particles of a point set.
void AddParticles(vtkPointSet* set, double defaultRadius, double efficiency,
  std::vector<littoral::FogParticle>& particles, const littoral::ParallelFor& parallelFor)
{
  const littoral::ArrayReader points = littoral::ArrayReader::OfPoints(set, "a set of particles");
  vtkDataArray* radii = points.Find(littoral::sea::Radius, 1);
  vtkDataArray* alphas = points.Find(littoral::sea::Alpha, 1);
  points.NeedFinite(set->GetPoints()->GetData());
  const std::size_t first = particles.size();
  littoral::SetSize(particles, static_cast<vtkIdType>(first) + set->GetNumberOfPoints());
  std::atomic<vtkIdType> bad(set->GetNumberOfPoints());
  const auto numbers = [](vtkDataArray* array) {
    const auto* single = vtkFloatArray::SafeDownCast(array);
    return [array, single](
             vtkIdType n) { return single ? static_cast<double>(single->GetValue(n)) : array->GetComponent(n, 0); };
  };
  const auto radiusOf = numbers(radii);
  const auto alphaOf = numbers(alphas);
  auto* places = vtkFloatArray::SafeDownCast(set->GetPoints()->GetData());
  parallelFor(static_cast<std::size_t>(set->GetNumberOfPoints()), [&](std::size_t begin, std::size_t end) {
    for (auto n = static_cast<vtkIdType>(begin); n < static_cast<vtkIdType>(end); ++n)
    {
      littoral::FogParticle& particle = particles[first + static_cast<std::size_t>(n)];
      places ? static_cast<void>(std::copy_n(places->GetPointer(3 * n), 3, &particle.Place.x))
             : set->GetPoints()->GetData()->GetTuple(n, &particle.Place.x);
      const double radius = radii ? radiusOf(n) : defaultRadius;
      const double alpha = alphas ? alphaOf(n) : 1.0;
      particle.CrossSection = alpha * efficiency * littoral::Pi * radius * radius;
      if (!littoral::ValueInterval::NotNegative().Contains(radius) || !(alpha >= 0.0 && alpha <= 1.0))
      {
        vtkIdType former = bad; // the first of them
        while (n < former && !bad.compare_exchange_weak(former, n))
        {
        }
      }
    }
  });
  const vtkIdType n = bad;
  if (n < set->GetNumberOfPoints())
  {
    RequirePoint(n, radii ? radiusOf(n) : defaultRadius, alphas ? alphaOf(n) : 1.0);
  }
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
  vtkIdType sample = 0;
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      onRow();
      const std::size_t row = (static_cast<std::size_t>(k) * grid.Count[1] + j) * grid.Count[0];
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        extinction->SetValue(sample++, fog.GetExtinction()[row + i] + water);
      }
    }
  }
  output->GetPointData()->SetScalars(extinction);
}

}

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
  std::vector<littoral::FogParticle> particles;
  for (vtkPointSet* set : sets)
  {
    AddParticles(set, this->ParticleRadius, this->ExtinctionEfficiency, particles, littoral::AbortableFor(this));
  }
  this->UpdateProgress(0.3);
  const std::array<double, 6> bounds = littoral::BoundsOf(particles, 2.0 * this->ParticleRadius);
  const littoral::FogGrid grid = this->MakeGrid(this->UseBounds ? this->Bounds : bounds.data());
  const littoral::ParticleFog fog(grid, particles, littoral::AbortableFor(this), littoral::PollOf(this));
  this->UpdateProgress(0.8);

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
