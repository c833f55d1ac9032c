// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkStandInventoryFilter.h"

#include "Data/Arrays.h"
#include "Data/Inputs.h"
#include "Data/TableTexts.h"
#include "Data/Tables.h"
#include "Pipeline/Mistakes.h"
#include "Pipeline/Pipeline.h"
#include "Plants/InventoryPlants.h"
#include "Plants/StandInventory.h"

#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkStandInventoryFilter);

namespace
{

constexpr int InventoryPort = 0;
constexpr int SpeciesPort = 1;

/// Memory of a row: its texts, the tree of it and its values [bytes].
constexpr double BytesOfTree = 1000.0;

std::string Word(const char* word)
{
  return word ? word : "";
}

/// Words as an array.
vtkSmartPointer<vtkStringArray> WordsOf(const char* name, const std::vector<std::string>& words)
{
  auto array = vtkSmartPointer<vtkStringArray>::New();
  array->SetName(name);
  for (const std::string& word : words)
  {
    array->InsertNextValue(word);
  }
  return array;
}

/// Some words in a row, and how many more there are.
std::string Joined(const std::vector<std::string>& words)
{
  constexpr std::size_t most = 12;
  std::string all;
  for (std::size_t word = 0; word < std::min(most, words.size()); ++word)
  {
    all += (all.empty() ? "" : ", ") + words[word];
  }
  return words.size() > most ? all + " and " + std::to_string(words.size() - most) + " more" : all;
}

/// Remarks on a table for its user; empty if all of it is read as it is.
std::string RemarksOn(const littoral::StandInventory& stand)
{
  const std::string codes = stand.MissingCodes.empty() ? "" : "Taken as missing: " + Joined(stand.MissingCodes) + ".";
  const std::string unread = stand.Unread.empty() ? "" : "Columns not used: " + Joined(stand.Unread) + ".";
  return codes + (codes.empty() || unread.empty() ? "" : " ") + unread;
}

/// Adds plants as field data.
void AddPlants(const std::vector<littoral::InventoryPlant>& plants, vtkPolyData* sites)
{
  std::vector<std::string> kinds;
  vtkNew<vtkDoubleArray> sizes[3];
  const char* const names[] = { "PlantDBH", "PlantHeight", "PlantCrownDiameter" };
  for (const littoral::InventoryPlant& plant : plants)
  {
    kinds.push_back(plant.Kind);
    sizes[0]->InsertNextValue(plant.Diameter);
    sizes[1]->InsertNextValue(plant.Height);
    sizes[2]->InsertNextValue(plant.CrownDiameter);
  }
  sites->GetFieldData()->AddArray(WordsOf("Kinds", kinds));
  for (int size = 0; size < 3; ++size)
  {
    sizes[size]->SetName(names[size]);
    sites->GetFieldData()->AddArray(sizes[size]);
  }
}

/// The trees of a part of a stand as vertices with arrays.
class Writer
{
public:
  Writer(const std::vector<littoral::StandTree>& trees, const littoral::PieceRange& part, vtkPolyData* output)
    : Trees(trees)
    , First(static_cast<std::size_t>(part.Begin))
    , Count(static_cast<std::size_t>(part.End - part.Begin))
    , Output(output)
  {
  }

  void WriteVertices()
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> vertices;
    for (std::size_t index = 0; index < this->Count; ++index)
    {
      const littoral::StandTree& tree = this->Trees[this->First + index];
      const vtkIdType point = points->InsertNextPoint(tree.X, tree.Y, 0.0);
      vertices->InsertNextCell(1, &point);
    }
    this->Output->SetPoints(points);
    this->Output->SetVerts(vertices);
  }

  /// An array of the value of each tree, by its number in the stand.
  template <typename Array, typename ValueOf>
  void Write(const char* name, const ValueOf& valueOf)
  {
    vtkNew<Array> array;
    array->SetName(name);
    for (std::size_t index = 0; index < this->Count; ++index)
    {
      array->InsertNextValue(valueOf(this->First + index));
    }
    this->Output->GetPointData()->AddArray(array);
  }

private:
  const std::vector<littoral::StandTree>& Trees;
  std::size_t First;
  std::size_t Count;
  vtkPolyData* Output;
};

}

