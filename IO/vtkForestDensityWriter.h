// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkForestDensityWriter
 * @brief   write a forest for fire and flow codes
 *
 * The input is an output of vtkForestDensityFilter, and the extension of FileName chooses the format:
 *
 * - `.bdf`, of a vtkImageData with the cell array `BulkDensity` [kg/m3]: the bulk density file of FDS, of the cells
 * that have a density, in double precision.
 * - `.dat`, of the same: QUIC-Fire's bulk density in single precision, all cells, x first, z last.
 * - `.nc`, of a vtkImageData with the cell array `LeafAreaDensity` [m2/m3]: a static driver of PALM, netCDF with `lad`
 *   over zlad, y and x, float32; with the cell array `PlantAreaDensity` also `bad`, what it has more than the leaves.
 *   Heights are above the lowest face of the image. Only if Littoral was built with netCDF.
 * - `.amrwind`, of a vtkPolyData with a point a tree and the point arrays `Height`, `CrownDiameter` [m] and
 *   `LeafAreaIndex`, optionally `MaximumHeight` (else 0.7): forest rows of AMR-Wind, a row a tree: type 2 (the profile
 * of Lalic and Mihailovic 2004), x, y, height, diameter, drag coefficient, leaf area index, z_m / h. Trees without
 * leaves are left out. Rows tell no ground: trees stand on the ground of the code.
 *
 * Numbers are in little-endian order on any machine, in records of Fortran; those of netCDF as it has them. The file is
 * written under another name in the same folder and renamed when it is complete. On failure, an existing file of this
 * name is unchanged, one error names file and reason, and Write() returns 0. The same input gives the same bytes.
 * Densities that are negative or not finite, a turned image and one that the format cannot hold are errors.
 *
 * @sa vtkForestDensityFilter vtkVDBVolumeWriter
 */
#ifndef vtkForestDensityWriter_h
#define vtkForestDensityWriter_h

#include "LittoralIOModule.h" // for the export macro
#include "vtkSingleFileWriter.h"

#include <functional>
#include <ostream>
#include <string>

class vtkImageData;
class vtkPointSet;

class LITTORALIO_EXPORT vtkForestDensityWriter : public vtkSingleFileWriter
{
public:
  static vtkForestDensityWriter* New();
  vtkTypeMacro(vtkForestDensityWriter, vtkSingleFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Drag coefficient of the trees in forest rows, 0 to 10; default 0.2.
   */
  vtkSetMacro(DragCoefficient, double);
  vtkGetMacro(DragCoefficient, double);
  ///@}

  ///@{
  /**
   * Latitude of the lower left corner of the image [degrees], -90 to 90, for PALM; default 0.
   */
  vtkSetMacro(Latitude, double);
  vtkGetMacro(Latitude, double);
  ///@}

  ///@{
  /**
   * Longitude of the lower left corner of the image [degrees], -180 to 360, for PALM; default 0.
   */
  vtkSetMacro(Longitude, double);
  vtkGetMacro(Longitude, double);
  ///@}

  ///@{
  /**
   * Time at which the run of PALM begins, as YYYY-MM-DD hh:mm:ss +zz; default 2000-06-21 12:00:00 +00.
   */
  vtkSetStringMacro(OriginTime);
  vtkGetStringMacro(OriginTime);
  ///@}

protected:
  vtkForestDensityWriter();
  ~vtkForestDensityWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteInput() override;

private:
  vtkForestDensityWriter(const vtkForestDensityWriter&) = delete;
  void operator=(const vtkForestDensityWriter&) = delete;

  /// Fills a file.
  using FillFile = std::function<void(std::ostream& file)>;

  void WriteImage(vtkImageData* image, const std::string& extension);
  void WritePalm(vtkImageData* image);
  void WriteTrees(vtkPointSet* input);
  void WriteWhole(const FillFile& fill);

  double DragCoefficient = 0.2;
  double Latitude = 0.0;
  double Longitude = 0.0;
  char* OriginTime = nullptr;
};

#endif
