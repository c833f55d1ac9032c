// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sway/PlantSway.h"

#include "Numerics/Constants.h"
#include "Sway/BeamResponse.h"
#include "Sway/OscillatorBank.h"
#include "Sway/PlantMotion.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace littoral
{

namespace
{

/// Frequencies that are tabulated for eq. 25, in equal ratios; where there are fewer motions, each has its own.
constexpr int MostColumns = 128;

/// Samples that are tabulated at a time, and those that a reader between samples needs besides.
constexpr long long WindowSamples = 32;
constexpr std::size_t TableRows = WindowSamples + SeriesTaps - 1;
/// The wind comes at half steps, where its fastest waves have four samples and the reader loses none of them.
constexpr std::size_t WindRows = 2 * WindowSamples + SeriesTaps;
/// Half steps from the first row of the wind to this one of the table: SeriesBefore half steps before the first to be
/// read.
constexpr long long WindMargin = SeriesBefore - SeriesBefore / 2;

/// Frequencies above this, times the wind's step, follow the load at once.
constexpr double FastestAngle = 30.0;

/// Mass [kg] and drag area, that of a bare cylinder [m2], of a branch with all that it carries.
struct CarriedLoad
{
  double Mass = 0.0;
  double Area = 0.0;
};

/// Stiffness, mass and drag of a tapered branch.
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
  double compliance = 0.0;
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
      // integral of 4 (1 - s)^3 / R^4 over the step
      compliance += (std::pow(low, 4) - std::pow(high, 4)) / std::pow(radius, 4);
      taper.MeanRadius += width * radius;
      taper.MeanSquare += width * radius * radius;
    }
  }
  taper.BendingRadius = std::pow(compliance, -0.25);
  return taper;
}

/// A twig that grew is thick enough for its leaves: grown skeletons have a few that are not, and would hang like
/// threads. The radius [m] from which the tip sags by no more than a part of the length, in branches of the usual
/// modulus.
double MinimumRadius(const RoundBeam& beam)
{
  constexpr double MaximumSag = 0.2;
  const double UsualModulus = BranchModulus * WoodParameters().YoungModulus;
  // q L^4 / (8 E I) = MaximumSag L, I = pi R^4 / 4
  const double weight = glm::length(WeightPerLength(beam.MassPerLength));
  const double least = weight * std::pow(beam.Length, 3) / (8.0 * UsualModulus * MaximumSag);
  return std::pow(least / SecondMoment(1.0), 0.25);
}

/// Marks of the branches that carry others.
std::vector<char> Carriers(const Skeleton& skeleton)
{
  std::vector<char> carriers(skeleton.Branches.size(), 0);
  for (std::size_t branch = 1; branch < carriers.size(); ++branch)
  {
    carriers[skeleton.Nodes[skeleton.Nodes[skeleton.Branches[branch].First].Parent].Branch] = 1;
  }
  return carriers;
}

/// Drag of an area of leaves as part of that of a bare cylinder's.
double LeafPart(const SwayOptions& options)
{
  return options.Load.DragCoefficient > 0.0 ? options.LeafDrag / options.Load.DragCoefficient : 0.0;
}

/// Adds leaves to their branches, then branches, from the twigs down, to those that carry them.
void AddCarried(const Skeleton& skeleton, const std::vector<double>& leafAreas, const SwayOptions& options,
  std::vector<CarriedLoad>& loads)
{
  const double leafPart = LeafPart(options);
  for (std::size_t node = 0; node < leafAreas.size(); ++node)
  {
    CarriedLoad& load = loads[skeleton.Nodes[node].Branch];
    load.Mass += options.LeafMass * leafAreas[node];
    load.Area += leafPart * leafAreas[node];
  }
  for (int branch = static_cast<int>(loads.size()) - 1; branch >= 0; --branch)
  {
    const int parent = skeleton.Nodes[skeleton.Branches[branch].First].Parent;
    if (parent >= 0)
    {
      CarriedLoad& below = loads[skeleton.Nodes[parent].Branch];
      below.Mass += loads[branch].Mass;
      below.Area += loads[branch].Area;
    }
  }
}

