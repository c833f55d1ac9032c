// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportSeaweedForest_h
#define LittoralSupportSeaweedForest_h

// Seaweeds in the sea between blocks and the numerics. Private: never installed, never wrapped.

#include "Data/DriftHistory.h"
#include "Data/PlantBlocks.h"
#include "Data/SeaweedBlocks.h"
#include "Geometry/ViewFrustum.h"
#include "Sea/WaveOrbits.h"
#include "Seaweed/SeaweedMotion.h"

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkAlgorithm;

namespace littoral
{

/// What is shown of seaweeds, and how.
struct SeaweedLevels
{
  bool UseLevels = false;
  double NearDistance = 5.0;   ///< [m]
  double FarDistance = 20.0;   ///< [m]
  double BlendDistance = 12.0; ///< beyond either, over which levels of small plants change [m]
  double PixelError = 0.5;     ///< of the water, by what is left out of waves [pixels]
  View Seen;
};

/// What a picture cost.
struct SeaweedCounters
{
  std::int64_t Shown = 0;            ///< plants
  std::int64_t Segments = 0;         ///< that were moved by a method
  std::int64_t TrainEvaluations = 0; ///< segments times wave trains, of what is shown
};

/// Seaweeds at full detail, one or many, with all that does not change from frame to frame, and their state.
class SeaweedForest
{
public:
  /// The reason why plants cannot be read, or nothing.
  std::string Read(vtkMultiBlockDataSet* plants, const SeaweedOptions& options);

  void SetSea(const SeaState& sea, bool isPhysical)
  {
    this->Sea = sea;
    this->IsPhysical = isPhysical;
  }

  std::size_t GetNumberOfLinks() const { return this->Motion ? this->Motion->GetLinks().size() : 0; }
  const std::vector<SeaweedLink>& GetLinks() const { return this->Motion->GetLinks(); }
  /// Of blades whose links are not graded towards their foot: the Cauchy number up to which their drag is right.
  double GetUngradedCauchyNumber() const { return this->UngradedCauchy; }
  std::size_t GetNumberOfPlants() const { return this->Plants.size(); }

  /// All at rest at the step 0.
  void Reset();

  /// Begins from the latest known state that is not after a step.
  void Resume(long long step);

  long long GetStep() const { return this->NowStep; }

  /// Takes the state one step further, from a time [s]. False when aborted.
  void Advance(double time, double step, const StepCurrents& currents);

  /// Finds the plants at a time, `rest` [s] after the state of the step.
  SeaweedCounters Show(double time, double rest, const StepCurrents& currents, const SeaweedLevels& levels);

  /// Adds Velocity and Acceleration of the nodes to what Show found; of all detail, whatever is shown.
  void FindMotion(double time, double rest, double step, const StepCurrents& currents);

  /// Writes the plants; `output` is a shallow copy of `plants`.
  void Write(vtkMultiBlockDataSet* plants, vtkMultiBlockDataSet* output) const;

private:
  struct Plant
  {
    std::size_t FirstLink = 0;
    std::size_t EndLink = 0;
    Vector3 Middle{ 0.0 };
    double Reach = 0.0; ///< of all it can touch around Middle [m]
    float Rigid = 0.0f; ///< how far its skin has turned stiff, 0 to 1
  };
  /// A run of vertices of one plant.
  struct Run
  {
    vtkIdType First = 0;
    vtkIdType End = 0;
    std::size_t Plant = 0;
  };
  struct Skin
  {
    const char* Name;
    vtkPolyData* Rest = nullptr;
    std::vector<Run> Runs;             ///< by plants
    std::vector<std::size_t> FirstRun; ///< of a plant, and an end
  };
  /// Bunches of trees that one thread moves at a time.
  struct Batch
  {
    std::size_t First = 0;
    std::size_t End = 0;
  };

  SeaweedOptions Options;
  SeaState Sea;
  bool IsPhysical = true;
  Skeleton Rest;
  std::unique_ptr<SeaweedMotion> Motion;
  double UngradedCauchy = std::numeric_limits<double>::infinity();
  std::vector<int> LinkOfNode; ///< that moves it; -1: the ground
  std::vector<std::size_t> PlantOfNode;
  std::vector<int> OrderInBranch; ///< of a link
  std::vector<int> LinksOfBranch; ///< of a link: how many its branch has
  std::vector<Plant> Plants;
  std::vector<Batch> Batches;
  std::vector<Skin> Skins;

  std::vector<LinkState> Now;
  std::vector<LinkPose> NowPoses;
  long long NowStep = 0;
  std::map<long long, std::vector<LinkState>> Checkpoints;
  long long Stride = 1;

  std::vector<LinkPose> Shown;
  /// Procedural plants as they are near by, in the middle and far away, whatever is shown.
  std::array<std::vector<LinkPose>, 3> LevelPoses;
  std::vector<Vector3> Velocities;    ///< of nodes
  std::vector<Vector3> Accelerations; ///< of nodes

  std::string ReadPlants(vtkPolyData* bones);
  std::string ReadSkins(vtkMultiBlockDataSet* plants);
  void MakeBatches();
  void WaterAt(const WaveOrbits& orbits, const StepCurrents& currents, const std::vector<Vector3>& middles,
    const std::vector<float>& shares, std::vector<WaterAtLink>& water) const;
  void StepAll(double time, double step, const StepCurrents& currents, std::vector<LinkState>& states,
    std::vector<LinkPose>& poses) const;
  std::vector<float> TrainSharesFor(const Plant& plant, const SeaweedLevels& levels) const;
  int LastLevelOf(std::size_t link) const;
  LinkState ProceduralState(std::size_t link, const WaterAtLink& water, double near, double far);
  void ShowPlant(Plant& plant, const WaveOrbits& orbits, const StepCurrents& currents, const SeaweedLevels& levels,
    const ViewFrustum* view, const std::vector<LinkState>& states, SeaweedCounters& counters);
  std::vector<Vector3> NodesAt(const std::vector<LinkPose>& poses, bool velocities) const;
  std::vector<glm::dquat> TurnsOfSkins() const;
  void FindChanges(const Plant& plant, const std::vector<glm::dquat>& turns, std::vector<JointChange>& changes) const;
  void MoveRun(
    const Run& run, const RestSkin<float>& rest, const std::vector<JointChange>& changes, float* p, float* n) const;
  void MoveSkins(vtkMultiBlockDataSet* blocks) const;
};

}

#endif
