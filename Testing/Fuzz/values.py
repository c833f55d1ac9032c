# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Values for setters: plausible ones more often than extreme ones, so that cases go deep."""

inf = float("inf")
nan = float("nan")

EXTREME_DOUBLES = [0.0, -0.0, 1.0, -1.0, 5e-324, 1e-300, 1e-30, 1e-6, 1e6, 1e15, -1e15, 1e300, 1.7e308, -1e-300,
                   -1e300, inf, -inf, nan]
EXTREME_INTS = [0, 1, -1, 2, 100, 2147483647, 2147483646, -2147483648]
STRINGS = ["", " ", "x", "Elevation", "NULL", "a b;c", "..", "%s%n%d", "ä\U0001f33f", "{}[](*+", "name.vdb", None]
EXTREMES = 0.12  # share of extreme values


def double(rng, now):
    """A number near the present one, or an extreme one."""
    if rng.random() < EXTREMES:
        return rng.choice(EXTREME_DOUBLES)
    if not isinstance(now, float) or now == 0.0:
        return round(rng.choice([0.0, rng.uniform(-1.0, 1.0), rng.uniform(0.0, 10.0)]), 3)
    return float(f"{rng.choice([now, now * rng.uniform(0.5, 1.5), now * 10.0 ** rng.uniform(-1.0, 1.0)]):.3g}")


def integer(rng, now, choices):
    """A whole number near the present one, or an extreme one; mostly one of the choices if there are any."""
    if rng.random() < EXTREMES:
        return rng.choice(EXTREME_INTS)
    if choices:
        return rng.randrange(choices)
    if not isinstance(now, int) or now == 0:
        return rng.randrange(4)
    return rng.choice([now, now + 1, now - 1, round(now * rng.uniform(0.3, 1.7))])


def text(rng, now):
    """A string, odd ones too."""
    huge = "x" * rng.choice([300, 100000])
    return rng.choice([now, rng.choice(STRINGS), rng.choice(STRINGS), huge if rng.random() < EXTREMES else "x"])


def argument(rng, kind, now, choices=0):
    """A value of that type; `now` is the present one, or None."""
    if kind == "bool":
        return rng.random() < 0.5
    if kind == "double":
        return double(rng, now)
    if kind == "int":
        return integer(rng, now, choices)
    if kind == "string":
        return text(rng, now)
    return None
