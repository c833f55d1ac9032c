// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Currents/CurrentDrift.h"
#include "Currents/FlowPrimitives.h"
#include "Numerics/Constants.h"
#include "Numerics/RandomStream.h"
#include "Particles/SuspendedParticles.h"
#include "Seaweed/PlantWake.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <limits>
#include <set>
#include <vector>

using namespace littoral;

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

FlowPrimitive Primitive(FlowType type, double strength, double core = 0.5, double reach = 0.0)
{
  FlowPrimitive primitive;
  primitive.Type = type;
  primitive.Strength = strength;
  primitive.Axis = Vector3(0.0, 0.0, 1.0);
  primitive.CoreRadius = core;
  primitive.InfluenceRadius = reach;
  return primitive;
}

Vector3 Drifted(const FlowField& field, Vector3 place, double step, long steps, const WaterLayer& layer = {})
{
  for (long n = 0; n < steps; ++n)
  {
    place = DriftStep(layer, place, step, [&](const Vector3& at, int) { return field.Velocity(at); });
  }
  return place;
}

/// Divergence by central differences.
double Divergence(const FlowField& field, const Vector3& place)
{
  const double h = 1e-5;
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    Vector3 shift(0.0);
    shift[axis] = h;
    sum += (field.Velocity(place + shift)[axis] - field.Velocity(place - shift)[axis]) / (2.0 * h);
  }
  return sum;
}

}

TEST(FlowPrimitives, HaveTheirClosedForms)
{
  const double e = 0.3;
  const FlowField source({ Primitive(FlowType::Source, 2.0, e) });
  const FlowField sink({ Primitive(FlowType::Sink, 2.0, e) });
  const FlowField vortex({ Primitive(FlowType::Vortex, 2.0, e) });
  for (const double r : { 1e-9, 1e-3, 0.1, 0.3, 1.0, 10.0, 1e4 })
  {
    const Vector3 place(0.6 * r, 0.8 * r, 0.0);
    const double speed = 2.0 * r / (4.0 * Pi * std::pow(r * r + e * e, 1.5));
    EXPECT_NEAR(glm::dot(source.Velocity(place), place) / (r * r) / (speed / r), 1.0, 1e-12);
    EXPECT_EQ(source.Velocity(place), -sink.Velocity(place));
    const double turn = 2.0 / (TwoPi * r) * -std::expm1(-r * r / (e * e));
    const Vector3 around = vortex.Velocity(place);
    EXPECT_NEAR((-0.8 * around.x + 0.6 * around.y) / turn, 1.0, 1e-8);
    EXPECT_NEAR(glm::dot(around, place), 0.0, 1e-12 * r);
  }
  // Far away a source lets through what it gives.
  EXPECT_NEAR(source.Velocity({ 1000.0, 0.0, 0.0 }).x * 4.0 * Pi * 1e6, 2.0, 1e-6);
  // Solid rotation in the core.
  EXPECT_NEAR(vortex.Velocity({ 1e-6, 0.0, 0.0 }).y, 1e-6 * 2.0 / (TwoPi * e * e), 1e-16);
}

TEST(FlowPrimitives, AreFiniteEverywhere)
{
  for (int id = 0; id < NumberOfFlowTypes; ++id)
  {
    const FlowType type = static_cast<FlowType>(id);
    for (const double reach : { 0.0, 2.0 })
    {
      const FlowField field({ Primitive(type, 3.0, 1e-3, reach) });
      EXPECT_TRUE(IsFinite(field.Velocity(Vector3(0.0))));
      for (double r = 1e-300; r < 1e100; r *= 3.0)
      {
        const Vector3 flow = field.Velocity({ r, -0.5 * r, 0.25 * r });
        ASSERT_TRUE(IsFinite(flow)) << static_cast<int>(type) << " at " << r;
        ASSERT_LT(glm::length(flow), 1e6);
      }
    }
  }
  EXPECT_EQ(FlowField({ Primitive(FlowType::Vortex, 3.0) }).Velocity(Vector3(0.0)), Vector3(0.0));
}

