// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportScatterMerge_h
#define LittoralSupportScatterMerge_h

// The blocks of a scattered forest from those of its prototypes. Private: never installed, never wrapped.

#include "Data/ScatterPrototypes.h"
#include "Plants/PlantLevels.h"

#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace littoral
{

/// Blocks, and the places of the plants in each level. A later merge of the same prototypes and places takes those
/// blocks whose plants are the same ones, so that what depends on them is not made anew where a camera moves.
struct MergedBlocks
{
  std::array<std::vector<int>, 3> Shown;
  std::array<vtkSmartPointer<vtkPolyData>, NumberOfParts> Parts; ///< null: to be made
};

/// All blocks of the shown plants.
class ScatterMerge
{
public:
  /// Merge of the shown plants; with a view, far plants face its eye. The surfaces of nearer ones may be left empty.
  ScatterMerge(const ScatterPrototypes& prototypes, const std::vector<PlantPlace>& places,
    const std::vector<ShownPlant>& shown, const View* facing, bool withSurfaces, const MergedBlocks& last);
  ScatterMerge(const ScatterMerge&) = delete;
  ScatterMerge& operator=(const ScatterMerge&) = delete;

  double GetBytes() const { return this->Bytes; }
  std::size_t GetNumberOfPlants(PlantLevel level) const { return this->Blocks.Shown[static_cast<int>(level)].size(); }
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

  /// Blocks for a later merge: without cards that face the eye of this one.
  MergedBlocks TakeBlocks();

private:
  const ScatterPrototypes& Species;
  const std::vector<PlantPlace>& Places;
  const View* Facing;
  const std::vector<int> None;
  MergedBlocks Blocks;
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

  bool AreCards(int part) const { return part == LowPart && this->Facing; }
  void Make(int part);

  /// Points, normals and texture coordinates of the card of a far plant.
  void PlaceCard(std::size_t plant);
};

}

#endif
