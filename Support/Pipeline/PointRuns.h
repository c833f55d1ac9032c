// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPointRuns_h
#define LittoralPointRuns_h

// Outputs whose points come in an order of place, with their `SiteId`, and whose parts are runs of them, one behind the
// other: ranks that each have a part know the points by their numbers, and have few that belong to others. Private:
// never installed, never wrapped.

class vtkInformation;

namespace littoral
{

/// Announces that an output can be made in parts, and whether they are such runs.
void AnnounceRuns(vtkInformation* output, bool areRuns = true);

/// Whether an input comes in such parts: also behind what ParaView puts between sources and filters.
bool ComesInRuns(vtkInformation* input);

/// Whether the data of an input are one of several runs: not so where something else upstream needs them all.
bool IsRun(vtkInformation* input);

/// Asks an input for the part that is asked of an output.
void RequestSamePart(vtkInformation* input, vtkInformation* output);

}

#endif
