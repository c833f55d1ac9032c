// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/StandPlausibility.h"

#include "Numerics/Constants.h"
#include "Numerics/InvalidInput.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

namespace littoral
{

namespace
{

// Limits of a tree.
constexpr double MaximumDiameter = 12.0;     // of the thickest tree on record, 11.6 m [m]
constexpr double MaximumHeight = 130.0;      // the tallest on record has 116 m [m]
constexpr double LargestWithoutOthers = 3.0; // diameter that needs no other thick tree beside it [m]
constexpr double TimesUpperDecile = 4.0;
constexpr double LowestBreast = 1.37;   // [m]
constexpr double BucklingHeight = 95.0; // 0.792 (E / (density g))^(1/3) of wood, for a diameter of 1 m [m]
constexpr double TimesBuckling = 3.0;   // that a height may be, as suppressed and leaning trees are, and bad measures
// Limits of a stand.
constexpr double ThickestMiddle = 2.5;       // median diameter [m]
constexpr double ThinnestMiddle = 0.005;     // [m]
constexpr double TallestMiddle = 90.0;       // median height [m]
constexpr double LowestMiddle = 0.3;         // [m]
constexpr double MaximumSlenderness = 400.0; // median of height over diameter
constexpr double MinimumSlenderness = 8.0;
constexpr double MaximumBasalArea = 600.0; // of cross-sections at breast height [m2 a hectare]
constexpr std::size_t FewestForBasalArea = 20;
constexpr double HectareMetres = 1e4;
constexpr double NarrowestStand = 0.1; // width over length of the area that a row of trees takes
constexpr double FewTrees = 0.1;       // share of trees that may be wrong in a stand that is right
// Limits of places.
constexpr std::size_t FewestForPlaces = 10;
constexpr std::size_t TreesOfAnOutlier = 50;
constexpr double FarthestGap = 2.0;        // of the extent of the other trees
constexpr double LeastFarthestGap = 100.0; // [m]

/// A number in six digits.
std::string Short(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

double QuantileOf(std::vector<double> numbers, double part)
{
  const auto place = numbers.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(numbers.size()));
  std::nth_element(numbers.begin(), place, numbers.end());
  return *place;
}

double Median(std::vector<double> numbers)
{
  return QuantileOf(std::move(numbers), 0.5);
}

/// Numbers that are known.
std::vector<double> Known(std::vector<double> numbers)
{
  numbers.erase(std::remove_if(numbers.begin(), numbers.end(), [](double number) { return !std::isfinite(number); }),
    numbers.end());
  return numbers;
}

/// Doubt about a stand: a fact in words, and whose units may be wrong.
struct Doubt
{
  std::string Fact;
  bool OfDiameters = false;
  bool OfHeights = false;
};

/// Diameters and heights of a stand [m], NaN where they are missing.
class Measures
{
public:
  Measures(const StandInventory& stand, double ofDiameters, double ofHeights)
    : Area(AreaOf(stand, NarrowestStand))
  {
    for (const StandTree& tree : stand.Trees)
    {
      this->Diameters.push_back(ofDiameters * tree.Diameter);
      this->Heights.push_back(ofHeights * tree.Height);
    }
    this->Thickest = LargestLikelyDiameter(this->Diameters);
  }

  /// Whether a tree can be that of its row.
  bool IsLikely(std::size_t tree) const
  {
    return !(this->Diameters[tree] > this->Thickest) && !(this->Heights[tree] > MaximumHeight) &&
      CanStand(this->Diameters[tree], this->Heights[tree]);
  }

  std::optional<Doubt> WhyNoStand(const std::string& ofDiameters, const std::string& ofHeights) const
  {
    if (const std::string fact = WhyNoSize("DBH", ofDiameters, this->Diameters, ThinnestMiddle, ThickestMiddle);
        !fact.empty())
    {
      return Doubt{ fact, true, false };
    }
    if (const std::string fact = WhyNoSize("height", ofHeights, this->Heights, LowestMiddle, TallestMiddle);
        !fact.empty())
    {
      return Doubt{ fact, false, true };
    }
    if (const std::string fact = this->WhyNoShape(); !fact.empty())
    {
      return Doubt{ "the units of DBH (" + ofDiameters + ") and height (" + ofHeights +
          ") do not fit each other: " + fact,
        true, true };
    }
    if (const double basal = this->BasalArea(); basal > MaximumBasalArea)
    {
      return Doubt{ "DBH in " + ofDiameters + " would have a basal area of " + Short(std::round(basal)) +
          " m2 a hectare, which is no stand of trees",
        true, false };
    }
    return {};
  }

