// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRandomFieldAlgorithm
 * @brief   base class of what makes Gaussian random fields on a grid
 *
 * The covariance model of the field, its mean, and the random numbers: seven models (Setas et al., section 2.1; spectra
 * and covariances in Documentation/design/terrain.md) with optional geometric anisotropy.
 *
 * @sa vtkTurningBandsTerrainSource vtkConditionalTerrainFilter
 */
#ifndef vtkRandomFieldAlgorithm_h
#define vtkRandomFieldAlgorithm_h

#include "LittoralSourcesModule.h" // for export macro
#include "vtkImageAlgorithm.h"

namespace littoral
{
struct FieldStatistics;
}

/// The method that sets a property to a value of its enumeration.
#define LITTORAL_SET_TO(property, value)                                                                               \
  void Set##property##To##value()                                                                                      \
  {                                                                                                                    \
    this->Set##property(value);                                                                                        \
  }

/// The methods that set a property to each ModelType.
#define LITTORAL_SET_TO_MODELS(property)                                                                               \
  LITTORAL_SET_TO(property, Fractal)                                                                                   \
  LITTORAL_SET_TO(property, SimpleExponential)                                                                         \
  LITTORAL_SET_TO(property, DoubleExponential)                                                                         \
  LITTORAL_SET_TO(property, Bessel1)                                                                                   \
  LITTORAL_SET_TO(property, Bessel2)                                                                                   \
  LITTORAL_SET_TO(property, Telis)                                                                                     \
  LITTORAL_SET_TO(property, Spherical)

class LITTORALSOURCES_EXPORT vtkRandomFieldAlgorithm : public vtkImageAlgorithm
{
public:
  vtkTypeMacro(vtkRandomFieldAlgorithm, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  enum ModelType
  {
    Fractal = 0,
    SimpleExponential = 1,
    DoubleExponential = 2,
    Bessel1 = 3,
    Bessel2 = 4,
    Telis = 5,
    Spherical = 6,
  };

  ///@{
  /**
   * Covariance model, a ModelType; default Fractal, that of vtkConditionalTerrainFilter FittedToData.
   */
  vtkSetMacro(Model, int);
  vtkGetMacro(Model, int);
  virtual const char* GetModelAsString() const;
  LITTORAL_SET_TO_MODELS(Model);
  ///@}

  ///@{
  /**
   * Standard deviation of the field [unit of the values, m for a terrain], 0, or from 1e-15 to 3e7; default 40.
   * vtkConditionalTerrainFilter: not 0, and not used with NormalScores, where it is 1.
   */
  vtkSetMacro(StandardDeviation, double);
  vtkGetMacro(StandardDeviation, double);
  ///@}

  ///@{
  /**
   * Mean of the field [unit of the values, m for a terrain], at the center of the extent; default 200.
   * vtkConditionalTerrainFilter: used only if KrigingType is Simple, without NormalScores.
   */
  vtkSetMacro(Mean, double);
  vtkGetMacro(Mean, double);
  ///@}

  ///@{
  /**
   * Range parameter of the covariance model [m], positive; default 1000. It is 1/b of the exponential and Bessel
   * models, one of the two scales of Telis, the distance beyond which Spherical has no correlation, or the longest
   * wavelength of Fractal. With anisotropy it holds along AnisotropyAngle.
   */
  vtkSetMacro(Range, double);
  vtkGetMacro(Range, double);
  ///@}

  ///@{
  /**
   * Second range parameter of the Telis model [m], positive; default 50. Not used by other models.
   */
  vtkSetMacro(SecondRange, double);
  vtkGetMacro(SecondRange, double);
  ///@}

  ///@{
  /**
   * Fractal dimension D of the surface (eq. 5), between 2 (smooth) and 3, both excluded; default 2.15. Used only by the
   * Fractal model.
   */
  vtkSetMacro(FractalDimension, double);
  vtkGetMacro(FractalDimension, double);
  ///@}

  ///@{
  /**
   * Ratio of the longest to the shortest range, at least 1; default 1.
   */
  vtkSetMacro(AnisotropyRatio, double);
  vtkGetMacro(AnisotropyRatio, double);
  ///@}

  ///@{
  /**
   * Direction of the longest range, counterclockwise from x [degrees]; default 0.
   */
  vtkSetMacro(AnisotropyAngle, double);
  vtkGetMacro(AnisotropyAngle, double);
  ///@}

  ///@{
  /**
   * Number L of lines (eq. 1), not negative; default 0, as many as the spectrum needs on the whole grid, 64 to 1024, so
   * that the gaps between lines show no streaks (Documentation/design/terrain.md). The computation time is proportional
   * to lines times points.
   */
  vtkSetMacro(NumberOfLines, int);
  vtkGetMacro(NumberOfLines, int);
  ///@}

  ///@{
  /**
   * Seed of the random numbers, any integer; default 1. The same seed gives the same field.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

protected:
  vtkRandomFieldAlgorithm();
  ~vtkRandomFieldAlgorithm() override;

  /// The statistics of the field by these properties.
  littoral::FieldStatistics OwnStatistics() const;

  int Model;
  double StandardDeviation;
  double Mean;
  double Range;
  double SecondRange;
  double FractalDimension;
  double AnisotropyRatio;
  double AnisotropyAngle;
  int NumberOfLines;
  int Seed;

private:
  vtkRandomFieldAlgorithm(const vtkRandomFieldAlgorithm&) = delete;
  void operator=(const vtkRandomFieldAlgorithm&) = delete;
};

#endif
