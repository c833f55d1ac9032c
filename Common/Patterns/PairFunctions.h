// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPairFunctions_h
#define LittoralPairFunctions_h

#include "Numerics/Parallel.h"
#include "Numerics/WorkShare.h"
#include "Patterns/ObservationWindow.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace littoral
{

class CommonAreaTable;

// Second-order statistics of a point pattern: functions of the distance r between two points. All are sums over ordered
// pairs with a weight e against the loss of pairs across the edge of the window W:
//
//   None         e = 1
//   Border       only points farther than r from the edge are centers; K alone
//   Isotropic    1 / e = the part of the circle about the first point through the second one that lies in W
//   Translation  1 / e = |W and W moved by the difference of the points| / |W|
//
// Weights end at 100. Ripley (1977); Ohser (1983); Baddeley, Rubak and Turner (2015), chapter 7. The same bytes for any
// parallel loop.

enum class EdgeCorrection
{
  None = 0,
  Border = 1,
  Isotropic = 2,
  Translation = 3,
};

/// Equidistant distances r(k) = k * Maximum / Steps [m], k = 0 ... Steps.
struct DistanceRange
{
  double Maximum = 0.0; ///< largest distance [m]
  int Steps = 512;      ///< number of steps

  double operator[](int k) const { return this->Maximum * k / this->Steps; }
  std::size_t Count() const { return static_cast<std::size_t>(this->Steps) + 1; }
};

/// Distances up to a quarter of the shorter side of the bounding box, and up to that within which a thousand points are
/// expected: where estimates can be trusted.
DistanceRange DefaultDistances(const ObservationWindow& window, std::size_t points, int steps = 512);

/// Options of the functions of pairs.
struct PairOptions
{
  DistanceRange Distances;
  EdgeCorrection Correction = EdgeCorrection::Isotropic;
  bool WantsK = true;
  bool WantsG = true;
  /// Half width of the Epanechnikov kernel of g [m]; 0: 0.15 / sqrt(intensity), Stoyan's rule.
  double HalfWidth = 0.0;
  /// Standard deviation of the Gaussian kernel of the mark correlation [m]; 0: Silverman's rule for the distances.
  double MarkWidth = 0.0;
  /// Weights of the points, 1 / intensity, for an inhomogeneous pattern; empty: homogeneous. Not for Border and cross
  /// functions.
  std::vector<double> Weights;
  /// Areas up to Maximum and the half width, for many patterns in one window; null: found anew for each pattern.
  std::shared_ptr<const CommonAreaTable> Areas;
  WorkShare Share; ///< blocks of points that processes share; the first one has the functions
};

/// Why the options cannot be, in words for a user; empty when they can.
std::string WhyInvalid(const PairOptions& options);

/// Values at all distances; a function that was not asked for is empty. g(0) is NaN: its kernel is divided by r.
struct PairFunctions
{
  std::vector<double> K;               ///< Ripley's K [m2]; pi r^2 for a random pattern
  std::vector<double> PairCorrelation; ///< g; 1 for a random pattern
  std::vector<double> MarkCorrelation; ///< k_mm, mean product of the marks of a pair over the squared mean; 1 at random
};

/**
 * Functions of one pattern, whose points must lie in the window.
 *
 *   K(r) = |W| / (n (n - 1)) sum over i != j of 1(d_ij <= r) e_ij
 *   g(r) = |W| / (2 pi r n (n - 1)) sum over i != j of kernel(r - d_ij) e_ij
 *
 * Where weights w_i are given (Baddeley, Moller and Waagepetersen 2000), each pair counts w_i w_j, and n (n - 1) is
 * (sum of w)^2 - sum of w^2.
 *
 * With Border: K(r) = |W| / n sum over i with b_i >= r of the points within r / number of such i, b_i the distance to
 * the edge. g and the mark correlation have no such form; they are empty then.
 */
PairFunctions FindPairFunctions(const std::vector<PlanePosition>& points, const ObservationWindow& window,
  const PairOptions& options, const ParallelFor& parallel = SerialFor);

/// Functions of one pattern with the mark correlation of positive marks, one for each point: k_mm(r) = sum of m_i m_j
/// kernel(r - d_ij) e_ij / (sum of kernel(r - d_ij) e_ij * mean(m)^2).
PairFunctions FindPairFunctions(const std::vector<PlanePosition>& points, const std::vector<double>& marks,
  const ObservationWindow& window, const PairOptions& options, const ParallelFor& parallel = SerialFor);

/**
 * Functions of pairs of a point of one species and one of another; the same formulas with n1 n2 for n (n - 1). The
 * circle and the border are those of the first species, the half width follows the intensity of the second.
 */
PairFunctions FindCrossFunctions(const std::vector<PlanePosition>& from, const std::vector<PlanePosition>& to,
  const ObservationWindow& window, const PairOptions& options, const ParallelFor& parallel = SerialFor);

/// Besag's L(r) = sqrt(K(r) / pi) [m]; r for a random pattern.
std::vector<double> BesagL(const std::vector<double>& k);

/// L(r) - r [m], as charts show it: beside the slope of L nobody sees its band. 0 for a random pattern.
std::vector<double> CenteredL(const std::vector<double>& l, const std::vector<double>& distances);

}

#endif
