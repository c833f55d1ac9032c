// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The wind through the pipeline: period, pieces, threads, direction, field data, bad input, a slice as a picture.
#include "Check.h"
#include "ErrorCounter.h"
#include "vtkWindFieldSource.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkImageDataGeometryFilter.h"
#include "vtkInformation.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <vector>

namespace
{

using Source = vtkWindFieldSource;

bool Fails(const char* word, const std::function<void(Source*)>& spoil)
{
  vtkNew<Source> source;
  spoil(source);
  vtkNew<ErrorCounter> errors;
  errors->Watch(source);
  return errors->ExpectOneNaming(word) && Check(source->GetOutput()->GetNumberOfPoints() == 0, "output not empty");
}

bool CheckBadInput()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  bool good = true;
  good &= Fails("The next good one is 640", [](Source* s) { s->SetDimensions(601, 8, 8); });
  good &= Fails("Dimensions", [](Source* s) { s->SetDimensions(600, 0, 8); });
  good &= Fails("memory", [](Source* s) { s->SetDimensions(1 << 20, 4096, 1024); });
  good &= Fails("TimeStep", [](Source* s) { s->SetTimeStep(0.0); });
  good &= Fails("TimeStep", [=](Source* s) { s->SetTimeStep(nan); });
  good &= Fails("LateralSpacing", [](Source* s) { s->SetLateralSpacing(-1.0); });
  good &= Fails("VerticalSpacing", [](Source* s) { s->SetVerticalSpacing(0.0); });
  good &= Fails("BottomHeight", [](Source* s) { s->SetRoughnessLength(1.0); });
  good &= Fails("ReferenceHeight", [](Source* s) { s->SetReferenceHeight(0.01); });
  good &= Fails("RoughnessLength", [=](Source* s) { s->SetRoughnessLength(nan); });
  good &= Fails("ReferenceSpeed", [](Source* s) { s->SetReferenceSpeed(0.0); });
  good &= Fails("WindDirection", [=](Source* s) { s->SetWindDirection(nan); });
  good &= Fails("Center", [=](Source* s) { s->SetCenter(0.0, nan); });
  good &= Fails("VerticalDecay", [](Source* s) { s->SetVerticalDecay(8.0, 0.0); });
  good &= Fails("Spectrum", [](Source* s) { s->SetSpectrum(2); });
  good &= Fails("Phases", [](Source* s) { s->SetPhases(-1); });
  good &= Fails("TurbulenceIntensity", [](Source* s) {
    s->SetSpectrum(Source::IecKaimal);
    s->SetTurbulenceIntensity(0.0);
  });
  return good;
}

void Prepare(Source* source)
{
  source->SetDimensions(240, 12, 8);
  source->SetTimeStep(0.125);
}

std::vector<float> Velocities(Source* source, double time)
{
  source->UpdateInformation();
  source->UpdateTimeStep(time);
  vtkFloatArray* array = vtkFloatArray::SafeDownCast(source->GetOutput()->GetPointData()->GetArray("Velocity"));
  return { array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues() };
}

bool CheckTime()
{
  vtkNew<Source> source;
  Prepare(source);
  const std::vector<float> start = Velocities(source, 0.0);
  const double period = 240 * 0.125;
  bool good = true;
  for (double time : { 0.0, 0.125, 3.0, 7.77, 29.99 })
  {
    const std::vector<float> once = Velocities(source, time);
    good &= Check(once == Velocities(source, time + period), "another period has other bytes");
    good &= Check(once == Velocities(source, time - 3.0 * period), "an earlier period has other bytes");
  }
  good &= Check(Velocities(source, period) == start, "the end is not the start");

  // Carried along: what is at x at time 0 is at x + 10 samples at time 10 steps. In between, in between.
  const std::vector<float> later = Velocities(source, 10 * 0.125);
  const std::vector<float> half = Velocities(source, 10.5 * 0.125);
  const std::vector<float> next = Velocities(source, 11 * 0.125);
  double worst = 0.0;
  for (std::size_t value = 0; value < 3 * 240; ++value)
  {
    const std::size_t shifted = (value + 30) % 720;
    good &= later[shifted] == start[value];
    worst = std::max(worst, std::abs(half[value] - 0.5 * (later[value] + next[value])));
  }
  good &= Check(worst < 1e-6, "between steps the field is not interpolated");
  return Check(good, "the field is not carried along");
}

