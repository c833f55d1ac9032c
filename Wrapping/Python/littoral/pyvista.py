# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Plants in PyVista, with their colors, normals and textures.

    plotter = pyvista.Plotter()
    add_plants(plotter, vtkReevesTreeSource().update().output)
"""

import pyvista
from vtkmodules.util.numpy_support import vtk_to_numpy

from .plants import block, cut_out, show_carried

PARTS = {"High": ("Skin", "Leaves"), "Medium": ("Trunk", "Crown"), "Low": ("",)}


def add_plants(plotter, plants, levels=("High",), **look):
    """Show levels of a plant, a scattered forest or moving plants; returns the actors.

    plants: blocks from a plant source, vtkPlantScatterFilter, vtkBeamTreeDeformationFilter or
    vtkSeaweedDeformationFilter; for a forest, show all three levels. look: further arguments of `add_mesh`.
    Crowns, and leaves whose texture is transparent outside the leaf, are cut out along it.
    """
    actors = []
    for level in levels:
        for name in PARTS[level]:
            part = block(plants, level, *filter(None, [name]))
            if part is None or not part.GetNumberOfCells():
                continue
            picture = _picture(part)
            colors = {"scalars": "RGB", "rgb": True}
            actor = plotter.add_mesh(part, texture=picture, **{"ambient": 0.25, **colors, **look})
            # PyVista's smooth_shading would replace the normals, which for leaves are those of the crown.
            actor.GetProperty().SetInterpolationToPhong()
            actors.append(actor if picture is None else show_carried(cut_out(actor), part))
    return actors


def _picture(part):
    """The texture of a part; None if it has none, or an opaque one."""
    data = part.GetFieldData()
    if not data.HasArray("Texture"):
        return None
    columns, rows = vtk_to_numpy(data.GetArray("TextureSize"))
    texels = vtk_to_numpy(data.GetArray("Texture")).reshape(rows, columns, 4)
    if texels[..., 3].min() > 127:
        return None
    texture = pyvista.Texture(texels[::-1])  # PyVista counts rows from above
    texture.interpolate = True  # no means of the transparency, which are below a half in fine detail
    return texture
