// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Seaweed/SeaweedLevels.h"

#include "Numerics/SmoothStep.h"
#include "Sea/WaveOrbits.h"

#include <algorithm>

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
