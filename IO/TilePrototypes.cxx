// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TilePrototypes.h"

#include "Numerics/InvalidInput.h"
#include "SceneBlocks.h"
#include "SceneFile.h"
#include "SceneReader.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <set>
#include <utility>

namespace littoral
{

namespace
{

constexpr int Levels = 3;

/// A number of four bytes in a GLB file, the lowest first.
std::size_t NumberAt(const std::string& bytes, std::size_t at)
{
  std::size_t number = 0;
  for (std::size_t place = 4; place-- > 0;)
  {
    number = number << 8 | static_cast<unsigned char>(bytes.at(at + place));
  }
  return number;
}

/// The end of a value of JSON that begins at a place: behind its last bracket or before the next comma or bracket.
std::size_t EndOfValue(const std::string& json, std::size_t at)
{
  int depth = 0;
  bool isText = false;
  for (; at < json.size(); ++at)
  {
    const char letter = json[at];
    if (isText)
    {
      at += letter == '\\' ? 1 : 0;
      isText = letter != '"';
      continue;
    }
    isText = letter == '"';
    const bool opens = letter == '[' || letter == '{';
    const bool closes = letter == ']' || letter == '}';
    if (depth == 0 && (letter == ',' || closes))
    {
      return at;
    }
    depth += opens ? 1 : closes ? -1 : 0;
  }
  return at;
}

/// The members of an object of JSON without blanks.
std::map<std::string, std::string> MembersOf(const std::string& json)
{
  std::map<std::string, std::string> members;
  std::size_t at = json.find('"');
  while (at != std::string::npos && at < json.size())
  {
    const std::size_t end = json.find('"', at + 1);
    const std::size_t value = json.find(':', end) + 1;
    const std::size_t behind = EndOfValue(json, value);
    members[json.substr(at + 1, end - at - 1)] = json.substr(value, behind - value);
    at = behind < json.size() && json[behind] == ',' ? json.find('"', behind) : std::string::npos;
  }
  return members;
}

/// The values in a list of JSON.
std::vector<std::string> ValuesOf(const std::string& list)
{
  std::vector<std::string> values;
  for (std::size_t at = 1; at < list.size() && list[at] != ']';)
  {
    const std::size_t end = EndOfValue(list, at);
    values.push_back(list.substr(at, end - at));
    at = end + 1;
  }
  return values;
}

/// A list of JSON of objects without members that each tile can do without.
std::string Without(
  const std::vector<std::string>& objects, const std::function<bool(std::size_t, const std::string&)>& isLeft)
{
  std::string list;
  for (std::size_t object = 0; object < objects.size(); ++object)
  {
    std::string text;
    for (const auto& [name, value] : MembersOf(objects[object]))
    {
      if (!isLeft(object, name))
      {
        text += (text.empty() ? "{\"" : ",\"") + name + "\":" + value;
      }
    }
    list += (list.empty() ? "[" : ",") + text + "}";
  }
  return list + "]";
}

/// The accessors of positions.
std::set<std::size_t> PositionsOf(const std::string& meshes)
{
  const std::string name = "\"POSITION\":";
  std::set<std::size_t> positions;
  for (std::size_t at = meshes.find(name); at != std::string::npos; at = meshes.find(name, at + 1))
  {
    positions.insert(std::stoul(meshes.substr(at + name.size())));
  }
  return positions;
}

/// Adds numbers of vertices to a pool, or where there are none a number for each component.
void AddVertices(const std::vector<float>& from, std::size_t vertices, std::size_t components, float otherwise,
  std::vector<float>& pool)
{
  pool.insert(pool.end(), from.begin(), from.end());
  pool.resize(pool.size() + (from.empty() ? vertices * components : 0), otherwise);
}

/// A mesh whose vertices are in a pool. Each tile tells of each array of vertices: one for all saves bytes.
SceneMesh Pooled(const SceneMesh& from, SceneMesh& pool)
{
  SceneMesh mesh;
  mesh.Material = from.Material;
  mesh.SharesVertices = true;
  const auto first = static_cast<std::uint32_t>(pool.GetNumberOfVertices());
  const std::size_t vertices = from.GetNumberOfVertices();
  pool.Positions.insert(pool.Positions.end(), from.Positions.begin(), from.Positions.end());
  AddVertices(from.Normals, vertices, 3, std::sqrt(1.0F / 3.0F), pool.Normals);
  AddVertices(from.TextureCoordinates, vertices, 2, 0.0F, pool.TextureCoordinates);
  Require(from.ColorParts == 3 ? "" : "the prototypes of the input have transparent colors, which are not written");
  AddVertices(from.Colors, vertices, 3, 1.0F, pool.Colors);
  for (const auto part : { &SceneMesh::Triangles, &SceneMesh::Lines, &SceneMesh::Points })
  {
    for (const std::uint32_t vertex : from.*part)
    {
      (mesh.*part).push_back(first + vertex);
    }
  }
  return mesh;
}

/// The level at which a species is drawn: the wanted one, the next coarser or else the next finer that it has.
int LevelFor(const std::array<std::vector<int>, Levels>& meshes, int wanted)
{
  for (const int level : { wanted, wanted + 1, wanted + 2, wanted - 1, wanted - 2 })
  {
    if (level >= 0 && level < Levels && !meshes[level].empty())
    {
      return level;
    }
  }
  return wanted;
}

/// Leaves out the materials and pictures that no mesh has.
void DropUnused(Scene& scene)
{
  std::map<int, int> materials;
  std::map<int, int> pictures;
  Scene from = scene;
  scene.Materials.clear();
  scene.Pictures.clear();
  const auto renumber = [](std::map<int, int>& known, int old, auto& all, auto&& take) {
    const auto found = known.emplace(old, static_cast<int>(all.size()));
    if (found.second)
    {
      all.push_back(take());
    }
    return found.first->second;
  };
  const auto take = [&](SceneMesh& mesh) {
    mesh.Material = renumber(materials, mesh.Material, scene.Materials, [&] {
      SceneMaterial material = from.Materials[mesh.Material];
      if (material.Picture >= 0)
      {
        material.Picture = renumber(
          pictures, material.Picture, scene.Pictures, [&] { return std::move(from.Pictures[material.Picture]); });
      }
      return material;
    });
  };
  for (SceneMesh& mesh : scene.Meshes)
  {
    take(mesh);
    std::for_each(mesh.More.begin(), mesh.More.end(), take);
  }
}

}

//----------------------------------------------------------------------------
TileLibrary LibraryOf(const std::string& glb)
{
  constexpr std::size_t header = 12;
  constexpr std::size_t chunk = 8;
  Require(glb.size() > header + chunk ? "" : "the prototypes of the input draw nothing");
  const std::size_t json = NumberAt(glb, header);
  const std::size_t buffer = header + chunk + json;
  TileLibrary library;
  if (glb.size() > buffer + chunk)
  {
    library.Buffer = glb.substr(buffer + chunk, NumberAt(glb, buffer));
  }
  const std::map<std::string, std::string> members = MembersOf(glb.substr(header + chunk, json));
  for (const char* name : { "accessors", "bufferViews", "images", "materials", "meshes", "samplers", "textures" })
  {
    const auto found = members.find(name);
    if (found != members.end())
    {
      library.Lists[name] = found->second;
    }
  }
  const std::vector<std::string> accessors = ValuesOf(library.Lists["accessors"]);
  const std::vector<std::string> views = ValuesOf(library.Lists["bufferViews"]);
  library.Accessors = static_cast<int>(accessors.size());
  library.BufferViews = static_cast<int>(views.size());
  // Each tile has them: of bounds only those that glTF asks for, and no names.
  const std::set<std::size_t> positions = PositionsOf(library.Lists["meshes"]);
  library.Lists["accessors"] = Without(accessors, [&](std::size_t accessor, const std::string& name) {
    return (name == "max" || name == "min") && positions.count(accessor) == 0;
  });
  library.Lists["bufferViews"] = Without(views, [](std::size_t, const std::string& name) { return name == "target"; });
  const auto isLabel = [](std::size_t, const std::string& name) { return name == "name" || name == "extras"; };
  for (const char* name : { "materials", "meshes" })
  {
    library.Lists[name] = Without(ValuesOf(library.Lists[name]), isLabel);
  }
  const std::string triangles = ",\"mode\":4"; // what a reader takes without it
  std::string& meshes = library.Lists["meshes"];
  for (std::size_t at = meshes.find(triangles); at != std::string::npos; at = meshes.find(triangles))
  {
    meshes.erase(at, triangles.size());
  }
  return library;
}

//----------------------------------------------------------------------------
TilePrototypes PrototypesOf(vtkMultiBlockDataSet* blocks, int level)
{
  Scene scene;
  SceneOptions options;
  options.Levels = SceneLevelForm::AsShown;
  SceneReader reader(options, scene);
  const std::map<int, std::array<std::vector<int>, Levels>> all = reader.AddPrototypes(blocks);
  TilePrototypes prototypes;
  Scene own = scene;
  own.Meshes.clear();
  SceneMesh pool;
  for (const auto& [species, levels] : all)
  {
    const std::vector<int>& parts = levels[LevelFor(levels, level)];
    for (const int part : parts)
    {
      SceneMesh mesh = Pooled(scene.Meshes[part], pool);
      if (part == parts.front())
      {
        prototypes.Meshes[species] = static_cast<int>(own.Meshes.size());
        own.Meshes.push_back(std::move(mesh));
      }
      else
      {
        own.Meshes.back().More.push_back(std::move(mesh));
      }
    }
  }
  Require(own.Meshes.empty() ? "the prototypes of the input draw nothing" : "");
  SceneMesh& first = own.Meshes.front();
  first.SharesVertices = false;
  first.Positions = std::move(pool.Positions);
  first.Normals = std::move(pool.Normals);
  first.TextureCoordinates = std::move(pool.TextureCoordinates);
  first.Colors = std::move(pool.Colors);
  DropUnused(own);
  prototypes.Library = LibraryOf(SceneBytes(own));
  return prototypes;
}

//----------------------------------------------------------------------------
std::map<int, PlantExtent> ExtentsOf(vtkMultiBlockDataSet* blocks)
{
  std::map<int, PlantExtent> extents;
  for (const NamedBlock& block : NamedBlocks(blocks))
  {
    auto* parts = vtkMultiBlockDataSet::SafeDownCast(block.Data);
    for (const NamedBlock& part : parts ? NamedBlocks(parts) : std::vector<NamedBlock>())
    {
      auto* data = vtkPolyData::SafeDownCast(part.Data);
      const int prototype = PrototypeOf(data);
      for (vtkIdType point = 0; prototype > 0 && point < data->GetNumberOfPoints(); ++point)
      {
        double at[3];
        data->GetPoint(point, at);
        PlantExtent& extent = extents[(prototype - 1) / Levels];
        extent.Radius = std::max(extent.Radius, std::hypot(at[0], at[1]));
        extent.Low = std::min(extent.Low, at[2]);
        extent.High = std::max(extent.High, at[2]);
      }
    }
  }
  return extents;
}

}
