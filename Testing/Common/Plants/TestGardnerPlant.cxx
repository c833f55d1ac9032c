// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/Constants.h"
#include "Plants/GardnerPlant.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

using namespace littoral;

namespace
{

class GardnerPresets : public testing::TestWithParam<GardnerPreset>
{
};

GardnerTextureParameters Shifted()
{
  GardnerTextureParameters parameters;
  parameters.FrequencyY = 7.3;
  parameters.Origin = { 0.4, 2.1 };
  return parameters;
}

Vector3 AreaOf(const PlantMesh& mesh, int polygon)
{
  const int* corner = &mesh.Corners[mesh.Offsets[polygon]];
  const Vector3& a = mesh.Points[corner[0]];
  return 0.5 * glm::cross(mesh.Points[corner[1]] - a, mesh.Points[corner[2]] - a);
}

bool SameBytes(const PlantMesh& a, const PlantMesh& b)
{
  return a.Points == b.Points && a.Normals == b.Normals && a.TCoords == b.TCoords && a.Colors == b.Colors &&
    a.Corners == b.Corners && a.JointIds == b.JointIds;
}

/// The preset's plant of seed 1 with a medium crown: grown once for all cases.
const PlantPrototype& PrototypeOf(GardnerPreset preset, MediumCrown crown = MediumCrown::Leaves)
{
  static std::map<std::pair<GardnerPreset, MediumCrown>, PlantPrototype> prototypes;
  const auto [place, isNew] = prototypes.try_emplace({ preset, crown });
  if (isNew)
  {
    PlantLevelOptions options;
    options.Crown = crown;
    place->second = LevelsOf(GrowGardnerPlant(PresetParameters(preset)), options);
  }
  return place->second;
}

/// The leaves alone, which cost less than all levels.
PlantMesh LeavesOf(const GardnerPlantParameters& parameters)
{
  const GardnerPlant plant = GrowGardnerPlant(parameters);
  return QuadricMesh(plant, GardnerPicture(GardnerTexture(plant.Parameters.Texture), plant.Parameters.Shells));
}

/// Gardner's profile, 1 less the quadric's equation: 1 at the center, 0 on the surface, negative outside.
double Profile(const Quadric& quadric, const Vector3& position)
{
  const Vector3 away = position - quadric.Center;
  const double c = std::cos(quadric.Azimuth);
  const double s = std::sin(quadric.Azimuth);
  const Vector3 within = Vector3(c * away.x + s * away.y, c * away.y - s * away.x, away.z) / quadric.Axes;
  return 1.0 - glm::dot(within, within);
}

double OpaqueShare(const TextureImage& picture, int firstRow, int rows)
{
  int opaque = 0;
  for (int row = firstRow; row < firstRow + rows; ++row)
  {
    for (int column = 0; column < picture.Columns; ++column)
    {
      opaque += picture.At(column, row)[3] > 0 ? 1 : 0;
    }
  }
  return opaque / (static_cast<double>(rows) * picture.Columns);
}

}

TEST(GardnerTexture, IsThePublishedFormula)
{
  GardnerTextureParameters p;
  p.Terms = 4;
  p.Frequency = 2;
  p.FrequencyY = 3.0;
  p.Offset = 0.9;
  const GardnerTexture texture(p);
  const double h = 0.5 * Pi;
  const double sum = 1.0 + 0.707 + 0.707 * 0.707 + 0.707 * 0.707 * 0.707;
  const double k = 1.0 / (sum * sum * 1.9 * 1.9);
  for (const auto& [x, y] : { std::pair{ 0.0, 0.0 }, { 0.3, 1.1 }, { 2.7, 0.2 }, { 5.9, 3.0 } })
  {
    const double alongX = 1.0 * (std::sin(2.0 * x + h * std::sin(1.5 * y)) + 0.9) +
      0.707 * (std::sin(4.0 * x + h * std::sin(3.0 * y)) + 0.9) +
      0.707 * 0.707 * (std::sin(8.0 * x + h * std::sin(6.0 * y)) + 0.9) +
      0.707 * 0.707 * 0.707 * (std::sin(16.0 * x + h * std::sin(12.0 * y)) + 0.9);
    const double alongY = 1.0 * (std::sin(3.0 * y + h * std::sin(1.0 * x)) + 0.9) +
      0.707 * (std::sin(6.0 * y + h * std::sin(2.0 * x)) + 0.9) +
      0.707 * 0.707 * (std::sin(12.0 * y + h * std::sin(4.0 * x)) + 0.9) +
      0.707 * 0.707 * 0.707 * (std::sin(24.0 * y + h * std::sin(8.0 * x)) + 0.9);
    EXPECT_NEAR(texture.At(x, y), k * alongX * alongY, 1e-14);
  }
}

