// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextTableReader.h"

#include "Data/FileBytes.h"
#include "Data/Tables.h"
#include "Numerics/InvalidInput.h"
#include "Numerics/TextTable.h"
#include "Pipeline/Mistakes.h"
#include "Pipeline/Pipeline.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkTextTableReader);

namespace
{

constexpr double BytesPerByte = 60.0; // of a table in memory, for short words, over those of its file

littoral::TextTable TableOf(const std::string& path)
{
  try
  {
    littoral::Require(path.empty() ? "FileName is empty" : "");
    return littoral::ReadTable(littoral::BytesOfFile(path, BytesPerByte, "A table of this size"));
  }
  catch (const littoral::InvalidInput& refusal)
  {
    throw littoral::InvalidInput(littoral::FileMessage("read", path, "a table", refusal.what()));
  }
}

/// Whether a word has zeros before its digits, as the names of plots do.
bool HasLeadingZeros(const std::string& word)
{
  return word.size() > 1 && word[0] == '0' && std::isdigit(static_cast<unsigned char>(word[1]));
}

/// Numbers of a column; empty if there are words in it, or nothing.
std::vector<double> NumbersOf(const std::vector<std::string>& words)
{
  std::vector<double> numbers;
  bool isAny = false;
  for (const std::string& word : words)
  {
    double number = 0.0;
    if (HasLeadingZeros(word) || !littoral::ReadNumber(word, number))
    {
      return {};
    }
    isAny |= !std::isnan(number);
    numbers.push_back(number);
  }
  return isAny ? numbers : std::vector<double>();
}

}

//----------------------------------------------------------------------------
vtkTextTableReader::vtkTextTableReader()
  : FileName(nullptr)
{
  this->SetNumberOfInputPorts(0);
}

//----------------------------------------------------------------------------
vtkTextTableReader::~vtkTextTableReader()
{
  this->SetFileName(nullptr);
}

//----------------------------------------------------------------------------
int vtkTextTableReader::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//----------------------------------------------------------------------------
int vtkTextTableReader::RequestData(vtkInformation* request, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (littoral::AsksForLaterPiece(request, outputVector))
  {
    return 1;
  }
  const std::string path = this->FileName ? this->FileName : "";
  const littoral::TextTable texts = TableOf(path);
  vtkTable* output = vtkTable::GetData(outputVector);
  for (std::size_t column = 0; column < texts.Names.size(); ++column)
  {
    const std::vector<std::string>& words = texts.Columns[column];
    const std::vector<double> numbers = NumbersOf(words);
    if (numbers.empty())
    {
      littoral::AddColumn(output, texts.Names[column].c_str(), words, [](const std::string& word) { return word; });
    }
    else
    {
      littoral::AddColumn(output, texts.Names[column].c_str(), numbers, [](double number) { return number; });
    }
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkTextTableReader::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(
    this, request, outputs, "", [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkTextTableReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
