// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPointProcess_h
#define LittoralPointProcess_h

#include "Numerics/ParameterTraits.h"

#include <cstddef>
#include <string>
#include <vector>

namespace littoral
{

/// Point processes of the plane (Illian et al. 2008). Values are user-visible.
enum class PointProcess
{
  Poisson = 0,
  Thomas = 1,
  MaternCluster = 2,
  LogGaussianCox = 3,
  MaternII = 4,
  Strauss = 5,
  SoftCore = 6,
};

inline constexpr int NumberOfPointProcesses = 7;

/**
 * A stationary and isotropic process with its parameters. Intensity is the mean number of points on 1 m2.
 * | process        | points                                                                                     |
 * |----------------|--------------------------------------------------------------------------------------------|
 * | Poisson        | independent: random                                                                        |
 * | Thomas         | clusters of Poisson size, mean ClusterSize, normal about a parent, deviation ClusterScale   |
 * | MaternCluster  | the same, uniform on a disc of radius ClusterScale about the parent                         |
 * | LogGaussianCox | Poisson, of intensity exp(Z): Z is Gaussian with covariance Variance exp(-r / Range)        |
 * | MaternII       | random points, of which each falls that has an older one nearer than Distance               |
 * | Strauss        | density Activity^n Interaction^s, where s pairs of the n points are nearer than Distance    |
 * | SoftCore       | density exp(-sum over pairs of (Distance / r)^(2 / Softness)) of a given number of points        |
 * Parents are random, of intensity Intensity / ClusterSize, and are no points themselves.
 */
struct PointProcessParameters
{
  PointProcess Process = PointProcess::Thomas;
  double Intensity = 0.01;   ///< [1/m2]
  double ClusterSize = 5.0;  ///< mean number of points of a cluster
  double ClusterScale = 5.0; ///< [m]
  double Variance = 1.0;     ///< of the logarithm of the intensity
  double Range = 20.0;       ///< [m], distance at which its correlation is 1/e
  double Distance = 5.0;     ///< [m], of inhibition
  double Activity = 0.02;    ///< [1/m2], intensity that the points would have without interaction
  double Interaction = 0.1;  ///< 0: none nearer than Distance, 1: random
  double Softness = 0.4;     ///< 0.05: almost a hard core of Distance, to 0.8: one that is felt far away
};

/// The row of a process: everything that sets it apart but the simulation, see ProcessPattern, and the fit, see
/// ProcessFit, of processes without clusters. A new process of clusters is an enumerator and a row.
struct PointProcessTraits
{
  using Function = double (*)(const PointProcessParameters&, double r);

  const char* Name; ///< as in the enumeration
  ParameterList<PointProcessParameters> Parameters;
  /// g(r), r > 0; null where there is no closed form.
  Function PairCorrelation;
  /// K(r); null where it is the integral of g or has no closed form.
  Function Ripley = nullptr;
  /// Why parameters that are allowed one by one make no process together; null where all do.
  std::string (*WhyInvalid)(const PointProcessParameters&) = nullptr;
  /// Offsets of the points of a cluster from its parent, in place of two uniform numbers each; null: no clusters.
  void (*Offsets)(double scale, std::size_t count, double* u, double* v) = nullptr;
  double OffsetReach = 1.0; ///< of all offsets [ClusterScale]
};

/// The row of a process, which must be one of the enumeration.
const PointProcessTraits& TraitsOf(PointProcess process);

/// The parameters of all processes, in the order of tables.
const ParameterList<PointProcessParameters>& AllPointProcessParameters();

/// The name of a process, as in the enumeration.
const char* PointProcessName(PointProcess process);

/// Why these parameters make no process, in words for a user; empty when they do.
std::string WhyInvalid(const PointProcessParameters& process);

/// Mean number of parents on 1 m2 of a process of clusters.
double ParentIntensity(const PointProcessParameters& process);

/// Intensity of the random points from which a Matern II process of the given intensity and distance is left [1/m2]:
/// Intensity = (1 - exp(-p pi Distance^2)) / (pi Distance^2).
double ProposedIntensity(double intensity, double distance);

/// Pair correlation g(r) at r > 0 [m]; NaN where there is no closed form.
double PairCorrelation(const PointProcessParameters& process, double r);

/// Ripley's K [m2] at distances that rise from 0 or above; NaN where there is no closed form.
std::vector<double> RipleyK(const PointProcessParameters& process, const std::vector<double>& distances);

}

#endif
