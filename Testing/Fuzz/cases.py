# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A case: the lines of a short Python program, which follow from a seed, a class and a number alone."""

import random
import re

import inputs
import introspection
import recipes
import values

NOT_ABOUT_DATA = {"SetController"}  # takes objects that are no part of a case


def opening(name):
    """The lines that make the working object."""
    lines = [f"made = littoral.{name}()"]
    lines += [f"made.{method}({', '.join(map(repr, given))})" for method, given in recipes.settings(name).items()]
    return lines + [connection(name, port) for port in range(len(recipes.inputs(name)))]


def connection(name, port):
    """The line that connects the valid input of a port, or clears a port that needs none."""
    sources = recipes.inputs(name)
    if port < len(sources):
        return f"made.SetInputConnection({port}, source({sources[port]!r}).GetOutputPort())"
    return f"made.RemoveAllInputConnections({port})"


class Writer:
    """Writes one case."""

    def __init__(self, name, seed, number):
        self.name = name
        self.rng = random.Random(f"{seed} {name} {number}")
        self.stops = random.Random(f"{seed} {name} {number} stops")
        self.made = recipes.source(name)
        self.setters = {setter.name: setter for setter in introspection.setters(name) if setter.name not in NOT_ABOUT_DATA}
        self.switches = [name for name in self.setters if self.switched(name)]
        self.types = introspection.ports(self.made)
        self.touched = set()  # setters and ports

    def lines(self):
        """All lines of the case: what is valid, what is not, and at last what is valid again."""
        lines = opening(self.name)
        for _ in range(self.rng.choice([1, 1, 2, 3])):
            lines += [self.change() for _ in range(self.rng.choice([0, 1, 1, 2, 4]))]
            lines.append(self.request())
        return lines + self.closing()

    def change(self):
        """A line that changes a setting, or an input."""
        names = [name for name in self.setters if name not in self.switches]
        if self.types and (not names or self.rng.random() < 0.4):
            return self.input()
        return self.setting(self.rng.choice(self.switches if self.switches and self.rng.random() < 0.1 else names))

    def switched(self, name):
        """The property that a setter without arguments sets, as SetModelToFractal does; empty if it is none."""
        plain = re.sub("(?<=[a-z0-9])To[A-Z].*", "", name)
        return plain if plain != name and plain in self.setters else ""

    def setting(self, name):
        """A line that calls a setter."""
        rng = self.rng
        setter = self.setters[name]
        now = introspection.present(self.made, setter)
        given = []
        for index, kind in enumerate(setter.types):
            if kind == "vtkAlgorithmOutput":
                given.append(rng.choice(["None", f"source({self.other()!r}).GetOutputPort()"]))
            else:
                given.append(repr(values.argument(rng, kind, now[index] if now else None, setter.choices)))
        self.touched.add(self.setters[self.switched(name) or name])
        call = ", ".join(given)
        return f"made.{setter.name}({f'[{call}]' if setter.packed else call})"

    def input(self):
        """A line that connects something to a port."""
        rng = self.rng
        port = rng.randrange(len(self.types))
        self.touched.add(port)
        known = recipes.inputs(self.name)
        producer = known[port] if port < len(known) and rng.random() < 0.75 else self.other()
        kind = rng.random()
        if kind < 0.08:
            return rng.choice([f"made.RemoveAllInputConnections({port})", f"made.SetInputDataObject({port}, None)"])
        if kind < 0.2:
            return f"made.SetInputDataObject({port}, empty({rng.choice([self.types[port], rng.choice(inputs.TYPES)])!r}))"
        if kind < 0.3:
            return f"made.SetInputConnection({port}, source({producer!r}).GetOutputPort())"
        text = f"data({producer!r})"
        for _ in range(rng.choice([0, 1, 1, 1, 2])):
            text = inputs.random_spoiling(rng, text, recipes.data(producer))
        return f"made.SetInputDataObject({port}, {text})"

    def other(self):
        """A class that puts out data."""
        return self.rng.choice([name for name in recipes.NAMES if recipes.source(name).GetNumberOfOutputPorts()])

    def request(self):
        """A line that asks for the outputs."""
        rng = self.rng
        parts = []
        if rng.random() < 0.3:
            parts.append(f"time={rng.choice([0.0, 0.5, 1.0, 2.5, -1.0, 1e6, 1e300, values.nan, values.inf])!r}")
        if rng.random() < 0.15:
            parts.append(f"piece={rng.choice([(0, 2, 0), (1, 2, 1), (7, 4, 0), (-1, 4, 0), (0, 0, 0), (2, 3, 9)])!r}")
        if rng.random() < 0.15:
            parts.append("extent=" + repr(rng.choice([(0, 3, 0, 3, 0, 0), (2, 5, 1, 2, 0, 1), (0, -1, 0, -1, 0, -1),
                                                      (5, 2, 0, 3, 0, 0), (-5, 3, 0, 900, 0, 0)])))
        if not parts and rng.random() >= 0.85:
            return "keep()"
        if self.stops.random() < 0.1:
            parts.append(f"stop={self.stops.choice([-1.0, 0.0, 0.3, 0.6, 0.9])!r}")
        return f"update({', '.join(parts)})"

    def closing(self):
        """The lines that set all that was touched as it was, and ask for the outputs."""
        lines = [connection(self.name, port) for port in sorted(key for key in self.touched if isinstance(key, int))]
        fresh = recipes.source(self.name)
        for setter in sorted(key for key in self.touched if not isinstance(key, int)):
            now = introspection.present(fresh, setter)
            if now is not None:
                call = ", ".join(map(repr, now))
                lines.append(f"made.{setter.name}({f'[{call}]' if setter.packed else call})")
            elif setter.name.endswith("Connection"):
                lines += [connection(self.name, port) for port in range(len(self.types))]
        return lines + ["finish()"]


def lines_of(name, seed, number):
    """The lines of a case."""
    return Writer(name, seed, number).lines()
