// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/ForestFiles.h"

#include "Numerics/LittleEndian.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <limits>

namespace littoral
{

namespace
{

constexpr std::size_t MostBytes = std::numeric_limits<std::int32_t>::max(); ///< of a record
constexpr std::size_t BytesAtOnce = 1 << 20;

/// Appends a record of numbers.
template <typename Number>
void AppendRecord(std::initializer_list<Number> numbers, std::string& bytes)
{
  const auto length = static_cast<std::int32_t>(numbers.size() * sizeof(Number));
  AppendLittleEndian(length, bytes);
  for (const Number number : numbers)
  {
    AppendLittleEndian(number, bytes);
  }
  AppendLittleEndian(length, bytes);
}

/// Hands over what has come together.
void Flush(std::string& bytes, const TakeBytes& take)
{
  take(bytes);
  bytes.clear();
}

/// Digits that a number needs to be read back the same.
std::string Shortest(double number)
{
  char text[32];
  for (int digits = 6; digits <= 17; ++digits)
  {
    std::snprintf(text, sizeof text, "%.*g", digits, number);
    if (std::strtod(text, nullptr) == number)
    {
      break;
    }
  }
  return text;
}

}

void WriteFdsDensity(const CanopyGrid& grid, const DensityOfCell& density, const TakeBytes& take)
{
  const std::size_t cells = grid.NumberOfCells();
  std::int32_t filled = 0;
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    filled += density(cell) > 0.0 ? 1 : 0;
  }
  const Vector3& low = grid.Origin;
  const Vector3 high = low + grid.Spacing * Vector3(grid.Count[0], grid.Count[1], grid.Count[2]);
  std::string bytes;
  AppendRecord({ low.x, high.x, low.y, high.y, low.z, high.z }, bytes);
  AppendRecord({ grid.Spacing.x, grid.Spacing.y, grid.Spacing.z }, bytes);
  AppendRecord({ filled }, bytes);
  std::size_t cell = 0;
  for (int k = 0; k < grid.Count[2]; ++k)
  {
    for (int j = 0; j < grid.Count[1]; ++j)
    {
      for (int i = 0; i < grid.Count[0]; ++i, ++cell)
      {
        const double own = density(cell);
        if (own > 0.0)
        {
          const Vector3 middle = low + grid.Spacing * (Vector3(i, j, k) + 0.5);
          AppendRecord({ middle.x, middle.y, middle.z }, bytes);
          AppendRecord({ own }, bytes);
        }
      }
    }
    Flush(bytes, take);
  }
}

void WriteQuicFireDensity(const CanopyGrid& grid, const DensityOfCell& density, const TakeBytes& take)
{
  const std::size_t cells = grid.NumberOfCells();
  const auto length = static_cast<std::int32_t>(cells * sizeof(float));
  std::string bytes;
  AppendLittleEndian(length, bytes);
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    AppendLittleEndian(static_cast<float>(density(cell)), bytes);
    if (bytes.size() >= BytesAtOnce)
    {
      Flush(bytes, take);
    }
  }
  AppendLittleEndian(length, bytes);
  Flush(bytes, take);
}

std::string WhyNoFds(std::size_t cells)
{
  const bool fits = cells <= MostBytes;
  return fits ? "" : "a .bdf holds at most 2147483647 cells with a density; take a larger CellSize";
}

std::string WhyNoQuicFire(const CanopyGrid& grid)
{
  const bool fits = grid.NumberOfCells() <= MostBytes / sizeof(float);
  return fits ? "" : "a .dat holds at most 536870911 cells; take a larger CellSize";
}

std::string TextOfRow(const ForestRow& row, double dragCoefficient)
{
  std::string text = "2";
  for (const double number :
    { row.X, row.Y, row.Height, row.Diameter, dragCoefficient, row.LeafAreaIndex, row.MaximumHeight })
  {
    text += " " + Shortest(number);
  }
  return text + "\n";
}

}
