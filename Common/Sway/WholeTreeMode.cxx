// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sway/WholeTreeMode.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

namespace littoral
{

namespace
{

/// Damping ratio of wood alone. It gives limbs that are nearly alike one common peak, and moves the peak of a single
/// one by 0.1 %.
constexpr double Damping = 0.05;

/// Frequencies that are tried, from a tenth of the rigid tree's, in equal ratios.
constexpr double LeastPart = 0.1;
constexpr int Trials = 80;

/// Riders that are so much faster than the rigid tree follow it.
constexpr double FastRatio = 4.0;

using LimbMatrix = Eigen::Matrix<double, LimbShapes, LimbShapes>;
using LimbVector = Eigen::Matrix<double, LimbShapes, 1>;

/// An oscillator on the trunk.
struct Rider
{
  double Squared; // of its angular frequency [rad2/s2]
  double Losses;  // 2 xi w_i [rad/s]
  double Mass;    // that the trunk feels when it follows [kg]
  double Load;    // that it hands on to the trunk at rest [kg]
};

/// Riders of one trunk. The fast ones are sums: over their square, and over its square.
struct Riders
{
  std::vector<Rider> Slow;
  std::array<double, 2> FastMass{};
  std::array<double, 2> FastLoad{};

  void Add(const Rider& rider, double fast)
  {
    if (rider.Squared < fast)
    {
      this->Slow.push_back(rider);
      return;
    }
    for (int power = 0; power < 2; ++power)
    {
      const double squares = power == 0 ? rider.Squared : rider.Squared * rider.Squared;
      this->FastMass[power] += rider.Mass / squares;
      this->FastLoad[power] += rider.Load / squares;
    }
  }
};

LimbVector VectorOf(const std::array<double, LimbShapes>& values)
{
  return Eigen::Map<const LimbVector>(values.data());
}

LimbMatrix MatrixOf(const std::array<double, LimbShapes * LimbShapes>& values)
{
  return Eigen::Map<const LimbMatrix>(values.data());
}

/// The oscillators of a limb: b'' m + b k = -(c . b) for the acceleration 1 of the trunk's mode.
void AddRiders(const LimbMeasures& limb, const RigidTreeMode& rigid, const LimbMaterial& material, Riders& riders)
{
  const ShapeMixture shapes = ShapesAt(limb.Part);
  const ShapeMixture slopes = SlopesAt(limb.Part);
  const auto mixed = [&](const ShapeMixture& values) {
    return std::inner_product(values.begin(), values.end(), rigid.Mixture.begin(), 0.0);
  };
  const LimbMatrix mass = material.Wood * MatrixOf(limb.Wood.Mass) + material.Leaves * MatrixOf(limb.Leaves.Mass);
  const LimbVector push = material.Wood * VectorOf(limb.Wood.Shift) + material.Leaves * VectorOf(limb.Leaves.Shift);
  const LimbVector turn = material.Wood * VectorOf(limb.Wood.Turn) + material.Leaves * VectorOf(limb.Leaves.Turn);
  const LimbVector coupling = mixed(shapes) * push + mixed(slopes) / rigid.Length * turn;
  const Eigen::SelfAdjointEigenSolver<LimbMatrix> solver(mass);
  for (int i = 0; i < LimbShapes; ++i)
  {
    const double own = solver.eigenvalues()[i];
    if (own > 1e-9 * solver.eigenvalues()[LimbShapes - 1])
    {
      const LimbVector mode = solver.eigenvectors().col(i);
      const double carried = mode.dot(coupling);
      const double frequency = std::sqrt(material.Stiffness / own);
      riders.Add({ material.Stiffness / own, 2.0 * Damping * frequency, carried * carried / own,
                   carried * mode.dot(push) / own },
        FastRatio * FastRatio * rigid.Frequency * rigid.Frequency);
    }
  }
}

/// The square of the trunk's answer to a push at an angular frequency [m2].
double Answer(const RigidTreeMode& rigid, const Riders& riders, double frequency)
{
  // w^2 / (w_i^2 - w^2 + 2 i xi w_i w), and (w / w_i)^2 + (w / w_i)^4 of the fast ones
  const double squared = frequency * frequency;
  double mass = riders.FastMass[0] + squared * riders.FastMass[1];
  double load = riders.FastLoad[0] + squared * riders.FastLoad[1];
  double massLost = 0.0;
  double loadLost = 0.0;
  for (const Rider& rider : riders.Slow)
  {
    const double ahead = rider.Squared - squared;
    const double follows = 1.0 / (ahead * ahead + rider.Losses * rider.Losses * squared);
    mass += rider.Mass * ahead * follows;
    load += rider.Load * ahead * follows;
    massLost += rider.Mass * rider.Losses * follows;
    loadLost += rider.Load * rider.Losses * follows;
  }
  const std::complex<double> push(rigid.Load + squared * load, -squared * frequency * loadLost);
  const double springs = rigid.Frequency * rigid.Frequency - squared;
  const std::complex<double> resists(rigid.Mass * springs - squared * squared * mass,
    rigid.Mass * 2.0 * Damping * rigid.Frequency * frequency + squared * squared * frequency * massLost);
  return std::norm(push) / std::norm(resists);
}

}

double WholeTreeFrequency(
  const RigidTreeMode& rigid, const std::vector<LimbMeasures>& limbs, const LimbMaterial& material)
{
  if (limbs.empty())
  {
    return rigid.Frequency;
  }
  Riders riders;
  for (const LimbMeasures& limb : limbs)
  {
    AddRiders(limb, rigid, material, riders);
  }
  const double ratio = std::pow(LeastPart, -1.0 / Trials);
  const auto answer = [&](double trial) {
    return Answer(rigid, riders, LeastPart * rigid.Frequency * std::pow(ratio, trial));
  };
  int best = 0;
  double most = 0.0;
  for (int trial = 0; trial <= Trials; ++trial)
  {
    const double value = answer(trial);
    if (value > most)
    {
      best = trial;
      most = value;
    }
  }
  // The top of the parabola through three answers, narrower and narrower.
  double at = best;
  for (const double width : { 0.5, 0.2, 0.1 })
  {
    const double before = answer(at - width);
    const double middle = answer(at);
    const double after = answer(at + width);
    const double bend = before - 2.0 * middle + after;
    at += bend < 0.0 ? std::clamp(0.5 * (before - after) / bend, -2.0, 2.0) * width : 0.0;
  }
  // A damped oscillator answers most at w (1 - 2 xi^2)^1/2.
  const double frequency = LeastPart * rigid.Frequency * std::pow(ratio, at) / std::sqrt(1.0 - 2.0 * Damping * Damping);
  return std::min(rigid.Frequency, frequency);
}

}
