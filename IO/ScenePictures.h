// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralScenePictures_h
#define LittoralScenePictures_h

#include "Scene.h"

class vtkPolyData;

namespace littoral
{

/// The picture that good data carry, as PNG.
ScenePicture PictureOf(vtkPolyData* data);

}

#endif
