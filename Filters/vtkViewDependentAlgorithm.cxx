// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkViewDependentAlgorithm.h"

#include "Geometry/ViewFrustum.h"
#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/CameraView.h"
#include "Pipeline/Exceptions.h"
#include "Pipeline/Mistakes.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace
{
constexpr double Degree = littoral::Pi / 180.0;

littoral::Vector3 VectorOf(const double a[3])
{
  return { a[0], a[1], a[2] };
}

void Copy(double x, double y, double z, double to[3])
{
  to[0] = x;
  to[1] = y;
  to[2] = z;
}

void Copy(const littoral::Vector3& a, double to[3])
{
  Copy(a.x, a.y, a.z, to);
}
}

//----------------------------------------------------------------------------
vtkViewDependentAlgorithm::vtkViewDependentAlgorithm()
  : ViewPoint{ 0.0, -100.0, 20.0 }
  , ViewDirection{ 0.0, 1.0, 0.0 }
  , ViewUp{ 0.0, 0.0, 1.0 }
  , ViewAngle(30.0)
  , ParallelProjection(false)
  , ParallelScale(100.0)
  , AspectRatio(16.0 / 9.0)
  , ViewHeight(1080.0)
  , DetailFactor(1.0)
  , NearDistance(60.0)
  , FarDistance(250.0)
  , MoveTolerance(0.0)
  , TurnTolerance(0.0)
{
}

//----------------------------------------------------------------------------
vtkViewDependentAlgorithm::~vtkViewDependentAlgorithm()
{
  this->Follow(nullptr);
}

//----------------------------------------------------------------------------
littoral::View vtkViewDependentAlgorithm::UnroundedView() const
{
  littoral::View view;
  view.Point = VectorOf(this->ViewPoint);
  view.Direction = VectorOf(this->ViewDirection);
  view.Up = VectorOf(this->ViewUp);
  view.Angle = this->ViewAngle * Degree;
  view.IsParallel = this->ParallelProjection;
  view.ParallelScale = this->ParallelScale;
  view.AspectRatio = this->AspectRatio;
  view.Height = this->ViewHeight;
  view.DetailFactor = this->DetailFactor;
  return view;
}

//----------------------------------------------------------------------------
littoral::View vtkViewDependentAlgorithm::RoundedView() const
{
  littoral::View view = this->UnroundedView();
  if (!this->DependsOnDirection() && littoral::WhyInvalid(view).empty())
  {
    const littoral::View any;
    view.Direction = any.Direction;
    view.Up = any.Up;
    view.AspectRatio = any.AspectRatio;
  }
  const bool rounds = this->MoveTolerance > 0.0 || this->TurnTolerance > 0.0;
  return rounds && littoral::WhyInvalid(view).empty()
    ? littoral::Rounded(view, std::max(0.0, this->MoveTolerance), std::max(0.0, this->TurnTolerance) * Degree)
    : view;
}

//----------------------------------------------------------------------------
littoral::View vtkViewDependentAlgorithm::GetView()
{
  littoral::ParameterCheck check;
  check.Require(littoral::WhyInvalid(this->UnroundedView()));
  check.NotNegative("MoveTolerance", this->MoveTolerance, "m");
  check.Range("TurnTolerance", this->TurnTolerance, 0.0, 10.0, "degrees");
  check.NotNegative("NearDistance", this->NearDistance, "m");
  check.NotNegative("FarDistance", this->FarDistance, "m");
  check.Require(this->FarDistance >= this->NearDistance,
    "NearDistance is " + littoral::TextOf(this->NearDistance) + " m and FarDistance " +
      littoral::TextOf(this->FarDistance) + " m; far must not be nearer than near.");
  littoral::Require(check.Reason());
  return this->RoundedView();
}

//----------------------------------------------------------------------------
template <typename Change>
void vtkViewDependentAlgorithm::ChangeView(const Change& change)
{
  const littoral::View before = this->RoundedView();
  change();
  if (!littoral::AreTheSame(before, this->RoundedView()))
  {
    const vtkMTimeType time = this->GetMTime();
    this->Modified();
    littoral::KeepMistakes(this, time);
  }
}

//----------------------------------------------------------------------------
void vtkViewDependentAlgorithm::SetViewPoint(double x, double y, double z)
{
  this->ChangeView([&]() { Copy(x, y, z, this->ViewPoint); });
}

