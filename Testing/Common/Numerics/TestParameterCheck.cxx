// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/ParameterCheck.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace littoral;

namespace
{

template <typename Check>
std::string Reason(const Check& run)
{
  ParameterCheck check;
  run(check);
  EXPECT_EQ(check.IsGood(), check.Reason().empty());
  return check.Reason();
}

}

TEST(ParameterCheck, HasOneWording)
{
  EXPECT_EQ(Reason([](auto& c) { c.Choice("Method", 3, 2); }), "Method is 3; it must be 0 or 1.");
  EXPECT_EQ(Reason([](auto& c) { c.Choice("Law", -1, 6); }), "Law is -1; it must be from 0 to 5.");
  EXPECT_EQ(Reason([](auto& c) { c.Range("TimeStep", 2.0, 1e-5, 1.0, "s"); }),
    "TimeStep is 2 s; it must be from 1e-05 to 1 s.");
  EXPECT_EQ(Reason([](auto& c) { c.Count("Lags", 5, 6, 10000); }), "Lags is 5; it must be from 6 to 10000.");
  EXPECT_EQ(Reason([](auto& c) { c.Positive("Depth", 0.0, "m"); }), "Depth is 0 m; it must be positive and finite.");
  EXPECT_EQ(Reason([](auto& c) { c.Positive("Speed", 300.0, "m/s", 200.0); }),
    "Speed is 300 m/s; it must be positive and at most 200 m/s.");
  EXPECT_EQ(
    Reason([](auto& c) { c.NotNegative("Error", -0.5); }), "Error is -0.5; it must be finite and not negative.");
  EXPECT_EQ(Reason([](auto& c) { c.NotNegative("Part", 2.0, "", 1.0); }), "Part is 2; it must be from 0 to 1.");
  EXPECT_EQ(Reason([](auto& c) { c.Finite("SeaLevel", std::nan("")); }), "SeaLevel is nan; it must be finite.");
}

