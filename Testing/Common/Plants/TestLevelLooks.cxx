// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// A plant looks the same at all levels of detail: as much is covered, in the same mean color. Seen by ray casting here.
#include "Numerics/Constants.h"
#include "Plants/AonoKuniiTree.h"
#include "Plants/GardnerPlant.h"
#include "Plants/PlantLevels.h"
#include "Plants/PlantScatter.h"
#include "Plants/ReevesTree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>

using namespace littoral;

namespace
{

constexpr int Pixels = 160; // along an edge
constexpr double Bound = 0.1;

/// Azimuths and elevations [degrees] between those of the pictures, and some of these.
constexpr double Directions[6][2] = { { 0.0, 0.0 }, { 28.0, 5.0 }, { 143.0, 17.0 }, { 221.0, 34.0 }, { 312.0, 56.0 },
  { 65.0, 83.0 } };

struct Seen
{
  double Covered = 0.0; // pixels
  double Color[3] = { 0.0, 0.0, 0.0 };
};

/// Red, green, blue and alpha at a place, between the middles of four texels.
std::array<double, 4> Interpolated(const TextureImage& image, double u, double v)
{
  const double x = u * image.Columns - 0.5;
  const double y = v * image.Rows - 0.5;
  const int column = static_cast<int>(std::floor(x));
  const int row = static_cast<int>(std::floor(y));
  std::array<double, 4> sum{};
  for (int corner = 0; corner < 4; ++corner)
  {
    const int i = corner % 2;
    const int j = corner / 2;
    const double weight = (i ? x - column : 1.0 - (x - column)) * (j ? y - row : 1.0 - (y - row));
    const Texel& texel = image.At(std::clamp(column + i, 0, image.Columns - 1), std::clamp(row + j, 0, image.Rows - 1));
    for (int channel = 0; channel < 4; ++channel)
    {
      sum[channel] += weight * texel[channel] / 255.0;
    }
  }
  return sum;
}

/// Parallel rays through a square about a middle, and the nearest opaque hit of each.
class Eye
{
public:
  Eye(const Vector3& middle, double half, const Vector3& towards)
    : Middle(middle)
    , Half(half)
    , Towards(towards)
    , Right(std::abs(towards.z) < 0.999 ? glm::normalize(glm::cross(Vector3(0.0, 0.0, 1.0), towards))
                                        : Vector3(0.0, 1.0, 0.0))
    , Up(glm::cross(towards, this->Right))
    , Depths(Pixels * Pixels, -1e300)
    , Colors(Pixels * Pixels)
  {
  }

  void Look(const DrawnMesh& drawn)
  {
    for (int polygon = 0; polygon < drawn.Mesh.NumberOfPolygons(); ++polygon)
    {
      const int* corners = &drawn.Mesh.Corners[drawn.Mesh.Offsets[polygon]];
      const int count = drawn.Mesh.Offsets[polygon + 1] - drawn.Mesh.Offsets[polygon];
      for (int i = 2; i < count; ++i)
      {
        this->Meet(drawn, { corners[0], corners[i - 1], corners[i] });
      }
    }
  }

  Seen Sum() const
  {
    Seen seen;
    for (std::size_t pixel = 0; pixel < this->Depths.size(); ++pixel)
    {
      if (this->Depths[pixel] > -1e299)
      {
        seen.Covered += 1.0;
        for (int channel = 0; channel < 3; ++channel)
        {
          seen.Color[channel] += this->Colors[pixel][channel];
        }
      }
    }
    return seen;
  }

private:
  Vector3 Middle;
  double Half;
  Vector3 Towards;
  Vector3 Right;
  Vector3 Up;
  std::vector<double> Depths;
  std::vector<std::array<double, 3>> Colors;

  int PixelOf(double along) const { return static_cast<int>(std::floor((along / this->Half + 1.0) * 0.5 * Pixels)); }

