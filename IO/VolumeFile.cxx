// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFile.h"

#include "ReplacedFile.h"

#include <openvdb/io/Archive.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Prune.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <ios>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace littoral
{

namespace
{

using openvdb::Coord;

/// The largest number that does not become infinite in half precision, as it is rounded.
constexpr float HalfEnd = 65520.0f;

/// Bits of |value|. They sort as the values do, and those of what is not finite sort behind.
std::uint32_t MagnitudeBits(float value)
{
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits & 0x7fffffffu;
}

// --- From a dense block to leaves -----------------------------------------------------------------------------------

template <typename Value>
constexpr int ComponentsOf = 1;
template <>
constexpr int ComponentsOf<openvdb::Vec3f> = 3;

template <typename Value>
Value ValueAt(const float* from)
{
  if constexpr (ComponentsOf<Value> == 3)
  {
    return Value(from[0], from[1], from[2]);
  }
  else
  {
    return *from;
  }
}

template <typename Value>
std::uint32_t LargestBits(const float* from)
{
  std::uint32_t bits = MagnitudeBits(*from);
  for (int component = 1; component < ComponentsOf<Value>; ++component)
  {
    bits = std::max(bits, MagnitudeBits(from[component]));
  }
  return bits;
}

/// The leaves that a block reaches, in a box of their own.
struct LeafBox
{
  explicit LeafBox(const VolumeBlock& block)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->First[axis] = block.Extent[2 * axis] & ~7;
      this->Size[axis] =
        static_cast<std::size_t>((static_cast<long long>(block.Extent[2 * axis + 1]) - this->First[axis]) / 8 + 1);
    }
  }
  std::size_t Count() const { return this->Size[0] * this->Size[1] * this->Size[2]; }
  Coord Origin(std::size_t leaf) const
  {
    const auto at = [&](int axis, std::size_t index) { return this->First[axis] + 8 * static_cast<int>(index); };
    return Coord(at(0, leaf % this->Size[0]), at(1, leaf / this->Size[0] % this->Size[1]),
      at(2, leaf / (this->Size[0] * this->Size[1])));
  }
  int First[3];
  std::size_t Size[3];
};

/// A leaf in the making.
template <typename Leaf>
struct LeafDraft
{
  std::unique_ptr<Leaf> Node;     ///< null where all samples are background
  bool Tile = false;              ///< all samples are there and the same
  std::uint32_t LargestBits = 0u; ///< of all samples, also of those not stored
};

template <typename Leaf>
LeafDraft<Leaf> DraftLeaf(const VolumeBlock& block, const Coord& origin, std::uint32_t toleranceBits)
{
  using Value = typename Leaf::ValueType;
  LeafDraft<Leaf> draft;
  draft.Node = std::make_unique<Leaf>(origin, openvdb::zeroVal<Value>(), false);
  Value* values = draft.Node->buffer().data();
  int first[3], last[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    first[axis] = std::max(origin[axis], block.Extent[2 * axis]);
    last[axis] = std::min(origin[axis] + 7, block.Extent[2 * axis + 1]);
  }
  std::uint64_t active[8] = {}; // a word a layer in x, as in OpenVDB's masks
  for (int z = first[2]; z <= last[2]; ++z)
  {
    for (int y = first[1]; y <= last[1]; ++y)
    {
      const std::size_t place = block.Place(first[0], y, z);
      const float* from = block.Values + place * block.Stride;
      const unsigned char* ghosts = block.Ghosts ? block.Ghosts + place : nullptr;
      const int column = (y & 7) << 3 | (z & 7);
      for (int x = first[0]; x <= last[0]; ++x, from += block.Stride)
      {
        if (ghosts && (ghosts[x - first[0]] & block.Hidden))
        {
          continue;
        }
        const std::uint32_t bits = LargestBits<Value>(from);
        draft.LargestBits = std::max(draft.LargestBits, bits);
        if (bits > toleranceBits)
        {
          values[(x & 7) << 6 | column] = ValueAt<Value>(from);
          active[x & 7] |= std::uint64_t{ 1 } << column;
        }
      }
    }
  }
  auto& mask = draft.Node->getValueMask();
  for (int layer = 0; layer < 8; ++layer)
  {
    mask.template getWord<std::uint64_t>(layer) = active[layer];
  }
  if (mask.isOff())
  {
    draft.Node.reset();
  }
  else if (mask.isOn())
  {
    draft.Tile = std::all_of(values + 1, values + Leaf::SIZE, [&](const Value& value) { return value == *values; });
  }
  return draft;
}

