// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkParticleFogFilter
 * @brief   convert particles to an extinction coefficient field
 *
 * Input: a vtkPointSet, or a vtkMultiBlockDataSet or vtkPartitionedDataSetCollection, of which only the block `Far` is
 * used if there is one, else all point sets. Optional point arrays: `Radius` of a particle [m], else ParticleRadius;
 * `Alpha`, the fraction of the particle that is fog, as written by vtkParticleLevelOfDetailFilter, so that the fog
 * fades in as particles fade out; else 1.
 *
 * Output: a vtkImageData with the point array `Extinction` (float) [1/m]: the transmittance of a ray is exp(-integral
 * of Extinction). The extinction cross section of a particle is the area of its disk times ExtinctionEfficiency. It is
 * distributed over the eight neighboring samples; the volume integral of the field, trilinear between samples, is the
 * sum of the cross sections. Field data: `ParticlesInFog`, `ParticlesOutside` of the image, and `CrossSection` [m2],
 * that sum.
 *
 * An input without particles, as before a near view, gives an image of WaterExtinction. Each piece of the image is
 * computed from the whole input. A property out of range or an array value out of range is reported as one error.
 *
 * @sa vtkParticleLevelOfDetailFilter
 */
#ifndef vtkParticleFogFilter_h
#define vtkParticleFogFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <memory> // for what is kept between frames

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

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  enum GridByType
  {
    ByDimensions = 0,
    BySpacing
  };

  ///@{
  /**
   * Definition of the sampling grid, a GridByType; default ByDimensions. ByDimensions: a fixed number of samples over
   * the box. BySpacing: cubic cells of the side Spacing over Bounds, which needs UseBounds.
   */
  vtkSetMacro(GridBy, int);
  vtkGetMacro(GridBy, int);
  void SetGridByToByDimensions() { this->SetGridBy(ByDimensions); }
  void SetGridByToBySpacing() { this->SetGridBy(BySpacing); }
  ///@}

  ///@{
  /**
   * Number of samples along x, y and z, each at least 2; default 64 64 64. Used only if GridBy is ByDimensions.
   */
  vtkSetVector3Macro(Dimensions, int);
  vtkGetVector3Macro(Dimensions, int);
  ///@}

  ///@{
  /**
   * Side of the cubic cells [m], positive; default 0.5. Used only if GridBy is BySpacing.
   */
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * Image over Bounds instead of the bounding box of the particles; default off.
   */
  vtkSetMacro(UseBounds, bool);
  vtkGetMacro(UseBounds, bool);
  vtkBooleanMacro(UseBounds, bool);
  ///@}

  ///@{
  /**
   * Bounds of the image, as minimum and maximum x, y and z [m], increasing; default -10 10 -10 10 -10 0. If GridBy is
   * BySpacing they are rounded up to whole cells. Used only with UseBounds.
   */
  vtkSetVector6Macro(Bounds, double);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /**
   * Radius of particles without the point array `Radius` [m], positive; default 0.005.
   */
  vtkSetMacro(ParticleRadius, double);
  vtkGetMacro(ParticleRadius, double);
  ///@}

  ///@{
  /**
   * Extinction efficiency, the ratio of the extinction cross section to the area of the disk of a particle, not
   * negative; default 1, an opaque disk. Large particles have 2 including diffraction.
   */
  vtkSetMacro(ExtinctionEfficiency, double);
  vtkGetMacro(ExtinctionEfficiency, double);
  ///@}

  ///@{
  /**
   * Extinction coefficient of the water [1/m], not negative, added everywhere; default 0. 0.065 leaves 2 % of the
   * contrast after 60 m.
   */
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

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;

  void CheckProperties() const;
  littoral::FogGrid MakeGrid(const double box[6]) const;
  template <typename Readers>
  void MakeFog(Readers& readers);
};

#endif
