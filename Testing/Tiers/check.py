# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The processor time of each test against the budget of its tier, by ctest's record of a run.

    check.py RECORD.xml TESTS.json [NAMES [WHOLE.xml]]

RECORD.xml: what `ctest --output-junit` wrote, with whole outputs; TESTS.json: `ctest --show-only=json-v1`. Prints the time
of each label and the dearest tests; ends with 1 if a test has no tier or no time, or is beyond its budget. NAMES gets the
names of such tests, a line each. WHOLE.xml: the record of the tier, if RECORD.xml is of some tests of it that ran again.

Budgets grow on slower machines. A loop of arithmetic does not see all that makes one slow: where the host lends memory page
by page, the same tests took 1.6 times their processor time while the loop took its own. So the tests of the tier are
themselves the measure: their mean time over that where the budgets hold.
"""

import collections
import json
import re
import statistics
import sys
import time
import xml.etree.ElementTree as ElementTree
from typing import NamedTuple

BUDGETS = {"quick": 1.0, "standard": 10.0, "all": float("inf")}  # of a test [s of processor time]
LOOP = 0.0067  # processor time of loop() where budgets hold as they are [s]
MEAN = 1.74  # that of a test of the standard tier there [s]
ENOUGH = 150  # standard tests whose mean says something
TIME = re.compile(r"CPU time: ([\d.]+) user, ([\d.]+) system")
PART = re.compile(r"CPU time of (\S+): ([\d.]+) user, ([\d.]+) system")  # of a script that shares a process
SHOWN = 10  # of the dearest tests


class Cost(NamedTuple):
    """Cost of a test, or of a script of several in one test."""

    name: str
    entry: str  # ctest's name
    tiers: list
    field: str
    seconds: float  # of processor time; None: not in the record


def loop():
    """Work by which machines are compared."""
    begin, sum_ = time.process_time(), 0
    for k in range(100000):
        sum_ = (sum_ + k * k) & 0xFFFFFFFF
    return time.process_time() - begin


def slowness(costs):
    """Time of this machine over that of the budgets, at least 1: of some loops in the median, of the tier's tests in the mean
    (at most 2, so that tests that all became dearer are not taken for a machine)."""
    loops = statistics.median(loop() for _ in range(25)) / LOOP
    seconds = [cost.seconds or 0.0 for cost in costs if "all" not in cost.tiers]
    tests = len({cost.entry for cost in costs if "all" not in cost.tiers})
    return max(1.0, loops, min(2.0, sum(seconds) / tests / MEAN) if tests >= ENOUGH else 0.0)


def labels_of(path):
    """The labels of tests by name."""
    with open(path, encoding="utf-8") as file:
        tests = json.load(file)["tests"]
    return {test["name"]: next((one["value"] for one in test.get("properties", []) if one["name"] == "LABELS"), [])
            for test in tests}


def costs_of_case(case, labels):
    """The costs of an element testcase: of each script that shares it, and of the rest."""
    output, name = case.findtext("system-out") or "", case.get("name")
    field = next((label for label in labels if label not in BUDGETS), "")
    tiers = [label for label in labels if label in BUDGETS]
    parts = [(f"{name} {script}", float(user) + float(system)) for script, user, system in PART.findall(output)]
    times = TIME.findall(output)
    rest = sum(map(float, times[-1])) - sum(seconds for _, seconds in parts) if times else None
    return [Cost(one, name, tiers, field, seconds) for one, seconds in [*parts, (name, rest)]]


def costs_of(record, tests):
    """The costs of the tests that ran, the dearest first."""
    labels = labels_of(tests)
    ran = [cost for case in ElementTree.parse(record).iter("testcase") if case.get("status") in ("run", "fail")
           for cost in costs_of_case(case, labels.get(case.get("name"), []))]
    return sorted(ran, key=lambda cost: -(cost.seconds or 0.0))


def faults_of(costs, slow):
    """The name of each test that breaks a rule, and a sentence, on a machine that is so much slower than that of the budgets."""
    for cost in costs:
        if len(cost.tiers) != 1:
            yield cost.entry, f"{cost.name} has the tiers {cost.tiers}; it must have one of {', '.join(BUDGETS)}."
        elif cost.seconds is None:
            yield cost.entry, (f"{cost.name} has no processor time in the record; its command must begin with "
                              "Testing/Tiers/measured.")
        elif cost.seconds > slow * BUDGETS[cost.tiers[0]]:
            yield cost.entry, (f"{cost.name} takes {cost.seconds:.1f} s of processor time; the tier {cost.tiers[0]} allows "
                               f"{slow * BUDGETS[cost.tiers[0]]:.1f} s on this machine.")


def summary(costs):
    """Lines of the times by label and of the dearest tests."""
    fields = collections.defaultdict(list)
    for cost in costs:
        fields[cost.field].append(cost.seconds or 0.0)
    for field, seconds in sorted(fields.items(), key=lambda item: -sum(item[1])):
        yield f"{field:10} {len(seconds):5} tests {sum(seconds):7.1f} s"
    yield f"{'all':10} {len(costs):5} tests {sum(cost.seconds or 0.0 for cost in costs):7.1f} s"
    for cost in costs[:SHOWN]:
        yield f"{cost.seconds or 0.0:6.1f} s {cost.name}"


def main(record, tests, names=None, whole=None):
    costs = costs_of(record, tests)
    slow = slowness(costs_of(whole, tests) if whole else costs)
    print(f"Processor time, on a machine {slow:.2f} times as slow as that of the budgets:", *summary(costs), sep="\n  ")
    faults = list(faults_of(costs, slow))
    print(*(sentence for _, sentence in faults), sep="\n", end="\n" if faults else "")
    if names:
        with open(names, "w", encoding="utf-8") as file:
            file.writelines(f"{name}\n" for name, _ in faults)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
