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
 * Plants of several species in one wind: plants in full with all branches, plants of the level Medium as bare trunks
 * that carry their crowns. The motion of a plant depends on the wind at its place and on the time alone, to the last
 * byte; neither on other plants nor on earlier times.
 */
class SwayScene
{
public:
  /// Plants are numbered by their row in `places`. The Species of a place is an index into `species`. Without species,
  /// all plants have the wood of the settings, and plants of the level Medium stand still.
  SwayScene(const SwaySettings& settings, std::shared_ptr<const FrozenWind> wind, std::vector<PlantPlace> places,
    std::vector<SwaySpecies> species);

  /// The settings, with the wind's period as that of the leaves.
  const SwaySettings& GetSettings() const { return this->Settings; }
  const FrozenWind& GetWind() const { return *this->Wind; }
  const std::vector<SwaySpecies>& GetSpecies() const { return this->Species; }
  std::size_t GetNumberOfRows() const { return this->Places.size(); }

  /// Memory of skeletons and leaves [bytes], without that of PlantSway.
  static double BytesOf(std::size_t nodes, std::size_t leaves);

  /// Beams of a plant in full, for AddPlant; with the wood of the settings where there is no such row. Thread-safe.
  std::vector<BranchBeam> BeamsOf(int row, const Skeleton& rest, const std::vector<double>& leafAreas) const;

  /// Adds a plant in full, its joints after those of earlier plants. Why it cannot be added; empty when it was.
  std::string AddPlant(int row, const Skeleton& rest, const std::vector<BranchBeam>& beams);

  /// Makes room for so many leaves in all.
  void ReserveLeaves(std::size_t leaves) { this->Leaves.reserve(leaves); }

  /// Adds a leaf of a plant in full, after the earlier leaves of the same plant. Its flutter is a function of the
  /// plant's identity and of the leaf's number in the plant.
  void AddLeaf(const std::array<int, 4>& corners, int plant, std::uint64_t identity);

  /// Index of a row's bare trunk among the plants; -1 where its species stands still. The first call adds it. Why it
  /// cannot be added; empty otherwise.
  std::string FindTrunk(int row, int& plant);

  /// Joints, and their weights, of the vertices [begin, end) of a block that a trunk carries. Points are tuples of
  /// three, joints and weights of four.
  void FollowTrunk(
    int plant, const float* points, std::size_t begin, std::size_t end, int* joints, float* weights) const;

  /// Adds the crown of a row; its vertices begin at `first` and end at the first of the next crown.
  void AddCrown(int row, std::size_t first);

  /// Areas of the crowns' pictures in their atlas, species by species.
  void SetPictureAreas(const std::vector<AtlasArea>& areas) { this->Areas = areas; }

  /// Moves all plants to a time [s], any finite number.
  void MoveTo(double time, const ParallelFor& parallel = SerialFor);

  std::size_t GetNumberOfPlants() const { return this->Plants.size(); }
  std::size_t GetNumberOfLeaves() const { return this->Leaves.size(); }

  /// Frequency of the trunk's first mode [Hz] by row; 0 for plants that stand still.
  const std::vector<double>& GetFrequencies() const { return this->Frequencies; }

  /// Motion of all joints at the time of MoveTo, for MoveSkin.
  const std::vector<JointChange>& GetChanges() const { return this->Changes; }

  /// The parent of each joint; -1 for the first of a plant.
  std::vector<int> GetParents() const;

  /// The position of a joint [m] at the time of MoveTo.
  Vector3 JointPosition(std::size_t node) const { return this->Rest.Nodes[node].Position + this->Shifts[node]; }

  /// Whether each leaf's corners come behind those of the leaf before.
  bool AreLeavesInOrder() const { return this->LeavesInOrder; }

  /// Range of the vertices of some leaves: [first, end) of the leaves [begin, end) among so many, the first and last
  /// leaves with all before and behind.
  std::array<std::size_t, 2> VerticesOfLeaves(std::size_t begin, std::size_t end, std::size_t vertices) const;

  /// Turns the leaves [begin, end) of skins that MoveSkin has moved, at the time of MoveTo.
  /// Ranges that do not overlap may be turned at once.
  void TurnLeaves(std::size_t begin, std::size_t end, float* points, float* normals);

  /// Texture coordinates of all crowns' vertices at the time of MoveTo. The pictures of a crown are delayed by the
  /// arrival time of the wind at its foot.
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
  LeafFlutter Flutter;
  std::vector<FlutteringLeaf> Leaves;
  bool LeavesInOrder = true;
  std::uint64_t LeafOfPlant = 0; // the last leaf's number in its plant
  std::vector<Crown> Crowns;
  std::vector<AtlasArea> Areas;
  double Time = 0.0;
  std::vector<Vector3> Shifts; // of joints [m]
  std::vector<JointChange> Changes;
  std::vector<LeafWind> Winds; // at each plant

  const SwaySpecies* SpeciesOf(int row) const;
  SwayOptions OptionsOf(int row) const;
  void Pose(std::size_t plant, std::vector<Vector3>& amplitudes, std::vector<JointPose>& poses);
};

}

#endif
