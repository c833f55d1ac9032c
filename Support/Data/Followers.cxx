// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Followers.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/SeaStateTable.h"
#include "Numerics/InvalidInput.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointSet.h"

namespace littoral
{

namespace
{

/// The masters that an array names.
template <typename At>
void ReadMasters(const At& at, Slaves& slaves)
{
  const auto points = static_cast<vtkIdType>(slaves.Master.size());
  for (vtkIdType id = 0; id < points; ++id)
  {
    const auto value = at(id);
    if (!(value < static_cast<decltype(at(id))>(points)))
    {
      Refuse("MasterId of point ", id, " is no point of its data set.");
    }
    slaves.Master[id] = value < 0 || static_cast<vtkIdType>(value) == id ? -1 : static_cast<vtkIdType>(value);
  }
}

}

double Slaves::OffsetAt(vtkIdType id, int axis) const
{
  return this->Offsets    ? this->Offsets[3 * id + axis]
    : this->SingleOffsets ? static_cast<double>(this->SingleOffsets[3 * id + axis])
                          : this->Offset->GetComponent(id, axis);
}

Slaves ReadSlaves(vtkPointSet* input)
{
  Slaves slaves;
  const ArrayReader arrays = ArrayReader::OfPoints(input, "a set of particles");
  vtkDataArray* master = arrays.Find(sea::MasterId, 1);
  slaves.Offset = master ? arrays.Need(sea::Offset, 3) : nullptr;
  if (!master)
  {
    return slaves;
  }
  const vtkIdType points = input->GetNumberOfPoints();
  SetSize(slaves.Master, points);
  auto* doubles = vtkDoubleArray::SafeDownCast(slaves.Offset);
  auto* singles = vtkFloatArray::SafeDownCast(slaves.Offset);
  slaves.Offsets = doubles ? doubles->GetPointer(0) : nullptr;
  slaves.SingleOffsets = singles ? singles->GetPointer(0) : nullptr;
  arrays.NeedFinite(slaves.Offset);
  if (auto* ids = vtkIdTypeArray::SafeDownCast(master))
  {
    const vtkIdType* values = ids->GetPointer(0);
    ReadMasters([values](vtkIdType id) { return values[id]; }, slaves);
  }
  else
  {
    ReadMasters([master](vtkIdType id) { return master->GetComponent(id, 0); }, slaves);
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