//----------------------------------------------------------------------------
vtkStandInventoryFilter::vtkStandInventoryFilter()
  : CoordinateUnit(Named)
  , DiameterUnit(Named)
  , HeightUnit(Named)
  , CoordinateScale(1.0)
  , XColumn(nullptr)
  , YColumn(nullptr)
  , SpeciesColumn(nullptr)
  , DiameterColumn(nullptr)
  , HeightColumn(nullptr)
  , PlotColumn(nullptr)
  , Plot(nullptr)
  , DefaultSpecies(nullptr)
  , KeepDead(false)
  , AllowCoincident(false)
  , AllowImplausible(false)
  , QuadraticMeanDiameter(0.0)
  , HeightVariation(0.1)
  , DiameterClasses(1)
  , Seed(1)
{
  this->SetDefaultSpecies("hardwood");
  this->SetNumberOfInputPorts(2);
}

//----------------------------------------------------------------------------
vtkStandInventoryFilter::~vtkStandInventoryFilter()
{
  this->SetXColumn(nullptr);
  this->SetYColumn(nullptr);
  this->SetSpeciesColumn(nullptr);
  this->SetDiameterColumn(nullptr);
  this->SetHeightColumn(nullptr);
  this->SetPlotColumn(nullptr);
  this->SetPlot(nullptr);
  this->SetDefaultSpecies(nullptr);
}

//----------------------------------------------------------------------------
int vtkStandInventoryFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  if (port == SpeciesPort)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkStandInventoryFilter::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//----------------------------------------------------------------------------
int vtkStandInventoryFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (int port : { InventoryPort, SpeciesPort })
  {
    for (int index = 0; index < inputVector[port]->GetNumberOfInformationObjects(); ++index)
    {
      littoral::RequestAll(inputVector[port]->GetInformationObject(index));
    }
  }
  return 1;
}

//----------------------------------------------------------------------------
littoral::InventoryOptions vtkStandInventoryFilter::Options() const
{
  littoral::InventoryOptions options;
  options.Columns = { Word(this->XColumn), Word(this->YColumn), Word(this->SpeciesColumn), Word(this->DiameterColumn),
    Word(this->HeightColumn), Word(this->PlotColumn) };
  options.CoordinateUnit = static_cast<littoral::LengthUnit>(this->CoordinateUnit);
  options.DiameterUnit = static_cast<littoral::LengthUnit>(this->DiameterUnit);
  options.HeightUnit = static_cast<littoral::LengthUnit>(this->HeightUnit);
  options.CoordinateScale = this->CoordinateScale;
  options.Plot = Word(this->Plot);
  options.DefaultSpecies = Word(this->DefaultSpecies);
  options.KeepDead = this->KeepDead;
  options.AllowCoincident = this->AllowCoincident;
  options.AllowImplausible = this->AllowImplausible;
  options.QuadraticMeanDiameter = this->QuadraticMeanDiameter;
  options.HeightVariation = this->HeightVariation;
  options.Seed = this->Seed;
  options.DiameterClasses = this->DiameterClasses;
  return options;
}

