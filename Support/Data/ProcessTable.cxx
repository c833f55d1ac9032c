// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/ProcessTable.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
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
void ReadCorners(vtkTable* table, ObservationWindow& window)
{
  const ArrayReader fields = ArrayReader::OfFields(table, "the table of fits");
  vtkDataArray* corners = fields.Find("Window", 2);
  fields.NeedFinite(corners);
  if (!corners)
  {
    return;
  }
  std::vector<PlanePosition> polygon;
  for (vtkIdType n = 0; n < corners->GetNumberOfTuples(); ++n)
  {
    polygon.push_back({ corners->GetComponent(n, 0), corners->GetComponent(n, 1) });
  }
  window = ObservationWindow::Polygon(polygon);
  Require(window.WhyInvalid());
}

/// The trend of a row: its degree in the column, its coefficients in the field data.
void ReadTrend(vtkTable* table, vtkIdType row, const ObservationWindow& window, IntensityRaster& raster)
{
  vtkDataArray* degrees = ArrayReader::OfRows(table, "the table of fits").Find("TrendDegree", 1);
  IntensityTrend trend;
  if (degrees)
  {
    ReadWhole("TrendDegree", degrees->GetComponent(row, 0), 0, MaximumTrendDegree, trend.Degree);
  }
  if (trend.Degree == 0)
  {
    return;
  }
  const ArrayReader fields = ArrayReader::OfFields(table, "the table of fits");
  vtkDataArray* coefficients = fields.Need("Trend", 1);
  fields.NeedFinite(coefficients);
  if (coefficients->GetNumberOfTuples() != TermsOfTrend(trend.Degree))
  {
    Refuse("the array Trend of the table of fits has ", coefficients->GetNumberOfTuples(),
      " numbers; a trend of the degree ", trend.Degree, " has ", TermsOfTrend(trend.Degree), ".");
  }
  for (vtkIdType n = 0; n < coefficients->GetNumberOfTuples(); ++n)
  {
    trend.Coefficients.push_back(coefficients->GetComponent(n, 0));
  }
  raster = RasterOf(trend, window);
  Require(WhyInvalid(raster));
}

}

bool FirstRowIsProcess(vtkTable* table)
{
  vtkDataArray* ids = ArrayReader::OfRows(table, "the table of fits").Seek("ProcessId", 1);
  return ids && table->GetNumberOfRows() > 0 && FirstProcess(ids) == 0;
}

void ReadProcessFit(vtkTable* table, PointProcessParameters& process, ObservationWindow& window, IntensityRaster& trend)
{
  const ArrayReader rows = ArrayReader::OfRows(table, "the table of fits");
  if (table->GetNumberOfRows() == 0 || !rows.Has("ProcessId"))
  {
    Refuse("the table of fits has no row with a ProcessId; connect the first output of a pattern verdict.");
  }
  vtkDataArray* ids = rows.Need("ProcessId", 1);
  const vtkIdType row = FirstProcess(ids);
  Require(row < 0 ? "no row of the table of fits is a process; all are laws of quadrats." : "");
  ReadWhole("ProcessId", ids->GetComponent(row, 0), 0, NumberOfPointProcesses - 1, process.Process);
  ParameterCheck check;
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
  Require(check.Reason());
  ReadCorners(table, window);
  ReadTrend(table, row, window, trend);
}

void ReadIntensity(vtkImageData* image, vtkDataArray* values, IntensityRaster& raster)
{
  InContext("the intensity: ", [image] { RequireRaster(image, 1); });
  RequireUpright(image, "the intensity image");
  Require(values ? "" : "the intensity image has no point array of one component to take the intensity from.");
  int extent[6];
  image->GetExtent(extent);
  for (int axis = 0; axis < 2; ++axis)
  {
    raster.Spacing[axis] = image->GetSpacing()[axis];
    raster.Center[axis] = image->GetOrigin()[axis] + extent[2 * axis] * raster.Spacing[axis];
    raster.Count[axis] = extent[2 * axis + 1] - extent[2 * axis] + 1;
  }
  SetSize(raster.Values, values->GetNumberOfTuples());
  for (std::size_t n = 0; n < raster.Values.size(); ++n)
  {
    raster.Values[n] = values->GetComponent(static_cast<vtkIdType>(n), 0);
  }
  Require(WhyInvalid(raster));
}

}
