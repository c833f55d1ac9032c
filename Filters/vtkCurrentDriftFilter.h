// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCurrentDriftFilter
 * @brief   advect points by currents
 *
 * Input 0: any vtkPointSet, or a vtkMultiBlockDataSet or vtkPartitionedDataSetCollection of them: the positions at
 * StartTime. Input 1, optional and repeatable: currents, which are superposed. A current is a data set of flow
 * primitives from vtkFlowPrimitiveSource, or any data set with a point array of velocities [m/s], such as the output of
 * an ocean model, a wind or a wake, or composite data of these. The velocity outside of a data set is 0; an image or
 * rectilinear grid of one layer is valid at all heights. Velocities that are not finite count as 0, as ocean models
 * have them on land.
 *
 * Output: the points at the requested time, in the precision of the input, with the point arrays `Start`[3] [m], where
 * they began, and `Captured` (1 in the
 * core of a sink). Connect it to vtkParticleOrbitFilter, for which these are the centers of orbits. Without currents
 * the input is passed through. Before StartTime the points are at their initial positions.
 *
 * Points are integrated by the fourth-order Runge-Kutta method in steps of TimeStep from StartTime, and a shorter last
 * step. The state at a time is a function of that time alone, whatever was requested before; some states are kept as
 * starting points. A current that is uniform in space and time is applied without steps.
 *
 * Currents that vary in time are requested at their TIME_STEPS and interpolated between these, or at every half
 * TimeStep if they have a TIME_RANGE only. Recent time steps are kept. Before the first and after the last time they
 * are constant.
 *
 * There is no flow through bed and surface, so that no point leaves the water, and points that fill it evenly go on
 * doing so in any current free of divergence. Of uniform flows only the horizontal component is used. Sources, sinks
 * and vortices have mirror images beyond the walls; those out of the water have no effect. A grid that ends within one
 * cell of a wall is extended to it: its horizontal velocity is constant, its vertical one decreases to 0. Where a wall
 * lies within a grid, the vertical velocity at the wall is subtracted from that of the grid at all heights, between two
 * walls in proportion to the height. Points out of the water at StartTime do not move. Slaves (point arrays `MasterId`
 * and `Offset`[3], see vtkParticleOrbitFilter) move with their masters.
 *
 * A property out of range, a current without velocities or a time more than 1e7 steps after StartTime is reported as
 * one error. Coulais et al., eq. 3.
 *
 * @sa vtkFlowPrimitiveSource vtkSuspendedParticleSource vtkParticleOrbitFilter
 */
#ifndef vtkCurrentDriftFilter_h
#define vtkCurrentDriftFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkPassInputTypeAlgorithm.h"

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkPointSet;
namespace littoral
{
enum class MarchEnd;
struct WaterLayer;
}

