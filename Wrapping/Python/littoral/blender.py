# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and films of scenes by Blender's path tracer.

    ./littoral render SCENE [FOLDER] [--engine cycles|eevee] [--samples N] [--noise SHARE] [--size W H] [--frames A B]
                      [--blur SHARE] [--blend FILE]

SCENE is a scene file (.glb), or a Python file with a function write_scene(filename, frame=0) that writes one, as those in
Examples/Blender. Without --frames one picture is made, FOLDER/NAME.png; with it FOLDER/NAME_0001.png and so on, and the
film FOLDER/NAME.ogv. A picture of a frame that is there is not made again: after an interruption the same command goes on.
"""

import argparse
import json
import os
import runpy
import shutil
import subprocess
import sys
import tempfile
import time

from . import files

#: Frames a second of a film.
RATE = 12
SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "in_blender", "render.py")
#: Variables that Blender's own Python and libraries must not take from Littoral's.
OTHERS = ("PYTHONPATH", "PYTHONHOME", "LD_LIBRARY_PATH", "LD_PRELOAD")
PNG_END = b"IEND\xaeB`\x82"


class RenderError(Exception):
    """Blender is not there, or has failed; the reason is a sentence."""


def render(scene, picture=None, blend=None, report=None, **options):
    """Render a scene file (.glb) into a PNG, save it as a .blend, or tell what it holds.

    `report` is a JSON file: counts, bounds and kinds of meshes as Blender has them. Options: size (width and height in
    pixels, default 960 x 540), samples (of a pixel at most, default 48), noise (of a pixel, as a share, at which no more
    samples are taken, 0 for never, default 0.05), engine (cycles or eevee), frame (of point caches, default 0), blur (the
    share of a frame that the shutter is open, default 0). Files are replaced when they are whole. Raises RenderError,
    and OSError where a file cannot be written.
    """
    program = shutil.which("blender")
    if not program:
        raise RenderError("Blender is not installed; its package is blender: ./littoral setup render")
    if not os.path.isfile(scene):
        raise RenderError(f"There is no scene {scene}.")
    with tempfile.TemporaryDirectory(prefix="littoral-") as folder:
        wanted = {name: target for name, target in (("picture", picture), ("blend", blend), ("report", report)) if target}
        made = {name: os.path.join(folder, name) for name in wanted}
        job = os.path.join(folder, "job.json")
        with open(job, "w", encoding="utf-8") as file:
            json.dump({"scene": os.path.abspath(scene), "rate": RATE, **made, **options,
                       "litter": [folder, *options.get("litter", ())]}, file)
        returned, output = run([program, "-b", "--factory-startup", "--python-exit-code", "1", "-P", SCRIPT, "--", job],
                               TMPDIR=folder)
        missing = [name for name, path in made.items() if not os.path.isfile(path)]
        if returned or missing or (picture and not is_whole(made["picture"])):
            lines = [line for line in output.splitlines() if line.strip()]
            raise RenderError("Blender has failed: " + " | ".join(lines[-4:]))
        for name, target in wanted.items():
            with files.replaced(target) as path:
                shutil.copyfile(made[name], path)


def run(words, **variables):
    """Run Blender with environment variables; returns its exit code and what it says. Its standard input is a pipe that ends
    when this process does, however it ends: then Blender ends too."""
    environment = {name: value for name, value in os.environ.items() if name not in OTHERS} | variables
    with subprocess.Popen(words, env=environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, errors="replace") as blender:
        try:
            output = blender.stdout.read()
        except BaseException:
            blender.kill()
            raise
        return blender.wait(), output


def is_whole(picture):
    """Whether a PNG is there to its last byte."""
    try:
        with open(picture, "rb") as file:
            return file.read().endswith(PNG_END)
    except OSError:
        return False


def write_scene(scene, filename, frame):
    """Write the scene file of a frame by a Python file."""
    functions = runpy.run_path(scene)
    if "write_scene" not in functions:
        raise RenderError(f"{scene} has no function write_scene(filename, frame=0).")
    functions["write_scene"](filename, frame)


def render_frames(scene, pictures, blend=None, **options):
    """Render frames of a scene into pictures, {frame: file}; those that are whole stay. Prints a line a frame."""
    left = [frame for frame, picture in pictures.items() if not is_whole(picture)]
    if len(left) < len(pictures):
        print(f"{len(pictures) - len(left)} of {len(pictures)} pictures are there", flush=True)
    begin = time.monotonic()
    for number, frame in enumerate(left, 1):
        wanted = pictures[frame], blend if number == 1 else None
        if scene.endswith(".glb"):  # those have files beside them
            render(scene, *wanted, frame=frame, **options)
        else:
            with tempfile.TemporaryDirectory(prefix="littoral-") as folder:
                file = os.path.join(folder, "scene.glb")
                write_scene(scene, file, frame)
                render(file, *wanted, frame=frame, litter=[folder], **options)
        gone = time.monotonic() - begin
        rest = gone / number * (len(left) - number)
        print(f"{pictures[frame]}: {gone:.0f} s" + (f", about {rest:.0f} s left" if rest else ""), flush=True)


def main(words):
    parser = argparse.ArgumentParser(prog="./littoral render", description="Renders a scene by Blender.",
                                     allow_abbrev=False)
    parser.add_argument("scene", help="a .glb, or a Python file with write_scene(filename, frame=0)")
    parser.add_argument("folder", nargs="?", default=".", help="of the pictures (default: the current one)")
    parser.add_argument("--engine", choices=("cycles", "eevee"), default="cycles")
    parser.add_argument("--samples", type=int, default=48, help="of a pixel at most (default: %(default)s)")
    parser.add_argument("--noise", type=float, default=0.05, metavar="SHARE",
                        help="with which a pixel is done after more than a third of its samples, 0: never (default: %(default)s)")
    parser.add_argument("--size", type=int, nargs=2, metavar=("W", "H"), default=(960, 540), help="in pixels")
    parser.add_argument("--frames", type=int, nargs=2, metavar=("A", "B"), help="first and last frame of a film")
    parser.add_argument("--blur", type=float, default=0.0, metavar="SHARE",
                        help="motion blur: share of a frame that the shutter is open (default: %(default)s)")
    parser.add_argument("--blend", metavar="FILE", help="also save the scene, to go on by hand")
    given = parser.parse_args(words)
    if min(*given.size, given.samples) < 1:
        parser.error("sizes and samples are above 0")
    if not 0.0 <= given.noise <= 1.0:
        parser.error("the share of noise is 0 to 1")
    if not 0.0 <= given.blur <= 1.0:
        parser.error("the share of a frame is 0 to 1")
    if given.frames and given.frames[1] < given.frames[0]:
        parser.error("the last frame is before the first")
    if not os.path.isfile(given.scene):
        parser.error(f"there is no scene {given.scene}")
    os.makedirs(given.folder, exist_ok=True)
    stem = os.path.join(given.folder, os.path.splitext(os.path.basename(given.scene))[0])
    options = {"engine": given.engine, "samples": given.samples, "noise": given.noise, "size": list(given.size),
               "blur": given.blur}
    if not given.frames:
        render_frames(given.scene, {0: f"{stem}.png"}, given.blend, **options)
        return
    pictures = {frame: f"{stem}_{frame:04d}.png" for frame in range(given.frames[0], given.frames[1] + 1)}
    render_frames(given.scene, pictures, given.blend, **options)
    from .film import save_film

    save_film(f"{stem}.ogv", pictures.values(), RATE)


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except (RenderError, OSError) as error:
        sys.exit(f"render: {error}")
