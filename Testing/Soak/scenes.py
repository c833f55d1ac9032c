# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A small land and a small sea: their parts, what a session changes in them, and what it looks at."""

from typing import NamedTuple

import littoral


class Part(NamedTuple):
    """An object of a scene. Inputs are the names of parts, by the order of the ports."""

    kind: str
    inputs: tuple = ()
    settings: dict = {}
    #: method: the values that a session chooses from; the first is the one to begin with
    changes: dict = {}
    #: whether it follows the camera
    is_seen: bool = False
    #: whether its output is looked at
    is_shown: bool = False


PICTURES = {"SetTextureSize": (16, 8)}

LAND = {
    "hills": Part("vtkTurningBandsTerrainSource", (),
                  {"SetWholeExtent": (0, 40, 0, 40, 0, 0), "SetNumberOfLines": (16,), "SetNumberOfHarmonics": (24,)},
                  {"SetSeed": ((1,), (2,), (3,)), "SetStandardDeviation": ((4.0,), (0.5,), (9.0,)),
                   "SetModel": ((6,), (0,), (2,))}),
    "sites": Part("vtkQuadratPointSource", (), {"SetOrigin": (2.0, 2.0), "SetSize": (70.0, 70.0), "SetQuadrats": (4, 4)},
                  {"SetSeed": ((1,), (5,)), "SetLaw": ((0,), (1,), (2,)), "SetMeanPerQuadrat": ((1.0,), (2.0,))}),
    "oak": Part("vtkReevesTreeSource", (), {"SetPreset": (1,), "SetNumberOfLeaves": (60,), **PICTURES},
                {"SetSeed": ((1,), (4,)), "SetHeight": ((12.0,), (9.0,))}),
    "wind": Part("vtkWindFieldSource", (), {"SetDimensions": (64, 6, 9)},
                 {"SetSeed": ((1,), (2,)), "SetReferenceSpeed": ((10.0,), (4.0,), (16.0,))}),
    "wood": Part("vtkPlantScatterFilter", ("sites", "oak", "hills"), {},
                 {"SetSeed": ((1,), (2,)), "SetFarDistance": ((100.0,), (30.0,)), "SetUseLevels": ((True,), (False,))},
                 True, True),
    "sway": Part("vtkBeamTreeDeformationFilter", ("oak", "wind"), PICTURES,
                 {"SetDragCoefficient": ((1.1,), (0.4,)), "SetGravity": ((False,), (True,)),
                  "SetNumberOfModes": ((2,), (1,))}, False, True),
    "ground": Part("vtkTerrainLevelOfDetailFilter", ("hills",), {},
                   {"SetGroundColors": ((True,), (False,)), "SetNumberOfLevels": ((5,), (3,))}, True, True),
    "sections": Part("vtkImageSectionFilter", ("wind",), {}, {"SetCrossSections": ((3,), (1,))}, False, True),
    "statistics": Part("vtkWindStatisticsFilter", ("wind",), {}, {"SetHeight": ((3.0,), (5.0,))}, False, True),
}

SEA = {
    "sea": Part("vtkSeaStateSource", (), {"SetNumberOfTrains": (12,), "SetSeaLevel": (15.0,)},
                {"SetSeed": ((1,), (2,), (3,)), "SetWindSpeed": ((6.0,), (9.0,)), "SetWaterDepth": ((0.0,), (20.0,))}),
    "surface": Part("vtkSeaSurfaceFilter", ("sea",), {"SetSectors": (24,), "SetRadius": (60.0,)},
                    {"SetChoppiness": ((1.0,), (0.5,)), "SetWaterColors": ((True,), (False,))}, False, True),
    "water": Part("vtkSuspendedParticleSource", (), {"SetDensity": (0.1,)},
                  {"SetSeed": ((1,), (2,)), "SetDensity": ((0.1,), (0.2,), (0.05,)), "SetPreset": ((1,), (2,))}),
    "orbits": Part("vtkParticleOrbitFilter", ("water", "sea"), {},
                   {"SetStokesDrift": ((False,), (True,)), "SetGenerateVelocity": ((False,), (True,))}, False, True),
    "levels": Part("vtkParticleLevelOfDetailFilter", ("water", "sea"), {},
                   {"SetUseLevels": ((True,), (False,)), "SetSlavesPerMaster": ((3,), (1,)),
                    "SetVisibleDistance": ((60.0,), (12.0,))}, True, True),
    "fog": Part("vtkParticleFogFilter", ("orbits",), {"SetDimensions": (8, 8, 8), "SetUseBounds": (True,)},
                {"SetParticleRadius": ((0.005,), (0.01,)), "SetGridBy": ((0,), (1,)), "SetSpacing": ((2.0,), (3.0,))},
                False, True),
    "jet": Part("vtkFlowPrimitiveSource", (), {}, {"SetStrength": ((0.2,), (0.5,)), "SetFlowType": ((0,), (1,), (3,))}),
    "drift": Part("vtkCurrentDriftFilter", ("water", "jet"), {}, {"SetTimeStep": ((0.1,), (0.2,))}, False, True),
    "kelp": Part("vtkSeaweedSource", (), {"SetSegmentsPerBranch": (4,), **PICTURES},
                 {"SetSeed": ((1,), (2,)), "SetPreset": ((0,), (1,), (2,))}),
    "bent": Part("vtkSeaweedDeformationFilter", ("kelp", "sea"), {"SetGenerateMotion": (True,)},
                 {"SetMethod": ((1,), (0,)), "SetDragCoefficient": ((1.0,), (0.5,))}, False, True),
    "wake": Part("vtkPlantWakeFilter", ("bent",), {}, {"SetStrength": ((0.5,), (1.0,))}, False, True),
}

SCENES = {"land": LAND, "sea": SEA}


class Scene:
    """The objects of a scene."""

    def __init__(self, parts):
        self.parts = parts
        self.objects = {}
        for name, part in parts.items():
            made = self.objects[name] = getattr(littoral, part.kind)()
            for port, source in enumerate(part.inputs):
                made.SetInputConnection(port, self.objects[source].GetOutputPort())
            for method, values in part.settings.items():
                getattr(made, method)(*values)

    def change(self, name, method, values):
        getattr(self.objects[name], method)(*values)

    def look_from(self, place):
        for name, part in self.parts.items():
            if part.is_seen:
                self.objects[name].SetViewPoint(*place)

    def shown(self):
        return [made for name, made in self.objects.items() if self.parts[name].is_shown]

    def show(self, time):
        for made in self.shown():
            made.UpdateTimeStep(time)
