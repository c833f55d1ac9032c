// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkParticleLevelOfDetailFilter
 * @brief   show near particles with individual orbits, farther ones in groups and far ones as fog
 *
 * Input 0: a vtkPointSet, the centers of the orbits. Input 1: a sea state from vtkSeaStateSource. Connect the output
 * and the same sea state to vtkParticleOrbitFilter, and the block Far to vtkParticleFogFilter.
 *
 * Output: a vtkMultiBlockDataSet of vtkPolyData with vertices, and points and arrays as in the input: `Near`, particles
 * with individual orbits; `MasterSlave`, first the masters, which have orbits, then the slaves, which keep their
 * offsets from their masters; `Far`, particles shown as fog. Additional point arrays: `ParticleId`, the index in the
 * input unless it has such an array; `Alpha`, the opacity of the particle in this level: levels blend over bands in
 * which a particle is in both, and its alphas sum to 1. Near and MasterSlave also have `TrainCount`, and `ErrorBound`
 * [m], an upper bound of the distance to the position by all trains at any time, without Stokes drift. MasterSlave also
 * has `MasterId`, an index in the block, and `Offset`[3] [m], in the
 * precision of the points. In Far, `TrainCount` is 0.
 *
 * The field array `TrainOrder` of each block is the order in which vtkParticleOrbitFilter takes the trains, by their
 * displacement at the mean height of the particles, which makes the counts smaller.
 *
 * Field data: `ParticlesInAll`, `ParticlesShown` (individually), `ParticlesFar`, `Masters`, `Slaves`, `CellsInAll`,
 * `CellsShown`, `Orbits` to be computed, `TrainSums`, the number of trains of all orbits, `TrainSumsInAll`, the same
 * for all particles with all trains, and `MaximumSlaveError` [m].
 *
 * A group of a master and its slaves is in the levels that the distance of its master tells. The view determines what
 * is shown, never the position of a particle: centers, groups and orders are functions of the input and are kept until
 * it changes. Particles in Far that vtkCurrentDriftFilter carries all the same way are there by steps of PixelError
 * where Far begins, at most 2 cm. Each piece holds its share of the groups of the whole input. Defaults of inherited
 * properties: NearDistance 2 m, FarDistance 12 m. A property out of range or a table that is no sea state is reported
 * as one error.
 *
 * Coulais et al., section 3.3; see Documentation/design/particles.md.
 *
 * @sa vtkParticleOrbitFilter vtkParticleFogFilter vtkViewDependentAlgorithm
 */
#ifndef vtkParticleLevelOfDetailFilter_h
#define vtkParticleLevelOfDetailFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkViewDependentAlgorithm.h"

#include <memory> // for what is kept

class vtkPointSet;

namespace littoral
{
struct ParticleLevelOptions;
struct SeaState;
}

