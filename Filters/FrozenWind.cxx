// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FrozenWind.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
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

std::string FrozenWind::Read(vtkImageData* image)
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
  this->Velocity = FloatsOf(velocity);
  const float* values = this->Velocity->GetPointer(0);
  const bool finite =
    std::all_of(values, values + this->Velocity->GetNumberOfValues(), [](float value) { return std::isfinite(value); });
  return finite ? std::string() : "Velocity of the wind has values that are not finite.";
}

std::string FrozenWind::ReadTimes()
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

bool FrozenWind::Locate(const Vector3& place, double index[3]) const
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

bool FrozenWind::Reaches(const Vector3& place) const
{
  double index[3];
  return this->Locate(place, index);
}

Vector3 FrozenWind::Middle(double height) const
{
  double bounds[6];
  this->Image->GetBounds(bounds);
  return { bounds[0], 0.5 * (bounds[2] + bounds[3]), height };
}

void FrozenWind::Sample(const Vector3& place, long long first, std::size_t count, Vector3* velocities) const
{
  double index[3];
  this->Locate(place, index);
  const long long n = this->Size[0];
  const double begin = std::floor(index[0]);
  const double part = index[0] - begin;
  // What is at sample i now comes to the place's sample i0 in i0 - i steps.
  const long long from = (static_cast<long long>(begin) - first) % n;
  std::fill_n(velocities, count, Vector3(0.0));
  for (int corner = 0; corner < 4; ++corner)
  {
    const int j = std::min(static_cast<int>(index[1]) + corner % 2, this->Size[1] - 1);
    const int k = std::min(static_cast<int>(index[2]) + corner / 2, this->Size[2] - 1);
    const double fj = index[1] - static_cast<int>(index[1]);
    const double fk = index[2] - static_cast<int>(index[2]);
    const double weight = (corner % 2 ? fj : 1.0 - fj) * (corner / 2 ? fk : 1.0 - fk);
    if (weight == 0.0)
    {
      continue;
    }
    const float* line = this->Velocity->GetPointer(3 * n * (j + static_cast<vtkIdType>(this->Size[1]) * k));
    long long i = from < 0 ? from + n : from;
    for (std::size_t sample = 0; sample < count; ++sample)
    {
      const float* a = line + 3 * i;
      const float* b = i + 1 < n ? a + 3 : line;
      for (int axis = 0; axis < 3; ++axis)
      {
        velocities[sample][axis] += weight * ((1.0 - part) * a[axis] + part * b[axis]);
      }
      i = i > 0 ? i - 1 : n - 1;
    }
  }
}

}
