// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkParticleRepresentation
 * @brief   points as soft spots that fade in water, without a copy of them
 *
 * ParaView's Point Gaussian copies all points and their arrays one by one at each time. This representation draws those
 * that are vertices already, as particles are, and may make their opacities:
 *
 *     opacity = Strength Alpha exp(-Extinction d),
 *
 * with the point array Alpha, or 1, and the distance d from Eye. All else is as in Point Gaussian, which has no
 * opacities where points have no colors.
 */
#ifndef vtkParticleRepresentation_h
#define vtkParticleRepresentation_h

#include "LittoralRepresentationsModule.h" // for export macro
#include "vtkPointGaussianRepresentation.h"

class LITTORALREPRESENTATIONS_EXPORT vtkParticleRepresentation : public vtkPointGaussianRepresentation
{
public:
  static vtkParticleRepresentation* New();
  vtkTypeMacro(vtkParticleRepresentation, vtkPointGaussianRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int ProcessViewRequest(vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

  ///@{
  /**
   * Extinction of the water [1/m], by which particles fade. Default 0, from 0 to 1000. With 0 and a Strength of 1,
   * opacities are those of Point Gaussian.
   */
  void SetExtinction(double extinction);
  vtkGetMacro(Extinction, double);
  ///@}

  ///@{
  /**
   * Opacity of a particle at Eye whose Alpha is 1. Default 1, from 0 to 1.
   */
  void SetStrength(double strength);
  vtkGetMacro(Strength, double);
  ///@}

  ///@{
  /**
   * Eye, from which distances count [m]; default 0 0 0.
   */
  void SetEye(double x, double y, double z);
  vtkGetVector3Macro(Eye, double);
  ///@}

protected:
  vtkParticleRepresentation();
  ~vtkParticleRepresentation() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkParticleRepresentation(const vtkParticleRepresentation&) = delete;
  void operator=(const vtkParticleRepresentation&) = delete;

  bool Fades() const { return this->Extinction > 0.0 || this->Strength != 1.0; }

  double Extinction = 0.0;
  double Strength = 1.0;
  double Eye[3] = { 0.0, 0.0, 0.0 };
};

#endif
