// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The transform of a real grid against that of kissfft's complex one, on sides that are odd, even, padded or not.
#include "../OnThreads.h"
#include "Numerics/FourierGrid.h"
#include "Numerics/RealGridFourier.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <vector>

using namespace littoral;
using littoral::testing::OnThreads;

namespace
{

std::vector<double> Values(std::array<int, 2> size)
{
  std::vector<double> values;
  for (int n = 0; n < size[0] * size[1]; ++n)
  {
    values.push_back(std::sin(1.0 + 0.37 * n * n) + 0.2);
  }
  return values;
}

}

TEST(RealGridFourier, AgreesWithTheComplexGrid)
{
  using Sides = std::array<int, 2>;
  const std::vector<std::array<Sides, 2>> cases = {
    { Sides{ 1, 1 }, Sides{ 1, 1 } },
    { Sides{ 7, 5 }, Sides{ 15, 9 } },
    { Sides{ 16, 8 }, Sides{ 16, 8 } },
    { Sides{ 17, 30 }, Sides{ 18, 60 } },
    { Sides{ 40, 33 }, Sides{ 45, 50 } },
  };
  for (const auto& [size, padded] : cases)
  {
    const std::vector<double> values = Values(size);
    FourierGrid reference(padded[0], padded[1]);
    for (int n = 0; n < size[0] * size[1]; ++n)
    {
      reference.At(n % size[0], n / size[0]) = values[n];
    }
    reference.Backward(); // exponent +i
    const RealGridFourier grid(values, size, padded, OnThreads(3));
    ASSERT_EQ(grid.NumberOfRows(), padded[1] / 2 + 1);
    DoubleLinePack rows(padded[0]);
    for (int pack = 0; pack < grid.NumberOfPacks(); ++pack)
    {
      grid.TransformRows(pack, rows);
      for (int n = 0; n < padded[0] * FourierLanes; ++n)
      {
        const int row = pack * FourierLanes + n % FourierLanes;
        const std::complex<double> wants =
          row < grid.NumberOfRows() ? reference.At(n / FourierLanes, row) : std::complex<double>(0.0);
        ASSERT_LT(std::abs(std::complex<double>(rows.Re[n], rows.Im[n]) - wants), 1e-11)
          << size[0] << " x " << size[1] << " at " << n / FourierLanes << ", " << row;
      }
    }
  }
}

TEST(RealGridFourier, DoesNotDependOnThreads)
{
  const std::vector<double> values = Values({ 50, 21 });
  const RealGridFourier one(values, { 50, 21 }, { 60, 24 });
  const RealGridFourier three(values, { 50, 21 }, { 60, 24 }, OnThreads(3));
  DoubleLinePack a(60);
  DoubleLinePack b(60);
  for (int pack = 0; pack < one.NumberOfPacks(); ++pack)
  {
    one.TransformRows(pack, a);
    three.TransformRows(pack, b);
    EXPECT_EQ(a.Re, b.Re);
    EXPECT_EQ(a.Im, b.Im);
  }
}
