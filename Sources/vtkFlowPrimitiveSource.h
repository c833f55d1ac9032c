// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFlowPrimitiveSource
 * @brief   generate an elementary flow of water: uniform, source, sink or vortex
 *
 * Output: a vtkPolyData with one vertex at Center and the point arrays `FlowType`, `Strength`, `Axis`[3], `CoreRadius`
 * [m] and `InfluenceRadius` [m]. Connect any number of these sources to port 1 of vtkCurrentDriftFilter, or append them
 * to one data set: their velocities are superposed.
 *
 * Flow primitives of other origin may also be limited to a box: with `InfluenceBox`[6] (minimum and maximum x, y, z
 * [m]) and `InfluenceMargin` M [m], the velocity is unchanged in the box and multiplied by (1 - d^2/M^2)^2 at the
 * distance d from it, 0 from M on. A margin of 0 means no box, and is what this source writes.
 *
 * With the distance R from the center and the core radius e, a source of discharge Q has the radial velocity Q R / (4
 * pi (R^2 + e^2)^(3/2)); a vortex of circulation G has the azimuthal velocity G / (2 pi q) (1 - exp(-q^2/e^2)) at the
 * distance q from its axis. Both are 0 at the center: velocities are finite everywhere. vtkCurrentDriftFilter adds
 * mirror images where there is a bed or a surface, so that there is no flow through them.
 *
 * A parameter out of range is reported as one error. Coulais et al., section 3.2.2 and figure 2.
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

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  enum PrimitiveType
  {
    Uniform = 0,
    Source = 1,
    Sink = 2,
    Vortex = 3,
  };

  ///@{
  /**
   * Type of flow, a PrimitiveType; default Uniform. Uniform: parallel flow along Axis. Source: radial flow away from
   * Center. Sink: radial flow towards Center, which captures particles in its core. Vortex: right-handed rotation about
   * Axis through Center.
   */
  vtkSetMacro(FlowType, int);
  vtkGetMacro(FlowType, int);
  void SetFlowTypeToUniform() { this->SetFlowType(Uniform); }
  void SetFlowTypeToSource() { this->SetFlowType(Source); }
  void SetFlowTypeToSink() { this->SetFlowType(Sink); }
  void SetFlowTypeToVortex() { this->SetFlowType(Vortex); }
  const char* GetFlowTypeAsString() const;
  ///@}

  ///@{
  /**
   * Speed of a Uniform flow [m/s], discharge of a Source or Sink [m3/s], or circulation of a Vortex [m2/s]; default
   * 0.2. A negative value reverses the flow.
   */
  vtkSetMacro(Strength, double);
  vtkGetMacro(Strength, double);
  ///@}

  ///@{
  /**
   * Center of the flow [m]; default 0 0 0. Not used by a Uniform flow without InfluenceRadius.
   */
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /**
   * Direction of a Uniform flow or axis of a Vortex, of any length but 0; default 1 0 0. Not used by a Source or Sink.
   */
  vtkSetVector3Macro(Axis, double);
  vtkGetVector3Macro(Axis, double);
  ///@}

  ///@{
  /**
   * Core radius, within which the velocity decreases to 0 and a Sink captures particles [m], positive; default 0.5. Not
   * used by a Uniform flow.
   */
  vtkSetMacro(CoreRadius, double);
  vtkGetMacro(CoreRadius, double);
  ///@}

  ///@{
  /**
   * Cutoff distance I from Center [m], positive, or 0 for none; default 0. The velocity at the distance R is multiplied
   * by (1 - R^2/I^2)^2.
   */
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
