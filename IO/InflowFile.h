// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralInflowFile_h
#define LittoralInflowFile_h

#include "ReplacedFile.h"
#include "Wind/HawcPlanes.h"
#include "Wind/InflowPlanes.h"

#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace littoral
{

class InflowRecords;

/// Files of an inflow that are read plane by plane.
class InflowFile
{
public:
  /// Opens the file of a path, of any of the formats, known by the extension. The order of planes is for files of HAWC2
  /// of which the text does not tell it. Throws InvalidInput.
  InflowFile(const std::string& path, HawcOrder order);
  ~InflowFile();

  const InflowGrid& GetGrid() const;

  /// Reads the velocities of the planes of `count` times from the first on, plane by plane. Throws InvalidInput.
  void Read(int first, int count, float* velocities);

private:
  void OpenTurbSim(const std::string& path);
  void OpenHawc(const std::string& path, HawcOrder order);
  void OpenBladed(const std::string& path);

  std::unique_ptr<InflowPlanes> Planes;
  std::vector<std::ifstream> Files;
  std::unique_ptr<InflowRecords> Records; ///< in place of planes and files, where a library reads
};

/// The bytes before which a plane of a time lies in a file.
double PlaceOf(const InflowPlanes& planes, int time);

/// Velocities of the planes of `count` times from the first on; false ends the writing, as the user wants it.
using InflowSource = std::function<bool(int first, int count, float* velocities)>;

/// Times that are asked of a source at once, which take about 32 MiB.
int TimesAtOnce(const InflowGrid& grid);

/// Calls use(first, count) for all times of a grid, as many as are asked for at once; the last ones first if told so.
/// False as soon as it returns false.
bool ForSlabs(const InflowGrid& grid, bool isBackwards, const std::function<bool(int first, int count)>& use);

/// Formats of files, by their extensions.
enum class InflowFormat
{
  TurbSim,
  Hawc,
  Bladed,
  Netcdf
};

/// The format of a path. Throws InvalidInput if the extension is none of .bts, .hawc, .wnd and .nc.
InflowFormat FormatOf(const std::string& path);

/// Writes a wind from a source to the files of a path, slab by slab, and replaces the files when all are whole. Throws
/// InvalidInput if the format cannot hold it.
FileOutcome WriteInflow(const std::string& path, const InflowGrid& grid, const InflowRange& range, HawcOrder order,
  const InflowSource& source);

}

#endif
