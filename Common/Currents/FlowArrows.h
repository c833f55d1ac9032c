// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFlowArrows_h
#define LittoralFlowArrows_h

#include "Currents/FlowPrimitives.h"

#include <vector>

namespace littoral
{

/// An arrow along the velocity at its middle.
struct FlowArrow
{
  Vector3 Tail; ///< [m]
  Vector3 Arm;  ///< from the tail to the tip [m]
  double Speed; ///< [m/s]
};

/// A circle that shows a radius of a flow.
struct FlowRing
{
  Vector3 Center; ///< [m]
  Vector3 Normal; ///< of length 1
  double Radius;  ///< [m]
};

/// The radius of the drawing of a primitive [m]: its influence radius, else four core radii; 2 m of a uniform flow.
double DrawingRadius(const FlowPrimitive& primitive);

/**
 * Arrows of the velocity of a primitive within its drawing radius: in a cross section of a uniform flow, along radii of
 * a source or sink, around the axis of a vortex. The longest has a third of the drawing radius, others in proportion to
 * their speed; those shorter than a twentieth of it are left out.
 */
std::vector<FlowArrow> ArrowsOf(const FlowPrimitive& primitive);

/// Samples of a velocity field.
struct FlowSample
{
  Vector3 Place;    ///< [m]
  Vector3 Velocity; ///< [m/s]
};

/**
 * Arrows at samples of a velocity field: plan view is divided into square cells, so many along its longer side, and in
 * each the highest of the samples that are nearest to its middle gets an arrow about it. The fastest one is as long as
 * a cell, others in proportion; those shorter than a twentieth of it are left out.
 */
std::vector<FlowArrow> ArrowsAt(const std::vector<FlowSample>& samples, int cellsAlong);

/// Circles with the core radius and the influence radius of a primitive, where it has them: three about the center, of
/// a vortex one about its axis.
std::vector<FlowRing> RingsOf(const FlowPrimitive& primitive);

}

#endif
