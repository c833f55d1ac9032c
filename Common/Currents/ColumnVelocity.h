// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralColumnVelocity_h
#define LittoralColumnVelocity_h

#include "Currents/FacesToNodes.h"
#include "Currents/VelocityGrid.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace littoral
{

/// Samples of a velocity in layers that lie over each other in upright columns, as those of ocean models. Safe to call
/// from many threads.
class ColumnSamples
{
public:
  virtual ~ColumnSamples() = default;

  virtual std::size_t Columns() const = 0;
  virtual int Layers() const = 0;

  /// Height of a sample [m]; it rises, or falls, from layer to layer in all columns.
  virtual double Height(std::size_t column, int layer) const = 0;

  /// Velocity of a sample [m/s]; not asked for on land.
  virtual Vector3 Sample(std::size_t column, int layer) const = 0;
  virtual bool IsWater(std::size_t column, int layer) const = 0;
};

/// Effect of land on a current beside it.
enum class CoastBehaviour
{
  Stop,  ///< the velocity falls to 0 towards samples on land
  Slide, ///< only its part towards the land does
};

/**
 * A velocity field on columns over triangles and quadrilaterals in plan view: bilinear between the columns of a cell,
 * linear between layers, whose heights are bilinear too. One layer holds for all heights. Above the highest and below
 * the lowest sample of a place its velocity goes on for the height of a layer, for the samples of models are in the
 * middles of their layers.
 */
class ColumnVelocity : public VelocityGrid
{
public:
  /// Columns at places [m] that are the corners of cells.
  ColumnVelocity(std::shared_ptr<const ColumnSamples> samples, std::vector<std::array<double, 2>> places,
    std::vector<FaceCorners> cells, CoastBehaviour coast);

  /// Memory that it takes, beside the samples [bytes].
  static double BytesOf(std::size_t columns, std::size_t cells);

  GridHeights Heights() const override { return this->Range; }
  bool IsLevelAt(double height) const override;
  Vector3 Velocity(const Vector3& position) const override;

private:
  struct CellPlace;
  bool FindCell(double x, double y, CellPlace& place) const;
  bool IsWithin(int cell, double x, double y, CellPlace& place) const;
  Vector3 Layer(const CellPlace& place, int layer) const;
  void FindRange();
  void FillBins();

  std::shared_ptr<const ColumnSamples> Samples;
  std::vector<std::array<double, 2>> Places;
  std::vector<FaceCorners> Cells;
  CoastBehaviour Coast;
  GridHeights Range;
  bool IsLevel = true;

  // bins of equal size in plan view, each with the cells whose boxes touch it
  std::array<double, 2> Low{ 0.0, 0.0 };
  std::array<double, 2> BinsPerMetre{ 0.0, 0.0 };
  std::array<int, 2> Bins{ 1, 1 };
  std::vector<int> FirstOfBin;
  std::vector<int> CellsOfBins;
};

}

#endif
