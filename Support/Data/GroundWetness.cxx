// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/GroundWetness.h"

#include "Data/ArrayReader.h"
#include "Drainage/ValleySpreading.h"
#include "Plants/SitePreference.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr const char* Area = "DrainageArea";

/// Standard deviation of the ground that a stream wets [cells].
constexpr double WetCells = 2.0;

/// Heights of an image of one layer, and slopes of the ground between them.
class SlopeReader
{
public:
  SlopeReader(vtkImageData* image, vtkDataArray* heights)
    : Heights(heights)
    , Size{ image->GetDimensions()[0], image->GetDimensions()[1] }
    , Spacing{ image->GetSpacing()[0], image->GetSpacing()[1] }
  {
  }

  /// From level ground [rad]; 0 beside holes.
  double At(int i, int j) const
  {
    const double x = this->Difference(i, j, 0);
    const double y = this->Difference(i, j, 1);
    const double slope = std::atan(std::hypot(x, y));
    return std::isfinite(slope) ? slope : 0.0;
  }

private:
  /// Of neighbours along an axis, central within the image [m/m].
  double Difference(int i, int j, int axis) const
  {
    int low[2] = { i, j };
    int high[2] = { i, j };
    low[axis] = std::max(0, low[axis] - 1);
    high[axis] = std::min(this->Size[axis] - 1, high[axis] + 1);
    const int steps = std::max(1, high[axis] - low[axis]);
    return (this->HeightAt(high) - this->HeightAt(low)) / (steps * this->Spacing[axis]);
  }

  double HeightAt(const int (&at)[2]) const
  {
    return this->Heights->GetComponent(at[1] * static_cast<vtkIdType>(this->Size[0]) + at[0], 0);
  }

  vtkDataArray* Heights;
  int Size[2];
  double Spacing[2];
};

}

//----------------------------------------------------------------------------
void RequireColorable(vtkImageData* image, const std::string& owner)
{
  const ArrayReader points = ArrayReader::OfPoints(image, owner);
  points.NeedFinite(points.Find("Reflectance", 1));
  vtkDataArray* area = points.Find(Area, 1);
  points.NeedFinite(area);
  double range[2] = { 1.0, 1.0 };
  if (area && area->GetNumberOfTuples() > 0)
  {
    area->GetRange(range);
  }
  Require(range[0] > 0.0 ? "" : "DrainageArea of " + owner + " must be positive everywhere.");
}

//----------------------------------------------------------------------------
std::vector<double> SpreadWetness(vtkImageData* image, vtkDataArray* heights, const ParallelFor& parallel)
{
  vtkDataArray* area = ArrayReader::OfPoints(image, "The image").Seek(Area, 1);
  if (!area)
  {
    return {};
  }
  const SlopeReader slopes(image, heights);
  const int width = image->GetDimensions()[0];
  const int height = image->GetDimensions()[1];
  const double cell = std::sqrt(image->GetSpacing()[0] * image->GetSpacing()[1]);
  std::vector<double> wetness(static_cast<std::size_t>(width) * height);
  parallel(height, [&](std::size_t begin, std::size_t end) {
    for (int j = static_cast<int>(begin); j < static_cast<int>(end); ++j)
    {
      for (int i = 0; i < width; ++i)
      {
        const vtkIdType point = static_cast<vtkIdType>(j) * width + i;
        wetness[point] = WetnessOf(area->GetComponent(point, 0), cell, slopes.At(i, j));
      }
    }
  });
  SmoothGrid(wetness, width, height, WetCells, parallel);
  return wetness;
}

}
