// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Terrain in levels of detail: arrays, counters, same bytes on any threads, what is kept, bad input, a picture.
#include "CameraPicture.h"
#include "Check.h"
#include "ErrorCounter.h"
#include "vtkTerrainLevelOfDetailFilter.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkTriangle.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace
{

using Filter = vtkTerrainLevelOfDetailFilter;

constexpr int Width = 203;
constexpr int Height = 150;

vtkSmartPointer<vtkImageData> Hills(int width = Width, int height = Height, int depth = 1)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, depth);
  image->SetSpacing(10.0, 10.0, 1.0);
  image->SetOrigin(500.0, -200.0, 0.0);
  vtkNew<vtkFloatArray> heights;
  heights->SetName("Elevation");
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("RGB");
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double x = static_cast<double>(i % width);
    const double y = static_cast<double>(i / width % height);
    heights->InsertNextValue(static_cast<float>(
      120.0 * std::sin(0.05 * x) * std::cos(0.07 * y) + 15.0 * std::sin(0.6 * x + 0.2 * y) * std::sin(0.5 * y)));
    colors->InsertNextTuple3(static_cast<double>(i % 251), static_cast<double>(i % 7), 100);
  }
  image->GetPointData()->AddArray(colors);
  image->GetPointData()->SetScalars(heights);
  return image;
}

void LookAcross(Filter* filter)
{
  filter->SetViewPoint(1500.0, -500.0, 400.0);
  filter->SetViewDirection(0.0, 1.0, -0.3);
  filter->SetSelectionToDistance();
  filter->SetNearDistance(600.0);
  filter->SetFarDistance(1500.0);
}

vtkPolyData* BlockOf(Filter* filter, unsigned int block)
{
  return vtkPolyData::SafeDownCast(filter->GetOutput()->GetBlock(block));
}

double CountOf(Filter* filter, const char* name)
{
  vtkDataArray* array = filter->GetOutput()->GetFieldData()->GetArray(name);
  return array ? array->GetTuple1(0) : std::numeric_limits<double>::quiet_NaN();
}

bool PointsAreThoseOfTheImage(vtkPolyData* block, vtkImageData* image)
{
  vtkDataArray* heights = image->GetPointData()->GetArray("Elevation");
  vtkDataArray* colors = image->GetPointData()->GetArray("RGB");
  vtkPointData* arrays = block->GetPointData();
  bool good = true;
  for (vtkIdType i = 0; i < block->GetNumberOfPoints(); ++i)
  {
    double point[3];
    block->GetPoint(i, point);
    const vtkIdType x = std::lround((point[0] - 500.0) / 10.0);
    const vtkIdType y = std::lround((point[1] + 200.0) / 10.0);
    const vtkIdType sample = y * Width + x;
    const double* tcoords = arrays->GetTCoords()->GetTuple2(i);
    good &= point[2] == heights->GetTuple1(sample) && arrays->GetArray("Elevation")->GetTuple1(i) == point[2];
    good &= arrays->GetArray("RGB")->GetComponent(i, 0) == colors->GetComponent(sample, 0);
    good &= std::abs(tcoords[0] - static_cast<double>(x) / (Width - 1.0)) < 1e-6 &&
      std::abs(tcoords[1] - static_cast<double>(y) / (Height - 1.0)) < 1e-6;
    const double* normal = arrays->GetNormals()->GetTuple3(i);
    good &= normal[2] > 0.0 && std::abs(std::hypot(std::hypot(normal[0], normal[1]), normal[2]) - 1.0) < 1e-6;
  }
  return good;
}

