// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Wind/BladedPlanes.h"

#include "Numerics/InvalidInput.h"
#include "Numerics/LittleEndian.h"
#include "Numerics/ParameterCheck.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <vector>

namespace littoral
{

namespace
{

constexpr int Components = 3;
constexpr int Format = -99;
constexpr int WithIntensities = 4;
constexpr double Unit = 1e-5; // of an integer, in speed times intensity [%]
constexpr const char* Names[Components] = { "u", "v", "w" };

std::string Upper(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

/// The number at the beginning of a text.
double NumberIn(const std::string& text, const std::string& name)
{
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  Require(end != text.c_str() && IsSensible(number) ? "" : "its .sum has no number for " + name);
  return number;
}

double NumberAfterSign(const std::string& line, const std::string& name)
{
  return NumberIn(line.substr(line.find('=') + 1), name);
}

bool IsYes(const std::string& line)
{
  const std::size_t first = line.find_first_not_of(" \t.");
  const char letter = first == std::string::npos ? ' ' : line[first];
  Require(letter == 'T' || letter == 'Y' || letter == 'F' || letter == 'N'
      ? ""
      : "its .sum does not say with T or F whether points are CLOCKWISE");
  return letter == 'T' || letter == 'Y';
}

void RequireAgreement(const char* name, double summary, double file, double within)
{
  if (!(std::abs(summary - file) <= within))
  {
    Refuse("its .sum contradicts it: ", name, " is ", summary, " there and ", file, " in the file");
  }
}

}

BladedSummary ReadBladedSummary(const std::string& text)
{
  BladedSummary summary;
  std::istringstream stream(Upper(text));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);)
  {
    lines.push_back(line);
  }
  auto at = lines.cbegin();
  // words in this order, as other readers look for them
  const auto seek = [&](const std::string& word, const std::string& other) {
    const auto found = std::find_if(at, lines.cend(), [&](const std::string& line) {
      return line.find(word) != std::string::npos || line.find(other) != std::string::npos;
    });
    return found;
  };
  const auto need = [&](const std::string& word, const std::string& other) {
    const auto found = seek(word, other);
    Require(found != lines.cend() ? "" : "its .sum has no line " + word);
    at = std::next(found);
    return *found;
  };
  summary.IsClockwise = IsYes(need("CLOCKWISE", "CLOCKWISE"));
  summary.HubHeight = NumberIn(need("HUB HEIGHT", "ZHUB"), "HUB HEIGHT");
  summary.Speed = NumberAfterSign(need("UBAR", "UBAR"), "UBAR");
  for (int component = 0; component < Components; ++component)
  {
    Require(at != lines.cend() ? "" : "its .sum ends before all intensities");
    summary.Intensity[component] = NumberAfterSign(*at++, std::string("TI(") + Names[component] + ")");
  }
  const auto offset = seek("HEIGHT OFFSET", "HEIGHT OFFSET");
  summary.HeightOffset = offset == lines.cend() ? 0.0 : NumberAfterSign(*offset, "HEIGHT OFFSET");
  summary.IsPeriodic = seek("PERIODIC", "PERIODIC") != lines.cend();
  return summary;
}

BladedPlanes::BladedPlanes(const InflowGrid& grid, const InflowRange& range)
{
  this->Grid = grid;
  Require(grid.TowerPoints == 0 ? "" : "its format has no points of a tower; set TowerLayers to 0");
  Require(grid.Count[0] % 2 == 0 ? "" : "its format holds an even number of times");
  for (int component = 0; component < Components; ++component)
  {
    const double mean = component == 0 ? grid.Speed : 0.0;
    const double deviation = range.DeviationFrom(mean, component);
    // as a float, which the file holds
    this->Intensity[component] = static_cast<float>(100.0 * deviation / grid.Speed);
    const double farthest = std::max(range.High[component] - mean, mean - range.Low[component]);
    Require(farthest <= 32767.0 * this->ScaleOf(component) * (1.0 + 1e-6) ? ""
                                                                          : std::string("a value of ") +
          Names[component] + " lies more than 32.767 deviations from the mean, beyond its integers");
  }
}

