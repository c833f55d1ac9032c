// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPointRuns_h
#define LittoralPointRuns_h

// Outputs whose points come in an order of place, and whose parts are runs of them, one behind the other: ranks that
// each have a part know the points by their numbers, and have few that belong to others. Private: never installed,
// never wrapped.

class vtkInformation;

namespace littoral
{

/// Announces that an output can be made in such parts. All ranks or none must be able to make theirs: those that share
/// them wait for each other.
void AnnounceRuns(vtkInformation* output);

/// Whether an input comes in such parts: also behind what ParaView puts between sources and filters.
bool ComesInRuns(vtkInformation* input);

/// Whether the data of an input are one of several runs: not so where something else upstream needs them all.
bool IsRun(vtkInformation* input);

/// Asks an input for the part that is asked of an output.
void RequestSamePart(vtkInformation* input, vtkInformation* output);

}

#endif
