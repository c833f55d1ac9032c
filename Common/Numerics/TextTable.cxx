// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/TextTable.h"

#include "Numerics/InvalidInput.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>
#include <set>
#include <string_view>

#ifndef __cpp_lib_to_chars
#include <cctype>
#include <cstdio>
#include <locale>
#include <sstream>
#endif

namespace littoral
{

namespace
{

constexpr char Separators[] = { ',', ';', '\t' };

/// Reads a number in full, whatever the locale; false where it is none.
bool ReadPlain(const char* begin, const char* end, double& number)
{
#ifdef __cpp_lib_to_chars
  const auto [stop, error] = std::from_chars(begin, end, number);
  return error == std::errc() && stop == end;
#else // libraries that have it for whole numbers alone
  std::istringstream text(std::string(begin, end));
  text.imbue(std::locale::classic());
  return !std::isspace(static_cast<unsigned char>(*begin)) && text >> number && text.peek() == EOF;
#endif
}

bool IsSpace(char letter)
{
  return letter == ' ' || letter == '\t' || letter == '\r' || letter == '"';
}

bool IsDigit(char letter)
{
  return letter >= '0' && letter <= '9';
}

/// Appends a code point of Unicode.
void Append(std::uint32_t point, std::string& text)
{
  const auto tail = [&text](std::uint32_t bits) { text += static_cast<char>(0x80u | (bits & 0x3fu)); };
  if (point < 0x80u)
  {
    text += static_cast<char>(point);
  }
  else if (point < 0x800u)
  {
    text += static_cast<char>(0xc0u | (point >> 6));
    tail(point);
  }
  else if (point < 0x10000u)
  {
    text += static_cast<char>(0xe0u | (point >> 12));
    tail(point >> 6);
    tail(point);
  }
  else
  {
    text += static_cast<char>(0xf0u | (point >> 18));
    tail(point >> 12);
    tail(point >> 6);
    tail(point);
  }
}

std::string OfUtf16(std::string_view bytes, bool isLittle)
{
  std::string text;
  std::uint32_t high = 0; // of a pair
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
  {
    const auto first = static_cast<unsigned char>(bytes[i]);
    const auto second = static_cast<unsigned char>(bytes[i + 1]);
    const std::uint32_t unit = isLittle ? first | (second << 8) : second | (first << 8);
    if (unit >= 0xd800u && unit < 0xdc00u)
    {
      high = unit;
      continue;
    }
    const bool isLow = unit >= 0xdc00u && unit < 0xe000u;
    Append(isLow ? (high ? 0x10000u + ((high - 0xd800u) << 10) + (unit - 0xdc00u) : 0xfffdu) : unit, text);
    high = 0;
  }
  return text;
}

std::string OfLatin1(std::string_view bytes)
{
  std::string text;
  for (const char letter : bytes)
  {
    Append(static_cast<unsigned char>(letter), text);
  }
  return text;
}

/// Number of bytes that follow the first one of a letter in UTF-8; -1 if none begins so.
int TailOf(unsigned char first)
{
  return first < 0x80u                ? 0
    : first >= 0xc2u && first < 0xe0u ? 1
    : first >= 0xe0u && first < 0xf0u ? 2
    : first >= 0xf0u && first < 0xf5u ? 3
                                      : -1;
}

bool IsUtf8(std::string_view bytes)
{
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    const int tail = TailOf(static_cast<unsigned char>(bytes[i]));
    if (tail < 0 || i + static_cast<std::size_t>(tail) >= bytes.size())
    {
      return false;
    }
    for (int k = 0; k < tail; ++k)
    {
      if ((static_cast<unsigned char>(bytes[++i]) & 0xc0u) != 0x80u)
      {
        return false;
      }
    }
  }
  return true;
}

bool BeginsWith(std::string_view text, std::string_view begin)
{
  return text.substr(0, begin.size()) == begin;
}

/// The rows of a text, cell by cell.
class RowParser
{
public:
  explicit RowParser(const std::string& text)
    : Text(text)
  {
    this->SkipToNames();
    const std::string_view head = this->Line();
    if (this->Separator == 0)
    {
      this->Separator = *std::max_element(std::begin(Separators), std::end(Separators),
        [head](char a, char b) { return CountOutsideQuotes(head, a) < CountOutsideQuotes(head, b); });
    }
  }

