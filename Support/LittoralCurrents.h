// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCurrents_h
#define LittoralCurrents_h

// Flow primitives between the numerics and VTK. Private: never installed, never wrapped.

#include "FlowPrimitives.h"
#include "LittoralSea.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <string>
#include <vector>

namespace littoral
{

/// A vertex a primitive, with its arrays.
inline void WriteFlowPrimitives(const std::vector<FlowPrimitive>& primitives, vtkPolyData* data)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkIntArray> type;
  type->SetName(sea::FlowType);
  vtkNew<vtkDoubleArray> axis;
  axis->SetName(sea::Axis);
  axis->SetNumberOfComponents(3);
  for (const FlowPrimitive& primitive : primitives)
  {
    const vtkIdType id = points->InsertNextPoint(&primitive.Centre[0]);
    vertices->InsertNextCell(1, &id);
    type->InsertNextValue(static_cast<int>(primitive.Type));
    axis->InsertNextTuple(&primitive.Axis[0]);
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
}

/// Whether a data set holds flow primitives, and no field of velocities.
inline bool HoldsFlowPrimitives(vtkDataSet* data)
{
  return vtkPointSet::SafeDownCast(data) && data->GetPointData()->GetArray(sea::FlowType);
}

/// Adds the primitives of a data set. Why they cannot be read, in words for a user; empty when they were.
inline std::string ReadFlowPrimitives(vtkDataSet* data, std::vector<FlowPrimitive>& primitives)
{
  const auto array = [data](const char* name) { return data->GetPointData()->GetArray(name); };
  for (const char* name : { sea::FlowType, sea::Strength, sea::Axis, sea::CoreRadius, sea::InfluenceRadius })
  {
    const int components = name == sea::Axis ? 3 : 1;
    if (!array(name) || array(name)->GetNumberOfComponents() != components)
    {
      return std::string("the flow primitives have no point array ") + name + " of " + std::to_string(components) +
        (components > 1 ? " components." : " component.");
    }
  }
  for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id)
  {
    FlowPrimitive primitive;
    const double type = array(sea::FlowType)->GetTuple1(id);
    primitive.Type = static_cast<FlowType>(type >= 0.0 && type < 4.0 ? static_cast<int>(type) : -1);
    primitive.Strength = array(sea::Strength)->GetTuple1(id);
    data->GetPoint(id, &primitive.Centre[0]);
    array(sea::Axis)->GetTuple(id, &primitive.Axis[0]);
    primitive.CoreRadius = array(sea::CoreRadius)->GetTuple1(id);
    primitive.InfluenceRadius = array(sea::InfluenceRadius)->GetTuple1(id);
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

#endif
