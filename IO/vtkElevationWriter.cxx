// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkElevationWriter.h"

#include "CoordinateSystem.h"
#include "Data/Georeference.h"
#include "Data/Inputs.h"
#include "GdalMessages.h"
#include "GeoTiffFile.h"
#include "ImageParts.h"
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
void vtkElevationWriter::SetPlace(vtkImageData* image, const int whole[6], littoral::GeoTiffContent& content) const
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
  const double* spacing = image->GetSpacing();
  // The first row of the file is the last one of the image.
  double first[3];
  image->TransformIndexToPhysicalPoint(whole[0], whole[3], whole[4], first);
  for (int axis = 0; axis < 2; ++axis)
  {
    content.First[axis] = (first[axis] + place.Offset[axis]) / place.MetresPerUnit;
    content.Along[axis] = turn[3 * axis] * spacing[0] / place.MetresPerUnit;
    content.Across[axis] = -turn[3 * axis + 1] * spacing[1] / place.MetresPerUnit;
  }
  content.System = place.System;
}

//----------------------------------------------------------------------------
void vtkElevationWriter::WriteHeights(const littoral::ImageParts& parts)
{
  this->NeedFileName();
  littoral::Require(this->WhyInvalid());
  const littoral::ImageParts::Extent& whole = parts.Whole;
  const auto part = [&](int low, int high) { return parts.Get({ whole[0], whole[1], low, high, whole[4], whole[5] }); };
  vtkImageData* image = part(whole[3], whole[3]);
  littoral::RequireRaster(image, 1);
  littoral::GeoTiffContent content;
  this->SetPlace(image, whole.data(), content);
  content.Points = { whole[1] - whole[0] + 1, whole[3] - whole[2] + 1 };
  content.IsWide = this->FindHeights(image)->GetDataType() == VTK_DOUBLE;
  content.IsCompressed = this->Compression == Deflate;
  const double bytes = static_cast<double>(sizeof(double)) * content.Points[0] * littoral::RowsAtOnce(content);
  littoral::RequireMemory(bytes, "a part of it", "take a coarser terrain");
  content.FillRows = [&](int first, int count, double* heights) {
    this->FillRows(part(whole[3] - first - count + 1, whole[3] - first), whole.data(), first, count, heights);
  };
  this->SetProgressText("Writing heights");
  this->Conclude(littoral::WriteGeoTiff(this->FileName, content, [this](double share) {
    this->UpdateProgress(share);
    return !littoral::IsAborted(this);
  }));
}

//----------------------------------------------------------------------------
void vtkElevationWriter::FillRows(vtkImageData* image, const int whole[6], int first, int count, double* values)
{
  vtkDataArray* heights = this->FindHeights(image);
  vtkUnsignedCharArray* ghosts = image->GetPointGhostArray();
  for (int row = first; row < first + count; ++row)
  {
    int place[3] = { whole[0], whole[3] - row, whole[4] };
    const vtkIdType begin = image->ComputePointId(place);
    for (vtkIdType point = begin; point <= begin + whole[1] - whole[0]; ++point)
    {
      const double height = heights->GetComponent(point, 0);
      const bool isHidden = ghosts && (ghosts->GetValue(point) & vtkDataSetAttributes::HIDDENPOINT);
      *values++ = isHidden || !std::isfinite(height) ? std::numeric_limits<double>::quiet_NaN() : height;
    }
  }
}

//----------------------------------------------------------------------------
void vtkElevationWriter::WriteInput()
{
  this->WriteHeights(littoral::PartsOf(vtkImageData::SafeDownCast(this->GetInput())));
}

//----------------------------------------------------------------------------
void vtkElevationWriter::WriteTogether(vtkDataObject* own)
{
  this->WritePartsTogether(own, [this](const littoral::ImageParts& parts) { this->WriteHeights(parts); });
}

//----------------------------------------------------------------------------
int vtkElevationWriter::Write()
{
  return this->WriteParts([this](const littoral::ImageParts& parts) { this->WriteHeights(parts); });
}

//----------------------------------------------------------------------------
void vtkElevationWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CoordinateSystem: " << this->CoordinateSystem << "\n";
  os << indent << "Compression: " << this->Compression << "\n";
}
