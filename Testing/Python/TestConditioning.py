# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Fields through data: kriging against its system solved by NumPy and against gstat (R, where it is there), 500 conditional
fields (or the number that is given) against both, data met, holes filled, normal scores, and each bad input refused by one
sentence.
"""
# run-with: python3 args=200
# run-with: python3 tier=all

import shutil
import subprocess
import sys

import numpy as np
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData, vtkTable

from littoral import vtkConditionalTerrainFilter, vtkCovarianceFitFilter, vtkNormalScoresFilter
from littoral import vtkTurningBandsTerrainSource
from littoral.tables import column

SIZE, SPACING, DEVIATION, RANGE = 25, 2.0, 3.0, 12.0


def points_of(xy, values, name="Elevation", **others):
    """Points with values, and other arrays."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(np.column_stack([xy, np.zeros(len(xy))]), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    for key, numbers in {name: values, **others}.items():
        array = numpy_to_vtk(np.asarray(numbers, float), deep=True)
        array.SetName(key)
        data.GetPointData().AddArray(array)
    data.GetPointData().SetActiveScalars(name)
    return data


def grid_of(size=SIZE, spacing=SPACING, values=None):
    """An image of one layer."""
    image = vtkImageData()
    image.SetDimensions(size, size, 1)
    image.SetSpacing(spacing, spacing, 1.0)
    if values is not None:
        array = numpy_to_vtk(np.asarray(values, float).ravel(), deep=True)
        array.SetName("Elevation")
        image.GetPointData().SetScalars(array)
    return image


def conditional(data, grid=None, **settings):
    """A filter with an exponential model."""
    made = vtkConditionalTerrainFilter()
    made.SetInputData(0, data)
    if grid is not None:
        made.SetInputData(1, grid)
    made.SetModelToSimpleExponential()
    made.SetStandardDeviation(DEVIATION)
    made.SetRange(RANGE)
    for name, value in settings.items():
        getattr(made, "Set" + name)(*value if isinstance(value, tuple) else (value,))
    return made


def values_of(made, name="Elevation"):
    """A point array of the image."""
    made.Update()
    return vtk_to_numpy(made.GetOutput().GetPointData().GetArray(name)).copy()


def table_of(made):
    """Output 1."""
    return made.GetOutputDataObject(1)


# A survey of twelve data, four at points of the grid, one outside.
random = np.random.default_rng(7)
xy = np.vstack([random.uniform(0.0, 48.0, (7, 2)), [[4.0, 6.0], [20.0, 20.0], [22.0, 20.0], [48.0, 0.0], [57.0, 30.0]]])
heights = 100.0 + 3.0 * random.normal(size=len(xy))
survey = points_of(xy, heights)
nodes = SPACING * np.column_stack([np.tile(np.arange(SIZE), SIZE), np.repeat(np.arange(SIZE), SIZE)])


def covariance(a, b):
    """Exponential covariances of places."""
    return DEVIATION**2 * np.exp(-np.hypot(*(a[:, None, :] - b[None, :, :]).transpose(2, 0, 1)) / RANGE)


# Ordinary kriging, with the Lagrange factor, by NumPy ---------------------------------------------
count = len(xy)
system = np.ones((count + 1, count + 1))
system[:count, :count] = covariance(xy, xy)
system[count, count] = 0.0
right = np.vstack([covariance(xy, nodes), np.ones(len(nodes))])
weights = np.linalg.solve(system, right)
estimate = weights[:count].T @ heights
variance = DEVIATION**2 - np.einsum("ij,ij->j", weights, right)

kriging = conditional(survey, grid_of(), Result=1, KrigingVariance=True)
assert np.allclose(values_of(kriging), estimate, rtol=0.0, atol=1e-7)
assert np.allclose(values_of(kriging, "KrigingVariance"), variance, rtol=0.0, atol=1e-6)

