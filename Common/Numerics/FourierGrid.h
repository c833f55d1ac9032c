// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFourierGrid_h
#define LittoralFourierGrid_h

#include "Numerics/Parallel.h"

#include <complex>
#include <cstddef>
#include <vector>

namespace littoral
{

/// The smallest product of 2, 3 and 5 that is not below the given size: lengths that transform fast.
int NextFastLength(int size);

/**
 * A complex grid, x fastest, and its discrete Fourier transform in place, without any scaling: forward then backward
 * multiplies by the number of values. The result does not depend on the threads.
 */
class FourierGrid
{
public:
  FourierGrid(int width, int height);

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  std::complex<double>& At(int i, int j) { return this->Values[static_cast<std::size_t>(j) * this->Width + i]; }
  const std::complex<double>& At(int i, int j) const
  {
    return this->Values[static_cast<std::size_t>(j) * this->Width + i];
  }

  void Forward(const ParallelFor& parallel = SerialFor) { this->Transform(false, parallel); }
  void Backward(const ParallelFor& parallel = SerialFor) { this->Transform(true, parallel); }

private:
  void Transform(bool backward, const ParallelFor& parallel);

  int Width;
  int Height;
  std::vector<std::complex<double>> Values;
};

}

#endif
