// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindFieldSource.h"

#include "Data/Arrays.h"
#include "Data/WindImage.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Mistakes.h"
#include "Pipeline/Pipeline.h"
#include "Pipeline/RankTeam.h"
#include "Wind/CarriedWind.h"
#include "Wind/IecWind.h"
#include "Wind/WindField.h"
#include "Wind/WindVeer.h"

#include "vtkDoubleArray.h"
#include "vtkExtentTranslator.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerRequestKey.h"
#include "vtkInformationStringKey.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

vtkStandardNewMacro(vtkWindFieldSource);

namespace
{
void AddNumber(vtkFieldData* fields, const char* name, double number)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->InsertNextValue(number);
  fields->AddArray(array);
}

/// Number of points of an extent.
double NumberOfPoints(const int extent[6])
{
  double points = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    points *= std::max(0.0, extent[2 * axis + 1] - static_cast<double>(extent[2 * axis]) + 1.0);
  }
  return points;
}

littoral::WindColumns ColumnsOf(const std::array<int, 6>& extent)
{
  return NumberOfPoints(extent.data()) > 0.0 ? littoral::WindColumns{ extent[2], extent[3] + 1 }
                                             : littoral::WindColumns{};
}

/// The grid of some columns of a wind.
littoral::WindGrid KeptGrid(littoral::WindGrid grid, const littoral::WindColumns& columns)
{
  grid.Count[1] = columns.Count();
  return grid;
}
}

/// All that the field depends on.
class vtkWindFieldSource::Recipe
{
public:
  littoral::WindModel Model;
  littoral::WindGrid Grid;
  littoral::WindSynthesis Synthesis;
  littoral::IECSite Site;

  /// A number that tells fields apart, not 0.
  std::uint64_t Key() const;
};

