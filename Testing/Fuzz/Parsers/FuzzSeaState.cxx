// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Tables of wave trains, with the spectrum in their field data.

#include "Data/SeaStateTable.h"
#include "Expect.h"
#include "RandomData.h"

#include <cmath>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  using namespace littoral;
  RandomData data(bytes, size);
  vtkNew<vtkTable> table;
  data.Fill(table->GetRowData(), { sea::Amplitude, sea::AngularFrequency, sea::WaveNumber, sea::Direction, sea::Phase },
    { 1, 1, 1, 1, 1 }, data.Count());
  data.Fill(table->GetFieldData(), { sea::WaterDepth, sea::SeaLevel, sea::Period }, { 1, 1, 1 }, 1);
  data.Fill(table->GetFieldData(), { sea::BinEdges }, { 1 }, data.Count());
  data.Fill(table->GetFieldData(), { sea::SpectralDensity }, { 1 }, data.Count());

  SeaState state;
  const bool isSea = ReadsOrRefuses([&] { state = ReadSeaState(table); });
  Expect(!isSea || std::isfinite(EnergyOf(state.Trains)), "The energy is not finite.");

  SampledSpectrum spectrum;
  const bool isSpectrum = ReadsOrRefuses([&] { spectrum = ReadSpectrum(table); });
  Expect(!isSpectrum || spectrum.Densities.size() >= spectrum.Edges.size(), "A bin has no density.");
  return 0;
}
