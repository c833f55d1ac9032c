// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/TerrainHeights.h"

#include "Data/Arrays.h"
#include "Data/Inputs.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Memory.h"
#include "Pipeline/Pipeline.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPointData.h"

#include <cmath>
#include <limits>

namespace littoral
{

namespace
{

/// Water needs an inner cell.
constexpr int SmallestSide = 3;

/// The chosen array, or the active scalars for an absent Elevation.
vtkDataArray* HeightArray(vtkImageData* image, vtkDataArray* array, vtkInformation* choice, const char* input)
{
  const std::string owner = std::string(input) + " has no ";
  if (!array && NamesDefaultElevation(choice))
  {
    array = image->GetPointData()->GetScalars();
  }
  const char* name = choice->Get(vtkDataObject::FIELD_NAME());
  if (!array && name && !NamesNoArray(choice))
  {
    Refuse(owner, "array '", name, "' of heights.");
  }
  if (!array || array->GetNumberOfTuples() != image->GetNumberOfPoints() || array->GetNumberOfComponents() != 1)
  {
    Refuse(owner, "scalar point array of heights", array ? ": the chosen one is a vector or lies on cells." : ".");
  }
  return array;
}

void RequireMemoryFor(vtkImageData* image, const CellMemory& memory)
{
  const int* size = image->GetDimensions();
  RequireMemory(memory.Bytes * size[0] * size[1],
    "Terrain of " + std::to_string(size[0]) + " x " + std::to_string(size[1]) + " points: " + memory.Task,
    "take a part of it or a coarser one");
}

}

vtkDataArray* FindHeights(vtkImageData* image, vtkDataArray* array, vtkInformation* choice, const char* input)
{
  RequireRaster(image, SmallestSide);
  return HeightArray(image, array, choice, input);
}

GridSamples ReadHeights(vtkImageData* image, vtkDataArray* array, vtkInformation* choice, const char* input,
  const CellMemory& memory, const Poll& poll)
{
  vtkDataArray* values = FindHeights(image, array, choice, input);
  RequireMemoryFor(image, memory);
  int size[3];
  image->GetDimensions(size);
  GridSamples heights;
  heights.Width = size[0];
  heights.Height = size[1];
  heights.Spacing = { image->GetSpacing()[0], image->GetSpacing()[1] };
  SetSize(heights.Values, image->GetNumberOfPoints());
  ForPolled(heights.Values.size(), poll, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell)
    {
      const double height = values->GetComponent(static_cast<vtkIdType>(cell), 0);
      heights.Values[cell] = std::isfinite(height) ? height : std::numeric_limits<double>::quiet_NaN();
    }
  });
  return heights;
}

void RequireRelief(const GridSamples& heights, const char* input)
{
  const auto [least, most] = RangeOf(heights.Values);
  if (!(least < most))
  {
    Refuse(input, " is constant: water has no way to run, and nothing is to measure.");
  }
}

}