  /// Moller and Trumbore's test of the rays near a triangle.
  void Meet(const DrawnMesh& drawn, const std::array<int, 3>& corners)
  {
    int box[4] = { Pixels, -1, Pixels, -1 };
    for (const int corner : corners)
    {
      const Vector3 away = drawn.Mesh.Points[corner] - this->Middle;
      const int column = this->PixelOf(glm::dot(away, this->Right));
      const int row = this->PixelOf(glm::dot(away, this->Up));
      box[0] = std::min(box[0], column);
      box[1] = std::max(box[1], column);
      box[2] = std::min(box[2], row);
      box[3] = std::max(box[3], row);
    }
    const Vector3& a = drawn.Mesh.Points[corners[0]];
    const Vector3 e1 = drawn.Mesh.Points[corners[1]] - a;
    const Vector3 e2 = drawn.Mesh.Points[corners[2]] - a;
    const Vector3 p = glm::cross(this->Towards, e2);
    const double determinant = glm::dot(e1, p);
    for (int row = std::max(0, box[2]); determinant != 0.0 && row <= std::min(Pixels - 1, box[3]); ++row)
    {
      for (int column = std::max(0, box[0]); column <= std::min(Pixels - 1, box[1]); ++column)
      {
        const Vector3 origin = this->Middle + (2.0 * (column + 0.5) / Pixels - 1.0) * this->Half * this->Right +
          (2.0 * (row + 0.5) / Pixels - 1.0) * this->Half * this->Up;
        const Vector3 s = origin - a;
        const double v = glm::dot(s, p) / determinant;
        const Vector3 q = glm::cross(s, e1);
        const double w = glm::dot(this->Towards, q) / determinant;
        const double depth = glm::dot(e2, q) / determinant;
        if (v >= 0.0 && w >= 0.0 && v + w <= 1.0 && depth > this->Depths[row * Pixels + column])
        {
          this->Shade(drawn, corners, { 1.0 - v - w, v, w }, depth, row * Pixels + column);
        }
      }
    }
  }

  void Shade(const DrawnMesh& drawn, const std::array<int, 3>& corners, const std::array<double, 3>& weights,
    double depth, int pixel)
  {
    std::array<double, 4> texel{ 1.0, 1.0, 1.0, 1.0 };
    if (drawn.Texture)
    {
      double at[2] = { 0.0, 0.0 };
      for (int i = 0; i < 3; ++i)
      {
        at[0] += weights[i] * drawn.Mesh.TCoords[corners[i]][0];
        at[1] += weights[i] * drawn.Mesh.TCoords[corners[i]][1];
      }
      texel = Interpolated(*drawn.Texture, at[0], at[1]);
    }
    if (texel[3] < 0.5)
    {
      return;
    }
    this->Depths[pixel] = depth;
    for (int channel = 0; channel < 3; ++channel)
    {
      double color = 0.0;
      for (int i = 0; i < 3; ++i)
      {
        color += weights[i] * drawn.Mesh.Colors[corners[i]][channel];
      }
      this->Colors[pixel][channel] = color * texel[channel] / (drawn.Texture ? drawn.TextureMean[channel] : 1.0);
    }
  }
};

/// The mesh of a prototype at a plant's site.
PlantMesh AtSite(PlantMesh mesh, const PlantPlace& place)
{
  for (Vector3& point : mesh.Points)
  {
    const Vector3 p = place.Scale * point;
    point = place.Foot +
      Vector3(std::cos(place.Azimuth) * p.x - std::sin(place.Azimuth) * p.y,
        std::sin(place.Azimuth) * p.x + std::cos(place.Azimuth) * p.y, p.z);
  }
  return mesh;
}

PlantMesh CardAtSite(const PlantPrototype& plant, const PlantPlace& place, const View& view)
{
  const ImpostorCard card = FacingCard(plant.Impostor.Shape, place, view);
  const auto tcoords = CardTCoords(card.View);
  PlantMesh mesh;
  mesh.Points.assign(card.Corners.begin(), card.Corners.end());
  mesh.TCoords.assign(tcoords.begin(), tcoords.end());
  mesh.Colors.assign(4, plant.Impostor.Mean);
  mesh.AddPolygon(std::array<int, 4>{ 0, 1, 2, 3 });
  return mesh;
}

void ExpectAlike(const Seen& full, const Seen& level, const std::string& what)
{
  EXPECT_NEAR(level.Covered / full.Covered, 1.0, Bound) << what;
  for (int channel = 0; channel < 3; ++channel)
  {
    const double ratio = level.Color[channel] / level.Covered / (full.Color[channel] / full.Covered);
    EXPECT_NEAR(ratio, 1.0, Bound) << what << " channel " << channel;
  }
}

void ExpectSameLooks(const PlantPrototype& plant, const std::string& name)
{
  PlantPlace place;
  place.Foot = { 40.0, -30.0, 5.0 };
  place.Scale = 1.2;
  place.Azimuth = 1.1;
  const PlantMesh skin = AtSite(plant.Skin, place);
  const PlantMesh leaves = AtSite(plant.Leaves, place);
  const PlantMesh trunk = AtSite(plant.Trunk, place);
  const PlantMesh crown = AtSite(plant.Crown, place);
  const PlantExtent& extent = plant.Impostor.Shape.Extent;
  const Vector3 middle = place.Foot + Vector3(0.0, 0.0, 0.5 * place.Scale * (extent.Low + extent.High));
  const double half = 1.3 * place.Scale * std::hypot(extent.Radius, 0.5 * (extent.High - extent.Low));
  for (const auto& [azimuth, elevation] : Directions)
  {
    const double a = azimuth * Pi / 180.0;
    const double e = elevation * Pi / 180.0;
    const Vector3 towards{ std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e) };
    View view;
    view.Point = middle + 150.0 * towards;
    Eye full(middle, half, towards);
    full.Look({ skin });
    full.Look({ leaves, &plant.LeafTexture });
    Eye medium(middle, half, towards);
    medium.Look({ trunk });
    medium.Look({ crown, &plant.CrownTexture, plant.CrownTextureMean });
    Eye low(middle, half, towards);
    low.Look({ CardAtSite(plant, place, view), &plant.Impostor.Pictures, plant.Impostor.TextureMean });
    const std::string from = name + " from " + std::to_string(azimuth) + " " + std::to_string(elevation);
    ExpectAlike(full.Sum(), medium.Sum(), from + ", Medium");
    ExpectAlike(full.Sum(), low.Sum(), from + ", Low");
  }
}

}

