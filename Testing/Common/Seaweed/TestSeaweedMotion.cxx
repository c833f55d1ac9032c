// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/Constants.h"
#include "Seaweed/SeaweedMotion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

using namespace littoral;

namespace
{

/// No water at all.
SeaweedOptions Dry()
{
  SeaweedOptions options;
  options.DragCoefficient = 0.0;
  options.FrictionCoefficient = 0.0;
  options.AddedMassCoefficient = 0.0;
  return options;
}

/// A straight upright plant of a stiff, round, weightless-in-water stem.
Skeleton Stem(int segments, double length, double tilt = 0.0)
{
  Skeleton skeleton;
  const Vector3 along(std::sin(tilt), 0.0, std::cos(tilt));
  skeleton.StartBranch(-1, { 0.0, 0.0, -50.0 }, 0.01);
  for (int i = 1; i <= segments; ++i)
  {
    skeleton.Grow(Vector3(0.0, 0.0, -50.0) + length * i / segments * along, 0.01);
  }
  return skeleton;
}

SeaweedSegment Tissue(double width, double youngModulus, double ratio, double density = 1025.0)
{
  SeaweedSegment segment;
  segment.Width = width;
  segment.Thickness = width;
  segment.YoungModulus = youngModulus;
  segment.DampingRatio = ratio;
  segment.Density = density;
  return segment;
}

/// A plant that is moved on, step by step.
struct Plant
{
  SeaweedMotion Motion;
  std::vector<LinkState> States;
  std::vector<LinkPose> Poses;
  std::vector<WaterAtLink> Water;

  Plant(const std::vector<SeaweedLink>& links, const SeaweedOptions& options)
    : Motion(links, options)
    , States(Motion.AtRest())
    , Poses(links.size())
    , Water(links.size())
  {
    this->Pose();
  }
  Plant(const Skeleton& skeleton, const SeaweedSegment& segment, const SeaweedOptions& options)
    : Plant(LinksOf(skeleton, std::vector<SeaweedSegment>(skeleton.Nodes.size(), segment), options), options)
  {
  }
  void Pose() { this->Motion.Pose(this->States.data(), 0, this->Poses.size(), this->Poses.data()); }
  void Step(double step)
  {
    for (const LinkBatch& batch : this->Motion.GetBatches())
    {
      std::vector<WaterAtLink> water;
      for (std::size_t i = 0; i < batch.Links; ++i)
      {
        for (const std::size_t first : batch.First)
        {
          water.push_back(this->Water[first + i]);
        }
      }
      this->Motion.Step(step, batch, water.data(), this->States.data(), this->Poses.data());
    }
  }
  void Run(double time, double step)
  {
    for (long n = std::lround(time / step); n > 0; --n)
    {
      this->Step(step);
    }
  }
  void Flow(const Vector3& velocity)
  {
    for (WaterAtLink& water : this->Water)
    {
      water.Velocity = velocity;
    }
  }
  Vector3 Tip() const
  {
    const SeaweedLink& last = this->Motion.GetLinks().back();
    return this->Poses.back().Foot + last.Length * this->Poses.back().Axis;
  }
};

/// One segment that swings with a period [s] and a damping ratio.
std::vector<SeaweedLink> Pendulum(double period, double ratio)
{
  SeaweedLink link;
  link.Foot = { 0.0, 0.0, -5.0 };
  link.Length = 0.5;
  link.Mass = 2.0;
  link.Buoyancy = 0.0;
  link.Weight = 0.0;
  const double frequency = TwoPi / period;
  link.Stiffness = link.Mass * link.Length * link.Length / 3.0 * frequency * frequency;
  std::vector<SeaweedLink> links{ link };
  SetDamping(links, { ratio });
  return links;
}

/// Of a plant of one segment, in units of that at 0.3 rad at rest.
double Energy(const Plant& plant)
{
  const SeaweedLink& link = plant.Motion.GetLinks()[0];
  const double angle = std::acos(std::min(1.0, plant.Poses[0].Axis.z));
  const double inertia = link.Mass * link.Length * link.Length / 3.0;
  const double spin = glm::length(plant.Poses[0].Spin);
  return (link.Stiffness * angle * angle + inertia * spin * spin) / (link.Stiffness * 0.09);
}

Plant Released(double period, double ratio, const SeaweedOptions& options)
{
  Plant plant(Pendulum(period, ratio), options);
  if (options.Joint == SeaweedJoint::Bending)
  {
    plant.States[0].Shape = { std::sin(0.3), 0.0, std::cos(0.3) };
  }
  else
  {
    plant.States[0].Shape.y = 0.3;
  }
  plant.Pose();
  return plant;
}

}

