// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Statistics of wind and sea through the pipeline: columns, field data, turned winds, pieces, bad input.
#include "Check.h"
#include "ErrorCounter.h"
#include "vtkSeaStateSource.h"
#include "vtkSeaStatisticsFilter.h"
#include "vtkWindFieldSource.h"
#include "vtkWindStatisticsFilter.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <cmath>
#include <functional>
#include <iostream>
#include <limits>

namespace
{

const double NaN = std::numeric_limits<double>::quiet_NaN();

vtkTable* Output(vtkAlgorithm* filter, int port)
{
  return vtkTable::SafeDownCast(filter->GetOutputDataObject(port));
}

double FieldOf(vtkTable* table, const char* name, int component = 0)
{
  return table->GetFieldData()->GetArray(name)->GetComponent(0, component);
}

/// Area under a column of a table.
double Area(vtkTable* table, const char* x, const char* y)
{
  double sum = 0.0;
  for (vtkIdType row = 1; row < table->GetNumberOfRows(); ++row)
  {
    const auto at = [&](vtkIdType k, const char* name) { return table->GetValueByName(k, name).ToDouble(); };
    sum += 0.5 * (at(row, x) - at(row - 1, x)) * (at(row, y) + at(row - 1, y));
  }
  return sum;
}

template <typename Filter>
bool Fails(const char* word, Filter* filter)
{
  vtkNew<ErrorCounter> errors;
  errors->Watch(filter);
  return errors->ExpectOneNaming(word) && Check(Output(filter, 0)->GetNumberOfRows() == 0, "output not empty");
}

/// The profile of a turned wind that veers is that of the same wind along x; the model is read from the field data.
bool WindIsMeasured()
{
  vtkNew<vtkWindFieldSource> wind;
  wind->SetDimensions(120, 12, 6);
  wind->SetRoughnessLength(0.2);
  vtkNew<vtkWindStatisticsFilter> statistics;
  statistics->SetInputConnection(wind->GetOutputPort());
  statistics->SetHeight(6.2);
  statistics->SetSeparation(7.0, 0.0);
  bool good = true;
  double deviations[2];
  for (const int turn : { 0, 1 })
  {
    wind->SetWindDirection(55.0 * turn);
    wind->SetVeer(1.5 * turn);
    statistics->Update();
    vtkTable* profile = Output(statistics, 2);
    good &= Check(profile->GetNumberOfRows() == 6, "not a row a layer");
    // U = u* / 0.4 ln(z / z0) with 10 m/s at 10 m
    const double wanted = 10.0 * std::log(5.0 / 0.2) / std::log(10.0 / 0.2);
    good &= Check(std::abs(profile->GetValueByName(2, "SpeedModel").ToDouble() - wanted) < 1e-9, "another law");
    good &= Check(std::abs(profile->GetValueByName(2, "Speed").ToDouble() - wanted) < 1e-4, "another mean speed");
    deviations[turn] = profile->GetValueByName(2, "AcrossDeviation").ToDouble();
    good &= Check(FieldOf(Output(statistics, 0), "Height") == 7.0, "another layer");
    good &= Check(FieldOf(Output(statistics, 1), "Separation") == 8.0, "another separation");
  }
  good &= Check(std::abs(deviations[1] - deviations[0]) < 1e-5, "a turned wind has other gusts");
  statistics->UpdatePiece(1, 2, 0);
  good &= Check(Output(statistics, 0)->GetNumberOfRows() == 0, "a later piece has rows");
  return good;
}

bool BadWinds()
{
  using Filter = vtkWindStatisticsFilter;
  vtkNew<vtkWindFieldSource> wind;
  wind->SetDimensions(60, 8, 4);
  wind->Update();
  const auto fails = [&](const char* word, const std::function<void(Filter*)>& spoil) {
    vtkNew<Filter> filter;
    filter->SetInputConnection(wind->GetOutputPort());
    spoil(filter);
    return Fails(word, filter.Get());
  };
  bool good = fails("Height", [](Filter* f) { f->SetHeight(NaN); });
  good &= fails("Separation", [](Filter* f) { f->SetSeparation(-1.0, 0.0); });
  good &= fails("Separation", [](Filter* f) { f->SetSeparation(0.0, 0.0); });
  good &= fails("Separation", [](Filter* f) { f->SetSeparation(32.0, 0.0); });
  good &= fails("Separation", [](Filter* f) { f->SetSeparation(0.0, 8.0); });
  good &= fails("NumberOfBands", [](Filter* f) { f->SetNumberOfBands(1); });
  for (const char* name : { "RoughnessLength", "LateralDecay", "Spectrum", "ConvectionSpeed" })
  {
    vtkNew<vtkImageData> image;
    image->DeepCopy(wind->GetOutput());
    image->GetFieldData()->RemoveArray(name);
    good &= fails(name, [&](Filter* f) { f->SetInputData(image); });
  }
  vtkNew<vtkImageData> still;
  still->SetDimensions(8, 8, 8);
  good &= fails("Velocity", [&](Filter* f) { f->SetInputData(still); });
  vtkNew<vtkImageData> cut;
  cut->DeepCopy(wind->GetOutput());
  const int half[6] = { 0, 29, 0, 7, 0, 3 };
  cut->Crop(half);
  good &= fails("Period", [&](Filter* f) { f->SetInputData(cut); });
  return good;
}

bool SeaIsMeasured()
{
  vtkNew<vtkSeaStateSource> sea;
  sea->SetSeaByToHeightAndPeriod();
  sea->SetSignificantWaveHeight(3.0);
  sea->SetPeakPeriod(8.0);
  sea->SetMeanDirection(70.0);
  vtkNew<vtkSeaStatisticsFilter> statistics;
  statistics->SetInputConnection(sea->GetOutputPort());
  bool good = true;
  for (const bool equal : { false, true })
  {
    sea->SetEqualSpacing(equal);
    statistics->Update();
    vtkTable* spectrum = Output(statistics, 0);
    vtkTable* directions = Output(statistics, 1);
    // Hs^2 / 16, but for the half percent beyond the bins.
    good &= Check(std::abs(Area(spectrum, "Frequency", "Trains") / (9.0 / 16.0) - 0.995) < 0.004, "another energy");
    good &= Check(std::abs(Area(spectrum, "Frequency", "Spectrum") / (9.0 / 16.0) - 0.995) < 0.004, "another area");
    good &= Check(std::abs(Area(directions, "Direction", "Trains") - 1.0) < 1e-9, "directions do not add up");
    good &= Check(std::abs(FieldOf(spectrum, "MeanDirection") - 70.0) < 1e-6, "another mean direction");
    good &= Check(std::abs(FieldOf(spectrum, "PeakPeriod") - 8.0) < 1e-6, "another period");
    // Spreading is 10: cos^20(angle / 2)
    double ratio[2] = { 0.0, 0.0 };
    for (vtkIdType row = 0; row < directions->GetNumberOfRows(); ++row)
    {
      const double angle = directions->GetValueByName(row, "Direction").ToDouble() - 70.0;
      const double density = directions->GetValueByName(row, "Spreading").ToDouble();
      ratio[0] = std::abs(angle) < 1e-6 ? density : ratio[0];
      ratio[1] = std::abs(angle - 45.0) < 1e-6 ? density : ratio[1];
    }
    good &= Check(
      std::abs(ratio[1] / ratio[0] - std::pow(std::cos(std::acos(-1.0) / 8.0), 20.0)) < 1e-6, "another spreading");
  }
  statistics->UpdatePiece(1, 2, 0);
  good &= Check(Output(statistics, 1)->GetNumberOfRows() == 0, "a later piece has rows");
  return good;
}

bool BadSeas()
{
  vtkNew<vtkSeaStateSource> sea;
  vtkNew<vtkSeaStatisticsFilter> statistics;
  statistics->SetInputConnection(sea->GetOutputPort());
  bool good = true;
  for (const int sectors : { 3, 3601 })
  {
    statistics->SetNumberOfSectors(sectors);
    good &= Fails("NumberOfSectors", statistics.Get());
  }
  statistics->SetNumberOfSectors(24);
  sea->SetSpectrumToRegular();
  good &= Fails("Regular", statistics.Get());
  vtkNew<vtkTable> bare;
  statistics->SetInputData(bare);
  good &= Fails("no wave trains", statistics.Get());
  return good;
}

}

int TestStatisticsFilters(int, char*[])
{
  return WindIsMeasured() && BadWinds() && SeaIsMeasured() && BadSeas() ? EXIT_SUCCESS : EXIT_FAILURE;
}