TEST(LevelLooks, ReevesTreesLookTheSameAtAllLevels)
{
  for (int preset = 1; preset < NumberOfTreePresets; ++preset)
  {
    const auto tree = static_cast<TreePreset>(preset);
    ExpectSameLooks(LevelsOf(GrowReevesTree(PresetParameters(tree)), {}), TraitsOf(tree).Name);
  }
}

TEST(LevelLooks, AonoKuniiTreesLookTheSameAtAllLevels)
{
  for (int preset = 1; preset < NumberOfForkPresets; preset += 3)
  {
    const auto tree = static_cast<ForkPreset>(preset);
    ExpectSameLooks(LevelsOf(GrowAonoKuniiTree(PresetParameters(tree)), {}), "Aono-Kunii " + std::to_string(preset));
  }
}

TEST(LevelLooks, GardnerPlantsLookTheSameAtAllLevels)
{
  for (int preset = 1; preset < NumberOfGardnerPresets; preset += 3)
  {
    const auto plant = static_cast<GardnerPreset>(preset);
    ExpectSameLooks(LevelsOf(GrowGardnerPlant(PresetParameters(plant)), {}), TraitsOf(plant).Name);
  }
}

TEST(LevelLooks, FarPlantsFaceTheEye)
{
  ImpostorShape shape;
  shape.Extent = { 3.0, 0.0, 10.0 };
  shape.Areas.fill(20.0);
  PlantPlace place;
  place.Foot = { 10.0, 20.0, 30.0 };
  place.Scale = 1.5;
  place.Azimuth = 2.0;
  for (const bool parallel : { false, true })
  {
    View view;
    view.Point = { -50.0, 70.0, 50.0 };
    view.Direction = { 2.0, -3.0, -1.0 };
    view.IsParallel = parallel;
    const ImpostorCard card = FacingCard(shape, place, view);
    const Vector3 middle = 0.5 * (card.Corners[0] + card.Corners[2]);
    EXPECT_LT(glm::distance(middle, place.Foot + Vector3(0.0, 0.0, 7.5)), 1e-9);
    const Vector3 towards = glm::normalize(parallel ? -view.Direction : view.Point - middle);
    const Vector3 right = card.Corners[1] - card.Corners[0];
    const Vector3 up = card.Corners[3] - card.Corners[0];
    EXPECT_NEAR(glm::dot(glm::normalize(glm::cross(right, up)), towards), 1.0, 1e-9);
    EXPECT_NEAR(glm::normalize(right).z, 0.0, 1e-9);
    EXPECT_GT(up.z, 0.0);
    // 9 and 16 degrees above the plant, 26 and 9 degrees from its own x axis.
    EXPECT_EQ(card.View, parallel ? ImpostorAzimuths : 0);
  }
}
