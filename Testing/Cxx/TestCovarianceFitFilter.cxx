// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The fit of a grown terrain: its tables, its trend, missing values, and every bad input.
#include "ErrorCounter.h"
#include "vtkCovarianceFitFilter.h"
#include "vtkTurningBandsTerrainSource.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <cmath>
#include <functional>
#include <limits>

namespace
{

bool Near(const char* what, double value, double wanted, double tolerance)
{
  if (std::abs(value - wanted) <= tolerance)
  {
    return true;
  }
  std::cerr << what << " is " << value << ", wanted " << wanted << " +- " << tolerance << std::endl;
  return false;
}

double Value(vtkTable* table, const char* column)
{
  return table->GetValueByName(0, column).ToDouble();
}

vtkNew<vtkImageData> Image(int nx, int ny, int nz, const std::function<float(int, int)>& valueAt)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(nx, ny, nz);
  vtkNew<vtkFloatArray> values;
  values->SetName("Elevation");
  for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
  {
    values->InsertNextValue(valueAt(n % nx, n / nx % ny));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

bool Fails(const char* word, vtkImageData* image, const std::function<void(vtkCovarianceFitFilter*)>& spoil = {})
{
  vtkNew<vtkCovarianceFitFilter> fit;
  fit->SetInputData(image);
  if (spoil)
  {
    spoil(fit);
  }
  vtkNew<ErrorCounter> errors;
  errors->Watch(fit);
  bool good = errors->ExpectOneNaming(word);
  for (int port : { 0, 1 })
  {
    vtkTable* output = vtkTable::SafeDownCast(fit->GetOutputDataObject(port));
    good &= output->GetNumberOfRows() == 0 && output->GetNumberOfColumns() == 0;
  }
  return good;
}

bool CheckBadInput()
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto rough = [](int i, int j) { return static_cast<float>((i * 7919 + j * 104729) % 101); };
  bool good = true;
  good &= Fails("constant", Image(20, 20, 1, [](int, int) { return 5.0f; }));
  good &= Fails("plane", Image(20, 20, 1, [](int i, int j) { return 5.0f + i - 2.0f * j; }));
  good &= Fails("NaN", Image(20, 20, 1, [=](int, int) { return nan; }));
  good &= Fails("NaN", Image(20, 20, 1, [](int, int) { return -9999.0f; }),
    [](vtkCovarianceFitFilter* fit) { fit->UseNoDataValueOn(); });
  good &= Fails("2 x 2", Image(2, 2, 1, rough));
  good &= Fails("20 x 20 x 4", Image(20, 20, 4, rough));
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(20, 20, 1);
  good &= Fails("scalar point array", bare);
  const auto image = Image(20, 20, 1, rough);
  const double badLengths[] = { -1.0, std::numeric_limits<double>::quiet_NaN() };
  for (double bad : badLengths)
  {
    good &= Fails("MaximumLag", image, [=](vtkCovarianceFitFilter* fit) { fit->SetMaximumLag(bad); });
    good &= Fails("LongestRange", image, [=](vtkCovarianceFitFilter* fit) { fit->SetLongestRange(bad); });
  }
  good &= Fails("NumberOfLags", image, [](vtkCovarianceFitFilter* fit) { fit->SetNumberOfLags(0); });
  good &= Fails("NumberOfDirections", image, [](vtkCovarianceFitFilter* fit) { fit->SetNumberOfDirections(0); });
  good &= Fails("No model", image, [](vtkCovarianceFitFilter* fit) { fit->SetMaximumLag(0.1); });
  return good;
}

}

int TestCovarianceFitFilter(int, char*[])
{
  vtkNew<vtkTurningBandsTerrainSource> terrain;
  terrain->SetWholeExtent(0, 383, 0, 319, 0, 0);
  terrain->SetSpacing(5.0, 10.0, 1.0);
  terrain->SetModelToSpherical();
  terrain->SetRange(250.0);
  terrain->SetStandardDeviation(20.0);
  terrain->SetMean(700.0);
  terrain->SetSlope(0.05, -0.02);
  vtkNew<vtkCovarianceFitFilter> fit;
  fit->SetInputConnection(terrain->GetOutputPort());
  fit->Update();
  vtkTable* table = fit->GetOutput();
  bool good = table->GetNumberOfRows() == 7;
  good &= table->GetValueByName(0, "Model").ToString() == "Spherical";
  good &= Near("ModelId", Value(table, "ModelId"), vtkTurningBandsTerrainSource::Spherical, 0.0);
  good &= Near("Variance", Value(table, "Variance"), 400.0, 80.0);
  good &= Near("Range", Value(table, "Range"), 250.0, 50.0);
  good &= Near("AnisotropyRatio", Value(table, "AnisotropyRatio"), 1.0, 0.15);
  good &= Near("Mean", Value(table, "Mean"), 700.0, 5.0);
  good &= Near("SlopeX", Value(table, "SlopeX"), 0.05, 0.01);
  good &= Near("SlopeY", Value(table, "SlopeY"), -0.02, 0.01);
  vtkTable* variogram = vtkTable::SafeDownCast(fit->GetOutputDataObject(1));
  for (const char* name : { "Lag", "Semivariance", "Pairs", "Spherical", "Semivariance_000", "Semivariance_165" })
  {
    if (!variogram->GetColumnByName(name))
    {
      std::cerr << "no column " << name << std::endl;
      good = false;
    }
  }

  // A third of the values missing, as NaN or as a mark, changes little.
  const auto marked = [&](float mark) {
    vtkNew<vtkImageData> holes;
    holes->DeepCopy(terrain->GetOutput());
    vtkFloatArray* values = vtkFloatArray::SafeDownCast(holes->GetPointData()->GetScalars());
    for (vtkIdType n = 0; n < values->GetNumberOfValues(); n += 3)
    {
      values->SetValue(n, mark);
    }
    vtkNew<vtkCovarianceFitFilter> other;
    other->SetInputData(holes);
    other->SetUseNoDataValue(!std::isnan(mark));
    other->SetNoDataValue(mark);
    other->Update();
    return Near("Range with holes", Value(other->GetOutput(), "Range"), Value(table, "Range"), 10.0) &&
      Near("Count", other->GetOutput()->GetFieldData()->GetArray("NumberOfValues")->GetTuple1(0), 81920.0, 0.0);
  };
  good &= marked(std::numeric_limits<float>::quiet_NaN());
  good &= marked(-32768.0f);

  // The table drives the source: a twin is fitted alike.
  vtkNew<vtkTurningBandsTerrainSource> twin;
  twin->SetInputConnection(fit->GetOutputPort());
  twin->SetWholeExtent(terrain->GetWholeExtent());
  twin->SetSpacing(terrain->GetSpacing());
  twin->SetSeed(77);
  vtkNew<vtkCovarianceFitFilter> second;
  second->SetInputConnection(twin->GetOutputPort());
  second->Update();
  good &= second->GetOutput()->GetValueByName(0, "Model").ToString() == "Spherical";
  good &= Near("Variance of the twin", Value(second->GetOutput(), "Variance") / Value(table, "Variance"), 1.0, 0.25);

  good &= CheckBadInput();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