TEST(SeaweedMotion, OneSegmentLosesTheEnergyOfADampedOscillator)
{
  for (const SeaweedJoint joint : { SeaweedJoint::Bending, SeaweedJoint::Tilting })
  {
    SeaweedOptions options = Dry();
    options.Joint = joint;
    Plant plant = Released(1.5, 0.05, options);
    EXPECT_NEAR(Energy(plant), 1.0, 1e-9);
    plant.Run(15.0, 1.0 / 24.0);
    EXPECT_NEAR(Energy(plant), 0.00185, 0.05 * 0.00185);
  }
}

TEST(SeaweedMotion, ExplicitEulerBlowsUpAsThePaperWould)
{
  SeaweedOptions options = Dry();
  options.Integrator = SeaweedIntegrator::ExplicitEuler;
  Plant plant = Released(1.5, 0.05, options);
  EXPECT_GT(1.0 / 24.0, ExplicitLimit(plant.Motion.GetLinks()));
  plant.Run(15.0, 1.0 / 24.0);
  EXPECT_NEAR(Energy(plant), 103.0, 0.05 * 103.0);
}

TEST(SeaweedMotion, ExplicitEulerHoldsBelowItsLimit)
{
  SeaweedOptions options = Dry();
  options.Integrator = SeaweedIntegrator::ExplicitEuler;
  Plant plant = Released(1.5, 0.05, options);
  const double limit = ExplicitLimit(plant.Motion.GetLinks());
  EXPECT_NEAR(limit, 2.0 * 0.05 * 1.5 / TwoPi, 1e-9);
  plant.Run(30.0, 0.9 * limit);
  EXPECT_LT(Energy(plant), 1.0);
}

TEST(SeaweedMotion, UndampedSegmentsKeepTheirEnergy)
{
  Plant plant = Released(1.5, 0.0, Dry());
  double least = 2.0;
  double most = 0.0;
  for (int period = 0; period < 1000; ++period)
  {
    plant.Run(1.5, 1.0 / 48.0);
    least = std::min(least, Energy(plant));
    most = std::max(most, Energy(plant));
  }
  EXPECT_GT(least, 0.99);
  EXPECT_LT(most, 1.01);
}

TEST(SeaweedMotion, ChainsOfAnyStiffnessAreStable)
{
  for (const SeaweedJoint joint : { SeaweedJoint::Bending, SeaweedJoint::Tilting })
  {
    for (double modulus = 1e3; modulus < 1e11; modulus *= 10.0)
    {
      SeaweedOptions options;
      options.Joint = joint;
      Plant plant(Stem(16, 2.0, 0.1), Tissue(0.01, modulus, 0.05, 900.0), options);
      double worst = 0.0;
      for (int n = 0; n < 48 * 60; ++n)
      {
        const double phase = TwoPi * n / (48.0 * 6.0);
        plant.Flow({ 0.8 * std::sin(phase), 0.3 * std::cos(phase), 0.0 });
        plant.Step(1.0 / 48.0);
        for (const LinkPose& pose : plant.Poses)
        {
          ASSERT_TRUE(IsFinite(pose.Foot) && IsFinite(pose.Spin)) << modulus;
          worst = std::max(worst, glm::length(pose.Spin));
        }
      }
      EXPECT_LT(worst, 30.0) << "at " << modulus << " Pa";
    }
  }
}

TEST(SeaweedMotion, BendsAsABeam)
{
  // A horizontal acceleration of the water is a constant uniform load.
  SeaweedOptions options = Dry();
  const double length = 2.0;
  Plant plant(Stem(16, length), Tissue(0.02, 1e8, 1.0), options);
  const SeaweedLink& link = plant.Motion.GetLinks()[0];
  const double load = link.WaterMass / link.Length * 0.01;
  for (WaterAtLink& water : plant.Water)
  {
    water.Acceleration = { 0.01, 0.0, 0.0 };
  }
  plant.Run(60.0, 1.0 / 48.0);
  const double bending = 1e8 * Pi / 64.0 * std::pow(0.02, 4);
  const double tip = load * std::pow(length, 4) / (8.0 * bending);
  EXPECT_NEAR(plant.Tip().x, tip, 0.004 * tip);
}

