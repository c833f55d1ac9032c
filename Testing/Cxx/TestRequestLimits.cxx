// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause

// What a request may take and what part of the data it gets: memory by the limits of the process and of its control
// groups, pieces that cover the whole once, and none beyond the last. What was refused leaves nothing behind.

#include "Check.h"
#include "Data/Arrays.h"
#include "ErrorCounter.h"
#include "Numerics/SimdClones.h"
#include "Pipeline/Pipeline.h"

#include "vtkCovarianceFitFilter.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImageSectionFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkParticleFogFilter.h"
#include "vtkParticleLevelOfDetailFilter.h"
#include "vtkParticleOrbitFilter.h"
#include "vtkPlantScatterFilter.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkQuadratPointSource.h"
#include "vtkSeaStateSource.h"
#include "vtkSeaweedDeformationFilter.h"
#include "vtkSeaweedSource.h"
#include "vtkSuspendedParticleSource.h"
#include "vtkTerrainLevelOfDetailFilter.h"
#include "vtkTestUtilities.h"
#include "vtkTurningBandsTerrainSource.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindFieldSource.h"

#include <vtksys/SystemTools.hxx>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>

#ifndef _WIN32
#include <sys/resource.h>
#endif

namespace
{

void WriteFile(const std::string& folder, const std::string& name, const std::string& text)
{
  vtksys::SystemTools::MakeDirectory(folder);
  std::ofstream(folder + "/" + name) << text;
}

bool TestGroups(const std::string& root)
{
  vtksys::SystemTools::RemoveADirectory(root);
  bool good = Check(std::isinf(littoral::GroupMemory("0::/job/step\n", root)), "groups without files are a limit");
  // Version 2: the group around is the closer limit; files that can be dropped do not count as used.
  WriteFile(root + "/job/step", "memory.max", "max\n");
  WriteFile(root + "/job", "memory.max", "1000000\n");
  WriteFile(root + "/job", "memory.current", "400000\n");
  WriteFile(root + "/job", "memory.stat", "anon 150000\ninactive_file 250000\n");
  good &=
    Check(littoral::GroupMemory("0::/job/step\n", root) == 850000.0, "the limit of the group around is not found");
  WriteFile(root + "/job/step", "memory.max", "500000\n");
  WriteFile(root + "/job/step", "memory.current", "600000\n");
  good &= Check(littoral::GroupMemory("0::/job/step\n", root) == 0.0, "a group that is full leaves nothing");
  // Version 1 names controllers; those of others do not count.
  WriteFile(root + "/memory/box", "memory.limit_in_bytes", "3000\n");
  WriteFile(root + "/memory/box", "memory.usage_in_bytes", "1000\n");
  good &= Check(littoral::GroupMemory("7:cpu:/job\n5:memory:/box\n", root) == 2000.0, "version 1 is not read");
  // A container sees its own root, whatever its path is outside.
  WriteFile(root, "memory.max", "70000\n");
  good &= Check(littoral::GroupMemory("0::/elsewhere\n", root) == 70000.0, "the root of a container is not read");
  return good;
}

#ifndef _WIN32
/// Sets the limit of addresses [bytes]; what it leaves, or -1 where there is another limit or a sanitizer, which takes
/// terabytes of addresses.
double LimitedTo(rlim_t bytes)
{
  if (LITTORAL_IS_SANITIZED)
  {
    return -1.0;
  }
  rlimit limit;
  getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = bytes;
  return limit.rlim_max == RLIM_INFINITY && setrlimit(RLIMIT_AS, &limit) == 0 ? littoral::LimitedMemory() : -1.0;
}
#endif

bool TestProcess()
{
  bool good = true;
#ifndef _WIN32
  rlimit before;
  getrlimit(RLIMIT_AS, &before);
  const double left = LimitedTo(static_cast<rlim_t>(64) << 30);
  if (left >= 0.0)
  {
    good &= Check(left > 0.0 && left < 64.0 * 0x1p30, "a limit of the address space is not seen");
    good &= Check(left > 32.0 * 0x1p30, "more is taken to be used than is");
    good &= Check(littoral::AvailableMemory() <= 0.9 * left, "a limit of the address space does not count");
    setrlimit(RLIMIT_AS, &before);
  }
#endif
  return good;
}

/// An array that the limits of the process leave no memory for is an exception; VTK alone would end the program.
bool TestArrays()
{
  bool good = true;
#ifndef _WIN32
  rlimit before;
  getrlimit(RLIMIT_AS, &before);
  const double left = LimitedTo(static_cast<rlim_t>(64) << 30);
  if (left > 0.0)
  {
    const double used = 64.0 * 0x1p30 - left;
    LimitedTo(static_cast<rlim_t>(used + 0x1p25)); // 32 MiB are left
    const auto fits = [](vtkIdType megabytes) {
      try
      {
        return littoral::NewArray<vtkUnsignedCharArray>("Bytes", 4, megabytes << 18)->GetPointer(0) != nullptr;
      }
      catch (const littoral::InvalidInput&)
      {
        return false;
      }
    };
    good &= Check(!fits(64) && !fits(1 << 20) && fits(8), "an array is not refused by the memory that is left");
    setrlimit(RLIMIT_AS, &before);
  }
#endif
  return good;
}

/// The sentence that refuses a task.
template <typename Task>
bool Refuses(const Task& task, const std::string& sentence)
{
  const std::string why = littoral::WhyRefused(task);
  return Check(why == sentence, ("the sentence is: " + why).c_str());
}

bool TestPoints()
{
  bool good = Refuses([] { littoral::RequirePoints(1.6e8, "MeanPerQuadrat", 1e5); },
    "MeanPerQuadrat of 100000 gives 160 million points, more than the bound of 50 million: at most 31250 do.");
  good &= Refuses([] { littoral::RequirePoints(9e7, "Intensity", 0.07); },
    "Intensity of 0.07 gives 90 million points, more than the bound of 50 million: at most 0.0388 do.");
  good &= Refuses(
    [] {
      littoral::RequireGridPoints("A terrain of WholeExtent", { 60001.0, 60001.0 });
    },
    "A terrain of WholeExtent 60001 x 60001 gives 3600 million points, more than the bound of 50 million: at most "
    "7071 x "
    "7071 do.");
  good &= Refuses(
    [] {
      littoral::RequireGridPoints("A wind of Dimensions", { 20000.0, 100.0, 100.0 });
    },
    "A wind of Dimensions 20000 x 100 x 100 gives 200 million points, more than the bound of 50 million: at most 5000 "
    "x 100 "
    "x 100 do.");
  good &= Refuses(
    [] {
      littoral::RequireGridPoints("A field of Dimensions", { 4000.0, 5000.0 }, 4.0);
    },
    "A field of Dimensions 4000 x 5000 takes the time of 80 million points, more than the bound of 50 million: at most "
    "3535 "
    "x 3535 do.");
  good &= Refuses([] { littoral::RequireGridPoints("A field of Dimensions", { 4000.0, 3125.0 }, 4.0); }, "");
  return good;
}

bool TestPieces()
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  bool good = true;
  vtkNew<vtkInformation> output;
  const auto part = [&](int piece, int pieces, long long count) {
    output->Set(Pipeline::UPDATE_PIECE_NUMBER(), piece);
    output->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), pieces);
    return littoral::RequestedPart(output, count);
  };
  for (const long long count : { 0ll, 1ll, 10ll, 400ll, 1ll << 62 })
  {
    for (const int pieces : { 1, 3, 7, 1000000 })
    {
      good &= Check(part(0, pieces, count).Begin == 0, "the first piece does not begin at 0");
      good &= Check(part(pieces - 1, pieces, count).End == count, "the last piece does not end at the end");
      good &= Check(part(pieces / 2, pieces, count).End == part(pieces / 2 + 1, pieces, count).Begin || pieces == 1,
        "pieces overlap or leave gaps");
      for (const int beyond : { pieces, pieces + 3, 2147483647 })
      {
        good &= Check(part(beyond, pieces, count).Begin == count && part(beyond, pieces, count).End == count,
          "a piece beyond the last one is not empty");
      }
    }
  }
  good &= Check(part(-1, 0, 12).Begin == 0 && part(-1, 0, 12).End == 12, "without pieces, all is asked for");

  vtkNew<vtkQuadratPointSource> points;
  points->UpdatePiece(7, 4, 0);
  good &= Check(points->GetOutput()->GetNumberOfPoints() == 0, "points beyond the last piece");
  points->UpdatePiece(0, 1, 0);
  good &= Check(points->GetOutput()->GetNumberOfPoints() > 0, "no points after a piece beyond the last one");

  vtkNew<vtkSuspendedParticleSource> water;
  vtkNew<vtkSeaStateSource> sea;
  vtkNew<vtkParticleLevelOfDetailFilter> levels;
  water->SetDensity(0.05);
  levels->SetInputConnection(0, water->GetOutputPort());
  levels->SetInputConnection(1, sea->GetOutputPort());
  const auto number = [&](const char* of, int piece) {
    levels->UpdatePiece(piece, 4, 0);
    return levels->GetOutput()->GetFieldData()->GetArray(of)->GetComponent(0, 0);
  };
  good &= Check(number("CellsInAll", 7) == 0.0, "cells beyond the last piece");
  good &= Check(number("ParticlesInAll", 7) == 0.0, "particles beyond the last piece");
  double all = 0.0;
  for (int piece = 0; piece < 4; ++piece)
  {
    all += number("ParticlesInAll", piece);
  }
  water->Update();
  good &= Check(all == static_cast<double>(water->GetOutput()->GetNumberOfPoints()), "particles of four pieces");
  return good;
}

