// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Four species at their three levels of detail: arrays, same bytes, pieces, bad input, a picture.
#include "ErrorCounter.h"
#include "PlantScene.h"
#include "vtkReevesTreeSource.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <cstring>
#include <functional>
#include <limits>
#include <string>

namespace
{

using Source = vtkReevesTreeSource;

bool Check(bool good, const char* what)
{
  if (!good)
  {
    std::cerr << what << std::endl;
  }
  return good;
}

vtkPolyData* PartOf(Source* source, const char* path)
{
  return vtkPolyData::SafeDownCast(BlockAt(source->GetOutputDataObject(0), path));
}

bool HasArrays(Source* source, const char* path, std::initializer_list<const char*> names)
{
  vtkPolyData* part = PartOf(source, path);
  bool good = Check(part && part->GetNumberOfCells() > 0, path);
  for (const char* name : names)
  {
    vtkDataArray* array = good ? part->GetPointData()->GetArray(name) : nullptr;
    good = good && Check(array && array->GetNumberOfTuples() == part->GetNumberOfPoints(), name);
  }
  return good;
}

bool Joints(Source* source, const char* path)
{
  const vtkIdType nodes = PartOf(source, "High/Skeleton")->GetNumberOfPoints();
  vtkPointData* arrays = PartOf(source, path)->GetPointData();
  vtkDataArray* ids = arrays->GetArray("JointIds");
  vtkDataArray* weights = arrays->GetArray("JointWeights");
  for (vtkIdType vertex = 0; vertex < ids->GetNumberOfTuples(); ++vertex)
  {
    double sum = 0.0;
    for (int joint = 0; joint < 4; ++joint)
    {
      const double id = ids->GetComponent(vertex, joint);
      if (id < 0 || id >= nodes)
      {
        return Check(false, "a joint that is no node");
      }
      sum += weights->GetComponent(vertex, joint);
    }
    if (std::abs(sum - 1.0) > 1e-6)
    {
      return Check(false, "joint weights do not sum to 1");
    }
  }
  return true;
}

bool Levels()
{
  bool good = true;
  for (int preset = Source::Pine; preset <= Source::Shrub; ++preset)
  {
    vtkNew<Source> source;
    source->SetPreset(preset);
    source->Update();
    good &= HasArrays(source, "High/Skeleton", { "ParentId", "Radius", "RGB" });
    good &= HasArrays(source, "High/Skin", { "Normals", "RGB", "JointIds", "JointWeights", "TCoords" });
    good &= HasArrays(source, "High/Leaves", { "Normals", "RGB", "JointIds", "JointWeights", "TCoords" });
    good &= HasArrays(source, "Medium/Trunk", { "Normals", "RGB" });
    good &= HasArrays(source, "Medium/Crown", { "Normals", "RGB", "TCoords" });
    good &= HasArrays(source, "Low", { "Normals", "RGB" });
    good = good && Joints(source, "High/Skin") && Joints(source, "High/Leaves");
    good &= Check(PartOf(source, "Low")->GetNumberOfPolys() == 4, "the lowest level has not four polygons");
    good &= Check(PartOf(source, "Low")->GetPointData()->GetTCoords() == nullptr, "the lowest level has a texture");
    vtkCellData* branches = PartOf(source, "High/Skeleton")->GetCellData();
    good &= Check(branches->GetArray("BranchId") && branches->GetArray("Order"), "branches without arrays");
  }
  return good;
}

bool SameBytes(vtkDataArray* a, vtkDataArray* b)
{
  return a->GetNumberOfValues() == b->GetNumberOfValues() &&
    std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
      static_cast<std::size_t>(a->GetNumberOfValues()) * a->GetDataTypeSize()) == 0;
}

