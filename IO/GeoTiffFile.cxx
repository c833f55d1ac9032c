// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GeoTiffFile.h"

#include "CoordinateSystem.h"
#include "GdalMessages.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <limits>
#include <memory>
#include <sstream>
#include <vector>

#include <cpl_conv.h>
#include <cpl_string.h>
#include <gdal.h>
#include <ogr_spatialref.h>

namespace littoral
{

namespace
{

constexpr int LargestBlock = 512;

/// Side of the blocks, of which a small raster has one; files have multiples of 16.
int BlockOf(const GeoTiffContent& content)
{
  const int side = std::max(content.Points[0], content.Points[1]);
  return std::min(LargestBlock, (side + 15) / 16 * 16);
}

struct CloseDataset
{
  void operator()(void* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<void, CloseDataset>;

GDALDriverH DriverNamed(const char* name)
{
  const GDALDriverH driver = GDALGetDriverByName(name);
  if (!driver)
  {
    throw RasterError(std::string("GDAL has no driver ") + name);
  }
  return driver;
}

/// A dataset in blocks, without compression.
Dataset CreateDataset(const std::string& name, const GeoTiffContent& content)
{
  const std::string block = std::to_string(BlockOf(content));
  CPLStringList options;
  options.SetNameValue("BIGTIFF", "IF_SAFER");
  options.SetNameValue("TILED", "YES");
  options.SetNameValue("BLOCKXSIZE", block.c_str());
  options.SetNameValue("BLOCKYSIZE", block.c_str());
  return Dataset(GDALCreate(DriverNamed("GTiff"), name.c_str(), content.Points[0], content.Points[1], 1,
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

/// A part of the progress, for GDAL, which goes on as long as it is told to.
struct ProgressPart
{
  const RasterProgress& Progress;
  double Begin;
  double Share;
  bool IsStopped = false;

  static int Tell(double done, const char*, void* self)
  {
    auto& part = *static_cast<ProgressPart*>(self);
    part.IsStopped = part.IsStopped || !part.Progress(part.Begin + part.Share * done);
    return !part.IsStopped;
  }
};

/// Throws why GDAL failed, or WriteStopped.
void RequireDone(bool isDone, const ProgressPart& part, const GdalMessages& messages)
{
  if (part.IsStopped)
  {
    throw WriteStopped();
  }
  const std::string problem = messages.ErrorOr(isDone ? "" : "the heights cannot be written");
  if (!problem.empty())
  {
    throw RasterError(problem);
  }
}

void WriteRows(void* dataset, const GeoTiffContent& content, ProgressPart part, const GdalMessages& messages)
{
  const GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
  GDALSetRasterNoDataValue(band, std::numeric_limits<double>::quiet_NaN());
  GDALSetRasterUnitType(band, "m");
  const int width = content.Points[0];
  const int height = content.Points[1];
  const int most = std::min(RowsAtOnce(content), height);
  std::vector<double> rows(static_cast<std::size_t>(width) * most);
  for (int first = 0; first < height; first += most)
  {
    const bool proceeds = ProgressPart::Tell(static_cast<double>(first) / height, nullptr, &part) != 0;
    RequireDone(true, part, messages);
    const int count = std::min(most, height - first);
    content.FillRows(first, count, rows.data());
    const bool isWritten =
      GDALRasterIO(band, GF_Write, 0, first, width, count, rows.data(), width, count, GDT_Float64, 0, 0) == CE_None;
    GDALFlushCache(dataset); // its blocks go to the disk
    RequireDone(proceeds && isWritten, part, messages);
  }
}

/// Adds overviews, each half as wide as the last, until one block has all.
void AddOverviews(void* dataset, const GeoTiffContent& content, ProgressPart part, const GdalMessages& messages)
{
  std::vector<int> factors;
  for (int factor = 2, side = std::max(content.Points[0], content.Points[1]); side > LargestBlock; factor *= 2)
  {
    factors.push_back(factor);
    side = (side + 1) / 2;
  }
  const bool isDone = factors.empty() ||
    GDALBuildOverviews(dataset, "AVERAGE", static_cast<int>(factors.size()), factors.data(), 0, nullptr,
      &ProgressPart::Tell, &part) == CE_None;
  RequireDone(isDone, part, messages);
}

/// Copies a dataset with its overviews into a file in the order of the cloud.
void CopyInOrder(void* dataset, const GeoTiffContent& content, const std::string& name, ProgressPart part,
  const GdalMessages& messages)
{
  CPLStringList options;
  options.SetNameValue("BIGTIFF", "IF_SAFER");
  options.SetNameValue("GEOTIFF_VERSION", "1.1");
  options.SetNameValue("BLOCKSIZE", std::to_string(BlockOf(content)).c_str());
  options.SetNameValue("COMPRESS", content.IsCompressed ? "DEFLATE" : "NONE");
  options.SetNameValue("PREDICTOR", content.IsCompressed ? "YES" : "NO");
  const Dataset copy(
    GDALCreateCopy(DriverNamed("COG"), name.c_str(), dataset, true, options.List(), &ProgressPart::Tell, &part));
  RequireDone(copy != nullptr, part, messages);
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
  return isSame ? "" : "GeoTIFF cannot hold the coordinate system " + NameOf(system);
}

/// Throws where a disk has no room for the heights and their overviews without compression, a third more.
void RequireDisk(const std::string& path, const GeoTiffContent& content)
{
  const double pixels = static_cast<double>(content.Points[0]) * content.Points[1];
  const double bytes = pixels * (content.IsWide ? 8.0 : 4.0) * 4.0 / 3.0;
  std::error_code error;
  const auto folder = std::filesystem::absolute(path, error).parent_path();
  const auto room = error ? std::filesystem::space_info{} : std::filesystem::space(folder, error);
  if (!error && static_cast<double>(room.available) < bytes)
  {
    std::ostringstream reason;
    reason << "No space left on device: it takes " << std::setprecision(3) << bytes / 1e6
           << " MB while it is written, and " << static_cast<double>(room.available) / 1e6 << " MB are free";
    throw RasterError(reason.str());
  }
}

/// Makes the file at the name of a new one, by way of another without compression beside it.
void MakeFile(const std::string& name, const std::string& scratch, const GeoTiffContent& content,
  const RasterProgress& progress, GdalMessages& messages)
{
  const Dataset dataset = CreateDataset(scratch, content);
  if (!dataset)
  {
    throw RasterError(messages.ErrorOr("GDAL cannot create it"));
  }
  SetPlace(dataset.get(), content, messages);
  WriteRows(dataset.get(), content, { progress, 0.0, 0.6 }, messages);
  AddOverviews(dataset.get(), content, { progress, 0.6, 0.1 }, messages);
  CopyInOrder(dataset.get(), content, name, { progress, 0.7, 0.3 }, messages);
  const std::string problem = messages.ErrorOr(WhyOtherSystem(name, content.System));
  if (!problem.empty())
  {
    throw RasterError(problem);
  }
}

}

int RowsAtOnce(const GeoTiffContent& content)
{
  constexpr double bytes = 32.0 * 1024.0 * 1024.0;
  const int block = BlockOf(content);
  const double blocks = bytes / (sizeof(double) * content.Points[0] * static_cast<double>(block));
  const int all = (content.Points[1] + block - 1) / block;
  return block * static_cast<int>(std::min<double>(std::max(1.0, std::floor(blocks)), all));
}

FileOutcome WriteGeoTiff(const std::string& path, const GeoTiffContent& content, const RasterProgress& progress)
{
  GDALAllRegister();
  const CPLConfigOptionSetter noSideFile("GDAL_PAM_ENABLED", "NO", false);
  const CPLConfigOptionSetter noCheck(
    "CHECK_DISK_FREE_SPACE", "NO", false); // GDAL looks where a descriptor's name lies
  GdalMessages messages;
  return WriteFile(path, [&](ReplacedFile& file) {
    RequireDisk(path, content);
    ReplacedFile scratch(path);
    if (!file.Close() || !scratch.Close())
    {
      return false;
    }
    try
    {
      MakeFile(file.Path(), scratch.Path(), content, progress, messages);
    }
    catch (const RasterError&)
    {
      file.NoteFullDisk();
      scratch.NoteFullDisk();
      if (!scratch.WhyFailed().empty())
      {
        throw RasterError(scratch.WhyFailed());
      }
      throw;
    }
    return file.Commit();
  });
}

}
