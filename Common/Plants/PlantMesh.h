// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPlantMesh_h
#define LittoralPlantMesh_h

#include "Geometry/TextureImage.h"
#include "Numerics/Vector3.h"

#include <array>
#include <vector>

namespace littoral
{

/// Polygons with what a renderer and a skinner want at each vertex. Arrays are empty where there is nothing to say.
struct PlantMesh
{
  std::vector<Vector3> Points; ///< [m]
  std::vector<Vector3> Normals;
  std::vector<std::array<double, 2>> TCoords;
  std::vector<Color> Colors;
  std::vector<std::array<int, 4>> JointIds;
  std::vector<std::array<double, 4>> JointWeights; ///< sum to 1 at each vertex
  std::vector<int> Offsets{ 0 };                   ///< polygon i has the corners Offsets[i] ... Offsets[i + 1] - 1
  std::vector<int> Corners;

  int NumberOfPolygons() const { return static_cast<int>(this->Offsets.size()) - 1; }

  template <typename List>
  void AddPolygon(const List& corners)
  {
    this->Corners.insert(this->Corners.end(), corners.begin(), corners.end());
    this->Offsets.push_back(static_cast<int>(this->Corners.size()));
  }
};

/// Adds a copy of a vertex; its index.
int CopyVertex(PlantMesh& mesh, int vertex);

/// Twice the area of a polygon [m2], along the normal of its winding.
Vector3 AreaVector(const PlantMesh& mesh, int polygon);

/// The upright cylinder about the axis of a plant that holds all of it [m].
struct PlantExtent
{
  double Radius = 0.0;
  double Low = 0.0;
  double High = 0.0;
};

/// Widens a cylinder by the points of a mesh.
void Enclose(PlantExtent& extent, const PlantMesh& mesh);

/// Turns normals, each as little as it takes, until they are on the front of all polygons at their vertices. A polygon
/// gets a vertex of its own where that is not to be had.
void TurnNormalsToFronts(PlantMesh& mesh);

}

#endif
