// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/SeaweedSegment.h"

#include "Numerics/ParameterRange.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

double EquivalentRadius(const SeaweedSegment& segment)
{
  return 0.5 * std::sqrt(segment.Width * segment.Thickness);
}

std::string WhyInvalid(const SeaweedSegment& segment)
{
  for (const std::string& reason :
    { OutOfRange("Width", segment.Width, 1e-6, 1e3), OutOfRange("Thickness", segment.Thickness, 1e-6, 1e3),
      OutOfRange("YoungModulus", segment.YoungModulus, 0.0, 1e13),
      OutOfRange("DampingRatio", segment.DampingRatio, 0.0, 1e3), OutOfRange("Density", segment.Density, 1.0, 1e5),
      OutOfRange("Tissue", static_cast<double>(static_cast<int>(segment.Tissue)), 0.0, 3.0) })
  {
    if (!reason.empty())
    {
      return reason;
    }
  }
  const bool isUnit = std::abs(glm::length(segment.Across) - 1.0) < 1e-3;
  return isUnit ? "" : "Across must have length 1.";
}

}