//----------------------------------------------------------------------------
std::uint64_t vtkWindFieldSource::Recipe::Key() const
{
  const littoral::WindModel& model = this->Model;
  const littoral::WindGrid& grid = this->Grid;
  std::vector<double> numbers{ model.ReferenceSpeed, model.ReferenceHeight, model.RoughnessLength,
    static_cast<double>(model.Spectrum), model.TurbulenceIntensity, static_cast<double>(model.Coherence),
    model.ShearExponent, model.Veer, grid.TimeStep, grid.LateralSpacing, grid.VerticalSpacing, grid.BottomHeight,
    static_cast<double>(this->Synthesis.Phases), this->Synthesis.NormalizeVariance ? 1.0 : 0.0,
    static_cast<double>(this->Synthesis.Seed), this->Synthesis.ShearStress ? 1.0 : 0.0 };
  numbers.insert(numbers.end(), grid.Count.begin(), grid.Count.end());
  for (const littoral::WindDecay& decay : model.Decay)
  {
    numbers.insert(numbers.end(), { decay.Lateral, decay.Vertical });
  }
  const std::string_view bytes(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
  return std::hash<std::string_view>()(bytes) | 1u;
}

/// The field at time 0 in the axes of the wind, or some columns of it.
class vtkWindFieldSource::vtkInternals
{
public:
  vtkTimeStamp Made;
  littoral::WindColumns Columns;
  std::vector<float> Velocities;
  double CoherenceError = 0.0;
};

//----------------------------------------------------------------------------
vtkWindFieldSource::vtkWindFieldSource()
  : Dimensions{ 600, 64, 24 }
  , TimeStep(0.1)
  , LateralSpacing(4.0)
  , VerticalSpacing(2.0)
  , BottomHeight(1.0)
  , Center{ 0.0, 0.0 }
  , ReferenceSpeed(10.0)
  , ReferenceHeight(10.0)
  , RoughnessLength(0.03)
  , WindDirection(0.0)
  , Coherence(Exponential)
  , LongitudinalDecay{ 10.0, 10.0 }
  , LateralDecay{ 10.0, 10.0 }
  , VerticalDecay{ 8.0, 8.0 }
  , Spectrum(SimiuScanlan)
  , TurbulenceIntensity(0.16)
  , Phases(Uniform)
  , NormalizeVariance(false)
  , Seed(1)
  , ShearStress(false)
  , IECClass(NoClass)
  , IECTurbulence(NormalTurbulence)
  , IECEvent(NoEvent)
  , EventStart(5.0)
  , AnnualMeanSpeed(10.0)
  , RotorDiameter(126.0)
  , ShearExponent(0.0)
  , Veer(0.0)
{
  this->SetNumberOfInputPorts(0);
}

//----------------------------------------------------------------------------
vtkWindFieldSource::~vtkWindFieldSource() = default;

//----------------------------------------------------------------------------
vtkWindFieldSource::Recipe vtkWindFieldSource::MakeRecipe() const
{
  Recipe recipe;
  littoral::WindModel& model = recipe.Model;
  model.ReferenceSpeed = this->ReferenceSpeed;
  model.ReferenceHeight = this->ReferenceHeight;
  model.RoughnessLength = this->RoughnessLength;
  model.Spectrum = static_cast<littoral::WindSpectrumModel>(this->Spectrum);
  model.TurbulenceIntensity = this->TurbulenceIntensity;
  model.ShearExponent = this->ShearExponent;
  model.Veer = this->Veer;
  model.Coherence = static_cast<littoral::WindCoherenceModel>(this->Coherence);
  model.Decay = { { { this->LongitudinalDecay[0], this->LongitudinalDecay[1] },
    { this->LateralDecay[0], this->LateralDecay[1] }, { this->VerticalDecay[0], this->VerticalDecay[1] } } };
  littoral::WindGrid& grid = recipe.Grid;
  grid.Count = { this->Dimensions[0], this->Dimensions[1], this->Dimensions[2] };
  grid.TimeStep = this->TimeStep;
  grid.LateralSpacing = this->LateralSpacing;
  grid.VerticalSpacing = this->VerticalSpacing;
  grid.BottomHeight = this->BottomHeight;
  recipe.Synthesis = { static_cast<littoral::WindPhases>(this->Phases), this->NormalizeVariance, this->Seed,
    this->ShearStress };
  recipe.Site = { static_cast<littoral::IECClass>(this->IECClass), this->AnnualMeanSpeed, this->RotorDiameter,
    this->ReferenceSpeed, this->ReferenceHeight };
  if (this->IECClass > NoClass && this->IECClass < littoral::NumberOfIECClasses)
  {
    const auto turbulence = static_cast<littoral::IECTurbulence>(this->IECTurbulence);
    model.TurbulenceIntensity = littoral::DeviationOf(recipe.Site, turbulence) / this->ReferenceSpeed;
  }
  return recipe;
}

//----------------------------------------------------------------------------
int vtkWindFieldSource::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const Recipe recipe = this->MakeRecipe();
  const littoral::WindGrid& grid = recipe.Grid;
  littoral::ParameterCheck check;
  check.Require(littoral::WhyInvalid(recipe.Model, grid));
  check.Choice("Phases", this->Phases, 2);
  check.Choice("IECTurbulence", this->IECTurbulence, 2);
  check.Require(littoral::WhyInvalid(recipe.Site, static_cast<littoral::IECEvent>(this->IECEvent)));
  check.Finite("EventStart", this->EventStart, "s");
  check.Finite("WindDirection", this->WindDirection, "degrees");
  check.Finite("Center[0]", this->Center[0], "m");
  check.Finite("Center[1]", this->Center[1], "m");
  if (!check.IsGood())
  {
    vtkImageData::GetData(outputVector)->Initialize();
    littoral::Refuse("Cannot make a wind: ", check.Reason());
  }

  const int extent[6] = { 0, grid.Count[0] - 1, 0, grid.Count[1] - 1, 0, grid.Count[2] - 1 };
  const double spacing[3] = { littoral::ConvectionSpeed(recipe.Model) * grid.TimeStep, grid.LateralSpacing,
    grid.VerticalSpacing };
  const double angle = vtkMath::RadiansFromDegrees(this->WindDirection);
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  const double back = 0.5 * spacing[0] * extent[1];
  const double right = 0.5 * spacing[1] * extent[3];
  const double origin[3] = { this->Center[0] - cosine * back + sine * right,
    this->Center[1] - sine * back - cosine * right, grid.BottomHeight };
  const double direction[9] = { cosine, -sine, 0.0, sine, cosine, 0.0, 0.0, 0.0, 1.0 };

  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::ORIGIN(), origin, 3);
  info->Set(vtkDataObject::SPACING(), spacing, 3);
  info->Set(vtkDataObject::DIRECTION(), direction, 9);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  if (grid.Count[1] > 1)
  {
    // Pieces of whole lines: a transform along the wind makes one of them.
    info->Set(vtkExtentTranslator::UPDATE_SPLIT_MODE(), vtkExtentTranslator::Y_SLAB_MODE);
  }
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 3);

  std::vector<double> times(grid.Count[0]);
  for (int step = 0; step < grid.Count[0]; ++step)
  {
    times[step] = step * grid.TimeStep;
  }
  const double range[2] = { 0.0, grid.Period() };
  info->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times.data(), grid.Count[0]);
  info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
  return 1;
}

