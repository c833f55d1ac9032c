// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSceneBuffer_h
#define LittoralSceneBuffer_h

#include <tiny_gltf.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace littoral
{

/// Buffer of a glTF model: arrays one after the other, each at a multiple of four bytes. Functions return the index of
/// the accessor, or of the buffer view.
class SceneBuffer
{
public:
  explicit SceneBuffer(tinygltf::Model& model)
    : Model(model)
  {
  }

  /// A file; the index is that of its buffer view.
  int AddBytes(const std::vector<unsigned char>& bytes);

  /// Numbers with so many components a tuple.
  int AddNumbers(const std::vector<float>& numbers, int components);

  /// An attribute of vertices, with its bounds.
  int AddVertices(const std::vector<float>& numbers, int components);

  /// Other numbers with their bounds.
  int AddBounded(const std::vector<float>& numbers, int components);

  /// Colors of vertices with three or four parts from 0 to 1, in units of 1/65535.
  int AddColors(const std::vector<float>& numbers, int components);

  /// Joints of vertices, four each.
  int AddJoints(const std::vector<std::uint16_t>& joints);

  /// Weights of the joints of vertices, four each with the sum 1, in units of 1/65535.
  int AddWeights(const std::vector<float>& weights);

  /// Samples of rotations, whose parts are in units of 1/32767. Those that follow one another share a view, as do
  /// numbers of samples: a scene has very many of them.
  int AddRotations(const std::vector<std::int16_t>& rotations);
  int AddSamples(const std::vector<float>& numbers, int components);

  /// Inverse bind matrices: translations by the negative of places.
  int AddInverses(const std::vector<float>& places);

  /// Indices of so many vertices, in 16 bits where these are enough.
  int AddIndices(const std::vector<std::uint32_t>& indices, std::size_t vertices);

private:
  tinygltf::Model& Model;

  int Shared = -1; // view of samples

  int AddView(const void* from, std::size_t bytes, int target);
  int AddShared(const void* from, std::size_t bytes, int component, int type, std::size_t count);
  void SetBounds(int accessor, const std::vector<float>& numbers, int components);
  int AddAccessor(int view, int component, int type, std::size_t count);
};

}

#endif
