// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointPatternStatisticsFilter.h"

#include "Data/Inputs.h"
#include "Data/PointPattern.h"
#include "Data/ProcessTable.h"
#include "Data/QuadratTable.h"
#include "Data/Tables.h"
#include "Patterns/PatternLaw.h"
#include "Patterns/PatternStatistics.h"
#include "Pipeline/Pipeline.h"
#include "Pipeline/RankTeam.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPointPatternStatisticsFilter);

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr int PointsPort = 0;
constexpr int WindowPort = 1;
constexpr int LawPort = 2;

bool IsNone(const std::string& name)
{
  return name.empty() || name == "None" || name == "NULL";
}

void AddCurve(vtkTable* table, const char* name, const std::vector<double>& curve)
{
  littoral::AddColumn(table, name, curve, [](double value) { return value; });
}

std::string TextOfName(const char* name)
{
  return name ? name : "";
}

/// Sets a name and tells whether it is another one.
bool Replace(std::string& member, const char* name)
{
  const std::string text = TextOfName(name);
  const bool isNew = member != text;
  member = text;
  return isNew;
}

void WriteFunctions(const std::vector<double>& distances, const littoral::FunctionCurves& functions, vtkTable* all)
{
  AddCurve(all, "Distance", distances);
  for (std::size_t function = 0; function < functions.size(); ++function)
  {
    if (!functions[function].empty())
    {
      AddCurve(all, littoral::NameOf(static_cast<littoral::PatternFunction>(function)), functions[function]);
    }
  }
}

/// The chosen function of a pattern beside random and simulated ones.
struct Comparison
{
  const littoral::StatisticsOptions& Options;
  std::vector<double> Distances;
  const std::vector<double>& Measured;
  const littoral::CurveEnvelope& Envelope; ///< empty without simulations
  double Intensity;
  bool IsRandomTested; ///< the simulations are of random patterns

  bool IsTested() const { return this->Options.Simulations > 0; }
};

/// The name of the drawn function.
const char* DrawnName(littoral::PatternFunction function)
{
  return function == littoral::PatternFunction::L ? "L(r) - r" : littoral::NameOf(function);
}

void WriteChart(const Comparison& comparison, vtkTable* chart)
{
  const littoral::PatternFunction function = comparison.Options.Function;
  const std::vector<double>& distances = comparison.Distances;
  const auto add = [&](const char* name, const std::vector<double>& curve) {
    AddCurve(chart, name, function == littoral::PatternFunction::L ? littoral::CenteredL(curve, distances) : curve);
  };
  std::vector<double> random(distances.size());
  std::transform(distances.begin(), distances.end(), random.begin(),
    [&](double distance) { return littoral::RandomValue(function, distance, comparison.Intensity); });
  AddCurve(chart, "Distance", distances);
  add(DrawnName(function), comparison.Measured);
  add("Theoretical", random);
  if (comparison.IsTested())
  {
    const littoral::CurveEnvelope& envelope = comparison.Envelope;
    add("Mean", envelope.Mean);
    add("Low", envelope.Low);
    add("High", envelope.High);
    add("GlobalLow", envelope.GlobalLow);
    add("GlobalHigh", envelope.GlobalHigh);
  }
}

void WriteVerdict(const Comparison& comparison, vtkTable* verdict)
{
  const littoral::StatisticsOptions& options = comparison.Options;
  const littoral::CurveEnvelope& envelope = comparison.Envelope;
  const bool isOut = !envelope.Outside.empty();
  const std::size_t first = isOut ? envelope.Outside.front() : 0;
  const std::string kind =
    isOut ? littoral::KindBeside(options.Function, comparison.Measured[first] > envelope.GlobalHigh[first]) : "random";
  const std::vector<int> row{ 0 };
  const auto add = [&](const char* name, const auto& value) {
    littoral::AddColumn(verdict, name, row, [&](int) { return value; });
  };
  const bool isTested = comparison.IsTested();
  add("Function", std::string(DrawnName(options.Function)));
  add("Verdict", std::string(!isTested ? "" : envelope.IsRejected ? "differs" : "not distinguishable"));
  add("Pattern", isTested && comparison.IsRandomTested ? kind : std::string());
  add("PValue", isTested ? envelope.PValue : NaN);
  add("Level", options.Level);
  add("Simulations", static_cast<double>(options.Simulations));
  add("OutsideFrom", isOut ? comparison.Distances[first] : NaN);
  add("OutsideTo", isOut ? comparison.Distances[envelope.Outside.back()] : NaN);
}

}

