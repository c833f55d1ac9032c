// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/CurrentData.h"

#include "Currents/ColumnVelocity.h"
#include "Currents/LinearVelocity.h"
#include "Currents/SplineVelocity.h"
#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/Cells.h"
#include "Data/FlowPrimitiveData.h"
#include "Data/Inputs.h"
#include "Data/Places.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Pipeline.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSmartPointer.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace littoral
{

namespace
{

/// Velocities as numbers in memory; the array is kept alive.
class Velocities
{
public:
  explicit Velocities(vtkDataArray* array)
    : Array(array)
  {
    if (auto* single = vtkFloatArray::SafeDownCast(array))
    {
      this->Single = single->GetPointer(0);
    }
    else if (auto* twice = vtkDoubleArray::SafeDownCast(array))
    {
      this->Double = twice->GetPointer(0);
    }
    else
    {
      const auto copy = WithType<vtkDoubleArray>(array);
      this->Array = copy;
      this->Double = copy->GetPointer(0);
    }
  }

  bool IsSingle() const { return this->Single != nullptr; }

  /// Velocity of a point; none on land.
  Vector3 operator()(vtkIdType id) const
  {
    const Vector3 value = this->Stored(id);
    return IsWater(value) ? value : Vector3(0.0);
  }

  bool IsWater(vtkIdType id) const { return IsWater(this->Stored(id)); }

private:
  Vector3 Stored(vtkIdType id) const
  {
    return this->Single ? Vector3(this->Single[3 * id], this->Single[3 * id + 1], this->Single[3 * id + 2])
                        : Vector3(this->Double[3 * id], this->Double[3 * id + 1], this->Double[3 * id + 2]);
  }

  /// Land has no number, or one as large as ocean models write there.
  static bool IsWater(const Vector3& value)
  {
    const double largest = std::max({ std::abs(value.x), std::abs(value.y), std::abs(value.z) });
    return IsFinite(value) && largest <= MaximumMagnitude;
  }

  vtkSmartPointer<vtkDataArray> Array;
  const float* Single = nullptr;
  const double* Double = nullptr;
};

class ImageVelocity : public SampledVelocity
{
public:
  ImageVelocity(vtkImageData* image, vtkDataArray* array)
    : Values(array)
  {
    int extent[6];
    image->GetExtent(extent);
    const vtkMatrix4x4* matrix = image->GetPhysicalToIndexMatrix();
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Samples[axis] = extent[2 * axis + 1] - extent[2 * axis] + 1;
      for (int column = 0; column < 3; ++column)
      {
        this->Turn[axis][column] = matrix->GetElement(axis, column);
      }
    }
    image->TransformIndexToPhysicalPoint(extent[0], extent[2], extent[4], &this->Corner[0]);
    image->GetBounds(this->Bounds);
    this->IsUpright = this->Turn[0].z == 0.0 && this->Turn[1].z == 0.0 && this->Turn[2].x == 0.0 &&
      this->Turn[2].y == 0.0 && this->Turn[2].z != 0.0;
  }

  std::vector<double> Nodes(int axis) const override
  {
    std::vector<double> nodes(static_cast<std::size_t>(this->Samples[axis]));
    std::iota(nodes.begin(), nodes.end(), 0.0);
    return nodes;
  }

  Vector3 PositionOf(const Vector3& place) const override
  {
    const Vector3 arm = place - this->Corner;
    return { glm::dot(this->Turn[0], arm), glm::dot(this->Turn[1], arm), glm::dot(this->Turn[2], arm) };
  }

  Vector3 Sample(std::size_t id) const override { return this->Values(static_cast<vtkIdType>(id)); }

  bool IsWater(std::size_t id) const override { return this->Values.IsWater(static_cast<vtkIdType>(id)); }

  bool IsSingle() const override { return this->Values.IsSingle(); }

  GridHeights Heights() const override
  {
    if (this->IsUpright && this->Samples[2] == 1)
    {
      return {};
    }
    const double step = this->IsUpright ? 1.0 / std::abs(this->Turn[2].z) : 0.0;
    return { this->Bounds[4], this->Bounds[5], step, step };
  }

  bool IsLevelAt(double height) const override
  {
    AxisPlace at;
    return this->IsUpright && FindPlace(this->Samples[2], this->Turn[2].z * (height - this->Corner.z), at) &&
      IsLevel(this->Values, this->Samples, at);
  }

  Vector3 Velocity(const Vector3& place) const override
  {
    const Vector3 position = this->PositionOf(place);
    std::array<AxisPlace, 3> at;
    for (int axis = 0; axis < 3; ++axis)
    {
      if (!FindPlace(this->Samples[axis], position[axis], at[axis]))
      {
        return Vector3(0.0);
      }
    }
    return Trilinear(this->Values, this->Samples, at);
  }

private:
  Velocities Values;
  std::array<int, 3> Samples;
  Vector3 Turn[3];
  Vector3 Corner;
  double Bounds[6];
  bool IsUpright; ///< whether its third axis is vertical, and the others level
};

class RectilinearVelocity : public SampledVelocity
{
public:
  RectilinearVelocity(vtkRectilinearGrid* grid, vtkDataArray* array)
    : Values(array)
  {
    vtkDataArray* axes[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(), grid->GetZCoordinates() };
    for (int axis = 0; axis < 3; ++axis)
    {
      for (vtkIdType id = 0; id < axes[axis]->GetNumberOfTuples(); ++id)
      {
        this->Coordinates[axis].push_back(axes[axis]->GetComponent(id, 0));
      }
      this->Samples[axis] = static_cast<int>(this->Coordinates[axis].size());
    }
  }

  std::vector<double> Nodes(int axis) const override { return this->Coordinates[axis]; }

  Vector3 PositionOf(const Vector3& place) const override { return place; }

  Vector3 Sample(std::size_t id) const override { return this->Values(static_cast<vtkIdType>(id)); }

  bool IsWater(std::size_t id) const override { return this->Values.IsWater(static_cast<vtkIdType>(id)); }

  bool IsSingle() const override { return this->Values.IsSingle(); }

  GridHeights Heights() const override
  {
    const std::vector<double>& z = this->Coordinates[2];
    const std::size_t count = z.size();
    if (count == 1)
    {
      return {};
    }
    const double firstStep = std::abs(z[1] - z[0]);
    const double lastStep = std::abs(z[count - 1] - z[count - 2]);
    return z.front() < z.back() ? GridHeights{ z.front(), z.back(), firstStep, lastStep }
                                : GridHeights{ z.back(), z.front(), lastStep, firstStep };
  }

  bool IsLevelAt(double height) const override
  {
    AxisPlace at;
    return FindPlace(this->Coordinates[2], height, at) && IsLevel(this->Values, this->Samples, at);
  }

  Vector3 Velocity(const Vector3& place) const override
  {
    std::array<AxisPlace, 3> at;
    for (int axis = 0; axis < 3; ++axis)
    {
      if (!FindPlace(this->Coordinates[axis], place[axis], at[axis]))
      {
        return Vector3(0.0);
      }
    }
    return Trilinear(this->Values, this->Samples, at);
  }

private:
  Velocities Values;
  std::array<int, 3> Samples;
  std::vector<double> Coordinates[3];
};

constexpr double BytesOfCell = 75.0; // in the locator

/// Any cells: the one around a place is found, and its own interpolation taken.
class CellVelocity : public VelocityGrid
{
public:
  CellVelocity(vtkDataSet* data, vtkDataArray* array)
    : Data(vtkSmartPointer<vtkDataSet>::Take(data->NewInstance()))
    , Values(array)
  {
    RequireMemory(BytesOfCell * static_cast<double>(data->GetNumberOfCells()), "The search in the cells of a current",
      "take a part of it");
    this->Data->ShallowCopy(data);
    this->Locator->SetDataSet(this->Data);
    this->Locator->BuildLocator();
    this->CellSize = std::max(1, this->Data->GetMaxCellSize());
    this->Scratch.Local().Cell->SetCellTypeToEmptyCell();
    this->Data->GetCell(0, this->Scratch.Local().Cell); // after this, data sets may be read from many threads
    this->Data->GetBounds(this->Bounds);
  }

  /// Ends count as at a wall if they are but for the rounding of points in single precision.
  GridHeights Heights() const override
  {
    const double step = 1e-5 * (this->Bounds[5] - this->Bounds[4]);
    return { this->Bounds[4], this->Bounds[5], step, step };
  }

  bool IsLevelAt(double height) const override
  {
    if (height != this->Bounds[4] && height != this->Bounds[5])
    {
      return false; // velocities there come from points above and below
    }
    for (vtkIdType id = 0; id < this->Data->GetNumberOfPoints(); ++id)
    {
      if (this->Data->GetPoint(id)[2] == height && this->Values(id).z != 0.0)
      {
        return false;
      }
    }
    return true;
  }

  Vector3 Velocity(const Vector3& place) const override
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (!(place[axis] >= this->Bounds[2 * axis] && place[axis] <= this->Bounds[2 * axis + 1]))
      {
        return Vector3(0.0);
      }
    }
    Tools& tools = this->Scratch.Local();
    tools.Weights.resize(static_cast<std::size_t>(this->CellSize));
    double x[3] = { place.x, place.y, place.z };
    double coordinates[3];
    const vtkIdType cell = this->Locator->FindCell(x, 0.0, tools.Cell, coordinates, tools.Weights.data());
    Vector3 sum(0.0);
    for (vtkIdType corner = 0; cell >= 0 && corner < tools.Cell->GetNumberOfPoints(); ++corner)
    {
      sum += tools.Weights[corner] * this->Values(tools.Cell->GetPointId(static_cast<int>(corner)));
    }
    return sum;
  }

