// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/SurveyTable.h"

#include "Data/Arrays.h"
#include "Data/Tables.h"
#include "Terrain/VariogramFit.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <cstddef>
#include <limits>

namespace littoral
{

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

void AddNumbers(vtkTable* table, const char* name, const std::vector<double>& numbers)
{
  AddColumn(table, name, numbers, [](double number) { return number; });
}

}

//----------------------------------------------------------------------------
void AddRows(const KrigingSurvey& survey, const std::vector<double>& field, vtkTable* table)
{
  AddColumn(table, "X", survey.Data.Places, [](const KrigingPlace& place) { return place.X; });
  AddColumn(table, "Y", survey.Data.Places, [](const KrigingPlace& place) { return place.Y; });
  AddNumbers(table, "Value", survey.Measured);
  AddNumbers(table, "Field", field);
}

//----------------------------------------------------------------------------
void AddModel(const KrigingSurvey& survey, vtkTable* table)
{
  const CovarianceParameters& field = survey.Model.Field;
  AddText(table, "Model", CovarianceModelName(field.Model));
  AddField(table, "ModelId", { static_cast<double>(field.Model) });
  for (const auto* parameter : AllCovarianceParameters())
  {
    const bool has = TraitsOf(field.Model).Parameters.Has(parameter->Name);
    AddField(table, parameter->Name, { has ? parameter->Get(field) : NaN });
  }
  AddField(table, "Nugget", { survey.Model.Nugget });
}

//----------------------------------------------------------------------------
void AddVariogram(const KrigingSurvey& survey, vtkTable* table)
{
  VariogramFit fit;
  fit.Field = survey.Model.Field;
  fit.Nugget = survey.Model.Nugget;
  const auto column = [&](const char* name, auto valueOf) { AddColumn(table, name, survey.Variogram, valueOf); };
  column("Lag", [](const LagBin& bin) { return bin.Lag; });
  column("Semivariance", [](const LagBin& bin) { return bin.Semivariance; });
  column("Pairs", [](const LagBin& bin) { return bin.Pairs; });
  column("Fitted", [&](const LagBin& bin) { return MeanSemivariance(fit, bin.Lag); });
}

//----------------------------------------------------------------------------
void AddCrossValidation(const CrossValidation& validation, vtkTable* table)
{
  AddNumbers(table, "LeaveOneOutEstimate", validation.Estimates);
  AddNumbers(table, "LeaveOneOutStandardDeviation", validation.Deviations);
  AddNumbers(table, "StandardizedError", validation.StandardizedErrors);
  AddField(table, "MeanError", { validation.MeanError });
  AddField(table, "RootMeanSquareError", { validation.RootMeanSquareError });
  AddField(table, "MeanSquaredStandardizedError", { validation.MeanSquaredStandardizedError });
}

//----------------------------------------------------------------------------
void WriteData(const KrigingSurvey& survey, vtkTable* table, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  for (std::size_t n = 0; n < survey.Measured.size(); ++n)
  {
    const KrigingPlace& place = survey.Data.Places[n];
    const vtkIdType point = points->InsertNextPoint(place.X, place.Y, survey.Measured[n]);
    vertices->InsertNextCell(1, &point);
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  for (vtkIdType n = 2; n < table->GetNumberOfColumns(); ++n) // after X and Y
  {
    output->GetPointData()->AddArray(table->GetColumn(n));
  }
}

}