bool CheckExtents()
{
  vtkNew<Source> whole;
  Prepare(whole);
  whole->SetWindDirection(30.0);
  whole->Update();
  vtkNew<Source> part;
  Prepare(part);
  part->SetWindDirection(30.0);
  const int extent[6] = { 17, 60, 3, 9, 2, 2 };
  part->UpdateExtent(extent);
  bool good = true;
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        int index[3] = { i, j, k };
        const vtkIdType a = whole->GetOutput()->ComputePointId(index);
        const vtkIdType b = part->GetOutput()->ComputePointId(index);
        for (int component = 0; component < 3; ++component)
        {
          good &= whole->GetOutput()->GetPointData()->GetArray("Velocity")->GetComponent(a, component) ==
            part->GetOutput()->GetPointData()->GetArray("Velocity")->GetComponent(b, component);
        }
        double here[3];
        double there[3];
        whole->GetOutput()->GetPoint(a, here);
        part->GetOutput()->GetPoint(b, there);
        good &= here[0] == there[0] && here[1] == there[1] && here[2] == there[2];
      }
    }
  }
  return Check(good, "a part differs from the whole");
}

bool CheckDirection()
{
  vtkNew<Source> east;
  Prepare(east);
  vtkNew<Source> north;
  Prepare(north);
  north->SetWindDirection(90.0);
  north->SetCenter(50.0, -20.0);
  const std::vector<float> a = Velocities(east, 1.0);
  const std::vector<float> b = Velocities(north, 1.0);
  bool good = true;
  for (std::size_t n = 0; n < a.size(); n += 3)
  {
    good &= std::abs(a[n] - b[n + 1]) < 1e-5 && std::abs(a[n + 1] + b[n]) < 1e-5 && a[n + 2] == b[n + 2];
  }
  good = Check(good, "velocities are not turned");
  double p[3];
  double q[3];
  for (vtkIdType id : { 0, 239, 240 * 12 * 8 - 1 })
  {
    east->GetOutput()->GetPoint(id, p);
    north->GetOutput()->GetPoint(id, q);
    good &= Check(std::abs(q[0] - 50.0 + p[1]) < 1e-9 && std::abs(q[1] + 20.0 - p[0]) < 1e-9 && p[2] == q[2],
      "points are not turned about the center");
  }
  return good;
}

bool CheckThreads()
{
  vtkNew<Source> one;
  Prepare(one);
  vtkSMPTools::Initialize(1);
  const std::vector<float> alone = Velocities(one, 1.0);
  vtkNew<Source> two;
  Prepare(two);
  vtkSMPTools::Initialize(2);
  return Check(alone == Velocities(two, 1.0), "two threads give other bytes");
}

bool CheckFieldData()
{
  vtkNew<Source> source;
  Prepare(source);
  source->Update();
  vtkFieldData* fields = source->GetOutput()->GetFieldData();
  const auto number = [fields](const char* name) {
    vtkDataArray* array = fields->GetArray(name);
    return array ? array->GetTuple1(0) : -1.0;
  };
  bool good = true;
  good &= Check(std::abs(number("FrictionVelocity") - 4.0 / std::log(10.0 / 0.03)) < 1e-12, "another u*");
  good &= Check(number("ConvectionSpeed") == 10.0 && number("Period") == 30.0, "another speed or period");
  good &= Check(number("CoherenceError") > 0.0 && number("CoherenceError") < 0.03, "another coherence error");
  double* range = source->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
  good &= Check(range && range[0] == 0.0 && range[1] == 30.0, "another time range");
  good &= Check(
    source->GetOutputInformation(0)->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()) == 240, "not 240 times");
  return good;
}

}

int TestWindFieldSource(int argc, char* argv[])
{
  bool good = CheckTime();
  good &= CheckExtents();
  good &= CheckDirection();
  good &= CheckThreads();
  good &= CheckFieldData();
  good &= CheckBadInput();

  vtkNew<Source> source;
  source->SetDimensions(240, 48, 8);
  source->SetWindDirection(20.0);
  source->UpdateTimeStep(12.5);
  vtkNew<vtkImageDataGeometryFilter> slice;
  slice->SetInputConnection(source->GetOutputPort());
  slice->SetExtent(0, 239, 0, 47, 4, 4);
  vtkNew<vtkLookupTable> colours;
  colours->SetHueRange(0.6, 0.1);
  colours->SetValueRange(0.5, 1.0);
  colours->SetSaturationRange(0.8, 0.3);
  colours->SetVectorModeToMagnitude();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(slice->GetOutputPort());
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray("Velocity");
  mapper->SetLookupTable(colours);
  mapper->SetScalarRange(4.0, 16.0);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->SetBackground(0.9, 0.92, 0.95);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(300, 240);
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 500.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(140.0);
  renderer->ResetCameraClippingRange();
  window->Render();
  int result = vtkRegressionTestImage(window);
  if (result == vtkRegressionTester::DO_INTERACTOR)
  {
    interactor->Start();
  }
  return good && result ? EXIT_SUCCESS : EXIT_FAILURE;
}
