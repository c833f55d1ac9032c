// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImageSectionFilter.h"

#include "Data/Inputs.h"
#include "Data/PickedTuples.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Pipeline.h"

#include "vtkCellArray.h"
#include "vtkExtentTranslator.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerRequestKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkImageSectionFilter);

namespace
{

/// Memory of a point and its cell, at most, with some arrays [bytes].
constexpr double BytesOfPoint = 250.0;

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// The samples of a whole image that a piece of the sections is made of: a part along x, or the one that VTK makes of
/// the piece where the producer makes slabs along y. Parts share the samples between them; layers on these belong to
/// the part above.
struct SectionPart
{
  std::array<int, 6> Whole{ 0, -1, 0, -1, 0, -1 };
  std::array<int, 6> Extent{ 0, -1, 0, -1, 0, -1 };

  SectionPart(vtkInformation* input, vtkInformation* output)
  {
    if (!input->Has(Pipeline::WHOLE_EXTENT()))
    {
      return;
    }
    input->Get(Pipeline::WHOLE_EXTENT(), this->Whole.data());
    if (HasSlabs(input))
    {
      this->TakePiece(output);
      return;
    }
    const int width = this->Whole[1] - this->Whole[0];
    // An image of one layer across x belongs to the first piece.
    const littoral::PieceRange steps = littoral::RequestedPart(output, std::max(1, width));
    if (width >= 0 && steps.Begin < steps.End)
    {
      this->Extent = this->Whole;
      this->Extent[0] = this->Whole[0] + static_cast<int>(steps.Begin);
      this->Extent[1] = std::min(this->Whole[0] + static_cast<int>(steps.End), this->Whole[1]);
    }
  }

  /// Whether the producer of an image makes slabs along y for pieces.
  static bool HasSlabs(vtkInformation* input)
  {
    vtkInformationIntegerKey* mode = vtkExtentTranslator::UPDATE_SPLIT_MODE();
    return input->Has(mode) && input->Get(mode) == vtkExtentTranslator::Y_SLAB_MODE;
  }

  bool IsEmpty() const { return this->Extent[1] < this->Extent[0]; }

  /// Whether a layer across an axis belongs to it, or some of the layer.
  bool Has(int axis, int index) const
  {
    const int last = this->Extent[2 * axis + 1];
    return index >= this->Extent[2 * axis] && (index < last || last == this->Whole[2 * axis + 1]);
  }

private:
  /// Takes the slab that VTK makes of a piece.
  void TakePiece(vtkInformation* output)
  {
    vtkNew<vtkExtentTranslator> translator;
    std::array<int, 6> slab{};
    const int hasPart = translator->PieceToExtentThreadSafe(std::max(0, output->Get(Pipeline::UPDATE_PIECE_NUMBER())),
      std::max(1, output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())), 0, this->Whole.data(), slab.data(),
      vtkExtentTranslator::Y_SLAB_MODE, 0);
    if (hasPart != 0)
    {
      this->Extent = slab;
    }
  }
};

/// Sections of a part of an image, one after the other.
class Sections
{
public:
  Sections(vtkImageData* image, const std::array<int, 6>& extent, littoral::Poll onRow)
    : Image(image)
    , OnRow(std::move(onRow))
    , Extent(extent)
  {
    this->Points->SetDataTypeToDouble();
  }

