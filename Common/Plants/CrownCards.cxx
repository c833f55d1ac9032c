// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/CrownCards.h"

#include "Numerics/Constants.h"
#include "Numerics/RandomStream.h"
#include "Plants/BranchSkin.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace littoral
{

namespace
{

constexpr int MatchTexels = 48; ///< along an edge of the pictures that are compared
constexpr int Halvings = 8;     ///< of the interval of scales
constexpr double SmallestScale = 0.4;
constexpr double LargestScale = 2.5;
constexpr int SidesOfTrunk = 6;
constexpr int SamplesOfTuft = 2; ///< along an edge of a texel
constexpr int MostLeavesOfTuft = 24;
/// Azimuths and elevations from which the levels are compared [parts of a circle].
constexpr double Directions[][2] = { { 0.05, 0.0 }, { 0.3, 0.0 }, { 0.55, 0.08 }, { 0.8, 0.08 }, { 0.4, 0.16 },
  { 0.0, 0.25 } };

/// Frames of a plant from these directions.
std::vector<PictureFrame> FramesAround(const PlantExtent& extent)
{
  const Vector3 middle{ 0.0, 0.0, 0.5 * (extent.Low + extent.High) };
  std::vector<PictureFrame> frames;
  for (const auto& [azimuth, elevation] : Directions)
  {
    PictureFrame frame = FrameTowards(middle, TwoPi * azimuth, TwoPi * elevation);
    // A little more than the cylinder, since cards reach out of it.
    frame.HalfWidth = 1.2 * extent.Radius;
    frame.HalfHeight = 1.2 *
      (0.5 * (extent.High - extent.Low) * std::cos(TwoPi * elevation) + extent.Radius * std::sin(TwoPi * elevation));
    frames.push_back(frame);
  }
  return frames;
}

PictureSum SeenFromAround(const std::vector<DrawnMesh>& meshes, const std::vector<PictureFrame>& frames)
{
  PictureSum sum;
  for (const PictureFrame& frame : frames)
  {
    sum.Add(PictureOf(meshes, frame, MatchTexels, MatchTexels));
  }
  return sum;
}

double CoverageFromAround(const std::vector<DrawnMesh>& meshes, const std::vector<PictureFrame>& frames)
{
  return std::accumulate(frames.begin(), frames.end(), 0.0,
    [&](double sum, const PictureFrame& frame) { return sum + CoverageOf(meshes, frame, MatchTexels, MatchTexels); });
}

/// Leaves in a square from -1 to 1, the first in front.
class Tuft
{
public:
  Tuft(const TextureImage& leaf, int leaves, int number, int seed)
    : Picture(leaf)
    , Length(std::min(1.9, 2.6 / std::sqrt(static_cast<double>(std::clamp(leaves, 1, MostLeavesOfTuft)))))
  {
    const RandomStream random(seed, RandomPurpose::LeafTufts);
    const int count = std::clamp(leaves, 1, MostLeavesOfTuft);
    for (int index = 0; index < count; ++index)
    {
      const auto object = 2 * static_cast<std::uint64_t>(index) + static_cast<std::uint64_t>(number);
      const auto place = random.UniformPair(object, 0);
      const auto form = random.UniformPair(object, 1);
      const double away = (1.0 - 0.5 * this->Length) * std::sqrt(place[0]);
      const double around = TwoPi * place[1];
      // Leaves point out of the tuft, more or less, and are seen aslant.
      const double angle = count == 1 ? 0.5 * Pi : around + 2.4 * (form[0] - 0.5);
      Leaf one;
      one.Axis = { std::cos(angle), std::sin(angle) };
      one.Foot = { away * std::cos(around) - 0.5 * this->Length * one.Axis[0],
        away * std::sin(around) - 0.5 * this->Length * one.Axis[1] };
      one.Width = 0.7 * (0.45 + 0.55 * form[1]);
      one.Shade = 0.72 + 0.28 * random.UniformPair(object, 2)[0];
      this->Leaves.push_back(one);
    }
  }

  /// 0 where there is no leaf.
  double ShadeAt(double x, double y) const
  {
    for (const Leaf& leaf : this->Leaves)
    {
      const double away[2] = { (x - leaf.Foot[0]) / this->Length, (y - leaf.Foot[1]) / this->Length };
      const double along = away[0] * leaf.Axis[0] + away[1] * leaf.Axis[1];
      const double across = 0.5 + (away[0] * leaf.Axis[1] - away[1] * leaf.Axis[0]) / leaf.Width;
      if (along >= 0.0 && along < 1.0 && across >= 0.0 && across < 1.0)
      {
        const Texel& texel = this->Picture.At(
          static_cast<int>(across * this->Picture.Columns), static_cast<int>(along * this->Picture.Rows));
        if (texel[3] >= 128)
        {
          return leaf.Shade * texel[0] / 255.0;
        }
      }
    }
    return 0.0;
  }

private:
  struct Leaf
  {
    std::array<double, 2> Foot{};
    std::array<double, 2> Axis{}; ///< of unit length
    double Width = 0.7;           ///< as part of Length
    double Shade = 1.0;
  };
  const TextureImage& Picture;
  double Length;
  std::vector<Leaf> Leaves;
};

Color Scaled(const Color& color, const ColorSum& gains)
{
  Color scaled{};
  for (int channel = 0; channel < 3; ++channel)
  {
    scaled[channel] = static_cast<unsigned char>(
      std::clamp(std::lround(gains[channel] * static_cast<float>(color[channel])), 1L, 255L));
  }
  return scaled;
}

}

PlantMesh MeshOf(const std::vector<CrownCard>& cards, double scale)
{
  PlantMesh mesh;
  const double sides[4][2] = { { -1.0, -1.0 }, { 1.0, -1.0 }, { 1.0, 1.0 }, { -1.0, 1.0 } };
  for (const CrownCard& card : cards)
  {
    const int first = static_cast<int>(mesh.Points.size());
    for (int corner = 0; corner < 4; ++corner)
    {
      const auto& side = sides[corner];
      mesh.Points.push_back(card.Center + scale * (side[0] * card.Right + side[1] * card.Up));
      mesh.Normals.push_back(card.Normals[corner]);
      mesh.TCoords.push_back({ 0.25 * (1.0 + side[0]) + (card.ShowsSecond ? 0.5 : 0.0), 0.5 * (1.0 + side[1]) });
      mesh.Colors.push_back(card.Tint);
    }
    mesh.AddPolygon(std::array<int, 4>{ first, first + 1, first + 2, first + 3 });
  }
  return mesh;
}

std::vector<CrownCard> TuftCards(const PlantMesh& leaves, int seed)
{
  const int all = leaves.NumberOfPolygons();
  const int count = std::min(all, MaximumCards);
  const RandomStream random(seed, RandomPurpose::CrownCards);
  double area = 0.0;
  for (int leaf = 0; leaf < all; ++leaf)
  {
    area += 0.5 * glm::length(AreaVector(leaves, leaf));
  }
  const double half = 0.5 * std::sqrt(2.0 * area / std::max(1, count));
  std::vector<CrownCard> cards;
  for (int index = 0; index < count; ++index)
  {
    // One of the leaves [i n / m, (i + 1) n / m)
    const auto draws = random.UniformPair(static_cast<std::uint64_t>(index), 0);
    const int first = static_cast<int>(static_cast<long long>(index) * all / count);
    const int last = static_cast<int>(static_cast<long long>(index + 1) * all / count);
    const int leaf = first + static_cast<int>(draws[0] * (last - first));
    const int* corners = &leaves.Corners[leaves.Offsets[leaf]];
    const Vector3& foot = leaves.Points[corners[0]];
    const Vector3& tip = leaves.Points[corners[2]];
    CrownCard card;
    card.Center = foot; // not beyond the crown
    card.Up = half * Normalised(tip - foot);
    card.Right = half * Normalised(leaves.Points[corners[1]] - leaves.Points[corners[3]]);
    card.Normals.fill(leaves.Normals[corners[0]]);
    card.Tint = leaves.Colors[corners[0]];
    card.ShowsSecond = draws[1] < 0.5;
    cards.push_back(card);
  }
  return cards;
}

TextureImage TuftPicture(const TextureImage& leaf, int leavesInTuft, int columns, int rows, int seed)
{
  TextureImage picture(columns, rows);
  for (int half = 0; half < 2; ++half)
  {
    const Tuft tuft(leaf, leavesInTuft, half, seed);
    const int begin = half == 0 ? 0 : columns / 2;
    const int end = half == 0 ? columns / 2 : columns;
    for (int at = 0; at < rows * (end - begin); ++at)
    {
      const int row = at / (end - begin);
      const int column = at % (end - begin);
      double shades = 0.0;
      int hits = 0;
      for (int sample = 0; sample < SamplesOfTuft * SamplesOfTuft; ++sample)
      {
        const int across = sample % SamplesOfTuft;
        const int down = sample / SamplesOfTuft;
        const double x = (column + (across + 0.5) / SamplesOfTuft) / (end - begin);
        const double y = (row + (down + 0.5) / SamplesOfTuft) / rows;
        const double shade = tuft.ShadeAt(2.0 * x - 1.0, 2.0 * y - 1.0);
        shades += shade;
        hits += shade > 0.0 ? 1 : 0;
      }
      const auto grey = static_cast<unsigned char>(std::lround(255.0 * (hits > 0 ? shades / hits : 0.75)));
      const auto opacity = static_cast<unsigned char>(255 * hits / (SamplesOfTuft * SamplesOfTuft));
      picture.At(begin + column, row) = { grey, grey, grey, opacity };
    }
  }
  return picture;
}

PlantMesh MainLimbs(const Skeleton& wood, const Color& bark)
{
  std::vector<int> order(wood.Branches.size());
  for (std::size_t branch = 0; branch < order.size(); ++branch)
  {
    order[branch] = static_cast<int>(branch);
  }
  const auto radius = [&](int branch) { return wood.Nodes[wood.Branches[branch].First].Radius; };
  std::stable_sort(order.begin() + 1, order.end(), [&](int a, int b) { return radius(a) > radius(b); });
  Skeleton main;
  int polygons = 0;
  for (std::size_t index = 0; index < order.size(); ++index)
  {
    const SkeletonBranch& branch = wood.Branches[order[index]];
    // A limb keeps its ends and its middle, the trunk its ends and three places between.
    const int most = index == 0 ? 4 : 2;
    const int segments = std::min(branch.Count - 1, most);
    const int sides = NumberOfSides(radius(order[index]), radius(order[0]), SidesOfTrunk);
    polygons += sides * (2 * segments + 1) + 1;
    if (segments < 1 || (index > 0 && polygons > MaximumWoodPolygons))
    {
      break;
    }
    const auto nodeAt = [&](int segment) -> const SkeletonNode& {
      return wood.Nodes[branch.First + segment * (branch.Count - 1) / segments];
    };
    // Branches are on their own: the skin needs no joints.
    main.StartBranch(-1, nodeAt(0).Position, nodeAt(0).Radius);
    for (int segment = 1; segment <= segments; ++segment)
    {
      main.Grow(nodeAt(segment).Position, nodeAt(segment).Radius);
    }
  }
  BranchSkinOptions options;
  options.MaximumSides = SidesOfTrunk;
  options.Bark = bark;
  PlantMesh skin = SkinOf(main, options);
  skin.TCoords.clear();
  skin.JointIds.clear();
  skin.JointWeights.clear();
  return skin;
}

PlantMesh MatchedMesh(
  const CrownCards& crown, const PlantMesh& trunk, const std::vector<DrawnMesh>& full, const PlantExtent& extent)
{
  if (crown.Cards.empty())
  {
    return {};
  }
  const ColorSum textureMean{ CardTextureMean, CardTextureMean, CardTextureMean };
  const std::vector<PictureFrame> frames = FramesAround(extent);
  const PictureSum wanted = SeenFromAround(full, frames);
  double low = SmallestScale;
  double high = LargestScale;
  for (int halving = 0; halving < Halvings; ++halving)
  {
    const double middle = std::sqrt(low * high);
    const PlantMesh mesh = MeshOf(crown.Cards, middle);
    const double covered = CoverageFromAround({ { trunk }, { mesh, &crown.Texture } }, frames);
    (covered < wanted.Coverage ? low : high) = middle;
  }
  PlantMesh mesh = MeshOf(crown.Cards, std::sqrt(low * high));
  const PictureSum seen = SeenFromAround({ { trunk }, { mesh, &crown.Texture, textureMean } }, frames);
  ColorSum gains{ 1.0f, 1.0f, 1.0f };
  for (int channel = 0; channel < 3 && wanted.Coverage > 0.0 && seen.Color[channel] > 0.0; ++channel)
  {
    const double ratio = wanted.Color[channel] / wanted.Coverage * seen.Coverage / seen.Color[channel];
    gains[channel] = static_cast<float>(std::clamp(ratio, 0.2, 5.0));
  }
  for (Color& color : mesh.Colors)
  {
    color = Scaled(color, gains);
  }
  TurnNormalsToFronts(mesh);
  return mesh;
}

void ScaleToCardMean(TextureImage& texture)
{
  const ColorSum mean = MeanOf(texture);
  for (Texel& texel : texture.Texels)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      const float scaled = CardTextureMean / mean[channel] * static_cast<float>(texel[channel]);
      texel[channel] = static_cast<unsigned char>(std::lround(std::min(255.0f, scaled)));
    }
  }
}

ColorSum MeanOf(const TextureImage& texture)
{
  ColorSum sum{ 0.0f, 0.0f, 0.0f };
  double sums[3] = { 0.0, 0.0, 0.0 };
  std::size_t count = 0;
  for (const Texel& texel : texture.Texels)
  {
    count += texel[3] >= 128 ? 1 : 0;
    for (int channel = 0; channel < 3 && texel[3] >= 128; ++channel)
    {
      sums[channel] += texel[channel] / 255.0;
    }
  }
  for (int channel = 0; channel < 3; ++channel)
  {
    sum[channel] =
      count > 0 && sums[channel] > 0.0 ? static_cast<float>(sums[channel] / static_cast<double>(count)) : 1.0f;
  }
  return sum;
}

}
