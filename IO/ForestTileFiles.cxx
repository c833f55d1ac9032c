// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ForestTileFiles.h"

#include "FolderOfFiles.h"
#include "Numerics/InvalidInput.h"

#include <glm/common.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

namespace littoral
{

namespace
{

constexpr const char* LevelFiles[] = { "high.bin", "medium.bin", "low.bin" };
constexpr std::size_t TreesOfStep = 8192; // between which an abort is heard
constexpr double PlacingShare = 0.4;      // of the work

// Bytes of an instance: a translation, scales, and a rotation in 16 bits.
constexpr std::size_t TranslationBytes = 3 * sizeof(float);
constexpr std::size_t RotationBytes = 4 * sizeof(std::int16_t);
constexpr std::size_t ScaleBytes = 3 * sizeof(float);

template <typename Number>
std::string TextOfNumber(Number number)
{
  char digits[32];
  const auto [end, error] = std::to_chars(digits, digits + sizeof(digits), number);
  return { digits, end };
}

template <typename Numbers>
std::string ListOf(const Numbers& numbers)
{
  std::string text = "[";
  for (const auto number : numbers)
  {
    text += (text.size() > 1 ? "," : "") + TextOfNumber(number);
  }
  return text + "]";
}

/// A multiple of a tenth of a millimetre, which has few digits.
Vector3 Rounded(const Vector3& place)
{
  return glm::round(1e4 * place) / 1e4;
}

/// A list of JSON with more objects at its end.
std::string Extended(const std::string& list, const std::string& more)
{
  const bool isEmpty = list.size() <= 2;
  return (isEmpty ? "[" : list.substr(0, list.size() - 1) + ",") + more + "]";
}

template <typename Number>
void Append(std::string& bytes, const Number* numbers, std::size_t count)
{
  bytes.append(reinterpret_cast<const char*>(numbers), count * sizeof(Number));
}

void AppendLength(std::string& bytes, std::size_t length)
{
  for (int place = 0; place < 4; ++place)
  {
    bytes += static_cast<char>(length >> (8 * place) & 0xff);
  }
}

/// A GLB file of a JSON alone.
std::string GlbOf(std::string json)
{
  constexpr std::size_t headers = 20;
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string glb = "glTF";
  AppendLength(glb, 2);
  AppendLength(glb, headers + json.size());
  AppendLength(glb, json.size());
  return glb + "JSON" + json;
}

/// The trees of a file of places: by species, and each species in the order of the tiling.
struct TilePlaces
{
  EarthFrame Frame;
  std::map<int, std::vector<std::size_t>> Trees; ///< places in the order
  std::size_t Count = 0;
  double Widening = 1.0; ///< of the trees, which cover the ground of those that are left out, too
  bool HasRotations = true;

  std::size_t BytesOfTree() const { return TranslationBytes + ScaleBytes + (this->HasRotations ? RotationBytes : 0); }
};

//----------------------------------------------------------------------------
/// Writer of the tiles of a forest.
class TileWriter
{
public:
  TileWriter(const TiledForest& forest, const EarthPlaces& earth, const ForestTilingOptions& options,
    const SceneProgress& progress)
    : From(forest)
    , Earth(earth)
    , Progress(progress)
    , Feet(FlatFeet(forest))
    , Tiling(this->Feet, options)
    , Frames(this->Tiling.GetTiles().size())
    , Boxes(this->Tiling.GetTiles().size())
  {
  }

  /// Writes all files into a folder. Throws WriteStopped when the user asks to stop.
  void WriteTiles(FolderOfFiles& folder);
  /// The tileset, whose tiles are in a folder of a name.
  std::string Tileset(const std::string& folder) const;

private:
  const TiledForest& From;
  const EarthPlaces& Earth;
  const SceneProgress& Progress;
  const std::vector<std::array<double, 2>> Feet;
  const ForestTiling Tiling;
  std::vector<Vector3> OnEarth; // by trees
  std::vector<EarthFrame> Frames;
  std::vector<Box> Boxes; // of tiles, in the frames of their places
  std::map<int, TilePlaces> Places;

  static std::vector<std::array<double, 2>> FlatFeet(const TiledForest& forest)
  {
    std::vector<std::array<double, 2>> feet;
    feet.reserve(forest.Feet.size());
    for (const Vector3& foot : forest.Feet)
    {
      feet.push_back({ { foot.x, foot.y } });
    }
    return feet;
  }

  static double WidthOf(const TiledForest& forest, std::size_t tree)
  {
    const float* scale = &forest.Scales[3 * tree];
    return forest.Extents.at(forest.Species[tree]).Radius * static_cast<double>(std::max(scale[0], scale[1]));
  }

  void Ask(double share) const
  {
    if (!this->Progress(share))
    {
      throw WriteStopped();
    }
  }

