// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../OnThreads.h"
#include "Kriging/ConditionalField.h"
#include "Kriging/CrossValidation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace littoral;
using littoral::testing::OnThreads;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// A grid of 31 x 21 points with data at some of them, of an exponential field of the variance 4 and a known mean.
KrigingSurvey Survey()
{
  KrigingSurvey survey;
  survey.Grid = { { 100.0, -50.0 }, { 2.0, 3.0 } };
  survey.Window = { { 0, 0 }, { 30, 20 } };
  survey.Type = KrigingType::Simple;
  survey.Mean = 50.0;
  survey.Model.Field.Model = CovarianceModel::SimpleExponential;
  survey.Model.Field.Variance = 4.0;
  survey.Model.Field.Range = 8.0;
  survey.Data.Places = { { 110.0, -38.0, 0.0 }, { 140.0, -20.0, 0.0 }, { 120.0, 4.0, 0.0 } };
  survey.Data.Values = { 47.0, 53.5, 51.0 };
  survey.Measured = survey.Data.Values;
  return survey;
}

struct Filled
{
  std::vector<double> Values;
  std::vector<double> Variances;
  std::vector<double> AtData;
};

Filled Fill(const KrigingSurvey& survey, const ConditionalOptions& options, const GridWindow& part,
  const ParallelFor& parallel = SerialFor)
{
  ConditionalField field(survey, options);
  field.Tabulate(parallel);
  field.Solve(parallel);
  const int width = part.Last[0] - part.First[0] + 1;
  const int height = part.Last[1] - part.First[1] + 1;
  Filled filled;
  filled.Values.resize(static_cast<std::size_t>(width) * height);
  filled.Variances.resize(filled.Values.size());
  field.Fill(part, filled.Values.data(), filled.Variances.data(), parallel);
  filled.AtData = field.AtData(parallel);
  return filled;
}

std::size_t IndexOf(const KrigingSurvey& survey, std::size_t datum)
{
  const KrigingPlace& place = survey.Data.Places[datum];
  return survey.Index(
    static_cast<int>(std::lround((place.X - 100.0) / 2.0)), static_cast<int>(std::lround((place.Y + 50.0) / 3.0)));
}

}

TEST(ConditionalField, MeetsExactData)
{
  const KrigingSurvey survey = Survey();
  for (const bool simulates : { false, true })
  {
    ConditionalOptions options;
    options.Simulates = simulates;
    options.NumberOfLines = 16;
    const Filled filled = Fill(survey, options, survey.Window);
    for (std::size_t n = 0; n < survey.Data.Places.size(); ++n)
    {
      EXPECT_NEAR(filled.Values[IndexOf(survey, n)], survey.Measured[n], 1e-6);
      EXPECT_NEAR(filled.AtData[n], survey.Measured[n], 1e-6);
      EXPECT_NEAR(filled.Variances[IndexOf(survey, n)], 0.0, 1e-6);
    }
  }
}

// One datum: the simple kriging estimate is m + (z - m) exp(-h / a), and its variance C (1 - exp(-2 h / a)).
TEST(ConditionalField, EstimateFromOneDatum)
{
  KrigingSurvey survey = Survey();
  survey.Data.Places.resize(1);
  survey.Data.Values = survey.Measured = { 47.0 };
  ConditionalOptions options;
  options.Simulates = false;
  const Filled filled = Fill(survey, options, survey.Window);
  for (const auto& [i, j] : { std::pair(7, 4), std::pair(5, 9), std::pair(30, 20) })
  {
    const double decay = std::exp(-std::hypot(2.0 * (i - 5), 3.0 * (j - 4)) / 8.0);
    EXPECT_NEAR(filled.Values[survey.Index(i, j)], 50.0 - 3.0 * decay, 1e-6);
    EXPECT_NEAR(filled.Variances[survey.Index(i, j)], 4.0 * (1.0 - decay * decay), 1e-6);
  }
}

