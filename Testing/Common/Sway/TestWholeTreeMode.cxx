// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/Constants.h"
#include "Plants/ReevesTree.h"
#include "Sway/PlantSway.h"
#include "SymmetricModes.h"

#include <Eigen/Sparse>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <map>

using namespace littoral;

namespace
{

/// A tree as a frame of beams in space, with six freedoms at each joint. No part of it is in the library.
class Frame
{
public:
  Frame(const Skeleton& skeleton, const std::vector<double>& leaves, const TrunkMaterial& material)
    : Plant(skeleton)
    , Material(material)
  {
    std::map<int, std::vector<std::pair<double, int>>> feet; // along the segment above a node
    for (std::size_t branch = 1; branch < skeleton.Branches.size(); ++branch)
    {
      const int first = skeleton.Branches[branch].First;
      const int parent = skeleton.Nodes[first].Parent;
      feet[parent].push_back({ glm::distance(skeleton.Nodes[first].Position, skeleton.Nodes[parent].Position), first });
    }
    this->JointOf.assign(skeleton.Nodes.size(), 0);
    this->AddJoint(skeleton.Nodes[0].Position);
    for (int branch = 0; branch < static_cast<int>(skeleton.Branches.size()); ++branch)
    {
      for (int node = skeleton.Branches[branch].First; node < skeleton.Tip(branch); ++node)
      {
        this->AddSegment(node, feet[node], leaves.empty() ? 0.0 : leaves[node]);
      }
      const int tip = skeleton.Tip(branch);
      for (const auto& foot : feet[tip])
      {
        this->JointOf[foot.second] = this->JointOf[tip];
      }
    }
  }

