# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# run-with: pvpython together=looks
"""Blocks that carry a texture are drawn with it by the representation Full Surface.

Squares with known texels: the color of a pixel is that of the points times the texel over the mean of the texture, and
nothing where the texel is transparent; visibility, picking and shaders of blocks as without textures. A block that
moves keeps in the graphics' memory what stays, and is seen and picked where it is. TestServer has a server.
"""

import json

import numpy as np
import quick
from paraview import simple
from window import colors

SIZE = 200  # of the window [pixels]; 10 units of the scene

#: A square without a texture at the left; one of 2 x 1 texels in the middle, of which the right one is transparent; a
#: third with normals to +x in its left half and to +y in its right half.
SQUARES = """
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkIntArray, vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

def array(kind, name, rows):
    made = kind()
    made.SetName(name)
    made.SetNumberOfComponents(len(rows[0]))
    for row in rows:
        made.InsertNextTuple(row)
    return made

def square(x, color, texels=None, mean=None, normals=None):
    data, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
    for u, v in corners:
        points.InsertNextPoint(x + 2 * u, 2 * v, 0)
    cells.InsertNextCell(4, list(range(4)))
    data.SetPoints(points)
    data.SetPolys(cells)
    data.GetPointData().SetScalars(array(vtkUnsignedCharArray, "RGB", [color] * 4))
    data.GetPointData().SetNormals(array(vtkFloatArray, "Normals", [(0, 0, 1)] * 4))
    if texels:
        data.GetPointData().SetTCoords(array(vtkFloatArray, "TCoords", corners))
        fields = data.GetFieldData()
        fields.AddArray(array(vtkUnsignedCharArray, "Texture", texels))
        fields.AddArray(array(vtkIntArray, "TextureSize", [(len(texels), 1)]))
        if mean:
            fields.AddArray(array(vtkFloatArray, "TextureMean", [mean]))
        if normals:
            fields.AddArray(array(vtkUnsignedCharArray, "NormalTexture", normals))
    return data

out = self.GetOutputDataObject(0)
out.SetBlock(0, square(0, (200, 100, 50)))
out.SetBlock(1, square(3, (100, 100, 100), [(255, 128, 0, 255)] * 4 + [(255, 255, 255, 0)] * 4, (0.5, 1.0, 1.0)))
out.SetBlock(2, square(6, (200, 200, 200), [(255, 255, 255, 255)] * 8, None,
                       [(255, 128, 128)] * 4 + [(128, 255, 128)] * 4))
for k, name in enumerate(("Plain", "Cut", "Round")):
    out.GetMetaData(k).Set(out.NAME(), name)
"""


def picture(view):
    """The colors of the window, by row from the bottom."""
    simple.Render(view)
    return colors(view).reshape(SIZE, SIZE, 3)


def at(seen, x, y=1.0):
    """The color at a place of the scene."""
    return seen[int(SIZE * (y + 4.0) / 10.0), int(SIZE * x / 10.0)]


def near(color, expected, what):
    assert np.abs(np.array(color) - np.array(expected)).max() <= 3, f"{what}: {color}, not {expected}"


def scene():
    """A view of the squares and its light."""
    view = simple.CreateView("RenderView")
    view.ViewSize = [SIZE, SIZE]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.0, 0.0, 1.0]
    view.UseLight = 0
    light = simple.AddLight(view=view)
    light.Coords, light.Type = "Scene", "Directional"
    light.Position, light.FocalPoint = [1.0, 0.0, 0.0], [0.0, 0.0, 0.0]
    squares = simple.ProgrammableSource(OutputDataSetType="vtkMultiblockDataSet", Script=SQUARES)
    shown = simple.Show(squares, view)
    shown.SetRepresentationType("Full Surface")
    simple.ColorBy(shown, ("POINTS", "RGB"))
    shown.MapScalars = 0
    shown.Specular = 0.0
    simple.Render(view)  # resets the camera
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 5.0
    view.CameraPosition = [5.0, 1.0, 20.0]
    view.CameraFocalPoint = [5.0, 1.0, 0.0]
    return view, squares, shown, light


