// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Wind/HawcPlanes.h"

#include "Numerics/InvalidInput.h"
#include "Numerics/LittleEndian.h"
#include "Numerics/ParameterCheck.h"

#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>

namespace littoral
{

namespace
{

constexpr int Components = 3;
constexpr const char* Letters[Components] = { "u", "v", "w" };

/// A number from which the same one is read.
std::string Exact(double number)
{
  std::ostringstream text;
  text.precision(17);
  text << number;
  return text.str();
}

/// Words after a command, by the command.
using Commands = std::map<std::string, std::vector<std::string>>;

/// Commands of lines as `wsp 12 ; comment`, and of comments as `; littoral periodic`.
Commands CommandsOf(const std::string& bytes)
{
  Commands commands;
  std::istringstream lines(bytes);
  for (std::string line; std::getline(lines, line);)
  {
    const std::string own = "; littoral ";
    const bool isOwn = line.rfind(own, 0) == 0;
    std::istringstream words(isOwn ? line.substr(own.size()) : line.substr(0, line.find(';')));
    std::string command;
    words >> command;
    for (std::string word; words >> word;)
    {
      commands[command].push_back(word);
    }
  }
  return commands;
}

/// The words of a command that must be there.
const std::vector<std::string>& Need(const Commands& commands, const std::string& name, std::size_t words)
{
  const auto found = commands.find(name);
  if (found == commands.end())
  {
    Refuse("it has no line ", name);
  }
  if (found->second.size() != words)
  {
    Refuse(
      "its line ", name, " has ", found->second.size(), " words after it; it must have ", words, ", and be there once");
  }
  return found->second;
}

double NumberOf(const std::string& name, const std::string& word)
{
  char* end = nullptr;
  const double number = std::strtod(word.c_str(), &end);
  Require(
    *end == '\0' && IsSensible(number) ? "" : "its line " + name + " has '" + word.substr(0, 40) + "' for a number");
  return number;
}

int CountOf(const std::string& name, const std::string& word)
{
  const double number = NumberOf(name, word);
  Require(number == std::floor(number) && number >= 1.0 && number < 1e9
      ? ""
      : "its line " + name + " has '" + word.substr(0, 40) + "' for a number of points");
  return static_cast<int>(number);
}

}

std::string WriteHawcText(const HawcText& text)
{
  const InflowGrid& grid = text.Grid;
  const double middle = grid.BottomHeight + 0.5 * (grid.Count[2] - 1) * grid.VerticalSpacing;
  const double spacings[] = { grid.Speed * grid.TimeStep, grid.LateralSpacing, grid.VerticalSpacing };
  std::ostringstream lines;
  lines << "; " << grid.Description << ": for HAWC2's input file\n"
        << "; float32, little-endian; height fastest, upwards; then across, from left to right; then planes\n"
        << "; littoral first_plane " << (text.Order == HawcOrder::EarliestFirst ? "earliest" : "latest") << "\n"
        << "; littoral periodic " << (grid.IsPeriodic ? "yes" : "no") << "\n"
        << "; littoral hub_height " << Exact(grid.HubHeight) << "\n"
        << "begin wind ;\n"
        << "  wsp " << Exact(grid.Speed) << " ;\n"
        << "  center_pos0 0 0 " << Exact(-middle) << " ; middle of the box\n"
        << "  shear_format 1 " << Exact(grid.Speed) << " ; the box holds the shear\n"
        << "  turb_format 1 ;\n"
        << "  begin mann ;\n";
  for (int component = 0; component < Components; ++component)
  {
    lines << "    filename_" << Letters[component] << " " << text.Names[component] << " ;\n";
  }
  for (int axis = 0; axis < Components; ++axis)
  {
    lines << "    box_dim_" << Letters[axis] << " " << grid.Count[axis] << " " << Exact(spacings[axis]) << " ;\n";
  }
  lines << "    dont_scale 1 ;\n"
        << "  end mann ;\n"
        << "end wind ;\n";
  return lines.str();
}

HawcText ReadHawcText(const std::string& bytes)
{
  const Commands commands = CommandsOf(bytes);
  HawcText text;
  InflowGrid& grid = text.Grid;
  double spacings[Components];
  for (int n = 0; n < Components; ++n)
  {
    text.Names[n] = Need(commands, std::string("filename_") + Letters[n], 1)[0];
    const std::string name = std::string("box_dim_") + Letters[n];
    const std::vector<std::string>& box = Need(commands, name, 2);
    grid.Count[n] = CountOf(name, box[0]);
    spacings[n] = NumberOf(name, box[1]);
  }
  grid.Speed = NumberOf("wsp", Need(commands, "wsp", 1)[0]);
  grid.TimeStep = spacings[0] / grid.Speed;
  grid.LateralSpacing = spacings[1];
  grid.VerticalSpacing = spacings[2];
  const double middle = -NumberOf("center_pos0", Need(commands, "center_pos0", 3)[2]);
  grid.BottomHeight = middle - 0.5 * (grid.Count[2] - 1) * grid.VerticalSpacing;
  grid.HubHeight = commands.count("hub_height") ? NumberOf("hub_height", Need(commands, "hub_height", 1)[0]) : middle;
  grid.IsPeriodic = !commands.count("periodic") || Need(commands, "periodic", 1)[0] == "yes"; // Mann's boxes are
  text.SaysOrder = commands.count("first_plane") > 0;
  if (text.SaysOrder)
  {
    const std::string& order = Need(commands, "first_plane", 1)[0];
    Require(order == "earliest" || order == "latest" ? "" : "its first_plane is neither earliest nor latest");
    text.Order = order == "earliest" ? HawcOrder::EarliestFirst : HawcOrder::LatestFirst;
  }
  Require(WhyInvalid(grid));
  return text;
}

HawcPlanes::HawcPlanes(const InflowGrid& grid, HawcOrder order)
  : Order(order)
{
  this->Grid = grid;
  Require(grid.TowerPoints == 0 ? "" : "its format has no points of a tower; set TowerLayers to 0");
}

std::size_t HawcPlanes::BytesOfPlane() const
{
  return this->Grid.PointsOfGrid() * sizeof(float);
}

int HawcPlanes::TimeAt(int place) const
{
  return this->Order == HawcOrder::EarliestFirst ? place : this->Grid.Count[0] - 1 - place;
}

template <typename Use>
void HawcPlanes::ForPoints(const Use& use) const
{
  const auto across = static_cast<std::size_t>(this->Grid.Count[1]);
  const auto up = static_cast<std::size_t>(this->Grid.Count[2]);
  for (std::size_t j = 0; j < across; ++j)
  {
    for (std::size_t k = 0; k < up; ++k)
    {
      use(k * across + j, (across - 1 - j) * up + k); // y falls in the file
    }
  }
}

void HawcPlanes::Decode(const char* const* bytes, float* velocities) const
{
  const auto mean = static_cast<float>(this->Grid.Speed);
  this->ForPoints([&](std::size_t point, std::size_t place) {
    for (int component = 0; component < Components; ++component)
    {
      const auto part = TakeLittleEndian<float>(bytes[component] + sizeof(float) * place);
      velocities[Components * point + component] = component == 0 ? part + mean : part;
    }
  });
}

void HawcPlanes::Encode(const float* velocities, char* const* bytes) const
{
  const auto mean = static_cast<float>(this->Grid.Speed);
  this->ForPoints([&](std::size_t point, std::size_t place) {
    for (int component = 0; component < Components; ++component)
    {
      const float velocity = velocities[Components * point + component];
      PutLittleEndian(component == 0 ? velocity - mean : velocity, bytes[component] + sizeof(float) * place);
    }
  });
}

}
