// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/ArrayReader.h"

#include "Data/ArraySearch.h"
#include "Numerics/InvalidInput.h"
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

std::vector<vtkDataArray*> ArrayReader::All(int components) const
{
  std::vector<vtkDataArray*> all;
  for (int index = 0; index < this->Arrays->GetNumberOfArrays(); ++index)
  {
    if (vtkDataArray* numbers = this->IfFits(this->Arrays->GetAbstractArray(index), components, VTK_VOID))
    {
      all.push_back(numbers);
    }
  }
  return all;
}

vtkDataArray* ArrayReader::Any(const char* name) const
{
  vtkAbstractArray* array = this->Named(name);
  return array ? this->IfFits(array, array->GetNumberOfComponents(), VTK_VOID) : nullptr;
}

vtkStringArray* ArrayReader::FindTexts(const char* name) const
{
  auto* texts = vtkStringArray::SafeDownCast(this->Named(name));
  const bool isAny = this->Tuples < 0;
  if (texts && (texts->GetNumberOfComponents() != 1 || (!isAny && texts->GetNumberOfTuples() != this->Tuples)))
  {
    Refuse(
      this->Owner, " has a ", this->Kind, " ", name, " that has not one text for each of its ", this->Elements, ".");
  }
  return texts;
}

bool ArrayReader::Has(const char* name) const
{
  return this->Named(name);
}

vtkAbstractArray* ArrayReader::Named(const char* name) const
{
  return this->Arrays ? this->Arrays->GetAbstractArray(name) : nullptr;
}

vtkDataArray* ArrayReader::Take(const char* name, int components, int type, bool isNeeded) const
{
  vtkAbstractArray* array = this->Named(name);
  if (!array && isNeeded)
  {
    Refuse(this->Owner, " has no ", this->Kind, " ", name, " of ", Components(components), ".");
  }
  return this->Check(array, name, components, type);
}

vtkDataArray* ArrayReader::Check(vtkAbstractArray* array, const char* name, int components, int type) const
{
  const std::string why = array ? this->WhyOther(array, components, type) : "";
  if (!why.empty())
  {
    Refuse(this->Owner, " has a ", this->Kind, " ", name ? name : "without a name", why, ".");
  }
  return vtkDataArray::SafeDownCast(array);
}

vtkDataArray* ArrayReader::IfFits(vtkAbstractArray* array, int components, int type) const
{
  return array && this->WhyOther(array, components, type).empty() ? vtkDataArray::SafeDownCast(array) : nullptr;
}

/// Words for an array of another form, after "has a point array Velocity"; empty if it has the form.
std::string ArrayReader::WhyOther(vtkAbstractArray* array, int components, int type) const
{
  if (!vtkDataArray::SafeDownCast(array))
  {
    return " that holds no numbers";
  }
  if (array->GetNumberOfComponents() != components)
  {
    return " of " + Components(array->GetNumberOfComponents()) + "; it must have " + std::to_string(components);
  }
  if (this->Tuples >= 0 && array->GetNumberOfTuples() != this->Tuples)
  {
    return " of " + std::to_string(array->GetNumberOfTuples()) + " values for " + std::to_string(this->Tuples) + " " +
      this->Elements;
  }
  if (type != VTK_VOID && (array->GetDataType() != type || !array->HasStandardMemoryLayout()))
  {
    return std::string(" of ") + array->GetDataTypeAsString() + "; it must be of " + vtkImageScalarTypeNameMacro(type);
  }
  return {};
}

void ArrayReader::NeedFinite(vtkDataArray* array) const
{
  const auto isSmall = [](auto value) { return std::abs(static_cast<double>(value)) <= MaximumMagnitude; };
  const vtkIdType bad = FirstOutside(array, isSmall);
  if (bad >= 0)
  {
    const vtkIdType tuple = bad / array->GetNumberOfComponents();
    const int component = static_cast<int>(bad % array->GetNumberOfComponents());
    const bool isFinite = std::isfinite(array->GetComponent(tuple, component));
    Refuse(this->Owner, " has a ", this->Kind, " ", array->GetName() ? array->GetName() : "without a name", " that is ",
      isFinite ? "beyond " + TextOf(MaximumMagnitude) : "not finite", " at ", tuple, ".");
  }
}

void ArrayReader::NeedIds(vtkDataArray* array, vtkIdType count, const char* of, vtkIdType lowest) const
{
  const vtkIdType bad = FirstOutside(array, IsWithin{ static_cast<double>(lowest), static_cast<double>(count) });
  if (bad >= 0)
  {
    const int components = array->GetNumberOfComponents();
    const double id = array->GetComponent(bad / components, static_cast<int>(bad % components));
    Refuse(array->GetName(), " of ", this->Owner, " names ", of, " ", TextOf(id), ", which does not exist.");
  }
}

bool IsWhole(double number, long long low, long long high)
{
  return number >= static_cast<double>(low) && number <= static_cast<double>(high) && number == std::floor(number) &&
    std::abs(number) < 9e18;
}

void RequireWhole(const std::string& name, double number, long long low, long long high)
{
  if (!IsWhole(number, low, high))
  {
    ParameterCheck check;
    check.Require(
      false, name, number, "", "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    Require(check.Reason());
  }
}

}