//----------------------------------------------------------------------------
bool vtkWindFieldSource::IsFresh()
{
  return this->Internals && this->Internals->Made.GetMTime() > this->GetMTime();
}

//----------------------------------------------------------------------------
void vtkWindFieldSource::RequireSize(
  const Recipe& recipe, const littoral::WindColumns& columns, bool isMade, double points)
{
  const littoral::WindGrid& grid = recipe.Grid;
  littoral::RequireGridPoints("A wind of Dimensions",
    { static_cast<double>(grid.Count[0]), static_cast<double>(grid.Count[1]), static_cast<double>(grid.Count[2]) }, 1.0,
    [](double count) { return littoral::LastWindLength(static_cast<int>(count)); });
  const double output = points * sizeof(float) * littoral::WindComponents;
  littoral::RequireMemory(output + (isMade ? 0.0 : littoral::WindFieldBytes(grid, columns.Count())),
    "A wind with Dimensions " + std::to_string(grid.Count[0]) + " x " + std::to_string(grid.Count[1]) + " x " +
      std::to_string(grid.Count[2]),
    "take smaller Dimensions");
}

//----------------------------------------------------------------------------
/// Makes the columns of a rank, where all of a team make the same wind.
void vtkWindFieldSource::FreezeShared(
  const Recipe& recipe, const littoral::WindColumns& columns, double points, littoral::RankTeam& team)
{
  this->Internals.reset();
  team.Run([&] {
    if (!team.Agree(recipe.Key()) || !team.IsSharing())
    {
      return;
    }
    RequireSize(recipe, columns, false, points);
    this->SetProgressText("Making wind");
    auto frozen = std::make_unique<vtkInternals>();
    littoral::WindField field(recipe.Model, recipe.Grid, recipe.Synthesis, columns);
    frozen->Velocities = field.MakeShared(team.Share(), littoral::AbortableFor(this));
    littoral::TurnWithHeight(recipe.Model, KeptGrid(recipe.Grid, columns), littoral::VeerTurn::FromLocal,
      frozen->Velocities.data(), littoral::AbortableFor(this));
    frozen->CoherenceError = field.GetCoherenceError();
    frozen->Columns = columns;
    frozen->Made.Modified();
    this->Internals = std::move(frozen);
  });
}

