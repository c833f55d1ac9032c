// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSeaweedDeformationFilter
 * @brief   deform seaweeds by waves and currents
 *
 * Inputs: port 0, one seaweed or a scattered forest of them from vtkSeaweedSource (vtkMultiBlockDataSet with High
 * {Skeleton, Skin, Leaves}; the skeleton has the arrays of that source); port 1, a sea state from vtkSeaStateSource;
 * port 2, repeatable, currents as in vtkCurrentDriftFilter. A sea state or a current is needed. Plants may also be a
 * vtkPartitionedDataSetCollection whose assembly has these blocks, each part in one partition, and whose field data are
 * those of the plants; the output has blocks.
 *
 * Output: the plants at the requested time, with skins that follow their skeletons. The holdfast never moves; in still
 * water, flexible plants rise by their buoyancy. The levels Medium and Low do not move.
 *
 * Plants of the method Physical have a state: it begins at rest at StartTime and is integrated in steps of TimeStep,
 * with a shorter last step; it is a function of the time alone, whatever was requested before and whatever the camera
 * saw. Some states are kept as starting points. Before StartTime plants are at rest. Plants of the method Procedural
 * are a closed form of the time.
 *
 * With UseLevels: within NearDistance all segments of a branch move; from there to FarDistance the half next to its
 * base; beyond, the first. Segments that do not move keep their angles of rest. Beyond NearDistance each vertex of the
 * skin follows one segment. Levels blend over BlendDistance and BlendTime. Plants outside the view stay at rest;
 * procedural ones omit the shortest wave trains below PixelError, gradually with the distance, and in steady currents
 * each stays as it is for a power of two of TimeSteps, up to 32, in which its water moves by less than PixelError. The
 * state does not depend on any of this.
 *
 * Segments of blades should be shorter towards their base, as those of vtkSeaweedSource are: ten of them have the drag
 * of the blade within 5 % up to a Cauchy number of 1e4. Where they are not, a warning gives the largest Cauchy number
 * with correct drag.
 *
 * Field data of the output: `PlantsInAll`, `PlantsShown`, `SegmentsInAll`, `SegmentsMoved` (in this frame),
 * `TrainEvaluations` (segments times wave trains, of procedural motion in this frame). Defaults of inherited
 * properties: NearDistance 5 m, FarDistance 20 m. A property out of range, an input without these arrays or a time more
 * than 1e7 steps after StartTime is reported as one error.
 *
 * Coulais et al., section 4, eqs. 4 to 10 with corrections; see Documentation/errata.md.
 *
 * @sa vtkSeaweedSource vtkSeaStateSource vtkPlantWakeFilter
 */
#ifndef vtkSeaweedDeformationFilter_h
#define vtkSeaweedDeformationFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkViewDependentAlgorithm.h"

#include <memory> // for what is kept between frames
#include <string> // for checks
#include <vector> // for what a state depends on

namespace littoral
{
enum class MarchEnd;
struct SeaweedLevels;
struct SeaweedOptions;
}

