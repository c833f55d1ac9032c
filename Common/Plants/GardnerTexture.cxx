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
  x += this->P.Origin[0];
  y += this->P.Origin[1];
  double alongX = 0.0;
  double alongY = 0.0;
  for (const Term& term : this->Terms)
  {
    // C_i [sin(FX_i x + PX_i) + T0], PX_i = pi/2 sin(FY_(i-1) y); the same for y
    const double phaseX = 0.5 * Pi * std::sin(term.YBefore * y);
    const double phaseY = 0.5 * Pi * std::sin(term.XBefore * x);
    alongX += term.Amplitude * (std::sin(term.X * x + phaseX) + this->P.Offset);
    alongY += term.Amplitude * (std::sin(term.Y * y + phaseY) + this->P.Offset);
  }
  return this->Scale * alongX * alongY;
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

void AddSections(const GardnerTexture& texture, TextureImage& picture)
{
  const int half = GardnerColumns / 2;
  for (int row = 0; row < SectionRows; ++row)
  {
    for (int column = 0; column < GardnerColumns; ++column)
    {
      const double across = 2.0 * (column % half + 0.5) / half - 1.0;
      const double up = 2.0 * (row + 0.5) / SectionRows - 1.0;
      // The other section shows what lies on the other side.
      const double value = texture.At((column < half ? 0.0 : Pi) + across, 0.5 * Pi + up);
      picture.At(column, row) = TexelOf(texture, value, 1.0 - across * across - up * up);
    }
  }
}

void AddShells(const GardnerTexture& texture, int shells, TextureImage& picture)
{
  const int stripRows = StripRows(shells);
  for (int row = 0; row < stripRows; ++row)
  {
    for (int column = 0; column < GardnerColumns; ++column)
    {
      const double value = texture.At(TwoPi * (column + 0.5) / GardnerColumns, Pi * (row + 0.5) / stripRows);
      for (int shell = 0; shell < shells; ++shell)
      {
        picture.At(column, SectionRows + shell * stripRows + row) =
          TexelOf(texture, value, ShellProfile(shell, shells));
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
