// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralExpectedVariogram_h
#define LittoralExpectedVariogram_h

#include "Terrain/Variogram.h"

#include <array>
#include <vector>

namespace littoral
{

class DetrendedWindow;

/**
 * Expected semivariance of a field in classes of lags: its own, or that of the residual where a trend was removed from
 * a window. Both are linear in the field's semivariance, so that a change of the field is shown by the same sums.
 */
class ExpectedVariogram
{
public:
  /// Window: null where the lags are those of the field itself. Directions: sectors of the classes.
  ExpectedVariogram(const std::vector<LagBin>& bins, const DetrendedWindow* window, int directions);

  /// Separations (x, y) [m] at which the field's semivariance is wanted: those of the lags, then those of the window.
  const std::vector<std::array<double, 2>>& GetSeparations() const { return this->Separations; }

  /// A field, or a change of one.
  struct Field
  {
    std::vector<double> Semivariances; ///< at the separations, nugget apart
    double Variance = 0.0;
    double Nugget = 0.0;
  };

  /// Field as the lags and the window show it.
  struct View
  {
    std::vector<double> Semivariances; ///< in the lags
    double Variance = 0.0;             ///< in the window
  };
  std::vector<View> Of(const std::vector<Field>& fields) const;

private:
  void AddChange(const std::vector<std::vector<double>>& cellMeans, std::vector<View>& views) const;

  std::vector<std::array<double, 2>> Separations;
  const DetrendedWindow* Window;
  std::size_t NumberOfBins;
  std::vector<double> Change; ///< of a block of bins by each lag of cells, block by block
};

}

#endif
