# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the script named in LITTORAL_CLIENT_SCRIPT inside ParaView's client, then ends the client.

The client itself would stay open after a script, and also after an error in it.
"""
import os
import runpy
import sys
import traceback

status = 0
script = os.environ["LITTORAL_CLIENT_SCRIPT"]
sys.path.insert(0, os.path.dirname(os.path.abspath(script)))  # as for any script
try:
    import quick
    runpy.run_path(script, run_name="__main__")
except SystemExit as end:
    status = end.code if isinstance(end.code, int) else int(end.code is not None)
except BaseException:
    # The client's sys.stderr is its own message window.
    traceback.print_exc(file=sys.__stderr__)
    status = 1
sys.__stdout__.flush()
sys.__stderr__.flush()
os._exit(status)
