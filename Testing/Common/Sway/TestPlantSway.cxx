// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/Constants.h"
#include "Plants/ReevesTree.h"
#include "Sway/BeamResponse.h"
#include "Sway/PlantMotion.h"
#include "Sway/PlantSway.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iterator>

using namespace littoral;

namespace
{

constexpr double Step = 0.05; // [s]
constexpr int Samples = 800;
const WindTimes Times{ Step, Samples };

/// A breeze with gusts along x, the same everywhere.
void Gusts(const Vector3&, double first, std::size_t count, Vector3* velocities)
{
  for (std::size_t k = 0; k < count; ++k)
  {
    const double t = TwoPi * std::fmod(std::fmod(first + static_cast<double>(k), Samples) + Samples, Samples) / Samples;
    velocities[k] = { 8.0 + 2.0 * std::sin(3.0 * t) + 1.5 * std::sin(31.0 * t + 1.0), 1.5 * std::cos(7.0 * t),
      0.6 * std::sin(19.0 * t) };
  }
}

void Calm(const Vector3&, double, std::size_t count, Vector3* velocities)
{
  std::fill_n(velocities, count, Vector3(0.0));
}

void Steady(const Vector3&, double, std::size_t count, Vector3* velocities)
{
  std::fill_n(velocities, count, Vector3(10.0, 0.0, 0.0));
}

Skeleton Oak()
{
  return GrowReevesTree(PresetParameters(TreePreset::Oak)).Wood;
}

std::vector<Vector3> AmplitudesAt(PlantSway& sway, std::size_t count, double time)
{
  std::vector<Vector3> amplitudes(count);
  sway.Amplitudes(time, amplitudes.data());
  return amplitudes;
}

double Difference(const std::vector<Vector3>& a, const std::vector<Vector3>& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    largest = std::max(largest, glm::distance(a[i], b[i]));
  }
  return largest;
}

}

TEST(PlantSway, NoWindNoAmplitude)
{
  const Skeleton oak = Oak();
  for (const SwayResponse response : { SwayResponse::Interpolated, SwayResponse::Direct })
  {
    SwayOptions options;
    options.Response = response;
    const auto beams = BeamsOf(oak, {}, options);
    PlantSway sway(beams, options, Times, Vector3(0.0), Calm);
    const PlantMotion motion(oak, 1);
    std::vector<JointPose> poses(oak.Nodes.size());
    motion.Pose(AmplitudesAt(sway, beams.size(), 3.21).data(), poses.data());
    const Skeleton moved = Moved(oak, poses);
    for (std::size_t node = 0; node < poses.size(); ++node)
    {
      ASSERT_EQ(std::memcmp(&moved.Nodes[node].Position, &oak.Nodes[node].Position, sizeof(Vector3)), 0);
    }
  }
}

TEST(PlantSway, SteadyWindBendsAMastByTheTextbook)
{
  Skeleton mast;
  mast.StartBranch(-1, { 0.0, 0.0, 0.0 }, 0.02);
  mast.Grow({ 0.0, 0.0, 3.0 }, 0.02);
  for (const SwayResponse response : { SwayResponse::Interpolated, SwayResponse::Direct })
  {
    SwayOptions options;
    options.Response = response;
    options.NumberOfModes = 5;
    options.Carries = false; // nor does its weight make it softer
    PlantSway sway(BeamsOf(mast, {}, options), options, Times, Vector3(0.0), Steady);
    const auto amplitudes = AmplitudesAt(sway, 5, 1.0);
    double tip = 0.0;
    for (int mode = 1; mode <= 5; ++mode)
    {
      tip += amplitudes[mode - 1].x * ModeShape(mode, 1.0);
    }
    const double load = 0.5 * 1.2 * 1.1 * 0.04 * 100.0;
    const double exact = load * std::pow(3.0, 4) / (8.0 * options.Wood.YoungModulus * SecondMoment(0.02));
    std::printf("tip in a wind of 10 m/s: %.6g m, %.8f of q L^4 / 8 E I\n", tip, tip / exact);
    EXPECT_NEAR(tip / exact, 1.0000147, 1e-6);
  }
}

