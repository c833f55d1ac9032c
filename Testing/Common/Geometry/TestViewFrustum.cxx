// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../PictureOf.h"
#include "Geometry/ViewFrustum.h"
#include "Numerics/Constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace littoral;

namespace
{

Vector3 RandomVector(std::mt19937& random, double size)
{
  std::uniform_real_distribution<double> uniform(-size, size);
  return { uniform(random), uniform(random), uniform(random) };
}

View RandomView(std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  View view;
  view.Point = RandomVector(random, 5.0);
  view.Direction = RandomVector(random, 3.0);
  view.Up = RandomVector(random, 2.0);
  view.Angle = 0.1 + 2.5 * uniform(random);
  view.AspectRatio = 0.3 + 2.0 * uniform(random);
  view.Near = uniform(random);
  view.Far = uniform(random) < 0.5 ? view.Near + 10.0 * uniform(random) : std::numeric_limits<double>::infinity();
  return view;
}

/// Projects the point on the picture, as a camera does.
bool IsShown(const View& view, const Vector3& point)
{
  const Vector3 ahead = glm::normalize(view.Direction);
  const double along = glm::dot(ahead, view.Up);
  const Vector3 up = glm::normalize(view.Up - along * ahead);
  const Vector3 away = point - view.Point;
  const double depth = glm::dot(ahead, away);
  const double y = glm::dot(up, away);
  const double x2 = glm::dot(away, away) - depth * depth - y * y;
  const double half = depth * std::tan(view.Angle / 2.0);
  return depth >= view.Near && depth <= view.Far && std::abs(y) <= half &&
    std::sqrt(std::max(x2, 0.0)) <= half * view.AspectRatio;
}

}

TEST(ViewFrustum, HoldsThePointsThatACameraProjectsOnThePicture)
{
  std::mt19937 random(1);
  int shown = 0;
  for (int n = 0; n < 200; ++n)
  {
    const View view = RandomView(random);
    ASSERT_EQ(WhyInvalid(view), "");
    const ViewFrustum frustum(view);
    for (int k = 0; k < 200; ++k)
    {
      const Vector3 point = RandomVector(random, 15.0);
      EXPECT_EQ(frustum.MayShow(point, 0.0), IsShown(view, point));
      shown += IsShown(view, point);
    }
  }
  EXPECT_GT(shown, 2000);
  EXPECT_LT(shown, 20000);
}

TEST(ViewFrustum, NeverRejectsABoxOrSphereWithAShownPoint)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int rejectedBoxes = 0;
  int rejectedSpheres = 0;
  for (int n = 0; n < 3000; ++n)
  {
    const View view = RandomView(random);
    const ViewFrustum frustum(view);
    Box box;
    box.Low = RandomVector(random, 10.0);
    for (int axis = 0; axis < 3; ++axis)
    {
      box.High[axis] = box.Low[axis] + 4.0 * uniform(random);
    }
    const Vector3 center = RandomVector(random, 10.0);
    const double radius = 3.0 * uniform(random);
    bool boxShown = false;
    bool sphereShown = false;
    for (int k = 0; k < 100; ++k)
    {
      Vector3 point;
      for (int axis = 0; axis < 3; ++axis)
      {
        point[axis] = box.Low[axis] + (box.High[axis] - box.Low[axis]) * uniform(random);
      }
      boxShown = boxShown || IsShown(view, point);
      const Vector3 step = RandomVector(random, radius);
      if (glm::dot(step, step) <= radius * radius)
      {
        sphereShown = sphereShown || IsShown(view, { center[0] + step[0], center[1] + step[1], center[2] + step[2] });
      }
    }
    EXPECT_TRUE(frustum.MayShow(box) || !boxShown);
    EXPECT_TRUE(frustum.MayShow(center, radius) || !sphereShown);
    rejectedBoxes += !frustum.MayShow(box);
    rejectedSpheres += !frustum.MayShow(center, radius);
  }
  EXPECT_GT(rejectedBoxes, 1000);
  EXPECT_GT(rejectedSpheres, 1000);
}

