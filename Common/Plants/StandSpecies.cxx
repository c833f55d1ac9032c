// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/StandSpecies.h"

#include "Numerics/InvalidInput.h"
#include "Plants/StandSpeciesText.h" // from StandSpecies.csv

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>

namespace littoral
{

namespace
{

std::vector<std::string> Split(const std::string& line, char separator)
{
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; std::getline(stream, word, separator);)
  {
    words.push_back(Trimmed(word));
  }
  return words;
}

/// The first word of a name.
std::string Genus(const std::string& name)
{
  const std::string trimmed = Trimmed(name);
  return trimmed.substr(0, trimmed.find_first_of(" _."));
}

/// Columns of a table of species.
struct SpeciesColumns
{
  int Species;
  int Kind;
  int Curve;
  std::array<int, 3> Numbers;
};

/// The curve of a row.
HeightCurve ReadCurve(const TextTable& table, const SpeciesColumns& columns, std::size_t row)
{
  HeightCurve curve;
  if (columns.Curve < 0)
  {
    return curve;
  }
  const std::string form = PlainWord(table.Columns[columns.Curve][row]);
  if (form.empty())
  {
    return curve;
  }
  if (form != "curtis" && form != "weibull")
  {
    Refuse("curve is '", form, "'; it must be Curtis or Weibull.");
  }
  curve.Form = form == "curtis" ? HeightCurveForm::Curtis : HeightCurveForm::Weibull;
  double* const numbers[] = { &curve.A, &curve.B, &curve.C };
  for (int index = 0; index < 3; ++index)
  {
    const int column = columns.Numbers[index];
    *numbers[index] = std::numeric_limits<double>::quiet_NaN();
    if (column < 0 || !ReadNumber(table.Columns[column][row], *numbers[index]))
    {
      Refuse("there is no number ", "abc"[index], " of its curve.");
    }
  }
  Require(WhyInvalid(curve));
  return curve;
}

}

StandSpeciesTable::StandSpeciesTable()
  : StandSpeciesTable(ReadTable(StandSpeciesText))
{
}

StandSpeciesTable::StandSpeciesTable(const TextTable& table)
{
  const SpeciesColumns columns{ table.ColumnOf("species"), table.ColumnOf("kind"), table.ColumnOf("curve"),
    { table.ColumnOf("a"), table.ColumnOf("b"), table.ColumnOf("c") } };
  if (columns.Species < 0 || columns.Kind < 0 || table.NumberOfRows() == 0)
  {
    Refuse("the table of species needs the columns species and kind, and a row.");
  }
  for (std::size_t row = 0; row < table.NumberOfRows(); ++row)
  {
    StandSpecies species;
    const std::vector<std::string> names = Split(table.Columns[columns.Species][row], ';');
    species.Kind = Trimmed(table.Columns[columns.Kind][row]);
    species.Name = names.empty() ? "" : names.front();
    InContext("row " + std::to_string(row + 1) + " of the table of species (" + species.Name + "): ", [&] {
      Require(species.Name.empty() || species.Kind.empty() ? "it needs a species and a kind." : "");
      species.Curve = ReadCurve(table, columns, row);
    });
    for (const std::string& name : names)
    {
      this->Rows.emplace(PlainWord(name), static_cast<int>(row));
    }
    this->Species.push_back(species);
  }
}

int StandSpeciesTable::RowOf(const std::string& name, const std::string& otherwise) const
{
  for (const std::string& word : { name, Genus(name), otherwise })
  {
    const auto found = this->Rows.find(PlainWord(word));
    if (found != this->Rows.end())
    {
      return found->second;
    }
  }
  return -1;
}

}
