// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/FoliageTriangles.h"

#include "vtkCellArray.h"
#include "vtkPointData.h"

namespace littoral
{

namespace
{

constexpr double HalfOfSurface = 0.5;

}

FoliageTriangles::FoliageTriangles(vtkPolyData* block, const TextureImage* picture)
  : Block(block)
  , Picture(picture)
{
  vtkDataArray* coordinates = block->GetPointData()->GetTCoords();
  if (picture && !picture->Texels.empty() && coordinates)
  {
    this->Coordinates = coordinates;
  }
}

double FoliageTriangles::PartOf(vtkIdType a, vtkIdType b, vtkIdType c)
{
  if (!this->Picture)
  {
    return HalfOfSurface;
  }
  if (!this->Coordinates)
  {
    return 1.0;
  }
  PictureTriangle triangle;
  const vtkIdType points[3] = { a, b, c };
  for (int corner = 0; corner < 3; ++corner)
  {
    triangle[corner] = { this->Coordinates->GetComponent(points[corner], 0),
      this->Coordinates->GetComponent(points[corner], 1) };
  }
  const auto [place, isNew] = this->Parts.try_emplace(triangle, 0.0);
  if (isNew)
  {
    place->second = CoverageOf(*this->Picture, triangle);
  }
  return place->second;
}

const std::vector<FoliageTriangle>& FoliageTriangles::Of(vtkIdType polygon)
{
  this->Triangles.clear();
  this->Block->GetPolys()->GetCellAtId(polygon, this->Corners);
  for (vtkIdType corner = 2; corner < this->Corners->GetNumberOfIds(); ++corner)
  {
    const vtkIdType points[3] = { this->Corners->GetId(0), this->Corners->GetId(corner - 1),
      this->Corners->GetId(corner) };
    FoliageTriangle& triangle = this->Triangles.emplace_back();
    for (int n = 0; n < 3; ++n)
    {
      this->Block->GetPoint(points[n], &triangle.Corners[n].x);
    }
    triangle.Part = this->PartOf(points[0], points[1], points[2]);
  }
  return this->Triangles;
}

std::vector<FoliageTriangle> TrianglesOf(vtkPolyData* block, const TextureImage* picture)
{
  std::vector<FoliageTriangle> all;
  if (block && block->GetNumberOfPolys() > 0)
  {
    FoliageTriangles triangles(block, picture);
    for (vtkIdType polygon = 0; polygon < block->GetNumberOfPolys(); ++polygon)
    {
      const std::vector<FoliageTriangle>& own = triangles.Of(polygon);
      all.insert(all.end(), own.begin(), own.end());
    }
  }
  return all;
}

}
