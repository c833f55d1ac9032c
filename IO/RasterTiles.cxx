// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RasterTiles.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <system_error>
#include <vector>

#include <cpl_conv.h>
#include <cpl_minixml.h>
#include <cpl_string.h>
#include <gdal.h>

namespace littoral
{

namespace
{

using Path = std::filesystem::path;

struct DestroyNode
{
  void operator()(CPLXMLNode* node) const { CPLDestroyXMLNode(node); }
};

struct CloseDataset
{
  void operator()(void* dataset) const { GDALClose(dataset); }
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

/// Pixels of a tile that the mosaic shows.
PixelWindow ShownOf(const CPLXMLNode* tile, int columns, int rows)
{
  const double left = NumberOf(tile, "SrcRect.xOff", 0.0);
  const double top = NumberOf(tile, "SrcRect.yOff", 0.0);
  const auto last = [](double end) { return static_cast<int>(std::ceil(end)) - 1; };
  return { static_cast<int>(left), last(left + NumberOf(tile, "SrcRect.xSize", columns)), static_cast<int>(top),
    last(top + NumberOf(tile, "SrcRect.ySize", rows)) };
}

Path PathOf(const CPLXMLNode* tile, const Path& mosaic)
{
  const Path name = CPLGetXMLValue(tile, "SourceFilename", "");
  const bool isBeside = NumberOf(tile, "SourceFilename.relativeToVRT", 0.0) != 0.0;
  return isBeside ? mosaic.parent_path() / name : name;
}

/// Opens a tile with the options that the mosaic has for it, as for one of its overviews.
std::unique_ptr<void, CloseDataset> Open(const CPLXMLNode* tile, const Path& path)
{
  CPLStringList options;
  const CPLXMLNode* given = CPLGetXMLNode(tile, "OpenOptions");
  for (const CPLXMLNode* node = given ? given->psChild : nullptr; node; node = node->psNext)
  {
    options.SetNameValue(CPLGetXMLValue(node, "key", ""), CPLGetXMLValue(node, "", ""));
  }
  return std::unique_ptr<void, CloseDataset>(
    GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, options.List(), nullptr));
}

std::string WhyOtherTilesIn(void* dataset, int band, const PixelWindow& window, std::vector<Path> outer);

/// Why a tile of the last of mosaics in mosaics is not what it says.
std::string WhyOtherTile(const CPLXMLNode* tile, const std::vector<Path>& mosaics)
{
  const auto columns = static_cast<int>(NumberOf(tile, "SourceProperties.RasterXSize", 0.0));
  const auto rows = static_cast<int>(NumberOf(tile, "SourceProperties.RasterYSize", 0.0));
  const Path path = PathOf(tile, mosaics.back());
  const std::unique_ptr<void, CloseDataset> opened =
    columns == 0 || rows == 0 || path.empty() ? nullptr : Open(tile, path);
  if (!opened)
  {
    return {};
  }
  const int ownColumns = GDALGetRasterXSize(opened.get());
  const int ownRows = GDALGetRasterYSize(opened.get());
  const auto sizeOf = [](int width, int height) { return std::to_string(width) + " x " + std::to_string(height); };
  return ownColumns == columns && ownRows == rows
    ? WhyOtherTilesIn(
        opened.get(), static_cast<int>(NumberOf(tile, "SourceBand", 1.0)), ShownOf(tile, columns, rows), mosaics)
    : "build the mosaic anew: its tile " + path.filename().string() + " has " + sizeOf(ownColumns, ownRows) +
      " pixels and not " + sizeOf(columns, rows);
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

std::string WhyOtherTilesIn(void* dataset, int band, const PixelWindow& window, std::vector<Path> outer)
{
  const char* driver = GDALGetDriverShortName(GDALGetDatasetDriver(dataset));
  std::error_code error;
  const Path mosaic = std::filesystem::canonical(GDALGetDescription(dataset), error); // GDAL goes on from there, too
  const bool isInItself = std::find(outer.begin(), outer.end(), mosaic) != outer.end();
  if (!driver || std::string(driver) != "VRT" || error || isInItself)
  {
    return {};
  }
  outer.push_back(mosaic);
  const std::unique_ptr<CPLXMLNode, DestroyNode> file(CPLParseXMLFile(mosaic.c_str()));
  const CPLXMLNode* tiles = BandOf(file.get(), band);
  std::string reason;
  for (const CPLXMLNode* tile = tiles ? tiles->psChild : nullptr; tile && reason.empty(); tile = tile->psNext)
  {
    const bool isTile = tile->eType == CXT_Element && CPLGetXMLNode(tile, "SourceFilename");
    reason = isTile && IsSeen(tile, window) ? WhyOtherTile(tile, outer) : std::string();
  }
  return reason;
}

}

std::string WhyOtherTiles(void* dataset, int band, const PixelWindow& window)
{
  return WhyOtherTilesIn(dataset, band, window, {});
}

}
