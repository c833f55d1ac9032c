# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Elevation models as `vtkImageData` in metres.

Images have one layer with the float point array `Elevation` [m], x to the east, y to the north,
in metres. Where on earth they are stands in their field data (vtkElevationReader), and travels with them:

    place = read_elevation("N36W085.hgt", projection="UTM")
    write_tif(twin_of(place), "twin.tif")
"""

import os
import zipfile

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

from . import errors, files
from .properties import set_properties

#: Jacksboro fault, Tennessee: US Geological Survey, public domain, in Debian's package
#: python-matplotlib-data.
JACKSBORO = "/usr/share/matplotlib/mpl-data/sample_data/jacksboro_fault_dem.npz"


def metres_per_degree(latitude):
    """Length [m] of a degree of longitude and of a degree of latitude on WGS 84.

    latitude: degrees.
    """
    semi_major, eccentricity2 = 6378137.0, 0.00669437999014
    phi = np.radians(latitude)
    w = np.sqrt(1.0 - eccentricity2 * np.sin(phi) ** 2)
    east = semi_major * np.cos(phi) / w
    north = semi_major * (1.0 - eccentricity2) / w**3
    return np.radians(east), np.radians(north)


def image_from_array(elevation, spacing, origin=(0.0, 0.0)):
    """Image of an array of heights [m], rows from south to north.

    spacing, origin: x and y [m].
    """
    rows, columns = elevation.shape
    image = vtkImageData()
    image.SetDimensions(columns, rows, 1)
    image.SetSpacing(spacing[0], spacing[1], 1.0)
    image.SetOrigin(origin[0], origin[1], 0.0)
    values = numpy_to_vtk(np.array(elevation, np.float32).ravel(), deep=True)
    values.SetName("Elevation")
    image.GetPointData().SetScalars(values)
    return image


def array_from_image(image, name="Elevation"):
    """A point array as [row, column], rows from south to north; None if there is no such array."""
    values = image.GetPointData().GetArray(name)
    if values is None:
        return None
    columns, rows, _ = image.GetDimensions()
    return vtk_to_numpy(values).reshape(rows, columns)


def read_elevation(filename=JACKSBORO, projection=None, **settings):
    """Read `.npz` or `.vti`, or else any raster that GDAL knows, as `read_raster`.

    Raises OSError for a file that cannot be opened, and ValueError for one that is damaged or holds no heights.
    """
    filename = os.fspath(filename)
    if not filename.startswith("/vsi"):  # GDAL's names of files within archives
        with open(filename, "rb"):  # missing, a folder, or not to be read
            pass
    reader = {".npz": read_npz, ".vti": read_vti}.get(os.path.splitext(filename)[1].lower())
    if reader is None:
        return read_raster(filename, projection, **settings)
    if projection is not None or settings:
        raise ValueError(f"{filename}: only rasters of GDAL are projected, or read with settings")
    return reader(filename)


def read_npz(filename):
    """Read a numpy archive with heights on a grid of degrees.

    `elevation` [m] has its rows from north to south; `dx`, `dy`, `ymin`, `ymax` are in degrees.
    """
    try:
        with np.load(filename) as data:
            east, north = metres_per_degree(0.5 * (float(data["ymin"]) + float(data["ymax"])))
            spacing = abs(float(data["dx"])) * east, abs(float(data["dy"])) * north
            return image_from_array(data["elevation"][::-1], spacing)
    except (AttributeError, EOFError, KeyError, TypeError, ValueError, zipfile.BadZipFile) as error:
        raise ValueError(f"{filename}: no NumPy archive of heights ({error})") from None


def read_vti(filename):
    """Read a VTK image; without an array `Elevation` its scalars are renamed to it."""
    from vtkmodules.vtkCommonCore import vtkEventForwarderCommand
    from vtkmodules.vtkIOXML import vtkXMLImageDataReader

    reader, parser, errors = vtkXMLImageDataReader(), vtkEventForwarderCommand(), []
    for watched in (reader, reader.GetExecutive()):
        watched.AddObserver("ErrorEvent", lambda *_: errors.append(True))  # in place of VTK's own messages
    parser.SetTarget(reader)
    reader.SetParserErrorObserver(parser)
    reader.SetFileName(filename)
    reader.Update()
    image = reader.GetOutput()
    if errors or reader.GetErrorCode():
        raise ValueError(f"{filename}: no whole VTK image")
    data = image.GetPointData()
    if data.GetArray("Elevation") is None:
        if data.GetScalars() is None:
            raise ValueError(f"{filename}: no point scalars to take as elevation")
        data.GetScalars().SetName("Elevation")
    return image


def read_raster(filename, projection=None, **settings):
    """Read a GeoTIFF or another raster of GDAL by vtkElevationReader.

    projection: None, as in the file, which must have lengths and not degrees; "UTM", the zone of its center; or a
    coordinate system as "EPSG:32632".
    settings: any property of vtkElevationReader, such as Band=2.
    """
    from . import vtkElevationReader

    reader = vtkElevationReader()
    reader.SetFileName(os.fspath(filename))
    if projection == "UTM":
        reader.SetProjectionToUTM()
    elif projection is not None:
        reader.SetProjectionToGivenSystem()
        reader.SetCoordinateSystem(projection)
    set_properties(reader, settings)
    messages = errors.kept(reader)
    reader.Update()
    if messages:
        raise ValueError(messages[0])
    return reader.GetOutput()


def twin_of(place, seed=1):
    """A twin of a terrain: another one with its statistics, on its grid and in its place on earth."""
    from . import vtkCovarianceFitFilter, vtkTurningBandsTerrainSource

    fit, twin = vtkCovarianceFitFilter(), vtkTurningBandsTerrainSource()
    fit.SetInputData(place)
    twin.SetInputConnection(fit.GetOutputPort(0))
    twin.UseMeasuredGridOn()
    twin.SetSeed(seed)
    messages = errors.kept(fit, twin)
    twin.Update()
    if messages:
        raise ValueError(messages[0])
    return twin.GetOutput()


def write_vti(image, filename):
    """Write an image as a VTK XML file. Raises OSError, with an old file as it was."""
    from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

    writer = vtkXMLImageDataWriter()
    writer.SetInputData(image)
    # Inline data: with some versions of expat VTK cannot read appended data.
    writer.SetDataModeToBinary()
    files.write(writer, filename)


def write_tif(image, filename, coordinate_system=""):
    """Write the heights of an image as a GeoTIFF in its place on earth, by vtkElevationWriter.

    coordinate_system: that of the image, as "EPSG:32632"; empty: the one in its field data.
    Raises OSError where the disk refuses, and ValueError for an image that cannot be written, with an old file as it
    was.
    """
    from vtkmodules.vtkCommonMisc import vtkErrorCode

    from . import vtkElevationWriter

    writer = vtkElevationWriter()
    writer.SetInputData(image)
    writer.SetFileName(os.fspath(filename))
    writer.SetCoordinateSystem(coordinate_system)
    messages = errors.kept(writer)
    if not writer.Write():
        is_disk = writer.GetErrorCode() == vtkErrorCode.CannotOpenFileError
        raise (OSError if is_disk else ValueError)(messages[0] if messages else f"Cannot write the file {filename}")
