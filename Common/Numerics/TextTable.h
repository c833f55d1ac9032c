// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTextTable_h
#define LittoralTextTable_h

#include <cstddef>
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

/// Largest number of columns of a table that is read.
inline constexpr std::size_t MaximumTableColumns = 10000;

/// Text of a file as UTF-8: UTF-16 with its mark or without, UTF-8, or else Latin-1.
std::string Utf8Of(const std::string& bytes);

/**
 * Reads separated values of a file: a row of names, and a row a line. The separator is the one of comma, semicolon and
 * tab that the names have most of, or that of a line `sep=;` before them. Lines of `#` before the names and blank lines
 * are left out. A cell in quotes may hold separators, quotes (two) and line breaks, but no whole rows. Columns without
 * a name are left out; numbers are as PlainNumbers() makes them. Throws InvalidInput for what is no text, a row that is
 * too long, a quote that is not closed, two columns of one name, and too many columns.
 */
TextTable ReadTable(const std::string& bytes);

/**
 * Writes numbers with a decimal comma, or with commas between thousands, as from_chars() reads them: 3,5 and 1.234,5
 * are 3.5 and 1234.5, and 1,234.5 is 1234.5. What 1,234 is follows from the other numbers of the table; it stays as it
 * is if they do not tell.
 */
void PlainNumbers(TextTable& table);

/// Small letters and digits of a word: "Height (m)" is "heightm".
std::string PlainWord(const std::string& word);

/// A word without spaces and quotes around it.
std::string Trimmed(const std::string& word);

/// A number of a table. False if the word is none; an absent one (empty, NA, NaN, NULL, a point or a dash) is NaN.
bool ReadNumber(const std::string& word, double& number);

}

#endif
