// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Wind/WindField.h"

#include "Numerics/Constants.h"
#include "Numerics/FourierGrid.h"
#include "Numerics/ParameterCheck.h"
#include "Numerics/Prefetch.h"
#include "Numerics/RandomStream.h"
#include "Numerics/SimdClones.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>

namespace littoral
{

namespace
{
/// Frequencies that one thread makes at a time.
constexpr int FrequenciesPerBlock = 32;
/// Draws of four words each that are made at a time.
constexpr std::size_t DrawsAtOnce = 256;
/// The exponential of less than minus this is 0 in single precision; libraries take long to find that.
constexpr float NoCoherence = 104.0f;
/// Planes that are asked for in advance where lines are gathered from them.
constexpr std::size_t PlanesAhead = 16;
/// Clipped power below this is the rounding of single precision, not of the method.
constexpr double RoundingShare = 1e-5;

/// Cells on an axis that keep opposite borders apart on the circle that a discrete transform works on.
int PaddedLength(int count)
{
  return count == 1 ? 1 : 2 * NextFastLength(count);
}

std::size_t PacksOf(std::size_t lines)
{
  return (lines + FourierLanes - 1) / FourierLanes;
}

/// cos and sin of 2 pi words / 2^32, to single precision.
LITTORAL_SIMD_CLONES void UnitCircle(const std::uint32_t* words, std::size_t count, float* cosines, float* sines)
{
  for (std::size_t n = 0; n < count; ++n)
  {
    const std::uint32_t quadrant = (words[n] + 0x20000000u) >> 30;
    const float x = static_cast<float>(static_cast<std::int32_t>(words[n] - (quadrant << 30))) * 1.46291808e-9f;
    const float xx = x * x;
    const float s = x * (1.0f + xx * (-0.166666667f + xx * (8.3333333e-3f + xx * (-1.98412698e-4f + xx * 2.7557e-6f))));
    const float c = 1.0f + xx * (-0.5f + xx * (4.16666667e-2f + xx * (-1.38888889e-3f + xx * 2.4801587e-5f)));
    const bool swap = (quadrant & 1u) != 0;
    const float first = swap ? s : c;
    const float second = swap ? c : s;
    cosines[n] = ((quadrant + 1u) & 2u) != 0 ? -first : first;
    sines[n] = (quadrant & 2u) != 0 ? -second : second;
  }
}

RandomStream StreamOf(int seed, int component)
{
  constexpr RandomPurpose purposes[] = { RandomPurpose::WindAlong, RandomPurpose::WindAcross, RandomPurpose::WindUp };
  return { seed, purposes[component] };
}

/// Calls use(n, words, size) with the words of cells first + n ... first + n + size - 1 of a frequency, until all from
/// first to first + count - 1 have theirs; amplitudes have words of their own.
template <typename Use>
void ForWords(const RandomStream& stream, std::uint64_t object, std::uint64_t first, std::size_t count, const Use& use)
{
  std::uint32_t words[4 * DrawsAtOnce];
  for (std::size_t n = 0; n < count;)
  {
    const std::size_t skipped = (first + n) % 4;
    const std::size_t size = std::min(count - n, std::size(words) - skipped);
    stream.FillWords(object, (first + n) / 4, (skipped + size + 3) / 4, words);
    use(n, words + skipped, size);
    n += size;
  }
}

/// Copies the numbers of some lanes; all of them need no call.
void Take(const float* from, int lanes, float* to)
{
  lanes == FourierLanes ? std::copy_n(from, FourierLanes, to) : std::copy_n(from, lanes, to);
}

/// Sum of the powers of a quarter of wave numbers, each as often as it occurs on the whole grid.
double WholeSum(const std::vector<float>& quarter, const std::array<int, 2>& size, const std::array<int, 2>& padded)
{
  double sum = 0.0;
  for (int k = 0; k < size[1]; ++k)
  {
    const int timesUp = k == 0 || 2 * k == padded[1] ? 1 : 2;
    for (int j = 0; j < size[0]; ++j)
    {
      const int timesAcross = j == 0 || 2 * j == padded[0] ? 1 : 2;
      sum += static_cast<double>(timesUp * timesAcross) * quarter[static_cast<std::size_t>(k) * size[0] + j];
    }
  }
  return sum;
}
}

int NextWindLength(int size)
{
  return 2 * NextFastLength((size + 1) / 2);
}

int LastWindLength(int size)
{
  while (size > 4 && NextWindLength(size) != size)
  {
    --size;
  }
  return size;
}

std::string WhyInvalid(const WindModel& model, const WindGrid& grid)
{
  const std::string why = WhyInvalid(model);
  if (!why.empty())
  {
    return why;
  }
  std::ostringstream dimensions;
  dimensions << "Dimensions are " << grid.Count[0] << ", " << grid.Count[1] << ", " << grid.Count[2];
  ParameterCheck check;
  check.Require(grid.Count[0] >= 4 && grid.Count[1] >= 1 && grid.Count[2] >= 1,
    dimensions.str() + "; there must be at least 4 samples along the wind and 1 across and up.");
  check.Require(std::max({ grid.Count[0], grid.Count[1], grid.Count[2] }) <= 1 << 28,
    dimensions.str() + "; that is more than any memory holds.");
  if (check.IsGood())
  {
    const int next = NextWindLength(grid.Count[0]);
    check.Require(next == grid.Count[0],
      "Dimensions, x is " + std::to_string(grid.Count[0]) +
        "; it must be even and a product of 2, 3 and 5. The next good one is " + std::to_string(next) + ".");
  }
  check.Positive("TimeStep", grid.TimeStep, "s");
  check.Positive("LateralSpacing", grid.LateralSpacing, "m");
  check.Positive("VerticalSpacing", grid.VerticalSpacing, "m");
  check.Finite("BottomHeight", grid.BottomHeight, "m");
  check.Require(grid.BottomHeight > model.RoughnessLength,
    "BottomHeight is " + TextOf(grid.BottomHeight) + " m; it must be above the RoughnessLength of " +
      TextOf(model.RoughnessLength) + " m, below which there is no wind.");
  return check.Reason();
}

double WindFieldBytes(const WindGrid& grid, int columns)
{
  const double samples = static_cast<double>(grid.Count[0]) * columns * grid.Count[2];
  const double padded = 4.0 * grid.Count[1] * grid.Count[2];
  // Velocities, the half spectrum of one component, and room for each thread.
  return samples * sizeof(float) * (WindComponents + 1.0) +
    64.0 * (16.0 * padded + 32.0 * FourierLanes * grid.Count[0]);
}

void WindFactors(const WindSynthesis& synthesis, int component, int frequency, std::uint64_t first, std::size_t count,
  float* re, float* im)
{
  const RandomStream stream = StreamOf(synthesis.Seed, component);
  ForWords(stream, static_cast<std::uint64_t>(frequency), first, count,
    [&](std::size_t n, const std::uint32_t* words, std::size_t size) { UnitCircle(words, size, re + n, im + n); });
  if (synthesis.Phases == WindPhases::GaussianAmplitudes)
  {
    constexpr std::uint64_t amplitudes = std::uint64_t{ 1 } << 32;
    const auto scale = [&](std::size_t n, const std::uint32_t* words, std::size_t size) {
      for (std::size_t k = 0; k < size; ++k)
      {
        const float amplitude = static_cast<float>(std::sqrt(-std::log((words[k] + 0.5) * 0x1p-32)));
        re[n + k] *= amplitude;
        im[n + k] *= amplitude;
      }
    };
    ForWords(stream, amplitudes + frequency, first, count, scale);
  }
}

/// Work space of one thread for a plane.
struct WindField::Scratch
{
  explicit Scratch(const WindField& field)
    : Power(static_cast<std::size_t>(field.Quarter[0]) * field.Quarter[1])
    , Re(static_cast<std::size_t>(field.Padded[0]) * field.Padded[1])
    , Im(Re.size())
    , Across(field.Padded[0])
    , Up(field.Padded[1])
  {
  }

