// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPalmFile_h
#define LittoralPalmFile_h

#include "Plants/CanopyCells.h"
#include "ReplacedFile.h"

#include <cstddef>
#include <functional>
#include <string>

namespace littoral
{

/// Place of a forest on the earth, which PALM takes from the attributes of its static driver.
struct PalmPlace
{
  double Latitude = 0.0;  ///< of the lower left corner [degrees]
  double Longitude = 0.0; ///< [degrees]
  std::string Time;       ///< at which the run begins
};

/// Densities of a layer of cells [m2/m3], x first.
using LayerOfCells = std::function<void(int layer, float* densities)>;

/**
 * A static driver of PALM with `lad` and, if there is wood, `bad`, over zlad, y and x, as PALM's input data standard
 * has them. Level 0 is the ground, without leaves; layer k of the grid is level k + 1, whose height is that of its
 * middle over the lowest face of the grid. x and y are distances from the lower left corner, `origin_x`, `origin_y`.
 */
FileOutcome WritePalm(const std::string& path, const CanopyGrid& grid, const PalmPlace& place,
  const LayerOfCells& leaves, const LayerOfCells& wood);

}

#endif
