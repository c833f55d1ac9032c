// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Drag, lift and weight by hand, out of the plane, and for both laws.
#include "Wind/WindLoads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace littoral;

TEST(WindLoads, FollowBothLaws)
{
  WindLoadParameters air;
  const Vector3 up(0.0, 0.0, 1.0);
  const Vector3 wind(6.0, 0.0, 8.0);
  // 1/2 1.2 1.1 0.1 = 0.066, with |U| = 10 and |U_perp| = 6.
  EXPECT_NEAR(DragPerLength(air, up, 0.1, wind).x, 0.066 * 10.0 * 6.0, 1e-12);
  air.Law = DragLaw::CrossFlow;
  EXPECT_NEAR(DragPerLength(air, up, 0.1, wind).x, 0.066 * 6.0 * 6.0, 1e-12);
  EXPECT_EQ(DragPerLength(air, up, 0.1, wind).z, 0.0);
  air.LiftCoefficient = 1.1;
  const Vector3 lift = LiftPerLength(air, up, 0.1, wind);
  EXPECT_NEAR(lift.y, -0.066 * 36.0, 1e-12);
  EXPECT_NEAR(glm::dot(lift, wind), 0.0, 1e-12);
  EXPECT_EQ(glm::length(LiftPerLength(air, up, 0.1, up)), 0.0);
  EXPECT_EQ(glm::length(DragPerLength(air, up, 0.1, Vector3(0.0))), 0.0);
  EXPECT_NEAR(WeightPerLength(2.0).z, -19.6133, 1e-12);
}

TEST(WindLoads, LiftIsAcrossWindAndAxis)
{
  WindLoadParameters air;
  air.LiftCoefficient = 0.8;
  // Eq. 16 with U across the axis: 1/2 1.2 0.8 0.25 100 = 12 N/m. To the right of the wind on an upright cylinder, up
  // on one that points to the left.
  EXPECT_NEAR(glm::distance(LiftPerLength(air, { 0, 0, 1 }, 0.25, { 10, 0, 0 }), Vector3(0, -12, 0)), 0.0, 1e-12);
  EXPECT_NEAR(glm::distance(LiftPerLength(air, { 0, 1, 0 }, 0.25, { 10, 0, 0 }), Vector3(0, 0, 12)), 0.0, 1e-12);
  EXPECT_NEAR(glm::distance(LiftPerLength(air, { 0, 0, 1 }, 0.25, { 0, -10, 0 }), Vector3(-12, 0, 0)), 0.0, 1e-12);
  // At 30 degrees to the axis half of the wind is across.
  const Vector3 axis(std::sqrt(0.75), 0.0, 0.5);
  for (const DragLaw law : { DragLaw::Projection, DragLaw::CrossFlow })
  {
    air.Law = law;
    const Vector3 lift = LiftPerLength(air, axis, 0.25, { 10, 0, 0 });
    EXPECT_NEAR(lift.y, law == DragLaw::Projection ? -6.0 : -3.0, 1e-12);
    EXPECT_NEAR(std::abs(lift.x) + std::abs(lift.z), 0.0, 1e-12);
    EXPECT_NEAR(glm::dot(lift, DragPerLength(air, axis, 0.25, { 10, 0, 0 })), 0.0, 1e-12);
  }
}

TEST(WindLoads, ProjectionAddsUp)
{
  // Drag on the three axes, summed and projected once more, halved, is the drag on any beam.
  const WindLoadParameters air;
  const Vector3 wind(3.0, -4.0, 1.5);
  const Vector3 axis = glm::normalize(Vector3(1.0, 2.0, -0.5));
  Vector3 sum(0.0);
  for (int n = 0; n < 3; ++n)
  {
    Vector3 unit(0.0);
    unit[n] = 1.0;
    sum += 0.5 * DragPerLength(air, unit, 0.2, wind);
  }
  const Vector3 projected = sum - glm::dot(sum, axis) * axis;
  EXPECT_NEAR(glm::distance(projected, DragPerLength(air, axis, 0.2, wind)), 0.0, 1e-12);
}

TEST(WindLoads, SayWhatIsWrong)
{
  WindLoadParameters air;
  EXPECT_EQ(WhyInvalid(air), "");
  air.AirDensity = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(WhyInvalid(air).find("AirDensity"), std::string::npos);
  air = {};
  air.DragCoefficient = -1.0;
  EXPECT_NE(WhyInvalid(air).find("DragCoefficient"), std::string::npos);
}
