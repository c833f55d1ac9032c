// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportTables_h
#define LittoralSupportTables_h

// Columns and field data of the tables that Littoral's analyses write. Private: never installed, never wrapped.

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <initializer_list>
#include <iterator>
#include <string>
#include <type_traits>

class vtkDataObject;
class vtkInformation;
class vtkInformationVector;

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
void AddField(vtkDataObject* data, const char* name, std::initializer_list<double> values);

/// Adds a word to the field data.
void AddText(vtkDataObject* data, const char* name, const std::string& text);

/**
 * A table has no pieces, the first holds all of it, so that a table made on all ranks is shown once: whether a later
 * one is requested. The executive stamps all outputs with the piece of the output that the request comes from.
 */
bool AsksForLaterPiece(vtkInformation* request, vtkInformationVector* outputs);

}

#endif
