// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OceanRoles.h"

#include "Geometry/PlaceUnits.h"
#include "Numerics/Constants.h"
#include "Numerics/InvalidInput.h"
#include "Numerics/Words.h"
#include "OceanProjection.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <map>

namespace littoral
{

namespace
{

using Names = std::initializer_list<const char*>;

bool IsOneOf(const std::string& text, const Names& names)
{
  return std::find(names.begin(), names.end(), text) != names.end();
}

enum class Axis
{
  None,
  T,
  Z,
  Y,
  X,
};

/// Pairs of names of horizontal velocities, those of three dimensions first.
constexpr std::array<std::array<const char*, 3>, 12> KnownVelocities{ { { "u_eastward", "v_northward", "w" },
  { "uo", "vo", "wo" }, { "water_u", "water_v", "water_w" }, { "u", "v", "w" }, { "U", "V", "W" },
  { "vozocrtx", "vomecrty", "vovecrtz" }, { "u_velocity", "v_velocity", "w_velocity" }, { "ua", "va", "" },
  { "ubar_eastward", "vbar_northward", "" }, { "ubar", "vbar", "" }, { "u_surf", "v_surf", "" },
  { "ssu", "ssv", "" } } };

/// Finds roles step by step.
class Search
{
public:
  Search(const NetcdfFile& file, const OceanChoices& choices)
    : File(file)
    , Choices(choices)
  {
  }

  bool HasVelocities()
  {
    const NetcdfVariable* found[3];
    const bool isThere = this->FindVelocities(found) && found[0]->Dimensions.size() >= 2;
    const std::string name = isThere ? this->StandardName(*found[0]) : "";
    // u and v are names of winds, too
    return isThere && (name.empty() || name.find("sea_water") != std::string::npos);
  }

  OceanRoles Find()
  {
    const NetcdfVariable* velocities[3];
    if (!this->FindVelocities(velocities))
    {
      Refuse(
        "no variables of it are known as velocities of the sea, by standard names as eastward_sea_water_velocity or "
        "by names as u and v; give UVariable and VVariable");
    }
    this->FindMesh(*velocities[0]);
    for (int c = 0; c < 3; ++c)
    {
      if (velocities[c])
      {
        this->Roles.Velocity[c] = this->WithAxes(*velocities[c]);
        this->Roles.Velocity[c].Unit = this->UnitOfSpeed(*velocities[c]);
      }
    }
    this->FindKind();
    this->FindPlaces();
    this->FindTime();
    this->FindLevels();
    this->FindRest();
    return this->Roles;
  }

private:
  std::string Text(const NetcdfVariable& variable, const char* attribute) const
  {
    return this->File.TextOf(variable, attribute);
  }

  std::string StandardName(const NetcdfVariable& variable) const { return this->Text(variable, "standard_name"); }

  const NetcdfVariable* Named(const std::string& name) const
  {
    const NetcdfVariable* found = name.empty() ? nullptr : this->File.Find(name);
    return found;
  }

  /// The first variable with one of some standard names and so many dimensions at least.
  const NetcdfVariable* Standard(const Names& names, std::size_t dimensions) const
  {
    for (const NetcdfVariable& variable : this->File.Variables())
    {
      if (variable.Dimensions.size() >= dimensions && IsOneOf(this->StandardName(variable), names))
      {
        return &variable;
      }
    }
    return nullptr;
  }

  bool FindVelocities(const NetcdfVariable* found[3])
  {
    std::fill_n(found, 3, nullptr);
    const std::array<std::string, 3>& chosen = this->Choices.Velocities;
    for (int c = 0; c < 3; ++c)
    {
      if (!chosen[c].empty())
      {
        found[c] = this->Named(chosen[c]);
        Require(found[c] ? "" : "it has no variable '" + chosen[c] + "'; give another " + "UVW"[c] + "Variable");
      }
    }
    Require(!found[0] == !found[1] ? "" : "UVariable and VVariable go together; give both");
    if (!found[0])
    {
      found[0] = this->Standard({ "eastward_sea_water_velocity" }, 2);
      found[1] = this->Standard({ "northward_sea_water_velocity" }, 2);
    }
    if (!found[0] || !found[1])
    {
      found[0] = this->Standard({ "sea_water_x_velocity", "grid_eastward_sea_water_velocity" }, 2);
      found[1] = this->Standard({ "sea_water_y_velocity", "grid_northward_sea_water_velocity" }, 2);
    }
    if (!found[0] || !found[1])
    {
      found[0] = this->Standard({ "surface_eastward_sea_water_velocity", "barotropic_eastward_sea_water_velocity" }, 2);
      found[1] =
        this->Standard({ "surface_northward_sea_water_velocity", "barotropic_northward_sea_water_velocity" }, 2);
    }
    for (std::size_t n = 0; (!found[0] || !found[1]) && n < KnownVelocities.size(); ++n)
    {
      found[0] = this->Named(KnownVelocities[n][0]);
      found[1] = this->Named(KnownVelocities[n][1]);
    }
    if (!found[0] || !found[1])
    {
      return false;
    }
    found[2] = found[2] ? found[2] : this->Standard({ "upward_sea_water_velocity" }, 3);
    for (std::size_t n = 0; !found[2] && n < KnownVelocities.size(); ++n)
    {
      const bool isOfTheseNames = found[0]->Name == KnownVelocities[n][0];
      found[2] = isOfTheseNames ? this->Named(KnownVelocities[n][2]) : nullptr;
    }
    const NetcdfVariable* ww = found[2] ? found[2] : this->Named("ww"); // FVCOM's
    found[2] = ww && ww->Dimensions.size() >= found[0]->Dimensions.size() ? ww : nullptr;
    return true;
  }

