// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointProcessSource
 * @brief   scatter points in a window by a point process
 *
 * Output: vtkPolyData vertices at z = 0 with the point array `SiteId`; `ClusterId` for processes of clusters, `Species`
 * for more than one species, and `Mark` if Marks is on. The processes (Illian et al. 2008) have structure at all
 * distances, in contrast to the laws of vtkQuadratPointSource:
 *
 * - Poisson: complete spatial randomness;
 * - Thomas: clusters of Poisson size of the mean ClusterSize, normal about Poisson parents with the standard deviation
 *   ClusterScale; K(r) = pi r^2 + (1 - exp(-r^2 / 4 ClusterScale^2)) ClusterSize / Intensity;
 * - MaternCluster: the same, uniform on discs of radius ClusterScale;
 * - LogGaussianCox: Poisson points of the intensity exp(Z), with a Gaussian field Z by turning bands of the covariance
 *   Variance exp(-r / Range); g(r) = exp(Variance exp(-r / Range));
 * - MaternII: Poisson points, of which each is deleted that has an older one nearer than Distance;
 * - Strauss: density proportional to Activity^n Interaction^s for n points of which s pairs are nearer than Distance;
 * - SoftCore: density proportional to exp(-sum over pairs of (Distance / r)^(2 / Softness)), of a given number of
 * points on a torus, the bounding box and twice Distance on each side.
 *
 * All but the last two are parts of one pattern of the plane: two windows show the same points where they overlap.
 *
 * Optional inputs:
 * - Input (port 0): a vtkTable of fits of vtkPatternVerdictFilter. Its first row that is a process replaces Process and
 *   its parameters, its window replaces Origin and Size, and the intensity follows its trend, if it has one.
 * - Intensity image (port 1): vtkImageData, one layer; each point of it stands for the cell about it, outside there are
 *   no points. The array is IntensityArray. It replaces the trend of the table.
 * - Window (port 2): vtkPolyData with one polygon, which replaces Origin and Size.
 *
 * Field data: `IsExact`, 0 for a Strauss pattern of a birth-death process after a burn-in of 32 lifetimes, where
 * perfect simulation takes too long, and for a SoftCore pattern, after 20 to 200 Metropolis sweeps; else 1.
 *
 * A piece holds a part of the points; all pieces together hold the same points for any number of pieces. A parameter
 * out of range, an intensity that is negative or 0 everywhere, and more points than fit into memory are reported as one
 * error.
 *
 * @sa vtkQuadratPointSource vtkPatternVerdictFilter
 */
#ifndef vtkPointProcessSource_h
#define vtkPointProcessSource_h

#include "LittoralSourcesModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for what is wrong with a property

