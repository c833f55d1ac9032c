// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Drainage through the pipeline: areas that sum to the grid's, rivers that fall, targets, outlets, parts, every bad
// input.
#include "Check.h"
#include "ErrorCounter.h"
#include "GroundImage.h"
#include "Sanitizer.h"
#include "vtkDrainageFilter.h"
#include "vtkGroundStatisticsFilter.h"
#include "vtkTurningBandsTerrainSource.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#ifndef _WIN32
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace
{

const double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr int StepX[8] = { 1, 1, 0, -1, -1, -1, 0, 1 };
constexpr int StepY[8] = { 0, 1, 1, 1, 0, -1, -1, -1 };

vtkNew<vtkTurningBandsTerrainSource> Terrain(int size, int seed = 1)
{
  vtkNew<vtkTurningBandsTerrainSource> terrain;
  terrain->SetWholeExtent(0, size, 0, size - 10, 0, 0);
  terrain->SetSpacing(20.0, 30.0, 1.0);
  terrain->SetModelToBessel1();
  terrain->SetRange(300.0);
  terrain->SetSeed(seed);
  return terrain;
}

double Value(vtkImageData* image, const char* name, vtkIdType cell)
{
  return image->GetPointData()->GetArray(name)->GetComponent(cell, 0);
}

double FieldOf(vtkDataObject* data, const char* name, int component)
{
  return data->GetFieldData()->GetArray(name)->GetComponent(0, component);
}

vtkPolyData* Rivers(vtkDrainageFilter* drainage)
{
  return vtkPolyData::SafeDownCast(drainage->GetOutputDataObject(1));
}

/// Water goes downhill to the border, along the directions; areas are the walks that pass, and sum to the grid's.
bool Drains(vtkImageData* ground)
{
  const int* size = ground->GetDimensions();
  const double cell = ground->GetSpacing()[0] * ground->GetSpacing()[1];
  const vtkIdType count = ground->GetNumberOfPoints();
  std::vector<double> walked(count, 0.0);
  double outflow = 0.0;
  bool good = true;
  for (vtkIdType start = 0; start < count && good; ++start)
  {
    vtkIdType at = start;
    walked[at] += cell;
    while (Value(ground, "FlowDirection", at) >= 0.0)
    {
      const int direction = static_cast<int>(Value(ground, "FlowDirection", at));
      const vtkIdType next = at + StepY[direction] * size[0] + StepX[direction];
      good &= Check(Value(ground, "Elevation", next) < Value(ground, "Elevation", at), "water runs uphill");
      at = next;
      walked[at] += cell;
    }
    const vtkIdType i = at % size[0];
    const vtkIdType j = at / size[0];
    good &= Check(i == 0 || j == 0 || i == size[0] - 1 || j == size[1] - 1, "water ends within the grid");
  }
  for (vtkIdType at = 0; at < count; ++at)
  {
    good &= walked[at] == Value(ground, "DrainageArea", at);
    good &= Value(ground, "DepressionDepth", at) == 0.0;
    outflow += Value(ground, "FlowDirection", at) < 0.0 ? Value(ground, "DrainageArea", at) : 0.0;
  }
  return Check(good, "areas are not those of walks") &&
    Check(outflow == cell * static_cast<double>(count), "lost water");
}

/// Rivers are blue, the darker the higher their order, and those of one order are alike.
bool RiversAreBlue(vtkPolyData* rivers)
{
  vtkDataArray* colors = rivers->GetPointData()->GetArray("RGB");
  vtkDataArray* orders = rivers->GetCellData()->GetArray("StreamOrder");
  std::map<int, std::array<double, 3>> known;
  bool good = true;
  vtkNew<vtkIdList> ids;
  for (vtkIdType row = 0; row < rivers->GetNumberOfCells(); ++row)
  {
    rivers->GetCellPoints(row, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      std::array<double, 3> color;
      colors->GetTuple(ids->GetId(k), color.data());
      good &= known.emplace(static_cast<int>(orders->GetComponent(row, 0)), color).first->second == color;
      good &= color[2] > color[1] && color[1] > color[0];
    }
  }
  double before = 3.0 * 255.0;
  for (const auto& [order, color] : known)
  {
    const double light = color[0] + color[1] + color[2];
    good &= light < before - 20.0;
    before = light;
  }
  return Check(known.size() > 2, "few orders of streams") && Check(good, "rivers are not blue, or not the darker");
}

/// Rivers lie on the ground, fall, and are those of the orders of the points.
bool RiversFall(vtkDrainageFilter* drainage, int least)
{
  vtkImageData* ground = drainage->GetOutput();
  vtkPolyData* rivers = Rivers(drainage);
  bool good = Check(rivers->GetNumberOfLines() > 3, "few rivers");
  for (const char* name : { "StreamOrder", "DrainageArea", "Length", "Slope" })
  {
    good &= Check(rivers->GetCellData()->GetArray(name) != nullptr, name);
  }
  good &= Check(rivers->GetPointData()->GetArray("RGB")->GetNumberOfTuples() == rivers->GetNumberOfPoints(), "colors");
  const double cell = ground->GetSpacing()[0] * ground->GetSpacing()[1];
  vtkNew<vtkIdList> ids;
  for (vtkIdType row = 0; row < rivers->GetNumberOfCells() && good; ++row)
  {
    rivers->GetCellPoints(row, ids);
    double length = 0.0;
    double first[3] = { 0.0, 0.0, 0.0 };
    double before[3] = { 0.0, 0.0, 0.0 };
    double at[3];
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      rivers->GetPoint(ids->GetId(k), at);
      double flat[3] = { at[0], at[1], 0.0 };
      const vtkIdType point = ground->FindPoint(flat);
      good &= Check(std::abs(Value(ground, "Elevation", point) - at[2]) < 1e-9, "a river off the ground");
      good &= Check(Value(ground, "DrainageArea", point) >= least * cell, "a river of less water");
      if (k > 0)
      {
        length += std::hypot(at[0] - before[0], at[1] - before[1]);
        good &= Check(at[2] < before[2], "a river that rises");
      }
      else
      {
        std::copy(at, at + 3, first);
        good &=
          Value(ground, "StreamOrder", point) == rivers->GetCellData()->GetArray("StreamOrder")->GetComponent(row, 0);
      }
      std::copy(at, at + 3, before);
    }
    const double told = rivers->GetCellData()->GetArray("Length")->GetComponent(row, 0);
    const double slope = rivers->GetCellData()->GetArray("Slope")->GetComponent(row, 0);
    good &= Check(std::abs(told / length - 1.0) < 1e-12, "another length");
    good &= Check(std::abs(slope * length / (first[2] - at[2]) - 1.0) < 1e-9, "another slope");
  }
  return Check(good, "rivers are not those of the ground");
}

