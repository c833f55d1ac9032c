// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// A wind that goes on: whole and parts of samples, back in time, turned, in parts, on threads.
#include "../OnThreads.h"
#include "WindSeries.h"

#include "Wind/CarriedWind.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

using namespace littoral;
using littoral::testing::OnThreads;

namespace
{

const double TwoPi = 2.0 * std::acos(-1.0);
constexpr int Samples = 60;
constexpr int Columns = 17; // more than go side by side, and no multiple of them
constexpr int Layers = 2;
constexpr WindWindow Whole{ { 0, 0, 0 }, { Samples - 1, Columns - 1, Layers - 1 } };

/// Two waves along each line, three periods ahead of a line's number; at the time t they are those of sample i - t.
double WaveAt(double sample, int line, int component)
{
  const double turn = TwoPi * sample / Samples;
  return component == 0 ? 7.0 + std::cos(3.0 * turn + line)
    : component == 1    ? std::sin(2.0 * turn - line)
                        : 0.25 * line;
}

std::vector<float> Carry(double time, const WindWindow& window, const std::array<double, 2>& turn = { 1.0, 0.0 },
  const ParallelFor& parallel = SerialFor)
{
  const WindGrid grid = GridOf(Samples, Columns, Layers);
  std::vector<float> velocities;
  for (int line = 0; line < Columns * Layers; ++line)
  {
    for (int sample = 0; sample < Samples; ++sample)
    {
      for (int component = 0; component < 3; ++component)
      {
        velocities.push_back(static_cast<float>(WaveAt(sample, line, component)));
      }
    }
  }
  std::vector<float> carried(3);
  for (int axis = 0; axis < 3; ++axis)
  {
    carried.resize(carried.size() * static_cast<std::size_t>(window.Last[axis] - window.First[axis] + 1));
  }
  CarryWind(grid, velocities.data(), time, turn, window, carried.data(), parallel);
  return carried;
}

/// Off what the waves are so many samples later.
double LargestError(const std::vector<float>& carried, double samples)
{
  double most = 0.0;
  for (std::size_t n = 0; n < carried.size(); ++n)
  {
    const auto sample = static_cast<int>(n / 3 % Samples);
    const auto line = static_cast<int>(n / 3 / Samples);
    most = std::max(most, std::abs(carried[n] - WaveAt(sample - samples, line, static_cast<int>(n % 3))));
  }
  return most;
}

}

TEST(CarriedWind, GoesOnByASampleAStep)
{
  const double step = GridOf(Samples, Columns, Layers).TimeStep;
  for (const double samples : { 0.0, 1.0, 17.0, -3.0, 60.0, 1234.0, 0.5, -7.25 })
  {
    EXPECT_LT(LargestError(Carry(samples * step, Whole), samples), 2e-5) << samples << " samples";
  }
}

TEST(CarriedWind, RoundsTimes)
{
  const double step = GridOf(Samples, Columns, Layers).TimeStep;
  EXPECT_EQ(Carry(2.0 * step, Whole), Carry((2.0 + 0.4 / 1024.0) * step, Whole));
  EXPECT_NE(Carry(2.0 * step, Whole), Carry((2.0 + 0.6 / 1024.0) * step, Whole));
}

// A quarter turn: along becomes y, across becomes -x.
TEST(CarriedWind, IsTurned)
{
  const std::vector<float> straight = Carry(0.3, Whole);
  const std::vector<float> turned = Carry(0.3, Whole, { 0.0, 1.0 });
  for (std::size_t n = 0; n < straight.size(); n += 3)
  {
    ASSERT_EQ(turned[n], -straight[n + 1]);
    ASSERT_EQ(turned[n + 1], straight[n]);
    ASSERT_EQ(turned[n + 2], straight[n + 2]);
  }
}

TEST(CarriedWind, WindowsAndThreadsMakeNoDifference)
{
  const std::vector<float> whole = Carry(0.33, Whole);
  EXPECT_EQ(whole, Carry(0.33, Whole, { 1.0, 0.0 }, OnThreads(3)));
  const WindWindow part{ { 5, 3, 1 }, { 9, 16, 1 } };
  const std::vector<float> own = Carry(0.33, part);
  std::size_t n = 0;
  for (int j = 3; j <= 16; ++j)
  {
    for (int value = 3 * 5; value < 3 * 10; ++value, ++n)
    {
      ASSERT_EQ(own[n], whole[static_cast<std::size_t>((Columns + j) * Samples) * 3 + static_cast<std::size_t>(value)]);
    }
  }
}
