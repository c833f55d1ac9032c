// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlantSway.h"

#include "BeamResponse.h"
#include "Constants.h"
#include "PlantMotion.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// Frequencies that are tabulated for eq. 25, in equal ratios.
constexpr int MostColumns = 128;

/// Frequencies above this, times the wind's step, follow the load at once.
constexpr double FastestAngle = 30.0;

/// Mass [kg] and drag, as the area of a bare cylinder [m2], of branches with what they carry.
struct Burden
{
  double Mass = 0.0;
  double Area = 0.0;
};

/// What bends, weighs and drags in a tapered branch.
struct Taper
{
  double BendingRadius; // [m]
  double MeanRadius;    // [m]
  double MeanSquare;    // of the radius [m2]
};

/// The uniform beam with the tip's deflection of the tapered one under a uniform load at rest: by the moment at the
/// part s of the length, (1 - s)^2 / 2, and its arm, the mean of 1 / R^4 with the weight 4 (1 - s)^3.
Taper TaperOf(const Skeleton& skeleton, const SkeletonBranch& branch, double length)
{
  constexpr int Steps = 8; // in a segment
  Taper taper{ 0.0, 0.0, 0.0 };
  double give = 0.0;
  double place = 0.0;
  for (int node = branch.First; node + 1 < branch.First + branch.Count; ++node)
  {
    const SkeletonNode& a = skeleton.Nodes[node];
    const SkeletonNode& b = skeleton.Nodes[node + 1];
    const double width = glm::distance(a.Position, b.Position) / length / Steps;
    for (int step = 0; step < Steps; ++step, place += width)
    {
      const double radius = a.Radius + (step + 0.5) / Steps * (b.Radius - a.Radius);
      const double low = std::max(0.0, 1.0 - place);
      const double high = std::max(0.0, 1.0 - place - width);
      give += (std::pow(low, 4) - std::pow(high, 4)) / std::pow(radius, 4);
      taper.MeanRadius += width * radius;
      taper.MeanSquare += width * radius * radius;
    }
  }
  taper.BendingRadius = std::pow(give, -0.25);
  return taper;
}

/// A branch that grew is thick enough for what it bears: grown skeletons have a few twigs that are not, and would hang
/// like threads. The radius [m] from which the tip sags by no more than a part of the length, in wood of the usual
/// modulus.
double LeastRadius(const RoundBeam& beam)
{
  constexpr double LargestSag = 0.2;
  constexpr double UsualModulus = 9e9; // [Pa]
  const double weight = glm::length(WeightPerLength(beam.MassPerLength));
  const double least = weight * std::pow(beam.Length, 3) / (8.0 * UsualModulus * LargestSag);
  return std::pow(least / SecondMoment(1.0), 0.25);
}

/// Adds leaves to their branches, then branches, from the twigs down, to those that carry them.
void AddCarried(const Skeleton& skeleton, const std::vector<double>& leafAreas, const SwayOptions& options,
  std::vector<Burden>& burdens)
{
  const double leafPart = options.Load.DragCoefficient > 0.0 ? options.LeafDrag / options.Load.DragCoefficient : 0.0;
  for (std::size_t node = 0; node < leafAreas.size(); ++node)
  {
    Burden& burden = burdens[skeleton.Nodes[node].Branch];
    burden.Mass += options.LeafMass * leafAreas[node];
    burden.Area += leafPart * leafAreas[node];
  }
  for (int branch = static_cast<int>(burdens.size()) - 1; branch >= 0; --branch)
  {
    const int parent = skeleton.Nodes[skeleton.Branches[branch].First].Parent;
    if (parent >= 0)
    {
      Burden& below = burdens[skeleton.Nodes[parent].Branch];
      below.Mass += burdens[branch].Mass;
      below.Area += burdens[branch].Area;
    }
  }
}

/// Weights of values at 0, 1, 2 and 3 in the cubic through them.
std::array<double, 4> CubicWeights(double x)
{
  return { -(x - 1.0) * (x - 2.0) * (x - 3.0) / 6.0, 0.5 * x * (x - 2.0) * (x - 3.0), -0.5 * x * (x - 1.0) * (x - 3.0),
    x * (x - 1.0) * (x - 2.0) / 6.0 };
}

