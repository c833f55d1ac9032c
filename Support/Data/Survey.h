// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportSurvey_h
#define LittoralSupportSurvey_h

// Data at places and the grid on which a field honours them. Private: never installed, never wrapped.

#include "Data/FieldStatistics.h"
#include "Kriging/Kriging.h"
#include "Kriging/NormalScores.h"
#include "Numerics/Parallel.h"
#include "Terrain/TurningBands.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkImageData;

namespace littoral
{

/// Data, grid and model.
struct Survey
{
  KrigingData Data;
  std::vector<double> Measured; ///< values as they came, Data has their scores
  std::string Name = "Elevation";
  bool IsRaster = false; ///< the data are points of the grid, which keep their values

  PlaneGrid Grid;
  GridWindow Window; ///< the whole grid
  double OriginZ = 0.0;
  double SpacingZ = 1.0;
  std::vector<double> Drift;  ///< at the points of the grid
  std::vector<double> Raster; ///< values at the points of the grid, NaN in holes, where the data are its points

  KrigingType Type = KrigingType::Ordinary;
  KrigingModel Model;
  double Mean = 0.0; ///< that is known
  std::optional<NormalScores> Scores;
  std::size_t Neighbors = 0;

  /// Of a point of the grid.
  std::size_t Index(int column, int row) const
  {
    const auto width = static_cast<std::size_t>(this->Window.Last[0] - this->Window.First[0]) + 1;
    return static_cast<std::size_t>(row - this->Window.First[1]) * width + (column - this->Window.First[0]);
  }

  /// From the scores, if there are such.
  double Back(double value) const { return this->Scores ? this->Scores->ValueOf(value) : value; }
};

// Each of these returns why it cannot be done, or nothing.

/// Takes the places, values and errors of data; of points without values their z; of an image its points but for holes.
std::string TakeData(vtkDataSet* data, vtkDataArray* values, vtkDataArray* errors, Survey& survey);

/// The grid is that of an image of one layer.
void TakeGrid(vtkImageData* grid, Survey& survey);

/// The grid covers the data, and a margin around them; around a single place this reach [m].
std::string SpanGrid(const std::array<int, 2>& dimensions, double reach, Survey& survey);

/// Takes an external drift at the points of the grid, and from there at the data.
std::string TakeDrift(vtkDataArray* drift, Survey& survey);

/// The model is that of given statistics.
std::string TakeModel(const FieldStatistics& statistics, Survey& survey);

/// The values become normal scores.
std::string TakeScores(Survey& survey);

/// So many neighbours are asked for; 0: the usual number.
void TakeNeighbors(int number, Survey& survey);

/// The model is the best of those fitted to the data whose system can be solved.
std::string FitModel(Survey& survey, const ParallelFor& parallel);

}

#endif
