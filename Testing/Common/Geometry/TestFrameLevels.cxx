// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Levels of a plant's picture, and the map of directions: means of checks and coverages that are known.
#include "Geometry/FrameLevels.h"
#include "Geometry/OctahedronMap.h"

#include <gtest/gtest.h>

#include <random>

using littoral::FramePicture;
using littoral::FrameTexel;

namespace
{

/// A picture whose texels are covered by chance, in two colors by columns.
FramePicture Leaves(int side, double share)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  FramePicture picture(side);
  for (int k = 0; k < side * side; ++k)
  {
    FrameTexel& texel = picture.Texels[static_cast<std::size_t>(k)];
    texel.Coverage = number(random) < share ? 1.0F : 0.0F;
    texel.Albedo = texel.Coverage * glm::vec3(k % 2 == 0 ? 0.2F : 0.6F);
  }
  return picture;
}

double CoverageOf(const FramePicture& picture)
{
  double sum = 0.0;
  for (const FrameTexel& texel : picture.Texels)
  {
    sum += static_cast<double>(texel.Coverage) / static_cast<double>(picture.Texels.size());
  }
  return sum;
}

}

TEST(FrameLevels, KeepMeans)
{
  const FramePicture finest = Leaves(64, 0.37);
  const double covered = CoverageOf(finest);
  const std::vector<FramePicture> levels = littoral::FrameLevels(finest, 64);
  ASSERT_EQ(levels.size(), 7U);
  for (const FramePicture& level : levels)
  {
    EXPECT_NEAR(CoverageOf(level), covered, 1e-6);
  }
  EXPECT_EQ(levels.back().Side, 1);
  EXPECT_NEAR(levels.back().Texels[0].Albedo.x, 0.4, 0.02);
}

TEST(FrameLevels, FillGapsFromAround)
{
  FramePicture picture(8);
  picture.At(5, 2).Coverage = 1.0F;
  picture.At(5, 2).Depth = 0.7F;
  const FramePicture filled = littoral::FrameLevels(picture, 8).front();
  EXPECT_FLOAT_EQ(filled.At(0, 7).Depth, 0.7F);
  EXPECT_EQ(filled.At(0, 7).Coverage, 0.0F);
}

TEST(FrameLevels, CutKeepsCoverage)
{
  for (const double share : { 0.15, 0.37, 0.6 })
  {
    FramePicture level = littoral::FrameLevels(Leaves(512, share), 64).front();
    const double whole = CoverageOf(level);
    littoral::KeepCoverage(level);
    // The mean of an interpolation between texels at the four corners of each of them
    double covered = 0.0;
    const auto corner = [&level](int column, int row) {
      return 0.25 *
        (level.At(column, row).Coverage + level.At(column + 1, row).Coverage + level.At(column, row + 1).Coverage +
          level.At(column + 1, row + 1).Coverage);
    };
    for (int row = 1; row < level.Side - 1; ++row)
    {
      for (int column = 1; column < level.Side - 1; ++column)
      {
        const double mean = 0.25 *
          (corner(column - 1, row - 1) + corner(column, row - 1) + corner(column - 1, row) + corner(column, row));
        covered += mean >= 0.5 ? 1.0 : 0.0;
      }
    }
    EXPECT_NEAR(covered / static_cast<double>(level.Texels.size()), whole, 0.02);
  }
}

TEST(OctahedronMap, GoesThereAndBack)
{
  for (const auto& place : { glm::dvec2(0.3, -0.2), glm::dvec2(-0.9, 0.8), glm::dvec2(0.6, 0.7), glm::dvec2(0.0, 0.0) })
  {
    const glm::dvec2 back = littoral::OctahedronPlace(littoral::OctahedronNormal(place.x, place.y));
    EXPECT_NEAR(back.x, place.x, 1e-12);
    EXPECT_NEAR(back.y, place.y, 1e-12);
  }
  EXPECT_NEAR(littoral::OctahedronNormal(0.0, 0.0).z, 1.0, 1e-12);
  EXPECT_NEAR(littoral::OctahedronNormal(1.0, 0.0).x, 1.0, 1e-12);
}
