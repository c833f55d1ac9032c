// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPatternVerdictFilter
 * @brief   fit point processes and quadrat laws to points, and judge all by one envelope test
 *
 * Input (port 0): any vtkPointSet; only x and y are used. Optional window (port 1): vtkPolyData with one polygon, which
 * replaces Origin and Size; laws of quadrats are for rectangles and are left out then.
 *
 * Output 0: a vtkTable with a row per process and law, the best (largest p-value) first, as vtkPointProcessSource reads
 * it. Columns: `Law` (name), `Kind` (process or quadrat law), `Verdict`: `best` of those that the test does not reject,
 * `not distinguishable` for the others of them, `worse` where it rejects, which may be everywhere, `does not exist`
 * where the points admit no such process or law; `PValue` of the global envelope test of extreme rank lengths
 * (Myllymaki et al. 2017), `TrendDegree` (0: no trend), `ProcessId` and `LawId` (-1 for those of the other kind), the
 * parameters of processes `Intensity` [1/m2], `ClusterSize`, `ClusterScale` [m], `Variance`, `Range` [m], `Distance`
 * [m], `Activity` [1/m2], `Interaction` and of laws `MeanPerQuadrat`, `Trials`, `ClusterShape`, `ClusterMean`,
 * `ClusterSuccess` (NaN where there is no such parameter). Field data: `Window` (corners), `Origin`, `Size`,
 * `Quadrats`, `Level`, and `Trend`, the coefficients of 1, u, v, u^2, u v, v^2, u^3 ..., where u and v go from -1 to 1
 * over the bounding box of the window and the intensity [1/m2] is the exponential of the sum, if there is a trend.
 *
 * Output 1: a vtkTable with a row per `Distance` [m], ready for a line chart: the `Measured` function, g or L(r) - r in
 * metres, `Theoretical` (of a random pattern: 1 or 0), and of the best row `Mean`, `GlobalLow` and `GlobalHigh`, the
 * global envelope.
 *
 * Trends are fitted by composite likelihood (Waagepetersen 2007); Thomas, Matern cluster and log-Gaussian Cox processes
 * by minimum contrast, with a trend of the K or g of points weighted by 1 / intensity; Strauss by pseudo-likelihood,
 * soft core and laws by maximum likelihood. g and L have the translation correction. Fewer than five points, points
 * outside of the window, two at one place unless AllowCoincidentPoints is on, and properties out of range are reported
 * as one error. Piece 0 holds the whole tables; ranks that have the same input and properties share the simulations:
 * the first one gets a number for each step of each simulation of the others.
 *
 * @sa vtkPointProcessSource vtkQuadratAnalysisFilter
 */
#ifndef vtkPatternVerdictFilter_h
#define vtkPatternVerdictFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkTableAlgorithm.h"

namespace littoral
{
class RankTeam;
}

class LITTORALFILTERS_EXPORT vtkPatternVerdictFilter : public vtkTableAlgorithm
{
public:
  static vtkPatternVerdictFilter* New();
  vtkTypeMacro(vtkPatternVerdictFilter, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  enum FunctionType
  {
    PairCorrelation = 0,
    BesagL = 1,
  };

  enum ContrastType
  {
    FitRipley = 0,
    FitPairCorrelation = 1,
  };

  /// The polygon of the window (port 1).
  void SetWindowConnection(vtkAlgorithmOutput* window) { this->SetInputConnection(1, window); }
  void RemoveWindow() { this->SetInputConnection(1, nullptr); }

  ///@{
  /**
   * Lower left corner of the window [m]; default 0 0. Used only if Size is not 0 0.
   */
  vtkSetVector2Macro(Origin, double);
  vtkGetVector2Macro(Origin, double);
  ///@}

  ///@{
  /**
   * Width and height of the window [m], not negative; default 0 0, the bounding box of the points, which is a little
   * smaller than the area in which they were mapped.
   */
  vtkSetVector2Macro(Size, double);
  vtkGetVector2Macro(Size, double);
  ///@}

  ///@{
  /**
   * Summary function of the test, a FunctionType; default PairCorrelation. PairCorrelation: g. BesagL: L.
   */
  vtkSetMacro(Function, int);
  vtkGetMacro(Function, int);
  void SetFunctionToPairCorrelation() { this->SetFunction(PairCorrelation); }
  void SetFunctionToBesagL() { this->SetFunction(BesagL); }
  ///@}

  ///@{
  /**
   * Function to which Thomas, Matern cluster and log-Gaussian Cox processes are fitted, a ContrastType; default
   * FitRipley. FitRipley: K. FitPairCorrelation: g.
   */
  vtkSetMacro(Contrast, int);
  vtkGetMacro(Contrast, int);
  void SetContrastToFitRipley() { this->SetContrast(FitRipley); }
  void SetContrastToFitPairCorrelation() { this->SetContrast(FitPairCorrelation); }
  ///@}

  ///@{
  /**
   * Degree of the log-intensity as a polynomial of x and y, 0 to 3; default 0, homogeneous. A trend is for Poisson,
   * Thomas, Matern cluster, log-Gaussian Cox and Matern II processes; the others have none.
   */
  vtkSetMacro(TrendDegree, int);
  vtkGetMacro(TrendDegree, int);
  ///@}

  ///@{
  /**
   * Maximum distance of the test and of minimum contrast [m], not negative; default 0, a quarter of the shorter side,
   * at most that within which a thousand points are expected.
   */
  vtkSetMacro(MaximumDistance, double);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  ///@{
  /**
   * Several points at one place, as in inventories with rounded coordinates; default off, an error. Such points are of
   * no Matern II process or soft core.
   */
  vtkSetMacro(AllowCoincidentPoints, bool);
  vtkGetMacro(AllowCoincidentPoints, bool);
  vtkBooleanMacro(AllowCoincidentPoints, bool);
  ///@}

  ///@{
  /**
   * Number of simulated patterns of each process and law, at least 1 / Level - 1; default 99.
   */
  vtkSetMacro(NumberOfSimulations, int);
  vtkGetMacro(NumberOfSimulations, int);
  ///@}

  ///@{
  /**
   * Significance level of the test, above 0 and below 1; default 0.05.
   */
  vtkSetMacro(Level, double);
  vtkGetMacro(Level, double);
  ///@}

  ///@{
  /**
   * Number of quadrats of the laws along x and y, 0 to 1000; default 0 0, about as many nearly square quadrats as
   * points.
   */
  vtkSetVector2Macro(Quadrats, int);
  vtkGetVector2Macro(Quadrats, int);
  ///@}

  ///@{
  /**
   * Seed of the simulations, any integer; default 1.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

protected:
  vtkPatternVerdictFilter();
  ~vtkPatternVerdictFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double Origin[2];
  double Size[2];
  int Function;
  int Contrast;
  int TrendDegree;
  double MaximumDistance;
  bool AllowCoincidentPoints;
  int NumberOfSimulations;
  double Level;
  int Quadrats[2];
  int Seed;

private:
  vtkPatternVerdictFilter(const vtkPatternVerdictFilter&) = delete;
  void operator=(const vtkPatternVerdictFilter&) = delete;

  void Judge(vtkInformationVector** inputVector, littoral::RankTeam& team, vtkInformationVector* outputVector);
};

#endif
