// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCanopyProfile_h
#define LittoralCanopyProfile_h

#include <vector>

namespace littoral
{

/**
 * Leaf area density over the height of a tree or a stand (Lalic and Mihailovic 2004, J. Appl. Meteorol. 43), as a share
 * of the leaf area below a height:
 *
 *   L(z) = L_m ((h - z_m) / (h - z))^n exp(n (1 - (h - z_m) / (h - z))), n = 6 below z_m and 0.5 above it,
 *
 * h being the height and z_m that of the largest density L_m.
 */
class CanopyProfile
{
public:
  /// z_m / h, between 0 and 1.
  explicit CanopyProfile(double maximum);

  /// L / L_m at z / h; 0 outside of 0 to 1.
  double Density(double height) const;

  /// LAI / (L_m h), the integral of Density().
  double Integral() const { return this->Below.back(); }

  /// Share of the leaf area below z / h, from 0 to 1.
  double ShareBelow(double height) const;

  /// Mean of z / h over the leaf area.
  double MeanHeight() const;

private:
  double Maximum;
  std::vector<double> Below; ///< integrals up to equally spaced heights
};

/// z_m / h of the profile whose leaves have a mean of z / h, from 0.05 to 0.95.
double MaximumOfMean(double meanHeight);

}

#endif
