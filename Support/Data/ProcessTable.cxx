// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/ProcessTable.h"

#include "Data/ArrayReader.h"
#include "Data/Inputs.h"
#include "Numerics/ParameterCheck.h"
#include "Patterns/IntensityTrend.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkTable.h"

#include <cmath>
#include <vector>

namespace littoral
{

namespace
{

/// The first row with a process, or -1.
vtkIdType FirstProcess(vtkDataArray* ids)
{
  for (vtkIdType row = 0; row < ids->GetNumberOfTuples(); ++row)
  {
    if (!(ids->GetComponent(row, 0) < 0.0))
    {
      return row;
    }
  }
  return -1;
}

/// The corners of the window that the field data name.
std::string ReadCorners(vtkTable* table, ObservationWindow& window)
{
  ArrayReader fields = ArrayReader::OfFields(table, "the table of fits");
  vtkDataArray* corners = fields.Find("Window", 2);
  fields.NeedFinite(corners);
  if (!fields.IsGood() || !corners)
  {
    return fields.Reason();
  }
  std::vector<PlanePosition> polygon;
  for (vtkIdType n = 0; n < corners->GetNumberOfTuples(); ++n)
  {
    polygon.push_back({ corners->GetComponent(n, 0), corners->GetComponent(n, 1) });
  }
  window = ObservationWindow::Polygon(polygon);
  return window.WhyInvalid();
}

/// The trend of a row: its degree in the column, its coefficients in the field data.
std::string ReadTrend(vtkTable* table, vtkIdType row, const ObservationWindow& window, IntensityRaster& raster)
{
  ArrayReader rows = ArrayReader::OfRows(table, "the table of fits");
  vtkDataArray* degrees = rows.Find("TrendDegree", 1);
  IntensityTrend trend;
  std::string reason = rows.Reason();
  if (degrees && reason.empty())
  {
    ReadWhole("TrendDegree", degrees->GetComponent(row, 0), 0, MostTrendDegree, trend.Degree, reason);
  }
  if (!reason.empty() || trend.Degree == 0)
  {
    return reason;
  }
  ArrayReader fields = ArrayReader::OfFields(table, "the table of fits");
  vtkDataArray* coefficients = fields.Need("Trend", 1);
  fields.NeedFinite(coefficients);
  if (!fields.IsGood())
  {
    return fields.Reason();
  }
  if (coefficients->GetNumberOfTuples() != TermsOfTrend(trend.Degree))
  {
    return "the array Trend of the table of fits has " + std::to_string(coefficients->GetNumberOfTuples()) +
      " numbers; a trend of the degree " + std::to_string(trend.Degree) + " has " +
      std::to_string(TermsOfTrend(trend.Degree)) + ".";
  }
  for (vtkIdType n = 0; n < coefficients->GetNumberOfTuples(); ++n)
  {
    trend.Coefficients.push_back(coefficients->GetComponent(n, 0));
  }
  raster = RasterOf(trend, window);
  return WhyInvalid(raster);
}

}

bool FirstRowIsProcess(vtkTable* table)
{
  ArrayReader rows = ArrayReader::OfRows(table, "the table of fits");
  vtkDataArray* ids = rows.Find("ProcessId", 1);
  return ids && table->GetNumberOfRows() > 0 && FirstProcess(ids) == 0;
}

std::string ReadProcessFit(
  vtkTable* table, PointProcessParameters& process, ObservationWindow& window, IntensityRaster& trend)
{
  ArrayReader rows = ArrayReader::OfRows(table, "the table of fits");
  if (table->GetNumberOfRows() == 0 || !rows.Has("ProcessId"))
  {
    return "the table of fits has no row with a ProcessId; connect the first output of a pattern verdict.";
  }
  vtkDataArray* ids = rows.Need("ProcessId", 1);
  if (!ids)
  {
    return rows.Reason();
  }
  const vtkIdType row = FirstProcess(ids);
  if (row < 0)
  {
    return "no row of the table of fits is a process; all are laws of quadrats.";
  }
  std::string reason;
  ReadWhole("ProcessId", ids->GetComponent(row, 0), 0, NumberOfPointProcesses - 1, process.Process, reason);
  ParameterCheck check;
  check.Require(reason);
  for (const auto* parameter : AllPointProcessParameters())
  {
    vtkDataArray* column = rows.Find(parameter->Name, 1);
    const double number = column ? column->GetComponent(row, 0) : std::nan("");
    if (std::isfinite(number)) // NaN: the process has no such parameter
    {
      check.Within(parameter->Name, number, parameter->Allowed, parameter->Unit);
      parameter->Set(process, number);
    }
  }
  check.Require(rows.Reason());
  check.Require(ReadCorners(table, window));
  return check.IsGood() ? ReadTrend(table, row, window, trend) : check.Reason();
}

std::string ReadIntensity(vtkImageData* image, vtkDataArray* values, IntensityRaster& raster)
{
  if (std::string reason = WhyNoRaster(image, 1); !reason.empty())
  {
    return "the intensity: " + reason;
  }
  if (!values)
  {
    return "the intensity image has no point array of one component to take the intensity from.";
  }
  int extent[6];
  image->GetExtent(extent);
  for (int axis = 0; axis < 2; ++axis)
  {
    raster.Spacing[axis] = image->GetSpacing()[axis];
    raster.Center[axis] = image->GetOrigin()[axis] + extent[2 * axis] * raster.Spacing[axis];
    raster.Count[axis] = extent[2 * axis + 1] - extent[2 * axis] + 1;
  }
  raster.Values.resize(static_cast<std::size_t>(values->GetNumberOfTuples()));
  for (std::size_t n = 0; n < raster.Values.size(); ++n)
  {
    raster.Values[n] = values->GetComponent(static_cast<vtkIdType>(n), 0);
  }
  return WhyInvalid(raster);
}

}
