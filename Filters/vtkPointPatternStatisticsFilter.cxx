// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointPatternStatisticsFilter.h"

#include "Data/Inputs.h"
#include "Data/PointPattern.h"
#include "Data/ProcessTable.h"
#include "Data/QuadratTable.h"
#include "Data/Tables.h"
#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Patterns/CurveEnvelope.h"
#include "Patterns/DistanceFunctions.h"
#include "Patterns/PairFunctions.h"
#include "Patterns/ProcessPattern.h"
#include "Patterns/WindowSections.h"
#include "Pipeline/Pipeline.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkPointPatternStatisticsFilter);

namespace
{

using Filter = vtkPointPatternStatisticsFilter;
using Curve = std::vector<double>;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr int PointsPort = 0;
constexpr int WindowPort = 1;
constexpr int LawPort = 2;
/// Fewer points say nothing about a pattern.
constexpr std::size_t FewestPoints = 5;
constexpr int NumberOfFunctions = 9;
const char* const FunctionNames[NumberOfFunctions] = { "K", "L", "PairCorrelation", "NearestNeighbor", "EmptySpace",
  "J", "MarkCorrelation", "CrossK", "CrossPairCorrelation" };

using Curves = std::array<Curve, NumberOfFunctions>;
/// In place of the number of a function.
constexpr int AllFunctions = -1;

/// How functions are found.
struct Measure
{
  littoral::ObservationWindow Window;
  littoral::PairOptions Pairs; ///< of K
  littoral::DistanceCorrection Nearest = littoral::DistanceCorrection::KaplanMeier;

  /// Border is for K alone: other functions of pairs take the translation correction then.
  littoral::PairOptions OtherPairs() const
  {
    littoral::PairOptions options = this->Pairs;
    options.Correction = options.Correction == littoral::EdgeCorrection::Border ? littoral::EdgeCorrection::Translation
                                                                                : options.Correction;
    return options;
  }

  /// One of the functions of points, or all of them, each pair and each nearest point being looked for once. Those of
  /// marks are empty without marks, and those of species always.
  Curves Find(int function, const std::vector<littoral::PlanePosition>& points, const Curve& marks,
    const littoral::ParallelFor& parallel) const
  {
    const auto wants = [&](int number) { return function == AllFunctions || function == number; };
    const littoral::PairFunctions pairs = this->FindPairs(wants(Filter::K) || wants(Filter::L),
      wants(Filter::PairCorrelation), wants(Filter::MarkCorrelation), [&](const littoral::PairOptions& options) {
        return littoral::FindPairFunctions(points, marks, this->Window, options, parallel);
      });
    Curves found;
    found[Filter::K] = pairs.K;
    found[Filter::L] = littoral::BesagL(pairs.K);
    found[Filter::PairCorrelation] = pairs.PairCorrelation;
    found[Filter::MarkCorrelation] = pairs.MarkCorrelation;
    if (wants(Filter::NearestNeighbor) || wants(Filter::EmptySpace) || wants(Filter::J))
    {
      const auto nearest =
        littoral::FindDistanceFunctions(points, this->Window, this->Pairs.Distances, this->Nearest, 128, parallel);
      found[Filter::NearestNeighbor] = nearest.G;
      found[Filter::EmptySpace] = nearest.F;
      found[Filter::J] = nearest.J;
    }
    return found;
  }

