// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportFlowPrimitiveData_h
#define LittoralSupportFlowPrimitiveData_h

// Flow primitives between the numerics and VTK. Private: never installed, never wrapped.

#include "Currents/FlowPrimitives.h"

#include <string>
#include <vector>

class vtkDataSet;
class vtkPolyData;

namespace littoral
{

/// A vertex a primitive, with its arrays.
void WriteFlowPrimitives(const std::vector<FlowPrimitive>& primitives, vtkPolyData* data);

/// Whether a data set holds flow primitives, and no field of velocities.
bool HoldsFlowPrimitives(vtkDataSet* data);

/// Adds the primitives of a data set. The arrays of the influence box may both be missing. Throws InvalidInput.
void ReadFlowPrimitives(vtkDataSet* data, std::vector<FlowPrimitive>& primitives);

}

#endif
