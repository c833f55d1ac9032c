// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointPatternStatisticsFilter
 * @brief   measure a point pattern at all distances and compare it with simulations of a law
 *
 * Input 0: any vtkPointSet of at least 5 points; only x and y are used. Input 1 (optional): the window in which they
 * were mapped, vtkPolyData of one polygon or closed line, or of corners in a row. Input 2 (optional): a vtkTable of
 * fits of a vtkQuadratAnalysisFilter or a vtkPatternVerdictFilter, whose first law or process is simulated instead of a
 * random pattern.
 *
 * Output 0: a vtkTable for a line chart, with a row per distance: `Distance` r [m], the chosen function under its name
 * (`K` [m2], `L` [m] as `L(r) - r`, `PairCorrelation`, `NearestNeighbor`, `EmptySpace`, `J`, `MarkCorrelation`,
 * `CrossK` [m2], `CrossPairCorrelation`), `Theoretical` (its value for a random pattern: pi r^2, 0, 1 - exp(-intensity
 * pi r^2) or 1), and of the simulations `Mean`, `Low` and `High` (pointwise at the level), `GlobalLow` and `GlobalHigh`
 * (extreme rank lengths, Myllymaeki et al. 2017). NaN where a function has no value: g, for one, at r = 0.
 *
 * Output 1: a vtkTable of one row: `Function` as in output 0, `Verdict` (`not distinguishable` from the law, or
 * `differs` where the measured curve leaves the global band, p <= Level; empty without simulations), `Pattern`
 * (`random`, `regular` or `clustered`, by the side on which it first leaves the band; empty where another law than the
 * random one or labels are tested), `PValue`, `Level`, `Simulations`, and `OutsideFrom` and `OutsideTo` [m], the
 * shortest and the longest distance out of the band, NaN without one.
 *
 * Output 2: a vtkTable of all functions by `Distance` that the input admits, without simulations; L as `L` [m].
 *
 * Field data of all: `Points`, `Intensity` [1/m2], `WindowArea` [m2].
 *
 * Simulations are as many points as the input has, uniform in the window; with a table of fits, patterns of its law or
 * process; for MarkCorrelation and cross functions random labelling, the same points with marks or species in a random
 * order.
 *
 * Fewer points, two at one place unless AllowCoincidentPoints is on, one outside the window, a window whose polygon
 * crosses itself, missing or not positive marks, unknown species or a property out of range are reported as one error.
 * Baddeley, Rubak and Turner (2015), Spatial Point Patterns, chapters 7, 8, 10 and 14. Piece 0 holds the whole tables,
 * other pieces are empty; ranks that have the same input and properties share the pairs and the simulations: the first
 * one gets a number for each step of each simulation of the others, and nine for each step of 256 points or more.
 *
 * @sa vtkQuadratAnalysisFilter, vtkPatternVerdictFilter
 */
#ifndef vtkPointPatternStatisticsFilter_h
#define vtkPointPatternStatisticsFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkTableAlgorithm.h"

#include <string> // for names

class vtkAlgorithmOutput;

namespace littoral
{
class RankTeam;
struct StatisticsOptions;
}

