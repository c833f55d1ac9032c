// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CompositeMapper_h
#define CompositeMapper_h

#if __has_include("vtkCompositePolyDataMapperDelegator.h") // VTK 9.3 and later
#include "vtkCompositePolyDataMapper.h"
#else
#include "vtkCompositePolyDataMapper2.h"
#endif

namespace littoral
{

/// The mapper of blocks whose display attributes are set.
#if __has_include("vtkCompositePolyDataMapperDelegator.h")
using CompositeMapper = vtkCompositePolyDataMapper;
#else
using CompositeMapper = vtkCompositePolyDataMapper2;
#endif

}

#endif
