// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPatternStatistics_h
#define LittoralPatternStatistics_h

#include "Numerics/Parallel.h"
#include "Patterns/CurveEnvelope.h"
#include "Patterns/DistanceFunctions.h"
#include "Patterns/ObservationWindow.h"
#include "Patterns/PairFunctions.h"
#include "Patterns/PatternLaw.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace littoral
{

/// Functions of distance of a point pattern. Values are user-visible.
enum class PatternFunction
{
  K = 0,                    ///< Ripley's K [m2]
  L = 1,                    ///< Besag's L [m]
  PairCorrelation = 2,      ///< g
  NearestNeighbor = 3,      ///< G
  EmptySpace = 4,           ///< F
  J = 5,                    ///< (1 - G) / (1 - F)
  MarkCorrelation = 6,      ///< k_mm
  CrossK = 7,               ///< K from one species to another [m2]
  CrossPairCorrelation = 8, ///< g from one species to another
};

inline constexpr int NumberOfPatternFunctions = 9;

/// The name of a function, as in the enumeration.
const char* NameOf(PatternFunction function);

/// The value of a function for a random pattern of an intensity [1/m2]: pi r^2, r, 1 - exp(-intensity pi r^2) or 1.
double RandomValue(PatternFunction function, double r, double intensity);

/// The kind of pattern whose function is above that of random ones, or below it: "regular" or "clustered".
const char* KindBeside(PatternFunction function, bool isAbove);

/// Whether a function is one of two species.
bool IsCross(PatternFunction function);

/// Curves by functions; those that were not asked for, or that a pattern does not admit, are empty.
using FunctionCurves = std::array<std::vector<double>, NumberOfPatternFunctions>;

/// Mapped points, and what they are besides.
struct MappedPattern
{
  std::vector<PlanePosition> Points; ///< in the window
  ObservationWindow Window;
  std::vector<double> Marks;        ///< one a point, positive; or none
  std::vector<std::string> Species; ///< one a point; or none
  std::array<std::string, 2> Pair;  ///< species that cross functions go from and to

  double GetIntensity() const { return static_cast<double>(this->Points.size()) / this->Window.GetArea(); } ///< [1/m2]
};

/// Completes the pair of species of cross functions: the most frequent one but for the other, of equal ones the first
/// by the alphabet. Throws InvalidInput if there is no such pair.
void ChoosePair(MappedPattern& pattern);

/// Options of the measurement and comparison of a pattern.
struct StatisticsOptions
{
  PatternFunction Function = PatternFunction::L;         ///< function that is compared; its kind sets the distances
  EdgeCorrection Correction = EdgeCorrection::Isotropic; ///< Border is for K; other functions take Translation then
  DistanceCorrection Nearest = DistanceCorrection::KaplanMeier;
  double MaximumDistance = 0.0; ///< largest distance [m]; 0: DefaultDistances, or DefaultNearestDistances
  int Steps = 256;
  double HalfWidth = 0.0; ///< half width of the kernel of g [m]; 0: Stoyan's rule
  int Simulations = 99;   ///< 0: no comparison
  double Level = 0.05;
  int Seed = 1;
};

/// Why the options cannot be, in words for a user; empty when they can.
std::string WhyInvalid(const StatisticsOptions& options);

/// Functions of a pattern, and their comparison with simulated ones. The pattern must live as long.
class PatternStatistics
{
public:
  PatternStatistics(
    const MappedPattern& pattern, const StatisticsOptions& options, const ParallelFor& parallel = SerialFor);

  /// The distances of all curves [m].
  std::vector<double> GetDistances() const;

  /// All functions that the pattern admits. Processes share the pairs; the first one has the functions.
  FunctionCurves Measure(const ParallelFor& parallel = SerialFor, const WorkShare& share = {}) const;

  /**
   * The measured curve of the chosen function beside those of simulations: of patterns of a law, without one of as many
   * points, uniform in the window; for the mark correlation the same points with marks in a random order, for cross
   * functions with species in a random order. The poll comes PollsOfCurves times. Processes share the simulations;
   * the first one has the envelope.
   */
  CurveEnvelope Compare(const std::vector<double>& measured, const PatternLaw* law, const Poll& poll = NoPoll,
    const ParallelFor& parallel = SerialFor, const WorkShare& share = {}) const;

private:
  using Positions = std::vector<PlanePosition>;

  PairOptions OtherPairs() const;
  template <typename FindOfOptions>
  PairFunctions FindPairs(
    bool wantsK, bool wantsG, bool wantsMarks, const WorkShare& share, const FindOfOptions& find) const;
  FunctionCurves Find(std::optional<PatternFunction> function, const Positions& points,
    const std::vector<double>& marks, const ParallelFor& parallel, const WorkShare& share = {}) const;
  FunctionCurves FindCross(std::optional<PatternFunction> function, const std::array<Positions, 2>& species,
    const ParallelFor& parallel, const WorkShare& share = {}) const;
  std::array<Positions, 2> Split(const std::vector<std::size_t>& order) const;
  std::vector<double> Simulate(const PatternLaw* law, int number, const ParallelFor& parallel) const;

  const MappedPattern& Pattern;
  StatisticsOptions Options;
  PairOptions Pairs; ///< options of K
};

}

#endif
