// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/GardnerPlant.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Numerics/RandomStream.h"
#include "Plants/BranchSkin.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace littoral
{

namespace
{

constexpr double GoldenAngle = 2.39996322972865332; // spreads quadrics evenly [rad]
constexpr int SegmentsOfTrunk = 10;
constexpr int SegmentsOfLimb = 4;
constexpr double TrunkInCrown = 0.6;  // part of the crown's height that the trunk reaches
constexpr double ShortestLimb = 0.04; // as part of the height; what is nearer sits on the trunk
constexpr int SidesOfShell = 16;
constexpr int RingsOfShell = 7; // between the poles
constexpr int SidesOfSection = 12;

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

  /// Factor of the height of quadrics in a crown of this ratio of height to width: they are less slender than the
  /// crown.
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
    quadric.Center = this->Crown.Foot +
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
    const double below = quadric.Center.z - 0.7 * std::hypot(quadric.Center.x, quadric.Center.y);
    const double lowest = std::min(0.8 * this->Result.Parameters.CrownBase + 0.1 * reach, 0.5 * reach);
    int node = 0;
    const Vector3 foot = wood.Along(0, std::clamp(below, lowest, 0.97 * reach) / reach, node);
    quadric.Node = node;
    const double length = glm::distance(foot, quadric.Center);
    if (length > ShortestLimb * this->Result.Parameters.Height)
    {
      quadric.Node = this->GrowLimb(node, foot, quadric.Center);
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

/// Directions of sections in the unit sphere, as even as a spiral over half of it gives.
Vector3 SectionNormal(int section)
{
  const double up = (section + 0.5) / NumberOfSections;
  const double outward = std::sqrt(1.0 - up * up);
  return { outward * std::cos(GoldenAngle * section), outward * std::sin(GoldenAngle * section), up };
}

/// Builds the shells and sections of quadrics.
class QuadricBuilder
{
public:
  QuadricBuilder(const GardnerPlant& plant, const TextureImage& picture)
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
      for (int section = 0; section < NumberOfSections; ++section)
      {
        this->AddSection(quadric, section);
      }
    }
    // Rims of sections in slender quadrics.
    TurnNormalsToFronts(this->Mesh);
    return std::move(this->Mesh);
  }

  /// Some of the sections as cards.
  std::vector<CrownCard> Cards() const
  {
    const int quadrics = static_cast<int>(this->Plant.Quadrics.size());
    const int sections = std::clamp(MaximumCards / std::max(1, quadrics), 1, NumberOfSections);
    std::vector<CrownCard> cards;
    for (const Quadric& quadric : this->Plant.Quadrics)
    {
      for (int index = 0; index < sections; ++index)
      {
        cards.push_back(this->CardOf(quadric, index * NumberOfSections / sections));
      }
    }
    return cards;
  }

private:
  /// A vertex before it is known whether any triangle needs it.
  struct Vertex
  {
    Vector3 OfSphere;
    Vector3 Facing; ///< facing in the sphere
    std::array<double, 2> TCoord;
    int Index = -1;
  };

  const GardnerPlant& Plant;
  const TextureImage& Picture;
  CrownVolume Crown;
  PlantMesh Mesh;

  /// Whether the picture is opaque anywhere near a triangle.
  bool IsSeen(const std::array<Vertex*, 3>& triangle) const
  {
    const int sizes[2] = { this->Picture.Columns, this->Picture.Rows };
    int low[2] = { sizes[0] - 1, sizes[1] - 1 };
    int high[2] = { 0, 0 };
    for (const Vertex* vertex : triangle)
    {
      for (int axis = 0; axis < 2; ++axis)
      {
        const int texel = std::min(sizes[axis] - 1, static_cast<int>(vertex->TCoord[axis] * sizes[axis]));
        low[axis] = std::min(low[axis], texel);
        high[axis] = std::max(high[axis], texel);
      }
    }
    for (int row = low[1]; row <= high[1]; ++row)
    {
      for (int column = low[0]; column <= high[0]; ++column)
      {
        if (this->Picture.At(column, row)[3] > 0)
        {
          return true;
        }
      }
    }
    return false;
  }

  /// A tuft shades its inside and its underside.
  Color TintAt(const Quadric& quadric, const Vector3& ofSphere, const Vector3& position) const
  {
    const GardnerPlantParameters& p = this->Plant.Parameters;
    const double strength = p.Variation / 0.2;
    const Color tint = TintOf(
      p.Leaf, this->Crown, position, { { 0.0, 0.0 }, { strength * quadric.Tints[0], strength * quadric.Tints[1] } });
    const double light = (0.75 + 0.35 * glm::length(ofSphere)) * (1.0 + 0.25 * ofSphere.z);
    Color seen{};
    for (int channel = 0; channel < 3; ++channel)
    {
      seen[channel] = static_cast<unsigned char>(std::clamp(light * tint[channel], 1.0, 255.0));
    }
    return seen;
  }

  int IndexOf(const Quadric& quadric, Vertex& vertex)
  {
    if (vertex.Index < 0)
    {
      vertex.Index = static_cast<int>(this->Mesh.Points.size());
      const Vector3 position = PointOf(quadric, vertex.OfSphere);
      this->Mesh.Points.push_back(position);
      this->Mesh.Normals.push_back(LitNormal(this->Crown, position, Outward(quadric, vertex.Facing)));
      this->Mesh.TCoords.push_back(vertex.TCoord);
      this->Mesh.Colors.push_back(this->TintAt(quadric, vertex.OfSphere, position));
      this->Mesh.JointIds.push_back({ quadric.Node, quadric.Node, quadric.Node, quadric.Node });
      this->Mesh.JointWeights.push_back({ 1.0, 0.0, 0.0, 0.0 });
    }
    return vertex.Index;
  }

  void AddTriangle(const Quadric& quadric, Vertex& a, Vertex& b, Vertex& c)
  {
    if (this->IsSeen({ &a, &b, &c }))
    {
      this->Mesh.AddPolygon(
        std::array<int, 3>{ this->IndexOf(quadric, a), this->IndexOf(quadric, b), this->IndexOf(quadric, c) });
    }
  }

  /// A vertex of a shell. Its side may be a half: poles have a vertex in the middle of each side, so that each triangle
  /// there has its own part of the picture.
  Vertex OnShell(int shell, double side, int ring) const
  {
    const int shells = this->Plant.Parameters.Shells;
    const int stripRows = StripRows(shells);
    const double angle = Pi * ring / (RingsOfShell + 1.0);
    const double longitude = side < SidesOfShell ? TwoPi * side / SidesOfShell : 0.0;
    const double outward = ring == 0 || ring == RingsOfShell + 1 ? 0.0 : std::sin(angle);
    const Vector3 away{ outward * std::cos(longitude), outward * std::sin(longitude), -std::cos(angle) };
    // Half a texel off the edges, so that interpolation does not mix shells.
    const double row = SectionRows + shell * stripRows + 0.5 + (stripRows - 1.0) * ring / (RingsOfShell + 1.0);
    return { std::sqrt(1.0 - ShellProfile(shell, shells)) * away, away,
      { side / SidesOfShell, row / this->Picture.Rows } };
  }

  void AddShell(const Quadric& quadric, int shell)
  {
    std::vector<std::vector<Vertex>> rings(RingsOfShell + 2);
    for (int ring = 0; ring < RingsOfShell + 2; ++ring)
    {
      const bool pole = ring == 0 || ring == RingsOfShell + 1;
      for (int side = 0; side < SidesOfShell + (pole ? 0 : 1); ++side)
      {
        rings[ring].push_back(this->OnShell(shell, side + (pole ? 0.5 : 0.0), ring));
      }
    }
    for (int side = 0; side < SidesOfShell; ++side)
    {
      this->AddTriangle(quadric, rings[0][side], rings[1][side + 1], rings[1][side]);
      for (int ring = 1; ring < RingsOfShell; ++ring)
      {
        this->AddTriangle(quadric, rings[ring][side], rings[ring][side + 1], rings[ring + 1][side + 1]);
        this->AddTriangle(quadric, rings[ring][side], rings[ring + 1][side + 1], rings[ring + 1][side]);
      }
      this->AddTriangle(
        quadric, rings[RingsOfShell][side], rings[RingsOfShell][side + 1], rings[RingsOfShell + 1][side]);
    }
  }

  /// The normal of a section in the sphere; its front is what is seen from outside of the crown.
  Vector3 FrontOf(const Quadric& quadric, int section) const
  {
    const Vector3 fromCrown = quadric.Center - this->Crown.Foot - Vector3(0.0, 0.0, 0.5 * this->Crown.Height);
    const bool inwards = glm::dot(Outward(quadric, SectionNormal(section)), fromCrown) < 0.0;
    return (inwards ? -1.0 : 1.0) * SectionNormal(section);
  }

  /// The square around a section.
  CrownCard CardOf(const Quadric& quadric, int section) const
  {
    const Vector3 normal = this->FrontOf(quadric, section);
    const Vector3 first = Perpendicular(normal);
    const Vector3 second = glm::cross(normal, first);
    CrownCard card;
    card.Center = quadric.Center;
    card.Right = PointOf(quadric, first) - quadric.Center;
    card.Up = PointOf(quadric, second) - quadric.Center;
    const double sides[4][2] = { { -1.0, -1.0 }, { 1.0, -1.0 }, { 1.0, 1.0 }, { -1.0, 1.0 } };
    for (int corner = 0; corner < 4; ++corner)
    {
      const Vector3 away = sides[corner][0] * first + sides[corner][1] * second;
      card.Normals[corner] =
        LitNormal(this->Crown, PointOf(quadric, 0.6 * away), Outward(quadric, Normalised(away + 0.8 * normal)));
    }
    card.Tint = this->TintAt(quadric, 0.6 * normal, PointOf(quadric, 0.6 * normal));
    card.ShowsSecond = section % 2 == 1;
    return card;
  }

  /// A disk, with the picture of an outline on it and normals as on the side of the quadric that it faces.
  void AddSection(const Quadric& quadric, int section)
  {
    const Vector3 normal = this->FrontOf(quadric, section);
    const Vector3 first = Perpendicular(normal);
    const Vector3 second = glm::cross(normal, first);
    const double half = 0.5 * GardnerColumns;
    const auto vertexAt = [&](double radius, double angle) {
      const double across = radius * std::cos(angle);
      const double up = radius * std::sin(angle);
      const Vector3 away = across * first + up * second;
      // Half a texel off the edges, as on shells.
      const double column = (section % 2) * half + 0.5 + 0.5 * (1.0 + across) * (half - 1.0);
      const double row = 0.5 + 0.5 * (1.0 + up) * (SectionRows - 1.0);
      return Vertex{ away, Normalised(away + 0.4 * normal),
        { column / this->Picture.Columns, row / this->Picture.Rows } };
    };
    std::vector<Vertex> rings[3]{ { vertexAt(0.0, 0.0) }, {}, {} };
    for (int ring = 1; ring < 3; ++ring)
    {
      for (int side = 0; side < SidesOfSection; ++side)
      {
        rings[ring].push_back(vertexAt(0.5 * ring, TwoPi * side / SidesOfSection));
      }
    }
    for (int side = 0; side < SidesOfSection; ++side)
    {
      const int next = (side + 1) % SidesOfSection;
      this->AddTriangle(quadric, rings[0][0], rings[1][side], rings[1][next]);
      this->AddTriangle(quadric, rings[1][side], rings[2][side], rings[2][next]);
      this->AddTriangle(quadric, rings[1][side], rings[2][next], rings[1][next]);
    }
  }
};

/// Directions of the quadric's own axes in space.
Vector3 Turned(const Quadric& quadric, const Vector3& own)
{
  const double c = std::cos(quadric.Azimuth);
  const double s = std::sin(quadric.Azimuth);
  return { c * own.x - s * own.y, s * own.x + c * own.y, own.z };
}

// -------------------------------------------------------------------------------------------------------------------
// Presets: what differs from the defaults, which are those of a tree.

GardnerPlantParameters Tree()
{
  return {};
}

GardnerPlantParameters Cypress()
{
  GardnerPlantParameters p;
  p.Height = 12.0;
  p.CrownRadius = 1.25;
  p.CrownBase = 0.5;
  p.TrunkRadius = 0.16;
  p.NumberOfQuadrics = 30;
  p.Texture.Frequency = 6;
  p.Texture.CenterThreshold = 0.06;
  p.Texture.SilhouetteThreshold = 0.36;
  p.Variation = 0.15;
  p.Leaf = { 96, 134, 78 };
  p.Bark = { 96, 78, 62 };
  return p;
}

GardnerPlantParameters StonePine()
{
  GardnerPlantParameters p;
  p.Height = 12.0;
  p.CrownRadius = 5.2;
  p.CrownBase = 7.6;
  p.TrunkRadius = 0.3;
  p.NumberOfQuadrics = 26;
  p.Texture.Frequency = 6;
  p.Texture.CenterThreshold = 0.07;
  p.Texture.SilhouetteThreshold = 0.38;
  p.Variation = 0.15;
  p.Leaf = { 118, 156, 88 };
  p.Bark = { 122, 88, 66 };
  return p;
}

GardnerPlantParameters Bush()
{
  GardnerPlantParameters p;
  p.Height = 2.2;
  p.CrownRadius = 1.6;
  p.CrownBase = 0.05;
  p.TrunkRadius = 0.05;
  p.NumberOfQuadrics = 16;
  p.Texture.Frequency = 6;
  p.Texture.CenterThreshold = 0.08;
  p.Texture.SilhouetteThreshold = 0.4;
  p.Variation = 0.3;
  p.Leaf = { 170, 182, 90 };
  p.Bark = { 96, 82, 66 };
  return p;
}

/// Rows in the order of the enumeration.
constexpr GardnerPresetTraits Presets[] = {
  { "Custom", Tree },
  { "Tree", Tree },
  { "Cypress", Cypress },
  { "StonePine", StonePine },
  { "Bush", Bush },
};
static_assert(std::size(Presets) == NumberOfGardnerPresets, "a row a preset");

}