  /// One of the functions of two species, or both.
  Curves FindCross(int function, const std::array<std::vector<littoral::PlanePosition>, 2>& species,
    const littoral::ParallelFor& parallel) const
  {
    const littoral::PairFunctions pairs = this->FindPairs(function != Filter::CrossPairCorrelation,
      function != Filter::CrossK, false, [&](const littoral::PairOptions& options) {
        return littoral::FindCrossFunctions(species[0], species[1], this->Window, options, parallel);
      });
    Curves found;
    found[Filter::CrossK] = pairs.K;
    found[Filter::CrossPairCorrelation] = pairs.PairCorrelation;
    return found;
  }

private:
  /// K and other functions of pairs by `find`, at once where they have the same correction.
  template <typename FindOfOptions>
  littoral::PairFunctions FindPairs(bool wantsK, bool wantsG, bool wantsMarks, const FindOfOptions& find) const
  {
    littoral::PairOptions others = this->OtherPairs();
    const bool isOne = others.Correction == this->Pairs.Correction;
    others.WantsK = wantsK && isOne;
    others.WantsG = wantsG;
    const bool wantsOthers = others.WantsK || wantsG || wantsMarks;
    littoral::PairFunctions pairs = wantsOthers ? find(others) : littoral::PairFunctions();
    if (wantsK && !isOne)
    {
      pairs.K = find(this->Pairs).K;
    }
    return pairs;
  }
};

/// The value of a function for a random pattern.
double Theoretical(int function, double r, double intensity)
{
  switch (function)
  {
    case Filter::K:
    case Filter::CrossK:
      return littoral::Pi * r * r;
    case Filter::L:
      return r;
    case Filter::NearestNeighbor:
    case Filter::EmptySpace:
      return 1.0 - std::exp(-intensity * littoral::Pi * r * r);
    default:
      return 1.0;
  }
}

/// What it means that a curve is above that of random patterns.
const char* WordForSide(int function, bool isAbove)
{
  const bool isRegularAbove = function == Filter::EmptySpace || function == Filter::J;
  return isAbove == isRegularAbove ? "regular" : "clustered";
}

bool IsNone(const std::string& name)
{
  return name.empty() || name == "None" || name == "NULL";
}

void AddCurve(vtkTable* table, const char* name, const Curve& curve)
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

}

/// What is measured.
struct vtkPointPatternStatisticsFilter::Pattern
{
  vtkPointSet* Input = nullptr;
  std::vector<littoral::PlanePosition> Points;
  littoral::ObservationWindow Window;
  Curve Marks;
  std::vector<std::string> Species;
  std::string First;
  std::string Second;
  vtkTable* Fits = nullptr;
  bool HasProcess = false; ///< of the fits; else they have a law
  littoral::PointProcessParameters Process;
  littoral::IntensityRaster Trend; ///< without values: there is none
  littoral::QuadratLawParameters QuadratLaw;
  littoral::QuadratGrid Grid;

  /// How the process is simulated with a seed.
  littoral::ProcessOptions Simulation(int seed) const
  {
    littoral::ProcessOptions options;
    options.Seed = seed;
    options.Raster = this->Trend.Values.empty() ? nullptr : &this->Trend;
    return options;
  }

  /// The points of the first and the second species when place n has the species of place order[n].
  std::array<std::vector<littoral::PlanePosition>, 2> Split(const std::vector<std::size_t>& order) const
  {
    std::array<std::vector<littoral::PlanePosition>, 2> both;
    for (std::size_t n = 0; n < this->Points.size(); ++n)
    {
      const std::string& species = this->Species[order.empty() ? n : order[n]];
      if (species == this->First || species == this->Second)
      {
        both[species == this->First ? 0 : 1].push_back(this->Points[n]);
      }
    }
    return both;
  }

  /// A pattern of the law or process of the fits in the window, from its own seed.
  std::vector<littoral::PlanePosition> Scatter(int seed) const
  {
    if (this->HasProcess)
    {
      return littoral::SimulateProcess(this->Process, this->Simulation(seed), this->Window).Points;
    }
    const auto counts =
      littoral::QuadratCounts(this->QuadratLaw, this->Grid.NumberOfQuadrats(), littoral::QuadratMode::Sampling, seed);
    std::vector<littoral::PlanePosition> points;
    for (std::size_t quadrat = 0; quadrat < counts.size(); ++quadrat)
    {
      for (int n = 0; n < counts[quadrat]; ++n)
      {
        const auto point = littoral::QuadratPosition(this->Grid, static_cast<long long>(quadrat), n, seed);
        if (this->Window.Contains(point))
        {
          points.push_back(point);
        }
      }
    }
    return points;
  }
};

