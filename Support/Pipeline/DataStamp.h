// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportDataStamp_h
#define LittoralSupportDataStamp_h

// Whether data are those of the last execution, for filters that keep what they made of them. Private: never
// installed, never wrapped.

#include "Data/ArrayStamp.h"

#include <string>
#include <vector>

class vtkDataObject;

namespace littoral
{

/**
 * Arrays of a data object and of all blocks in it, and its numbers and names. A shallow copy has the same stamp:
 * ParaView makes one anew for each consumer that asks for other arrays, so that the time of the data object says
 * nothing.
 */
struct DataStamp
{
  std::vector<ArrayStamp> Arrays;
  std::vector<double> Numbers;
  std::vector<std::string> Names; ///< of blocks
};

inline bool operator==(const DataStamp& a, const DataStamp& b)
{
  return a.Arrays == b.Arrays && a.Numbers == b.Numbers && a.Names == b.Names;
}

/// The stamp of a data object; null is allowed.
DataStamp StampOf(vtkDataObject* data);

}

#endif