TEST(FlowPrimitives, EndSmoothlyAtTheirInfluence)
{
  for (const FlowType type : { FlowType::Uniform, FlowType::Source, FlowType::Vortex })
  {
    const FlowField field({ Primitive(type, 3.0, 0.3, 2.0) });
    EXPECT_EQ(field.Velocity({ 2.0, 0.0, 0.0 }), Vector3(0.0));
    EXPECT_EQ(field.Velocity({ 3.0, 0.0, 0.0 }), Vector3(0.0));
    // Velocity and slope: both go to 0 at the end.
    EXPECT_LT(glm::length(field.Velocity({ 2.0 - 1e-4, 0.0, 0.0 })), 1e-7);
    EXPECT_GT(glm::length(field.Velocity({ 1.0, 0.0, 0.0 })), 0.01);
    // (1 - (R / radius)^2)^2 of a flow without end, in any direction.
    const FlowField endless({ Primitive(type, 3.0, 0.3) });
    for (const Vector3& place : { Vector3(0.2, 0.1, 0.0), Vector3(-0.6, 0.8, 0.0), Vector3(0.9, -1.0, 0.7) })
    {
      const double share = 1.0 - glm::dot(place, place) / 4.0;
      EXPECT_LT(glm::length(field.Velocity(place) - share * share * endless.Velocity(place)), 1e-14);
    }
  }
}

TEST(FlowPrimitives, AreWholeInTheirBoxAndEndWithinItsMargin)
{
  for (int id = 0; id < NumberOfFlowTypes; ++id)
  {
    const FlowType type = static_cast<FlowType>(id);
    FlowPrimitive primitive = Primitive(type, 3.0, 0.3);
    primitive.Axis = Vector3(0.2, 0.3, 1.0);
    const FlowField endless({ primitive });
    primitive.InfluenceBox = { { -1.0, -0.5, -2.0 }, { 1.5, 0.25, 0.5 } };
    primitive.InfluenceMargin = 0.5;
    const FlowField field({ primitive });
    for (const Vector3 inside : { Vector3(0.1, 0.2, -0.3), Vector3(1.5, 0.25, 0.5), Vector3(-1.0, -0.5, -2.0) })
    {
      EXPECT_EQ(field.Velocity(inside), endless.Velocity(inside));
    }
    // Beside a face, an edge and a corner, at the distance d.
    for (const Vector3 way : { Vector3(1.0, 0.0, 0.0), Vector3(0.6, 0.8, 0.0), Vector3(2.0, 2.0, 1.0) / 3.0 })
    {
      const auto at = [&](double d) { return Vector3(1.5, 0.25, 0.5) + d * way; };
      for (const double d : { 0.1, 0.25, 0.4 })
      {
        const double share = std::pow(1.0 - 4.0 * d * d, 2.0);
        EXPECT_LT(glm::length(field.Velocity(at(d)) - share * endless.Velocity(at(d))), 1e-14);
        EXPECT_GT(glm::length(field.Velocity(at(d))), 1e-3);
      }
      // No jump of velocity or slope where it begins to fall and where it ends.
      EXPECT_LT(glm::length(field.Velocity(at(1e-6)) - endless.Velocity(at(1e-6))), 1e-10);
      EXPECT_LT(glm::length(field.Velocity(at(0.5 - 1e-6))), 1e-9);
      EXPECT_EQ(field.Velocity(at(0.5 + 1e-9)), Vector3(0.0));
      EXPECT_EQ(field.Velocity(at(50.0)), Vector3(0.0));
    }
    // Both ends hold.
    primitive.InfluenceRadius = 0.6;
    EXPECT_EQ(FlowField({ primitive }).Velocity({ 0.7, 0.0, 0.0 }), Vector3(0.0));
    EXPECT_FALSE(FlowField({ primitive }).IsUniform());
    primitive.Center = Vector3(9.0, 0.0, 0.0);
    EXPECT_EQ(FlowField({ primitive }).Velocity({ 9.0, 0.0, 0.1 }), Vector3(0.0));
    EXPECT_EQ(FlowField({ primitive }).Velocity({ 2.0, 0.0, 0.1 }), Vector3(0.0));
  }
}

TEST(FlowPrimitives, OfWhichManyEndAreSummedOneByOne)
{
  // Of all shapes: flat, thin, large, a point; and some without an end.
  const RandomStream random(5, RandomPurpose::ParticlePositions);
  std::vector<FlowPrimitive> all;
  for (std::uint64_t n = 0; n < 400; ++n)
  {
    const auto number = [&](std::uint64_t k) { return random.UniformPair(n, k)[0]; };
    FlowPrimitive one = Primitive(static_cast<FlowType>(n % NumberOfFlowTypes), number(0) - 0.3, 0.2);
    one.Center = Vector3(40.0 * number(1), 10.0 * number(2), -3.0 * number(3));
    const Vector3 half = n % 50 == 0 ? Vector3(30.0, 0.0, 9.0) : n % 9 == 0 ? Vector3(0.0) : Vector3(0.5, 0.3, 1.0);
    one.InfluenceBox = { one.Center - half, one.Center + half * number(4) };
    one.InfluenceMargin = n % 60 == 7 ? 0.0 : 0.1 + number(5);
    one.InfluenceRadius = n % 7 == 3 ? 1.0 : 0.0;
    all.push_back(one);
  }
  const FlowField field(all);
  const auto number = [&random](std::uint64_t n, std::uint64_t k) { return random.UniformPair(n, k)[0]; };
  std::vector<FlowField> alone;
  for (const FlowPrimitive& one : all)
  {
    alone.push_back(FlowField({ one }));
  }
  int moving = 0;
  for (std::uint64_t n = 0; n < 3000; ++n)
  {
    const Vector3 place(60.0 * number(n, 6) - 10.0, 20.0 * number(n, 7) - 5.0, 8.0 * number(n, 8) - 6.0);
    Vector3 sum(0.0);
    for (const FlowField& one : alone)
    {
      sum += one.Velocity(place);
    }
    ASSERT_LT(glm::length(field.Velocity(place) - sum), 1e-12);
    moving += glm::length(sum) > 1e-3;
  }
  EXPECT_GT(moving, 2000);
  EXPECT_FALSE(IsFinite(field.Velocity({ NaN, 0.0, 0.0 })));
}

