// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Georeference.h"

#include "Data/Tables.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkStringArray.h"

#include <cmath>

namespace littoral
{

namespace
{

constexpr const char* SystemName = "CoordinateSystem";
constexpr const char* UnitName = "CoordinateUnit";
constexpr const char* OffsetName = "CoordinateOffset";

/// Numbers of a field array; false with a reason if there are others than `count` finite ones. Absent is good.
bool ReadNumbers(vtkFieldData* fields, const char* name, int count, double* numbers, std::string& reason)
{
  if (!fields->GetAbstractArray(name))
  {
    return true;
  }
  vtkDataArray* array = fields->GetArray(name);
  bool isGood = array && array->GetNumberOfValues() == count;
  for (int i = 0; isGood && i < count; ++i)
  {
    numbers[i] = array->GetComponent(i / array->GetNumberOfComponents(), i % array->GetNumberOfComponents());
    isGood = std::isfinite(numbers[i]);
  }
  if (!isGood && reason.empty())
  {
    reason = std::string("The field array ") + name + " must be " + std::to_string(count) + " finite number" +
      (count > 1 ? "s." : ".");
  }
  return isGood;
}

}

void AddGeoreference(vtkDataObject* data, const Georeference& place)
{
  if (!place.System.empty())
  {
    AddText(data, SystemName, place.System);
    AddField(data, UnitName, { place.MetresPerUnit });
  }
  if (!place.System.empty() || place.Offset[0] != 0.0 || place.Offset[1] != 0.0)
  {
    AddField(data, OffsetName, { place.Offset[0], place.Offset[1] });
  }
}

Georeference ReadGeoreference(vtkDataObject* data, std::string& reason)
{
  Georeference place;
  vtkFieldData* fields = data->GetFieldData();
  if (auto* system = vtkStringArray::SafeDownCast(fields->GetAbstractArray(SystemName)))
  {
    place.System = system->GetNumberOfValues() > 0 ? static_cast<std::string>(system->GetValue(0)) : std::string();
  }
  const bool isRead = ReadNumbers(fields, UnitName, 1, &place.MetresPerUnit, reason) &&
    ReadNumbers(fields, OffsetName, 2, place.Offset.data(), reason);
  if (isRead && !(place.MetresPerUnit > 0.0) && reason.empty())
  {
    reason = "The field array CoordinateUnit must be above 0.";
  }
  return place;
}

void PassGeoreference(vtkDataObject* from, vtkDataObject* to)
{
  for (const char* name : { SystemName, UnitName, OffsetName })
  {
    if (vtkAbstractArray* array = from->GetFieldData()->GetAbstractArray(name))
    {
      to->GetFieldData()->AddArray(array);
    }
  }
}

}
