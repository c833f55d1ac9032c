// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSimdDouble4_h
#define LittoralSimdDouble4_h

#include "Numerics/Constants.h"
#include "Numerics/SimdClones.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

// Doubles side by side in one vector register, a lane each, so that a kernel is written once for a Real that is a
// double or SimdDoubles. GLM's vectors take either. Lanes do not mix: each gets the bytes that it would get alone.

namespace littoral
{

/// A power of two of doubles, aligned as the widest version of a kernel expects them, wherever they are made.
template <std::size_t Lanes>
struct alignas(Lanes * sizeof(double)) SimdDoubles
{
  typedef double Register __attribute__((vector_size(Lanes * sizeof(double))));
  Register Values;

  static constexpr std::size_t Count = Lanes;

  SimdDoubles() = default;
  LITTORAL_INLINE SimdDoubles(double all) // in all lanes; implicit, as double converts to any Real
    : Values(all - Register{})
  {
  }
  LITTORAL_INLINE explicit SimdDoubles(const Register& values)
    : Values(values)
  {
  }
  template <typename... Others, std::enable_if_t<sizeof...(Others) + 2 == Lanes, int> = 0>
  LITTORAL_INLINE SimdDoubles(double a, double b, Others... others)
    : Values{ a, b, static_cast<double>(others)... }
  {
  }

  LITTORAL_INLINE SimdDoubles& operator+=(const SimdDoubles& o)
  {
    this->Values += o.Values;
    return *this;
  }
  LITTORAL_INLINE SimdDoubles& operator-=(const SimdDoubles& o)
  {
    this->Values -= o.Values;
    return *this;
  }
  LITTORAL_INLINE SimdDoubles& operator*=(const SimdDoubles& o)
  {
    this->Values *= o.Values;
    return *this;
  }
  LITTORAL_INLINE SimdDoubles& operator/=(const SimdDoubles& o)
  {
    this->Values /= o.Values;
    return *this;
  }
  friend LITTORAL_INLINE SimdDoubles operator+(const SimdDoubles& a, const SimdDoubles& b)
  {
    return SimdDoubles(a.Values + b.Values);
  }
  friend LITTORAL_INLINE SimdDoubles operator-(const SimdDoubles& a, const SimdDoubles& b)
  {
    return SimdDoubles(a.Values - b.Values);
  }
  friend LITTORAL_INLINE SimdDoubles operator*(const SimdDoubles& a, const SimdDoubles& b)
  {
    return SimdDoubles(a.Values * b.Values);
  }
  friend LITTORAL_INLINE SimdDoubles operator/(const SimdDoubles& a, const SimdDoubles& b)
  {
    return SimdDoubles(a.Values / b.Values);
  }
  friend LITTORAL_INLINE SimdDoubles operator-(const SimdDoubles& a) { return SimdDoubles(-a.Values); }

