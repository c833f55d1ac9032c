// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Fog of particles and of their levels, through the pipeline: cross sections, parts of the image, threads, every bad
// input.
#include "Check.h"
#include "ErrorCounter.h"
#include "FilledArray.h"
#include "SeaParticles.h"
#include "vtkParticleFogFilter.h"
#include "vtkParticleLevelOfDetailFilter.h"
#include "vtkSeaStateSource.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <string>

using namespace littoral::testing;

namespace
{

using Levels = vtkParticleLevelOfDetailFilter;
using Fog = vtkParticleFogFilter;
using Sea = vtkSeaStateSource;

/// 20000 particles of two radii, with the sum of their cross sections [m2].
vtkSmartPointer<vtkPolyData> ParticlesOfTwoSizes(double& section)
{
  vtkSmartPointer<vtkPolyData> particles = Particles(20000).Get();
  vtkNew<vtkFloatArray> radius;
  radius->SetName("Radius");
  section = 0.0;
  for (int n = 0; n < 20000; ++n)
  {
    radius->InsertNextValue(n % 2 ? 0.01f : 0.02f);
    section += vtkMath::Pi() * radius->GetValue(n) * radius->GetValue(n);
  }
  particles->GetPointData()->AddArray(radius);
  return particles;
}

/// The image of particles that are all fog has their cross sections.
bool CheckFog()
{
  double section = 0.0;
  const auto particles = ParticlesOfTwoSizes(section);
  vtkNew<Fog> fog;
  fog->SetInputData(particles);
  fog->SetDimensions(20, 24, 11);
  fog->Update();
  vtkImageData* image = fog->GetOutput();
  vtkDataArray* extinction = image->GetPointData()->GetScalars();
  bool good = Check(
    extinction && std::string(extinction->GetName()) == "Extinction" && image->GetNumberOfPoints() == 20 * 24 * 11,
    "no image of extinction");
  good &= Check(std::abs(Counter(fog, "CrossSection") / section - 1.0) < 1e-5, "cross sections are lost");
  const double volume = 16.0 * 22.0 * 9.0;
  const double center = extinction->GetTuple1(image->vtkDataSet::FindPoint(0.0, 9.0, -4.5));
  good &= Check(center > 0.2 * section / volume && center < 3.0 * section / volume, "another extinction");
  return good;
}

/// Fog that is kept is that of the particles as they are.
bool CheckFogOfChangedParticles()
{
  double section = 0.0;
  const auto particles = ParticlesOfTwoSizes(section);
  vtkNew<Fog> fog;
  fog->SetInputData(particles);
  fog->SetDimensions(20, 24, 11);
  fog->Update();
  vtkNew<vtkImageData> before;
  before->DeepCopy(fog->GetOutput());
  particles->Modified();
  fog->Update();
  bool good = true;
  for (vtkIdType n = 0; n < before->GetNumberOfPoints(); ++n)
  {
    good &= before->GetPointData()->GetScalars()->GetTuple1(n) ==
      fog->GetOutput()->GetPointData()->GetScalars()->GetTuple1(n);
  }
  good = Check(good, "the same particles have another fog");
  auto* radius = vtkFloatArray::SafeDownCast(particles->GetPointData()->GetArray("Radius"));
  for (vtkIdType n = 0; n < radius->GetNumberOfTuples(); ++n)
  {
    radius->SetValue(n, 2.0f * radius->GetValue(n));
  }
  radius->Modified();
  particles->Modified();
  fog->Update();
  return good &
    Check(std::abs(Counter(fog, "CrossSection") / section - 4.0) < 1e-4, "larger particles have the same fog");
}

/// Water has an extinction of its own, and a part of the image is the same on any threads.
bool CheckFogInWater(Fog* far)
{
  const double clearest = far->GetOutput()->GetPointData()->GetScalars()->GetRange()[0];
  far->SetWaterExtinction(0.065);
  far->Update();
  bool good =
    Check(clearest == 0.0 && std::abs(far->GetOutput()->GetPointData()->GetScalars()->GetRange()[0] - 0.065) < 1e-6,
      "no water");
  vtkNew<vtkImageData> whole;
  whole->DeepCopy(far->GetOutput());
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::Initialize(threads);
    int part[6] = { 3, 20, 0, 44, 7, 18 };
    far->Modified();
    far->UpdateExtent(part);
    for (int k = part[4]; k <= part[5]; ++k)
    {
      for (int i = part[0]; i <= part[1]; ++i)
      {
        good &=
          far->GetOutput()->GetScalarComponentAsDouble(i, 30, k, 0) == whole->GetScalarComponentAsDouble(i, 30, k, 0);
      }
    }
  }
  vtkSMPTools::Initialize(0);
  good &= Check(good, "a part of the image is another");
  return good;
}