const GardnerPresetTraits& TraitsOf(GardnerPreset preset)
{
  return Presets[static_cast<int>(preset)];
}

GardnerPlantParameters PresetParameters(GardnerPreset preset)
{
  return TraitsOf(preset).Parameters();
}

std::string WhyInvalid(const GardnerPlantParameters& p)
{
  const GardnerTextureParameters& t = p.Texture;
  ParameterCheck check;
  check.Range("Height", p.Height, 0.05, 150.0, "m");
  check.Range("CrownRadius", p.CrownRadius, 0.01, 100.0, "m");
  check.Range("CrownBase", p.CrownBase, 0.0, 0.9 * p.Height, "m");
  check.Range("TrunkRadius", p.TrunkRadius, 0.001, 10.0, "m");
  check.Count("NumberOfQuadrics", p.NumberOfQuadrics, 1, 500);
  check.Count("Shells", p.Shells, 2, 8);
  check.Count("Terms", t.Terms, 4, 7);
  check.Count("Frequency", t.Frequency, 2, 16);
  check.Range("Offset", t.Offset, 0.0, 3.0);
  check.Range("SilhouetteThreshold", t.SilhouetteThreshold, 0.0, 1.0);
  check.Range("CenterThreshold", t.CenterThreshold, 0.0, 1.0);
  check.Require(t.CenterThreshold <= t.SilhouetteThreshold, "CenterThreshold", t.CenterThreshold, "",
    "at most SilhouetteThreshold, " + TextOf(t.SilhouetteThreshold));
  check.Range("Variation", p.Variation, 0.0, 0.5);
  check.Require(t.Frequency % 2 == 0,
    "Frequency is " + std::to_string(t.Frequency) +
      "; it must be even, since half of it goes into the phases and has to close around a quadric too.");
  return check.Reason();
}