class LITTORALFILTERS_EXPORT vtkPointPatternStatisticsFilter : public vtkTableAlgorithm
{
public:
  static vtkPointPatternStatisticsFilter* New();
  vtkTypeMacro(vtkPointPatternStatisticsFilter, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  enum FunctionType
  {
    K = 0,
    L = 1,
    PairCorrelation = 2,
    NearestNeighbor = 3,
    EmptySpace = 4,
    J = 5,
    MarkCorrelation = 6,
    CrossK = 7,
    CrossPairCorrelation = 8,
  };

  enum EdgeCorrectionType
  {
    NoCorrection = 0,
    Border = 1,
    Isotropic = 2,
    Translation = 3,
  };

  enum DistanceCorrectionType
  {
    Uncorrected = 0,
    ReducedSample = 1,
    KaplanMeier = 2,
  };

  ///@{
  /**
   * Function of output 0: K, L, PairCorrelation, NearestNeighbor (G), EmptySpace (F), J, MarkCorrelation, CrossK or
   * CrossPairCorrelation; default L.
   */
  vtkSetMacro(Function, int);
  vtkGetMacro(Function, int);
  void SetFunctionToK() { this->SetFunction(K); }
  void SetFunctionToL() { this->SetFunction(L); }
  void SetFunctionToPairCorrelation() { this->SetFunction(PairCorrelation); }
  void SetFunctionToNearestNeighbor() { this->SetFunction(NearestNeighbor); }
  void SetFunctionToEmptySpace() { this->SetFunction(EmptySpace); }
  void SetFunctionToJ() { this->SetFunction(J); }
  void SetFunctionToMarkCorrelation() { this->SetFunction(MarkCorrelation); }
  void SetFunctionToCrossK() { this->SetFunction(CrossK); }
  void SetFunctionToCrossPairCorrelation() { this->SetFunction(CrossPairCorrelation); }
  ///@}

  ///@{
  /**
   * Lower left corner of a rectangular window [m]; default 0 0. Used only if Size is not 0 0 and no window is
   * connected.
   */
  vtkSetVector2Macro(Origin, double);
  vtkGetVector2Macro(Origin, double);
  ///@}

  ///@{
  /**
   * Width and height of a rectangular window [m], not negative; default 0 0, the bounding box of the points, which is a
   * little smaller than the window in which they were mapped.
   */
  vtkSetVector2Macro(Size, double);
  vtkGetVector2Macro(Size, double);
  ///@}

  ///@{
  /**
   * Correction of pairs for the edge of the window: NoCorrection, Border, Isotropic or Translation; default Isotropic.
   * Border is for K and L; the other functions of pairs are then corrected by Translation.
   */
  vtkSetMacro(EdgeCorrection, int);
  vtkGetMacro(EdgeCorrection, int);
  void SetEdgeCorrectionToNoCorrection() { this->SetEdgeCorrection(NoCorrection); }
  void SetEdgeCorrectionToBorder() { this->SetEdgeCorrection(Border); }
  void SetEdgeCorrectionToIsotropic() { this->SetEdgeCorrection(Isotropic); }
  void SetEdgeCorrectionToTranslation() { this->SetEdgeCorrection(Translation); }
  ///@}

  ///@{
  /**
   * Correction of nearest-neighbor, empty space and J functions: Uncorrected, ReducedSample (only places farther than r
   * from the edge) or KaplanMeier; default KaplanMeier.
   */
  vtkSetMacro(DistanceCorrection, int);
  vtkGetMacro(DistanceCorrection, int);
  void SetDistanceCorrectionToUncorrected() { this->SetDistanceCorrection(Uncorrected); }
  void SetDistanceCorrectionToReducedSample() { this->SetDistanceCorrection(ReducedSample); }
  void SetDistanceCorrectionToKaplanMeier() { this->SetDistanceCorrection(KaplanMeier); }
  ///@}

  ///@{
  /**
   * Maximum distance [m], not negative; default 0: for functions of pairs a quarter of the shorter side of the window,
   * at most the distance within which 1000 points are expected; for the others half the diagonal, at most the distance
   * at which a random pattern has F = 1 - 1e-5.
   */
  vtkSetMacro(MaximumDistance, double);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  ///@{
  /**
   * Number of steps from 0 to the maximum distance, 8 to 10000; default 256.
   */
  vtkSetMacro(NumberOfSteps, int);
  vtkGetMacro(NumberOfSteps, int);
  ///@}

  ///@{
  /**
   * Half width of the Epanechnikov kernel of pair correlations [m], not negative; default 0: 0.15 / sqrt(intensity).
   */
  vtkSetMacro(Bandwidth, double);
  vtkGetMacro(Bandwidth, double);
  ///@}

  ///@{
  /**
   * Several points at one place, as in inventories with rounded coordinates; default off, an error.
   */
  vtkSetMacro(AllowCoincidentPoints, bool);
  vtkGetMacro(AllowCoincidentPoints, bool);
  vtkBooleanMacro(AllowCoincidentPoints, bool);
  ///@}

  ///@{
  /**
   * Name of the point array of marks, as the diameter of trees, above 0; default None.
   */
  virtual void SetMarkArray(const char* name);
  const char* GetMarkArray() const { return this->MarkArray.c_str(); }
  ///@}

  ///@{
  /**
   * Name of the point array of species, texts or numbers; default None.
   */
  virtual void SetSpeciesArray(const char* name);
  const char* GetSpeciesArray() const { return this->SpeciesArray.c_str(); }
  ///@}

  ///@{
  /**
   * Species that cross functions go from; default ``, the most frequent one.
   */
  virtual void SetFirstSpecies(const char* name);
  const char* GetFirstSpecies() const { return this->FirstSpecies.c_str(); }
  ///@}

  ///@{
  /**
   * Species that cross functions go to; default ``, the most frequent one but for the first.
   */
  virtual void SetSecondSpecies(const char* name);
  const char* GetSecondSpecies() const { return this->SecondSpecies.c_str(); }
  ///@}

  ///@{
  /**
   * Number of simulations of the envelopes, 0 to 100000; default 99. 0: no envelopes. Otherwise at least 1 / Level - 1.
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
   * Seed of the simulations, any integer; default 1.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /// Connects the window, input 1, or takes it away.
  void SetWindowConnection(vtkAlgorithmOutput* window);
  void RemoveWindow() { this->RemoveAllInputConnections(1); }
  ///@}

  ///@{
  /// Connects the table of fits of the law or process, input 2, or takes it away.
  void SetLawConnection(vtkAlgorithmOutput* fits);
  void RemoveLaw() { this->RemoveAllInputConnections(2); }
  ///@}

protected:
  vtkPointPatternStatisticsFilter();
  ~vtkPointPatternStatisticsFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Function;
  double Origin[2];
  double Size[2];
  int EdgeCorrection;
  int DistanceCorrection;
  double MaximumDistance;
  int NumberOfSteps;
  double Bandwidth;
  bool AllowCoincidentPoints;
  std::string MarkArray;
  std::string SpeciesArray;
  std::string FirstSpecies;
  std::string SecondSpecies;
  int NumberOfSimulations;
  double Level;
  int Seed;

private:
  vtkPointPatternStatisticsFilter(const vtkPointPatternStatisticsFilter&) = delete;
  void operator=(const vtkPointPatternStatisticsFilter&) = delete;

  struct Pattern;

  littoral::StatisticsOptions Options() const;
  void Measure(vtkInformationVector** inputVector, littoral::RankTeam& team, vtkInformationVector* outputVector);
  void ReadPattern(vtkInformationVector** inputs, Pattern& pattern) const;
  void ReadKinds(Pattern& pattern) const;
  static void ReadLaw(Pattern& pattern);
};

#endif
