// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RasterTiles.h"

#include <filesystem>
#include <memory>
#include <system_error>

#include <cpl_conv.h>
#include <cpl_minixml.h>
#include <gdal.h>

namespace littoral
{

namespace
{

struct DestroyNode
{
  void operator()(CPLXMLNode* node) const { CPLDestroyXMLNode(node); }
};

double NumberOf(const CPLXMLNode* node, const char* path, double otherwise)
{
  const char* text = CPLGetXMLValue(node, path, nullptr);
  return text ? CPLAtof(text) : otherwise;
}

/// Whether a tile shows pixels in a window; also where it does not say which.
bool IsSeen(const CPLXMLNode* tile, const PixelWindow& window)
{
  const double left = NumberOf(tile, "DstRect.xOff", window[0]);
  const double top = NumberOf(tile, "DstRect.yOff", window[2]);
  return left <= window[1] && left + NumberOf(tile, "DstRect.xSize", window[1] + 1.0) > window[0] && top <= window[3] &&
    top + NumberOf(tile, "DstRect.ySize", window[3] + 1.0) > window[2];
}

std::string PathOf(const CPLXMLNode* tile, const std::string& mosaic)
{
  const std::filesystem::path name = CPLGetXMLValue(tile, "SourceFilename", "");
  const bool isBeside = NumberOf(tile, "SourceFilename.relativeToVRT", 0.0) != 0.0;
  return isBeside ? (std::filesystem::path(mosaic).parent_path() / name).string() : name.string();
}

std::string WhyOtherTile(const CPLXMLNode* tile, const std::string& mosaic)
{
  const auto columns = static_cast<int>(NumberOf(tile, "SourceProperties.RasterXSize", 0.0));
  const auto rows = static_cast<int>(NumberOf(tile, "SourceProperties.RasterYSize", 0.0));
  const std::string path = PathOf(tile, mosaic);
  if (columns == 0 || rows == 0 || path.empty())
  {
    return {};
  }
  const GDALDatasetH opened = GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr);
  if (!opened)
  {
    return {};
  }
  const int ownColumns = GDALGetRasterXSize(opened);
  const int ownRows = GDALGetRasterYSize(opened);
  GDALClose(opened);
  const auto sizeOf = [](int width, int height) { return std::to_string(width) + " x " + std::to_string(height); };
  return ownColumns == columns && ownRows == rows
    ? std::string()
    : "build the mosaic anew: its tile " + std::filesystem::path(path).filename().string() + " has " +
      sizeOf(ownColumns, ownRows) + " pixels and not " + sizeOf(columns, rows);
}

/// The element of a band of a mosaic; null for none.
const CPLXMLNode* BandOf(CPLXMLNode* file, int band)
{
  const CPLXMLNode* root = file ? CPLGetXMLNode(file, "=VRTDataset") : nullptr;
  int number = 0;
  for (const CPLXMLNode* node = root ? root->psChild : nullptr; node; node = node->psNext)
  {
    number += std::string(node->pszValue) == "VRTRasterBand" ? 1 : 0;
    if (number == band)
    {
      return node;
    }
  }
  return nullptr;
}

}

std::string WhyOtherTiles(void* dataset, int band, const PixelWindow& window)
{
  const char* driver = GDALGetDriverShortName(GDALGetDatasetDriver(dataset));
  const std::string mosaic = GDALGetDescription(dataset);
  std::error_code error;
  if (!driver || std::string(driver) != "VRT" || !std::filesystem::exists(mosaic, error))
  {
    return {};
  }
  const std::unique_ptr<CPLXMLNode, DestroyNode> file(CPLParseXMLFile(mosaic.c_str()));
  const CPLXMLNode* tiles = BandOf(file.get(), band);
  std::string reason;
  for (const CPLXMLNode* tile = tiles ? tiles->psChild : nullptr; tile && reason.empty(); tile = tile->psNext)
  {
    const bool isTile = tile->eType == CXT_Element && CPLGetXMLNode(tile, "SourceFilename");
    reason = isTile && IsSeen(tile, window) ? WhyOtherTile(tile, mosaic) : std::string();
  }
  return reason;
}

}
