// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Drift through the pipeline: uniform flow, vortices, sinks, grids, currents that change, time in any order, threads,
// pieces, and every bad input.
#include "Check.h"
#include "ErrorCounter.h"
#include "vtkCurrentDriftFilter.h"
#include "vtkFlowPrimitiveSource.h"
#include "vtkParticleOrbitFilter.h"
#include "vtkSeaStateSource.h"
#include "vtkSuspendedParticleSource.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <vector>

namespace
{

using Drift = vtkCurrentDriftFilter;
using Flow = vtkFlowPrimitiveSource;
using Pipeline = vtkStreamingDemandDrivenPipeline;

constexpr double Pi = 3.14159265358979323846;

/// Points within 8 m of a place, at depths to 10 m.
vtkNew<vtkPolyData> Particles(int count, int type = VTK_DOUBLE, double x = 0.0, double level = 0.0)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  for (int n = 0; n < count; ++n)
  {
    points->InsertNextPoint(x + 8.0 * std::sin(1.7 * n), 8.0 * std::cos(0.9 * n), level - 10.0 * (n + 0.5) / count);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  return data;
}

vtkNew<vtkPolyData> OneParticle(double x, double y, double z)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(x, y, z);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  return data;
}

vtkNew<Flow> Primitive(int type, double strength, double x, double y, double z, double core = 0.5)
{
  vtkNew<Flow> flow;
  flow->SetFlowType(type);
  flow->SetStrength(strength);
  flow->SetCenter(x, y, z);
  flow->SetCoreRadius(core);
  if (type == Flow::Vortex)
  {
    flow->SetAxis(0.0, 0.0, 1.0);
  }
  return flow;
}

std::vector<char> BytesOf(vtkDataArray* array)
{
  const char* begin = static_cast<const char*>(array->GetVoidPointer(0));
  return { begin, begin + array->GetNumberOfValues() * array->GetDataTypeSize() };
}

vtkPolyData* OutputOf(vtkAlgorithm* algorithm)
{
  return vtkPolyData::SafeDownCast(algorithm->GetOutputDataObject(0));
}

std::vector<char> Moved(Drift* drift, double time)
{
  drift->UpdateTimeStep(time);
  vtkPolyData* output = OutputOf(drift);
  std::vector<char> bytes = BytesOf(output->GetPoints()->GetData());
  const std::vector<char> captured = BytesOf(output->GetPointData()->GetArray("Captured"));
  bytes.insert(bytes.end(), captured.begin(), captured.end());
  return bytes;
}

/// An image whose velocity is uniform and goes up and down with time as (a, b cos wt, 0); with time steps, or with a
/// range alone. Counts how often it is asked.
class Tide : public vtkImageAlgorithm
{
public:
  static Tide* New();
  vtkTypeMacro(Tide, vtkImageAlgorithm);

  double Interval = 0.0; ///< of time steps; 0: a range alone
  double Last = 20.0;
  int Calls = 0;
  static constexpr double Along = 0.3;
  static constexpr double Across = 0.5;
  static constexpr double Frequency = 1.5;

protected:
  Tide() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    vtkInformation* info = outputVector->GetInformationObject(0);
    const int whole[6] = { 0, 10, 0, 10, 0, 4 };
    info->Set(Pipeline::WHOLE_EXTENT(), whole, 6);
    const double range[2] = { 0.0, this->Last };
    info->Set(Pipeline::TIME_RANGE(), range, 2);
    std::vector<double> steps;
    for (int n = 0; this->Interval > 0.0 && n * this->Interval <= this->Last + 1e-9; ++n)
    {
      steps.push_back(n * this->Interval);
    }
    if (!steps.empty())
    {
      info->Set(Pipeline::TIME_STEPS(), steps.data(), static_cast<int>(steps.size()));
    }
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    ++this->Calls;
    const double time = outputVector->GetInformationObject(0)->Get(Pipeline::UPDATE_TIME_STEP());
    vtkImageData* image = vtkImageData::GetData(outputVector);
    image->SetExtent(0, 10, 0, 10, 0, 4);
    image->SetOrigin(-50.0, -50.0, -20.0);
    image->SetSpacing(10.0, 10.0, 5.0);
    vtkNew<vtkDoubleArray> velocity;
    velocity->SetName("Velocity");
    velocity->SetNumberOfComponents(3);
    for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
    {
      velocity->InsertNextTuple3(Along, Across * std::cos(Frequency * time), 0.0);
    }
    image->GetPointData()->AddArray(velocity);
    return 1;
  }
};
vtkStandardNewMacro(Tide);