TEST(ParameterCheck, RefusesMagnitudesThatOverflowOrVanish)
{
  EXPECT_EQ(Reason([](auto& c) { c.Finite("Slope", -1e300); }),
    "Slope is -1e+300; it must be of a magnitude from 1e-30 to 1e+15.");
  EXPECT_EQ(Reason([](auto& c) { c.Positive("Depth", 5e-324, "m"); }),
    "Depth is 4.94066e-324 m; it must be of a magnitude from 1e-30 to 1e+15 m.");
  EXPECT_EQ(Reason([](auto& c) { c.Range("Share", 1e-300, 0.0, 1.0); }),
    "Share is 1e-300; it must be of a magnitude from 1e-30 to 1e+15.");
  for (const double good : { 0.0, -0.0, 1e-30, -1e-30, 6e-17, 1e15, -1e15 })
  {
    EXPECT_TRUE(IsSensible(good)) << good;
    EXPECT_EQ(Reason([&](auto& c) { c.Finite("Center", good); }), "");
  }
  for (const double bad : { 0.9e-30, 1.1e15, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    EXPECT_FALSE(IsSensible(bad)) << bad;
    EXPECT_FALSE(IsSensible(-bad)) << bad;
  }
}

TEST(ParameterCheck, NamesChoicesCountsAndColors)
{
  EXPECT_EQ(Reason([](auto& c) {
    c.Choice("Law", 2, { "linear", "cubic" });
  }),
    "Law is 2; it must be 0 (linear) or 1 (cubic).");
  EXPECT_EQ(Reason([](auto& c) {
    c.Choice("Trains", -1, { "some", "most", "all" });
  }),
    "Trains is -1; it must be 0 (some), 1 (most) or 2 (all).");
  EXPECT_EQ(Reason([](auto& c) { c.PositiveCount("Lines", 0); }), "Lines is 0; it must be positive.");
  const double color[] = { 0.5, 1.0, 1.5 };
  EXPECT_EQ(Reason([&](auto& c) { c.Color("LeafColor", color); }),
    "LeafColor is 0.5, 1, 1.5; it must be from 0 to 1 in each part.");
  EXPECT_EQ(Reason([](auto& c) { c.Require(false, "Depth", -2.0, "m", "positive, or 0 for none"); }),
    "Depth is -2 m; it must be positive, or 0 for none.");
  EXPECT_EQ(Reason([&](auto& c) {
    const double black[] = { 0.0, 0.0, 0.0 };
    c.Choice("Law", 1, { "linear", "cubic" });
    c.PositiveCount("Lines", 1);
    c.Color("LeafColor", black);
  }),
    "");
}

TEST(ParameterCheck, IntervalsInWords)
{
  EXPECT_EQ(ValueInterval().Words("m"), "finite");
  EXPECT_EQ(ValueInterval::Positive().Words("m"), "positive and finite");
  EXPECT_EQ(ValueInterval::NotNegative().Words("m"), "finite and not negative");
  EXPECT_EQ(ValueInterval::AtLeast(1.0).Words("m"), "finite and at least 1 m");
  EXPECT_EQ(ValueInterval::Above(0.0, 2.0).Words("m"), "positive and at most 2 m");
  EXPECT_EQ(ValueInterval::Above(0.5, 2.0).Words(), "above 0.5 and at most 2");
  EXPECT_EQ(ValueInterval::From(-1.0, 2.0).Words("m"), "from -1 to 2 m");
  EXPECT_EQ(ValueInterval::Between(2.0, 3.0).Words(), "above 2 and below 3");
  EXPECT_FALSE(ValueInterval::Between(2.0, 3.0).Contains(3.0));
  EXPECT_FALSE(ValueInterval::Above(2.0, 3.0).Contains(2.0));
  EXPECT_TRUE(ValueInterval::From(2.0, 3.0).Contains(2.0) && ValueInterval::From(2.0, 3.0).Contains(3.0));
}

TEST(ParameterCheck, EndsAreWithin)
{
  EXPECT_EQ(Reason([](auto& c) {
    c.Range("a", 0.0, 0.0, 1.0);
    c.Range("a", 1.0, 0.0, 1.0);
    c.Positive("a", 1e-30);
    c.Positive("a", 2.0, "", 2.0);
    c.NotNegative("a", 0.0);
    c.Choice("a", 0, 2);
    c.Choice("a", 1, 2);
    c.Count("a", 6, 6, 7);
    c.Count("a", 7, 6, 7);
  }),
    "");
}

TEST(ParameterCheck, WhatIsNotFiniteIsBad)
{
  for (const double bad :
    { std::nan(""), std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() })
  {
    EXPECT_NE(Reason([=](auto& c) { c.Range("a", bad, -1e300, 1e300); }), "");
    EXPECT_NE(Reason([=](auto& c) { c.Positive("a", bad); }), "");
    EXPECT_NE(Reason([=](auto& c) { c.NotNegative("a", bad); }), "");
    EXPECT_NE(Reason([=](auto& c) { c.Finite("a", bad); }), "");
  }
}

TEST(ParameterCheck, TheFirstCounts)
{
  EXPECT_EQ(Reason([](auto& c) {
    c.Range("Good", 0.5, 0.0, 1.0);
    c.Require(false, "First must be something.");
    c.Range("Second", 2.0, 0.0, 1.0);
  }),
    "First must be something.");
}

TEST(ParameterCheck, ElementsAreNamedByTheirAxis)
{
  EXPECT_EQ(
    Reason([](auto& c) { c.Positive("Size[0]", 0.0, "m"); }), "Size, x is 0 m; it must be positive and finite.");
  EXPECT_EQ(Reason([](auto& c) { c.Count("Dimensions[1]", 1, 2, 9); }), "Dimensions, y is 1; it must be from 2 to 9.");
  EXPECT_EQ(Reason([](auto& c) { c.Positive("Spacing[2] of Input", 0.0); }),
    "Spacing, z of Input is 0; it must be positive and finite.");
}

TEST(ParameterCheck, NumbersReadAsTheyAre)
{
  EXPECT_EQ(TextOf(0.1), "0.1");
  EXPECT_EQ(TextOf(20.0), "20");
  EXPECT_EQ(TextOf(1.0 / 3.0), "0.3333333333333333");
  EXPECT_EQ(TextOf(1e9), "1e+09");
  EXPECT_EQ(TextOf(2147483647.0), "2147483647");
}
