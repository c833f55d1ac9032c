# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Leaves of stands in cells: totals of leaves measured here, the three forms of a stand, parts, tables, bad stands."""
import functools
import math
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData

from littoral import errors, stand, vtkForestDensityFilter, vtkPlantScatterFilter, vtkReevesTreeSource
from littoral.plants import block

OAK, PINE, BIRCH = 0, 1, 3
BOX = (-12.0, 28.0, -12.0, 28.0, -1.0, 23.0)


@functools.lru_cache(maxsize=None)
def tree(preset, leaves=0):
    plant = vtkReevesTreeSource()
    plant.SetPreset(preset)
    if leaves:
        plant.SetNumberOfLeaves(leaves)
    return plant


def points(places, **arrays):
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(np.array(places, dtype=float), deep=True))
    for name, values in arrays.items():
        array = numpy_to_vtk(np.array(values), deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    return data


def density(data, bounds=BOX, cell=2.0, **settings):
    one = vtkForestDensityFilter()
    one.SetInputDataObject(0, data)
    one.SetBounds(bounds)
    one.SetCellSize(cell, cell, cell)
    for name, value in settings.items():
        getattr(one, "Set" + name)(value)
    one.Update()
    return one


def cells(one, name="LeafAreaDensity"):
    return vtk_to_numpy(one.GetOutput().GetCellData().GetArray(name)).astype(float)


def field(one, name):
    return one.GetOutput().GetFieldData().GetArray(name).GetValue(0)


def column(table, name):
    return vtk_to_numpy(table.GetColumnByName(name))


def area_of(data, part):
    """Area of the polygons of a block, by cross products of their diagonals or edges."""
    mesh = block(data, "High", part)
    where = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    corners = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray())
    offsets = vtk_to_numpy(mesh.GetPolys().GetOffsetsArray())
    total = 0.0
    for size in set(np.diff(offsets)):
        these = corners[offsets[:-1][np.diff(offsets) == size][:, None] + np.arange(size)]
        p = where[these]
        total += sum(0.5 * np.linalg.norm(np.cross(p[:, k - 1] - p[:, 0], p[:, k] - p[:, 0]), axis=1).sum()
                     for k in range(2, size))
    return total


def opaque_part(data):
    """Part of the kite that the picture of its leaves covers, by texels."""
    fields = block(data, "High", "Leaves").GetFieldData()
    columns, rows = vtk_to_numpy(fields.GetArray("TextureSize"))
    alpha = vtk_to_numpy(fields.GetArray("Texture"))[:, 3].reshape(rows, columns)
    across = np.abs(2.0 * (np.arange(columns) + 0.5) / columns - 1.0)[None]
    along = ((np.arange(rows) + 0.5) / rows)[:, None]
    kite = across < np.where(along < 0.42, along / 0.42, (1.0 - along) / 0.58)
    return (alpha[kite] > 127).mean()


@functools.lru_cache(maxsize=None)
def scattered(form, levels=False):
    sites = points([[0, 0, 0], [9, 4, 1], [12, 15, 0.5], [3, 14, 0]], Species=np.array([0, 1, 0, 1]),
                   Height=[11.0, 15.0, 9.0, 12.0], DBH=[0.4, 0.3, 0.5, 0.2])
    plants = [tree(OAK, 300), tree(PINE, 300)]
    forest = vtkPlantScatterFilter()
    forest.SetInputDataObject(0, sites)
    for plant in plants:
        forest.AddPrototypeConnection(plant.GetOutputPort())
    forest.SetUseLevels(levels)
    forest.SetUseCulling(False)
    forest.SetOutputForm(form)
    forest.Update()
    return forest.GetOutput()