  bool HasPlaces(int tile) const { return this->Tiling.GetTiles()[tile].Places == tile; }
  int TreeAt(std::size_t place) const { return this->Tiling.GetOrder()[place]; }
  void PlaceTrees();
  EarthFrame FrameOf(const ForestTile& tile) const;
  void Enclose(int tile);
  TilePlaces PlacesOf(int tile) const;
  std::string BytesOf(const TilePlaces& places) const;
  std::string GltfOf(const ForestTile& tile) const;
  bool IsEmpty(const ForestTile& tile) const;
  void AddTile(int tile, const EarthFrame& above, const std::string& folder, std::string& text) const;
};

//----------------------------------------------------------------------------
/// Widening of trees, of which each s-th is shown: sqrt(s), so that crowns cover as much ground.
double WideningOf(const ForestTile& tile)
{
  return std::sqrt(static_cast<double>(tile.Stride));
}

//----------------------------------------------------------------------------
void TileWriter::PlaceTrees()
{
  this->OnEarth = this->From.Feet;
  const std::size_t count = this->OnEarth.size();
  for (std::size_t first = 0; first < count; first += TreesOfStep)
  {
    this->Ask(PlacingShare * static_cast<double>(first) / static_cast<double>(count));
    this->Earth.Place(&this->OnEarth[first], std::min(TreesOfStep, count - first), first);
  }
}

//----------------------------------------------------------------------------
/// Level axes at the middle of the trees of a tile.
EarthFrame TileWriter::FrameOf(const ForestTile& tile) const
{
  Vector3 low = this->From.Feet[this->TreeAt(tile.First)];
  Vector3 high = low;
  for (std::size_t place = tile.First; place < tile.End; ++place)
  {
    low = glm::min(low, this->From.Feet[this->TreeAt(place)]);
    high = glm::max(high, this->From.Feet[this->TreeAt(place)]);
  }
  return this->Earth.FrameAt(0.5 * (low + high));
}

//----------------------------------------------------------------------------
/// The box of all trees of a tile and of the boxes below it, in the frame of its places.
void TileWriter::Enclose(int tile)
{
  const ForestTile& own = this->Tiling.GetTiles()[tile];
  const EarthFrame& frame = this->Frames[own.Places];
  Box& box = this->Boxes[tile];
  bool isFirst = true;
  const auto unite = [&](const Vector3& low, const Vector3& high) {
    box.Low = isFirst ? low : glm::min(box.Low, low);
    box.High = isFirst ? high : glm::max(box.High, high);
    isFirst = false;
  };
  for (std::size_t place = own.First; place < own.End; ++place)
  {
    const int tree = this->TreeAt(place);
    const Vector3 foot = frame.ToLocal(this->OnEarth[tree]);
    const PlantExtent& extent = this->From.Extents.at(this->From.Species[tree]);
    const double height = static_cast<double>(this->From.Scales[3 * tree + 2]);
    const double width = WideningOf(own) * WidthOf(this->From, tree);
    // Trees are upright in the frame of their places, whatever tile they are shown in.
    unite(foot + Vector3(-width, -width, height * extent.Low), foot + Vector3(width, width, height * extent.High));
  }
  for (const int child : own.Children)
  {
    const EarthFrame& below = this->Frames[this->Tiling.GetTiles()[child].Places];
    const Box& inner = this->Boxes[child];
    for (int corner = 0; corner < 8; ++corner)
    {
      const Vector3 local((corner & 1) != 0 ? inner.High.x : inner.Low.x,
        (corner & 2) != 0 ? inner.High.y : inner.Low.y, (corner & 4) != 0 ? inner.High.z : inner.Low.z);
      const Vector3 at = frame.ToLocal(below.ToEarth(local));
      unite(at, at);
    }
  }
  // In whole millimetres, which have few digits.
  box = { glm::floor(1000.0 * box.Low) / 1000.0, glm::ceil(1000.0 * box.High) / 1000.0 };
}

//----------------------------------------------------------------------------
TilePlaces TileWriter::PlacesOf(int tile) const
{
  const ForestTile& own = this->Tiling.GetTiles()[tile];
  TilePlaces places;
  places.Frame = this->Frames[tile];
  places.Widening = WideningOf(own);
  places.HasRotations = own.Stride == 1; // Low looks the same from all sides
  const std::size_t first = (own.First + own.Stride - 1) / own.Stride * own.Stride;
  for (std::size_t place = first; place < own.End; place += own.Stride)
  {
    places.Trees[this->From.Species[this->TreeAt(place)]].push_back(place);
    ++places.Count;
  }
  return places;
}

//----------------------------------------------------------------------------
/// Translations, scales and rotations of all trees, one array after the other.
std::string TileWriter::BytesOf(const TilePlaces& places) const
{
  std::string translations;
  std::string rotations;
  std::string scales;
  for (const auto& [species, trees] : places.Trees)
  {
    for (const std::size_t place : trees)
    {
      const int tree = this->TreeAt(place);
      const Vector3 local = places.Frame.ToLocal(this->OnEarth[tree]);
      const float at[3] = { static_cast<float>(local.x), static_cast<float>(local.y), static_cast<float>(local.z) };
      Append(translations, at, 3);
      std::int16_t turn[4];
      for (int part = 0; part < 4; ++part)
      {
        turn[part] =
          static_cast<std::int16_t>(std::lround(32767.0 * static_cast<double>(this->From.Rotations[4 * tree + part])));
      }
      Append(rotations, turn, 4);
      const float* own = &this->From.Scales[3 * tree];
      const auto widening = static_cast<float>(places.Widening);
      const float wide[3] = { widening * own[0], widening * own[1], own[2] };
      Append(scales, wide, 3);
    }
  }
  return translations + scales + (places.HasRotations ? rotations : std::string());
}

//----------------------------------------------------------------------------
bool TileWriter::IsEmpty(const ForestTile& tile) const
{
  return this->Places.at(tile.Places).Count == 0;
}

//----------------------------------------------------------------------------
/// A tile as glTF: prototypes of its level, and a part of a file of places.
std::string TileWriter::GltfOf(const ForestTile& tile) const
{
  const TilePrototypes& prototypes = this->From.Levels[static_cast<int>(tile.Level)];
  const TileLibrary& library = prototypes.Library;
  const TilePlaces& places = this->Places.at(tile.Places);
  std::string accessors;
  std::string nodes;
  std::vector<int> children;
  std::size_t before = 0;
  int accessor = library.Accessors;
  const auto addAccessor = [&](int view, std::size_t offset, std::size_t count, const char* form) {
    accessors += (accessors.empty() ? R"({"bufferView":)" : R"(,{"bufferView":)") +
      TextOfNumber(library.BufferViews + view) + R"(,"byteOffset":)" + TextOfNumber(offset) + R"(,"count":)" +
      TextOfNumber(count) + form + "}";
    return accessor++;
  };
  for (const auto& [species, trees] : places.Trees)
  {
    const auto first = std::lower_bound(trees.begin(), trees.end(), tile.First);
    const auto end = std::lower_bound(first, trees.end(), tile.End);
    const std::size_t offset = before + static_cast<std::size_t>(first - trees.begin());
    const auto count = static_cast<std::size_t>(end - first);
    before += trees.size();
    const auto meshes = prototypes.Meshes.find(species);
    if (count == 0 || meshes == prototypes.Meshes.end())
    {
      continue;
    }
    std::string attributes = R"({"TRANSLATION":)" +
      TextOfNumber(addAccessor(0, offset * TranslationBytes, count, R"(,"componentType":5126,"type":"VEC3")"));
    attributes += R"(,"SCALE":)" +
      TextOfNumber(addAccessor(1, offset * ScaleBytes, count, R"(,"componentType":5126,"type":"VEC3")"));
    if (places.HasRotations)
    {
      attributes += R"(,"ROTATION":)" +
        TextOfNumber(
          addAccessor(2, offset * RotationBytes, count, R"(,"componentType":5122,"normalized":true,"type":"VEC4")"));
    }
    children.push_back(static_cast<int>(children.size()) + 1);
    nodes += R"(,{"mesh":)" + TextOfNumber(meshes->second) +
      R"(,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":)" + attributes + "}}}}";
  }
  std::string views;
  std::size_t start = 0;
  for (const std::size_t bytes : { TranslationBytes, ScaleBytes, RotationBytes })
  {
    if (start == places.BytesOfTree() * places.Count)
    {
      break;
    }
    views += (views.empty() ? R"({"buffer":1,"byteOffset":)" : R"(,{"buffer":1,"byteOffset":)") + TextOfNumber(start) +
      R"(,"byteLength":)" + TextOfNumber(bytes * places.Count) + "}";
    start += bytes * places.Count;
  }
  std::string json = R"({"asset":{"version":"2.0"},)"
                     R"("extensionsUsed":["EXT_mesh_gpu_instancing"],"extensionsRequired":["EXT_mesh_gpu_instancing"],)"
                     R"("scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"rotation":[-0.7071067811865476,0,0,)"
                     R"(0.7071067811865476],"children":)" +
    ListOf(children) + "}" + nodes + R"(],"buffers":[{"uri":")" + LevelFiles[static_cast<int>(tile.Level)] +
    R"(","byteLength":)" + TextOfNumber(library.Buffer.size()) + R"(},{"uri":")" + TextOfNumber(tile.Places) +
    R"(.bin","byteLength":)" + TextOfNumber(start) + "}]";
  for (const auto& [name, list] : library.Lists)
  {
    const std::string& more = name == "accessors" ? accessors : name == "bufferViews" ? views : std::string();
    json += ",\"" + name + "\":" + (more.empty() ? list : Extended(list, more));
  }
  return GlbOf(json + "}");
}

