// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Plants of two species that do not carry their joints take those of their prototypes, and move alike.
#include "Check.h"
#include "ErrorCounter.h"
#include "PlantScene.h"

#include "vtkBeamTreeDeformationFilter.h"
#include "vtkPlantScatterFilter.h"
#include "vtkReevesTreeSource.h"
#include "vtkWindFieldSource.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationInformationVectorKey.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstdlib>
#include <initializer_list>
#include <string>
#include <vector>

namespace
{

/// All values of the point arrays of the moved blocks, their points and polygons.
std::vector<double> ValuesOf(vtkDataObject* plants)
{
  std::vector<double> values;
  const auto add = [&](vtkDataArray* array) {
    for (vtkIdType k = 0; k < array->GetNumberOfTuples(); ++k)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        values.push_back(array->GetComponent(k, c));
      }
    }
  };
  for (const char* path : { "High/Skeleton", "High/Skin", "High/Leaves", "Medium/Trunk", "Medium/Crown" })
  {
    auto* block = vtkPolyData::SafeDownCast(BlockAt(plants, path));
    add(block->GetPoints()->GetData());
    add(block->GetPolys()->GetOffsetsArray());
    add(block->GetPolys()->GetConnectivityArray());
    for (const char* name : { "Normals", "RGB", "TCoords", "PlantId", "JointIds", "JointWeights" })
    {
      if (vtkDataArray* array = block->GetPointData()->GetArray(name))
      {
        add(array);
      }
    }
  }
  return values;
}

vtkPolyData* LeavesOf(vtkPlantScatterFilter* wood)
{
  return vtkPolyData::SafeDownCast(BlockAt(wood->GetOutputDataObject(0), "High/Leaves"));
}

/// The array that holds the pictures of the crowns.
vtkDataArray* PicturesOf(vtkAlgorithm* sway)
{
  return vtkImageData::SafeDownCast(sway->GetOutputDataObject(1))->GetPointData()->GetScalars();
}

bool HasJoints(vtkPlantScatterFilter* wood)
{
  vtkPointData* leaves = LeavesOf(wood)->GetPointData();
  return leaves->HasArray("JointIds") || leaves->HasArray("JointWeights");
}

}

int TestScatteredJoints(int, char*[])
{
  vtkNew<vtkReevesTreeSource> tree;
  tree->SetMediumCrownToEnvelope();
  vtkNew<vtkReevesTreeSource> shrub;
  shrub->SetPreset(vtkReevesTreeSource::Shrub);
  vtkNew<vtkPoints> feet;
  for (int i = 0; i < 8; ++i)
  {
    feet->InsertNextPoint(7.0 * (i % 4), 7.0 * (i / 4) - 14.0, 10.0);
  }
  vtkNew<vtkPolyData> sites;
  sites->SetPoints(feet);
  vtkNew<vtkPlantScatterFilter> wood;
  wood->SetInputData(sites);
  for (vtkReevesTreeSource* prototype : { tree.Get(), shrub.Get() })
  {
    prototype->SetTextureSize(32, 16); // small pictures cost less
    wood->AddPrototypeConnection(prototype->GetOutputPort());
  }
  wood->UseCullingOff();
  wood->SetViewPoint(0.0, -15.0, 12.0);
  wood->SetNearDistance(16.0);
  wood->SetFarDistance(500.0);
  vtkNew<vtkWindFieldSource> wind;
  wind->SetDimensions(120, 24, 10);
  const auto sway = [&](std::initializer_list<vtkAlgorithm*> prototypes) {
    vtkNew<vtkBeamTreeDeformationFilter> made;
    made->SetTextureSize(32, 16);
    made->SetNumberOfTextures(2);
    made->GenerateJointsOn();
    made->SetInputConnection(0, wood->GetOutputPort());
    made->SetWindConnection(wind->GetOutputPort());
    for (vtkAlgorithm* prototype : prototypes)
    {
      made->AddPrototypeConnection(prototype->GetOutputPort());
    }
    return made;
  };
  const auto moved = [&] {
    const auto filter = sway({ tree, shrub });
    filter->UpdateTimeStep(3.3);
    return ValuesOf(filter->GetOutputDataObject(0));
  };
  bool good = true;
  const std::vector<double> with = moved();
  wood->PassJointsOff();
  const std::vector<double> without = moved();
  good &= Check(with.size() > 100000 && with == without, "joints of prototypes are not those that plants carry");
  good &= Check(LeavesOf(wood)->GetNumberOfPoints() > 0 && !HasJoints(wood), "plants have joints");
  wood->PassSurfacesOff();
  const std::vector<double> made = moved();
  good &= Check(made == without, "surfaces that sway are not those that plants are passed with");
  good &= Check(LeavesOf(wood)->GetNumberOfPoints() == 0, "plants have surfaces");
  const auto keeper = sway({ tree, shrub });
  const auto follows = [&](const char* change, bool isOtherKind) {
    const vtkSmartPointer<vtkDataArray> former = PicturesOf(keeper);
    wood->Update();
    keeper->UpdateTimeStep(3.3);
    const bool isOther = PicturesOf(keeper) != former;
    return Check(ValuesOf(keeper->GetOutputDataObject(0)) == moved(), std::string("not moved as anew: ") + change) &&
      Check(isOther == isOtherKind, std::string("pictures of crowns are made at need: ") + change);
  };
  keeper->UpdateTimeStep(3.3);
  auto* leaves = vtkPolyData::SafeDownCast(BlockAt(keeper->GetOutputDataObject(0), "High/Leaves"));
  vtkDataArray* colors = leaves->GetPointData()->GetArray("RGB");
  good &= Check(colors->GetNumberOfTuples() > 4096 && colors->GetInformation()->Has(vtkDataArray::PER_COMPONENT()),
    "colors of surfaces that are made keep no ranges");
  wood->SetViewPoint(18.0, -15.0, 12.0);
  good &= follows("other plants", false);
  wind->SetSeed(5);
  good &= follows("another wind", true);
  shrub->SetSeed(7);
  good &= follows("another prototype", true);
  vtkNew<ErrorCounter> bareErrors;
  const auto bare = sway({});
  bareErrors->Watch(bare);
  good &= bareErrors->ExpectOneNaming("switch on PassSurfaces");
  wood->PassSurfacesOn();
  vtkNew<ErrorCounter> errors;
  const auto others = sway({ shrub, tree });
  errors->Watch(others);
  good &= errors->ExpectOneNaming("not like their prototypes");
  wood->PassJointsOn();
  wood->Update();
  good &= Check(LeavesOf(wood)->GetPointData()->HasArray("JointIds") != 0, "joints do not come back");
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
