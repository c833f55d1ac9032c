// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportSwayForest_h
#define LittoralSupportSwayForest_h

// Plants in the wind between blocks and the numerics. Private: never installed, never wrapped.

#include "Data/SwayPrototype.h"
#include "Geometry/TextureAtlas.h"
#include "Sway/PlantMotion.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkAlgorithm;

namespace littoral
{

/// The plants of a forest, or one, with all that does not change from frame to frame.
class SwayForest
{
public:
  /// The reason why it cannot be read, or nothing. `prototypes` are those of a scattered forest, or none. An abort
  /// leaves a forest that is not whole.
  std::string Read(vtkMultiBlockDataSet* plants, const std::vector<vtkMultiBlockDataSet*>& prototypes,
    vtkImageData* wind, const SwaySettings& settings, vtkAlgorithm* progress);

  /// False where an abort came before it was all read.
  bool IsWhole() const { return this->Whole; }

  /// The plants at a time [s]; `output` is a shallow copy of the plants. An abort leaves it unchanged.
  void Move(double time, vtkMultiBlockDataSet* plants, vtkMultiBlockDataSet* output, vtkAlgorithm* progress);

  /// The frequency of the trunk's first mode [Hz] of each plant that sways, by its row; 0 for those that do not.
  const std::vector<double>& GetFrequencies() const { return this->Frequencies; }

  /// Pictures of the crowns, all of a species one above the other, then the next species.
  vtkImageData* GetPictures() const { return this->PictureImage; }

private:
  /// A plant at full detail, or the trunk of one at less.
  struct One
  {
    std::size_t FirstJoint = 0;
    int Branches = 0;
    std::unique_ptr<PlantMotion> Motion;
    std::unique_ptr<PlantSway> Sway;
  };
  /// A leaf of a plant in full.
  struct Leaf
  {
    std::array<int, 4> Corners{};
    int Plant = 0; ///< index of One
    std::uint64_t Identity = 0;
  };
  /// A block that follows joints.
  struct Skin
  {
    const char* Level;
    const char* Name;
    vtkPolyData* Rest = nullptr;
    std::vector<int> Joints; ///< where the block does not say them
    std::vector<float> Weights;
  };
  /// The vertices of a plant in the crowns of Medium.
  struct CrownRun
  {
    std::size_t First = 0;
    int Species = 0;
    double Arrival = 0.0; ///< of the wind at its foot [s]
  };

  bool Whole = false;
  std::shared_ptr<WindImage> Wind;
  SwaySettings Settings;
  PlantTable Table;
  bool Scattered = false;
  std::vector<SwayPrototype> Species;
  Skeleton Rest; // of all plants in full, then of the trunks
  std::vector<double> Frequencies;
  std::vector<One> Plants;
  std::vector<Leaf> Leaves;
  std::vector<Skin> Skins;
  std::vector<CrownRun> Crowns;
  TextureAtlas Atlas;
  vtkSmartPointer<vtkImageData> PictureImage;
  vtkSmartPointer<vtkPolyData> PictureFields; // the same as field data
  std::vector<JointPose> Poses;
  std::vector<JointChange> Changes;
  std::vector<Vector3> Winds; // at each plant

  std::string ReadSpecies(
    vtkMultiBlockDataSet* plants, const std::vector<vtkMultiBlockDataSet*>& prototypes, vtkAlgorithm* progress);
  std::string ReadHigh(vtkMultiBlockDataSet* plants, vtkAlgorithm* progress);
  std::string CutIntoPlants(vtkPolyData* bones, std::vector<Skeleton>& skeletons, std::vector<int>& rows) const;
  std::string ReadHighSkins(vtkMultiBlockDataSet* plants, std::vector<double>& leafAreas);
  std::string ReadMedium(vtkMultiBlockDataSet* plants);
  std::string ReadMediumSkin(vtkPolyData* block, const char* name, std::vector<int>& trunkOfRow);
  std::string AddTrunk(int row, std::vector<int>& trunkOfRow);
  std::string AddPlant(int row, const Skeleton& rest, const std::vector<BranchBeam>& beams, const SwayOptions& options);
  std::string WhyTooLarge(double bytes) const;
  WindAtPlace WindOver(double ground) const;
  const SwayPrototype* SpeciesOf(int row) const;
  void Pose(double time);
  void MoveSkinOf(const Skin& skin, double time, vtkPolyData* moved);
  void TurnLeaves(double time, float* points, float* normals) const;
  void ShowPictures(double time, vtkPolyData* crowns) const;
};

}

#endif