/// Frequencies in equal ratios over those that are met.
std::vector<double> FrequenciesOver(const std::vector<double>& met)
{
  const auto ends = std::minmax_element(met.begin(), met.end());
  const double low = *ends.first;
  const double ratio = *ends.second / low;
  if (ratio < 1.0 + 1e-9)
  {
    return { low };
  }
  std::vector<double> frequencies(MostColumns);
  for (int i = 0; i < MostColumns; ++i)
  {
    frequencies[i] = low * std::pow(ratio, i / (MostColumns - 1.0));
  }
  return frequencies;
}

}

std::vector<BranchBeam> BeamsOf(
  const Skeleton& skeleton, const std::vector<double>& leafAreas, const SwayOptions& options)
{
  std::vector<BranchBeam> beams(skeleton.Branches.size());
  std::vector<Burden> burdens(beams.size());
  for (int branch = 0; branch < static_cast<int>(beams.size()); ++branch)
  {
    BranchBeam& beam = beams[branch];
    int node = 0;
    beam.Axis = BranchAxis(skeleton, branch);
    beam.Middle = skeleton.Along(branch, 0.5, node);
    beam.Beam.Length = skeleton.BranchLength(branch);
    const Taper taper = TaperOf(skeleton, skeleton.Branches[branch], beam.Beam.Length);
    beam.Beam.Radius = taper.BendingRadius;
    beam.Beam.YoungModulus = options.Wood.YoungModulus;
    burdens[branch].Mass = options.Wood.Density * Pi * taper.MeanSquare * beam.Beam.Length;
    burdens[branch].Area = 2.0 * taper.MeanRadius * beam.Beam.Length;
  }
  if (options.Carries)
  {
    AddCarried(skeleton, leafAreas, options, burdens);
  }
  for (std::size_t branch = 0; branch < beams.size(); ++branch)
  {
    beams[branch].Beam.MassPerLength = burdens[branch].Mass / beams[branch].Beam.Length;
    beams[branch].DragDiameter = burdens[branch].Area / beams[branch].Beam.Length;
    if (options.Carries)
    {
      beams[branch].Beam.Radius = std::max(beams[branch].Beam.Radius, LeastRadius(beams[branch].Beam));
    }
  }
  return beams;
}

PlantSway::PlantSway(const std::vector<BranchBeam>& beams, const SwayOptions& options, double step,
  const Vector3& middle, const WindAtPlace& wind, const ParallelFor& parallelFor)
  : Step(step)
  , Shared(options.Response == SwayResponse::Interpolated)
{
  // A beam along `axis` in a load per length f: amplitude at rest = mean of the shape x f across / (m w^2).
  const double unitDrag = 0.5 * options.Load.AirDensity * options.Load.DragCoefficient;
  std::vector<double> frequencies;
  for (const BranchBeam& beam : beams)
  {
    for (int mode = 1; mode <= options.NumberOfModes; ++mode)
    {
      const double frequency = AngularFrequency(beam.Beam, mode);
      const double give = MeanShape(mode) / (beam.Beam.MassPerLength * frequency * frequency);
      const Vector3 weight = options.Gravity ? WeightPerLength(beam.Beam.MassPerLength) : Vector3(0.0);
      this->Motions.push_back({ beam.Axis, give * AcrossBeam(weight, beam.Axis), give, 0, { 1.0, 0.0, 0.0, 0.0 } });
      frequencies.push_back(std::min(frequency, FastestAngle / step));
      if (options.Response == SwayResponse::Interpolated)
      {
        this->Motions.back().Gain *= unitDrag * beam.DragDiameter;
      }
    }
  }
  if (options.Response == SwayResponse::Direct)
  {
    this->TabulateEach(beams, options, wind, parallelFor);
    return;
  }
  const std::vector<double> columns = FrequenciesOver(frequencies);
  for (std::size_t i = 0; i < this->Motions.size() && columns.size() > 1; ++i)
  {
    const double place =
      (MostColumns - 1) * std::log(frequencies[i] / columns.front()) / std::log(columns.back() / columns.front());
    Motion& motion = this->Motions[i];
    motion.Column = std::clamp(static_cast<int>(place) - 1, 0, MostColumns - 4);
    motion.Weights = CubicWeights(place - motion.Column);
  }
  std::vector<Vector3> velocities;
  wind(middle, velocities);
  this->TabulateOrthogonal(columns, options.Wood.DampingRatio, velocities, parallelFor);
}

