// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause

// Grows a field through measured heights, without VTK, and writes it as an ESRI grid:
//   GrowThroughData survey.csv field.asc [seed]
// The survey has a line of names, and the columns x, y and height [m]. Examples/Data/survey.csv is one, of 120 places
// on a terrain of four kilometres.

#include <Kriging/ConditionalField.h>
#include <Kriging/FieldAtData.h>
#include <Numerics/InvalidInput.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using Survey = littoral::KrigingSurvey;

//------------------------------------------------------------------------------
Survey ReadSurvey(const std::string& path)
{
  Survey survey;
  std::ifstream file(path);
  std::string line;
  std::getline(file, line); // names
  while (std::getline(file, line))
  {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream numbers(line);
    littoral::KrigingPlace place;
    double height = 0.0;
    if (!(numbers >> place.X >> place.Y >> height))
    {
      throw std::runtime_error("not x, y and height: " + line);
    }
    survey.Data.Places.push_back(place);
    survey.Data.Values.push_back(height);
  }
  survey.Measured = survey.Data.Values;
  return survey;
}

//------------------------------------------------------------------------------
/// A grid of square cells over the survey, with so many of them along its longer side.
void CoverWithCells(Survey& survey, int cells)
{
  const auto [left, right] = std::minmax_element(survey.Data.Places.begin(), survey.Data.Places.end(),
    [](const littoral::KrigingPlace& a, const littoral::KrigingPlace& b) { return a.X < b.X; });
  const auto [bottom, top] = std::minmax_element(survey.Data.Places.begin(), survey.Data.Places.end(),
    [](const littoral::KrigingPlace& a, const littoral::KrigingPlace& b) { return a.Y < b.Y; });
  const double width = right->X - left->X;
  const double height = top->Y - bottom->Y;
  const double cell = std::max(width, height) / cells;
  survey.Grid = { { left->X, bottom->Y }, { cell, cell } };
  survey.Window.Last = { static_cast<int>(std::ceil(width / cell)), static_cast<int>(std::ceil(height / cell)) };
  littoral::SnapToGrid(survey.Grid, survey.Data.Places);
}

//------------------------------------------------------------------------------
void WriteGrid(const Survey& survey, const std::vector<double>& heights, const std::string& path)
{
  const int columns = survey.Window.Last[0] + 1;
  const int rows = survey.Window.Last[1] + 1;
  std::ofstream file(path);
  file << std::setprecision(10) << "ncols " << columns << "\nnrows " << rows << "\nxllcenter " << survey.Grid.Origin[0]
       << "\nyllcenter " << survey.Grid.Origin[1] << "\ncellsize " << survey.Grid.Spacing[0] << '\n';
  for (int j = rows - 1; j >= 0; --j) // from the north
  {
    for (int i = 0; i < columns; ++i)
    {
      file << heights[survey.Index(i, j)] << (i + 1 < columns ? ' ' : '\n');
    }
  }
  if (!file.flush())
  {
    throw std::runtime_error("could not write " + path);
  }
}

//------------------------------------------------------------------------------
void GrowThrough(Survey survey, int seed, const std::string& path)
{
  littoral::Require(littoral::WhyInvalid(survey.Data, survey.Model));
  CoverWithCells(survey, 200);
  littoral::TakeNeighbors(0, survey);
  littoral::FitModel(survey);
  std::cout << survey.Data.Places.size() << " heights, model "
            << littoral::CovarianceModelName(survey.Model.Field.Model) << ", standard deviation "
            << std::sqrt(survey.Model.Field.Variance) << " m, range " << survey.Model.Field.Range << " m\n";

  littoral::ConditionalOptions options;
  options.Seed = seed;
  littoral::ConditionalField field(survey, options);
  field.Tabulate();
  field.Solve();
  std::vector<double> heights(survey.Index(survey.Window.Last[0], survey.Window.Last[1]) + 1);
  field.Fill(survey.Window, heights.data());

  const std::vector<double> there = field.AtData();
  double most = 0.0;
  for (std::size_t n = 0; n < there.size(); ++n)
  {
    most = std::max(most, std::abs(there[n] - survey.Measured[n]));
  }
  std::cout << "the field misses the data by at most " << most << " m\n";
  WriteGrid(survey, heights, path);
  std::cout << "written: " << path << '\n';
}

} // anonymous namespace

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  if (argc < 3)
  {
    std::cerr << "usage: " << argv[0] << " survey.csv field.asc [seed]\n";
    return EXIT_FAILURE;
  }
  try
  {
    GrowThrough(ReadSurvey(argv[1]), argc > 3 ? std::atoi(argv[3]) : 1, argv[2]);
    return EXIT_SUCCESS;
  }
  catch (const std::exception& failure)
  {
    std::cerr << failure.what() << '\n';
    return EXIT_FAILURE;
  }
}
