// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GardnerTexture.h"

#include "Constants.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr double AmplitudeRatio = 0.707;

// Factors of the leaf's colour: shade is bluish, light is warm, as painters have it.
constexpr double InShade[] = { 0.42, 0.52, 0.60 };
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
  const double largest = sum * (1.0 + this->P.Offset);
  this->Scale = 1.0 / (largest * largest);
}

double GardnerTexture::At(double x, double y) const
{
  x += this->P.Origin[0];
  y += this->P.Origin[1];
  double alongX = 0.0;
  double alongY = 0.0;
  for (const Term& term : this->Terms)
  {
    const double phaseX = 0.5 * Pi * std::sin(term.YBefore * y);
    const double phaseY = 0.5 * Pi * std::sin(term.XBefore * x);
    alongX += term.Amplitude * (std::sin(term.X * x + phaseX) + this->P.Offset);
    alongY += term.Amplitude * (std::sin(term.Y * y + phaseY) + this->P.Offset);
  }
  return this->Scale * alongX * alongY;
}

double GardnerTexture::Threshold(double profile) const
{
  return this->P.CentreThreshold + (this->P.SilhouetteThreshold - this->P.CentreThreshold) * (1.0 - profile);
}

TextureImage GardnerPicture(const GardnerTexture& texture, int shells, int columns, int rows)
{
  TextureImage picture(columns, rows);
  const int stripRows = StripRows(shells, rows);
  const double dark = texture.Threshold(1.0);
  const double bright = std::max(texture.Threshold(0.0), dark + 0.05);
  for (int row = 0; row < stripRows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      const double value = texture.At(TwoPi * (column + 0.5) / columns, Pi * (row + 0.5) / stripRows);
      const double light = std::clamp((value - dark) / (bright - dark), 0.0, 1.0);
      Texel texel{};
      for (int channel = 0; channel < 3; ++channel)
      {
        const double gain = InShade[channel] + (InLight[channel] - InShade[channel]) * light;
        texel[channel] = static_cast<unsigned char>(std::lround(255.0 * gain));
      }
      for (int shell = 0; shell < shells; ++shell)
      {
        texel[3] = value > texture.Threshold(ShellProfile(shell, shells)) ? 255 : 0;
        picture.At(column, shell * stripRows + row) = texel;
      }
    }
  }
  return picture;
}

}
