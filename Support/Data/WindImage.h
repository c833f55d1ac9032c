// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportWindImage_h
#define LittoralSupportWindImage_h

// A wind field between VTK and the numerics. Private: never installed, never wrapped.

#include "Sway/PlantSway.h"
#include "Wind/WindLines.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>

namespace littoral
{

/// A frozen field and how it is carried along: by one sample of x a step. It repeats along x.
class WindImage
{
public:
  /// The reason why there is no wind, or nothing.
  std::string Read(vtkImageData* image);

  const WindTimes& Times() const { return this->Time; }
  double Period() const { return this->Time.Step * static_cast<double>(this->Time.Samples); }

  /// Whether a place lies within the field across the wind and below its top. Below its lowest layer is within.
  bool Reaches(const Vector3& place) const;

  /// `count` velocities at a place, one a step, from the step `first` on. Beyond its edges the field goes on as there.
  void Sample(const Vector3& place, double first, std::size_t count, Vector3* velocities) const;

  /// When what is at the beginning of the field now comes to a place, which may be beyond its edges [s].
  double Arrival(const Vector3& place) const;

  /// A place in the middle of the field, at a height.
  Vector3 Middle(double height) const;

private:
  vtkSmartPointer<vtkImageData> Image;
  std::unique_ptr<const WindLines> Lines;
  int Size[3] = { 1, 1, 1 };
  WindTimes Time;

  std::string ReadTimes();
  bool Locate(const Vector3& place, double index[3]) const;
};

}

#endif