/// A mode of a beam: its own, or the uniform cantilever's.
TrunkMode ModeOf(const BranchBeam& beam, int mode)
{
  return beam.Modes.empty()
    ? TrunkMode{ AngularFrequency(beam.Beam, mode), MeanShape(mode) / beam.Beam.MassPerLength, MeanShape(mode), {} }
    : beam.Modes[mode - 1];
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
  const std::vector<double> areas = FedLeafAreas(skeleton, leafAreas, options.LeafAreaRatio);
  std::vector<BranchBeam> beams(skeleton.Branches.size());
  std::vector<CarriedLoad> loads(beams.size());
  for (int branch = 0; branch < static_cast<int>(beams.size()); ++branch)
  {
    BranchBeam& beam = beams[branch];
    beam.Axis = BranchAxis(skeleton, branch);
    beam.Beam.Length = skeleton.BranchLength(branch);
    const Taper taper = TaperOf(skeleton, skeleton.Branches[branch], beam.Beam.Length);
    beam.Beam.Radius = taper.BendingRadius;
    beam.Beam.YoungModulus = BranchModulus * options.Wood.YoungModulus;
    loads[branch].Mass = options.Wood.Density * Pi * taper.MeanSquare * beam.Beam.Length;
    loads[branch].Area = 2.0 * taper.MeanRadius * beam.Beam.Length;
  }
  if (options.Carries)
  {
    AddCarried(skeleton, areas, options, loads);
  }
  beams.front() = TrunkBeam(MeasureTrunk(skeleton, areas, options.Carries), 1.0, 0.0, options);
  const std::vector<char> carriers = Carriers(skeleton);
  for (int branch = 0; branch < static_cast<int>(beams.size()); ++branch)
  {
    BranchBeam& beam = beams[branch];
    int node = 0;
    beam.Middle = skeleton.Along(branch, 0.5, node);
    if (branch > 0)
    {
      beam.Beam.MassPerLength = loads[branch].Mass / beam.Beam.Length;
      beam.DragDiameter = loads[branch].Area / beam.Beam.Length; // the outer ones have no lee
    }
    if (options.Carries && branch > 0 && !carriers[branch])
    {
      beam.Beam.Radius = std::max(beam.Beam.Radius, MinimumRadius(beam.Beam));
    }
  }
  return beams;
}

BranchBeam TrunkBeam(const TrunkMeasures& trunk, double scale, double azimuth, const SwayOptions& options)
{
  const double leafPart = LeafPart(options);
  const double c = std::cos(azimuth);
  const double s = std::sin(azimuth);
  BranchBeam beam;
  beam.Axis = { c * trunk.Axis.x - s * trunk.Axis.y, s * trunk.Axis.x + c * trunk.Axis.y, trunk.Axis.z };
  beam.Beam.Length = scale * trunk.Length;
  beam.Beam.Radius = scale * trunk.BendingRadius;
  beam.Beam.YoungModulus = options.Wood.YoungModulus;
  const double mass = options.Wood.Density * scale * trunk.Wood.Amount + options.LeafMass * trunk.Leaves.Amount;
  beam.Beam.MassPerLength = scale * scale * mass / beam.Beam.Length;
  beam.DragDiameter = scale * scale * (trunk.Wood.Area + leafPart * trunk.Leaves.Area) / beam.Beam.Length;
  const auto modes = ModesOf(
    trunk, scale, { options.Wood.YoungModulus, options.Wood.Density, options.LeafMass, leafPart, options.Carries });
  beam.Modes.assign(modes.begin(), modes.begin() + options.NumberOfModes);
  return beam;
}

PlantSway::PlantSway(const std::vector<BranchBeam>& beams, const SwayOptions& options, const WindTimes& times,
  const Vector3& middle, const WindAtPlace& wind)
  : Times(times)
  , Middle(middle)
  , WindAt(wind)
  , Load(options.Load)
  , Damping(options.Wood.DampingRatio)
  , Beams(options.Response == SwayResponse::Direct ? beams : std::vector<BranchBeam>())
  , Offset(static_cast<std::size_t>(std::abs(std::floor(middle.x + 3.0 * middle.y))) % WindowSamples)
{
  // A beam along `axis` in a load per length f: amplitude at rest = mean of the shape x f across / (m w^2), and a
  // trunk's by its own modes.
  const double unitDrag = 0.5 * options.Load.AirDensity * options.Load.DragCoefficient;
  const double unitLift = 0.5 * options.Load.AirDensity * options.Load.LiftCoefficient;
  std::vector<double> frequencies;
  for (const BranchBeam& beam : beams)
  {
    for (int mode = 1; mode <= options.NumberOfModes; ++mode)
    {
      const TrunkMode own = ModeOf(beam, mode);
      // eqs. 21 to 23 at rest: Y = P / (M w^2)
      const double frequency = own.Frequency;
      const double squared = frequency * frequency;
      const double compliance = own.Load / squared;
      const Vector3 weight = options.Gravity ? WeightPerLength(own.Weight / squared) : Vector3(0.0);
      this->Motions.push_back({ beam.Axis, AcrossBeam(weight, beam.Axis), compliance, 0.0,
        static_cast<int>(frequencies.size()), { 1.0, 0.0, 0.0, 0.0 } });
      frequencies.push_back(std::min(frequency, FastestAngle / times.Step));
      if (options.Response == SwayResponse::Interpolated)
      {
        this->Motions.back().Gain = compliance * unitDrag * beam.DragDiameter;
        this->Motions.back().Lift = compliance * unitLift * beam.DragDiameter;
      }
    }
  }
  this->TakeColumns(frequencies);
  this->Now.resize(3 * this->Frequencies.size());
}

