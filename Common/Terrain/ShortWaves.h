// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralShortWaves_h
#define LittoralShortWaves_h

#include "Numerics/RandomStream.h"
#include "Terrain/CovarianceModels.h"

#include <array>
#include <functional>
#include <vector>

namespace littoral
{

class FourierGrid;

/**
 * The points of a grid in the space where a field is isotropic: point (i, j) is at i StepX + j StepY [m] from the
 * origin.
 */
struct PlaneLattice
{
  std::array<double, 2> StepX{ 1.0, 0.0 };
  std::array<double, 2> StepY{ 0.0, 1.0 };

  /// Distance of points i columns and j rows apart [m].
  double Distance(int i, int j) const;
};

/// Shares the power of a field between long and short waves: all long below Low, all short above High [rad/m].
struct Crossover
{
  double Low;
  double High;

  /// Crossover of long and short waves of a field on a lattice: between wavelengths of 8 and 4 of its mean spacings.
  static Crossover OfLattice(const PlaneLattice& lattice);

  /// The part of the power at wave number w that is long: from 1 at Low to 0 at High without a kink.
  double LongPart(double w) const;

  /// The part of a field's variance in long waves of wave numbers below w.
  double LongBelow(const CovarianceParameters& field, double w) const;
};

/**
 * The short waves of a field, as they show at the points of a grid: a moving average of white noise that has a number
 * for each point. Waves shorter than two spacings fold back, as those of a real surface do when it is sampled, so that
 * with the long waves the covariance at the points is the model's.
 *
 * The weights of the average are the inverse transform of the root of the spectrum at the points (Oliver 1995), cut
 * off at seven mean spacings. A value depends on the seed and on the point's place alone, counted in spacings from (0,
 * 0) of the plane: grids that are whole spacings apart are parts of one.
 */
class ShortWaves
{
public:
  /// `origin` is the place of the grid's point (0, 0) in spacings.
  ShortWaves(const CovarianceParameters& field, const PlaneLattice& lattice, const Crossover& crossover,
    const std::array<long long, 2>& origin, int seed, RandomPurpose purpose);

  /// Covariance of points i columns and j rows apart; at 0, 0 the variance.
  double Covariance(int i, int j) const;

  /// Covariance that the model asks for at any distance [m] in the space where the field is isotropic, also between
  /// places that are no points of the grid.
  double CovarianceAt(double distance) const { return this->Model(distance); }

  /// Values at the points firstColumn <= i < firstColumn + width, firstRow <= j < firstRow + height, x fastest.
  void Fill(int firstColumn, int firstRow, int width, int height, std::vector<float>& values) const;

private:
  void FindWeights(const CovarianceParameters& field, const PlaneLattice& lattice, const Crossover& crossover);
  void CutWeights(FourierGrid& grid, const PlaneLattice& lattice, double radius, double variance);
  void FindTaps();
  float Weight(int i, int j) const;

  RandomStream Random;
  std::array<long long, 2> Origin; ///< column and row of the grid's point (0, 0)
  std::function<double(double)> Model;
  std::array<int, 2> Reach{ 0, 0 }; ///< largest |i| and |j| of a weight
  std::vector<float> Weights;       ///< of -Reach <= i, j <= Reach, i fastest
  /// The weights that are not zero, one of each pair of opposite ones, the middle first.
  struct Tap
  {
    int Column;
    int Row;
    float Weight;
  };
  std::vector<Tap> Taps;
};

}

#endif
