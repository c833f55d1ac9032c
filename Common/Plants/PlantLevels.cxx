// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/PlantLevels.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Numerics/RandomStream.h"
#include "Plants/BranchSkin.h"
#include "Plants/CylindricalProjection.h"
#include "Plants/LeafCards.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr int CornersOfEllipse = 24;
constexpr int SidesOfTrunk = 6;
constexpr int SidesOfCrown = 16;
constexpr int RingsOfCrown = 7; ///< between the foot and the top of an ellipsoid

/// Adds a polygon in the vertical plane through a point, given by distances from its axis and heights above it [m].
void AddUpright(PlantMesh& mesh, const Vector3& foot, const std::vector<std::array<double, 2>>& outline,
  const Vector3& across, const Color& color)
{
  std::vector<int> corners;
  for (const auto& corner : outline)
  {
    corners.push_back(static_cast<int>(mesh.Points.size()));
    mesh.Points.push_back(foot + corner[0] * across + Vector3(0.0, 0.0, corner[1]));
    mesh.Normals.push_back({ across.y, -across.x, 0.0 });
    mesh.Colors.push_back(color);
  }
  mesh.AddPolygon(corners);
}

std::vector<std::array<double, 2>> OutlineOf(const CrownVolume& crown)
{
  if (crown.Shape == CrownShape::Cone)
  {
    return { { -crown.Radius, 0.0 }, { crown.Radius, 0.0 }, { 0.0, crown.Height } };
  }
  std::vector<std::array<double, 2>> outline;
  for (int corner = 0; corner < CornersOfEllipse; ++corner)
  {
    const double angle = TwoPi * corner / CornersOfEllipse;
    outline.push_back({ crown.Radius * std::cos(angle), 0.5 * crown.Height * (1.0 + std::sin(angle)) });
  }
  return outline;
}

/// A part of a picture; beyond its last column comes the first again.
struct TexelWindow
{
  int Column; ///< in the middle
  int Row;
  int Width; ///< to both sides
  int Height;
};

/// The mean color of what is seen in a part of the picture; the leaf's where nothing is.
Color MeanColor(const TextureImage& seen, const TexelWindow& window, const Color& leaf)
{
  double sums[3] = { 0.0, 0.0, 0.0 };
  double weight = 0.0;
  const int last = std::min(seen.Rows - 1, window.Row + window.Height);
  for (int row = std::max(0, window.Row - window.Height); row <= last; ++row)
  {
    for (int column = window.Column - window.Width; column <= window.Column + window.Width; ++column)
    {
      const Texel& texel = seen.At(((column % seen.Columns) + seen.Columns) % seen.Columns, row);
      weight += texel[3];
      for (int channel = 0; channel < 3; ++channel)
      {
        sums[channel] += static_cast<double>(texel[3]) * texel[channel];
      }
    }
  }
  Color mean = leaf;
  for (int channel = 0; channel < 3 && weight > 0.0; ++channel)
  {
    mean[channel] = static_cast<unsigned char>(std::lround(sums[channel] / weight));
  }
  return mean;
}

/// The color around a vertex of the envelope.
Color ColorAround(const TextureImage& seen, double u, double v, const Color& leaf)
{
  const int reach = std::max(1, seen.Columns / (2 * SidesOfCrown));
  const int row = std::min(seen.Rows - 1, static_cast<int>(v * seen.Rows));
  return MeanColor(seen, { static_cast<int>(u * seen.Columns), row, reach, reach }, leaf);
}

/// The color of the whole crown at a part of its height.
Color ColorAtHeight(const TextureImage& seen, double v, const Color& leaf)
{
  const int row = std::min(seen.Rows - 1, static_cast<int>(v * seen.Rows));
  return MeanColor(seen, { 0, row, seen.Columns / 2, seen.Rows / 8 }, leaf);
}

/// Builds an envelope from rings of vertices around the axis.
class Envelope
{
public:
  Envelope(const CrownVolume& crown, const PlantLevelOptions& options)
    : Crown(crown)
    , Jitter(options.CrownJitter)
    , Stream(options.Seed, RandomPurpose::CrownJitter)
  {
  }

