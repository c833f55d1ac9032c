// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Particles/ParticleFog.h"

#include "Numerics/SimdDouble4.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

namespace littoral
{

namespace
{

using Located = LocatedFogParticle;

typedef int Wholes __attribute__((vector_size(4 * sizeof(int))));
/// Four numbers anywhere in memory: std::memcpy would move them by halves, for which the whole would wait.
typedef double FourInMemory __attribute__((vector_size(4 * sizeof(double)), aligned(sizeof(double)), may_alias));

/// Finds the cells of places in a grid: x, y, z and the cross section in a lane each, the last one as it comes.
class Locator
{
public:
  LITTORAL_INLINE explicit Locator(const FogGrid& grid)
    : Origin(grid.Origin.x, grid.Origin.y, grid.Origin.z, 0.0)
    , Inverse(1.0 / grid.Spacing.x, 1.0 / grid.Spacing.y, 1.0 / grid.Spacing.z, 1.0)
    , Last(grid.Count[0] - 1, grid.Count[1] - 1, grid.Count[2] - 1, 1.0)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    // The faces belong to the grid, with the rounding of the places on them.
    constexpr double tolerance = 1e-9;
    this->Low = SimdDouble4(-tolerance, -tolerance, -tolerance, -infinity);
    this->High = this->Last + SimdDouble4(tolerance, tolerance, tolerance, infinity);
    this->Most = SimdDouble4(1.0, 1.0, 1.0, infinity);
  }

  /// False for places outside of the grid; else the cell, and where in it.
  LITTORAL_INLINE bool Locate(const FogParticle& particle, Wholes& cell, float part[4]) const
  {
    const FourInMemory four = *reinterpret_cast<const FourInMemory*>(&particle);
    const SimdDouble4 place(four[0], four[1], four[2], four[3]);
    const SimdDouble4 x = (place - this->Origin) * this->Inverse;
    const auto isInside = (x.Values >= this->Low.Values) & (x.Values <= this->High.Values);
    if (!(isInside[0] & isInside[1] & isInside[2]))
    {
      return false;
    }
    const SimdDouble4 none(0.0);
    // Wholes below what is no larger than the number of cells less one: a place on the last face is of the last cell.
    const SimdDouble4 within = Min(Max(x, none), this->Last - SimdDouble4(1.0));
    cell = __builtin_convertvector(within.Values, Wholes);
    const SimdDouble4 own(__builtin_convertvector(cell, SimdDouble4::Register));
    const SimdFloat4 singles = __builtin_convertvector(Min(Max(x - own, none), this->Most).Values, SimdFloat4);
    std::memcpy(part, &singles, sizeof singles);
    return true;
  }

private:
  SimdDouble4 Origin;
  SimdDouble4 Inverse; ///< of the spacing
  SimdDouble4 Last;
  SimdDouble4 Low;
  SimdDouble4 High;
  SimdDouble4 Most;
};

static_assert(sizeof(FogParticle) == sizeof(SimdDouble4), "a place and a cross section fill a register");

/// Locates particles: those inside of the grid, in their order, and their layers of cells. The number of these.
LITTORAL_SIMD_CLONES std::size_t LocateAll(
  const FogGrid& grid, const FogParticle* particles, std::size_t count, Located* inside, std::uint32_t* layers)
{
  const Locator locator(grid);
  const int width = grid.Count[0];
  std::size_t next = 0;
  for (std::size_t n = 0; n < count; ++n)
  {
    Wholes cell;
    if (locator.Locate(particles[n], cell, inside[next].Values))
    {
      inside[next].Sample = static_cast<std::uint32_t>(cell[1] * width + cell[0]);
      layers[next++] = static_cast<std::uint32_t>(cell[2]);
    }
  }
  return next;
}

/// The lengths along an axis that samples stand for: less on the faces of the grid.
std::vector<double> LengthsOf(const FogGrid& grid, int axis)
{
  std::vector<double> lengths;
  for (int index = 0; index < grid.Count[axis]; ++index)
  {
    const bool onFace = index == 0 || index == grid.Count[axis] - 1;
    lengths.push_back(grid.Spacing[axis] * (onFace ? 0.5 : 1.0));
  }
  return lengths;
}

/// Particles by layer of cells, in their order: in runs that one thread locates at a time, from layer to layer within a
/// run. What is in memory is written once and read once.
class LocatedParticles
{
public:
  LocatedParticles(const FogGrid& grid, std::size_t count, const FogParticles& particles, FogMemory& memory,
    const ParallelFor& parallelFor)
    : Grid(grid)
    , Layers(static_cast<std::size_t>(grid.Count[2]) - 1)
    , Length(std::max<std::size_t>(4096, 4 * Layers)) // so that the ends of layers are few beside the particles
    , Particles(memory.Take(count))
    , Ends((count + Length - 1) / Length * Layers)
  {
    const std::size_t runs = this->Ends.size() / this->Layers;
    parallelFor(runs, [&](std::size_t first, std::size_t last) {
      Work work;
      for (std::size_t run = first; run < last; ++run)
      {
        const std::size_t begin = run * this->Length;
        this->Sort(run, begin, std::min(count, begin + this->Length), particles, work);
      }
    });
  }

