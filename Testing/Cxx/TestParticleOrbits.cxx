// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Sea states and orbits through the pipeline: time in any order, threads, blocks, slaves, and every bad input.
#include "Check.h"
#include "ErrorCounter.h"
#include "FilledArray.h"
#include "vtkParticleOrbitFilter.h"
#include "vtkSeaStateSource.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <iostream>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace
{

using Sea = vtkSeaStateSource;
using Orbits = vtkParticleOrbitFilter;

/// Particles from 0 to 40 m below the sea, in single or double precision.
vtkNew<vtkPolyData> Particles(int count, int type = VTK_DOUBLE)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  for (int n = 0; n < count; ++n)
  {
    points->InsertNextPoint(0.37 * n, 50.0 * std::sin(0.1 * n), -40.0 * n / count);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  return data;
}

std::vector<char> BytesOf(vtkDataArray* array)
{
  const char* begin = static_cast<const char*>(array->GetVoidPointer(0));
  return { begin, begin + array->GetNumberOfValues() * array->GetDataTypeSize() };
}

std::vector<char> Moved(Orbits* orbits, double time)
{
  orbits->UpdateTimeStep(time);
  return BytesOf(vtkPolyData::SafeDownCast(orbits->GetOutputDataObject(0))->GetPoints()->GetData());
}

bool CheckTimeOrderAndThreads()
{
  bool good = true;
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    vtkNew<Sea> sea;
    sea->SetWaterDepth(25.0);
    const auto make = [&](Orbits* orbits) {
      orbits->SetInputData(0, Particles(30000, type));
      orbits->SetSeaStateConnection(sea->GetOutputPort());
    };
    vtkNew<Orbits> direct;
    make(direct);
    const std::vector<char> wanted = Moved(direct, 7.3);
    vtkNew<Orbits> other;
    make(other);
    for (int time = 0; time <= 7; ++time)
    {
      good &= Check(Moved(other, time) != wanted, "time has no effect");
    }
    good &= Check(Moved(other, 7.3) == wanted, "another state after 0 to 7");
    Moved(other, 20.0);
    good &= Check(Moved(other, 7.3) == wanted, "another state after 20 and back");
    for (const int threads : { 1, 2 })
    {
      vtkSMPTools::Initialize(threads);
      vtkNew<Orbits> again;
      make(again);
      good &= Check(Moved(again, 7.3) == wanted, "another state on other threads");
    }
    vtkSMPTools::Initialize(0);
    good &= Check(vtkPolyData::SafeDownCast(direct->GetOutputDataObject(0))->GetPoints()->GetDataType() == type,
      "another precision");
  }
  return good;
}

/// Frames take each other's memory, but never that of a frame that is held; the input is looked at again as it changes.
bool CheckFrames()
{
  bool good = true;
  vtkNew<Sea> sea;
  vtkNew<vtkPolyData> particles = Particles(20000, VTK_FLOAT);
  vtkNew<Orbits> orbits;
  orbits->SetInputData(0, particles);
  orbits->SetSeaStateConnection(sea->GetOutputPort());
  const auto points = [](Orbits* of) { return vtkPolyData::SafeDownCast(of->GetOutputDataObject(0))->GetPoints(); };
  const std::vector<char> first = Moved(orbits, 1.0);
  const vtkSmartPointer<vtkDataArray> held = points(orbits)->GetData();
  std::set<void*> places;
  for (int frame = 0; frame < 6; ++frame)
  {
    Moved(orbits, 2.0 + frame);
    places.insert(points(orbits)->GetData()->GetVoidPointer(0));
  }
  good &= Check(BytesOf(held) == first && places.count(held->GetVoidPointer(0)) == 0, "a held frame has changed");
  good &= Check(places.size() == 1, "frames take new memory each");
  double bounds[6];
  particles->GetPoints()->SetPoint(7, 1e4, 0.0, -3.0);
  particles->GetPoints()->Modified();
  Moved(orbits, 1.0);
  points(orbits)->GetBounds(bounds);
  vtkDataArray* centers = vtkPolyData::SafeDownCast(orbits->GetOutputDataObject(0))->GetPointData()->GetArray("Center");
  good &= Check(bounds[1] > 9990.0 && centers->GetRange(0)[1] == 1e4, "ranges of another frame");
  particles->GetPoints()->SetPoint(7, std::nan(""), 0.0, -3.0);
  particles->GetPoints()->Modified();
  return good & Check(FailsNaming("not finite", orbits), "a point without a place is moved");
}

vtkPolyData* LeafOf(Orbits* orbits)
{
  return vtkPolyData::SafeDownCast(vtkMultiBlockDataSet::SafeDownCast(orbits->GetOutputDataObject(0))->GetBlock(0));
}

