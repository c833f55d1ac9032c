// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralRigidSkinning_h
#define LittoralRigidSkinning_h

#include "Numerics/VectorRange.h"
#include "Plants/Skinning.h"

#include <cstddef>
#include <vector>

namespace littoral
{

/// The joint that each vertex of a skin follows most, in runs: longer ones than those of a SkinBinding, since weights
/// change within a segment and the largest one's joint does not.
class RigidBinding
{
public:
  /// The vertices up to End that no earlier run has.
  struct Run
  {
    std::size_t End = 0;
    int Joint = 0;
  };

  /// Joints of the vertices, or, where `carriers` has one for each joint, the carriers of these: runs are longer still.
  explicit RigidBinding(const SkinBinding& binding, const std::vector<int>& carriers = {});

  /// The run of a vertex.
  const Run* RunOf(std::size_t vertex) const;

  /// The index of a run.
  std::size_t IndexOf(const Run* run) const { return static_cast<std::size_t>(run - this->Runs.data()); }
  const Run* RunAt(std::size_t index) const { return this->Runs.data() + index; }

private:
  std::vector<Run> Runs;
};

/// Ranges of the vertices of a skin.
struct SkinRanges
{
  VectorRangeSum Points;
  VectorRangeSum Normals;
};

/// Moves the vertices [begin, end) of a skin, of which the first is in a run, each with one joint alone, as MoveSkin
/// does with a rigidity of 1 but for the rounding, at a third of its cost. Normals keep their lengths to some 1e-7.
/// Adds points and normals to their ranges while it has them.
void MoveRigidly(const RestSkin& rest, const RigidBinding::Run* run, const JointChange* joints, std::size_t begin,
  std::size_t end, float* points, float* normals, SkinRanges& ranges);

}

#endif
