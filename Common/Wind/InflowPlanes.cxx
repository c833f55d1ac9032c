// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Wind/InflowPlanes.h"

#include "Numerics/InvalidInput.h"
#include "Numerics/ParameterCheck.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace littoral
{

std::string WhyInvalid(const InflowGrid& grid)
{
  ParameterCheck check;
  constexpr int most = 1 << 24; // bytes of a plane are then a number of 64 bits
  check.PositiveCount("Number of times", grid.Count[0]);
  check.Count("Number of points across", grid.Count[1], 1, most);
  check.Count("Number of points up", grid.Count[2], 1, most);
  check.Count("Number of points of the tower", grid.TowerPoints, 0, most);
  check.Positive("Time step", grid.TimeStep, "s");
  check.Positive("Lateral spacing", grid.LateralSpacing, "m");
  check.Positive("Vertical spacing", grid.VerticalSpacing, "m");
  check.Positive("Mean wind speed", grid.Speed, "m/s");
  check.Finite("Hub height", grid.HubHeight, "m");
  check.Finite("Height of the lowest points", grid.BottomHeight, "m");
  return check.Reason();
}

void InflowRange::Add(const float* velocities, std::size_t points)
{
  if (this->Points == 0 && points > 0)
  {
    std::copy_n(velocities, 3, this->First.begin());
    this->Low = this->First;
    this->High = this->First;
  }
  this->Points += points;
  for (std::size_t n = 0; n < 3 * points; ++n)
  {
    const float value = velocities[n];
    const double part = static_cast<double>(value) - this->First[n % 3];
    if (!std::isfinite(value))
    {
      Refuse("a velocity is ", value, " m/s; all must be finite");
    }
    this->Low[n % 3] = std::min(this->Low[n % 3], value);
    this->High[n % 3] = std::max(this->High[n % 3], value);
    this->Sum[n % 3] += part;
    this->Square[n % 3] += part * part;
  }
}

double InflowRange::DeviationFrom(double number, int component) const
{
  // mean of (v - c)² = mean of d² + 2 (v1 - c) mean of d + (v1 - c)², d = v - v1
  const double shift = this->First[component] - number;
  const double count = std::max<double>(1.0, static_cast<double>(this->Points));
  return std::sqrt(
    std::max(0.0, this->Square[component] / count + 2.0 * shift * this->Sum[component] / count + shift * shift));
}

std::string WhyOtherSize(const InflowPlanes& planes, double size)
{
  const double wanted = static_cast<double>(planes.BytesOfHeader()) +
    static_cast<double>(planes.BytesOfPlane()) * planes.GetGrid().Count[0];
  std::ostringstream words;
  words.precision(16);
  if (size < wanted)
  {
    words << "it is cut off: of " << wanted << " bytes it has " << size;
  }
  else if (size > wanted)
  {
    words << "it goes on after its last plane: of " << size << " bytes it needs " << wanted;
  }
  return words.str();
}

}
