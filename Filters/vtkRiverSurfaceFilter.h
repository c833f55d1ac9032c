// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRiverSurfaceFilter
 * @brief   give rivers the surface of their water
 *
 * Input 0: a vtkPolyData of rivers as from output 1 of vtkDrainageFilter: polylines downstream that meet at points of
 * the same place, with the point array `DrainageArea` [m^2], above 0. Input 1, optional: a vtkImageData, their terrain,
 * with the point array `Elevation` or active scalars [m]: rivers follow its heights, and fill what is in their way.
 *
 * Output: a vtkPolyData of triangles, a band for each river along its smoothed course, level from bank to bank, which
 * falls downstream or is level. Its width is that of rivers by their drainage area, w = WidthOfUnitArea (A / 1 km^2) ^
 * WidthExponent (Leopold and Maddock 1953). Point arrays: `ChannelWidth` double [m], by which vtkLandscapePass is told
 * in ParaView that this is water, `DrainageArea` double [m^2], `Bank` float, 1 at the left and -1 at the right one,
 * `RGB`, `Normals`.
 *
 * The whole input is requested, and the surface is in piece 0. A bad input or property is reported as one error.
 *
 * @sa vtkDrainageFilter
 */
#ifndef vtkRiverSurfaceFilter_h
#define vtkRiverSurfaceFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class LITTORALFILTERS_EXPORT vtkRiverSurfaceFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkRiverSurfaceFilter* New();
  vtkTypeMacro(vtkRiverSurfaceFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  ///@{
  /**
   * Width of a river that drains 1 km^2 [m], 0.001 to 10^4; default 2.8.
   */
  vtkSetMacro(WidthOfUnitArea, double);
  vtkGetMacro(WidthOfUnitArea, double);
  ///@}

  ///@{
  /**
   * Exponent of the width over the drainage area, 0 to 1; default 0.45.
   */
  vtkSetMacro(WidthExponent, double);
  vtkGetMacro(WidthExponent, double);
  ///@}

  ///@{
  /**
   * Number of times that courses are smoothed, 0 to 1000; default 6, which takes the corners of the cells of a terrain
   * from them. Heads and ends stay.
   */
  vtkSetMacro(Smoothing, int);
  vtkGetMacro(Smoothing, int);
  ///@}

  ///@{
  /**
   * Number of parts of a band between two points of a river, 1 to 100; default 4.
   */
  vtkSetMacro(Subdivision, int);
  vtkGetMacro(Subdivision, int);
  ///@}

  ///@{
  /**
   * Height of the water above the ground along the river [m], any finite number; default 0.1.
   */
  vtkSetMacro(Lift, double);
  vtkGetMacro(Lift, double);
  ///@}

  /// Connects the terrain, port 1.
  void SetTerrainConnection(vtkAlgorithmOutput* terrain) { this->SetInputConnection(1, terrain); }

  /// Removes the connection of port 1, the terrain.
  void RemoveTerrain() { this->RemoveAllInputConnections(1); }

protected:
  vtkRiverSurfaceFilter();
  ~vtkRiverSurfaceFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double WidthOfUnitArea;
  double WidthExponent;
  int Smoothing;
  int Subdivision;
  double Lift;

private:
  vtkRiverSurfaceFilter(const vtkRiverSurfaceFilter&) = delete;
  void operator=(const vtkRiverSurfaceFilter&) = delete;
};

#endif
