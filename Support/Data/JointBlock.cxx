// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/JointBlock.h"

#include "Data/Arrays.h"

#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>

namespace littoral
{

vtkSmartPointer<vtkPolyData> JointBlock(const std::vector<JointChange>& changes, const std::vector<int>& parents)
{
  const auto count = static_cast<vtkIdType>(changes.size());
  const auto rests = NewArray<vtkFloatArray>(joint::RestPosition, 3, count);
  const auto rotations = NewArray<vtkFloatArray>(joint::Rotation, 4, count);
  const auto ids = NewArray<vtkIntArray>(joint::ParentId, 1, count);
  std::copy(parents.begin(), parents.end(), ids->GetPointer(0));
  std::vector<Vector3> places;
  places.reserve(changes.size());
  for (vtkIdType index = 0; index < count; ++index)
  {
    const auto& c = changes[index].Columns;
    const Vector3 rest(c[0][3], c[1][3], c[2][3]);
    // Columns hold R - 1, and the last one the shift.
    glm::dmat3 rotation(1.0);
    for (int column = 0; column < 3; ++column)
    {
      rotation[column] += Vector3(c[column][0], c[column][1], c[column][2]);
    }
    const glm::dquat turn = glm::normalize(glm::quat_cast(rotation));
    const double numbers[4] = { turn.w, turn.x, turn.y, turn.z };
    rests->SetTuple(index, &rest.x);
    rotations->SetTuple(index, numbers);
    places.push_back(rest + Vector3(c[3][0], c[3][1], c[3][2]));
  }
  auto block = vtkSmartPointer<vtkPolyData>::New();
  block->SetPoints(PointsOf(places));
  block->GetPointData()->AddArray(rests);
  block->GetPointData()->AddArray(rotations);
  block->GetPointData()->AddArray(ids);
  return block;
}

}