/// Sets a leaf into the tree. Blocks may overlap; where they do they hold the same samples.
template <typename Tree, typename Leaf>
void Insert(Tree& tree, LeafDraft<Leaf>& draft)
{
  const Coord origin = draft.Node->origin();
  if (draft.Tile)
  {
    tree.addTile(1, origin, draft.Node->getValue(0), true);
  }
  else if (Leaf* other = tree.probeLeaf(origin))
  {
    for (auto value = draft.Node->cbeginValueOn(); value; ++value)
    {
      other->setValueOn(value.pos(), *value);
    }
  }
  else if (!tree.isValueOn(origin)) // where it is on there is a tile, which is whole
  {
    tree.addLeaf(draft.Node.release());
  }
}

std::string Named(const Volume& volume)
{
  return "the array '" + volume.Array + "'" + (volume.Place.empty() ? "" : " of block '" + volume.Place + "'");
}

std::string WhereNotFinite(const Volume& volume, const VolumeBlock& block)
{
  for (int z = block.Extent[4]; z <= block.Extent[5]; ++z)
  {
    for (int y = block.Extent[2]; y <= block.Extent[3]; ++y)
    {
      for (int x = block.Extent[0]; x <= block.Extent[1]; ++x)
      {
        const std::size_t place = block.Place(x, y, z);
        const bool hidden = block.Ghosts && (block.Ghosts[place] & block.Hidden);
        for (int component = 0; component < volume.Components && !hidden; ++component)
        {
          if (MagnitudeBits(block.Values[place * block.Stride + component]) >= 0x7f800000u)
          {
            return std::to_string(x) + ", " + std::to_string(y) + ", " + std::to_string(z);
          }
        }
      }
    }
  }
  return {};
}

/// Throws what a user should read if a value does not fit into the file.
void CheckLargest(std::uint32_t bits, const Volume& volume, const VolumeBlock& block, bool half)
{
  if (bits >= 0x7f800000u)
  {
    throw std::runtime_error(Named(volume) +
      " holds a value that is not a finite single-precision number, first at index (" + WhereNotFinite(volume, block) +
      "); replace such values first");
  }
  if (half && bits >= MagnitudeBits(HalfEnd))
  {
    float largest;
    std::memcpy(&largest, &bits, sizeof(largest));
    throw std::runtime_error(Named(volume) + " reaches " + std::to_string(largest) +
      ", and half precision ends at 65504; switch HalfFloat off");
  }
}

/// The largest float that is not above the tolerance.
std::uint32_t ToleranceBits(double tolerance)
{
  const float limit = static_cast<float>(std::min<double>(tolerance, std::numeric_limits<float>::max()));
  const std::uint32_t bits = MagnitudeBits(limit);
  return static_cast<double>(limit) > tolerance ? bits - 1 : bits;
}

/// Visits the blocks of a volume, of those that lie elsewhere box by box.
template <typename Visit>
void EachLoaded(const Volume& volume, const Visit& visit)
{
  for (const VolumeBlock& block : volume.Blocks)
  {
    if (!block.Load)
    {
      visit(block);
      continue;
    }
    for (const std::array<int, 6>& box : BoxesToLoad(block, volume.Components))
    {
      visit(block.Load(box));
    }
  }
}

