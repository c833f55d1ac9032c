// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GatheredImage.h"

#include "Data/Arrays.h"
#include "Numerics/InvalidInput.h"
#include "Pipeline/Memory.h"
#include "PlainData.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>

namespace littoral
{

namespace
{

using Box = ImageParts::Extent;

constexpr int ShapeTag = 78140;
constexpr int RequestTag = 78141;
constexpr int StateTag = 78142;
constexpr int ValuesTag = 78143;
constexpr int FieldsTag = 78144;

constexpr Box NoBox{ { 0, -1, 0, -1, 0, -1 } };

bool IsEmpty(const Box& box)
{
  return box[1] < box[0] || box[3] < box[2] || box[5] < box[4];
}

vtkIdType Length(const Box& box, int axis)
{
  return static_cast<vtkIdType>(box[2 * axis + 1]) - box[2 * axis] + 1;
}

vtkIdType CountOf(const Box& box)
{
  return IsEmpty(box) ? 0 : Length(box, 0) * Length(box, 1) * Length(box, 2);
}

Box Intersection(const Box& a, const Box& b)
{
  Box common{};
  for (int axis = 0; axis < 3; ++axis)
  {
    common[2 * axis] = std::max(a[2 * axis], b[2 * axis]);
    common[2 * axis + 1] = std::min(a[2 * axis + 1], b[2 * axis + 1]);
  }
  return IsEmpty(common) ? NoBox : common;
}

Box Union(const Box& a, const Box& b)
{
  if (IsEmpty(a) || IsEmpty(b))
  {
    return IsEmpty(a) ? b : a;
  }
  Box both{};
  for (int axis = 0; axis < 3; ++axis)
  {
    both[2 * axis] = std::min(a[2 * axis], b[2 * axis]);
    both[2 * axis + 1] = std::max(a[2 * axis + 1], b[2 * axis + 1]);
  }
  return both;
}

bool Holds(const Box& outer, const Box& inner)
{
  return IsEmpty(inner) || Intersection(outer, inner) == inner;
}

/// The cells between the points of a box: a part of the image that is flat where the image is not has none.
Box CellsOf(Box points, const Box& whole)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    points[2 * axis + 1] -= whole[2 * axis] < whole[2 * axis + 1] ? 1 : 0;
  }
  return IsEmpty(points) ? NoBox : points;
}

/// The tuple of the first sample of a row of a box.
vtkIdType RowOf(const Box& box, int i, int j, int k)
{
  return (i - box[0]) + Length(box, 0) * ((j - box[2]) + Length(box, 1) * (k - box[4]));
}

/// Copies the tuples of a box between the arrays of two boxes around it.
void CopyBox(vtkDataArray* from, const Box& fromBox, vtkDataArray* to, const Box& toBox, const Box& box)
{
  for (int k = box[4]; k <= box[5]; ++k)
  {
    for (int j = box[2]; j <= box[3]; ++j)
    {
      to->InsertTuples(RowOf(toBox, box[0], j, k), Length(box, 0), RowOf(fromBox, box[0], j, k), from);
    }
  }
}

vtkDataSetAttributes* AttributesOf(vtkImageData* image, bool isOfCells)
{
  return isOfCells ? static_cast<vtkDataSetAttributes*>(image->GetCellData()) : image->GetPointData();
}

Box ExtentOf(vtkImageData* image)
{
  Box extent{};
  image->GetExtent(extent.data());
  return extent;
}

/// An array of zeros, as those of ghosts are where a part has no marks.
vtkSmartPointer<vtkDataArray> Zeros(int type, int components, const std::string& name, vtkIdType tuples)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetNumberOfComponents(components);
  array->SetName(name.c_str());
  SetTuples(array, tuples);
  array->Fill(0.0);
  return array;
}

bool IsOfGhosts(const std::string& name)
{
  return name == vtkDataSetAttributes::GhostArrayName();
}

}

