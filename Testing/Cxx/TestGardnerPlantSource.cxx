// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Four kinds of plants at their three levels of detail: arrays, pictures, same bytes, pieces, bad input, a picture.
#include "ErrorCounter.h"
#include "PlantScene.h"
#include "vtkGardnerPlantSource.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <set>
#include <string>

namespace
{

using Source = vtkGardnerPlantSource;

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

bool EachPointIsUsed(vtkPolyData* part)
{
  std::set<vtkIdType> used;
  for (vtkIdType cell = 0; cell < part->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    part->GetCellPoints(cell, size, corners);
    used.insert(corners, corners + size);
  }
  return static_cast<vtkIdType>(used.size()) == part->GetNumberOfPoints();
}

/// The Medium crown reaches no farther than the ellipsoid that its own height and width span.
bool CrownIsInside(Source* source)
{
  vtkPolyData* crown = PartOf(source, "Medium/Crown");
  double bounds[6];
  crown->GetBounds(bounds);
  const double middle = 0.5 * (bounds[4] + bounds[5]);
  const double half = 0.5 * (bounds[5] - bounds[4]);
  const double radius = std::max({ -bounds[0], bounds[1], -bounds[2], bounds[3] });
  for (vtkIdType point = 0; point < crown->GetNumberOfPoints(); ++point)
  {
    double p[3];
    crown->GetPoint(point, p);
    if (std::hypot(std::hypot(p[0], p[1]) / radius, (p[2] - middle) / half) > 1.0 + 1e-5)
    {
      return Check(false, "the medium crown reaches out of its volume");
    }
  }
  double leaves[6];
  PartOf(source, "High/Leaves")->GetBounds(leaves);
  const double tolerance = 0.15 * (leaves[5] - leaves[4]);
  const bool about = std::abs(bounds[4] - leaves[4]) < tolerance && std::abs(bounds[5] - leaves[5]) < tolerance;
  if (!about)
  {
    std::cerr << bounds[4] << " to " << bounds[5] << " for " << leaves[4] << " to " << leaves[5] << std::endl;
  }
  return Check(about, "the medium crown is not where the leaves are");
}

/// A picture has its whole extent and is the field data of its block.
bool PictureFits(Source* source, int port, const char* path)
{
  auto* picture = vtkImageData::SafeDownCast(source->GetOutputDataObject(port));
  vtkFieldData* fields = PartOf(source, path)->GetFieldData();
  vtkDataArray* size = fields->GetArray("TextureSize");
  vtkDataArray* texels = fields->GetArray("Texture");
  int announced[6];
  source->GetOutputInformation(port)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), announced);
  const int* extent = picture->GetExtent();
  return std::equal(extent, extent + 6, announced) && size && texels &&
    size->GetTuple1(0) == picture->GetDimensions()[0] && size->GetTuple1(1) == picture->GetDimensions()[1] &&
    texels->GetNumberOfComponents() == 4 && texels->GetNumberOfTuples() == picture->GetNumberOfPoints();
}

bool Levels()
{
  bool good = true;
  for (int preset = Source::Tree; preset <= Source::Bush; ++preset)
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
    good &= Check(EachPointIsUsed(PartOf(source, "High/Leaves")), "vertices without triangles");
    good = good && CrownIsInside(source);
    good &= Check(PictureFits(source, 1, "Medium/Crown") && PictureFits(source, 2, "High/Leaves"),
      "a picture and the field data of its block differ");
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
    "another seed gives the same plant");
  return good;
}

bool Pieces()
{
  vtkNew<Source> source;
  source->UpdatePiece(1, 2, 0);
  const bool later = PartOf(source, "High/Skin") == nullptr;
  source->UpdatePiece(0, 2, 0);
  return Check(later && PartOf(source, "High/Skin"), "the plant is not in the first piece alone");
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
    Fails("NumberOfQuadrics", [](Source* s) { s->SetNumberOfQuadrics(0); }) &
    Fails("Shells", [](Source* s) { s->SetShells(9); }) & Fails("Terms", [](Source* s) { s->SetTerms(3); }) &
    Fails("Frequency", [](Source* s) { s->SetFrequency(5); }) & Fails("Offset", [=](Source* s) { s->SetOffset(nan); }) &
    Fails("CentreThreshold", [](Source* s) { s->SetCentreThreshold(0.9); }) &
    Fails("SilhouetteThreshold", [](Source* s) { s->SetSilhouetteThreshold(1.1); }) &
    Fails("Variation", [](Source* s) { s->SetVariation(-0.1); }) &
    Fails("LeafColor", [](Source* s) { s->SetLeafColor(2.0, 0.0, 0.0); }) &
    Fails("TextureSize", [](Source* s) { s->SetTextureSize(0, 64); }) &
    Fails("CrownJitter", [](Source* s) { s->SetCrownJitter(-0.1); });
}

}

int TestGardnerPlantSource(int argc, char* argv[])
{
  if (!Levels() || !Reproducible() || !Pieces() || !BadInput())
  {
    return EXIT_FAILURE;
  }
  PlantScene scene;
  scene.Window->SetSize(300, 200);
  double x = 0.0;
  for (const int preset : { Source::Tree, Source::Cypress, Source::Bush })
  {
    vtkNew<Source> source;
    source->SetPreset(preset);
    source->Update();
    const double half = preset == Source::Tree ? 5.0 : 1.8;
    x += half;
    scene.Add(PartOf(source, "High/Skin"), x);
    scene.Add(
      PartOf(source, "High/Leaves"), x, vtkImageData::SafeDownCast(source->GetOutputDataObject(2)), false, true);
    x += half;
  }
  const double eye[3] = { 0.5 * x, -60.0, 6.0 };
  const double focus[3] = { 0.5 * x, 0.0, 6.0 };
  return scene.Compare(argc, argv, eye, focus, 12.0);
}
