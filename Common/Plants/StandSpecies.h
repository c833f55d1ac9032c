// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralStandSpecies_h
#define LittoralStandSpecies_h

#include "Plants/StandAllometry.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace littoral
{

/// Table of texts: columns with names, all of as many rows.
struct TextTable
{
  std::vector<std::string> Names;
  std::vector<std::vector<std::string>> Columns;

  std::size_t NumberOfRows() const { return this->Columns.empty() ? 0 : this->Columns.front().size(); }
  /// A column by its name in any case and punctuation; -1 if there is none.
  int ColumnOf(const std::string& name) const;
};

/// Comma-separated values without quotes; lines of spaces are left out.
TextTable ReadLines(const std::string& text);

/// Small letters and digits of a word: "Height (m)" is "heightm".
std::string PlainWord(const std::string& word);

/// A number of a table. False if the word is none; an absent one (empty, NA, NaN, NULL, a point or a dash) is NaN.
bool ReadNumber(const std::string& word, double& number);

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
