// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The default terrain with reflectance, lit from the side: a picture against its baseline.
#include "BaselinePicture.h"
#include "vtkTurningBandsTerrainSource.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkImageDataGeometryFilter.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkWarpScalar.h"

int TestTurningBandsTerrainSource(int argc, char* argv[])
{
  vtkNew<vtkTurningBandsTerrainSource> terrain;
  terrain->SetWholeExtent(0, 200, 0, 200, 0, 0);
  terrain->SetSpacing(5.0, 5.0, 1.0);
  terrain->ReflectanceOn();
  vtkNew<vtkImageDataGeometryFilter> surface;
  surface->SetInputConnection(terrain->GetOutputPort());
  vtkNew<vtkWarpScalar> relief;
  relief->SetInputConnection(surface->GetOutputPort());
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(relief->GetOutputPort());
  normals->SplittingOff();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(normals->GetOutputPort());
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray("Reflectance");
  vtkNew<vtkLookupTable> earth;
  earth->SetHueRange(0.09, 0.25);
  earth->SetSaturationRange(0.35, 0.5);
  earth->SetValueRange(0.9, 0.6);
  mapper->SetLookupTable(earth);
  mapper->SetScalarRange(0.0, 1.0);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->SetBackground(0.75, 0.82, 0.9);
  renderer->AutomaticLightCreationOff();
  vtkNew<vtkLight> sun;
  sun->SetLightTypeToSceneLight();
  sun->SetPosition(-2000.0, 100.0, 1600.0);
  sun->SetFocalPoint(500.0, 500.0, 200.0);
  renderer->AddLight(sun);
  vtkNew<vtkLight> sky;
  sky->SetLightTypeToSceneLight();
  sky->SetPosition(500.0, 0.0, 5000.0);
  sky->SetFocalPoint(500.0, 500.0, 200.0);
  sky->SetColor(0.45, 0.5, 0.6);
  renderer->AddLight(sky);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(300, 240);
  window->AddRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(500.0, -900.0, 1000.0);
  camera->SetFocalPoint(500.0, 430.0, 170.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
  return IsAsBaseline(window, argc, argv) ? EXIT_SUCCESS : EXIT_FAILURE;
}
