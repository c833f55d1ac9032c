// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaveSpectrumReader.h"

#include "Data/Arrays.h"
#include "Data/FileBytes.h"
#include "Data/SeaStateTable.h"
#include "Data/Tables.h"
#include "Numerics/Constants.h"
#include "Numerics/InvalidInput.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Mistakes.h"
#include "Pipeline/Pipeline.h"
#include "Sea/MeasuredSpectrum.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <cctype>
#include <cmath>
#include <complex>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

vtkStandardNewMacro(vtkWaveSpectrumReader);

namespace
{

constexpr double BytesPerByte = 20.0; // of numbers and words in memory over those of a file
constexpr const char* What = "A spectrum of this size";

/// Bytes of NDBC's file of directions beside a file of densities; empty if there is none. A file of recent data has
/// another ending, one of a year another letter: 46042w2023.txt.
std::string BytesBeside(const std::string& path, const char* ending, char letter)
{
  namespace fs = std::filesystem;
  fs::path beside = path;
  std::string name = beside.filename().string();
  if (beside.extension() == ".data_spec")
  {
    beside.replace_extension(ending);
  }
  else if (name.size() > 5 && name[5] == 'w' && std::isdigit(static_cast<unsigned char>(name[0])))
  {
    name[5] = letter;
    beside.replace_filename(name);
  }
  std::error_code none;
  const bool isThere = beside != fs::path(path) && fs::is_regular_file(beside, none);
  return isThere ? littoral::BytesOfFile(beside.string(), BytesPerByte, What) : std::string();
}

littoral::MeasuredSpectrum SpectrumOf(const std::string& path, const littoral::SpectrumFileOptions& options)
{
  try
  {
    littoral::Require(path.empty() ? "FileName is empty" : "");
    const std::string bytes = littoral::BytesOfFile(path, BytesPerByte, What);
    return littoral::ReadSpectrumFile(
      bytes, options, BytesBeside(path, ".swdir", 'd'), BytesBeside(path, ".swr1", 'j'));
  }
  catch (const littoral::InvalidInput& refusal)
  {
    throw littoral::InvalidInput(littoral::FileMessage("read", path, "a spectrum", refusal.what()));
  }
}

/// Mean vector of the directions of all energy, densities being linear between frequencies.
littoral::MeanVector MeanOf(const littoral::MeasuredSpectrum& spectrum)
{
  std::complex<double> sum(0.0, 0.0);
  double energy = 0.0;
  const auto partOf = [&](std::size_t n) {
    return spectrum.Densities[n] * std::polar(spectrum.Lengths[n], spectrum.Directions[n]);
  };
  for (std::size_t n = 1; n < spectrum.Frequencies.size(); ++n)
  {
    const double half = 0.5 * (spectrum.Frequencies[n] - spectrum.Frequencies[n - 1]);
    sum += half * (partOf(n) + partOf(n - 1));
    energy += half * (spectrum.Densities[n] + spectrum.Densities[n - 1]);
  }
  return { std::arg(sum), std::abs(sum) / energy };
}

void AddNumbers(vtkTable* table, const char* name, const std::vector<double>& numbers)
{
  littoral::AddColumn(table, name, numbers, [](double number) { return number; });
}

void WriteMeasured(const littoral::MeasuredSpectrum& spectrum, vtkTable* table)
{
  using namespace littoral;
  SpectrumParameters parameters;
  parameters.Kind = SpectrumKind::Table;
  parameters.Frequencies = spectrum.Frequencies;
  parameters.Densities = spectrum.Densities;
  Require(WhyInvalid(parameters));
  AddNumbers(table, "Frequency", spectrum.Frequencies);
  AddNumbers(table, "Density", spectrum.Densities);
  const SeaPeriods periods = PeriodsOf(SeaSpectrum(parameters));
  AddField(table, sea::SignificantWaveHeight, { periods.Height });
  AddField(table, sea::PeakPeriod, { periods.Peak });
  WritePeriods(periods, table);
  if (!spectrum.Directions.empty())
  {
    std::vector<double> towards, spreads;
    for (std::size_t n = 0; n < spectrum.Directions.size(); ++n)
    {
      towards.push_back(spectrum.Directions[n] * 180.0 / Pi);
      spreads.push_back(CircularSpread(spectrum.Lengths[n]) * 180.0 / Pi);
    }
    AddNumbers(table, sea::DirectionTowards, towards);
    AddNumbers(table, sea::DirectionalSpread, spreads);
    WriteDirection(MeanOf(spectrum), table);
  }
  AddText(table, "Format", spectrum.Format.c_str());
  AddText(table, "Time", spectrum.Time.c_str());
}

}

//----------------------------------------------------------------------------
vtkWaveSpectrumReader::vtkWaveSpectrumReader()
  : FileName(nullptr)
  , Record(0)
  , Location(0)
  , DirectionConvention(AsInFile)
  , DensityUnit(PerDegree)
{
  this->SetNumberOfInputPorts(0);
}

//----------------------------------------------------------------------------
vtkWaveSpectrumReader::~vtkWaveSpectrumReader()
{
  this->SetFileName(nullptr);
}

//----------------------------------------------------------------------------
int vtkWaveSpectrumReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//----------------------------------------------------------------------------
int vtkWaveSpectrumReader::RequestData(
  vtkInformation* request, vtkInformationVector**, vtkInformationVector* outputVector)
{
  using namespace littoral;
  if (AsksForLaterPiece(request, outputVector))
  {
    return 1;
  }
  ParameterCheck check;
  check.Choice("DirectionConvention", this->DirectionConvention, 5);
  check.Choice("DensityUnit", this->DensityUnit, 2);
  check.Range("Record", this->Record, 0, VTK_INT_MAX);
  check.Range("Location", this->Location, 0, VTK_INT_MAX);
  Require(check.Reason());
  SpectrumFileOptions options;
  options.Record = this->Record;
  options.Location = this->Location;
  options.Convention = static_cast<littoral::DirectionConvention>(this->DirectionConvention);
  options.Unit = static_cast<littoral::DensityUnit>(this->DensityUnit);
  WriteMeasured(SpectrumOf(this->FileName ? this->FileName : "", options), vtkTable::GetData(outputVector));
  return 1;
}

//----------------------------------------------------------------------------
int vtkWaveSpectrumReader::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(
    this, request, outputs, "", [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkWaveSpectrumReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Record: " << this->Record << "\n";
  os << indent << "Location: " << this->Location << "\n";
  os << indent << "DirectionConvention: " << this->DirectionConvention << "\n";
  os << indent << "DensityUnit: " << this->DensityUnit << "\n";
}
