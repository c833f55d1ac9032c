// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GeoTiffFile.h"

#include "CoordinateSystem.h"
#include "GdalMessages.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <memory>
#include <vector>

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <ogr_spatialref.h>

namespace littoral
{

namespace
{

/// A file in memory, and what GDAL may put beside it.
class MemoryFile
{
public:
  MemoryFile()
  {
    static std::atomic<unsigned> counter{ 0 };
    this->Name = "/vsimem/littoral-" + std::to_string(counter++) + ".tif";
  }
  ~MemoryFile()
  {
    VSIUnlink(this->Name.c_str());
    VSIUnlink((this->Name + ".aux.xml").c_str());
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string Name;
};

struct CloseDataset
{
  void operator()(void* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<void, CloseDataset>;

Dataset CreateDataset(const std::string& name, const GeoTiffContent& content)
{
  CPLStringList options;
  options.SetNameValue("BIGTIFF", "IF_SAFER");
  options.SetNameValue("GEOTIFF_VERSION", "1.1");
  if (content.IsCompressed)
  {
    options.SetNameValue("COMPRESS", "DEFLATE");
    options.SetNameValue("PREDICTOR", "3"); // of floating-point numbers
  }
  const GDALDriverH driver = GDALGetDriverByName("GTiff");
  return Dataset(!driver ? nullptr
                         : GDALCreate(driver, name.c_str(), content.Points[0], content.Points[1], 1,
                             content.IsWide ? GDT_Float64 : GDT_Float32, options.List()));
}

/// Gives a dataset its place. Throws RasterError.
void SetPlace(void* dataset, const GeoTiffContent& content, GdalMessages& messages)
{
  // The corner of the first pixel is half a step before its center, along both sides.
  double transform[6] = { 0.0, content.Along[0], content.Across[0], 0.0, content.Along[1], content.Across[1] };
  transform[0] = content.First[0] - 0.5 * (content.Along[0] + content.Across[0]);
  transform[3] = content.First[1] - 0.5 * (content.Along[1] + content.Across[1]);
  bool isSet = GDALSetGeoTransform(dataset, transform) == CE_None;
  if (isSet && !content.System.empty())
  {
    OGRSpatialReference system;
    if (!ReadCoordinateSystem(content.System, system))
    {
      throw RasterError(
        "'" + content.System.substr(0, 60) + "' is no coordinate system; it must be a code as EPSG:32632, or WKT");
    }
    isSet = GDALSetSpatialRef(dataset, OGRSpatialReference::ToHandle(&system)) == CE_None;
  }
  if (!isSet)
  {
    throw RasterError(messages.ErrorOr("GeoTIFF cannot hold its place"));
  }
}

/// Writes the heights. Throws RasterError or WriteStopped.
void WriteRows(
  void* dataset, const GeoTiffContent& content, const RasterProgress& progress, const GdalMessages& messages)
{
  const GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
  GDALSetRasterNoDataValue(band, std::numeric_limits<double>::quiet_NaN());
  GDALSetRasterUnitType(band, "m");
  const int width = content.Points[0];
  const int height = content.Points[1];
  std::vector<double> row(width);
  for (int j = 0; j < height; ++j)
  {
    if (j % 64 == 0 && !progress(0.9 * j / height))
    {
      throw WriteStopped();
    }
    content.FillRow(j, row.data());
    if (GDALRasterIO(band, GF_Write, 0, j, width, 1, row.data(), width, 1, GDT_Float64, 0, 0) != CE_None)
    {
      throw RasterError(messages.ErrorOr("the heights cannot be written"));
    }
  }
}

/// Why the coordinate system that a file has is not the one it was given; empty if it is.
std::string WhyOtherSystem(const std::string& name, const std::string& wanted)
{
  if (wanted.empty())
  {
    return {};
  }
  const Dataset dataset(GDALOpen(name.c_str(), GA_ReadOnly));
  OGRSpatialReference system;
  ReadCoordinateSystem(wanted, system);
  const OGRSpatialReferenceH held = dataset ? GDALGetSpatialRef(dataset.get()) : nullptr;
  const char* const criterion[] = { "IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES", "CRITERION=EQUIVALENT", nullptr };
  const bool isSame = held && OSRIsSameEx(held, OGRSpatialReference::ToHandle(&system), criterion);
  VSIStatBufL status;
  const bool isBeside = VSIStatL((name + ".aux.xml").c_str(), &status) == 0;
  return isSame && !isBeside ? "" : "GeoTIFF cannot hold the coordinate system " + NameOf(system);
}

/// Copies a file in memory to the disk. Throws std::ios_base::failure or WriteStopped.
void CopyTo(ReplacedFile& file, const std::string& name, const RasterProgress& progress)
{
  vsi_l_offset length = 0;
  const GByte* bytes = VSIGetMemFileBuffer(name.c_str(), &length, false);
  constexpr vsi_l_offset chunk = 1 << 22;
  for (vsi_l_offset at = 0; bytes && at < length; at += chunk)
  {
    if (!progress(0.9 + 0.1 * static_cast<double>(at) / static_cast<double>(length)))
    {
      throw WriteStopped();
    }
    const vsi_l_offset part = std::min(chunk, length - at);
    file.Stream().write(reinterpret_cast<const char*>(bytes + at), static_cast<std::streamsize>(part));
  }
}

}

FileOutcome WriteGeoTiff(const std::string& path, const GeoTiffContent& content, const RasterProgress& progress)
{
  GDALAllRegister();
  GdalMessages messages;
  return WriteFile(path, [&](ReplacedFile& file) {
    const MemoryFile memory;
    Dataset dataset = CreateDataset(memory.Name, content);
    if (!dataset)
    {
      throw RasterError(messages.ErrorOr("GDAL has no writer of GeoTIFF"));
    }
    SetPlace(dataset.get(), content, messages);
    WriteRows(dataset.get(), content, progress, messages);
    dataset.reset(); // writes what is left
    const std::string problem = messages.ErrorOr(WhyOtherSystem(memory.Name, content.System));
    if (!problem.empty())
    {
      throw RasterError(problem);
    }
    CopyTo(file, memory.Name, progress);
    return file.Close() && file.Commit();
  });
}

}