/// A terrain and a wind that were refused are, made valid, what fresh ones are.
bool TestRecovery()
{
  const double nan = std::nan("");
  vtkNew<vtkTurningBandsTerrainSource> terrain;
  vtkNew<ErrorCounter> errors;
  errors->Watch(terrain);
  terrain->SetWholeExtent(0, 99, 0, 99, 0, 0);
  terrain->SetNumberOfLines(2147483647);
  bool good = errors->ExpectOneNaming("NumberOfLines");
  terrain->SetNumberOfLines(16);
  terrain->SetNumberOfHarmonics(2147483647);
  good &= errors->ExpectOneNaming("NumberOfHarmonics");
  terrain->SetNumberOfHarmonics(20);
  terrain->SetSpacing(1.0, -1.0, nan);
  good &= errors->ExpectOneNaming("Spacing, y");
  terrain->SetSpacing(1.0, 1.0, nan);
  good &= errors->ExpectOneNaming("Spacing, z");
  terrain->SetSpacing(1.0, 1.0, 1.0);
  terrain->SetOrigin(1e14, 0.0, 0.0);
  good &= errors->ExpectOneNaming("Origin, x");
  terrain->SetOrigin(0.0, 0.0, 0.0);
  terrain->SetSlope(1e300, 0.0);
  good &= errors->ExpectOneNaming("Slope, x");
  terrain->SetSlope(0.0, 0.0);
  terrain->SetWholeExtent(0, 9, 0, 9, 0, 0);
  terrain->Update();
  good &= Check(terrain->GetOutput()->GetNumberOfPoints() == 100, "a terrain keeps the extent of a refused one");

  // Nor does what was asked, beyond the whole extent, while an input failed.
  vtkNew<vtkSeaweedSource> seaweed;
  vtkNew<vtkSeaStateSource> sea;
  vtkNew<vtkSeaweedDeformationFilter> sway;
  sway->SetInputConnection(0, seaweed->GetOutputPort());
  sway->SetInputConnection(1, sea->GetOutputPort());
  vtkNew<ErrorCounter> moved;
  moved->Watch(sway);
  terrain->SetInputConnection(sway->GetOutputPort());
  const int beyond[6] = { 2, 5, 1, 2, 0, 1 };
  terrain->UpdateTimeStep(std::numeric_limits<double>::infinity(), -1, 1, 0, beyond);
  good &= Check(moved->Count == 1, "no message of the input's time");
  terrain->RemoveAllInputConnections(0);
  terrain->UpdateWholeExtent();
  good &= Check(terrain->GetOutput()->GetDimensions()[2] == 1, "layers beyond the whole extent");

  vtkNew<vtkWindFieldSource> wind;
  vtkNew<ErrorCounter> gusts;
  gusts->Watch(wind);
  wind->SetDimensions(1 << 20, 1024, 1024);
  good &= gusts->ExpectOneNaming("Dimensions");
  wind->SetDimensions(16, 4, 4);
  wind->SetReferenceHeight(5e-324);
  good &= gusts->ExpectOneNaming("ReferenceHeight");
  wind->SetReferenceHeight(10.0);
  wind->Update();
  good &= Check(wind->GetOutput()->GetNumberOfPoints() == 256, "a wind keeps the extent of a refused one");

  vtkNew<vtkPlantScatterFilter> scatter;
  vtkNew<ErrorCounter> weights;
  weights->Watch(scatter);
  scatter->SetWeight(2147483646, 2.0);
  good &= Check(weights->Count == 1 && scatter->GetWeight(2147483646) == 1.0, "a weight without a prototype is taken");
  return good;
}

