// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/TapSums.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

using namespace littoral;

namespace
{

/// Any numbers of mixed sizes and signs, whose sums round.
float AnyNumber(std::size_t n)
{
  return static_cast<float>(static_cast<int>((n * 2654435761u >> 7) % 200003u) - 100001) /
    static_cast<float>(1 + n % 17);
}

struct Taps
{
  const float* Of[LinesAtOnce][4];
  TapWeights Weights;
};

/// The sums as the header has them, point by point.
void AddPlainly(const Taps& taps, int count, float* sums)
{
  for (int i = 0; i < count; ++i)
  {
    std::array<float, LinesAtOnce> line;
    for (int n = 0; n < LinesAtOnce; ++n)
    {
      std::array<float, 4> part;
      for (int k = 0; k < 4; ++k)
      {
        part[k] = taps.Weights[k][n] * taps.Of[n][k][i];
      }
      line[n] = (part[0] + part[1]) + (part[2] + part[3]);
    }
    sums[i] += (line[0] + line[1]) + (line[2] + line[3]);
  }
}

class TapSums : public testing::TestWithParam<int>
{
protected:
  const int Count = GetParam();
  std::vector<std::vector<float>> Tables;
  Taps Lines;
  std::vector<float> Sums = std::vector<float>(MaximumPointsAtOnce + 32);

  /// Lines whose taps are so far apart, each from a place of its own.
  void MakeLines(int apart)
  {
    for (int n = 0; n < LinesAtOnce; ++n)
    {
      this->Tables.emplace_back(5 * n + 3 * apart + this->Count + Overrun);
      for (std::size_t i = 0; i < this->Tables[n].size(); ++i)
      {
        this->Tables[n][i] = AnyNumber(1000 * n + i);
      }
      for (int k = 0; k < 4; ++k)
      {
        this->Lines.Of[n][k] = this->Tables[n].data() + 5 * n + k * apart;
        this->Lines.Weights[k][n] = AnyNumber(77 + 4 * n + k) * 1e-5f;
      }
    }
    for (std::size_t i = 0; i < this->Sums.size(); ++i)
    {
      this->Sums[i] = AnyNumber(i + 5);
    }
  }
};

}

// The bytes are those of the plain sums, for rows of every kind of length.
TEST_P(TapSums, TapsAnywhereAreThePlainSums)
{
  this->MakeLines(7);
  std::vector<float> plain = this->Sums;
  AddPlainly(this->Lines, this->Count, plain.data());
  AddTaps(this->Lines.Of, this->Lines.Weights, this->Count, this->Sums.data());
  EXPECT_EQ(this->Sums, plain);
}

TEST_P(TapSums, NeighborsAreThePlainSums)
{
  this->MakeLines(1);
  std::vector<float> plain = this->Sums;
  AddPlainly(this->Lines, this->Count, plain.data());
  const float* tables[LinesAtOnce];
  for (int n = 0; n < LinesAtOnce; ++n)
  {
    tables[n] = this->Lines.Of[n][0];
  }
  AddNeighborTaps(tables, this->Lines.Weights, this->Count, this->Sums.data());
  for (std::size_t i = 0; i < this->Sums.size(); ++i)
  {
    const bool mayChange = i >= static_cast<std::size_t>(this->Count) && i < (this->Count + 15u) / 16u * 16u;
    EXPECT_TRUE(mayChange || this->Sums[i] == plain[i]) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Counts, TapSums, testing::Values(1, 2, 7, 8, 15, 16, 17, 33, 100, 255, 256));