  bool IsAtEnd() const { return this->At >= this->Text.size(); }

  /// The next row; `number` is told where it is refused.
  std::vector<std::string> Next(std::size_t number)
  {
    std::vector<std::string> cells;
    bool isMore = true;
    while (isMore)
    {
      cells.push_back(this->Cell(number));
      isMore = !this->IsAtEnd() && this->Text[this->At] == this->Separator;
      this->At += isMore ? 1 : 0;
    }
    this->SkipLineEnd();
    this->Width = std::max(this->Width, cells.size());
    return cells;
  }

private:
  const std::string& Text;
  std::size_t At = 0;
  char Separator = 0;
  std::size_t Width = 1; // cells of the rows so far

  static std::ptrdiff_t CountOutsideQuotes(std::string_view line, char separator)
  {
    bool isQuoted = false;
    return std::count_if(line.begin(), line.end(), [&](char letter) {
      isQuoted = isQuoted != (letter == '"');
      return letter == separator && !isQuoted;
    });
  }

  bool IsLineEnd() const { return this->Text[this->At] == '\n' || this->Text[this->At] == '\r'; }

  std::string_view Line() const
  {
    const std::size_t end = this->Text.find_first_of("\r\n", this->At);
    return std::string_view(this->Text).substr(this->At, end == std::string::npos ? end : end - this->At);
  }

  void SkipLineEnd()
  {
    if (!this->IsAtEnd())
    {
      this->At += this->Text.compare(this->At, 2, "\r\n") == 0 ? 2 : 1;
    }
  }

  /// Goes to the line of the names, which may tell the separator before.
  void SkipToNames()
  {
    while (!this->IsAtEnd())
    {
      const std::string line(this->Line());
      const std::string plain = Trimmed(line);
      const bool tells = plain.size() == 5 && BeginsWith(PlainWord(plain), "sep") && plain[3] == '=';
      this->Separator = tells ? plain[4] : this->Separator;
      const bool isTab = Trimmed(line) == "sep=" && !line.empty() && line.back() == '\t';
      this->Separator = isTab ? '\t' : this->Separator;
      if (!tells && !isTab && !plain.empty() && plain.front() != '#')
      {
        return;
      }
      this->At += line.size();
      this->SkipLineEnd();
    }
  }

  std::string Cell(std::size_t number)
  {
    std::size_t begin = this->At;
    while (begin < this->Text.size() && this->Text[begin] == ' ')
    {
      ++begin;
    }
    if (begin < this->Text.size() && this->Text[begin] == '"')
    {
      this->At = begin;
      return this->QuotedCell(number);
    }
    begin = this->At;
    while (!this->IsAtEnd() && this->Text[this->At] != this->Separator && !this->IsLineEnd())
    {
      ++this->At;
    }
    return Trimmed(this->Text.substr(begin, this->At - begin));
  }

  /// A cell in quotes, of which two stand for one.
  std::string QuotedCell(std::size_t number)
  {
    std::string cell;
    for (++this->At;; ++this->At)
    {
      const bool isOpen = this->IsAtEnd();
      if (!isOpen && this->Text[this->At] != '"')
      {
        cell += this->Text[this->At];
        continue;
      }
      if (!isOpen && this->At + 1 < this->Text.size() && this->Text[this->At + 1] == '"')
      {
        cell += '"';
        ++this->At;
        continue;
      }
      this->At += isOpen ? 0 : 1;
      while (!this->IsAtEnd() && this->Text[this->At] == ' ')
      {
        ++this->At;
      }
      const bool isEnd = this->IsAtEnd() || this->Text[this->At] == this->Separator || this->IsLineEnd();
      if (isOpen || !isEnd || this->HoldsRow(cell))
      {
        Refuse(
          "close the quote of row ", number, ", at '", cell.substr(0, cell.find_first_of("\r\n")).substr(0, 20), "'.");
      }
      return Trimmed(cell);
    }
  }

