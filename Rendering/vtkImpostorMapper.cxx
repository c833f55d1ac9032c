// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImpostorMapper.h"

#include "ImpostorAtlas.h"
#include "ImpostorQuads.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkImpostorMapper);

namespace
{

vtkDataArray* ArrayWith(vtkPointData* arrays, const char* name, int components)
{
  vtkDataArray* array = arrays->GetArray(name);
  return array && array->GetNumberOfComponents() == components ? array : nullptr;
}

/// Arrays of instances, null where there are none.
struct InstanceArrays
{
  vtkDataArray* Rotation;
  vtkDataArray* Scale;
  vtkDataArray* Tint;
  vtkDataArray* Fades;

  explicit InstanceArrays(vtkPointData* arrays)
    : Rotation(ArrayWith(arrays, "Rotation", 4))
    , Scale(ArrayWith(arrays, "Scale", 1))
    , Tint(ArrayWith(arrays, "Tint", 3))
    , Fades(ArrayWith(arrays, "Fades", 1))
  {
    this->Scale = this->Scale ? this->Scale : ArrayWith(arrays, "Scale", 3);
  }
};

/// Adds an instance at a place, by its row of the arrays, of a plant within a sphere.
void Add(const InstanceArrays& arrays, vtkIdType row, const glm::dvec3& place,
  const littoral::ImpostorAtlas::Sphere& around, littoral::ImpostorInstances& instances)
{
  std::array<double, 4> rotation{ 1.0, 0.0, 0.0, 0.0 };
  std::array<double, 3> tint{ 1.0, 1.0, 1.0 };
  if (arrays.Rotation)
  {
    arrays.Rotation->GetTuple(row, rotation.data());
  }
  if (arrays.Tint)
  {
    arrays.Tint->GetTuple(row, tint.data());
  }
  const double wide = arrays.Scale ? arrays.Scale->GetComponent(row, 0) : 1.0;
  const double scale = arrays.Scale ? arrays.Scale->GetComponent(row, arrays.Scale->GetNumberOfComponents() - 1) : 1.0;
  if (!(scale > 0.0 && wide > 0.0))
  {
    return;
  }
  const double girth = wide / scale;
  const bool isFading = arrays.Fades && arrays.Fades->GetTuple1(row) != 0.0;
  const glm::dvec3 off = place - instances.Anchor;
  for (const double number : { off.x, off.y, off.z, scale, rotation[1], rotation[2], rotation[3], rotation[0], tint[0],
         tint[1], tint[2], isFading ? -girth : girth })
  {
    instances.Values.push_back(static_cast<float>(number));
  }
  const glm::dvec3 own = scale * around.Center * glm::dvec3(girth, girth, 1.0);
  glm::dvec3 middle;
  vtkMath::RotateVectorByNormalizedQuaternion(&own.x, rotation.data(), &middle.x);
  const double reach = around.Radius * std::max(scale, wide);
  for (const double side : { -reach, reach })
  {
    glm::dvec3 end = place + middle + side;
    instances.Bounds.AddPoint(&end.x);
  }
}

/// Calls a function with each point of actors with a vtkPolyDataMapper.
template <typename Function>
void ForEachPoint(const std::vector<vtkActor*>& parts, const Function& call)
{
  for (vtkActor* part : parts)
  {
    auto* mapper = vtkPolyDataMapper::SafeDownCast(part->GetMapper());
    vtkPolyData* data = mapper ? mapper->GetInput() : nullptr;
    for (vtkIdType point = 0; data && point < data->GetNumberOfPoints(); ++point)
    {
      double at[4] = { 0.0, 0.0, 0.0, 1.0 };
      data->GetPoint(point, at);
      part->GetMatrix()->MultiplyPoint(at, at);
      call(glm::dvec3(at[0], at[1], at[2]));
    }
  }
}

/// A sphere around actors.
littoral::ImpostorAtlas::Sphere SphereAround(const std::vector<vtkActor*>& parts)
{
  vtkBoundingBox box;
  ForEachPoint(parts, [&](glm::dvec3 point) { box.AddPoint(&point.x); });
  littoral::ImpostorAtlas::Sphere sphere;
  if (box.IsValid())
  {
    box.GetCenter(&sphere.Center.x);
  }
  ForEachPoint(parts, [&](const glm::dvec3& point) {
    sphere.Radius = std::max(sphere.Radius, 1.01 * glm::distance(point, sphere.Center));
  });
  return sphere;
}

}

/// The plant, its pictures and its instances.
struct vtkImpostorMapper::Internals
{
  std::vector<vtkSmartPointer<vtkActor>> Parts;
  littoral::ImpostorAtlas Atlas;
  littoral::ImpostorAtlas::Sphere Around;
  vtkNew<littoral::ImpostorQuads> Quads;
  vtkMTimeType AtlasTime = 0;     ///< of what the pictures show
  vtkMTimeType InstancesTime = 0; ///< of what the instances are from
  std::pair<int, int> Drawn;      ///< frames and their size

  std::vector<vtkActor*> GetParts() const { return { this->Parts.begin(), this->Parts.end() }; }
  vtkMTimeType GetPartsTime() const;
};

//----------------------------------------------------------------------------
vtkMTimeType vtkImpostorMapper::Internals::GetPartsTime() const
{
  vtkMTimeType time = 0;
  for (vtkActor* part : this->Parts)
  {
    time = std::max(time, part->GetRedrawMTime());
  }
  return time;
}

