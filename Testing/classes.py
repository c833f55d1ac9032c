# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""One row a class: what tests, pictures and pages need to know that neither its header nor its entry in ParaView tells.

Rows feed the hashes of outputs (Testing/Hashes), the fuzzer and the tests of bad inputs (Testing/Fuzz), mistakes and
ranks in ParaView (Testing/ParaView), the pictures of the entries (Documentation/pictures), the site and the page of
classes. They need neither VTK nor ParaView: what does is called later, with a module that has it.
"""

import functools
import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Callable, NamedTuple, Optional

HERE = Path(__file__).resolve().parent
PLUGIN = HERE.parent / "paraview-plugin"

# Fields by title: their pages of the guide and of the design.
FIELDS = {
    "Terrain": ("terrain", "terrain"),
    "Drainage": ("drainage", "drainage"),
    "Fields through data": ("kriging", "kriging"),
    "Point patterns": ("patterns", "patterns"),
    "Stands": ("stands", "plants"),
    "Plants": ("plants", "plants"),
    "Wind and sway": ("wind", "wind"),
    "Sea": ("sea", "sea"),
    "Currents": ("currents", "currents"),
    "Particles": ("particles", "particles"),
    "Seaweeds": ("seaweed", "seaweed"),
    "Light": ("light", "light"),
    "Views": ("terrain", "geometry"),
    "Rasters": ("terrain", "terrain"),
    "Volumes": ("volumes", "volumes"),
    "Scenes": ("saving", "scenes"),
}

# Classes of which there are no objects, and their fields.
BASES = {
    "vtkRandomFieldAlgorithm": "Terrain",
    "vtkPlantSource": "Plants",
    "vtkLeafyTreeSource": "Plants",
    "vtkViewDependentAlgorithm": "Views",
    "vtkSingleFileWriter": "Rasters",
}

# Classes that draw, and are no part of a pipeline.
PASSES = {"vtkLandscapePass": "Light", "vtkImpostorMapper": "Light"}

# Folders of VTK classes that users call.
MODULES = ("Sources", "Filters", "Rendering", "IO")

# Output after a mistake: nothing, or the first input as it is.
EMPTY, UNMOVED = "empty", "unmoved"


class Mistake(NamedTuple):
    """A mistake with an entry in ParaView."""

    entry: str  # the proxy
    given: Callable  # (Examples): its inputs and properties
    words: str  # of the one message
    result: str = EMPTY


class Entry(NamedTuple):
    """A proxy of a class that users find in ParaView."""

    proxy: str
    label: str
    menu: str  # Sources or Filters; Open or Save for readers and writers
    kind: str  # tag of its definition, as PresetProxy
    ports: dict  # names of the input properties in Python, by port


class Row(NamedTuple):
    """A class that can be made."""

    name: str
    field: str  # a title of FIELDS
    fed_by: list = []  # classes or OTHER_OUTPUTS, by port, of which small examples are the inputs of a small example
    small: dict = {}  # settings of a small example: methods and their arguments
    inputs: Optional[Callable] = None  # (Testing/Hashes/hash_outputs.py): larger inputs; None: those of a small example
    variants: list = []  # settings that change the output, beside the defaults
    mistakes: list = []  # the typical one of each entry first
    shown: dict = {}  # by entry, (Examples): the inputs of its picture; else what feeds it, by default

    @property
    def entries(self):
        """Entries in ParaView, the first one first."""
        return [entry for name, entry in all_entries() if name == self.name]

    @property
    def entry(self):
        """Way to it in ParaView's menus."""
        menus = {"Open": "File > Open", "Save": "File > Save Data"}
        return ", ".join(f"{menus.get(one.menu, one.menu + ' > Littoral')} > {one.label}" for one in self.entries)

    @property
    def is_of_files(self):
        """Whether it is a reader or a writer."""
        return "SetFileName" in self.small


