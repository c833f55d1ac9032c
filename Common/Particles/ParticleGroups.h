// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralParticleGroups_h
#define LittoralParticleGroups_h

#include "Geometry/ViewFrustum.h"
#include "Numerics/Parallel.h"
#include "Numerics/Vector3.h"
#include "Particles/PlaceList.h"

#include <cstddef>
#include <string>
#include <vector>

namespace littoral
{

/// Parameters of the grouping of particles into a master and its slaves.
struct GroupOptions
{
  int Slaves = 3;             ///< a master, 0 to 1000
  double NearestOffset = 0.0; ///< of a slave from its master [m], not negative
  double MaximumOffset = 0.5; ///< [m], not below NearestOffset
  bool Scatter = false;       ///< slaves leave their places for random ones around their master
  int Seed = 1;               ///< of these places
};

std::string WhyInvalid(const GroupOptions& options);

/**
 * Particles in groups of neighbours, whose masters alone need an orbit (Coulais et al., 3.3.3), and in cells of whole
 * groups, to be tested against a view at once (3.3.2). Medians along the longest side of a box cut the particles in two
 * until a group is left: groups are compact wherever particles crowd, and depend on the places only.
 *
 * The master is the particle next to the middle of its group. A particle that is nearer to it than the nearest offset,
 * or farther than the largest, moves by itself. With Scatter none is, and offsets are random.
 */
class ParticleGroups
{
public:
  /// About as many particles as asked for, at least one group, in a cell. Options must be valid, places finite. The
  /// order of former groups of the same particles, if given, saves time where they have moved little; the groups are
  /// the same without.
  ParticleGroups(const PlaceList& places, const GroupOptions& options, std::size_t particlesPerCell,
    const ParallelFor& parallelFor = SerialFor, const Poll& poll = NoPoll, std::vector<int> former = {});

  /// Particles from begin up to end in the order, and the box that holds them, at their own places and as slaves.
  struct Cell
  {
    std::size_t Begin;
    std::size_t End;
    Box Bounds;
  };

  const std::vector<Cell>& GetCells() const { return this->Cells; }

  /// Particles of a group, masters and slaves; the last group may have fewer.
  std::size_t GetGroupSize() const { return this->GroupSize; }

  /// Particles, cell after cell, group after group, each master before its slaves.
  const std::vector<int>& GetOrder() const { return this->Order; }

  /// The master of a particle; the particle itself if it has none.
  int MasterOf(int particle) const { return this->Masters[particle]; }

  /// Offset that a slave keeps from its master [m]; zero for others.
  const Vector3& OffsetOf(int particle) const { return this->Offsets[particle]; }

  /// Whether a particle follows the first one of its group, of which it is another, from where both are now, and the
  /// offset that it keeps [m]. At the places of the grouping it does if its MasterOf() is another one.
  bool Follows(int particle, const Vector3& place, const Vector3& master, Vector3& offset) const;

private:
  struct Item; ///< a particle with its place beside it

  static Box BoxOf(const std::vector<Item>& items, std::size_t begin, std::size_t end);
  static void Halve(std::vector<Item>& items, const Cell& low, const Cell& high, int axis);
  static void Split(std::vector<Item>& items, const Cell& all, std::size_t group, std::size_t cell,
    std::vector<Cell>& cells, const Poll& poll);
  void Arrange(std::vector<Item>& items, std::size_t begin, std::size_t end);

  bool IsOffset(const Vector3& offset) const;

  GroupOptions Options;
  std::size_t GroupSize;
  std::vector<int> Order;
  std::vector<int> Masters;
  std::vector<Vector3> Offsets;
  std::vector<Cell> Cells;
};

}

#endif
