// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sea/WaveDirections.h"

#include "Numerics/Constants.h"

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numeric>

namespace littoral
{

namespace
{

/// Panels of a half of the spreading, at least: so narrow that a line is near enough to begin a quantile with.
constexpr int LeastPanels = 128;
/// Agreement of panels with their halves; rounding leaves s times 2e-16 of the density.
constexpr double PanelAgreement = 1e-10;
/// Angles are stretched by no more.
constexpr double LargestStretch = 16.0;

/// cos^2s(angle/2) = sin^2s(supplement/2) of the supplement pi - angle.
CompositeQuadrature::Function DensityOf(double exponent)
{
  return [exponent](double supplement) { return std::pow(std::sin(0.5 * supplement), 2.0 * exponent); };
}

std::vector<double> HalfTurnInParts(int count)
{
  std::vector<double> cuts;
  for (int part = 0; part <= count; ++part)
  {
    cuts.push_back(Pi * part / count);
  }
  return cuts;
}

/// Van der Corput's sequence in base 2, the halves at each node of its tree in random order (Owen 1995).
double ScrambledPlace(std::uint64_t index, std::uint64_t count, const RandomStream& random)
{
  double place = 0.0;
  double half = 0.5;
  for (std::uint64_t node = 1; node < count; node *= 2)
  {
    const std::uint64_t bit = index / node % 2;
    const std::uint64_t swap = random.Words(node + index % node, 1)[0] % 2;
    place += static_cast<double>(bit ^ swap) * half;
    half *= 0.5;
  }
  return place;
}

/// Trains in the order of their strata.
std::vector<std::size_t> OrderOfStrata(std::size_t count, const RandomStream& random)
{
  std::vector<double> place(count);
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t(0));
  for (std::size_t train = 0; train < count; ++train)
  {
    place[train] = ScrambledPlace(train, count, random);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return place[a] < place[b]; });
  return order;
}

/// The mean vector by energy when angles are stretched by a factor.
std::complex<double> MeanVector(
  const std::vector<double>& energies, double total, const std::vector<double>& angles, double stretch)
{
  std::complex<double> sum(0.0, 0.0);
  for (std::size_t train = 0; train < angles.size(); ++train)
  {
    sum += energies[train] * std::polar(1.0, stretch * angles[train]);
  }
  return sum / total;
}

/// The factor that gives the mean vector a length; 1 where none does.
template <typename Length>
double StretchTo(const Length& lengthOf, double wanted)
{
  const auto excess = [&](double stretch) { return lengthOf(stretch) - wanted; };
  double near = 1.0;
  const double start = excess(near);
  const double factor = start > 0.0 ? 2.0 : 0.5;
  double far = factor;
  while (excess(far) * start > 0.0)
  {
    near = far;
    far *= factor;
    if (!(far <= LargestStretch && far >= 1.0 / LargestStretch))
    {
      return 1.0;
    }
  }
  std::uintmax_t steps = 60;
  const auto found = boost::math::tools::toms748_solve(
    excess, std::min(near, far), std::max(near, far), boost::math::tools::eps_tolerance<double>(40), steps);
  return 0.5 * (found.first + found.second);
}

/// Part of the energy below the angle of each train, at random in its stratum.
std::vector<double> PartsOfTrains(const std::vector<double>& energies, double total, const RandomStream& random)
{
  std::vector<double> parts(energies.size());
  double below = 0.0;
  for (const std::size_t train : OrderOfStrata(energies.size(), random))
  {
    parts[train] = (below + random.UniformPair(train, 0)[0] * energies[train]) / total;
    below += energies[train];
  }
  return parts;
}

}

WaveSpreading::WaveSpreading(double exponent)
  : Exponent(exponent)
  , Half(DensityOf(exponent), HalfTurnInParts(LeastPanels), PanelAgreement)
{
}

double WaveSpreading::Quantile(double part) const
{
  const double angle = Pi - this->Half.Quantile(DensityOf(this->Exponent), 2.0 * std::min(part, 1.0 - part));
  return part < 0.5 ? -angle : angle;
}

std::vector<double> WaveAngles(
  const std::vector<double>& energies, const WaveSpreading& spreading, const RandomStream& random)
{
  if (energies.empty())
  {
    return {};
  }
  const double total = std::accumulate(energies.begin(), energies.end(), 0.0);
  std::vector<double> angles = PartsOfTrains(energies, total, random);
  std::transform(angles.begin(), angles.end(), angles.begin(), [&](double part) { return spreading.Quantile(part); });
  const auto length = [&](double stretch) { return std::abs(MeanVector(energies, total, angles, stretch)); };
  const double stretch = StretchTo(length, spreading.MeanCosine());
  const double turn = std::arg(MeanVector(energies, total, angles, stretch));
  for (double& angle : angles)
  {
    angle = stretch * angle - turn;
  }
  return angles;
}

std::vector<double> WaveAngles(
  const std::vector<double>& energies, const std::vector<WaveDirection>& directions, const RandomStream& random)
{
  const double total = std::accumulate(energies.begin(), energies.end(), 0.0);
  std::vector<double> angles = PartsOfTrains(energies, total, random);
  std::complex<double> wanted(0.0, 0.0);
  for (std::size_t train = 0; train < energies.size(); ++train)
  {
    const WaveSpreading spreading(directions[train].Exponent);
    angles[train] = spreading.Quantile(angles[train]);
    wanted += energies[train] / total * std::polar(spreading.MeanCosine(), directions[train].Mean);
  }
  const auto stretched = [&](double stretch) {
    std::complex<double> sum(0.0, 0.0);
    for (std::size_t train = 0; train < energies.size(); ++train)
    {
      sum += energies[train] / total * std::polar(1.0, directions[train].Mean + stretch * angles[train]);
    }
    return sum;
  };
  const double stretch = StretchTo([&](double by) { return std::abs(stretched(by)); }, std::abs(wanted));
  const double turn = std::arg(stretched(stretch)) - std::arg(wanted);
  for (std::size_t train = 0; train < energies.size(); ++train)
  {
    angles[train] = directions[train].Mean + stretch * angles[train] - turn;
  }
  return angles;
}

}