TEST(GardnerTexture, ClosesAroundTheQuadric)
{
  for (const int frequency : { 2, 6, 16 })
  {
    for (const int terms : { 4, 7 })
    {
      GardnerTextureParameters p = Shifted();
      p.Frequency = frequency;
      p.Terms = terms;
      const GardnerTexture texture(p);
      for (double x = 0.0; x < 6.0; x += 0.37)
      {
        EXPECT_NEAR(texture.At(x, 0.5 * x), texture.At(x + TwoPi, 0.5 * x), 1e-11);
      }
    }
  }
  // With an odd number of periods half of it does not close: this is why it is refused.
  GardnerTextureParameters odd = Shifted();
  odd.Frequency = 3;
  EXPECT_GT(std::abs(GardnerTexture(odd).At(0.2, 1.0) - GardnerTexture(odd).At(0.2 + TwoPi, 1.0)), 1e-3);
}

TEST(GardnerTexture, StaysWithinItsRange)
{
  const GardnerTexture texture(Shifted());
  double largest = 0.0;
  for (double x = 0.0; x < TwoPi; x += 0.01)
  {
    for (double y = 0.0; y < Pi; y += 0.01)
    {
      const double value = texture.At(x, y);
      ASSERT_GE(value, 0.0) << "both sums are positive with T0 = 1";
      largest = std::max(largest, value);
    }
  }
  EXPECT_LE(largest, 1.0);
  EXPECT_GT(largest, 0.5);
}

TEST(GardnerTexture, ThresholdsRunFromTheSilhouetteToTheCenter)
{
  const GardnerTextureParameters p;
  const GardnerTexture texture(p);
  EXPECT_DOUBLE_EQ(texture.Threshold(1.0), p.CenterThreshold);
  EXPECT_DOUBLE_EQ(texture.Threshold(0.0), p.SilhouetteThreshold);
  EXPECT_DOUBLE_EQ(texture.Threshold(0.5), 0.5 * (p.CenterThreshold + p.SilhouetteThreshold));
}

TEST(GardnerTexture, ShellsAreAsOpaqueAsTheFunctionIsAboveTheirThreshold)
{
  const GardnerTexture texture(Shifted());
  for (const int shells : { 2, 3, 8 })
  {
    const TextureImage picture = GardnerPicture(texture, shells);
    ASSERT_EQ(picture.Columns, GardnerColumns);
    ASSERT_EQ(picture.Rows, SectionRows + ShellRows);
    const int rows = StripRows(shells);
    double before = 0.0;
    for (int shell = 0; shell < shells; ++shell)
    {
      const double profile = ShellProfile(shell, shells);
      int above = 0;
      for (int row = 0; row < rows; ++row)
      {
        for (int column = 0; column < GardnerColumns; ++column)
        {
          above +=
            texture.At(TwoPi * (column + 0.5) / GardnerColumns, Pi * (row + 0.5) / rows) > texture.Threshold(profile)
            ? 1
            : 0;
        }
      }
      const double share = OpaqueShare(picture, SectionRows + shell * rows, rows);
      EXPECT_DOUBLE_EQ(share, above / (static_cast<double>(rows) * GardnerColumns));
      EXPECT_GT(share, before) << "the share grows inwards";
      before = share;
    }
    EXPECT_GT(before, 0.8);
  }
}

TEST(GardnerTexture, SectionsAreOutlinesThatThinOutTowardsTheirRim)
{
  const TextureImage picture = GardnerPicture(GardnerTexture(Shifted()), 3);
  constexpr int Bins = 4;
  int all[Bins] = {};
  int opaque[Bins] = {};
  for (int row = 0; row < SectionRows; ++row)
  {
    for (int column = 0; column < GardnerColumns; ++column)
    {
      const double across = 2.0 * (column % (GardnerColumns / 2) + 0.5) / (GardnerColumns / 2) - 1.0;
      const double profile = 1.0 - across * across - std::pow(2.0 * (row + 0.5) / SectionRows - 1.0, 2.0);
      if (profile < 0.0)
      {
        EXPECT_EQ(picture.At(column, row)[3], 0) << "outside of the outline";
        continue;
      }
      ++all[static_cast<int>(Bins * profile)];
      opaque[static_cast<int>(Bins * profile)] += picture.At(column, row)[3] > 0 ? 1 : 0;
    }
  }
  for (int bin = 1; bin < Bins; ++bin)
  {
    EXPECT_GT(static_cast<double>(opaque[bin]) / all[bin], static_cast<double>(opaque[bin - 1]) / all[bin - 1]);
  }
}