/// Arrays with their names and values, and which of them are attributes.
std::vector<std::vector<char>> ContentOf(vtkDataSetAttributes* arrays)
{
  std::vector<std::vector<char>> content;
  for (int index = 0; index < arrays->GetNumberOfArrays(); ++index)
  {
    const std::string name = arrays->GetArrayName(index);
    content.emplace_back(name.begin(), name.end());
    content.push_back(BytesOf(arrays->GetArray(index)));
    content.back().push_back(static_cast<char>(arrays->IsArrayAnAttribute(index)));
  }
  return content;
}

std::vector<std::vector<char>> ContentOf(vtkPolyData* leaf)
{
  std::vector<std::vector<char>> content = ContentOf(leaf->GetPointData());
  content.push_back(BytesOf(leaf->GetPoints()->GetData()));
  for (const std::vector<char>& bytes : ContentOf(leaf->GetCellData()))
  {
    content.push_back(bytes);
  }
  const auto cells = static_cast<std::size_t>(leaf->GetNumberOfVerts());
  const auto fields = static_cast<std::size_t>(leaf->GetFieldData()->GetNumberOfArrays());
  content.emplace_back(cells, 'v');
  content.emplace_back(fields, 'f');
  return content;
}

/// Leaves of a composite are those of a fresh filter whatever changes from frame to frame, the same objects where
/// nobody holds them, and stay as they are where somebody does.
bool CheckLeaves()
{
  bool good = true;
  vtkNew<Sea> sea;
  vtkNew<vtkPolyData> particles = Particles(50, VTK_FLOAT);
  AddFilled<vtkFloatArray>(particles, "Alpha", 1.0f);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, particles);
  const auto make = [&] {
    auto orbits = vtkSmartPointer<Orbits>::New();
    orbits->SetInputData(0, blocks);
    orbits->SetSeaStateConnection(sea->GetOutputPort());
    return orbits;
  };
  vtkNew<vtkCellArray> vertices;
  const std::vector<std::function<void(Orbits*)>> changes = { [](Orbits*) {},
    [&](Orbits*) { AddFilled<vtkFloatArray>(particles, "Alpha", 0.5f); }, [](Orbits* of) { of->GenerateVelocityOn(); },
    [](Orbits* of) { of->GenerateVelocityOff(); },
    [&](Orbits*) { particles->GetPointData()->SetActiveScalars("Alpha"); },
    [&](Orbits*) { AddFilled<vtkFloatArray>(particles, "Size", 2.0f); },
    [&](Orbits*) { particles->GetPointData()->RemoveArray("Alpha"); },
    [&](Orbits*) { particles->GetFieldData()->AddArray(particles->GetPointData()->GetArray("Size")); },
    [&](Orbits*) { particles->SetVerts(vertices); },
    [&](Orbits*) {
      const vtkIdType first = 0;
      vertices->InsertNextCell(1, &first);
      vertices->Modified();
    },
    [&](Orbits*) { particles->SetPoints(Particles(50, VTK_FLOAT)->GetPoints()); } };
  const auto orbits = make();
  std::set<vtkPolyData*> leaves;
  double time = 0.0;
  for (const auto& change : changes)
  {
    change(orbits);
    blocks->Modified();
    const auto fresh = make();
    fresh->SetGenerateVelocity(orbits->GetGenerateVelocity());
    time += 0.5;
    orbits->UpdateTimeStep(time);
    fresh->UpdateTimeStep(time);
    good &= Check(ContentOf(LeafOf(orbits)) == ContentOf(LeafOf(fresh)), "a leaf differs from a fresh one");
    leaves.insert(LeafOf(orbits));
  }
  good &= Check(leaves.size() < changes.size(), "each frame has a new leaf");
  const vtkSmartPointer<vtkPolyData> held = LeafOf(orbits);
  const std::vector<std::vector<char>> content = ContentOf(held);
  orbits->UpdateTimeStep(9.0);
  return good & Check(LeafOf(orbits) != held && ContentOf(held) == content, "a leaf that was held has changed");
}