bool Data()
{
  const auto image = Hills();
  vtkNew<Filter> filter;
  filter->SetInputData(image);
  LookAcross(filter);
  filter->Update();
  bool good = Check(filter->GetOutput()->GetNumberOfBlocks() == 6, "not five levels and the seams");
  double polygons = 0.0;
  for (unsigned int block = 0; good && block < 6; ++block)
  {
    const std::string name = block == 5 ? "Seams" : "Level" + std::to_string(block);
    vtkPolyData* data = BlockOf(filter, block);
    good &= Check(name == filter->GetOutput()->GetMetaData(block)->Get(vtkCompositeDataSet::NAME()), name);
    good &= Check(data && data->GetNumberOfCells() > 0, name + " is empty");
    good = good && Check(PointsAreThoseOfTheImage(data, image), name + " has points that are not the image's");
    double range[2];
    data->GetCellData()->GetArray("Level")->GetRange(range);
    good &= Check(block == 5 ? range[0] >= 1 && range[1] <= 4 : range[0] == block && range[1] == block, "Level");
    polygons += static_cast<double>(data->GetNumberOfCells());
  }
  good &= Check(CountOf(filter, "PolygonsShown") == polygons, "PolygonsShown");
  good &= Check(CountOf(filter, "PolygonsAtFullDetail") == 2.0 * (Width - 1) * (Height - 1), "PolygonsAtFullDetail");
  good &= Check(CountOf(filter, "TilesInAll") == 7 * 5, "TilesInAll");
  good &= Check(CountOf(filter, "TilesShown") > 5 && CountOf(filter, "TilesShown") < 35, "TilesShown");
  good &= Check(CountOf(filter, "MaximumScreenError") > 0.0, "MaximumScreenError");

  filter->SetSelection(Filter::PixelErrorRule);
  filter->SetPixelError(20.0);
  filter->Update();
  const double coarse = CountOf(filter, "PolygonsShown");
  good &= Check(CountOf(filter, "MaximumScreenError") <= 20.0, "the error on the screen is above PixelError");
  filter->SetPixelError(1e-6);
  filter->Update();
  good &= Check(CountOf(filter, "PolygonsShown") > coarse, "a smaller error takes no more polygons");
  filter->UseCullingOff();
  filter->Update();
  good &= Check(CountOf(filter, "PolygonsShown") == CountOf(filter, "PolygonsAtFullDetail"), "no full detail");
  return good;
}

bool SameBytes(vtkDataArray* a, vtkDataArray* b)
{
  return a->GetNumberOfValues() == b->GetNumberOfValues() && a->GetNumberOfValues() > 0 &&
    std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
      static_cast<std::size_t>(a->GetNumberOfValues()) * a->GetDataTypeSize()) == 0;
}

bool SameBlocks(vtkMultiBlockDataSet* one, vtkMultiBlockDataSet* two)
{
  bool good = true;
  for (unsigned int block = 0; block < 6; ++block)
  {
    vtkPolyData* a = vtkPolyData::SafeDownCast(one->GetBlock(block));
    vtkPolyData* b = vtkPolyData::SafeDownCast(two->GetBlock(block));
    good &= SameBytes(a->GetPoints()->GetData(), b->GetPoints()->GetData());
    good &= SameBytes(a->GetPolys()->GetConnectivityArray(), b->GetPolys()->GetConnectivityArray());
    good &= SameBytes(a->GetPointData()->GetNormals(), b->GetPointData()->GetNormals());
    good &= SameBytes(a->GetCellData()->GetArray("Level"), b->GetCellData()->GetArray("Level"));
    good &= SameBytes(a->GetPolys()->GetOffsetsArray(), b->GetPolys()->GetOffsetsArray());
    good &= SameBytes(a->GetPointData()->GetArray("RGB"), b->GetPointData()->GetArray("RGB"));
  }
  return good;
}

bool SameBlocks(Filter* one, Filter* two)
{
  return SameBlocks(one->GetOutput(), two->GetOutput());
}

/// Whether two filters show the same polygons of each level.
bool SamePolygons(Filter* one, Filter* two)
{
  bool good = CountOf(one, "PolygonsShown") == CountOf(two, "PolygonsShown") && CountOf(one, "PolygonsShown") > 0.0;
  for (unsigned int block = 0; block < 6; ++block)
  {
    good &= BlockOf(one, block)->GetNumberOfPolys() == BlockOf(two, block)->GetNumberOfPolys();
  }
  return good;
}

