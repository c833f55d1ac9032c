// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneSurface.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/PlantBlocks.h"
#include "Data/PlantForm.h"
#include "Geometry/SrgbCode.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr const char* Velocity = "Velocity";

vtkDataArray* NormalsOf(vtkPolyData* data)
{
  vtkDataArray* active = data->GetPointData()->GetNormals();
  return active ? active : ArrayReader::OfPoints(data, "").Seek("Normals", 3);
}

vtkDataArray* VelocityOf(vtkPolyData* data, bool isWanted)
{
  return isWanted ? ArrayReader::OfPoints(data, "").Seek(Velocity, 3) : nullptr;
}

/// Radii of particles, which have no other size.
vtkDataArray* RadiiOf(vtkPolyData* data)
{
  return data->GetPolys()->GetNumberOfCells() == 0 ? ArrayReader::OfPoints(data, "").Seek(plant::Radius, 1) : nullptr;
}

/// The first components of all tuples in single precision.
std::vector<float> NumbersOf(vtkDataArray* array, int components)
{
  std::vector<float> numbers;
  if (!array)
  {
    return numbers;
  }
  const vtkIdType count = array->GetNumberOfTuples();
  SetSize(numbers, count * components);
  auto* floats = vtkFloatArray::FastDownCast(array);
  if (floats && floats->GetNumberOfComponents() == components)
  {
    std::copy_n(floats->GetPointer(0), numbers.size(), numbers.begin());
    return numbers;
  }
  for (vtkIdType tuple = 0; tuple < count; ++tuple)
  {
    for (int component = 0; component < components; ++component)
    {
      numbers[tuple * components + component] = static_cast<float>(array->GetComponent(tuple, component));
    }
  }
  return numbers;
}

/// Triples become of unit length; those of no length point up.
void Normalise(std::vector<float>& triples)
{
  constexpr double least = 1e-20;
  for (std::size_t first = 0; first < triples.size(); first += 3)
  {
    const double x = triples[first], y = triples[first + 1], z = triples[first + 2];
    const double length = std::sqrt(x * x + y * y + z * z);
    const bool isSome = length > least;
    triples[first] = isSome ? static_cast<float>(x / length) : 0.0f;
    triples[first + 1] = isSome ? static_cast<float>(y / length) : 0.0f;
    triples[first + 2] = isSome ? static_cast<float>(z / length) : 1.0f;
  }
}

/// Linear colors of bytes in sRGB. A renderer multiplies them with the texels, of which Littoral's displays draw RGB *
/// texel / mean: the mean goes into the colors of the vertices.
std::vector<float> LinearColors(vtkUnsignedCharArray* colors, const ColorSum& mean)
{
  constexpr int levels = 256;
  constexpr double most = 255.0;
  std::array<std::array<float, levels>, 4> tables{};
  for (int level = 0; level < levels; ++level)
  {
    for (int part = 0; part < 3; ++part)
    {
      tables[part][level] = static_cast<float>(LinearOfSrgb(std::min(1.0, level / most / mean[part])));
    }
    tables[3][level] = static_cast<float>(level / most); // opacity is linear
  }
  const int parts = colors->GetNumberOfComponents();
  const unsigned char* byte = colors->GetPointer(0);
  std::vector<float> linear;
  SetSize(linear, colors->GetNumberOfValues());
  for (std::size_t value = 0; value < linear.size(); ++value)
  {
    linear[value] = tables[value % parts][byte[value]];
  }
  return linear;
}

/// Texture coordinates with v from above.
std::vector<float> FromAbove(vtkDataArray* coordinates)
{
  std::vector<float> numbers = NumbersOf(coordinates, 2);
  for (std::size_t v = 1; v < numbers.size(); v += 2)
  {
    numbers[v] = 1.0f - numbers[v];
  }
  return numbers;
}

/// Hands each run of points of a cell array to a task.
template <typename Task>
void ForCells(vtkCellArray* cells, const Task& task)
{
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, count, ids);
    task(ids, count);
  }
}

bool HasLargePolygons(vtkPolyData* data)
{
  return data->GetStrips()->GetNumberOfCells() > 0 || data->GetPolys()->GetMaxCellSize() > 4;
}

