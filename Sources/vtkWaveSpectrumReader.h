// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWaveSpectrumReader
 * @brief   read a wave spectrum from a file of a buoy or a wave model
 *
 * Output: a vtkTable with a row per frequency and the columns `Frequency` [Hz] and `Density` [m2/Hz], and where the
 * file has directions `DirectionTowards`, the mean direction of travel from x (east) towards y (north) [degrees], and
 * `DirectionalSpread`, sqrt(2 (1 - r)) of the mean vector of length r [degrees]: an input of vtkSeaStateSource. Field
 * data: `SignificantWaveHeight` [m]; `PeakPeriod`, `EnergyPeriod` (Tm-1,0), `MeanPeriod` (Tm01) and
 * `ZeroCrossingPeriod` (Tm02) [s]; `MeanDirection` and `DirectionalSpread` of all energy [degrees]; `Format` and `Time`
 * as text.
 *
 * Formats, known by their content:
 * - NDBC: `.data_spec` of recent data with `.swdir` and `.swr1` beside it, or a file of a year as 46042w2023.txt with
 *   46042d2023.txt and 46042j2023.txt. Frequencies without a density (999) are left out.
 * - SWAN: spectra by frequency and direction, VaDens or EnDens, or by frequency.
 * - Sofar Spotter: JSON with frequencyData.
 * - Tables with the columns Frequency and Density, or alpha1 and r1 too; or with a row of directions [degrees] and a
 *   column of frequencies [Hz], for which DirectionConvention must be set.
 *
 * By frequency and direction, a spectrum is reduced to density, mean direction and spread at each frequency: two seas
 * of one frequency become one. Densities are linear between frequencies. What is no spectrum is reported as one error.
 *
 * @sa vtkSeaStateSource
 */
#ifndef vtkWaveSpectrumReader_h
#define vtkWaveSpectrumReader_h

#include "LittoralSourcesModule.h" // for export macro
#include "vtkTableAlgorithm.h"

class LITTORALSOURCES_EXPORT vtkWaveSpectrumReader : public vtkTableAlgorithm
{
public:
  static vtkWaveSpectrumReader* New();
  vtkTypeMacro(vtkWaveSpectrumReader, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  enum DirectionConventionType
  {
    AsInFile = 0,
    NauticalFrom = 1,
    NauticalTo = 2,
    CartesianTo = 3,
    CartesianFrom = 4,
  };

  enum DensityUnitType
  {
    PerDegree = 0,
    PerRadian = 1,
  };

  ///@{
  /**
   * Name of the file; default none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Index of the time in a file of several, not negative; default 0, the first in the file.
   */
  vtkSetMacro(Record, int);
  vtkGetMacro(Record, int);
  ///@}

  ///@{
  /**
   * Index of the place in a file of several, not negative; default 0, the first. Used for SWAN.
   */
  vtkSetMacro(Location, int);
  vtkGetMacro(Location, int);
  ///@}

  ///@{
  /**
   * Meaning of directions in the file, a DirectionConventionType; default AsInFile, what the format or its header says;
   * a table by frequency and direction does not, and needs another. NauticalFrom and NauticalTo: clockwise from north,
   * from where waves come and where they go. CartesianTo and CartesianFrom: from x (east) towards y (north).
   */
  vtkSetMacro(DirectionConvention, int);
  vtkGetMacro(DirectionConvention, int);
  void SetDirectionConventionToAsInFile() { this->SetDirectionConvention(AsInFile); }
  void SetDirectionConventionToNauticalFrom() { this->SetDirectionConvention(NauticalFrom); }
  void SetDirectionConventionToNauticalTo() { this->SetDirectionConvention(NauticalTo); }
  void SetDirectionConventionToCartesianTo() { this->SetDirectionConvention(CartesianTo); }
  void SetDirectionConventionToCartesianFrom() { this->SetDirectionConvention(CartesianFrom); }
  ///@}

  ///@{
  /**
   * Unit of the densities in a table by frequency and direction, a DensityUnitType; default PerDegree, m2/Hz/degree.
   * PerRadian: m2/Hz/rad. Not used for other formats.
   */
  vtkSetMacro(DensityUnit, int);
  vtkGetMacro(DensityUnit, int);
  void SetDensityUnitToPerDegree() { this->SetDensityUnit(PerDegree); }
  void SetDensityUnitToPerRadian() { this->SetDensityUnit(PerRadian); }
  ///@}

protected:
  vtkWaveSpectrumReader();
  ~vtkWaveSpectrumReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  char* FileName;
  int Record;
  int Location;
  int DirectionConvention;
  int DensityUnit;

private:
  vtkWaveSpectrumReader(const vtkWaveSpectrumReader&) = delete;
  void operator=(const vtkWaveSpectrumReader&) = delete;
};

#endif
