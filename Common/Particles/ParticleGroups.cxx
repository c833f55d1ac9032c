// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Particles/ParticleGroups.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Numerics/RandomStream.h"
#include "Numerics/RoundedUp.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace littoral
{

namespace
{

constexpr int MostSlaves = 1000;

/// Particles that are not worth a thread.
constexpr std::size_t ParticlesOfOneThread = 1 << 13;

int LongestSide(const Box& box)
{
  const Vector3 size = box.High - box.Low;
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

/// Length of the first part of a row of particles that is cut in two, so that all groups but the last are full.
std::size_t HalfOf(std::size_t count, std::size_t group)
{
  const std::size_t groups = (count + group - 1) / group;
  return groups / 2 * group;
}

/// A place in the shell between two radii, uniform in its volume.
Vector3 PlaceInShell(const RandomStream& random, int particle, double inner, double outer)
{
  const auto direction = random.UniformPair(particle, 0);
  const double part = random.UniformPair(particle, 1)[0];
  // r^3 and z are uniform
  const double cubes = inner * inner * inner + part * (outer * outer * outer - inner * inner * inner);
  const double z = 2.0 * direction[0] - 1.0;
  const double across = std::sqrt(std::max(0.0, 1.0 - z * z));
  const double angle = TwoPi * direction[1];
  return std::cbrt(cubes) * Vector3(across * std::cos(angle), across * std::sin(angle), z);
}

}

std::string WhyInvalid(const GroupOptions& options)
{
  ParameterCheck check;
  check.Count("SlavesPerMaster", options.Slaves, 0, MostSlaves);
  check.NotNegative("OffsetRange[0]", options.NearestOffset, "m");
  check.NotNegative("OffsetRange[1]", options.MaximumOffset, "m");
  check.Require(options.MaximumOffset >= options.NearestOffset,
    "OffsetRange is " + TextOf(options.NearestOffset) + " to " + TextOf(options.MaximumOffset) +
      " m; the first must not be above the second.");
  return check.Reason();
}

struct ParticleGroups::Item
{
  Vector3 Place;
  int Particle;
};

ParticleGroups::ParticleGroups(const PlaceList& places, const GroupOptions& options, std::size_t particlesPerCell,
  const ParallelFor& parallelFor, const Poll& poll, std::vector<int> former)
  : Options(options)
  , Tree(std::move(former))
  , Order(places.Size())
  , Places(places.Size())
  , Kin(places.Size())
  , Reaches(places.Size(), 0.0f)
  , Masters(places.Size())
  , Offsets(places.Size(), Vector3(0.0))
{
  if (this->Tree.size() != places.Size())
  {
    this->Tree.resize(places.Size());
    std::iota(this->Tree.begin(), this->Tree.end(), 0);
  }
  if (places.Size() == 0)
  {
    return;
  }
  std::vector<Item> items(places.Size());
  for (std::size_t n = 0; n < places.Size(); ++n)
  {
    items[n] = { places[this->Tree[n]], this->Tree[n] };
  }
  const ParallelFor& onThreads = items.size() > ParticlesOfOneThread ? parallelFor : SerialFor;
  const std::vector<Part> cells = this->FindCells(items, particlesPerCell, onThreads, poll);
  this->Cells.resize(cells.size());
  this->Clusters.resize((cells.size() + CellsOfCluster - 1) / CellsOfCluster);
  onThreads(this->Clusters.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t cluster = first; cluster < last; ++cluster)
    {
      this->PutMastersFirst(cells.data(), cluster);
      const ParticleRegion& all = this->Clusters[cluster];
      std::transform(this->Order.data() + all.Orbits.Begin, this->Order.data() + all.Slaves.End,
        this->Places.data() + all.Orbits.Begin, [&](int particle) { return places[particle]; });
    }
  });
}

