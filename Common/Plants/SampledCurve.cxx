// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/SampledCurve.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace littoral
{

namespace
{

/// Shares of two values and, for cubic curves, of their slopes, in what is between them.
struct Shares
{
  glm::dvec2 Values;
  glm::dvec2 Slopes;
};

bool IsCubic(const Sampling& sampling, int length)
{
  return sampling.IsSmooth && length > 2;
}

/// A line: 1 - u and u. A cubic curve, Hermite's form: (1 + 2 u) (1 - u)^2, u^2 (3 - 2 u), L u (1 - u)^2, -L u^2 (1 -
/// u).
Shares SharesAt(int step, int length, bool isCubic)
{
  const double u = static_cast<double>(step) / length;
  const double v = 1.0 - u;
  if (!isCubic)
  {
    return { { v, u }, { 0.0, 0.0 } };
  }
  return { { (1.0 + 2.0 * u) * v * v, u * u * (3.0 - 2.0 * u) }, { length * u * v * v, -length * u * u * v } };
}

/// Sums over the frames between two samples: products of shares with each other and with values.
struct Between
{
  glm::dmat2 Values{ 0.0 };                                               // h h'
  glm::dmat2 Mixed{ 0.0 };                                                // g h'
  glm::dmat2 Slopes{ 0.0 };                                               // g g'
  std::array<glm::dvec4, 2> OfValues{ glm::dvec4(0.0), glm::dvec4(0.0) }; // h y
  std::array<glm::dvec4, 2> OfSlopes{ glm::dvec4(0.0), glm::dvec4(0.0) }; // g y

  Between(const std::vector<glm::dvec4>& values, int first, int length, bool isCubic)
  {
    for (int step = 1; step < length; ++step)
    {
      const Shares shares = SharesAt(step, length, isCubic);
      this->Values += glm::outerProduct(shares.Values, shares.Values);
      this->Mixed += glm::outerProduct(shares.Slopes, shares.Values);
      this->Slopes += glm::outerProduct(shares.Slopes, shares.Slopes);
      for (int end = 0; end < 2; ++end)
      {
        this->OfValues[end] += shares.Values[end] * values[first + step];
        this->OfSlopes[end] += shares.Slopes[end] * values[first + step];
      }
    }
    if (isCubic)
    {
      this->Eliminate();
    }
  }

  /// The best slopes for two values.
  std::array<glm::dvec4, 2> SlopesFor(const glm::dvec4& before, const glm::dvec4& after) const
  {
    std::array<glm::dvec4, 2> slopes;
    for (int end = 0; end < 2; ++end)
    {
      slopes[end] = this->OfSlopes[end] - this->Mixed[0][end] * before - this->Mixed[1][end] * after;
    }
    return slopes;
  }

private:
  /// The slopes are the best ones for any values, t = (g g')^-1 (g y - g h' x): what is left is an equation of values.
  void Eliminate()
  {
    const glm::dmat2 mixed = this->Mixed;
    const glm::dmat2 inverse = glm::inverse(this->Slopes);
    const std::array<glm::dvec4, 2> ofSlopes = this->OfSlopes;
    this->Mixed = inverse * mixed;
    this->Values -= glm::transpose(mixed) * this->Mixed;
    for (int end = 0; end < 2; ++end)
    {
      this->OfSlopes[end] = inverse[0][end] * ofSlopes[0] + inverse[1][end] * ofSlopes[1];
    }
    for (int end = 0; end < 2; ++end)
    {
      this->OfValues[end] -= mixed[end][0] * this->OfSlopes[0] + mixed[end][1] * this->OfSlopes[1];
    }
  }
};

}

//----------------------------------------------------------------------------
std::vector<int> SampledFrames(int frames, int stride)
{
  std::vector<int> sampled;
  for (int frame = 0; frame < frames - 1; frame += stride)
  {
    sampled.push_back(frame);
  }
  sampled.push_back(frames - 1);
  return sampled;
}

//----------------------------------------------------------------------------
int CountOf(const Sampling& sampling, int frames)
{
  const int samples = 1 + (frames - 1 + sampling.Stride - 1) / sampling.Stride;
  return sampling.IsSmooth ? 3 * samples : samples;
}

//----------------------------------------------------------------------------
/// A x = b with a tridiagonal A: each sample has its own value, and shares in those up to the next ones.
std::vector<glm::dvec4> CurveThrough(const std::vector<glm::dvec4>& values, const Sampling& sampling)
{
  const std::vector<int> frames = SampledFrames(static_cast<int>(values.size()), sampling.Stride);
  const std::size_t count = frames.size();
  std::vector<double> diagonal(count, 1.0);
  std::vector<double> beside(count, 0.0); // of a sample and the next one
  std::vector<glm::dvec4> sums(count);
  std::vector<Between> intervals;
  for (std::size_t sample = 0; sample < count; ++sample)
  {
    sums[sample] = values[frames[sample]];
  }
  for (std::size_t sample = 0; sample + 1 < count; ++sample)
  {
    const int length = frames[sample + 1] - frames[sample];
    const Between interval(values, frames[sample], length, IsCubic(sampling, length));
    for (std::size_t end = 0; end < 2; ++end)
    {
      diagonal[sample + end] += interval.Values[static_cast<int>(end)][static_cast<int>(end)];
      sums[sample + end] += interval.OfValues[end];
    }
    beside[sample] = interval.Values[0][1];
    intervals.push_back(interval);
  }
  for (std::size_t row = 1; row < count; ++row)
  {
    const double factor = beside[row - 1] / diagonal[row - 1];
    diagonal[row] -= factor * beside[row - 1];
    sums[row] -= factor * sums[row - 1];
  }
  sums.back() /= diagonal.back();
  for (std::size_t row = count - 1; row > 0; --row)
  {
    sums[row - 1] = (sums[row - 1] - beside[row - 1] * sums[row]) / diagonal[row - 1];
  }
  if (!sampling.IsSmooth)
  {
    return sums;
  }
  std::vector<glm::dvec4> curve(3 * count, glm::dvec4(0.0));
  for (std::size_t sample = 0; sample < count; ++sample)
  {
    curve[3 * sample + 1] = sums[sample];
  }
  for (std::size_t sample = 0; sample + 1 < count; ++sample)
  {
    const int length = frames[sample + 1] - frames[sample];
    const glm::dvec4 straight = (sums[sample + 1] - sums[sample]) / static_cast<double>(length);
    const std::array<glm::dvec4, 2> slopes = IsCubic(sampling, length)
      ? intervals[sample].SlopesFor(sums[sample], sums[sample + 1])
      : std::array<glm::dvec4, 2>{ straight, straight };
    curve[3 * sample + 2] = slopes[0];
    curve[3 * sample + 3] = slopes[1];
  }
  return curve;
}

//----------------------------------------------------------------------------
glm::dvec4 CurveAt(const std::vector<glm::dvec4>& curve, const Sampling& sampling, int frames, int frame)
{
  const int each = sampling.IsSmooth ? 3 : 1;
  const int last = static_cast<int>(curve.size()) / each - 1;
  const int before = std::min(frame / sampling.Stride, last);
  const int first = before * sampling.Stride;
  const int length = std::min(sampling.Stride, frames - 1 - first);
  const auto value = [&](int sample, int part) { return curve[static_cast<std::size_t>(each) * sample + part]; };
  if (before == last || length <= 0)
  {
    return value(last, sampling.IsSmooth ? 1 : 0);
  }
  const Shares shares = SharesAt(frame - first, length, sampling.IsSmooth);
  if (!sampling.IsSmooth)
  {
    return shares.Values[0] * value(before, 0) + shares.Values[1] * value(before + 1, 0);
  }
  return shares.Values[0] * value(before, 1) + shares.Values[1] * value(before + 1, 1) +
    shares.Slopes[0] * value(before, 2) + shares.Slopes[1] * value(before + 1, 0);
}

}
