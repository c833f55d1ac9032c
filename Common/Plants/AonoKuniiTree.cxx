// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/AonoKuniiTree.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Numerics/RandomStream.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <iterator>

namespace littoral
{

namespace
{

constexpr double Sway = 40.0 * Degree;          // of a segment's direction, at a variation of 1
constexpr double TernarySegment = 50.0 / 200.0; // of the first ternary fork's segments to the trunk, as published
constexpr double TernaryRoll = 45.0 * Degree;   // of the first ternary fork, as published

/// The frame of a growing tip: ahead, to the left and up, at right angles to each other.
struct Turtle
{
  Vector3 Ahead{ 0.0, 0.0, 1.0 };
  Vector3 Left{ 1.0, 0.0, 0.0 };
  Vector3 Up{ 0.0, 1.0, 0.0 };
};

/// Turns the first vector towards the second in their plane.
void Rotate(Vector3& from, Vector3& to, double angle)
{
  const Vector3 turned = std::cos(angle) * from + std::sin(angle) * to;
  to = std::cos(angle) * to - std::sin(angle) * from;
  from = turned;
}

Turtle TurnedLeft(Turtle turtle, double angle)
{
  Rotate(turtle.Ahead, turtle.Left, angle);
  return turtle;
}

Turtle PitchedDown(Turtle turtle, double angle)
{
  Rotate(turtle.Ahead, turtle.Up, -angle);
  return turtle;
}

Turtle Rolled(Turtle turtle, double angle)
{
  Rotate(turtle.Left, turtle.Up, angle);
  return turtle;
}

/// Rolled until its left is horizontal; as it is where it points straight up or down.
Turtle Levelled(Turtle turtle)
{
  const Vector3 left = glm::cross(Vector3(0.0, 0.0, 1.0), turtle.Ahead);
  if (glm::length(left) > 1e-6)
  {
    turtle.Left = glm::normalize(left);
    turtle.Up = glm::cross(turtle.Ahead, turtle.Left);
  }
  return turtle;
}

/// Bent towards a direction T by the angle e |H x T| [rad] about H x T (The Algorithmic Beauty of Plants, chapter 2).
Turtle Bent(Turtle turtle, const Vector3& towards, double susceptibility)
{
  const Vector3 moment = glm::cross(turtle.Ahead, towards);
  const double strength = glm::length(moment);
  if (strength < 1e-12 || susceptibility == 0.0)
  {
    return turtle;
  }
  const Vector3 axis = moment / strength;
  const double angle = susceptibility * strength;
  for (Vector3* vector : { &turtle.Ahead, &turtle.Left, &turtle.Up })
  {
    // Rodrigues: v cos a + n x v sin a + (1 - cos a) (n . v) n
    *vector = std::cos(angle) * *vector + std::sin(angle) * glm::cross(axis, *vector) +
      (1.0 - std::cos(angle)) * glm::dot(axis, *vector) * axis;
  }
  return turtle;
}

/// The letters of the rules: A is the axis of the tree, B and C are branches that fork to the one side and the other.
enum class Letter
{
  A,
  B,
  C,
};

/// State with which a branch starts.
struct Bud
{
  int Node; ///< node that carries it
  Vector3 Position;
  Turtle Frame;
  double Length; ///< of the next segment, unvaried [m]
  int Step;      ///< step at which its first segment was made
  Letter Kind;
  std::uint64_t Id; ///< of its next segment, for random numbers
};

class Forker
{
public:
  Forker(const AonoKuniiParameters& parameters, const Poll& poll)
    : P(parameters)
    , Towards(glm::length(parameters.Tropism) > 0.0 ? glm::normalize(parameters.Tropism) : Vector3(0.0, 0.0, 0.0))
    , Branches(parameters.Seed, RandomPurpose::ForkBranches)
    , Leafing(parameters.Seed, RandomPurpose::ForkLeaves)
    , Steps(poll)
  {
  }

