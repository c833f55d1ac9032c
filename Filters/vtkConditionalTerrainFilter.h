// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkConditionalTerrainFilter
 * @brief   make a field on a grid that honours data, by conditional simulation or kriging
 *
 * Input 0 (Data): a vtkPointSet whose points are data, or a vtkImageData of one layer whose points are data except
 * where the value is NaN. Values are the point array 0 of SetInputArrayToProcess (default the active scalars, which
 * also stand in for an absent `Elevation`; points without scalars: their z coordinates). ErrorArray names the standard
 * deviations of their errors. The x and y of points are places [m].
 *
 * Input 1 (Grid), optional: a vtkImageData of one layer that tells where the field is wanted. Without one it is the
 * image of the data, whose points with a value then keep it, so that its holes are filled; for points, Dimensions over
 * their bounds. DriftArray names the external drift.
 *
 * Input 2 (Fits), optional: a table of fits from vtkCovarianceFitFilter. Its first row then replaces Model,
 * StandardDeviation, Mean, Range, SecondRange, FractalDimension, Nugget, AnisotropyRatio and AnisotropyAngle, each
 * where the table has its column.
 *
 * Output 0: a vtkImageData with a double point array of the name of the values, else `Elevation`: the conditional
 * field, that is the field of vtkTurningBandsTerrainSource with the same model and Seed on the same grid, conditioned
 * by the kriged residuals at the data; or the kriging estimate itself. With KrigingVariance also the point array
 * `KrigingVariance` [unit of the values squared]. Field data: `KrigingNeighbors`.
 *
 * Output 1: a vtkTable with a row per datum: `X`, `Y` [m], `Value`, `Field` (the output's field at the datum, also off
 * the points of the grid); with CrossValidation `LeaveOneOutEstimate`, `LeaveOneOutStandardDeviation` (estimate from
 * the other data and its standard deviation, NaN where the others are too few) and `StandardizedError`. Field data:
 * `Model` (name), `ModelId`, `Variance`, `Range`, `SecondRange`, `FractalDimension`, `Nugget`; with CrossValidation
 * `MeanError`, `RootMeanSquareError` and `MeanSquaredStandardizedError`, which is near 1 if the model gives the right
 * kriging variances.
 *
 * Output 2: a vtkPolyData with a vertex per datum at (x, y, value), with the columns of output 1 but `X` and `Y` as
 * point arrays; empty where Data are an image, whose own points they are.
 *
 * Output 3: a vtkTable, the variogram of the data, that is of the residuals from their drift by least squares (with
 * NormalScores of the scores), of pairs up to half the diagonal of their bounds in up to 15 classes: `Lag` [m], the
 * mean distance of a class; `Semivariance` [unit of the values squared]; `Pairs`; `Fitted`, the semivariance of the
 * model that is used, its mean over all directions.
 *
 * Data without error are honoured; data with an error or a nugget, which is noise of all data, are filtered. Data
 * outside the grid count as those inside. Values are the same bytes for any subextent and number of threads or ranks.
 *
 * NaN among the points, two data without error at one place, a system that is singular to working precision, too few
 * data for the drift, an external drift that is missing at a datum, or a property out of range is reported as one
 * error.
 *
 * @sa vtkTurningBandsTerrainSource vtkCovarianceFitFilter vtkNormalScoresFilter
 */
#ifndef vtkConditionalTerrainFilter_h
#define vtkConditionalTerrainFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkRandomFieldAlgorithm.h"

#include <string> // for names

class vtkDataArray;
class vtkDataSet;
class vtkTable;

namespace littoral
{
struct Survey;
}

