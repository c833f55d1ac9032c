// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Seaweed/SeaweedLevels.h"

#include "Numerics/SmoothStep.h"
#include "Sea/WaveOrbits.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// 1 up to a distance, 0 beyond the band that follows.
double ShareOf(double distance, double end, double band)
{
  return band > 0.0 ? 1.0 - SmoothStep(0.0, 1.0, (distance - end) / band) : (distance <= end ? 1.0 : 0.0);
}

}

SeaweedLevelShares LevelSharesAt(const SeaweedLevels& levels, double distance, double reach)
{
  // What reaches far sweeps over more pixels.
  const double band = levels.BlendDistance > 0.0 ? std::max(levels.BlendDistance, reach) : 0.0;
  return { ShareOf(distance, levels.NearDistance, band), ShareOf(distance, levels.FarDistance, band) };
}

bool AreTheSame(const SeaweedLevels& a, const SeaweedLevels& b)
{
  if (!a.UseLevels || !b.UseLevels)
  {
    return a.UseLevels == b.UseLevels;
  }
  const View& x = a.Seen;
  const View& y = b.Seen;
  return AreTheSame(x, y) && x.Near == y.Near && x.Far == y.Far && x.Margin == y.Margin &&
    x.AngleMargin == y.AngleMargin && a.NearDistance == b.NearDistance && a.FarDistance == b.FarDistance &&
    a.BlendDistance == b.BlendDistance && a.PixelError == b.PixelError;
}

double ErrorOfWater(const SeaweedLevels& levels, double distance)
{
  const View& seen = levels.Seen;
  return levels.UseLevels ? levels.PixelError * 2.0 * distance * std::tan(0.5 * seen.Angle) / seen.Height : 0.0;
}

double TrainSpeed(const SeaState& sea, double height)
{
  double speed = 0.0;
  for (const WaveTrain& train : sea.Trains)
  {
    speed += AxesAt(train, height, sea.Depth).Horizontal * train.AngularFrequency;
  }
  return speed;
}

int StepsHeld(double maximum, double speed, double step)
{
  if (!(speed * step <= maximum) || !(maximum > 0.0))
  {
    return 0;
  }
  int held = 1;
  while (held < MostHeld && 2.0 * held * speed * step <= maximum)
  {
    held *= 2;
  }
  return held;
}

long long StepOfHeld(long long step, int held, std::size_t plant)
{
  // Powers of two: the lowest bits of what is negative, too.
  return step - ((step + static_cast<long long>(plant)) & (held - 1));
}

std::vector<double> TrainSums(const SeaState& sea, double height)
{
  std::vector<double> sums(sea.Trains.size());
  double sum = 0.0;
  for (std::size_t n = sums.size(); n-- > 0;)
  {
    sum += AxesAt(sea.Trains[n], height, sea.Depth).Horizontal;
    sums[n] = sum;
  }
  return sums;
}

// Let r_n be the sum of the amplitudes of a train and all after it, divided by the maximum. A train fades from r_n
// 3/2 to 1/2: sum (1 - share_n) a_n is at most the integral of 1 - share over r, which is 1. A train that were there
// or not would move the plant at once by what its joints make of the train, which is a multiple of its amplitude.
void FindTrainShares(const double* sums, std::size_t trains, double maximum, float* shares)
{
  std::size_t n = trains;
  for (; n > 0 && (n == trains || sums[n] <= 1.5 * maximum); --n)
  {
    shares[n - 1] = static_cast<float>(SmoothStep(0.0, 1.0, sums[n - 1] / maximum - 0.5));
  }
  std::fill_n(shares, n, 1.0f);
}

}
