// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Stands from tables, and sites that the terrain decides: arrays, parts, bad input.
#include "Check.h"
#include "ErrorCounter.h"
#include "vtkSitePreferenceFilter.h"
#include "vtkStandInventoryFilter.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

void AddWords(vtkTable* table, const char* name, const std::vector<const char*>& words)
{
  vtkNew<vtkStringArray> column;
  column->SetName(name);
  for (const char* word : words)
  {
    column->InsertNextValue(word);
  }
  table->AddColumn(column);
}

void AddNumbers(vtkTable* table, const char* name, std::initializer_list<double> numbers)
{
  vtkNew<vtkDoubleArray> column;
  column->SetName(name);
  for (const double number : numbers)
  {
    column->InsertNextValue(number);
  }
  table->AddColumn(column);
}

vtkDataArray* Of(vtkPolyData* data, const char* name)
{
  return data->GetPointData()->GetArray(name);
}

/// Three oaks, a pine and a tree of an unknown species; numbers as VTK's reader of text finds them.
void FillInventory(vtkTable* table)
{
  AddNumbers(table, "gx", { 1.0, 8.0, 15.0, 22.0, 29.0 });
  AddNumbers(table, "gy", { 5.0, 9.0, 5.0, 9.0, 4e6 / 4e5 });
  AddWords(table, "sp", { "Quercus alba", "oak", "Pinus taeda", "white oak", "ZZZ" });
  AddNumbers(table, "dbh", { 250.0, NaN, 312.5, 80.0, 120.0 });
  AddWords(table, "status", { "A", "A", "A", "A", "alive" });
}

bool Inventory()
{
  vtkNew<vtkTable> table;
  FillInventory(table);
  vtkNew<vtkStandInventoryFilter> stand;
  stand->SetInputData(0, table);
  stand->Update();
  vtkPolyData* trees = stand->GetOutput();
  bool good = Check(trees->GetNumberOfPoints() == 5 && trees->GetNumberOfVerts() == 5, "five trees");
  good &= Check(std::abs(Of(trees, "DBH")->GetTuple1(2) - 0.3125) < 1e-15, "millimetres of ForestGEO");
  good &=
    Check(Of(trees, "Imputed")->GetTuple1(0) == 2.0 && Of(trees, "Imputed")->GetTuple1(1) == 3.0, "what is drawn");
  for (const char* name : { "SiteId", "Species", "DBH", "Height", "CrownDiameter", "Plot", "Imputed" })
  {
    for (vtkIdType tree = 0; tree < 5; ++tree)
    {
      good &= Check(std::isfinite(Of(trees, name)->GetTuple1(tree)), name);
    }
  }
  auto* kinds = vtkStringArray::SafeDownCast(trees->GetFieldData()->GetAbstractArray("Kinds"));
  good &= Check(kinds && kinds->GetNumberOfValues() == 2 && kinds->GetValue(0) == "Pine" && kinds->GetValue(1) == "Oak",
    "kinds in the order of the table");
  good &= Check(Of(trees, "Species")->GetTuple1(2) == 0.0 && Of(trees, "Species")->GetTuple1(4) == 1.0, "species");
  auto* unlisted = vtkStringArray::SafeDownCast(trees->GetFieldData()->GetAbstractArray("Unlisted"));
  good &= Check(unlisted && unlisted->GetNumberOfValues() == 1 && unlisted->GetValue(0) == "ZZZ", "unlisted species");
  // A plant for each of the three oaks and the one of an unknown species that are not about as thick.
  stand->SetDiameterClasses(3);
  stand->Update();
  kinds = vtkStringArray::SafeDownCast(trees->GetFieldData()->GetAbstractArray("Kinds"));
  good &= Check(kinds && kinds->GetNumberOfValues() == 4 && kinds->GetValue(1) == "Oak" && kinds->GetValue(3) == "Oak",
    "three sizes of oaks");
  double thickest = 0.0;
  for (vtkIdType plant = 1; plant < 4; ++plant)
  {
    const double thick = trees->GetFieldData()->GetArray("PlantDBH")->GetTuple1(plant);
    good &= Check(thick > thickest && trees->GetFieldData()->GetArray("PlantHeight")->GetTuple1(plant) > 2.0 &&
        trees->GetFieldData()->GetArray("PlantCrownDiameter")->GetTuple1(plant) > 0.5,
      "sizes of plants");
    thickest = thick;
  }
  good &= Check(Of(trees, "Species")->GetTuple1(3) == 1.0, "the thinnest oak");
  stand->SetDiameterClasses(1);
  // Another table of species, and an older one again.
  vtkNew<vtkTable> species;
  AddWords(species, "species", { "ZZZ;Quercus", "pinus" });
  AddWords(species, "kind", { "Birch", "Fern" });
  stand->SetInputData(1, species);
  stand->SetDefaultSpecies("pinus");
  stand->Update();
  kinds = vtkStringArray::SafeDownCast(stand->GetOutput()->GetFieldData()->GetAbstractArray("Kinds"));
  good &= Check(kinds && kinds->GetValue(0) == "Birch" && kinds->GetValue(1) == "Fern", "kinds of another table");
  return good;
}

