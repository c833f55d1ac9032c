// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Inputs.h"

#include "Numerics/ParameterCheck.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"

#include <sstream>

namespace littoral
{

namespace
{

/// Why arrays have not a tuple for each of some elements.
std::string WhyUnfit(vtkFieldData* arrays, vtkIdType tuples, const char* elements, const std::string& owner)
{
  for (int index = 0; index < arrays->GetNumberOfArrays(); ++index)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(index);
    if (array->GetNumberOfTuples() != tuples)
    {
      return owner + " has an array " + (array->GetName() ? array->GetName() : "without a name") + " of " +
        std::to_string(array->GetNumberOfTuples()) + " values for " + std::to_string(tuples) + " " + elements + ".";
    }
  }
  return {};
}

/// Why an image is nowhere: a number of its frame that is not sensible.
std::string WhyUnfitFrame(vtkImageData* image, const std::string& owner)
{
  ParameterCheck check;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::string part = "[" + std::to_string(axis) + "] of " + owner;
    check.Finite("Origin" + part, image->GetOrigin()[axis]);
    check.Finite("Spacing" + part, image->GetSpacing()[axis]);
  }
  return check.Reason();
}

/// Why the points of a grid are not as many as its dimensions tell.
std::string WhyUnfitGrid(vtkDataSet* data, const std::string& owner)
{
  int dimensions[3] = { 0, 0, 0 };
  bool fits = true;
  if (auto* grid = vtkStructuredGrid::SafeDownCast(data))
  {
    grid->GetDimensions(dimensions);
    fits = vtkIdType(dimensions[0]) * dimensions[1] * dimensions[2] == data->GetNumberOfPoints() || !grid->GetPoints();
  }
  else if (auto* lines = vtkRectilinearGrid::SafeDownCast(data))
  {
    lines->GetDimensions(dimensions);
    vtkDataArray* const axes[3] = { lines->GetXCoordinates(), lines->GetYCoordinates(), lines->GetZCoordinates() };
    for (int axis = 0; axis < 3 && data->GetNumberOfPoints() > 0; ++axis)
    {
      fits = fits && axes[axis] && axes[axis]->GetNumberOfComponents() == 1 &&
        axes[axis]->GetNumberOfTuples() == dimensions[axis];
    }
  }
  return fits ? "" : owner + " has not as many coordinates as its dimensions tell.";
}

std::string WhyUnfitLeaf(vtkDataObject* leaf, const std::string& owner)
{
  if (auto* table = vtkTable::SafeDownCast(leaf))
  {
    return WhyUnfit(table->GetRowData(), table->GetNumberOfRows(), "rows", owner);
  }
  auto* data = vtkDataSet::SafeDownCast(leaf);
  if (!data)
  {
    return {};
  }
  auto* image = vtkImageData::SafeDownCast(data);
  std::string reason = image ? WhyUnfitFrame(image, owner) : WhyUnfitGrid(data, owner);
  reason = reason.empty() ? WhyUnfit(data->GetPointData(), data->GetNumberOfPoints(), "points", owner) : reason;
  return reason.empty() ? WhyUnfit(data->GetCellData(), data->GetNumberOfCells(), "cells", owner) : reason;
}

}

std::vector<vtkDataObject*> LeavesOf(vtkDataObject* data)
{
  std::vector<vtkDataObject*> leaves;
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    return { data };
  }
  auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    leaves.push_back(iterator->GetCurrentDataObject());
  }
  return leaves;
}

std::string WhyOtherType(vtkDataObject* data, const char* input, const char* words)
{
  return std::string(input) + " is " + (data ? std::string("a ") + data->GetClassName() : "empty") + "; it must be " +
    words + ".";
}

std::string WhyUnfit(vtkDataObject* data, const char* input)
{
  for (vtkDataObject* leaf : LeavesOf(data))
  {
    std::string reason = WhyUnfitLeaf(leaf, input);
    if (!reason.empty())
    {
      return reason;
    }
  }
  return {};
}

std::vector<vtkPointSet*> PointSetsOf(vtkDataObject* data, const char* input, std::string& reason)
{
  std::vector<vtkPointSet*> sets;
  for (vtkDataObject* leaf : LeavesOf(data))
  {
    auto* points = vtkPointSet::SafeDownCast(leaf);
    const std::string own =
      points ? WhyUnfitLeaf(points, input) : WhyOtherType(leaf, input, WordsForType<vtkPointSet>());
    if (!own.empty())
    {
      reason = reason.empty() ? own : reason;
      return {};
    }
    sets.push_back(points);
  }
  return sets;
}

std::string WhyNoRaster(vtkImageData* image, int least)
{
  int dimensions[3];
  image->GetDimensions(dimensions);
  if (dimensions[2] != 1 || dimensions[0] < least || dimensions[1] < least)
  {
    std::ostringstream text;
    text << "The image has " << dimensions[0] << " x " << dimensions[1] << " x " << dimensions[2]
         << " points; it must be one layer in z of at least " << least << " x " << least << ".";
    return text.str();
  }
  ParameterCheck check;
  check.Positive("Spacing[0] of the image", image->GetSpacing()[0]);
  check.Positive("Spacing[1] of the image", image->GetSpacing()[1]);
  return check.Reason();
}

}
