# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Graphics memory of scenes in ParaView: the most that buffers and textures take at one time [MB], by the calls of OpenGL.

    build/bin/littoral-env --display python3 Testing/Benchmarks/bench_graphics_memory.py [SCENE...]

SCENE: entries of Sources > Littoral (default: Forest and Underwater), drawn in 960 by 540 pixels as they open. Needs
apitrace, which records the calls.
"""

import os
import re
import subprocess
import sys
import tempfile

DRAWING = """
from paraview import simple
view = simple.CreateView("RenderView")
view.ViewSize = [960, 540]
simple.SetActiveView(view)
simple.Show(simple.{scene}(), view)
simple.ResetCamera(view)
for picture in range(2):
    simple.Render(view)
"""
#: Bytes of a texel.
TEXEL = {"GL_RGBA32F": 16, "GL_RGB32F": 12, "GL_RG32F": 8, "GL_RGBA16F": 8, "GL_RGB8": 3, "GL_RG8": 2, "GL_R8": 1}


class Memory:
    """What is allocated, call by call."""

    def __init__(self):
        self.taken, self.bound, self.unit, self.most = {}, {}, "0", 0

    def call(self, function, words):
        """A call of OpenGL with its arguments."""
        target = words.get("target")
        if function == "glActiveTexture":
            self.unit = words["texture"]
        elif function == "glBindBuffer":
            self.bound[target] = words["buffer"]
        elif function == "glBindTexture":
            self.bound[self.unit, target] = words["texture"]
        elif function == "glBufferData":
            self.taken["buffer", self.bound[target]] = int(words["size"])
        elif function in ("glTexImage2D", "glTexImage3D"):
            texels = int(words["width"]) * int(words["height"]) * int(words.get("depth", 1))
            key = "texture", self.bound[self.unit, target], words["level"]
            self.taken[key] = texels * TEXEL.get(words["internalformat"], 4)
        self.most = max(self.most, sum(self.taken.values()))

    def delete(self, kind, names):
        """A call that frees buffers or textures."""
        self.taken = {key: size for key, size in self.taken.items() if key[0] != kind or key[1] not in names}


def measure(scene):
    """The most memory of a scene's first pictures [bytes]."""
    memory = Memory()
    with tempfile.TemporaryDirectory() as folder:
        trace, script = os.path.join(folder, "calls.trace"), os.path.join(folder, "draw.py")
        with open(script, "w", encoding="utf-8") as file:
            file.write(DRAWING.format(scene=scene))
        subprocess.run(["apitrace", "trace", "-o", trace, "pvpython", script], check=True, capture_output=True)
        with subprocess.Popen(["apitrace", "dump", "--color=never", trace], stdout=subprocess.PIPE, text=True,
                              stderr=subprocess.DEVNULL) as dump:
            for line in dump.stdout:
                found = re.match(r"\d+ (gl\w+)\((.*)", line)
                if found and (freed := re.match(r"glDelete(Buffer|Texture)s", found[1])):
                    memory.delete(freed[1].lower(), set(re.findall(r"\d+", found[2].split("{")[-1])))
                elif found:
                    memory.call(found[1], dict(re.findall(r"(\w+) = (\w+)", found[2])))
    return memory.most


for name in sys.argv[1:] or ["Forest", "Underwater"]:
    print(f"{name}: {measure(name) / 1e6:.0f} MB", flush=True)
