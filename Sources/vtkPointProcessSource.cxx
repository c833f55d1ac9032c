// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointProcessSource.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/Inputs.h"
#include "Data/PointPattern.h"
#include "Data/ProcessTable.h"
#include "Data/Tables.h"
#include "Numerics/ParameterCheck.h"
#include "Patterns/ProcessPattern.h"
#include "Pipeline/Pipeline.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPointProcessSource);

namespace
{

/// Ports of the inputs.
constexpr int FitPort = 0;
constexpr int IntensityPort = 1;
constexpr int WindowPort = 2;
constexpr int MostSpecies = 100;
/// Memory of a point while it is made and as output [bytes].
constexpr double BytesOfPoint = 140.0;

using littoral::ProcessPattern;

/// Points in a range of a parallel loop.
constexpr std::size_t PointsOfRange = 1 << 15;

bool BeginsCluster(const ProcessPattern& pattern, std::size_t n)
{
  const littoral::PointIdentity& last = pattern.Identities[n > 0 ? n - 1 : 0];
  const littoral::PointIdentity& next = pattern.Identities[n];
  return next.Object != last.Object || next.Draw >> 32 != last.Draw >> 32;
}

/// The number of the cluster of each point of a part, from 0 in the order of all points.
void AddClusters(const ProcessPattern& pattern, const littoral::PieceRange& part, vtkPolyData* output)
{
  const std::size_t count = pattern.Identities.size();
  const auto begin = static_cast<std::size_t>(part.Begin);
  const auto end = static_cast<std::size_t>(part.End);
  // Clusters that begin in each range, then the last one before it.
  std::vector<vtkIdType> last(count / PointsOfRange + 2, 0);
  littoral::ForRanges(littoral::SmpFor, count, PointsOfRange, [&](std::size_t from, std::size_t to) {
    for (std::size_t n = from; n < to; ++n)
    {
      last[from / PointsOfRange + 1] += BeginsCluster(pattern, n);
    }
  });
  std::partial_sum(last.begin(), last.end(), last.begin());
  const auto array = littoral::NewArray<vtkIdTypeArray>("ClusterId", 1, part.End - part.Begin);
  vtkIdType* clusters = array->GetPointer(0);
  littoral::ForRanges(littoral::SmpFor, count, PointsOfRange, [&](std::size_t from, std::size_t to) {
    vtkIdType cluster = last[from / PointsOfRange];
    for (std::size_t n = from; n < std::min(to, end); ++n)
    {
      cluster += BeginsCluster(pattern, n);
      if (n >= begin)
      {
        clusters[n - begin] = cluster;
      }
    }
  });
  output->GetPointData()->AddArray(array);
}

/// Adds a part of the numbers of all points.
template <typename Array, typename Numbers>
void AddPart(const char* name, const Numbers& numbers, const littoral::PieceRange& part, vtkPolyData* output)
{
  const auto array = littoral::NewArray<Array>(name, 1, part.End - part.Begin);
  std::copy(numbers.begin() + part.Begin, numbers.begin() + part.End, array->GetPointer(0));
  output->GetPointData()->AddArray(array);
}

/// Vertices at the points of a part, with their numbers among all.
void AddVertices(const ProcessPattern& pattern, const littoral::PieceRange& part, vtkPolyData* output)
{
  const vtkIdType count = part.End - part.Begin;
  const auto coordinates = littoral::NewArray<vtkDoubleArray>("Points", 3, count);
  const auto siteId = littoral::NewArray<vtkIdTypeArray>("SiteId", 1, count);
  const auto offsets = littoral::NewArray<vtkIdTypeArray>(nullptr, 1, count + 1);
  const auto corners = littoral::NewArray<vtkIdTypeArray>(nullptr, 1, count);
  offsets->SetValue(count, count);
  littoral::ForRanges(littoral::SmpFor, static_cast<std::size_t>(count), PointsOfRange, [&](auto begin, auto end) {
    for (auto n = static_cast<vtkIdType>(begin); n < static_cast<vtkIdType>(end); ++n)
    {
      const littoral::PlanePosition& point = pattern.Points[static_cast<std::size_t>(part.Begin + n)];
      double* position = coordinates->GetPointer(3 * n);
      position[0] = point[0];
      position[1] = point[1];
      position[2] = 0.0;
      siteId->SetValue(n, part.Begin + n);
      offsets->SetValue(n, n);
      corners->SetValue(n, n);
    }
  });
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  vtkNew<vtkCellArray> vertices;
  vertices->SetData(offsets, corners);
  output->SetPoints(points);
  output->SetVerts(vertices);
  output->GetPointData()->AddArray(siteId);
}

}

