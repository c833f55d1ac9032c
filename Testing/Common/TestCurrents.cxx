// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Constants.h"
#include "CurrentDrift.h"
#include "FlowPrimitives.h"
#include "SuspendedParticles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>

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
  for (const FlowType type : { FlowType::Uniform, FlowType::Source, FlowType::Sink, FlowType::Vortex })
  {
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
  }
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

TEST(FlowPrimitives, Add)
{
  FlowPrimitive other = Primitive(FlowType::Source, 1.0);
  other.Centre = Vector3(1.0, 2.0, 3.0);
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
  EXPECT_TRUE(named(Primitive(static_cast<FlowType>(4), 1.0), "FlowType"));
  FlowPrimitive primitive;
  primitive.Axis = Vector3(0.0);
  EXPECT_TRUE(named(primitive, "Axis"));
  primitive.Axis = Vector3(1.0);
  primitive.Centre.y = NaN;
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
  source.Centre = Vector3(1.0, -0.5, 0.2);
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
  EXPECT_NEAR(height, 2.0, 0.1); // it rose to the surface and stays there
}

TEST(Drift, IsCapturedBySinks)
{
  FlowPrimitive sink = Primitive(FlowType::Sink, 1.0, 0.25);
  sink.Centre = Vector3(5.0, 0.0, 0.0);
  const FlowField field({ Primitive(FlowType::Source, 1.0), sink });
  Vector3 to(6.0, 0.2, 0.0);
  EXPECT_TRUE(field.Capture({ 4.0, 0.2, 0.0 }, to)); // in one long step, over the core
  EXPECT_LE(glm::length(to - sink.Centre), 0.25);
  to = Vector3(6.0, 0.3, 0.0);
  EXPECT_FALSE(field.Capture({ 4.0, 0.3, 0.0 }, to));
  EXPECT_EQ(to, Vector3(6.0, 0.3, 0.0));
  to = Vector3(0.0, 0.0, 0.0); // the core of a source holds nothing
  EXPECT_FALSE(field.Capture(to, to));
  to = sink.Centre;
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
  Vector3 mean(0.0);
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
    logarithm += std::log(2.0 * particle.Radius / box.Diameter) / count;
  }
  const double bound = 4.0 / std::sqrt(12.0 * count);
  EXPECT_NEAR(mean.x, 0.5, bound);
  EXPECT_NEAR(mean.y, 0.5, bound);
  EXPECT_NEAR(mean.z, 0.5, bound);
  EXPECT_NEAR(logarithm, 0.0, 4.0 * 0.3 / std::sqrt(1.0 * count));
  EXPECT_EQ(ParticleOf(box, 3, 5, 0.0, 7).Radius, 0.5 * box.Diameter);
  EXPECT_NE(ParticleOf(box, 3, 5, 0.3, 7).Place, ParticleOf(box, 4, 5, 0.3, 7).Place);
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
      covered += texel[3] / 255.0 / picture.Texels.size();
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
  box.Colour[1] = 1.5;
  EXPECT_TRUE(named(box, "colour"));
}
