// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLinkState_h
#define LittoralLinkState_h

#include "Numerics/Rotation.h"

namespace littoral
{

// The state of a link at a moment (Real = double), or of links side by side, a lane each (Real = SimdDoubles).

/// The water at the middle of a segment.
template <typename Real>
struct WaterOf
{
  using Vector = glm::vec<3, Real>;
  Vector Velocity{ Real(0.0) };     ///< of waves and current [m/s]
  Vector Acceleration{ Real(0.0) }; ///< of the water, following it: of waves and by their gradient [m/s2]
  Vector Displacement{ Real(0.0) }; ///< displacement by the waves [m]; of Direct loads in procedural motion only
};

/// The state of a joint: its shape and how fast it changes.
template <typename Real>
struct LinkStateOf
{
  using Vector = glm::vec<3, Real>;
  Vector Shape{ Real(0.0), Real(0.0), Real(1.0) }; ///< Bending: the segment's direction, as if its parent were at rest;
                                                   ///< else theta, phi
  Vector Rate{ Real(0.0) }; ///< Bending: of turning against the parent, in the same frame; else of the angles
};

/// Position and velocity of a link.
template <typename Real>
struct LinkPoseOf
{
  using Vector = glm::vec<3, Real>;
  glm::qua<Real> Rotation{ Real(1.0), Real(0.0), Real(0.0), Real(0.0) }; ///< from rest
  Vector Foot{ Real(0.0) };                                              ///< [m]
  Vector Axis{ Real(0.0), Real(0.0), Real(1.0) };
  Vector Velocity{ Real(0.0) }; ///< of the foot [m/s]
  Vector Spin{ Real(0.0) };     ///< [rad/s]
};

using WaterAtLink = WaterOf<double>;
using LinkState = LinkStateOf<double>;
using LinkPose = LinkPoseOf<double>;

}

#endif
