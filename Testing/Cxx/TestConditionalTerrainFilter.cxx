// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Fields through data in the pipeline: closed forms of one datum, data met, tables, parts, holes, every bad input.
#include "Check.h"
#include "ErrorCounter.h"
#include "vtkConditionalTerrainFilter.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{

using Filter = vtkConditionalTerrainFilter;

constexpr double Deviation = 2.0;
constexpr double Mean = 50.0;
constexpr double Range = 8.0;
constexpr int Columns = 31;
constexpr int Rows = 21;

/// Places and heights as points without an array: z is the height.
vtkNew<vtkPolyData> Survey(const std::vector<std::array<double, 3>>& data)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& datum : data)
  {
    points->InsertNextPoint(datum.data());
  }
  vtkNew<vtkPolyData> survey;
  survey->SetPoints(points);
  return survey;
}

const std::vector<std::array<double, 3>> Three = { { 10.0, 12.0, 47.0 }, { 40.0, 30.0, 53.5 }, { 58.7, 3.3, 51.0 } };

vtkNew<vtkImageData> Grid()
{
  vtkNew<vtkImageData> grid;
  grid->SetDimensions(Columns, Rows, 1);
  grid->SetSpacing(2.0, 3.0, 1.0);
  return grid;
}

vtkNew<Filter> Conditional(vtkDataObject* data, vtkImageData* grid)
{
  vtkNew<Filter> filter;
  filter->SetInputDataObject(0, data);
  if (grid)
  {
    filter->SetInputDataObject(1, grid);
  }
  filter->SetModelToSimpleExponential();
  filter->SetStandardDeviation(Deviation);
  filter->SetRange(Range);
  filter->SetMean(Mean);
  filter->UseDataMeanOff();
  filter->SetKrigingTypeToSimple();
  filter->SetNumberOfLines(16);
  return filter;
}

vtkDoubleArray* ArrayOf(Filter* filter, const char* name)
{
  return vtkDoubleArray::SafeDownCast(filter->GetOutput()->GetPointData()->GetArray(name));
}

/// One datum: the simple kriging estimate is m + (z - m) exp(-h / a), and its variance C (1 - exp(-2 h / a)).
bool EstimateFromOneDatum()
{
  const auto survey = Survey({ { 10.0, 12.0, 47.0 } });
  const auto grid = Grid();
  const auto filter = Conditional(survey, grid);
  filter->SetResultToKrigingEstimate();
  filter->KrigingVarianceOn();
  filter->Update();
  vtkDoubleArray* heights = ArrayOf(filter, "Elevation");
  vtkDoubleArray* variances = ArrayOf(filter, "KrigingVariance");
  if (!Check(heights && variances, "There is no estimate, or no variance"))
  {
    return false;
  }
  double most = 0.0;
  for (int n = 0; n < Columns * Rows; ++n)
  {
    const double decay = std::exp(-std::hypot(2.0 * (n % Columns) - 10.0, 3.0 * (n / Columns) - 12.0) / Range);
    most = std::max(most, std::abs(heights->GetValue(n) - (Mean - 3.0 * decay)));
    most = std::max(most, std::abs(variances->GetValue(n) - Deviation * Deviation * (1.0 - decay * decay)));
  }
  return Check(most < 1e-6, "The estimate from one datum is off by " + std::to_string(most));
}

