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
#include <type_traits>

namespace littoral
{

namespace
{
#ifdef LITTORAL_WITH_FFTW
/// Shorter lines take longer to copy there and back than FFTW saves.
constexpr int ShortestForFftw = 256;
#endif

constexpr double Sin60 = 0.86602540378443864676;
constexpr double Cos72 = 0.30901699437494742410;
constexpr double Sin72 = 0.95105651629515357212;
constexpr double Cos144 = -0.80901699437494742410;
constexpr double Sin144 = 0.58778525229247312917;

/// Reads (Radix values, a step apart) and writes (as many, one after the other) of a stage, and its turns.
template <typename Real>
struct Butterfly
{
  const Real* __restrict Re;
  const Real* __restrict Im;
  Real* __restrict ToRe;
  Real* __restrict ToIm;
  std::size_t Step;  ///< between values read
  std::size_t Count; ///< of numbers side by side
  const Real* Turn;  ///< real, imaginary of w, w^2, ...
};

template <typename Real>
LITTORAL_INLINE void Butterfly2(const Butterfly<Real>& b)
{
  const Real* __restrict re = b.Re;
  const Real* __restrict im = b.Im;
  Real* __restrict toRe = b.ToRe;
  Real* __restrict toIm = b.ToIm;
  const std::size_t step = b.Step;
  const std::size_t count = b.Count;
  const Real c1 = b.Turn[0];
  const Real s1 = b.Turn[1];
  LITTORAL_INDEPENDENT
  for (std::size_t n = 0; n < count; ++n)
  {
    const Real dr = re[n] - re[n + step];
    const Real di = im[n] - im[n + step];
    toRe[n] = re[n] + re[n + step];
    toIm[n] = im[n] + im[n + step];
    toRe[n + count] = c1 * dr - s1 * di;
    toIm[n + count] = c1 * di + s1 * dr;
  }
}

template <typename Real>
LITTORAL_INLINE void Butterfly3(const Butterfly<Real>& b)
{
  const Real* __restrict re = b.Re;
  const Real* __restrict im = b.Im;
  Real* __restrict toRe = b.ToRe;
  Real* __restrict toIm = b.ToIm;
  const std::size_t step = b.Step;
  const std::size_t count = b.Count;
  const Real c1 = b.Turn[0];
  const Real s1 = b.Turn[1];
  const Real c2 = b.Turn[2];
  const Real s2 = b.Turn[3];
  constexpr auto sin60 = static_cast<Real>(Sin60);
  LITTORAL_INDEPENDENT
  for (std::size_t n = 0; n < count; ++n)
  {
    const Real sumRe = re[n + step] + re[n + 2 * step];
    const Real sumIm = im[n + step] + im[n + 2 * step];
    const Real midRe = re[n] - Real(0.5) * sumRe;
    const Real midIm = im[n] - Real(0.5) * sumIm;
    const Real offRe = -sin60 * (im[n + step] - im[n + 2 * step]);
    const Real offIm = sin60 * (re[n + step] - re[n + 2 * step]);
    const Real r1 = midRe + offRe;
    const Real i1 = midIm + offIm;
    const Real r2 = midRe - offRe;
    const Real i2 = midIm - offIm;
    toRe[n] = re[n] + sumRe;
    toIm[n] = im[n] + sumIm;
    toRe[n + count] = c1 * r1 - s1 * i1;
    toIm[n + count] = c1 * i1 + s1 * r1;
    toRe[n + 2 * count] = c2 * r2 - s2 * i2;
    toIm[n + 2 * count] = c2 * i2 + s2 * r2;
  }
}

template <typename Real>
LITTORAL_INLINE void Butterfly4(const Butterfly<Real>& b)
{
  const Real* __restrict re = b.Re;
  const Real* __restrict im = b.Im;
  Real* __restrict toRe = b.ToRe;
  Real* __restrict toIm = b.ToIm;
  const std::size_t step = b.Step;
  const std::size_t count = b.Count;
  const Real c1 = b.Turn[0];
  const Real s1 = b.Turn[1];
  const Real c2 = b.Turn[2];
  const Real s2 = b.Turn[3];
  const Real c3 = b.Turn[4];
  const Real s3 = b.Turn[5];
  LITTORAL_INDEPENDENT
  for (std::size_t n = 0; n < count; ++n)
  {
    const Real aRe = re[n] + re[n + 2 * step];
    const Real aIm = im[n] + im[n + 2 * step];
    const Real bRe = re[n] - re[n + 2 * step];
    const Real bIm = im[n] - im[n + 2 * step];
    const Real cRe = re[n + step] + re[n + 3 * step];
    const Real cIm = im[n + step] + im[n + 3 * step];
    const Real dRe = re[n + step] - re[n + 3 * step];
    const Real dIm = im[n + step] - im[n + 3 * step];
    const Real r1 = bRe - dIm;
    const Real i1 = bIm + dRe;
    const Real r2 = aRe - cRe;
    const Real i2 = aIm - cIm;
    const Real r3 = bRe + dIm;
    const Real i3 = bIm - dRe;
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

template <typename Real>
LITTORAL_INLINE void Butterfly5(const Butterfly<Real>& b)
{
  const Real* __restrict re = b.Re;
  const Real* __restrict im = b.Im;
  Real* __restrict toRe = b.ToRe;
  Real* __restrict toIm = b.ToIm;
  const std::size_t step = b.Step;
  const std::size_t count = b.Count;
  Real c[5];
  Real s[5];
  for (int power = 1; power < 5; ++power)
  {
    c[power] = b.Turn[2 * power - 2];
    s[power] = b.Turn[2 * power - 1];
  }
  constexpr auto cos72 = static_cast<Real>(Cos72);
  constexpr auto sin72 = static_cast<Real>(Sin72);
  constexpr auto cos144 = static_cast<Real>(Cos144);
  constexpr auto sin144 = static_cast<Real>(Sin144);
  LITTORAL_INDEPENDENT
  for (std::size_t n = 0; n < count; ++n)
  {
    const Real sum1Re = re[n + step] + re[n + 4 * step];
    const Real sum1Im = im[n + step] + im[n + 4 * step];
    const Real sum2Re = re[n + 2 * step] + re[n + 3 * step];
    const Real sum2Im = im[n + 2 * step] + im[n + 3 * step];
    const Real dif1Re = re[n + step] - re[n + 4 * step];
    const Real dif1Im = im[n + step] - im[n + 4 * step];
    const Real dif2Re = re[n + 2 * step] - re[n + 3 * step];
    const Real dif2Im = im[n + 2 * step] - im[n + 3 * step];
    const Real mid1Re = re[n] + cos72 * sum1Re + cos144 * sum2Re;
    const Real mid1Im = im[n] + cos72 * sum1Im + cos144 * sum2Im;
    const Real mid2Re = re[n] + cos144 * sum1Re + cos72 * sum2Re;
    const Real mid2Im = im[n] + cos144 * sum1Im + cos72 * sum2Im;
    const Real off1Re = -(sin72 * dif1Im + sin144 * dif2Im);
    const Real off1Im = sin72 * dif1Re + sin144 * dif2Re;
    const Real off2Re = -(sin144 * dif1Im - sin72 * dif2Im);
    const Real off2Im = sin144 * dif1Re - sin72 * dif2Re;
    const Real r1 = mid1Re + off1Re;
    const Real i1 = mid1Im + off1Im;
    const Real r2 = mid2Re + off2Re;
    const Real i2 = mid2Im + off2Im;
    const Real r3 = mid2Re - off2Re;
    const Real i3 = mid2Im - off2Im;
    const Real r4 = mid1Re - off1Re;
    const Real i4 = mid1Im - off1Im;
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

/// A stage of a transform: its butterflies, for each of the turns.
template <typename Real>
struct StageTask
{
  int Radix;
  std::size_t Cofactor;
  std::size_t Done; ///< numbers side by side that the same turn belongs to
  const Real* Turns;
  const Real* Re;
  const Real* Im;
  Real* ToRe;
  Real* ToIm;
};

template <int Radix, typename Real>
LITTORAL_INLINE void RunRadix(const StageTask<Real>& stage)
{
  for (std::size_t j = 0; j < stage.Cofactor; ++j)
  {
    const std::size_t from = stage.Done * j;
    const std::size_t to = from * Radix;
    const Butterfly<Real> butterfly{ stage.Re + from, stage.Im + from, stage.ToRe + to, stage.ToIm + to,
      stage.Done * stage.Cofactor, stage.Done, stage.Turns + 2 * (Radix - 1) * j };
    if constexpr (Radix == 2)
    {
      Butterfly2(butterfly);
    }
    else if constexpr (Radix == 3)
    {
      Butterfly3(butterfly);
    }
    else if constexpr (Radix == 4)
    {
      Butterfly4(butterfly);
    }
    else
    {
      Butterfly5(butterfly);
    }
  }
}

template <typename Real>
LITTORAL_INLINE void RunAnyRadix(const StageTask<Real>& stage)
{
  switch (stage.Radix)
  {
    case 2:
      return RunRadix<2>(stage);
    case 3:
      return RunRadix<3>(stage);
    case 4:
      return RunRadix<4>(stage);
    default:
      return RunRadix<5>(stage);
  }
}

LITTORAL_SIMD_CLONES void RunStage(const StageTask<float>& stage)
{
  RunAnyRadix(stage);
}

LITTORAL_WIDE_SIMD_CLONES void RunStage(const StageTask<double>& stage)
{
  RunAnyRadix(stage);
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

template <typename Real>
LineFourierOf<Real>::LineFourierOf(int length, [[maybe_unused]] FourierEngine engine)
  : Length(length)
{
#ifdef LITTORAL_WITH_FFTW
  if (std::is_same_v<Real, float> && engine == FourierEngine::Fftw && length >= ShortestForFftw)
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
          stage.Turns.push_back(static_cast<Real>(std::cos(angle)));
          stage.Turns.push_back(static_cast<Real>(std::sin(angle)));
        }
      }
      cofactor = stage.Cofactor;
      this->Stages.push_back(std::move(stage));
    }
  }
}

template <typename Real>
void LineFourierOf<Real>::Backward(LinePackOf<Real>& pack) const
{
#ifdef LITTORAL_WITH_FFTW
  if constexpr (std::is_same_v<Real, float>)
  {
    if (this->Fftw)
    {
      this->Fftw->Backward(pack);
      return;
    }
  }
#endif
  std::size_t done = FourierLanes;
  for (const Stage& stage : this->Stages)
  {
    RunStage(StageTask<Real>{ stage.Radix, static_cast<std::size_t>(stage.Cofactor), done, stage.Turns.data(),
      pack.Re.data(), pack.Im.data(), pack.WorkRe.data(), pack.WorkIm.data() });
    pack.Re.swap(pack.WorkRe);
    pack.Im.swap(pack.WorkIm);
    done *= stage.Radix;
  }
}

template class LineFourierOf<float>;
template class LineFourierOf<double>;

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
