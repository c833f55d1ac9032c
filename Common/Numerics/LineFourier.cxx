// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/LineFourier.h"

#include "Numerics/Constants.h"
#include "Numerics/SimdClones.h"
#ifdef LITTORAL_WITH_FFTW
#include "Numerics/FftwLines.h"
#endif

#include <algorithm>
#include <cmath>
#include <functional>

namespace littoral
{

namespace
{
#ifdef LITTORAL_WITH_FFTW
/// Shorter lines take longer to copy there and back than FFTW saves.
constexpr int ShortestForFftw = 256;
#endif

constexpr float Sin60 = 0.86602540378443864676f;
constexpr float Cos72 = 0.30901699437494742410f;
constexpr float Sin72 = 0.95105651629515357212f;
constexpr float Cos144 = -0.80901699437494742410f;
constexpr float Sin144 = 0.58778525229247312917f;

/// Where a stage reads (Radix values, a step apart) and writes (the same, one after the other), and its turns.
struct Butterfly
{
  const float* __restrict Re;
  const float* __restrict Im;
  float* __restrict ToRe;
  float* __restrict ToIm;
  std::size_t Step;  ///< between values read
  std::size_t Count; ///< of numbers side by side
  const float* Turn; ///< real, imaginary of w, w^2, ...
};

LITTORAL_SIMD_CLONES void Butterfly2(const Butterfly& b)
{
  const float* __restrict re = b.Re;
  const float* __restrict im = b.Im;
  float* __restrict toRe = b.ToRe;
  float* __restrict toIm = b.ToIm;
  const std::size_t step = b.Step;
  const std::size_t count = b.Count;
  const float c1 = b.Turn[0];
  const float s1 = b.Turn[1];
  for (std::size_t n = 0; n < count; ++n)
  {
    const float dr = re[n] - re[n + step];
    const float di = im[n] - im[n + step];
    toRe[n] = re[n] + re[n + step];
    toIm[n] = im[n] + im[n + step];
    toRe[n + count] = c1 * dr - s1 * di;
    toIm[n + count] = c1 * di + s1 * dr;
  }
}

LITTORAL_SIMD_CLONES void Butterfly3(const Butterfly& b)
{
  const float* __restrict re = b.Re;
  const float* __restrict im = b.Im;
  float* __restrict toRe = b.ToRe;
  float* __restrict toIm = b.ToIm;
  const std::size_t step = b.Step;
  const std::size_t count = b.Count;
  const float c1 = b.Turn[0];
  const float s1 = b.Turn[1];
  const float c2 = b.Turn[2];
  const float s2 = b.Turn[3];
  for (std::size_t n = 0; n < count; ++n)
  {
    const float sumRe = re[n + step] + re[n + 2 * step];
    const float sumIm = im[n + step] + im[n + 2 * step];
    const float midRe = re[n] - 0.5f * sumRe;
    const float midIm = im[n] - 0.5f * sumIm;
    const float offRe = -Sin60 * (im[n + step] - im[n + 2 * step]);
    const float offIm = Sin60 * (re[n + step] - re[n + 2 * step]);
    const float r1 = midRe + offRe;
    const float i1 = midIm + offIm;
    const float r2 = midRe - offRe;
    const float i2 = midIm - offIm;
    toRe[n] = re[n] + sumRe;
    toIm[n] = im[n] + sumIm;
    toRe[n + count] = c1 * r1 - s1 * i1;
    toIm[n + count] = c1 * i1 + s1 * r1;
    toRe[n + 2 * count] = c2 * r2 - s2 * i2;
    toIm[n + 2 * count] = c2 * i2 + s2 * r2;
  }
}

LITTORAL_SIMD_CLONES void Butterfly4(const Butterfly& b)
{
  const float* __restrict re = b.Re;
  const float* __restrict im = b.Im;
  float* __restrict toRe = b.ToRe;
  float* __restrict toIm = b.ToIm;
  const std::size_t step = b.Step;
  const std::size_t count = b.Count;
  const float c1 = b.Turn[0];
  const float s1 = b.Turn[1];
  const float c2 = b.Turn[2];
  const float s2 = b.Turn[3];
  const float c3 = b.Turn[4];
  const float s3 = b.Turn[5];
  for (std::size_t n = 0; n < count; ++n)
  {
    const float aRe = re[n] + re[n + 2 * step];
    const float aIm = im[n] + im[n + 2 * step];
    const float bRe = re[n] - re[n + 2 * step];
    const float bIm = im[n] - im[n + 2 * step];
    const float cRe = re[n + step] + re[n + 3 * step];
    const float cIm = im[n + step] + im[n + 3 * step];
    const float dRe = re[n + step] - re[n + 3 * step];
    const float dIm = im[n + step] - im[n + 3 * step];
    const float r1 = bRe - dIm;
    const float i1 = bIm + dRe;
    const float r2 = aRe - cRe;
    const float i2 = aIm - cIm;
    const float r3 = bRe + dIm;
    const float i3 = bIm - dRe;
    toRe[n] = aRe + cRe;
    toIm[n] = aIm + cIm;
    toRe[n + count] = c1 * r1 - s1 * i1;
    toIm[n + count] = c1 * i1 + s1 * r1;
    toRe[n + 2 * count] = c2 * r2 - s2 * i2;
    toIm[n + 2 * count] = c2 * i2 + s2 * r2;
    toRe[n + 3 * count] = c3 * r3 - s3 * i3;
    toIm[n + 3 * count] = c3 * i3 + s3 * r3;
  }
}

LITTORAL_SIMD_CLONES void Butterfly5(const Butterfly& b)
{
  const float* __restrict re = b.Re;
  const float* __restrict im = b.Im;
  float* __restrict toRe = b.ToRe;
  float* __restrict toIm = b.ToIm;
  const std::size_t step = b.Step;
  const std::size_t count = b.Count;
  float c[5];
  float s[5];
  for (int power = 1; power < 5; ++power)
  {
    c[power] = b.Turn[2 * power - 2];
    s[power] = b.Turn[2 * power - 1];
  }
  for (std::size_t n = 0; n < count; ++n)
  {
    const float sum1Re = re[n + step] + re[n + 4 * step];
    const float sum1Im = im[n + step] + im[n + 4 * step];
    const float sum2Re = re[n + 2 * step] + re[n + 3 * step];
    const float sum2Im = im[n + 2 * step] + im[n + 3 * step];
    const float dif1Re = re[n + step] - re[n + 4 * step];
    const float dif1Im = im[n + step] - im[n + 4 * step];
    const float dif2Re = re[n + 2 * step] - re[n + 3 * step];
    const float dif2Im = im[n + 2 * step] - im[n + 3 * step];
    const float mid1Re = re[n] + Cos72 * sum1Re + Cos144 * sum2Re;
    const float mid1Im = im[n] + Cos72 * sum1Im + Cos144 * sum2Im;
    const float mid2Re = re[n] + Cos144 * sum1Re + Cos72 * sum2Re;
    const float mid2Im = im[n] + Cos144 * sum1Im + Cos72 * sum2Im;
    const float off1Re = -(Sin72 * dif1Im + Sin144 * dif2Im);
    const float off1Im = Sin72 * dif1Re + Sin144 * dif2Re;
    const float off2Re = -(Sin144 * dif1Im - Sin72 * dif2Im);
    const float off2Im = Sin144 * dif1Re - Sin72 * dif2Re;
    const float r1 = mid1Re + off1Re;
    const float i1 = mid1Im + off1Im;
    const float r2 = mid2Re + off2Re;
    const float i2 = mid2Im + off2Im;
    const float r3 = mid2Re - off2Re;
    const float i3 = mid2Im - off2Im;
    const float r4 = mid1Re - off1Re;
    const float i4 = mid1Im - off1Im;
    toRe[n] = re[n] + sum1Re + sum2Re;
    toIm[n] = im[n] + sum1Im + sum2Im;
    toRe[n + count] = c[1] * r1 - s[1] * i1;
    toIm[n + count] = c[1] * i1 + s[1] * r1;
    toRe[n + 2 * count] = c[2] * r2 - s[2] * i2;
    toIm[n + 2 * count] = c[2] * i2 + s[2] * r2;
    toRe[n + 3 * count] = c[3] * r3 - s[3] * i3;
    toIm[n + 3 * count] = c[3] * i3 + s[3] * r3;
    toRe[n + 4 * count] = c[4] * r4 - s[4] * i4;
    toIm[n + 4 * count] = c[4] * i4 + s[4] * r4;
  }
}

void Run(int radix, const Butterfly& b)
{
  switch (radix)
  {
    case 2:
      return Butterfly2(b);
    case 3:
      return Butterfly3(b);
    case 4:
      return Butterfly4(b);
    default:
      return Butterfly5(b);
  }
}

/// Joins the two halves of a real line's spectrum: sum is X_k + X_(k + half), dif their difference, turned.
LITTORAL_SIMD_CLONES void FoldHalves(LinePack& pack, std::size_t half, const float* turns)
{
  for (std::size_t k = 0; k < half; ++k)
  {
    const float* re = &pack.Re[k * FourierLanes];
    const float* im = &pack.Im[k * FourierLanes];
    const float* otherRe = &pack.Re[(half - k) * FourierLanes];
    const float* otherIm = &pack.Im[(half - k) * FourierLanes];
    float* toRe = &pack.WorkRe[k * FourierLanes];
    float* toIm = &pack.WorkIm[k * FourierLanes];
    const float c = turns[2 * k];
    const float s = turns[2 * k + 1];
    for (int lane = 0; lane < FourierLanes; ++lane)
    {
      const float difRe = re[lane] - otherRe[lane];
      const float difIm = im[lane] + otherIm[lane];
      toRe[lane] = re[lane] + otherRe[lane] - (c * difIm + s * difRe);
      toIm[lane] = im[lane] - otherIm[lane] + (c * difRe - s * difIm);
    }
  }
}

/// Parts the transform Z of pairs, given as its conjugate, into the half spectrum of the real line:
/// 2 X_k = Z_k + conj Z_(half - k) - i exp(-2 pi i k / length) (Z_k - conj Z_(half - k)).
LITTORAL_SIMD_CLONES void PartHalves(LinePack& pack, std::size_t half, const float* turns)
{
  for (std::size_t k = 0; k <= half; ++k)
  {
    const std::size_t own = k < half ? k : 0;
    const std::size_t other = k > 0 ? half - k : 0;
    const float* re = &pack.Re[own * FourierLanes];
    const float* im = &pack.Im[own * FourierLanes];
    const float* otherRe = &pack.Re[other * FourierLanes];
    const float* otherIm = &pack.Im[other * FourierLanes];
    float* toRe = &pack.WorkRe[k * FourierLanes];
    float* toIm = &pack.WorkIm[k * FourierLanes];
    const float c = k < half ? turns[2 * k] : -1.0f;
    const float s = k < half ? turns[2 * k + 1] : 0.0f;
    for (int lane = 0; lane < FourierLanes; ++lane)
    {
      const float difRe = re[lane] - otherRe[lane];
      const float difIm = -im[lane] - otherIm[lane];
      toRe[lane] = 0.5f * (re[lane] + otherRe[lane] + (c * difIm - s * difRe));
      toIm[lane] = 0.5f * (otherIm[lane] - im[lane] - (c * difRe + s * difIm));
    }
  }
}
}

bool HasFftw()
{
#ifdef LITTORAL_WITH_FFTW
  return true;
#else
  return false;
#endif
}

FourierEngine UsualFourierEngine()
{
  return HasFftw() ? FourierEngine::Fftw : FourierEngine::Own;
}

LineFourier::LineFourier(int length, [[maybe_unused]] FourierEngine engine)
  : Length(length)
{
#ifdef LITTORAL_WITH_FFTW
  if (engine == FourierEngine::Fftw && length >= ShortestForFftw)
  {
    this->Fftw = std::make_shared<FftwLines>(length);
    return;
  }
#endif
  int cofactor = length;
  for (int radix : { 4, 2, 3, 5 })
  {
    while (cofactor % radix == 0 && cofactor > 1)
    {
      Stage stage{ radix, cofactor / radix, {} };
      for (int j = 0; j < stage.Cofactor; ++j)
      {
        for (int power = 1; power < radix; ++power)
        {
          const double angle = TwoPi * (static_cast<double>(j) * power / cofactor);
          stage.Turns.push_back(static_cast<float>(std::cos(angle)));
          stage.Turns.push_back(static_cast<float>(std::sin(angle)));
        }
      }
      cofactor = stage.Cofactor;
      this->Stages.push_back(std::move(stage));
    }
  }
}

void LineFourier::Backward(LinePack& pack) const
{
#ifdef LITTORAL_WITH_FFTW
  if (this->Fftw)
  {
    this->Fftw->Backward(pack);
    return;
  }
#endif
  std::size_t done = FourierLanes; // numbers side by side that the same turn belongs to
  for (const Stage& stage : this->Stages)
  {
    const std::size_t turns = 2 * (static_cast<std::size_t>(stage.Radix) - 1);
    for (std::size_t j = 0; j < static_cast<std::size_t>(stage.Cofactor); ++j)
    {
      const std::size_t from = done * j;
      const std::size_t to = from * stage.Radix;
      Run(stage.Radix,
        { &pack.Re[from], &pack.Im[from], &pack.WorkRe[to], &pack.WorkIm[to], done * stage.Cofactor, done,
          &stage.Turns[turns * j] });
    }
    pack.Re.swap(pack.WorkRe);
    pack.Im.swap(pack.WorkIm);
    done *= stage.Radix;
  }
}

RealLineFourier::RealLineFourier(int length, FourierEngine engine)
  : Half(length / 2, engine)
  , Turns(static_cast<std::size_t>(length))
{
  for (int k = 0; k < length / 2; ++k)
  {
    const double angle = TwoPi * k / length;
    this->Turns[2 * k] = static_cast<float>(std::cos(angle));
    this->Turns[2 * k + 1] = static_cast<float>(std::sin(angle));
  }
}

void RealLineFourier::Backward(LinePack& pack) const
{
  FoldHalves(pack, this->Half.GetLength(), this->Turns.data());
  pack.Re.swap(pack.WorkRe);
  pack.Im.swap(pack.WorkIm);
  this->Half.Backward(pack);
}

void RealLineFourier::Forward(LinePack& pack) const
{
  // The transform with the exponent -i is the conjugate of that of the conjugate.
  std::transform(pack.Im.begin(), pack.Im.end(), pack.Im.begin(), std::negate<float>());
  this->Half.Backward(pack);
  PartHalves(pack, this->Half.GetLength(), this->Turns.data());
  pack.Re.swap(pack.WorkRe);
  pack.Im.swap(pack.WorkIm);
}

}
