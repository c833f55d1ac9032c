# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Has another Blender what that of this system has? Counts, bounds and kinds of the scene of TestBlender, the vertices of a
point cache, and wind that is seen where it is fast. As root, with a system made by `debootstrap trixie FOLDER` and `chroot
FOLDER apt-get install blender`:

    ./littoral run /usr/bin/python3 Testing/Python/other_blender.py FOLDER
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile

import numpy as np

from littoral import blender
from littoral.caches import read_pc2, write_pc2
from littoral.glb import write_glb
from TestBlender import ABOVE, TINY, pixels, scene, square
from TestBlenderLight import GUSTS, write_wind
from TestCaches import DUMP, sea

SCRIPTS = os.path.dirname(blender.SCRIPT)
QUIET = dict(stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)


def run(system, *words):
    """Blender in a folder of the other system."""
    ran = subprocess.run(["chroot", system, "env", "-i", "HOME=/root", "PATH=/usr/bin:/bin", "sh", "-c",
                          "cd /tmp/littoral && exec blender -b \"$@\"", "sh", *words], **QUIET)
    if ran.returncode:
        sys.exit(ran.stdout[-3000:])


def main(system):
    inside = os.path.join(system, "tmp", "littoral")
    shutil.rmtree(inside, ignore_errors=True)
    shutil.copytree(SCRIPTS, os.path.join(inside, "in_blender"))
    scene(os.path.join(inside, "scene.glb"))
    surface = sea()
    write_pc2(os.path.join(inside, "Sea.pc2"), surface, (1.0, 2.0, 4.0))
    surface.UpdateTimeStep(1.0)
    write_glb(os.path.join(inside, "sea.glb"), {"Sea": surface}, camera=((0, -60, 20), (0, 0, 0), (0, 0, 1), 40.0),
              extras={"caches": {"Sea": "Sea.pc2"}})
    with open(os.path.join(inside, "dump.py"), "w", encoding="utf-8") as script:
        script.write(DUMP)
    write_wind(os.path.join(inside, "wind.vdb"))
    write_glb(os.path.join(inside, "wind.glb"), {"Square": square()}, extras={"volumes": [{"file": "wind.vdb", **GUSTS}]}, **ABOVE)
    for name in ("scene", "sea", "wind"):
        made = {kind: f"/tmp/littoral/{name}.{kind}" for kind in ("report", "blend", "picture")}
        with open(os.path.join(inside, "job.json"), "w", encoding="utf-8") as job:
            json.dump({"scene": f"/tmp/littoral/{name}.glb", **made, **TINY, "samples": 400 if name == "wind" else 1}, job)
        run(system, "--factory-startup", "--python-exit-code", "1", "-P", "in_blender/render.py", "--", "job.json")
        assert blender.is_whole(os.path.join(inside, f"{name}.picture"))
    gusts = pixels(os.path.join(inside, "wind.picture"))[:4, :, 0].mean(axis=0)
    draws_wind = bool(gusts[:5].mean() < 3.0 and gusts[19:].mean() > gusts[11:13].mean() > 10.0)
    run(system, "/tmp/littoral/sea.blend", "--python-exit-code", "1", "-P", "dump.py")
    right = read_pc2(os.path.join(inside, "Sea.pc2"))
    for frame in (1, 3, 5):
        at = np.fromfile(os.path.join(inside, f"Sea_{frame}.raw"), np.float32).reshape(-1, 3)
        np.testing.assert_allclose(at, right[frame - 1], atol=1e-5)
    with tempfile.TemporaryDirectory() as folder:
        own = os.path.join(folder, "report.json")
        blender.render(os.path.join(inside, "scene.glb"), report=own)
        with open(own, encoding="utf-8") as here, open(os.path.join(inside, "scene.report"), encoding="utf-8") as there:
            here, there = json.load(here), json.load(there)
    assert here["meshes"].keys() == there["meshes"].keys()
    for name, mesh in here["meshes"].items():
        for what, value in mesh.items():
            other = there["meshes"][name][what]
            assert value == other if what in ("instances", "triangles", "kinds") else np.allclose(value, other, atol=1e-5)
    is_known = there["blender"].startswith("5.")  # of sid
    assert draws_wind or is_known, gusts
    print(f"Blender {there['blender']} has what {here['blender']} has" + ("" if draws_wind else ", and draws no volumes"))


if __name__ == "__main__":
    main(*sys.argv[1:])
