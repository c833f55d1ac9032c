// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImageSectionFilter.h"

#include "Data/Inputs.h"
#include "Data/PickedTuples.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Pipeline.h"

#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <array>
#include <set>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkImageSectionFilter);

namespace
{

/// Memory of a point and its cell, at most, with some arrays [bytes].
constexpr double BytesOfPoint = 250.0;

/// Sections of an image, one after the other.
class Sections
{
public:
  Sections(vtkImageData* image, littoral::Poll onRow)
    : Image(image)
    , OnRow(std::move(onRow))
  {
    image->GetExtent(this->Extent.data());
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
    littoral::RequireMemory(BytesOfPoint * count, "a section of " + littoral::TextOf(count) + " points", "take a coarser image");
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

  int First(int axis) const { return this->Extent[2 * axis]; }
  int Last(int axis) const { return this->Extent[2 * axis + 1]; }

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
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  littoral::RequestAll(inputVector[0]->GetInformationObject(0));
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
  if (image->GetNumberOfPoints() == 0 ||
    outputVector->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1;
  }
  Sections sections(image, littoral::PollOf(this));
  const auto isLayer = [&](int axis) { return sections.First(axis) == sections.Last(axis); };
  if (isLayer(0) || isLayer(1) || isLayer(2))
  {
    const int axis = isLayer(2) ? 2 : isLayer(1) ? 1 : 0;
    sections.Add(axis, sections.First(axis));
  }
  else
  {
    sections.Add(2, sections.First(2));
    sections.Add(1, sections.Last(1));
    std::set<int> across;
    for (int i = 0; i < this->CrossSections; ++i)
    {
      const long long width = sections.Last(0) - sections.First(0);
      across.insert(sections.First(0) + static_cast<int>((2 * i + 1) * width / (2 * this->CrossSections)));
    }
    for (int index : across)
    {
      sections.Add(0, index);
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