CrownVolume CrownOf(const GardnerPlantParameters& p)
{
  return { CrownShape::Ellipsoid, { 0.0, 0.0, p.CrownBase }, p.Height - p.CrownBase, p.CrownRadius };
}

Vector3 PointOf(const Quadric& quadric, const Vector3& ofSphere)
{
  // x = c + R (a_1 u_1, a_2 u_2, a_3 u_3)
  return quadric.Center + Turned(quadric, ofSphere * quadric.Axes);
}

Vector3 Outward(const Quadric& quadric, const Vector3& ofSphere)
{
  // Gradient of sum (x_i / a_i)^2 at x_i = a_i u_i: R (u_1 / a_1, u_2 / a_2, u_3 / a_3)
  return Normalised(Turned(quadric, ofSphere / quadric.Axes));
}

GardnerPlant GrowGardnerPlant(const GardnerPlantParameters& parameters)
{
  return Grower(parameters).Run();
}

PlantMesh QuadricMesh(const GardnerPlant& plant, const TextureImage& picture)
{
  return QuadricBuilder(plant, picture).Run();
}

CrownCards SectionCards(const GardnerPlant& plant, const TextureImage& picture, int columns, int rows)
{
  CrownCards cards{ QuadricBuilder(plant, picture).Cards(), TextureImage(columns, rows) };
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      cards.Texture.At(column, row) =
        picture.At((2 * column + 1) * picture.Columns / (2 * columns), (2 * row + 1) * SectionRows / (2 * rows));
    }
  }
  return cards;
}

