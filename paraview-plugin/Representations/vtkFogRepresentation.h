// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFogRepresentation
 * @brief   an image as a volume of which rays take few samples
 *
 * ParaView's Volume takes two samples a voxel, and up to two hundred along each side of an image of fewer voxels. Fog
 * is smooth: this representation takes SampleDistance voxels a step, and begins each ray at a random part of a step, so
 * that no layers appear. Colors, opacities and all else are those of Volume.
 */
#ifndef vtkFogRepresentation_h
#define vtkFogRepresentation_h

#include "LittoralRepresentationsModule.h" // for export macro
#include "vtkImageVolumeRepresentation.h"

class LITTORALREPRESENTATIONS_EXPORT vtkFogRepresentation : public vtkImageVolumeRepresentation
{
public:
  static vtkFogRepresentation* New();
  vtkTypeMacro(vtkFogRepresentation, vtkImageVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Distance of samples along a ray [voxels of mean spacing]. Default 1, from 0.1 to 10.
   */
  vtkSetClampMacro(SampleDistance, double, 0.1, 10.0);
  vtkGetMacro(SampleDistance, double);
  ///@}

protected:
  vtkFogRepresentation();
  ~vtkFogRepresentation() override;

  void UpdateMapperParameters() override;

private:
  vtkFogRepresentation(const vtkFogRepresentation&) = delete;
  void operator=(const vtkFogRepresentation&) = delete;

  double SampleDistance = 1.0;
};

#endif
