// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Statistics of point patterns through the pipeline: columns, verdicts, windows, marks, species, laws, every bad input.
#include "Check.h"
#include "ErrorCounter.h"
#include "Numerics/Constants.h"
#include "vtkPatternVerdictFilter.h"
#include "vtkPointPatternStatisticsFilter.h"
#include "vtkPointProcessSource.h"
#include "vtkQuadratAnalysisFilter.h"
#include "vtkQuadratPointSource.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStringArray.h"
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

using Filter = vtkPointPatternStatisticsFilter;
using Places = std::vector<std::array<double, 2>>;

const double NaN = std::numeric_limits<double>::quiet_NaN();

vtkNew<vtkPolyData> Points(const Places& places)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& place : places)
  {
    points->InsertNextPoint(place[0], place[1], 0.0);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  return data;
}

/// A polygon, or as a line.
vtkNew<vtkPolyData> Polygon(const Places& corners, bool isLine = false)
{
  vtkNew<vtkPolyData> data = Points(corners);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<int>(corners.size()));
  for (std::size_t n = 0; n < corners.size(); ++n)
  {
    cells->InsertCellPoint(static_cast<vtkIdType>(n));
  }
  isLine ? data->SetLines(cells) : data->SetPolys(cells);
  return data;
}

/// Ten by ten places a metre apart, in the middle of their square metres.
vtkNew<vtkPolyData> Lattice()
{
  Places places;
  for (int n = 0; n < 100; ++n)
  {
    places.push_back({ 0.5 + n % 10, 0.5 + n / 10 });
  }
  return Points(places);
}

vtkTable* Output(vtkAlgorithm* filter, int port)
{
  return vtkTable::SafeDownCast(filter->GetOutputDataObject(port));
}

std::string Word(Filter* filter, const char* name)
{
  return Output(filter, 1)->GetValueByName(0, name).ToString();
}

double Number(vtkTable* table, vtkIdType row, const char* name)
{
  return table->GetValueByName(row, name).ToDouble();
}

vtkNew<Filter> OnLattice(vtkPolyData* points)
{
  vtkNew<Filter> filter;
  filter->SetInputData(points);
  filter->SetSize(10.0, 10.0);
  return filter;
}

bool LatticeIsRegular()
{
  const auto points = Lattice();
  const auto filter = OnLattice(points);
  filter->SetNumberOfSimulations(39);
  bool good = true;
  for (const int function :
    { Filter::K, Filter::L, Filter::PairCorrelation, Filter::NearestNeighbor, Filter::EmptySpace, Filter::J })
  {
    filter->SetFunction(function);
    filter->Update();
    const std::string name = Word(filter, "Function");
    good &= Check(Word(filter, "Verdict") == "differs", name + " finds nothing");
    good &= Check(Word(filter, "Pattern") == "regular", name + " calls a lattice " + Word(filter, "Pattern"));
    good &= Check(Number(Output(filter, 1), 0, "PValue") <= 0.03, name + ": another p");
    good &= Check(Number(Output(filter, 1), 0, "OutsideFrom") < 0.9, name + ": out of the band from elsewhere");
    vtkTable* chart = Output(filter, 0);
    good &= Check(chart->GetNumberOfRows() == 257 && chart->GetColumnByName(name.c_str()), name + ": another table");
    const vtkIdType row = function == Filter::J ? 30 : 100; // J has no value where simulated patterns leave no space
    const double mean = Number(chart, row, "Mean");
    good &= Check(Number(chart, row, "GlobalLow") <= mean && Number(chart, row, "Low") <= mean &&
        mean <= Number(chart, row, "High") && mean <= Number(chart, row, "GlobalHigh"),
      name + ": bands out of order");
    const double random = Number(chart, row, "Theoretical");
    const double scale = function == Filter::L ? Number(chart, row, "Distance") : random;
    good &= Check(std::abs(mean - random) < 0.12 * scale, name + ": simulations are not random");
  }
  // K(r) of 4 next neighbors from 1 m, corrected by the border: 4 places of 1 m2.
  filter->SetFunction(Filter::K);
  filter->SetEdgeCorrection(Filter::Border);
  filter->SetMaximumDistance(1.3);
  filter->SetNumberOfSteps(13);
  filter->SetNumberOfSimulations(0);
  filter->Update();
  good &= Check(Number(Output(filter, 0), 9, "K") == 0.0, "neighbors below 1 m");
  good &= Check(std::abs(Number(Output(filter, 0), 10, "K") - 4.0) < 1e-12, "not four neighbors");
  good &= Check(!Output(filter, 0)->GetColumnByName("Low"), "a band without simulations");
  good &= Check(Word(filter, "Verdict").empty() && Word(filter, "Pattern").empty(), "a verdict without simulations");
  good &= Check(Output(filter, 2)->GetNumberOfColumns() == 7, "other functions than those of points");
  good &= Check(Output(filter, 0)->GetFieldData()->GetArray("Intensity")->GetTuple1(0) == 1.0, "another intensity");
  // A rectangle as a window is the same, closed or not.
  const Places corners{ { 0.0, 0.0 }, { 10.0, 0.0 }, { 10.0, 10.0 }, { 0.0, 10.0 }, { 0.0, 0.0 } };
  for (const bool isLine : { false, true })
  {
    filter->SetSize(0.0, 0.0);
    const auto window = Polygon(corners, isLine);
    filter->SetInputData(1, window);
    filter->Update();
    good &= Check(std::abs(Number(Output(filter, 0), 10, "K") - 4.0) < 1e-12, "another window");
  }
  filter->RemoveWindow();
  filter->Update();
  good &= Check(Output(filter, 0)->GetFieldData()->GetArray("WindowArea")->GetTuple1(0) == 81.0, "no bounding box");
  filter->UpdatePiece(1, 2, 0);
  good &= Check(Output(filter, 0)->GetNumberOfRows() == 0, "a later piece has rows");
  return good;
}

