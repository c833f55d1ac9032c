// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/SeaStateTable.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/Tables.h"
#include "Numerics/Constants.h"
#include "Numerics/InvalidInput.h"
#include "Sea/MeasuredSpectrum.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace littoral
{

namespace
{
/// Points that a spectrum needs to be drawn as a smooth curve.
constexpr std::size_t SmoothCurve = 256;
}

void WriteSeaState(const SeaState& state, vtkTable* table)
{
  const auto column = [&](const char* name, double WaveTrain::*member) {
    AddColumn(table, name, state.Trains, [member](const WaveTrain& train) { return train.*member; });
  };
  column(sea::Amplitude, &WaveTrain::Amplitude);
  column(sea::AngularFrequency, &WaveTrain::AngularFrequency);
  column(sea::WaveNumber, &WaveTrain::WaveNumber);
  column(sea::Direction, &WaveTrain::Direction);
  column(sea::Phase, &WaveTrain::Phase);
  AddField(table, sea::WaterDepth, { state.Depth });
  AddField(table, sea::SeaLevel, { state.SeaLevel });
  AddField(table, sea::Period, { state.Period });
  if (state.Order != SeaOrder::First)
  {
    AddField(table, sea::Order, { static_cast<double>(state.Order) });
  }
}

void WriteSpectrum(const SeaSpectrum& spectrum, const TrainParameters& parameters, vtkTable* table)
{
  const std::vector<double> edges = BinEdges(spectrum, parameters);
  const auto field = [table](const char* name) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    table->GetFieldData()->AddArray(array);
    return array.Get();
  };
  if (edges.empty())
  {
    return; // all energy in one wave
  }
  vtkDoubleArray* frequencies = field(sea::BinEdges);
  vtkDoubleArray* densities = field(sea::SpectralDensity);
  // S(f) = 2 pi S(w)
  const auto densityAt = [&](double frequency) { return TwoPi * spectrum.Density(frequency); };
  const std::size_t bins = edges.size() - 1;
  const std::size_t steps = (SmoothCurve + bins - 1) / bins;
  for (std::size_t bin = 0; bin < bins; ++bin)
  {
    frequencies->InsertNextValue(edges[bin] / TwoPi);
    for (std::size_t step = 0; step < steps; ++step)
    {
      densities->InsertNextValue(
        densityAt(edges[bin] + (edges[bin + 1] - edges[bin]) * static_cast<double>(step) / static_cast<double>(steps)));
    }
  }
  frequencies->InsertNextValue(edges.back() / TwoPi);
  densities->InsertNextValue(densityAt(edges.back()));
}

void WritePeriods(const SeaPeriods& periods, vtkTable* table)
{
  AddField(table, sea::EnergyPeriod, { periods.Energy });
  AddField(table, sea::MeanPeriod, { periods.Mean });
  AddField(table, sea::ZeroCrossingPeriod, { periods.ZeroCrossing });
}

void WriteDirection(const MeanVector& mean, vtkTable* table)
{
  AddField(table, sea::MeanDirection, { mean.Direction * 180.0 / Pi });
  AddField(table, sea::DirectionalSpread, { CircularSpread(mean.Length) * 180.0 / Pi });
}

SampledSpectrum ReadSpectrum(vtkTable* table)
{
  SampledSpectrum spectrum;
  const ArrayReader fields = ArrayReader::OfFields(table, "the sea state");
  const auto read = [&fields](const char* name, std::vector<double>& values) {
    auto* array = fields.Find<vtkDoubleArray>(name, 1);
    fields.NeedFinite(array);
    values = array ? ListOf(array) : std::vector<double>();
  };
  read(sea::BinEdges, spectrum.Edges);
  read(sea::SpectralDensity, spectrum.Densities);
  const std::size_t edges = spectrum.Edges.size();
  const std::size_t densities = spectrum.Densities.size();
  if (edges < 2 || densities < edges || (densities - 1) % (edges - 1) != 0 ||
    std::adjacent_find(spectrum.Edges.begin(), spectrum.Edges.end(), std::greater_equal<>()) != spectrum.Edges.end())
  {
    Refuse("the sea state has no field data BinEdges and SpectralDensity; it must be that of a Sea State with a "
           "spectrum, not of a Regular wave.");
  }
  return spectrum;
}

SeaState ReadSeaState(vtkTable* table)
{
  Require(table->GetNumberOfRows() == 0 ? "the sea state has no wave trains." : "");
  SeaState state;
  SetSize(state.Trains, table->GetNumberOfRows());
  const struct
  {
    const char* Name;
    double WaveTrain::*Member;
  } columns[] = { { sea::Amplitude, &WaveTrain::Amplitude }, { sea::AngularFrequency, &WaveTrain::AngularFrequency },
    { sea::WaveNumber, &WaveTrain::WaveNumber }, { sea::Direction, &WaveTrain::Direction },
    { sea::Phase, &WaveTrain::Phase } };
  const ArrayReader rows = ArrayReader::OfRows(table, "the sea state");
  for (const auto& column : columns)
  {
    vtkDataArray* array = rows.Need(column.Name, 1);
    for (std::size_t row = 0; row < state.Trains.size(); ++row)
    {
      state.Trains[row].*column.Member = array->GetComponent(static_cast<vtkIdType>(row), 0);
    }
  }
  const ArrayReader fields = ArrayReader::OfFields(table, "the sea state", 1);
  const auto field = [&fields](const char* name, double& value) {
    vtkDataArray* array = fields.Find(name, 1);
    value = array ? array->GetComponent(0, 0) : value;
  };
  field(sea::WaterDepth, state.Depth);
  field(sea::SeaLevel, state.SeaLevel);
  field(sea::Period, state.Period);
  double order = static_cast<double>(state.Order);
  field(sea::Order, order);
  Require(order == 1.0 || order == 2.0 ? "" : "Order of the sea state must be 1 or 2.");
  state.Order = static_cast<SeaOrder>(static_cast<int>(order));
  Require(WhyInvalid(state));
  return state;
}

}
