// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWindFieldSource
 * @brief   generate a turbulent wind over a logarithmic mean profile by spectral synthesis
 *
 * Output: vtkImageData with the point array `Velocity` [m/s] in world axes: x along the wind (downwind), y across to
 * the left, z up. The field is frozen and convected at a constant speed (Taylor's hypothesis), so that its x axis is
 * time: spacing ReferenceSpeed x TimeStep, length ReferenceSpeed x period. It is periodic along x and in time with the
 * period Dimensions[0] x TimeStep; images one period apart are identical to the bit. Times are rounded to 1/1024 of a
 * step; between steps each Fourier component along x is shifted in phase, so that spectrum and variance are the same at
 * any time. An image at a step is a copy, one between steps takes two transforms per requested line. Linear
 * interpolation between points loses variance; see the user guide for how much.
 *
 * The velocity components are statistically independent unless ShearStress is on: the mean of u'w' is 0 and not -u*^2.
 * The field is not free of divergence.
 *
 * Field data: `CoherenceError` (maximum difference of the root coherence from the model), `FrictionVelocity` [m/s],
 * `ConvectionSpeed` [m/s], `Period` [s]; and of the model `ReferenceSpeed` [m/s], `ReferenceHeight` [m],
 * `RoughnessLength` [m], `Spectrum`, `TurbulenceIntensity`, `Coherence`, `LongitudinalDecay`, `LateralDecay` and
 * `VerticalDecay`, as the properties, of a power law `ShearExponent`, and of a
 * wind that veers `Veer` [degrees/m].
 *
 * The field is computed once and kept, so that another time is a copy. Any extent can be requested. Pieces are slabs
 * across the wind. Ranks of the global controller that ask for one piece each share the work: a rank makes the planes
 * of every n-th block of 32 frequencies, sends each other rank those lines of them that are in its piece, and keeps the
 * lines of its own. So all of them must ask. A rank alone, one that asks for another extent than that of a piece,
 * and an IECEvent compute the whole field. A parameter out of range or a field larger than the memory is reported as
 * one error, on the first of such ranks.
 *
 * Setas et al., section 3.1.1, algorithm 3, eqs. 9-14, with corrections: see Documentation/errata.md.
 */
#ifndef vtkWindFieldSource_h
#define vtkWindFieldSource_h

#include "LittoralSourcesModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <array>  // for the axes of the wind
#include <memory> // for unique_ptr

namespace littoral
{
class RankTeam;
struct WindColumns;
struct WindGrid;
}

class LITTORALSOURCES_EXPORT vtkWindFieldSource : public vtkImageAlgorithm
{
public:
  static vtkWindFieldSource* New();
  vtkTypeMacro(vtkWindFieldSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  enum SpectrumType
  {
    SimiuScanlan = 0,
    IECKaimal = 1,
  };

  enum CoherenceType
  {
    Exponential = 0,
    IEC = 1,
  };

  enum IECClassType
  {
    NoClass = 0,
    APlus = 1,
    A = 2,
    B = 3,
    C = 4,
  };

  enum IECTurbulenceType
  {
    NormalTurbulence = 0,
    ExtremeTurbulence = 1,
  };

  enum IECEventType
  {
    NoEvent = 0,
    OperatingGust = 1,
    DirectionChange = 2,
    CoherentGust = 3,
  };

  enum PhasesType
  {
    Uniform = 0,
    GaussianAmplitudes = 1,
  };

  ///@{
  /**
   * Number of samples along the wind (in time), across and up; default 600 64 24. The first must be even, at least 4
   * and a product of 2, 3 and 5; the others are positive.
   */
  vtkSetVector3Macro(Dimensions, int);
  vtkGetVector3Macro(Dimensions, int);
  ///@}

  ///@{
  /**
   * Time between samples along the wind [s], positive; default 0.1.
   */
  vtkSetMacro(TimeStep, double);
  vtkGetMacro(TimeStep, double);
  ///@}

  ///@{
  /**
   * Distance between samples across the wind [m], positive; default 4.
   */
  vtkSetMacro(LateralSpacing, double);
  vtkGetMacro(LateralSpacing, double);
  ///@}

  ///@{
  /**
   * Distance between horizontal layers [m], positive; default 2.
   */
  vtkSetMacro(VerticalSpacing, double);
  vtkGetMacro(VerticalSpacing, double);
  ///@}

  ///@{
  /**
   * Height of the lowest layer above the ground [m], above RoughnessLength; default 1.
   */
  vtkSetMacro(BottomHeight, double);
  vtkGetMacro(BottomHeight, double);
  ///@}

  ///@{
  /**
   * Center of the box in the horizontal plane, the pivot of WindDirection [m]; default 0 0.
   */
  vtkSetVector2Macro(Center, double);
  vtkGetVector2Macro(Center, double);
  ///@}

  ///@{
  /**
   * Mean wind speed at ReferenceHeight [m/s], positive, at most 1000; default 10. It is also the convection speed of
   * the turbulence.
   */
  vtkSetMacro(ReferenceSpeed, double);
  vtkGetMacro(ReferenceSpeed, double);
  ///@}

  ///@{
  /**
   * Height of ReferenceSpeed above the ground [m], above RoughnessLength; default 10.
   */
  vtkSetMacro(ReferenceHeight, double);
  vtkGetMacro(ReferenceHeight, double);
  ///@}

  ///@{
  /**
   * Aerodynamic roughness length of the ground [m], positive and below 10; default 0.03. Typical values: 0.01 short
   * grass, 0.03 meadow, 0.3 bushes, 1 forest.
   */
  vtkSetMacro(RoughnessLength, double);
  vtkGetMacro(RoughnessLength, double);
  ///@}

  ///@{
  /**
   * Exponent of a power law of the mean wind, ReferenceSpeed (z / ReferenceHeight)^ShearExponent, from 0 to 1; default
   * 0, the logarithmic law. IEC 61400-1 has 0.2 on land, 0.14 at sea.
   */
  vtkSetMacro(ShearExponent, double);
  vtkGetMacro(ShearExponent, double);
  ///@}

  ///@{
  /**
   * Turn of the mean wind with height, clockwise seen from above [degrees/m], from -10 to 10; default 0. The direction
   * is WindDirection at ReferenceHeight and WindDirection - Veer (z - ReferenceHeight) at a height z (Kelly and van der
   * Laan 2023); negative: it backs. Gusts turn with the mean, so that spectra along and across it stay the same.
   */
  vtkSetMacro(Veer, double);
  vtkGetMacro(Veer, double);
  ///@}

  ///@{
  /**
   * Direction towards which the wind blows, counterclockwise from x [degrees]; default 0. With another direction the
   * image has a direction matrix.
   */
  vtkSetMacro(WindDirection, double);
  vtkGetMacro(WindDirection, double);
  ///@}

  ///@{
  /**
   * Model of the root coherence between two points, a CoherenceType; default Exponential. Exponential: decreasing with
   * frequency times distance, with the three decay coefficients below (eqs. 11, 12). IEC: the model of IEC 61400-1
   * (edition 3, annex B) for the longitudinal component, exp(-12 sqrt((f r / U)^2 + (0.12 r / L_c)^2)) with the
   * distance r, U = ReferenceSpeed, L_c = 8.1 Lambda_1 and Lambda_1 = 0.7 ReferenceHeight, at most 42 m, in which low
   * frequencies too are not fully coherent. The standard does not define the other two components, which keep their
   * decay coefficients.
   */
  vtkSetMacro(Coherence, int);
  vtkGetMacro(Coherence, int);
  void SetCoherenceToExponential() { this->SetCoherence(Exponential); }
  void SetCoherenceToIEC() { this->SetCoherence(IEC); }
  const char* GetCoherenceAsString() const;
  ///@}

  ///@{
  /**
   * Decay coefficients of the root coherence of the longitudinal velocity for lateral and vertical distances, positive;
   * default 10 10. Not used if Coherence is IEC.
   */
  vtkSetVector2Macro(LongitudinalDecay, double);
  vtkGetVector2Macro(LongitudinalDecay, double);
  ///@}

  ///@{
  /**
   * Decay coefficients of the root coherence of the lateral velocity for lateral and vertical distances, positive;
   * default 10 10.
   */
  vtkSetVector2Macro(LateralDecay, double);
  vtkGetVector2Macro(LateralDecay, double);
  ///@}

  ///@{
  /**
   * Decay coefficients of the root coherence of the vertical velocity for lateral and vertical distances, positive;
   * default 8 8.
   */
  vtkSetVector2Macro(VerticalDecay, double);
  vtkGetVector2Macro(VerticalDecay, double);
  ///@}

  ///@{
  /**
   * Model of the velocity spectra, a SpectrumType; default SimiuScanlan. SimiuScanlan: the neutral surface layer, whose
   * turbulence follows from the mean wind. IECKaimal: the Kaimal spectra of IEC 61400-1, with TurbulenceIntensity.
   */
  vtkSetMacro(Spectrum, int);
  vtkGetMacro(Spectrum, int);
  void SetSpectrumToSimiuScanlan() { this->SetSpectrum(SimiuScanlan); }
  void SetSpectrumToIECKaimal() { this->SetSpectrum(IECKaimal); }
  const char* GetSpectrumAsString() const;
  ///@}

  ///@{
  /**
   * Turbulence intensity, the longitudinal standard deviation relative to ReferenceSpeed, positive; default 0.16. Used
   * only if Spectrum is IECKaimal.
   */
  vtkSetMacro(TurbulenceIntensity, double);
  vtkGetMacro(TurbulenceIntensity, double);
  ///@}

  ///@{
  /**
   * Class of turbulence of IEC 61400-1, an IECClassType; default NoClass. Of A+, A, B and C the reference intensity is
   * 0.18, 0.16, 0.14 and 0.12, and TurbulenceIntensity follows from it, from IECTurbulence and ReferenceSpeed, the
   * speed at the hub. With NormalizeVariance each layer has that deviation. Used only if Spectrum is IECKaimal, and for
   * IECEvent.
   */
  vtkSetMacro(IECClass, int);
  vtkGetMacro(IECClass, int);
  void SetIECClassToNoClass() { this->SetIECClass(NoClass); }
  void SetIECClassToAPlus() { this->SetIECClass(APlus); }
  void SetIECClassToA() { this->SetIECClass(A); }
  void SetIECClassToB() { this->SetIECClass(B); }
  void SetIECClassToC() { this->SetIECClass(C); }
  ///@}

  ///@{
  /**
   * Model of turbulence of IEC 61400-1, edition 3, an IECTurbulenceType; default NormalTurbulence (NTM), I_ref (0.75 V
   * + 5.6). ExtremeTurbulence (ETM): 2 I_ref (0.072 (V_ave/2 + 3) (V/2 - 4) + 10). Used only with an IECClass.
   */
  vtkSetMacro(IECTurbulence, int);
  vtkGetMacro(IECTurbulence, int);
  void SetIECTurbulenceToNormalTurbulence() { this->SetIECTurbulence(NormalTurbulence); }
  void SetIECTurbulenceToExtremeTurbulence() { this->SetIECTurbulence(ExtremeTurbulence); }
  ///@}

  ///@{
  /**
   * Transient of IEC 61400-1, edition 3, an IECEventType; default NoEvent. The wind is then its mean profile
   * without turbulence, plus: OperatingGust (EOG, 10.5 s), DirectionChange (EDC, 6 s), CoherentGust (ECD, 15 m/s and a
   * change of direction in 10 s). Directions change to the left and stay until the period ends. Needs an IECClass.
   */
  vtkSetMacro(IECEvent, int);
  vtkGetMacro(IECEvent, int);
  void SetIECEventToNoEvent() { this->SetIECEvent(NoEvent); }
  void SetIECEventToOperatingGust() { this->SetIECEvent(OperatingGust); }
  void SetIECEventToDirectionChange() { this->SetIECEvent(DirectionChange); }
  void SetIECEventToCoherentGust() { this->SetIECEvent(CoherentGust); }
  ///@}

  ///@{
  /**
   * Time at which IECEvent begins at the downwind end of the box [s], a finite number; default 5. In files of
   * vtkWindFieldWriter it is the time of the plane.
   */
  vtkSetMacro(EventStart, double);
  vtkGetMacro(EventStart, double);
  ///@}

  ///@{
  /**
   * Annual mean wind speed at the hub [m/s], positive; default 10, that of the class I. Used for ExtremeTurbulence and
   * OperatingGust.
   */
  vtkSetMacro(AnnualMeanSpeed, double);
  vtkGetMacro(AnnualMeanSpeed, double);
  ///@}

  ///@{
  /**
   * Diameter of the rotor [m], positive; default 126. Used for OperatingGust and DirectionChange.
   */
  vtkSetMacro(RotorDiameter, double);
  vtkGetMacro(RotorDiameter, double);
  ///@}

  ///@{
  /**
   * Random part of the Fourier coefficients, a PhasesType; default Uniform. Uniform: random phases alone, so that each
   * realization has the energy of the spectrum. GaussianAmplitudes: random amplitudes too, a Gaussian process.
   */
  vtkSetMacro(Phases, int);
  vtkGetMacro(Phases, int);
  void SetPhasesToUniform() { this->SetPhases(Uniform); }
  void SetPhasesToGaussianAmplitudes() { this->SetPhases(GaussianAmplitudes); }
  ///@}

  ///@{
  /**
   * Scaling of each component and layer to the variance of its spectrum over all frequencies, so that the standard
   * deviation is TurbulenceIntensity times ReferenceSpeed in a field of any length; default off. The spectrum then lies
   * above the model's by what the field has no frequencies for: by 11 % in 10 minutes at 23 m/s and steps of 0.5 s.
   */
  vtkSetMacro(NormalizeVariance, bool);
  vtkGetMacro(NormalizeVariance, bool);
  vtkBooleanMacro(NormalizeVariance, bool);
  ///@}

  ///@{
  /**
   * Shear stress: the components along and up have Kaimal's co-spectrum, -14 n / (1 + 9.6 n)^2.4 of u*^2 at n = f z /
   * U, whose mean of u'w' is about -u*^2; default off, for which it is 0. The spectra and the coherence stay the same.
   * Where the spectra cannot hold it, as those of IECKaimal high above the ground, the stress is what they hold.
   */
  vtkSetMacro(ShearStress, bool);
  vtkGetMacro(ShearStress, bool);
  vtkBooleanMacro(ShearStress, bool);
  ///@}

  ///@{
  /**
   * Seed of the random numbers, any integer; default 1. The same seed gives the same wind.
   */
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
  bool ShearStress;
  int IECClass;
  int IECTurbulence;
  int IECEvent;
  double EventStart;
  double AnnualMeanSpeed;
  double RotorDiameter;
  double ShearExponent;
  double Veer;

private:
  vtkWindFieldSource(const vtkWindFieldSource&) = delete;
  void operator=(const vtkWindFieldSource&) = delete;

  class Recipe;
  class vtkInternals;
  Recipe MakeRecipe() const;
  bool IsFresh();
  static void RequireSize(const Recipe& recipe, const littoral::WindColumns& columns, bool isMade, double points);
  void FreezeShared(
    const Recipe& recipe, const littoral::WindColumns& columns, double points, littoral::RankTeam& team);
  bool Freeze(const Recipe& recipe);
  void CopyVelocities(
    const littoral::WindGrid& grid, double time, const std::array<double, 2>& turn, vtkImageData* output) const;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
