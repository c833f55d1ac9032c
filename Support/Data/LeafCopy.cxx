// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/LeafCopy.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkInformationIntegerKey.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace littoral
{

namespace
{

bool AreTheSame(vtkFieldData* some, vtkFieldData* others)
{
  bool areSame = some->GetNumberOfArrays() == others->GetNumberOfArrays();
  for (int index = 0; areSame && index < some->GetNumberOfArrays(); ++index)
  {
    areSame = some->GetAbstractArray(index) == others->GetAbstractArray(index);
  }
  return areSame;
}

template <typename Key>
bool HaveTheSame(Key* key, vtkInformation* some, vtkInformation* other)
{
  return some->Has(key) == other->Has(key) && (!some->Has(key) || some->Get(key) == other->Get(key));
}

/// Whether they are the same piece at the same time.
bool AreOfOnePiece(vtkInformation* some, vtkInformation* other)
{
  return HaveTheSame(vtkDataObject::DATA_PIECE_NUMBER(), some, other) &&
    HaveTheSame(vtkDataObject::DATA_NUMBER_OF_PIECES(), some, other) &&
    HaveTheSame(vtkDataObject::DATA_NUMBER_OF_GHOST_LEVELS(), some, other) &&
    HaveTheSame(vtkDataObject::DATA_TIME_STEP(), some, other);
}

bool HaveOneName(vtkAbstractArray* some, vtkAbstractArray* other)
{
  return some->GetName() && other->GetName() && std::strcmp(some->GetName(), other->GetName()) == 0;
}

/// Gives attributes the arrays of other ones, where they have the same names, and no more.
bool TakeArrays(vtkDataSetAttributes* from, vtkDataSetAttributes* to)
{
  for (int index = to->GetNumberOfArrays() - 1; index >= from->GetNumberOfArrays(); --index)
  {
    to->RemoveArray(index);
  }
  bool areTaken = to->GetNumberOfArrays() == from->GetNumberOfArrays();
  for (int index = 0; areTaken && index < from->GetNumberOfArrays(); ++index)
  {
    vtkAbstractArray* array = from->GetAbstractArray(index);
    if (array != to->GetAbstractArray(index) && HaveOneName(array, to->GetAbstractArray(index)))
    {
      to->AddArray(array); // in place of the one of its name
    }
    areTaken = array == to->GetAbstractArray(index);
  }
  int attributes[2][vtkDataSetAttributes::NUM_ATTRIBUTES];
  from->GetAttributeIndices(attributes[0]);
  to->GetAttributeIndices(attributes[1]);
  return areTaken && std::equal(std::begin(attributes[0]), std::end(attributes[0]), std::begin(attributes[1]));
}

}

vtkDataObject* LeafCopy::Of(vtkDataObject* leaf)
{
  const bool isPlain = leaf->GetDataObjectType() == VTK_POLY_DATA;
  if (!isPlain || !this->Follows(vtkPolyData::SafeDownCast(leaf)))
  {
    this->Copy = vtkSmartPointer<vtkDataObject>::Take(leaf->NewInstance());
    this->Copy->ShallowCopy(leaf);
    this->Cells = isPlain ? CellsOf(vtkPolyData::SafeDownCast(leaf)) : Stamps{};
  }
  return this->Copy;
}

bool LeafCopy::Follows(vtkPolyData* leaf)
{
  const bool isFree = this->Copy && this->Copy->GetReferenceCount() == 1;
  auto* copy = isFree ? vtkPolyData::SafeDownCast(this->Copy) : nullptr;
  if (!copy || copy->GetClassName() != leaf->GetClassName() || this->Cells != CellsOf(leaf) ||
    !AreTheSame(copy->GetFieldData(), leaf->GetFieldData()) || !AreTheSame(copy->GetCellData(), leaf->GetCellData()) ||
    !AreOfOnePiece(copy->GetInformation(), leaf->GetInformation()) ||
    !TakeArrays(leaf->GetPointData(), copy->GetPointData()))
  {
    return false;
  }
  copy->SetPoints(leaf->GetPoints());
  return true;
}

LeafCopy::Stamps LeafCopy::CellsOf(vtkPolyData* leaf)
{
  const auto stamp = [](vtkCellArray* cells) {
    return std::pair<const void*, vtkMTimeType>(cells, cells ? cells->GetMTime() : 0);
  };
  return { stamp(leaf->GetVerts()), stamp(leaf->GetLines()), stamp(leaf->GetPolys()), stamp(leaf->GetStrips()) };
}

}
