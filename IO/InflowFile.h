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

/// Files of an inflow that are read plane by plane.
class InflowFile
{
public:
  /// Opens the file of a path, of any of the formats, known by the extension. The order of planes is for files of HAWC2
  /// of which the text does not tell it. Throws InvalidInput.
  InflowFile(const std::string& path, HawcOrder order);

  const InflowGrid& GetGrid() const { return this->Planes->GetGrid(); }

  /// Reads the velocities of the planes of `count` times from the first on, plane by plane. Throws InvalidInput.
  void Read(int first, int count, float* velocities);

private:
  void OpenTurbSim(const std::string& path);
  void OpenHawc(const std::string& path, HawcOrder order);
  void OpenBladed(const std::string& path);

  std::unique_ptr<InflowPlanes> Planes;
  std::vector<std::ifstream> Files;
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

/// Planes and the files that they go to.
struct InflowTarget
{
  std::unique_ptr<InflowPlanes> Planes;
  std::vector<std::string> Paths; ///< as many as the planes have files
  std::string TextPath;           ///< of a text beside them; empty if there is none
  std::string Text;
};

/// Formats of files, by their extensions.
enum class InflowFormat
{
  TurbSim,
  Hawc,
  Bladed
};

/// The format of a path. Throws InvalidInput if the extension is none of .bts, .hawc and .wnd.
InflowFormat FormatOf(const std::string& path);

/// The files of a path for a wind. Throws InvalidInput if the format cannot hold it.
InflowTarget TargetOf(const std::string& path, const InflowGrid& grid, const InflowRange& range, HawcOrder order);

/// Writes planes from a source to their files, slab by slab, and replaces the files when all are whole.
FileOutcome WriteInflow(const InflowTarget& target, const InflowSource& source);

}

#endif