/// Inputs at no place, or beyond any, are refused by name; a grid whose extent is inverted is an empty one.
bool TestPlaces()
{
  const auto move = [](vtkImageData* image, double origin, double spacing) {
    image->SetOrigin(origin, 0.0, 0.0);
    image->SetSpacing(spacing, 1.0, 1.0);
  };
  vtkNew<vtkImageData> image;
  image->SetDimensions(20, 20, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  image->GetPointData()->GetScalars()->Fill(1.0);
  vtkNew<vtkCovarianceFitFilter> fit;
  vtkNew<ErrorCounter> fits;
  fits->Watch(fit);
  fit->SetInputData(image);
  move(image, 0.0, -1.0);
  bool good = fits->ExpectOneNaming("Spacing, x of the image");
  move(image, 0.0, 1e300);
  good &= fits->ExpectOneNaming("Spacing, x of Input");

  vtkNew<vtkImageSectionFilter> sections;
  vtkNew<ErrorCounter> cuts;
  cuts->Watch(sections);
  sections->SetInputData(image);
  move(image, std::nan(""), 1.0);
  good &= cuts->ExpectOneNaming("Origin, x of Input");
  move(image, 0.0, -1.0); // sections may be mirrored
  sections->Update();
  good &= Check(sections->GetOutput()->GetNumberOfPoints() == 400, "no section after a refused one");

  vtkNew<vtkSuspendedParticleSource> water;
  water->SetDensity(0.02);
  water->Update();
  vtkNew<vtkPolyData> particles;
  particles->DeepCopy(water->GetOutputDataObject(0));
  vtkNew<vtkSeaStateSource> sea;
  vtkNew<vtkParticleOrbitFilter> orbits;
  vtkNew<ErrorCounter> waves;
  waves->Watch(orbits);
  orbits->SetInputData(particles);
  orbits->SetInputConnection(1, sea->GetOutputPort());
  particles->GetPoints()->SetPoint(0, 3e15, 0.0, 0.0);
  good &= waves->ExpectOneNaming("beyond 1e+15 at 0");

  vtkNew<vtkParticleFogFilter> far;
  vtkNew<ErrorCounter> mists;
  mists->Watch(far);
  far->SetInputData(particles);
  good &= mists->ExpectOneNaming("beyond 1e+15 at 0");
  particles->GetPoints()->SetPoint(0, 0.0, 0.0, 0.0);
  far->UseBoundsOn();
  far->SetBounds(-10.0, 10.0, -10.0, 1.7e308, -10.0, 0.0);
  good &= mists->ExpectOneNaming("Bounds along y");

  vtkNew<vtkParticleFogFilter> fog;
  fog->SetDimensions(6, 5, 4);
  fog->SetInputConnection(water->GetOutputPort());
  const int inverted[6] = { 5, 2, 0, 3, 0, 0 };
  fog->UpdateExtent(inverted);
  good &= Check(!fog->GetOutput()->GetPointData()->GetScalars(), "fog in an inverted extent");
  fog->UpdateWholeExtent();
  good &= Check(fog->GetOutput()->GetNumberOfPoints() == 120, "no fog after an inverted extent");
  // With ghosts VTK makes an array for the points of an extent: none, not -8.
  fog->UpdatePiece(2, 3, 9, inverted);
  good &= Check(fog->GetOutput()->GetNumberOfPoints() == 0, "points in an inverted extent");

  // What was asked while it was refused does not widen the next request.
  vtkNew<vtkPolyData> nothing;
  nothing->DeepCopy(water->GetOutput());
  nothing->SetPoints(vtkSmartPointer<vtkPoints>::New());
  fog->SetDimensions(9, 5, 6);
  fog->SetInputData(nothing);
  vtkNew<ErrorCounter> refused;
  refused->Watch(fog);
  good &= refused->ExpectOneNaming("Input has an array");
  fog->SetInputConnection(water->GetOutputPort());
  fog->SetDimensions(6, 5, 4);
  fog->UpdateWholeExtent();
  good &= Check(fog->GetOutput()->GetNumberOfPoints() == 120, "another grid after a refused one");
  return good;
}

/// Levels of several blocks do not go into one output, which is said once.
bool TestBlocks()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 5, 1);
  vtkNew<vtkPolyData> particles;
  vtkNew<vtkSeaStateSource> sea;
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, image);
  vtkNew<vtkTerrainLevelOfDetailFilter> terrain;
  vtkNew<ErrorCounter> tiles;
  tiles->Watch(terrain);
  terrain->SetInputDataObject(0, blocks);
  bool good = tiles->ExpectOneNaming("Input is a vtkMultiBlockDataSet; it must be an image");
  vtkNew<vtkParticleLevelOfDetailFilter> levels;
  vtkNew<ErrorCounter> details;
  details->Watch(levels);
  blocks->SetBlock(0, particles);
  levels->SetInputDataObject(0, blocks);
  levels->SetInputConnection(1, sea->GetOutputPort());
  good &= details->ExpectOneNaming("Input is a vtkMultiBlockDataSet; it must be points");
  return good;
}

