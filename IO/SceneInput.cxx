// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneInput.h"

#include "Data/Blocks.h"
#include "Data/Inputs.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Memory.h"
#include "SceneBlocks.h"
#include "SceneFile.h"
#include "SceneSurface.h"

#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"

#include <vtk_utf8.h>

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

constexpr double NodeBytes = 300.0; // of a node as JSON, about

bool IsUtf8(const std::string& text)
{
  return utf8::is_valid(text.begin(), text.end());
}

/// A text with a question mark in the place of each byte that is none of ASCII.
std::string Readable(std::string text)
{
  std::replace_if(
    text.begin(), text.end(), [](char byte) { return static_cast<unsigned char>(byte) > 126; }, '?');
  return text;
}

/// Why so many bytes are too many for a file, or for the memory; empty if they are not.
std::string WhyTooManyBytes(double bytes)
{
  const auto gigabytes = [](double number) { return TextOf(std::round(number / 1e7) / 100.0) + " GB"; };
  if (bytes > MaximumSceneFile)
  {
    return "the scene needs " + gigabytes(bytes) + "; a GLB file holds at most 4.29 GB.";
  }
  // The meshes, their place in the buffer, and the library's copy of it.
  constexpr double copies = 3.0;
  return WhyRefused([&] { RequireMemory(copies * bytes, "the scene", "take less of it"); });
}

double BytesOf(const SceneMesh& mesh)
{
  const std::size_t floats = mesh.Positions.size() + mesh.Normals.size() + mesh.TextureCoordinates.size() +
    mesh.Colors.size() + mesh.Velocities.size() + mesh.Radii.size() + mesh.JointWeights.size();
  const std::size_t indices = mesh.Triangles.size() + mesh.Lines.size() + mesh.Points.size();
  double bytes = 4.0 * static_cast<double>(floats + indices) + 2.0 * static_cast<double>(mesh.JointIds.size());
  for (const SceneMesh::Target& target : mesh.Targets)
  {
    bytes += 4.0 * static_cast<double>(target.Positions.size() + target.Normals.size());
  }
  for (const SceneMesh& more : mesh.More)
  {
    bytes += BytesOf(more);
  }
  return bytes;
}

//----------------------------------------------------------------------------
/// Looks at all data before anything is copied.
class SceneCheck
{
public:
  explicit SceneCheck(const SceneOptions& options)
    : Options(options)
  {
  }

  void Check(const SceneSource& source)
  {
    this->Points = 0;
    this->CheckName(source.Name);
    this->CheckData(source.Data, source.Name);
    Require(this->Points > 0 ? "" : source.Name + " has no points.");
  }

  void CheckName(const std::string& name)
  {
    Require(IsUtf8(name) ? "" : "the name '" + Readable(name) + "' is not in UTF-8.");
  }

  double GetBytes() const { return this->Bytes; }

private:
  const SceneOptions& Options;
  double Bytes = 0.0;
  vtkIdType Points = 0;

  void CheckData(vtkDataObject* data, const std::string& owner)
  {
    if (IsComposite(data))
    {
      this->CheckBlocks(BlocksOf(data, owner.c_str()), owner);
      return;
    }
    auto* image = vtkImageData::SafeDownCast(data);
    vtkSmartPointer<vtkPolyData> surface = vtkPolyData::SafeDownCast(data);
    if (image)
    {
      RequireTerrain(image, owner);
      this->Points += image->GetNumberOfPoints();
      this->Bytes += TerrainBytes(image);
      return;
    }
    Require(surface ? ""
                    : WhyOtherType(data, owner.c_str(),
                        "polygonal data (vtkPolyData), a terrain (vtkImageData) or blocks of them"));
    RequireSurface(surface, owner);
    this->Points += surface->GetNumberOfPoints();
    this->Bytes += MeshBytes(surface, this->Options.HasVelocity);
  }

  void CheckBlocks(vtkMultiBlockDataSet* blocks, const std::string& owner)
  {
    vtkPolyData* points = InstancesOf(blocks);
    if (points)
    {
      constexpr double bytesEach = (3 + 4 + 3 + 3) * sizeof(float);
      RequireInstances(points, owner);
      const bool areNodes = this->Options.Instances == SceneInstanceForm::Nodes;
      this->Bytes += (areNodes ? 3.0 * NodeBytes : bytesEach) * static_cast<double>(points->GetNumberOfPoints());
    }
    if (ArePlants(blocks) && this->Options.HasMotion)
    {
      RequireMotion(blocks, owner);
    }
    for (const NamedBlock& block : NamedBlocks(blocks))
    {
      this->CheckName(block.Name);
      if (block.Data != points)
      {
        this->CheckData(block.Data, owner + "/" + block.Name);
      }
    }
  }
};

}

//----------------------------------------------------------------------------
void RequireScene(const Scene& scene, const std::vector<SceneSource>& sources, const SceneOptions& options)
{
  SceneCheck check(options);
  check.CheckName(scene.Name);
  for (const SceneSource& source : sources)
  {
    check.Check(source);
  }
  Require(WhyTooManyBytes(check.GetBytes()));
}

//----------------------------------------------------------------------------
std::string WhyTooLarge(const Scene& scene)
{
  constexpr double trackBytes = 250.0; // of a track as JSON, about
  double bytes = NodeBytes * static_cast<double>(scene.Nodes.size());
  for (const SceneMesh& mesh : scene.Meshes)
  {
    bytes += BytesOf(mesh);
  }
  for (const SceneTrack& track : scene.Tracks)
  {
    bytes += trackBytes + sizeof(std::int16_t) * static_cast<double>(track.Rotations.size()) +
      sizeof(float) * static_cast<double>(track.Translations.size() + track.Weights.size());
  }
  return WhyTooManyBytes(bytes);
}

}