TEST(ViewFrustum, ARoundedViewHoldsWhatTheViewShows)
{
  std::mt19937 random(8);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int shown = 0;
  for (int n = 0; n < 400; ++n)
  {
    View view = RandomView(random);
    view.Angle = 0.1 + 1.5 * uniform(random);
    const ViewFrustum rounded(Rounded(view, 2.0 * uniform(random), 0.25 * uniform(random)));
    for (int m = 0; m < 300; ++m)
    {
      const Vector3 point = view.Point + RandomVector(random, 8.0);
      if (IsShown(view, point))
      {
        ++shown;
        ASSERT_TRUE(rounded.MayShow(point, 0.0));
      }
    }
  }
  EXPECT_GT(shown, 1000);
}

TEST(ViewFrustum, LessDetailIsRoundedToLongerSteps)
{
  View view;
  view.Point = { 4.9, -7.1, 12.1 };
  view.DetailFactor = 0.4;
  const View rounded = Rounded(view, 4.0, 0.0); // to 10 m
  EXPECT_EQ(rounded.Point, Vector3(0.0, -10.0, 10.0));
  EXPECT_DOUBLE_EQ(rounded.Margin, view.Margin + 5.0 * std::sqrt(3.0));
}

// Views of all kinds by other matrices: what is on the picture is in the volume, and nothing else.
TEST(ViewFrustum, HoldsThePictureInPerspectiveAndInParallel)
{
  std::mt19937 random(21);
  int shown[2] = { 0, 0 };
  for (int n = 0; n < 600; ++n)
  {
    View view = AnyView(random, 50.0);
    view.Near = n % 3 == 0 ? 0.02 * (n % 100) : 0.0;
    view.Far = n % 5 == 0 ? 60.0 : std::numeric_limits<double>::infinity();
    const ViewFrustum frustum(view);
    const PictureOf picture(view);
    for (int k = 0; k < 200; ++k)
    {
      const Vector3 place = RandomVector(random, 60.0);
      ASSERT_EQ(frustum.MayShow(place, 0.0), picture.Shows(place)) << n;
      shown[view.IsParallel] += picture.Shows(place);
    }
  }
  EXPECT_GT(shown[0], 5000);
  EXPECT_GT(shown[1], 5000);
}

// Rounded to coarse steps, with places near the corners of the picture, where a turn moves most.
TEST(ViewFrustum, ARoundedViewHoldsThePictureOfAnyView)
{
  std::mt19937 random(22);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int shown[2] = { 0, 0 };
  int rejected = 0;
  for (int n = 0; n < 1500; ++n)
  {
    View view = AnyView(random, 50.0);
    view.Far = n % 3 == 0 ? 20.0 + n % 50 : view.Far;
    const ViewFrustum rounded(Rounded(view, 3.0 * uniform(random), 0.25 * std::pow(uniform(random), 2)));
    const PictureOf picture(view);
    const Vector3 ahead = glm::normalize(view.Direction);
    const Vector3 right = glm::normalize(glm::cross(ahead, view.Up));
    const Vector3 up = glm::cross(right, ahead);
    for (int k = 0; k < 200; ++k)
    {
      const double depth = 200.0 * std::pow(uniform(random), 3);
      const double half = view.IsParallel ? view.ParallelScale : depth * std::tan(0.5 * view.Angle);
      const double x = (k & 1 ? 1.0 : -1.0) * std::pow(uniform(random), 0.1) * half * view.AspectRatio;
      const double y = (k & 2 ? 1.0 : -1.0) * std::pow(uniform(random), 0.1) * half;
      const Vector3 place = view.Point + depth * ahead + x * right + y * up;
      if (picture.Shows(place))
      {
        ++shown[view.IsParallel];
        ASSERT_TRUE(rounded.MayShow(place, 0.0)) << n << " " << view.IsParallel;
      }
      rejected += !rounded.MayShow(RandomVector(random, 60.0), 0.0);
    }
  }
  EXPECT_GT(shown[0], 100000);
  EXPECT_GT(shown[1], 100000);
  EXPECT_GT(rejected, 100000);
}