template <typename Grid>
openvdb::GridBase::Ptr MakeGrid(const Volume& volume, const VolumeFileOptions& options, const ParallelFor& parallelFor)
{
  using Leaf = typename Grid::TreeType::LeafNodeType;
  auto grid = Grid::create();
  auto& tree = grid->tree();
  const std::uint32_t toleranceBits = ToleranceBits(options.Tolerance);
  EachLoaded(volume, [&](const VolumeBlock& block) {
    const LeafBox box(block);
    std::vector<LeafDraft<Leaf>> drafts(box.Count());
    parallelFor(drafts.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t leaf = begin; leaf < end; ++leaf)
      {
        drafts[leaf] = DraftLeaf<Leaf>(block, box.Origin(leaf), toleranceBits);
      }
    });
    std::uint32_t largest = 0u;
    for (const auto& draft : drafts)
    {
      largest = std::max(largest, draft.LargestBits);
    }
    CheckLargest(largest, volume, block, options.Half);
    for (auto& draft : drafts)
    {
      if (draft.Node)
      {
        Insert(tree, draft);
      }
    }
  });
  openvdb::tools::pruneTiles(tree);
  return grid;
}

// --- What goes with the values --------------------------------------------------------------------------------------

/**
 * A transform with this very map. The constructor of Transform would take the steps as differences of places, which is
 * wrong by 1e-10 m at 1000 km; reading one does not.
 */
openvdb::math::Transform::Ptr TransformOf(const openvdb::math::MapBase& map)
{
  std::stringstream stream(std::ios_base::in | std::ios_base::out | std::ios_base::binary);
  openvdb::io::setCurrentVersion(stream);
  openvdb::writeString(stream, map.type());
  map.write(stream);
  auto transform = std::make_shared<openvdb::math::Transform>();
  transform->read(stream);
  return transform;
}

openvdb::math::Transform::Ptr TransformOf(const VolumeLattice& lattice)
{
  namespace math = openvdb::math;
  const auto& step = lattice.Step;
  const openvdb::Vec3d origin(lattice.Origin.data());
  bool straight = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    straight = straight && step[axis][(axis + 1) % 3] == 0.0 && step[axis][(axis + 2) % 3] == 0.0;
  }
  math::MapBase::Ptr map;
  if (straight && step[0][0] == step[1][1] && step[0][0] == step[2][2])
  {
    map = std::make_shared<math::UniformScaleTranslateMap>(step[0][0], origin); // what some readers insist on
  }
  else if (straight)
  {
    map = std::make_shared<math::ScaleTranslateMap>(openvdb::Vec3d(step[0][0], step[1][1], step[2][2]), origin);
  }
  else
  {
    // OpenVDB multiplies rows by matrices: each row is where an axis goes.
    const openvdb::Mat4d matrix(step[0][0], step[0][1], step[0][2], 0.0, step[1][0], step[1][1], step[1][2], 0.0,
      step[2][0], step[2][1], step[2][2], 0.0, origin[0], origin[1], origin[2], 1.0);
    map = std::make_shared<math::AffineMap>(matrix);
  }
  return TransformOf(*map);
}

void AddRemarks(const VolumeRemarks& remarks, openvdb::MetaMap& target)
{
  for (const auto& [name, remark] : remarks)
  {
    if (const auto* text = std::get_if<std::string>(&remark))
    {
      target.insertMeta(name, openvdb::StringMetadata(*text));
    }
    else if (const auto* number = std::get_if<double>(&remark))
    {
      target.insertMeta(name, openvdb::DoubleMetadata(*number));
    }
    else
    {
      target.insertMeta(name, openvdb::Vec3DMetadata(openvdb::Vec3d(std::get<2>(remark).data())));
    }
  }
}

