// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportLastChange_h
#define LittoralSupportLastChange_h

// Whether data are those of the last execution, for filters that keep what they made of them. Private: never
// installed, never wrapped.

#include "vtkType.h"

#include <utility>

class vtkDataObject;

namespace littoral
{

/// The latest modification time of a data object, its field data, and all blocks and partitions in it.
vtkMTimeType LastChange(vtkDataObject* data);

/// Address and last change of a data object. Modification times never repeat: equal stamps mean the same data.
using DataStamp = std::pair<const void*, vtkMTimeType>;

/// The stamp of a data object; null is allowed.
DataStamp StampOf(vtkDataObject* data);

}

#endif
