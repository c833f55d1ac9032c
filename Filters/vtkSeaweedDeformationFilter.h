// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSeaweedDeformationFilter
 * @brief   seaweeds that bend with waves and currents
 *
 * Inputs: port 0, one seaweed or a scattered forest of them, as vtkSeaweedSource makes them (vtkMultiBlockDataSet with
 * High {Skeleton, Skin, Leaves}; the skeleton has the arrays of that source); port 1, a sea state, as vtkSeaStateSource
 * makes it; port 2, repeatable, currents, as vtkCurrentDriftFilter takes them. One of sea state and currents is enough.
 * Plants may also be a vtkPartitionedDataSetCollection whose assembly has these blocks, each part in one partition, and
 * whose field data are those of the plants; the output has blocks.
 *
 * Output: the plants at the requested time, with skins that follow their skeletons. The holdfast never moves; without
 * motion of the water, limp plants rise by their buoyancy. The levels Medium and Low stand still.
 *
 * Physical plants have a state: it begins at StartTime, at rest, and goes on in steps of TimeStep, with a shorter last
 * one; it is a function of the time alone, whatever was asked before, and whatever the camera saw. Some states are kept
 * to begin from. Before StartTime plants are at rest. Procedural plants are a closed form of the time.
 *
 * With UseLevels: within NearDistance all segments of a branch move; from there to FarDistance the half next to its
 * foot; beyond, the first. What does not move keeps its angles of rest. Beyond NearDistance skins are
 * rigid: a vertex follows one segment. Levels change over BlendDistance and BlendTime. Plants out of the view stay at
 * rest; procedural ones leave out what is below PixelError of the smallest wave trains, which fade with the distance.
 * None of it touches the state.
 *
 * Segments of blades should get shorter towards their foot, as those of vtkSeaweedSource do: ten of them have the drag
 * of the blade within 5 % up to a Cauchy number of 1e4. Where they do not, a warning says up to which number drag is
 * right.
 *
 * Field data of the output: `PlantsInAll`, `PlantsShown`, `SegmentsInAll`, `SegmentsMoved` (in this picture),
 * `TrainEvaluations` (segments times wave trains, of procedural motion in this picture).
 *
 * Coulais et al., section 4, eqs. 4 to 10 with their errors put right; see Documentation/errata.md.
 *
 * @sa vtkSeaweedSource vtkSeaStateSource vtkPlantWakeFilter
 */
#ifndef vtkSeaweedDeformationFilter_h
#define vtkSeaweedDeformationFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkViewDependentAlgorithm.h"

#include <memory> // for what is kept between frames
#include <string> // for reasons
#include <vector> // for what a state depends on

namespace littoral
{
struct SeaweedLevels;
struct SeaweedOptions;
}

