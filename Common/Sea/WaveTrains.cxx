// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sea/WaveTrains.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Numerics/RandomStream.h"
#include "Sea/Dispersion.h"
#include "Sea/WaveDirections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

namespace littoral
{

namespace
{

/// Relative mismatch of w and sqrt(g k tanh kh) that rounding of a table, and of its gravity to 9.8 or 9.81 m/s2, may
/// leave; more is another depth.
constexpr double DispersionTolerance = 5e-4;
constexpr int MostTrains = 100000;
/// Beyond this exponent the spreading is narrower than anyone can see.
constexpr double LargestSpreading = 10000.0;
/// An exponent with the same energy from all sides.
constexpr double LeastSpreading = 1e-3;

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

/// Edges of the bins, one more than there are bins.
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

/// Direction and spreading at a frequency, between those that are given by their vectors, and those beyond at the ends.
WaveDirection DirectionOf(const std::vector<DirectionAt>& known, double frequency)
{
  const auto next = std::lower_bound(
    known.begin(), known.end(), frequency, [](const DirectionAt& at, double w) { return at.Frequency < w; });
  const auto vectorOf = [](const DirectionAt& at) { return std::polar(at.Length, at.Mean); };
  std::complex<double> mean = vectorOf(next == known.end() ? known.back() : *next);
  if (next != known.begin() && next != known.end())
  {
    // Densities times vectors are linear, as densities are
    const DirectionAt& before = *(next - 1);
    const double part = (frequency - before.Frequency) / (next->Frequency - before.Frequency);
    const double left = (1.0 - part) * before.Density;
    const double right = part * next->Density;
    mean = left + right > 0.0 ? (left * vectorOf(before) + right * mean) / (left + right) : mean;
  }
  // s = r / (1 - r)
  const double length = std::abs(mean);
  const double exponent = length < 1.0 ? length / (1.0 - length) : LargestSpreading;
  return { std::arg(mean), std::clamp(exponent, LeastSpreading, LargestSpreading) };
}

/// Whether the spreading varies with frequency.
bool HasModel(const TrainParameters& parameters)
{
  return parameters.Model == SpreadingModel::DonelanBanner ||
    (parameters.Model == SpreadingModel::Mitsuyasu && parameters.Spreading > 0.0);
}

/// Direction and spreading of a train of a swell or of the wind sea beside it.
WaveDirection DirectionIn(bool isSwell, const TrainParameters& parameters, double frequency)
{
  if (!isSwell && HasModel(parameters))
  {
    return DirectionOf(parameters.Model, parameters.MeanDirection, parameters.Spreading, frequency);
  }
  const double exponent = isSwell ? parameters.SwellSpreading : parameters.Spreading;
  return { isSwell ? parameters.SwellDirection : parameters.MeanDirection,
    exponent > 0.0 ? std::max(exponent, LeastSpreading) : LargestSpreading };
}

/// A wave of a spectrum's whole energy, with a crest at the origin at time 0.
WaveTrain RegularWave(const SeaSpectrum& spectrum, double depth, double direction)
{
  const double frequency = spectrum.PeakFrequency();
  return { std::sqrt(2.0 * spectrum.TotalEnergy()), frequency, WaveNumber(frequency, depth), direction, Pi };
}

/// Amplitudes may be as small as they come: they are sums, and divide nothing.
bool IsGood(const WaveTrain& train)
{
  return train.Amplitude >= 0.0 && train.Amplitude <= MaximumMagnitude &&
    ValueInterval::Positive().Contains(train.AngularFrequency) &&
    ValueInterval::Positive().Contains(train.WaveNumber) && std::abs(train.Direction) <= MaximumMagnitude &&
    std::abs(train.Phase) <= MaximumMagnitude;
}

/// Whether frequency and wave number obey w^2 = g k tanh kh.
bool IsOfDepth(const WaveTrain& train, double depth)
{
  return !(std::abs(WaveFrequency(train.WaveNumber, depth) / train.AngularFrequency - 1.0) > DispersionTolerance);
}

std::string WhyBad(const WaveTrain& train, std::ptrdiff_t n, double depth)
{
  const std::string ofTrain = " of train " + std::to_string(n);
  ParameterCheck check;
  check.NotNegative("Amplitude" + ofTrain, train.Amplitude, "m");
  check.Positive("AngularFrequency" + ofTrain, train.AngularFrequency, "rad/s");
  check.Positive("WaveNumber" + ofTrain, train.WaveNumber, "rad/m");
  check.Finite("Direction" + ofTrain, train.Direction, "rad");
  check.Finite("Phase" + ofTrain, train.Phase, "rad");
  check.Require(IsOfDepth(train, depth),
    "WaveNumber" + ofTrain + " belongs to another depth than WaterDepth, " + TextOf(depth) + " m.");
  return check.Reason();
}

}

std::string WhyInvalid(const SeaState& sea)
{
  ParameterCheck check;
  check.Require(!sea.Trains.empty(), "the sea state has no wave trains.");
  check.Require(sea.Depth > 0.0, "WaterDepth", sea.Depth, "m", "positive"); // or infinite
  check.Finite("SeaLevel", sea.SeaLevel, "m");
  check.Range("Order", static_cast<int>(sea.Order), 1, 2);
  check.Require(sea.Order == SeaOrder::First || sea.Trains.size() <= MostBoundTrains,
    "a sea of second order has at most " + std::to_string(MostBoundTrains) + " wave trains; this one has " +
      std::to_string(sea.Trains.size()) + ".");
  const auto isBad = [&](const WaveTrain& train) { return !IsGood(train) || !IsOfDepth(train, sea.Depth); };
  const auto bad = std::find_if(sea.Trains.begin(), sea.Trains.end(), isBad);
  if (check.IsGood() && bad != sea.Trains.end())
  {
    return WhyBad(*bad, bad - sea.Trains.begin(), sea.Depth);
  }
  return check.Reason();
}

std::string WhyInvalid(const TrainParameters& parameters)
{
  const bool isAll = parameters.Lowest == 0.0 && parameters.Highest == 0.0;
  ParameterCheck check;
  check.Count("NumberOfTrains", parameters.Count, 1, MostTrains);
  check.Require(
    isAll || (parameters.Lowest >= 0.0 && parameters.Highest > parameters.Lowest && parameters.Highest <= 1000.0),
    "FrequencyRange is " + TextOf(parameters.Lowest) + " to " + TextOf(parameters.Highest) +
      " peak frequencies; it must be increasing, not negative and at most 1000, or 0 and 0.");
  check.Finite("MeanDirection", parameters.MeanDirection * 180.0 / Pi, "degrees");
  check.Range("Spreading", parameters.Spreading, 0.0, LargestSpreading);
  check.Finite("SwellDirection", parameters.SwellDirection * 180.0 / Pi, "degrees");
  check.Range("SwellSpreading", parameters.SwellSpreading, 0.0, LargestSpreading);
  check.Choice("SpreadingModel", static_cast<int>(parameters.Model), 3);
  return check.Reason();
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
    // r^2 / 2 = integral of S over the bin
    train.Amplitude = std::sqrt(2.0 * energy);
    train.AngularFrequency = parameters.EqualSpacing ? (comb.First + bin) * comb.Spacing : place;
    train.WaveNumber = WaveNumber(train.AngularFrequency, depth);
    train.Direction = parameters.MeanDirection;
    train.Phase = TwoPi * random[0];
    trains.push_back(train);
    energies.push_back(energy);
  }
  if (!parameters.Directions.empty() || HasModel(parameters) || spectrum.HasSwell())
  {
    const double peak = spectrum.WindSeaPeak();
    // A train is all swell or all wind sea, and each has its mean direction
    std::vector<std::size_t> groups[2];
    for (std::size_t n = 0; n < trains.size(); ++n)
    {
      groups[phases.UniformPair(n, 1)[0] < spectrum.SwellPart(trains[n].AngularFrequency) ? 1 : 0].push_back(n);
    }
    for (int isSwell = 0; isSwell < 2; ++isSwell)
    {
      std::vector<WaveDirection> own;
      std::vector<double> part;
      for (const std::size_t n : groups[isSwell])
      {
        const double w = trains[n].AngularFrequency;
        own.push_back(parameters.Directions.empty() ? DirectionIn(isSwell == 1, parameters, w / peak)
                                                    : DirectionOf(parameters.Directions, w));
        part.push_back(energies[n]);
      }
      const std::vector<double> angles = WaveAngles(part, own, directions);
      for (std::size_t n = 0; n < angles.size(); ++n)
      {
        trains[groups[isSwell][n]].Direction = angles[n];
      }
    }
  }
  else if (parameters.Spreading > 0.0)
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

std::vector<double> BinEdges(const SeaSpectrum& spectrum, const TrainParameters& parameters)
{
  return spectrum.IsRegular() ? std::vector<double>() : EdgesOf(RangeOf(spectrum, parameters), parameters);
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