/// Columns that are not used and codes for missing values are told, once.
bool Remarks()
{
  vtkNew<vtkTable> table;
  FillInventory(table);
  vtkNew<vtkStandInventoryFilter> stand;
  stand->SetInputData(0, table);
  vtkNew<ErrorCounter> messages;
  messages->Watch(stand);
  messages->WatchWarnings();
  stand->Update();
  bool good = Check(messages->Warnings == 0, "a remark on a table that is used as it is");
  table->SetValueByName(3, "dbh", -999.0);
  AddNumbers(table, "agb", { 1.0, 2.0, 3.0, 4.0, 5.0 });
  table->Modified();
  stand->Update();
  stand->UpdatePiece(1, 2, 0);
  const char* const words = "Taken as missing: dbh -999. Columns not used: agb.";
  good &= Check(messages->Warnings == 1 && messages->LastWarning.find(words) != std::string::npos, words);
  for (const char* name : { "UnusedColumns", "MissingCodes" })
  {
    auto* names = vtkStringArray::SafeDownCast(stand->GetOutput()->GetFieldData()->GetAbstractArray(name));
    good &= Check(names && names->GetNumberOfValues() == 1, name);
  }
  stand->UpdatePiece(0, 1, 0);
  return good & Check(Of(stand->GetOutput(), "Imputed")->GetTuple1(3) == 3.0, "a code is no diameter");
}

/// Parts of a stand are the stand.
bool Pieces()
{
  vtkNew<vtkTable> table;
  FillInventory(table);
  vtkNew<vtkStandInventoryFilter> whole;
  whole->SetInputData(0, table);
  whole->Update();
  vtkIdType next = 0;
  bool good = true;
  for (int piece = 0; piece < 3; ++piece)
  {
    vtkNew<vtkStandInventoryFilter> part;
    part->SetInputData(0, table);
    part->UpdatePiece(piece, 3, 0);
    for (vtkIdType tree = 0; tree < part->GetOutput()->GetNumberOfPoints(); ++tree, ++next)
    {
      for (const char* name : { "SiteId", "DBH", "Height" })
      {
        good &=
          Check(Of(part->GetOutput(), name)->GetTuple1(tree) == Of(whole->GetOutput(), name)->GetTuple1(next), name);
      }
    }
  }
  return good & Check(next == 5, "all trees in parts");
}

bool BadInventories()
{
  const auto fails = [](const char* words, const std::function<void(vtkStandInventoryFilter*, vtkTable*)>& spoil) {
    vtkNew<vtkTable> table;
    FillInventory(table);
    vtkNew<vtkStandInventoryFilter> stand;
    stand->SetInputData(0, table);
    spoil(stand, table);
    vtkNew<ErrorCounter> errors;
    errors->Watch(stand);
    return Check(errors->ExpectOneNaming(words) && errors->ExpectOneNaming(words), words);
  };
  using Stand = vtkStandInventoryFilter;
  bool good = fails("no columns x and y", [](Stand*, vtkTable* t) { t->RemoveColumnByName("gx"); });
  good &= fails("no column 'Dicke'", [](Stand* s, vtkTable*) { s->SetDiameterColumn("Dicke"); });
  good &= fails("set DiameterUnit", [](Stand* s, vtkTable*) { s->SetDiameterUnit(Stand::Metre); });
  good &= fails("DiameterUnit is 9", [](Stand* s, vtkTable*) { s->SetDiameterUnit(9); });
  good &= fails("stand at the same place", [](Stand*, vtkTable* t) {
    t->SetValueByName(1, "gx", 1.0);
    t->SetValueByName(1, "gy", 5.0);
  });
  good &= fails("is a living tree of the plot 'C'", [](Stand* s, vtkTable*) { s->SetPlot("C"); });
  good &= fails("HeightVariation", [](Stand* s, vtkTable*) { s->SetHeightVariation(NaN); });
  good &= fails("DefaultSpecies", [](Stand* s, vtkTable*) { s->SetDefaultSpecies(nullptr); });
  good &= fails("needs the columns species and kind", [](Stand* s, vtkTable*) {
    vtkNew<vtkTable> empty;
    s->SetInputData(1, empty);
  });
  good &= fails("QuadraticMeanDiameter", [](Stand* s, vtkTable*) { s->SetQuadraticMeanDiameter(9.0); });
  good &= fails("DiameterClasses", [](Stand* s, vtkTable*) { s->SetDiameterClasses(0); });
  return good;
}