/// A field that is linear in place, v = A x, which all interpolations keep: rotation about z with 0.4 rad/s and a slow
/// rise.
void AddLinearVelocity(vtkDataSet* data, double scale = 1.0)
{
  vtkNew<vtkFloatArray> velocity;
  velocity->SetName("uo");
  velocity->SetNumberOfComponents(3);
  for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id)
  {
    double p[3];
    data->GetPoint(id, p);
    velocity->InsertNextTuple3(-0.5 * scale * p[1], 0.5 * scale * p[0], 0.0);
  }
  data->GetPointData()->AddArray(velocity);
}

bool CheckUniform()
{
  vtkNew<vtkPolyData> particles = Particles(1000);
  vtkNew<Flow> first = Primitive(Flow::Uniform, 0.31, 0.0, 0.0, 0.0);
  first->SetAxis(3.0, 4.0, 0.0);
  vtkNew<Flow> second = Primitive(Flow::Uniform, 0.07, 0.0, 0.0, 0.0);
  second->SetAxis(0.0, -1.0, 0.0);
  bool good = true;
  for (const bool steps : { false, true })
  {
    vtkNew<Drift> drift;
    drift->SetStartTime(2.0);
    drift->SetInputData(0, particles);
    drift->AddInputConnection(1, first->GetOutputPort());
    drift->AddInputConnection(1, second->GetOutputPort());
    vtkNew<Flow> still = Primitive(Flow::Vortex, 0.0, 0.0, 0.0, 0.0); // makes it take steps
    if (steps)
    {
      drift->AddInputConnection(1, still->GetOutputPort());
    }
    double worst = 0.0;
    for (const double time : { 12.34, 2.0, 102.0, 0.5 })
    {
      drift->UpdateTimeStep(time);
      const double passed = std::max(0.0, time - 2.0);
      for (vtkIdType id = 0; id < particles->GetNumberOfPoints(); ++id)
      {
        double p[3];
        double q[3];
        particles->GetPoint(id, p);
        OutputOf(drift)->GetPoint(id, q);
        const double wanted[3] = { p[0] + 0.186 * passed, p[1] + (0.248 - 0.07) * passed, p[2] };
        for (int axis = 0; axis < 3; ++axis)
        {
          worst = std::max(worst, std::abs(q[axis] - wanted[axis]));
        }
      }
    }
    std::cout << "uniform drift is off by " << worst << " m" << (steps ? " in steps" : "") << std::endl;
    good &= Check(worst < 1e-9, "uniform drift is not U t");
  }
  return good;
}

bool CheckVortex()
{
  vtkNew<Flow> vortex = Primitive(Flow::Vortex, 2.0, 1.0, 2.0, -5.0);
  const double radius = 1.2;
  const double rate = 2.0 / (2.0 * Pi * radius * radius) * -std::expm1(-radius * radius / 0.25);
  vtkNew<Drift> drift;
  drift->SetInputData(0, OneParticle(1.0 + radius, 2.0, -3.0));
  drift->SetInputConnection(1, vortex->GetOutputPort());
  drift->SetTimeStep(0.1 / rate);
  drift->UpdateTimeStep(100.0 * 2.0 * Pi / rate);
  double p[3];
  OutputOf(drift)->GetPoint(0, p);
  const double error = std::abs(std::hypot(p[0] - 1.0, p[1] - 2.0) / radius - 1.0);
  std::cout << "vortex: radius after 100 turns of 63 steps is off by " << error << std::endl;
  return Check(error < 1e-4 && p[2] == -3.0, "points leave the vortex");
}

/// All that a source gives comes to the sink.
bool CheckCapture()
{
  vtkNew<vtkPolyData> particles = Particles(200);
  vtkNew<Flow> source = Primitive(Flow::Source, 10.0, -9.0, 0.0, -5.0);
  vtkNew<Flow> sink = Primitive(Flow::Sink, 80.0, 2.0, 0.0, -5.0, 0.4);
  vtkNew<Drift> drift;
  drift->SetInputData(0, particles);
  drift->AddInputConnection(1, source->GetOutputPort());
  drift->AddInputConnection(1, sink->GetOutputPort());
  drift->SetWaterDepth(10.0);
  drift->UpdateTimeStep(5.0);
  const auto captured = [&] {
    int count = 0;
    for (vtkIdType id = 0; id < 200; ++id)
    {
      if (OutputOf(drift)->GetPointData()->GetArray("Captured")->GetTuple1(id) == 1.0)
      {
        ++count;
        double p[3];
        OutputOf(drift)->GetPoint(id, p);
        if (std::hypot(p[0] - 2.0, p[1], p[2] + 5.0) > 0.4 + 1e-12)
        {
          return -1;
        }
      }
    }
    return count;
  };
  const int early = captured();
  drift->UpdateTimeStep(2000.0);
  const int late = captured();
  std::cout << "captured: " << early << " at 5 s, " << late << " at 2000 s" << std::endl;
  return Check(early > 0 && early < late && late == 200, "the sink does not capture");
}

