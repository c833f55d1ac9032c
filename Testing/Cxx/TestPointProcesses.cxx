// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Point process source and pattern verdict: pieces, arrays, windows, images, the way from verdict to pattern, and every
// bad input.
#include "Check.h"
#include "ErrorCounter.h"
#include "vtkPatternVerdictFilter.h"
#include "vtkPointProcessSource.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{

using Source = vtkPointProcessSource;
using Verdict = vtkPatternVerdictFilter;

vtkNew<vtkPolyData> Points(const std::vector<std::array<double, 2>>& positions, bool isPolygon = false)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<int>(positions.size()));
  for (const auto& position : positions)
  {
    cells->InsertCellPoint(points->InsertNextPoint(position[0], position[1], 0.0));
  }
  data->SetPoints(points);
  if (isPolygon)
  {
    data->SetPolys(cells);
  }
  return data;
}

vtkNew<vtkImageData> Image(double left, double right)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(10, 10, 1);
  image->SetOrigin(25.0, 25.0, 0.0);
  image->SetSpacing(50.0, 50.0, 1.0);
  image->AllocateScalars(VTK_DOUBLE, 1);
  for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
  {
    image->GetPointData()->GetScalars()->SetTuple1(n, n % 10 < 5 ? left : right);
  }
  return image;
}

bool SourceFails(const char* word, const std::function<void(Source*)>& spoil)
{
  vtkNew<Source> source;
  spoil(source);
  return FailsNaming(word, source) && Check(source->GetOutput()->GetNumberOfPoints() == 0, "output not empty");
}

bool VerdictFails(const char* word, vtkPolyData* points, const std::function<void(Verdict*)>& spoil = {})
{
  vtkNew<Verdict> verdict;
  verdict->SetInputData(points);
  if (spoil)
  {
    spoil(verdict);
  }
  return FailsNaming(word, verdict) && Check(verdict->GetOutput()->GetNumberOfColumns() == 0, "output not empty");
}

bool CheckBadSources()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  bool good = true;
  good &= SourceFails("Process", [](Source* s) { s->SetProcess(7); });
  good &= SourceFails("Softness", [](Source* s) {
    s->SetProcess(Source::SoftCore);
    s->SetSoftness(0.9);
  });
  good &= SourceFails("Distance^2", [](Source* s) {
    s->SetProcess(Source::SoftCore);
    s->SetIntensity(1.0);
  });
  good &= SourceFails("Intensity", [](Source* s) { s->SetIntensity(0.0); });
  good &= SourceFails("Intensity", [](Source* s) { s->SetIntensity(-1.0); });
  good &= SourceFails("ClusterSize", [](Source* s) { s->SetClusterSize(0.0); });
  good &= SourceFails("ClusterScale", [=](Source* s) { s->SetClusterScale(nan); });
  good &= SourceFails("Size", [](Source* s) { s->SetSize(0.0, 3.0); });
  good &= SourceFails("Origin", [=](Source* s) { s->SetOrigin(nan, 3.0); });
  good &= SourceFails("draws", [](Source* s) { s->SetIntensity(1e9); });
  good &= SourceFails("Interaction is 1.5", [](Source* s) {
    s->SetProcess(Source::Strauss);
    s->SetInteraction(1.5);
  });
  good &= SourceFails("Matern II", [](Source* s) {
    s->SetProcess(Source::MaternII);
    s->SetIntensity(0.03);
  });
  good &= SourceFails("Variance", [](Source* s) {
    s->SetProcess(Source::LogGaussianCox);
    s->SetVariance(-1.0);
  });
  good &= SourceFails("NumberOfSpecies", [](Source* s) { s->SetNumberOfSpecies(0); });
  good &= SourceFails("SpeciesGrouping", [](Source* s) { s->SetSpeciesGrouping(2); });
  good &= SourceFails("CrossInteraction", [](Source* s) { s->SetCrossInteraction(-0.1); });
  good &= SourceFails("IntensityScale", [](Source* s) { s->SetIntensityScale(2); });
  good &= SourceFails("MarkMean", [](Source* s) {
    s->MarksOn();
    s->SetMarkMean(0.0);
  });
  const auto negative = Image(-1.0, 2.0);
  const auto zero = Image(0.0, 0.0);
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(3, 3, 1);
  good &= SourceFails("Intensity of the image is -1", [&](Source* s) { s->SetInputData(1, negative); });
  good &= SourceFails("0 everywhere", [&](Source* s) { s->SetInputData(1, zero); });
  good &= SourceFails("no point array", [&](Source* s) { s->SetInputData(1, bare); });
  good &= SourceFails("Density", [&](Source* s) {
    s->SetInputData(1, bare);
    s->SetIntensityArray("Density");
  });
  const auto crossed = Points({ { 0, 0 }, { 9, 9 }, { 9, 0 }, { 0, 5 } }, true);
  good &= SourceFails("cross", [&](Source* s) { s->SetInputData(2, crossed); });
  vtkNew<vtkTable> empty;
  good &= SourceFails("ProcessId", [&](Source* s) { s->SetInputData(empty); });
  return good;
}

