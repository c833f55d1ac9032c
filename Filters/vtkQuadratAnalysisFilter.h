// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkQuadratAnalysisFilter
 * @brief   count points in quadrats and fit six probability laws to the counts
 *
 * Input: any vtkPointSet; only x and y are used.
 *
 * Output 0: a vtkTable with a row per law, the best (smallest AIC) first, as vtkQuadratPointSource reads it. Columns:
 * `Law` (name), `LawId`, the maximum likelihood estimates `MeanPerQuadrat`, `Trials`, `ClusterShape`, `ClusterMean`,
 * `ClusterSuccess` (NaN where a law has no such parameter) and those by the method of moments (`Moments...`),
 * `LogLikelihood`, `AIC`, `ChiSquare`, `DegreesOfFreedom`, `PValue` (Pearson's test, counts pooled to an expectation of
 * 5; NaN without a degree of freedom) and `Verdict`: `best`; `not distinguishable` within 2 of the best AIC; `worse`;
 * `does not exist` where the likelihood of the law has no maximum (a clustered law for a regular pattern, and the
 * reverse). Field data: `DispersionIndex` (variance / mean of the counts) with `DispersionPValue` (two-sided),
 * `Pattern` (random, regular or clustered, at 5 %), and the grid `Origin`, `Size`, `Quadrats`.
 *
 * Output 1: a vtkTable with a row per count, ready for a bar chart: `Points`, `Observed` number of quadrats, and a
 * column of expected numbers per law.
 *
 * A property out of range, too few points in the study area or too many in a quadrat are reported as one error. Setas
 * et al., section 2.2.1, algorithm 2 (characterization).
 *
 * @sa vtkQuadratPointSource
 */
#ifndef vtkQuadratAnalysisFilter_h
#define vtkQuadratAnalysisFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkTableAlgorithm.h"

#include <vector> // for frequencies

class vtkPointSet;

namespace littoral
{
struct QuadratGrid;
}

class LITTORALFILTERS_EXPORT vtkQuadratAnalysisFilter : public vtkTableAlgorithm
{
public:
  static vtkQuadratAnalysisFilter* New();
  vtkTypeMacro(vtkQuadratAnalysisFilter, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  ///@{
  /**
   * Lower left corner of the study area [m]; default 0 0. Used only if Size is not 0 0.
   */
  vtkSetVector2Macro(Origin, double);
  vtkGetVector2Macro(Origin, double);
  ///@}

  ///@{
  /**
   * Width and height of the study area [m], not negative; default 0 0, the bounding box of the points. Points outside
   * are left out. The bounding box is a little smaller than the area in which the points were mapped.
   */
  vtkSetVector2Macro(Size, double);
  vtkGetVector2Macro(Size, double);
  ///@}

  ///@{
  /**
   * Number of quadrats along x and y, not negative; default 0 0, about as many nearly square quadrats as points.
   */
  vtkSetVector2Macro(Quadrats, int);
  vtkGetVector2Macro(Quadrats, int);
  ///@}

protected:
  vtkQuadratAnalysisFilter();
  ~vtkQuadratAnalysisFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double Origin[2];
  double Size[2];
  int Quadrats[2];

private:
  vtkQuadratAnalysisFilter(const vtkQuadratAnalysisFilter&) = delete;
  void operator=(const vtkQuadratAnalysisFilter&) = delete;

  littoral::QuadratGrid MakeGrid(vtkPointSet* input);
  std::vector<long long> CountPoints(vtkPointSet* input, const littoral::QuadratGrid& grid);
};

#endif