TEST(GardnerTexture, ShadeFollowsT)
{
  const GardnerTexture texture(Shifted());
  const TextureImage picture = GardnerPicture(texture, 2);
  double light[2] = { 0.0, 0.0 };
  int count[2] = { 0, 0 };
  for (int row = 0; row < StripRows(2); ++row)
  {
    for (int column = 0; column < GardnerColumns; ++column)
    {
      const double value = texture.At(TwoPi * (column + 0.5) / GardnerColumns, Pi * (row + 0.5) / StripRows(2));
      const int bright = value > 0.25 ? 1 : 0;
      light[bright] += picture.At(column, SectionRows + row)[1];
      ++count[bright];
    }
  }
  EXPECT_GT(light[1] / count[1], 1.15 * light[0] / count[0]);
}

TEST(Quadric, PointsSatisfyItsEquation)
{
  const Quadric quadric{ { 1.0, -2.0, 5.0 }, { 1.5, 0.7, 2.2 }, 0.8, 0, { 0.0, 0.0 } };
  EXPECT_DOUBLE_EQ(Profile(quadric, quadric.Center), 1.0);
  for (double angle = 0.1; angle < 3.1; angle += 0.3)
  {
    for (double longitude = 0.0; longitude < 6.2; longitude += 0.4)
    {
      const Vector3 away{ std::sin(angle) * std::cos(longitude), std::sin(angle) * std::sin(longitude),
        std::cos(angle) };
      const Vector3 place = PointOf(quadric, away);
      EXPECT_NEAR(Profile(quadric, place), 0.0, 1e-12);
      EXPECT_NEAR(Profile(quadric, PointOf(quadric, 0.6 * away)), 1.0 - 0.36, 1e-12);
      // The outward direction is that in which the profile falls fastest.
      const double step = 1e-6;
      Vector3 gradient;
      for (int axis = 0; axis < 3; ++axis)
      {
        Vector3 beside = place;
        beside[axis] += step;
        gradient[axis] = (Profile(quadric, place) - Profile(quadric, beside)) / step;
      }
      EXPECT_GT(glm::dot(glm::normalize(gradient), Outward(quadric, away)), 1.0 - 1e-9);
    }
  }
}

TEST_P(GardnerPresets, GrowsASoundPlantInItsCrown)
{
  GardnerPlantParameters parameters = PresetParameters(GetParam());
  ASSERT_EQ(WhyInvalid(parameters), "");
  const CrownVolume crown = CrownOf(parameters);
  for (int seed = 1; seed <= 12; ++seed)
  {
    parameters.Seed = seed;
    const GardnerPlant plant = GrowGardnerPlant(parameters);
    ASSERT_EQ(WhyInvalid(plant.Wood), "");
    ASSERT_EQ(plant.Quadrics.size(), static_cast<std::size_t>(parameters.NumberOfQuadrics));
    double highest = 0.0;
    double widest = 0.0;
    for (const Quadric& quadric : plant.Quadrics)
    {
      for (double angle = 0.0; angle < Pi; angle += 0.05)
      {
        for (double longitude = 0.0; longitude < TwoPi; longitude += 0.05)
        {
          const Vector3 place = PointOf(
            quadric, { std::sin(angle) * std::cos(longitude), std::sin(angle) * std::sin(longitude), std::cos(angle) });
          ASSERT_GE(Depth(crown, place), 0.0);
          highest = std::max(highest, place.z);
          widest = std::max(widest, std::hypot(place.x, place.y));
        }
      }
      // It hangs on its limb, or on the trunk beside it.
      ASSERT_LT(glm::distance(plant.Wood.Nodes[quadric.Node].Position, quadric.Center), 0.15 * parameters.Height);
    }
    EXPECT_GT(highest, 0.85 * parameters.Height);
    EXPECT_GT(widest, 0.85 * parameters.CrownRadius);
  }
}