/// A pattern, its input, and the law that it is compared with.
struct vtkPointPatternStatisticsFilter::Pattern : littoral::MappedPattern
{
  vtkPointSet* Input = nullptr;
  vtkTable* Fits = nullptr;
  littoral::PatternLaw Law; ///< read from the fits, if there are such
};

//----------------------------------------------------------------------------
vtkPointPatternStatisticsFilter::vtkPointPatternStatisticsFilter()
  : Function(L)
  , Origin{ 0.0, 0.0 }
  , Size{ 0.0, 0.0 }
  , EdgeCorrection(Isotropic)
  , DistanceCorrection(KaplanMeier)
  , MaximumDistance(0.0)
  , NumberOfSteps(256)
  , Bandwidth(0.0)
  , AllowCoincidentPoints(false)
  , MarkArray("None")
  , SpeciesArray("None")
  , NumberOfSimulations(99)
  , Level(0.05)
  , Seed(1)
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(3);
}

//----------------------------------------------------------------------------
vtkPointPatternStatisticsFilter::~vtkPointPatternStatisticsFilter() = default;

//----------------------------------------------------------------------------
void vtkPointPatternStatisticsFilter::SetMarkArray(const char* name)
{
  if (Replace(this->MarkArray, name))
  {
    this->Modified();
  }
}

//----------------------------------------------------------------------------
void vtkPointPatternStatisticsFilter::SetSpeciesArray(const char* name)
{
  if (Replace(this->SpeciesArray, name))
  {
    this->Modified();
  }
}

//----------------------------------------------------------------------------
void vtkPointPatternStatisticsFilter::SetFirstSpecies(const char* name)
{
  if (Replace(this->FirstSpecies, name))
  {
    this->Modified();
  }
}

//----------------------------------------------------------------------------
void vtkPointPatternStatisticsFilter::SetSecondSpecies(const char* name)
{
  if (Replace(this->SecondSpecies, name))
  {
    this->Modified();
  }
}

//----------------------------------------------------------------------------
void vtkPointPatternStatisticsFilter::SetWindowConnection(vtkAlgorithmOutput* window)
{
  this->SetInputConnection(WindowPort, window);
}

//----------------------------------------------------------------------------
void vtkPointPatternStatisticsFilter::SetLawConnection(vtkAlgorithmOutput* fits)
{
  this->SetInputConnection(LawPort, fits);
}

//----------------------------------------------------------------------------
int vtkPointPatternStatisticsFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  const char* types[] = { "vtkPointSet", "vtkPolyData", "vtkTable" };
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), types[port]);
  if (port != PointsPort)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkPointPatternStatisticsFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // Statistics of a part are not those of the whole.
  for (const int port : { PointsPort, WindowPort, LawPort })
  {
    littoral::RequestAll(inputVector[port]->GetInformationObject(0));
  }
  return 1;
}

//----------------------------------------------------------------------------
littoral::StatisticsOptions vtkPointPatternStatisticsFilter::Options() const
{
  littoral::StatisticsOptions options;
  options.Function = static_cast<littoral::PatternFunction>(this->Function);
  options.Correction = static_cast<littoral::EdgeCorrection>(this->EdgeCorrection);
  options.Nearest = static_cast<littoral::DistanceCorrection>(this->DistanceCorrection);
  options.MaximumDistance = this->MaximumDistance;
  options.Steps = this->NumberOfSteps;
  options.HalfWidth = this->Bandwidth;
  options.Simulations = this->NumberOfSimulations;
  options.Level = this->Level;
  options.Seed = this->Seed;
  return options;
}