//----------------------------------------------------------------------------
vtkImpostorMapper::vtkImpostorMapper()
  : Own(new Internals)
  , Frames(13)
  , FrameSize(64)
  , FadeRange{ 0.0, 0.0 }
{
}

//----------------------------------------------------------------------------
vtkImpostorMapper::~vtkImpostorMapper() = default;

//----------------------------------------------------------------------------
void vtkImpostorMapper::AddPart(vtkActor* part)
{
  this->Own->Parts.emplace_back(part);
  this->Modified();
}

//----------------------------------------------------------------------------
void vtkImpostorMapper::RemoveAllParts()
{
  this->Own->Parts.clear();
  this->Modified();
}

//----------------------------------------------------------------------------
int vtkImpostorMapper::GetNumberOfParts()
{
  return static_cast<int>(this->Own->Parts.size());
}

//----------------------------------------------------------------------------
vtkActor* vtkImpostorMapper::GetPart(int part)
{
  return part >= 0 && part < this->GetNumberOfParts() ? this->Own->Parts[part].Get() : nullptr;
}

//----------------------------------------------------------------------------
vtkTypeInt64 vtkImpostorMapper::GetAtlasBytes()
{
  return littoral::ImpostorAtlas::BytesOf(this->Frames, this->FrameSize);
}

//----------------------------------------------------------------------------
void vtkImpostorMapper::SetFrames(int frames)
{
  const int odd = std::clamp(frames, 3, 33) | 1;
  if (this->Frames != odd)
  {
    this->Frames = odd;
    this->Modified();
  }
}

//----------------------------------------------------------------------------
void vtkImpostorMapper::SetFrameSize(int texels)
{
  int power = 256;
  while (power > std::max(texels, 16))
  {
    power /= 2;
  }
  if (this->FrameSize != power)
  {
    this->FrameSize = power;
    this->Modified();
  }
}

//----------------------------------------------------------------------------
vtkMTimeType vtkImpostorMapper::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Own->GetPartsTime());
}

//----------------------------------------------------------------------------
void vtkImpostorMapper::UpdateInstances()
{
  Internals& own = *this->Own;
  vtkPolyData* points = this->GetInput();
  const vtkMTimeType time = std::max(this->GetMTime(), points ? points->GetMTime() : 0);
  if (own.InstancesTime == time)
  {
    return;
  }
  own.InstancesTime = time;
  own.Around = SphereAround(own.GetParts());
  littoral::ImpostorInstances instances;
  const vtkIdType count = points && own.Around.Radius > 0.0 ? points->GetNumberOfPoints() : 0;
  if (count > 0)
  {
    points->GetPoint(0, &instances.Anchor.x);
    const InstanceArrays arrays(points->GetPointData());
    for (vtkIdType row = 0; row < count; ++row)
    {
      glm::dvec3 place;
      points->GetPoint(row, &place.x);
      Add(arrays, row, place, own.Around, instances);
    }
  }
  own.Quads->SetInstances(std::move(instances));
}

//----------------------------------------------------------------------------
void vtkImpostorMapper::UpdateAtlas(vtkRenderer* renderer)
{
  Internals& own = *this->Own;
  const std::pair<int, int> wished(this->Frames, this->FrameSize);
  if (own.AtlasTime == own.GetPartsTime() && own.Drawn == wished && own.Atlas.GetColors())
  {
    return;
  }
  own.Atlas.Draw(renderer, own.GetParts(), own.Around, this->Frames, this->FrameSize);
  ++this->TimesTaken;
  own.AtlasTime = own.GetPartsTime();
  own.Drawn = wished;
  own.Quads->SetAtlas(&own.Atlas, own.Around, this->Frames, this->FrameSize);
}

//----------------------------------------------------------------------------
void vtkImpostorMapper::ComputeBounds()
{
  this->UpdateInstances();
  vtkMath::UninitializeBounds(this->Bounds);
  if (this->Own->Quads->GetInstances().Bounds.IsValid())
  {
    this->Own->Quads->GetInstances().Bounds.GetBounds(this->Bounds);
  }
}

//----------------------------------------------------------------------------
void vtkImpostorMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  if (!this->Static)
  {
    this->GetInputAlgorithm()->Update();
  }
  this->UpdateInstances();
  if (!this->Own->Quads->GetInstances().Values.empty())
  {
    this->UpdateAtlas(renderer);
    this->Own->Quads->SetFade({ this->FadeRange[0], this->FadeRange[1] });
    this->Own->Quads->RenderPiece(renderer, actor);
  }
}

//----------------------------------------------------------------------------
void vtkImpostorMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Own->Atlas.ReleaseGraphicsResources(window);
  this->Own->Quads->ReleaseGraphicsResources(window);
  for (vtkActor* part : this->Own->Parts)
  {
    part->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

//----------------------------------------------------------------------------
void vtkImpostorMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Parts: " << this->Own->Parts.size() << "\n";
  os << indent << "Frames: " << this->Frames << "\n";
  os << indent << "FrameSize: " << this->FrameSize << "\n";
  os << indent << "TimesTaken: " << this->TimesTaken << "\n";
  os << indent << "FadeRange: " << this->FadeRange[0] << " " << this->FadeRange[1] << "\n";
}
