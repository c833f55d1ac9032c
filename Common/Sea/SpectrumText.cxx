// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sea/SpectrumText.h"

#include "Numerics/InvalidInput.h"
#include "Numerics/TextTable.h"
#include "Numerics/Words.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace littoral
{

namespace
{

/// Arrays and objects within each other, at most.
constexpr int DeepestJson = 64;

/// One pass over a JSON text (RFC 8259).
class JsonParser
{
public:
  explicit JsonParser(const std::string& text)
    : Text(text)
  {
  }

  Json Read()
  {
    Json value = this->Value(0);
    this->Skip();
    Require(this->Place == this->Text.size() ? "" : "the JSON text goes on after its end.");
    return value;
  }

private:
  void Skip()
  {
    while (this->Place < this->Text.size() && std::isspace(static_cast<unsigned char>(this->Text[this->Place])))
    {
      ++this->Place;
    }
  }

  char Next()
  {
    this->Skip();
    Require(this->Place < this->Text.size() ? "" : "the JSON text ends too early.");
    return this->Text[this->Place];
  }

  bool Take(char c)
  {
    const bool isThere = this->Next() == c;
    this->Place += isThere ? 1 : 0;
    return isThere;
  }

  void Need(char c)
  {
    Require(this->Take(c)
        ? ""
        : std::string("the JSON text lacks a '") + c + "' at byte " + std::to_string(this->Place) + ".");
  }

  std::string String()
  {
    this->Need('"');
    std::string text;
    while (this->Place < this->Text.size() && this->Text[this->Place] != '"')
    {
      // Names and times have no escapes that matter
      this->Place += this->Text[this->Place] == '\\' ? 1 : 0;
      Require(this->Place < this->Text.size() ? "" : "the JSON text ends too early.");
      text += this->Text[this->Place++];
    }
    this->Need('"');
    return text;
  }

  Json Value(int depth)
  {
    Require(depth < DeepestJson ? "" : "the JSON text has too many arrays within each other.");
    Json value;
    const char first = this->Next();
    if (first == '"')
    {
      value.Text = this->String();
      return value;
    }
    if (first == '{' || first == '[')
    {
      this->Collection(value, first, depth);
      return value;
    }
    const std::size_t end = std::min(this->Text.find_first_of(",]} \t\r\n", this->Place), this->Text.size());
    const std::string word = this->Text.substr(this->Place, end - this->Place);
    this->Place = end;
    value.IsNumber = word != "null" && word != "true" && word != "false";
    Require(!value.IsNumber || (!word.empty() && ReadNumber(word, value.Number))
        ? ""
        : "'" + word.substr(0, 30) + "' is no JSON.");
    return value;
  }

  void Collection(Json& value, char first, int depth)
  {
    const char last = first == '{' ? '}' : ']';
    this->Need(first);
    if (this->Take(last))
    {
      return;
    }
    do
    {
      if (first == '{')
      {
        value.Names.push_back(this->String());
        this->Need(':');
      }
      value.Items.push_back(this->Value(depth + 1));
    }
    while (this->Take(','));
    this->Need(last);
  }

  const std::string& Text;
  std::size_t Place = 0;
};

}

std::string LineReader::Peek() const
{
  const std::size_t end = std::min(this->Text->find('\n', this->Place), this->Text->size());
  std::string line = this->Text->substr(this->Place, end - this->Place);
  line.erase(line.find_last_not_of('\r') + 1);
  return line;
}

std::string LineReader::Next()
{
  std::string line = this->Peek();
  this->Place = std::min(this->Text->find('\n', this->Place), this->Text->size() - 1) + 1;
  return line;
}

std::string FirstWord(const std::string& line)
{
  std::istringstream stream(line);
  std::string word;
  stream >> word;
  return word;
}

std::vector<std::string> CellsOf(const std::string& line)
{
  const char marks[] = { '\t', ';', ',' };
  const auto mark =
    std::find_if(std::begin(marks), std::end(marks), [&](char c) { return line.find(c) != std::string::npos; });
  if (mark == std::end(marks))
  {
    return WordsOf(line);
  }
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, *mark);)
  {
    cells.push_back(Trimmed(cell));
  }
  return cells;
}

const Json* Json::Member(const std::string& name) const
{
  const auto at = std::find(this->Names.begin(), this->Names.end(), name);
  return at == this->Names.end() ? nullptr : &this->Items[at - this->Names.begin()];
}

Json ReadJson(const std::string& text)
{
  return JsonParser(text).Read();
}

}
