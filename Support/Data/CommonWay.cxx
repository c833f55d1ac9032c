// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/CommonWay.h"

#include "Data/ArrayReader.h"
#include "Data/SeaStateTable.h"
#include "Numerics/InvalidInput.h"
#include "Pipeline/SharedKey.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationIdTypeKey.h"

namespace littoral
{

namespace
{

vtkInformationDoubleVectorKey* Way()
{
  static auto* key = SharedKey<vtkInformationDoubleVectorKey>("COMMON_WAY");
  return key;
}

/// Modification time of the places that had gone it.
vtkInformationIdTypeKey* WayTime()
{
  static auto* key = SharedKey<vtkInformationIdTypeKey>("COMMON_WAY_TIME");
  return key;
}

/// Memory of the numbers of the other array, which its copies share.
vtkInformationIdTypeKey* WayStart()
{
  static auto* key = SharedKey<vtkInformationIdTypeKey>("COMMON_WAY_START");
  return key;
}

vtkIdType MemoryOf(vtkDataArray* array)
{
  return reinterpret_cast<vtkIdType>(array->GetVoidPointer(0)); // compared, never used
}

}

void KeepCommonWay(vtkDataArray* places, vtkDataArray* start, const Vector3& way)
{
  vtkInformation* info = places->GetInformation();
  info->Set(Way(), &way.x, 3);
  info->Set(WayTime(), static_cast<vtkIdType>(places->GetMTime()));
  info->Set(WayStart(), MemoryOf(start));
}

void RequireInPlace(vtkDataObject* points)
{
  const bool isInPlace = !ArrayReader::OfFields(points, "Input").Has(sea::Way);
  Require(isInPlace ? "" : "take Way As Field of the current off: the points are not where it carries them.");
}

std::optional<Vector3> CommonWayOf(vtkDataArray* places, vtkDataArray* start)
{
  vtkInformation* info = places->HasInformation() ? places->GetInformation() : nullptr;
  const bool isKept = info && info->Has(Way()) && places->GetNumberOfTuples() == start->GetNumberOfTuples() &&
    places->GetDataType() == start->GetDataType() && info->Get(WayStart()) == MemoryOf(start) &&
    info->Get(WayTime()) == static_cast<vtkIdType>(places->GetMTime());
  if (!isKept)
  {
    return {};
  }
  const double* way = info->Get(Way());
  return Vector3(way[0], way[1], way[2]);
}

}
