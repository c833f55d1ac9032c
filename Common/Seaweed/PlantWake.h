// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPlantWake_h
#define LittoralPlantWake_h

#include "Currents/FlowPrimitives.h"
#include "Geometry/ViewFrustum.h"

#include <string>
#include <vector>

namespace littoral
{

/// Flows by which a plant that moves stirs the water.
enum class WakeKind
{
  Source = 0,  ///< a source at the center of gravity (Coulais et al., section 4.3.4)
  Doublet = 1, ///< a source ahead of it and a sink behind, as a body makes that moves
};

struct WakeOptions
{
  WakeKind Kind = WakeKind::Source;
  double Strength = 0.5;  ///< Source: discharge for an acceleration [m2 s]; Doublet: factor, 1 for a solid body
  double Margin = 0.5;    ///< distance from the plant's bounding box at which the wake has ended [m]
  double CoreShare = 0.2; ///< core of the primitives, as part of half the diagonal of that box
};

/// Why there are no such options, with the name of the property; empty when there are.
std::string WhyInvalid(const WakeOptions& options);

/// A plant as a whole.
struct MovingPlant
{
  Vector3 Center{ 0.0 };       ///< of gravity [m]
  Vector3 Velocity{ 0.0 };     ///< of that [m/s]
  Vector3 Acceleration{ 0.0 }; ///< of that [m/s2]
  double Volume = 0.0;         ///< [m3]
  Box Bounds;                  ///< [m]
};

/// A point of a plant with its share of the volume [m3].
struct MovingPoint
{
  Vector3 Place{ 0.0 };
  Vector3 Velocity{ 0.0 };
  Vector3 Acceleration{ 0.0 };
  double Volume = 0.0;
  double Weight = 0.0; ///< weight of the point in the center of gravity [kg]
};

/// Plant of points, at least one.
MovingPlant PlantOf(const std::vector<MovingPoint>& points);

/**
 * The primitives of a plant, always as many: one source, whose strength is the acceleration along the way of the center
 * of gravity, positive as the plant gets faster; or a source and a sink (of negative strength, so that it captures
 * nothing) for the doublet 2 pi R^3 v of a sphere of the plant's volume. They are whole within the plant's bounding
 * box.
 */
std::vector<FlowPrimitive> WakeOf(const MovingPlant& plant, const WakeOptions& options);

}

#endif
