// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImpostorAtlas.h"

#include "BoundFrame.h"
#include "Geometry/FrameLevels.h"
#include "Geometry/OctahedronMap.h"
#include "Geometry/SrgbCode.h"
#include "OpenGL.h"
#include "SurfacePass.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace littoral
{

namespace
{

constexpr int Fineness = 4; // samples along a texel's side

/// Axes of a picture from a direction: to the right and upward; the shader of impostors has the same.
void AxesOf(const glm::dvec3& towards, glm::dvec3& right, glm::dvec3& up)
{
  const glm::dvec3 other = std::abs(towards.z) < 0.9137 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, 1.0, 0.0);
  right = glm::normalize(glm::cross(other, towards));
  up = glm::cross(towards, right);
}

/// Linear light of each byte.
std::array<float, 256> LinearBytes()
{
  std::array<float, 256> linear;
  for (int code = 0; code < 256; ++code)
  {
    linear[code] = static_cast<float>(LinearOfSrgb(code / 255.0));
  }
  return linear;
}

unsigned char ByteOf(double number)
{
  return static_cast<unsigned char>(std::clamp(255.0 * number + 0.5, 0.0, 255.0));
}

unsigned char CodeOf(float linear)
{
  return ByteOf(linear <= 0.0031308F ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055);
}

vtkSmartPointer<vtkTextureObject> NewTexture(vtkOpenGLRenderWindow* window)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  return texture;
}

}

/// Texels of both textures, by levels.
struct ImpostorAtlas::Bytes
{
  int Frames;
  int FrameSize;
  std::vector<std::vector<unsigned char>> Colors;
  std::vector<std::vector<unsigned char>> Forms;
  std::vector<std::vector<unsigned char>> Leaves;

  Bytes(int frames, int frameSize)
    : Frames(frames)
    , FrameSize(frameSize)
  {
    for (int level = 0; level < LevelsOf(frameSize); ++level)
    {
      const std::size_t side = static_cast<std::size_t>(frames) * (frameSize >> level);
      this->Colors.emplace_back(4 * side * side);
      this->Forms.emplace_back(4 * side * side);
      this->Leaves.emplace_back(side * side);
    }
  }

  void Add(const FramePicture& picture, int level, int column, int row);
  vtkSmartPointer<vtkTextureObject> Sent(
    const std::vector<std::vector<unsigned char>>& levels, int format, vtkOpenGLRenderWindow* window) const;
};

