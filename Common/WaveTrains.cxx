// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "WaveTrains.h"

#include "Constants.h"
#include "Dispersion.h"
#include "RandomStream.h"

#include <boost/math/special_functions/beta.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace littoral
{

namespace
{

/// Relative mismatch of w2 and g k tanh kh that rounding of a table may leave; more is another depth.
constexpr double DispersionTolerance = 1e-5;
constexpr int MostTrains = 100000;
/// Beyond this exponent the spreading is narrower than anyone can see.
constexpr double LargestSpreading = 10000.0;

/// A stratum of the spreading for each train, in random order.
std::vector<int> Strata(int count, const RandomStream& random)
{
  std::vector<double> key(count);
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  for (int train = 0; train < count; ++train)
  {
    key[train] = random.UniformPair(train, 0)[1];
  }
  std::sort(order.begin(), order.end(), [&](int a, int b) { return key[a] != key[b] ? key[a] < key[b] : a < b; });
  return order;
}

}

std::string WhyInvalid(const SeaState& sea)
{
  std::ostringstream reason;
  if (sea.Trains.empty())
  {
    return "the sea state has no wave trains.";
  }
  if (!(sea.Depth > 0.0))
  {
    reason << "WaterDepth is " << sea.Depth << " m; it must be positive.";
  }
  else if (!std::isfinite(sea.SeaLevel))
  {
    reason << "SeaLevel is " << sea.SeaLevel << "; it must be finite.";
  }
  for (std::size_t n = 0; n < sea.Trains.size() && reason.str().empty(); ++n)
  {
    const WaveTrain& train = sea.Trains[n];
    const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
    const double frequency = WaveFrequency(train.WaveNumber, sea.Depth);
    if (!(train.Amplitude >= 0.0 && std::isfinite(train.Amplitude)))
    {
      reason << "Amplitude of train " << n << " is " << train.Amplitude << " m; it must not be negative.";
    }
    else if (!positive(train.AngularFrequency))
    {
      reason << "AngularFrequency of train " << n << " is " << train.AngularFrequency << "; it must be positive.";
    }
    else if (!positive(train.WaveNumber))
    {
      reason << "WaveNumber of train " << n << " is " << train.WaveNumber << "; it must be positive.";
    }
    else if (!std::isfinite(train.Direction) || !std::isfinite(train.Phase))
    {
      reason << "Direction or Phase of train " << n << " is no number.";
    }
    else if (std::abs(frequency / train.AngularFrequency - 1.0) > DispersionTolerance)
    {
      reason << "WaveNumber of train " << n << " belongs to another depth than WaterDepth, " << sea.Depth << " m.";
    }
  }
  return reason.str();
}

std::string WhyInvalid(const TrainParameters& parameters)
{
  std::ostringstream reason;
  if (parameters.Count < 1 || parameters.Count > MostTrains)
  {
    reason << "NumberOfTrains is " << parameters.Count << "; it must be 1 to " << MostTrains << ".";
  }
  else if (!(parameters.Lowest >= 0.0 && parameters.Highest > parameters.Lowest && parameters.Highest <= 1000.0))
  {
    reason << "FrequencyRange is " << parameters.Lowest << " to " << parameters.Highest
           << " peak frequencies; it must be increasing, not negative and at most 1000.";
  }
  else if (!std::isfinite(parameters.MeanDirection))
  {
    reason << "MeanDirection is " << parameters.MeanDirection << "; it must be finite.";
  }
  else if (!(parameters.Spreading >= 0.0 && parameters.Spreading <= LargestSpreading))
  {
    reason << "Spreading is " << parameters.Spreading << "; it must be 0 to " << LargestSpreading << ".";
  }
  return reason.str();
}

double SpreadingQuantile(double spreading, double part)
{
  // With y = (1 + sin(angle/2))/2, cos^2s(angle/2) becomes the beta distribution of s + 1/2 and s + 1/2.
  const double y = boost::math::ibeta_inv(spreading + 0.5, spreading + 0.5, part);
  return 2.0 * std::asin(std::clamp(2.0 * y - 1.0, -1.0, 1.0));
}

std::vector<WaveTrain> TrainsOf(const SeaSpectrum& spectrum, double depth, const TrainParameters& parameters)
{
  const RandomStream phases(parameters.Seed, RandomPurpose::WavePhases);
  const RandomStream directions(parameters.Seed, RandomPurpose::WaveDirections);
  const int count = parameters.Count;
  const std::vector<int> stratum = Strata(count, directions);
  const double peak = spectrum.PeakFrequency();
  const double width = (parameters.Highest - parameters.Lowest) * peak / count;
  std::vector<WaveTrain> trains;
  for (int bin = 0; bin < count; ++bin)
  {
    const double low = parameters.Lowest * peak + bin * width;
    const double energy = spectrum.Energy(low, low + width);
    if (!(energy > 0.0))
    {
      continue;
    }
    const auto random = phases.UniformPair(bin, 0);
    WaveTrain train;
    train.Amplitude = std::sqrt(2.0 * energy);
    train.AngularFrequency = low + (parameters.EqualSpacing ? 0.5 : random[1]) * width;
    train.WaveNumber = WaveNumber(train.AngularFrequency, depth);
    train.Direction = parameters.MeanDirection;
    if (parameters.Spreading > 0.0)
    {
      const double part = (stratum[bin] + directions.UniformPair(bin, 0)[0]) / count;
      train.Direction += SpreadingQuantile(parameters.Spreading, part);
    }
    train.Phase = TwoPi * random[0];
    trains.push_back(train);
  }
  std::stable_sort(
    trains.begin(), trains.end(), [](const WaveTrain& a, const WaveTrain& b) { return a.Amplitude > b.Amplitude; });
  return trains;
}

}
