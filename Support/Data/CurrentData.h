// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportCurrentData_h
#define LittoralSupportCurrentData_h

// A current at one moment between VTK's data and the numerics. Private: never installed, never wrapped.

#include "Currents/ColumnVelocity.h"
#include "Currents/CurrentSnapshot.h"
#include "Currents/FlowArrows.h"

#include "vtkDataObject.h"

#include <string>
#include <vector>

class vtkDataSet;

namespace littoral
{

/// Interpolation of velocities between the samples of images and rectilinear grids.
enum class VelocityInterpolation
{
  Linear,
  CubicSpline, ///< see VelocitySpline
};

/**
 * Reads all that flows in a data object, or in the leaves of a composite one: flow primitives, and data sets with a
 * point array of velocities, with the name `array`; empty: `Velocity`, or the only array of three components. Where
 * values are no numbers, as ocean models have on land, the water is at rest. Points in upright columns, with the field
 * data `Layers`, are interpolated by ColumnVelocity, beside whose land a current behaves as said. Arrays are shared
 * with the data set; splines have coefficients of their own, three a sample. Throws InvalidInput.
 */
CurrentSnapshot ReadCurrent(vtkDataObject* data, const std::string& array, const WaterLayer& layer,
  VelocityInterpolation interpolation, CoastBehaviour coast = CoastBehaviour::Stop);

/// Samples of the velocities of a data set that is no flow primitive, of water alone. Throws InvalidInput.
std::vector<FlowSample> ReadSamples(vtkDataSet* data, const std::string& array);

}

#endif
