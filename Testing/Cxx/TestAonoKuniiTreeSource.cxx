// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Twelve published trees at their three levels of detail: arrays, the crown's volume, sound polygons, same bytes,
// pieces, bad input, a picture.
#include "AonoKuniiTree.h"
#include "ErrorCounter.h"
#include "PlantScene.h"
#include "vtkAonoKuniiTreeSource.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolygon.h"
#include "vtkSMPTools.h"

#include <cstring>
#include <functional>
#include <limits>
#include <string>

namespace
{

using Source = vtkAonoKuniiTreeSource;

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

/// No polygon without area.
bool Sound(Source* source, const char* path)
{
  vtkPolyData* part = PartOf(source, path);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < part->GetNumberOfCells(); ++cell)
  {
    part->GetCellPoints(cell, corners);
    double normal[3];
    vtkPolygon::ComputeNormal(
      part->GetPoints(), static_cast<int>(corners->GetNumberOfIds()), corners->GetPointer(0), normal);
    if (!(std::abs(normal[0]) + std::abs(normal[1]) + std::abs(normal[2]) > 0.5))
    {
      return Check(false, "a polygon without area");
    }
  }
  return true;
}

/// The Medium crown lies within the volume around the leaves.
bool CrownWithin(Source* source, int preset)
{
  littoral::AonoKuniiParameters parameters = littoral::PresetParameters(static_cast<littoral::ForkPreset>(preset));
  const littoral::CrownVolume crown = littoral::GrowAonoKuniiTree(parameters).Crown;
  vtkPolyData* envelope = PartOf(source, "Medium/Crown");
  for (vtkIdType point = 0; point < envelope->GetNumberOfPoints(); ++point)
  {
    const double* x = envelope->GetPoint(point);
    const double part = (x[2] - crown.Foot.z) / crown.Height;
    const double reach = std::hypot(x[0] - crown.Foot.x, x[1] - crown.Foot.y) / crown.Radius;
    const double widest =
      crown.Shape == littoral::CrownShape::Cone ? 1.0 - part : std::sqrt(std::max(0.0, 4.0 * part * (1.0 - part)));
    if (part < -1e-6 || part > 1.0 + 1e-6 || reach > widest + 1e-5)
    {
      return Check(false, "the Medium crown is not within its volume");
    }
  }
  return true;
}

bool Levels()
{
  bool good = true;
  for (int preset = Source::MonopodialA; preset <= Source::TernaryD; ++preset)
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
    for (const char* path : { "High/Skin", "High/Leaves", "Medium/Trunk", "Medium/Crown", "Low" })
    {
      good = good && Sound(source, path);
    }
    good = good && CrownWithin(source, preset);
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
  return Fails("Preset", [](Source* s) { s->SetPreset(13); }) &
    Fails("Branching", [](Source* s) { s->SetBranching(3); }) &
    Fails("Iterations", [](Source* s) { s->SetIterations(0); }) &
    Fails("Iterations", [](Source* s) { s->SetIterations(40); }) &
    Fails("LengthRatio1", [=](Source* s) { s->SetLengthRatio1(nan); }) &
    Fails("Angle2", [](Source* s) { s->SetAngle2(180.0); }) &
    Fails("Tropism", [=](Source* s) { s->SetTropism(0.0, nan, 0.0); }) &
    Fails("TrunkLength", [](Source* s) { s->SetTrunkLength(0.0); }) &
    Fails("Variation", [](Source* s) { s->SetVariation(0.6); }) &
    Fails("NumberOfLeaves", [](Source* s) { s->SetNumberOfLeaves(-1); }) &
    Fails("LeafForm", [](Source* s) { s->SetLeafForm(5); }) &
    Fails("LeafColor", [](Source* s) { s->SetLeafColor(2.0, 0.0, 0.0); }) &
    Fails("TextureSize", [](Source* s) { s->SetTextureSize(0, 64); }) &
    Fails("CrownJitter", [](Source* s) { s->SetCrownJitter(-0.1); });
}

}

int TestAonoKuniiTreeSource(int argc, char* argv[])
{
  if (!Levels() || !Reproducible() || !Pieces() || !BadInput())
  {
    return EXIT_FAILURE;
  }
  PlantScene scene;
  double x = 0.0;
  for (const int preset : { Source::MonopodialA, Source::SympodialB, Source::TernaryA })
  {
    vtkNew<Source> source;
    source->SetPreset(preset);
    source->Update();
    auto* crown = vtkImageData::SafeDownCast(source->GetOutputDataObject(1));
    scene.Add(BlockAt(source->GetOutputDataObject(0), "High"), x);
    scene.Add(PartOf(source, "Medium/Trunk"), x + 15.0);
    scene.Add(PartOf(source, "Medium/Crown"), x + 15.0, crown, true);
    scene.Add(PartOf(source, "Low"), x + 30.0);
    x += 47.0;
  }
  const double eye[3] = { 62.0, -180.0, 9.0 };
  const double focus[3] = { 62.0, 0.0, 6.5 };
  return scene.Compare(argc, argv, eye, focus, 19.5);
}