  PlantMesh Run()
  {
    const bool cone = this->Crown.Shape == CrownShape::Cone;
    this->AddPole(0.0, -1.0);
    for (int ring = 0; ring < RingsOfCrown; ++ring)
    {
      const double part = cone ? static_cast<double>(ring) / RingsOfCrown
                               : 0.5 * (1.0 - std::cos(Pi * (ring + 1.0) / (RingsOfCrown + 1.0)));
      this->AddRing(part, cone ? 1.0 - part : 2.0 * std::sqrt(part * (1.0 - part)), ring);
    }
    this->AddPole(1.0, 1.0);
    this->Join();
    TurnNormalsToFronts(this->Mesh); // of dents
    return std::move(this->Mesh);
  }

private:
  CrownVolume Crown;
  double Jitter;
  RandomStream Stream;
  PlantMesh Mesh;

  void AddVertex(const Vector3& away, const Vector3& normal, double u, double v)
  {
    this->Mesh.Points.push_back(this->Crown.Foot + away);
    this->Mesh.Normals.push_back(normal);
    this->Mesh.TCoords.push_back({ u, v });
  }

  /// A vertex at an end of the axis for each side, so that each triangle there has its own part of the texture.
  void AddPole(double part, double up)
  {
    for (int side = 0; side < SidesOfCrown; ++side)
    {
      this->AddVertex({ 0.0, 0.0, part * this->Crown.Height }, { 0.0, 0.0, up }, (side + 0.5) / SidesOfCrown, part);
    }
  }

  void AddRing(double part, double wide, int ring)
  {
    for (int corner = 0; corner <= SidesOfCrown; ++corner)
    {
      const int side = corner % SidesOfCrown;
      const double angle = TwoPi * side / SidesOfCrown;
      const auto draw = this->Stream.UniformPair(static_cast<std::uint64_t>(ring), static_cast<std::uint64_t>(side));
      const double radius = this->Crown.Radius * wide * (1.0 - this->Jitter * draw[0]);
      const Vector3 away{ radius * std::cos(angle), radius * std::sin(angle), part * this->Crown.Height };
      this->AddVertex(
        away, Outward(this->Crown, this->Crown.Foot + away), static_cast<double>(corner) / SidesOfCrown, part);
    }
  }

  /// The rim of the underside of a cone has normals of its own, after all else; the place of its first vertex.
  int AddRim()
  {
    const int rim = static_cast<int>(this->Mesh.Points.size());
    for (int corner = 0; corner <= SidesOfCrown; ++corner)
    {
      const Vector3 away = this->Mesh.Points[SidesOfCrown + corner] - this->Crown.Foot;
      this->AddVertex(away, { 0.0, 0.0, -1.0 }, static_cast<double>(corner) / SidesOfCrown, 0.0);
    }
    return rim;
  }

  void Join()
  {
    const auto inRing = [](int ring, int corner) { return SidesOfCrown + ring * (SidesOfCrown + 1) + corner; };
    const int top = inRing(RingsOfCrown, 0);
    const int rim = this->Crown.Shape == CrownShape::Cone ? this->AddRim() : inRing(0, 0);
    for (int side = 0; side < SidesOfCrown; ++side)
    {
      this->Mesh.AddPolygon(std::array<int, 3>{ side, rim + side + 1, rim + side });
      for (int ring = 0; ring + 1 < RingsOfCrown; ++ring)
      {
        this->Mesh.AddPolygon(
          std::array<int, 3>{ inRing(ring, side), inRing(ring, side + 1), inRing(ring + 1, side + 1) });
        this->Mesh.AddPolygon(
          std::array<int, 3>{ inRing(ring, side), inRing(ring + 1, side + 1), inRing(ring + 1, side) });
      }
      this->Mesh.AddPolygon(
        std::array<int, 3>{ inRing(RingsOfCrown - 1, side), inRing(RingsOfCrown - 1, side + 1), top + side });
    }
  }
};

}

std::string WhyInvalid(const PlantLevelOptions& options)
{
  ParameterCheck check;
  check.Count("TextureSize[0]", options.TextureColumns, 4, 4096);
  check.Count("TextureSize[1]", options.TextureRows, 4, 4096);
  check.Range("CrownJitter", options.CrownJitter, 0.0, 0.9);
  return check.Reason();
}