CrownVolume SeenCrown(const GardnerPlant& plant, const TextureImage& picture)
{
  double opaque = 0.0;
  for (int row = 0; row < SectionRows; ++row)
  {
    for (int column = 0; column < picture.Columns; ++column)
    {
      opaque += picture.At(column, row)[3] > 0 ? 1.0 : 0.0;
    }
  }
  const double outlines = 0.25 * Pi * SectionRows * picture.Columns;
  const double seen = std::sqrt(std::min(1.0, opaque / outlines));
  double size = 0.0;
  for (const Quadric& quadric : plant.Quadrics)
  {
    size += quadric.Axes.x / plant.Parameters.CrownRadius / static_cast<double>(plant.Quadrics.size());
  }
  const double scale = 1.0 - size * (1.0 - seen);
  CrownVolume crown = CrownOf(plant.Parameters);
  crown.Foot.z += 0.5 * (1.0 - scale) * crown.Height;
  crown.Height *= scale;
  crown.Radius *= scale;
  return crown;
}

PlantPrototype LevelsOf(const GardnerPlant& plant, const PlantLevelOptions& options)
{
  const GardnerPlantParameters& p = plant.Parameters;
  PlantPrototype prototype;
  BranchSkinOptions skin;
  skin.Bark = p.Bark;
  prototype.Wood = plant.Wood;
  prototype.Skin = SkinOf(plant.Wood, skin);
  prototype.LeafTexture = GardnerPicture(GardnerTexture(p.Texture), p.Shells);
  options.OnStep();
  prototype.Leaves = QuadricMesh(plant, prototype.LeafTexture);
  options.OnStep();
  AddLowerLevels(prototype, { SeenCrown(plant, prototype.LeafTexture), p.Bark }, options,
    [&] { return SectionCards(plant, prototype.LeafTexture, options.TextureColumns, options.TextureRows); });
  return prototype;
}

}
