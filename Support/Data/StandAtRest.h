// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportStandAtRest_h
#define LittoralSupportStandAtRest_h

// Surfaces at rest that are not kept. Private: never installed, never wrapped.

#include "Data/PlantMerge.h"
#include "Plants/PlantScatter.h"

#include "vtkFloatArray.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <vector>

namespace littoral
{

/// Points and normals at rest of a part of scattered plants: those of the prototypes, placed whenever they are needed,
/// to the bytes of PlantMerge.
class StandAtRest
{
public:
  StandAtRest() = default;
  /// `plants` are indices into the places, as those of a merge.
  StandAtRest(const PlantPart& part, const std::vector<PlantPlace>& places, const std::vector<int>& plants);

  std::size_t GetNumberOfVertices() const { return this->Plants.empty() ? 0 : this->Plants.back().End; }
  bool HasNormals() const { return !this->Normals.empty(); }

  /// Places the vertices [begin, end), the first of them at the first tuple; without normals `normals` is not used.
  void Place(std::size_t begin, std::size_t end, float* points, float* normals) const;

private:
  /// The vertices [Begin, End) of all.
  struct Plant
  {
    std::size_t Begin;
    std::size_t End;
    PlantPlace Place;
  };
  using OfSpecies = std::vector<vtkSmartPointer<vtkFloatArray>>;
  OfSpecies Points;
  OfSpecies Normals;
  std::vector<Plant> Plants;
};

}

#endif
