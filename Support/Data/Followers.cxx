// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Followers.h"

#include "Data/ArrayReader.h"
#include "Data/SeaStateTable.h"

#include "vtkDataArray.h"
#include "vtkPointSet.h"

namespace littoral
{

std::string ReadSlaves(vtkPointSet* input, Slaves& slaves)
{
  ArrayReader arrays = ArrayReader::OfPoints(input, "a set of particles");
  vtkDataArray* master = arrays.Find(sea::MasterId, 1);
  slaves.Offset = master ? arrays.Need(sea::Offset, 3) : nullptr;
  arrays.NeedFinite(slaves.Offset);
  if (!master || !arrays.IsGood())
  {
    return arrays.Reason();
  }
  const vtkIdType points = input->GetNumberOfPoints();
  slaves.Master.resize(static_cast<std::size_t>(points));
  for (vtkIdType id = 0; id < points; ++id)
  {
    const double value = master->GetComponent(id, 0);
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
