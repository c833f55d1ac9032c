// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralObservation_h
#define LittoralObservation_h

#include "vtkObject.h"
#include "vtkWeakPointer.h"

#include <vector>

namespace littoral
{

/// An observer of an object, which may be gone.
struct Observation
{
  vtkWeakPointer<vtkObject> Object;
  unsigned long Tag;
};

inline void StopObserving(std::vector<Observation>& observed)
{
  for (const Observation& one : observed)
  {
    if (one.Object)
    {
      one.Object->RemoveObserver(one.Tag);
    }
  }
  observed.clear();
}

}

#endif