//----------------------------------------------------------------------------
void vtkPointPatternStatisticsFilter::ReadKinds(Pattern& pattern) const
{
  const bool hasMarks = !IsNone(this->MarkArray);
  const bool hasSpecies = !IsNone(this->SpeciesArray);
  littoral::Require(
    this->Function == MarkCorrelation && !hasMarks ? "the mark correlation needs marks; choose a MarkArray." : "");
  littoral::Require(littoral::IsCross(this->Options().Function) && !hasSpecies
      ? "cross functions need species; choose a SpeciesArray."
      : "");
  pattern.Marks = hasMarks ? littoral::ReadMarks(pattern.Input, this->MarkArray) : pattern.Marks;
  pattern.Species = hasSpecies ? littoral::ReadSpecies(pattern.Input, this->SpeciesArray) : pattern.Species;
  if (pattern.Species.empty())
  {
    return;
  }
  pattern.Pair = { this->FirstSpecies, this->SecondSpecies };
  littoral::ChoosePair(pattern);
}

//----------------------------------------------------------------------------
void vtkPointPatternStatisticsFilter::ReadLaw(Pattern& pattern)
{
  littoral::PatternLaw& law = pattern.Law;
  littoral::ObservationWindow ofFit;
  law.IsProcess = littoral::FirstRowIsProcess(pattern.Fits);
  if (law.IsProcess)
  {
    littoral::ReadProcessFit(pattern.Fits, law.Process, ofFit, law.Trend);
  }
  else
  {
    littoral::ReadQuadratFit(pattern.Fits, law.Counts, law.Grid);
  }
  littoral::Require(littoral::WhyInvalid(law, pattern.Window));
  const double draws = littoral::ExpectedDraws(law, pattern.Window);
  littoral::RequireMemory(64.0 * draws, "the law of the table, which makes " + littoral::TextOf(draws) + " points,",
    "take that of this pattern");
}

//----------------------------------------------------------------------------
void vtkPointPatternStatisticsFilter::ReadPattern(vtkInformationVector** inputs, Pattern& pattern) const
{
  pattern.Input = littoral::InputOf<vtkPointSet>(inputs[PointsPort], "Input");
  auto* window = littoral::OptionalInputOf<vtkPolyData>(inputs[WindowPort], "Window");
  pattern.Fits = littoral::OptionalInputOf<vtkTable>(inputs[LawPort], "Law");
  littoral::Require(littoral::WhyInvalid(this->Options()));
  if (pattern.Input->GetNumberOfPoints() < static_cast<vtkIdType>(littoral::FewestPatternPoints))
  {
    littoral::Refuse("the input has ", pattern.Input->GetNumberOfPoints(), " points; it must have at least ",
      littoral::FewestPatternPoints, ".");
  }
  pattern.Points = littoral::PlanePositionsOf(pattern.Input);
  pattern.Window =
    window ? littoral::ReadWindow(window) : littoral::ReadWindow(pattern.Input, this->Origin, this->Size);
  littoral::Require(
    littoral::WhyInvalid(pattern.Points, pattern.Window, littoral::FewestPatternPoints, this->AllowCoincidentPoints));
  this->ReadKinds(pattern);
  if (pattern.Fits)
  {
    ReadLaw(pattern);
  }
}

//----------------------------------------------------------------------------
int vtkPointPatternStatisticsFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  littoral::RankTeam team(request, outputVector);
  if (!team.IsAlone() || !littoral::AsksForLaterPiece(request, outputVector))
  {
    team.Run([&] { this->Measure(inputVector, team, outputVector); });
  }
  return 1;
}

