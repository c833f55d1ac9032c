// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../WindAlong.h"
#include "Plants/CylindricalProjection.h"
#include "Sway/CrownPictures.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>

using namespace littoral;
using littoral::testing::WindAlong;

namespace
{

/// A trunk with two branches, and upright leaves on them.
struct SmallTree
{
  SwaySettings Settings;
  SwaySpecies Species;
  CrownModel Crown;
  std::vector<float> Points;
  std::vector<int> JointIds;
  std::vector<float> JointWeights;

  SmallTree()
  {
    Skeleton wood;
    wood.StartBranch(-1, { 0.0, 0.0, 0.0 }, 0.05);
    wood.Grow({ 0.0, 0.0, 2.0 }, 0.04);
    wood.Grow({ 0.0, 0.0, 4.0 }, 0.02);
    for (const double side : { -1.0, 1.0 })
    {
      wood.StartBranch(1, { 0.0, 0.0, 2.0 }, 0.012);
      wood.Grow({ side, 0.2, 2.5 }, 0.008);
      const int tip = wood.Grow({ 1.8 * side, -0.2, 3.0 }, 0.005);
      this->AddLeaf({ 1.8 * side, -0.2, 3.0 }, tip);
      this->AddLeaf({ 0.9 * side, 0.2, 2.5 }, tip - 1);
    }
    this->Settings.Pictures = 4;
    this->Settings.TextureSize = { 48, 32 };
    this->Species = MakeSpecies(wood, this->Settings.Options.Wood, this->Species.Leaves, this->Settings);
    this->Crown.Volume = CrownVolume{ CrownShape::Ellipsoid, { 0.0, 0.0, 1.5 }, 3.0, 2.5 };
    for (std::size_t point = 0; point < this->Crown.Leaves.Points.size(); ++point)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Points.push_back(static_cast<float>(this->Crown.Leaves.Points[point][axis]));
      }
    }
    this->Crown.LeafSkin = { this->Points.data(), nullptr };
    this->Crown.LeafBinding = { this->JointIds.data(), this->JointWeights.data(), this->Crown.Leaves.Points.size() };
  }
  SmallTree(const SmallTree&) = delete;

  void AddLeaf(const Vector3& foot, int node)
  {
    PlantMesh& mesh = this->Crown.Leaves;
    const int first = static_cast<int>(mesh.Points.size());
    for (const Vector3& corner :
      { Vector3(0.0), Vector3(-0.3, -0.3, 0.4), Vector3(0.0, 0.0, 0.8), Vector3(0.3, 0.3, 0.4) })
    {
      mesh.Points.push_back(foot + corner);
      mesh.Colors.push_back({ 80, 160, 40 });
      mesh.TCoords.push_back({ 0.5, 0.5 });
      this->JointIds.insert(this->JointIds.end(), { node, 0, 0, 0 });
      this->JointWeights.insert(this->JointWeights.end(), { 1.0f, 0.0f, 0.0f, 0.0f });
    }
    mesh.AddPolygon(std::array<int, 4>{ first, first + 1, first + 2, first + 3 });
    this->Species.Leaves.push_back({ { first, first + 1, first + 2, first + 3 }, node, 0.3 });
  }

  std::vector<TextureImage> PicturesIn(const WindAlong& wind) const
  {
    return CrownPictures(this->Species, this->Crown, wind.Field(), { 0.0, 0.0, 3.0 }, this->Settings);
  }
};

}

TEST(CrownPictures, AreProjectionsOfTheLeavesAtRestInCalm)
{
  const SmallTree tree;
  WindAlong calm;
  calm.Gusts = 0.0;
  WindAlong almost = calm; // the mean wind that carries nothing
  almost.Speed = 1e-30;
  almost.Spacing = 0.1e-30;
  const TextureImage rest = CylindricalProjection({ tree.Crown.Leaves, nullptr }, *tree.Crown.Volume, 48, 32);
  int opaque = 0;
  for (const Texel& texel : rest.Texels)
  {
    opaque += texel[3] > 0;
  }
  EXPECT_GT(opaque, 20);
  const std::vector<TextureImage> pictures = tree.PicturesIn(almost);
  ASSERT_EQ(pictures.size(), 4u);
  for (const TextureImage& picture : pictures)
  {
    EXPECT_EQ(picture.Texels, rest.Texels);
  }
}

TEST(CrownPictures, DifferInWind)
{
  const SmallTree tree;
  const std::vector<TextureImage> pictures = tree.PicturesIn(WindAlong());
  ASSERT_EQ(pictures.size(), 4u);
  for (std::size_t a = 0; a < 4; ++a)
  {
    for (std::size_t b = 0; b < a; ++b)
    {
      EXPECT_NE(pictures[a].Texels, pictures[b].Texels);
    }
  }
}

TEST(CrownPictures, GoAlongWithTheTrunk)
{
  // Leaves on the trunk that neither align nor flutter: the eye that goes along sees them at rest.
  SmallTree tree;
  for (std::size_t i = 0; i < tree.JointIds.size(); i += 4)
  {
    tree.JointIds[i] = 1;
  }
  tree.Crown.LeafBinding = { tree.JointIds.data(), tree.JointWeights.data(), tree.Crown.Leaves.Points.size() };
  tree.Settings.Leaves.MaximumAlignment = 0.0;
  tree.Settings.Leaves.FlutterAngle = 0.0;
  const TextureImage rest = CylindricalProjection({ tree.Crown.Leaves, nullptr }, *tree.Crown.Volume, 48, 32);
  for (const TextureImage& picture : tree.PicturesIn(WindAlong()))
  {
    EXPECT_EQ(picture.Texels, rest.Texels);
  }
}

TEST(CrownPictures, AreStillWhereNothingMoves)
{
  const WindAlong wind;
  SmallTree tree;
  const auto isStill = [&](const Texel& color) {
    const std::vector<TextureImage> pictures = tree.PicturesIn(wind);
    EXPECT_EQ(pictures.size(), 4u);
    for (const TextureImage& picture : pictures)
    {
      EXPECT_EQ(picture.Columns, 48);
      EXPECT_EQ(picture.Rows, 32);
      EXPECT_EQ(picture.Texels, std::vector<Texel>(48 * 32, color));
    }
  };
  tree.Crown.Volume.reset();
  isStill({ 255, 255, 255, 255 });
  tree.Crown.StillPicture = TextureImage(2, 3);
  tree.Crown.StillPicture.Texels.assign(6, { 1, 2, 3, 4 });
  isStill({ 1, 2, 3, 4 });
  tree.Crown.Volume = CrownVolume();
  tree.Species.Rest = Skeleton();
  isStill({ 1, 2, 3, 4 });
}

TEST(CrownPictures, TurnInWholeSwingsAPeriod)
{
  // 0.63 Hz in 10 s: six swings, of five pictures each 1/3 s.
  for (int k = 0; k < 90; ++k)
  {
    const double time = (k + 0.5) / 3.0;
    EXPECT_EQ(CrownPictureAt(time, 0.63, 10.0, 5), k % 5);
    EXPECT_EQ(CrownPictureAt(time - 70.0, 0.63, 10.0, 5), k % 5);
  }
  // At least one swing; and one picture is always the first.
  EXPECT_EQ(CrownPictureAt(5.1, 0.001, 10.0, 2), 1);
  EXPECT_EQ(CrownPictureAt(4.9, 0.001, 10.0, 2), 0);
  EXPECT_EQ(CrownPictureAt(-1e-300, 1.0, 10.0, 8), 7);
  EXPECT_EQ(CrownPictureAt(123.4, 1.0, 10.0, 1), 0);
}
