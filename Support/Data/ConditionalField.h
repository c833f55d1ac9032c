// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportConditionalField_h
#define LittoralSupportConditionalField_h

// A field through the data of a survey, and what it is there. Private: never installed, never wrapped.

#include "Data/Survey.h"
#include "Kriging/Kriging.h"
#include "Terrain/TurningBands.h"

#include <memory>
#include <optional>
#include <vector>

class vtkAlgorithm;
class vtkDoubleArray;
class vtkImageData;
class vtkPolyData;
class vtkTable;

namespace littoral
{

/// The field that is wanted.
struct ConditionalWish
{
  bool Simulates = true; ///< else it is the kriging estimate
  int NumberOfLines = 0; ///< 0: enough
  int Seed = 1;
  bool Variance = false; ///< of kriging, beside it
};

/// Bytes of a field of these points from the data of a survey.
double MemoryOf(const Survey& survey, double points, bool variance);

/// A simulated field plus the kriged differences of the data from it; without a simulated field the kriging estimate.
class ConditionalField
{
public:
  ConditionalField(const Survey& survey, const ConditionalWish& wish, vtkAlgorithm* algorithm);

  /// Solves for the differences at the data; false when aborted. Throws KrigingFailure.
  bool Solve();

  /// Sets the points of an extent, and their kriging variances if they are wanted; false when aborted.
  bool Fill(const int extent[6], vtkImageData* output) const;

  /// Adds a row for each datum, with the field there.
  void AddRows(vtkTable* table) const;

private:
  bool Simulate();
  void FillRows(const int extent[6], int first, int last, vtkDoubleArray* values, vtkDoubleArray* variances) const;

  const Survey& Data;
  ConditionalWish Wish;
  vtkAlgorithm* Algorithm;
  std::optional<TurningBandsField> Field;
  std::vector<double> AtData; ///< of the simulated field
  std::unique_ptr<Kriging> Differences;
};

/// Adds the model of a survey as field data.
void AddModel(const Survey& survey, vtkTable* table);

/// Adds the estimates of each datum from the others as columns, and what they tell as field data.
void AddCrossValidation(const Survey& survey, vtkAlgorithm* algorithm, vtkTable* table);

/// The data as vertices, with the columns of their table but x and y.
void WriteData(const Survey& survey, vtkTable* table, vtkPolyData* output);

}

#endif
