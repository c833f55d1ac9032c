// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralNumberedSuffix_h
#define LittoralNumberedSuffix_h

#include <cstddef>
#include <string>

namespace littoral
{

/// A suffix of files with the place of a number, as in `_%04d`: text, `%`, at most two digits of its width, `d`, text
/// without `%`.
class NumberedSuffix
{
public:
  explicit NumberedSuffix(const std::string& suffix)
  {
    const std::size_t percent = suffix.find('%');
    const std::size_t letter = percent == std::string::npos ? percent : suffix.find('d', percent);
    this->IsValid = letter != std::string::npos && letter - percent <= 3 &&
      suffix.find_first_not_of("0123456789", percent + 1) == letter && suffix.find('%', letter) == std::string::npos;
    if (this->IsValid)
    {
      this->Before = suffix.substr(0, percent);
      this->Width = suffix.substr(percent + 1, letter - percent - 1);
      this->After = suffix.substr(letter + 1);
    }
  }
  std::string With(int number) const
  {
    std::string digits = std::to_string(number);
    const std::size_t wanted = this->Width.empty() ? 0 : std::stoul(this->Width);
    digits.insert(0, wanted > digits.size() ? wanted - digits.size() : 0, this->Width[0] == '0' ? '0' : ' ');
    return this->Before + digits + this->After;
  }

  bool IsValid = false;

private:
  std::string Before;
  std::string Width;
  std::string After;
};

}

#endif
