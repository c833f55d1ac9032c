# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's window with each entry of the menus Sources > Littoral and Filters > Littoral: its panel and first look,
and the message after a mistake; and the page Documentation/guide/entries.md, which shows them.

    xvfb-run -s "-screen 0 1400x1060x24" ./littoral run python3 Documentation/pictures/make_entries.py [ENTRY ...]

A source is made as a user does, by its name and Apply, a filter and its inputs by script. Needs xdotool and ImageMagick.
"""

import contextlib
import glob
import json
import os
import re
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree

HERE = os.path.dirname(os.path.abspath(__file__))
TOP = os.path.dirname(os.path.dirname(HERE))
FOLDER = os.path.join(HERE, "window")
PAGE = os.path.join(TOP, "Documentation", "guide", "entries.md")
MESSAGES = os.path.join(FOLDER, "messages.json")
SIZE = (1400, 1060)
# The window without its toolbars and its status line.
PART = "1400x890+0+140"
# The column of the edge between the panel and the view that gives labels their room, and the row of the panel's tabs.
EDGE, TABS = 440, 476
HEAD = """# The entries in pictures

{contents}
Every entry of *Sources > Littoral* and *Filters > Littoral*, as ParaView's window shows it after *Apply*: its panel
with the default values, what it shows first, and the message after a mistake. Filters have the usual input of the
guide's pages. `Documentation/pictures/make_entries.py` makes the pictures and this page.

"""


# --- the entries ----------------------------------------------------------------------------------


def words_of(name):
    """FooBar as Foo Bar."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", " ", name)


def file_of(name):
    return words_of(name).lower().replace(" ", "-")


def read_entries():
    """The entries in the order of the menus: (menu, name, label, what it is for)."""
    roots = [ElementTree.parse(path).getroot()
             for path in sorted(glob.glob(os.path.join(TOP, "paraview-plugin", "*.xml")))]
    proxies = {one.get("name"): one for root in roots for group in root.iter("ProxyGroup") for one in group}
    entries = []
    for menu in ("Sources", "Filters"):
        for root in roots:
            for entry in root.iterfind(f"./ParaView{menu}/Category/Proxy"):
                proxy = proxies[entry.get("name")]
                label = proxy.get("label") or words_of(entry.get("name"))
                entries.append((menu, entry.get("name"), label, proxy.find("Documentation").get("short_help")))
    return entries


def read_messages():
    """Messages after a mistake with each entry."""
    if not os.path.exists(MESSAGES):
        return {}
    with open(MESSAGES, encoding="utf-8") as file:
        return json.load(file)


# --- the window -----------------------------------------------------------------------------------


def do(*keys):
    subprocess.run(["xdotool", *map(str, keys)], check=True, stdout=subprocess.DEVNULL)


def click(x, y):
    do("mousemove", x, y, "click", 1)


def grab(window="root"):
    """Picture of a window, as bytes."""
    return subprocess.run(["import", "-window", window, "-depth", "8", "ppm:-"], check=True, stdout=subprocess.PIPE).stdout


def seconds_of(client):
    """The time that a client has computed."""
    with open(f"/proc/{client.pid}/stat", encoding="utf-8") as file:
        numbers = file.read().rpartition(")")[2].split()
    return (int(numbers[11]) + int(numbers[12])) / os.sysconf("SC_CLK_TCK")


def grab_at_rest(client, window="root", most=180.0):
    """Picture of a window when it has not changed for a while, in which its client computed nothing."""
    before, same, end = None, 0, time.time() + most
    while same < 3 and time.time() < end:
        done = seconds_of(client)
        time.sleep(0.7)
        now = grab(window)
        same = same + 1 if now == before and seconds_of(client) - done < 0.05 else 0
        before = now
    return before


def windows():
    """The client's windows."""
    return subprocess.run(["xdotool", "search", "--onlyvisible", "--class", "paraview"], stdout=subprocess.PIPE).stdout


def wait_until(is_so, most=180.0):
    end = time.time() + most
    while not is_so():
        if time.time() > end:
            raise RuntimeError("The window does not do as expected.")
        time.sleep(0.2)


def place_of_apply():
    """The green button, if there is one."""
    picture = grab()
    columns, rows = map(int, picture.split(b"\n", 3)[1].split())
    pixels = picture[-3 * columns * rows:]
    for y in range(300, rows):
        red, green, blue = pixels[3 * (columns * y + 20):][:3]
        if green > max(red, blue) + 25:
            return 50, y + 5
    return None


def save(picture, name, kilobytes, *options):
    path = os.path.join(FOLDER, name + ".jpg")
    subprocess.run(["convert", "ppm:-", *options, "-strip", path], input=picture, check=True)
    if os.path.getsize(path) > kilobytes * 1000:
        subprocess.run(["convert", path, "-define", f"jpeg:extent={kilobytes}kB", path], check=True)