TEST(SeaweedMotion, OneSegmentBendsAsItsSpring)
{
  std::vector<SeaweedLink> links = Pendulum(1.5, 0.3);
  links[0].WaterMass = 4.0;
  Plant plant(links, Dry());
  plant.Water[0].Acceleration = { 0.3, 0.4, 0.0 };
  plant.Run(60.0, 1.0 / 24.0);
  const double angle = std::acos(plant.Poses[0].Axis.z);
  const double torque = 4.0 * 0.5 * 0.5 * links[0].Length * 2.0 * 0.5 * std::cos(angle);
  EXPECT_NEAR(angle, torque / links[0].Stiffness, 0.01 * angle);
}

TEST(SeaweedMotion, BuoyancyKeepsALimpPlantUpright)
{
  Plant plant(Stem(10, 2.0, 0.6), Tissue(0.02, 0.0, 0.0, 500.0), SeaweedOptions());
  EXPECT_LT(plant.Poses[0].Axis.z, 0.9);
  plant.Run(120.0, 1.0 / 48.0);
  for (const LinkPose& pose : plant.Poses)
  {
    EXPECT_GT(pose.Axis.z, 0.9999);
  }
}

// A limp rod above the sea falls over as one of its weight: a = a_0 cosh(w t), w^2 = 3 g / 2 L. In the water it would
// float.
TEST(SeaweedMotion, WhatIsAboveTheSeaHasItsWeight)
{
  SeaweedOptions options = Dry();
  options.SeaLevel = -60.0;
  Plant plant(Stem(1, 1.0, 0.05), Tissue(0.02, 1.0, 0.0, 500.0), options);
  const double rate = std::sqrt(1.5 * 9.80665);
  for (int part = 1; part <= 4; ++part)
  {
    plant.Run(0.1, 0.002);
    const Vector3& axis = plant.Poses[0].Axis;
    EXPECT_NEAR(std::atan2(axis.x, axis.z) / (0.05 * std::cosh(0.1 * part * rate)), 1.0, 0.005);
  }
}

// Under a moment M a segment bends by M l / E I: between the middles of two that meet lie half of one and half of the
// other, and below the first half of its own.
TEST(SeaweedMotion, JointsAreAsStiffAsTheBeamsThatMeet)
{
  Skeleton wood;
  wood.StartBranch(-1, { 0.0, 0.0, 0.0 }, 0.01);
  wood.Grow({ 0.0, 0.0, 0.5 }, 0.01);
  wood.Grow({ 0.0, 0.0, 0.8 }, 0.01);
  const std::vector<SeaweedSegment> segments{ Tissue(0.02, 2e7, 0.0), Tissue(0.01, 8e7, 0.0), Tissue(0.01, 8e7, 0.0) };
  const double bends[2] = { 0.5 / (2e7 * Pi / 64.0 * 1.6e-7),
    0.3 / (8e7 * Pi / 64.0 * 1e-8) }; // l / E I, I = pi d^4 / 64
  const std::vector<SeaweedLink> links = LinksOf(wood, segments, SeaweedOptions());
  ASSERT_EQ(links.size(), 2u);
  EXPECT_NEAR(links[0].Stiffness * 0.5 * bends[0], 1.0, 1e-9);
  EXPECT_NEAR(links[1].Stiffness * 0.5 * (bends[0] + bends[1]), 1.0, 1e-9);
}