/// The field meets its data, the table says so, and a part is a part of the whole.
bool FieldThroughData()
{
  const auto survey = Survey(Three);
  const auto grid = Grid();
  const auto filter = Conditional(survey, grid);
  filter->CrossValidationOn();
  filter->Update();
  vtkDoubleArray* heights = ArrayOf(filter, "Elevation");
  bool good = Check(heights && heights->GetNumberOfTuples() == Columns * Rows, "There is no field");
  good = good && Check(std::abs(heights->GetValue(4 * Columns + 5) - 47.0) < 1e-6, "A datum is missed");
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  good = good && Check(table->GetNumberOfRows() == 3, "There is not a row a datum");
  for (vtkIdType row = 0; good && row < 3; ++row)
  {
    good &= Check(table->GetValueByName(row, "Value").ToDouble() == Three[row][2], "A value of the table");
    good &=
      Check(std::abs(table->GetValueByName(row, "Field").ToDouble() - Three[row][2]) < 1e-6, "A field at a datum");
    // So far apart the others tell next to nothing of a datum.
    const double wanted = (Three[row][2] - Mean) / Deviation;
    const double error = table->GetValueByName(row, "StandardizedError").ToDouble();
    good &= Check(std::abs(error - wanted) < 0.05, "A standardized error is " + std::to_string(error));
  }
  good = good && Check(table->GetFieldData()->GetArray("RootMeanSquareError") != nullptr, "No error of the estimates");
  auto* vertices = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(2));
  good = good && Check(vertices->GetNumberOfVerts() == 3, "There is not a vertex a datum");
  const std::vector<double> whole(heights->GetPointer(0), heights->GetPointer(0) + heights->GetNumberOfValues());

  const int part[6] = { 7, 12, 3, 20, 0, 0 };
  filter->Modified();
  filter->UpdateExtent(part);
  vtkImageData* output = filter->GetOutput();
  good &= Check(output->GetNumberOfPoints() == 6 * 18, "The part has other points than asked for");
  for (int j = 3; good && j <= 20; ++j)
  {
    for (int i = 7; i <= 12; ++i)
    {
      good &= output->GetScalarComponentAsDouble(i, j, 0, 0) == whole[static_cast<std::size_t>(j) * Columns + i];
    }
  }
  return Check(good, "Of the field, its table or its part");
}

/// The table of the variogram, against the definition: pairs up to half the diagonal in 15 classes, and the model.
bool VariogramOfData()
{
  std::vector<std::array<double, 3>> data;
  for (int n = 0; n < 60; ++n)
  {
    data.push_back({ std::fmod(37.3 * n, 61.0), std::fmod(23.9 * n, 43.0), 50.0 + std::fmod(7.7 * n, 5.0) });
  }
  std::array<double, 4> bounds{ data[0][0], data[0][0], data[0][1], data[0][1] };
  for (const auto& datum : data)
  {
    bounds = { std::min(bounds[0], datum[0]), std::max(bounds[1], datum[0]), std::min(bounds[2], datum[1]),
      std::max(bounds[3], datum[1]) };
  }
  const double width = 0.5 * std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2]) / 15.0;
  const auto survey = Survey(data);
  const auto filter = Conditional(survey, nullptr);
  filter->SetNugget(0.25);
  filter->Update();
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(3));
  bool good = true;
  vtkIdType row = 0;
  for (int index = 0; good && index < 15; ++index)
  {
    double pairs = 0.0;
    double lag = 0.0;
    double squares = 0.0;
    for (std::size_t a = 0; a < data.size(); ++a)
    {
      for (std::size_t b = 0; b < a; ++b)
      {
        const double distance = std::hypot(data[a][0] - data[b][0], data[a][1] - data[b][1]);
        if (distance >= width * index && distance < width * (index + 1))
        {
          pairs += 1.0;
          lag += distance;
          squares += (data[a][2] - data[b][2]) * (data[a][2] - data[b][2]);
        }
      }
    }
    const auto is = [&](const char* name, double wanted) {
      const double found = table->GetValueByName(row, name).ToDouble();
      return Check(std::abs(found - wanted) < 1e-9 * wanted,
        std::string(name) + " of a class is " + std::to_string(found) + ", not " + std::to_string(wanted));
    };
    if (pairs == 0.0)
    {
      continue;
    }
    good = Check(row < table->GetNumberOfRows(), "A class without a row") && is("Pairs", pairs) &&
      is("Lag", lag / pairs) && is("Semivariance", squares / (2.0 * pairs)) &&
      is("Fitted", 0.25 + Deviation * Deviation * (1.0 - std::exp(-lag / pairs / Range)));
    ++row;
  }
  good = good && Check(row > 10 && row == table->GetNumberOfRows(), "There is not a row a class");
  // One datum has no pairs.
  const auto one = Conditional(Survey({ data[0] }), Grid());
  one->Update();
  return Check(vtkTable::SafeDownCast(one->GetOutputDataObject(3))->GetNumberOfRows() == 0, "A pair of one") && good;
}

