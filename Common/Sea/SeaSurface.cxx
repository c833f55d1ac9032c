// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sea/SeaSurface.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"

#include <algorithm>
#include <cmath>

namespace littoral
{
namespace
{

/// Points a wave must have at least to count.
constexpr double PointsPerWave = 4.0;
constexpr double MostPoints = 5e7;
/// Step between ages of foam, in lifetimes.
constexpr double AgeStep = 1.6 / (MostAges - 1);

/// Trains, the longest waves first.
SeaState LongestFirst(SeaState sea)
{
  std::stable_sort(sea.Trains.begin(), sea.Trains.end(),
    [](const WaveTrain& a, const WaveTrain& b) { return a.WaveNumber < b.WaveNumber; });
  return sea;
}

/// The sea as seen from a center at its level, for single precision: phi = k d . (x - c) - w t + (phase + k d . c).
SeaState FromCenter(SeaState sea, const double center[2])
{
  for (WaveTrain& train : sea.Trains)
  {
    train.Phase += train.WaveNumber * (std::cos(train.Direction) * center[0] + std::sin(train.Direction) * center[1]);
  }
  sea.SeaLevel = 0.0;
  return sea;
}

/// Foam of a particle by the gradients of its past (OrbitRequest).
double FoamLeft(const float* gradients)
{
  double jacobians[MostAges] = {};
  for (int age = 0; age < MostAges; ++age)
  {
    double gradient[3];
    std::copy_n(gradients + 3 * age, 3, gradient);
    jacobians[age] = SurfaceJacobian(gradient);
  }
  return FoamOf(jacobians);
}

/// Number of trains of a sea, the longest first, with waves of at least four spacings.
int TrainsResolved(const SeaState& longestFirst, double spacing)
{
  const double limit = TwoPi / (PointsPerWave * spacing); // k <= 2 pi / (4 s)
  const auto end = std::upper_bound(longestFirst.Trains.begin(), longestFirst.Trains.end(), limit,
    [](double k, const WaveTrain& train) { return k < train.WaveNumber; });
  return static_cast<int>(end - longestFirst.Trains.begin());
}

}

std::string WhyInvalid(const SeaSurfaceParameters& parameters)
{
  ParameterCheck check;
  check.Finite("Center[0]", parameters.Center[0], "m");
  check.Finite("Center[1]", parameters.Center[1], "m");
  check.Range("Radius", parameters.Radius, 1.0, 1e6, "m");
  check.Range("Spacing", parameters.Spacing, 1e-3, parameters.Radius, "m");
  check.Range("Sectors", parameters.Sectors, 8, 10000);
  if (!check.Reason().empty())
  {
    return check.Reason();
  }
  // Rings of even spacing up to r = n s / 2 pi, then of growing spacing.
  const double even = std::min(parameters.Radius, parameters.Sectors * parameters.Spacing / TwoPi);
  const double rings =
    even / parameters.Spacing + std::log(parameters.Radius / even) / std::log1p(TwoPi / parameters.Sectors);
  check.Require(rings * parameters.Sectors <= MostPoints, "Spacing and Sectors give more than 5e7 points.");
  return check.Reason();
}

SeaSurfaceGrid::SeaSurfaceGrid(const SeaSurfaceParameters& parameters)
  : SeaSurfaceGrid(parameters, 0, parameters.Sectors)
{
}

SeaSurfaceGrid::SeaSurfaceGrid(const SeaSurfaceParameters& parameters, int first, int end)
  : Sectors(parameters.Sectors)
  , First(first)
  , Count(end - first)
  // A ring that does not close ends with the next part's first point.
  , Columns(this->Count > 0 && this->Count < this->Sectors ? this->Count + 1 : this->Count)
  , Innermost(parameters.Spacing)
{
  double radius = 0.0;
  while (radius < parameters.Radius)
  {
    // r' = r + max(s, 2 pi r / n)
    const double spacing = std::max(parameters.Spacing, TwoPi * radius / this->Sectors);
    radius = std::min(radius + spacing, parameters.Radius);
    this->Radii.push_back(radius);
    this->Spacings.push_back(std::max(spacing, TwoPi * radius / this->Sectors));
  }
}

double SeaSurfaceGrid::SpacingAt(std::size_t point) const
{
  return point == 0 ? this->Innermost : this->Spacings[(point - 1) / this->Columns];
}

void SeaSurfaceGrid::PlaceAt(std::size_t point, double& x, double& y) const
{
  const std::size_t ring = point == 0 ? 0 : (point - 1) / this->Columns;
  const double radius = point == 0 ? 0.0 : this->Radii[ring];
  const std::size_t sector = point == 0 ? 0 : (this->First + (point - 1) % this->Columns) % this->Sectors;
  const double angle = TwoPi * static_cast<double>(sector) / this->Sectors;
  x = radius * std::cos(angle);
  y = radius * std::sin(angle);
}

std::vector<int> SeaSurfaceGrid::MakeTriangles(const Poll& onRing) const
{
  std::vector<int> corners;
  corners.reserve(3 * this->Count * (2 * this->Radii.size() - 1));
  for (int i = 0; i < this->Count; ++i)
  {
    corners.insert(corners.end(), { 0, 1 + i, 1 + (i + 1) % this->Columns });
  }
  for (std::size_t ring = 1; ring < this->Radii.size(); ++ring)
  {
    onRing();
    const int inner = 1 + static_cast<int>(ring - 1) * this->Columns;
    const int outer = inner + this->Columns;
    for (int i = 0; i < this->Count; ++i)
    {
      const int next = (i + 1) % this->Columns;
      corners.insert(corners.end(), { inner + i, outer + i, outer + next });
      corners.insert(corners.end(), { inner + i, outer + next, inner + next });
    }
  }
  return corners;
}

std::vector<double> FoamAges(double lifetime)
{
  std::vector<double> ages(MostAges);
  for (int k = 0; k < MostAges; ++k)
  {
    ages[k] = AgeStep * lifetime * k;
  }
  return ages;
}

double FoamOf(const double* jacobians)
{
  const double decay = std::exp(-AgeStep);
  double left[MostAges];
  double part = 1.0;
  for (int k = 0; k < MostAges; ++k)
  {
    left[k] = part * (1.0 - jacobians[k]);
    part *= decay;
  }
  double most = std::max(left[0], left[MostAges - 1]);
  for (int k = 1; k + 1 < MostAges; ++k)
  {
    // f(u) = f0 + b u - c u2, largest at u = b / 2c, between the two beside
    const double b = 0.5 * (left[k + 1] - left[k - 1]);
    const double c = left[k] - 0.5 * (left[k + 1] + left[k - 1]);
    most = std::max(most, 2.0 * c > std::abs(b) ? left[k] + 0.25 * b * b / c : left[k]);
  }
  return most;
}

SeaSurfacePoints SurfaceOf(const SeaState& sea, const SeaSurfaceParameters& parameters, const SeaSurfaceGrid& grid,
  double choppiness, double time, std::size_t begin, std::size_t end, double foamLifetime)
{
  const std::size_t count = end - begin;
  const SeaState trains = FromCenter(LongestFirst(sea), parameters.Center);
  std::vector<float> centers(3 * count, 0.0f);
  std::vector<int> resolved(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    double x, y;
    grid.PlaceAt(begin + i, x, y);
    centers[3 * i] = static_cast<float>(x);
    centers[3 * i + 1] = static_cast<float>(y);
    resolved[i] = TrainsResolved(trains, grid.SpacingAt(begin + i));
  }
  SeaSurfacePoints points;
  points.Places.resize(3 * count);
  points.Normals.resize(3 * count);
  points.Jacobians.resize(count);
  std::vector<float> gradients(5 * count);
  OrbitRequest<float> request;
  request.Centers = centers.data();
  request.TrainCounts = resolved.data();
  request.Displacement = points.Places.data();
  request.Gradient = gradients.data();
  WaveOrbitOptions options;
  options.Choppiness = choppiness;
  options.Bound.Motion = BoundMotion::Surface;
  std::vector<float> past;
  if (foamLifetime > 0.0)
  {
    options.Ages = FoamAges(foamLifetime);
    past.resize(3 * MostAges * count);
    request.PastGradient = past.data();
    points.Foam.resize(count);
    points.Ways.resize(2 * count);
  }
  WaveOrbits(trains, options, time).Evaluate(request, 0, count);
  for (std::size_t i = 0; i < count; ++i)
  {
    double gradient[5];
    std::copy_n(gradients.begin() + 5 * i, 5, gradient);
    const Vector3 normal = SurfaceNormal(gradient);
    if (foamLifetime > 0.0)
    {
      points.Foam[i] = static_cast<float>(FoamLeft(past.data() + 3 * MostAges * i));
      std::copy_n(points.Places.begin() + 3 * i, 2, points.Ways.begin() + 2 * i);
    }
    for (int c = 0; c < 3; ++c)
    {
      points.Places[3 * i + c] += centers[3 * i + c];
      points.Normals[3 * i + c] = static_cast<float>(normal[c]);
    }
    points.Jacobians[i] = static_cast<float>(SurfaceJacobian(gradient));
  }
  return points;
}

}
