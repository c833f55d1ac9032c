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

/// Particles from Begin up to End in an order.
struct PlaceRange
{
  std::size_t Begin = 0;
  std::size_t End = 0;

  std::size_t Size() const { return this->End - this->Begin; }
};

/// Particles that are near each other, with all slaves of their masters.
struct ParticleRegion
{
  PlaceRange Orbits; ///< masters, and particles that follow none
  PlaceRange Slaves;
  Box Bounds;         ///< that holds them, at their own places and as slaves
  double Reach = 0.0; ///< bound of the distance of slaves from their masters [m]

  std::size_t Size() const { return this->Orbits.Size() + this->Slaves.Size(); }
};

/**
 * Particles in groups of neighbours, whose masters alone need an orbit (Coulais et al., 3.3.3), in cells of whole
 * groups, to be tested against a view at once (3.3.2), and in clusters of cells. Medians along the longest side of a
 * box cut the particles in two until a group is left: groups are compact wherever particles crowd, and depend on the
 * places only.
 *
 * The master is the particle next to the middle of its group. A particle that is nearer to it than the nearest offset,
 * or farther than the largest, moves by itself. With Scatter none is, and offsets are random.
 */
class ParticleGroups
{
public:
  static constexpr std::size_t CellsOfCluster = 16;

  /// About as many particles as asked for, at least one group, in a cell. Options must be valid, places finite. The
  /// order of former groups of the same particles, if given, saves time where they have moved little; the groups are
  /// the same without.
  ParticleGroups(const PlaceList& places, const GroupOptions& options, std::size_t particlesPerCell,
    const ParallelFor& parallelFor = SerialFor, const Poll& poll = NoPoll, std::vector<int> former = {});

  const std::vector<ParticleRegion>& GetCells() const { return this->Cells; }

  /// CellsOfCluster cells each, in their order, but for the last one. What is in one lies side by side in the order.
  const std::vector<ParticleRegion>& GetClusters() const { return this->Clusters; }

  /// Particles, cluster after cluster: those of all cells with orbits of their own, then the slaves of all cells.
  const std::vector<int>& GetOrder() const { return this->Order; }

  /// Places of the particles when they were grouped, in this order [m].
  const std::vector<Vector3>& GetPlaces() const { return this->Places; }

  /// Particles as the medians have cut them, group after group: the former order of groups to come.
  const std::vector<int>& GetTree() const { return this->Tree; }

  /// Slaves of the master at a place in the order of a cell; none where it has none.
  PlaceRange SlavesAt(const ParticleRegion& cell, std::size_t place) const
  {
    return { static_cast<std::size_t>(this->Kin[place]),
      place + 1 < cell.Orbits.End ? static_cast<std::size_t>(this->Kin[place + 1]) : cell.Slaves.End };
  }

  /// Place of the master of the slave at a place in the order.
  std::size_t MasterAt(std::size_t place) const { return static_cast<std::size_t>(this->Kin[place]); }

  /// Bound of the distance of the slaves from a master, at their own places and as slaves [m]; 0 without any.
  double ReachOf(int master) const { return this->Reaches[master]; }

  /// The master of a particle; the particle itself if it has none.
  int MasterOf(int particle) const { return this->Masters[particle]; }

  /// Offset of a slave from its master when they were grouped [m]; zero for others.
  const Vector3& OffsetOf(int particle) const { return this->Offsets[particle]; }

private:
  struct Item; ///< a particle with its place beside it

  /// Items from Begin up to End.
  struct Part
  {
    std::size_t Begin;
    std::size_t End;
    Box Bounds;
  };

  static Box BoxOf(const std::vector<Item>& items, std::size_t begin, std::size_t end);
  static void Halve(std::vector<Item>& items, const Part& low, const Part& high, int axis);
  static void Split(std::vector<Item>& items, const Part& all, std::size_t group, std::size_t cell,
    std::vector<Part>& cells, const Poll& poll);
  std::vector<Part> FindCells(
    std::vector<Item>& items, std::size_t cell, const ParallelFor& parallelFor, const Poll& poll);
  void Arrange(std::vector<Item>& items, const Part& group);
  void PutMastersFirst(const Part* cells, std::size_t cluster);
  void Put(int particle, bool hasOrbit, ParticleRegion& region);
  bool IsOffset(const Vector3& offset) const;

  GroupOptions Options;
  std::vector<int> Tree;
  std::vector<int> Order;
  std::vector<Vector3> Places; ///< in the order
  std::vector<int> Kin;        ///< by place: the first slave of a master, the master of a slave
  std::vector<float> Reaches;
  std::vector<int> Masters;
  std::vector<Vector3> Offsets;
  std::vector<ParticleRegion> Cells;
  std::vector<ParticleRegion> Clusters;
};

}

#endif