bool CheckWaterIsLeftByNone()
{
  vtkNew<Flow> up = Primitive(Flow::Uniform, 1.0, 0.0, 0.0, 0.0);
  up->SetAxis(0.2, 0.0, 1.0);
  vtkNew<Flow> vortex = Primitive(Flow::Vortex, 30.0, 0.0, 0.0, 445.0);
  vortex->SetAxis(0.0, 1.0, 0.0);
  vtkNew<vtkPolyData> particles = Particles(300, VTK_DOUBLE, 0.0, 450.0);
  particles->GetPoints()->InsertNextPoint(0.0, 0.0, 451.0); // in the air
  vtkNew<Drift> drift;
  drift->SetInputData(0, particles);
  drift->AddInputConnection(1, up->GetOutputPort());
  drift->AddInputConnection(1, vortex->GetOutputPort());
  drift->SetSeaLevel(450.0);
  drift->SetWaterDepth(10.0);
  bool good = true;
  for (const double time : { 1.0, 7.77, 30.0 })
  {
    drift->UpdateTimeStep(time);
    for (vtkIdType id = 0; id < 300; ++id)
    {
      const double z = OutputOf(drift)->GetPoint(id)[2];
      good &= z >= 440.0 && z <= 450.0;
    }
    const double* air = OutputOf(drift)->GetPoint(300);
    good &= air[0] == 0.0 && air[2] == 451.0;
  }
  Check(good, "points leave the water");
  drift->KeepInWaterOff();
  drift->UpdateTimeStep(30.0);
  return good & Check(OutputOf(drift)->GetBounds()[5] > 460.0, "points are kept in the water against the wish");
}

/// A scene of all primitives, somewhere.
void Connect(Drift* drift, double x, double level, int type, int count)
{
  vtkNew<Flow> uniform = Primitive(Flow::Uniform, 0.2, 0.0, 0.0, 0.0);
  vtkNew<Flow> vortex = Primitive(Flow::Vortex, 4.0, x + 2.0, 1.0, level - 4.0);
  vortex->SetAxis(0.1, 0.2, 1.0);
  vortex->SetInfluenceRadius(6.0);
  vtkNew<Flow> source = Primitive(Flow::Source, 5.0, x - 3.0, 2.0, level - 6.0);
  vtkNew<Flow> sink = Primitive(Flow::Sink, 5.0, x + 5.0, -2.0, level - 3.0);
  drift->SetInputData(0, Particles(count, type, x, level));
  for (Flow* flow : { uniform.Get(), vortex.Get(), source.Get(), sink.Get() })
  {
    drift->AddInputConnection(1, flow->GetOutputPort());
  }
  drift->SetSeaLevel(level);
  drift->SetWaterDepth(11.0);
}

bool CheckTimeOrderAndThreads(bool tide, double interval)
{
  bool good = true;
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    const auto make = [&](Drift* drift) {
      Connect(drift, 0.0, 0.0, type, 3000);
      if (tide)
      {
        vtkNew<Tide> current;
        current->Interval = interval;
        drift->AddInputConnection(1, current->GetOutputPort());
      }
    };
    vtkNew<Drift> direct;
    make(direct);
    const std::vector<char> wanted = Moved(direct, 7.3);
    vtkNew<Drift> other;
    make(other);
    for (int time = 0; time <= 7; ++time)
    {
      good &= Check(Moved(other, time) != wanted, "time has no effect");
    }
    good &= Check(Moved(other, 7.3) == wanted, "another state after 0 to 7");
    const std::vector<char> late = Moved(other, 20.0);
    good &= Check(Moved(other, 7.3) == wanted, "another state after 20 and back");
    good &= Check(Moved(other, 7.33) != wanted, "the rest of a step has no effect");
    good &= Check(Moved(other, 7.3) == wanted, "the rest of a step is kept");
    good &= Check(Moved(direct, 20.0) == late, "another state at 20");
    for (const int threads : { 1, 2 })
    {
      vtkSMPTools::Initialize(threads);
      vtkNew<Drift> again;
      make(again);
      good &= Check(Moved(again, 7.3) == wanted, "another state on other threads");
    }
    vtkSMPTools::Initialize(0);
    good &= Check(OutputOf(direct)->GetPoints()->GetDataType() == type, "another precision");
  }
  return good;
}

