// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkQuadratPointSource.h"

#include "Data/Arrays.h"
#include "Data/Inputs.h"
#include "Data/QuadratTable.h"
#include "Numerics/ParameterCheck.h"
#include "Patterns/QuadratPattern.h"
#include "Pipeline/Pipeline.h"
#include "Pipeline/Ranges.h"
#include "Pipeline/SharedParts.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkQuadratPointSource);

namespace
{
/// More quadrats than this are hardly meant.
constexpr long long MostQuadrats = 1000000000;
/// Points that one thread places at a time, more or less.
constexpr long long PointsAtOnce = 1 << 14;

/// The points of some quadrats in a row.
class PatternPiece
{
public:
  PatternPiece(const littoral::QuadratGrid& grid, int seed, const std::vector<int>& counts, double mean,
    const littoral::PieceRange& part)
    : Grid(grid)
    , Seed(seed)
    , Counts(counts)
    , First(static_cast<std::size_t>(part.Begin))
    , End(static_cast<std::size_t>(part.End))
    , QuadratsAtOnce(static_cast<std::size_t>(std::max(1.0, PointsAtOnce / std::max(1.0, mean))))
    , Sites(littoral::QuadratSites(counts, this->First, this->End, this->QuadratsAtOnce))
    , Coordinates(littoral::NewArray<vtkDoubleArray>("Points", 3, this->GetNumberOfPoints()))
    , SiteId(littoral::NewArray<vtkIdTypeArray>("SiteId", 1, this->GetNumberOfPoints()))
    , QuadratId(littoral::NewArray<vtkIdTypeArray>("QuadratId", 1, this->GetNumberOfPoints()))
    , Offsets(littoral::NewArray<vtkIdTypeArray>(nullptr, 1, this->GetNumberOfPoints() + 1))
    , Corners(littoral::NewArray<vtkIdTypeArray>(nullptr, 1, this->GetNumberOfPoints()))
  {
    this->Offsets->SetValue(this->GetNumberOfPoints(), this->GetNumberOfPoints());
  }

  std::size_t GetNumberOfBatches() const { return this->Sites.size() - 1; }

  /// Places the points of a batch of quadrats, in any order on any threads.
  void Scatter(std::size_t batch)
  {
    const std::size_t begin = this->First + batch * this->QuadratsAtOnce;
    const std::size_t end = std::min(begin + this->QuadratsAtOnce, this->End);
    const vtkIdType site = this->Sites[batch];
    const vtkIdType point = site - this->Sites.front();
    const vtkIdType count = this->Sites[batch + 1] - site;
    littoral::PlaceQuadratPoints(this->Grid, this->Seed, this->Counts, begin, end,
      this->Coordinates->GetPointer(3 * point), this->QuadratId->GetPointer(point));
    const auto fill = [=](vtkIdTypeArray* array, vtkIdType first) {
      std::iota(array->GetPointer(point), array->GetPointer(point) + count, first);
    };
    fill(this->SiteId, site);
    fill(this->Offsets, point);
    fill(this->Corners, point);
  }

  void AddTo(vtkPolyData* output) const
  {
    vtkNew<vtkCellArray> vertices;
    vertices->SetData(this->Offsets, this->Corners);
    output->SetPoints(littoral::PointsWithRanges(this->Coordinates));
    output->SetVerts(vertices);
    output->GetPointData()->AddArray(this->SiteId);
    output->GetPointData()->AddArray(this->QuadratId);
  }

private:
  vtkIdType GetNumberOfPoints() const { return this->Sites.back() - this->Sites.front(); }

  const littoral::QuadratGrid& Grid;
  int Seed;
  const std::vector<int>& Counts; ///< points of each quadrat
  std::size_t First;
  std::size_t End;
  std::size_t QuadratsAtOnce;
  std::vector<long long> Sites; ///< the first of each batch, and the end
  vtkSmartPointer<vtkDoubleArray> Coordinates;
  vtkSmartPointer<vtkIdTypeArray> SiteId;
  vtkSmartPointer<vtkIdTypeArray> QuadratId;
  vtkSmartPointer<vtkIdTypeArray> Offsets;
  vtkSmartPointer<vtkIdTypeArray> Corners;
};

}

/// Law and grid in full.
class vtkQuadratPointSource::Recipe
{
public:
  littoral::QuadratLawParameters Law;
  littoral::QuadratGrid Grid;
};

//----------------------------------------------------------------------------
vtkQuadratPointSource::vtkQuadratPointSource()
  : Origin{ 0.0, 0.0 }
  , Size{ 1000.0, 1000.0 }
  , Quadrats{ 20, 20 }
  , Law(Poisson)
  , MeanPerQuadrat(1.0)
  , Trials(3)
  , ClusterShape(0.5)
  , ClusterMean(4.0)
  , ClusterSuccess(0.5)
  , Mode(Quota)
  , Seed(1)
{
  this->SetNumberOfInputPorts(1);
}