/// Cells in the order of the tree, with their groups arranged.
std::vector<ParticleGroups::Part> ParticleGroups::FindCells(
  std::vector<Item>& items, std::size_t cell, const ParallelFor& parallelFor, const Poll& poll)
{
  const std::size_t group = static_cast<std::size_t>(this->Options.Slaves) + 1;
  const std::size_t size = std::max(group, cell);
  // A few large parts one after the other, each of them by a thread.
  std::vector<Part> parts;
  const Part all{ 0, items.size(), BoxOf(items, 0, items.size()) };
  Split(items, all, group, std::max(size, items.size() / 32), parts, poll);
  std::vector<std::vector<Part>> cells(parts.size());
  parallelFor(parts.size(), [&](std::size_t first, std::size_t last) {
    std::vector<Part> groups;
    for (std::size_t part = first; part < last; ++part)
    {
      Split(items, parts[part], group, size, cells[part], NoPoll);
      for (const Part& each : cells[part])
      {
        groups.clear();
        Split(items, each, group, group, groups, NoPoll);
        std::for_each(groups.begin(), groups.end(), [&](const Part& one) { this->Arrange(items, one); });
      }
    }
  });
  std::vector<Part> flat;
  std::for_each(
    cells.begin(), cells.end(), [&](const auto& some) { flat.insert(flat.end(), some.begin(), some.end()); });
  return flat;
}

Box ParticleGroups::BoxOf(const std::vector<Item>& items, std::size_t begin, std::size_t end)
{
  Box bounds{ items[begin].Place, items[begin].Place };
  for (std::size_t n = begin + 1; n < end; ++n)
  {
    bounds.Low = glm::min(bounds.Low, items[n].Place);
    bounds.High = glm::max(bounds.High, items[n].Place);
  }
  return bounds;
}

/// Puts the lower half of some particles along an axis before the upper one.
void ParticleGroups::Halve(std::vector<Item>& items, const Part& low, const Part& high, int axis)
{
  const auto at = [&items](std::size_t n) { return items.begin() + static_cast<std::ptrdiff_t>(n); };
  const auto middle = at(high.Begin);
  // Whoever is below all of the upper half, or above all of the lower one, is in its half already.
  const double least = high.Bounds.Low[axis];
  const double most = low.Bounds.High[axis];
  const auto first = std::partition(at(low.Begin), middle, [=](const Item& item) { return item.Place[axis] < least; });
  const auto last = std::partition(middle, at(high.End), [=](const Item& item) { return item.Place[axis] <= most; });
  // Ties go by number, so that each half has the same particles whatever their order was.
  std::nth_element(first, middle, last, [axis](const Item& a, const Item& b) {
    return a.Place[axis] != b.Place[axis] ? a.Place[axis] < b.Place[axis] : a.Particle < b.Particle;
  });
}

void ParticleGroups::Split(std::vector<Item>& items, const Part& all, std::size_t group, std::size_t cell,
  std::vector<Part>& cells, const Poll& poll)
{
  poll();
  if (all.End - all.Begin <= cell)
  {
    cells.push_back(all);
    return;
  }
  const int axis = LongestSide(all.Bounds);
  const std::size_t middle = all.Begin + HalfOf(all.End - all.Begin, group);
  Part low{ all.Begin, middle, BoxOf(items, all.Begin, middle) };
  Part high{ middle, all.End, BoxOf(items, middle, all.End) };
  if (!(low.Bounds.High[axis] < high.Bounds.Low[axis]))
  {
    Halve(items, low, high, axis);
    low.Bounds = BoxOf(items, low.Begin, low.End);
    high.Bounds = BoxOf(items, high.Begin, high.End);
  }
  Split(items, low, group, cell, cells, poll);
  Split(items, high, group, cell, cells, poll);
}

bool ParticleGroups::IsOffset(const Vector3& offset) const
{
  const double length = glm::length(offset);
  return length >= this->Options.NearestOffset && length <= this->Options.MaximumOffset;
}

