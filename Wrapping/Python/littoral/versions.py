# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What single versions of VTK and ParaView do their own way, in one place.

Each function says which versions need it, so that it can go when they do.
"""

import re

from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer


def set_plot_color(plot, color):
    """Set the color of a vtkPlot, components from 0 to 1.

    VTK 9.6 has no SetColor of three numbers any more, VTK 9.1 no SetColorF yet.
    """
    plot.SetColor(*(round(255.0 * c) for c in color), 255)


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

    What ParaView 6 fetches has the number of the rank in front of the names of the first level: Block 0_High.
    """
    names = data.GetMetaData(index) if data.HasMetaData(index) else None
    name = names.Get(vtkCompositeDataSet.NAME()) if names else None
    return re.sub(r"^Block \d+_", "", name) if name else name


def series_suffix():
    """What SaveData puts between name and extension of a series: a number of four digits.

    ParaView 6.1 warns of the form of those before.
    """
    from paraview.servermanager import vtkSMProxyManager

    version = vtkSMProxyManager.GetVersionMajor(), vtkSMProxyManager.GetVersionMinor()
    return "_{:04d}" if version >= (6, 1) else "_%.4d"


def mend_calls(sources):
    """Let `(source >> filter)()`, and `source()` of these classes, leave inputs as they are.

    VTK 9.4 to 9.6, and that of ParaView 5.13, connect nothing to port 0 where a pipeline is called without an input,
    even if what is there is optional or connected, and refuse such a call of a source.
    """
    try:
        from vtkmodules.util import execution_model
    except ImportError:  # VTK before 9.4, which has no such calls
        return
    of_vtk = execution_model._call

    def call(first, last, inp=None, port=0):
        # A producer has no port to which VTK could connect nothing.
        return of_vtk(vtkTrivialProducer() if inp is None else first, last, inp, port)

    def callable_class(source):
        class Callable(source):
            __doc__ = source.__doc__

            def __call__(self, *inputs):
                return super().__call__(*inputs) if inputs else call(self, self)

        Callable.__name__ = Callable.__qualname__ = source.__name__
        return Callable

    execution_model._call = call
    for source in sources:
        source.override(callable_class(source))