// Rays of the rim, corners and all, turned by the whole margin in any direction.
TEST(ViewFrustum, AnAngleMarginHoldsWhatATurnPutsOnThePicture)
{
  std::mt19937 random(24);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int n = 0; n < 300; ++n)
  {
    View view = RandomView(random);
    view.Angle = 0.3 + uniform(random);
    view.AngleMargin = 0.2 * uniform(random);
    const ViewFrustum frustum(view);
    const Vector3 ahead = glm::normalize(view.Direction);
    const Vector3 right = glm::normalize(glm::cross(ahead, view.Up));
    const Vector3 up = glm::cross(right, ahead);
    const double tangent = std::tan(0.5 * view.Angle);
    for (int k = 0; k < 200; ++k)
    {
      const double x = (k & 1 ? 1.0 : -1.0) * view.AspectRatio * tangent;
      const double y = (k & 2 ? 1.0 : -1.0) * (k & 4 ? 1.0 : uniform(random)) * tangent;
      const Vector3 ray = glm::normalize(ahead + x * right + y * up);
      const Vector3 aside = glm::normalize(glm::cross(ray, RandomVector(random, 1.0)));
      const double turn = (1.0 - 1e-9) * view.AngleMargin;
      ASSERT_TRUE(frustum.MayShow(view.Point + std::cos(turn) * ray + std::sin(turn) * aside, 1e-12)) << n;
    }
  }
}

// Whatever view of those that round to one, wherever on its picture. Small boxes on the picture get 1 % more on
// average.
TEST(ViewFrustum, ARiseIsNowhereTallerOnThePicture)
{
  std::mt19937 random(23);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int shown[2] = { 0, 0 };
  int finite = 0;
  double waste = 0.0;
  int wasteSum = 0;
  for (int n = 0; n < 6000; ++n)
  {
    const View view = AnyView(random, 50.0);
    const bool rounds = n % 2 == 0;
    const View kept = rounds ? Rounded(view, 2.0 * uniform(random), 0.1 * uniform(random)) : view;
    const ViewFrustum frustum(kept);
    const PictureOf picture(view);
    Box box;
    box.Low = RandomVector(random, 60.0);
    const double size = 20.0 * std::pow(uniform(random), 4);
    box.High = box.Low + Vector3(size * uniform(random), size * uniform(random), size * uniform(random));
    const double rise = uniform(random) * (box.High.z - box.Low.z);
    const double bound = frustum.PixelsOfRise(rise, box);
    double tallest = 0.0;
    bool all = true;
    for (int k = 0; k < 60; ++k)
    {
      Vector3 low;
      for (int axis = 0; axis < 3; ++axis)
      {
        low[axis] = box.Low[axis] + (box.High[axis] - box.Low[axis]) * (k < 8 ? (k >> axis & 1) : uniform(random));
      }
      low.z = std::min(low.z, box.High.z - rise);
      const Vector3 high = low + Vector3(0.0, 0.0, rise);
      all = all && picture.Shows(low) && picture.Shows(high);
      if (picture.Shows(low) || picture.Shows(high))
      {
        ++shown[view.IsParallel];
        tallest = std::max(tallest, picture.PixelsBetween(low, high));
        ASSERT_LE(tallest, bound * (1.0 + 1e-9) + 1e-6) << n << " " << view.IsParallel << " " << rounds;
      }
    }
    finite += std::isfinite(bound) && tallest > 0.0;
    if (view.IsParallel && !rounds && tallest > 0.0) // there a rise is as tall anywhere
    {
      ASSERT_NEAR(bound, tallest, 1e-6 * tallest + 1e-9);
    }
    if (all && !rounds && 20.0 * size < SightDistance(view, box) && !view.IsParallel)
    {
      waste += bound / tallest - 1.0;
      ++wasteSum;
    }
  }
  EXPECT_GT(shown[0], 20000);
  EXPECT_GT(shown[1], 20000);
  EXPECT_GT(finite, 1000);
  ASSERT_GT(wasteSum, 200);
  EXPECT_LT(waste / wasteSum, 0.02);
}

