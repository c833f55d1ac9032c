// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PalmFile.h"

#include "NetcdfOutput.h"

#include <vector>

namespace littoral
{

namespace
{

constexpr float Missing = -9999.0f;
constexpr double BytesOfVariable = 4294967292.0; ///< at most, with places of 64 bits alone

/// Adds the coordinate of an axis; its number.
int AddAxis(NetcdfOutput& file, const char* name, int dimension, const char* axis, const char* words)
{
  const int variable = file.AddDoubles(name, { dimension });
  file.AddText(variable, "long_name", words);
  file.AddText(variable, "units", "m");
  file.AddText(variable, "axis", axis);
  return variable;
}

int AddDensity(NetcdfOutput& file, const char* name, const std::vector<int>& dimensions, const char* words)
{
  const int variable = file.AddFloats(name, dimensions);
  file.AddText(variable, "long_name", words);
  file.AddText(variable, "units", "m2 m-3");
  file.AddFloat(variable, "_FillValue", Missing);
  return variable;
}

void AddPlace(NetcdfOutput& file, const CanopyGrid& grid, const PalmPlace& place)
{
  file.AddText(NetcdfOutput::File, "Conventions", "CF-1.7");
  file.AddText(NetcdfOutput::File, "source", "Forest of Littoral");
  file.AddNumber(NetcdfOutput::File, "origin_x", grid.Origin.x);
  file.AddNumber(NetcdfOutput::File, "origin_y", grid.Origin.y);
  file.AddNumber(NetcdfOutput::File, "origin_z", grid.Origin.z);
  file.AddNumber(NetcdfOutput::File, "origin_lat", place.Latitude);
  file.AddNumber(NetcdfOutput::File, "origin_lon", place.Longitude);
  file.AddText(NetcdfOutput::File, "origin_time", place.Time);
  file.AddNumber(NetcdfOutput::File, "rotation_angle", 0.0);
}

/// Middles of cells from the lower end of an axis; `ground` puts the end itself in front.
std::vector<double> MiddlesOf(int count, double spacing, bool ground)
{
  std::vector<double> middles(ground ? 1 : 0, 0.0);
  for (int n = 0; n < count; ++n)
  {
    middles.push_back((n + 0.5) * spacing);
  }
  return middles;
}

void WriteLevels(NetcdfOutput& file, int variable, const CanopyGrid& grid, const LayerOfCells& layerOf)
{
  const auto rows = static_cast<std::size_t>(grid.Count[1]);
  const auto columns = static_cast<std::size_t>(grid.Count[0]);
  std::vector<float> layer(rows * columns, 0.0f);
  file.Write(variable, { 0, 0, 0 }, { 1, rows, columns }, layer.data());
  for (int k = 0; k < grid.Count[2]; ++k)
  {
    layerOf(k, layer.data());
    file.Write(variable, { static_cast<std::size_t>(k) + 1, 0, 0 }, { 1, rows, columns }, layer.data());
  }
}

}

FileOutcome WritePalm(const std::string& path, const CanopyGrid& grid, const PalmPlace& place,
  const LayerOfCells& leaves, const LayerOfCells& wood)
{
  return WriteFile(path, [&](ReplacedFile& target) {
    if (!target.Close())
    {
      return false;
    }
    const double bytes = 4.0 * grid.Count[0] * grid.Count[1] * (grid.Count[2] + 1.0);
    NetcdfOutput file(target.Path(), bytes > BytesOfVariable);
    const int levels = file.AddDimension("zlad", static_cast<std::size_t>(grid.Count[2]) + 1);
    const int rows = file.AddDimension("y", static_cast<std::size_t>(grid.Count[1]));
    const int columns = file.AddDimension("x", static_cast<std::size_t>(grid.Count[0]));
    const int z = AddAxis(file, "zlad", levels, "Z", "height above ground");
    const int y = AddAxis(file, "y", rows, "Y", "distance to origin in y-direction");
    const int x = AddAxis(file, "x", columns, "X", "distance to origin in x-direction");
    const int lad = AddDensity(file, "lad", { levels, rows, columns }, "leaf area density");
    const int bad = wood ? AddDensity(file, "bad", { levels, rows, columns }, "basal area density") : -1;
    AddPlace(file, grid, place);
    file.EndHeader();
    file.Write(z, 0, MiddlesOf(grid.Count[2], grid.Spacing.z, true));
    file.Write(y, 0, MiddlesOf(grid.Count[1], grid.Spacing.y, false));
    file.Write(x, 0, MiddlesOf(grid.Count[0], grid.Spacing.x, false));
    WriteLevels(file, lad, grid, leaves);
    if (wood)
    {
      WriteLevels(file, bad, grid, wood);
    }
    file.Close();
    return target.Commit();
  });
}

}
