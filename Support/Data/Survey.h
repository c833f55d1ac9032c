// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportSurvey_h
#define LittoralSupportSurvey_h

// Conditioning data and the grid of the field that honours them. Private: never installed, never wrapped.

#include "Data/FieldStatistics.h"
#include "Kriging/KrigingSurvey.h"

#include <string>

class vtkDataArray;
class vtkDataSet;
class vtkImageData;

namespace littoral
{

/// A survey, and where it comes from.
struct Survey : KrigingSurvey
{
  std::string Name = "Elevation"; ///< name of the values
  bool IsRaster = false;          ///< the data are points of the grid, which keep their values
  double OriginZ = 0.0;
  double SpacingZ = 1.0;
};

// Each of these throws InvalidInput if it cannot be done.

/// Takes places, values and errors of data; without values the z of points; of an image the points except holes (NaN).
void TakeData(vtkDataSet* data, vtkDataArray* values, vtkDataArray* errors, Survey& survey);

/// Takes the grid of an image of one layer.
void TakeGrid(vtkImageData* grid, Survey& survey);

/// Takes an external drift at the points of the grid, and from there at the data.
void TakeDrift(vtkDataArray* drift, Survey& survey);

/// Takes the model from given statistics.
void TakeModel(const FieldStatistics& statistics, Survey& survey);

}

#endif
