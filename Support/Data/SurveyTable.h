// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportSurveyTable_h
#define LittoralSupportSurveyTable_h

// Tables of the data of a survey. Private: never installed, never wrapped.

#include "Kriging/CrossValidation.h"
#include "Kriging/KrigingSurvey.h"

#include <vector>

class vtkPolyData;
class vtkTable;

namespace littoral
{

/// Adds a row for each datum: its place, its value and that of the field there.
void AddRows(const KrigingSurvey& survey, const std::vector<double>& field, vtkTable* table);

/// Adds the model of a survey as field data.
void AddModel(const KrigingSurvey& survey, vtkTable* table);

/// Adds a row for each class of the variogram of the data, with the semivariance of the model there.
void AddVariogram(const KrigingSurvey& survey, vtkTable* table);

/// Adds a cross-validation: columns, and its means as field data.
void AddCrossValidation(const CrossValidation& validation, vtkTable* table);

/// The data as vertices, with the columns of their table but x and y.
void WriteData(const KrigingSurvey& survey, vtkTable* table, vtkPolyData* output);

}

#endif
