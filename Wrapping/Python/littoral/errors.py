# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Errors of VTK's algorithms as texts, in place of messages on the terminal."""


def kept(*algorithms):
    """A list that fills with what the algorithms and their executives report, without the place in the sources."""
    messages = []

    def keep(_source, _event, text):
        messages.append(text.split(": ", 1)[-1].strip() if text.startswith("ERROR") else text.strip())

    keep.CallDataType = "string0"
    for algorithm in algorithms:
        algorithm.AddObserver("ErrorEvent", keep)
        algorithm.GetExecutive().AddObserver("ErrorEvent", keep)
    return messages