/// A detail factor is that of the viewport, or of the distances; the error is told as it is on the screen.
bool DetailFactor()
{
  const auto image = Hills();
  vtkNew<Filter> factored;
  vtkNew<Filter> other;
  for (Filter* filter : { factored.Get(), other.Get() })
  {
    filter->SetInputData(image);
    LookAcross(filter);
    filter->SetSelectionToPixelError();
  }
  factored->SetDetailFactor(0.25);
  other->SetPixelError(4.0);
  factored->Update();
  other->Update();
  bool good = Check(SamePolygons(factored, other), "a detail factor is not that of the viewport");
  good &= Check(CountOf(factored, "MaximumScreenError") == CountOf(other, "MaximumScreenError"), "MaximumScreenError");
  for (Filter* filter : { factored.Get(), other.Get() })
  {
    filter->SetSelectionToDistance();
  }
  other->SetNearDistance(0.25 * other->GetNearDistance());
  other->SetFarDistance(0.25 * other->GetFarDistance());
  factored->Update();
  other->Update();
  good &= Check(SamePolygons(factored, other), "a detail factor is not that of the distances");
  factored->SetDetailFactor(1.0);
  factored->Update();
  return good & Check(!SamePolygons(factored, other), "a detail factor changes nothing");
}

/// The same bytes on one and two threads, whatever was seen before, and no trace of an earlier terrain.
bool Reproducible()
{
  const auto image = Hills();
  vtkNew<Filter> one;
  vtkNew<Filter> two;
  for (Filter* filter : { one.Get(), two.Get() })
  {
    vtkSMPTools::Initialize(filter == one ? 1 : 2);
    filter->SetInputData(image);
    LookAcross(filter);
    filter->Update();
  }
  bool good = Check(SameBlocks(one, two), "the output depends on the number of threads");
  two->SetViewPoint(900.0, 900.0, 50.0);
  two->Update();
  LookAcross(two);
  two->Update();
  good &= Check(SameBlocks(one, two), "the output depends on an earlier view");
  vtkDataArray* heights = image->GetPointData()->GetArray("Elevation");
  for (vtkIdType i = 0; i < heights->GetNumberOfTuples(); ++i)
  {
    heights->SetTuple1(i, 0.5 * heights->GetTuple1(i));
  }
  heights->Modified();
  two->Update();
  good &= Check(PointsAreThoseOfTheImage(BlockOf(two, 0), image), "the terrain of before is shown");
  return good;
}

/// Whether the ranges of arrays are those of their values.
bool RangesAreTrue(vtkFieldData* arrays)
{
  bool good = true;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = arrays->GetArray(i);
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      double low = VTK_DOUBLE_MAX;
      double high = -low;
      for (vtkIdType tuple = 0; tuple < array->GetNumberOfTuples(); ++tuple)
      {
        low = std::min(low, array->GetComponent(tuple, c));
        high = std::max(high, array->GetComponent(tuple, c));
      }
      good &= Check(array->GetRange(c)[0] == low && array->GetRange(c)[1] == high, array->GetName());
    }
  }
  return good;
}

/// A walk of an eye: what a filter keeps from view to view shows nowhere, and a picture that is held stays.
bool Walk()
{
  const auto image = Hills();
  image->GetPointData()->RemoveArray("RGB"); // colors are found
  vtkNew<Filter> walking;
  walking->SetInputData(image);
  LookAcross(walking);
  bool good = true;
  vtkNew<vtkMultiBlockDataSet> held;
  vtkNew<vtkMultiBlockDataSet> copy;
  for (int step = 0; step < 6; ++step)
  {
    vtkNew<Filter> fresh;
    fresh->SetInputData(image);
    LookAcross(fresh);
    for (Filter* filter : { walking.Get(), fresh.Get() })
    {
      filter->SetViewPoint(1400.0 + 35.0 * step, -500.0, 400.0);
      filter->Update();
    }
    good &= Check(SameBlocks(walking, fresh), "a view depends on those before");
    good &= RangesAreTrue(BlockOf(walking, 0)->GetPointData()) && RangesAreTrue(BlockOf(walking, 0)->GetCellData());
    good &= Check(step == 0 || SameBlocks(held, copy), "a later view changes a picture that is held");
    if (step % 2 == 0)
    {
      held->ShallowCopy(walking->GetOutput());
      copy->DeepCopy(walking->GetOutput());
    }
  }
  return good;
}

/// Counts the progress of a filter, and aborts it when it comes for the last time.
struct Abort
{
  int Last;
  int Count = 0;

