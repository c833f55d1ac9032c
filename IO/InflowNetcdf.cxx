// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "InflowNetcdf.h"

#include "NetcdfFile.h"
#include "NetcdfOutput.h"
#include "Numerics/InvalidInput.h"
#include "Pipeline/Memory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace littoral
{

namespace
{

constexpr std::array<const char*, 3> Components{ "u", "v", "w" };
constexpr std::array<const char*, 3> StandardNames{ "x_wind", "y_wind", "upward_air_velocity" };
constexpr std::array<const char*, 3> Words{ "wind speed along", "wind speed across, to the left",
  "wind speed upwards" };
constexpr double Uneven = 0.01; ///< of a step, as float32 has the times of a long wind

/// Axes of a wind, the slowest first.
enum Axis
{
  Time,
  Up,
  Across
};
constexpr std::array<char, 3> Letters{ 'T', 'Z', 'Y' };
constexpr std::array<const char*, 3> AxisWords{ "time", "height", "across" };

/// The place of an axis in even steps.
struct EvenAxis
{
  double First = 0.0;
  double Step = 1.0;
  int Count = 1;
};

const NetcdfVariable FileItself;

bool IsOneOf(const std::string& word, std::initializer_list<const char*> words)
{
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// The first word of the units of a variable.
std::string UnitOf(const NetcdfFile& file, const NetcdfVariable& variable)
{
  const std::string text = file.TextOf(variable, "units");
  return text.substr(0, text.find(' '));
}

void RequireUnit(const NetcdfFile& file, const NetcdfVariable& axis, bool isTime)
{
  const std::string unit = UnitOf(file, axis);
  const bool isKnown = isTime ? IsOneOf(unit, { "", "s", "sec", "second", "seconds" })
                              : IsOneOf(unit, { "", "m", "metre", "metres", "meter", "meters" });
  if (!isKnown)
  {
    Refuse("its axis ", axis.Name, " is in ", unit, "; it must be in ", isTime ? "s" : "m");
  }
}

/// The axis that a dimension is, by the attribute of its variable or by its name.
Axis AxisOf(const NetcdfFile& file, const std::string& name)
{
  const NetcdfVariable* variable = file.Find(name);
  Require(variable ? "" : "its axis " + name + " has no places: there is no variable of that name");
  const std::string letter = file.TextOf(*variable, "axis");
  for (const Axis axis : { Time, Up, Across })
  {
    if (letter == std::string(1, Letters[axis]))
    {
      return axis;
    }
  }
  if (IsOneOf(name, { "time", "t" }))
  {
    return Time;
  }
  if (IsOneOf(name, { "z", "height", "z_tower" }))
  {
    return Up;
  }
  if (name == "y")
  {
    return Across;
  }
  Refuse("its axis ", name, " does not say what it is; its attribute axis must be T, Z or Y");
}

/// Reads an axis. Throws InvalidInput unless it rises in even steps.
EvenAxis ReadAxis(const NetcdfFile& file, const std::string& name, Axis axis)
{
  const NetcdfVariable& variable = *file.Find(name);
  Require(variable.Dimensions.size() == 1 ? "" : "its axis " + name + " is not a list of numbers");
  RequireUnit(file, variable, axis == Time);
  const std::vector<double> places = file.ReadAll(variable);
  Require(!places.empty() ? "" : "its axis " + name + " is empty");
  Require(places.size() <= std::numeric_limits<int>::max() ? "" : "its axis " + name + " is too long");
  EvenAxis even;
  even.Count = static_cast<int>(places.size());
  even.First = places.front();
  even.Step = even.Count > 1 ? (places.back() - places.front()) / (even.Count - 1.0)
                             : file.NumberOf(variable, "grid_spacing").value_or(1.0);
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    const double wanted = even.First + even.Step * static_cast<double>(n);
    if (!std::isfinite(places[n]))
    {
      Refuse("its axis ", name, " has no number at index ", n);
    }
    if (n > 0 && places[n] <= places[n - 1])
    {
      Refuse("its axis ", name, " must rise; at index ", n, " ", places[n], " follows on ", places[n - 1]);
    }
    if (std::abs(places[n] - wanted) > Uneven * std::abs(even.Step))
    {
      Refuse("its axis ", name, " must have even steps; at index ", n, " it is ", places[n], " in place of ", wanted);
    }
  }
  return even;
}

/// The variable of a component, by its name or its standard name.
const NetcdfVariable& ComponentOf(const NetcdfFile& file, int component)
{
  const NetcdfVariable* found = file.Find(Components[component]);
  for (const NetcdfVariable& variable : file.Variables())
  {
    found = found ? found : file.TextOf(variable, "standard_name") == StandardNames[component] ? &variable : nullptr;
  }
  if (!found)
  {
    Refuse("it has no variable ", Components[component], ", or one of the standard name ", StandardNames[component]);
  }
  const std::string unit = file.TextOf(*found, "units");
  if (!IsOneOf(unit, { "", "m/s", "m s-1", "m s^-1", "m.s-1" }))
  {
    Refuse("its variable ", found->Name, " is in ", unit, "; it must be in m/s");
  }
  return *found;
}

/// Throws InvalidInput unless a variable is over the axes, in their order.
void RequireAxes(const NetcdfFile& file, const NetcdfVariable& variable, const std::vector<Axis>& axes)
{
  std::string wanted, found;
  for (const Axis axis : axes)
  {
    wanted += (wanted.empty() ? "" : ", ") + std::string(AxisWords[axis]);
  }
  bool isSo = variable.Dimensions.size() == axes.size();
  for (std::size_t d = 0; d < variable.Dimensions.size(); ++d)
  {
    const std::string& name = file.Dimensions()[variable.Dimensions[d]].Name;
    found += (found.empty() ? "" : ", ") + name;
    const auto here = variable.Dimensions.begin() + static_cast<std::ptrdiff_t>(d);
    Require(std::count(variable.Dimensions.begin(), here, *here) == 0
        ? ""
        : "its variable " + variable.Name + " has the axis " + name + " more than once");
    isSo = isSo && AxisOf(file, name) == axes[d];
  }
  if (!isSo)
  {
    Refuse("its variable ", variable.Name, " has the axes ", found, "; they must be ", wanted, ", in this order");
  }
}

/// Whether a variable can be a component of a wind in planes: over three axes, of which the last is no longitude.
bool IsOverPlane(const NetcdfFile& file, const NetcdfVariable& variable)
{
  if (variable.Dimensions.size() != 3 || file.TextOf(variable, "standard_name").find("sea_water") != std::string::npos)
  {
    return false;
  }
  const NetcdfVariable* across = file.Find(file.Dimensions()[variable.Dimensions[2]].Name);
  return !across || UnitOf(file, *across).rfind("degree", 0) != 0;
}

class Records : public InflowRecords
{
public:
  explicit Records(const std::string& path)
    : File(path)
  {
    for (const int component : { 0, 1, 2 })
    {
      const NetcdfVariable& variable = ComponentOf(this->File, component);
      RequireAxes(this->File, variable, { Time, Up, Across });
      Require(component == 0 || variable.Dimensions == this->Grids[0]->Dimensions
          ? ""
          : "its variables " + this->Grids[0]->Name + " and " + variable.Name + " have other axes");
      this->Grids[component] = &variable;
    }
    this->ReadAxes();
    this->ReadTower();
    this->ReadAttributes();
    Require(WhyInvalid(this->Grid));
  }

  const InflowGrid& GetGrid() const override { return this->Grid; }

  void Read(int first, int count, float* velocities) const override
  {
    const auto times = static_cast<std::size_t>(count);
    const std::size_t points = this->Grid.PointsOfPlane();
    RequireMemory(sizeof(double) * static_cast<double>(points) * count, "a part of the wind", "take fewer points");
    std::vector<double> values(std::max(this->Grid.PointsOfGrid(), std::size_t(this->Grid.TowerPoints)) * times);
    const auto up = static_cast<std::size_t>(this->Grid.Count[2]);
    const auto across = static_cast<std::size_t>(this->Grid.Count[1]);
    const auto tower = static_cast<std::size_t>(this->Grid.TowerPoints);
    for (const int component : { 0, 1, 2 })
    {
      const auto start = static_cast<std::size_t>(first);
      this->File.Read(*this->Grids[component], { start, 0, 0 }, { times, up, across }, values.data());
      for (std::size_t n = 0; n < times * up * across; ++n)
      {
        const std::size_t time = n / (up * across);
        velocities[3 * (time * points + n % (up * across)) + component] =
          this->NumberOf(values[n], component, start + time);
      }
      if (tower > 0)
      {
        this->File.Read(*this->Towers[component], { start, 0 }, { times, tower }, values.data());
      }
      for (std::size_t n = 0; n < times * tower; ++n)
      {
        const std::size_t point = up * across + tower - 1 - n % tower; // downwards
        velocities[3 * (n / tower * points + point) + component] =
          this->NumberOf(values[n], component, start + n / tower);
      }
    }
    this->File.RequireUnchanged();
  }

private:
  float NumberOf(double value, int component, std::size_t time) const
  {
    const auto number = static_cast<float>(value);
    if (!std::isfinite(number))
    {
      Refuse("its ", this->Grids[component]->Name, " is missing, or no number, at time index ", time);
    }
    return number;
  }

  const std::string& NameOf(const NetcdfVariable& variable, int dimension) const
  {
    return this->File.Dimensions()[variable.Dimensions[dimension]].Name;
  }

  void ReadAxes()
  {
    std::array<EvenAxis, 3> axes;
    for (const Axis axis : { Time, Up, Across })
    {
      axes[axis] = ReadAxis(this->File, this->NameOf(*this->Grids[0], axis), axis);
      this->Grid.Count[axis == Time ? 0 : axis == Up ? 2 : 1] = axes[axis].Count;
    }
    Require(axes[Time].Count > 1 ? "" : "it has one time; a wind has two or more");
    this->Grid.TimeStep = axes[Time].Step;
    this->Grid.VerticalSpacing = axes[Up].Step;
    this->Grid.LateralSpacing = axes[Across].Step;
    this->Grid.BottomHeight = axes[Up].First;
  }

  void ReadTower()
  {
    for (const int component : { 0, 1, 2 })
    {
      this->Towers[component] = this->File.Find(this->Grids[component]->Name + "_tower");
    }
    const auto there = std::count(this->Towers.begin(), this->Towers.end(), nullptr);
    Require(there == 0 || there == 3 ? "" : "a component of its tower is missing");
    if (there == 3)
    {
      return;
    }
    for (const NetcdfVariable* variable : this->Towers)
    {
      RequireAxes(this->File, *variable, { Time, Up });
      Require(
        variable->Dimensions == this->Towers[0]->Dimensions && variable->Dimensions[0] == this->Grids[0]->Dimensions[0]
          ? ""
          : "the variables of its tower have other axes");
    }
    const EvenAxis heights = ReadAxis(this->File, this->NameOf(*this->Towers[0], 1), Up);
    const double step = this->Grid.VerticalSpacing;
    const double top = heights.First + (heights.Count - 1) * heights.Step;
    const bool isBelow = std::abs(this->Grid.BottomHeight - step - top) <= Uneven * step &&
      (heights.Count == 1 || std::abs(heights.Step - step) <= Uneven * step);
    Require(isBelow ? "" : "the points of its tower must lie below its grid, as far apart as its layers");
    this->Grid.TowerPoints = heights.Count;
  }

  void ReadAttributes()
  {
    const double middle = this->Grid.BottomHeight + 0.5 * (this->Grid.Count[2] - 1) * this->Grid.VerticalSpacing;
    this->Grid.HubHeight = this->File.NumberOf(FileItself, "hub_height").value_or(middle);
    this->Grid.IsPeriodic = this->File.NumberOf(FileItself, "periodic").value_or(0.0) != 0.0;
    this->Grid.Description = this->File.TextOf(FileItself, "title");
    const std::optional<double> speed = this->File.NumberOf(FileItself, "mean_wind_speed");
    this->Grid.Speed = speed ? *speed : this->MeanAtHub();
  }

  /// Mean of u over the times at the point of the grid that is nearest to the hub.
  double MeanAtHub() const
  {
    const double layer = (this->Grid.HubHeight - this->Grid.BottomHeight) / this->Grid.VerticalSpacing;
    const auto k = static_cast<std::size_t>(std::clamp(std::round(layer), 0.0, this->Grid.Count[2] - 1.0));
    const auto j = static_cast<std::size_t>(this->Grid.Count[1] / 2);
    std::vector<double> values(static_cast<std::size_t>(this->Grid.Count[0]));
    this->File.Read(*this->Grids[0], { 0, k, j }, { values.size(), 1, 1 }, values.data());
    double sum = 0.0;
    for (std::size_t time = 0; time < values.size(); ++time)
    {
      sum += this->NumberOf(values[time], 0, time);
    }
    return sum / static_cast<double>(values.size());
  }

  NetcdfFile File;
  std::array<const NetcdfVariable*, 3> Grids{};
  std::array<const NetcdfVariable*, 3> Towers{};
  InflowGrid Grid;
};

/// Numbers of variables of a file that is written.
struct Variables
{
  int Time = 0;
  std::array<int, 3> Grids{};
  std::array<int, 3> Towers{};
};

/// Adds an axis of a length, 0 for records; the numbers of its dimension and its variable.
std::array<int, 2> AddAxis(NetcdfOutput& file, const char* name, int length, Axis axis, const char* units)
{
  const int dimension = file.AddDimension(name, static_cast<std::size_t>(length));
  const int variable = file.AddDoubles(name, { dimension });
  file.AddText(variable, "units", units);
  file.AddText(variable, "axis", std::string(1, Letters[axis]));
  return { dimension, variable };
}

std::array<int, 3> AddComponents(NetcdfOutput& file, const std::string& suffix, const std::vector<int>& dimensions)
{
  std::array<int, 3> added{};
  for (const int component : { 0, 1, 2 })
  {
    added[component] = file.AddFloats((Components[component] + suffix).c_str(), dimensions);
    file.AddText(added[component], "standard_name", StandardNames[component]);
    file.AddText(added[component], "long_name", Words[component] + std::string(suffix.empty() ? "" : " at the tower"));
    file.AddText(added[component], "units", "m s-1");
  }
  return added;
}

std::vector<double> EvenPlaces(double first, double step, int count)
{
  std::vector<double> places;
  for (int n = 0; n < count; ++n)
  {
    places.push_back(first + n * step);
  }
  return places;
}

Variables WriteHeader(NetcdfOutput& file, const InflowGrid& grid)
{
  Variables variables;
  const auto [times, time] = AddAxis(file, "time", 0, Time, "seconds since 2000-01-01 00:00:00");
  const auto [up, z] = AddAxis(file, "z", grid.Count[2], Up, "m");
  const auto [across, y] = AddAxis(file, "y", grid.Count[1], Across, "m");
  file.AddText(time, "standard_name", "time");
  file.AddText(z, "standard_name", "height");
  file.AddText(z, "positive", "up");
  file.AddText(y, "long_name", "distance from the middle, to the left");
  file.AddNumber(z, "grid_spacing", grid.VerticalSpacing);
  file.AddNumber(y, "grid_spacing", grid.LateralSpacing);
  variables.Time = time;
  variables.Grids = AddComponents(file, "", { times, up, across });
  int below = 0;
  if (grid.TowerPoints > 0)
  {
    const auto [levels, heights] = AddAxis(file, "z_tower", grid.TowerPoints, Up, "m");
    file.AddText(heights, "positive", "up");
    variables.Towers = AddComponents(file, "_tower", { times, levels });
    below = heights;
  }
  file.AddText(NetcdfOutput::File, "Conventions", "CF-1.8");
  file.AddText(NetcdfOutput::File, "title", grid.Description);
  file.AddNumber(NetcdfOutput::File, "mean_wind_speed", grid.Speed);
  file.AddNumber(NetcdfOutput::File, "hub_height", grid.HubHeight);
  file.AddNumber(NetcdfOutput::File, "periodic", grid.IsPeriodic ? 1.0 : 0.0);
  file.EndHeader();
  file.Write(z, 0, EvenPlaces(grid.BottomHeight, grid.VerticalSpacing, grid.Count[2]));
  file.Write(y, 0, EvenPlaces(-0.5 * (grid.Count[1] - 1) * grid.LateralSpacing, grid.LateralSpacing, grid.Count[1]));
  if (grid.TowerPoints > 0)
  {
    file.Write(below, 0,
      EvenPlaces(grid.BottomHeight - grid.TowerPoints * grid.VerticalSpacing, grid.VerticalSpacing, grid.TowerPoints));
  }
  return variables;
}

/// Writes the plane of a time: a component after the other.
void WriteRecord(NetcdfOutput& file, const Variables& variables, const InflowGrid& grid, int time, const float* plane)
{
  const auto record = static_cast<std::size_t>(time);
  const std::size_t points = grid.PointsOfGrid();
  const auto tower = static_cast<std::size_t>(grid.TowerPoints);
  std::vector<float> values(std::max(points, tower));
  file.Write(variables.Time, record, std::vector<double>{ time * grid.TimeStep });
  for (const int component : { 0, 1, 2 })
  {
    for (std::size_t n = 0; n < points; ++n)
    {
      values[n] = plane[3 * n + component];
    }
    file.Write(variables.Grids[component], { record, 0, 0 },
      { 1, static_cast<std::size_t>(grid.Count[2]), static_cast<std::size_t>(grid.Count[1]) }, values.data());
    for (std::size_t n = 0; n < tower; ++n)
    {
      values[n] = plane[3 * (points + tower - 1 - n) + component]; // planes have them downwards
    }
    if (tower > 0)
    {
      file.Write(variables.Towers[component], { record, 0 }, { 1, tower }, values.data());
    }
  }
}

}

std::unique_ptr<InflowRecords> OpenInflowNetcdf(const std::string& path)
{
  return std::make_unique<Records>(path);
}

bool HoldsInflow(const NetcdfFile& file)
{
  bool holds = true;
  for (const int component : { 0, 1, 2 })
  {
    const NetcdfVariable* variable = nullptr;
    const std::string why = WhyRefused([&] { variable = &ComponentOf(file, component); });
    holds = holds && why.empty() && IsOverPlane(file, *variable);
  }
  return holds;
}

FileOutcome WriteInflowNetcdf(const std::string& path, const InflowGrid& grid, const InflowSource& source)
{
  return WriteFile(path, [&](ReplacedFile& target) {
    if (!target.Close())
    {
      return false;
    }
    NetcdfOutput file(target.Path(), false);
    const Variables variables = WriteHeader(file, grid);
    const std::size_t values = 3 * grid.PointsOfPlane();
    std::vector<float> velocities(values * TimesAtOnce(grid));
    const bool isWhole = ForSlabs(grid, false, [&](int first, int times) {
      const bool proceeds = source(first, times, velocities.data());
      for (int n = 0; proceeds && n < times; ++n)
      {
        WriteRecord(file, variables, grid, first + n, velocities.data() + values * n);
      }
      return proceeds;
    });
    if (!isWhole)
    {
      throw WriteStopped();
    }
    file.Close();
    return target.Commit();
  });
}

}
