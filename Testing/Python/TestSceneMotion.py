# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What moves in a scene file is what moves in VTK: skins of trees and kelp, morphs of a sea, points that change."""

import sys
import unittest

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData

sys.dont_write_bytecode = True

import TestSceneFiles  # noqa: E402
from TestSceneFiles import complaint, make, tree, sites, points_of, forest, block, array, places  # noqa: E402


class Moving(TestSceneFiles.Written):
    """What moves, in VTK and in the file."""

    TIMES = 0.5, 1.5, 8.0  # begin and end [s], samples a second

    def compare(self, source, parts, tolerance, root="P", times=TIMES, frames=(0, 3, 8), **settings):
        """VTK's skins at sampled times are those of the file."""
        g = self.write({root: source}, times=times, JointTolerance=tolerance, **settings)
        skinned = [k for k, node in enumerate(g.nodes) if "skin" in node]
        moved, largest = 0.0, 0.0
        for time in np.array(frames) / times[2]:
            source.UpdateTimeStep(times[0] + time)
            for level, name in parts:
                data = block(source.GetOutput(), level, name)
                for node in skinned[::1 + len(skinned) // 5]:
                    for index in range(len(g.meshes[g.nodes[node]["mesh"]]["primitives"])):
                        wanted = self.plant_of(g, node, data, level)
                        at = g.skinned(node, time, index) if wanted is not None else None
                        if at is None or len(at) != len(wanted) or self.is_other(g, node, index, name):
                            continue
                        largest = max(largest, np.linalg.norm(at - wanted, axis=1).max())
                        rest = g.skinned(node, 0.0, index)
                        moved = max(moved, np.linalg.norm(at - rest, axis=1).max())
        self.assertGreater(moved, 10 * max(tolerance, 0.001), "nothing moves that could be compared")
        return g, largest

    @staticmethod
    def is_other(g, node, index, name):
        return index != (1 if name in ("Leaves", "Crown") else 0) and len(g.meshes[g.nodes[node]["mesh"]]["primitives"]) > 1

    @staticmethod
    def plant_of(g, node, data, level):
        """The vertices of the plant that a skinned node is named after; None if it is none of the level."""
        words = g.nodes[node]["name"].split()
        if words[-2] != level:
            return None
        return places(data)[array(data, "PlantId") == int(words[-1])] if data.GetPointData().HasArray("PlantId") else places(data)

    def swaying(self, plants, prototypes=()):
        wind = make("vtkWindFieldSource", Dimensions=(64, 32, 16), LateralSpacing=4.0, VerticalSpacing=2.5)
        made = make("vtkBeamTreeDeformationFilter", plants, wind, GenerateJoints=True, LeafFlutter=0.0)
        for prototype in prototypes:
            made.AddPrototypeConnection(prototype.GetOutputPort())
        return made


class Motion(Moving):
    TREES = {}, {"Seed": 2, "CrownShape": 0}
    OF_FOREST = {"times": (0.5, 0.75, 8.0), "frames": (0, 2)}
    OF_CURVES = 0, 5, 17, 36

    def test_a_tree(self):
        source = self.swaying(tree(**self.TREES[0]))
        parts = (("High", "Skin"), ("High", "Leaves"))
        g, error = self.compare(source, parts, 0.001)
        self.assertLess(error, 0.001)
        h, error = self.compare(source, parts, 0.0)
        self.assertLess(error, 0.0002)
        self.assertEqual(len(h.skins[0]["joints"]), block(source.GetOutput(), "High", "Skeleton").GetNumberOfPoints())
        self.assertLess(len(g.skins[0]["joints"]), 0.9 * len(h.skins[0]["joints"]), "the tolerance saves no joints")
        times = h.array(h.animations[0]["samplers"][0]["input"])[:, 0]
        np.testing.assert_allclose(times, np.arange(9) / 8.0, atol=1e-7)

    def test_a_forest(self):
        prototypes = [tree(**settings) for settings in self.TREES]
        wood = forest(prototypes, count=16, OutputForm=0, ViewPoint=(0.0, 0.0, 2.0), NearDistance=18.0, FarDistance=40.0)
        source = self.swaying(wood, prototypes)
        g, error = self.compare(source, (("High", "Skin"), ("High", "Leaves"), ("Medium", "Trunk"), ("Medium", "Crown")), 0.001,
                                **self.OF_FOREST)
        self.assertLess(error, 0.001)
        counts = {n: int(source.GetOutput().GetFieldData().GetArray(n).GetTuple1(0)) for n in ("PlantsHigh", "PlantsMedium")}
        self.assertEqual(len(g.skins), counts["PlantsHigh"] + counts["PlantsMedium"])
        self.assertGreater(min(counts.values()), 3)
        self.assertLessEqual(len([m for m in g.meshes if "JOINTS_0" in m["primitives"][0]["attributes"]]), 4)
        colors = [g.nodes[k].get("extras", {}).get("tint", (1, 1, 1)) for k, n in enumerate(g.nodes) if "skin" in n]
        self.assertGreater(np.std(colors), 0.01, "all plants have one tint")
        self.check_tints(g, block(source.GetOutput(), "High", "Leaves"))

    def check_tints(self, g, leaves):
        """Colors of the mesh of a group times the tint of a plant are its own, in linear light."""
        own = TestSceneFiles.linear(array(leaves, "RGB")[:, :3] / 255.0)
        for node in g.nodes:
            words = node.get("name", "").split()
            if "skin" in node and words[-2] == "High" and "tint" in node.get("extras", {}):
                leaf = g.meshes[node["mesh"]]["primitives"][1]["attributes"]["COLOR_0"]
                shown = g.array(leaf)[:, :3].sum(axis=0) * node["extras"]["tint"]
                wanted = own[array(leaves, "PlantId") == int(words[-1])].sum(axis=0)
                np.testing.assert_allclose(shown, wanted, rtol=1e-3)

    def test_curves_between_few_samples(self):
        """Cubic curves of the film's rate, at samples and between them, keep fewer numbers than all samples would."""
        source = self.swaying(tree(**self.TREES[0]))
        parts = (("High", "Skin"), ("High", "Leaves"))
        g, error = self.compare(source, parts, 0.001, times=(0.5, 2.0, 24.0), frames=self.OF_CURVES)
        self.assertLess(error, 0.001)
        samplers = g.animations[0]["samplers"]
        smooth = [s for s in samplers if s["interpolation"] == "CUBICSPLINE"]
        self.assertGreater(len(smooth), 0.2 * len(samplers), "cubic curves are hardly used")
        for sampler in smooth:
            count = g.accessors[sampler["output"]]["count"]
            self.assertEqual(count, 3 * g.accessors[sampler["input"]]["count"])
            self.assertLess(count, 37)

    def test_kelp(self):
        state = make("vtkSeaStateSource", NumberOfTrains=12, SeaLevel=4.0)
        source = make("vtkSeaweedDeformationFilter", make("vtkSeaweedSource"), state, GenerateJoints=True, UseLevels=False)
        _, error = self.compare(source, (("High", "Skin"), ("High", "Leaves")), 0.001)
        self.assertLess(error, 0.001)

    def test_a_sea(self):
        sea = make("vtkSeaSurfaceFilter", make("vtkSeaStateSource", NumberOfTrains=12), Radius=30.0)
        g = self.write({"Sea": sea, "Still": sites()}, times=(0.0, 1.0, 4.0))
        node, = g.named("Sea")
        self.assertEqual(len(g.animations[0]["channels"]), 1)
        weights = g.array(g.animations[0]["samplers"][0]["output"]).reshape(5, 4)
        for frame in range(5):
            sea.UpdateTimeStep(0.25 * frame)
            at = g.attribute(node, "POSITION") + sum(
                weights[frame, k] * g.array(target["POSITION"]) for k, target in enumerate(g.primitive(node)["targets"]))
            np.testing.assert_allclose(at, places(sea.GetOutput()), atol=1e-5)

    def test_changing_points(self):
        """A source whose points become more."""
        from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
        from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline

        class Source(VTKPythonAlgorithmBase):
            def __init__(self):
                super().__init__(nInputPorts=0, outputType="vtkPolyData")

            def RequestInformation(self, request, inputs, outputs):
                outputs.GetInformationObject(0).Set(Pipeline.TIME_RANGE(), (0.0, 1.0), 2)
                return 1

            def RequestData(self, request, inputs, outputs):
                time = outputs.GetInformationObject(0).Get(Pipeline.UPDATE_TIME_STEP())
                vtkPolyData.GetData(outputs).ShallowCopy(points_of(np.zeros((3 + int(time > 0.4), 3))))
                return 1

        text = complaint({"Growing": Source()}, times=(0.0, 1.0, 4.0))
        self.assertIn("4 points at 0.5 s after the start, and 3 there", text)


if __name__ == "__main__":
    unittest.main()