TEST(BoxCells, FindWhatHoldsAPlace)
{
  const RandomStream random(6, RandomPurpose::ParticlePositions);
  for (const bool isHuge : { false, true })
  {
    std::vector<Box> boxes;
    for (std::uint64_t n = 0; n < 200; ++n)
    {
      const auto number = [&](std::uint64_t k) { return random.UniformPair(n, k)[0]; };
      const Vector3 low(number(0), number(1), number(2));
      boxes.push_back({ low, low + 0.1 * number(3) });
    }
    if (isHuge)
    {
      boxes.push_back({ Vector3(-1.7e308), Vector3(1.7e308) });
      boxes.push_back({ Vector3(-Infinity, 0.0, 0.0), Vector3(0.5, Infinity, 1e-300) });
    }
    const BoxCells cells(boxes);
    std::vector<Vector3> places;
    for (const Box& box : boxes)
    {
      places.insert(places.end(), { box.Low, box.High, 0.5 * (box.Low + box.High) });
    }
    std::size_t listed = 0;
    for (const Vector3& place : places)
    {
      const BoxCells::List near = cells.Near(place);
      listed += near.End - near.Begin;
      EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
      for (int box = 0; box < static_cast<int>(boxes.size()); ++box)
      {
        const bool holds = Distance(boxes[box], place) == 0.0;
        EXPECT_TRUE(!holds || std::find(near.begin(), near.end(), box) != near.end());
      }
    }
    EXPECT_TRUE(isHuge || listed < 20 * places.size()) << listed;
  }
  EXPECT_EQ(BoxCells().Near(Vector3(0.0)).Begin, nullptr);
  EXPECT_EQ(BoxCells(std::vector<Box>{ {} }).Near(Vector3(NaN)).Begin, nullptr);
  EXPECT_NE(BoxCells(std::vector<Box>{ {} }).Near(Vector3(0.0)).Begin, nullptr);
}

namespace
{

/// A stem of ten points that leans as it moves.
MovingPlant Stem(const Vector3& velocity, const Vector3& acceleration, double lean = 0.0)
{
  std::vector<MovingPoint> points;
  for (int n = 0; n < 10; ++n)
  {
    points.push_back({ { lean * n / 9.0, 0.0, 0.2 * n }, velocity, acceleration, 1e-4, 0.1 });
  }
  return PlantOf(points);
}

}

