// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../ProcessTeam.h"
#include "Numerics/Constants.h"
#include "Plants/CanopyDensity.h"
#include "Plants/CanopyProfile.h"
#include "Plants/CrownCylinder.h"
#include "Plants/FoliageParcels.h"
#include "Plants/GapFraction.h"
#include "Plants/LeafCards.h"
#include "Plants/LeafInclination.h"
#include "Plants/LeafTraits.h"
#include "Plants/PictureCoverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace littoral;

namespace
{

/// Uniform numbers, not those of the library.
class Numbers
{
public:
  double operator()(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(this->Engine()) / 4294967296.0);
  }

  Vector3 Direction()
  {
    const double z = (*this)(-1.0, 1.0);
    const double azimuth = (*this)(0.0, 2.0 * Pi);
    const double r = std::sqrt(1.0 - z * z);
    return { r * std::cos(azimuth), r * std::sin(azimuth), z };
  }

private:
  std::mt19937 Engine{ 7 };
};

/// Triangles of a size about a place in an ellipsoid.
std::vector<FoliageTriangle> Cloud(Numbers& numbers, int count, double size)
{
  std::vector<FoliageTriangle> triangles;
  for (int n = 0; n < count; ++n)
  {
    const Vector3 center = numbers.Direction() * Vector3(2.0, 2.5, 3.0) * std::cbrt(numbers(0.0, 1.0));
    const Vector3 a = size * numbers.Direction();
    const Vector3 b = size * numbers.Direction();
    triangles.push_back({ { center, center + a, center + b }, numbers(0.3, 1.0) });
  }
  return triangles;
}

CanopyGrid GridOf(const Vector3& low, const Vector3& high, double side)
{
  CanopyGrid grid{ low, Vector3(side), {} };
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.Count[axis] = static_cast<int>(std::ceil((high[axis] - low[axis]) / side));
  }
  return grid;
}

double SumOfLeaves(const CanopyDensity& density)
{
  double sum = 0.0;
  for (std::size_t cell = 0; cell < density.GetGrid().NumberOfCells(); ++cell)
  {
    sum += density.LeafArea(cell);
  }
  return sum;
}

double Area(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const Vector3 normal = glm::cross(b - a, c - a);
  return 0.5 * std::sqrt(glm::dot(normal, normal));
}

}

TEST(CanopyProfile, LalicAndMihailovic)
{
  // quadrature of its own, to four digits
  const double values[4][2] = { { 0.4, 0.72799 }, { 0.5, 0.67441 }, { 0.7, 0.46006 }, { 0.84, 0.25200 } };
  for (const auto& value : values)
  {
    const CanopyProfile profile(value[0]);
    EXPECT_NEAR(profile.Integral(), value[1], 5e-6) << value[0];
    EXPECT_DOUBLE_EQ(profile.Density(value[0]), 1.0);
    EXPECT_EQ(profile.ShareBelow(0.0), 0.0);
    EXPECT_EQ(profile.ShareBelow(1.0), 1.0);
    EXPECT_EQ(profile.Density(-0.1) + profile.Density(1.0), 0.0);
    EXPECT_NEAR(MaximumOfMean(profile.MeanHeight()), value[0], 1e-6);
    const double rise = profile.ShareBelow(0.301) - profile.ShareBelow(0.299);
    EXPECT_NEAR(rise / 0.002, profile.Density(0.3) / profile.Integral(), 1e-4);
  }
}

TEST(CanopyProfile, MeanHeight)
{
  double mean = 0.0;
  double sum = 0.0;
  const CanopyProfile profile(0.6);
  for (int n = 0; n < 2000; ++n)
  {
    sum += profile.Density((n + 0.5) / 2000.0);
    mean += profile.Density((n + 0.5) / 2000.0) * (n + 0.5) / 2000.0;
  }
  EXPECT_NEAR(profile.MeanHeight(), mean / sum, 1e-5);
}

TEST(CanopyDensity, CellsShareLeavesExactly)
{
  Numbers numbers;
  const std::vector<FoliageTriangle> leaves = Cloud(numbers, 300, 0.7);
  double area = 0.0;
  for (const FoliageTriangle& leaf : leaves)
  {
    area += leaf.Part * Area(leaf.Corners[0], leaf.Corners[1], leaf.Corners[2]);
  }
  for (const double side : { 0.25, 0.5, 1.0, 2.0, 4.0 })
  {
    CanopyDensity density(GridOf({ -4.0, -4.2, -4.4 }, { 4.0, 4.2, 4.4 }, side), { 0.08 }, false);
    for (const FoliageTriangle& leaf : leaves)
    {
      AddLeaf(leaf, 0, density);
    }
    EXPECT_NEAR(SumOfLeaves(density) / area, 1.0, 1e-6) << side;
    EXPECT_NEAR(density.LeafOutside(), 0.0, 1e-9);
  }
}

