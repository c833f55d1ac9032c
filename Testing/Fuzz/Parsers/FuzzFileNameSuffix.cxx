// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The suffix of files in a series: where it is valid, it gives what printf() does.

#include "Expect.h"
#include "NumberedSuffix.h"

#include <array>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  const std::string suffix(reinterpret_cast<const char*>(bytes), size);
  const littoral::NumberedSuffix numbered(suffix);
  std::array<char, 4096> printed;
  for (const int number : { 0, 7, 12345 })
  {
    const std::string text = numbered.With(number);
    if (numbered.IsValid && size < 2048 && suffix.find('\0') == std::string::npos)
    {
      std::snprintf(printed.data(), printed.size(), suffix.c_str(), number);
      Expect(text == printed.data(), "'" + text + "' is not '" + printed.data() + "'");
    }
  }
  return 0;
}
