// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/PointRuns.h"

#include "Pipeline/SharedKey.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationExecutivePortKey.h"
#include "vtkInformationIntegerKey.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

namespace littoral
{

namespace
{

vtkInformationIntegerKey* RunsKey()
{
  static auto* key = SharedKey<vtkInformationIntegerKey>("PARTS_ARE_RUNS");
  return key;
}

}

void AnnounceRuns(vtkInformation* output)
{
  output->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  output->Set(RunsKey(), 1);
}

bool ComesInRuns(vtkInformation* input)
{
  while (input && !input->Has(RunsKey()))
  {
    vtkExecutive* producer = vtkExecutive::PRODUCER()->GetExecutive(input);
    const bool passesOn = producer && producer->GetAlgorithm()->IsA("vtkPVPostFilter");
    input = passesOn ? producer->GetInputInformation(0, 0) : nullptr;
  }
  return input != nullptr;
}

bool IsRun(vtkInformation* input)
{
  vtkDataObject* data = vtkDataObject::GetData(input);
  return data && data->GetInformation()->Get(vtkDataObject::DATA_NUMBER_OF_PIECES()) > 1 && ComesInRuns(input);
}

void RequestSamePart(vtkInformation* input, vtkInformation* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  // VTK asks for piece -1 where it knows of none.
  input->Set(Pipeline::UPDATE_PIECE_NUMBER(), std::max(0, output->Get(Pipeline::UPDATE_PIECE_NUMBER())));
  input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), std::max(1, output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())));
  input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
}

}