class TestForestDensity(unittest.TestCase):
    def test_leaves_of_a_tree(self):
        """Densities times volumes are the leaves drawn, in cells of any size; plausible per area of crown."""
        # LAI of closed stands: oak 3 to 6, Scots pine 2 to 4, birch 2 to 5 (see the guide)
        near = (-4.0, 4.0, -4.0, 4.0, -1.0, 15.0)
        for preset, index, low, high in ((OAK, 2.7, 2.0, 6.0), (PINE, 3.4, 2.0, 4.5), (BIRCH, 4.1, 2.0, 5.0)):
            plant = tree(preset)
            plant.Update()
            data = plant.GetOutput()
            leaves, wood = area_of(data, "Leaves"), 0.5 * area_of(data, "Skin")
            for cell in (0.25, 4.0) if preset == BIRCH else (1.0,):
                one = density(data, cell=cell, bounds=near if preset == BIRCH else BOX)
                self.assertAlmostEqual(cells(one).sum() * cell**3 / field(one, "LeafArea"), 1.0, delta=1e-6)
                self.assertAlmostEqual(field(one, "LeafArea") / (leaves * opaque_part(data)), 1.0, delta=0.005)
                plant_area = cells(one, "PlantAreaDensity").sum() * cell**3
                self.assertAlmostEqual((plant_area - field(one, "LeafArea")) / wood, 1.0, delta=1e-5)
            crown = one.GetOutputDataObject(3).GetPointData()
            self.assertAlmostEqual(crown.GetArray("LeafAreaIndex").GetValue(0), index, delta=0.06)
            self.assertTrue(low < index < high)

    def test_forms_of_a_stand(self):
        """Merged plants and instances have the same leaves; parcels the same totals; species add up."""
        merged = density(scattered(0), BySpecies=True, SpeciesNames="Oak; Scots pine")
        leaves = density(scattered(1), Detail=1, BySpecies=True, SpeciesNames="Oak; Scots pine")
        parcels = density(scattered(1), Detail=2, SpeciesNames="Oak; Scots pine")
        for name in ("LeafAreaDensity", "PlantAreaDensity", "BulkDensity", "LeafAreaDensity Oak"):
            self.assertLess(np.abs(cells(merged, name) - cells(leaves, name)).max(), 1e-4 * cells(merged, name).max())
        self.assertAlmostEqual(field(merged, "LeafArea") / field(leaves, "LeafArea"), 1.0, delta=1e-6)
        self.assertAlmostEqual(field(parcels, "LeafArea") / field(leaves, "LeafArea"), 1.0, delta=1e-6)
        error = np.sqrt(((cells(parcels) - cells(leaves))**2).mean() / (cells(leaves)**2).mean())
        self.assertLess(error, 0.15)
        oak, pine = (cells(leaves, "LeafAreaDensity " + name) for name in ("Oak", "Scots pine"))
        np.testing.assert_allclose(oak + pine, cells(leaves), atol=1e-6)
        np.testing.assert_allclose(cells(leaves, "BulkDensity"), 0.080 * oak + pine / 6.2, atol=1e-6)
        # a species that is not listed counts as the mean of hardwoods
        other = density(scattered(1), SpeciesNames="Pinus sylvestris; Ginkgo biloba", Detail=2)
        masses = other.GetOutput().GetFieldData().GetArray("LeafMassPerArea")
        self.assertEqual([round(masses.GetValue(k), 4) for k in (0, 1)], [0.1613, 0.0686])
        heights = vtk_to_numpy(leaves.GetOutputDataObject(3).GetPointData().GetArray("Height"))
        np.testing.assert_allclose(heights, [11.0, 15.0, 9.0, 12.0], rtol=1e-4)
        np.testing.assert_allclose(heights, vtk_to_numpy(merged.GetOutputDataObject(3).GetPointData().GetArray("Height")),
                                   rtol=1e-4)

    def test_parts_and_grid(self):
        """A part of the image has the bytes of the whole; a Grid gives its own cells."""
        whole = density(scattered(1))
        one = vtkForestDensityFilter()
        one.SetInputDataObject(0, scattered(1))
        one.SetBounds(BOX)
        one.UpdateExtent([3, 9, 2, 15, 4, 8])
        image = one.GetOutput()
        self.assertEqual(image.GetExtent(), (3, 9, 2, 15, 4, 8))
        all_cells = cells(whole).reshape(12, 20, 20)
        self.assertTrue((cells(one).reshape(4, 13, 6) == all_cells[4:8, 2:15, 3:9]).all())
        grid = vtkImageData()
        grid.SetExtent(-6, 14, -6, 14, 5, 17)
        grid.SetSpacing(2.0, 2.0, 2.0)
        grid.SetOrigin(0.0, 0.0, -11.0)
        by_grid = vtkForestDensityFilter()
        by_grid.SetInputDataObject(0, scattered(1))
        by_grid.SetInputDataObject(1, grid)
        by_grid.Update()
        self.assertEqual(by_grid.GetOutput().GetBounds(), BOX)
        self.assertTrue((cells(by_grid) == cells(whole)).all())

    def test_tables(self):
        one = density(scattered(1), cell=1.0)
        profile, gaps = one.GetOutputDataObject(1), one.GetOutputDataObject(2)
        layers = cells(one).reshape(24, -1)[::-1]
        np.testing.assert_allclose(column(profile, "LeafAreaDensity"), layers.mean(axis=1), rtol=1e-5, atol=1e-9)
        np.testing.assert_allclose(column(profile, "CumulativeLeafArea"), layers.mean(axis=1).cumsum(), rtol=1e-5,
                                   atol=1e-9)
        self.assertEqual(column(profile, "Height")[0], 22.5)
        index = field(one, "LeafAreaIndex")
        self.assertAlmostEqual(field(one, "LeafArea") / 1600.0, index, delta=1e-9)
        # straight up: the mean over columns of what their leaves leave
        projection = column(gaps, "Projection")[0]
        through = np.exp(-projection * layers.sum(axis=0)).mean()
        self.assertAlmostEqual(column(gaps, "GapFraction")[0], through, delta=1e-6)
        angles = np.radians(column(gaps, "ZenithAngle"))
        np.testing.assert_allclose(column(gaps, "RandomGapFraction"),
                                   np.exp(-column(gaps, "Projection") * index / np.cos(angles)), rtol=1e-9)
        self.assertTrue((np.diff(column(gaps, "GapFraction")) < 0.0).all())

    def test_trees_without_leaves(self):
        """Leaf area by index, array and diameter; Lalic and Mihailovic's profile, integrated here."""
        trees = points([[10.0, 10.0, 0.0]], Height=[20.0], CrownDiameter=[8.0], DBH=[0.3])
        one = density(trees, bounds=(0, 20, 0, 20, 0, 20), cell=1.0, LeafAreaIndex=3.0)
        area = 3.0 * math.pi * 16.0
        self.assertAlmostEqual(field(one, "LeafArea") / area, 1.0, delta=1e-6)
        z = (np.arange(200000) + 0.5) / 200000
        ratio = 0.3 / (1.0 - z)
        power = np.where(z < 0.7, 6.0, 0.5)
        law = (ratio**power * np.exp(power * (1.0 - ratio))).reshape(20, -1).sum(axis=1)
        layers = cells(one).reshape(20, -1).sum(axis=1)
        np.testing.assert_allclose(layers / layers.sum(), law / law.sum(), atol=1e-5)
        foot = cells(one).reshape(20, 20, 20)[13]
        self.assertAlmostEqual(foot[10, 10] / foot.sum(), 1.0 / (math.pi * 16.0), delta=1e-6)
        # an oak of 30 cm: 526.7 kg, 2.054 % of it leaves of 80 g/m2 (Jenkins et al. 2003)
        oak = density(trees, bounds=(0, 20, 0, 20, 0, 20), SpeciesNames="Oak")
        self.assertAlmostEqual(field(oak, "LeafArea"), 526.7 * 0.02054 / 0.080, delta=0.3)
        known = density(points([[5, 5, 0]], Height=[9.0], CrownDiameter=[3.0], LeafArea=[40.0]), cell=4.0)
        self.assertAlmostEqual(field(known, "LeafArea"), 40.0, delta=1e-6)
        table = stand.table_of_words(["x", "y", "species", "dbh"],
                                     [["1", "9", "5"], ["2", "4", "9"], ["oak", "Pinus taeda", "oak"], ["30", "25", "40"]])
        read = density(stand.read_inventory(table), cell=4.0, bounds=(-8, 20, -8, 20, 0, 32))
        names = read.GetOutput().GetFieldData().GetAbstractArray("SpeciesNames")
        self.assertEqual({names.GetValue(k) for k in range(names.GetNumberOfValues())}, {"Oak", "Pine"})
        self.assertGreater(field(read, "LeafMass"), 15.0)

    def test_heights_above_ground(self):
        """A stand on a slope has the bytes of the level one, in each form; feet are at z = 0."""
        random = np.random.default_rng(5)
        level = np.column_stack([random.uniform(0.0, 40.0, (30, 2)), np.zeros(30)])
        slope = level + np.outer(0.4 * level[:, 0] - 7.0, (0.0, 0.0, 1.0))
        sizes = dict(Height=random.uniform(8.0, 20.0, 30), DBH=random.uniform(0.1, 0.4, 30))
        box = dict(bounds=(-5, 45, -5, 45, 0, 24), HeightsAboveGround=True)
        flat, tilted = (density(points(places, **sizes), **box) for places in (level, slope))
        self.assertTrue((cells(flat) == cells(tilted)).all())
        for name in ("LeafAreaDensity", "PlantAreaDensity", "CumulativeLeafArea"):
            self.assertTrue((column(flat.GetOutputDataObject(1), name) == column(tilted.GetOutputDataObject(1), name)).all())
        self.assertEqual(tilted.GetOutputDataObject(3).GetBounds()[4:], (0.0, 0.0))
        self.assertEqual(field(tilted, "HeightsAboveGround"), 1.0)
        off = density(points(slope, **sizes), bounds=box["bounds"])
        self.assertFalse((cells(off) == cells(flat)).all())
        forms = [density(scattered(form), HeightsAboveGround=on) for form in (0, 1) for on in (False, True)]
        merged, lowered, instances, lowered_instances = (cells(one).reshape(12, 20, 20) for one in forms)
        self.assertLess(np.abs(lowered - lowered_instances).max(), 1e-4 * lowered.max())
        # of the four plants, those at (9, 4) and (12, 15) stand 1 m and 0.5 m above the others
        self.assertLess(np.abs(merged - lowered)[:, :, :8].max(), 1e-6)
        self.assertGreater(np.abs(merged - lowered)[:, :, 9:].max(), 0.01)

    def test_bad_stands(self):
        def refusal(words, data, bounds=BOX, **settings):
            one = vtkForestDensityFilter()
            one.SetInputDataObject(0, data)
            one.SetBounds(bounds)
            for name, value in settings.items():
                getattr(one, "Set" + name)(*value) if isinstance(value, tuple) else getattr(one, "Set" + name)(value)
            messages = errors.kept(one)
            one.Update()
            self.assertEqual(len(messages), 1, messages)
            self.assertIn(words, messages[0])
            self.assertEqual(one.GetOutput().GetNumberOfCells(), 0)

        forest = scattered(1)
        refusal("outside of the image", forest, bounds=(900, 950, 0, 20, 0, 20))
        refusal("CellSize", forest, CellSize=(0.0, 1.0, 1.0))
        refusal("Bounds along y", forest, bounds=(0, 10, 8, 5, 0, 3))
        refusal("far ones without leaves", scattered(0, levels=True))
        refusal("no leaf area", points([[0, 0, 0]], Height=[9.0], CrownDiameter=[3.0], LeafArea=[0.0]))
        refusal("LeafArea of tree 0", points([[0, 0, 0]], Height=[9.0], CrownDiameter=[3.0], LeafArea=[-2.0]))
        refusal("set LeafAreaIndex", points([[0, 0, 0]], Height=[9.0], CrownDiameter=[3.0]))
        refusal("Height", points([[0, 0, 0]], Height=[math.nan], CrownDiameter=[3.0]), LeafAreaIndex=2.0)
        refusal("no point array Height", points([[0, 0, 0]]))


if __name__ == "__main__":
    unittest.main()
