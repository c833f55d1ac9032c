// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/WindImage.h"

#include "Pipeline/Pipeline.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// The first number of a field array; 0 where there is none.
double FieldNumber(vtkDataObject* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() > 0 ? array->GetTuple1(0) : 0.0;
}

vtkSmartPointer<vtkFloatArray> FloatsOf(vtkDataArray* array)
{
  vtkSmartPointer<vtkFloatArray> floats = vtkFloatArray::SafeDownCast(array);
  if (!floats)
  {
    floats = vtkSmartPointer<vtkFloatArray>::New();
    floats->DeepCopy(array);
  }
  return floats;
}

std::string ReadTimes(vtkImageData* image, WindTimes& times)
{
  const double convection = FieldNumber(image, "ConvectionSpeed");
  if (!(convection > 0.0) || !std::isfinite(convection))
  {
    return "The wind has no field data ConvectionSpeed that is positive.";
  }
  const int samples = image->GetDimensions()[0];
  times.Step = image->GetSpacing()[0] / convection;
  if (samples < 4 || !(times.Step > 0.0))
  {
    return "The wind has no duration: it needs at least four samples along x, and a positive Spacing.";
  }
  times.Samples = static_cast<std::size_t>(samples);
  const bool told = image->GetFieldData()->GetArray("Period") != nullptr;
  const double period = FieldNumber(image, "Period");
  if (told && !(std::abs(period - times.Period()) < 1e-3 * times.Period()))
  {
    return "Period of the wind is not the length of its image over ConvectionSpeed.";
  }
  return {};
}

FrozenWindGrid GridOf(vtkImageData* image)
{
  FrozenWindGrid grid;
  const int* extent = image->GetExtent();
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.Size[axis] = image->GetDimensions()[axis];
    grid.FirstIndex[axis] = extent[2 * axis];
    for (int column = 0; column < 4; ++column)
    {
      grid.ToIndex[axis][column] = image->GetPhysicalToIndexMatrix()->GetElement(axis, column);
    }
  }
  grid.LayerSpacing = image->GetSpacing()[2];
  grid.Bottom = image->GetOrigin()[2] + extent[4] * grid.LayerSpacing;
  return grid;
}

}

std::string ReadWind(vtkImageData* image, std::shared_ptr<const FrozenWind>& wind)
{
  vtkDataArray* velocity = image->GetPointData()->GetArray("Velocity");
  if (!velocity || velocity->GetNumberOfComponents() != 3)
  {
    return "The wind has no point array Velocity of three components.";
  }
  WindTimes times;
  const std::string reason = ReadTimes(image, times);
  if (!reason.empty())
  {
    return reason;
  }
  const vtkSmartPointer<vtkFloatArray> floats = FloatsOf(velocity);
  const float* values = floats->GetPointer(0);
  if (!std::all_of(values, values + floats->GetNumberOfValues(), [](float value) { return std::isfinite(value); }))
  {
    return "Velocity of the wind has values that are not finite.";
  }
  const FrozenWindGrid grid = GridOf(image);
  const double bytes = WindLines::BytesOf(grid.Size);
  if (bytes > AvailableMemory())
  {
    return "The waves of the wind need " + std::to_string(static_cast<long long>(bytes / 1e6)) +
      " MB, more than this machine has free.";
  }
  wind = std::make_shared<const FrozenWind>(grid, times, values, SmpFor);
  return {};
}

Vector3 MiddleOfWind(vtkImageData* image, double height)
{
  double bounds[6];
  image->GetBounds(bounds);
  return { bounds[0], 0.5 * (bounds[2] + bounds[3]), height };
}

}