  /// Whether a line within a cell has as many separators as a row.
  bool HoldsRow(const std::string& cell) const
  {
    std::size_t begin = cell.find_first_of("\r\n");
    while (begin != std::string::npos)
    {
      const std::size_t end = cell.find_first_of("\r\n", begin + 1);
      const auto last = end == std::string::npos ? cell.end() : cell.begin() + static_cast<std::ptrdiff_t>(end);
      const auto count = std::count(cell.begin() + static_cast<std::ptrdiff_t>(begin), last, this->Separator);
      if (this->Width > 1 && static_cast<std::size_t>(count) + 1 >= this->Width)
      {
        return true;
      }
      begin = end;
    }
    return false;
  }
};

void CheckNames(const std::vector<std::string>& names)
{
  if (names.size() > MaximumTableColumns)
  {
    Refuse("leave out columns: there are ", names.size(), ", and at most ", MaximumTableColumns, " are read.");
  }
  std::set<std::string> met;
  for (const std::string& name : names)
  {
    if (!name.empty() && !met.insert(name).second)
    {
      Refuse("rename a column: two are named ", name, ".");
    }
  }
}

/// Forms of numbers with commas.
enum class CommaForm
{
  None,
  Decimal,   ///< 3,5 or 1.234,5
  Thousands, ///< 1,234.5 or 1,234,567
  Either,    ///< 1,234
};

/// Whether digits stand in groups of three behind a mark, after one to three others.
bool IsGrouped(std::string_view digits, char mark)
{
  std::size_t cut = digits.find(mark);
  if (cut == 0 || cut > 3 || cut == std::string_view::npos)
  {
    return false;
  }
  for (; cut < digits.size(); cut += 4)
  {
    const std::string_view group = digits.substr(cut + 1, 3);
    const bool isEnd = cut + 4 >= digits.size();
    if (digits[cut] != mark || group.size() != 3 || !std::all_of(group.begin(), group.end(), IsDigit) ||
      (!isEnd && digits[cut + 4] != mark))
    {
      return false;
    }
  }
  return true;
}

CommaForm FormOf(std::string_view word)
{
  word.remove_prefix(!word.empty() && (word.front() == '-' || word.front() == '+') ? 1 : 0);
  const bool isNumber = std::all_of(
    word.begin(), word.end(), [](char letter) { return IsDigit(letter) || letter == ',' || letter == '.'; });
  const std::size_t comma = word.rfind(',');
  if (!isNumber || comma == std::string_view::npos || comma + 1 == word.size())
  {
    return CommaForm::None;
  }
  const std::size_t point = word.rfind('.');
  const std::string_view whole = word.substr(0, std::min(comma, point));
  if (point != std::string_view::npos)
  {
    const bool isDecimal = point < comma && IsGrouped(word.substr(0, comma), '.');
    const bool isThousands = point > comma && IsGrouped(word.substr(0, point), ',') && word.find('.') == point;
    return isDecimal ? CommaForm::Decimal : isThousands ? CommaForm::Thousands : CommaForm::None;
  }
  if (word.find(',') != comma)
  {
    return IsGrouped(word, ',') ? CommaForm::Thousands : CommaForm::None;
  }
  const bool mayBeThousands = IsGrouped(word, ',') && whole.front() != '0';
  return mayBeThousands ? CommaForm::Either : CommaForm::Decimal;
}

/// A number without thousands, and with a decimal point.
std::string PlainNumber(const std::string& word, bool isDecimal)
{
  std::string plain;
  for (const char letter : word)
  {
    const char mark = isDecimal ? ',' : '.';
    plain += letter == mark ? "." : letter == ',' || letter == '.' ? "" : std::string(1, letter);
  }
  return plain;
}

}

int TextTable::ColumnOf(const std::string& name) const
{
  const std::string wanted = PlainWord(name);
  for (std::size_t column = 0; column < this->Names.size(); ++column)
  {
    if (PlainWord(this->Names[column]) == wanted)
    {
      return static_cast<int>(column);
    }
  }
  return -1;
}

