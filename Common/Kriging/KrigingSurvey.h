// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralKrigingSurvey_h
#define LittoralKrigingSurvey_h

#include "Kriging/Kriging.h"
#include "Kriging/NormalScores.h"
#include "Numerics/Parallel.h"
#include "Terrain/TurningBands.h"
#include "Terrain/Variogram.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace littoral
{

/// Data, the grid on which a field honours them, and the model of the field.
struct KrigingSurvey
{
  KrigingData Data;             ///< values, or their normal scores
  std::vector<double> Measured; ///< values as they came, one a datum

  PlaneGrid Grid;
  GridWindow Window;          ///< the whole grid
  std::vector<double> Drift;  ///< external drift at the points of the grid; none without one
  std::vector<double> Raster; ///< values that points of the grid keep, NaN elsewhere; none: no point keeps one

  KrigingType Type = KrigingType::Ordinary;
  KrigingModel Model;
  std::vector<LagBin> Variogram;      ///< of the values about their drift (DataVariogram)
  double Mean = 0.0;                  ///< mean of the field, if it is known, else 0
  std::optional<NormalScores> Scores; ///< the map from values to scores, if the data are scores
  std::size_t Neighbors = 0;          ///< data that take part in an estimate; 0: all

  /// Index of a point of the grid, x fastest.
  std::size_t Index(int column, int row) const
  {
    const auto width = static_cast<std::size_t>(this->Window.Last[0] - this->Window.First[0]) + 1;
    return static_cast<std::size_t>(row - this->Window.First[1]) * width + (column - this->Window.First[0]);
  }

  /// The value of a normal score; without scores the value itself.
  double BackTransformed(double value) const { return this->Scores ? this->Scores->ValueOf(value) : value; }

  /// Options of a kriging system whose estimates are wanted at the data.
  KrigingOptions OptionsAtData() const;
};

// Each of these throws InvalidInput if it cannot be done.

/// Takes a grid of so many points along x and y that covers the data and a margin around them of a twentieth of their
/// longer side; around a single place this reach [m].
void SpanGrid(const std::array<int, 2>& dimensions, double reach, KrigingSurvey& survey);

/// Takes an external drift at the points of the grid, and from there, bilinear, at the data.
void TakeDrift(std::vector<double> drift, KrigingSurvey& survey);

/// Turns the values into normal scores.
void TakeScores(KrigingSurvey& survey);

/// Takes the variogram of the data, and the best of the models fitted to it (FitToData) whose system can be solved.
void FitModel(KrigingSurvey& survey, const ParallelFor& parallel = SerialFor);

/// Takes this number of neighbours, at most all data; 0: all of up to 2000 data, else 50.
void TakeNeighbors(int number, KrigingSurvey& survey);

/// Leaves the mean to kriging of the type Simple alone, which takes that of the data if it is asked for; normal scores
/// have the mean 0.
void TakeMean(bool ofData, KrigingSurvey& survey);

}

#endif