# The same by gstat --------------------------------------------------------------------------------
SCRIPT = """
suppressMessages({library(sp); library(gstat)})
d <- read.table(file("stdin"), header = TRUE)
s <- d[d$known == 1, ]; n <- d[d$known == 0, ]
coordinates(s) <- ~x+y; coordinates(n) <- ~x+y
k <- krige(z ~ 1, s, n, vgm(9, "Exp", 12), debug.level = 0)
write.table(format(cbind(k$var1.pred, k$var1.var), digits = 15), row.names = FALSE, col.names = FALSE, quote = FALSE)
"""
if shutil.which("Rscript") and not subprocess.run(
        ["Rscript", "-e", "library(gstat)"], capture_output=True, check=False).returncode:
    ROWS = "x y z known\n" + "\n".join(
        [f"{x!r} {y!r} {z!r} 1" for (x, y), z in zip(xy.tolist(), heights.tolist())]
        + [f"{x!r} {y!r} 0 0" for x, y in nodes.tolist()])
    answer = subprocess.run(["Rscript", "-e", SCRIPT], input=ROWS, capture_output=True, text=True, check=True).stdout
    peer = np.array([line.split() for line in answer.splitlines()], float)
    assert np.allclose(peer[:, 0], estimate, rtol=0.0, atol=1e-8), abs(peer[:, 0] - estimate).max()
    assert np.allclose(peer[:, 1], variance, rtol=0.0, atol=1e-8), abs(peer[:, 1] - variance).max()
    print("gstat agrees")
else:
    print("gstat is not there: compared with NumPy alone")

# Conditional fields -------------------------------------------------------------------------------
FIELDS = int(sys.argv[1]) if len(sys.argv) > 1 else 500
through = conditional(survey, grid_of())
fields = np.empty((FIELDS, len(nodes)))
miss = 0.0
for n in range(FIELDS):
    through.SetSeed(n + 1)
    fields[n] = values_of(through)
    miss = max(miss, abs(column(table_of(through), "Field") - heights).max())
assert miss <= 1e-9 * DEVIATION, miss
inside = [np.flatnonzero((nodes == place).all(axis=1))[0] for place in xy[7:11]]
assert abs(fields[:, inside] - heights[7:11]).max() <= 1e-9 * DEVIATION
free = variance > 1e-6
errors = (fields.mean(axis=0) - estimate)[free] / np.sqrt(variance[free] / FIELDS)
ratio = fields.var(axis=0, ddof=1)[free].sum() / variance[free].sum()
print(f"mean off by {np.sqrt((errors**2).mean()):.2f} standard errors, at most {abs(errors).max():.2f}; "
      f"variance {ratio:.3f} of kriging's; data missed by {miss:.1e}")
# Three standard errors at 25 places all over the grid; of all nodes, a normal distribution leaves 0.27 % beyond.
spread = np.zeros((SIZE, SIZE), bool)
spread[2::5, 2::5] = True
assert abs(errors[spread.ravel()[free]]).max() <= 3.0
assert (abs(errors) > 3.0).mean() <= 0.005 and (errors**2).mean() <= 1.5
assert abs(ratio - 1.0) <= 0.05
# Near the data between points, too, where short waves count.
near = free & (np.hypot(*(nodes[:, None] - xy[None, :7]).transpose(2, 0, 1)).min(axis=1) < 1.5)
assert near.sum() >= 5
assert abs(fields.var(axis=0, ddof=1)[near].sum() / variance[near].sum() - 1.0) <= 0.1

# The unconditional field is that of the source: the difference is smooth away from the data -----
source = vtkTurningBandsTerrainSource()
source.SetWholeExtent(0, SIZE - 1, 0, SIZE - 1, 0, 0)
source.SetSpacing(SPACING, SPACING, 1.0)
source.SetModelToSimpleExponential()
source.SetStandardDeviation(DEVIATION)
source.SetRange(RANGE)
source.SetMean(0.0)
source.Update()
grown = vtk_to_numpy(source.GetOutput().GetPointData().GetScalars())
through.SetSeed(1)
simple = conditional(points_of([[1e4, 1e4]], [0.0]), grid_of(), KrigingType=0, Mean=0.0)
assert np.allclose(values_of(simple), grown, rtol=0.0, atol=1e-6)

