// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The scenes that two papers have measured: figure 9 of Setas et al. (trees), tables 1 and 2 of Coulais et al.
// (particles, seaweeds). Times are those of the filters, without drawing; what the papers leave open is in errata.md.
#include "Data/PlantBlocks.h"
#include "vtkCurrentDriftFilter.h"
#include "vtkFlowPrimitiveSource.h"
#include "vtkParticleLevelOfDetailFilter.h"
#include "vtkParticleOrbitFilter.h"
#include "vtkPlantScatterFilter.h"
#include "vtkQuadratPointSource.h"
#include "vtkReevesTreeSource.h"
#include "vtkSeaStateSource.h"
#include "vtkSeaweedDeformationFilter.h"
#include "vtkSeaweedSource.h"
#include "vtkSuspendedParticleSource.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>

namespace
{

constexpr double Frame = 1.0 / 24.0; // s

vtkDataArray* Field(vtkAlgorithm* algorithm, const char* name)
{
  return algorithm->GetOutputDataObject(0)->GetFieldData()->GetArray(name);
}

/// Table 1: 4000 particles in 10 m x 10 m x 1 m of water, 30 wave trains, a uniform current, 3 slaves a master, levels
/// at 2 m and 12 m, 30 m of visibility; the eye is some distance before the box. With one train all that is left is
/// what a particle costs whatever its level. The current writes all places, or tells their way.
void Particles(benchmark::State& state)
{
  const bool levels = state.range(1) != 0;
  const bool selection = state.range(2) != 0;
  const double number = static_cast<double>(state.range(3));
  const double box[12] = { -5.0, 5.0, 0.0, 10.0, -8.5, -7.5, 1.0, 0.01, number, 1.0, 1.0, 1.0 };
  vtkNew<vtkSuspendedParticleSource> particles;
  particles->SetPreset(vtkSuspendedParticleSource::Custom);
  particles->SetAmountIs(vtkSuspendedParticleSource::Count);
  particles->AddBox(box);
  vtkNew<vtkFlowPrimitiveSource> current;
  current->SetStrength(0.1);
  vtkNew<vtkCurrentDriftFilter> drift;
  drift->SetInputConnection(0, particles->GetOutputPort());
  drift->AddCurrentConnection(current->GetOutputPort());
  drift->SetWayAsField(state.range(5) != 0);
  vtkNew<vtkSeaStateSource> sea;
  sea->SetNumberOfTrains(static_cast<int>(state.range(4)));
  vtkNew<vtkParticleLevelOfDetailFilter> select;
  select->SetInputConnection(0, drift->GetOutputPort());
  select->SetSeaStateConnection(sea->GetOutputPort());
  select->SetUseLevels(levels);
  select->SetUseCulling(levels);
  select->SetTrainSelection(
    selection ? vtkParticleLevelOfDetailFilter::PerTrain : vtkParticleLevelOfDetailFilter::AllTrains);
  select->SetVisibleDistance(30.0);
  select->SetViewPoint(0.0, -static_cast<double>(state.range(0)), -8.0);
  select->SetViewDirection(0.0, 1.0, 0.0);
  select->SetViewAngle(45.0);
  select->SetAspectRatio(4.0 / 3.0);
  select->SetViewHeight(480);
  vtkNew<vtkParticleOrbitFilter> orbits;
  orbits->SetInputConnection(0, select->GetOutputPort());
  orbits->SetSeaStateConnection(sea->GetOutputPort());
  // Three frames fill the arrays that all later ones take in turn.
  for (int frame = 0; frame < 3; ++frame)
  {
    orbits->UpdateTimeStep(Frame * frame);
  }
  state.counters["train sums"] = Field(select, "TrainSums")->GetTuple1(0);
  int frame = 2;
  while (state.KeepRunning())
  {
    // Four seconds, over and over: the current carries the particles by four decimetres at most, and levels are chosen
    // anew after each two of them.
    orbits->UpdateTimeStep(Frame * (1 + frame++ % 95));
  }
}
BENCHMARK(Particles)
  ->ArgNames({ "distance", "levels", "selection", "size", "trains", "told" })
  ->ArgsProduct({ { 0, 3, 6, 9, 12 }, { 0, 1 }, { 0, 1 }, { 1000, 4000 }, { 30 }, { 0 } })
  ->ArgsProduct({ { 0, 3, 6, 9, 12 }, { 0, 1 }, { 0, 1 }, { 400000 }, { 30 }, { 0, 1 } })
  ->ArgsProduct({ { 0, 3, 6, 9, 12 }, { 0, 1 }, { 0, 1 }, { 400000 }, { 300 }, { 0 } })
  ->Args({ 0, 0, 0, 400000, 1, 0 })
  ->Unit(benchmark::kMillisecond)
  ->MeasureProcessCPUTime();

/// Table 2: seaweeds of six segments with skins on 40 m x 10 m, seen lengthwise, in a swell of 30 wave trains over 10 m
/// and a uniform current, levels at 5 m and 20 m.
struct SeaweedBed
{
  vtkNew<vtkSeaweedDeformationFilter> Move;