//----------------------------------------------------------------------------
void vtkPointPatternStatisticsFilter::Measure(
  vtkInformationVector** inputVector, littoral::RankTeam& team, vtkInformationVector* outputVector)
{
  Pattern pattern;
  this->ReadPattern(inputVector, pattern);
  const std::vector<double> properties{ static_cast<double>(this->Function), static_cast<double>(this->EdgeCorrection),
    static_cast<double>(this->DistanceCorrection), this->MaximumDistance, static_cast<double>(this->NumberOfSteps),
    this->Bandwidth, static_cast<double>(this->NumberOfSimulations), this->Level, static_cast<double>(this->Seed),
    this->Origin[0], this->Origin[1], this->Size[0], this->Size[1] };
  if (!team.Agree(littoral::KeyOf(pattern.Points, properties)))
  {
    return;
  }
  const littoral::StatisticsOptions options = this->Options();
  const littoral::WorkShare share = team.Share();
  this->SetProgressText("Measuring the pattern");
  const littoral::PatternStatistics statistics(pattern, options, littoral::AbortableFor(this));
  const littoral::FunctionCurves functions = statistics.Measure(littoral::AbortableFor(this), share);
  this->UpdateProgress(0.2);
  const std::vector<double>& measured = functions[this->Function];
  littoral::CurveEnvelope envelope;
  if (this->NumberOfSimulations > 0)
  {
    this->SetProgressText("Simulating patterns");
    int polls = 0;
    const auto poll = [&] { this->UpdateProgress(0.2 + 0.8 * ++polls / littoral::PollsOfCurves); };
    envelope =
      statistics.Compare(measured, pattern.Fits ? &pattern.Law : nullptr, poll, littoral::AbortableFor(this), share);
  }
  if (!team.IsFirst())
  {
    return;
  }
  const bool isRandomTested =
    !pattern.Fits && !littoral::IsCross(options.Function) && this->Function != MarkCorrelation;
  const Comparison comparison{ options, statistics.GetDistances(), measured, envelope, pattern.GetIntensity(),
    isRandomTested };
  vtkTable* chart = vtkTable::GetData(outputVector, 0);
  vtkTable* verdict = vtkTable::GetData(outputVector, 1);
  vtkTable* all = vtkTable::GetData(outputVector, 2);
  WriteChart(comparison, chart);
  WriteVerdict(comparison, verdict);
  WriteFunctions(comparison.Distances, functions, all);
  for (vtkTable* table : { chart, verdict, all })
  {
    littoral::AddField(table, "Points", { static_cast<double>(pattern.Points.size()) });
    littoral::AddField(table, "Intensity", { comparison.Intensity });
    littoral::AddField(table, "WindowArea", { pattern.Window.GetArea() });
  }
  this->UpdateProgress(1.0);
}

//----------------------------------------------------------------------------
int vtkPointPatternStatisticsFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(this, request, outputs,
    "Cannot measure the pattern: ", [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkPointPatternStatisticsFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Function: " << this->Function << "\n";
  os << indent << "Origin: " << this->Origin[0] << " " << this->Origin[1] << "\n";
  os << indent << "Size: " << this->Size[0] << " " << this->Size[1] << "\n";
  os << indent << "EdgeCorrection: " << this->EdgeCorrection << "\n";
  os << indent << "DistanceCorrection: " << this->DistanceCorrection << "\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
  os << indent << "NumberOfSteps: " << this->NumberOfSteps << "\n";
  os << indent << "Bandwidth: " << this->Bandwidth << "\n";
  os << indent << "AllowCoincidentPoints: " << this->AllowCoincidentPoints << "\n";
  os << indent << "MarkArray: " << this->MarkArray << "\n";
  os << indent << "SpeciesArray: " << this->SpeciesArray << "\n";
  os << indent << "FirstSpecies: " << this->FirstSpecies << "\n";
  os << indent << "SecondSpecies: " << this->SecondSpecies << "\n";
  os << indent << "NumberOfSimulations: " << this->NumberOfSimulations << "\n";
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
