// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lens.h"

#include "LandscapeLens.h"
#include "Uniforms.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace littoral
{

namespace
{

constexpr double LargestShare = 0.04; // radius of blur, of the height of the picture
constexpr double Taps = 64.0;

}

//----------------------------------------------------------------------------
Lens::Lens()
  : ToTiles(LandscapeLens, "#define LensPart LensTiles\n")
  , ToBlurred(LandscapeLens, "#define LensPart LensGather\n")
{
}

//----------------------------------------------------------------------------
Lens::~Lens() = default;

//----------------------------------------------------------------------------
void Lens::Draw(vtkOpenGLRenderWindow* window, vtkTextureObject* lit, const View& view)
{
  const auto width = static_cast<int>(lit->GetWidth());
  const auto height = static_cast<int>(lit->GetHeight());
  const int largest = std::max(static_cast<int>(LargestShare * height), 4);
  if (!this->Blurred || this->Width != width || this->Height != height)
  {
    this->Width = width;
    this->Height = height;
    this->Tiles = PictureShader::NewPicture(window, (width - 1) / largest + 1, (height - 1) / largest + 1, 1);
    this->Blurred = PictureShader::NewPicture(window, width, height, 4);
  }
  const auto setUniforms = [&](vtkShaderProgram* program) {
    SetUniform(program, "lensBlur", view.Blur);
    SetUniform(program, "lensFocus", view.Focus);
    SetUniform(program, "lensLargest", static_cast<double>(largest));
    SetUniform(program, "lensTaps", Taps);
  };
  this->ToTiles.Draw(window, this->Tiles, { { "lensLit", lit } }, setUniforms);
  this->ToBlurred.Draw(window, this->Blurred, { { "lensLit", lit }, { "lensTiles", this->Tiles } }, setUniforms);
}

//----------------------------------------------------------------------------
void Lens::ReleaseGraphicsResources(vtkWindow* window)
{
  PictureShader::Release({ &this->Tiles, &this->Blurred }, window);
  this->ToTiles.ReleaseGraphicsResources(window);
  this->ToBlurred.ReleaseGraphicsResources(window);
}

}
