// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPatternVerdict_h
#define LittoralPatternVerdict_h

#include "Numerics/Parallel.h"
#include "Patterns/CurveEnvelope.h"
#include "Patterns/ObservationWindow.h"
#include "Patterns/PairFunctions.h"
#include "Patterns/ProcessFit.h"
#include "Patterns/QuadratFit.h"
#include "Patterns/QuadratPattern.h"

#include <array>
#include <string>
#include <vector>

namespace littoral
{

/// Summary function of the test.
enum class VerdictFunction
{
  PairCorrelation = 0, ///< g
  BesagL = 1,          ///< L
};

/// Options of the fits and tests of processes and laws.
struct VerdictOptions
{
  ContrastOptions Contrast; ///< options of the fits
  VerdictFunction Function = VerdictFunction::PairCorrelation;
  int Simulations = 99; ///< simulated patterns of each process and law
  double Level = 0.05;  ///< significance level
  int Seed = 1;
  int Steps = 64;                      ///< number of distances at which the function is compared
  std::array<int, 2> Quadrats{ 0, 0 }; ///< of the laws; 0 0: about as many nearly square ones as points
};

/// Why there can be no verdict, in words for a user; empty when there can.
std::string WhyInvalid(const VerdictOptions& options);

/// Verdict on a process or a law.
enum class PatternVerdict
{
  Best = 0,               ///< the largest p of all that are not rejected
  NotDistinguishable = 1, ///< not rejected by the envelope test
  Worse = 2,              ///< rejected by the envelope test
  DoesNotExist = 3,       ///< the pattern admits no such process or law
};

/// The word of a verdict, as in tables of fits.
const char* WordOf(PatternVerdict verdict);

/// Verdict on a law of counts by its AIC, beside that of the best one (DistinguishableAIC).
PatternVerdict VerdictOf(const QuadratFit& fit, const QuadratFit& best);

/// A process or a law, fitted and judged.
struct JudgedLaw
{
  bool IsProcess = true;
  ProcessFit Process; ///< of a process
  QuadratFit Law;     ///< of a law of counts in quadrats
  CurveEnvelope Envelope;
  PatternVerdict Verdict = PatternVerdict::DoesNotExist;
  const char* Name() const;
  bool Exists() const { return this->IsProcess ? this->Process.Exists : this->Law.Exists; }
};

/// All processes and laws, best first, with the measured function.
struct PatternJudgement
{
  std::vector<JudgedLaw> Laws;
  QuadratGrid Grid;              ///< of the laws
  std::vector<double> Distances; ///< [m]
  std::vector<double> Measured;  ///< the function of the pattern
};

/**
 * Fits all processes and, in a rectangle, all laws of quadrats to a pattern, simulates each so many times in the
 * window, and compares g or L of the pattern with those of its simulations by the global envelope test of extreme rank
 * lengths (CurveEnvelope), the same for all. g has the same kernel in all of them, and both have the translation
 * correction, whatever the fits have. What is best has the largest p, of equal ones the fewest parameters.
 *
 * The poll comes PollsOfCurves times in the simulations of each. Processes share the simulations, and each fits all;
 * the first one has the judgement.
 *
 * As parameters were fitted to the same pattern, the test rejects less often than its level says (Baddeley et al.
 * 2017).
 */
PatternJudgement JudgePattern(const std::vector<PlanePosition>& points, const ObservationWindow& window,
  const VerdictOptions& options, const Poll& poll = NoPoll, const ParallelFor& parallel = SerialFor,
  const WorkShare& share = {});

}

#endif
