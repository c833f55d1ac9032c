// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// A piece of a windy sea in low light: a picture against its baseline.
#include "BaselinePicture.h"
#include "vtkParticleOrbitFilter.h"
#include "vtkSeaStateSource.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

int TestSeaSurface(int argc, char* argv[])
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0.0, 0.0, 0.0);
  plane->SetPoint1(120.0, 0.0, 0.0);
  plane->SetPoint2(0.0, 120.0, 0.0);
  plane->SetResolution(240, 240);
  vtkNew<vtkSeaStateSource> sea;
  sea->SetWindSpeed(8.0);
  sea->SetMeanDirection(-60.0);
  sea->SetNumberOfTrains(60);
  vtkNew<vtkParticleOrbitFilter> surface;
  surface->SetInputConnection(0, plane->GetOutputPort());
  surface->SetSeaStateConnection(sea->GetOutputPort());
  surface->SetChoppiness(0.8);
  surface->UpdateTimeStep(7.3);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(surface->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.10, 0.34, 0.42);
  actor->GetProperty()->SetAmbient(0.25);
  actor->GetProperty()->SetDiffuse(0.8);
  actor->GetProperty()->SetSpecular(0.7);
  actor->GetProperty()->SetSpecularPower(40.0);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.86, 0.90, 0.93);
  renderer->AddActor(actor);
  vtkNew<vtkLight> sun;
  sun->SetPosition(60.0, 400.0, 130.0);
  sun->SetFocalPoint(60.0, 60.0, 0.0);
  renderer->AddLight(sun);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(300, 200);
  window->AddRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(60.0, -45.0, 28.0);
  camera->SetFocalPoint(60.0, 55.0, -6.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
  return IsAsBaseline(window, argc, argv) ? EXIT_SUCCESS : EXIT_FAILURE;
}