/// Quadrats of a clustered law, and the verdict on it and on chance.
bool LawIsRecognized()
{
  vtkNew<vtkQuadratPointSource> source;
  source->SetLaw(vtkQuadratPointSource::PoissonPoisson);
  source->SetClusterMean(4.0);
  source->SetMode(vtkQuadratPointSource::Sampling);
  source->SetSize(100.0, 100.0);
  vtkNew<vtkQuadratAnalysisFilter> analysis;
  analysis->SetInputConnection(source->GetOutputPort());
  analysis->SetSize(100.0, 100.0);
  analysis->SetQuadrats(20, 20);
  vtkNew<Filter> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetSize(100.0, 100.0);
  filter->SetNumberOfSteps(64);
  filter->SetNumberOfSimulations(39);
  filter->Update();
  bool good = Check(Word(filter, "Verdict") == "differs" && Word(filter, "Pattern") == "clustered", "no clusters");
  filter->SetLawConnection(analysis->GetOutputPort());
  filter->Update();
  good &= Check(Word(filter, "Verdict") == "not distinguishable", "the law is not recognized");
  good &= Check(Word(filter, "Pattern").empty(), "a pattern that was not tested");
  good &= Check(std::isnan(Number(Output(filter, 1), 0, "OutsideFrom")), "outside of the band");
  filter->RemoveLaw();
  filter->Update();
  good &= Check(Word(filter, "Pattern") == "clustered", "the law is not taken away");
  // The same on one thread.
  std::vector<double> high;
  for (const int threads : { 0, 1 })
  {
    vtkSMPTools::Initialize(threads);
    filter->Modified();
    filter->Update();
    high.push_back(Number(Output(filter, 0), 40, "GlobalHigh"));
    high.push_back(Number(Output(filter, 2), 40, "PairCorrelation"));
  }
  vtkSMPTools::Initialize();
  return Check(high[0] == high[2] && high[1] == high[3], "another result on one thread") && good;
}

