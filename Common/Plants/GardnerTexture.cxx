// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/GardnerTexture.h"

#include "Numerics/Constants.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr double AmplitudeRatio = 0.707;

// Factors of the leaf's color: shade is bluish, light is warm, as painters have it.
constexpr double InShade[] = { 0.52, 0.60, 0.66 };
constexpr double InLight[] = { 1.0, 1.0, 0.84 };

}

GardnerTexture::GardnerTexture(const GardnerTextureParameters& parameters)
  : P(parameters)
{
  double amplitude = 1.0;
  double sum = 0.0;
  for (int i = 0; i < this->P.Terms; ++i)
  {
    const double octave = std::ldexp(1.0, i);
    const double x = octave * this->P.Frequency;
    const double y = octave * this->P.FrequencyY;
    this->Terms.push_back({ amplitude, x, y, 0.5 * x, 0.5 * y });
    sum += amplitude;
    amplitude *= AmplitudeRatio;
  }
  // k = 1 / (sum C_i (1 + T0))^2
  const double largest = sum * (1.0 + this->P.Offset);
  this->Scale = 1.0 / (largest * largest);
}

double GardnerTexture::At(double x, double y) const
{
  return this->OnGrid({ x }, { y }).front();
}

std::vector<double> GardnerTexture::OnGrid(const std::vector<double>& x, const std::vector<double>& y) const
{
  // sin(FX_i x + PX_i) = sin(FX_i x) cos(PX_i) + cos(FX_i x) sin(PX_i), and the same for y: what depends on a column or
  // a row alone is computed once.
  const auto wavesOf = [this](
                         const std::vector<double>& places, double origin, double Term::*own, double Term::*before) {
    std::vector<Wave> waves;
    waves.reserve(places.size() * this->Terms.size());
    for (const double place : places)
    {
      for (const Term& term : this->Terms)
      {
        const double angle = term.*own * (place + origin);
        const double phase = 0.5 * Pi * std::sin(term.*before * (place + origin)); // of the other direction
        waves.push_back({ std::sin(angle), std::cos(angle), std::sin(phase), std::cos(phase) });
      }
    }
    return waves;
  };
  const std::vector<Wave> columns = wavesOf(x, this->P.Origin[0], &Term::X, &Term::XBefore);
  const std::vector<Wave> rows = wavesOf(y, this->P.Origin[1], &Term::Y, &Term::YBefore);
  std::vector<double> values;
  values.reserve(x.size() * y.size());
  const std::size_t terms = this->Terms.size();
  for (std::size_t row = 0; row < y.size(); ++row)
  {
    for (std::size_t column = 0; column < x.size(); ++column)
    {
      double alongX = 0.0;
      double alongY = 0.0;
      for (std::size_t i = 0; i < terms; ++i)
      {
        // C_i [sin(FX_i x + PX_i) + T0]; the same for y
        const double amplitude = this->Terms[i].Amplitude;
        const Wave& ofX = columns[column * terms + i];
        const Wave& ofY = rows[row * terms + i];
        alongX += amplitude * (ofX.Sine * ofY.PhaseCosine + ofX.Cosine * ofY.PhaseSine + this->P.Offset);
        alongY += amplitude * (ofY.Sine * ofX.PhaseCosine + ofY.Cosine * ofX.PhaseSine + this->P.Offset);
      }
      values.push_back(this->Scale * alongX * alongY);
    }
  }
  return values;
}

double GardnerTexture::Threshold(double profile) const
{
  return this->P.CenterThreshold + (this->P.SilhouetteThreshold - this->P.CenterThreshold) * (1.0 - profile);
}

namespace
{

/// The color that T gives, opaque or not.
Texel TexelOf(const GardnerTexture& texture, double value, double profile)
{
  const double dark = texture.Threshold(1.0);
  const double bright = std::max(texture.Threshold(0.0), dark + 0.05);
  const double light = std::clamp((value - dark) / (bright - dark), 0.0, 1.0);
  Texel texel{};
  for (int channel = 0; channel < 3; ++channel)
  {
    const double gain = InShade[channel] + (InLight[channel] - InShade[channel]) * light;
    texel[channel] = static_cast<unsigned char>(std::lround(255.0 * gain));
  }
  texel[3] = profile >= 0.0 && value > texture.Threshold(profile) ? 255 : 0;
  return texel;
}

/// Numbers in the middles of equal steps from 0 to an end.
std::vector<double> Middles(double end, int count)
{
  std::vector<double> middles(static_cast<std::size_t>(std::max(0, count)));
  for (int step = 0; step < count; ++step)
  {
    middles[static_cast<std::size_t>(step)] = end * (step + 0.5) / count;
  }
  return middles;
}

void AddSections(const GardnerTexture& texture, TextureImage& picture)
{
  const int half = GardnerColumns / 2;
  std::vector<double> across = Middles(2.0, half);
  std::vector<double> up = Middles(2.0, SectionRows);
  std::vector<double> x;
  std::vector<double> y;
  for (double& place : across)
  {
    place -= 1.0;
    x.push_back(place);
  }
  for (const double place : across) // the other section shows what lies on the other side
  {
    x.push_back(Pi + place);
  }
  for (double& place : up)
  {
    place -= 1.0;
    y.push_back(0.5 * Pi + place);
  }
  const std::vector<double> values = texture.OnGrid(x, y);
  for (int row = 0; row < SectionRows; ++row)
  {
    for (int column = 0; column < GardnerColumns; ++column)
    {
      const double outwards = across[column % half];
      picture.At(column, row) =
        TexelOf(texture, values[row * GardnerColumns + column], 1.0 - outwards * outwards - up[row] * up[row]);
    }
  }
}

void AddShells(const GardnerTexture& texture, int shells, TextureImage& picture)
{
  const int stripRows = StripRows(shells);
  const std::vector<double> values = texture.OnGrid(Middles(TwoPi, GardnerColumns), Middles(Pi, stripRows));
  for (int row = 0; row < stripRows; ++row)
  {
    for (int column = 0; column < GardnerColumns; ++column)
    {
      for (int shell = 0; shell < shells; ++shell)
      {
        picture.At(column, SectionRows + shell * stripRows + row) =
          TexelOf(texture, values[row * GardnerColumns + column], ShellProfile(shell, shells));
      }
    }
  }
}

}

TextureImage GardnerPicture(const GardnerTexture& texture, int shells)
{
  TextureImage picture(GardnerColumns, SectionRows + ShellRows);
  AddSections(texture, picture);
  AddShells(texture, shells, picture);
  return picture;
}

}
