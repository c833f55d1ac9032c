// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Light/SkyTables.h"

#include "Geometry/OctahedronMap.h"
#include "Numerics/Constants.h"
#include "Numerics/SimdClones.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr int HalfRows = SkyTables::DomeRows / 2;

/// Elevation of a row of the dome [rad].
double ElevationOf(int row)
{
  // Row h - 1 is just below the horizon, row h just above it.
  const bool isAbove = row >= HalfRows;
  const double t = isAbove ? (row - HalfRows) / (HalfRows - 1.0) : (HalfRows - 1.0 - row) / (HalfRows - 1.0);
  return (isAbove ? 1.0 : -1.0) * std::max(t * t * 0.5 * Pi, 1e-4);
}

/// Place of an elevation among the rows, 0 to 1.
double RowAt(double elevation)
{
  const double t = (HalfRows - 1.0) * std::sqrt(std::min(std::abs(elevation) / (0.5 * Pi), 1.0));
  return (elevation >= 0.0 ? HalfRows + t : HalfRows - 1.0 - t) / (SkyTables::DomeRows - 1.0);
}

/// A part of the sphere of directions.
struct Sample
{
  Vector3 Direction;
  Vector3 Light; ///< luminance times solid angle
};

/// The dome in parts of about one size.
std::vector<Sample> SamplesOf(const SkyTables& sky)
{
  constexpr int rows = 90;
  constexpr int columns = 120;
  std::vector<Sample> samples;
  samples.reserve(static_cast<std::size_t>(rows) * columns);
  for (int row = 0; row < rows; ++row)
  {
    const double z = -1.0 + (2.0 * row + 1.0) / rows;
    const double across = std::sqrt(1.0 - z * z);
    for (int column = 0; column < columns; ++column)
    {
      const double around = TwoPi * (column + 0.5) / columns;
      const Vector3 direction{ across * std::cos(around), across * std::sin(around), z };
      samples.push_back({ direction, 4.0 * Pi / (rows * columns) * sky.LuminanceAt(direction) });
    }
  }
  return samples;
}

/// Planes by the components of their normals, and the light that each receives.
struct Planes
{
  static constexpr int Count = SkyTables::LightSize;
  double Normal[3][Count];
  double Light[3][Count]{};
};

/// E = integral of L cos, of many planes side by side as vectors of the processor
LITTORAL_SIMD_CLONES
void AddLight(const std::vector<Sample>& samples, Planes& planes)
{
  for (const Sample& sample : samples)
  {
    for (int n = 0; n < Planes::Count; ++n)
    {
      const double cosine = planes.Normal[0][n] * sample.Direction.x + planes.Normal[1][n] * sample.Direction.y +
        planes.Normal[2][n] * sample.Direction.z;
      const double part = cosine > 0.0 ? cosine : 0.0;
      planes.Light[0][n] += part * sample.Light.x;
      planes.Light[1][n] += part * sample.Light.y;
      planes.Light[2][n] += part * sample.Light.z;
    }
  }
}

}

Vector3 ColorTable::Between(double x, double y) const
{
  const double u = std::clamp(x, 0.0, 1.0) * (this->Columns - 1);
  const double v = std::clamp(y, 0.0, 1.0) * (this->Rows - 1);
  const int i = std::min(static_cast<int>(u), this->Columns - 2);
  const int j = std::min(static_cast<int>(v), this->Rows - 2);
  const Vector3* at = this->Colors.data() + static_cast<std::size_t>(j) * this->Columns + i;
  return (1.0 - (v - j)) * ((1.0 - (u - i)) * at[0] + (u - i) * at[1]) +
    (v - j) * ((1.0 - (u - i)) * at[this->Columns] + (u - i) * at[this->Columns + 1]);
}

Vector3 SkyTables::LuminanceAt(const Vector3& direction) const
{
  const double from = std::atan2(this->Sun.y, this->Sun.x);
  const double angle = std::abs(std::remainder(std::atan2(direction.y, direction.x) - from, TwoPi));
  return this->Dome.Between(std::sqrt(angle / Pi), RowAt(std::asin(std::clamp(direction.z, -1.0, 1.0))));
}

Vector3 SkyTables::LightOn(const Vector3& normal) const
{
  const glm::dvec2 place = OctahedronPlace(normal);
  return this->Light.Between(0.5 + 0.5 * place.x, 0.5 + 0.5 * place.y);
}

SkyTables TabulateSky(const Atmosphere& air, const Vector3& sun, const ParallelFor& parallel)
{
  return TabulateSky([&](const std::vector<Vector3>& directions) { return air.SkyLuminances(directions, sun); }, sun,
    air.SunLight(sun), parallel);
}

SkyTables TabulateSky(
  const SkyRow& luminances, const Vector3& sun, const Vector3& sunLight, const ParallelFor& parallel)
{
  SkyTables sky;
  sky.Sun = glm::normalize(sun);
  sky.SunLight = sunLight;
  const double from = std::atan2(sky.Sun.y, sky.Sun.x);
  sky.Dome = { SkyTables::DomeColumns, SkyTables::DomeRows, {} };
  sky.Dome.Colors.resize(static_cast<std::size_t>(SkyTables::DomeColumns) * SkyTables::DomeRows);
  parallel(SkyTables::DomeRows, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
    {
      const double up = ElevationOf(static_cast<int>(row));
      std::vector<Vector3> directions;
      for (int column = 0; column < SkyTables::DomeColumns; ++column)
      {
        const double part = column / (SkyTables::DomeColumns - 1.0);
        const double around = from + Pi * part * part;
        directions.emplace_back(std::cos(up) * std::cos(around), std::cos(up) * std::sin(around), std::sin(up));
      }
      const std::vector<Vector3> colors = luminances(directions);
      std::copy(colors.begin(), colors.end(), &sky.Dome.At(0, static_cast<int>(row)));
    }
  });
  const std::vector<Sample> samples = SamplesOf(sky);
  sky.Light = { SkyTables::LightSize, SkyTables::LightSize, {} };
  sky.Light.Colors.resize(static_cast<std::size_t>(SkyTables::LightSize) * SkyTables::LightSize);
  parallel(SkyTables::LightSize, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
    {
      Planes planes;
      const double v = 2.0 * static_cast<double>(row) / (SkyTables::LightSize - 1.0) - 1.0;
      for (int column = 0; column < SkyTables::LightSize; ++column)
      {
        const Vector3 normal = OctahedronNormal(2.0 * column / (SkyTables::LightSize - 1.0) - 1.0, v);
        for (int axis = 0; axis < 3; ++axis)
        {
          planes.Normal[axis][column] = normal[axis];
        }
      }
      AddLight(samples, planes);
      for (int column = 0; column < SkyTables::LightSize; ++column)
      {
        sky.Light.At(column, static_cast<int>(row)) = { planes.Light[0][column], planes.Light[1][column],
          planes.Light[2][column] };
      }
    }
  });
  return sky;
}

}