/// A carved field drains, keeps mean, variance and distribution of its heights, and the arrays that it had.
bool CarvedGroundDrains()
{
  const auto terrain = Terrain(100);
  terrain->ReflectanceOn();
  vtkNew<vtkDrainageFilter> drainage;
  drainage->SetInputConnection(terrain->GetOutputPort());
  drainage->SetStreamThreshold(40);
  drainage->KeepHypsometryOn();
  drainage->Update();
  vtkImageData* ground = drainage->GetOutput();
  bool good = Drains(ground) && RiversFall(drainage, 40) && RiversAreBlue(Rivers(drainage));
  good &= Check(ground->GetPointData()->GetArray("Reflectance") != nullptr, "an array of the input is lost");
  good &= Check(
    FieldOf(ground, "DepressionFraction", 0) > 0.1 && FieldOf(ground, "DepressionFraction", 1) == 0.0, "sunk cells");
  good &= Check(FieldOf(Rivers(drainage), "Iterations", 0) >= 1.0, "no rounds");
  std::vector<double> before;
  std::vector<double> after;
  for (vtkIdType cell = 0; cell < ground->GetNumberOfPoints(); ++cell)
  {
    before.push_back(Value(terrain->GetOutput(), "Elevation", cell));
    after.push_back(Value(ground, "Elevation", cell));
  }
  std::sort(before.begin(), before.end());
  std::sort(after.begin(), after.end());
  const double range = before.back() - before.front();
  for (std::size_t n = 0; n < before.size(); ++n)
  {
    good &= std::abs(after[n] - before[n]) < 0.005 * range;
  }
  return Check(good, "another distribution of heights");
}

/// A target of another size and spacing hands over its heights and concavity; without carving the ground stays.
bool TargetIsTaken()
{
  const auto terrain = Terrain(80, 3);
  vtkNew<vtkImageData> place;
  {
    vtkNew<vtkDrainageFilter> carved;
    const auto other = Terrain(90, 7);
    carved->SetInputConnection(other->GetOutputPort());
    carved->KeepHypsometryOff();
    carved->SetHypsometricIntegral(0.3);
    carved->SetElevationSkewness(0.8);
    carved->SetMaximumNumberOfIterations(3);
    carved->Update();
    place->ShallowCopy(carved->GetOutput());
  }
  vtkNew<vtkDrainageFilter> drainage;
  drainage->SetInputConnection(terrain->GetOutputPort());
  drainage->SetInputData(1, place);
  drainage->SetMaximumNumberOfIterations(3);
  drainage->Update();
  vtkNew<vtkGroundStatisticsFilter> statistics;
  double integral[2];
  double skew[2];
  int k = 0;
  for (vtkImageData* ground : { place.Get(), drainage->GetOutput() })
  {
    statistics->SetInputData(ground);
    statistics->Update();
    auto* table = vtkTable::SafeDownCast(statistics->GetOutputDataObject(0));
    integral[k] = table->GetValueByName(0, "HypsometricIntegral").ToDouble();
    skew[k++] = table->GetValueByName(0, "ElevationSkewness").ToDouble();
  }
  bool good = Check(std::abs(integral[0] - 0.3) < 0.03 && std::abs(skew[0] - 0.8) < 0.15, "numbers are no target");
  good &= Check(std::abs(integral[1] - integral[0]) < 0.03 && std::abs(skew[1] - skew[0]) < 0.15, "another hypsometry");
  drainage->RemoveTarget();
  drainage->CarveOff();
  drainage->Update();
  for (vtkIdType cell = 0; cell < drainage->GetOutput()->GetNumberOfPoints(); ++cell)
  {
    good &= Value(drainage->GetOutput(), "Elevation", cell) == Value(terrain->GetOutput(), "Elevation", cell);
  }
  good &= Check(good, "ground that is not carved has changed");
  return good &&
    Check(FieldOf(drainage->GetOutput(), "DepressionFraction", 0) ==
        FieldOf(drainage->GetOutput(), "DepressionFraction", 1),
      "measures of ground that has not changed");
}

