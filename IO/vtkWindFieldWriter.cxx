// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindFieldWriter.h"

#include "InflowFile.h"
#include "InflowImage.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Pipeline.h"

#include "vtkCommand.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <array>
#include <vector>

vtkStandardNewMacro(vtkWindFieldWriter);

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// The image of an output, or null.
vtkImageData* ImageOf(vtkAlgorithm* producer, int port)
{
  return vtkImageData::SafeDownCast(producer->GetOutputDataObject(port));
}

/// Updates a part of an image. Throws Aborted where that fails: the producer has told why.
vtkImageData* UpdatedPart(vtkAlgorithm* producer, int port, const std::array<int, 6>& extent)
{
  vtkInformation* info = producer->GetOutputInformation(port);
  // a part of its own choice, whatever piece was asked for before
  info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
  info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  info->Set(Pipeline::UPDATE_EXTENT_INITIALIZED(), 1);
  info->Set(Pipeline::UPDATE_EXTENT(), extent.data(), 6);
  const bool isUpdated = producer->GetExecutive()->Update(port) != 0;
  vtkImageData* image = ImageOf(producer, port);
  if (!isUpdated || !image || image->GetNumberOfPoints() == 0)
  {
    throw littoral::Aborted();
  }
  return image;
}

}

//----------------------------------------------------------------------------
vtkWindFieldWriter::vtkWindFieldWriter()
  : vtkSingleFileWriter("a wind")
{
}

//----------------------------------------------------------------------------
vtkWindFieldWriter::~vtkWindFieldWriter() = default;

//----------------------------------------------------------------------------
int vtkWindFieldWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//----------------------------------------------------------------------------
void vtkWindFieldWriter::WriteInput()
{
  auto* image = vtkImageData::SafeDownCast(this->GetInput());
  littoral::Require(image ? "" : "there is no input");
  int whole[6];
  image->GetExtent(whole);
  this->WritePlanes(whole, [image](int, int) { return image; });
}

//----------------------------------------------------------------------------
int vtkWindFieldWriter::Write()
{
  this->SetErrorCode(vtkErrorCode::NoError);
  this->InvokeEvent(vtkCommand::StartEvent);
  this->WriteOrRefuse([&] {
    int port = 0;
    vtkAlgorithm* producer = this->GetNumberOfInputConnections(0) > 0 ? this->GetInputAlgorithm(0, 0, port) : nullptr;
    littoral::Require(producer ? "" : "there is no input");
    producer->UpdateInformation();
    vtkInformation* info = producer->GetOutputInformation(port);
    const bool isImage = ImageOf(producer, port) && info->Has(Pipeline::WHOLE_EXTENT());
    littoral::Require(isImage ? "" : "the input is no image");
    std::array<int, 6> whole{};
    info->Get(Pipeline::WHOLE_EXTENT(), whole.data());
    littoral::Require(whole[1] >= whole[0] ? "" : "the input is empty");
    this->WritePlanes(whole.data(), [&](int first, int last) {
      return UpdatedPart(producer, port, { first, last, whole[2], whole[3], whole[4], whole[5] });
    });
  });
  this->InvokeEvent(vtkCommand::EndEvent);
  this->WriteTime.Modified();
  return this->IsWritten ? 1 : 0;
}

//----------------------------------------------------------------------------
void vtkWindFieldWriter::WritePlanes(const int whole[6], const PartOfInput& part)
{
  const std::string path = this->NeedFileName();
  littoral::FormatOf(path);
  littoral::ParameterCheck check;
  check.NotNegative("HubHeight", this->HubHeight, "m");
  check.Choice("PlaneOrder", this->PlaneOrder, LatestFirst + 1);
  littoral::Require(check.Reason());

  this->SetProgressText("Writing wind");
  vtkImageData* first = part(whole[1], whole[1]);
  const littoral::InflowGrid grid = littoral::ReadInflowGrid(first, whole, { this->HubHeight, this->TowerLayers });
  littoral::RequireMemory(6.0 * sizeof(float) * static_cast<double>(grid.PointsOfPlane()) * littoral::TimesAtOnce(grid),
    "a part of the wind", "take fewer points across and up");
  double done = 0.0;
  const littoral::InflowSource planes = [&](int begin, int count, float* velocities) {
    this->UpdateProgress(done / (2.0 * grid.Count[0]));
    done += count;
    if (littoral::IsAborted(this))
    {
      return false;
    }
    littoral::CopyPlanes(part(whole[1] - begin - count + 1, whole[1] - begin), whole, grid, begin, count, velocities);
    return true;
  };
  littoral::InflowRange range;
  std::vector<float> velocities(3 * grid.PointsOfPlane() * littoral::TimesAtOnce(grid));
  const bool isRead = littoral::ForSlabs(grid, false, [&](int begin, int count) {
    const bool proceeds = planes(begin, count, velocities.data());
    if (proceeds)
    {
      range.Add(velocities.data(), grid.PointsOfPlane() * count);
    }
    return proceeds;
  });
  if (!isRead)
  {
    throw littoral::Aborted();
  }
  velocities = {};
  this->Conclude(littoral::WriteInflow(path, grid, range, static_cast<littoral::HawcOrder>(this->PlaneOrder), planes));
}

//----------------------------------------------------------------------------
void vtkWindFieldWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "HubHeight: " << this->HubHeight << "\n";
  os << indent << "TowerLayers: " << this->TowerLayers << "\n";
  os << indent << "PlaneOrder: " << this->PlaneOrder << "\n";
}
