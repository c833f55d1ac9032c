// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkQuadratPointSource
 * @brief   scatters points on a rectangle by a law of counts, the quadrat method
 *
 * Output: vtkPolyData vertices at z = 0, with the point arrays `SiteId` and `QuadratId`. The rectangle is cut into
 * quadrats; each gets a number of points by one of six laws, at uniform positions (Setas et al., section 2.2.1,
 * algorithm 2, eqs. 6-8 with the mean per quadrat put right, see Documentation/errata.md). Counts of neighbouring
 * quadrats are independent: the law holds at the size of the quadrat.
 *
 * Optional input: a table of fits, as vtkQuadratAnalysisFilter writes it. Its first row then replaces the law and its
 * parameters, and the grid that was measured replaces Origin, Size and Quadrats.
 *
 * A piece holds the points of a part of the quadrats; all pieces together hold the same points for any number of them.
 *
 * @sa vtkQuadratAnalysisFilter
 */
#ifndef vtkQuadratPointSource_h
#define vtkQuadratPointSource_h

#include "LittoralSourcesModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class LITTORALSOURCES_EXPORT vtkQuadratPointSource : public vtkPolyDataAlgorithm
{
public:
  static vtkQuadratPointSource* New();
  vtkTypeMacro(vtkQuadratPointSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

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
  /// Lower left corner of the rectangle [m]. Default 0 0.
  vtkSetVector2Macro(Origin, double);
  vtkGetVector2Macro(Origin, double);
  ///@}

  ///@{
  /// Width and height of the rectangle [m], positive. Default 1000 1000.
  vtkSetVector2Macro(Size, double);
  vtkGetVector2Macro(Size, double);
  ///@}

  ///@{
  /// Number of quadrats along x and y, positive; about as many in all as there are points. Default 20 20.
  vtkSetVector2Macro(Quadrats, int);
  vtkGetVector2Macro(Quadrats, int);
  ///@}

  ///@{
  /**
   * Law of the counts, a LawType: Poisson scatters at random; Binomial more regularly than that; the other four in
   * clusters. Default Poisson.
   */
  vtkSetMacro(Law, int);
  vtkGetMacro(Law, int);
  const char* GetLawAsString() const;
  ///@}

  ///@{
  /// Mean number of points in a quadrat (N / Q), positive. Default 1.
  vtkSetMacro(MeanPerQuadrat, double);
  vtkGetMacro(MeanPerQuadrat, double);
  ///@}

  ///@{
  /**
   * Binomial: the number of places in a quadrat, hence the most points in one, not below MeanPerQuadrat.
   * PoissonBinomial: the largest size of a cluster. Positive; of no effect in other laws. Default 3.
   */
  vtkSetMacro(Trials, int);
  vtkGetMacro(Trials, int);
  ///@}

  ///@{
  /**
   * NegativeBinomial: the aggregation index k of ecology, the smaller the more clustered. PoissonNegativeBinomial: the
   * same for the sizes of clusters. Positive; of no effect in other laws. Default 0.5.
   */
  vtkSetMacro(ClusterShape, double);
  vtkGetMacro(ClusterShape, double);
  ///@}

  ///@{
  /// PoissonPoisson (Neyman type A) and PoissonNegativeBinomial: mean number of points in a cluster, positive; of no
  /// effect in other laws. Default 4.
  vtkSetMacro(ClusterMean, double);
  vtkGetMacro(ClusterMean, double);
  ///@}

  ///@{
  /// PoissonBinomial: the chance that a place of a cluster is taken, above 0 and at most 1; of no effect in other laws.
  /// Default 0.5.
  vtkSetMacro(ClusterSuccess, double);
  vtkGetMacro(ClusterSuccess, double);
  ///@}

  ///@{
  /**
   * Quota: frequencies as the law expects them and a total that is exact, the paper's way. Sampling: each quadrat draws
   * from the law, with the scatter of nature. Default Quota.
   */
  vtkSetMacro(Mode, int);
  vtkGetMacro(Mode, int);
  ///@}

  ///@{
  /// Any whole number; the same seed gives the same points. Default 1.
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
  bool MakeRecipe(vtkInformationVector* fits, Recipe& recipe);
};

#endif