  static void Hear(vtkObject* caller, unsigned long, void* data, void*)
  {
    auto* own = static_cast<Abort*>(data);
    static_cast<Filter*>(caller)->SetAbortExecute(++own->Count >= own->Last ? 1 : 0);
  }
};

/// A terrain whose making was aborted, at any place, is not taken for the one before.
bool Aborted()
{
  const auto image = Hills();
  const auto other = Hills();
  vtkNew<vtkFloatArray> areas; // wet ground takes a time of its own
  areas->SetName("DrainageArea");
  areas->SetNumberOfTuples(other->GetNumberOfPoints());
  areas->FillValue(1000.0f);
  other->GetPointData()->AddArray(areas);
  vtkDataArray* heights = other->GetPointData()->GetArray("Elevation");
  for (vtkIdType i = 0; i < heights->GetNumberOfTuples(); ++i)
  {
    heights->SetTuple1(i, 0.5 * heights->GetTuple1(i));
  }
  vtkNew<Filter> fresh;
  fresh->SetInputData(image);
  LookAcross(fresh);
  fresh->Update();
  vtkNew<Filter> filter;
  filter->SetInputData(image);
  LookAcross(filter);
  filter->Update();
  bool good = true;
  bool isAborted = true;
  for (int last = 1; isAborted; last += 2)
  {
    Abort abort{ last };
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(Abort::Hear);
    command->SetClientData(&abort);
    const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, command);
    filter->SetInputData(other);
    filter->Update();
    filter->RemoveObserver(tag);
    isAborted = filter->GetAbortExecute() != 0;
    filter->SetAbortExecute(0);
    filter->SetInputData(image);
    filter->Update();
    good &= Check(SameBlocks(filter, fresh), "abort " + std::to_string(last) + " leaves another terrain");
  }
  return good;
}

/// The first piece has the terrain, another the same blocks without it.
bool Pieces()
{
  bool good = true;
  for (const int tileSize : { 32, 4 })
  {
    vtkNew<Filter> first;
    vtkNew<Filter> second;
    for (Filter* filter : { first.Get(), second.Get() })
    {
      filter->SetInputData(Hills());
      filter->SetTileSize(tileSize);
      LookAcross(filter);
      filter->UpdatePiece(filter == second ? 1 : 0, 2, 0);
    }
    const unsigned int blocks = first->GetOutput()->GetNumberOfBlocks();
    good &= Check(blocks == (tileSize == 4 ? 4 : 6), std::to_string(blocks) + " blocks in the first piece");
    good &= Check(first->GetOutput()->GetNumberOfPoints() > 0, "the first piece is empty");
    good &= Check(second->GetOutput()->GetNumberOfBlocks() == blocks, "another number of blocks in a later piece");
    for (unsigned int block = 0; good && block < blocks; ++block)
    {
      const auto name = [block](Filter* filter) {
        return std::string(filter->GetOutput()->GetMetaData(block)->Get(vtkCompositeDataSet::NAME()));
      };
      good &= Check(name(first) == name(second), "blocks of pieces have other names");
      vtkPolyData* later = BlockOf(second, block);
      good &= Check(later && later->GetNumberOfPoints() == 0, "a later piece has terrain or no blocks");
    }
  }
  return good;
}

bool Fails(const char* word, const std::function<void(Filter*)>& spoil, vtkImageData* image = nullptr)
{
  vtkNew<Filter> filter;
  filter->SetInputData(image ? image : Hills().Get());
  spoil(filter);
  vtkNew<ErrorCounter> errors;
  errors->Watch(filter);
  return Check(errors->ExpectOneNaming(word) && filter->GetOutput()->GetNumberOfBlocks() == 0, word);
}

/// The active scalars stand in for an Elevation that is absent, also if it is chosen by name.
bool DefaultArray()
{
  bool good = true;
  for (const char* name : { "", "Elevation", "Height" })
  {
    const auto image = Hills();
    image->GetPointData()->GetArray("Elevation")->SetName("Height");
    image->GetPointData()->SetActiveScalars("Height");
    vtkNew<Filter> filter;
    filter->SetInputData(image);
    filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
    filter->Update();
    good &= Check(filter->GetOutput()->GetNumberOfBlocks() > 0, name);
  }
  return good;
}

