// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainZoomFilter
 * @brief   refine a coarse terrain by valleys that continue its own
 *
 * Input: a vtkImageData of one layer, at least 3 x 3, with a scalar point array, the elevation [m]
 * (SetInputArrayToProcess; default the active scalars, which also stand in for an absent `Elevation`), not constant.
 * Each value is the mean height of the cell about its point. Missing values (NaN) stay missing.
 *
 * Each cell becomes Factor x Factor cells. Between the coarse heights the ground is smooth first; then rivers and
 * hillslopes run over it by the laws that are measured on the coarser ground, and what they take from a coarse cell is
 * given back to it, so that its valleys go on as its heights ask. Last, depressions are breached.
 *
 * Output: a vtkImageData with Factor times the points along x and y, over the same cells, and the point array
 * `Elevation` double [m]. Field data: `LargestShift` double [m], between a coarse height and the mean of its fine
 * cells, and `LargestShare`, the same over the relief of the 3 x 3 coarse cells about, at most MaximumShift.
 *
 * Sources: Keys 1981 (cubic convolution), Lindsay 2016 (breaching), Braun & Willett 2013 (stream power), Roering,
 * Kirchner & Dietrich 1999 (hillslopes).
 *
 * The whole image is requested, whatever part of the output is, since flow is not local. Threads and ranks change no
 * byte. A bad input or property is reported as one error.
 *
 * @sa vtkDrainageFilter
 */
#ifndef vtkTerrainZoomFilter_h
#define vtkTerrainZoomFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkImageAlgorithm.h"

class LITTORALFILTERS_EXPORT vtkTerrainZoomFilter : public vtkImageAlgorithm
{
public:
  static vtkTerrainZoomFilter* New();
  vtkTypeMacro(vtkTerrainZoomFilter, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  ///@{
  /**
   * Fine cells along the side of a coarse one, 2 to 16; default 3.
   */
  vtkSetMacro(Factor, int);
  vtkGetMacro(Factor, int);
  ///@}

  ///@{
  /**
   * Uplift while rivers and hillslopes run, over the mean fall across a coarse cell, 0 to 10; default 1. 0: smooth
   * ground between the coarse heights that is only breached.
   */
  vtkSetMacro(Growth, double);
  vtkGetMacro(Growth, double);
  ///@}

  ///@{
  /**
   * Greatest shift of a coarse height, over the relief of the 3 x 3 coarse cells about it, 0 to 1; default 0.5. With 0
   * means of cells are kept exactly, and water stands where they leave it no way.
   */
  vtkSetMacro(MaximumShift, double);
  vtkGetMacro(MaximumShift, double);
  ///@}

  ///@{
  /**
   * Seed of the irregular points on which the ground grows, any integer; default 1.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

protected:
  vtkTerrainZoomFilter();
  ~vtkTerrainZoomFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Factor;
  double Growth;
  double MaximumShift;
  int Seed;

private:
  vtkTerrainZoomFilter(const vtkTerrainZoomFilter&) = delete;
  void operator=(const vtkTerrainZoomFilter&) = delete;
};

#endif
