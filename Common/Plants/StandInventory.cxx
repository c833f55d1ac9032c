// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/StandInventory.h"

#include "Numerics/Constants.h"
#include "Numerics/InvalidInput.h"
#include "Numerics/ParameterCheck.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace littoral
{

namespace
{

constexpr double PlotGap = 20.0; // between plots that are set in a row [m]
// Limits of the dimensions of a stand.
constexpr double MaximumDiameter = 12.0;     // of the thickest tree on record, 11.6 m [m]
constexpr double MaximumHeight = 130.0;      // the tallest on record has 116 m [m]
constexpr double ThickestMiddle = 2.5;       // median diameter [m]
constexpr double ThinnestMiddle = 0.002;     // [m]
constexpr double TallestMiddle = 90.0;       // median height [m]
constexpr double LowestMiddle = 0.3;         // [m]
constexpr double MaximumSlenderness = 400.0; // median of height over diameter
constexpr double MinimumSlenderness = 8.0;
constexpr double DensestStand = 20.0; // trees a square metre
constexpr std::size_t MinimumTreesForDensity = 20;
constexpr double FarthestPlace = 1e8; // [m]

struct UnitWord
{
  const char* Word;
  LengthUnit Unit;
};

constexpr UnitWord UnitWords[] = { { "m", LengthUnit::Metre }, { "metre", LengthUnit::Metre },
  { "metres", LengthUnit::Metre }, { "meters", LengthUnit::Metre }, { "cm", LengthUnit::Centimetre },
  { "mm", LengthUnit::Millimetre }, { "ft", LengthUnit::Foot }, { "feet", LengthUnit::Foot },
  { "in", LengthUnit::Inch }, { "inch", LengthUnit::Inch }, { "inches", LengthUnit::Inch } };

constexpr const char* UnitNames[] = { "the unit of its name", "m", "cm", "mm", "ft", "in" };
static_assert(std::size(UnitNames) == NumberOfLengthUnits, "a name a unit");

/// A name of a column in two: what it is called, and the unit behind it.
std::pair<std::string, LengthUnit> NameAndUnit(const std::string& name)
{
  const std::size_t cut = name.find_last_of(" _.([");
  if (cut != std::string::npos && cut > 0)
  {
    const std::string last = PlainWord(name.substr(cut));
    for (const UnitWord& unit : UnitWords)
    {
      if (last == unit.Word)
      {
        return { PlainWord(name.substr(0, cut)), unit.Unit };
      }
    }
  }
  return { PlainWord(name), LengthUnit::Named };
}

/// A column that was found.
struct FoundColumn
{
  int Index = -1;
  LengthUnit Unit = LengthUnit::Named; ///< by its name
};

std::string NamesOf(const TextTable& table)
{
  std::string names;
  for (const std::string& name : table.Names)
  {
    names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

/// Finds columns by the names that are known, or by the one that is asked for.
class ColumnFinder
{
public:
  explicit ColumnFinder(const TextTable& table)
    : Table(table)
  {
  }

  FoundColumn Find(const std::string& asked, std::initializer_list<const char*> known)
  {
    for (std::size_t column = 0; !asked.empty() && column < this->Table.Names.size(); ++column)
    {
      if (this->Table.Names[column] == asked)
      {
        return { static_cast<int>(column), NameAndUnit(asked).second };
      }
    }
    if (!asked.empty())
    {
      Refuse("there is no column '", asked, "'; the table has ", NamesOf(this->Table), ".");
    }
    for (const char* name : known)
    {
      for (std::size_t column = 0; column < this->Table.Names.size(); ++column)
      {
        const auto [word, unit] = NameAndUnit(this->Table.Names[column]);
        if (word == name)
        {
          return { static_cast<int>(column), unit };
        }
      }
    }
    return {};
  }

private:
  const TextTable& Table;
};

/// The columns of an inventory, and the units of its numbers.
struct Layout
{
  FoundColumn X;
  FoundColumn Y;
  FoundColumn Genus; ///< of a species in two columns
  FoundColumn Species;
  FoundColumn Diameter;
  FoundColumn Height;
  FoundColumn Plot;
  FoundColumn Status;
  FoundColumn Tree;
  bool IsForestGeo = false;
  double OfDiameter = 1.0; ///< diameter over what the column of diameters has: 1 / pi of a girth

  Layout(const TextTable& table, const InventoryColumns& columns)
  {
    ColumnFinder finder(table);
    this->X = finder.Find(columns.X, { "x", "gx", "px", "easting", "xcoord", "xcoordinate", "xutm", "utmx" });
    this->Y = finder.Find(columns.Y, { "y", "gy", "py", "northing", "ycoord", "ycoordinate", "yutm", "utmy" });
    this->Species = finder.Find(
      columns.Species, { "species", "sp", "spp", "spcode", "mnemonic", "latin", "latinname", "scientificname" });
    this->Genus = columns.Species.empty() ? finder.Find("", { "genus" }) : FoundColumn();
    this->Diameter = finder.Find(columns.Diameter, { "dbh", "diameter", "diam", "d130", "d" });
    if (this->Diameter.Index < 0)
    {
      this->Diameter = finder.Find("", { "gbh", "cbh", "girth", "circumference" });
      this->OfDiameter = this->Diameter.Index < 0 ? 1.0 : 1.0 / Pi;
    }
    this->Height = finder.Find(columns.Height, { "height", "ht", "totalheight", "treeheight", "h" });
    this->Plot = finder.Find(columns.Plot, { "plot", "plotid", "plotname", "plotcode" });
    this->Status = finder.Find("", { "status", "dfstatus" });
    this->Tree = finder.Find("", { "treeid", "tag", "treetag" });
    this->IsForestGeo = (table.ColumnOf("gx") >= 0 && table.ColumnOf("gy") >= 0) ||
      (table.ColumnOf("px") >= 0 && table.ColumnOf("py") >= 0);
    if (this->X.Index < 0 || this->Y.Index < 0)
    {
      Refuse("there are no columns x and y, or gx and gy; the table has ", NamesOf(table),
        ". Name the columns of the places.");
    }
    const std::string strange = this->HasTrees() ? std::string() : this->StrangeNames(table);
    if (!strange.empty())
    {
      Refuse("none of ", strange,
        " is known as a species, a diameter or a height. Name the columns that are, or leave all of them out.");
    }
  }

private:
  /// Whether anything but places is known of the trees.
  bool HasTrees() const
  {
    return this->Species.Index >= 0 || this->Genus.Index >= 0 || this->Diameter.Index >= 0 || this->Height.Index >= 0;
  }

  /// Names of columns that nothing is read from.
  std::string StrangeNames(const TextTable& table) const
  {
    const std::array<int, 5> read{ this->X.Index, this->Y.Index, this->Plot.Index, this->Status.Index,
      this->Tree.Index };
    std::string names;
    for (int column = 0; column < static_cast<int>(table.Names.size()); ++column)
    {
      const std::string& name = table.Names[static_cast<std::size_t>(column)];
      const bool isNumber = name.empty() || NameAndUnit(name).first == "id"; // of the row
      if (!isNumber && std::find(read.begin(), read.end(), column) == read.end())
      {
        names += (names.empty() ? "" : ", ") + name;
      }
    }
    return names;
  }
};

/// The unit of a column: as told, as its name says, or the usual one.
LengthUnit UnitOf(LengthUnit told, const FoundColumn& column, LengthUnit usual)
{
  return told != LengthUnit::Named ? told : column.Unit != LengthUnit::Named ? column.Unit : usual;
}

/// Whether a status says that a tree lives, in the words of ForestGEO and others.
bool IsAlive(const std::string& status)
{
  static const std::set<std::string> dead{ "d", "dead", "m", "missing", "g", "gone", "p", "prior", "stemdead",
    "stemgone", "loststem", "brokenbelow", "dc", "dn", "ds", "cut", "fallen" };
  return dead.count(PlainWord(status)) == 0;
}

/// A cell as words; empty where there is no column.
const std::string& CellOf(const TextTable& table, const FoundColumn& column, std::size_t row)
{
  static const std::string none;
  return column.Index < 0 ? none : table.Columns[column.Index][row];
}

/// A length of a cell [m], NaN where there is none.
double LengthIn(const TextTable& table, const FoundColumn& column, std::size_t row, double metres)
{
  double number = std::numeric_limits<double>::quiet_NaN();
  const std::string& word = CellOf(table, column, row);
  if (column.Index >= 0 && !ReadNumber(word, number))
  {
    Refuse("row ", row + 1, " has '", word, "' for ", table.Names[column.Index], ", which is no number",
      word.find(',') == std::string::npos ? "." : "; a decimal comma must be a point.");
  }
  return metres * number;
}

/// A measure that is 0 was not taken; below 0 it is wrong.
double Measure(double length, const char* name, std::size_t row)
{
  if (length < 0.0)
  {
    Refuse(name, " of row ", row + 1, " is ", TextOf(length), " m; it must be positive.");
  }
  return length > 0.0 ? length : std::numeric_limits<double>::quiet_NaN();
}

double Median(std::vector<double> numbers)
{
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

/// The numbers of trees that are known.
template <typename ValueOf>
std::vector<double> Known(const std::vector<StandTree>& trees, const ValueOf& valueOf)
{
  std::vector<double> known;
  for (const StandTree& tree : trees)
  {
    const double value = valueOf(tree);
    if (std::isfinite(value))
    {
      known.push_back(value);
    }
  }
  return known;
}

/// Refuses lengths that must be in another unit than told.
void RequirePlausible(const char* name, const char* property, LengthUnit unit, const std::vector<double>& known,
  double lowest, double highest, double largest)
{
  if (known.empty())
  {
    return;
  }
  const double middle = Median(known);
  const double most = *std::max_element(known.begin(), known.end());
  if (middle >= lowest && middle <= highest && most <= largest)
  {
    return;
  }
  const int told = static_cast<int>(unit);
  std::string others;
  for (int other = 1; other < NumberOfLengthUnits; ++other)
  {
    const double factor = MetresOf(static_cast<LengthUnit>(other)) / MetresOf(unit);
    const bool fits = factor * middle >= lowest && factor * middle <= highest && factor * most <= largest;
    others += fits ? (others.empty() ? " " : " or ") + std::string(UnitNames[other]) : "";
  }
  Refuse(name, " in ", UnitNames[told], " would have a median of ", TextOf(middle), " m and a maximum of ",
    TextOf(most), " m, which is no stand of trees; set ", property, others.empty() ? "." : ", to" + others + ".");
}

void RequirePlausible(const StandInventory& stand, LengthUnit diameters, LengthUnit heights)
{
  RequirePlausible("DBH", "DiameterUnit", diameters,
    Known(stand.Trees, [](const StandTree& tree) { return tree.Diameter; }), ThinnestMiddle, ThickestMiddle,
    MaximumDiameter);
  RequirePlausible("height", "HeightUnit", heights,
    Known(stand.Trees, [](const StandTree& tree) { return tree.Height; }), LowestMiddle, TallestMiddle, MaximumHeight);
  const std::vector<double> slenderness =
    Known(stand.Trees, [](const StandTree& tree) { return tree.Height / tree.Diameter; });
  const double middle = slenderness.empty() ? MinimumSlenderness : Median(slenderness);
  if (middle < MinimumSlenderness || middle > MaximumSlenderness)
  {
    Refuse("half of the trees are ", middle < MinimumSlenderness ? "less" : "more", " than ",
      TextOf(std::floor(middle)), " times as high as thick; the units of DBH (", UnitNames[static_cast<int>(diameters)],
      ") and height (", UnitNames[static_cast<int>(heights)],
      ") do not fit each other: set DiameterUnit or HeightUnit.");
  }
}

/// The rectangle around some trees.
struct Rectangle
{
  double Low[2] = { 1e300, 1e300 };
  double High[2] = { -1e300, -1e300 };

  void Add(const StandTree& tree)
  {
    const double place[2] = { tree.X, tree.Y };
    for (int axis = 0; axis < 2; ++axis)
    {
      this->Low[axis] = std::min(this->Low[axis], place[axis]);
      this->High[axis] = std::max(this->High[axis], place[axis]);
    }
  }

  bool Overlaps(const Rectangle& other) const
  {
    return this->Low[0] <= other.High[0] && other.Low[0] <= this->High[0] && this->Low[1] <= other.High[1] &&
      other.Low[1] <= this->High[1];
  }
};

std::vector<Rectangle> RectanglesOf(const StandInventory& stand)
{
  std::vector<Rectangle> rectangles(stand.Plots.size());
  for (const StandTree& tree : stand.Trees)
  {
    rectangles[tree.Plot].Add(tree);
  }
  return rectangles;
}

/// Sets plots that overlap in a row along x.
void SetApart(StandInventory& stand)
{
  const std::vector<Rectangle> plots = RectanglesOf(stand);
  bool isOver = false;
  for (std::size_t one = 0; one < plots.size(); ++one)
  {
    for (std::size_t other = 0; other < one; ++other)
    {
      isOver |= plots[one].Overlaps(plots[other]);
    }
  }
  if (!isOver)
  {
    return;
  }
  std::vector<double> shifts;
  double next = plots.front().Low[0];
  for (const Rectangle& plot : plots)
  {
    shifts.push_back(next - plot.Low[0]);
    next += plot.High[0] - plot.Low[0] + PlotGap;
  }
  for (StandTree& tree : stand.Trees)
  {
    tree.X += shifts[tree.Plot];
    tree.Y += plots.front().Low[1] - plots[tree.Plot].Low[1];
  }
}

/// Keeps the thickest of the stems of one tree. Other trees must not stand at one place unless that is allowed.
void JoinStems(const std::vector<std::string>& identities, bool allowed, StandInventory& stand)
{
  std::map<std::tuple<double, double, int>, std::size_t> first;
  std::vector<StandTree> kept;
  for (const StandTree& tree : stand.Trees)
  {
    const auto [found, isNew] = first.emplace(std::tuple(tree.X, tree.Y, tree.Plot), kept.size());
    if (isNew)
    {
      kept.push_back(tree);
      continue;
    }
    StandTree& other = kept[found->second];
    const bool isSame =
      !identities.empty() && !identities[tree.Row].empty() && identities[tree.Row] == identities[other.Row];
    if (isSame)
    {
      ++stand.Dropped;
      other = !(tree.Diameter <= other.Diameter) && std::isfinite(tree.Diameter) ? tree : other;
    }
    else if (allowed)
    {
      kept.push_back(tree);
    }
    else
    {
      Refuse("rows ", other.Row + 1, " and ", tree.Row + 1, " stand at the same place (", TextOf(tree.X), ", ",
        TextOf(tree.Y), ") m; remove one, give stems of one tree the same treeID, or set AllowCoincident.");
    }
  }
  stand.Trees = std::move(kept);
}

void RequireRoom(const StandInventory& stand)
{
  const double area = AreaOf(stand);
  const double density = static_cast<double>(stand.Trees.size()) / area;
  if (stand.Trees.size() >= MinimumTreesForDensity && density > DensestStand)
  {
    Refuse(stand.Trees.size(), " trees on ", TextOf(area),
      " m2 are no stand; set CoordinateScale or CoordinateUnit, as of a plot on a unit square. Degrees must be "
      "projected to metres.");
  }
}

/// Reads the rows, one by one.
class RowReader
{
public:
  RowReader(
    const TextTable& table, const StandSpeciesTable& species, const InventoryOptions& options, StandInventory& stand)
    : Table(table)
    , Species(species)
    , Options(options)
    , Stand(stand)
    , Columns(table, options.Columns)
    , Diameters(UnitOf(options.DiameterUnit, this->Columns.Diameter,
        this->Columns.IsForestGeo ? LengthUnit::Millimetre : LengthUnit::Centimetre))
    , Heights(UnitOf(options.HeightUnit, this->Columns.Height, LengthUnit::Metre))
  {
  }

  LengthUnit GetDiameterUnit() const { return this->Diameters; }
  LengthUnit GetHeightUnit() const { return this->Heights; }
  const Layout& GetColumns() const { return this->Columns; }

  void Read(std::size_t row)
  {
    StandTree tree;
    tree.Row = static_cast<long long>(row);
    const std::string& plot = CellOf(this->Table, this->Columns.Plot, row);
    if ((!this->Options.Plot.empty() && plot != this->Options.Plot) ||
      (!this->Options.KeepDead && !IsAlive(CellOf(this->Table, this->Columns.Status, row))))
    {
      ++this->Stand.Dropped;
      return;
    }
    tree.X = this->PlaceIn(this->Columns.X, row);
    tree.Y = this->PlaceIn(this->Columns.Y, row);
    const double unit = this->Columns.OfDiameter * MetresOf(this->Diameters);
    tree.Diameter = Measure(LengthIn(this->Table, this->Columns.Diameter, row, unit), "DBH", row);
    tree.Height = Measure(LengthIn(this->Table, this->Columns.Height, row, MetresOf(this->Heights)), "Height", row);
    tree.Name = this->NameIn(row);
    tree.Species = this->Species.RowOf(tree.Name, this->Options.DefaultSpecies);
    if (!tree.Name.empty() && !this->Species.Has(tree.Name) && this->Met.insert(tree.Name).second)
    {
      this->Stand.Unlisted.push_back(tree.Name);
    }
    const auto [found, isNew] = this->Plots.emplace(plot, static_cast<int>(this->Stand.Plots.size()));
    tree.Plot = found->second;
    if (isNew)
    {
      this->Stand.Plots.push_back(plot);
    }
    this->Stand.Trees.push_back(tree);
  }

private:
  const TextTable& Table;
  const StandSpeciesTable& Species;
  const InventoryOptions& Options;
  StandInventory& Stand;
  Layout Columns;
  LengthUnit Diameters;
  LengthUnit Heights;
  std::map<std::string, int> Plots;
  std::set<std::string> Met;

  /// The species, with its genus where that has a column of its own.
  std::string NameIn(std::size_t row) const
  {
    const std::string& genus = CellOf(this->Table, this->Columns.Genus, row);
    const std::string& species = CellOf(this->Table, this->Columns.Species, row);
    return genus.empty() || species.empty() ? genus + species : genus + " " + species;
  }

  double PlaceIn(const FoundColumn& column, std::size_t row) const
  {
    const double metres = MetresOf(UnitOf(this->Options.CoordinateUnit, column, LengthUnit::Metre));
    const double place = LengthIn(this->Table, column, row, this->Options.CoordinateScale * metres);
    if (!(std::abs(place) <= FarthestPlace))
    {
      Refuse("row ", row + 1, " has no place: its ", this->Table.Names[column.Index], " is '",
        CellOf(this->Table, column, row), "'.");
    }
    return place;
  }
};

/// Why the options cannot be; empty if they can.
std::string WhyInvalid(const InventoryOptions& options, const StandSpeciesTable& species)
{
  ParameterCheck check;
  check.Choice("CoordinateUnit", static_cast<int>(options.CoordinateUnit), NumberOfLengthUnits);
  check.Choice("DiameterUnit", static_cast<int>(options.DiameterUnit), NumberOfLengthUnits);
  check.Choice("HeightUnit", static_cast<int>(options.HeightUnit), NumberOfLengthUnits);
  check.Positive("CoordinateScale", options.CoordinateScale);
  check.NotNegative("QuadraticMeanDiameter", options.QuadraticMeanDiameter, "m", ThickestMiddle);
  check.Range("HeightVariation", options.HeightVariation, 0.0, 0.4);
  check.Count("DiameterClasses", options.DiameterClasses, 1, MaximumDiameterClasses);
  check.Require(species.Has(options.DefaultSpecies),
    "DefaultSpecies is '" + options.DefaultSpecies + "', which is not in the table of species.");
  return check.Reason();
}

}

double MetresOf(LengthUnit unit)
{
  constexpr double metres[] = { 0.0, 1.0, 0.01, 0.001, 0.3048, 0.0254 };
  static_assert(std::size(metres) == NumberOfLengthUnits, "a length a unit");
  return metres[static_cast<int>(unit)];
}

double AreaOf(const StandInventory& stand)
{
  const std::vector<Rectangle> plots = RectanglesOf(stand);
  std::vector<double> trees(plots.size(), 0.0);
  for (const StandTree& tree : stand.Trees)
  {
    trees[tree.Plot] += 1.0;
  }
  double area = 0.0;
  for (std::size_t plot = 0; plot < plots.size(); ++plot)
  {
    // A side of n^(1/2) spacings, of which the outermost trees are one fewer apart.
    const double wider = 1.0 + 1.0 / std::max(1.0, std::sqrt(trees[plot]));
    const double width = wider * (plots[plot].High[0] - plots[plot].Low[0]);
    const double depth = wider * (plots[plot].High[1] - plots[plot].Low[1]);
    const double least = 1e-3 * std::max({ width, depth, 1.0 });
    area += trees[plot] > 0.0 ? std::max(width, least) * std::max(depth, least) : 0.0;
  }
  return area;
}

StandInventory ReadInventory(const TextTable& table, const StandSpeciesTable& species, const InventoryOptions& options)
{
  StandInventory stand;
  Require(WhyInvalid(options, species));
  RowReader rows(table, species, options, stand);
  for (std::size_t row = 0; row < table.NumberOfRows(); ++row)
  {
    rows.Read(row);
  }
  Require(table.NumberOfRows() == 0 ? "the table has no rows." : "");
  if (stand.Trees.empty())
  {
    Refuse("none of the ", table.NumberOfRows(), " rows is a living tree",
      options.Plot.empty() ? "." : " of the plot '" + options.Plot + "'.");
  }
  const int tree = rows.GetColumns().Tree.Index;
  JoinStems(tree < 0 ? std::vector<std::string>() : table.Columns[tree], options.AllowCoincident, stand);
  RequirePlausible(stand, rows.GetDiameterUnit(), rows.GetHeightUnit());
  RequireRoom(stand);
  SetApart(stand);
  return stand;
}

}