bool CheckAnywhere()
{
  const auto at = [](double x, double level) {
    vtkNew<Drift> drift;
    Connect(drift, x, level, VTK_DOUBLE, 500);
    drift->UpdateTimeStep(12.7);
    std::vector<double> places;
    for (vtkIdType id = 0; id < 500; ++id)
    {
      const double* p = OutputOf(drift)->GetPoint(id);
      places.insert(places.end(), { p[0] - x, p[1], p[2] - level });
    }
    return places;
  };
  const std::vector<double> home = at(0.0, 0.0);
  bool good = true;
  for (const auto& [x, level] : { std::pair<double, double>{ 0.0, 450.0 }, { 1e6, 0.0 }, { 1e6, 450.0 } })
  {
    const std::vector<double> away = at(x, level);
    double worst = 0.0;
    for (std::size_t n = 0; n < home.size(); ++n)
    {
      worst = std::max(worst, std::abs(away[n] - home[n]));
    }
    std::cout << "the scene at x " << x << ", level " << level << " is off by " << worst << " m" << std::endl;
    good &= Check(worst < 1e-6, "a scene far away moves in another way");
  }
  return good;
}

bool CheckChangingCurrent()
{
  bool good = true;
  // Between close time steps, and with a range alone.
  for (const double interval : { 0.02, 0.0 })
  {
    vtkNew<Tide> tide;
    tide->Interval = interval;
    vtkNew<Drift> drift;
    drift->SetInputData(0, OneParticle(1.0, 2.0, -5.0));
    drift->SetInputConnection(1, tide->GetOutputPort());
    drift->SetTimeStep(0.05);
    double worst = 0.0;
    for (const double time : { 7.3, 3.0, 3.21, 12.0 })
    {
      drift->UpdateTimeStep(time);
      const double* p = OutputOf(drift)->GetPoint(0);
      worst = std::max(worst, std::abs(p[0] - 1.0 - Tide::Along * time));
      worst = std::max(worst, std::abs(p[1] - 2.0 - Tide::Across / Tide::Frequency * std::sin(Tide::Frequency * time)));
    }
    std::cout << "in a tide points are off by " << worst << " m; it was asked " << tide->Calls << " times" << std::endl;
    // Straight lines between steps h: up to h^2 w^2 / 12 of the amplitude.
    const double bound = Tide::Across * Tide::Frequency * interval * interval / 12.0 + 1e-6;
    good &= Check(worst < bound, "points do not follow the tide");
    const int calls = tide->Calls;
    drift->UpdateTimeStep(12.0);
    good &= Check(tide->Calls == calls, "the tide is asked again for nothing");
    drift->UpdateTimeStep(11.98);
    good &= Check(tide->Calls <= calls + 80, "no state was kept to begin from");
  }
  // An ocean model's hours: piecewise linear between its steps, so that a sum of trapezia is exact.
  vtkNew<Tide> model;
  model->Interval = 0.5;
  model->Last = 4.0;
  vtkNew<Drift> drift;
  drift->SetInputData(0, OneParticle(0.0, 0.0, -5.0));
  drift->SetInputConnection(1, model->GetOutputPort());
  drift->UpdateTimeStep(4.0);
  double sum = 0.0;
  for (int n = 0; n < 8; ++n)
  {
    const auto speed = [](double time) { return Tide::Across * std::cos(Tide::Frequency * time); };
    sum += 0.25 * (speed(0.5 * n) + speed(0.5 * n + 0.5));
  }
  good &= Check(std::abs(OutputOf(drift)->GetPoint(0)[1] - sum) < 1e-12, "time steps are not interpolated");
  good &= Check(model->Calls == 9, "a model is asked for other times than its own");
  // After the last step it stays as it was.
  drift->UpdateTimeStep(6.0);
  const double last = Tide::Across * std::cos(Tide::Frequency * 4.0);
  good &= Check(std::abs(OutputOf(drift)->GetPoint(0)[1] - sum - 2.0 * last) < 1e-12, "the current does not stay");
  // A change upstream is noticed.
  model->Last = 2.0;
  model->Modified();
  drift->UpdateTimeStep(4.0);
  good &= Check(std::abs(OutputOf(drift)->GetPoint(0)[1] - sum) > 1e-3, "a change upstream is not noticed");
  // Waves downstream ask for the time they want.
  vtkNew<vtkSeaStateSource> sea;
  vtkNew<vtkParticleOrbitFilter> orbits;
  orbits->SetInputConnection(0, drift->GetOutputPort());
  orbits->SetInputConnection(1, sea->GetOutputPort());
  orbits->UpdateTimeStep(1.3);
  const double* center = OutputOf(orbits)->GetPointData()->GetArray("Center")->GetTuple3(0);
  return good & Check(std::abs(center[0] - 1.3 * Tide::Along) < 1e-12, "orbits have other centers");
}