def check_colors(view, squares, shown, where):
    shown.Ambient, shown.Diffuse = 1.0, 0.0
    seen = picture(view)
    near(at(seen, 1.0), (200, 100, 50), f"{where}: no texture")
    near(at(seen, 3.3), (200, 50, 0), f"{where}: points times texel over mean")
    near(at(seen, 4.7), (0, 0, 255), f"{where}: a transparent texel")
    near(at(seen, 7.0), (200, 200, 200), f"{where}: a white texture")
    lights, view.AdditionalLights = list(view.AdditionalLights), []
    near(at(picture(view), 3.3), (200, 50, 0), f"{where}: without lights")
    view.AdditionalLights = lights
    shown.SetRepresentationType("Full Surface")
    shown.BlockSelectors = ["/Root/Cut"]
    seen = picture(view)
    near(at(seen, 1.0), (0, 0, 255), f"{where}: a hidden block")
    near(at(seen, 7.0), (0, 0, 255), f"{where}: a hidden textured block")
    near(at(seen, 3.3), (200, 50, 0), f"{where}: the block that is left")
    shown.BlockSelectors = ["/Root"]
    near(at(picture(view), 7.0), (200, 200, 200), f"{where}: shown again")
    simple.Hide(squares, view)
    for x in (1.0, 3.3, 7.0):
        near(at(picture(view), x), (0, 0, 255), f"{where}: hidden")
    simple.Show(squares, view)
    near(at(picture(view), 3.3), (200, 50, 0), f"{where}: shown once more")
    shown.SetRepresentationType("Surface")
    seen = picture(view)
    near(at(seen, 4.7), (100, 100, 100), f"{where}: a surface without textures")
    near(at(seen, 3.3), (100, 100, 100), f"{where}: nothing left of the texture")
    shown.SetRepresentationType("Full Surface")


def check_light(view, shown, light, where):
    """Light along -x and along -y meets the normals of the texture that look to it, and no others."""
    shown.Ambient, shown.Diffuse = 0.0, 1.0
    for sun, lit, dark in (((1.0, 0.0, 0.0), 6.3, 7.7), ((0.0, 1.0, 0.0), 7.7, 6.3)):
        light.Position = sun
        seen = picture(view)
        assert at(seen, lit).min() > 150, f"{where}: {at(seen, lit)} towards the light {sun}"
        assert at(seen, dark).max() < 20, f"{where}: {at(seen, dark)} across the light {sun}"
        assert at(seen, 1.0).max() < 20, f"{where}: {at(seen, 1.0)} across the light, without a texture"


def check_shaders(view, shown):
    """Replacements in vertex and fragment shaders hold for blocks with a texture and without: red grows with x."""
    shown.Ambient, shown.Diffuse = 1.0, 0.0
    changes = [
        ("vertex", "//VTK::PositionVC::Dec", "//VTK::PositionVC::Dec\nout float across;"),
        ("vertex", "//VTK::PositionVC::Impl", "//VTK::PositionVC::Impl\n  across = vertexMC.x;"),
        ("fragment", "//VTK::PositionVC::Dec", "//VTK::PositionVC::Dec\nin float across;"),
        ("fragment", "//VTK::TCoord::Impl",
         "//VTK::TCoord::Impl\n  gl_FragData[0] = vec4(0.1 * across, 0.0, 0.0, 1.0);")]
    shown.CoordinateShiftScaleMethod = "Disable"  # places in the scene
    shown.UseShaderReplacements = 1
    shown.ShaderReplacements = json.dumps(
        [{"type": stage, "original": original, "replacement": code} for stage, original, code in changes])
    seen = picture(view)
    for x in (1.0, 3.3, 7.0):
        near(at(seen, x), (25.5 * x, 0, 0), f"the shader of the block at {x}")
    # What follows the step of the texture gets the color with the texture; what takes its place, without.
    for kept, expected in (("//VTK::TCoord::Impl\n", (100, 50, 0)), ("", (50, 100, 100))):
        shown.ShaderReplacements = json.dumps([{
            "type": "fragment", "original": "//VTK::TCoord::Impl",
            "replacement": kept + "  gl_FragData[0] = vec4(0.5 * gl_FragData[0].r, gl_FragData[0].gb, 1.0);"}])
        seen = picture(view)
        near(at(seen, 3.3), expected, f"a shader after '{kept.strip()}'")
        near(at(seen, 4.7), (0, 0, 255), f"a transparent texel with a shader after '{kept.strip()}'")
        near(at(seen, 1.0), (100, 100, 50), f"no texture, with a shader after '{kept.strip()}'")
    shown.ShaderReplacements, shown.UseShaderReplacements = "", 0
    near(at(picture(view), 3.3), (200, 50, 0), "the shader of the representation again")
    shown.Opacity = 0.4
    near(at(picture(view), 3.3), (200, 50, 0), "a texture that cuts out is opaque")
    shown.Opacity = 1.0


