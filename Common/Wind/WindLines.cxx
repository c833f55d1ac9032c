// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Wind/WindLines.h"

#include "Numerics/Constants.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{
constexpr int Components = 3;
/// Below this part of their power, waves that nearly cancel do not tell a phase.
constexpr double LeastShare = 1e-12;

/// A line that takes part in a mean.
struct Neighbour
{
  const std::complex<float>* Waves;
  double Weight;
};

/// The waves of a component at a place: means of amplitudes with the means of powers, turned by the part of a sample.
void MeanWaves(const std::vector<Neighbour>& lines, int waves, double part, int length, std::complex<double>* to)
{
  const std::complex<double> turn = std::polar(1.0, TwoPi * part / length);
  std::complex<double> phase(1.0);
  for (int k = 0; k < waves; ++k, phase *= turn)
  {
    std::complex<double> mean(0.0);
    double power = 0.0;
    const Neighbour* strongest = &lines.front();
    for (const Neighbour& line : lines)
    {
      const std::complex<double> wave(line.Waves[k]);
      mean += line.Weight * wave;
      power += line.Weight * std::norm(wave);
      strongest =
        line.Weight * std::norm(line.Waves[k]) > strongest->Weight * std::norm(strongest->Waves[k]) ? &line : strongest;
    }
    if (k > 0 && lines.size() > 1 && power > 0.0)
    {
      mean = std::norm(mean) > LeastShare * power ? mean : std::complex<double>(strongest->Waves[k]);
      mean *= std::sqrt(power / std::norm(mean));
    }
    to[k] = mean * phase;
  }
}
}

WindLines::WindLines(const float* velocities, const std::array<int, 3>& size, const ParallelFor& parallel)
  : Size(size)
  , Waves(size[0] / 2 + 1)
  , Along(size[0])
  , Spectra(static_cast<std::size_t>(size[1]) * size[2] * Components * this->Waves)
{
  const auto length = static_cast<std::size_t>(size[0]);
  parallel(static_cast<std::size_t>(size[1]) * size[2], [&](std::size_t begin, std::size_t end) {
    PeriodFourier::Line values(length);
    for (std::size_t line = begin * Components; line < end * Components; ++line)
    {
      const float* from = velocities + line / Components * Components * length + line % Components;
      for (std::size_t n = 0; n < length; ++n)
      {
        values[n] = from[n * Components] / static_cast<double>(length);
      }
      const PeriodFourier::Line spectrum = this->Along.Forward(values);
      std::transform(spectrum.begin(), spectrum.begin() + this->Waves, &this->Spectra[line * this->Waves],
        [](const std::complex<double>& wave) { return Wave(wave); });
    }
  });
}

double WindLines::BytesOf(const std::array<int, 3>& size)
{
  return static_cast<double>(size[1]) * size[2] * Components * (size[0] / 2 + 1) * sizeof(Wave);
}

const WindLines::Wave* WindLines::WavesOf(int across, int up) const
{
  return &this->Spectra[(static_cast<std::size_t>(up) * this->Size[1] + across) * Components * this->Waves];
}

void WindLines::Sample(const std::array<double, 3>& place, double first, std::size_t count, Vector3* velocities) const
{
  const double y = std::clamp(place[1], 0.0, this->Size[1] - 1.0);
  const double z = std::clamp(place[2], 0.0, this->Size[2] - 1.0);
  const int length = this->Size[0];
  // What is at sample i now comes to the sample i0 in i0 - i steps.
  const double begin = std::floor(place[0] - first);
  const double part = place[0] - first - begin;
  std::array<PeriodFourier::Line, 2> values{ PeriodFourier::Line(length), PeriodFourier::Line(length) };
  PeriodFourier::Line waves(this->Waves);
  for (int component = 0; component < Components; ++component)
  {
    std::vector<Neighbour> lines;
    for (int corner = 0; corner < 4; ++corner)
    {
      const double fromY = y - std::floor(y);
      const double fromZ = z - std::floor(z);
      const double weight = (corner % 2 ? fromY : 1.0 - fromY) * (corner / 2 ? fromZ : 1.0 - fromZ);
      if (weight > 0.0)
      {
        const Wave* line = this->WavesOf(static_cast<int>(y) + corner % 2, static_cast<int>(z) + corner / 2);
        lines.push_back({ line + component * this->Waves, weight });
      }
    }
    MeanWaves(lines, this->Waves, part, length, waves.data());
    // Two real lines go as the real and the imaginary part of one.
    PeriodFourier::Line& sum = values[component / 2];
    const std::complex<double> unit = component % 2 ? std::complex<double>(0.0, 1.0) : std::complex<double>(1.0);
    sum[0] += unit * waves[0].real();
    for (int k = 1; k < this->Waves; ++k)
    {
      const std::complex<double> wave = 2 * k == length ? waves[k].real() : waves[k];
      sum[k] += unit * wave;
      if (2 * k != length)
      {
        sum[length - k] += unit * std::conj(wave);
      }
    }
  }
  for (PeriodFourier::Line& line : values)
  {
    line = this->Along.Backward(line);
  }
  auto i = static_cast<long long>(std::fmod(begin, static_cast<double>(length)));
  i = i < 0 ? i + length : i;
  for (std::size_t n = 0; n < count; ++n)
  {
    velocities[n] = { values[0][i].real(), values[0][i].imag(), values[1][i].real() };
    i = i > 0 ? i - 1 : length - 1;
  }
}

double LayerPlace(double height, double bottom, double spacing)
{
  const double place = (height - bottom) / spacing;
  const double layer = std::floor(place);
  const double below = bottom + layer * spacing;
  return below > 0.0 ? layer + std::log(height / below) / std::log1p(spacing / below) : place;
}

WindCarrier::WindCarrier(int length)
  : Along(length)
{
}

void WindCarrier::Carry(const float* first, int count, double part, Room& room) const
{
  const auto length = static_cast<std::size_t>(this->Along.GetLength());
  const std::size_t half = length / 2;
  LinePack& pack = room.Pack;
  for (int component = 0; component < Components; ++component)
  {
    for (std::size_t n = 0; n < half; ++n)
    {
      for (int lane = 0; lane < count; ++lane)
      {
        const float* pair = first + (lane * length + 2 * n) * Components + component;
        pack.Re[n * FourierLanes + lane] = pair[0];
        pack.Im[n * FourierLanes + lane] = pair[Components];
      }
    }
    this->Along.Forward(pack);
    // A wave that is k times in the line falls back by the angle 2 pi k part / length.
    for (std::size_t k = 0; k <= half; ++k)
    {
      const double angle = -TwoPi * static_cast<double>(k) * part / static_cast<double>(length);
      const auto scale = 1.0 / static_cast<double>(length);
      const auto c = static_cast<float>(scale * std::cos(angle));
      const auto s = static_cast<float>(scale * std::sin(angle));
      float* re = &pack.Re[k * FourierLanes];
      float* im = &pack.Im[k * FourierLanes];
      for (int lane = 0; lane < FourierLanes; ++lane)
      {
        const float turned = c * re[lane] - s * im[lane];
        im[lane] = k == half ? 0.0f : c * im[lane] + s * re[lane];
        re[lane] = turned;
      }
    }
    this->Along.Backward(pack);
    for (std::size_t n = 0; n < half; ++n)
    {
      for (int lane = 0; lane < count; ++lane)
      {
        float* pair = &room.Velocities[(lane * length + 2 * n) * Components + component];
        pair[0] = pack.Re[n * FourierLanes + lane];
        pair[Components] = pack.Im[n * FourierLanes + lane];
      }
    }
  }
}

}
