// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sea/WaveTrains.h"

#include "Numerics/Constants.h"
#include "Numerics/RandomStream.h"
#include "Sea/Dispersion.h"
#include "Sea/WaveDirections.h"

#include <algorithm>
#include <array>
#include <cmath>
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

/// Frequencies that are whole multiples of one: First w0, (First + 1) w0, ...
struct FrequencyComb
{
  double Spacing; ///< w0 [rad/s]
  double First;
};

std::array<double, 2> RangeOf(const SeaSpectrum& spectrum, const TrainParameters& parameters)
{
  const double peak = spectrum.PeakFrequency();
  return parameters.Lowest == 0.0 && parameters.Highest == 0.0
    ? spectrum.Range()
    : std::array<double, 2>{ parameters.Lowest * peak, parameters.Highest * peak };
}

/// The comb of so many frequencies that best fills a range and has its middle.
FrequencyComb CombOf(const std::array<double, 2>& range, int count)
{
  const double bins = count / (range[1] - range[0]);
  const double first = count == 1 ? 1.0 : std::round(range[0] * bins + 0.5);
  return { 0.5 * (range[0] + range[1]) / (first + 0.5 * (count - 1)), first };
}

/// Where bins end, one more than there are.
std::vector<double> EdgesOf(const std::array<double, 2>& range, const TrainParameters& parameters)
{
  const FrequencyComb comb = CombOf(range, parameters.Count);
  const double width = (range[1] - range[0]) / parameters.Count;
  std::vector<double> edges{ range[0] };
  for (int bin = 1; bin < parameters.Count; ++bin)
  {
    edges.push_back(parameters.EqualSpacing ? (comb.First + bin - 0.5) * comb.Spacing : range[0] + bin * width);
  }
  edges.push_back(range[1]);
  return edges;
}

/// A wave of a spectrum's whole energy, with a crest at the origin at time 0.
WaveTrain RegularWave(const SeaSpectrum& spectrum, double depth, double direction)
{
  const double frequency = spectrum.PeakFrequency();
  return { std::sqrt(2.0 * spectrum.TotalEnergy()), frequency, WaveNumber(frequency, depth), direction, Pi };
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
  else if (!(parameters.Lowest == 0.0 && parameters.Highest == 0.0) &&
    !(parameters.Lowest >= 0.0 && parameters.Highest > parameters.Lowest && parameters.Highest <= 1000.0))
  {
    reason << "FrequencyRange is " << parameters.Lowest << " to " << parameters.Highest
           << " peak frequencies; it must be increasing, not negative and at most 1000, or 0 and 0.";
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

std::vector<WaveTrain> TrainsOf(const SeaSpectrum& spectrum, double depth, const TrainParameters& parameters)
{
  if (spectrum.IsRegular())
  {
    return { RegularWave(spectrum, depth, parameters.MeanDirection) };
  }
  const RandomStream phases(parameters.Seed, RandomPurpose::WavePhases);
  const RandomStream directions(parameters.Seed, RandomPurpose::WaveDirections);
  const int count = parameters.Count;
  const std::array<double, 2> range = RangeOf(spectrum, parameters);
  const std::vector<double> edges = EdgesOf(range, parameters);
  const FrequencyComb comb = CombOf(range, count);
  std::vector<WaveTrain> trains;
  std::vector<double> energies;
  for (int bin = 0; bin < count; ++bin)
  {
    const double energy = spectrum.Energy(edges[bin], edges[bin + 1]);
    if (!(energy > 0.0))
    {
      continue;
    }
    const auto random = phases.UniformPair(bin, 0);
    const double place = edges[bin] + random[1] * (edges[bin + 1] - edges[bin]);
    WaveTrain train;
    train.Amplitude = std::sqrt(2.0 * energy);
    train.AngularFrequency = parameters.EqualSpacing ? (comb.First + bin) * comb.Spacing : place;
    train.WaveNumber = WaveNumber(train.AngularFrequency, depth);
    train.Direction = parameters.MeanDirection;
    train.Phase = TwoPi * random[0];
    trains.push_back(train);
    energies.push_back(energy);
  }
  if (parameters.Spreading > 0.0)
  {
    const std::vector<double> angles = WaveAngles(energies, WaveSpreading(parameters.Spreading), directions);
    for (std::size_t n = 0; n < trains.size(); ++n)
    {
      trains[n].Direction += angles[n];
    }
  }
  std::stable_sort(
    trains.begin(), trains.end(), [](const WaveTrain& a, const WaveTrain& b) { return a.Amplitude > b.Amplitude; });
  return trains;
}

double PeriodOf(const SeaSpectrum& spectrum, const TrainParameters& parameters)
{
  if (spectrum.IsRegular())
  {
    return TwoPi / spectrum.PeakFrequency();
  }
  return parameters.EqualSpacing ? TwoPi / CombOf(RangeOf(spectrum, parameters), parameters.Count).Spacing
                                 : std::numeric_limits<double>::infinity();
}

double EnergyOf(const std::vector<WaveTrain>& trains)
{
  double sum = 0.0;
  for (const WaveTrain& train : trains)
  {
    sum += 0.5 * train.Amplitude * train.Amplitude;
  }
  return sum;
}

}