// Inertia of a blade about its own axis: that of its elliptic section, summed over squares, and C rho pi / 128 (w2 -
// t2)2 of the water.
TEST(SeaweedMotion, AxialInertiaIsThatOfTheSection)
{
  Skeleton blade;
  blade.StartBranch(-1, { 0.0, 0.0, 0.0 }, 0.01);
  blade.Grow({ 0.0, 0.0, 0.4 }, 0.01);
  SeaweedSegment segment = Tissue(0.06, 1e6, 0.0, 1050.0);
  segment.Thickness = 0.01;
  SeaweedOptions options;
  const SeaweedLink link = LinksOf(blade, std::vector<SeaweedSegment>(2, segment), options).front();
  double squares = 0.0;
  double area = 0.0;
  const double side = 1e-4;
  for (double x = -0.03 + 0.5 * side; x < 0.03; x += side)
  {
    for (double y = -0.005 + 0.5 * side; y < 0.005; y += side)
    {
      const bool isInside = x * x / 9e-4 + y * y / 2.5e-5 < 1.0;
      squares += isInside ? (x * x + y * y) * side * side : 0.0;
      area += isInside ? side * side : 0.0;
    }
  }
  const double water =
    options.AddedMassCoefficient * options.WaterDensity * Pi / 128.0 * std::pow(0.06 * 0.06 - 0.01 * 0.01, 2.0) * 0.4;
  EXPECT_NEAR(link.AxialInertia, link.Mass * squares / area + water, 2e-3 * link.Mass * squares / area);
}

// In motion without a past, links of any length that are parts of one blade bend alike: by as much a metre.
TEST(SeaweedMotion, LinksOfAnyLengthBendAlikeAtOnce)
{
  std::vector<SeaweedLink> links(3);
  const double lengths[3] = { 1.0, 0.25, 3.0 };
  for (int n = 0; n < 3; ++n)
  {
    links[n].Length = lengths[n];
    links[n].MeanLength = 1.0;
    links[n].FrontalArea = links[n].EdgeFrontalArea = 0.05 * lengths[n];
    links[n].Stiffness = 2.0 / lengths[n];
    links[n].Foot = { 0.0, 3.0 * n, -20.0 };
  }
  Plant plant(links, SeaweedOptions());
  WaterAtLink water;
  water.Velocity = { 0.05, 0.0, 0.0 };
  double bends[3];
  for (int n = 0; n < 3; ++n)
  {
    const Vector3 axis = plant.Motion.Procedural(water, n, plant.Poses.data()).Shape;
    bends[n] = std::atan2(axis.x, axis.z) / lengths[n];
  }
  EXPECT_GT(bends[0], 1e-4);
  EXPECT_NEAR(bends[1] / bends[0], 1.0, 0.01);
  EXPECT_NEAR(bends[2] / bends[0], 1.0, 0.01);
}

// Pressed down by a dead load, a limp link comes to rest where the potential of load and stop is least. That of the
// stop is K_s/2 x^2 / (1 - x / 1.05), x rad beyond 1.75.
TEST(SeaweedMotion, AStopHoldsALoadWhereTheirPotentialIsLeast)
{
  SeaweedOptions options = Dry();
  options.Load = SeaweedLoad::Direct;
  options.ForceFactor = 1.0;
  std::vector<SeaweedLink> links(1);
  links[0].Stiffness = 0.0;
  links[0].Damping = 1.0;
  links[0].Axis = glm::normalize(Vector3(0.1, 0.0, 1.0));
  links[0].Side = { 0.0, 1.0, 0.0 };
  Plant plant(links, options);
  const double bent = std::atan2(0.1, 1.0); // at rest
  const double strength = plant.Motion.GetLinks()[0].StopStiffness;
  ASSERT_GT(strength, 0.0);
  for (const double load : { 0.1 * strength, 0.5 * strength })
  {
    plant.Flow({ 0.0, 0.0, -load });
    plant.Run(60.0, 0.01);
    const Vector3& axis = plant.Poses[0].Axis;
    const double found = std::atan2(axis.x, axis.z) - bent;
    double least = std::numeric_limits<double>::infinity();
    double wanted = 0.0;
    for (double angle = 1.5; angle < 2.75; angle += 1e-4)
    {
      const double x = std::max(0.0, angle - 1.75);
      const double potential = 0.5 * strength * x * x / (1.0 - x / 1.05) + 0.5 * load * std::cos(angle + bent);
      wanted = potential < least ? angle : wanted;
      least = std::min(least, potential);
    }
    EXPECT_GT(wanted, 1.76);
    EXPECT_NEAR(found, wanted, 1e-3);
  }
}