/// A grown landscape drains, is none of the terrain, and has the target's mean height; seeds differ.
bool GrownGroundDrains()
{
  const auto terrain = Terrain(70, 3);
  const auto place = Terrain(60, 7);
  place->Update();
  vtkNew<vtkDrainageFilter> drainage;
  drainage->SetInputConnection(terrain->GetOutputPort());
  drainage->SetTargetConnection(place->GetOutputPort());
  drainage->SetMethodToGrowth();
  drainage->SetStreamThreshold(40);
  drainage->SetMaximumNumberOfIterations(2);
  drainage->Update();
  vtkNew<vtkImageData> first;
  first->DeepCopy(drainage->GetOutput());
  bool good = Drains(first) && RiversFall(drainage, 40);
  const auto mean = [](vtkImageData* ground) {
    double sum = 0.0;
    for (vtkIdType n = 0; n < ground->GetNumberOfPoints(); ++n)
    {
      sum += ground->GetPointData()->GetScalars()->GetComponent(n, 0);
    }
    return sum / static_cast<double>(ground->GetNumberOfPoints());
  };
  const double* range = place->GetOutput()->GetPointData()->GetScalars()->GetRange();
  good &= Check(std::abs(mean(first) - mean(place->GetOutput())) < 0.02 * (range[1] - range[0]), "another mean height");
  good &= Check(FieldOf(first, "Iterations", 0) <= 2.0, "too many iterations");
  drainage->SetSeed(2);
  drainage->Update();
  return good && Check(Value(first, "Elevation", 999) != Value(drainage->GetOutput(), "Elevation", 999), "one seed");
}

/// A quilt of a place that drains does so too, has cells of the target's size, and seeds differ; other cells are
/// refused.
bool QuiltedGroundDrains()
{
  const auto terrain = Terrain(70, 3);
  const auto rough = Terrain(60, 7);
  vtkNew<vtkDrainageFilter> place;
  place->SetInputConnection(rough->GetOutputPort());
  vtkNew<vtkDrainageFilter> drainage;
  drainage->SetInputConnection(terrain->GetOutputPort());
  drainage->SetTargetConnection(place->GetOutputPort());
  drainage->SetMethodToQuilting();
  drainage->SetStreamThreshold(40);
  drainage->Update();
  vtkNew<vtkImageData> first;
  first->DeepCopy(drainage->GetOutput());
  bool good = Drains(first) && RiversFall(drainage, 40);
  drainage->SetSeed(2);
  drainage->Update();
  return good && Check(Value(first, "Elevation", 999) != Value(drainage->GetOutput(), "Elevation", 999), "one seed");
}

/// An array of the terrain by place, of a value west of the middle and another east of it.
void AddHalves(vtkImageData* image, const char* name, double west, double east)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName(name);
  const int width = image->GetDimensions()[0];
  for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
  {
    values->InsertNextValue(n % width < width / 2 ? west : east);
  }
  image->GetPointData()->AddArray(values);
}

/// Rock counts if it is used; a throw lifts its side of the ground; bad rock is refused.
bool RockIsUsed()
{
  const auto source = Terrain(50, 3);
  source->Update();
  vtkNew<vtkImageData> terrain;
  terrain->DeepCopy(source->GetOutput());
  const auto place = Terrain(40, 7);
  vtkNew<vtkDrainageFilter> drainage;
  drainage->SetInputData(terrain);
  drainage->SetTargetConnection(place->GetOutputPort());
  drainage->SetMethodToGrowth();
  drainage->SetMaximumNumberOfIterations(1);
  const auto halves = [&](bool uses) {
    drainage->SetUseRock(uses);
    drainage->Modified();
    drainage->Update();
    const int width = terrain->GetDimensions()[0];
    std::array<double, 2> means{ 0.0, 0.0 };
    for (vtkIdType n = 0; n < terrain->GetNumberOfPoints(); ++n)
    {
      means[n % width < width / 2 ? 0 : 1] += Value(drainage->GetOutput(), "Elevation", n);
    }
    return (means[0] - means[1]) / static_cast<double>(terrain->GetNumberOfPoints() / 2);
  };
  AddHalves(terrain, "FaultThrow", 500.0, 0.0);
  const double plain = halves(false);
  bool good = Check(std::abs(halves(true) - plain - 500.0) < 50.0, "a fault does not lift its side by its throw");
  good &= Check(Drains(drainage->GetOutput()), "faulted ground does not drain");
  terrain->GetPointData()->RemoveArray("FaultThrow");
  for (const auto& [west, east] : { std::pair{ 1.0, 8.0 }, { 8.0, 1.0 } })
  {
    AddHalves(terrain, "UpliftFactor", west, east);
    AddHalves(terrain, "Erodibility", east, west);
    good &= Check((halves(true) > plain) == (west > east), "soft ground that hardly rises is higher");
  }
  terrain->GetPointData()->GetArray("Erodibility")->SetComponent(77, 0, -1.0);
  drainage->Modified();
  good &= FailsNaming("Erodibility has values", drainage);
  terrain->GetPointData()->RemoveArray("Erodibility");
  terrain->GetPointData()->RemoveArray("UpliftFactor");
  drainage->Modified();
  return good && FailsNaming("UseRock is on", drainage);
}