bool CheckGrids()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(21, 21, 5);
  image->SetOrigin(-10.0, -10.0, -12.0);
  image->SetSpacing(1.0, 1.0, 3.0);
  AddLinearVelocity(image);
  vtkNew<vtkImageData> layer;
  layer->SetDimensions(21, 21, 1);
  layer->SetOrigin(-10.0, -10.0, 0.0);
  AddLinearVelocity(layer);
  vtkNew<vtkRectilinearGrid> rectilinear;
  rectilinear->SetDimensions(11, 11, 4);
  vtkNew<vtkStructuredGrid> curved;
  curved->SetDimensions(11, 11, 4);
  vtkNew<vtkDoubleArray> axes[3];
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto place = [](int n, int axis) { return axis == 2 ? 0.5 - 4.0 * n : -10.0 + 2.0 * n + 0.04 * n * (10 - n); };
  for (int k = 0; k < 4; ++k)
  {
    for (int j = 0; j < 11; ++j)
    {
      for (int i = 0; i < 11; ++i)
      {
        points->InsertNextPoint(place(i, 0), place(j, 1), place(k, 2));
      }
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int n = 0; n < (axis < 2 ? 11 : 4); ++n)
    {
      axes[axis]->InsertNextValue(place(n, axis));
    }
  }
  rectilinear->SetXCoordinates(axes[0]);
  rectilinear->SetYCoordinates(axes[1]);
  rectilinear->SetZCoordinates(axes[2]); // falling
  curved->SetPoints(points);
  AddLinearVelocity(rectilinear);
  AddLinearVelocity(curved);
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkImageData> half;
  half->DeepCopy(image);
  half->GetPointData()->Initialize();
  AddLinearVelocity(half, 0.5);
  blocks->SetBlock(0, half);
  blocks->SetBlock(2, half);
  bool good = true;
  vtkDataObject* grids[] = { image, layer, rectilinear, curved, blocks };
  for (vtkDataObject* grid : grids)
  {
    vtkNew<Drift> drift;
    vtkNew<vtkPolyData> particles = OneParticle(3.0, 4.0, -2.0);
    particles->GetPoints()->InsertNextPoint(30.0, 0.0, -2.0); // outside
    drift->SetInputData(0, particles);
    drift->SetInputData(1, grid);
    drift->UpdateTimeStep(2.0);
    const double angle = std::atan2(4.0, 3.0) + 1.0;
    double p[3];
    OutputOf(drift)->GetPoint(0, p);
    const double error = std::hypot(p[0] - 5.0 * std::cos(angle), p[1] - 5.0 * std::sin(angle), p[2] + 2.0);
    std::cout << grid->GetClassName() << ": off by " << error << " m" << std::endl;
    good &= Check(error < 2e-6, "a grid carries points elsewhere");
    OutputOf(drift)->GetPoint(1, p);
    good &= Check(p[0] == 30.0 && p[1] == 0.0, "there is a current outside of the data set");
  }
  // Land is at rest.
  vtkNew<vtkImageData> land;
  land->DeepCopy(image);
  land->GetPointData()->GetArray(0)->Fill(std::numeric_limits<double>::quiet_NaN());
  vtkNew<Drift> drift;
  drift->SetInputData(0, OneParticle(3.0, 4.0, -2.0));
  drift->SetInputData(1, land);
  drift->UpdateTimeStep(2.0);
  return good & Check(OutputOf(drift)->GetPoint(0)[0] == 3.0, "land flows");
}

/// A basin of 64 m x 64 m x 10 m with gyres, weaker at the bed, and water that turns over, as the curl of (0, A, B): no
/// divergence, and no flow through any wall.
constexpr double BasinX = 64.0;
constexpr double BasinDepth = 10.0;

void BasinVelocity(const double p[3], double flow[3])
{
  const double x = Pi * p[0] / BasinX;
  const double y = Pi * p[1] / BasinX;
  const double z = Pi * (p[2] / BasinDepth + 1.0);
  const double sine = std::pow(std::sin(y), 2);
  const double strength = 1.0 + 0.5 * std::cos(z - Pi);
  flow[0] = std::pow(std::sin(x), 2) * std::sin(2.0 * y) * strength - 0.3 * std::cos(z) * std::sin(2.0 * x) * sine;
  flow[1] = -std::sin(2.0 * x) * sine * strength;
  flow[2] = 0.6 * BasinDepth / BasinX * std::sin(z) * std::cos(2.0 * x) * sine;
}