openvdb::VecType VectorTypeOf(VolumeVectors vectors)
{
  switch (vectors)
  {
    case VolumeVectors::Normal:
      return openvdb::VEC_COVARIANT_NORMALIZE;
    case VolumeVectors::Invariant:
      return openvdb::VEC_INVARIANT;
    default:
      return openvdb::VEC_CONTRAVARIANT_RELATIVE;
  }
}

openvdb::GridBase::Ptr GridOf(const Volume& volume, const VolumeFileOptions& options, const ParallelFor& parallelFor)
{
  openvdb::GridBase::Ptr grid = volume.Components == 3 ? MakeGrid<openvdb::Vec3SGrid>(volume, options, parallelFor)
                                                       : MakeGrid<openvdb::FloatGrid>(volume, options, parallelFor);
  AddRemarks(volume.Remarks, *grid);
  grid->setName(volume.Name);
  grid->setCreator("Littoral");
  grid->setTransform(TransformOf(volume.Lattice));
  grid->setSaveFloatAsHalf(options.Half);
  if (volume.Components == 3)
  {
    grid->setVectorType(VectorTypeOf(volume.Vectors));
    grid->setIsInWorldSpace(true);
  }
  else
  {
    grid->setGridClass(openvdb::GRID_FOG_VOLUME);
  }
  return grid;
}

// --- The file -------------------------------------------------------------------------------------------------------

/// OpenVDB's own writer, into a stream of ours that can be searched, so that readers find grids without reading all.
class VolumeArchive : public openvdb::io::Archive
{
public:
  VolumeArchive(VolumeCompression compression)
  {
    const bool blosc = compression == VolumeCompression::Blosc && hasBloscCompression();
    const bool zip = compression != VolumeCompression::None && !blosc && hasZLibCompression();
    this->setCompression(openvdb::io::COMPRESS_ACTIVE_MASK |
      (blosc    ? openvdb::io::COMPRESS_BLOSC
          : zip ? openvdb::io::COMPRESS_ZIP
                : openvdb::io::COMPRESS_NONE));
  }
  void WriteTo(std::ostream& stream, const openvdb::GridCPtrVec& grids, const openvdb::MetaMap& remarks) const
  {
    this->Archive::write(stream, grids, true, remarks);
  }
};

/// A number that different bytes hardly share, in four lanes that a processor can work on at once.
class Digest
{
public:
  void Add(const char* bytes, std::size_t count)
  {
    constexpr std::size_t stride = sizeof(this->Lanes);
    std::size_t at = 0;
    for (; at + stride <= count; at += stride)
    {
      this->AddStride(bytes + at);
    }
    char rest[stride] = {};
    std::memcpy(rest, bytes + at, count - at);
    this->AddStride(rest);
    this->Lanes[0] ^= count;
  }
  /// As the text of an identifier of version 8: one made in a way of one's own.
  std::string Identifier() const
  {
    std::uint64_t states[2] = { Mix(this->Lanes[0] ^ Mix(this->Lanes[1])), Mix(this->Lanes[2] ^ Mix(this->Lanes[3])) };
    std::string text = "xxxxxxxx-xxxx-8xxx-8xxx-xxxxxxxxxxxx";
    int used = 0;
    for (char& letter : text)
    {
      if (letter == 'x')
      {
        std::uint64_t& state = states[used++ / 16];
        letter = "0123456789abcdef"[state & 15u];
        state >>= 4;
      }
    }
    return text;
  }

private:
  static std::uint64_t Mix(std::uint64_t word)
  {
    word = (word ^ (word >> 32)) * 0xd6e8feb86659fd93u;
    return word ^ (word >> 29);
  }
  void AddStride(const char* bytes)
  {
    std::uint64_t words[4];
    std::memcpy(words, bytes, sizeof(words));
    for (int lane = 0; lane < 4; ++lane)
    {
      const std::uint64_t state = (this->Lanes[lane] ^ words[lane]) * 0x9e3779b97f4a7c15u;
      this->Lanes[lane] = state ^ (state >> 29);
    }
  }
  std::uint64_t Lanes[4] = { 0x243f6a8885a308d3u, 0x13198a2e03707344u, 0xa4093822299f31d0u, 0x082efa98ec4e6c89u };
};