//----------------------------------------------------------------------------
GatheredImage::GatheredImage(const WriterRanks& ranks, vtkImageData* own, const Box& announced)
  : Ranks(ranks)
  , Image(own && own->GetNumberOfPoints() > 0 ? own : nullptr)
{
  this->AllParts.push_back(PartOf(this->Image, announced));
  if (ranks.IsFirst())
  {
    this->ReceiveParts();
    this->Join();
  }
  else
  {
    this->SendPart();
  }
  this->ShareColumns();
  this->ShareFields();
}

//----------------------------------------------------------------------------
GatheredImage::~GatheredImage()
{
  for (int rank = 1; this->Ranks.IsFirst() && rank < this->Ranks.GetNumberOfRanks(); ++rank)
  {
    this->Ranks.GetController()->Send(NoBox.data(), 6, rank, RequestTag);
  }
}

//----------------------------------------------------------------------------
GatheredImage::Part GatheredImage::PartOf(vtkImageData* own, const Box& announced)
{
  Part part;
  part.Announced = announced;
  if (!own)
  {
    return part;
  }
  own->GetExtent(part.Extent.data());
  std::copy_n(own->GetOrigin(), 3, part.Grid.data());
  std::copy_n(own->GetSpacing(), 3, part.Grid.data() + 3);
  std::copy_n(own->GetDirectionMatrix()->GetData(), 9, part.Grid.data() + 6);
  for (const bool isOfCells : { false, true })
  {
    vtkDataSetAttributes* attributes = AttributesOf(own, isOfCells);
    for (int index = 0; index < attributes->GetNumberOfArrays(); ++index)
    {
      vtkDataArray* array = attributes->GetArray(index);
      const vtkIdType tuples = isOfCells ? own->GetNumberOfCells() : own->GetNumberOfPoints();
      const bool isActive = array && array == attributes->GetScalars();
      if (array && array->GetNumberOfTuples() == tuples && (array->GetName() || isActive))
      {
        part.Columns.push_back({ isOfCells, isActive, array->GetName() ? array->GetName() : "", array->GetDataType(),
          array->GetNumberOfComponents() });
      }
    }
  }
  return part;
}

//----------------------------------------------------------------------------
void GatheredImage::Put(vtkMultiProcessStream& stream, const std::vector<Column>& columns)
{
  stream << static_cast<int>(columns.size());
  for (const Column& column : columns)
  {
    stream << static_cast<int>(column.IsOfCells) << static_cast<int>(column.IsActive) << column.Name << column.Type
           << column.Components;
  }
}

//----------------------------------------------------------------------------
void GatheredImage::Take(vtkMultiProcessStream& stream, std::vector<Column>& columns)
{
  int count = 0;
  stream >> count;
  columns.clear();
  for (int n = 0; n < count; ++n)
  {
    Column column;
    int isOfCells = 0;
    int isActive = 0;
    stream >> isOfCells >> isActive >> column.Name >> column.Type >> column.Components;
    column.IsOfCells = isOfCells != 0;
    column.IsActive = isActive != 0;
    columns.push_back(column);
  }
}

//----------------------------------------------------------------------------
void GatheredImage::SendPart()
{
  const Part& own = this->AllParts.front();
  vtkMultiProcessStream stream;
  for (const Box* box : { &own.Announced, &own.Extent })
  {
    for (const int bound : *box)
    {
      stream << bound;
    }
  }
  for (const double number : own.Grid)
  {
    stream << number;
  }
  Put(stream, own.Columns);
  this->Ranks.GetController()->Send(stream, 0, ShapeTag);
}

//----------------------------------------------------------------------------
GatheredImage::Part GatheredImage::ReceivedPart(vtkMultiProcessStream& stream)
{
  Part part;
  for (Box* box : { &part.Announced, &part.Extent })
  {
    for (int& bound : *box)
    {
      stream >> bound;
    }
  }
  for (double& number : part.Grid)
  {
    stream >> number;
  }
  Take(stream, part.Columns);
  return part;
}

