// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "../ProcessTeam.h"
#include "Numerics/Constants.h"
#include "Plants/CylindricalProjection.h"
#include "Plants/PlantLevels.h"
#include "Plants/ReevesTree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

using namespace littoral;

namespace
{

const TreePreset Species[] = { TreePreset::Pine, TreePreset::Oak, TreePreset::Birch, TreePreset::Shrub };

Vector3 AreaOf(const PlantMesh& mesh, int polygon)
{
  const int first = mesh.Offsets[polygon];
  Vector3 area{ 0.0, 0.0, 0.0 };
  for (int i = first + 1; i + 1 < mesh.Offsets[polygon + 1]; ++i)
  {
    const Vector3& a = mesh.Points[mesh.Corners[first]];
    area += 0.5 * glm::cross(mesh.Points[mesh.Corners[i]] - a, mesh.Points[mesh.Corners[i + 1]] - a);
  }
  return area;
}

/// Whether each edge, told by the places of its ends, belongs to one polygon in each direction.
bool IsClosed(const PlantMesh& mesh)
{
  using Place = std::array<double, 3>;
  const auto placeOf = [&](int corner) {
    const Vector3& p = mesh.Points[mesh.Corners[corner]];
    return Place{ p.x, p.y, p.z };
  };
  std::map<std::pair<Place, Place>, int> edges;
  for (int polygon = 0; polygon < mesh.NumberOfPolygons(); ++polygon)
  {
    const int first = mesh.Offsets[polygon];
    const int end = mesh.Offsets[polygon + 1];
    for (int corner = first; corner < end; ++corner)
    {
      const int next = corner + 1 < end ? corner + 1 : first;
      ++edges[{ placeOf(corner), placeOf(next) }];
    }
  }
  for (const auto& [edge, count] : edges)
  {
    const auto opposite = edges.find({ edge.second, edge.first });
    if (count != 1 || opposite == edges.end())
    {
      return false;
    }
  }
  return !edges.empty();
}

/// A square plate at a distance from the axis, `half` wide to both sides and up and down about a height [m].
PlantMesh Plate(double distance, double half, double height, const Color& color)
{
  PlantMesh mesh;
  for (const auto& corner : { std::array<double, 2>{ -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } })
  {
    mesh.Points.push_back({ distance, half * corner[0], height + half * corner[1] });
    mesh.Colors.push_back(color);
    mesh.TCoords.push_back({ 0.5 + 0.5 * corner[0], 0.5 + 0.5 * corner[1] });
  }
  mesh.AddPolygon(std::array<int, 4>{ 0, 1, 2, 3 });
  return mesh;
}

}

TEST(PlantLevels, LowIsFourRectanglesAroundThePlant)
{
  for (const TreePreset preset : Species)
  {
    const PlantPrototype tree = LevelsOf(GrowReevesTree(PresetParameters(preset)), {});
    const PlantExtent& extent = tree.Impostor.Shape.Extent;
    const double margin = ImpostorSize / (ImpostorSize - 4.0);
    ASSERT_EQ(tree.Low.NumberOfPolygons(), 4);
    ASSERT_EQ(tree.Low.TCoords.size(), 16U);
    EXPECT_EQ(tree.Low.Colors, std::vector<Color>(16, tree.Impostor.Mean));
    for (int polygon = 0; polygon < 4; ++polygon)
    {
      const double tall = polygon < 3 ? extent.High - extent.Low : 2.0 * extent.Radius;
      EXPECT_NEAR(glm::length(AreaOf(tree.Low, polygon)), margin * margin * 2.0 * extent.Radius * tall, 1e-9);
    }
    EXPECT_NEAR(extent.Low, 0.0, 0.3);
    EXPECT_NEAR(extent.High, PresetParameters(preset).Height, 0.1 * PresetParameters(preset).Height);
  }
}