bool CheckBadVerdicts()
{
  bool good = true;
  const auto five = Points({ { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 }, { 0.5, 0.2 }, { 0.3, 0.9 } });
  good &= VerdictFails("points", Points({ { 0, 0 }, { 1, 1 } }));
  good &= VerdictFails("10", five, [](Verdict* v) { v->SetNumberOfSimulations(10); });
  good &= VerdictFails("evel", five, [](Verdict* v) { v->SetLevel(0.0); });
  good &= VerdictFails("Function", five, [](Verdict* v) { v->SetFunction(2); });
  good &= VerdictFails("Contrast", five, [](Verdict* v) { v->SetContrast(2); });
  good &= VerdictFails("MaximumDistance", five, [](Verdict* v) { v->SetMaximumDistance(-1.0); });
  good &= VerdictFails("Quadrats", five, [](Verdict* v) { v->SetQuadrats(-1, 4); });
  good &= VerdictFails("Size", five, [](Verdict* v) { v->SetSize(-1.0, 1.0); });
  good &= VerdictFails("window", five, [](Verdict* v) { v->SetSize(0.5, 0.5); });
  return good;
}

/// Pieces hold the points and arrays of the whole, in their order.
bool CheckPieces()
{
  const auto prepare = [](Source* source) {
    source->SetNumberOfSpecies(3);
    source->SetSpeciesGroupingToByCluster();
    source->MarksOn();
  };
  vtkNew<Source> whole;
  prepare(whole);
  whole->Update();
  vtkPolyData* all = whole->GetOutput();
  bool good =
    Check(all->GetNumberOfPoints() > 2000 && all->GetNumberOfVerts() == all->GetNumberOfPoints(), "few points");
  vtkIdType id = 0;
  for (int piece = 0; piece < 3; ++piece)
  {
    vtkNew<Source> part;
    prepare(part);
    part->UpdatePiece(piece, 3, 0);
    vtkPolyData* output = part->GetOutput();
    for (vtkIdType n = 0; n < output->GetNumberOfPoints(); ++n, ++id)
    {
      std::array<double, 3> a;
      std::array<double, 3> b;
      output->GetPoint(n, a.data());
      all->GetPoint(id, b.data());
      good &= a == b && output->GetPointData()->GetArray("SiteId")->GetTuple1(n) == static_cast<double>(id);
      for (const char* name : { "ClusterId", "Species", "Mark" })
      {
        good &=
          output->GetPointData()->GetArray(name)->GetTuple1(n) == all->GetPointData()->GetArray(name)->GetTuple1(id);
      }
    }
  }
  return Check(good && id == all->GetNumberOfPoints(), "pieces differ from the whole");
}

/// Clusters are numbered one after the other: discs of 1 m, whose points are at most 2 m apart, others hardly ever.
bool CheckClusters()
{
  vtkNew<Source> source;
  source->SetProcessToMaternCluster();
  source->SetSize(3000.0, 3000.0);
  source->SetClusterScale(1.0);
  source->Update();
  vtkPolyData* output = source->GetOutput();
  vtkDataArray* clusters = output->GetPointData()->GetArray("ClusterId");
  const vtkIdType count = output->GetNumberOfPoints();
  bool good = Check(count > 80000 && clusters->GetTuple1(0) == 0.0, "few points, or no first cluster");
  int near = 0;
  for (vtkIdType n = 1; n < count; ++n)
  {
    std::array<double, 3> a;
    std::array<double, 3> b;
    output->GetPoint(n - 1, a.data());
    output->GetPoint(n, b.data());
    const bool isNear = std::hypot(a[0] - b[0], a[1] - b[1]) <= 2.0;
    const double step = clusters->GetTuple1(n) - clusters->GetTuple1(n - 1);
    good &= step == 1.0 || (step == 0.0 && isNear);
    near += step == 1.0 && isNear;
  }
  good &= Check(near < 0.01 * clusters->GetTuple1(count - 1), "points of a cluster have two numbers");
  return Check(good, "points of a cluster are apart, or numbers are left out");
}

/// An image of which the left half has a third of the right one's intensity; in points on 1 m2; in a triangle.
bool CheckImagesAndWindows()
{
  bool good = true;
  const auto image = Image(0.005, 0.015);
  for (const int scale : { Source::Relative, Source::Absolute })
  {
    vtkNew<Source> source;
    source->SetProcessToPoisson();
    source->SetInputData(1, image);
    source->SetIntensity(0.02);
    source->SetIntensityScale(scale);
    source->Update();
    vtkPolyData* output = source->GetOutput();
    double left = 0.0;
    for (vtkIdType n = 0; n < output->GetNumberOfPoints(); ++n)
    {
      left += output->GetPoint(n)[0] < 250.0;
    }
    const double wanted = scale == Source::Relative ? 5000.0 : 2500.0;
    const auto points = static_cast<double>(output->GetNumberOfPoints());
    good &= Check(std::abs(points - wanted) < 4.0 * std::sqrt(wanted), "another number of points than the image has");
    good &= Check(std::abs(left / points - 0.25) < 0.03, "another share on the left than the image has");
  }
  vtkNew<Source> source;
  const auto triangle = Points({ { 0, 0 }, { 100, 0 }, { 0, 100 } }, true);
  source->SetInputData(2, triangle);
  source->Update();
  for (vtkIdType n = 0; n < source->GetOutput()->GetNumberOfPoints(); ++n)
  {
    const double* point = source->GetOutput()->GetPoint(n);
    good &= point[0] + point[1] <= 100.0;
  }
  return Check(good && source->GetOutput()->GetNumberOfPoints() > 10, "points outside of the triangle");
}

