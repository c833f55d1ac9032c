// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSeaStateSource
 * @brief   a sea as a table of wave trains
 *
 * Output: a vtkTable, a row a train, largest amplitude first. Columns: `Amplitude` [m], `AngularFrequency` [rad/s],
 * `WaveNumber` [rad/m], `Direction` towards which it travels, from x towards y [rad], `Phase` [rad]. Field data:
 * `WaterDepth` [m] (infinite: deep), `SeaLevel` [m], and of the whole spectrum `SignificantWaveHeight` [m] and
 * `PeakPeriod` [s].
 *
 * The spectrum is cut into bins of equal width. A train has the exact energy of its bin, so that the energy of the sea
 * does not depend on the number of trains. With the default FrequencyRange, 99.5 % of the energy of a
 * Pierson-Moskowitz sea is in the trains.
 *
 * Optional input, for a Spectrum of Table only: a vtkTable with the columns `Frequency` [Hz], increasing, and `Density`
 * [m2/Hz], as wave buoys measure them.
 *
 * Coulais et al., section 2.2.
 *
 * @sa vtkParticleOrbitFilter
 */
#ifndef vtkSeaStateSource_h
#define vtkSeaStateSource_h

#include "LittoralSourcesModule.h" // for export macro
#include "vtkTableAlgorithm.h"

class LITTORALSOURCES_EXPORT vtkSeaStateSource : public vtkTableAlgorithm
{
public:
  static vtkSeaStateSource* New();
  vtkTypeMacro(vtkSeaStateSource, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SpectrumType
  {
    PiersonMoskowitz = 0,
    JONSWAP = 1,
    TMA = 2,
    Table = 3,
  };

  enum SeaByType
  {
    Wind = 0,
    HeightAndPeriod = 1,
  };

  ///@{
  /**
   * A SpectrumType. PiersonMoskowitz: a fully developed sea on deep water. JONSWAP: a young sea, with a higher peak.
   * TMA: the same where the bed is felt. Table: from the input. Default PiersonMoskowitz.
   */
  vtkSetMacro(Spectrum, int);
  vtkGetMacro(Spectrum, int);
  ///@}

  ///@{
  /**
   * What tells how high the sea is, a SeaByType: WindSpeed, or SignificantWaveHeight and PeakPeriod. JONSWAP takes
   * height and period of the fully developed sea of the wind, TMA the deep sea of JONSWAP less what the depth takes. Of
   * no effect with a Table. Default Wind.
   */
  vtkSetMacro(SeaBy, int);
  vtkGetMacro(SeaBy, int);
  ///@}

  ///@{
  /// Wind 19.5 m above the sea [m/s], 0.1 to 200; about 1.026 times that at 10 m. Of no effect unless SeaBy is Wind,
  /// and with a Table. Default 10.
  vtkSetMacro(WindSpeed, double);
  vtkGetMacro(WindSpeed, double);
  ///@}

  ///@{
  /// Four times the standard deviation of the elevation [m], positive. Of no effect unless SeaBy is HeightAndPeriod,
  /// and with a Table. Default 2.
  vtkSetMacro(SignificantWaveHeight, double);
  vtkGetMacro(SignificantWaveHeight, double);
  ///@}

  ///@{
  /// Period of the waves with most energy [s], 0.01 to 10000. Of no effect unless SeaBy is HeightAndPeriod, and with a
  /// Table. Default 7.
  vtkSetMacro(PeakPeriod, double);
  vtkGetMacro(PeakPeriod, double);
  ///@}

  ///@{
  /// Gamma of JONSWAP and TMA, 1 (fully developed) to 20. Of no effect in other spectra. Default 3.3.
  vtkSetMacro(PeakEnhancement, double);
  vtkGetMacro(PeakEnhancement, double);
  ///@}

  ///@{
  /// Depth of the water [m], positive; 0: deep. Sets wave numbers in all spectra, energies in TMA alone. Default 0.
  vtkSetMacro(WaterDepth, double);
  vtkGetMacro(WaterDepth, double);
  ///@}

  ///@{
  /// Height of the sea at rest [m]. Default 0.
  vtkSetMacro(SeaLevel, double);
  vtkGetMacro(SeaLevel, double);
  ///@}

  ///@{
  /// Number of bins, hence of trains, 1 to 100000; bins without energy give none. Default 30.
  vtkSetMacro(NumberOfTrains, int);
  vtkGetMacro(NumberOfTrains, int);
  ///@}

  ///@{
  /// Lowest and highest angular frequency [peak frequencies], increasing, not negative, at most 1000. Default 0.5 4.
  vtkSetVector2Macro(FrequencyRange, double);
  vtkGetVector2Macro(FrequencyRange, double);
  ///@}

  ///@{
  /// Towards which the waves travel, from x towards y [degrees]. Default 0.
  vtkSetMacro(MeanDirection, double);
  vtkGetMacro(MeanDirection, double);
  ///@}

  ///@{
  /**
   * Exponent s of the spreading cos^2s(angle/2) of directions, 0 to 10000: small for a wind sea, above 50 for swell. 0
   * stands for no spreading: all trains along MeanDirection, with crests without an end. Default 10.
   */
  vtkSetMacro(Spreading, double);
  vtkGetMacro(Spreading, double);
  ///@}

  ///@{
  /// On: frequencies at the centres of their bins, so that the sea returns after two turns of a bin's width. Off: at
  /// random places in their bins, and it hardly ever does. Default off.
  vtkSetMacro(EqualSpacing, bool);
  vtkGetMacro(EqualSpacing, bool);
  vtkBooleanMacro(EqualSpacing, bool);
  ///@}

  ///@{
  /// Any whole number; the same seed gives the same sea. Default 1.
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

protected:
  vtkSeaStateSource();
  ~vtkSeaStateSource() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Spectrum;
  int SeaBy;
  double WindSpeed;
  double SignificantWaveHeight;
  double PeakPeriod;
  double PeakEnhancement;
  double WaterDepth;
  double SeaLevel;
  int NumberOfTrains;
  double FrequencyRange[2];
  double MeanDirection;
  double Spreading;
  bool EqualSpacing;
  int Seed;

private:
  vtkSeaStateSource(const vtkSeaStateSource&) = delete;
  void operator=(const vtkSeaStateSource&) = delete;
};

#endif
