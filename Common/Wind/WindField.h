// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralWindField_h
#define LittoralWindField_h

#include "Numerics/LineFourier.h"
#include "Numerics/Parallel.h"
#include "Numerics/WorkShare.h"
#include "Wind/WindSpectrum.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace littoral
{

/// Grid of a wind field: along the wind, that is in time, then across, then up.
struct WindGrid
{
  std::array<int, 3> Count{ 600, 64, 24 }; ///< the first at least 4, even and a product of 2, 3 and 5
  double TimeStep = 0.1;                   ///< between samples along the wind [s], positive
  double LateralSpacing = 4.0;             ///< [m], positive
  double VerticalSpacing = 2.0;            ///< [m], positive
  double BottomHeight = 1.0;               ///< of the lowest layer above the ground [m], above the roughness length

  /// Number of waves of a line, of the frequencies 1, 2 ... a period.
  int Waves() const { return this->Count[0] / 2 - 1; }
  double Period() const { return this->Count[0] * this->TimeStep; }
  double Height(int layer) const { return this->BottomHeight + layer * this->VerticalSpacing; }
  std::size_t NumberOfLines() const { return static_cast<std::size_t>(this->Count[1]) * this->Count[2]; }
};

/// Columns of lines side by side across the wind: from First up to End, which does not belong to them.
struct WindColumns
{
  int First = 0;
  int End = 0;

  int Count() const { return this->End - this->First; }
  bool Hold(const WindColumns& others) const
  {
    return others.Count() <= 0 || (this->First <= others.First && others.End <= this->End);
  }
};

/// Randomness of a spectral wind.
enum class WindPhases
{
  Uniform = 0,           ///< phases alone: each wave has the energy that the spectrum says (the paper's way)
  GaussianAmplitudes = 1 ///< amplitudes too: a Gaussian process, with its scatter from run to run
};

/// Parameters of the synthesis of a wind field.
struct WindSynthesis
{
  WindPhases Phases = WindPhases::Uniform;
  bool NormalizeVariance = false; ///< scale each component and layer to Variance(), of all frequencies
  int Seed = 1;
  bool ShearStress = false; ///< whether gusts along and up have the co-spectrum ShearDensity()
};

/// The smallest even product of 2, 3 and 5 that is not below the given size: lengths along the wind.
int NextWindLength(int size);

/// The largest such length that is not above the given size, of at least 4.
int LastWindLength(int size);

/// Why there is no such field, in words for a user; empty when there is one.
std::string WhyInvalid(const WindModel& model, const WindGrid& grid);

/// Bytes that the synthesis takes in all, the velocities included, for so many columns across.
double WindFieldBytes(const WindGrid& grid, int columns);

/// Random factors of one frequency: for cells first ... first + count - 1, of mean square 1.
void WindFactors(const WindSynthesis& synthesis, int component, int frequency, std::uint64_t first, std::size_t count,
  float* re, float* im);

/**
 * A frozen, periodic field of turbulence over a mean wind, by Fourier synthesis (Setas et al., algorithm 3, put right:
 * see Documentation/errata.md).
 *
 * For each frequency the root coherence, a function of separations alone on a grid that is padded to twice its size, is
 * transformed to the power of plane waves across and up. Waves with the root of that power and random phases, summed,
 * give a plane of complex amplitudes with that coherence; scaled by the root of the spectrum at each height they are
 * the Fourier coefficients in time, from one wave a period to the last that has more than two samples: two samples
 * would not tell such a wave's size from its phase, and it would pulse between them. Power that comes out negative is
 * taken as none; how far that moves the coherence is known exactly.
 *
 * With ShearStress the waves up are those of their own with the part (1 - g^2)^(1/2) and, with the part g, such as have
 * the random factors of those along the wind; g follows from the co-spectrum at each frequency and height, at most 1.
 * Both have the coherence of the component, so that spectra stay as they are.
 *
 * Components are made one after the other: BeginComponent, then all blocks of frequencies, FinishPlanes, then all packs
 * of lines, where blocks and packs can go to any threads. Several processes share the blocks by MakeShared: a plane
 * needs one frequency of all lines, a line all frequencies.
 */
class WindField
{
public:
  /// Model and grid must be valid.
  WindField(const WindModel& model, const WindGrid& grid, const WindSynthesis& synthesis);
  /// One of which only some columns are kept, for MakeShared.
  WindField(const WindModel& model, const WindGrid& grid, const WindSynthesis& synthesis, const WindColumns& columns);

  std::size_t NumberOfBlocks() const;
  std::size_t NumberOfPacks() const;

  void BeginComponent(int component);
  void MakePlanes(std::size_t block);
  void FinishPlanes();
  /// Room for MakeLines, which one thread may use for pack after pack.
  LinePack RoomForLines() const;
  /// Writes into velocities: (along, across, up) of each sample, the first index (x, downwind) fastest.
  void MakeLines(std::size_t pack, LinePack& room, float* velocities) const;

  /// All of it: (along, across, up) of each sample at time 0.
  std::vector<float> Make(const ParallelFor& parallel = SerialFor);

  /// The same of the own columns, with other processes: each makes the planes of its share of the blocks, and of those
  /// of the others it gets its columns. All bytes are those of Make().
  std::vector<float> MakeShared(const WorkShare& share, const ParallelFor& parallel = SerialFor);

  /// The largest difference between the coherence of the components made so far and the model's, within the grid.
  double GetCoherenceError() const { return this->CoherenceError; }

private:
  struct Scratch;

  /// Complex amplitudes of lines, line by line.
  struct Plane
  {
    float* Re;
    float* Im;
  };

  /// Power of the waves of one frequency, in the quarter of wave numbers up to the middle; what was clipped of it.
  double WavePower(int component, int frequency, Scratch& scratch) const;
  /// Transforms an even function, given in the quarter of indices up to the middle, along both axes.
  void TransformEven(std::vector<float>& quarter, Scratch& scratch) const;
  double CoherenceErrorOf(int component, int frequency, Scratch& scratch) const;
  void MakePlanesAt(std::size_t block, const std::function<Plane(int frequency)>& planeOf);
  void SumWaves(int frequency, const Plane& plane, Scratch& scratch) const;
  void AddWaves(int component, int frequency, bool isFirst, const std::vector<float>& shares, const Plane& plane,
    Scratch& scratch) const;
  void SumUp(Scratch& scratch) const;
  void SumAcross(
    int frequency, bool isFirst, const std::vector<float>& shares, const Plane& plane, Scratch& scratch) const;
  /// Frequencies of a block: the first, and the last.
  std::array<int, 2> FrequenciesOf(std::size_t block) const;
  std::size_t NumberOfKept() const { return static_cast<std::size_t>(this->Columns.Count()) * this->Grid.Count[2]; }
  Plane KeptPlane(int frequency);
  void AddPower(const float* re, const float* im);
  void TakeError();
  void TakeLayerFactors();
  /// Blocks that each process makes before all exchange them.
  std::size_t BlocksAtOnce() const;
  /// Planes on their way from process to process; memory that is taken once.
  struct SharedPlanes
  {
    std::vector<WindColumns> Columns;     ///< of each process
    std::vector<std::vector<float>> Made; ///< by block: the real parts of a plane, then its imaginary ones
    SingleRows Sent;
    SingleRows Received;
  };
  void MakeAllLines(float* velocities, const ParallelFor& parallel) const;
  void ShareBlocks(std::size_t first, SharedPlanes& planes, const WorkShare& share, const ParallelFor& parallel);
  void SharePower(std::size_t first, const SharedPlanes& planes, const WorkShare& share);
  void Deal(SharedPlanes& planes, const WorkShare& share) const;
  bool HasStress() const;
  /// Likeness of planes of waves along and up that have the same random factors; then the power is that of those up.
  double PowersOfBoth(int frequency, Scratch& scratch) const;
  std::vector<float> SharedPart(int frequency, double likeness) const;

  WindModel Model;
  WindGrid Grid;
  WindSynthesis Synthesis;
  WindColumns Columns;        ///< kept ones
  std::array<int, 2> Padded;  ///< cells across and up
  std::array<int, 2> Quarter; ///< wave numbers up to the middle
  LineFourier Across;
  LineFourier Up;
  RealLineFourier Along;
  std::array<std::vector<float>, WindComponents> Delay; ///< of the coherence, in the quarter of separations [s]
  std::array<std::vector<float>, WindComponents> Still; ///< exponent of its decay at any frequency
  int Component = 0;
  std::vector<float> PlaneRe; ///< Fourier coefficients in time: frequency, then across, then up (fastest)
  std::vector<float> PlaneIm;
  std::vector<double> LayerPower;
  std::vector<float> LayerFactor;
  std::vector<float> BlockError;
  double CoherenceError = 0.0;
};

}

#endif