  double UnitOfSpeed(const NetcdfVariable& variable) const
  {
    std::string unit = Lower(this->Text(variable, "units"));
    unit.erase(
      std::remove_if(unit.begin(), unit.end(), [](char c) { return c == ' ' || c == '.' || c == '*'; }), unit.end());
    if (IsOneOf(unit,
          { "", "m/s", "ms-1", "ms^-1", "meter/second", "metre/second", "meters/second", "metres/second",
            "meterspersecond", "metersecond-1", "metresecond-1", "meterssecond-1", "metersecond^-1", "metress-1",
            "meters-1", "meterss-1", "m/sec", "msec-1" }))
    {
      return 1.0;
    }
    if (IsOneOf(unit, { "cm/s", "cms-1", "cms^-1", "centimeter/second", "centimetersecond-1", "cm/sec" }))
    {
      return 0.01;
    }
    if (IsOneOf(unit, { "mm/s", "mms-1" }))
    {
      return 0.001;
    }
    if (IsOneOf(unit, { "km/h", "kmh-1", "kmhr-1" }))
    {
      return 1.0 / 3.6;
    }
    if (IsOneOf(unit, { "kt", "knot", "knots", "kn" }))
    {
      return 1852.0 / 3600.0;
    }
    Refuse("the unit '", this->Text(variable, "units"), "' of its ", variable.Name, " is none of velocities, as m/s");
  }

  /// Whether a unit is one of angles.
  static bool IsLongitudeUnit(const std::string& unit)
  {
    return IsOneOf(unit, { "degrees_east", "degree_east", "degree_e", "degrees_e", "degreee", "degreese" });
  }

  static bool IsLatitudeUnit(const std::string& unit)
  {
    return IsOneOf(unit, { "degrees_north", "degree_north", "degree_n", "degrees_n", "degreen", "degreesn" });
  }

  /// The axis that a variable of coordinates is for, by its attributes.
  Axis AxisOfAttributes(const NetcdfVariable& variable) const
  {
    const std::string name = this->StandardName(variable);
    const std::string unit = Lower(this->Text(variable, "units"));
    const std::string axis = Lower(this->Text(variable, "axis"));
    if (name == "time" || axis == "t" || unit.find(" since ") != std::string::npos)
    {
      return Axis::T;
    }
    if (axis == "z" || !this->Text(variable, "positive").empty() || IsOneOf(name, { "depth", "height", "altitude" }) ||
      name.rfind("ocean_s", 0) == 0)
    {
      return Axis::Z;
    }
    if (axis == "x" || IsLongitudeUnit(unit) ||
      IsOneOf(name, { "longitude", "grid_longitude", "projection_x_coordinate" }))
    {
      return Axis::X;
    }
    if (axis == "y" || IsLatitudeUnit(unit) ||
      IsOneOf(name, { "latitude", "grid_latitude", "projection_y_coordinate" }))
    {
      return Axis::Y;
    }
    return Axis::None;
  }

  static Axis AxisOfName(const std::string& spelled)
  {
    const std::string name = Lower(spelled);
    const auto begins = [&](const char* with) { return name.rfind(with, 0) == 0; };
    if (begins("time") || begins("ocean_time") || IsOneOf(name, { "t", "mt" }))
    {
      return Axis::T;
    }
    if (begins("depth") || begins("lev") || begins("s_rho") || begins("s_w") || begins("sig") ||
      IsOneOf(name, { "z", "zt", "layer", "nz" }))
    {
      return Axis::Z;
    }
    if (begins("eta") || begins("lat") || begins("rlat") || IsOneOf(name, { "y", "yc", "j", "ny", "nlat" }))
    {
      return Axis::Y;
    }
    if (begins("xi") || begins("lon") || begins("rlon") || IsOneOf(name, { "x", "xc", "i", "nx", "nlon" }))
    {
      return Axis::X;
    }
    return Axis::None;
  }

