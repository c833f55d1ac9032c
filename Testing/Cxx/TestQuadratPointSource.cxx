// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Points by three laws, regular, random and clustered, side by side: a picture against its baseline.
#include "BaselinePicture.h"
#include "vtkQuadratPointSource.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

int TestQuadratPointSource(int argc, char* argv[])
{
  const int laws[3] = { vtkQuadratPointSource::Binomial, vtkQuadratPointSource::Poisson,
    vtkQuadratPointSource::PoissonPoisson };
  const double colors[3][3] = { { 0.2, 0.4, 0.7 }, { 0.3, 0.5, 0.25 }, { 0.75, 0.35, 0.15 } };
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.96, 0.96, 0.94);
  for (int i = 0; i < 3; ++i)
  {
    vtkNew<vtkQuadratPointSource> source;
    source->SetLaw(laws[i]);
    source->SetTrials(1);
    source->SetOrigin(1100.0 * i, 0.0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(colors[i][0], colors[i][1], colors[i][2]);
    actor->GetProperty()->SetPointSize(2.0);
    actor->GetProperty()->LightingOff();
    renderer->AddActor(actor);
  }
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(360, 130);
  window->AddRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(590.0);
  camera->SetPosition(1600.0, 500.0, 1000.0);
  camera->SetFocalPoint(1600.0, 500.0, 0.0);
  renderer->ResetCameraClippingRange();
  return IsAsBaseline(window, argc, argv) ? EXIT_SUCCESS : EXIT_FAILURE;
}