/// A measured pattern of clusters is called one, and regrown in its window.
/// Random places with two points each are clusters, and no regular process or chance.
bool CheckCoincidentPoints()
{
  std::vector<std::array<double, 2>> places;
  for (int n = 0; n < 12; ++n)
  {
    const std::array<double, 2> place{ 100.0 * std::fmod(0.754877666 * n, 1.0),
      100.0 * std::fmod(0.569840291 * n, 1.0) };
    places.insert(places.end(), { place, place });
  }
  const auto points = Points(places);
  bool good = VerdictFails("are at one place", points);
  vtkNew<Verdict> verdict;
  verdict->SetInputData(points);
  verdict->SetSize(100.0, 100.0);
  verdict->SetNumberOfSimulations(19);
  verdict->AllowCoincidentPointsOn();
  verdict->Update();
  vtkTable* table = verdict->GetOutput();
  good &= Check(table->GetNumberOfRows() == 13, "There is no verdict on coincident points");
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const std::string law = table->GetValueByName(row, "Law").ToString();
    const std::string word = table->GetValueByName(row, "Verdict").ToString();
    const bool isSpread = law == "Poisson" || law == "Strauss" || law == "MaternII" || law == "SoftCore";
    good &=
      Check(!isSpread || word == "worse" || word == "does not exist", law + " is " + word + " for pairs of points");
  }
  return good;
}

bool CheckVerdict()
{
  vtkNew<Source> source;
  source->SetOrigin(1000.0, -500.0);
  source->SetSize(140.0, 100.0);
  source->SetClusterScale(3.0);
  source->SetIntensity(0.02);
  source->SetSeed(4);
  source->Update();
  vtkNew<Verdict> verdict;
  verdict->SetInputConnection(source->GetOutputPort());
  verdict->SetOrigin(source->GetOrigin());
  verdict->SetSize(source->GetSize());
  verdict->SetNumberOfSimulations(19);
  verdict->Update();
  vtkTable* table = verdict->GetOutput();
  bool good = Check(table->GetNumberOfRows() == 13, "not seven processes and six laws");
  good &= Check(table->GetValueByName(0, "Verdict").ToString() == "best", "the first row is not the best");
  bool isPoissonWorse = false;
  bool isThomasGood = false;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const std::string law = table->GetValueByName(row, "Law").ToString();
    const std::string word = table->GetValueByName(row, "Verdict").ToString();
    const bool isProcess = table->GetValueByName(row, "ProcessId").ToInt() >= 0;
    good &= isProcess == (table->GetValueByName(row, "LawId").ToInt() < 0);
    isPoissonWorse |= law == "Poisson" && isProcess && word == "worse";
    isThomasGood |= law == "Thomas" && (word == "best" || word == "not distinguishable") &&
      std::abs(table->GetValueByName(row, "ClusterScale").ToDouble() - 3.0) < 1.0;
  }
  good &= Check(isPoissonWorse && isThomasGood, "clusters are not called clusters");
  vtkTable* envelope = vtkTable::SafeDownCast(verdict->GetOutputDataObject(1));
  for (vtkIdType row = 0; row < envelope->GetNumberOfRows(); ++row)
  {
    good &=
      envelope->GetValueByName(row, "GlobalLow").ToDouble() <= envelope->GetValueByName(row, "Measured").ToDouble();
    good &=
      envelope->GetValueByName(row, "GlobalHigh").ToDouble() >= envelope->GetValueByName(row, "Measured").ToDouble();
  }
  vtkNew<Source> regrown;
  regrown->SetInputConnection(verdict->GetOutputPort());
  regrown->SetSeed(9);
  regrown->Update();
  const double* bounds = regrown->GetOutput()->GetBounds();
  good &= Check(bounds[0] >= 1000.0 && bounds[1] <= 1140.0 && bounds[2] >= -500.0 && bounds[3] <= -400.0,
    "regrown points are in another window");
  return Check(good && regrown->GetOutput()->GetNumberOfPoints() > 100, "the verdict is wrong");
}

}

int TestPointProcesses(int, char*[])
{
  bool good = CheckPieces();
  good &= CheckClusters();
  good &= CheckImagesAndWindows();
  good &= CheckVerdict();
  good &= CheckCoincidentPoints();
  good &= CheckBadSources();
  good &= CheckBadVerdicts();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
