// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralConstants_h
#define LittoralConstants_h

namespace littoral
{

inline constexpr double Pi = 3.14159265358979323846;
inline constexpr double TwoPi = 2.0 * Pi;
inline constexpr double Degree = Pi / 180.0; ///< [rad]

/// Standard acceleration of gravity [m/s2].
inline constexpr double Gravity = 9.80665;

}

#endif