bool CheckSurface()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0.0, 0.0, 450.0);
  plane->SetPoint1(60.0, 0.0, 450.0);
  plane->SetPoint2(0.0, 60.0, 450.0);
  plane->SetResolution(50, 50);
  vtkNew<Sea> sea;
  sea->SetSeaLevel(450.0);
  sea->SetWaterDepth(3.0);
  sea->SetWindSpeed(5.0);
  vtkNew<Orbits> orbits;
  orbits->SetInputConnection(0, plane->GetOutputPort());
  orbits->SetSeaStateConnection(sea->GetOutputPort());
  orbits->GenerateVelocityOn();
  orbits->GenerateAccelerationOn();
  orbits->UpdateTimeStep(3.0);
  auto* output = vtkPolyData::SafeDownCast(orbits->GetOutputDataObject(0));
  vtkPointData* arrays = output->GetPointData();
  bool good = Check(arrays->GetNormals() && arrays->GetArray("Jacobian") && arrays->GetArray("Velocity") &&
      arrays->GetArray("Acceleration") && arrays->GetArray("Center")->GetComponent(0, 2) == 450.0,
    "an array is missing");
  const double* bounds = output->GetBounds();
  good &= Check(bounds[4] > 449.0 && bounds[4] < 449.95 && bounds[5] > 450.05 && bounds[5] < 451.0, "no sea");
  double range[2];
  arrays->GetArray("Jacobian")->GetRange(range);
  good &= Check(range[0] > 0.0 && range[0] < 1.0 && range[1] > 1.0 && range[1] < 2.5, "no Jacobian");
  auto* regime = vtkStringArray::SafeDownCast(output->GetFieldData()->GetAbstractArray("DepthRegime"));
  good &= Check(regime && regime->GetValue(0) == "intermediate", "another regime");
  vtkInformation* info = orbits->GetOutputInformation(0);
  const double* times = info->Get(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
  return good & Check(times && times[1] == 60.0, "no time range");
}

bool CheckCountsAndSlaves()
{
  vtkNew<vtkPolyData> particles = Particles(5);
  vtkNew<vtkIntArray> counts;
  counts->SetName("TrainCount");
  vtkNew<vtkIntArray> masters;
  masters->SetName("MasterId");
  vtkNew<vtkDoubleArray> offset;
  offset->SetName("Offset");
  offset->SetNumberOfComponents(3);
  const int countOf[5] = { 30, 0, 5, 30, 0 };
  const int masterOf[5] = { -1, 1, -1, 0, -1 };
  for (int id = 0; id < 5; ++id)
  {
    counts->InsertNextValue(countOf[id]);
    masters->InsertNextValue(masterOf[id]);
    offset->InsertNextTuple3(0.5, -0.25, -0.125);
  }
  particles->GetPointData()->AddArray(counts);
  particles->GetPointData()->AddArray(masters);
  particles->GetPointData()->AddArray(offset);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(1, particles);
  vtkNew<Sea> sea;
  vtkNew<Orbits> orbits;
  orbits->SetInputData(0, blocks);
  orbits->SetSeaStateConnection(sea->GetOutputPort());
  orbits->GenerateVelocityOn();
  orbits->UpdateTimeStep(2.0);
  auto* moved = vtkMultiBlockDataSet::SafeDownCast(orbits->GetOutputDataObject(0));
  auto* output = vtkPolyData::SafeDownCast(moved->GetBlock(1));
  double p[5][3];
  double rest[5][3];
  for (int id = 0; id < 5; ++id)
  {
    output->GetPoint(id, p[id]);
    particles->GetPoint(id, rest[id]);
  }
  bool good = Check(!moved->GetBlock(0), "a block from nowhere");
  good &= Check(p[1][0] == rest[1][0] && p[1][2] == rest[1][2], "a point without trains moves");
  good &= Check(std::equal(p[4], p[4] + 3, rest[4]), "a point without trains moves behind slaves");
  good &= Check(p[2][0] != rest[2][0] && p[0][0] != rest[0][0], "a point with trains does not move");
  good &= Check(std::abs(p[3][0] - p[0][0] - 0.5) < 1e-12 && std::abs(p[3][1] - p[0][1] + 0.25) < 1e-12 &&
      std::abs(p[3][2] - p[0][2] + 0.125) < 1e-12,
    "a slave leaves its master");
  vtkDataArray* speed = output->GetPointData()->GetArray("Velocity");
  good &= Check(speed->GetComponent(3, 0) == speed->GetComponent(0, 0), "a slave has a speed of its own");

  // The first five trains alone.
  vtkNew<vtkTable> few;
  sea->Update();
  few->DeepCopy(sea->GetOutput());
  while (few->GetNumberOfRows() > 5)
  {
    few->RemoveRow(few->GetNumberOfRows() - 1);
  }
  vtkNew<Orbits> alone;
  alone->SetInputData(0, Particles(5));
  alone->SetInputData(1, few);
  alone->UpdateTimeStep(2.0);
  double q[3];
  vtkPolyData::SafeDownCast(alone->GetOutputDataObject(0))->GetPoint(2, q);
  return good & Check(std::memcmp(q, p[2], sizeof q) == 0, "TrainCount takes other trains");
}

bool SeaFails(const char* word, const std::function<void(Sea*)>& spoil)
{
  vtkNew<Sea> sea;
  spoil(sea);
  return FailsNaming(word, sea) && Check(sea->GetOutput()->GetNumberOfColumns() == 0, "output not empty");
}