void PlantSway::TakeColumns(const std::vector<double>& frequencies)
{
  this->Frequencies = frequencies;
  if (!this->Beams.empty())
  {
    return;
  }
  if (frequencies.size() <= MostColumns) // in ascending order
  {
    std::vector<int> order(frequencies.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return frequencies[a] < frequencies[b]; });
    for (std::size_t column = 0; column < order.size(); ++column)
    {
      this->Motions[order[column]].Column = static_cast<int>(column);
    }
    std::sort(this->Frequencies.begin(), this->Frequencies.end());
    return;
  }
  this->Frequencies = FrequenciesOver(frequencies);
  if (this->Frequencies.size() == 1)
  {
    std::for_each(this->Motions.begin(), this->Motions.end(), [](Motion& motion) { motion.Column = 0; });
    return;
  }
  this->Taps = 4;
  const double span = std::log(this->Frequencies.back() / this->Frequencies.front());
  for (std::size_t i = 0; i < this->Motions.size(); ++i)
  {
    const double place = (MostColumns - 1) * std::log(frequencies[i] / this->Frequencies.front()) / span;
    Motion& motion = this->Motions[i];
    motion.Column = std::clamp(static_cast<int>(place) - 1, 0, MostColumns - 4);
    motion.Weights = CubicWeights(place - motion.Column);
  }
}

double PlantSway::BytesOf(std::size_t branches, const SwayOptions& options)
{
  const double motions = static_cast<double>(branches) * options.NumberOfModes;
  const bool direct = options.Response == SwayResponse::Direct;
  const double columns = direct ? motions : std::min<double>(motions, MostColumns);
  return columns * (3.0 * TableRows * sizeof(float) + 4.0 * sizeof(double)) + motions * sizeof(Motion) +
    WindRows * sizeof(Vector3) + (direct ? static_cast<double>(branches) * sizeof(BranchBeam) : 0.0);
}

void PlantSway::Tabulate(long long first)
{
  this->Table.resize(3 * TableRows * this->Frequencies.size());
  if (this->Beams.empty())
  {
    this->TabulateShared(first);
    return;
  }
  std::array<Vector3, WindRows / 2> winds;
  this->WindAt(this->Middle, static_cast<double>(first + WindMargin), winds.size(), winds.data());
  this->TabulateWind(first, winds.data());
  for (std::size_t branch = 0; branch < this->Beams.size(); ++branch)
  {
    this->TabulateBranch(branch, first);
  }
}

/// The wind at half steps; that at whole ones is known, from WindMargin after the first on.
void PlantSway::TabulateWind(long long first, const Vector3* whole)
{
  std::array<Vector3, WindRows / 2> between;
  this->WindAt(this->Middle, static_cast<double>(first + WindMargin) - 0.5, between.size(), between.data());
  this->Winds.clear();
  for (std::size_t row = 0; row < between.size(); ++row)
  {
    this->Winds.push_back(between[row]);
    this->Winds.push_back(whole[row]);
  }
}

void PlantSway::TabulateShared(long long first)
{
  // Slow columns settle later and begin earlier; one that takes longer than a period is settled after one.
  const std::size_t columns = this->Frequencies.size();
  std::vector<std::size_t> leads;
  for (const double frequency : this->Frequencies)
  {
    leads.push_back(std::min(this->Times.Samples, SettlingSteps({ frequency, this->Damping }, this->Times.Step)));
  }
  const std::size_t longest = leads.front();
  std::vector<Vector3> load(longest + TableRows + 2 * LoadMargin);
  this->WindAt(
    this->Middle, static_cast<double>(first) - static_cast<double>(longest + LoadMargin), load.size(), load.data());
  this->TabulateWind(first, &load[longest + LoadMargin + WindMargin]);
  // eq. 25, halved: half the sum of the responses of beams along x, y and z is the response to |U| U, since each has
  // two of its three components.
  std::transform(
    load.begin(), load.end(), load.begin(), [](const Vector3& velocity) { return glm::length(velocity) * velocity; });
  load = SharpLoad(load);
  OscillatorBank bank(this->Frequencies, this->Damping, this->Times.Step);
  std::size_t active = 0;
  for (std::size_t sample = 0; sample < longest; ++sample)
  {
    while (active < columns && leads[active] >= longest - sample)
    {
      ++active;
    }
    bank.Advance(active, load[sample], load[sample + 1]);
  }
  for (std::size_t column = 0; column < columns && leads[column] == this->Times.Samples; ++column)
  {
    bank.Settle(column, this->Times.Samples);
  }
  for (std::size_t row = 0; row < TableRows; ++row)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      std::copy_n(bank.Displacements(axis), columns, &this->Table[(3 * row + axis) * columns]);
    }
    if (row + 1 < TableRows)
    {
      bank.Advance(columns, load[longest + row], load[longest + row + 1]);
    }
  }
}