// From straight above a rise is a point, and a line from aside: so far aside as the eye may be.
TEST(ViewFrustum, ARiseBelowTheEyeIsSeenFromWithinTheMargin)
{
  View view;
  view.Point = { 0.0, 0.0, 0.0 };
  view.Direction = { 0.0, 0.0, -1.0 };
  view.Up = { 0.0, 1.0, 0.0 };
  view.Margin = 0.5;
  const Box box{ { -0.01, -0.01, -20.0 }, { 0.01, 0.01, -19.0 } };
  const double bound = ViewFrustum(view).PixelsOfRise(1.0, box);
  for (int side = 0; side < 8; ++side)
  {
    View moved = view;
    moved.Point = { 0.5 * std::cos(side * Pi / 4.0), 0.5 * std::sin(side * Pi / 4.0), 0.0 };
    const double seen = PictureOf(moved).PixelsBetween({ 0.0, 0.0, -20.0 }, { 0.0, 0.0, -19.0 });
    EXPECT_GT(seen, 0.1);
    EXPECT_LE(seen, bound);
  }
  EXPECT_LT(bound, 3.0 * PictureOf(view).PixelsBetween({ 0.5, 0.0, -20.0 }, { 0.5, 0.0, -19.0 }));
}

TEST(ViewFrustum, DistancesInParallelProjection)
{
  View view;
  view.Point = { 3.0, -10.0, 2.0 };
  view.Angle = Pi / 2.0;
  view.ParallelScale = 25.0;
  const Vector3 place{ 3.0, -7.0, 6.0 };
  EXPECT_DOUBLE_EQ(LevelDistance(view, place), 5.0);
  EXPECT_DOUBLE_EQ(SightDistance(view, place), 5.0);
  view.IsParallel = true;
  EXPECT_DOUBLE_EQ(LevelDistance(view, place), 25.0); // 50 m fill a perspective of 90 degrees at 25 m
  EXPECT_DOUBLE_EQ(SightDistance(view, place), 3.0);
  EXPECT_DOUBLE_EQ(SightDistance(view, Box{ { -9.0, -8.5, 0.0 }, place }), 1.5);
  // What fills the parallel picture fills the perspective one of the same angle at that distance.
  for (const double angle : { 0.3, 1.0, 2.0 })
  {
    view.IsParallel = true;
    view.Angle = angle;
    const double distance = LevelDistance(view, place);
    view.IsParallel = false;
    const Vector3 middle = view.Point + distance * view.Direction;
    EXPECT_NEAR(
      PictureOf(view).PixelsBetween(middle - 25.0 * view.Up, middle + 25.0 * view.Up), view.Height, 1e-9 * view.Height);
  }
}

TEST(ViewFrustum, DetailFactorLengthensDistancesOfLevels)
{
  View view;
  view.Point = { 3.0, -10.0, 2.0 };
  View coarse = view;
  coarse.DetailFactor = 0.25;
  const Vector3 place{ 3.0, -7.0, 6.0 };
  EXPECT_DOUBLE_EQ(LevelDistance(coarse, place), 20.0);
  EXPECT_DOUBLE_EQ(SightDistance(coarse, place), 5.0);
  const Box box{ place, place + Vector3(0.0, 0.0, 2.0) };
  EXPECT_DOUBLE_EQ(ViewFrustum(coarse).PixelsOfRise(2.0, box), ViewFrustum(view).PixelsOfRise(2.0, box));
  EXPECT_FALSE(AreTheSame(coarse, view));
  for (const double bad : { 0.0, -0.5, 1.5, std::numeric_limits<double>::quiet_NaN() })
  {
    view.DetailFactor = bad;
    EXPECT_NE(WhyInvalid(view).find("DetailFactor"), std::string::npos) << bad;
  }
}