  /// Frequency [Hz] at which the trunk's tip answers most to a push on all mass, mean over x and y.
  double Frequency()
  {
    const int free = 6 * (static_cast<int>(this->Joints.size()) - 1);
    Eigen::SparseMatrix<double> stiffness(free, free);
    stiffness.setFromTriplets(this->Entries.begin(), this->Entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(stiffness);
    Eigen::VectorXd mass = Eigen::VectorXd::Zero(free);
    std::array<Eigen::VectorXd, 2> pushes{ mass, mass };
    for (std::size_t joint = 1; joint < this->Joints.size(); ++joint)
    {
      const Eigen::Index row = 6 * (static_cast<Eigen::Index>(joint) - 1);
      mass.segment(row, 3).setConstant(this->Masses[joint]);
      pushes[0][row] = this->Masses[joint];
      pushes[1][row + 1] = this->Masses[joint];
    }
    struct Line
    {
      double Frequency, Share;
      int Direction;
    };
    std::vector<Line> lines;
    const Eigen::Index tip = 6 * (this->JointOf[this->Plant.Tip(0)] - 1);
    for (int direction = 0; direction < 2; ++direction)
    {
      // Krylov vectors of the push, orthogonal by mass: modes that it moves.
      constexpr int Vectors = 50;
      Eigen::MatrixXd basis(free, Vectors);
      Eigen::VectorXd next = solver.solve(pushes[direction]);
      int count = 0;
      for (; count < Vectors; ++count)
      {
        for (int repeat = 0; repeat < 2; ++repeat)
        {
          next -= basis.leftCols(count) * (basis.leftCols(count).transpose() * mass.cwiseProduct(next));
        }
        const double size = std::sqrt(next.dot(mass.cwiseProduct(next)));
        if (!(size > 1e-12))
        {
          break;
        }
        basis.col(count) = next / size;
        next = solver.solve(Eigen::VectorXd(mass.cwiseProduct(basis.col(count))));
        next /= std::sqrt(next.dot(mass.cwiseProduct(next)));
      }
      const Eigen::MatrixXd small = basis.leftCols(count).transpose() * (stiffness * basis.leftCols(count));
      const littoral::testing::SymmetricModes modes = littoral::testing::ModesOf(small);
      for (int i = 0; i < count; ++i)
      {
        const Eigen::VectorXd mode = basis.leftCols(count) * modes.Vectors.col(i);
        lines.push_back({ std::sqrt(modes.Values[i]), mode.dot(pushes[direction]) * mode[tip + direction], direction });
      }
    }
    double best = 0.0;
    double at = 0.0;
    for (double frequency = 0.02 * TwoPi; frequency < 5.0 * TwoPi; frequency *= 1.002)
    {
      std::array<std::complex<double>, 2> answers{};
      for (const Line& line : lines)
      {
        answers[line.Direction] += line.Share /
          std::complex<double>(
            line.Frequency * line.Frequency - frequency * frequency, 0.1 * line.Frequency * frequency);
      }
      const double answer = std::norm(answers[0]) + std::norm(answers[1]);
      if (answer > best)
      {
        best = answer;
        at = frequency;
      }
    }
    return at / TwoPi;
  }

private:
  const Skeleton& Plant;
  TrunkMaterial Material;
  std::vector<int> JointOf; // by node
  std::vector<Vector3> Joints;
  std::vector<double> Masses; // [kg]
  std::vector<Eigen::Triplet<double>> Entries;

  int AddJoint(const Vector3& place)
  {
    this->Joints.push_back(place);
    this->Masses.push_back(0.0);
    return static_cast<int>(this->Joints.size()) - 1;
  }

  /// Two beams, and more where branches grow; leaves are in the middle, or on the node of a trunk.
  void AddSegment(int node, const std::vector<std::pair<double, int>>& feet, double leaves)
  {
    const SkeletonNode& a = this->Plant.Nodes[node];
    const SkeletonNode& b = this->Plant.Nodes[node + 1];
    const double length = glm::distance(a.Position, b.Position);
    std::vector<std::pair<double, int>> stops{ { 0.5, -1 }, { 1.0, node + 1 } };
    for (const auto& foot : feet)
    {
      stops.push_back({ std::min(1.0, foot.first / length), foot.second });
    }
    std::stable_sort(stops.begin(), stops.end(), [](const auto& p, const auto& q) { return p.first < q.first; });
    int below = this->JointOf[node];
    double part = 0.0;
    for (const auto& stop : stops)
    {
      if (stop.first > part + 1e-9)
      {
        const int above = this->AddJoint(a.Position + stop.first * (b.Position - a.Position));
        const double low = a.Radius + part * (b.Radius - a.Radius);
        const double high = a.Radius + stop.first * (b.Radius - a.Radius);
        this->AddBeam(below, above, low, high, a.Branch == 0);
        below = above;
        part = stop.first;
      }
      if (stop.second >= 0)
      {
        this->JointOf[stop.second] = below;
      }
      else if (a.Branch > 0)
      {
        this->Masses[below] += this->Material.LeafMass * leaves;
      }
    }
    if (a.Branch == 0)
    {
      this->Masses[this->JointOf[node]] += this->Material.LeafMass * leaves;
    }
  }

  void AddBeam(int from, int to, double low, double high, bool isTrunk)
  {
    const Vector3 run = this->Joints[to] - this->Joints[from];
    const double h = glm::length(run);
    const double wood = this->Material.Density * Pi / 3.0 * (low * low + low * high + high * high) * h;
    this->Masses[from] += 0.5 * wood;
    this->Masses[to] += 0.5 * wood;
    const double radius = std::pow(3.0 * std::pow(low * high, 3) / (low * low + low * high + high * high), 0.25);
    const double modulus = (isTrunk ? 1.0 : 0.5) * this->Material.YoungModulus;
    const double ei = modulus * 0.25 * Pi * std::pow(radius, 4);
    Eigen::Matrix<double, 12, 12> k = Eigen::Matrix<double, 12, 12>::Zero();
    const auto spring = [&](int i, double value) {
      k(i, i) += value;
      k(i + 6, i + 6) += value;
      k(i, i + 6) -= value;
      k(i + 6, i) -= value;
    };
    spring(0, modulus * Pi * radius * radius / h);
    spring(3, 0.16 * ei / h); // 2 G / E
    for (const auto& [shift, turn, sign] : { std::array<int, 3>{ 1, 5, 1 }, { 2, 4, -1 } })
    {
      const int at[4] = { shift, turn, shift + 6, turn + 6 };
      Eigen::Matrix4d bend;
      const double s = sign * h;
      bend << 12, 6 * s, -12, 6 * s, 6 * s, 4 * h * h, -6 * s, 2 * h * h, -12, -6 * s, 12, -6 * s, 6 * s, 2 * h * h,
        -6 * s, 4 * h * h;
      for (int i = 0; i < 16; ++i)
      {
        k(at[i / 4], at[i % 4]) += ei / (h * h * h) * bend(i / 4, i % 4);
      }
    }
    const Vector3 e = run / h;
    const Vector3 f = glm::normalize(glm::cross(e, std::abs(e.z) < 0.9 ? Vector3(0, 0, 1) : Vector3(1, 0, 0)));
    const Vector3 g = glm::cross(e, f);
    Eigen::Matrix3d rows;
    rows << e.x, e.y, e.z, f.x, f.y, f.z, g.x, g.y, g.z;
    for (int i = 0; i < 16; ++i)
    {
      auto part = k.block<3, 3>(i / 4 * 3, i % 4 * 3);
      part = (rows.transpose() * part * rows).eval();
    }
    const int first[2] = { 6 * (from - 1), 6 * (to - 1) };
    for (int i = 0; i < 144; ++i)
    {
      const int row = first[i / 12 / 6] + i / 12 % 6;
      const int column = first[i % 12 / 6] + i % 12 % 6;
      if (row >= 0 && column >= 0)
      {
        this->Entries.emplace_back(row, column, k(i / 12, i % 12));
      }
    }
  }
};

const TrunkMaterial Light{ 5e9, 950.0, 0.35, 0.05, false };

double Ours(const Skeleton& skeleton, const std::vector<double>& leaves, bool gives = true)
{
  TrunkMeasures trunk = MeasureTrunk(skeleton, leaves);
  if (!gives)
  {
    trunk.Limbs.clear();
  }
  return ModesOf(trunk, 1.0, Light)[0].Frequency / TwoPi;
}

/// A trunk of 6 m with whorls of long limbs, bent upwards, which bear side branches on one side.
Skeleton Whorls(double limbRadius, double lift)
{
  Skeleton tree;
  tree.StartBranch(-1, { 0.0, 0.0, 0.0 }, 0.12);
  for (int i = 1; i <= 12; ++i)
  {
    tree.Grow({ 0.0, 0.0, 0.5 * i }, 0.12 - 0.006 * i);
  }
  std::vector<std::pair<int, Vector3>> feet;
  for (const int whorl : { 6, 9, 11 })
  {
    for (int limb = 0; limb < 5; ++limb)
    {
      const double angle = TwoPi * (limb + 0.3 * whorl) / 5.0;
      const Vector3 out{ std::cos(angle), std::sin(angle), 0.0 };
      Vector3 place{ 0.0, 0.0, 0.5 * whorl + 0.2 };
      tree.StartBranch(whorl, place, limbRadius);
      for (int i = 1; i <= 6; ++i)
      {
        place += 0.5 * out + Vector3(0.0, 0.0, lift * i);
        const int node = tree.Grow(place, limbRadius * (1.0 - 0.12 * i));
        if (i == 2 || i == 4)
        {
          feet.push_back({ node, glm::cross(out, Vector3(0.0, 0.0, 1.0)) });
        }
      }
    }
  }
  for (const auto& [node, side] : feet)
  {
    const Vector3 place = tree.Nodes[node].Position;
    tree.StartBranch(node, place, 0.4 * limbRadius);
    for (int i = 1; i <= 4; ++i)
    {
      tree.Grow(place + 0.3 * i * side, 0.4 * limbRadius * (1.0 - 0.2 * i));
    }
  }
  return tree;
}

}

TEST(WholeTreeMode, LongLimbsAgainstAFrame)
{
  // From limbs that hardly give way to such as are slower than the trunk; these bend it in another shape than that of
  // the tree with rigid limbs, which is taken here.
  for (const double radius : { 0.06, 0.045, 0.035, 0.028 })
  {
    for (const double lift : { 0.0, 0.05 })
    {
      const Skeleton tree = Whorls(radius, lift);
      std::vector<double> leaves(tree.Nodes.size(), 0.0);
      for (std::size_t node = 13; node < leaves.size(); ++node)
      {
        leaves[node] = node + 1 < leaves.size() && tree.Nodes[node + 1].Branch == tree.Nodes[node].Branch ? 0.15 : 0.0;
      }
      const double frame = Frame(tree, leaves, Light).Frequency();
      const double own = Ours(tree, leaves);
      std::printf("limbs of %.1f cm, %s: %.4f Hz, %.4f of a frame's; rigid limbs %.3f\n", 100.0 * radius,
        lift > 0.0 ? "lifted" : "level", own, own / frame, Ours(tree, leaves, false) / frame);
      EXPECT_NEAR(own / frame, 1.0, radius > 0.03 ? 0.02 : 0.06);
      EXPECT_GT(Ours(tree, leaves, false), own);
    }
  }
}

TEST(WholeTreeMode, GrownTreesAgainstAFrame)
{
  for (const TreePreset preset : { TreePreset::Pine, TreePreset::Birch, TreePreset::Oak })
  {
    ReevesTreeParameters parameters = SizedParameters(preset, 18.0, 0.3);
    parameters.Orders = 2;
    parameters.MainBranches = 14;
    const Plant tree = GrowReevesTree(parameters);
    std::vector<double> leaves(tree.Wood.Nodes.size(), 0.0);
    for (const LeafParticle& leaf : tree.Leaves)
    {
      leaves[leaf.Node] += 0.5 * leaf.Size * leaf.Size * leaf.Width;
    }
    leaves = FedLeafAreas(tree.Wood, leaves, 2500.0);
    const double frame = Frame(tree.Wood, leaves, Light).Frequency();
    const double own = Ours(tree.Wood, leaves);
    std::printf("preset %d: %.4f Hz, %.4f of a frame's; rigid limbs %.3f\n", static_cast<int>(preset), own, own / frame,
      Ours(tree.Wood, leaves, false) / frame);
    EXPECT_NEAR(own / frame, 1.0, 0.02);
  }
}
