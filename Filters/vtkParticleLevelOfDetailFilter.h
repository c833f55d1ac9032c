// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkParticleLevelOfDetailFilter
 * @brief   particles near the eye with their own orbits, farther ones behind masters, far ones as fog
 *
 * Input 0: a vtkPointSet, the centers of the orbits. Input 1: a sea state, as vtkSeaStateSource makes it. Give the
 * output and the same sea to vtkParticleOrbitFilter, and the block Far to vtkParticleFogFilter.
 *
 * Output: a vtkMultiBlockDataSet of vtkPolyData with vertices, points and arrays as in the input: `Near`, particles
 * with orbits of their own; `MasterSlave`, first the masters, which have orbits, then the slaves, which keep their
 * offsets from them; `Far`, particles that are fog. Point arrays, besides those of the input: `ParticleId`, the index
 * in the input unless it has such an array; `Alpha`, how much of the particle the level shows: levels change over bands
 * in which the particle is in both, and its alphas sum to 1. In Near and MasterSlave also `TrainCount`, and
 * `ErrorBound` [m], how far the particle may be, at any time, from where all trains would have it, without the drift of
 * Stokes. In MasterSlave also `MasterId`, an index in the block, and `Offset`. In Far, `TrainCount` is 0.
 *
 * The field array `TrainOrder` of each block tells in which order vtkParticleOrbitFilter takes the trains: by what they
 * do at the mean height of the particles. Counts are fewer that way.
 *
 * Field data: `ParticlesInAll`, `ParticlesShown` (one by one), `ParticlesFar`, `Masters`, `Slaves`, `CellsInAll`,
 * `CellsShown`, `Orbits` that are to be computed, `TrainSums`, the trains of all orbits together, `TrainSumsInAll`, the
 * same for all particles with all trains, and `LargestSlaveError` [m].
 *
 * The view decides on what is shown, never on where a particle is: centers, groups and orders are functions of the
 * input. They are kept until it changes. Each piece has its part of the groups, of the whole input.
 *
 * Coulais et al., section 3.3; see Documentation/design.md.
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
}

class LITTORALFILTERS_EXPORT vtkParticleLevelOfDetailFilter : public vtkViewDependentAlgorithm
{
public:
  static vtkParticleLevelOfDetailFilter* New();
  vtkTypeMacro(vtkParticleLevelOfDetailFilter, vtkViewDependentAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum TrainSelections
  {
    PerTrain = 0,
    TailSum,
    AllTrains
  };

  enum SlavePlacements
  {
    OwnPlace = 0,
    Scattered
  };

  ///@{
  /// Whether particles become slaves and fog with distance; else each has its orbit. Default on.
  vtkSetMacro(UseLevels, bool);
  vtkGetMacro(UseLevels, bool);
  vtkBooleanMacro(UseLevels, bool);
  ///@}

  ///@{
  /// Distance from the eye from which particles follow masters [m], not negative, not above FarDistance. Another name
  /// of NearDistance. Default 2, the paper's D_m.
  void SetMiddleDistance(double distance) { this->SetNearDistance(distance); }
  double GetMiddleDistance() { return this->GetNearDistance(); }
  ///@}

  ///@{
  /// Half the width of the bands about MiddleDistance and FarDistance in which levels change [m], not negative. Default
  /// 0.5.
  vtkSetMacro(BlendDistance, double);
  vtkGetMacro(BlendDistance, double);
  ///@}

  ///@{
  /// Distance from the eye, or from its plane in parallel projection, beyond which particles are left out, as fog too
  /// [m], not negative; 0: no limit. Default 60.
  vtkSetMacro(Visibility, double);
  vtkGetMacro(Visibility, double);
  ///@}

  ///@{
  /// Slaves that follow a master, 0 to 1000. Default 3.
  vtkSetMacro(SlavesPerMaster, int);
  vtkGetMacro(SlavesPerMaster, int);
  ///@}

  ///@{
  /// Least and largest distance of a slave from its master [m], not negative and increasing. Particles nearer or
  /// farther move by themselves. Default 0 to 0.5.
  vtkSetVector2Macro(OffsetRange, double);
  vtkGetVector2Macro(OffsetRange, double);
  ///@}

  ///@{
  /// Where slaves keep. OwnPlace: at their own distance from their master. Scattered, the paper's: at a random one
  /// within OffsetRange. Default OwnPlace.
  vtkSetMacro(SlavePlacement, int);
  vtkGetMacro(SlavePlacement, int);
  ///@}

  ///@{
  /// Of the places of scattered slaves; of no effect without them. Any number. Default 1.
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /// Which trains are left out. TailSum: the last ones, as long as together they move the particle by less than
  /// ScreenError, anywhere in a picture of ViewHeight. PerTrain, the paper's: each that moves it by less, whose sum may
  /// be some times as much. AllTrains: none. Default TailSum.
  vtkSetMacro(TrainSelection, int);
  vtkGetMacro(TrainSelection, int);
  ///@}

  ///@{
  /// Of what is left out, see TrainSelection [pixels], positive; of no effect with AllTrains. Default 1.
  vtkSetMacro(ScreenError, double);
  vtkGetMacro(ScreenError, double);
  ///@}

  ///@{
  /// Whether particles whose orbits the view cannot show are left out. Default on.
  vtkSetMacro(UseCulling, bool);
  vtkGetMacro(UseCulling, bool);
  vtkBooleanMacro(UseCulling, bool);
  ///@}

  ///@{
  /// About how many particles a cell holds, positive. Default 64.
  vtkSetMacro(ParticlesPerCell, int);
  vtkGetMacro(ParticlesPerCell, int);
  ///@}

  ///@{
  /// By which the view is widened for the size of the particles [m], not negative. Default 0.01.
  vtkSetMacro(Margin, double);
  vtkGetMacro(Margin, double);
  ///@}

  ///@{
  /// By which the view is widened for particles that are fog [m], not negative: at least the spacing of the fog's grid.
  /// Default 1.
  vtkSetMacro(FogMargin, double);
  vtkGetMacro(FogMargin, double);
  ///@}

protected:
  vtkParticleLevelOfDetailFilter();
  ~vtkParticleLevelOfDetailFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  bool UseLevels;
  double BlendDistance;
  double Visibility;
  int SlavesPerMaster;
  double OffsetRange[2];
  int SlavePlacement;
  int Seed;
  int TrainSelection;
  double ScreenError;
  bool UseCulling;
  int ParticlesPerCell;
  double Margin;
  double FogMargin;

private:
  vtkParticleLevelOfDetailFilter(const vtkParticleLevelOfDetailFilter&) = delete;
  void operator=(const vtkParticleLevelOfDetailFilter&) = delete;

  struct Internals;
  struct Piece;
  std::string WhyBadProperties() const;
  std::string RememberGroups(vtkPointSet* particles);
  littoral::ParticleLevelOptions MakeOptions() const;

  std::unique_ptr<Internals> Internal;
};

#endif