/// Given lines and points are held: a river's water leaves at its lower end, no water comes to a ridge, the ground goes
/// through a point; bad ones are refused.
bool GivenIsHeld()
{
  const auto terrain = Terrain(50, 3);
  const auto place = Terrain(40, 7);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  const double places[][3] = { { 200.0, 300.0, 90.0 }, { 600.0, 450.0, 60.0 }, { 1000.0, 330.0, 20.0 },
    { 200.0, 840.0, 0.0 }, { 800.0, 960.0, 0.0 }, { 420.0, 660.0, 123.0 } };
  for (const auto& at : places)
  {
    points->InsertNextPoint(at);
  }
  const vtkIdType river[] = { 0, 1, 2 };
  const vtkIdType ridge[] = { 3, 4 };
  lines->InsertNextCell(3, river);
  lines->InsertNextCell(2, ridge);
  vtkNew<vtkDoubleArray> isRidge;
  isRidge->SetName("Ridge");
  isRidge->InsertNextValue(0.0);
  isRidge->InsertNextValue(1.0);
  vtkNew<vtkPolyData> given;
  given->SetPoints(points);
  given->SetLines(lines);
  given->GetCellData()->AddArray(isRidge);
  vtkNew<vtkDrainageFilter> drainage;
  drainage->SetInputConnection(terrain->GetOutputPort());
  drainage->SetTargetConnection(place->GetOutputPort());
  drainage->SetInputData(3, given);
  drainage->SetMethodToGrowth();
  drainage->UseLineHeightsOn();
  drainage->SetMaximumNumberOfIterations(1);
  given->GetCellData()->RemoveArray("Ridge"); // the ridge is level, so it may be a river
  drainage->Update();
  vtkImageData* ground = drainage->GetOutput();
  const auto at = [&](const char* name, double x, double y) {
    double point[3] = { x, y, 0.0 };
    return Value(ground, name, ground->FindPoint(point));
  };
  const double cell = 20.0 * 30.0;
  bool good = Drains(ground);
  good &= Check(std::abs(at("Elevation", 420.0, 660.0) - 123.0) < 1.0, "a given height is not met");
  good &= Check(std::abs(at("Elevation", 600.0, 450.0) - 60.0) < 10.0, "a height of a line is not met");
  good &= Check(at("DrainageArea", 1000.0, 330.0) > 40.0 * cell, "a given river has no water");
  given->GetCellData()->AddArray(isRidge);
  given->Modified();
  drainage->UseLineHeightsOff();
  drainage->Update();
  good &= Check(at("DrainageArea", 1000.0, 330.0) > 40.0 * cell, "a given river has no water");
  good &= Check(at("DrainageArea", 500.0, 900.0) < 5.0 * cell, "water crosses a ridge");
  good &= Check(std::abs(at("Elevation", 420.0, 660.0) - 123.0) < 1.0, "a given height is not met");
  points->SetPoint(1, 600.0, 1000.0, 60.0);
  points->Modified();
  good &= FailsNaming("A river crosses a ridge", drainage);
  points->SetPoint(1, 600.0, 2000.0, 60.0);
  points->Modified();
  good &= FailsNaming("outside of the terrain", drainage);
  points->SetPoint(1, NaN, 450.0, 60.0);
  points->Modified();
  good &= FailsNaming("not finite", drainage);
  points->SetPoint(1, 600.0, 450.0, 91.0);
  points->Modified();
  drainage->UseLineHeightsOn();
  return good && FailsNaming("A river runs uphill", drainage);
}

/// A table of statistics hands over heights and concavity, as the same numbers set one by one do.
bool StatisticsAreTaken()
{
  const auto terrain = Terrain(80, 3);
  vtkNew<vtkTable> table;
  for (const auto& [name, value] : { std::pair{ "HypsometricIntegral", 0.33 }, { "ElevationSkewness", 0.7 },
         { "Concavity", 0.3 }, { "DepressionFraction", 0.05 } })
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    column->InsertNextValue(value);
    table->AddColumn(column);
  }
  vtkNew<vtkDrainageFilter> told;
  vtkNew<vtkDrainageFilter> set;
  told->SetInputData(2, table);
  told->KeepHypsometryOn();
  set->SetHypsometricIntegral(0.33);
  set->SetElevationSkewness(0.7);
  set->SetConcavity(0.3);
  for (vtkDrainageFilter* drainage : { told.Get(), set.Get() })
  {
    drainage->SetInputConnection(terrain->GetOutputPort());
    drainage->SetMaximumNumberOfIterations(3);
    drainage->Update();
  }
  bool good = Check(FieldOf(told->GetOutput(), "HypsometricIntegral", 1) < 0.36, "another hypsometric integral");
  for (vtkIdType cell = 0; cell < set->GetOutput()->GetNumberOfPoints(); ++cell)
  {
    good &= Value(told->GetOutput(), "Elevation", cell) == Value(set->GetOutput(), "Elevation", cell);
  }
  return Check(good, "a table is not what its numbers are");
}

