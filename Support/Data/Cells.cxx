// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Cells.h"

#include "Data/ArraySearch.h"
#include "Numerics/InvalidInput.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

namespace littoral
{

namespace
{

void RequireCells(vtkCellArray* cells, vtkIdType points, const std::string& owner)
{
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return;
  }
  Require(cells->IsValid() ? "" : owner + " has cells whose offsets are not increasing.");
  vtkDataArray* ids = cells->GetConnectivityArray();
  const vtkIdType corner = FirstOutside(ids, IsWithin{ 0.0, static_cast<double>(points) });
  if (corner >= 0)
  {
    Refuse(owner, " has a cell with point ", static_cast<vtkIdType>(ids->GetComponent(corner, 0)), ", but ", points,
      " points.");
  }
}

}

void RequireCells(vtkDataSet* data, const std::string& owner)
{
  const auto look = [&](vtkCellArray* cells) { RequireCells(cells, data->GetNumberOfPoints(), owner); };
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
}

}
