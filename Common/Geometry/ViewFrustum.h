// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralViewFrustum_h
#define LittoralViewFrustum_h

#include "Numerics/Vector3.h"

#include <limits>
#include <string>
#include <vector>

namespace littoral
{

/// A view of a scene, as of a camera: in perspective, or in parallel projection. Direction and Up need no unit length.
struct View
{
  Vector3 Point{ 0.0, 0.0, 0.0 };                       ///< [m]
  Vector3 Direction{ 0.0, 1.0, 0.0 };                   ///< towards what is looked at
  Vector3 Up{ 0.0, 0.0, 1.0 };                          ///< not along Direction
  double Angle = 0.5235987755982988;                    ///< vertical, full [rad], 0 to pi, both excluded
  bool IsParallel = false;                              ///< rays along Direction, from the plane of Point
  double ParallelScale = 1.0;                           ///< half the height of a parallel picture [m], positive
  double AspectRatio = 1.0;                             ///< width / height of the picture, positive
  double Height = 1080.0;                               ///< of the picture [pixels], positive
  double DetailFactor = 1.0;                            ///< inverse factor of the distances of levels, above 0 to 1
  double Near = 0.0;                                    ///< [m], not negative
  double Far = std::numeric_limits<double>::infinity(); ///< [m], above Near
  double Margin = 0.0;                                  ///< widening of the volume on all sides [m]
  double AngleMargin = 0.0; ///< turn of the view that is allowed for; no near and far planes then [rad]
};

/// Whether two views show the same picture.
bool AreTheSame(const View& a, const View& b);

/**
 * The view that stands for all views near it: point and directions rounded to a grid of a length [m] and an angle
 * [rad], and the volume widened so that it holds the volume of the view itself. What is chosen with it changes only
 * when the view has moved by a step, yet depends on nothing but the view. A step of 0 keeps that part as it is. The
 * length is divided by the view's DetailFactor: coarser levels may change at larger steps. The view must be valid.
 */
View Rounded(const View& view, double lengthStep, double angleStep);

/// Why this is no view, in words for a user; empty when it is one.
std::string WhyInvalid(const View& view);

/// The distance by which levels of detail go [m]: that of a place from the eye. In a parallel projection all is as
/// large as in a perspective of the same angle at one distance, which stands for that of any place. A DetailFactor f
/// makes it 1/f times as long.
double LevelDistance(const View& view, const Vector3& place);

/// Length of the path of light from a place through the scene [m]: to the eye, or to the plane of the eye in a parallel
/// projection.
double SightDistance(const View& view, const Vector3& place);

/// A box with its sides along the axes: smallest and largest x, y, z [m].
struct Box
{
  Vector3 Low{ 0.0, 0.0, 0.0 };
  Vector3 High{ 0.0, 0.0, 0.0 };
};

/// The smallest distance of a point from a box [m]; 0 inside.
double Distance(const Box& box, const Vector3& point);

/// The smallest sight distance of a place in a box [m].
double SightDistance(const View& view, const Box& box);

/// A bound of the largest sight distance of a place in a box [m].
double FarthestSight(const View& view, const Box& box);

/// Bounds of distances [m].
struct Distances
{
  double Least;
  double Most;
};

/// Bounds of the distances by which levels of detail go, of all places in a box.
Distances LevelDistances(const View& view, const Box& box);

/**
 * The volume that a valid view shows: four sides, through the view point or parallel, a near plane, and a far plane if
 * Far is finite.
 *
 * Tests are conservative: what is touched is never rejected. A box or sphere beyond one of the planes is rejected. One
 * that is beyond none of them, yet outside near an edge of the volume, is kept.
 */
class ViewFrustum
{
public:
  /// Points with Normal . x + Offset >= 0 are inside; the normal has unit length.
  struct Plane
  {
    Vector3 Normal;
    double Offset;
  };

  explicit ViewFrustum(const View& view);

  const View& GetView() const { return this->Seen; }

  /// Left, right, bottom, top, near and, if there is one, far.
  const std::vector<Plane>& GetPlanes() const { return this->Planes; }

  bool MayShow(const Box& box) const;
  bool MayShow(const Vector3& center, double radius) const;

  /// Whether all of a box is inside, by a distance [m] at least.
  bool Holds(const Box& box, double distance) const;

  /**
   * Bound of the distance on the screen [pixels] of two places of a box, one straight above the other by at most a rise
   * [m], if either is on the picture, for any view within the margins; infinite where one may be at the eye.
   *
   * In units of the picture's distance, places p and q = p + u z at depths p_d and q_d are |a x (z x p)| u / (p_d q_d)
   * apart, for a view along a from the origin. What is above u / d off the axis of a perspective, up to 1 / cos^2 of
   * the angle from it, is in the first factor.
   */
  double PixelsOfRise(double rise, const Box& box) const;

private:
  void AddPlane(const Vector3& normal, double distance);
  void AddPerspectiveSides();
  void AddParallelSides();

  View Seen;
  Vector3 Ahead;
  Vector3 Right;
  Vector3 Up;
  double Tangents[2] = { 0.0, 0.0 }; ///< of half the angles across and up
  std::vector<Plane> Planes;
};

}

#endif
