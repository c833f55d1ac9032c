// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GardnerPlant.h"

#include "BranchSkin.h"
#include "Constants.h"
#include "ParameterRange.h"
#include "RandomStream.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace littoral
{

namespace
{

constexpr double GoldenAngle = 2.39996322972865332; // spreads quadrics evenly [rad]
constexpr int SegmentsOfTrunk = 10;
constexpr int SegmentsOfLimb = 4;
constexpr double TrunkInCrown = 0.6;  // part of the crown's height that the trunk reaches
constexpr double ShortestLimb = 0.04; // as part of the height; what is nearer sits on the trunk
constexpr int SidesOfShell = 20;
constexpr int RingsOfShell = 9; // between the poles

/// Grows the wood and the quadrics.
class Grower
{
public:
  explicit Grower(const GardnerPlantParameters& parameters)
    : Crown(CrownOf(parameters))
    , Random(parameters.Seed, RandomPurpose::GardnerQuadrics)
  {
    this->Result.Parameters = parameters;
  }

  GardnerPlant Run()
  {
    const auto origin = this->Random.UniformPair(0, 0);
    GardnerTextureParameters& texture = this->Result.Parameters.Texture;
    texture.Origin = { TwoPi * origin[0], TwoPi * origin[1] };
    const double ratio = 0.5 * this->Crown.Height / this->Crown.Radius;
    texture.FrequencyY = texture.Frequency * std::clamp(ratio * Slenderness(ratio), 0.5, 3.0);
    this->GrowTrunk();
    for (int index = 0; index < this->Result.Parameters.NumberOfQuadrics; ++index)
    {
      this->AddQuadric(index);
    }
    return std::move(this->Result);
  }

private:
  GardnerPlant Result;
  CrownVolume Crown;
  RandomStream Random;

  /// A factor of mean 1, never far from it.
  double Vary(double deviate) const
  {
    return std::max(0.4, 1.0 + this->Result.Parameters.Variation * std::clamp(deviate, -2.0, 2.0));
  }

  void GrowTrunk()
  {
    const GardnerPlantParameters& p = this->Result.Parameters;
    const double reach = p.CrownBase + TrunkInCrown * (p.Height - p.CrownBase);
    const auto lean = this->Random.NormalPair(0, 1);
    const auto bend = this->Random.NormalPair(0, 2);
    const double most = 0.15 * p.Variation * std::min(p.CrownRadius, 0.3 * p.Height);
    this->Result.Wood.StartBranch(-1, { 0.0, 0.0, 0.0 }, p.TrunkRadius);
    for (int step = 1; step <= SegmentsOfTrunk; ++step)
    {
      const double part = static_cast<double>(step) / SegmentsOfTrunk;
      const double shape[2] = { std::sin(Pi * part), std::sin(TwoPi * part) };
      Vector3 place{ 0.0, 0.0, reach * part };
      for (int axis = 0; axis < 2; ++axis)
      {
        place[axis] =
          most * (std::clamp(lean[axis], -2.0, 2.0) * shape[0] + std::clamp(bend[axis], -2.0, 2.0) * shape[1]);
      }
      this->Result.Wood.Grow(place, p.TrunkRadius * (1.0 - 0.75 * part));
    }
  }

  /// How much shorter than the crown quadrics are in a crown of this ratio of height to width, as part of their width.
  static double Slenderness(double ratio) { return std::min(1.0, std::pow(ratio, -0.4)); }

  /// The largest distance from the middle of the unit sphere in a direction of an elevation at which a spheroid with
  /// an upright axis still lies within the sphere.
  static double Room(double elevation, double across, double along)
  {
    const auto fits = [&](double distance) {
      const double outward = distance * std::cos(elevation);
      const double up = distance * std::sin(elevation);
      for (int step = 0; step < 96; ++step)
      {
        const double angle = TwoPi * step / 96.0;
        if (std::hypot(outward + across * std::cos(angle), up + along * std::sin(angle)) > 0.995)
        {
          return false;
        }
      }
      return true;
    };
    double low = 0.0;
    double high = 1.0;
    for (int halving = 0; halving < 30; ++halving)
    {
      const double middle = 0.5 * (low + high);
      (fits(middle) ? low : high) = middle;
    }
    return low;
  }

  Quadric MakeQuadric(int index) const
  {
    const GardnerPlantParameters& p = this->Result.Parameters;
    const std::uint64_t object = static_cast<std::uint64_t>(index) + 1;
    const auto sizes = this->Random.NormalPair(object, 0);
    const auto forms = this->Random.NormalPair(object, 1);
    const auto place = this->Random.NormalPair(object, 2);
    const auto turns = this->Random.UniformPair(object, 3);
    const auto tints = this->Random.NormalPair(object, 4);
    const double upright = 0.5 * this->Crown.Height;

    // In units of the crown's own semi-axes.
    const double mean = std::min(0.98, std::pow(p.NumberOfQuadrics, -0.3));
    const double size = std::min(0.98, mean * this->Vary(sizes[0]));
    const double slender = std::min(1.0, Slenderness(upright / p.CrownRadius) * this->Vary(0.5 * sizes[1]));
    const double oval = std::min(1.0, this->Vary(-std::abs(0.7 * forms[0])));
    const double evenly = 1.0 - (2.0 * index + 1.0) / p.NumberOfQuadrics;
    const double elevation = std::clamp(std::asin(evenly) + p.Variation * 0.6 * place[0], -0.5 * Pi, 0.5 * Pi);
    const double azimuth = index * GoldenAngle + p.Variation * place[1] + TwoPi * this->Random.UniformPair(0, 3)[0];
    const double distance = Room(elevation, size, size * slender) * (1.0 - 0.5 * p.Variation * turns[1]);

    Quadric quadric;
    quadric.Axes = { size * p.CrownRadius, size * oval * p.CrownRadius, size * slender * upright };
    quadric.Azimuth = TwoPi * turns[0];
    const double outward = distance * std::cos(elevation) * p.CrownRadius;
    quadric.Centre = this->Crown.Foot +
      Vector3(
        outward * std::cos(azimuth), outward * std::sin(azimuth), upright * (1.0 + distance * std::sin(elevation)));
    std::copy(tints.begin(), tints.end(), quadric.Tints);
    return quadric;
  }

  /// Adds a quadric with its limb, if it needs one.
  void AddQuadric(int index)
  {
    Quadric quadric = this->MakeQuadric(index);
    Skeleton& wood = this->Result.Wood;
    const double reach = wood.Nodes[wood.Tip(0)].Position.z;
    const double below = quadric.Centre.z - 0.7 * std::hypot(quadric.Centre.x, quadric.Centre.y);
    const double lowest = std::min(0.8 * this->Result.Parameters.CrownBase + 0.1 * reach, 0.5 * reach);
    int node = 0;
    const Vector3 foot = wood.Along(0, std::clamp(below, lowest, 0.97 * reach) / reach, node);
    quadric.Node = node;
    const double length = glm::distance(foot, quadric.Centre);
    if (length > ShortestLimb * this->Result.Parameters.Height)
    {
      quadric.Node = this->GrowLimb(node, foot, quadric.Centre);
    }
    this->Result.Quadrics.push_back(quadric);
  }

  /// An arc that leaves the trunk flatly and ends steeply; gives its tip.
  int GrowLimb(int parent, const Vector3& foot, const Vector3& tip)
  {
    Skeleton& wood = this->Result.Wood;
    const double length = glm::distance(foot, tip);
    const double radius = std::min(0.5 * wood.Nodes[parent].Radius, 0.03 * length);
    const Vector3 bend{ foot.x + 0.65 * (tip.x - foot.x), foot.y + 0.65 * (tip.y - foot.y),
      foot.z + 0.3 * (tip.z - foot.z) };
    wood.StartBranch(parent, foot, radius);
    int node = 0;
    for (int step = 1; step <= SegmentsOfLimb; ++step)
    {
      const double t = static_cast<double>(step) / SegmentsOfLimb;
      const Vector3 place = (1.0 - t) * (1.0 - t) * foot + 2.0 * t * (1.0 - t) * bend + t * t * tip;
      node = wood.Grow(place, radius * (1.0 - 0.8 * t));
    }
    return node;
  }
};

/// Builds the shells of quadrics.
class ShellBuilder
{
public:
  ShellBuilder(const GardnerPlant& plant, const TextureImage& picture)
    : Plant(plant)
    , Picture(picture)
    , Crown(CrownOf(plant.Parameters))
  {
  }

  PlantMesh Run()
  {
    for (const Quadric& quadric : this->Plant.Quadrics)
    {
      for (int shell = 0; shell < this->Plant.Parameters.Shells; ++shell)
      {
        this->AddShell(quadric, shell);
      }
    }
    return std::move(this->Mesh);
  }

private:
  /// A place on a shell: columns and rows of its vertices. Poles have a vertex in the middle of each side, so that each
  /// triangle there has its own part of the picture.
  struct Place
  {
    double Column;
    int Row;
  };

  const GardnerPlant& Plant;
  const TextureImage& Picture;
  CrownVolume Crown;
  PlantMesh Mesh;
  std::vector<int> Known; // vertices of the present shell; -1 where none is needed so far

  std::array<double, 2> TCoordOf(const Place& place, int shell) const
  {
    const int stripRows = StripRows(this->Plant.Parameters.Shells, this->Picture.Rows);
    // Half a texel off the edges, so that interpolation does not mix shells.
    const double row = shell * stripRows + 0.5 + (stripRows - 1.0) * place.Row / (RingsOfShell + 1.0);
    return { place.Column / SidesOfShell, row / this->Picture.Rows };
  }

  /// Whether the picture is opaque anywhere near a triangle.
  bool IsSeen(const std::array<Place, 3>& triangle, int shell) const
  {
    double low[2] = { 1.0, 1.0 };
    double high[2] = { 0.0, 0.0 };
    for (const Place& place : triangle)
    {
      const auto at = this->TCoordOf(place, shell);
      for (int axis = 0; axis < 2; ++axis)
      {
        low[axis] = std::min(low[axis], at[axis]);
        high[axis] = std::max(high[axis], at[axis]);
      }
    }
    const int columns[2] = { static_cast<int>(low[0] * this->Picture.Columns),
      std::min(this->Picture.Columns - 1, static_cast<int>(high[0] * this->Picture.Columns)) };
    const int rows[2] = { static_cast<int>(low[1] * this->Picture.Rows),
      static_cast<int>(high[1] * this->Picture.Rows) };
    for (int row = rows[0]; row <= rows[1]; ++row)
    {
      for (int column = columns[0]; column <= columns[1]; ++column)
      {
        if (this->Picture.At(column, row)[3] > 0)
        {
          return true;
        }
      }
    }
    return false;
  }

  Colour TintAt(const Quadric& quadric, const Vector3& position, double scale) const
  {
    const GardnerPlantParameters& p = this->Plant.Parameters;
    const double strength = p.Variation / 0.2;
    const Colour tint = TintOf(
      p.Leaf, this->Crown, position, { { 0.0, 0.0 }, { strength * quadric.Tints[0], strength * quadric.Tints[1] } });
    // A tuft shades its inside and its underside.
    const double up = (position.z - quadric.Centre.z) / quadric.Axes.z;
    const double light = (0.7 + 0.3 * scale) * (1.0 + 0.2 * up);
    Colour seen{};
    for (int channel = 0; channel < 3; ++channel)
    {
      seen[channel] = static_cast<unsigned char>(std::clamp(light * tint[channel], 1.0, 255.0));
    }
    return seen;
  }

  int VertexAt(const Quadric& quadric, int shell, const Place& place)
  {
    int& known = this->Known[place.Row * (SidesOfShell + 1) + static_cast<int>(place.Column)];
    if (known < 0)
    {
      known = static_cast<int>(this->Mesh.Points.size());
      const double scale = std::sqrt(1.0 - ShellProfile(shell, this->Plant.Parameters.Shells));
      const double column = place.Column < SidesOfShell ? place.Column : 0.0;
      const Vector3 position =
        PointOf(quadric, scale, TwoPi * column / SidesOfShell, Pi * place.Row / (RingsOfShell + 1.0));
      this->Mesh.Points.push_back(position);
      this->Mesh.Normals.push_back(LitNormal(this->Crown, position, Outward(quadric, position)));
      this->Mesh.TCoords.push_back(this->TCoordOf(place, shell));
      this->Mesh.Colours.push_back(this->TintAt(quadric, position, scale));
      this->Mesh.JointIds.push_back({ quadric.Node, quadric.Node, quadric.Node, quadric.Node });
      this->Mesh.JointWeights.push_back({ 1.0, 0.0, 0.0, 0.0 });
    }
    return known;
  }

  void AddTriangle(const Quadric& quadric, int shell, const std::array<Place, 3>& triangle)
  {
    if (this->IsSeen(triangle, shell))
    {
      this->Mesh.AddPolygon(std::array<int, 3>{ this->VertexAt(quadric, shell, triangle[0]),
        this->VertexAt(quadric, shell, triangle[1]), this->VertexAt(quadric, shell, triangle[2]) });
    }
  }

  void AddShell(const Quadric& quadric, int shell)
  {
    this->Known.assign((RingsOfShell + 2) * (SidesOfShell + 1), -1);
    for (int side = 0; side < SidesOfShell; ++side)
    {
      const double left = side;
      const double right = side + 1.0;
      const double middle = side + 0.5;
      this->AddTriangle(quadric, shell, { { { middle, 0 }, { right, 1 }, { left, 1 } } });
      for (int ring = 1; ring < RingsOfShell; ++ring)
      {
        this->AddTriangle(quadric, shell, { { { left, ring }, { right, ring }, { right, ring + 1 } } });
        this->AddTriangle(quadric, shell, { { { left, ring }, { right, ring + 1 }, { left, ring + 1 } } });
      }
      this->AddTriangle(
        quadric, shell, { { { left, RingsOfShell }, { right, RingsOfShell }, { middle, RingsOfShell + 1 } } });
    }
  }
};

/// A position in the quadric's own axes, each 1 at the surface.
Vector3 Within(const Quadric& quadric, const Vector3& position)
{
  const Vector3 away = position - quadric.Centre;
  const double c = std::cos(quadric.Azimuth);
  const double s = std::sin(quadric.Azimuth);
  return Vector3(c * away.x + s * away.y, c * away.y - s * away.x, away.z) / quadric.Axes;
}

/// Directions of the quadric's own axes in space.
Vector3 Turned(const Quadric& quadric, const Vector3& own)
{
  const double c = std::cos(quadric.Azimuth);
  const double s = std::sin(quadric.Azimuth);
  return { c * own.x - s * own.y, s * own.x + c * own.y, own.z };
}

}

GardnerPlantParameters PresetParameters(GardnerPreset preset)
{
  GardnerPlantParameters p;
  switch (preset)
  {
    case GardnerPreset::Cypress:
      p = { 12.0, 1.25, 0.5, 0.16, 26, 5, { 6, 4, 4.0, 1.0, 0.06, 0.36 }, 0.15, { 74, 108, 62 }, { 96, 78, 62 }, 1 };
      break;
    case GardnerPreset::StonePine:
      p = { 12.0, 5.2, 7.6, 0.3, 22, 5, { 6, 4, 4.0, 1.0, 0.07, 0.38 }, 0.15, { 92, 128, 70 }, { 122, 88, 66 }, 1 };
      break;
    case GardnerPreset::Bush:
      p = { 2.2, 1.6, 0.05, 0.05, 12, 5, { 6, 4, 4.0, 1.0, 0.08, 0.4 }, 0.3, { 138, 152, 70 }, { 96, 82, 66 }, 1 };
      break;
    case GardnerPreset::Custom:
    case GardnerPreset::Tree:
      break;
  }
  return p;
}

std::string WhyInvalid(const GardnerPlantParameters& p)
{
  const GardnerTextureParameters& t = p.Texture;
  for (const std::string& reason :
    { OutOfRange("Height", p.Height, 0.05, 150.0), OutOfRange("CrownRadius", p.CrownRadius, 0.01, 100.0),
      OutOfRange("CrownBase", p.CrownBase, 0.0, 0.9 * p.Height), OutOfRange("TrunkRadius", p.TrunkRadius, 0.001, 10.0),
      OutOfRange("NumberOfQuadrics", p.NumberOfQuadrics, 1, 500), OutOfRange("Shells", p.Shells, 2, 8),
      OutOfRange("Terms", t.Terms, 4, 7), OutOfRange("Frequency", t.Frequency, 2, 16),
      OutOfRange("Offset", t.Offset, 0.0, 3.0), OutOfRange("SilhouetteThreshold", t.SilhouetteThreshold, 0.0, 1.0),
      OutOfRange("CentreThreshold", t.CentreThreshold, 0.0, t.SilhouetteThreshold),
      OutOfRange("Variation", p.Variation, 0.0, 0.5) })
  {
    if (!reason.empty())
    {
      return reason;
    }
  }
  if (t.Frequency % 2 != 0)
  {
    return "Frequency is " + std::to_string(t.Frequency) +
      "; it must be even, since half of it goes into the phases and has to close around a quadric too.";
  }
  return {};
}

CrownVolume CrownOf(const GardnerPlantParameters& p)
{
  return { CrownShape::Ellipsoid, { 0.0, 0.0, p.CrownBase }, p.Height - p.CrownBase, p.CrownRadius };
}

double Profile(const Quadric& quadric, const Vector3& position)
{
  const Vector3 within = Within(quadric, position);
  return 1.0 - glm::dot(within, within);
}

Vector3 PointOf(const Quadric& quadric, double scale, double longitude, double angle)
{
  const Vector3 own{ std::sin(angle) * std::cos(longitude), std::sin(angle) * std::sin(longitude), -std::cos(angle) };
  return quadric.Centre + Turned(quadric, scale * own * quadric.Axes);
}

Vector3 Outward(const Quadric& quadric, const Vector3& position)
{
  return Normalised(Turned(quadric, Within(quadric, position) / quadric.Axes));
}

GardnerPlant GrowGardnerPlant(const GardnerPlantParameters& parameters)
{
  return Grower(parameters).Run();
}

PlantMesh ShellsOf(const GardnerPlant& plant, const TextureImage& picture)
{
  return ShellBuilder(plant, picture).Run();
}

PlantPrototype LevelsOf(const GardnerPlant& plant, const PlantLevelOptions& options)
{
  const GardnerPlantParameters& p = plant.Parameters;
  PlantPrototype prototype;
  BranchSkinOptions skin;
  skin.Bark = p.Bark;
  prototype.Wood = plant.Wood;
  prototype.Skin = SkinOf(plant.Wood, skin);
  prototype.LeafTexture =
    GardnerPicture(GardnerTexture(p.Texture), p.Shells, GardnerPictureSize[0], GardnerPictureSize[1]);
  prototype.Leaves = ShellsOf(plant, prototype.LeafTexture);
  AddLowerLevels(prototype, { CrownOf(p), p.Leaf, p.Bark }, options);
  return prototype;
}

}