//----------------------------------------------------------------------------
bool vtkWindFieldSource::Freeze(const Recipe& recipe)
{
  auto frozen = std::make_unique<vtkInternals>();
  frozen->Columns = { 0, recipe.Grid.Count[1] };
  this->Internals.reset();
  this->SetProgressText("Making wind");
  frozen->Velocities.resize(recipe.Grid.NumberOfLines() * recipe.Grid.Count[0] * littoral::WindComponents);
  if (this->IECEvent != NoEvent)
  {
    littoral::MakeEventWind(recipe.Model, recipe.Grid, recipe.Site, static_cast<littoral::IECEvent>(this->IECEvent),
      this->EventStart, frozen->Velocities.data(), littoral::AbortableFor(this));
    littoral::TurnWithHeight(recipe.Model, recipe.Grid, littoral::VeerTurn::FromLocal, frozen->Velocities.data(),
      littoral::AbortableFor(this));
    frozen->Made.Modified();
    this->Internals = std::move(frozen);
    return true;
  }
  littoral::WindField field(recipe.Model, recipe.Grid, recipe.Synthesis);
  for (int component = 0; component < littoral::WindComponents; ++component)
  {
    const double first = 0.9 * component / littoral::WindComponents;
    field.BeginComponent(component);
    if (!littoral::RunWithProgress(
          this, field.NumberOfBlocks(), first, first + 0.2, [&](std::size_t block) { field.MakePlanes(block); }))
    {
      return false;
    }
    field.FinishPlanes();
    if (!littoral::RunWithProgress(this, field.NumberOfPacks(), first + 0.2, first + 0.3, [&](std::size_t pack) {
          littoral::LinePack room = field.RoomForLines();
          field.MakeLines(pack, room, frozen->Velocities.data());
        }))
    {
      return false;
    }
  }
  littoral::TurnWithHeight(
    recipe.Model, recipe.Grid, littoral::VeerTurn::FromLocal, frozen->Velocities.data(), littoral::AbortableFor(this));
  frozen->CoherenceError = field.GetCoherenceError();
  frozen->Made.Modified();
  this->Internals = std::move(frozen);
  return true;
}

//----------------------------------------------------------------------------
void vtkWindFieldSource::CopyVelocities(
  const littoral::WindGrid& grid, double time, const std::array<double, 2>& turn, vtkImageData* output) const
{
  const int* extent = output->GetExtent();
  const auto velocity =
    littoral::NewArray<vtkFloatArray>("Velocity", littoral::WindComponents, output->GetNumberOfPoints());
  velocity->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), "m/s");
  const littoral::WindColumns& columns = this->Internals->Columns;
  littoral::CarryWind(KeptGrid(grid, columns), this->Internals->Velocities.data(), std::isfinite(time) ? time : 0.0,
    turn, { { extent[0], extent[2] - columns.First, extent[4] }, { extent[1], extent[3] - columns.First, extent[5] } },
    velocity->GetPointer(0), littoral::SmpFor);
  output->GetPointData()->SetVectors(velocity);
}

//----------------------------------------------------------------------------
namespace
{

/// Marks what belongs to other pieces, in place of VTK, which takes all pieces of images for blocks: so it must not
/// know of these ghosts, and asks for them anew at each update.
void MarkGhosts(vtkInformation* info, vtkImageData* image)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformationIntegerKey* mode = vtkExtentTranslator::UPDATE_SPLIT_MODE();
  if (info->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS()) < 1 || !info->Has(mode))
  {
    return;
  }
  std::array<int, 6> whole{};
  std::array<int, 6> own{};
  info->Get(Pipeline::WHOLE_EXTENT(), whole.data());
  vtkNew<vtkExtentTranslator> translator;
  const int hasPart = translator->PieceToExtentThreadSafe(info->Get(Pipeline::UPDATE_PIECE_NUMBER()),
    info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()), 0, whole.data(), own.data(), info->Get(mode), 0);
  if (hasPart != 0)
  {
    image->GenerateGhostArray(own.data());
    info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
}

}

