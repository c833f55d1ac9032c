// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/PhiloxLanes.h"
#include "Numerics/RandomStream.h"

#include <gtest/gtest.h>

#include <Random123/philox.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

using littoral::RandomPurpose;
using littoral::RandomStream;

// Known answer of Philox 4x32-10 for an all-zero key and counter, from the method's publication.
TEST(RandomStream, GeneratorGivesItsKnownAnswer)
{
  const r123::Philox4x32::ctr_type counter = { { 0, 0, 0, 0 } };
  const r123::Philox4x32::key_type key = { { 0, 0 } };
  const auto words = r123::Philox4x32()(counter, key);
  EXPECT_EQ(words[0], 0x6627e8d5u);
  EXPECT_EQ(words[1], 0xe169c58du);
  EXPECT_EQ(words[2], 0xbc57ac4cu);
  EXPECT_EQ(words[3], 0x9b00dbd8u);
}

// The mapping of seed, purpose, object and draw is part of every result: it may never change.
TEST(RandomStream, WordsArePinned)
{
  const RandomStream stream(7, RandomPurpose::ElevationLines);
  const r123::Philox4x32::ctr_type counter = { { 5, 1, 9, 0 } };
  const r123::Philox4x32::key_type key = { { 7, 1 } };
  const auto expected = r123::Philox4x32()(counter, key);
  const auto words = stream.Words((1ull << 32) + 5, 9);
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(words[i], expected[i]);
  }
}

// Runs of draws are those drawn one by one: of every length about the group's, and where the lower word overflows.
TEST(RandomStream, RunsOfDrawsAreTheDrawsOneByOne)
{
  const RandomStream stream(-5, RandomPurpose::ElevationLines);
  for (const std::uint64_t first : { 0ull, 7ull, 0xfffffffaull, 0xfffffffffffffffaull })
  {
    for (const std::size_t count : { 0, 1, 3, 4, 5, 16, 21 })
    {
      const std::uint64_t object = (3ull << 32) + 0x80000001u;
      std::vector<std::uint32_t> words(4 * count + 1, 77u);
      stream.FillWords(object, first, count, words.data());
      for (std::size_t n = 0; n < 4 * count; ++n)
      {
        ASSERT_EQ(words[n], stream.Words(object, first + n / 4)[n % 4]) << "first " << first << ", word " << n;
      }
      ASSERT_EQ(words[4 * count], 77u);
    }
  }
}

TEST(RandomStream, PurposesSeedsObjectsAndDrawsDiffer)
{
  const RandomStream a(1, RandomPurpose::ElevationLines);
  EXPECT_NE(a.Words(0, 0), RandomStream(1, RandomPurpose::ReflectanceLines).Words(0, 0));
  EXPECT_NE(a.Words(0, 0), RandomStream(2, RandomPurpose::ElevationLines).Words(0, 0));
  EXPECT_NE(a.Words(0, 0), a.Words(1, 0));
  EXPECT_NE(a.Words(0, 0), a.Words(0, 1));
}

TEST(RandomStream, UniformAndNormalMomentsAreRight)
{
  const RandomStream stream(3, RandomPurpose::ElevationLines);
  const int n = 200000;
  double uniform = 0.0;
  double square = 0.0;
  double normal = 0.0;
  double variance = 0.0;
  double fourth = 0.0;
  double crossed = 0.0;
  for (int i = 0; i < n; ++i)
  {
    const auto u = stream.UniformPair(i, 0);
    ASSERT_GT(u[0], 0.0);
    ASSERT_LT(u[0], 1.0);
    uniform += u[0] / n;
    square += u[0] * u[0] / n;
    const auto g = stream.NormalPair(i, 1);
    normal += (g[0] + g[1]) / (2 * n);
    variance += (g[0] * g[0] + g[1] * g[1]) / (2 * n);
    fourth += std::pow(g[0], 4) / n;
    crossed += g[0] * g[1] / n;
  }
  EXPECT_NEAR(uniform, 0.5, 0.003);
  EXPECT_NEAR(square - uniform * uniform, 1.0 / 12.0, 0.001);
  EXPECT_NEAR(normal, 0.0, 0.01);
  EXPECT_NEAR(variance, 1.0, 0.01);
  EXPECT_NEAR(fourth, 3.0, 0.1);
  EXPECT_NEAR(crossed, 0.0, 0.01);
}