//----------------------------------------------------------------------------
vtkPointPatternStatisticsFilter::vtkPointPatternStatisticsFilter()
  : Function(L)
  , Origin{ 0.0, 0.0 }
  , Size{ 0.0, 0.0 }
  , EdgeCorrection(Isotropic)
  , DistanceCorrection(KaplanMeier)
  , LargestDistance(0.0)
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
std::string vtkPointPatternStatisticsFilter::WhyInvalid() const
{
  littoral::ParameterCheck check;
  check.Choice("Function", this->Function, NumberOfFunctions);
  check.Choice("EdgeCorrection", this->EdgeCorrection, { "none", "border", "isotropic", "translation" });
  check.Choice("DistanceCorrection", this->DistanceCorrection, { "uncorrected", "reduced sample", "Kaplan-Meier" });
  check.NotNegative("LargestDistance", this->LargestDistance, "m");
  check.Count("NumberOfSteps", this->NumberOfSteps, 8, 10000);
  check.NotNegative("Bandwidth", this->Bandwidth, "m");
  check.Count("NumberOfSimulations", this->NumberOfSimulations, 0, 100000);
  check.Within("Level", this->Level, littoral::ValueInterval::Between(0.0, 1.0));
  if (this->NumberOfSimulations > 0 && check.IsGood())
  {
    check.Require(littoral::WhyNoEnvelope(this->NumberOfSimulations, this->Level));
  }
  return check.Reason();
}

//----------------------------------------------------------------------------
void vtkPointPatternStatisticsFilter::ReadKinds(Pattern& pattern) const
{
  const bool hasMarks = !IsNone(this->MarkArray);
  const bool hasSpecies = !IsNone(this->SpeciesArray);
  littoral::Require(
    this->Function == MarkCorrelation && !hasMarks ? "the mark correlation needs marks; choose a MarkArray." : "");
  littoral::Require(this->IsCross() && !hasSpecies ? "cross functions need species; choose a SpeciesArray." : "");
  pattern.Marks = hasMarks ? littoral::ReadMarks(pattern.Input, this->MarkArray) : pattern.Marks;
  pattern.Species = hasSpecies ? littoral::ReadSpecies(pattern.Input, this->SpeciesArray) : pattern.Species;
  if (pattern.Species.empty())
  {
    return;
  }
  std::map<std::string, int> counts;
  for (const std::string& species : pattern.Species)
  {
    ++counts[species];
  }
  // The most frequent, of equal ones the first by the alphabet.
  const auto choose = [&](const std::string& chosen, const std::string& except) {
    std::string most;
    for (const auto& [species, count] : counts)
    {
      most = species != except && (most.empty() || count > counts[most]) ? species : most;
    }
    return chosen.empty() ? most : chosen;
  };
  pattern.First = choose(this->FirstSpecies, this->SecondSpecies);
  pattern.Second = choose(this->SecondSpecies, pattern.First);
  for (const std::string& species : { pattern.First, pattern.Second })
  {
    if (counts.find(species) == counts.end())
    {
      littoral::Refuse("no point is of the species '", species, "'.");
    }
  }
  littoral::Require(pattern.First == pattern.Second ? "cross functions need two different species." : "");
}

//----------------------------------------------------------------------------
void vtkPointPatternStatisticsFilter::ReadLaw(Pattern& pattern)
{
  pattern.HasProcess = littoral::FirstRowIsProcess(pattern.Fits);
  double expected = 0.0;
  if (pattern.HasProcess)
  {
    littoral::ObservationWindow ofFit;
    littoral::ReadProcessFit(pattern.Fits, pattern.Process, ofFit, pattern.Trend);
    const littoral::ProcessOptions options = pattern.Simulation(1);
    littoral::Require(littoral::WhyInvalid(pattern.Process, options, pattern.Window));
    expected = littoral::ExpectedDraws(pattern.Process, options, pattern.Window);
  }
  else
  {
    littoral::ReadQuadratFit(pattern.Fits, pattern.QuadratLaw, pattern.Grid);
    littoral::Require(littoral::WhyInvalid(pattern.QuadratLaw));
    littoral::Require(littoral::WhyInvalid(pattern.Grid));
    expected = static_cast<double>(pattern.Grid.NumberOfQuadrats()) * (1.0 + pattern.QuadratLaw.Mean);
  }
  const bool isTooMuch = 64.0 * expected > littoral::AvailableMemory();
  littoral::Require(isTooMuch ? "the law of the table makes more points than this machine has memory for." : "");
}