TEST(PlantSway, InterpolatedEqualsDirectForSimilarBeams)
{
  // Twelve beams of one size in all directions: what eq. 25 was made for.
  SwayOptions options;
  options.Load.LiftCoefficient = -0.5;
  std::vector<BranchBeam> beams(12);
  for (int i = 0; i < 12; ++i)
  {
    beams[i].Axis = Normalised(Vector3(std::sin(1.0 + i), std::cos(2.3 * i), std::sin(0.7 * i)));
  }
  PlantSway interpolated(beams, options, Times, Vector3(0.0), Gusts);
  options.Response = SwayResponse::Direct;
  PlantSway direct(beams, options, Times, Vector3(0.0), Gusts);
  double largest = 0.0;
  double error = 0.0;
  for (int k = 0; k < 100; ++k)
  {
    const auto a = AmplitudesAt(interpolated, 12, 0.377 * k);
    const auto b = AmplitudesAt(direct, 12, 0.377 * k);
    error = std::max(error, Difference(a, b));
    largest = std::max(largest, Difference(b, std::vector<Vector3>(12, Vector3(0.0))));
  }
  std::printf("similar beams, interpolated against direct: %.3g of the largest amplitude\n", error / largest);
  EXPECT_LT(error / largest, 1e-6);
}

TEST(PlantSway, InterpolatedIsCloseForATree)
{
  const Skeleton oak = Oak();
  SwayOptions options;
  const auto beams = BeamsOf(oak, {}, options);
  PlantSway interpolated(beams, options, Times, Vector3(0.0), Gusts);
  options.Response = SwayResponse::Direct;
  PlantSway direct(beams, options, Times, Vector3(0.0), Gusts);
  double squares = 0.0;
  double errors = 0.0;
  for (int k = 0; k < 40; ++k)
  {
    const auto a = AmplitudesAt(interpolated, beams.size(), 0.977 * k);
    const auto b = AmplitudesAt(direct, beams.size(), 0.977 * k);
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      errors += glm::dot(a[i] - b[i], a[i] - b[i]);
      squares += glm::dot(b[i], b[i]);
    }
  }
  std::printf("a tree, tabulated frequencies against each branch's own: %.3g rms\n", std::sqrt(errors / squares));
  EXPECT_LT(std::sqrt(errors / squares), 0.005);
}

TEST(PlantSway, AnyTimeWithoutHistoryBitwise)
{
  const Skeleton oak = Oak();
  for (const SwayResponse response : { SwayResponse::Interpolated, SwayResponse::Direct })
  {
    SwayOptions options;
    options.Response = response;
    options.NumberOfModes = 2;
    const auto beams = BeamsOf(oak, {}, options);
    PlantSway one(beams, options, Times, Vector3(0.0), Gusts);
    PlantSway other(beams, options, Times, Vector3(0.0), Gusts);
    std::vector<std::vector<Vector3>> forward;
    for (int k = 0; k < 20; ++k)
    {
      forward.push_back(AmplitudesAt(one, 2 * beams.size(), 1.7 * k));
    }
    for (int k = 19; k >= 0; --k)
    {
      EXPECT_EQ(AmplitudesAt(other, 2 * beams.size(), 1.7 * k), forward[k]);
    }
    const double period = Samples * Step;
    EXPECT_LT(Difference(AmplitudesAt(one, 2 * beams.size(), 1.7 + period), forward[1]), 1e-9);
  }
}

TEST(PlantSway, StretchesOfTimeAreThePeriodicResponse)
{
  // A stretch starts from rest some time before; the whole period at once does not. Little damping reaches beyond it.
  std::vector<Vector3> wind(Samples + 2 * LoadMargin);
  Gusts(Vector3(0.0), -static_cast<double>(LoadMargin), wind.size(), wind.data());
  std::vector<Vector3> load;
  std::transform(wind.begin(), wind.end(), std::back_inserter(load),
    [](const Vector3& velocity) { return glm::length(velocity) * velocity; });
  load = SharpLoad(load);
  for (const double damping : { 0.3, 0.08, 0.004 })
  {
    for (const SwayResponse response : { SwayResponse::Interpolated, SwayResponse::Direct })
    {
      SwayOptions options;
      options.Response = response;
      options.Wood.DampingRatio = damping;
      const BranchBeam beam;
      PlantSway sway({ beam }, options, Times, Vector3(0.0), Gusts);
      const double frequency = AngularFrequency(beam.Beam, 1);
      std::vector<Vector3> exact = PeriodicResponse({ frequency, damping }, Step, load);
      const double gain = 0.5 * 1.2 * 1.1 * beam.DragDiameter * MeanShape(1) / beam.Beam.MassPerLength;
      double error = 0.0;
      double largest = 0.0;
      for (int k = 0; k < Samples; ++k)
      {
        const Vector3 wanted = gain * AcrossBeam(exact[k], beam.Axis);
        error = std::max(error, glm::distance(AmplitudesAt(sway, 1, k * Step)[0], wanted));
        largest = std::max(largest, glm::length(wanted));
      }
      std::printf("damping %g, response %d: stretches against the whole period %.3g\n", damping,
        static_cast<int>(response), error / largest);
      // single precision, of the whole load where that along the beam is taken away
      EXPECT_LT(error / largest, 1e-6);
    }
  }
}

