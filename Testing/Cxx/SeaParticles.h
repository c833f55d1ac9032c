// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Particles before an eye in the sea, and the blocks and counters of their levels.

#include "vtkParticleLevelOfDetailFilter.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cstring>
#include <limits>
#include <vector>

namespace littoral::testing
{

inline const char* const ParticleBlocks[3] = { "Near", "MasterSlave", "Far" };

/// Particles in a box before the eye at the origin, with an array of their own.
inline vtkNew<vtkPolyData> Particles(int count, int type = VTK_DOUBLE)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(5);
  const auto next = [&](double low, double high) {
    random->Next();
    return random->GetRangeValue(low, high);
  };
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  vtkNew<vtkFloatArray> tint;
  tint->SetName("Tint");
  for (int n = 0; n < count; ++n)
  {
    points->InsertNextPoint(next(-8.0, 8.0), next(-2.0, 20.0), next(-9.0, 0.0));
    tint->InsertNextValue(static_cast<float>(n));
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->GetPointData()->SetScalars(tint);
  return data;
}

inline void LookAlongY(vtkParticleLevelOfDetailFilter* levels)
{
  levels->SetViewPoint(0.0, 0.0, -4.0);
  levels->SetViewDirection(0.0, 1.0, 0.0);
  levels->SetViewAngle(40.0);
}

inline vtkPolyData* BlockOf(vtkAlgorithm* algorithm, int index)
{
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(algorithm->GetOutputDataObject(0));
  const char* name = blocks->GetMetaData(index)->Get(vtkCompositeDataSet::NAME());
  return name && std::strcmp(name, ParticleBlocks[index]) == 0 ? vtkPolyData::SafeDownCast(blocks->GetBlock(index))
                                                               : nullptr;
}

inline double Counter(vtkAlgorithm* algorithm, const char* name)
{
  vtkDataArray* array = algorithm->GetOutputDataObject(0)->GetFieldData()->GetArray(name);
  return array ? array->GetTuple1(0) : std::numeric_limits<double>::quiet_NaN();
}

inline void Append(std::vector<char>& bytes, vtkDataArray* array)
{
  const char* begin = static_cast<const char*>(array->GetVoidPointer(0));
  bytes.insert(bytes.end(), begin, begin + array->GetNumberOfValues() * array->GetDataTypeSize());
}

/// All bytes of the points and point arrays of the three blocks.
inline std::vector<char> BytesOf(vtkAlgorithm* algorithm)
{
  std::vector<char> bytes;
  for (int index = 0; index < 3; ++index)
  {
    vtkPolyData* block = BlockOf(algorithm, index);
    Append(bytes, block->GetPoints()->GetData());
    for (int n = 0; n < block->GetPointData()->GetNumberOfArrays(); ++n)
    {
      Append(bytes, block->GetPointData()->GetArray(n));
    }
  }
  return bytes;
}

}