bool Reproducible()
{
  vtkNew<Source> one;
  vtkNew<Source> two;
  vtkSMPTools::Initialize(1);
  one->Update();
  vtkSMPTools::Initialize(2);
  two->Update();
  bool good = true;
  for (const char* path : { "High/Skin", "High/Leaves", "Medium/Crown", "Low" })
  {
    good &= Check(SameBytes(PartOf(one, path)->GetPoints()->GetData(), PartOf(two, path)->GetPoints()->GetData()),
      "points depend on the number of threads");
  }
  vtkDataArray* first = vtkImageData::SafeDownCast(one->GetOutputDataObject(1))->GetPointData()->GetScalars();
  vtkDataArray* second = vtkImageData::SafeDownCast(two->GetOutputDataObject(1))->GetPointData()->GetScalars();
  good &= Check(SameBytes(first, second), "the picture of the crown depends on the number of threads");
  two->SetSeed(7);
  two->Update();
  good &= Check(
    !SameBytes(PartOf(one, "High/Leaves")->GetPoints()->GetData(), PartOf(two, "High/Leaves")->GetPoints()->GetData()),
    "another seed gives the same tree");
  return good;
}

bool Pieces()
{
  vtkNew<Source> source;
  source->UpdatePiece(1, 2, 0);
  const bool later = PartOf(source, "High/Skin") == nullptr;
  source->UpdatePiece(0, 2, 0);
  return Check(later && PartOf(source, "High/Skin"), "the tree is not in the first piece alone");
}

bool Fails(const char* word, const std::function<void(Source*)>& spoil)
{
  vtkNew<Source> source;
  source->SetPreset(Source::Custom);
  spoil(source);
  vtkNew<ErrorCounter> errors;
  errors->Watch(source);
  return Check(errors->ExpectOneNaming(word) && !PartOf(source, "High/Skin"), word);
}

bool BadInput()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  return Fails("Preset", [](Source* s) { s->SetPreset(9); }) & Fails("Height", [](Source* s) { s->SetHeight(0.0); }) &
    Fails("Height", [=](Source* s) { s->SetHeight(nan); }) &
    Fails("CrownBase", [](Source* s) { s->SetCrownBase(100.0); }) &
    Fails("CrownShape", [](Source* s) { s->SetCrownShape(2); }) &
    Fails("NumberOfLeaves", [](Source* s) { s->SetNumberOfLeaves(-1); }) &
    Fails("LeafForm", [](Source* s) { s->SetLeafForm(5); }) &
    Fails("LeafColor", [](Source* s) { s->SetLeafColor(2.0, 0.0, 0.0); }) &
    Fails("TextureSize", [](Source* s) { s->SetTextureSize(0, 64); }) &
    Fails("CrownJitter", [](Source* s) { s->SetCrownJitter(-0.1); });
}

}

int TestReevesTreeSource(int argc, char* argv[])
{
  if (!Levels() || !Reproducible() || !Pieces() || !BadInput())
  {
    return EXIT_FAILURE;
  }
  PlantScene scene;
  double x = 0.0;
  for (int preset = Source::Pine; preset <= Source::Shrub; ++preset)
  {
    vtkNew<Source> source;
    source->SetPreset(preset);
    source->Update();
    auto* crown = vtkImageData::SafeDownCast(source->GetOutputDataObject(1));
    const double step = preset == Source::Shrub ? 3.2 : preset == Source::Oak ? 11.5 : 7.0;
    scene.Add(BlockAt(source->GetOutputDataObject(0), "High"), x);
    scene.Add(PartOf(source, "Medium/Trunk"), x + step);
    scene.Add(PartOf(source, "Medium/Crown"), x + step, crown, true);
    scene.Add(PartOf(source, "Low"), x + 1.9 * step);
    x += preset == Source::Pine ? 23.0 : preset == Source::Oak ? 30.0 : 18.0;
  }
  const double eye[3] = { 36.5, -120.0, 10.0 };
  const double focus[3] = { 36.5, 0.0, 7.0 };
  return scene.Compare(argc, argv, eye, focus, 16.5);
}
