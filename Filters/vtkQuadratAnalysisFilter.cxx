// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkQuadratAnalysisFilter.h"

#include "Data/Inputs.h"
#include "Data/Tables.h"
#include "Patterns/PatternVerdict.h"
#include "Patterns/QuadratFit.h"
#include "Patterns/QuadratPattern.h"
#include "Pipeline/Pipeline.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkTable.h"

#include <limits>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkQuadratAnalysisFilter);

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
/// Fewer points say nothing about a pattern.
constexpr long long FewestPoints = 5;
/// Laws of clusters cost the square of the largest count.
constexpr std::size_t LargestCount = 20000;
constexpr double SignificanceLevel = 0.05;
constexpr const char* CannotAnalyse = "Cannot analyse: ";

using Fit = littoral::QuadratFit;

/// A parameter of a law, NaN where the law has no such parameter.
double ValueIn(
  const littoral::QuadratLawParameters& law, const littoral::ParameterTraits<littoral::QuadratLawParameters>& parameter)
{
  return littoral::TraitsOf(law.Law).Parameters.Has(parameter.Name) ? parameter.Get(law) : NaN;
}

void WriteFits(const std::vector<Fit>& fits, vtkTable* table)
{
  using namespace littoral;
  AddColumn(table, "Law", fits, [](const Fit& fit) { return std::string(QuadratLawName(fit.Law.Law)); });
  AddColumn(table, "LawId", fits, [](const Fit& fit) { return static_cast<int>(fit.Law.Law); });
  const auto column = [&](const char* name, auto valueOf) { AddColumn(table, name, fits, valueOf); };
  const auto& parameters = AllQuadratLawParameters();
  for (const auto* parameter : parameters)
  {
    column(parameter->Name, [=](const Fit& fit) { return ValueIn(fit.Law, *parameter); });
  }
  // The first is the mean, which all fits keep.
  for (auto each = parameters.begin() + 1; each != parameters.end(); ++each)
  {
    const auto* parameter = *each;
    column((std::string("Moments") + parameter->Name).c_str(),
      [=](const Fit& fit) { return fit.MomentsExist ? ValueIn(fit.Moments, *parameter) : NaN; });
  }
  column("LogLikelihood", [](const Fit& fit) { return fit.LogLikelihood; });
  column("AIC", [](const Fit& fit) { return fit.AIC; });
  column("ChiSquare", [](const Fit& fit) { return fit.ChiSquare; });
  column("DegreesOfFreedom", [](const Fit& fit) { return static_cast<double>(fit.DegreesOfFreedom); });
  column("PValue", [](const Fit& fit) { return fit.PValue; });
  column("Verdict", [&](const Fit& fit) { return std::string(WordOf(VerdictOf(fit, fits.front()))); });
}

void WriteFrequencies(
  const std::vector<long long>& frequencies, const std::vector<Fit>& fits, double quadrats, vtkTable* table)
{
  using namespace littoral;
  std::vector<int> counts(frequencies.size());
  for (std::size_t r = 0; r < counts.size(); ++r)
  {
    counts[r] = static_cast<int>(r);
  }
  AddColumn(table, "Points", counts, [](int r) { return r; });
  AddColumn(table, "Observed", counts, [&](int r) { return static_cast<double>(frequencies[r]); });
  for (const Fit& fit : fits)
  {
    const std::vector<double> mass = MassFunctionUpTo(fit.Law, static_cast<int>(frequencies.size()) - 1);
    AddColumn(table, QuadratLawName(fit.Law.Law), counts, [&](int r) { return quadrats * mass[r]; });
  }
}

/// Adds the dispersion of the points over the quadrats as field data.
void AddPattern(const littoral::QuadratMoments& moments, const littoral::QuadratGrid& grid, vtkTable* table)
{
  const bool random = moments.DispersionPValue > SignificanceLevel;
  littoral::AddField(table, "DispersionIndex", { moments.DispersionIndex });
  littoral::AddField(table, "DispersionPValue", { moments.DispersionPValue });
  littoral::AddText(table, "Pattern", random ? "random" : moments.DispersionIndex < 1.0 ? "regular" : "clustered");
  littoral::AddField(table, "Origin", { grid.Origin[0], grid.Origin[1] });
  littoral::AddField(table, "Size", { grid.Size[0], grid.Size[1] });
  littoral::AddField(table, "Quadrats", { static_cast<double>(grid.Count[0]), static_cast<double>(grid.Count[1]) });
}

}

//----------------------------------------------------------------------------
vtkQuadratAnalysisFilter::vtkQuadratAnalysisFilter()
  : Origin{ 0.0, 0.0 }
  , Size{ 0.0, 0.0 }
  , Quadrats{ 0, 0 }
{
  this->SetNumberOfOutputPorts(2);
}

