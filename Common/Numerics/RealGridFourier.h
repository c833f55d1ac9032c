// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralRealGridFourier_h
#define LittoralRealGridFourier_h

#include "Numerics/LineFourier.h"
#include "Numerics/Parallel.h"

#include <array>
#include <cstddef>
#include <vector>

namespace littoral
{

/**
 * The discrete Fourier transform of a real grid, x fastest, that zeros pad on its far sides; exponent +i, no scaling.
 * The spectrum at (-kx, -ky) is the conjugate of that at (kx, ky), so that the rows ky = 0 ... height / 2 are all of
 * it.
 *
 * Columns are transformed at once, two real ones as one complex line. Rows are transformed when they are asked for, so
 * that a caller who takes them pack by pack never stores their padding. The result does not depend on the threads.
 */
class RealGridFourier
{
public:
  /// The values, size[0] times size[1], may go after this. Padded sizes: products of 2, 3 and 5, not below the size.
  RealGridFourier(const std::vector<double>& values, std::array<int, 2> size, std::array<int, 2> padded,
    const ParallelFor& parallel = SerialFor);

  /// Rows of the half spectrum.
  int NumberOfRows() const { return this->Padded[1] / 2 + 1; }

  /// Packs of FourierLanes rows; lanes beyond the last row hold zeros.
  int NumberOfPacks() const { return (this->NumberOfRows() + FourierLanes - 1) / FourierLanes; }

  /// The spectrum of the rows ky = FourierLanes * pack + lane, at kx = 0 ... padded width - 1.
  void TransformRows(int pack, DoubleLinePack& rows) const;

private:
  void TransformColumns(const std::vector<double>& values, const ParallelFor& parallel);

  std::array<int, 2> Size;
  std::array<int, 2> Padded;
  DoubleLineFourier Along;
  std::size_t Stride;     ///< columns, rounded up to whole packs
  std::vector<double> Re; ///< of the transformed columns, row by row
  std::vector<double> Im;
};

}

#endif
