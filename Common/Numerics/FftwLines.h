// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFftwLines_h
#define LittoralFftwLines_h

#include "Numerics/LineFourier.h"

namespace littoral
{

/// The one place that knows FFTW. It is there with the build option LITTORAL_WITH_FFTW alone; FFTW is under the GPL, so
/// that what is linked with it may be given away under the GPL only.
class FftwLines
{
public:
  /// Plans are made without measurements, so that each run takes the same way and gives the same bytes.
  explicit FftwLines(int length);
  ~FftwLines();
  FftwLines(const FftwLines&) = delete;
  FftwLines& operator=(const FftwLines&) = delete;

  /// As LineFourier's. Any number of threads may call it.
  void Backward(LinePack& pack) const;

private:
  std::size_t Values; // in a pack
  void* Plan;
};

}

#endif
