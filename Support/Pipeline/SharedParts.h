// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSharedParts_h
#define LittoralSharedParts_h

// Outputs in parts that ranks can share: each point or plant is in one of them. Private: never installed, never
// wrapped.

class vtkInformation;
class vtkInformationVector;

namespace littoral
{

/// Forms of the parts of an output.
enum class PartForm
{
  Runs = 1,      ///< of points in an order of place, one behind the other: ranks know the points by their numbers, and
                 ///< have few that belong to others
  Instances = 2, ///< of plants, with all prototypes in each part
  Whole = 3,     ///< all of it in the first part; ranks that each need all can share the work
};

/// Announces that an output can be made in such parts. All ranks or none must be able to make theirs: those that share
/// them wait for each other.
void AnnouncePartForm(vtkInformation* output, PartForm form);

/// Takes it back.
void ForgetPartForm(vtkInformation* output);

/// Whether an input comes in such parts: also behind what ParaView puts between sources and filters.
bool ComesInParts(vtkInformation* input, PartForm form);

/// Whether the data of an input are one of several parts: not so where something else upstream needs them all.
bool IsPart(vtkInformation* input, PartForm form);

/// Asks an input for the part that is asked of an output.
void RequestSamePart(vtkInformation* input, vtkInformation* output);

/// Asks inputs of the form Whole, of which all ranks need all, to make it together, if on all ranks, all of which must
/// call this now, each of them has changed since it made some.
void RequestTogether(vtkInformationVector* inputs);

/// Whether an output is asked for so; once.
bool IsAskedTogether(vtkInformation* output);

/// Asks an input for the part that it has, if it has data.
void RequestNoOtherPart(vtkInformation* input);

}

#endif
