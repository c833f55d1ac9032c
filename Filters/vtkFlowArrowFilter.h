// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFlowArrowFilter
 * @brief   draw flow primitives and currents as arrows and rings
 *
 * Input: a vtkPolyData of flow primitives, from vtkFlowPrimitiveSource or vtkPlantWakeFilter; or any vtkPointSet with
 * the point array `Velocity`[3] [m/s], as of vtkOceanCurrentReader.
 *
 * Output: a vtkPolyData of arrows along the velocity of each primitive, and of rings with its CoreRadius and its
 * InfluenceRadius, where it has them. Point arrays: `Speed` [m/s] of an arrow, 0 of a ring, and `RGB`, from
 * blue where it is slow to amber where it is fastest. Each primitive is drawn for
 * itself, without others and without walls, out to its InfluenceRadius, else to four core radii, a uniform flow to 2 m;
 * the longest of its arrows has a third of that radius, and the others are in proportion to their speed.
 *
 * In a data set with velocities the highest points nearest to the middles of square cells in plan view have arrows
 * about them, ArrowsAlong cells along the longer side; the longest arrow is as long as a cell. Land has none.
 *
 * An input that holds neither flow primitives nor velocities is reported as one error.
 *
 * @sa vtkFlowPrimitiveSource vtkOceanCurrentReader
 */
#ifndef vtkFlowArrowFilter_h
#define vtkFlowArrowFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class vtkPointSet;

class LITTORALFILTERS_EXPORT vtkFlowArrowFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkFlowArrowFilter* New();
  vtkTypeMacro(vtkFlowArrowFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  ///@{
  /**
   * Number of arrows along the longer side of a data set with velocities in plan view, from 1 to 300; default 30.
   */
  vtkSetMacro(ArrowsAlong, int);
  vtkGetMacro(ArrowsAlong, int);
  ///@}

protected:
  vtkFlowArrowFilter();
  ~vtkFlowArrowFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFlowArrowFilter(const vtkFlowArrowFilter&) = delete;
  void operator=(const vtkFlowArrowFilter&) = delete;

  int DrawSamples(vtkPointSet* data, vtkInformationVector* outputVector);

  int ArrowsAlong = 30;
};

#endif