/// All water leaves at the one outlet that is chosen, or at the sea.
bool OutletsAreChosen()
{
  const auto image = Image(40, 30, 1, [](int i, int j) { return 100.0 + std::sin(0.7 * i) + std::cos(1.1 * j); });
  vtkNew<vtkDoubleArray> outlets;
  outlets->SetName("Outlets");
  outlets->SetNumberOfTuples(1200);
  outlets->Fill(0.0);
  outlets->SetValue(15 * 40 + 20, 1.0);
  image->GetPointData()->AddArray(outlets);
  vtkNew<vtkDrainageFilter> drainage;
  drainage->SetInputData(image);
  drainage->SetOutletsToChosen();
  drainage->SetMaximumNumberOfIterations(2);
  drainage->Update();
  vtkImageData* ground = drainage->GetOutput();
  bool good = Check(Value(ground, "DrainageArea", 15 * 40 + 20) == 1200 * 200.0, "water leaves elsewhere");
  good &= Check(Value(ground, "FlowDirection", 15 * 40 + 20) == -1.0, "the outlet flows");
  drainage->SetInputData(Image(41, 41, 1, [](int i, int j) { return std::hypot(i - 20.0, j - 20.0) - 6.0; }));
  drainage->SetOutletsToSea();
  drainage->CarveOff();
  drainage->Update();
  double sea = 0.0;
  for (vtkIdType cell = 0; cell < 41 * 41; ++cell)
  {
    const bool isSea = Value(ground, "Elevation", cell) <= 0.0;
    sea += isSea ? Value(ground, "DrainageArea", cell) : 0.0;
    good &= !isSea || Value(ground, "FlowDirection", cell) == -1.0;
  }
  drainage->SetOutletsToBorder();
  drainage->Update();
  // the bowl's rim is lowest where the border is nearest to its middle
  const double rim = 20.0 - 6.0;
  good &= Check(std::abs(Value(ground, "DepressionDepth", 20 * 41 + 20) - (rim + 6.0)) < 1e-12, "another depth");
  return Check(good, "the sea flows") && Check(sea > 0.8 * 41 * 41 * 200.0, "the bowl does not drain to its sea");
}

/// A part is that of the whole; a later piece has no rivers.
bool PartsAreOfOneWhole()
{
  const auto terrain = Terrain(70);
  vtkNew<vtkDrainageFilter> whole;
  whole->SetInputConnection(terrain->GetOutputPort());
  whole->SetMaximumNumberOfIterations(2);
  whole->Update();
  vtkNew<vtkDrainageFilter> part;
  part->SetInputConnection(terrain->GetOutputPort());
  part->SetMaximumNumberOfIterations(2);
  int extent[6] = { 20, 50, 11, 30, 0, 0 };
  part->UpdateExtent(extent);
  int got[6];
  part->GetOutput()->GetExtent(got);
  bool good = Check(std::equal(got, got + 6, extent), "another part than was asked for");
  for (vtkIdType cell = 0; good && cell < part->GetOutput()->GetNumberOfPoints(); ++cell)
  {
    double place[3];
    part->GetOutput()->GetPoint(cell, place);
    const vtkIdType same = whole->GetOutput()->FindPoint(place);
    for (const char* name : { "Elevation", "DrainageArea", "FlowDirection", "StreamOrder" })
    {
      good &= Value(part->GetOutput(), name, cell) == Value(whole->GetOutput(), name, same);
    }
  }
  good = Check(good, "a part differs from the whole");
  for (const int piece : { 1, 0 })
  {
    part->UpdateInformation();
    vtkInformation* info = part->GetOutputInformation(1);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), piece);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 2);
    part->Update(1);
    good &= Check((Rivers(part)->GetNumberOfLines() > 0) == (piece == 0), "rivers in another piece than the first");
  }
  return good;
}