/// Puts the master of a group first, then its slaves, then those that follow none.
void ParticleGroups::Arrange(std::vector<Item>& items, const Part& group)
{
  const GroupOptions& options = this->Options;
  const auto first = items.begin() + static_cast<std::ptrdiff_t>(group.Begin);
  const auto last = items.begin() + static_cast<std::ptrdiff_t>(group.End);
  std::sort(first, last, [](const Item& a, const Item& b) { return a.Particle < b.Particle; });
  Vector3 sum(0.0);
  std::for_each(first, last, [&](const Item& item) { sum += item.Place; });
  const Vector3 middle = sum / static_cast<double>(group.End - group.Begin);
  const auto central = std::min_element(first, last,
    [&](const Item& a, const Item& b) { return glm::distance(a.Place, middle) < glm::distance(b.Place, middle); });
  std::rotate(first, central, central + 1);
  const RandomStream random(options.Seed, RandomPurpose::SlaveOffsets);
  const Item& master = *first;
  for (auto item = first; item != last; ++item)
  {
    Vector3 offset = item->Place - master.Place;
    if (options.Scatter)
    {
      offset = PlaceInShell(random, item->Particle, options.NearestOffset, options.MaximumOffset);
    }
    const bool follows = item != first && (options.Scatter || this->IsOffset(offset));
    const double away = std::max(glm::length(offset), glm::distance(item->Place, master.Place));
    float& reach = this->Reaches[master.Particle];
    reach = follows ? std::max(reach, RoundedUp(away)) : reach;
    this->Masters[item->Particle] = follows ? master.Particle : item->Particle;
    this->Offsets[item->Particle] = follows ? offset : Vector3(0.0);
  }
  std::stable_partition(
    first + 1, last, [&](const Item& item) { return this->Masters[item.Particle] != item.Particle; });
  std::transform(first, last, this->Tree.begin() + static_cast<std::ptrdiff_t>(group.Begin),
    [](const Item& item) { return item.Particle; });
}

/// Puts the slaves of a cluster behind all that have orbits, and finds its cells in this order.
void ParticleGroups::PutMastersFirst(const Part* cells, std::size_t cluster)
{
  const std::size_t firstCell = cluster * CellsOfCluster;
  const std::size_t endCell = std::min(firstCell + CellsOfCluster, this->Cells.size());
  const std::size_t begin = cells[firstCell].Begin;
  const auto hasOrbit = [this](int particle) { return this->Masters[particle] == particle; };
  std::size_t orbit = begin;
  std::size_t slave = begin +
    static_cast<std::size_t>(
      std::count_if(this->Tree.data() + begin, this->Tree.data() + cells[endCell - 1].End, hasOrbit));
  const double scatter = this->Options.Scatter && this->Options.Slaves > 0 ? this->Options.MaximumOffset : 0.0;
  ParticleRegion& all = this->Clusters[cluster];
  all.Bounds = cells[firstCell].Bounds;
  for (std::size_t cell = firstCell; cell < endCell; ++cell)
  {
    ParticleRegion& region = this->Cells[cell];
    region = { { orbit, orbit }, { slave, slave }, cells[cell].Bounds, 0.0 };
    region.Bounds = { region.Bounds.Low - scatter, region.Bounds.High + scatter };
    for (std::size_t n = cells[cell].Begin; n < cells[cell].End; ++n)
    {
      this->Put(this->Tree[n], hasOrbit(this->Tree[n]), region);
    }
    orbit = region.Orbits.End;
    slave = region.Slaves.End;
    all.Bounds = { glm::min(all.Bounds.Low, region.Bounds.Low), glm::max(all.Bounds.High, region.Bounds.High) };
    all.Reach = std::max(all.Reach, region.Reach);
  }
  all.Orbits = { begin, orbit };
  all.Slaves = { orbit, slave };
}

/// Puts a particle behind those of its kind in a region. A slave comes after its master, and before all other masters.
void ParticleGroups::Put(int particle, bool hasOrbit, ParticleRegion& region)
{
  const std::size_t place = hasOrbit ? region.Orbits.End++ : region.Slaves.End++;
  this->Order[place] = particle;
  if (hasOrbit)
  {
    this->Kin[place] = static_cast<int>(region.Slaves.End);
    region.Reach = std::max(region.Reach, this->ReachOf(particle));
    return;
  }
  this->Kin[place] = static_cast<int>(region.Orbits.End - 1);
}

}
