// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralColorHelper_h
#define LittoralColorHelper_h

#if __has_include("vtkSMColorMapEditorHelper.h") // ParaView 5.13 and later
#include "vtkSMColorMapEditorHelper.h"
#else
#include "vtkSMPVRepresentationProxy.h"
#endif

namespace littoral
{

/// Header with ParaView's static functions for colors of a representation.
#if __has_include("vtkSMColorMapEditorHelper.h")
using ColorHelper = vtkSMColorMapEditorHelper;
#else
using ColorHelper = vtkSMPVRepresentationProxy;
#endif

}

#endif
