// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sea/WaveOrbits.h"

#include "Numerics/Constants.h"
#include "Numerics/SimdClones.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <cstring>

namespace littoral
{

namespace
{

/// Points that a pass of the single precision kernel holds in the first-level cache.
constexpr int BlockSize = 256;
/// k h from which the bed is not felt in single precision.
constexpr double DeepInSingle = 20.0;
/// k h below which b = r sinh k(z+h) / sinh kh would lose digits as a difference of exponentials.
constexpr double ShallowInSingle = 1.0;

/// Bits of the fraction of a phase in turns.
constexpr int TurnBits = 26;
/// Added to turns, it leaves their fraction in the last bits of the sum, in units of 2^-26.
constexpr double AlignTurns = 1.5 * (1 << TurnBits);
/// Adding and subtracting it rounds to whole numbers.
constexpr float RoundSingle = 12582912.0f;

LITTORAL_INLINE std::uint32_t BitsOf(float x)
{
  std::uint32_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

LITTORAL_INLINE float FloatOf(std::uint32_t bits)
{
  float x;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

struct Powers
{
  float Up;   ///< 2^x
  float Down; ///< 2^-x
};

/// Powers of 2 for |x| <= 60, to 1.2e-7.
LITTORAL_INLINE Powers PowersOf2(float x)
{
  const float rounded = x + RoundSingle;
  const float f = x - (rounded - RoundSingle);
  const float q = f * f;
  // 2^f - 1 and 2^-f - 1 differ in the sign of the odd powers
  const float even = q * (0.2402265f + q * (0.009618057f + q * 0.00015461f));
  const float odd = f * (0.6931472f + q * (0.05550327f + q * 0.001340043f));
  const std::uint32_t exponent = BitsOf(rounded) << 23;
  return { FloatOf(BitsOf(1.0f + (even + odd)) + exponent), FloatOf(BitsOf(1.0f + (even - odd)) - exponent) };
}

/// Phases of a train at points, in units of 2^-26 turns; whole turns overflow.
LITTORAL_WIDE_SIMD_CLONES void ReducePhases(const double* __restrict x, const double* __restrict y, double kx,
  double ky, double phase, int count, std::uint32_t* __restrict turns)
{
  const double aligned = phase + AlignTurns;
  for (int i = 0; i < count; ++i)
  {
    const double sum = kx * x[i] + (ky * y[i] + aligned);
    std::uint64_t bits;
    std::memcpy(&bits, &sum, sizeof bits);
    turns[i] = static_cast<std::uint32_t>(bits);
  }
}

struct SineCosine
{
  float Sine;
  float Cosine;
};

/// Sine and cosine of a phase in units of 2^-26 turns, to 3e-7.
LITTORAL_INLINE SineCosine SineAndCosine(std::uint32_t turns)
{
  // phi = half turns + u, u at most a quarter turn: an odd half turn changes both signs
  const std::uint32_t halves = turns << (32 - TurnBits);
  const std::uint32_t rest = halves << 1;
  const std::uint32_t sign = (halves ^ rest) & 0x80000000u;
  const float u = 0x1p-33f * static_cast<float>(static_cast<std::int32_t>(rest));
  // Polynomials in q = u^2, in pairs of terms, which do not wait for each other
  const float q = u * u;
  const float q2 = q * q;
  const float sine =
    u * ((6.28318528f + q * -41.34168061f) + q2 * ((81.60247637f + q * -76.58117264f) + q2 * 39.75982708f));
  const float cosine =
    (0.9999999535f + q * -19.73917143f) + q2 * ((64.93459063f + q * -85.24033032f) + q2 * 56.24238047f);
  return { FloatOf(BitsOf(sine) ^ sign), FloatOf(BitsOf(cosine) ^ sign) };
}

// Semi-axes a, b over the amplitude's factor s = Train::Scale.

LITTORAL_WIDE_SIMD_CLONES void DeepAxes(
  const float* __restrict z, float octaves, int count, float* __restrict a, float* __restrict b)
{
  const float deepest = -60.0f / octaves;
  for (int i = 0; i < count; ++i)
  {
    // a = b = s e^kz
    a[i] = PowersOf2(octaves * (z[i] < deepest ? deepest : z[i])).Up;
    b[i] = a[i];
  }
}

LITTORAL_WIDE_SIMD_CLONES void FiniteAxes(
  const float* __restrict z, float octaves, float mirror, int count, float* __restrict a, float* __restrict b)
{
  for (int i = 0; i < count; ++i)
  {
    // a, b = s (e^kz +- e^-2kh e^-kz), s = r / (1 - e^-2kh)
    const Powers e = PowersOf2(octaves * z[i]);
    const float reflected = mirror * e.Down;
    a[i] = e.Up + reflected;
    b[i] = e.Up - reflected;
  }
}

LITTORAL_WIDE_SIMD_CLONES void ShallowAxes(
  const float* __restrict heightOverBed, float waveNumber, int count, float* __restrict a, float* __restrict b)
{
  for (int i = 0; i < count; ++i)
  {
    const float x = waveNumber * heightOverBed[i]; // 0 to 1
    const float q = x * x;
    // a, b = s (cosh x, sinh x), s = r / sinh kh, x = k (z + h)
    a[i] = 1.0f + q * (1 / 2.0f + q * (1 / 24.0f + q * (1 / 720.0f + q * (1 / 40320.0f))));
    b[i] = x * (1.0f + q * (1 / 6.0f + q * (1 / 120.0f + q * (1 / 5040.0f + q * (1 / 362880.0f)))));
  }
}

/// The smallest and the largest of some numbers, and of the two given.
LITTORAL_WIDE_SIMD_CLONES void FindBounds(const int* numbers, int count, int& least, int& most)
{
  int low = least;
  int high = most;
  for (int i = 0; i < count; ++i)
  {
    low = std::min(low, numbers[i]);
    high = std::max(high, numbers[i]);
  }
  least = low;
  most = high;
}

/// Amplitude 0 at the points that have fewer trains.
LITTORAL_WIDE_SIMD_CLONES void Mask(
  const int* __restrict counts, int train, int count, float* __restrict a, float* __restrict b)
{
  for (int i = 0; i < count; ++i)
  {
    a[i] = counts[i] > train ? a[i] : 0.0f;
    b[i] = counts[i] > train ? b[i] : 0.0f;
  }
}

/// Multiplies amplitudes by a part for each point.
LITTORAL_WIDE_SIMD_CLONES void Scale(const float* __restrict parts, int count, float* __restrict a, float* __restrict b)
{
  for (int i = 0; i < count; ++i)
  {
    a[i] *= parts[i];
    b[i] *= parts[i];
  }
}

/// Adds f a sin phi along the train, f b cos phi upwards.
LITTORAL_WIDE_SIMD_CLONES void AddDisplacement(const std::uint32_t* __restrict turns, const float* __restrict a,
  const float* __restrict b, float fx, float fy, float fz, int count, float* __restrict x, float* __restrict y,
  float* __restrict z)
{
  for (int i = 0; i < count; ++i)
  {
    const SineCosine phi = SineAndCosine(turns[i]);
    const float along = a[i] * phi.Sine;
    x[i] += fx * along;
    y[i] += fy * along;
    z[i] += fz * (b[i] * phi.Cosine);
  }
}

/// a sin phi, a cos phi, b sin phi, b cos phi.
LITTORAL_WIDE_SIMD_CLONES void FindProducts(const std::uint32_t* __restrict turns, const float* __restrict a,
  const float* __restrict b, int count, float* __restrict aSine, float* __restrict aCosine, float* __restrict bSine,
  float* __restrict bCosine)
{
  for (int i = 0; i < count; ++i)
  {
    const SineCosine phi = SineAndCosine(turns[i]);
    aSine[i] = a[i] * phi.Sine;
    aCosine[i] = a[i] * phi.Cosine;
    bSine[i] = b[i] * phi.Sine;
    bCosine[i] = b[i] * phi.Cosine;
  }
}

/// Adds f p along the train, f q upwards.
LITTORAL_WIDE_SIMD_CLONES void AddMotion(const float* __restrict p, const float* __restrict q, float fx, float fy,
  float fz, int count, float* __restrict x, float* __restrict y, float* __restrict z)
{
  for (int i = 0; i < count; ++i)
  {
    x[i] += fx * p[i];
    y[i] += fy * p[i];
    z[i] += fz * q[i];
  }
}

LITTORAL_WIDE_SIMD_CLONES void AddGradient(const float* __restrict p, const float* __restrict q, const float* factor,
  int count, float* __restrict xx, float* __restrict xy, float* __restrict yy, float* __restrict zx,
  float* __restrict zy)
{
  const float fxx = factor[0];
  const float fxy = factor[1];
  const float fyy = factor[2];
  const float fzx = factor[3];
  const float fzy = factor[4];
  for (int i = 0; i < count; ++i)
  {
    xx[i] += fxx * p[i];
    xy[i] += fxy * p[i];
    yy[i] += fyy * p[i];
    zx[i] += fzx * q[i];
    zy[i] += fzy * q[i];
  }
}

/// Adds what a train makes with the sums of those before it to the level and its slopes, and the train to the sums.
LITTORAL_WIDE_SIMD_CLONES void AddLevelSums(const std::uint32_t* __restrict turns, const float* __restrict a, float up,
  float k, float dx, float dy, int count, float (*__restrict sines)[BlockSize], float (*__restrict cosines)[BlockSize],
  float* __restrict z, float* __restrict zx, float* __restrict zy)
{
  for (int i = 0; i < count; ++i)
  {
    const SineCosine phi = SineAndCosine(turns[i]);
    const float s = up * a[i] * phi.Sine;
    const float c = up * a[i] * phi.Cosine;
    // a_i a_j k_j cos(phi_i - phi_j), k_j <= k_i, half of it for i = j
    z[i] += c * (cosines[0][i] + 0.5f * k * c) + s * (sines[0][i] + 0.5f * k * s);
    // -a_i a_j k_j (k_i - k_j) sin(phi_i - phi_j)
    const float slope = (s * cosines[1][i] - c * sines[1][i]) - k * (s * cosines[0][i] - c * sines[0][i]);
    zx[i] += dx * slope;
    zy[i] += dy * slope;
    sines[0][i] += k * s;
    cosines[0][i] += k * c;
    sines[1][i] += k * k * s;
    cosines[1][i] += k * k * c;
  }
}

/// Adds f a cos(phi + w age), from a sin phi and a cos phi.
LITTORAL_WIDE_SIMD_CLONES void AddPastGradient(const float* __restrict aSine, const float* __restrict aCosine,
  float sine, float cosine, const float* factor, int count, float* __restrict xx, float* __restrict xy,
  float* __restrict yy)
{
  const float fxx = factor[0];
  const float fxy = factor[1];
  const float fyy = factor[2];
  for (int i = 0; i < count; ++i)
  {
    const float p = cosine * aCosine[i] - sine * aSine[i];
    xx[i] += fxx * p;
    xy[i] += fxy * p;
    yy[i] += fyy * p;
  }
}

/// Sums of the trains of a surface so far, k a e^(i phi) and k2 a e^(i phi).
struct LevelSums
{
  std::complex<double> First;
  std::complex<double> Second;

  /// Adds a train to the sums and what it makes with them to a level; returns the slope of that along the train.
  double Add(double k, double amplitude, double phase, double& level)
  {
    const std::complex<double> own = std::polar(amplitude, phase);
    // a_i Re e^(i phi_i) conj(sum over k_j < k_i of k_j a_j e^(i phi_j) + k_i a_i e^(i phi_i) / 2)
    level += (own * std::conj(this->First + 0.5 * k * own)).real();
    const double slope = (own * std::conj(this->Second - k * this->First)).imag();
    this->First += k * own;
    this->Second += k * k * own;
    return slope;
  }
};

/// Centers by coordinate; z from sea level, not outside of the water, and the height over the bed.
LITTORAL_WIDE_SIMD_CLONES void ReadCenters(const float* __restrict centers, double seaLevel, double depth, int count,
  double* __restrict x, double* __restrict y, float* __restrict z, float* __restrict heightOverBed)
{
  for (int i = 0; i < count; ++i)
  {
    x[i] = centers[3 * i];
    y[i] = centers[3 * i + 1];
    const double inWater = std::min(0.0, std::max(centers[3 * i + 2] - seaLevel, -depth));
    z[i] = static_cast<float>(inWater);
    heightOverBed[i] = static_cast<float>(inWater + depth);
  }
}

LITTORAL_WIDE_SIMD_CLONES void StoreVectors(const float (*__restrict sums)[BlockSize], int count, float* __restrict to)
{
  for (int i = 0; i < count; ++i)
  {
    to[3 * i] = sums[0][i];
    to[3 * i + 1] = sums[1][i];
    to[3 * i + 2] = sums[2][i];
  }
}

/// Adds numbers to others in double precision.
LITTORAL_WIDE_SIMD_CLONES void AddNumbers(const float* __restrict numbers, int count, float* __restrict to)
{
  for (int i = 0; i < count; ++i)
  {
    to[i] = static_cast<float>(static_cast<double>(to[i]) + numbers[i]);
  }
}

LITTORAL_WIDE_SIMD_CLONES void StoreGradients(
  const float (*__restrict sums)[BlockSize], int components, int count, float* __restrict to)
{
  for (int i = 0; i < count; ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      to[components * i + c] = sums[c][i];
    }
  }
}

}

/// Points of a block, an array a coordinate, and what is summed over trains.
struct alignas(64) WaveOrbits::Block
{
  double X[BlockSize];
  double Y[BlockSize];
  float Z[BlockSize]; ///< from sea level, at most 0
  float HeightOverBed[BlockSize];
  float DriftX[BlockSize]; ///< of Stokes [m/s]
  float DriftY[BlockSize];
  std::uint32_t Turns[BlockSize];
  float A[BlockSize];
  float B[BlockSize];
  float Shares[BlockSize]; ///< of the train at hand, where points have sets of their own
  float ASine[BlockSize];
  float ACosine[BlockSize];
  float BSine[BlockSize];
  float BCosine[BlockSize];
  float Displacement[3][BlockSize];
  float Velocity[3][BlockSize];
  float Acceleration[3][BlockSize];
  float Gradient[5][BlockSize];
  float VelocityGradient[5][BlockSize];
  float PastGradient[3 * MostAges][BlockSize];
  float LevelSine[2][BlockSize]; ///< sums of k a sin phi, k2 a sin phi
  float LevelCosine[2][BlockSize];
};

OrbitAxes AxesAt(const WaveTrain& train, double height, double depth)
{
  // d = r e^kz / (1 - e^-2kh):  a = d (1 + e^-2k(z+h)),  b = d (1 - e^-2k(z+h))
  const double z = std::min(0.0, std::max(height, -depth));
  const double k = train.WaveNumber;
  const double d = train.Amplitude * std::exp(k * z) / -std::expm1(-2.0 * k * depth);
  const double twice = -2.0 * k * (z + depth);
  return { d * (1.0 + std::exp(twice)), d * -std::expm1(twice) };
}

Vector3 SurfaceNormal(const double g[5])
{
  const Vector3 alongX(1.0 + g[0], g[1], g[3]);
  const Vector3 alongY(g[1], 1.0 + g[2], g[4]);
  return Normalised(glm::cross(alongX, alongY));
}

double SurfaceJacobian(const double g[3])
{
  return (1.0 + g[0]) * (1.0 + g[2]) - g[1] * g[1];
}

WaveOrbits::WaveOrbits(const SeaState& sea, const WaveOrbitOptions& options, double time)
  : Sea(sea)
  , Options(options)
  , Time(time)
{
  for (const WaveTrain& wave : sea.Trains)
  {
    this->Trains.push_back(this->MomentOf(wave, sea.Depth));
    this->Trains.back().Last = static_cast<int>(this->Trains.size()) - 1;
  }
  this->BySums = sea.Order == SeaOrder::Second && options.Bound.Motion == BoundMotion::Surface &&
    options.Choppiness == 1.0 && IsSortedLongCrestedDeep(sea);
  if (sea.Order == SeaOrder::Second && !this->BySums)
  {
    this->Waves = BoundWavesOf(sea, options.Bound, options.Choppiness);
  }
  for (const BoundWave& wave : this->Waves)
  {
    this->Bound.push_back(this->MomentOf(wave));
  }
}

/// A train at the moment.
WaveOrbits::Train WaveOrbits::MomentOf(const WaveTrain& wave, double depth) const
{
  Train train;
  const double k = wave.WaveNumber;
  train.DirectionX = std::cos(wave.Direction);
  train.DirectionY = std::sin(wave.Direction);
  train.X = k * train.DirectionX;
  train.Y = k * train.DirectionY;
  train.Frequency = wave.AngularFrequency;
  double atFixedPoint = wave.AngularFrequency;
  // Frequency at a fixed point: w + k . U
  if (this->Options.DopplerShift)
  {
    atFixedPoint += train.X * this->Options.Current[0] + train.Y * this->Options.Current[1];
  }
  train.Phase = std::remainder(wave.Phase - std::remainder(atFixedPoint * this->Time, TwoPi), TwoPi);
  const double relative = k * depth;
  train.Kind = relative > DeepInSingle ? Form::Deep : relative > ShallowInSingle ? Form::Finite : Form::Shallow;
  train.Octaves = static_cast<float>(k / std::log(2.0));
  train.WaveNumber = static_cast<float>(k);
  const double part = train.Kind == Form::Shallow ? std::sinh(relative) : -std::expm1(-2.0 * relative);
  train.Scale = static_cast<float>(wave.Amplitude / part);
  train.Mirror = static_cast<float>(std::exp(-2.0 * relative));
  for (std::size_t age = 0; age < this->Options.Ages.size(); ++age)
  {
    train.PastCosine[age] = static_cast<float>(std::cos(atFixedPoint * this->Options.Ages[age]));
    train.PastSine[age] = static_cast<float>(std::sin(atFixedPoint * this->Options.Ages[age]));
  }
  return train;
}

/// A bound wave at the moment, as a train of amplitude 1 with a profile, directions and a rise of its own.
WaveOrbits::Train WaveOrbits::MomentOf(const BoundWave& wave) const
{
  Train train = this->MomentOf(WaveTrain{ 1.0, 0.0, wave.Profile, 0.0, 0.0 }, this->Sea.Depth);
  const Train& first = this->Trains[wave.First];
  const Train& second = this->Trains[wave.Second];
  const double own = wave.Sign == 0.0 ? 0.0 : 1.0;
  train.X = own * first.X + wave.Sign * second.X;
  train.Y = own * first.Y + wave.Sign * second.Y;
  train.Phase = std::remainder(own * first.Phase + wave.Sign * second.Phase, TwoPi);
  train.Frequency = own * first.Frequency + wave.Sign * second.Frequency;
  train.DirectionX = wave.Along[0];
  train.DirectionY = wave.Along[1];
  train.IsFree = false;
  train.Up = static_cast<float>(-wave.Up);
  train.Last = std::max(wave.First, wave.Second);
  train.First = std::min(wave.First, wave.Second);
  return train;
}

/// Half of K_x H_y + K_y H_x.
double WaveOrbits::Cross(const Train& bound)
{
  return 0.5 * (bound.X * bound.DirectionY + bound.Y * bound.DirectionX);
}

/// The part of a bound wave that acts.
float WaveOrbits::ShareOf(const Train& bound, const float* shares) const
{
  return shares ? shares[bound.First] * shares[bound.Last] : 1.0f;
}

std::array<double, 2> WaveOrbits::StokesVelocity(double height, std::size_t trains, const float* shares) const
{
  std::array<double, 2> drift{ 0.0, 0.0 };
  for (std::size_t n = 0; n < std::min(trains, this->Trains.size()); ++n)
  {
    const OrbitAxes axes = AxesAt(this->Sea.Trains[n], height, this->Sea.Depth);
    // Stokes (1847): w k r^2 cosh 2k(z+h) / (2 sinh^2 kh) = w k (a^2 + b^2) / 2, along d
    const double share = shares ? shares[n] : 1.0;
    const double half = 0.5 * share * share * this->Trains[n].Frequency *
      (axes.Horizontal * axes.Horizontal + axes.Vertical * axes.Vertical);
    drift[0] += half * this->Trains[n].X;
    drift[1] += half * this->Trains[n].Y;
  }
  return drift;
}

/// The part of a train that acts on all points of a block; where they have parts of their own, 1, or 0 if none acts.
float WaveOrbits::Weigh(
  Block& block, const OrbitRequest<float>& request, const Train& train, std::size_t begin, int count) const
{
  const auto of = [&](const float* shares) {
    return !train.IsFree ? this->ShareOf(train, shares) : shares ? shares[train.Last] : 1.0f;
  };
  if (!request.ShareSets)
  {
    return of(request.Shares);
  }
  float most = 0.0f;
  for (int i = 0; i < count; ++i)
  {
    const auto set = static_cast<std::size_t>(request.ShareSets[begin + static_cast<std::size_t>(i)]);
    block.Shares[i] = of(request.Shares + set * this->Trains.size());
    most = std::max(most, block.Shares[i]);
  }
  return most > 0.0f ? 1.0f : 0.0f;
}

void WaveOrbits::Evaluate(const OrbitRequest<double>& request, std::size_t begin, std::size_t end) const
{
  const double chop = this->Options.Choppiness;
  for (std::size_t i = begin; i < end; ++i)
  {
    const std::size_t set = request.ShareSets ? static_cast<std::size_t>(request.ShareSets[i]) : 0;
    const float* shares = request.Shares ? request.Shares + set * this->Trains.size() : nullptr;
    const double* center = request.Centers + 3 * i;
    const double z = center[2] - this->Sea.SeaLevel;
    std::size_t trains = this->Trains.size();
    if (request.TrainCounts)
    {
      trains = std::min<std::size_t>(trains, std::max(0, request.TrainCounts[i]));
    }
    std::array<double, 2> drift{ 0.0, 0.0 };
    if (this->Options.StokesDrift)
    {
      drift = this->StokesVelocity(z, trains, shares);
    }
    const double x = center[0] + drift[0] * this->Time;
    const double y = center[1] + drift[1] * this->Time;
    Vector3 displacement(drift[0] * this->Time, drift[1] * this->Time, 0.0);
    Vector3 velocity(drift[0], drift[1], 0.0);
    Vector3 acceleration(0.0);
    double gradient[5] = { 0.0, 0.0, 0.0, 0.0, 0.0 };
    double shear[5] = { 0.0, 0.0, 0.0, 0.0, 0.0 };
    const auto add = [&](const Train& train, const OrbitAxes& axes, double share, double up) {
      const double a = share * chop * axes.Horizontal;
      const double b = share * up * axes.Vertical;
      // phi = k d . x - w t + phase
      const double phi = train.X * x + train.Y * y + train.Phase;
      const double s = std::sin(phi);
      const double c = std::cos(phi);
      // Displacement (a sin phi d, -b cos phi), the paper's eq. 2 at any depth
      const Vector3 orbit(a * s * train.DirectionX, a * s * train.DirectionY, -b * c);
      displacement += orbit;
      const double w = train.Frequency;
      // Its derivative by the time, phi' = -w
      velocity += w * Vector3(-a * c * train.DirectionX, -a * c * train.DirectionY, -b * s);
      acceleration -= w * w * orbit;
      // Its derivatives by the center, grad phi = k d
      gradient[0] += a * c * train.X * train.DirectionX;
      gradient[1] += train.IsFree ? a * c * train.X * train.DirectionY : a * c * Cross(train);
      gradient[2] += a * c * train.Y * train.DirectionY;
      gradient[3] += b * s * train.X;
      gradient[4] += b * s * train.Y;
      // And those of the velocity
      shear[0] += w * a * s * train.X * train.DirectionX;
      shear[1] += train.IsFree ? w * a * s * train.X * train.DirectionY : w * a * s * Cross(train);
      shear[2] += w * a * s * train.Y * train.DirectionY;
      shear[3] -= w * b * c * train.X;
      shear[4] -= w * b * c * train.Y;
    };
    LevelSums levels;
    for (std::size_t n = 0; n < trains; ++n)
    {
      const Train& train = this->Trains[n];
      const double share = shares ? shares[n] : 1.0;
      add(train, AxesAt(this->Sea.Trains[n], z, this->Sea.Depth), share, 1.0);
      if (this->BySums)
      {
        const WaveTrain& wave = this->Sea.Trains[n];
        const double slope =
          levels.Add(wave.WaveNumber, share * wave.Amplitude, train.X * x + train.Y * y + train.Phase, displacement.z);
        gradient[3] += slope * train.DirectionX;
        gradient[4] += slope * train.DirectionY;
      }
    }
    for (std::size_t n = 0; n < this->Bound.size(); ++n)
    {
      const Train& train = this->Bound[n];
      if (static_cast<std::size_t>(train.Last) < trains)
      {
        const WaveTrain profile{ 1.0, 0.0, this->Waves[n].Profile, 0.0, 0.0 };
        add(train, AxesAt(profile, z, this->Sea.Depth), this->ShareOf(train, shares), -this->Waves[n].Up);
      }
    }
    const auto store = [i](double* to, const double* from, int count) {
      if (to)
      {
        std::copy(from, from + count, to + count * i);
      }
    };
    if (request.AddsCenters)
    {
      displacement += Vector3(center[0], center[1], center[2]);
    }
    store(request.Displacement, &displacement[0], 3);
    store(request.Velocity, &velocity[0], 3);
    store(request.Acceleration, &acceleration[0], 3);
    store(request.Gradient, gradient, 5);
    store(request.VelocityGradient, shear, 5);
  }
}

void WaveOrbits::Evaluate(const OrbitRequest<float>& request, std::size_t begin, std::size_t end) const
{
  Block block;
  for (std::size_t first = begin; first < end; first += BlockSize)
  {
    this->EvaluateBlock(block, request, first, static_cast<int>(std::min<std::size_t>(BlockSize, end - first)));
  }
}

void WaveOrbits::EvaluateBlock(Block& block, const OrbitRequest<float>& request, std::size_t begin, int count) const
{
  const int* counts = request.TrainCounts ? request.TrainCounts + begin : nullptr;
  int trains = static_cast<int>(this->Trains.size());
  int shared = trains; // the first ones, which all points have
  if (counts)
  {
    int most = 0;
    FindBounds(counts, count, shared, most);
    trains = std::min(most, trains);
  }
  this->StartBlock(block, request, begin, count);
  if (this->Options.StokesDrift)
  {
    this->AddDrift(block, request, counts, request.ShareSets ? request.ShareSets + begin : nullptr, count);
  }
  for (int n = 0; n < trains; ++n)
  {
    const float share = this->Weigh(block, request, this->Trains[n], begin, count);
    if (share == 0.0f)
    {
      continue;
    }
    this->FindAxes(block, this->Trains[n], count);
    if (request.ShareSets)
    {
      Scale(block.Shares, count, block.A, block.B);
    }
    if (n >= shared)
    {
      Mask(counts, n, count, block.A, block.B);
    }
    this->AddTrain(block, request, this->Trains[n], share, count);
    if (this->BySums)
    {
      this->AddLevels(block, this->Trains[n], share, count);
    }
  }
  for (const Train& wave : this->Bound)
  {
    const float share = this->Weigh(block, request, wave, begin, count);
    if (share == 0.0f || wave.Last >= trains)
    {
      continue;
    }
    this->FindAxes(block, wave, count);
    if (request.ShareSets)
    {
      Scale(block.Shares, count, block.A, block.B);
    }
    if (wave.Last >= shared)
    {
      Mask(counts, wave.Last, count, block.A, block.B);
    }
    this->AddTrain(block, request, wave, share, count);
  }
  const auto to = [begin](float* array, int components) { return array ? array + components * begin : nullptr; };
  if (request.Displacement)
  {
    StoreVectors(block.Displacement, count, to(request.Displacement, 3));
    if (request.AddsCenters)
    {
      AddNumbers(request.Centers + 3 * begin, 3 * count, to(request.Displacement, 3));
    }
  }
  if (request.Velocity)
  {
    StoreVectors(block.Velocity, count, to(request.Velocity, 3));
  }
  if (request.Acceleration)
  {
    StoreVectors(block.Acceleration, count, to(request.Acceleration, 3));
  }
  if (request.Gradient)
  {
    StoreGradients(block.Gradient, 5, count, to(request.Gradient, 5));
  }
  if (request.PastGradient)
  {
    const int components = 3 * static_cast<int>(this->Options.Ages.size());
    StoreGradients(block.PastGradient, components, count, to(request.PastGradient, components));
  }
  if (request.VelocityGradient)
  {
    StoreGradients(block.VelocityGradient, 5, count, to(request.VelocityGradient, 5));
  }
}

/// Centers of the points; sums that are requested, and the displacement, 0.
void WaveOrbits::StartBlock(Block& block, const OrbitRequest<float>& request, std::size_t begin, int count) const
{
  ReadCenters(request.Centers + 3 * begin, this->Sea.SeaLevel, this->Sea.Depth, count, block.X, block.Y, block.Z,
    block.HeightOverBed);
  const auto zero = [count](auto& sums) {
    for (auto& row : sums)
    {
      std::fill_n(row, count, 0.0f);
    }
  };
  zero(block.Displacement);
  if (this->BySums)
  {
    zero(block.LevelSine);
    zero(block.LevelCosine);
    zero(block.Gradient);
  }
  const auto clear = [&zero](const float* requested, auto& sums) {
    if (requested)
    {
      zero(sums);
    }
  };
  clear(request.Velocity, block.Velocity);
  clear(request.Acceleration, block.Acceleration);
  clear(request.Gradient, block.Gradient);
  clear(request.VelocityGradient, block.VelocityGradient);
  clear(request.PastGradient, block.PastGradient);
}

/// Moves the centers with the Stokes drift of their trains; `counts` and `sets` as in the request, of this block.
void WaveOrbits::AddDrift(
  Block& block, const OrbitRequest<float>& request, const int* counts, const int* sets, int count) const
{
  for (int i = 0; i < count; ++i)
  {
    const std::size_t own = counts ? static_cast<std::size_t>(std::max(0, counts[i])) : this->Trains.size();
    const std::size_t set = sets ? static_cast<std::size_t>(sets[i]) : 0;
    const auto drift =
      this->StokesVelocity(block.Z[i], own, request.Shares ? request.Shares + set * this->Trains.size() : nullptr);
    block.X[i] += drift[0] * this->Time;
    block.Y[i] += drift[1] * this->Time;
    for (int axis = 0; axis < 2; ++axis)
    {
      block.Displacement[axis][i] = static_cast<float>(drift[axis] * this->Time);
      block.Velocity[axis][i] = static_cast<float>(drift[axis]);
    }
  }
}

/// The phase and the semi-axes a, b of a train.
void WaveOrbits::FindAxes(Block& block, const Train& train, int count) const
{
  constexpr double turn = 1.0 / TwoPi;
  ReducePhases(block.X, block.Y, turn * train.X, turn * train.Y, turn * train.Phase, count, block.Turns);
  switch (train.Kind)
  {
    case Form::Deep:
      DeepAxes(block.Z, train.Octaves, count, block.A, block.B);
      break;
    case Form::Finite:
      FiniteAxes(block.Z, train.Octaves, train.Mirror, count, block.A, block.B);
      break;
    case Form::Shallow:
      ShallowAxes(block.HeightOverBed, train.WaveNumber, count, block.A, block.B);
      break;
  }
}

/// Adds the motion by a train to what is requested.
void WaveOrbits::AddTrain(
  Block& block, const OrbitRequest<float>& request, const Train& train, float share, int count) const
{
  float up = share * train.Scale;
  const float chop = up * static_cast<float>(this->Options.Choppiness);
  const float dx = chop * static_cast<float>(train.DirectionX);
  const float dy = chop * static_cast<float>(train.DirectionY);
  up *= train.Up;
  // a sin phi d, -b cos phi
  float(*places)[BlockSize] = block.Displacement;
  if (!request.Velocity && !request.Acceleration && !request.Gradient && !request.VelocityGradient &&
    !request.PastGradient)
  {
    AddDisplacement(block.Turns, block.A, block.B, dx, dy, -up, count, places[0], places[1], places[2]);
    return;
  }
  FindProducts(block.Turns, block.A, block.B, count, block.ASine, block.ACosine, block.BSine, block.BCosine);
  if (request.Displacement)
  {
    AddMotion(block.ASine, block.BCosine, dx, dy, -up, count, places[0], places[1], places[2]);
  }
  const float w = static_cast<float>(train.Frequency);
  // -w a cos phi d, -w b sin phi
  if (request.Velocity)
  {
    float(*sums)[BlockSize] = block.Velocity;
    AddMotion(block.ACosine, block.BSine, -w * dx, -w * dy, -w * up, count, sums[0], sums[1], sums[2]);
  }
  // -w^2 a sin phi d, w^2 b cos phi
  if (request.Acceleration)
  {
    float(*sums)[BlockSize] = block.Acceleration;
    const float w2 = w * w;
    AddMotion(block.ASine, block.BCosine, -w2 * dx, -w2 * dy, w2 * up, count, sums[0], sums[1], sums[2]);
  }
  const float kx = static_cast<float>(train.X);
  const float ky = static_cast<float>(train.Y);
  const float cross = train.IsFree ? kx * dy : 0.5f * (kx * dy + ky * dx);
  // k_x a cos phi d_x, k_x a cos phi d_y, k_y a cos phi d_y; k_x b sin phi, k_y b sin phi
  if (request.Gradient)
  {
    float(*sums)[BlockSize] = block.Gradient;
    const float factor[5] = { kx * dx, cross, ky * dy, kx * up, ky * up };
    AddGradient(block.ACosine, block.BSine, factor, count, sums[0], sums[1], sums[2], sums[3], sums[4]);
  }
  if (request.PastGradient && train.IsFree)
  {
    this->AddPast(block, train, chop, count);
  }
  // Its derivative by the time, phi' = -w
  if (request.VelocityGradient)
  {
    float(*sums)[BlockSize] = block.VelocityGradient;
    const float factor[5] = { w * kx * dx, train.IsFree ? w * kx * dy : w * cross, w * ky * dy, -w * kx * up,
      -w * ky * up };
    AddGradient(block.ASine, block.BCosine, factor, count, sums[0], sums[1], sums[2], sums[3], sums[4]);
  }
}

/// Adds what a train of a surface makes with those before it.
void WaveOrbits::AddLevels(Block& block, const Train& train, float share, int count) const
{
  AddLevelSums(block.Turns, block.A, share * train.Scale, train.WaveNumber, static_cast<float>(train.DirectionX),
    static_cast<float>(train.DirectionY), count, block.LevelSine, block.LevelCosine, block.Displacement[2],
    block.Gradient[3], block.Gradient[4]);
}

/// Adds the gradients by a train at the ages before.
void WaveOrbits::AddPast(Block& block, const Train& train, float chop, int count) const
{
  const float dx = static_cast<float>(train.DirectionX);
  const float dy = static_cast<float>(train.DirectionY);
  const float slope = chop * static_cast<float>(std::hypot(train.X, train.Y));
  const float factor[3] = { slope * dx * dx, slope * dx * dy, slope * dy * dy };
  for (std::size_t age = 0; age < this->Options.Ages.size(); ++age)
  {
    float(*sums)[BlockSize] = block.PastGradient + 3 * age;
    AddPastGradient(
      block.ASine, block.ACosine, train.PastSine[age], train.PastCosine[age], factor, count, sums[0], sums[1], sums[2]);
  }
}

}
