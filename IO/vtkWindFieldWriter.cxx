// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindFieldWriter.h"

#include "ImageParts.h"
#include "InflowFile.h"
#include "InflowImage.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Pipeline.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"

#include <vector>

vtkStandardNewMacro(vtkWindFieldWriter);

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
  this->WritePlanes(littoral::PartsOf(vtkImageData::SafeDownCast(this->GetInput())));
}

//----------------------------------------------------------------------------
void vtkWindFieldWriter::WriteTogether(vtkDataObject* own)
{
  this->WritePartsTogether(own, [this](const littoral::ImageParts& parts) { this->WritePlanes(parts); });
}

//----------------------------------------------------------------------------
int vtkWindFieldWriter::Write()
{
  return this->WriteParts([this](const littoral::ImageParts& parts) { this->WritePlanes(parts); });
}

//----------------------------------------------------------------------------
void vtkWindFieldWriter::WritePlanes(const littoral::ImageParts& parts)
{
  const littoral::ImageParts::Extent& whole = parts.Whole;
  const auto part = [&](int first, int last) {
    return parts.Get({ first, last, whole[2], whole[3], whole[4], whole[5] });
  };
  const std::string path = this->NeedFileName();
  littoral::FormatOf(path);
  littoral::ParameterCheck check;
  check.NotNegative("HubHeight", this->HubHeight, "m");
  check.Choice("PlaneOrder", this->PlaneOrder, LatestFirst + 1);
  littoral::Require(check.Reason());

  this->SetProgressText("Writing wind");
  vtkImageData* first = part(whole[1], whole[1]);
  const littoral::InflowGrid grid =
    littoral::ReadInflowGrid(first, whole.data(), { this->HubHeight, this->TowerLayers });
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
    littoral::CopyPlanes(
      part(whole[1] - begin - count + 1, whole[1] - begin), whole.data(), grid, begin, count, velocities);
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