class LITTORALFILTERS_EXPORT vtkSeaweedDeformationFilter : public vtkViewDependentAlgorithm
{
public:
  static vtkSeaweedDeformationFilter* New();
  vtkTypeMacro(vtkSeaweedDeformationFilter, vtkViewDependentAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// 0 Procedural: springs at equilibrium with the load of the moment (eqs. 5, 6); 1 Physical: the equations of motion
  /// (eqs. 7 to 10). Default 1.
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /// 0 Bending, about two axes; 1 Tilting, the paper's azimuth about the parent and tilt. Default 0.
  vtkSetMacro(Joint, int);
  vtkGetMacro(Joint, int);
  ///@}

  ///@{
  /// 0 Morison: drag by the relative velocity, inertia, buoyancy; 1 Direct, the paper's: ForceFactor times the
  /// acceleration of the water (of a procedural plant its displacement) and the current. Default 0.
  vtkSetMacro(Load, int);
  vtkGetMacro(Load, int);
  ///@}

  ///@{
  /// Of physical plants: 0 Implicit, the midpoint rule, of second order, in sub-steps where the motion needs them;
  /// plants gain no energy but from the water; 1 Explicit Euler, the paper's, with a warning where TimeStep is beyond
  /// its limit. Default 0.
  vtkSetMacro(Integrator, int);
  vtkGetMacro(Integrator, int);
  ///@}

  ///@{
  /// When physical plants are at rest [s]. Some seconds before the first picture let them lean into the current.
  /// Default -5.
  vtkSetMacro(StartTime, double);
  vtkGetMacro(StartTime, double);
  ///@}

  ///@{
  /// Step of physical plants [s], 1e-5 to 1. Default 1/48.
  vtkSetMacro(TimeStep, double);
  vtkGetMacro(TimeStep, double);
  ///@}

  ///@{
  /// [kg/m3], 1 to 1e5. Default 1025.
  vtkSetMacro(WaterDensity, double);
  vtkGetMacro(WaterDensity, double);
  ///@}

  ///@{
  /// Of the flow across a segment, by the area of its face and, along the width, of its edge, 0 to 100. Default 1.
  vtkSetMacro(DragCoefficient, double);
  vtkGetMacro(DragCoefficient, double);
  ///@}

  ///@{
  /// Of the flow along a segment, by its surface, 0 to 100. Default 0.02.
  vtkSetMacro(FrictionCoefficient, double);
  vtkGetMacro(FrictionCoefficient, double);
  ///@}

  ///@{
  /// Mass of water that moves along, as part of the cylinder around the width in motion normal to the face, and around
  /// the thickness in motion along the width; none in motion along the segment. 0 to 100. Default 1.
  vtkSetMacro(AddedMassCoefficient, double);
  vtkGetMacro(AddedMassCoefficient, double);
  ///@}

  ///@{
  /// Factor of the damping ratios of the plants, 0 to 1000. Default 1.
  vtkSetMacro(DampingFactor, double);
  vtkGetMacro(DampingFactor, double);
  ///@}

  ///@{
  /// Of the load Direct, on a metre of a segment [N/m] for 1 m/s2, 1 m or 1 m/s, 0 to 1e6. Default 1.
  vtkSetMacro(ForceFactor, double);
  vtkGetMacro(ForceFactor, double);
  ///@}

  ///@{
  /// Of procedural plants: where the load acts, as part of the segment, 0 to 1. The paper has 1. Default 0.5.
  vtkSetMacro(LeverArm, double);
  vtkGetMacro(LeverArm, double);
  ///@}

  ///@{
  /// Of procedural plants: what no joint goes beyond [degrees], 0 to 180. Default 60.
  vtkSetMacro(LargestAngle, double);
  vtkGetMacro(LargestAngle, double);
  ///@}

  ///@{
  /// Whether plants move in less detail far from the view point, and not at all out of view. Default off.
  vtkSetMacro(UseLevels, bool);
  vtkGetMacro(UseLevels, bool);
  vtkBooleanMacro(UseLevels, bool);
  ///@}

  ///@{
  /// Length over which a level changes into the next, beyond NearDistance and FarDistance [m], not negative; for plants
  /// that reach further, their reach. 0: levels change at once. Default 12.
  vtkSetMacro(BlendDistance, double);
  vtkGetMacro(BlendDistance, double);
  ///@}

  ///@{
  /// Time that a view of ViewSpeed takes, at least, through a change of levels [s], not negative: BlendDistance grows
  /// by what it goes in that time. So levels change over a time, and pictures still depend on no earlier ones. Default
  /// 0.
  vtkSetMacro(BlendTime, double);
  vtkGetMacro(BlendTime, double);
  ///@}

  ///@{
  /// How fast the view moves, for BlendTime [m/s], not negative. Default 1, a diver's.
  vtkSetMacro(ViewSpeed, double);
  vtkGetMacro(ViewSpeed, double);
  ///@}

  ///@{
  /// What is left out of waves may move the water at the top of a plant by, all together [pixels], not negative. Of
  /// procedural plants; a limp one may be off by several times as much (up to 6 pixels of the presets at the default).
  /// Default 0.5.
  vtkSetMacro(PixelError, double);
  vtkGetMacro(PixelError, double);
  ///@}

  ///@{
  /// Whether to add the point arrays `Velocity`[3] [m/s] and `Acceleration`[3] [m/s2] to High/Skeleton, of all segments
  /// whatever the view; vtkPlantWakeFilter needs them. Default off.
  vtkSetMacro(GenerateMotion, bool);
  vtkGetMacro(GenerateMotion, bool);
  vtkBooleanMacro(GenerateMotion, bool);
  ///@}

  ///@{
  /// Name of the point array of velocities in currents that are no flow primitives. Empty or null: `Velocity`, else the
  /// only array of three components. Default null.
  vtkSetStringMacro(VelocityArray);
  vtkGetStringMacro(VelocityArray);
  ///@}

  ///@{
  /// First and last time that players are told of [s], increasing. Any time can be asked for. Default 0 60.
  vtkSetVector2Macro(TimeRange, double);
  vtkGetVector2Macro(TimeRange, double);
  ///@}

  /// The sea state, on port 1.
  void SetSeaStateConnection(vtkAlgorithmOutput* sea) { this->SetInputConnection(1, sea); }

  /// Disconnects the sea state.
  void RemoveSeaState() { this->RemoveAllInputConnections(1); }

  /// Disconnects all currents.
  void RemoveAllCurrents() { this->RemoveAllInputConnections(2); }

protected:
  vtkSeaweedDeformationFilter();
  ~vtkSeaweedDeformationFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Method;
  int Joint;
  int Load;
  int Integrator;
  double StartTime;
  double TimeStep;
  double WaterDensity;
  double DragCoefficient;
  double FrictionCoefficient;
  double AddedMassCoefficient;
  double DampingFactor;
  double ForceFactor;
  double LeverArm;
  double LargestAngle;
  bool UseLevels;
  double BlendDistance;
  double BlendTime;
  double ViewSpeed;
  double PixelError;
  bool GenerateMotion;
  char* VelocityArray;
  double TimeRange[2];

private:
  vtkSeaweedDeformationFilter(const vtkSeaweedDeformationFilter&) = delete;
  void operator=(const vtkSeaweedDeformationFilter&) = delete;

  class Internals;
  std::string WhyInvalid(double time) const;
  littoral::SeaweedOptions MakeOptions() const;
  std::vector<double> StateKey(vtkInformationVector** inputs, vtkInformation* output);
  std::string TakeInputs(vtkInformationVector** inputs, vtkMultiBlockDataSet* blocks);
  std::string TakePlants(vtkInformationVector* seas, vtkMultiBlockDataSet* blocks);
  void WarnOfLimits();
  bool FindLevels(littoral::SeaweedLevels& levels);
  void Write(const littoral::SeaweedLevels& levels, vtkMultiBlockDataSet* plants, vtkMultiBlockDataSet* output);
  int Fail(vtkInformation* request, vtkDataObject* output);

  std::unique_ptr<Internals> State;
};

#endif
