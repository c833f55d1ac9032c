// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/PlantMesh.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr double LeastCosine = 0.02; ///< of a normal and that of a polygon
constexpr int MostRounds = 200;      ///< a turn towards one polygon may turn away from another

/// Calls a task with each corner whose normal is not on the front of its polygon, and with the nearest that is.
template <typename Task>
void ForWrongNormals(const PlantMesh& mesh, const Task& task)
{
  for (int polygon = 0; polygon < mesh.NumberOfPolygons(); ++polygon)
  {
    const Vector3 area = AreaVector(mesh, polygon);
    const double size = glm::length(area);
    for (int corner = mesh.Offsets[polygon]; size > 0.0 && corner < mesh.Offsets[polygon + 1]; ++corner)
    {
      const Vector3 normal = mesh.Normals[mesh.Corners[corner]];
      const double cosine = glm::dot(normal, area) / size;
      if (cosine < LeastCosine)
      {
        // A little more than enough, so that rounds end.
        task(corner, Normalised(normal + (2.0 * LeastCosine - cosine) / size * area));
      }
    }
  }
}

template <typename List>
void CopyElement(List& list, int index)
{
  if (!list.empty())
  {
    const typename List::value_type element = list[index];
    list.push_back(element);
  }
}

}

int CopyVertex(PlantMesh& mesh, int vertex)
{
  CopyElement(mesh.Points, vertex);
  CopyElement(mesh.Normals, vertex);
  CopyElement(mesh.TCoords, vertex);
  CopyElement(mesh.Colors, vertex);
  CopyElement(mesh.JointIds, vertex);
  CopyElement(mesh.JointWeights, vertex);
  return static_cast<int>(mesh.Points.size()) - 1;
}

Vector3 AreaVector(const PlantMesh& mesh, int polygon)
{
  const int begin = mesh.Offsets[polygon];
  const int end = mesh.Offsets[polygon + 1];
  const Vector3& origin = mesh.Points[mesh.Corners[begin]];
  Vector3 area(0.0);
  for (int corner = begin + 1; corner + 1 < end; ++corner)
  {
    area += glm::cross(mesh.Points[mesh.Corners[corner]] - origin, mesh.Points[mesh.Corners[corner + 1]] - origin);
  }
  return area;
}

void Enclose(PlantExtent& extent, const PlantMesh& mesh)
{
  for (const Vector3& point : mesh.Points)
  {
    extent.Radius = std::max(extent.Radius, std::hypot(point.x, point.y));
    extent.Low = std::min(extent.Low, point.z);
    extent.High = std::max(extent.High, point.z);
  }
}

void TurnNormalsToFronts(PlantMesh& mesh)
{
  bool turned = true;
  for (int round = 0; turned && round < MostRounds; ++round)
  {
    turned = false;
    ForWrongNormals(mesh, [&](int corner, const Vector3& normal) {
      mesh.Normals[mesh.Corners[corner]] = normal;
      turned = true;
    });
  }
  if (turned) // there are polygons without a common front
  {
    ForWrongNormals(mesh, [&](int corner, const Vector3& normal) {
      mesh.Corners[corner] = CopyVertex(mesh, mesh.Corners[corner]);
      mesh.Normals.back() = normal;
    });
  }
}

}