//----------------------------------------------------------------------------
void TileWriter::WriteTiles(FolderOfFiles& folder)
{
  this->PlaceTrees();
  for (std::size_t level = 0; level < this->From.Levels.size(); ++level)
  {
    folder.Add(LevelFiles[level], this->From.Levels[level].Library.Buffer);
  }
  const std::vector<ForestTile>& tiles = this->Tiling.GetTiles();
  const int count = static_cast<int>(tiles.size());
  for (int tile = 0; tile < count; ++tile)
  {
    const double done = static_cast<double>(tile) / count;
    this->Ask(PlacingShare + (1.0 - PlacingShare) * done);
    if (this->HasPlaces(tile))
    {
      this->Frames[tile] = this->FrameOf(tiles[tile]);
      this->Places[tile] = this->PlacesOf(tile);
      folder.Add(TextOfNumber(tile) + ".bin", this->BytesOf(this->Places[tile]));
    }
    if (!this->IsEmpty(tiles[tile]))
    {
      folder.Add(TextOfNumber(tile) + ".glb", this->GltfOf(tiles[tile]));
    }
  }
  for (int tile = count - 1; tile >= 0; --tile)
  {
    this->Enclose(tile);
  }
}

//----------------------------------------------------------------------------
void TileWriter::AddTile(int tile, const EarthFrame& above, const std::string& folder, std::string& text) const
{
  const ForestTile& own = this->Tiling.GetTiles()[tile];
  const EarthFrame& frame = this->Frames[own.Places];
  const Vector3 middle = Rounded(0.5 * (this->Boxes[tile].Low + this->Boxes[tile].High));
  const Vector3 half = Rounded(0.5 * (this->Boxes[tile].High - this->Boxes[tile].Low));
  text += R"({"boundingVolume":{"box":)" +
    ListOf(std::array<double, 12>{ middle.x, middle.y, middle.z, half.x, 0, 0, 0, half.y, 0, 0, 0, half.z }) +
    R"(},"geometricError":)" + TextOfNumber(own.Error);
  text += tile == 0 ? R"(,"refine":"REPLACE")" : "";
  text += this->HasPlaces(tile) ? R"(,"transform":)" + ListOf(frame.MatrixTo(above)) : std::string();
  text +=
    this->IsEmpty(own) ? std::string() : R"(,"content":{"uri":")" + folder + "/" + TextOfNumber(tile) + R"(.glb"})";
  for (const int child : own.Children)
  {
    text += child == own.Children.front() ? R"(,"children":[)" : ",";
    this->AddTile(child, frame, folder, text);
  }
  text += own.Children.empty() ? "}" : "]}";
}

