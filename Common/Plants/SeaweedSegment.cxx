// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/SeaweedSegment.h"

#include "Numerics/ParameterCheck.h"

#include <cmath>

namespace littoral
{

double EquivalentRadius(const SeaweedSegment& segment)
{
  return 0.5 * std::sqrt(segment.Width * segment.Thickness);
}

std::string WhyInvalid(const SeaweedSegment& segment)
{
  ParameterCheck check;
  check.Range("Width", segment.Width, 1e-6, 1e3, "m");
  check.Range("Thickness", segment.Thickness, 1e-6, 1e3, "m");
  check.Range("YoungModulus", segment.YoungModulus, 0.0, 1e13, "Pa");
  check.Range("DampingRatio", segment.DampingRatio, 0.0, 1e3);
  check.Range("Density", segment.Density, 1.0, 1e5, "kg/m3");
  check.Choice("Tissue", static_cast<int>(segment.Tissue), 4);
  check.Require(std::abs(glm::length(segment.Across) - 1.0) < 1e-3, "Across must have length 1.");
  return check.Reason();
}

}