  Plant Run()
  {
    this->Tree.Leaf = this->P.Leaf;
    this->Tree.Bark = this->P.Bark;
    this->Tree.Form = this->P.Outline;
    const bool ternary = this->P.Form == Branching::Ternary;
    const double length = this->P.TrunkLength * this->Vary(0, 0);
    this->Buds.push_back({ -1, { 0.0, 0.0, 0.0 }, {}, length, ternary ? 0 : 1, Letter::A, 1 });
    while (!this->Buds.empty())
    {
      const Bud bud = this->Buds.front();
      this->Buds.pop_front();
      if (ternary)
      {
        this->GrowTernary(bud);
      }
      else
      {
        this->GrowBinary(bud);
      }
    }
    this->GrowLeaves();
    return std::move(this->Tree);
  }

private:
  const AonoKuniiParameters& P;
  Vector3 Towards;
  RandomStream Branches;
  RandomStream Leafing;
  SteppedPoll Steps;
  Plant Tree;
  std::deque<Bud> Buds;
  std::vector<int> Twigs; ///< nodes at the feet of the last segments

  /// A factor of mean 1, never far from it.
  double Vary(std::uint64_t object, std::uint64_t draw) const
  {
    const double deviate = std::clamp(this->Branches.NormalPair(object, draw)[0], -2.0, 2.0);
    return std::max(0.2, 1.0 + this->P.Variation * deviate);
  }

  /// An angle [rad] from one of the parameters [degrees].
  double Angle(double degrees, std::uint64_t id, std::uint64_t draw) const
  {
    return degrees * Degree * this->Vary(id, draw);
  }

  double Radius(int forks) const { return this->P.TrunkRadius * std::pow(this->P.WidthRatio, forks); }

  /// Adds a segment to the last branch, bends the tip after it, and returns the node at its foot.
  int Lengthen(Bud& tip, double radiusAbove, std::uint64_t draw)
  {
    this->Steps.Step();
    const auto sway = this->Branches.NormalPair(tip.Id, draw);
    const double amount = tip.Id == 1 ? 0.25 * Sway : Sway;
    tip.Frame = TurnedLeft(tip.Frame, amount * this->P.Variation * std::clamp(sway[0], -2.0, 2.0));
    tip.Frame = PitchedDown(tip.Frame, amount * this->P.Variation * std::clamp(sway[1], -2.0, 2.0));
    tip.Position += tip.Length * this->Vary(tip.Id, draw + 1) * tip.Frame.Ahead;
    const int node = this->Tree.Wood.Grow(tip.Position, radiusAbove);
    tip.Frame = Bent(tip.Frame, this->Towards, this->P.Susceptibility);
    return node - 1;
  }

  /// The weaker branch of a fork.
  Bud SideBud(const Bud& tip, int node) const
  {
    Bud side = tip;
    side.Node = node;
    side.Id = 2 * tip.Id + 1;
    side.Step = tip.Step + 1;
    side.Length = this->P.LengthRatio2 * tip.Length;
    side.Kind = tip.Kind == Letter::B && this->P.Form == Branching::Monopodial ? Letter::C : Letter::B;
    if (tip.Kind == Letter::A)
    {
      const bool sympodial = this->P.Form == Branching::Sympodial;
      const Turtle around = sympodial ? Rolled(tip.Frame, this->P.DivergenceAngle * Degree) : tip.Frame;
      side.Frame = PitchedDown(around, this->Angle(sympodial ? this->P.Angle2 : this->P.Angle1, side.Id, 0));
      return side;
    }
    const double angle = this->Angle(this->P.Angle2, side.Id, 0);
    side.Frame = Levelled(TurnedLeft(tip.Frame, tip.Kind == Letter::B ? -angle : angle));
    return side;
  }

  /// The stronger branch of a fork, which is the rest of the branch that forks.
  Bud MainBud(Bud tip) const
  {
    const Letter kind = tip.Kind;
    tip.Id = 2 * tip.Id;
    tip.Step += 1;
    tip.Length *= this->P.LengthRatio1;
    if (this->P.Form == Branching::Sympodial)
    {
      const double angle = this->Angle(this->P.Angle1, tip.Id, 0);
      tip.Frame = kind == Letter::A ? PitchedDown(tip.Frame, angle) : Levelled(TurnedLeft(tip.Frame, angle));
      tip.Kind = Letter::B;
    }
    else if (kind == Letter::A)
    {
      tip.Frame = Rolled(tip.Frame, this->Angle(this->P.DivergenceAngle, tip.Id, 0));
    }
    else
    {
      tip.Kind = kind == Letter::B ? Letter::C : Letter::B;
    }
    return tip;
  }