//----------------------------------------------------------------------------
int vtkWindFieldSource::RequestData(vtkInformation* request, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  littoral::ForgetExtent(info);
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  if (littoral::IsAnnouncedEmpty(info))
  {
    return littoral::FailedRequest(this);
  }
  const Recipe recipe = this->MakeRecipe();
  const littoral::WindGrid& grid = recipe.Grid;
  std::array<int, 6> extent = littoral::RequestedExtent(info);
  const double points = NumberOfPoints(extent.data());
  const littoral::WindColumns columns = ColumnsOf(extent);
  // All ranks execute after a change, for some piece each; one that asks for more later is alone.
  littoral::RankTeam team(request, outputVector);
  if (!this->IsFresh() && !team.IsAlone() && this->IECEvent == NoEvent)
  {
    this->FreezeShared(recipe, columns, points, team);
  }
  const bool isMade = this->IsFresh() && this->Internals->Columns.Hold(columns);
  RequireSize(recipe, { 0, grid.Count[1] }, isMade, points);
  if (!isMade && points > 0.0 && !this->Freeze(recipe))
  {
    return 1; // aborted
  }
  double place[9];
  output->SetExtent(extent.data());
  info->Get(vtkDataObject::ORIGIN(), place);
  output->SetOrigin(place);
  info->Get(vtkDataObject::SPACING(), place);
  output->SetSpacing(place);
  info->Get(vtkDataObject::DIRECTION(), place);
  output->SetDirectionMatrix(place);
  const double time = littoral::RequestedTime(info);
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  if (!(points > 0.0))
  {
    return 1; // a rank with nothing to do
  }
  this->CopyVelocities(grid, time, { place[0], place[3] }, output);
  vtkFieldData* fields = output->GetFieldData();
  AddNumber(fields, "CoherenceError", this->Internals->CoherenceError);
  AddNumber(fields, "FrictionVelocity", littoral::FrictionVelocity(recipe.Model));
  AddNumber(fields, "ConvectionSpeed", littoral::ConvectionSpeed(recipe.Model));
  AddNumber(fields, "Period", grid.Period());
  littoral::WriteWindModel(recipe.Model, output);
  MarkGhosts(info, output);
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
const char* vtkWindFieldSource::GetSpectrumAsString() const
{
  return littoral::NameOfRow<littoral::WindSpectrumModel>(this->Spectrum, littoral::NumberOfWindSpectra);
}

//----------------------------------------------------------------------------
const char* vtkWindFieldSource::GetCoherenceAsString() const
{
  return littoral::NameOfRow<littoral::WindCoherenceModel>(this->Coherence, littoral::NumberOfWindCoherences);
}

//----------------------------------------------------------------------------
int vtkWindFieldSource::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(
    this, request, outputs, [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkWindFieldSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dimensions: " << this->Dimensions[0] << " " << this->Dimensions[1] << " " << this->Dimensions[2]
     << "\n";
  os << indent << "TimeStep: " << this->TimeStep << "\n";
  os << indent << "LateralSpacing: " << this->LateralSpacing << "\n";
  os << indent << "VerticalSpacing: " << this->VerticalSpacing << "\n";
  os << indent << "BottomHeight: " << this->BottomHeight << "\n";
  os << indent << "Center: " << this->Center[0] << " " << this->Center[1] << "\n";
  os << indent << "ReferenceSpeed: " << this->ReferenceSpeed << "\n";
  os << indent << "ReferenceHeight: " << this->ReferenceHeight << "\n";
  os << indent << "RoughnessLength: " << this->RoughnessLength << "\n";
  os << indent << "WindDirection: " << this->WindDirection << "\n";
  os << indent << "Coherence: " << this->Coherence << "\n";
  os << indent << "LongitudinalDecay: " << this->LongitudinalDecay[0] << " " << this->LongitudinalDecay[1] << "\n";
  os << indent << "LateralDecay: " << this->LateralDecay[0] << " " << this->LateralDecay[1] << "\n";
  os << indent << "VerticalDecay: " << this->VerticalDecay[0] << " " << this->VerticalDecay[1] << "\n";
  os << indent << "Spectrum: " << this->Spectrum << "\n";
  os << indent << "TurbulenceIntensity: " << this->TurbulenceIntensity << "\n";
  os << indent << "Phases: " << this->Phases << "\n";
  os << indent << "NormalizeVariance: " << (this->NormalizeVariance ? "on" : "off") << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "ShearStress: " << (this->ShearStress ? "on" : "off") << "\n";
  os << indent << "IECClass: " << this->IECClass << "\n";
  os << indent << "IECTurbulence: " << this->IECTurbulence << "\n";
  os << indent << "IECEvent: " << this->IECEvent << "\n";
  os << indent << "EventStart: " << this->EventStart << "\n";
  os << indent << "AnnualMeanSpeed: " << this->AnnualMeanSpeed << "\n";
  os << indent << "RotorDiameter: " << this->RotorDiameter << "\n";
  os << indent << "ShearExponent: " << this->ShearExponent << "\n";
  os << indent << "Veer: " << this->Veer << "\n";
}