/// Process, window and what points are besides, in full.
class vtkPointProcessSource::Recipe
{
public:
  littoral::PointProcessParameters Process;
  littoral::ObservationWindow Window;
  littoral::ProcessOptions Options;
  littoral::IntensityRaster Raster;
  littoral::MarkOptions Marks;
};

//----------------------------------------------------------------------------
vtkPointProcessSource::vtkPointProcessSource()
  : Origin{ 0.0, 0.0 }
  , Size{ 500.0, 500.0 }
  , Process(Thomas)
  , Intensity(0.01)
  , ClusterSize(8.0)
  , ClusterScale(8.0)
  , Variance(1.0)
  , Range(30.0)
  , Distance(4.0)
  , Activity(0.02)
  , Interaction(0.1)
  , Softness(0.4)
  , IntensityArray("None")
  , IntensityScale(Relative)
  , NumberOfSpecies(1)
  , SpeciesGrouping(ByPoint)
  , CrossInteraction(1.0)
  , Marks(false)
  , MarkMean(1.0)
  , MarkVariation(0.3)
  , MarkClusterCorrelation(0.0)
  , Seed(1)
{
  this->SetNumberOfInputPorts(3);
}

//----------------------------------------------------------------------------
vtkPointProcessSource::~vtkPointProcessSource() = default;

//----------------------------------------------------------------------------
void vtkPointProcessSource::SetIntensityArray(const char* name)
{
  const std::string wanted = name ? name : "";
  if (this->IntensityArray != wanted)
  {
    this->IntensityArray = wanted;
    this->Modified();
  }
}

//----------------------------------------------------------------------------
int vtkPointProcessSource::FillInputPortInformation(int port, vtkInformation* info)
{
  const char* types[] = { "vtkTable", "vtkImageData", "vtkPolyData" };
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), types[port]);
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//----------------------------------------------------------------------------
int vtkPointProcessSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//----------------------------------------------------------------------------
int vtkPointProcessSource::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    littoral::RequestAll(inputVector[port]->GetInformationObject(0));
  }
  return 1;
}

//----------------------------------------------------------------------------
/// Takes properties, and what inputs have in their place.
void vtkPointProcessSource::MakeRecipe(vtkInformationVector** inputs, Recipe& recipe)
{
  littoral::PointProcessParameters& process = recipe.Process;
  process.Process = static_cast<littoral::PointProcess>(this->Process);
  process.Intensity = this->Intensity;
  process.ClusterSize = this->ClusterSize;
  process.ClusterScale = this->ClusterScale;
  process.Variance = this->Variance;
  process.Range = this->Range;
  process.Distance = this->Distance;
  process.Activity = this->Activity;
  process.Interaction = this->Interaction;
  process.Softness = this->Softness;
  recipe.Options.Seed = this->Seed;
  recipe.Options.Grouping = static_cast<littoral::SpeciesGrouping>(this->SpeciesGrouping);
  recipe.Options.CrossInteraction = this->CrossInteraction;
  recipe.Marks = { this->Seed, this->MarkMean, this->MarkVariation, this->MarkClusterCorrelation };
  littoral::ParameterCheck check;
  for (int axis = 0; axis < 2; ++axis)
  {
    const std::string component = "[" + std::to_string(axis) + "]";
    check.Finite("Origin" + component, this->Origin[axis], "m");
    check.Positive("Size" + component, this->Size[axis], "m");
  }
  check.Count("NumberOfSpecies", this->NumberOfSpecies, 1, MostSpecies);
  check.Choice("IntensityScale", this->IntensityScale, { "relative", "absolute" });
  littoral::Require(check.Reason());
  recipe.Window = littoral::ObservationWindow::Rectangle(
    { this->Origin[0], this->Origin[1] }, { this->Origin[0] + this->Size[0], this->Origin[1] + this->Size[1] });
  if (this->NumberOfSpecies > 1)
  {
    recipe.Options.SpeciesShares.assign(static_cast<std::size_t>(this->NumberOfSpecies), 1.0);
  }
  auto* table = littoral::OptionalInputOf<vtkTable>(inputs[FitPort], "Input");
  auto* image = littoral::OptionalInputOf<vtkImageData>(inputs[IntensityPort], "IntensityImage");
  auto* polygon = littoral::OptionalInputOf<vtkPolyData>(inputs[WindowPort], "Window");
  if (table)
  {
    littoral::ReadProcessFit(table, process, recipe.Window, recipe.Raster);
  }
  recipe.Window = polygon ? littoral::ReadWindow(polygon) : recipe.Window;
  if (image || !recipe.Raster.Values.empty())
  {
    recipe.Options.Raster = &recipe.Raster;
  }
  if (image)
  {
    recipe.Raster.Scale = static_cast<littoral::IntensityScale>(this->IntensityScale);
    const bool isActive = this->IntensityArray.empty() || this->IntensityArray == "None";
    const littoral::ArrayReader points = littoral::ArrayReader::OfPoints(image, "the intensity image");
    vtkDataArray* values =
      isActive ? points.Fit(image->GetPointData()->GetScalars(), 1) : points.Need(this->IntensityArray.c_str(), 1);
    littoral::ReadIntensity(image, values, recipe.Raster);
  }
}

