// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Normal scores in the pipeline: quantiles of ranks, the way back, the distribution of a reference, every bad input.
#include "Check.h"
#include "ErrorCounter.h"
#include "vtkNormalScoresFilter.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// An image of one row of values.
vtkSmartPointer<vtkImageData> RowOf(const std::vector<double>& values, const char* name = "Elevation")
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(values.size()), 1, 1);
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  image->GetPointData()->SetScalars(array);
  return image;
}

std::vector<double> ScalarsOf(vtkAlgorithm* filter)
{
  vtkDataArray* scalars = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetPointData()->GetScalars();
  std::vector<double> values;
  for (vtkIdType n = 0; scalars && n < scalars->GetNumberOfTuples(); ++n)
  {
    values.push_back(scalars->GetComponent(n, 0));
  }
  return values;
}

/// The normal distribution function.
double Phi(double score)
{
  return 0.5 * std::erfc(-score / std::sqrt(2.0));
}

bool IsNear(const std::vector<double>& got, const std::vector<double>& wanted, const std::string& what)
{
  bool good = got.size() == wanted.size();
  for (std::size_t n = 0; good && n < got.size(); ++n)
  {
    good = std::abs(got[n] - wanted[n]) < 1e-9;
  }
  return Check(good, what);
}

bool ScoresAndBack()
{
  const std::vector<double> values = { 5.0, 1.0, 100.0, 2.0, 2.0, 7.0 };
  vtkNew<vtkNormalScoresFilter> forth;
  forth->SetInputData(RowOf(values));
  forth->Update();
  std::vector<double> shares;
  for (const double score : ScalarsOf(forth))
  {
    shares.push_back(Phi(score));
  }
  // Quantiles (k - 1/2) / 6 of the ranks 4, 1, 6, 2.5, 2.5, 5
  bool good =
    IsNear(shares, { 3.5 / 6.0, 0.5 / 6.0, 5.5 / 6.0, 2.0 / 6.0, 2.0 / 6.0, 4.5 / 6.0 }, "Scores are no quantiles");
  vtkDataArray* scores = vtkImageData::SafeDownCast(forth->GetOutputDataObject(0))->GetPointData()->GetScalars();
  good &= Check(scores && scores->GetName() == std::string("NormalScores"), "The array of scores has another name");

  vtkNew<vtkNormalScoresFilter> back;
  back->InverseOn();
  back->SetInputConnection(0, forth->GetOutputPort());
  back->SetInputData(1, RowOf(values, "Height"));
  back->Update();
  good &= IsNear(ScalarsOf(back), values, "The way back leads elsewhere");
  vtkDataArray* heights = vtkImageData::SafeDownCast(back->GetOutputDataObject(0))->GetPointData()->GetScalars();
  good &= Check(heights && heights->GetName() == std::string("Height"), "The values have another name");

  // Beyond the outermost scores, and half way between two of them.
  vtkNew<vtkNormalScoresFilter> flat;
  flat->InverseOn();
  flat->SetInputData(0, RowOf({ -9.0, 9.0, 0.0 }));
  flat->SetInputData(1, RowOf({ 3.0, 5.0, NaN }));
  flat->Update();
  return IsNear(ScalarsOf(flat), { 3.0, 5.0, 4.0 }, "Values beyond or between those of the reference") && good;
}

/// Points, whose scores are those of a reference.
bool PointsByAReference()
{
  vtkNew<vtkPoints> places;
  places->InsertNextPoint(0.0, 0.0, 0.0);
  places->InsertNextPoint(1.0, 0.0, 0.0);
  vtkNew<vtkPolyData> points;
  points->SetPoints(places);
  points->GetPointData()->SetScalars(RowOf({ 1.0, 4.0 })->GetPointData()->GetScalars());
  vtkNew<vtkNormalScoresFilter> filter;
  filter->SetInputData(0, points);
  filter->SetInputData(1, RowOf({ 1.0, 3.0, 5.0 }));
  filter->Update();
  const std::vector<double> scores = ScalarsOf(filter);
  // Of three the quantiles are 1/6, 1/2, 5/6: 4 is half way between 0 and the largest score.
  return Check(scores.size() == 2, "There is not a score a point") &&
    Check(std::abs(Phi(scores[0]) - 1.0 / 6.0) < 1e-9 && std::abs(Phi(-2.0 * scores[1]) - 1.0 / 6.0) < 1e-9,
      "Scores by a reference");
}

bool BadInput()
{
  vtkNew<vtkNormalScoresFilter> filter;
  vtkNew<ErrorCounter> errors;
  errors->Watch(filter);
  filter->SetInputData(0, RowOf({ 1.0, NaN, 2.0 }));
  bool good = errors->ExpectOneNaming("Value 1");
  filter->SetInputData(0, RowOf({ 4.0, 4.0 }));
  good &= errors->ExpectOneNaming("no two different values");
  filter->SetInputData(0, RowOf({ 1.0, 2.0 }));
  filter->InverseOn();
  good &= errors->ExpectOneNaming("Reference");
  filter->SetInputData(1, RowOf({ NaN, 2.0 }));
  good &= errors->ExpectOneNaming("Reference has no two different values");
  filter->SetInputData(1, RowOf({ 1.0, 2.0 }));
  filter->SetInputArrayToProcess(1, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Nothing");
  good &= errors->ExpectOneNaming("'Nothing'");
  vtkNew<vtkNormalScoresFilter> other;
  vtkNew<ErrorCounter> others;
  others->Watch(other);
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(2, 2, 1);
  other->SetInputData(0, bare);
  return others->ExpectOneNaming("scalar point array") && good;
}

}

int TestNormalScoresFilter(int, char*[])
{
  bool good = ScoresAndBack();
  good &= PointsByAReference();
  good &= BadInput();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