# Parts are parts of the whole ---------------------------------------------------------------------
whole = values_of(through).reshape(SIZE, SIZE)
part = conditional(survey, grid_of())
part.UpdateExtent((5, 11, 3, 20, 0, 0))
own = vtk_to_numpy(part.GetOutput().GetPointData().GetScalars()).reshape(18, 7)
assert (own == whole[3:21, 5:12]).all()

# Errors of data: what they leave is the kriging variance of the field, and data are not met -------
noisy = conditional(points_of(xy, heights, Error=np.full(count, 2.0)), grid_of(), Result=1, KrigingVariance=True,
                    ErrorArray="Error")
system[:count, :count] += 4.0 * np.eye(count)
weights = np.linalg.solve(system, right)
assert np.allclose(values_of(noisy), weights[:count].T @ heights, rtol=0.0, atol=1e-7)
assert np.allclose(
    values_of(noisy, "KrigingVariance"), DEVIATION**2 - np.einsum("ij,ij->j", weights, right), rtol=0.0, atol=1e-6)

# An external drift that the data are a multiple of is the field -----------------------------------
drift = np.sin(nodes[:, 0] / 9.0) + 0.02 * nodes[:, 1]
on_nodes = np.arange(3, SIZE * SIZE, 41)
drifted = conditional(points_of(nodes[on_nodes], 5.0 + 2.0 * drift[on_nodes]), grid_of(values=drift),
                      KrigingType=4, Result=1)
assert np.allclose(values_of(drifted), 5.0 + 2.0 * drift, rtol=0.0, atol=1e-6)

# By its name among the arrays of the grid, whatever array of errors there is
two = grid_of(values=drift - 7.0 * nodes[:, 0])
named = numpy_to_vtk(drift, deep=True)
named.SetName("Coarse")
two.GetPointData().AddArray(named)
chosen = conditional(points_of(nodes[on_nodes], 5.0 + 2.0 * drift[on_nodes], Error=np.full(len(on_nodes), 1e-6)), two,
                     KrigingType=4, Result=1, ErrorArray="Error", DriftArray="Coarse")
assert np.allclose(values_of(chosen), 5.0 + 2.0 * drift, rtol=0.0, atol=1e-4)
chosen.SetDriftArray("")
assert not np.allclose(values_of(chosen), 5.0 + 2.0 * drift, rtol=0.0, atol=1e-1)

# Holes of a raster --------------------------------------------------------------------------------
place = grown.astype(float).reshape(SIZE, SIZE).copy()
place[8:12, 9:15] = np.nan
holes = conditional(grid_of(values=place), Result=1, NumberOfNeighbors=40)
filled = values_of(holes).reshape(SIZE, SIZE)
known = np.isfinite(place)
assert (filled[known] == place[known]).all() and np.isfinite(filled).all()
others = np.argsort(np.hypot(nodes[:, 0] - 22.0, nodes[:, 1] - 18.0), kind="stable")
others = np.array([n for n in others if known.ravel()[n]])[:60]
assert abs(filled[9, 11] - place.ravel()[others].mean()) < 2.0 * DEVIATION

# Cross-validation: leave one out, indeed ----------------------------------------------------------
checked = conditional(survey, grid_of(5), CrossValidation=True)
checked.Update()
left = column(table_of(checked), "LeaveOneOutEstimate")
rest = np.arange(count) != 9
alone = conditional(points_of(xy[rest], heights[rest]), grid_of(), Result=1)
assert abs(values_of(alone)[inside[2]] - left[9]) < 1e-6
told = table_of(checked).GetFieldData().GetArray("RootMeanSquareError").GetValue(0)
assert abs(told - np.sqrt(((heights - left)**2).mean())) < 1e-9

