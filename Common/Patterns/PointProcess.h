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
 * A stationary and isotropic process with its parameters. Intensity lambda is the mean number of points on 1 m2.
 * | process        | points                                                                                     |
 * |----------------|--------------------------------------------------------------------------------------------|
 * | Poisson        | independent: complete spatial randomness                                                    |
 * | Thomas         | clusters of Poisson size, mean ClusterSize, normal offsets from a parent of ClusterScale    |
 * | MaternCluster  | the same, uniform on a disc of radius ClusterScale about the parent                         |
 * | LogGaussianCox | Poisson of intensity exp(Z), with a Gaussian field Z of covariance Variance exp(-r / Range) |
 * | MaternII       | Poisson, of which each point is deleted that has an older one nearer than Distance          |
 * | Strauss        | density Activity^n Interaction^s, where s pairs of the n points are nearer than Distance    |
 * | SoftCore       | density exp(-sum over pairs of (Distance / r)^(2 / Softness)) of a given number of points   |
 * Parents are Poisson, of intensity kappa = Intensity / ClusterSize, and are no points themselves.
 */
struct PointProcessParameters
{
  PointProcess Process = PointProcess::Thomas;
  double Intensity = 0.01;   ///< lambda [1/m2], positive
  double ClusterSize = 5.0;  ///< mean number of points of a cluster, mu, above 0, at most 1e4
  double ClusterScale = 5.0; ///< standard deviation sigma of the offsets, or radius R of the disc [m], positive
  double Variance = 1.0;     ///< variance of the log-intensity, above 0, at most 10
  double Range = 20.0;       ///< distance at which the correlation of the log-intensity is 1/e [m], positive
  double Distance = 5.0;     ///< inhibition distance, interaction radius, or sigma of the soft core [m], positive
  double Activity = 0.02;    ///< beta of Strauss, the intensity without interaction [1/m2], positive
  double Interaction = 0.1;  ///< gamma of Strauss, 0 (hard core) to 1 (Poisson)
  double Softness = 0.4; ///< kappa of the soft core, 0.05 (almost a hard core) to 0.8 (an interaction of long range)
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
  double OffsetReach = 1.0; ///< maximum length of the offsets [ClusterScale]
};

/// The row of a process, which must be one of the enumeration.
const PointProcessTraits& TraitsOf(PointProcess process);

/// The parameters of all processes, in the order of tables.
const ParameterList<PointProcessParameters>& AllPointProcessParameters();

/// The name of a process, as in the enumeration.
const char* PointProcessName(PointProcess process);

/// Why these parameters make no process, in words for a user; empty when they do.
std::string WhyInvalid(const PointProcessParameters& process);

/// Intensity of the parents of a cluster process, kappa = Intensity / ClusterSize [1/m2].
double ParentIntensity(const PointProcessParameters& process);

/// Intensity p of the Poisson process before the thinning of a Matern II process of an intensity and a distance [1/m2]:
/// Intensity = (1 - exp(-p pi Distance^2)) / (pi Distance^2).
double ProposedIntensity(double intensity, double distance);

/// Pair correlation g(r) at r > 0 [m]; NaN where there is no closed form.
double PairCorrelation(const PointProcessParameters& process, double r);

/// Ripley's K [m2] at distances that rise from 0 or above; NaN where there is no closed form.
std::vector<double> RipleyK(const PointProcessParameters& process, const std::vector<double>& distances);

}

#endif
