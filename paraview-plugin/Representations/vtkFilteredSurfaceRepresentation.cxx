// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFilteredSurfaceRepresentation.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCompositeDataIterator.h"
#include "vtkDataObjectTree.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPVTrivialProducer.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"

namespace
{

bool IsFirstRank()
{
  vtkMultiProcessController* ranks = vtkMultiProcessController::GetGlobalController();
  return !ranks || ranks->GetLocalProcessId() == 0;
}

/// Whether there is nothing to filter: the output of a source that has reported why.
bool IsEmpty(vtkDataObject* data)
{
  return !data ||
    (data->GetNumberOfElements(vtkDataObject::POINT) == 0 && data->GetNumberOfElements(vtkDataObject::ROW) == 0);
}

/// The same blocks without points: ranks talk about each block of a picture.
vtkSmartPointer<vtkDataObject> EmptyCopy(vtkDataObject* data)
{
  auto copy = vtkSmartPointer<vtkDataObject>::Take(data->NewInstance());
  if (auto* blocks = vtkDataObjectTree::SafeDownCast(data))
  {
    auto* emptied = vtkDataObjectTree::SafeDownCast(copy);
    emptied->CopyStructure(blocks);
    auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      emptied->SetDataSet(
        iterator, vtkSmartPointer<vtkDataObject>::Take(iterator->GetCurrentDataObject()->NewInstance()));
    }
  }
  return copy;
}

}

//----------------------------------------------------------------------------
vtkFilteredSurfaceRepresentation::vtkFilteredSurfaceRepresentation()
{
  this->Shown = vtkSmartPointer<vtkTrivialProducer>::New();
}

//----------------------------------------------------------------------------
vtkFilteredSurfaceRepresentation::~vtkFilteredSurfaceRepresentation() = default;

//----------------------------------------------------------------------------
void vtkFilteredSurfaceRepresentation::SetFilter(vtkAlgorithm* filter)
{
  this->Filter = filter;
}

//----------------------------------------------------------------------------
int vtkFilteredSurfaceRepresentation::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  if (inputVector[0]->GetNumberOfInformationObjects() == 1)
  {
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    vtkInformation* input = inputVector[0]->GetInformationObject(0);
    input->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
    input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkFilteredSurfaceRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (inputVector[0]->GetNumberOfInformationObjects() == 1)
  {
    this->UpdateFilter(inputVector[0]->GetInformationObject(0));
  }
  const int result = this->Superclass::RequestData(request, inputVector, outputVector);
  vtkInformation* output = this->Filter->GetOutputInformation(0);
  if (output && output->Has(vtkStreamingDemandDrivenPipeline::TIME_RANGE()))
  {
    this->SetHasTemporalPipeline(true);
  }
  return result;
}

//----------------------------------------------------------------------------
void vtkFilteredSurfaceRepresentation::UpdateFilter(vtkInformation* input)
{
  vtkAlgorithmOutput* data = this->Superclass::GetInternalOutputPort(0, 0);
  if (!data || IsEmpty(vtkDataObject::GetData(input)))
  {
    vtkNew<vtkPolyData> nothing;
    this->Shown->SetOutput(nothing);
    return;
  }
  // The internal producer of an image has to be told how far the image reaches.
  auto* producer = vtkPVTrivialProducer::SafeDownCast(data->GetProducer());
  if (producer && input->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    producer->SetWholeExtent(input->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()));
  }
  if (this->Filter->GetInputConnection(0, 0) != data)
  {
    this->Filter->SetInputConnection(0, data);
  }
  if (this->GetUpdateTimeValid())
  {
    this->Filter->UpdateTimeStep(this->GetUpdateTime());
  }
  else
  {
    this->Filter->Update();
  }
  vtkDataObject* surface = this->Filter->GetOutputDataObject(0);
  auto shown = IsFirstRank() ? vtkSmartPointer<vtkDataObject>::Take(surface->NewInstance()) : EmptyCopy(surface);
  if (IsFirstRank())
  {
    shown->ShallowCopy(surface);
  }
  this->Shown->SetOutput(shown);
}

//----------------------------------------------------------------------------
vtkAlgorithmOutput* vtkFilteredSurfaceRepresentation::GetInternalOutputPort(int port, int connection)
{
  return this->Superclass::GetInternalOutputPort(port, connection) ? this->Shown->GetOutputPort() : nullptr;
}

//----------------------------------------------------------------------------
void vtkFilteredSurfaceRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Filter: " << this->Filter->GetClassName() << "\n";
}