bool BadInput()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto nothing = [](Filter*) {};
  const auto peak = Hills();
  peak->GetPointData()->GetArray("Elevation")->SetTuple1(77, std::numeric_limits<double>::infinity());
  const auto nowhere = Hills();
  nowhere->GetPointData()->GetArray("Elevation")->FillComponent(0, nan);
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(5, 5, 1);
  bool good = Fails("infinite at point 77", nothing, peak);
  good &= Fails("NaN at all points", nothing, nowhere);
  good &= Fails("scalars", nothing, bare);
  good &= Fails("1 x 9 x 1", nothing, Hills(1, 9));
  good &= Fails("x 2 points", nothing, Hills(9, 9, 2));
  for (const double spacing : { 0.0, -1.0 })
  {
    const auto flat = Hills(9, 9);
    flat->SetSpacing(spacing, 1.0, 1.0);
    good &= Fails("Spacing, x", nothing, flat);
    flat->SetSpacing(1.0, spacing, 1.0);
    good &= Fails("Spacing, y", nothing, flat);
  }
  const auto choose = [](const char* name, int association) {
    return [=](Filter* f) { f->SetInputArrayToProcess(0, 0, 0, association, name); };
  };
  good &= Fails("'Depth'", choose("Depth", vtkDataObject::FIELD_ASSOCIATION_POINTS));
  good &= Fails("'RGB'", choose("RGB", vtkDataObject::FIELD_ASSOCIATION_POINTS));
  for (const int size : { 0, -4, 12, 8192 })
  {
    good &= Fails("TileSize", [=](Filter* f) { f->SetTileSize(size); });
  }
  good &= Fails("NumberOfLevels", [](Filter* f) { f->SetNumberOfLevels(0); });
  good &= Fails("NumberOfLevels", [](Filter* f) { f->SetNumberOfLevels(9); });
  good &= Fails("PixelError", [](Filter* f) { f->SetPixelError(0.0); });
  good &= Fails("PixelError", [=](Filter* f) { f->SetPixelError(nan); });
  good &= Fails("Selection", [](Filter* f) { f->SetSelection(2); });
  good &= Fails("ViewAngle", [](Filter* f) { f->SetViewAngle(180.0); });
  good &= Fails("ParallelScale", [](Filter* f) {
    f->ParallelProjectionOn();
    f->SetParallelScale(-1.0);
  });
  good &= Fails("FarDistance", [](Filter* f) { f->SetFarDistance(1.0); });
  return good;
}

/// The farthest that any sample on the picture is from the surface that is shown, and how many are on it at all but
/// have none.
void MeasureError(Filter* filter, vtkImageData* image, const CameraPicture& picture, double& largest, int& holes)
{
  vtkDataArray* heights = image->GetPointData()->GetArray("Elevation");
  std::vector<char> isCovered(static_cast<std::size_t>(image->GetNumberOfPoints()), 0);
  largest = 0.0;
  for (unsigned int block = 0; block < 5; ++block)
  {
    vtkPolyData* data = BlockOf(filter, block);
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
    {
      double bounds[6];
      double corners[3][3];
      data->GetCellBounds(cell, bounds);
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      data->GetCellPoints(cell, count, ids);
      for (int k = 0; k < 3; ++k)
      {
        data->GetPoint(ids[k], corners[k]);
      }
      const auto gridAt = [](double place, double origin) {
        return static_cast<int>(std::lround((place - origin) / 10.0));
      };
      for (int y = gridAt(bounds[2], -200.0); y <= gridAt(bounds[3], -200.0); ++y)
      {
        for (int x = gridAt(bounds[0], 500.0); x <= gridAt(bounds[1], 500.0); ++x)
        {
          const vtkIdType sample = static_cast<vtkIdType>(y) * Width + x;
          const double full[3] = { 500.0 + 10.0 * x, -200.0 + 10.0 * y, heights->GetTuple1(sample) };
          double shares[3];
          double flat[3][2];
          for (int k = 0; k < 3; ++k)
          {
            std::copy_n(corners[k], 2, flat[k]);
          }
          vtkTriangle::BarycentricCoords(full, flat[0], flat[1], flat[2], shares);
          if (*std::min_element(shares, shares + 3) < -1e-9)
          {
            continue;
          }
          isCovered[sample] = 1;
          const double height = shares[0] * corners[0][2] + shares[1] * corners[1][2] + shares[2] * corners[2][2];
          const double shown[3] = { full[0], full[1], height };
          if (picture.Shows(full) || picture.Shows(shown))
          {
            largest = std::max(largest, picture.PixelsBetween(full, shown));
          }
        }
      }
    }
  }
  holes = 0;
  for (vtkIdType sample = 0; sample < image->GetNumberOfPoints(); ++sample)
  {
    double place[3];
    image->GetPoint(sample, place);
    place[2] = heights->GetTuple1(sample);
    holes += isCovered[sample] == 0 && picture.Shows(place) ? 1 : 0;
  }
}

