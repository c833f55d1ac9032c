// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The wind through the pipeline: period, pieces, threads, direction, field data, bad input, a slice as a picture.
#include "BaselinePicture.h"
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
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <array>
#include <cmath>
#include <complex>
#include <cstring>
#include <functional>
#include <iostream>
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
  good &= Fails("points, more than the bound", [](Source* s) { s->SetDimensions(1 << 20, 4096, 1024); });
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
  good &= Fails("Coherence", [](Source* s) { s->SetCoherence(2); });
  good &= Fails("at least 4", [](Source* s) { s->SetDimensions(2, 8, 8); });
  good &= Fails("Phases", [](Source* s) { s->SetPhases(-1); });
  good &= Fails("TurbulenceIntensity", [](Source* s) {
    s->SetSpectrum(Source::IECKaimal);
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

  // Carried along: what is at x at time 0 is at x + 10 samples at time 10 steps.
  const std::vector<float> later = Velocities(source, 10 * 0.125);
  for (std::size_t value = 0; value < 3 * 240; ++value)
  {
    good &= later[(value + 30) % 720] == start[value];
  }
  return Check(good, "the field is not carried along");
}

/// A component of the first line of an image at a place along it, by the definition of its Fourier series.
double SumOfWaves(const std::vector<float>& image, int component, double place)
{
  constexpr int Length = 240;
  const double unit = 2.0 * vtkMath::Pi() / Length;
  double sum = 0.0;
  for (int k = 0; k <= Length / 2; ++k)
  {
    std::complex<double> wave(0.0);
    for (int n = 0; n < Length; ++n)
    {
      wave += static_cast<double>(image[3 * n + component]) * std::polar(1.0 / Length, -unit * (k * n % Length));
    }
    sum += (k == 0 ? 1.0 : 2.0) * (wave * std::polar(1.0, unit * k * place)).real();
  }
  return sum;
}

/// Between its steps the field is that of the waves, and has the same variance: on straight lines it would pulse, by up
/// to 28 % at 1 m.
bool CheckBetweenSteps()
{
  vtkNew<Source> source;
  Prepare(source);
  const std::vector<float> start = Velocities(source, 0.0);
  const auto variances = [](const std::vector<float>& image) {
    std::array<double, 24> sums{}; // by layer and component
    for (std::size_t n = 0; n < image.size(); ++n)
    {
      const std::size_t line = n / 720;
      double mean = 0.0;
      for (std::size_t i = 0; i < 720 && n % 720 < 3; i += 3)
      {
        mean += image[720 * line + i + n % 3] / 240.0;
      }
      for (std::size_t i = 0; i < 720 && n % 720 < 3; i += 3)
      {
        sums[3 * (line / 12) + n % 3] += std::pow(image[720 * line + i + n % 3] - mean, 2.0);
      }
    }
    return sums;
  };
  const std::array<double, 24> wants = variances(start);
  double worst = 0.0;
  double off = 0.0;
  for (int part = 0; part < 16; ++part)
  {
    const double steps = 7.0 * part + part / 16.0;
    const std::vector<float> now = Velocities(source, steps * 0.125);
    const std::array<double, 24> has = variances(now);
    for (std::size_t n = 0; n < has.size(); ++n)
    {
      worst = std::max(worst, std::abs(has[n] / wants[n] - 1.0));
    }
    for (int n = 0; n < 240; n += 80)
    {
      off = std::max(off, std::abs(now[3 * n + 2] - SumOfWaves(start, 2, n - steps)));
    }
  }
  std::cout << "variance at 16 times between steps within " << worst << ", the wind within " << off << " m/s\n";
  return Check(worst < 1e-4 && off < 1e-5, "the field pulses between its steps");
}

/// The coherence of IEC 61400-1 is that of the component along the wind; the others stay, to the bit.
bool CheckCoherence()
{
  vtkNew<Source> source;
  Prepare(source);
  const std::vector<float> usual = Velocities(source, 0.0);
  source->SetCoherence(Source::IEC);
  const std::vector<float> other = Velocities(source, 0.0);
  double along = 0.0;
  double across = 0.0;
  for (std::size_t n = 0; n < usual.size(); n += 3)
  {
    along = std::max(along, static_cast<double>(std::abs(usual[n] - other[n])));
    across = std::max(across, static_cast<double>(std::abs(usual[n + 1] - other[n + 1])));
  }
  return Check(along > 0.1 && across == 0.0, "Coherence does not change the component along the wind alone");
}

bool CheckExtents()
{
  vtkNew<Source> whole;
  Prepare(whole);
  whole->SetWindDirection(30.0);
  whole->UpdateTimeStep(1.04);
  vtkNew<Source> part;
  Prepare(part);
  part->SetWindDirection(30.0);
  const int extent[6] = { 17, 60, 3, 9, 2, 2 };
  part->UpdateInformation();
  part->UpdateTimeStep(1.04, -1, 1, 0, extent);
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
  const std::vector<float> alone = Velocities(one, 1.07);
  vtkNew<Source> two;
  Prepare(two);
  vtkSMPTools::Initialize(2);
  return Check(alone == Velocities(two, 1.07), "two threads give other bytes");
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
  good &= CheckBetweenSteps();
  good &= CheckCoherence();
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
  vtkNew<vtkLookupTable> colors;
  colors->SetHueRange(0.6, 0.1);
  colors->SetValueRange(0.5, 1.0);
  colors->SetSaturationRange(0.8, 0.3);
  colors->SetVectorModeToMagnitude();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(slice->GetOutputPort());
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray("Velocity");
  mapper->SetLookupTable(colors);
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
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 500.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(140.0);
  renderer->ResetCameraClippingRange();
  return good && IsAsBaseline(window, argc, argv) ? EXIT_SUCCESS : EXIT_FAILURE;
}
