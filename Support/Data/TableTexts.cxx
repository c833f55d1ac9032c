// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/TableTexts.h"

#include "Numerics/InvalidInput.h"

#include "vtkDataArray.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkVariant.h"
#include "vtkVariantArray.h"

#include <charconv>
#include <cmath>
#include <string>

namespace littoral
{

namespace
{

std::string TextOfNumber(double number)
{
  if (std::isnan(number))
  {
    return {};
  }
  char text[64];
  if (number == std::floor(number) && std::abs(number) < 1e15)
  {
    return std::to_string(static_cast<long long>(number)); // a name of a plot, and not 1e+05
  }
  return { text, std::to_chars(text, text + sizeof(text), number).ptr }; // the shortest that is read back the same
}

/// A value of a column as a word.
std::string TextAt(vtkAbstractArray* column, vtkIdType row)
{
  if (auto* numbers = vtkDataArray::SafeDownCast(column))
  {
    return TextOfNumber(numbers->GetComponent(row, 0));
  }
  if (auto* words = vtkStringArray::SafeDownCast(column))
  {
    return words->GetValue(row);
  }
  auto* variants = vtkVariantArray::SafeDownCast(column);
  return variants ? std::string(variants->GetValue(row).ToString()) : std::string();
}

}

TextTable TextsOf(vtkTable* table)
{
  TextTable texts;
  const vtkIdType rows = table->GetNumberOfRows();
  for (vtkIdType index = 0; index < table->GetNumberOfColumns(); ++index)
  {
    vtkAbstractArray* column = table->GetColumn(index);
    if (!column || !column->GetName() || column->GetNumberOfComponents() != 1)
    {
      continue;
    }
    if (column->GetNumberOfTuples() != rows)
    {
      Refuse("its column ", column->GetName(), " has ", column->GetNumberOfTuples(), " values for ", rows, " rows.");
    }
    texts.Names.emplace_back(column->GetName());
    std::vector<std::string>& words = texts.Columns.emplace_back();
    words.reserve(static_cast<std::size_t>(rows));
    for (vtkIdType row = 0; row < rows; ++row)
    {
      words.push_back(TextAt(column, row));
    }
  }
  PlainNumbers(texts);
  return texts;
}

}
