// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/FlowPrimitiveData.h"

#include "Data/ArrayReader.h"
#include "Data/SeaStateTable.h"
#include "Numerics/InvalidInput.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace littoral
{

void WriteFlowPrimitives(const std::vector<FlowPrimitive>& primitives, vtkPolyData* data)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkIntArray> type;
  type->SetName(sea::FlowType);
  vtkNew<vtkDoubleArray> axis;
  axis->SetName(sea::Axis);
  axis->SetNumberOfComponents(3);
  vtkNew<vtkDoubleArray> box;
  box->SetName(sea::InfluenceBox);
  box->SetNumberOfComponents(6);
  for (const FlowPrimitive& primitive : primitives)
  {
    const vtkIdType id = points->InsertNextPoint(&primitive.Center[0]);
    vertices->InsertNextCell(1, &id);
    type->InsertNextValue(static_cast<int>(primitive.Type));
    axis->InsertNextTuple(&primitive.Axis[0]);
    for (int side = 0; side < 6; ++side)
    {
      box->InsertNextValue((side % 2 ? primitive.InfluenceBox.High : primitive.InfluenceBox.Low)[side / 2]);
    }
  }
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->GetPointData()->AddArray(type);
  const auto add = [&](const char* name, double FlowPrimitive::*member) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    for (const FlowPrimitive& primitive : primitives)
    {
      array->InsertNextValue(primitive.*member);
    }
    data->GetPointData()->AddArray(array);
  };
  add(sea::Strength, &FlowPrimitive::Strength);
  data->GetPointData()->AddArray(axis);
  add(sea::CoreRadius, &FlowPrimitive::CoreRadius);
  add(sea::InfluenceRadius, &FlowPrimitive::InfluenceRadius);
  // Also where there are no boxes, or appending other primitives to some that have them would lose these.
  data->GetPointData()->AddArray(box);
  add(sea::InfluenceMargin, &FlowPrimitive::InfluenceMargin);
}

bool HoldsFlowPrimitives(vtkDataSet* data)
{
  return vtkPointSet::SafeDownCast(data) && ArrayReader::OfPoints(data, "").Has(sea::FlowType);
}

void ReadFlowPrimitives(vtkDataSet* data, std::vector<FlowPrimitive>& primitives)
{
  const ArrayReader points = ArrayReader::OfPoints(data, "a set of flow primitives");
  const bool hasBoxes = points.Has(sea::InfluenceBox) || points.Has(sea::InfluenceMargin);
  vtkDataArray* types = points.Need(sea::FlowType, 1);
  vtkDataArray* strengths = points.Need(sea::Strength, 1);
  vtkDataArray* axes = points.Need(sea::Axis, 3);
  vtkDataArray* cores = points.Need(sea::CoreRadius, 1);
  vtkDataArray* radii = points.Need(sea::InfluenceRadius, 1);
  vtkDataArray* boxes = hasBoxes ? points.Need(sea::InfluenceBox, 6) : nullptr;
  vtkDataArray* margins = hasBoxes ? points.Need(sea::InfluenceMargin, 1) : nullptr;
  for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id)
  {
    FlowPrimitive primitive;
    const std::string name = "flow primitive " + std::to_string(id) + ": ";
    ReadWhole(name + sea::FlowType, types->GetComponent(id, 0), 0, NumberOfFlowTypes - 1, primitive.Type);
    primitive.Strength = strengths->GetComponent(id, 0);
    data->GetPoint(id, &primitive.Center[0]);
    axes->GetTuple(id, &primitive.Axis[0]);
    primitive.CoreRadius = cores->GetComponent(id, 0);
    primitive.InfluenceRadius = radii->GetComponent(id, 0);
    for (int side = 0; hasBoxes && side < 6; ++side)
    {
      Box& box = primitive.InfluenceBox;
      (side % 2 ? box.High : box.Low)[side / 2] = boxes->GetComponent(id, side);
    }
    primitive.InfluenceMargin = hasBoxes ? margins->GetComponent(id, 0) : 0.0;
    InContext(name, [&] { Require(WhyInvalid(primitive)); });
    primitives.push_back(primitive);
  }
}

}
