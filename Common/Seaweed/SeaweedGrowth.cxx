// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Seaweed/SeaweedGrowth.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Numerics/RandomStream.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace littoral
{

namespace
{

constexpr double GoldenAngle = 2.39996322972865332; // spreads fronds evenly [rad]
constexpr int LeavesOfShoot = 4;
constexpr double FirstBlade = 0.08; // part of a stipe below its blades
constexpr double MostBlades = 20000;

Vector3 Direction(double tilt, double azimuth)
{
  return { std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth), std::cos(tilt) };
}

/// A unit vector at a right angle to a direction, level but for a roll about the direction.
Vector3 AcrossOf(const Vector3& direction, double azimuth, double roll)
{
  const Vector3 level{ -std::sin(azimuth), std::cos(azimuth), 0.0 };
  const Vector3 flat = glm::normalize(level - glm::dot(level, direction) * direction);
  return std::cos(roll) * flat + std::sin(roll) * glm::cross(direction, flat);
}

/// Segments in a row, before they are a branch.
struct SegmentRun
{
  std::vector<Vector3> Steps; // from node to node [m]
  std::vector<SeaweedSegment> Segments;

  void Add(const Vector3& step, const SeaweedSegment& segment)
  {
    this->Steps.push_back(step);
    this->Segments.push_back(segment);
  }
};

/// Attitude of a blade in the water: its tilt at foot and tip, and its turns about the vertical and about itself [rad].
struct BladeCourse
{
  double TiltAtFoot = 0.0;
  double TiltAtTip = 0.0;
  double Azimuth = 0.0;
  double Turn = 0.0;
  double Roll = 0.0;
  double Twist = 0.0;
};

class Grower
{
public:
  explicit Grower(const SeaweedParameters& parameters)
    : P(parameters)
    , OfFronds(parameters.Seed, RandomPurpose::SeaweedFronds)
    , OfBlades(parameters.Seed, RandomPurpose::SeaweedBlades)
  {
    this->Result.Parameters = parameters;
  }

  Seaweed Run()
  {
    if (this->P.Form == SeaweedForm::Meadow)
    {
      this->GrowRhizome();
    }
    else
    {
      this->GrowHoldfast();
    }
    for (int frond = 0; frond < this->P.NumberOfFronds; ++frond)
    {
      if (this->P.Form == SeaweedForm::Canopy)
      {
        this->GrowStipe(frond);
      }
      else
      {
        this->GrowFrond(frond);
      }
    }
    return std::move(this->Result);
  }

private:
  const SeaweedParameters& P;
  RandomStream OfFronds;
  RandomStream OfBlades;
  Seaweed Result;

  /// A factor of mean 1, never far from it.
  double Vary(double deviate) const { return std::max(0.3, 1.0 + this->P.Variation * std::clamp(deviate, -2.0, 2.0)); }

  SeaweedSegment Material(SeaweedTissue tissue, double width, double thickness) const
  {
    SeaweedSegment segment;
    segment.Tissue = tissue;
    segment.Width = width;
    segment.Thickness = std::min(thickness, width);
    const bool flat = tissue == SeaweedTissue::Blade;
    segment.YoungModulus = flat ? this->P.BladeModulus : this->P.StipeModulus;
    segment.DampingRatio = this->P.DampingRatio;
    segment.Density = tissue == SeaweedTissue::Float ? this->P.FloatDensity
      : flat                                         ? this->P.BladeDensity
                                                     : this->P.StipeDensity;
    return segment;
  }

  SeaweedSegment RoundSegment(SeaweedTissue tissue, double radius, const Vector3& along) const
  {
    SeaweedSegment segment = this->Material(tissue, 2.0 * radius, 2.0 * radius);
    segment.Across = Perpendicular(glm::normalize(along));
    return segment;
  }

  int AddBranch(int parent, Vector3 foot, const SegmentRun& run)
  {
    Skeleton& wood = this->Result.Wood;
    const int branch = wood.StartBranch(parent, foot, EquivalentRadius(run.Segments.front()));
    this->Result.Segments.push_back(run.Segments.front());
    for (std::size_t step = 0; step < run.Steps.size(); ++step)
    {
      const SeaweedSegment& next = run.Segments[std::min(step + 1, run.Segments.size() - 1)];
      foot += run.Steps[step];
      wood.Grow(foot, EquivalentRadius(next));
      this->Result.Segments.push_back(next);
    }
    return branch;
  }

  /// A stub that the stipes rise from.
  void GrowHoldfast()
  {
    const Vector3 up{ 0.0, 0.0, 0.5 * this->P.HoldfastRadius };
    SegmentRun run;
    run.Add(up, this->RoundSegment(SeaweedTissue::Holdfast, 0.4 * this->P.HoldfastRadius, up));
    this->AddBranch(-1, { 0.0, 0.0, 0.0 }, run);
  }

  int NumberOfShoots() const { return (this->P.NumberOfFronds + LeavesOfShoot - 1) / LeavesOfShoot; }

  /// A spiral on the ground with a node for each shoot, so that shoots stand evenly in the patch.
  void GrowRhizome()
  {
    const int shoots = this->NumberOfShoots();
    const double start = TwoPi * this->OfFronds.UniformPair(0, 20)[0];
    const auto place = [&](int shoot) {
      const double part = std::sqrt(static_cast<double>(shoot) / std::max(1, shoots));
      const double angle = start + 3.5 * std::sqrt(static_cast<double>(shoot));
      const auto jitter = this->OfFronds.UniformPair(static_cast<std::uint64_t>(shoot), 21);
      const double off = shoot == 0 ? 0.0 : 0.25 * this->P.HoldfastRadius / std::sqrt(static_cast<double>(shoots));
      return this->P.HoldfastRadius * part * Vector3(std::cos(angle), std::sin(angle), 0.0) +
        off * Vector3(2.0 * jitter[0] - 1.0, 2.0 * jitter[1] - 1.0, 0.0);
    };
    SegmentRun run;
    for (int shoot = 0; shoot < shoots; ++shoot)
    {
      const Vector3 step = place(shoot + 1) - place(shoot);
      run.Add(step, this->RoundSegment(SeaweedTissue::Holdfast, this->P.StipeRadius, step));
    }
    this->AddBranch(-1, { 0.0, 0.0, 0.0 }, run);
  }

  Color TintOf(double light, double warm) const
  {
    const double strength = std::clamp(1.0 + 0.1 * light, 0.75, 1.25);
    const double shift = std::clamp(0.05 * warm, -0.12, 0.12);
    const double gains[3] = { strength * (1.0 + shift), strength, strength * (1.0 - shift) };
    Color tint{};
    for (int channel = 0; channel < 3; ++channel)
    {
      tint[channel] = static_cast<unsigned char>(std::clamp(gains[channel] * this->P.Blade[channel], 0.0, 255.0));
    }
    return tint;
  }

  /// Adds the segments of a blade to a run.
  void AddBladeSegments(SegmentRun& run, int count, double length, double width, const BladeCourse& course) const
  {
    const std::vector<double> steps = BladeSteps(count);
    for (int step = 0; step < count; ++step)
    {
      const double part = 0.5 * (steps[step] + steps[step + 1]);
      const double tilt = course.TiltAtFoot + (course.TiltAtTip - course.TiltAtFoot) * std::pow(part, 1.4);
      const double azimuth = course.Azimuth + course.Turn * part;
      const Vector3 along = Direction(tilt, azimuth);
      SeaweedSegment segment =
        this->Material(SeaweedTissue::Blade, width * BladeProfile(this->P.Form, part), this->P.BladeThickness);
      segment.Across = AcrossOf(along, azimuth, course.Roll + course.Twist * part);
      run.Add((steps[step + 1] - steps[step]) * length * along, segment);
    }
  }

  void AddBlade(int branch, int firstStep, double length, double width, std::uint64_t index)
  {
    const auto tints = this->OfBlades.NormalPair(index, 10);
    const auto phase = this->OfBlades.UniformPair(index, 11);
    SeaweedBlade blade;
    blade.Branch = branch;
    blade.FirstStep = firstStep;
    blade.Length = length;
    blade.Width = width;
    blade.Ruffle = 0.5 * width * this->P.Ruffle;
    blade.Phase = TwoPi * phase[0];
    blade.Tint = this->TintOf(tints[0], tints[1]);
    this->Result.Blades.push_back(blade);
  }

  /// The node of the holdfast that carries a frond, and the place on it.
  Vector3 FootOf(int frond, int& node) const
  {
    if (this->P.Form == SeaweedForm::Meadow)
    {
      node = frond / LeavesOfShoot;
      return this->Result.Wood.Nodes[node].Position;
    }
    const double part = 0.4 + 0.6 * (frond + 0.5) / this->P.NumberOfFronds;
    return this->Result.Wood.Along(0, part, node);
  }

  double AzimuthOf(int frond) const
  {
    const auto draws = this->OfFronds.UniformPair(static_cast<std::uint64_t>(frond), 0);
    if (this->P.Form != SeaweedForm::Meadow)
    {
      const double start = TwoPi * this->OfFronds.UniformPair(0, 22)[0];
      return start + GoldenAngle * frond + this->P.Variation * (2.0 * draws[0] - 1.0);
    }
    // The leaves of a shoot stand in a fan.
    const double fan = TwoPi * this->OfFronds.UniformPair(static_cast<std::uint64_t>(frond / LeavesOfShoot), 23)[0];
    return fan + Pi * (frond % 2) + 0.7 * (2.0 * draws[0] - 1.0);
  }

  /// A stipe with a blade, or a leaf.
  void GrowFrond(int frond)
  {
    const auto id = static_cast<std::uint64_t>(frond);
    const auto sizes = this->OfFronds.NormalPair(id, 1);
    const auto tilts = this->OfFronds.UniformPair(id, 2);
    const auto turns = this->OfFronds.NormalPair(id, 3);
    const auto rolls = this->OfFronds.NormalPair(id, 4);
    const bool isLeaf = this->P.Form == SeaweedForm::Meadow;
    const double young = isLeaf ? 1.0 - 0.14 * (frond % LeavesOfShoot) : 1.0;
    const double bladeLength = this->P.BladeLength * young * this->Vary(sizes[0]);
    const double bladeWidth = this->P.BladeWidth * this->Vary(0.7 * sizes[1]);
    const double stipeLength = isLeaf ? 0.0 : this->P.StipeLength * this->Vary(sizes[1]);

    BladeCourse course;
    course.Azimuth = this->AzimuthOf(frond);
    course.TiltAtFoot = this->P.SpreadAngle * Degree * (0.35 + 1.3 * tilts[0]);
    course.TiltAtTip = course.TiltAtFoot + this->P.SpreadAngle * Degree * (0.4 + (isLeaf ? 5.0 : 2.6) * tilts[1]);
    course.Turn = (isLeaf ? 0.6 : 0.5) * std::clamp(turns[0], -2.0, 2.0);
    course.Roll = 0.25 * std::clamp(rolls[0], -2.0, 2.0);
    course.Twist = (isLeaf ? 0.9 : 0.6) * std::clamp(rolls[1], -2.0, 2.0);

    SegmentRun run;
    int stipeSegments = 0;
    if (stipeLength > 0.0)
    {
      const int all = this->P.SegmentsPerBranch;
      const double share = stipeLength / (stipeLength + bladeLength);
      stipeSegments = std::clamp(static_cast<int>(std::lround(all * share)), 1, all - 1);
    }
    for (int step = 0; step < stipeSegments; ++step)
    {
      // A stipe comes out of the holdfast sideways and rises.
      const double part = (step + 0.5) / stipeSegments;
      const double tilt = course.TiltAtFoot * (1.6 - 0.6 * part);
      const Vector3 along = stipeLength / stipeSegments * Direction(tilt, course.Azimuth);
      run.Add(along, this->RoundSegment(SeaweedTissue::Stipe, this->P.StipeRadius * (1.0 - 0.3 * part), along));
    }
    this->AddBladeSegments(run, this->P.SegmentsPerBranch - stipeSegments, bladeLength, bladeWidth, course);
    int node = 0;
    const Vector3 foot = this->FootOf(frond, node);
    const int branch = this->AddBranch(node, foot, run);
    this->AddBlade(branch, stipeSegments, bladeLength, bladeWidth, id);
  }

  /// A long stipe that leaves the holdfast sideways, rises and wanders about the vertical, with its blades.
  void GrowStipe(int frond)
  {
    const auto id = static_cast<std::uint64_t>(frond);
    const auto sizes = this->OfFronds.UniformPair(id, 1);
    const auto waves = this->OfFronds.UniformPair(id, 2);
    const double azimuth = this->AzimuthOf(frond);
    // The eldest is as long as can be; those that grow up follow it.
    const double length =
      this->P.StipeLength * (frond == 0 ? 1.0 : std::max(0.3, 1.0 - 2.0 * this->P.Variation * sizes[0]));
    const int count = this->P.SegmentsPerBranch;
    SegmentRun run;
    for (int step = 0; step < count; ++step)
    {
      const double part = (step + 0.5) / count;
      const double lean = this->P.SpreadAngle * Degree * std::exp(-7.0 * part);
      const double wander = 0.55 * this->P.Variation * std::sin(TwoPi * (1.7 * part + waves[0]));
      const Vector3 along = length / count *
        glm::normalize(Direction(lean, azimuth) +
          wander * Vector3(std::cos(azimuth + 5.0 * waves[1]), std::sin(azimuth + 5.0 * waves[1]), 0.0));
      run.Add(along, this->RoundSegment(SeaweedTissue::Stipe, this->P.StipeRadius * (1.0 - 0.5 * part), along));
    }
    int node = 0;
    const Vector3 foot = this->FootOf(frond, node);
    const int stipe = this->AddBranch(node, foot, run);
    const int blades = std::max(1, static_cast<int>((1.0 - FirstBlade) * length / this->P.BladeSpacing));
    for (int blade = 0; blade < blades; ++blade)
    {
      this->GrowBlade(stipe, FirstBlade + (1.0 - FirstBlade) * (blade + 1.0) / blades, blade, azimuth);
    }
  }

  /// A blade on a stipe, held up by a float. Blades stand in two rows that wind about the stipe.
  void GrowBlade(int stipe, double part, int rank, double start)
  {
    const auto id = static_cast<std::uint64_t>(this->Result.Blades.size());
    const auto sizes = this->OfBlades.NormalPair(id, 0);
    const auto angles = this->OfBlades.NormalPair(id, 1);
    const auto rolls = this->OfBlades.NormalPair(id, 2);
    // Blades unfold at the tip of a stipe and wither low down.
    const double age = std::min({ 1.0, 0.3 + 6.0 * (1.0 - part), 0.65 + 1.2 * part });
    const double length = this->P.BladeLength * age * this->Vary(sizes[0]);
    const double width = this->P.BladeWidth * std::sqrt(age) * this->Vary(0.7 * sizes[1]);

    BladeCourse course;
    course.Azimuth = start + Pi * rank + 0.5 * rank + 2.0 * this->P.Variation * std::clamp(angles[0], -2.0, 2.0);
    course.TiltAtFoot = (58.0 - 22.0 * part) * Degree * this->Vary(angles[1]);
    course.TiltAtTip = course.TiltAtFoot + (48.0 - 25.0 * part) * Degree * this->Vary(rolls[0]);
    course.Turn = 0.35 * std::clamp(rolls[0], -2.0, 2.0);
    course.Roll = 0.4 * std::clamp(rolls[1], -2.0, 2.0);
    course.Twist = 0.8 * std::clamp(angles[0], -2.0, 2.0);

    SegmentRun run;
    const double bladder = this->P.FloatRadius * std::sqrt(age);
    if (bladder > 0.0)
    {
      const Vector3 along = 5.0 * bladder * Direction(course.TiltAtFoot, course.Azimuth);
      run.Add(along, this->RoundSegment(SeaweedTissue::Float, bladder, along));
    }
    this->AddBladeSegments(run, std::max(2, this->P.SegmentsPerBranch / 4), length, width, course);
    int node = 0;
    const Vector3 foot = this->Result.Wood.Along(stipe, part, node);
    const int branch = this->AddBranch(node, foot, run);
    this->AddBlade(branch, bladder > 0.0 ? 1 : 0, length, width, id);
  }
};

// -------------------------------------------------------------------------------------------------------------------
// Presets: what differs from the defaults, which are those of a sugar kelp.

SeaweedParameters SugarKelp()
{
  return {};
}

SeaweedParameters GiantKelp()
{
  SeaweedParameters p;
  p.Form = SeaweedForm::Canopy;
  p.NumberOfFronds = 6;
  p.HoldfastRadius = 0.35;
  p.StipeLength = 14.0;
  p.StipeRadius = 0.008;
  p.BladeLength = 0.95;
  p.BladeWidth = 0.17;
  p.BladeThickness = 0.0008;
  p.BladeSpacing = 0.26;
  p.FloatRadius = 0.02;
  p.Ruffle = 0.22;
  p.SpreadAngle = 38.0;
  p.SegmentsPerBranch = 12;
  p.StipeModulus = 1.5e7;
  p.BladeModulus = 5e6;
  p.StipeDensity = 1040.0;
  p.BladeDensity = 1050.0;
  p.FloatDensity = 300.0;
  p.Variation = 0.2;
  p.Blade = { 182, 144, 52 };
  p.Stipe = { 150, 116, 50 };
  return p;
}

SeaweedParameters Eelgrass()
{
  SeaweedParameters p;
  p.Form = SeaweedForm::Meadow;
  p.NumberOfFronds = 36;
  p.HoldfastRadius = 0.2;
  p.StipeLength = 0.0;
  p.StipeRadius = 0.002;
  p.BladeLength = 0.75;
  p.BladeWidth = 0.008;
  p.BladeThickness = 0.0004;
  p.FloatRadius = 0.0;
  p.Ruffle = 0.0;
  p.SpreadAngle = 11.0;
  p.StipeModulus = 2e8;
  p.BladeModulus = 3e8;
  p.StipeDensity = 1000.0;
  p.BladeDensity = 800.0;
  p.Variation = 0.2;
  p.Blade = { 104, 152, 62 };
  p.Stipe = { 128, 112, 74 };
  return p;
}

/// Rows in the order of the enumeration.
constexpr SeaweedPresetTraits Presets[] = {
  { "Custom", SugarKelp },
  { "SugarKelp", SugarKelp },
  { "GiantKelp", GiantKelp },
  { "Eelgrass", Eelgrass },
};
static_assert(std::size(Presets) == NumberOfSeaweedPresets, "a row a preset");

}

