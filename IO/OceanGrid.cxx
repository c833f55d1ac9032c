// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OceanGrid.h"

#include "Data/Arrays.h"
#include "Numerics/Constants.h"
#include "Numerics/InvalidInput.h"
#include "Numerics/ParameterCheck.h"
#include "OceanProjection.h"
#include "Pipeline/Memory.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace littoral
{

namespace
{

constexpr double FarthestFromOrigin = 90.0; ///< [degrees]
constexpr double LeastThickness = 0.01;     ///< of water, in columns that fall dry [m]
constexpr double BytesOfColumn = 250.0;     ///< while a grid is made
constexpr double SecondsPerDay = 86400.0;

/// So many indices from a first one on.
struct Run
{
  std::size_t First = 0;
  std::size_t Count = 1;
};

/// Values of a variable at a time and a level, by y and x.
std::vector<double> ReadPlane(
  const NetcdfFile& file, const OceanVariable& variable, std::size_t time, std::size_t level, Run y, Run x)
{
  const OceanAxes& axes = variable.Axes;
  std::vector<std::size_t> start(variable.Variable->Dimensions.size(), 0);
  std::vector<std::size_t> count(start.size(), 1);
  const auto set = [&](int place, Run run) {
    if (place >= 0)
    {
      start[static_cast<std::size_t>(place)] = run.First;
      count[static_cast<std::size_t>(place)] = run.Count;
    }
  };
  set(axes.T, { time, 1 });
  set(axes.Z, { level, 1 });
  set(axes.Y, y);
  set(axes.X, x);
  const std::size_t rows = axes.Y >= 0 ? y.Count : 1;
  std::vector<double> values;
  SetSize(values, static_cast<vtkIdType>(rows * x.Count));
  file.Read(*variable.Variable, start, count, values.data());
  if (axes.Y > axes.X) // x is slower
  {
    std::vector<double> turned(values.size());
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      turned[n % rows * x.Count + n / rows] = values[n];
    }
    values.swap(turned);
  }
  return values;
}

/// The same for indices along x that begin again after a length.
std::vector<double> ReadAround(const NetcdfFile& file, const OceanVariable& variable, std::size_t time,
  std::size_t level, Run y, Run x, std::size_t length)
{
  x.First %= std::max<std::size_t>(length, 1);
  if (x.First + x.Count <= length)
  {
    return ReadPlane(file, variable, time, level, y, x);
  }
  const Run before{ x.First, length - x.First };
  const Run after{ 0, x.Count - before.Count };
  const std::vector<double> left = ReadPlane(file, variable, time, level, y, before);
  const std::vector<double> right = ReadPlane(file, variable, time, level, y, after);
  std::vector<double> values;
  for (std::size_t row = 0; row < y.Count; ++row)
  {
    values.insert(values.end(), left.begin() + row * before.Count, left.begin() + (row + 1) * before.Count);
    values.insert(values.end(), right.begin() + row * after.Count, right.begin() + (row + 1) * after.Count);
  }
  return values;
}

void RequireNoGaps(const std::vector<double>& values, const std::string& name)
{
  for (std::size_t n = 0; n < values.size(); ++n)
  {
    if (!IsSensible(values[n]))
    {
      Refuse("its ", name, " has a gap: number ", n + 1, " is missing or no sensible number");
    }
  }
}

/// Throws unless the coordinates of an axis rise all along or fall all along.
void RequireOrder(const std::vector<double>& values, const std::string& name)
{
  for (std::size_t n = 1; n < values.size(); ++n)
  {
    const double step = values[n] - values[n - 1];
    if (step == 0.0)
    {
      Refuse("its axis ", name, " repeats ", TextOf(values[n]), ", as number ", n + 1);
    }
    if (n > 1 && (step > 0.0) != (values[1] > values[0]))
    {
      Refuse("its axis ", name, " turns back at number ", n + 1, ", ", TextOf(values[n]));
    }
  }
}

/// Makes a grid step by step.
class Maker
{
public:
  Maker(const NetcdfFile& file, const OceanRoles& roles, const OceanPlacing& placing)
    : File(file)
    , Roles(roles)
    , Placing(placing)
  {
    this->Grid.IsMesh = roles.Kind == OceanGridKind::Nodes || roles.Kind == OceanGridKind::Faces;
    if (roles.PlaceKind == OceanPlaceKind::Projected)
    {
      this->Projection.emplace(roles.Map);
    }
  }

  OceanGrid Make()
  {
    this->MakeTimes();
    this->Grid.IsMesh ? this->MakeNodes() : this->MakeColumns();
    this->MakeMap();
    this->Grid.IsMesh ? this->MakeFaces() : this->MakeDirections();
    this->MakeLevels();
    this->MakeDepth();
    return std::move(this->Grid);
  }

private:
  std::size_t LengthOf(const OceanVariable& variable, int place) const
  {
    return place < 0 ? 1 : this->File.LengthOf(*variable.Variable, static_cast<std::size_t>(place));
  }

  static std::string NumberAndName(std::size_t n, const std::string& name)
  {
    return "number " + std::to_string(n + 1) + " of its times " + name;
  }

  void MakeTimes()
  {
    const OceanVariable& u = this->Roles.Velocity[0];
    this->Grid.Times.clear();
    const NetcdfVariable* variable = this->Roles.Time;
    if (!variable)
    {
      return;
    }
    const std::size_t count = this->LengthOf(u, u.Axes.T);
    Require(count > 0 ? "" : "it holds no times");
    Require(variable->Dimensions.size() == 1 && this->File.SizeOf(*variable) == count
        ? ""
        : "its times " + variable->Name + " are not as many as those of its " + u.Variable->Name);
    std::vector<double> values = this->File.ReadAll(*variable);
    const Calendar calendar = CalendarOf(this->File.TextOf(*variable, "calendar"));
    TimeUnit unit = TimeUnitOf(calendar, this->File.TextOf(*variable, "units"));
    if (this->Roles.TimeOfDay)
    {
      const std::vector<double> clock = this->File.ReadAll(*this->Roles.TimeOfDay);
      Require(clock.size() == count ? "" : "its times Itime and Itime2 are not as many");
      for (std::size_t n = 0; n < count; ++n)
      {
        values[n] += clock[n] / (1000.0 * SecondsPerDay); // whole days and milliseconds, summed in seconds below
      }
    }
    const bool isDivided = this->Roles.TimeOfDay != nullptr;
    for (std::size_t n = 0; n < count; ++n)
    {
      Require(IsSensible(values[n]) ? "" : NumberAndName(n, variable->Name) + " is missing or no sensible number");
      Require(n == 0 || values[n] > values[n - 1]
          ? ""
          : NumberAndName(n, variable->Name) + " is not after the one before it");
      // of the difference, so that seconds keep their digits
      const double since = (values[n] - values[0]) * unit.Seconds;
      this->Grid.Times.push_back(isDivided ? std::round(since * 1000.0) / 1000.0 : since);
    }
    this->MakeDates(calendar, unit, values[0]);
  }

  void MakeDates(Calendar calendar, const TimeUnit& unit, double first)
  {
    const bool isWished = !this->Placing.StartDate.empty();
    if (!unit.HasDate)
    {
      Require(isWished ? "StartDate cannot be met, as its times have no date" : "");
      return;
    }
    const double days = first * unit.Seconds / SecondsPerDay;
    CalendarTime time = unit.Since;
    time.Day += static_cast<long long>(std::floor(days));
    time = Later(time, first * unit.Seconds - std::floor(days) * SecondsPerDay);
    this->Grid.FirstDate = TextOfTime(calendar, time);
    if (isWished)
    {
      const double shift = SecondsBetween(ReadTime(calendar, this->Placing.StartDate), time);
      for (double& one : this->Grid.Times)
      {
        one += shift;
      }
    }
  }

  void MakeNodes()
  {
    const NetcdfVariable& x = *this->Roles.PlaceX;
    const NetcdfVariable& y = *this->Roles.PlaceY;
    this->Grid.LengthX = this->File.SizeOf(x);
    this->Grid.Count[0] = static_cast<int>(this->Grid.LengthX);
    Require(this->Placing.Region ? "Region is for grids of rows; a mesh is read as a whole" : "");
    RequireMemory(2.0 * BytesOfColumn * static_cast<double>(this->Grid.LengthX), "its mesh", "take a smaller file");
    this->Raw[0] = this->File.ReadAll(x);
    this->Raw[1] = this->File.ReadAll(y);
    RequireNoGaps(this->Raw[0], x.Name);
    RequireNoGaps(this->Raw[1], y.Name);
  }

  /// The coordinates of all columns in the part that is read.
  void MakeColumns()
  {
    const NetcdfVariable& x = *this->Roles.PlaceX;
    const NetcdfVariable& y = *this->Roles.PlaceY;
    const OceanVariable& u = this->Roles.Velocity[0];
    const OceanVariable& v = this->Roles.Velocity[1];
    const bool isStaggered = this->Roles.Kind == OceanGridKind::Staggered;
    const std::size_t width = this->LengthOf(isStaggered ? v : u, isStaggered ? v.Axes.X : u.Axes.X);
    const std::size_t height = this->LengthOf(u, u.Axes.Y);
    const bool isPlane = x.Dimensions.size() == 2;
    RequireMemory((isPlane ? 16.0 : 0.0) * static_cast<double>(width) * static_cast<double>(height), "its places",
      "take a smaller file");
    std::vector<double> xs = this->File.ReadAll(x);
    std::vector<double> ys = this->File.ReadAll(y);
    RequireNoGaps(xs, x.Name);
    RequireNoGaps(ys, y.Name);
    const bool isOnEarth = !this->Projection && this->Roles.PlaceKind != OceanPlaceKind::Metres;
    if (!isPlane)
    {
      Require(xs.size() == width && ys.size() == height
          ? ""
          : "its axes " + x.Name + " and " + y.Name + " have not the lengths of its " + u.Variable->Name);
      if (isOnEarth)
      {
        Unwrap(xs);
      }
      RequireOrder(xs, x.Name);
      RequireOrder(ys, y.Name);
    }
    this->Grid.LengthX = width;
    // the outermost centres of a C grid have no velocities on one side
    Run runX{ isStaggered ? 1U : 0U, width - (isStaggered ? 2 : 0) };
    Run runY{ isStaggered ? 1U : 0U, height - (isStaggered ? 2 : 0) };
    Require(width >= (isStaggered ? 4U : 2U) && height >= (isStaggered ? 4U : 2U)
        ? ""
        : "its grid has fewer than two points along an axis");
    if (this->Placing.Region)
    {
      this->TakeRegion(xs, ys, isPlane, runX, runY);
    }
    this->Grid.FirstX = runX.First;
    this->Grid.FirstY = runY.First;
    this->Grid.Count = { static_cast<int>(runX.Count), static_cast<int>(runY.Count), 1 };
    const double columns = static_cast<double>(runX.Count) * static_cast<double>(runY.Count);
    RequireMemory(BytesOfColumn * columns, "its grid", "give a smaller Region");
    for (std::size_t j = runY.First; j < runY.First + runY.Count; ++j)
    {
      for (std::size_t i = runX.First; i < runX.First + runX.Count; ++i)
      {
        const std::size_t at = i % width;
        this->Raw[0].push_back(xs[isPlane ? j * width + at : at]);
        this->Raw[1].push_back(ys[isPlane ? j * width + at : j]);
      }
    }
  }

  static bool IsLongitudeWithin(double longitude, double west, double east)
  {
    const double beyond = std::fmod(std::fmod(longitude - west, 360.0) + 360.0, 360.0);
    return beyond <= east - west;
  }

  /// Takes the rows and columns that hold all points of the region.
  void TakeRegion(const std::vector<double>& xs, const std::vector<double>& ys, bool isPlane, Run& runX, Run& runY)
  {
    const auto [west, east, south, north] = *this->Placing.Region;
    Require(
      this->Roles.PlaceKind == OceanPlaceKind::Metres ? "Region is in degrees, and its coordinates are lengths" : "");
    const std::size_t width = this->Grid.LengthX;
    std::vector<char> hasX(width, 0), hasY(runY.First + runY.Count, 0);
    for (std::size_t j = runY.First; j < runY.First + runY.Count; ++j)
    {
      for (std::size_t i = runX.First; i < runX.First + runX.Count; ++i)
      {
        const EarthPlace place = this->EarthOf({ xs[isPlane ? j * width + i : i], ys[isPlane ? j * width + i : j] });
        if (place[1] >= south && place[1] <= north && IsLongitudeWithin(place[0], west, east))
        {
          hasX[i] = 1;
          hasY[j] = 1;
        }
      }
    }
    const auto lastY = std::find(hasY.rbegin(), hasY.rend(), 1);
    Require(lastY == hasY.rend() ? "it has no points in the Region; give another Region" : "");
    const std::size_t firstRow = std::find(hasY.begin(), hasY.end(), 1) - hasY.begin();
    runY = { firstRow, static_cast<std::size_t>(hasY.rend() - lastY) - firstRow };
    // around the earth the columns of the region may be the last and the first ones
    const bool isAround = !isPlane && this->Roles.PlaceKind == OceanPlaceKind::Degrees &&
      std::abs(std::abs(xs.back() - xs.front()) + std::abs(xs[1] - xs[0]) - 360.0) < 0.01 * std::abs(xs[1] - xs[0]);
    const bool isSplit =
      isAround && hasX.front() && hasX.back() && std::find(hasX.begin(), hasX.end(), 0) != hasX.end();
    const std::size_t first = std::find(hasX.begin(), hasX.end(), 1) - hasX.begin();
    const std::size_t last = hasX.rend() - std::find(hasX.rbegin(), hasX.rend(), 1);
    runX = { first, last - first };
    if (isSplit)
    {
      const std::size_t tail = hasX.rend() - std::find(hasX.rbegin(), hasX.rend(), 0);
      const std::size_t head = std::find(hasX.begin(), hasX.end(), 0) - hasX.begin();
      runX = { tail, width - tail + head };
    }
    Require(runX.Count >= 2 && runY.Count >= 2 ? "" : "it has fewer than two rows in the Region; give a larger Region");
  }

  /// The place on earth of coordinates of the file.
  EarthPlace EarthOf(const std::array<double, 2>& place) const
  {
    if (this->Projection)
    {
      return this->Projection->ToEarth(
        { this->Roles.MetresPerPlace * place[0], this->Roles.MetresPerPlace * place[1] });
    }
    const EarthPlace onEarth{ place[0], place[1] };
    return this->Roles.PlaceKind == OceanPlaceKind::RotatedDegrees ? this->Roles.Pole.ToEarth(onEarth) : onEarth;
  }

  /// Whether the axes of velocities are those along which the coordinates grow, not the rows.
  bool AreAxesOfCoordinates() const
  {
    return this->Projection || this->Roles.PlaceKind == OceanPlaceKind::RotatedDegrees;
  }

  void MakeMap()
  {
    const std::size_t count = this->Raw[0].size();
    if (this->Roles.PlaceKind == OceanPlaceKind::Metres)
    {
      for (std::size_t n = 0; n < count; ++n)
      {
        this->Grid.Places.push_back(
          { this->Roles.MetresPerPlace * this->Raw[0][n], this->Roles.MetresPerPlace * this->Raw[1][n] });
      }
      this->Grid.Axes.resize(count);
      return;
    }
    for (std::size_t n = 0; n < count; ++n)
    {
      const std::array<double, 2> place{ this->Raw[0][n], this->Raw[1][n] };
      Require(this->Projection || (std::abs(place[1]) <= 90.0 + 1e-6 && std::abs(place[0]) <= 1000.0)
          ? ""
          : "its point " + TextOf(place[0]) + ", " + TextOf(place[1]) + " is not on earth");
      this->Earth.push_back(this->EarthOf(place));
    }
    const EarthPlace origin = this->Placing.Origin ? *this->Placing.Origin : MiddleOf(this->Earth);
    for (const EarthPlace& place : this->Earth)
    {
      if (!(AngleBetween(place, origin) <= FarthestFromOrigin))
      {
        Refuse("its grid reaches ", TextOf(std::round(AngleBetween(place, origin))),
          " degrees far from the origin of its map, which is too far; give a Region");
      }
    }
    const OceanMap map(origin);
    this->Grid.Origin = origin;
    this->Grid.System = map.System();
    this->Grid.Places = map.Places(this->Earth);
    this->Grid.Axes = map.Axes(this->Earth);
  }

  std::size_t ColumnOf(int i, int j) const { return static_cast<std::size_t>(j) * this->Grid.Count[0] + i; }

  /// Turns rows round for a right-handed grid, and turns the axes of velocities to those of the file's grid.
  void MakeDirections()
  {
    OceanGrid& grid = this->Grid;
    const int width = grid.Count[0], height = grid.Count[1];
    double area = 0.0;
    for (int j = 0; j + 1 < height; ++j)
    {
      for (int i = 0; i + 1 < width; ++i)
      {
        const auto& a = grid.Places[this->ColumnOf(i, j)];
        const auto& b = grid.Places[this->ColumnOf(i + 1, j)];
        const auto& c = grid.Places[this->ColumnOf(i, j + 1)];
        area += (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
      }
    }
    grid.TurnsY = area < 0.0;
    if (this->Roles.IsAlongAxes)
    {
      this->TurnAxes(area < 0.0 && !this->AreAxesOfCoordinates() ? -1.0 : 1.0);
    }
    if (grid.TurnsY)
    {
      for (int j = 0; j < height / 2; ++j)
      {
        for (int i = 0; i < width; ++i)
        {
          std::swap(grid.Places[this->ColumnOf(i, j)], grid.Places[this->ColumnOf(i, height - 1 - j)]);
          std::swap(grid.Axes[this->ColumnOf(i, j)], grid.Axes[this->ColumnOf(i, height - 1 - j)]);
        }
      }
    }
  }

  void TurnAxes(double hand)
  {
    OceanGrid& grid = this->Grid;
    const std::vector<double> angles = this->Roles.Angle
      ? ReadAround(this->File, this->Roles.Angle, 0, 0, { grid.FirstY, static_cast<std::size_t>(grid.Count[1]) },
          { grid.FirstX, static_cast<std::size_t>(grid.Count[0]) }, grid.LengthX)
      : std::vector<double>();
    std::vector<MapAxes> turned(grid.Axes.size());
    for (int j = 0; j < grid.Count[1]; ++j)
    {
      for (int i = 0; i < grid.Count[0]; ++i)
      {
        const std::size_t n = this->ColumnOf(i, j);
        const MapAxes& axes = grid.Axes[n];
        double angle = angles.empty() ? this->AngleAt(i, j) : this->Roles.Angle.Unit * angles[n];
        angle = std::isfinite(angle) ? angle : 0.0; // on land
        const double cosine = std::cos(angle), sine = std::sin(angle);
        for (int c = 0; c < 2; ++c)
        {
          // the grid's x axis is turned from east by the angle, its y axis lies across it
          turned[n].East[c] = cosine * axes.East[c] + sine * axes.North[c];
          turned[n].North[c] = hand * (cosine * axes.North[c] - sine * axes.East[c]);
        }
      }
    }
    grid.Axes = turned;
  }

  /// Angle of the grid's x axis from east at a point, by its neighbours or by a small step on a rotated grid.
  double AngleAt(int i, int j) const
  {
    const OceanGrid& grid = this->Grid;
    const std::size_t n = this->ColumnOf(i, j);
    if (this->AreAxesOfCoordinates())
    {
      const double step = this->Projection ? 10.0 / this->Roles.MetresPerPlace : 1e-4; // 10 m or degrees
      const EarthPlace from = this->EarthOf({ this->Raw[0][n] - step, this->Raw[1][n] });
      const EarthPlace to = this->EarthOf({ this->Raw[0][n] + step, this->Raw[1][n] });
      const double latitude = 0.5 * (from[1] + to[1]) * Pi / 180.0;
      return std::atan2(to[1] - from[1], std::cos(latitude) * std::remainder(to[0] - from[0], 360.0));
    }
    if (this->Roles.PlaceX->Dimensions.size() == 1)
    {
      return grid.Count[0] > 1 && this->Raw[0][1] < this->Raw[0][0] ? Pi : 0.0;
    }
    const std::array<double, 2> along = this->AlongRow(i, j);
    // of the map, less that of east there; the map keeps angles
    const std::array<double, 2>& east = grid.Axes[n].East;
    return std::atan2(along[1], along[0]) - std::atan2(east[1], east[0]);
  }

  /// Direction of a row at a point, by differences of second order.
  std::array<double, 2> AlongRow(int i, int j) const
  {
    const int last = this->Grid.Count[0] - 1;
    const auto at = [&](int n, int c) { return this->Grid.Places[this->ColumnOf(n, j)][c]; };
    std::array<double, 2> along{ at(last, 0) - at(0, 0), at(last, 1) - at(0, 1) };
    const int inward = i == 0 ? 1 : i == last ? -1 : 0;
    for (int c = 0; last > 1 && c < 2; ++c)
    {
      along[c] = inward == 0 ? at(i + 1, c) - at(i - 1, c)
                             : inward * (4.0 * at(i + inward, c) - 3.0 * at(i, c) - at(i + 2 * inward, c));
    }
    return along;
  }

  void MakeFaces()
  {
    OceanGrid& grid = this->Grid;
    const NetcdfVariable& table = *this->Roles.FaceNodes;
    const std::size_t first = this->File.LengthOf(table, 0), second = this->File.LengthOf(table, 1);
    const std::size_t faces = this->Roles.AreNodesFirst ? second : first;
    const std::size_t corners = this->Roles.AreNodesFirst ? first : second;
    Require(corners == 3 || corners == 4 ? "" : "its mesh has faces of other than three or four nodes");
    RequireMemory(2.0 * BytesOfColumn * static_cast<double>(faces), "its mesh", "take a smaller file");
    const std::vector<double> numbers = this->File.ReadAll(table);
    for (std::size_t f = 0; f < faces; ++f)
    {
      FaceCorners face{ -1, -1, -1, -1 };
      for (std::size_t c = 0; c < corners; ++c)
      {
        const double number = numbers[this->Roles.AreNodesFirst ? c * faces + f : f * corners + c];
        const double node = number - this->Roles.StartIndex;
        const bool isAbsent = c == 3 && (std::isnan(number) || node < 0.0);
        Require(isAbsent || (node >= 0.0 && node < static_cast<double>(grid.Columns()) && node == std::floor(node))
            ? ""
            : "face " + std::to_string(f + 1) + " of its mesh names a node that does not exist");
        face[c] = isAbsent ? -1 : static_cast<int>(node);
      }
      this->Orient(face);
      grid.Faces.push_back(face);
    }
    if (this->Roles.Kind == OceanGridKind::Faces)
    {
      grid.ToNodes = FacesToNodes(grid.Places, grid.Faces);
      this->MakeFaceAxes();
    }
  }

  /// Axes of velocities in faces: the means of those at their nodes.
  void MakeFaceAxes()
  {
    OceanGrid& grid = this->Grid;
    std::vector<MapAxes> axes(grid.Faces.size(), MapAxes{ { 0.0, 0.0 }, { 0.0, 0.0 } });
    for (std::size_t f = 0; f < grid.Faces.size(); ++f)
    {
      const double share = grid.Faces[f][3] < 0 ? 1.0 / 3.0 : 0.25;
      for (const int node : grid.Faces[f])
      {
        for (int c = 0; node >= 0 && c < 2; ++c)
        {
          axes[f].East[c] += share * grid.Axes[node].East[c];
          axes[f].North[c] += share * grid.Axes[node].North[c];
        }
      }
    }
    grid.Axes = axes;
  }

  void Orient(FaceCorners& face) const
  {
    const auto& a = this->Grid.Places[face[0]];
    const auto& b = this->Grid.Places[face[1]];
    const auto& c = this->Grid.Places[face[2]];
    const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    Require(area != 0.0 ? "" : "a face of its mesh has no area");
    if (area < 0.0)
    {
      std::swap(face[face[3] < 0 ? 0 : 1], face[face[3] < 0 ? 2 : 3]);
    }
  }

  void MakeLevels()
  {
    OceanGrid& grid = this->Grid;
    const NetcdfVariable* variable = this->Roles.S;
    if (!variable)
    {
      return;
    }
    const OceanVariable& u = this->Roles.Velocity[0];
    const std::size_t count = this->LengthOf(u, u.Axes.Z);
    grid.Count[2] = static_cast<int>(count);
    std::vector<double> s = this->File.ReadAll(*variable);
    RequireNoGaps(s, variable->Name);
    if (variable->Dimensions.size() == 2 && s.size() == count * grid.Columns())
    {
      grid.OwnSigma = s;
      std::vector<double> first;
      for (std::size_t k = 0; k < count; ++k)
      {
        first.push_back(s[k * grid.Columns()]);
      }
      s = first;
    }
    Require(
      s.size() == count ? "" : "its levels " + variable->Name + " are not as many as those of its " + u.Variable->Name);
    RequireOrder(s, variable->Name);
    const bool areHeights = this->Roles.LevelsKind == LevelKind::Heights;
    for (double& one : s)
    {
      Require(areHeights || (one <= 1e-6 && one >= -1.0 - 1e-6)
          ? ""
          : "its levels " + variable->Name + " are not from -1 to 0: " + TextOf(one));
      one = areHeights ? (this->Roles.IsDownwards ? -1.0 : 1.0) * this->Roles.MetresPerHeight * one : one;
    }
    grid.TurnsZ = count > 1 && s[1] < s[0];
    grid.Levels = { this->Roles.LevelsKind, s, {}, this->Roles.CriticalDepth };
    const bool isStretched = !areHeights && this->Roles.LevelsKind != LevelKind::Sigma;
    if (isStretched && this->Roles.Stretching)
    {
      grid.Levels.Stretching = this->File.ReadAll(*this->Roles.Stretching);
      RequireNoGaps(grid.Levels.Stretching, this->Roles.Stretching->Name);
      Require(grid.Levels.Stretching.size() == count
          ? ""
          : "its " + this->Roles.Stretching->Name + " has not the levels of its " + u.Variable->Name);
    }
    for (std::size_t k = 0; isStretched && !this->Roles.Stretching && k < count; ++k)
    {
      grid.Levels.Stretching.push_back(this->Roles.Function.At(s[k]));
    }
  }

  /// A variable on the columns, rows in the order of the grid.
  std::vector<double> ReadColumns(const OceanVariable& variable) const
  {
    const OceanGrid& grid = this->Grid;
    std::vector<double> values =
      ReadAround(this->File, variable, 0, 0, { grid.FirstY, static_cast<std::size_t>(grid.Count[1]) },
        { grid.FirstX, static_cast<std::size_t>(grid.Count[0]) }, grid.LengthX);
    for (int j = 0; grid.TurnsY && j < grid.Count[1] / 2; ++j)
    {
      std::swap_ranges(values.begin() + this->ColumnOf(0, j), values.begin() + this->ColumnOf(0, j + 1),
        values.begin() + this->ColumnOf(0, grid.Count[1] - 1 - j));
    }
    return values;
  }

  void MakeDepth()
  {
    OceanGrid& grid = this->Grid;
    if (this->Roles.Mask)
    {
      for (const double value : this->ReadColumns(this->Roles.Mask))
      {
        grid.Water.push_back(value > 0.5 ? 1 : 0);
      }
    }
    if (!this->Roles.Depth)
    {
      return;
    }
    grid.Depth = this->ReadColumns(this->Roles.Depth);
    for (double& depth : grid.Depth)
    {
      depth *= this->Roles.Depth.Unit;
    }
  }

  const NetcdfFile& File;
  const OceanRoles& Roles;
  const OceanPlacing& Placing;
  std::optional<OceanProjection> Projection; ///< of projected places
  OceanGrid Grid;
  std::vector<double> Raw[2];    ///< coordinates of columns as the file has them
  std::vector<EarthPlace> Earth; ///< the same as longitudes and latitudes
};

}

OceanGrid MakeOceanGrid(const NetcdfFile& file, const OceanRoles& roles, const OceanPlacing& placing)
{
  return Maker(file, roles, placing).Make();
}

std::size_t OceanLayers::LevelOf(int layer) const
{
  return static_cast<std::size_t>(this->Grid.TurnsZ ? this->Grid.Count[2] - 1 - layer : layer);
}

std::vector<double> OceanLayers::Centers(
  const OceanVariable& variable, int time, int level, const OceanWindow& window, int shift, int axis) const
{
  const OceanGrid& grid = this->Grid;
  const int firstRow = grid.TurnsY ? grid.Count[1] - 1 - window[3] : window[2];
  const auto width = static_cast<std::size_t>(window[1] - window[0] + 1);
  const auto height = static_cast<std::size_t>(window[3] - window[2] + 1);
  Run y{ grid.FirstY + static_cast<std::size_t>(firstRow), height };
  Run x{ grid.FirstX + static_cast<std::size_t>(window[0]), width };
  std::vector<double> values;
  if (shift == 0)
  {
    values = ReadAround(this->File, variable, static_cast<std::size_t>(time), static_cast<std::size_t>(level), y, x,
      grid.IsMesh ? x.First + x.Count : grid.LengthX);
  }
  else
  {
    // sides n - 1 and n of the centre n; a closed side, which is missing, has no flow
    Run& along = axis == 0 ? x : y;
    --along.First;
    ++along.Count;
    const std::vector<double> sides =
      ReadPlane(this->File, variable, static_cast<std::size_t>(time), static_cast<std::size_t>(level), y, x);
    const std::size_t stride = axis == 0 ? 1 : width;
    for (std::size_t j = 0; j < height; ++j)
    {
      for (std::size_t i = 0; i < width; ++i)
      {
        const double before = sides[j * x.Count + i], after = sides[j * x.Count + i + stride];
        const bool isClosed = std::isnan(before) && std::isnan(after);
        values.push_back(isClosed ? std::numeric_limits<double>::quiet_NaN()
                                  : 0.5 * ((std::isnan(before) ? 0.0 : before) + (std::isnan(after) ? 0.0 : after)));
      }
    }
  }
  for (std::size_t j = 0; grid.TurnsY && j < height / 2; ++j)
  {
    std::swap_ranges(
      values.begin() + j * width, values.begin() + (j + 1) * width, values.begin() + (height - 1 - j) * width);
  }
  return values;
}

std::vector<double> OceanLayers::Surface(int time, const OceanWindow& window) const
{
  const auto columns =
    static_cast<std::size_t>(window[1] - window[0] + 1) * static_cast<std::size_t>(window[3] - window[2] + 1);
  if (!this->Roles.Surface)
  {
    return std::vector<double>(columns, 0.0);
  }
  std::vector<double> surface = this->Centers(this->Roles.Surface, time, 0, window, 0, 0);
  for (double& height : surface)
  {
    height = std::isfinite(height) ? this->Roles.Surface.Unit * height : 0.0;
  }
  return surface;
}

void OceanLayers::Heights(
  int layer, const OceanWindow& window, const std::vector<double>& surface, double* heights) const
{
  const OceanGrid& grid = this->Grid;
  if (!this->Roles.S)
  {
    std::fill_n(heights, surface.size(), 0.0);
    return;
  }
  OceanLevels levels = grid.Levels;
  const auto level = static_cast<int>(this->LevelOf(layer));
  // columns on land are as deep as the shallowest ones, so that cells beside them have a volume
  double shallowest = std::numeric_limits<double>::infinity();
  for (const double depth : grid.Depth)
  {
    shallowest = depth > LeastThickness ? std::min(shallowest, depth) : shallowest;
  }
  shallowest = std::isfinite(shallowest) ? shallowest : 1.0;
  std::size_t n = 0;
  for (int j = window[2]; j <= window[3]; ++j)
  {
    for (int i = window[0]; i <= window[1]; ++i, ++n)
    {
      const std::size_t column = static_cast<std::size_t>(j) * grid.Count[0] + i;
      const double told = grid.Depth.empty() ? 0.0 : grid.Depth[column];
      const double depth = std::max(std::isfinite(told) ? told : shallowest, LeastThickness - surface[n]);
      if (!grid.OwnSigma.empty())
      {
        levels.S[level] = grid.OwnSigma[this->LevelOf(layer) * grid.Columns() + column];
      }
      heights[n] = levels.HeightOf(level, depth, surface[n]);
    }
  }
}

std::vector<double> OceanLayers::Up(int time, int level, const OceanWindow& window) const
{
  const OceanVariable& w = this->Roles.Velocity[2];
  const std::size_t levels = w.Axes.Z < 0 ? 1 : this->File.LengthOf(*w.Variable, static_cast<std::size_t>(w.Axes.Z));
  const auto own = static_cast<std::size_t>(this->Grid.Count[2]);
  Require(levels == own || levels == own + 1 ? "" : "its " + w.Variable->Name + " has other levels than its currents");
  std::vector<double> up = this->Centers(w, time, level, window, 0, 0);
  if (levels == own + 1)
  {
    // between the levels of the horizontal velocities
    const std::vector<double> next = this->Centers(w, time, level + 1, window, 0, 0);
    std::transform(up.begin(), up.end(), next.begin(), up.begin(), [](double a, double b) { return 0.5 * (a + b); });
  }
  return up;
}

std::vector<Vector3> OceanLayers::OnMap(int time, int level, const OceanWindow& window, std::size_t firstAxes) const
{
  const OceanGrid& grid = this->Grid;
  const OceanVariable* components = this->Roles.Velocity;
  const bool isStaggered = this->Roles.Kind == OceanGridKind::Staggered;
  const std::vector<double> u = this->Centers(components[0], time, level, window, isStaggered ? 1 : 0, 0);
  const std::vector<double> v = this->Centers(components[1], time, level, window, isStaggered ? 1 : 0, 1);
  const std::vector<double> w = components[2] ? this->Up(time, level, window) : std::vector<double>();
  const std::size_t width = static_cast<std::size_t>(window[1] - window[0] + 1);
  const std::size_t stride = grid.IsMesh ? width : static_cast<std::size_t>(grid.Count[0]);
  std::vector<Vector3> found(u.size(), Vector3(std::numeric_limits<double>::quiet_NaN()));
  for (std::size_t n = 0; n < u.size(); ++n)
  {
    if (!IsSensible(u[n]) || !IsSensible(v[n]))
    {
      continue;
    }
    const MapAxes& axes = grid.Axes[firstAxes + n / width * stride + n % width];
    const double east = components[0].Unit * u[n], north = components[1].Unit * v[n];
    found[n].x = east * axes.East[0] + north * axes.North[0];
    found[n].y = east * axes.East[1] + north * axes.North[1];
    found[n].z = !w.empty() && IsSensible(w[n]) ? components[2].Unit * w[n] : 0.0;
  }
  return found;
}

void OceanLayers::Velocities(int time, int layer, const OceanWindow& window, float* velocities) const
{
  const OceanGrid& grid = this->Grid;
  const auto level = static_cast<int>(this->LevelOf(layer));
  if (this->Roles.Kind == OceanGridKind::Faces)
  {
    const std::vector<Vector3> faces =
      this->OnMap(time, level, { 0, static_cast<int>(grid.Faces.size()) - 1, 0, 0 }, 0);
    for (int node = window[0]; node <= window[1]; ++node, velocities += 3)
    {
      const Vector3 velocity = grid.ToNodes.At(node, faces.data());
      std::copy_n(&velocity.x, 3, velocities);
    }
    return;
  }
  const std::size_t first = static_cast<std::size_t>(window[2]) * grid.Count[0] + window[0];
  const std::vector<Vector3> columns = this->OnMap(time, level, window, first);
  const std::size_t width = static_cast<std::size_t>(window[1] - window[0] + 1);
  for (std::size_t n = 0; n < columns.size(); ++n, velocities += 3)
  {
    const std::size_t column = first + n / width * grid.Count[0] + n % width;
    const bool isWater = grid.Water.empty() || grid.Water[column] != 0;
    for (int c = 0; c < 3; ++c)
    {
      velocities[c] = isWater ? static_cast<float>(columns[n][c]) : std::numeric_limits<float>::quiet_NaN();
    }
  }
}

}
