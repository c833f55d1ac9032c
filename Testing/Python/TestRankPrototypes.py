# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Ranks share the pictures of prototypes that all of them make: the bytes of one rank; where one can make none, all of
them end with one message.

The file starts itself on three ranks; each writes what it has seen."""

import json
import os
import sys

import littoral
from TestRankCanopies import of_rank, start
from TestRankTeam import Messages, bytes_of, sites


def species(rank):
    """Names and prototypes of forests, of which one rank has another, or none."""

    def shrub(seed=1, texels=8):
        plant = littoral.vtkReevesTreeSource()
        plant.SetPresetToShrub()
        plant.SetNumberOfLeaves(60)
        plant.SetSeed(seed)
        plant.SetTextureSize(texels, 8)
        return plant

    yield "alike", [shrub(), shrub(2)]
    yield "another", [shrub(1 + rank)]
    yield "failing", [shrub(texels=1 if rank == 1 else 8), shrub(2)]
    aborted = shrub()
    if rank == 1:
        aborted.AddObserver("ProgressEvent", lambda caller, event: caller.SetAbortExecute(1))
    yield "aborted", [aborted]


def run(folder, rank, ranks, controllers):
    """Writes what a rank has of forests, alone and with others, and what its plants say."""
    lines = []
    quadrats = sites(2)
    for (name, shared), (_, alone) in zip(species(rank), species(rank)):
        said, found = [], []
        for plants, controller in (shared, controllers[0]), (alone, controllers[1]):
            type(controllers[0]).SetGlobalController(controller)
            scatter = littoral.vtkPlantScatterFilter()
            scatter.SetInputConnection(0, quadrats.GetOutputPort())
            said.append([Messages(one) for one in (*plants, scatter)])
            for plant in plants:
                scatter.AddPrototypeConnection(plant.GetOutputPort())
            scatter.SetOutputFormToInstances()
            scatter.UseCullingOff()
            scatter.UpdatePiece(rank, ranks, 0)
            found.append(bytes_of(scatter.GetOutputDataObject(0)))
        type(controllers[0]).SetGlobalController(controllers[0])
        lines.append([name, found, [" ".join(text for one in messages for text in one.texts) for messages in said]])
    with open(os.path.join(folder, str(rank)), "w") as file:
        json.dump(lines, file)


def check(folder, ranks):
    """Each rank has the plants that it has alone; where one can grow none, no rank has any, and the first says why."""
    for rank in range(ranks):
        with open(os.path.join(folder, str(rank))) as file:
            for name, (shared, alone), (said, said_alone) in json.load(file):
                print(f"{name}, rank {rank}: {shared}, {alone} alone; {said}")
                if name in ("failing", "aborted"):
                    assert shared[0] == 0, f"{name}, rank {rank}: {shared}"
                    assert ("TextureSize" in said) == (name == "failing" and rank == 0), f"{name}, rank {rank}: {said}"
                else:
                    assert shared == alone and shared[0] > 0 and not said + said_alone, f"{name}: {said} {said_alone}"


if __name__ == "__main__":
    run(sys.argv[1], *of_rank()) if len(sys.argv) > 1 else start(__file__, check)
