// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportPlantMerge_h
#define LittoralSupportPlantMerge_h

// Many plants in one block. Private: never installed, never wrapped.

#include "Geometry/TextureAtlas.h"
#include "Plants/PlantScatter.h"

#include "vtkDataArray.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <string>
#include <vector>

namespace littoral
{

inline constexpr const char* NormalsName = "Normals";

/// Uses of an array on its way from a prototype to a plant.
enum class ArrayUse
{
  Copy,
  Points,
  Directions,
  Lengths,
  Colors,
  Nodes, ///< indices into the skeleton; negative ones stay
};

/// An array that all prototypes have in a block.
struct PartArray
{
  std::string Name;
  ArrayUse Use = ArrayUse::Copy;
  int Type = 0;
  int Components = 1;
  std::vector<vtkSmartPointer<vtkDataArray>> OfSpecies; ///< null where a species has nothing in this block

  std::size_t TupleBytes() const;
};

/// One block (skin, leaves, ...) of all prototypes, ready to be copied to many plants.
struct PlantPart
{
  struct Mesh
  {
    std::size_t NumberOfPoints = 0;
    std::vector<int> Offsets{ 0 }; ///< one more than there are cells
    std::vector<int> Corners;

    std::size_t NumberOfCells() const { return this->Offsets.size() - 1; }
  };

  bool HasLines = false; ///< cells are lines, else polygons
  std::vector<Mesh> Meshes;
  std::vector<PartArray> PointArrays; ///< the first is the points
  std::vector<PartArray> CellArrays;
};

/// Kind of a block.
struct PartKind
{
  const char* Level; ///< name of the level that it belongs to
  const char* Name;  ///< null: the level is the block
  bool HasLines;     ///< cells are lines, else polygons
  bool IsTinted;     ///< colors vary from plant to plant
};

/// Takes a block from each prototype (null: nothing). With an atlas, texture coordinates are taken to it.
PlantPart MakePart(const PartKind& kind, const std::vector<vtkPolyData*>& blocks, const TextureAtlas* atlas);

/// Merges a block of many plants: sizes first, then memory, then plants in any order on any threads.
class PlantMerge
{
public:
  /// `plants` are indices into the places. Both must outlive this.
  PlantMerge(const PlantPart& part, const std::vector<PlantPlace>& places, const std::vector<int>& plants);

  std::size_t GetNumberOfPlants() const { return this->Plants.size(); }
  std::size_t GetNumberOfPoints() const { return this->First.back().Point; }
  std::size_t GetNumberOfCells() const { return this->First.back().Cell; }
  double GetBytes() const;

  /// The first point of a plant.
  std::size_t GetFirstPoint(std::size_t plant) const { return this->First[plant].Point; }

  /// Node indices are offset to this merged skeleton, which has the same plants; none if there are no nodes.
  void SetSkeleton(const PlantMerge* skeleton) { this->SkeletonMerge = skeleton; }

  void Allocate();
  void Fill(std::size_t beginPlant, std::size_t endPlant);
  vtkPolyData* GetOutput() const { return this->Output; }

private:
  struct Begin
  {
    std::size_t Point = 0;
    std::size_t Cell = 0;
    std::size_t Corner = 0;
  };
  struct Target
  {
    const PartArray* From;
    unsigned char* To;
  };

  bool NeedsLongIds() const;
  vtkSmartPointer<vtkDataArray> Add(const PartArray& array, std::size_t tuples, std::vector<Target>& targets);
  void AllocateCells();
  void FillArrays(const std::vector<Target>& targets, const PlantPlace& place, std::size_t tuple, int node) const;
  template <typename Id>
  void FillCells(std::size_t plant, Id* offsets, Id* corners) const;

  const PlantPart& Part;
  const std::vector<PlantPlace>& Places;
  const std::vector<int>& Plants;
  const PlantMerge* SkeletonMerge = nullptr;
  std::vector<Begin> First; ///< of each plant, and the end
  vtkSmartPointer<vtkPolyData> Output;
  std::vector<Target> PointTargets;
  std::vector<Target> CellTargets;
  int* PlantOfPoint = nullptr;
  int* PlantOfCell = nullptr;
  void* OffsetTarget = nullptr;
  void* CornerTarget = nullptr;
};

}

#endif
