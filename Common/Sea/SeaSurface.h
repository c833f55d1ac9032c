// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSeaSurface_h
#define LittoralSeaSurface_h

#include "Numerics/Parallel.h"
#include "Sea/WaveOrbits.h"

#include <cstddef>
#include <string>
#include <vector>

namespace littoral
{

/// A disk of points at rest on the sea whose spacing grows with the distance from the center.
struct SeaSurfaceParameters
{
  double Center[2] = { 0.0, 0.0 }; ///< [m]
  double Radius = 5000.0;          ///< of the disk [m]
  double Spacing = 0.6;            ///< of points near the center [m]
  int Sectors = 360;               ///< points on a ring
};

/// Why there is no such disk, in words for a user; empty if there is one.
std::string WhyInvalid(const SeaSurfaceParameters& parameters);

/**
 * Rings of points around a center. With n sectors, rings are Spacing apart as far as points on a ring are closer than
 * that; further out the distance of rings grows with the radius r as 2 pi r / n, so that cells are square and look
 * equally large from above the center.
 */
class SeaSurfaceGrid
{
public:
  explicit SeaSurfaceGrid(const SeaSurfaceParameters& parameters);
  /// The sectors from first up to end, which does not belong to them. Parts of a disk share the points between them.
  SeaSurfaceGrid(const SeaSurfaceParameters& parameters, int first, int end);

  /// The center, then ring by ring; none in a part without a sector.
  std::size_t GetNumberOfPoints() const { return this->Columns > 0 ? 1 + this->Radii.size() * this->Columns : 0; }
  /// Radii of the rings [m], increasing.
  const std::vector<double>& GetRadii() const { return this->Radii; }

  /// Largest distance between a point and its neighbors [m].
  double SpacingAt(std::size_t point) const;
  /// Position of a point at rest, from the center [m].
  void PlaceAt(std::size_t point, double& x, double& y) const;
  /// Corners of all triangles, counterclockwise from above.
  std::vector<int> MakeTriangles(const Poll& onRing = NoPoll) const;

private:
  std::vector<double> Radii;
  std::vector<double> Spacings; ///< a ring
  int Sectors;                  ///< of the disk
  int First;                    ///< sector of the part
  int Count;                    ///< of its sectors
  int Columns;                  ///< of its points on a ring
  double Innermost;
};

/// Points of a surface, three numbers each but the last.
struct SeaSurfacePoints
{
  std::vector<float> Places;    ///< from (Center, SeaLevel) [m]
  std::vector<float> Normals;   ///< of length 1, upwards
  std::vector<float> Jacobians; ///< stretch of the surface, see SurfaceJacobian
  std::vector<float> Foam;      ///< see FoamOf; empty without a lifetime
  std::vector<float> Ways;      ///< two numbers each, horizontally from the place at rest [m]; as Foam
};

/// Ages [s] of the Jacobians of FoamOf, evenly from 0 to 1.6 lifetimes [s].
std::vector<double> FoamAges(double lifetime);

/**
 * Foam as the squeeze of the water where crests were, as it fades: max over ages a of (1 - J(t - a)) exp(-a / T), from
 * the Jacobians of a particle at FoamAges, with parabolas through three of them.
 */
double FoamOf(const double* jacobians);

/**
 * The surface of a sea at a time [s] at points between begin and end, which are those of the result; choppiness is that
 * of WaveOrbitOptions. A train counts where its waves are at least four spacings long: shorter ones would alias. Foam
 * is there if it has a lifetime [s].
 */
SeaSurfacePoints SurfaceOf(const SeaState& sea, const SeaSurfaceParameters& parameters, const SeaSurfaceGrid& grid,
  double choppiness, double time, std::size_t begin, std::size_t end, double foamLifetime = 0.0);

}

#endif
