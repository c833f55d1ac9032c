// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkImageSectionFilter
 * @brief   cut an image into sections that show its inside at a glance
 *
 * Input: a vtkImageData.
 *
 * Output: a vtkPolyData of quadrilaterals between samples: the lowest layer, the last row along y as a wall behind, and
 * CrossSections layers across x, evenly spaced; of an image of one layer, that layer. The point arrays are those of the
 * input, and places are those of the image with its direction matrix.
 *
 * A piece is a part along x, or a slab along y of an input that is made in such slabs, as a wind is, and asks for that
 * part of the input; pieces share the samples between them. A property out of range is reported as one error.
 *
 * @sa vtkWindFieldSource
 */
#ifndef vtkImageSectionFilter_h
#define vtkImageSectionFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class LITTORALFILTERS_EXPORT vtkImageSectionFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkImageSectionFilter* New();
  vtkTypeMacro(vtkImageSectionFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  ///@{
  /**
   * Number of sections across x, 0 to 100; default 3.
   */
  vtkSetMacro(CrossSections, int);
  vtkGetMacro(CrossSections, int);
  ///@}

protected:
  vtkImageSectionFilter();
  ~vtkImageSectionFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int CrossSections;

private:
  vtkImageSectionFilter(const vtkImageSectionFilter&) = delete;
  void operator=(const vtkImageSectionFilter&) = delete;
};

#endif