# Normal scores: a skewed survey stays skewed and is met; the way back gives the distribution ------
skewed = np.exp(random.normal(size=60))
spots = random.uniform(0.0, 48.0, (60, 2))
bounded = conditional(points_of(spots, skewed), grid_of(), NormalScores=True)
made = values_of(bounded)
assert made.min() >= skewed.min() and made.max() <= skewed.max()
assert abs(column(table_of(bounded), "Field") - skewed).max() <= 1e-9 * skewed.std()
scored = vtkNormalScoresFilter()
scored.SetInputData(grid_of(values=np.exp(grown / 3.0)))
scored.Update()
scores = vtk_to_numpy(scored.GetOutput().GetPointData().GetArray("NormalScores"))
assert abs(scores.mean()) < 1e-6 and abs(scores.std() - 1.0) < 0.01
assert (np.argsort(scores, kind="stable") == np.argsort(np.exp(grown / 3.0).astype(float), kind="stable")).all()
back = vtkNormalScoresFilter()
back.InverseOn()
back.SetInputConnection(scored.GetOutputPort())
back.SetInputData(1, grid_of(values=np.exp(grown / 3.0)))
back.Update()
assert np.allclose(vtk_to_numpy(back.GetOutput().GetPointData().GetArray("Elevation")), np.exp(grown / 3.0), rtol=1e-12)

# A twin of a place whose heights are lognormal, by its scores: the place's distribution, and none of its places
lognormal = vtkTurningBandsTerrainSource()
lognormal.SetWholeExtent(0, 199, 0, 179, 0, 0)
lognormal.SetSpacing(SPACING, SPACING, 1.0)
lognormal.SetModelToSimpleExponential()
lognormal.SetStandardDeviation(0.7)
lognormal.SetRange(3.0)
lognormal.SetMean(5.0)
lognormal.Update()
rough = vtkImageData()
rough.ShallowCopy(lognormal.GetOutput())
known = np.exp(vtk_to_numpy(rough.GetPointData().GetScalars()).astype(float))
array = numpy_to_vtk(known, deep=True)
array.SetName("Elevation")
rough.GetPointData().SetScalars(array)
scored = vtkNormalScoresFilter()
scored.SetInputData(rough)
fit = vtkCovarianceFitFilter()
fit.SetInputConnection(scored.GetOutputPort())
twin = vtkTurningBandsTerrainSource()
twin.SetInputConnection(fit.GetOutputPort(0))
twin.UseMeasuredGridOn()
twin.SetSeed(7)
back = vtkNormalScoresFilter()
back.SetInputConnection(twin.GetOutputPort())
back.SetInputData(1, rough)
back.InverseOn()
back.Update()
grown_again = vtk_to_numpy(back.GetOutput().GetPointData().GetScalars())
levels = np.quantile(known, np.linspace(0.02, 0.98, 49))
off = max(abs((grown_again < level).mean() - (known < level).mean()) for level in levels)
gaussian = vtk_to_numpy(twin.GetOutput().GetPointData().GetScalars()).astype(float)
of_gauss = max(abs((gaussian * known.std() + known.mean() < level).mean() - (known < level).mean()) for level in levels)
print(f"distribution of a twin by normal scores: off by {off:.3f}, without by {of_gauss:.3f}")
assert off < 0.04 and of_gauss > 0.1
assert abs(np.corrcoef(grown_again, known)[0, 1]) < 0.2

