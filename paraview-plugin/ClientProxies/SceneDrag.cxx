// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneDrag.h"

#include "FirstCamera.h"

#include "Numerics/Constants.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"

#include <algorithm>
#include <cmath>

namespace littoral
{
namespace
{

/// Priority of an observer before those that take the camera.
constexpr float BeforeOthers = 20.0f;

/// Height of the eye over the bed and depth below the surface of a shallow sea, as shares of its depth.
constexpr double OverBed = 0.1;
constexpr double UnderSurface = 0.3;

/// Steepest sight of what is dragged, down or up [rad]: at the pole the horizon turns round.
constexpr double Steepest = 85.0 * Pi / 180.0;

/// Rounding of a turn, as a share of its radius.
constexpr double Rounding = 1e-9;

/// Whether two points are the same, but for the rounding of a turn of that radius.
bool AreSame(const Vector3& a, const Vector3& b, double radius)
{
  return glm::distance(a, b) <= Rounding * radius;
}

/// Whether the horizon of a sight is level, and the sky above.
bool IsUpright(const Vector3& arm, const Vector3& up)
{
  return up.z > 0.0 && std::abs(Normalised(glm::cross(arm, up)).z) < 1e-3;
}

/// Value of a property of one number; another one if the proxy has none of that name.
double ValueOf(vtkSMProxy* proxy, const char* name, double other)
{
  vtkSMProperty* property = proxy ? proxy->GetProperty(name) : nullptr;
  return property ? vtkSMPropertyHelper(property).GetAsDouble() : other;
}

/// Eye at a distance from a focus, in a horizontal direction (dx, dy), as high over it as z.
Vector3 EyeAt(const Vector3& focus, double distance, double dx, double dy, double z)
{
  const double horizontal = std::sqrt(std::max(0.0, distance * distance - z * z)) / std::max(1e-12, std::hypot(dx, dy));
  return { focus.x + horizontal * dx, focus.y + horizontal * dy, focus.z + z };
}

}

//----------------------------------------------------------------------------
SceneDrag::~SceneDrag()
{
  if (this->View)
  {
    this->View->RemoveObserver(this->Observer);
  }
}

//----------------------------------------------------------------------------
void SceneDrag::Keep(vtkSMRenderViewProxy* view, vtkSMProxy* source, const EyeHeights& heights)
{
  if (this->View)
  {
    this->View->RemoveObserver(this->Observer);
  }
  this->View = view;
  this->Source = source;
  this->Heights = heights;
  this->IsKept = false;
  if (view)
  {
    this->Observer = view->AddObserver(vtkCommand::StartEvent, this, &SceneDrag::OnStart, BeforeOthers);
  }
}

//----------------------------------------------------------------------------
void SceneDrag::ScaleDepths(double ratio, std::vector<vtkSMRenderViewProxy*> views)
{
  const double level = ValueOf(this->Source, "SeaLevel", 0.0);
  if (this->View && std::find(views.begin(), views.end(), this->View) == views.end())
  {
    views.push_back(this->View);
  }
  for (vtkSMRenderViewProxy* view : views)
  {
    vtkCamera* camera = view->GetActiveCamera();
    const Sight sight = SightOf(camera);
    if (sight.Eye.z < level)
    {
      camera->SetPosition(sight.Eye.x, sight.Eye.y, level + ratio * (sight.Eye.z - level));
      camera->SetFocalPoint(sight.Focus.x, sight.Focus.y, level + ratio * (sight.Focus.z - level));
      TurnAboutFocus(view);
    }
  }
}

//----------------------------------------------------------------------------
SceneDrag::Sight SceneDrag::SightOf(vtkCamera* camera)
{
  Sight sight;
  camera->GetPosition(sight.Eye.x, sight.Eye.y, sight.Eye.z);
  camera->GetFocalPoint(sight.Focus.x, sight.Focus.y, sight.Focus.z);
  camera->GetViewUp(sight.Up.x, sight.Up.y, sight.Up.z);
  return sight;
}

//----------------------------------------------------------------------------
EyeHeights SceneDrag::Limits() const
{
  const double level = ValueOf(this->Source, "SeaLevel", 0.0);
  const double depth = ValueOf(this->Source, "WaterDepth", 0.0);
  EyeHeights limits = { this->Heights.Elevation, level + this->Heights.Lowest, level + this->Heights.Highest };
  if (this->Heights.Highest < 0.0 && depth > 0.0)
  {
    limits.Lowest = std::max(limits.Lowest, level - (1.0 - OverBed) * depth);
    limits.Highest = std::max(limits.Highest, level - UnderSurface * depth);
  }
  return limits;
}

//----------------------------------------------------------------------------
SceneDrag::Sight SceneDrag::Kept(const Sight& dragged) const
{
  Sight kept = dragged;
  const Vector3 arm = dragged.Eye - dragged.Focus;
  const Vector3 former = this->Former.Eye - this->Former.Focus;
  const double distance = glm::length(arm);
  const bool isOverPole = dragged.Up.z < 0.0;
  // No steeper than the steepest, no flatter than the least: z = max(d sin e, min(arm_z, d sin a))
  const EyeHeights limits = this->Limits();
  const double highest = distance * std::sin(Steepest);
  const double least = std::max(-highest, distance * std::sin(limits.Elevation * Pi / 180.0));
  const double rise = std::max(least, std::min(isOverPole ? std::copysign(highest, arm.z) : arm.z, highest));
  const Vector3& side = isOverPole ? former : arm;
  kept.Eye = EyeAt(dragged.Focus, distance, side.x, side.y, rise);
  // Back to its side: turned about a focus at rest, else moved with it
  const double missing = std::max(limits.Lowest, std::min(kept.Eye.z, limits.Highest)) - kept.Eye.z;
  if (missing != 0.0 && AreSame(dragged.Focus, this->Former.Focus, distance) && std::abs(rise + missing) < highest)
  {
    kept.Eye = EyeAt(dragged.Focus, distance, side.x, side.y, rise + missing);
  }
  else
  {
    kept.Eye.z += missing;
    kept.Focus.z += missing;
  }
  kept.Up = { 0.0, 0.0, 1.0 };
  return kept;
}

//----------------------------------------------------------------------------
void SceneDrag::OnStart(vtkObject*, unsigned long, void* isInteractive)
{
  vtkCamera* camera = this->View->GetActiveCamera();
  Sight sight = SightOf(camera);
  const Vector3 arm = sight.Eye - sight.Focus;
  const double distance = glm::length(arm);
  if (!isInteractive || *static_cast<int*>(isInteractive) == 0)
  {
    const EyeHeights limits = this->Limits();
    const double rounding = Rounding * distance; // of what an earlier drag has left at a limit
    this->IsKept = arm.z >= distance * std::sin(limits.Elevation * Pi / 180.0) - rounding &&
      sight.Eye.z >= limits.Lowest - rounding && sight.Eye.z <= limits.Highest + rounding && IsUpright(arm, sight.Up);
  }
  else if (this->IsKept)
  {
    const bool isAtRest =
      AreSame(sight.Eye, this->Former.Eye, distance) && AreSame(sight.Focus, this->Former.Focus, distance);
    this->IsKept = !isAtRest || IsUpright(arm, sight.Up); // else it is rolled
    if (this->IsKept && !isAtRest)
    {
      sight = this->Kept(sight);
      camera->SetPosition(sight.Eye.x, sight.Eye.y, sight.Eye.z);
      camera->SetFocalPoint(sight.Focus.x, sight.Focus.y, sight.Focus.z);
      camera->SetViewUp(sight.Up.x, sight.Up.y, sight.Up.z);
    }
  }
  this->Former = sight;
}

}
