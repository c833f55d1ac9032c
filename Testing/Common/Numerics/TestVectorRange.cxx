// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The ranges of vectors whose extremes are put where one lane, one part or the rest must find them.
#include "Numerics/VectorRange.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

using namespace littoral;

TEST(VectorRange, FindsExtremesWhereverTheyAre)
{
  // All vectors are (1, 2, 2), of length 3, but one, which is (-4, 0, 3) or (4, 7, 4).
  for (std::size_t count = 2; count <= 37; ++count)
  {
    for (std::size_t odd = 0; odd < count; ++odd)
    {
      std::vector<float> vectors;
      for (std::size_t n = 0; n < count; ++n)
      {
        vectors.insert(vectors.end(), { 1.0f, 2.0f, 2.0f });
      }
      vectors[3 * odd] = -4.0f;
      vectors[3 * odd + 1] = 0.0f;
      vectors[3 * odd + 2] = 3.0f;
      const VectorRange low = RangeOf(vectors.data(), count);
      EXPECT_TRUE(low.IsFinite);
      EXPECT_EQ(low.Low, (std::array<float, 3>{ -4.0f, 0.0f, 2.0f }));
      EXPECT_EQ(low.High, (std::array<float, 3>{ 1.0f, 2.0f, 3.0f }));
      EXPECT_EQ(low.MinimumSquare, 9.0);
      EXPECT_EQ(low.MaximumSquare, 25.0);
      vectors[3 * odd] = 4.0f;
      vectors[3 * odd + 1] = 7.0f;
      vectors[3 * odd + 2] = 4.0f;
      const VectorRange high = RangeOf(vectors.data(), count);
      EXPECT_EQ(high.Low, (std::array<float, 3>{ 1.0f, 2.0f, 2.0f }));
      EXPECT_EQ(high.High, (std::array<float, 3>{ 4.0f, 7.0f, 4.0f }));
      EXPECT_EQ(high.MinimumSquare, 9.0);
      EXPECT_EQ(high.MaximumSquare, 81.0);
    }
  }
}

TEST(VectorRange, TellsOfEachComponentThatIsNotFinite)
{
  for (const float odd : { std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
         std::numeric_limits<float>::quiet_NaN() })
  {
    for (std::size_t place = 0; place < 105; ++place)
    {
      std::vector<float> vectors(105, 1.0f);
      EXPECT_TRUE(RangeOf(vectors.data(), 35).IsFinite);
      vectors[place] = odd;
      EXPECT_FALSE(RangeOf(vectors.data(), 35).IsFinite) << odd << " at " << place;
    }
  }
}

TEST(VectorRange, LengthsBeyondSinglePrecisionAreFinite)
{
  const std::vector<float> vectors(15, 3e38f); // the square is no float
  const VectorRange range = RangeOf(vectors.data(), 5);
  EXPECT_TRUE(range.IsFinite);
  EXPECT_NEAR(range.MaximumSquare / (3.0 * 9e76), 1.0, 1e-6);
}

TEST(VectorRange, OfBytesHasThreeExtremesAndLengths)
{
  // All are (10, 20, 20), of length 30, but one of length 27 and one of 255 sqrt 3.
  for (std::size_t count = 3; count <= 70; ++count)
  {
    std::vector<unsigned char> vectors;
    for (std::size_t n = 0; n < count; ++n)
    {
      vectors.insert(vectors.end(), { 10, 20, 20 });
    }
    const unsigned char shortest[3] = { 2, 14, 23 };
    std::copy_n(shortest, 3, vectors.data() + 3 * (count / 2));
    std::fill_n(vectors.data() + 3 * (count - 1), 3, static_cast<unsigned char>(255));
    const VectorRange range = RangeOfBytes(vectors.data(), count);
    EXPECT_EQ(range.Low, (std::array<float, 3>{ 2.0f, 14.0f, 20.0f }));
    EXPECT_EQ(range.High, (std::array<float, 3>{ 255.0f, 255.0f, 255.0f }));
    EXPECT_EQ(range.MinimumSquare, 729.0);
    EXPECT_EQ(range.MaximumSquare, 3.0 * 65025.0);
  }
}

TEST(VectorRange, NoVectorsHaveNone)
{
  const VectorRange range = RangeOf(nullptr, 0);
  EXPECT_TRUE(range.IsFinite);
  EXPECT_GT(range.Low[0], range.High[0]);
  EXPECT_GT(range.MinimumSquare, range.MaximumSquare);
}

TEST(VectorRange, FindsExtremesOfPairsWhereverTheyAre)
{
  // All pairs are (3, 4), of length 5, but one, which is (-1, 0) or (8, 15) or not finite.
  for (std::size_t count = 2; count <= 13; ++count)
  {
    for (std::size_t odd = 0; odd < count; ++odd)
    {
      std::vector<float> pairs;
      for (std::size_t n = 0; n < count; ++n)
      {
        pairs.insert(pairs.end(), { 3.0f, 4.0f });
      }
      pairs[2 * odd] = -1.0f;
      pairs[2 * odd + 1] = 0.0f;
      const VectorRange low = RangeOfPairs(pairs.data(), count);
      EXPECT_TRUE(low.IsFinite);
      EXPECT_EQ((std::array<float, 2>{ low.Low[0], low.Low[1] }), (std::array<float, 2>{ -1.0f, 0.0f }));
      EXPECT_EQ((std::array<float, 2>{ low.High[0], low.High[1] }), (std::array<float, 2>{ 3.0f, 4.0f }));
      EXPECT_EQ(low.MinimumSquare, 1.0);
      EXPECT_EQ(low.MaximumSquare, 25.0);
      pairs[2 * odd] = 8.0f;
      pairs[2 * odd + 1] = 15.0f;
      const VectorRange high = RangeOfPairs(pairs.data(), count);
      EXPECT_EQ((std::array<float, 2>{ high.Low[0], high.Low[1] }), (std::array<float, 2>{ 3.0f, 4.0f }));
      EXPECT_EQ((std::array<float, 2>{ high.High[0], high.High[1] }), (std::array<float, 2>{ 8.0f, 15.0f }));
      EXPECT_EQ(high.MinimumSquare, 25.0);
      EXPECT_EQ(high.MaximumSquare, 289.0);
      for (std::size_t part = 0; part < 2; ++part)
      {
        pairs[2 * odd + part] = std::numeric_limits<float>::quiet_NaN();
        EXPECT_FALSE(RangeOfPairs(pairs.data(), count).IsFinite) << odd << " of " << count;
        pairs[2 * odd + part] = 1.0f;
      }
    }
  }
}
