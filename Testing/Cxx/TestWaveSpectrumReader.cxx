// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Files of buoys and tables as seas: height, period and direction of what was read and of its trains.
#include "Check.h"
#include "ErrorCounter.h"
#include "TestFolder.h"
#include "vtkSeaStateSource.h"
#include "vtkWaveSpectrumReader.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
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

double Field(vtkAlgorithm* algorithm, const char* name)
{
  vtkDataArray* array = vtkTable::SafeDownCast(algorithm->GetOutputDataObject(0))->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(0, 0) : std::nan("");
}

/// A record of recent data of NDBC: values at 0.1, 0.15, 0.2 Hz.
std::string Recent(const char* head, const char* first, const char* second, const char* third)
{
  return std::string("#YY  MM DD hh mm ") + head + "\n2014 09 11 17 00 " + first + " (0.100) " + second + " (0.150) " +
    third + " (0.200)\n";
}

/// All waves of both frequencies with energy come from the south-west, and so do trains.
bool OfBuoy(const fs::path& folder)
{
  vtkNew<vtkWaveSpectrumReader> reader;
  const std::string path =
    Write(folder / "46042.data_spec", Recent("Sep_Freq  < spec_1 (freq_1) ... >", "9.999 0.0", "8.0", "0.0"));
  reader->SetFileName(path.c_str());
  reader->Update();
  bool good = Check(reader->GetOutput()->GetNumberOfColumns() == 2, "directions out of nothing");
  Write(folder / "46042.swdir", Recent("alpha1_1 (freq_1) ...", "225.0", "225.0", "225.0"));
  Write(folder / "46042.swr1", Recent("r1_1 (freq_1) ...", "0.90", "0.90", "0.90"));
  reader->Modified();
  reader->Update();
  good &= Check(reader->GetOutput()->GetNumberOfRows() == 3, "three frequencies");
  // A triangle from 0.1 to 0.2 Hz: m0 = 0.4
  good &= Check(std::abs(Field(reader, "SignificantWaveHeight") / (4.0 * std::sqrt(0.4)) - 1.0) < 1e-4, "the height");
  good &= Check(std::abs(Field(reader, "PeakPeriod") * 0.15 - 1.0) < 1e-9, "the peak");
  good &= Check(std::abs(Field(reader, "MeanPeriod") * 0.15 - 1.0) < 1e-4, "the mean period");
  good &= Check(std::abs(Field(reader, "MeanDirection") - 45.0) < 1e-6, "the mean direction");
  good &=
    Check(std::abs(Field(reader, "DirectionalSpread") - std::sqrt(0.2) * 180.0 / 3.14159265) < 1e-3, "the spread");
  vtkNew<vtkSeaStateSource> sea;
  sea->SetSpectrumToTable();
  sea->SetMeanDirection(-100.0); // not used
  sea->SetInputConnection(reader->GetOutputPort());
  sea->SetNumberOfTrains(60);
  sea->Update();
  for (const char* name : { "SignificantWaveHeight", "MeanPeriod", "EnergyPeriod", "ZeroCrossingPeriod" })
  {
    good &= Check(std::abs(Field(sea, name) / Field(reader, name) - 1.0) < 5e-3, name);
  }
  good &= Check(std::abs(Field(sea, "MeanDirection") - 45.0) < 1e-6, "trains have another mean direction");
  good &=
    Check(std::abs(Field(sea, "DirectionalSpread") / Field(reader, "DirectionalSpread") - 1.0) < 1e-3, "and spread");
  return good;
}

/// Long waves go east and short ones north, each with their own spread.
bool TurningWithFrequency(const fs::path& folder)
{
  vtkNew<vtkWaveSpectrumReader> reader;
  reader->SetFileName(Write(folder / "turn.csv",
    "Frequency,Density,alpha1,r1\n0.08,0,270,0.97\n0.09,5,270,0.97\n0.1,0,270,0.97\n0.2,0,180,0.8\n0.22,1,180,0.8\n"
    "0.24,0,180,0.8\n")
                        .c_str());
  vtkNew<vtkSeaStateSource> sea;
  sea->SetSpectrumToTable();
  sea->SetInputConnection(reader->GetOutputPort());
  sea->SetNumberOfTrains(160);
  sea->Update();
  vtkTable* trains = sea->GetOutput();
  double sums[2][2] = {};
  for (vtkIdType row = 0; row < trains->GetNumberOfRows(); ++row)
  {
    const double a = trains->GetValueByName(row, "Amplitude").ToDouble();
    const double direction = trains->GetValueByName(row, "Direction").ToDouble();
    const int isShort = trains->GetValueByName(row, "AngularFrequency").ToDouble() > 1.0 ? 1 : 0;
    sums[isShort][0] += a * a * std::cos(direction);
    sums[isShort][1] += a * a * std::sin(direction);
  }
  bool good = Check(std::abs(std::atan2(sums[0][1], sums[0][0])) < 0.06, "long waves go east");
  good &= Check(std::abs(std::atan2(sums[1][1], sums[1][0]) - 1.5708) < 0.15, "short waves go north");
  good &= Check(std::abs(Field(sea, "MeanDirection") - Field(reader, "MeanDirection")) < 1.0, "the mean direction");
  return good;
}

bool Refused(const char* words, const std::string& path)
{
  vtkNew<vtkWaveSpectrumReader> reader;
  reader->SetFileName(path.c_str());
  vtkNew<ErrorCounter> errors;
  errors->Watch(reader);
  return Check(errors->ExpectOneNaming(words), words);
}

}

int TestWaveSpectrumReader(int argc, char* argv[])
{
  const fs::path folder = EmptyFolder(argc, argv, "TestWaveSpectrumReader");
  bool good = OfBuoy(folder);
  good &= TurningWithFrequency(folder);
  good &= Refused("none.spc: No such file", (folder / "none.spc").string());
  good &= Refused("it is a folder", folder.string());
  good &= Refused("FileName is empty", "");
  good &= Refused("et DirectionConvention", Write(folder / "a.csv", "x,0,120,240\n0.1,1,1,1\n0.2,1,1,1\n"));
  good &= Refused("must be in m2/Hz", Write(folder / "b.csv", "Frequency,Density\n0.1,0\n0.2,60000\n0.3,0\n"));
  vtkNew<vtkWaveSpectrumReader> reader;
  reader->SetFileName(Write(folder / "c.csv", "Frequency,Density\n0.1,0\n0.2,6\n0.3,0\n").c_str());
  reader->SetDirectionConvention(5);
  vtkNew<ErrorCounter> errors;
  errors->Watch(reader);
  good &= Check(errors->ExpectOneNaming("DirectionConvention"), "a convention that is none");
  reader->SetDirectionConventionToAsInFile();
  reader->SetRecord(-1);
  good &= Check(errors->ExpectOneNaming("Record"), "a record before the first");
  reader->SetRecord(0);
  reader->UpdatePiece(1, 2, 0);
  good &= Check(reader->GetOutput()->GetNumberOfRows() == 0, "a table on the first rank alone");
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
