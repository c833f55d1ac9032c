# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""One row a class: what tests, pictures and documents need to know of it beside its header and its entry in ParaView.

They feed the hashes of outputs (Testing/Hashes), the fuzzer and the tests of bad inputs (Testing/Fuzz), mistakes and
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
}

# What comes out after a mistake: nothing, or the first input as it is.
EMPTY, UNMOVED = "empty", "unmoved"


class Mistake(NamedTuple):
    """A mistake with an entry in ParaView."""

    entry: str  # the proxy
    given: Callable  # (Testing/ParaView/mistakes.py): its inputs and properties
    words: str  # of the one message
    result: str = EMPTY


class Entry(NamedTuple):
    """A proxy of a class that users find in ParaView."""

    proxy: str
    label: str
    menu: str  # Sources or Filters; Open or Save for readers and writers
    ports: dict  # names of the input properties by port


class Row(NamedTuple):
    """A class that can be made."""

    name: str
    field: str  # a title of FIELDS
    gives: list  # a pair a port, or some: data, and its arrays with their units
    takes: str = "none"  # the inputs
    fed_by: list = []  # classes, by port, of which small examples are the inputs of a small example
    small: dict = {}  # settings of a small example: methods and their arguments
    inputs: Optional[Callable] = None  # (Testing/Hashes/hash_outputs.py): larger inputs; None: those of a small example
    variants: list = []  # settings that change the output, beside the defaults
    mistakes: list = []  # the typical one of each entry first
    shown: dict = {}  # by entry, (Testing/ParaView/mistakes.py): inputs of its picture; else those of fed_by by default

    @property
    def entries(self):
        """Its entries in ParaView, the first one first."""
        return [entry for name, entry in all_entries() if name == self.name]

    @property
    def entry(self):
        """Where users find it in ParaView."""
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
        base = proxies.get(proxy.get("base_proxyname"))
        own = {int(one.get("port_index", 0)): one.get("name") for one in proxy.iter("InputProperty")}
        return {**({} if base is None else ports_of(base)), **own}

    def entry_of(proxy, menu, label=None):
        label = label or proxy.get("label") or words_of(proxy.get("name"))
        return Entry(proxy.get("name"), label, menu, ports_of(proxy))

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
            core = proxies[one.find("SubProxy/Proxy").get("proxyname")]
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