private:
  /// Data of a thread of its own; a copy has its own too.
  struct Tools
  {
    vtkNew<vtkGenericCell> Cell;
    std::vector<double> Weights;

    Tools() = default;
    Tools(const Tools&) {}
    Tools& operator=(const Tools&) { return *this; }
  };

  vtkSmartPointer<vtkDataSet> Data;
  Velocities Values;
  vtkNew<vtkStaticCellLocator> Locator;
  int CellSize;
  double Bounds[6];
  mutable vtkSMPThreadLocal<Tools> Scratch;
};

/// Velocities in upright columns, in layers of points one after the other, as vtkOceanCurrentReader has them.
class ColumnData : public ColumnSamples
{
public:
  ColumnData(vtkPointSet* data, vtkDataArray* velocities, vtkIdType columns)
    : Places(data->GetPoints()->GetData())
    , Values(velocities)
    , Count(columns)
    , Single(vtkFloatArray::SafeDownCast(this->Places))
    , Double(vtkDoubleArray::SafeDownCast(this->Places))
  {
  }

  std::size_t Columns() const override { return static_cast<std::size_t>(this->Count); }
  int Layers() const override { return static_cast<int>(this->Places->GetNumberOfTuples() / this->Count); }
  double Height(std::size_t column, int layer) const override
  {
    const vtkIdType place = 3 * this->PointOf(column, layer) + 2;
    return this->Single ? this->Single->GetValue(place) : this->Double->GetValue(place);
  }
  Vector3 Sample(std::size_t column, int layer) const override { return this->Values(this->PointOf(column, layer)); }
  bool IsWater(std::size_t column, int layer) const override
  {
    return this->Values.IsWater(this->PointOf(column, layer));
  }

private:
  vtkIdType PointOf(std::size_t column, int layer) const
  {
    return layer * this->Count + static_cast<vtkIdType>(column);
  }