class LITTORALSOURCES_EXPORT vtkPointProcessSource : public vtkPolyDataAlgorithm
{
public:
  static vtkPointProcessSource* New();
  vtkTypeMacro(vtkPointProcessSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  enum ProcessType
  {
    Poisson = 0,
    Thomas = 1,
    MaternCluster = 2,
    LogGaussianCox = 3,
    MaternII = 4,
    Strauss = 5,
    SoftCore = 6,
  };

  enum IntensityScaleType
  {
    Relative = 0,
    Absolute = 1,
  };

  enum SpeciesGroupingType
  {
    ByPoint = 0,
    ByCluster = 1,
  };

  /// The image of the intensity (port 1).
  void SetIntensityImageConnection(vtkAlgorithmOutput* image) { this->SetInputConnection(1, image); }
  void RemoveIntensityImage() { this->SetInputConnection(1, nullptr); }

  ///@{
  /**
   * Point array of the intensity image; default `None`, the active scalars.
   */
  virtual void SetIntensityArray(const char* name);
  const char* GetIntensityArray() const { return this->IntensityArray.c_str(); }
  ///@}

  /// The polygon of the window (port 2).
  void SetWindowConnection(vtkAlgorithmOutput* window) { this->SetInputConnection(2, window); }
  void RemoveWindow() { this->SetInputConnection(2, nullptr); }

  ///@{
  /**
   * Lower left corner of the window [m]; default 0 0.
   */
  vtkSetVector2Macro(Origin, double);
  vtkGetVector2Macro(Origin, double);
  ///@}

  ///@{
  /**
   * Width and height of the window [m], positive; default 500 500.
   */
  vtkSetVector2Macro(Size, double);
  vtkGetVector2Macro(Size, double);
  ///@}

  ///@{
  /**
   * Point process, a ProcessType; default Thomas.
   */
  vtkSetMacro(Process, int);
  vtkGetMacro(Process, int);
  void SetProcessToPoisson() { this->SetProcess(Poisson); }
  void SetProcessToThomas() { this->SetProcess(Thomas); }
  void SetProcessToMaternCluster() { this->SetProcess(MaternCluster); }
  void SetProcessToLogGaussianCox() { this->SetProcess(LogGaussianCox); }
  void SetProcessToMaternII() { this->SetProcess(MaternII); }
  void SetProcessToStrauss() { this->SetProcess(Strauss); }
  void SetProcessToSoftCore() { this->SetProcess(SoftCore); }
  const char* GetProcessAsString() const;
  ///@}

  ///@{
  /**
   * Intensity, the mean number of points on 1 m2, positive; default 0.01. A MaternII process has less than 1 / (pi
   * Distance^2), a SoftCore process at most 2 / Distance^2. Not used by Strauss.
   */
  vtkSetMacro(Intensity, double);
  vtkGetMacro(Intensity, double);
  ///@}

  ///@{
  /**
   * Mean number of points of a cluster, positive, at most 1e4; default 8. Thomas and MaternCluster.
   */
  vtkSetMacro(ClusterSize, double);
  vtkGetMacro(ClusterSize, double);
  ///@}

  ///@{
  /**
   * Standard deviation of the points about their parent (Thomas), or radius of the disc of a cluster (MaternCluster)
   * [m], positive; default 8.
   */
  vtkSetMacro(ClusterScale, double);
  vtkGetMacro(ClusterScale, double);
  ///@}

  ///@{
  /**
   * Variance of the logarithm of the intensity of LogGaussianCox, positive, at most 10; default 1.
   */
  vtkSetMacro(Variance, double);
  vtkGetMacro(Variance, double);
  ///@}

  ///@{
  /**
   * Distance at which the correlation of the logarithm of the intensity of LogGaussianCox has fallen to 1/e [m],
   * positive; default 30.
   */
  vtkSetMacro(Range, double);
  vtkGetMacro(Range, double);
  ///@}

  ///@{
  /**
   * Distance of inhibition of MaternII and Strauss, and at which the potential of two points of SoftCore is 1 [m],
   * positive; default 4.
   */
  vtkSetMacro(Distance, double);
  vtkGetMacro(Distance, double);
  ///@}

  ///@{
  /**
   * Activity beta of a Strauss process, its intensity without interaction [1/m2], positive; default 0.02.
   */
  vtkSetMacro(Activity, double);
  vtkGetMacro(Activity, double);
  ///@}

  ///@{
  /**
   * Interaction gamma of a Strauss process, the factor of its density for each pair of points nearer than Distance, 0
   * (hard core) to 1 (Poisson); default 0.1.
   */
  vtkSetMacro(Interaction, double);
  vtkGetMacro(Interaction, double);
  ///@}

  ///@{
  /**
   * Softness kappa of SoftCore, whose pairs have the potential (Distance / r)^(2 / kappa): 0.05, almost a hard core, to
   * 0.8, an interaction of long range; default 0.4.
   */
  vtkSetMacro(Softness, double);
  vtkGetMacro(Softness, double);
  ///@}

  ///@{
  /**
   * Scale of the intensity image, an IntensityScaleType; default Relative. Relative: values are proportional to the
   * intensity, whose mean over the image is Intensity (Activity). Absolute: values are points on 1 m2.
   */
  vtkSetMacro(IntensityScale, int);
  vtkGetMacro(IntensityScale, int);
  void SetIntensityScaleToRelative() { this->SetIntensityScale(Relative); }
  void SetIntensityScaleToAbsolute() { this->SetIntensityScale(Absolute); }
  ///@}

  ///@{
  /**
   * Number of species, equally frequent, 1 to 100; default 1. The array `Species` chooses the prototype of
   * vtkPlantScatterFilter.
   */
  vtkSetMacro(NumberOfSpecies, int);
  vtkGetMacro(NumberOfSpecies, int);
  ///@}

  ///@{
  /**
   * Grouping of species, a SpeciesGroupingType; default ByPoint. ByPoint: each point has its own, so that species share
   * clusters and attract each other. ByCluster: each cluster of Thomas and MaternCluster has one, so that species are
   * apart.
   */
  vtkSetMacro(SpeciesGrouping, int);
  vtkGetMacro(SpeciesGrouping, int);
  void SetSpeciesGroupingToByPoint() { this->SetSpeciesGrouping(ByPoint); }
  void SetSpeciesGroupingToByCluster() { this->SetSpeciesGrouping(ByCluster); }
  ///@}

  ///@{
  /**
   * Interaction gamma_12 of Strauss points of different species, 0 (hard core) to 1 (none); default 1.
   */
  vtkSetMacro(CrossInteraction, double);
  vtkGetMacro(CrossInteraction, double);
  ///@}

  ///@{
  /**
   * Log-normal marks, as diameters; default off.
   */
  vtkSetMacro(Marks, bool);
  vtkGetMacro(Marks, bool);
  vtkBooleanMacro(Marks, bool);
  ///@}

  ///@{
  /**
   * Mean of the marks, positive; default 1.
   */
  vtkSetMacro(MarkMean, double);
  vtkGetMacro(MarkMean, double);
  ///@}

  ///@{
  /**
   * Coefficient of variation of the marks, 0 to 3; default 0.3.
   */
  vtkSetMacro(MarkVariation, double);
  vtkGetMacro(MarkVariation, double);
  ///@}

  ///@{
  /**
   * Correlation of the log-marks of two points of a cluster, 0 to 1; default 0.
   */
  vtkSetMacro(MarkClusterCorrelation, double);
  vtkGetMacro(MarkClusterCorrelation, double);
  ///@}

  ///@{
  /**
   * Seed of the random numbers, any integer; default 1. The same seed gives the same points.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

protected:
  vtkPointProcessSource();
  ~vtkPointProcessSource() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double Origin[2];
  double Size[2];
  int Process;
  double Intensity;
  double ClusterSize;
  double ClusterScale;
  double Variance;
  double Range;
  double Distance;
  double Activity;
  double Interaction;
  double Softness;
  std::string IntensityArray;
  int IntensityScale;
  int NumberOfSpecies;
  int SpeciesGrouping;
  double CrossInteraction;
  bool Marks;
  double MarkMean;
  double MarkVariation;
  double MarkClusterCorrelation;
  int Seed;

private:
  vtkPointProcessSource(const vtkPointProcessSource&) = delete;
  void operator=(const vtkPointProcessSource&) = delete;

  class Recipe;
  void MakeRecipe(vtkInformationVector** inputs, Recipe& recipe);
  std::string WhyInvalid(const Recipe& recipe) const;
};

#endif
