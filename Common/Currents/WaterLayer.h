// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralWaterLayer_h
#define LittoralWaterLayer_h

#include <cmath>
#include <limits>

namespace littoral
{

/// Water between a level bed and a surface, either of which may be missing. No flow goes through them.
struct WaterLayer
{
  double Bed = -std::numeric_limits<double>::infinity();    ///< [m]
  double Surface = std::numeric_limits<double>::infinity(); ///< [m]

  bool HasBed() const { return std::isfinite(this->Bed); }
  bool HasSurface() const { return std::isfinite(this->Surface); }
  bool HasWalls() const { return this->HasBed() || this->HasSurface(); }
  /// Infinite unless there are both walls [m].
  double Depth() const { return this->Surface - this->Bed; }
  bool Holds(double height) const { return height >= this->Bed && height <= this->Surface; }

  /// The height within the layer that stands for a height of the mirrored water. `upright` tells whether it is seen
  /// by an even number of mirrors.
  double Fold(double height, bool& upright) const
  {
    upright = true;
    if (this->Holds(height))
    {
      return height;
    }
    if (this->HasBed() && this->HasSurface())
    {
      const double turns = std::floor((height - this->Bed) / this->Depth());
      const double remainder = std::fmin(std::fmax(height - this->Bed - turns * this->Depth(), 0.0), this->Depth());
      upright = std::fmod(turns, 2.0) == 0.0;
      return upright ? this->Bed + remainder : this->Surface - remainder;
    }
    upright = false;
    return height < this->Bed ? std::fmax(2.0 * this->Bed - height, this->Bed)
                              : std::fmin(2.0 * this->Surface - height, this->Surface);
  }
};

}

#endif
