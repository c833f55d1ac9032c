// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/InvalidInput.h"
#include "Numerics/TextTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace littoral;

namespace
{

using Words = std::vector<std::string>;

/// A text as UTF-16, with its mark.
std::string Utf16(const std::u16string& text, bool isLittle)
{
  std::string bytes;
  for (const char16_t unit : u"\ufeff" + text)
  {
    const char low = static_cast<char>(unit & 0xff);
    const char high = static_cast<char>(unit >> 8);
    bytes += isLittle ? std::string{ low, high } : std::string{ high, low };
  }
  return bytes;
}

/// The only column of numbers, as it is read.
Words Numbers(const Words& written)
{
  TextTable table;
  table.Names = { "a" };
  table.Columns = { written };
  PlainNumbers(table);
  return table.Columns.front();
}

std::string WhyNot(const std::string& bytes)
{
  return WhyRefused([&] { ReadTable(bytes); });
}

}

TEST(TextTable, ATableInAnyEncodingAndWithAnySeparatorIsTheSame)
{
  const Words first = { "1.5", "8" };
  const Words second = { "Ch\xc3\xaane", "oak; red" };
  for (const std::string& bytes :
    { std::string("a,b\n1.5,Ch\xc3\xaane\n8,oak; red\n"),
      std::string("\xef\xbb\xbf"
                  "a,b\r\n1.5,Ch\xc3\xaane\r\n8,oak; red"),
      std::string("a;b\r1,5;Ch\xeane\r8;\"oak; red\"\r"), std::string("sep=;\na;b\n1,5;Ch\xeane\n8;\"oak; red\"\n"),
      std::string("# a plot\n\n\"a\"\t\"b\"\n1,5\tCh\xeane\n\n8\toak; red\t\n"),
      std::string("sep=\t\na\tb\n1,5\tCh\xeane\n8\toak; red"),
      Utf16(u"a\tb\r\n1,5\tCh\u00eane\r\n8\toak; red\r\n", true), Utf16(u"a\tb\n1,5\tCh\u00eane\n8\toak; red", false),
      Utf16(u"a;b\n1,5;Ch\u00eane\n8;\"oak; red\"", true).substr(2),
      std::string("a,,b\n\"1,5\",7,Ch\xeane\n8,6,oak; red\n") })
  {
    const TextTable table = ReadTable(bytes);
    EXPECT_EQ(table.Names, (Words{ "a", "b" })) << bytes;
    ASSERT_EQ(table.Columns.size(), 2u) << bytes;
    EXPECT_EQ(table.Columns[0], first) << bytes;
    EXPECT_EQ(table.Columns[1], second) << bytes;
  }
  EXPECT_EQ(Utf8Of(Utf16(u"\U0001f332", false)), "\xf0\x9f\x8c\xb2");
}

TEST(TextTable, CellsInQuotes)
{
  const TextTable table =
    ReadTable("a,b,c\n\"x, y\",\"5\"\" pine\",\"two\nlines\"\n1, \"2\" ,3\n" + std::string(200000, 'a'));
  EXPECT_EQ(table.Columns[0], (Words{ "x, y", "1", std::string(200000, 'a') }));
  EXPECT_EQ(table.Columns[1], (Words{ "5\" pine", "2", "" }));
  EXPECT_EQ(table.Columns[2], (Words{ "two\nlines", "3", "" }));
}

TEST(TextTable, SeparatorsOfQuotedNamesDoNotCount)
{
  EXPECT_EQ(ReadTable("\"a;b;c\",d\n1,2\n").Names, (Words{ "a;b;c", "d" }));
}

TEST(TextTable, CommasOfNumbers)
{
  EXPECT_EQ(Numbers({ "3,5", "-1.234,5", "1,234", "7", "" }), (Words{ "3.5", "-1234.5", "1.234", "7", "" }));
  EXPECT_EQ(Numbers({ "1,234", "500,026.16", "7.5" }), (Words{ "1234", "500026.16", "7.5" }));
  EXPECT_EQ(Numbers({ "1,234,567", "1,234" }), (Words{ "1234567", "1234" }));
  EXPECT_EQ(Numbers({ "0,123", "1,234" }), (Words{ "0.123", "1.234" }));
  EXPECT_EQ(Numbers({ "5000,123", "1,234" }), (Words{ "5000.123", "1.234" }));
  EXPECT_EQ(Numbers({ "1,234", "5,678" }), (Words{ "1,234", "5,678" })) << "nobody knows";
  EXPECT_EQ(Numbers({ "3,5", "1,234.5" }), (Words{ "3,5", "1,234.5" })) << "both";
  EXPECT_EQ(Numbers({ "3,5", "oak, red", "12,34,5", "," }), (Words{ "3.5", "oak, red", "12,34,5", "," }));
  double number = 0.0;
  EXPECT_TRUE(ReadNumber(" 3.5 ", number) && number == 3.5);
  EXPECT_TRUE(ReadNumber("NA", number) && std::isnan(number));
  EXPECT_FALSE(ReadNumber("1,234", number));
}

TEST(TextTable, OneMessageForWhatIsNoTable)
{
  const std::string rows = "a,b\n1,oak\n2,oak\n3,oak\n";
  EXPECT_EQ(WhyNot(rows), "");
  // A quote that is not closed, alone, and before others.
  EXPECT_EQ(WhyNot("a,b\n1,\"oak\n2,oak\n3,oak\n"), "close the quote of row 2, at 'oak'.");
  EXPECT_EQ(WhyNot("a,b\n1,\"oak\n2,oak\n3,\"pine\"\n"), "close the quote of row 2, at 'oak'.");
  EXPECT_EQ(WhyNot("a,b\n1,oak\n2,\"oak\n3,oak\"\n4,fir\n"), "close the quote of row 3, at 'oak'.");
  EXPECT_EQ(WhyNot("a,b\n1,\"oak\" fir\n"), "close the quote of row 2, at 'oak'.");
  EXPECT_EQ(WhyNot("a,b,a\n1,2,3\n"), "rename a column: two are named a.");
  EXPECT_EQ(WhyNot("a,b\n1,2,3\n"), "row 2 has 3 cells, and the first row has 2.");
  EXPECT_EQ(WhyNot("a,b\n1,2,,\n"), "");
  EXPECT_EQ(WhyNot(" \n"), "the file has no rows.");
  EXPECT_EQ(WhyNot(std::string("a,b\n1,\0\n", 8)), "the file is no text.");
  EXPECT_EQ(WhyNot(""), "the file has no rows.");
  std::string wide = "x0";
  for (int column = 1; column < 100000; ++column)
  {
    wide += ",x" + std::to_string(column);
  }
  EXPECT_EQ(WhyNot(wide), "leave out columns: there are 100000, and at most 10000 are read.");
}
