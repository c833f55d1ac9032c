// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Trees of an inventory: heights and girths of scattered plants, measured on their polygons.
#include "Check.h"
#include "ErrorCounter.h"
#include "PlantScene.h"
#include "vtkAonoKuniiTreeSource.h"
#include "vtkGardnerPlantSource.h"
#include "vtkPlantScatterFilter.h"
#include "vtkReevesTreeSource.h"

#include "vtkCellArray.h"
#include "vtkCleanPolyData.h"
#include "vtkCutter.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkPoints.h"
#include "vtkStripper.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// Height and diameter at breast height [m], from saplings to the tallest of their kinds.
constexpr std::array<std::array<double, 2>, 4> Sizes{ { { 1.6, 0.012 }, { 6.0, 0.05 }, { 18.1, 0.656 },
  { 44.0, 2.1 } } };

//----------------------------------------------------------------------------
/// Plants of several kinds, which all stands share.
struct Kinds
{
  vtkNew<vtkReevesTreeSource> Pine;
  vtkNew<vtkReevesTreeSource> Oak;
  vtkNew<vtkReevesTreeSource> Birch;
  vtkNew<vtkAonoKuniiTreeSource> Forked;
  vtkNew<vtkGardnerPlantSource> Tufts;

  Kinds()
  {
    this->Pine->SetPresetToPine();
    this->Birch->SetPresetToBirch();
    for (vtkPlantSource* plant : std::initializer_list<vtkPlantSource*>{ Pine, Oak, Birch, Forked, Tufts })
    {
      plant->SetTextureSize(32, 16); // small pictures cost less
    }
  }
};

//----------------------------------------------------------------------------
/// A row of trees of several kinds, one of each size and kind.
struct Stand
{
  vtkNew<vtkPolyData> Sites;
  vtkNew<vtkPoints> Feet;
  vtkNew<vtkDoubleArray> Heights;
  vtkNew<vtkDoubleArray> Diameters;
  vtkNew<vtkIntArray> Species;
  vtkNew<vtkPlantScatterFilter> Filter;

  explicit Stand(Kinds& kinds)
  {
    this->Heights->SetName("Height");
    this->Diameters->SetName("DBH");
    this->Species->SetName("Species");
    vtkPlantSource* const plants[] = { kinds.Pine, kinds.Oak, kinds.Birch, kinds.Forked, kinds.Tufts };
    int species = 0;
    for (vtkPlantSource* plant : plants)
    {
      for (const auto& [height, diameter] : Sizes)
      {
        const auto site = static_cast<double>(this->Feet->GetNumberOfPoints());
        this->Feet->InsertNextPoint(0.5 * site, 3.0, 0.25 * site);
        this->Heights->InsertNextValue(height);
        this->Diameters->InsertNextValue(diameter);
        this->Species->InsertNextValue(species);
      }
      ++species;
      this->Filter->AddPrototypeConnection(plant->GetOutputPort());
    }
    this->Sites->SetPoints(this->Feet);
    this->Sites->GetPointData()->AddArray(this->Species);
    this->Filter->SetInputData(0, this->Sites);
    this->Filter->UseLevelsOff();
    this->Filter->UseCullingOff();
  }

  void Add(vtkDataArray* array) { this->Sites->GetPointData()->AddArray(array); }
  vtkPolyData* Part(const char* path)
  {
    return vtkPolyData::SafeDownCast(BlockAt(this->Filter->GetOutputDataObject(0), path));
  }

  /// The highest points of the plants above their feet [m].
  std::vector<double> Tops(const char* bark = "High/Skin", const char* leaves = "High/Leaves")
  {
    std::vector<double> tops(static_cast<std::size_t>(this->Feet->GetNumberOfPoints()), 0.0);
    for (const char* path : { bark, leaves })
    {
      vtkPolyData* part = this->Part(path);
      vtkDataArray* plants = part->GetPointData()->GetArray("PlantId");
      for (vtkIdType point = 0; point < part->GetNumberOfPoints(); ++point)
      {
        const auto plant = static_cast<vtkIdType>(plants->GetTuple1(point));
        const double height = part->GetPoint(point)[2] - this->Feet->GetPoint(plant)[2];
        tops[plant] = std::max(tops[plant], height);
      }
    }
    return tops;
  }

