// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/Constants.h"
#include "Numerics/RandomStream.h"
#include "Patterns/ClusterOffsets.h"
#include "Patterns/PoissonCount.h"
#include "Patterns/ProcessDraws.h"
#include "Patterns/SpeciesDraw.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace littoral
{

namespace
{

/// Lifetimes of the first run; each following one is twice as long.
constexpr int FirstRun = 8;
/// Largest beta (1 - gamma) pi R^2 of perfect simulation, with R = Distance: beyond it the upper and lower processes do
/// not coincide in any window that is not small.
constexpr double MaximumRemoved = 4.0;
/// Events between polls.
constexpr std::size_t EventsAtOnce = 4096;

/// Point of the dominating process, the birth-death process without interaction.
struct Birth
{
  double Time;  ///< [mean lifetimes], below 0, which is the time of the pattern
  double Death; ///< [mean lifetimes]
  PlanePosition Place;
  double Chance; ///< uniform number; the point is accepted if it is below gamma^t, with t points within Distance
  PointIdentity Identity;
  int Species;
};

void SortByTime(std::vector<Birth>& births)
{
  std::sort(births.begin(), births.end(), [](const Birth& a, const Birth& b) {
    return std::tie(a.Time, a.Identity.Object, a.Identity.Draw) < std::tie(b.Time, b.Identity.Object, b.Identity.Draw);
  });
}

/// The dominating process of the plane: births at the rate Activity on 1 m2 in a mean lifetime, exponential lifetimes.
class FreeProcess
{
public:
  explicit FreeProcess(const ProcessScene& scene)
    : Scene(scene)
    , Domain(scene.Box.Grown(StraussMargin(scene.Process)))
    , Lattice(DrawingSide(scene.Process.Activity))
    , Table(scene.Process.Activity * this->Lattice.GetSide() * this->Lattice.GetSide())
    , Species(scene.Options)
    , Counts(scene.Options.Seed, RandomPurpose::ProcessCells)
    , Places(scene.Options.Seed, RandomPurpose::ProcessBirths)
    , Lives(scene.Options.Seed, RandomPurpose::ProcessLives)
    , Chances(scene.Options.Seed, RandomPurpose::ProcessThinning)
  {
  }

  const PatternArea& GetDomain() const { return this->Domain; }

  /// Points alive at some time from so many lifetimes ago to now, in the order of their births.
  std::vector<Birth> Since(int lifetimes) const
  {
    // Of points that live for exponential times, those that die in a lifetime are as many as those that are born in it,
    // and those that live now: so they are drawn by their deaths, in slab 0 those that are alive.
    std::vector<std::vector<Birth>> slabs(static_cast<std::size_t>(lifetimes) + 1);
    this->Scene.Parallel(slabs.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t slab = begin; slab < end; ++slab)
      {
        this->AddSlab(slab, slabs[slab]);
      }
    });
    // By the lifetime in which they were born, the earliest first; those of the first part are there at the start.
    std::vector<std::vector<Birth>> parts(slabs.size());
    for (const std::vector<Birth>& slab : slabs)
    {
      for (const Birth& birth : slab)
      {
        parts[static_cast<std::size_t>(std::max(0.0, lifetimes + std::floor(birth.Time) + 1.0))].push_back(birth);
      }
    }
    this->Scene.Parallel(parts.size(), [&](std::size_t begin, std::size_t end) {
      std::for_each(&parts[begin], &parts[begin] + (end - begin), SortByTime);
    });
    std::vector<Birth> births;
    for (const std::vector<Birth>& part : parts)
    {
      births.insert(births.end(), part.begin(), part.end());
    }
    return births;
  }

private:
  /// Adds the births of the points that die in one lifetime.
  void AddSlab(std::size_t slab, std::vector<Birth>& births) const
  {
    const CellBlock block = this->Lattice.Covering(this->Domain);
    for (long long j = block.First[1]; j <= block.Last[1]; ++j)
    {
      for (long long i = block.First[0]; i <= block.Last[0]; ++i)
      {
        const int count = this->Table(this->Counts.UniformPair(ProcessLattice::ObjectOf(i, j), slab)[0]);
        for (int n = 0; n < count; ++n)
        {
          this->AddBirth(i, j, slab, n, births);
        }
      }
    }
  }

  void AddBirth(long long i, long long j, std::size_t slab, int n, std::vector<Birth>& births) const
  {
    const PointIdentity identity{ ProcessLattice::ObjectOf(i, j), slab << 20 | static_cast<std::uint64_t>(n) };
    // Lifetimes are exponential: -ln u. Those that are alive have an exponential age.
    auto life = this->Lives.UniformPair(identity.Object, identity.Draw);
    MakeLogarithms(1, &life[1]);
    const double death = slab == 0 ? 1.0 : 1.0 - static_cast<double>(slab) - life[0];
    const double time = std::min(0.0, death) + life[1];
    const auto u = this->Places.UniformPair(identity.Object, identity.Draw);
    const double side = this->Lattice.GetSide();
    const PlanePosition place = { this->Lattice.EdgeOf(i) + side * u[0], this->Lattice.EdgeOf(j) + side * u[1] };
    const auto chances = this->Chances.UniformPair(identity.Object, identity.Draw);
    if (this->Domain.Contains(place[0], place[1]) && chances[1] < this->Scene.Factor.ShareAt(place[0], place[1]))
    {
      births.push_back({ time, death, place, chances[0], identity, this->Species(identity) });
    }
  }

  const ProcessScene& Scene;
  PatternArea Domain;
  ProcessLattice Lattice;
  PoissonTable Table;
  SpeciesDraw Species;
  RandomStream Counts;
  RandomStream Places;
  RandomStream Lives;
  RandomStream Chances;
};

