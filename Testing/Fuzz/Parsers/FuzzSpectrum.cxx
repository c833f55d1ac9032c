// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Measured spectra, and those of few numbers; the sea that follows from them.

#include "Expect.h"
#include "RandomData.h"
#include "Sea/SeaSpectrum.h"
#include "Sea/WaveTrains.h"

#include <cmath>

namespace
{

std::vector<double> Numbers(RandomData& data, vtkIdType count, bool isRising)
{
  std::vector<double> numbers;
  double last = 0.0;
  for (vtkIdType n = 0; n < count; ++n)
  {
    const double number = data.Number();
    last = isRising && data.ConsumeIntegralInRange(0, 15) != 0 ? last + 0.01 + 0.02 * std::abs(number) : number;
    numbers.push_back(last);
  }
  return numbers;
}

}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  using namespace littoral;
  RandomData data(bytes, size);
  SpectrumParameters parameters;
  parameters.Kind = static_cast<SpectrumKind>(data.ConsumeIntegralInRange(0, 4));
  parameters.FromWind = data.ConsumeBool();
  parameters.WindSpeed = data.Number();
  parameters.SignificantHeight = data.Number();
  parameters.PeakPeriod = data.Number();
  parameters.PeakEnhancement = data.Number();
  parameters.Depth = data.ConsumeBool() ? data.Number() : parameters.Depth;
  const vtkIdType count = data.Count() + data.ConsumeIntegralInRange(0, 9);
  parameters.Frequencies = Numbers(data, count, true);
  parameters.Densities = Numbers(data, data.ConsumeIntegralInRange(0, 15) != 0 ? count : data.Count(), false);
  TrainParameters cut;
  cut.Count = data.ConsumeIntegralInRange(1, 12);
  cut.Lowest = data.ConsumeBool() ? data.Number() : 0.0;
  cut.Highest = data.ConsumeBool() ? data.Number() : 0.0;
  cut.Spreading = data.Number();
  cut.EqualSpacing = data.ConsumeBool();
  if (!ReadsOrRefuses([&] {
        Require(WhyInvalid(parameters));
        Require(WhyInvalid(cut));
        if (!(parameters.Depth > 0.0))
        {
          Refuse("WaterDepth must be positive.");
        }
      }))
  {
    return 0;
  }
  const SeaSpectrum spectrum(parameters);
  Expect(std::isfinite(spectrum.TotalEnergy()) && spectrum.TotalEnergy() >= 0.0, "The energy is none.");
  const auto [low, high] = spectrum.Range();
  Expect(low >= 0.0 && high >= low && std::isfinite(high), "The range is none.");
  const double within = spectrum.Energy(low, high);
  Expect(within >= 0.0 && within <= spectrum.TotalEnergy() * (1.0 + 1e-9), "A part has more energy than the whole.");
  ReadsOrRefuses([&] { Require(WhyBroken(spectrum, parameters.Depth)); });
  const double energy = EnergyOf(TrainsOf(spectrum, parameters.Depth, cut));
  Expect(energy >= 0.0 && energy <= spectrum.TotalEnergy() * (1.0 + 1e-9), "Trains have more energy than the sea.");
  return 0;
}
