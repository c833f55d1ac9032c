// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/LandscapeStep.h"

#include "Numerics/ParameterCheck.h"
#include "Numerics/PolledMemory.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr int Passes = 2;

/// Least 1 - (S / S_c)^2: the flux is at most 20 times the linear one, and the threshold does the rest.
constexpr double LeastRest = 0.05;

/// Implicit equation of a point, z = Right / Left.
struct PointEquation
{
  double Left;
  double Right;

  void Add(double weight, double height)
  {
    this->Left += weight;
    this->Right += weight * height;
  }
};

double FactorAt(const std::vector<double>& factors, std::size_t point)
{
  return factors.empty() ? 1.0 : factors[point];
}

}

std::string WhyInvalid(const LandscapeLaw& law)
{
  ParameterCheck check;
  check.NotNegative("Erodibility", law.Erodibility);
  check.Range("AreaExponent", law.AreaExponent, 0.0, 2.0);
  check.NotNegative("Diffusivity", law.Diffusivity);
  check.Positive("ThresholdSlope", law.ThresholdSlope);
  check.NotNegative("MinimumSlope", law.MinimumSlope);
  return check.Reason();
}

void StepLandscape(const PointMesh& mesh, const MeshDrainage& drainage, const LandscapeLaw& law, double uplift,
  const std::vector<double>& hardness, double time, std::vector<double>& heights, const ParallelFor& parallel,
  const RockFactors& factors, const Poll& poll)
{
  std::vector<double> start;
  std::vector<double> incision;
  Lengthen(start, heights.size(), poll);
  Lengthen(incision, heights.size(), poll);
  parallel(heights.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      // z0 / dt + U f h^1/2, and K e A^m / d h^-1/2
      const double root = std::sqrt(hardness[n]);
      start[n] = heights[n] / time + uplift * FactorAt(factors.Uplift, n) * root;
      const CellIndex link = drainage.Link[n];
      incision[n] =
        link < 0 ? 0.0 : law.Erodibility * std::pow(drainage.Area[n], law.AreaExponent) / mesh.Distance[link];
      incision[n] /= root;
      incision[n] *= FactorAt(factors.Erodibility, n);
    }
  });
  const double threshold = law.ThresholdSlope * law.ThresholdSlope;
  const auto solve = [&](CellIndex point, CellIndex out) {
    // z (1/dt + K A^m/d + sum w) = z0/dt + U + K A^m/d z_r + sum w z_j,  w = D e / (d a (1 - (S/S_c)^2))
    const double bed = heights[mesh.Neighbour[out]];
    const double creep = law.Diffusivity / mesh.Area[point];
    PointEquation equation{ 1.0 / time, start[point] };
    equation.Add(incision[point], bed);
    for (CellIndex link = mesh.First[point]; link < mesh.First[point + 1]; ++link)
    {
      const double other = heights[mesh.Neighbour[link]];
      const double fall = heights[point] - other;
      const double most = threshold * mesh.Distance[link] * mesh.Distance[link]; // (S_c d)^2
      const double rest = std::max(most - fall * fall, LeastRest * most);
      equation.Add(creep * mesh.EdgeRatio[link] * most / rest, other);
    }
    const double distance = mesh.Distance[out];
    heights[point] = std::clamp(equation.Right / equation.Left, bed + law.MinimumSlope * distance,
      bed + std::max(law.MinimumSlope, law.ThresholdSlope) * distance);
  };
  SteppedPoll steps(poll);
  for (int pass = 0; pass < Passes; ++pass)
  {
    for (const CellIndex point : drainage.Order)
    {
      steps.Step();
      if (drainage.Link[point] >= 0)
      {
        solve(point, drainage.Link[point]);
      }
    }
  }
}

}
