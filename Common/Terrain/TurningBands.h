// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTurningBands_h
#define LittoralTurningBands_h

#include "Numerics/RandomStream.h"
#include "Terrain/CovarianceModels.h"
#include "Terrain/GridSamples.h"
#include "Terrain/ShortWaves.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace littoral
{

/// Division of the wave numbers of a line into bins, one harmonic a bin.
enum class HarmonicBins
{
  Adaptive = 0, ///< half of the bins follow the spectrum's mass, half its octaves; Fractal: octaves alone
  Uniform = 1,  ///< equal widths, as in the paper's eq. 3
};

/// Parameters of a turning bands field.
struct TurningBandsParameters
{
  CovarianceParameters Field;
  int NumberOfLines = 64;
  int NumberOfHarmonics = 300;
  HarmonicBins Bins = HarmonicBins::Adaptive;
  double AnisotropyRatio = 1.0; ///< longest over shortest range; Field.Range is the longest
  double AnisotropyAngle = 0.0; ///< [rad], direction of the longest range, counter-clockwise from x
  /// [m], finer detail is left out, which makes a band-limited field; 0: detail of every size, sampled at the points
  double MinimumWavelength = 0.0;
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

/**
 * The number of lines whose rays leave no gaps in the spectrum of a field on a grid, at least 64 and at most 1024. A
 * line's ray is as wide as the grid tells wave numbers apart, 2 pi / D for a grid of size D; at wave number w the rays
 * of L lines are pi w / L apart. Rays two widths apart are not told from an even spectrum
 * (Documentation/design/terrain.md): L = w D / 4, at the wave number w below which lies 95 % of the slopes' variance
 * that lines carry.
 */
int EnoughLines(const TurningBandsParameters& parameters, const PlaneGrid& grid, const GridWindow& whole);

/// Why no field can be grown with these parameters on this grid; empty when it can. The prefix is that of its own Model
/// and Range.
std::string WhyInvalid(const TurningBandsParameters& parameters, const PlaneGrid& grid, const std::string& prefix = "");

/// Spectrum of a line, bin by bin of its wave numbers.
struct LineSpectrum
{
  std::vector<double> Edges; ///< [rad/m], one more than bins, where the field is isotropic
  std::vector<double> Power; ///< part of the field's variance
  double Total = 1.0;        ///< of all lines together, the part of the field's variance
};

/**
 * A Gaussian random field of mean zero by the turning bands method (Setas et al., algorithm 1): a sum over lines of
 * one-dimensional processes, each a sum of harmonics (eq. 3), tabulated along its line.
 *
 * The field is a function of position alone. A window of the grid holds the same bytes whether it is computed by
 * itself or as part of a larger one, and a grid of 2, 4, 8... times the spacing holds every 2nd, 4th, 8th... value,
 * provided that MinimumWavelength is the same, and below eight of the finest spacings.
 *
 * Lines carry the long waves. Where the spectrum is left open at its end, short waves, of less than some four to eight
 * spacings, are a moving average of noise at the points (see ShortWaves). So variance and covariance at the points are
 * the model's at all lags.
 *
 * Each line is tabulated with a step that divides the step of the grid's points along it (in x, or in y for a line
 * that is closer to y). A row of points then meets the table at one constant fraction of its step, which turns the
 * look-up into sums of shifted arrays. Interpolation is by cubic B-splines. Each harmonic is divided by the root of the
 * mean power of its spline, and each line's nodes are shifted by a random part of a step, so that no variance is lost.
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

  /// The long waves at any position [m], summed harmonic by harmonic: slow, free of tables, needs no TabulateLine. The
  /// whole field if MinimumWavelength is given.
  double ValueAt(double x, double y) const;

  /// The value that FillRows() has at a point of the window, with the same bytes.
  float ValueAtPoint(int column, int row) const;

  /// The long waves between the points of the window, at a place in columns and rows, from the tables.
  double LongWavesAt(double column, double row) const;

  /// Short waves, which are added to the long waves at the points; null where lines carry all.
  const ShortWaves* GetShortWaves() const { return this->Short ? &*this->Short : nullptr; }

  /// The points in the space where the field is isotropic.
  const PlaneLattice& GetLattice() const { return this->Lattice; }

  /**
   * A line's part in the plane that fits the field best by least squares over a rectangle of the given center and sides
   * [m]: the sum over lines is the field's. In closed form from the harmonics: it needs no TabulateLine, and no window
   * changes it.
   */
  PlaneTrend PlaneOfLine(
    std::size_t line, const std::array<double, 2>& center, const std::array<double, 2>& sides) const;

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
    int StrideBits;                 ///< logarithm of the stride, the table's nodes per grid step, a power of two
    double Step;                    ///< [m], signed distance of table nodes along the line
    double Shift;                   ///< node 0 lies this part of a step before the line's origin, 0 to 1
    double FirstPosition;     ///< of the points of row 0 (or column 0), in nodes, less the stride times their index
    double Across;            ///< its change from row to row
    double Highest;           ///< wave number along the line up to which it has harmonics
    long long FirstNode;      ///< absolute index of the first node in the table, a multiple of a block
    std::vector<float> Table; ///< spline coefficients, one contiguous array for each phase of the stride
    std::size_t PhaseLength;
  };

  void PlaceTable(Line& line) const;
  void PlaceLine(std::size_t line);
  void AddLines(const std::vector<const Line*>& lines, int row, int rows, int column, int columns, float* sums) const;

  TurningBandsParameters Parameters;
  PlaneGrid Grid;
  GridWindow Window;
  PlaneLattice Lattice; ///< of the grid's points in the space where the field is isotropic
  LineSpectrum Spectrum;
  std::optional<ShortWaves> Short; ///< waves beyond those of the lines, if they matter
  double FirstDirection;           ///< angle of line 0 [rad]
  std::vector<Line> Lines;
};

}

#endif