//----------------------------------------------------------------------------
vtkQuadratAnalysisFilter::~vtkQuadratAnalysisFilter() = default;

//----------------------------------------------------------------------------
int vtkQuadratAnalysisFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

//----------------------------------------------------------------------------
int vtkQuadratAnalysisFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // Statistics of a part are not those of the whole.
  littoral::RequestAll(inputVector[0]->GetInformationObject(0));
  return 1;
}

//----------------------------------------------------------------------------
littoral::QuadratGrid vtkQuadratAnalysisFilter::MakeGrid(vtkPointSet* input)
{
  littoral::QuadratGrid grid;
  const bool boxed = this->Size[0] == 0.0 && this->Size[1] == 0.0;
  double bounds[6];
  input->GetBounds(bounds);
  for (int axis = 0; axis < 2; ++axis)
  {
    grid.Origin[axis] = boxed ? bounds[2 * axis] : this->Origin[axis];
    grid.Size[axis] = boxed ? bounds[2 * axis + 1] - bounds[2 * axis] : this->Size[axis];
  }
  if (boxed && !(grid.Size[0] > 0.0 && grid.Size[1] > 0.0))
  {
    littoral::Refuse("The points cover no area: their box is ", grid.Size[0], " x ", grid.Size[1], " m.");
  }
  littoral::InContext(CannotAnalyse, [&] {
    littoral::Require(littoral::WhyInvalid(grid));
    if (this->Quadrats[0] == 0 && this->Quadrats[1] == 0)
    {
      littoral::ChooseQuadrats(grid, static_cast<double>(input->GetNumberOfPoints()));
    }
    else
    {
      grid.Count = { this->Quadrats[0], this->Quadrats[1] };
      littoral::Require(littoral::WhyInvalid(grid));
    }
    littoral::Require(grid.NumberOfQuadrats() < 2 ? "1 quadrats cannot be analysed; take more." : "");
    littoral::RequireMemory(4.0 * static_cast<double>(grid.NumberOfQuadrats()),
      "an analysis of " + std::to_string(grid.NumberOfQuadrats()) + " quadrats", "take fewer");
  });
  return grid;
}

//----------------------------------------------------------------------------
std::vector<long long> vtkQuadratAnalysisFilter::CountPoints(vtkPointSet* input, const littoral::QuadratGrid& grid)
{
  std::vector<int> counts(static_cast<std::size_t>(grid.NumberOfQuadrats()), 0);
  const vtkIdType points = input->GetNumberOfPoints();
  long long inside = 0;
  for (vtkIdType id = 0; id < points; ++id)
  {
    double position[3];
    input->GetPoint(id, position);
    const long long quadrat = littoral::QuadratOf(grid, position[0], position[1]);
    if (quadrat >= 0)
    {
      ++counts[static_cast<std::size_t>(quadrat)];
      ++inside;
    }
  }
  if (inside < FewestPoints)
  {
    littoral::Refuse("Only ", inside, " of ", points, " points lie in the study area.");
  }
  std::vector<long long> frequencies = littoral::CountFrequencies(counts);
  if (frequencies.size() > LargestCount)
  {
    littoral::Refuse("A quadrat holds ", frequencies.size() - 1,
      " points; take more Quadrats, so that none holds more than ", LargestCount, ".");
  }
  return frequencies;
}

//----------------------------------------------------------------------------
int vtkQuadratAnalysisFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (littoral::AsksForLaterPiece(request, outputVector))
  {
    return 1;
  }
  auto* input =
    littoral::InContext(CannotAnalyse, [&] { return littoral::InputOf<vtkPointSet>(inputVector[0], "Input"); });
  const vtkIdType points = input->GetNumberOfPoints();
  if (points < FewestPoints)
  {
    littoral::Refuse("The input has ", points, " points; an analysis needs at least ", FewestPoints, ".");
  }
  const littoral::QuadratGrid grid = this->MakeGrid(input);
  this->SetProgressText("Counting points");
  const std::vector<long long> frequencies = this->CountPoints(input, grid);
  this->UpdateProgress(0.2);
  vtkTable* table = vtkTable::GetData(outputVector, 0);
  const std::vector<Fit> fits = littoral::FitAllQuadratLaws(frequencies);
  WriteFits(fits, table);
  WriteFrequencies(frequencies, fits, static_cast<double>(grid.NumberOfQuadrats()), vtkTable::GetData(outputVector, 1));
  AddPattern(littoral::MomentsOfCounts(frequencies), grid, table);
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
int vtkQuadratAnalysisFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(
    this, request, outputs, [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkQuadratAnalysisFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Origin: " << this->Origin[0] << " " << this->Origin[1] << "\n";
  os << indent << "Size: " << this->Size[0] << " " << this->Size[1] << "\n";
  os << indent << "Quadrats: " << this->Quadrats[0] << " " << this->Quadrats[1] << "\n";
}
