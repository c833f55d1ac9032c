// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/RiverLines.h"

#include "Data/Arrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// sRGB of brooks and of the largest rivers.
constexpr double Brook[3] = { 96.0, 168.0, 216.0 };
constexpr double Stream[3] = { 10.0, 56.0, 128.0 };

void AddColor(vtkUnsignedCharArray* colors, int order, int highest)
{
  const double share = highest > 1 ? (order - 1.0) / (highest - 1.0) : 1.0;
  for (int k = 0; k < 3; ++k)
  {
    colors->InsertNextValue(static_cast<unsigned char>(std::lround(Brook[k] + share * (Stream[k] - Brook[k]))));
  }
}

}

void WriteRivers(vtkImageData* place, const GridSamples& heights, const std::vector<CellIndex>& accumulation,
  const std::vector<River>& rivers, vtkPolyData* output, const Poll& poll)
{
  vtkIdType count = 0;
  int highest = 0;
  std::vector<const River*> ordered;
  for (const River& river : rivers)
  {
    ordered.push_back(&river);
    count += static_cast<vtkIdType>(river.Cells.size());
    highest = std::max(highest, river.Order);
  }
  std::stable_sort(
    ordered.begin(), ordered.end(), [](const River* one, const River* other) { return one->Order < other->Order; });
  const double cellArea = heights.Spacing[0] * heights.Spacing[1];
  const auto rows = static_cast<vtkIdType>(rivers.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  SetTuples(points->GetData(), count);
  const auto areas = NewArray<vtkDoubleArray>("DrainageArea", 1, count);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("RGB");
  colors->SetNumberOfComponents(3);
  const auto orders = NewArray<vtkIntArray>("StreamOrder", 1, rows);
  const auto ends = NewArray<vtkDoubleArray>("DrainageArea", 1, rows);
  const auto lengths = NewArray<vtkDoubleArray>("Length", 1, rows);
  const auto slopes = NewArray<vtkDoubleArray>("Slope", 1, rows);
  vtkNew<vtkCellArray> lines;
  vtkIdType next = 0;
  for (vtkIdType row = 0; row < rows; ++row)
  {
    poll();
    const River& river = *ordered[row];
    orders->SetValue(row, river.Order);
    ends->SetValue(row, river.Area);
    lengths->SetValue(row, river.Length);
    slopes->SetValue(row, river.Slope);
    lines->InsertNextCell(static_cast<int>(river.Cells.size()));
    for (const CellIndex cell : river.Cells)
    {
      double at[3];
      place->GetPoint(cell, at);
      points->SetPoint(next, at[0], at[1], heights.Values[cell]);
      areas->SetValue(next, accumulation[cell] * cellArea);
      AddColor(colors, river.Order, highest);
      lines->InsertCellPoint(next++);
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetPointData()->AddArray(areas);
  output->GetPointData()->AddArray(colors);
  output->GetCellData()->AddArray(orders);
  output->GetCellData()->AddArray(ends);
  output->GetCellData()->AddArray(lengths);
  output->GetCellData()->AddArray(slopes);
}

}