/// A filter whose request ends by an exception.
class ThrowingOrbits : public vtkParticleOrbitFilter
{
public:
  static ThrowingOrbits* New() { VTK_STANDARD_NEW_BODY(ThrowingOrbits); }
  vtkTypeMacro(ThrowingOrbits, vtkParticleOrbitFilter);

protected:
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override { throw std::bad_alloc(); }
};

/// Refuses its input in a thread, with an output that is made halfway.
class RefusingOrbits : public vtkParticleOrbitFilter
{
public:
  static RefusingOrbits* New() { VTK_STANDARD_NEW_BODY(RefusingOrbits); }
  vtkTypeMacro(RefusingOrbits, vtkParticleOrbitFilter);

protected:
  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    vtkDataObject::GetData(outputs)->ShallowCopy(vtkDataObject::GetData(inputs[0]));
    littoral::SmpFor(1000, [](std::size_t, std::size_t) { littoral::Refuse("a point is none."); });
    return 1;
  }
};

bool TestRefusal()
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkPolyData> particles;
  particles->SetPoints(points);
  vtkNew<RefusingOrbits> orbits;
  vtkNew<ErrorCounter> errors;
  errors->Watch(orbits);
  orbits->SetInputData(particles);
  return errors->ExpectOneNaming("Cannot move points: a point is none.") &&
    Check(orbits->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT) == 0,
      "a refused request leaves an output");
}