TEST(PlantLevels, TheEnvelopeIsClosedAndWithinItsVolumeHoweverItIsJittered)
{
  for (const CrownShape shape : { CrownShape::Cone, CrownShape::Ellipsoid })
  {
    const CrownVolume crown{ shape, { 1.0, -2.0, 3.0 }, 7.0, 2.5 };
    for (const double jitter : { 0.0, 0.15, 0.5 })
    {
      PlantLevelOptions options;
      options.CrownJitter = jitter;
      const PlantMesh mesh = CrownEnvelope(crown, options);
      EXPECT_TRUE(IsClosed(mesh));
      Vector3 sum{ 0.0, 0.0, 0.0 };
      for (int polygon = 0; polygon < mesh.NumberOfPolygons(); ++polygon)
      {
        EXPECT_GT(glm::length(AreaOf(mesh, polygon)), 1e-6);
        sum += AreaOf(mesh, polygon);
      }
      EXPECT_LT(glm::length(sum), 1e-12);
      for (std::size_t i = 0; i < mesh.Points.size(); ++i)
      {
        const Vector3 away = mesh.Points[i] - crown.Foot;
        EXPECT_GE(away.z, 0.0);
        EXPECT_LE(away.z, crown.Height);
        const double up = away.z / crown.Height;
        const double widest = shape == CrownShape::Cone ? 1.0 - up : 2.0 * std::sqrt(std::max(0.0, up * (1.0 - up)));
        EXPECT_LE(std::hypot(away.x, away.y), crown.Radius * widest * (1.0 + 1e-12) + 1e-12);
        EXPECT_NEAR(mesh.TCoords[i][1], up, 1e-12);
      }
    }
  }
}

TEST(PlantLevels, ProcessesSharePicturesFromAfar)
{
  ReevesTreeParameters parameters = PresetParameters(TreePreset::Shrub);
  parameters.NumberOfLeaves = 40;
  std::uint64_t ofPlant = 0;
  PlantLevelOptions options;
  options.ShareOf = [&](std::uint64_t key) {
    ofPlant = key;
    return WorkShare();
  };
  const PlantPrototype plant = LevelsOf(GrowReevesTree(parameters), options);
  const PlantImpostor& alone = plant.Impostor;
  EXPECT_GT(std::set<Texel>(alone.Pictures.Texels.begin(), alone.Pictures.Texels.end()).size(), 50u);
  const std::vector<DrawnMesh> meshes{ { plant.Skin }, { plant.Leaves, &plant.LeafTexture } };
  EXPECT_EQ(KeyOf(meshes), ofPlant);
  PlantMesh other = plant.Leaves;
  other.Colors.back()[0] ^= 1;
  EXPECT_NE(KeyOf({ { plant.Skin }, { other, &plant.LeafTexture } }), ofPlant);
  for (const std::size_t ranks : { 3, 30 }) // more than views too
  {
    littoral::testing::ProcessTeam(ranks).Run([&](const WorkShare& share) {
      const PlantImpostor impostor = ImpostorOf(meshes, alone.Shape.Extent, SerialFor, share);
      EXPECT_EQ(impostor.Pictures.Texels, alone.Pictures.Texels) << share.Rank << " of " << ranks;
      EXPECT_EQ(impostor.Normals, alone.Normals);
      EXPECT_EQ(impostor.Shape.Areas, alone.Shape.Areas);
      EXPECT_EQ(impostor.Mean, alone.Mean);
      EXPECT_EQ(impostor.TextureMean, alone.TextureMean);
    });
  }
}

TEST(PlantLevels, EnvelopePolygonsFaceOutwards)
{
  for (const CrownShape shape : { CrownShape::Cone, CrownShape::Ellipsoid })
  {
    const CrownVolume crown{ shape, { 0.0, 0.0, 3.0 }, 7.0, 2.5 };
    const PlantMesh mesh = CrownEnvelope(crown, {});
    const Vector3 inside{ 0.0, 0.0, 5.0 };
    for (int polygon = 0; polygon < mesh.NumberOfPolygons(); ++polygon)
    {
      const Vector3& corner = mesh.Points[mesh.Corners[mesh.Offsets[polygon]]];
      EXPECT_GT(glm::dot(AreaOf(mesh, polygon), corner - inside), 0.0);
    }
  }
}

