// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralObservationWindow_h
#define LittoralObservationWindow_h

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace littoral
{

/// A point of the plane, x and y [m].
using PlanePosition = std::array<double, 2>;

/**
 * The part of the plane in which a pattern was mapped: a rectangle, or a polygon whose edges meet at its corners only.
 * A polygon of four corners with edges along x and y becomes a rectangle.
 */
class ObservationWindow
{
public:
  /// The unit square.
  ObservationWindow()
    : ObservationWindow(Rectangle({ 0.0, 0.0 }, { 1.0, 1.0 }))
  {
  }

  /// A rectangle between its lower left and its upper right corner.
  static ObservationWindow Rectangle(const PlanePosition& low, const PlanePosition& high);

  /// A polygon by its corners, in either sense of rotation; the last one may repeat the first.
  static ObservationWindow Polygon(std::vector<PlanePosition> corners);

  /// Why this is no window, in words for a user; empty when it is one. What follows is for windows that are.
  std::string WhyInvalid() const;

  bool IsRectangle() const { return this->Rectangular; }
  const PlanePosition& GetLow() const { return this->Low; }   ///< of the bounding box [m]
  const PlanePosition& GetHigh() const { return this->High; } ///< of the bounding box [m]
  /// Corners counterclockwise, each once [m].
  const std::vector<PlanePosition>& GetCorners() const { return this->Corners; }
  double GetArea() const { return this->Area; } ///< [m2]

  /// Whether a point lies in the window or on its edge.
  bool Contains(const PlanePosition& point) const;

  /// Distance of a point in the window to the edge [m].
  double DistanceToEdge(const PlanePosition& point) const;

  /// The part of a circle about a point in the window that lies in the window, 0 to 1; the radius [m] is above 0.
  double CircleInside(const PlanePosition& center, double radius) const;

  /// Set covariance: area of the intersection of the window and the window moved by (dx, dy) [m], [m2].
  double CommonArea(double dx, double dy) const;

private:
  struct Empty
  {
  };
  explicit ObservationWindow(Empty) {}
  bool Surrounds(const PlanePosition& point) const;
  void Measure();

  std::vector<PlanePosition> Corners;
  PlanePosition Low{ 0.0, 0.0 };
  PlanePosition High{ 0.0, 0.0 };
  double Area = 0.0;
  bool Rectangular = false;
};

/// Fewer points say nothing about a pattern.
inline constexpr std::size_t FewestPatternPoints = 5;

/// Why points are no pattern in a window, in words for a user: fewer than `minimum`, one outside or not finite, two at
/// one place unless they may be. Empty when they are one.
std::string WhyInvalid(const std::vector<PlanePosition>& points, const ObservationWindow& window,
  std::size_t minimum = FewestPatternPoints, bool mayCoincide = false);

}

#endif
