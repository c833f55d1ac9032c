// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportTiledTerrain_h
#define LittoralSupportTiledTerrain_h

// Requests of a filter that drains a terrain by tiles. Private: never installed, never wrapped.

#include "Drainage/TiledDrainage.h"
#include "Numerics/Parallel.h"

#include <array>
#include <memory>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkInformation;

namespace littoral
{

/**
 * A terrain that is asked for tile by tile, twice: for the spills of tiles, and for the directions of flow. Then its
 * drainage is known, and any part of it can be made from the heights of that part.
 */
class TiledTerrain
{
public:
  /// Whether it must begin anew, for what it depends on has changed.
  bool BeginsAnew(const std::vector<double>& key);

  /// Begins with the first tile of a whole extent. Throws InvalidInput: too many cells, too little memory.
  void Begin(const std::array<int, 6>& whole, int side, double seaLevel);

  /// Whether there is nothing left to be learned.
  bool IsKnown() const { return this->Stage == Known; }

  /// Part of all tiles that have been asked for, 0 to 1.
  double Share() const;

  /// Extent of the input that is next needed: about a tile, or the tiles about the part that is to be made.
  std::array<int, 6> NextExtent(const std::array<int, 6>& part) const;

  /// Takes the tile that was asked for. Throws InvalidInput if its heights are none.
  void Take(vtkImageData* image, vtkDataArray* heights, const Poll& poll);

  /// Makes the arrays of a part of the terrain, given the heights of NextExtent().
  void Write(vtkImageData* image, vtkDataArray* heights, const std::array<int, 6>& part, vtkImageData* output,
    const Poll& poll) const;

private:
  enum StageType
  {
    Spills,
    Directions,
    Known
  };

  TileGround GroundOf(vtkImageData* image, vtkDataArray* heights, const TileWindow& window) const;
  void TakeRange(const TileGround& ground);
  void FinishStage(const Poll& poll);

  std::vector<double> Key;
  std::array<int, 6> Whole{};
  int Side = 1;
  StageType Stage = Spills;
  int Tile = 0;
  double Lowest = 0.0;
  double Highest = 0.0;
  std::unique_ptr<TiledDrainage> Drainage;
};

}

#endif