bool TestExceptionOfFilter()
{
  vtkNew<ThrowingOrbits> orbits;
  vtkNew<ErrorCounter> errors;
  errors->Watch(orbits);
  vtkNew<vtkPolyData> particles;
  orbits->SetInputData(particles);
  return errors->ExpectOneNaming("not enough memory");
}

bool TestExceptions()
{
  bool caught = false;
  try
  {
    littoral::SmpFor(1000, [](std::size_t begin, std::size_t) {
      if (begin == 0)
      {
        throw std::runtime_error("of a thread");
      }
    });
  }
  catch (const std::runtime_error& error)
  {
    caught = std::string(error.what()) == "of a thread";
  }
  return Check(caught, "an exception of a thread does not reach the one that waits for it");
}

}

int TestRequestLimits(int argc, char* argv[])
{
  char* folder = vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "LITTORAL_TEST_FOLDER", "Testing/Temporary");
  bool good = TestGroups(std::string(folder) + "/groups");
  delete[] folder;
  good &= TestProcess();
  good &= TestArrays();
  good &= TestPoints();
  good &= TestPieces();
  good &= TestPlaces();
  good &= TestBlocks();
  good &= TestExceptions();
  good &= TestExceptionOfFilter();
  good &= TestRefusal();
  good &= TestRecovery();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
