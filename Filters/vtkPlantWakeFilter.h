// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPlantWakeFilter
 * @brief   compute the wakes of moving seaweeds as flow primitives
 *
 * Input: moving seaweeds from vtkSeaweedDeformationFilter with GenerateMotion (High/Skeleton with `Velocity`,
 * `Acceleration`, `Radius`, `Length` and `Density`), or a vtkPartitionedDataSetCollection whose assembly has that
 * block. Output: a vtkPolyData of flow primitives, as vtkFlowPrimitiveSource writes them, with `PlantId`; a current for
 * vtkCurrentDriftFilter. Each plant has a source at its center of gravity, proportional to its tangential acceleration,
 * or a doublet, proportional to its velocity. The flow is unchanged within the bounding box of the skeleton of the
 * plant and decreases smoothly to 0 within Margin about it (`InfluenceBox`, `InfluenceMargin`).
 *
 * The plants are not moved by the wakes: there is no feedback.
 *
 * The input should not depend on a view: from a vtkPlantScatterFilter and a vtkSeaweedDeformationFilter without
 * UseLevels and UseCulling. With them the bounding boxes, and the particles in the wakes, would follow the camera.
 *
 * A property out of range or an input without these arrays is reported as one error. Coulais et al., section 4.3.4.
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

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  enum PrimitiveType
  {
    Source = 0,
    Doublet = 1,
  };

  ///@{
  /**
   * Flow primitive of a plant, a PrimitiveType; default Source. Source: by the acceleration of the plant, as in the
   * paper. Doublet: by its velocity.
   */
  vtkSetMacro(Primitive, int);
  vtkGetMacro(Primitive, int);
  void SetPrimitiveToSource() { this->SetPrimitive(Source); }
  void SetPrimitiveToDoublet() { this->SetPrimitive(Doublet); }
  ///@}

  ///@{
  /**
   * Strength of the wake, 0 to 1e6; default 0.5. Source: discharge per acceleration [m2 s]. Doublet: factor of the
   * doublet of a rigid body of the plant's volume.
   */
  vtkSetMacro(Strength, double);
  vtkGetMacro(Strength, double);
  ///@}

  ///@{
  /**
   * Distance from the bounding box of the plant at which the wake is 0 [m], 0.001 to 1000; default 0.5.
   */
  vtkSetMacro(Margin, double);
  vtkGetMacro(Margin, double);
  ///@}

  ///@{
  /**
   * Core radius of the primitives relative to half the diagonal of the bounding box, 0.001 to 1; default 0.2. The
   * radius is at least 1 cm.
   */
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