/// Samples of the basin: as many along and across, layers from bed to surface, or in the middles of as many.
vtkNew<vtkRectilinearGrid> Basin(int across, int layers, bool middles)
{
  const auto axis = [](int count, double first, double last) {
    vtkNew<vtkDoubleArray> values;
    for (int n = 0; n < count; ++n)
    {
      values->InsertNextValue(n == count - 1 ? last : first + (last - first) * n / (count - 1));
    }
    return values;
  };
  const double end = middles ? 0.5 * BasinDepth / layers : 0.0;
  vtkNew<vtkRectilinearGrid> grid;
  grid->SetDimensions(across, across, layers);
  grid->SetXCoordinates(axis(across, 0.0, BasinX));
  grid->SetYCoordinates(axis(across, 0.0, BasinX));
  grid->SetZCoordinates(axis(layers, -end, end - BasinDepth)); // down, as ocean models have it
  vtkNew<vtkFloatArray> velocity;
  velocity->SetName("uvw");
  velocity->SetNumberOfComponents(3);
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    double flow[3];
    BasinVelocity(grid->GetPoint(id), flow);
    velocity->InsertNextTuple(flow);
  }
  grid->GetPointData()->AddArray(velocity);
  return grid;
}

/// Even tracers in a basin 2000 s later: chi-squared over 4 x 4 x 4 boxes, and the part within 1 cm of bed and surface.
void Stir(vtkDataSet* basin, int interpolation, double& chi, double& atWalls)
{
  constexpr int Count = 2048;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto number = [](int n, int base) {
    double part = 1.0;
    double sum = 0.0;
    for (; n > 0; n /= base)
    {
      part /= base;
      sum += part * (n % base);
    }
    return sum;
  };
  for (int n = 1; n <= Count; ++n) // Halton's sequence
  {
    points->InsertNextPoint(BasinX * number(n, 2), BasinX * number(n, 3), -BasinDepth * number(n, 5));
  }
  vtkNew<vtkPolyData> tracers;
  tracers->SetPoints(points);
  vtkNew<Drift> drift;
  drift->SetInputData(0, tracers);
  drift->SetInputData(1, basin);
  drift->SetWaterDepth(BasinDepth);
  drift->SetTimeStep(5.0);
  drift->SetVelocityInterpolation(interpolation);
  drift->UpdateTimeStep(2000.0);
  std::vector<int> boxes(64, 0);
  int near = 0;
  for (int n = 0; n < Count; ++n)
  {
    const double* p = OutputOf(drift)->GetPoint(n);
    near += p[2] > -0.01 || p[2] < 0.01 - BasinDepth;
    const auto box = [](double part) { return std::min(3, std::max(0, static_cast<int>(4.0 * part))); };
    ++boxes[static_cast<std::size_t>(box(p[0] / BasinX) + 4 * box(p[1] / BasinX) + 16 * box(-p[2] / BasinDepth))];
  }
  chi = 0.0;
  for (const int many : boxes)
  {
    chi += std::pow(many - Count / 64.0, 2) / (Count / 64.0);
  }
  atWalls = static_cast<double>(near) / Count;
}

/// An ocean model's currents keep an even distribution. Of 2048 tracers, chi-squared of 63 degrees of freedom is below
/// 105 but once in a thousand times, and above it in half of the cases if densities differ by 14 % rms; 4 are expected
/// within 1 cm of a wall.
bool CheckOcean()
{
  bool good = true;
  for (const bool middles : { false, true })
  {
    vtkNew<vtkRectilinearGrid> basin = Basin(17, 9, middles);
    double chi[2];
    double atWalls[2];
    for (const int interpolation : { Drift::Linear, Drift::CubicSpline })
    {
      Stir(basin, interpolation, chi[interpolation], atWalls[interpolation]);
      std::cout << (middles ? "middles of layers, " : "bed to surface, ")
                << (interpolation == Drift::Linear ? "linear" : "spline") << ": chi-squared " << chi[interpolation]
                << " of 63, " << 100.0 * atWalls[interpolation] << " % within 1 cm of bed and surface" << std::endl;
    }
    good &= Check(chi[1] < 105.0, "an ocean model's current gathers tracers");
    good &= Check(atWalls[1] < 0.006, "an ocean model's current gathers tracers at bed and surface");
    good &= Check(chi[1] < chi[0], "splines gather more than straight lines");
  }
  return good;
}

