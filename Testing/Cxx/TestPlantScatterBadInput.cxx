// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Bad input of the scatter filter: each is refused with one message that names it.
#include "Check.h"
#include "ErrorCounter.h"
#include "ScatteredForest.h"
#include "vtkQuadratPointSource.h"
#include "vtkReevesTreeSource.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"

#include <cstring>
#include <functional>
#include <limits>
#include <string>

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

bool Fails(const Forest& trees, const char* word, const std::function<void(Forest&)>& spoil)
{
  Forest forest;
  forest.TakeTrees(trees);
  spoil(forest);
  vtkNew<ErrorCounter> errors;
  errors->Watch(forest.Filter);
  // Twice: nothing bad is kept.
  bool good = errors->ExpectOneNaming(word) && errors->ExpectOneNaming(word);
  return Check(good && !forest.Part("Low"), word);
}

void SetSiteArray(Forest& forest, const char* name, double bad)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (vtkIdType site = 0; site < forest.Sites->GetNumberOfPoints(); ++site)
  {
    array->InsertNextValue(site == 7 ? bad : 1.0);
  }
  forest.Sites->GetPointData()->AddArray(array);
}

/// Replaces the second prototype by one without a block.
void Drop(Forest& forest, const char* name)
{
  forest.Shrub->Update();
  vtkNew<vtkMultiBlockDataSet> spoiled;
  auto* whole = vtkMultiBlockDataSet::SafeDownCast(forest.Shrub->GetOutputDataObject(0));
  for (unsigned int index = 0; index < whole->GetNumberOfBlocks(); ++index)
  {
    const char* own = whole->GetMetaData(index)->Get(vtkCompositeDataSet::NAME());
    if (std::strcmp(own, name) != 0)
    {
      const unsigned int next = spoiled->GetNumberOfBlocks();
      spoiled->SetBlock(next, whole->GetBlock(index));
      spoiled->GetMetaData(next)->Set(vtkCompositeDataSet::NAME(), own);
    }
  }
  forest.Filter->RemoveInputConnection(1, 1);
  forest.Filter->AddInputDataObject(1, spoiled);
}

bool BadInput()
{
  const Forest trees;
  const auto fails = [&](const char* word, const std::function<void(Forest&)>& spoil) {
    return Fails(trees, word, spoil);
  };
  bool good = true;
  good &= fails("no prototypes", [](Forest& f) { f.Filter->RemoveAllInputConnections(1); });
  good &= fails("Prototype 1 cannot be scattered: its level High", [](Forest& f) { Drop(f, "High"); });
  good &= fails("Prototype 1 cannot be scattered: its level Medium", [](Forest& f) { Drop(f, "Medium"); });
  good &= fails("Prototype 1 cannot be scattered: its level Low", [](Forest& f) { Drop(f, "Low"); });
  good &= fails("site 4 lies at", [](Forest& f) { f.Sites->GetPoints()->SetPoint(4, 0.0, NaN, 0.0); });
  good &= fails("Weight 1", [](Forest& f) { f.Filter->SetWeight(1, -1.0); });
  good &= fails("Weights", [](Forest& f) {
    f.Filter->SetWeight(0, 0.0);
    f.Filter->SetWeight(1, 0.0);
  });
  good &= fails("Species of site 7 is 2", [](Forest& f) { SetSiteArray(f, "Species", 2.0); });
  good &= fails("Species of site 7 is 0.5", [](Forest& f) { SetSiteArray(f, "Species", 0.5); });
  good &= fails("Scale of site 7", [](Forest& f) { SetSiteArray(f, "Scale", 0.0); });
  good &= fails("Azimuth of site 7", [](Forest& f) { SetSiteArray(f, "Azimuth", NaN); });
  good &= fails("of 60 sites, 2 lie outside", [](Forest& f) {
    f.AddTerrain();
    f.Sites->GetPoints()->SetPoint(1, 41.0, 0.0, 0.0);
    f.Sites->GetPoints()->SetPoint(2, 0.0, 91.0, 0.0);
  });
  good &= fails("no height", [](Forest& f) {
    f.AddTerrain();
    f.Terrain->GetPointData()->GetScalars()->FillComponent(0, NaN);
  });
  good &= fails("Terrain", [](Forest& f) {
    f.AddTerrain();
    f.Terrain->GetPointData()->Initialize();
  });
  good &= fails("ScaleVariation", [](Forest& f) { f.Filter->SetScaleVariation(0.6); });
  good &= fails("TintVariation", [](Forest& f) { f.Filter->SetTintVariation(NaN); });
  good &= fails("SlopeLimit", [](Forest& f) { f.Filter->SetSlopeLimit(-1.0); });
  good &= fails("HeightRange", [](Forest& f) { f.Filter->SetHeightRange(2.0, 1.0); });
  good &= fails("PlantsPerCell", [](Forest& f) { f.Filter->SetPlantsPerCell(0.0); });
  good &= fails("VisibleDistance", [](Forest& f) { f.Filter->SetVisibleDistance(-1.0); });
  good &= fails("NearDistance", [](Forest& f) { f.Filter->SetNearDistance(300.0); });
  good &= fails("ViewAngle", [](Forest& f) { f.Filter->SetViewAngle(0.0); });
  good &= fails("ParallelScale", [](Forest& f) {
    f.Filter->ParallelProjectionOn();
    f.Filter->SetParallelScale(0.0);
  });
  return good;
}

/// More plants in full than any memory holds: an error before any of it is asked for.
bool TooMuch()
{
  vtkNew<vtkQuadratPointSource> sites;
  sites->SetQuadrats(1000, 1000);
  Forest forest;
  vtkNew<vtkReevesTreeSource> oak;
  forest.Filter->SetInputConnection(0, sites->GetOutputPort());
  forest.Filter->SetInputConnection(1, oak->GetOutputPort());
  forest.Filter->UseLevelsOff();
  forest.Filter->UseCullingOff();
  vtkNew<ErrorCounter> errors;
  errors->Watch(forest.Filter);
  return Check(errors->ExpectOneNaming("are free") && errors->Last.find("1000000 plants") != std::string::npos,
    "a million trees in full");
}

}

int TestPlantScatterBadInput(int, char*[])
{
  return BadInput() && TooMuch() ? EXIT_SUCCESS : EXIT_FAILURE;
}
