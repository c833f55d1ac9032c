// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/FlowPrimitiveData.h"

#include "Data/SeaStateTable.h"

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

namespace
{

/// Why a point array of some components is missing, in words for a user; empty if it is there.
std::string WhyMissing(vtkDataSet* data, const char* name, int components)
{
  vtkDataArray* array = data->GetPointData()->GetArray(name);
  if (!array || array->GetNumberOfComponents() != components)
  {
    return std::string("the flow primitives have no point array ") + name + " of " + std::to_string(components) +
      (components > 1 ? " components." : " component.");
  }
  if (array->GetNumberOfTuples() != data->GetNumberOfPoints())
  {
    return std::string("the flow primitives' point array ") + name + " has " +
      std::to_string(array->GetNumberOfTuples()) + " values for " + std::to_string(data->GetNumberOfPoints()) +
      " points.";
  }
  return "";
}

}

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
  return vtkPointSet::SafeDownCast(data) && data->GetPointData()->GetArray(sea::FlowType);
}

std::string ReadFlowPrimitives(vtkDataSet* data, std::vector<FlowPrimitive>& primitives)
{
  const auto array = [data](const char* name) { return data->GetPointData()->GetArray(name); };
  const bool hasBoxes = array(sea::InfluenceBox) || array(sea::InfluenceMargin);
  const struct
  {
    const char* Name;
    int Components;
    bool IsNeeded;
  } arrays[] = { { sea::FlowType, 1, true }, { sea::Strength, 1, true }, { sea::Axis, 3, true },
    { sea::CoreRadius, 1, true }, { sea::InfluenceRadius, 1, true }, { sea::InfluenceBox, 6, hasBoxes },
    { sea::InfluenceMargin, 1, hasBoxes } };
  for (const auto& one : arrays)
  {
    const std::string reason = one.IsNeeded ? WhyMissing(data, one.Name, one.Components) : "";
    if (!reason.empty())
    {
      return reason;
    }
  }
  for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id)
  {
    FlowPrimitive primitive;
    const double type = array(sea::FlowType)->GetTuple1(id);
    primitive.Type = static_cast<FlowType>(type >= 0.0 && type < NumberOfFlowTypes ? static_cast<int>(type) : -1);
    primitive.Strength = array(sea::Strength)->GetTuple1(id);
    data->GetPoint(id, &primitive.Center[0]);
    array(sea::Axis)->GetTuple(id, &primitive.Axis[0]);
    primitive.CoreRadius = array(sea::CoreRadius)->GetTuple1(id);
    primitive.InfluenceRadius = array(sea::InfluenceRadius)->GetTuple1(id);
    for (int side = 0; hasBoxes && side < 6; ++side)
    {
      Box& box = primitive.InfluenceBox;
      (side % 2 ? box.High : box.Low)[side / 2] = array(sea::InfluenceBox)->GetComponent(id, side);
    }
    primitive.InfluenceMargin = hasBoxes ? array(sea::InfluenceMargin)->GetTuple1(id) : 0.0;
    const std::string reason = WhyInvalid(primitive);
    if (!reason.empty())
    {
      return "flow primitive " + std::to_string(id) + ": " + reason;
    }
    primitives.push_back(primitive);
  }
  return "";
}

}
