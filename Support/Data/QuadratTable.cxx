// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/QuadratTable.h"

#include "Data/ArrayReader.h"
#include "Numerics/ParameterCheck.h"

#include "vtkDataArray.h"
#include "vtkTable.h"

#include <cmath>

namespace littoral
{

void ReadQuadratFit(vtkTable* table, QuadratLawParameters& law, QuadratGrid& grid)
{
  const ArrayReader rows = ArrayReader::OfRows(table, "the table of fits");
  if (table->GetNumberOfRows() == 0 || !rows.Has("LawId"))
  {
    Refuse("the table of fits has no row with a LawId; connect the first output of a quadrat analysis.");
  }
  vtkDataArray* ids = rows.Need("LawId", 1);
  ReadWhole("LawId", ids->GetComponent(0, 0), 0, NumberOfQuadratLaws - 1, law.Law);
  ParameterCheck check;
  for (const auto* parameter : AllQuadratLawParameters())
  {
    vtkDataArray* column = rows.Find(parameter->Name, 1);
    const double number = column ? column->GetComponent(0, 0) : std::nan("");
    if (std::isfinite(number)) // NaN: the law has no such parameter
    {
      check.Within(parameter->Name, number, parameter->Allowed, parameter->Unit);
      check.Range(parameter->Name, number, -VTK_INT_MAX, VTK_INT_MAX); // some are whole
    }
    if (std::isfinite(number) && check.IsGood())
    {
      parameter->Set(law, number);
    }
  }
  Require(check.Reason());
  const ArrayReader fields = ArrayReader::OfFields(table, "the table of fits", 1);
  vtkDataArray* origin = fields.Find("Origin", 2);
  vtkDataArray* size = fields.Find("Size", 2);
  vtkDataArray* quadrats = fields.Find("Quadrats", 2);
  for (int axis = 0; axis < 2; ++axis)
  {
    grid.Origin[axis] = origin ? origin->GetComponent(0, axis) : grid.Origin[axis];
    grid.Size[axis] = size ? size->GetComponent(0, axis) : grid.Size[axis];
    if (quadrats)
    {
      ReadWhole("Quadrats", quadrats->GetComponent(0, axis), 1, VTK_INT_MAX, grid.Count[axis]);
    }
  }
}

}
