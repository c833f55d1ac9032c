// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sway/LimbModes.h"

#include "Numerics/Constants.h"
#include "Sway/BeamModes.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr int PiecesOfSegment = 2;

/// Weight of leaves in the inertia that shapes the deflections, as a layer of wood of this part of the trunk's length:
/// 0.35 kg/m2 on a trunk of 12 m. So the shapes of a scaled plant are the same.
constexpr double UsualLeafDepth = 3e-5;

/// A piece of a branch: two rigid halves and a spring in the middle, where its mass is.
struct Piece
{
  int Below;      // piece whose upper half it grows on, or -1: the trunk
  Vector3 Middle; // [m]
  Vector3 Axis;
  double Give;   // angle for a bending moment, times Young's modulus [1/m3]
  double Wood;   // [m3]
  double Leaves; // [m2]
  int Limb;
  int Shape; // in which it bends
};

/// Attachment of a branch to the trunk.
struct Foot
{
  Vector3 Place;
  double Part;  // of the trunk's length
  double Shift; // of a uniform trunk there in its first mode
  double Turn;  // [1/m]
};

/// Displacements of all pieces, or forces on them; for the two directions across the axis.
using Field = std::array<std::vector<Vector3>, 2>;

/// Adds a mass in one of the two directions, of which the mean is taken.
void AddBurden(const std::array<Vector3, LimbShapes>& places, const Vector3& shifted, const Vector3& turned,
  double amount, LimbBurden& burden)
{
  for (int i = 0; i < LimbShapes; ++i)
  {
    for (int j = 0; j < LimbShapes; ++j)
    {
      burden.Mass[i * LimbShapes + j] += 0.5 * amount * glm::dot(places[i], places[j]);
    }
    burden.Shift[i] += 0.5 * amount * glm::dot(places[i], shifted);
    burden.Turn[i] += 0.5 * amount * glm::dot(places[i], turned);
  }
}

class LimbMeasurer
{
public:
  LimbMeasurer(const Skeleton& skeleton, const std::vector<double>& leafAreas)
    : Plant(skeleton)
    , LeafAreas(leafAreas)
    , Length(skeleton.BranchLength(0))
    , Axis(Normalised(skeleton.Nodes[skeleton.Tip(0)].Position - skeleton.Nodes[0].Position))
  {
    this->Across[0] = Perpendicular(this->Axis);
    this->Across[1] = glm::cross(this->Axis, this->Across[0]);
    this->TakePieces();
  }

  std::vector<LimbMeasures> Run() const
  {
    std::vector<LimbMeasures> limbs(this->Feet.size());
    for (std::size_t limb = 0; limb < limbs.size(); ++limb)
    {
      limbs[limb].Part = this->Feet[limb].Part;
    }
    const std::array<Field, LimbShapes> shapes = this->Shapes();
    for (int direction = 0; direction < 2; ++direction)
    {
      for (std::size_t i = 0; i < this->Pieces.size(); ++i)
      {
        const Piece& piece = this->Pieces[i];
        std::array<Vector3, LimbShapes> places;
        std::transform(
          shapes.begin(), shapes.end(), places.begin(), [=](const Field& shape) { return shape[direction][i]; });
        const Vector3 turned = this->Turned(piece, direction);
        AddBurden(places, this->Across[direction], turned, piece.Wood, limbs[piece.Limb].Wood);
        AddBurden(places, this->Across[direction], turned, piece.Leaves, limbs[piece.Limb].Leaves);
      }
    }
    return limbs;
  }

private:
  const Skeleton& Plant;
  const std::vector<double>& LeafAreas;
  double Length;
  Vector3 Axis;
  std::array<Vector3, 2> Across;
  std::vector<Piece> Pieces;
  std::vector<Foot> Feet;

