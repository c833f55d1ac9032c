// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkQuadratPointSource
 * @brief   scatter points on a rectangle by the quadrat method
 *
 * Output: vtkPolyData vertices at z = 0 with the point arrays `SiteId` and `QuadratId`. The rectangle is divided into
 * quadrats; the number of points per quadrat follows one of six probability laws, and the positions within a quadrat
 * are uniform (Setas et al., section 2.2.1, algorithm 2, eqs. 6-8 with a corrected mean per quadrat, see
 * Documentation/errata.md). Counts of neighboring quadrats are independent: the law holds at the size of the quadrat.
 *
 * Optional input: a vtkTable of fits from vtkQuadratAnalysisFilter. Its first row then replaces the law and its
 * parameters, and the grid of the analysis replaces Origin, Size and Quadrats.
 *
 * A piece holds the points of a part of the quadrats; all pieces together hold the same points for any number of
 * pieces. A parameter out of range, a table without a row or more points than fit into memory are reported as one
 * error.
 *
 * @sa vtkQuadratAnalysisFilter
 */
#ifndef vtkQuadratPointSource_h
#define vtkQuadratPointSource_h

#include "LittoralSourcesModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for what is wrong with a property

class vtkTable;

class LITTORALSOURCES_EXPORT vtkQuadratPointSource : public vtkPolyDataAlgorithm
{
public:
  static vtkQuadratPointSource* New();
  vtkTypeMacro(vtkQuadratPointSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  enum LawType
  {
    Poisson = 0,
    Binomial = 1,
    NegativeBinomial = 2,
    PoissonPoisson = 3,
    PoissonBinomial = 4,
    PoissonNegativeBinomial = 5,
  };

  enum ModeType
  {
    Quota = 0,
    Sampling = 1,
  };

  ///@{
  /**
   * Lower left corner of the rectangle [m]; default 0 0.
   */
  vtkSetVector2Macro(Origin, double);
  vtkGetVector2Macro(Origin, double);
  ///@}

  ///@{
  /**
   * Width and height of the rectangle [m], positive; default 1000 1000.
   */
  vtkSetVector2Macro(Size, double);
  vtkGetVector2Macro(Size, double);
  ///@}

  ///@{
  /**
   * Number of quadrats along x and y, positive; default 20 20. A suitable total is about the number of points.
   */
  vtkSetVector2Macro(Quadrats, int);
  vtkGetVector2Macro(Quadrats, int);
  ///@}

  ///@{
  /**
   * Probability law of the counts, a LawType; default Poisson. Poisson is a random pattern, Binomial a regular one, and
   * the other four are clustered.
   */
  vtkSetMacro(Law, int);
  vtkGetMacro(Law, int);
  void SetLawToPoisson() { this->SetLaw(Poisson); }
  void SetLawToBinomial() { this->SetLaw(Binomial); }
  void SetLawToNegativeBinomial() { this->SetLaw(NegativeBinomial); }
  void SetLawToPoissonPoisson() { this->SetLaw(PoissonPoisson); }
  void SetLawToPoissonBinomial() { this->SetLaw(PoissonBinomial); }
  void SetLawToPoissonNegativeBinomial() { this->SetLaw(PoissonNegativeBinomial); }
  const char* GetLawAsString() const;
  ///@}

  ///@{
  /**
   * Mean number of points per quadrat (N / Q), positive, at most 1e5; default 1.
   */
  vtkSetMacro(MeanPerQuadrat, double);
  vtkGetMacro(MeanPerQuadrat, double);
  ///@}

  ///@{
  /**
   * Number of trials, positive; default 3. Binomial: trials per quadrat, hence the maximum count, not below
   * MeanPerQuadrat. PoissonBinomial: trials per cluster, hence the maximum cluster size. Not used by other laws.
   */
  vtkSetMacro(Trials, int);
  vtkGetMacro(Trials, int);
  ///@}

  ///@{
  /**
   * Aggregation index k of NegativeBinomial, or of the cluster sizes of PoissonNegativeBinomial, positive; default 0.5.
   * A smaller index means stronger clustering. Not used by other laws.
   */
  vtkSetMacro(ClusterShape, double);
  vtkGetMacro(ClusterShape, double);
  ///@}

  ///@{
  /**
   * Mean number of points per cluster of PoissonPoisson (Neyman type A) and PoissonNegativeBinomial, positive; default
   * 4. Not used by other laws.
   */
  vtkSetMacro(ClusterMean, double);
  vtkGetMacro(ClusterMean, double);
  ///@}

  ///@{
  /**
   * Success probability of the trials in a cluster of PoissonBinomial, above 0 and at most 1; default 0.5. Not used by
   * other laws.
   */
  vtkSetMacro(ClusterSuccess, double);
  vtkGetMacro(ClusterSuccess, double);
  ///@}

  ///@{
  /**
   * Method of assigning counts, a ModeType; default Quota. Quota: the expected frequencies of the law with an exact
   * total, as in the paper. Sampling: an independent random count per quadrat.
   */
  vtkSetMacro(Mode, int);
  vtkGetMacro(Mode, int);
  void SetModeToQuota() { this->SetMode(Quota); }
  void SetModeToSampling() { this->SetMode(Sampling); }
  ///@}

  ///@{
  /**
   * Seed of the random numbers, any integer; default 1. The same seed gives the same points.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

protected:
  vtkQuadratPointSource();
  ~vtkQuadratPointSource() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double Origin[2];
  double Size[2];
  int Quadrats[2];
  int Law;
  double MeanPerQuadrat;
  int Trials;
  double ClusterShape;
  double ClusterMean;
  double ClusterSuccess;
  int Mode;
  int Seed;

private:
  vtkQuadratPointSource(const vtkQuadratPointSource&) = delete;
  void operator=(const vtkQuadratPointSource&) = delete;

  class Recipe;
  void MakeRecipe(vtkInformationVector* fits, Recipe& recipe);
  std::string WhyInvalid(const Recipe& recipe) const;
};

#endif
