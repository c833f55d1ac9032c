// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLineFourier_h
#define LittoralLineFourier_h

#include <cstddef>
#include <memory>
#include <vector>

namespace littoral
{

class FftwLines;

/// Who transforms.
enum class FourierEngine
{
  Own,
  Fftw, ///< for long lines; Own for short ones, and where Littoral was built without it
};

/// Whether Littoral was built with FFTW.
bool HasFftw();

/// FFTW where Littoral was built with it.
FourierEngine UsualFourierEngine();

/// Lines that are transformed side by side: one in each lane of the processor's vectors.
inline constexpr int FourierLanes = 8;

/// Complex values of FourierLanes lines, value by value: number k of a line is at k * FourierLanes + lane.
template <typename Real>
struct LinePackOf
{
  explicit LinePackOf(std::size_t length)
    : Re(length * FourierLanes)
    , Im(length * FourierLanes)
    , WorkRe(length * FourierLanes)
    , WorkIm(length * FourierLanes)
  {
  }

  std::vector<Real> Re;
  std::vector<Real> Im;
  std::vector<Real> WorkRe; ///< room to work in
  std::vector<Real> WorkIm;
};
using LinePack = LinePackOf<float>;
using DoubleLinePack = LinePackOf<double>;

/**
 * The discrete Fourier transform with the exponent +i, without scaling, of lines of one length, in single or double
 * precision. Many short lines are what a wind field or a grid consists of; side by side they keep the vectors of any
 * processor full, which a library that takes line after line does not.
 */
template <typename Real>
class LineFourierOf
{
public:
  /// The length must be a product of 2, 3 and 5. Double precision has its own engine only.
  explicit LineFourierOf(int length, FourierEngine engine = UsualFourierEngine());

  int GetLength() const { return this->Length; }

  /// Replaces each line of the pack by its transform.
  void Backward(LinePackOf<Real>& pack) const;

private:
  struct Stage
  {
    int Radix;
    int Cofactor;            ///< length of the transforms that remain after it
    std::vector<Real> Turns; ///< Radix - 1 factors (real, imaginary) for each of Rest
  };

  int Length;
  std::vector<Stage> Stages;
  std::shared_ptr<const FftwLines> Fftw; ///< null: own stages
};
extern template class LineFourierOf<float>;
extern template class LineFourierOf<double>;
using LineFourier = LineFourierOf<float>;
using DoubleLineFourier = LineFourierOf<double>;

/**
 * Real lines of an even length from their half spectra: x_n = sum over all k of X_k exp(2 pi i k n / length), where X
 * beyond the middle is the conjugate.
 */
class RealLineFourier
{
public:
  /// The length must be even and a product of 2, 3 and 5.
  explicit RealLineFourier(int length, FourierEngine engine = UsualFourierEngine());

  int GetLength() const { return 2 * this->Half.GetLength(); }

  /**
   * The pack holds X_0 ... X_(length / 2), of which the first and the last must be real, and needs room for one value
   * more than half the length. After it Re holds the even samples, Im the odd ones.
   */
  void Backward(LinePack& pack) const;

  /// The other way: from the even samples in Re and the odd ones in Im to X_0 ... X_(length / 2), times the length.
  void Forward(LinePack& pack) const;

private:
  LineFourier Half;
  std::vector<float> Turns; ///< exp(2 pi i k / length): real, imaginary
};

}

#endif
