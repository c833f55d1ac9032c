// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The transforms of the wind against double precision, their definition, and FFTW.
#include "Numerics/LineFourier.h"
#include "Numerics/PeriodFourier.h"

#include <gtest/gtest.h>

#include <kissfft/kissfft.hh>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <vector>

using namespace littoral;

namespace
{

void AgreesWithDoublePrecision(FourierEngine engine)
{
  for (int length : { 1, 2, 3, 4, 5, 6, 30, 64, 90, 128, 6000 })
  {
    LinePack pack(length);
    kissfft<double> reference(length, true);
    std::vector<std::complex<double>> line(length);
    std::vector<std::complex<double>> wants(length);
    for (int k = 0; k < length; ++k)
    {
      for (int lane = 0; lane < FourierLanes; ++lane)
      {
        pack.Re[k * FourierLanes + lane] = static_cast<float>(std::sin(1.0 + k * k + lane));
        pack.Im[k * FourierLanes + lane] = static_cast<float>(std::cos(3.0 * k + 2.0 * lane));
      }
      line[k] = { pack.Re[k * FourierLanes + 5], pack.Im[k * FourierLanes + 5] };
    }
    if (length == 1)
    {
      wants = line;
    }
    else
    {
      reference.transform(line.data(), wants.data());
    }
    LineFourier(length, engine).Backward(pack);
    double worst = 0.0;
    for (int k = 0; k < length; ++k)
    {
      const std::complex<double> has{ pack.Re[k * FourierLanes + 5], pack.Im[k * FourierLanes + 5] };
      worst = std::max(worst, std::abs(has - wants[k]));
    }
    EXPECT_LT(worst / std::sqrt(length), engine == FourierEngine::Own ? 2e-6 : 3e-6) << length;
  }
}

}

TEST(LineFourier, AgreesWithDoublePrecision)
{
  AgreesWithDoublePrecision(FourierEngine::Own);
}

TEST(LineFourier, InDoublePrecisionAgreesWithKissfft)
{
  for (int length : { 2, 3, 5, 16, 90, 1536 })
  {
    DoubleLinePack pack(length);
    std::vector<std::complex<double>> line(length);
    std::vector<std::complex<double>> wants(length);
    for (int k = 0; k < length; ++k)
    {
      for (int lane = 0; lane < FourierLanes; ++lane)
      {
        pack.Re[k * FourierLanes + lane] = std::sin(1.0 + k * k + lane);
        pack.Im[k * FourierLanes + lane] = std::cos(3.0 * k + 2.0 * lane);
      }
      line[k] = { pack.Re[k * FourierLanes + 5], pack.Im[k * FourierLanes + 5] };
    }
    kissfft<double>(length, true).transform(line.data(), wants.data());
    DoubleLineFourier fourier(length);
    fourier.Backward(pack);
    for (int k = 0; k < length; ++k)
    {
      const std::complex<double> has{ pack.Re[k * FourierLanes + 5], pack.Im[k * FourierLanes + 5] };
      EXPECT_LT(std::abs(has - wants[k]) / std::sqrt(length), 1e-14) << length << ", " << k;
    }
  }
}

TEST(LineFourier, ForwardUndoesBackward)
{
  for (int length : { 4, 6, 30, 600, 6000 })
  {
    const RealLineFourier fourier(length);
    LinePack pack(length / 2 + 1);
    std::vector<double> samples(length);
    for (int n = 0; n < length; ++n)
    {
      samples[n] = std::sin(1.0 + 0.1 * n * n);
      for (int lane = 0; lane < FourierLanes; ++lane)
      {
        std::vector<float>& part = n % 2 == 0 ? pack.Re : pack.Im;
        part[n / 2 * FourierLanes + lane] = static_cast<float>((lane + 1) * samples[n]);
      }
    }
    const LinePack start = pack;
    fourier.Forward(pack);
    // By definition, at some frequencies: the first, the second, one in the middle, the last.
    for (int k : { 0, 1, length / 3, length / 2 })
    {
      std::complex<double> wants(0.0);
      for (int n = 0; n < length; ++n)
      {
        wants += samples[n] * std::polar(1.0, -2.0 * std::acos(-1.0) * k * n / length);
      }
      const std::complex<double> has{ pack.Re[k * FourierLanes + 1], pack.Im[k * FourierLanes + 1] };
      EXPECT_LT(std::abs(has - 2.0 * wants) / std::sqrt(length), 4e-6) << length << ", " << k;
    }
    fourier.Backward(pack);
    for (std::size_t n = 0; n < static_cast<std::size_t>(length / 2 * FourierLanes); ++n)
    {
      ASSERT_NEAR(pack.Re[n] / static_cast<float>(length), start.Re[n], 8e-6);
      ASSERT_NEAR(pack.Im[n] / static_cast<float>(length), start.Im[n], 8e-6);
    }
  }
}

TEST(PeriodFourier, AnyLengthByDefinition)
{
  for (int length : { 1, 2, 7, 30, 97, 202, 601 })
  {
    PeriodFourier::Line line(length);
    for (int n = 0; n < length; ++n)
    {
      line[n] = { std::sin(1.0 + n * n), std::cos(3.0 * n) };
    }
    const PeriodFourier fourier(length);
    const PeriodFourier::Line spectrum = fourier.Forward(line);
    const PeriodFourier::Line back = fourier.Backward(spectrum);
    double worst = 0.0;
    for (int k = 0; k < length; ++k)
    {
      std::complex<double> wants(0.0);
      for (int n = 0; n < length; ++n)
      {
        wants += line[n] *
          std::polar(
            1.0, -2.0 * std::acos(-1.0) * static_cast<double>(static_cast<long long>(k) * n % length) / length);
      }
      worst =
        std::max({ worst, std::abs(spectrum[k] - wants), std::abs(back[k] / static_cast<double>(length) - line[k]) });
    }
    EXPECT_LT(worst, 1e-11 * length) << length;
  }
}

TEST(LineFourier, FftwAgreesWithDoublePrecisionAndWithOurs)
{
  if (!HasFftw())
  {
    GTEST_SKIP() << "built without LITTORAL_WITH_FFTW";
  }
  AgreesWithDoublePrecision(FourierEngine::Fftw);
  for (int length : { 2000, 12000 })
  {
    LinePack ours(length / 2 + 1);
    for (std::size_t k = 0; k < ours.Re.size(); ++k)
    {
      ours.Re[k] = std::sin(1.0f + 0.3f * static_cast<float>(k));
      ours.Im[k] =
        k < FourierLanes || k >= ours.Re.size() - FourierLanes ? 0.0f : std::cos(1.7f * static_cast<float>(k));
    }
    LinePack theirs = ours;
    LinePack again = ours;
    RealLineFourier(length, FourierEngine::Own).Backward(ours);
    RealLineFourier(length, FourierEngine::Fftw).Backward(theirs);
    RealLineFourier(length, FourierEngine::Fftw).Backward(again);
    EXPECT_EQ(theirs.Re, again.Re);
    EXPECT_EQ(theirs.Im, again.Im);
    double difference = 0.0;
    double squares = 0.0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(length / 2 * FourierLanes); ++k)
    {
      difference += std::pow(ours.Re[k] - theirs.Re[k], 2) + std::pow(ours.Im[k] - theirs.Im[k], 2);
      squares += std::pow(ours.Re[k], 2) + std::pow(ours.Im[k], 2);
    }
    std::printf("%d samples: FFTW differs by %.3g rms\n", length, std::sqrt(difference / squares));
    EXPECT_LT(std::sqrt(difference / squares), 1e-6); // of single precision
  }
}
