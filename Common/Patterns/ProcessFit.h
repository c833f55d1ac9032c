// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralProcessFit_h
#define LittoralProcessFit_h

#include "Numerics/Parallel.h"
#include "Patterns/IntensityTrend.h"
#include "Patterns/ObservationWindow.h"
#include "Patterns/PairFunctions.h"
#include "Patterns/PointProcess.h"

#include <string>
#include <vector>

namespace littoral
{

/// Summary function by whose contrast cluster and Cox processes are fitted.
enum class ContrastFunction
{
  Ripley = 0,          ///< K
  PairCorrelation = 1, ///< g
};

/// Options of fits by minimum contrast (Diggle 1983; Waagepetersen 2007).
struct ContrastOptions
{
  ContrastFunction Function = ContrastFunction::Ripley;
  EdgeCorrection Correction = EdgeCorrection::Isotropic;
  double MaximumDistance = 0.0; ///< [m], distance up to which functions are compared; 0: that of DefaultDistances()
  double Power = 0.25;          ///< q
  int TrendDegree = 0;          ///< of the logarithm of the intensity over the window, 0 (none) to MaximumTrendDegree
};

/// Why a contrast cannot be, in words for a user; empty when it can.
std::string WhyInvalid(const ContrastOptions& options);

/// A process, fitted.
struct ProcessFit
{
  PointProcessParameters Process;
  IntensityTrend Trend;             ///< none unless it was asked for, and for Strauss and the soft core
  bool Exists = false;              ///< false where the fit has no maximum or minimum within bounds
  double Contrast = 0.0;            ///< of fits by minimum contrast [m^(4 q) m for K, m for g]; else NaN
  double LogPseudoLikelihood = 0.0; ///< of fits by pseudo-likelihood; else NaN
};

/**
 * Fits a process to the points of a window, of which there are at least five and no two at one place.
 *
 * - Poisson: n / |W|.
 * - Thomas, Matern cluster, log-Gaussian Cox: the minimum over the parameters of the integral of
 *   |K_measured^q - K^q|^2 (or g) from 0 to MaximumDistance; the intensity is n / |W|. A Cox process of a Range below a
 *   quarter of the mean distance of points, 1 / intensity^(1/2), does not exist.
 * - These and Poisson with a trend: FitTrend first, and then the same with the K or g of points that are weighted by
 *   1 / intensity (Waagepetersen and Guan 2009). Intensity and ClusterSize are those of places of the mean intensity.
 * - Matern II: Distance is the shortest distance times n / (n + 1) (Ripley and Silverman 1978), intensity n / |W|, and
 *   a trend that thins points, as SimulateProcess() does.
 * - Strauss: Distance has the largest pseudo-likelihood (Besag 1975) of all points, at the best Activity and
 *   Interaction of each of 128 distances up to a quarter of the shorter side of the bounding box, and at most to 2.5
 *   mean distances of points. Activity and Interaction are then those of FitStrauss() with a border of that distance,
 *   if there are any. Activities of more than a hundred intensities are left out: such points are packed, and no
 *   simulation of them ends.
 * - Soft core: FitSoftCore with a border of 0.85 mean distances of points, 1 / intensity^(1/2), then RefineSoftCore.
 */
ProcessFit FitProcess(PointProcess process, const std::vector<PlanePosition>& points, const ObservationWindow& window,
  const ContrastOptions& options, const ParallelFor& parallel = SerialFor);

/// Trend of the degree of the options, by FitTrend(); none for the degree 0.
IntensityTrend TrendOf(
  const std::vector<PlanePosition>& points, const ObservationWindow& window, const ContrastOptions& options);

/// Fits with the TrendOf() the points, which all processes share.
ProcessFit FitProcess(PointProcess process, const std::vector<PlanePosition>& points, const ObservationWindow& window,
  const ContrastOptions& options, const IntensityTrend& trend, const ParallelFor& parallel = SerialFor);

/// Fits a Strauss process of a given Distance by the maximum of the pseudo-likelihood. Border correction [m]: points
/// nearer to the edge, and places, are neighbours only. The integral is a sum over 256 by 256 places of the bounding
/// box.
ProcessFit FitStrauss(const std::vector<PlanePosition>& points, const ObservationWindow& window, double distance,
  double border, const ParallelFor& parallel = SerialFor);

/// Fits a soft-core process by the maximum of the pseudo-likelihood over Distance at each Softness of 0.05, 0.1 ...
/// 0.75, and over those. Border correction [m]: points nearer to the edge are neighbours only; neighbours count up to
/// three mean distances of points. The integral is a sum over 128 by 128 places and the points (Berman and Turner
/// 1992). The fit exists if its log-pseudo-likelihood exceeds that of random points by more than 5, as by chance one
/// random pattern in twenty.
ProcessFit FitSoftCore(const std::vector<PlanePosition>& points, const ObservationWindow& window, double border,
  const ParallelFor& parallel = SerialFor);

/// Refines a fit to the maximum likelihood given the number of points, by stochastic approximation (Robbins and Monro
/// 1951). At the maximum the integrals of g times the derivatives of the potential by ln Distance and by Softness are
/// those of the pattern (with translation correction, up to half the shorter side). 24 iterations of 40 sweeps of one
/// simulation take Newton steps, whose derivatives are the covariances of these sums, shortened as 1, 1/2, 1/3 ... from
/// the ninth on.
ProcessFit RefineSoftCore(const ProcessFit& start, const std::vector<PlanePosition>& points,
  const ObservationWindow& window, const ParallelFor& parallel = SerialFor);

}

#endif