vtkNew<vtkTable> Spectrum(const std::vector<double>& hertz, const std::vector<double>& densities)
{
  vtkNew<vtkDoubleArray> frequency;
  frequency->SetName("Frequency");
  vtkNew<vtkDoubleArray> density;
  density->SetName("Density");
  for (std::size_t row = 0; row < hertz.size(); ++row)
  {
    frequency->InsertNextValue(hertz[row]);
    density->InsertNextValue(densities[row]);
  }
  vtkNew<vtkTable> table;
  table->AddColumn(frequency);
  table->AddColumn(density);
  return table;
}

bool TableFails(const char* word, const std::vector<double>& hertz, const std::vector<double>& densities)
{
  return SeaFails(word, [&](Sea* sea) {
    sea->SetSpectrum(Sea::Table);
    sea->SetInputData(Spectrum(hertz, densities));
  });
}

bool OrbitsFail(const char* word, const std::function<void(Orbits*, vtkPolyData*, vtkTable*)>& spoil)
{
  vtkNew<Sea> sea;
  sea->SetWaterDepth(10.0);
  sea->Update();
  vtkNew<vtkTable> trains;
  trains->DeepCopy(sea->GetOutput());
  vtkNew<vtkPolyData> particles = Particles(10);
  vtkNew<Orbits> orbits;
  orbits->SetInputData(0, particles);
  orbits->SetInputData(1, trains);
  spoil(orbits, particles, trains);
  return FailsNaming(word, orbits) &&
    Check(vtkPolyData::SafeDownCast(orbits->GetOutputDataObject(0))->GetNumberOfPoints() == 0, "output not empty");
}

bool CheckBadInput()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  bool good = true;
  good &= SeaFails("Spectrum", [](Sea* s) { s->SetSpectrum(6); });
  good &= SeaFails("Spectrum", [](Sea* s) { s->SetSpectrum(-1); });
  good &= SeaFails("SeaBy", [](Sea* s) { s->SetSeaBy(2); });
  good &= SeaFails("WindSpeed", [](Sea* s) { s->SetWindSpeed(0.0); });
  good &= SeaFails("WindSpeed", [=](Sea* s) { s->SetWindSpeed(nan); });
  good &= SeaFails("SignificantWaveHeight", [](Sea* s) {
    s->SetSeaBy(Sea::HeightAndPeriod);
    s->SetSignificantWaveHeight(-1.0);
  });
  good &= SeaFails("PeakPeriod", [](Sea* s) {
    s->SetSeaBy(Sea::HeightAndPeriod);
    s->SetPeakPeriod(0.0);
  });
  good &= SeaFails("PeakEnhancement", [](Sea* s) {
    s->SetSpectrum(Sea::JONSWAP);
    s->SetPeakEnhancement(0.5);
  });
  good &= SeaFails("WaterDepth", [](Sea* s) { s->SetWaterDepth(-3.0); });
  good &= SeaFails("WaterDepth", [=](Sea* s) { s->SetWaterDepth(nan); });
  good &= SeaFails("WaterDepth of 3 m holds waves of at most 1.77 m", [](Sea* s) {
    s->SetSeaByToHeightAndPeriod();
    s->SetWaterDepth(3.0);
  });
  good &= SeaFails("SeaLevel", [=](Sea* s) { s->SetSeaLevel(nan); });
  good &= SeaFails("NumberOfTrains", [](Sea* s) { s->SetNumberOfTrains(0); });
  good &= SeaFails("NumberOfTrains", [](Sea* s) { s->SetNumberOfTrains(2000000000); });
  good &= SeaFails("FrequencyRange", [](Sea* s) { s->SetFrequencyRange(4.0, 0.5); });
  good &= SeaFails("FrequencyRange", [](Sea* s) { s->SetFrequencyRange(0.0, 1e-3); });
  good &= SeaFails("MeanDirection", [=](Sea* s) { s->SetMeanDirection(nan); });
  good &= SeaFails("Spreading", [](Sea* s) { s->SetSpreading(-1.0); });
  good &= SeaFails("table", [](Sea* s) { s->SetSpectrum(Sea::Table); });
  good &= TableFails("Density", { 0.1, 0.2, 0.3 }, { 1.0, -2.0, 1.0 });
  good &= TableFails("Frequency", { 0.1, 0.1, 0.3 }, { 1.0, 2.0, 1.0 });
  good &= TableFails("Density", { 0.1, 0.2 }, { 0.0, 0.0 });

  good &= OrbitsFail("no wave trains", [](Orbits* o, vtkPolyData*, vtkTable*) {
    vtkNew<vtkTable> none;
    o->SetInputData(1, none);
  });
  good &= OrbitsFail("Phase", [](Orbits*, vtkPolyData*, vtkTable* t) { t->RemoveColumnByName("Phase"); });
  good &= OrbitsFail("another depth", [](Orbits*, vtkPolyData*, vtkTable* t) {
    vtkDoubleArray::SafeDownCast(t->GetFieldData()->GetArray("WaterDepth"))->SetValue(0, 3.0);
  });
  good &= OrbitsFail("Amplitude", [=](Orbits*, vtkPolyData*, vtkTable* t) {
    vtkDoubleArray::SafeDownCast(t->GetColumnByName("Amplitude"))->SetValue(3, nan);
  });
  good &= OrbitsFail("Choppiness", [](Orbits* o, vtkPolyData*, vtkTable*) { o->SetChoppiness(1.5); });
  good &= OrbitsFail("TimeRange", [](Orbits* o, vtkPolyData*, vtkTable*) { o->SetTimeRange(3.0, 3.0); });
  good &= OrbitsFail("Current", [=](Orbits* o, vtkPolyData*, vtkTable*) {
    o->DopplerShiftOn();
    o->SetCurrent(nan, 0.0);
  });
  good &=
    OrbitsFail("TrainCount", [](Orbits*, vtkPolyData* p, vtkTable*) { AddFilled<vtkIntArray>(p, "TrainCount", -1); });
  good &= OrbitsFail("Offset", [](Orbits*, vtkPolyData* p, vtkTable*) { AddFilled<vtkIntArray>(p, "MasterId", -1); });
  good &= OrbitsFail("MasterId", [](Orbits*, vtkPolyData* p, vtkTable*) {
    AddFilled<vtkIntArray>(p, "MasterId", 10);
    vtkNew<vtkDoubleArray> offset;
    offset->SetName("Offset");
    offset->SetNumberOfComponents(3);
    offset->SetNumberOfTuples(10);
    offset->Fill(0.0);
    p->GetPointData()->AddArray(offset);
  });

  // Nothing to move is no error.
  vtkNew<Sea> sea;
  vtkNew<vtkPolyData> nothing;
  vtkNew<Orbits> orbits;
  orbits->SetInputData(0, nothing);
  orbits->SetSeaStateConnection(sea->GetOutputPort());
  vtkNew<ErrorCounter> errors;
  errors->Watch(orbits);
  orbits->Update();
  good &= Check(errors->Count == 0, "an empty input is an error");
  return good;
}

