// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The surface of a sea by distance, against the linear theory of a wave.
#include "Numerics/Constants.h"
#include "Sea/SeaSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace littoral;

namespace
{

SeaSurfaceParameters SmallDisk()
{
  SeaSurfaceParameters disk;
  disk.Radius = 400.0;
  disk.Spacing = 2.0;
  disk.Sectors = 90;
  return disk;
}

SeaState OneWave(double length)
{
  const double k = 2.0 * Pi / length;
  SeaState sea;
  sea.SeaLevel = 3.0;
  sea.Trains = { { 0.02 * length, std::sqrt(9.80665 * k), k, 0.4, 0.7 } };
  return sea;
}

}

TEST(SeaSurface, DeepWaterWave)
{
  // Gerstner: x = x0 + a sin(phi) d, z = -a cos(phi), J = 1 + k a cos(phi), normal ~ (-k a sin(phi) d, J).
  SeaSurfaceParameters disk = SmallDisk();
  disk.Center[0] = 1.0e6;
  disk.Center[1] = -2.0e6;
  const SeaSurfaceGrid grid(disk);
  const SeaState sea = OneWave(120.0);
  const WaveTrain wave = sea.Trains[0];
  const double time = 11.3;
  const SeaSurfacePoints points = SurfaceOf(sea, disk, grid, 1.0, time, 0, grid.GetNumberOfPoints());
  for (std::size_t i = 0; i < grid.GetNumberOfPoints(); ++i)
  {
    if (4.0 * grid.SpacingAt(i) > 120.0)
    {
      continue;
    }
    double x, y;
    grid.PlaceAt(i, x, y);
    const double dx = std::cos(wave.Direction);
    const double dy = std::sin(wave.Direction);
    const double phi = wave.WaveNumber * (dx * (disk.Center[0] + x) + dy * (disk.Center[1] + y)) -
      wave.AngularFrequency * time + wave.Phase;
    const double steepness = wave.WaveNumber * wave.Amplitude;
    EXPECT_NEAR(points.Places[3 * i], x + wave.Amplitude * std::sin(phi) * dx, 2e-4);
    EXPECT_NEAR(points.Places[3 * i + 1], y + wave.Amplitude * std::sin(phi) * dy, 2e-4);
    EXPECT_NEAR(points.Places[3 * i + 2], -wave.Amplitude * std::cos(phi), 2e-4);
    const double jacobian = 1.0 + steepness * std::cos(phi);
    EXPECT_NEAR(points.Jacobians[i], jacobian, 1e-5);
    const double length = std::hypot(steepness * std::sin(phi), jacobian);
    EXPECT_NEAR(points.Normals[3 * i], -steepness * std::sin(phi) * dx / length, 1e-5);
    EXPECT_NEAR(points.Normals[3 * i + 2], jacobian / length, 1e-5);
  }
}

TEST(SeaSurface, WavesEndWhereTheyWouldAlias)
{
  const SeaSurfaceParameters disk = SmallDisk();
  const SeaSurfaceGrid grid(disk);
  const double length = 60.0;
  const SeaSurfacePoints points = SurfaceOf(OneWave(length), disk, grid, 1.0, 0.0, 0, grid.GetNumberOfPoints());
  std::size_t near = 0;
  std::size_t moved = 0;
  std::size_t still = 0;
  for (std::size_t i = 0; i < grid.GetNumberOfPoints(); ++i)
  {
    const bool isMoved = std::abs(points.Jacobians[i] - 1.0f) > 1e-7f;
    // Of four points a wave, one at least is off its zeros; the spacing at r is 2 pi r / 90 there.
    double x, y;
    grid.PlaceAt(i, x, y);
    const double spacing = std::max(2.0, 2.0 * Pi * std::hypot(x, y) / 90.0);
    near += spacing < 0.24 * length;
    moved += spacing < 0.24 * length && isMoved;
    still += spacing > 0.25 * length && !isMoved;
    EXPECT_FALSE(spacing > 0.25 * length && isMoved) << i;
  }
  EXPECT_GT(near, 3000u);
  EXPECT_GT(moved, 0.95 * static_cast<double>(near));
  EXPECT_GT(still, 500u);
}