/// L is drawn as L(r) - r, here and for a verdict: below 1 m a lattice has no neighbors, at 1 m four on 1 m2 each.
bool LIsDrawnAboutZero()
{
  const auto points = Lattice();
  const auto filter = OnLattice(points);
  filter->SetEdgeCorrection(Filter::Border);
  filter->SetMaximumDistance(1.3);
  filter->SetNumberOfSteps(13);
  filter->SetNumberOfSimulations(19);
  filter->Update();
  vtkTable* chart = Output(filter, 0);
  bool good = Check(Word(filter, "Function") == "L(r) - r", "the drawn function is " + Word(filter, "Function"));
  for (const vtkIdType row : { 9, 10 })
  {
    const double distance = Number(chart, row, "Distance");
    const double wanted = (row < 10 ? 0.0 : std::sqrt(4.0 / littoral::Pi)) - distance;
    good &= Check(std::abs(Number(chart, row, "L(r) - r") - wanted) < 1e-12, "another L(r) - r");
    good &= Check(Number(chart, row, "Theoretical") == 0.0, "random patterns are not at 0");
    good &= Check(std::abs(Number(Output(filter, 2), row, "L") - distance - wanted) < 1e-12, "another L");
    good &= Check(Number(chart, row, "GlobalLow") < 0.0 && Number(chart, row, "Low") < 0.0 &&
        Number(chart, row, "High") > 0.0 && Number(chart, row, "GlobalHigh") > 0.0,
      "a band that is not about 0");
  }
  vtkNew<vtkPatternVerdictFilter> verdict;
  verdict->SetInputData(points);
  verdict->SetSize(10.0, 10.0);
  verdict->SetFunctionToBesagL();
  verdict->SetNumberOfSimulations(19);
  verdict->SetMaximumDistance(1.3);
  verdict->Update();
  chart = Output(verdict, 1);
  good &= Check(chart->GetNumberOfRows() > 10, "a verdict without distances");
  for (vtkIdType row = 0; row < chart->GetNumberOfRows(); ++row)
  {
    const double distance = Number(chart, row, "Distance");
    const double measured = Number(chart, row, "Measured");
    good &= Check(distance > 0.99 || measured == -distance, "L(r) - r of a verdict is not -r");
    good &= Check(Number(chart, row, "Theoretical") == 0.0, "random patterns of a verdict are not at 0");
    for (const char* name : { "Mean", "GlobalLow", "GlobalHigh" })
    {
      const double value = Number(chart, row, name); // NaN without a best process
      good &= Check(std::isnan(value) || (value >= -distance && value < 0.5), "a band of a verdict not about 0");
    }
  }
  return good;
}

/// Thomas clusters are no random pattern, and one of the process that a verdict finds for them; not of what it rejects.
bool ProcessIsRecognized()
{
  vtkNew<vtkPointProcessSource> source;
  source->SetProcessToThomas();
  source->SetSize(100.0, 100.0);
  source->SetIntensity(0.03);
  source->SetClusterScale(3.0);
  vtkNew<vtkPatternVerdictFilter> judge;
  judge->SetInputConnection(source->GetOutputPort());
  judge->SetSize(100.0, 100.0);
  judge->SetNumberOfSimulations(19);
  vtkNew<Filter> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetSize(100.0, 100.0);
  filter->SetNumberOfSteps(64);
  filter->SetNumberOfSimulations(39);
  filter->Update();
  bool good = Check(Word(filter, "Verdict") == "differs", "clusters are random");
  filter->SetLawConnection(judge->GetOutputPort());
  for (const int function : { Filter::L, Filter::PairCorrelation, Filter::NearestNeighbor })
  {
    filter->SetFunction(function);
    filter->Update();
    good &= Check(Word(filter, "Verdict") == "not distinguishable", "the process is not recognized");
    good &= Check(Word(filter, "Pattern").empty(), "a pattern that was not tested against chance");
  }
  // A table with a process that has no clusters.
  vtkNew<vtkTable> table;
  table->DeepCopy(Output(judge, 0));
  vtkTable* rows = table;
  rows->GetColumnByName("ProcessId")->SetVariantValue(0, vtkVariant(vtkPointProcessSource::Poisson));
  filter->SetInputData(2, table);
  filter->SetFunction(Filter::L);
  filter->Update();
  good &= Check(Word(filter, "Verdict") == "differs", "clusters are a Poisson process");
  rows->GetColumnByName("Intensity")->SetVariantValue(0, vtkVariant(-1.0));
  vtkNew<ErrorCounter> errors;
  errors->Watch(filter);
  filter->Modified();
  return errors->ExpectOneNaming("Intensity") && good;
}

