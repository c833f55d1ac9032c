// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralParameterCheck_h
#define LittoralParameterCheck_h

#include <limits>
#include <string>

namespace littoral
{

/**
 * Checks of parameters, in one wording: "TimeStep is 2 s; it must be from 1e-05 to 1 s." The first bad one counts;
 * those after it are not looked at. Numbers that are not finite are bad.
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

  /// A number from low to high, ends included.
  void Range(const std::string& name, double value, double low, double high, const char* unit = "");

  /// A number above 0, and at most `high`.
  void Positive(const std::string& name, double value, const char* unit = "",
    double high = std::numeric_limits<double>::infinity());

  /// A number of at least 0, and at most `high`.
  void NotNegative(const std::string& name, double value, const char* unit = "",
    double high = std::numeric_limits<double>::infinity());

  void Finite(const std::string& name, double value, const char* unit = "");

  /// A choice of an enumeration, from 0 to count - 1.
  void Choice(const std::string& name, int value, int count);

  /// A whole number from low to high, ends included.
  void Count(const std::string& name, long long value, long long low, long long high);

  /// A reason found elsewhere; empty when all is good there.
  void Require(const std::string& reason) { this->Require(reason.empty(), reason); }

  /// Any other condition, in words that name the parameter: "ViewUp must be finite and not zero."
  void Require(bool isGood, const std::string& otherwise);

  /// The one sentence of all of these: "NAME is VALUE UNIT; it must be WANTED."
  void Require(
    bool isGood, const std::string& name, const std::string& value, const char* unit, const std::string& wanted);

private:
  std::string First;
};

/// A number as short as it reads: 0.1, 1e-05, 20.
std::string TextOf(double value);

}

#endif
