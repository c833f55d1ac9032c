// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFlowPrimitiveSource
 * @brief   a flow of water around a place: uniform, source, sink or vortex
 *
 * Output: a vtkPolyData with one vertex at Center and the point arrays `FlowType`, `Strength`, `Axis`[3], `CoreRadius`
 * [m] and `InfluenceRadius` [m]. Connect any number of these sources to port 1 of vtkCurrentDriftFilter, or append
 * them to one data set: flows add up.
 *
 * Flow primitives of other origin may also be kept to a box: with `InfluenceBox`[6] (smallest and largest x, y, z [m])
 * and `InfluenceMargin` [m], the flow is whole in the box and is multiplied by (1 - d^2/M^2)^2 at the distance d from
 * it, 0 from M on. A margin of 0 is no box, and this source writes that.
 *
 * With R from the center and e the core, a source of discharge Q flows with Q R / (4 pi (R^2 + e^2)^(3/2)) away from
 * the center; a vortex of circulation G with G / (2 pi q) (1 - exp(-q^2/e^2)) around its axis at the distance q from
 * it. Both are at rest at the center: velocities are finite everywhere. vtkCurrentDriftFilter adds images of them where
 * there is a bed or a surface, through which nothing flows.
 *
 * Coulais et al., section 3.2.2 and figure 2.
 *
 * @sa vtkCurrentDriftFilter
 */
#ifndef vtkFlowPrimitiveSource_h
#define vtkFlowPrimitiveSource_h

#include "LittoralSourcesModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class LITTORALSOURCES_EXPORT vtkFlowPrimitiveSource : public vtkPolyDataAlgorithm
{
public:
  static vtkFlowPrimitiveSource* New();
  vtkTypeMacro(vtkFlowPrimitiveSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum FlowTypeValue
  {
    Uniform = 0,
    Source = 1,
    Sink = 2,
    Vortex = 3,
  };

  ///@{
  /**
   * A FlowTypeValue. Uniform: along Axis. Source: away from Center in all directions. Sink: towards it, and what comes
   * into its core is captured. Vortex: around Axis through Center, right-handed. Default Uniform.
   */
  vtkSetMacro(FlowType, int);
  vtkGetMacro(FlowType, int);
  const char* GetFlowTypeAsString() const;
  ///@}

  ///@{
  /// Uniform: speed [m/s]. Source, sink: discharge [m3/s]. Vortex: circulation [m2/s]. Negative ones flow the other
  /// way. Default 0.2.
  vtkSetMacro(Strength, double);
  vtkGetMacro(Strength, double);
  ///@}

  ///@{
  /// Center [m]. Of no effect in a uniform flow without InfluenceRadius. Default 0 0 0.
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /// Direction of a uniform flow, axis of a vortex; of any length but 0. Of no effect in a source and a sink. Default
  /// 1 0 0.
  vtkSetVector3Macro(Axis, double);
  vtkGetVector3Macro(Axis, double);
  ///@}

  ///@{
  /// Distance within which a source or a vortex dies down to rest, and a sink captures [m], positive. Of no effect in a
  /// uniform flow. Default 0.5.
  vtkSetMacro(CoreRadius, double);
  vtkGetMacro(CoreRadius, double);
  ///@}

  ///@{
  /// Distance from Center at which the flow has died out [m], positive: it is multiplied by (1 - R^2/I^2)^2. 0: it
  /// reaches everywhere. Default 0.
  vtkSetMacro(InfluenceRadius, double);
  vtkGetMacro(InfluenceRadius, double);
  ///@}

protected:
  vtkFlowPrimitiveSource();
  ~vtkFlowPrimitiveSource() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int FlowType;
  double Strength;
  double Center[3];
  double Axis[3];
  double CoreRadius;
  double InfluenceRadius;

private:
  vtkFlowPrimitiveSource(const vtkFlowPrimitiveSource&) = delete;
  void operator=(const vtkFlowPrimitiveSource&) = delete;
};

#endif
