// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCoverShapes_h
#define LittoralCoverShapes_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <vector>

namespace littoral
{

/// What covers the ground: blades, rosettes of leaves, heads of flowers, fallen leaves, stones.
enum class CoverKind
{
  Grass,
  Herb,
  Flower,
  Litter,
  Stone
};

/// Elements that are repeated over the plane in square tiles.
struct CoverTile
{
  static constexpr int Cells = 8; ///< along its sides

  CoverKind Kind;
  double Side;  ///< over the radius of the cover, at least twice Reach
  int Count;    ///< of elements, each a strip of five points
  double Width; ///< of a blade or leaf, over its height or length
  double From;  ///< distances between which they are drawn, over the radius of the cover
  double Reach;

  /// Elements of a plant or stone, which share its place.
  int Group() const { return this->Kind == CoverKind::Herb ? 5 : this->Kind == CoverKind::Stone ? 2 : 1; }
  /// Whether sizes are metres; others are parts of the height of the grass.
  bool HasOwnSize() const { return this->Kind == CoverKind::Litter || this->Kind == CoverKind::Stone; }
  /// Whether colors are those of the elements; others are parts of the color of the grass.
  bool HasOwnColor() const { return this->HasOwnSize() || this->Kind == CoverKind::Flower; }
};

/// Cells of a tile, row by row, that are made or are not.
using CoverCells = std::array<bool, CoverTile::Cells * CoverTile::Cells>;

/// The elements of a tile in some cells, cell by cell, with the ends of all cells among them and a 0 before the first;
/// the same in a cell whatever other cells are made. Points are relative to the array Foot, from 0 to 1 in the tile.
/// The first elements alone are cells, as GroundCoverMapper asks.
vtkSmartPointer<vtkPolyData> CoverShapes(const CoverTile& tile, const CoverCells& made, std::vector<int>& ends);

}

#endif
