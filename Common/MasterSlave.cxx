// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MasterSlave.h"

#include "Constants.h"
#include "RandomStream.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace littoral
{

namespace
{

constexpr int MostSlaves = 1000;

Box BoundsOf(const std::vector<Vector3>& places, const std::vector<int>& order, std::size_t begin, std::size_t end)
{
  Box box{ places[order[begin]], places[order[begin]] };
  for (std::size_t n = begin + 1; n < end; ++n)
  {
    box.Low = glm::min(box.Low, places[order[n]]);
    box.High = glm::max(box.High, places[order[n]]);
  }
  return box;
}

int LongestSide(const Box& box)
{
  const Vector3 size = box.High - box.Low;
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

/// Where to cut a row of particles, so that all groups but the last one of it are full.
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
  const double cubes = inner * inner * inner + part * (outer * outer * outer - inner * inner * inner);
  const double z = 2.0 * direction[0] - 1.0;
  const double across = std::sqrt(std::max(0.0, 1.0 - z * z));
  const double angle = TwoPi * direction[1];
  return std::cbrt(cubes) * Vector3(across * std::cos(angle), across * std::sin(angle), z);
}

}

std::string WhyInvalid(const GroupOptions& options)
{
  std::ostringstream reason;
  if (options.Slaves < 0 || options.Slaves > MostSlaves)
  {
    reason << "SlavesPerMaster is " << options.Slaves << "; it must be 0 to " << MostSlaves << ".";
  }
  else if (!(options.NearestOffset >= 0.0 && options.LargestOffset >= options.NearestOffset &&
             std::isfinite(options.LargestOffset)))
  {
    reason << "OffsetRange is " << options.NearestOffset << " to " << options.LargestOffset
           << " m; it must be finite, not negative, and its first not above its second.";
  }
  return reason.str();
}

ParticleGroups::ParticleGroups(const std::vector<Vector3>& places, const GroupOptions& options,
  std::size_t particlesPerCell, const ParallelFor& parallelFor)
  : GroupSize(static_cast<std::size_t>(options.Slaves) + 1)
  , Order(places.size())
  , Masters(places.size())
  , Offsets(places.size(), Vector3(0.0))
{
  std::iota(this->Order.begin(), this->Order.end(), 0);
  if (places.empty())
  {
    return;
  }
  const std::size_t group = this->GroupSize;
  const std::size_t cell = std::max(group, particlesPerCell);
  // A few large parts one after the other, each of them by a thread.
  std::vector<Cell> parts;
  this->Split(places, 0, places.size(), group, std::max(cell, places.size() / 32), parts);
  std::vector<std::vector<Cell>> cells(parts.size());
  parallelFor(parts.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t part = first; part < last; ++part)
    {
      this->Split(places, parts[part].Begin, parts[part].End, group, cell, cells[part]);
      for (Cell& each : cells[part])
      {
        std::vector<Cell> groups;
        this->Split(places, each.Begin, each.End, group, group, groups);
        for (const Cell& one : groups)
        {
          this->Arrange(places, options, one.Begin, one.End);
        }
        const double scatter = options.Scatter && options.Slaves > 0 ? options.LargestOffset : 0.0;
        each.Bounds.Low -= scatter;
        each.Bounds.High += scatter;
      }
    }
  });
  for (const std::vector<Cell>& some : cells)
  {
    this->Cells.insert(this->Cells.end(), some.begin(), some.end());
  }
}

void ParticleGroups::Split(const std::vector<Vector3>& places, std::size_t begin, std::size_t end, std::size_t group,
  std::size_t cell, std::vector<Cell>& cells)
{
  const Box bounds = BoundsOf(places, this->Order, begin, end);
  if (end - begin <= cell)
  {
    cells.push_back({ begin, end, bounds });
    return;
  }
  const int axis = LongestSide(bounds);
  const std::size_t middle = begin + HalfOf(end - begin, group);
  const auto at = [this](std::size_t n) { return this->Order.begin() + static_cast<std::ptrdiff_t>(n); };
  // Which particles come first is settled by the ties' numbers; in which order they do is not, so it is made so.
  const auto isBefore = [&](int a, int b) {
    return places[a][axis] != places[b][axis] ? places[a][axis] < places[b][axis] : a < b;
  };
  std::nth_element(at(begin), at(middle), at(end), isBefore);
  this->Split(places, begin, middle, group, cell, cells);
  this->Split(places, middle, end, group, cell, cells);
}

void ParticleGroups::Arrange(
  const std::vector<Vector3>& places, const GroupOptions& options, std::size_t begin, std::size_t end)
{
  const auto first = this->Order.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto last = this->Order.begin() + static_cast<std::ptrdiff_t>(end);
  std::sort(first, last);
  Vector3 sum(0.0);
  std::for_each(first, last, [&](int particle) { sum += places[particle]; });
  const Vector3 middle = sum / static_cast<double>(end - begin);
  const auto away = [&](int particle) { return glm::distance(places[particle], middle); };
  const auto master = std::min_element(first, last, [&](int a, int b) { return away(a) < away(b); });
  std::rotate(first, master, master + 1);
  const RandomStream random(options.Seed, RandomPurpose::SlaveOffsets);
  this->Masters[*first] = *first;
  for (auto slave = first + 1; slave != last; ++slave)
  {
    Vector3 offset = places[*slave] - places[*first];
    if (options.Scatter)
    {
      offset = PlaceInShell(random, *slave, options.NearestOffset, options.LargestOffset);
    }
    const double length = glm::length(offset);
    const bool follows = options.Scatter || (length >= options.NearestOffset && length <= options.LargestOffset);
    this->Masters[*slave] = follows ? *first : *slave;
    this->Offsets[*slave] = follows ? offset : Vector3(0.0);
  }
}

}
