// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralWindLines_h
#define LittoralWindLines_h

#include "Numerics/LineFourier.h"
#include "Numerics/Parallel.h"
#include "Numerics/PeriodFourier.h"
#include "Numerics/Vector3.h"

#include <array>
#include <complex>
#include <cstddef>
#include <vector>

namespace littoral
{

/**
 * A frozen wind that repeats along x, between its samples, with the variance that it has at them.
 *
 * Along x, which is time, a line is the sum of its waves and is evaluated as such: exact at any place of a line that
 * has no wave of two samples. Across and up, waves of neighbouring lines hardly know of each other where they are
 * short, and a mean of them is too weak. So the complex amplitude of each wave is the bilinear mean of those of the
 * four lines around, brought to the root of the bilinear mean of their powers. The mean wind is bilinear.
 */
class WindLines
{
public:
  /// Velocities of `size` samples, the first index (along x) fastest. Beyond its edges across and up the wind goes on
  /// as there.
  WindLines(const float* velocities, const std::array<int, 3>& size, const ParallelFor& parallel = SerialFor);

  /// `count` velocities at a place [samples], one a step, from the step `first` on: the field goes on by one sample a
  /// step.
  void Sample(const std::array<double, 3>& place, double first, std::size_t count, Vector3* velocities) const;

  /// Memory of it [bytes].
  static double BytesOf(const std::array<int, 3>& size);

private:
  using Wave = std::complex<float>;

  const Wave* WavesOf(int across, int up) const;

  std::array<int, 3> Size;
  int Waves; ///< of a line: none, one, two ... a period
  PeriodFourier Along;
  std::vector<Wave> Spectra; ///< line by line, then component by component
};

/**
 * The place between layers [samples] at which a bilinear mean has what the wind has at a height, where layers begin at
 * `bottom` and are a spacing apart [m]: by the logarithm of the height, as the mean wind near the ground goes, and as
 * fast gusts nearly do. By the height itself where a layer is not above the ground.
 */
double LayerPlace(double height, double bottom, double spacing);

/// Lines of a wind as it is a part of a sample later, by the sums of their waves.
class WindCarrier
{
public:
  /// The length of a line must be even and a product of 2, 3 and 5.
  explicit WindCarrier(int length);

  /// Room for one thread, with FourierLanes lines in it.
  struct Room
  {
    explicit Room(int length)
      : Pack(static_cast<std::size_t>(length) / 2 + 1)
      , Velocities(static_cast<std::size_t>(FourierLanes) * 3 * length)
    {
    }

    LinePack Pack;
    std::vector<float> Velocities; ///< line by line
  };

  /// Takes `count` lines of velocities that lie side by side from the first on.
  void Carry(const float* first, int count, double part, Room& room) const;

private:
  RealLineFourier Along;
};

}

#endif
