// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralDetrendedWindow_h
#define LittoralDetrendedWindow_h

#include "Terrain/GridSamples.h"
#include "Terrain/Variogram.h"

#include <array>
#include <functional>
#include <vector>

namespace littoral
{

/// Trend that was removed by least squares from the values of a window.
enum class Trend
{
  Mean,
  Plane,
};

/**
 * Residual of a random field in a measured window after a trend is removed by least squares. Of values z with the
 * covariance matrix C the residual is R z with R = I - P, P the projection on the trend; its expected variance is C(0)
 * - tr(P C) / n, and its semivariance at a separation h is less than that of the field by h's part in the slope that
 * was removed.
 *
 * The window is cut into at most 10 x 10 cells, each weighted by the values it holds, and covariances are averaged
 * over pairs of cells: so missing values count, and the expected variance is good to about 0.2 % of the field's.
 */
class DetrendedWindow
{
public:
  /// Covariance of a field at a separation (x, y) [m].
  using CovarianceFunction = std::function<double(double x, double y)>;

  /// The window that the values which are not NaN cover; what they are does not matter.
  DetrendedWindow(const GridSamples& samples, Trend trend);

  /// Separations of two cells, opposite ones counted once.
  int NumberOfLags() const { return (2 * this->CellsX - 1) * this->CellsY; }

  /// Mean covariances between cells, in which what the trend takes is linear.
  std::vector<double> CellCovariances(const CovarianceFunction& covariance) const;

  /// Separations (x, y) [m] of parts of cells, and the mean over each lag of cells of what is there.
  std::vector<std::array<double, 2>> Separations() const;
  std::vector<double> CellMeans(const std::vector<double>& atSeparations) const;

  /// tr(P C) / n: the expected variance that the trend takes away.
  double LostVariance(const std::vector<double>& cellCovariances) const;

  /**
   * Weights, a row for each class of lags: their sum with the cell covariances is what the trend changes in the
   * expected semivariance (mostly below zero). Directions: sectors of the classes; 1: all directions together.
   */
  std::vector<std::vector<double>> SemivarianceChange(const std::vector<LagBin>& bins, int directions) const;

  /**
   * Standard deviation, from realisation to realisation, of the variance in the window once the trend is removed:
   * for a Gaussian field the root of 2 tr(R C R C) / n^2.
   */
  double VarianceDeviation(const CovarianceFunction& covariance) const;

private:
  /// Covariance is averaged over separations (x, y) to make the mean of one lag of cells.
  struct Node
  {
    int Lag;
    double X;
    double Y;
    double Weight;
  };

  void AddNodes(const GridSamples& samples);
  int LagIndex(int cellA, int cellB) const;
  void AddPairs(int cell, double factor, const std::vector<double>& values, std::vector<double>& lags) const;
  std::vector<double> PairImbalance(double x, double y) const;

  int CellsX;
  int CellsY;
  double CellWidth;
  double CellHeight;
  double Count = 0.0;                       ///< values that are there
  std::vector<double> Values;               ///< of these in each cell
  std::vector<std::vector<double>> Basis;   ///< trend's functions, orthonormal over the values, times Values
  std::vector<std::array<double, 2>> Slope; ///< weights of the cells' means that make the slope which is removed
  std::vector<Node> Nodes;
  std::vector<double> Loss;        ///< weights of the lags of cells in the lost variance
  std::vector<double> PairWeights; ///< part of all pairs of values at each lag of cells
};

}

#endif
