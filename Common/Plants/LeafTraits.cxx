// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/LeafTraits.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace littoral
{

namespace
{

constexpr double CentimetresOfMetre = 100.0;

constexpr LeafTraits Rows[] = {
  { "hardwood", 0.0686, 0.15, { -2.4800, 2.4835 }, { -4.0813, 5.8816 } },
  { "oak;quercus", 0.080, 0.15, { -2.0127, 2.4342 }, { -4.0813, 5.8816 } },
  { "beech;fagus;maple;acer;hickory;carya", 0.0686, 0.15, { -2.0127, 2.4342 }, { -4.0813, 5.8816 } },
  { "birch;betula", 1.0 / 13.55, 0.15, { -1.9123, 2.3651 }, { -4.0813, 5.8816 } },
  { "pine;pinus", 1.0 / 6.2, 0.18, { -2.5356, 2.4349 }, { -2.9584, 4.4766 } },
  { "spruce;picea", 1.0 / 4.95, 0.18, { -2.0773, 2.3323 }, { -2.9584, 4.4766 } },
  { "larch;larix", 1.0 / 11.7, 0.18, { -2.0336, 2.2592 }, { -2.9584, 4.4766 } },
};

/// Whether a name is one of some that semicolons separate.
bool IsAmong(const std::string& name, const std::string& names)
{
  return !name.empty() && (";" + names + ";").find(";" + name + ";") != std::string::npos;
}

}

const LeafTraits* FindLeafTraits(const std::string& name)
{
  std::string plain = name;
  std::transform(plain.begin(), plain.end(), plain.begin(), [](unsigned char letter) { return std::tolower(letter); });
  for (const std::string& wanted : { plain, plain.substr(0, plain.find(' ')), plain.substr(plain.rfind(' ') + 1) })
  {
    for (const LeafTraits& row : Rows)
    {
      if (IsAmong(wanted, row.Names))
      {
        return &row;
      }
    }
  }
  return nullptr;
}

const LeafTraits& HardwoodTraits()
{
  return Rows[0];
}

double FoliageMassOf(const LeafTraits& traits, double diameter)
{
  // m = exp(b0 + b1 ln D) exp(c0 + c1 / D)
  const double d = diameter * CentimetresOfMetre;
  return std::exp(
    traits.Biomass[0] + traits.Biomass[1] * std::log(d) + traits.FoliageRatio[0] + traits.FoliageRatio[1] / d);
}

}
