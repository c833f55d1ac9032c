# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Scripts that share one process, whose start takes longer than most of them: each in a session and a folder of its own.

    together.py SCRIPT...

A script is the name of one beside this, or a path, both without .py; it has the arguments of its first run-with line. One
that fails does not keep the others from running. The processor time of each is printed for Testing/Tiers/check.py.
"""

import gc
import os
import re
import runpy
import sys
import traceback

import quick
from player import time_since
from paraview import simple

HERE = os.path.dirname(os.path.abspath(__file__))


def reset():
    """A new session, in which nothing of the last one is left: VTK fails where a window outlives its session."""
    gc.collect()
    simple.ResetSession()
    gc.collect()


def run(*names, run_name="<run_path>"):
    for name in names:
        print(f"{name}:", flush=True)
        runpy.run_path(os.path.join(HERE, f"{name}.py"), run_name=run_name)
        reset()


def arguments_of(script):
    with open(os.path.join(HERE, f"{script}.py"), encoding="utf-8") as file:
        line = re.search("^# run-with:.*", file.read(1000), re.MULTILINE)
    return re.findall(r"args=(\S+)", line[0]) if line else []


def run_apart(script):
    """A script as it runs alone; whether it passed."""
    name = os.path.basename(script)
    begin, top, passed = os.times(), os.getcwd(), True
    os.makedirs(name, exist_ok=True)
    os.chdir(name)
    sys.argv[1:] = arguments_of(script)
    try:
        run(script, run_name="__main__")
    except SystemExit as end:
        reset()
        passed = end.code == 125  # skipped
    except BaseException:  # also an exit of the script
        traceback.print_exc()
        reset()
        passed = False
    os.chdir(top)
    print(time_since(begin, name), file=sys.__stdout__, flush=True)  # the client has a window for its own
    return passed


def run_all(*names):
    failed = [name for name in names if not run_apart(name)]
    if failed:  # sys.exit would end VTK's windows after their display
        print(f"Failed: {', '.join(failed)}", flush=True)
        os._exit(1)


if __name__ == "__main__":
    run_all(*sys.argv[1:])