ROWS = [
    # Terrain ---------------------------------------------------------------------------------------------------------
    Row("vtkTurningBandsTerrainSource", "Terrain", takes="none, or a `vtkTable` of fits",
        gives=[
            ("`vtkImageData`, one layer",
             "`Elevation` float [m]; on request `Reflectance` float [0 to 1]; field data `ElevationLines`, "
             "`ReflectanceLines`")],
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
    Row("vtkCovarianceFitFilter", "Terrain", takes="`vtkImageData`, one layer, a scalar point array [m]",
        gives=[
            ("0: `vtkTable` of fits, best first",
             "`Model`, `ModelId`, `Variance` [m²], `Range` [m], `SecondRange` [m], `FractalDimension`, `Nugget` "
             "[m²], `AnisotropyRatio`, `AnisotropyAngle` [rad], `Mean` [m], `SlopeX`, `SlopeY`, `TrendWidth`, "
             "`TrendHeight` [m], `VarianceDeviation` [m²], `AtBound`, `WeightedSSE`, `AICc`"),
            ("1: `vtkTable`, the variogram",
             "`Lag` [m], `Semivariance` [m²], `Pairs`, one column per model [m²], one per direction [m²]")],
        fed_by=[TERRAIN],
        small={"SetNumberOfLags": (6,), "SetNumberOfDirections": (4,), "SetFitNugget": (False,),
               "SetFitAnisotropy": (False,)},
        inputs=lambda h: (h.terrain(),),
        variants=[{"SetNumberOfLags": (12,)}, {"SetRemoveTrend": (False,)}, {"SetFitAnisotropy": (False,)}],
        mistakes=[Mistake("CovarianceFit", lambda pv: dict(Input=pv.image()), "one layer")]),
    Row("vtkTerrainLevelOfDetailFilter", "Terrain", takes="`vtkImageData`, one layer",
        gives=[
            ("`vtkMultiBlockDataSet`, one block per level, and `Seams`",
             "`Elevation` [m], `Normals`, `TCoords`, `RGB`, `Level`")],
        fed_by=[TERRAIN],
        inputs=lambda h: (h.terrain(128),),
        variants=[{"SetGroundColors": (False,)}, {"SetUseCulling": (False,)}, {"SetViewPoint": (0.0, 0.0, 90.0)}],
        mistakes=[Mistake("TerrainLevelOfDetail", lambda pv: dict(Input=pv.image()), "one layer")]),
    # Drainage --------------------------------------------------------------------------------------------------------
    Row("vtkDrainageFilter", "Drainage",
        takes="`vtkImageData`, one layer, a scalar point array [m]; optionally another one as target",
        gives=[
            ("0: `vtkImageData`",
             "`Elevation` [m], `DrainageArea` [m²], `FlowDirection` (0 to 7 counter-clockwise from x, -1 at "
             "outlets), `StreamOrder`, `DepressionDepth` [m]; field data `SunkShare`, `HypsometricIntegral`, "
             "`HeightSkew`, `Concavity`, `CurvatureSkew`, `Rounds`, `ReachedTarget`"),
            ("1: `vtkPolyData`, rivers",
             "cells: `StreamOrder`, `DrainageArea` [m²], `Length` [m], `Slope`; points: `DrainageArea`, `RGB`")],
        fed_by=[TERRAIN],
        small={"SetMinimumDrainageCells": (4,), "SetNumberOfRounds": (2,)},
        inputs=lambda h: (h.terrain(60), h.terrain(50)),
        variants=[{"SetMinimumDrainageCells": (8,)}, {"SetCarve": (False,), "SetMinimumDrainageCells": (12,)},
                  {"SetOutlets": (1,), "SetSeaLevel": (180.0,), "SetNumberOfRounds": (2,)}],
        mistakes=[
            Mistake("Drainage", lambda pv: dict(Input=pv.image()), "one layer"),
            Mistake("Drainage",
                    lambda pv: dict(Input=pv.TurningBandsTerrain(WholeExtent=[0, 40, 0, 40, 0, 0]), Concavity=-1.0),
                    "Concavity")]),
    Row("vtkGroundStatisticsFilter", "Drainage", takes="`vtkImageData`, one layer, a scalar point array [m]",
        gives=[
            ("0: `vtkTable` of one row",
             "`SunkShare`, `FillRatio`, `HypsometricIntegral`, `HeightSkew`, `HeightDeviation` [m], `MeanSlope`, "
             "`SlopeSkew`, `CurvatureDeviation` [1/m], `CurvatureSkew`, `Concavity`, `Steepness`, `HackExponent`, "
             "`BifurcationRatio`, `LengthRatio`, `AreaRatio`"),
            ("1: `vtkTable`, slope by drainage area", "`DrainageArea` [m²], `Slope`, `PowerLaw`, `Cells`"),
            ("2: `vtkTable` of distributions", "`Fraction`, `Elevation` [m], `Slope`, `Curvature` [1/m]"),
            ("3: `vtkTable` of stream orders", "`Order`, `Streams`, `MeanLength` [m], `MeanArea` [m²]")],
        fed_by=[TERRAIN],
        small={"SetMinimumDrainageCells": (6,)},
        inputs=lambda h: (h.terrain(60),),
        variants=[{"SetMinimumDrainageCells": (8,)}, {"SetMinimumDrainageCells": (30,)},
                  {"SetUseSeaLevel": (True,), "SetSeaLevel": (180.0,)}],
        mistakes=[Mistake("GroundStatistics", lambda pv: dict(Input=pv.image()), "one layer")]),
    # Fields through data ---------------------------------------------------------------------------------------------
    Row("vtkConditionalTerrainFilter", "Fields through data",
        takes="Data: points with values, or a `vtkImageData` with holes; Grid: `vtkImageData`, optional; Fits: "
              "`vtkTable`, optional",
        gives=[
            ("0: `vtkImageData`, one layer",
             "the values' name, else `Elevation`, double; on request `KrigingVariance`; field data "
             "`KrigingNeighbors`"),
            ("1: `vtkTable`, a row per datum",
             "`X`, `Y` [m], `Value`, `Field`; on request `LeftOutEstimate`, `LeftOutDeviation`, `StandardizedError`; "
             "field data `Model`, `ModelId`, `Variance`, `Range`, `SecondRange`, `FractalDimension`, `Nugget`, "
             "`MeanError`, `RootMeanSquareError`, `MeanSquaredStandardizedError`")],
        fed_by=[TERRAIN, TERRAIN, "vtkCovarianceFitFilter"],
        small={"SetNumberOfNeighbors": (8,), "SetNumberOfLines": (8,)},
        inputs=lambda h: (h.survey(),),
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
        takes="points or `vtkImageData` with a scalar point array; Reference: the same, optional",
        gives=[("the input", "`NormalScores` double; with Inverse the reference's name, else `Elevation`")],
        fed_by=[TERRAIN, TERRAIN],
        inputs=lambda h: (h.terrain(), h.terrain(30)),
        variants=[{"SetInverse": (True,)}],
        mistakes=[Mistake("NormalScores", lambda pv: dict(Input=pv.image(), Inverse=1), "Reference")],
        shown={"NormalScores": lambda pv: dict(Input=pv.TurningBandsTerrain())}),
    # Point patterns --------------------------------------------------------------------------------------------------
    Row("vtkQuadratPointSource", "Point patterns", takes="none, or a `vtkTable` of fits",
        gives=[("`vtkPolyData`, vertices", "`SiteId`, `QuadratId`")],
        small={"SetQuadrats": (6, 5), "SetOrigin": (1.0, 1.0), "SetSize": (18.0, 14.0)},
        variants=[{"SetLaw": (1,), "SetSeed": (4,)}, {"SetLaw": (2,)}, {"SetMode": (1,), "SetMeanPerQuadrat": (3.0,)}],
        mistakes=[Mistake("QuadratPointsFromFits", lambda pv: dict(Input=pv.SeaState()), "quadrat analysis"),
                  Mistake("QuadratPoints", lambda pv: dict(MeanPerQuadrat=-1.0), "Mean")],
        shown={"QuadratPointsFromFits": lambda pv: dict(Input=pv.QuadratAnalysis(Input=pv.QuadratPoints()))}),
    Row("vtkQuadratAnalysisFilter", "Point patterns", takes="`vtkPointSet`",
        gives=[
            ("0: `vtkTable` of fits, best first",
             "`Law`, `LawId`, `MeanPerQuadrat`, `Trials`, `ClusterShape`, `ClusterMean`, `ClusterSuccess` (and "
             "`Moments...`), `LogLikelihood`, `AIC`, `ChiSquare`, `DegreesOfFreedom`, `PValue`, `Verdict`"),
            ("1: `vtkTable`, the frequencies", "`Points`, `Observed`, one column per law")],
        fed_by=[SITES],
        inputs=lambda h: (h.make("vtkQuadratPointSource"),),
        variants=[{"SetQuadrats": (5, 5)}, {"SetQuadrats": (8, 6)},
                  {"SetOrigin": (-5.0, -5.0), "SetSize": (300.0, 300.0)}],
        mistakes=[Mistake("QuadratAnalysis", lambda pv: dict(Input=pv.PointSource()), "at least 5")]),
    Row("vtkPointPatternStatisticsFilter", "Point patterns",
        takes="`vtkPointSet`, optional window `vtkPolyData`, optional `vtkTable` of fits",
        gives=[
            ("0: `vtkTable` of a function; 1: verdict; 2: all functions",
             "`Distance`, the function, `Theoretical`, `Mean`, `Low`, `High`, `GlobalLow`, `GlobalHigh`; `Verdict`, "
             "`Pattern`, `PValue`, `OutsideFrom`, `OutsideTo`")],
        fed_by=[SITES],
        small={"SetNumberOfSteps": (16,), "SetNumberOfSimulations": (19,)},
        inputs=lambda h: (h.make("vtkQuadratPointSource"),),
        variants=[{"SetFunction": (2,), "SetEdgeCorrection": (3,)},
                  {"SetFunction": (5,), "SetNumberOfSimulations": (19,)},
                  {"SetFunction": (0,), "SetEdgeCorrection": (1,), "SetSeed": (2,)}],
        mistakes=[
            Mistake("PointPatternStatistics", lambda pv: dict(Input=pv.PointSource()), "at least 5"),
            Mistake("PointPatternStatistics", lambda pv: dict(Input=pv.sites(), Function="Mark Correlation"),
                    "MarkArray")]),
    Row("vtkPointProcessSource", "Point patterns",
        takes="none, or a `vtkTable` of verdicts; optional `vtkImageData` of the intensity and `vtkPolyData` of the "
              "window",
        gives=[("`vtkPolyData`, vertices", "`SiteId`; `ClusterId`, `Species`, `Mark`; field data `IsExact`")],
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
    Row("vtkPatternVerdictFilter", "Point patterns", takes="`vtkPointSet`; optional `vtkPolyData`, the window",
        gives=[
            ("0: `vtkTable` of processes and laws, best first",
             "`Law`, `Kind`, `Verdict`, `PValue`, `ProcessId`, `LawId`, the parameters; field data `Window`"),
            ("1: `vtkTable`, the function and its envelope",
             "`Distance` [m], `Measured`, `Theoretical`, `Mean`, `GlobalLow`, `GlobalHigh`")],
        fed_by=["vtkPointProcessSource"],
        small={"SetNumberOfSimulations": (19,)},
        inputs=lambda h: (h.make("vtkPointProcessSource", SetSize=(80.0, 60.0), SetIntensity=(0.02,)),),
        variants=[{"SetNumberOfSimulations": (19,)}, {"SetNumberOfSimulations": (19,), "SetFunction": (1,)},
                  {"SetNumberOfSimulations": (19,), "SetContrast": (1,), "SetSeed": (2,)}],
        mistakes=[Mistake("PatternVerdict", lambda pv: dict(Input=pv.PointSource()), "at least 5")],
        shown={"PatternVerdict": lambda pv: dict(Input=pv.PointProcess(Size=[150, 150]))}),
    # Stands ----------------------------------------------------------------------------------------------------------
    Row("vtkStandInventoryFilter", "Stands", takes="`vtkTable`, an inventory; optional `vtkTable` of species",
        gives=[
            ("`vtkPolyData`, vertices",
             "`SiteId`, `Species`, `DBH`, `Height`, `CrownDiameter` [m], `Plot`, `Drawn`, `SpeciesName`; field data "
             "`Kinds`, `Plots`, `Unlisted`, `RowsDropped`, `Area` [m²]")],
        fed_by=[SEA],
        small={"SetXColumn": ("Direction",), "SetYColumn": ("Phase",), "SetHeightColumn": ("Phase",)},
        inputs=lambda h: (h.inventory(),),
        variants=[{"SetSeed": (2,)}, {"SetHeightVariation": (0.3,)}, {"SetPlot": ("B",), "SetMeanDiameter": (0.4,)}],
        mistakes=[
            Mistake("StandInventory", lambda pv: dict(Inventory=pv.inventory("east,north,species,dbh")),
                    "no columns x and y"),
            Mistake("StandInventory", lambda pv: dict(Inventory=pv.inventory(), DiameterUnit="Metre"),
                    "set DiameterUnit")],
        shown={"StandInventory": lambda pv: dict(Inventory=pv.many_trees())}),
    Row("vtkSitePreferenceFilter", "Stands",
        takes="sites; `vtkImageData`, a terrain; optional `vtkTable` of preferences",
        gives=[
            ("`vtkPolyData`, vertices",
             "those of the sites, `SiteId`, `Species`, `Elevation` [m], `Slope`, `Aspect` [degrees], `RGB`, "
             "`Wetness`; field data `SpeciesNames`")],
        fed_by=[SITES, TERRAIN],
        inputs=lambda h: (h.make("vtkQuadratPointSource", SetSize=(40.0, 40.0)), h.terrain()),
        variants=[{"SetSeed": (2,)}, {"SetThins": (True,)}, {"SetThins": (True,), "SetSeed": (3,)}],
        mistakes=[Mistake("SitePreference", lambda pv: dict(Sites=pv.sites()), "there is no terrain"),
                  Mistake("SitePreference", lambda pv: dict(Sites=pv.sites(), Terrain=pv.image()), "one layer")]),
    # Plants ----------------------------------------------------------------------------------------------------------
    Row("vtkReevesTreeSource", "Plants",
        gives=[("as `vtkGardnerPlantSource`", "as `vtkGardnerPlantSource`")],
        small={"SetPreset": (0,), "SetOrders": (2,), "SetMainBranches": (3,), "SetSideBranches": (2,),
               "SetNumberOfLeaves": (12,), "SetTextureSize": (16, 8)},
        variants=[{"SetPreset": (1,), "SetSeed": (2,)}, {"SetPreset": (3,)}, {"SetPreset": (0,), "SetOrders": (2,)}],
        mistakes=[Mistake("ReevesTree", lambda pv: dict(Preset="Custom", Height=-1.0), "Height")]),
    Row("vtkAonoKuniiTreeSource", "Plants",
        gives=[
            ("0: `vtkMultiBlockDataSet` `High`, `Medium`, `Low`",
             "`RGB`; `High`: `ParentId`, `Radius` [m], `JointIds`, `JointWeights`"),
            ("1, 2: `vtkImageData`, textures of the crown and of a leaf", "RGBA")],
        small={"SetPreset": (0,), "SetIterations": (3,), "SetNumberOfLeaves": (12,), "SetTextureSize": (16, 8)},
        variants=[{"SetPreset": (1,), "SetSeed": (2,)}, {"SetPreset": (9,)},
                  {"SetPreset": (0,), "SetIterations": (4,)}],
        mistakes=[Mistake("AonoKuniiTree", lambda pv: dict(Variation=2.0), "Variation")]),
    Row("vtkGardnerPlantSource", "Plants",
        gives=[
            ("0: `vtkMultiBlockDataSet`, blocks `High`, `Medium`, `Low`",
             "`RGB`, `Normals`, `TCoords`, `JointIds`, `JointWeights`; on the skeleton `ParentId`, `Radius` [m], "
             "`BranchId`, `Order`"),
            ("1, 2: `vtkImageData`, textures of the crown and of the leaves", "`Texture` unsigned char, RGBA")],
        small={"SetPreset": (0,), "SetHeight": (40.0,), "SetCrownBase": (35.0,), "SetCrownRadius": (1.0,),
               "SetNumberOfQuadrics": (2,), "SetShells": (2,), "SetTerms": (4,), "SetTextureSize": (16, 8)},
        variants=[{"SetPreset": (2,)}, {"SetSeed": (5,)}, {"SetPreset": (0,), "SetTerms": (6,), "SetShells": (2,)}],
        mistakes=[Mistake("GardnerPlant", lambda pv: dict(Preset="Custom", CrownRadius=-1.0), "CrownRadius")]),
    Row("vtkPlantScatterFilter", "Plants", takes="sites, prototypes, and an optional terrain",
        gives=[
            ("0: `vtkMultiBlockDataSet`, blocks `High`, `Medium`, `Low`",
             "as the prototypes; field data `SiteId`, `Species`, `Position` ... and counters"),
            ("1, 2: `vtkImageData`, texture atlases of all crowns and of all leaves", "RGBA")],
        fed_by=[SITES, TREE, TERRAIN],
        inputs=lambda h: (h.make("vtkQuadratPointSource"), h.tree()),
        variants=[{"SetSeed": (2,)}, {"SetUseLevels": (False,), "SetUseCulling": (False,)},
                  {"SetViewPoint": (50.0, 50.0, 9.0)}],
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
        gives=[
            ("`vtkImageData`",
             "`Velocity` [m/s]; field data `CoherenceError`, `FrictionVelocity`, `ConvectionSpeed`, `Period`, and "
             "the parameters of the model")],
        small={"SetDimensions": (16, 4, 4)},
        variants=[{"SetDimensions": (32, 4, 4), "SetSpectrum": (1,)}, {"SetDimensions": (32, 4, 4), "SetSeed": (2,)},
                  {"SetDimensions": (32, 4, 4), "SetCoherence": (1,), "SetNormalizeVariance": (True,)}],
        mistakes=[Mistake("WindField", lambda pv: dict(ReferenceSpeed=-1.0), "ReferenceSpeed")]),
    Row("vtkWindStatisticsFilter", "Wind and sway", takes="`vtkImageData`, a wind field",
        gives=[
            ("0: `vtkTable` of spectra",
             "`Frequency` [Hz], `Along`, `Across`, `Up`, `AlongModel`, `AcrossModel`, `UpModel` [m²/s²/Hz]"),
            ("1: `vtkTable` of root coherence", "as 0"),
            ("2: `vtkTable` of layers", "`Height` [m], `Speed`, `SpeedModel`, `AlongDeviation` ... [m/s]")],
        fed_by=[WIND],
        inputs=lambda h: (h.wind(),),
        variants=[{"SetHeight": (3.0,)}, {"SetSeparation": (0.0, 2.0)}, {"SetNumberOfBands": (6,)}],
        mistakes=[Mistake("WindStatistics", lambda pv: dict(Input=pv.image()), "Velocity")]),
    Row("vtkImageSectionFilter", "Wind and sway", takes="`vtkImageData`",
        gives=[("`vtkPolyData`, sections", "as the input")],
        fed_by=[WIND],
        inputs=lambda h: (h.wind(),),
        variants=[{"SetCrossSections": (1,)}],
        mistakes=[Mistake("ImageSections", lambda pv: dict(Input=pv.image(), CrossSections=-1), "CrossSections")]),
    Row("vtkBeamTreeDeformationFilter", "Wind and sway",
        takes="`vtkMultiBlockDataSet`, a plant or a forest; `vtkImageData`, a wind; optional prototypes",
        gives=[
            ("0: the plants at the requested time",
             "as the input plants; field data `Frequency` [Hz] of trunks; `TCoords` of Medium/Crown select the "
             "texture of that time"),
            ("1: `vtkImageData`, textures of the moving crowns", "RGBA")],
        fed_by=[TREE, WIND],
        small={"SetTextureSize": (16, 8)},
        inputs=lambda h: (h.tree(), h.wind()),
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
    Row("vtkSeaStateSource", "Sea", takes="none, or a `vtkTable` of a spectrum",
        gives=[
            ("`vtkTable` of wave trains",
             "`Amplitude` [m], `AngularFrequency` [rad/s], `WaveNumber` [rad/m], `Direction`, `Phase` [rad]; field "
             "data `SignificantWaveHeight`, `PeakPeriod`, `Period`, `EnergyLeftOut`, `WaterDepth`, `SeaLevel`, "
             "`BinEdges` [Hz], `SpectralDensity` [m²/Hz]")],
        small={"SetNumberOfTrains": (8,), "SetSeaLevel": (4.0,)},
        variants=[{"SetSpectrum": (1,)}, {"SetSeed": (2,), "SetWaterDepth": (5.0,)}, {"SetSeaBy": (1,)}],
        mistakes=[
            Mistake("MeasuredSeaState", lambda pv: dict(Input=pv.QuadratAnalysis(Input=pv.sites())),
                    "Frequency and Density"),
            Mistake("SeaState", lambda pv: dict(WindSpeed=-1.0), "WindSpeed")],
        shown={"MeasuredSeaState": lambda pv: dict(Input=pv.measured_spectrum())}),
    Row("vtkSeaStatisticsFilter", "Sea", takes="`vtkTable`, a sea state",
        gives=[("0: `vtkTable`, the spectrum", "`Frequency` [Hz], `Spectrum`, `Trains` [m²/Hz]"),
               ("1: `vtkTable` of directions", "`Direction` [degrees], `Spreading`, `Trains` [1/degree]")],
        fed_by=[SEA],
        inputs=lambda h: (h.sea(),),
        variants=[{"SetNumberOfSectors": (4,)}, {"SetNumberOfSectors": (36,)}, {"SetNumberOfSectors": (90,)}],
        mistakes=[Mistake("SeaStatistics", lambda pv: dict(Input=pv.QuadratAnalysis(Input=pv.sites())), "Amplitude")]),
    Row("vtkSeaSurfaceFilter", "Sea", takes="`vtkTable`, a sea state",
        gives=[("`vtkPolyData`, a disk out to the horizon at the requested time", "`Normals`, `Jacobian`, `RGB`")],
        fed_by=[SEA],
        small={"SetSectors": (12,), "SetRadius": (40.0,)},
        inputs=lambda h: (h.sea(),),
        variants=[{"SetSpacing": (1.0,), "SetSectors": (90,)}, {"SetCenter": (70.0, -20.0), "SetRadius": (300.0,)},
                  {"SetChoppiness": (0.5,), "SetWaterColors": (False,)}],
        mistakes=[Mistake("SeaSurface", lambda pv: dict(Input=pv.QuadratAnalysis(Input=pv.sites())), "Amplitude"),
                  Mistake("SeaSurface", lambda pv: dict(Input=pv.SeaState(), Spacing=-1.0), "Spacing")]),
    Row("vtkParticleOrbitFilter", "Sea", takes="0: `vtkPointSet`, or levels of detail; 1: `vtkTable`, a sea state",
        gives=[
            ("as input 0",
             "`Center` [m]; on request `Velocity` [m/s], `Acceleration` [m/s²]; on a surface `Normals`, `Jacobian`")],
        fed_by=[PARTICLES, SEA],
        inputs=lambda h: (h.particles(), h.sea()),
        variants=[{"SetStokesDrift": (True,)}, {"SetDopplerShift": (True,), "SetCurrent": (0.5, 0.1)},
                  {"SetGenerateAcceleration": (True,)}],
        mistakes=[
            Mistake("ParticleOrbits", lambda pv: dict(Input=pv.particles()), "There is no sea state", UNMOVED),
            Mistake("ParticleOrbits",
                    lambda pv: dict(Input=pv.particles(), SeaState=pv.QuadratAnalysis(Input=pv.sites())),
                    "Amplitude")]),
    # Currents --------------------------------------------------------------------------------------------------------
    Row("vtkFlowPrimitiveSource", "Currents",
        gives=[
            ("`vtkPolyData`, one vertex",
             "`FlowType`, `Strength`, `Axis`, `CoreRadius` [m], `InfluenceRadius` [m], `InfluenceBox`, "
             "`InfluenceMargin` [m]")],
        variants=[{"SetFlowType": (1,)}, {"SetFlowType": (2,)}, {"SetStrength": (3.0,)}],
        mistakes=[Mistake("FlowPrimitive", lambda pv: dict(FlowType="Vortex", CoreRadius=-1.0), "CoreRadius")]),
    Row("vtkFlowArrowFilter", "Currents", takes="`vtkPolyData` of flow primitives",
        gives=[("`vtkPolyData`, arrows and rings", "`Speed` [m/s], `RGB`")],
        fed_by=[FLOW],
        inputs=lambda h: (h.make("vtkFlowPrimitiveSource", SetFlowType=(3,)),),
        mistakes=[Mistake("FlowArrows", lambda pv: dict(Input=pv.Sphere()), "FlowType")],
        shown={"FlowArrows": lambda pv: dict(Input=pv.FlowPrimitive(FlowType="Vortex"))}),
    Row("vtkCurrentDriftFilter", "Currents",
        takes="0: `vtkPointSet` or blocks; 1: any number of flow primitives, and data sets with velocities",
        gives=[("as input 0", "`Captured`; on request `Current` [m/s]")],
        fed_by=[PARTICLES, FLOW],
        inputs=lambda h: (h.particles(), h.current()),
        variants=[{"SetStartTime": (0.5,)}, {"SetStartTime": (-2.0,), "SetTimeStep": (0.25,)},
                  {"SetGenerateCurrent": (True,)}],
        mistakes=[
            Mistake("CurrentDrift", lambda pv: dict(Input=pv.particles(), Currents=[pv.image()]), "velocities"),
            Mistake("CurrentDrift",
                    lambda pv: dict(Input=pv.particles(), Currents=[pv.FlowPrimitive()], TimeStep=-1.0), "TimeStep")],
        shown={"CurrentDrift": lambda pv: dict(
                   Input=pv.SuspendedParticles(Bounds=[-4, 4, -2, 2, -5, 0], Density=30),
                   Currents=pv.FlowPrimitive(FlowType="Vortex", Center=[0, 0, -2.5], Axis=[0, 1, 0], Strength=0.5))}),
    # Particles -------------------------------------------------------------------------------------------------------
    Row("vtkSuspendedParticleSource", "Particles",
        gives=[
            ("0: `vtkPolyData`, vertices or squares",
             "`ParticleId`, `BoxId`, `ParticleType`, `Radius` [m], `RGB`; on squares `MasterId`, `Offset` [m], "
             "texture coordinates"),
            ("1: `vtkImageData`, textures", "RGBA")],
        small={"SetDensity": (0.02,)},
        variants=[{"SetPreset": (3,)}, {"SetSeed": (2,), "SetMode": (1,)},
                  {"SetDensity": (0.5,), "SetSizeSpread": (0.4,)}],
        mistakes=[Mistake("SuspendedParticles", lambda pv: dict(SizeSpread=-1.0), "SizeSpread")]),
    Row("vtkParticleLevelOfDetailFilter", "Particles", takes="0: `vtkPointSet`; 1: `vtkTable`, a sea state",
        gives=[
            ("`vtkMultiBlockDataSet`: `Near`, `MasterSlave`, `Far`",
             "`Alpha`, `TrainCount`, `ErrorBound` [m], `MasterId`, `Offset` [m], `ParticleId`; field data "
             "`TrainOrder`, counters")],
        fed_by=[PARTICLES, SEA],
        inputs=lambda h: (h.particles(), h.sea()),
        variants=[{"SetViewPoint": (5.0, 5.0, -3.0)}, {"SetViewPoint": (5.0, 5.0, -3.0), "SetSlavesPerMaster": (2,)},
                  {"SetViewPoint": (1.0, 1.0, -1.0), "SetUseLevels": (False,)}],
        mistakes=[
            Mistake("ParticleLevelOfDetail", lambda pv: dict(Input=pv.particles()), "there is no sea state"),
            Mistake("ParticleLevelOfDetail",
                    lambda pv: dict(Input=pv.particles(), SeaState=pv.QuadratAnalysis(Input=pv.sites())),
                    "Amplitude")]),
    Row("vtkParticleFogFilter", "Particles", takes="`vtkPointSet`, or levels of detail",
        gives=[("`vtkImageData`", "`Extinction` float [1/m]")],
        fed_by=[PARTICLES],
        small={"SetDimensions": (6, 5, 4)},
        inputs=lambda h: (h.particles(),),
        variants=[{"SetGridBy": (0,), "SetDimensions": (8, 9, 10)},
                  {"SetGridBy": (1,), "SetUseBounds": (True,), "SetSpacing": (0.7,)}, {"SetWaterExtinction": (0.4,)}],
        mistakes=[Mistake("ParticleFog", lambda pv: dict(Input=pv.particles(), ParticleRadius=-1.0),
                          "ParticleRadius")]),
    # Seaweeds --------------------------------------------------------------------------------------------------------
    Row("vtkSeaweedSource", "Seaweeds",
        gives=[
            ("as `vtkGardnerPlantSource`; 1, 2: textures of a blade",
             "as `vtkGardnerPlantSource`; on the skeleton also `Tissue`, `Width`, `Thickness`, `Length`, "
             "`Attachment` [m], `Across`, `YoungModulus` [Pa], `DampingRatio`, `Density` [kg/m³], `RestTheta`, "
             "`RestPhi` [rad]")],
        small={"SetSegmentsPerBranch": (4,), "SetTextureSize": (16, 8)},
        variants=[{"SetPreset": (3,)}, {"SetPreset": (2,), "SetSeed": (3,)}, {"SetSegmentsPerBranch": (4,)}],
        mistakes=[Mistake("Seaweed", lambda pv: dict(SegmentsPerBranch=0), "SegmentsPerBranch")]),
    Row("vtkSeaweedDeformationFilter", "Seaweeds", takes="0: seaweeds; 1: a sea state; 2: any number of currents",
        gives=[
            ("the plants at the requested time",
             "as the input plants; on request `Velocity`, `Acceleration` of Skeleton")],
        fed_by=[SEAWEED, SEA],
        small={"SetGenerateMotion": (True,)},
        inputs=lambda h: (h.seaweed(), h.sea(4.0)),
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
    Row("vtkPlantWakeFilter", "Seaweeds", takes="moving plants, with *Generate Motion* on",
        gives=[("flow primitives", "as flow primitives; `PlantId`")],
        fed_by=["vtkSeaweedDeformationFilter"],
        inputs=lambda h: (h.make("vtkSeaweedDeformationFilter", (h.seaweed(), h.sea(4.0)), SetGenerateMotion=(True,))),
        variants=[{"SetPrimitive": (1,)}, {"SetStrength": (2.0,)}, {"SetMargin": (1.0,)}],
        mistakes=[Mistake("PlantWake", lambda pv: dict(Input=pv.tree()), "GenerateMotion"),
                  Mistake("PlantWake", lambda pv: dict(Input=pv.blocks()), "High/Skeleton")],
        shown={"PlantWake": lambda pv: dict(
                   Input=pv.SeaweedDeformation(Input=pv.Seaweed(),
                                               SeaState=pv.SeaState(WindSpeed=5, SeaLevel=6, WaterDepth=6),
                                               GenerateMotion=1))}),
    # Rasters ---------------------------------------------------------------------------------------------------------
    Row("vtkElevationReader", "Rasters", takes="GeoTIFF, ASCII grid, SRTM tile, netCDF and other rasters",
        gives=[
            ("`vtkImageData`",
             "`Elevation` [m], holes as NaN; field data `CoordinateSystem`, `CoordinateUnit`, `CoordinateOffset`")],
        small={"SetFileName": (str(HERE / "Fuzz" / "hills.asc"),)}),
    Row("vtkElevationWriter", "Rasters", takes="`vtkImageData` of one layer",
        gives=[("a `.tif` file", "heights [m] in their place on earth")],
        fed_by=[TERRAIN],
        small={"SetFileName": ("terrain.tif",)}),
    # Volumes ---------------------------------------------------------------------------------------------------------
    Row("vtkVDBVolumeWriter", "Volumes", takes="`vtkImageData`, or blocks of them",
        gives=[("a `.vdb` file", "one grid per array; metadata `unit`, `time`, and the field data")],
        fed_by=[WIND],
        small={"SetFileName": ("wind.vdb",)}),
    # Scenes ----------------------------------------------------------------------------------------------------------
    Row("vtkGLTFSceneWriter", "Scenes",
        takes="any number of `vtkPolyData`, terrains as `vtkImageData`, or blocks of them",
        gives=[
            ("a `.glb` file",
             "meshes with normals, texture coordinates and colors; on request `_VELOCITY`; instances with `_TINT`, "
             "levels, joints and their motion")],
        fed_by=[TREE],
        small={"SetFileName": ("tree.glb",), "SetWriteMotion": (True,), "SetEndTime": (0.1,),
               "SetWriteCamera": (True,), "SetWriteSun": (True,)}),
]
BY_NAME = {row.name: row for row in ROWS}
