// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Tables.h"

#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

namespace littoral
{

void AddField(vtkDataObject* data, const char* name, std::initializer_list<double> values)
{
  vtkNew<vtkDoubleArray> field;
  field->SetName(name);
  field->SetNumberOfComponents(static_cast<int>(values.size()));
  field->InsertNextTuple(std::data(values));
  data->GetFieldData()->AddArray(field);
}

void AddText(vtkDataObject* data, const char* name, const std::string& text)
{
  vtkNew<vtkStringArray> field;
  field->SetName(name);
  field->InsertNextValue(text);
  data->GetFieldData()->AddArray(field);
}

bool AsksForLaterPiece(vtkInformation* request, vtkInformationVector* outputs)
{
  const int port = std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT()));
  return outputs->GetInformationObject(port)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0;
}

}
