// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralParameterTraits_h
#define LittoralParameterTraits_h

#include "Numerics/ParameterCheck.h"

#include <string>
#include <type_traits>

namespace littoral
{

/// A parameter in the row of a model: the name and the unit that users see, the allowed values, and its member.
template <typename Parameters>
struct ParameterTraits
{
  const char* Name;
  const char* Unit; ///< empty for a pure number
  ValueInterval Allowed;
  double (*Get)(const Parameters&);
  void (*Set)(Parameters&, double);

  /// Why the value is bad, in words for a user; empty when it is good.
  std::string WhyInvalid(const Parameters& parameters) const
  {
    ParameterCheck check;
    check.Within(this->Name, this->Get(parameters), this->Allowed, this->Unit);
    return check.Reason();
  }
};

/// The traits of the parameter that a member holds: MakeParameter<Law, &Law::Mean>("Mean", "", ...).
template <typename Parameters, auto Member>
constexpr ParameterTraits<Parameters> MakeParameter(const char* name, const char* unit, const ValueInterval& allowed)
{
  return { name, unit, allowed, [](const Parameters& all) { return static_cast<double>(all.*Member); },
    [](Parameters& all, double value) {
      auto& member = all.*Member;
      member = static_cast<std::remove_reference_t<decltype(member)>>(value);
    } };
}

/// The parameters that count in a row.
template <typename Parameters>
struct ParameterList
{
  static constexpr int MaximumCount = 12;
  const ParameterTraits<Parameters>* Items[MaximumCount] = {}; ///< the rest is null

  const ParameterTraits<Parameters>* const* begin() const { return this->Items; }
  const ParameterTraits<Parameters>* const* end() const { return this->Items + this->Size(); }

  int Size() const
  {
    int size = 0;
    while (size < MaximumCount && this->Items[size])
    {
      ++size;
    }
    return size;
  }

  bool Has(const std::string& name) const
  {
    for (const ParameterTraits<Parameters>* item : *this)
    {
      if (name == item->Name)
      {
        return true;
      }
    }
    return false;
  }

  /// Why the first bad value is bad; empty when all are good.
  std::string WhyInvalid(const Parameters& parameters) const
  {
    for (const ParameterTraits<Parameters>* item : *this)
    {
      if (std::string reason = item->WhyInvalid(parameters); !reason.empty())
      {
        return reason;
      }
    }
    return {};
  }
};

/// Why a choice is none of a table's rows, as "Model is 9; it must be from 0 to 6."; empty when it is one.
inline std::string WhyNoRow(const char* name, int choice, int rows)
{
  ParameterCheck check;
  check.Choice(name, choice, rows);
  return check.Reason();
}

/// The name of a table's row, "Unknown" for a choice that is none; `nameOf` is asked for choices that are.
template <typename Choice, typename NameOf>
const char* NameOfRow(int choice, int rows, const NameOf& nameOf)
{
  return choice >= 0 && choice < rows ? nameOf(static_cast<Choice>(choice)) : "Unknown";
}

/// Likewise, of rows with traits.
template <typename Choice>
const char* NameOfRow(int choice, int rows)
{
  return NameOfRow<Choice>(choice, rows, [](Choice row) { return TraitsOf(row).Name; });
}

}

#endif
