// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSitePreferenceFilter.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/Inputs.h"
#include "Data/Places.h"
#include "Data/TableTexts.h"
#include "Data/TerrainGrid.h"
#include "Drainage/GroundWetness.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Pipeline.h"
#include "Plants/SiteGround.h"
#include "Plants/SitePreference.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSitePreferenceFilter);

namespace
{

constexpr int SitesPort = 0;
constexpr int TerrainPort = 1;
constexpr int PreferencesPort = 2;
constexpr double BytesOfSite = 100.0;                  // in the output, without the arrays of the input
constexpr double LargestIdentity = 9007199254740992.0; // 2^53

using Factor = littoral::GroundFactor;
using Species = std::vector<littoral::SpeciesPreference>;

/// The ground of a terrain; without drainage areas its wetness is not known.
littoral::SiteGround GroundOf(vtkImageData* terrain, const Species& species)
{
  const littoral::HeightGrid grid = littoral::MakeGrid(terrain);
  vtkDataArray* drainage = littoral::ArrayReader::OfPoints(terrain, "the Terrain").Find("DrainageArea", 1);
  littoral::Require(!drainage && littoral::AnyResponds(species, Factor::Wetness)
      ? "a species has a wetness, and the Terrain has no point array DrainageArea."
      : "");
  if (!drainage)
  {
    return littoral::SiteGround(grid);
  }
  const double width = std::sqrt(grid.Spacing[0] * grid.Spacing[1]);
  return littoral::SiteGround(grid, [drainage, width](long long point, double slope) {
    return littoral::WetnessOf(drainage->GetComponent(static_cast<vtkIdType>(point), 0), width, slope);
  });
}

/// A site that is kept.
struct KeptSite
{
  vtkIdType Site;
  long long Identity;
  int Species;
  double Place[2];
  littoral::GroundFactors Ground;
};

/// Arrays of the sites.
class Sites
{
public:
  explicit Sites(vtkPointSet* sites)
    : Points(sites)
  {
    const littoral::ArrayReader points = littoral::ArrayReader::OfPoints(sites, "a set of sites");
    this->Identities = points.Find("SiteId", 1);
    this->Kinds = points.Find("Species", 1);
  }