// About the kriging estimate, conditional fields of many seeds have the kriging variance, and data with errors are
// missed by the part of the error that kriging leaves.
TEST(ConditionalField, SeedsHaveTheKrigingVariance)
{
  KrigingSurvey survey = Survey();
  survey.Data.ErrorVariances = { 3.0, 0.0, 0.0 };
  ConditionalOptions options;
  options.Simulates = false;
  const Filled kriged = Fill(survey, options, survey.Window);
  options.Simulates = true;
  options.NumberOfLines = 8;
  constexpr int Seeds = 200;
  const std::size_t points[] = { IndexOf(survey, 0), survey.Index(8, 6), survey.Index(29, 2) };
  double sums[3] = {};
  double squares[3] = {};
  for (options.Seed = 1; options.Seed <= Seeds; ++options.Seed)
  {
    const Filled filled = Fill(survey, options, survey.Window);
    for (int n = 0; n < 3; ++n)
    {
      const double apart = filled.Values[points[n]] - kriged.Values[points[n]];
      sums[n] += apart;
      squares[n] += apart * apart;
    }
  }
  for (int n = 0; n < 3; ++n)
  {
    const double variance = kriged.Variances[points[n]];
    EXPECT_GT(variance, 0.5);
    EXPECT_NEAR(sums[n] / Seeds, 0.0, 4.0 * std::sqrt(variance / Seeds));
    EXPECT_NEAR(squares[n] / Seeds / variance, 1.0, 4.0 * std::sqrt(2.0 / Seeds));
  }
}

TEST(ConditionalField, PartsAndThreadsMakeNoDifference)
{
  const KrigingSurvey survey = Survey();
  ConditionalOptions options;
  options.NumberOfLines = 16;
  const Filled whole = Fill(survey, options, survey.Window);
  EXPECT_EQ(whole.Values, Fill(survey, options, survey.Window, OnThreads(3)).Values);
  const GridWindow part{ { 4, 2 }, { 9, 20 } };
  const Filled own = Fill(survey, options, part);
  std::size_t point = 0;
  for (int j = 2; j <= 20; ++j)
  {
    for (int i = 4; i <= 9; ++i, ++point)
    {
      ASSERT_EQ(own.Values[point], whole.Values[survey.Index(i, j)]);
      ASSERT_EQ(own.Variances[point], whole.Variances[survey.Index(i, j)]);
    }
  }
}

TEST(ConditionalField, RasterKeepsItsValues)
{
  KrigingSurvey survey = Survey();
  survey.Raster.assign(31 * 21, NaN);
  survey.Raster[survey.Index(3, 3)] = 123.0;
  ConditionalOptions options;
  options.NumberOfLines = 4;
  const Filled filled = Fill(survey, options, survey.Window);
  EXPECT_EQ(filled.Values[survey.Index(3, 3)], 123.0);
  EXPECT_EQ(filled.Variances[survey.Index(3, 3)], 0.0);
  EXPECT_TRUE(
    std::all_of(filled.Values.begin(), filled.Values.end(), [](double value) { return std::isfinite(value); }));
}

// Scores go back to what was measured: no value beyond the least and the largest.
TEST(ConditionalField, ScoresGoBack)
{
  KrigingSurvey survey = Survey();
  survey.Data.Values = survey.Measured = { 1.0, 10.0, 1000.0 };
  survey.Mean = 0.0;
  survey.Model.Field.Variance = 1.0;
  TakeScores(survey);
  ConditionalOptions options;
  options.NumberOfLines = 16;
  const Filled filled = Fill(survey, options, survey.Window);
  EXPECT_EQ(*std::min_element(filled.Values.begin(), filled.Values.end()), 1.0);
  EXPECT_EQ(*std::max_element(filled.Values.begin(), filled.Values.end()), 1000.0);
  for (std::size_t n = 0; n < 3; ++n)
  {
    EXPECT_NEAR(filled.Values[IndexOf(survey, n)] / survey.Measured[n], 1.0, 1e-6);
  }
}

TEST(ConditionalField, RefusesAFieldThatIsNone)
{
  KrigingSurvey survey = Survey();
  survey.Grid.Spacing[0] = 0.0;
  EXPECT_THROW(ConditionalField(survey, {}), KrigingFailure);
}

