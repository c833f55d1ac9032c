# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What single versions of VTK and ParaView do their own way, in one place.

Each function says which versions need it, so that it can go when they do.
"""

from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet


def set_plot_colour(plot, colour):
    """Set the colour of a vtkPlot, components from 0 to 1.

    VTK 9.6 has no SetColor of three numbers any more, VTK 9.1 no SetColorF yet.
    """
    plot.SetColor(*(round(255.0 * c) for c in colour), 255)


def create_texture(file):
    """A texture proxy of a picture file, for a representation's Texture.

    ParaView 5.13 keeps the file name to itself until it is told to pass it on.
    """
    from paraview import simple

    texture = simple.CreateTexture(file)
    getattr(texture, "SMProxy", texture).UpdateVTKObjects()
    return texture


def block_name(data, index):
    """The name of a block of a multiblock; None if it has none.

    What ParaView 6 fetches has a number in front of the names of the first level: Block 0_High.
    """
    names = data.GetMetaData(index) if data.HasMetaData(index) else None
    name = names.Get(vtkCompositeDataSet.NAME()) if names else None
    return name.removeprefix(f"Block {index}_") if name else name