TEST_P(GardnerPresets, MeshesAreSound)
{
  const GardnerPlant plant = GrowGardnerPlant(PresetParameters(GetParam()));
  const PlantPrototype& prototype = PrototypeOf(GetParam());
  const PlantMesh& mesh = prototype.Leaves;
  std::set<int> used;
  for (int polygon = 0; polygon < mesh.NumberOfPolygons(); ++polygon)
  {
    ASSERT_EQ(mesh.Offsets[polygon + 1] - mesh.Offsets[polygon], 3);
    EXPECT_GT(glm::length(AreaOf(mesh, polygon)), 1e-9);
    const int* corner = &mesh.Corners[mesh.Offsets[polygon]];
    used.insert(corner, corner + 3);
    EXPECT_EQ(mesh.JointIds[corner[0]], mesh.JointIds[corner[1]]) << "a triangle on two limbs";
    EXPECT_EQ(mesh.JointIds[corner[0]], mesh.JointIds[corner[2]]);
  }
  EXPECT_EQ(used.size(), mesh.Points.size()) << "vertices without triangles";
  EXPECT_GT(mesh.NumberOfPolygons(), 5000);
  EXPECT_LT(mesh.NumberOfPolygons(), 40000);
  const CrownVolume crown = CrownOf(plant.Parameters);
  for (std::size_t vertex = 0; vertex < mesh.Points.size(); ++vertex)
  {
    EXPECT_GE(Depth(crown, mesh.Points[vertex]), 0.0);
    EXPECT_NEAR(glm::length(mesh.Normals[vertex]), 1.0, 1e-12);
    for (const double coordinate : mesh.TCoords[vertex])
    {
      EXPECT_GE(coordinate, 0.0);
      EXPECT_LE(coordinate, 1.0);
    }
    EXPECT_GT(mesh.Colors[vertex][0] + mesh.Colors[vertex][1] + mesh.Colors[vertex][2], 20) << "a black leaf";
  }
  EXPECT_EQ(prototype.Low.NumberOfPolygons(), 4);
  for (const Vector3& point : PrototypeOf(GetParam(), MediumCrown::Envelope).Crown.Points)
  {
    EXPECT_GE(Depth(crown, point), 0.0) << "the medium crown reaches out of the bounding volume";
  }
  const CrownVolume seen = SeenCrown(plant, prototype.LeafTexture);
  EXPECT_LT(seen.Radius, crown.Radius);
  EXPECT_GT(seen.Radius, 0.8 * crown.Radius);
}

TEST_P(GardnerPresets, IsAFunctionOfItsSeed)
{
  GardnerPlantParameters parameters = PresetParameters(GetParam());
  const PlantPrototype& one = PrototypeOf(GetParam());
  const PlantPrototype same = LevelsOf(GrowGardnerPlant(parameters), {});
  EXPECT_TRUE(SameBytes(one.Leaves, same.Leaves));
  EXPECT_EQ(one.LeafTexture.Texels, same.LeafTexture.Texels);
  EXPECT_EQ(one.CrownTexture.Texels, same.CrownTexture.Texels);
  parameters.Seed = 2;
  const GardnerPlant other = GrowGardnerPlant(parameters);
  const TextureImage picture = GardnerPicture(GardnerTexture(other.Parameters.Texture), other.Parameters.Shells);
  EXPECT_FALSE(SameBytes(one.Leaves, QuadricMesh(other, picture)));
  EXPECT_NE(one.LeafTexture.Texels, picture.Texels);
}

TEST_P(GardnerPresets, ThePictureOfTheCrownIsFullInItsMiddleAndOpenAtItsRim)
{
  const TextureImage& picture = PrototypeOf(GetParam(), MediumCrown::Envelope).CrownTexture;
  EXPECT_GT(OpaqueShare(picture, picture.Rows / 3, picture.Rows / 3), 0.85);
  EXPECT_LT(OpaqueShare(picture, 0, picture.Rows), 0.99);
  std::set<int> shades;
  for (const Texel& texel : picture.Texels)
  {
    shades.insert(texel[1]);
  }
  EXPECT_GT(shades.size(), 30U);
}

namespace
{

std::vector<GardnerPreset> AllKinds()
{
  std::vector<GardnerPreset> presets;
  for (int preset = 1; preset < NumberOfGardnerPresets; ++preset)
  {
    presets.push_back(static_cast<GardnerPreset>(preset));
  }
  return presets;
}

}