  void GrowBinary(Bud tip)
  {
    this->Tree.Wood.StartBranch(tip.Node, tip.Position, this->Radius(tip.Step - 1));
    for (; tip.Step < this->P.Iterations; tip = this->MainBud(tip))
    {
      const int foot = this->Lengthen(tip, this->Radius(tip.Step), 1);
      this->Buds.push_back(this->SideBud(tip, foot + 1));
    }
    this->Twigs.push_back(this->Lengthen(tip, this->Radius(tip.Step), 1));
  }

  /// A branch between two forks, of two segments: one that an earlier step made and one of the next step.
  void GrowTernary(Bud tip)
  {
    const double first = tip.Step == 0 ? TernarySegment * tip.Length : tip.Length;
    const bool last = tip.Step == this->P.Iterations;
    this->Tree.Wood.StartBranch(tip.Node, tip.Position, this->Radius(tip.Step));
    int foot = this->Lengthen(tip, this->Radius(last ? tip.Step + 1 : tip.Step), 1);
    if (last)
    {
      this->Twigs.push_back(foot);
      return;
    }
    if (tip.Step == 0)
    {
      tip.Frame = Rolled(tip.Frame, TernaryRoll);
    }
    tip.Length = first / this->P.Elongation;
    tip.Step += 1;
    foot = this->Lengthen(tip, this->Radius(tip.Step), 4);
    const double rolls[] = { 0.0, this->P.DivergenceAngle * Degree,
      (this->P.DivergenceAngle + this->P.DivergenceAngle2) * Degree };
    for (std::uint64_t side = 0; side < 3; ++side)
    {
      Bud bud = tip;
      bud.Node = foot;
      bud.Id = 4 * tip.Id + side + 1;
      bud.Frame = PitchedDown(Rolled(tip.Frame, rolls[side]), this->Angle(this->P.Angle1, bud.Id, 0));
      this->Buds.push_back(bud);
    }
  }

  /// Places leaves on the last segments.
  void PlaceLeaves()
  {
    const std::vector<SkeletonNode>& nodes = this->Tree.Wood.Nodes;
    this->Tree.Leaves.resize(static_cast<std::size_t>(this->P.NumberOfLeaves));
    for (std::size_t index = 0; index < this->Tree.Leaves.size(); ++index)
    {
      this->Steps.Step();
      LeafParticle& leaf = this->Tree.Leaves[index];
      const auto place = this->Leafing.UniformPair(index, 0);
      const auto across = this->Leafing.NormalPair(index, 1);
      const auto up = this->Leafing.NormalPair(index, 2);
      const double spread = 0.4 * this->P.LeafSize;
      leaf.Node = this->Twigs[index % this->Twigs.size()];
      leaf.Position = glm::mix(nodes[leaf.Node].Position, nodes[leaf.Node + 1].Position, place[0]) +
        spread *
          Vector3(std::clamp(across[0], -2.0, 2.0), std::clamp(across[1], -2.0, 2.0), std::clamp(up[0], -2.0, 2.0));
      leaf.Size = this->P.LeafSize * std::clamp(1.0 + 2.0 * this->P.Variation * up[1], 0.4, 1.6);
      leaf.Width = this->P.LeafWidth;
    }
  }

  /// The smaller one of the cone and the ellipsoid around the leaves and the last segments.
  CrownVolume Around() const
  {
    std::vector<Vector3> positions;
    positions.reserve(this->Tree.Leaves.size() + this->Twigs.size());
    for (const LeafParticle& leaf : this->Tree.Leaves)
    {
      positions.push_back(leaf.Position);
    }
    for (const int twig : this->Twigs)
    {
      positions.push_back(this->Tree.Wood.Nodes[twig + 1].Position);
    }
    const CrownVolume cone = VolumeAround(positions, CrownShape::Cone);
    const CrownVolume ellipsoid = VolumeAround(positions, CrownShape::Ellipsoid);
    const double ratio =
      cone.Radius * cone.Radius * cone.Height / (2.0 * ellipsoid.Radius * ellipsoid.Radius * ellipsoid.Height);
    return ratio < 1.0 ? cone : ellipsoid;
  }