TEST(SeaSurface, PartsAreTheDisk)
{
  // Each triangle of the disk, by the places of its corners, is in one of the parts, with the same surface at them.
  const SeaSurfaceParameters disk = SmallDisk();
  const SeaState sea = OneWave(120.0);
  const auto trianglesOf = [&](int first, int end, std::vector<std::vector<float>>& triangles) {
    const SeaSurfaceGrid grid(disk, first, end);
    const SeaSurfacePoints points = SurfaceOf(sea, disk, grid, 1.0, 3.0, 0, grid.GetNumberOfPoints());
    const std::vector<int> corners = grid.MakeTriangles();
    for (std::size_t i = 0; i < corners.size(); i += 3)
    {
      std::vector<float> triangle;
      for (std::size_t c = i; c < i + 3; ++c)
      {
        triangle.insert(
          triangle.end(), points.Places.begin() + 3 * corners[c], points.Places.begin() + 3 * corners[c] + 3);
        triangle.push_back(points.Jacobians[corners[c]]);
      }
      triangles.push_back(triangle);
    }
  };
  std::vector<std::vector<float>> whole;
  trianglesOf(0, disk.Sectors, whole);
  std::sort(whole.begin(), whole.end());
  for (const std::vector<int>& bounds : { std::vector<int>{ 0, 30, 60, 90 }, { 0, 0, 1, 89, 90 } })
  {
    ASSERT_EQ(bounds.back(), disk.Sectors);
    std::vector<std::vector<float>> parts;
    for (std::size_t part = 0; part + 1 < bounds.size(); ++part)
    {
      trianglesOf(bounds[part], bounds[part + 1], parts);
    }
    std::sort(parts.begin(), parts.end());
    EXPECT_TRUE(parts == whole);
  }
  EXPECT_EQ(SeaSurfaceGrid(disk, 7, 7).GetNumberOfPoints(), 0u);
}

TEST(SeaSurface, DiskIsCoveredOnce)
{
  const SeaSurfaceParameters disk = SmallDisk();
  const SeaSurfaceGrid grid(disk);
  const std::vector<int> corners = grid.MakeTriangles();
  double area = 0.0;
  for (std::size_t i = 0; i < corners.size(); i += 3)
  {
    double x[3], y[3];
    for (int c = 0; c < 3; ++c)
    {
      ASSERT_LT(corners[i + c], static_cast<int>(grid.GetNumberOfPoints()));
      grid.PlaceAt(corners[i + c], x[c], y[c]);
    }
    const double twice = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    EXPECT_GT(twice, 0.0) << "a triangle looks down";
    area += 0.5 * twice;
  }
  // The regular polygon of 90 corners in the circle.
  EXPECT_NEAR(area, 0.5 * 90 * 400.0 * 400.0 * std::sin(2.0 * Pi / 90.0), 1e-6 * area);
  EXPECT_DOUBLE_EQ(grid.GetRadii().back(), 400.0);
}

TEST(SeaSurface, CellsAreSquareWherePointsOnARingAreFarApart)
{
  const SeaSurfaceParameters disk = SmallDisk();
  const SeaSurfaceGrid grid(disk);
  const std::vector<double>& radii = grid.GetRadii();
  const double even = disk.Spacing * disk.Sectors / (2.0 * Pi);
  ASSERT_LT(even, 0.5 * disk.Radius);
  for (std::size_t ring = 1; ring + 1 < radii.size(); ++ring)
  {
    const double inner = radii[ring - 1];
    const double square = 2.0 * Pi * inner / disk.Sectors;
    EXPECT_NEAR(radii[ring] - inner, inner < even ? disk.Spacing : square, 1e-9 * radii[ring]);
  }
}

