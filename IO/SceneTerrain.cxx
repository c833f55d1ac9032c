// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneSurface.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/GroundWetness.h"
#include "Data/Inputs.h"
#include "Data/PickedTuples.h"
#include "Data/PlantBlocks.h"
#include "Numerics/ParameterCheck.h"
#include "Terrain/GroundColor.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace littoral
{

namespace
{

constexpr const char* Elevation = "Elevation";

/// The elevations of an image, or else its active scalars.
vtkDataArray* ElevationsOf(vtkImageData* image, const ArrayReader& arrays)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  return arrays.Has(Elevation) || !scalars ? arrays.Need(Elevation, 1) : arrays.Fit(scalars, 1);
}

/// The samples of a raster.
struct Samples
{
  vtkDataArray* Heights;
  int Columns;
  int Rows;
  double Spacing[2];

  double At(int column, int row) const
  {
    return this->Heights->GetComponent(static_cast<vtkIdType>(row) * this->Columns + column, 0);
  }

  bool IsHole(int column, int row) const { return std::isnan(this->At(column, row)); }

  /// n ~ (-dz/dx, -dz/dy, 1), of the differences between neighbors that are there.
  std::array<double, 3> NormalAt(int column, int row) const
  {
    const int west = column > 0 && !this->IsHole(column - 1, row) ? column - 1 : column;
    const int east = column + 1 < this->Columns && !this->IsHole(column + 1, row) ? column + 1 : column;
    const int south = row > 0 && !this->IsHole(column, row - 1) ? row - 1 : row;
    const int north = row + 1 < this->Rows && !this->IsHole(column, row + 1) ? row + 1 : row;
    const double alongX = (this->At(west, row) - this->At(east, row)) / (std::max(1, east - west) * this->Spacing[0]);
    const double alongY =
      (this->At(column, south) - this->At(column, north)) / (std::max(1, north - south) * this->Spacing[1]);
    std::array<double, 3> normal = { { alongX, alongY, 1.0 } };
    vtkMath::Normalize(normal.data());
    return normal;
  }
};

/// Quads whose corners all have a height.
vtkSmartPointer<vtkCellArray> QuadsOf(vtkDataArray* heights, vtkIdType columns, vtkIdType rows)
{
  auto quads = vtkSmartPointer<vtkCellArray>::New();
  const auto isThere = [heights](vtkIdType point) { return !std::isnan(heights->GetComponent(point, 0)); };
  quads->AllocateExact((columns - 1) * (rows - 1), 4 * (columns - 1) * (rows - 1));
  for (vtkIdType row = 0; row + 1 < rows; ++row)
  {
    for (vtkIdType column = 0; column + 1 < columns; ++column)
    {
      const vtkIdType first = row * columns + column;
      if (isThere(first) && isThere(first + 1) && isThere(first + columns + 1) && isThere(first + columns))
      {
        quads->InsertNextCell({ first, first + 1, first + columns + 1, first + columns });
      }
    }
  }
  return quads;
}

/// The points of polygons that have one, with their arrays, and the polygons on them.
vtkSmartPointer<vtkPolyData> UsedPart(vtkPolyData* whole)
{
  std::vector<vtkIdType> places;
  SetSize(places, whole->GetNumberOfPoints());
  std::fill(places.begin(), places.end(), -1);
  std::vector<vtkIdType> used;
  vtkNew<vtkCellArray> polygons;
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  vtkCellArray* cells = whole->GetPolys();
  for (cells->InitTraversal(); cells->GetNextCell(size, corners);)
  {
    polygons->InsertNextCell(static_cast<int>(size));
    for (vtkIdType corner = 0; corner < size; ++corner)
    {
      vtkIdType& place = places[static_cast<std::size_t>(corners[corner])];
      if (place < 0)
      {
        place = static_cast<vtkIdType>(used.size());
        used.push_back(corners[corner]);
      }
      polygons->InsertCellPoint(place);
    }
  }
  const auto positions = NewArray<vtkDoubleArray>("Points", 3, static_cast<vtkIdType>(used.size()));
  for (std::size_t point = 0; point < used.size(); ++point)
  {
    positions->SetTuple(static_cast<vtkIdType>(point), whole->GetPoint(used[point]));
  }
  vtkNew<vtkPoints> points;
  points->SetData(positions);
  auto part = vtkSmartPointer<vtkPolyData>::New();
  part->SetPoints(points);
  part->SetPolys(polygons);
  PickTuples(whole->GetPointData(), used, part->GetPointData());
  return part;
}

/// Colors of the ground by slope, height and, if they are there, reflectance and wetness.
vtkSmartPointer<vtkUnsignedCharArray> GroundColors(
  const Samples& samples, vtkFloatArray* normals, vtkDataArray* reflectance, const std::vector<double>& wetness)
{
  const vtkIdType count = normals->GetNumberOfTuples();
  auto colors = NewArray<vtkUnsignedCharArray>(plant::RGB, 3, count);
  double range[2];
  samples.Heights->GetFiniteRange(range);
  for (vtkIdType sample = 0; sample < count; ++sample)
  {
    GroundPlace ground;
    if (std::isnan(samples.Heights->GetComponent(sample, 0)))
    {
      continue; // in a hole, which is not shown
    }
    ground.Slope = std::acos(std::min(1.0, normals->GetComponent(sample, 2)));
    ground.Height =
      range[1] > range[0] ? (samples.Heights->GetComponent(sample, 0) - range[0]) / (range[1] - range[0]) : 0.0;
    ground.Reflectance = reflectance ? reflectance->GetComponent(sample, 0) : ground.Reflectance;
    ground.Wetness = wetness.empty() ? ground.Wetness : wetness[static_cast<std::size_t>(sample)];
    const Color color = GroundColor(ground);
    std::copy(color.begin(), color.end(), colors->GetPointer(3 * sample));
  }
  return colors;
}

}

