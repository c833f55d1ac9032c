// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSeaweedStand_h
#define LittoralSeaweedStand_h

#include "Plants/Skeleton.h"
#include "Seaweed/SeaweedPlant.h"

#include <cstddef>
#include <vector>

namespace littoral
{

/// One seaweed of a stand: the links [FirstLink, EndLink), and a sphere that it never leaves.
struct StandPlant
{
  std::size_t FirstLink = 0;
  std::size_t EndLink = 0;
  Vector3 Middle{ 0.0 }; ///< [m]
  double Reach = 0.0;    ///< radius around Middle [m]
};

/// A stand of seaweeds, one or many, at rest: which nodes of the skeleton, links and plants belong to each other.
class SeaweedStand
{
public:
  SeaweedStand() = default;

  /// `links` are those of the skeleton (LinksOf). `plantIds` has a number for each node, which changes from one plant
  /// to the next; null: all is one plant.
  SeaweedStand(Skeleton rest, const std::vector<SeaweedLink>& links, const int* plantIds);

  const Skeleton& GetSkeleton() const { return this->Rest; }
  const std::vector<StandPlant>& GetPlants() const { return this->Plants; }

  /// The link that moves a node; -1: none, it is fixed to the ground.
  int LinkOf(std::size_t node) const { return this->LinkOfNode[node]; }

  /// The plant of a node. A holdfast belongs to the plant that comes next.
  std::size_t PlantOf(std::size_t node) const { return this->PlantOfNode[node]; }

  /// The least detailed level in which a link moves, of 0 near, 1 middle, 2 far.
  int LastLevelOf(std::size_t link) const { return this->LastLevels[link]; }

  /// The link that carries another one where only links of the level 2 move; such a link carries itself.
  std::size_t CarrierOf(std::size_t link) const { return this->Carriers[link]; }

  /// Whether a link carries others, or one that does grows on it.
  bool IsBelowCarrier(std::size_t link) const { return this->AreBelowCarriers[link] != 0; }

  /// Nodes by whose links nodes move where only links of the level 2 do; nodes without a link are their own.
  std::vector<int> CarriersOf(const std::vector<SeaweedLink>& links) const;

private:
  void FindLinks(const std::vector<SeaweedLink>& links);
  void FindCarriers(const std::vector<SeaweedLink>& links);
  void FindPlants(const int* plantIds);
  static void Measure(const std::vector<SeaweedLink>& links, StandPlant& plant);

  Skeleton Rest;
  std::vector<StandPlant> Plants;
  std::vector<int> LinkOfNode;
  std::vector<std::size_t> PlantOfNode;
  std::vector<unsigned char> LastLevels;       ///< of links
  std::vector<std::size_t> Carriers;           ///< of links
  std::vector<unsigned char> AreBelowCarriers; ///< links
};

}

#endif
