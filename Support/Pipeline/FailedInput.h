// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportFailedInput_h
#define LittoralSupportFailedInput_h

// A failure upstream, told from a part without data. Private: never installed, never wrapped.

class vtkAlgorithm;

namespace littoral
{

/// Whether an algorithm has nothing to work with for an upstream one has reported an error.
bool HasFailedInput(vtkAlgorithm* algorithm);

}

#endif
