# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Errors of VTK's algorithms as texts, in place of messages on the terminal."""

import contextlib
import re


def kept(*algorithms):
    """A list that fills with what the algorithms report, without the place in the sources.

    What executives add, that a request failed, is left out.
    """
    messages = []
    for algorithm in algorithms:
        _observe(algorithm, messages)
    return messages


@contextlib.contextmanager
def caught(algorithm):
    """The same for one algorithm while the context lasts."""
    messages = []
    observers = _observe(algorithm, messages)
    try:
        yield messages
    finally:
        for observed, observer in observers:
            observed.RemoveObserver(observer)


def _observe(algorithm, messages):
    """Put what an algorithm reports into a list; returns pairs of what is observed and the observer."""
    def keep(_source, _event, text):
        messages.append(re.sub(r"^ERROR:.*\n.*?\(0x[0-9a-f]+\): ", "", text).strip())

    def drop(_source, _event, _text):
        pass

    keep.CallDataType = drop.CallDataType = "string0"
    executive = algorithm.GetExecutive()
    return [(algorithm, algorithm.AddObserver("ErrorEvent", keep)),
            (executive, executive.AddObserver("ErrorEvent", drop))]
