// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Flow primitives, currents and points that are refused, with one message each.
#include "Check.h"
#include "DriftScene.h"
#include "ErrorCounter.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"

#include <functional>
#include <limits>

using namespace DriftScene;

namespace
{

bool FlowFails(const char* word, const std::function<void(Flow*)>& spoil)
{
  vtkNew<Flow> flow = Primitive(Flow::Vortex, 1.0, 0.0, 0.0, 0.0);
  spoil(flow);
  return FailsNaming(word, flow) && Check(flow->GetOutput()->GetNumberOfPoints() == 0, "output not empty");
}

bool DriftFails(const char* word, const std::function<void(Drift*, vtkPolyData*, vtkPolyData*)>& spoil)
{
  vtkNew<Flow> flow = Primitive(Flow::Vortex, 1.0, 0.0, 0.0, 0.0);
  flow->Update();
  vtkNew<vtkPolyData> primitives;
  primitives->DeepCopy(flow->GetOutput());
  vtkNew<vtkPolyData> particles = Particles(10);
  vtkNew<Drift> drift;
  drift->SetInputData(0, particles);
  drift->SetInputData(1, primitives);
  spoil(drift, particles, primitives);
  return FailsNaming(word, drift) && Check(OutputOf(drift)->GetNumberOfPoints() == 0, "output not empty");
}

bool GridFails(const char* word, const std::function<void(Drift*, vtkImageData*)>& spoil)
{
  return DriftFails(word, [&](Drift* drift, vtkPolyData*, vtkPolyData*) {
    vtkNew<vtkImageData> image;
    image->SetDimensions(3, 3, 3);
    drift->SetInputData(1, image);
    spoil(drift, image);
  });
}

void AddVectors(vtkDataSet* data, const char* name, int components, vtkIdType tuples)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  array->Fill(0.1);
  data->GetPointData()->AddArray(array);
}

