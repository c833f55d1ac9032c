// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralParameterCheck_h
#define LittoralParameterCheck_h

#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>

namespace littoral
{

/// Magnitudes that a parameter in any unit can sensibly have, besides 0. Beyond them products of a few parameters
/// overflow, or vanish where they divide.
constexpr double MinimumMagnitude = 1e-30;
constexpr double MaximumMagnitude = 1e15;

/// Whether a number is 0 or of a sensible magnitude; NaN and infinity are not.
bool IsSensible(double value);

/// Interval of allowed values. Values that are not finite are never allowed.
struct ValueInterval
{
  double Low = -std::numeric_limits<double>::infinity();
  double High = std::numeric_limits<double>::infinity();
  bool IncludesLow = false;
  bool IncludesHigh = false;

  static constexpr ValueInterval Positive() { return Above(0.0, std::numeric_limits<double>::infinity()); }
  static constexpr ValueInterval NotNegative() { return AtLeast(0.0); }
  static constexpr ValueInterval AtLeast(double low)
  {
    return { low, std::numeric_limits<double>::infinity(), true, false };
  }
  /// Above low, at most high.
  static constexpr ValueInterval Above(double low, double high) { return { low, high, false, true }; }
  /// Both ends included.
  static constexpr ValueInterval From(double low, double high) { return { low, high, true, true }; }
  /// Both ends excluded.
  static constexpr ValueInterval Between(double low, double high) { return { low, high, false, false }; }

  bool Contains(double value) const;

  /// The interval in words, as "positive and at most 200 m/s".
  std::string Words(const char* unit = "") const;
};

/**
 * Checks of parameters, in one wording: "TimeStep is 2 s; it must be from 1e-05 to 1 s." Elements of a property are named
 * by their axis: Size[0] is "Size, x". The first bad one counts;
 * those after it are not looked at. Numbers that are not sensible are bad, whatever the interval.
 *
 *   ParameterCheck check;
 *   check.Choice("Method", method, 2);
 *   check.Range("TimeStep", step, 1e-5, 1.0, "s");
 *   return check.Reason();
 */
class ParameterCheck
{
public:
  /// Why the parameters are bad; empty when they are good.
  const std::string& Reason() const { return this->First; }

  bool IsGood() const { return this->First.empty(); }

  /// A number within an interval.
  void Within(std::string_view name, double value, const ValueInterval& allowed, const char* unit = "");

  /// A number from low to high, ends included.
  void Range(std::string_view name, double value, double low, double high, const char* unit = "");

  /// A number above 0, and at most `high`.
  void Positive(
    std::string_view name, double value, const char* unit = "", double high = std::numeric_limits<double>::infinity());

  /// A number of at least 0, and at most `high`.
  void NotNegative(
    std::string_view name, double value, const char* unit = "", double high = std::numeric_limits<double>::infinity());

  void Finite(std::string_view name, double value, const char* unit = "");

  /// A choice of an enumeration, from 0 to count - 1.
  void Choice(std::string_view name, int value, int count);

  /// A choice of an enumeration whose values from 0 on have names: "Method is 3; it must be 0 (linear) or 1 (cubic)."
  void Choice(std::string_view name, int value, std::initializer_list<const char*> names);

  /// A whole number from low to high, ends included.
  void Count(std::string_view name, long long value, long long low, long long high);

  /// A whole number above 0.
  void PositiveCount(std::string_view name, long long value);

  /// The two ends of a range, the first below the second.
  void Increasing(std::string_view name, const double* ends, const char* unit = "");

  /// Three parts of a color, from 0 to 1.
  void Color(std::string_view name, const double* color);

  /// A reason found elsewhere; empty when all is good there.
  void Require(const std::string& reason) { this->Require(reason.empty(), reason); }

  /// Any other condition, in words that name the parameter: "ViewUp must be finite and not zero."
  void Require(bool isGood, std::string_view otherwise);

  /// The one sentence of all of these: "NAME is VALUE UNIT; it must be WANTED."
  void Require(bool isGood, std::string_view name, double value, const char* unit, std::string_view wanted);

private:
  std::string First;
};

/// A number as short as it reads: 0.1, 1e-05, 20.
std::string TextOf(double value);

}

#endif