TEST(ViewFrustum, NearbyViewsRoundToTheSame)
{
  View view;
  view.Point = { 10.02, 20.01, 3.99 };
  view.Direction = { 0.3, 0.8, 0.1 };
  const View first = Rounded(view, 0.5, 0.02);
  view.Point = { 9.99, 19.98, 4.01 };
  view.Direction = { 0.3003, 0.8, 0.1 };
  const View second = Rounded(view, 0.5, 0.02);
  EXPECT_EQ(first.Point, second.Point);
  EXPECT_EQ(first.Direction, second.Direction);
  EXPECT_EQ(first.Up, second.Up);
  EXPECT_EQ(first.Point, Vector3(10.0, 20.0, 4.0));
  const View exact = Rounded(view, 0.0, 0.0);
  EXPECT_EQ(exact.Point, view.Point);
  EXPECT_EQ(exact.Margin, 0.0);
}

TEST(ViewFrustum, ABoxThatHoldsTheViewPointIsShown)
{
  std::mt19937 random(3);
  for (int n = 0; n < 100; ++n)
  {
    View view = RandomView(random);
    view.Near = 0.0;
    const Box around{ { view.Point[0] - 0.1, view.Point[1] - 0.1, view.Point[2] - 0.1 },
      { view.Point[0] + 0.1, view.Point[1] + 0.1, view.Point[2] + 0.1 } };
    EXPECT_TRUE(ViewFrustum(view).MayShow(around));
  }
}

TEST(ViewFrustum, DistanceOfABox)
{
  const Box box{ { 0.0, 0.0, 0.0 }, { 1.0, 2.0, 3.0 } };
  EXPECT_EQ(Distance(box, { 0.5, 0.5, 0.5 }), 0.0);
  EXPECT_EQ(Distance(box, { 4.0, 6.0, 1.0 }), 5.0);
  EXPECT_EQ(Distance(box, { 0.5, 1.0, -2.0 }), 2.0);
}

TEST(ViewFrustum, BadViewsAreNamed)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const auto reason = [](auto spoil) {
    View view;
    spoil(view);
    return WhyInvalid(view);
  };
  const auto names = [](const std::string& text, const char* word) { return text.find(word) != std::string::npos; };
  EXPECT_EQ(WhyInvalid(View()), "");
  EXPECT_TRUE(names(reason([&](View& v) { v.Point[1] = nan; }), "ViewPoint"));
  EXPECT_TRUE(names(reason([&](View& v) { v.Direction = { 0.0, 0.0, 0.0 }; }), "ViewDirection"));
  EXPECT_TRUE(names(reason([&](View& v) { v.Direction[0] = inf; }), "ViewDirection"));
  EXPECT_TRUE(names(reason([&](View& v) { v.Up = { 0.0, 0.0, 0.0 }; }), "ViewUp"));
  EXPECT_TRUE(names(reason([&](View& v) { v.Up = { 0.0, -3.0, 0.0 }; }), "ViewUp"));
  for (double bad : { 0.0, -1.0, Pi, nan })
  {
    EXPECT_TRUE(names(reason([=](View& v) { v.Angle = bad; }), "ViewAngle"));
  }
  for (double bad : { 0.0, -1.0, inf, nan })
  {
    EXPECT_TRUE(names(reason([=](View& v) { v.AspectRatio = bad; }), "AspectRatio"));
    EXPECT_TRUE(names(reason([=](View& v) { v.Height = bad; }), "ViewHeight"));
  }
  for (double bad : { 0.0, -1.0, inf, nan })
  {
    EXPECT_TRUE(names(reason([=](View& v) {
      v.IsParallel = true;
      v.ParallelScale = bad;
    }),
      "ParallelScale"));
    EXPECT_EQ(reason([=](View& v) { v.ParallelScale = bad; }), "");
  }
  EXPECT_TRUE(names(reason([](View& v) { v.Near = -1.0; }), "near"));
  EXPECT_TRUE(names(reason([](View& v) { v.Near = v.Far = 3.0; }), "far"));
}
