# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Blocks of data."""


def leaves(data):
    """The data sets and tables in what a filter gives."""
    if data is None or not data.IsA("vtkCompositeDataSet"):
        return [] if data is None else [data]
    iterator = data.NewIterator()
    found = []
    while not iterator.IsDoneWithTraversal():
        found += leaves(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return found