def words_of(name):
    """FooBar as Foo Bar."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", " ", name)


@functools.lru_cache(maxsize=None)
def all_entries():
    """Pairs of class and Entry, in the order of the menus."""
    roots = [ElementTree.parse(path).getroot() for path in sorted(PLUGIN.glob("*.xml"))]
    proxies = {one.get("name"): one for root in roots for group in root.iter("ProxyGroup") for one in group}

    def ports_of(proxy):
        base = proxies.get(proxy.get("base_proxyname", ""))
        own = {int(one.get("port_index", order)): (one.get("label") or one.get("name")).replace(" ", "")
               for order, one in enumerate(proxy.iter("InputProperty"))}
        return {**({} if base is None else ports_of(base)), **own}

    def entry_of(proxy, menu, label=None):
        label = label or proxy.get("label") or words_of(proxy.get("name"))
        return Entry(proxy.get("name"), label, menu, proxy.tag, ports_of(proxy))

    found = []
    for menu in ("Sources", "Filters"):
        for name in (one.get("name") for root in roots for one in root.iterfind(f"./ParaView{menu}/Category/Proxy")):
            one = proxies[name]
            # A scene is a pipeline of several classes.
            found.append((one.get("class") if one.find(".//Scene") is None else None, entry_of(one, menu)))
    for one in proxies.values():
        for hint in one.iterfind("Hints/ReaderFactory"):
            found.append((one.get("class"), entry_of(one, "Open", hint.get("file_description"))))
        for hint in one.iterfind("Hints/WriterFactory"):
            inner = one.find("SubProxy/Proxy")
            core = one if inner is None else proxies[inner.get("proxyname")]
            found.append((core.get("class"), entry_of(one, "Save", hint.get("file_description"))))
    return found


TERRAIN = "vtkTurningBandsTerrainSource"
SITES = "vtkQuadratPointSource"
TREE = "vtkReevesTreeSource"
WIND = "vtkWindFieldSource"
SEA = "vtkSeaStateSource"
PARTICLES = "vtkSuspendedParticleSource"
FLOW = "vtkFlowPrimitiveSource"
SEAWEED = "vtkSeaweedSource"
RIVERS = "rivers"
INSTANCES = "instances"

# Outputs that feed classes but are not the first of theirs as it is by default: class, port, and settings.
OTHER_OUTPUTS = {
    RIVERS: ("vtkDrainageFilter", 1, {}),
    INSTANCES: ("vtkPlantScatterFilter", 0, {"SetOutputForm": (1,), "SetUseCulling": (0,)})}

def rivers_and_terrain(pv, drainage):
    """Inputs of River Surface, which is seen on its terrain."""
    pv.Show(drainage)
    return dict(Input=pv.OutputPort(drainage, 1), Terrain=drainage)


ROWS = [
    # Terrain ---------------------------------------------------------------------------------------------------------
    Row("vtkTurningBandsTerrainSource", "Terrain",
        small={"SetWholeExtent": (0, 12, 0, 10, 0, 0), "SetSpacing": (1.7, 1.7, 1.0), "SetNumberOfLines": (16,),
               "SetNumberOfHarmonics": (20,)},
        variants=[
            {"SetWholeExtent": (0, 60, 0, 60, 0, 0)},
            {"SetWholeExtent": (0, 60, 0, 60, 0, 0), "SetModel": (1,), "SetSeed": (3,), "SetReflectance": (True,)},
            {"SetWholeExtent": (5, 60, 0, 40, 0, 0), "SetAnisotropyRatio": (2.0,), "SetAnisotropyAngle": (30.0,)}],
        mistakes=[Mistake("TurningBandsTerrainFromFits", lambda pv: dict(Input=pv.SeaState()), "covariance fit"),
                  Mistake("TurningBandsTerrain", lambda pv: dict(WholeExtent=[5, 0, 0, 10, 0, 0]), "WholeExtent"),
                  Mistake("TurningBandsTerrain", lambda pv: dict(Range=-1.0), "Range")],
        shown={"TurningBandsTerrainFromFits": lambda pv: dict(
                   Input=pv.CovarianceFit(Input=pv.TurningBandsTerrain()))}),
    Row("vtkCovarianceFitFilter", "Terrain",
        fed_by=[TERRAIN],
        small={"SetNumberOfLags": (6,), "SetNumberOfDirections": (4,), "SetFitNugget": (False,),
               "SetFitAnisotropy": (False,)},
        inputs=lambda h: [h.terrain()],
        variants=[{"SetNumberOfLags": (12,)}, {"SetRemoveTrend": (False,)}, {"SetFitAnisotropy": (False,)}],
        mistakes=[Mistake("CovarianceFit", lambda pv: dict(Input=pv.image()), "one layer")]),
    Row("vtkTerrainLevelOfDetailFilter", "Terrain",
        fed_by=[TERRAIN],
        inputs=lambda h: [h.terrain(128)],
        variants=[{"SetGroundColors": (False,)}, {"SetUseCulling": (False,)}, {"SetViewPoint": (0.0, 0.0, 90.0)}],
        mistakes=[Mistake("TerrainLevelOfDetail", lambda pv: dict(Input=pv.image()), "one layer")]),
    # Drainage --------------------------------------------------------------------------------------------------------
    Row("vtkDrainageFilter", "Drainage",
        fed_by=[TERRAIN],
        small={"SetStreamThreshold": (4,), "SetMaximumNumberOfIterations": (2,)},
        inputs=lambda h: [h.terrain(60), h.terrain(50)],
        variants=[{"SetStreamThreshold": (8,)}, {"SetCarve": (False,), "SetStreamThreshold": (12,)},
                  {"SetOutlets": (1,), "SetSeaLevel": (180.0,), "SetMaximumNumberOfIterations": (2,)},
                  {"SetMethod": (1,), "SetMaximumNumberOfIterations": (2,)}, {"SetMethod": (2,)}],
        mistakes=[
            Mistake("Drainage", lambda pv: dict(Input=pv.image()), "one layer"),
            Mistake("Drainage",
                    lambda pv: dict(Input=pv.TurningBandsTerrain(WholeExtent=[0, 40, 0, 40, 0, 0]), Method=2),
                    "no Target"),
            Mistake("Drainage",
                    lambda pv: dict(Input=pv.TurningBandsTerrain(WholeExtent=[0, 40, 0, 40, 0, 0]),
                                    Target=pv.TurningBandsTerrain(WholeExtent=[0, 40, 0, 40, 0, 0]), Method=1, UseRock=1),
                    "UseRock"),
            Mistake("Drainage",
                    lambda pv: dict(Input=pv.TurningBandsTerrain(WholeExtent=[5, 45, 5, 45, 0, 0]),
                                    Target=pv.TurningBandsTerrain(WholeExtent=[0, 40, 0, 40, 0, 0]), Method=1,
                                    Given=pv.PointSource()),
                    "outside of the terrain"),
            Mistake("Drainage",
                    lambda pv: dict(Input=pv.TurningBandsTerrain(WholeExtent=[0, 40, 0, 40, 0, 0]), Concavity=-1.0),
                    "Concavity")]),
    Row("vtkGroundStatisticsFilter", "Drainage",
        fed_by=[TERRAIN],
        small={"SetStreamThreshold": (6,)},
        inputs=lambda h: [h.terrain(60)],
        variants=[{"SetStreamThreshold": (8,)}, {"SetStreamThreshold": (30,)},
                  {"SetUseSeaLevel": (True,), "SetSeaLevel": (180.0,)}],
        mistakes=[Mistake("GroundStatistics", lambda pv: dict(Input=pv.image()), "one layer")]),
    Row("vtkRiverSurfaceFilter", "Drainage",
        fed_by=[RIVERS, TERRAIN],
        inputs=lambda h: [h.recipes.source(RIVERS), h.terrain(60)],
        variants=[{"SetSmoothing": (0,)}, {"SetWidthOfUnitArea": (20.0,), "SetSubdivision": (2,)},
                  {"SetWidthExponent": (0.1,), "SetLift": (3.0,)}],
        mistakes=[Mistake("RiverSurface", lambda pv: dict(Input=pv.Sphere()), "lines")],
        shown={"RiverSurface": lambda pv: rivers_and_terrain(pv, pv.Drainage(Input=pv.TurningBandsTerrain()))}),
    Row("vtkTerrainZoomFilter", "Drainage",
        fed_by=[TERRAIN],
        small={"SetFactor": (2,)},
        inputs=lambda h: [h.terrain(20)],
        variants=[{"SetFactor": (2,)}, {"SetFactor": (4,), "SetGrowth": (0.0,)},
                  {"SetMaximumShift": (0.01,), "SetSeed": (3,)}],
        mistakes=[Mistake("TerrainZoom", lambda pv: dict(Input=pv.image()), "one layer"),
                  Mistake("TerrainZoom",
                          lambda pv: dict(Input=pv.TurningBandsTerrain(WholeExtent=[0, 20, 0, 20, 0, 0]), Factor=1),
                          "Factor")],
        shown={"TerrainZoom": lambda pv: dict(Input=pv.TurningBandsTerrain(WholeExtent=[0, 60, 0, 60, 0, 0]))}),
    # Fields through data ---------------------------------------------------------------------------------------------
    Row("vtkConditionalTerrainFilter", "Fields through data",
        fed_by=[TERRAIN, TERRAIN, "vtkCovarianceFitFilter"],
        small={"SetNumberOfNeighbors": (8,), "SetNumberOfLines": (8,)},
        inputs=lambda h: [h.survey()],
        variants=[{"SetDimensions": (30, 20), "SetKrigingVariance": (True,), "SetCrossValidation": (True,)},
                  {"SetDimensions": (30, 20), "SetModel": (1,), "SetKrigingType": (2,), "SetNumberOfNeighbors": (12,)},
                  {"SetDimensions": (30, 20), "SetModel": (0,), "SetResult": (1,), "SetNormalScores": (True,)}],
        mistakes=[Mistake("ConditionalTerrain", lambda pv: dict(Input=pv.image()), "one layer")],
        shown={"ConditionalTerrain": lambda pv: dict(
                   Input=pv.MaskPoints(Input=pv.TurningBandsTerrain(Model="Bessel 1", Range=120, StandardDeviation=45),
                                       OnRatio=400, RandomSampling=1,
                                       RandomSamplingMode="Spatially Stratified Random Sampling",
                                       MaximumNumberofPoints=400, GenerateVertices=1, SingleVertexPerCell=1))}),
    Row("vtkNormalScoresFilter", "Fields through data",
        fed_by=[TERRAIN, TERRAIN],
        inputs=lambda h: [h.terrain(), h.terrain(30)],
        variants=[{"SetInverse": (True,)}],
        mistakes=[Mistake("NormalScores", lambda pv: dict(Input=pv.image(), Inverse=1), "Reference")],
        shown={"NormalScores": lambda pv: dict(Input=pv.TurningBandsTerrain())}),
    # Point patterns --------------------------------------------------------------------------------------------------
    Row("vtkQuadratPointSource", "Point patterns",
        small={"SetQuadrats": (6, 5), "SetOrigin": (1.0, 1.0), "SetSize": (18.0, 14.0)},
        variants=[{"SetLaw": (1,), "SetSeed": (4,)}, {"SetLaw": (2,)}, {"SetMode": (1,), "SetMeanPerQuadrat": (3.0,)}],
        mistakes=[Mistake("QuadratPointsFromFits", lambda pv: dict(Input=pv.SeaState()), "quadrat analysis"),
                  Mistake("QuadratPoints", lambda pv: dict(MeanPerQuadrat=-1.0), "Mean")],
        shown={"QuadratPointsFromFits": lambda pv: dict(Input=pv.QuadratAnalysis(Input=pv.QuadratPoints()))}),
    Row("vtkQuadratAnalysisFilter", "Point patterns",
        fed_by=[SITES],
        inputs=lambda h: [h.make("vtkQuadratPointSource")],
        variants=[{"SetQuadrats": (5, 5)}, {"SetQuadrats": (8, 6)},
                  {"SetOrigin": (-5.0, -5.0), "SetSize": (300.0, 300.0)}],
        mistakes=[Mistake("QuadratAnalysis", lambda pv: dict(Input=pv.PointSource()), "at least 5")]),
    Row("vtkPointPatternStatisticsFilter", "Point patterns",
        fed_by=[SITES],
        small={"SetNumberOfSteps": (16,), "SetNumberOfSimulations": (19,)},
        inputs=lambda h: [h.make("vtkQuadratPointSource")],
        variants=[{"SetFunction": (2,), "SetEdgeCorrection": (3,)},
                  {"SetFunction": (5,), "SetNumberOfSimulations": (19,)},
                  {"SetFunction": (0,), "SetEdgeCorrection": (1,), "SetSeed": (2,)}],
        mistakes=[
            Mistake("PointPatternStatistics", lambda pv: dict(Input=pv.PointSource()), "at least 5"),
            Mistake("PointPatternStatistics", lambda pv: dict(Input=pv.sites(), Function="Mark Correlation"),
                    "MarkArray")]),
    Row("vtkPointProcessSource", "Point patterns",
        small={"SetIntensity": (0.2,), "SetOrigin": (1.0, 1.0), "SetSize": (18.0, 14.0), "SetClusterScale": (1.0,)},
        variants=[{"SetProcess": (3,)}, {"SetProcess": (4,), "SetSeed": (2,)},
                  {"SetProcess": (5,), "SetSize": (100.0, 80.0), "SetNumberOfSpecies": (2,), "SetMarks": (True,)},
                  {"SetProcess": (6,), "SetSize": (100.0, 80.0), "SetIntensity": (0.03,)}],
        mistakes=[Mistake("PointProcess", lambda pv: dict(Intensity=-1.0), "Intensity"),
                  Mistake("PointProcessOnImage", lambda pv: dict(Input=pv.image()), "one layer"),
                  Mistake("ProcessPointsFromVerdict", lambda pv: dict(Input=pv.SeaState()), "pattern verdict")],
        shown={"PointProcessOnImage": lambda pv: dict(
                   Input=pv.TurningBandsTerrain(WholeExtent=[0, 100, 0, 100, 0, 0], Spacing=[5, 5, 1], Mean=100.0)),
               "ProcessPointsFromVerdict": lambda pv: dict(
                   Input=pv.PatternVerdict(Input=pv.PointProcess(Size=[150, 150])))}),
    Row("vtkPatternVerdictFilter", "Point patterns",
        fed_by=["vtkPointProcessSource"],
        small={"SetNumberOfSimulations": (19,)},
        inputs=lambda h: [h.make("vtkPointProcessSource", SetSize=(80.0, 60.0), SetIntensity=(0.02,))],
        variants=[{"SetNumberOfSimulations": (19,)}, {"SetNumberOfSimulations": (19,), "SetFunction": (1,)},
                  {"SetNumberOfSimulations": (19,), "SetContrast": (1,), "SetSeed": (2,)}],
        mistakes=[Mistake("PatternVerdict", lambda pv: dict(Input=pv.PointSource()), "at least 5")],
        shown={"PatternVerdict": lambda pv: dict(Input=pv.PointProcess(Size=[150, 150]))}),
    # Stands ----------------------------------------------------------------------------------------------------------
    Row("vtkTextTableReader", "Stands",
        small={"SetFileName": (str(HERE / "Fuzz" / "plot.csv"),)}),
    Row("vtkStandInventoryFilter", "Stands",
        fed_by=[SEA],
        small={"SetXColumn": ("Direction",), "SetYColumn": ("Phase",), "SetHeightColumn": ("Phase",)},
        inputs=lambda h: [h.inventory()],
        variants=[{"SetSeed": (2,)}, {"SetHeightVariation": (0.3,)}, {"SetPlot": ("B",), "SetQuadraticMeanDiameter": (0.4,)}],
        mistakes=[
            Mistake("StandInventory", lambda pv: dict(Inventory=pv.inventory("east,north,species,dbh")),
                    "no columns x and y"),
            Mistake("StandInventory", lambda pv: dict(Inventory=pv.inventory(), DiameterUnit="Metre"),
                    "set DiameterUnit")],
        shown={"StandInventory": lambda pv: dict(Inventory=pv.many_trees())}),
    Row("vtkSitePreferenceFilter", "Stands",
        fed_by=[SITES, TERRAIN],
        inputs=lambda h: [h.make("vtkQuadratPointSource", SetSize=(40.0, 40.0)), h.terrain()],
        variants=[{"SetSeed": (2,)}, {"SetThinning": (True,)}, {"SetThinning": (True,), "SetSeed": (3,)}],
        mistakes=[Mistake("SitePreference", lambda pv: dict(Sites=pv.sites()), "there is no terrain"),
                  Mistake("SitePreference", lambda pv: dict(Sites=pv.sites(), Terrain=pv.image()), "one layer")]),
    Row("vtkForestDensityFilter", "Stands",
        fed_by=[TREE],
        small={"SetBounds": (-4.0, 4.0, -4.0, 4.0, 0.0, 16.0)},
        inputs=lambda h: [h.tree()],
        variants=[{"SetBounds": (-8.0, 8.0, -8.0, 8.0, 0.0, 16.0)},
                  {"SetBounds": (-8.0, 8.0, -8.0, 8.0, 0.0, 16.0), "SetCellSize": (0.5, 1.0, 2.0), "SetBySpecies": (True,)},
                  {"SetBounds": (-8.0, 8.0, -8.0, 8.0, 0.0, 16.0), "SetLeafMassPerArea": (0.1,),
                   "SetHeightsAboveGround": (True,)}],
        mistakes=[Mistake("ForestDensity", lambda pv: dict(Input=pv.tree(), CellSize=[-1.0, 1.0, 1.0]), "CellSize"),
                  Mistake("ForestDensity", lambda pv: dict(Input=pv.sites()), "no point array Height"),
                  Mistake("ForestDensity", lambda pv: dict(Input=pv.tree(), Bounds=[500.0, 600.0, 0.0, 9.0, 0.0, 9.0]),
                          "outside of the image")],
        shown={"ForestDensity": lambda pv: dict(Input=pv.PlantScatter(
            Sites=pv.QuadratPoints(Size=[100, 100]), Prototypes=pv.ReevesTree(), OutputForm="Instances", UseCulling=0))}),
    Row("vtkForestDensityWriter", "Stands",
        fed_by=["vtkForestDensityFilter"],
        small={"SetFileName": ("forest.bdf",)}),
    # Plants ----------------------------------------------------------------------------------------------------------
    Row("vtkReevesTreeSource", "Plants",
        small={"SetPreset": (0,), "SetOrders": (2,), "SetMainBranches": (3,), "SetSideBranches": (2,),
               "SetNumberOfLeaves": (12,), "SetTextureSize": (16, 8)},
        variants=[{"SetPreset": (1,), "SetSeed": (2,)}, {"SetPreset": (3,)}, {"SetPreset": (0,), "SetOrders": (2,)}],
        mistakes=[Mistake("ReevesTree", lambda pv: dict(Preset="Custom", Height=-1.0), "Height")]),
    Row("vtkAonoKuniiTreeSource", "Plants",
        small={"SetPreset": (0,), "SetIterations": (3,), "SetNumberOfLeaves": (12,), "SetTextureSize": (16, 8)},
        variants=[{"SetPreset": (1,), "SetSeed": (2,)}, {"SetPreset": (9,)},
                  {"SetPreset": (0,), "SetIterations": (4,)}],
        mistakes=[Mistake("AonoKuniiTree", lambda pv: dict(Variation=2.0), "Variation")]),
    Row("vtkGardnerPlantSource", "Plants",
        small={"SetPreset": (0,), "SetHeight": (40.0,), "SetCrownBase": (35.0,), "SetCrownRadius": (1.0,),
               "SetNumberOfQuadrics": (2,), "SetShells": (2,), "SetTerms": (4,), "SetTextureSize": (16, 8)},
        variants=[{"SetPreset": (2,)}, {"SetSeed": (5,)}, {"SetPreset": (0,), "SetTerms": (6,), "SetShells": (2,)}],
        mistakes=[Mistake("GardnerPlant", lambda pv: dict(Preset="Custom", CrownRadius=-1.0), "CrownRadius")]),
    Row("vtkPlantScatterFilter", "Plants",
        fed_by=[SITES, TREE, TERRAIN],
        inputs=lambda h: [h.make("vtkQuadratPointSource"), h.tree()],
        variants=[{"SetSeed": (2,)}, {"SetUseLevels": (False,), "SetUseCulling": (False,)},
                  {"SetViewPoint": (50.0, 50.0, 9.0)}, {"SetPassJoints": (False,)},
                  {"SetViewPoint": (50.0, 50.0, 9.0), "SetPassSurfaces": (False,)}],
        mistakes=[
            Mistake("PlantScatter", lambda pv: dict(Sites=pv.sites()), "There are no prototypes"),
            Mistake("PlantScatter", lambda pv: dict(Sites=pv.tree()), "The sites are blocks"),
            Mistake("PlantScatter", lambda pv: dict(Sites=pv.tree(), Prototypes=[pv.tree()]), "The sites are blocks"),
            Mistake("PlantScatter", lambda pv: dict(Sites=pv.sites(), Prototypes=[pv.blocks()]), "Prototype 0"),
            Mistake("PlantScatter", lambda pv: dict(Sites=pv.sites(), Prototypes=[pv.tree()], Terrain=pv.image()),
                    "errain"),
            Mistake("PlantScatter", lambda pv: dict(Sites=pv.sites(), Prototypes=[pv.tree()], SlopeLimit=-1.0),
                    "SlopeLimit")],
        shown={"PlantScatter": lambda pv: dict(Sites=pv.QuadratPoints(Size=[200, 200]), Prototypes=pv.ReevesTree())}),
    # Wind and sway ---------------------------------------------------------------------------------------------------
    Row("vtkWindFieldSource", "Wind and sway",
        small={"SetDimensions": (16, 4, 4)},
        variants=[{"SetDimensions": (32, 4, 4), "SetSpectrum": (1,)}, {"SetDimensions": (32, 4, 4), "SetSeed": (2,)},
                  {"SetDimensions": (32, 4, 4), "SetCoherence": (1,), "SetNormalizeVariance": (True,)},
                  {"SetDimensions": (32, 4, 4), "SetShearStress": (True,)},
                  {"SetDimensions": (32, 4, 4), "SetShearExponent": (0.2,), "SetVeer": (0.3,)},
                  {"SetDimensions": (32, 4, 4), "SetSpectrum": (1,), "SetIECClass": (2,), "SetIECTurbulence": (1,)},
                  {"SetDimensions": (32, 4, 4), "SetIECClass": (1,), "SetIECEvent": (3,), "SetEventStart": (1.0,)}],
        mistakes=[Mistake("WindField", lambda pv: dict(ReferenceSpeed=-1.0), "ReferenceSpeed")]),
    Row("vtkWindStatisticsFilter", "Wind and sway",
        fed_by=[WIND],
        inputs=lambda h: [h.wind()],
        variants=[{"SetHeight": (3.0,)}, {"SetSeparation": (0.0, 2.0)}, {"SetNumberOfBands": (6,)}],
        mistakes=[Mistake("WindStatistics", lambda pv: dict(Input=pv.image()), "Velocity")]),
    Row("vtkWindFieldReader", "Wind and sway",
        small={"SetFileName": (str(HERE / "Fuzz" / "wind.bts"),)}),
    Row("vtkWindFieldWriter", "Wind and sway",
        fed_by=[WIND],
        small={"SetFileName": ("wind.bts",)}),
    Row("vtkImageSectionFilter", "Wind and sway",
        fed_by=[WIND],
        inputs=lambda h: [h.wind()],
        variants=[{"SetCrossSections": (1,)}],
        mistakes=[Mistake("ImageSections", lambda pv: dict(Input=pv.image(), CrossSections=-1), "CrossSections")]),
    Row("vtkBeamTreeDeformationFilter", "Wind and sway",
        fed_by=[TREE, WIND],
        small={"SetTextureSize": (16, 8)},
        inputs=lambda h: [h.tree(), h.wind()],
        variants=[{"SetResponse": (1,)}, {"SetGravity": (True,)},
                  {"SetNumberOfModes": (1,), "SetWoodFromPlants": (False,)}],
        mistakes=[
            Mistake("BeamTreeDeformation", lambda pv: dict(Input=pv.tree()), "There is no wind", UNMOVED),
            Mistake("BeamTreeDeformation", lambda pv: dict(Input=pv.tree(), Wind=pv.image()),
                    "no point array Velocity"),
            Mistake("BeamTreeDeformation", lambda pv: dict(Input=pv.blocks(), Wind=pv.WindField(**pv.SMALL_WIND)),
                    "High/Skeleton"),
            Mistake(
                "BeamTreeDeformation",
                lambda pv: dict(Input=pv.PlantScatter(Sites=pv.sites(), Prototypes=[pv.tree()]),
                                Wind=pv.WindField(**pv.SMALL_WIND), Prototypes=[pv.blocks()]),
                "Skeleton"),
            Mistake("BeamTreeDeformation",
                    lambda pv: dict(Input=pv.tree(), Wind=pv.WindField(**pv.SMALL_WIND), NumberOfModes=0),
                    "NumberOfModes"),
            Mistake("BeamTreeDeformation", lambda pv: dict(Input=pv.tree(), Wind=pv.WindField(ReferenceSpeed=-1.0)),
                    "ReferenceSpeed")]),
    # Sea -------------------------------------------------------------------------------------------------------------
    Row("vtkSeaStateSource", "Sea",
        small={"SetNumberOfTrains": (8,), "SetSeaLevel": (4.0,)},
        variants=[{"SetSpectrum": (1,)}, {"SetSeed": (2,), "SetWaterDepth": (5.0,)}, {"SetSeaBy": (1,)},
                  {"SetOrder": (2,), "SetWaterDepth": (15.0,)}, {"SetSpreadingModel": (2,)},
                  {"SetSpectrum": (5,), "SetSwellDirection": (60.0,)}],
        mistakes=[
            Mistake("MeasuredSeaState", lambda pv: dict(Input=pv.QuadratAnalysis(Input=pv.sites())),
                    "Frequency and Density"),
            Mistake("SeaState", lambda pv: dict(WindSpeed=-1.0), "WindSpeed")],
        shown={"MeasuredSeaState": lambda pv: dict(Input=pv.measured_spectrum())}),
    Row("vtkWaveSpectrumReader", "Sea",
        small={"SetFileName": (str(HERE / "Fuzz" / "waves.csv"),)},
        variants=[{"SetDirectionConvention": (2,)}]),
    Row("vtkSeaStatisticsFilter", "Sea",
        fed_by=[SEA],
        inputs=lambda h: [h.sea()],
        variants=[{"SetNumberOfSectors": (4,)}, {"SetNumberOfSectors": (36,)}, {"SetNumberOfSectors": (90,)}],
        mistakes=[Mistake("SeaStatistics", lambda pv: dict(Input=pv.QuadratAnalysis(Input=pv.sites())), "Amplitude")]),
    Row("vtkSeaSurfaceFilter", "Sea",
        fed_by=[SEA],
        small={"SetSectors": (12,), "SetRadius": (40.0,)},
        inputs=lambda h: [h.sea()],
        variants=[{"SetSpacing": (1.0,), "SetSectors": (90,)}, {"SetCenter": (70.0, -20.0), "SetRadius": (300.0,)},
                  {"SetFoamLifetime": (4.0,), "SetChoppiness": (0.5,), "SetWaterColors": (False,)}],
        mistakes=[Mistake("SeaSurface", lambda pv: dict(Input=pv.QuadratAnalysis(Input=pv.sites())), "Amplitude"),
                  Mistake("SeaSurface", lambda pv: dict(Input=pv.SeaState(), Spacing=-1.0), "Spacing")]),
    Row("vtkParticleOrbitFilter", "Sea",
        fed_by=[PARTICLES, SEA],
        inputs=lambda h: [h.particles(), h.sea()],
        variants=[{"SetStokesDrift": (True,)}, {"SetDopplerShift": (True,), "SetCurrent": (0.5, 0.1)},
                  {"SetGenerateAcceleration": (True,)}],
        mistakes=[
            Mistake("ParticleOrbits", lambda pv: dict(Input=pv.particles()), "There is no sea state", UNMOVED),
            Mistake("ParticleOrbits",
                    lambda pv: dict(Input=pv.particles(), SeaState=pv.QuadratAnalysis(Input=pv.sites())),
                    "Amplitude")]),
    # Currents --------------------------------------------------------------------------------------------------------
    Row("vtkFlowPrimitiveSource", "Currents",
        variants=[{"SetFlowType": (1,)}, {"SetFlowType": (2,)}, {"SetStrength": (3.0,)}],
        mistakes=[Mistake("FlowPrimitive", lambda pv: dict(FlowType="Vortex", CoreRadius=-1.0), "CoreRadius")]),
    Row("vtkFlowArrowFilter", "Currents",
        fed_by=[FLOW],
        inputs=lambda h: [h.make("vtkFlowPrimitiveSource", SetFlowType=(3,))],
        mistakes=[Mistake("FlowArrows", lambda pv: dict(Input=pv.Sphere()), "FlowType")],
        shown={"FlowArrows": lambda pv: dict(Input=pv.FlowPrimitive(FlowType="Vortex"))}),
    Row("vtkCurrentDriftFilter", "Currents",
        fed_by=[PARTICLES, FLOW],
        inputs=lambda h: [h.particles(), h.current()],
        variants=[{"SetStartTime": (0.5,)}, {"SetStartTime": (-2.0,), "SetTimeStep": (0.25,)},
                  {"SetGenerateCurrent": (True,)}, {"SetWayAsField": (True,)}],
        mistakes=[
            Mistake("CurrentDrift", lambda pv: dict(Input=pv.particles(), Currents=[pv.image()]), "velocities"),
            Mistake("CurrentDrift",
                    lambda pv: dict(Input=pv.particles(), Currents=[pv.FlowPrimitive()], TimeStep=-1.0), "TimeStep")],
        shown={"CurrentDrift": lambda pv: dict(
                   Input=pv.SuspendedParticles(Bounds=[-4, 4, -2, 2, -5, 0], Density=30),
                   Currents=pv.FlowPrimitive(FlowType="Vortex", Center=[0, 0, -2.5], Axis=[0, 1, 0], Strength=0.5))}),
    Row("vtkOceanCurrentReader", "Currents",
        small={"SetFileName": (str(HERE / "Fuzz" / "current.nc"),)}),
    # Particles -------------------------------------------------------------------------------------------------------
    Row("vtkSuspendedParticleSource", "Particles",
        small={"SetDensity": (0.02,)},
        variants=[{"SetPreset": (3,)}, {"SetSeed": (2,), "SetMode": (1,)},
                  {"SetDensity": (0.5,), "SetSizeSpread": (0.4,)}],
        mistakes=[Mistake("SuspendedParticles", lambda pv: dict(SizeSpread=-1.0), "SizeSpread")]),
    Row("vtkParticleLevelOfDetailFilter", "Particles",
        fed_by=[PARTICLES, SEA],
        inputs=lambda h: [h.particles(), h.sea()],
        variants=[{"SetViewPoint": (5.0, 5.0, -3.0)}, {"SetViewPoint": (5.0, 5.0, -3.0), "SetSlavesPerMaster": (2,)},
                  {"SetViewPoint": (1.0, 1.0, -1.0), "SetUseLevels": (False,)}],
        mistakes=[
            Mistake("ParticleLevelOfDetail", lambda pv: dict(Input=pv.particles()), "there is no sea state"),
            Mistake("ParticleLevelOfDetail",
                    lambda pv: dict(Input=pv.particles(), SeaState=pv.QuadratAnalysis(Input=pv.sites())),
                    "Amplitude")]),
    Row("vtkParticleFogFilter", "Particles",
        fed_by=[PARTICLES],
        small={"SetDimensions": (6, 5, 4)},
        inputs=lambda h: [h.particles()],
        variants=[{"SetGridBy": (0,), "SetDimensions": (8, 9, 10)},
                  {"SetGridBy": (1,), "SetUseBounds": (True,), "SetSpacing": (0.7,)}, {"SetWaterExtinction": (0.4,)}],
        mistakes=[Mistake("ParticleFog", lambda pv: dict(Input=pv.particles(), ParticleRadius=-1.0),
                          "ParticleRadius")]),
    # Seaweeds --------------------------------------------------------------------------------------------------------
    Row("vtkSeaweedSource", "Seaweeds",
        small={"SetSegmentsPerBranch": (4,), "SetTextureSize": (16, 8)},
        variants=[{"SetPreset": (3,)}, {"SetPreset": (2,), "SetSeed": (3,)}, {"SetSegmentsPerBranch": (4,)}],
        mistakes=[Mistake("Seaweed", lambda pv: dict(SegmentsPerBranch=0), "SegmentsPerBranch")]),
    Row("vtkSeaweedDeformationFilter", "Seaweeds",
        fed_by=[SEAWEED, SEA],
        small={"SetGenerateMotion": (True,)},
        inputs=lambda h: [h.seaweed(), h.sea(4.0)],
        variants=[{"SetMethod": (0,)}, {"SetIntegrator": (1,), "SetTimeStep": (0.0025,)},
                  {"SetGenerateMotion": (True,)}],
        mistakes=[
            Mistake("SeaweedDeformation", lambda pv: dict(Input=pv.Seaweed()), "There is no sea state and no current",
                    UNMOVED),
            Mistake("SeaweedDeformation", lambda pv: dict(Input=pv.tree(), SeaState=pv.SeaState()), "Width"),
            Mistake("SeaweedDeformation", lambda pv: dict(Input=pv.Seaweed(), Currents=[pv.FlowPrimitive()]),
                    "above the sea"),
            Mistake("SeaweedDeformation",
                    lambda pv: dict(Input=pv.Seaweed(), SeaState=pv.QuadratAnalysis(Input=pv.sites())), "Amplitude")],
        shown={"SeaweedDeformation": lambda pv: dict(Input=pv.Seaweed(),
                                                     SeaState=pv.SeaState(WindSpeed=5, SeaLevel=6, WaterDepth=6))}),
    Row("vtkPlantWakeFilter", "Seaweeds",
        fed_by=["vtkSeaweedDeformationFilter"],
        inputs=lambda h: [h.make("vtkSeaweedDeformationFilter", (h.seaweed(), h.sea(4.0)), SetGenerateMotion=(True,))],
        variants=[{"SetPrimitive": (1,)}, {"SetStrength": (2.0,)}, {"SetMargin": (1.0,)}],
        mistakes=[Mistake("PlantWake", lambda pv: dict(Input=pv.tree()), "GenerateMotion"),
                  Mistake("PlantWake", lambda pv: dict(Input=pv.blocks()), "High/Skeleton")],
        shown={"PlantWake": lambda pv: dict(
                   Input=pv.SeaweedDeformation(Input=pv.Seaweed(),
                                               SeaState=pv.SeaState(WindSpeed=5, SeaLevel=6, WaterDepth=6),
                                               GenerateMotion=1))}),
    # Rasters ---------------------------------------------------------------------------------------------------------
    Row("vtkElevationReader", "Rasters",
        small={"SetFileName": (str(HERE / "Fuzz" / "hills.asc"),)}),
    Row("vtkElevationWriter", "Rasters",
        fed_by=[TERRAIN],
        small={"SetFileName": ("terrain.tif",)}),
    # Volumes ---------------------------------------------------------------------------------------------------------
    Row("vtkVDBVolumeWriter", "Volumes",
        fed_by=[WIND],
        small={"SetFileName": ("wind.vdb",)}),
    # Scenes ----------------------------------------------------------------------------------------------------------
    Row("vtkGLTFSceneWriter", "Scenes",
        fed_by=[TREE],
        small={"SetFileName": ("tree.glb",), "SetWriteMotion": (True,), "SetEndTime": (0.1,),
               "SetWriteCamera": (True,), "SetWriteSun": (True,)}),
    Row("vtkForestTilesWriter", "Scenes",
        fed_by=[INSTANCES],
        small={"SetFileName": ("forest.json",), "SetCoordinateSystem": ("EPSG:32632",),
               "SetCoordinateOffset": (500000.0, 5400000.0)}),
]
BY_NAME = {row.name: row for row in ROWS}
