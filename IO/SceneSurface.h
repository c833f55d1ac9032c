// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSceneSurface_h
#define LittoralSceneSurface_h

// Meshes of a scene from polygonal data and images. Private: never installed.

#include "Scene.h"

#include "vtkSmartPointer.h"

#include <array>
#include <string>

class vtkDataArray;
class vtkImageData;
class vtkPolyData;
class vtkUnsignedCharArray;

namespace littoral
{

/// Throws InvalidInput if polygonal data cannot be drawn.
void RequireSurface(vtkPolyData* data, const std::string& owner);

/// Throws InvalidInput if an image is no terrain, one layer of elevations.
void RequireTerrain(vtkImageData* image, const std::string& owner);

/// Polygonal data of a valid terrain: a point for each sample, with normals and, where the image has none, colors of
/// the ground.
vtkSmartPointer<vtkPolyData> TerrainOf(vtkImageData* image);

/// Size of the mesh of a terrain in a file [bytes].
double TerrainBytes(vtkImageData* image);

/// Size of the mesh of valid data in a file [bytes].
double MeshBytes(vtkPolyData* data, bool hasVelocity);

/// Mesh of valid data, without name and material, relative to the place of its node: data in double precision may be
/// far from the origin.
SceneMesh MeshOf(vtkPolyData* data, bool hasVelocity, std::array<double, 3>& place);

/// Positions and normals of the vertices of such a mesh.
SceneMesh::Target PlacesAt(vtkPolyData* data, const std::array<double, 3>& place);

/// The point array of colors, bytes of three or four components; null where there is none.
vtkUnsignedCharArray* ColorsOf(vtkPolyData* data);

/// The texture coordinates of the points; null where there are none.
vtkDataArray* TextureCoordinatesOf(vtkPolyData* data);

}

#endif
