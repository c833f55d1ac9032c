// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef DriftScene_h
#define DriftScene_h

// Points and currents for tests of drift.

#include "vtkCurrentDriftFilter.h"
#include "vtkFlowPrimitiveSource.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>
#include <vector>

namespace DriftScene
{

using Drift = vtkCurrentDriftFilter;
using Flow = vtkFlowPrimitiveSource;

/// Points within 8 m of a place, at depths to 10 m.
inline vtkNew<vtkPolyData> Particles(int count, int type = VTK_DOUBLE, double x = 0.0, double level = 0.0)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  for (int n = 0; n < count; ++n)
  {
    points->InsertNextPoint(x + 8.0 * std::sin(1.7 * n), 8.0 * std::cos(0.9 * n), level - 10.0 * (n + 0.5) / count);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  return data;
}

inline vtkNew<vtkPolyData> OneParticle(double x, double y, double z)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(x, y, z);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  return data;
}

inline vtkNew<Flow> Primitive(int type, double strength, double x, double y, double z, double core = 0.5)
{
  vtkNew<Flow> flow;
  flow->SetFlowType(type);
  flow->SetStrength(strength);
  flow->SetCenter(x, y, z);
  flow->SetCoreRadius(core);
  if (type == Flow::Vortex)
  {
    flow->SetAxis(0.0, 0.0, 1.0);
  }
  return flow;
}

inline std::vector<char> BytesOf(vtkDataArray* array)
{
  const char* begin = static_cast<const char*>(array->GetVoidPointer(0));
  return { begin, begin + array->GetNumberOfValues() * array->GetDataTypeSize() };
}

inline vtkPolyData* OutputOf(vtkAlgorithm* algorithm)
{
  return vtkPolyData::SafeDownCast(algorithm->GetOutputDataObject(0));
}

inline std::vector<char> Moved(Drift* drift, double time)
{
  drift->UpdateTimeStep(time);
  vtkPolyData* output = OutputOf(drift);
  std::vector<char> bytes = BytesOf(output->GetPoints()->GetData());
  const std::vector<char> captured = BytesOf(output->GetPointData()->GetArray("Captured"));
  bytes.insert(bytes.end(), captured.begin(), captured.end());
  return bytes;
}

/// A scene of all primitives, somewhere.
inline void Connect(Drift* drift, double x, double level, int type, int count)
{
  vtkNew<Flow> uniform = Primitive(Flow::Uniform, 0.2, 0.0, 0.0, 0.0);
  vtkNew<Flow> vortex = Primitive(Flow::Vortex, 4.0, x + 2.0, 1.0, level - 4.0);
  vortex->SetAxis(0.1, 0.2, 1.0);
  vortex->SetInfluenceRadius(6.0);
  vtkNew<Flow> source = Primitive(Flow::Source, 5.0, x - 3.0, 2.0, level - 6.0);
  vtkNew<Flow> sink = Primitive(Flow::Sink, 5.0, x + 5.0, -2.0, level - 3.0);
  drift->SetInputData(0, Particles(count, type, x, level));
  for (Flow* flow : { uniform.Get(), vortex.Get(), source.Get(), sink.Get() })
  {
    drift->AddCurrentConnection(flow->GetOutputPort());
  }
  drift->SetSeaLevel(level);
  drift->SetWaterDepth(11.0);
}

}

#endif
