// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../OnThreads.h"
#include "MappedPatterns.h"
#include "Patterns/CurveEnvelope.h"
#include "Patterns/PairFunctions.h"
#include "Patterns/PatternVerdict.h"
#include "Patterns/ProcessFit.h"
#include "Patterns/ProcessPattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace littoral;
using littoral::testing::Mapped;

namespace
{

ObservationWindow WindowOf(const std::string& name)
{
  const double low = name == "redwood" ? -1.0 : 0.0;
  return ObservationWindow::Rectangle({ 0.0, low }, { 1.0, low + 1.0 });
}

const JudgedLaw& Find(const PatternJudgement& judgement, const std::string& name, bool isProcess)
{
  return *std::find_if(judgement.Laws.begin(), judgement.Laws.end(),
    [&](const JudgedLaw& law) { return law.IsProcess == isProcess && law.Name() == name; });
}

}

// g of each pattern lies in the global envelope of 39 simulations of what is called best; a random pattern is not made
// of what has clusters.
TEST(PatternVerdict, MappedPatternsAreRegrown)
{
  for (const char* name : { "redwood", "japanesepines" })
  {
    SCOPED_TRACE(name);
    VerdictOptions options;
    options.Simulations = 39;
    const PatternJudgement judgement = JudgePattern(Mapped(name), WindowOf(name), options);
    ASSERT_EQ(judgement.Laws.size(), static_cast<std::size_t>(NumberOfPointProcesses + NumberOfQuadratLaws));
    const JudgedLaw& best = judgement.Laws.front();
    EXPECT_EQ(best.Verdict, PatternVerdict::Best);
    EXPECT_GT(best.Envelope.PValue, 0.05) << best.Name();
    EXPECT_TRUE(best.Envelope.Outside.empty()) << best.Name();
    for (std::size_t n = 1; n < judgement.Laws.size(); ++n)
    {
      const JudgedLaw& law = judgement.Laws[n];
      EXPECT_EQ(law.Verdict == PatternVerdict::DoesNotExist, !law.Exists());
      EXPECT_EQ(law.Verdict == PatternVerdict::Worse, law.Exists() && law.Envelope.PValue <= 0.05) << law.Name();
      EXPECT_TRUE(!law.Exists() || law.Envelope.PValue <= judgement.Laws[n - 1].Envelope.PValue);
    }
    const bool isClustered = std::string(name) == "redwood";
    EXPECT_EQ(Find(judgement, "Poisson", true).Verdict == PatternVerdict::Worse, isClustered);
    EXPECT_EQ(Find(judgement, "Thomas", true).Exists(), isClustered);
  }
}

// Cells keep soft distances: g falls slowly between 0.12 and 0.08 and is above 1.8 at 0.15, which neither a strict
// distance nor that of Strauss makes, but a soft core does.
TEST(PatternVerdict, CellsHaveASoftCoreAndNothingElse)
{
  const PatternJudgement judgement = JudgePattern(Mapped("cells"), WindowOf("cells"), {});
  const JudgedLaw& best = judgement.Laws.front();
  EXPECT_STREQ(best.Name(), "SoftCore");
  EXPECT_EQ(best.Verdict, PatternVerdict::Best);
  EXPECT_TRUE(best.Envelope.Outside.empty());
  for (std::size_t n = 1; n < judgement.Laws.size(); ++n)
  {
    const JudgedLaw& law = judgement.Laws[n];
    EXPECT_EQ(law.Verdict, law.Exists() ? PatternVerdict::Worse : PatternVerdict::DoesNotExist) << law.Name();
  }
  EXPECT_TRUE(Find(judgement, "Strauss", true).Exists());
  EXPECT_FALSE(Find(judgement, "Thomas", true).Exists());
}

// The same of two processes alone, which costs less.
TEST(PatternVerdict, CellsAreMadeByASoftCoreAndNotByAStrictDistance)
{
  const std::vector<PlanePosition> cells = Mapped("cells");
  const ObservationWindow window = WindowOf("cells");
  PairOptions pairs;
  pairs.Distances = DefaultDistances(window, cells.size(), 64);
  pairs.Correction = EdgeCorrection::Translation;
  pairs.WantsK = false;
  pairs.HalfWidth = 0.15 / std::sqrt(static_cast<double>(cells.size()));
  const auto curve = [&](const std::vector<PlanePosition>& points, const ParallelFor&) {
    const std::vector<double> g = FindPairFunctions(points, window, pairs).PairCorrelation;
    return std::vector<double>(g.begin() + 1, g.end());
  };
  for (const PointProcess id : { PointProcess::SoftCore, PointProcess::MaternII })
  {
    const ProcessFit fit = FitProcess(id, cells, window, {});
    ASSERT_TRUE(fit.Exists);
    const auto law = [&](int number, const ParallelFor&) {
      ProcessOptions options;
      options.Seed = SeedOfSimulation(1, number);
      return SimulateProcess(fit.Process, options, window).Points;
    };
    const CurveEnvelope envelope = FindCurveEnvelope(curve(cells, SerialFor), SimulateCurves(law, curve, 99), 0.05);
    EXPECT_EQ(envelope.IsRejected, id == PointProcess::MaternII) << envelope.PValue;
  }
}

