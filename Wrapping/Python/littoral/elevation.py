# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Elevation models as `vtkImageData` in metres.

Images have one layer with the float point array `Elevation` [m], x to the east, y to the north,
in metres.
"""

import os
import zipfile

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

from . import files

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


def read_elevation(filename=JACKSBORO):
    """Read `.npz` or `.vti`, or else any raster that GDAL knows.

    Raises OSError for a file that cannot be opened, and ValueError for one that is damaged or holds no heights.
    """
    with open(filename, "rb"):  # missing, a folder, or not to be read
        pass
    readers = {".npz": read_npz, ".vti": read_vti}
    return readers.get(os.path.splitext(filename)[1].lower(), read_raster)(filename)


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


def read_raster(filename):
    """Read a GeoTIFF or another raster through GDAL, with projected coordinates in metres.

    The centers of the pixels become the points; pixels without data become NaN.
    """
    try:
        from osgeo import gdal
    except ImportError as error:
        raise ImportError(f"{filename}: reading rasters takes Debian's package python3-gdal ({error})") from None
    raising = gdal.GetUseExceptions()
    gdal.UseExceptions()
    try:
        raster = gdal.Open(filename)
        band = raster.GetRasterBand(1)
        heights = band.ReadAsArray().astype(np.float32)
        heights[band.GetMaskBand().ReadAsArray() == 0] = np.nan
        west, east, row_east, north, column_north, south = raster.GetGeoTransform()
    except (AttributeError, RuntimeError) as error:
        raise ValueError(f"{filename}: no whole raster of heights ({error})") from None
    finally:
        if not raising:
            gdal.DontUseExceptions()
    place = raster.GetSpatialRef()
    if place is not None and place.IsGeographic():
        raise ValueError(f"{filename}: its coordinates are degrees; project it to metres first, as by gdalwarp")
    if row_east or column_north or east <= 0.0 or south == 0.0:
        raise ValueError(f"{filename}: its rows do not run from west to east; warp it first, as by gdalwarp")
    if south > 0.0:  # the first row is the southernmost, or the raster has no place
        return image_from_array(heights, (east, south), (west + 0.5 * east, north + 0.5 * south))
    lowest = north + (len(heights) - 0.5) * south
    return image_from_array(heights[::-1], (east, -south), (west + 0.5 * east, lowest))


def write_vti(image, filename):
    """Write an image as a VTK XML file. Raises OSError, with an old file as it was."""
    from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

    writer = vtkXMLImageDataWriter()
    writer.SetInputData(image)
    # Inline data: with some versions of expat VTK cannot read appended data.
    writer.SetDataModeToBinary()
    files.write(writer, filename)