//----------------------------------------------------------------------------
vtkQuadratPointSource::~vtkQuadratPointSource() = default;

//----------------------------------------------------------------------------
int vtkQuadratPointSource::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//----------------------------------------------------------------------------
int vtkQuadratPointSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  littoral::AnnouncePartForm(outputVector->GetInformationObject(0), littoral::PartForm::Runs);
  return 1;
}

//----------------------------------------------------------------------------
int vtkQuadratPointSource::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  littoral::RequestAll(inputVector[0]->GetInformationObject(0));
  return 1;
}

//----------------------------------------------------------------------------
void vtkQuadratPointSource::MakeRecipe(vtkInformationVector* fits, Recipe& recipe)
{
  littoral::QuadratLawParameters& law = recipe.Law;
  law.Law = static_cast<littoral::QuadratLaw>(this->Law);
  law.Mean = this->MeanPerQuadrat;
  law.Trials = this->Trials;
  law.ClusterShape = this->ClusterShape;
  law.ClusterMean = this->ClusterMean;
  law.ClusterSuccess = this->ClusterSuccess;
  recipe.Grid = { { this->Origin[0], this->Origin[1] }, { this->Size[0], this->Size[1] },
    { this->Quadrats[0], this->Quadrats[1] } };
  if (auto* table = littoral::OptionalInputOf<vtkTable>(fits, "Input"))
  {
    littoral::ReadQuadratFit(table, recipe.Law, recipe.Grid);
  }
}

//----------------------------------------------------------------------------
std::string vtkQuadratPointSource::WhyInvalid(const Recipe& recipe) const
{
  littoral::ParameterCheck check;
  check.Require(littoral::WhyInvalid(recipe.Grid));
  check.Require(littoral::WhyInvalid(recipe.Law));
  check.Choice("Mode", this->Mode, { "quota", "sampling" });
  const long long quadrats = recipe.Grid.NumberOfQuadrats();
  const double points = static_cast<double>(quadrats) * recipe.Law.Mean;
  const std::string words = std::to_string(quadrats) + " Quadrats of MeanPerQuadrat";
  check.Require(quadrats <= MostQuadrats, words + " are more than memory is made for.");
  if (check.IsGood())
  {
    littoral::RequirePoints(points, "MeanPerQuadrat", recipe.Law.Mean);
    littoral::RequireMemory(48.0 * points + 8.0 * static_cast<double>(quadrats),
      "A pattern of " + words + ", " + littoral::TextOf(recipe.Law.Mean) + ",", "take fewer");
  }
  return check.Reason();
}

//----------------------------------------------------------------------------
int vtkQuadratPointSource::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  Recipe recipe;
  this->MakeRecipe(inputVector[0], recipe);
  littoral::Require(this->WhyInvalid(recipe));
  this->SetProgressText("Scattering points");
  const long long quadrats = recipe.Grid.NumberOfQuadrats();
  const auto mode = static_cast<littoral::QuadratMode>(this->Mode);
  const std::vector<int> counts = littoral::QuadratCounts(
    recipe.Law, quadrats, mode, this->Seed, littoral::PollOf(this), littoral::AbortableFor(this));
  const littoral::PieceRange part = littoral::RequestedPart(outputVector->GetInformationObject(0), quadrats);
  PatternPiece pattern(recipe.Grid, this->Seed, counts, recipe.Law.Mean, part);
  if (littoral::RunWithProgress(this, pattern.GetNumberOfBatches(), 0.2, 1.0,
        [&](std::size_t batch) { pattern.Scatter(batch); })) // else aborted
  {
    pattern.AddTo(vtkPolyData::GetData(outputVector));
    this->UpdateProgress(1.0);
  }
  return 1;
}

//----------------------------------------------------------------------------
const char* vtkQuadratPointSource::GetLawAsString() const
{
  return littoral::NameOfRow<littoral::QuadratLaw>(this->Law, littoral::NumberOfQuadratLaws);
}

//----------------------------------------------------------------------------
int vtkQuadratPointSource::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(this, request, outputs,
    "Cannot scatter points: ", [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkQuadratPointSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Origin: " << this->Origin[0] << " " << this->Origin[1] << "\n";
  os << indent << "Size: " << this->Size[0] << " " << this->Size[1] << "\n";
  os << indent << "Quadrats: " << this->Quadrats[0] << " " << this->Quadrats[1] << "\n";
  os << indent << "Law: " << this->Law << "\n";
  os << indent << "MeanPerQuadrat: " << this->MeanPerQuadrat << "\n";
  os << indent << "Trials: " << this->Trials << "\n";
  os << indent << "ClusterShape: " << this->ClusterShape << "\n";
  os << indent << "ClusterMean: " << this->ClusterMean << "\n";
  os << indent << "ClusterSuccess: " << this->ClusterSuccess << "\n";
  os << indent << "Mode: " << this->Mode << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
