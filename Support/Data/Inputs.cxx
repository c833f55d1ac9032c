// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Inputs.h"

#include "Numerics/ParameterCheck.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"

#include <set>

namespace littoral
{

namespace
{

/// Arrays must have a tuple for each of some elements.
void RequireTuples(vtkFieldData* arrays, vtkIdType tuples, const char* elements, const std::string& owner)
{
  for (int index = 0; index < arrays->GetNumberOfArrays(); ++index)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(index);
    if (array->GetNumberOfTuples() != tuples)
    {
      Refuse(owner, " has an array ", array->GetName() ? array->GetName() : "without a name", " of ",
        array->GetNumberOfTuples(), " values for ", tuples, " ", elements, ".");
    }
  }
}

/// No two arrays may have one name: VTK's copies keep one of them, and which is meant cannot be known.
void RequireNames(vtkFieldData* arrays, const std::string& owner)
{
  std::set<std::string> names;
  for (int index = 0; index < arrays->GetNumberOfArrays(); ++index)
  {
    const char* name = arrays->GetAbstractArray(index)->GetName();
    if (name && !names.insert(name).second)
    {
      Refuse("Rename an array of ", owner, ": two are named ", name, ".");
    }
  }
}

/// Arrays of points, cells or rows.
void RequireArrays(vtkFieldData* arrays, vtkIdType tuples, const char* elements, const std::string& owner)
{
  RequireTuples(arrays, tuples, elements, owner);
  RequireNames(arrays, owner);
}

/// The numbers of an image's frame must be sensible.
void RequireFrame(vtkImageData* image, const std::string& owner)
{
  ParameterCheck check;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::string part = "[" + std::to_string(axis) + "] of " + owner;
    check.Finite("Origin" + part, image->GetOrigin()[axis]);
    check.Finite("Spacing" + part, image->GetSpacing()[axis]);
  }
  Require(check.Reason());
}

/// The points of a grid must be as many as its dimensions tell.
void RequireGrid(vtkDataSet* data, const std::string& owner)
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
  Require(fits ? "" : owner + " has not as many coordinates as its dimensions tell.");
}

void RequireFitLeaf(vtkDataObject* leaf, const std::string& owner)
{
  if (auto* table = vtkTable::SafeDownCast(leaf))
  {
    RequireArrays(table->GetRowData(), table->GetNumberOfRows(), "rows", owner);
  }
  if (auto* data = vtkDataSet::SafeDownCast(leaf))
  {
    auto* image = vtkImageData::SafeDownCast(data);
    image ? RequireFrame(image, owner) : RequireGrid(data, owner);
    RequireArrays(data->GetPointData(), data->GetNumberOfPoints(), "points", owner);
    RequireArrays(data->GetCellData(), data->GetNumberOfCells(), "cells", owner);
  }
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

void RequireFit(vtkDataObject* data, const char* input)
{
  for (vtkDataObject* leaf : LeavesOf(data))
  {
    RequireFitLeaf(leaf, input);
  }
}

std::vector<vtkPointSet*> PointSetsOf(vtkDataObject* data, const char* input)
{
  std::vector<vtkPointSet*> sets;
  for (vtkDataObject* leaf : LeavesOf(data))
  {
    auto* points = vtkPointSet::SafeDownCast(leaf);
    Require(points ? "" : WhyOtherType(leaf, input, WordsForType<vtkPointSet>()));
    RequireFitLeaf(points, input);
    sets.push_back(points);
  }
  return sets;
}

void RequireUpright(vtkImageData* image, const char* input)
{
  Require(image->GetDirectionMatrix()->IsIdentity() ? ""
                                                    : std::string(input) +
        " is turned by its direction matrix; resample it on a grid along x and y, by Resample To Image.");
}

void RequireRaster(vtkImageData* image, int least)
{
  int dimensions[3];
  image->GetDimensions(dimensions);
  if (dimensions[2] != 1 || dimensions[0] < least || dimensions[1] < least)
  {
    Refuse("The image has ", dimensions[0], " x ", dimensions[1], " x ", dimensions[2],
      " points; it must be one layer in z of at least ", least, " x ", least, ".");
  }
  ParameterCheck check;
  check.Positive("Spacing[0] of the image", image->GetSpacing()[0]);
  check.Positive("Spacing[1] of the image", image->GetSpacing()[1]);
  Require(check.Reason());
}

}