  /// The piece that carries what grows from a node, so far along the segment above it [m].
  int Carrier(int node, double away, const std::vector<int>& firstOf) const
  {
    const SkeletonNode& at = this->Plant.Nodes[node];
    if (at.Branch == 0)
    {
      return -1;
    }
    if (node == this->Plant.Tip(at.Branch))
    {
      return firstOf[node - 1] + PiecesOfSegment - 1;
    }
    const double length = glm::distance(at.Position, this->Plant.Nodes[node + 1].Position);
    // Springs are at half a piece, one and a half...
    const int passed = static_cast<int>(std::floor(away / length * PiecesOfSegment + 0.5));
    const int piece = std::min(passed, PiecesOfSegment) - 1;
    return piece >= 0 ? firstOf[node] + piece : this->Pieces[firstOf[node]].Below;
  }

  void TakePieces()
  {
    const std::vector<SkeletonNode>& nodes = this->Plant.Nodes;
    std::vector<int> firstOf(nodes.size(), -1); // piece of the segment above a node
    std::vector<double> places(this->Plant.Branches[0].Count, 0.0);
    for (std::size_t node = 1; node < places.size(); ++node)
    {
      places[node] = places[node - 1] + glm::distance(nodes[node].Position, nodes[node - 1].Position);
    }
    std::vector<int> limbOf(this->Plant.Branches.size(), -1);
    for (int branch = 1; branch < static_cast<int>(this->Plant.Branches.size()); ++branch)
    {
      const SkeletonBranch& run = this->Plant.Branches[branch];
      const SkeletonNode& first = nodes[run.First];
      const double away = glm::distance(first.Position, nodes[first.Parent].Position);
      limbOf[branch] = limbOf[nodes[first.Parent].Branch];
      if (nodes[first.Parent].Branch == 0)
      {
        limbOf[branch] = static_cast<int>(this->Feet.size());
        const double part = std::min(1.0, (places[first.Parent] + away) / this->Length);
        this->Feet.push_back({ first.Position, part, ModeShape(1, part), ModeSlope(1, part) / this->Length });
      }
      int below = this->Carrier(first.Parent, away, firstOf);
      for (int node = run.First; node < run.First + run.Count - 1; ++node)
      {
        firstOf[node] = static_cast<int>(this->Pieces.size());
        below = this->AddSegment(node, below, limbOf[branch]);
      }
    }
  }

  int AddSegment(int node, int below, int limb)
  {
    const SkeletonNode& a = this->Plant.Nodes[node];
    const SkeletonNode& b = this->Plant.Nodes[node + 1];
    const double leaves = this->LeafAreas.empty()
      ? 0.0
      : this->LeafAreas[node] + (node + 1 == this->Plant.Tip(a.Branch) ? this->LeafAreas[node + 1] : 0.0);
    const double length = glm::distance(a.Position, b.Position) / PiecesOfSegment;
    for (int piece = 0; piece < PiecesOfSegment; ++piece)
    {
      const double low = a.Radius + static_cast<double>(piece) / PiecesOfSegment * (b.Radius - a.Radius);
      const double high = a.Radius + (piece + 1.0) / PiecesOfSegment * (b.Radius - a.Radius);
      const double squares = low * low + low * high + high * high;
      // int ds / I of a cone
      const double give = length * squares / (3.0 * std::pow(low * high, 3)) / (0.25 * Pi);
      const Vector3 middle = a.Position + (piece + 0.5) / PiecesOfSegment * (b.Position - a.Position);
      this->Pieces.push_back({ below, middle, Normalised(b.Position - a.Position), give, Pi / 3.0 * squares * length,
        leaves / PiecesOfSegment, limb, std::clamp(this->Plant.Branches[a.Branch].Order, 1, LimbShapes) - 1 });
      below = static_cast<int>(this->Pieces.size()) - 1;
    }
    return below;
  }

  /// Displacement of a piece when its limb's foot turns by 1, so that the parts above go along the direction.
  Vector3 Turned(const Piece& piece, int direction) const
  {
    return glm::cross(glm::cross(this->Axis, this->Across[direction]), piece.Middle - this->Feet[piece.Limb].Place);
  }