namespace
{

/// Counters whose words all differ, and more of them than any vector holds.
struct Counters
{
  std::vector<std::uint64_t> Objects;
  std::vector<std::uint64_t> Draws;

  explicit Counters(std::size_t count)
  {
    for (std::uint64_t n = 0; n < count; ++n)
    {
      this->Objects.push_back(n * 0x9E3779B97F4A7C15u);
      this->Draws.push_back(~n * 0xBF58476D1CE4E5B9u);
    }
  }
};

}

TEST(RandomStream, ManyPairsAreThoseDrawnOneByOne)
{
  const RandomStream random(-5, RandomPurpose::QuadratPositions);
  for (std::size_t count = 0; count < 40; ++count)
  {
    const Counters counters(count);
    std::vector<double> first(count + 1, -1.0);
    std::vector<double> second(count + 1, -1.0);
    random.UniformPairs(count, counters.Objects.data(), counters.Draws.data(), first.data(), second.data());
    for (std::size_t n = 0; n < count; ++n)
    {
      const auto pair = random.UniformPair(counters.Objects[n], counters.Draws[n]);
      EXPECT_EQ(first[n], pair[0]) << n << " of " << count;
      EXPECT_EQ(second[n], pair[1]) << n << " of " << count;
    }
    EXPECT_EQ(first[count], -1.0);
    EXPECT_EQ(second[count], -1.0);
  }
}

TEST(RandomStream, VectorsOfAnyWidthGiveTheSameWords)
{
  const RandomStream random(77, RandomPurpose::QuadratCounts);
  const std::array<std::uint32_t, 2> key = { 77, static_cast<std::uint32_t>(RandomPurpose::QuadratCounts) };
  const std::size_t count = 4000;
  const Counters counters(count);
  for (const std::size_t lanes : littoral::PhiloxWidths())
  {
    if (lanes == 0)
    {
      continue;
    }
    std::vector<std::uint64_t> first(count);
    std::vector<std::uint64_t> second(count);
    const std::size_t done = littoral::PhiloxBitsOfWidth(
      lanes, key, count - 1, counters.Objects.data(), counters.Draws.data(), first.data(), second.data());
    EXPECT_EQ(done, (count - 1) / lanes * lanes);
    for (std::size_t n = 0; n < done; ++n)
    {
      const auto words = random.Words(counters.Objects[n], counters.Draws[n]);
      const std::uint64_t upper = 0x100000000;
      ASSERT_EQ(first[n], words[0] * upper + words[1]) << n << " of " << lanes << " lanes";
      ASSERT_EQ(second[n], words[2] * upper + words[3]) << n << " of " << lanes << " lanes";
    }
  }
}

TEST(RandomStream, UniformNumbersAreMiddlesOfCells)
{
  const RandomStream random(3, RandomPurpose::PlantScale);
  for (std::uint64_t object = 0; object < 1000; ++object)
  {
    for (const double u : random.UniformPair(object, 1))
    {
      EXPECT_EQ(std::fmod(u * 0x1p53, 2.0), 1.0); // half of a cell of 2^-52: neither 0 nor 1 can be drawn
    }
  }
}

// The binary digits of a number after the 32nd are as random as the first, and say nothing about them.
TEST(RandomStream, LateDigitsAreRandomToo)
{
  const RandomStream random(11, RandomPurpose::PlantScale);
  const int count = 20000;
  double mean = 0.0;
  double square = 0.0;
  double crossed = 0.0;
  for (int n = 0; n < count; ++n)
  {
    const double first = random.UniformPair(n, 0)[0];
    const double late = std::fmod(first * 0x1p32, 1.0);
    mean += late / count;
    square += late * late / count;
    crossed += (first - 0.5) * (late - 0.5) / count;
  }
  EXPECT_NEAR(mean, 0.5, 4.0 / std::sqrt(12.0 * count));
  EXPECT_NEAR(square, 1.0 / 3.0, 4.0 * std::sqrt(4.0 / 45.0 / count));
  EXPECT_NEAR(crossed, 0.0, 4.0 / (12.0 * std::sqrt(1.0 * count)));
}