//----------------------------------------------------------------------------
int vtkStandInventoryFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* inventory = littoral::InputOf<vtkTable>(inputVector[InventoryPort], "Inventory");
  auto* rows = littoral::OptionalInputOf<vtkTable>(inputVector[SpeciesPort], "Species");
  const littoral::StandSpeciesTable species =
    rows ? littoral::StandSpeciesTable(littoral::TextsOf(rows)) : littoral::StandSpeciesTable();
  const littoral::InventoryOptions options = this->Options();
  littoral::RequireMemory(BytesOfTree * static_cast<double>(inventory->GetNumberOfRows()), "the inventory", "take fewer rows");
  this->SetProgressText("Reading trees");
  const littoral::TextTable texts = littoral::TextsOf(inventory);
  this->UpdateProgress(0.3);
  littoral::StandInventory stand = littoral::ReadInventory(texts, species, options);
  this->UpdateProgress(0.6);
  littoral::CompleteStand(species, options, stand);
  const littoral::InventoryPlants plants = littoral::PlantsOfInventory(species, stand, options.DiameterClasses);
  vtkInformation* output = outputVector->GetInformationObject(0);
  vtkPolyData* sites = vtkPolyData::GetData(output);
  const std::vector<littoral::StandTree>& trees = stand.Trees;
  Writer writer(trees, littoral::RequestedPart(output, static_cast<vtkIdType>(trees.size())), sites);
  writer.WriteVertices();
  writer.Write<vtkTypeInt64Array>("SiteId", [&](std::size_t tree) { return trees[tree].Row; });
  writer.Write<vtkIntArray>("Species", [&](std::size_t tree) { return plants.OfTree[tree]; });
  writer.Write<vtkDoubleArray>("DBH", [&](std::size_t tree) { return trees[tree].Diameter; });
  writer.Write<vtkDoubleArray>("Height", [&](std::size_t tree) { return trees[tree].Height; });
  writer.Write<vtkDoubleArray>("CrownDiameter",
    [&](std::size_t tree) { return littoral::CrownDiameterOf(trees[tree].Diameter, trees[tree].Height); });
  writer.Write<vtkIntArray>("Plot", [&](std::size_t tree) { return trees[tree].Plot; });
  writer.Write<vtkIntArray>("Imputed",
    [&](std::size_t tree) { return (trees[tree].ImputedDiameter ? 1 : 0) + (trees[tree].ImputedHeight ? 2 : 0); });
  writer.Write<vtkStringArray>("SpeciesName", [&](std::size_t tree) { return trees[tree].Name; });
  AddPlants(plants.Plants, sites);
  sites->GetFieldData()->AddArray(WordsOf("Plots", stand.Plots));
  sites->GetFieldData()->AddArray(WordsOf("Unlisted", stand.Unlisted));
  sites->GetFieldData()->AddArray(WordsOf("UnusedColumns", stand.Unread));
  sites->GetFieldData()->AddArray(WordsOf("MissingCodes", stand.MissingCodes));
  littoral::AddField(sites, "RowsDropped", { static_cast<double>(stand.Dropped) });
  littoral::AddField(sites, "Area", { littoral::AreaOf(stand) });
  if (const std::string remarks = RemarksOn(stand); !remarks.empty())
  {
    littoralWarningMacro(<< remarks);
  }
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
int vtkStandInventoryFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(this, request, outputs,
    "Cannot read the inventory: ", [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkStandInventoryFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CoordinateUnit: " << this->CoordinateUnit << "\n";
  os << indent << "DiameterUnit: " << this->DiameterUnit << "\n";
  os << indent << "HeightUnit: " << this->HeightUnit << "\n";
  os << indent << "CoordinateScale: " << this->CoordinateScale << "\n";
  os << indent << "XColumn: " << Word(this->XColumn) << "\n";
  os << indent << "YColumn: " << Word(this->YColumn) << "\n";
  os << indent << "SpeciesColumn: " << Word(this->SpeciesColumn) << "\n";
  os << indent << "DiameterColumn: " << Word(this->DiameterColumn) << "\n";
  os << indent << "HeightColumn: " << Word(this->HeightColumn) << "\n";
  os << indent << "PlotColumn: " << Word(this->PlotColumn) << "\n";
  os << indent << "Plot: " << Word(this->Plot) << "\n";
  os << indent << "DefaultSpecies: " << Word(this->DefaultSpecies) << "\n";
  os << indent << "KeepDead: " << this->KeepDead << "\n";
  os << indent << "AllowCoincident: " << this->AllowCoincident << "\n";
  os << indent << "AllowImplausible: " << this->AllowImplausible << "\n";
  os << indent << "QuadraticMeanDiameter: " << this->QuadraticMeanDiameter << "\n";
  os << indent << "HeightVariation: " << this->HeightVariation << "\n";
  os << indent << "DiameterClasses: " << this->DiameterClasses << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
