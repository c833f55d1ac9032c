// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DepthMaps.h"
#include "BoundFrame.h"
#include "CasterState.h"
#include "OpenGL.h"
#include "vtkLandscapePass.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCommunicator.h"
#include "vtkInformation.h"
#include "vtkInformationIdTypeKey.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr double MiddleShare = 0.15; // of the distance, to which the near map reaches
constexpr double Slack = 1.25;       // of a map's radius over what it must cover: turns by some degrees move none
constexpr double HasteSlack = 2.0;   // the same in haste: a drag moves few
constexpr double HasteTexel = 0.6;   // the longest texels of maps of all, which no drag moves, in haste [m]

constexpr double LeavesToldApart = 0.2; // the longest texels of maps in which they are [m]

vtkBoundingBox BoundsOf(const std::vector<vtkProp*>& props)
{
  vtkBoundingBox box;
  for (vtkProp* prop : props)
  {
    const double* bounds = prop->GetUseBounds() ? prop->GetBounds() : nullptr;
    if (bounds && vtkBoundingBox::IsValid(bounds))
    {
      box.AddBounds(bounds);
    }
  }
  return box;
}

/// Whether there are others.
bool AreSeveral(vtkMultiProcessController* processes)
{
  return processes && processes->GetNumberOfProcesses() > 1;
}

/// The box around those of all processes.
vtkBoundingBox Joint(const vtkBoundingBox& own, vtkMultiProcessController* processes)
{
  if (!AreSeveral(processes))
  {
    return own;
  }
  // Least x, y, z and least -x, -y, -z
  double ends[6];
  double all[6];
  for (int axis = 0; axis < 3; ++axis)
  {
    ends[axis] = own.GetMinPoint()[axis];
    ends[axis + 3] = -own.GetMaxPoint()[axis];
  }
  processes->AllReduce(ends, all, 6, vtkCommunicator::MIN_OP);
  vtkBoundingBox joint;
  joint.SetBounds(all[0], -all[3], all[1], -all[4], all[2], -all[5]);
  return joint;
}

/// The least sphere around a part of the view's cone, from one distance to another, on the line of sight.
void SphereOf(vtkCamera* camera, double aspect, double from, double to, glm::dvec3& center, double& radius)
{
  glm::dvec3 eye;
  glm::dvec3 ahead;
  camera->GetPosition(&eye.x);
  camera->GetDirectionOfProjection(&ahead.x);
  double slope = std::tan(0.5 * camera->GetViewAngle() * 0.017453292519943295);
  if (camera->GetUseHorizontalViewAngle())
  {
    slope /= aspect;
  }
  const double corner = slope * std::hypot(1.0, aspect);
  if (camera->GetParallelProjection())
  {
    center = eye + 0.5 * (from + to) * ahead;
    radius = std::hypot(camera->GetParallelScale() * std::hypot(1.0, aspect), 0.5 * (to - from));
    return;
  }
  // On the line of sight at s: (s - from)^2 + (c from)^2 = (to - s)^2 + (c to)^2, not beyond `to`
  const double s = std::min(0.5 * (from + to) * (1.0 + corner * corner), to);
  center = eye + s * ahead;
  radius = std::hypot(to - s, corner * to);
}

}

//----------------------------------------------------------------------------
DepthMaps::DepthMaps() = default;
DepthMaps::~DepthMaps() = default;

//----------------------------------------------------------------------------
vtkSmartPointer<vtkTextureObject> DepthMaps::NewTexture(vtkOpenGLRenderWindow* window, int size, bool compares)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->AllocateDepth(static_cast<unsigned int>(size), static_cast<unsigned int>(size), vtkTextureObject::Float32);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(vtkTextureObject::Linear);
  texture->SetLinearMagnification(true);
  texture->SetDepthTextureCompare(compares);
  texture->SetDepthTextureCompareFunction(vtkTextureObject::Lequal);
  return texture;
}

//----------------------------------------------------------------------------
vtkTextureObject* DepthMaps::TextureOf(int map) const
{
  return map == Ground ? this->OfGround : this->Light;
}

//----------------------------------------------------------------------------
/// First column and row of a map in its texture.
glm::ivec2 DepthMaps::CornerOf(int map) const
{
  return map == Ground ? glm::ivec2(0) : this->Size * glm::ivec2(map % 2, map / 2);
}

//----------------------------------------------------------------------------
void DepthMaps::Allocate(vtkOpenGLRenderWindow* window, int size)
{
  if (this->Size == size)
  {
    return;
  }
  this->Size = size;
  this->Light = NewTexture(window, 2 * size);
  this->OfGround = NewTexture(window, size, false);
  this->Places = {};
}