  vtkSmartPointer<vtkDataArray> Places;
  Velocities Values;
  vtkIdType Count;
  vtkFloatArray* Single;
  vtkDoubleArray* Double;
};

/// Number of the upright columns of points that a data set says to have layers of (field data `Layers`); 0 if it says
/// no number, or its points are not so.
vtkIdType ColumnsOf(vtkPointSet* data)
{
  vtkDataArray* layers = ArrayReader::OfFields(data, "a current", 1).Find("Layers", 1);
  const double told = layers ? layers->GetComponent(0, 0) : 0.0;
  const vtkIdType points = data->GetNumberOfPoints();
  const auto count = told >= 1.0 && told <= static_cast<double>(points) ? static_cast<vtkIdType>(told) : 0;
  vtkDataArray* places = data->GetPoints()->GetData();
  const bool isPlain = vtkFloatArray::SafeDownCast(places) || vtkDoubleArray::SafeDownCast(places);
  if (count == 0 || points % count != 0 || !isPlain)
  {
    return 0;
  }
  const vtkIdType columns = points / count;
  double above[3], below[3];
  for (vtkIdType point = columns; point < points; ++point)
  {
    data->GetPoint(point, above);
    data->GetPoint(point - columns, below);
    if (above[0] != below[0] || above[1] != below[1])
    {
      return 0;
    }
  }
  return columns;
}