TEST(SeaweedMotion, HoldfastStaysAndLengthsAreKept)
{
  Plant plant(Stem(12, 3.0, 0.2), Tissue(0.01, 1e6, 0.1, 800.0), SeaweedOptions());
  const Vector3 foot = plant.Poses[0].Foot;
  for (int n = 0; n < 2000; ++n)
  {
    plant.Flow({ 1.5 * std::sin(0.02 * n), std::cos(0.031 * n), 0.4 * std::sin(0.05 * n) });
    plant.Step(1.0 / 48.0);
    ASSERT_EQ(plant.Poses[0].Foot, foot);
    for (std::size_t i = 1; i < plant.Poses.size(); ++i)
    {
      ASSERT_NEAR(glm::distance(plant.Poses[i].Foot, plant.Poses[i - 1].Foot), 0.25, 1e-7);
    }
  }
}

TEST(SeaweedMotion, BendsAlikeInACurrentFromAnywhere)
{
  const auto deflections = [](SeaweedJoint joint, bool procedural) {
    std::vector<double> all;
    for (int direction = 0; direction < 8; ++direction)
    {
      SeaweedOptions options;
      options.Joint = joint;
      Plant plant(Stem(8, 1.0), Tissue(0.01, 1e8, 0.1, 1000.0), options);
      plant.Flow({ 0.4 * std::cos(0.25 * Pi * direction), 0.4 * std::sin(0.25 * Pi * direction), 0.0 });
      if (procedural)
      {
        for (std::size_t i = 0; i < plant.States.size(); ++i)
        {
          plant.States[i] = plant.Motion.Procedural(plant.Water[i], i, plant.Poses.data());
          plant.Motion.PoseOne(plant.States[i], i, plant.Poses.data());
        }
      }
      else
      {
        plant.Run(20.0, 1.0 / 48.0);
      }
      all.push_back(std::hypot(plant.Tip().x, plant.Tip().y));
    }
    return all;
  };
  for (const bool procedural : { false, true })
  {
    const std::vector<double> all = deflections(SeaweedJoint::Bending, procedural);
    EXPECT_GT(all[0], 0.02);
    for (const double one : all)
    {
      EXPECT_NEAR(one, all[0], 0.01 * all[0]);
    }
  }
  // The paper's joint turns about the straight plant's own axis: a current along X moves nothing.
  const std::vector<double> paper = deflections(SeaweedJoint::Tilting, false);
  EXPECT_LT(paper[0], 1e-6);
  EXPECT_GT(paper[2], 0.02);
}

TEST(SeaweedMotion, LeansWithTheCurrent)
{
  for (const SeaweedJoint joint : { SeaweedJoint::Bending, SeaweedJoint::Tilting })
  {
    SeaweedOptions options;
    options.Joint = joint;
    Plant plant(Stem(8, 1.0), Tissue(0.01, 1e8, 0.1, 1000.0), options);
    plant.Flow({ 0.0, 0.4, 0.0 });
    plant.Run(20.0, 1.0 / 48.0);
    EXPECT_GT(plant.Tip().y, 0.02);
  }
}

TEST(SeaweedMotion, LimpPlantsLieOnTheBed)
{
  Plant plant(Stem(10, 2.0, 0.3), Tissue(0.02, 1e3, 0.1, 1200.0), SeaweedOptions());
  plant.Flow({ 0.2, 0.0, 0.0 });
  plant.Run(60.0, 1.0 / 48.0);
  EXPECT_GT(plant.Tip().x, 1.5);
  for (const LinkPose& pose : plant.Poses)
  {
    EXPECT_GT(pose.Foot.z, -50.05);
    EXPECT_LT(pose.Foot.z, -49.8);
  }
}

