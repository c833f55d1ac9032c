// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Cells.h"

#include "Data/ArraySearch.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

namespace littoral
{

namespace
{

std::string WhyBadCells(vtkCellArray* cells, vtkIdType points, const std::string& owner)
{
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return {};
  }
  if (!cells->IsValid())
  {
    return owner + " has cells whose offsets are not increasing.";
  }
  vtkDataArray* ids = cells->GetConnectivityArray();
  const vtkIdType corner = FirstOutside(ids, IsWithin{ 0.0, static_cast<double>(points) });
  return corner < 0 ? std::string()
                    : owner + " has a cell with point " +
      std::to_string(static_cast<vtkIdType>(ids->GetComponent(corner, 0))) + ", but " + std::to_string(points) +
      " points.";
}

}

std::string WhyBadCells(vtkDataSet* data, const std::string& owner)
{
  std::string reason;
  const auto look = [&](vtkCellArray* cells) {
    reason = reason.empty() ? WhyBadCells(cells, data->GetNumberOfPoints(), owner) : reason;
  };
  if (auto* polygons = vtkPolyData::SafeDownCast(data))
  {
    look(polygons->GetVerts());
    look(polygons->GetLines());
    look(polygons->GetPolys());
    look(polygons->GetStrips());
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    look(grid->GetCells());
  }
  return reason;
}

}