  /// Whether a site is kept, with what becomes of it.
  bool Keeps(vtkIdType site, const Species& species, const littoral::SiteGround& ground,
    const littoral::PreferenceOptions& options, KeptSite& kept) const
  {
    double place[3];
    this->Points->GetPoint(site, place);
    const double identity = this->Identities ? this->Identities->GetComponent(site, 0) : static_cast<double>(site);
    if (!(std::abs(identity) <= LargestIdentity))
    {
      littoral::ParameterCheck check;
      check.Range("SiteId of site " + std::to_string(site), identity, -LargestIdentity, LargestIdentity);
      littoral::Require(check.Reason());
    }
    const std::optional<littoral::GroundFactors> factors = ground.At(place[0], place[1]);
    if (ground.IsHole(place[0], place[1]))
    {
      return false;
    }
    if (!factors)
    {
      littoral::Refuse("site ", site, " at (", littoral::TextOf(place[0]), ", ", littoral::TextOf(place[1]),
        ") lies outside of the Terrain, or where it has no drainage area.");
    }
    kept.Ground = *factors;
    kept.Site = site;
    kept.Identity = static_cast<long long>(identity);
    std::copy_n(place, 2, kept.Place);
    if (!this->Kinds)
    {
      kept.Species = littoral::SpeciesAt(species, kept.Ground, options, kept.Identity);
      return kept.Species >= 0;
    }
    const auto last = static_cast<long long>(species.size()) - 1;
    const double kind = this->Kinds->GetComponent(site, 0);
    if (!littoral::IsWhole(kind, 0, last))
    {
      littoral::RequireWhole("Species of site " + std::to_string(site), kind, 0, last);
    }
    kept.Species = static_cast<int>(kind);
    return littoral::StaysAt(species[kept.Species], kept.Ground, options, kept.Identity);
  }

private:
  vtkPointSet* Points;
  vtkDataArray* Identities = nullptr;
  vtkDataArray* Kinds = nullptr;
};

/// Colors of species in turn: dark green, ochre, light green, red, blue, violet.
constexpr unsigned char Colors[][3] = { { 34, 84, 61 }, { 204, 132, 36 }, { 146, 190, 76 }, { 178, 60, 48 },
  { 64, 110, 160 }, { 130, 90, 150 } };

/// The color of each site's species.
void AddColors(vtkPolyData* output, const std::vector<KeptSite>& sites)
{
  const auto array = littoral::NewArray<vtkUnsignedCharArray>("RGB", 3, static_cast<vtkIdType>(sites.size()));
  for (std::size_t index = 0; index < sites.size(); ++index)
  {
    array->SetTypedTuple(
      static_cast<vtkIdType>(index), Colors[static_cast<std::size_t>(sites[index].Species) % std::size(Colors)]);
  }
  output->GetPointData()->AddArray(array);
}

/// An array of a number a site.
template <typename Array, typename ValueOf>
void AddNumbers(vtkPolyData* output, const char* name, const std::vector<KeptSite>& sites, const ValueOf& valueOf)
{
  const auto array = littoral::NewArray<Array>(name, 1, static_cast<vtkIdType>(sites.size()));
  for (std::size_t index = 0; index < sites.size(); ++index)
  {
    array->SetValue(static_cast<vtkIdType>(index), valueOf(sites[index]));
  }
  output->GetPointData()->AddArray(array);
}

/// The sites that are kept, on the ground.
void Write(const std::vector<KeptSite>& kept, vtkPointSet* sites, bool hasDrainage, const littoral::Poll& poll,
  vtkPolyData* output)
{
  littoral::SteppedPoll steps(poll);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  vtkPointData* arrays = output->GetPointData();
  arrays->CopyAllocate(sites->GetPointData(), static_cast<vtkIdType>(kept.size()));
  for (const KeptSite& site : kept)
  {
    steps.Step();
    const vtkIdType point = points->InsertNextPoint(site.Place[0], site.Place[1], site.Ground[0]);
    arrays->CopyData(sites->GetPointData(), site.Site, point);
    vertices->InsertNextCell(1, &point);
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  const auto factor = [&](const char* name, Factor which) {
    AddNumbers<vtkDoubleArray>(
      output, name, kept, [which](const KeptSite& site) { return site.Ground[static_cast<int>(which)]; });
  };
  AddNumbers<vtkTypeInt64Array>(output, "SiteId", kept, [](const KeptSite& site) { return site.Identity; });
  AddNumbers<vtkIntArray>(output, "Species", kept, [](const KeptSite& site) { return site.Species; });
  AddColors(output, kept);
  factor("Elevation", Factor::Elevation);
  factor("Slope", Factor::Slope);
  factor("Aspect", Factor::Aspect);
  if (hasDrainage)
  {
    factor("Wetness", Factor::Wetness);
  }
}

}

//----------------------------------------------------------------------------
vtkSitePreferenceFilter::vtkSitePreferenceFilter()
  : Thinning(false)
  , Seed(1)
{
  this->SetNumberOfInputPorts(3);
}

//----------------------------------------------------------------------------
vtkSitePreferenceFilter::~vtkSitePreferenceFilter() = default;

//----------------------------------------------------------------------------
int vtkSitePreferenceFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  const char* types[] = { "vtkPointSet", "vtkImageData", "vtkTable" };
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), types[port]);
  if (port != SitesPort)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // no terrain: our own, clearer message
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkSitePreferenceFilter::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//----------------------------------------------------------------------------
int vtkSitePreferenceFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (int port : { SitesPort, TerrainPort, PreferencesPort })
  {
    for (int index = 0; index < inputVector[port]->GetNumberOfInformationObjects(); ++index)
    {
      littoral::RequestAll(inputVector[port]->GetInformationObject(index));
    }
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkSitePreferenceFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* sites = littoral::InputOf<vtkPointSet>(inputVector[SitesPort], "Sites");
  auto* terrain = littoral::OptionalInputOf<vtkImageData>(inputVector[TerrainPort], "Terrain");
  littoral::Require(terrain ? "" : "there is no terrain; connect one to Terrain.");
  auto* table = littoral::OptionalInputOf<vtkTable>(inputVector[PreferencesPort], "Preferences");
  const bool knowsDrainage = terrain->GetPointData()->HasArray("DrainageArea");
  const Species species =
    table ? littoral::ReadPreferences(littoral::TextsOf(table)) : littoral::DefaultPreferences(knowsDrainage);
  const littoral::SiteGround ground = GroundOf(terrain, species);
  littoral::RequireLengths(sites, "Sites", littoral::FarForPoints);
  const Sites arrays(sites);
  const auto count = static_cast<double>(sites->GetNumberOfPoints());
  const double ofArrays = 1024.0 * static_cast<double>(sites->GetPointData()->GetActualMemorySize());
  littoral::RequireMemory((2.0 * sizeof(KeptSite) + BytesOfSite) * count + ofArrays,
    "the choice of " + littoral::TextOf(count) + " sites", "take fewer");
  const littoral::Poll poll = littoral::PollOf(this);
  littoral::SteppedPoll steps(poll);
  std::vector<KeptSite> kept;
  vtkInformation* output = outputVector->GetInformationObject(0);
  const littoral::PieceRange part = littoral::RequestedPart(output, sites->GetNumberOfPoints());
  for (long long site = part.Begin; site < part.End; ++site)
  {
    steps.Step();
    KeptSite own{};
    if (arrays.Keeps(site, species, ground, { this->Thinning, this->Seed }, own))
    {
      kept.push_back(own);
    }
  }
  vtkPolyData* result = vtkPolyData::GetData(output);
  Write(kept, sites, ground.HasWetness(), poll, result);
  vtkNew<vtkStringArray> names;
  names->SetName("SpeciesNames");
  for (const littoral::SpeciesPreference& each : species)
  {
    names->InsertNextValue(each.Name);
  }
  result->GetFieldData()->AddArray(names);
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
int vtkSitePreferenceFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(this, request, outputs,
    "Cannot let the terrain decide: ", [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkSitePreferenceFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Thinning: " << this->Thinning << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
