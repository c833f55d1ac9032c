# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=looks
"""TestFirstLooks.py for other grounds and seas, arrows, points, fog and images."""

import os

import numpy as np
import quick
from first_looks import SIZE, check
from paraview import simple
from window import small_view


def check_grounds():
    """Terrains and seas of several kinds, from the side and with the colors of the ground and of water."""
    terrain = simple.TurningBandsTerrain(WholeExtent=[0, 128, 0, 128, 0, 0])
    check("Terrain Level Of Detail", simple.TerrainLevelOfDetail(Input=terrain), "Full Surface", "RGB", "land", 0.12)
    levels = simple.TerrainLevelOfDetail(Input=terrain, UseCulling=0, GroundColors=0)
    levels.UpdatePipeline()
    assert levels.PointData.GetArray("RGB") is None, "colors that are not wanted"
    fits = simple.CovarianceFit(Input=simple.TurningBandsTerrain(WholeExtent=[0, 40, 0, 40, 0, 0]))
    check("From Fits", simple.TurningBandsTerrainFromFits(Input=fits, WholeExtent=[0, 64, 0, 64, 0, 0]), "Relief",
          "RGB", "land", 0.10)
    check("Sea Surface", simple.SeaSurface(Input=simple.SeaState(), Sectors=90), "Full Surface", "RGB", "sea", 0.4)


def check_arrows_and_points():
    check("Image Sections", simple.ImageSections(Input=simple.WindField(Dimensions=[60, 24, 12])), "Surface", "Velocity",
          "land", 0.05)
    arrows = check("Flow Primitive Uniform", simple.FlowPrimitive(FlowType="Uniform"), "Flow Arrows", "RGB", "water", 0.02)
    assert arrows.mean(axis=0)[0] > 100, "arrows are not bright"
    file = os.path.join(os.environ["LITTORAL_SOURCE_DIR"], "Testing", "Fuzz", "current.nc")

    def has_dry_land(shown):
        red, green, blue = shown.LookupTable.NanColor
        assert red > green > blue > 0.3, "land is no earth"

    check("Ocean Current File", simple.OceanCurrentFile(FileName=file), "Surface", "Velocity", "land", 0.05, spread=5.0,
          display=has_dry_land)
    check("Quadrat Points", simple.QuadratPoints(), "Points", None, "paper", 0.005, spread=0.0,
          seen_from="above")


def check_fog():
    """Fog absorbs as 1 - exp(-F s U) over the unit distance U, for one factor F."""
    fog = simple.ParticleFog(Input=simple.SuspendedParticles(Density=0.3), Dimensions=[24, 24, 24])

    def absorbs(shown):
        points = np.array(shown.ScalarOpacityFunction.Points).reshape(-1, 4)
        depth = -np.log1p(-points[1:, 1]) / (points[1:, 0] * shown.ScalarOpacityUnitDistance)
        assert np.allclose(depth, depth[0], rtol=1e-9) and depth[0] >= 1.0, depth
        assert np.isclose(points[-1, 0], fog.PointData["Extinction"].GetRange()[1])

    check("Particle Fog", fog, "Volume", "Extinction", "water", 0.10, spread=5.0, display=absorbs)


def check_textures():
    """The images of a plant, its other outputs, are shown as images, without a message."""
    tree = simple.ReevesTree(Preset="Custom", NumberOfLeaves=50, MainBranches=4, Orders=1)
    view = small_view(SIZE)
    for port in (1, 2):
        shown = simple.Show(simple.OutputPort(tree, port), view)
        assert shown.Representation != "Full Surface", port
    simple.Delete(view)


check_grounds()
check_arrows_and_points()
check_fog()
check_textures()
