// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNormalScoresFilter.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/Inputs.h"
#include "Data/Tables.h"
#include "Kriging/NormalScores.h"
#include "Pipeline/Pipeline.h"

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <array>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkNormalScoresFilter);

//----------------------------------------------------------------------------
vtkNormalScoresFilter::vtkNormalScoresFilter()
  : Inverse(false)
{
  this->SetNumberOfInputPorts(2);
  for (int port : { 0, 1 })
  {
    this->SetInputArrayToProcess(port, port, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  }
}

//----------------------------------------------------------------------------
vtkNormalScoresFilter::~vtkNormalScoresFilter() = default;

//----------------------------------------------------------------------------
int vtkNormalScoresFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkNormalScoresFilter::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  littoral::AnnounceParts(outputs->GetInformationObject(0)); // else each rank would be asked for the whole image
  return this->Superclass::RequestInformation(request, inputs, outputs);
}

//----------------------------------------------------------------------------
int vtkNormalScoresFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // The distribution is that of the whole: every rank reads all of it.
  for (int port : { 0, 1 })
  {
    littoral::RequestAll(inputVector[port]->GetInformationObject(0));
  }
  return 1;
}

//----------------------------------------------------------------------------
vtkDataArray* vtkNormalScoresFilter::Values(int port, vtkInformationVector** inputVector, vtkDataSet*& data)
{
  const char* owner = port == 0 ? "Input" : "Reference";
  if (vtkImageData::SafeDownCast(vtkDataObject::GetData(inputVector[port])))
  {
    data = littoral::InputOf<vtkImageData>(inputVector[port], owner);
  }
  else
  {
    data = littoral::InputOf<vtkPointSet>(inputVector[port], owner);
  }
  vtkInformation* choice = this->GetInputArrayInformation(port);
  vtkDataArray* array = this->GetInputArrayToProcess(port, inputVector);
  if (!array && littoral::NamesDefaultElevation(choice))
  {
    array = data->GetPointData()->GetScalars();
  }
  const char* name = choice->Get(vtkDataObject::FIELD_NAME());
  if (!array)
  {
    const bool isNamed = name && !littoral::NamesNoArray(choice);
    littoral::Refuse(owner, isNamed ? " has no array '" + std::string(name) + "'." : " has no scalar point array.");
  }
  return littoral::ArrayReader::OfPoints(data, owner).Fit(array, 1);
}

//----------------------------------------------------------------------------
int vtkNormalScoresFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  littoral::ForgetExtent(info);
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  vtkDataSet* input = nullptr;
  vtkDataSet* reference = nullptr;
  vtkDataArray* values = this->Values(0, inputVector, input);
  const bool hasReference = inputVector[1]->GetNumberOfInformationObjects() > 0;
  vtkDataArray* known = hasReference ? this->Values(1, inputVector, reference) : values;
  littoral::Require(this->Inverse && !hasReference
      ? "The way back from scores to values needs a Reference whose distribution they take."
      : "");
  littoral::RequireMemory(16.0 * static_cast<double>(known->GetNumberOfTuples() + values->GetNumberOfTuples()),
    "Scores of " + std::to_string(values->GetNumberOfTuples()) + " values", "take fewer");
  std::vector<double> distribution;
  for (vtkIdType n = 0; n < known->GetNumberOfTuples(); ++n)
  {
    const double value = known->GetComponent(n, 0);
    if (std::isfinite(value))
    {
      distribution.push_back(value);
    }
  }
  const littoral::NormalScores scores(std::move(distribution));
  if (scores.IsEmpty())
  {
    littoral::Refuse(hasReference ? "Reference" : "Input", " has no two different values, and so no distribution.");
  }
  for (vtkIdType n = 0; n < values->GetNumberOfTuples(); ++n)
  {
    if (std::isnan(values->GetComponent(n, 0)))
    {
      littoral::Refuse("Value ", n, " of the input is NaN, which has no score; fill holes first.");
    }
  }
  output->ShallowCopy(input);
  const char* name = known->GetName() && *known->GetName() ? known->GetName() : "Elevation";
  const vtkIdType count = values->GetNumberOfTuples();
  auto mapped = littoral::NewArray<vtkDoubleArray>(this->Inverse ? name : "NormalScores", 1, count);
  const bool inverse = this->Inverse;
  littoral::AbortableFor(this)(static_cast<std::size_t>(count), [&](std::size_t begin, std::size_t end) {
    for (auto n = static_cast<vtkIdType>(begin); n < static_cast<vtkIdType>(end); ++n)
    {
      const double value = values->GetComponent(n, 0);
      mapped->SetValue(n, inverse ? scores.ValueOf(value) : scores.ScoreOf(value));
    }
  });
  output->GetAttributes(vtkDataObject::POINT)->SetScalars(mapped);
  if (auto* image = vtkImageData::SafeDownCast(output))
  {
    std::array<int, 6> extent = littoral::RequestedExtent(info);
    image->Crop(extent.data());
  }
  else if (littoral::AsksForLaterPiece(request, outputVector))
  {
    output->Initialize(); // the first piece has all points
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkNormalScoresFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(this, request, outputs,
    "Cannot make normal scores: ", [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkNormalScoresFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Inverse: " << (this->Inverse ? "on" : "off") << "\n";
}