/// PixelError holds through the matrices of any camera, all over the picture, and nothing on it is culled.
bool ScreenErrorHolds()
{
  const auto image = Hills();
  vtkNew<Filter> filter;
  filter->SetInputData(image);
  filter->SetSelection(Filter::PixelErrorRule);
  filter->SetTileSize(16);
  vtkNew<vtkCamera> camera;
  const double middle[3] = { 1500.0, 550.0, 0.0 };
  std::mt19937 random(5);
  bool good = true;
  double worst = 0.0;
  int coarse = 0;
  for (int round = 0; round < 40; ++round)
  {
    LookFromAnywhere(camera, random, middle, 1500.0);
    const int size[2] = { 300 + 150 * (round % 7), 900 - 120 * (round % 5) };
    filter->SetAspectRatio(static_cast<double>(size[0]) / size[1]);
    filter->SetViewHeight(size[1]);
    filter->SetPixelError(2.0 + round % 5);
    filter->SetMoveTolerance(round % 3 == 0 ? 15.0 : 0.0);
    filter->SetTurnTolerance(round % 3 == 0 ? 1.0 : 0.0);
    filter->SetCamera(camera);
    filter->Update();
    double largest = 0.0;
    int holes = 0;
    MeasureError(filter, image, CameraPicture(camera, size[0], size[1]), largest, holes);
    worst = std::max(worst, largest / filter->GetPixelError());
    coarse += CountOf(filter, "PolygonsShown") < 0.5 * CountOf(filter, "PolygonsAtFullDetail") ? 1 : 0;
    good &= Check(largest <= filter->GetPixelError(),
      "off by " + std::to_string(largest) + " pixels, PixelError " + std::to_string(filter->GetPixelError()) +
        (camera->GetParallelProjection() ? ", parallel" : ", perspective"));
    good &= Check(holes == 0, std::to_string(holes) + " samples on the picture are culled");
  }
  return good & Check(worst > 0.8 && coarse > 10, "the test sees no coarse level: " + std::to_string(worst));
}

void AddBlock(vtkRenderer* renderer, vtkPolyData* block, const std::array<double, 3>& color)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(block);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  renderer->AddActor(actor);
}

}

int TestTerrainLevelOfDetail(int argc, char* argv[])
{
  if (!Data() || !DetailFactor() || !Reproducible() || !Walk() || !Aborted() || !Pieces() || !DefaultArray() ||
    !BadInput() || !ScreenErrorHolds())
  {
    return EXIT_FAILURE;
  }
  vtkNew<Filter> filter;
  filter->SetInputData(Hills());
  LookAcross(filter);
  filter->UseCullingOff();
  filter->Update();
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.9, 0.93, 0.97);
  const std::array<std::array<double, 3>, 6> colors{ { { 0.2, 0.5, 0.2 }, { 0.5, 0.6, 0.2 }, { 0.8, 0.7, 0.3 },
    { 0.8, 0.5, 0.3 }, { 0.7, 0.4, 0.5 }, { 1.0, 0.0, 0.0 } } };
  for (unsigned int block = 0; block < 6; ++block)
  {
    AddBlock(renderer, BlockOf(filter, block), colors[block]);
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(1500.0, -1500.0, 1500.0);
  camera->SetFocalPoint(1500.0, 450.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(40.0);
  renderer->ResetCameraClippingRange();
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(300, 200);
  window->AddRenderer(renderer);
  window->Render();
  return !vtkRegressionTestImage(window);
}
