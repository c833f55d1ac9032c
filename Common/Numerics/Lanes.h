// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLanes_h
#define LittoralLanes_h

#include "Numerics/Constants.h"
#include "Numerics/SimdClones.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

// Arithmetic on numbers that stand side by side, one of each of four things of the same shape, so that a kernel is
// written once, for a Real that is a double or Lanes. GLM's vectors take Lanes as they take doubles. A lane never knows
// of its neighbours: it gets the bytes that it would get alone.

namespace littoral
{

/// Numbers side by side.
constexpr int LaneCount = 4;

/// Aligned as the widest version of a kernel expects it, wherever it is made.
struct alignas(LaneCount * sizeof(double)) Lanes
{
  typedef double Register __attribute__((vector_size(LaneCount * sizeof(double))));
  Register Values;

  Lanes() = default;
  LITTORAL_INLINE Lanes(double all) // as doubles become any number
    : Values(all - Register{})
  {
  }
  LITTORAL_INLINE explicit Lanes(const Register& values)
    : Values(values)
  {
  }
  LITTORAL_INLINE Lanes(double a, double b, double c, double d)
    : Values{ a, b, c, d }
  {
  }

  LITTORAL_INLINE Lanes& operator+=(const Lanes& o)
  {
    this->Values += o.Values;
    return *this;
  }
  LITTORAL_INLINE Lanes& operator-=(const Lanes& o)
  {
    this->Values -= o.Values;
    return *this;
  }
  LITTORAL_INLINE Lanes& operator*=(const Lanes& o)
  {
    this->Values *= o.Values;
    return *this;
  }
  LITTORAL_INLINE Lanes& operator/=(const Lanes& o)
  {
    this->Values /= o.Values;
    return *this;
  }
  friend LITTORAL_INLINE Lanes operator+(const Lanes& a, const Lanes& b) { return Lanes(a.Values + b.Values); }
  friend LITTORAL_INLINE Lanes operator-(const Lanes& a, const Lanes& b) { return Lanes(a.Values - b.Values); }
  friend LITTORAL_INLINE Lanes operator*(const Lanes& a, const Lanes& b) { return Lanes(a.Values * b.Values); }
  friend LITTORAL_INLINE Lanes operator/(const Lanes& a, const Lanes& b) { return Lanes(a.Values / b.Values); }
  friend LITTORAL_INLINE Lanes operator-(const Lanes& a) { return Lanes(-a.Values); }
};

/// As many numbers of single precision, for memory.
typedef float Singles __attribute__((vector_size(LaneCount * sizeof(float))));

/// Where a condition holds, one number, else another.
LITTORAL_INLINE double WhereLess(double a, double b, double then, double other)
{
  return a < b ? then : other;
}
LITTORAL_INLINE Lanes WhereLess(const Lanes& a, const Lanes& b, const Lanes& then, const Lanes& other)
{
  return Lanes(a.Values < b.Values ? then.Values : other.Values);
}

template <typename Real>
LITTORAL_INLINE Real Smaller(const Real& a, const Real& b)
{
  return WhereLess(b, a, b, a);
}

template <typename Real>
LITTORAL_INLINE Real Larger(const Real& a, const Real& b)
{
  return WhereLess(a, b, b, a);
}

template <typename Real>
LITTORAL_INLINE Real Between(const Real& x, const Real& low, const Real& high)
{
  return Smaller(Larger(x, low), high);
}

template <typename Real>
LITTORAL_INLINE Real Magnitude(const Real& x)
{
  return WhereLess(x, Real(0.0), -x, x);
}

/// A function of the standard library, lane by lane.
template <typename Function>
LITTORAL_INLINE Lanes EachLane(const Lanes& x, const Function& f)
{
  return { f(x.Values[0]), f(x.Values[1]), f(x.Values[2]), f(x.Values[3]) };
}

LITTORAL_INLINE double SquareRoot(double x)
{
  return std::sqrt(x);
}
LITTORAL_INLINE Lanes SquareRoot(const Lanes& x)
{
  return EachLane(x, [](double one) { return std::sqrt(one); });
}

LITTORAL_INLINE double Sine(double x)
{
  return std::sin(x);
}
LITTORAL_INLINE Lanes Sine(const Lanes& x)
{
  return EachLane(x, [](double one) { return std::sin(one); });
}

LITTORAL_INLINE double Cosine(double x)
{
  return std::cos(x);
}
LITTORAL_INLINE Lanes Cosine(const Lanes& x)
{
  return EachLane(x, [](double one) { return std::cos(one); });
}

/// c[0] + c[1] x + ...
template <typename Real, std::size_t Count>
LITTORAL_INLINE Real Polynomial(const std::array<double, Count>& c, const Real& x)
{
  Real sum(c[Count - 1]);
  for (std::size_t i = Count - 1; i-- > 0;)
  {
    sum = sum * x + Real(c[i]);
  }
  return sum;
}

/// The angle of a direction (cosine, sine) of any length whose sine is not negative [rad], to 3e-16.
template <typename Real>
LITTORAL_INLINE Real AngleOf(const Real& sine, const Real& cosine)
{
  // atan(x)/x through Chebyshev's nodes of x2 up to tan2(pi/8)
  constexpr std::array<double, 12> arc{ 1.0, -0.3333333333333312, 0.19999999999940893, -0.14285714279250245,
    0.11111110744919658, -0.09090896809064027, 0.07692045330902225, -0.06662951813629191, 0.05846878297330872,
    -0.05035102456601552, 0.03796525745386593, -0.017805397205419446 };
  constexpr double eighth = 0.41421356237309503; // tan(pi/8)
  const Real size = Magnitude(cosine);
  const Real slope = Smaller(size, sine) / Larger(Larger(size, sine), Real(1e-300));
  const Real x = WhereLess(Real(eighth), slope, (slope - Real(1.0)) / (slope + Real(1.0)), slope);
  const Real small = x * Polynomial(arc, x * x) + WhereLess(Real(eighth), slope, Real(0.25 * Pi), Real(0.0));
  const Real acute = WhereLess(size, sine, Real(0.5 * Pi) - small, small);
  return WhereLess(cosine, Real(0.0), Real(Pi) - acute, acute);
}

/// cos(a) of an angle of at most 0.8 rad, from its square, to 1e-16.
template <typename Real>
LITTORAL_INLINE Real CosineOfSmall(const Real& square)
{
  constexpr std::array<double, 9> taylor{ 1.0, -1.0 / 2, 1.0 / 24, -1.0 / 720, 1.0 / 40320, -1.0 / 3628800,
    1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000 };
  return Polynomial(taylor, square);
}

/// sin(a)/a of an angle of at most 0.8 rad, from its square, to 1e-16.
template <typename Real>
LITTORAL_INLINE Real SineRatioOfSmall(const Real& square)
{
  constexpr std::array<double, 9> taylor{ 1.0, -1.0 / 6, 1.0 / 120, -1.0 / 5040, 1.0 / 362880, -1.0 / 39916800,
    1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000 };
  return Polynomial(taylor, square);
}

template <typename Real>
LITTORAL_INLINE Real LengthOf(const glm::vec<3, Real>& a)
{
  return SquareRoot(glm::dot(a, a));
}

/// Where the things of the lanes stand in an array.
using LaneIndices = std::array<std::size_t, LaneCount>;

/// A member of four things of an array, or of what they inherit from, side by side.
template <typename Thing, typename Whole>
LITTORAL_INLINE Lanes GatherNumber(const Thing* things, const LaneIndices& at, double Whole::*part)
{
  return { things[at[0]].*part, things[at[1]].*part, things[at[2]].*part, things[at[3]].*part };
}

template <typename Thing, typename Whole>
LITTORAL_INLINE glm::vec<3, Lanes> GatherVector(
  const Thing* things, const LaneIndices& at, glm::vec<3, double> Whole::*part)
{
  const glm::vec<3, double>& a = things[at[0]].*part;
  const glm::vec<3, double>& b = things[at[1]].*part;
  const glm::vec<3, double>& c = things[at[2]].*part;
  const glm::vec<3, double>& d = things[at[3]].*part;
  return { Lanes(a.x, b.x, c.x, d.x), Lanes(a.y, b.y, c.y, d.y), Lanes(a.z, b.z, c.z, d.z) };
}

template <typename Thing, typename Whole>
LITTORAL_INLINE glm::qua<Lanes> GatherTurn(const Thing* things, const LaneIndices& at, glm::qua<double> Whole::*part)
{
  const glm::qua<double>& a = things[at[0]].*part;
  const glm::qua<double>& b = things[at[1]].*part;
  const glm::qua<double>& c = things[at[2]].*part;
  const glm::qua<double>& d = things[at[3]].*part;
  return { Lanes(a.w, b.w, c.w, d.w), Lanes(a.x, b.x, c.x, d.x), Lanes(a.y, b.y, c.y, d.y), Lanes(a.z, b.z, c.z, d.z) };
}

/// One lane of numbers that stand side by side.
LITTORAL_INLINE glm::vec<3, double> LaneOf(const glm::vec<3, Lanes>& lanes, int lane)
{
  return { lanes.x.Values[lane], lanes.y.Values[lane], lanes.z.Values[lane] };
}

LITTORAL_INLINE glm::qua<double> LaneOf(const glm::qua<Lanes>& lanes, int lane)
{
  return { lanes.w.Values[lane], lanes.x.Values[lane], lanes.y.Values[lane], lanes.z.Values[lane] };
}

}

/// So that GLM takes lanes as the floating-point numbers that they are.
template <>
class std::numeric_limits<littoral::Lanes> : public std::numeric_limits<double>
{
};

#endif
