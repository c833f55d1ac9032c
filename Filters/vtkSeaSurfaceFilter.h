// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSeaSurfaceFilter
 * @brief   generate the surface of a sea state, from near waves to the horizon
 *
 * Input: a sea state from vtkSeaStateSource.
 *
 * Output: a vtkPolyData of triangles at the requested time, a disk whose points are Spacing apart near Center and
 * further apart with the distance, so that a disk of 5 km has 135,000 points. Point arrays: `Normals`, `Jacobian` (1 at
 * rest; 0 or less where the surface folds over itself, which indicates foam), `RGB` (see WaterColors), `Foam` and
 * `Displacement` (see FoamLifetime). Waves are left out where they are shorter than four spacings; at Center all waves
 * of at least 4 Spacing are there.
 *
 * Pieces are sectors of the disk; they share the points between them. A level of ghosts is a sector on each side. A
 * property out of range or a table that is no sea state is reported as one error. Coulais et al., eq. 2, as
 * vtkParticleOrbitFilter moves points at sea level.
 *
 * @sa vtkSeaStateSource vtkParticleOrbitFilter
 */
#ifndef vtkSeaSurfaceFilter_h
#define vtkSeaSurfaceFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for what is wrong with a property

namespace littoral
{
class SeaSurfaceGrid;
struct SeaState;
struct SeaSurfaceParameters;
}

class LITTORALFILTERS_EXPORT vtkSeaSurfaceFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkSeaSurfaceFilter* New();
  vtkTypeMacro(vtkSeaSurfaceFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  ///@{
  /**
   * Center of the disk in the horizontal plane, where the waves are finest [m]; default 0 0.
   */
  vtkSetVector2Macro(Center, double);
  vtkGetVector2Macro(Center, double);
  ///@}

  ///@{
  /**
   * Radius of the disk [m], 1 to 1e6; default 5000.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Distance between neighboring points near Center [m], 0.001 to Radius; default 0.6.
   */
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * Number of points on a circle around Center, 8 to 10000; default 360. The distance between points at the distance r
   * is 2 pi r / Sectors where that is above Spacing.
   */
  vtkSetMacro(Sectors, int);
  vtkGetMacro(Sectors, int);
  ///@}

  ///@{
  /**
   * Factor of the horizontal motion, 0 to 1; default 1. Below 1 a steep sea does not fold over itself.
   */
  vtkSetMacro(Choppiness, double);
  vtkGetMacro(Choppiness, double);
  ///@}

  ///@{
  /**
   * Addition of the point array `RGB`, the color of the water by day as seen from 9 m above Center: blue in troughs and
   * green in crests, with the sky that it reflects by Fresnel's equations, white where Jacobian is below FoamThreshold,
   * and pale towards the horizon; default on.
   */
  vtkSetMacro(WaterColors, bool);
  vtkGetMacro(WaterColors, bool);
  vtkBooleanMacro(WaterColors, bool);
  ///@}

  ///@{
  /**
   * Jacobian below which water has foam, 0 to 1; default 0.42. Waves that are left out would fold the surface more: the
   * coarser the surface, the higher the threshold for as much foam. Used with WaterColors.
   */
  vtkSetMacro(FoamThreshold, double);
  vtkGetMacro(FoamThreshold, double);
  ///@}

  ///@{
  /**
   * Time T in which foam that a crest leaves behind fades to 1/e [s], 0 to 100; default 0: none is left. Above 0 there
   * are the point arrays `Foam`, max over ages a of (1 - J(t - a)) exp(-a / T) of the same water, with its Jacobian J,
   * and `Displacement`, the horizontal way of the water from its place at rest [m], and RGB is white where 1 - Foam is
   * below FoamThreshold. Whitecaps fade in 3.85 s in the sea (Monahan and Zietlow 1969).
   */
  vtkSetMacro(FoamLifetime, double);
  vtkGetMacro(FoamLifetime, double);
  ///@}

  ///@{
  /**
   * First and last time of an animation [s], increasing; default 0 60. Any time can be requested.
   */
  vtkSetVector2Macro(TimeRange, double);
  vtkGetVector2Macro(TimeRange, double);
  ///@}

protected:
  vtkSeaSurfaceFilter();
  ~vtkSeaSurfaceFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double Center[2];
  double Radius;
  double Spacing;
  int Sectors;
  double Choppiness;
  bool WaterColors;
  double FoamThreshold;
  double FoamLifetime;
  double TimeRange[2];

private:
  vtkSeaSurfaceFilter(const vtkSeaSurfaceFilter&) = delete;
  void operator=(const vtkSeaSurfaceFilter&) = delete;

  littoral::SeaSurfaceParameters MakeParameters() const;
  std::string WhyBadProperties(double time) const;
  void MakeSurface(
    const littoral::SeaState& sea, const littoral::SeaSurfaceGrid& grid, double time, vtkPolyData* output);
};

#endif
