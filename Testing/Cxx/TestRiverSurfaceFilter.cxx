// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of rivers through the pipeline: of a drained terrain, on their ground, every bad input.
#include "Check.h"
#include "ErrorCounter.h"
#include "vtkDrainageFilter.h"
#include "vtkRiverSurfaceFilter.h"
#include "vtkTurningBandsTerrainSource.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>
#include <cstdlib>
#include <limits>

namespace
{

/// A river of three points, 100 m to the east, which drains 4 km^2.
vtkNew<vtkPolyData> Brook(double area = 4e6)
{
  vtkNew<vtkPolyData> lines;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> areas;
  areas->SetName("DrainageArea");
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(3);
  for (int k = 0; k < 3; ++k)
  {
    cells->InsertCellPoint(points->InsertNextPoint(50.0 * k, 0.0, 10.0 - k));
    areas->InsertNextValue(area);
  }
  lines->SetPoints(points);
  lines->SetLines(cells);
  lines->GetPointData()->AddArray(areas);
  return lines;
}

double WidthAt(vtkPolyData* surface, vtkIdType point)
{
  return surface->GetPointData()->GetArray("ChannelWidth")->GetComponent(point, 0);
}

/// Of each pair of points the first is on the left bank.
bool HasBanks(vtkPolyData* surface)
{
  vtkDataArray* banks = surface->GetPointData()->GetArray("Bank");
  bool good = banks != nullptr;
  for (vtkIdType point = 0; good && point < surface->GetNumberOfPoints(); ++point)
  {
    good = banks->GetComponent(point, 0) == (surface->GetPoint(point)[1] > 0.0 ? 1.0 : -1.0);
  }
  return Check(good, "Banks are not left and right of a river.");
}

/// Triangles face upward, and rivers of a real network fall from section to section.
bool RiversOfATerrain()
{
  vtkNew<vtkTurningBandsTerrainSource> terrain;
  terrain->SetWholeExtent(0, 90, 0, 70, 0, 0);
  vtkNew<vtkDrainageFilter> drainage;
  drainage->SetInputConnection(terrain->GetOutputPort());
  drainage->SetMaximumNumberOfIterations(3);
  vtkNew<vtkRiverSurfaceFilter> rivers;
  rivers->SetInputConnection(drainage->GetOutputPort(1));
  rivers->SetTerrainConnection(drainage->GetOutputPort(0));
  rivers->Update();
  vtkPolyData* surface = rivers->GetOutput();
  const vtkIdType courses = drainage->GetOutputDataObject(1)
    ? vtkPolyData::SafeDownCast(drainage->GetOutputDataObject(1))->GetNumberOfLines()
    : 0;
  bool good = Check(courses > 10 && surface->GetNumberOfPolys() > 8 * courses, "no rivers, or no surface of them");
  vtkIdType faceDown = 0;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corner = nullptr;
    surface->GetCellPoints(cell, size, corner);
    double a[3];
    double b[3];
    double c[3];
    surface->GetPoint(corner[0], a);
    surface->GetPoint(corner[1], b);
    surface->GetPoint(corner[2], c);
    faceDown += (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) < 0.0;
    good &= Check(a[2] >= c[2] - 1e-9, "water runs upward");
  }
  // A few at bends that are narrower than their river is wide
  return good & Check(faceDown < surface->GetNumberOfCells() / 50, "the surface faces down");
}

bool WidthsAndLifts()
{
  vtkNew<vtkRiverSurfaceFilter> rivers;
  rivers->SetInputData(Brook());
  rivers->SetWidthOfUnitArea(3.0);
  rivers->SetWidthExponent(0.5);
  rivers->SetSubdivision(5);
  rivers->SetLift(0.25);
  rivers->Update();
  vtkPolyData* surface = rivers->GetOutput();
  bool good = Check(surface->GetNumberOfPoints() == 22 && surface->GetNumberOfPolys() == 20, "another size");
  good &= Check(std::abs(WidthAt(surface, 0) - 6.0) < 1e-12, "another width");
  good &= HasBanks(surface);
  const double* first = surface->GetPoint(0);
  good &= Check(first[0] == 0.0 && std::abs(first[1] - 3.0) < 1e-12 && first[2] == 10.25, "another left bank");
  return good;
}

/// On a terrain a river has its height, and stands before a hump that it has to pass.
bool FollowsItsGround()
{
  vtkNew<vtkImageData> terrain;
  terrain->SetDimensions(5, 2, 1);
  terrain->SetSpacing(25.0, 10.0, 1.0);
  terrain->SetOrigin(0.0, -5.0, 0.0);
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Elevation");
  for (const double height : { 7.0, 5.0, 6.0, 5.0, 2.0, 7.0, 5.0, 6.0, 5.0, 2.0 })
  {
    heights->InsertNextValue(height);
  }
  terrain->GetPointData()->SetScalars(heights);
  vtkNew<vtkRiverSurfaceFilter> rivers;
  rivers->SetInputData(0, Brook());
  rivers->SetInputData(1, terrain);
  rivers->SetSubdivision(1);
  rivers->SetLift(0.0);
  rivers->Update();
  vtkPolyData* surface = rivers->GetOutput();
  const bool good =
    Check(surface->GetPoint(0)[2] == 7.0 && surface->GetPoint(2)[2] == 6.0 && surface->GetPoint(4)[2] == 2.0,
      "a river is not on its ground");
  heights->SetValue(2, 9.0);
  heights->SetValue(7, 9.0);
  heights->Modified();
  terrain->Modified();
  rivers->Update();
  return good & Check(surface->GetPoint(0)[2] == 9.0, "no water before a hump");
}

bool BadInputs()
{
  vtkNew<vtkRiverSurfaceFilter> rivers;
  vtkNew<ErrorCounter> errors;
  errors->Watch(rivers);
  bool good = true;
  const auto lines = Brook();
  rivers->SetInputData(lines);
  for (const double area : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    lines->GetPointData()->GetArray("DrainageArea")->SetComponent(1, 0, area);
    good &= errors->ExpectOneNaming("DrainageArea");
  }
  lines->GetPointData()->RemoveArray("DrainageArea");
  good &= errors->ExpectOneNaming("DrainageArea");
  good &= Check(rivers->GetOutput()->GetNumberOfPoints() == 0, "something is left after a mistake");
  rivers->SetInputData(Brook());
  rivers->SetWidthExponent(2.0);
  good &= errors->ExpectOneNaming("WidthExponent");
  rivers->SetWidthExponent(0.5);
  rivers->SetLift(std::numeric_limits<double>::infinity());
  good &= errors->ExpectOneNaming("Lift");
  rivers->SetLift(0.0);
  vtkNew<vtkPolyData> points;
  points->SetPoints(Brook()->GetPoints());
  rivers->SetInputData(points);
  good &= errors->ExpectOneNaming("no lines");
  const auto torn = Brook();
  torn->GetLines()->InsertNextCell({ 0, 1 << 30 });
  rivers->SetInputData(torn);
  good &= errors->ExpectOneNaming("a cell with point 1073741824");
  vtkNew<vtkPolyData> none;
  rivers->SetInputData(none);
  rivers->Update();
  return good & Check(rivers->GetOutput()->GetNumberOfCells() == 0, "rivers of nothing");
}

}

int TestRiverSurfaceFilter(int, char*[])
{
  bool good = RiversOfATerrain();
  good &= WidthsAndLifts();
  good &= FollowsItsGround();
  good &= BadInputs();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
