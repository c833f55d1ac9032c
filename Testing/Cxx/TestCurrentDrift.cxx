// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Drift through the pipeline: uniform flow, vortices, sinks, currents that change, time in any order, threads and
// pieces.
#include "Check.h"
#include "DriftScene.h"
#include "ErrorCounter.h"
#include "vtkParticleOrbitFilter.h"
#include "vtkSeaStateSource.h"
#include "vtkSuspendedParticleSource.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cstring>
#include <utility>

using namespace DriftScene;

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

constexpr double Pi = 3.14159265358979323846;

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
    drift->AddCurrentConnection(first->GetOutputPort());
    drift->AddCurrentConnection(second->GetOutputPort());
    vtkNew<Flow> still = Primitive(Flow::Vortex, 0.0, 0.0, 0.0, 0.0); // makes it take steps
    if (steps)
    {
      drift->AddCurrentConnection(still->GetOutputPort());
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
  drift->AddCurrentConnection(vortex->GetOutputPort());
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
  drift->AddCurrentConnection(source->GetOutputPort());
  drift->AddCurrentConnection(sink->GetOutputPort());
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
  drift->AddCurrentConnection(up->GetOutputPort());
  drift->AddCurrentConnection(vortex->GetOutputPort());
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

bool CheckTimeOrderAndThreads(bool tide, double interval)
{
  bool good = true;
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    const auto make = [&](Drift* drift) {
      Connect(drift, 0.0, 0.0, type, 250);
      if (tide)
      {
        vtkNew<Tide> current;
        current->Interval = interval;
        drift->AddCurrentConnection(current->GetOutputPort());
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
    const std::vector<char> late = Moved(other, 10.0);
    good &= Check(Moved(other, 7.3) == wanted, "another state after 10 and back");
    good &= Check(Moved(other, 7.33) != wanted, "the rest of a step has no effect");
    good &= Check(Moved(other, 7.3) == wanted, "the rest of a step is kept");
    good &= Check(Moved(direct, 10.0) == late, "another state at 10");
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
    drift->AddCurrentConnection(tide->GetOutputPort());
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
  drift->AddCurrentConnection(model->GetOutputPort());
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
  orbits->SetSeaStateConnection(sea->GetOutputPort());
  orbits->UpdateTimeStep(1.3);
  const double* center = OutputOf(orbits)->GetPointData()->GetArray("Center")->GetTuple3(0);
  return good & Check(std::abs(center[0] - 1.3 * Tide::Along) < 1e-12, "orbits have other centers");
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
  empty->AddCurrentConnection(flow->GetOutputPort());
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
  drift->AddCurrentConnection(vortex->GetOutputPort());
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
  whole->AddCurrentConnection(vortex->GetOutputPort());
  const std::vector<char> wanted = Moved(whole, 3.3);
  const std::size_t count = static_cast<std::size_t>(OutputOf(whole)->GetNumberOfPoints());
  std::vector<char> together;
  for (int piece = 0; piece < 3; ++piece)
  {
    vtkNew<Drift> part;
    part->SetInputConnection(0, points->GetOutputPort());
    part->AddCurrentConnection(vortex->GetOutputPort());
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
  many->AddCurrentConnection(vortex->GetOutputPort());
  many->UpdateTimeStep(2.0);
  vtkNew<Drift> single;
  single->SetInputData(0, Particles(700));
  single->AddCurrentConnection(vortex->GetOutputPort());
  single->UpdateTimeStep(2.0);
  auto* moved = vtkMultiBlockDataSet::SafeDownCast(many->GetOutputDataObject(0));
  return good &
    Check(BytesOf(vtkPolyData::SafeDownCast(moved->GetBlock(2))->GetPoints()->GetData()) ==
        BytesOf(OutputOf(single)->GetPoints()->GetData()),
      "blocks drift in another way");
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
  good &= CheckNoCurrent();
  good &= CheckParticles();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
