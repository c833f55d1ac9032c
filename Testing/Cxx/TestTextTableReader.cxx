// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Tables of text read: types of columns, and what is no table.
#include "Check.h"
#include "ErrorCounter.h"
#include "TestFolder.h"
#include "vtkTextTableReader.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace
{

namespace fs = std::filesystem;

std::string Write(const fs::path& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary) << bytes;
  return path.string();
}

bool Columns(const fs::path& folder)
{
  vtkNew<vtkTextTableReader> reader;
  reader->SetFileName(Write(folder / "plot.csv", "sep=;\nplot;dbh;species\n01;3,5;H\xeatre\n02;;\n").c_str());
  reader->Update();
  vtkTable* table = reader->GetOutput();
  auto* plots = vtkStringArray::SafeDownCast(table->GetColumnByName("plot"));
  auto* dbh = vtkDoubleArray::SafeDownCast(table->GetColumnByName("dbh"));
  auto* species = vtkStringArray::SafeDownCast(table->GetColumnByName("species"));
  bool good = Check(table->GetNumberOfRows() == 2 && table->GetNumberOfColumns() == 3, "two rows of three");
  good &= Check(plots && plots->GetValue(0) == "01", "names of plots are words");
  good &= Check(dbh && dbh->GetValue(0) == 3.5 && std::isnan(dbh->GetValue(1)), "numbers");
  good &= Check(species && species->GetValue(0) == "H\xc3\xaatre", "Latin-1");
  vtkNew<vtkTextTableReader> later;
  later->SetFileName(reader->GetFileName());
  later->UpdatePiece(1, 2, 0);
  return good & Check(later->GetOutput()->GetNumberOfRows() == 0, "a table on the first rank alone");
}

bool Refused(const char* words, const std::string& path)
{
  vtkNew<vtkTextTableReader> reader;
  reader->SetFileName(path.c_str());
  vtkNew<ErrorCounter> errors;
  errors->Watch(reader);
  const bool good = errors->ExpectOneNaming(words);
  const std::size_t verb = errors->Last.find("Cannot read");
  return Check(good && errors->Last.find("Cannot read", verb + 1) == std::string::npos, words);
}

}

int TestTextTableReader(int argc, char* argv[])
{
  const fs::path folder = EmptyFolder(argc, argv, "TestTextTableReader");
  bool good = Columns(folder);
  good &= Refused("Cannot read quote.csv: close the quote of row 2", Write(folder / "quote.csv", "a,b\n1,\"x\n2,y\n"));
  good &= Refused("Cannot read none.csv: No such file", (folder / "none.csv").string());
  good &= Refused("Cannot read none.csv: there is no folder ", (folder / "nowhere" / "none.csv").string());
  good &= Refused("it is a folder", folder.string());
  good &= Refused("Cannot read a table: FileName is empty", "");
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
