# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Drainage by tiles of ground that is made by extents, asked for in rows of tiles: processor time, the most memory, and
whether the areas at the outlets sum to the grid's.

    build/bin/littoral-env python3 Testing/Benchmarks/drainage_tiles.py WIDTH [TILE [FILE.tif]]

With a TILE of 0 the ground drains as a whole. With a FILE its areas are written in place of that sum.
"""

import resource
import sys

from vtkmodules.util.numpy_support import vtk_to_numpy

from littoral import vtkDrainageFilter, vtkElevationWriter, vtkTurningBandsTerrainSource


def terrain_of(width):
    """Hills of 1.4 km on cells of 80 m. Few lines, as the cost of the ground is not that of draining it."""
    terrain = vtkTurningBandsTerrainSource()
    terrain.SetWholeExtent(0, width - 1, 0, width - 1, 0, 0)
    terrain.SetSpacing(80.0, 80.0, 1.0)
    terrain.SetModelToBessel1()
    terrain.SetRange(1400.0)
    terrain.SetNumberOfLines(32)
    return terrain


def leaving(drainage, width, tile):
    """Number of cells whose water leaves, and words on the depressions."""
    cells = sunk = 0
    for row in range(0, width, tile or width):
        drainage.UpdateExtent((0, width - 1, row, min(row + (tile or width), width) - 1, 0, 0))
        points = drainage.GetOutput().GetPointData()
        areas, ways, depths = (vtk_to_numpy(points.GetArray(name))
                               for name in ("DrainageArea", "FlowDirection", "DepressionDepth"))
        cells += round(areas[ways < 0].sum() / 6400.0)
        sunk += int((depths > 0.0).sum())
    return cells, f"{sunk / width ** 2:.4f} in depressions; {'all' if cells == width ** 2 else 'NOT ALL'} water leaves"


def write(drainage, name):
    """Whether the areas are written, in place of a number of cells, and words on the file."""
    writer = vtkElevationWriter()
    writer.SetInputConnection(drainage.GetOutputPort())
    writer.SetInputArrayToProcess(0, 0, 0, 0, "DrainageArea")
    writer.SetFileName(name)
    is_written = writer.Write()
    return is_written, f"written to {name}" if is_written else "NOT written"


def main(width, tile, name):
    drainage = vtkDrainageFilter()
    terrain = terrain_of(width)
    terrain.UpdateExtent((0, 63, 0, 63, 0, 0))
    drainage.SetInputConnection(terrain.GetOutputPort())
    drainage.CarveOff()
    drainage.SetTileSize(tile)
    good, words = write(drainage, name) if name else leaving(drainage, width, tile)
    used = resource.getrusage(resource.RUSAGE_SELF)
    print(f"{width}^2 cells, tiles of {tile}: {used.ru_utime:.1f} s user, {used.ru_stime:.1f} s system, "
          f"{used.ru_maxrss / 1024.0 ** 2:.2f} GiB; {words}")
    return 0 if good == (1 if name else width ** 2) else 1


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 1024,
                  sys.argv[3] if len(sys.argv) > 3 else ""))