  std::size_t GetNumberOfInside() const
  {
    std::size_t inside = 0;
    for (std::size_t last = this->Layers; last <= this->Ends.size(); last += this->Layers)
    {
      inside += this->Ends[last - 1] - (last / this->Layers - 1) * this->Length;
    }
    return inside;
  }

  /// Calls a task with the particles of a layer, run by run.
  template <typename Task>
  void ForLayer(std::size_t layer, const Task& task) const
  {
    for (std::size_t run = 0; run * this->Layers < this->Ends.size(); ++run)
    {
      const std::size_t* ends = &this->Ends[run * this->Layers];
      const std::size_t begin = layer > 0 ? ends[layer - 1] : run * this->Length;
      task(this->Particles + begin, this->Particles + ends[layer]);
    }
  }

private:
  /// A run of particles as they come.
  struct Work
  {
    std::vector<FogParticle> Particles;
    std::vector<Located> Inside;
    std::vector<std::uint32_t> LayerOf;
    std::vector<std::size_t> Next;
  };

  const FogGrid& Grid;
  std::size_t Layers;
  std::size_t Length;            ///< of a run
  Located* Particles;            ///< not filled behind the last layer of a run
  std::vector<std::size_t> Ends; ///< of the layers of each run

  void Sort(std::size_t run, std::size_t begin, std::size_t end, const FogParticles& particles, Work& work)
  {
    this->LocateRun(begin, end, particles, work);
    std::size_t* ends = &this->Ends[run * this->Layers];
    std::fill_n(ends, this->Layers, 0);
    for (const std::uint32_t layer : work.LayerOf)
    {
      ++ends[layer];
    }
    work.Next.resize(this->Layers);
    std::size_t sum = begin;
    for (std::size_t layer = 0; layer < this->Layers; ++layer)
    {
      work.Next[layer] = sum;
      sum += ends[layer];
      ends[layer] = sum;
    }
    for (std::size_t n = 0; n < work.LayerOf.size(); ++n)
    {
      this->Particles[work.Next[work.LayerOf[n]]++] = work.Inside[n];
    }
  }

  void LocateRun(std::size_t begin, std::size_t end, const FogParticles& particles, Work& work) const
  {
    work.Particles.resize(this->Length);
    work.Inside.resize(this->Length);
    work.LayerOf.resize(this->Length);
    particles(begin, end, work.Particles.data());
    work.LayerOf.resize(
      LocateAll(this->Grid, work.Particles.data(), end - begin, work.Inside.data(), work.LayerOf.data()));
  }
};

/// Two samples side by side.
typedef double Pair __attribute__((vector_size(2 * sizeof(double))));

/// Adds to two samples that follow each other.
LITTORAL_INLINE void AddTo(double* samples, const Pair& part)
{
  Pair sum;
  std::memcpy(&sum, samples, sizeof sum);
  sum += part;
  std::memcpy(samples, &sum, sizeof sum);
}

/// Adds what particles give to the samples below and above their layer of cells.
LITTORAL_SIMD_CLONES void AddParticles(
  const Located* begin, const Located* end, std::size_t width, double* below, double* above)
{
  for (const Located* particle = begin; particle != end; ++particle)
  {
    const double x = particle->Values[0];
    const double y = particle->Values[1];
    const double z = particle->Values[2];
    // Trilinear weight of a particle at a sample, times its cross section: by x, y and z
    const Pair alongX = { 1.0 - x, x };
    const Pair all = alongX * static_cast<double>(particle->Values[3]);
    const Pair far = all * y;
    const Pair near = all - far;
    AddTo(below + particle->Sample, near * (1.0 - z));
    AddTo(below + particle->Sample + width, far * (1.0 - z));
    AddTo(above + particle->Sample, near * z);
    AddTo(above + particle->Sample + width, far * z);
  }
}

/// Sums of two layers of samples, the one below the cells at hand and the one above.
class LayerSums
{
public:
  explicit LayerSums(const FogGrid& grid)
    : Width(static_cast<std::size_t>(grid.Count[0]))
    , Below(Width * static_cast<std::size_t>(grid.Count[1]))
    , Above(Below.size())
  {
  }

