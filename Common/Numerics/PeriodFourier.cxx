// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/PeriodFourier.h"

#include "Numerics/Constants.h"
#include "Numerics/FourierGrid.h"

#include <kissfft/kissfft.hh>

#include <algorithm>
#include <functional>

namespace littoral
{

/// Transforms of a length of 2, 3 and 5 alone; for others kissfft is slow and keeps a scratch that threads would share.
struct PeriodFourier::Plans
{
  explicit Plans(int length)
    : Forward(length, false)
    , Backward(length, true)
  {
  }

  kissfft<double> Forward;
  kissfft<double> Backward;
};

PeriodFourier::PeriodFourier(int length)
  : Length(length)
{
  if (NextFastLength(length) == length)
  {
    this->Own = std::make_unique<Plans>(length);
    return;
  }
  const int padded = NextFastLength(2 * length - 1);
  this->Own = std::make_unique<Plans>(padded);
  Line chirp(padded, 0.0);
  for (int n = 0; n < length; ++n)
  {
    const long long square = static_cast<long long>(n) * n % (2LL * length);
    this->Chirp.push_back(std::polar(1.0, Pi * static_cast<double>(square) / length));
    chirp[n] = chirp[n == 0 ? 0 : padded - n] = this->Chirp.back() / static_cast<double>(padded);
  }
  this->ChirpSpectrum.resize(padded);
  this->Own->Forward.transform(chirp.data(), this->ChirpSpectrum.data());
}

PeriodFourier::~PeriodFourier() = default;

PeriodFourier::Line PeriodFourier::Forward(const Line& line) const
{
  if (this->Chirp.empty())
  {
    Line spectrum(line.size());
    this->Own->Forward.transform(line.data(), spectrum.data());
    return spectrum;
  }
  // k n = (k^2 + n^2 - (k - n)^2) / 2: a convolution with the chirp, between two products with its conjugate.
  Line padded(this->ChirpSpectrum.size(), 0.0);
  for (int n = 0; n < this->Length; ++n)
  {
    padded[n] = line[n] * std::conj(this->Chirp[n]);
  }
  Line spectrum(padded.size());
  this->Own->Forward.transform(padded.data(), spectrum.data());
  std::transform(spectrum.begin(), spectrum.end(), this->ChirpSpectrum.begin(), spectrum.begin(), std::multiplies<>());
  this->Own->Backward.transform(spectrum.data(), padded.data());
  padded.resize(this->Length);
  std::transform(padded.begin(), padded.end(), this->Chirp.begin(), padded.begin(),
    [](const std::complex<double>& value, const std::complex<double>& chirp) { return value * std::conj(chirp); });
  return padded;
}

PeriodFourier::Line PeriodFourier::Backward(const Line& line) const
{
  if (this->Chirp.empty())
  {
    Line values(line.size());
    this->Own->Backward.transform(line.data(), values.data());
    return values;
  }
  // The exponent's sign turns with the order of the frequencies.
  Line turned = line;
  std::reverse(turned.begin() + 1, turned.end());
  return this->Forward(turned);
}

}
