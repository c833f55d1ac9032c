// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkElevationReader.h"

#include "Data/Arrays.h"
#include "Data/Georeference.h"
#include "Data/Tables.h"
#include "NetcdfKind.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Mistakes.h"
#include "Pipeline/Pipeline.h"
#include "Raster.h"

#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

vtkStandardNewMacro(vtkElevationReader);

namespace
{

/// Range and number of the heights.
struct HeightRange
{
  vtkIdType Count = 0;
  float Low = std::numeric_limits<float>::infinity();
  float High = -std::numeric_limits<float>::infinity();

  explicit HeightRange(vtkFloatArray* heights)
  {
    const float* height = heights->GetPointer(0);
    for (vtkIdType i = 0; i < heights->GetNumberOfTuples(); ++i)
    {
      const bool isThere = !std::isnan(height[i]);
      this->Count += isThere;
      this->Low = isThere ? std::min(this->Low, height[i]) : this->Low;
      this->High = isThere ? std::max(this->High, height[i]) : this->High;
    }
  }
};

/// Hides the points without a height.
void HideHoles(vtkImageData* image, vtkFloatArray* heights)
{
  const vtkIdType count = heights->GetNumberOfTuples();
  auto ghosts = littoral::NewArray<vtkUnsignedCharArray>(vtkDataSetAttributes::GhostArrayName(), 1, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const bool isHole = std::isnan(heights->GetValue(i));
    ghosts->SetValue(i, isHole ? static_cast<unsigned char>(vtkDataSetAttributes::HIDDENPOINT) : 0);
  }
  image->GetPointData()->AddArray(ghosts);
}

/// A number in six digits.
std::string Short(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

std::string Summary(const littoral::RasterGrid& grid, const std::string& heightWords, const HeightRange& range)
{
  const vtkIdType missing = static_cast<vtkIdType>(grid.Points[0]) * grid.Points[1] - range.Count;
  return std::to_string(grid.Points[0]) + " x " + std::to_string(grid.Points[1]) + " heights, " +
    Short(grid.Spacing[0]) + " x " + Short(grid.Spacing[1]) + " m apart, from " + Short(range.Low) + " to " +
    Short(range.High) + " m; " + std::to_string(missing) + " missing; " + grid.SystemName + "; " + heightWords;
}

}

//----------------------------------------------------------------------------
vtkElevationReader::vtkElevationReader()
{
  this->SetNumberOfInputPorts(0);
}

//----------------------------------------------------------------------------
vtkElevationReader::~vtkElevationReader()
{
  this->SetFileName(nullptr);
}

//----------------------------------------------------------------------------
int vtkElevationReader::CanReadFile(const char* name)
{
  return name && littoral::IsPlacedRaster(name) && littoral::KindOfNetcdf(name) == littoral::NetcdfKind::Other ? 1 : 0;
}

//----------------------------------------------------------------------------
void vtkElevationReader::Refuse(const std::string& reason)
{
  littoral::FailedBy(this, littoral::FileMessage("read", this->FileName ? this->FileName : "", "a raster", reason));
}

//----------------------------------------------------------------------------
std::string vtkElevationReader::WhyInvalid() const
{
  littoral::ParameterCheck check;
  check.Require(this->FileName && *this->FileName, "FileName is empty.");
  check.PositiveCount("Band", this->Band);
  check.Choice("Projection", this->Projection, GivenSystem + 1);
  check.Choice("Resampling", this->Resampling, Cubic + 1);
  check.Choice("HeightUnit", this->HeightUnit, USSurveyFeet + 1);
  check.NotNegative("ProjectedSpacing", this->ProjectedSpacing, "m");
  check.Require(!this->UseNoDataValue || std::isfinite(this->NoDataValue), "NoDataValue must be finite.");
  return check.Reason();
}

//----------------------------------------------------------------------------
littoral::RasterOptions vtkElevationReader::Options() const
{
  constexpr double metres[] = { 0.0, 1.0, 0.3048, 1200.0 / 3937.0 }; // by HeightUnitType
  littoral::RasterOptions options;
  options.Path = this->FileName;
  options.Dataset = this->Dataset;
  options.Band = this->Band;
  options.FileSystem = this->FileCoordinateSystem;
  options.Projection = static_cast<littoral::RasterProjection>(this->Projection);
  options.GivenSystem = this->CoordinateSystem;
  options.Spacing = this->ProjectedSpacing;
  options.Resampling = static_cast<littoral::RasterResampling>(this->Resampling);
  options.MetresPerHeight = metres[this->HeightUnit];
  options.HasLocalOrigin = this->LocalOrigin;
  options.UsesNoData = this->UseNoDataValue;
  options.NoData = this->NoDataValue;
  return options;
}

//----------------------------------------------------------------------------
int vtkElevationReader::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  this->WhyUnread.clear();
  try
  {
    littoral::Require(this->WhyInvalid());
    const littoral::Raster raster(this->Options());
    const littoral::RasterGrid& grid = raster.Grid();
    const std::array<int, 6> extent{ 0, grid.Points[0] - 1, 0, grid.Points[1] - 1, 0, 0 };
    const std::array<double, 3> origin{ grid.Origin[0], grid.Origin[1], 0.0 };
    const std::array<double, 3> spacing{ grid.Spacing[0], grid.Spacing[1], 1.0 };
    vtkInformation* info = outputVector->GetInformationObject(0);
    info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent.data(), 6);
    info->Set(vtkDataObject::ORIGIN(), origin.data(), 3);
    info->Set(vtkDataObject::SPACING(), spacing.data(), 3);
    info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
    vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 1);
    return 1;
  }
  catch (const littoral::InvalidInput& refusal)
  {
    this->WhyUnread = refusal.what();
    const int result = littoral::FailedInformation(this, outputVector);
    if (result == 0)
    {
      this->Refuse(this->WhyUnread);
    }
    return result; // ParaView also asks before a user could choose a projection: it is told with the data
  }
}

