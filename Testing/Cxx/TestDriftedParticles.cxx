// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Particles in a uniform flow, a vortex, a source and a sink, early and late, colored by their box: a picture against
// its baseline.
#include "BaselinePicture.h"
#include "vtkCurrentDriftFilter.h"
#include "vtkFlowPrimitiveSource.h"
#include "vtkSuspendedParticleSource.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

namespace
{

void AddFlow(vtkCurrentDriftFilter* drift, int type, double strength, double x, double y)
{
  vtkNew<vtkFlowPrimitiveSource> flow;
  flow->SetFlowType(type);
  flow->SetStrength(strength);
  flow->SetCenter(x, y, -1.0);
  flow->SetAxis(
    type == vtkFlowPrimitiveSource::Vortex ? 0.0 : 1.0, 0.0, type == vtkFlowPrimitiveSource::Vortex ? 1.0 : 0.0);
  drift->AddCurrentConnection(flow->GetOutputPort());
}

}

int TestDriftedParticles(int argc, char* argv[])
{
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(400, 200);
  for (int late = 0; late < 2; ++late)
  {
    vtkNew<vtkSuspendedParticleSource> particles;
    particles->SetPreset(vtkSuspendedParticleSource::Custom);
    particles->SetAmountIs(vtkSuspendedParticleSource::Count);
    for (int row = 0; row < 4; ++row)
    {
      const double box[12] = { -5.0, 5.0, 2.5 * row - 5.0, 2.5 * row - 2.5, -1.1, -0.9, 1.0, 0.01, 700.0,
        1.0 - 0.3 * row, 0.35 + 0.18 * row, 0.15 + 0.28 * row };
      particles->AddBox(box);
    }
    vtkNew<vtkCurrentDriftFilter> drift;
    drift->SetInputConnection(0, particles->GetOutputPort());
    drift->SetWaterDepth(2.0);
    AddFlow(drift, vtkFlowPrimitiveSource::Uniform, 0.05, 0.0, 0.0);
    AddFlow(drift, vtkFlowPrimitiveSource::Vortex, 16.0, -1.5, 1.0);
    AddFlow(drift, vtkFlowPrimitiveSource::Source, 8.0, -2.5, -3.0);
    AddFlow(drift, vtkFlowPrimitiveSource::Sink, 8.0, 3.0, -1.0);
    drift->UpdateTimeStep(late ? 7.3 : 1.5);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(drift->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetPointSize(2.0);
    actor->GetProperty()->LightingOff();
    vtkNew<vtkRenderer> renderer;
    renderer->SetViewport(0.5 * late, 0.0, 0.5 + 0.5 * late, 1.0);
    renderer->SetBackground(0.02, 0.10 + 0.03 * late, 0.17 + 0.03 * late);
    renderer->AddActor(actor);
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(5.4);
    camera->SetPosition(0.0, 0.0, 20.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    renderer->ResetCameraClippingRange();
    window->AddRenderer(renderer);
  }
  return IsAsBaseline(window, argc, argv) ? EXIT_SUCCESS : EXIT_FAILURE;
}
