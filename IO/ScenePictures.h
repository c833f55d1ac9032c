// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralScenePictures_h
#define LittoralScenePictures_h

#include "Scene.h"

class vtkPolyData;

namespace littoral
{

/// Texture of valid data, as PNG.
ScenePicture PictureOf(vtkPolyData* data);

}

#endif
