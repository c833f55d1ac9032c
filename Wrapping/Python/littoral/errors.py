# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Errors of VTK's algorithms as texts, in place of messages on the terminal."""

import re


def kept(*algorithms):
    """A list that fills with what the algorithms report, without the place in the sources.

    What executives add, that a request failed, is left out.
    """
    messages = []

    def keep(_source, _event, text):
        messages.append(re.sub(r"^ERROR:.*\n.*?\(0x[0-9a-f]+\): ", "", text).strip())

    def drop(_source, _event, _text):
        pass

    keep.CallDataType = drop.CallDataType = "string0"
    for algorithm in algorithms:
        algorithm.AddObserver("ErrorEvent", keep)
        algorithm.GetExecutive().AddObserver("ErrorEvent", drop)
    return messages