TEST(CanopyDensity, PartsLieInTheirCells)
{
  Numbers numbers;
  const CanopyGrid grid = GridOf({ -1.0, -1.5, -2.0 }, { 1.0, 1.5, 2.0 }, 0.5);
  for (const FoliageTriangle& leaf : Cloud(numbers, 100, 1.0))
  {
    double sum = 0.0;
    CutToCells(grid, TriangleOf(leaf.Corners[0], leaf.Corners[1], leaf.Corners[2]),
      [&](std::size_t cell, const CutPolygon& part) {
        sum += part.Area();
        for (int corner = 0; corner < part.Size; ++corner)
        {
          const Vector3 place = (part.Corners[corner] - grid.Origin) / grid.Spacing;
          const int indices[3] = { static_cast<int>(cell % grid.Count[0]),
            static_cast<int>(cell / grid.Count[0] % grid.Count[1]),
            static_cast<int>(cell / (static_cast<std::size_t>(grid.Count[0]) * grid.Count[1])) };
          bool isWithin = true;
          for (int axis = 0; axis < 3; ++axis)
          {
            isWithin &= cell == OutsideCells || std::abs(place[axis] - indices[axis] - 0.5) <= 0.5 + 1e-9;
          }
          EXPECT_TRUE(isWithin);
        }
      });
    EXPECT_NEAR(sum, Area(leaf.Corners[0], leaf.Corners[1], leaf.Corners[2]), 1e-12);
  }
}

TEST(CanopyDensity, TriangleAcrossAFace)
{
  // a right triangle with legs 2 from the origin: the cell from 0 to 1 has a square less nothing, its neighbour a half
  const CanopyGrid grid{ { 0.0, 0.0, -0.5 }, Vector3(1.0), { 3, 3, 1 } };
  CanopyDensity density(grid, { 0.1, 0.3 }, true);
  AddLeaf({ { Vector3(0.0), { 2.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0 } }, 0.5 }, 1, density);
  EXPECT_NEAR(density.LeafArea(0), 0.5, 1e-9);
  EXPECT_NEAR(density.LeafArea(1), 0.25, 1e-9);
  EXPECT_NEAR(density.LeafArea(3), 0.25, 1e-9);
  EXPECT_NEAR(density.LeafAreaOf(1, 3), 0.25, 1e-9);
  EXPECT_EQ(density.LeafAreaOf(0, 3), 0.0);
  EXPECT_NEAR(density.LeafMass(3), 0.075, 1e-9);
  EXPECT_EQ(density.LeafArea(4), 0.0);
}

TEST(CanopyDensity, ParcelsKeepTotals)
{
  Numbers numbers;
  const PlantFoliage plant{ Cloud(numbers, 2000, 0.15), Cloud(numbers, 300, 0.2) };
  const double side = 1.0;
  const ParcelledPlant parcels{ { plant.Leaves, 0.5 * side }, { plant.Wood, 0.5 * side } };
  EXPECT_LT(parcels.Leaves.Parcels().size(), plant.Leaves.size() / 2);
  const CanopyGrid grid = GridOf(Vector3(-9.0), Vector3(9.0), side);
  for (const Vector3& scale : { Vector3(1.0), Vector3(1.3, 1.3, 0.7), Vector3(0.4, 0.4, 1.9) })
  {
    CanopyDensity exact(grid, { 0.08 }, false);
    CanopyDensity quick(grid, { 0.08 }, false);
    FoliagePlace place{ 0, { 0.3, -0.2, 0.1 }, glm::dquat(std::cos(0.4), 0.0, 0.0, std::sin(0.4)), scale };
    AddPlant(plant, place, exact);
    PlantCells cells;
    AddPlant(parcels, place, cells, quick);
    EXPECT_NEAR(SumOfLeaves(quick) / SumOfLeaves(exact), 1.0, 1e-6);
    double difference = 0.0;
    double square = 0.0;
    for (std::size_t cell = 0; cell < grid.NumberOfCells(); ++cell)
    {
      difference += std::pow(quick.LeafArea(cell) - exact.LeafArea(cell), 2);
      square += std::pow(exact.LeafArea(cell), 2);
    }
    EXPECT_LT(std::sqrt(difference / square), 0.1);
  }
}