  /// The variable of one dimension that gives the coordinates of a dimension; null for none.
  const NetcdfVariable* CoordinatesOf(int dimension) const
  {
    const NetcdfVariable* found = this->Named(this->File.Dimensions()[static_cast<std::size_t>(dimension)].Name);
    return found && found->Dimensions.size() == 1 && found->Dimensions[0] == dimension ? found : nullptr;
  }

  Axis AxisOf(int dimension) const
  {
    const std::string& name = this->File.Dimensions()[static_cast<std::size_t>(dimension)].Name;
    const NetcdfVariable* coordinates = this->CoordinatesOf(dimension);
    Axis axis = coordinates ? this->AxisOfAttributes(*coordinates) : Axis::None;
    for (const NetcdfVariable& variable : this->File.Variables())
    {
      // a coordinate of another name: one dimension, with attributes that say what it is
      const bool isOther = axis == Axis::None && variable.Dimensions.size() == 1 && variable.Dimensions[0] == dimension;
      axis = isOther ? this->AxisOfAttributes(variable) : axis;
    }
    return axis == Axis::None ? AxisOfName(name) : axis;
  }

  static void Take(OceanAxes& axes, Axis axis, int place, const std::string& words)
  {
    int* const places[] = { nullptr, &axes.T, &axes.Z, &axes.Y, &axes.X };
    int& own = *places[static_cast<int>(axis)];
    Require(own < 0 ? "" : "two axes of its variable " + words);
    own = place;
  }

  /// A variable with the places of its axes. Throws InvalidInput if it has one twice, or one that is none.
  OceanVariable WithAxes(const NetcdfVariable& variable) const
  {
    OceanVariable with;
    with.Variable = &variable;
    std::vector<int> open;
    const auto& all = this->File.Dimensions();
    for (int place = 0; place < static_cast<int>(variable.Dimensions.size()); ++place)
    {
      const int dimension = variable.Dimensions[static_cast<std::size_t>(place)];
      const bool isOfMesh =
        std::find(this->MeshDimensions.begin(), this->MeshDimensions.end(), dimension) != this->MeshDimensions.end();
      const Axis axis = isOfMesh ? Axis::X : this->AxisOf(dimension);
      if (axis == Axis::None)
      {
        open.push_back(place);
        continue;
      }
      Take(with.Axes, axis, place, variable.Name + " are of the same kind (" + all[dimension].Name + ")");
    }
    // The last two dimensions are those in plan view if nothing says what they are.
    for (auto place = open.rbegin(); place != open.rend(); ++place)
    {
      const std::size_t length = this->File.LengthOf(variable, static_cast<std::size_t>(*place));
      const bool isMesh = !this->MeshDimensions.empty();
      if (with.Axes.X < 0 && !isMesh)
      {
        with.Axes.X = *place;
      }
      else if (with.Axes.Y < 0 && !isMesh)
      {
        with.Axes.Y = *place;
      }
      else if (length != 1)
      {
        const int dimension = variable.Dimensions[static_cast<std::size_t>(*place)];
        Refuse("the axis '", all[static_cast<std::size_t>(dimension)].Name, "' of its variable ", variable.Name,
          " is unknown: it is none of times, levels and places");
      }
    }
    return with;
  }

  int DimensionOf(const OceanVariable& variable, int place) const
  {
    return place < 0 ? -1 : variable.Variable->Dimensions[static_cast<std::size_t>(place)];
  }

  void FindMesh(const NetcdfVariable& velocity)
  {
    const NetcdfVariable* topology = this->Named(this->Text(velocity, "mesh"));
    for (const NetcdfVariable& variable : this->File.Variables())
    {
      topology = !topology && this->Text(variable, "cf_role") == "mesh_topology" ? &variable : topology;
    }
    this->Topology = topology;
    OceanRoles& roles = this->Roles;
    roles.FaceNodes = topology ? this->Named(this->Text(*topology, "face_node_connectivity")) : this->Named("nv");
    if (!topology && !(roles.FaceNodes && roles.FaceNodes->Dimensions.size() == 2))
    {
      roles.FaceNodes = nullptr;
      return;
    }
    if (!roles.FaceNodes || roles.FaceNodes->Dimensions.size() != 2)
    {
      Refuse("its mesh has no table of two dimensions of the nodes of its faces");
    }
    const std::string faces = topology ? this->Text(*topology, "face_dimension") : "";
    const auto& all = this->File.Dimensions();
    const auto& own = roles.FaceNodes->Dimensions;
    const bool isNamed = !faces.empty();
    roles.AreNodesFirst = isNamed ? all[static_cast<std::size_t>(own[1])].Name == faces
                                  : this->File.LengthOf(*roles.FaceNodes, 0) < this->File.LengthOf(*roles.FaceNodes, 1);
    roles.StartIndex = this->File.NumberOf(*roles.FaceNodes, "start_index").value_or(topology ? 0.0 : 1.0);
    this->FaceDimension = own[roles.AreNodesFirst ? 1 : 0];
    this->FindNodes();
    this->MeshDimensions = { this->FaceDimension, this->NodeDimension };
  }

