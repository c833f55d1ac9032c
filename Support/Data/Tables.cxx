// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Tables.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

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

bool AsksForLaterPieces(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    if (outputs->GetInformationObject(port)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) <= 0)
    {
      return false;
    }
  }
  return true;
}

}
