// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralIntensityRaster_h
#define LittoralIntensityRaster_h

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace littoral
{

/// How the values of a raster make an intensity.
enum class IntensityScale
{
  Relative = 0, ///< proportional to the values: their mean stands for the intensity of the process
  Absolute = 1, ///< the values themselves [1/m2], in place of the intensity of the process
};

/// An intensity that is constant on each cell of a grid. Cell (i, j) is about the point Center + (i, j) * Spacing, and
/// there is none outside.
struct IntensityRaster
{
  std::array<double, 2> Center{ 0.0, 0.0 };  ///< [m], of cell (0, 0)
  std::array<double, 2> Spacing{ 1.0, 1.0 }; ///< [m], positive
  std::array<int, 2> Count{ 0, 0 };
  std::vector<double> Values; ///< not negative, x fastest
  IntensityScale Scale = IntensityScale::Relative;

  /// The index of the cell of a place, or -1 outside.
  long long CellOf(double x, double y) const;

  double Mean() const;
  double Highest() const;
};

/// Why a raster makes no intensity, in words for a user; empty when it does.
std::string WhyInvalid(const IntensityRaster& raster);

/// A raster as factors of the intensity of a process, from 0 up to the highest; without one the factor is 1 everywhere.
class IntensityFactor
{
public:
  IntensityFactor() = default;

  /// The values over their mean. The raster must be valid, and must outlive this.
  explicit IntensityFactor(const IntensityRaster& raster);

  bool IsOne() const { return !this->Raster; }

  double Highest() const { return this->Maximum; }

  /// The share of the points of the highest intensity that stay at a place.
  double ShareAt(double x, double y) const
  {
    if (!this->Raster)
    {
      return 1.0;
    }
    const long long cell = this->Raster->CellOf(x, y);
    return cell < 0 ? 0.0 : this->Raster->Values[static_cast<std::size_t>(cell)] * this->OverHighest;
  }

private:
  const IntensityRaster* Raster = nullptr;
  double Maximum = 1.0;
  double OverHighest = 1.0;
};

}

#endif