TEST(SeaweedMotion, ConvergesWithTheSquareOfTheStep)
{
  // A stem with drag, a branch and a flow that changes: over five steps errors fall by four each time.
  Skeleton skeleton = Stem(6, 1.0, 0.3);
  skeleton.StartBranch(3, skeleton.Nodes[3].Position, 0.01);
  skeleton.Grow(skeleton.Nodes[3].Position + Vector3(-0.1, 0.2, 0.1), 0.01);
  skeleton.Grow(skeleton.Nodes[3].Position + Vector3(-0.2, 0.4, 0.25), 0.01);
  const auto tips = [&](int steps) {
    Plant plant(skeleton, Tissue(0.02, 3e6, 0.1, 900.0), SeaweedOptions());
    const double step = 1.0 / steps;
    for (int n = 0; n < steps; ++n)
    {
      const double middle = (n + 0.5) * step;
      plant.Flow({ 0.3 * std::sin(3.0 * middle), 0.2 * middle, 0.1 * middle * middle });
      plant.Step(step);
    }
    return std::array<Vector3, 2>{ plant.Poses[5].Foot, plant.Tip() };
  };
  const std::array<Vector3, 2> exact = tips(12288);
  double last = 0.0;
  for (const int steps : { 96, 192, 384, 768, 1536 })
  {
    const std::array<Vector3, 2> own = tips(steps);
    const double error = std::max(glm::distance(own[0], exact[0]), glm::distance(own[1], exact[1]));
    if (last > 0.0)
    {
      EXPECT_NEAR(last / error, 4.0, 0.8) << steps;
    }
    last = error;
  }
  EXPECT_LT(last, 1e-5);
}

TEST(SeaweedMotion, PlantsOfAnyResolutionAndStiffnessFollowTheWater)
{
  // Long kelp in a current and waves of 1 m/s together: nothing outruns the water by far, at any step.
  for (const int segments : { 2, 16, 64 })
  {
    for (const double modulus : { 1e4, 1e6, 1e9 })
    {
      for (const double step : { 1.0 / 24.0, 1.0 / 48.0, 1.0 / 120.0 })
      {
        SeaweedSegment tissue = Tissue(0.1, modulus, 0.05, 1010.0);
        tissue.Thickness = 0.002;
        tissue.Tissue = SeaweedTissue::Blade;
        tissue.Across = { 0.0, 1.0, 0.0 };
        Plant plant(Stem(segments, 2.0, 0.2), tissue, SeaweedOptions());
        double fastest = 0.0;
        const int steps = static_cast<int>(std::lround(2.5 / step));
        for (int n = 0; n < steps; ++n)
        {
          const double phase = TwoPi / 4.0 * (n + 0.5) * step;
          for (WaterAtLink& water : plant.Water)
          {
            water.Velocity = { 0.3 + 0.7 * std::sin(phase), 0.1, 0.7 * std::cos(phase) };
            water.Acceleration = TwoPi / 4.0 * 0.7 * Vector3(std::cos(phase), 0.0, -std::sin(phase));
          }
          plant.Step(step);
          for (const LinkPose& pose : plant.Poses)
          {
            ASSERT_TRUE(IsFinite(pose.Velocity) && IsFinite(pose.Spin));
            fastest = std::max(fastest, glm::length(pose.Velocity));
          }
          fastest = std::max(fastest, glm::length(plant.Poses.back().Velocity));
        }
        EXPECT_LT(fastest, 4.4) << segments << " segments of " << modulus << " Pa, step " << step;
      }
    }
  }
}

TEST(SeaweedMotion, BranchesPullAtTheirStem)
{
  // A float on a side branch lifts the joint of a drooping stem.
  Skeleton skeleton;
  skeleton.StartBranch(-1, { 0.0, 0.0, -20.0 }, 0.01);
  skeleton.Grow({ 0.5, 0.0, -20.0 }, 0.01);
  skeleton.Grow({ 1.0, 0.0, -20.0 }, 0.01);
  skeleton.StartBranch(1, { 0.75, 0.0, -20.0 }, 0.02);
  skeleton.Grow({ 0.75, 0.0, -19.6 }, 0.02);
  std::vector<SeaweedSegment> segments(skeleton.Nodes.size(), Tissue(0.02, 1e6, 0.3, 1050.0));
  SeaweedOptions options;
  Plant sinks(LinksOf(skeleton, segments, options), options);
  segments[3] = Tissue(0.06, 1e6, 0.3, 300.0);
  segments[4] = segments[3];
  Plant rises(LinksOf(skeleton, segments, options), options);
  EXPECT_EQ(rises.Motion.GetLinks()[2].Parent, 1);
  sinks.Run(30.0, 1.0 / 48.0);
  rises.Run(30.0, 1.0 / 48.0);
  EXPECT_LT(sinks.Poses[1].Foot.z, -20.0); // on the soft bed
  EXPECT_NEAR(sinks.Poses[1].Axis.z, 0.0, 0.001);
  EXPECT_GT(rises.Poses[1].Axis.z, 0.1);
}