/// Parts of a terrain that is drained by tiles are those of the whole: of a source that makes parts, and of an image.
bool TilesAreOfOneWhole()
{
  const auto terrain = Terrain(70);
  vtkNew<vtkDrainageFilter> whole;
  whole->SetInputConnection(terrain->GetOutputPort());
  whole->CarveOff();
  whole->Update();
  vtkNew<vtkDrainageFilter> part;
  part->SetInputConnection(terrain->GetOutputPort());
  part->CarveOff();
  part->SetTileSize(23); // the last tiles are two columns wide
  std::vector<std::array<int, 6>> extents{ { 0, 70, 0, 22, 0, 0 }, { 20, 50, 11, 30, 0, 0 }, { 69, 70, 46, 60, 0, 0 } };
  bool good = true;
  for (const bool isImage : { false, true })
  {
    if (isImage)
    {
      part->SetInputData(terrain->GetOutput());
      terrain->UpdateWholeExtent();
    }
    for (std::array<int, 6> extent : extents)
    {
      part->UpdateExtent(extent.data());
      int got[6];
      part->GetOutput()->GetExtent(got);
      good &= Check(std::equal(got, got + 6, extent.data()), "another part by tiles than was asked for");
      for (vtkIdType cell = 0; good && cell < part->GetOutput()->GetNumberOfPoints(); ++cell)
      {
        double place[3];
        part->GetOutput()->GetPoint(cell, place);
        const vtkIdType same = whole->GetOutput()->FindPoint(place);
        for (const char* name : { "Elevation", "DrainageArea", "FlowDirection", "DepressionDepth" })
        {
          good &= Value(part->GetOutput(), name, cell) == Value(whole->GetOutput(), name, same);
        }
      }
      const auto fraction = [](vtkDrainageFilter* filter) {
        return filter->GetOutput()->GetFieldData()->GetArray("DepressionFraction")->GetComponent(0, 0);
      };
      good &= Check(fraction(part) == fraction(whole), "another share of depressions");
    }
  }
  // Another terrain is drained anew.
  terrain->SetSeed(2);
  part->SetInputConnection(terrain->GetOutputPort());
  whole->Update();
  part->UpdateWholeExtent();
  for (vtkIdType cell = 0; cell < part->GetOutput()->GetNumberOfPoints(); ++cell)
  {
    good &= Value(part->GetOutput(), "DrainageArea", cell) == Value(whole->GetOutput(), "DrainageArea", cell);
  }
  return Check(good, "a part by tiles differs from the whole") &&
    Check(Rivers(part)->GetNumberOfLines() == 0, "rivers of tiles");
}

bool Fails(const char* word, vtkImageData* image, const std::function<void(vtkDrainageFilter*)>& spoil = {})
{
  vtkNew<vtkDrainageFilter> drainage;
  drainage->SetInputData(image);
  if (spoil)
  {
    spoil(drainage);
  }
  bool good = FailsNaming(word, drainage);
  good &= Check(drainage->GetOutput()->GetNumberOfPoints() == 0, "a refused input leaves ground");
  return good && Check(Rivers(drainage)->GetNumberOfPoints() == 0, "a refused input leaves rivers");
}

/// One message for each bad input, nothing half written, and the next good request works.
/// What only the last tile tells is one error, too; VTK does not hand on that the request failed.
bool BadTiles()
{
  bool good = true;
  for (const double height : { 5.0, NaN })
  {
    const auto image = Image(40, 20, 1, [height](int, int) { return height; });
    vtkNew<vtkDrainageFilter> drainage;
    drainage->SetInputData(image);
    drainage->CarveOff();
    drainage->SetTileSize(16);
    vtkNew<ErrorCounter> errors;
    errors->Watch(drainage);
    drainage->Update();
    const char* word = height == 5.0 ? "is constant" : "no heights";
    good &= Check(errors->Count == 1 && errors->Last.find(word) != std::string::npos, "no error of all tiles");
    good &= Check(drainage->GetOutput()->GetNumberOfPoints() == 0, "refused tiles leave ground");
    drainage->SetInputData(Image(40, 20, 1, Ramp));
    drainage->Update();
    good &= Check(drainage->GetOutput()->GetNumberOfPoints() == 800, "nothing after mended tiles");
  }
  return good;
}