  /// The coordinates of nodes.
  void FindNodes()
  {
    OceanRoles& roles = this->Roles;
    std::vector<std::string> names = this->Topology ? WordsOf(this->Text(*this->Topology, "node_coordinates"))
                                                    : std::vector<std::string>{ "lon", "lat" };
    if (names.size() == 2)
    {
      roles.PlaceX = this->Named(names[0]);
      roles.PlaceY = this->Named(names[1]);
    }
    if (roles.PlaceX && roles.PlaceY && this->AxisOfAttributes(*roles.PlaceX) == Axis::Y)
    {
      std::swap(roles.PlaceX, roles.PlaceY);
    }
    if (!this->Topology && (!roles.PlaceX || !roles.PlaceY || this->AreAllZero(*roles.PlaceX)))
    {
      roles.PlaceX = this->Named("x");
      roles.PlaceY = this->Named("y");
    }
    const bool isFit = roles.PlaceX && roles.PlaceY && roles.PlaceX->Dimensions.size() == 1 &&
      roles.PlaceX->Dimensions == roles.PlaceY->Dimensions;
    Require(isFit ? "" : "its mesh has no coordinates of nodes");
    this->NodeDimension = roles.PlaceX->Dimensions[0];
  }

  /// FVCOM fills the coordinates that it does not use with zeros.
  bool AreAllZero(const NetcdfVariable& variable) const
  {
    const std::vector<double> values = this->File.ReadAll(variable);
    return std::all_of(values.begin(), values.end(), [](double value) { return value == 0.0; });
  }

  void FindKind()
  {
    OceanVariable& u = this->Roles.Velocity[0];
    OceanVariable& v = this->Roles.Velocity[1];
    const auto lengthOf = [&](const OceanVariable& variable, int place) {
      return place < 0 ? 1 : this->File.LengthOf(*variable.Variable, static_cast<std::size_t>(place));
    };
    const bool areLike = (u.Axes.T < 0) == (v.Axes.T < 0) && (u.Axes.Z < 0) == (v.Axes.Z < 0) &&
      lengthOf(u, u.Axes.Z) == lengthOf(v, v.Axes.Z) && lengthOf(u, u.Axes.T) == lengthOf(v, v.Axes.T);
    Require(areLike ? "" : "its " + u.Variable->Name + " and " + v.Variable->Name + " have other axes");
    const std::string standard = this->StandardName(*u.Variable);
    bool isAlong = standard.find("x_velocity") != std::string::npos || standard.find("grid_") != std::string::npos;
    if (!this->MeshDimensions.empty())
    {
      Require(u.Axes.X >= 0 && v.Axes.X >= 0 && this->DimensionOf(u, u.Axes.X) == this->DimensionOf(v, v.Axes.X)
          ? ""
          : "its " + u.Variable->Name + " and " + v.Variable->Name + " are not on the same points of its mesh");
      this->Roles.Kind =
        this->DimensionOf(u, u.Axes.X) == this->NodeDimension ? OceanGridKind::Nodes : OceanGridKind::Faces;
      isAlong = false; // of a mesh the standard names of FVCOM mean x and y of its own map
    }
    else
    {
      Require(u.Axes.X >= 0 && u.Axes.Y >= 0 && v.Axes.X >= 0 && v.Axes.Y >= 0 ? ""
                                                                               : "its " + u.Variable->Name + " and " +
            v.Variable->Name + " have no two axes of places, as latitude and longitude");
      const std::size_t ux = lengthOf(u, u.Axes.X), uy = lengthOf(u, u.Axes.Y);
      const std::size_t vx = lengthOf(v, v.Axes.X), vy = lengthOf(v, v.Axes.Y);
      const bool isSame = ux == vx && uy == vy;
      const bool isStaggered = ux + 1 == vx && vy + 1 == uy;
      Require(isSame || isStaggered
          ? ""
          : "its " + u.Variable->Name + " and " + v.Variable->Name + " are on grids that do not fit each other");
      this->Roles.Kind = isStaggered ? OceanGridKind::Staggered : OceanGridKind::Structured;
      isAlong = isAlong || isStaggered || IsOneOf(u.Variable->Name, { "vozocrtx" });
      this->Lengths = { isStaggered ? vx : ux, uy };
    }
    const OceanDirections chosen = this->Choices.Directions;
    this->Roles.IsAlongAxes = chosen == OceanDirections::Automatic ? isAlong : chosen == OceanDirections::GridAxes;
  }

