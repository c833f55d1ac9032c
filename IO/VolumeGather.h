// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralVolumeGather_h
#define LittoralVolumeGather_h

#include "VolumeInput.h"

class vtkMultiProcessController;

namespace littoral
{

/**
 * Brings the parts of all ranks to rank 0, which then has Volumes, Samples and the first Reason of all. Each rank must
 * call this. Null, or one rank: nothing to do.
 */
void GatherVolumes(vtkMultiProcessController* controller, VolumeInput& input);

/// Rank 0's answer, on each rank.
bool ShareAnswer(vtkMultiProcessController* controller, bool answer);

/// Whether this rank is the one that has it all.
bool IsFirstRank(vtkMultiProcessController* controller);

}

#endif