TEST(PlantSway, NothingIsLostBetweenSteps)
{
  // A wind with waves of 1000 to 2.2 samples, the same size each: at any place between steps it is what it is, and a
  // branch so stiff that it follows its load swings with the same variance.
  constexpr int Count = 1000;
  const WindTimes times{ Step, Count };
  const auto wave = [](int k, double t) { return 0.3 * std::sin(TwoPi * k * t / Count + 1.7 * k * k); };
  const auto gusts = [&](const Vector3&, double first, std::size_t count, Vector3* velocities) {
    for (std::size_t n = 0; n < count; ++n)
    {
      const double t = first + static_cast<double>(n);
      velocities[n] = { 10.0, 0.0, 0.0 };
      for (const int k : { 1, 30, 101, 250, 333, 400, 451 })
      {
        velocities[n] += Vector3(wave(k, t), wave(k, t + 200.0), 0.5 * wave(k, t + 500.0));
      }
    }
  };
  PlantSway sway({ BranchBeam() }, {}, times, Vector3(3.0, 1.0, 0.0), gusts);
  double worst = 0.0;
  for (int part = 0; part < 16; ++part)
  {
    for (int n = 0; n < Count; n += 3)
    {
      Vector3 wants;
      gusts({}, n + part / 16.0, 1, &wants);
      worst = std::max(worst, glm::distance(sway.Wind((n + part / 16.0) * Step), wants));
    }
  }
  std::printf("wind of a plant between its steps: within %.3g m/s, of waves of 0.3 m/s\n", worst);
  EXPECT_LT(worst, 0.01);
}

TEST(PlantSway, LiftMovesToTheSide)
{
  // A mast in a steady wind along x: C_L / C_D of what drag does along x, to the right. A leaning one by either
  // response.
  for (const SwayResponse response : { SwayResponse::Interpolated, SwayResponse::Direct })
  {
    SwayOptions options;
    options.Response = response;
    options.Load.LiftCoefficient = 0.4;
    BranchBeam mast;
    PlantSway sway({ mast }, options, Times, Vector3(0.0), Steady);
    const Vector3 amplitude = AmplitudesAt(sway, 1, 2.0)[0];
    // Half the air's density, coefficient, diameter, square of the speed; over m w^2 and the shape's own mean.
    const double give = MeanShape(1) / (mast.Beam.MassPerLength * std::pow(AngularFrequency(mast.Beam, 1), 2.0));
    const double drag = 0.5 * 1.2 * 1.1 * mast.DragDiameter * 100.0 * give;
    EXPECT_NEAR(amplitude.x / drag, 1.0, 1e-6);
    EXPECT_NEAR(amplitude.y / drag, -0.4 / 1.1, 1e-6);
    EXPECT_NEAR(amplitude.z / drag, 0.0, 1e-6);
    mast.Axis = Normalised(Vector3(std::sqrt(0.75), 0.0, 0.5)); // half of the wind is across
    PlantSway leaning({ mast }, options, Times, Vector3(0.0), Steady);
    EXPECT_NEAR(AmplitudesAt(leaning, 1, 2.0)[0].y / drag, -0.5 * 0.4 / 1.1, 1e-6);
    // Without drag, lift alone.
    options.Load.DragCoefficient = 0.0;
    PlantSway alone({ BranchBeam() }, options, Times, Vector3(0.0), Steady);
    EXPECT_NEAR(AmplitudesAt(alone, 1, 2.0)[0].y / drag, -0.4 / 1.1, 1e-6);
    EXPECT_NEAR(AmplitudesAt(alone, 1, 2.0)[0].x, 0.0, 1e-12);
  }
}

