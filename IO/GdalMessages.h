// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralGdalMessages_h
#define LittoralGdalMessages_h

#include <initializer_list>
#include <string>
#include <vector>

namespace littoral
{

/// Keeps what GDAL has to say on this thread, instead of the terminal, for as long as it lives.
class GdalMessages
{
public:
  GdalMessages();
  ~GdalMessages();
  GdalMessages(const GdalMessages&) = delete;
  GdalMessages& operator=(const GdalMessages&) = delete;

  /// The first error since the beginning or the last Forget(), without a period, else words of one's own.
  std::string ErrorOr(const std::string& words) const;

  /// The first error or warning that has one of some words; empty for none.
  std::string About(std::initializer_list<const char*> words) const;

  void Forget() { this->All.clear(); }

  void Take(bool isError, const char* message);

private:
  struct Message
  {
    bool IsError;
    std::string Text;
  };
  std::vector<Message> All;
};

}

#endif
