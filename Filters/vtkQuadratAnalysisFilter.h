// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkQuadratAnalysisFilter
 * @brief   counts points in quadrats and fits six laws to the counts
 *
 * Input: any vtkPointSet; x and y count, z does not.
 *
 * Output 0: a vtkTable, a row a law, best (smallest AIC) first, as vtkQuadratPointSource takes it. Columns: `Law`
 * (name), `LawId`, the parameters by maximum likelihood `MeanPerQuadrat`, `Trials`, `ClusterShape`, `ClusterMean`,
 * `ClusterSuccess` (NaN where a law has none) and by the method of moments (`Moments...`), `LogLikelihood`, `AIC`,
 * `ChiSquare`, `DegreesOfFreedom`, `PValue` (Pearson's test, counts pooled to an expectation of 5; NaN without a
 * degree of freedom) and `Verdict`: `best`; `not distinguishable` within 2 of the best AIC; `worse`; `does not exist`
 * where the likelihood has no maximum in this law (a clustered law for a regular pattern, and the reverse).
 * Field data: `DispersionIndex` (variance / mean of the counts) with `DispersionPValue` (two-sided), `Pattern` (random,
 * regular or clustered, at 5 %), and the grid `Origin`, `Size`, `Quadrats`.
 *
 * Output 1: a vtkTable, a row a count: `Points`, `Observed` quadrats, and the expected ones, a column a law. Ready for
 * a bar chart.
 *
 * Setas et al., section 2.2.1, algorithm 2 (characterisation).
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

  ///@{
  /// Lower left corner of the study area [m]; used if Size is given. Default 0 0.
  vtkSetVector2Macro(Origin, double);
  vtkGetVector2Macro(Origin, double);
  ///@}

  ///@{
  /**
   * Width and height of the study area [m], not negative; points outside are left out. 0 0: the bounding box of the
   * points, which is a little smaller than the area they were mapped in. Default 0 0.
   */
  vtkSetVector2Macro(Size, double);
  vtkGetVector2Macro(Size, double);
  ///@}

  ///@{
  /// Number of quadrats along x and y, not negative; 0 0: about as many as points, nearly square. Default 0 0.
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

  bool MakeGrid(vtkPointSet* input, littoral::QuadratGrid& grid);
  bool CountPoints(vtkPointSet* input, const littoral::QuadratGrid& grid, std::vector<long long>& frequencies);
};

#endif