// Points at the corners of squares keep more order than any process or law has.
TEST(PatternVerdict, WhatNothingMakesIsCalledByNoName)
{
  std::vector<PlanePosition> points;
  for (int n = 0; n < 25; ++n)
  {
    points.push_back({ 0.1 + 0.2 * (n % 5), 0.1 + 0.2 * (n / 5) + 1e-3 * (n % 7) });
  }
  VerdictOptions options;
  options.Simulations = 19;
  const PatternJudgement judgement = JudgePattern(points, ObservationWindow(), options);
  for (const JudgedLaw& law : judgement.Laws)
  {
    EXPECT_EQ(law.Verdict, law.Exists() ? PatternVerdict::Worse : PatternVerdict::DoesNotExist) << law.Name();
  }
}

// In a polygon there are no quadrats, and processes are judged as in a rectangle; the same on any threads.
TEST(PatternVerdict, PolygonsHaveProcessesOnly)
{
  PointProcessParameters process;
  process.Process = PointProcess::Thomas;
  process.Intensity = 40.0;
  process.ClusterSize = 8.0;
  process.ClusterScale = 0.02;
  const ObservationWindow window =
    ObservationWindow::Polygon({ { 0.0, 0.0 }, { 1.5, 0.2 }, { 0.5, 1.3 }, { -0.2, 0.6 } });
  const std::vector<PlanePosition> points = SimulateProcess(process, {}, window).Points;
  VerdictOptions options;
  options.Simulations = 19;
  options.Contrast.Correction = EdgeCorrection::Translation;
  options.Function = VerdictFunction::BesagL;
  options.Steps = 16;
  const PatternJudgement one = JudgePattern(points, window, options);
  EXPECT_EQ(one.Laws.size(), static_cast<std::size_t>(NumberOfPointProcesses));
  EXPECT_GT(Find(one, "Thomas", true).Envelope.PValue, 0.05);
  EXPECT_LE(Find(one, "Poisson", true).Envelope.PValue, 0.05);
  const PatternJudgement two = JudgePattern(points, window, options, NoPoll, littoral::testing::OnThreads(3));
  for (std::size_t n = 0; n < one.Laws.size(); ++n)
  {
    EXPECT_STREQ(one.Laws[n].Name(), two.Laws[n].Name());
    EXPECT_EQ(one.Laws[n].Envelope.PValue, two.Laws[n].Envelope.PValue);
    EXPECT_EQ(one.Laws[n].Envelope.GlobalHigh, two.Laws[n].Envelope.GlobalHigh);
  }
}

TEST(PatternVerdict, OptionsThatCannotBeAreNamed)
{
  const auto names = [](const VerdictOptions& options, const char* word) {
    return WhyInvalid(options).find(word) != std::string::npos;
  };
  VerdictOptions options;
  EXPECT_EQ(WhyInvalid(options), "");
  options.Simulations = 10;
  EXPECT_TRUE(names(options, "10"));
  options = {};
  options.Quadrats = { -1, 3 };
  EXPECT_TRUE(names(options, "Quadrats"));
  options = {};
  options.Contrast.Correction = EdgeCorrection::Border;
  EXPECT_TRUE(names(options, "border"));
  options = {};
  options.Steps = 2;
  EXPECT_TRUE(names(options, "Steps"));
}

// AICs that are nearer to the best than DistinguishableAIC are not told apart.
TEST(PatternVerdict, VerdictsByAIC)
{
  std::vector<QuadratFit> fits(4);
  const double above[] = { 0.0, 1.9, 2.0, 0.0 };
  for (std::size_t n = 0; n < 4; ++n)
  {
    fits[n].Exists = n < 3;
    fits[n].AIC = 100.0 + above[n];
  }
  const char* const words[] = { "best", "not distinguishable", "worse", "does not exist" };
  for (std::size_t n = 0; n < 4; ++n)
  {
    EXPECT_STREQ(WordOf(VerdictOf(fits[n], fits[0])), words[n]);
  }
}