# A fit of the data, and a table of fits -----------------------------------------------------------
fit = vtkCovarianceFitFilter()
fit.SetInputConnection(source.GetOutputPort())
fitted = conditional(survey, grid_of())
fitted.SetInputConnection(2, fit.GetOutputPort(0))
fitted.Update()
told = table_of(fitted).GetFieldData()
assert told.GetArray("Range").GetValue(0) == column(fit.GetOutput(), "Range")[0]
automatic = vtkConditionalTerrainFilter()
automatic.SetInputData(points_of(nodes[::7], grown[::7]))
automatic.Update()
assert automatic.GetOutput().GetDimensions() == (301, 301, 1)
ranges = table_of(automatic).GetFieldData().GetArray("Variance").GetValue(0)
assert 1.0 < ranges < 60.0, ranges

# What is refused ----------------------------------------------------------------------------------
def refuses(word, made):
    """One error that holds the word, an empty output, and a good field afterwards."""
    told = []

    @calldata_type(VTK_STRING)
    def note(_, __, text):
        told.append(text)

    observers = made.AddObserver("ErrorEvent", note), made.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    made.Update()
    made.RemoveObserver(observers[0])
    made.GetExecutive().RemoveObserver(observers[1])
    assert len(told) == 1 and word in told[0], (word, told)
    output = made.GetOutputDataObject(0)
    assert output.GetPointData().GetNumberOfArrays() == 0
    if made.IsA("vtkConditionalTerrainFilter"):
        assert table_of(made).GetNumberOfColumns() == 0
        assert made.GetOutputDataObject(2).GetNumberOfPoints() == 0
        fresh = conditional(survey, grid_of())
        for port in 1, 2:
            made.RemoveAllInputConnections(port)
        made.SetInputData(0, survey)
        made.SetInputData(1, grid_of())
        made.SetInputArrayToProcess(0, 0, 0, 0, "Elevation")
        made.SetDriftArray("")
        for name in ("Model", "KrigingType", "Range", "StandardDeviation", "NormalScores", "NumberOfNeighbors",
                     "Nugget", "Result"):
            getattr(made, "Set" + name)(getattr(fresh, "Get" + name)())
        made.SetErrorArray("None")
        assert (values_of(made) == values_of(fresh)).all()


twice = np.vstack([xy, xy[3]])
refuses("contradict", conditional(points_of(twice, np.append(heights, 1.0)), grid_of()))
refuses("same value", conditional(points_of(twice, np.append(heights, heights[3])), grid_of()))
refuses("must be finite", conditional(points_of(xy, np.append(heights[1:], np.nan)), grid_of()))
refuses("outside the Grid", conditional(survey, grid_of(values=drift), KrigingType=4))
refuses("only 1 datum", conditional(points_of(xy[:1], heights[:1]), grid_of(), Model=-1))
refuses("do not vary", conditional(points_of(spots, np.full(60, 4.0)), grid_of(), Model=-1))
refuses("no normal score", conditional(points_of(xy, np.full(count, 4.0)), grid_of(), NormalScores=True))
refuses("on one line", conditional(points_of(np.column_stack([xy[:, 0], 2.0 * xy[:, 0]]), heights), grid_of(),
                                   KrigingType=2))
refuses("singular", conditional(points_of(spots, skewed), grid_of(), Model=2, Range=1e5))
refuses("singular", conditional(points_of(spots, skewed), grid_of(), Model=2, Range=1e5, NumberOfNeighbors=30))
refuses("Nugget", conditional(survey, grid_of(), Nugget=-1.0))
refuses("Model", conditional(survey, grid_of(), Model=9))
refuses("at least one", conditional(points_of(np.empty((0, 2)), []), grid_of()))
refuses("no point array Nothing", conditional(survey, grid_of(), ErrorArray="Nothing"))
wrong = conditional(survey, grid_of())
wrong.SetInputArrayToProcess(0, 0, 0, 0, "Nothing")
refuses("no array 'Nothing'", wrong)
wrong = conditional(survey, grid_of(values=drift), KrigingType=4)
wrong.SetDriftArray("Nothing")
refuses("no point array Nothing", wrong)
# Errors: below 0, NaN, and two data at one place that contradict each other within theirs
for bad in -1.0, np.nan:
    refuses("at least 0", conditional(points_of(xy, heights, Error=np.append(np.ones(count - 1), bad)), grid_of(),
                                      ErrorArray="Error"))
