# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Differences between versions of VTK and ParaView, in one place.

Each function names the versions that need it, so that it can be removed with them.
"""

import re

from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer


def set_plot_color(plot, color):
    """Set the color of a vtkPlot, components from 0 to 1.

    VTK 9.6 has no SetColor with three numbers, VTK 9.1 no SetColorF.
    """
    plot.SetColor(*(round(255.0 * c) for c in color), 255)


def move_display(display, way):
    """Move what a display of ParaView shows.

    ParaView 5.13 calls Translation what was Position.
    """
    setattr(display, "Position" if "Position" in display.ListProperties() else "Translation", way)


def create_texture(file):
    """A texture proxy of an image file, for the Texture of a representation.

    ParaView 5.13 passes the file name on only after an explicit update.
    """
    from paraview import simple

    texture = simple.CreateTexture(file)
    getattr(texture, "SMProxy", texture).UpdateVTKObjects()
    return texture


def block_name(data, index):
    """The name of a block of a multiblock; None if it has none.

    Data that ParaView 6 fetches has the rank in the names of the first level: Block 0_High.
    """
    names = data.GetMetaData(index) if data.HasMetaData(index) else None
    name = names.Get(vtkCompositeDataSet.NAME()) if names else None
    return re.sub(r"^Block \d+_", "", name) if name else name


def series_suffix():
    """Suffix of SaveData between name and extension of a series: a number of four digits.

    ParaView 6.1 warns of the older form.
    """
    from paraview.servermanager import vtkSMProxyManager

    version = vtkSMProxyManager.GetVersionMajor(), vtkSMProxyManager.GetVersionMinor()
    return "_{:04d}" if version >= (6, 1) else "_%.4d"


def mend_calls(sources):
    """Let `(source >> filter)()`, and `source()` of these classes, leave inputs unchanged.

    VTK 9.4 to 9.6, and that of ParaView 5.13, connect None to port 0 when a pipeline is called without an input, even
    if the port is optional or connected, and reject such a call of a source.
    """
    try:
        from vtkmodules.util import execution_model
    except ImportError:  # VTK before 9.4, which has no such calls
        return
    of_vtk = execution_model._call

    def call(first, last, inp=None, port=0):
        # A producer has no port to which VTK could connect None.
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