//----------------------------------------------------------------------------
void vtkPointPatternStatisticsFilter::ReadPattern(vtkInformationVector** inputs, Pattern& pattern) const
{
  pattern.Input = littoral::InputOf<vtkPointSet>(inputs[PointsPort], "Input");
  auto* window = littoral::OptionalInputOf<vtkPolyData>(inputs[WindowPort], "Window");
  pattern.Fits = littoral::OptionalInputOf<vtkTable>(inputs[LawPort], "Law");
  littoral::Require(this->WhyInvalid());
  if (pattern.Input->GetNumberOfPoints() < static_cast<vtkIdType>(FewestPoints))
  {
    littoral::Refuse(
      "the input has ", pattern.Input->GetNumberOfPoints(), " points; it must have at least ", FewestPoints, ".");
  }
  pattern.Points = littoral::PlanePositionsOf(pattern.Input);
  pattern.Window =
    window ? littoral::ReadWindow(window) : littoral::ReadWindow(pattern.Input, this->Origin, this->Size);
  littoral::Require(littoral::WhyInvalid(pattern.Points, pattern.Window, FewestPoints, this->AllowCoincidentPoints));
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
  if (littoral::AsksForLaterPiece(request, outputVector))
  {
    return 1;
  }
  Pattern pattern;
  this->ReadPattern(inputVector, pattern);
  const std::size_t points = pattern.Points.size();
  Measure measure;
  measure.Window = pattern.Window;
  measure.Nearest = static_cast<littoral::DistanceCorrection>(this->DistanceCorrection);
  measure.Pairs.Correction = static_cast<littoral::EdgeCorrection>(this->EdgeCorrection);
  measure.Pairs.HalfWidth = this->Bandwidth;
  measure.Pairs.Distances = this->IsOfPairs()
    ? littoral::DefaultDistances(pattern.Window, points, this->NumberOfSteps)
    : littoral::DefaultNearestDistances(pattern.Window, points, this->NumberOfSteps);
  const littoral::DistanceRange& distances = measure.Pairs.Distances;
  if (this->LargestDistance > 0.0)
  {
    measure.Pairs.Distances.Largest = this->LargestDistance;
  }

  // All functions of the pattern.
  this->SetProgressText("Measuring the pattern");
  const auto parallel = littoral::AbortableFor(this);
  if (measure.OtherPairs().Correction == littoral::EdgeCorrection::Translation)
  {
    const double h = 0.15 * std::sqrt(pattern.Window.GetArea() / static_cast<double>(points));
    const double reach = distances.Largest + 4.0 * std::max(h, this->Bandwidth);
    measure.Pairs.Areas = std::make_shared<const littoral::CommonAreaTable>(pattern.Window, reach, parallel);
  }
  Curve r(distances.Count());
  for (std::size_t k = 0; k < r.size(); ++k)
  {
    r[k] = distances[static_cast<int>(k)];
  }
  vtkTable* all = vtkTable::GetData(outputVector, 2);
  AddCurve(all, "Distance", r);
  Curves functions = measure.Find(AllFunctions, pattern.Points, pattern.Marks, parallel);
  this->UpdateProgress(0.15);
  if (!pattern.Species.empty())
  {
    const Curves crossed = measure.FindCross(AllFunctions, pattern.Split({}), parallel);
    std::copy(crossed.begin() + CrossK, crossed.end(), functions.begin() + CrossK);
  }
  this->UpdateProgress(0.2);
  for (int function = 0; function < NumberOfFunctions; ++function)
  {
    if (!functions[function].empty())
    {
      AddCurve(all, FunctionNames[function], functions[function]);
    }
  }
  const Curve& measured = functions[this->Function];

  // The chosen one of simulated patterns.
  const double intensity = static_cast<double>(points) / pattern.Window.GetArea();
  littoral::CurveEnvelope envelope;
  if (this->NumberOfSimulations > 0)
  {
    this->SetProgressText("Simulating patterns");
    const littoral::CurveOfNumber simulate = [&](int number) {
      if (this->IsCross())
      {
        const auto order = littoral::RandomOrder(points, this->Seed, number);
        return measure.FindCross(this->Function, pattern.Split(order), littoral::SerialFor)[this->Function];
      }
      if (this->Function == MarkCorrelation)
      {
        Curve marks;
        for (const std::size_t n : littoral::RandomOrder(points, this->Seed, number))
        {
          marks.push_back(pattern.Marks[n]);
        }
        return measure.Find(this->Function, pattern.Points, marks, littoral::SerialFor)[this->Function];
      }
      const auto simulated = pattern.Fits ? pattern.Scatter(littoral::SeedOfSimulation(this->Seed, number))
                                          : littoral::UniformPattern(pattern.Window, points, this->Seed, number);
      return simulated.size() < 2 ? Curve(r.size(), NaN)
                                  : measure.Find(this->Function, simulated, {}, littoral::SerialFor)[this->Function];
    };
    const auto curves =
      littoral::SimulateCurves(simulate, this->NumberOfSimulations, littoral::AbortableFor(this, 0.2, 1.0));
    envelope = littoral::FindCurveEnvelope(measured, curves, this->Level);
  }

  vtkTable* chart = vtkTable::GetData(outputVector, 0);
  AddCurve(chart, "Distance", r);
  AddCurve(chart, FunctionNames[this->Function], measured);
  littoral::AddColumn(
    chart, "Theoretical", r, [&](double distance) { return Theoretical(this->Function, distance, intensity); });
  if (this->NumberOfSimulations > 0)
  {
    AddCurve(chart, "Mean", envelope.Mean);
    AddCurve(chart, "Low", envelope.Low);
    AddCurve(chart, "High", envelope.High);
    AddCurve(chart, "GlobalLow", envelope.GlobalLow);
    AddCurve(chart, "GlobalHigh", envelope.GlobalHigh);
  }

  vtkTable* verdict = vtkTable::GetData(outputVector, 1);
  const std::vector<int> row{ 0 };
  const bool isTested = this->NumberOfSimulations > 0;
  const bool isRandomTested = isTested && !pattern.Fits && !this->IsCross() && this->Function != MarkCorrelation;
  const bool isOut = !envelope.Outside.empty();
  const std::size_t out = isOut ? envelope.Outside.front() : 0;
  const std::string side = isOut ? WordForSide(this->Function, measured[out] > envelope.GlobalHigh[out]) : "random";
  const auto addText = [&](const char* name, const std::string& text) {
    littoral::AddColumn(verdict, name, row, [&](int) { return text; });
  };
  const auto addNumber = [&](const char* name, double number) {
    littoral::AddColumn(verdict, name, row, [&](int) { return number; });
  };
  addText("Function", FunctionNames[this->Function]);
  addText("Verdict", !isTested ? "" : envelope.IsRejected ? "differs" : "not distinguishable");
  addText("Pattern", isRandomTested ? side : "");
  addNumber("PValue", isTested ? envelope.PValue : NaN);
  addNumber("Level", this->Level);
  addNumber("Simulations", this->NumberOfSimulations);
  addNumber("OutsideFrom", isOut ? r[envelope.Outside.front()] : NaN);
  addNumber("OutsideTo", isOut ? r[envelope.Outside.back()] : NaN);
  for (vtkTable* table : { chart, verdict, all })
  {
    littoral::AddField(table, "Points", { static_cast<double>(points) });
    littoral::AddField(table, "Intensity", { intensity });
    littoral::AddField(table, "WindowArea", { pattern.Window.GetArea() });
  }
  this->UpdateProgress(1.0);
  return 1;
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
  os << indent << "LargestDistance: " << this->LargestDistance << "\n";
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