const SeaweedPresetTraits& TraitsOf(SeaweedPreset preset)
{
  return Presets[static_cast<int>(preset)];
}

SeaweedParameters PresetParameters(SeaweedPreset preset)
{
  return TraitsOf(preset).Parameters();
}

std::string WhyInvalid(const SeaweedParameters& p)
{
  ParameterCheck check;
  check.Choice("Form", static_cast<int>(p.Form), 3);
  check.Count("NumberOfFronds", p.NumberOfFronds, 1, 500);
  check.Range("HoldfastRadius", p.HoldfastRadius, 0.001, 5.0, "m");
  check.Range("StipeLength", p.StipeLength, 0.0, 100.0, "m");
  check.Range("StipeRadius", p.StipeRadius, 0.0001, 0.5, "m");
  check.Range("BladeLength", p.BladeLength, 0.01, 20.0, "m");
  check.Range("BladeWidth", p.BladeWidth, 0.0005, 3.0, "m");
  check.Range("BladeThickness", p.BladeThickness, 0.00001, 0.1, "m");
  check.Range("BladeSpacing", p.BladeSpacing, 0.01, 20.0, "m");
  check.Range("FloatRadius", p.FloatRadius, 0.0, 0.2, "m");
  check.Range("Ruffle", p.Ruffle, 0.0, 1.0);
  check.Range("SpreadAngle", p.SpreadAngle, 0.0, 60.0, "degrees");
  check.Count("SegmentsPerBranch", p.SegmentsPerBranch, 2, 64);
  check.Range("StipeModulus", p.StipeModulus, 1e3, 1e12, "Pa");
  check.Range("BladeModulus", p.BladeModulus, 1e3, 1e12, "Pa");
  check.Range("DampingRatio", p.DampingRatio, 0.0, 10.0);
  check.Range("StipeDensity", p.StipeDensity, 50.0, 3000.0, "kg/m3");
  check.Range("BladeDensity", p.BladeDensity, 50.0, 3000.0, "kg/m3");
  check.Range("FloatDensity", p.FloatDensity, 50.0, 3000.0, "kg/m3");
  check.Range("Variation", p.Variation, 0.0, 0.5);
  if (p.Form == SeaweedForm::Canopy && check.IsGood())
  {
    check.Require(p.StipeLength >= p.BladeSpacing,
      "StipeLength is " + TextOf(p.StipeLength) + " m; the stipes of a Canopy are not shorter than BladeSpacing.");
    check.Require(p.NumberOfFronds * p.StipeLength / p.BladeSpacing <= MostBlades,
      "BladeSpacing is " + TextOf(p.BladeSpacing) + " m; stipes of that length would have more than 20000 blades.");
  }
  return check.Reason();
}

