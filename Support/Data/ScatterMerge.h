// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportScatterMerge_h
#define LittoralSupportScatterMerge_h

// The blocks of a scattered forest from those of its prototypes. Private: never installed, never wrapped.

#include "Data/ScatterPrototypes.h"
#include "Plants/PlantLevels.h"

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace littoral
{

/// All blocks of the shown plants.
class ScatterMerge
{
public:
  /// Merge of the shown plants; with a view, far plants face its eye.
  ScatterMerge(const ScatterPrototypes& prototypes, const std::vector<PlantPlace>& places,
    const std::vector<ShownPlant>& shown, const View* facing);
  ScatterMerge(const ScatterMerge&) = delete;
  ScatterMerge& operator=(const ScatterMerge&) = delete;

  double GetBytes() const { return this->Bytes; }
  std::size_t GetNumberOfPlants(PlantLevel level) const { return this->Shown[static_cast<int>(level)].size(); }
  bool HasTooManyNodes() const
  {
    return this->Merges[SkeletonPart].GetNumberOfPoints() > std::numeric_limits<int>::max();
  }
  double GetNumberOfPolygons() const;

  /// Takes memory, and shares the work out in jobs.
  std::size_t Begin();

  /// Does a job, in any order on any threads.
  void Do(std::size_t job);

  /// Adds the blocks to the output.
  void AddTo(vtkMultiBlockDataSet* output) const;

private:
  const ScatterPrototypes& Species;
  const std::vector<PlantPlace>& Places;
  const View* Facing;
  std::array<std::vector<int>, 3> Shown; ///< places, of each level
  std::vector<PlantMerge> Merges;
  /// Some plants of a part.
  struct Job
  {
    int Part;
    std::size_t First;
    std::size_t End;
  };
  std::vector<Job> Jobs;
  double Bytes = 0.0;

  /// Points, normals and texture coordinates of the card of a far plant.
  void PlaceCard(std::size_t plant);
};

}

#endif
