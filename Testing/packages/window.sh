#!/bin/bash
# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# ParaView's window with the menu Sources > Littoral open, into window.png of the current folder: someone has to look at it.
set -eu
export XDG_RUNTIME_DIR=$PWD/runtime
mkdir -p "$XDG_RUNTIME_DIR" home
chmod 0700 "$XDG_RUNTIME_DIR"
HOME=$PWD/home paraview --dr >window.log 2>&1 &
paraview=$!
trap 'kill $paraview || true' EXIT
for ((k = 0; k < 60; k++)); do
  xdotool search --onlyvisible --name 'ParaView' >/dev/null 2>&1 && break
  sleep 1
done
sleep 8
import -window root start.png
xdotool key Escape
xdotool mousemove 700 600 click 1
sleep 1
xdotool key alt+s
sleep 2
xdotool key l
sleep 2
import -window root window.png
