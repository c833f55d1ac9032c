// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWindStatisticsFilter
 * @brief   compute spectra, coherence and profile of a wind field, and compare them with those of its model
 *
 * Input: the vtkImageData of a vtkWindFieldSource, not cut along x, whose model is read from the field data.
 *
 * Output 0: a vtkTable with a row per band of frequencies: `Frequency` [Hz], the one-sided spectral densities `Along`,
 * `Across` and `Up` [m2/s2/Hz] of the layer nearest to Height, mean over its lines, and `AlongModel`, `AcrossModel`,
 * `UpModel`. Output 1: the same columns for the root coherence between that layer's lines and those at the Separation
 * across and up, NaN where the lines have no gusts. Field data of both: `Height` and `Separation` on the grid [m].
 * Output 2: a vtkTable with a row per layer: `Height` [m], `Speed` [m/s], `SpeedModel` (the logarithmic profile), the
 * standard deviations `AlongDeviation`, `AcrossDeviation` and `UpDeviation` [m/s], and `AlongDeviationModel`,
 * `AcrossDeviationModel`, `UpDeviationModel`, those of the spectrum over the frequencies of the field.
 *
 * Models are averaged over the same frequencies as the measurement. Piece 0 holds the whole tables, other pieces are
 * empty. An image that is no wind field or a property out of range is reported as one error.
 *
 * Setas et al., eqs. 9-12, with corrections: see Documentation/errata.md.
 *
 * @sa vtkWindFieldSource
 */
#ifndef vtkWindStatisticsFilter_h
#define vtkWindStatisticsFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkTableAlgorithm.h"

class LITTORALFILTERS_EXPORT vtkWindStatisticsFilter : public vtkTableAlgorithm
{
public:
  static vtkWindStatisticsFilter* New();
  vtkTypeMacro(vtkWindStatisticsFilter, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  ///@{
  /**
   * Height above the ground of spectra and coherence [m], a finite number; default 10. The nearest layer is taken.
   */
  vtkSetMacro(Height, double);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /**
   * Separation of the two points of the coherence across and up [m], not negative; default 4 0. It is rounded to the
   * spacing of the grid, to one spacing at least, must not be 0 0 and must lie within the field.
   */
  vtkSetVector2Macro(Separation, double);
  vtkGetVector2Macro(Separation, double);
  ///@}

  ///@{
  /**
   * Number of frequency bands of equal ratio, 2 to 10000; default 30. Bands without a frequency of the field are left
   * out.
   */
  vtkSetMacro(NumberOfBands, int);
  vtkGetMacro(NumberOfBands, int);
  ///@}

protected:
  vtkWindStatisticsFilter();
  ~vtkWindStatisticsFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double Height;
  double Separation[2];
  int NumberOfBands;

private:
  vtkWindStatisticsFilter(const vtkWindStatisticsFilter&) = delete;
  void operator=(const vtkWindStatisticsFilter&) = delete;
};

#endif
