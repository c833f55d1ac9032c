// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PlantChecks_h
#define PlantChecks_h

// What holds for every plant source.

#include "Check.h"
#include "Data/PlantBlocks.h"
#include "ErrorCounter.h"
#include "PlantScene.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolygon.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <initializer_list>
#include <iostream>

/// A block of the level High of plants.
inline vtkPolyData* Part(vtkDataObject* plants, const char* name)
{
  auto* high = littoral::FindBlock(vtkMultiBlockDataSet::SafeDownCast(plants), "High");
  return vtkPolyData::SafeDownCast(littoral::FindBlock(vtkMultiBlockDataSet::SafeDownCast(high), name));
}

/// The block of a source's first output.
inline vtkPolyData* PartOf(vtkAlgorithm* source, const char* path)
{
  return vtkPolyData::SafeDownCast(BlockAt(source->GetOutputDataObject(0), path));
}

inline bool HasArrays(vtkAlgorithm* source, const char* path, std::initializer_list<const char*> names)
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

/// Each vertex belongs to nodes of the skeleton, with weights that sum to 1.
inline bool Joints(vtkAlgorithm* source, const char* path)
{
  const auto nodes = static_cast<double>(PartOf(source, "High/Skeleton")->GetNumberOfPoints());
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
inline bool Sound(vtkAlgorithm* source, const char* path)
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

/// A picture has its whole extent and is the field data of its block.
inline bool PictureFits(vtkAlgorithm* source, int port, const char* path)
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

/// All levels with their arrays, sound polygons, and four polygons as the lowest.
inline bool HasLevels(vtkAlgorithm* source)
{
  bool good = HasArrays(source, "High/Skeleton", { "ParentId", "Radius", "RGB" });
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
  return good & Check(PartOf(source, "Low")->GetNumberOfPolys() == 4, "the lowest level has not four polygons");
}

/// A block that carries a texture of as many texels as it says, and its mean.
inline bool CarriesTexture(vtkAlgorithm* source, const char* path, bool hasNormals)
{
  vtkFieldData* fields = PartOf(source, path)->GetFieldData();
  vtkDataArray* texels = fields->GetArray("Texture");
  vtkDataArray* size = fields->GetArray("TextureSize");
  vtkDataArray* mean = fields->GetArray("TextureMean");
  vtkDataArray* normals = fields->GetArray("NormalTexture");
  return Check(texels && size && mean && mean->GetNumberOfValues() == 3 &&
      texels->GetNumberOfTuples() == static_cast<vtkIdType>(size->GetTuple1(0) * size->GetTuple1(1)) &&
      (normals != nullptr) == hasNormals && (!normals || normals->GetNumberOfTuples() == texels->GetNumberOfTuples()),
    path);
}

/// A tree that any source of trees makes: its levels, its textures, and the arrays of its branches.
inline bool IsTree(vtkAlgorithm* source)
{
  vtkCellData* branches = PartOf(source, "High/Skeleton")->GetCellData();
  return HasLevels(source) && CarriesTexture(source, "Medium/Crown", false) && CarriesTexture(source, "Low", true) &&
    Check(branches->GetArray("BranchId") && branches->GetArray("Order"), "branches without arrays");
}

inline bool SameBytes(vtkDataArray* a, vtkDataArray* b)
{
  return a->GetNumberOfValues() == b->GetNumberOfValues() &&
    std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
      static_cast<std::size_t>(a->GetNumberOfValues()) * a->GetDataTypeSize()) == 0;
}

/// The same bytes on one thread and two, others with another seed; of the default or what makes it smaller.
template <typename Source>
bool Reproducible(const std::function<void(Source*)>& shrink = [](Source*) {})
{
  vtkNew<Source> one;
  vtkNew<Source> two;
  for (Source* source : { one.Get(), two.Get() })
  {
    source->SetTextureSize(32, 16); // small pictures cost less
    shrink(source);
  }
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
  vtkDataArray* seen[] = { PartOf(one, "Low")->GetFieldData()->GetArray("Texture"),
    PartOf(two, "Low")->GetFieldData()->GetArray("Texture") };
  good &= Check(!seen[0] || SameBytes(seen[0], seen[1]), "pictures of the plant depend on the number of threads");
  two->SetSeed(7);
  two->Update();
  good &= Check(
    !SameBytes(PartOf(one, "High/Leaves")->GetPoints()->GetData(), PartOf(two, "High/Leaves")->GetPoints()->GetData()),
    "another seed gives the same plant");
  return good;
}

/// The first piece has the plant, a later one the same blocks without it.
template <typename Source>
bool Pieces(const std::function<void(Source*)>& shrink = [](Source*) {})
{
  vtkNew<Source> source;
  source->SetTextureSize(32, 16);
  shrink(source);
  bool good = true;
  for (const int piece : { 1, 0 })
  {
    source->UpdatePiece(piece, 2, 0);
    for (const char* path : { "High/Skeleton", "High/Skin", "High/Leaves", "Medium/Trunk", "Medium/Crown", "Low" })
    {
      vtkPolyData* part = PartOf(source, path);
      const std::string what = std::string(path) + " of piece " + std::to_string(piece);
      good &= Check(part != nullptr, what + " is missing");
      good &= Check(piece == 0 || (part && part->GetNumberOfPoints() == 0), what + " is not empty");
    }
    good &= Check(piece == 1 || PartOf(source, "High/Skin")->GetNumberOfPoints() > 0, "the first piece is empty");
  }
  return good;
}

/// A custom plant that was spoilt gives one message that has a word, and no data.
template <typename Source>
bool Fails(const char* word, const std::function<void(Source*)>& spoil)
{
  vtkNew<Source> source;
  source->SetPreset(Source::Custom);
  spoil(source);
  vtkNew<ErrorCounter> errors;
  errors->Watch(source);
  return Check(errors->ExpectOneNaming(word) && !PartOf(source, "High/Skin"), word);
}

/// Properties of leaves and of the levels that show them, which trees share.
template <typename Source>
bool RefusesBadLeaves()
{
  bool good = true;
  good &= Fails<Source>("NumberOfLeaves", [](Source* s) { s->SetNumberOfLeaves(-1); });
  good &= Fails<Source>("LeafForm", [](Source* s) { s->SetLeafForm(5); });
  good &= Fails<Source>("LeafColor", [](Source* s) { s->SetLeafColor(2.0, 0.0, 0.0); });
  good &= Fails<Source>("TextureSize", [](Source* s) { s->SetTextureSize(0, 64); });
  good &= Fails<Source>("MediumCrown", [](Source* s) { s->SetMediumCrown(2); });
  good &= Fails<Source>("CrownJitter", [](Source* s) { s->SetCrownJitter(-0.1); });
  return good;
}

#endif