  const std::vector<double>& GetBelow() const { return this->Below; }

  void Add(const LocatedParticles& particles, std::size_t layer)
  {
    particles.ForLayer(layer, [this](const Located* begin, const Located* end) {
      AddParticles(begin, end, this->Width, this->Below.data(), this->Above.data());
    });
  }

  /// Goes up by a layer.
  void Rise()
  {
    this->Below.swap(this->Above);
    std::fill(this->Above.begin(), this->Above.end(), 0.0);
  }

private:
  std::size_t Width;
  std::vector<double> Below;
  std::vector<double> Above;
};

/// Layers of samples that one thread does at a time: of the cells below them those of one layer are done twice.
constexpr std::size_t LayersAtOnce = 8;

}

LocatedFogParticle* FogMemory::Take(std::size_t count)
{
  if (count > this->Size)
  {
    this->Particles.reset();
    this->Particles.reset(new LocatedFogParticle[count]);
    this->Size = count;
  }
  return this->Particles.get();
}

void FogMemory::Limit(std::size_t count)
{
  if (this->Size > count)
  {
    this->Particles.reset();
    this->Size = 0;
  }
}

std::array<double, 6> Thickened(const std::array<double, 6>& bounds, double thickness)
{
  std::array<double, 6> thick = bounds;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double missing = std::max(0.0, thickness - (bounds[2 * axis + 1] - bounds[2 * axis]));
    thick[2 * axis] -= 0.5 * missing;
    thick[2 * axis + 1] += 0.5 * missing;
  }
  return thick;
}

ParticleFog::ParticleFog(const FogGrid& grid, std::size_t count, const FogParticles& particles, FogMemory& memory,
  const ParallelFor& parallelFor, const Poll& poll)
  : Extinction(grid.NumberOfSamples())
{
  // Layers of cells keep the order of the particles; a layer of samples adds the cells below, then those above. So the
  // order of sums is that of the particles, on any threads.
  poll();
  const LocatedParticles located(grid, count, particles, memory, parallelFor);
  this->Outside = static_cast<long long>(count - located.GetNumberOfInside());
  const auto layers = static_cast<std::size_t>(grid.Count[2]);
  const std::vector<double> lengths[3] = { LengthsOf(grid, 0), LengthsOf(grid, 1), LengthsOf(grid, 2) };
  ForRanges(parallelFor, layers, LayersAtOnce, [&](std::size_t begin, std::size_t end) {
    LayerSums sums(grid);
    if (begin > 0)
    {
      sums.Add(located, begin - 1);
    }
    for (std::size_t k = begin; k < end; ++k)
    {
      if (k > 0)
      {
        sums.Rise();
      }
      if (k < layers - 1)
      {
        sums.Add(located, k);
      }
      // sigma = sum of w C / V [1/m]: weights w, cross sections C, volume V of the sample
      const double* section = sums.GetBelow().data();
      float* extinction = this->Extinction.data() + k * sums.GetBelow().size();
      for (const double alongY : lengths[1])
      {
        for (const double alongX : lengths[0])
        {
          *extinction++ = static_cast<float>(*section++ / (alongX * alongY * lengths[2][k]));
        }
      }
    }
  });
}

double TotalCrossSection(const FogGrid& grid, const std::vector<float>& extinction, const Poll& onRow)
{
  const std::vector<double> lengths[3] = { LengthsOf(grid, 0), LengthsOf(grid, 1), LengthsOf(grid, 2) };
  const float* sample = extinction.data();
  double total = 0.0;
  for (const double alongZ : lengths[2])
  {
    for (const double alongY : lengths[1])
    {
      onRow();
      for (const double alongX : lengths[0])
      {
        total += alongX * alongY * alongZ * *sample++;
      }
    }
  }
  return total;
}

}
