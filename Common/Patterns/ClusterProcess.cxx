// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/RandomStream.h"
#include "Patterns/PoissonCount.h"
#include "Patterns/ProcessDraws.h"

#include <array>
#include <memory>

namespace littoral
{

namespace
{

/// Points whose offsets are made at once.
constexpr std::size_t PointsAtOnce = 512;

/// Poisson points of the plane, square by square.
class RandomSquares
{
public:
  RandomSquares(int seed, const ProcessLattice& lattice, double intensity)
    : Lattice(lattice)
    , Counts(seed, RandomPurpose::ProcessCells)
    , Places(seed, RandomPurpose::ProcessParents)
    , Table(intensity * lattice.GetSide() * lattice.GetSide())
  {
  }

  int CountIn(std::uint64_t square) const { return this->Table(this->Counts.UniformPair(square, 0)[0]); }

  PlanePosition PlaceOf(long long i, long long j, std::uint64_t index) const
  {
    const auto u = this->Places.UniformPair(ProcessLattice::ObjectOf(i, j), index);
    return { this->Lattice.EdgeOf(i) + this->Lattice.GetSide() * u[0],
      this->Lattice.EdgeOf(j) + this->Lattice.GetSide() * u[1] };
  }

private:
  ProcessLattice Lattice;
  RandomStream Counts;
  RandomStream Places;
  PoissonTable Table;
};

/// The points of clusters, of which some are made at once.
class ClusterSquares
{
public:
  explicit ClusterSquares(const ProcessScene& scene, const ProcessLattice& lattice)
    : Scene(scene)
    , Parents(scene.Options.Seed, lattice, ParentIntensity(scene.Process))
    , Sizes(scene.Options.Seed, RandomPurpose::ProcessClusters)
    , Points(scene.Options.Seed, RandomPurpose::ProcessPoints)
    , Table(scene.Process.ClusterSize)
    , Reached(scene.Box.Grown(ClusterReach(scene.Process)))
  {
  }

  void Draw(long long i, long long j, ProcessPattern& pattern)
  {
    const std::uint64_t square = ProcessLattice::ObjectOf(i, j);
    const int parents = this->Parents.CountIn(square);
    for (int p = 0; p < parents; ++p)
    {
      const PlanePosition parent = this->Parents.PlaceOf(i, j, static_cast<std::uint64_t>(p));
      if (this->Reached.Contains(parent[0], parent[1]))
      {
        this->AddCluster(parent, square, static_cast<std::uint64_t>(p), pattern);
      }
    }
    this->Flush(pattern);
  }

private:
  void AddCluster(const PlanePosition& parent, std::uint64_t square, std::uint64_t index, ProcessPattern& pattern)
  {
    const int size = this->Table(this->Sizes.UniformPair(square, index)[0]);
    for (int n = 0; n < size; ++n)
    {
      this->Objects[this->Waiting] = square;
      this->Draws[this->Waiting] = index << 32 | static_cast<std::uint64_t>(n);
      this->Centers[this->Waiting] = parent;
      if (++this->Waiting == PointsAtOnce)
      {
        this->Flush(pattern);
      }
    }
  }

  /// Puts the waiting points about their parents.
  void Flush(ProcessPattern& pattern)
  {
    this->Points.UniformPairs(
      this->Waiting, this->Objects.data(), this->Draws.data(), this->Across.data(), this->Along.data());
    TraitsOf(this->Scene.Process.Process)
      .Offsets(this->Scene.Process.ClusterScale, this->Waiting, this->Across.data(), this->Along.data());
    for (std::size_t n = 0; n < this->Waiting; ++n)
    {
      const PlanePosition place = { this->Centers[n][0] + this->Across[n], this->Centers[n][1] + this->Along[n] };
      KeepPoint(this->Scene, place, { this->Objects[n], this->Draws[n] }, pattern);
    }
    this->Waiting = 0;
  }

  const ProcessScene& Scene;
  RandomSquares Parents;
  RandomStream Sizes;
  RandomStream Points;
  PoissonTable Table;
  PatternArea Reached;
  std::array<std::uint64_t, PointsAtOnce> Objects;
  std::array<std::uint64_t, PointsAtOnce> Draws;
  std::array<PlanePosition, PointsAtOnce> Centers;
  std::array<double, PointsAtOnce> Across;
  std::array<double, PointsAtOnce> Along;
  std::size_t Waiting = 0;
};

}

double ClusterReach(const PointProcessParameters& process)
{
  return process.ClusterScale * TraitsOf(process.Process).OffsetReach;
}

ProcessPattern DrawPoisson(const ProcessScene& scene)
{
  const ProcessLattice lattice(DrawingSide(scene.Process.Intensity));
  const RandomSquares squares(scene.Options.Seed, lattice, scene.Process.Intensity);
  return DrawSquares(scene, lattice.Covering(scene.Box), 4.0, [&]() -> SquareTask {
    return [&](long long i, long long j, ProcessPattern& pattern) {
      const std::uint64_t square = ProcessLattice::ObjectOf(i, j);
      const int count = squares.CountIn(square);
      for (int n = 0; n < count; ++n)
      {
        const auto index = static_cast<std::uint64_t>(n);
        KeepPoint(scene, squares.PlaceOf(i, j, index), { square, index }, pattern);
      }
    };
  });
}

ProcessPattern DrawClusters(const ProcessScene& scene)
{
  const ProcessLattice lattice(DrawingSide(ParentIntensity(scene.Process)));
  const CellBlock block = lattice.Covering(scene.Box.Grown(ClusterReach(scene.Process)));
  return DrawSquares(scene, block, 4.0 * scene.Process.ClusterSize, [&]() -> SquareTask {
    const auto squares = std::make_shared<ClusterSquares>(scene, lattice);
    return [squares](long long i, long long j, ProcessPattern& pattern) { squares->Draw(i, j, pattern); };
  });
}

}