  /// Whether a variable has a value for each column of the grid, or is one of its axes.
  bool IsOfGrid(const NetcdfVariable& variable) const
  {
    return variable.Dimensions.size() == 2 && this->File.LengthOf(variable, 0) == this->Lengths[1] &&
      this->File.LengthOf(variable, 1) == this->Lengths[0];
  }

  bool IsPlaceUnit(const NetcdfVariable& variable, bool isX) const
  {
    const std::string unit = Lower(this->Text(variable, "units"));
    const std::string name = this->StandardName(variable);
    return isX ? IsLongitudeUnit(unit) || name == "longitude" : IsLatitudeUnit(unit) || name == "latitude";
  }

  void FindPlaces()
  {
    OceanRoles& roles = this->Roles;
    const OceanVariable& u = roles.Velocity[0];
    const NetcdfVariable* x = roles.PlaceX;
    const NetcdfVariable* y = roles.PlaceY;
    if (this->MeshDimensions.empty())
    {
      const bool isStaggered = roles.Kind == OceanGridKind::Staggered;
      x = isStaggered ? nullptr : this->AxisVariable(u, u.Axes.X, true);
      y = isStaggered ? nullptr : this->AxisVariable(u, u.Axes.Y, false);
      const bool areEarth = x && y && this->IsPlaceUnit(*x, true) && this->IsPlaceUnit(*y, false);
      const NetcdfVariable* longitudes = areEarth ? nullptr : this->PlaneVariable(u, true);
      const NetcdfVariable* latitudes = areEarth ? nullptr : this->PlaneVariable(u, false);
      if (longitudes && latitudes)
      {
        x = longitudes;
        y = latitudes;
      }
      else if (!x || !y)
      {
        x = this->PlaneNamed({ "x_rho", "x" });
        y = this->PlaneNamed({ "y_rho", "y" });
      }
      if (!x || !y)
      {
        Refuse("the places of its ", u.Variable->Name, " are missing: no variables have its longitudes and latitudes");
      }
    }
    roles.PlaceX = x;
    roles.PlaceY = y;
    this->FindPlaceUnits(*x);
  }

  /// The coordinates along an axis of a variable, by name or as the only variable that is of this axis.
  const NetcdfVariable* AxisVariable(const OceanVariable& of, int place, bool isX) const
  {
    const int dimension = this->DimensionOf(of, place);
    const NetcdfVariable* named = this->CoordinatesOf(dimension);
    const Axis axis = isX ? Axis::X : Axis::Y;
    for (const NetcdfVariable& variable : this->File.Variables())
    {
      const bool isOfAxis = variable.Dimensions.size() == 1 && variable.Dimensions[0] == dimension &&
        this->AxisOfAttributes(variable) == axis;
      named = isOfAxis && (!named || this->IsPlaceUnit(variable, isX)) ? &variable : named;
    }
    return named;
  }

  /// The longitudes or latitudes of all columns: those that the velocities name, else any.
  const NetcdfVariable* PlaneVariable(const OceanVariable& of, bool isX) const
  {
    const bool isStaggered = this->Roles.Kind == OceanGridKind::Staggered;
    const std::vector<std::string> names =
      isStaggered ? std::vector<std::string>() : WordsOf(this->Text(*of.Variable, "coordinates"));
    for (const std::string& name : names)
    {
      const NetcdfVariable* variable = this->Named(name);
      if (variable && this->IsOfGrid(*variable) && this->IsPlaceUnit(*variable, isX))
      {
        return variable;
      }
    }
    const NetcdfVariable* named = isX
      ? this->PlaneNamed({ "lon_rho", "nav_lon", "lon", "longitude", "Longitude", "LON", "XLONG" })
      : this->PlaneNamed({ "lat_rho", "nav_lat", "lat", "latitude", "Latitude", "LAT", "XLAT" });
    for (const NetcdfVariable& variable : this->File.Variables())
    {
      named = !named && this->IsOfGrid(variable) && this->IsPlaceUnit(variable, isX) ? &variable : named;
    }
    return named;
  }

  const NetcdfVariable* PlaneNamed(const Names& names) const
  {
    for (const char* name : names)
    {
      const NetcdfVariable* variable = this->Named(name);
      if (variable && this->IsOfGrid(*variable))
      {
        return variable;
      }
    }
    return nullptr;
  }