double Field(Sea* sea, const char* name)
{
  return sea->GetOutput()->GetFieldData()->GetArray(name)->GetTuple1(0);
}

/// The sum of half the squares of amplitudes.
double Energy(Sea* sea)
{
  vtkDataArray* amplitude = vtkDataArray::SafeDownCast(sea->GetOutput()->GetColumnByName("Amplitude"));
  double energy = 0.0;
  for (vtkIdType row = 0; row < amplitude->GetNumberOfTuples(); ++row)
  {
    energy += 0.5 * amplitude->GetTuple1(row) * amplitude->GetTuple1(row);
  }
  return energy;
}

bool CheckMeasuredSpectrum()
{
  vtkNew<Sea> sea;
  sea->SetSpectrum(Sea::Table);
  sea->SetInputData(Spectrum({ 0.05, 0.1, 0.2, 0.5 }, { 0.0, 4.0, 1.0, 0.0 }));
  vtkNew<ErrorCounter> messages;
  messages->Watch(sea);
  messages->WatchWarnings();
  bool good = true;
  for (const bool all : { true, false })
  {
    sea->SetFrequencyRange(all ? 0.0 : 0.5, all ? 0.0 : 5.0);
    sea->Update();
    good &= Check(std::abs(Energy(sea) - 0.5) < 1e-12, "another energy than the table's");
    good &= Check(std::abs(Field(sea, "SignificantWaveHeight") - 4.0 * std::sqrt(0.5)) < 1e-12, "another height");
    good &= Check(std::abs(Field(sea, "PeakPeriod") - 10.0) < 1e-12, "another period");
    good &= Check(Field(sea, "EnergyLeftOut") < 1e-12, "energy of the table is left out");
  }
  good &= Check(messages->Warnings == 0 && messages->Count == 0, "a table is warned of");
  // From 0.1 to 0.2 Hz there are 0.25 of 0.5 m2.
  sea->SetFrequencyRange(1.0, 2.0);
  sea->Update();
  good &= Check(std::abs(Field(sea, "EnergyLeftOut") - 0.5) < 1e-12, "another part is left out");
  good &= Check(std::abs(Field(sea, "SignificantWaveHeight") - 2.0) < 1e-12, "the height is not that of the trains");
  return good &
    Check(messages->Warnings == 1 && messages->LastWarning.find("FrequencyRange") != std::string::npos,
      "half of the energy is left out in silence");
}

