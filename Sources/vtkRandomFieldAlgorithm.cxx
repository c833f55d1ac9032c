// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRandomFieldAlgorithm.h"

#include "Data/FieldStatistics.h"
#include "Pipeline/Exceptions.h"

#include "vtkMath.h"

//----------------------------------------------------------------------------
vtkRandomFieldAlgorithm::vtkRandomFieldAlgorithm()
  : Model(Fractal)
  , StandardDeviation(40.0)
  , Mean(200.0)
  , Range(1000.0)
  , SecondRange(50.0)
  , FractalDimension(2.15)
  , AnisotropyRatio(1.0)
  , AnisotropyAngle(0.0)
  , NumberOfLines(0)
  , Seed(1)
{
}

//----------------------------------------------------------------------------
vtkRandomFieldAlgorithm::~vtkRandomFieldAlgorithm() = default;

//----------------------------------------------------------------------------
const char* vtkRandomFieldAlgorithm::GetModelAsString() const
{
  return littoral::NameOfRow<littoral::CovarianceModel>(this->Model, littoral::NumberOfCovarianceModels);
}

//----------------------------------------------------------------------------
littoral::FieldStatistics vtkRandomFieldAlgorithm::OwnStatistics() const
{
  littoral::FieldStatistics own;
  own.Field.Model = static_cast<littoral::CovarianceModel>(this->Model);
  own.Field.Variance = this->StandardDeviation * this->StandardDeviation;
  own.Field.Range = this->Range;
  own.Field.SecondRange = this->SecondRange;
  own.Field.FractalDimension = this->FractalDimension;
  own.AnisotropyRatio = this->AnisotropyRatio;
  own.AnisotropyAngle = vtkMath::RadiansFromDegrees(this->AnisotropyAngle);
  own.Mean = this->Mean;
  return own;
}

//----------------------------------------------------------------------------
int vtkRandomFieldAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(
    this, request, outputs, [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkRandomFieldAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Model: " << this->Model << "\n";
  os << indent << "StandardDeviation: " << this->StandardDeviation << "\n";
  os << indent << "Mean: " << this->Mean << "\n";
  os << indent << "Range: " << this->Range << "\n";
  os << indent << "SecondRange: " << this->SecondRange << "\n";
  os << indent << "FractalDimension: " << this->FractalDimension << "\n";
  os << indent << "AnisotropyRatio: " << this->AnisotropyRatio << "\n";
  os << indent << "AnisotropyAngle: " << this->AnisotropyAngle << "\n";
  os << indent << "NumberOfLines: " << this->NumberOfLines << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
