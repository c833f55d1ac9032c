// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOceanCurrentReader
 * @brief   read currents from a netCDF file of an ocean model
 *
 * Files by the conventions for climate and forecast (CF), of ROMS, of FVCOM, and by UGRID:
 *
 * - Grids of rows: longitudes and latitudes along axes, of each point, or on a grid with a rotated pole; lengths on a
 * map that a grid_mapping names (WKT, or one of eight mappings of CF), or on none. C grids (ROMS) have their velocities
 * brought to the centres of cells, without the outermost ones.
 * - Meshes of triangles or quadrilaterals, with velocities at nodes or in faces; those in faces are brought to the
 * nodes.
 * - Levels: heights or depths, sigma, s by ROMS's transforms 1 and 2 with their stretching 1 to 5; none for a surface
 * current, which holds for all heights.
 * - Times in any calendar of CF. Velocities in m/s, cm/s, mm/s, km/h and knots; without a unit m/s. Packed numbers and
 * all marks of missing ones.
 *
 * Output: a vtkStructuredGrid, or of a mesh a vtkUnstructuredGrid of triangles or wedges, with the float point array
 * `Velocity`[3] [m/s] in local axes, NaN on land, which vtkCurrentDriftFilter and vtkSeaweedDeformationFilter take as a
 * current; and, where the file has it, the float array `Depth` [m] of the still water. Points are in columns that stand
 * upright, from the bed upwards, in metres: x eastwards and y northwards at Origin, on the stereographic projection of
 * WGS 84 about it, z from the model's mean sea level. Velocities are those on that map, which differ from those on
 * earth by r^2/4R^2 at a distance r from the origin. Field data: `CoordinateSystem`, the projection as WKT; `Layers`,
 * the number of levels; `FirstDate`, the date of the first time (text).
 *
 * Times are in seconds from the first one. A request for another time gets the nearest one; only that is read. Any
 * extent of a grid of rows can be requested, and any piece of a mesh.
 *
 * Axes that are missing, repeated or turn back, gaps in them, unknown units and calendars, levels without a term of
 * their formula, and a file that is cut off or changes while it is read are reported as one error.
 *
 * @sa vtkCurrentDriftFilter vtkSeaweedDeformationFilter
 */
#ifndef vtkOceanCurrentReader_h
#define vtkOceanCurrentReader_h

#include "LittoralIOModule.h" // for the export macro
#include "vtkDataObjectAlgorithm.h"

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkStructuredGrid;
class vtkUnstructuredGrid;

namespace littoral
{
class OceanLayers;
struct OceanChoices;
struct OceanGrid;
struct OceanPlacing;
}

class LITTORALIO_EXPORT vtkOceanCurrentReader : public vtkDataObjectAlgorithm
{
public:
  static vtkOceanCurrentReader* New();
  vtkTypeMacro(vtkOceanCurrentReader, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  enum VectorDirectionsType
  {
    Automatic = 0,
    EastNorth = 1,
    GridAxes = 2,
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
   * Variable of the first horizontal component; default ``, found by standard names, else by names that models use.
   */
  vtkSetMacro(UVariable, std::string);
  vtkGetMacro(UVariable, std::string);
  ///@}

  ///@{
  /**
   * Variable of the second horizontal component; default ``, found like the first.
   */
  vtkSetMacro(VVariable, std::string);
  vtkGetMacro(VVariable, std::string);
  ///@}

  ///@{
  /**
   * Variable of the vertical component, upwards; default ``, found like the others, or 0 if there is none.
   */
  vtkSetMacro(WVariable, std::string);
  vtkGetMacro(WVariable, std::string);
  ///@}

  ///@{
  /**
   * Directions of the horizontal components, a VectorDirectionsType; default Automatic: by standard names, else those
   * of C grids along the axes of the grid, and others eastwards and northwards.
   */
  vtkSetMacro(VectorDirections, int);
  vtkGetMacro(VectorDirections, int);
  void SetVectorDirectionsToAutomatic() { this->SetVectorDirections(Automatic); }
  void SetVectorDirectionsToEastNorth() { this->SetVectorDirections(EastNorth); }
  void SetVectorDirectionsToGridAxes() { this->SetVectorDirections(GridAxes); }
  ///@}

  ///@{
  /**
   * Whether Origin is given; default off: the middle of the points.
   */
  vtkSetMacro(GivenOrigin, bool);
  vtkGetMacro(GivenOrigin, bool);
  vtkBooleanMacro(GivenOrigin, bool);
  ///@}

  ///@{
  /**
   * Longitude and latitude of x = y = 0 [degrees]; default 0 0. Used only if GivenOrigin is on, and not where the file
   * itself has lengths.
   */
  vtkSetVector2Macro(Origin, double);
  vtkGetVector2Macro(Origin, double);
  ///@}

  ///@{
  /**
   * Whether only the rows with points in Region are read; default off. No point may be more than 90 degrees from the
   * origin, so files of the whole earth need it.
   */
  vtkSetMacro(GivenRegion, bool);
  vtkGetMacro(GivenRegion, bool);
  vtkBooleanMacro(GivenRegion, bool);
  ///@}

  ///@{
  /**
   * Western and eastern longitude, southern and northern latitude of the region [degrees], each increasing: 170 190 is
   * across the date line; default -10 10 -10 10. Used only if GivenRegion is on.
   */
  vtkSetVector4Macro(Region, double);
  vtkGetVector4Macro(Region, double);
  ///@}

  ///@{
  /**
   * Date of the time 0 in UTC, as `2020-02-28T06:00:00Z`; default ``, the first one of the file.
   */
  vtkSetMacro(StartDate, std::string);
  vtkGetMacro(StartDate, std::string);
  ///@}

  /**
   * Whether a file is a netCDF file with velocities of the sea: 1 or 0.
   */
  int CanReadFile(const char* name);

protected:
  vtkOceanCurrentReader();
  ~vtkOceanCurrentReader() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkOceanCurrentReader(const vtkOceanCurrentReader&) = delete;
  void operator=(const vtkOceanCurrentReader&) = delete;

  class vtkInternals;
  littoral::OceanChoices Choices() const;
  littoral::OceanPlacing Placing() const;
  /// The grid of the file as it is now.
  const littoral::OceanGrid& Grid();
  /// False when the user asked to stop.
  bool Read(vtkInformation* info, vtkStructuredGrid* output);
  bool Read(vtkInformation* info, vtkUnstructuredGrid* output);

  char* FileName = nullptr;
  std::string UVariable;
  std::string VVariable;
  std::string WVariable;
  int VectorDirections = Automatic;
  bool GivenOrigin = false;
  double Origin[2] = { 0.0, 0.0 };
  bool GivenRegion = false;
  double Region[4] = { -10.0, 10.0, -10.0, 10.0 };
  std::string StartDate;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
