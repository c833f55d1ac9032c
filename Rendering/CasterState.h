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
/// changes the times of lookup tables and of the attributes of blocks. Inputs of mappers are updated. In coarse maps
/// the shapes are those of vtkLandscapePass::COARSE_SHAPE(), where props have it.
std::uint64_t StateOf(const std::vector<vtkProp*>& casters, bool isCoarse = false);

/// Whether a prop casts nothing in coarse maps.
bool CastsNothing(vtkProp* prop);

}

#endif
