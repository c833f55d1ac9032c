// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSpectrumText_h
#define LittoralSpectrumText_h

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace littoral
{

/// Lines of a text, one after the other, without their ends.
class LineReader
{
public:
  explicit LineReader(const std::string& text)
    : Text(&text)
  {
  }

  bool AtEnd() const { return this->Place >= this->Text->size(); }
  std::string Peek() const;
  std::string Next();

private:
  const std::string* Text;
  std::size_t Place = 0;
};

/// The first word of a line; empty if there is none.
std::string FirstWord(const std::string& line);

/// Cells of a line, between commas, semicolons or tabs if it has them, else between spaces.
std::vector<std::string> CellsOf(const std::string& line);

/// A value of a JSON text.
struct Json
{
  bool IsNumber = false;
  double Number = 0.0;
  std::string Text;               ///< of a string
  std::vector<std::string> Names; ///< of an object, one an item
  std::vector<Json> Items;        ///< of an object or an array

  /// The item of a name; null if there is none.
  const Json* Member(const std::string& name) const;
};

/// Reads a JSON text. null, true and false are neither numbers nor texts. Throws InvalidInput.
Json ReadJson(const std::string& text);

}

#endif