class LITTORALFILTERS_EXPORT vtkCurrentDriftFilter : public vtkPassInputTypeAlgorithm
{
public:
  static vtkCurrentDriftFilter* New();
  vtkTypeMacro(vtkCurrentDriftFilter, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  ///@{
  /**
   * Time of the input positions [s]; default 0.
   */
  vtkSetMacro(StartTime, double);
  vtkGetMacro(StartTime, double);
  ///@}

  ///@{
  /**
   * Time step of the integration [s], positive; default 0.1. A vortex should not rotate by more than 0.1 rad per step:
   * 2 pi core^2 / circulation / 10.
   */
  vtkSetMacro(TimeStep, double);
  vtkGetMacro(TimeStep, double);
  ///@}

  ///@{
  /**
   * Impermeable bed and surface, which keep the points in the water; default on.
   */
  vtkSetMacro(KeepInWater, bool);
  vtkGetMacro(KeepInWater, bool);
  vtkBooleanMacro(KeepInWater, bool);
  ///@}

  ///@{
  /**
   * Mean sea level, the z of the surface [m]; default 0. Used only with KeepInWater.
   */
  vtkSetMacro(SeaLevel, double);
  vtkGetMacro(SeaLevel, double);
  ///@}

  ///@{
  /**
   * Water depth [m], positive, or 0 for no bed; default 0. Used only with KeepInWater.
   */
  vtkSetMacro(WaterDepth, double);
  vtkGetMacro(WaterDepth, double);
  ///@}

  enum VelocityInterpolationType
  {
    Linear = 0,
    CubicSpline = 1,
  };

  ///@{
  /**
   * Interpolation of velocities in images and rectilinear grids, a VelocityInterpolationType; default CubicSpline.
   * Linear: trilinear in a cell, whose divergence slowly concentrates the points. CubicSpline: splines through all
   * points, whose coefficients take as much memory as the array. Other data sets are always interpolated linearly.
   */
  vtkSetMacro(VelocityInterpolation, int);
  vtkGetMacro(VelocityInterpolation, int);
  void SetVelocityInterpolationToLinear() { this->SetVelocityInterpolation(Linear); }
  void SetVelocityInterpolationToCubicSpline() { this->SetVelocityInterpolation(CubicSpline); }
  ///@}

  enum CoastType
  {
    Stop = 0,
    Slide = 1,
  };

  ///@{
  /**
   * Effect of land on the points beside it in the currents of vtkOceanCurrentReader, a CoastType; default Stop: the
   * velocity falls to 0 towards points on land. Slide: only its part towards the land does, so that points go on along
   * the coast. In other data sets points always stop.
   */
  vtkSetMacro(Coast, int);
  vtkGetMacro(Coast, int);
  void SetCoastToStop() { this->SetCoast(Stop); }
  void SetCoastToSlide() { this->SetCoast(Slide); }
  ///@}

  ///@{
  /**
   * Name of the point array of velocities in data sets that are no flow primitives; default null. If empty or null, it
   * is `Velocity`, else the only array of three components.
   */
  vtkSetStringMacro(VelocityArray);
  vtkGetStringMacro(VelocityArray);
  ///@}

  ///@{
  /**
   * Addition of the point array `Current`[3], the velocity of the current at the output points [m/s]; default off.
   */
  vtkSetMacro(GenerateCurrent, bool);
  vtkGetMacro(GenerateCurrent, bool);
  vtkBooleanMacro(GenerateCurrent, bool);
  ///@}

  ///@{
  /**
   * The way that all points have gone as the field array `DriftWay`[3] [m], in place of moved points, where it is the
   * same for all and GenerateCurrent is off; default off. The points stay at `Start`. Only for
   * vtkParticleLevelOfDetailFilter, which adds it, and so spares the pass over all points of each time.
   */
  vtkSetMacro(WayAsField, bool);
  vtkGetMacro(WayAsField, bool);
  vtkBooleanMacro(WayAsField, bool);
  ///@}

  ///@{
  /**
   * First and last time of an animation, announced as TIME_RANGE [s], increasing; default 0 60. Any time can be
   * requested.
   */
  vtkSetVector2Macro(TimeRange, double);
  vtkGetVector2Macro(TimeRange, double);
  ///@}

  /// Adds a current, to port 1.
  void AddCurrentConnection(vtkAlgorithmOutput* current) { this->AddInputConnection(1, current); }

  /// Removes all connections of port 1, the currents.
  void RemoveAllCurrents() { this->RemoveAllInputConnections(1); }

protected:
  vtkCurrentDriftFilter();
  ~vtkCurrentDriftFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double StartTime;
  double TimeStep;
  bool KeepInWater;
  double SeaLevel;
  double WaterDepth;
  int VelocityInterpolation;
  int Coast;
  char* VelocityArray;
  bool GenerateCurrent;
  bool WayAsField;
  double TimeRange[2];

private:
  vtkCurrentDriftFilter(const vtkCurrentDriftFilter&) = delete;
  void operator=(const vtkCurrentDriftFilter&) = delete;

  class vtkInternals;
  std::string WhyInvalid(double time) const;
  littoral::WaterLayer GetWaterLayer() const;
  void TakeInputs(vtkInformationVector** inputVector, double time);
  void TakePoints(vtkDataObject* input);
  littoral::MarchEnd March(vtkInformationVector** inputVector, double time);
  bool WriteLeaf(vtkPointSet* input, vtkPointSet* output, std::size_t first);
  template <typename Array>
  bool WriteLeafAs(vtkPointSet* input, vtkPointSet* output, std::size_t first);
  bool WriteAll(vtkDataObject* input, vtkDataObject* output);
  bool WriteLeaves(vtkDataObject* input, vtkDataObject* output);

  std::unique_ptr<vtkInternals> Internals;
};

#endif
