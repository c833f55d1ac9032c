// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Blades in currents and waves: chains of links against the boundary value problem of a beam under drag (Luhar and Nepf
// 2011), solved here by shooting from the tip, and against closed forms of plates.
#include "Numerics/Constants.h"
#include "Seaweed/SeaweedGrowth.h"
#include "Seaweed/SeaweedMotion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

using namespace littoral;

namespace
{

constexpr double Density = 1025.0;

/// A blade of length 1 in a current, upright at its foot, with drag normal to it: what it looks like.
struct Elastica
{
  double Drag = 0.0; ///< of that of the upright rigid blade: l_e / l
  double Tip = 0.0;  ///< angle of the tip from the vertical [rad]
};

/// theta'' = -(Fx cos theta - Fz sin theta), lengths in l, forces in E I / l2. The angle at the tip is chosen so that
/// the foot is upright.
Elastica SolveElastica(double cauchy, double buoyancy)
{
  using State = std::array<double, 5>; // theta, theta', Fx, Fz of what is beyond, drag
  const auto slope = [&](const State& y) {
    const double c = std::cos(y[0]);
    const double q = cauchy * c * std::abs(c);
    return State{ -y[1], y[2] * c - y[3] * std::sin(y[0]), q * c, -q * std::sin(y[0]) + buoyancy, q * c };
  };
  const auto shoot = [&](double offLevel) {
    State y{ 0.5 * Pi - offLevel, 0.0, 0.0, 0.0, 0.0 };
    constexpr int steps = 3000;
    for (int n = 0; n < steps && y[0] > -0.5; ++n)
    {
      // Steps that get finer towards the foot.
      const auto at = [](int i) { return 1.0 - std::pow(1.0 - static_cast<double>(i) / steps, 2); };
      const double h = at(n + 1) - at(n);
      const auto moved = [&y](const State& k, double by) {
        State to = y;
        for (std::size_t i = 0; i < to.size(); ++i)
        {
          to[i] += by * k[i];
        }
        return to;
      };
      const State k1 = slope(y);
      const State k2 = slope(moved(k1, 0.5 * h));
      const State k3 = slope(moved(k2, 0.5 * h));
      const State k4 = slope(moved(k3, h));
      for (std::size_t i = 0; i < y.size(); ++i)
      {
        y[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
      }
    }
    return y;
  };
  // From a tip that hardly turns, for which the foot must lean back, to the first with which it is upright.
  double above = std::log(0.5 * Pi - 1e-3);
  double below = above;
  while (shoot(std::exp(below))[0] < 0.0 && below > -36.0)
  {
    above = below;
    below -= 0.25;
  }
  if (above == below)
  {
    return {};
  }
  for (int n = 0; n < 50; ++n)
  {
    const double middle = 0.5 * (above + below);
    (shoot(std::exp(middle))[0] < 0.0 ? above : below) = middle;
  }
  return { shoot(std::exp(below))[4] / cauchy, 0.5 * Pi - std::exp(below) };
}

/// A blade of links in water.
struct Blade
{
  SeaweedSegment Segment;
  SeaweedOptions Options;
  std::unique_ptr<SeaweedMotion> Motion;
  std::vector<LinkState> States;
  std::vector<LinkPose> Poses;
  std::vector<WaterAtLink> Water;

  /// Of length 1, its face towards x, of links that end at parts of it.
  Blade(const std::vector<double>& steps, double width, double bending, double density, bool hasAddedMass)
  {
    Skeleton skeleton;
    skeleton.StartBranch(-1, { 0.0, 0.0, -20.0 }, 0.01);
    for (std::size_t i = 1; i < steps.size(); ++i)
    {
      skeleton.Grow({ 0.0, 0.0, -20.0 + steps[i] }, 0.01);
    }
    this->Segment.Tissue = SeaweedTissue::Blade;
    this->Segment.Width = width;
    this->Segment.Thickness = 0.01 * width;
    this->Segment.Across = { 0.0, 1.0, 0.0 };
    this->Segment.YoungModulus = bending / SecondMoment(this->Segment);
    this->Segment.Density = density;
    this->Options.DragCoefficient = 1.0;
    this->Options.FrictionCoefficient = 0.0;
    this->Options.AddedMassCoefficient = hasAddedMass ? 1.0 : 0.0;
    const std::vector<SeaweedSegment> segments(skeleton.Nodes.size(), this->Segment);
    this->Motion = std::make_unique<SeaweedMotion>(LinksOf(skeleton, segments, this->Options), this->Options);
    this->States = this->Motion->AtRest();
    this->Poses.resize(this->States.size());
    this->Motion->Pose(this->States.data(), 0, this->States.size(), this->Poses.data());
    this->Water.resize(this->Motion->GetBatches().front().PaddedLinks());
  }
  void Step(double step, const Vector3& velocity, const Vector3& acceleration = Vector3(0.0))
  {
    for (WaterAtLink& water : this->Water)
    {
      water.Velocity = velocity;
      water.Acceleration = acceleration;
    }
    this->Motion->Step(
      step, this->Motion->GetBatches().front(), this->Water.data(), this->States.data(), this->Poses.data());
  }
  /// Drag along x [N], by many points of each link.
  double Drag(double flow) const
  {
    double drag = 0.0;
    for (std::size_t i = 0; i < this->Poses.size(); ++i)
    {
      const LinkPose& pose = this->Poses[i];
      const double length = this->Motion->GetLinks()[i].Length;
      const Vector3 normal = glm::cross(pose.Axis, pose.Rotation * this->Motion->GetLinks()[i].Side);
      for (int point = 0; point < 8; ++point)
      {
        const Vector3 v = pose.Velocity + glm::cross(pose.Spin, (point + 0.5) / 8.0 * length * pose.Axis);
        const double slip = glm::dot(Vector3(flow, 0.0, 0.0) - v, normal);
        drag += 0.5 * Density * this->Segment.Width * length / 8.0 * std::abs(slip) * slip * normal.x;
      }
    }
    return drag;
  }
  double Tip() const { return std::acos(this->Poses.back().Axis.z); }
};

constexpr double Flow = 0.5;
constexpr double Width = 0.02;

/// A blade in a current when it has come to rest.
Blade BladeInCurrent(const std::vector<double>& steps, double cauchy, double buoyancy)
{
  const double bending = Density * Width * Flow * Flow / (2.0 * cauchy);
  const double area = 0.25 * Pi * Width * 0.01 * Width;
  Blade blade(steps, Width, bending, Density - buoyancy * bending / (9.80665 * area), true);
  for (int n = 0; n < 24 * 50; ++n)
  {
    blade.Step(1.0 / 24.0, { Flow, 0.0, 0.0 });
  }
  return blade;
}

std::vector<double> EqualSteps(int count)
{
  std::vector<double> steps;
  for (int i = 0; i <= count; ++i)
  {
    steps.push_back(static_cast<double>(i) / count);
  }
  return steps;
}

double EffectiveLength(const Blade& blade)
{
  return blade.Drag(Flow) / (0.5 * Density * Width * Flow * Flow);
}

}

TEST(SeaweedBlade, ShootingGivesThePublishedBlades)
{
  // Luhar and Nepf (2011), by an independent solver: Ca, B, l_e / l, angle of the tip.
  for (const auto& known : { std::array<double, 4>{ 1, 0, 0.9748, 9.31 }, std::array<double, 4>{ 10, 0, 0.5236, 47.09 },
         std::array<double, 4>{ 100, 0, 0.1918, 76.71 }, std::array<double, 4>{ 10, 10, 0.7447, 30.69 } })
  {
    const Elastica exact = SolveElastica(known[0], known[1]);
    EXPECT_NEAR(exact.Drag, known[2], 1e-4);
    EXPECT_NEAR(exact.Tip * 180.0 / Pi, known[3], 0.02);
  }
}

TEST(SeaweedBlade, TenGradedLinksHaveTheDragOfABlade)
{
  double slowest = 0.0;
  double fastest = 0.0;
  for (const auto& flow :
    { std::array<double, 2>{ 1, 0 }, std::array<double, 2>{ 10, 0 }, std::array<double, 2>{ 10, 10 },
      std::array<double, 2>{ 100, 0 }, std::array<double, 2>{ 1e3, 0 }, std::array<double, 2>{ 1e4, 0 } })
  {
    const Elastica exact = SolveElastica(flow[0], flow[1]);
    const Blade blade = BladeInCurrent(BladeSteps(10), flow[0], flow[1]);
    const double drag = EffectiveLength(blade);
    EXPECT_NEAR(drag, exact.Drag, 0.05 * exact.Drag) << "Ca " << flow[0] << ", B " << flow[1];
    EXPECT_NEAR(blade.Tip() * 180.0 / Pi, exact.Tip * 180.0 / Pi, 0.6) << "Ca " << flow[0] << ", B " << flow[1];
    slowest = flow[0] == 100 ? drag : slowest;
    fastest = drag;
  }
  // Drag goes with U2 l_e: Vogel's exponent -2/3 is l_e with Ca^(-1/3).
  const double exponent = 2.0 * std::log(fastest / slowest) / std::log(1e4 / 100.0);
  EXPECT_NEAR(exponent, -2.0 / 3.0, 0.02);
}

TEST(SeaweedBlade, EqualLinksHaveTheDragUpToTheirCauchyNumber)
{
  // The number that a warning gives, (0.52 l / l_1)^3, is where drag begins to be off by more than 5 %.
  for (const int links : { 6, 10, 16 })
  {
    const double bearable = ResolvedCauchyNumber(1.0, 1.0 / links);
    const Elastica exact = SolveElastica(bearable, 0.0);
    const double drag = EffectiveLength(BladeInCurrent(EqualSteps(links), bearable, 0.0));
    EXPECT_NEAR(drag, exact.Drag, 0.06 * exact.Drag) << links;
    const Elastica beyond = SolveElastica(20.0 * bearable, 0.0);
    const double off = EffectiveLength(BladeInCurrent(EqualSteps(links), 20.0 * bearable, 0.0));
    EXPECT_GT(std::abs(off - beyond.Drag), 0.1 * beyond.Drag) << links;
  }
}

TEST(SeaweedBlade, SkeletonsOfEqualSegmentsAreFound)
{
  for (const SeaweedPreset preset : { SeaweedPreset::SugarKelp, SeaweedPreset::GiantKelp, SeaweedPreset::Eelgrass })
  {
    const Seaweed weed = GrowSeaweed(PresetParameters(preset));
    EXPECT_TRUE(std::isinf(UngradedCauchyNumber(weed.Wood, weed.Segments)));
  }
  // A blade of ten equal segments on a stipe of two: only the blade counts.
  Skeleton skeleton;
  skeleton.StartBranch(-1, { 0.0, 0.0, -20.0 }, 0.01);
  for (int i = 1; i <= 12; ++i)
  {
    skeleton.Grow({ 0.0, 0.0, -20.0 + 0.2 * i }, 0.01);
  }
  std::vector<SeaweedSegment> segments(skeleton.Nodes.size());
  EXPECT_TRUE(std::isinf(UngradedCauchyNumber(skeleton, segments)));
  for (std::size_t node = 2; node < segments.size(); ++node)
  {
    segments[node].Tissue = SeaweedTissue::Blade;
  }
  EXPECT_NEAR(UngradedCauchyNumber(skeleton, segments), std::pow(5.2, 3), 1e-6);
}

TEST(SeaweedBlade, WavesAreFeltByTheEffectiveLength)
{
  // Lei and Nepf (2019): l_e / l = 0.94 (Ca L)^(-1/4), L: length over the excursion of the water; by the root mean
  // square of the drag against that of the rigid blade.
  for (const auto& wave : { std::array<double, 2>{ 10, 8.0 }, std::array<double, 2>{ 300, 2.0 },
         std::array<double, 2>{ 3000, 4.0 }, std::array<double, 2>{ 1e4, 4.0 } })
  {
    const double cauchy = wave[0];
    const double ratio = wave[1];
    const double speed = 0.3;
    const double frequency = speed * ratio; // excursion 1 / ratio
    const double bending = Density * Width * speed * speed / (2.0 * cauchy);
    Blade blade(BladeSteps(10), Width, bending, Density, true);
    const double period = TwoPi / frequency;
    const int steps = 400;
    double own = 0.0;
    double rigid = 0.0;
    for (int n = 0; n < 6 * steps; ++n)
    {
      const double middle = TwoPi * (n + 0.5) / steps;
      blade.Step(
        period / steps, { speed * std::sin(middle), 0.0, 0.0 }, { speed * frequency * std::cos(middle), 0.0, 0.0 });
      if (n >= 3 * steps)
      {
        const double flow = speed * std::sin(TwoPi * (n + 1.0) / steps);
        own += std::pow(blade.Drag(flow), 2);
        rigid += std::pow(0.5 * Density * Width * flow * flow, 2);
      }
    }
    const double expected = 0.94 * std::pow(cauchy * ratio, -0.25);
    EXPECT_NEAR(std::sqrt(own / rigid), expected, 0.25 * expected) << cauchy << " " << ratio;
  }
}

TEST(SeaweedBlade, SpinningBladesLoseTheirRateAsDragAlongThemSays)
{
  // A plate on a free joint: J dw/dt = -rho/2 C b w2 l4/4, which is that of its middle twice.
  Blade blade({ 0.0, 1.0 }, 0.05, 0.0, Density, false);
  const SeaweedLink& link = blade.Motion->GetLinks()[0];
  const double inertia = link.Mass / 3.0;
  const double start = 2.0;
  blade.States[0].Rate = { 0.0, start, 0.0 }; // about the width: face first
  blade.Motion->Pose(blade.States.data(), 0, 1, blade.Poses.data());
  const double time = 0.4;
  for (int n = 0; n < 400; ++n)
  {
    blade.Step(time / 400, Vector3(0.0));
  }
  const double rate = start / (1.0 + 0.5 * Density * 0.05 * 0.25 / inertia * start * time);
  EXPECT_LT(rate, 0.1 * start);
  EXPECT_NEAR(blade.Poses[0].Spin.y, rate, 0.01 * rate);
}

TEST(SeaweedBlade, AFlowAlongTheFaceHardlyPushes)
{
  // In the same weak current, edge-on a stiff blade bends by thickness over width of what it does face-on.
  const auto bend = [](const Vector3& flow) {
    Blade blade(EqualSteps(4), 0.1, 0.02, Density, true);
    for (int n = 0; n < 48 * 40; ++n)
    {
      blade.Step(1.0 / 48.0, flow);
    }
    return blade.Tip();
  };
  const double face = bend({ 0.02, 0.0, 0.0 });
  const double edge = bend({ 0.0, 0.02, 0.0 });
  EXPECT_GT(face, 0.02);
  EXPECT_NEAR(edge / face, 0.01, 0.002);
}

TEST(SeaweedBlade, BladesHaveTheDragOfPlatesAndStipesThatOfCylinders)
{
  // One stiff link in a weak current at the defaults: K a = rho/2 C D L U2 L/2, K = 2 E I / L.
  for (const bool isBlade : { true, false })
  {
    Skeleton skeleton;
    skeleton.StartBranch(-1, { 0.0, 0.0, -20.0 }, 0.01);
    skeleton.Grow({ 0.0, 0.0, -19.0 }, 0.01);
    SeaweedSegment segment;
    segment.Tissue = isBlade ? SeaweedTissue::Blade : SeaweedTissue::Stipe;
    segment.Width = 0.02;
    segment.Thickness = isBlade ? 0.004 : 0.02;
    segment.Across = { 0.0, 1.0, 0.0 };
    segment.Density = Density;
    segment.YoungModulus = 50.0 / SecondMoment(segment);
    const SeaweedMotion motion(LinksOf(skeleton, { segment, segment }, {}), {});
    std::vector<LinkState> states = motion.AtRest();
    std::vector<LinkPose> poses(1);
    motion.Pose(states.data(), 0, 1, poses.data());
    std::vector<WaterAtLink> water(motion.GetBatches().front().PaddedLinks());
    for (WaterAtLink& one : water)
    {
      one.Velocity = { 0.3, 0.0, 0.0 };
    }
    for (int n = 0; n < 4000; ++n)
    {
      motion.Step(0.01, motion.GetBatches().front(), water.data(), states.data(), poses.data());
    }
    const double coefficient = isBlade ? 1.95 : 0.975;
    const double bend = 0.25 * Density * coefficient * 0.02 * 0.09 / 100.0;
    EXPECT_NEAR(std::acos(poses[0].Axis.z), bend, 1e-3 * bend) << isBlade;
  }
}

TEST(SeaweedBlade, TheWaterMovesWithTheFaceAlone)
{
  // One link on a spring, without drag: periods of a plate with the added mass of its sides.
  for (const bool isFace : { true, false })
  {
    Blade blade({ 0.0, 1.0 }, 0.1, 0.05, Density, true);
    std::vector<SeaweedLink> links = blade.Motion->GetLinks();
    links[0].Damping = 0.0;
    SeaweedOptions options = blade.Options;
    options.DragCoefficient = 0.0;
    const SeaweedMotion motion(links, options);
    const double tissue = Density * 0.25 * Pi * 0.1 * 0.001;
    const double water = Density * 0.25 * Pi * (isFace ? 0.01 : 1e-6);
    const double frequency = std::sqrt(2.0 * 0.05 / ((tissue + water) / 3.0));
    blade.States[0].Shape =
      isFace ? Vector3(std::sin(0.1), 0.0, std::cos(0.1)) : Vector3(0.0, std::sin(0.1), std::cos(0.1));
    motion.Pose(blade.States.data(), 0, 1, blade.Poses.data());
    const double period = TwoPi / frequency;
    for (int n = 0; n < 1000; ++n)
    {
      motion.Step(
        2.25 * period / 1000, motion.GetBatches().front(), blade.Water.data(), blade.States.data(), blade.Poses.data());
    }
    // After two periods and a quarter it is upright.
    const double off = std::acos(blade.Poses[0].Axis.z);
    EXPECT_LT(off, 0.1 * 0.005 * TwoPi) << (isFace ? "face" : "edge");
  }
}