INSTANTIATE_TEST_SUITE_P(
  Kinds, GardnerPresets, testing::ValuesIn(AllKinds()), [](const auto& one) { return TraitsOf(one.param).Name; });

TEST(GardnerPlant, ShellsAreNested)
{
  GardnerPlantParameters parameters;
  parameters.NumberOfQuadrics = 1;
  parameters.Shells = 4;
  // Opaque everywhere, so that no triangle is left out.
  parameters.Texture.CenterThreshold = parameters.Texture.SilhouetteThreshold = 0.0;
  const GardnerPlant plant = GrowGardnerPlant(parameters);
  const TextureImage picture = GardnerPicture(GardnerTexture(plant.Parameters.Texture), parameters.Shells);
  const PlantMesh mesh = QuadricMesh(plant, picture);
  std::map<int, std::set<int>> profiles; // in millionths, by shell
  for (std::size_t vertex = 0; vertex < mesh.Points.size(); ++vertex)
  {
    const double row = mesh.TCoords[vertex][1] * picture.Rows;
    const double profile = Profile(plant.Quadrics[0], mesh.Points[vertex]);
    if (row >= SectionRows)
    {
      const int shell = static_cast<int>((row - SectionRows) / StripRows(parameters.Shells));
      EXPECT_NEAR(profile, ShellProfile(shell, parameters.Shells), 1e-12);
      profiles[shell].insert(static_cast<int>(1e6 * profile + 0.5));
    }
    else
    {
      EXPECT_GE(profile, -1e-12) << "a section reaches out of its quadric";
    }
  }
  ASSERT_EQ(profiles.size(), 4U);
  for (int shell = 1; shell < 4; ++shell)
  {
    EXPECT_GT(*profiles[shell].begin(), *profiles[shell - 1].rbegin());
  }
}

TEST(GardnerPlant, TrianglesThatShowNothingAreLeftOut)
{
  GardnerPlantParameters parameters;
  const int some = LeavesOf(parameters).NumberOfPolygons();
  parameters.Texture.SilhouetteThreshold = parameters.Texture.CenterThreshold;
  const int full = LeavesOf(parameters).NumberOfPolygons();
  parameters.Texture.CenterThreshold = parameters.Texture.SilhouetteThreshold = 1.0;
  const int none = LeavesOf(parameters).NumberOfPolygons();
  EXPECT_LT(some, full);
  EXPECT_EQ(none, 0);
}

TEST(GardnerPlant, NamesBadParameters)
{
  const auto names = [](const char* word, void (*spoil)(GardnerPlantParameters&)) {
    GardnerPlantParameters parameters;
    spoil(parameters);
    return WhyInvalid(parameters).rfind(word, 0) == 0;
  };
  EXPECT_TRUE(names("Height", [](GardnerPlantParameters& p) { p.Height = std::numeric_limits<double>::infinity(); }));
  EXPECT_TRUE(names("CrownRadius", [](GardnerPlantParameters& p) { p.CrownRadius = 0.0; }));
  EXPECT_TRUE(names("CrownBase", [](GardnerPlantParameters& p) { p.CrownBase = p.Height; }));
  EXPECT_TRUE(names("TrunkRadius", [](GardnerPlantParameters& p) { p.TrunkRadius = -1.0; }));
  EXPECT_TRUE(names("NumberOfQuadrics", [](GardnerPlantParameters& p) { p.NumberOfQuadrics = 0; }));
  EXPECT_TRUE(names("Shells", [](GardnerPlantParameters& p) { p.Shells = 1; }));
  EXPECT_TRUE(names("Terms", [](GardnerPlantParameters& p) { p.Texture.Terms = 8; }));
  EXPECT_TRUE(names("Frequency", [](GardnerPlantParameters& p) { p.Texture.Frequency = 5; }));
  EXPECT_TRUE(names("Offset", [](GardnerPlantParameters& p) { p.Texture.Offset = -0.1; }));
  EXPECT_TRUE(names("CenterThreshold", [](GardnerPlantParameters& p) { p.Texture.CenterThreshold = 0.5; }));
  EXPECT_TRUE(names("SilhouetteThreshold",
    [](GardnerPlantParameters& p) { p.Texture.SilhouetteThreshold = std::numeric_limits<double>::quiet_NaN(); }));
  EXPECT_TRUE(names("Variation", [](GardnerPlantParameters& p) { p.Variation = 0.6; }));
}
