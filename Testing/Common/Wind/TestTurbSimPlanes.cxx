// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Integers of .bts files: errors within range/65535 for any range, headers to the byte, sizes.
#include "Numerics/InvalidInput.h"
#include "Wind/TurbSimPlanes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace littoral;

namespace
{

InflowGrid SmallGrid()
{
  InflowGrid grid;
  grid.Count = { 4, 3, 2 };
  grid.TowerPoints = 1;
  grid.IsPeriodic = true;
  grid.Description = "ab";
  return grid;
}

}

TEST(Quantiser, ErrorsAreWithinAStepOfAnyRange)
{
  const std::pair<double, double> ranges[] = { { -3.0, 5.0 }, { 0.0, 1e-3 }, { 9.0, 11.0 }, { 99.0, 101.0 },
    { -40.0, -39.0 }, { 0.0, 0.0 }, { 7.5, 7.5 }, { 10.0, 10.0001 }, { -1e10, 2e10 }, { -1e-20, 1e-20 } };
  for (const auto& [low, high] : ranges)
  {
    const Quantiser quantiser = Quantiser::Of(low, high);
    for (int n = 0; n <= 1000; ++n)
    {
      const auto value = static_cast<float>(low + (high - low) * n / 1000.0);
      const double error = std::abs(static_cast<double>(quantiser.Value(quantiser.Stored(value))) - value);
      const double step = (high - low) / 65535.0;
      // to the nearest of integers, and what a float tells of the number
      EXPECT_LE(error, 0.501 * step + 1.3e-7 * std::abs(value)) << low << " " << high << " " << value;
    }
  }
}

TEST(Quantiser, TakesAllIntegersAndNoOther)
{
  for (const double middle : { 0.0, 13.0, -60.0 })
  {
    const Quantiser quantiser = Quantiser::Of(middle - 1.0, middle + 1.0);
    EXPECT_NEAR(quantiser.Stored(static_cast<float>(middle - 1.0)), -32768, 1);
    EXPECT_NEAR(quantiser.Stored(static_cast<float>(middle + 1.0)), 32767, 1);
  }
}

TEST(TurbSimPlanes, HeaderIsReadAsWritten)
{
  InflowRange range;
  range.Low = { 5.0f, -1.0f, 0.0f };
  range.High = { 9.0f, 1.0f, 0.0f };
  const TurbSimPlanes written(SmallGrid(), range);
  const std::string header = written.Header();
  ASSERT_EQ(header.size(), 72u);
  // int16 8, int32 2 points up, 3 across, 1 of the tower, 4 times
  const unsigned char first[] = { 8, 0, 2, 0, 0, 0, 3, 0, 0, 0, 1, 0, 0, 0, 4, 0, 0, 0, 0, 0, 0, 0x40 };
  for (std::size_t n = 0; n < sizeof first; ++n)
  {
    EXPECT_EQ(static_cast<unsigned char>(header[n]), first[n]) << n; // the last four: 2 m up as a float
  }
  const TurbSimPlanes read(header, 72.0 + 4.0 * 7.0 * 6.0);
  EXPECT_EQ(read.Header(), header);
  EXPECT_EQ(WhyRefused([&] { TurbSimPlanes(header, 239.0); }), "it is cut off: of 240 bytes it has 239");
  EXPECT_EQ(
    WhyRefused([&] { TurbSimPlanes(header, 241.0); }), "it goes on after its last plane: of 241 bytes it needs 240");
}

TEST(TurbSimPlanes, PlanesAreReadAsWritten)
{
  std::vector<float> plane;
  for (int n = 0; n < 21; ++n)
  {
    plane.push_back(static_cast<float>(std::sin(1.0 + n)));
  }
  InflowRange range;
  range.Add(plane.data(), 7);
  const TurbSimPlanes planes(SmallGrid(), range);
  std::string bytes(planes.BytesOfPlane(), '\0');
  ASSERT_EQ(bytes.size(), 42u);
  char* to = bytes.data();
  planes.Encode(plane.data(), &to);
  std::vector<float> again(plane.size());
  const char* from = bytes.data();
  planes.Decode(&from, again.data());
  for (std::size_t n = 0; n < plane.size(); ++n)
  {
    EXPECT_NEAR(again[n], plane[n], 2.0 / 65535.0);
  }
}

TEST(InflowRange, IsThatOfEachComponent)
{
  const float some[] = { 3.0f, -2.0f, 5.0f, 4.0f, -3.0f, 5.5f };
  InflowRange range;
  range.Add(some, 2);
  EXPECT_EQ(range.Low, (std::array<float, 3>{ 3.0f, -3.0f, 5.0f }));
  EXPECT_EQ(range.High, (std::array<float, 3>{ 4.0f, -2.0f, 5.5f }));
  const float broken[] = { 1.0f, std::numeric_limits<float>::quiet_NaN(), 0.0f };
  EXPECT_NE(WhyRefused([&] { range.Add(broken, 1); }), "");
}
