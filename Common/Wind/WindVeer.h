// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralWindVeer_h
#define LittoralWindVeer_h

#include "Numerics/Parallel.h"
#include "Wind/WindField.h"

namespace littoral
{

/// Direction of the mean wind at a height [m] against that at ReferenceHeight [rad], counterclockwise from above: a
/// wind that veers turns clockwise with height (Kelly and van der Laan 2023).
double VeerAngle(const WindModel& model, double height);

/// Axes between which velocities are turned.
enum class VeerTurn
{
  FromLocal, ///< those along and across the mean wind of each layer, as WindField makes velocities
  ToLocal
};

/// Turns velocities, as WindField::Make gives them, about the vertical by the VeerAngle of their layer. Without Veer
/// they stay to the bit.
void TurnWithHeight(const WindModel& model, const WindGrid& grid, VeerTurn turn, float* velocities,
  const ParallelFor& parallel = SerialFor);

}

#endif
