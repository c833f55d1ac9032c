// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Kriging/NormalScores.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace littoral;

TEST(NormalScores, OfRanks)
{
  const NormalScores scores({ 5.0, -1.0, 100.0, 2.0 });
  // Ranks 1 to 4: a part (k - 1/2) / 4 of a normal distribution is below each, 1/2 erfc(-s / sqrt 2).
  const double values[] = { -1.0, 2.0, 5.0, 100.0 };
  for (int k = 0; k < 4; ++k)
  {
    const double score = scores.ScoreOf(values[k]);
    EXPECT_NEAR(0.5 * std::erfc(-score / std::sqrt(2.0)), (k + 0.5) / 4.0, 1e-14);
    EXPECT_EQ(scores.ValueOf(score), values[k]);
  }
  EXPECT_EQ(scores.ScoreOf(-50.0), scores.ScoreOf(-1.0));
  EXPECT_EQ(scores.ValueOf(9.0), 100.0);
  EXPECT_EQ(scores.ValueOf(-9.0), -1.0);
  EXPECT_NEAR(scores.ScoreOf(scores.ValueOf(0.1)), 0.1, 1e-14);
  // Linear between values: a fourth of the way from 2 to 5
  EXPECT_NEAR(scores.ScoreOf(2.75), 0.75 * scores.ScoreOf(2.0) + 0.25 * scores.ScoreOf(5.0), 1e-14);
}

TEST(NormalScores, OfEqualValues)
{
  const NormalScores scores({ 1.0, 1.0, 1.0, 8.0 });
  // Mean rank 2 of 4: quantile 1.5 / 4
  EXPECT_NEAR(0.5 * std::erfc(-scores.ScoreOf(1.0) / std::sqrt(2.0)), 1.5 / 4.0, 1e-14);
  EXPECT_EQ(scores.ValueOf(scores.ScoreOf(1.0)), 1.0);
  EXPECT_TRUE(NormalScores({ 3.0, 3.0 }).IsEmpty());
  EXPECT_TRUE(NormalScores({}).IsEmpty());
  EXPECT_FALSE(scores.IsEmpty());
}
