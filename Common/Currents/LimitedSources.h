// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLimitedSources_h
#define LittoralLimitedSources_h

#include "Geometry/ViewFrustum.h"
#include "Numerics/Vector3.h"

#include <cstddef>
#include <vector>

namespace littoral
{

/**
 * Softened sources and sinks that end at a margin about a box, as those of plant wakes do, evaluated four at a time. The
 * bytes of a sum are those of one after the other.
 */
class LimitedSources
{
public:
  struct Source
  {
    Vector3 Center;       ///< [m]
    double Factor;        ///< Q / 4pi, signed
    double CoreSquared;   ///< [m2]
    Box Whole;            ///< where the flow is whole
    double InverseMargin; ///< one over the square of the margin, positive [1/m2]
  };

  void Add(const Source& source) { this->Sources.push_back(source); }

  std::size_t Size() const { return this->Sources.size(); }

  /// Adds the flow at a place of some of the sources, by their numbers, in that order [m/s].
  void AddFlow(const int* begin, const int* end, const Vector3& place, Vector3& sum) const;

private:
  std::vector<Source> Sources;
};

}

#endif