TEST(PlantSway, MemoryDoesNotGrowWithTheWind)
{
  SwayOptions options;
  const double oak = PlantSway::BytesOf(300, options);
  options.Response = SwayResponse::Direct;
  const double direct = PlantSway::BytesOf(300, options);
  std::printf("responses of a plant of 300 branches: %.0f kB interpolated, %.0f kB direct\n", oak / 1e3, direct / 1e3);
  EXPECT_LT(oak, 1e5);
  EXPECT_LT(direct, 3e5);
}

TEST(PlantSway, TrunksOfScaledPlants)
{
  const Skeleton oak = Oak();
  std::vector<double> areas(oak.Nodes.size(), 0.02);
  const SwayOptions options;
  for (const double scale : { 0.7, 1.0, 1.3 })
  {
    Skeleton scaled = oak;
    for (SkeletonNode& node : scaled.Nodes)
    {
      node.Position = scale * Vector3(-node.Position.y, node.Position.x, node.Position.z);
      node.Radius *= scale;
    }
    std::vector<double> wide = areas;
    std::for_each(wide.begin(), wide.end(), [=](double& area) { area *= scale * scale; });
    const BranchBeam wanted = BeamsOf(scaled, wide, options)[0];
    const TrunkMeasures trunk = MeasureTrunk(oak, FedLeafAreas(oak, areas, options.LeafAreaRatio));
    const BranchBeam beam = TrunkBeam(trunk, scale, 0.25 * TwoPi, options);
    EXPECT_NEAR(beam.Beam.Length / wanted.Beam.Length, 1.0, 1e-12);
    EXPECT_NEAR(beam.Beam.Radius / wanted.Beam.Radius, 1.0, 1e-12);
    EXPECT_NEAR(beam.Beam.MassPerLength / wanted.Beam.MassPerLength, 1.0, 1e-12);
    EXPECT_NEAR(beam.DragDiameter / wanted.DragDiameter, 1.0, 1e-12);
    EXPECT_LT(glm::distance(beam.Axis, wanted.Axis), 1e-12);
    EXPECT_NEAR(beam.Modes[0].Frequency / wanted.Modes[0].Frequency, 1.0, 1e-9);
    EXPECT_NEAR(beam.Modes[0].Load / wanted.Modes[0].Load, 1.0, 1e-9);
  }
}

TEST(PlantSway, BranchesCarryWhatGrowsOnThem)
{
  const Skeleton oak = Oak();
  SwayOptions options;
  std::vector<double> areas(oak.Nodes.size(), 0.0);
  areas.back() = 5.0;
  options.LeafAreaRatio = 0.0;
  const auto loaded = BeamsOf(oak, areas, options);
  options.Carries = false;
  const auto bare = BeamsOf(oak, areas, options);
  double mass = options.LeafMass * 5.0;
  double area = options.LeafDrag / options.Load.DragCoefficient * 5.0;
  for (std::size_t branch = 1; branch < bare.size(); ++branch)
  {
    mass += bare[branch].Beam.MassPerLength * bare[branch].Beam.Length;
    area += bare[branch].DragDiameter * bare[branch].Beam.Length;
  }
  mass += bare[0].Beam.MassPerLength * bare[0].Beam.Length;
  area = CrownShelter * area + bare[0].DragDiameter * bare[0].Beam.Length;
  // Branches were measured in steps of their taper, and all on the trunk by its segments.
  EXPECT_NEAR(loaded[0].Beam.MassPerLength * loaded[0].Beam.Length / mass, 1.0, 1e-3);
  EXPECT_NEAR(loaded[0].DragDiameter * loaded[0].Beam.Length / area, 1.0, 1e-3);
  std::printf("trunk of an oak: bare %.3g Hz, loaded %.3g Hz\n", bare[0].Modes[0].Frequency / TwoPi,
    loaded[0].Modes[0].Frequency / TwoPi);
  EXPECT_LT(loaded[0].Modes[0].Frequency, bare[0].Modes[0].Frequency);
}