  /// The length of the cut of the stem by a level plane, over pi [m].
  double Diameter(vtkIdType plant, double height, const char* path = "High/Skin")
  {
    vtkPolyData* skin = this->Part(path);
    vtkDataArray* plants = skin->GetPointData()->GetArray("PlantId");
    const double cutAt = this->Feet->GetPoint(plant)[2] + height;
    vtkNew<vtkPolyData> own; // what the plane cuts
    vtkNew<vtkPoints> points;
    points->SetDataType(skin->GetPoints()->GetDataType());
    vtkNew<vtkCellArray> triangles;
    std::map<vtkIdType, vtkIdType> places; // in `points`
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    for (vtkIdType cell = 0; cell < skin->GetNumberOfCells(); ++cell)
    {
      skin->GetCellPoints(cell, size, corners);
      if (static_cast<vtkIdType>(plants->GetTuple1(corners[0])) != plant)
      {
        continue;
      }
      const auto isBelow = [&](vtkIdType corner) { return skin->GetPoint(corner)[2] <= cutAt; };
      const auto isAbove = [&](vtkIdType corner) { return skin->GetPoint(corner)[2] >= cutAt; };
      if (std::any_of(corners, corners + size, isBelow) && std::any_of(corners, corners + size, isAbove))
      {
        triangles->InsertNextCell(static_cast<int>(size));
        for (vtkIdType corner = 0; corner < size; ++corner)
        {
          const auto [place, isNew] = places.try_emplace(corners[corner], points->GetNumberOfPoints());
          if (isNew)
          {
            points->InsertNextPoint(skin->GetPoint(corners[corner]));
          }
          triangles->InsertCellPoint(place->second);
        }
      }
    }
    own->SetPoints(points);
    own->SetPolys(triangles);
    vtkNew<vtkPlane> level;
    level->SetOrigin(0.0, 0.0, cutAt);
    level->SetNormal(0.0, 0.0, 1.0);
    vtkNew<vtkCutter> cut;
    cut->SetInputData(own);
    cut->SetCutFunction(level);
    vtkNew<vtkCleanPolyData> joined;
    joined->SetInputConnection(cut->GetOutputPort());
    joined->ToleranceIsAbsoluteOn();
    joined->SetAbsoluteTolerance(2e-5);
    vtkNew<vtkStripper> loops;
    loops->SetInputConnection(joined->GetOutputPort());
    loops->SetMaximumLength(100000);
    loops->Update();
    std::vector<std::array<double, 3>> sections; // length, and the place of the middle
    vtkPolyData* lines = loops->GetOutput();
    for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
    {
      lines->GetLines()->GetCellAtId(line, size, corners);
      double length = 0.0;
      double middle[2] = { 0.0, 0.0 };
      for (vtkIdType corner = 1; corner < size; ++corner)
      {
        double a[3];
        double b[3];
        lines->GetPoint(corners[corner - 1], a);
        lines->GetPoint(corners[corner], b);
        length += std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
        middle[0] += a[0] / static_cast<double>(size - 1);
        middle[1] += a[1] / static_cast<double>(size - 1);
      }
      sections.push_back({ length, middle[0], middle[1] });
    }
    // The stem's is the longest around the section that is nearest to the axis, as of a branch that begins in it.
    const double* foot = this->Feet->GetPoint(plant);
    const auto away = [foot](const auto& section) { return std::hypot(section[1] - foot[0], section[2] - foot[1]); };
    const auto nearest = *std::min_element(
      sections.begin(), sections.end(), [&](const auto& a, const auto& b) { return away(a) < away(b); });
    double girth = 0.0;
    for (const auto& [length, x, y] : sections)
    {
      const bool isAround = std::hypot(x - nearest[1], y - nearest[2]) <= 0.5 * length / vtkMath::Pi();
      girth = isAround ? std::max(girth, length) : girth;
    }
    return girth / vtkMath::Pi();
  }
};

/// Where a stem is measured [m].
double MeasuredAt(double height)
{
  return height < 2.6 ? 0.5 * height : 1.3;
}

