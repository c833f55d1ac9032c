// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeInput.h"

#include "Data/Arrays.h"
#include "Numerics/InvalidInput.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArraySelection.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace littoral
{

namespace
{

struct Choice
{
  vtkDataArraySelection* Points;
  vtkDataArraySelection* Cells;
};

bool IsChosen(vtkDataArraySelection* selection, const std::string& name)
{
  return !selection->ArrayExists(name.c_str()) || selection->ArrayIsEnabled(name.c_str());
}

std::string NameOf(vtkAbstractArray* array)
{
  return array->GetName() && *array->GetName() ? array->GetName() : "unnamed";
}

// --- Remarks --------------------------------------------------------------------------------------------------------

/// Text, single numbers and triples of the field data, and the time.
VolumeRemarks RemarksOf(vtkDataObject* data)
{
  VolumeRemarks remarks;
  vtkFieldData* fields = data->GetFieldData();
  for (int index = 0; fields && index < fields->GetNumberOfArrays(); ++index)
  {
    vtkAbstractArray* field = fields->GetAbstractArray(index);
    if (auto* text = vtkStringArray::SafeDownCast(field))
    {
      if (text->GetNumberOfValues() == 1)
      {
        remarks[NameOf(field)] = std::string(text->GetValue(0));
      }
    }
    else if (auto* numbers = vtkDataArray::SafeDownCast(field))
    {
      if (numbers->GetNumberOfValues() == 1)
      {
        remarks[NameOf(field)] = numbers->GetComponent(0, 0);
      }
      else if (numbers->GetNumberOfTuples() == 1 && numbers->GetNumberOfComponents() == 3)
      {
        remarks[NameOf(field)] = std::array<double, 3>{ { numbers->GetComponent(0, 0), numbers->GetComponent(0, 1),
          numbers->GetComponent(0, 2) } };
      }
    }
  }
  if (data->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()))
  {
    remarks["time"] = data->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP());
  }
  return remarks;
}

/// The unit that an array names itself, or that the field data names for it.
std::string UnitOf(vtkDataArray* array, const VolumeRemarks& remarks)
{
  if (array->HasInformation() && array->GetInformation()->Has(vtkDataArray::UNITS_LABEL()))
  {
    return array->GetInformation()->Get(vtkDataArray::UNITS_LABEL());
  }
  const auto found = remarks.find(NameOf(array) + "Unit");
  const std::string* text = found == remarks.end() ? nullptr : std::get_if<std::string>(&found->second);
  return text ? *text : std::string();
}

// --- Images ---------------------------------------------------------------------------------------------------------

VolumeLattice LatticeOf(vtkImageData* image)
{
  VolumeLattice lattice;
  for (int row = 0; row < 3; ++row)
  {
    lattice.Origin[row] = image->GetOrigin()[row];
    for (int axis = 0; axis < 3; ++axis)
    {
      lattice.Step[axis][row] = image->GetDirectionMatrix()->GetElement(row, axis) * image->GetSpacing()[axis];
    }
  }
  return lattice;
}

bool IsProper(const VolumeLattice& lattice)
{
  bool proper = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto& step = lattice.Step[axis];
    const double square = step[0] * step[0] + step[1] * step[1] + step[2] * step[2];
    proper = proper && std::isfinite(square) && square > 0.0 && std::isfinite(lattice.Origin[axis]);
  }
  return proper;
}

VolumeVectors VectorsOf(vtkDataSetAttributes* arrays, int index)
{
  switch (arrays->IsArrayAnAttribute(index))
  {
    case vtkDataSetAttributes::NORMALS:
      return VolumeVectors::Normal;
    case vtkDataSetAttributes::TCOORDS:
      return VolumeVectors::Invariant;
    default:
      return arrays->GetArray(index)->GetDataType() == VTK_UNSIGNED_CHAR ? VolumeVectors::Invariant
                                                                         : VolumeVectors::Relative;
  }
}

/// Samples of one association of an image, without their values.
struct SampleSet
{
  VolumeLattice Lattice;
  VolumeBlock Box;
  vtkDataSetAttributes* Arrays;
  vtkDataArraySelection* Selection;
};

void TakeGhosts(vtkUnsignedCharArray* ghosts, unsigned char hidden, VolumeBlock& box)
{
  if (ghosts && ghosts->GetNumberOfTuples() == static_cast<vtkIdType>(box.Count()))
  {
    box.Ghosts = ghosts->GetPointer(0);
    box.Hidden = hidden;
    box.Own.push_back(std::make_shared<vtkSmartPointer<vtkUnsignedCharArray>>(ghosts));
  }
}