  void FindPlaceUnits(const NetcdfVariable& x)
  {
    OceanRoles& roles = this->Roles;
    const std::string name = this->StandardName(x);
    if (name == "grid_longitude" || Lower(x.Name) == "rlon")
    {
      this->FindPole();
      return;
    }
    const std::string unit = Lower(this->Text(x, "units"));
    const bool isNamedEarth = Lower(x.Name).find("lon") != std::string::npos;
    if (this->IsPlaceUnit(x, true) || (isNamedEarth && (unit.empty() || unit == "degrees" || unit == "degree")))
    {
      roles.PlaceKind = OceanPlaceKind::Degrees;
      return;
    }
    const UnitOfLength* length = unit.empty() ? nullptr : FindUnitOfLength(unit);
    if (!length)
    {
      Refuse("the unit '", unit, "' of its ", x.Name, " is none of places, as degrees_east or m");
    }
    const NetcdfVariable* mapping = this->Named(this->Text(*roles.Velocity[0].Variable, "grid_mapping"));
    roles.MetresPerPlace = length->Metres;
    roles.PlaceKind = mapping ? OceanPlaceKind::Projected : OceanPlaceKind::Metres;
    Require(mapping && !this->MeshDimensions.empty()
        ? "its mesh is on a map, and its longitudes and latitudes are missing"
        : "");
    roles.Map = mapping ? MapOfMapping(this->File, *mapping, length->Metres) : "";
  }

  void FindPole()
  {
    const NetcdfVariable& u = *this->Roles.Velocity[0].Variable;
    const NetcdfVariable* mapping = this->Named(this->Text(u, "grid_mapping"));
    const auto latitude = mapping ? this->File.NumberOf(*mapping, "grid_north_pole_latitude") : std::nullopt;
    const auto longitude = mapping ? this->File.NumberOf(*mapping, "grid_north_pole_longitude") : std::nullopt;
    if (!latitude || !longitude)
    {
      Refuse("the pole of its rotated grid is missing: its ", u.Name,
        " names no grid_mapping with grid_north_pole_latitude and grid_north_pole_longitude");
    }
    const double turn = this->File.NumberOf(*mapping, "north_pole_grid_longitude").value_or(0.0);
    this->Roles.Pole = { *longitude, *latitude, turn };
    this->Roles.PlaceKind = OceanPlaceKind::RotatedDegrees;
  }

  void FindTime()
  {
    OceanRoles& roles = this->Roles;
    const int dimension = this->DimensionOf(roles.Velocity[0], roles.Velocity[0].Axes.T);
    if (dimension < 0)
    {
      return;
    }
    const NetcdfVariable* days = this->Named("Itime");
    const NetcdfVariable* clock = this->Named("Itime2");
    if (days && clock)
    {
      roles.TimeDays = days;
      roles.TimeOfDay = clock;
    }
    roles.Time = roles.TimeDays ? roles.TimeDays : this->CoordinatesOf(dimension);
    for (const NetcdfVariable& variable : this->File.Variables())
    {
      const bool isOfAxis = !roles.Time && variable.Dimensions.size() == 1 && variable.Dimensions[0] == dimension &&
        this->AxisOfAttributes(variable) == Axis::T;
      roles.Time = isOfAxis ? &variable : roles.Time;
    }
    if (!roles.Time)
    {
      Refuse(
        "the times of its axis '", this->File.Dimensions()[static_cast<std::size_t>(dimension)].Name, "' are missing");
    }
  }

  /// Terms of a vertical coordinate, as "s: s_rho C: Cs_r".
  std::map<std::string, std::string> TermsOf(const NetcdfVariable& variable) const
  {
    std::map<std::string, std::string> terms;
    std::string key;
    for (const std::string& word : WordsOf(this->Text(variable, "formula_terms")))
    {
      if (word.back() == ':')
      {
        key = word.substr(0, word.size() - 1);
      }
      else if (!key.empty())
      {
        terms[key] = word;
      }
    }
    return terms;
  }

  double ScalarOf(const std::string& name) const
  {
    const NetcdfVariable* variable = this->Named(name);
    const double value =
      variable && this->File.SizeOf(*variable) == 1 ? this->File.ReadAll(*variable)[0] : std::nan("");
    return value;
  }

  /// A term of the vertical coordinate: by the formula, else by the name that ROMS and FVCOM give it.
  const NetcdfVariable* Term(
    const std::map<std::string, std::string>& terms, const char* key, const char* name, bool isNeeded) const
  {
    const auto found = terms.find(key);
    const NetcdfVariable* variable = this->Named(found == terms.end() ? name : found->second);
    if (!variable && isNeeded)
    {
      Refuse("its levels ", this->Roles.S->Name, " lack their term '", key, "'",
        found == terms.end() ? std::string() : ": there is no variable " + found->second);
    }
    return variable;
  }

