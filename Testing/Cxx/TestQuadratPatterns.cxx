// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Quadrat source and analysis: pieces, exact totals, the way from fit to pattern, and every bad input.
#include "Check.h"
#include "ErrorCounter.h"
#include "vtkQuadratAnalysisFilter.h"
#include "vtkQuadratPointSource.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <functional>
#include <limits>
#include <vector>

namespace
{

using Source = vtkQuadratPointSource;
using Analysis = vtkQuadratAnalysisFilter;

bool SourceFails(const char* word, const std::function<void(Source*)>& spoil)
{
  vtkNew<Source> source;
  spoil(source);
  return FailsNaming(word, source) && Check(source->GetOutput()->GetNumberOfPoints() == 0, "output not empty");
}

vtkNew<vtkPolyData> Points(const std::vector<std::array<double, 2>>& positions)
{
  vtkNew<vtkPoints> points;
  for (const auto& position : positions)
  {
    points->InsertNextPoint(position[0], position[1], 0.0);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  return data;
}

bool AnalysisFails(const char* word, vtkPolyData* points, const std::function<void(Analysis*)>& spoil = {})
{
  vtkNew<Analysis> analysis;
  analysis->SetInputData(points);
  if (spoil)
  {
    spoil(analysis);
  }
  return FailsNaming(word, analysis) && Check(analysis->GetOutput()->GetNumberOfColumns() == 0, "output not empty");
}

bool CheckBadInput()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  bool good = true;
  good &= SourceFails("Quadrats", [](Source* s) { s->SetQuadrats(0, 10); });
  good &= SourceFails("Quadrats", [](Source* s) { s->SetQuadrats(10, -1); });
  good &= SourceFails("memory", [](Source* s) { s->SetQuadrats(100000, 100000); });
  good &= SourceFails("Size", [](Source* s) { s->SetSize(0.0, 10.0); });
  good &= SourceFails("Size", [=](Source* s) { s->SetSize(10.0, nan); });
  good &= SourceFails("Origin", [=](Source* s) { s->SetOrigin(nan, 0.0); });
  good &= SourceFails("Law", [](Source* s) { s->SetLaw(6); });
  good &= SourceFails("Mode", [](Source* s) { s->SetMode(2); });
  good &= SourceFails("MeanPerQuadrat", [](Source* s) { s->SetMeanPerQuadrat(0.0); });
  good &= SourceFails("MeanPerQuadrat", [=](Source* s) { s->SetMeanPerQuadrat(nan); });
  good &= SourceFails("Trials", [](Source* s) {
    s->SetLaw(Source::Binomial);
    s->SetMeanPerQuadrat(5.0);
  });
  good &= SourceFails("ClusterShape", [](Source* s) {
    s->SetLaw(Source::NegativeBinomial);
    s->SetClusterShape(-1.0);
  });
  vtkNew<vtkTable> empty;
  good &= SourceFails("LawId", [&](Source* s) { s->SetInputData(empty); });

  good &= AnalysisFails("0 points", Points({}));
  good &= AnalysisFails("1 points", Points({ { 1.0, 2.0 } }));
  const auto line = Points({ { 0, 1 }, { 1, 1 }, { 2, 1 }, { 3, 1 }, { 4, 1 }, { 5, 1 } });
  good &= AnalysisFails("no area", line);
  const auto square = Points({ { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 }, { 0.5, 0.2 }, { 0.3, 0.9 } });
  good &= AnalysisFails("Quadrats", square, [](Analysis* a) { a->SetQuadrats(0, 4); });
  good &= AnalysisFails("1 quadrats", square, [](Analysis* a) { a->SetQuadrats(1, 1); });
  good &= AnalysisFails("Size", square, [](Analysis* a) { a->SetSize(-1.0, 1.0); });
  good &= AnalysisFails("study area", square, [](Analysis* a) {
    a->SetOrigin(50.0, 50.0);
    a->SetSize(1.0, 1.0);
  });
  return good;
}

}

