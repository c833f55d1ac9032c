// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSeaStateSource
 * @brief   a sea as a table of wave trains
 *
 * Output: a vtkTable, a row a train, largest amplitude first. Columns: `Amplitude` [m], `AngularFrequency` [rad/s],
 * `WaveNumber` [rad/m], `Direction` towards which it travels, from x towards y [rad], `Phase` [rad]. Field data:
 * `WaterDepth` [m] (infinite: deep), `SeaLevel` [m], `Period` after which the sea returns [s] (infinite without
 * EqualSpacing; that of a Regular wave); of the trains `SignificantWaveHeight` [m], four times the standard deviation
 * of the elevation; of the spectrum `PeakPeriod` [s], and `EnergyLeftOut`, the part of its energy that FrequencyRange
 * leaves out, with a warning where it is above 0.02.
 *
 * The spectrum is cut into bins. A train has the energy of its bin, to 1e-12 of it, so that the energy of the sea does
 * not depend on the number of trains. With the default FrequencyRange, 99.5 % of the energy of a Pierson-Moskowitz sea
 * is in the trains.
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
    Regular = 4,
  };

  enum SeaByType
  {
    Wind = 0,
    HeightAndPeriod = 1,
  };

  ///@{
  /**
   * A SpectrumType. PiersonMoskowitz: a fully developed sea on deep water. JONSWAP: a young sea, with a higher peak.
   * TMA: the same where the bed is felt. Table: from the input. Regular: one wave of PeakPeriod along MeanDirection,
   * SignificantWaveHeight high from trough to crest, with a crest at the origin at time 0; NumberOfTrains,
   * FrequencyRange, Spreading, EqualSpacing and Seed have no effect on it. Default PiersonMoskowitz.
   */
  vtkSetMacro(Spectrum, int);
  vtkGetMacro(Spectrum, int);
  ///@}

  ///@{
  /**
   * What tells how high the sea is, a SeaByType: WindSpeed, or SignificantWaveHeight and PeakPeriod. JONSWAP
   * and Regular take height and period of the fully developed sea of the wind, TMA the deep sea of JONSWAP less what
   * the depth takes. Of no effect with a Table. Default Wind.
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
  /// Four times the standard deviation of the elevation [m], positive. Of a Regular sea the height of its wave from
  /// trough to crest, which is sqrt(8) standard deviations, so that the field data have 1.414 times as much. Of no
  /// effect unless SeaBy is HeightAndPeriod, and with a Table. Default 2.
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
  /**
   * Lowest and highest angular frequency [peak frequencies], increasing, not negative, at most 1000. 0 0 stands for the
   * range of the spectrum: all of a Table; else 0.5 to 4, and on by halves until at most 1 % of the energy lies above,
   * which TMA needs in shallow water. Default 0 0.
   */
  vtkSetVector2Macro(FrequencyRange, double);
  vtkGetVector2Macro(FrequencyRange, double);
  ///@}

  ///@{
  /// Towards which the waves travel by their energy, from x towards y [degrees]; trains meet it. Default 0.
  vtkSetMacro(MeanDirection, double);
  vtkGetMacro(MeanDirection, double);
  ///@}

  ///@{
  /**
   * Exponent s of the spreading cos^2s(angle/2) of directions, 0 to 10000: small for a wind sea, above 50 for swell.
   * Trains meet the length of its mean vector, s / (s + 1), unless they are few or one of them has nearly all energy. 0
   * stands for no spreading: all trains along MeanDirection, with crests without an end. Default 10.
   */
  vtkSetMacro(Spreading, double);
  vtkGetMacro(Spreading, double);
  ///@}

  ///@{
  /**
   * On: frequencies are whole multiples of one, with the middle of FrequencyRange as theirs, so that the sea returns
   * after `Period` of the field data, at its default about NumberOfTrains / 3.5 peak periods. So do points whose
   * centers stay, unless vtkParticleOrbitFilter's StokesDrift or DopplerShift are on; with DopplerShift and a Current,
   * the distance returns of a point from its center, if that is carried by the Current. Off: frequencies lie at random
   * places in their bins, and the sea hardly ever returns. Default off.
   */
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
