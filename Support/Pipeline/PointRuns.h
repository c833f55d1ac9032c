// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPointRuns_h
#define LittoralPointRuns_h

// Outputs whose parts are runs of their points, one behind the other, so that ranks which each have a part know the
// points by their numbers. Private: never installed, never wrapped.

class vtkInformation;

namespace littoral
{

/// Announces that an output can be made in such parts.
void AnnounceRuns(vtkInformation* output);

/// Whether an input comes in such parts: also behind what ParaView puts between sources and filters.
bool ComesInRuns(vtkInformation* input);

/// Asks an input for the part that is asked of an output.
void RequestSamePart(vtkInformation* input, vtkInformation* output);

}

#endif
