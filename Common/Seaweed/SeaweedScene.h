// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSeaweedScene_h
#define LittoralSeaweedScene_h

#include "Currents/CurrentSet.h"
#include "Geometry/ViewFrustum.h"
#include "Numerics/Parallel.h"
#include "Numerics/TimeMarching.h"
#include "Sea/WaveOrbits.h"
#include "Seaweed/SeaweedLevels.h"
#include "Seaweed/SeaweedMotion.h"
#include "Seaweed/SeaweedStand.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace littoral
{

/// Numbers of what Show() moved.
struct SeaweedCounters
{
  std::int64_t Plants = 0;
  std::int64_t Segments = 0;
  std::int64_t TrainEvaluations = 0; ///< segments times wave trains
};

/**
 * Seaweeds in waves and currents, from rest at the start of a TimeGrid to any time: in steps and a shorter last one if
 * they are physical, else by a closed form of the time (SeaweedMotion).
 *
 * To a goal: while IsAtGoal() is false, the currents at NextMoments() are supplied and Advance() is called. Then the
 * currents at NextMoments() are those for Show() and FindMotion().
 */
class SeaweedScene
{
public:
  /// Largest number of states kept.
  static constexpr std::size_t MaximumCheckpoints = 16;

  SeaweedScene()
    : SeaweedScene(TimeGrid(), {}, true)
  {
  }
  SeaweedScene(
    const TimeGrid& grid, std::vector<CurrentSeries> currents, bool isPhysical, ParallelFor parallel = SerialFor);

  CurrentSet Currents;
  bool NeedsMotion = false; ///< whether FindMotion() is to be called; its currents are those of a whole step
  bool NeedsJoints = false; ///< whether FindChanges() is to be called for all links of far plants, too

  /// Sets the plants, at rest at the start: a valid skeleton with a segment for each node, and for each node a number
  /// that changes from one plant to the next (null: all is one plant). SeaLevel of the options is that of the sea. Why
  /// they cannot be moved, in words for a user; empty if they can.
  std::string SetPlants(Skeleton rest, const std::vector<SeaweedSegment>& segments, const int* plantIds,
    const SeaweedOptions& options, SeaState sea);
  bool HasPlants() const { return this->Marching.IsBegun(); }

  const SeaweedStand& GetStand() const { return this->Stand; }
  std::size_t GetNumberOfLinks() const { return this->Motion ? this->Motion->GetLinks().size() : 0; }
  const std::vector<SeaweedLink>& GetLinks() const { return this->Motion->GetLinks(); }

  /// Cauchy number up to which the drag of blades is right whose links are not graded towards their foot; see
  /// UngradedCauchyNumber.
  double GetUngradedCauchyNumber() const { return this->UngradedCauchy; }

  const TimeGrid& GetGrid() const { return this->Marching.GetGrid(); }
  const StepGoal& GetGoal() const { return this->Marching.GetGoal(); }
  long long GetStep() const { return this->Physical ? this->Marching.GetStep() : this->GetGoal().Step; }

  /// Sets the time to show [s]; before the start physical plants are at rest.
  void SetGoal(double time);

  bool IsAtGoal() const { return !this->Physical || this->Marching.IsAtGoal(); }

  /// The middle and the ends of the next step; at the goal, the moments of Show() and FindMotion().
  std::vector<StepMoment> NextMoments() const;

  /// Whether the currents at NextMoments() are known.
  bool IsNextKnown() const { return this->Currents.AreKnown(this->GetGrid(), this->NextMoments()); }

  /// Takes the state one step further.
  void Advance();

  /// Finds the plants at the goal.
  SeaweedCounters Show(const SeaweedLevels& levels);

  /// Finds velocities and accelerations at the goal, of all detail, whatever Show() found.
  void FindMotion();

  /// Positions of the nodes as Show() found them [m].
  std::vector<Vector3> NodePositions() const;
  Vector3 NodePosition(std::size_t node) const;

  /// Velocities [m/s] and accelerations [m/s2] of the nodes; empty unless found since the last Show().
  const std::vector<Vector3>& GetVelocities() const { return this->Velocities; }
  const std::vector<Vector3>& GetAccelerations() const { return this->Accelerations; }

  /// Rigidity of the skin of a plant in its level, 0 to 1; see MoveSkin.
  float RigidityOf(std::size_t plant) const { return this->Rigidities[plant]; }

  /// Whether only links of the level 2 move in a plant: its skin may follow the carriers of its joints.
  bool IsFar(std::size_t plant) const { return this->AreFar[plant] != 0; }

  /// Rotations of the links as skins show them; empty: those of their poses.
  std::vector<glm::dquat> SkinRotations() const;

  /// Finds the changes of the nodes of a plant, by which its skin moves, or of the carriers among them alone.
  /// `rotations` are SkinRotations(). Far plants have those of carriers alone, unless NeedsJoints.
  void FindChanges(std::size_t plant, const std::vector<glm::dquat>& rotations, std::vector<JointChange>& changes,
    bool ofCarriers = false) const;

private:
  /// Batches of trees that one thread moves at a time, First <= batch < End.
  struct BatchRange
  {
    std::size_t First = 0;
    std::size_t End = 0;
  };
  /// View data that all plants of a picture share.
  struct Picture
  {
    const WaveOrbits& Orbits;
    const StepCurrents& Currents;
    const SeaweedLevels& Levels;
    const std::vector<LinkState>& States;
    const std::vector<LinkPose>& Poses; ///< those that go with them
    std::unique_ptr<ViewFrustum> View;  ///< null: no levels
  };

  /// A procedural plant whose water is to be found.
  struct MovingPlant
  {
    std::size_t Index = 0;
    SeaweedLevelShares Shares;
  };

  /// Memory of one thread, kept from plant to plant.
  struct Work
  {
    std::vector<Vector3> Middles;
    std::vector<WaterAtLink> Water;
    std::vector<float> Shares;  ///< of wave trains, a set a plant; none: all of all
    std::vector<int> ShareSets; ///< of links
    std::vector<MovingPlant> Plants;
    std::vector<float> Centers;
    std::vector<float> First;
    std::vector<float> Second;
    std::vector<float> Gradient;
  };

  std::vector<StepMoment> MomentsOf(double length) const;
  StepCurrents CurrentsOver(double length) const;
  void MakeBatchRanges();
  void PoseAll();
  void WaterAt(const WaveOrbits& orbits, const StepCurrents& currents, Work& work) const;
  void StepAll(double time, double step, const StepCurrents& currents, std::vector<LinkState>& states,
    std::vector<LinkPose>& poses) const;
  void StepBatches(const BatchRange& range, double step, const WaveOrbits& orbits, const StepCurrents& currents,
    std::vector<LinkState>& states, std::vector<LinkPose>& poses, Work& work) const;
  void FindTrainSums();
  std::int64_t AddSharesFor(std::size_t plant, const SeaweedLevels& levels, std::vector<float>& shares) const;
  LinkState ProceduralIn(int level, std::size_t link, const WaterAtLink& water, const LinkPose* poses) const;
  void ShowLink(std::size_t link, const WaterAtLink& water, const SeaweedLevelShares& shares);
  SeaweedCounters ShowPhysical(std::size_t index, const std::array<double, 3>& shares, const Picture& picture);
  SeaweedCounters AddMoving(const MovingPlant& moving, const Picture& picture, Work& work) const;
  void ShowMoving(const Picture& picture, Work& work);
  bool IsPosed(std::size_t plant, std::size_t link) const;
  void ShowAtRest(std::size_t index);
  SeaweedCounters ShowPlant(std::size_t index, const Picture& picture, Work& work);
  SeaweedCounters ShowAt(double time, double remainder, const StepCurrents& currents, const SeaweedLevels& levels);
  void FindPhysicalMotion();
  void FindProceduralMotion();
  Vector3 NodeBy(int link, std::size_t node, const std::vector<LinkPose>& poses) const;
  Vector3 NodeAt(std::size_t node, const std::vector<LinkPose>& poses) const;
  Vector3 NodeVelocity(std::size_t node, const std::vector<LinkPose>& poses) const;
  std::vector<Vector3> VelocitiesIn(const std::vector<LinkPose>& poses) const;

  bool Physical;
  ParallelFor Parallel;
  SeaweedOptions Options;
  SeaState Sea;
  SeaweedStand Stand;
  std::unique_ptr<SeaweedMotion> Motion;
  double UngradedCauchy = std::numeric_limits<double>::infinity();
  std::vector<BatchRange> BatchRanges;
  std::vector<double> TrainSums; ///< at the tops of plants, those of a plant together; empty until they are needed

  TimeMarching<std::vector<LinkState>> Marching;
  std::vector<LinkPose> Poses; ///< of the state that marches

  std::vector<LinkPose> Shown;
  std::vector<float> Rigidities; ///< of plants, as shown
  std::vector<char> AreFar;      ///< plants, as shown
  /// Procedural plants as they are near by, in the middle and far away, where two of these are mixed.
  std::array<std::vector<LinkPose>, 3> LevelPoses;
  std::vector<Vector3> Velocities;    ///< of nodes
  std::vector<Vector3> Accelerations; ///< of nodes
};

}

#endif
