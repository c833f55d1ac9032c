// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralIntensityRaster_h
#define LittoralIntensityRaster_h

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace littoral
{

/// Scale of the values of an intensity raster.
enum class IntensityScale
{
  Relative = 0, ///< proportional to the values: their mean stands for the intensity of the process
  Absolute = 1, ///< the values themselves [1/m2], in place of the intensity of the process
};

/// Intensity that is constant on each cell of a grid, 0 outside. Cell (i, j) is about the point Center + (i, j) *
/// Spacing.
struct IntensityRaster
{
  std::array<double, 2> Center{ 0.0, 0.0 };  ///< [m], of cell (0, 0)
  std::array<double, 2> Spacing{ 1.0, 1.0 }; ///< [m], positive
  std::array<int, 2> Count{ 0, 0 };
  std::vector<double> Values; ///< not negative, x fastest; NaN: outside too
  IntensityScale Scale = IntensityScale::Relative;

  /// The index of the cell of a place, or -1 outside.
  long long CellOf(double x, double y) const;

  double Mean() const;
  double Highest() const;
};

/// Why a raster makes no intensity, in words for a user; empty when it does.
std::string WhyInvalid(const IntensityRaster& raster);

/// Raster as factors of the intensity of a process, from 0 up to the highest; 1 everywhere without a raster.
class IntensityFactor
{
public:
  IntensityFactor() = default;

  /// The values over their mean. The raster must be valid, and must outlive this.
  explicit IntensityFactor(const IntensityRaster& raster);

  bool IsOne() const { return !this->Raster; }

  double Highest() const { return this->Maximum; }

  /// Retention probability of the thinning at a place, the intensity over the highest one.
  double ShareAt(double x, double y) const
  {
    if (!this->Raster)
    {
      return 1.0;
    }
    const long long cell = this->Raster->CellOf(x, y);
    const double value = cell < 0 ? 0.0 : this->Raster->Values[static_cast<std::size_t>(cell)];
    return std::isnan(value) ? 0.0 : value * this->OverHighest;
  }

private:
  const IntensityRaster* Raster = nullptr;
  double Maximum = 1.0;
  double OverHighest = 1.0;
};

}

#endif