  /// The inertia of all pieces when a uniform trunk carries them in its first mode.
  std::vector<Vector3> Inertia(int direction) const
  {
    std::vector<Vector3> forces;
    for (const Piece& piece : this->Pieces)
    {
      const Foot& foot = this->Feet[piece.Limb];
      const Vector3 place = foot.Shift * this->Across[direction] + foot.Turn * this->Turned(piece, direction);
      forces.push_back((piece.Wood + UsualLeafDepth * this->Length * piece.Leaves) * place);
    }
    return forces;
  }

  /// Moments [N m] at the springs, from the tips down, of forces on all pieces.
  std::vector<Vector3> Moments(std::vector<Vector3> forces) const
  {
    std::vector<Vector3> moments(forces.size(), Vector3(0.0));
    for (int i = static_cast<int>(forces.size()) - 1; i >= 0; --i)
    {
      const int below = this->Pieces[i].Below;
      if (below >= 0)
      {
        const Vector3 arm = this->Pieces[i].Middle - this->Pieces[below].Middle;
        moments[below] += moments[i] + glm::cross(arm, forces[i]);
        forces[below] += forces[i];
      }
    }
    return moments;
  }

  /// Displacements, from the feet up, where the springs of one shape turn by so much.
  std::vector<Vector3> Places(const std::vector<Vector3>& turns, int shape) const
  {
    std::vector<Vector3> angles(turns.size(), Vector3(0.0));
    std::vector<Vector3> places(turns.size(), Vector3(0.0));
    for (std::size_t i = 0; i < turns.size(); ++i)
    {
      const Piece& piece = this->Pieces[i];
      angles[i] = piece.Shape == shape ? turns[i] : Vector3(0.0);
      if (piece.Below >= 0)
      {
        const Vector3 arm = piece.Middle - this->Pieces[piece.Below].Middle;
        places[i] = places[piece.Below] + glm::cross(angles[piece.Below], arm);
        angles[i] += angles[piece.Below];
      }
    }
    return places;
  }

  /// Static shapes of the branches of each order under the inertia of all that they bear when a uniform trunk carries
  /// them in its first mode, with the strain energy 1/2.
  std::array<Field, LimbShapes> Shapes() const
  {
    std::array<Field, LimbShapes> shapes;
    std::vector<std::array<double, LimbShapes>> energies(this->Feet.size());
    for (int direction = 0; direction < 2; ++direction)
    {
      std::vector<Vector3> turns = this->Moments(this->Inertia(direction));
      for (std::size_t i = 0; i < turns.size(); ++i)
      {
        // kappa = m_bend / (E I) + m_twist / (G J)
        const Piece& piece = this->Pieces[i];
        const Vector3 moment = turns[i];
        const Vector3 twist = glm::dot(moment, piece.Axis) * piece.Axis;
        turns[i] = piece.Give * (moment - twist + twist / TwistPart);
        energies[piece.Limb][piece.Shape] += 0.5 * glm::dot(moment, turns[i]);
      }
      for (int shape = 0; shape < LimbShapes; ++shape)
      {
        shapes[shape][direction] = this->Places(turns, shape);
      }
    }
    for (int shape = 0; shape < LimbShapes; ++shape)
    {
      for (std::vector<Vector3>& places : shapes[shape])
      {
        for (std::size_t i = 0; i < places.size(); ++i)
        {
          const double energy = energies[this->Pieces[i].Limb][shape];
          places[i] *= energy > 0.0 ? 1.0 / std::sqrt(energy) : 0.0;
        }
      }
    }
    return shapes;
  }
};

}

std::vector<LimbMeasures> MeasureLimbs(const Skeleton& skeleton, const std::vector<double>& leafAreas)
{
  return LimbMeasurer(skeleton, leafAreas).Run();
}

}