//----------------------------------------------------------------------------
DepthMaps::Place DepthMaps::PlaceOf(int map, vtkRenderer* renderer, const Whole& whole, const Wish& wish) const
{
  Place place;
  place.Depth = 1.001 * whole.Radius;
  place.Towards = map >= Zenith ? glm::dvec3(0.0, 0.0, 1.0) : wish.Sun;
  const double near = std::min(MiddleShare * wish.Distance, whole.Radius);
  const double far = std::min(wish.Distance, whole.Radius);
  const double from[Count] = { 0.0, near, 0.0, 0.0, 0.0 };
  const double to[Count] = { near, far, 0.0, far, 0.0 };
  const double slack = wish.IsInHaste && map != Ground ? HasteSlack : Slack;
  if (map == Ground)
  {
    renderer->GetActiveCamera()->GetPosition(&place.Center.x);
    place.Radius = slack * wish.GroundRadius;
  }
  else if (map != SunMaps - 1)
  {
    SphereOf(
      renderer->GetActiveCamera(), renderer->GetTiledAspectRatio(), from[map], to[map], place.Center, place.Radius);
    place.Radius *= slack;
  }
  const bool areSharp = wish.IsInHaste && 2.0 * whole.Radius <= HasteTexel * wish.Size;
  const bool isAll = map == SunMaps - 1 || (map != Ground && (areSharp || place.Radius > whole.Radius));
  if (isAll)
  {
    place.Center = whole.Center;
    place.Radius = 1.001 * whole.Radius;
  }
  // Rays to the zenith are tried at distances from 0.4 of that of what hides the sky: a tenth of it is not told apart.
  const double texel = 2.0 * place.Radius / wish.Size;
  const double toldApart = map == Zenith ? std::max(texel, 0.1 * wish.Occlusion) : texel;
  place.IsCoarse = map != Ground && (wish.IsInHaste || toldApart > LeavesToldApart);
  place.State = place.IsCoarse ? whole.CoarseState : whole.State;
  // Axes of the map: two across the light
  const glm::dvec3 other = std::abs(place.Towards.z) < 0.99 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 right = glm::normalize(glm::cross(other, place.Towards));
  const glm::dvec3 up = glm::cross(place.Towards, right);
  // The center moves by whole texels, some at once, at the depth of the middle of all; the slack covers the steps.
  const double step = std::max(1.0, std::floor((slack - 1.0) / slack * place.Radius / texel)) * texel;
  const auto moved = [&](double distance) { return isAll ? distance : step * std::floor(distance / step + 0.5); };
  const glm::dvec3 off = place.Center - whole.Center;
  place.Center = whole.Center + moved(glm::dot(off, right)) * right + moved(glm::dot(off, up)) * up;
  const glm::dmat4 view = glm::lookAt(place.Center + place.Depth * place.Towards, place.Center, up);
  const glm::dmat4 projection =
    glm::ortho(-place.Radius, place.Radius, -place.Radius, place.Radius, 0.0, 2.0 * place.Depth);
  place.ToMap =
    glm::translate(glm::dmat4(1.0), glm::dvec3(0.5)) * glm::scale(glm::dmat4(1.0), glm::dvec3(0.5)) * projection * view;
  return place;
}

//----------------------------------------------------------------------------
bool DepthMaps::Draw(vtkRenderer* renderer, const std::vector<vtkProp*>& shown, const std::vector<vtkProp*>& casters,
  const Wish& wish, const Drawing& drawCasters, vtkMultiProcessController* processes)
{
  const vtkBoundingBox box = Joint(BoundsOf(shown), processes);
  const bool isShown = box.IsValid() && box.GetDiagonalLength() > 0.0;
  Whole whole;
  this->Radius = isShown ? 0.5 * box.GetDiagonalLength() : 0.0;
  this->Lowest = isShown ? box.GetMinPoint()[2] : 0.0;
  this->Highest = isShown ? box.GetMaxPoint()[2] : 0.0;
  if (isShown)
  {
    this->Allocate(static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()), wish.Size);
    box.GetCenter(&whole.Center.x);
    whole.Radius = this->Radius;
    whole.State = StateOf(casters, false);
    whole.CoarseState = StateOf(casters, true);
  }
  std::array<int, Count> areOld{};
  for (int map = 0; map < Count; ++map)
  {
    Place& last = this->Places[map];
    const bool isWanted = map == Ground ? wish.GroundRadius > 0.0 : map == Zenith ? wish.HasZenith : wish.HasSun;
    if (!isShown || !isWanted)
    {
      last = Place();
      continue;
    }
    const Place place = this->PlaceOf(map, renderer, whole, wish);
    // In haste that of all does for the one near the eye, and for the middle one where it is as large.
    last.IsIdle = wish.IsInHaste && (map == 0 || (map == 1 && place.Radius > whole.Radius));
    if (last.IsIdle)
    {
      continue;
    }
    areOld[map] = last.State != place.State || last.Center != place.Center || last.Towards != place.Towards ||
      last.Radius != place.Radius || last.Depth != place.Depth;
    last = place;
  }
  if (AreSeveral(processes))
  {
    const std::array<int, Count> own = areOld;
    processes->AllReduce(own.data(), areOld.data(), Count, vtkCommunicator::MAX_OP);
  }
  for (int map = 0; map < Count; ++map)
  {
    if (areOld[map])
    {
      this->DrawOne(map, renderer, drawCasters, processes);
    }
  }
  return std::any_of(areOld.begin(), areOld.end(), [](int isOld) { return isOld != 0; });
}

