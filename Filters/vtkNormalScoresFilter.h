// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNormalScoresFilter
 * @brief   turn values of any distribution into normal scores, and normal scores into such values
 *
 * Input 0: a vtkImageData or vtkPointSet with a scalar point array (SetInputArrayToProcess; default the active scalars,
 * which also stand in for an absent `Elevation`).
 *
 * Input 1 (Reference), optional: a vtkImageData or vtkPointSet whose array (array 1 of SetInputArrayToProcess; default
 * likewise) tells the distribution; without one it is that of input 0. Inverse needs it.
 *
 * Output: the input with the double point array `NormalScores` as active scalars: the value of rank k among n becomes
 * the quantile (k - 1/2) / n of the standard normal distribution, equal values share the score of their mean rank, and
 * between values of the reference the map is linear. With Inverse the array, taken as scores, becomes values of the
 * reference, in an array of its name, else `Elevation`; scores beyond the outermost ones become the least and the
 * largest value. NaN in the reference is left out.
 *
 * All of both inputs is asked for. An image is cut to what is asked of it; points are in piece 0.
 *
 * A value of input 0 that is NaN (vtkConditionalTerrainFilter fills holes), or a reference without two different
 * values, is reported as one error.
 *
 * @sa vtkCovarianceFitFilter vtkTurningBandsTerrainSource
 */
#ifndef vtkNormalScoresFilter_h
#define vtkNormalScoresFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkPassInputTypeAlgorithm.h"

class vtkDataArray;
class vtkDataSet;

class LITTORALFILTERS_EXPORT vtkNormalScoresFilter : public vtkPassInputTypeAlgorithm
{
public:
  static vtkNormalScoresFilter* New();
  vtkTypeMacro(vtkNormalScoresFilter, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  ///@{
  /**
   * Way back, from scores to values of the reference; default off.
   */
  vtkSetMacro(Inverse, bool);
  vtkGetMacro(Inverse, bool);
  vtkBooleanMacro(Inverse, bool);
  ///@}

protected:
  vtkNormalScoresFilter();
  ~vtkNormalScoresFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  bool Inverse;

private:
  vtkNormalScoresFilter(const vtkNormalScoresFilter&) = delete;
  void operator=(const vtkNormalScoresFilter&) = delete;

  vtkDataArray* Values(int port, vtkInformationVector** inputs, vtkDataSet*& data);
};

#endif