constexpr double Pi = 3.14159265358979323846;

struct RegularWave
{
  double Height;
  double Period;
  double Depth; ///< 0: deep

  double Frequency() const { return 2.0 * Pi / this->Period; } ///< [rad/s]
};

/// Wave number k by bisection of w2 = g k tanh kh.
double WaveNumberOf(const RegularWave& wave)
{
  const double w = wave.Frequency();
  double low = 0.0;
  double high = w * w / 9.80665 + w / std::sqrt(9.80665 * (wave.Depth > 0.0 ? wave.Depth : 1e9));
  for (int halving = 0; halving < 200; ++halving)
  {
    const double k = 0.5 * (low + high);
    (9.80665 * k * (wave.Depth > 0.0 ? std::tanh(k * wave.Depth) : 1.0) < w * w ? low : high) = k;
  }
  return 0.5 * (low + high);
}

/// The state of a regular wave has one train, whatever is said of the cut of spectra.
bool CheckRegularState(Sea* sea, double height, double period)
{
  bool good = true;
  vtkNew<vtkTable> plain;
  plain->DeepCopy(sea->GetOutput());
  good &= Check(plain->GetNumberOfRows() == 1, "not one train");
  good &= Check(std::abs(Field(sea, "SignificantWaveHeight") / (std::sqrt(2.0) * height) - 1.0) < 1e-12 &&
      std::abs(Field(sea, "PeakPeriod") / period - 1.0) < 1e-12 &&
      std::abs(Field(sea, "Period") / period - 1.0) < 1e-12 && Field(sea, "EnergyLeftOut") == 0.0,
    "field data of another wave");
  sea->SetNumberOfTrains(70);
  sea->SetFrequencyRange(0.95, 1.05);
  sea->SetSpreading(3.0);
  sea->SetSeed(9);
  sea->EqualSpacingOn();
  sea->SetPeakEnhancement(0.5);
  sea->Update();
  for (vtkIdType column = 0; column < plain->GetNumberOfColumns(); ++column)
  {
    good &= Check(sea->GetOutput()->GetValue(0, column) == plain->GetValue(0, column), "the cut has an effect");
  }
  return good;
}

/// Orbits have the axes H/2 cosh k(z+h) / sinh kh and H/2 sinh k(z+h) / sinh kh.
bool CheckRegularOrbits(Sea* sea, const RegularWave& wave)
{
  bool good = true;
  const double w = wave.Frequency();
  const double k = WaveNumberOf(wave);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0.0, 0.0, 5.0);
  points->InsertNextPoint(7.0, -11.0, 5.0);
  points->InsertNextPoint(-3.0, 2.0, 4.2);
  points->InsertNextPoint(900.0, 40.0, 2.5);
  vtkNew<vtkPolyData> centers;
  centers->SetPoints(points);
  vtkNew<Orbits> orbits;
  orbits->SetInputData(0, centers);
  orbits->SetSeaStateConnection(sea->GetOutputPort());
  for (const double time : { 0.0, 0.3 * wave.Period, 40.1 })
  {
    orbits->UpdateTimeStep(time);
    auto* moved = vtkPolyData::SafeDownCast(orbits->GetOutputDataObject(0));
    for (vtkIdType id = 0; id < 4; ++id)
    {
      const double* x = points->GetPoint(id);
      const double z = x[2] - 5.0;
      const double phase = k * (std::cos(Pi / 6.0) * x[0] + 0.5 * x[1]) - w * time;
      const double y = k * wave.Depth;
      const bool isDeep = wave.Depth == 0.0;
      const double across = 0.5 * wave.Height * (isDeep ? std::exp(k * z) : std::cosh(k * z + y) / std::sinh(y));
      const double up = 0.5 * wave.Height * (isDeep ? std::exp(k * z) : std::sinh(k * z + y) / std::sinh(y));
      const double wanted[3] = { x[0] - across * std::sin(phase) * std::cos(Pi / 6.0),
        x[1] - across * std::sin(phase) * 0.5, x[2] + up * std::cos(phase) };
      for (int axis = 0; axis < 3; ++axis)
      {
        const double error = std::abs(moved->GetPoint(id)[axis] - wanted[axis]);
        good &= Check(error < 1e-9 * wave.Height, "a particle is not on the orbit of the regular wave");
      }
    }
  }
  return good;
}

