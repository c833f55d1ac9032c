// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/GroundWetness.h"

#include "Data/ArrayReader.h"
#include "Drainage/GroundWetness.h"
#include "Terrain/GridSamples.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"

#include <cmath>

namespace littoral
{

namespace
{

constexpr const char* Area = "DrainageArea";

}

//----------------------------------------------------------------------------
void RequireColorable(vtkImageData* image, const std::string& owner)
{
  const ArrayReader points = ArrayReader::OfPoints(image, owner);
  points.NeedFinite(points.Find("Reflectance", 1));
  vtkDataArray* area = points.Find(Area, 1);
  double least = 1.0;
  for (vtkIdType point = 0; area && point < area->GetNumberOfTuples(); ++point)
  {
    const double own = area->GetComponent(point, 0);
    least = std::isnan(own) ? least : std::isfinite(own) ? std::fmin(least, own) : 0.0; // NaN: outside
  }
  Require(least > 0.0 ? "" : "DrainageArea of " + owner + " must be positive everywhere.");
}

//----------------------------------------------------------------------------
std::vector<double> SpreadWetness(vtkImageData* image, vtkDataArray* heights, const ParallelFor& parallel)
{
  vtkDataArray* area = ArrayReader::OfPoints(image, "The image").Seek(Area, 1);
  if (!area)
  {
    return {};
  }
  HeightGrid ground;
  for (int axis = 0; axis < 2; ++axis)
  {
    ground.Count[axis] = image->GetDimensions()[axis];
    ground.Spacing[axis] = image->GetSpacing()[axis];
  }
  // What is outside is as dry as its own cell, on ground that goes on smoothly.
  GridSamples filled{ ground.Count[0], ground.Count[1], { ground.Spacing[0], ground.Spacing[1] }, {} };
  for (vtkIdType point = 0; point < heights->GetNumberOfTuples(); ++point)
  {
    filled.Values.push_back(heights->GetComponent(point, 0));
  }
  FillHoles(filled);
  const double cell = ground.Spacing[0] * ground.Spacing[1];
  ground.HeightOf = [&](long long point) { return filled.Values[static_cast<std::size_t>(point)]; };
  const auto areaOf = [&](long long point) {
    const double own = area->GetComponent(static_cast<vtkIdType>(point), 0);
    return std::isnan(own) ? cell : own;
  };
  return SpreadWetness(ground, areaOf, parallel);
}

}
