// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/GivenLines.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/Cells.h"
#include "Numerics/InvalidInput.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <array>
#include <vector>

namespace littoral
{

namespace
{

/// Place of a point from the first one of an image, along its rows and columns [m].
std::array<double, 2> PlaceIn(vtkImageData* image, const std::array<double, 3>& point)
{
  std::array<double, 3> index{};
  image->TransformPhysicalPointToContinuousIndex(point.data(), index.data());
  const int* extent = image->GetExtent();
  const double* spacing = image->GetSpacing();
  return { (index[0] - extent[0]) * spacing[0], (index[1] - extent[2]) * spacing[1] };
}

/// Places of all lines, those of a point that several have once for each.
vtkIdType PlacesOfLines(vtkPolyData* data)
{
  return data->GetLines()->GetNumberOfConnectivityIds();
}

}

GivenGround ReadGiven(vtkPolyData* data, vtkImageData* image, const char* heights, bool usesLineHeights)
{
  RequireCells(data, "Given");
  Require(data->GetNumberOfPolys() > 0 || data->GetNumberOfStrips() > 0
      ? "Given has polygons; only lines and points can be rivers, ridges and heights."
      : "");
  Require(data->GetNumberOfPoints() > 0 ? "" : "Given has no points.");
  vtkDataArray* values = heights ? ArrayReader::OfPoints(data, "Given").Find(heights, 1) : nullptr;
  vtkDataArray* ridges = ArrayReader::OfCells(data, "Given").Find("Ridge", 1);
  ArrayReader::OfCells(data, "Given").NeedFinite(ridges);
  std::vector<char> isOfLine;
  SetSize(isOfLine, data->GetNumberOfPoints());
  const auto heightAt = [&](vtkIdType id) {
    std::array<double, 3> point{};
    data->GetPoint(id, point.data());
    return GivenHeight{ PlaceIn(image, point), values ? values->GetComponent(id, 0) : point[2] };
  };
  GivenGround given;
  vtkNew<vtkIdList> ids;
  for (vtkIdType row = 0; row < data->GetNumberOfLines(); ++row)
  {
    data->GetLines()->GetCellAtId(row, ids);
    GivenLine line;
    for (const vtkIdType id : *ids)
    {
      const GivenHeight point = heightAt(id);
      line.Places.push_back(point.Place);
      line.Heights.resize(usesLineHeights ? line.Places.size() : 0, point.Height);
      isOfLine[id] = 1;
    }
    // cells of polygonal data count vertices first
    const bool isRidge = ridges && ridges->GetComponent(data->GetNumberOfVerts() + row, 0) != 0.0;
    (isRidge ? given.Ridges : given.Rivers).push_back(line);
  }
  for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id)
  {
    if (!isOfLine[id])
    {
      given.Heights.push_back(heightAt(id));
    }
  }
  return given;
}

double MemoryOfGiven(vtkPolyData* data)
{
  // a place and a height in each of the copies of the terrain, of the grid with margins, of a level and of a part
  constexpr double bytesOfPoint = 400.0;
  return bytesOfPoint * (static_cast<double>(data->GetNumberOfPoints()) + static_cast<double>(PlacesOfLines(data)));
}

}