//----------------------------------------------------------------------------
void ImpostorAtlas::Bytes::Add(const FramePicture& picture, int level, int column, int row)
{
  const int side = picture.Side;
  for (int y = 0; y < side; ++y)
  {
    for (int x = 0; x < side; ++x)
    {
      const FrameTexel& texel = picture.At(x, y);
      const std::size_t at = 4 * (static_cast<std::size_t>(row * side + y) * (this->Frames * side) + column * side + x);
      unsigned char* color = &this->Colors[level][at];
      for (int c = 0; c < 3; ++c)
      {
        color[c] = CodeOf(texel.Albedo[c]);
      }
      color[3] = ByteOf(texel.Coverage);
      unsigned char* form = &this->Forms[level][at];
      for (int c = 0; c < 3; ++c)
      {
        form[c] = ByteOf(0.5 + 0.5 * texel.Normal[c]);
      }
      form[3] = ByteOf(0.5 + 0.5 * texel.Depth);
      this->Leaves[level][at / 4] = ByteOf(texel.Transmittance);
    }
  }
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkTextureObject> ImpostorAtlas::Bytes::Sent(
  const std::vector<std::vector<unsigned char>>& levels, int format, vtkOpenGLRenderWindow* window) const
{
  const auto side = static_cast<unsigned int>(this->Frames * this->FrameSize);
  const bool isGrey = format == GL_R8;
  auto texture = NewTexture(window);
  texture->SetMinificationFilter(vtkTextureObject::LinearMipmapLinear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  texture->SetMaxLevel(static_cast<int>(levels.size()) - 1);
  texture->Allocate2D(side, side, isGrey ? 1 : 4, VTK_UNSIGNED_CHAR);
  texture->Activate();
  for (std::size_t level = 0; level < levels.size(); ++level)
  {
    const auto size = static_cast<GLsizei>(side >> level);
    glTexImage2D(GL_TEXTURE_2D, static_cast<GLint>(level), format, size, size, 0, isGrey ? GL_RED : GL_RGBA,
      GL_UNSIGNED_BYTE, levels[level].data());
  }
  texture->Deactivate();
  return texture;
}

//----------------------------------------------------------------------------
ImpostorAtlas::ImpostorAtlas() = default;
ImpostorAtlas::~ImpostorAtlas() = default;

//----------------------------------------------------------------------------
int ImpostorAtlas::LevelsOf(int frameSize)
{
  int levels = 1;
  for (; frameSize > 8; frameSize /= 2)
  {
    ++levels;
  }
  return levels;
}

//----------------------------------------------------------------------------
vtkTypeInt64 ImpostorAtlas::BytesOf(int frames, int frameSize)
{
  vtkTypeInt64 bytes = 0;
  for (int level = 0; level < LevelsOf(frameSize); ++level)
  {
    const vtkTypeInt64 side = static_cast<vtkTypeInt64>(frames) * (frameSize >> level);
    bytes += 9 * side * side;
  }
  return bytes;
}

//----------------------------------------------------------------------------
void ImpostorAtlas::Allocate(vtkOpenGLRenderWindow* window, int side)
{
  const auto size = static_cast<unsigned int>(side);
  this->Albedo = NewTexture(window);
  this->Surface = NewTexture(window);
  this->Depth = NewTexture(window);
  this->Albedo->Allocate2D(size, size, 4, VTK_UNSIGNED_CHAR);
  this->Surface->Allocate2D(size, size, 4, VTK_FLOAT);
  this->Depth->AllocateDepth(size, size, vtkTextureObject::Float32);
}

//----------------------------------------------------------------------------
void ImpostorAtlas::Draw(
  vtkRenderer* renderer, const std::vector<vtkActor*>& parts, const Sphere& around, int frames, int frameSize)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const int side = Fineness * frameSize;
  this->Allocate(window, side);
  std::vector<vtkProp*> props(parts.begin(), parts.end());
  vtkRenderState all(renderer);
  all.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
  Bytes bytes(frames, frameSize);
  this->Surfaces->Begin(&all);
  for (int k = 0; k < frames * frames; ++k)
  {
    const double half = 0.5 * (frames - 1);
    const glm::dvec3 towards = OctahedronNormal((k % frames) / half - 1.0, (k / frames) / half - 1.0);
    std::vector<FramePicture> levels = FrameLevels(this->TakeFrame(renderer, props, around, towards, side), frameSize);
    for (int level = 0; level < LevelsOf(frameSize); ++level)
    {
      KeepCoverage(levels[level]);
      bytes.Add(levels[level], level, k % frames, k / frames);
    }
  }
  this->Surfaces->End(&all);
  this->Colors = bytes.Sent(bytes.Colors, GL_SRGB8_ALPHA8, window);
  this->Forms = bytes.Sent(bytes.Forms, GL_RGBA8, window);
  this->Leaves = bytes.Sent(bytes.Leaves, GL_R8, window);
  for (auto* texture : { &this->Albedo, &this->Surface, &this->Depth })
  {
    (*texture)->ReleaseGraphicsResources(window);
    *texture = nullptr;
  }
}

//----------------------------------------------------------------------------
FramePicture ImpostorAtlas::TakeFrame(
  vtkRenderer* renderer, const std::vector<vtkProp*>& props, const Sphere& around, const glm::dvec3& towards, int side)
{
  glm::dvec3 right;
  glm::dvec3 up;
  AxesOf(towards, right, up);
  const glm::dvec3 eye = around.Center + 2.0 * around.Radius * towards;
  this->Camera->SetPosition(eye.x, eye.y, eye.z);
  this->Camera->SetFocalPoint(around.Center.x, around.Center.y, around.Center.z);
  this->Camera->SetViewUp(up.x, up.y, up.z);
  this->Camera->ParallelProjectionOn();
  this->Camera->SetParallelScale(around.Radius);
  this->Camera->SetClippingRange(around.Radius, 3.0 * around.Radius);
  // x / r, y / r, and depths -1 to 1 over the sphere
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 0, 1.0 / around.Radius);
  matrix->SetElement(1, 1, 1.0 / around.Radius);
  matrix->SetElement(2, 2, -1.0 / around.Radius);
  matrix->SetElement(2, 3, -2.0);
  this->Camera->SetExplicitProjectionTransformMatrix(matrix);
  this->Camera->UseExplicitProjectionTransformMatrixOn();

  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  BoundFrame bound(window, this->Frame, { this->Albedo, this->Surface }, this->Depth);
  bound.Clear(SurfacePass::Nothing);
  vtkSmartPointer<vtkCamera> camera = renderer->GetActiveCamera();
  renderer->SetActiveCamera(this->Camera);
  for (vtkProp* prop : props)
  {
    prop->RenderOpaqueGeometry(renderer);
  }
  renderer->SetActiveCamera(camera);
  return this->Read(towards, side);
}

//----------------------------------------------------------------------------
/// The frame that is bound, from the view's axes to those of the plant.
FramePicture ImpostorAtlas::Read(const glm::dvec3& towards, int side) const
{
  const auto count = static_cast<std::size_t>(side) * side;
  std::vector<unsigned char> albedo(4 * count);
  std::vector<float> surface(4 * count);
  std::vector<float> depth(count);
  this->Frame->ActivateReadBuffer(0);
  glReadPixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, albedo.data());
  this->Frame->ActivateReadBuffer(1);
  glReadPixels(0, 0, side, side, GL_RGBA, GL_FLOAT, surface.data());
  glReadPixels(0, 0, side, side, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
  glm::dvec3 right;
  glm::dvec3 up;
  AxesOf(towards, right, up);
  FramePicture picture(side);
  const std::array<float, 256> linear = LinearBytes();
  for (std::size_t k = 0; k < count; ++k)
  {
    FrameTexel& texel = picture.Texels[k];
    if (surface[4 * k + 2] <= SurfacePass::Nothing + 0.5)
    {
      continue;
    }
    const Vector3 normal = OctahedronNormal(surface[4 * k], surface[4 * k + 1]);
    texel.Coverage = 1.0F;
    texel.Albedo = { linear[albedo[4 * k]], linear[albedo[4 * k + 1]], linear[albedo[4 * k + 2]] };
    texel.Normal = glm::vec3(normal.x * right + normal.y * up + normal.z * towards);
    texel.Transmittance = std::clamp(surface[4 * k + 2], 0.0F, 1.0F);
    texel.Depth = 1.0F - 2.0F * depth[k];
  }
  return picture;
}

//----------------------------------------------------------------------------
void ImpostorAtlas::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto* texture : { &this->Colors, &this->Forms, &this->Leaves })
  {
    if (*texture)
    {
      (*texture)->ReleaseGraphicsResources(window);
    }
    *texture = nullptr;
  }
  this->Frame->ReleaseGraphicsResources(window);
}

}
