// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralWords_h
#define LittoralWords_h

#include <string>
#include <vector>

namespace littoral
{

/// A text with small letters of ASCII.
std::string Lower(std::string text);

/// The words of a text that are apart by blanks.
std::vector<std::string> WordsOf(const std::string& text);

}

#endif
