// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LimbModes.h"

#include "BeamModes.h"
#include "Constants.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr int PiecesOfSegment = 2;
/// In the inertia that shapes the deflections leaves weigh as much as a layer of wood of this part of the trunk's
/// length: 0.35 kg/m2 on a trunk of 12 m. So the shapes of a scaled plant are the same.
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

/// Where a branch leaves the trunk.
struct Foot
{
  Vector3 Place;
  double Part; // of the trunk's length
};

/// Displacements of all pieces, or forces on them; for the two directions across the axis.
using Field = std::array<std::vector<Vector3>, 2>;

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
    const Field shift = this->Carried(1.0, 0.0);
    const Field turn = this->Carried(0.0, 1.0);
    for (int i = 0; i < LimbShapes; ++i)
    {
      for (const bool isWood : { true, false })
      {
        LimbBurden LimbMeasures::*burden = isWood ? &LimbMeasures::Wood : &LimbMeasures::Leaves;
        const Field force = this->Inertia(shapes[i], isWood ? 1.0 : 0.0, isWood ? 0.0 : 1.0);
        const auto take = [&](const Field& field, auto&& to) {
          const std::vector<double> products = this->Products(force, field);
          for (std::size_t limb = 0; limb < limbs.size(); ++limb)
          {
            to(limbs[limb].*burden) = products[limb];
          }
        };
        for (int j = 0; j < LimbShapes; ++j)
        {
          take(shapes[j], [=](LimbBurden& own) -> double& { return own.Mass[i * LimbShapes + j]; });
        }
        take(shift, [=](LimbBurden& own) -> double& { return own.Shift[i]; });
        take(turn, [=](LimbBurden& own) -> double& { return own.Turn[i]; });
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
        this->Feet.push_back({ first.Position, part });
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

  /// All pieces carried along by a shift of the feet across the axis, and a turn that takes what is above that way.
  Field Carried(double shift, double turn) const
  {
    Field field;
    for (int direction = 0; direction < 2; ++direction)
    {
      const Vector3 angle = turn * glm::cross(this->Axis, this->Across[direction]);
      for (const Piece& piece : this->Pieces)
      {
        field[direction].push_back(
          shift * this->Across[direction] + glm::cross(angle, piece.Middle - this->Feet[piece.Limb].Place));
      }
    }
    return field;
  }

  Field Inertia(const Field& field, double density, double leafMass) const
  {
    Field forces = field;
    for (std::vector<Vector3>& force : forces)
    {
      for (std::size_t i = 0; i < force.size(); ++i)
      {
        force[i] *= density * this->Pieces[i].Wood + leafMass * this->Pieces[i].Leaves;
      }
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

  /// What branches of each order do under the inertia of all that they bear when a uniform trunk carries them in its
  /// first mode, with the strain energy 1/2.
  std::array<Field, LimbShapes> Shapes() const
  {
    std::array<Field, LimbShapes> shapes;
    std::vector<std::array<double, LimbShapes>> energies(this->Feet.size());
    Field forces = this->Inertia(this->CarriedByTrunk(), 1.0, UsualLeafDepth * this->Length);
    for (int direction = 0; direction < 2; ++direction)
    {
      std::vector<Vector3> turns = this->Moments(forces[direction]);
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

  Field CarriedByTrunk() const
  {
    Field field = this->Carried(1.0, 0.0);
    const Field turn = this->Carried(0.0, 1.0);
    for (int direction = 0; direction < 2; ++direction)
    {
      for (std::size_t i = 0; i < this->Pieces.size(); ++i)
      {
        const double part = this->Feet[this->Pieces[i].Limb].Part;
        field[direction][i] =
          ModeShape(1, part) * field[direction][i] + ModeSlope(1, part) / this->Length * turn[direction][i];
      }
    }
    return field;
  }

  /// By limb, as a mean over the directions.
  std::vector<double> Products(const Field& a, const Field& b) const
  {
    std::vector<double> sums(this->Feet.size(), 0.0);
    for (int direction = 0; direction < 2; ++direction)
    {
      for (std::size_t i = 0; i < this->Pieces.size(); ++i)
      {
        sums[this->Pieces[i].Limb] += 0.5 * glm::dot(a[direction][i], b[direction][i]);
      }
    }
    return sums;
  }
};

}

std::vector<LimbMeasures> MeasureLimbs(const Skeleton& skeleton, const std::vector<double>& leafAreas)
{
  return LimbMeasurer(skeleton, leafAreas).Run();
}

}