/// Near, slaves and fog hide as much in all as all particles do as fog.
bool CheckFogOfLevels()
{
  double section = 0.0;
  const auto particles = ParticlesOfTwoSizes(section);
  vtkNew<Sea> sea;
  vtkNew<Levels> levels;
  levels->SetInputData(0, particles);
  levels->SetSeaStateConnection(sea->GetOutputPort());
  LookAlongY(levels);
  levels->UseCullingOff();
  vtkNew<Fog> far;
  far->SetInputConnection(levels->GetOutputPort());
  far->UseBoundsOn();
  far->SetBounds(-8.0, 8.0, -2.0, 20.0, -9.0, 0.0);
  far->SetGridBy(Fog::BySpacing);
  far->SetSpacing(0.5);
  far->Update();
  int dimensions[3];
  far->GetOutput()->GetDimensions(dimensions);
  bool good = Check(dimensions[0] == 33 && dimensions[1] == 45 && dimensions[2] == 19, "another grid");
  double alone = 0.0;
  double faded = 0.0;
  for (int index = 0; index < 3; ++index)
  {
    vtkPointData* arrays = BlockOf(levels, index)->GetPointData();
    for (vtkIdType n = 0; n < arrays->GetNumberOfTuples(); ++n)
    {
      const double r = arrays->GetArray("Radius")->GetTuple1(n);
      (index < 2 ? alone : faded) += arrays->GetArray("Alpha")->GetTuple1(n) * vtkMath::Pi() * r * r;
    }
  }
  good &= Check(std::abs((alone + Counter(far, "CrossSection")) / section - 1.0) < 1e-5 && faded > 0.1 * section,
    "particles and fog do not make one whole");
  vtkDataArray* field = far->GetOutput()->GetPointData()->GetScalars();
  good &=
    Check(field->GetTuple1(far->GetOutput()->vtkDataSet::FindPoint(0.0, 5.0, -4.0)) == 0.0, "fog about near particles");
  return good & CheckFogInWater(far);
}

/// No particles are no error: water alone.
bool CheckFogOfNothing()
{
  vtkNew<vtkPolyData> nothing;
  vtkNew<Fog> clear;
  clear->SetInputData(nothing);
  clear->SetWaterExtinction(0.1);
  vtkNew<ErrorCounter> errors;
  errors->Watch(clear);
  clear->Update();
  const double* range = clear->GetOutput()->GetPointData()->GetScalars()->GetRange();
  return Check(errors->Count == 0 && std::abs(range[0] - 0.1) < 1e-6 && std::abs(range[1] - 0.1) < 1e-6,
    "clear water is an error");
}

bool FogFails(const char* word, const std::function<void(Fog*, vtkPolyData*)>& spoil)
{
  vtkNew<vtkPolyData> particles = Particles(100);
  vtkNew<Fog> fog;
  fog->SetInputData(particles);
  spoil(fog, particles);
  return FailsNaming(word, fog) && Check(fog->GetOutput()->GetPointData()->GetNumberOfArrays() == 0, "not empty");
}

bool CheckBadInput()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  bool good = true;
  good &= FogFails("GridBy", [](Fog* f, vtkPolyData*) { f->SetGridBy(2); });
  good &= FogFails("UseBounds", [](Fog* f, vtkPolyData*) { f->SetGridBy(Fog::BySpacing); });
  good &= FogFails("Dimensions", [](Fog* f, vtkPolyData*) { f->SetDimensions(1, 10, 10); });
  good &= FogFails("Dimensions", [](Fog* f, vtkPolyData*) { f->SetDimensions(100000, 100000, 1000); });
  good &= FogFails("Spacing", [=](Fog* f, vtkPolyData*) {
    f->SetGridBy(Fog::BySpacing);
    f->UseBoundsOn();
    f->SetSpacing(nan);
  });
  good &= FogFails("Spacing", [](Fog* f, vtkPolyData*) {
    f->SetGridBy(Fog::BySpacing);
    f->UseBoundsOn();
    f->SetSpacing(1e-12);
  });
  good &= FogFails("Bounds", [](Fog* f, vtkPolyData*) {
    f->UseBoundsOn();
    f->SetBounds(1.0, -1.0, 0.0, 1.0, 0.0, 1.0);
  });
  good &= FogFails("ParticleRadius", [](Fog* f, vtkPolyData*) { f->SetParticleRadius(0.0); });
  good &= FogFails("ExtinctionEfficiency", [](Fog* f, vtkPolyData*) { f->SetExtinctionEfficiency(-1.0); });
  good &= FogFails("WaterExtinction", [=](Fog* f, vtkPolyData*) { f->SetWaterExtinction(nan); });
  good &= FogFails("not finite at 3", [=](Fog*, vtkPolyData* p) { p->GetPoints()->SetPoint(3, nan, 0.0, 0.0); });
  good &= FogFails("Alpha", [](Fog*, vtkPolyData* p) { AddFilled<vtkFloatArray>(p, "Alpha", 1.5f); });
  good &= FogFails("Radius", [](Fog*, vtkPolyData* p) { AddFilled<vtkFloatArray>(p, "Radius", -1.0f); });
  return good;
}

}

int TestParticleFog(int, char*[])
{
  bool good = CheckFog();
  good &= CheckFogOfChangedParticles();
  good &= CheckFogOfLevels();
  good &= CheckFogOfNothing();
  good &= CheckBadInput();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