class LITTORALFILTERS_EXPORT vtkConditionalTerrainFilter : public vtkRandomFieldAlgorithm
{
public:
  static vtkConditionalTerrainFilter* New();
  vtkTypeMacro(vtkConditionalTerrainFilter, vtkRandomFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ResultType
  {
    ConditionalField = 0,
    KrigingEstimate = 1,
  };

  /// One model more than those of the base class.
  enum ModelType
  {
    FittedToData = -1,
  };

  enum KrigingKind
  {
    Simple = 0,
    Ordinary = 1,
    LinearDrift = 2,
    QuadraticDrift = 3,
    ExternalDrift = 4,
  };

  ///@{
  /**
   * Name of the point array of Data with the standard deviation of the error of each datum [unit of the values], not
   * negative; default None: data are exact.
   */
  virtual void SetErrorArray(const char* name);
  const char* GetErrorArray() const { return this->ErrorArray.c_str(); }
  ///@}

  ///@{
  /**
   * Name of the point array of the Grid that is the external drift; default ``, its active scalars. Used only if
   * KrigingType is ExternalDrift.
   */
  virtual void SetDriftArray(const char* name);
  const char* GetDriftArray() const { return this->DriftArray.c_str(); }
  ///@}

  ///@{
  /**
   * Kind of field that is made, a ResultType; default ConditionalField. ConditionalField: a field as rough as the model
   * that honours the data, another one for each Seed. KrigingEstimate: the expectation of all of these, which is smooth
   * between data.
   */
  vtkSetMacro(Result, int);
  vtkGetMacro(Result, int);
  void SetResultToConditionalField() { this->SetResult(ConditionalField); }
  void SetResultToKrigingEstimate() { this->SetResult(KrigingEstimate); }
  ///@}

  ///@{
  /**
   * Kind of kriging by the knowledge of the mean, a KrigingKind; default Ordinary. Simple: the known Mean, or that of the
   * data. Ordinary: an unknown constant. LinearDrift, QuadraticDrift: an unknown polynomial of degree 1 or 2 (universal kriging).
   * ExternalDrift: an unknown constant plus an unknown multiple of DriftArray.
   */
  vtkSetMacro(KrigingType, int);
  vtkGetMacro(KrigingType, int);
  void SetKrigingTypeToSimple() { this->SetKrigingType(Simple); }
  void SetKrigingTypeToOrdinary() { this->SetKrigingType(Ordinary); }
  void SetKrigingTypeToLinearDrift() { this->SetKrigingType(LinearDrift); }
  void SetKrigingTypeToQuadraticDrift() { this->SetKrigingType(QuadraticDrift); }
  void SetKrigingTypeToExternalDrift() { this->SetKrigingType(ExternalDrift); }
  ///@}

  ///@{
  /**
   * Use of the mean of the data in place of Mean; default on. Used only if KrigingType is Simple, without NormalScores
   * and without Fits, whose mean is taken.
   */
  vtkSetMacro(UseDataMean, bool);
  vtkGetMacro(UseDataMean, bool);
  vtkBooleanMacro(UseDataMean, bool);
  ///@}

  /**
   * Choice of the covariance model, default FittedToData: the one that fits the variogram of the data best of those
   * whose kriging system can be solved, with a nugget where the fit calls for one. That needs at least 20 data.
   */
  void SetModelToFittedToData() { this->SetModel(FittedToData); }
  const char* GetModelAsString() const override;

  ///@{
  /**
   * Variance of the noise of every datum [unit of the values squared], not negative; default 0.
   */
  vtkSetMacro(Nugget, double);
  vtkGetMacro(Nugget, double);
  ///@}

  ///@{
  /**
   * Number of points along x and y where neither a Grid nor an image of data tells them, at least 2; default 301 301.
   * They cover the bounds of the data and a twentieth of the longer side around them.
   */
  vtkSetVector2Macro(Dimensions, int);
  vtkGetVector2Macro(Dimensions, int);
  ///@}

  ///@{
  /**
   * Number of data of the moving neighbourhood, the nearest ones, not negative; default 0, all of up to 2000 data (a
   * unique neighbourhood) and 50 of more. A moving neighbourhood makes small steps where it changes.
   */
  vtkSetMacro(NumberOfNeighbors, int);
  vtkGetMacro(NumberOfNeighbors, int);
  ///@}

  ///@{
  /**
   * Normal score transform of the values and back transform of the field, for values whose distribution is not
   * Gaussian; default off. The model is then that of the scores; the field stays between the smallest and the largest
   * datum; KrigingEstimate is the median, and KrigingVariance is that of the scores. ErrorArray must be None.
   */
  vtkSetMacro(NormalScores, bool);
  vtkGetMacro(NormalScores, bool);
  vtkBooleanMacro(NormalScores, bool);
  ///@}

  ///@{
  /**
   * Addition of the point array `KrigingVariance`; default off. With all data the time is proportional to their number
   * squared times points.
   */
  vtkSetMacro(KrigingVariance, bool);
  vtkGetMacro(KrigingVariance, bool);
  vtkBooleanMacro(KrigingVariance, bool);
  ///@}

  ///@{
  /**
   * Leave-one-out cross-validation, as columns of output 1; default off.
   */
  vtkSetMacro(CrossValidation, bool);
  vtkGetMacro(CrossValidation, bool);
  vtkBooleanMacro(CrossValidation, bool);
  ///@}

protected:
  vtkConditionalTerrainFilter();
  ~vtkConditionalTerrainFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  std::string ErrorArray;
  std::string DriftArray;
  int Result;
  int KrigingType;
  bool UseDataMean;
  double Nugget;
  int Dimensions[2];
  int NumberOfNeighbors;
  bool NormalScores;
  bool KrigingVariance;
  bool CrossValidation;

private:
  vtkConditionalTerrainFilter(const vtkConditionalTerrainFilter&) = delete;
  void operator=(const vtkConditionalTerrainFilter&) = delete;

  void SetName(std::string& own, const std::string& name);
  vtkDataArray* ValueArray(vtkInformationVector** inputs, vtkDataSet* data);
  void CheckProperties();
  void ReadData(vtkInformationVector** inputs, littoral::Survey& survey);
  void ReadGrid(vtkInformationVector** inputs, littoral::Survey& survey);
  void ReadDrift(vtkInformationVector** inputs, littoral::Survey& survey);
  void FindModel(vtkInformationVector** inputs, littoral::Survey& survey);
  void CheckMemory(const littoral::Survey& survey, const int extent[6]);
  /// Runs all that can fail for want of a solution. Throws KrigingFailure and Aborted.
  void Make(const littoral::Survey& survey, vtkImageData* output, vtkTable* table);
};

#endif
