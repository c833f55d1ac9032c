// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPresetNumbers_h
#define LittoralPresetNumbers_h

#include <string>
#include <vector>

namespace littoral
{

/// A property of a proxy and its values.
struct PresetNumber
{
  const char* Property;
  std::vector<double> Values;
};

/// Values of the preset of a source; none if the class has no presets or the preset is Custom or does not exist.
std::vector<PresetNumber> PresetNumbersOf(
  const std::string& source, int preset, double height, double diameter, double crown);

}

#endif
