// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/RandomStream.h"
#include "Patterns/PoissonCount.h"
#include "Patterns/ProcessDraws.h"

#include <algorithm>
#include <vector>

namespace littoral
{

namespace
{

/// A random point and its age.
struct Proposal
{
  PlanePosition Place;
  double Age;
};

/// Poisson points before the thinning, each with an age; squares are not shorter than the inhibition distance.
class ProposedSquares
{
public:
  ProposedSquares(const ProcessScene& scene, const ProcessLattice& lattice, double intensity)
    : Lattice(lattice)
    , Nearest2(scene.Process.Distance * scene.Process.Distance)
    , Counts(scene.Options.Seed, RandomPurpose::ProcessCells)
    , Places(scene.Options.Seed, RandomPurpose::ProcessPoints)
    , Ages(scene.Options.Seed, RandomPurpose::ProcessLives)
    , Table(intensity * lattice.GetSide() * lattice.GetSide())
  {
  }

  void Draw(long long i, long long j, std::vector<Proposal>& proposals) const
  {
    const std::uint64_t square = ProcessLattice::ObjectOf(i, j);
    const int count = this->Table(this->Counts.UniformPair(square, 0)[0]);
    const double side = this->Lattice.GetSide();
    proposals.clear();
    for (int n = 0; n < count; ++n)
    {
      const auto index = static_cast<std::uint64_t>(n);
      const auto u = this->Places.UniformPair(square, index);
      proposals.push_back({ { this->Lattice.EdgeOf(i) + side * u[0], this->Lattice.EdgeOf(j) + side * u[1] },
        this->Ages.UniformPair(square, index)[0] });
    }
  }

  bool HasOlder(const Proposal& proposal, const std::vector<Proposal>& others) const
  {
    return std::any_of(others.begin(), others.end(), [&](const Proposal& other) {
      const double dx = other.Place[0] - proposal.Place[0];
      const double dy = other.Place[1] - proposal.Place[1];
      return other.Age > proposal.Age && dx * dx + dy * dy < this->Nearest2;
    });
  }

private:
  const ProcessLattice& Lattice;
  double Nearest2;
  RandomStream Counts;
  RandomStream Places;
  RandomStream Ages;
  PoissonTable Table;
};

}

ProcessPattern DrawMaternII(const ProcessScene& scene)
{
  const double intensity = ProposedIntensity(scene.Process.Intensity, scene.Process.Distance);
  const ProcessLattice lattice(std::max(scene.Process.Distance, std::sqrt(2.0 / intensity)));
  const ProposedSquares squares(scene, lattice, intensity);
  // Dependent thinning: of the proposals of the squares in reach, those without an older one in the nine squares about.
  CellBlock block = lattice.Covering(scene.Box);
  CellBlock reached = { { block.First[0] - 1, block.First[1] - 1 }, { block.Last[0] + 1, block.Last[1] + 1 } };
  const std::size_t columns = reached.Columns();
  std::vector<std::vector<Proposal>> proposals(columns * reached.Rows());
  const std::size_t squaresOfTask = 4096;
  ForRanges(scene.Parallel, proposals.size(), squaresOfTask, [&](std::size_t begin, std::size_t end) {
    for (std::size_t q = begin; q < end; ++q)
    {
      squares.Draw(reached.First[0] + static_cast<long long>(q % columns),
        reached.First[1] + static_cast<long long>(q / columns), proposals[q]);
    }
  });
  return DrawSquares(scene, block, 2.0, [&]() -> SquareTask {
    return [&](long long i, long long j, ProcessPattern& pattern) {
      const std::size_t q =
        static_cast<std::size_t>(j - reached.First[1]) * columns + static_cast<std::size_t>(i - reached.First[0]);
      for (std::size_t n = 0; n < proposals[q].size(); ++n)
      {
        const Proposal& proposal = proposals[q][n];
        bool stays = scene.Box.Contains(proposal.Place[0], proposal.Place[1]);
        for (std::size_t row = q - columns; stays && row <= q + columns; row += columns)
        {
          for (std::size_t other = row - 1; stays && other <= row + 1; ++other)
          {
            stays = !squares.HasOlder(proposal, proposals[other]);
          }
        }
        if (stays)
        {
          KeepPoint(scene, proposal.Place, { ProcessLattice::ObjectOf(i, j), n }, pattern);
        }
      }
    };
  });
}

}