/// Sites in rows along a slope that rises from 0 to 90 m along y.
struct Slope
{
  vtkNew<vtkPolyData> Sites;
  vtkNew<vtkImageData> Terrain;
  vtkNew<vtkTable> Preferences;
  vtkNew<vtkSitePreferenceFilter> Filter;

  Slope()
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkDoubleArray> tags;
    tags->SetName("Tag");
    for (int site = 0; site < 10000; ++site)
    {
      points->InsertNextPoint(site % 100, 0.99 * (site / 100), -7.0);
      tags->InsertNextValue(3.0 * site);
    }
    this->Sites->SetPoints(points);
    this->Sites->GetPointData()->AddArray(tags);
    this->Terrain->SetDimensions(11, 11, 1);
    this->Terrain->SetSpacing(10.0, 10.0, 1.0);
    vtkNew<vtkDoubleArray> heights;
    heights->SetName("Elevation");
    for (int point = 0; point < 121; ++point)
    {
      heights->InsertNextValue(9.0 * (point / 11));
    }
    this->Terrain->GetPointData()->SetScalars(heights);
    AddWords(this->Preferences, "species", { "low", "high" });
    AddNumbers(this->Preferences, "elevation", { 20.0, 70.0 });
    AddNumbers(this->Preferences, "elevation_tolerance", { 15.0, 15.0 });
    this->Filter->SetInputData(0, this->Sites);
    this->Filter->SetInputData(1, this->Terrain);
    this->Filter->SetInputData(2, this->Preferences);
  }

  void AddDrainage(double area)
  {
    vtkNew<vtkDoubleArray> drainage;
    drainage->SetName("DrainageArea");
    drainage->SetNumberOfTuples(121);
    drainage->FillComponent(0, area);
    this->Terrain->GetPointData()->AddArray(drainage);
  }
};

bool Preferences()
{
  Slope slope;
  slope.AddDrainage(300.0);
  slope.Filter->Update();
  bool good = Check(slope.Filter->GetOutput()->GetNumberOfPoints() == 10000, "all sites stay by default");
  slope.Filter->ThinningOn();
  slope.Filter->Update();
  vtkPolyData* kept = slope.Filter->GetOutput();
  const vtkIdType count = kept->GetNumberOfPoints();
  good &= Check(count > 2000 && count < 6000 && kept->GetNumberOfVerts() == count, "sites are thinned");
  double mean[2] = { 0.0, 0.0 };
  double number[2] = { 0.0, 0.0 };
  for (vtkIdType site = 0; site < count; ++site)
  {
    double place[3];
    kept->GetPoint(site, place);
    const auto species = static_cast<int>(Of(kept, "Species")->GetTuple1(site));
    mean[species] += place[2];
    number[species] += 1.0;
    good = good && std::abs(place[2] - 0.9 * place[1]) < 1e-4 &&
      std::abs(Of(kept, "Elevation")->GetTuple1(site) - place[2]) < 1e-9;
    good = good && Of(kept, "Tag")->GetTuple1(site) == 3.0 * Of(kept, "SiteId")->GetTuple1(site);
    good = good && std::abs(Of(kept, "Aspect")->GetTuple1(site) - 180.0) < 1e-6;
    good = good && std::abs(std::tan(Of(kept, "Slope")->GetTuple1(site) * std::acos(-1.0) / 180.0) - 0.9) < 1e-6;
    good = good && std::abs(Of(kept, "Wetness")->GetTuple1(site) - std::log(300.0 / 10.0 / 0.9)) < 1e-6;
  }
  good = Check(good, "arrays of the ground");
  // Of normal laws of 15 m about 20 and 70 m, cut at 0 and 89.2 m.
  good &= Check(std::abs(mean[0] / number[0] - 22.71) < 1.0 && std::abs(mean[1] / number[1] - 67.04) < 1.0,
    "mean heights " + std::to_string(mean[0] / number[0]) + " and " + std::to_string(mean[1] / number[1]));
  // A part has the same sites.
  vtkIdType next = 0;
  for (int piece = 0; piece < 4; ++piece)
  {
    slope.Filter->UpdatePiece(piece, 4, 0);
    next += slope.Filter->GetOutput()->GetNumberOfPoints();
  }
  good &= Check(next == count, "sites in parts");
  return good;
}

