// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GdalMessages.h"

#include <cpl_error.h>

namespace littoral
{

namespace
{

void CPL_STDCALL TakeMessage(CPLErr kind, CPLErrorNum, const char* message)
{
  auto* messages = static_cast<GdalMessages*>(CPLGetErrorHandlerUserData());
  if (messages && message && kind >= CE_Warning)
  {
    messages->Take(kind != CE_Warning, message);
  }
}

}

GdalMessages::GdalMessages()
{
  CPLPushErrorHandlerEx(TakeMessage, this);
}

GdalMessages::~GdalMessages()
{
  CPLPopErrorHandler();
}

std::string GdalMessages::ErrorOr(const std::string& words) const
{
  for (const Message& message : this->All)
  {
    if (message.IsError)
    {
      return message.Text;
    }
  }
  return words;
}

std::string GdalMessages::About(std::initializer_list<const char*> words) const
{
  for (const Message& message : this->All)
  {
    for (const char* word : words)
    {
      if (message.Text.find(word) != std::string::npos)
      {
        return message.Text;
      }
    }
  }
  return {};
}

void GdalMessages::Take(bool isError, const char* message)
{
  constexpr std::size_t most = 100; // a damaged file can have one a pixel
  if (this->All.size() >= most)
  {
    return;
  }
  std::string text = message;
  while (!text.empty() && (text.back() == '.' || text.back() == '\n' || text.back() == ' '))
  {
    text.pop_back();
  }
  this->All.push_back({ isError, text });
}

}
