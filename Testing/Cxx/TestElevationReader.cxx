// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Rasters of heights read: an ESRI grid of known heights, holes, units, parts, projections, every bad input.
#include "Check.h"
#include "ErrorCounter.h"
#include "TestFolder.h"
#include "vtkElevationReader.h"

#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

namespace
{

namespace fs = std::filesystem;

constexpr const char* Utm32 = "EPSG:32632";

/// 4 x 3 heights, 10 m apart, the second of the northern row missing; centers of pixels from (500005, 5300005) on.
std::string Grid(const char* corner = "xllcorner 500000\nyllcorner 5300000\ncellsize 10\n")
{
  return std::string("ncols 4\nnrows 3\n") + corner +
    "NODATA_value -9999\n31 -9999 33 34.5\n21 22 23 24\n11 12 13 14\n";
}

/// Writes a file, and returns its path.
std::string Write(const fs::path& path, const std::string& text)
{
  std::ofstream(path) << text;
  return path.string();
}

double HeightAt(vtkImageData* image, int i, int j)
{
  return image->GetScalarComponentAsDouble(i, j, 0, 0);
}

/// Heights, their places, the hole, and the place on earth as field data.
bool ReadsGrid(const std::string& path)
{
  vtkNew<vtkElevationReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetFileCoordinateSystem(Utm32);
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  bool good = Check(image->GetNumberOfPoints() == 12, "There are not 12 heights");
  if (!good)
  {
    return false;
  }
  good &= Check(HeightAt(image, 0, 0) == 11.0 && HeightAt(image, 3, 1) == 24.0 && HeightAt(image, 3, 2) == 34.5,
    "Heights are at other places");
  good &= Check(std::isnan(HeightAt(image, 1, 2)), "The missing height is a number");
  vtkUnsignedCharArray* ghosts = image->GetPointGhostArray();
  for (vtkIdType point = 0; ghosts && point < 12; ++point)
  {
    const bool isHidden = (ghosts->GetValue(point) & vtkDataSetAttributes::HIDDENPOINT) != 0;
    good &= Check(isHidden == (point == 9), "Point " + std::to_string(point) + " is hidden, or is not");
  }
  good &= Check(ghosts != nullptr, "The missing height is not hidden");
  const double* origin = image->GetOrigin();
  const double* spacing = image->GetSpacing();
  good &= Check(origin[0] == 500005.0 && origin[1] == 5300005.0 && spacing[0] == 10.0 && spacing[1] == 10.0,
    "The points are not the centers of the pixels");
  auto* system = vtkStringArray::SafeDownCast(image->GetFieldData()->GetAbstractArray("CoordinateSystem"));
  good &= Check(system && system->GetValue(0).find("UTM zone 32N") != std::string::npos, "The coordinate system");

  const int part[6] = { 2, 3, 1, 2, 0, 0 };
  reader->Modified();
  reader->UpdateExtent(part);
  image = reader->GetOutput();
  good &= Check(image->GetNumberOfPoints() == 4 && HeightAt(image, 2, 1) == 23.0 && HeightAt(image, 3, 2) == 34.5,
    "A part has other heights");

  reader->LocalOriginOn();
  reader->SetHeightUnitToFeet();
  reader->UpdateWholeExtent();
  image = reader->GetOutput();
  vtkDataArray* offset = image->GetFieldData()->GetArray("CoordinateOffset");
  good &= Check(image->GetOrigin()[0] == 0.0 && offset && offset->GetComponent(0, 1) == 5300005.0, "The local origin");
  return Check(std::abs(HeightAt(image, 0, 0) - 11.0 * 0.3048) < 1e-6, "Feet are no metres") && good;
}

/// A thousandth of a degree of latitude is 110.6 to 111.7 m; on the equator UTM shrinks it by 0.9996.
bool ProjectsDegrees(const std::string& path)
{
  vtkNew<vtkElevationReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetFileCoordinateSystem("EPSG:4326");
  reader->SetProjectionToUTM();
  reader->SetResamplingToNearest();
  reader->Update();
  double bounds[6];
  reader->GetOutput()->GetBounds(bounds);
  const double west = 500000.0 - bounds[0];
  return Check(reader->GetOutput()->GetNumberOfPoints() >= 12, "Nothing is projected") &&
    Check(west > -200.0 && west < 400.0 && bounds[2] > -100.0 && bounds[2] < 200.0,
      "The middle of zone 31 on the equator is not at 500 km");
}

bool BadInput(const fs::path& folder, const std::string& grid, const std::string& degrees)
{
  vtkNew<vtkElevationReader> reader;
  vtkNew<ErrorCounter> errors;
  errors->Watch(reader);
  bool good = errors->ExpectOneNaming("FileName is empty");
  reader->SetFileName("/no/such/raster.tif");
  good &= errors->ExpectOneNaming("Cannot read raster.tif: there is no folder /no/such.");
  reader->SetFileName((folder / "raster.tif").string().c_str());
  good &= errors->ExpectOneNaming("Cannot read raster.tif: there is no such file.");
  reader->SetFileName(Write(folder / "words.tif", "This is no raster.").c_str());
  good &= errors->ExpectOneNaming("words.tif");
  reader->SetFileName(degrees.c_str());
  reader->SetFileCoordinateSystem("EPSG:4326");
  good &= errors->ExpectOneNaming("degrees");
  reader->SetFileName(grid.c_str());
  reader->SetFileCoordinateSystem("nowhere");
  good &= errors->ExpectOneNaming("nowhere");
  reader->SetFileCoordinateSystem(Utm32);
  reader->SetBand(2);
  good &= errors->ExpectOneNaming("2");
  reader->SetBand(1);
  reader->SetProjectedSpacing(-1.0);
  good &= errors->ExpectOneNaming("ProjectedSpacing");
  reader->SetProjectedSpacing(0.0);
  reader->SetResampling(3);
  good &= errors->ExpectOneNaming("Resampling");
  reader->SetResamplingToCubic();
  reader->UseNoDataValueOn();
  reader->SetNoDataValue(std::numeric_limits<double>::quiet_NaN());
  good &= errors->ExpectOneNaming("NoDataValue");
  good &= Check(reader->CanReadFile("/no/such/raster.tif") == 0, "Reads what is not there");
  return Check(reader->CanReadFile(grid.c_str()) == 1, "Does not read an ESRI grid") && good;
}

}

int TestElevationReader(int argc, char* argv[])
{
  const fs::path folder = EmptyFolder(argc, argv, "TestElevationReader");
  const std::string grid = Write(folder / "grid.asc", Grid());
  const std::string degrees = Write(folder / "degrees.asc", Grid("xllcorner 3\nyllcorner 0\ncellsize 0.001\n"));
  bool good = ReadsGrid(grid);
  good &= ProjectsDegrees(degrees);
  good &= BadInput(folder, grid, degrees);
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