//----------------------------------------------------------------------------
std::string vtkPointProcessSource::WhyInvalid(const Recipe& recipe) const
{
  littoral::ParameterCheck check;
  check.Require(littoral::WhyInvalid(recipe.Process, recipe.Options, recipe.Window));
  check.Require(this->Marks ? littoral::WhyInvalid(recipe.Marks) : std::string());
  if (check.IsGood())
  {
    const double draws = littoral::ExpectedDraws(recipe.Process, recipe.Options, recipe.Window);
    littoral::RequirePoints(draws, "Intensity", recipe.Process.Intensity);
    littoral::RequireMemory(
      BytesOfPoint * draws, "The process, which makes " + littoral::TextOf(draws) + " points,", "take a smaller Size");
  }
  return check.Reason();
}

//----------------------------------------------------------------------------
int vtkPointProcessSource::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  Recipe recipe;
  this->MakeRecipe(inputVector, recipe);
  littoral::Require(this->WhyInvalid(recipe));
  this->SetProgressText("Scattering points");
  const ProcessPattern pattern = littoral::SimulateProcess(
    recipe.Process, recipe.Options, recipe.Window, littoral::PollOf(this), littoral::AbortableFor(this, 0.0, 0.8));
  const littoral::PieceRange part =
    littoral::RequestedPart(outputVector->GetInformationObject(0), static_cast<long long>(pattern.Points.size()));
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  AddVertices(pattern, part, output);
  if (pattern.HasClusters)
  {
    AddClusters(pattern, part, output);
  }
  if (this->NumberOfSpecies > 1)
  {
    AddPart<vtkIntArray>("Species", pattern.Species, part, output);
  }
  if (this->Marks)
  {
    AddPart<vtkDoubleArray>("Mark", littoral::DrawMarks(pattern, recipe.Marks, littoral::SmpFor), part, output);
  }
  littoral::AddField(output, "IsExact", { pattern.IsExact ? 1.0 : 0.0 });
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
const char* vtkPointProcessSource::GetProcessAsString() const
{
  return littoral::NameOfRow<littoral::PointProcess>(this->Process, littoral::NumberOfPointProcesses);
}

//----------------------------------------------------------------------------
int vtkPointProcessSource::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(this, request, outputs,
    "Cannot scatter points: ", [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkPointProcessSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Origin: " << this->Origin[0] << " " << this->Origin[1] << "\n";
  os << indent << "Size: " << this->Size[0] << " " << this->Size[1] << "\n";
  os << indent << "Process: " << this->Process << "\n";
  os << indent << "Intensity: " << this->Intensity << "\n";
  os << indent << "ClusterSize: " << this->ClusterSize << "\n";
  os << indent << "ClusterScale: " << this->ClusterScale << "\n";
  os << indent << "Variance: " << this->Variance << "\n";
  os << indent << "Range: " << this->Range << "\n";
  os << indent << "Distance: " << this->Distance << "\n";
  os << indent << "Activity: " << this->Activity << "\n";
  os << indent << "Interaction: " << this->Interaction << "\n";
  os << indent << "Softness: " << this->Softness << "\n";
  os << indent << "IntensityArray: " << this->IntensityArray << "\n";
  os << indent << "IntensityScale: " << this->IntensityScale << "\n";
  os << indent << "NumberOfSpecies: " << this->NumberOfSpecies << "\n";
  os << indent << "SpeciesGrouping: " << this->SpeciesGrouping << "\n";
  os << indent << "CrossInteraction: " << this->CrossInteraction << "\n";
  os << indent << "Marks: " << this->Marks << "\n";
  os << indent << "MarkMean: " << this->MarkMean << "\n";
  os << indent << "MarkVariation: " << this->MarkVariation << "\n";
  os << indent << "MarkClusterCorrelation: " << this->MarkClusterCorrelation << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
