// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTrainSelection_h
#define LittoralTrainSelection_h

#include "Geometry/ViewFrustum.h"
#include "Sea/WaveTrains.h"

#include <vector>

namespace littoral
{

/// Criteria for trains that may be left out of the motion of a particle.
enum class TrainRule
{
  PerTrain, ///< each of those that move it by less than the error on the screen (Coulais et al., 3.3.1)
  TailSum,  ///< the last ones, as long as all of them together move it by less: a true bound
  All       ///< none
};

/**
 * The trains by the axes of their orbits at a height [m], longest first. Trains that come sorted by their amplitudes at
 * the surface are in another order below: short waves die out first, and long ones that hardly lift the surface matter
 * more.
 */
std::vector<int> OrderAt(const SeaState& sea, double height);

/// The sea with its trains in an order; indices must be those of a permutation.
SeaState Ordered(const SeaState& sea, const std::vector<int>& order);

/// Whether these are the numbers from 0 on, each of them once.
bool IsPermutation(const std::vector<int>& order);

/**
 * Number of trains that matter by distance from the eye and depth in the water, as a table (Coulais et al., 3.3.1; the
 * paper's knows distances alone, yet short waves die out with depth). Trains count from the first; a sea ordered at the
 * height of the particles needs the fewest. The table depends on the lens of a view only, not on where it is.
 *
 * An entry holds for the nearest distance and the least depth of its interval, so that interpolation never drops a
 * train that matters. With TailSum the projected error of any particle within the picture stays below the screen error:
 * distance counts from the near end of the orbit, and pixels as they are in the corner of the picture, where they are
 * largest.
 */
class TrainTable
{
public:
  /// Heights [m] between which particles are centered. The screen error [pixels] must be positive.
  TrainTable(const SeaState& sea, double lowest, double highest, const View& view, TrainRule rule, double screenError);

  /// Number of trains that act at a distance [m] and height [m].
  int CountAt(double distance, double height) const;

  /// Bound of the displacement at a height [m].
  double AmplitudeAt(double height) const { return this->Rows[this->RowOf(height)].Tail.front(); }

  /// Bound of the displacement by the trains after the first ones [m].
  double TailAt(int first, double height) const { return this->Rows[this->RowOf(height)].Tail[first]; }

  /**
   * Bound, at any time, of the distance of a particle from its own orbit [m], if it keeps an offset of a length [m]
   * from another one instead. Height: of the upper one. Per train the motion at two places differs by no more than k a
   * times their distance, nor by more than 2 a.
   */
  double SlaveError(double length, double height) const;

  int NumberOfTrains() const { return this->Trains; }

  /// Whether all trains act everywhere.
  bool IsComplete() const { return this->Rule == TrainRule::All; }

private:
  struct Row
  {
    double Height;            ///< of the upper end
    std::vector<double> Tail; ///< sum of a from train n on, one more than trains
    double Steepness;         ///< sum of k a
    std::vector<int> Counts;  ///< a distance each
  };

  int RowOf(double height) const;
  void FillCounts(Row& row, const SeaState& sea, const View& view, double screenError) const;

  int Trains;
  TrainRule Rule;
  double Highest = 0.0;
  double Step = 1.0;
  std::vector<Row> Rows;
};

}

#endif
