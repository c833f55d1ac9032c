// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportTables_h
#define LittoralSupportTables_h

// Columns and field data of the tables that Littoral's analyses write. Private: never installed, never wrapped.

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <initializer_list>
#include <iterator>
#include <string>
#include <type_traits>

namespace littoral
{

/// Adds a column with one value for each row's record; its type follows what valueOf returns (text, int or double).
template <typename Records, typename ValueOf>
void AddColumn(vtkTable* table, const char* name, const Records& records, const ValueOf& valueOf)
{
  using Value = std::decay_t<decltype(valueOf(*std::begin(records)))>;
  using Array = std::conditional_t<std::is_same_v<Value, std::string>, vtkStringArray,
    std::conditional_t<std::is_same_v<Value, int>, vtkIntArray, vtkDoubleArray>>;
  vtkNew<Array> column;
  column->SetName(name);
  for (const auto& record : records)
  {
    column->InsertNextValue(valueOf(record));
  }
  table->AddColumn(column);
}

/// Adds one tuple of numbers to the field data.
inline void AddField(vtkDataObject* data, const char* name, std::initializer_list<double> values)
{
  vtkNew<vtkDoubleArray> field;
  field->SetName(name);
  field->SetNumberOfComponents(static_cast<int>(values.size()));
  field->InsertNextTuple(std::data(values));
  data->GetFieldData()->AddArray(field);
}

/// Adds a word to the field data.
inline void AddText(vtkDataObject* data, const char* name, const std::string& text)
{
  vtkNew<vtkStringArray> field;
  field->SetName(name);
  field->InsertNextValue(text);
  data->GetFieldData()->AddArray(field);
}

/// A table has no pieces, the first holds all of it: whether all outputs are asked for later ones only.
inline bool AsksForLaterPieces(vtkInformationVector* outputs)
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

#endif
