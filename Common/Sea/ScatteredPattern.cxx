// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sea/ScatteredPattern.h"

#include "Numerics/Constants.h"
#include "Numerics/FourierGrid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace littoral
{

//----------------------------------------------------------------------------
double ContrastAfter(double waveNumber, const ScatteringWay& way)
{
  // The phase function in small angles, 1 / ((1 - g)^2 + g t^2)^(3/2), has the transform exp(-k t_0), t_0 = (1 - g) /
  // sqrt(g)
  const double blur = waveNumber * way.Length * (1.0 - way.Forward) / std::sqrt(way.Forward);
  // exp(-b r (1 - int_0^1 exp(-k r t_0 s) ds)): light that is scattered at r (1 - s) lands beside by the angle times r
  // s
  const double kept = blur < 1e-6 ? 1.0 : -std::expm1(-blur) / blur;
  return std::exp(-way.Scattering * way.Length * (1.0 - kept));
}

//----------------------------------------------------------------------------
std::vector<double> ScatteredPattern(
  const std::vector<double>& light, int places, double side, const ScatteringWay& way)
{
  FourierGrid grid(places, places);
  std::copy(light.begin(), light.end(), &grid.At(0, 0));
  grid.Forward();
  const double scale = 1.0 / static_cast<double>(light.size());
  for (int row = 0; row < places; ++row)
  {
    for (int column = 0; column < places; ++column)
    {
      const double waves = std::hypot(std::min(row, places - row), std::min(column, places - column));
      grid.At(column, row) *= scale * ContrastAfter(TwoPi * waves / side, way);
    }
  }
  grid.Backward();
  std::vector<double> scattered(light.size());
  std::transform(&grid.At(0, 0), &grid.At(0, 0) + light.size(), scattered.begin(),
    [](const std::complex<double>& value) { return value.real(); });
  return scattered;
}

}
