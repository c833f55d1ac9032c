// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Followers.h"

#include "Data/SeaStateTable.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

namespace littoral
{

std::string ReadSlaves(vtkPointSet* input, Slaves& slaves)
{
  vtkDataArray* master = input->GetPointData()->GetArray(sea::MasterId);
  if (!master)
  {
    return "";
  }
  slaves.Offset = input->GetPointData()->GetArray(sea::Offset);
  if (master->GetNumberOfComponents() != 1)
  {
    return "the point array MasterId must have one component.";
  }
  if (!slaves.Offset || slaves.Offset->GetNumberOfComponents() != 3)
  {
    return "the point array MasterId needs an array Offset of three components beside it.";
  }
  const vtkIdType points = input->GetNumberOfPoints();
  slaves.Master.resize(static_cast<std::size_t>(points));
  for (vtkIdType id = 0; id < points; ++id)
  {
    const double value = master->GetTuple1(id);
    if (!(value < static_cast<double>(points)))
    {
      return "MasterId of point " + std::to_string(id) + " is no point of its data set.";
    }
    slaves.Master[id] = value < 0.0 || static_cast<vtkIdType>(value) == id ? -1 : static_cast<vtkIdType>(value);
  }
  for (vtkIdType id = 0; id < points; ++id)
  {
    const vtkIdType its = slaves.Master[id];
    if (its >= 0 && slaves.Master[its] >= 0)
    {
      return "MasterId of point " + std::to_string(id) + " is a slave itself.";
    }
  }
  return "";
}

}
