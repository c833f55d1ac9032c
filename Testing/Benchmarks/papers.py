# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The scenes of two papers: what they have published, beside what vtkbench_papers has measured.

Papers give frames a second, drawing included, on computers of their time; here are updates a second of the filters,
which draw nothing. So the ratios of a table are to be compared, and most of all those of what is counted.
"""

#: Numbers of trees here: fewer than Setas et al., figure 9, theirs, and more.
TREES_SIZES = 100, 1000, 100000, 1000000
#: Their frames a second with 1000 trees, by (levels, cells), as the text has them.
TREES = {(0, 0): 0.9, (1, 0): 3.7, (0, 1): 5.2, (1, 1): 12.2}
#: Numbers of particles of vtkbench_particles.
MILLIONS = 1000000, 10000000
#: Coulais et al., table 1: frames a second by (levels, selection of trains), at distances [m].
DISTANCES = 0, 3, 6, 9, 12
PARTICLES = {(0, 0): (11, 11, 11, 11, 11), (1, 0): (20, 23, 29, 45, 97),
             (0, 1): (13, 16, 21, 28, 30), (1, 1): (22, 28, 38, 62, 122)}
#: Numbers of particles and of trains here: a quarter of the paper's, the paper's, and more; whether the current tells
#: its way in place of writing all places.
SIZES = (1000, 30, 0), (4000, 30, 0), (400000, 30, 0), (400000, 30, 1), (400000, 300, 0)
PAPERS_SIZE = 4000, 30, 0
#: A gain below it is none.
SLOWER = 0.95
#: Coulais et al., table 2: frames a second without and with levels, by numbers of plants.
PLANTS = 25, 50, 100, 200, 300
MORE_PLANTS = 30000,  # a hundred times as many, which the paper has not
SEAWEEDS = (63, 41, 24, 13, 9), (82, 59, 38, 22, 16)

WORDS = {(0, 0): "neither", (1, 0): "levels of detail", (0, 1): "selection of trains", (1, 1): "both"}
IN_TREES = {**WORDS, (0, 1): "cells"}


def short(number):
    """Three figures that mean something."""
    return f"{number:.3g}" if number < 1000.0 else f"{number:.0f}"


def row_of(words, numbers):
    return (words, *map(short, numbers))


def ratios(numbers, others):
    return [number / other for number, other in zip(numbers, others)]


def of_millions(ran, table):
    def of(name):
        return ran[f"{name}/real_time", "vtkbench_particles"].time

    rows = []
    for size in MILLIONS:
        if (f"FrameWithout/size:{size}/real_time", "vtkbench_particles") not in ran:
            continue
        without = of(f"FrameWithout/size:{size}")
        for distance in (0, 12):
            levels = of(f"FrameWithLevels/distance:{distance}/size:{size}")
            rows.append((short(1e-6 * size), str(distance), short(without), short(levels), *gains([without], [levels])))
    if not rows:
        raise KeyError("FrameWithout")
    return ["Levels and orbits of a new view at a new time, within 60 m of the eye, which is in the water or some distance "
            "before it [ms]:", "",
            *table(("particles [million]", "distance [m]", "without", "with levels", "gain"), rows)]


def gains(numbers, others):
    """Ratios as words; those of what is slower with than without are marked."""
    return [short(ratio) + (" (slower)" if ratio < SLOWER else "") for ratio in ratios(numbers, others)]


def of_particles(ran, table):
    """ran: results by name."""
    def one(distance, levels, selection, particles, trains, told):
        return ran[f"Particles/distance:{distance}/levels:{levels}/selection:{selection}/size:{particles}"
                   f"/trains:{trains}/told:{told}/process_time"]

    def of(size, key, value):
        return [value(one(distance, *key, *size)) for distance in DISTANCES]

    def words(size):
        return f"{size[0]} in {size[1]} trains" + (", whose way is told" if size[2] else "")

    rates = {(size, key): of(size, key, lambda result: 1e3 / result.processor) for size in SIZES for key in PARTICLES}
    sums = {key: of(PAPERS_SIZE, key, lambda result: result.counters["train sums"]) for key in PARTICLES}
    rows = []
    for key, published in PARTICLES.items():
        rows.append(row_of(f"{WORDS[key]}, paper [1/s]", published))
        rows += [row_of(f"{WORDS[key]}, here, {words(size)} [1/s]", rates[size, key]) for size in SIZES]
    for key in list(PARTICLES)[1:]:
        rows.append(row_of(f"gain by {WORDS[key]}, paper", ratios(PARTICLES[key], PARTICLES[0, 0])))
        rows += [(f"here in time, {words(size)}", *gains(rates[size, key], rates[size, (0, 0)])) for size in SIZES]
        rows.append(row_of("here, in trains times particles", ratios(sums[0, 0], sums[key])))
    bounds = [short(one(0, 0, 0, 400000, trains, 0).processor / one(0, 0, 0, 400000, 1, 0).processor)
              for trains in (30, 300)]
    return ["Table 1 of Coulais et al., on an AMD Athlon XP 2400+ with an nVIDIA GeForce FX 5700 LE: 4000 particles, 30 "
            "wave trains, a uniform current. Here: current, levels and orbits, of as many particles, of a quarter and of 100 "
            "times as many in the same box, these in ten times as many trains, and with *Way As Field* of the current, too; "
            "45 degrees, 480 lines, wind of 10 m/s, which the paper does not give.", "", *table(("distance [m]", *DISTANCES), rows),
            f"In one train, without levels, 400000 particles take {bounds[0]} times less than in 30 and {bounds[1]} times "
            "less than in 300: as long as all are shown, no choice of trains gains more.", ""]


def of_seaweeds(ran, table):
    both = [[ran[f"Seaweeds/plants:{plants}/levels:{levels}/process_time"] for plants in PLANTS + MORE_PLANTS]
            for levels in (0, 1)]
    rates, segments = ([[value(one) for one in row] for row in both]
                       for value in (lambda one: 1e3 / one.processor, lambda one: one.counters["segments"]))
    rows = []
    for words, published, here in zip(("no levels", "levels of detail"), SEAWEEDS, rates):
        rows += [row_of(f"{words}, paper [1/s]", published) + ("",), row_of(f"{words}, here [1/s]", here)]
    rows += [row_of("gain, paper", ratios(*reversed(SEAWEEDS))) + ("",),
             ("here in time", *gains(*reversed(rates))),
             row_of("here, in segments moved", ratios(*segments))]
    return ["Table 2 of Coulais et al., on the same computer: simple seaweeds on 40 m x 10 m, seen lengthwise. Here: "
            "procedural plants of six segments with skins, moved by waves and current.", "",
            *table(("seaweeds", *PLANTS, *MORE_PLANTS), rows)]


def of_trees(ran, table):
    def one(cells, trees):
        return ran.get(f"Trees/cells:{cells}/trees:{trees}/iterations:90/process_time")

    rows = []
    for trees in TREES_SIZES:
        if not one(0, trees) or not one(1, trees):
            continue
        shown = {key: one(key[1], trees).counters["polygons" if key[0] else "polygons in full"] for key in TREES}
        for key, published in TREES.items():
            rows.append((trees, IN_TREES[key], short(published), short(published / TREES[0, 0]), short(1e-3 * shown[key]),
                         short(shown[0, 0] / shown[key]), short(1e3 / one(key[1], trees).processor) if key[0] else ""))
    if not rows:
        raise KeyError("Trees")
    return ["Figure 9 of Setas et al., on an SGI Indigo IRIS XS24, at 1000 trees: the frame rates that the text gives, on a "
            "random path, with two levels. Here: means over 90 views from evenly spread places within 500 m x 500 m, or as "
            "dense a forest of fewer or more, with three levels; trees in full are counted, not made. Frames with drawing "
            "are measured by bench_paper_frames.py.", "",
            *table(("trees", "with", "paper [1/s]", "gain, paper", "here [1000 polygons a view]", "gain in polygons",
                    "updates here [1/s]"), rows)]


def lines(results, table):
    """Lines of the section; table(head, rows): those of a table."""
    ran = {one.name: one for one in results if one.program == "vtkbench_papers"}
    ran.update({(one.name, one.program): one for one in results})
    made = []
    for part in (of_trees, of_particles, of_seaweeds, of_millions):
        try:
            made += part(ran, table)
        except KeyError:
            continue  # not all of it was run
    if not made:
        return ["The scenes of the papers were not measured.", ""]
    return ["Papers give frames a second, drawing included; here are updates a second of the filters, which draw nothing, "
            "by the processor's time of all threads. Ratios within a table are what compares, above all those of what is "
            "counted.", "", *made]