  std::vector<float> Power;
  std::vector<float> Re;
  std::vector<float> Im;
  LinePack Across;
  LinePack Up;
};

WindField::WindField(const WindModel& model, const WindGrid& grid, const WindSynthesis& synthesis)
  : WindField(model, grid, synthesis, { 0, grid.Count[1] })
{
}

WindField::WindField(
  const WindModel& model, const WindGrid& grid, const WindSynthesis& synthesis, const WindColumns& columns)
  : Model(model)
  , Grid(grid)
  , Synthesis(synthesis)
  , Columns(columns)
  , Padded{ PaddedLength(grid.Count[1]), PaddedLength(grid.Count[2]) }
  , Quarter{ Padded[0] / 2 + 1, Padded[1] / 2 + 1 }
  , Across(Padded[0])
  , Up(Padded[1])
  , Along(grid.Count[0])
  , PlaneRe((static_cast<std::size_t>(grid.Count[0]) / 2 + 1) * NumberOfKept())
  , PlaneIm(PlaneRe.size())
  , LayerPower(grid.Count[2], 0.0)
  , LayerFactor(grid.Count[2], 1.0f)
  , BlockError(this->NumberOfBlocks())
{
  for (int component = 0; component < WindComponents; ++component)
  {
    for (int k = 0; k < this->Quarter[1]; ++k)
    {
      for (int j = 0; j < this->Quarter[0]; ++j)
      {
        const WindSeparation separation =
          SeparationOf(model, component, j * grid.LateralSpacing, k * grid.VerticalSpacing);
        this->Delay[component].push_back(static_cast<float>(separation.Delay));
        this->Still[component].push_back(static_cast<float>(separation.Still));
      }
    }
  }
}

std::size_t WindField::NumberOfBlocks() const
{
  return (static_cast<std::size_t>(this->Grid.Waves()) + FrequenciesPerBlock - 1) / FrequenciesPerBlock;
}

std::size_t WindField::NumberOfPacks() const
{
  return PacksOf(this->NumberOfKept());
}

void WindField::BeginComponent(int component)
{
  this->Component = component;
  std::fill(this->LayerPower.begin(), this->LayerPower.end(), 0.0);
}

std::array<int, 2> WindField::FrequenciesOf(std::size_t block) const
{
  const int first = 1 + static_cast<int>(block) * FrequenciesPerBlock;
  return { first, std::min(first + FrequenciesPerBlock - 1, this->Grid.Waves()) };
}

WindField::Plane WindField::KeptPlane(int frequency)
{
  const std::size_t first = static_cast<std::size_t>(frequency) * this->NumberOfKept();
  return { &this->PlaneRe[first], &this->PlaneIm[first] };
}

void WindField::MakePlanes(std::size_t block)
{
  this->MakePlanesAt(block, [this](int frequency) { return this->KeptPlane(frequency); });
}

void WindField::MakePlanesAt(std::size_t block, const std::function<Plane(int frequency)>& planeOf)
{
  Scratch scratch(*this);
  const auto [first, last] = this->FrequenciesOf(block);
  this->BlockError[block] = 0.0f;
  for (int frequency = first; frequency <= last; ++frequency)
  {
    if (this->WavePower(this->Component, frequency, scratch) > RoundingShare)
    {
      const std::vector<float> power = scratch.Power;
      this->BlockError[block] = std::max(
        this->BlockError[block], static_cast<float>(this->CoherenceErrorOf(this->Component, frequency, scratch)));
      scratch.Power = power;
    }
    this->SumWaves(frequency, planeOf(frequency), scratch);
  }
}

void WindField::TransformEven(std::vector<float>& quarter, Scratch& scratch) const
{
  // The transform of an even real line is real: two lines go as the real and the imaginary part of one.
  const int width = this->Quarter[0];
  const auto transform = [&](const LineFourier& fourier, LinePack& pack, int lines, int lineStep, int step) {
    const int length = fourier.GetLength();
    const int half = length / 2 + 1;
    for (int first = 0; first < lines; first += 2 * FourierLanes)
    {
      const int inRe = std::min(FourierLanes, lines - first);
      const int inIm = std::clamp(lines - first - FourierLanes, 0, FourierLanes);
      for (int k = 0; k < half; ++k)
      {
        const float* from = &quarter[static_cast<std::size_t>(first) * lineStep + static_cast<std::size_t>(k) * step];
        float* re = &pack.Re[static_cast<std::size_t>(k) * FourierLanes];
        float* im = &pack.Im[static_cast<std::size_t>(k) * FourierLanes];
        for (int lane = 0; lane < inRe; ++lane)
        {
          re[lane] = from[static_cast<std::ptrdiff_t>(lane) * lineStep];
        }
        std::fill(re + inRe, re + FourierLanes, 0.0f);
        for (int lane = 0; lane < inIm; ++lane)
        {
          im[lane] = from[static_cast<std::ptrdiff_t>(FourierLanes + lane) * lineStep];
        }
        std::fill(im + inIm, im + FourierLanes, 0.0f);
        if (k > 0 && 2 * k != length)
        {
          const std::size_t opposite = static_cast<std::size_t>(length - k) * FourierLanes;
          std::copy(re, re + FourierLanes, &pack.Re[opposite]);
          std::copy(im, im + FourierLanes, &pack.Im[opposite]);
        }
      }
      fourier.Backward(pack);
      for (int k = 0; k < half; ++k)
      {
        float* to = &quarter[static_cast<std::size_t>(first) * lineStep + static_cast<std::size_t>(k) * step];
        const std::size_t at = static_cast<std::size_t>(k) * FourierLanes;
        for (int lane = 0; lane < inRe; ++lane)
        {
          to[static_cast<std::ptrdiff_t>(lane) * lineStep] = pack.Re[at + lane];
        }
        for (int lane = 0; lane < inIm; ++lane)
        {
          to[static_cast<std::ptrdiff_t>(FourierLanes + lane) * lineStep] = pack.Im[at + lane];
        }
      }
    }
  };
  transform(this->Up, scratch.Up, width, 1, width);
  transform(this->Across, scratch.Across, this->Quarter[1], width, 1);
}

double WindField::WavePower(int component, int frequency, Scratch& scratch) const
{
  const float hertz = static_cast<float>(frequency / this->Grid.Period());
  const std::vector<float>& delay = this->Delay[component];
  const std::vector<float>& still = this->Still[component];
  for (std::size_t n = 0; n < delay.size(); ++n)
  {
    // Root coherence gamma = exp(-((f Delay)^2 + Still^2)^(1/2)) (eqs. 11 and 12), at all separations
    const float moving = hertz * delay[n];
    const float decay = still[n] == 0.0f ? moving : std::sqrt(moving * moving + still[n] * still[n]);
    scratch.Power[n] = decay > NoCoherence ? 0.0f : std::exp(-decay);
  }
  // Algorithm 3, step 2: W(k) = sum over separations r of gamma(r) exp(-i k . r); what is negative is clipped
  this->TransformEven(scratch.Power, scratch);
  std::vector<float>& power = scratch.Power;
  for (float& value : power)
  {
    value = std::max(value, 0.0f);
  }
  // Coherence 1 at separation 0 means that the powers sum to the number of cells.
  const double cells = static_cast<double>(this->Padded[0]) * this->Padded[1];
  const double sum = WholeSum(power, this->Quarter, this->Padded);
  const float factor = static_cast<float>(cells / sum);
  for (float& value : power)
  {
    value *= factor;
  }
  return sum / cells - 1.0;
}

double WindField::CoherenceErrorOf(int component, int frequency, Scratch& scratch) const
{
  const double hertz = frequency / this->Grid.Period();
  const double cells = static_cast<double>(this->Padded[0]) * this->Padded[1];
  this->TransformEven(scratch.Power, scratch);
  double worst = 0.0;
  for (int k = 0; k < this->Grid.Count[2]; ++k)
  {
    for (int j = 0; j < this->Grid.Count[1]; ++j)
    {
      const double wanted =
        RootCoherence(this->Model, component, hertz, j * this->Grid.LateralSpacing, k * this->Grid.VerticalSpacing);
      const double got = scratch.Power[static_cast<std::size_t>(k) * this->Quarter[0] + j] / cells;
      worst = std::max(worst, std::abs(got - wanted));
    }
  }
  return worst;
}

bool WindField::HasStress() const
{
  return this->Synthesis.ShearStress && this->Component == WindComponents - 1;
}

double WindField::PowersOfBoth(int frequency, Scratch& scratch) const
{
  const std::vector<float> up = scratch.Power;
  this->WavePower(0, frequency, scratch);
  std::vector<float>& both = scratch.Power;
  for (std::size_t n = 0; n < up.size(); ++n)
  {
    both[n] = std::sqrt(both[n] * up[n]);
  }
  // With the same xi: E A_u A_w* = sum over k of (W_u W_w)^(1/2) / N
  const double likeness =
    WholeSum(both, this->Quarter, this->Padded) / (static_cast<double>(this->Padded[0]) * this->Padded[1]);
  scratch.Power = up;
  return likeness;
}

std::vector<float> WindField::SharedPart(int frequency, double likeness) const
{
  const double hertz = frequency / this->Grid.Period();
  std::vector<float> parts(this->Grid.Count[2]);
  for (int layer = 0; layer < this->Grid.Count[2]; ++layer)
  {
    const double height = this->Grid.Height(layer);
    const double both = std::sqrt(
      SpectralDensity(this->Model, 0, hertz, height) * SpectralDensity(this->Model, this->Component, hertz, height));
    // g = C_uw / (S_u S_w)^(1/2), over the likeness of the planes
    const double part = ShearDensity(this->Model, hertz, height) / (both * likeness);
    parts[layer] = static_cast<float>(std::clamp(part, -1.0, 1.0));
  }
  return parts;
}

void WindField::SumWaves(int frequency, const Plane& plane, Scratch& scratch) const
{
  const double likeness = this->HasStress() ? this->PowersOfBoth(frequency, scratch) : 0.0;
  const std::size_t cells = static_cast<std::size_t>(this->Padded[0]) * this->Padded[1];
  // Algorithm 3, step 3: A(y, z) = sum over k of (W / N)^(1/2) xi(k) exp(i k . r), with E |xi|^2 = 1 and N cells, so
  // that E A A'* = gamma
  for (float& power : scratch.Power)
  {
    power = std::sqrt(power / static_cast<float>(cells));
  }
  std::vector<float> parts;
  if (this->HasStress())
  {
    parts = this->SharedPart(frequency, likeness);
    this->AddWaves(0, frequency, true, parts, plane, scratch);
    for (float& part : parts)
    {
      // (1 - g^2)^(1/2): the power stays as it is
      part = std::sqrt(std::max(0.0f, 1.0f - part * part));
    }
  }
  this->AddWaves(this->Component, frequency, parts.empty(), parts, plane, scratch);
}

/// Adds waves with the random factors of a component, as large in each layer as its share; no shares stand for ones.
void WindField::AddWaves(int component, int frequency, bool isFirst, const std::vector<float>& shares,
  const Plane& plane, Scratch& scratch) const
{
  const std::size_t cells = static_cast<std::size_t>(this->Padded[0]) * this->Padded[1];
  WindFactors(this->Synthesis, component, frequency, 0, cells, scratch.Re.data(), scratch.Im.data());
  this->SumUp(scratch);
  this->SumAcross(frequency, isFirst, shares, plane, scratch);
}

/// The sum over wave numbers up: columns side by side; only the layers of the grid are kept.
void WindField::SumUp(Scratch& scratch) const
{
  const int width = this->Padded[0];
  const int height = this->Padded[1];
  const int layers = this->Grid.Count[2];
  for (int first = 0; first < width; first += FourierLanes)
  {
    const int lanes = std::min(FourierLanes, width - first);
    for (int k = 0; k < height; ++k)
    {
      const float* amplitude = &scratch.Power[static_cast<std::size_t>(std::min(k, height - k)) * this->Quarter[0]];
      const std::size_t from = static_cast<std::size_t>(k) * width + first;
      const std::size_t to = static_cast<std::size_t>(k) * FourierLanes;
      for (int lane = 0; lane < lanes; ++lane)
      {
        const float factor = amplitude[std::min(first + lane, width - first - lane)];
        scratch.Up.Re[to + lane] = factor * scratch.Re[from + lane];
        scratch.Up.Im[to + lane] = factor * scratch.Im[from + lane];
      }
    }
    this->Up.Backward(scratch.Up);
    for (int k = 0; k < layers; ++k)
    {
      const std::size_t from = static_cast<std::size_t>(k) * FourierLanes;
      Take(&scratch.Up.Re[from], lanes, &scratch.Re[static_cast<std::size_t>(k) * width + first]);
      Take(&scratch.Up.Im[from], lanes, &scratch.Im[static_cast<std::size_t>(k) * width + first]);
    }
  }
}

/// The sum over wave numbers across: layers side by side, each scaled by its own spectrum; only the columns of the grid
/// are kept.
void WindField::SumAcross(
  int frequency, bool isFirst, const std::vector<float>& shares, const Plane& plane, Scratch& scratch) const
{
  const int width = this->Padded[0];
  const int layers = this->Grid.Count[2];
  const double step = 1.0 / this->Grid.Period();
  for (int first = 0; first < layers; first += FourierLanes)
  {
    const int lanes = std::min(FourierLanes, layers - first);
    float scale[FourierLanes] = {};
    for (int lane = 0; lane < lanes; ++lane)
    {
      // Fourier coefficient c = A (S(f, z) df / 2)^(1/2): u = sum over f of 2 Re(c exp(2 pi i f t)) has the variance
      // sum S df (Shinozuka and Deodatis 1991)
      const double density =
        SpectralDensity(this->Model, this->Component, frequency * step, this->Grid.Height(first + lane));
      scale[lane] = static_cast<float>(std::sqrt(0.5 * density * step));
      scale[lane] *= shares.empty() ? 1.0f : shares[first + lane];
    }
    for (int lane = 0; lane < lanes; ++lane)
    {
      const std::size_t row = static_cast<std::size_t>(first + lane) * width;
      for (int j = 0; j < width; ++j)
      {
        scratch.Across.Re[static_cast<std::size_t>(j) * FourierLanes + lane] = scratch.Re[row + j];
        scratch.Across.Im[static_cast<std::size_t>(j) * FourierLanes + lane] = scratch.Im[row + j];
      }
    }
    this->Across.Backward(scratch.Across);
    for (int j = 0; j < this->Grid.Count[1]; ++j)
    {
      const std::size_t from = static_cast<std::size_t>(j) * FourierLanes;
      const std::size_t to = static_cast<std::size_t>(j) * layers + first;
      for (int lane = 0; lane < lanes; ++lane)
      {
        const float re = scale[lane] * scratch.Across.Re[from + lane];
        const float im = scale[lane] * scratch.Across.Im[from + lane];
        plane.Re[to + lane] = isFirst ? re : plane.Re[to + lane] + re;
        plane.Im[to + lane] = isFirst ? im : plane.Im[to + lane] + im;
      }
    }
  }
}

void WindField::TakeError()
{
  for (float error : this->BlockError)
  {
    this->CoherenceError = std::max(this->CoherenceError, static_cast<double>(error));
  }
}

void WindField::FinishPlanes()
{
  this->TakeError();
  if (!this->Synthesis.NormalizeVariance)
  {
    return;
  }
  for (int frequency = 1; frequency <= this->Grid.Waves(); ++frequency)
  {
    const Plane plane = this->KeptPlane(frequency);
    this->AddPower(plane.Re, plane.Im);
  }
  this->TakeLayerFactors();
}

/// Adds the power of a plane of all lines. The variance of a periodic line is the sum over its Fourier coefficients.
void WindField::AddPower(const float* re, const float* im)
{
  const int layers = this->Grid.Count[2];
  const std::size_t lines = this->Grid.NumberOfLines();
  for (std::size_t line = 0; line < lines; ++line)
  {
    const double real = re[line];
    const double imaginary = im[line];
    // 2 |c|^2, the mean over the lines of a layer
    this->LayerPower[line % layers] += 2.0 * (real * real + imaginary * imaginary) / this->Grid.Count[1];
  }
}

/// Algorithm 3, step 5, with the integral of S over all f in place of the sum over those of the field: sigma = I U.
void WindField::TakeLayerFactors()
{
  const double wants = Variance(this->Model, this->Component);
  for (std::size_t layer = 0; layer < this->LayerPower.size(); ++layer)
  {
    const double has = this->LayerPower[layer];
    this->LayerFactor[layer] = has > 0.0 ? static_cast<float>(std::sqrt(wants / has)) : 1.0f;
  }
}

LinePack WindField::RoomForLines() const
{
  return LinePack(static_cast<std::size_t>(this->Grid.Count[0]) / 2 + 1); // half a line and a number
}

void WindField::MakeLines(std::size_t pack, LinePack& values, float* velocities) const
{
  const std::size_t lines = this->NumberOfKept();
  const std::size_t first = pack * FourierLanes;
  const int lanes = static_cast<int>(std::min<std::size_t>(FourierLanes, lines - first));
  const int length = this->Grid.Count[0];
  const int layers = this->Grid.Count[2];
  for (int frequency = 0; frequency <= length / 2; ++frequency)
  {
    const std::size_t from = static_cast<std::size_t>(frequency) * lines + first;
    const std::size_t to = static_cast<std::size_t>(frequency) * FourierLanes;
    if (frequency == 0 || frequency > this->Grid.Waves() || lanes < FourierLanes)
    {
      std::fill_n(&values.Re[to], FourierLanes, 0.0f);
      std::fill_n(&values.Im[to], FourierLanes, 0.0f);
    }
    if (frequency > 0 && frequency <= this->Grid.Waves())
    {
      // Planes are far apart in memory.
      Prefetch(this->PlaneRe.data() + std::min(from + PlanesAhead * lines, this->PlaneRe.size()));
      Prefetch(this->PlaneIm.data() + std::min(from + PlanesAhead * lines, this->PlaneIm.size()));
      Take(&this->PlaneRe[from], lanes, &values.Re[to]);
      Take(&this->PlaneIm[from], lanes, &values.Im[to]);
    }
  }
  // Algorithm 3, step 4: u(t) = sum over f of c exp(2 pi i f t), with c(-f) = c*(f)
  this->Along.Backward(values);
  for (int lane = 0; lane < lanes; ++lane)
  {
    const std::size_t across = (first + lane) / layers;
    const int layer = static_cast<int>((first + lane) % layers);
    const float mean =
      this->Component == 0 ? static_cast<float>(MeanSpeed(this->Model, this->Grid.Height(layer))) : 0.0f;
    const float factor = this->LayerFactor[layer];
    float* line =
      velocities + (static_cast<std::size_t>(layer) * this->Columns.Count() + across) * length * WindComponents;
    // Taylor's hypothesis, eq. 14: what arrives later is farther upwind, so that the line runs against time
    const auto put = [&](int time, float value) {
      const int index = time == 0 ? 0 : length - time;
      line[static_cast<std::size_t>(index) * WindComponents + this->Component] = mean + factor * value;
    };
    for (int pair = 0; pair < length / 2; ++pair)
    {
      put(2 * pair, values.Re[static_cast<std::size_t>(pair) * FourierLanes + lane]);
      put(2 * pair + 1, values.Im[static_cast<std::size_t>(pair) * FourierLanes + lane]);
    }
  }
}

void WindField::MakeAllLines(float* velocities, const ParallelFor& parallel) const
{
  parallel(this->NumberOfPacks(), [&](std::size_t begin, std::size_t end) {
    LinePack room = this->RoomForLines();
    for (std::size_t pack = begin; pack < end; ++pack)
    {
      this->MakeLines(pack, room, velocities);
    }
  });
}

std::vector<float> WindField::Make(const ParallelFor& parallel)
{
  std::vector<float> velocities(this->Grid.NumberOfLines() * this->Grid.Count[0] * WindComponents);
  for (int component = 0; component < WindComponents; ++component)
  {
    this->BeginComponent(component);
    parallel(this->NumberOfBlocks(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t block = begin; block < end; ++block)
      {
        this->MakePlanes(block);
      }
    });
    this->FinishPlanes();
    this->MakeAllLines(velocities.data(), parallel);
  }
  return velocities;
}

}
