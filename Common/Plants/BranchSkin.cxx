// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/BranchSkin.h"

#include "Numerics/Constants.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// The direction of a branch at one of its nodes: the mean of the segments that meet.
Vector3 DirectionAt(const Skeleton& skeleton, const SkeletonBranch& branch, int step)
{
  const int node = branch.First + step;
  const int before = step > 0 ? node - 1 : node;
  const int after = step + 1 < branch.Count ? node + 1 : node;
  return glm::normalize(skeleton.Nodes[after].Position - skeleton.Nodes[before].Position);
}

void AddJoints(PlantMesh& mesh, const SkeletonBranch& branch, int step)
{
  const int own = branch.First + std::min(step, branch.Count - 2);
  const bool between = step > 0 && step + 1 < branch.Count;
  mesh.JointIds.push_back({ own, between ? own - 1 : own, own, own });
  mesh.JointWeights.push_back({ between ? 0.5 : 1.0, between ? 0.5 : 0.0, 0.0, 0.0 });
}

/// The first vector, turned into the plane at a right angle to the direction.
Vector3 Carried(const Vector3& side, const Vector3& direction)
{
  const Vector3 flat = side - glm::dot(side, direction) * direction;
  return glm::length(flat) > 1e-6 ? glm::normalize(flat) : Perpendicular(direction);
}

void AddVertex(PlantMesh& mesh, const Vector3& point, const Vector3& normal, double u, double v, const Color& bark)
{
  mesh.Points.push_back(point);
  mesh.Normals.push_back(normal);
  mesh.TCoords.push_back({ u, v });
  mesh.Colors.push_back(bark);
}

/// Triangles between the last two rings.
void JoinRings(PlantMesh& mesh, int sides)
{
  const int upper = static_cast<int>(mesh.Points.size()) - (sides + 1);
  const int lower = upper - (sides + 1);
  for (int side = 0; side < sides; ++side)
  {
    mesh.AddPolygon(std::array<int, 3>{ lower + side, lower + side + 1, upper + side + 1 });
    mesh.AddPolygon(std::array<int, 3>{ lower + side, upper + side + 1, upper + side });
  }
}

/// Closes the foot of a branch, whose first ring starts at a vertex, by triangles in its plane with normals of their
/// own.
void CloseFoot(PlantMesh& mesh, int ring, int sides, const Vector3& direction)
{
  const int first = static_cast<int>(mesh.Points.size());
  for (int corner = 0; corner < sides; ++corner)
  {
    CopyVertex(mesh, ring + corner);
    mesh.Normals.back() = -direction;
  }
  for (int corner = 1; corner + 1 < sides; ++corner)
  {
    mesh.AddPolygon(std::array<int, 3>{ first, first + corner + 1, first + corner });
  }
}

/// Twigs are darker than the trunk, whatever that is.
Color BarkOf(const Color& trunk, int order)
{
  constexpr Color Twig{ 74, 60, 50 };
  const double part = std::min(0.9, 0.35 * order);
  Color bark{};
  for (int channel = 0; channel < 3; ++channel)
  {
    bark[channel] = static_cast<unsigned char>(std::lround((1.0 - part) * trunk[channel] + part * Twig[channel]));
  }
  return bark;
}

void SkinBranch(
  PlantMesh& mesh, const Skeleton& skeleton, const SkeletonBranch& branch, int sides, const BranchSkinOptions& options)
{
  Vector3 side = Perpendicular(DirectionAt(skeleton, branch, 0));
  const Color bark = BarkOf(options.Bark, branch.Order);
  const int foot = static_cast<int>(mesh.Points.size());
  double v = 0.0;
  for (int step = 0; step < branch.Count; ++step)
  {
    const SkeletonNode& node = skeleton.Nodes[branch.First + step];
    const Vector3 direction = DirectionAt(skeleton, branch, step);
    side = Carried(side, direction);
    const Vector3 other = glm::cross(direction, side);
    v += step > 0 ? glm::distance(node.Position, skeleton.Nodes[branch.First + step - 1].Position) : 0.0;
    for (int corner = 0; corner <= sides; ++corner)
    {
      const double angle = TwoPi * (corner % sides) / sides;
      const Vector3 normal = std::cos(angle) * side + std::sin(angle) * other;
      AddVertex(mesh, node.Position + node.Radius * normal, normal, static_cast<double>(corner) / sides,
        v / options.BarkLength, bark);
      AddJoints(mesh, branch, step);
    }
    if (step > 0)
    {
      JoinRings(mesh, sides);
    }
  }
  const SkeletonNode& tip = skeleton.Nodes[branch.First + branch.Count - 1];
  const Vector3 direction = DirectionAt(skeleton, branch, branch.Count - 1);
  const int ring = static_cast<int>(mesh.Points.size()) - (sides + 1);
  AddVertex(mesh, tip.Position + tip.Radius * direction, direction, 0.5, v / options.BarkLength, bark);
  AddJoints(mesh, branch, branch.Count - 1);
  for (int corner = 0; corner < sides; ++corner)
  {
    mesh.AddPolygon(std::array<int, 3>{ ring + corner, ring + corner + 1, ring + sides + 1 });
  }
  CloseFoot(mesh, foot, sides, DirectionAt(skeleton, branch, 0));
}

}

int NumberOfSides(double radius, double thickest, int maximumSides)
{
  const double part = thickest > 0.0 ? std::sqrt(std::clamp(radius / thickest, 0.0, 1.0)) : 1.0;
  return std::max(3, static_cast<int>(std::lround(maximumSides * part)));
}

PlantMesh SkinOf(const Skeleton& skeleton, const BranchSkinOptions& options)
{
  double thickest = 0.0;
  for (const SkeletonNode& node : skeleton.Nodes)
  {
    thickest = std::max(thickest, node.Radius);
  }
  PlantMesh mesh;
  for (const SkeletonBranch& branch : skeleton.Branches)
  {
    const int sides = NumberOfSides(skeleton.Nodes[branch.First].Radius, thickest, options.MaximumSides);
    SkinBranch(mesh, skeleton, branch, sides, options);
  }
  TurnNormalsToFronts(mesh); // where a thick branch bends sharply
  return mesh;
}

}