/// The same points with triangles in the place of polygons of more than four corners, and of strips.
vtkSmartPointer<vtkPolyData> Triangulated(vtkPolyData* data)
{
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(data);
  filter->Update();
  return filter->GetOutput();
}

std::vector<std::uint32_t> TrianglesOf(vtkCellArray* polygons)
{
  std::vector<std::uint32_t> corners;
  SetSize(corners, 6 * polygons->GetNumberOfCells());
  corners.clear(); // with room for quadrilaterals
  ForCells(polygons, [&](const vtkIdType* ids, vtkIdType count) {
    for (vtkIdType corner = 2; corner < count; ++corner)
    {
      for (const vtkIdType id : { ids[0], ids[corner - 1], ids[corner] })
      {
        corners.push_back(static_cast<std::uint32_t>(id));
      }
    }
  });
  return corners;
}

std::vector<std::uint32_t> PairsOf(vtkCellArray* lines)
{
  std::vector<std::uint32_t> pairs;
  ForCells(lines, [&](const vtkIdType* ids, vtkIdType count) {
    for (vtkIdType end = 1; end < count; ++end)
    {
      pairs.push_back(static_cast<std::uint32_t>(ids[end - 1]));
      pairs.push_back(static_cast<std::uint32_t>(ids[end]));
    }
  });
  return pairs;
}

/// The vertices of data; all points where there are no cells.
std::vector<std::uint32_t> VerticesOf(vtkPolyData* data)
{
  std::vector<std::uint32_t> vertices;
  ForCells(data->GetVerts(),
    [&](const vtkIdType* ids, vtkIdType count) { vertices.insert(vertices.end(), ids, ids + count); });
  for (vtkIdType point = 0; data->GetNumberOfCells() == 0 && point < data->GetNumberOfPoints(); ++point)
  {
    vertices.push_back(static_cast<std::uint32_t>(point));
  }
  return vertices;
}

/// The middle of points in double precision that are far from the origin, in whole metres; else the origin.
std::array<double, 3> PlaceOf(vtkPolyData* data)
{
  constexpr double far = 1000.0; // [m]
  std::array<double, 3> place{};
  const double* bounds = data->GetPoints()->GetBounds();
  const bool isFar = std::any_of(bounds, bounds + 6, [](double bound) { return std::abs(bound) > far; });
  if (data->GetPoints()->GetDataType() == VTK_DOUBLE && isFar)
  {
    place = { { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]), 0.5 * (bounds[4] + bounds[5]) } };
    std::transform(place.begin(), place.end(), place.begin(), [](double number) { return std::round(number); });
  }
  return place;
}

std::vector<float> PositionsOf(vtkPoints* points, const std::array<double, 3>& place)
{
  if (!points || place == std::array<double, 3>{})
  {
    return NumbersOf(points ? points->GetData() : nullptr, 3);
  }
  std::vector<float> positions;
  SetSize(positions, 3 * points->GetNumberOfPoints());
  for (std::size_t n = 0; n < positions.size(); ++n)
  {
    const auto axis = static_cast<int>(n % 3);
    positions[n] =
      static_cast<float>(points->GetData()->GetComponent(static_cast<vtkIdType>(n / 3), axis) - place[axis]);
  }
  return positions;
}

/// The picture of a block, if there is one, must have a place on it.
void RequirePicture(vtkPolyData* data, const std::string& owner)
{
  RequireTexture(data, owner);
  const ArrayReader fields = ArrayReader::OfFields(data, owner);
  const bool hasPicture = fields.Has(plant::Texture);
  Require(!hasPicture && fields.Has(plant::TextureSize) ? owner + " has a TextureSize and no Texture." : "");
  const bool hasPlace = data->GetNumberOfPoints() == 0 || TextureCoordinatesOf(data);
  Require(hasPicture && !hasPlace ? owner + " has a Texture and no texture coordinates." : "");
}

}

