// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralForestFiles_h
#define LittoralForestFiles_h

#include "Plants/CanopyCells.h"

#include <cstddef>
#include <functional>
#include <string>

namespace littoral
{

// Files of codes that take a forest as a porous medium or as fuel. Numbers are in little-endian order on any machine;
// a record is one of Fortran's sequential files without format: its bytes between two int32 of their number.

/// A density in each cell, as text or bytes that are made bit by bit.
using DensityOfCell = std::function<double(std::size_t cell)>;
using TakeBytes = std::function<void(const std::string& bytes)>;

/**
 * FDS, BULK_DENSITY_FILE (`.bdf`): records of the bounds (6 doubles: x, x, y, y, z, z), of the sides of a cell (3
 * doubles) and of the number of cells that have a density (int32), and for each of those the record of its middle (3
 * doubles) and that of its bulk density [kg/m3] (1 double); cells in the order of the grid, x first.
 */
void WriteFdsDensity(const CanopyGrid& grid, const DensityOfCell& density, const TakeBytes& take);

/// QUIC-Fire (`.dat`): one record of float32, x first, y, z from the ground up.
void WriteQuicFireDensity(const CanopyGrid& grid, const DensityOfCell& density, const TakeBytes& take);

/// Why a format cannot hold a grid, with so many cells that have a density; empty if it can.
std::string WhyNoFds(std::size_t cells);
std::string WhyNoQuicFire(const CanopyGrid& grid);

/// A tree as a row of forest.amrwind: an upright cylinder.
struct ForestRow
{
  double X;             ///< [m]
  double Y;             ///< [m]
  double Height;        ///< [m]
  double Diameter;      ///< [m]
  double LeafAreaIndex; ///< leaf area over the area of the cylinder
  double MaximumHeight; ///< z_m / h
};

/// The row: type 2, the profile of Lalic and Mihailovic; x, y, height, diameter, drag coefficient, leaf area index and
/// z_m / h, as short as they read back the same.
std::string TextOfRow(const ForestRow& row, double dragCoefficient);

}

#endif
