// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralVolume_h
#define LittoralVolume_h

// Volumes between VTK and a file: samples on lattices, with their names and remarks. Private: never installed.

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace littoral
{

/// Sample (i, j, k) is at Origin + i Step[0] + j Step[1] + k Step[2], in world coordinates.
struct VolumeLattice
{
  std::array<double, 3> Origin{ { 0.0, 0.0, 0.0 } };
  std::array<std::array<double, 3>, 3> Step{ { { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } }, { { 0.0, 0.0, 1.0 } } } };

  bool operator==(const VolumeLattice& other) const { return this->Origin == other.Origin && this->Step == other.Step; }
};

/// Transformation of vectors with the space that they live in.
enum class VolumeVectors
{
  Relative, ///< as velocities and displacements do
  Normal,
  Invariant ///< colors, and other triples
};

using VolumeRemark = std::variant<std::string, double, std::array<double, 3>>;
using VolumeRemarks = std::map<std::string, VolumeRemark>;

/// Samples of a box of the lattice, x fastest.
struct VolumeBlock
{
  std::array<int, 6> Extent;              ///< first and last index along x, y, z; both included
  const float* Values = nullptr;          ///< the components of a sample lie side by side
  std::size_t Stride = 1;                 ///< from one sample to the next
  const unsigned char* Ghosts = nullptr;  ///< a byte a sample; null: all samples count
  unsigned char Hidden = 0;               ///< bits of Ghosts that take a sample away
  std::vector<std::shared_ptr<void>> Own; ///< owners of the memory that the pointers lead to
  /// The samples of a box of the block, where Values lie elsewhere. Throws InvalidInput.
  std::function<VolumeBlock(const std::array<int, 6>& box)> Load;

  std::size_t Count(int axis) const
  {
    return static_cast<std::size_t>(this->Extent[2 * axis + 1] - static_cast<long long>(this->Extent[2 * axis]) + 1);
  }
  std::size_t Count() const { return this->Count(0) * this->Count(1) * this->Count(2); }
  /// The place of a sample among those of the block.
  std::size_t Place(int x, int y, int z) const
  {
    return x - this->Extent[0] + this->Count(0) * (y - this->Extent[2] + this->Count(1) * (z - this->Extent[4]));
  }
};

/**
 * The boxes in which a block is loaded, one after the other: of whole leaves of 8 samples a side, along x all of them,
 * and of no more bytes than 16 MiB, or those of a row of leaves.
 */
std::vector<std::array<int, 6>> BoxesToLoad(const VolumeBlock& block, int components);

/// The most bytes of such a box, with marks of ghosts.
double BytesToLoad(const VolumeBlock& block, int components);

/// An array of one block of the input, in one or several boxes.
struct Volume
{
  std::string Place; ///< name of the block; empty for an input without blocks
  std::string Array;
  std::string Name; ///< name in the file, where no other volume has it
  VolumeLattice Lattice;
  int Components = 1; ///< 1 or 3
  VolumeVectors Vectors = VolumeVectors::Relative;
  VolumeRemarks Remarks;
  int Rank = 0; ///< that holds the values, before they are gathered
  std::vector<VolumeBlock> Blocks;
};

}

#endif
