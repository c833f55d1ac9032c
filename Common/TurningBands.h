// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTurningBands_h
#define LittoralTurningBands_h

#include "CovarianceModels.h"
#include "GridSamples.h"
#include "RandomStream.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace littoral
{

/// How the wave numbers of a line are cut into bins, one harmonic a bin.
enum class HarmonicBins
{
  Adaptive = 0, ///< half of the bins follow the spectrum's mass, half its octaves; Fractal: octaves alone
  Uniform = 1,  ///< equal widths, as in the paper's eq. 3
};

/// What field to grow.
struct TurningBandsParameters
{
  CovarianceParameters Field;
  int NumberOfLines = 64;
  int NumberOfHarmonics = 1000;
  HarmonicBins Bins = HarmonicBins::Adaptive;
  double AnisotropyRatio = 1.0; ///< longest over shortest range; Field.Range is the longest
  double AnisotropyAngle = 0.0; ///< [rad], direction of the longest range, counter-clockwise from x
  /// [m], finer detail is left out, which makes a band-limited field; 0: detail of every size, sampled at the points
  double ShortestWavelength = 0.0;
  int Seed = 1;
  RandomPurpose Purpose = RandomPurpose::ElevationLines;
};

/// A regular grid of the plane: point (i, j) is at Origin + (i, j) * Spacing [m].
struct PlaneGrid
{
  std::array<double, 2> Origin{ 0.0, 0.0 };
  std::array<double, 2> Spacing{ 1.0, 1.0 };
};

/// The points of a grid with First <= (i, j) <= Last.
struct GridWindow
{
  std::array<int, 2> First{ 0, 0 };
  std::array<int, 2> Last{ 0, 0 };
};

/// Why no field can be grown with these parameters on this grid; empty when it can.
std::string WhyInvalid(const TurningBandsParameters& parameters, const PlaneGrid& grid);

/**
 * A Gaussian random field of mean zero by the turning bands method (Setas et al., algorithm 1): a sum over lines of
 * one-dimensional processes, each a sum of harmonics (eq. 3), tabulated along its line.
 *
 * The field is a function of position alone. A window of the grid holds the same bytes whether it is computed by
 * itself or as part of a larger one, and a grid of 2, 4, 8... times the spacing holds every 2nd, 4th, 8th... value,
 * provided that ShortestWavelength is the same.
 *
 * Each line is tabulated with a step that divides the step of the grid's points along it (in x, or in y for a line
 * that is closer to y). A row of points then meets the table at one constant fraction of its step, which turns the
 * look-up into sums of shifted arrays. Cubic B-spline interpolation, made exact by dividing each harmonic by the
 * spline's response, keeps variance and slopes.
 *
 * Use: construct, call TabulateLine for each line (in any order, on any thread), then FillRows.
 */
class TurningBandsField
{
public:
  TurningBandsField(const TurningBandsParameters& parameters, const PlaneGrid& grid, const GridWindow& window);

  std::size_t GetNumberOfLines() const { return this->Lines.size(); }

  /// Computes the table of one line over the window.
  void TabulateLine(std::size_t line);

  /**
   * Values at rows firstRow <= j <= lastRow of the window, times scale and plus offset, x fastest. Value (i, j) goes to
   * values[(j - firstRow) * width + i - First], where width is the number of the window's columns.
   */
  void FillRows(int firstRow, int lastRow, double scale, double offset, float* values) const;

  /// The field at any position [m], summed harmonic by harmonic: slow, free of tables, needs no TabulateLine.
  double ValueAt(double x, double y) const;

  /**
   * A line's part in the plane that fits the field best by least squares over a rectangle of the given centre and sides
   * [m]: the sum over lines is the field's. In closed form from the harmonics: it needs no TabulateLine, and no window
   * changes it.
   */
  PlaneTrend PlaneOfLine(
    std::size_t line, const std::array<double, 2>& centre, const std::array<double, 2>& sides) const;

  /// Harmonics and direction of a line, for tests and for drawing.
  struct Harmonics
  {
    std::vector<double> WaveNumber; ///< [rad/m] along the line, in the space where the field is isotropic
    std::vector<double> Amplitude;
    std::vector<double> Phase; ///< [rad]
  };
  Harmonics GetHarmonics(std::size_t line) const;
  /// Unit vector of the line in the space where the field is isotropic.
  std::array<double, 2> GetDirection(std::size_t line) const;

private:
  struct Line
  {
    std::array<double, 2> Gradient; ///< change of the line's coordinate per metre along x and y
    bool AlongX;                    ///< the table's step divides the grid's step in x (else in y)
    double Step;                    ///< [m], signed distance of table nodes along the line
    long long FirstNode;            ///< absolute index of the first node in the table, a multiple of a block
    std::vector<float> Table;       ///< spline coefficients, one contiguous array for each phase of Stride
    std::size_t PhaseLength;
  };

  double NodePosition(const Line& line, int index) const;
  void PlaceTable(Line& line) const;
  double HighestWaveNumber() const;
  void CutBins();

  TurningBandsParameters Parameters;
  PlaneGrid Grid;
  GridWindow Window;
  int Stride;            ///< table nodes per grid step, a power of two
  int StrideBits;        ///< its logarithm
  double Wavelength;     ///< the shortest that the tables resolve [m]
  double FirstDirection; ///< angle of line 0 [rad]
  std::vector<double> BinEdges;
  std::vector<double> BinPower;
  std::vector<Line> Lines;
};

}

#endif