TEST(SeaSurface, FoamFadesBehindItsCrests)
{
  // J = 1 + s cos(phi): of (1 - J(t - a)) exp(-a / T) = -s cos(phi + w a) exp(-a / T) the first maximum is where
  // tan(phi + w a) = -1 / (w T).
  const SeaSurfaceParameters disk = SmallDisk();
  const SeaSurfaceGrid grid(disk);
  const SeaState sea = OneWave(60.0);
  const WaveTrain wave = sea.Trains[0];
  const double steepness = wave.WaveNumber * wave.Amplitude;
  const double turn = wave.AngularFrequency;
  const double lifetime = 3.85;
  const double time = 1000.7;
  const SeaSurfacePoints points = SurfaceOf(sea, disk, grid, 1.0, time, 0, grid.GetNumberOfPoints(), lifetime);
  ASSERT_EQ(points.Foam.size(), grid.GetNumberOfPoints());
  EXPECT_TRUE(SurfaceOf(sea, disk, grid, 1.0, time, 0, 10).Foam.empty());
  for (std::size_t i = 0; i < grid.GetNumberOfPoints() && 4.0 * grid.SpacingAt(i) < 60.0; ++i)
  {
    double x, y;
    grid.PlaceAt(i, x, y);
    const double phi =
      wave.WaveNumber * (std::cos(wave.Direction) * x + std::sin(wave.Direction) * y) - turn * time + wave.Phase;
    const double age = std::fmod(Pi - std::atan(1.0 / (turn * lifetime)) - phi + 1e4 * Pi, 2.0 * Pi) / turn;
    const double former = -steepness * std::cos(phi + turn * age) * std::exp(-age / lifetime);
    EXPECT_NEAR(points.Foam[i], std::max(-steepness * std::cos(phi), former), 0.005 * steepness);
    EXPECT_NEAR(points.Ways[2 * i + 1], points.Places[3 * i + 1] - y, 1e-4);
    EXPECT_GE(points.Foam[i], 1.0F - points.Jacobians[i] - 1e-5F);
  }
}

TEST(SeaSurface, FoamTravelsWithItsWave)
{
  // Seen from a frame that goes with the wave, foam stands still.
  SeaSurfaceParameters disk = SmallDisk();
  const SeaSurfaceGrid grid(disk);
  const SeaState sea = OneWave(60.0);
  const WaveTrain wave = sea.Trains[0];
  const SeaSurfacePoints before = SurfaceOf(sea, disk, grid, 1.0, 7.0, 0, grid.GetNumberOfPoints(), 3.0);
  const double way = 0.37 * wave.AngularFrequency / wave.WaveNumber;
  disk.Center[0] += way * std::cos(wave.Direction);
  disk.Center[1] += way * std::sin(wave.Direction);
  const SeaSurfacePoints after = SurfaceOf(sea, disk, grid, 1.0, 7.37, 0, grid.GetNumberOfPoints(), 3.0);
  for (std::size_t i = 0; i < grid.GetNumberOfPoints(); ++i)
  {
    ASSERT_NEAR(before.Foam[i], after.Foam[i], 1e-6);
  }
}

TEST(SeaSurface, RangesDoNotMatter)
{
  const SeaSurfaceParameters disk = SmallDisk();
  const SeaSurfaceGrid grid(disk);
  const SeaState sea = OneWave(90.0);
  const SeaSurfacePoints whole = SurfaceOf(sea, disk, grid, 1.0, 2.0, 0, grid.GetNumberOfPoints(), 4.0);
  const SeaSurfacePoints part = SurfaceOf(sea, disk, grid, 1.0, 2.0, 777, 1333, 4.0);
  EXPECT_TRUE(std::equal(part.Places.begin(), part.Places.end(), whole.Places.begin() + 3 * 777));
  EXPECT_TRUE(std::equal(part.Normals.begin(), part.Normals.end(), whole.Normals.begin() + 3 * 777));
  EXPECT_TRUE(std::equal(part.Foam.begin(), part.Foam.end(), whole.Foam.begin() + 777));
}

TEST(SeaSurface, BadDisks)
{
  SeaSurfaceParameters disk;
  EXPECT_EQ(WhyInvalid(disk), "");
  disk.Radius = 0.0;
  EXPECT_NE(WhyInvalid(disk).find("Radius is 0 m"), std::string::npos) << WhyInvalid(disk);
  disk = {};
  disk.Spacing = 6000.0;
  EXPECT_NE(WhyInvalid(disk).find("Spacing"), std::string::npos);
  disk = {};
  disk.Sectors = 10000;
  disk.Spacing = 0.001;
  EXPECT_NE(WhyInvalid(disk).find("points"), std::string::npos) << WhyInvalid(disk);
}
