// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPeriodFourier_h
#define LittoralPeriodFourier_h

#include <complex>
#include <memory>
#include <vector>

namespace littoral
{

/**
 * The discrete Fourier transform of one line of any length, in double precision and without scaling. Lengths with other
 * primes than 2, 3 and 5 go through a convolution with a chirp (Bluestein 1970), so that none takes long. Many threads
 * can use one.
 */
class PeriodFourier
{
public:
  using Line = std::vector<std::complex<double>>;

  explicit PeriodFourier(int length);
  ~PeriodFourier();

  int GetLength() const { return this->Length; }

  /// X_k = sum of x_n exp(-2 pi i k n / length).
  Line Forward(const Line& line) const;
  /// x_n = sum of X_k exp(2 pi i k n / length).
  Line Backward(const Line& line) const;

private:
  struct Plans;

  int Length;
  std::unique_ptr<const Plans> Own;
  Line Chirp;         ///< exp(pi i n^2 / length); empty where there is no need of it
  Line ChirpSpectrum; ///< of the padded chirp, over its length
};

}

#endif
