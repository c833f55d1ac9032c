// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlowPrimitiveSource.h"

#include "Data/FlowPrimitiveData.h"
#include "Numerics/ParameterTraits.h"
#include "Pipeline/Pipeline.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <string>

vtkStandardNewMacro(vtkFlowPrimitiveSource);

//----------------------------------------------------------------------------
vtkFlowPrimitiveSource::vtkFlowPrimitiveSource()
  : FlowType(Uniform)
  , Strength(0.2)
  , Center{ 0.0, 0.0, 0.0 }
  , Axis{ 1.0, 0.0, 0.0 }
  , CoreRadius(0.5)
  , InfluenceRadius(0.0)
{
  this->SetNumberOfInputPorts(0);
}

//----------------------------------------------------------------------------
vtkFlowPrimitiveSource::~vtkFlowPrimitiveSource() = default;

//----------------------------------------------------------------------------
int vtkFlowPrimitiveSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//----------------------------------------------------------------------------
int vtkFlowPrimitiveSource::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  littoral::FlowPrimitive primitive;
  primitive.Type = static_cast<littoral::FlowType>(this->FlowType);
  primitive.Strength = this->Strength;
  primitive.Center = { this->Center[0], this->Center[1], this->Center[2] };
  primitive.Axis = { this->Axis[0], this->Axis[1], this->Axis[2] };
  primitive.CoreRadius = this->CoreRadius;
  primitive.InfluenceRadius = this->InfluenceRadius;
  littoral::Require(littoral::WhyInvalid(primitive));
  // The first piece holds the primitive; else each rank would add its own.
  vtkInformation* info = outputVector->GetInformationObject(0);
  if (info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) <= 0)
  {
    littoral::WriteFlowPrimitives({ primitive }, vtkPolyData::GetData(outputVector));
  }
  return 1;
}

//----------------------------------------------------------------------------
const char* vtkFlowPrimitiveSource::GetFlowTypeAsString() const
{
  return littoral::NameOfRow<littoral::FlowType>(this->FlowType, littoral::NumberOfFlowTypes);
}

//----------------------------------------------------------------------------
int vtkFlowPrimitiveSource::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(this, request, outputs,
    "Cannot make a flow: ", [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkFlowPrimitiveSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FlowType: " << this->FlowType << "\n";
  os << indent << "Strength: " << this->Strength << "\n";
  os << indent << "Center: " << this->Center[0] << " " << this->Center[1] << " " << this->Center[2] << "\n";
  os << indent << "Axis: " << this->Axis[0] << " " << this->Axis[1] << " " << this->Axis[2] << "\n";
  os << indent << "CoreRadius: " << this->CoreRadius << "\n";
  os << indent << "InfluenceRadius: " << this->InfluenceRadius << "\n";
}
