// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Drawings of flow primitives: lengths, speeds, colors and rings, every bad input.
#include "Check.h"
#include "ErrorCounter.h"
#include "vtkFlowArrowFilter.h"
#include "vtkFlowPrimitiveSource.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace
{

/// The drawing of a primitive, with its speeds and colors.
struct Drawing
{
  vtkNew<vtkFlowArrowFilter> Filter;
  vtkPolyData* Data;
  vtkDataArray* Speeds;
  vtkDataArray* Colors;

  explicit Drawing(vtkFlowPrimitiveSource* source)
  {
    this->Filter->SetInputConnection(source->GetOutputPort());
    this->Filter->Update();
    this->Data = this->Filter->GetOutput();
    this->Speeds = this->Data->GetPointData()->GetArray("Speed");
    this->Colors = this->Data->GetPointData()->GetArray("RGB");
  }

  bool IsThere() const { return Check(this->Speeds && this->Colors, "There is no drawing"); }

  bool HasColor(vtkIdType point, double red, double green, double blue) const
  {
    const double* color = this->Colors->GetTuple3(point);
    return color[0] == red && color[1] == green && color[2] == blue;
  }
};

/// Everywhere the same: 37 arrows of a third of the drawing radius of 2 m, as fast as the flow, and no ring.
bool UniformFlow()
{
  vtkNew<vtkFlowPrimitiveSource> source;
  source->SetFlowTypeToUniform();
  source->SetStrength(0.7);
  source->SetCenter(5.0, 6.0, 7.0);
  source->SetAxis(3.0, 0.0, 0.0);
  const Drawing drawing(source);
  if (!drawing.IsThere())
  {
    return false;
  }
  bool good = Check(drawing.Data->GetNumberOfPoints() % 37 == 0, "There are not 37 arrows");
  double bounds[6];
  drawing.Data->GetBounds(bounds);
  good &= Check(std::abs(bounds[0] - (5.0 - 1.0 / 3.0)) < 1e-6 && std::abs(bounds[1] - (5.0 + 1.0 / 3.0)) < 1e-6,
    "The arrows are not as long as a third of the drawing");
  good &= Check(bounds[2] < 6.0 - 1.6 && bounds[2] > 6.0 - 1.8 && bounds[5] > 7.0 + 1.6 && bounds[5] < 7.0 + 1.8,
    "The arrows do not fill the drawing");
  double range[2];
  drawing.Speeds->GetRange(range);
  good &= Check(std::abs(range[0] - 0.7) < 1e-6 && std::abs(range[1] - 0.7) < 1e-6, "The arrows have another speed");
  return Check(drawing.HasColor(0, 250.0, 176.0, 64.0), "What is fastest is not amber") && good;
}

/// Around the axis, faster inside; a ring with the core radius and one with the influence radius, which have no speed.
bool Vortex()
{
  vtkNew<vtkFlowPrimitiveSource> source;
  source->SetFlowTypeToVortex();
  source->SetStrength(2.0);
  source->SetCenter(1.0, 2.0, 3.0);
  source->SetAxis(0.0, 0.0, 1.0);
  source->SetCoreRadius(0.5);
  source->SetInfluenceRadius(4.0);
  const Drawing drawing(source);
  if (!drawing.IsThere())
  {
    return false;
  }
  vtkIdType rings[2] = { 0, 0 };
  double fastest[2] = { 0.0, 0.0 }; // inside and outside
  bool good = true;
  for (vtkIdType point = 0; point < drawing.Data->GetNumberOfPoints(); ++point)
  {
    double place[3];
    drawing.Data->GetPoint(point, place);
    const double radius = std::hypot(place[0] - 1.0, place[1] - 2.0);
    const double speed = drawing.Speeds->GetComponent(point, 0);
    if (speed == 0.0)
    {
      const bool isOuter = radius > 2.0;
      ++rings[isOuter];
      good &= std::abs(radius - (isOuter ? 4.0 : 0.5)) < 0.04 && std::abs(place[2] - 3.0) < 0.04;
      good &= drawing.HasColor(point, 226.0, 236.0, 238.0);
    }
    else
    {
      fastest[radius > 1.6] = std::max(fastest[radius > 1.6], speed);
    }
  }
  good = Check(good, "A ring has another radius or color");
  good &= Check(rings[0] > 100 && rings[0] == rings[1], "There are not two rings");
  return Check(fastest[0] > fastest[1] && fastest[1] > 0.0, "The vortex is not faster inside") && good;
}

bool BadInput()
{
  vtkNew<vtkFlowArrowFilter> filter;
  vtkNew<ErrorCounter> errors;
  errors->Watch(filter);
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkPolyData> plain;
  plain->SetPoints(points);
  filter->SetInputData(plain);
  bool good = errors->ExpectOneNaming("FlowType");
  vtkNew<vtkFlowPrimitiveSource> source;
  source->SetFlowTypeToSource();
  source->SetInfluenceRadius(1e10);
  filter->SetInputConnection(source->GetOutputPort());
  good &= errors->ExpectOneNaming("1e+10 m");
  // Nothing to draw is no mistake.
  filter->SetInputData(vtkNew<vtkPolyData>());
  errors->Count = 0;
  filter->Update();
  return Check(errors->Count == 0 && filter->GetOutput()->GetNumberOfPoints() == 0, "Nothing is a mistake") && good;
}

}

int TestFlowArrowFilter(int, char*[])
{
  bool good = UniformFlow();
  good &= Vortex();
  good &= BadInput();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
