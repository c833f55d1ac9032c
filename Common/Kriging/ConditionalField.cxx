// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Kriging/ConditionalField.h"

#include "Kriging/FieldAtData.h"
#include "Numerics/RandomStream.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace littoral
{

namespace
{

/// Rows of the grid that one thread fills at a time.
constexpr int RowsAtOnce = 16;

/// The turning bands field of the model of a survey. Throws KrigingFailure if there is none.
TurningBandsParameters BandsOf(const KrigingSurvey& survey, const ConditionalOptions& options)
{
  TurningBandsParameters bands;
  bands.Field = survey.Model.Field;
  bands.AnisotropyRatio = survey.Model.AnisotropyRatio;
  bands.AnisotropyAngle = survey.Model.AnisotropyAngle;
  bands.Seed = options.Seed;
  const int lines = options.NumberOfLines;
  bands.NumberOfLines = lines > 0 ? lines : 1;
  const std::string reason = WhyInvalid(bands, survey.Grid);
  if (!reason.empty())
  {
    throw KrigingFailure(reason);
  }
  bands.NumberOfLines = lines > 0 ? lines : EnoughLines(bands, survey.Grid, survey.Window);
  return bands;
}

}

double MemoryOf(const KrigingSurvey& survey, double points, bool hasVariances)
{
  return points * sizeof(double) * (hasVariances ? 2 : 1) +
    Kriging::MemoryFor(survey.Data.Places.size(), survey.Neighbors);
}

double CostOfPoint(const KrigingSurvey& survey, bool hasVariances)
{
  const auto n = static_cast<double>(survey.Data.Places.size());
  const auto k = static_cast<double>(survey.Neighbors);
  const double ofSystem = k * k / 540.0;
  const double ofSums = n / 680.0 + (hasVariances ? n * n / 40000.0 : 0.0);
  return 1.0 + (k < n ? ofSystem : ofSums);
}

ConditionalField::ConditionalField(const KrigingSurvey& survey, const ConditionalOptions& options)
  : Survey(survey)
  , Options(options)
  , SimulatedAtData(survey.Data.Places.size(), 0.0)
{
  if (options.Simulates)
  {
    this->Bands = BandsOf(survey, options);
    this->Simulated.emplace(this->Bands, survey.Grid, survey.Window);
  }
}

void ConditionalField::Tabulate(const ParallelFor& parallel)
{
  if (this->Simulated)
  {
    parallel(this->Simulated->GetNumberOfLines(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t line = begin; line < end; ++line)
      {
        this->Simulated->TabulateLine(line);
      }
    });
  }
}

void ConditionalField::Solve(const ParallelFor& parallel)
{
  const KrigingSurvey& survey = this->Survey;
  KrigingData differences = survey.Data;
  if (this->Simulated)
  {
    this->SimulatedAtData =
      FieldAtData(*this->Simulated, this->Bands, survey.Grid, survey.Window, survey.Data.Places, parallel);
    // What a measurement would have read of the simulated field
    const RandomStream errors(this->Options.Seed, RandomPurpose::DatumErrors);
    for (std::size_t n = 0; n < this->SimulatedAtData.size(); ++n)
    {
      const double noise = survey.Model.Nugget + survey.Data.ErrorVariance(n);
      differences.Values[n] -=
        this->SimulatedAtData[n] + (noise > 0.0 ? std::sqrt(noise) * errors.NormalPair(n, 0)[0] : 0.0);
    }
  }
  for (double& value : differences.Values)
  {
    value -= survey.Mean;
  }
  KrigingOptions options;
  options.Type = survey.Type;
  options.Neighbors = survey.Neighbors;
  options.Low = PlaceOfPoint(survey.Grid, survey.Window.First[0], survey.Window.First[1]);
  options.High = PlaceOfPoint(survey.Grid, survey.Window.Last[0], survey.Window.Last[1]);
  this->Differences = std::make_unique<Kriging>(survey.Model, std::move(differences), options, parallel);
}

void ConditionalField::Fill(
  const GridWindow& part, double* values, double* variances, const ParallelFor& parallel) const
{
  const int width = part.Last[0] - part.First[0] + 1;
  const int height = std::max(0, part.Last[1] - part.First[1] + 1);
  const std::size_t pieces = width > 0 ? (height + RowsAtOnce - 1) / RowsAtOnce : 0;
  parallel(pieces, [&](std::size_t begin, std::size_t end) {
    for (std::size_t piece = begin; piece < end; ++piece)
    {
      const int first = part.First[1] + static_cast<int>(piece) * RowsAtOnce;
      this->FillRows(part, first, std::min(first + RowsAtOnce - 1, part.Last[1]), values, variances);
    }
  });
}

void ConditionalField::FillRows(const GridWindow& part, int first, int last, double* values, double* variances) const
{
  const KrigingSurvey& survey = this->Survey;
  const auto width = static_cast<std::size_t>(part.Last[0] - part.First[0]) + 1;
  const auto fullWidth = static_cast<std::size_t>(survey.Window.Last[0] - survey.Window.First[0]) + 1;
  std::vector<float> simulated;
  if (this->Simulated)
  {
    simulated.resize(fullWidth * (last - first + 1));
    this->Simulated->FillRows(first, last, 1.0, 0.0, simulated.data());
  }
  std::vector<KrigingPlace> places;
  std::vector<std::size_t> ids;
  std::vector<double> offsets;
  for (int j = first; j <= last; ++j)
  {
    for (int i = part.First[0]; i <= part.Last[0]; ++i)
    {
      const std::size_t id = (j - part.First[1]) * width + (i - part.First[0]);
      const std::size_t whole = survey.Index(i, j);
      if (!survey.Raster.empty() && !std::isnan(survey.Raster[whole]))
      {
        values[id] = survey.Raster[whole];
        if (variances)
        {
          variances[id] = 0.0;
        }
        continue;
      }
      places.push_back(PlaceOfPoint(survey.Grid, i, j));
      places.back().External = survey.Drift.empty() ? 0.0 : survey.Drift[whole];
      ids.push_back(id);
      offsets.push_back(this->Simulated ? simulated[(j - first) * fullWidth + (i - survey.Window.First[0])] : 0.0);
    }
  }
  std::vector<double> kriged(places.size());
  std::vector<double> own(variances ? places.size() : 0);
  this->Differences->Estimate(places.data(), places.size(), kriged.data(), variances ? own.data() : nullptr);
  for (std::size_t n = 0; n < ids.size(); ++n)
  {
    values[ids[n]] = survey.BackTransformed(survey.Mean + offsets[n] + kriged[n]);
    if (variances)
    {
      variances[ids[n]] = own[n];
    }
  }
}

std::vector<double> ConditionalField::AtData(const ParallelFor& parallel) const
{
  const KrigingSurvey& survey = this->Survey;
  const std::vector<KrigingPlace>& places = survey.Data.Places;
  std::vector<double> field(places.size());
  parallel(places.size(), [&](std::size_t begin, std::size_t end) {
    this->Differences->Estimate(&places[begin], end - begin, &field[begin]);
    for (std::size_t n = begin; n < end; ++n)
    {
      field[n] = survey.BackTransformed(survey.Mean + this->SimulatedAtData[n] + field[n]);
    }
  });
  return field;
}

}
