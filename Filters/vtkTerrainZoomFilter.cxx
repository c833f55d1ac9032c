// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainZoomFilter.h"

#include "Data/Arrays.h"
#include "Data/Inputs.h"
#include "Data/Tables.h"
#include "Data/TerrainHeights.h"
#include "Landscapes/TerrainZoom.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Pipeline.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

vtkStandardNewMacro(vtkTerrainZoomFilter);

namespace
{

constexpr int LeastFactor = 2;
constexpr int GreatestFactor = 16;

/// Extent, spacing and origin of cells that are divided along x and y.
struct FineGrid
{
  std::array<int, 6> Extent;
  std::array<double, 3> Spacing;
  std::array<double, 3> Origin;
};

FineGrid Divided(vtkInformation* coarse, int factor)
{
  FineGrid fine{};
  coarse->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), fine.Extent.data());
  coarse->Get(vtkDataObject::SPACING(), fine.Spacing.data());
  coarse->Get(vtkDataObject::ORIGIN(), fine.Origin.data());
  std::array<double, 9> direction{ 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
  if (coarse->Has(vtkDataObject::DIRECTION()))
  {
    coarse->Get(vtkDataObject::DIRECTION(), direction.data());
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    const std::int64_t first = static_cast<std::int64_t>(fine.Extent[2 * axis]) * factor;
    const std::int64_t last = (static_cast<std::int64_t>(fine.Extent[2 * axis + 1]) + 1) * factor - 1;
    constexpr std::int64_t most = std::numeric_limits<int>::max();
    littoral::Require(first >= -most && last <= most ? "" : "The terrain is too wide for this Factor.");
    fine.Extent[2 * axis] = static_cast<int>(first);
    fine.Extent[2 * axis + 1] = static_cast<int>(last);
    // the first fine point is half a fine cell from the edge of the first coarse cell
    const double shift = 0.5 * fine.Spacing[axis] * (1.0 / factor - 1.0);
    for (int n = 0; n < 3; ++n)
    {
      fine.Origin[n] += direction[3 * n + axis] * shift;
    }
    fine.Spacing[axis] /= factor;
  }
  return fine;
}

}

//----------------------------------------------------------------------------
vtkTerrainZoomFilter::vtkTerrainZoomFilter()
  : Factor(3)
  , Growth(1.0)
  , MaximumShift(0.5)
  , Seed(1)
{
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

//----------------------------------------------------------------------------
vtkTerrainZoomFilter::~vtkTerrainZoomFilter() = default;

//----------------------------------------------------------------------------
int vtkTerrainZoomFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//----------------------------------------------------------------------------
int vtkTerrainZoomFilter::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  littoral::AnnounceParts(info); // else each rank would be asked for the whole image
  if (!this->Superclass::RequestInformation(request, inputs, outputs))
  {
    return 0;
  }
  // a bad factor is refused once there is data
  const int factor = std::clamp(this->Factor, LeastFactor, GreatestFactor);
  FineGrid fine = Divided(inputs[0]->GetInformationObject(0), factor);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), fine.Extent.data(), 6);
  info->Set(vtkDataObject::SPACING(), fine.Spacing.data(), 3);
  info->Set(vtkDataObject::ORIGIN(), fine.Origin.data(), 3);
  return 1;
}

//----------------------------------------------------------------------------
int vtkTerrainZoomFilter::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  // Flow is not local.
  littoral::RequestAll(inputs[0]->GetInformationObject(0));
  return 1;
}

//----------------------------------------------------------------------------
int vtkTerrainZoomFilter::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  littoral::ForgetExtent(info);
  vtkImageData* output = vtkImageData::GetData(outputs, 0);
  output->Initialize();
  this->SetProgressText("Zooming the terrain");
  littoral::InContext("Cannot zoom a terrain: ", [&] {
    littoral::ZoomParameters parameters;
    parameters.Factor = this->Factor;
    parameters.Growth = this->Growth;
    parameters.MaximumShift = this->MaximumShift;
    parameters.Seed = this->Seed;
    littoral::Require(littoral::WhyInvalid(parameters));
    auto* image = littoral::InputOf<vtkImageData>(inputs[0], "Terrain");
    const int* size = image->GetDimensions();
    const double* spacing = image->GetSpacing();
    const double memory = littoral::ZoomMemory(size[0], size[1], this->Factor, { spacing[0], spacing[1] }) /
      std::max(1.0, static_cast<double>(size[0]) * size[1]);
    const littoral::GridSamples coarse = littoral::ReadHeights(image, this->GetInputArrayToProcess(0, inputs),
      this->GetInputArrayInformation(0), "Terrain", { memory, "zooming it" });
    littoral::Require(littoral::WhyInvalid(coarse, parameters));
    const littoral::Poll poll = littoral::PollOf(this);
    const littoral::ZoomedTerrain zoomed =
      littoral::ZoomTerrain(coarse, parameters, littoral::AbortableFor(this), [&](double part) {
        this->UpdateProgress(part);
        poll();
      });
    FineGrid fine = Divided(inputs[0]->GetInformationObject(0), this->Factor);
    output->SetExtent(fine.Extent.data());
    output->SetSpacing(fine.Spacing.data());
    output->SetOrigin(fine.Origin.data());
    output->SetDirectionMatrix(image->GetDirectionMatrix());
    const std::vector<double>& heights = zoomed.Heights.Values;
    const auto elevations = littoral::NewArray<vtkDoubleArray>("Elevation", 1, static_cast<vtkIdType>(heights.size()));
    std::copy(heights.begin(), heights.end(), elevations->GetPointer(0));
    output->GetPointData()->SetScalars(elevations);
    littoral::AddField(output, "LargestShift", { zoomed.LargestShift });
    littoral::AddField(output, "LargestShare", { zoomed.LargestShare });
  });
  std::array<int, 6> extent = littoral::RequestedExtent(info);
  output->Crop(extent.data());
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
int vtkTerrainZoomFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(
    this, request, outputs, [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkTerrainZoomFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Factor: " << this->Factor << "\n";
  os << indent << "Growth: " << this->Growth << "\n";
  os << indent << "MaximumShift: " << this->MaximumShift << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