  /// Lane by lane, a < b ? then : other.
  friend LITTORAL_INLINE SimdDoubles SelectLess(
    const SimdDoubles& a, const SimdDoubles& b, const SimdDoubles& then, const SimdDoubles& other)
  {
    return SimdDoubles(a.Values < b.Values ? then.Values : other.Values);
  }
};

/// Four lanes, for what needs no others.
using SimdDouble4 = SimdDoubles<4>;

/// Lanes of a SimdDouble4.
constexpr int LaneCount = static_cast<int>(SimdDouble4::Count);

/// Four floats, for loads and stores.
typedef float SimdFloat4 __attribute__((vector_size(LaneCount * sizeof(float))));

/// Four numbers anywhere in memory.
LITTORAL_INLINE SimdFloat4 LoadFloats(const float* from)
{
  SimdFloat4 four;
  std::memcpy(&four, from, sizeof four);
  return four;
}

/// a < b ? then : other.
LITTORAL_INLINE double SelectLess(double a, double b, double then, double other)
{
  return a < b ? then : other;
}

template <typename Real>
LITTORAL_INLINE Real Min(const Real& a, const Real& b)
{
  return SelectLess(b, a, b, a);
}

template <typename Real>
LITTORAL_INLINE Real Max(const Real& a, const Real& b)
{
  return SelectLess(a, b, b, a);
}

template <typename Real>
LITTORAL_INLINE Real Clamp(const Real& x, const Real& low, const Real& high)
{
  return Min(Max(x, low), high);
}

template <typename Real>
LITTORAL_INLINE Real Abs(const Real& x)
{
  return SelectLess(x, Real(0.0), -x, x);
}

template <std::size_t Lanes, typename Function, std::size_t... Lane>
LITTORAL_INLINE SimdDoubles<Lanes> EachLane(
  const SimdDoubles<Lanes>& x, const Function& f, std::index_sequence<Lane...> /*lanes*/)
{
  return { f(x.Values[Lane])... };
}

/// A function of the standard library, lane by lane.
template <std::size_t Lanes, typename Function>
LITTORAL_INLINE SimdDoubles<Lanes> EachLane(const SimdDoubles<Lanes>& x, const Function& f)
{
  return EachLane(x, f, std::make_index_sequence<Lanes>());
}

LITTORAL_INLINE double Sqrt(double x)
{
  return std::sqrt(x);
}
template <std::size_t Lanes>
LITTORAL_INLINE SimdDoubles<Lanes> Sqrt(const SimdDoubles<Lanes>& x)
{
  return EachLane(x, [](double one) { return std::sqrt(one); });
}

LITTORAL_INLINE double Sin(double x)
{
  return std::sin(x);
}
template <std::size_t Lanes>
LITTORAL_INLINE SimdDoubles<Lanes> Sin(const SimdDoubles<Lanes>& x)
{
  return EachLane(x, [](double one) { return std::sin(one); });
}

LITTORAL_INLINE double Cos(double x)
{
  return std::cos(x);
}
template <std::size_t Lanes>
LITTORAL_INLINE SimdDoubles<Lanes> Cos(const SimdDoubles<Lanes>& x)
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
  const Real size = Abs(cosine);
  const Real slope = Min(size, sine) / Max(Max(size, sine), Real(1e-300));
  const Real x = SelectLess(Real(eighth), slope, (slope - Real(1.0)) / (slope + Real(1.0)), slope);
  const Real small = x * Polynomial(arc, x * x) + SelectLess(Real(eighth), slope, Real(0.25 * Pi), Real(0.0));
  const Real acute = SelectLess(size, sine, Real(0.5 * Pi) - small, small);
  return SelectLess(cosine, Real(0.0), Real(Pi) - acute, acute);
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
LITTORAL_INLINE Real Length(const glm::vec<3, Real>& a)
{
  return Sqrt(glm::dot(a, a));
}

/// Indices of the lanes' elements in an array.
using LaneIndices = std::array<std::size_t, LaneCount>;

template <std::size_t Lanes, typename Number, std::size_t... Lane>
LITTORAL_INLINE SimdDoubles<Lanes> FromLanes(
  const Number& number, std::size_t first, std::index_sequence<Lane...> /*lanes*/)
{
  return { number(first + Lane)... };
}

/// A number of each lane, counted from the first.
template <std::size_t Lanes, typename Number>
LITTORAL_INLINE SimdDoubles<Lanes> FromLanes(const Number& number, std::size_t first = 0)
{
  if constexpr (Lanes == 8)
  {
    // GCC 12 would put them one by one into a register that it has not halved
    const SimdDouble4 low = FromLanes<4>(number, first);
    const SimdDouble4 high = FromLanes<4>(number, first + 4);
    return SimdDoubles<8>(__builtin_shufflevector(low.Values, high.Values, 0, 1, 2, 3, 4, 5, 6, 7));
  }
  else
  {
    return FromLanes<Lanes>(number, first, std::make_index_sequence<Lanes>());
  }
}

/// One member of elements of an array, which may be inherited, a lane each.
template <std::size_t Lanes, typename Element, typename Class>
LITTORAL_INLINE SimdDoubles<Lanes> GatherNumber(
  const Element* elements, const std::array<std::size_t, Lanes>& at, double Class::*member)
{
  return FromLanes<Lanes>([&](std::size_t lane) { return elements[at[lane]].*member; });
}

/// Vectors, a lane each.
template <std::size_t Lanes, typename Element, typename Class>
LITTORAL_INLINE glm::vec<3, SimdDoubles<Lanes>> GatherVector(
  const Element* elements, const std::array<std::size_t, Lanes>& at, glm::vec<3, double> Class::*member)
{
  return { FromLanes<Lanes>([&](std::size_t lane) { return (elements[at[lane]].*member).x; }),
    FromLanes<Lanes>([&](std::size_t lane) { return (elements[at[lane]].*member).y; }),
    FromLanes<Lanes>([&](std::size_t lane) { return (elements[at[lane]].*member).z; }) };
}

template <std::size_t Lanes, typename Element, typename Class>
LITTORAL_INLINE glm::qua<SimdDoubles<Lanes>> GatherRotation(
  const Element* elements, const std::array<std::size_t, Lanes>& at, glm::qua<double> Class::*member)
{
  return { FromLanes<Lanes>([&](std::size_t lane) { return (elements[at[lane]].*member).w; }),
    FromLanes<Lanes>([&](std::size_t lane) { return (elements[at[lane]].*member).x; }),
    FromLanes<Lanes>([&](std::size_t lane) { return (elements[at[lane]].*member).y; }),
    FromLanes<Lanes>([&](std::size_t lane) { return (elements[at[lane]].*member).z; }) };
}

/// Four vectors, a lane each.
LITTORAL_INLINE glm::vec<3, SimdDouble4> InLanes(const glm::vec<3, double>& a, const glm::vec<3, double>& b,
  const glm::vec<3, double>& c, const glm::vec<3, double>& d)
{
  return { SimdDouble4(a.x, b.x, c.x, d.x), SimdDouble4(a.y, b.y, c.y, d.y), SimdDouble4(a.z, b.z, c.z, d.z) };
}

/// The vector or quaternion of one lane.
template <std::size_t Lanes>
LITTORAL_INLINE glm::vec<3, double> LaneOf(const glm::vec<3, SimdDoubles<Lanes>>& lanes, std::size_t lane)
{
  return { lanes.x.Values[lane], lanes.y.Values[lane], lanes.z.Values[lane] };
}

template <std::size_t Lanes>
LITTORAL_INLINE glm::qua<double> LaneOf(const glm::qua<SimdDoubles<Lanes>>& lanes, std::size_t lane)
{
  return { lanes.w.Values[lane], lanes.x.Values[lane], lanes.y.Values[lane], lanes.z.Values[lane] };
}

}

/// Trait for GLM, which asks whether its numbers are floating-point.
template <std::size_t Lanes>
class std::numeric_limits<littoral::SimdDoubles<Lanes>> : public std::numeric_limits<double>
{
};

#endif
