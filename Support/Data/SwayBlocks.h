// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportSwayBlocks_h
#define LittoralSupportSwayBlocks_h

// Plants in the wind between blocks and the numerics. Private: never installed, never wrapped.

#include "Data/FrameArrays.h"
#include "Data/PlantBlocks.h"
#include "Data/PlantTable.h"
#include "Data/ScatteredSurfaces.h"
#include "Data/SwayKinds.h"
#include "Sway/SwayScene.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

class vtkAlgorithm;

namespace littoral
{

/// The blocks of a forest, or of one plant, that follow a SwayScene.
class SwayBlocks
{
public:
  /// Reads plants. `prototypes` are those of a scattered forest, or none; `known`, of scattered plants, null or the
  /// kinds that the same prototypes, wind and settings had before. After an abort it is not whole. Throws InvalidInput.
  void Read(vtkMultiBlockDataSet* plants, const std::vector<vtkMultiBlockDataSet*>& prototypes, vtkImageData* wind,
    const SwaySettings& settings, std::shared_ptr<SwayKinds> known, vtkAlgorithm* progress);

  /// The kinds of scattered plants; null for a single plant.
  std::shared_ptr<SwayKinds> GetKinds() const { return this->Scattered ? this->Kinds : nullptr; }

  /// False where an abort came before all was read.
  bool IsWhole() const { return this->Whole; }

  /// Whether a frame may be written over the one before whoever holds it.
  void SetOverwritesFrames(bool overwrites) { this->Arrays.SetOverwrites(overwrites); }

  /// Moves the plants to a time [s]; `output` is a shallow copy of the plants. An abort leaves it unchanged.
  void Move(double time, vtkMultiBlockDataSet* plants, vtkMultiBlockDataSet* output, vtkAlgorithm* progress);

  /// Adds the block of the joints as they are, and what vertices of the level Medium follow.
  void AddJoints(vtkMultiBlockDataSet* output) const;

  /// Frequency of the trunk's first mode [Hz] by row; 0 for plants that stand still.
  const std::vector<double>& GetFrequencies() const { return this->Scene->GetFrequencies(); }

  /// Pictures of the crowns, all of a species one above the other, then the next species.
  vtkImageData* GetPictures() const { return this->Kinds->PictureImage; }

private:
  /// A block that follows joints.
  struct Skin
  {
    const char* Level;
    const char* Name;
    vtkSmartPointer<vtkPolyData> Rest;
    StandBinding Binding;
    StandAtRest AtRest = {}; ///< of a surface that is made of prototypes, whose Rest has no points and normals
  };

  bool Whole = false;
  PlantTable Table;
  bool Scattered = false;
  std::shared_ptr<SwayKinds> Kinds;
  std::unique_ptr<SwayScene> Scene;
  ScatteredSurfaces Surfaces;
  std::vector<Skin> Skins;
  FrameArrays Arrays;

  int RowAt(vtkIntArray* plantIds, vtkIdType point) const;
  void MakeScene(vtkMultiBlockDataSet* plants, const std::vector<vtkMultiBlockDataSet*>& prototypes, vtkImageData* wind,
    const SwaySettings& settings, vtkAlgorithm* progress);
  void RequireKnownSpecies(std::size_t prototypes) const;
  void ReadHigh(
    vtkMultiBlockDataSet* plants, const std::vector<vtkMultiBlockDataSet*>& prototypes, vtkAlgorithm* progress);
  void ReadHighSkins(vtkMultiBlockDataSet* plants, const std::vector<vtkMultiBlockDataSet*>& prototypes,
    const std::vector<Skeleton>& skeletons, std::vector<double>& leafAreas);
  void AddPlants(const std::vector<Skeleton>& skeletons, vtkIntArray* plantIds, const std::vector<double>& leafAreas,
    vtkAlgorithm* progress);
  void ReadMedium(vtkMultiBlockDataSet* plants);
  void ForgetRest();
  void ReadMediumSkin(vtkPolyData* block, const char* name);
  vtkSmartPointer<vtkMultiBlockDataSet> MovedLevel(
    const char* level, vtkMultiBlockDataSet* rest, const std::vector<vtkSmartPointer<vtkPolyData>>& moved);
  vtkSmartPointer<vtkPolyData> MovedBones(vtkPolyData* bones);
  vtkSmartPointer<vtkPolyData> MovedSkin(const Skin& skin);
  std::array<vtkSmartPointer<vtkFloatArray>, 2> ArraysFor(const Skin& skin);
  void MoveVertices(const Skin& skin, std::size_t begin, std::size_t end, float* points, float* normals) const;
  void ShowPictures(vtkPolyData* crowns);
};

}

#endif
