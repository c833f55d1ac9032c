// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralInflowFile_h
#define LittoralInflowFile_h

#include "ReplacedFile.h"
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
  /// Opens the file of a path, of any of the formats. Throws InvalidInput.
  explicit InflowFile(const std::string& path);

  const InflowGrid& GetGrid() const { return this->Planes->GetGrid(); }

  /// Reads the velocities of the planes of `count` times from the first on, plane by plane. Throws InvalidInput.
  void Read(int first, int count, float* velocities);

private:
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

/// Writes planes from a source to their files, slab by slab, and replaces the files when all are whole.
FileOutcome WriteInflow(const InflowPlanes& planes, const std::vector<std::string>& paths, const InflowSource& source);

}

#endif
