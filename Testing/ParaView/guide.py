# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The numbered lists of the guide, played in ParaView's window: a test that does what a step no longer says fails.

A step is done by its own words: menu entries, labels and values. Each word in italics or code must be done, or named
as told only. Then the picture is compared with one of the same pipeline made by a short script, from the same camera.
"""

import glob
import os
import re
import shutil

import quick
from paraview import simple
from player import PANEL, SIZE, WINDOW, Session, difference, drawn, kept_with

TOP = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
GUIDE = os.path.join(TOP, "Documentation", "guide")
DIALOG = f"{WINDOW}/SelectInputDialog"
#: ParaView's own entries, as the guide names them: menu and action.
ENTRIES = {
    "File > Open": ("menu_File", "actionFileOpen"),
    "File > Save Data": ("menu_File", "actionFileSaveData"),
    "Filters > Alphabetical > Table To Points": ("menuFilters/Alphabetical", "Table To Points"),
    "View > Animation View": ("menu_View", "Animation View"),
}


def read(file):
    with open(file, encoding="utf-8") as text:
        return text.read()


def lists(page):
    """The numbered lists of a page: of each the text of its steps, with marks, without pictures."""
    found, inside, fenced = [], False, False
    for line in read(os.path.join(GUIDE, f"{page}.md")).splitlines():
        fenced ^= line.startswith("```")
        item = None if fenced else re.match(r"\s*(\d+)[.)] +(.*)", line)
        if item:
            if item[1] == "1" or not inside:
                found.append([])
            found[-1].append(item[2])
            inside = True
        elif inside and line.startswith("   "):
            found[-1][-1] += " " + line.strip()
        elif line:
            inside = False
    return [[re.sub(r"!?\[[^]]*\]\([^)]*\)", "", step) for step in steps] for steps in found]


def pages():
    return sorted(os.path.splitext(os.path.basename(file))[0] for file in glob.glob(os.path.join(GUIDE, "*.md")))


class Walk(Session):
    """A session that walks numbered lists of pages one after the other, each to its end and from an empty window."""

    def __init__(self):
        super().__init__(__file__)
        self.panels = "".join(map(read, glob.glob(os.path.join(TOP, "paraview-plugin", "*.xml"))))

    def begin(self, page, number):
        self.page, self.steps, self.left, self.done = page, lists(page)[number], [], 0

    def empty(self):
        """Edit > Reset Session, and a view of the same size as before."""
        self.reset()
        self.small_view()  # for the old view: off
        self.small_view()

    def next(self, *told):
        """Go on to the next step; some of its marked words tell of something else than what the test does."""
        self.leave()
        assert self.done < len(self.steps), f"{self.page}: the list has only {self.done} steps"
        self.done += 1
        self.text = self.steps[self.done - 1]
        self.left = ["".join(mark) for mark in re.findall(r"\*([^*]+)\*|`([^`]+)`", self.text)]
        for words in told:
            self.say(words)

    def leave(self):
        assert not self.left, f"{self.page}, step {self.done}: the test does not do {self.left}"

    def say(self, words):
        """The step must have these words."""
        plain = re.sub("[*`]", "", self.text)
        assert words in plain, f"{self.page}, step {self.done}: {words!r} is not in {plain!r}"
        self.left = [mark for mark in self.left if mark != words]

    def named(self, label):
        """The name of an entry or property of the plugin by its label."""
        name = label.replace(" ", "")
        known = re.search(f'name="{name}"(\\s+label="{label}")?[\\s/>]', self.panels)
        assert known, f"{self.page}: the plugin has no {label!r}"
        return name

    def entry(self, words):
        """Choose an entry of a menu."""
        self.say(words)
        menu, _, label = words.partition(" > Littoral > ")
        if label:
            (self.source if menu == "Sources" else self.filter)(self.named(label))
        else:
            menu, action = ENTRIES[words]
            self.event(f"{WINDOW}/menubar/{menu}", "activate", action)

    def take_input(self, port, source, item):
        """In the dialog of a filter of several inputs: takes a source, an item of its tree, for a port."""
        self.say(port)
        self.event(f"{DIALOG}/buttonFrame/{port.replace(' ', '')}", "set_boolean", "true")
        self.say(source)
        self.event(f"{DIALOG}/pipelineView", "currentChanged", item)
        self.say("OK")
        self.event(f"{DIALOG}/buttonBox/1QPushButton0")

    def apply(self):
        self.say("Apply")
        super().apply()

    def open(self, file, other=""):
        """Open a file; where this ParaView has also another reader for it, it asks, and suggests the right one."""
        self.entry("File > Open")
        self.event(f"{WINDOW}/FileOpenDialog", "filesSelected", os.path.abspath(file))
        if hasattr(simple, other):
            self.event(f"{WINDOW}/pqSelectReaderDialog/okButton")

    def save(self, file):
        """Save Data by the name in the step; its writer's options as they are: OK in both dialogs."""
        self.entry("File > Save Data")
        self.say(file)
        self.say("OK")
        self.event(f"{WINDOW}/FileSaveDialog", "filesSelected", os.path.abspath(file))
        self.event(f"{WINDOW}/WriterSettingsDialog/widget/OKButton")

    def set(self, label, values, *, widget="DoubleLineEdit", said=""):
        """Type values into the fields of a property."""
        self.say(label)
        self.say(said)
        name = self.named(label)
        for k, value in enumerate(values):
            self.field(name, value, f"{widget}{k}")

    def tick(self, label):
        """Tick a box."""
        self.say(label)
        self.event(f"{PANEL}/{self.named(label)}/CheckBox", "set_boolean", "true")

    def slide(self, label, value, said):
        """Type a value into the field beside a slider."""
        self.say(label)
        self.say(said)
        self.field(self.named(label), value)

    def macro(self, name):
        """Import a macro and choose it in the menu."""
        self.say(f"Macros > {name}")
        self.event(f"{WINDOW}/menubar/menu_Macros", "activate", "actionMacroCreate")
        self.event(f"{WINDOW}/FileOpenDialog", "filesSelected",
                   os.path.join(TOP, "paraview-plugin", "Macros", f"{name}.py"))
        self.event(f"{WINDOW}/menubar/menu_Macros", "activate", name)

    def end(self):
        self.leave()
        assert self.done == len(self.steps), f"{self.page}: the test does {self.done} of {len(self.steps)} steps"


