// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPlantWakeFilter
 * @brief   what moving seaweeds do to the water around them
 *
 * Input: seaweeds that move, as vtkSeaweedDeformationFilter makes them with GenerateMotion (High/Skeleton with
 * `Velocity`, `Acceleration`, `Radius`, `Length` and `Density`). Output: flow primitives, as vtkFlowPrimitiveSource
 * makes them, with `PlantId`; a current for vtkCurrentDriftFilter. Each plant makes a source at its centre of gravity,
 * by its acceleration along its way, or a doublet by its velocity; either ends, with no jump, at the sphere around its
 * bounding box.
 *
 * A plant is not stirred by its own wake nor by those of others: nothing leads back to it.
 *
 * Coulais et al., section 4.3.4.
 *
 * @sa vtkSeaweedDeformationFilter vtkCurrentDriftFilter
 */
#ifndef vtkPlantWakeFilter_h
#define vtkPlantWakeFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class LITTORALFILTERS_EXPORT vtkPlantWakeFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkPlantWakeFilter* New();
  vtkTypeMacro(vtkPlantWakeFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// 0 Source, the paper's; 1 Doublet. Default 0.
  vtkSetMacro(Primitive, int);
  vtkGetMacro(Primitive, int);
  ///@}

  ///@{
  /// Source: discharge for an acceleration [m2 s]; Doublet: part of that of a solid body of the plant's volume. 0 to
  /// 1e6. Default 0.5.
  vtkSetMacro(Strength, double);
  vtkGetMacro(Strength, double);
  ///@}

  ///@{
  /// Where the wake ends, as part of half the diagonal of the plant's bounding box, 0.001 to 1000. Default 1.
  vtkSetMacro(Reach, double);
  vtkGetMacro(Reach, double);
  ///@}

  ///@{
  /// Core of the primitives, as part of where the wake ends, 0.001 to 1. Default 0.2.
  vtkSetMacro(CoreShare, double);
  vtkGetMacro(CoreShare, double);
  ///@}

protected:
  vtkPlantWakeFilter();
  ~vtkPlantWakeFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Primitive;
  double Strength;
  double Reach;
  double CoreShare;

private:
  vtkPlantWakeFilter(const vtkPlantWakeFilter&) = delete;
  void operator=(const vtkPlantWakeFilter&) = delete;
};

#endif
