// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSeaweedSkin_h
#define LittoralSeaweedSkin_h

#include "Seaweed/SeaweedStand.h"

#include <cstddef>
#include <vector>

namespace littoral
{

/// The vertices [First, End) of a skin, all of one plant.
struct SkinRun
{
  std::size_t First = 0;
  std::size_t End = 0;
  std::size_t Plant = 0;
};

/// The vertices of a skin by the plants of a stand, but for those that never move: they follow a holdfast.
class SeaweedSkin
{
public:
  /// `jointIds` has four nodes of the skeleton a vertex; the first one tells the plant.
  SeaweedSkin(const int* jointIds, std::size_t vertices, const SeaweedStand& stand);

  /// The vertices that never move.
  const std::vector<SkinRun>& GetFixedRuns() const { return this->FixedRuns; }

  /// The runs of a plant are those from RunsOf(plant) up to RunsOf(plant + 1).
  const SkinRun* RunsOf(std::size_t plant) const { return this->Runs.data() + this->FirstRun[plant]; }

  /// All of them, and the index of one.
  const std::vector<SkinRun>& GetRuns() const { return this->Runs; }
  std::size_t IndexOf(const SkinRun* run) const { return static_cast<std::size_t>(run - this->Runs.data()); }

private:
  std::vector<SkinRun> FixedRuns;
  std::vector<SkinRun> Runs;         ///< by plants
  std::vector<std::size_t> FirstRun; ///< of a plant, and an end
};

}

#endif
