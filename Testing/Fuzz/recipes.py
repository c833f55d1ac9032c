# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A small working object of each class: what the cases vary, and what they hand to other classes as inputs."""

import re
from pathlib import Path

import littoral

TREE = {"SetNumberOfLeaves": (12,), "SetTextureSize": (16, 8)}
WOOD = ("vtkReevesTreeSource",)
SEA = ("vtkSeaStateSource",)
WATER = ("vtkSuspendedParticleSource",)
FLOW = ("vtkFlowPrimitiveSource",)
# class: (the classes that its ports get their inputs from, settings). A class without a line takes what its ports want.
RECIPES = {
    "vtkTurningBandsTerrainSource": ((), {"SetWholeExtent": (0, 12, 0, 10, 0, 0), "SetSpacing": (1.7, 1.7, 1.0),
                                          "SetNumberOfLines": (16,), "SetNumberOfHarmonics": (20,)}),
    "vtkQuadratPointSource": ((), {"SetQuadrats": (6, 5), "SetOrigin": (1.0, 1.0), "SetSize": (18.0, 14.0)}),
    "vtkPointProcessSource": ((), {"SetIntensity": (0.2,), "SetOrigin": (1.0, 1.0), "SetSize": (18.0, 14.0),
                                   "SetClusterScale": (1.0,)}),
    "vtkReevesTreeSource": ((), {"SetPreset": (0,), "SetOrders": (2,), "SetMainBranches": (3,), "SetSideBranches": (2,), **TREE}),
    "vtkAonoKuniiTreeSource": ((), {"SetPreset": (0,), "SetIterations": (3,), **TREE}),
    "vtkGardnerPlantSource": ((), {"SetPreset": (0,), "SetHeight": (40.0,), "SetCrownBase": (35.0,),
                                   "SetCrownRadius": (1.0,), "SetNumberOfQuadrics": (2,), "SetShells": (2,),
                                   "SetTerms": (4,), "SetTextureSize": (16, 8)}),
    "vtkSeaweedSource": ((), {"SetSegmentsPerBranch": (4,), "SetTextureSize": (16, 8)}),
    "vtkSeaStateSource": ((), {"SetNumberOfTrains": (8,), "SetSeaLevel": (4.0,)}),
    "vtkSuspendedParticleSource": ((), {"SetDensity": (0.02,)}),
    "vtkFlowPrimitiveSource": ((), {}),
    "vtkWindFieldSource": ((), {"SetDimensions": (16, 4, 4)}),
    "vtkCovarianceFitFilter": (("vtkTurningBandsTerrainSource",), {"SetNumberOfLags": (6,),
                                                                   "SetNumberOfDirections": (4,), "SetFitNugget": (False,),
                                                                   "SetFitAnisotropy": (False,)}),
    "vtkDrainageFilter": (("vtkTurningBandsTerrainSource",), {"SetMinimumDrainageCells": (4,), "SetNumberOfRounds": (2,)}),
    "vtkGroundStatisticsFilter": (("vtkTurningBandsTerrainSource",), {"SetMinimumDrainageCells": (6,)}),
    "vtkConditionalTerrainFilter": (("vtkTurningBandsTerrainSource", "vtkTurningBandsTerrainSource",
                                     "vtkCovarianceFitFilter"), {"SetNumberOfNeighbors": (8,), "SetNumberOfLines": (8,)}),
    "vtkNormalScoresFilter": (("vtkTurningBandsTerrainSource", "vtkTurningBandsTerrainSource"), {}),
    "vtkWindStatisticsFilter": (("vtkWindFieldSource",), {}),
    "vtkSeaStatisticsFilter": (SEA, {}),
    "vtkQuadratAnalysisFilter": (("vtkQuadratPointSource",), {}),
    "vtkPointPatternStatisticsFilter": (("vtkQuadratPointSource",), {"SetNumberOfSteps": (16,),
                                                                     "SetNumberOfSimulations": (19,)}),
    "vtkPatternVerdictFilter": (("vtkPointProcessSource",), {"SetNumberOfSimulations": (19,)}),
    "vtkStandInventoryFilter": (  # phases stand for heights
        SEA, {"SetXColumn": ("Direction",), "SetYColumn": ("Phase",), "SetHeightColumn": ("Phase",)}),
    "vtkSitePreferenceFilter": (("vtkQuadratPointSource", "vtkTurningBandsTerrainSource"), {}),
    "vtkTerrainLevelOfDetailFilter": (("vtkTurningBandsTerrainSource",), {}),
    "vtkPlantScatterFilter": (("vtkQuadratPointSource", *WOOD, "vtkTurningBandsTerrainSource"), {}),
    "vtkBeamTreeDeformationFilter": ((*WOOD, "vtkWindFieldSource"), {"SetTextureSize": (16, 8)}),
    "vtkParticleOrbitFilter": (WATER + SEA, {}),
    "vtkSeaSurfaceFilter": (SEA, {"SetSectors": (12,), "SetRadius": (40.0,)}),
    "vtkFlowArrowFilter": (FLOW, {}),
    "vtkImageSectionFilter": (("vtkWindFieldSource",), {}),
    "vtkParticleLevelOfDetailFilter": (WATER + SEA, {}),
    "vtkParticleFogFilter": (WATER, {"SetDimensions": (6, 5, 4)}),
    "vtkCurrentDriftFilter": (WATER + FLOW, {}),
    "vtkSeaweedDeformationFilter": (("vtkSeaweedSource", *SEA), {"SetGenerateMotion": (True,)}),
    "vtkPlantWakeFilter": (("vtkSeaweedDeformationFilter",), {}),
    "vtkElevationReader": ((), {"SetFileName": (str(Path(__file__).with_name("hills.asc")),)}),
    "vtkElevationWriter": (("vtkTurningBandsTerrainSource",), {"SetFileName": ("terrain.tif",)}),
    "vtkVDBVolumeWriter": (("vtkWindFieldSource",), {"SetFileName": ("wind.vdb",)}),
    "vtkGLTFSceneWriter": (WOOD, {"SetFileName": ("tree.glb",), "SetWriteMotion": (True,), "SetEndTime": (0.1,),
                                  "SetWriteCamera": (True,), "SetWriteSun": (True,)}),
}
MADE = {}


def inputs(name):
    """Names of the classes that feed the ports."""
    return RECIPES.get(name, ((), {}))[0]


def settings(name):
    """Methods and arguments of the working object."""
    return RECIPES.get(name, ((), {}))[1]


def source(name):
    """The working object of a class, one for all of a process."""
    if name not in MADE:
        MADE[name] = made = getattr(littoral, name)()
        for port, other in enumerate(inputs(name)):
            made.SetInputConnection(port, source(other).GetOutputPort())
        for method, values in settings(name).items():
            getattr(made, method)(*values)
    return MADE[name]


def results(name):
    """What the working object of a class puts out."""
    made = source(name)
    made.Update()
    return [made.GetOutputDataObject(port) for port in range(made.GetNumberOfOutputPorts())]


def warm(name, lines):
    """Updates the objects that a case needs, for all processes that are forked later."""
    for other in {name, *inputs(name), *re.findall(r"(?:data|source)\('(\w+)'\)", " ".join(lines))}:
        if source(other).GetNumberOfOutputPorts():
            source(other).Update()


def data(name):
    """A copy of what the working object of a class puts out."""
    output = results(name)[0]
    copy = output.NewInstance()
    copy.DeepCopy(output)
    return copy
