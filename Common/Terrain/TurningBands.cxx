// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/TurningBands.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Numerics/SimdClones.h"
#include "Terrain/TapSums.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace littoral
{

// The turning bands method: A. Mantoglou and J. L. Wilson, Water Resources Research 18 (5), 1982. Equations are those
// of Setas et al., section 2.1.

namespace
{

/// Part of the variance that may lie above the highest harmonic; what is cut is given back to the rest.
constexpr double CutTail = 1e-6;

/// Largest phase step of a harmonic from node to node, four nodes a wavelength; the spline's images hold 1.5e-4
/// of the power there, and fall with the eighth power of the wave number.
constexpr double MostPhaseStep = 0.5 * Pi;

/// Most nodes of a table for a step of the grid; on lines that would need more, harmonics end earlier.
constexpr int MostNodesPerStep = 64;

/// More lines or harmonics than this show nothing more, and take hours.
constexpr int MostLinesGiven = 100000;
constexpr int MostHarmonics = 100000;

/// Spacings between 0 and the origin beyond which points are not told apart.
constexpr double FarthestOrigin = 1e12;

/// Draw index of the random turn of all lines and of the random shift of each line's nodes, far from those of the
/// harmonics.
constexpr std::uint64_t PlaceDraw = 0xffffffffu;

// -------------------------------------------------------------------------------------------------------------------
// Line tables. A block of nodes lies symmetrically about its center c: with theta = delta (m + 1/2),
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

/// One pass of harmonics: their state at the center of the present block, and the sines within a block.
struct HarmonicPass
{
  int Count;
  alignas(64) double Cosine[HarmonicsPerPass]; ///< amplitude times cosine of the phase at the block's center
  alignas(64) double Sine[HarmonicsPerPass];
  alignas(64) double TurnCosine[HarmonicsPerPass]; ///< rotation from block to block
  alignas(64) double TurnSine[HarmonicsPerPass];
  alignas(64) float NodeCosine[HarmonicsPerPass][HalfBlock];
  alignas(64) float NodeSine[HarmonicsPerPass][HalfBlock];
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
    // cos, sin of (m + 1/2) delta, each from the one before by the rotation delta
    for (int m = 0; m < HalfBlock; ++m)
    {
      pass.NodeCosine[k][m] = static_cast<float>(c);
      pass.NodeSine[k][m] = static_cast<float>(s);
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
    // A exp(i a) exp(i Block delta)
    pass.Cosine[k] = c * pass.TurnCosine[k] - s * pass.TurnSine[k];
    pass.Sine[k] = s * pass.TurnCosine[k] + c * pass.TurnSine[k];
  }
}

using EightFloats = float __attribute__((vector_size(8 * sizeof(float))));
using FourFloats = float __attribute__((vector_size(4 * sizeof(float))));

/// Adds the pass's harmonics to two blocks of nodes, whose states are given: a small matrix product. A part of each
/// block at a time, two packs of nodes on either side of the center, so that all sums stay in registers.
template <typename Pack>
LITTORAL_INLINE void AddTwoBlocksBy(const HarmonicPass& pass, const float (*cosine)[HarmonicsPerPass],
  const float (*sine)[HarmonicsPerPass], float* nodes)
{
  constexpr int lanes = sizeof(Pack) / sizeof(float);
  for (int first = 0; first < HalfBlock; first += 2 * lanes)
  {
    Pack even[2][2] = {};
    Pack odd[2][2] = {};
    for (int k = 0; k < pass.Count; ++k)
    {
      // even = sum_k A_k cos a_k cos theta_km, odd = sum_k A_k sin a_k sin theta_km
      for (int p = 0; p < 2; ++p)
      {
        Pack c;
        Pack s;
        std::memcpy(&c, &pass.NodeCosine[k][first + p * lanes], sizeof(c));
        std::memcpy(&s, &pass.NodeSine[k][first + p * lanes], sizeof(s));
        for (int b = 0; b < 2; ++b)
        {
          even[b][p] += cosine[b][k] * c;
          odd[b][p] += sine[b][k] * s;
        }
      }
    }
    for (int b = 0; b < 2; ++b)
    {
      float* center = nodes + b * Block + HalfBlock;
      for (int m = 0; m < 2 * lanes; ++m)
      {
        const float e = even[b][m / lanes][m % lanes];
        const float o = odd[b][m / lanes][m % lanes];
        // sum_k A_k cos(a_k +- theta_km) = even -+ odd
        center[first + m] += e - o;
        center[-1 - first - m] += e + o;
      }
    }
  }
}

#if LITTORAL_HAS_SIMD_VERSIONS
LITTORAL_AVX2_VERSION void AddTwoBlocks(const HarmonicPass& pass, const float (*cosine)[HarmonicsPerPass],
  const float (*sine)[HarmonicsPerPass], float* nodes)
{
  AddTwoBlocksBy<EightFloats>(pass, cosine, sine, nodes);
}
#endif

LITTORAL_ANY_VERSION void AddTwoBlocks(const HarmonicPass& pass, const float (*cosine)[HarmonicsPerPass],
  const float (*sine)[HarmonicsPerPass], float* nodes)
{
  AddTwoBlocksBy<FourFloats>(pass, cosine, sine, nodes);
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
      const double center = static_cast<double>(block * Block) + HalfBlock - 0.5;
      for (int k = 0; k < pass.Count; ++k)
      {
        // eq. 3 at the block's center: A cos(delta n + phase)
        const double angle = delta[k] * center + phase[k];
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

/// The largest whole number that is not above a position; the standard function would be a call.
long long Floor(double position)
{
  const long long towardsZero = static_cast<long long>(position);
  return towardsZero - (static_cast<double>(towardsZero) > position ? 1 : 0);
}

/// Columns and rows of the tiles in which the points are worked on: long runs for the shifted sums, short enough for
/// the cache. Rows lie a little farther apart, so that the values of a column share no set of the cache.
constexpr int TileSize = MaximumPointsAtOnce;
constexpr int TilePitch = TileSize + 16;

/// Weights B_0(t) ... B_3(t) of the uniform cubic B-spline at the fractions of several lines, 0 <= t < 1.
void SplineWeights(const double* fractions, TapWeights& weights)
{
  const double sixth = 1.0 / 6.0;
  for (int n = 0; n < LinesAtOnce; ++n)
  {
    const double t = fractions[n];
    const double u = 1.0 - t;
    weights[0][n] = static_cast<float>(sixth * (u * u * u));
    weights[1][n] = static_cast<float>(sixth * (4.0 - t * t * (6.0 - 3.0 * t)));
    weights[2][n] = static_cast<float>(sixth * (4.0 - u * u * (6.0 - 3.0 * u)));
    weights[3][n] = static_cast<float>(sixth * (t * t * t));
  }
}

/// Side of the squares in which a tile is transposed.
constexpr int Corner = 4;
using CornerRow = float __attribute__((vector_size(Corner * sizeof(float))));

/// Adds a square of Corner x Corner sums, transposed: sums(j, i) += across(i, j).
LITTORAL_INLINE void AddTransposedCorner(const float* across, float* sums)
{
  CornerRow a[Corner];
  for (int i = 0; i < Corner; ++i)
  {
    std::memcpy(&a[i], across + static_cast<std::ptrdiff_t>(i) * TilePitch, sizeof(a[i]));
  }
  // Rows interleaved by two, then by one.
  const CornerRow even[2] = { __builtin_shufflevector(a[0], a[2], 0, 4, 1, 5),
    __builtin_shufflevector(a[0], a[2], 2, 6, 3, 7) };
  const CornerRow odd[2] = { __builtin_shufflevector(a[1], a[3], 0, 4, 1, 5),
    __builtin_shufflevector(a[1], a[3], 2, 6, 3, 7) };
  const CornerRow columns[Corner] = { __builtin_shufflevector(even[0], odd[0], 0, 4, 1, 5),
    __builtin_shufflevector(even[0], odd[0], 2, 6, 3, 7), __builtin_shufflevector(even[1], odd[1], 0, 4, 1, 5),
    __builtin_shufflevector(even[1], odd[1], 2, 6, 3, 7) };
  for (int j = 0; j < Corner; ++j)
  {
    CornerRow row;
    std::memcpy(&row, sums + static_cast<std::ptrdiff_t>(j) * TilePitch, sizeof(row));
    row += columns[j];
    std::memcpy(sums + static_cast<std::ptrdiff_t>(j) * TilePitch, &row, sizeof(row));
  }
}

/// Adds to a tile of rows one of columns; both are whole corners.
void AddTransposed(const float* columnSums, int rows, int columns, float* rowSums)
{
  for (int j = 0; j < rows; j += Corner)
  {
    for (int i = 0; i < columns; i += Corner)
    {
      AddTransposedCorner(columnSums + static_cast<std::ptrdiff_t>(i) * TilePitch + j,
        rowSums + static_cast<std::ptrdiff_t>(j) * TilePitch + i);
    }
  }
}

/// The rule for the number of lines: distance of rays in widths of a ray, the part of the slopes' variance that they
/// must hold without gaps, bounds, and bins of the spectrum to find it.
constexpr double RaySpacing = 2.0;
constexpr double SlopesThatMatter = 0.95;
constexpr int FewestLines = 64;
constexpr int MostLines = 1024;
constexpr int BinsForLines = 200;

// -------------------------------------------------------------------------------------------------------------------
// What the lines carry.

/// A vector in the space where the field is isotropic: A x, with A = diag(1, ratio) R(-angle).
std::array<double, 2> Stretched(const TurningBandsParameters& parameters, double x, double y)
{
  const double c = std::cos(parameters.AnisotropyAngle);
  const double s = std::sin(parameters.AnisotropyAngle);
  return { c * x + s * y, parameters.AnisotropyRatio * (c * y - s * x) };
}

PlaneLattice StretchedLattice(const TurningBandsParameters& parameters, const PlaneGrid& grid)
{
  return { Stretched(parameters, grid.Spacing[0], 0.0), Stretched(parameters, 0.0, grid.Spacing[1]) };
}

/// Whether the field has detail of every size at the grid's points; equal widths have no harmonics to spare for it.
bool IsOpen(const TurningBandsParameters& parameters)
{
  return parameters.MinimumWavelength == 0.0 && parameters.Bins == HarmonicBins::Adaptive;
}

/// The highest wave number of a field whose end is not open [rad/m].
double CutWaveNumber(const TurningBandsParameters& parameters, const PlaneGrid& grid)
{
  const double wavelength = parameters.MinimumWavelength > 0.0 ? parameters.MinimumWavelength
                                                               : 2.0 * std::max(grid.Spacing[0], grid.Spacing[1]);
  return TwoPi / wavelength;
}

/// Crossover of long and short waves, if short ones matter.
std::optional<Crossover> FindCrossover(const TurningBandsParameters& parameters, const PlaneLattice& lattice)
{
  const Crossover crossover = Crossover::OfLattice(lattice);
  const bool matters = IsOpen(parameters) && crossover.LongBelow(parameters.Field, crossover.High) < 1.0 - CutTail;
  return matters ? std::optional<Crossover>(crossover) : std::nullopt;
}

/// Edges of bins from 0 to the highest wave number W, at quantiles of half the cumulative spectrum, F(w) / F(W), and
/// half the octaves above its median w_m, max(0, ln(w / w_m) / ln(W / w_m)); w / W where there is less than one.
std::vector<double> AdaptiveEdges(const CovarianceParameters& field, double highest, int count)
{
  // Inverted on a table even in w^(1/3), linearly: edges need not be exact.
  std::vector<double> edges(count + 1);
  const int samples = 1024;
  const double median = WaveNumberAtTail(field, 0.5);
  const double total = CumulativeSpectrum(field, highest);
  double w0 = 0.0;
  double mass0 = 0.0;
  int k = 0;
  for (int i = 1; i <= samples; ++i)
  {
    const double part = static_cast<double>(i) / samples;
    const double w1 = highest * part * part * part;
    const double octave =
      highest > 2.0 * median ? std::max(0.0, std::log(w1 / median) / std::log(highest / median)) : w1 / highest;
    const double mass1 = 0.5 * (CumulativeSpectrum(field, w1) / total + octave);
    for (; k <= count && k <= mass1 * count; ++k)
    {
      edges[k] = w0 + (w1 - w0) * (static_cast<double>(k) / count - mass0) / (mass1 - mass0);
    }
    w0 = w1;
    mass0 = mass1;
  }
  for (; k <= count; ++k)
  {
    edges[k] = highest;
  }
  return edges;
}

/// Cuts [0, limit] into bins, and finds the power in each.
LineSpectrum CutSpectrum(
  const TurningBandsParameters& parameters, const std::optional<Crossover>& crossover, double limit)
{
  const CovarianceParameters& field = parameters.Field;
  const double highest = crossover ? crossover->High : std::min(WaveNumberAtTail(field, CutTail), limit);
  const int count = parameters.NumberOfHarmonics;
  const double lowest = std::min(LowestWaveNumber(field), 0.5 * highest);
  LineSpectrum spectrum;
  if (parameters.Bins == HarmonicBins::Uniform || lowest > 0.0)
  {
    const bool geometric = parameters.Bins == HarmonicBins::Adaptive;
    spectrum.Edges.resize(count + 1);
    for (int k = 0; k <= count; ++k)
    {
      const double part = static_cast<double>(k) / count;
      spectrum.Edges[k] = geometric ? lowest * std::pow(highest / lowest, part) : lowest + (highest - lowest) * part;
    }
  }
  else
  {
    spectrum.Edges = AdaptiveEdges(field, highest, count);
  }
  const auto powerBelow = [&](double w) {
    return crossover ? crossover->LongBelow(field, w) : CumulativeSpectrum(field, w); // in parts of the variance
  };
  spectrum.Power.resize(count);
  double below = powerBelow(spectrum.Edges[0]);
  for (int k = 0; k < count; ++k)
  {
    const double next = powerBelow(spectrum.Edges[k + 1]);
    spectrum.Power[k] = std::max(0.0, next - below);
    below = next;
  }
  spectrum.Total = crossover ? below : 1.0; // without short waves, lines carry all
  return spectrum;
}

LineSpectrum CutSpectrum(const TurningBandsParameters& parameters, const PlaneGrid& grid, const PlaneLattice& lattice)
{
  const double limit = IsOpen(parameters) ? Crossover::OfLattice(lattice).High : CutWaveNumber(parameters, grid);
  return CutSpectrum(parameters, FindCrossover(parameters, lattice), limit);
}

}

int EnoughLines(const TurningBandsParameters& parameters, const PlaneGrid& grid, const GridWindow& whole)
{
  // The field's size where it is isotropic.
  const PlaneLattice lattice = StretchedLattice(parameters, grid);
  const double size = std::max(lattice.Distance(1, 0) * (static_cast<double>(whole.Last[0]) - whole.First[0]),
    lattice.Distance(0, 1) * (static_cast<double>(whole.Last[1]) - whole.First[1]));
  // Slopes go as w2 f(w).
  TurningBandsParameters coarse = parameters;
  coarse.NumberOfHarmonics = BinsForLines;
  const LineSpectrum spectrum = CutSpectrum(coarse, grid, lattice);
  std::vector<double> slopes(1, 0.0);
  for (std::size_t k = 0; k < spectrum.Power.size(); ++k)
  {
    const double w = 0.5 * (spectrum.Edges[k] + spectrum.Edges[k + 1]);
    slopes.push_back(slopes.back() + w * w * spectrum.Power[k]);
  }
  const auto most = std::lower_bound(slopes.begin(), slopes.end(), SlopesThatMatter * slopes.back());
  const double highest = slopes.back() > 0.0 ? spectrum.Edges[most - slopes.begin()] : 0.0;
  // Rays pi w / L apart, of the width 2 pi / D: L = w D / (2 RaySpacing)
  const double lines = std::ceil(highest * size / (2.0 * RaySpacing));
  return static_cast<int>(std::clamp<double>(lines, FewestLines, MostLines));
}

std::string WhyInvalid(const TurningBandsParameters& parameters, const PlaneGrid& grid, const std::string& prefix)
{
  if (std::string why = WhyInvalid(parameters.Field, prefix); !why.empty())
  {
    return why;
  }
  const bool hasLargestWave = LowestWaveNumber(parameters.Field) > 0.0;
  ParameterCheck check;
  check.Count("NumberOfLines", parameters.NumberOfLines, 1, MostLinesGiven);
  check.Count("NumberOfHarmonics", parameters.NumberOfHarmonics, 1, MostHarmonics);
  check.Within("AnisotropyRatio", parameters.AnisotropyRatio, ValueInterval::AtLeast(1.0));
  check.Finite("AnisotropyAngle", parameters.AnisotropyAngle * 180.0 / Pi, "degrees");
  check.NotNegative("MinimumWavelength", parameters.MinimumWavelength);
  check.Require(!hasLargestWave || parameters.Field.Range > parameters.MinimumWavelength,
    prefix + "Range is " + TextOf(parameters.Field.Range) +
      "; the largest wavelength of a fractal field must exceed its shortest, " + TextOf(parameters.MinimumWavelength) +
      ".");
  check.Positive("Spacing[0]", grid.Spacing[0]);
  check.Positive("Spacing[1]", grid.Spacing[1]);
  for (int axis = 0; axis < 2; ++axis)
  {
    const std::string name = "Origin[" + std::to_string(axis) + "]";
    check.Finite(name, grid.Origin[axis]);
    check.Within(name, grid.Origin[axis],
      ValueInterval::From(-FarthestOrigin * grid.Spacing[axis], FarthestOrigin * grid.Spacing[axis]));
  }
  return check.Reason();
}

namespace
{

/// The place of a grid's point (0, 0), in whole spacings.
std::array<long long, 2> NearestPlace(const PlaneGrid& grid)
{
  return { std::llround(grid.Origin[0] / grid.Spacing[0]), std::llround(grid.Origin[1] / grid.Spacing[1]) };
}

}

TurningBandsField::TurningBandsField(
  const TurningBandsParameters& parameters, const PlaneGrid& grid, const GridWindow& window)
  : Parameters(parameters)
  , Grid(grid)
  , Window(window)
  , Lattice(StretchedLattice(parameters, grid))
  , Spectrum(CutSpectrum(parameters, grid, Lattice))
{
  if (const auto crossover = FindCrossover(parameters, this->Lattice))
  {
    this->Short.emplace(
      parameters.Field, this->Lattice, *crossover, NearestPlace(grid), parameters.Seed, parameters.Purpose);
  }
  const RandomStream random(parameters.Seed, parameters.Purpose);
  this->FirstDirection = Pi / parameters.NumberOfLines * random.UniformPair(0, PlaceDraw)[0];
  this->Lines.resize(parameters.NumberOfLines);
  for (std::size_t i = 0; i < this->Lines.size(); ++i)
  {
    this->PlaceLine(i);
  }
}

std::array<double, 2> TurningBandsField::GetDirection(std::size_t line) const
{
  const double angle = this->FirstDirection + Pi * static_cast<double>(line) / this->Parameters.NumberOfLines;
  return { std::cos(angle), std::sin(angle) };
}

/// Direction, nodes and highest wave number of a line.
void TurningBandsField::PlaceLine(std::size_t index)
{
  Line& line = this->Lines[index];
  // Algorithm 1, step 4: the coordinate along a line is u . A x, its gradient A^T u
  const auto u = this->GetDirection(index);
  const std::array<double, 2> steps = { u[0] * this->Lattice.StepX[0] + u[1] * this->Lattice.StepX[1],
    u[0] * this->Lattice.StepY[0] + u[1] * this->Lattice.StepY[1] };
  line.Gradient = { steps[0] / this->Grid.Spacing[0], steps[1] / this->Grid.Spacing[1] };
  line.AlongX = std::abs(steps[0]) >= std::abs(steps[1]);
  const int along = line.AlongX ? 0 : 1;

  // Nodes as close as the shortest wave needs. A given shortest wavelength counts in metres along x or y, which makes
  // the steps of the nodes the same on grids of 2, 4, 8... times the spacing; along the direction in which the field is
  // squeezed, it is a lower wave number on the line.
  const bool open = IsOpen(this->Parameters);
  const double cut = CutWaveNumber(this->Parameters, this->Grid);
  const double needed = open ? this->Spectrum.Edges.back() * std::abs(steps[along]) : cut * this->Grid.Spacing[along];
  line.StrideBits = 0;
  while (
    (1 << line.StrideBits) < MostNodesPerStep && std::ldexp(MostPhaseStep, line.StrideBits) < needed * (1.0 - 1e-9))
  {
    ++line.StrideBits;
  }
  line.Step = std::ldexp(steps[along], -line.StrideBits);
  line.Highest = std::min(open ? this->Spectrum.Edges.back() : cut / std::hypot(line.Gradient[0], line.Gradient[1]),
    MostPhaseStep / std::abs(line.Step));
  // A random place of the nodes: else all lines would have one at the grid's origin.
  line.Shift = RandomStream(this->Parameters.Seed, this->Parameters.Purpose).UniformPair(index, PlaceDraw)[1];
  line.FirstPosition =
    (line.Gradient[0] * this->Grid.Origin[0] + line.Gradient[1] * this->Grid.Origin[1]) / line.Step + line.Shift;
  line.Across = steps[1 - along] / line.Step;
  this->PlaceTable(line);
}

TurningBandsField::Harmonics TurningBandsField::GetHarmonics(std::size_t index) const
{
  const RandomStream random(this->Parameters.Seed, this->Parameters.Purpose);
  Harmonics harmonics;
  double power = 0.0;
  for (std::size_t k = 0; k < this->Spectrum.Power.size(); ++k)
  {
    const double low = this->Spectrum.Edges[k];
    if (low >= this->Lines[index].Highest && k > 0)
    {
      break;
    }
    // eq. 3: 2 (S_1 dw)^(1/2) cos(w' x + phi), with S_1 = sigma^2 f / 2 (eq. 4) and w' random in its bin:
    // A = (2 sigma^2 P_k)^(1/2), P_k the integral of f over the bin
    const auto draw = random.UniformPair(index, k);
    harmonics.WaveNumber.push_back(low + draw[0] * (this->Spectrum.Edges[k + 1] - low));
    harmonics.Amplitude.push_back(std::sqrt(2.0 * this->Spectrum.Power[k]));
    harmonics.Phase.push_back(TwoPi * draw[1]);
    power += this->Spectrum.Power[k];
  }
  // Power beyond the last harmonic goes to those that are there. 1 / L is the square of eq. 1's 1 / sqrt(L).
  const double variance = this->Parameters.Field.Variance * this->Spectrum.Total / this->Parameters.NumberOfLines;
  const double scale = power > 0.0 ? std::sqrt(variance / power) : 0.0;
  for (double& amplitude : harmonics.Amplitude)
  {
    amplitude *= scale;
  }
  return harmonics;
}

void TurningBandsField::PlaceTable(Line& line) const
{
  const int along = line.AlongX ? 0 : 1;
  const long long stride = 1ll << line.StrideBits;
  const double a = line.FirstPosition + line.Across * this->Window.First[1 - along];
  const double b = line.FirstPosition + line.Across * this->Window.Last[1 - along];
  const long long first = Floor(std::min(a, b)) - 1 + stride * this->Window.First[along];
  const long long last = Floor(std::max(a, b)) + 2 + stride * this->Window.Last[along];
  const long long unit = std::max<long long>(2 * Block, stride);
  line.FirstNode = RoundDown(first, unit);
  line.PhaseLength = static_cast<std::size_t>((RoundDown(last, unit) + unit - line.FirstNode) / stride);
}

void TurningBandsField::TabulateLine(std::size_t index)
{
  Line& line = this->Lines[index];
  Harmonics harmonics = this->GetHarmonics(index);
  std::vector<double>& delta = harmonics.WaveNumber;
  for (std::size_t k = 0; k < delta.size(); ++k)
  {
    delta[k] *= line.Step;
    harmonics.Phase[k] -= delta[k] * line.Shift;
    // The mean power between nodes of the spline with these coefficients is the harmonic's own: the sum over images of
    // sinc(delta / 2 pi + n)^8 is the transform of the B-spline of order 7, (2416 + 2382 cos delta + 240 cos 2 delta +
    // 2 cos 3 delta) / 5040.
    const double c = std::cos(delta[k]);
    harmonics.Amplitude[k] /= std::sqrt((((8.0 * c + 480.0) * c + 2376.0) * c + 2176.0) / 5040.0);
  }
  std::vector<float> nodes(line.PhaseLength << line.StrideBits, 0.0f);
  HarmonicPass pass;
  for (std::size_t k = 0; k < delta.size(); k += HarmonicsPerPass)
  {
    pass.Count = static_cast<int>(std::min<std::size_t>(HarmonicsPerPass, delta.size() - k));
    AddHarmonics(pass, &harmonics.Amplitude[k], &harmonics.Phase[k], &delta[k], line.FirstNode, nodes);
  }
  // Nodes that one row meets lie a stride apart: store them side by side.
  line.Table.resize(nodes.size() + Overrun);
  const std::size_t phases = std::size_t(1) << line.StrideBits;
  for (std::size_t n = 0; n < nodes.size(); ++n)
  {
    line.Table[(n & (phases - 1)) * line.PhaseLength + (n >> line.StrideBits)] = nodes[n];
  }
}

/**
 * Adds lines that are along x to a tile: rows of points from row and column on, each row's sums TilePitch after those
 * of the one before. For lines along y, rows and columns change places.
 */
void TurningBandsField::AddLines(
  const std::vector<const Line*>& lines, int row, int rows, int column, int columns, float* sums) const
{
  for (std::size_t begin = 0; begin < lines.size(); begin += LinesAtOnce)
  {
    // In the last pass, the last line fills empty places with weights of zero.
    const std::size_t places = std::min<std::size_t>(LinesAtOnce, lines.size() - begin);
    const Line* group[LinesAtOnce];
    bool neighbors = true;
    for (std::size_t n = 0; n < LinesAtOnce; ++n)
    {
      group[n] = lines[begin + std::min(n, places - 1)];
      neighbors = neighbors && group[n]->StrideBits == 0;
    }
    for (int j = 0; j < rows; ++j)
    {
      double fractions[LinesAtOnce];
      std::size_t starts[LinesAtOnce];
      for (int n = 0; n < LinesAtOnce; ++n)
      {
        // Algorithm 1, step 4: the projection x . u on the line, in nodes
        const Line& line = *group[n];
        const double position = line.FirstPosition + line.Across * (row + j);
        const long long node = Floor(position);
        fractions[n] = position - static_cast<double>(node);
        starts[n] = static_cast<std::size_t>(node - 1 - line.FirstNode + column * (1ll << line.StrideBits));
      }
      TapWeights weights;
      SplineWeights(fractions, weights);
      for (std::size_t n = places; n < LinesAtOnce; ++n)
      {
        weights[0][n] = weights[1][n] = weights[2][n] = weights[3][n] = 0.0f;
      }
      float* rowSums = sums + static_cast<std::ptrdiff_t>(j) * TilePitch;
      if (neighbors)
      {
        const float* tables[LinesAtOnce];
        for (int n = 0; n < LinesAtOnce; ++n)
        {
          tables[n] = group[n]->Table.data() + starts[n];
        }
        AddNeighborTaps(tables, weights, columns, rowSums);
        continue;
      }
      const float* taps[LinesAtOnce][4];
      for (int n = 0; n < LinesAtOnce; ++n)
      {
        const Line& line = *group[n];
        const std::size_t phases = (std::size_t(1) << line.StrideBits) - 1;
        for (int tap = 0; tap < 4; ++tap)
        {
          const std::size_t place = starts[n] + static_cast<std::size_t>(tap);
          taps[n][tap] = line.Table.data() + (place & phases) * line.PhaseLength + (place >> line.StrideBits);
        }
      }
      AddTaps(taps, weights, columns, rowSums);
    }
  }
}

void TurningBandsField::FillRows(int firstRow, int lastRow, double scale, double offset, float* values) const
{
  const int width = this->Window.Last[0] - this->Window.First[0] + 1;
  const int height = lastRow - firstRow + 1;
  const float scaleF = static_cast<float>(scale);
  const float offsetF = static_cast<float>(offset);
  std::vector<const Line*> alongX;
  std::vector<const Line*> alongY;
  for (const Line& line : this->Lines)
  {
    (line.AlongX ? alongX : alongY).push_back(&line);
  }

  std::vector<float> shortWaves;
  std::vector<float> rowSums(TileSize * TilePitch);
  std::vector<float> columnSums(TileSize * TilePitch);
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
      this->AddLines(alongX, row, rows, column, columns, rowSums.data());
      this->AddLines(alongY, column, columns, row, rows, columnSums.data());
      AddTransposed(columnSums.data(), rows, columns, rowSums.data());
      if (this->Short)
      {
        this->Short->Fill(column, row, columns, rows, shortWaves);
      }
      else
      {
        shortWaves.assign(static_cast<std::size_t>(columns) * rows, 0.0f);
      }
      for (int j = 0; j < rows; ++j)
      {
        float* out = values + static_cast<std::size_t>(tileRow + j) * width + tileColumn;
        const float* longWaves = &rowSums[static_cast<std::size_t>(j) * TilePitch];
        const float* shortRow = &shortWaves[static_cast<std::size_t>(j) * columns];
        for (int i = 0; i < columns; ++i)
        {
          out[i] = offsetF + scaleF * (longWaves[i] + shortRow[i]);
        }
      }
    }
  }
}

float TurningBandsField::ValueAtPoint(int column, int row) const
{
  std::vector<const Line*> alongX;
  std::vector<const Line*> alongY;
  for (const Line& line : this->Lines)
  {
    (line.AlongX ? alongX : alongY).push_back(&line);
  }
  std::vector<float> rowSums(Corner * TilePitch, 0.0f);
  std::vector<float> columnSums(Corner * TilePitch, 0.0f);
  this->AddLines(alongX, row, 1, column, 1, rowSums.data());
  this->AddLines(alongY, column, 1, row, 1, columnSums.data());
  AddTransposed(columnSums.data(), 1, 1, rowSums.data());
  std::vector<float> shortWaves(1, 0.0f);
  if (this->Short)
  {
    this->Short->Fill(column, row, 1, 1, shortWaves);
  }
  return 0.0f + 1.0f * (rowSums[0] + shortWaves[0]);
}

double TurningBandsField::LongWavesAt(double column, double row) const
{
  double sum = 0.0;
  for (const Line& line : this->Lines)
  {
    // The projection x . u on the line, in nodes, and the four nodes around it
    const double along = line.AlongX ? column : row;
    const double across = line.AlongX ? row : column;
    const double position = line.FirstPosition + line.Across * across + std::ldexp(along, line.StrideBits);
    const long long node = Floor(position);
    const double t = position - static_cast<double>(node);
    const double u = 1.0 - t;
    const double weights[4] = { u * u * u, 4.0 - t * t * (6.0 - 3.0 * t), 4.0 - u * u * (6.0 - 3.0 * u), t * t * t };
    const auto first = static_cast<std::size_t>(node - 1 - line.FirstNode);
    const std::size_t phases = (std::size_t(1) << line.StrideBits) - 1;
    for (std::size_t tap = 0; tap < 4; ++tap)
    {
      const std::size_t place = first + tap;
      sum += weights[tap] / 6.0 * line.Table[(place & phases) * line.PhaseLength + (place >> line.StrideBits)];
    }
  }
  return sum;
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
      // eqs. 1 and 3
      sum += harmonics.Amplitude[k] * std::cos(harmonics.WaveNumber[k] * position + harmonics.Phase[k]);
    }
  }
  return sum;
}

PlaneTrend TurningBandsField::PlaneOfLine(
  std::size_t index, const std::array<double, 2>& center, const std::array<double, 2>& sides) const
{
  // Means over [-1, 1] of cos(u t) and of t sin(u t): the spherical Bessel functions j0 and j1.
  const auto j0 = [](double u) { return std::abs(u) > 1e-4 ? std::sin(u) / u : 1.0; };
  const auto j1 = [](double u) {
    return std::abs(u) > 1e-2 ? (std::sin(u) / u - std::cos(u)) / u : u / 3.0 * (1.0 - 0.1 * u * u);
  };
  const Harmonics harmonics = this->GetHarmonics(index);
  const std::array<double, 2>& gradient = this->Lines[index].Gradient;
  const double middle = gradient[0] * center[0] + gradient[1] * center[1];
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