BladedPlanes::BladedPlanes(std::string_view bytes, double size, const BladedSummary& summary)
  : IsClockwise(summary.IsClockwise)
  , Intensity(summary.Intensity)
{
  if (bytes.size() < BytesToRead)
  {
    Refuse("it is cut off: of a header of ", BytesToRead, " bytes it has ", bytes.size());
  }
  const auto whole = [&](std::size_t at) { return TakeLittleEndian<std::int32_t>(bytes.data() + at); };
  const auto number = [&](std::size_t at) { return static_cast<double>(TakeLittleEndian<float>(bytes.data() + at)); };
  const int format = TakeLittleEndian<std::int16_t>(bytes.data());
  const int kind = TakeLittleEndian<std::int16_t>(bytes.data() + 2);
  Require(format == Format && kind == WithIntensities && whole(4) == Components
      ? ""
      : "it is no full-field file with three components and intensities: it does not begin with -99, 4, 3");
  InflowGrid& grid = this->Grid;
  grid.VerticalSpacing = number(32);
  grid.LateralSpacing = number(36);
  Require(std::abs(whole(44)) < 1 << 30 ? "" : "the number of its times is no such number");
  grid.Count = { 2 * whole(44), whole(76), whole(72) };
  grid.Speed = number(48);
  grid.TimeStep = number(40) / grid.Speed;
  grid.HubHeight = summary.HubHeight;
  grid.BottomHeight = summary.HubHeight - summary.HeightOffset - 0.5 * (grid.Count[2] - 1) * grid.VerticalSpacing;
  grid.IsPeriodic = summary.IsPeriodic;
  Require(WhyInvalid(grid));
  Require(WhyOtherSize(*this, size));
  RequireAgreement("the speed", summary.Speed, grid.Speed, 0.01 * grid.Speed);
  RequireAgreement("the height of the middle", summary.HubHeight - summary.HeightOffset, number(16), 0.1);
  for (int component = 0; component < Components; ++component)
  {
    const double told = number(20 + sizeof(float) * component);
    RequireAgreement("an intensity", summary.Intensity[component], told, 0.015 * std::abs(told) + 1e-3);
  }
}

double BladedPlanes::Middle() const
{
  return this->Grid.BottomHeight + 0.5 * (this->Grid.Count[2] - 1) * this->Grid.VerticalSpacing;
}

double BladedPlanes::ScaleOf(int component) const
{
  return Unit * this->Grid.Speed * this->Intensity[component];
}

std::string BladedPlanes::Header() const
{
  const InflowGrid& grid = this->Grid;
  std::string bytes;
  const auto wholes = [&](std::initializer_list<int> numbers) {
    for (const int number : numbers)
    {
      AppendLittleEndian(static_cast<std::int32_t>(number), bytes);
    }
  };
  const auto floats = [&](std::initializer_list<double> numbers) {
    for (const double number : numbers)
    {
      AppendLittleEndian(static_cast<float>(number), bytes);
    }
  };
  AppendLittleEndian(static_cast<std::int16_t>(Format), bytes);
  AppendLittleEndian(static_cast<std::int16_t>(WithIntensities), bytes);
  wholes({ Components });
  floats({ 0.0, 0.0, this->Middle(), this->Intensity[0], this->Intensity[1], this->Intensity[2] });
  floats({ grid.VerticalSpacing, grid.LateralSpacing, grid.Speed * grid.TimeStep });
  wholes({ grid.Count[0] / 2 });
  floats({ grid.Speed, 0.0, 0.0, 0.0 });
  wholes({ 0, 0, grid.Count[2], grid.Count[1], 0, 0, 0, 0, 0, 0 });
  return bytes;
}

std::string BladedPlanes::Summary() const
{
  const InflowGrid& grid = this->Grid;
  std::ostringstream text;
  text.precision(9);
  text << grid.Description << "\n\n"
       << "T   CLOCKWISE rotation when looking downwind\n"
       << grid.HubHeight << "   HUB HEIGHT [m]\n\n"
       << "UBAR = " << grid.Speed << " m/s\n"
       << "TI(u) = " << this->Intensity[0] << " %\n"
       << "TI(v) = " << this->Intensity[1] << " %\n"
       << "TI(w) = " << this->Intensity[2] << " %\n\n"
       << "HEIGHT OFFSET = " << grid.HubHeight - this->Middle() << " m\n"
       << (grid.IsPeriodic ? "PERIODIC\n" : "");
  return text.str();
}

std::size_t BladedPlanes::BytesOfPlane() const
{
  return this->Grid.PointsOfGrid() * Components * sizeof(std::int16_t);
}

template <typename Use>
void BladedPlanes::ForValues(const Use& use) const
{
  const auto across = static_cast<std::size_t>(this->Grid.Count[1]);
  const std::size_t points = this->Grid.PointsOfGrid();
  for (std::size_t point = 0; point < points; ++point)
  {
    const std::size_t j = point % across;
    const std::size_t place = point - j + (this->IsClockwise ? across - 1 - j : j);
    for (int component = 0; component < Components; ++component)
    {
      use(Components * point + component, sizeof(std::int16_t) * (Components * place + component), component);
    }
  }
}

void BladedPlanes::Decode(const char* const* bytes, float* velocities) const
{
  this->ForValues([&](std::size_t value, std::size_t place, int component) {
    const double stored = TakeLittleEndian<std::int16_t>(bytes[0] + place);
    // u = U + 1e-5 U TI stored
    velocities[value] =
      static_cast<float>((component == 0 ? this->Grid.Speed : 0.0) + this->ScaleOf(component) * stored);
  });
}

void BladedPlanes::Encode(const float* velocities, char* const* bytes) const
{
  this->ForValues([&](std::size_t value, std::size_t place, int component) {
    const double part = velocities[value] - (component == 0 ? this->Grid.Speed : 0.0);
    const double scale = this->ScaleOf(component);
    const double stored = scale > 0.0 ? std::nearbyint(part / scale) : 0.0;
    PutLittleEndian(static_cast<std::int16_t>(std::clamp(stored, -32768.0, 32767.0)), bytes[0] + place);
  });
}

}
