// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Statistics of ground through the pipeline: tables, sea level, pieces, memory, and every bad input.
#include "Check.h"
#include "ErrorCounter.h"
#include "GroundImage.h"
#include "Sanitizer.h"
#include "vtkGroundStatisticsFilter.h"
#include "vtkTurningBandsTerrainSource.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <cmath>
#include <functional>
#include <limits>

#ifndef _WIN32
#include <sys/resource.h>
#endif

namespace
{

const double NaN = std::numeric_limits<double>::quiet_NaN();

vtkTable* Output(vtkAlgorithm* filter, int port)
{
  return vtkTable::SafeDownCast(filter->GetOutputDataObject(port));
}

double Value(vtkTable* table, const char* column, vtkIdType row = 0)
{
  return table->GetValueByName(row, column).ToDouble();
}

bool Fails(const char* word, vtkImageData* image, const std::function<void(vtkGroundStatisticsFilter*)>& spoil = {})
{
  vtkNew<vtkGroundStatisticsFilter> statistics;
  statistics->SetInputData(image);
  if (spoil)
  {
    spoil(statistics);
  }
  bool good = FailsNaming(word, statistics);
  for (int port = 0; port < 6; ++port)
  {
    good &= Check(Output(statistics, port)->GetNumberOfColumns() == 0, "a refused input leaves a table");
  }
  return good;
}

/// A pit of 2 x 3 cells, 5 m deep, in a ramp of slope 0.3 along x and 0.025 along y.
bool NumbersAreKnown()
{
  const auto image =
    Image(40, 30, 1, [](int i, int j) { return i >= 10 && i < 12 && j >= 10 && j < 13 ? -500.0 : Ramp(i, j); });
  vtkNew<vtkGroundStatisticsFilter> statistics;
  statistics->SetInputData(image);
  statistics->SetStreamThreshold(5);
  statistics->Update();
  vtkTable* numbers = Output(statistics, 0);
  bool good = Check(numbers->GetNumberOfRows() == 1 && numbers->GetNumberOfColumns() == 19, "not a row of 19");
  good &= Check(std::abs(Value(numbers, "DepressionFraction") - 6.0 / 1200.0) < 1e-15, "another share of sunk cells");
  statistics->SetInputData(Image(40, 30, 1, Ramp));
  statistics->Update();
  good &= Check(std::abs(Value(numbers, "DepressionFraction")) < 1e-15, "a ramp has sunk cells");
  good &= Check(std::abs(Value(numbers, "MeanSlope") - std::hypot(0.3, 0.025)) < 1e-12, "another slope");
  good &= Check(std::abs(Value(numbers, "HypsometricIntegral") - 0.5) < 1e-12, "another integral");
  vtkTable* distribution = Output(statistics, 2);
  good &= Check(distribution->GetNumberOfRows() == 101, "not a row a percent");
  good &= Check(Value(distribution, "Fraction", 100) == 1.0 && Value(distribution, "Elevation", 0) == 0.0 &&
      Value(distribution, "Elevation", 100) == Ramp(39, 29),
    "other ends of the distribution");
  vtkTable* streams = Output(statistics, 3);
  good &= Check(streams->GetNumberOfRows() == 1, "parallel streams have orders");
  good &= Check(Value(streams, "Streams") == 28.0, "not a stream in each inner row");
  vtkTable* forms = Output(statistics, 4);
  good &= Check(forms->GetNumberOfRows() == 10 && Value(forms, "Share", 5) == 1.0, "a ramp is no slope");
  good &=
    Check(forms->GetValueByName(5, "Name").ToString() == "slope" && Value(forms, "Form", 5) == 6.0, "other names");
  vtkTable* relief = Output(statistics, 5); // cells 10 to 40 m off are 1 to 3 cells of 14.1 m off
  good &= Check(relief->GetNumberOfRows() == 3, "other distances to streams");
  good &= Check(std::abs(Value(relief, "Height", 1) / Value(relief, "Distance", 1) - 0.3) < 1e-9, "another relief");
  return good;
}

/// Within a bowl all inner ground is sunk; a sea in it drains what is above.
bool SeaDrainsABowl()
{
  vtkNew<vtkGroundStatisticsFilter> statistics;
  statistics->SetInputData(Image(21, 21, 1, [](int i, int j) { return std::hypot(i - 10.0, j - 10.0) - 3.0; }));
  statistics->Update();
  bool good = Check(Value(Output(statistics, 0), "DepressionFraction") > 0.5, "a bowl is not sunk");
  statistics->UseSeaLevelOn();
  statistics->Update();
  good &= Check(Value(Output(statistics, 0), "DepressionFraction") == 0.0, "ground above the sea is sunk");
  return good;
}

/// The tables of a large terrain: bins by the cells that drain, and the law through them.
bool ProfileIsFitted()
{
  vtkNew<vtkTurningBandsTerrainSource> terrain;
  terrain->SetWholeExtent(0, 159, 0, 149, 0, 0);
  vtkNew<vtkGroundStatisticsFilter> statistics;
  statistics->SetInputConnection(terrain->GetOutputPort());
  statistics->Update();
  vtkTable* profile = Output(statistics, 1);
  bool good = Check(profile->GetNumberOfRows() > 10, "few bins");
  const double concavity = Value(Output(statistics, 0), "Concavity");
  const double steepness = Value(Output(statistics, 0), "Steepness");
  double rest = 0.0; // of least squares: residuals of the logarithms sum to 0
  for (vtkIdType row = 0; row < profile->GetNumberOfRows(); ++row)
  {
    const double law = steepness * std::pow(Value(profile, "DrainageArea", row), -concavity);
    good &= Check(std::abs(Value(profile, "PowerLaw", row) / law - 1.0) < 1e-12, "another law");
    good &= Check(Value(profile, "DrainageArea", row) >= 100 * 4.0, "a bin of a smaller area");
    rest += std::log(Value(profile, "Slope", row) / law);
  }
  good &= Check(std::abs(rest) < 1e-9, "the law is not that of least squares");
  for (const char* name : { "HackExponent", "BifurcationRatio", "LengthRatio", "AreaRatio", "CurvatureSkewness" })
  {
    good &= Check(std::isfinite(Value(Output(statistics, 0), name)), name);
  }
  statistics->UpdatePiece(1, 2, 0);
  return good && Check(Output(statistics, 0)->GetNumberOfRows() == 0, "a later piece has rows");
}

/// What the memory does not suffice for is refused, and a smaller terrain is then measured.
bool MemoryIsAsked()
{
  bool good = true;
#ifndef _WIN32
  const auto large = Image(1200, 1100, 1, Ramp); // needs 132 MB
  vtkNew<vtkGroundStatisticsFilter> statistics;
  statistics->SetInputData(large);
  vtkNew<ErrorCounter> errors;
  errors->Watch(statistics);
  rlimit before;
  getrlimit(RLIMIT_DATA, &before);
  rlimit limit = before;
  limit.rlim_cur = static_cast<rlim_t>(1) << 20; // less than what is used
  if (!IsSanitized && before.rlim_max == RLIM_INFINITY && setrlimit(RLIMIT_DATA, &limit) == 0)
  {
    good &= errors->ExpectOneNaming("of memory");
    setrlimit(RLIMIT_DATA, &before);
    statistics->SetInputData(Image(30, 30, 1, Ramp));
    statistics->Update();
    good &= Check(Output(statistics, 0)->GetNumberOfRows() == 1, "nothing is measured after a refusal");
  }
#endif
  return good;
}

bool BadInput()
{
  using Filter = vtkGroundStatisticsFilter;
  const auto good = Image(20, 20, 1, Ramp);
  bool passed = Fails("constant", Image(20, 20, 1, [](int, int) { return 5.0; }));
  passed &= Fails("no heights", Image(20, 20, 1, [](int, int) { return NaN; }));
  passed &= Fails("beyond", Image(20, 20, 1, [](int i, int j) { return i == 3 ? 1e300 : Ramp(i, j); }));
  passed &= Fails("20 x 1", Image(20, 1, 1, Ramp));
  passed &= Fails("2 x 20", Image(2, 20, 1, Ramp));
  passed &= Fails("20 x 20 x 3", Image(20, 20, 3, Ramp));
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(20, 20, 1);
  passed &= Fails("scalar point array", bare);
  passed &= Fails("'Depth'", good,
    [](Filter* filter) { filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Depth"); });
  passed &= Fails("StreamThreshold", good, [](Filter* filter) { filter->SetStreamThreshold(1); });
  passed &= Fails("SearchRadius", good, [](Filter* filter) { filter->SetSearchRadius(0); });
  passed &= Fails("Flatness", good, [](Filter* filter) { filter->SetFlatness(46.0); });
  passed &= Fails("SeaLevel", good, [](Filter* filter) { filter->SetSeaLevel(NaN); });
  return passed;
}

}

int TestGroundStatisticsFilter(int, char*[])
{
  return NumbersAreKnown() && SeaDrainsABowl() && ProfileIsFitted() && MemoryIsAsked() && BadInput() ? EXIT_SUCCESS
                                                                                                     : EXIT_FAILURE;
}