class LITTORALFILTERS_EXPORT vtkParticleLevelOfDetailFilter : public vtkViewDependentAlgorithm
{
public:
  static vtkParticleLevelOfDetailFilter* New();
  vtkTypeMacro(vtkParticleLevelOfDetailFilter, vtkViewDependentAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum TrainSelectionType
  {
    PerTrain = 0,
    TailSum,
    AllTrains
  };

  enum SlavePlacementType
  {
    OwnPlace = 0,
    Scattered
  };

  ///@{
  /**
   * Levels of detail: slaves and fog depending on the distance; default on. If off, each particle has its own orbit.
   */
  vtkSetMacro(UseLevels, bool);
  vtkGetMacro(UseLevels, bool);
  vtkBooleanMacro(UseLevels, bool);
  ///@}

  ///@{
  /**
   * Distance from the camera beyond which particles follow masters, D_m of the paper [m], not negative, not above
   * FarDistance; default 2. It is the same property as NearDistance.
   */
  void SetMiddleDistance(double distance) { this->SetNearDistance(distance); }
  double GetMiddleDistance() { return this->GetNearDistance(); }
  ///@}

  ///@{
  /**
   * Half width of the bands about MiddleDistance and FarDistance in which levels blend [m], not negative; default 0.5.
   */
  vtkSetMacro(BlendDistance, double);
  vtkGetMacro(BlendDistance, double);
  ///@}

  ///@{
  /**
   * Distance from the camera, or from its plane in parallel projection, beyond which neither particles nor fog are
   * shown [m], not negative; default 60. 0 means no limit.
   */
  vtkSetMacro(VisibleDistance, double);
  vtkGetMacro(VisibleDistance, double);
  ///@}

  ///@{
  /**
   * Number of slaves per master, 0 to 1000; default 3.
   */
  vtkSetMacro(SlavesPerMaster, int);
  vtkGetMacro(SlavesPerMaster, int);
  ///@}

  ///@{
  /**
   * Minimum and maximum distance of a slave from its master [m], not negative, not decreasing; default 0 0.5. Particles
   * outside this range have individual orbits.
   */
  vtkSetVector2Macro(OffsetRange, double);
  vtkGetVector2Macro(OffsetRange, double);
  ///@}

  ///@{
  /**
   * Position of a slave relative to its master, a SlavePlacementType; default OwnPlace. OwnPlace: the offset of the
   * particle in the input. Scattered: a random offset within OffsetRange, as in the paper.
   */
  vtkSetMacro(SlavePlacement, int);
  vtkGetMacro(SlavePlacement, int);
  void SetSlavePlacementToOwnPlace() { this->SetSlavePlacement(OwnPlace); }
  void SetSlavePlacementToScattered() { this->SetSlavePlacement(Scattered); }
  ///@}

  ///@{
  /**
   * Seed of the random offsets of scattered slaves, any integer; default 1. Used only if SlavePlacement is Scattered.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * Criterion for leaving out wave trains, a TrainSelectionType; default TailSum. TailSum: the last trains, as long as
   * their total displacement is below PixelError anywhere in a viewport of ViewHeight. PerTrain: each train whose own
   * displacement is, as in the paper; their sum may be several times as much. AllTrains: none.
   */
  vtkSetMacro(TrainSelection, int);
  vtkGetMacro(TrainSelection, int);
  void SetTrainSelectionToPerTrain() { this->SetTrainSelection(PerTrain); }
  void SetTrainSelectionToTailSum() { this->SetTrainSelection(TailSum); }
  void SetTrainSelectionToAllTrains() { this->SetTrainSelection(AllTrains); }
  ///@}

  ///@{
  /**
   * Maximum screen-space error by omitted wave trains, see TrainSelection [pixels], positive; default 1. Not used if
   * TrainSelection is AllTrains.
   */
  vtkSetMacro(PixelError, double);
  vtkGetMacro(PixelError, double);
  ///@}

  ///@{
  /**
   * Culling of particles whose orbits lie outside the view frustum; default on.
   */
  vtkSetMacro(UseCulling, bool);
  vtkGetMacro(UseCulling, bool);
  vtkBooleanMacro(UseCulling, bool);
  ///@}

  ///@{
  /**
   * Mean number of particles per culling cell, positive; default 64.
   */
  vtkSetMacro(ParticlesPerCell, int);
  vtkGetMacro(ParticlesPerCell, int);
  ///@}

  ///@{
  /**
   * Margin of the view frustum for the size of the particles [m], not negative; default 0.01.
   */
  vtkSetMacro(Margin, double);
  vtkGetMacro(Margin, double);
  ///@}

  ///@{
  /**
   * Margin of the view frustum for particles shown as fog [m], not negative; default 1. It should be at least the
   * spacing of the fog image.
   */
  vtkSetMacro(FogMargin, double);
  vtkGetMacro(FogMargin, double);
  ///@}

  /// Connects the sea state, port 1.
  void SetSeaStateConnection(vtkAlgorithmOutput* sea) { this->SetInputConnection(1, sea); }

  /// Removes the connection of port 1, the sea state.
  void RemoveSeaState() { this->RemoveAllInputConnections(1); }

protected:
  vtkParticleLevelOfDetailFilter();
  ~vtkParticleLevelOfDetailFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  bool UseLevels;
  double BlendDistance;
  double VisibleDistance;
  int SlavesPerMaster;
  double OffsetRange[2];
  int SlavePlacement;
  int Seed;
  int TrainSelection;
  double PixelError;
  bool UseCulling;
  int ParticlesPerCell;
  double Margin;
  double FogMargin;

private:
  vtkParticleLevelOfDetailFilter(const vtkParticleLevelOfDetailFilter&) = delete;
  void operator=(const vtkParticleLevelOfDetailFilter&) = delete;

  class vtkInternals;
  std::string WhyBadProperties() const;
  void RememberGroups(vtkPointSet* particles);
  littoral::SeaState ReadInputs(vtkInformationVector** inputVector);
  littoral::ParticleLevelOptions MakeOptions() const;

  std::unique_ptr<vtkInternals> Internals;
};

#endif