TEST(CanopyDensity, ParcelsBeyondTheGrid)
{
  Numbers numbers;
  const PlantFoliage plant{ Cloud(numbers, 200, 0.1), {} };
  const ParcelledPlant parcels{ { plant.Leaves, 0.5 }, {} };
  CanopyDensity density(GridOf(Vector3(0.0), Vector3(9.0), 1.0), { 0.08 }, false);
  PlantCells cells;
  AddPlant(parcels, {}, cells, density);
  AddPlant(parcels, { 0, Vector3(100.0) }, cells, density);
  const double all = CountedArea(plant.Leaves);
  EXPECT_NEAR(SumOfLeaves(density) + density.LeafOutside(), 2.0 * all, 1e-8 * all);
  EXPECT_GT(density.LeafOutside(), 1.6 * all);
}

TEST(LeafInclination, ClosedForms)
{
  LeafInclination sphere;
  sphere.AddSphere(1.0);
  LeafInclination flat;
  flat.Add({ 0.0, 0.0, -2.0 }, 3.0);
  LeafInclination steep;
  steep.Add({ 0.0, 1.0, 0.0 }, 3.0);
  for (const double zenith : { 0.0, 0.3, 0.8, 1.4 })
  {
    EXPECT_NEAR(sphere.Projection(zenith), 0.5, 2e-4);
    EXPECT_NEAR(flat.Projection(zenith), std::cos(zenith), 1e-2);
    EXPECT_NEAR(steep.Projection(zenith), 2.0 / Pi * std::sin(zenith), 1e-2);
  }
  // mean of |n d| over azimuths, by sums
  for (const double inclination : { 0.2, 0.7, 1.2 })
  {
    double mean = 0.0;
    for (int turn = 0; turn < 20000; ++turn)
    {
      const double azimuth = 2.0 * Pi * (turn + 0.5) / 20000;
      mean +=
        std::abs(std::cos(inclination) * std::cos(1.0) + std::sin(inclination) * std::sin(1.0) * std::cos(azimuth)) /
        20000;
    }
    EXPECT_NEAR(ProjectionOf(inclination, 1.0), mean, 1e-6);
  }
}

TEST(GapFraction, RandomLeaves)
{
  // small squares at random in a box that repeats itself, seen through pixels: those that no square covers
  constexpr double box = 8.0;
  constexpr double height = 4.0;
  constexpr double side = 0.05;
  constexpr int leaves = 51200; // leaf area index 2
  constexpr int pixels = 1000;
  Numbers numbers;
  const CanopyGrid grid = GridOf(Vector3(0.0), { box, box, height }, 1.0);
  CanopyDensity density(grid, { 0.08 }, false);
  LeafInclination inclination;
  std::vector<std::array<Vector3, 3>> squares; // middle and half sides
  std::vector<FoliageTriangle> triangles;
  for (int n = 0; n < leaves; ++n)
  {
    const Vector3 normal = numbers.Direction();
    const Vector3 a = 0.5 * side * Perpendicular(normal);
    const Vector3 b = glm::cross(normal, a);
    const Vector3 middle(numbers(0.0, box), numbers(0.0, box), numbers(0.1, height - 0.1));
    squares.push_back({ middle, a, b });
    triangles.push_back({ { middle - a - b, middle + a - b, middle + a + b } });
    triangles.push_back({ { middle - a - b, middle + a + b, middle - a + b } });
  }
  for (const FoliageTriangle& triangle : triangles)
  {
    AddLeaf(triangle, 0, density);
  }
  AddInclination(triangles, inclination);
  std::vector<float> values;
  for (std::size_t cell = 0; cell < grid.NumberOfCells(); ++cell)
  {
    values.push_back(static_cast<float>(density.LeafArea(cell) / grid.CellVolume()));
  }
  for (const double zenith : { 0.2, 0.9 })
  {
    // along the direction onto the ground: x - z tan(zenith)
    std::vector<char> covered(pixels * pixels, 0);
    for (const auto& [middle, a, b] : squares)
    {
      const double slope = std::tan(zenith);
      const double p[2] = { a.x - slope * a.z, a.y };
      const double q[2] = { b.x - slope * b.z, b.y };
      const double area = p[0] * q[1] - p[1] * q[0];
      const double scale = pixels / box;
      const double x = middle.x - slope * middle.z;
      const double reach[2] = { std::abs(p[0]) + std::abs(q[0]), std::abs(p[1]) + std::abs(q[1]) };
      for (int j = static_cast<int>(std::floor((middle.y - reach[1]) * scale)); j < (middle.y + reach[1]) * scale; ++j)
      {
        for (int i = static_cast<int>(std::floor((x - reach[0]) * scale)); i < (x + reach[0]) * scale; ++i)
        {
          const double dx = (i + 0.5) / scale - x;
          const double dy = (j + 0.5) / scale - middle.y;
          const bool isWithin =
            std::abs(dx * q[1] - dy * q[0]) <= std::abs(area) && std::abs(dy * p[0] - dx * p[1]) <= std::abs(area);
          if (isWithin)
          {
            covered[((j + 10 * pixels) % pixels) * pixels + (i + 10 * pixels) % pixels] = 1;
          }
        }
      }
    }
    const double seen = static_cast<double>(std::count(covered.begin(), covered.end(), 0)) / (1.0 * pixels * pixels);
    const double projection = inclination.Projection(zenith);
    EXPECT_NEAR(projection, 0.5, 0.005);
    const double gap = GapFraction(grid, values.data(), zenith, projection);
    EXPECT_NEAR(gap / std::exp(-projection * 2.0 / std::cos(zenith)), 1.0, 0.02);
    EXPECT_NEAR(gap / seen, 1.0, 0.02) << zenith;
  }
}