  const NetcdfVariable* LevelVariable() const
  {
    const OceanVariable& u = this->Roles.Velocity[0];
    const int dimension = this->DimensionOf(u, u.Axes.Z);
    const NetcdfVariable* found = this->CoordinatesOf(dimension);
    const std::string& name = this->File.Dimensions()[static_cast<std::size_t>(dimension)].Name;
    const NetcdfVariable* wide = found ? found : this->Named(name); // FVCOM's siglay has its nodes too
    for (const NetcdfVariable& variable : this->File.Variables())
    {
      const bool isOfAxis = !wide && variable.Dimensions.size() == 1 && variable.Dimensions[0] == dimension &&
        this->AxisOfAttributes(variable) == Axis::Z;
      wide = isOfAxis ? &variable : wide;
    }
    if (!wide)
    {
      Refuse("the levels of its axis '", name, "' are missing");
    }
    return wide;
  }

  void FindLevels()
  {
    OceanRoles& roles = this->Roles;
    if (roles.Velocity[0].Axes.Z < 0)
    {
      return;
    }
    roles.S = this->LevelVariable();
    const std::string name = this->StandardName(*roles.S);
    const std::string spelled = Lower(roles.S->Name);
    const bool isRoms = name.empty() && spelled == "s_rho";
    const bool isSigma = name == "ocean_sigma_coordinate" || (name.empty() && spelled.rfind("sig", 0) == 0);
    if (isSigma || isRoms || name.rfind("ocean_s", 0) == 0)
    {
      this->FindTerms(name, isSigma, isRoms);
      return;
    }
    Require(roles.S->Dimensions.size() == 1 ? "" : "its levels " + roles.S->Name + " have more than one axis");
    Require(
      name.rfind("ocean_", 0) == 0 ? "its levels " + roles.S->Name + " are of a kind that is not read: " + name : "");
    const std::string unit = this->Text(*roles.S, "units");
    const UnitOfLength* length = FindUnitOfLength(unit);
    if (!length)
    {
      Refuse("the unit '", unit, "' of its levels ", roles.S->Name, " is no length");
    }
    const std::string positive = Lower(this->Text(*roles.S, "positive"));
    roles.MetresPerHeight = length->Metres;
    roles.IsDownwards = positive.empty() ? name != "height" && name != "altitude" : positive == "down";
  }

  void FindTerms(const std::string& name, bool isSigma, bool isRoms)
  {
    OceanRoles& roles = this->Roles;
    const std::map<std::string, std::string> terms = this->TermsOf(*roles.S);
    roles.Surface = this->OnColumns(this->Term(terms, "eta", "zeta", true));
    roles.Depth = this->OnColumns(this->Term(terms, "depth", "h", true));
    if (isSigma)
    {
      roles.LevelsKind = LevelKind::Sigma;
      return;
    }
    const double transform = this->ScalarOf("Vtransform");
    if (name == "ocean_s_coordinate_g1" || (isRoms && transform == 1.0))
    {
      roles.LevelsKind = LevelKind::SCoordinate1;
    }
    else if (name == "ocean_s_coordinate_g2" || (isRoms && transform == 2.0))
    {
      roles.LevelsKind = LevelKind::SCoordinate2;
    }
    else if (name == "ocean_s_coordinate")
    {
      roles.LevelsKind = LevelKind::SOfHaidvogel;
    }
    else
    {
      Refuse("its levels ", roles.S->Name,
        " are of a kind that is not read: ", isRoms ? "Vtransform is neither 1 nor 2" : name);
    }
    const NetcdfVariable* critical = this->Term(terms, "depth_c", "hc", true);
    roles.CriticalDepth = this->ScalarOf(critical->Name);
    Require(roles.CriticalDepth >= 0.0 ? "" : "its critical depth " + critical->Name + " is no number of at least 0");
    const bool isHaidvogel = roles.LevelsKind == LevelKind::SOfHaidvogel;
    roles.Stretching = isHaidvogel ? nullptr : this->Term(terms, "C", "Cs_r", false);
    if (!roles.Stretching)
    {
      this->FindStretching(terms, isHaidvogel);
    }
  }

