# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The lists of mutations fit the code: each piece that is to be broken stands once in its file."""

import os
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "Mutation"))
sys.dont_write_bytecode = True
import mutate  # noqa: E402


class Mutations(unittest.TestCase):
    def test_each_can_be_made(self):
        self.assertEqual([reason for reason in map(mutate.why_unfit, mutate.read_all()) if reason], [])

    def test_a_piece_that_stands_twice_or_nowhere_is_unfit(self):
        text = "a = 1;\n  b = 2;\nb = 2;\n"
        self.assertEqual(mutate.place(text, "a = 1"), 0)
        self.assertEqual(mutate.place(text, "b = 2;"), text.rindex("b = 2;"))  # the whole line
        self.assertEqual((mutate.place(text, "= 2"), mutate.place(text, "c")), (-1, -1))

    def test_a_list_names_tests_of_a_room_and_of_classes(self):
        with tempfile.NamedTemporaryFile("w", suffix=".txt") as file:
            file.write("# text\nCommon/Sea/Dispersion.cxx\n- a\n+ b\n? Common/Wind/TestWindField Cxx/TestRanges\n"
                       "- c\n+ d\n= no difference\n")
            file.flush()
            first, second = mutate.read_list(file.name)
        self.assertEqual((first.old, first.new, second.old, second.new), ("a", "b", "c", "d"))
        self.assertEqual((first.reason, second.reason), ("", "no difference"))
        self.assertEqual(mutate.class_tests(first), ["-R", "Cxx-(TestRanges)$"])
        self.assertEqual(mutate.class_tests(second), ["-L", "cxx"])
        programs = mutate.room_tests(first)
        self.assertEqual(programs[0], "TestWindField")  # those of the list before others of the room
        self.assertTrue({"TestSea", "TestWaveTrains"} <= set(programs))
        self.assertEqual(mutate.why_unfit(first._replace(tests=["Cxx/TestNothing"])),
                         "Common/Sea/Dispersion.cxx: there is no test Cxx/TestNothing")

    def test_mutations_of_the_plugin_ask_tests_in_paraview(self):
        mutation = mutate.Mutation("paraview-plugin/A.cxx", "a", "b", ["ParaView/TestTextures"], "")
        self.assertEqual(mutate.plugin_tests(mutation), ["-R", "^(paraview.TestTextures)$"])
        scene = mutate.Mutation("IO/SceneFile.cxx", "a", "b", ["Python/TestSceneFiles", "Python/TestHoles"], "")
        self.assertEqual(mutate.kind_of(scene, False), mutate.PLUGIN)
        self.assertEqual(mutate.plugin_tests(scene), ["-R", "^(python.TestSceneFiles|python.TestHoles)$"])
        self.assertEqual(mutate.plugin_tests(mutation._replace(tests=[])), ["-L", "paraview"])
        self.assertEqual((mutate.kind_of(mutation, False), mutate.targets_of(mutation, mutate.PLUGIN)),
                         (mutate.PLUGIN, ["all"]))
        self.assertEqual(mutate.kind_of(mutation._replace(file="Common/Sea/Dispersion.cxx"), False), mutate.ALL)

    def test_a_mirror_writes_what_differs_and_no_more(self):
        with tempfile.TemporaryDirectory() as folder:
            source, copy = os.path.join(folder, "a"), os.path.join(folder, "b")
            os.makedirs(os.path.join(source, "in"))
            for name in ("in/same", "in/other"):
                with open(os.path.join(source, name), "w", encoding="utf-8") as file:
                    file.write(name)
            mutate.mirror(source, copy, ["kept"])
            same, other = (os.path.join(copy, "in", name) for name in ("same", "other"))
            for name in (same, other):
                os.utime(name, (1, 1))
            with open(other, "w", encoding="utf-8") as file:
                file.write("broken")
            for name in ("kept", "stale"):
                os.makedirs(os.path.join(copy, name))
            mutate.mirror(source, copy, ["kept"])
            with open(other, encoding="utf-8") as file:
                self.assertEqual(file.read(), "in/other")
            self.assertEqual(os.stat(same).st_mtime, 1)
            self.assertGreater(os.stat(other).st_mtime, 1)
            self.assertEqual(sorted(os.listdir(copy)), ["in", "kept"])


if __name__ == "__main__":
    unittest.main()
