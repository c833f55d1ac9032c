// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSeaweedLevels_h
#define LittoralSeaweedLevels_h

#include "Geometry/ViewFrustum.h"
#include "Sea/WaveTrains.h"

#include <cstddef>
#include <vector>

namespace littoral
{

/// Levels of detail of seaweeds in a view.
struct SeaweedLevels
{
  bool UseLevels = false;
  double NearDistance = 5.0;   ///< up to which all links move [m]
  double FarDistance = 20.0;   ///< beyond which the first link of each branch moves [m]
  double BlendDistance = 12.0; ///< beyond either, over which levels of small plants change [m]
  double PixelError = 0.5;     ///< displacement of the water by what is left out of waves [pixels]
  View Seen;
};

/// Weights of the detailed levels, 0 to 1.
struct SeaweedLevelShares
{
  double Near = 1.0;
  double Far = 1.0; ///< of what is nearer than FarDistance
};

/// The weights for a plant at a distance from the eye that reaches some way from its middle [m].
SeaweedLevelShares LevelSharesAt(const SeaweedLevels& levels, double distance, double reach);

/// Whether all plants are shown alike in two of them.
bool AreTheSame(const SeaweedLevels& a, const SeaweedLevels& b);

/// The error that the water may have at a distance from the eye [m]: PixelError; 0 without levels.
double ErrorOfWater(const SeaweedLevels& levels, double distance);

/// A bound of the speed of the water by all wave trains at a height above the sea level [m/s].
double TrainSpeed(const SeaState& sea, double height);

/// The most steps for which a plant is shown as it was.
constexpr int MostHeld = 32;

/// The steps [s] for which a plant is shown as it was while water of a speed [m/s] moves by `maximum` [m] at most: a
/// power of two up to MostHeld; 0: its motion is shown at all times.
int StepsHeld(double maximum, double speed, double step);

/// The last step up to another one at which a plant that is held for so many steps is shown anew: plants take turns.
long long StepOfHeld(long long step, int held, std::size_t plant);

/// The sum of the amplitudes of each wave train and all after it at a height above the sea level [m].
std::vector<double> TrainSums(const SeaState& sea, double height);

/**
 * Weights of wave trains with these TrainSums, 0 to 1, so that what they leave out moves the water by at most `maximum`
 * [m], all together.
 */
void FindTrainShares(const double* sums, std::size_t trains, double maximum, float* shares);

}

#endif