int TestQuadratPatterns(int, char*[])
{
  bool good = true;
  vtkNew<Source> source;
  source->SetOrigin(-100.0, 40.0);
  source->SetSize(400.0, 300.0);
  source->SetQuadrats(40, 30);
  source->SetLaw(Source::NegativeBinomial);
  source->SetMeanPerQuadrat(2.5);
  source->Update();
  vtkPolyData* whole = source->GetOutput();
  good &= Check(whole->GetNumberOfPoints() == 3000 && whole->GetNumberOfVerts() == 3000, "quota is not exact");
  const double* bounds = whole->GetBounds();
  good &= Check(bounds[0] > -100.0 && bounds[1] < 300.0 && bounds[2] > 40.0 && bounds[3] < 340.0, "points outside");

  // Three pieces hold the same points as one.
  vtkIdType id = 0;
  for (int piece = 0; piece < 3; ++piece)
  {
    vtkNew<Source> part;
    part->SetOrigin(source->GetOrigin());
    part->SetSize(source->GetSize());
    part->SetQuadrats(source->GetQuadrats());
    part->SetLaw(Source::NegativeBinomial);
    part->SetMeanPerQuadrat(2.5);
    part->UpdatePiece(piece, 3, 0);
    vtkDataArray* site = part->GetOutput()->GetPointData()->GetArray("SiteId");
    for (vtkIdType n = 0; n < part->GetOutput()->GetNumberOfPoints(); ++n, ++id)
    {
      double a[3];
      double b[3];
      part->GetOutput()->GetPoint(n, a);
      whole->GetPoint(id, b);
      if (site->GetTuple1(n) != static_cast<double>(id) || a[0] != b[0] || a[1] != b[1])
      {
        return !Check(false, "a piece differs from the whole");
      }
    }
  }
  good &= Check(id == 3000, "pieces miss points");

  vtkNew<Analysis> analysis;
  analysis->SetInputConnection(source->GetOutputPort());
  analysis->SetOrigin(source->GetOrigin());
  analysis->SetSize(source->GetSize());
  analysis->SetQuadrats(source->GetQuadrats());
  analysis->Update();
  vtkTable* fits = analysis->GetOutput();
  good &= Check(fits->GetNumberOfRows() == 6, "not six laws");
  good &= Check(fits->GetValueByName(0, "Law").ToString() == "NegativeBinomial", "another law is best");
  good &= Check(std::abs(fits->GetValueByName(0, "ClusterShape").ToDouble() - 0.5) < 0.05, "another aggregation index");
  good &= Check(std::abs(fits->GetValueByName(0, "MeanPerQuadrat").ToDouble() - 2.5) < 1e-12, "another mean");
  vtkStringArray* pattern = vtkStringArray::SafeDownCast(fits->GetFieldData()->GetAbstractArray("Pattern"));
  good &= Check(pattern->GetValue(0) == "clustered", "pattern is not called clustered");
  vtkTable* bars = vtkTable::SafeDownCast(analysis->GetOutputDataObject(1));
  double quadrats = 0.0;
  for (vtkIdType row = 0; row < bars->GetNumberOfRows(); ++row)
  {
    quadrats += bars->GetValueByName(row, "Observed").ToDouble();
  }
  good &= Check(quadrats == 1200.0 && bars->GetColumnByName("Poisson"), "frequencies are wrong");

  vtkNew<Source> regrown;
  regrown->SetInputConnection(analysis->GetOutputPort());
  regrown->SetSeed(5);
  regrown->Update();
  good &= Check(regrown->GetOutput()->GetNumberOfPoints() == 3000, "regrown pattern has another total");
  good &= Check(regrown->GetOutput()->GetBounds()[1] > 200.0, "regrown pattern is not on the measured area");

  good &= CheckBadInput();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