TEST(PlantSway, TaperedBranchesGiveAsTheirBeams)
{
  // A cone from R to R / 2: the integral of 4 (1 - s)^3 / R(s)^4 over the length by a fine sum.
  Skeleton mast;
  mast.StartBranch(-1, { 0.0, 0.0, 0.0 }, 0.2);
  for (int i = 1; i <= 50; ++i)
  {
    mast.Grow({ 0.0, 0.0, 0.1 * i }, 0.2 * (1.0 - 0.01 * i));
  }
  double give = 0.0;
  for (int i = 0; i < 100000; ++i)
  {
    const double s = (i + 0.5) / 100000;
    give += 4.0 * std::pow(1.0 - s, 3) / std::pow(0.2 * (1.0 - 0.5 * s), 4) / 100000;
  }
  const auto beams = BeamsOf(mast, {}, {});
  std::printf("cone from R to R/2: bends as a cylinder of %.5f R\n", beams[0].Beam.Radius / 0.2);
  EXPECT_NEAR(beams[0].Beam.Radius / std::pow(give, -0.25), 1.0, 1e-5);
  EXPECT_NEAR(beams[0].DragDiameter, 2.0 * 0.15, 1e-12);
  EXPECT_NEAR(beams[0].Beam.MassPerLength / (WoodParameters().Density * Pi * 0.04 * 7.0 / 12.0), 1.0, 1e-4);
}

TEST(PlantSway, NoTwigHangsLikeAThread)
{
  Skeleton plant;
  plant.StartBranch(-1, { 0.0, 0.0, 0.0 }, 0.001);
  plant.Grow({ 0.0, 0.0, 1.0 }, 0.001);
  plant.StartBranch(0, { 0.0, 0.0, 0.5 }, 0.001);
  plant.Grow({ 1.0, 0.0, 0.5 }, 0.001);
  plant.StartBranch(2, { 0.5, 0.0, 0.5 }, 0.001);
  plant.Grow({ 0.5, 1.0, 0.5 }, 0.001);
  SwayOptions options;
  options.LeafAreaRatio = 0.0;
  const auto beams = BeamsOf(plant, { 0.0, 0.0, 0.0, 0.0, 0.0, 1.0 }, options);
  const RoundBeam& twig = beams[2].Beam;
  const double sag = 9.80665 * twig.MassPerLength / (8.0 * twig.YoungModulus * SecondMoment(twig.Radius));
  EXPECT_EQ(twig.YoungModulus, BranchModulus * WoodParameters().YoungModulus);
  EXPECT_NEAR(sag, 0.2, 1e-9);
  // What carries others, and the trunk above all, is as thick as it is.
  EXPECT_NEAR(beams[1].Beam.Radius, 0.001, 1e-12);
  EXPECT_NEAR(beams[0].Beam.Radius, 0.001, 1e-12);
  options.Carries = false;
  EXPECT_NEAR(BeamsOf(plant, { 0.0, 0.0, 0.0, 0.0, 0.0, 1.0 }, options)[2].Beam.Radius, 0.001, 1e-12);
}

TEST(PlantSway, GravityBendsDownAndUprightBeamsNotAtAll)
{
  SwayOptions options;
  options.Gravity = true;
  std::vector<BranchBeam> beams(2);
  beams[1].Axis = { 1.0, 0.0, 0.0 };
  PlantSway sway(beams, options, Times, Vector3(0.0), Calm);
  const auto amplitudes = AmplitudesAt(sway, 2, 0.0);
  EXPECT_EQ(amplitudes[0], Vector3(0.0));
  const RoundBeam& beam = beams[1].Beam;
  const double exact = -9.80665 * beam.MassPerLength / (8.0 * beam.YoungModulus * SecondMoment(beam.Radius));
  EXPECT_NEAR(2.0 * amplitudes[1].z / exact, 1.013388, 1e-5);
}

TEST(PlantSway, WoodOfSpecies)
{
  for (int species = 0; species < NumberOfWoodSpecies; ++species)
  {
    EXPECT_EQ(WhyInvalid(ParametersOf(static_cast<WoodSpecies>(species))), "");
  }
  WoodParameters wood;
  wood.DampingRatio = std::nan("");
  EXPECT_NE(WhyInvalid(wood).find("Damping"), std::string::npos);
  wood = {};
  wood.YoungModulus = 0.0;
  EXPECT_NE(WhyInvalid(wood).find("YoungModulus"), std::string::npos);
}
