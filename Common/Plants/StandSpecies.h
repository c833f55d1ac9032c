// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralStandSpecies_h
#define LittoralStandSpecies_h

#include "Numerics/TextTable.h"
#include "Plants/StandAllometry.h"

#include <map>
#include <string>
#include <vector>

namespace littoral
{

/// A species of trees.
struct StandSpecies
{
  std::string Name;
  std::string Kind; ///< the plant that stands for it
  HeightCurve Curve;
};

/**
 * The species that an inventory may name: columns `species` (names of the species, separated by semicolons), `kind`,
 * and, unless a species is to be like another kind of tree, `curve` (Curtis or Weibull), `a`, `b` and `c`.
 *
 * Littoral's own table has the curves of trees of the southern United States in the Forest Vegetation Simulator
 * (Keyser 2008, Southern variant), from feet and inches to metres and centimetres, and the one of Feldpausch et al.
 * (2012) for trees of all tropics.
 */
class StandSpeciesTable
{
public:
  /// The table that is part of Littoral.
  StandSpeciesTable();

  /// Another table. Throws InvalidInput if it is none.
  explicit StandSpeciesTable(const TextTable& table);

  /// Row of a name: of the whole name, else of its first word, the genus; else of `otherwise`. -1 if there is none.
  int RowOf(const std::string& name, const std::string& otherwise) const;
  bool Has(const std::string& name) const { return this->RowOf(name, "") >= 0; }

  const std::vector<StandSpecies>& GetSpecies() const { return this->Species; }

private:
  std::vector<StandSpecies> Species;
  std::map<std::string, int> Rows; ///< rows by plain names
};

}

#endif