SampleSet PointsOf(vtkImageData* image, const Choice& choice)
{
  SampleSet set{ LatticeOf(image), {}, image->GetPointData(), choice.Points };
  std::copy_n(image->GetExtent(), 6, set.Box.Extent.begin());
  TakeGhosts(image->GetPointGhostArray(), vtkDataSetAttributes::HIDDENPOINT, set.Box);
  return set;
}

/// Cells are sampled at their centers, which lie half a step further where the image has cells along the axis.
SampleSet CellsOf(vtkImageData* image, const Choice& choice)
{
  SampleSet set{ LatticeOf(image), {}, image->GetCellData(), choice.Cells };
  std::copy_n(image->GetExtent(), 6, set.Box.Extent.begin());
  for (int axis = 0; axis < 3; ++axis)
  {
    int& last = set.Box.Extent[2 * axis + 1];
    if (last > set.Box.Extent[2 * axis])
    {
      --last;
      for (int row = 0; row < 3; ++row)
      {
        set.Lattice.Origin[row] += 0.5 * set.Lattice.Step[axis][row];
      }
    }
  }
  TakeGhosts(image->GetCellGhostArray(), vtkDataSetAttributes::HIDDENCELL, set.Box);
  return set;
}

/// Adds an array: whole if it has 1 or 3 components, else each component by itself.
void AddArray(
  const SampleSet& set, int index, const std::string& place, const VolumeRemarks& remarks, std::vector<Volume>& volumes)
{
  vtkDataArray* array = set.Arrays->GetArray(index);
  const auto numbers = WithType<vtkFloatArray>(array);
  const int components = numbers->GetNumberOfComponents();
  const bool whole = components == 1 || components == 3;
  Volume volume;
  volume.Place = place;
  volume.Lattice = set.Lattice;
  volume.Components = whole ? components : 1;
  volume.Vectors = VectorsOf(set.Arrays, index);
  volume.Remarks = remarks;
  const std::string unit = UnitOf(array, remarks);
  if (!unit.empty())
  {
    volume.Remarks["unit"] = unit;
  }
  for (int component = 0; component < (whole ? 1 : components); ++component)
  {
    const char* own = array->GetComponentName(component);
    volume.Array = NameOf(array) + (whole ? "" : "_" + (own ? std::string(own) : std::to_string(component)));
    VolumeBlock block = set.Box;
    block.Values = numbers->GetPointer(component);
    block.Stride = components;
    block.Own.push_back(std::make_shared<vtkSmartPointer<vtkFloatArray>>(numbers));
    volume.Blocks.assign(1, block);
    volumes.push_back(volume);
  }
}

/// Why an array cannot be written; empty if it can.
std::string WhyUnfit(const SampleSet& set, vtkAbstractArray* array)
{
  if (!vtkDataArray::SafeDownCast(array))
  {
    return "the array '" + NameOf(array) + "' holds no numbers; leave it out of the choice of arrays.";
  }
  if (array->GetNumberOfTuples() != static_cast<vtkIdType>(set.Box.Count()))
  {
    return "the array '" + NameOf(array) + "' has " + std::to_string(array->GetNumberOfTuples()) + " values for " +
      std::to_string(set.Box.Count()) + " places.";
  }
  return {};
}

void ReadSamples(const SampleSet& set, const std::string& place, const VolumeRemarks& remarks, VolumeInput& result)
{
  for (int index = 0; index < set.Arrays->GetNumberOfArrays() && result.Reason.empty(); ++index)
  {
    vtkAbstractArray* array = set.Arrays->GetAbstractArray(index);
    const std::string name = NameOf(array);
    if (name == vtkDataSetAttributes::GhostArrayName() || !IsChosen(set.Selection, name))
    {
      continue;
    }
    result.Reason = WhyUnfit(set, array);
    if (result.Reason.empty())
    {
      result.Reason = WhyRefused([&] { AddArray(set, index, place, remarks, result.Volumes); });
    }
  }
}

void ReadImage(vtkImageData* image, const std::string& place, const VolumeRemarks& remarks, const Choice& choice,
  VolumeInput& result)
{
  if (image->GetNumberOfPoints() == 0)
  {
    return;
  }
  if (!IsProper(LatticeOf(image)))
  {
    result.Reason = "spacing, origin and direction of the image" + (place.empty() ? "" : " '" + place + "'") +
      " must be finite, and the spacing not 0.";
    return;
  }
  result.Samples += static_cast<std::size_t>(image->GetNumberOfPoints());
  ReadSamples(PointsOf(image, choice), place, remarks, result);
  ReadSamples(CellsOf(image, choice), place, remarks, result);
}

