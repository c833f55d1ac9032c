// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/TerrainGrid.h"

#include "Data/ArrayReader.h"
#include "Data/Inputs.h"
#include "Numerics/InvalidInput.h"

#include "vtkImageData.h"
#include "vtkPointData.h"

namespace littoral
{

HeightGrid MakeGrid(vtkImageData* terrain)
{
  int extent[6];
  terrain->GetExtent(extent);
  if (extent[5] != extent[4] || extent[1] <= extent[0] || extent[3] <= extent[2])
  {
    Refuse("the Terrain must be one layer of at least 2 x 2 points.");
  }
  RequireUpright(terrain, "the Terrain");
  const ArrayReader points = ArrayReader::OfPoints(terrain, "the Terrain");
  vtkDataArray* heights =
    points.Has("Elevation") ? points.Find("Elevation", 1) : points.Fit(terrain->GetPointData()->GetScalars(), 1);
  Require(heights ? "" : "the Terrain has neither a point array Elevation nor active scalars.");
  HeightGrid grid;
  for (int axis = 0; axis < 2; ++axis)
  {
    grid.Spacing[axis] = terrain->GetSpacing()[axis];
    grid.Origin[axis] = terrain->GetOrigin()[axis] + extent[2 * axis] * grid.Spacing[axis];
    grid.Count[axis] = extent[2 * axis + 1] - extent[2 * axis] + 1;
    Require(grid.Spacing[axis] > 0.0 ? "" : "the spacing of the Terrain must be positive.");
  }
  grid.HeightOf = [heights](long long point) { return heights->GetComponent(static_cast<vtkIdType>(point), 0); };
  return grid;
}

}
