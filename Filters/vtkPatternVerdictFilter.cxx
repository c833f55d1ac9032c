// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternVerdictFilter.h"

#include "Data/Inputs.h"
#include "Data/PointPattern.h"
#include "Data/Tables.h"
#include "Numerics/ParameterCheck.h"
#include "Patterns/PatternVerdict.h"
#include "Pipeline/Pipeline.h"
#include "Pipeline/RankTeam.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPatternVerdictFilter);

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
/// Memory of a point, with the simulated patterns that are kept [bytes].
constexpr double BytesOfPoint = 10000.0;
/// Polls of a verdict, for its progress.
constexpr double MostPolls =
  littoral::PollsOfCurves * (littoral::NumberOfPointProcesses + littoral::NumberOfQuadratLaws);

using Judged = littoral::JudgedLaw;

void WriteLaws(const std::vector<Judged>& laws, vtkTable* table)
{
  const auto column = [&](const char* name, auto valueOf) { littoral::AddColumn(table, name, laws, valueOf); };
  column("Law", [](const Judged& law) { return std::string(law.Name()); });
  column("Kind", [](const Judged& law) { return std::string(law.IsProcess ? "process" : "quadrat law"); });
  column("Verdict", [](const Judged& law) { return std::string(littoral::WordOf(law.Verdict)); });
  column("PValue", [](const Judged& law) { return law.Exists() ? law.Envelope.PValue : NaN; });
  column(
    "ProcessId", [](const Judged& law) { return law.IsProcess ? static_cast<int>(law.Process.Process.Process) : -1; });
  column("LawId", [](const Judged& law) { return law.IsProcess ? -1 : static_cast<int>(law.Law.Law.Law); });
  column("TrendDegree", [](const Judged& law) { return law.Process.Trend.Exists() ? law.Process.Trend.Degree : 0; });
  for (const auto* parameter : littoral::AllPointProcessParameters())
  {
    column(parameter->Name, [=](const Judged& law) {
      const bool has = law.IsProcess && law.Exists() &&
        littoral::TraitsOf(law.Process.Process.Process).Parameters.Has(parameter->Name);
      return has ? parameter->Get(law.Process.Process) : NaN;
    });
  }
  for (const auto* parameter : littoral::AllQuadratLawParameters())
  {
    column(parameter->Name, [=](const Judged& law) {
      const bool has =
        !law.IsProcess && law.Exists() && littoral::TraitsOf(law.Law.Law.Law).Parameters.Has(parameter->Name);
      return has ? parameter->Get(law.Law.Law) : NaN;
    });
  }
}

/// Adds the window and the grid of the laws as field data.
void AddPlace(
  const littoral::ObservationWindow& window, const littoral::QuadratGrid& grid, double level, vtkTable* table)
{
  vtkNew<vtkDoubleArray> corners;
  corners->SetName("Window");
  corners->SetNumberOfComponents(2);
  for (const littoral::PlanePosition& corner : window.GetCorners())
  {
    corners->InsertNextTuple(corner.data());
  }
  table->GetFieldData()->AddArray(corners);
  littoral::AddField(table, "Origin", { grid.Origin[0], grid.Origin[1] });
  littoral::AddField(table, "Size", { grid.Size[0], grid.Size[1] });
  littoral::AddField(table, "Quadrats", { static_cast<double>(grid.Count[0]), static_cast<double>(grid.Count[1]) });
  littoral::AddField(table, "Level", { level });
}

/// Adds the coefficients of the trend as field data, which all processes share that have one.
void AddTrend(const std::vector<Judged>& laws, vtkTable* table)
{
  const auto found = std::find_if(
    laws.begin(), laws.end(), [](const Judged& law) { return law.IsProcess && law.Process.Trend.Exists(); });
  if (found != laws.end())
  {
    vtkNew<vtkDoubleArray> coefficients;
    coefficients->SetName("Trend");
    for (const double coefficient : found->Process.Trend.Coefficients)
    {
      coefficients->InsertNextValue(coefficient);
    }
    table->GetFieldData()->AddArray(coefficients);
  }
}

void WriteEnvelope(const littoral::PatternJudgement& judgement, bool isLength, vtkTable* table)
{
  std::vector<std::size_t> rows(judgement.Distances.size());
  for (std::size_t k = 0; k < rows.size(); ++k)
  {
    rows[k] = k;
  }
  const littoral::CurveEnvelope& envelope = judgement.Laws.front().Envelope;
  const auto column = [&](const char* name, const std::vector<double>& values) {
    littoral::AddColumn(table, name, rows, [&](std::size_t k) { return k < values.size() ? values[k] : NaN; });
  };
  const auto curve = [&](const char* name, const std::vector<double>& values) {
    column(name, isLength ? littoral::CenteredL(values, judgement.Distances) : values);
  };
  column("Distance", judgement.Distances);
  curve("Measured", judgement.Measured);
  littoral::AddColumn(table, "Theoretical", rows, [&](std::size_t) { return isLength ? 0.0 : 1.0; });
  curve("Mean", envelope.Mean);
  curve("GlobalLow", envelope.GlobalLow);
  curve("GlobalHigh", envelope.GlobalHigh);
}

}

