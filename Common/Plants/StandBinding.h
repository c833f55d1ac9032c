// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralStandBinding_h
#define LittoralStandBinding_h

#include "Plants/SkinBinding.h"
#include "Plants/Skinning.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace littoral
{

/// The joints that the skins of plants follow, one plant after the other. Plants of one kind share a binding, whose
/// joints count from the first one of each.
class StandBinding
{
public:
  StandBinding() = default;
  /// A binding of all plants in one.
  explicit StandBinding(SkinBinding all);

  /// Adds a plant with a skin of at least one vertex. Throws InvalidInput if there are too many vertices.
  void Add(std::shared_ptr<const SkinBinding> binding, int firstJoint);

  std::size_t GetNumberOfVertices() const { return this->Plants.empty() ? 0 : this->Plants.back().End; }

  /// The first joint of a vertex.
  int JointOf(std::size_t vertex) const;

  /// MoveSkin of the vertices [begin, end), byte for byte as if the plants had one binding.
  void Move(const RestSkin& rest, const JointChange* joints, std::size_t begin, std::size_t end, float* points,
    float* normals) const;

  /// The arrays of four joints and four weights.
  void Write(int* jointIds, float* jointWeights) const;

private:
  /// The vertices [Begin, End) of all.
  struct Plant
  {
    std::size_t Begin = 0;
    std::size_t End = 0;
    int FirstJoint = 0;
    std::shared_ptr<const SkinBinding> Binding;
  };
  std::vector<Plant> Plants;

  const Plant* PlantOf(std::size_t vertex) const;
};

}

#endif
