// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/ScatteredSurfaces.h"

#include "Data/Arrays.h"
#include "Data/Blocks.h"
#include "Data/PlantBlocks.h"
#include "Data/ScatterMerge.h"
#include "Pipeline/Memory.h"
#include "Pipeline/Ranges.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"

namespace littoral
{

namespace
{

/// Puts a block of a part in place of another one.
void Replace(int part, vtkPolyData* block, vtkMultiBlockDataSet* plants)
{
  const PartKind& kind = PartKinds[part];
  vtkNew<vtkMultiBlockDataSet> level;
  level->ShallowCopy(FindBlock(plants, kind.Level));
  ReplaceBlock(level, kind.Name, block);
  ReplaceBlock(plants, kind.Level, level);
}

}

void ScatteredSurfaces::Make(
  vtkMultiBlockDataSet* plants, const PlantTable& table, const ScatterPrototypes& species, const ParallelFor& parallel)
{
  std::vector<ShownPlant> shown;
  MergedBlocks others; // what plants are passed with
  for (std::size_t row = 0; row < table.Places.size(); ++row)
  {
    shown.push_back({ static_cast<int>(row), table.Levels[row] });
    others.Shown[static_cast<int>(table.Levels[row])].push_back(static_cast<int>(row));
  }
  others.Parts[SkeletonPart] = others.Parts[LowPart] = vtkSmartPointer<vtkPolyData>::New();
  ScatterMerge merge(species, table.Places, shown, nullptr, true, others);
  RequireMemory(merge.GetBytes(), "The surfaces of the plants", "take fewer plants in full");
  parallel(merge.Begin(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t job = begin; job < end; ++job)
    {
      merge.Do(job);
    }
  });
  const MergedBlocks made = merge.TakeBlocks();
  this->Plants = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  this->Plants->ShallowCopy(plants);
  for (int part = 0; part < NumberOfParts; ++part)
  {
    if (IsSurface(part))
    {
      Replace(part, made.Parts[part], this->Plants);
      this->AtRest[part] =
        StandAtRest(species.Parts[part], table.Places, made.Shown[static_cast<int>(LevelOfPart[part])]);
    }
  }
}

vtkSmartPointer<vtkPolyData> ScatteredSurfaces::Bare(int part)
{
  auto bare = vtkSmartPointer<vtkPolyData>::New();
  bare->ShallowCopy(PlantPartOf(this->Plants, PartKinds[part].Level, PartKinds[part].Name));
  bare->SetPoints(nullptr);
  bare->GetPointData()->RemoveArray(NormalsName);
  KeepRanges(bare);
  Replace(part, bare, this->Plants);
  return bare;
}

}