  void FindStretching(const std::map<std::string, std::string>& terms, bool isHaidvogel)
  {
    OceanRoles& roles = this->Roles;
    const NetcdfVariable* surface = this->Term(terms, "a", "theta_s", false);
    const NetcdfVariable* bottom = this->Term(terms, "b", "theta_b", false);
    const double function = isHaidvogel ? 1.0 : this->ScalarOf("Vstretching");
    if (!surface || !bottom || std::isnan(function))
    {
      Refuse("its levels ", roles.S->Name, " lack their term '", isHaidvogel ? "a" : "C",
        "', and Vstretching, theta_s and theta_b that it would follow from");
    }
    roles.Function = { static_cast<int>(std::clamp(function, 0.0, 9.0)), this->ScalarOf(surface->Name),
      this->ScalarOf(bottom->Name) };
    Require(roles.Function.Surface >= 0.0 && roles.Function.Bottom >= 0.0 && roles.Function.Surface < 100.0 &&
          roles.Function.Bottom < 100.0
        ? ""
        : "theta_s or theta_b of its levels is no number from 0 to 100");
  }

  /// A variable that has a value for each column of the grid, maybe at each time.
  OceanVariable OnColumns(const NetcdfVariable* variable) const
  {
    if (!variable)
    {
      return {};
    }
    const OceanVariable with = this->WithAxes(*variable);
    const OceanAxes& axes = with.Axes;
    const bool isMesh = !this->MeshDimensions.empty();
    const auto lengthOf = [&](int place) {
      return place < 0 ? 0 : this->File.LengthOf(*variable, static_cast<std::size_t>(place));
    };
    const bool isFit = isMesh ? axes.X >= 0 && this->DimensionOf(with, axes.X) == this->NodeDimension
                              : lengthOf(axes.X) == this->Lengths[0] && lengthOf(axes.Y) == this->Lengths[1];
    Require(isFit && axes.Z < 0 ? "" : "its " + variable->Name + " has not the grid of the velocities");
    return with;
  }

  /// The first variable of some names that has a value for each column.
  OceanVariable ColumnsNamed(const Names& names) const
  {
    for (const char* name : names)
    {
      const NetcdfVariable* variable = this->Named(name);
      OceanVariable with;
      const std::string why = WhyRefused([&] { with = this->OnColumns(variable); });
      if (variable && why.empty())
      {
        return with;
      }
    }
    return {};
  }

  void FindRest()
  {
    OceanRoles& roles = this->Roles;
    if (!roles.Depth)
    {
      const NetcdfVariable* standard = this->Standard(
        { "sea_floor_depth_below_geoid", "sea_floor_depth_below_sea_surface", "sea_floor_depth_below_mean_sea_level",
          "sea_floor_depth", "model_sea_floor_depth_below_geoid" },
        1);
      roles.Depth = this->ColumnsNamed(
        { standard ? standard->Name.c_str() : "h", "h", "deptho", "bathymetry", "Bathymetry", "depth" });
    }
    roles.Depth.Unit = this->UnitOfHeight(roles.Depth);
    roles.Surface.Unit = this->UnitOfHeight(roles.Surface);
    if (this->MeshDimensions.empty())
    {
      const NetcdfVariable* standard = this->Standard({ "sea_binary_mask" }, 2);
      roles.Mask = this->ColumnsNamed({ "mask_rho", standard ? standard->Name.c_str() : "mask", "mask" });
      roles.Angle =
        roles.Kind == OceanGridKind::Staggered || roles.IsAlongAxes ? this->ColumnsNamed({ "angle" }) : OceanVariable();
      const std::string unit = roles.Angle ? Lower(this->Text(*roles.Angle.Variable, "units")) : "";
      roles.Angle.Unit = unit.rfind("degree", 0) == 0 ? Pi / 180.0 : 1.0;
    }
  }

  double UnitOfHeight(const OceanVariable& variable) const
  {
    const std::string unit = variable ? this->Text(*variable.Variable, "units") : "";
    const UnitOfLength* length = unit.empty() ? nullptr : FindUnitOfLength(unit);
    if (!unit.empty() && !length)
    {
      Refuse("the unit '", unit, "' of its ", variable.Variable->Name, " is no length");
    }
    return length ? length->Metres : 1.0;
  }

  const NetcdfFile& File;
  const OceanChoices& Choices;
  OceanRoles Roles;
  const NetcdfVariable* Topology = nullptr;
  std::vector<int> MeshDimensions; ///< of faces and nodes
  int FaceDimension = -1;
  int NodeDimension = -1;
  std::array<std::size_t, 2> Lengths{ 0, 0 }; ///< of the grid of columns, along X and Y
};

}

OceanRoles FindOceanRoles(const NetcdfFile& file, const OceanChoices& choices)
{
  return Search(file, choices).Find();
}

bool HasOceanVelocities(const NetcdfFile& file)
{
  return Search(file, {}).HasVelocities();
}

}
