// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralReducedDistance_h
#define LittoralReducedDistance_h

#include <cmath>

namespace littoral
{

/// Distances in the space where an anisotropic field is isotropic: with l along the angle and a across it,
/// r^2 = l^2 + (ratio a)^2.
class ReducedDistance
{
public:
  ReducedDistance(double ratio, double angle)
    : Cosine(std::cos(angle))
    , Sine(std::sin(angle))
    , Ratio(ratio)
  {
  }

  double operator()(double x, double y) const
  {
    const double along = this->Cosine * x + this->Sine * y;
    const double across = this->Ratio * (this->Cosine * y - this->Sine * x);
    return std::sqrt(along * along + across * across);
  }

  /// Change of ln r with ln ratio, and with the angle; 0 at r = 0.
  struct Changes
  {
    double ByRatio;
    double ByAngle;
  };
  Changes ChangesAt(double x, double y) const
  {
    const double along = this->Cosine * x + this->Sine * y;
    const double across = this->Cosine * y - this->Sine * x;
    const double ratio2 = this->Ratio * this->Ratio;
    const double r2 = along * along + ratio2 * across * across;
    return r2 > 0.0 ? Changes{ ratio2 * across * across / r2, (1.0 - ratio2) * along * across / r2 } : Changes{ 0, 0 };
  }

private:
  double Cosine;
  double Sine;
  double Ratio;
};

}

#endif
