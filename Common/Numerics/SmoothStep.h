// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSmoothStep_h
#define LittoralSmoothStep_h

#include <algorithm>

namespace littoral
{

/// Smooth step from 0 at low to 1 at high and beyond, without kinks: t^2 (3 - 2 t), t = (x - low) / (high - low).
inline double SmoothStep(double low, double high, double x)
{
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}

#endif
