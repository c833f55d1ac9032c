# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Elevation models as `vtkImageData` in metres.

Images have one layer with the float point array `Elevation` [m], x to the east, y to the north,
in metres.
"""

import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

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
    """Read `.npz`, `.vti` or `.dem`, or else any raster that GDAL knows."""
    if not os.path.isfile(filename):
        raise FileNotFoundError(filename)
    readers = {".npz": read_npz, ".vti": read_vti, ".dem": read_dem}
    return readers.get(os.path.splitext(filename)[1].lower(), read_raster)(filename)


def read_npz(filename):
    """Read a numpy archive with heights on a grid of degrees.

    `elevation` [m] has its rows from north to south; `dx`, `dy`, `ymin`, `ymax` are in degrees.
    """
    with np.load(filename) as data:
        east, north = metres_per_degree(0.5 * (float(data["ymin"]) + float(data["ymax"])))
        spacing = abs(float(data["dx"])) * east, abs(float(data["dy"])) * north
        return image_from_array(data["elevation"][::-1], spacing)


def read_vti(filename):
    """Read a VTK image; without an array `Elevation` its scalars are renamed to it."""
    from vtkmodules.vtkIOXML import vtkXMLImageDataReader

    return _read(vtkXMLImageDataReader(), filename)


def read_dem(filename):
    """Read an elevation model in the ASCII format of the US Geological Survey."""
    from vtkmodules.vtkIOImage import vtkDEMReader

    return _read(vtkDEMReader(), filename)


def read_raster(filename):
    """Read a GeoTIFF or another raster through GDAL, with projected coordinates in metres.

    The centers of the pixels become the points; pixels without data become NaN.
    """
    from vtkmodules.vtkIOGDAL import vtkGDALRasterReader

    if filename.lower().endswith(".asc"):
        raise ValueError(f"{filename}: VTK cannot read ASCII grids; convert it to GeoTIFF")
    reader = vtkGDALRasterReader()
    reader.SetFileName(filename)
    reader.Update()
    raster = reader.GetOutput()
    values = raster.GetCellData().GetArray("Elevation")
    if values is None:
        raise ValueError(f"{filename}: no raster of heights")
    heights = vtk_to_numpy(values).astype(np.float32)
    ghosts = raster.GetCellGhostArray()
    if ghosts is not None:
        heights[vtk_to_numpy(ghosts) != 0] = np.nan
    columns, rows, _ = raster.GetDimensions()
    spacing, origin = raster.GetSpacing(), raster.GetOrigin()
    center = origin[0] + 0.5 * spacing[0], origin[1] + 0.5 * spacing[1]
    return image_from_array(heights.reshape(rows - 1, columns - 1), spacing, center)


def write_vti(image, filename):
    """Write an image as a VTK XML file."""
    from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

    writer = vtkXMLImageDataWriter()
    writer.SetInputData(image)
    # Inline data: with some versions of expat VTK cannot read appended data.
    writer.SetDataModeToBinary()
    writer.SetFileName(filename)
    writer.Write()


def _read(reader, filename):
    reader.SetFileName(filename)
    reader.Update()
    data = reader.GetOutput().GetPointData()
    if data.GetArray("Elevation") is None:
        if data.GetScalars() is None:
            raise ValueError(f"{filename}: no point scalars to take as elevation")
        data.GetScalars().SetName("Elevation")
    return reader.GetOutput()