/// A regular wave is the textbook's, H/2 cos(k d . x - w t) high at its surface.
bool CheckRegularWave()
{
  bool good = true;
  for (const double height : { 0.3, 2.0, 9.0 })
  {
    for (const double period : { 1.5, 6.0, 14.0 })
    {
      for (const double depth : { 3.0, 20.0, 100.0, 0.0 })
      {
        vtkNew<Sea> sea;
        sea->SetSpectrum(Sea::Regular);
        sea->SetSeaBy(Sea::HeightAndPeriod);
        sea->SetSignificantWaveHeight(height);
        sea->SetPeakPeriod(period);
        sea->SetWaterDepth(depth);
        sea->SetSeaLevel(5.0);
        sea->SetMeanDirection(30.0);
        vtkNew<ErrorCounter> messages;
        messages->Watch(sea);
        messages->WatchWarnings();
        sea->Update();
        if (depth > 0.0 && height > 0.78 * depth)
        {
          good &= Check(messages->Count == 1, "a wave that breaks is not refused");
          continue;
        }
        good &= CheckRegularState(sea, height, period);
        good &= Check(messages->Warnings == 0 && messages->Count == 0, "a regular wave is warned of");
        good &= CheckRegularOrbits(sea, { height, period, depth });
      }
    }
  }
  return good;
}

/// A regular wave by a wind has the height and the period of its fully developed sea.
bool CheckRegularWaveByWind()
{
  vtkNew<Sea> sea;
  sea->SetSpectrum(Sea::Regular);
  sea->Update();
  const double height = 400.0 / 9.80665 * std::sqrt(8.1e-3 / (4.0 * 0.74));
  return Check(std::abs(sea->GetOutput()->GetValueByName(0, "Amplitude").ToDouble() - 0.5 * height) < 1e-9 &&
      std::abs(Field(sea, "PeakPeriod") - 7.30) < 5e-3,
    "another regular wave by the wind");
}

/// The closed form of Pierson and Moskowitz says what is left out; more than 2 % is said once.
bool CheckEnergyLeftOut()
{
  bool good = true;
  for (const auto& range : { std::array<double, 2>{ 0.5, 4.0 }, { 0.5, 2.9 }, { 0.5, 2.7 }, { 0.8, 1.2 } })
  {
    vtkNew<Sea> sea;
    sea->SetFrequencyRange(range[0], range[1]);
    vtkNew<ErrorCounter> messages;
    messages->Watch(sea);
    messages->WatchWarnings();
    sea->Update();
    const double left = 1.0 - std::exp(-1.25 / std::pow(range[1], 4.0)) + std::exp(-1.25 / std::pow(range[0], 4.0));
    // 4 U2 / g sqrt(alpha / (4 beta)), of a wind of 10 m/s
    const double height = 400.0 / 9.80665 * std::sqrt(8.1e-3 / (4.0 * 0.74) * (1.0 - left));
    good &= Check(std::abs(Field(sea, "EnergyLeftOut") - left) < 1e-12, "another part is left out");
    good &= Check(std::abs(Field(sea, "SignificantWaveHeight") - height) < 1e-9, "another height of the trains");
    good &= Check(messages->Warnings == (left > 0.02 ? 1 : 0), "a warning too many or too few");
  }
  // Storms over a shallow bed too are no reason for a warning at the default range.
  for (const int spectrum : { Sea::PiersonMoskowitz, Sea::JONSWAP, Sea::TMA })
  {
    for (const double depth : { 0.0, 0.5, 5.0, 50.0 })
    {
      vtkNew<Sea> sea;
      sea->SetSpectrum(spectrum);
      sea->SetWindSpeed(20.0);
      sea->SetWaterDepth(depth);
      vtkNew<ErrorCounter> messages;
      messages->Watch(sea);
      messages->WatchWarnings();
      sea->Update();
      good &=
        Check(messages->Warnings == 0 && Field(sea, "EnergyLeftOut") < 0.011, "the default range leaves out much");
      good &= Check(std::isinf(Field(sea, "Period")), "a sea at random frequencies has a period");
    }
  }
  // Directions of a measured spectrum are not used, and this is told.
  vtkNew<vtkTable> table = Spectrum({ 0.05, 0.1, 0.3 }, { 0.0, 2.0, 0.0 });
  vtkNew<vtkDoubleArray> directions;
  directions->SetName("Direction");
  directions->SetNumberOfTuples(3);
  directions->FillComponent(0, 200.0);
  table->AddColumn(directions);
  vtkNew<Sea> measured;
  measured->SetSpectrum(Sea::Table);
  measured->SetInputData(table);
  vtkNew<ErrorCounter> messages;
  messages->Watch(measured);
  messages->WatchWarnings();
  measured->Update();
  good &=
    Check(messages->Warnings == 1 && messages->LastWarning.find("not used: Direction; set Mean") != std::string::npos,
      "directions of a spectrum are ignored in silence");
  return good;
}

