// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFlowArrowFilter
 * @brief   draw flow primitives as arrows and rings
 *
 * Input: a vtkPolyData of flow primitives, from vtkFlowPrimitiveSource or vtkPlantWakeFilter.
 *
 * Output: a vtkPolyData of arrows along the velocity of each primitive, and of rings with its CoreRadius and its
 * InfluenceRadius, where it has them. Point arrays: `Speed` [m/s] of an arrow, 0 of a ring, and `RGB`, from
 * blue where it is slow to amber where it is fastest. Each primitive is drawn for
 * itself, without others and without walls, out to its InfluenceRadius, else to four core radii, a uniform flow to 2 m;
 * the longest of its arrows has a third of that radius, and the others are in proportion to their speed.
 *
 * An input that holds no flow primitives is reported as one error.
 *
 * @sa vtkFlowPrimitiveSource
 */
#ifndef vtkFlowArrowFilter_h
#define vtkFlowArrowFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class LITTORALFILTERS_EXPORT vtkFlowArrowFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkFlowArrowFilter* New();
  vtkTypeMacro(vtkFlowArrowFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

protected:
  vtkFlowArrowFilter();
  ~vtkFlowArrowFilter() override;

  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFlowArrowFilter(const vtkFlowArrowFilter&) = delete;
  void operator=(const vtkFlowArrowFilter&) = delete;
};

#endif
