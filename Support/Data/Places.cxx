// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Places.h"

#include "Numerics/InvalidInput.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"

#include <string>

namespace littoral
{

namespace
{

/// Fewer points have no size to be told by.
constexpr vtkIdType FewestPoints = 3;

/// The name of a point array that has the coordinates along an axis; empty for none.
std::string NameOf(vtkDataSet* data, int axis)
{
  vtkPointData* arrays = data->GetPointData();
  for (int index = 0; index < arrays->GetNumberOfArrays(); ++index)
  {
    vtkDataArray* array = arrays->GetArray(index);
    bool isSame = array && array->GetName() && array->GetNumberOfComponents() == 1 &&
      array->GetNumberOfTuples() == data->GetNumberOfPoints();
    for (const vtkIdType point : { vtkIdType(0), data->GetNumberOfPoints() / 2, data->GetNumberOfPoints() - 1 })
    {
      isSame =
        isSame && static_cast<float>(array->GetComponent(point, 0)) == static_cast<float>(data->GetPoint(point)[axis]);
    }
    if (isSame)
    {
      return array->GetName();
    }
  }
  return {};
}

}

void RequireLengths(vtkDataSet* data, const char* input, double far)
{
  if (data->GetNumberOfPoints() < FewestPoints || data->GetFieldData()->HasArray("CoordinateSystem"))
  {
    return;
  }
  double box[6];
  data->GetBounds(box);
  const PlaceAxis x{ NameOf(data, 0), {}, box[0], box[1] };
  const PlaceAxis y{ NameOf(data, 1), {}, box[2], box[3] };
  if (UnitOfPlaces(x, y, far).Kind != PlaceKind::Lengths)
  {
    Refuse(input, " lies at ", box[0], " to ", box[1], ", ", box[2], " to ", box[3],
      ", which look like degrees: project it to metres, or move it to the origin if it is in metres.");
  }
}

}
