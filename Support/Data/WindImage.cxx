// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/WindImage.h"

#include "Pipeline/Pipeline.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"

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

}

std::string WindImage::Read(vtkImageData* image)
{
  vtkDataArray* velocity = image->GetPointData()->GetArray("Velocity");
  if (!velocity || velocity->GetNumberOfComponents() != 3)
  {
    return "The wind has no point array Velocity of three components.";
  }
  this->Image = image;
  image->GetDimensions(this->Size);
  const std::string reason = this->ReadTimes();
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
  const std::array<int, 3> size{ this->Size[0], this->Size[1], this->Size[2] };
  const double bytes = WindLines::BytesOf(size);
  if (bytes > AvailableMemory())
  {
    return "The waves of the wind need " + std::to_string(static_cast<long long>(bytes / 1e6)) +
      " MB, more than this machine has free.";
  }
  this->Lines = std::make_unique<const WindLines>(values, size, SmpFor);
  return {};
}

std::string WindImage::ReadTimes()
{
  const double convection = FieldNumber(this->Image, "ConvectionSpeed");
  if (!(convection > 0.0) || !std::isfinite(convection))
  {
    return "The wind has no field data ConvectionSpeed that is positive.";
  }
  this->Time.Step = this->Image->GetSpacing()[0] / convection;
  if (this->Size[0] < 4 || !(this->Time.Step > 0.0))
  {
    return "The wind has no duration: it needs at least four samples along x, and a positive Spacing.";
  }
  this->Time.Samples = static_cast<std::size_t>(this->Size[0]);
  const bool told = this->Image->GetFieldData()->GetArray("Period") != nullptr;
  const double period = FieldNumber(this->Image, "Period");
  if (told && !(std::abs(period - this->Period()) < 1e-3 * this->Period()))
  {
    return "Period of the wind is not the length of its image over ConvectionSpeed.";
  }
  return {};
}

bool WindImage::Locate(const Vector3& place, double index[3]) const
{
  this->Image->TransformPhysicalPointToContinuousIndex(&place.x, index);
  const int* extent = this->Image->GetExtent();
  for (int axis = 0; axis < 3; ++axis)
  {
    index[axis] -= extent[2 * axis];
  }
  constexpr double Slack = 1e-6;
  const bool inside =
    index[1] >= -Slack && index[1] <= this->Size[1] - 1 + Slack && index[2] <= this->Size[2] - 1 + Slack;
  index[1] = std::clamp(index[1], 0.0, this->Size[1] - 1.0);
  index[2] = std::clamp(index[2], 0.0, this->Size[2] - 1.0);
  return inside;
}

bool WindImage::Reaches(const Vector3& place) const
{
  double index[3];
  return this->Locate(place, index);
}

Vector3 WindImage::Middle(double height) const
{
  double bounds[6];
  this->Image->GetBounds(bounds);
  return { bounds[0], 0.5 * (bounds[2] + bounds[3]), height };
}

void WindImage::Sample(const Vector3& place, double first, std::size_t count, Vector3* velocities) const
{
  double index[3];
  this->Locate(place, index);
  const double spacing = this->Image->GetSpacing()[2];
  const double bottom = this->Image->GetOrigin()[2] + this->Image->GetExtent()[4] * spacing;
  const double layer = LayerPlace(bottom + index[2] * spacing, bottom, spacing);
  this->Lines->Sample({ index[0], index[1], layer }, first, count, velocities);
}

double WindImage::Arrival(const Vector3& place) const
{
  double index[3];
  this->Locate(place, index);
  return index[0] * this->Time.Step;
}

}