//----------------------------------------------------------------------------
void vtkViewDependentAlgorithm::SetViewDirection(double x, double y, double z)
{
  this->ChangeView([&]() { Copy(x, y, z, this->ViewDirection); });
}

//----------------------------------------------------------------------------
void vtkViewDependentAlgorithm::SetViewUp(double x, double y, double z)
{
  this->ChangeView([&]() { Copy(x, y, z, this->ViewUp); });
}

//----------------------------------------------------------------------------
void vtkViewDependentAlgorithm::SetViewAngle(double angle)
{
  this->ChangeView([&]() { this->ViewAngle = angle; });
}

//----------------------------------------------------------------------------
void vtkViewDependentAlgorithm::SetParallelProjection(bool parallel)
{
  this->ChangeView([&]() { this->ParallelProjection = parallel; });
}

//----------------------------------------------------------------------------
void vtkViewDependentAlgorithm::SetParallelScale(double scale)
{
  this->ChangeView([&]() { this->ParallelScale = scale; });
}

//----------------------------------------------------------------------------
void vtkViewDependentAlgorithm::SetAspectRatio(double ratio)
{
  this->ChangeView([&]() { this->AspectRatio = ratio; });
}

//----------------------------------------------------------------------------
void vtkViewDependentAlgorithm::SetViewHeight(double height)
{
  this->ChangeView([&]() { this->ViewHeight = height; });
}

//----------------------------------------------------------------------------
void vtkViewDependentAlgorithm::SetDetailFactor(double factor)
{
  this->ChangeView([&]() { this->DetailFactor = factor; });
}

//----------------------------------------------------------------------------
void vtkViewDependentAlgorithm::Take(const littoral::View& view)
{
  this->ChangeView([&]() {
    Copy(view.Point, this->ViewPoint);
    Copy(view.Direction, this->ViewDirection);
    Copy(view.Up, this->ViewUp);
    this->ViewAngle = view.Angle / Degree;
    this->ParallelProjection = view.IsParallel;
    this->ParallelScale = view.ParallelScale;
    this->AspectRatio = view.AspectRatio;
    this->ViewHeight = view.Height;
  });
}

//----------------------------------------------------------------------------
void vtkViewDependentAlgorithm::SetCamera(vtkCamera* camera)
{
  if (camera)
  {
    this->Take(littoral::ViewOfCamera(camera, this->UnroundedView()));
  }
}

//----------------------------------------------------------------------------
void vtkViewDependentAlgorithm::Follow(vtkRenderer* renderer)
{
  if (this->Renderer)
  {
    this->Renderer->RemoveObserver(this->Observer);
  }
  this->Renderer = renderer;
  if (renderer)
  {
    this->Observer = renderer->AddObserver(vtkCommand::StartEvent, this, &vtkViewDependentAlgorithm::TakeRenderer);
  }
}

//----------------------------------------------------------------------------
void vtkViewDependentAlgorithm::TakeRenderer()
{
  const int* size = this->Renderer->GetSize();
  this->Take(littoral::ViewOfCamera(this->Renderer->GetActiveCamera(), size[0], size[1], this->UnroundedView()));
}

//----------------------------------------------------------------------------
int vtkViewDependentAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(
    this, request, outputs, [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkViewDependentAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const double a[3]) {
    os << indent << name << ": " << a[0] << " " << a[1] << " " << a[2] << "\n";
  };
  print("ViewPoint", this->ViewPoint);
  print("ViewDirection", this->ViewDirection);
  print("ViewUp", this->ViewUp);
  os << indent << "ViewAngle: " << this->ViewAngle << "\n";
  os << indent << "ParallelProjection: " << (this->ParallelProjection ? "on" : "off") << "\n";
  os << indent << "ParallelScale: " << this->ParallelScale << "\n";
  os << indent << "AspectRatio: " << this->AspectRatio << "\n";
  os << indent << "ViewHeight: " << this->ViewHeight << "\n";
  os << indent << "DetailFactor: " << this->DetailFactor << "\n";
  os << indent << "NearDistance: " << this->NearDistance << "\n";
  os << indent << "FarDistance: " << this->FarDistance << "\n";
  os << indent << "MoveTolerance: " << this->MoveTolerance << "\n";
  os << indent << "TurnTolerance: " << this->TurnTolerance << "\n";
  os << indent << "Renderer: " << this->Renderer << "\n";
}