//----------------------------------------------------------------------------
void GatheredImage::ReceiveParts()
{
  for (int rank = 1; rank < this->Ranks.GetNumberOfRanks(); ++rank)
  {
    vtkMultiProcessStream stream;
    this->Ranks.GetController()->Receive(stream, rank, ShapeTag);
    this->AllParts.push_back(ReceivedPart(stream));
  }
}

//----------------------------------------------------------------------------
GatheredImage::Column* GatheredImage::Find(std::vector<Column>& columns, const Column& like)
{
  const auto found = std::find_if(columns.begin(), columns.end(), [&](const Column& column) {
    return column.IsOfCells == like.IsOfCells && column.Name == like.Name && column.Type == like.Type &&
      column.Components == like.Components;
  });
  return found == columns.end() ? nullptr : &*found;
}

//----------------------------------------------------------------------------
/// The extent of all parts, and the columns that each has.
void GatheredImage::Join()
{
  std::vector<Column> ghosts;
  for (std::size_t rank = 0; rank < this->AllParts.size(); ++rank)
  {
    Part& part = this->AllParts[rank];
    if (IsEmpty(part.Extent))
    {
      continue;
    }
    if (this->FirstFilled < 0)
    {
      this->FirstFilled = static_cast<int>(rank);
      this->Columns = part.Columns;
    }
    this->Whole = Union(this->Whole, part.Extent);
    for (const Column& column : part.Columns)
    {
      if (IsOfGhosts(column.Name) && !Find(ghosts, column))
      {
        ghosts.push_back(column);
      }
    }
    const auto isMissing = [&](const Column& column) { return !Find(part.Columns, column); };
    this->Columns.erase(std::remove_if(this->Columns.begin(), this->Columns.end(), isMissing), this->Columns.end());
  }
  for (const Column& column : ghosts)
  {
    if (!Find(this->Columns, column))
    {
      this->Columns.push_back(column);
    }
  }
}

//----------------------------------------------------------------------------
void GatheredImage::ShareColumns()
{
  vtkMultiProcessStream stream;
  if (this->Ranks.IsFirst())
  {
    stream << this->FirstFilled;
    for (const int bound : this->Whole)
    {
      stream << bound;
    }
    Put(stream, this->Columns);
  }
  this->Ranks.GetController()->Broadcast(stream, 0);
  if (!this->Ranks.IsFirst())
  {
    stream >> this->FirstFilled;
    for (int& bound : this->Whole)
    {
      stream >> bound;
    }
    Take(stream, this->Columns);
  }
}

//----------------------------------------------------------------------------
/// Field data are those of the first part that has points.
void GatheredImage::ShareFields()
{
  this->Fields = vtkSmartPointer<vtkImageData>::New();
  if (this->FirstFilled == this->Ranks.GetRank())
  {
    this->Fields->SetFieldData(this->Image->GetFieldData());
  }
  if (this->FirstFilled <= 0)
  {
    return;
  }
  if (this->FirstFilled == this->Ranks.GetRank())
  {
    this->Ranks.GetController()->Send(PlainFields(this->Image->GetFieldData()), 0, FieldsTag);
  }
  else if (this->Ranks.IsFirst())
  {
    vtkNew<vtkPolyData> carrier; // that has nothing else
    this->Ranks.GetController()->Receive(carrier, this->FirstFilled, FieldsTag);
    this->Fields->SetFieldData(carrier->GetFieldData());
  }
}

//----------------------------------------------------------------------------
std::string GatheredImage::WhyNoImage() const
{
  if (this->FirstFilled < 0)
  {
    return "the image has no points";
  }
  for (const Part& part : this->AllParts)
  {
    if (!IsEmpty(part.Extent) && part.Grid != this->AllParts[this->FirstFilled].Grid)
    {
      return "the parts of the ranks are not those of one image: origin, spacing or axes differ";
    }
    if (!Holds(this->Whole, part.Announced))
    {
      return "a rank has not its part of the image";
    }
  }
  return {};
}

//----------------------------------------------------------------------------
ImageParts GatheredImage::Parts()
{
  Require(this->WhyNoImage());
  return { this->Whole, [this](const Box& asked) { return this->Get(asked); } };
}

