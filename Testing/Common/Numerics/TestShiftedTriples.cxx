// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Places moved by one way, against sums number by number.
#include "Numerics/ShiftedTriples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace littoral;

namespace
{

template <typename Real>
void Compare(std::size_t count)
{
  const Vector3 way(0.3, -1e5, 1e-9);
  std::vector<Real> from(3 * count);
  for (std::size_t n = 0; n < from.size(); ++n)
  {
    from[n] = static_cast<Real>(1e3 * std::sin(0.7 * static_cast<double>(n)));
  }
  std::vector<Real> to(3 * count + 1, Real(7.0));
  ShiftTriples(from.data(), count, way, to.data());
  for (std::size_t n = 0; n < from.size(); ++n)
  {
    EXPECT_EQ(to[n], static_cast<Real>(static_cast<double>(from[n]) + way[static_cast<int>(n % 3)])) << n;
  }
  EXPECT_EQ(to.back(), Real(7.0)) << "written beyond the end";
}

}

TEST(ShiftedTriples, AreSumsOfDoublePrecision)
{
  for (const std::size_t count : { 0, 1, 7, 15, 16, 17, 24, 31, 1000 })
  {
    Compare<float>(count);
    Compare<double>(count);
  }
}