  void GrowLeaves()
  {
    this->PlaceLeaves();
    this->Tree.Crown = this->Around();
    for (std::size_t index = 0; index < this->Tree.Leaves.size(); ++index)
    {
      this->Steps.Step();
      LeafParticle& leaf = this->Tree.Leaves[index];
      FinishLeaf(leaf, this->Tree, this->Leafing, index, static_cast<std::uint64_t>(leaf.Node));
    }
  }
};

/// Parameters in which the four trees of a figure differ.
struct Published
{
  double Ratio1, Ratio2, Angle1, Angle2;
};

// Length ratios 1 and 2, angles 1 and 2.
constexpr Published Monopodial[] = { { 0.9, 0.6, 45.0, 45.0 }, { 0.9, 0.9, 45.0, 45.0 }, { 0.9, 0.8, 45.0, 45.0 },
  { 0.9, 0.7, 30.0, -30.0 } };
constexpr Published Sympodial[] = { { 0.9, 0.7, 5.0, 65.0 }, { 0.9, 0.7, 10.0, 60.0 }, { 0.9, 0.8, 20.0, 50.0 },
  { 0.9, 0.8, 35.0, 35.0 } };

struct PublishedTernary
{
  double Divergence1, Divergence2, Angle, Elongation, Tropism[3], Susceptibility;
  int Iterations;
};

// Divergences 1 and 2, angle, elongation, tropism, susceptibility, iterations. The figures have y up: (x, y, z) there
// is (x, -z, y) here.
constexpr PublishedTernary Ternary[] = { { 94.74, 132.63, 18.95, 1.109, { 0.0, 0.0, -1.0 }, 0.22, 6 },
  { 137.5, 137.5, 18.95, 1.109, { 0.0, 0.0, -1.0 }, 0.14, 8 },
  { 112.5, 157.5, 22.5, 1.79, { -0.02, 0.0, -1.0 }, 0.27, 8 },
  { 180.0, 252.0, 36.0, 1.07, { -0.61, 0.19, 0.77 }, 0.4, 6 } };

/// Parameters that the figures do not give: size in metres, leaves and colors.
struct Dress
{
  double TrunkLength, TrunkRadius, LeafSize, LeafWidth;
  int NumberOfLeaves;
  Color Leaf, Bark;
};

constexpr Dress Dresses[] = {
  // trunk's length and radius, size and width of leaves, number of leaves, colors of leaves and bark
  { 1.9, 0.17, 0.27, 0.6, 12000, { 138, 172, 70 }, { 112, 94, 76 } },
  { 1.9, 0.24, 0.28, 0.65, 16000, { 128, 166, 68 }, { 106, 90, 72 } },
  { 2.0, 0.24, 0.28, 0.65, 15000, { 146, 176, 74 }, { 118, 100, 82 } },
  { 2.0, 0.19, 0.27, 0.6, 13000, { 154, 184, 84 }, { 126, 110, 92 } },
  { 2.1, 0.2, 0.27, 0.6, 13000, { 160, 182, 78 }, { 118, 102, 84 } },
  { 2.1, 0.22, 0.27, 0.6, 13000, { 142, 174, 74 }, { 112, 96, 80 } },
  { 2.2, 0.24, 0.27, 0.65, 15000, { 134, 172, 78 }, { 112, 98, 82 } },
  { 2.2, 0.25, 0.27, 0.65, 15000, { 150, 176, 72 }, { 110, 94, 78 } },
  { 4.2, 0.26, 0.28, 0.55, 15000, { 140, 172, 72 }, { 114, 98, 80 } },
  { 3.6, 0.26, 0.26, 0.55, 19000, { 136, 172, 76 }, { 116, 100, 84 } },
  { 5.5, 0.2, 0.24, 0.5, 14000, { 146, 174, 74 }, { 118, 102, 86 } },
  { 4.0, 0.26, 0.26, 0.5, 14000, { 128, 158, 80 }, { 120, 100, 80 } },
};

void TakePublished(const Published& published, AonoKuniiParameters& p)
{
  p.LengthRatio1 = published.Ratio1;
  p.LengthRatio2 = published.Ratio2;
  p.Angle1 = published.Angle1;
  p.Angle2 = published.Angle2;
}

void TakePublished(const PublishedTernary& published, AonoKuniiParameters& p)
{
  p.Iterations = published.Iterations;
  p.DivergenceAngle = published.Divergence1;
  p.DivergenceAngle2 = published.Divergence2;
  p.Angle1 = published.Angle;
  p.Elongation = published.Elongation;
  p.Tropism = { published.Tropism[0], published.Tropism[1], published.Tropism[2] };
  p.Susceptibility = published.Susceptibility;
  p.WidthRatio = 1.0 / 1.732;
}

void PutOn(const Dress& dress, AonoKuniiParameters& p)
{
  p.TrunkLength = dress.TrunkLength;
  p.TrunkRadius = dress.TrunkRadius;
  p.LeafSize = dress.LeafSize;
  p.LeafWidth = dress.LeafWidth;
  p.NumberOfLeaves = dress.NumberOfLeaves;
  p.Leaf = dress.Leaf;
  p.Bark = dress.Bark;
}

}

const char* ForkPresetName(ForkPreset preset)
{
  constexpr const char* names[] = { "Custom", "MonopodialA", "MonopodialB", "MonopodialC", "MonopodialD", "SympodialA",
    "SympodialB", "SympodialC", "SympodialD", "TernaryA", "TernaryB", "TernaryC", "TernaryD" };
  static_assert(std::size(names) == NumberOfForkPresets && std::size(Dresses) + 1 == NumberOfForkPresets);
  return names[static_cast<int>(preset)];
}

AonoKuniiParameters PresetParameters(ForkPreset preset)
{
  AonoKuniiParameters p;
  const int index = static_cast<int>(preset) - 1;
  if (index < 0 || index + 1 >= NumberOfForkPresets)
  {
    return p;
  }
  p.Form = static_cast<Branching>(index / 4);
  if (p.Form == Branching::Ternary)
  {
    TakePublished(Ternary[index % 4], p);
  }
  else
  {
    TakePublished(p.Form == Branching::Monopodial ? Monopodial[index % 4] : Sympodial[index % 4], p);
    p.DivergenceAngle = p.Form == Branching::Monopodial ? 137.5 : 180.0;
  }
  PutOn(Dresses[index], p);
  return p;
}

int MaximumIterations(Branching form)
{
  return form == Branching::Ternary ? 10 : 15;
}

std::string WhyInvalid(const AonoKuniiParameters& p)
{
  ParameterCheck check;
  for (int axis = 0; axis < 3; ++axis)
  {
    check.Finite("Tropism[" + std::to_string(axis) + "]", p.Tropism[axis]);
  }
  check.Choice("Branching", static_cast<int>(p.Form), 3);
  check.Count("Iterations", p.Iterations, 1, MaximumIterations(p.Form));
  check.Range("LengthRatio1", p.LengthRatio1, 0.3, 1.2);
  check.Range("LengthRatio2", p.LengthRatio2, 0.3, 1.2);
  check.Range("Angle1", p.Angle1, -90.0, 90.0, "degrees");
  check.Range("Angle2", p.Angle2, -90.0, 90.0, "degrees");
  check.Range("DivergenceAngle", p.DivergenceAngle, -360.0, 360.0, "degrees");
  check.Range("DivergenceAngle2", p.DivergenceAngle2, -360.0, 360.0, "degrees");
  check.Range("WidthRatio", p.WidthRatio, 0.3, 1.0);
  check.Range("Elongation", p.Elongation, 0.8, 3.0);
  check.Range("Susceptibility", p.Susceptibility, 0.0, 1.0);
  check.Range("TrunkLength", p.TrunkLength, 0.01, 50.0, "m");
  check.Range("TrunkRadius", p.TrunkRadius, 0.001, 10.0, "m");
  check.Range("Variation", p.Variation, 0.0, 0.5);
  check.Count("NumberOfLeaves", p.NumberOfLeaves, 0, 1000000);
  check.Range("LeafSize", p.LeafSize, 0.001, 5.0, "m");
  check.Range("LeafWidth", p.LeafWidth, 0.01, 2.0);
  check.Choice("LeafForm", static_cast<int>(p.Outline), 3);
  return check.Reason();
}

Plant GrowAonoKuniiTree(const AonoKuniiParameters& parameters, const Poll& poll)
{
  return Forker(parameters, poll).Run();
}

}