/// Upper and lower birth-death processes, between which that of the Strauss process lies.
class BoundingProcesses
{
public:
  BoundingProcesses(const ProcessScene& scene, const PatternArea& domain, const std::vector<Birth>& births)
    : Scene(scene)
    , Births(births)
    , Squares(scene.Process.Distance)
    , Block(this->Squares.Covering(domain))
    , Present(this->Block.Columns() * this->Block.Rows())
    , IsInLower(births.size(), 0)
  {
  }

  /// Follows both to time 0, from all that live at the time `from` and from none; or one from none.
  void Run(double from, bool isBounding)
  {
    std::size_t birth = 0;
    for (; birth < this->Births.size() && this->Births[birth].Time < from; ++birth)
    {
      if (isBounding)
      {
        this->SquareOf(this->Births[birth].Place).push_back(birth);
        this->Deaths.push({ this->Births[birth].Death, birth });
      }
    }
    SteppedPoll poll(this->Scene.Called, EventsAtOnce);
    for (; birth < this->Births.size() && this->Births[birth].Time < 0.0; ++birth)
    {
      this->LeaveUntil(this->Births[birth].Time);
      this->Enter(birth);
      poll.Step();
    }
    this->LeaveUntil(0.0);
  }

  /// Whether the upper and the lower process coincide in the box.
  bool HaveMet() const
  {
    return std::all_of(this->Present.begin(), this->Present.end(), [&](const std::vector<std::size_t>& square) {
      return std::all_of(square.begin(), square.end(), [&](std::size_t n) {
        return this->IsInLower[n] || !this->Scene.Box.Contains(this->Births[n].Place[0], this->Births[n].Place[1]);
      });
    });
  }

  /// The points of the lower one in the box.
  ProcessPattern Pattern() const
  {
    ProcessPattern pattern;
    for (const std::vector<std::size_t>& square : this->Present)
    {
      for (const std::size_t n : square)
      {
        const Birth& birth = this->Births[n];
        if (this->IsInLower[n] && this->Scene.Box.Contains(birth.Place[0], birth.Place[1]))
        {
          pattern.Points.push_back(birth.Place);
          pattern.Identities.push_back(birth.Identity);
        }
      }
    }
    return pattern;
  }

private:
  /// Removes from the upper process the points that die at a time or before.
  void LeaveUntil(double time)
  {
    for (; !this->Deaths.empty() && this->Deaths.top().first <= time; this->Deaths.pop())
    {
      this->Leave(this->Deaths.top().second);
    }
  }

