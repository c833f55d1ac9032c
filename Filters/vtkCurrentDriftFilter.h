// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCurrentDriftFilter
 * @brief   carries points along with currents
 *
 * Input 0: any vtkPointSet, or a vtkMultiBlockDataSet or vtkPartitionedDataSetCollection of them: particles where they
 * are at StartTime. Input 1, optional, repeatable: currents, which add up. A current is a data set of flow primitives,
 * as vtkFlowPrimitiveSource makes them, or any data set with a point array of velocities [m/s]: the output of an ocean
 * model, a wind, a wake; or composite data of such. Outside of a data set its current is 0; an image or rectilinear
 * grid of one layer holds for all heights. Velocities that are no numbers count as rest, as ocean models have them on
 * land.
 *
 * Output: the points at the requested time, in the precision of the input, with the point array `Captured` (1: the core
 * of a sink holds it). Connect it to vtkParticleOrbitFilter, for which these are the centers of orbits. Without
 * currents the input is passed on. Before StartTime points are where they start.
 *
 * Points are carried by the Runge-Kutta method of fourth order in steps of TimeStep, counted from StartTime, and by
 * a shorter last one. The state at a time is a function of that time alone, whatever was asked before; some states are
 * kept to begin from. Where all currents are the same everywhere, no steps are taken.
 *
 * Currents that change are asked for their own TIME_STEPS, between which they are interpolated; if they have a
 * TIME_RANGE only, for each half of a TimeStep. What was asked is kept for a while. Before their first and after their
 * last time they stay as they were then.
 *
 * Nothing flows through bed and surface, so that no point leaves the water, and points that fill it evenly go on doing
 * so in any current that is free of divergence. Of uniform flows the horizontal part is left. Sources, sinks and
 * vortices have images beyond the walls; those out of the water have no flow in it. A grid that ends within its last
 * step of a wall reaches it: its horizontal flow goes on, its vertical one falls to 0. Where a wall is within a grid,
 * the vertical velocity there is subtracted from the grid's at all heights, between two walls in proportion to the
 * height. Points that are out of the water at StartTime stay where they are. Slaves (point arrays `MasterId` and
 * `Offset`[3], see vtkParticleOrbitFilter) move with their masters.
 *
 * Coulais et al., eq. 3.
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
struct WaterLayer;
}

class LITTORALFILTERS_EXPORT vtkCurrentDriftFilter : public vtkPassInputTypeAlgorithm
{
public:
  static vtkCurrentDriftFilter* New();
  vtkTypeMacro(vtkCurrentDriftFilter, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Time at which points are where the input has them [s]. Default 0.
  vtkSetMacro(StartTime, double);
  vtkGetMacro(StartTime, double);
  ///@}

  ///@{
  /// Step of the integration [s], positive. A vortex should not turn by more than 0.1 radian in it: 2 pi core^2 /
  /// circulation / 10. Default 0.1.
  vtkSetMacro(TimeStep, double);
  vtkGetMacro(TimeStep, double);
  ///@}

  ///@{
  /// Whether nothing flows through bed and surface; else points may leave the water. Default on.
  vtkSetMacro(KeepInWater, bool);
  vtkGetMacro(KeepInWater, bool);
  vtkBooleanMacro(KeepInWater, bool);
  ///@}

  ///@{
  /// Height of the surface [m]. Of no effect without KeepInWater. Default 0.
  vtkSetMacro(SeaLevel, double);
  vtkGetMacro(SeaLevel, double);
  ///@}

  ///@{
  /// Depth of the water [m], positive; 0: there is no bed. Of no effect without KeepInWater. Default 0.
  vtkSetMacro(WaterDepth, double);
  vtkGetMacro(WaterDepth, double);
  ///@}

  enum VelocityInterpolations
  {
    Linear = 0,
    CubicSpline = 1,
  };

  ///@{
  /// How velocities come about between the points of images and rectilinear grids, a VelocityInterpolations. Linear:
  /// from the eight around a place, which drives points together slowly, as it has a divergence of its own.
  /// CubicSpline: by splines through all points, with coefficients that take the memory of the array again. Other data
  /// sets are always linear. Default CubicSpline.
  vtkSetMacro(VelocityInterpolation, int);
  vtkGetMacro(VelocityInterpolation, int);
  ///@}

  ///@{
  /// Name of the point array of velocities in data sets that are no flow primitives. Empty or null: `Velocity`, else
  /// the only array of three components. Default null.
  vtkSetStringMacro(VelocityArray);
  vtkGetStringMacro(VelocityArray);
  ///@}

  ///@{
  /// Whether to add the point array `Current`[3], the velocity of the current at the output's points [m/s]. Default
  /// off.
  vtkSetMacro(GenerateCurrent, bool);
  vtkGetMacro(GenerateCurrent, bool);
  vtkBooleanMacro(GenerateCurrent, bool);
  ///@}

  ///@{
  /// First and last time that players are told of [s], increasing. Any time can be asked for. Default 0 60.
  vtkSetVector2Macro(TimeRange, double);
  vtkGetVector2Macro(TimeRange, double);
  ///@}

  /// Disconnects all currents.
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
  char* VelocityArray;
  bool GenerateCurrent;
  double TimeRange[2];

private:
  vtkCurrentDriftFilter(const vtkCurrentDriftFilter&) = delete;
  void operator=(const vtkCurrentDriftFilter&) = delete;

  class Internals;
  std::string WhyInvalid(double time) const;
  littoral::WaterLayer GetWaterLayer() const;
  std::string TakeInputs(vtkInformationVector** inputVector);
  std::string TakePoints(vtkDataObject* input);
  bool Advance();
  bool WriteLeaf(vtkPointSet* input, vtkPointSet* output, std::size_t first);
  template <typename Array>
  bool WriteLeafAs(vtkPointSet* input, vtkPointSet* output, std::size_t first);
  bool WriteAll(vtkDataObject* input, vtkDataObject* output);

  std::unique_ptr<Internals> State;
};

#endif
