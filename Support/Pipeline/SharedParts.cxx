// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SharedParts.h"

#include "Pipeline/RankTeam.h"
#include "Pipeline/SharedKey.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationExecutivePortKey.h"
#include "vtkInformationIdTypeKey.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <vector>

namespace littoral
{

namespace
{

vtkInformationIntegerKey* FormKey()
{
  static auto* key = SharedKey<vtkInformationIntegerKey>("FORM_OF_PARTS");
  return key;
}

/// The time of the change after which an output is asked for by ranks that make it together.
vtkInformationIdTypeKey* TogetherKey()
{
  static auto* key = SharedKey<vtkInformationIdTypeKey>("MADE_TOGETHER");
  return key;
}

/// The output that announces a form of an input's parts; null for none.
vtkInformation* AnnouncementOf(vtkInformation* input, PartForm form)
{
  while (input && !input->Has(FormKey()))
  {
    vtkExecutive* producer = vtkExecutive::PRODUCER()->GetExecutive(input);
    const bool passesOn = producer && producer->GetAlgorithm()->IsA("vtkPVPostFilter");
    input = passesOn ? producer->GetInputInformation(0, 0) : nullptr;
  }
  return input && input->Get(FormKey()) == static_cast<int>(form) ? input : nullptr;
}

/// Time of the last change upstream of an output.
vtkIdType ChangeOf(vtkInformation* output)
{
  auto* producer = vtkDemandDrivenPipeline::SafeDownCast(vtkExecutive::PRODUCER()->GetExecutive(output));
  return producer ? static_cast<vtkIdType>(producer->GetPipelineMTime()) : 0;
}

/// Whether an output has changed since its data were made.
bool HasChanged(vtkInformation* output)
{
  vtkDataObject* data = vtkDataObject::GetData(output);
  return !data || static_cast<vtkIdType>(data->GetUpdateTime()) < ChangeOf(output);
}

void RequestPart(vtkInformation* input, int piece, int pieces)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  input->Set(Pipeline::UPDATE_PIECE_NUMBER(), piece);
  input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), pieces);
  input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
}

}

void AnnouncePartForm(vtkInformation* output, PartForm form)
{
  output->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  output->Set(FormKey(), static_cast<int>(form));
}

void ForgetPartForm(vtkInformation* output)
{
  output->Remove(FormKey());
}

bool ComesInParts(vtkInformation* input, PartForm form)
{
  return AnnouncementOf(input, form) != nullptr;
}

bool IsPart(vtkInformation* input, PartForm form)
{
  vtkDataObject* data = vtkDataObject::GetData(input);
  return data && data->GetInformation()->Get(vtkDataObject::DATA_NUMBER_OF_PIECES()) > 1 && ComesInParts(input, form);
}

void RequestSamePart(vtkInformation* input, vtkInformation* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  // VTK asks for piece -1 where it knows of none.
  RequestPart(input, std::max(0, output->Get(Pipeline::UPDATE_PIECE_NUMBER())),
    std::max(1, output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())));
}

void RequestTogether(vtkInformationVector* inputs)
{
  std::vector<vtkInformation*> outputs;
  bool canShare = true;
  for (int index = 0; index < inputs->GetNumberOfInformationObjects(); ++index)
  {
    outputs.push_back(AnnouncementOf(inputs->GetInformationObject(index), PartForm::Whole));
    canShare &= outputs.back() && HasChanged(outputs.back());
  }
  canShare = RankTeam().HoldsOnAll(canShare);
  for (vtkInformation* output : outputs)
  {
    if (canShare)
    {
      output->Set(TogetherKey(), ChangeOf(output));
    }
    else if (output)
    {
      output->Remove(TogetherKey());
    }
  }
}

bool IsAskedTogether(vtkInformation* output)
{
  const bool isAsked = output->Has(TogetherKey()) && output->Get(TogetherKey()) == ChangeOf(output);
  output->Remove(TogetherKey());
  return isAsked;
}

void RequestNoOtherPart(vtkInformation* input)
{
  vtkDataObject* data = vtkDataObject::GetData(input);
  vtkInformation* own = data ? data->GetInformation() : nullptr;
  if (own && own->Has(vtkDataObject::DATA_NUMBER_OF_PIECES()))
  {
    RequestPart(input, own->Get(vtkDataObject::DATA_PIECE_NUMBER()), own->Get(vtkDataObject::DATA_NUMBER_OF_PIECES()));
  }
}

}
