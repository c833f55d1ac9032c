// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportSwayPrototype_h
#define LittoralSupportSwayPrototype_h

// What the lower levels of a swaying plant take from its prototype. Private: never installed, never wrapped.

#include "Data/PlantReading.h"
#include "Data/WindImage.h"
#include "Sway/LeafMotion.h"

#include <string>
#include <vector>

namespace littoral
{

/// How plants sway.
struct SwaySettings
{
  SwayOptions Options;        ///< the wood is that of plants which do not say theirs
  bool WoodFromPlants = true; ///< whether plants may say theirs
  LeafMotionOptions Leaves;
  int Pictures = 8; ///< of a crown, 1 for one at rest
  std::array<int, 2> PictureSize{ 256, 128 };

  /// The options for a plant of a wood.
  SwayOptions With(const WoodParameters& wood) const;
};

/// A plant at full detail, by itself.
struct SwayPrototype
{
  Skeleton Rest; ///< without nodes, the plant stands still
  WoodParameters Wood;
  TrunkMeasures Trunk;
  Skeleton TrunkRest;
  double SwingFrequency = 0.0;                     ///< of the trunk's first mode [Hz]
  std::vector<std::array<double, 2>> CrownTCoords; ///< of the Medium crown in its own picture

  /// The reason why it cannot be read, or nothing.
  std::string Read(vtkMultiBlockDataSet* plant, const SwaySettings& settings);

  /// Pictures of the crown, as an eye sees it that circles around and sways along with the trunk, at equal times of a
  /// swing.
  std::vector<TextureImage> Pictures(const WindImage& wind, const SwaySettings& settings) const;

private:
  std::vector<double> LeafAreas; // by node
  vtkSmartPointer<vtkPolyData> Leaves;
  std::vector<LeafCorners> Corners;
  CrownVolume Crown;
  vtkSmartPointer<vtkPolyData> Envelope; // null where there is none

  void ReadCrown(vtkPolyData* crown);
  TextureImage StillPicture(const SwaySettings& settings) const;
  std::vector<float> LeavesAt(double time, PlantSway& sway, const SwaySettings& settings) const;
};

}

#endif
