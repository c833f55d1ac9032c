# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Drainage by tiles of ground that is made by extents, asked for in rows of tiles: processor time, the most memory, and
whether the areas at the outlets sum to the grid's.

    build/bin/littoral-env python3 Testing/Benchmarks/drainage_tiles.py WIDTH [TILE]

With a TILE of 0 the ground drains as a whole.
"""

import resource
import sys

from vtkmodules.util.numpy_support import vtk_to_numpy

from littoral import vtkDrainageFilter, vtkTurningBandsTerrainSource


def terrain_of(width):
    """Hills of 1.4 km on cells of 80 m. Few lines, as the cost of the ground is not that of draining it."""
    terrain = vtkTurningBandsTerrainSource()
    terrain.SetWholeExtent(0, width - 1, 0, width - 1, 0, 0)
    terrain.SetSpacing(80.0, 80.0, 1.0)
    terrain.SetModelToBessel1()
    terrain.SetRange(1400.0)
    terrain.SetNumberOfLines(32)
    return terrain


def main(width, tile):
    drainage = vtkDrainageFilter()
    terrain = terrain_of(width)
    terrain.UpdateExtent((0, 63, 0, 63, 0, 0))
    drainage.SetInputConnection(terrain.GetOutputPort())
    drainage.CarveOff()
    drainage.SetTileSize(tile)
    leaving = sunk = 0
    for row in range(0, width, tile or width):
        drainage.UpdateExtent((0, width - 1, row, min(row + (tile or width), width) - 1, 0, 0))
        points = drainage.GetOutput().GetPointData()
        areas, ways, depths = (vtk_to_numpy(points.GetArray(name))
                               for name in ("DrainageArea", "FlowDirection", "DepressionDepth"))
        leaving += round(areas[ways < 0].sum() / 6400.0)
        sunk += int((depths > 0.0).sum())
    used = resource.getrusage(resource.RUSAGE_SELF)
    print(f"{width}^2 cells, tiles of {tile}: {used.ru_utime:.1f} s user, {used.ru_stime:.1f} s system, "
          f"{used.ru_maxrss / 1024.0 ** 2:.2f} GiB; {sunk / width ** 2:.4f} in depressions; "
          f"{'all' if leaving == width ** 2 else 'NOT ALL'} water leaves")
    return 0 if leaving == width ** 2 else 1


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 1024))
