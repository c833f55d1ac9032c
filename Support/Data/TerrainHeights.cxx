// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/TerrainHeights.h"

#include "Data/Inputs.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Memory.h"
#include "Pipeline/Pipeline.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPointData.h"

#include <algorithm>

namespace littoral
{

namespace
{

/// Water needs an inner cell.
constexpr int SmallestSide = 3;

/// The chosen array, or the active scalars for an absent Elevation; null with the reason if it holds no heights.
vtkDataArray* HeightArray(
  vtkImageData* image, vtkDataArray* array, vtkInformation* choice, const char* input, std::string& reason)
{
  const std::string owner = std::string(input) + " has no ";
  if (!array && NamesDefaultElevation(choice))
  {
    array = image->GetPointData()->GetScalars();
  }
  const char* name = choice->Get(vtkDataObject::FIELD_NAME());
  if (!array && name && !NamesNoArray(choice))
  {
    reason = owner + "array '" + name + "' of heights.";
    return nullptr;
  }
  if (!array || array->GetNumberOfTuples() != image->GetNumberOfPoints() || array->GetNumberOfComponents() != 1)
  {
    reason = owner + "scalar point array of heights" + (array ? ": the chosen one is a vector or lies on cells." : ".");
    return nullptr;
  }
  return array;
}

}

std::string WhyTooLarge(vtkImageData* image, const CellMemory& memory)
{
  const int* size = image->GetDimensions();
  const double bytes = memory.Bytes * size[0] * size[1];
  if (bytes <= AvailableMemory())
  {
    return {};
  }
  return "Terrain of " + std::to_string(size[0]) + " x " + std::to_string(size[1]) + " points: " + memory.Task +
    " needs all of it at once and " + TextOf(bytes / 0x1p30) +
    " GiB, more than this machine has free. Take a part of it or a coarser one.";
}

bool ReadHeights(vtkImageData* image, vtkDataArray* array, vtkInformation* choice, const char* input,
  const CellMemory& memory, GridSamples& heights, std::string& reason)
{
  std::string own = WhyNoRaster(image, SmallestSide);
  vtkDataArray* values = own.empty() ? HeightArray(image, array, choice, input, own) : nullptr;
  own = own.empty() ? WhyTooLarge(image, memory) : own;
  if (!own.empty())
  {
    reason = reason.empty() ? own : reason;
    return false;
  }
  int size[3];
  image->GetDimensions(size);
  heights.Width = size[0];
  heights.Height = size[1];
  heights.Spacing = { image->GetSpacing()[0], image->GetSpacing()[1] };
  heights.Values.resize(static_cast<std::size_t>(image->GetNumberOfPoints()));
  for (std::size_t cell = 0; cell < heights.Values.size(); ++cell)
  {
    heights.Values[cell] = values->GetComponent(static_cast<vtkIdType>(cell), 0);
  }
  return true;
}

std::string WhyConstant(const GridSamples& heights, const char* input)
{
  const auto [least, most] = std::minmax_element(heights.Values.begin(), heights.Values.end());
  return *least < *most ? "" : std::string(input) + " is constant: water has no way to run, and nothing is to measure.";
}

}