/// Corners of the cells of the lowest layer in plan view, the first ones; none if there are cells of other kinds.
std::vector<FaceCorners> CornersOf(vtkPointSet* data, vtkIdType columns)
{
  std::vector<FaceCorners> corners;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    const int kind = data->GetCellType(cell);
    const int count = kind == VTK_WEDGE || kind == VTK_TRIANGLE ? 3
      : kind == VTK_HEXAHEDRON || kind == VTK_QUAD              ? 4
                                                                : 0;
    data->GetCellPoints(cell, ids);
    if (count == 0)
    {
      return {};
    }
    if (ids->GetId(0) >= columns)
    {
      break;
    }
    FaceCorners face{ -1, -1, -1, -1 };
    for (int c = 0; c < count; ++c)
    {
      if (ids->GetId(c) >= columns)
      {
        return {};
      }
      face[c] = static_cast<int>(ids->GetId(c));
    }
    corners.push_back(face);
  }
  return corners;
}

/// The velocity field of a data set in columns; null if it is not one.
std::shared_ptr<const VelocityGrid> ColumnsAsGrid(vtkDataSet* data, vtkDataArray* velocities, CoastBehaviour coast)
{
  auto* points = vtkPointSet::SafeDownCast(data);
  const vtkIdType columns = points && points->GetPoints() ? ColumnsOf(points) : 0;
  if (columns == 0 || columns > VTK_INT_MAX)
  {
    return nullptr;
  }
  RequireMemory(ColumnVelocity::BytesOf(static_cast<std::size_t>(columns), 2 * static_cast<std::size_t>(columns)),
    "The search in the columns of a current", "take a part of it");
  std::vector<FaceCorners> corners = CornersOf(points, columns);
  std::vector<std::array<double, 2>> places(static_cast<std::size_t>(columns));
  for (vtkIdType column = 0; column < columns; ++column)
  {
    double place[3];
    points->GetPoint(column, place);
    places[static_cast<std::size_t>(column)] = { place[0], place[1] };
  }
  if (corners.empty())
  {
    return nullptr;
  }
  return std::make_shared<ColumnVelocity>(
    std::make_shared<ColumnData>(points, velocities, columns), std::move(places), std::move(corners), coast);
}

/// Whether velocities can be interpolated: some cell is more than points and lines.
bool HasCells(vtkDataSet* data)
{
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    const int kind = data->GetCellType(cell);
    if (kind != VTK_EMPTY_CELL && kind != VTK_VERTEX && kind != VTK_POLY_VERTEX && kind != VTK_LINE &&
      kind != VTK_POLY_LINE)
    {
      return true;
    }
  }
  return false;
}

