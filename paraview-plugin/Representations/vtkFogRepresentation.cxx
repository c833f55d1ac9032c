// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFogRepresentation.h"

#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkSmartVolumeMapper.h"

namespace
{

/// A volume mapper that keeps to its sample distance.
class FogMapper : public vtkSmartVolumeMapper
{
public:
  static FogMapper* New();

protected:
  FogMapper()
  {
    this->AutoAdjustSampleDistancesOff();
    this->InteractiveAdjustSampleDistancesOff();
    this->UseJitteringOn();
    this->GPUMapper->LockSampleDistanceToInputSpacingOff();
  }
};
vtkStandardNewMacro(FogMapper);

}

vtkStandardNewMacro(vtkFogRepresentation);

//----------------------------------------------------------------------------
vtkFogRepresentation::vtkFogRepresentation()
{
  vtkNew<FogMapper> mapper;
  this->VolumeMapper = mapper;
}

//----------------------------------------------------------------------------
vtkFogRepresentation::~vtkFogRepresentation() = default;

//----------------------------------------------------------------------------
void vtkFogRepresentation::UpdateMapperParameters()
{
  this->Superclass::UpdateMapperParameters();
  auto* mapper = vtkSmartVolumeMapper::SafeDownCast(this->VolumeMapper);
  if (vtkImageData* image = vtkImageData::SafeDownCast(this->Cache); mapper && image)
  {
    const double* spacing = image->GetSpacing();
    mapper->SetSampleDistance(static_cast<float>(this->SampleDistance * (spacing[0] + spacing[1] + spacing[2]) / 3.0));
  }
}

//----------------------------------------------------------------------------
void vtkFogRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SampleDistance: " << this->SampleDistance << "\n";
}