//----------------------------------------------------------------------------
vtkUnsignedCharArray* ColorsOf(vtkPolyData* data)
{
  vtkPointData* arrays = data->GetPointData();
  const auto typed = [](vtkDataArray* array) {
    auto* bytes = vtkUnsignedCharArray::SafeDownCast(array);
    const int parts = bytes ? bytes->GetNumberOfComponents() : 0;
    return parts == 3 || parts == 4 ? bytes : nullptr;
  };
  vtkUnsignedCharArray* named = typed(arrays->GetArray(plant::RGB));
  return named ? named : typed(arrays->GetScalars());
}

//----------------------------------------------------------------------------
vtkDataArray* TextureCoordinatesOf(vtkPolyData* data)
{
  vtkDataArray* active = data->GetPointData()->GetTCoords();
  vtkDataArray* found = active ? active : ArrayReader::OfPoints(data, "").Any("TCoords");
  return found && found->GetNumberOfComponents() >= 2 ? found : nullptr;
}

//----------------------------------------------------------------------------
void RequireSurface(vtkPolyData* data, const std::string& owner)
{
  Require(data->GetNumberOfPoints() == 0 && data->GetNumberOfCells() > 0 ? owner + " has cells and no points." : "");
  RequireDrawing(data, owner);
  const ArrayReader points = ArrayReader::OfPoints(data, owner);
  points.NeedFinite(points.Find(Velocity, 3));
  points.NeedFinite(RadiiOf(data));
  RequirePicture(data, owner);
}

//----------------------------------------------------------------------------
double MeshBytes(vtkPolyData* data, bool hasVelocity)
{
  const auto points = static_cast<double>(data->GetNumberOfPoints());
  vtkUnsignedCharArray* colors = ColorsOf(data);
  const int floats = 3 + (NormalsOf(data) ? 3 : 0) + (TextureCoordinatesOf(data) ? 2 : 0) +
    (colors ? colors->GetNumberOfComponents() : 0) + (VelocityOf(data, hasVelocity) ? 3 : 0) + (RadiiOf(data) ? 1 : 0);
  const vtkIdType polygons = data->GetPolys()->GetNumberOfConnectivityIds() - 2 * data->GetPolys()->GetNumberOfCells();
  const vtkIdType lines = data->GetLines()->GetNumberOfConnectivityIds() - data->GetLines()->GetNumberOfCells();
  const double indices = 3.0 * static_cast<double>(polygons) + 2.0 * static_cast<double>(lines) +
    static_cast<double>(data->GetVerts()->GetNumberOfConnectivityIds());
  return sizeof(float) * floats * points + (points > VTK_UNSIGNED_SHORT_MAX ? 4.0 : 2.0) * std::max(0.0, indices);
}

//----------------------------------------------------------------------------
SceneMesh::Target PlacesAt(vtkPolyData* data, const std::array<double, 3>& place)
{
  SceneMesh::Target target = { PositionsOf(data->GetPoints(), place), NumbersOf(NormalsOf(data), 3) };
  Normalise(target.Normals);
  return target;
}

//----------------------------------------------------------------------------
SceneMesh MeshOf(vtkPolyData* data, bool hasVelocity, std::array<double, 3>& place)
{
  SceneMesh mesh;
  place = PlaceOf(data);
  const vtkSmartPointer<vtkPolyData> drawn =
    HasLargePolygons(data) ? Triangulated(data) : vtkSmartPointer<vtkPolyData>(data);
  mesh.Triangles = TrianglesOf(drawn->GetPolys());
  mesh.Lines = PairsOf(data->GetLines());
  mesh.Points = VerticesOf(data);
  if (mesh.Triangles.empty() && mesh.Lines.empty() && mesh.Points.empty())
  {
    return {};
  }
  mesh.Positions = PositionsOf(data->GetPoints(), place);
  mesh.Normals = NumbersOf(NormalsOf(data), 3);
  Normalise(mesh.Normals);
  mesh.TextureCoordinates = FromAbove(TextureCoordinatesOf(data));
  mesh.Velocities = NumbersOf(VelocityOf(data, hasVelocity), 3);
  mesh.Radii = NumbersOf(RadiiOf(data), 1);
  if (vtkUnsignedCharArray* colors = ColorsOf(data))
  {
    mesh.ColorParts = colors->GetNumberOfComponents();
    mesh.Colors = LinearColors(colors, ReadTextureMean(data));
  }
  return mesh;
}

}