bool CheckBadInput()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  bool good = true;
  good &= FlowFails("FlowType", [](Flow* f) { f->SetFlowType(4); });
  good &= FlowFails("Strength", [=](Flow* f) { f->SetStrength(nan); });
  good &= FlowFails("Center", [=](Flow* f) { f->SetCenter(0.0, nan, 0.0); });
  good &= FlowFails("Axis", [](Flow* f) { f->SetAxis(0.0, 0.0, 0.0); });
  good &= FlowFails("CoreRadius", [](Flow* f) { f->SetCoreRadius(0.0); });
  good &= FlowFails("CoreRadius", [](Flow* f) { f->SetCoreRadius(-1.0); });
  good &= FlowFails("InfluenceRadius", [](Flow* f) { f->SetInfluenceRadius(-1.0); });

  good &= DriftFails("TimeStep", [](Drift* d, vtkPolyData*, vtkPolyData*) { d->SetTimeStep(0.0); });
  good &= DriftFails("TimeStep", [=](Drift* d, vtkPolyData*, vtkPolyData*) { d->SetTimeStep(nan); });
  good &= DriftFails("StartTime", [=](Drift* d, vtkPolyData*, vtkPolyData*) { d->SetStartTime(nan); });
  good &= DriftFails("SeaLevel", [=](Drift* d, vtkPolyData*, vtkPolyData*) { d->SetSeaLevel(nan); });
  good &= DriftFails("WaterDepth", [](Drift* d, vtkPolyData*, vtkPolyData*) { d->SetWaterDepth(-2.0); });
  good &=
    DriftFails("VelocityInterpolation", [](Drift* d, vtkPolyData*, vtkPolyData*) { d->SetVelocityInterpolation(2); });
  good &= DriftFails("TimeRange", [](Drift* d, vtkPolyData*, vtkPolyData*) { d->SetTimeRange(1.0, 1.0); });
  good &= DriftFails("TimeStep", [](Drift* d, vtkPolyData*, vtkPolyData*) { d->SetStartTime(-1e9); });
  good &=
    DriftFails("point 3", [=](Drift*, vtkPolyData* p, vtkPolyData*) { p->GetPoints()->SetPoint(3, 0.0, nan, 0.0); });
  good &= DriftFails("Weight", [](Drift*, vtkPolyData* p, vtkPolyData*) { // two arrays of one name
    AddVectors(p, "Weight", 1, 10);
    AddVectors(p, "Other", 1, 10);
    p->GetPointData()->GetArray("Other")->SetName("Weight");
  });
  good &= DriftFails("Offset", [](Drift*, vtkPolyData* p, vtkPolyData*) { AddVectors(p, "MasterId", 1, 10); });
  good &= DriftFails("CoreRadius",
    [](Drift*, vtkPolyData*, vtkPolyData* f) { f->GetPointData()->GetArray("CoreRadius")->SetComponent(0, 0, -1.0); });
  good &= DriftFails("Strength",
    [=](Drift*, vtkPolyData*, vtkPolyData* f) { f->GetPointData()->GetArray("Strength")->SetComponent(0, 0, nan); });
  good &= DriftFails("Axis", [](Drift*, vtkPolyData*, vtkPolyData* f) { f->GetPointData()->RemoveArray("Axis"); });
  good &= DriftFails(
    "InfluenceMargin", [](Drift*, vtkPolyData*, vtkPolyData* f) { f->GetPointData()->RemoveArray("InfluenceMargin"); });
  good &= DriftFails(
    "InfluenceBox", [](Drift*, vtkPolyData*, vtkPolyData* f) { f->GetPointData()->RemoveArray("InfluenceBox"); });
  good &= DriftFails("InfluenceBox", [](Drift*, vtkPolyData*, vtkPolyData* f) { AddVectors(f, "InfluenceBox", 3, 1); });
  good &= DriftFails("InfluenceBox", [](Drift*, vtkPolyData*, vtkPolyData* f) { AddVectors(f, "InfluenceBox", 6, 0); });
  good &= DriftFails("InfluenceBox", [](Drift*, vtkPolyData*, vtkPolyData* f) {
    f->GetPointData()->GetArray("InfluenceMargin")->SetComponent(0, 0, 1.0);
    f->GetPointData()->GetArray("InfluenceBox")->SetComponent(0, 0, 1.0);
  });
  good &= DriftFails("InfluenceMargin", [=](Drift*, vtkPolyData*, vtkPolyData* f) {
    f->GetPointData()->GetArray("InfluenceMargin")->SetComponent(0, 0, nan);
  });
  good &= DriftFails("FlowType",
    [](Drift*, vtkPolyData*, vtkPolyData* f) { f->GetPointData()->GetArray("FlowType")->SetComponent(0, 0, 7); });
  good &= DriftFails("cells", [](Drift*, vtkPolyData*, vtkPolyData* f) {
    f->GetPointData()->Initialize();
    AddVectors(f, "Velocity", 3, 1);
  });
  good &= GridFails("velocities", [](Drift*, vtkImageData*) {});
  good &= GridFails("'uo'", [](Drift* d, vtkImageData*) { d->SetVelocityArray("uo"); });
  good &= GridFails("components", [](Drift*, vtkImageData* i) { AddVectors(i, "Velocity", 2, 27); });
  good &= GridFails("values for 27", [](Drift*, vtkImageData* i) { AddVectors(i, "Velocity", 3, 26); });
  good &= GridFails("VelocityArray", [](Drift*, vtkImageData* i) {
    AddVectors(i, "a", 3, 27);
    AddVectors(i, "b", 3, 27);
  });

  // After an error is put right, all is as if it had never been.
  vtkNew<Drift> drift;
  Connect(drift, 0.0, 0.0, VTK_DOUBLE, 50);
  const std::vector<char> wanted = Moved(drift, 2.0);
  vtkNew<ErrorCounter> errors;
  errors->Watch(drift);
  drift->SetTimeStep(-1.0);
  errors->ExpectOneNaming("TimeStep");
  drift->SetTimeStep(0.1);
  return good & Check(Moved(drift, 2.0) == wanted, "an error leaves traces");
}

}

int TestCurrentBadInput(int, char*[])
{
  return CheckBadInput() ? EXIT_SUCCESS : EXIT_FAILURE;
}
