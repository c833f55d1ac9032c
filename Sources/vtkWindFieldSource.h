// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWindFieldSource
 * @brief   a turbulent wind over a logarithmic mean, by spectral synthesis
 *
 * Output: vtkImageData with the point array `Velocity` [m/s] in world axes: x along the wind (where it blows to), y
 * across to the left, z up. The field is frozen and carried along with one speed (Taylor's hypothesis), so that its x
 * axis is time: spacing ReferenceSpeed x TimeStep, length ReferenceSpeed x period. It is periodic along x and in time
 * with the period Dimensions[0] x TimeStep; the image at time t and at t plus a period are the same to the bit. Times
 * are rounded to 1/1024 of a step; between steps each wave along x is turned by its phase, so that spectrum and
 * variance are the same at any time. An image at a step is a copy, one between steps two transforms of each line that
 * is asked for. Linear probes between points lose variance; see the user guide for how much.
 *
 * The components know nothing of each other: the mean of u'w' is 0 and not -u*^2, and the field is not free of
 * divergence.
 *
 * Field data: `CoherenceError` (largest difference of root coherence from the model), `FrictionVelocity` [m/s],
 * `ConvectionSpeed` [m/s], `Period` [s].
 *
 * The field is made once and kept, so that another time is a copy. Any extent can be asked for; the whole field is made
 * for it, on each rank.
 *
 * Setas et al., section 3.1.1, algorithm 3, eqs. 9-14, with corrections: see Documentation/errata.md.
 */
#ifndef vtkWindFieldSource_h
#define vtkWindFieldSource_h

#include "LittoralSourcesModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <memory> // for unique_ptr

class LITTORALSOURCES_EXPORT vtkWindFieldSource : public vtkImageAlgorithm
{
public:
  static vtkWindFieldSource* New();
  vtkTypeMacro(vtkWindFieldSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SpectrumType
  {
    SimiuScanlan = 0,
    IecKaimal = 1,
  };

  enum CoherenceType
  {
    Exponential = 0,
    Iec = 1,
  };

  enum PhasesType
  {
    Uniform = 0,
    GaussianAmplitudes = 1,
  };

  ///@{
  /// Number of samples along the wind (in time), across and up. The first must be at least 4, even and a product of 2,
  /// 3 and 5. Default 600 64 24.
  vtkSetVector3Macro(Dimensions, int);
  vtkGetVector3Macro(Dimensions, int);
  ///@}

  ///@{
  /// Time between samples along the wind [s], positive. Default 0.1.
  vtkSetMacro(TimeStep, double);
  vtkGetMacro(TimeStep, double);
  ///@}

  ///@{
  /// Distance of samples across the wind [m], positive. Default 4.
  vtkSetMacro(LateralSpacing, double);
  vtkGetMacro(LateralSpacing, double);
  ///@}

  ///@{
  /// Distance of layers [m], positive. Default 2.
  vtkSetMacro(VerticalSpacing, double);
  vtkGetMacro(VerticalSpacing, double);
  ///@}

  ///@{
  /// Height of the lowest layer above the ground [m], above RoughnessLength. Default 1.
  vtkSetMacro(BottomHeight, double);
  vtkGetMacro(BottomHeight, double);
  ///@}

  ///@{
  /// Middle of the box in the plane [m], about which WindDirection turns it. Default 0 0.
  vtkSetVector2Macro(Center, double);
  vtkGetVector2Macro(Center, double);
  ///@}

  ///@{
  /// Mean wind at ReferenceHeight [m/s], positive, at most 1000; also the speed that turbulence is carried along with.
  /// Default 10.
  vtkSetMacro(ReferenceSpeed, double);
  vtkGetMacro(ReferenceSpeed, double);
  ///@}

  ///@{
  /// Height of ReferenceSpeed above the ground [m], above RoughnessLength. Default 10.
  vtkSetMacro(ReferenceHeight, double);
  vtkGetMacro(ReferenceHeight, double);
  ///@}

  ///@{
  /// Roughness of the ground [m], positive: 0.01 low grass, 0.03 meadows, 0.3 bushes, 1 forest. Default 0.03.
  vtkSetMacro(RoughnessLength, double);
  vtkGetMacro(RoughnessLength, double);
  ///@}

  ///@{
  /// Where the wind blows to [degrees], counterclockwise from the x axis. Other than 0, the image has a direction
  /// matrix. Default 0.
  vtkSetMacro(WindDirection, double);
  vtkGetMacro(WindDirection, double);
  ///@}

  ///@{
  /// Root coherence of two points at a frequency, a CoherenceType. Exponential falls with the product of frequency and
  /// distance, by the three decays below (eqs. 11, 12). Iec is that of IEC 61400-1 (ed. 3, annex B) for the component
  /// along the wind, exp(-12 sqrt((f r / U)^2 + (0.12 r / L_c)^2)) with the distance r, U = ReferenceSpeed,
  /// L_c = 8.1 Lambda_1 and Lambda_1 = 0.7 ReferenceHeight, at most 42 m: slow gusts, too, differ from place to place.
  /// The standard says nothing of the other two components, which keep their decays. Default Exponential.
  vtkSetMacro(Coherence, int);
  vtkGetMacro(Coherence, int);
  const char* GetCoherenceAsString() const;
  ///@}

  ///@{
  /// Decay of the coherence of the component along the wind with distance across and up, positive; without effect where
  /// Coherence is Iec. Default 10 10.
  vtkSetVector2Macro(LongitudinalDecay, double);
  vtkGetVector2Macro(LongitudinalDecay, double);
  ///@}

  ///@{
  /// The same of the component across. Default 10 10.
  vtkSetVector2Macro(LateralDecay, double);
  vtkGetVector2Macro(LateralDecay, double);
  ///@}

  ///@{
  /// The same of the component up. Default 8 8.
  vtkSetVector2Macro(VerticalDecay, double);
  vtkGetVector2Macro(VerticalDecay, double);
  ///@}

  ///@{
  /// Auto-spectra, a SpectrumType: those of the neutral surface layer, whose turbulence follows from the mean wind, or
  /// IEC 61400-1's, with TurbulenceIntensity. Default SimiuScanlan.
  vtkSetMacro(Spectrum, int);
  vtkGetMacro(Spectrum, int);
  const char* GetSpectrumAsString() const;
  ///@}

  ///@{
  /// IecKaimal: standard deviation along the wind over ReferenceSpeed, positive. Default 0.16.
  vtkSetMacro(TurbulenceIntensity, double);
  vtkGetMacro(TurbulenceIntensity, double);
  ///@}

  ///@{
  /// What is random, a PhasesType: phases alone, so that each run has the energy of the spectrum, or amplitudes too, a
  /// Gaussian process. Default Uniform.
  vtkSetMacro(Phases, int);
  vtkGetMacro(Phases, int);
  ///@}

  ///@{
  /// Scale each component and layer to exactly the variance of its spectrum. Default off.
  vtkSetMacro(NormalizeVariance, bool);
  vtkGetMacro(NormalizeVariance, bool);
  vtkBooleanMacro(NormalizeVariance, bool);
  ///@}

  ///@{
  /// Any whole number; the same seed gives the same wind. Default 1.
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

protected:
  vtkWindFieldSource();
  ~vtkWindFieldSource() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Dimensions[3];
  double TimeStep;
  double LateralSpacing;
  double VerticalSpacing;
  double BottomHeight;
  double Center[2];
  double ReferenceSpeed;
  double ReferenceHeight;
  double RoughnessLength;
  double WindDirection;
  int Coherence;
  double LongitudinalDecay[2];
  double LateralDecay[2];
  double VerticalDecay[2];
  int Spectrum;
  double TurbulenceIntensity;
  int Phases;
  bool NormalizeVariance;
  int Seed;

private:
  vtkWindFieldSource(const vtkWindFieldSource&) = delete;
  void operator=(const vtkWindFieldSource&) = delete;

  class Recipe;
  class Frozen;
  Recipe MakeRecipe() const;
  bool Freeze(const Recipe& recipe);
  std::unique_ptr<Frozen> Kept;
};

#endif
