// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportFoliageTriangles_h
#define LittoralSupportFoliageTriangles_h

// Leaves and bark of blocks as triangles. Private: never installed, never wrapped.

#include "Geometry/TextureImage.h"
#include "Plants/PictureCoverage.h"
#include "Plants/PlantFoliage.h"

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <map>
#include <vector>

class vtkDataArray;

namespace littoral
{

/// Reads polygons of a block as triangles, one after the other. For each thread one of its own.
class FoliageTriangles
{
public:
  /// Leaves with their picture, or bark, half of whose surface counts. The block and the picture must outlive this.
  FoliageTriangles(vtkPolyData* block, const TextureImage* picture);

  /// The triangles of a polygon.
  const std::vector<FoliageTriangle>& Of(vtkIdType polygon);

  /// A point of the polygon last read.
  vtkIdType FirstPoint() const { return this->Corners->GetId(0); }

private:
  double PartOf(vtkIdType a, vtkIdType b, vtkIdType c);

  vtkPolyData* Block;
  const TextureImage* Picture;
  vtkDataArray* Coordinates = nullptr;
  vtkNew<vtkIdList> Corners;
  std::vector<FoliageTriangle> Triangles;
  std::map<PictureTriangle, double> Parts;
};

/// All triangles of a block; none of null.
std::vector<FoliageTriangle> TrianglesOf(vtkPolyData* block, const TextureImage* picture);

}

#endif
