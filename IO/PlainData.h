// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPlainData_h
#define LittoralPlainData_h

// Data as VTK's messages between ranks can carry them. Private: never installed.

#include "vtkSmartPointer.h"

class vtkFieldData;
class vtkMultiBlockDataSet;
class vtkPolyData;

namespace littoral
{

/// The same numbers and texts without the information of their arrays, whose keys the reader of a message warns of.
/// They share the memory of the data, which must stay.
vtkSmartPointer<vtkPolyData> PlainFields(vtkFieldData* fields);
vtkSmartPointer<vtkPolyData> PlainData(vtkPolyData* data);
vtkSmartPointer<vtkMultiBlockDataSet> PlainData(vtkMultiBlockDataSet* blocks);

}

#endif