/// Marks and species that follow each other, and their functions.
bool KindsAreRead()
{
  const auto points = Lattice();
  vtkNew<vtkDoubleArray> marks;
  marks->SetName("DBH");
  vtkNew<vtkStringArray> species;
  species->SetName("Species");
  vtkNew<vtkIntArray> codes;
  codes->SetName("Code");
  for (int n = 0; n < 100; ++n)
  {
    marks->InsertNextValue(n % 10 < 5 ? 10.0 : 30.0); // two halves
    species->InsertNextValue(n % 10 < 5 ? "oak" : n % 10 < 9 ? "pine" : "ash");
    codes->InsertNextValue(n % 10 < 5 ? 1 : n % 10 < 9 ? 2 : 3);
  }
  points->GetPointData()->AddArray(marks);
  points->GetPointData()->AddArray(species);
  points->GetPointData()->AddArray(codes);
  const auto filter = OnLattice(points);
  filter->SetNumberOfSimulations(39);
  filter->SetMarkArray("DBH");
  filter->SetFunction(Filter::MarkCorrelation);
  filter->SetEdgeCorrection(Filter::NoCorrection);
  filter->Update();
  bool good = Check(Word(filter, "Verdict") == "differs" && Word(filter, "Pattern").empty(), "marks are not alike");
  // At 1 m 170 of 180 pairs are of one half: (85 * 100 + 85 * 900 + 10 * 300) / 180 / 400.
  const double wanted = (85.0 * 100.0 + 85.0 * 900.0 + 10.0 * 300.0) / 180.0 / 400.0;
  vtkTable* chart = Output(filter, 0);
  const vtkIdType row = std::lround(1.0 / Number(chart, 1, "Distance"));
  good &= Check(std::abs(Number(chart, row, "MarkCorrelation") / wanted - 1.0) < 0.02,
    "mark correlation " + std::to_string(Number(chart, row, "MarkCorrelation")) + " not " + std::to_string(wanted));
  double values[2][2];
  const char* const names[2][3] = { { "Species", "oak", "pine" }, { "Code", "1", "2" } };
  for (int way = 0; way < 2; ++way)
  {
    filter->SetSpeciesArray(names[way][0]);
    filter->SetFunction(Filter::CrossK);
    filter->Update();
    good &= Check(Word(filter, "Verdict") == "differs", "species in halves are mixed");
    chart = Output(filter, 0);
    values[way][0] = Number(chart, row, "CrossK"); // of the two most frequent
    filter->SetFirstSpecies(names[way][1]);
    filter->SetSecondSpecies(names[way][2]);
    filter->Update();
    values[way][1] = Number(Output(filter, 0), row, "CrossK");
    filter->SetFirstSpecies("");
    filter->SetSecondSpecies(nullptr);
    good &= Check(Output(filter, 2)->GetNumberOfColumns() == 10, "not all functions");
  }
  good &= Check(values[0][0] == values[0][1] && values[0][1] == values[1][1], "names of species matter");
  filter->SetFunction(Filter::CrossPairCorrelation);
  filter->Update();
  return Check(Number(Output(filter, 0), row, "CrossPairCorrelation") < 0.7, "halves attract each other") && good;
}

bool Fails(const char* word, vtkPolyData* points, const std::function<void(Filter*)>& spoil = {})
{
  const auto filter = OnLattice(points);
  if (spoil)
  {
    spoil(filter);
  }
  vtkNew<ErrorCounter> errors;
  errors->Watch(filter);
  bool good = errors->ExpectOneNaming(word) && Check(Output(filter, 0)->GetNumberOfRows() == 0, "output not empty");
  return good && Check(Output(filter, 2)->GetNumberOfRows() == 0, "output not empty");
}

