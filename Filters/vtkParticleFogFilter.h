// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkParticleFogFilter
 * @brief   the fog that far particles are
 *
 * Input: a vtkPointSet, or a vtkMultiBlockDataSet or vtkPartitionedDataSetCollection, of which the block `Far` counts
 * if there is one, else all point sets. Optional point arrays: `Radius` of a particle [m], else ParticleRadius;
 * `Alpha`, how much of it is fog, as vtkParticleLevelOfDetailFilter tells, so that the fog fades in as particles fade
 * out; else 1.
 *
 * Output: a vtkImageData with the point array `Extinction` (float) [1/m]: light that has gone a way through it is
 * dimmed by e to the power of minus its integral. A particle takes the area of its disc from the light, times
 * ExtinctionEfficiency. It is shared out among the eight samples about it; the integral over the image of the field,
 * linear between samples, is the sum of these areas. Field data: `ParticlesInFog`, `ParticlesOutside` of the image, and
 * `CrossSection` [m2], that sum.
 *
 * No particles, as before a near view, give an image of WaterExtinction. Each piece of the image is made of the whole
 * input.
 *
 * @sa vtkParticleLevelOfDetailFilter
 */
#ifndef vtkParticleFogFilter_h
#define vtkParticleFogFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <string> // for reasons

namespace littoral
{
struct FogGrid;
}

class LITTORALFILTERS_EXPORT vtkParticleFogFilter : public vtkImageAlgorithm
{
public:
  static vtkParticleFogFilter* New();
  vtkTypeMacro(vtkParticleFogFilter, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum GridRules
  {
    ByDimensions = 0,
    BySpacing
  };

  ///@{
  /// ByDimensions: so many samples over the box. BySpacing: cubes of a side over Bounds, which UseBounds must switch
  /// on. Default ByDimensions.
  vtkSetMacro(GridBy, int);
  vtkGetMacro(GridBy, int);
  ///@}

  ///@{
  /// Samples along x, y, z, each 2 or more; of no effect by spacing. Default 64 64 64.
  vtkSetVector3Macro(Dimensions, int);
  vtkGetVector3Macro(Dimensions, int);
  ///@}

  ///@{
  /// Side of the cubes [m], positive; of no effect by dimensions. Default 0.5.
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /// Whether Bounds tell the box of the image; else it is that of the particles. Default off.
  vtkSetMacro(UseBounds, bool);
  vtkGetMacro(UseBounds, bool);
  vtkBooleanMacro(UseBounds, bool);
  ///@}

  ///@{
  /// Smallest and largest x, y, z of the image [m]; by spacing, rounded up to whole cubes. Of no effect without
  /// UseBounds. Default -10 10 -10 10 -10 0.
  vtkSetVector6Macro(Bounds, double);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /// Of particles without an array Radius [m], positive. Default 0.005.
  vtkSetMacro(ParticleRadius, double);
  vtkGetMacro(ParticleRadius, double);
  ///@}

  ///@{
  /// Light that a particle takes, by what its disc would, not negative. 1: what a drawn particle hides. 2: with what
  /// large particles diffract out of the way. Default 1.
  vtkSetMacro(ExtinctionEfficiency, double);
  vtkGetMacro(ExtinctionEfficiency, double);
  ///@}

  ///@{
  /// Of the water itself [1/m], not negative, added everywhere. Water in which 2 % of the contrast is left after 60 m
  /// has 0.065. Default 0.
  vtkSetMacro(WaterExtinction, double);
  vtkGetMacro(WaterExtinction, double);
  ///@}

protected:
  vtkParticleFogFilter();
  ~vtkParticleFogFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int GridBy;
  int Dimensions[3];
  double Spacing;
  bool UseBounds;
  double Bounds[6];
  double ParticleRadius;
  double ExtinctionEfficiency;
  double WaterExtinction;

private:
  vtkParticleFogFilter(const vtkParticleFogFilter&) = delete;
  void operator=(const vtkParticleFogFilter&) = delete;

  std::string WhyBadProperties() const;
  littoral::FogGrid MakeGrid(const double box[6]) const;
};

#endif