void PlantSway::TabulateBranch(std::size_t branch, long long first)
{
  const BranchBeam& beam = this->Beams[branch];
  const std::size_t columns = this->Frequencies.size();
  const std::size_t modes = columns / this->Beams.size();
  for (std::size_t column = branch * modes; column < (branch + 1) * modes; ++column)
  {
    const Oscillator oscillator{ this->Frequencies[column], this->Damping };
    const std::size_t lead = std::min(this->Times.Samples, SettlingSteps(oscillator, this->Times.Step));
    std::vector<Vector3> load(lead + TableRows + 2 * LoadMargin);
    this->WindAt(
      beam.Middle, static_cast<double>(first) - static_cast<double>(lead + LoadMargin), load.size(), load.data());
    for (Vector3& value : load)
    {
      value = DragPerLength(this->Load, beam.Axis, beam.DragDiameter, value) +
        LiftPerLength(this->Load, beam.Axis, beam.DragDiameter, value);
    }
    load = SharpLoad(load);
    OscillatorBank one({ oscillator.Frequency }, this->Damping, this->Times.Step);
    for (std::size_t sample = 0; sample + 1 < load.size(); ++sample)
    {
      if (sample == lead && lead == this->Times.Samples)
      {
        one.Settle(0, lead);
      }
      for (std::size_t axis = 0; axis < 3 && sample >= lead; ++axis)
      {
        this->Table[(3 * (sample - lead) + axis) * columns + column] = static_cast<float>(*one.Displacements(axis));
      }
      one.Advance(1, load[sample], load[sample + 1]);
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Table[(3 * (TableRows - 1) + axis) * columns + column] = static_cast<float>(*one.Displacements(axis));
    }
  }
}

/// Index of a sample in its window, which is tabulated unless the table holds it.
long long PlantSway::Follow(long long sample)
{
  const long long at = (sample + static_cast<long long>(this->Offset)) % static_cast<long long>(this->Times.Samples);
  const long long window = at / WindowSamples;
  if (window != this->Window)
  {
    this->Tabulate(window * WindowSamples - static_cast<long long>(this->Offset) - SeriesBefore);
    this->Window = window;
  }
  return at - window * WindowSamples;
}

void PlantSway::Amplitudes(double time, Vector3* amplitudes)
{
  const SeriesPlace place(time, this->Times.Step, this->Times.Samples);
  const auto at = static_cast<std::size_t>(this->Follow(static_cast<long long>(place.Samples[SeriesBefore])));
  const std::size_t columns = this->Frequencies.size();
  const float* rows = &this->Table[3 * columns * at];
  for (std::size_t i = 0; i < 3 * columns; ++i)
  {
    this->Now[i] = place.Weights[0] * rows[i];
  }
  for (std::size_t tap = 1; tap < SeriesTaps; ++tap)
  {
    for (std::size_t i = 0; i < 3 * columns; ++i)
    {
      this->Now[i] += place.Weights[tap] * rows[3 * columns * tap + i];
    }
  }
  const double* now = this->Now.data();
  for (std::size_t i = 0; i < this->Motions.size(); ++i)
  {
    const Motion& motion = this->Motions[i];
    Vector3 response(0.0);
    for (int tap = 0; tap < this->Taps; ++tap)
    {
      const double* value = now + motion.Column + tap;
      response += motion.Weights[tap] * Vector3(value[0], value[columns], value[2 * columns]);
    }
    // eq. 25, halved: the response across the beam
    amplitudes[i] = motion.Rest + motion.Gain * AcrossBeam(response, motion.Axis);
    if (motion.Lift != 0.0) // linear in the load as well: to the side of wind x axis
    {
      amplitudes[i] += motion.Lift * glm::cross(response, motion.Axis);
    }
  }
}

Vector3 PlantSway::Wind(double time)
{
  const SeriesPlace place(time, 0.5 * this->Times.Step, 2 * this->Times.Samples);
  const auto sample = static_cast<long long>(place.Samples[SeriesBefore]);
  const long long row = 2 * this->Follow(sample / 2) + sample % 2;
  Vector3 wind(0.0);
  for (std::size_t tap = 0; tap < SeriesTaps; ++tap)
  {
    wind += place.Weights[tap] * this->Winds[static_cast<std::size_t>(row) + tap];
  }
  return wind;
}

}