  /// Rows of the vector of trees that are not likely.
  std::vector<std::size_t> Unlikely() const
  {
    std::vector<std::size_t> trees;
    for (std::size_t tree = 0; tree < this->Diameters.size(); ++tree)
    {
      if (!this->IsLikely(tree))
      {
        trees.push_back(tree);
      }
    }
    return trees;
  }

private:
  std::vector<double> Diameters;
  std::vector<double> Heights;
  double Area;
  double Thickest = 0.0;

  static std::string WhyNoSize(
    const char* name, const std::string& unit, const std::vector<double>& sizes, double lowest, double highest)
  {
    const std::vector<double> known = Known(sizes);
    const double middle = known.empty() ? lowest : Median(known);
    return middle >= lowest && middle <= highest
      ? std::string()
      : std::string(name) + " in " + unit + " would have a median of " + Short(middle) + " m and a maximum of " +
        Short(*std::max_element(known.begin(), known.end())) + " m, which is no stand of trees";
  }

  /// Half of the trees, or more than a few, would be too slender or too stout.
  std::string WhyNoShape() const
  {
    std::vector<double> slenderness;
    for (std::size_t tree = 0; tree < this->Diameters.size(); ++tree)
    {
      slenderness.push_back(this->Heights[tree] / this->Diameters[tree]);
    }
    slenderness = Known(std::move(slenderness));
    const double middle = slenderness.empty() ? MinimumSlenderness : Median(slenderness);
    if (middle < MinimumSlenderness || middle > MaximumSlenderness)
    {
      return std::string("half of the trees are ") + (middle < MinimumSlenderness ? "less" : "more") + " than " +
        Short(std::floor(middle)) + " times as high as thick";
    }
    const std::size_t unlikely = this->Unlikely().size();
    return unlikely > 1 && static_cast<double>(unlikely) > FewTrees * static_cast<double>(this->Diameters.size())
      ? std::to_string(unlikely) + " of " + std::to_string(this->Diameters.size()) + " trees cannot be"
      : std::string();
  }

  /// pi / 4 sum of D^2 a hectare of the trees that are likely, 0 for a few trees.
  double BasalArea() const
  {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t tree = 0; tree < this->Diameters.size(); ++tree)
    {
      const double diameter = this->Diameters[tree];
      const bool counts = std::isfinite(diameter) && this->IsLikely(tree);
      sum += counts ? 0.25 * Pi * diameter * diameter : 0.0;
      count += counts ? 1 : 0;
    }
    return count < FewestForBasalArea ? 0.0 : sum / this->Area * HectareMetres;
  }
};

/// ", to cm or mm": units of a property in which there would be a stand; empty if there is none.
template <typename MeasuresIn>
std::string UnitsThatFit(LengthUnit told, const char* property, const MeasuresIn& measuresIn)
{
  std::string units;
  for (int unit = 1; unit < NumberOfLengthUnits; ++unit)
  {
    const auto other = static_cast<LengthUnit>(unit);
    if (other != told && !measuresIn(MetresOf(other) / MetresOf(told)).WhyNoStand("", ""))
    {
      units += (units.empty() ? "" : " or ") + std::string(NameOf(other));
    }
  }
  return units.empty() ? units : std::string(property) + ", to " + units;
}

/// The remedy of a stand in wrong units.
std::string Remedy(const StandInventory& stand, const Doubt& doubt, LengthUnit diameters, LengthUnit heights)
{
  std::string remedy;
  if (doubt.OfDiameters)
  {
    remedy = UnitsThatFit(diameters, "DiameterUnit", [&](double factor) { return Measures(stand, factor, 1.0); });
  }
  if (doubt.OfHeights)
  {
    const std::string other =
      UnitsThatFit(heights, "HeightUnit", [&](double factor) { return Measures(stand, 1.0, factor); });
    remedy += (remedy.empty() || other.empty() ? "" : ", or ") + other;
  }
  return remedy.empty() ? "; check these columns, or set AllowImplausible." : "; set " + remedy + ".";
}

std::string SizeOf(const StandTree& tree)
{
  const std::string thick = std::isfinite(tree.Diameter) ? Short(tree.Diameter) + " m thick" : "";
  const std::string high = std::isfinite(tree.Height) ? Short(tree.Height) + " m high" : "";
  return thick + (thick.empty() || high.empty() ? "" : " and ") + high;
}

/// Refuses a tree that cannot be.
[[noreturn]] void RefuseTree(const StandTree& tree, std::size_t others)
{
  Refuse("the tree of row ", tree.Row + 1, others == 0 ? "" : ", like " + std::to_string(others) + " more,",
    " would be ", SizeOf(tree), "; correct it, empty what was not measured, or set AllowImplausible.");
}

/// Places of the trees of a plot along an axis, with their numbers.
using Places = std::vector<std::pair<double, std::size_t>>;

/// Refuses the first or the last trees of a sorted row if they are far from the others.
void RequireNear(const StandInventory& stand, const Places& places, char axis)
{
  const std::size_t count = places.size();
  const std::size_t few = std::max<std::size_t>(1, count / TreesOfAnOutlier);
  for (std::size_t cut = 1; cut < count; ++cut)
  {
    const bool isFirst = cut <= few; // those before the cut are the few
    if (!isFirst && count - cut > few)
    {
      continue;
    }
    const double gap = places[cut].first - places[cut - 1].first;
    const double extent =
      isFirst ? places.back().first - places[cut].first : places[cut - 1].first - places.front().first;
    if (gap > std::max(LeastFarthestGap, FarthestGap * extent))
    {
      const StandTree& tree = stand.Trees[places[isFirst ? cut - 1 : cut].second];
      Refuse("the tree of row ", tree.Row + 1, " stands ", Short(std::round(gap)), " m along ", axis,
        " from the others, which are within ", Short(std::round(extent)),
        " m; correct its place, or set AllowImplausible.");
    }
  }
}

}

