// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralNearestPixels_h
#define LittoralNearestPixels_h

class vtkMultiProcessController;
class vtkTextureObject;

namespace littoral
{

/// Takes the nearest pixels of a picture that processes have, all together. A pixel has three numbers, and in the
/// fourth channel its distance, 0 where there is none.
void TakeNearestPixels(vtkTextureObject* picture, vtkMultiProcessController* processes);

/// Takes the nearest colors of a picture that processes have, by their depths, all together.
void TakeNearestColors(vtkTextureObject* picture, vtkTextureObject* depth, vtkMultiProcessController* processes);

/// Pictures of surfaces (SurfacePass).
struct SurfacePictures
{
  vtkTextureObject* Albedo;
  vtkTextureObject* Surface;
  vtkTextureObject* Depth;
};

/// Writes the nearest of the surfaces that processes have to pictures of their size, all together, at pixels where one
/// of them has a depth of water.
void TakeNearestBelow(vtkTextureObject* depthOfWater, const SurfacePictures& own, const SurfacePictures& nearest,
  vtkMultiProcessController* processes);

}

#endif