def walk(*modules):
    """A session that walks the lists of some modules guide_*.py in one window."""
    shutil.rmtree("settings", ignore_errors=True)
    os.environ["XDG_CONFIG_HOME"] = os.path.abspath("settings")  # where ParaView keeps an imported macro
    session = Walk()
    for module in modules:
        getattr(module, "prepare", lambda: None)()
        if module is not modules[0]:
            session.empty()
        session.begin(module.PAGE, getattr(module, "NUMBER", 0))
        module.walk(session)
        session.end()
    return session


def play(*modules):
    """Walk, then check what has come of each."""
    walk(*modules).play()
    for module in modules:
        module.check()


def compare(name, make, shown):
    """The picture of a walk is that of make(view) from the same camera at the same time, and not nearly empty."""
    kept = kept_with(name)
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    simple.SetActiveView(view)
    view.ViewTime = kept["time"]
    make(view)
    simple.Render(view)
    for key, value in kept["camera"].items():
        view.SetPropertyWithName(key, value)
    simple.Render(view)
    simple.SaveScreenshot(f"{name}-script.png", view, ImageResolution=SIZE)
    simple.ResetSession()
    covered, part = drawn(f"{name}.png"), difference(f"{name}.png", f"{name}-script.png")
    print(f"{name}: {covered:.1%} drawn, {part:.2%} differ from the script's", flush=True)
    assert covered > shown, f"{name}: {covered:.1%} of the picture are drawn"
    assert part < 0.005, f"{name}: {part:.1%} of the picture differ from the script's"
    return kept