  SeaweedBed(long plants, bool levels)
  {
    vtkNew<vtkPoints> sites;
    for (long plant = 0; plant < plants; ++plant)
    {
      // A low-discrepancy sequence: any run of it is spread alike.
      const auto part = [plant](double step) { return std::fmod(0.5 + step * static_cast<double>(plant), 1.0); };
      sites->InsertNextPoint(40.0 * part(0.7548776662466927), 10.0 * part(0.5698402909980532) - 5.0, -10.0);
    }
    vtkNew<vtkPolyData> places;
    places->SetPoints(sites);
    vtkNew<vtkSeaweedSource> weed;
    weed->SetPreset(vtkSeaweedSource::Custom);
    weed->SetForm(vtkSeaweedSource::Tuft);
    weed->SetNumberOfFronds(1);
    weed->SetSegmentsPerBranch(6);
    vtkNew<vtkPlantScatterFilter> scatter;
    scatter->SetInputData(places);
    scatter->AddPrototypeConnection(weed->GetOutputPort());
    scatter->UseLevelsOff();
    scatter->UseCullingOff();
    vtkNew<vtkSeaStateSource> sea;
    sea->SetWaterDepth(10.0);
    vtkNew<vtkFlowPrimitiveSource> current;
    this->Move->SetInputConnection(0, scatter->GetOutputPort());
    this->Move->SetSeaStateConnection(sea->GetOutputPort());
    this->Move->AddCurrentConnection(current->GetOutputPort());
    this->Move->SetMethodToProcedural();
    this->Move->SetUseLevels(levels);
    this->Move->SetNearDistance(5.0);
    this->Move->SetFarDistance(20.0);
    this->Move->SetBlendDistance(0.0);
    this->Move->SetViewPoint(0.0, 0.0, -9.5);
    this->Move->SetViewDirection(1.0, 0.0, 0.0);
    this->Move->SetViewAngle(170.0);
    // Two frames fill the arrays that all later ones take in turn.
    this->Move->UpdateTimeStep(-Frame);
    this->Move->UpdateTimeStep(0.0);
  }
};

void Seaweeds(benchmark::State& state)
{
  SeaweedBed bed(state.range(0), state.range(1) != 0);
  state.counters["segments"] = Field(bed.Move, "SegmentsMoved")->GetTuple1(0);
  int frame = 0;
  while (state.KeepRunning())
  {
    bed.Move->UpdateTimeStep(Frame * ++frame);
  }
}
BENCHMARK(Seaweeds)
  ->ArgNames({ "plants", "levels" })
  ->ArgsProduct({ { 25, 50, 100, 200, 300, 30000 }, { 0, 1 } })
  ->Unit(benchmark::kMillisecond)
  ->MeasureProcessCPUTime();

/// The same on a screen, which holds the last picture; the camera stands still or goes by 1 m/s.
void WatchedSeaweeds(benchmark::State& state)
{
  SeaweedBed bed(state.range(0), state.range(1) != 0);
  vtkNew<vtkMultiBlockDataSet> screen;
  const auto show = [&](int frame) {
    if (state.range(2) != 0)
    {
      bed.Move->SetViewPoint(std::fmod(Frame * frame, 2.0), 0.0, -9.5);
    }
    bed.Move->UpdateTimeStep(Frame * frame);
    screen->ShallowCopy(bed.Move->GetOutputDataObject(0));
  };
  // Four frames fill the arrays that all later ones take in turn.
  int frame = 0;
  while (frame < 4)
  {
    show(++frame);
  }
  while (state.KeepRunning())
  {
    show(++frame);
  }
}
BENCHMARK(WatchedSeaweeds)
  ->ArgNames({ "plants", "levels", "walks" })
  ->ArgsProduct({ { 30000 }, { 0, 1 }, { 0, 1 } })
  ->Unit(benchmark::kMillisecond)
  ->MeasureProcessCPUTime();

/// Figure 9: 1000 trees on 500 m x 500 m, or as dense a forest of fewer or more, with levels of detail, without and
/// with cells, over views from within, spread evenly over places and headings. The shown trees in full are counted.
void Trees(benchmark::State& state)
{
  const double number = static_cast<double>(state.range(1));
  const double side = 500.0 * std::sqrt(number / 1000.0);
  vtkNew<vtkQuadratPointSource> sites;
  sites->SetQuadrats(10, static_cast<int>(number) / 10);
  sites->SetSize(side, side);
  vtkNew<vtkPlantScatterFilter> forest;
  forest->SetInputConnection(0, sites->GetOutputPort());
  std::array<double, 3> polygons = { 0.0, 0.0, 0.0 }; // of each species in full
  for (int species = 0; species < 3; ++species)
  {
    vtkNew<vtkReevesTreeSource> tree;
    tree->SetPreset(species + 1);
    tree->Update();
    auto* high = vtkMultiBlockDataSet::SafeDownCast(littoral::FindBlock(tree->GetOutput(), littoral::plant::High));
    for (unsigned int block = 0; block < high->GetNumberOfBlocks(); ++block)
    {
      polygons[species] += static_cast<double>(vtkPolyData::SafeDownCast(high->GetBlock(block))->GetNumberOfPolys());
    }
    forest->AddPrototypeConnection(tree->GetOutputPort());
  }
  forest->SetUseCulling(state.range(0) != 0);
  forest->SetViewAngle(45.0);
  forest->SetAspectRatio(4.0 / 3.0);
  double shown = 0.0;
  double full = 0.0;
  int view = 0;
  while (state.KeepRunning())
  {
    // Multiples of powers of 1 / 1.2207, the root of g^4 = g + 1, but for wholes.
    ++view;
    const auto part = [view](int power) { return std::fmod((view - 0.5) * std::pow(1.2207440846, -power), 1.0); };
    const double heading = 2.0 * 3.14159265358979323846 * part(3);
    forest->SetViewPoint(side * part(1), side * part(2), 1.7);
    forest->SetViewDirection(std::cos(heading), std::sin(heading), 0.0);
    forest->Update();
    state.PauseTiming();
    shown += Field(forest, "PolygonsShown")->GetTuple1(0);
    vtkDataArray* species = Field(forest, "Species");
    for (vtkIdType plant = 0; plant < species->GetNumberOfTuples(); ++plant)
    {
      full += polygons.at(static_cast<std::size_t>(species->GetTuple1(plant)));
    }
    state.ResumeTiming();
  }
  state.counters["polygons"] = shown / view;
  state.counters["polygons in full"] = full / view;
}
BENCHMARK(Trees)
  ->ArgNames({ "cells", "trees" })
  ->ArgsProduct({ { 0, 1 }, { 100, 1000, 100000, 1000000 } })
  ->Iterations(90)
  ->Unit(benchmark::kMillisecond)
  ->MeasureProcessCPUTime();

}

BENCHMARK_MAIN();