TEST(CylindricalProjection, APlateIsSeenWhereItStands)
{
  const CrownVolume crown{ CrownShape::Ellipsoid, { 0.0, 0.0, 0.0 }, 10.0, 5.0 };
  const PlantMesh plate = Plate(3.0, 1.0, 6.0, { 200, 100, 50 });
  const TextureImage picture = CylindricalProjection({ plate, nullptr }, crown, 360, 100);
  const double reach = std::atan2(1.0, 3.0) * 180.0 / Pi; // [degrees] to both sides
  for (int column = 0; column < 360; ++column)
  {
    const double angle = std::abs(std::remainder(column + 0.5, 360.0));
    const double beside = angle - reach;
    for (int row = 0; row < 100; ++row)
    {
      const double above = std::abs(0.1 * (row + 0.5) - 6.0) - 1.0;
      if (beside < -1.0 && above < -0.1)
      {
        EXPECT_EQ(picture.At(column, row), (Texel{ 200, 100, 50, 255 }));
      }
      else if (beside > 1.0 || above > 0.1)
      {
        EXPECT_EQ(picture.At(column, row)[3], 0);
      }
    }
  }
}

TEST(CylindricalProjection, TheOutermostIsSeenAndTransparentTexelsAreLookedThrough)
{
  const CrownVolume crown{ CrownShape::Ellipsoid, { 0.0, 0.0, 0.0 }, 10.0, 5.0 };
  // Opaque where u < 0.5 of the texture, that is at y < 0 of the outer plate, and all over the inner one.
  PlantMesh both = Plate(4.0, 1.0, 5.0, { 250, 10, 10 });
  const PlantMesh inner = Plate(1.0, 1.0, 5.0, { 10, 250, 10 });
  both.Points.insert(both.Points.end(), inner.Points.begin(), inner.Points.end());
  both.Colors.insert(both.Colors.end(), inner.Colors.begin(), inner.Colors.end());
  both.TCoords.insert(both.TCoords.end(), 4, { 0.1, 0.5 });
  both.AddPolygon(std::array<int, 4>{ 4, 5, 6, 7 });
  TextureImage half(2, 1);
  half.At(0, 0) = { 255, 255, 255, 255 };
  half.At(1, 0) = { 255, 255, 255, 0 };
  const TextureImage picture = CylindricalProjection({ both, &half }, crown, 720, 100);
  EXPECT_EQ(picture.At(720 - 6, 50), (Texel{ 250, 10, 10, 255 })) << "y < 0, where the outer plate is opaque";
  EXPECT_EQ(picture.At(6, 50), (Texel{ 10, 250, 10, 255 })) << "y > 0, where it is not";
  EXPECT_EQ(picture.At(360, 50)[3], 0) << "behind the axis";
}

TEST(CylindricalProjection, ATreeIsDenseInItsMiddleAndOpenAtItsRim)
{
  for (const TreePreset preset : Species)
  {
    PlantLevelOptions options;
    options.Crown = MediumCrown::Envelope;
    const PlantPrototype tree = LevelsOf(GrowReevesTree(PresetParameters(preset)), options);
    const TextureImage& picture = tree.CrownTexture;
    double share = 0.0;
    std::set<int> shades;
    for (const Texel& texel : picture.Texels)
    {
      share += texel[3] / 255.0 / static_cast<double>(picture.Texels.size());
      shades.insert(texel[1]);
    }
    EXPECT_GT(share, 0.35);
    EXPECT_LT(share, 0.999);
    EXPECT_GT(shades.size(), 30U);
  }
}

TEST(PlantLevels, LeavesLieInTheirPlaneAndFollowOneJoint)
{
  const Plant plant = GrowReevesTree(PresetParameters(TreePreset::Oak));
  const PlantPrototype tree = LevelsOf(plant, {});
  ASSERT_EQ(tree.Leaves.NumberOfPolygons(), static_cast<int>(plant.Leaves.size()));
  for (int leaf = 0; leaf < tree.Leaves.NumberOfPolygons(); ++leaf)
  {
    const LeafParticle& particle = plant.Leaves[leaf];
    const Vector3 area = AreaOf(tree.Leaves, leaf);
    EXPECT_NEAR(glm::length(area), 0.5 * particle.Width * particle.Size * particle.Size, 1e-9);
    EXPECT_GT(glm::dot(glm::normalize(area), particle.Facing), 1.0 - 1e-9);
    EXPECT_EQ(tree.Leaves.JointIds[4 * leaf + 2][0], particle.Node);
  }
}