// --- Composites -----------------------------------------------------------------------------------------------------

std::string BlockName(const std::string& parent, vtkInformation* metaData, unsigned int index)
{
  const bool named = metaData && metaData->Has(vtkCompositeDataSet::NAME());
  const std::string own = named ? metaData->Get(vtkCompositeDataSet::NAME()) : "Block" + std::to_string(index);
  return parent.empty() ? own : parent + "_" + own;
}

void Read(
  vtkDataObject* data, const std::string& place, VolumeRemarks remarks, const Choice& choice, VolumeInput& result);

/// Partitions are pieces of one block.
void ReadPartitions(vtkPartitionedDataSet* parts, const std::string& place, const VolumeRemarks& remarks,
  const Choice& choice, VolumeInput& result)
{
  for (unsigned int index = 0; index < parts->GetNumberOfPartitions(); ++index)
  {
    Read(parts->GetPartitionAsDataObject(index), place, remarks, choice, result);
  }
}

void ReadOther(vtkCompositeDataSet* blocks, const std::string& place, const VolumeRemarks& remarks,
  const Choice& choice, VolumeInput& result)
{
  vtkSmartPointer<vtkCompositeDataIterator> iterator;
  iterator.TakeReference(blocks->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    Read(iterator->GetCurrentDataObject(), BlockName(place, nullptr, iterator->GetCurrentFlatIndex()), remarks, choice,
      result);
  }
}

void Read(
  vtkDataObject* data, const std::string& place, VolumeRemarks remarks, const Choice& choice, VolumeInput& result)
{
  if (!data || !result.Reason.empty())
  {
    return;
  }
  for (const auto& [name, remark] : RemarksOf(data))
  {
    remarks[name] = remark;
  }
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    ReadImage(image, place, remarks, choice, result);
  }
  else if (auto* parts = vtkPartitionedDataSet::SafeDownCast(data))
  {
    ReadPartitions(parts, place, remarks, choice, result);
  }
  else if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    for (unsigned int index = 0; index < blocks->GetNumberOfBlocks(); ++index)
    {
      vtkInformation* metaData = blocks->HasMetaData(index) ? blocks->GetMetaData(index) : nullptr;
      Read(blocks->GetBlock(index), BlockName(place, metaData, index), remarks, choice, result);
    }
  }
  else if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
  {
    for (unsigned int index = 0; index < collection->GetNumberOfPartitionedDataSets(); ++index)
    {
      vtkInformation* metaData = collection->HasMetaData(index) ? collection->GetMetaData(index) : nullptr;
      Read(collection->GetPartitionedDataSet(index), BlockName(place, metaData, index), remarks, choice, result);
    }
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    ReadOther(composite, place, remarks, choice, result);
  }
  else
  {
    result.Reason = (place.empty() ? "the input" : "the block '" + place + "'") + " is a " + data->GetClassName() +
      "; volumes are written of images alone.";
  }
}

bool AreOne(const Volume& one, const Volume& other)
{
  return one.Place == other.Place && one.Array == other.Array && one.Components == other.Components &&
    one.Lattice == other.Lattice;
}

}

VolumeInput ReadVolumes(vtkDataObject* input, vtkDataArraySelection* points, vtkDataArraySelection* cells)
{
  VolumeInput result;
  result.Remarks = RemarksOf(input);
  if (auto* image = vtkImageData::SafeDownCast(input))
  {
    image->GetExtent(result.Extent.data());
  }
  Read(input, {}, {}, { points, cells }, result);
  return result;
}

void JoinVolumes(std::vector<Volume>& volumes)
{
  std::vector<Volume> joined;
  for (Volume& volume : volumes)
  {
    const auto found =
      std::find_if(joined.begin(), joined.end(), [&](const Volume& other) { return AreOne(volume, other); });
    if (found == joined.end())
    {
      joined.push_back(std::move(volume));
    }
    else
    {
      found->Blocks.insert(found->Blocks.end(), volume.Blocks.begin(), volume.Blocks.end());
    }
  }
  std::map<std::string, int> uses;
  for (const Volume& volume : joined)
  {
    ++uses[volume.Array];
  }
  std::set<std::string> names;
  for (Volume& volume : joined)
  {
    const bool alone = uses[volume.Array] == 1 || volume.Place.empty();
    const std::string name = alone ? volume.Array : volume.Place + "_" + volume.Array;
    volume.Name = name;
    for (int number = 2; !names.insert(volume.Name).second; ++number)
    {
      volume.Name = name + "_" + std::to_string(number);
    }
  }
  volumes = std::move(joined);
}

}
