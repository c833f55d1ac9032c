// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/ReevesTree.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Numerics/RandomStream.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace littoral
{

namespace
{

constexpr double GoldenAngle = 2.39996322972865332; // of the leaves of many plants [rad]
constexpr int SegmentsOfTrunk = 12;
constexpr int SegmentsOfBranch[] = { 6, 4, 2, 2 }; // by order; twigs bend little and are many
constexpr double ShortestBranch = 0.006;           // as part of the height
constexpr double StemForm = 0.65;                  // power of the distance from the top to which a bare stem is thick
constexpr double MostBranches = 100000.0;

/// Branches of all orders for each main branch: 1 + s + s^2 + ...
double BranchesOfMain(const ReevesTreeParameters& p)
{
  double branches = 0.0;
  for (int order = 1; order <= p.Orders; ++order)
  {
    branches = branches * p.SideBranches + 1.0;
  }
  return branches;
}

/// State with which a branch starts.
struct Bud
{
  int Node;
  Vector3 Position;
  Vector3 Direction;
  double Length; // [m]
  int Segments;
};

class Grower
{
public:
  Grower(const ReevesTreeParameters& parameters, const Poll& poll)
    : P(parameters)
    , Crown(CrownOf(parameters))
    , Branching(parameters.Seed, RandomPurpose::TreeBranches)
    , Leafing(parameters.Seed, RandomPurpose::TreeLeaves)
    , Steps(poll)
  {
  }

  Plant Run()
  {
    this->Tree.Crown = this->Crown;
    this->Tree.Leaf = this->P.Leaf;
    this->Tree.Bark = this->P.Bark;
    this->Tree.Form = this->P.Form;
    this->GrowTrunk();
    this->GrowBranches(0);
    this->Thicken();
    this->GrowLeaves();
    return std::move(this->Tree);
  }

private:
  const ReevesTreeParameters& P;
  CrownVolume Crown;
  RandomStream Branching;
  RandomStream Leafing;
  SteppedPoll Steps;
  Plant Tree;

  /// A factor of mean 1, never far from it.
  double Vary(std::uint64_t object, std::uint64_t draw) const
  {
    const double deviate = std::clamp(this->Branching.NormalPair(object, draw)[0], -2.0, 2.0);
    return std::max(0.2, 1.0 + this->P.Variation * deviate);
  }

  void GrowTrunk()
  {
    Skeleton& wood = this->Tree.Wood;
    const double reach = this->P.Height * this->P.TrunkReach;
    wood.StartBranch(-1, { 0.0, 0.0, 0.0 }, 1.0);
    Vector3 position{ 0.0, 0.0, 0.0 };
    for (int step = 1; step <= SegmentsOfTrunk; ++step)
    {
      const double part = static_cast<double>(step) / SegmentsOfTrunk;
      const auto sway = this->Branching.NormalPair(0, 100 + step);
      const double amount = 0.03 * this->P.Variation * reach / SegmentsOfTrunk * (1.0 - part) * 5.0;
      position = { position[0] + amount * std::clamp(sway[0], -2.0, 2.0),
        position[1] + amount * std::clamp(sway[1], -2.0, 2.0), reach * part };
      wood.Grow(position, 1.0);
    }
  }

  /// Distance to the surface of the crown [m].
  double Reach(const Vector3& position, const Vector3& direction) const
  {
    const double step = (this->P.Height + this->P.CrownRadius) / 200.0;
    double reach = 0.0;
    while (reach < 2.0 * this->P.Height + 2.0 * this->P.CrownRadius &&
      Depth(this->Crown, position + (reach + step) * direction) > 0.0)
    {
      reach += step;
    }
    return reach;
  }

  Bud MakeBud(int parent, int index, int count) const
  {
    const Skeleton& wood = this->Tree.Wood;
    const bool onTrunk = parent == 0;
    const std::uint64_t object = static_cast<std::uint64_t>(parent) * 4096 + static_cast<std::uint64_t>(index) + 1;
    const auto place = this->Branching.UniformPair(object, 0);
    const double reach = this->P.Height * this->P.TrunkReach;
    const double low = onTrunk ? std::min(0.95, this->P.CrownBase / reach) : 0.2;
    Bud bud{};
    bud.Position = wood.Along(parent, low + (0.98 - low) * (index + place[0]) / count, bud.Node);
    // d = cos(angle) axis + sin(angle) around, about the axis by the golden angle from branch to branch
    const Vector3 axis = Normalised(wood.Nodes[bud.Node + 1].Position - wood.Nodes[bud.Node].Position);
    const Vector3 side = Perpendicular(axis);
    const double turn = index * GoldenAngle + place[1];
    const Vector3 around = std::cos(turn) * side + std::sin(turn) * glm::cross(axis, side);
    const double angle = std::min(2.6, this->P.BranchAngle * Pi / 180.0 * this->Vary(object, 1));
    bud.Direction = Normalised(std::cos(angle) * axis + std::sin(angle) * around);
    const double parentLength = wood.BranchLength(parent);
    bud.Length = onTrunk ? this->Reach(bud.Position, bud.Direction) : 0.5 * parentLength;
    bud.Length *= this->Vary(object, 2);
    bud.Segments = SegmentsOfBranch[wood.Branches[parent].Order];
    return bud;
  }

  /// Grows one branch until its length is reached or the crown's surface.
  void GrowBranch(const Bud& bud)
  {
    std::vector<Vector3> path;
    Vector3 position = bud.Position;
    Vector3 direction = bud.Direction;
    const double step = bud.Length / bud.Segments;
    for (int segment = 0; segment < bud.Segments; ++segment)
    {
      direction = Normalised(direction + Vector3(0.0, 0.0, this->P.Lift));
      position = position + step * direction;
      if (Depth(this->Crown, position) <= 0.0)
      {
        break;
      }
      path.push_back(position);
    }
    if (path.empty() || glm::distance(path.back(), bud.Position) < ShortestBranch * this->P.Height)
    {
      return;
    }
    this->Tree.Wood.StartBranch(bud.Node, bud.Position, 1.0);
    for (const Vector3& node : path)
    {
      this->Tree.Wood.Grow(node, 1.0);
    }
  }

  void GrowBranches(int parent)
  {
    for (int order = 1, first = parent, last = 1; order <= this->P.Orders; ++order)
    {
      for (int branch = first; branch < last; ++branch)
      {
        const int count = order == 1 ? this->P.MainBranches : this->P.SideBranches;
        for (int index = 0; index < count; ++index)
        {
          this->Steps.Step();
          this->GrowBranch(this->MakeBud(branch, index, count));
        }
      }
      first = last;
      last = static_cast<int>(this->Tree.Wood.Branches.size());
    }
  }

  /// Radius of a bare stem below the crown over that at the crown's base.
  double StemBelowCrown(double height) const
  {
    const double base = std::min(this->P.CrownBase, this->P.Height * this->P.TrunkReach);
    return std::pow((this->P.Height - std::min(height, base)) / (this->P.Height - base), StemForm);
  }

  /// The radius of the trunk at a height, by the radii of its nodes.
  double TrunkRadiusAt(double height) const
  {
    const std::vector<SkeletonNode>& nodes = this->Tree.Wood.Nodes;
    int node = 0;
    while (node + 2 < this->Tree.Wood.Branches[0].Count && nodes[node + 1].Position.z < height)
    {
      ++node;
    }
    const double part = (height - nodes[node].Position.z) / (nodes[node + 1].Position.z - nodes[node].Position.z);
    return nodes[node].Radius + part * (nodes[node + 1].Radius - nodes[node].Radius);
  }

  /// Sections by the pipe model (Shinozaki et al. 1964): a pipe leads from each length of a branch, where leaves are,
  /// to the ground, so that the sections of branches and trunk add up at every fork, as da Vinci found. Below the
  /// crown, pipes of branches that fell make the stem thicker.
  void Thicken()
  {
    std::vector<SkeletonNode>& nodes = this->Tree.Wood.Nodes;
    const int trunk = this->Tree.Wood.Branches[0].Count;
    std::vector<double> pipes(nodes.size(), 0.0);
    for (int node = static_cast<int>(nodes.size()) - 1; node > 0; --node)
    {
      const int parent = nodes[node].Parent;
      const SkeletonBranch& branch = this->Tree.Wood.Branches[nodes[node].Branch];
      const bool bearsLeaves = branch.Order >= std::min(2, this->P.Orders);
      if (node > branch.First && (bearsLeaves || node + 1 == branch.First + branch.Count))
      {
        pipes[node] += bearsLeaves ? 1.0 / (branch.Count - 1) : 1.0;
      }
      pipes[parent] += pipes[node];
    }
    for (std::size_t node = 0; node < nodes.size(); ++node)
    {
      // Section proportional to the number of pipes: R = (n / n_ground)^(1/2)
      nodes[node].Radius = std::sqrt(pipes[node] / pipes[0]);
    }
    for (int node = 0; node < trunk; ++node)
    {
      nodes[node].Radius *= this->StemBelowCrown(nodes[node].Position.z);
    }
    const double scale = this->P.TrunkRadius / this->TrunkRadiusAt(TrunkReferenceHeight(this->P.Height));
    std::for_each(nodes.begin(), nodes.end(), [=](SkeletonNode& node) { node.Radius *= scale; });
  }

  /// Branches that bear leaves: all but the trunk and, in a tree of several orders, the main branches.
  std::vector<int> Twigs() const
  {
    const std::vector<SkeletonBranch>& branches = this->Tree.Wood.Branches;
    std::vector<int> twigs;
    for (int wanted = std::min(2, this->P.Orders); twigs.empty() && wanted >= 0; --wanted)
    {
      for (int branch = 0; branch < static_cast<int>(branches.size()); ++branch)
      {
        if (branches[branch].Order >= wanted)
        {
          twigs.push_back(branch);
        }
      }
    }
    return twigs;
  }

  void GrowLeaves()
  {
    const std::vector<int> twigs = this->Twigs();
    this->Tree.Leaves.reserve(static_cast<std::size_t>(this->P.NumberOfLeaves));
    for (int leaf = 0; leaf < this->P.NumberOfLeaves; ++leaf)
    {
      this->Steps.Step();
      const std::uint64_t index = static_cast<std::uint64_t>(leaf);
      const int twig = twigs[index % twigs.size()];
      const auto place = this->Leafing.UniformPair(index, 0);
      const auto across = this->Leafing.NormalPair(index, 1);
      const auto up = this->Leafing.NormalPair(index, 2);
      LeafParticle particle;
      const Vector3 onTwig = this->Tree.Wood.Along(twig, 0.25 + 0.75 * place[0], particle.Node);
      const double spread = 0.4 * this->P.LeafSize;
      const Vector3 offset{ spread * across[0], spread * across[1], spread * up[0] };
      particle.Position = onTwig + offset;
      if (Depth(this->Crown, particle.Position) < 0.0)
      {
        particle.Position = onTwig;
      }
      particle.Size = this->P.LeafSize * std::clamp(1.0 + this->P.Variation * up[1], 0.4, 1.6);
      particle.Width = this->P.LeafWidth;
      FinishLeaf(particle, this->Tree, this->Leafing, index, static_cast<std::uint64_t>(twig));
      this->Tree.Leaves.push_back(particle);
    }
  }
};

// -------------------------------------------------------------------------------------------------------------------
// Presets: what differs from the defaults, which are those of an oak.

ReevesTreeParameters Oak()
{
  return {};
}

ReevesTreeParameters Pine()
{
  ReevesTreeParameters p;
  p.Shape = CrownShape::Cone;
  p.Height = 15.0;
  p.CrownRadius = 3.0;
  p.CrownBase = 1.0;
  p.TrunkRadius = 0.2;
  p.TrunkReach = 0.985;
  p.Orders = 2;
  p.MainBranches = 90;
  p.SideBranches = 8;
  p.BranchAngle = 92.0;
  p.Lift = -0.05;
  p.Variation = 0.12;
  p.NumberOfLeaves = 11000;
  p.LeafSize = 0.36;
  p.LeafWidth = 0.34;
  p.Leaf = { 76, 114, 74 };
  p.Bark = { 92, 70, 56 };
  p.Form = LeafForm::Needle;
  return p;
}

ReevesTreeParameters Birch()
{
  ReevesTreeParameters p;
  p.Shape = CrownShape::Ellipsoid;
  p.Height = 13.0;
  p.CrownRadius = 2.7;
  p.CrownBase = 2.6;
  p.TrunkRadius = 0.13;
  p.TrunkReach = 0.95;
  p.Orders = 3;
  p.MainBranches = 36;
  p.SideBranches = 5;
  p.BranchAngle = 48.0;
  p.Lift = -0.05;
  p.Variation = 0.2;
  p.NumberOfLeaves = 9000;
  p.LeafSize = 0.2;
  p.LeafWidth = 0.75;
  p.Leaf = { 162, 184, 78 };
  p.Bark = { 222, 218, 208 };
  return p;
}

ReevesTreeParameters Shrub()
{
  ReevesTreeParameters p;
  p.Shape = CrownShape::Ellipsoid;
  p.Height = 2.0;
  p.CrownRadius = 1.4;
  p.CrownBase = 0.05;
  p.TrunkRadius = 0.04;
  p.TrunkReach = 0.4;
  p.Orders = 3;
  p.MainBranches = 18;
  p.SideBranches = 6;
  p.BranchAngle = 58.0;
  p.Lift = 0.06;
  p.Variation = 0.25;
  p.NumberOfLeaves = 5000;
  p.LeafSize = 0.11;
  p.LeafWidth = 0.6;
  p.Leaf = { 120, 154, 80 };
  p.Bark = { 96, 82, 66 };
  return p;
}

/// Rows in the order of the enumeration.
constexpr TreePresetTraits Presets[] = {
  { "Custom", Oak, WoodSpecies::Custom },
  { "Pine", Pine, WoodSpecies::Pine },
  { "Oak", Oak, WoodSpecies::Oak },
  { "Birch", Birch, WoodSpecies::Birch },
  { "Shrub", Shrub, WoodSpecies::Shrub },
};
static_assert(std::size(Presets) == NumberOfTreePresets, "a row a preset");

}

const TreePresetTraits& TraitsOf(TreePreset preset)
{
  return Presets[static_cast<int>(preset)];
}

ReevesTreeParameters PresetParameters(TreePreset preset)
{
  return TraitsOf(preset).Parameters();
}

ReevesTreeParameters SizedParameters(TreePreset preset, double height, double diameter, double crown)
{
  const ReevesTreeParameters own = PresetParameters(preset);
  ReevesTreeParameters p = own;
  if (!(height > 0.0) && !(diameter > 0.0) && !(crown > 0.0))
  {
    return p;
  }
  p.Height = height > 0.0 ? height : own.Height;
  p.TrunkRadius = diameter > 0.0 ? 0.5 * diameter : own.TrunkRadius;
  const double wider = p.TrunkRadius / own.TrunkRadius;
  const double taller = p.Height / own.Height;
  p.CrownRadius = crown > 0.0 ? 0.5 * crown : wider * own.CrownRadius;
  // A shrub has its crown down to the ground, whatever it grew among.
  const double stouter = preset == TreePreset::Shrub ? 1.0 : wider / taller;
  p.TrunkReach = 1.0 - (1.0 - own.TrunkReach) * std::min(1.0, stouter);
  const double part = (1.0 - own.CrownBase / own.Height) * std::sqrt(stouter);
  p.CrownBase = std::max(0.0, 1.0 - std::min(part, 1.0)) * p.Height;
  p.CrownBase = std::min(p.CrownBase, 0.8 * p.TrunkReach * p.Height);
  const double length = (p.Height - p.CrownBase) / (own.Height - own.CrownBase);
  p.LeafSize = own.LeafSize * std::sqrt(p.CrownRadius / own.CrownRadius * length);
  return p;
}

double TrunkReferenceHeight(double height)
{
  return std::min(1.3, 0.1 * height);
}

std::string WhyInvalid(const ReevesTreeParameters& p)
{
  ParameterCheck check;
  check.Choice("CrownShape", static_cast<int>(p.Shape), 2);
  check.Range("Height", p.Height, 0.05, 150.0, "m");
  check.Range("CrownRadius", p.CrownRadius, 0.01, 100.0, "m");
  check.Range("TrunkRadius", p.TrunkRadius, 0.001, 10.0, "m");
  check.Range("TrunkReach", p.TrunkReach, 0.1, 1.0);
  check.Range("CrownBase", p.CrownBase, 0.0, 0.9 * p.TrunkReach * p.Height, "m");
  check.Count("Orders", p.Orders, 1, 4);
  check.Count("MainBranches", p.MainBranches, 1, 500);
  check.Count("SideBranches", p.SideBranches, 1, 20);
  check.Range("BranchAngle", p.BranchAngle, 0.0, 150.0, "degrees");
  check.Range("Lift", p.Lift, -0.9, 0.9);
  check.Range("Variation", p.Variation, 0.0, 0.5);
  check.Count("NumberOfLeaves", p.NumberOfLeaves, 0, 1000000);
  check.Choice("LeafForm", static_cast<int>(p.Form), 3);
  check.Range("LeafSize", p.LeafSize, 0.001, 5.0, "m");
  check.Range("LeafWidth", p.LeafWidth, 0.01, 2.0);
  if (check.IsGood())
  {
    const double branches = BranchesOfMain(p);
    check.Require(p.MainBranches * branches <= MostBranches,
      "MainBranches of " + std::to_string(p.MainBranches) + " give " + TextOf(p.MainBranches * branches) +
        " branches in " + std::to_string(p.Orders) + " Orders, and a tree has at most " + TextOf(MostBranches) + "; " +
        TextOf(std::floor(MostBranches / branches)) + " will do.");
  }
  return check.Reason();
}

CrownVolume CrownOf(const ReevesTreeParameters& p)
{
  return { p.Shape, { 0.0, 0.0, p.CrownBase }, p.Height - p.CrownBase, p.CrownRadius };
}

Plant GrowReevesTree(const ReevesTreeParameters& parameters, const Poll& poll)
{
  return Grower(parameters, poll).Run();
}

}