/// Grids that flow through the bed and the surface: what goes in and out again is taken away.
bool CheckGridsThroughWalls()
{
  bool good = true;
  const auto make = [](const int dimensions[3], double low, double step, double turn) {
    vtkNew<vtkImageData> image;
    image->SetDimensions(dimensions);
    image->SetOrigin(-40.0, -40.0, low);
    image->SetSpacing(4.0, 4.0, step);
    vtkNew<vtkDoubleArray> velocity;
    velocity->SetName("Velocity");
    velocity->SetNumberOfComponents(3);
    for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
    {
      velocity->InsertNextTuple3(0.2, 0.0, 0.05 + turn * image->GetPoint(id)[1]);
    }
    image->GetPointData()->AddArray(velocity);
    return image;
  };
  const struct
  {
    const char* Name;
    int Dimensions[3];
    double Low;
    double Step;
    double Depth;
    double Turn;
  } cases[] = { { "wider than the water", { 21, 21, 9 }, -16.0, 4.0, 10.0, 0.01 },
    { "up to both walls", { 21, 21, 6 }, -10.0, 2.0, 10.0, 0.0 },
    { "without a bed", { 21, 21, 9 }, -16.0, 4.0, 0.0, 0.01 },
    { "of one layer", { 21, 21, 1 }, -3.0, 1.0, 10.0, 0.01 } };
  for (const auto& one : cases)
  {
    for (const int interpolation : { Drift::Linear, Drift::CubicSpline })
    {
      vtkNew<Drift> drift;
      drift->SetInputData(0, OneParticle(-30.0, 7.0, -4.0));
      drift->SetInputData(1, make(one.Dimensions, one.Low, one.Step, one.Turn));
      drift->SetWaterDepth(one.Depth);
      drift->SetVelocityInterpolation(interpolation);
      drift->UpdateTimeStep(200.0);
      const double* p = OutputOf(drift)->GetPoint(0);
      const double error = std::hypot(p[0] - 10.0, p[1] - 7.0, p[2] + 4.0);
      std::cout << "a tilted grid " << one.Name << ": off by " << error << " m" << std::endl;
      good &= Check(error < 1e-4, "a grid flows through bed and surface");
    }
  }
  // Between the end of a grid and a wall that is near, the horizontal flow goes on, and the vertical one falls to 0.
  vtkNew<vtkImageData> ended = make(cases[0].Dimensions, -9.0, 1.0, 0.0); // up to -1 m
  const auto currentAt = [&](double z, double level) {
    vtkNew<Drift> drift;
    drift->SetInputData(0, OneParticle(0.0, 0.0, z));
    drift->SetInputData(1, ended);
    drift->GenerateCurrentOn();
    drift->SetSeaLevel(level);
    drift->UpdateTimeStep(0.0);
    const double* flow = OutputOf(drift)->GetPointData()->GetArray("Current")->GetTuple3(0);
    return std::array<double, 2>{ flow[0], flow[2] };
  };
  good &= Check(std::abs(currentAt(-0.25, 0.0)[0] - 0.2) < 1e-6 && std::abs(currentAt(-0.25, 0.0)[1] - 0.0125) < 1e-6,
    "the end of a grid is not joined to the surface");
  good &= Check(std::abs(currentAt(-2.0, 0.0)[1] - 0.05) < 1e-6, "a grid below the surface is changed");
  good &= Check(currentAt(-0.25, 0.5)[0] == 0.0, "a grid reaches farther than its last step");
  return good;
}

bool CheckNoCurrent()
{
  vtkNew<vtkPolyData> particles = Particles(100, VTK_FLOAT);
  vtkNew<Drift> drift;
  drift->SetInputData(0, particles);
  drift->UpdateTimeStep(5.0);
  bool good = Check(BytesOf(OutputOf(drift)->GetPoints()->GetData()) == BytesOf(particles->GetPoints()->GetData()),
    "points move without a current");
  good &= Check(OutputOf(drift)->GetPoints()->GetData() == particles->GetPoints()->GetData(), "points are copied");
  // Nothing to carry is no error.
  vtkNew<vtkPolyData> nothing;
  vtkNew<Flow> flow;
  vtkNew<Drift> empty;
  empty->SetInputData(0, nothing);
  empty->SetInputConnection(1, flow->GetOutputPort());
  vtkNew<ErrorCounter> errors;
  errors->Watch(empty);
  empty->Update();
  return good & Check(errors->Count == 0, "an empty input is an error");
}

