// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/InvalidInput.h"

#include <gtest/gtest.h>

#include <new>

using namespace littoral;

TEST(InvalidInput, IsOneSentence)
{
  EXPECT_EQ(WhyRefused([] { Refuse("Only ", 3, " of ", 2.5, " points."); }), "Only 3 of 2.5 points.");
  EXPECT_EQ(WhyRefused([] { Require("The input is empty."); }), "The input is empty.");
  EXPECT_EQ(WhyRefused([] { Require(""); }), "");
}

TEST(InvalidInput, HasWordsInFront)
{
  const auto refuse = [] { InContext("row 2: ", [] { Refuse("no number."); }); };
  EXPECT_EQ(WhyRefused([&] { InContext("Cannot read: ", refuse); }), "Cannot read: row 2: no number.");
  EXPECT_EQ(InContext("row 2: ", [] { return 7; }), 7);
}

// What is no fault of the input keeps its type.
TEST(InvalidInput, LetsOthersPass)
{
  const auto exhaust = [] { throw std::bad_alloc(); };
  EXPECT_THROW(InContext("row 2: ", exhaust), std::bad_alloc);
  EXPECT_THROW(WhyRefused(exhaust), std::bad_alloc);
}