refuses("no meaning for normal scores", conditional(points_of(xy, heights, Error=np.ones(count)), grid_of(),
                                                    ErrorArray="Error", NormalScores=True))
refuses("contradict", conditional(points_of(twice, np.append(heights, 1.0), Error=np.zeros(count + 1)), grid_of(),
                                  ErrorArray="Error"))
# Rasters: all missing, one layer only, no array, too thick
refuses("at least one", conditional(grid_of(values=np.full((SIZE, SIZE), np.nan))))
refuses("without a point array", conditional(grid_of()))
thick = vtkImageData()
thick.SetDimensions(5, 5, 2)
refuses("one layer", conditional(survey, thick))
refuses("must be finite", conditional(points_of([[np.inf, 0.0]], [1.0]), grid_of()))
holed_drift = drift.copy()
holed_drift[3] = np.nan
refuses("must be finite", conditional(survey, grid_of(values=holed_drift), KrigingType=4))
refuses("as Grid", conditional(survey, KrigingType=4))
unfitted = conditional(survey, grid_of())
unfitted.SetInputData(2, vtkTable())
refuses("table of fits is empty", unfitted)
lost = vtkNormalScoresFilter()
lost.SetInputData(grid_of(values=np.full((SIZE, SIZE), 2.0)))
refuses("two different values", lost)
holed = vtkNormalScoresFilter()
holed.SetInputData(grid_of(values=place))
refuses("fill holes first", holed)
orphan = vtkNormalScoresFilter()
orphan.InverseOn()
orphan.SetInputData(grid_of(values=grown))
refuses("Reference", orphan)

# Two data at one place, with errors: kriged from both -------------------------------------------
pair = conditional(points_of([[20.0, 20.0], [20.0, 20.0]], [1.0, 2.0], Error=[0.5, 0.5]), grid_of(), Result=1,
                   ErrorArray="Error")
assert abs(values_of(pair)[10 * SIZE + 10] - 1.5) < 1e-9
# One of them exact: the field is the exact one there
pair.SetInputData(points_of([[20.0, 20.0], [20.0, 20.0]], [1.0, 2.0], Error=[0.5, 0.0]))
assert abs(values_of(pair)[10 * SIZE + 10] - 2.0) < 1e-9

# One row of points, and data on one row ----------------------------------------------------------
row = vtkImageData()
row.SetDimensions(SIZE, 1, 1)
row.SetSpacing(SPACING, SPACING, 1.0)
assert np.allclose(values_of(conditional(survey, row, Result=1)), estimate[:SIZE], rtol=0.0, atol=1e-7)
level = conditional(points_of([[0.0, 3.0], [9.0, 3.0]], [1.0, 2.0]), Dimensions=(4, 3))
assert np.isfinite(values_of(level)).all()

# The data as points: at their values, with the columns of the table ------------------------------
checked.Update()
dots = checked.GetOutputDataObject(2)
assert (vtk_to_numpy(dots.GetPoints().GetData()) == np.column_stack([xy, heights])).all()
assert dots.GetNumberOfVerts() == count
assert (vtk_to_numpy(dots.GetPointData().GetArray("LeaveOneOutEstimate")) == left).all()

# One datum and constant data are fields like others.
one = conditional(points_of([[20.0, 20.0]], [7.0]), grid_of())
assert abs(values_of(one)[10 * SIZE + 10] - 7.0) < 1e-9
flat = conditional(points_of(xy, np.full(count, 4.0)), grid_of(), Result=1)
assert np.allclose(values_of(flat), 4.0, rtol=0.0, atol=1e-8)
