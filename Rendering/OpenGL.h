// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/// Functions and numbers of OpenGL, as VTK finds them.
#ifndef LittoralOpenGL_h
#define LittoralOpenGL_h

#if __has_include("vtk_glad.h") // VTK 9.4 and later
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#endif
