// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportCurrentInputs_h
#define LittoralSupportCurrentInputs_h

// Currents at a repeatable port: their times, requests for snapshots, and the snapshots. Private: never installed,
// never wrapped.

#include "Currents/CurrentSet.h"
#include "Data/CurrentData.h"

#include <string>
#include <vector>

class vtkInformationVector;

namespace littoral
{

/// The currents of a port by the times that they announce; each is requested as a whole.
std::vector<CurrentSeries> AnnouncedCurrents(vtkInformationVector* inputs);

/// Adds the times of currents to what a state depends on.
void AddTimes(const std::vector<CurrentSeries>& currents, std::vector<double>& key);

/// Requests of each current that changes the first snapshot that is missing for some moments.
void AskForSnapshots(
  CurrentSet& currents, const TimeGrid& grid, const std::vector<StepMoment>& moments, vtkInformationVector* inputs);

/// Keeps the snapshots that were requested. Throws InvalidInput if one cannot be read.
void TakeSnapshots(CurrentSet& currents, const TimeGrid& grid, const std::vector<StepMoment>& moments,
  vtkInformationVector* inputs, const char* velocityArray, VelocityInterpolation interpolation,
  CoastBehaviour coast = CoastBehaviour::Stop);

}

#endif
