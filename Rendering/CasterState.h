// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CasterState_h
#define CasterState_h

#include <cstdint>
#include <vector>

class vtkProp;

namespace littoral
{

/// A number that changes with the shapes of props, which cast shadows, but not with their colors: drawing itself
/// changes the times of lookup tables and of the attributes of blocks. Inputs of mappers are updated.
std::uint64_t StateOf(const std::vector<vtkProp*>& casters);

}

#endif