TEST(CanopyDensity, SharedByProcesses)
{
  Numbers numbers;
  const CanopyGrid grid = GridOf({ -3.0, -2.0, -3.0 }, { 3.0, 3.0, 3.0 }, 0.5);
  const std::vector<FoliageTriangle> leaves = Cloud(numbers, 400, 0.6);
  const auto count = [&](const WorkShare& share, CanopyDensity& density) {
    for (std::size_t own = 0; own < share.OwnOf(leaves.size()); ++own)
    {
      const std::size_t leaf = share.RowOf(own);
      AddLeaf(leaves[leaf], static_cast<int>(leaf % 2), density);
      AddWood(leaves[leaf], density);
    }
    // more than a double has of the unit of the sums
    density.AddLeaf(0, share.Rank % grid.NumberOfCells(), 3e6 + 1.0 / 1024.0);
    density.AddUp(share);
  };
  const auto numbersOf = [&](const CanopyDensity& density) {
    std::vector<double> all{ density.LeafOutside() };
    for (std::size_t cell = 0; cell < grid.NumberOfCells(); ++cell)
    {
      all.insert(all.end(),
        { density.LeafArea(cell), density.LeafAreaOf(1, cell), density.WoodArea(cell), density.LeafMass(cell) });
    }
    return all;
  };
  std::vector<float> ofCells(grid.NumberOfCells());
  std::generate(ofCells.begin(), ofCells.end(), [&] { return static_cast<float>(numbers(0.0, 0.4)); });
  for (const std::size_t ranks : { 2, 3, 7 })
  {
    CanopyDensity alone(grid, { 0.08, 0.1 }, true);
    count({}, alone);
    for (std::size_t rank = 1; rank < ranks; ++rank)
    {
      alone.AddLeaf(0, rank, 3e6 + 1.0 / 1024.0);
    }
    ASSERT_GT(alone.LeafOutside(), 0.0);
    const double gap = GapFraction(grid, ofCells.data(), 0.9, 0.5);
    littoral::testing::ProcessTeam(ranks).Run([&](const WorkShare& share) {
      CanopyDensity density(grid, { 0.08, 0.1 }, true);
      count(share, density);
      EXPECT_EQ(numbersOf(density), numbersOf(alone)) << share.Rank << " of " << ranks;
      EXPECT_EQ(GapFraction(grid, ofCells.data(), 0.9, 0.5, SerialFor, share), gap) << share.Rank << " of " << ranks;
    });
  }
}

