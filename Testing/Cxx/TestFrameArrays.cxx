// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Frames of a swaying tree and of kelp take each other's memory in turn, and never that of one which somebody holds.
#include "PlantChecks.h"
#include "vtkBeamTreeDeformationFilter.h"
#include "vtkReevesTreeSource.h"
#include "vtkSeaStateSource.h"
#include "vtkSeaweedDeformationFilter.h"
#include "vtkSeaweedSource.h"
#include "vtkWindFieldSource.h"

#include "vtkFloatArray.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

namespace
{

/// What moves of a block, as it is kept by VTK.
vtkFloatArray* Moving(vtkAlgorithm* plants, bool normals)
{
  vtkPolyData* part = PartOf(plants, "High/Skin");
  return vtkFloatArray::SafeDownCast(normals ? part->GetPointData()->GetNormals() : part->GetPoints()->GetData());
}

std::vector<float> Values(vtkFloatArray* array)
{
  return { array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues() };
}

/// Whether the kept ranges and bounds are those of the values.
bool HasTrueRanges(vtkFloatArray* array)
{
  bool good = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    float low = std::numeric_limits<float>::max();
    float high = -low;
    for (vtkIdType n = 0; n < array->GetNumberOfTuples(); ++n)
    {
      low = std::min(low, array->GetTypedComponent(n, axis));
      high = std::max(high, array->GetTypedComponent(n, axis));
    }
    double range[2];
    array->GetRange(range, axis);
    good = good && range[0] == static_cast<double>(low) && range[1] == static_cast<double>(high);
  }
  return good;
}

/// Takes a filter through frames, some of them held.
template <typename Make>
bool FramesAreTheirOwn(const Make& make)
{
  const auto plants = make();
  std::vector<vtkSmartPointer<vtkFloatArray>> held;
  std::vector<std::vector<float>> values;
  std::set<float*> places;
  bool good = true;
  for (int frame = 0; frame < 9; ++frame)
  {
    const double time = 0.37 * frame;
    plants->UpdateTimeStep(time);
    const auto fresh = make();
    fresh->UpdateTimeStep(time);
    for (const bool normals : { false, true })
    {
      vtkFloatArray* array = Moving(plants, normals);
      good &= Check(Values(array) == Values(Moving(fresh, normals)), "a frame differs from a fresh one");
      good &= Check(HasTrueRanges(array), "ranges of another frame");
      if (frame < 4)
      {
        held.emplace_back(array);
        values.push_back(Values(array));
      }
      places.insert(frame < 4 ? nullptr : array->GetPointer(0));
    }
  }
  for (std::size_t n = 0; n < held.size(); ++n)
  {
    good &= Check(Values(held[n]) == values[n], "a frame that was held has changed");
  }
  // Five frames that nobody held: points and normals each at one place, or two.
  good &= Check(places.size() <= 1 + 4, "frames take new memory each");
  return good;
}

vtkSmartPointer<vtkAlgorithm> Tree()
{
  vtkNew<vtkReevesTreeSource> tree;
  vtkNew<vtkWindFieldSource> wind;
  wind->SetDimensions(64, 4, 8);
  auto sway = vtkSmartPointer<vtkBeamTreeDeformationFilter>::New();
  sway->SetInputConnection(tree->GetOutputPort());
  sway->SetWindConnection(wind->GetOutputPort());
  return sway;
}

vtkSmartPointer<vtkAlgorithm> Kelp()
{
  vtkNew<vtkSeaweedSource> kelp;
  vtkNew<vtkSeaStateSource> sea;
  sea->SetSeaLevel(8.0);
  auto swell = vtkSmartPointer<vtkSeaweedDeformationFilter>::New();
  swell->SetInputConnection(kelp->GetOutputPort());
  swell->SetSeaStateConnection(sea->GetOutputPort());
  return swell;
}

}

int TestFrameArrays(int, char*[])
{
  bool good = FramesAreTheirOwn(Tree);
  good &= FramesAreTheirOwn(Kelp);
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
