// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSeaStateSource
 * @brief   generate a sea state as a table of wave trains
 *
 * Output: a vtkTable with a row per wave train, the largest amplitude first. Columns: `Amplitude` [m],
 * `AngularFrequency` [rad/s], `WaveNumber` [rad/m], `Direction` of propagation, from x towards y [rad], `Phase` [rad].
 * Field data: `WaterDepth` [m] (infinite for deep water), `SeaLevel` [m], `Period` after which the sea repeats [s]
 * (infinite without EqualSpacing; that of a Regular wave); with Order Second `Order`, 2, and `Skewness` of the surface
 * elevation at a fixed place by its trains; of the trains `SignificantWaveHeight` [m], four times the
 * standard deviation of the surface elevation, `EnergyPeriod` (Tm-1,0), `MeanPeriod` (Tm01) and `ZeroCrossingPeriod`
 * (Tm02) [s], `MeanDirection` by energy and `DirectionalSpread`, sqrt(2 (1 - r)) with the length r of the mean vector
 * [degrees]; of the spectrum `PeakPeriod` [s], and `EnergyLeftOut`, the fraction of
 * its energy outside FrequencyRange, with a warning where it is above 0.02; and unless it is Regular `BinEdges`, the
 * frequencies [Hz] between which the bins lie, and `SpectralDensity` [m2/Hz] at the edges and at equal steps within
 * each bin.
 *
 * The spectrum is divided into bins. A train has the energy of its bin, to 1e-12 of it, so that the energy of the sea
 * does not depend on the number of trains. With the default FrequencyRange, the trains hold 99.5 % of the energy of a
 * Pierson-Moskowitz sea.
 *
 * Optional input, used only if Spectrum is Table: a vtkTable with the columns `Frequency` [Hz], increasing, and
 * `Density` [m2/Hz], as measured by wave buoys. If it has `DirectionTowards`, the mean direction of travel at the
 * frequency from x towards y, and `DirectionalSpread`, circular [degrees], as vtkWaveSpectrumReader writes them, trains
 * have these in place of MeanDirection and Spreading. Other columns are named by a warning. A parameter
 * out of range, a code for a missing density (999) or a table that is no spectrum is reported as one error.
 *
 * Piece 0 holds the whole table, other pieces are empty; filters that move points request piece 0 on each rank.
 *
 * Coulais et al., section 2.2.
 *
 * @sa vtkParticleOrbitFilter vtkWaveSpectrumReader
 */
#ifndef vtkSeaStateSource_h
#define vtkSeaStateSource_h

#include "LittoralSourcesModule.h" // for export macro
#include "vtkTableAlgorithm.h"

namespace littoral
{
struct SpectrumParameters;
struct TrainParameters;
}