/// The array of velocities.
vtkDataArray* FindVelocities(vtkDataSet* data, const std::string& name)
{
  const ArrayReader points = ArrayReader::OfPoints(data, "a current (VelocityArray)");
  vtkDataArray* found = points.Find(name.empty() ? "Velocity" : name.c_str(), 3);
  if (!found && name.empty())
  {
    const std::vector<vtkDataArray*> all = points.All(3);
    found = all.empty() ? nullptr : all.back();
    Require(
      all.size() > 1 ? "a current has more than one point array of three components; name one in VelocityArray." : "");
  }
  if (!found)
  {
    const bool onCells = !name.empty() && ArrayReader::OfCells(data, "").Has(name.c_str());
    Refuse("a current has no point array ", name.empty() ? "of velocities" : "'" + name + "'",
      onCells ? "; it is on cells: bring it to the points first." : " (VelocityArray), and is no flow primitive.");
  }
  return found;
}

std::shared_ptr<const VelocityGrid> SplineOf(const std::shared_ptr<const SampledVelocity>& samples)
{
  RequireMemory(SplineVelocity::BytesOf(*samples, static_cast<int>(NumberOfThreads())), "The spline of a current",
    "take a part of it, or Linear as VelocityInterpolation");
  return std::make_shared<SplineVelocity>(samples, SmpFor);
}

void TakeDataSet(vtkDataSet* data, const std::string& name, VelocityInterpolation interpolation, CoastBehaviour coast,
  std::vector<FlowPrimitive>& primitives, std::vector<std::shared_ptr<const VelocityGrid>>& grids)
{
  const auto add = [&](const std::shared_ptr<const SampledVelocity>& samples) {
    const bool isSpline = interpolation == VelocityInterpolation::CubicSpline && SplineVelocity::CanBe(*samples);
    grids.push_back(isSpline ? SplineOf(samples) : samples);
  };
  if (data->GetNumberOfPoints() == 0)
  {
    return;
  }
  if (HoldsFlowPrimitives(data))
  {
    ReadFlowPrimitives(data, primitives);
    return;
  }
  vtkDataArray* velocities = FindVelocities(data, name);
  RequireCells(data, "a current");
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    add(std::make_shared<ImageVelocity>(image, velocities));
  }
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data))
  {
    add(std::make_shared<RectilinearVelocity>(rectilinear, velocities));
  }
  else if (const auto columns = ColumnsAsGrid(data, velocities, coast))
  {
    grids.push_back(columns);
  }
  else if (HasCells(data))
  {
    grids.push_back(std::make_shared<CellVelocity>(data, velocities));
  }
  else
  {
    Refuse("a current with velocities has no cells between whose points they could be interpolated.");
  }
}

}

CurrentSnapshot ReadCurrent(vtkDataObject* data, const std::string& array, const WaterLayer& layer,
  VelocityInterpolation interpolation, CoastBehaviour coast)
{
  std::vector<FlowPrimitive> primitives;
  std::vector<std::shared_ptr<const VelocityGrid>> grids;
  for (vtkDataObject* leaf : LeavesOf(data))
  {
    auto* leafData = vtkDataSet::SafeDownCast(leaf);
    Require(leafData ? "" : WhyOtherType(leaf, "Currents", "points or a grid (vtkDataSet)"));
    RequireFit(leaf, "Currents");
    RequireLengths(leafData, "A current", HoldsFlowPrimitives(leafData) ? FarForPoints : FarForGrid);
    TakeDataSet(leafData, array, interpolation, coast, primitives, grids);
  }
  return CurrentSnapshot(std::move(primitives), std::move(grids), layer);
}

std::vector<FlowSample> ReadSamples(vtkDataSet* data, const std::string& array)
{
  const Velocities velocities(FindVelocities(data, array));
  const vtkIdType count = data->GetNumberOfPoints();
  RequireMemoryOfList(static_cast<double>(count), sizeof(FlowSample));
  std::vector<FlowSample> samples;
  samples.reserve(static_cast<std::size_t>(count));
  for (vtkIdType id = 0; id < count; ++id)
  {
    Vector3 place;
    data->GetPoint(id, &place.x);
    if (velocities.IsWater(id) && IsSensible(place))
    {
      samples.push_back({ place, velocities(id) });
    }
  }
  return samples;
}

}