TEST(SeaweedMotion, VelocitiesAreThoseOfThePlaces)
{
  // Frames that bend the shortest way also twist; what grows sideways on them feels it.
  Skeleton skeleton;
  skeleton.StartBranch(-1, { 0.0, 0.0, -20.0 }, 0.01);
  for (int i = 1; i <= 6; ++i)
  {
    skeleton.Grow({ 0.05 * i, 0.0, -20.0 + 0.3 * i }, 0.01);
  }
  skeleton.StartBranch(3, skeleton.Nodes[3].Position, 0.01);
  skeleton.Grow(skeleton.Nodes[3].Position + Vector3(0.2, 0.3, 0.0), 0.01);
  skeleton.Grow(skeleton.Nodes[3].Position + Vector3(0.4, 0.6, 0.1), 0.01);
  for (const SeaweedJoint joint : { SeaweedJoint::Bending, SeaweedJoint::Tilting })
  {
    SeaweedOptions options;
    options.Joint = joint;
    const std::vector<SeaweedSegment> segments(skeleton.Nodes.size(), Tissue(0.02, 1e5, 0.1, 1000.0));
    Plant plant(LinksOf(skeleton, segments, options), options);
    double worst = 0.0;
    double fastest = 0.0;
    double bend = 0.0;
    for (int n = 0; n < 480; ++n)
    {
      plant.Flow({ std::sin(0.06 * n), std::cos(0.041 * n), 0.3 * std::sin(0.1 * n) });
      plant.Step(1.0 / 48.0);
      const double step = 1e-6;
      Plant next = plant;
      next.Step(step);
      for (std::size_t link = 0; link < plant.Poses.size(); ++link)
      {
        const Vector3 moved = (next.Poses[link].Foot - plant.Poses[link].Foot) / step;
        worst = std::max(worst, glm::distance(moved, plant.Poses[link].Velocity));
        fastest = std::max(fastest, glm::length(moved));
        const int parent = plant.Motion.GetLinks()[link].Parent;
        const Vector3 below = parent < 0 ? Vector3(0.0, 0.0, 1.0) : plant.Poses[parent].Axis;
        bend = std::max(bend, std::acos(std::clamp(glm::dot(below, plant.Poses[link].Axis), -1.0, 1.0)));
      }
    }
    EXPECT_GT(bend, 1.0);
    EXPECT_GT(fastest, 0.5);
    EXPECT_LT(worst, 1e-3 * fastest);
  }
}

TEST(SeaweedMotion, LimpPlantsNeitherFoldFlatNorOutrunTheWater)
{
  Plant plant(Stem(12, 2.4, 0.2), Tissue(0.02, 1e3, 0.1, 1010.0), SeaweedOptions());
  double bend = 0.0;
  double fastest = 0.0;
  for (int n = 0; n < 48 * 40; ++n)
  {
    const double phase = TwoPi * n / (48.0 * 4.0);
    plant.Flow({ 1.2 * std::sin(phase), 0.2 * std::cos(phase), 0.6 * std::cos(phase) });
    plant.Step(1.0 / 48.0);
    for (std::size_t link = 1; link < plant.Poses.size(); ++link)
    {
      bend = std::max(bend, std::acos(glm::dot(plant.Poses[link - 1].Axis, plant.Poses[link].Axis)));
      fastest = std::max(fastest, glm::length(plant.Poses[link].Velocity));
    }
  }
  EXPECT_GT(bend, 1.0);
  EXPECT_LT(bend, 2.1);
  EXPECT_LT(fastest, 2.0 * 1.3);
}

TEST(SeaweedMotion, SaysWhichOptionIsBad)
{
  EXPECT_EQ(WhyInvalid(SeaweedOptions()), "");
  SeaweedOptions options;
  options.DragCoefficient = -1.0;
  EXPECT_NE(WhyInvalid(options).find("DragCoefficient"), std::string::npos);
  options = {};
  options.WaterDensity = std::nan("");
  EXPECT_NE(WhyInvalid(options).find("WaterDensity"), std::string::npos);
}
