// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkParticleRepresentation.h"

#include "vtkCellArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPVView.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <functional>

vtkStandardNewMacro(vtkParticleRepresentation);

namespace
{

constexpr const char* OpacityName = "Opacity";

/// Whether each point is a vertex of its own, and there is nothing else to draw. Nothing may come without points.
bool AreVertices(vtkDataObject* leaf)
{
  auto* points = vtkPolyData::SafeDownCast(leaf);
  return points &&
    (points->GetNumberOfPoints() == 0 ||
      (points->GetNumberOfVerts() == points->GetNumberOfPoints() &&
        points->GetNumberOfCells() == points->GetNumberOfVerts() && points->GetVerts()->IsHomogeneous() == 1));
}

/// Calls a function with each leaf of a tree, or with data that are no tree; whether all calls return true.
bool ForLeaves(vtkDataObject* data, const std::function<bool(vtkDataObject*)>& function)
{
  auto* tree = vtkDataObjectTree::SafeDownCast(data);
  if (!tree)
  {
    return function(data);
  }
  const auto leaf = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
  bool isGood = true;
  for (leaf->InitTraversal(); isGood && !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    isGood = function(leaf->GetCurrentDataObject());
  }
  return isGood;
}

/// The same data in a tree of their own, to which arrays can be added.
vtkSmartPointer<vtkDataObject> SharedCopy(vtkDataObject* data)
{
  if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
  {
    const auto copy = vtkSmartPointer<vtkDataObjectTree>::Take(tree->NewInstance());
    copy->CopyStructure(tree);
    const auto leaf = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      copy->SetDataSet(leaf, SharedCopy(leaf->GetCurrentDataObject()));
    }
    return copy;
  }
  auto copy = vtkSmartPointer<vtkDataObject>::Take(data->NewInstance());
  copy->ShallowCopy(data);
  return copy;
}

/// Adds the opacities of points.
void AddOpacity(vtkPolyData* points, double strength, double extinction, const double eye[3])
{
  const vtkIdType count = points->GetNumberOfPoints();
  vtkDataArray* places = count > 0 ? points->GetPoints()->GetData() : nullptr;
  vtkDataArray* alphas = points->GetPointData()->GetArray("Alpha");
  auto* single = vtkFloatArray::SafeDownCast(places);
  auto* weights = vtkFloatArray::SafeDownCast(alphas);
  vtkNew<vtkDoubleArray> opacity;
  opacity->SetName(OpacityName);
  opacity->SetNumberOfTuples(count);
  vtkSMPTools::For(0, count, 4096, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType n = begin; n < end; ++n)
    {
      double place[3];
      single ? static_cast<void>(std::copy_n(single->GetPointer(3 * n), 3, place)) : places->GetTuple(n, place);
      const double alpha = weights ? weights->GetValue(n) : alphas ? alphas->GetComponent(n, 0) : 1.0;
      const double x = place[0] - eye[0];
      const double y = place[1] - eye[1];
      const double z = place[2] - eye[2];
      opacity->SetValue(n, strength * alpha * std::exp(-extinction * std::sqrt(x * x + y * y + z * z)));
    }
  });
  points->GetPointData()->AddArray(opacity);
}

}

//----------------------------------------------------------------------------
vtkParticleRepresentation::vtkParticleRepresentation() = default;

//----------------------------------------------------------------------------
vtkParticleRepresentation::~vtkParticleRepresentation() = default;

//----------------------------------------------------------------------------
void vtkParticleRepresentation::SetExtinction(double extinction)
{
  extinction = std::clamp(extinction, 0.0, 1000.0);
  if (this->Extinction != extinction)
  {
    this->Extinction = extinction;
    this->MarkModified();
  }
}

//----------------------------------------------------------------------------
void vtkParticleRepresentation::SetStrength(double strength)
{
  strength = std::clamp(strength, 0.0, 1.0);
  if (this->Strength != strength)
  {
    this->Strength = strength;
    this->MarkModified();
  }
}

//----------------------------------------------------------------------------
void vtkParticleRepresentation::SetEye(double x, double y, double z)
{
  if (this->Eye[0] != x || this->Eye[1] != y || this->Eye[2] != z)
  {
    this->Eye[0] = x;
    this->Eye[1] = y;
    this->Eye[2] = z;
    this->MarkModified();
  }
}

//----------------------------------------------------------------------------
int vtkParticleRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0], 0);
  if (!input || !ForLeaves(input, AreVertices))
  {
    this->Superclass::RequestData(request, inputVector, outputVector);
  }
  else
  {
    this->ProcessedData = SharedCopy(input);
    if (!vtkCompositeDataSet::SafeDownCast(this->ProcessedData))
    {
      vtkNew<vtkMultiBlockDataSet> blocks;
      blocks->SetBlock(0, this->ProcessedData);
      this->ProcessedData = blocks;
    }
    this->vtkPVDataRepresentation::RequestData(request, inputVector, outputVector);
  }
  if (this->Fades())
  {
    ForLeaves(this->ProcessedData, [this](vtkDataObject* leaf) {
      if (auto* points = vtkPolyData::SafeDownCast(leaf))
      {
        AddOpacity(points, this->Strength, this->Extinction, this->Eye);
      }
      return true;
    });
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkParticleRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  const int isVisible = this->Superclass::ProcessViewRequest(request, inInfo, outInfo);
  if (isVisible && request == vtkPVView::REQUEST_RENDER())
  {
    const char* chosen = this->OpacityByArray ? this->LastOpacityArray : nullptr;
    this->Mapper->SetOpacityArray(this->Fades() ? OpacityName : chosen);
    this->Mapper->SetOpacityArrayComponent(!this->Fades() && chosen ? this->LastOpacityArrayComponent : 0);
  }
  return isVisible;
}

//----------------------------------------------------------------------------
void vtkParticleRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Extinction: " << this->Extinction << "\n";
  os << indent << "Strength: " << this->Strength << "\n";
  os << indent << "Eye: " << this->Eye[0] << " " << this->Eye[1] << " " << this->Eye[2] << "\n";
}
