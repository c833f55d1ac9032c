// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/ArrayReader.h"

#include "Data/ArraySearch.h"
#include "Numerics/ParameterCheck.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

std::string Components(int count)
{
  return std::to_string(count) + (count == 1 ? " component" : " components");
}

}

ArrayReader::ArrayReader(
  vtkFieldData* arrays, vtkIdType tuples, const char* kind, const char* elements, const std::string& owner)
  : Arrays(arrays)
  , Tuples(tuples)
  , Kind(kind)
  , Elements(elements)
  , Owner(owner)
{
}

ArrayReader ArrayReader::OfPoints(vtkDataSet* data, const std::string& owner)
{
  return { data->GetPointData(), data->GetNumberOfPoints(), "point array", "points", owner };
}

ArrayReader ArrayReader::OfCells(vtkDataSet* data, const std::string& owner)
{
  return { data->GetCellData(), data->GetNumberOfCells(), "cell array", "cells", owner };
}

ArrayReader ArrayReader::OfRows(vtkTable* table, const std::string& owner)
{
  return { table->GetRowData(), table->GetNumberOfRows(), "column", "rows", owner };
}

ArrayReader ArrayReader::OfFields(vtkDataObject* data, const std::string& owner, vtkIdType tuples)
{
  return { data->GetFieldData(), tuples, "field array", tuples == 1 ? "number" : "numbers", owner };
}

void ArrayReader::Complain(const std::string& predicate)
{
  this->First = this->First.empty() ? this->Owner + " has " + predicate + "." : this->First;
}

std::vector<vtkDataArray*> ArrayReader::All(int components) const
{
  std::vector<vtkDataArray*> all;
  for (int index = 0; index < this->Arrays->GetNumberOfArrays(); ++index)
  {
    ArrayReader reader = *this;
    vtkAbstractArray* array = this->Arrays->GetAbstractArray(index);
    if (vtkDataArray* numbers = reader.Check(array, array->GetName(), components, VTK_VOID))
    {
      all.push_back(numbers);
    }
  }
  return all;
}

vtkDataArray* ArrayReader::Any(const char* name) const
{
  vtkAbstractArray* array = this->Arrays->GetAbstractArray(name);
  ArrayReader reader = *this;
  return array ? reader.Check(array, name, array->GetNumberOfComponents(), VTK_VOID) : nullptr;
}

vtkStringArray* ArrayReader::FindTexts(const char* name)
{
  auto* texts = this->Arrays ? vtkStringArray::SafeDownCast(this->Arrays->GetAbstractArray(name)) : nullptr;
  if (texts && (texts->GetNumberOfComponents() != 1 || texts->GetNumberOfTuples() != this->Tuples))
  {
    this->Complain(
      std::string("a ") + this->Kind + " " + name + " that has not one text for each of its " + this->Elements);
    return nullptr;
  }
  return texts;
}

bool ArrayReader::Has(const char* name) const
{
  return this->Arrays && this->Arrays->GetAbstractArray(name);
}

vtkDataArray* ArrayReader::Take(const char* name, int components, int type, bool isNeeded)
{
  vtkAbstractArray* array = this->Arrays ? this->Arrays->GetAbstractArray(name) : nullptr;
  if (!array && isNeeded)
  {
    this->Complain(std::string("no ") + this->Kind + " " + name + " of " + Components(components));
  }
  return this->Check(array, name, components, type);
}

vtkDataArray* ArrayReader::Check(vtkAbstractArray* array, const char* name, int components, int type)
{
  if (!array)
  {
    return nullptr;
  }
  const std::string own = std::string("a ") + this->Kind + " " + (name ? name : "without a name");
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if (!numbers)
  {
    this->Complain(own + " that holds no numbers");
  }
  else if (array->GetNumberOfComponents() != components)
  {
    this->Complain(
      own + " of " + Components(array->GetNumberOfComponents()) + "; it must have " + std::to_string(components));
  }
  else if (this->Tuples >= 0 && array->GetNumberOfTuples() != this->Tuples)
  {
    this->Complain(own + " of " + std::to_string(array->GetNumberOfTuples()) + " values for " +
      std::to_string(this->Tuples) + " " + this->Elements);
  }
  else if (type != VTK_VOID && (array->GetDataType() != type || !array->HasStandardMemoryLayout()))
  {
    this->Complain(
      own + " of " + array->GetDataTypeAsString() + "; it must be of " + vtkImageScalarTypeNameMacro(type));
  }
  else
  {
    return numbers;
  }
  return nullptr;
}

void ArrayReader::NeedFinite(vtkDataArray* array)
{
  const auto isSmall = [](auto value) { return std::abs(static_cast<double>(value)) <= LargestMagnitude; };
  const vtkIdType bad = FirstOutside(array, isSmall);
  if (bad >= 0)
  {
    const vtkIdType tuple = bad / array->GetNumberOfComponents();
    const int component = static_cast<int>(bad % array->GetNumberOfComponents());
    const bool isFinite = std::isfinite(array->GetComponent(tuple, component));
    this->Complain(std::string("a ") + this->Kind + " " + (array->GetName() ? array->GetName() : "without a name") +
      " that is " + (isFinite ? "beyond " + TextOf(LargestMagnitude) : "not finite") + " at " + std::to_string(tuple));
  }
}

void ArrayReader::NeedIds(vtkDataArray* array, vtkIdType count, const char* of, vtkIdType lowest)
{
  const vtkIdType bad = FirstOutside(array, IsWithin{ static_cast<double>(lowest), static_cast<double>(count) });
  if (bad >= 0)
  {
    const int components = array->GetNumberOfComponents();
    const double id = array->GetComponent(bad / components, static_cast<int>(bad % components));
    this->First = this->First.empty()
      ? array->GetName() + (" of " + this->Owner) + " names " + of + " " + TextOf(id) + ", which does not exist."
      : this->First;
  }
}

bool ReadWhole(
  const std::string& name, double number, long long low, long long high, long long& whole, std::string& reason)
{
  const bool isGood = number >= static_cast<double>(low) && number <= static_cast<double>(high) &&
    number == std::floor(number) && std::abs(number) < 9e18;
  if (isGood)
  {
    whole = static_cast<long long>(number);
    return true;
  }
  ParameterCheck check;
  check.Require(false, name, number, "", "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  reason = reason.empty() ? check.Reason() : reason;
  return false;
}

}