bool BadInputIsRefused()
{
  const auto points = Lattice();
  vtkNew<vtkDoubleArray> marks;
  marks->SetName("Height");
  marks->SetNumberOfTuples(100);
  marks->Fill(3.0);
  marks->SetValue(7, NaN);
  points->GetPointData()->AddArray(marks);
  vtkNew<vtkStringArray> same;
  same->SetName("Same");
  same->SetNumberOfValues(100);
  for (int n = 0; n < 100; ++n)
  {
    same->SetValue(n, "oak");
  }
  points->GetPointData()->AddArray(same);
  bool good = Fails("0 points", Points({}));
  good &= Fails("4 points", Points({ { 1.0, 1.0 }, { 2.0, 1.0 }, { 2.0, 2.0 }, { 5.0, 5.0 } }));
  const Places six{ { 1.0, 1.0 }, { 2.0, 1.0 }, { 2.0, 2.0 }, { 5.0, 5.0 }, { 5.0, 7.0 }, { 2.0, 2.0 } };
  good &= Fails("Points 2 and 5 are at one place", Points(six));
  const auto twice = OnLattice(Points(six));
  twice->AllowCoincidentPointsOn();
  twice->Update();
  good &= Check(std::abs(Number(Output(twice, 2), 0, "K") - 100.0 * 2.0 / 30.0) < 1e-12, "coincident points are lost");
  good &= Fails("Point 9", points, [](Filter* f) { f->SetSize(9.0, 9.0); });
  good &= Fails("cover no area", Points({ { 1, 1 }, { 2, 1 }, { 3, 1 }, { 4, 1 }, { 5, 1 } }),
    [](Filter* f) { f->SetSize(0.0, 0.0); });
  good &= Fails("Size", points, [](Filter* f) { f->SetSize(-1.0, 10.0); });
  good &= Fails("Origin", points, [](Filter* f) { f->SetOrigin(NaN, 0.0); });
  good &= Fails("Function", points, [](Filter* f) { f->SetFunction(9); });
  good &= Fails("EdgeCorrection", points, [](Filter* f) { f->SetEdgeCorrection(4); });
  good &= Fails("DistanceCorrection", points, [](Filter* f) { f->SetDistanceCorrection(-1); });
  good &= Fails("MaximumDistance", points, [](Filter* f) { f->SetMaximumDistance(-1.0); });
  good &= Fails("NumberOfSteps", points, [](Filter* f) { f->SetNumberOfSteps(7); });
  good &= Fails("Bandwidth", points, [](Filter* f) { f->SetBandwidth(NaN); });
  good &= Fails("NumberOfSimulations", points, [](Filter* f) { f->SetNumberOfSimulations(-1); });
  good &= Fails("at least 19", points, [](Filter* f) { f->SetNumberOfSimulations(18); });
  good &= Fails("Level", points, [](Filter* f) { f->SetLevel(1.0); });
  good &= Fails("needs marks", points, [](Filter* f) { f->SetFunction(Filter::MarkCorrelation); });
  good &= Fails("DBH", points, [](Filter* f) { f->SetMarkArray("DBH"); });
  good &= Fails("Height of point 7", points, [](Filter* f) { f->SetMarkArray("Height"); });
  good &= Fails("need species", points, [](Filter* f) { f->SetFunction(Filter::CrossK); });
  good &= Fails("Kind", points, [](Filter* f) { f->SetSpeciesArray("Kind"); });
  good &= Fails("species", points, [](Filter* f) { f->SetSpeciesArray("Same"); });
  good &= Fails("'elm'", points, [](Filter* f) {
    f->SetSpeciesArray("Same");
    f->SetFirstSpecies("elm");
  });
  const auto bow = Polygon({ { 0, 0 }, { 10, 10 }, { 10, 0 }, { 0, 11 } });
  good &= Fails("crosses", points, [&](Filter* f) { f->SetInputData(1, bow); });
  const auto few = Polygon({ { 0, 0 }, { 10, 10 } });
  good &= Fails("2 corners", points, [&](Filter* f) { f->SetInputData(1, few); });
  auto two = Polygon({ { 0, 0 }, { 10, 0 }, { 10, 10 } });
  vtkNew<vtkCellArray> line;
  line->InsertNextCell({ 0, 1, 2 });
  two->SetLines(line);
  good &= Fails("2 polygons or lines", points, [&](Filter* f) { f->SetInputData(1, two); });
  vtkNew<vtkTable> table;
  good &= Fails("LawId", points, [&](Filter* f) { f->SetInputData(2, table); });
  // After a mistake a valid request gives what it gives to a fresh filter.
  const auto filter = OnLattice(points);
  filter->SetNumberOfSimulations(0);
  filter->SetLevel(2.0);
  vtkNew<ErrorCounter> errors;
  errors->Watch(filter);
  good &= errors->ExpectOneNaming("Level");
  filter->SetLevel(0.05);
  filter->Update();
  return Check(Output(filter, 0)->GetNumberOfRows() == 257 && errors->Count == 1, "no way back") && good;
}

}

int TestPointPatternStatistics(int, char*[])
{
  return LatticeIsRegular() && LIsDrawnAboutZero() && LawIsRecognized() && ProcessIsRecognized() && KindsAreRead() && BadInputIsRefused()
    ? EXIT_SUCCESS
    : EXIT_FAILURE;
}