  /// The layer of an index along an axis.
  void Add(int axis, int index)
  {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const vtkIdType first = this->Points->GetNumberOfPoints();
    const vtkIdType row = this->Extent[2 * u + 1] - this->Extent[2 * u] + 1;
    const double count = static_cast<double>(row) * (this->Extent[2 * v + 1] - this->Extent[2 * v] + 1.0);
    littoral::RequireMemory(
      BytesOfPoint * count, "a section of " + littoral::TextOf(count) + " points", "take a coarser image");
    int sample[3];
    sample[axis] = index;
    for (sample[v] = this->Extent[2 * v]; sample[v] <= this->Extent[2 * v + 1]; ++sample[v])
    {
      this->OnRow();
      for (sample[u] = this->Extent[2 * u]; sample[u] <= this->Extent[2 * u + 1]; ++sample[u])
      {
        const vtkIdType id = this->Image->ComputePointId(sample);
        this->Points->InsertNextPoint(this->Image->GetPoint(id));
        this->Samples.push_back(id);
      }
    }
    const vtkIdType end = this->Points->GetNumberOfPoints() - row;
    for (vtkIdType corner = first; corner < end; ++corner)
    {
      if ((corner - first) % row != row - 1)
      {
        const vtkIdType quad[4] = { corner, corner + 1, corner + row + 1, corner + row };
        this->Quads->InsertNextCell(4, quad);
      }
    }
  }

  void Write(vtkPolyData* output)
  {
    output->SetPoints(this->Points);
    output->SetPolys(this->Quads);
    littoral::PickTuples(this->Image->GetPointData(), this->Samples, output->GetPointData());
  }

private:
  vtkImageData* Image;
  littoral::Poll OnRow;
  std::array<int, 6> Extent;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Quads;
  std::vector<vtkIdType> Samples; ///< of the image, one a point
};

}

//----------------------------------------------------------------------------
vtkImageSectionFilter::vtkImageSectionFilter()
  : CrossSections(3)
{
}

//----------------------------------------------------------------------------
vtkImageSectionFilter::~vtkImageSectionFilter() = default;

//----------------------------------------------------------------------------
int vtkImageSectionFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//----------------------------------------------------------------------------
int vtkImageSectionFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  vtkInformation* output = outputVector->GetInformationObject(0);
  littoral::RequestAll(input);
  SectionPart part(input, output);
  if (SectionPart::HasSlabs(input))
  {
    // as the piece that it is, which ranks make together
    input->Set(Pipeline::UPDATE_PIECE_NUMBER(), std::max(0, output->Get(Pipeline::UPDATE_PIECE_NUMBER())));
    input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), std::max(1, output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())));
  }
  else if (!part.IsEmpty())
  {
    input->Set(Pipeline::UPDATE_EXTENT(), part.Extent.data(), 6);
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkImageSectionFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  littoral::ParameterCheck check;
  check.Count("CrossSections", this->CrossSections, 0, 100);
  littoral::Require(check.Reason());
  auto* image = littoral::InputOf<vtkImageData>(inputVector[0], "Input");
  const SectionPart part(inputVector[0]->GetInformationObject(0), outputVector->GetInformationObject(0));
  if (image->GetNumberOfPoints() == 0 || part.IsEmpty())
  {
    return 1;
  }
  const std::array<int, 6>& whole = part.Whole;
  Sections sections(image, part.Extent, littoral::PollOf(this));
  const auto isLayer = [&](int axis) { return whole[2 * axis] == whole[2 * axis + 1]; };
  if (isLayer(0) || isLayer(1) || isLayer(2))
  {
    const int axis = isLayer(2) ? 2 : isLayer(1) ? 1 : 0;
    sections.Add(axis, whole[2 * axis]);
  }
  else
  {
    if (part.Has(2, whole[4]))
    {
      sections.Add(2, whole[4]);
    }
    if (part.Has(1, whole[3]))
    {
      sections.Add(1, whole[3]);
    }
    std::set<int> across;
    for (int i = 0; i < this->CrossSections; ++i)
    {
      const long long width = whole[1] - whole[0];
      across.insert(whole[0] + static_cast<int>((2 * i + 1) * width / (2 * this->CrossSections)));
    }
    for (const int index : across)
    {
      if (part.Has(0, index))
      {
        sections.Add(0, index);
      }
    }
  }
  sections.Write(vtkPolyData::GetData(outputVector));
  return 1;
}

//----------------------------------------------------------------------------
int vtkImageSectionFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(this, request, outputs,
    "Cannot cut sections: ", [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkImageSectionFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CrossSections: " << this->CrossSections << "\n";
}