//----------------------------------------------------------------------------
std::string TileWriter::Tileset(const std::string& folder) const
{
  // Nothing shown is wrong by all that there is.
  const Vector3 size = this->Boxes[0].High - this->Boxes[0].Low;
  const double error = std::max(glm::length(size), this->Tiling.GetTiles()[0].Error);
  std::string text =
    R"({"asset":{"version":"1.1","generator":"Littoral"},"geometricError":)" + TextOfNumber(error) + R"(,"root":)";
  this->AddTile(0, EarthFrame(), folder, text);
  return text + "}\n";
}

/// A name as part of an address and of JSON.
std::string AddressOf(const std::string& name)
{
  constexpr const char* digits = "0123456789ABCDEF";
  std::string address;
  for (const char letter : name)
  {
    const auto code = static_cast<unsigned char>(letter);
    const bool isPlain = (code >= '0' && code <= '9') || (code >= 'A' && code <= 'Z') || (code >= 'a' && code <= 'z') ||
      code == '-' || code == '_' || code == '.';
    address += isPlain ? std::string(1, letter) : std::string{ '%', digits[code >> 4], digits[code & 15] };
  }
  return address;
}

}

//----------------------------------------------------------------------------
FileOutcome WriteForestTiles(const std::string& path, const TiledForest& forest, const EarthPlaces& earth,
  const ForestTilingOptions& options, const SceneProgress& progress)
{
  return WriteFile(path, [&](ReplacedFile& file) {
    FolderOfFiles folder(path);
    TileWriter writer(forest, earth, options, progress);
    writer.WriteTiles(folder);
    file.Stream() << writer.Tileset(AddressOf(folder.Name()));
    if (!file.Close())
    {
      return false;
    }
    folder.Commit();
    if (!file.Commit())
    {
      folder.Withdraw();
      return false;
    }
    folder.RemoveOthers();
    return true;
  });
}

}
