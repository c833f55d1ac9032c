// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkElevationReader
 * @brief   read a raster of heights in metres with its place on earth
 *
 * Reads GeoTIFF, ESRI ASCII grids, SRTM tiles (.hgt), netCDF and all other rasters that GDAL knows. Output: a
 * vtkImageData of one layer with the float point array `Elevation` [m], x to the east and y to the north, in metres.
 * The points are the centers of the pixels. Pixels without data, or beyond 1e15, are NaN, and hidden (`vtkGhostType`)
 * so that they are holes in every picture.
 *
 * Coordinates that are no lengths are never taken for metres: degrees, and maps on which lengths differ by more than 5
 * % from those on the ground (as the web's Mercator map), are refused, or projected with Projection. Feet become
 * metres. A raster whose rows do not run from west to east is resampled on a grid whose rows do. Without a named
 * coordinate system coordinates are what the unit of a netCDF file's coordinate variables says, else metres, unless
 * they look like degrees; without any coordinates a pixel is 1 m.
 *
 * Field data: `CoordinateSystem` (text, WKT of the horizontal coordinate system), `CoordinateUnit` (metres per unit of
 * it) and `CoordinateOffset` (two numbers, m): map coordinates are (position + CoordinateOffset) / CoordinateUnit. All
 * filters of VTK pass field data on; vtkTurningBandsTerrainSource does on request; vtkElevationWriter writes them.
 * `ElevationSummary` (text) tells in a sentence what was read: size, spacing, range, missing heights, coordinate
 * system, unit.
 *
 * Any subextent can be requested; only that part of the file is read. A file that is missing, cut off or of another
 * kind, a tile of a mosaic (VRT) that is gone or has not the size that the mosaic says, and a coordinate system that
 * cannot be read, are reported as one error.
 *
 * @sa vtkElevationWriter vtkCovarianceFitFilter
 */
#ifndef vtkElevationReader_h
#define vtkElevationReader_h

#include "LittoralIOModule.h" // for the export macro
#include "vtkImageAlgorithm.h"

#include <string> // for names of coordinate systems

namespace littoral
{
struct RasterOptions;
}

class LITTORALIO_EXPORT vtkElevationReader : public vtkImageAlgorithm
{
public:
  static vtkElevationReader* New();
  vtkTypeMacro(vtkElevationReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  enum ProjectionType
  {
    AsInFile = 0,
    UTM = 1,
    GivenSystem = 2,
  };

  enum ResamplingType
  {
    Nearest = 0,
    Bilinear = 1,
    Cubic = 2,
  };

  enum HeightUnitType
  {
    AsNamed = 0,
    Metres = 1,
    Feet = 2,
    USSurveyFeet = 3,
  };

  ///@{
  /**
   * Name of the file; default null, which is an error.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Name of the dataset to read from a file with several, as the variable of a netCDF file; default ``, the first.
   */
  vtkSetMacro(Dataset, std::string);
  vtkGetMacro(Dataset, std::string);
  ///@}

  ///@{
  /**
   * Number of the band to read, from 1; default 1.
   */
  vtkSetMacro(Band, int);
  vtkGetMacro(Band, int);
  ///@}

  ///@{
  /**
   * Coordinate system of the file, as `EPSG:4326` or WKT; default ``, the one that the file names. `metres`: none, its
   * coordinates are metres even if they look like degrees.
   */
  vtkSetMacro(FileCoordinateSystem, std::string);
  vtkGetMacro(FileCoordinateSystem, std::string);
  ///@}

  ///@{
  /**
   * Coordinate system to read in, a ProjectionType; default AsInFile. UTM: the UTM zone of the center, on the datum of
   * the file; on a sphere, as that of weather models, the transverse Mercator projection of its meridian. GivenSystem:
   * CoordinateSystem.
   */
  vtkSetMacro(Projection, int);
  vtkGetMacro(Projection, int);
  void SetProjectionToAsInFile() { this->SetProjection(AsInFile); }
  void SetProjectionToUTM() { this->SetProjection(UTM); }
  void SetProjectionToGivenSystem() { this->SetProjection(GivenSystem); }
  ///@}

  ///@{
  /**
   * Coordinate system of the output, a projection as `EPSG:32632` or WKT; default ``. Used only if Projection is
   * GivenSystem.
   */
  vtkSetMacro(CoordinateSystem, std::string);
  vtkGetMacro(CoordinateSystem, std::string);
  ///@}

  ///@{
  /**
   * Spacing of the output along x and y where it is resampled [m], not negative; default 0, about that of the file.
   */
  vtkSetMacro(ProjectedSpacing, double);
  vtkGetMacro(ProjectedSpacing, double);
  ///@}

  ///@{
  /**
   * Interpolation between the heights of the file where they are resampled, a ResamplingType; default Cubic, which
   * keeps most of the small relief.
   */
  vtkSetMacro(Resampling, int);
  vtkGetMacro(Resampling, int);
  void SetResamplingToNearest() { this->SetResampling(Nearest); }
  void SetResamplingToBilinear() { this->SetResampling(Bilinear); }
  void SetResamplingToCubic() { this->SetResampling(Cubic); }
  ///@}

  ///@{
  /**
   * Unit of the heights in the file, a HeightUnitType; default AsNamed: the one that the file names, else metres.
   */
  vtkSetMacro(HeightUnit, int);
  vtkGetMacro(HeightUnit, int);
  void SetHeightUnitToAsNamed() { this->SetHeightUnit(AsNamed); }
  void SetHeightUnitToMetres() { this->SetHeightUnit(Metres); }
  void SetHeightUnitToFeet() { this->SetHeightUnit(Feet); }
  void SetHeightUnitToUSSurveyFeet() { this->SetHeightUnit(USSurveyFeet); }
  ///@}

  ///@{
  /**
   * Origin of the output at its southwestern point, with the place of that point as `CoordinateOffset`; default off,
   * coordinates of the map. Filters in single precision have steps of 0.25 to 0.5 m at such coordinates, which are
   * thousands of kilometres.
   */
  vtkSetMacro(LocalOrigin, bool);
  vtkGetMacro(LocalOrigin, bool);
  vtkBooleanMacro(LocalOrigin, bool);
  ///@}

  ///@{
  /**
   * NoDataValue marks a missing height, besides what the file says of itself; default off.
   */
  vtkSetMacro(UseNoDataValue, bool);
  vtkGetMacro(UseNoDataValue, bool);
  vtkBooleanMacro(UseNoDataValue, bool);
  ///@}

  ///@{
  /**
   * Value of a missing height, in the unit of the file; default -9999. Used only if UseNoDataValue is on.
   */
  vtkSetMacro(NoDataValue, double);
  vtkGetMacro(NoDataValue, double);
  ///@}

  /**
   * Whether a file is a raster with a place on a map, and not a picture: 1 or 0. Of netCDF its values must be in a unit
   * of heights or in none, and files with winds or with velocities of the sea are left to their own readers.
   */
  int CanReadFile(const char* name);

protected:
  vtkElevationReader();
  ~vtkElevationReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkElevationReader(const vtkElevationReader&) = delete;
  void operator=(const vtkElevationReader&) = delete;

  std::string WhyInvalid() const;
  littoral::RasterOptions Options() const;
  /// One message that names the file.
  void Refuse(const std::string& reason);

  char* FileName = nullptr;
  std::string Dataset;
  int Band = 1;
  std::string FileCoordinateSystem;
  int Projection = AsInFile;
  std::string CoordinateSystem;
  double ProjectedSpacing = 0.0;
  int Resampling = Cubic;
  int HeightUnit = AsNamed;
  bool LocalOrigin = false;
  bool UseNoDataValue = false;
  double NoDataValue = -9999.0;
  std::string WhyUnread; ///< found by RequestInformation()
};

#endif