//----------------------------------------------------------------------------
bool Near(double value, double wanted, double tolerance, const std::string& what)
{
  return Check(std::abs(value / wanted - 1.0) <= tolerance,
    what + " is " + std::to_string(value) + " instead of " + std::to_string(wanted));
}

/// Each tree has its height and its girth, within rounding.
bool HeightsAndDiameters(Kinds& kinds)
{
  Stand stand(kinds);
  stand.Add(stand.Heights);
  stand.Add(stand.Diameters);
  stand.Filter->Update();
  const std::vector<double> tops = stand.Tops();
  bool good = true;
  for (vtkIdType plant = 0; plant < stand.Feet->GetNumberOfPoints(); ++plant)
  {
    const std::string ofPlant = " of plant " + std::to_string(plant);
    const double height = stand.Heights->GetValue(plant);
    good &= Near(tops[plant], height, 1e-4, "height" + ofPlant);
    good &= Near(stand.Diameter(plant, MeasuredAt(height)), stand.Diameters->GetValue(plant), 2e-3, "DBH" + ofPlant);
  }
  return good;
}

/// So have trees in the level Medium.
bool InMedium(Kinds& kinds)
{
  Stand stand(kinds);
  stand.Add(stand.Heights);
  stand.Add(stand.Diameters);
  stand.Filter->UseLevelsOn();
  stand.Filter->SetNearDistance(1.0);
  stand.Filter->SetFarDistance(1e6);
  stand.Filter->SetViewPoint(0.0, -900.0, 0.0);
  stand.Filter->Update();
  const std::vector<double> tops = stand.Tops("Medium/Trunk", "Medium/Crown");
  bool good = true;
  for (vtkIdType plant = 0; plant < stand.Feet->GetNumberOfPoints(); ++plant)
  {
    const std::string ofPlant = " of plant " + std::to_string(plant) + " in Medium";
    const double height = stand.Heights->GetValue(plant);
    good &= Near(tops[plant], height, 1e-4, "height" + ofPlant);
    good &= Near(stand.Diameter(plant, MeasuredAt(height), "Medium/Trunk"), stand.Diameters->GetValue(plant), 2e-3,
      "DBH" + ofPlant);
  }
  return good;
}

/// One array alone keeps the proportions of the prototype, and switching it off leaves the sites their scales.
bool OneOfThem(Kinds& kinds)
{
  bool good = true;
  Stand tall(kinds);
  tall.Add(tall.Heights);
  tall.Filter->Update();
  const std::vector<double> tops = tall.Tops();
  good &= Check(!tall.Filter->GetOutputDataObject(0)->GetFieldData()->HasArray("WidthScale"), "a WidthScale of nobody");
  Stand thick(kinds);
  thick.Add(thick.Diameters);
  thick.Filter->SetDiameterArray("Dicke");
  thick.Diameters->SetName("Dicke");
  thick.Filter->Update();
  const std::vector<double> topsByGirth = thick.Tops();
  for (vtkIdType plant = 0; plant < tall.Feet->GetNumberOfPoints(); ++plant)
  {
    good &= Near(tops[plant], tall.Heights->GetValue(plant), 1e-4, "height alone");
    good &= Near(thick.Diameter(plant, MeasuredAt(topsByGirth[plant])), thick.Diameters->GetValue(plant), 2e-3,
      "DBH alone of plant " + std::to_string(plant));
  }
  Stand plain(kinds);
  plain.Add(plain.Heights);
  plain.Add(plain.Diameters);
  plain.Filter->UseDimensionsOff();
  plain.Filter->SetScaleVariation(0.0);
  plain.Filter->Update();
  const std::vector<double> own = plain.Tops();
  good &= Near(own[0], own[1], 1e-5, "a pine without dimensions");
  return good;
}