/**
 * OpenVDB gives each file a random identifier. This puts one in its place that follows from the other bytes, so that
 * the same volumes make the same file.
 */
void GiveIdentifier(const std::string& path)
{
  constexpr std::size_t place = 8 + 4 + 4 + 4 + 1; // behind the magic number, three versions and a flag
  constexpr std::size_t length = 36;
  std::fstream file(path, std::ios_base::in | std::ios_base::out | std::ios_base::binary);
  file.exceptions(std::ios_base::badbit);
  std::vector<char> bytes(std::size_t{ 1 } << 20);
  Digest digest;
  for (bool head = true; file.read(bytes.data(), bytes.size()), file.gcount() > 0; head = false)
  {
    if (head)
    {
      char* text = bytes.data() + place;
      if (file.gcount() < static_cast<std::streamsize>(place + length) || text[8] != '-' || text[23] != '-')
      {
        return; // another kind of header
      }
      std::fill(text, text + length, '0');
    }
    digest.Add(bytes.data(), static_cast<std::size_t>(file.gcount()));
  }
  file.clear();
  file.exceptions(std::ios_base::badbit | std::ios_base::failbit);
  file.seekp(place);
  file << digest.Identifier();
  file.close();
}

/// The share of the time that goes into making grids; the rest is writing.
constexpr double MakingShare = 0.3;

openvdb::GridCPtrVec MakeGrids(const std::vector<Volume>& volumes, const VolumeFileOptions& options,
  const ParallelFor& parallelFor, const VolumeProgress& progress)
{
  openvdb::GridCPtrVec grids;
  for (const Volume& volume : volumes)
  {
    if (!progress(MakingShare * static_cast<double>(grids.size()) / static_cast<double>(volumes.size())))
    {
      throw WriteStopped();
    }
    grids.push_back(GridOf(volume, options, parallelFor));
  }
  return grids;
}

/// Tells the progress of the writing, as far as it can be known before compression, in 20 steps.
std::function<void(std::size_t)> WriteWatch(
  const openvdb::GridCPtrVec& grids, const VolumeFileOptions& options, const VolumeProgress& progress)
{
  double bytes = 1.0;
  for (const auto& grid : grids)
  {
    const double components = grid->isType<openvdb::Vec3SGrid>() ? 3.0 : 1.0;
    bytes += (options.Half ? 2.0 : 4.0) * components * static_cast<double>(grid->activeVoxelCount());
  }
  return [=, next = 0.0](std::size_t written) mutable {
    const double share = std::min(1.0, static_cast<double>(written) / bytes);
    if (share >= next)
    {
      next = share + 0.05;
      if (!progress(MakingShare + (1.0 - MakingShare) * share))
      {
        throw WriteStopped();
      }
    }
  };
}

}

FileOutcome WriteVolumes(const std::string& path, const std::vector<Volume>& volumes, const VolumeRemarks& remarks,
  const VolumeFileOptions& options, const ParallelFor& parallelFor, const VolumeProgress& progress)
{
  openvdb::initialize();
  return WriteFile(path, [&](ReplacedFile& file) {
    const openvdb::GridCPtrVec grids = MakeGrids(volumes, options, parallelFor, progress);
    openvdb::MetaMap fileRemarks;
    AddRemarks(remarks, fileRemarks);
    file.OnWrite(WriteWatch(grids, options, progress));
    VolumeArchive(options.Compression).WriteTo(file.Stream(), grids, fileRemarks);
    if (!file.Close())
    {
      return false;
    }
    GiveIdentifier(file.Path());
    return file.Commit();
  });
}

}