double PlantSway::TableBytes(std::size_t branches, const SwayOptions& options, std::size_t samples)
{
  const double columns =
    options.Response == SwayResponse::Direct ? double(branches) * options.NumberOfModes : MostColumns;
  return columns * static_cast<double>(samples) * sizeof(Triple);
}

void PlantSway::Store(std::size_t column, const std::vector<Vector3>& series)
{
  for (std::size_t sample = 0; sample < series.size(); ++sample)
  {
    const Vector3& value = series[sample];
    this->Table[sample * this->Columns + column] = { static_cast<float>(value.x), static_cast<float>(value.y),
      static_cast<float>(value.z) };
  }
}

void PlantSway::TabulateOrthogonal(const std::vector<double>& frequencies, double damping,
  const std::vector<Vector3>& wind, const ParallelFor& parallelFor)
{
  this->Samples = wind.size();
  this->Columns = std::max<std::size_t>(4, frequencies.size()); // four are read, of weight zero where there is one
  this->Table.assign(this->Samples * this->Columns, Triple{});
  parallelFor(frequencies.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t column = begin; column < end; ++column)
    {
      // Half the sum of the responses of beams along x, y and z is the response to all of the load, since each has
      // two of its three components.
      const double square = frequencies[column] * frequencies[column];
      std::vector<Vector3> load(wind.size());
      std::transform(wind.begin(), wind.end(), load.begin(),
        [=](const Vector3& velocity) { return square * glm::length(velocity) * velocity; });
      this->Store(column, PeriodicResponse({ frequencies[column], damping }, this->Step, load));
    }
  });
}

void PlantSway::TabulateEach(const std::vector<BranchBeam>& beams, const SwayOptions& options, const WindAtPlace& wind,
  const ParallelFor& parallelFor)
{
  std::vector<Vector3> first;
  wind(beams.front().Middle, first);
  this->Samples = first.size();
  this->Columns = this->Motions.size();
  this->Table.assign(this->Samples * this->Columns, Triple{});
  const auto modes = static_cast<std::size_t>(options.NumberOfModes);
  parallelFor(beams.size(), [&](std::size_t begin, std::size_t end) {
    std::vector<Vector3> load;
    for (std::size_t branch = begin; branch < end; ++branch)
    {
      const BranchBeam& beam = beams[branch];
      wind(beam.Middle, load);
      for (Vector3& value : load)
      {
        value = DragPerLength(options.Load, beam.Axis, beam.DragDiameter, value) +
          LiftPerLength(options.Load, beam.Axis, beam.DragDiameter, value);
      }
      for (std::size_t mode = 0; mode < modes; ++mode)
      {
        const double frequency =
          std::min(AngularFrequency(beam.Beam, static_cast<int>(mode) + 1), FastestAngle / this->Step);
        std::vector<Vector3> series = PeriodicResponse({ frequency, options.Wood.DampingRatio }, this->Step, load);
        for (Vector3& value : series)
        {
          value *= frequency * frequency;
        }
        this->Motions[branch * modes + mode].Column = static_cast<int>(branch * modes + mode);
        this->Store(branch * modes + mode, series);
      }
    }
  });
}

void PlantSway::Amplitudes(double time, Vector3* amplitudes) const
{
  const SeriesPlace place(time, this->Step, this->Samples);
  const auto read = [&](std::size_t column) {
    Vector3 sum(0.0);
    for (int i = 0; i < 4; ++i)
    {
      const Triple& value = this->Table[place.Samples[i] * this->Columns + column];
      sum += place.Weights[i] * Vector3(value[0], value[1], value[2]);
    }
    return sum;
  };
  std::array<Vector3, MostColumns> shared;
  for (std::size_t column = 0; this->Shared && column < this->Columns; ++column)
  {
    shared[column] = read(column);
  }
  for (std::size_t i = 0; i < this->Motions.size(); ++i)
  {
    const Motion& motion = this->Motions[i];
    Vector3 response(0.0);
    for (int tap = 0; this->Shared && tap < 4; ++tap)
    {
      response += motion.Weights[tap] * shared[motion.Column + tap];
    }
    if (!this->Shared)
    {
      response = read(motion.Column);
    }
    amplitudes[i] = motion.Rest + motion.Gain * AcrossBeam(response, motion.Axis);
  }
}

}