class LITTORALSOURCES_EXPORT vtkSeaStateSource : public vtkTableAlgorithm
{
public:
  static vtkSeaStateSource* New();
  vtkTypeMacro(vtkSeaStateSource, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  enum SpectrumType
  {
    PiersonMoskowitz = 0,
    JONSWAP = 1,
    TMA = 2,
    Table = 3,
    Regular = 4,
    OchiHubble = 5,
  };

  enum SeaByType
  {
    Wind = 0,
    HeightAndPeriod = 1,
  };

  enum SpreadingModelType
  {
    Constant = 0,
    Mitsuyasu = 1,
    DonelanBanner = 2,
  };

  enum OrderType
  {
    First = 1,
    Second = 2,
  };

  ///@{
  /**
   * Wave spectrum, a SpectrumType; default PiersonMoskowitz. PiersonMoskowitz: a fully developed sea. JONSWAP: a
   * fetch-limited sea with a higher peak. TMA: JONSWAP with the factor of WaterDepth. Regular: one wave of
   * PeakPeriod along MeanDirection, with the height SignificantWaveHeight from trough to crest and a crest at the
   * origin at time 0; NumberOfTrains, FrequencyRange, Spreading, EqualSpacing and Seed are not used. Table: the
   * spectrum of the input. OchiHubble: a swell beside the wind sea, each with a direction of its own; a depth takes
   * nothing from it.
   */
  vtkSetMacro(Spectrum, int);
  vtkGetMacro(Spectrum, int);
  void SetSpectrumToPiersonMoskowitz() { this->SetSpectrum(PiersonMoskowitz); }
  void SetSpectrumToJONSWAP() { this->SetSpectrum(JONSWAP); }
  void SetSpectrumToTMA() { this->SetSpectrum(TMA); }
  void SetSpectrumToTable() { this->SetSpectrum(Table); }
  void SetSpectrumToRegular() { this->SetSpectrum(Regular); }
  void SetSpectrumToOchiHubble() { this->SetSpectrum(OchiHubble); }
  ///@}

  ///@{
  /**
   * Quantities that define the height of the sea, a SeaByType; default Wind. Wind: WindSpeed. HeightAndPeriod:
   * SignificantWaveHeight and PeakPeriod. JONSWAP and Regular take height and period of the fully developed sea of the
   * wind; on water of a finite WaterDepth PiersonMoskowitz and JONSWAP are reduced by the depth factor of TMA, and to
   * 0.59 depths at most. Not used if Spectrum is Table.
   */
  vtkSetMacro(SeaBy, int);
  vtkGetMacro(SeaBy, int);
  void SetSeaByToWind() { this->SetSeaBy(Wind); }
  void SetSeaByToHeightAndPeriod() { this->SetSeaBy(HeightAndPeriod); }
  ///@}

  ///@{
  /**
   * Wind speed 19.5 m above the sea [m/s], 0.1 to 200; default 10. It is about 1.026 times the wind speed at 10 m. Used
   * if SeaBy is Wind and Spectrum is not Table.
   */
  vtkSetMacro(WindSpeed, double);
  vtkGetMacro(WindSpeed, double);
  ///@}

  ///@{
  /**
   * Significant wave height, four times the standard deviation of the surface elevation [m], positive; default 2. For a
   * Regular wave it is the height from trough to crest, sqrt(8) standard deviations, so that the field data have 1.414
   * times as much. Used if SeaBy is HeightAndPeriod and Spectrum is not Table.
   */
  vtkSetMacro(SignificantWaveHeight, double);
  vtkGetMacro(SignificantWaveHeight, double);
  ///@}

  ///@{
  /**
   * Peak period, the period of the waves with the most energy [s], 0.01 to 10000; default 7. Used if SeaBy is
   * HeightAndPeriod and Spectrum is not Table.
   */
  vtkSetMacro(PeakPeriod, double);
  vtkGetMacro(PeakPeriod, double);
  ///@}

  ///@{
  /**
   * Peak enhancement factor gamma of JONSWAP and TMA, 1 (fully developed) to 20; default 3.3. Not used by other
   * spectra.
   */
  vtkSetMacro(PeakEnhancement, double);
  vtkGetMacro(PeakEnhancement, double);
  ///@}

  ///@{
  /**
   * Shape lambda of the wind sea of OchiHubble, 1 (fully developed) to 20 (narrow); default 1.5. Not used by other
   * spectra.
   */
  vtkSetMacro(WindSeaShape, double);
  vtkGetMacro(WindSeaShape, double);
  ///@}

  ///@{
  /**
   * Significant wave height of the swell of OchiHubble [m], positive; default 1. Not used by other spectra.
   */
  vtkSetMacro(SwellHeight, double);
  vtkGetMacro(SwellHeight, double);
  ///@}

  ///@{
  /**
   * Peak period of the swell of OchiHubble [s], 0.01 to 10000; default 13. Not used by other spectra.
   */
  vtkSetMacro(SwellPeriod, double);
  vtkGetMacro(SwellPeriod, double);
  ///@}

  ///@{
  /**
   * Shape lambda of the swell of OchiHubble, 1 to 20 (narrow); default 4. Not used by other spectra.
   */
  vtkSetMacro(SwellShape, double);
  vtkGetMacro(SwellShape, double);
  ///@}

  ///@{
  /**
   * Mean direction of the swell of OchiHubble, from x towards y [degrees]; default 0. Not used by other spectra.
   */
  vtkSetMacro(SwellDirection, double);
  vtkGetMacro(SwellDirection, double);
  ///@}

  ///@{
  /**
   * Exponent s of the directional spreading of the swell of OchiHubble, 0 (long-crested) to 10000; default 50. Not used
   * by other spectra.
   */
  vtkSetMacro(SwellSpreading, double);
  vtkGetMacro(SwellSpreading, double);
  ///@}

  ///@{
  /**
   * Water depth [m], at least 1e-6, or 0 for deep water; default 0. It determines the wave numbers of all spectra, and
   * the energy of TMA and of seas by Wind. Waves that would break, a SignificantWaveHeight above 0.59 depths or a
   * Regular wave above 0.78, are refused.
   */
  vtkSetMacro(WaterDepth, double);
  vtkGetMacro(WaterDepth, double);
  ///@}

  ///@{
  /**
   * Mean sea level, the z of the surface at rest [m]; default 0.
   */
  vtkSetMacro(SeaLevel, double);
  vtkGetMacro(SeaLevel, double);
  ///@}

  ///@{
  /**
   * Order in the steepness of waves to which surface, orbits and flow are summed, an OrderType; default First: trains
   * alone. Second: and the waves that each pair of trains forces, by which crests are higher and sharper, troughs
   * flatter, the mean level at a fixed place that of second order, and groups of waves travel with long waves. It takes
   * at most 200 trains, and a time that grows with their pairs.
   */
  vtkSetMacro(Order, int);
  vtkGetMacro(Order, int);
  void SetOrderToFirst() { this->SetOrder(First); }
  void SetOrderToSecond() { this->SetOrder(Second); }
  ///@}

  ///@{
  /**
   * Number of frequency bins, hence of wave trains, 1 to 100000; default 30. Bins without energy give no train.
   */
  vtkSetMacro(NumberOfTrains, int);
  vtkGetMacro(NumberOfTrains, int);
  ///@}

  ///@{
  /**
   * Minimum and maximum angular frequency relative to the peak frequency, increasing, 0 to 1000; default 0 0, the range
   * of the spectrum. That range is the whole Table; for other spectra it is 0.5 to 4, extended in steps of 0.5 until at
   * most 1 % of the energy lies above, as TMA needs in shallow water.
   */
  vtkSetVector2Macro(FrequencyRange, double);
  vtkGetVector2Macro(FrequencyRange, double);
  ///@}

  ///@{
  /**
   * Energy-weighted mean direction of propagation, from x towards y [degrees]; default 0. The trains have exactly this
   * mean.
   */
  vtkSetMacro(MeanDirection, double);
  vtkGetMacro(MeanDirection, double);
  ///@}

  ///@{
  /**
   * Exponent s of the directional spreading function cos^2s(angle / 2), 0 to 10000; default 10. It is small for a wind
   * sea and above 50 for swell; 0 means no spreading, all trains along MeanDirection and long-crested. The length of
   * the mean direction vector of the trains is s / (s + 1), unless they are few or one of them has nearly all energy.
   */
  vtkSetMacro(Spreading, double);
  vtkGetMacro(Spreading, double);
  ///@}

  ///@{
  /**
   * Directional spreading by frequency, a SpreadingModelType; default Constant: that of Spreading at all. Mitsuyasu:
   * Spreading is s at the peak frequency, and s falls with f^5 below it and with f^-2.5 above. DonelanBanner:
   * sech^2(b angle), with b from 1.2 at half the peak frequency to 2.4 near it and below 1 far above; Spreading is not
   * used. Directions of the Table, where it has them, come first.
   */
  vtkSetMacro(SpreadingModel, int);
  vtkGetMacro(SpreadingModel, int);
  void SetSpreadingModelToConstant() { this->SetSpreadingModel(Constant); }
  void SetSpreadingModelToMitsuyasu() { this->SetSpreadingModel(Mitsuyasu); }
  void SetSpreadingModelToDonelanBanner() { this->SetSpreadingModel(DonelanBanner); }
  ///@}

  ///@{
  /**
   * Frequencies at integer multiples of one fundamental, which make the sea periodic; default off. The period is
   * `Period` of the field data, with the default FrequencyRange about NumberOfTrains / 3.5 peak periods, and the center
   * of FrequencyRange is that of the frequencies. Points whose centers are fixed have the same period, unless
   * StokesDrift or DopplerShift of vtkParticleOrbitFilter are on; with DopplerShift and a Current, it is the
   * displacement of a point from its center that repeats, if the center moves with the Current. If off, frequencies are
   * random within their bins, and the sea practically never repeats.
   */
  vtkSetMacro(EqualSpacing, bool);
  vtkGetMacro(EqualSpacing, bool);
  vtkBooleanMacro(EqualSpacing, bool);
  ///@}

  ///@{
  /**
   * Seed of the random numbers, any integer; default 1. The same seed gives the same sea.
   */
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
  double WindSeaShape;
  double SwellHeight;
  double SwellPeriod;
  double SwellShape;
  double SwellDirection;
  double SwellSpreading;
  double WaterDepth;
  double SeaLevel;
  int Order;
  int NumberOfTrains;
  double FrequencyRange[2];
  double MeanDirection;
  double Spreading;
  int SpreadingModel;
  bool EqualSpacing;
  int Seed;

private:
  vtkSeaStateSource(const vtkSeaStateSource&) = delete;
  void operator=(const vtkSeaStateSource&) = delete;

  littoral::SpectrumParameters MakeSpectrum(vtkTable* measured) const;
  littoral::TrainParameters MakeTrainParameters() const;
};

#endif
