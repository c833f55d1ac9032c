// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSeaStatisticsFilter
 * @brief   compute the spectrum and the directional spreading of a sea state
 *
 * Input: the vtkTable of a vtkSeaStateSource whose Spectrum is not Regular.
 *
 * Output 0: a vtkTable of the frequency spectrum: `Frequency` [Hz], `Spectrum` [m2/Hz], and `Trains` [m2/Hz], the
 * energy of each wave train over the width of its bin, as steps. Output 1: a vtkTable of directions: `Direction`
 * [degrees], from x towards y, `Spreading` [1/degree], cos^2s(angle / 2) about the mean direction, where s / (s + 1) is
 * the length of the mean direction vector of the trains (NaN where all trains have one direction), and `Trains`
 * [1/degree], the fraction of the energy in each sector over its width, as steps. Both curves of an output have the
 * same area, but for the energy that the bins leave out. Field data of both: those of the input but BinEdges and
 * SpectralDensity, and `MeanDirection` [degrees].
 *
 * Piece 0 holds the whole tables, other pieces are empty. A table that is no sea state or a property out of range is
 * reported as one error.
 *
 * @sa vtkSeaStateSource
 */
#ifndef vtkSeaStatisticsFilter_h
#define vtkSeaStatisticsFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkTableAlgorithm.h"

class LITTORALFILTERS_EXPORT vtkSeaStatisticsFilter : public vtkTableAlgorithm
{
public:
  static vtkSeaStatisticsFilter* New();
  vtkTypeMacro(vtkSeaStatisticsFilter, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  ///@{
  /**
   * Number of sectors of direction over a turn, 4 to 3600; default 24.
   */
  vtkSetMacro(NumberOfSectors, int);
  vtkGetMacro(NumberOfSectors, int);
  ///@}

protected:
  vtkSeaStatisticsFilter();
  ~vtkSeaStatisticsFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int NumberOfSectors;

private:
  vtkSeaStatisticsFilter(const vtkSeaStatisticsFilter&) = delete;
  void operator=(const vtkSeaStatisticsFilter&) = delete;
};

#endif
