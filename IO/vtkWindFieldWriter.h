// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWindFieldWriter
 * @brief   write a wind field as a file for wind turbine codes
 *
 * The input is a vtkImageData with the point array `Velocity` [m/s] and the field data `ConvectionSpeed` [m/s], as of
 * vtkWindFieldSource or vtkWindFieldReader: x along the wind, which moves with that speed. Each sample along x becomes
 * a plane across the wind, the last one first: what is upwind comes later. Velocities are turned from world axes to
 * those of the wind: along, across to the left, up. The extension of FileName chooses the format:
 *
 * - `.bts`: TurbSim's full-field file. Integers of 16 bits over the range of each component. Its mean wind speed is
 *   `ConvectionSpeed`, by which codes place the planes along the wind. It is marked as periodic if the field data
 * `Period` is the duration of the image.
 *
 * - `.hawc`: HAWC2's binaries `NAME_u.bin`, `NAME_v.bin` and `NAME_w.bin`, float32, and NAME.hawc with what HAWC2's
 * input file needs to read them. Along the wind they hold the velocity less `ConvectionSpeed`. No tower.
 * - `.wnd`: a full-field file in Bladed's form and NAME.sum with its scales. Integers of 16 bits, 1000 of them the
 * deviation of the component over all points. An even number of times, no tower, no value beyond 32 deviations.
 * - `.nc`: netCDF, `u`, `v` and `w` in float32 over time, z and y, a record a time, with `mean_wind_speed`,
 *   `hub_height` and `periodic` as attributes of the file, in CF's units and names: as it was, to the bit. The points
 * of a tower are `u_tower`, `v_tower` and `w_tower` over time and z_tower. Only if Littoral was built with netCDF.
 *
 * Write() asks its input for parts along x, two times over: for the ranges, then to write. Its memory is that of a
 * part, about 32 MiB, whatever the duration. The file is written under another name in the same folder and renamed when
 * it is complete. On failure, an existing file of this name is unchanged, one error names file and reason, and Write()
 * returns 0. The same input gives the same bytes, on any machine in little-endian order.
 *
 * @sa vtkWindFieldReader vtkWindFieldSource
 */
#ifndef vtkWindFieldWriter_h
#define vtkWindFieldWriter_h

#include "LittoralIOModule.h" // for the export macro
#include "vtkSingleFileWriter.h"

class LITTORALIO_EXPORT vtkWindFieldWriter : public vtkSingleFileWriter
{
public:
  static vtkWindFieldWriter* New();
  vtkTypeMacro(vtkWindFieldWriter, vtkSingleFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum PlaneOrderType
  {
    EarliestFirst = 0,
    LatestFirst = 1,
  };

  ///@{
  /**
   * Height of the hub [m], within the grid; default 0, that of the field data `HubHeight` or `ReferenceHeight` if it
   * lies within the grid, or else the middle of the grid.
   */
  vtkSetMacro(HubHeight, double);
  vtkGetMacro(HubHeight, double);
  ///@}

  ///@{
  /**
   * Number of lowest layers that become points of the tower, below the grid: of each the middle point. At least 0,
   * fewer than all; the number of points across must then be odd. Default 0.
   */
  vtkSetMacro(TowerLayers, int);
  vtkGetMacro(TowerLayers, int);
  ///@}

  ///@{
  /**
   * The plane that lies first in the binaries of HAWC2, a PlaneOrderType; default EarliestFirst, as OpenFAST reads
   * them. LatestFirst: as programs read them that take the first plane as the one farthest upwind. The `.hawc` tells
   * it.
   */
  vtkSetMacro(PlaneOrder, int);
  vtkGetMacro(PlaneOrder, int);
  void SetPlaneOrderToEarliestFirst() { this->SetPlaneOrder(EarliestFirst); }
  void SetPlaneOrderToLatestFirst() { this->SetPlaneOrder(LatestFirst); }
  ///@}

  /**
   * Writes the file; 0 where that fails, after a message.
   */
  int Write() override;

protected:
  vtkWindFieldWriter();
  ~vtkWindFieldWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteInput() override;
  void WriteTogether(vtkDataObject* own) override;

private:
  vtkWindFieldWriter(const vtkWindFieldWriter&) = delete;
  void operator=(const vtkWindFieldWriter&) = delete;

  /// Writes an image along the wind, plane by plane. Throws littoral::InvalidInput.
  void WritePlanes(const littoral::ImageParts& parts);

  double HubHeight = 0.0;
  int TowerLayers = 0;
  int PlaneOrder = EarliestFirst;
};

#endif
