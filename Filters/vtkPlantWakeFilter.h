// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPlantWakeFilter
 * @brief   what moving seaweeds do to the water around them
 *
 * Input: seaweeds that move, as vtkSeaweedDeformationFilter makes them with GenerateMotion (High/Skeleton with
 * `Velocity`, `Acceleration`, `Radius`, `Length` and `Density`), or a vtkPartitionedDataSetCollection whose assembly
 * has that block. Output: flow primitives, as vtkFlowPrimitiveSource makes them, with `PlantId`; a current for
 * vtkCurrentDriftFilter. Each plant makes a source at its center of gravity, by its acceleration along its way, or a
 * doublet by its velocity. Either is whole within the bounding box of the plant's skeleton and ends, with no jump,
 * within Margin about it (`InfluenceBox`, `InfluenceMargin`).
 *
 * A plant is not stirred by its own wake nor by those of others: nothing leads back to it.
 *
 * Give it plants that do not depend on a view: from a vtkPlantScatterFilter and a vtkSeaweedDeformationFilter without
 * UseLevels and UseCells. With them the bounding boxes, and what drifts in the wakes, would follow the camera.
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
  /// Distance from the plant's bounding box at which the wake has ended [m], 0.001 to 1000. Default 0.5.
  vtkSetMacro(Margin, double);
  vtkGetMacro(Margin, double);
  ///@}

  ///@{
  /// Core of the primitives, as part of half the diagonal of the bounding box, 0.001 to 1; at least 1 cm. Default 0.2.
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
  double Margin;
  double CoreShare;

private:
  vtkPlantWakeFilter(const vtkPlantWakeFilter&) = delete;
  void operator=(const vtkPlantWakeFilter&) = delete;
};

#endif