/// Sites with a species keep it; without thinning all stay, and without a table there are four species.
bool SpeciesOfSites()
{
  Slope slope;
  slope.AddDrainage(300.0);
  slope.Filter->ThinningOn();
  vtkNew<vtkIntArray> species;
  species->SetName("Species");
  species->SetNumberOfTuples(10000);
  species->FillComponent(0, 1);
  slope.Sites->GetPointData()->AddArray(species);
  slope.Filter->Update();
  double range[2];
  Of(slope.Filter->GetOutput(), "Species")->GetRange(range);
  bool good = Check(range[0] == 1.0 && slope.Filter->GetOutput()->GetNumberOfPoints() > 1000, "a species of its own");
  slope.Filter->ThinningOff();
  slope.Filter->Update();
  good &= Check(slope.Filter->GetOutput()->GetNumberOfPoints() == 10000, "all sites");
  // Without a table there are four species.
  slope.Sites->GetPointData()->RemoveArray("Species");
  slope.Filter->RemovePreferences();
  slope.Filter->Update();
  Of(slope.Filter->GetOutput(), "Species")->GetRange(range);
  good &= Check(range[0] == 0.0 && range[1] == 3.0, "the usual species");
  return good;
}

/// On gentle ground as wet as birches like it there are more of them than on dry ground.
bool BirchesOnWetGround()
{
  Slope slope;
  slope.Filter->RemovePreferences();
  vtkDataArray* heights = slope.Terrain->GetPointData()->GetScalars();
  for (vtkIdType point = 0; point < heights->GetNumberOfTuples(); ++point)
  {
    heights->SetTuple1(point, 0.1 * heights->GetTuple1(point));
  }
  heights->Modified();
  const auto birches = [&](double area) {
    slope.AddDrainage(area);
    slope.Filter->Update();
    vtkPolyData* sites = slope.Filter->GetOutput();
    long long found = 0;
    for (vtkIdType site = 0; site < sites->GetNumberOfPoints(); ++site)
    {
      double color[3];
      Of(sites, "RGB")->GetTuple(site, color);
      const bool isBirch = Of(sites, "Species")->GetTuple1(site) == 2.0;
      found += isBirch && color[0] == 146.0 && color[1] == 190.0;
    }
    return found;
  };
  const long long dry = birches(10.0 * 0.09 * std::exp(5.0));
  const long long wet = birches(10.0 * 0.09 * std::exp(9.0));
  return Check(wet > 2 * dry && dry > 0, std::to_string(dry) + " and " + std::to_string(wet) + " birches");
}

bool BadPreferences()
{
  const auto fails = [](const char* words, const std::function<void(Slope&)>& spoil) {
    Slope slope;
    spoil(slope);
    vtkNew<ErrorCounter> errors;
    errors->Watch(slope.Filter);
    return Check(errors->ExpectOneNaming(words) && errors->ExpectOneNaming(words), words);
  };
  const auto wetness = [](Slope& s) {
    AddNumbers(s.Preferences, "wetness", { 5.0, NaN });
    AddNumbers(s.Preferences, "wetness_tolerance", { 1.0, NaN });
  };
  bool good = fails("no point array DrainageArea", wetness);
  good &= fails("site 0 at (0, 0) lies outside", [&](Slope& s) {
    wetness(s);
    s.AddDrainage(0.0);
  });
  good &=
    fails("site 17 at (170, 3) lies outside", [](Slope& s) { s.Sites->GetPoints()->SetPoint(17, 170.0, 3.0, 0.0); });
  good &= fails("needs the column species", [](Slope& s) { s.Preferences->RemoveColumnByName("species"); });
  good &= fails(
    "elevation_tolerance of low is nan", [](Slope& s) { s.Preferences->RemoveColumnByName("elevation_tolerance"); });
  good &= fails("Species of site 2 is 5", [](Slope& s) {
    vtkNew<vtkIntArray> species;
    species->SetName("Species");
    species->SetNumberOfTuples(10000);
    species->FillComponent(0, 1);
    species->SetValue(2, 5);
    s.Sites->GetPointData()->AddArray(species);
  });
  good &= fails("there is no terrain", [](Slope& s) { s.Filter->RemoveAllInputConnections(1); });
  good &= fails("spacing of the Terrain", [](Slope& s) { s.Terrain->SetSpacing(10.0, 0.0, 1.0); });
  return good;
}

}

int TestStandFilters(int, char*[])
{
  bool good = Inventory();
  good &= Remarks();
  good &= Pieces();
  good &= BadInventories();
  good &= Preferences();
  good &= SpeciesOfSites();
  good &= BirchesOnWetGround();
  good &= BadPreferences();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
