// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Kriging/DriftFunctions.h"

#include <algorithm>

namespace littoral
{

std::size_t NumberOfDriftFunctions(KrigingType type)
{
  constexpr std::size_t counts[NumberOfKrigingTypes] = { 0, 1, 3, 6, 2 };
  return counts[static_cast<int>(type)];
}

DriftFunctions::DriftFunctions(
  KrigingType type, const std::vector<KrigingPlace>& places, const std::size_t* indices, std::size_t count)
  : Type(type)
  , Count(NumberOfDriftFunctions(type))
{
  const auto place = [&](std::size_t n) { return places[indices ? indices[n] : n]; };
  const auto scale = [&](double KrigingPlace::*coordinate) {
    double low = place(0).*coordinate;
    double high = low;
    for (std::size_t n = 1; n < count; ++n)
    {
      low = std::min(low, place(n).*coordinate);
      high = std::max(high, place(n).*coordinate);
    }
    this->Center.*coordinate = 0.5 * low + 0.5 * high;
    this->Half.*coordinate = high > low ? 0.5 * high - 0.5 * low : 1.0;
  };
  scale(&KrigingPlace::X);
  scale(&KrigingPlace::Y);
  scale(&KrigingPlace::External);
}

DriftFunctions::Values DriftFunctions::At(const KrigingPlace& place) const
{
  const double x = (place.X - this->Center.X) / this->Half.X;
  const double y = (place.Y - this->Center.Y) / this->Half.Y;
  switch (this->Type)
  {
    case KrigingType::Ordinary:
      return { 1.0 };
    case KrigingType::LinearDrift:
      return { 1.0, x, y };
    case KrigingType::QuadraticDrift:
      return { 1.0, x, y, x * x, x * y, y * y };
    case KrigingType::ExternalDrift:
      return { 1.0, (place.External - this->Center.External) / this->Half.External };
    default:
      return {};
  }
}

}
