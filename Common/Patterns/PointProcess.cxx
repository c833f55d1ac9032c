// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns/PointProcess.h"

#include "Numerics/Constants.h"
#include "Patterns/ClusterOffsets.h"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace littoral
{

namespace
{

using Parameters = PointProcessParameters;

constexpr auto Intensity =
  MakeParameter<Parameters, &Parameters::Intensity>("Intensity", "1/m2", ValueInterval::Positive());
constexpr auto ClusterSize =
  MakeParameter<Parameters, &Parameters::ClusterSize>("ClusterSize", "", ValueInterval::Above(0.0, 1e4));
constexpr auto ClusterScale =
  MakeParameter<Parameters, &Parameters::ClusterScale>("ClusterScale", "m", ValueInterval::Positive());
constexpr auto Variance =
  MakeParameter<Parameters, &Parameters::Variance>("Variance", "", ValueInterval::Above(0.0, 10.0));
constexpr auto Range = MakeParameter<Parameters, &Parameters::Range>("Range", "m", ValueInterval::Positive());
constexpr auto Distance = MakeParameter<Parameters, &Parameters::Distance>("Distance", "m", ValueInterval::Positive());
constexpr auto Activity =
  MakeParameter<Parameters, &Parameters::Activity>("Activity", "1/m2", ValueInterval::Positive());
constexpr auto Interaction =
  MakeParameter<Parameters, &Parameters::Interaction>("Interaction", "", ValueInterval::From(0.0, 1.0));
constexpr auto Softness =
  MakeParameter<Parameters, &Parameters::Softness>("Softness", "", ValueInterval::From(0.05, 0.8));

constexpr ParameterList<Parameters> All = { { &Intensity, &ClusterSize, &ClusterScale, &Variance, &Range, &Distance,
  &Activity, &Interaction, &Softness } };

/// Points of a soft-core process on the square of Distance, at most.
constexpr double MaximumSoftCores = 2.0;

double RandomPairs(const Parameters&, double)
{
  return 1.0;
}

double RandomRipley(const Parameters&, double r)
{
  return Pi * r * r;
}

/// g = 1 + exp(-r^2 / 4 s^2) / (4 pi s^2 kappa).
double ThomasPairs(const Parameters& process, double r)
{
  const double s2 = 4.0 * process.ClusterScale * process.ClusterScale;
  return 1.0 + std::exp(-r * r / s2) / (Pi * s2 * ParentIntensity(process));
}

/// K = pi r^2 + (1 - exp(-r^2 / 4 s^2)) / kappa.
double ThomasRipley(const Parameters& process, double r)
{
  const double s2 = 4.0 * process.ClusterScale * process.ClusterScale;
  return Pi * r * r - std::expm1(-r * r / s2) / ParentIntensity(process);
}

/// g = 1 + 2 (arccos z - z (1 - z^2)^(1/2)) / (pi^2 R^2 kappa), z = r / 2R < 1.
double MaternPairs(const Parameters& process, double r)
{
  const double radius = process.ClusterScale;
  const double z = std::min(1.0, r / (2.0 * radius));
  const double overlap = std::acos(z) - z * std::sqrt(1.0 - z * z);
  return 1.0 + 2.0 * overlap / (Pi * Pi * radius * radius * ParentIntensity(process));
}

/// K = pi r^2 + h(z) / kappa, h = 2 + ((8 z^2 - 4) arccos z - 2 arcsin z + 4 z (1 - z^2)^(3/2) - 6 z (1 - z^2)^(1/2)) /
/// pi.
double MaternRipley(const Parameters& process, double r)
{
  const double z = std::min(1.0, r / (2.0 * process.ClusterScale));
  const double w = std::sqrt(1.0 - z * z);
  const double h =
    2.0 + ((8.0 * z * z - 4.0) * std::acos(z) - 2.0 * std::asin(z) + 4.0 * z * w * w * w - 6.0 * z * w) / Pi;
  return Pi * r * r + h / ParentIntensity(process);
}

/// g = exp(s2 exp(-r / Range)).
double CoxPairs(const Parameters& process, double r)
{
  return std::exp(process.Variance * std::exp(-r / process.Range));
}

/// Area of two discs of radius h whose centers are r apart, together.
double AreaOfTwoDiscs(double h, double r)
{
  const double z = std::min(1.0, r / (2.0 * h));
  return 2.0 * h * h * (Pi - std::acos(z) + z * std::sqrt(1.0 - z * z));
}

/// g = 2 (V (1 - exp(-p A)) - A (1 - exp(-p V))) / (A V (V - A) Intensity^2) beyond h, where A = pi h^2, V is the area
/// of the two discs, and p the proposed intensity.
double InhibitedPairs(const Parameters& process, double r)
{
  const double h = process.Distance;
  if (r < h)
  {
    return 0.0;
  }
  const double a = Pi * h * h;
  const double v = AreaOfTwoDiscs(h, r);
  const double p = ProposedIntensity(process.Intensity, h);
  const double pairs = 2.0 * (a * std::expm1(-p * v) - v * std::expm1(-p * a)) / (a * v * (v - a));
  return pairs / (process.Intensity * process.Intensity);
}

std::string WhyNotInhibited(const Parameters& process)
{
  const double most = 1.0 / (Pi * process.Distance * process.Distance);
  ParameterCheck check;
  check.Require(process.Intensity < 0.999 * most, "Intensity", process.Intensity, "1/m2",
    "below " + TextOf(0.999 * most) + " 1/m2, 0.999 / (pi Distance^2), which no Matern II process exceeds");
  return check.Reason();
}

std::string WhyNoSoftCore(const Parameters& process)
{
  const double most = MaximumSoftCores / (process.Distance * process.Distance);
  ParameterCheck check;
  check.Require(process.Intensity <= most, "Intensity", process.Intensity, "1/m2",
    "at most " + TextOf(most) + " 1/m2, " + TextOf(MaximumSoftCores) + " / Distance^2: denser points freeze");
  return check.Reason();
}

const PointProcessTraits Rows[] = {
  { "Poisson", { { &Intensity } }, RandomPairs, RandomRipley },
  { "Thomas", { { &Intensity, &ClusterSize, &ClusterScale } }, ThomasPairs, ThomasRipley, nullptr, MakeNormalOffsets,
    NormalReach },
  { "MaternCluster", { { &Intensity, &ClusterSize, &ClusterScale } }, MaternPairs, MaternRipley, nullptr,
    MakeDiscOffsets },
  { "LogGaussianCox", { { &Intensity, &Variance, &Range } }, CoxPairs },
  { "MaternII", { { &Intensity, &Distance } }, InhibitedPairs, nullptr, WhyNotInhibited },
  { "Strauss", { { &Activity, &Interaction, &Distance } }, nullptr },
  { "SoftCore", { { &Intensity, &Distance, &Softness } }, nullptr, nullptr, WhyNoSoftCore },
};
static_assert(std::size(Rows) == NumberOfPointProcesses);

/// The integral of 2 pi r (g(r) - 1) from a to b.
double PairsBetween(const PointProcessTraits& row, const Parameters& process, double a, double b)
{
  const auto pairs = [&](double r) { return TwoPi * r * (row.PairCorrelation(process, r) - 1.0); };
  return boost::math::quadrature::gauss<double, 15>::integrate(pairs, a, b);
}

/// Steps of the integral of g, and the distance beyond which g is 1.
struct PairSteps
{
  double Longest;
  double Reach;
};

PairSteps StepsOf(const Parameters& process)
{
  const bool isCox = process.Process == PointProcess::LogGaussianCox;
  return { 0.5 * (isCox ? process.Range : process.Distance), isCox ? 45.0 * process.Range : 2.0 * process.Distance };
}

/// The same in steps short enough, which end where an inhibition begins and ends.
double IntegralOfPairs(const PointProcessTraits& row, const Parameters& process, double a, double b)
{
  const PairSteps steps = StepsOf(process);
  const double end = std::min(b, steps.Reach);
  double sum = 0.0;
  for (double from = a; from < end;)
  {
    const double to = std::min(end, steps.Longest * (std::floor(from / steps.Longest + 1e-9) + 1.0));
    sum += PairsBetween(row, process, from, to);
    from = to;
  }
  return sum;
}

}

const PointProcessTraits& TraitsOf(PointProcess process)
{
  return Rows[static_cast<int>(process)];
}

const ParameterList<PointProcessParameters>& AllPointProcessParameters()
{
  return All;
}

const char* PointProcessName(PointProcess process)
{
  return TraitsOf(process).Name;
}

std::string WhyInvalid(const PointProcessParameters& process)
{
  ParameterCheck check;
  check.Choice("Process", static_cast<int>(process.Process), NumberOfPointProcesses);
  if (check.IsGood())
  {
    const PointProcessTraits& row = TraitsOf(process.Process);
    check.Require(row.Parameters.WhyInvalid(process));
    check.Require(check.IsGood() && row.WhyInvalid ? row.WhyInvalid(process) : std::string());
  }
  return check.Reason();
}

double ParentIntensity(const PointProcessParameters& process)
{
  return process.Intensity / process.ClusterSize;
}

double ProposedIntensity(double intensity, double distance)
{
  const double area = Pi * distance * distance;
  return -std::log1p(-intensity * area) / area;
}

double PairCorrelation(const PointProcessParameters& process, double r)
{
  const auto function = TraitsOf(process.Process).PairCorrelation;
  return function ? function(process, r) : std::numeric_limits<double>::quiet_NaN();
}

std::vector<double> RipleyK(const PointProcessParameters& process, const std::vector<double>& distances)
{
  const PointProcessTraits& row = TraitsOf(process.Process);
  std::vector<double> result(distances.size(), std::numeric_limits<double>::quiet_NaN());
  double at = 0.0;
  double sum = 0.0;
  for (std::size_t n = 0; n < distances.size(); ++n)
  {
    if (row.Ripley)
    {
      result[n] = row.Ripley(process, distances[n]);
    }
    else if (row.PairCorrelation)
    {
      sum += IntegralOfPairs(row, process, at, distances[n]);
      at = distances[n];
      result[n] = Pi * at * at + sum;
    }
  }
  return result;
}

}
