// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/GroundWetness.h"

#include "Data/ArrayReader.h"
#include "Drainage/GroundWetness.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"

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
  HeightGrid ground;
  for (int axis = 0; axis < 2; ++axis)
  {
    ground.Count[axis] = image->GetDimensions()[axis];
    ground.Spacing[axis] = image->GetSpacing()[axis];
  }
  const auto valueOf = [](vtkDataArray* array) {
    return [array](long long point) { return array->GetComponent(static_cast<vtkIdType>(point), 0); };
  };
  ground.HeightOf = valueOf(heights);
  return SpreadWetness(ground, valueOf(area), parallel);
}

}
