// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Georeference.h"

#include "Data/ArrayReader.h"
#include "Data/Tables.h"
#include "Numerics/InvalidInput.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkStringArray.h"

namespace littoral
{

namespace
{

constexpr const char* SystemName = "CoordinateSystem";
constexpr const char* UnitName = "CoordinateUnit";
constexpr const char* OffsetName = "CoordinateOffset";

/// The index of a field array; -1 for none.
int IndexOf(vtkDataObject* data, const char* name)
{
  vtkFieldData* fields = data->GetFieldData();
  for (int index = 0; index < fields->GetNumberOfArrays(); ++index)
  {
    const char* own = fields->GetAbstractArray(index)->GetName();
    if (own && std::string(own) == name)
    {
      return index;
    }
  }
  return -1;
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

Georeference ReadGeoreference(vtkDataObject* data)
{
  Georeference place;
  const int index = IndexOf(data, SystemName);
  auto* system = index < 0 ? nullptr : vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(index));
  if (system && system->GetNumberOfValues() > 0)
  {
    place.System = system->GetValue(0);
  }
  const ArrayReader fields = ArrayReader::OfFields(data, "The image", 1);
  vtkDataArray* unit = fields.Find(UnitName, 1);
  vtkDataArray* offset = fields.Find(OffsetName, 2);
  fields.NeedFinite(unit);
  fields.NeedFinite(offset);
  if (unit)
  {
    place.MetresPerUnit = unit->GetComponent(0, 0);
  }
  if (offset)
  {
    place.Offset = { offset->GetComponent(0, 0), offset->GetComponent(0, 1) };
  }
  Require(place.MetresPerUnit > 0.0 ? "" : "The field array CoordinateUnit must be above 0.");
  return place;
}

void PassGeoreference(vtkDataObject* from, vtkDataObject* to)
{
  for (const char* name : { SystemName, UnitName, OffsetName })
  {
    const int index = IndexOf(from, name);
    if (index >= 0)
    {
      to->GetFieldData()->AddArray(from->GetFieldData()->GetAbstractArray(index));
    }
  }
}

}
