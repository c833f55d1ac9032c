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
#include <map>
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
  float RigidityOf(std::size_t plant) const { return static_cast<float>(1.0 - this->Plants[plant].Look.Shares.Near); }

  /// Whether only links of the level 2 move in a plant: its skin may follow the carriers of its joints.
  bool IsFar(std::size_t plant) const { return this->Plants[plant].Look.IsFar(); }

  /// The number of the last Show(), from 1.
  long long GetShow() const { return this->ShowNumber; }

  /// Whether a plant is not as it was after an earlier Show().
  bool HasChangedSince(std::size_t plant, long long show) const { return this->Plants[plant].Changed > show; }

  /// Whether a plant stays as it is for some pictures of a view that seems to stand still.
  bool Stays(std::size_t plant) const
  {
    const PlantLook& look = this->Plants[plant].Look;
    return !look.IsSeen || (look.Held > 0 && this->StandsStill);
  }

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
  /// The motion and the level of a plant in a view.
  struct PlantLook
  {
    SeaweedLevelShares Shares;
    double WaterError = 0.0; ///< [m]
    int Held = 0;            ///< steps for which it is shown as it was
    bool IsSeen = true;      ///< else it is at rest

    bool IsFar() const { return this->Shares.Near <= 0.0 && this->Shares.Far <= 0.0; }
    bool operator==(const PlantLook& other) const
    {
      return this->Shares.Near == other.Shares.Near && this->Shares.Far == other.Shares.Far &&
        this->WaterError == other.WaterError && this->Held == other.Held && this->IsSeen == other.IsSeen;
    }
  };
  /// A plant as it is shown.
  struct ShownPlant
  {
    PlantLook Look;
    double Time = std::numeric_limits<double>::quiet_NaN(); ///< of its motion; no number: it is to be shown anew
    long long Changed = 0;                                  ///< the Show() that found it
    SeaweedCounters Counters;
  };

  /// The water at a moment and the plants to be shown in it.
  struct Moment
  {
    WaveOrbits Orbits;
    StepCurrents Currents;
    std::vector<std::size_t> Plants;
  };
  /// The state that physical plants of a picture share.
  struct Picture
  {
    const std::vector<LinkState>& States;
    const std::vector<LinkPose>& Poses; ///< those that go with them
  };

  /// Memory of one thread, kept from plant to plant.
  struct Work
  {
    std::vector<Vector3> Middles;
    std::vector<WaterAtLink> Water;
    std::vector<float> Shares;       ///< of wave trains, a set a plant; none: all of all
    std::vector<int> ShareSets;      ///< of links
    std::vector<std::size_t> Plants; ///< procedural ones whose water is to be found
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
  std::int64_t AddSharesFor(std::size_t plant, std::vector<float>& shares) const;
  LinkState ProceduralIn(int level, std::size_t link, const WaterAtLink& water, const LinkPose* poses) const;
  void ShowLink(std::size_t link, const WaterAtLink& water, const SeaweedLevelShares& shares);
  SeaweedCounters ShowPhysical(std::size_t index, const std::array<double, 3>& shares, const Picture& picture);
  SeaweedCounters AddMoving(std::size_t index, Work& work) const;
  void ShowMoving(const Moment& moment, Work& work);
  bool IsPosed(std::size_t plant, std::size_t link) const;
  void ShowAtRest(std::size_t index);
  SeaweedCounters ShowPlant(std::size_t index, const Picture& picture, Work& work);
  PlantLook LookOf(std::size_t index, const SeaweedLevels& levels, const ViewFrustum& frustum, bool mayBeHeld) const;
  void FindLooks(const SeaweedLevels& levels);
  std::map<long long, Moment> MomentsToShow(double time, const StepCurrents& currents);
  void ShowPlants(const std::map<long long, Moment>& moments, const Picture& picture);
  void ShowAt(double time, double remainder, const StepCurrents& currents);
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
  std::vector<double> TrainSums;   ///< at the tops of plants, those of a plant together; empty until they are needed
  std::vector<double> TrainSpeeds; ///< there, one a plant

  TimeMarching<std::vector<LinkState>> Marching;
  std::vector<LinkPose> Poses; ///< of the state that marches

  std::vector<LinkPose> Shown;
  std::vector<ShownPlant> Plants;
  SeaweedLevels Levels; ///< by which their looks were found
  bool AreLooksFound = false;
  bool HadJoints = false;   ///< NeedsJoints as they were shown
  bool StandsStill = false; ///< the view is that of the Show() before
  long long ShowNumber = 0;
  /// Procedural plants as they are near by, in the middle and far away, where two of these are mixed.
  std::array<std::vector<LinkPose>, 3> LevelPoses;
  std::vector<Vector3> Velocities;    ///< of nodes
  std::vector<Vector3> Accelerations; ///< of nodes
};

}

#endif
