// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralInvalidInput_h
#define LittoralInvalidInput_h

#include <sstream>
#include <stdexcept>
#include <string>

namespace littoral
{

/// An input or a property that nothing can be made of, as one sentence for a user.
class InvalidInput : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Throws InvalidInput with the sentence that the parts make.
template <typename... Parts>
[[noreturn]] void Refuse(const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  throw InvalidInput(text.str());
}

/// Throws InvalidInput unless a check, such as WhyInvalid(), has returned an empty text.
inline void Require(const std::string& whyNot)
{
  if (!whyNot.empty())
  {
    throw InvalidInput(whyNot);
  }
}

/// Puts words in front of the sentence of what a task refuses: "Cannot drain a terrain: ...".
template <typename Task>
auto InContext(const std::string& words, const Task& task)
{
  try
  {
    return task();
  }
  catch (const InvalidInput& refusal)
  {
    throw InvalidInput(words + refusal.what());
  }
}

/// Why a task refuses its input; empty if it does not.
template <typename Task>
std::string WhyRefused(const Task& task)
{
  try
  {
    task();
  }
  catch (const InvalidInput& refusal)
  {
    return refusal.what();
  }
  return {};
}

}

#endif
