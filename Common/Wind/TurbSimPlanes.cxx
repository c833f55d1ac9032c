// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Wind/TurbSimPlanes.h"

#include "Numerics/InvalidInput.h"
#include "Numerics/LittleEndian.h"
#include "Numerics/ParameterCheck.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr int AnyWind = 7;
constexpr int PeriodicWind = 8;
constexpr std::size_t FixedBytes = 70;
constexpr std::size_t LongestDescription = 200;
constexpr int Components = 3;

/// Takes the numbers of a header one after the other.
struct HeaderReader
{
  const char* From;

  template <typename Number>
  Number Take()
  {
    const auto number = TakeLittleEndian<Number>(this->From);
    this->From += sizeof number;
    return number;
  }
};

int RequireId(std::string_view bytes)
{
  const auto id = TakeLittleEndian<std::int16_t>(bytes.data());
  const char turned[2] = { bytes[1], bytes[0] };
  const auto other = TakeLittleEndian<std::int16_t>(turned);
  if (id != AnyWind && id != PeriodicWind)
  {
    Require(other == AnyWind || other == PeriodicWind ? "its bytes are in big-endian order; TurbSim's are little-endian"
                                                      : "");
    Refuse("it is no .bts file: it begins with ", id, ", not with 7 or 8");
  }
  return id;
}

}

Quantiser Quantiser::Of(double low, double high)
{
  if (low == high)
  {
    return { 1.0f, -static_cast<float>(low) }; // exactly
  }
  const double range = std::max(high - low, MinimumMagnitude); // so that the slope is finite
  Quantiser quantiser;
  quantiser.Slope = static_cast<float>(65534.0 / range * (1.0 - 1e-7));
  // the middle of the range lies at the middle of the integers, -1/2
  quantiser.Offset = static_cast<float>(-0.5 - 0.5 * (low + high) * quantiser.Slope);
  return quantiser;
}

std::int16_t Quantiser::Stored(float value) const
{
  const double stored = std::nearbyint(static_cast<double>(value) * this->Slope + this->Offset);
  return static_cast<std::int16_t>(std::clamp(stored, -32768.0, 32767.0));
}

float Quantiser::Value(std::int16_t stored) const
{
  return static_cast<float>((stored - static_cast<double>(this->Offset)) / this->Slope);
}

TurbSimPlanes::TurbSimPlanes(const InflowGrid& grid, const InflowRange& range)
{
  this->Grid = grid;
  this->Grid.Description.resize(std::min(grid.Description.size(), LongestDescription));
  this->HeaderSize = FixedBytes + this->Grid.Description.size();
  for (int component = 0; component < Components; ++component)
  {
    this->Quantisers[component] = Quantiser::Of(range.Low[component], range.High[component]);
  }
}

TurbSimPlanes::TurbSimPlanes(std::string_view bytes, double size)
{
  if (bytes.size() < FixedBytes)
  {
    Refuse("it is cut off: of a header of ", FixedBytes, " bytes it has ", bytes.size());
  }
  const int id = RequireId(bytes);
  HeaderReader reader{ bytes.data() + sizeof(std::int16_t) };
  InflowGrid& grid = this->Grid;
  grid.IsPeriodic = id == PeriodicWind;
  grid.Count[2] = reader.Take<std::int32_t>();
  grid.Count[1] = reader.Take<std::int32_t>();
  grid.TowerPoints = reader.Take<std::int32_t>();
  grid.Count[0] = reader.Take<std::int32_t>();
  for (double* number :
    { &grid.VerticalSpacing, &grid.LateralSpacing, &grid.TimeStep, &grid.Speed, &grid.HubHeight, &grid.BottomHeight })
  {
    *number = reader.Take<float>();
  }
  Require(WhyInvalid(grid));
  for (Quantiser& quantiser : this->Quantisers)
  {
    quantiser.Slope = reader.Take<float>();
    quantiser.Offset = reader.Take<float>();
    const bool isGood = std::isfinite(quantiser.Slope) && quantiser.Slope != 0.0f && std::isfinite(quantiser.Offset);
    Require(isGood ? "" : "a slope in its header is 0, or a slope or offset is not finite");
  }
  const auto length = reader.Take<std::int32_t>();
  Require(length >= 0 ? "" : "the length of its description is negative");
  this->HeaderSize = FixedBytes + static_cast<std::size_t>(length);
  grid.Description = std::string(bytes.substr(FixedBytes, static_cast<std::size_t>(length)));
  Require(WhyOtherSize(*this, size));
}

std::string TurbSimPlanes::Header() const
{
  const InflowGrid& grid = this->Grid;
  std::string bytes;
  AppendLittleEndian(static_cast<std::int16_t>(grid.IsPeriodic ? PeriodicWind : AnyWind), bytes);
  for (const int count : { grid.Count[2], grid.Count[1], grid.TowerPoints, grid.Count[0] })
  {
    AppendLittleEndian(static_cast<std::int32_t>(count), bytes);
  }
  for (const double number :
    { grid.VerticalSpacing, grid.LateralSpacing, grid.TimeStep, grid.Speed, grid.HubHeight, grid.BottomHeight })
  {
    AppendLittleEndian(static_cast<float>(number), bytes);
  }
  for (const Quantiser& quantiser : this->Quantisers)
  {
    AppendLittleEndian(quantiser.Slope, bytes);
    AppendLittleEndian(quantiser.Offset, bytes);
  }
  AppendLittleEndian(static_cast<std::int32_t>(grid.Description.size()), bytes);
  return bytes + grid.Description;
}

std::size_t TurbSimPlanes::BytesOfPlane() const
{
  return this->Grid.PointsOfPlane() * Components * sizeof(std::int16_t);
}

void TurbSimPlanes::Decode(const char* const* bytes, float* velocities) const
{
  const std::size_t values = this->Grid.PointsOfPlane() * Components;
  for (std::size_t n = 0; n < values; ++n)
  {
    velocities[n] = this->Quantisers[n % Components].Value(TakeLittleEndian<std::int16_t>(bytes[0] + 2 * n));
  }
}

void TurbSimPlanes::Encode(const float* velocities, char* const* bytes) const
{
  const std::size_t values = this->Grid.PointsOfPlane() * Components;
  for (std::size_t n = 0; n < values; ++n)
  {
    PutLittleEndian(this->Quantisers[n % Components].Stored(velocities[n]), bytes[0] + 2 * n);
  }
}

}