/// Squares, blocks, pieces, and the array Current.
bool CheckParticles()
{
  vtkNew<vtkSuspendedParticleSource> source;
  source->SetDensity(0.1);
  source->SetMode(vtkSuspendedParticleSource::Quads);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkNew<Flow> vortex = Primitive(Flow::Vortex, 5.0, 0.0, 0.0, 0.0);
  vtkNew<Drift> drift;
  drift->SetInputConnection(0, source->GetOutputPort());
  drift->SetInputConnection(1, vortex->GetOutputPort());
  drift->GenerateCurrentOn();
  drift->UpdateTimeStep(4.0);
  vtkPolyData* output = OutputOf(drift);
  bool good = Check(output->GetNumberOfPoints() > 3000 && output->GetNumberOfPolys() > 600, "no squares");
  double bent = 0.0;
  vtkDataArray* offset = output->GetPointData()->GetArray("Offset");
  for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id)
  {
    double p[3];
    double q[3];
    output->GetPoint(id, p);
    output->GetPoint(id - id % 5, q);
    for (int axis = 0; axis < 3; ++axis)
    {
      bent = std::max(bent, std::abs(p[axis] - q[axis] - offset->GetComponent(id, axis)));
    }
  }
  good &= Check(bent < 1e-9, "squares are bent");
  double place[3];
  output->GetPoint(0, place);
  const double* flow = output->GetPointData()->GetArray("Current")->GetTuple3(0);
  good &= Check(std::abs(flow[0] * place[0] + flow[1] * place[1]) < 1e-5 && std::hypot(flow[0], flow[1]) > 0.01,
    "Current is not around the vortex");

  // Pieces are parts of the whole.
  vtkNew<vtkSuspendedParticleSource> points;
  vtkNew<Drift> whole;
  whole->SetInputConnection(0, points->GetOutputPort());
  whole->SetInputConnection(1, vortex->GetOutputPort());
  const std::vector<char> wanted = Moved(whole, 3.3);
  const std::size_t count = static_cast<std::size_t>(OutputOf(whole)->GetNumberOfPoints());
  std::vector<char> together;
  for (int piece = 0; piece < 3; ++piece)
  {
    vtkNew<Drift> part;
    part->SetInputConnection(0, points->GetOutputPort());
    part->SetInputConnection(1, vortex->GetOutputPort());
    part->UpdateInformation();
    vtkInformation* info = part->GetOutputInformation(0);
    info->Set(Pipeline::UPDATE_PIECE_NUMBER(), piece);
    info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 3);
    info->Set(Pipeline::UPDATE_TIME_STEP(), 3.3);
    part->GetExecutive()->Update();
    const std::vector<char> own = BytesOf(OutputOf(part)->GetPoints()->GetData());
    together.insert(together.end(), own.begin(), own.end());
  }
  good &= Check(together.size() == 12 * count && std::memcmp(together.data(), wanted.data(), together.size()) == 0,
    "pieces are other than the whole");

  // Blocks.
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Particles(5));
  blocks->SetBlock(2, Particles(700));
  vtkNew<Drift> many;
  many->SetInputData(0, blocks);
  many->SetInputConnection(1, vortex->GetOutputPort());
  many->UpdateTimeStep(2.0);
  vtkNew<Drift> single;
  single->SetInputData(0, Particles(700));
  single->SetInputConnection(1, vortex->GetOutputPort());
  single->UpdateTimeStep(2.0);
  auto* moved = vtkMultiBlockDataSet::SafeDownCast(many->GetOutputDataObject(0));
  return good &
    Check(BytesOf(vtkPolyData::SafeDownCast(moved->GetBlock(2))->GetPoints()->GetData()) ==
        BytesOf(OutputOf(single)->GetPoints()->GetData()),
      "blocks drift in another way");
}

bool FlowFails(const char* word, const std::function<void(Flow*)>& spoil)
{
  vtkNew<Flow> flow = Primitive(Flow::Vortex, 1.0, 0.0, 0.0, 0.0);
  spoil(flow);
  vtkNew<ErrorCounter> errors;
  errors->Watch(flow);
  return errors->ExpectOneNaming(word) && Check(flow->GetOutput()->GetNumberOfPoints() == 0, "output not empty");
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
  vtkNew<ErrorCounter> errors;
  errors->Watch(drift);
  return errors->ExpectOneNaming(word) && Check(OutputOf(drift)->GetNumberOfPoints() == 0, "output not empty");
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

int TestCurrentDrift(int, char*[])
{
  bool good = CheckUniform();
  good &= CheckVortex();
  good &= CheckCapture();
  good &= CheckWaterIsLeftByNone();
  good &= CheckTimeOrderAndThreads(false, 0.0);
  good &= CheckTimeOrderAndThreads(true, 0.0);
  good &= CheckTimeOrderAndThreads(true, 1.7);
  good &= CheckAnywhere();
  good &= CheckChangingCurrent();
  good &= CheckGrids();
  good &= CheckOcean();
  good &= CheckGridsThroughWalls();
  good &= CheckNoCurrent();
  good &= CheckParticles();
  good &= CheckBadInput();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
