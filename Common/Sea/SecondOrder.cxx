// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sea/SecondOrder.h"

#include "Numerics/Constants.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace littoral
{

namespace
{

/// Wave number over those of its trains below which a difference is that of one train and itself.
constexpr double SameTrain = 1e-6;
/// Frequency over those of its trains below which a difference stands still.
constexpr double Standing = 1e-6;
/// Bound waves over the product of their trains' amplitudes and wave numbers that nobody sees.
constexpr double Negligible = 1e-9;
/// Relative depth that stands for a wave longer than all else.
constexpr double LongWave = 1e-3;

/// A train as the kernels see it.
struct Wave
{
  double WaveNumber;
  double Depth;
  double Frequency; ///< of the dispersion relation [rad/s]
  double Tanh;      ///< tanh kh

  Wave(const WaveTrain& train, double depth)
    : WaveNumber(train.WaveNumber)
    , Depth(depth)
    , Frequency(std::sqrt(Gravity * train.WaveNumber * std::tanh(train.WaveNumber * depth)))
    , Tanh(std::tanh(train.WaveNumber * depth))
  {
  }

  double Coth() const { return 1.0 / this->Tanh; }
  /// R = w2 / g
  double Rate() const { return this->WaveNumber * this->Tanh; }
  /// k2 - R2 = k2 / cosh2 kh
  double Rest() const
  {
    const double part = this->WaveNumber / std::cosh(std::min(300.0, this->WaveNumber * this->Depth));
    return part * part;
  }
};

/// K = k_i + s k_j, along x and y.
struct Sum
{
  double X;
  double Y;
  double Length;

  Sum(const WaveTrain& a, const WaveTrain& b, double sign)
    : X(a.WaveNumber * std::cos(a.Direction) + sign * b.WaveNumber * std::cos(b.Direction))
    , Y(a.WaveNumber * std::sin(a.Direction) + sign * b.WaveNumber * std::sin(b.Direction))
    , Length(std::hypot(this->X, this->Y))
  {
  }
};

bool AreSame(const WaveTrain& a, const WaveTrain& b)
{
  return Sum(a, b, -1.0).Length < SameTrain * (a.WaveNumber + b.WaveNumber);
}

/// The waves of one pair.
class Pair
{
public:
  Pair(const SeaState& sea, int first, int second, double sign, double choppiness)
    : I(first)
    , J(second)
    , Sign(sign)
    , Choppiness(choppiness)
    , TrainI(sea.Trains[first])
    , TrainJ(sea.Trains[second])
    , A(this->TrainI, sea.Depth)
    , B(this->TrainJ, sea.Depth)
    , K(this->TrainI, this->TrainJ, sign)
    , Kernel(PairKernelOf(this->TrainI, this->TrainJ, sea.Depth, sign))
    , Cosine(std::cos(this->TrainI.Direction - this->TrainJ.Direction))
    , Frequency(this->A.Frequency + sign * this->B.Frequency)
  {
    // A train and itself are once in the double sum, two trains twice
    this->Amplitudes = (first == second ? 0.5 : 1.0) * this->TrainI.Amplitude * this->TrainJ.Amplitude;
  }

  /// Lack of the vertical motion of the surface, 2 a_i a_j B less s c/2 a_i a_j cos (k_j coth k_i h + k_i coth k_j
  /// h).
  double Lack() const
  {
    const double held = 0.5 * this->Sign * this->Choppiness * this->Cosine *
      (this->B.WaveNumber * this->A.Coth() + this->A.WaveNumber * this->B.Coth());
    return this->Amplitudes * (2.0 * this->Kernel.Elevation - held);
  }

  void AddSurface(std::vector<BoundWave>& waves) const
  {
    this->Add(waves, this->A.WaveNumber + this->B.WaveNumber, 0.0, 0.0, this->Lack());
  }

  /// The potential flow: U = g2 D K tanh Kh / (2 w_i w_j W2) upwards.
  void AddFlow(std::vector<BoundWave>& waves) const
  {
    if (this->IsStanding() || this->K.Length < SameTrain * (this->A.WaveNumber + this->B.WaveNumber))
    {
      return; // no flow
    }
    const double rise = this->Amplitudes * Gravity * Gravity * this->Kernel.Potential * this->K.Length *
      std::tanh(this->K.Length * this->A.Depth) /
      (2.0 * this->A.Frequency * this->B.Frequency * this->Frequency * this->Frequency);
    this->Add(waves, this->K.Length, -rise * this->K.X / this->K.Length, -rise * this->K.Y / this->K.Length, rise);
  }

  /// Difference of the trains' flow where the orbit has taken the particle, without the drift.
  void AddWay(std::vector<BoundWave>& waves) const
  {
    const double ki = this->A.WaveNumber;
    const double kj = this->B.WaveNumber;
    const double both = this->A.Coth() + this->B.Coth(); // sinh (k_i + k_j) h / (sinh k_i h sinh k_j h)
    const double apart = this->B.Coth() - this->A.Coth();
    if (this->IsStanding())
    {
      this->Add(waves, ki + kj, 0.0, 0.0, this->Lack());
      return;
    }
    // (xi . grad) u, integrated over time: (p A_j B_i + q A_i B_j) cos(phi_i +- phi_j) upwards
    const double left = 1.0 - this->Choppiness;
    const double wi = this->A.Frequency * ki;
    const double wj = this->B.Frequency * kj;
    const double p = 0.5 * this->Sign * ((wj - this->Cosine * wi) / this->Frequency + left * this->Cosine * ki);
    const double q = 0.5 * ((wi - this->Cosine * wj) / this->Frequency + this->Sign * left * this->Cosine * kj);
    // -(w_i k_i d_i + w_j k_j d_j) / 2 W (B_i B_j - d_i . d_j A_i A_j) sin(phi_i + phi_j) along
    double alongBoth[2] = { 0.0, 0.0 };
    double alongApart[2] = { 0.0, 0.0 };
    const double longWave = std::max(std::abs(ki - kj), LongWave / this->A.Depth);
    if (this->Sign > 0.0)
    {
      const double mean[2] = { wi * std::cos(this->TrainI.Direction) + wj * std::cos(this->TrainJ.Direction),
        wi * std::sin(this->TrainI.Direction) + wj * std::sin(this->TrainJ.Direction) };
      const double flat = this->FlatAtBed() * std::sinh(std::min(300.0, longWave * this->A.Depth));
      for (int axis = 0; axis < 2; ++axis)
      {
        const double scale = -0.25 * this->Amplitudes * mean[axis] / this->Frequency;
        alongBoth[axis] = scale * (1.0 - this->Cosine) * both;
        alongApart[axis] = -scale * (1.0 + this->Cosine) * flat;
      }
    }
    this->Add(waves, ki + kj, alongBoth[0], alongBoth[1], 0.5 * this->Amplitudes * (p + q) * both);
    this->Add(waves, longWave, alongApart[0], alongApart[1], 0.5 * this->Amplitudes * (p - q) * apart);
  }

private:
  /// 1 / (sinh k_i h sinh k_j h)
  double FlatAtBed() const
  {
    const auto inverse = [](
                           const Wave& wave) { return 1.0 / std::sinh(std::min(300.0, wave.WaveNumber * wave.Depth)); };
    return inverse(this->A) * inverse(this->B);
  }

  bool IsStanding() const { return std::abs(this->Frequency) < Standing * (this->A.Frequency + this->B.Frequency); }

  void Add(std::vector<BoundWave>& waves, double profile, double x, double y, double up) const
  {
    const double least = Negligible * this->Amplitudes * (this->A.WaveNumber + this->B.WaveNumber);
    if (std::abs(x) > least || std::abs(y) > least || std::abs(up) > least)
    {
      waves.push_back({ this->I, this->J, this->Sign, profile, { x, y }, up });
    }
  }

  int I;
  int J;
  double Sign;
  double Choppiness;
  const WaveTrain& TrainI;
  const WaveTrain& TrainJ;
  Wave A;
  Wave B;
  Sum K;
  PairKernel Kernel;
  double Cosine;
  double Frequency;
  double Amplitudes;
};

/// The mean level of particles: c/2 k A B for their orbits, and the set-down, which is 0 at the bed.
void AddLevel(const SeaState& sea, int n, BoundMotion motion, double choppiness, std::vector<BoundWave>& waves)
{
  const WaveTrain& train = sea.Trains[n];
  const Wave wave(train, sea.Depth);
  const double square = train.Amplitude * train.Amplitude;
  const double orbit = 0.5 * choppiness * square * wave.WaveNumber * wave.Coth();
  const double setDown = square * PairKernelOf(train, train, sea.Depth, -1.0).Elevation;
  if (motion == BoundMotion::Surface)
  {
    waves.push_back({ n, n, 0.0, 2.0 * wave.WaveNumber, { 0.0, 0.0 }, orbit + setDown });
    return;
  }
  waves.push_back({ n, n, 0.0, 2.0 * wave.WaveNumber, { 0.0, 0.0 }, orbit });
  if (setDown != 0.0)
  {
    waves.push_back({ n, n, 0.0, LongWave / sea.Depth, { 0.0, 0.0 }, setDown });
  }
}

struct Weight
{
  double Skewness; ///< that the pair adds to the elevation, at most
  int First;
  int Second;
};

/// Pairs of trains that matter, in the order of the trains.
std::vector<Weight> PairsOf(const SeaState& sea, double choppiness, double mostLeftOut)
{
  std::vector<Weight> pairs;
  const int count = static_cast<int>(sea.Trains.size());
  const double variance = EnergyOf(sea.Trains);
  for (int j = 0; j < count; ++j)
  {
    for (int i = 0; i <= j; ++i)
    {
      double lack = std::abs(Pair(sea, i, j, 1.0, choppiness).Lack());
      lack += i == j ? 0.0 : std::abs(Pair(sea, i, j, -1.0, choppiness).Lack());
      // <eta1^2 eta2> of a pair is at most a_i a_j times half the amplitudes of its waves
      const double part = 1.5 * sea.Trains[i].Amplitude * sea.Trains[j].Amplitude * lack;
      pairs.push_back({ part / std::pow(variance, 1.5), i, j });
    }
  }
  std::vector<std::size_t> order(pairs.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(
    order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return pairs[a].Skewness < pairs[b].Skewness; });
  double leftOut = 0.0;
  for (const std::size_t index : order)
  {
    leftOut += pairs[index].Skewness;
    if (!(leftOut <= mostLeftOut))
    {
      break;
    }
    pairs[index].First = -1;
  }
  pairs.erase(
    std::remove_if(pairs.begin(), pairs.end(), [](const Weight& pair) { return pair.First < 0; }), pairs.end());
  return pairs;
}

}

PairKernel PairKernelOf(const WaveTrain& first, const WaveTrain& second, double depth, double sign)
{
  const Wave i(first, depth);
  const Wave j(second, depth);
  const double ri = i.Rate();
  const double rj = j.Rate();
  const double along = i.WaveNumber * j.WaveNumber * std::cos(first.Direction - second.Direction);
  const double k = Sum(first, second, sign).Length;
  double d = 0.0;
  if (sign > 0.0 || !AreSame(first, second))
  {
    // D = [q (sqrt(R_j) (k_i2 - R_i2) + s sqrt(R_i) (k_j2 - R_j2)) + 2 q2 (k_i . k_j - s R_i R_j)] / (q2 - K tanh Kh),
    // q = sqrt(R_i) + s sqrt(R_j)
    const double q = std::sqrt(ri) + sign * std::sqrt(rj);
    const double rest = std::sqrt(rj) * i.Rest() + sign * std::sqrt(ri) * j.Rest();
    d = q == 0.0
      ? 0.0
      : (q * rest + 2.0 * q * q * (along - sign * ri * rj)) / (q * q - (k > 0.0 ? k * std::tanh(k * depth) : 0.0));
  }
  // B = 1/4 [(D - (k_i . k_j - s R_i R_j)) / sqrt(R_i R_j) + R_i + R_j]
  return { 0.25 * ((d - (along - sign * ri * rj)) / std::sqrt(ri * rj) + ri + rj), d };
}

std::vector<BoundWave> BoundWavesOf(const SeaState& sea, const BoundWaveOptions& options, double choppiness)
{
  const BoundMotion motion = options.Motion;
  std::vector<BoundWave> waves;
  for (int n = 0; motion != BoundMotion::Places && n < static_cast<int>(sea.Trains.size()); ++n)
  {
    AddLevel(sea, n, motion, choppiness, waves);
  }
  for (const Weight& weight : PairsOf(sea, choppiness, options.SkewnessLeftOut))
  {
    for (const double sign : { 1.0, -1.0 })
    {
      if (sign < 0.0 && weight.First == weight.Second)
      {
        continue; // its level
      }
      const Pair pair(sea, weight.First, weight.Second, sign, choppiness);
      if (motion == BoundMotion::Surface)
      {
        pair.AddSurface(waves);
        continue;
      }
      pair.AddFlow(waves);
      if (motion == BoundMotion::Particles)
      {
        pair.AddWay(waves);
      }
    }
  }
  return waves;
}

bool IsSortedLongCrestedDeep(const SeaState& sea)
{
  const auto isBefore = [](const WaveTrain& a, const WaveTrain& b) { return a.WaveNumber < b.WaveNumber; };
  const auto turns = [&](const WaveTrain& train) { return train.Direction != sea.Trains.front().Direction; };
  return std::isinf(sea.Depth) && std::is_sorted(sea.Trains.begin(), sea.Trains.end(), isBefore) &&
    std::none_of(sea.Trains.begin(), sea.Trains.end(), turns);
}

double SkewnessOf(const SeaState& sea)
{
  const double variance = EnergyOf(sea.Trains);
  double third = 0.0;
  for (const WaveTrain& first : sea.Trains)
  {
    for (const WaveTrain& second : sea.Trains)
    {
      // <eta1^2 eta2> = sum over i, j of a_i^2 a_j^2 (B+ + B-) / 2, without the mean level
      const bool isSelf = &first == &second;
      const double kernel = PairKernelOf(first, second, sea.Depth, 1.0).Elevation * (isSelf ? 0.5 : 1.0) +
        (isSelf ? 0.0 : PairKernelOf(first, second, sea.Depth, -1.0).Elevation);
      third += 0.5 * first.Amplitude * first.Amplitude * second.Amplitude * second.Amplitude * kernel;
    }
  }
  return variance > 0.0 ? 3.0 * third / std::pow(variance, 1.5) : 0.0;
}

}
