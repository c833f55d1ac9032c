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
/// An exponent with the same energy from all sides.
constexpr double LeastExponent = 1e-3;
/// Difference of mean vectors over the wanted one up to which angles are fitted to it.
constexpr double LargestMisfit = 0.5;
/// Steps of a mean cosine.
constexpr int CosineSteps = 256;

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

/// The angle below which a part of sech^2(b angle), -pi to pi, lies.
double SechQuantile(double b, double part)
{
  return std::atanh((2.0 * part - 1.0) * std::tanh(b * Pi)) / b;
}

/// b of sech^2(b angle) at a frequency over that of the peak; below 0.56, where there are no data, that at 0.56.
double DonelanBannerWidth(double f)
{
  if (f < 0.95)
  {
    return 2.61 * std::pow(std::max(f, 0.56), 1.3);
  }
  return f < 1.6 ? 2.28 * std::pow(f, -1.3) : std::pow(10.0, -0.4 + 0.8393 * std::exp(-0.567 * std::log(f * f)));
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

WaveDirection DirectionOf(SpreadingModel model, double mean, double s, double f)
{
  if (model == SpreadingModel::DonelanBanner)
  {
    return { mean, DonelanBannerWidth(f), true };
  }
  const double fall = model == SpreadingModel::Constant ? 1.0 : std::pow(f, f < 1.0 ? 5.0 : -2.5);
  return { mean, std::max(s * fall, LeastExponent) };
}

double MeanCosineOf(const WaveDirection& direction)
{
  const double b = direction.Exponent;
  if (!direction.IsSech)
  {
    return b / (b + 1.0);
  }
  // Simpson's rule for the integral of cos x b sech^2(b x) / tanh(b pi), 0 to pi
  double sum = 0.0;
  for (int n = 0; n <= CosineSteps; ++n)
  {
    const double x = Pi * n / CosineSteps;
    const double sech = 1.0 / std::cosh(b * x);
    sum += (n == 0 || n == CosineSteps ? 1.0 : n % 2 == 1 ? 4.0 : 2.0) * std::cos(x) * sech * sech;
  }
  return sum * Pi / (3.0 * CosineSteps) * b / std::tanh(b * Pi);
}

std::vector<double> WaveAngles(
  const std::vector<double>& energies, const std::vector<WaveDirection>& directions, const RandomStream& random)
{
  const double total = std::accumulate(energies.begin(), energies.end(), 0.0);
  std::vector<double> angles = PartsOfTrains(energies, total, random);
  std::complex<double> wanted(0.0, 0.0);
  for (std::size_t train = 0; train < energies.size(); ++train)
  {
    const WaveDirection& own = directions[train];
    angles[train] =
      own.IsSech ? SechQuantile(own.Exponent, angles[train]) : WaveSpreading(own.Exponent).Quantile(angles[train]);
    wanted += energies[train] / total * std::polar(MeanCosineOf(own), own.Mean);
  }
  const auto stretched = [&](double stretch) {
    std::complex<double> sum(0.0, 0.0);
    for (std::size_t train = 0; train < energies.size(); ++train)
    {
      sum += energies[train] / total * std::polar(1.0, directions[train].Mean + stretch * angles[train]);
    }
    return sum;
  };
  // Seas that nearly cancel have no mean vector to fit to
  const bool isFitted = std::abs(stretched(1.0) - wanted) < LargestMisfit * std::abs(wanted);
  const double stretch =
    isFitted ? StretchTo([&](double by) { return std::abs(stretched(by)); }, std::abs(wanted)) : 1.0;
  const double turn = isFitted ? std::arg(stretched(stretch)) - std::arg(wanted) : 0.0;
  for (std::size_t train = 0; train < energies.size(); ++train)
  {
    angles[train] = directions[train].Mean + stretch * angles[train] - turn;
  }
  return angles;
}

}