bool BadInput()
{
  using Filter = vtkDrainageFilter;
  const auto rough = [](int i, int j) { return static_cast<double>((i * 7919 + j * 104729) % 101); };
  const auto fine = Image(24, 20, 1, rough);
  bool good = Fails("constant", Image(20, 20, 1, [](int, int) { return 5.0; }));
  good &= Fails("beyond", Image(20, 20, 1, [](int i, int j) { return i == 3 && j == 4 ? 1e300 : Ramp(i, j); }));
  good &= Fails("no heights", Image(20, 20, 1, [](int, int) { return NaN; }));
  good &= Fails("20 x 1", Image(20, 1, 1, Ramp));
  good &= Fails("20 x 20 x 3", Image(20, 20, 3, Ramp));
  good &= Fails("'Depth'", fine,
    [](Filter* filter) { filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Depth"); });
  good &= Fails("Outlets is 5", fine, [](Filter* filter) { filter->SetOutlets(5); });
  good &= Fails("Outlets", fine, [](Filter* filter) { filter->SetOutletsToChosen(); });
  good &= Fails("SeaLevel", fine, [](Filter* filter) { filter->SetSeaLevel(NaN); });
  good &= Fails("StreamThreshold", fine, [](Filter* filter) { filter->SetStreamThreshold(0); });
  good &= Fails("Concavity", fine, [](Filter* filter) { filter->SetConcavity(1.5); });
  good &= Fails("HypsometricIntegral", fine, [](Filter* filter) { filter->SetHypsometricIntegral(1.5); });
  good &= Fails("ElevationSkewness", fine, [](Filter* filter) { filter->SetElevationSkewness(NaN); });
  good &= Fails("MaximumNumberOfIterations", fine, [](Filter* filter) { filter->SetMaximumNumberOfIterations(0); });
  good &= Fails("ChannelThreshold", fine, [](Filter* filter) { filter->SetChannelThreshold(0.0); });
  good &= Fails("ValleyWidth", fine, [](Filter* filter) { filter->SetValleyWidth(-1.0); });
  good &= Fails("no Target", fine, [](Filter* filter) { filter->SetMethodToGrowth(); });
  good &= Fails("no Target", fine, [](Filter* filter) { filter->SetMethodToQuilting(); });
  good &= Fails("Method is 3", fine, [](Filter* filter) { filter->SetMethod(3); });
  good &= Fails("Carve is on", fine, [](Filter* filter) { filter->SetTileSize(16); });
  const auto tiled = [](int size, int outlets) {
    return [size, outlets](Filter* filter) {
      filter->CarveOff();
      filter->SetTileSize(size);
      filter->SetOutlets(outlets);
    };
  };
  good &= Fails("TileSize is 15", fine, tiled(15, Filter::Border));
  good &= Fails("neither Border nor Sea", fine, tiled(16, Filter::LowestOfBorder));
  good &= Fails("20 x 1", Image(20, 1, 1, Ramp), tiled(16, Filter::Border));
  good &= Fails("20 x 20 x 3", Image(20, 20, 3, Ramp), tiled(16, Filter::Sea));
  const auto grow = [](const vtkNew<vtkImageData>& place, int outlets) {
    return [&place, outlets](Filter* filter) {
      filter->SetMethodToGrowth();
      filter->SetOutlets(outlets);
      filter->SetInputData(1, place);
    };
  };
  good &= Fails("Outlets is not Border", fine, grow(fine, Filter::LowestOfBorder));
  const auto quilt = [](const vtkNew<vtkImageData>& place, int outlets) {
    return [&place, outlets](Filter* filter) {
      filter->SetMethodToQuilting();
      filter->SetOutlets(outlets);
      filter->SetInputData(1, place);
    };
  };
  const auto wide = Image(24, 20, 1, rough);
  wide->SetSpacing(20.0, 10.0, 1.0);
  good &= Fails("cells of other sizes", fine, quilt(wide, Filter::Border));
  good &= Fails("Outlets is not Border", fine, quilt(fine, Filter::Sea));
  good &= Fails("The target has fewer than 16", fine, quilt(Image(24, 9, 1, rough), Filter::Border));
  good &= Fails("The target is a plane", fine, grow(Image(24, 20, 1, Ramp), Filter::Border));
  good &= Fails("The target has fewer than 16", fine, grow(Image(24, 9, 1, rough), Filter::Border));
  good &= Fails("The terrain has fewer than 16", Image(9, 24, 1, rough), grow(fine, Filter::Border));
  // targets that contradict each other: most of the ground low, and a long tail downwards
  good &= Fails("ElevationSkewness", fine, [](Filter* filter) {
    filter->KeepHypsometryOff();
    filter->SetHypsometricIntegral(0.2);
    filter->SetElevationSkewness(-1.0);
  });
  const auto target = [](const vtkNew<vtkImageData>& image) {
    return [&image](Filter* filter) { filter->SetInputData(1, image); };
  };
  const auto flat = Image(20, 20, 1, [](int, int) { return 5.0; });
  const auto holed = Image(20, 20, 1, [](int i, int j) { return i == 3 && j == 4 ? 1e300 : Ramp(i, j); });
  const auto row = Image(20, 1, 1, Ramp);
  good &= Fails("target", fine, target(flat));
  good &= Fails("target", fine, target(holed));
  good &= Fails("20 x 1", fine, target(row));
  vtkNew<vtkTable> other;
  vtkNew<vtkDoubleArray> column;
  column->SetName("Concavity");
  other->AddColumn(column);
  const auto statistics = [&other](Filter* filter) { filter->SetInputData(2, other); };
  good &= Fails("Ground Statistics", fine, statistics); // without rows
  column->InsertNextValue(NaN);
  good &= Fails("Ground Statistics", fine, statistics);
  column->SetValue(0, 1.5);
  good &= Fails("Concavity is 1.5", fine, statistics);
  column->SetValue(0, 0.4);
  good &= Fails("disconnect one", fine, [&](Filter* filter) {
    filter->SetInputData(1, fine);
    filter->SetInputData(2, other);
  });

  vtkNew<vtkDrainageFilter> drainage;
  drainage->SetInputData(fine);
  drainage->SetConcavity(-1.0);
  vtkNew<ErrorCounter> errors;
  errors->Watch(drainage);
  good &= errors->ExpectOneNaming("Concavity");
  drainage->SetConcavity(0.4);
  drainage->Update();
  return good && Check(drainage->GetOutput()->GetNumberOfPoints() == 480, "nothing after a mistake was mended");
}

/// A round catchment within missing heights drains to its rim, or to its lowest place; what is outside stays NaN.
bool HolesAreOutside()
{
  const auto isOutside = [](vtkIdType cell) {
    return std::hypot(static_cast<double>(cell % 48) - 23.0, static_cast<double>(cell / 48) - 21.0) > 17.0;
  };
  const auto bowl = Image(48, 44, 1, [&](int i, int j) {
    return isOutside(48 * j + i) ? NaN : 0.05 * std::hypot(i - 23.0, j - 4.0) + 0.3 * ((7 * i + 3 * j * j) % 5);
  });
  bool good = true;
  for (const bool carves : { false, true })
  {
    for (const int outlets : { vtkDrainageFilter::Border, vtkDrainageFilter::LowestOfBorder })
    {
      vtkNew<vtkDrainageFilter> drainage;
      drainage->SetInputData(bowl);
      drainage->SetCarve(carves);
      drainage->SetOutlets(outlets);
      vtkNew<ErrorCounter> errors;
      errors->Watch(drainage);
      drainage->Update();
      vtkImageData* output = drainage->GetOutput();
      good &= Check(errors->Count == 0 && output->GetNumberOfPoints() == 48 * 44, "holes are refused");
      double atOutlets = 0.0;
      double present = 0.0;
      double count = 0.0;
      for (vtkIdType cell = 0; good && cell < output->GetNumberOfPoints(); ++cell)
      {
        const bool isHole = std::isnan(Value(output, "Elevation", cell));
        good &= Check(isHole == isOutside(cell), "the outside has other cells");
        good &= Check(isHole == std::isnan(Value(output, "DrainageArea", cell)), "the outside drains");
        const bool isOutlet = !isHole && Value(output, "FlowDirection", cell) < 0;
        present += !isHole;
        count += isOutlet;
        atOutlets += isOutlet ? Value(output, "DrainageArea", cell) : 0.0;
      }
      const double area = bowl->GetSpacing()[0] * bowl->GetSpacing()[1];
      good &=
        Check(std::abs(atOutlets - present * area) < 1e-6 * atOutlets, "areas at the outlets are not the terrain's");
      good &= Check(outlets == vtkDrainageFilter::Border ? count > 50.0 : count == 1.0, "other outlets");
    }
  }
  return good;
}

/// What the memory does not suffice for is refused, and a smaller terrain is then drained.
bool MemoryIsAsked()
{
  bool good = true;
#ifndef _WIN32
  vtkNew<vtkDrainageFilter> drainage;
  drainage->SetInputData(Image(900, 800, 1, Ramp));
  vtkNew<ErrorCounter> errors;
  errors->Watch(drainage);
  rlimit before;
  getrlimit(RLIMIT_DATA, &before);
  rlimit limit = before;
  limit.rlim_cur = static_cast<rlim_t>(1) << 20; // less than what is used
  if (!IsSanitized && before.rlim_max == RLIM_INFINITY && setrlimit(RLIMIT_DATA, &limit) == 0)
  {
    good &= errors->ExpectOneNaming("of memory");
    setrlimit(RLIMIT_DATA, &before);
    drainage->SetInputData(Image(30, 30, 1, [](int i, int j) { return Ramp(i, j) + (i * j) % 7; }));
    drainage->Update();
    good &= Check(drainage->GetOutput()->GetNumberOfPoints() == 900, "nothing is drained after a refusal");
  }
#endif
  return good;
}

/// Given points count in the memory that is asked for, in one message.
bool GivenIsCounted()
{
  bool good = true;
#ifdef __linux__
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(1000000);
  points->GetData()->Fill(0.0);
  vtkNew<vtkPolyData> given;
  given->SetPoints(points);
  vtkNew<vtkDrainageFilter> drainage;
  drainage->SetInputData(Image(30, 30, 1, Ramp));
  drainage->SetMethodToGrowth();
  vtkNew<ErrorCounter> errors;
  errors->Watch(drainage);
  long pages = 0;
  std::ifstream status("/proc/self/statm");
  for (int field = 0; field < 6; ++field)
  {
    status >> pages; // the sixth: data and stacks
  }
  rlimit before;
  getrlimit(RLIMIT_DATA, &before);
  rlimit limit = before;
  limit.rlim_cur = static_cast<rlim_t>(pages) * sysconf(_SC_PAGESIZE) + (static_cast<rlim_t>(200) << 20);
  if (!IsSanitized && before.rlim_max == RLIM_INFINITY && setrlimit(RLIMIT_DATA, &limit) == 0)
  {
    good &= errors->ExpectOneNaming("There is no Target");
    drainage->SetInputData(3, given);
    good &= errors->ExpectOneNaming("of memory");
    setrlimit(RLIMIT_DATA, &before);
  }
#endif
  return good;
}

}

int TestDrainageFilter(int, char*[])
{
  return CarvedGroundDrains() && TargetIsTaken() && GrownGroundDrains() && QuiltedGroundDrains() && RockIsUsed() &&
      GivenIsHeld() && StatisticsAreTaken() && OutletsAreChosen() && PartsAreOfOneWhole() && TilesAreOfOneWhole() &&
      HolesAreOutside() && BadInput() && BadTiles() && MemoryIsAsked() && GivenIsCounted()
    ? EXIT_SUCCESS
    : EXIT_FAILURE;
}