@contextlib.contextmanager
def window_of(name, role):
    """A client in which entry_in_window.py has played a role, its last word, and the file of what is printed."""
    with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryFile("w+") as log:
        ready = os.path.join(folder, "ready")
        client = subprocess.Popen(["paraview", "--dr", "--script=" + os.path.join(HERE, "entry_in_window.py")],
                                  env=dict(os.environ, LITTORAL_SOURCE_DIR=TOP, LITTORAL_ENTRY=name, LITTORAL_ROLE=role,
                                           LITTORAL_READY=ready), stdout=log, stderr=log)
        try:
            wait_until(lambda: os.path.exists(ready))
            wait_until(windows)
            do("search", "--onlyvisible", "--name", "ParaView", "windowmove", 0, 0, "windowsize", *SIZE)
            grab_at_rest(client)
            with open(ready, encoding="utf-8") as file:
                yield client, file.read().strip(), log
        finally:
            client.kill()
            client.wait()


def edge_of_panel():
    """The column where the view begins, seen beside the panel's tabs."""
    picture = grab()
    columns, rows = map(int, picture.split(b"\n", 3)[1].split())
    row = picture[-3 * columns * rows:][3 * columns * TABS:3 * columns * (TABS + 1)]
    blank = row[3 * 200:3 * 201]
    return next(x for x in range(200, columns) if row[3 * x:3 * (x + 1)] != blank)


def move_edge(client, column):
    """Drags the edge between the panel and the view. Qt forgets a move that it has not drawn yet."""
    for _ in range(5):
        grab_at_rest(client)
        edge = edge_of_panel()
        if abs(edge - column) < 4:
            return
        do("mousemove", edge - 2, TABS)
        time.sleep(0.5)
        do("mousedown", 1, "mousemove", (edge + column) // 2, TABS)
        time.sleep(0.5)
        do("mousemove", column, TABS)
        grab_at_rest(client)
        do("mouseup", 1)
    raise RuntimeError("The panel does not get wider.")


def make_entry(label):
    """Makes an entry by its name, and applies it."""
    click(900, 700)
    before = windows()
    do("key", "ctrl+space")
    wait_until(lambda: windows() != before)
    do("type", label)
    time.sleep(1.0)
    do("key", "Return")
    wait_until(place_of_apply)
    time.sleep(1.0)
    click(*place_of_apply())
    wait_until(lambda: not place_of_apply())


def take_first_look(name, label):
    with window_of(name, "first look") as (client, word, _):
        move_edge(client, EDGE)
        if word != "made":
            make_entry(label)
        do("mousemove", SIZE[0] - 1, SIZE[1] - 1)
        save(grab_at_rest(client), file_of(name), 60, "-quality", "85", "-crop", PART, "+repage", "-resize", "1000x")


def take_mistake(name):
    """The window of messages, and the sentences in it."""
    with window_of(name, "mistake") as (client, _, log):
        messages = subprocess.run(["xdotool", "search", "--sync", "--onlyvisible", "--name", "Output Messages"],
                                  check=True, stdout=subprocess.PIPE, text=True, timeout=180).stdout.split()[0]
        do("windowsize", messages, 700, 160)
        save(grab_at_rest(client, messages), file_of(name) + "-mistake", 25, "-quality", "80")
        log.seek(0)
        return re.findall(r"(?:ERR|WARN)\|.*?\): (.*?)(?:\x1b.*)?$", log.read(), re.M)


# --- the page -------------------------------------------------------------------------------------


def write_page(entries, said):
    """All entries with their pictures."""
    text = []
    for menu in ("Sources", "Filters"):
        text += [f"## {menu}", ""]
        for _, name, label, what in [entry for entry in entries if entry[0] == menu]:
            text += [f"### {label}", "", what, ""]
            if os.path.exists(os.path.join(FOLDER, file_of(name) + ".jpg")):
                text += [f"![{label}](../pictures/window/{file_of(name)}.jpg)", ""]
            if name in said:
                text += [f"*A mistake:* {said[name]}", "",
                         f"![A mistake with {label}](../pictures/window/{file_of(name)}-mistake.jpg)", ""]
    contents = [f"- [{menu}](#{menu.lower()})\n" + "".join(
        f"  - [{label}](#{label.lower().replace(' ', '-')})\n" for kind, _, label, _ in entries if kind == menu)
        for menu in ("Sources", "Filters")]
    with open(PAGE, "w", encoding="utf-8") as file:
        file.write(HEAD.format(contents="".join(contents)) + "\n".join(text).rstrip() + "\n")


def main():
    os.makedirs(FOLDER, exist_ok=True)
    entries, said = read_entries(), read_messages()
    failed = []
    for _, name, label, _ in entries:
        if len(sys.argv) > 1 and name not in sys.argv:
            continue
        print(name, flush=True)
        try:
            take_first_look(name, label)
            sentences = take_mistake(name)
        except (RuntimeError, subprocess.SubprocessError) as error:
            failed.append(f"{name}: {error}")
            continue
        if len(sentences) != 1:
            failed.append(f"{name}: not one message but {sentences}")
        said = {**read_messages(), name: sentences[0] if sentences else ""}
        with open(MESSAGES, "w", encoding="utf-8") as file:
            json.dump(said, file, indent=1, sort_keys=True)
            file.write("\n")
    write_page(entries, said)
    sys.exit("\n".join(failed))


if __name__ == "__main__":
    main()