TEST(PlantWake, IsWholeInTheBoundingBox)
{
  for (const WakeKind kind : { WakeKind::Source, WakeKind::Doublet })
  {
    WakeOptions options;
    options.Kind = kind;
    const MovingPlant plant = Stem({ 0.4, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, 0.7);
    const std::vector<FlowPrimitive> wake = WakeOf(plant, options);
    for (const FlowPrimitive& one : wake)
    {
      EXPECT_EQ(WhyInvalid(one), "");
      EXPECT_EQ(one.InfluenceBox.Low, Vector3(0.0));
      EXPECT_LT(glm::length(one.InfluenceBox.High - Vector3(0.7, 0.0, 1.8)), 1e-15);
      EXPECT_EQ(one.InfluenceMargin, options.Margin);
      EXPECT_NEAR(one.CoreRadius, options.CoreShare * 0.5 * std::hypot(0.7, 1.8), 1e-12); // whatever the margin
    }
    const FlowField field(wake);
    EXPECT_GT(glm::length(field.Velocity({ 0.3, 0.1, 0.9 })), 0.0);
    EXPECT_GT(glm::length(field.Velocity({ 0.0, 0.0, 2.2 })), 0.0);
    EXPECT_EQ(field.Velocity({ 0.3, 0.0, 2.3 + 1e-9 }), Vector3(0.0)); // within the sphere about the box
    EXPECT_EQ(field.Velocity({ 0.3, -0.5 - 1e-9, 0.9 }), Vector3(0.0));
  }
}

TEST(PlantWake, OfAThinStemReachesParticlesBesideIt)
{
  // As strong as that of a stem that leans, whose box is not flat.
  const auto beside = [](double lean, double far) {
    return FlowField(WakeOf(Stem({ 0.4, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, lean), {})).Velocity({ lean + far, 0.0, 0.9 }).x;
  };
  EXPECT_GT(beside(0.0, 0.1), 0.01);
  EXPECT_GT(beside(0.0, 0.25), 0.005);
  EXPECT_GT(beside(0.0, 0.1), 0.5 * beside(0.3, 0.1));
  // Even of a single point.
  MovingPoint point;
  point.Velocity = Vector3(0.4, 0.0, 0.0);
  point.Acceleration = Vector3(1.0, 0.0, 0.0);
  point.Weight = 1.0;
  EXPECT_GT(FlowField(WakeOf(PlantOf({ point }), {})).Velocity({ 0.1, 0.0, 0.0 }).x, 0.01);
}

TEST(PlantWake, PushesAwayWhileThePlantGetsFaster)
{
  const auto ahead = [](const WakeOptions& options, double velocity, double acceleration) {
    return FlowField(WakeOf(Stem({ velocity, 0.0, 0.0 }, { acceleration, 0.0, 0.0 }), options))
      .Velocity({ 0.3, 0.0, 0.9 })
      .x;
  };
  WakeOptions source;
  EXPECT_GT(ahead(source, 0.4, 1.0), 0.0);
  EXPECT_LT(ahead(source, 0.4, -1.0), 0.0);
  EXPECT_GT(ahead(source, -0.4, -1.0), 0.0);
  EXPECT_EQ(ahead(source, 0.0, 1.0), 0.0);
  EXPECT_DOUBLE_EQ(ahead(source, -0.4, -1.0), ahead(source, 0.4, 1.0));
  WakeOptions doublet;
  doublet.Kind = WakeKind::Doublet;
  EXPECT_GT(ahead(doublet, 0.4, 0.0), 0.0);
  EXPECT_NEAR(ahead(doublet, -0.4, 0.0), -ahead(doublet, 0.4, 0.0), 1e-15);
  EXPECT_EQ(ahead(doublet, 0.0, 1.0), 0.0);
  EXPECT_FALSE(FlowField(WakeOf(Stem({ 0.4, 0.0, 0.0 }, Vector3(0.0)), doublet)).HasSinks());
}

TEST(PlantWake, DoubletHasTheMomentOfASphereOfThePlantsVolume)
{
  std::vector<MovingPoint> points(2);
  points[0].Place = Vector3(1.0, 0.0, 0.0);
  points[1].Place = Vector3(1.0, 0.4, 0.8);
  for (MovingPoint& point : points)
  {
    point.Velocity = Vector3(0.0, 0.3, 0.4);
    point.Weight = 3.0;
    point.Volume = 0.02;
  }
  const MovingPlant plant = PlantOf(points);
  EXPECT_NEAR(plant.Volume, 0.04, 1e-15);
  WakeOptions options;
  options.Kind = WakeKind::Doublet;
  options.Strength = 2.0;
  const std::vector<FlowPrimitive> wake = WakeOf(plant, options);
  ASSERT_EQ(wake.size(), 2u);
  // 2 pi R^3 v, with the volume 4 pi R^3 / 3
  const Vector3 moment = wake[0].Strength * wake[0].Center + wake[1].Strength * wake[1].Center;
  EXPECT_LT(glm::length(moment - 2.0 * 1.5 * 0.04 * Vector3(0.0, 0.3, 0.4)), 1e-14);
}

TEST(PlantWake, SaysWhatIsWrong)
{
  const auto named = [](double WakeOptions::*member, double value, const char* word) {
    WakeOptions options;
    options.*member = value;
    return WhyInvalid(options).find(word) == 0;
  };
  EXPECT_EQ(WhyInvalid(WakeOptions{}), "");
  EXPECT_TRUE(named(&WakeOptions::Strength, -1.0, "Strength"));
  EXPECT_TRUE(named(&WakeOptions::Margin, 0.0, "Margin"));
  EXPECT_TRUE(named(&WakeOptions::Margin, NaN, "Margin"));
  EXPECT_TRUE(named(&WakeOptions::CoreShare, 2.0, "CoreShare"));
}

TEST(FlowPrimitives, VorticesHaveNoDivergence)
{
  for (const double reach : { 0.0, 2.0 })
  {
    FlowPrimitive primitive = Primitive(FlowType::Vortex, 3.0, 0.3, reach);
    primitive.Axis = Vector3(0.3, -0.5, 2.0);
    const FlowField field({ primitive });
    for (const Vector3 place : { Vector3(0.1, 0.2, 0.3), Vector3(-1.0, 0.5, 0.4), Vector3(0.0, 0.0, 1.5) })
    {
      EXPECT_NEAR(Divergence(field, place), 0.0, 1e-8);
    }
  }
}

namespace
{

class AllFlows : public testing::TestWithParam<int>
{
protected:
  AllFlows() { this->Flow.Axis = Vector3(0.3, -0.5, 2.0); }
  FlowPrimitive Flow = Primitive(static_cast<FlowType>(GetParam()), 3.0, 0.3);
  const FlowTraits& Traits = TraitsOf(static_cast<FlowType>(GetParam()));
  const std::vector<Vector3> Places{ { 0.1, 0.2, 0.3 }, { -1.0, 0.5, 0.4 }, { 0.05, 0.0, 1.5 } };
};

}

TEST_P(AllFlows, HaveNoDivergenceWhereNoneIsClaimed)
{
  const FlowField field({ this->Flow });
  double most = 0.0;
  for (const Vector3& place : this->Places)
  {
    most = std::max(most, std::abs(Divergence(field, place)));
  }
  EXPECT_EQ(most < 1e-8, this->Traits.IsSolenoidal) << most;
}

TEST_P(AllFlows, GrowWithTheirStrength)
{
  FlowPrimitive twice = this->Flow;
  twice.Strength = -2.0 * this->Flow.Strength;
  for (const Vector3& place : this->Places)
  {
    const Vector3 flow = FlowField({ this->Flow }).Velocity(place);
    EXPECT_GT(glm::length(flow), 0.0);
    EXPECT_LT(glm::length(FlowField({ twice }).Velocity(place) + 2.0 * flow), 1e-12 * glm::length(flow));
  }
}

TEST_P(AllFlows, DependOnAxisAndCoreWhereTheseCount)
{
  FlowPrimitive turned = this->Flow;
  turned.Axis = Vector3(1.0, 0.0, 0.0);
  FlowPrimitive wide = this->Flow;
  wide.CoreRadius = 0.5;
  const auto differs = [&](const FlowPrimitive& other) {
    const Vector3 place = this->Places[0];
    return FlowField({ other }).Velocity(place) != FlowField({ this->Flow }).Velocity(place);
  };
  EXPECT_EQ(differs(turned), this->Traits.HasAxis);
  EXPECT_EQ(differs(wide), this->Traits.HasCore);
  turned.Axis = Vector3(0.0);
  wide.CoreRadius = 0.0;
  EXPECT_EQ(WhyInvalid(turned).find("Axis") == 0, this->Traits.HasAxis);
  EXPECT_EQ(WhyInvalid(wide).find("CoreRadius") == 0, this->Traits.HasCore);
}

TEST_P(AllFlows, CaptureWhereTheySaySo)
{
  const FlowField field({ this->Flow });
  Vector3 to(1.0, 0.0, 0.0);
  EXPECT_EQ(field.HasSinks(), this->Traits.Captures);
  EXPECT_EQ(field.Capture({ -1.0, 0.1, 0.0 }, to), this->Traits.Captures);
}

TEST_P(AllFlows, GoThroughNoWall)
{
  for (const double reach : { 0.0, 4.0 })
  {
    FlowPrimitive flow = this->Flow;
    flow.Center = Vector3(0.0, 0.0, -1.2);
    flow.InfluenceRadius = reach;
    const FlowField field({ flow }, WaterLayer{ -3.0, 0.0 });
    for (const double wall : { -3.0, 0.0 })
    {
      for (const Vector3& place : { Vector3(0.4, 0.3, wall), Vector3(-1.0, 2.0, wall), Vector3(2.5, -0.2, wall) })
      {
        const Vector3 velocity = field.Velocity(place);
        EXPECT_LT(std::abs(velocity.z), 1e-3 * glm::length(velocity) + 1e-12) << "reach " << reach;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(FlowPrimitives, AllFlows, testing::Range(0, NumberOfFlowTypes),
  [](const auto& one) { return TraitsOf(static_cast<FlowType>(one.param)).Name; });

TEST(FlowPrimitives, Add)
{
  FlowPrimitive other = Primitive(FlowType::Source, 1.0);
  other.Center = Vector3(1.0, 2.0, 3.0);
  const FlowPrimitive one = Primitive(FlowType::Vortex, 2.0);
  const Vector3 place(0.4, -0.3, 0.2);
  const Vector3 sum = FlowField({ one }).Velocity(place) + FlowField({ other }).Velocity(place);
  EXPECT_LT(glm::length(FlowField({ one, other }).Velocity(place) - sum), 1e-15);
  EXPECT_TRUE(FlowField().IsEmpty() && FlowField().IsUniform());
  EXPECT_EQ(FlowField().Velocity(place), Vector3(0.0));
}

TEST(FlowPrimitives, SayWhatIsWrong)
{
  const auto named = [](const FlowPrimitive& primitive, const char* word) {
    return WhyInvalid(primitive).find(word) != std::string::npos;
  };
  EXPECT_EQ(WhyInvalid(FlowPrimitive{}), "");
  EXPECT_TRUE(named(Primitive(FlowType::Vortex, NaN), "Strength"));
  EXPECT_TRUE(named(Primitive(FlowType::Vortex, 1.0, 0.0), "CoreRadius"));
  EXPECT_TRUE(named(Primitive(FlowType::Sink, 1.0, -1.0), "CoreRadius"));
  EXPECT_TRUE(named(Primitive(FlowType::Sink, 1.0, 1.0, -2.0), "InfluenceRadius"));
  EXPECT_TRUE(named(Primitive(FlowType::Sink, 1.0, 1.0, Infinity), "InfluenceRadius"));
  EXPECT_TRUE(named(Primitive(static_cast<FlowType>(NumberOfFlowTypes), 1.0), "FlowType"));
  FlowPrimitive primitive;
  for (const double margin : { -1.0, NaN, Infinity })
  {
    primitive.InfluenceMargin = margin;
    EXPECT_TRUE(named(primitive, "InfluenceMargin"));
  }
  primitive.InfluenceMargin = 0.5;
  EXPECT_EQ(WhyInvalid(primitive), "");
  primitive.InfluenceBox.Low.y = 0.1;
  EXPECT_TRUE(named(primitive, "InfluenceBox"));
  primitive.InfluenceBox.Low.y = NaN;
  EXPECT_TRUE(named(primitive, "InfluenceBox"));
  primitive = {};
  primitive.Axis = Vector3(0.0);
  EXPECT_TRUE(named(primitive, "Axis"));
  primitive.Axis = Vector3(1.0);
  primitive.Center.y = NaN;
  EXPECT_TRUE(named(primitive, "Center"));
}

TEST(Drift, StaysOnTheCirclesOfAVortex)
{
  // Solid rotation, the Lamb-Oseen peak, and far away; 0.05 rad a step.
  for (const double r : { 0.05, 0.56, 5.0 })
  {
    const FlowField field({ Primitive(FlowType::Vortex, 2.0, 0.5) });
    const double rate = field.Velocity({ r, 0.0, 0.0 }).y / r;
    const double step = 0.05 / rate;
    const long steps = std::lround(100.0 * TwoPi / 0.05);
    const Vector3 end = Drifted(field, { r, 0.0, -3.0 }, step, steps);
    const double error = std::abs(std::hypot(end.x, end.y) / r - 1.0);
    std::cout << "radius " << r << " m after 100 turns is off by " << error << std::endl;
    EXPECT_LT(error, 1e-4);
    EXPECT_EQ(end.z, -3.0);
  }
}

TEST(Drift, IsOfFourthOrder)
{
  FlowPrimitive source = Primitive(FlowType::Source, 1.0, 0.3);
  source.Center = Vector3(1.0, -0.5, 0.2);
  const FlowField field({ source, Primitive(FlowType::Vortex, 2.0, 0.4), Primitive(FlowType::Uniform, 0.2) });
  const Vector3 start(0.5, 0.2, -0.3);
  const Vector3 fine = Drifted(field, start, 4.0 / 4096, 4096);
  const double coarse = glm::length(Drifted(field, start, 4.0 / 64, 64) - fine);
  const double half = glm::length(Drifted(field, start, 4.0 / 128, 128) - fine);
  EXPECT_NEAR(std::log2(coarse / half), 4.0, 0.4);
}

TEST(Drift, OfASourceIsTheCubeRoot)
{
  // r^3 grows by 3 Q t / 4 pi far outside of the core.
  const FlowField field({ Primitive(FlowType::Source, 10.0, 1e-3) });
  const double end = Drifted(field, { 1.0, 0.0, 0.0 }, 0.01, 1000).x;
  EXPECT_NEAR(end, std::cbrt(1.0 + 3.0 * 10.0 * 10.0 / (4.0 * Pi)), 2e-5);
}

TEST(Drift, IsMirrored)
{
  const WaterLayer layer{ -10.0, 2.0 };
  FlowPrimitive up = Primitive(FlowType::Uniform, 1.0);
  const FlowField field({ up });
  double height = 2.0;
  bool upright = true;
  for (const double z : { -10.0, -4.0, 2.0 })
  {
    EXPECT_EQ(layer.Fold(z, upright), z);
    EXPECT_TRUE(upright);
  }
  EXPECT_DOUBLE_EQ(layer.Fold(3.0, upright), 1.0);
  EXPECT_FALSE(upright);
  EXPECT_DOUBLE_EQ(layer.Fold(-11.0, upright), -9.0);
  EXPECT_FALSE(upright);
  EXPECT_DOUBLE_EQ(layer.Fold(2.0 + 12.0 + 3.0, upright), -7.0);
  EXPECT_TRUE(upright);
  EXPECT_DOUBLE_EQ((WaterLayer{ -Infinity, 2.0 }.Fold(5.0, upright)), -1.0);
  EXPECT_DOUBLE_EQ((WaterLayer{ -1.0, Infinity }.Fold(-5.0, upright)), 3.0);
  Vector3 place(0.0, 0.0, -5.0);
  for (int n = 0; n < 1000; ++n)
  {
    place = Drifted(field, place, 0.1, 1, layer);
    ASSERT_TRUE(place.z >= -10.0 && place.z <= 2.0);
    height = place.z;
  }
  EXPECT_NEAR(height, 2.0, 0.1); // even in a flow that goes through the surface, as none of a field in a layer does
}

TEST(Drift, IsCapturedBySinks)
{
  FlowPrimitive sink = Primitive(FlowType::Sink, 1.0, 0.25);
  sink.Center = Vector3(5.0, 0.0, 0.0);
  const FlowField field({ Primitive(FlowType::Source, 1.0), sink });
  Vector3 to(6.0, 0.2, 0.0);
  EXPECT_TRUE(field.Capture({ 4.0, 0.2, 0.0 }, to)); // in one long step, over the core
  EXPECT_LE(glm::length(to - sink.Center), 0.25);
  to = Vector3(6.0, 0.3, 0.0);
  EXPECT_FALSE(field.Capture({ 4.0, 0.3, 0.0 }, to));
  EXPECT_EQ(to, Vector3(6.0, 0.3, 0.0));
  to = Vector3(4.5, 0.0, 0.0); // the core lies ahead, on the way's line
  EXPECT_FALSE(field.Capture({ 3.0, 0.0, 0.0 }, to));
  to = Vector3(7.0, 0.0, 0.0); // behind
  EXPECT_FALSE(field.Capture({ 5.5, 0.0, 0.0 }, to));
  EXPECT_EQ(to, Vector3(7.0, 0.0, 0.0));
  to = Vector3(0.0, 0.0, 0.0); // the core of a source holds nothing
  EXPECT_FALSE(field.Capture(to, to));
  to = sink.Center;
  EXPECT_TRUE(field.Capture(to, to));
}

TEST(Particles, FillTheirBox)
{
  ParticleBox box;
  box.Lower = Vector3(1e6, -3.0, 440.0);
  box.Upper = Vector3(1e6 + 10.0, 5.0, 450.0);
  box.Amount = 40.0;
  EXPECT_EQ(NumberIn(box, false), 40.0 * 800.0);
  EXPECT_EQ(NumberIn(box, true), 40.0);
  box.Amount = 2.6 / 800.0; // the nearest whole number
  EXPECT_EQ(NumberIn(box, false), 3.0);
  box.Amount = 2.4 / 800.0;
  EXPECT_EQ(NumberIn(box, false), 2.0);
  Vector3 mean(0.0);
  Vector3 crossed(0.0); // xy, yz, zx
  double logarithm = 0.0;
  const int count = 20000;
  for (int n = 0; n < count; ++n)
  {
    const SuspendedParticle particle = ParticleOf(box, 3, n, 0.3, 7);
    const Vector3 part = (particle.Place - box.Lower) / (box.Upper - box.Lower);
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_TRUE(part[axis] > 0.0 && part[axis] < 1.0);
    }
    mean += part / static_cast<double>(count);
    const Vector3 off = part - 0.5;
    crossed += off * Vector3(off.y, off.z, off.x) / static_cast<double>(count);
    logarithm += std::log(2.0 * particle.Radius / box.Diameter) / count;
  }
  const double bound = 4.0 / std::sqrt(12.0 * count);
  EXPECT_NEAR(mean.x, 0.5, bound);
  EXPECT_NEAR(mean.y, 0.5, bound);
  EXPECT_NEAR(mean.z, 0.5, bound);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(crossed[axis], 0.0, 4.0 / (12.0 * std::sqrt(1.0 * count)));
  }
  EXPECT_NEAR(logarithm, 0.0, 4.0 * 0.3 / std::sqrt(1.0 * count));
  EXPECT_EQ(ParticleOf(box, 3, 5, 0.0, 7).Radius, 0.5 * box.Diameter);
  EXPECT_NE(ParticleOf(box, 3, 5, 0.3, 7).Place, ParticleOf(box, 4, 5, 0.3, 7).Place);
  std::set<double> depths; // boxes and particles that stand for each other would have the same
  for (int boxId = 0; boxId < 10; ++boxId)
  {
    for (long long n = 0; n < 100; ++n)
    {
      depths.insert(ParticleOf(box, boxId, n, 0.3, 7).Place.z);
    }
  }
  EXPECT_EQ(depths.size(), 1000u);
  EXPECT_NE(ParticleOf(box, 3, 5, 0.3, 7).Place, ParticleOf(box, 3, 5, 0.3, 8).Place);
}

TEST(Particles, TurnAllWays)
{
  Vector3 mean(0.0);
  double square = 0.0;
  const int count = 20000;
  for (int n = 0; n < count; ++n)
  {
    const PictureAxes axes = OrientationOf(0, n, 1);
    ASSERT_NEAR(glm::length(axes.Right), 1.0, 1e-12);
    ASSERT_NEAR(glm::length(axes.Up), 1.0, 1e-12);
    ASSERT_NEAR(glm::dot(axes.Right, axes.Up), 0.0, 1e-12);
    const Vector3 normal = glm::cross(axes.Right, axes.Up);
    mean += normal / static_cast<double>(count);
    square += normal.z * normal.z / count;
  }
  EXPECT_LT(glm::length(mean), 0.03);
  EXPECT_NEAR(square, 1.0 / 3.0, 0.01);
}

TEST(Particles, ScenesPutKindsWhereTheyLive)
{
  const Vector3 lower(-10.0, -10.0, -12.0);
  const Vector3 upper(10.0, 10.0, 0.0);
  for (int scene = 1; scene <= 4; ++scene)
  {
    double total = 0.0;
    int index = 0;
    for (const ParticleBox& box : BoxesOf(static_cast<ParticleScene>(scene), lower, upper))
    {
      EXPECT_EQ(WhyInvalid(box, index++), "");
      total += NumberIn(box, false);
      EXPECT_TRUE(box.Lower.z >= -12.0 && box.Upper.z <= 1e-12);
      if (box.Kind == ParticleKind::Grain)
      {
        EXPECT_EQ(box.Lower.z, -12.0) << "minerals lie on the bed";
      }
    }
    EXPECT_TRUE(total > 3000.0 && total < 100000.0) << total;
  }
  EXPECT_DOUBLE_EQ(BoxesOf(ParticleScene::CoastalSea, lower, upper).front().Upper.z, 0.0);
}

TEST(Particles, PicturesAreOpaqueWithinAndEmptyAtTheEdge)
{
  for (int kind = 0; kind < ParticleKinds; ++kind)
  {
    const TextureImage picture = ParticlePicture(static_cast<ParticleKind>(kind));
    const int last = ParticlePictureSize - 1;
    EXPECT_GT(picture.At(last / 2, last / 2)[3], 128) << ParticleKindName(static_cast<ParticleKind>(kind));
    double covered = 0.0;
    for (int n = 0; n <= last; ++n)
    {
      EXPECT_LT(picture.At(0, n)[3] + picture.At(last, n)[3] + picture.At(n, 0)[3] + picture.At(n, last)[3], 40)
        << ParticleKindName(static_cast<ParticleKind>(kind));
    }
    for (const Texel& texel : picture.Texels)
    {
      covered += texel[3] / 255.0 / static_cast<double>(picture.Texels.size());
    }
    EXPECT_TRUE(covered > 0.1 && covered < 0.8) << covered;
  }
}

TEST(Particles, SayWhatIsWrong)
{
  const auto named = [](const ParticleBox& box, const char* word) {
    return WhyInvalid(box, 2).find(word) != std::string::npos && WhyInvalid(box, 2).find("box 2") == 0;
  };
  ParticleBox good;
  EXPECT_EQ(WhyInvalid(good, 0), "");
  ParticleBox box = good;
  std::swap(box.Lower.z, box.Upper.z);
  EXPECT_TRUE(named(box, "bounds"));
  box = good;
  box.Lower.x = NaN;
  EXPECT_TRUE(named(box, "bounds"));
  box = good;
  box.Upper.x = Infinity;
  EXPECT_TRUE(named(box, "bounds"));
  box = good;
  box.Kind = static_cast<ParticleKind>(9);
  EXPECT_TRUE(named(box, "kind"));
  box = good;
  box.Diameter = 0.0;
  EXPECT_TRUE(named(box, "diameter"));
  box = good;
  box.Amount = -1.0;
  EXPECT_TRUE(named(box, "amount"));
  box = good;
  box.Color[1] = 1.5;
  EXPECT_TRUE(named(box, "color"));
}