std::vector<double> BladeSteps(int count)
{
  constexpr double Growth = 1.6;
  constexpr int MostGraded = 5;
  const int graded = std::min(count / 2, MostGraded);
  std::vector<double> steps{ 0.0 };
  for (int step = 0; step < count; ++step)
  {
    steps.push_back(steps.back() + std::pow(Growth, std::min(step, graded)));
  }
  const double all = steps.back();
  for (double& step : steps)
  {
    step /= all;
  }
  return steps;
}

double BladeProfile(SeaweedForm form, double part)
{
  const double s = std::clamp(part, 0.0, 1.0);
  const auto rise = [s](double over) {
    const double left = 1.0 - std::min(1.0, s / over);
    return std::sqrt(1.0 - left * left);
  };
  const auto end = [s](double over) {
    const double beyond = std::max(0.0, s - (1.0 - over)) / over;
    return std::sqrt(std::max(0.0, 1.0 - beyond * beyond));
  };
  double width = 1.0;
  switch (form)
  {
    case SeaweedForm::Tuft:
      width = rise(0.3) * end(0.22) * (1.0 - 0.3 * s);
      break;
    case SeaweedForm::Canopy:
      width = rise(0.35) * std::pow(1.0 - s, 0.75) * 1.5;
      break;
    case SeaweedForm::Meadow:
      width = (0.75 + 0.25 * std::min(1.0, 4.0 * s)) * end(0.03);
      break;
  }
  return std::clamp(width, 0.06, 1.0);
}

Seaweed GrowSeaweed(const SeaweedParameters& parameters)
{
  return Grower(parameters).Run();
}

}
