// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sway/TrunkModes.h"

#include "Numerics/Constants.h"
#include "Plants/WoodParameters.h"
#include "Sway/PlantMotion.h"
#include "Sway/WholeTreeMode.h"
#include "Wind/WindLoads.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace littoral
{

namespace
{

constexpr int LeastPieces = 24;             // of a trunk, for integrals
constexpr double LargestWeightShare = 0.75; // of the stiffness
constexpr std::array<double, 4> GaussPlaces{ 0.0694318442029737, 0.3300094782075719, 0.6699905217924281,
  0.9305681557970263 };
constexpr std::array<double, 4> GaussWeights{ 0.1739274225687269, 0.3260725774312731, 0.3260725774312731,
  0.1739274225687269 };

void AddProducts(double amount, const ShapeMixture& a, const ShapeMixture& b, ShapeProducts& products)
{
  for (int i = 0; i < MaximumModes; ++i)
  {
    for (int j = 0; j < MaximumModes; ++j)
    {
      products[i * MaximumModes + j] += amount * a[i] * b[j];
    }
  }
}

void AddShapes(double amount, const ShapeMixture& shapes, ShapeMixture& sum)
{
  for (int i = 0; i < MaximumModes; ++i)
  {
    sum[i] += amount * shapes[i];
  }
}

/// A place of a trunk where integrals take their values.
struct Station
{
  double Part;   // of the length
  double Length; // that it stands for [m]
  double Radius; // [m]
};

/// All that grows from one place of a trunk, of one material: amounts and areas, and their moments about the place.
struct Load
{
  double Amount = 0.0;
  double Rise = 0.0; // amount x height along the trunk's axis
  double Turn = 0.0; // amount x (height^2 + half of the distance from the axis^2)
  double Area = 0.0;
  double AreaRise = 0.0;

  void Add(double amount, double area, double rise, double distance)
  {
    this->Amount += amount;
    this->Rise += amount * rise;
    this->Turn += amount * (rise * rise + 0.5 * distance * distance);
    this->Area += area;
    this->AreaRise += area * rise;
  }
};

struct Limb
{
  double Part = 0.0; // where it grows from
  Vector3 Foot{ 0.0, 0.0, 0.0 };
  Load Wood;
  Load Leaves;
};

class Measurer
{
public:
  Measurer(const Skeleton& skeleton, const std::vector<double>& leafAreas, bool carries)
    : Plant(skeleton)
    , LeafAreas(leafAreas)
  {
    this->Trunk.Length = skeleton.BranchLength(0);
    this->Trunk.Axis = BranchAxis(skeleton, 0);
    this->TakeStations();
    if (carries)
    {
      this->TakeLimbs();
      this->Trunk.Limbs = MeasureLimbs(skeleton, leafAreas);
    }
  }

  TrunkMeasures Run()
  {
    this->AddTrunk();
    for (const Limb& limb : this->Limbs)
    {
      this->AddLimb(limb, limb.Wood, this->Trunk.Wood);
      this->AddLimb(limb, limb.Leaves, this->Trunk.Leaves);
    }
    this->AddWeights();
    return this->Trunk;
  }

private:
  const Skeleton& Plant;
  const std::vector<double>& LeafAreas;
  TrunkMeasures Trunk;
  std::vector<Station> Stations;
  std::vector<Limb> Limbs;

  void TakeStations()
  {
    const int segments = this->Plant.Branches[0].Count - 1;
    const int pieces = std::max(2, (LeastPieces + segments - 1) / segments);
    double below = 0.0;
    for (int node = 0; node < segments; ++node)
    {
      const SkeletonNode& a = this->Plant.Nodes[node];
      const SkeletonNode& b = this->Plant.Nodes[node + 1];
      const double length = glm::distance(a.Position, b.Position);
      for (int point = 0; point < 4 * pieces; ++point)
      {
        const int piece = point / 4;
        const double along = (piece + GaussPlaces[point % 4]) / pieces;
        this->Stations.push_back({ (below + along * length) / this->Trunk.Length,
          GaussWeights[point % 4] * length / pieces, a.Radius + along * (b.Radius - a.Radius) });
      }
      below += length;
    }
  }

  /// Branches on the trunk with all that grows on them.
  void TakeLimbs()
  {
    std::vector<int> limbOf(this->Plant.Branches.size(), -1);
    std::vector<double> parts(this->Plant.Branches[0].Count, 0.0);
    for (std::size_t node = 1; node < parts.size(); ++node)
    {
      parts[node] = parts[node - 1] +
        glm::distance(this->Plant.Nodes[node].Position, this->Plant.Nodes[node - 1].Position) / this->Trunk.Length;
    }
    for (std::size_t branch = 1; branch < limbOf.size(); ++branch)
    {
      const SkeletonNode& first = this->Plant.Nodes[this->Plant.Branches[branch].First];
      const int below = this->Plant.Nodes[first.Parent].Branch;
      limbOf[branch] = limbOf[below];
      if (below == 0)
      {
        limbOf[branch] = static_cast<int>(this->Limbs.size());
        const double away = glm::distance(first.Position, this->Plant.Nodes[first.Parent].Position);
        this->Limbs.push_back(
          { std::min(1.0, parts[first.Parent] + away / this->Trunk.Length), first.Position, {}, {} });
      }
    }
    for (std::size_t node = 0; node < this->Plant.Nodes.size(); ++node)
    {
      this->AddSegment(static_cast<int>(node), limbOf, parts);
    }
  }

  /// The wood from a node to the next of its branch, and the leaves there.
  void AddSegment(int index, const std::vector<int>& limbOf, const std::vector<double>& parts)
  {
    const SkeletonNode& node = this->Plant.Nodes[index];
    const bool isTip = index == this->Plant.Tip(node.Branch);
    const SkeletonNode& next = this->Plant.Nodes[isTip ? index : index + 1];
    const double leaves = this->LeafAreas.empty() ? 0.0 : this->LeafAreas[index];
    if (node.Branch == 0)
    {
      if (leaves > 0.0)
      {
        this->Limbs.push_back({ parts[index], node.Position, {}, { leaves, 0.0, 0.0, leaves, 0.0 } });
      }
      return;
    }
    Limb& limb = this->Limbs[limbOf[node.Branch]];
    const Vector3 arm = 0.5 * (node.Position + next.Position) - limb.Foot;
    const double rise = glm::dot(arm, this->Trunk.Axis);
    const double distance = glm::length(arm - rise * this->Trunk.Axis);
    const double length = glm::distance(node.Position, next.Position);
    const double squares = node.Radius * node.Radius + node.Radius * next.Radius + next.Radius * next.Radius;
    limb.Wood.Add(Pi / 3.0 * squares * length, (node.Radius + next.Radius) * length, rise, distance);
    limb.Leaves.Add(leaves, leaves, rise, distance);
  }

  void AddTrunk()
  {
    const double length = this->Trunk.Length;
    TrunkBurden& wood = this->Trunk.Wood;
    double give = 0.0;
    for (const Station& station : this->Stations)
    {
      // K_ij = int I psi_i'' psi_j'' ds / L^3, M_ij = int A psi_i psi_j ds
      const ShapeMixture curvatures = CurvaturesAt(station.Part);
      const ShapeMixture shapes = ShapesAt(station.Part);
      const double volume = Pi * station.Radius * station.Radius * station.Length;
      const double area = 2.0 * station.Radius * station.Length;
      AddProducts(SecondMoment(station.Radius) * station.Length / std::pow(length, 4), curvatures, curvatures,
        this->Trunk.Stiffness);
      AddProducts(volume, shapes, shapes, wood.Mass);
      AddShapes(volume, shapes, wood.Load);
      AddShapes(area, shapes, wood.Drag);
      wood.Amount += volume;
      wood.Area += area;
      give += 4.0 * std::pow(1.0 - station.Part, 3) / std::pow(station.Radius, 4) * station.Length / length;
    }
    this->Trunk.BendingRadius = std::pow(give, -0.25);
  }

  void AddLimb(const Limb& limb, const Load& load, TrunkBurden& burden)
  {
    const ShapeMixture shapes = ShapesAt(limb.Part);
    ShapeMixture slopes = SlopesAt(limb.Part);
    std::for_each(slopes.begin(), slopes.end(), [&](double& slope) { slope /= this->Trunk.Length; });
    // What is higher by z goes by psi + z psi' / L.
    AddProducts(load.Amount, shapes, shapes, burden.Mass);
    AddProducts(load.Rise, shapes, slopes, burden.Mass);
    AddProducts(load.Rise, slopes, shapes, burden.Mass);
    AddProducts(load.Turn, slopes, slopes, burden.Mass);
    AddProducts(load.Rise, slopes, slopes, burden.Weight);
    AddShapes(load.Amount, shapes, burden.Load);
    AddShapes(load.Rise, slopes, burden.Load);
    AddShapes(CrownShelter * load.Area, shapes, burden.Drag);
    AddShapes(CrownShelter * load.AreaRise, slopes, burden.Drag);
    burden.Amount += load.Amount;
    burden.Area += CrownShelter * load.Area;
  }

  /// G_ij = int N psi_i' psi_j' ds / L^2, N: what is above.
  void AddWeights()
  {
    std::sort(this->Limbs.begin(), this->Limbs.end(), [](const Limb& a, const Limb& b) { return a.Part > b.Part; });
    double wood = 0.0;
    double leaves = 0.0;
    std::size_t limb = 0;
    for (auto station = this->Stations.rbegin(); station != this->Stations.rend(); ++station)
    {
      for (; limb < this->Limbs.size() && this->Limbs[limb].Part > station->Part; ++limb)
      {
        wood += this->Limbs[limb].Wood.Amount;
        leaves += this->Limbs[limb].Leaves.Amount;
      }
      const double volume = Pi * station->Radius * station->Radius * station->Length;
      const double width = station->Length / (this->Trunk.Length * this->Trunk.Length);
      const ShapeMixture slopes = SlopesAt(station->Part);
      AddProducts(width * (wood + 0.5 * volume), slopes, slopes, this->Trunk.Wood.Weight);
      AddProducts(width * leaves, slopes, slopes, this->Trunk.Leaves.Weight);
      wood += volume;
    }
  }
};

using Matrix = Eigen::Matrix<double, MaximumModes, MaximumModes>;
using Vector = Eigen::Matrix<double, MaximumModes, 1>;

Matrix MatrixOf(const ShapeProducts& products)
{
  return Eigen::Map<const Matrix>(products.data());
}

Vector VectorOf(const ShapeMixture& mixture)
{
  return Eigen::Map<const Vector>(mixture.data());
}

}

double ShapeOf(const ShapeMixture& mixture, double part)
{
  const ShapeMixture shapes = ShapesAt(part);
  return std::inner_product(mixture.begin(), mixture.end(), shapes.begin(), 0.0);
}

/// The lowest node of the trunk that bears a branch; the foot where there is none.
int CrownBase(const Skeleton& skeleton)
{
  int base = skeleton.Branches[0].Count;
  for (const SkeletonBranch& branch : skeleton.Branches)
  {
    const int parent = skeleton.Nodes[branch.First].Parent;
    if (parent >= 0 && skeleton.Nodes[parent].Branch == 0)
    {
      base = std::min(base, parent);
    }
  }
  return base < skeleton.Branches[0].Count ? base : 0;
}

std::vector<double> FedLeafAreas(const Skeleton& skeleton, const std::vector<double>& leafAreas, double ratio)
{
  std::vector<double> fed = leafAreas;
  const double drawn = std::accumulate(fed.begin(), fed.end(), 0.0);
  if (ratio > 0.0 && drawn > 0.0)
  {
    const double radius = skeleton.Nodes[CrownBase(skeleton)].Radius;
    std::for_each(fed.begin(), fed.end(), [=](double& area) { area *= ratio * Pi * radius * radius / drawn; });
  }
  return fed;
}

TrunkMeasures MeasureTrunk(const Skeleton& skeleton, const std::vector<double>& leafAreas, bool carries)
{
  return Measurer(skeleton, leafAreas, carries).Run();
}

std::array<TrunkMode, MaximumModes> ModesOf(const TrunkMeasures& trunk, double scale, const TrunkMaterial& material)
{
  // Wood grows as the cube of the scale, leaves as its square.
  const double wood = material.Density * scale * scale * scale;
  const double leaves = material.LeafMass * scale * scale;
  const Matrix mass = wood * MatrixOf(trunk.Wood.Mass) + leaves * MatrixOf(trunk.Leaves.Mass);
  Matrix stiffness = material.YoungModulus * scale * MatrixOf(trunk.Stiffness);
  if (material.Weighs)
  {
    const double gravity = std::max(0.0, -WeightPerLength(1.0).z * trunk.Axis.z);
    const Matrix weight =
      gravity / scale * (wood * MatrixOf(trunk.Wood.Weight) + leaves * MatrixOf(trunk.Leaves.Weight));
    const double largest = Eigen::GeneralizedSelfAdjointEigenSolver<Matrix>(weight, stiffness, Eigen::EigenvaluesOnly)
                             .eigenvalues()
                             .maxCoeff();
    stiffness -= std::min(1.0, LargestWeightShare / std::max(largest, LargestWeightShare)) * weight;
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix> solver(stiffness, mass);
  const Vector load = wood * VectorOf(trunk.Wood.Load) + leaves * VectorOf(trunk.Leaves.Load);
  const Vector drag = VectorOf(trunk.Wood.Drag) + material.LeafDrag * VectorOf(trunk.Leaves.Drag);
  const double diameter = (trunk.Wood.Area + material.LeafDrag * trunk.Leaves.Area) / trunk.Length;
  std::array<TrunkMode, MaximumModes> modes;
  for (int mode = 0; mode < MaximumModes; ++mode)
  {
    Vector mixture = solver.eigenvectors().col(mode).normalized();
    mixture *= mixture[mode] < 0.0 ? -1.0 : 1.0;
    Eigen::Map<Vector>(modes[mode].Mixture.data()) = mixture;
    double modalMass = mixture.dot(mass * mixture);
    double squared = solver.eigenvalues()[mode];
    if (mode == 0)
    {
      // Limbs give way. At rest all is as before, so that mass seems more.
      const RigidTreeMode rigid{ modes[0].Mixture, trunk.Length, std::sqrt(squared), modalMass, mixture.dot(load) };
      const double whole =
        WholeTreeFrequency(rigid, trunk.Limbs, { wood, leaves, BranchModulus * material.YoungModulus * scale });
      modalMass *= squared / (whole * whole);
      squared = whole * whole;
    }
    modes[mode].Frequency = std::sqrt(squared);
    modes[mode].Load = scale * mixture.dot(drag) / diameter / modalMass;
    modes[mode].Weight = mixture.dot(load) / modalMass;
  }
  return modes;
}

}
