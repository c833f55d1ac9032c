// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/FftwLines.h"

#include <fftw3.h>

#include <algorithm>
#include <mutex>
#include <vector>

namespace littoral
{

namespace
{

/// FFTW makes one plan at a time.
std::mutex& Planner()
{
  static std::mutex mutex;
  return mutex;
}

/// Real and imaginary parts, in and out, in one block: a plan holds for arrays at the same distances alone.
struct Block
{
  explicit Block(std::size_t values)
    : Numbers(4 * values)
    , Re(Numbers.data())
    , Im(Re + values)
    , OutRe(Im + values)
    , OutIm(OutRe + values)
  {
  }

  std::vector<float> Numbers;
  float* Re;
  float* Im;
  float* OutRe;
  float* OutIm;
};

}

FftwLines::FftwLines(int length)
  : Values(static_cast<std::size_t>(length) * FourierLanes)
{
  const std::lock_guard<std::mutex> guard(Planner());
  const fftwf_iodim along{ length, FourierLanes, FourierLanes };
  const fftwf_iodim lanes{ FourierLanes, 1, 1 };
  const Block block(this->Values);
  // Split arrays go with the exponent -i; +i is the same with real and imaginary parts exchanged.
  this->Plan = fftwf_plan_guru_split_dft(
    1, &along, 1, &lanes, block.Im, block.Re, block.OutIm, block.OutRe, FFTW_ESTIMATE | FFTW_UNALIGNED);
}

FftwLines::~FftwLines()
{
  const std::lock_guard<std::mutex> guard(Planner());
  fftwf_destroy_plan(static_cast<fftwf_plan>(this->Plan));
}

void FftwLines::Backward(LinePack& pack) const
{
  thread_local Block block(0);
  if (block.Numbers.size() != 4 * this->Values)
  {
    block = Block(this->Values);
  }
  std::copy_n(pack.Re.begin(), this->Values, block.Re);
  std::copy_n(pack.Im.begin(), this->Values, block.Im);
  fftwf_execute_split_dft(static_cast<fftwf_plan>(this->Plan), block.Im, block.Re, block.OutIm, block.OutRe);
  std::copy_n(block.OutRe, this->Values, pack.Re.begin());
  std::copy_n(block.OutIm, this->Values, pack.Im.begin());
}

}