/// How far points are from where they were at a time, at most.
double FarthestMove(Orbits* orbits, double from, double to)
{
  const auto places = [orbits](double time) {
    orbits->UpdateTimeStep(time);
    vtkDataArray* points = vtkPolyData::SafeDownCast(orbits->GetOutputDataObject(0))->GetPoints()->GetData();
    std::vector<double> values;
    for (vtkIdType n = 0; n < 3 * points->GetNumberOfTuples(); ++n)
    {
      values.push_back(points->GetComponent(n / 3, static_cast<int>(n % 3)));
    }
    return values;
  };
  const std::vector<double> before = places(from);
  const std::vector<double> after = places(to);
  double farthest = 0.0;
  for (std::size_t n = 0; n < before.size(); ++n)
  {
    farthest = std::max(farthest, std::abs(after[n] - before[n]));
  }
  return farthest;
}

/// With equal spacing the surface and orbits below are the same after a period, and not after a half or a third of one.
bool CheckReturn()
{
  bool good = true;
  double worst = 0.0;
  double worstSingle = 0.0;
  double least = 1e9;
  for (const int spectrum : { Sea::PiersonMoskowitz, Sea::JONSWAP, Sea::TMA, Sea::Table })
  {
    for (const auto& range : { std::array<double, 2>{ 0.0, 0.0 }, { 0.5, 4.0 }, { 0.0, 3.3 }, { 0.77, 2.31 } })
    {
      for (const int count : { 1, 30, 157 })
      {
        for (const double depth : { 0.0, 5.0 })
        {
          vtkObject::GlobalWarningDisplayOff();
          vtkNew<Sea> sea;
          sea->SetInputData(Spectrum({ 0.05, 0.1, 0.2, 0.5 }, { 0.0, 4.0, 1.0, 0.0 }));
          sea->SetSpectrum(spectrum);
          sea->SetFrequencyRange(range.data());
          sea->SetNumberOfTrains(count);
          sea->SetWaterDepth(depth);
          sea->EqualSpacingOn();
          sea->Update();
          vtkObject::GlobalWarningDisplayOn();
          const double period = Field(sea, "Period");
          for (const int type : { VTK_DOUBLE, VTK_FLOAT })
          {
            vtkNew<Orbits> orbits;
            orbits->SetInputData(0, Particles(40, type));
            orbits->SetSeaStateConnection(sea->GetOutputPort());
            double& kept = type == VTK_FLOAT ? worstSingle : worst;
            kept = std::max(kept, FarthestMove(orbits, 1.7, 1.7 + period));
            kept = std::max(kept, FarthestMove(orbits, 0.0, 3.0 * period));
            if (count > 1)
            {
              least = std::min(least, FarthestMove(orbits, 0.0, period / 2.0));
              least = std::min(least, FarthestMove(orbits, 0.0, period / 3.0));
            }
          }
        }
      }
    }
  }
  std::cout << "after a period within " << worst << " m, in single precision " << worstSingle
            << " m; after a part of it " << least << " m and more" << std::endl;
  good &= Check(worst < 1e-9 && worstSingle < 5e-5, "the sea does not return");
  good &= Check(least > 0.1, "the sea returns too early");

  // The defaults, with a Current: at a fixed center the phase of a train runs by k.U more; carried centers return.
  vtkNew<Sea> sea;
  sea->EqualSpacingOn();
  sea->Update();
  const double period = Field(sea, "Period");
  good &= Check(std::abs(period - 63.3) < 0.1, "another period at the defaults");
  vtkNew<Orbits> orbits;
  orbits->SetInputData(0, Particles(40));
  orbits->SetSeaStateConnection(sea->GetOutputPort());
  orbits->SetCurrent(0.5, 0.0);
  good &= Check(FarthestMove(orbits, 0.0, period) < 1e-10, "Current without DopplerShift has an effect");
  orbits->DopplerShiftOn();
  good &= Check(FarthestMove(orbits, 0.0, period) > 0.1, "waves on a current return at a fixed place");
  orbits->DopplerShiftOff();
  orbits->StokesDriftOn();
  good &= Check(FarthestMove(orbits, 0.0, period) > 0.1, "drifting centers return");
  return good;
}

}

int TestParticleOrbits(int, char*[])
{
  bool good = CheckTimeOrderAndThreads();
  good &= CheckFrames();
  good &= CheckLeaves();
  good &= CheckSurface();
  good &= CheckCountsAndSlaves();
  good &= CheckMeasuredSpectrum();
  good &= CheckEnergyLeftOut();
  good &= CheckRegularWave();
  good &= CheckRegularWaveByWind();
  good &= CheckReturn();
  good &= CheckBadInput();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
