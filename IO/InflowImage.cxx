// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "InflowImage.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/Inputs.h"
#include "Numerics/InvalidInput.h"
#include "Numerics/ParameterCheck.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// A number of the field data; the other one if there is none.
double FieldOf(const ArrayReader& fields, const char* name, double otherwise)
{
  vtkDataArray* field = fields.Find(name, 1);
  return field ? field->GetComponent(0, 0) : otherwise;
}

/// Height of the hub: as chosen, as the wind says, or that of the middle of the grid.
double HubOf(const ArrayReader& fields, const InflowGrid& grid, double chosen)
{
  const double height = (grid.Count[2] - 1) * grid.VerticalSpacing;
  const auto reaches = [&](double hub) { return hub >= grid.BottomHeight && hub <= grid.BottomHeight + height; };
  if (chosen > 0.0)
  {
    Require(reaches(chosen) ? "" : "HubHeight is " + TextOf(chosen) + " m, which is not within the grid");
    return chosen;
  }
  const double told = FieldOf(fields, "HubHeight", FieldOf(fields, "ReferenceHeight", std::nan("")));
  return reaches(told) ? told : grid.BottomHeight + 0.5 * height;
}

void TakeTower(InflowGrid& grid, int layers)
{
  ParameterCheck check;
  check.Count("TowerLayers", layers, 0, grid.Count[2] - 1);
  Require(check.Reason());
  Require(layers == 0 || grid.Count[1] % 2 == 1
      ? ""
      : "TowerLayers needs an odd number of points across, for the tower stands on the middle one");
  grid.TowerPoints = layers;
  grid.Count[2] -= layers;
  grid.BottomHeight += layers * grid.VerticalSpacing;
}

}

void InflowPlacing::Place(
  const InflowGrid& grid, bool isTower, double origin[3], double spacing[3], double turn[9]) const
{
  const double cosine = this->Direction[0];
  const double sine = this->Direction[1];
  spacing[0] = grid.Speed * grid.TimeStep;
  spacing[1] = grid.LateralSpacing;
  spacing[2] = grid.VerticalSpacing;
  const double along = spacing[0] * (grid.Count[0] - 1);
  const double right = isTower ? 0.0 : 0.5 * spacing[1] * (grid.Count[1] - 1);
  origin[0] = this->Center[0] - cosine * along + sine * right;
  origin[1] = this->Center[1] - sine * along - cosine * right;
  origin[2] = grid.BottomHeight - (isTower ? grid.TowerPoints * spacing[2] : 0.0);
  const double axes[9] = { cosine, -sine, 0.0, sine, cosine, 0.0, 0.0, 0.0, 1.0 };
  std::copy_n(axes, 9, turn);
}

std::array<int, 6> ExtentOf(const InflowGrid& grid, bool isTower)
{
  if (isTower && grid.TowerPoints == 0)
  {
    return { 0, -1, 0, -1, 0, -1 };
  }
  return { 0, grid.Count[0] - 1, 0, isTower ? 0 : grid.Count[1] - 1, 0,
    (isTower ? grid.TowerPoints : grid.Count[2]) - 1 };
}

InflowGrid ReadInflowGrid(vtkImageData* image, const int whole[6], const InflowChoices& choices)
{
  RequireFit(image, "Input");
  const ArrayReader fields = ArrayReader::OfFields(image, "The wind", 1);
  const double* spacing = image->GetSpacing();
  const double* axes = image->GetDirectionMatrix()->GetData();
  Require(
    axes[2] == 0.0 && axes[5] == 0.0 && axes[6] == 0.0 && axes[7] == 0.0 ? "" : "the image of the wind is tilted");
  InflowGrid grid;
  grid.Count = { whole[1] - whole[0] + 1, whole[3] - whole[2] + 1, whole[5] - whole[4] + 1 };
  grid.Speed = fields.Need("ConvectionSpeed", 1)->GetComponent(0, 0);
  grid.TimeStep = spacing[0] / grid.Speed;
  grid.LateralSpacing = spacing[1];
  grid.VerticalSpacing = spacing[2];
  grid.BottomHeight = image->GetOrigin()[2] + whole[4] * spacing[2];
  Require(grid.Count[0] > 1 ? "" : "the wind has no duration: its image has one sample along x");
  Require(WhyInvalid(grid));
  const double period = FieldOf(fields, "Period", 0.0);
  grid.IsPeriodic = std::abs(period - grid.Count[0] * grid.TimeStep) < 1e-3 * grid.TimeStep;
  TakeTower(grid, choices.TowerLayers);
  grid.HubHeight = HubOf(fields, grid, choices.HubHeight);
  grid.Description = "Wind field of Littoral";
  return grid;
}

void CopyPlanes(
  vtkImageData* image, const int whole[6], const InflowGrid& grid, int first, int count, float* velocities)
{
  RequireFit(image, "Input");
  const auto array = WithType<vtkFloatArray>(ArrayReader::OfPoints(image, "The wind").Need("Velocity", 3));
  const int* extent = image->GetExtent();
  const int last = whole[1] - first; // the first time is the last sample along the wind
  const bool isThere = extent[0] <= last - count + 1 && extent[1] >= last && extent[2] <= whole[2] &&
    extent[3] >= whole[3] && extent[4] <= whole[4] && extent[5] >= whole[5];
  Require(isThere ? "" : "the input does not hold the part that was asked of it");
  const double* axes = image->GetDirectionMatrix()->GetData();
  const auto cosine = static_cast<float>(axes[0]);
  const auto sine = static_cast<float>(axes[3]);
  const std::size_t across = static_cast<std::size_t>(extent[3]) - extent[2] + 1;
  const std::size_t along = static_cast<std::size_t>(extent[1]) - extent[0] + 1;
  const auto copy = [&](int time, int j, int k, float* to) {
    const std::size_t line = static_cast<std::size_t>(k - extent[4]) * across + (j - extent[2]);
    const float* from = array->GetPointer(static_cast<vtkIdType>(3 * (line * along + (last - time - extent[0]))));
    to[0] = cosine * from[0] + sine * from[1];
    to[1] = cosine * from[1] - sine * from[0];
    to[2] = from[2];
  };
  const std::size_t points = grid.PointsOfPlane();
  const int bottom = whole[4] + grid.TowerPoints;
  for (int k = whole[4]; k <= whole[5]; ++k)
  {
    for (int j = whole[2]; k >= bottom && j <= whole[3]; ++j)
    {
      const std::size_t point = static_cast<std::size_t>(k - bottom) * grid.Count[1] + (j - whole[2]);
      for (int time = 0; time < count; ++time)
      {
        copy(time, j, k, velocities + 3 * (time * points + point));
      }
    }
    for (int time = 0; k < bottom && time < count; ++time)
    {
      const std::size_t point = grid.PointsOfGrid() + (bottom - 1 - k);
      copy(time, (whole[2] + whole[3]) / 2, k, velocities + 3 * (time * points + point));
    }
  }
}

}