//----------------------------------------------------------------------------
vtkPatternVerdictFilter::vtkPatternVerdictFilter()
  : Origin{ 0.0, 0.0 }
  , Size{ 0.0, 0.0 }
  , Function(PairCorrelation)
  , Contrast(FitRipley)
  , TrendDegree(0)
  , MaximumDistance(0.0)
  , AllowCoincidentPoints(false)
  , NumberOfSimulations(99)
  , Level(0.05)
  , Quadrats{ 0, 0 }
  , Seed(1)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//----------------------------------------------------------------------------
vtkPatternVerdictFilter::~vtkPatternVerdictFilter() = default;

//----------------------------------------------------------------------------
int vtkPatternVerdictFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPointSet" : "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkPatternVerdictFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // Statistics of a part are not those of the whole.
  littoral::RequestAll(inputVector[0]->GetInformationObject(0));
  littoral::RequestAll(inputVector[1]->GetInformationObject(0));
  return 1;
}

//----------------------------------------------------------------------------
int vtkPatternVerdictFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  littoral::RankTeam team(request, outputVector);
  if (!team.IsAlone() || !littoral::AsksForLaterPiece(request, outputVector))
  {
    team.Run([&] { this->Judge(inputVector, team, outputVector); });
  }
  return 1;
}

//----------------------------------------------------------------------------
void vtkPatternVerdictFilter::Judge(
  vtkInformationVector** inputVector, littoral::RankTeam& team, vtkInformationVector* outputVector)
{
  littoral::VerdictOptions options;
  options.Contrast.Function = static_cast<littoral::ContrastFunction>(this->Contrast);
  options.Contrast.TrendDegree = this->TrendDegree;
  options.Contrast.MaximumDistance = this->MaximumDistance;
  options.Function = static_cast<littoral::VerdictFunction>(this->Function);
  options.Simulations = this->NumberOfSimulations;
  options.Level = this->Level;
  options.Seed = this->Seed;
  options.Quadrats = { this->Quadrats[0], this->Quadrats[1] };
  auto* input = littoral::InputOf<vtkPointSet>(inputVector[0], "Input");
  auto* polygon = littoral::OptionalInputOf<vtkPolyData>(inputVector[1], "Window");
  littoral::Require(WhyInvalid(options));
  const std::vector<littoral::PlanePosition> points = littoral::PlanePositionsOf(input);
  littoral::Require(points.size() < littoral::FewestPatternPoints ? littoral::WhyInvalid(points, {}) : "");
  const littoral::ObservationWindow window =
    polygon ? littoral::ReadWindow(polygon) : littoral::ReadWindow(input, this->Origin, this->Size);
  littoral::Require(littoral::WhyInvalid(points, window, littoral::FewestPatternPoints, this->AllowCoincidentPoints));
  littoral::RequireMemory(
    BytesOfPoint * static_cast<double>(points.size()), "The verdict on this pattern", "take a part of it");
  const std::vector<double> properties{ static_cast<double>(this->Contrast), static_cast<double>(this->TrendDegree),
    this->MaximumDistance, static_cast<double>(this->Function), static_cast<double>(this->NumberOfSimulations),
    this->Level, static_cast<double>(this->Seed), static_cast<double>(this->Quadrats[0]),
    static_cast<double>(this->Quadrats[1]), this->Origin[0], this->Origin[1], this->Size[0], this->Size[1] };
  if (!team.Agree(littoral::KeyOf(points, properties)))
  {
    return;
  }
  this->SetProgressText("Simulating patterns");
  const littoral::Poll heard = littoral::PollOf(this);
  int polls = 0;
  const auto poll = [&] {
    this->UpdateProgress(++polls / MostPolls);
    heard();
  };
  const littoral::PatternJudgement judgement =
    littoral::JudgePattern(points, window, options, poll, littoral::AbortableFor(this), team.Share());
  if (!team.IsFirst())
  {
    return;
  }
  vtkTable* laws = vtkTable::GetData(outputVector, 0);
  WriteLaws(judgement.Laws, laws);
  AddPlace(window, judgement.Grid, this->Level, laws);
  AddTrend(judgement.Laws, laws);
  WriteEnvelope(judgement, this->Function == BesagL, vtkTable::GetData(outputVector, 1));
  this->UpdateProgress(1.0);
}

//----------------------------------------------------------------------------
int vtkPatternVerdictFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(this, request, outputs,
    "Cannot judge the pattern: ", [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkPatternVerdictFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Origin: " << this->Origin[0] << " " << this->Origin[1] << "\n";
  os << indent << "Size: " << this->Size[0] << " " << this->Size[1] << "\n";
  os << indent << "Function: " << this->Function << "\n";
  os << indent << "Contrast: " << this->Contrast << "\n";
  os << indent << "TrendDegree: " << this->TrendDegree << "\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
  os << indent << "AllowCoincidentPoints: " << this->AllowCoincidentPoints << "\n";
  os << indent << "NumberOfSimulations: " << this->NumberOfSimulations << "\n";
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "Quadrats: " << this->Quadrats[0] << " " << this->Quadrats[1] << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
