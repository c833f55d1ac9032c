// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/RandomStream.h"
#include "Plants/StandInventory.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>

namespace littoral
{

namespace
{

constexpr std::size_t MinimumMeasuredDiameters = 10; // measured, before others are drawn from them
constexpr std::size_t MinimumMeasuredHeights = 5;    // measured, before the curve is scaled by them
constexpr double MaximumDeviation = 2.0;             // standard deviations
constexpr double LowestTree = 1.3716;                // of curves, at a diameter of 0 [m]
constexpr double MinimumDiameter = 0.001;            // [m]
constexpr double MaximumMean = 0.6;                  // of stands by their density [m]
constexpr double MinimumMean = 0.05;                 // [m]
constexpr double SquareMetres = 1e4;                 // of a hectare

/// Sorted sample of each species, and of all.
class Measured
{
public:
  explicit Measured(std::size_t fewest)
    : Fewest(fewest)
  {
  }

  void Add(int species, double number)
  {
    this->OfSpecies[species].push_back(number);
    this->All.push_back(number);
  }

  void Sort()
  {
    std::sort(this->All.begin(), this->All.end());
    for (auto& [species, numbers] : this->OfSpecies)
    {
      std::sort(numbers.begin(), numbers.end());
    }
  }

  /// Measured values of a species, else of all; null where there are too few.
  const std::vector<double>* Of(int species) const
  {
    const auto found = this->OfSpecies.find(species);
    if (found != this->OfSpecies.end() && found->second.size() >= this->Fewest)
    {
      return &found->second;
    }
    return this->All.size() >= this->Fewest ? &this->All : nullptr;
  }

private:
  std::size_t Fewest;
  std::map<int, std::vector<double>> OfSpecies;
  std::vector<double> All;
};

/// Quantile of a sorted sample, linear between its values.
double Quantile(const std::vector<double>& sorted, double part)
{
  const double place = part * static_cast<double>(sorted.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), sorted.size() - 2);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[below + 1] - sorted[below]);
}

/// Imputation of the missing dimensions of a stand.
class Completion
{
public:
  Completion(const std::vector<StandSpecies>& species, const InventoryOptions& options, const StandInventory& stand)
    : Species(species)
    , Options(options)
    , Diameters(options.Seed, RandomPurpose::StandDiameters)
    , Heights(options.Seed, RandomPurpose::StandHeights)
  {
    for (const StandTree& tree : stand.Trees)
    {
      if (std::isfinite(tree.Diameter))
      {
        this->Thick.Add(tree.Species, tree.Diameter);
        if (std::isfinite(tree.Height))
        {
          this->Tall.Add(tree.Species, tree.Height / HeightOf(this->CurveOf(tree), tree.Diameter));
        }
      }
    }
    this->Thick.Sort();
    this->Tall.Sort();
    const double density = static_cast<double>(stand.Trees.size()) / AreaOf(stand) * SquareMetres;
    this->Mean = options.QuadraticMeanDiameter > 0.0 ? options.QuadraticMeanDiameter
                                                     : std::clamp(DiameterOfDensity(density), MinimumMean, MaximumMean);
  }

  void Complete(StandTree& tree) const
  {
    tree.ImputedDiameter = !std::isfinite(tree.Diameter);
    tree.ImputedHeight = !std::isfinite(tree.Height);
    if (tree.ImputedDiameter)
    {
      tree.Diameter = std::max(MinimumDiameter,
        tree.ImputedHeight ? this->DiameterFor(tree)
                           : DiameterOf(this->CurveOf(tree), tree.Height / this->FactorOf(tree)));
    }
    if (tree.ImputedHeight)
    {
      // H = 1.37 m + (r f(D) - 1.37 m) (1 + s z)
      const double middle = std::max(LowestTree, HeightOf(this->CurveOf(tree), tree.Diameter) * this->RatioOf(tree));
      tree.Height = LowestTree + (middle - LowestTree) * this->VariationOf(tree);
    }
  }

private:
  const std::vector<StandSpecies>& Species;
  const InventoryOptions& Options;
  RandomStream Diameters;
  RandomStream Heights;
  Measured Thick{ MinimumMeasuredDiameters };
  Measured Tall{ MinimumMeasuredHeights };
  double Mean = 0.0;

  const HeightCurve& CurveOf(const StandTree& tree) const { return this->Species[tree.Species].Curve; }

  double DiameterFor(const StandTree& tree) const
  {
    const double uniform = this->Diameters.UniformPair(static_cast<std::uint64_t>(tree.Row), 0)[0];
    const std::vector<double>* measured = this->Thick.Of(tree.Species);
    return measured ? Quantile(*measured, uniform) : DiameterInStand(this->Mean, uniform);
  }

  /// Median of the measured heights of a species over those of the curve.
  double RatioOf(const StandTree& tree) const
  {
    const std::vector<double>* ratios = this->Tall.Of(tree.Species);
    return ratios ? Quantile(*ratios, 0.5) : 1.0;
  }

  double VariationOf(const StandTree& tree) const
  {
    const double deviate = this->Heights.NormalPair(static_cast<std::uint64_t>(tree.Row), 0)[0];
    return 1.0 + this->Options.HeightVariation * std::clamp(deviate, -MaximumDeviation, MaximumDeviation);
  }

  /// Height of a tree of unknown diameter over that of the curve.
  double FactorOf(const StandTree& tree) const { return this->RatioOf(tree) * this->VariationOf(tree); }
};

}

void CompleteStand(const StandSpeciesTable& species, const InventoryOptions& options, StandInventory& stand)
{
  const Completion completion(species.GetSpecies(), options, stand);
  for (StandTree& tree : stand.Trees)
  {
    completion.Complete(tree);
  }
}

}