//----------------------------------------------------------------------------
/// What the map can do without, for mappers, as keys of its camera.
void DepthMaps::TellMappers(int map)
{
  vtkNew<vtkInformation> about;
  if (this->IsCoarse(map))
  {
    about->Set(vtkLandscapePass::COARSE_MAP(), 1);
  }
  this->Camera->SetInformation(about);
}

//----------------------------------------------------------------------------
void DepthMaps::DrawOne(
  int map, vtkRenderer* renderer, const Drawing& drawCasters, vtkMultiProcessController* processes)
{
  this->TellMappers(map);
  const Place& place = this->Places[map];
  const glm::dmat4 projection =
    glm::ortho(-place.Radius, place.Radius, -place.Radius, place.Radius, 0.0, 2.0 * place.Depth);
  const glm::dvec3 end = place.Center + place.Depth * place.Towards;
  const glm::dvec3 up(place.ToMap[0][1], place.ToMap[1][1], place.ToMap[2][1]);
  this->Camera->SetPosition(end.x, end.y, end.z);
  this->Camera->SetFocalPoint(place.Center.x, place.Center.y, place.Center.z);
  this->Camera->SetViewUp(up.x, up.y, up.z);
  this->Camera->ParallelProjectionOn();
  this->Camera->SetParallelScale(place.Radius);
  this->Camera->SetClippingRange(1e-3 * place.Depth, 2.0 * place.Depth);
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      matrix->SetElement(row, column, projection[column][row]);
    }
  }
  this->Camera->SetExplicitProjectionTransformMatrix(matrix);
  this->Camera->UseExplicitProjectionTransformMatrixOn();

  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  BoundFrame bound(window, this->Frame, {}, this->TextureOf(map));
  const glm::ivec2 corner = this->CornerOf(map);
  bound.SetSquare(corner.x, corner.y, this->Size); // another map stays as it is
  bound.Clear(0.0);

  vtkSmartPointer<vtkCamera> eye = renderer->GetActiveCamera();
  renderer->SetActiveCamera(this->Camera);
  drawCasters(map);
  renderer->SetActiveCamera(eye);

  if (AreSeveral(processes))
  {
    this->TakeNearest(map, processes);
  }
}

//----------------------------------------------------------------------------
/// The nearest of the depths that the processes have drawn, while the frame is bound.
void DepthMaps::TakeNearest(int map, vtkMultiProcessController* processes)
{
  const auto count = static_cast<std::size_t>(this->Size) * this->Size;
  std::vector<float> own(count);
  std::vector<float> nearest(count);
  const glm::ivec2 corner = this->CornerOf(map);
  glReadPixels(corner.x, corner.y, this->Size, this->Size, GL_DEPTH_COMPONENT, GL_FLOAT, own.data());
  processes->AllReduce(own.data(), nearest.data(), static_cast<vtkIdType>(count), vtkCommunicator::MIN_OP);
  vtkTextureObject* texture = this->TextureOf(map);
  texture->Activate();
  glTexSubImage2D(
    GL_TEXTURE_2D, 0, corner.x, corner.y, this->Size, this->Size, GL_DEPTH_COMPONENT, GL_FLOAT, nearest.data());
  texture->Deactivate();
}

//----------------------------------------------------------------------------
void DepthMaps::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto* texture : { &this->Light, &this->OfGround })
  {
    if (*texture)
    {
      (*texture)->ReleaseGraphicsResources(window);
    }
    *texture = nullptr;
  }
  this->Frame->ReleaseGraphicsResources(window);
  this->Size = 0;
}

}