TEST(CrownCylinder, SharesAddUp)
{
  EXPECT_NEAR(CircleWithin(2.0, 5.0, 3.0), Pi, 1e-12);
  EXPECT_NEAR(CircleWithin(2.0, -1.0, 1.0), -1.0, 1e-12);
  double sum = 0.0; // strips
  for (int n = 0; n < 100000; ++n)
  {
    sum += std::min(1.5, std::sqrt(4.0 - std::pow((n + 0.5) * 1.8e-5, 2))) * 1.8e-5;
  }
  EXPECT_NEAR(CircleWithin(2.0, 1.8, 1.5), sum, 1e-6);

  const CanopyProfile profile(0.7);
  const CanopyGrid grid = GridOf({ -6.0, -6.0, 0.0 }, { 6.0, 6.0, 24.0 }, 1.5);
  std::vector<double> ofLayer(grid.Count[2], 0.0);
  double moment = 0.0;
  ShareBetweenCells(grid, { { 0.4, -0.3, 1.0 }, 20.0, 7.0 }, profile, [&](std::size_t cell, double share) {
    if (cell == OutsideCells)
    {
      EXPECT_NEAR(share, 0.0, 1e-12);
      return;
    }
    ofLayer[cell / (static_cast<std::size_t>(grid.Count[0]) * grid.Count[1])] += share;
    moment += share * (static_cast<double>(cell % grid.Count[0]) + 0.5);
  });
  // from 1 to 21 m: the layer from 12 to 13.5 m is 0.55 to 0.625 of the height
  EXPECT_NEAR(ofLayer[8], profile.ShareBelow(0.625) - profile.ShareBelow(0.55), 1e-12);
  EXPECT_EQ(ofLayer[15], 0.0);
  EXPECT_NEAR(moment * 1.5 - 6.0, 0.4, 0.05);
  double outside = 0.0;
  ShareBetweenCells(grid, { { -6.0, 0.0, 0.0 }, 20.0, 7.0 }, profile,
    [&](std::size_t cell, double share) { outside += cell == OutsideCells ? share : 0.0; });
  EXPECT_NEAR(outside, 0.5, 1e-9);
}

TEST(PictureCoverage, PartsOfPictures)
{
  TextureImage picture(64, 64);
  for (int row = 0; row < 64; ++row)
  {
    for (int column = 0; column < 64; ++column)
    {
      picture.At(column, row) = { 255, 255, 255, static_cast<unsigned char>(column < 32 ? 200 : 100) };
    }
  }
  // of the triangle below the diagonal, what is left of the middle: 1/4
  EXPECT_NEAR(CoverageOf(picture, { { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 } } }), 0.25, 0.01);
  EXPECT_EQ(CoverageOf({}, { { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 } } }), 1.0);
  EXPECT_EQ(CoverageOf(picture, { { { 0.1, 0.1 }, { 0.1, 0.1 }, { 0.1, 0.1 } } }), 1.0);
  // texels of a leaf within its kite, counted
  const TextureImage leaf = LeafPicture(LeafForm::Blade);
  int within = 0;
  int opaque = 0;
  for (int row = 0; row < leaf.Rows; ++row)
  {
    for (int column = 0; column < leaf.Columns; ++column)
    {
      const double across = std::abs(2.0 * (column + 0.5) / leaf.Columns - 1.0);
      const double along = (row + 0.5) / leaf.Rows;
      const bool isWithin = across < (along < 0.42 ? along / 0.42 : (1.0 - along) / 0.58);
      within += isWithin ? 1 : 0;
      opaque += isWithin && leaf.At(column, row)[3] > 127 ? 1 : 0;
    }
  }
  const double halves = 0.5 *
    (CoverageOf(leaf, { { { 0.5, 0.0 }, { 1.0, 0.42 }, { 0.5, 1.0 } } }) +
      CoverageOf(leaf, { { { 0.5, 0.0 }, { 0.5, 1.0 }, { 0.0, 0.42 } } }));
  EXPECT_NEAR(halves, static_cast<double>(opaque) / within, 0.01);
}

TEST(LeafTraits, FoliageOfTrees)
{
  ASSERT_NE(FindLeafTraits("Quercus robur"), nullptr);
  EXPECT_EQ(FindLeafTraits("Quercus robur"), FindLeafTraits("oak"));
  EXPECT_EQ(FindLeafTraits("Scots pine"), FindLeafTraits("Pinus sylvestris"));
  EXPECT_EQ(FindLeafTraits("cactus"), nullptr);
  EXPECT_EQ(FindLeafTraits(""), nullptr);
  // an oak of 30 cm: 526.7 kg above the ground, 2.054 % of it leaves
  EXPECT_NEAR(FoliageMassOf(*FindLeafTraits("Oak"), 0.3), 526.7 * 0.02054, 0.02);
  EXPECT_NEAR(1.0 / FindLeafTraits("pine")->MassPerArea, 6.2, 1e-9);
}