PlantMesh TrunkCone(const Skeleton& wood, const Color& bark)
{
  const SkeletonBranch& trunk = wood.Branches.front();
  const SkeletonNode& foot = wood.Nodes[trunk.First];
  const Vector3 top = wood.Nodes[wood.Tip(0)].Position;
  const Vector3 axis = Normalised(top - foot.Position);
  const Vector3 side = Perpendicular(axis);
  PlantMesh mesh;
  for (int corner = 0; corner < SidesOfTrunk; ++corner)
  {
    const double angle = TwoPi * corner / SidesOfTrunk;
    const Vector3 normal = std::cos(angle) * side + std::sin(angle) * glm::cross(axis, side);
    mesh.Points.push_back(foot.Position + foot.Radius * normal);
    mesh.Normals.push_back(normal);
    mesh.Colors.push_back(bark);
  }
  mesh.Points.push_back(top);
  mesh.Normals.push_back(axis);
  mesh.Colors.push_back(bark);
  for (int corner = 0; corner < SidesOfTrunk; ++corner)
  {
    mesh.AddPolygon(std::array<int, 3>{ corner, (corner + 1) % SidesOfTrunk, SidesOfTrunk });
  }
  // The end at the foot, with normals of its own.
  std::vector<int> corners;
  for (int corner = SidesOfTrunk - 1; corner >= 0; --corner)
  {
    corners.push_back(CopyVertex(mesh, corner));
    mesh.Normals.back() = -axis;
  }
  mesh.AddPolygon(corners);
  return mesh;
}

PlantMesh CrownEnvelope(const CrownVolume& crown, const PlantLevelOptions& options)
{
  return Envelope(crown, options).Run();
}

PlantMesh LowPlant(const PlantOutline& outline, const Skeleton& wood, const TextureImage& seen)
{
  const SkeletonBranch& trunk = wood.Branches.front();
  const SkeletonNode& foot = wood.Nodes[trunk.First];
  const double r = foot.Radius;
  // Up to the crown only: beyond, it would lie in the crown's own plane.
  const double top = std::max(outline.Crown.Foot.z - foot.Position.z, r);
  const std::vector<std::array<double, 2>> rectangle{ { -r, 0.0 }, { r, 0.0 }, { r, top }, { -r, top } };
  const std::vector<std::array<double, 2>> crown = OutlineOf(outline.Crown);
  PlantMesh mesh;
  for (const Vector3& across : { Vector3{ 1.0, 0.0, 0.0 }, Vector3{ 0.0, 1.0, 0.0 } })
  {
    AddUpright(mesh, foot.Position, rectangle, across, outline.Bark);
    const std::size_t first = mesh.Points.size();
    AddUpright(mesh, outline.Crown.Foot, crown, across, outline.Leaf);
    for (std::size_t i = first; i < mesh.Points.size(); ++i)
    {
      const double up = (mesh.Points[i].z - outline.Crown.Foot.z) / outline.Crown.Height;
      mesh.Colors[i] = ColorAtHeight(seen, std::clamp(up, 0.0, 1.0), outline.Leaf);
    }
  }
  return mesh;
}

void AddLowerLevels(PlantPrototype& prototype, const PlantOutline& outline, const PlantLevelOptions& options)
{
  const TextureImage* leafTexture = prototype.LeafTexture.Texels.empty() ? nullptr : &prototype.LeafTexture;
  prototype.CrownTexture = CylindricalProjection(
    { prototype.Leaves, leafTexture }, outline.Crown, options.TextureColumns, options.TextureRows);
  prototype.Trunk = TrunkCone(prototype.Wood, outline.Bark);
  prototype.Crown = CrownEnvelope(outline.Crown, options);
  for (const auto& at : prototype.Crown.TCoords)
  {
    prototype.Crown.Colors.push_back(ColorAround(prototype.CrownTexture, at[0], at[1], outline.Leaf));
  }
  prototype.Low = LowPlant(outline, prototype.Wood, prototype.CrownTexture);
}

PlantPrototype LevelsOf(const Plant& plant, const PlantLevelOptions& options)
{
  PlantPrototype prototype;
  BranchSkinOptions skin;
  skin.Bark = plant.Bark;
  prototype.Wood = plant.Wood;
  prototype.Skin = SkinOf(plant.Wood, skin);
  prototype.Leaves = LeafCards(plant);
  prototype.LeafTexture = LeafPicture(plant.Form);
  AddLowerLevels(prototype, { plant.Crown, plant.Leaf, plant.Bark }, options);
  return prototype;
}

}