class LITTORALFILTERS_EXPORT vtkSeaweedDeformationFilter : public vtkViewDependentAlgorithm
{
public:
  static vtkSeaweedDeformationFilter* New();
  vtkTypeMacro(vtkSeaweedDeformationFilter, vtkViewDependentAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum MethodType
  {
    Procedural = 0,
    Physical = 1,
  };

  ///@{
  /**
   * Method of motion, a MethodType; default Physical. Procedural: springs in equilibrium with the instantaneous load
   * (eqs. 5, 6). Physical: the equations of motion (eqs. 7 to 10).
   */
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  void SetMethodToProcedural() { this->SetMethod(Procedural); }
  void SetMethodToPhysical() { this->SetMethod(Physical); }
  ///@}

  enum JointType
  {
    Bending = 0,
    Tilting = 1,
  };

  ///@{
  /**
   * Joint model, a JointType; default Bending. Bending: about two axes. Tilting: the azimuth about the parent segment
   * and the tilt of the paper, which cannot bend a straight plant in all directions.
   */
  vtkSetMacro(Joint, int);
  vtkGetMacro(Joint, int);
  void SetJointToBending() { this->SetJoint(Bending); }
  void SetJointToTilting() { this->SetJoint(Tilting); }
  ///@}

  enum LoadType
  {
    Morison = 0,
    Direct = 1,
  };

  ///@{
  /**
   * Load model, a LoadType; default Morison. Morison: drag by the relative velocity, inertia and buoyancy. Direct, that
   * of the paper: ForceFactor times the current and the acceleration of the water (its displacement for procedural
   * plants).
   */
  vtkSetMacro(Load, int);
  vtkGetMacro(Load, int);
  void SetLoadToMorison() { this->SetLoad(Morison); }
  void SetLoadToDirect() { this->SetLoad(Direct); }
  ///@}

  enum IntegratorType
  {
    Implicit = 0,
    ExplicitEuler = 1,
  };

  ///@{
  /**
   * Time integration of physical plants, an IntegratorType; default Implicit. Implicit: the second-order midpoint rule,
   * with sub-steps where the motion needs them; plants gain energy from the water only. ExplicitEuler, that of the
   * paper: with a warning where TimeStep exceeds its stability limit.
   */
  vtkSetMacro(Integrator, int);
  vtkGetMacro(Integrator, int);
  void SetIntegratorToImplicit() { this->SetIntegrator(Implicit); }
  void SetIntegratorToExplicitEuler() { this->SetIntegrator(ExplicitEuler); }
  ///@}

  ///@{
  /**
   * Time at which physical plants are at rest [s], -1e9 to 1e9; default -5. Some seconds before the first frame let
   * them lean into the current.
   */
  vtkSetMacro(StartTime, double);
  vtkGetMacro(StartTime, double);
  ///@}

  ///@{
  /**
   * Time step of physical plants, and of the times at which far procedural ones move [s], 1e-5 to 1; default 1/48.
   */
  vtkSetMacro(TimeStep, double);
  vtkGetMacro(TimeStep, double);
  ///@}

  ///@{
  /**
   * Density of the water [kg/m3], 1 to 1e5; default 1025.
   */
  vtkSetMacro(WaterDensity, double);
  vtkGetMacro(WaterDensity, double);
  ///@}

  ///@{
  /**
   * Drag coefficient of the flow normal to a blade, 0 to 100; default 1.95, that of a plate. The reference area is that
   * of the face, and of the edge for flow along the width. Round stipes and floats have half of it.
   */
  vtkSetMacro(DragCoefficient, double);
  vtkGetMacro(DragCoefficient, double);
  ///@}

  ///@{
  /**
   * Skin friction coefficient of the flow along a segment, 0 to 100; default 0.02. The reference area is the wetted
   * surface.
   */
  vtkSetMacro(FrictionCoefficient, double);
  vtkGetMacro(FrictionCoefficient, double);
  ///@}

  ///@{
  /**
   * Added mass coefficient, 0 to 100; default 1. The reference mass is that of a water cylinder with the width as
   * diameter for acceleration normal to the face, and with the thickness as diameter for acceleration along the width;
   * acceleration along the segment has none.
   */
  vtkSetMacro(AddedMassCoefficient, double);
  vtkGetMacro(AddedMassCoefficient, double);
  ///@}

  ///@{
  /**
   * Factor of the damping ratios of the plants, 0 to 1000; default 1.
   */
  vtkSetMacro(DampingFactor, double);
  vtkGetMacro(DampingFactor, double);
  ///@}

  ///@{
  /**
   * Force per length of the load Direct [N/m] for 1 m/s2, 1 m or 1 m/s, 0 to 1e6; default 1.
   */
  vtkSetMacro(ForceFactor, double);
  vtkGetMacro(ForceFactor, double);
  ///@}

  ///@{
  /**
   * Point of action of the load on a segment of a procedural plant, as a fraction of its length, 0 to 1; default 0.5.
   * The paper has 1.
   */
  vtkSetMacro(LeverArm, double);
  vtkGetMacro(LeverArm, double);
  ///@}

  ///@{
  /**
   * Maximum joint angle of procedural plants [degrees], 0 to 180; default 60.
   */
  vtkSetMacro(MaximumAngle, double);
  vtkGetMacro(MaximumAngle, double);
  ///@}

  ///@{
  /**
   * Levels of detail of the motion depending on the distance from the camera, and none outside the view; default off.
   */
  vtkSetMacro(UseLevels, bool);
  vtkGetMacro(UseLevels, bool);
  vtkBooleanMacro(UseLevels, bool);
  ///@}

  ///@{
  /**
   * Length over which a level blends into the next, beyond NearDistance and FarDistance [m], 0 to 1e9; default 12. It
   * is at least the reach of the plant. 0 means an immediate change.
   */
  vtkSetMacro(BlendDistance, double);
  vtkGetMacro(BlendDistance, double);
  ///@}

  ///@{
  /**
   * Minimum duration of a change of levels for a camera moving at ViewSpeed [s], 0 to 1e9; default 0. BlendDistance is
   * increased by the distance covered in that time, so that the output still does not depend on earlier frames.
   */
  vtkSetMacro(BlendTime, double);
  vtkGetMacro(BlendTime, double);
  ///@}

  ///@{
  /**
   * Speed of the camera for BlendTime [m/s], 0 to 1e9; default 1, that of a diver.
   */
  vtkSetMacro(ViewSpeed, double);
  vtkGetMacro(ViewSpeed, double);
  ///@}

  ///@{
  /**
   * Maximum screen-space displacement of the water at the top of a procedural plant by all omitted wave trains, and as
   * much while it stays as it is [pixels], 0 to 1e9; default 0.5. The error of a flexible plant may be many times
   * larger.
   */
  vtkSetMacro(PixelError, double);
  vtkGetMacro(PixelError, double);
  ///@}

  ///@{
  /**
   * Addition of the point arrays `Velocity`[3] [m/s] and `Acceleration`[3] [m/s2] to High/Skeleton, for all segments in
   * any view; default off. Needed by vtkPlantWakeFilter.
   */
  vtkSetMacro(GenerateMotion, bool);
  vtkGetMacro(GenerateMotion, bool);
  vtkBooleanMacro(GenerateMotion, bool);
  ///@}

  ///@{
  /**
   * Addition of the block `Joints` to the output, for programs that move skins themselves, as vtkGLTFSceneWriter does:
   * a point for each joint at its position, with the point arrays `ParentId` (-1: none), `RestPosition`[3] [m] and
   * `Rotation`[4] (quaternion w, x, y, z, since rest); default off. `JointIds` are indices of it.
   * Beyond NearDistance skins follow joints in another way: switch UseLevels off.
   */
  vtkSetMacro(GenerateJoints, bool);
  vtkGetMacro(GenerateJoints, bool);
  vtkBooleanMacro(GenerateJoints, bool);
  ///@}

  ///@{
  /**
   * Name of the point array of velocities in currents that are no flow primitives; default null. If empty or null, it
   * is `Velocity`, else the only array of three components.
   */
  vtkSetStringMacro(VelocityArray);
  vtkGetStringMacro(VelocityArray);
  ///@}

  ///@{
  /**
   * First and last time of an animation, announced as TIME_RANGE [s], increasing; default 0 60. Any time can be
   * requested.
   */
  vtkSetVector2Macro(TimeRange, double);
  vtkGetVector2Macro(TimeRange, double);
  ///@}

  /// Connects the sea state, port 1.
  void SetSeaStateConnection(vtkAlgorithmOutput* sea) { this->SetInputConnection(1, sea); }

  /// Removes the connection of port 1, the sea state.
  void RemoveSeaState() { this->RemoveAllInputConnections(1); }

  /// Adds a current, to port 2.
  void AddCurrentConnection(vtkAlgorithmOutput* current) { this->AddInputConnection(2, current); }

  /// Removes all connections of port 2, the currents.
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
  double MaximumAngle;
  bool UseLevels;
  double BlendDistance;
  double BlendTime;
  double ViewSpeed;
  double PixelError;
  bool GenerateMotion;
  bool GenerateJoints;
  char* VelocityArray;
  double TimeRange[2];

private:
  vtkSeaweedDeformationFilter(const vtkSeaweedDeformationFilter&) = delete;
  void operator=(const vtkSeaweedDeformationFilter&) = delete;

  class vtkInternals;
  std::string WhyInvalid(double time) const;
  littoral::SeaweedOptions MakeOptions() const;
  std::vector<double> StateKey(vtkInformationVector** inputs, vtkInformation* output);
  void TakeInputs(vtkInformationVector** inputs, vtkMultiBlockDataSet* blocks);
  void TakePlants(vtkInformationVector* seas, vtkMultiBlockDataSet* blocks);
  void WarnOfLimits();
  littoral::SeaweedLevels FindLevels();
  void Write(const littoral::SeaweedLevels& levels, vtkMultiBlockDataSet* plants, vtkMultiBlockDataSet* output);
  littoral::MarchEnd March(vtkInformationVector** inputVector, vtkMultiBlockDataSet* plants);
  void Fail(vtkDataObject* output);

  std::unique_ptr<vtkInternals> Internals;
};

#endif
