// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Currents/OceanLevels.h"

#include "Numerics/InvalidInput.h"

#include <cmath>
#include <cstddef>

namespace littoral
{

namespace
{

/// (1 - cosh(theta s))/(cosh(theta) - 1), -s^2 in the limit of theta 0
double ShchepetkinSurface(double theta, double s)
{
  return theta > 0.0 ? (1.0 - std::cosh(theta * s)) / (std::cosh(theta) - 1.0) : -s * s;
}

double SongHaidvogel(double surface, double bottom, double s)
{
  if (surface == 0.0)
  {
    return s;
  }
  // (1 - b) sinh(a s)/sinh(a) + b (tanh(a (s + 1/2))/(2 tanh(a/2)) - 1/2)
  return (1.0 - bottom) * std::sinh(surface * s) / std::sinh(surface) +
    bottom * (0.5 * std::tanh(surface * (s + 0.5)) / std::tanh(0.5 * surface) - 0.5);
}

double Shchepetkin2005(double surface, double bottom, double s)
{
  const double above = ShchepetkinSurface(surface, s);
  if (bottom <= 0.0)
  {
    return above;
  }
  const double below = std::sinh(bottom * (s + 1.0)) / std::sinh(bottom) - 1.0;
  // weight (s + 1) (1 + (1 - (s + 1))), both powers 1
  const double weight = (s + 1.0) * (1.0 - s);
  return weight * above + (1.0 - weight) * below;
}

double Geyer(double surface, double bottom, double s)
{
  constexpr double gamma = 3.0;
  const double unit = std::log(std::cosh(gamma));
  const double above = -std::log(std::cosh(gamma * std::pow(std::abs(s), surface))) / unit;
  const double below = std::log(std::cosh(gamma * std::pow(s + 1.0, bottom))) / unit - 1.0;
  const double weight = 0.5 * (1.0 - std::tanh(gamma * (s + 0.5)));
  return weight * below + (1.0 - weight) * above;
}

double Shchepetkin2010(double surface, double bottom, double s)
{
  const double above = ShchepetkinSurface(surface, s);
  // (exp(b C) - 1)/(1 - exp(-b))
  return bottom > 0.0 ? std::expm1(bottom * above) / -std::expm1(-bottom) : above;
}

}

double OceanLevels::HeightOf(int level, double depth, double surface) const
{
  const auto k = static_cast<std::size_t>(level);
  const double s = this->S[k];
  const double hc = this->CriticalDepth;
  switch (this->Kind)
  {
    case LevelKind::Heights:
      return s;
    case LevelKind::Sigma:
      return surface + s * (depth + surface);
    case LevelKind::SCoordinate1:
    {
      // Z0 = hc s + (h - hc) C, z = Z0 + zeta (1 + Z0/h)
      const double still = hc * s + (depth - hc) * this->Stretching[k];
      return still + surface * (1.0 + still / depth);
    }
    case LevelKind::SCoordinate2:
      // Z0 = (hc s + h C)/(hc + h), z = zeta + (zeta + h) Z0
      return surface + (surface + depth) * (hc * s + depth * this->Stretching[k]) / (hc + depth);
    case LevelKind::SOfHaidvogel:
      break;
  }
  // z = zeta (1 + s) + hc s + (h - hc) C
  return surface * (1.0 + s) + hc * s + (depth - hc) * this->Stretching[k];
}

double LevelStretching::At(double s) const
{
  switch (this->Function)
  {
    case 1:
      return SongHaidvogel(this->Surface, this->Bottom, s);
    case 2:
      return Shchepetkin2005(this->Surface, this->Bottom, s);
    case 3:
      return Geyer(this->Surface, this->Bottom, s);
    case 4:
    case 5: // the same function of levels that are not evenly apart
      return Shchepetkin2010(this->Surface, this->Bottom, s);
    default:
      Refuse("its stretching of levels (Vstretching) is ", this->Function, "; 1 to 5 are known");
  }
}

}