//----------------------------------------------------------------------------
/// The array of this rank's part; null where it has none.
vtkDataArray* GatheredImage::Own(const Column& column) const
{
  vtkDataSetAttributes* attributes = AttributesOf(this->Image, column.IsOfCells);
  return column.Name.empty() ? attributes->GetScalars() : attributes->GetArray(column.Name.c_str());
}

//----------------------------------------------------------------------------
double GatheredImage::BytesOf(const Box& box) const
{
  double bytes = 2.0; // marks of what is there
  for (const Column& column : this->Columns)
  {
    bytes += static_cast<double>(vtkDataArray::GetDataTypeSize(column.Type)) * column.Components;
  }
  return bytes * static_cast<double>(CountOf(box));
}

//----------------------------------------------------------------------------
void GatheredImage::Serve()
{
  for (;;)
  {
    Box box = NoBox;
    this->Ranks.GetController()->Receive(box.data(), 6, 0, RequestTag);
    if (IsEmpty(box))
    {
      return;
    }
    this->Answer(box);
  }
}

//----------------------------------------------------------------------------
/// Whether there is memory for the answer, and then its columns.
void GatheredImage::Answer(const Box& box)
{
  vtkMultiProcessController* controller = this->Ranks.GetController();
  std::vector<vtkSmartPointer<vtkDataArray>> packed;
  const std::string reason = WhyRefused([&] {
    RequireMemory(this->BytesOf(box), "a part of the image", "");
    for (const Column& column : this->Columns)
    {
      packed.push_back(this->Packed(column, box));
    }
  });
  const int isGood = static_cast<int>(reason.empty());
  controller->Send(&isGood, 1, 0, StateTag);
  for (const vtkSmartPointer<vtkDataArray>& array : packed)
  {
    if (isGood != 0 && array)
    {
      controller->Send(array, 0, ValuesTag);
    }
  }
}

//----------------------------------------------------------------------------
/// The values of this rank in a box; null where there are none, as cells of a single layer of points.
vtkSmartPointer<vtkDataArray> GatheredImage::Packed(const Column& column, const Box& box) const
{
  const auto among = [&](const Box& points) { return column.IsOfCells ? CellsOf(points, this->Whole) : points; };
  const Box values = among(box);
  if (IsEmpty(values))
  {
    return nullptr;
  }
  const vtkSmartPointer<vtkDataArray> packed = Zeros(column.Type, column.Components, column.Name, CountOf(values));
  if (vtkDataArray* own = this->Own(column))
  {
    CopyBox(own, among(ExtentOf(this->Image)), packed, values, values);
  }
  return packed;
}

//----------------------------------------------------------------------------
void GatheredImage::ReceiveBox(int rank, const Box& box, vtkImageData* image)
{
  vtkMultiProcessController* controller = this->Ranks.GetController();
  controller->Send(box.data(), 6, rank, RequestTag);
  int isGood = 0;
  controller->Receive(&isGood, 1, rank, StateTag);
  Require(isGood != 0 ? "" : "rank " + std::to_string(rank) + " has no memory to hand over a part of the image");
  const Box asked = ExtentOf(image);
  for (const Column& column : this->Columns)
  {
    const Box values = column.IsOfCells ? CellsOf(box, this->Whole) : box;
    if (!IsEmpty(values))
    {
      auto received = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(column.Type));
      controller->Receive(received, rank, ValuesTag);
      vtkDataArray* to = AttributesOf(image, column.IsOfCells)->GetArray(column.Name.c_str());
      CopyBox(received, values, to, column.IsOfCells ? CellsOf(asked, this->Whole) : asked, values);
    }
  }
}

