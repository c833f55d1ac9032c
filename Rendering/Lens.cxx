// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lens.h"

#include "LandscapeLens.h"
#include "OpenGL.h"
#include "Uniforms.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <vector>

namespace littoral
{

namespace
{

constexpr double LargestShare = 0.04; // radius of blur, of the height of the picture
constexpr double Taps = 64.0;
constexpr float Nowhere = 2e9F; // a distance beyond that of the sky

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
void Lens::TakeNearest(vtkTextureObject* lit, vtkMultiProcessController* processes)
{
  const auto width = static_cast<int>(lit->GetWidth());
  const auto height = static_cast<int>(lit->GetHeight());
  const auto count = static_cast<std::size_t>(width) * height;
  std::vector<float> pixels(4 * count);
  std::vector<float> ways(count);
  std::vector<float> nearest(count);
  std::vector<float> whole(4 * count);
  lit->Activate();
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, pixels.data());
  for (std::size_t k = 0; k < count; ++k)
  {
    ways[k] = pixels[4 * k + 3] > 0.0F ? pixels[4 * k + 3] : Nowhere;
  }
  processes->AllReduce(ways.data(), nearest.data(), static_cast<vtkIdType>(count), vtkCommunicator::MIN_OP);
  for (std::size_t k = 0; k < count; ++k)
  {
    if (ways[k] > nearest[k] || ways[k] == Nowhere)
    {
      std::fill_n(&pixels[4 * k], 4, 0.0F);
    }
  }
  processes->AllReduce(pixels.data(), whole.data(), static_cast<vtkIdType>(4 * count), vtkCommunicator::MAX_OP);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, whole.data());
  lit->Deactivate();
}

//----------------------------------------------------------------------------
void Lens::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto* picture : { &this->Tiles, &this->Blurred })
  {
    if (*picture)
    {
      (*picture)->ReleaseGraphicsResources(window);
    }
    *picture = nullptr;
  }
  this->ToTiles.ReleaseGraphicsResources(window);
  this->ToBlurred.ReleaseGraphicsResources(window);
}

}
