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

constexpr int SidesOfTrunk = 6;
constexpr int SidesOfCrown = 16;
constexpr int RingsOfCrown = 7; ///< between the foot and the top of an ellipsoid

Color ColorOf(const ColorSum& mean)
{
  Color color{};
  std::transform(mean.begin(), mean.end(), color.begin(),
    [](float part) { return static_cast<unsigned char>(std::lround(255.0f * part)); });
  return color;
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
  check.Choice("MediumCrown", static_cast<int>(options.Crown), NumberOfMediumCrowns);
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

void AddLowerLevels(PlantPrototype& prototype, const PlantOutline& outline, const PlantLevelOptions& options,
  const std::function<CrownCards()>& makeCards)
{
  const TextureImage* leafTexture = prototype.LeafTexture.Texels.empty() ? nullptr : &prototype.LeafTexture;
  const std::vector<DrawnMesh> full{ { prototype.Skin }, { prototype.Leaves, leafTexture } };
  PlantExtent extent;
  Enclose(extent, prototype.Skin);
  Enclose(extent, prototype.Leaves);
  prototype.CrownIsEnvelope = options.Crown == MediumCrown::Envelope;
  if (prototype.CrownIsEnvelope)
  {
    prototype.Trunk = TrunkCone(prototype.Wood, outline.Bark);
    prototype.Crown = CrownEnvelope(outline.Crown, options);
    prototype.CrownTexture = CylindricalProjection(
      { prototype.Leaves, leafTexture }, outline.Crown, options.TextureColumns, options.TextureRows, options.OnStep);
    prototype.CrownTextureMean = MeanOf(prototype.CrownTexture);
    prototype.Crown.Colors.assign(prototype.Crown.Points.size(), ColorOf(prototype.CrownTextureMean));
  }
  else
  {
    CrownCards cards = makeCards();
    ScaleToCardMean(cards.Texture);
    prototype.Trunk = MainLimbs(prototype.Wood, outline.Bark);
    prototype.Crown = MatchedMesh(cards, prototype.Trunk, full, extent);
    prototype.CrownTexture = std::move(cards.Texture);
    prototype.CrownTextureMean.fill(CardTextureMean);
  }
  options.OnStep();
  prototype.Impostor =
    ImpostorOf(full, extent, options.Parallel, options.ShareOf ? options.ShareOf(KeyOf(full)) : WorkShare());
  prototype.Low = CrossedCards(prototype.Impostor);
}

PlantPrototype LevelsOf(const Plant& plant, const PlantLevelOptions& options)
{
  PlantPrototype prototype;
  BranchSkinOptions skin;
  skin.Bark = plant.Bark;
  prototype.Wood = plant.Wood;
  options.OnStep();
  prototype.Skin = SkinOf(plant.Wood, skin);
  options.OnStep();
  prototype.Leaves = LeafCards(plant, options.OnStep);
  prototype.LeafTexture = LeafPicture(plant.Form);
  AddLowerLevels(prototype, { plant.Crown, plant.Bark }, options, [&] {
    CrownCards cards{ TuftCards(prototype.Leaves, options.Seed), {} };
    const int leaves =
      cards.Cards.empty() ? 1 : prototype.Leaves.NumberOfPolygons() / static_cast<int>(cards.Cards.size());
    cards.Texture =
      TuftPicture(prototype.LeafTexture, leaves, options.TextureColumns, options.TextureRows, options.Seed);
    return cards;
  });
  return prototype;
}

}
