// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralVolumeGather_h
#define LittoralVolumeGather_h

#include "VolumeInput.h"

class vtkMultiProcessController;

namespace littoral
{

/**
 * Brings what the ranks hold to rank 0, which then has Samples, the first Reason of all, and Volumes whose blocks have
 * extents but, those of other ranks, no values. Each rank must call this. Null, or one rank: nothing to do.
 */
void GatherShapes(vtkMultiProcessController* controller, VolumeInput& input);

/// Brings the values to rank 0, which has asked for their memory; each rank must call this, or none.
void GatherValues(vtkMultiProcessController* controller, VolumeInput& input);

/// Rank 0's answer, on each rank.
bool ShareAnswer(vtkMultiProcessController* controller, bool answer);

/// Whether this rank is the one that has it all.
bool IsFirstRank(vtkMultiProcessController* controller);

}

#endif
