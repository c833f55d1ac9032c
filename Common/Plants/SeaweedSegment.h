// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSeaweedSegment_h
#define LittoralSeaweedSegment_h

#include "Numerics/Constants.h"
#include "Plants/Skeleton.h"

#include <string>
#include <vector>

namespace littoral
{

/// Tissues of segments of a seaweed.
enum class SeaweedTissue
{
  Stipe = 0,    ///< round
  Blade = 1,    ///< flat
  Float = 2,    ///< a gas bladder
  Holdfast = 3, ///< grown to the ground: never moves
};

/**
 * Material and section of a segment of a seaweed, from a node of the skeleton to the next of its branch. Its section is
 * an ellipse: a circle for stipes and floats, a lens for blades. Material and sizes only, so that a seaweed grown to
 * another scale has the mass and the stiffness of its size.
 */
struct SeaweedSegment
{
  SeaweedTissue Tissue = SeaweedTissue::Stipe;
  double Width = 0.01;        ///< of the section, at its middle [m]
  double Thickness = 0.01;    ///< [m], at most Width
  double YoungModulus = 1e7;  ///< [Pa]
  double DampingRatio = 0.05; ///< of the tissue alone, of critical
  double Density = 1000.0;    ///< gas included [kg/m3]
  Vector3 Across{ 1, 0, 0 };  ///< unit vector along the width, at a right angle to the segment
};

/// Area of the section [m2].
inline double SectionArea(const SeaweedSegment& segment)
{
  return 0.25 * Pi * segment.Width * segment.Thickness;
}

/// Second moment of area about the width, the way in which the segment bends [m4].
inline double SecondMoment(const SeaweedSegment& segment)
{
  const double t = segment.Thickness;
  return Pi / 64.0 * segment.Width * t * t * t;
}

/// Mass of a segment of a length [m], without added mass [kg].
inline double SegmentMass(const SeaweedSegment& segment, double length)
{
  return segment.Density * SectionArea(segment) * length;
}

/// Rotational stiffness of the joint at the foot of a segment of a length [m]: that of the beam, E I / L [N m/rad].
inline double JointStiffness(const SeaweedSegment& segment, double length)
{
  return segment.YoungModulus * SecondMoment(segment) / length;
}

/// Force of buoyancy less weight, upward where positive [N].
inline double NetBuoyancy(const SeaweedSegment& segment, double length, double waterDensity)
{
  return (waterDensity - segment.Density) * Gravity * SectionArea(segment) * length;
}

/// The radius of the circle of the section's area, which a skeleton keeps [m].
double EquivalentRadius(const SeaweedSegment& segment);

/// Why there is no such segment, with the name of the array that holds the number; empty when there is.
std::string WhyInvalid(const SeaweedSegment& segment);

}

#endif