//----------------------------------------------------------------------------
int vtkElevationReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  littoral::ForgetExtent(info);
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  if (littoral::IsAnnouncedEmpty(info))
  {
    this->Refuse(this->WhyUnread);
    return littoral::FailedRequest(this);
  }
  try
  {
    littoral::Raster raster(this->Options());
    const littoral::RasterGrid& grid = raster.Grid();
    std::array<int, 6> extent = littoral::RequestedExtent(info);
    output->SetExtent(extent.data());
    output->SetOrigin(grid.Origin[0], grid.Origin[1], 0.0);
    output->SetSpacing(grid.Spacing[0], grid.Spacing[1], 1.0);
    if (extent[1] < extent[0] || extent[3] < extent[2])
    {
      return 1; // a rank with nothing to do
    }
    const vtkIdType count = output->GetNumberOfPoints();
    // 4 bytes a height, and 1 that hides it
    const double ofHeights = 5.0 * static_cast<double>(count);
    const double ofWork = raster.WorkBytes(extent[1] - extent[0] + 1);
    const char* remedy = this->Projection == AsInFile ? "read a part of it, or a coarser one"
      : ofHeights > ofWork                            ? "set a larger ProjectedSpacing"
                                                      : "set a smaller ProjectedSpacing";
    littoral::RequireMemory(ofHeights + ofWork,
      "a raster of " + std::to_string(extent[1] - extent[0] + 1) + " x " + std::to_string(extent[3] - extent[2] + 1) +
        " heights",
      remedy);
    auto heights = littoral::NewArray<vtkFloatArray>("Elevation", 1, count);
    this->SetProgressText("Reading heights");
    const bool isRead =
      raster.Read({ extent[0], extent[1], extent[2], extent[3] }, heights->GetPointer(0), [this](double share) {
        this->UpdateProgress(share);
        return !littoral::IsAborted(this);
      });
    if (!isRead)
    {
      output->Initialize();
      return 1;
    }
    const HeightRange range(heights);
    const bool isWhole = count == static_cast<vtkIdType>(grid.Points[0]) * grid.Points[1];
    if (isWhole && range.Count == 0)
    {
      throw littoral::RasterError("all of its " + std::to_string(count) + " heights are missing");
    }
    output->GetPointData()->SetScalars(heights);
    if (range.Count < count)
    {
      HideHoles(output, heights);
    }
    littoral::AddGeoreference(output, { grid.System, grid.MetresPerUnit, grid.Offset });
    if (isWhole)
    {
      littoral::AddText(output, "ElevationSummary", Summary(grid, raster.HeightWords(), range));
    }
    this->UpdateProgress(1.0);
    return 1;
  }
  catch (const littoral::InvalidInput& refusal)
  {
    output->Initialize();
    this->Refuse(refusal.what());
    return littoral::FailedRequest(this);
  }
}

//----------------------------------------------------------------------------
int vtkElevationReader::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(
    this, request, outputs, [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkElevationReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Dataset: " << this->Dataset << "\n";
  os << indent << "Band: " << this->Band << "\n";
  os << indent << "FileCoordinateSystem: " << this->FileCoordinateSystem << "\n";
  os << indent << "Projection: " << this->Projection << "\n";
  os << indent << "CoordinateSystem: " << this->CoordinateSystem << "\n";
  os << indent << "ProjectedSpacing: " << this->ProjectedSpacing << "\n";
  os << indent << "Resampling: " << this->Resampling << "\n";
  os << indent << "HeightUnit: " << this->HeightUnit << "\n";
  os << indent << "LocalOrigin: " << (this->LocalOrigin ? "on" : "off") << "\n";
  os << indent << "UseNoDataValue: " << (this->UseNoDataValue ? "on" : "off") << "\n";
  os << indent << "NoDataValue: " << this->NoDataValue << "\n";
}
