// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Followers.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/SeaStateTable.h"
#include "Numerics/InvalidInput.h"

#include "vtkDataArray.h"
#include "vtkPointSet.h"

namespace littoral
{

Slaves ReadSlaves(vtkPointSet* input)
{
  Slaves slaves;
  const ArrayReader arrays = ArrayReader::OfPoints(input, "a set of particles");
  vtkDataArray* master = arrays.Find(sea::MasterId, 1);
  slaves.Offset = master ? arrays.Need(sea::Offset, 3) : nullptr;
  arrays.NeedFinite(slaves.Offset);
  if (!master)
  {
    return slaves;
  }
  const vtkIdType points = input->GetNumberOfPoints();
  SetSize(slaves.Master, points);
  for (vtkIdType id = 0; id < points; ++id)
  {
    const double value = master->GetComponent(id, 0);
    if (!(value < static_cast<double>(points)))
    {
      Refuse("MasterId of point ", id, " is no point of its data set.");
    }
    slaves.Master[id] = value < 0.0 || static_cast<vtkIdType>(value) == id ? -1 : static_cast<vtkIdType>(value);
  }
  for (vtkIdType id = 0; id < points; ++id)
  {
    const vtkIdType its = slaves.Master[id];
    if (its >= 0 && slaves.Master[its] >= 0)
    {
      Refuse("MasterId of point ", id, " is a slave itself.");
    }
  }
  return slaves;
}

}
