// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/PointPattern.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/Places.h"
#include "Numerics/InvalidInput.h"
#include "Numerics/ParameterCheck.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <utility>

namespace littoral
{

std::vector<PlanePosition> PlanePositionsOf(vtkPointSet* points)
{
  RequireLengths(points, "Input", FarForPoints);
  std::vector<PlanePosition> positions;
  SetSize(positions, points->GetNumberOfPoints());
  for (std::size_t n = 0; n < positions.size(); ++n)
  {
    double position[3];
    points->GetPoint(static_cast<vtkIdType>(n), position);
    positions[n] = { position[0], position[1] };
  }
  return positions;
}

std::uint64_t KeyOf(const std::vector<PlanePosition>& points, const std::vector<double>& properties)
{
  const auto hashOf = [](const auto& values) {
    const auto* bytes = reinterpret_cast<const char*>(values.data());
    return std::hash<std::string_view>()({ bytes, values.size() * sizeof(values.front()) });
  };
  return (31 * hashOf(points) + hashOf(properties)) | 1u;
}

ObservationWindow ReadWindow(vtkPointSet* points, const double origin[2], const double size[2])
{
  ObservationWindow window;
  if (size[0] == 0.0 && size[1] == 0.0)
  {
    double bounds[6];
    points->GetBounds(bounds);
    const bool hasArea = bounds[1] > bounds[0] && bounds[3] > bounds[2];
    Require(hasArea ? "" : "The points cover no area; set the Size of the window.");
    window = ObservationWindow::Rectangle({ bounds[0], bounds[2] }, { bounds[1], bounds[3] });
    Require(window.WhyInvalid());
    return window;
  }
  ParameterCheck check;
  for (int axis = 0; axis < 2; ++axis)
  {
    const std::string component = "[" + std::to_string(axis) + "]";
    check.Finite("Origin" + component, origin[axis], "m");
    check.Positive("Size" + component, size[axis], "m");
  }
  Require(check.Reason());
  window = ObservationWindow::Rectangle({ origin[0], origin[1] }, { origin[0] + size[0], origin[1] + size[1] });
  Require(window.WhyInvalid());
  return window;
}

ObservationWindow ReadWindow(vtkPolyData* polygon)
{
  const vtkIdType cells = polygon->GetNumberOfPolys() + polygon->GetNumberOfLines();
  if (cells > 1)
  {
    Refuse("The window has ", cells, " polygons or lines; it must have one.");
  }
  vtkNew<vtkIdList> ids;
  if (cells == 1)
  {
    (polygon->GetNumberOfPolys() > 0 ? polygon->GetPolys() : polygon->GetLines())->GetCellAtId(0, ids);
  }
  const vtkIdType count = cells == 1 ? ids->GetNumberOfIds() : polygon->GetNumberOfPoints();
  std::vector<PlanePosition> corners;
  for (vtkIdType n = 0; n < count; ++n)
  {
    const vtkIdType id = cells == 1 ? ids->GetId(n) : n;
    const bool isThere = id >= 0 && id < polygon->GetNumberOfPoints();
    Require(isThere ? "" : "The window's polygon names a point that it does not have.");
    double position[3];
    polygon->GetPoint(id, position);
    corners.push_back({ position[0], position[1] });
  }
  ObservationWindow window = ObservationWindow::Polygon(std::move(corners));
  Require(window.WhyInvalid());
  return window;
}

std::vector<double> ReadMarks(vtkPointSet* points, const std::string& name)
{
  std::vector<double> marks;
  vtkDataArray* array = ArrayReader::OfPoints(points, "The input").Need(name.c_str(), 1);
  SetSize(marks, array->GetNumberOfTuples());
  for (vtkIdType n = 0; n < array->GetNumberOfTuples(); ++n)
  {
    const double mark = array->GetComponent(n, 0);
    if (!IsSensible(mark) || mark <= 0.0)
    {
      Refuse("The mark ", name, " of point ", n, " is missing or not positive.");
    }
    marks[static_cast<std::size_t>(n)] = mark;
  }
  return marks;
}

std::vector<std::string> ReadSpecies(vtkPointSet* points, const std::string& name)
{
  std::vector<std::string> species;
  SetSize(species, points->GetNumberOfPoints());
  const ArrayReader reader = ArrayReader::OfPoints(points, "The input");
  if (vtkStringArray* texts = reader.FindTexts(name.c_str()))
  {
    for (vtkIdType n = 0; n < points->GetNumberOfPoints(); ++n)
    {
      species[static_cast<std::size_t>(n)] = texts->GetValue(n);
    }
    return species;
  }
  vtkDataArray* array = reader.Need(name.c_str(), 1);
  for (vtkIdType n = 0; n < array->GetNumberOfTuples(); ++n)
  {
    species[static_cast<std::size_t>(n)] = TextOf(array->GetComponent(n, 0));
  }
  return species;
}

}