  std::size_t IndexOf(long long i, long long j) const
  {
    return static_cast<std::size_t>(j - this->Block.First[1]) * this->Block.Columns() +
      static_cast<std::size_t>(i - this->Block.First[0]);
  }

  std::vector<std::size_t>& SquareOf(const PlanePosition& place)
  {
    return this->Present[this->IndexOf(this->Squares.IndexOf(place[0]), this->Squares.IndexOf(place[1]))];
  }

  /// Accepts a birth into the lower process if u < gamma^t with the t neighbours in the upper one, and into the upper
  /// process by those in the lower one: the more neighbours, the fewer births, so that one stays above the other.
  void Enter(std::size_t n)
  {
    const Birth& birth = this->Births[n];
    double upper = 1.0;
    double lower = 1.0;
    const long long i0 = this->Squares.IndexOf(birth.Place[0]);
    const long long j0 = this->Squares.IndexOf(birth.Place[1]);
    for (long long j = std::max(j0 - 1, this->Block.First[1]); j <= std::min(j0 + 1, this->Block.Last[1]); ++j)
    {
      for (long long i = std::max(i0 - 1, this->Block.First[0]); i <= std::min(i0 + 1, this->Block.Last[0]); ++i)
      {
        for (const std::size_t other : this->Present[this->IndexOf(i, j)])
        {
          const double factor = this->InteractionOf(birth, this->Births[other]);
          upper *= factor;
          lower *= this->IsInLower[other] ? factor : 1.0;
        }
      }
    }
    if (birth.Chance < lower)
    {
      this->Present[this->IndexOf(i0, j0)].push_back(n);
      this->IsInLower[n] = birth.Chance < upper;
      this->Deaths.push({ birth.Death, n });
    }
  }

  void Leave(std::size_t n)
  {
    std::vector<std::size_t>& square = this->SquareOf(this->Births[n].Place);
    square.erase(std::find(square.begin(), square.end(), n));
  }

  double InteractionOf(const Birth& a, const Birth& b) const
  {
    const double dx = a.Place[0] - b.Place[0];
    const double dy = a.Place[1] - b.Place[1];
    const bool isNear = dx * dx + dy * dy < this->Scene.Process.Distance * this->Scene.Process.Distance;
    const double near = a.Species == b.Species ? this->Scene.Process.Interaction : this->Scene.Options.CrossInteraction;
    return isNear ? near : 1.0;
  }

  const ProcessScene& Scene;
  const std::vector<Birth>& Births;
  ProcessLattice Squares;
  CellBlock Block;
  std::vector<std::vector<std::size_t>> Present; ///< births in the upper process, by squares
  std::vector<char> IsInLower;
  using Death = std::pair<double, std::size_t>;                               ///< its time, and who dies
  std::priority_queue<Death, std::vector<Death>, std::greater<Death>> Deaths; ///< of the upper process
};

}

ProcessPattern DrawStrauss(const ProcessScene& scene)
{
  const FreeProcess free(scene);
  const PointProcessParameters& process = scene.Process;
  const double removed = process.Activity * (1.0 - process.Interaction) * Pi * process.Distance * process.Distance;
  for (int lifetimes = FirstRun; removed < MaximumRemoved && lifetimes <= MaximumCouplingTime; lifetimes *= 2)
  {
    const std::vector<Birth> births = free.Since(lifetimes);
    BoundingProcesses processes(scene, free.GetDomain(), births);
    processes.Run(-lifetimes, true);
    if (processes.HaveMet())
    {
      return processes.Pattern();
    }
  }
  const std::vector<Birth> births = free.Since(BurnIn);
  BoundingProcesses processes(scene, free.GetDomain(), births);
  processes.Run(-BurnIn, false);
  ProcessPattern pattern = processes.Pattern();
  pattern.IsExact = false;
  return pattern;
}

}
