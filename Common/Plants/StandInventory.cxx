// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/StandInventory.h"

#include "Numerics/Constants.h"
#include "Numerics/InvalidInput.h"
#include "Numerics/MissingCodes.h"
#include "Numerics/ParameterCheck.h"
#include "Plants/StandPlausibility.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace littoral
{

namespace
{

constexpr double PlotGap = 20.0;        // between plots that are set in a row [m]
constexpr double StemsOfTree = 2.0;     // to which the stems of one tree stand apart [m]
constexpr double ThickestMean = 2.5;    // quadratic mean diameter of a stand [m]
constexpr double TallestLikely = 130.0; // height that is no code for a missing one [m]
constexpr double DensestStand = 20.0;   // trees a square metre
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

std::string Joined(const std::vector<std::string>& names)
{
  std::string all;
  for (const std::string& name : names)
  {
    all += (all.empty() ? "" : ", ") + name;
  }
  return all;
}

std::string NamesOf(const TextTable& table)
{
  return Joined(table.Names);
}

/// A name of a column that says no column.
constexpr const char* NoColumn = "-";

/// Kind of a column: the property that names it, the known names, and parts of names that are like these.
struct ColumnKind
{
  const char* Property; ///< null: by known names alone
  const char* Words;    ///< of what it has
  std::vector<const char*> Known;
  std::vector<const char*> Parts;    ///< anywhere in a name
  std::vector<const char*> Prefixes; ///< at its begin
};

const ColumnKind Diameters{ "DiameterColumn", "diameters", { "dbh", "diameter", "diam", "dia", "d130", "d" },
  { "dbh", "diam", "girth", "circumf", "gbh", "cbh", "bhd" }, { "dia", "dap" } };
const ColumnKind Girths{ "DiameterColumn", "girths", { "gbh", "cbh", "girth", "circumference" }, {}, {} };
const ColumnKind Heights{ "HeightColumn", "heights", { "height", "ht", "totalheight", "treeheight", "h" },
  { "height", "hoehe", "h\xc3\xb6he", "hauteur", "altura" }, { "ht" } };

/// Columns by the names that are known, or by the one that is asked for.
class ColumnFinder
{
public:
  explicit ColumnFinder(const TextTable& table)
    : Table(table)
    , IsRead(table.Names.size(), false)
  {
  }

  FoundColumn Find(const std::string& asked, const ColumnKind& kind)
  {
    const FoundColumn found = asked.empty() ? this->Known(kind) : this->Asked(asked);
    if (found.Index >= 0)
    {
      this->IsRead[static_cast<std::size_t>(found.Index)] = true;
    }
    return found;
  }

  /// Refuses to go on without a column while the names of others look like it.
  void AskFor(const ColumnKind& kind) const
  {
    std::string names;
    for (const std::string& name : this->Unread())
    {
      names += IsLike(PlainWord(name), kind) ? (names.empty() ? "" : ", ") + name : "";
    }
    if (!names.empty())
    {
      Refuse("set ", kind.Property, ": ", names, " may be ", kind.Words, ".");
    }
  }

  /// Names of columns that nothing is read from, without numbers of rows.
  std::vector<std::string> Unread() const
  {
    std::vector<std::string> names;
    for (std::size_t column = 0; column < this->IsRead.size(); ++column)
    {
      const std::string& name = this->Table.Names[column];
      if (!this->IsRead[column] && !name.empty() && NameAndUnit(name).first != "id")
      {
        names.push_back(name);
      }
    }
    return names;
  }

private:
  const TextTable& Table;
  std::vector<bool> IsRead;

  FoundColumn Asked(const std::string& asked) const
  {
    if (asked == NoColumn)
    {
      return {};
    }
    const auto found = std::find(this->Table.Names.begin(), this->Table.Names.end(), asked);
    if (found == this->Table.Names.end())
    {
      Refuse("there is no column '", asked, "'; the table has ", NamesOf(this->Table), ".");
    }
    return { static_cast<int>(found - this->Table.Names.begin()), NameAndUnit(asked).second };
  }

  /// The column of the first known name that there is; two of one name but of other units must be told apart.
  FoundColumn Known(const ColumnKind& kind) const
  {
    for (const char* name : kind.Known)
    {
      FoundColumn found;
      for (std::size_t column = 0; column < this->Table.Names.size(); ++column)
      {
        const auto [word, unit] = NameAndUnit(this->Table.Names[column]);
        if (word != name)
        {
          continue;
        }
        if (found.Index >= 0 && kind.Property)
        {
          Refuse("set ", kind.Property, ": both ", this->Table.Names[static_cast<std::size_t>(found.Index)], " and ",
            this->Table.Names[column], " may be ", kind.Words, ".");
        }
        found = found.Index >= 0 ? found : FoundColumn{ static_cast<int>(column), unit };
      }
      if (found.Index >= 0)
      {
        return found;
      }
    }
    return {};
  }

  /// Whether a plain name may be that of a kind: no height of a crown or of a measurement.
  static bool IsLike(const std::string& name, const ColumnKind& kind)
  {
    const auto has = [&name](const char* part) { return name.find(part) != std::string::npos; };
    const auto begins = [&name](const char* part) { return name.rfind(part, 0) == 0; };
    const bool isOther = has("crown") || has("canopy") || has("base") || has("meas");
    return !isOther &&
      (std::any_of(kind.Parts.begin(), kind.Parts.end(), has) ||
        std::any_of(kind.Prefixes.begin(), kind.Prefixes.end(), begins));
  }
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
  std::vector<std::string> Unread; ///< names of the others
  bool IsForestGeo = false;
  double OfDiameter = 1.0; ///< diameter over what the column of diameters has: 1 / pi of a girth

  Layout(const TextTable& table, const InventoryColumns& columns)
  {
    ColumnFinder finder(table);
    this->X = finder.Find(
      columns.X, { "XColumn", "x", { "x", "gx", "px", "easting", "xcoord", "xcoordinate", "xutm", "utmx" }, {}, {} });
    this->Y = finder.Find(
      columns.Y, { "YColumn", "y", { "y", "gy", "py", "northing", "ycoord", "ycoordinate", "yutm", "utmy" }, {}, {} });
    this->Species = finder.Find(columns.Species,
      { "SpeciesColumn", "species",
        { "species", "sp", "spp", "spcode", "mnemonic", "latin", "latinname", "scientificname" }, {}, {} });
    this->Genus = columns.Species.empty() ? finder.Find("", { nullptr, "genus", { "genus" }, {}, {} }) : FoundColumn();
    this->Diameter = finder.Find(columns.Diameter, Diameters);
    if (this->Diameter.Index < 0 && columns.Diameter.empty())
    {
      this->Diameter = finder.Find("", Girths);
      this->OfDiameter = this->Diameter.Index < 0 ? 1.0 : 1.0 / Pi;
    }
    this->Height = finder.Find(columns.Height, Heights);
    this->Plot =
      finder.Find(columns.Plot, { "PlotColumn", "plots", { "plot", "plotid", "plotname", "plotcode" }, {}, {} });
    this->Status = finder.Find("", { nullptr, "status", { "status", "dfstatus" }, {}, {} });
    this->Tree = finder.Find("", { nullptr, "trees", { "treeid", "tag", "treetag" }, {}, {} });
    this->IsForestGeo = (table.ColumnOf("gx") >= 0 && table.ColumnOf("gy") >= 0) ||
      (table.ColumnOf("px") >= 0 && table.ColumnOf("py") >= 0);
    this->Unread = finder.Unread();
    this->Check(table, columns, finder);
  }

private:
  void Check(const TextTable& table, const InventoryColumns& columns, const ColumnFinder& finder) const
  {
    if (this->X.Index < 0 || this->Y.Index < 0)
    {
      if (table.Names.size() == 1 && table.Names.front().find_first_of(";\t,") != std::string::npos)
      {
        Refuse("open the file as Text Table: its only column is '", table.Names.front(), "'.");
      }
      Refuse("there are no columns x and y, or gx and gy; the table has ", NamesOf(table),
        ". Name the columns of the places.");
    }
    if (this->Diameter.Index < 0 && columns.Diameter.empty())
    {
      finder.AskFor(Diameters);
    }
    if (this->Height.Index < 0 && columns.Height.empty())
    {
      finder.AskFor(Heights);
    }
    if (!this->HasTrees() && !this->Unread.empty())
    {
      Refuse("none of ", Joined(this->Unread),
        " is known as a species, a diameter or a height. Name the columns that are, or leave all of them out.");
    }
  }

  /// Whether anything but places is known of the trees.
  bool HasTrees() const
  {
    return this->Species.Index >= 0 || this->Genus.Index >= 0 || this->Diameter.Index >= 0 || this->Height.Index >= 0;
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
      word.find(',') == std::string::npos ? "." : ", or two; write it without a comma.");
  }
  return metres * number;
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

/// Keeps the thickest of the stems of one tree, which have its name and stand close together.
void JoinStems(const std::vector<std::string>& identities, StandInventory& stand)
{
  if (identities.empty())
  {
    return;
  }
  std::map<std::pair<std::string, int>, std::vector<std::size_t>> known; // places among those kept
  std::vector<StandTree> kept;
  for (const StandTree& tree : stand.Trees)
  {
    const std::string& identity = identities[tree.Row];
    std::vector<std::size_t>& others = known[{ identity, tree.Plot }];
    const auto same = identity.empty() ? others.end() : std::find_if(others.begin(), others.end(), [&](std::size_t at) {
      return std::hypot(tree.X - kept[at].X, tree.Y - kept[at].Y) <= StemsOfTree;
    });
    if (same == others.end())
    {
      others.push_back(kept.size());
      kept.push_back(tree);
      continue;
    }
    StandTree& other = kept[*same];
    ++stand.Dropped;
    other = !(tree.Diameter <= other.Diameter) && std::isfinite(tree.Diameter) ? tree : other;
  }
  stand.Trees = std::move(kept);
}

/// Refuses two trees at one place.
void RequireApart(const StandInventory& stand)
{
  std::map<std::tuple<double, double, int>, std::size_t> first;
  for (const StandTree& tree : stand.Trees)
  {
    const auto [found, isNew] = first.emplace(std::tuple(tree.X, tree.Y, tree.Plot), tree.Row);
    if (!isNew)
    {
      Refuse("rows ", found->second + 1, " and ", tree.Row + 1, " stand at the same place (", TextOf(tree.X), ", ",
        TextOf(tree.Y), ") m; remove one, give stems of one tree the same treeID, or set AllowCoincident.");
    }
  }
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
    , DiameterCodes(this->CodesIn(this->Columns.Diameter, LargestLikely(this->NumbersIn(this->Columns.Diameter))))
    , HeightCodes(this->CodesIn(this->Columns.Height, TallestLikely / MetresOf(this->Heights)))
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
    tree.Diameter = this->MeasureIn(this->Columns.Diameter, this->DiameterCodes, this->MetresOfDiameter(), row);
    tree.Height = this->MeasureIn(this->Columns.Height, this->HeightCodes, MetresOf(this->Heights), row);
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
  std::set<double> DiameterCodes; ///< for missing values, as written in the table
  std::set<double> HeightCodes;
  std::map<std::string, int> Plots;
  std::set<std::string> Met;

  double MetresOfDiameter() const { return this->Columns.OfDiameter * MetresOf(this->Diameters); }

  /// Numbers of a column, without words.
  std::vector<double> NumbersIn(const FoundColumn& column) const
  {
    std::vector<double> numbers;
    for (std::size_t row = 0; column.Index >= 0 && row < this->Table.NumberOfRows(); ++row)
    {
      double number = 0.0;
      if (ReadNumber(CellOf(this->Table, column, row), number))
      {
        numbers.push_back(number);
      }
    }
    return numbers;
  }

  /// Largest likely diameter of a tree of a column, in the unit of the column.
  double LargestLikely(std::vector<double> numbers) const
  {
    for (double& number : numbers)
    {
      number *= this->MetresOfDiameter();
    }
    return LargestLikelyDiameter(std::move(numbers)) / this->MetresOfDiameter();
  }

  /// Codes for missing values in a column, of which the stand keeps the names.
  std::set<double> CodesIn(const FoundColumn& column, double largestLikely)
  {
    std::set<double> codes = MissingCodes(this->NumbersIn(column), largestLikely);
    if (this->Options.AllowImplausible)
    {
      codes.erase(codes.upper_bound(0.0), codes.end());
    }
    for (const double code : codes)
    {
      this->Stand.MissingCodes.push_back(this->Table.Names[column.Index] + " " + TextOf(code));
    }
    return codes;
  }

  /// A positive length [m]; NaN where it was not measured, which 0 and codes say too.
  double MeasureIn(const FoundColumn& column, const std::set<double>& codes, double metres, std::size_t row) const
  {
    const double number = LengthIn(this->Table, column, row, 1.0);
    const bool isMissing = std::isnan(number) || number == 0.0 || codes.count(number) > 0;
    const double length = metres * number;
    if (!isMissing && !(length > 0.0 && IsSensible(length)))
    {
      Refuse(this->Table.Names[column.Index], " of row ", row + 1, " is ", TextOf(length), " m; it must be ",
        number < 0.0 ? "positive." : "the length of a tree.");
    }
    return isMissing ? std::numeric_limits<double>::quiet_NaN() : length;
  }

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
  check.NotNegative("QuadraticMeanDiameter", options.QuadraticMeanDiameter, "m", ThickestMean);
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

const char* NameOf(LengthUnit unit)
{
  constexpr const char* names[] = { "the unit of its name", "m", "cm", "mm", "ft", "in" };
  static_assert(std::size(names) == NumberOfLengthUnits, "a name a unit");
  return names[static_cast<int>(unit)];
}

double AreaOf(const StandInventory& stand, double narrowest)
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
    // E of a side of n random places is (n - 1) / (n + 1) of the plot's.
    const double wider = (trees[plot] + 1.0) / std::max(1.0, trees[plot] - 1.0);
    const double width = wider * (plots[plot].High[0] - plots[plot].Low[0]);
    const double depth = wider * (plots[plot].High[1] - plots[plot].Low[1]);
    const double least = narrowest * std::max({ width, depth, 1.0 });
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
  stand.Unread = rows.GetColumns().Unread;
  const int tree = rows.GetColumns().Tree.Index;
  JoinStems(tree < 0 ? std::vector<std::string>() : table.Columns[tree], stand);
  if (!options.AllowCoincident)
  {
    RequireApart(stand);
  }
  RequireRoom(stand);
  RequirePlausible(stand, rows.GetDiameterUnit(), rows.GetHeightUnit(), options);
  if (!options.AllowImplausible)
  {
    RequireNear(stand);
  }
  SetApart(stand);
  return stand;
}

}