std::string Utf8Of(const std::string& bytes)
{
  const std::string_view all(bytes);
  if (BeginsWith(all, "\xff\xfe") || BeginsWith(all, "\xfe\xff"))
  {
    return OfUtf16(all.substr(2), all.front() == '\xff');
  }
  if (const std::size_t zero = bytes.find('\0'); zero < 2)
  {
    return OfUtf16(all, zero == 1);
  }
  const std::string_view marked = BeginsWith(all, "\xef\xbb\xbf") ? all.substr(3) : all;
  return IsUtf8(marked) ? std::string(marked) : OfLatin1(marked);
}

TextTable ReadTable(const std::string& bytes)
{
  const std::string text = Utf8Of(bytes);
  if (text.find('\0') != std::string::npos)
  {
    Refuse("the file is no text.");
  }
  RowParser rows(text);
  if (rows.IsAtEnd())
  {
    Refuse("the file has no rows.");
  }
  const std::vector<std::string> names = rows.Next(1);
  CheckNames(names);
  std::vector<std::vector<std::string>> columns(names.size());
  for (std::size_t number = 2; !rows.IsAtEnd();)
  {
    const std::vector<std::string> cells = rows.Next(number);
    const auto isEmpty = [](const std::string& cell) { return cell.empty(); };
    if (std::all_of(cells.begin(), cells.end(), isEmpty))
    {
      continue;
    }
    if (cells.size() > names.size() &&
      !std::all_of(cells.begin() + static_cast<std::ptrdiff_t>(names.size()), cells.end(), isEmpty))
    {
      Refuse("row ", number, " has ", cells.size(), " cells, and the first row has ", names.size(), ".");
    }
    for (std::size_t column = 0; column < names.size(); ++column)
    {
      columns[column].push_back(column < cells.size() ? cells[column] : "");
    }
    ++number;
  }
  TextTable table;
  for (std::size_t column = 0; column < names.size(); ++column)
  {
    if (!names[column].empty())
    {
      table.Names.push_back(names[column]);
      table.Columns.push_back(std::move(columns[column]));
    }
  }
  PlainNumbers(table);
  return table;
}

void PlainNumbers(TextTable& table)
{
  bool isDecimal = false;
  bool isThousands = false;
  for (const std::vector<std::string>& column : table.Columns)
  {
    for (const std::string& word : column)
    {
      const CommaForm form = FormOf(word);
      isDecimal |= form == CommaForm::Decimal;
      isThousands |= form == CommaForm::Thousands;
    }
  }
  if (isDecimal == isThousands)
  {
    return; // none, or both
  }
  for (std::vector<std::string>& column : table.Columns)
  {
    for (std::string& word : column)
    {
      word = FormOf(word) == CommaForm::None ? word : PlainNumber(word, isDecimal);
    }
  }
}

std::string PlainWord(const std::string& word)
{
  std::string plain;
  for (const char letter : word)
  {
    const char small = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    const bool isBeyondAscii = (static_cast<unsigned char>(small) & 0x80u) != 0;
    if ((small >= 'a' && small <= 'z') || IsDigit(small) || isBeyondAscii)
    {
      plain += small;
    }
  }
  return plain;
}

std::string Trimmed(const std::string& word)
{
  std::size_t begin = 0;
  std::size_t end = word.size();
  while (begin < end && IsSpace(word[begin]))
  {
    ++begin;
  }
  while (end > begin && IsSpace(word[end - 1]))
  {
    --end;
  }
  return word.substr(begin, end - begin);
}

bool ReadNumber(const std::string& word, double& number)
{
  const std::string trimmed = Trimmed(word);
  const std::string plain = PlainWord(trimmed);
  number = std::numeric_limits<double>::quiet_NaN();
  if (plain.empty() || plain == "na" || plain == "nan" || plain == "null" || plain == "none")
  {
    return plain != "" || trimmed.size() <= 1;
  }
  return ReadPlain(trimmed.data() + (trimmed.front() == '+' ? 1 : 0), trimmed.data() + trimmed.size(), number);
}

}