//----------------------------------------------------------------------------
void GatheredImage::TakeOwnBox(const Box& box, vtkImageData* image)
{
  const Box extent = ExtentOf(this->Image);
  const Box asked = ExtentOf(image);
  for (const Column& column : this->Columns)
  {
    const auto among = [&](const Box& points) { return column.IsOfCells ? CellsOf(points, this->Whole) : points; };
    vtkDataArray* own = this->Own(column);
    if (own && !IsEmpty(among(box)))
    {
      vtkDataArray* to = AttributesOf(image, column.IsOfCells)->GetArray(column.Name.c_str());
      CopyBox(own, among(extent), to, among(asked), among(box));
    }
  }
}

//----------------------------------------------------------------------------
/// An image of a box whose arrays are to be filled.
vtkSmartPointer<vtkImageData> GatheredImage::Room(const Box& box) const
{
  RequireMemory(2.0 * this->BytesOf(box), "a part of the image", "take fewer points");
  auto image = vtkSmartPointer<vtkImageData>::New();
  const std::array<double, 15>& grid = this->AllParts[this->FirstFilled].Grid;
  image->SetExtent(box[0], box[1], box[2], box[3], box[4], box[5]);
  image->SetOrigin(grid.data());
  image->SetSpacing(grid.data() + 3);
  image->SetDirectionMatrix(grid.data() + 6);
  image->SetFieldData(this->Fields->GetFieldData());
  for (const Column& column : this->Columns)
  {
    const Box values = column.IsOfCells ? CellsOf(box, this->Whole) : box;
    if (!IsEmpty(values))
    {
      vtkDataSetAttributes* attributes = AttributesOf(image, column.IsOfCells);
      const int index = attributes->AddArray(Zeros(column.Type, column.Components, column.Name, CountOf(values)));
      if (column.IsActive)
      {
        attributes->SetActiveAttribute(index, vtkDataSetAttributes::SCALARS);
      }
    }
  }
  return image;
}

//----------------------------------------------------------------------------
/// Throws InvalidInput where points or cells of a box are in none of the others.
void GatheredImage::RequireCovered(const Box& asked, const std::vector<Box>& boxes, bool isOfCells) const
{
  const auto among = [&](const Box& points) { return isOfCells ? CellsOf(points, this->Whole) : points; };
  const Box all = among(asked);
  std::vector<bool> isThere(static_cast<std::size_t>(CountOf(all)), false);
  for (const Box& box : boxes)
  {
    const Box values = among(box);
    for (int k = values[4]; !IsEmpty(values) && k <= values[5]; ++k)
    {
      for (int j = values[2]; j <= values[3]; ++j)
      {
        const auto begin = isThere.begin() + RowOf(all, values[0], j, k);
        std::fill(begin, begin + Length(values, 0), true);
      }
    }
  }
  const bool isCovered = std::find(isThere.begin(), isThere.end(), false) == isThere.end();
  Require(isCovered ? "" : std::string(isOfCells ? "cells" : "points") + " of the image are on no rank");
}

//----------------------------------------------------------------------------
vtkImageData* GatheredImage::Get(const Box& asked)
{
  std::vector<Box> boxes;
  std::vector<int> owners;
  for (std::size_t rank = 0; rank < this->AllParts.size(); ++rank)
  {
    const Box box = Intersection(this->AllParts[rank].Extent, asked);
    const bool isNew = std::none_of(boxes.begin(), boxes.end(), [&](const Box& other) { return Holds(other, box); });
    if (!IsEmpty(box) && isNew)
    {
      boxes.push_back(box);
      owners.push_back(static_cast<int>(rank));
    }
  }
  const bool hasCells =
    std::any_of(this->Columns.begin(), this->Columns.end(), [](const Column& column) { return column.IsOfCells; });
  this->RequireCovered(asked, boxes, false);
  if (hasCells && !IsEmpty(CellsOf(asked, this->Whole)))
  {
    this->RequireCovered(asked, boxes, true);
  }
  this->Last = nullptr; // before room is made for another one
  this->Last = this->Room(asked);
  for (std::size_t n = 0; n < boxes.size(); ++n)
  {
    owners[n] == 0 ? this->TakeOwnBox(boxes[n], this->Last) : this->ReceiveBox(owners[n], boxes[n], this->Last);
  }
  return this->Last;
}

}