/// An image keeps what it has, and its holes are filled.
bool FillsHoles()
{
  const auto image = Grid();
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Elevation");
  heights->SetNumberOfTuples(Columns * Rows);
  for (int n = 0; n < Columns * Rows; ++n)
  {
    heights->SetValue(n, n % 7 == 3 ? std::numeric_limits<double>::quiet_NaN() : Mean + n % 5);
  }
  image->GetPointData()->SetScalars(heights);
  const auto filter = Conditional(image, nullptr);
  filter->Update();
  vtkDoubleArray* filled = ArrayOf(filter, "Elevation");
  bool good = Check(filled != nullptr, "There is no filled image");
  for (int n = 0; good && n < Columns * Rows; ++n)
  {
    const bool isHole = n % 7 == 3;
    good &= isHole ? std::isfinite(filled->GetValue(n)) : filled->GetValue(n) == heights->GetValue(n);
  }
  good &= Check(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(2))->GetNumberOfPoints() == 0,
    "The points of an image hide its field");
  return Check(good, "A height changes, or a hole is left");
}

/// Far from all data simple kriging tells its mean: the given one, or that of the data.
bool MeanFarFromData()
{
  const auto survey = Survey(Three);
  const auto grid = Grid();
  grid->SetOrigin(1e4, 1e4, 0.0);
  const auto filter = Conditional(survey, grid);
  filter->SetResultToKrigingEstimate();
  filter->Update();
  bool good = Check(std::abs(ArrayOf(filter, "Elevation")->GetValue(0) - Mean) < 1e-9, "The given mean is not taken");
  filter->UseDataMeanOn();
  filter->Update();
  good &= Check(std::abs(ArrayOf(filter, "Elevation")->GetValue(0) - (47.0 + 53.5 + 51.0) / 3.0) < 1e-9,
    "The mean of the data is not taken");
  return good;
}

/// A setting, and a word of the one message that it must give.
struct Mistake
{
  std::function<void(Filter*)> Make;
  const char* Word;
};

bool BadInput()
{
  const std::vector<Mistake> mistakes = {
    { [](Filter* filter) { filter->SetResult(2); }, "Result" },
    { [](Filter* filter) { filter->SetKrigingType(-1); }, "KrigingType" },
    { [](Filter* filter) { filter->SetModel(7); }, "Model" },
    { [](Filter* filter) { filter->SetStandardDeviation(0.0); }, "StandardDeviation" },
    { [](Filter* filter) { filter->SetRange(-1.0); }, "Range" },
    { [](Filter* filter) { filter->SetMean(std::numeric_limits<double>::infinity()); }, "Mean" },
    { [](Filter* filter) { filter->SetNugget(-1.0); }, "Nugget" },
    { [](Filter* filter) { filter->SetNumberOfNeighbors(-1); }, "NumberOfNeighbors" },
    { [](Filter* filter) { filter->SetNumberOfLines(100001); }, "NumberOfLines" },
    { [](Filter* filter) { filter->SetErrorArray("Nothing"); }, "array Nothing" },
    { [](Filter* filter) { filter->SetKrigingTypeToExternalDrift(); }, "drift" },
    { [](Filter* filter) { filter->SetKrigingTypeToQuadraticDrift(); }, "data" }, // six unknowns of three data
    { [](Filter* filter) { filter->SetInputDataObject(0, Survey({})); }, "data" },
    { [](Filter* filter) {
       filter->SetInputDataObject(0, Survey({ Three[0], Three[0] }));
     },
      "with the same value" },
    { [](Filter* filter) { filter->SetModelToFittedToData(); }, "data" },
  };
  bool good = true;
  for (const Mistake& mistake : mistakes)
  {
    const auto survey = Survey(Three);
    const auto grid = Grid();
    const auto filter = Conditional(survey, grid);
    vtkNew<ErrorCounter> errors;
    errors->Watch(filter);
    mistake.Make(filter);
    good &= errors->ExpectOneNaming(mistake.Word);
    good &= Check(!ArrayOf(filter, "Elevation"), std::string("A field in spite of ") + mistake.Word);
  }
  const auto survey = Survey(Three);
  const auto filter = Conditional(survey, nullptr);
  vtkNew<ErrorCounter> errors;
  errors->Watch(filter);
  filter->SetDimensions(1, 5);
  return errors->ExpectOneNaming("Dimensions, x") && good;
}

}

int TestConditionalTerrainFilter(int, char*[])
{
  bool good = EstimateFromOneDatum();
  good &= FieldThroughData();
  good &= VariogramOfData();
  good &= FillsHoles();
  good &= MeanFarFromData();
  good &= BadInput();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