def check_picking(view, squares, shown, where):
    """Rectangles over a block select its cell, where it is not transparent."""
    shown.Ambient, shown.Diffuse = 1.0, 0.0
    picture(view)
    for x, expected in ((3.3, 1), (4.7, 0), (1.0, 1), (7.0, 1)):
        column, row = int(SIZE * x / 10.0), int(SIZE * 0.5)
        simple.ClearSelection(squares)
        simple.SelectSurfaceCells(Rectangle=[column - 2, row - 2, column + 2, row + 2], View=view)
        simple.UpdatePipeline(proxy=squares)
        selected = simple.ExtractSelection(Input=squares)
        selected.Selection = squares.GetSelectionInput(0)
        selected.UpdatePipeline()
        cells = selected.GetDataInformation().GetNumberOfCells()
        assert cells == expected, f"{where}: {cells} cells selected at x = {x}"
        simple.Delete(selected)


def actor_inputs(view):
    """The class of the mapper that draws each visible actor, and the numbers of points that it draws."""
    actors, found = view.GetRenderer().GetActors(), []
    actors.InitTraversal()
    for _ in range(actors.GetNumberOfItems()):
        actor = actors.GetNextItem()
        mapper = actor.GetMapper()
        if actor.GetVisibility() and mapper and mapper.GetInputDataObject(0, 0):
            found.append((mapper.GetClassName(), mapper.GetInputDataObject(0, 0).GetNumberOfElements(0)))
    return found


def check_motion(view, squares, shown):
    """Squares that move and change their color, their cells and the choice of block colors: pixels and picks follow."""
    shown.Ambient, shown.Diffuse = 1.0, 0.0
    picture(view)
    alone = [points for kind, points in actor_inputs(view) if kind == "BlockMapper"]
    assert alone == [4, 4, 4], f"each block has a mapper of its own: {actor_inputs(view)}"
    squares.Script = SQUARES.replace("x + 2 * u, 2 * v, 0", "x + 2 * u, 2 * v + 2.5, 0")
    seen = picture(view)
    for x, color in ((1.0, (200, 100, 50)), (3.3, (200, 50, 0)), (7.0, (200, 200, 200))):
        near(at(seen, x, 3.5), color, f"moved, at {x}")
        near(at(seen, x), (0, 0, 255), f"moved away from {x}")
    squares.Script = SQUARES.replace("(200, 100, 50)", "(50, 100, 200)")
    near(at(picture(view), 1.0), (50, 100, 200), "another color of the points")
    squares.Script = SQUARES.replace("(4, list(range(4)))", "(3, [0, 1, 2])")
    seen = picture(view)
    near(at(seen, 1.6, 0.4), (200, 100, 50), "the triangle that is left")
    near(at(seen, 0.4, 1.6), (0, 0, 255), "the triangle that is gone")
    squares.Script = SQUARES
    check_picking(view, squares, shown, "moved back")
    shown.BlockColors = ["/Root/Plain", "0", "1", "0"]
    near(at(picture(view), 1.0), (0, 255, 0), "a color that a user chose for a block")
    shown.BlockColors = []
    near(at(picture(view), 1.0), (200, 100, 50), "the color of the points again")


def check_still(view):
    """A picture like the last one changes nothing that is drawn, by which maps of shadows would be drawn anew."""
    def times():
        simple.Render(view)
        props = view.GetRenderer().GetViewProps()
        each = [props.GetItemAsObject(index) for index in range(props.GetNumberOfItems())]
        return [prop.GetRedrawMTime() for prop in each if prop.GetVisibility() and prop.GetBounds()]

    times()
    before = times()
    assert len(before) >= 3 and times() == before, "a picture like the last one changes what is drawn"


def main():
    view, squares, shown, light = scene()
    check_still(view)
    check_colors(view, squares, shown, "alone")
    check_motion(view, squares, shown)
    check_light(view, shown, light, "alone")
    check_picking(view, squares, shown, "alone")
    check_shaders(view, shown)


if __name__ == "__main__":
    main()
