// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TurningBands.h"

#include "Constants.h"
#include "SimdClones.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace littoral
{

namespace
{

/// Part of the variance that may lie above the highest harmonic; what is cut is given back to the rest.
constexpr double CutTail = 1e-6;

/// Table nodes per half of the shortest wavelength; two keep the spline's images below 1.3 % at the very end.
constexpr double NodesPerHalfWavelength = 2.0;

/// Highest wave number, in grid Nyquist wave numbers, of a field whose shortest wavelength is left open.
constexpr double MostFoldings = 64.0;

/// Draw index of the random turn of all lines, far from those of the harmonics.
constexpr std::uint64_t TurnDraw = 0xffffffffu;

// -------------------------------------------------------------------------------------------------------------------
// Line tables. A block of nodes lies symmetrically about its centre c: with theta = delta (m + 1/2),
// cos(a +- theta) = cos a cos theta -+ sin a sin theta gives two nodes for the products of one.
// The phase a is exact at the first block of each anchor and turned on by a rotation within it.

constexpr int HalfBlock = 16;
constexpr int Block = 2 * HalfBlock;
constexpr int BlocksPerAnchor = 32;
/// Harmonics whose sines and cosines are kept in the first-level cache together.
constexpr int HarmonicsPerPass = 64;

/// The smallest multiple of unit that is not above value, also for negative values.
long long RoundDown(long long value, long long unit)
{
  const long long quotient = value / unit;
  return (quotient * unit > value ? quotient - 1 : quotient) * unit;
}

/// Eight floats that the compiler keeps in one or two registers.
constexpr int PackSize = 8;
using FloatPack = float __attribute__((vector_size(PackSize * sizeof(float))));

/// One pass of harmonics: their state at the centre of the present block, and the sines within a block.
struct HarmonicPass
{
  int Count;
  alignas(64) double Cosine[HarmonicsPerPass]; ///< amplitude times cosine of the phase at the block's centre
  alignas(64) double Sine[HarmonicsPerPass];
  alignas(64) double TurnCosine[HarmonicsPerPass]; ///< rotation from block to block
  alignas(64) double TurnSine[HarmonicsPerPass];
  FloatPack NodeCosine[HarmonicsPerPass][HalfBlock / PackSize];
  FloatPack NodeSine[HarmonicsPerPass][HalfBlock / PackSize];
};

/// Sines and cosines of (m + 1/2) delta, by rotation in double precision.
void FillNodeAngles(HarmonicPass& pass, const double* delta)
{
  for (int k = 0; k < pass.Count; ++k)
  {
    double c = std::cos(0.5 * delta[k]);
    double s = std::sin(0.5 * delta[k]);
    const double turnCosine = c * c - s * s;
    const double turnSine = 2.0 * c * s;
    for (int m = 0; m < HalfBlock; ++m)
    {
      pass.NodeCosine[k][m / PackSize][m % PackSize] = static_cast<float>(c);
      pass.NodeSine[k][m / PackSize][m % PackSize] = static_cast<float>(s);
      const double next = c * turnCosine - s * turnSine;
      s = s * turnCosine + c * turnSine;
      c = next;
    }
    pass.TurnCosine[k] = std::cos(Block * delta[k]);
    pass.TurnSine[k] = std::sin(Block * delta[k]);
  }
}

LITTORAL_SIMD_CLONES void TurnToNextBlock(HarmonicPass& pass, float* cosine, float* sine)
{
  for (int k = 0; k < HarmonicsPerPass; ++k)
  {
    const double c = pass.Cosine[k];
    const double s = pass.Sine[k];
    cosine[k] = static_cast<float>(c);
    sine[k] = static_cast<float>(s);
    pass.Cosine[k] = c * pass.TurnCosine[k] - s * pass.TurnSine[k];
    pass.Sine[k] = s * pass.TurnCosine[k] + c * pass.TurnSine[k];
  }
}

/// Adds the pass's harmonics to two blocks of nodes, whose states are given: a small matrix product.
LITTORAL_SIMD_CLONES void AddTwoBlocks(const HarmonicPass& pass, const float (*cosine)[HarmonicsPerPass],
  const float (*sine)[HarmonicsPerPass], float* nodes)
{
  FloatPack even[2][HalfBlock / PackSize] = {};
  FloatPack odd[2][HalfBlock / PackSize] = {};
  for (int k = 0; k < pass.Count; ++k)
  {
    for (int p = 0; p < HalfBlock / PackSize; ++p)
    {
      const FloatPack c = pass.NodeCosine[k][p];
      const FloatPack s = pass.NodeSine[k][p];
      for (int b = 0; b < 2; ++b)
      {
        even[b][p] += cosine[b][k] * c;
        odd[b][p] += sine[b][k] * s;
      }
    }
  }
  for (int b = 0; b < 2; ++b)
  {
    float* block = nodes + b * Block;
    for (int m = 0; m < HalfBlock; ++m)
    {
      const float e = even[b][m / PackSize][m % PackSize];
      const float o = odd[b][m / PackSize][m % PackSize];
      block[HalfBlock + m] += e - o;
      block[HalfBlock - 1 - m] += e + o;
    }
  }
}

/// Adds harmonics, given by amplitude, phase at node 0 and phase step from node to node, to nodes first, first + 1...
void AddHarmonics(HarmonicPass& pass, const double* amplitude, const double* phase, const double* delta,
  long long first, std::vector<float>& nodes)
{
  std::fill(std::begin(pass.Cosine), std::end(pass.Cosine), 0.0);
  std::fill(std::begin(pass.Sine), std::end(pass.Sine), 0.0);
  FillNodeAngles(pass, delta);
  const long long firstBlock = first / Block;
  const long long lastBlock = firstBlock + static_cast<long long>(nodes.size()) / Block;
  alignas(64) float cosine[2][HarmonicsPerPass];
  alignas(64) float sine[2][HarmonicsPerPass];
  for (long long block = RoundDown(firstBlock, BlocksPerAnchor); block < lastBlock; block += 2)
  {
    if (block == RoundDown(block, BlocksPerAnchor))
    {
      const double centre = static_cast<double>(block * Block) + HalfBlock - 0.5;
      for (int k = 0; k < pass.Count; ++k)
      {
        const double angle = delta[k] * centre + phase[k];
        pass.Cosine[k] = amplitude[k] * std::cos(angle);
        pass.Sine[k] = amplitude[k] * std::sin(angle);
      }
    }
    TurnToNextBlock(pass, cosine[0], sine[0]);
    TurnToNextBlock(pass, cosine[1], sine[1]);
    if (block >= firstBlock)
    {
      AddTwoBlocks(pass, cosine, sine, nodes.data() + (block - firstBlock) * Block);
    }
  }
}

// -------------------------------------------------------------------------------------------------------------------
// Sums of shifted tables.

/// Where a row (or column) of points meets a line's table.
struct TableShift
{
  const float* Taps[4];
  float Weights[4];
};

/// Weights of the uniform cubic B-spline at fraction t of a step.
void SplineWeights(double t, float* weights)
{
  const double u = 1.0 - t;
  weights[0] = static_cast<float>(u * u * u / 6.0);
  weights[1] = static_cast<float>((4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0);
  weights[2] = static_cast<float>((4.0 - 6.0 * u * u + 3.0 * u * u * u) / 6.0);
  weights[3] = static_cast<float>(t * t * t / 6.0);
}

LITTORAL_SIMD_CLONES void AddShifted(const TableShift& shift, int count, float* __restrict sums)
{
  const float* __restrict t0 = shift.Taps[0];
  const float* __restrict t1 = shift.Taps[1];
  const float* __restrict t2 = shift.Taps[2];
  const float* __restrict t3 = shift.Taps[3];
  const float w0 = shift.Weights[0];
  const float w1 = shift.Weights[1];
  const float w2 = shift.Weights[2];
  const float w3 = shift.Weights[3];
  for (int i = 0; i < count; ++i)
  {
    sums[i] += (w0 * t0[i] + w1 * t1[i]) + (w2 * t2[i] + w3 * t3[i]);
  }
}

/// Columns and rows of the tiles in which the points are worked on: long runs for the shifted sums, short enough for
/// the cache.
constexpr int TileSize = 256;

bool IsPositive(double value)
{
  return std::isfinite(value) && value > 0.0;
}

}

std::string WhyInvalid(const TurningBandsParameters& parameters, const PlaneGrid& grid)
{
  std::ostringstream text;
  if (std::string reason = WhyInvalid(parameters.Field); !reason.empty())
  {
    return reason;
  }
  if (parameters.NumberOfLines < 1)
  {
    text << "NumberOfLines is " << parameters.NumberOfLines << "; it must be positive.";
  }
  else if (parameters.NumberOfHarmonics < 1)
  {
    text << "NumberOfHarmonics is " << parameters.NumberOfHarmonics << "; it must be positive.";
  }
  else if (!std::isfinite(parameters.AnisotropyRatio) || parameters.AnisotropyRatio < 1.0)
  {
    text << "AnisotropyRatio is " << parameters.AnisotropyRatio << "; it must be finite and at least 1.";
  }
  else if (!std::isfinite(parameters.AnisotropyAngle))
  {
    text << "AnisotropyAngle must be finite.";
  }
  else if (!std::isfinite(parameters.ShortestWavelength) || parameters.ShortestWavelength < 0.0)
  {
    text << "ShortestWavelength is " << parameters.ShortestWavelength << "; it must be finite and not negative.";
  }
  else if (parameters.Field.Model == CovarianceModel::Fractal &&
    parameters.Field.Range <= parameters.ShortestWavelength)
  {
    text << "Range is " << parameters.Field.Range << "; the largest wavelength of a fractal field must exceed its "
         << "shortest, " << parameters.ShortestWavelength << ".";
  }
  else if (!IsPositive(grid.Spacing[0]) || !IsPositive(grid.Spacing[1]))
  {
    text << "Spacing is " << grid.Spacing[0] << ", " << grid.Spacing[1] << "; it must be finite and positive.";
  }
  else if (!std::isfinite(grid.Origin[0]) || !std::isfinite(grid.Origin[1]))
  {
    text << "Origin must be finite.";
  }
  return text.str();
}

TurningBandsField::TurningBandsField(
  const TurningBandsParameters& parameters, const PlaneGrid& grid, const GridWindow& window)
  : Parameters(parameters)
  , Grid(grid)
  , Window(window)
{
  const double largestSpacing = std::max(grid.Spacing[0], grid.Spacing[1]);
  this->Wavelength = parameters.ShortestWavelength > 0.0 ? parameters.ShortestWavelength : 2.0 * largestSpacing;
  // A power of two, so that grids of 2, 4, 8... times the spacing share the nodes.
  this->StrideBits = 0;
  while (std::ldexp(this->Wavelength, this->StrideBits) < 2.0 * NodesPerHalfWavelength * largestSpacing)
  {
    ++this->StrideBits;
  }
  this->Stride = 1 << this->StrideBits;

  const RandomStream random(parameters.Seed, parameters.Purpose);
  const double spread = Pi / parameters.NumberOfLines;
  this->FirstDirection = spread * random.UniformPair(0, TurnDraw)[0];
  this->CutBins();

  this->Lines.resize(parameters.NumberOfLines);
  for (std::size_t i = 0; i < this->Lines.size(); ++i)
  {
    // The coordinate along a line is u . A x, with A = diag(1, ratio) R(-angle): its gradient is A^T u.
    const auto u = this->GetDirection(i);
    const double c = std::cos(parameters.AnisotropyAngle);
    const double s = std::sin(parameters.AnisotropyAngle);
    const double across = parameters.AnisotropyRatio * u[1];
    Line& line = this->Lines[i];
    line.Gradient = { c * u[0] - s * across, s * u[0] + c * across };
    const double stepX = line.Gradient[0] * grid.Spacing[0];
    const double stepY = line.Gradient[1] * grid.Spacing[1];
    line.AlongX = std::abs(stepX) >= std::abs(stepY);
    line.Step = (line.AlongX ? stepX : stepY) / this->Stride;
    this->PlaceTable(line);
  }
}

std::array<double, 2> TurningBandsField::GetDirection(std::size_t line) const
{
  const double angle = this->FirstDirection + Pi * static_cast<double>(line) / this->Parameters.NumberOfLines;
  return { std::cos(angle), std::sin(angle) };
}

/**
 * Without a shortest wavelength the grid's points sample a field that has detail of every size, as points of a real
 * surface do: wave numbers beyond what the tables resolve fold back in them and stay what they are between distant
 * points, uncorrelated. The limit only keeps the harmonics from being spread over detail that no grid can tell.
 */
double TurningBandsField::HighestWaveNumber() const
{
  const bool open = this->Parameters.ShortestWavelength == 0.0 && this->Parameters.Bins == HarmonicBins::Adaptive;
  const double folded = open ? MostFoldings : 1.0; // equal widths have no harmonics to spare
  return folded * TwoPi / this->Wavelength;
}

/// Cuts [0, highest wave number] into bins, and finds the power in each.
void TurningBandsField::CutBins()
{
  const CovarianceParameters& field = this->Parameters.Field;
  const double limit = this->HighestWaveNumber();
  const double highest = std::min(WaveNumberAtTail(field, CutTail), limit);
  const double median = WaveNumberAtTail(field, 0.5);
  const int count = this->Parameters.NumberOfHarmonics;
  this->BinEdges.resize(count + 1);
  const bool fractal = field.Model == CovarianceModel::Fractal;
  const double lowest = fractal ? std::min(TwoPi / field.Range, 0.5 * limit) : 0.0;

  if (this->Parameters.Bins == HarmonicBins::Uniform || fractal)
  {
    const bool geometric = this->Parameters.Bins == HarmonicBins::Adaptive;
    for (int k = 0; k <= count; ++k)
    {
      const double part = static_cast<double>(k) / count;
      this->BinEdges[k] = geometric ? lowest * std::pow(highest / lowest, part) : lowest + (highest - lowest) * part;
    }
  }
  else
  {
    // Invert the mean of the spectrum's mass and of the logarithm from the median up, both scaled to 1. A table even
    // in w^(1/3) is dense enough, as edges need not be exact.
    const int samples = 1024;
    const double total = SpectrumBelow(field, highest);
    double w0 = 0.0;
    double mass0 = 0.0;
    int k = 0;
    for (int i = 1; i <= samples; ++i)
    {
      const double part = static_cast<double>(i) / samples;
      const double w1 = highest * part * part * part;
      const double octave =
        highest > 2.0 * median ? std::max(0.0, std::log(w1 / median) / std::log(highest / median)) : w1 / highest;
      const double mass1 = 0.5 * (SpectrumBelow(field, w1) / total + octave);
      for (; k <= count && k <= mass1 * count; ++k)
      {
        this->BinEdges[k] = w0 + (w1 - w0) * (static_cast<double>(k) / count - mass0) / (mass1 - mass0);
      }
      w0 = w1;
      mass0 = mass1;
    }
    for (; k <= count; ++k)
    {
      this->BinEdges[k] = highest;
    }
  }

  this->BinPower.resize(count);
  double below = SpectrumBelow(field, this->BinEdges[0]);
  for (int k = 0; k < count; ++k)
  {
    const double next = SpectrumBelow(field, this->BinEdges[k + 1]);
    this->BinPower[k] = std::max(0.0, next - below);
    below = next;
  }
}

TurningBandsField::Harmonics TurningBandsField::GetHarmonics(std::size_t index) const
{
  const Line& line = this->Lines[index];
  // Along the direction in which the field is squeezed, the same wavelength [m] is a lower wave number on the line.
  const double highest = this->HighestWaveNumber() / std::hypot(line.Gradient[0], line.Gradient[1]);
  const RandomStream random(this->Parameters.Seed, this->Parameters.Purpose);
  Harmonics harmonics;
  double power = 0.0;
  for (std::size_t k = 0; k < this->BinPower.size(); ++k)
  {
    const double low = this->BinEdges[k];
    if (low >= highest && k > 0)
    {
      break;
    }
    const auto draw = random.UniformPair(index, k);
    harmonics.WaveNumber.push_back(low + draw[0] * (this->BinEdges[k + 1] - low));
    harmonics.Amplitude.push_back(std::sqrt(2.0 * this->BinPower[k]));
    harmonics.Phase.push_back(TwoPi * draw[1]);
    power += this->BinPower[k];
  }
  // The cut tail's variance goes to the harmonics that are there; the sum over lines is divided by their number.
  const double scale =
    power > 0.0 ? std::sqrt(this->Parameters.Field.Variance / (power * this->Parameters.NumberOfLines)) : 0.0;
  for (double& amplitude : harmonics.Amplitude)
  {
    amplitude *= scale;
  }
  return harmonics;
}

/// Position, in nodes, of the points of row j (or column i, for a line along y), less Stride times their index.
double TurningBandsField::NodePosition(const Line& line, int index) const
{
  const int across = line.AlongX ? 1 : 0;
  const double along = line.Gradient[1 - across] * this->Grid.Origin[1 - across];
  const double position = this->Grid.Origin[across] + index * this->Grid.Spacing[across];
  return (along + line.Gradient[across] * position) / line.Step;
}

void TurningBandsField::PlaceTable(Line& line) const
{
  const int along = line.AlongX ? 0 : 1;
  const double a = this->NodePosition(line, this->Window.First[1 - along]);
  const double b = this->NodePosition(line, this->Window.Last[1 - along]);
  const long long first = static_cast<long long>(std::floor(std::min(a, b))) - 1 +
    static_cast<long long>(this->Stride) * this->Window.First[along];
  const long long last = static_cast<long long>(std::floor(std::max(a, b))) + 2 +
    static_cast<long long>(this->Stride) * this->Window.Last[along];
  const long long unit = std::max(2 * Block, this->Stride);
  line.FirstNode = RoundDown(first, unit);
  line.PhaseLength = static_cast<std::size_t>((RoundDown(last, unit) + unit - line.FirstNode) / this->Stride);
}

void TurningBandsField::TabulateLine(std::size_t index)
{
  Line& line = this->Lines[index];
  Harmonics harmonics = this->GetHarmonics(index);
  std::vector<double>& delta = harmonics.WaveNumber;
  for (std::size_t k = 0; k < delta.size(); ++k)
  {
    delta[k] *= line.Step;
    // The spline of these coefficients then runs through the harmonic's own values at the nodes.
    harmonics.Amplitude[k] *= 3.0 / (2.0 + std::cos(delta[k]));
  }
  std::vector<float> nodes(line.PhaseLength * this->Stride, 0.0f);
  HarmonicPass pass;
  for (std::size_t k = 0; k < delta.size(); k += HarmonicsPerPass)
  {
    pass.Count = static_cast<int>(std::min<std::size_t>(HarmonicsPerPass, delta.size() - k));
    AddHarmonics(pass, &harmonics.Amplitude[k], &harmonics.Phase[k], &delta[k], line.FirstNode, nodes);
  }
  // Nodes that one row meets lie Stride apart: store them side by side.
  line.Table.resize(nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n)
  {
    line.Table[n % this->Stride * line.PhaseLength + n / this->Stride] = nodes[n];
  }
}

void TurningBandsField::FillRows(int firstRow, int lastRow, double scale, double offset, float* values) const
{
  const int width = this->Window.Last[0] - this->Window.First[0] + 1;
  const int height = lastRow - firstRow + 1;
  const float scaleF = static_cast<float>(scale);
  const float offsetF = static_cast<float>(offset);

  const auto shiftOf = [this](const Line& line, int index, int firstAlong) {
    const double position = this->NodePosition(line, index);
    const double node = std::floor(position);
    TableShift shift;
    SplineWeights(position - node, shift.Weights);
    const long long first =
      static_cast<long long>(node) - 1 + static_cast<long long>(this->Stride) * firstAlong - line.FirstNode;
    for (int tap = 0; tap < 4; ++tap)
    {
      const std::size_t n = static_cast<std::size_t>(first + tap);
      shift.Taps[tap] = line.Table.data() + (n & (this->Stride - 1)) * line.PhaseLength + (n >> this->StrideBits);
    }
    return shift;
  };

  std::vector<float> rowSums(TileSize * TileSize);
  std::vector<float> columnSums(TileSize * TileSize);
  for (int tileRow = 0; tileRow < height; tileRow += TileSize)
  {
    const int rows = std::min(TileSize, height - tileRow);
    for (int tileColumn = 0; tileColumn < width; tileColumn += TileSize)
    {
      const int columns = std::min(TileSize, width - tileColumn);
      const int row = firstRow + tileRow;
      const int column = this->Window.First[0] + tileColumn;
      std::fill(rowSums.begin(), rowSums.end(), 0.0f);
      std::fill(columnSums.begin(), columnSums.end(), 0.0f);
      for (const Line& line : this->Lines)
      {
        if (line.AlongX)
        {
          for (int j = 0; j < rows; ++j)
          {
            AddShifted(shiftOf(line, row + j, column), columns, &rowSums[j * TileSize]);
          }
        }
        else
        {
          for (int i = 0; i < columns; ++i)
          {
            AddShifted(shiftOf(line, column + i, row), rows, &columnSums[i * TileSize]);
          }
        }
      }
      for (int j = 0; j < rows; ++j)
      {
        float* out = values + static_cast<std::size_t>(tileRow + j) * width + tileColumn;
        for (int i = 0; i < columns; ++i)
        {
          out[i] = offsetF + scaleF * (rowSums[j * TileSize + i] + columnSums[i * TileSize + j]);
        }
      }
    }
  }
}

double TurningBandsField::ValueAt(double x, double y) const
{
  double sum = 0.0;
  for (std::size_t i = 0; i < this->Lines.size(); ++i)
  {
    const Harmonics harmonics = this->GetHarmonics(i);
    const double position = this->Lines[i].Gradient[0] * x + this->Lines[i].Gradient[1] * y;
    for (std::size_t k = 0; k < harmonics.WaveNumber.size(); ++k)
    {
      sum += harmonics.Amplitude[k] * std::cos(harmonics.WaveNumber[k] * position + harmonics.Phase[k]);
    }
  }
  return sum;
}

PlaneTrend TurningBandsField::PlaneOfLine(
  std::size_t index, const std::array<double, 2>& centre, const std::array<double, 2>& sides) const
{
  // Means over [-1, 1] of cos(u t) and of t sin(u t): the spherical Bessel functions j0 and j1.
  const auto j0 = [](double u) { return std::abs(u) > 1e-4 ? std::sin(u) / u : 1.0; };
  const auto j1 = [](double u) {
    return std::abs(u) > 1e-2 ? (std::sin(u) / u - std::cos(u)) / u : u / 3.0 * (1.0 - 0.1 * u * u);
  };
  const Harmonics harmonics = this->GetHarmonics(index);
  const std::array<double, 2>& gradient = this->Lines[index].Gradient;
  const double middle = gradient[0] * centre[0] + gradient[1] * centre[1];
  PlaneTrend plane;
  for (std::size_t k = 0; k < harmonics.WaveNumber.size(); ++k)
  {
    // A cos(kx x + ky y + p) over sides a, b: mean A cos p j0(ux) j0(uy), slope -6/a A sin p j1(ux) j0(uy), ux = kx
    // a/2.
    const double phase = harmonics.WaveNumber[k] * middle + harmonics.Phase[k];
    const double ux = 0.5 * harmonics.WaveNumber[k] * gradient[0] * sides[0];
    const double uy = 0.5 * harmonics.WaveNumber[k] * gradient[1] * sides[1];
    const double sine = harmonics.Amplitude[k] * std::sin(phase);
    plane.Mean += harmonics.Amplitude[k] * std::cos(phase) * j0(ux) * j0(uy);
    plane.Slope[0] -= 6.0 / sides[0] * sine * j1(ux) * j0(uy);
    plane.Slope[1] -= 6.0 / sides[1] * sine * j0(ux) * j1(uy);
  }
  return plane;
}

}