//----------------------------------------------------------------------------
void RequireTerrain(vtkImageData* image, const std::string& owner)
{
  RequireFit(image, owner.c_str());
  RequireRaster(image, 2);
  const ArrayReader arrays = ArrayReader::OfPoints(image, owner);
  RequireUpright(image, owner.c_str());
  vtkDataArray* heights = ElevationsOf(image, arrays);
  double range[2];
  heights->GetFiniteRange(range);
  Require(range[0] <= range[1] ? "" : owner + " has no heights.");
  for (vtkIdType point = 0; point < heights->GetNumberOfTuples(); ++point)
  {
    const double height = heights->GetComponent(point, 0);
    Require(std::isnan(height) || IsSensible(height) ? "" : owner + " has a height of " + TextOf(height) + " m.");
  }
  RequireColorable(image, owner);
}

//----------------------------------------------------------------------------
double TerrainBytes(vtkImageData* image)
{
  const auto points = static_cast<double>(image->GetNumberOfPoints());
  return ((3 + 3 + 3) * sizeof(float) + 2 * 3 * sizeof(int)) * points; // positions, normals, colors, two triangles
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> TerrainOf(vtkImageData* image)
{
  const ArrayReader arrays = ArrayReader::OfPoints(image, "");
  const int* dimensions = image->GetDimensions();
  const double* spacing = image->GetSpacing();
  const Samples samples = { ElevationsOf(image, arrays), dimensions[0], dimensions[1], { spacing[0], spacing[1] } };
  const vtkIdType count = image->GetNumberOfPoints();
  vtkNew<vtkPoints> points;
  points->SetData(NewArray<vtkDoubleArray>("Points", 3, count));
  const auto normals = NewArray<vtkFloatArray>("Normals", 3, count);
  for (vtkIdType sample = 0; sample < count; ++sample)
  {
    const int column = static_cast<int>(sample % samples.Columns);
    const int row = static_cast<int>(sample / samples.Columns);
    double place[3];
    image->GetPoint(sample, place);
    place[2] = samples.At(column, row);
    points->SetPoint(sample, place);
    normals->SetTuple(sample, samples.NormalAt(column, row).data());
  }
  auto terrain = vtkSmartPointer<vtkPolyData>::New();
  terrain->SetPoints(points);
  terrain->SetPolys(QuadsOf(samples.Heights, samples.Columns, samples.Rows));
  vtkPointData* own = terrain->GetPointData();
  own->SetNormals(normals);
  if (vtkDataArray* colors = arrays.Any(plant::RGB))
  {
    own->AddArray(colors);
  }
  if (!ColorsOf(terrain))
  {
    own->AddArray(GroundColors(samples, normals, arrays.Find("Reflectance", 1), SpreadWetness(image, samples.Heights)));
  }
  // Tells what it is, whatever the name of the scalars.
  vtkNew<vtkFloatArray> heights;
  heights->ShallowCopy(WithType<vtkFloatArray>(samples.Heights));
  heights->SetName(Elevation);
  own->AddArray(heights);
  const vtkIdType whole = static_cast<vtkIdType>(samples.Columns - 1) * (samples.Rows - 1);
  return terrain->GetNumberOfPolys() < whole ? UsedPart(terrain) : terrain;
}

}
