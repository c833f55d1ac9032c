// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWindFieldReader
 * @brief   read a turbulent wind from a file of a wind turbine code
 *
 * Formats, by the extension of FileName:
 *
 * - `.bts`: TurbSim's full-field files.
 * - `.hawc`: HAWC2's binaries of three components, by the text with a block `mann` that names them, as
 * vtkWindFieldWriter writes it. Of others' texts the order of planes is not told: see PlaneOrder. Their wind is taken
 * as periodic.
 * - `.wnd`: full-field files in Bladed's form with the `.sum` beside them, as TurbSim writes them.
 * - `.nc`: netCDF with the variables `u`, `v` and `w` [m/s] (or of the standard names `x_wind`, `y_wind` and
 *   `upward_air_velocity`) over time, height and across, along axes that rise in even steps [s, m]. Attributes of the
 *   file: `mean_wind_speed` [m/s], else the mean of u over the times at the hub; `hub_height` [m], else the middle of
 *   the grid; `periodic`, else 0. Only if Littoral was built with netCDF.
 *
 * Output 0: vtkImageData with the float point array `Velocity` [m/s] in world axes, as of vtkWindFieldSource: x along
 * the wind, y across to the left, z up. The planes of the file lie along x, spacing mean wind speed x time step, and
 * move with the mean wind: at the time of a plane it passes Center, as the last sample along x, and later ones are
 * upwind. Times are rounded to those of planes. After the last plane the first one follows, also in a wind that is not
 * periodic, which then has a jump there. Field data: `ConvectionSpeed` [m/s], `HubHeight` [m], `Description` (text),
 * and of a periodic wind `Period` [s].
 *
 * Output 1: the same for the points of the tower below the grid, a single line across; empty if there are none.
 *
 * Any extent can be requested; only the planes in it are read. A file that is cut off, too long, of another kind or
 * byte order, or that changes while it is read is reported as one error.
 *
 * @sa vtkWindFieldWriter vtkWindFieldSource
 */
#ifndef vtkWindFieldReader_h
#define vtkWindFieldReader_h

#include "LittoralIOModule.h" // for the export macro
#include "vtkImageAlgorithm.h"

class vtkImageData;

namespace littoral
{
class InflowFile;
struct InflowPlacing;
}

class LITTORALIO_EXPORT vtkWindFieldReader : public vtkImageAlgorithm
{
public:
  static vtkWindFieldReader* New();
  vtkTypeMacro(vtkWindFieldReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  enum PlaneOrderType
  {
    EarliestFirst = 0,
    LatestFirst = 1,
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
   * Place of the plane that passes at its time, in the horizontal plane [m]; default 0 0.
   */
  vtkSetVector2Macro(Center, double);
  vtkGetVector2Macro(Center, double);
  ///@}

  ///@{
  /**
   * Direction towards which the wind blows, counterclockwise from x [degrees]; default 0. With another direction the
   * image has a direction matrix.
   */
  vtkSetMacro(WindDirection, double);
  vtkGetMacro(WindDirection, double);
  ///@}

  ///@{
  /**
   * The plane that lies first in files of HAWC2 whose `.hawc` does not tell it, a PlaneOrderType; default
   * EarliestFirst, as OpenFAST reads them.
   */
  vtkSetMacro(PlaneOrder, int);
  vtkGetMacro(PlaneOrder, int);
  void SetPlaneOrderToEarliestFirst() { this->SetPlaneOrder(EarliestFirst); }
  void SetPlaneOrderToLatestFirst() { this->SetPlaneOrder(LatestFirst); }
  ///@}

  /**
   * Whether a file can be one of a wind, 1 or 0: by its extension, and netCDF by its variables.
   */
  int CanReadFile(const char* name);

protected:
  vtkWindFieldReader();
  ~vtkWindFieldReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkWindFieldReader(const vtkWindFieldReader&) = delete;
  void operator=(const vtkWindFieldReader&) = delete;

  littoral::InflowFile Open() const;
  littoral::InflowPlacing Placing() const;
  void Announce(littoral::InflowFile& file, vtkInformationVector* outputs) const;
  /// False when the user asked to stop.
  bool Read(littoral::InflowFile& file, bool isTower, vtkInformation* info, vtkImageData* output);

  char* FileName = nullptr;
  double Center[2] = { 0.0, 0.0 };
  double WindDirection = 0.0;
  int PlaneOrder = EarliestFirst;
};

#endif