/// Instances are the same trees.
bool AsInstances(Kinds& kinds)
{
  Stand stand(kinds);
  stand.Add(stand.Heights);
  stand.Add(stand.Diameters);
  stand.Filter->Update();
  const std::vector<double> tops = stand.Tops();
  stand.Filter->SetOutputFormToInstances();
  stand.Filter->Update();
  vtkPolyData* points = stand.Part("Instances");
  vtkDataArray* scales = points->GetPointData()->GetArray("Scale");
  vtkDataArray* prototypes = points->GetPointData()->GetArray("Prototype");
  bool good = Check(scales->GetNumberOfComponents() == 3, "scales along the axes");
  for (vtkIdType plant = 0; good && plant < points->GetNumberOfPoints(); ++plant)
  {
    const auto species = (static_cast<int>(prototypes->GetTuple1(plant)) - 1) / 3;
    double top = 0.0;
    for (const char* part : { "Skin", "Leaves" })
    {
      auto* block = vtkPolyData::SafeDownCast(
        BlockAt(stand.Filter->GetOutputDataObject(0), (std::to_string(species) + " High/" + part).c_str()));
      top = std::max(top, block && block->GetNumberOfPoints() > 0 ? block->GetBounds()[5] : 0.0);
    }
    good &= Near(top * scales->GetComponent(plant, 2), tops[plant], 1e-5, "height of an instance");
    good &= Check(scales->GetComponent(plant, 0) == scales->GetComponent(plant, 1), "level scales");
  }
  return good;
}

/// Normals have the length 1, and radii are those of the bark.
bool NormalsAndRadii(Kinds& kinds)
{
  Stand stand(kinds);
  stand.Add(stand.Heights);
  stand.Add(stand.Diameters);
  stand.Filter->Update();
  vtkPolyData* skin = stand.Part("High/Skin");
  vtkDataArray* normals = skin->GetPointData()->GetNormals();
  double worst = 0.0;
  for (vtkIdType point = 0; point < skin->GetNumberOfPoints(); ++point)
  {
    double normal[3];
    normals->GetTuple(point, normal);
    worst = std::max(worst, std::abs(vtkMath::Norm(normal) - 1.0));
  }
  bool good = Check(worst < 1e-5, "length of normals off by " + std::to_string(worst));
  vtkPolyData* bones = stand.Part("High/Skeleton");
  vtkDataArray* plants = bones->GetPointData()->GetArray("PlantId");
  vtkDataArray* radii = bones->GetPointData()->GetArray("Radius");
  const vtkIdType oak = 6; // 18.1 m, 0.656 m
  double last = 0.0;
  double at = 0.0;
  for (vtkIdType node = 0; node < bones->GetNumberOfPoints() && at == 0.0; ++node)
  {
    const double height = bones->GetPoint(node)[2] - stand.Feet->GetPoint(oak)[2];
    const bool isOwn = static_cast<vtkIdType>(plants->GetTuple1(node)) == oak;
    at = isOwn && height > 1.3 ? radii->GetTuple1(node) : 0.0;
    last = isOwn && height <= 1.3 ? radii->GetTuple1(node) : last;
  }
  good &= Check(2.0 * at < 0.68 && 2.0 * last > 0.656,
    "radii of the skeleton around breast height are " + std::to_string(last) + " and " + std::to_string(at));
  return good;
}

bool BadInput(Kinds& kinds)
{
  const auto fails = [&kinds](const char* words, const std::function<void(Stand&)>& spoil) {
    Stand stand(kinds);
    stand.Add(stand.Heights);
    stand.Add(stand.Diameters);
    spoil(stand);
    vtkNew<ErrorCounter> errors;
    errors->Watch(stand.Filter);
    return Check(errors->ExpectOneNaming(words) && errors->ExpectOneNaming(words), words);
  };
  bool good = fails(
    "DBH of site 3 is 25 m; it must be positive and at most 20 m", [](Stand& s) { s.Diameters->SetValue(3, 25.0); });
  good &= fails("DBH of site 3 is 0 m", [](Stand& s) { s.Diameters->SetValue(3, 0.0); });
  good &= fails("Height of site 4 is nan m", [](Stand& s) { s.Heights->SetValue(4, NaN); });
  good &= fails("Height of site 0 is 181 m", [](Stand& s) { s.Heights->SetValue(0, 181.0); });
  good &= fails("DBH", [](Stand& s) { s.Diameters->SetNumberOfTuples(3); });
  return good;
}

}

int TestTreeDimensions(int, char*[])
{
  Kinds kinds;
  bool good = HeightsAndDiameters(kinds);
  good &= InMedium(kinds);
  good &= OneOfThem(kinds);
  good &= AsInstances(kinds);
  good &= NormalsAndRadii(kinds);
  good &= BadInput(kinds);
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
