// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSwayScene_h
#define LittoralSwayScene_h

#include "Geometry/TextureAtlas.h"
#include "Numerics/Parallel.h"
#include "Plants/PlantScatter.h"
#include "Plants/Skinning.h"
#include "Sway/PlantMotion.h"
#include "Sway/SwaySpecies.h"
#include "Wind/FrozenWind.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace littoral
{

/**
 * Plants of several species that sway in a wind: those in full with all their branches, those of the level Medium as
 * trunks alone, along which their crowns go. The motion of a plant depends on its own wind alone; neither other plants
 * nor the times asked for before change a byte of it.
 */
class SwayScene
{
public:
  /// A row of `places` is a plant's number. Species of the places are indices into `species`, which may be empty: all
  /// plants then have the wood of the settings, and none of the level Medium sways.
  SwayScene(const SwaySettings& settings, std::shared_ptr<const FrozenWind> wind, std::vector<PlantPlace> places,
    std::vector<SwaySpecies> species);

  /// The settings, with the wind's period as that of the leaves.
  const SwaySettings& GetSettings() const { return this->Settings; }
  const FrozenWind& GetWind() const { return *this->Wind; }
  const std::vector<SwaySpecies>& GetSpecies() const { return this->Species; }
  std::size_t GetNumberOfRows() const { return this->Places.size(); }

  /// Memory [bytes] of plants' skeletons and leaves, but for what PlantSway keeps.
  static double BytesOf(std::size_t nodes, std::size_t leaves);

  /// The beams of a plant in full, for AddPlant. A row of none is that of a plant of no species. Thread-safe.
  std::vector<BranchBeam> BeamsOf(int row, const Skeleton& rest, const std::vector<double>& leafAreas) const;

  /// Adds a plant in full; its joints follow those of the plants before it. Why it cannot be added; empty when it was.
  std::string AddPlant(int row, const Skeleton& rest, const std::vector<BranchBeam>& beams);

  /// Adds a leaf of a plant in full, a plant's leaves in a row. Its flutter is a function of the plant's identity and
  /// of its own place among the plant's leaves.
  void AddLeaf(const std::array<int, 4>& corners, int plant, std::uint64_t identity);

  /// The plant of a row as a trunk, which is added at the first call; -1 where its species stands still. Why it cannot
  /// be added; empty when it was.
  std::string FindTrunk(int row, int& plant);

  /// Which joints move the vertices [begin, end) of a block that follows a trunk. Points are tuples of three, joints
  /// and weights of four.
  void FollowTrunk(
    int plant, const float* points, std::size_t begin, std::size_t end, int* joints, float* weights) const;

  /// Adds the crown of a row; its vertices begin at `first` and end at the first of the next crown.
  void AddCrown(int row, std::size_t first);

  /// Pictures of the crowns in their atlas, all of a species side by side.
  void SetPictureAreas(const std::vector<AtlasArea>& areas) { this->Areas = areas; }

  /// Moves all plants to a time [s], any finite number.
  void MoveTo(double time, const ParallelFor& parallel = SerialFor);

  std::size_t GetNumberOfPlants() const { return this->Plants.size(); }
  std::size_t GetNumberOfLeaves() const { return this->Leaves.size(); }

  /// The first mode of the trunk [Hz] of each plant that sways, by row; 0 of those that stand still.
  const std::vector<double>& GetFrequencies() const { return this->Frequencies; }

  /// What the joints of all plants add to their skins, at the time of MoveTo.
  const std::vector<JointChange>& GetChanges() const { return this->Changes; }

  /// The position of a joint [m] at the time of MoveTo.
  Vector3 JointPosition(std::size_t node) const { return this->Rest.Nodes[node].Position + this->Poses[node].Shift; }

  /// Turns leaves [begin, end), which joints have moved, to the wind at the time of MoveTo, and lets them flutter.
  void TurnLeaves(std::size_t begin, std::size_t end, float* points, float* normals) const;

  /// Texture coordinates of the vertices of all crowns, so that each shows its picture of the time of MoveTo. The
  /// pictures of a crown are late by the arrival time of the wind at its foot.
  void ShowPictures(std::size_t vertices, float* tcoords, const ParallelFor& parallel = SerialFor) const;

private:
  /// A plant in full, or a trunk.
  struct SwayingPlant
  {
    std::size_t FirstJoint = 0;
    std::size_t Branches = 0;
    std::unique_ptr<PlantMotion> Motion;
    std::unique_ptr<PlantSway> Sway;
  };
  struct Leaf
  {
    std::array<int, 4> Corners{};
    int Plant = 0;
    std::uint64_t Identity = 0;
  };
  struct Crown
  {
    std::size_t First = 0;
    int Species = 0;
    double Arrival = 0.0; // of the wind at its foot [s]
  };

  SwaySettings Settings;
  std::shared_ptr<const FrozenWind> Wind;
  std::vector<PlantPlace> Places;
  std::vector<SwaySpecies> Species;
  Skeleton Rest; // nodes of all plants
  std::vector<double> Frequencies;
  std::vector<int> TrunkOfRow;
  std::vector<SwayingPlant> Plants;
  std::vector<Leaf> Leaves;
  std::uint64_t LeafOfPlant = 0; // the last leaf's number in its plant
  std::vector<Crown> Crowns;
  std::vector<AtlasArea> Areas;
  double Time = 0.0;
  std::vector<JointPose> Poses;
  std::vector<JointChange> Changes;
  std::vector<Vector3> Winds; // at each plant

  const SwaySpecies* SpeciesOf(int row) const;
  SwayOptions OptionsOf(int row) const;
  void Pose(std::size_t plant, std::vector<Vector3>& amplitudes);
};

}

#endif