// Two data: each is estimated from the other alone, m + (z - m) exp(-h / a), with the variance C (1 - exp(-2 h / a)).
TEST(CrossValidation, OfTwoData)
{
  KrigingSurvey survey = Survey();
  survey.Data.Places = { { 110.0, -38.0, 0.0 }, { 114.0, -38.0, 0.0 } };
  survey.Data.Values = survey.Measured = { 48.0, 51.0 };
  const CrossValidation validation = CrossValidate(survey);
  const double decay = std::exp(-0.5);
  const double deviation = std::sqrt(4.0 * (1.0 - decay * decay));
  const double errors[] = { 48.0 - (50.0 + decay), 51.0 - (50.0 - 2.0 * decay) };
  for (std::size_t n = 0; n < 2; ++n)
  {
    EXPECT_NEAR(validation.Estimates[n], survey.Measured[n] - errors[n], 1e-6);
    EXPECT_NEAR(validation.Deviations[n], deviation, 1e-6);
    EXPECT_NEAR(validation.StandardizedErrors[n], errors[n] / deviation, 1e-6);
  }
  EXPECT_NEAR(validation.MeanError, 0.5 * (errors[0] + errors[1]), 1e-6);
  EXPECT_NEAR(validation.RootMeanSquareError, std::hypot(errors[0], errors[1]) / std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(validation.MeanSquaredStandardizedError,
    0.5 * (errors[0] * errors[0] + errors[1] * errors[1]) / (deviation * deviation), 1e-6);
}

TEST(KrigingSurvey, GridCoversTheDataAndAMargin)
{
  KrigingSurvey survey = Survey();
  SpanGrid({ 11, 21 }, 7.0, survey);
  EXPECT_NEAR(survey.Grid.Origin[0], 110.0 - 0.05 * 42.0, 1e-12); // the longer side is 42 m
  EXPECT_NEAR(survey.Grid.Origin[1], -38.0 - 0.05 * 42.0, 1e-12);
  EXPECT_NEAR(survey.Grid.Spacing[0], (30.0 + 0.1 * 42.0) / 10.0, 1e-12);
  EXPECT_NEAR(survey.Grid.Spacing[1], (42.0 + 0.1 * 42.0) / 20.0, 1e-12);
  survey.Data.Places.resize(1);
  SpanGrid({ 11, 21 }, 7.0, survey);
  EXPECT_NEAR(survey.Grid.Origin[0], 103.0, 1e-12);
  EXPECT_NEAR(survey.Grid.Spacing[0], 1.4, 1e-12);
  survey.Data.Places.clear();
  EXPECT_THROW(SpanGrid({ 11, 21 }, 7.0, survey), InvalidInput);
}

// A drift that is linear in x and y and their product is what bilinear functions are.
TEST(KrigingSurvey, DriftAtTheData)
{
  KrigingSurvey survey = Survey();
  survey.Data.Places = { { 110.0, -38.0, 0.0 }, { 113.3, -20.9, 0.0 }, { 160.0, 10.0, 0.0 } };
  std::vector<double> drift;
  for (int j = 0; j <= 20; ++j)
  {
    for (int i = 0; i <= 30; ++i)
    {
      drift.push_back(3.0 + 2.0 * i - j + 0.5 * i * j);
    }
  }
  TakeDrift(drift, survey);
  for (const KrigingPlace& place : survey.Data.Places)
  {
    const double i = (place.X - 100.0) / 2.0;
    const double j = (place.Y + 50.0) / 3.0;
    EXPECT_NEAR(place.External, 3.0 + 2.0 * i - j + 0.5 * i * j, 1e-9);
  }
  const auto why = [&] { return WhyRefused([&] { TakeDrift(drift, survey); }); };
  survey.Data.Places[1].X = 161.0;
  EXPECT_EQ(why(), "Datum 1 is outside the Grid, where there is no external drift.");
  drift[40] = NaN;
  EXPECT_EQ(why(), "The drift at point 40 of the Grid is nan; it must be finite.");
}

TEST(KrigingSurvey, NeighborsAndScores)
{
  KrigingSurvey survey = Survey();
  survey.Type = KrigingType::Simple;
  survey.Data.Values = { 1.0, 2.0, 6.0 };
  TakeMean(true, survey);
  EXPECT_DOUBLE_EQ(survey.Mean, 3.0);
  TakeNeighbors(0, survey);
  EXPECT_EQ(survey.Neighbors, 3u);
  TakeNeighbors(2, survey);
  EXPECT_EQ(survey.Neighbors, 2u);
  TakeNeighbors(9, survey);
  EXPECT_EQ(survey.Neighbors, 3u);
  survey.Data.Places.resize(2001);
  TakeNeighbors(0, survey);
  EXPECT_EQ(survey.Neighbors, 50u);
  survey.Data.Values = { 4.0, 4.0 };
  EXPECT_THROW(TakeScores(survey), InvalidInput);
}
