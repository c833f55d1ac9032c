// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Check_h
#define Check_h

#include <iostream>
#include <string>

/// Says what is wrong, unless it is good.
inline bool Check(bool good, const std::string& what)
{
  if (!good)
  {
    std::cerr << what << std::endl;
  }
  return good;
}

#endif
