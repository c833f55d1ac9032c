# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: python3 tier=all
"""Scene files of whole species: what moves, and a film of three seconds, whose cubic curves keep fewer numbers than lines
of the same tolerance would."""

import sys
import unittest

import numpy as np

sys.dont_write_bytecode = True

import TestSceneFiles  # noqa: E402
import TestSceneMotion  # noqa: E402
from glb import smooth  # noqa: E402


class Species(TestSceneMotion.Motion):
    TREES = {"Preset": 2}, {"Preset": 3}
    OF_FOREST = {"times": (0.5, 1.0, 8.0), "frames": (0, 4)}
    OF_CURVES = 0, 5, 17, 26, 35, 36


class Film(TestSceneMotion.Moving):
    def test_cubic_curves_are_shorter_than_lines(self):
        g, error = self.compare(self.swaying(TestSceneFiles.tree(Preset=2)), (("High", "Skin"), ("High", "Leaves")), 0.001,
                                times=(0.5, 3.5, 24.0), frames=(0, 1, 5, 17, 26, 39, 50, 63, 70, 72))
        self.assertLess(error, 0.001)
        kept, by_lines = self.turns_of(g, 0.001)
        self.assertLess(sum(kept), sum(by_lines))

    @staticmethod
    def turns_of(g, tolerance):
        """How many turns the cubic tracks of the first skin keep, and how many lines would need to keep what follows each
        joint within the tolerance of the same motion: least squares, even strides."""
        joints = {node: k for k, node in enumerate(g.skins[0]["joints"])}
        skinned, = [k for k, node in enumerate(g.nodes) if "skin" in node]
        rests = -g.array(g.skins[0]["inverseBindMatrices"])[:, 12:15]
        reach = np.zeros(len(joints))
        for index in range(len(g.meshes[g.nodes[skinned]["mesh"]]["primitives"])):
            at = g.attribute(skinned, "POSITION", index)
            ids, weights = (g.attribute(skinned, name, index) for name in ("JOINTS_0", "WEIGHTS_0"))
            for hold in range(4):
                held = weights[:, hold] > 0.0
                away = np.linalg.norm(at[held] - rests[ids[held, hold]], axis=1)
                np.maximum.at(reach, ids[held, hold], away)
        last, fits = 72, []
        frames = np.arange(last + 1)
        for stride in range(last, 0, -1):
            knots = np.append(np.arange(0, last, stride), last)
            hats = np.array([np.interp(frames, knots, unit) for unit in np.eye(len(knots))]).T
            fits.append((len(knots), hats @ np.linalg.pinv(hats)))
        kept, by_lines = [], []
        for channel in g.animations[0]["channels"]:
            sampler = g.animations[0]["samplers"][channel["sampler"]]
            if channel["target"]["path"] != "rotation" or sampler["interpolation"] != "CUBICSPLINE":
                continue
            times, values = g.array(sampler["input"])[:, 0], g.array(sampler["output"])
            turns = np.array([smooth(times, values, frame / 24.0, "rotation") for frame in frames])
            for count, fit in fits:
                lines = fit @ turns
                lines /= np.linalg.norm(lines, axis=1, keepdims=True)
                # A turn by the angle a moves what is at the distance r by 2 r sin(a / 2).
                off = 2.0 * np.sqrt(np.maximum(0.0, 1.0 - np.einsum("ij,ij->i", lines, turns) ** 2)).max()
                if off * reach[joints[channel["target"]["node"]]] <= tolerance:
                    break
            kept.append(len(values))
            by_lines.append(count)
        return kept, by_lines


if __name__ == "__main__":
    unittest.main()
