// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralGatheredPoints_h
#define LittoralGatheredPoints_h

#include "WriterRanks.h"

#include "vtkSmartPointer.h"

class vtkPolyData;

namespace littoral
{

/**
 * The points of all ranks on the first one, rank after rank, with the arrays that all of them have and the field data
 * of the first rank that has points. Null on the others, and where no rank has points. Each rank must call this, with
 * null where it has none. Throws InvalidInput or Aborted where there is no memory.
 */
vtkSmartPointer<vtkPolyData> GatherPoints(const WriterRanks& ranks, vtkPolyData* own);

/// Points, each of which is a cell, in the order of the numbers of an array; as they are where there is none.
vtkSmartPointer<vtkPolyData> InOrder(vtkPolyData* points, const char* name);

}

#endif
