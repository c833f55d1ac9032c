// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkElevationWriter.h"

#include "CoordinateSystem.h"
#include "Data/Georeference.h"
#include "Data/Inputs.h"
#include "GdalMessages.h"
#include "GeoTiffFile.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Pipeline.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <limits>

#include <ogr_spatialref.h>

vtkStandardNewMacro(vtkElevationWriter);

namespace
{

/// Metres per unit of a coordinate system that was named by the user. Throws what a user should read.
double MetresPerUnitOf(const std::string& text)
{
  const littoral::GdalMessages quiet;
  OGRSpatialReference system;
  if (!littoral::ReadCoordinateSystem(text, system))
  {
    throw littoral::RasterError("CoordinateSystem is '" + text.substr(0, 60) +
      "', which is no coordinate system; it must be a code as EPSG:32632, or WKT");
  }
  if (!system.IsProjected() && !system.IsLocal())
  {
    throw littoral::RasterError(
      "CoordinateSystem is " + littoral::NameOf(system) + "; that of an image in metres must be a projection, as UTM");
  }
  return system.GetLinearUnits();
}

}

//----------------------------------------------------------------------------
vtkElevationWriter::vtkElevationWriter()
  : vtkSingleFileWriter("a raster")
{
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
}

//----------------------------------------------------------------------------
vtkElevationWriter::~vtkElevationWriter() = default;

//----------------------------------------------------------------------------
int vtkElevationWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//----------------------------------------------------------------------------
std::string vtkElevationWriter::WhyInvalid() const
{
  littoral::ParameterCheck check;
  check.Choice("Compression", this->Compression, Deflate + 1);
  return check.Reason();
}

//----------------------------------------------------------------------------
vtkDataArray* vtkElevationWriter::FindHeights(vtkImageData* image)
{
  vtkInformation* choice = this->GetInputArrayInformation(0);
  vtkDataArray* heights = this->GetInputArrayToProcess(0, image);
  if (!heights && littoral::NamesDefaultElevation(choice))
  {
    heights = image->GetPointData()->GetScalars();
  }
  if (!heights || heights->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    const char* name = choice->Get(vtkDataObject::FIELD_NAME());
    littoral::Refuse("the image has no point array '", name ? name : "Elevation", "'.");
  }
  if (heights->GetNumberOfComponents() != 1)
  {
    littoral::Refuse("the array '", heights->GetName() ? heights->GetName() : "", "' has ",
      heights->GetNumberOfComponents(), " components; heights have one.");
  }
  return heights;
}

//----------------------------------------------------------------------------
void vtkElevationWriter::SetPlace(vtkImageData* image, littoral::GeoTiffContent& content) const
{
  littoral::Georeference place = littoral::ReadGeoreference(image);
  if (!this->CoordinateSystem.empty())
  {
    place.System = this->CoordinateSystem;
    place.MetresPerUnit = MetresPerUnitOf(place.System);
  }
  const double* turn = image->GetDirectionMatrix()->GetData(); // columns are the axes
  if (turn[2] != 0.0 || turn[5] != 0.0 || turn[6] != 0.0 || turn[7] != 0.0)
  {
    littoral::Refuse("the image is tilted: its rows and columns must lie in the plane of x and y.");
  }
  int extent[6];
  image->GetExtent(extent);
  const double* spacing = image->GetSpacing();
  // The first row of the file is the last one of the image.
  double first[3];
  image->TransformIndexToPhysicalPoint(extent[0], extent[3], extent[4], first);
  for (int axis = 0; axis < 2; ++axis)
  {
    content.First[axis] = (first[axis] + place.Offset[axis]) / place.MetresPerUnit;
    content.Along[axis] = turn[3 * axis] * spacing[0] / place.MetresPerUnit;
    content.Across[axis] = -turn[3 * axis + 1] * spacing[1] / place.MetresPerUnit;
  }
  content.System = place.System;
}

//----------------------------------------------------------------------------
void vtkElevationWriter::WriteImage(vtkImageData* image)
{
  this->NeedFileName();
  littoral::Require(this->WhyInvalid());
  littoral::RequireRaster(image, 1);
  vtkDataArray* heights = this->FindHeights(image);
  littoral::GeoTiffContent content;
  this->SetPlace(image, content);
  int dimensions[3];
  image->GetDimensions(dimensions);
  content.Points = { dimensions[0], dimensions[1] };
  content.IsWide = heights->GetDataType() == VTK_DOUBLE;
  content.IsCompressed = this->Compression == Deflate;
  // The file is made in memory, compressed or not at most as large as the heights and somewhat more.
  const double bytes = (content.IsWide ? 8.8 : 4.4) * static_cast<double>(image->GetNumberOfPoints());
  littoral::RequireMemory(bytes, "it", "take a smaller or coarser terrain");
  vtkUnsignedCharArray* ghosts = image->GetPointGhostArray();
  content.FillRow = [&](int row, double* values) {
    const vtkIdType begin = static_cast<vtkIdType>(dimensions[1] - 1 - row) * dimensions[0];
    for (int i = 0; i < dimensions[0]; ++i)
    {
      const double height = heights->GetComponent(begin + i, 0);
      const bool isHidden = ghosts && (ghosts->GetValue(begin + i) & vtkDataSetAttributes::HIDDENPOINT);
      values[i] = isHidden || !std::isfinite(height) ? std::numeric_limits<double>::quiet_NaN() : height;
    }
  };
  this->SetProgressText("Writing heights");
  this->Conclude(littoral::WriteGeoTiff(this->FileName, content, [this](double share) {
    this->UpdateProgress(share);
    return !littoral::IsAborted(this);
  }));
}

//----------------------------------------------------------------------------
void vtkElevationWriter::WriteInput()
{
  auto* image = vtkImageData::SafeDownCast(this->GetInput());
  littoral::Require(image ? "" : "there is no input.");
  this->WriteImage(image);
}

//----------------------------------------------------------------------------
void vtkElevationWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CoordinateSystem: " << this->CoordinateSystem << "\n";
  os << indent << "Compression: " << this->Compression << "\n";
}