double LargestLikelyDiameter(std::vector<double> diameters)
{
  diameters = Known(std::move(diameters));
  const double others = diameters.empty() ? 0.0 : TimesUpperDecile * QuantileOf(std::move(diameters), 0.9);
  return std::min(MaximumDiameter, std::max(LargestWithoutOthers, others));
}

bool CanStand(double diameter, double height)
{
  return !(height < diameter) &&
    !(height - LowestBreast > TimesBuckling * BucklingHeight * std::cbrt(diameter * diameter));
}

void RequirePlausible(
  const StandInventory& stand, LengthUnit diameters, LengthUnit heights, const InventoryOptions& options)
{
  const auto isTooLarge = [](const StandTree& tree) {
    return tree.Diameter > MaximumDiameter || tree.Height > MaximumHeight;
  };
  if (!options.AllowImplausible)
  {
    const Measures measures(stand, 1.0, 1.0);
    if (const auto doubt = measures.WhyNoStand(NameOf(diameters), NameOf(heights)))
    {
      Refuse(doubt->Fact, Remedy(stand, *doubt, diameters, heights));
    }
    if (const std::vector<std::size_t> unlikely = measures.Unlikely(); !unlikely.empty())
    {
      RefuseTree(stand.Trees[unlikely.front()], unlikely.size() - 1);
    }
  }
  const auto giant = std::find_if(stand.Trees.begin(), stand.Trees.end(), isTooLarge);
  if (giant != stand.Trees.end())
  {
    Refuse("the tree of row ", giant->Row + 1, " would be ", SizeOf(*giant), "; at most ", Short(MaximumDiameter),
      " m and ", Short(MaximumHeight), " m are allowed.");
  }
}

void RequireNear(const StandInventory& stand)
{
  for (std::size_t plot = 0; plot < stand.Plots.size(); ++plot)
  {
    Places places[2];
    for (std::size_t tree = 0; tree < stand.Trees.size(); ++tree)
    {
      if (stand.Trees[tree].Plot == static_cast<int>(plot))
      {
        places[0].emplace_back(stand.Trees[tree].X, tree);
        places[1].emplace_back(stand.Trees[tree].Y, tree);
      }
    }
    for (int axis = 0; axis < 2 && places[axis].size() >= FewestForPlaces; ++axis)
    {
      std::sort(places[axis].begin(), places[axis].end());
      RequireNear(stand, places[axis], axis == 0 ? 'x' : 'y');
    }
  }
}

}
