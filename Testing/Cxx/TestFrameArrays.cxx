// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Frames of a swaying tree and of kelp take each other's memory in turn, and never that of one which somebody holds,
// unless frames may be overwritten.
#include "Data/PlantBlocks.h"
#include "Data/PlantForm.h"
#include "PlantChecks.h"
#include "vtkBeamTreeDeformationFilter.h"
#include "vtkPlantScatterFilter.h"
#include "vtkReevesTreeSource.h"
#include "vtkSeaStateSource.h"
#include "vtkSeaweedDeformationFilter.h"
#include "vtkSeaweedSource.h"
#include "vtkWindFieldSource.h"

#include "vtkFloatArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <limits>
#include <set>
#include <string>
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

vtkSmartPointer<vtkBeamTreeDeformationFilter> Tree()
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

/// A frame that is held is written over where it may be, and each frame is what it is without that.
bool HeldFramesAreOverwritten()
{
  const auto plants = Tree();
  plants->OverwriteFramesOn();
  std::vector<vtkSmartPointer<vtkFloatArray>> held;
  bool good = true;
  for (int frame = 0; frame < 3; ++frame)
  {
    const double time = 0.37 * frame;
    plants->UpdateTimeStep(time);
    const auto fresh = Tree();
    fresh->UpdateTimeStep(time);
    for (const bool normals : { false, true })
    {
      vtkFloatArray* array = Moving(plants, normals);
      good &= Check(Values(array) == Values(Moving(fresh, normals)), "a frame over another differs from a fresh one");
      good &= Check(HasTrueRanges(array), "ranges of the frame that was written over");
      good &= Check(frame == 0 || array == held[normals], "a frame was not written over the one before");
      held.emplace_back(array);
    }
  }
  return good;
}

/// Kelp on a site.
struct KelpBed
{
  vtkNew<vtkPoints> Points;
  vtkNew<vtkPolyData> Sites;
  vtkNew<vtkPlantScatterFilter> Scatter;
  vtkNew<vtkSeaStateSource> Sea;
  vtkNew<vtkSeaweedDeformationFilter> Move;

  explicit KelpBed(double x)
  {
    vtkNew<vtkSeaweedSource> kelp;
    this->Points->InsertNextPoint(x, 0.0, 0.0);
    this->Sites->SetPoints(this->Points);
    this->Scatter->SetInputData(this->Sites);
    this->Scatter->AddPrototypeConnection(kelp->GetOutputPort());
    this->Scatter->UseLevelsOff();
    this->Scatter->UseCullingOff();
    this->Sea->SetSeaLevel(8.0);
    this->Move->SetInputConnection(this->Scatter->GetOutputPort());
    this->Move->SetSeaStateConnection(this->Sea->GetOutputPort());
  }

  /// Points of a skin at a time.
  std::vector<float> SkinAt(double time, const char* name)
  {
    this->Move->UpdateTimeStep(time);
    auto* plants = vtkMultiBlockDataSet::SafeDownCast(this->Move->GetOutputDataObject(0));
    return Values(
      vtkFloatArray::SafeDownCast(littoral::PlantPartOf(plants, littoral::plant::High, name)->GetPoints()->GetData()));
  }
};

/// Vertices of a holdfast are written once: again where the plants themselves have gone.
bool PlantsThatWentAreWrittenAnew()
{
  KelpBed bed(0.0);
  for (const double time : { 0.0, 0.3, 0.6 })
  {
    bed.Move->UpdateTimeStep(time);
  }
  bed.Points->SetPoint(0, 5.0, 0.0, 0.0);
  bed.Points->Modified();
  bed.Sites->Modified();
  KelpBed fresh(5.0);
  bool good = true;
  for (const char* name : { littoral::plant::Skin, littoral::plant::Leaves })
  {
    good &= Check(bed.SkinAt(0.9, name) == fresh.SkinAt(0.9, name), "a holdfast has stayed behind");
  }
  return good;
}

/// A bed with some plants out of view and others held, and a fresh one for each picture.
struct WatchedBed
{
  KelpBed Bed{ 0.0 };

  WatchedBed()
  {
    vtkNew<vtkSeaweedSource> grass;
    grass->SetPreset(vtkSeaweedSource::Eelgrass);
    this->Bed.Scatter->RemoveAllInputConnections(1);
    this->Bed.Scatter->AddPrototypeConnection(grass->GetOutputPort());
    for (int plant = 1; plant < 12; ++plant)
    {
      this->Bed.Points->InsertNextPoint(1.5 * plant, 0.3 * (plant % 7), 0.0);
    }
    vtkSeaweedDeformationFilter* move = this->Bed.Move;
    move->UseLevelsOn();
    move->SetBlendDistance(2.0);
    move->SetViewAngle(120.0);
    move->SetPixelError(20.0);
    move->SetStartTime(0.0);
  }

  /// A picture, that of a camera which looks along x or back.
  vtkSmartPointer<vtkMultiBlockDataSet> At(double time, bool isBack, int method)
  {
    vtkSeaweedDeformationFilter* move = this->Bed.Move;
    move->SetMethod(method);
    move->SetViewPoint(8.0, 0.5, 1.0);
    move->SetViewDirection(isBack ? -1.0 : 1.0, 0.0, 0.0);
    move->UpdateTimeStep(time);
    auto picture = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    picture->ShallowCopy(move->GetOutputDataObject(0));
    return picture;
  }
};

/// Plants that stay as they are are not written again: each picture is that of a filter without any before it, with its
/// ranges, whichever of the former ones are still held.
bool PlantsThatStayAreAsWritten(int method)
{
  WatchedBed bed;
  std::vector<vtkSmartPointer<vtkMultiBlockDataSet>> held;
  bool good = true;
  int shown = 0;
  for (int frame = 0; good && frame < 16; ++frame)
  {
    const double time = frame / 24.0;
    const bool isBack = frame % 8 > 4;
    held.push_back(bed.At(time, isBack, method));
    held.erase(held.begin(), held.end() - (frame % 5 < 3 ? 1 : 2)); // one or two are on the screen
    WatchedBed fresh;
    const auto expected = fresh.At(time, isBack, method);
    for (const char* name : { littoral::plant::Skeleton, littoral::plant::Skin, littoral::plant::Leaves })
    {
      vtkPolyData* own = littoral::PlantPartOf(held.back(), littoral::plant::High, name);
      vtkPolyData* other = littoral::PlantPartOf(expected, littoral::plant::High, name);
      for (const bool isNormals : { false, true })
      {
        auto* values =
          vtkFloatArray::SafeDownCast(isNormals ? own->GetPointData()->GetNormals() : own->GetPoints()->GetData());
        auto* wanted =
          vtkFloatArray::SafeDownCast(isNormals ? other->GetPointData()->GetNormals() : other->GetPoints()->GetData());
        if (!values || !wanted)
        {
          continue;
        }
        const std::string where = std::string(name) + ", frame " + std::to_string(frame);
        good &= Check(Values(values) == Values(wanted), where + ": values are those of another picture");
        good &= Check(HasTrueRanges(values), where + ": ranges are those of other values");
        ++shown;
      }
    }
  }
  return Check(shown >= 16 * 5, "there is less to be seen than there should be") && good;
}

}

int TestFrameArrays(int, char*[])
{
  bool good = FramesAreTheirOwn(Tree);
  good &= FramesAreTheirOwn(Kelp);
  good &= HeldFramesAreOverwritten();
  good &= PlantsThatWentAreWrittenAnew();
  for (const int method : { 0, 1 })
  {
    good &= PlantsThatStayAreAsWritten(method);
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
