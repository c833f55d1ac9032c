# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The lists of mutations fit the code: each piece that is to be broken stands once in its file."""

import os
import sys
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


if __name__ == "__main__":
    unittest.main()
