// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Volumes written and read back with OpenVDB: values, places in the world, names and remarks, sparseness, composites,
// threads, series, and every bad input with the old file untouched.
#include "Check.h"
#include "ErrorCounter.h"
#include "TestFolder.h"
#include "vtkVDBVolumeWriter.h"
#include "vtkWindFieldSource.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArraySelection.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include <sys/resource.h>

namespace
{

namespace fs = std::filesystem;
using Writer = vtkVDBVolumeWriter;
using Image = vtkSmartPointer<vtkImageData>;

fs::path folder;

std::string InFolder(const std::string& name)
{
  return (folder / name).string();
}

/// The size of a file in the folder [bytes].
double SizeOf(const std::string& name)
{
  return static_cast<double>(fs::file_size(folder / name));
}

std::string BytesOf(const fs::path& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

std::size_t FilesInFolder()
{
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

/// A number from -1 to 1 that looks like noise.
float Noise(int n)
{
  return static_cast<float>(std::fmod(std::sin(12.9898 * n + 1.0) * 43758.5453, 1.0));
}

template <typename Array = vtkFloatArray>
vtkSmartPointer<Array> Numbers(const char* name, vtkIdType tuples, int components)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  for (vtkIdType n = 0; n < tuples * components; ++n)
  {
    const float number = 3.0f * Noise(static_cast<int>(n));
    if constexpr (std::is_integral_v<typename Array::ValueType>)
    {
      // By way of int: those below 0 wrap.
      array->SetValue(n, static_cast<typename Array::ValueType>(static_cast<int>(number)));
    }
    else
    {
      array->SetValue(n, number);
    }
  }
  return array;
}

/// Cells that are no cubes, indices that start below 0, an origin 1000 km away and a turn: 23 x 14 x 9 points.
Image TurnedImage()
{
  auto image = Image::New();
  image->SetExtent(-5, 17, 3, 16, -4, 4);
  image->SetOrigin(-1000000.25, 2000.5, -3.75);
  image->SetSpacing(0.7, 1.3, 2.9);
  const double angle = 0.4;
  image->SetDirectionMatrix(
    std::cos(angle), -std::sin(angle), 0.0, std::sin(angle), std::cos(angle), 0.0, 0.0, 0.0, 1.0);
  const auto density = Numbers("density", image->GetNumberOfPoints(), 1);
  density->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), "kg/m^3");
  image->GetPointData()->AddArray(density);
  image->GetPointData()->AddArray(Numbers("velocity", image->GetNumberOfPoints(), 3));
  image->GetPointData()->SetNormals(Numbers("normals", image->GetNumberOfPoints(), 3));
  image->GetPointData()->AddArray(Numbers<vtkDoubleArray>("heat", image->GetNumberOfPoints(), 1));
  image->GetPointData()->AddArray(Numbers("pair", image->GetNumberOfPoints(), 2));
  image->GetPointData()->AddArray(Numbers<vtkUnsignedCharArray>("color", image->GetNumberOfPoints(), 3));
  image->GetCellData()->AddArray(Numbers("perCell", image->GetNumberOfCells(), 1));
  vtkNew<vtkStringArray> unit;
  unit->SetName("heatUnit");
  unit->InsertNextValue("K");
  image->GetFieldData()->AddArray(unit);
  vtkNew<vtkDoubleArray> period;
  period->SetName("Period");
  period->InsertNextValue(12.5);
  image->GetFieldData()->AddArray(period);
  image->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), 7.25);
  return image;
}

struct Read
{
  openvdb::GridPtrVecPtr Grids;
  openvdb::MetaMap::Ptr Remarks;

  openvdb::GridBase::Ptr Find(const std::string& name) const { return openvdb::findGridByName(*this->Grids, name); }
  template <typename Grid>
  typename Grid::Ptr Get(const std::string& name) const
  {
    const auto grid = this->Find(name);
    return grid ? openvdb::gridPtrCast<Grid>(grid) : nullptr;
  }
};

Read ReadFile(const std::string& name)
{
  openvdb::io::File file(InFolder(name));
  file.setCopyMaxBytes(0);
  file.open(false);
  return { file.getGrids(), file.getMetadata() };
}

bool Write(Writer* writer, vtkDataObject* data, const std::string& name)
{
  writer->SetInputData(data);
  writer->SetFileName(InFolder(name).c_str());
  return Check(writer->Write() == 1, "Write() says it failed for " + name);
}

/// The largest distance of a voxel's place from the sample's, in metres.
double MaximumOffset(vtkImageData* image, const openvdb::GridBase& grid, bool cells)
{
  const int* extent = image->GetExtent();
  double largest = 0.0;
  for (int z = extent[4]; z <= extent[5] - cells; ++z)
  {
    for (int y = extent[2]; y <= extent[3] - cells; ++y)
    {
      for (int x = extent[0]; x <= extent[1] - cells; ++x)
      {
        const double shift = cells ? 0.5 : 0.0;
        const double index[3] = { x + shift, y + shift, z + shift };
        double wanted[3];
        image->TransformContinuousIndexToPhysicalPoint(index, wanted);
        const openvdb::Vec3d place = grid.indexToWorld(openvdb::Coord(x, y, z));
        largest = std::max(largest, (place - openvdb::Vec3d(wanted)).length());
      }
    }
  }
  return largest;
}

/// The largest difference of a grid's values from an array's.
template <typename Grid>
double LargestDifference(vtkImageData* image, const Grid& grid, vtkDataArray* array, bool cells, int component = 0)
{
  const int* extent = image->GetExtent();
  const auto accessor = grid.getConstAccessor();
  double largest = 0.0;
  vtkIdType place = 0;
  for (int z = extent[4]; z <= extent[5] - cells; ++z)
  {
    for (int y = extent[2]; y <= extent[3] - cells; ++y)
    {
      for (int x = extent[0]; x <= extent[1] - cells; ++x, ++place)
      {
        const auto value = accessor.getValue(openvdb::Coord(x, y, z));
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, float>)
        {
          const float wanted = static_cast<float>(array->GetComponent(place, component));
          largest = std::max<double>(largest, std::fabs(value - wanted));
        }
        else
        {
          for (int axis = 0; axis < 3; ++axis)
          {
            const float wanted = static_cast<float>(array->GetComponent(place, axis));
            largest = std::max<double>(largest, std::fabs(value[axis] - wanted));
          }
        }
      }
    }
  }
  return largest;
}

bool CheckValuesAndPlaces()
{
  const Image image = TurnedImage();
  vtkPointData* points = image->GetPointData();
  bool good = true;
  for (const int compression : { Writer::NoCompression, Writer::Zip, Writer::Blosc })
  {
    vtkNew<Writer> writer;
    writer->SetCompression(compression);
    good &= Write(writer, image, "turned.vdb");
    const Read read = ReadFile("turned.vdb");
    good &= Check(read.Grids->size() == 8, "There are not 8 grids");
    for (const char* name : { "density", "heat", "perCell" })
    {
      const bool cells = std::string(name) == "perCell";
      const auto grid = read.Get<openvdb::FloatGrid>(name);
      if (!Check(grid != nullptr, std::string("There is no float grid ") + name))
      {
        return false;
      }
      vtkDataArray* array = cells ? image->GetCellData()->GetArray(name) : points->GetArray(name);
      good &= Check(LargestDifference(image, *grid, array, cells) == 0.0, std::string("Values differ: ") + name);
      // A metre at 1000 km is known to 1e-10 m in double precision.
      const double offset = MaximumOffset(image, *grid, cells);
      good &= Check(offset < 1e-9, "A sample is " + std::to_string(offset) + " m away");
      good &= Check(grid->getGridClass() == openvdb::GRID_FOG_VOLUME, "No fog volume");
      good &=
        Check(grid->activeVoxelCount() == static_cast<openvdb::Index64>(array->GetNumberOfTuples()), "Active voxels");
    }
    for (const char* name : { "velocity", "normals", "color" })
    {
      const auto grid = read.Get<openvdb::Vec3SGrid>(name);
      if (!Check(grid != nullptr, std::string("There is no vec3s grid ") + name))
      {
        return false;
      }
      good &= Check(LargestDifference(image, *grid, points->GetArray(name), false) == 0.0, "Vectors differ");
      good &= Check(grid->isInWorldSpace(), "Vectors are not in world space");
    }
    for (const int component : { 0, 1 })
    {
      const auto grid = read.Get<openvdb::FloatGrid>("pair_" + std::to_string(component));
      good &=
        Check(grid && LargestDifference(image, *grid, points->GetArray("pair"), false, component) == 0.0, "Pairs");
    }
    good &= Check(read.Find("velocity")->getVectorType() == openvdb::VEC_CONTRAVARIANT_RELATIVE, "velocity's type");
    good &= Check(read.Find("normals")->getVectorType() == openvdb::VEC_COVARIANT_NORMALIZE, "normals' type");
    good &= Check(read.Find("color")->getVectorType() == openvdb::VEC_INVARIANT, "color's type");
    good &= Check(read.Find("density")->metaValue<std::string>("unit") == "kg/m^3", "unit of the array");
    good &= Check(read.Find("heat")->metaValue<std::string>("unit") == "K", "unit of the field data");
    good &= Check(!(*read.Find("velocity"))["unit"], "a unit from nowhere");
    good &= Check(read.Find("density")->metaValue<double>("time") == 7.25, "time");
    good &= Check(read.Remarks->metaValue<double>("time") == 7.25, "time of the file");
    good &= Check(read.Remarks->metaValue<double>("Period") == 12.5, "field data of the file");
  }
  return good;
}

/// Straight images: places are right to the bit, and cubic cells make the map that some readers insist on.
bool CheckStraightMaps()
{
  bool good = true;
  for (const double height : { 0.1, 0.3 })
  {
    auto image = Image::New();
    image->SetExtent(0, 12, 0, 10, -3, 3);
    image->SetOrigin(-17.3, 1e6, -0.7);
    image->SetSpacing(0.1, 0.1, height);
    image->GetPointData()->SetScalars(Numbers("density", image->GetNumberOfPoints(), 1));
    vtkNew<Writer> writer;
    good &= Write(writer, image, "straight.vdb");
    const auto grid = ReadFile("straight.vdb").Find("density");
    const std::string wanted = height == 0.1 ? "UniformScaleTranslateMap" : "ScaleTranslateMap";
    good &= Check(grid->transform().mapType() == wanted, "The map is a " + grid->transform().mapType());
    const double origin[3] = { -17.3, 1e6, -0.7 };
    const double spacing[3] = { 0.1, 0.1, height };
    for (int n = -3; n < 4; ++n)
    {
      const openvdb::Vec3d place = grid->indexToWorld(openvdb::Coord(n + 3, n + 3, n));
      const double index[3] = { n + 3.0, n + 3.0, static_cast<double>(n) };
      for (int axis = 0; axis < 3; ++axis)
      {
        good &= Check(place[axis] == origin[axis] + index[axis] * spacing[axis], "A place is not exact");
      }
    }
  }
  return good;
}

bool CheckHalfSize()
{
  auto image = Image::New();
  image->SetDimensions(64, 64, 64);
  image->GetPointData()->SetScalars(Numbers("noise", image->GetNumberOfPoints(), 1));
  vtkNew<Writer> writer;
  bool good = Write(writer, image, "single.vdb");
  writer->HalfFloatOn();
  good &= Write(writer, image, "half.vdb");
  const double single = SizeOf("single.vdb");
  return good & Check(SizeOf("half.vdb") < 0.6 * single, "Half precision does not make small files");
}

bool CheckHalf()
{
  const Image image = TurnedImage();
  vtkNew<Writer> writer;
  writer->HalfFloatOn();
  bool good = Write(writer, image, "half.vdb");
  const Read read = ReadFile("half.vdb");
  const auto density = read.Get<openvdb::FloatGrid>("density");
  const auto velocity = read.Get<openvdb::Vec3SGrid>("velocity");
  // Values reach 3: steps of half precision are 2^-9 there, and rounding is to the nearest.
  const double error = std::max(LargestDifference(image, *density, image->GetPointData()->GetArray("density"), false),
    LargestDifference(image, *velocity, image->GetPointData()->GetArray("velocity"), false));
  good &= Check(error > 0.0 && error <= 0x1p-10, "Half precision is off by " + std::to_string(error));
  good &= Check(density->saveFloatAsHalf(), "Not marked as half");
  good &= CheckHalfSize();

  vtkNew<ErrorCounter> errors;
  errors->Watch(writer);
  image->GetPointData()->GetArray("density")->SetComponent(7, 0, 65519.0);
  good &= Check(writer->Write() == 1, "65519 rounds to 65504");
  image->GetPointData()->GetArray("density")->SetComponent(7, 0, -65520.0);
  good &= errors->ExpectOneNaming("'density' reaches 65520");
  return good;
}

/// A ball of ones in a box of zeros with a little noise.
bool CheckTolerance()
{
  constexpr int side = 40;
  auto image = Image::New();
  image->SetDimensions(side, side, side);
  auto values = Numbers("ball", side * side * side, 1);
  openvdb::Index64 inside = 0;
  openvdb::Index64 notZero = 0;
  for (int n = 0; n < side * side * side; ++n)
  {
    const double x = n % side - 20.0, y = n / side % side - 20.0, z = n / (side * side) - 20.0;
    const bool in = x * x + y * y + z * z < 144.0;
    values->SetValue(n, in ? 1.0f : n % 5 ? 0.25f * std::fabs(Noise(n)) : n % 2 ? -0.0f : 0.0f);
    inside += in;
    notZero += values->GetValue(n) != 0.0f;
  }
  values->SetValue(0, 0.25f);
  image->GetPointData()->SetScalars(values);
  vtkNew<Writer> writer;
  bool good = Write(writer, image, "dense.vdb");
  const auto dense = ReadFile("dense.vdb").Get<openvdb::FloatGrid>("ball");
  good &= Check(dense->activeVoxelCount() == notZero + 1, "Zeros are stored, or others are not");
  good &= Check(LargestDifference(image, *dense, values, false) == 0.0, "Tolerance 0 loses something");

  writer->SetTolerance(0.25);
  good &= Write(writer, image, "sparse.vdb");
  const auto sparse = ReadFile("sparse.vdb").Get<openvdb::FloatGrid>("ball");
  good &= Check(sparse->activeVoxelCount() == inside, "The tolerance leaves other samples than the ball");
  good &= Check(LargestDifference(image, *sparse, values, false) <= 0.25, "The tolerance is exceeded");
  good &= Check(sparse->tree().activeTileCount() > 0, "Equal samples are not joined");
  good &= Check(SizeOf("sparse.vdb") < 0.2 * SizeOf("dense.vdb"), "Not sparse");

  // Blanked points are left out, and their values do not matter.
  auto ghosts = Numbers<vtkUnsignedCharArray>(vtkDataSetAttributes::GhostArrayName(), side * side * side, 1);
  ghosts->Fill(0);
  const vtkIdType center = 20 + side * (20 + side * 20);
  ghosts->SetValue(center, vtkDataSetAttributes::HIDDENPOINT);
  values->SetValue(center, std::numeric_limits<float>::quiet_NaN());
  image->GetPointData()->AddArray(ghosts);
  good &= Write(writer, image, "blank.vdb");
  const Read blank = ReadFile("blank.vdb");
  good &= Check(blank.Get<openvdb::FloatGrid>("ball")->activeVoxelCount() == inside - 1, "A blanked point is stored");
  good &= Check(blank.Grids->size() == 1, "Ghost flags are stored");
  return good;
}

/// The points of an extent with x + 100 y + 10000 z as values.
Image Piece(int x0, int x1, const char* name = "number")
{
  auto image = Image::New();
  image->SetExtent(x0, x1, 0, 9, 0, 4);
  auto values = Numbers(name, image->GetNumberOfPoints(), 1);
  for (vtkIdType n = 0; n < values->GetNumberOfValues(); ++n)
  {
    double at[3];
    image->GetPoint(n, at);
    values->SetValue(n, static_cast<float>(1.0 + at[0] + 100.0 * at[1] + 10000.0 * at[2]));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

bool CheckComposites()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Piece(0, 9));
  blocks->SetBlock(1, Piece(20, 29));
  blocks->SetBlock(2, nullptr);
  blocks->SetBlock(3, Piece(0, 5, "lonely"));
  blocks->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "Near");
  blocks->GetMetaData(3u)->Set(vtkCompositeDataSet::NAME(), "Far");
  vtkNew<Writer> writer;
  bool good = Write(writer, blocks, "blocks.vdb");
  const Read read = ReadFile("blocks.vdb");
  good &= Check(read.Grids->size() == 3, "There are not 3 grids");
  for (const char* name : { "Near_number", "Block1_number", "lonely" })
  {
    good &= Check(read.Get<openvdb::FloatGrid>(name) != nullptr, std::string("There is no grid ") + name);
  }
  good &= Check(read.Get<openvdb::FloatGrid>("Block1_number")->getConstAccessor().getValue({ 25, 3, 2 }) == 20326.0f,
    "A value of the second block");

  // Partitions are one grid, whatever leaves they share.
  vtkNew<vtkPartitionedDataSet> parts;
  parts->SetPartition(0, Piece(0, 10));
  parts->SetPartition(1, Piece(10, 23));
  parts->SetPartition(2, Piece(23, 29));
  good &= Write(writer, parts, "parts.vdb");
  good &= Write(writer, Piece(0, 29), "whole.vdb");
  good &= Check(BytesOf(InFolder("parts.vdb")) == BytesOf(InFolder("whole.vdb")), "Pieces differ from the whole");

  blocks->SetBlock(2, vtkNew<vtkPolyData>());
  writer->SetInputData(blocks);
  vtkNew<ErrorCounter> errors;
  errors->Watch(writer);
  good &= errors->ExpectOneNaming("vtkPolyData");
  return good;
}

bool CheckSelection()
{
  const Image image = TurnedImage();
  vtkNew<Writer> writer;
  for (const char* name : { "density", "velocity", "normals", "color", "pair" })
  {
    writer->GetPointDataArraySelection()->DisableArray(name);
  }
  bool good = Write(writer, image, "chosen.vdb");
  good &= Check(ReadFile("chosen.vdb").Grids->size() == 2, "Not the two arrays that are left");
  vtkNew<ErrorCounter> errors;
  errors->Watch(writer);
  writer->GetPointDataArraySelection()->DisableArray("heat");
  writer->GetCellDataArraySelection()->DisableArray("perCell");
  good &= errors->ExpectOneNaming("no array of numbers");
  return good;
}

/// The same bytes again and again, for any number of threads.
bool CheckBytes()
{
  const Image image = TurnedImage();
  vtkNew<Writer> writer;
  bool good = true;
  std::string first;
  for (const int threads : { 1, 2, 5 })
  {
    vtkSMPTools::Initialize(threads);
    good &= Write(writer, image, "bytes.vdb");
    const std::string bytes = BytesOf(InFolder("bytes.vdb"));
    good &= Check(first.empty() || bytes == first, "Bytes depend on the threads");
    first = bytes;
  }
  vtkSMPTools::Initialize(0);
  image->GetPointData()->GetArray("density")->SetComponent(11, 0, 0.125);
  good &= Write(writer, image, "bytes.vdb");
  good &= Check(BytesOf(InFolder("bytes.vdb")).substr(21, 36) != first.substr(21, 36), "Two files have one identifier");
  return good;
}

bool CheckSeries()
{
  vtkNew<vtkWindFieldSource> wind;
  wind->SetDimensions(10, 4, 3);
  vtkNew<Writer> writer;
  writer->SetInputConnection(wind->GetOutputPort());
  writer->WriteAllTimeStepsOn();
  writer->SetFileName(InFolder("wind.vdb").c_str());
  const std::size_t before = FilesInFolder();
  bool good = Check(writer->Write() == 1, "The series failed");
  good &= Check(FilesInFolder() == before + 10, "There are not ten files more");
  for (const int step : { 0, 9 })
  {
    const Read read = ReadFile("wind_000" + std::to_string(step) + ".vdb");
    const auto grid = read.Get<openvdb::Vec3SGrid>("Velocity");
    good &= Check(grid->metaValue<double>("time") == step * wind->GetTimeStep(), "The time of a step");
    good &= Check(grid->metaValue<std::string>("unit") == "m/s", "The unit of the wind");
    wind->UpdateTimeStep(step * wind->GetTimeStep());
    vtkImageData* image = wind->GetOutput();
    good &= Check(LargestDifference(image, *grid, image->GetPointData()->GetArray("Velocity"), false) == 0.0, "A step");
    good &= Check(MaximumOffset(image, *grid, false) < 1e-10, "The place of a step");
  }
  vtkNew<ErrorCounter> errors;
  errors->Watch(writer);
  writer->SetFileNameSuffix("_%s");
  good &= errors->ExpectOneNaming("FileNameSuffix");
  for (const char* number : { "", "%d", "%04d" })
  {
    writer->SetFileNameSuffix(std::string(100000, 'x') + number);
    good &= errors->ExpectOneNaming("FileNameSuffix");
  }
  // The whole name is too long, not the suffix; and letters stand between "%" and "d", of any number.
  writer->SetFileNameSuffix(std::string(250, 'x') + "%d");
  good &= errors->ExpectOneNaming("File name too long.");
  writer->SetFileNameSuffix("%" + std::string(100000, '0') + "d");
  good &= errors->ExpectOneNaming("FileNameSuffix");
  writer->SetFileNameSuffix("-%d.x");
  good &= Check(writer->Write() == 1 && fs::exists(InFolder("wind-7.x.vdb")), "Another suffix");
  return good;
}

/// One array under the name that renderers know; two volumes cannot have it.
bool CheckGridName()
{
  vtkNew<vtkWindFieldSource> wind;
  wind->SetDimensions(10, 4, 3);
  vtkNew<Writer> writer;
  writer->SetInputConnection(wind->GetOutputPort());
  writer->SetFileName(InFolder("named.vdb").c_str());
  writer->SetGridName("density");
  bool good = Check(writer->Write() == 1, "The named grid failed");
  const Read read = ReadFile("named.vdb");
  const auto grid = read.Get<openvdb::Vec3SGrid>("density");
  wind->Update();
  vtkImageData* image = wind->GetOutput();
  good &=
    Check(LargestDifference(image, *grid, image->GetPointData()->GetArray("Velocity"), false) == 0.0, "Its values");

  vtkNew<vtkImageData> two;
  two->DeepCopy(image);
  vtkNew<vtkFloatArray> more;
  more->SetName("More");
  more->SetNumberOfTuples(two->GetNumberOfPoints());
  more->FillValue(1.0f);
  two->GetPointData()->AddArray(more);
  writer->SetInputData(two);
  vtkNew<ErrorCounter> errors;
  errors->Watch(writer);
  good &= errors->ExpectOneNaming("GridName");
  writer->GetPointDataArraySelection()->DisableArray("More");
  good &= Check(writer->Write() == 1 && ReadFile("named.vdb").Get<openvdb::Vec3SGrid>("density"), "The chosen array");
  return good;
}

/// Each breaks an image or a writer; the message must hold the word.
struct BadCase
{
  const char* Word;
  std::function<void(vtkImageData*, Writer*)> Break;
};

const BadCase BadCases[] = {
  { "FileName is empty", [](vtkImageData*, Writer* writer) { writer->SetFileName(nullptr); } },
  { "no array of numbers",
    [](vtkImageData* image, Writer*) {
      image->GetPointData()->Initialize();
      image->GetCellData()->Initialize();
    } },
  { "'words' holds no numbers",
    [](vtkImageData* image, Writer*) {
      vtkNew<vtkStringArray> words;
      words->SetName("words");
      words->SetNumberOfValues(image->GetNumberOfPoints());
      image->GetPointData()->AddArray(words);
    } },
  { "the input is empty", [](vtkImageData* image, Writer*) { image->Initialize(); } },
  { "'short' has 5 values",
    [](vtkImageData* image, Writer*) { image->GetPointData()->AddArray(Numbers("short", 5, 1)); } },
  { "'velocity' holds a value that is not a finite single-precision number, first at index (-4, 3, -4)",
    [](vtkImageData* image, Writer*) {
      image->GetPointData()->GetArray("velocity")->SetComponent(1, 2, std::numeric_limits<double>::quiet_NaN());
    } },
  { "'perCell' holds a value that is not a finite",
    [](vtkImageData* image, Writer*) {
      image->GetCellData()->GetArray("perCell")->SetComponent(1, 0, -std::numeric_limits<double>::infinity());
    } },
  { "'heat' holds a value that is not a finite single-precision",
    [](vtkImageData* image, Writer*) { image->GetPointData()->GetArray("heat")->SetComponent(9, 0, 1e200); } },
  { "spacing", [](vtkImageData* image, Writer*) { image->SetSpacing(1.0, 0.0, 1.0); } },
  { "origin",
    [](vtkImageData* image, Writer*) { image->SetOrigin(std::numeric_limits<double>::infinity(), 0.0, 0.0); } },
  { "Tolerance", [](vtkImageData*, Writer* writer) { writer->SetTolerance(-1.0); } },
  { "Tolerance", [](vtkImageData*, Writer* writer) { writer->SetTolerance(std::nan("")); } },
  { "Cannot write x.vdb: there is no folder ",
    [](vtkImageData*, Writer* writer) { writer->SetFileName(InFolder("nowhere/x.vdb").c_str()); } },
  { "Cannot write x.vdb", [](vtkImageData*, Writer* writer) { writer->SetFileName("/proc/x.vdb"); } },
  { "it is a folder", [](vtkImageData*, Writer* writer) { writer->SetFileName(folder.string().c_str()); } },
  { "Cannot write null: it is not a regular file",
    [](vtkImageData*, Writer* writer) { writer->SetFileName("/dev/null"); } },
};

bool CheckBadInput()
{
  bool good = true;
  {
    std::ofstream(InFolder("old.vdb")) << "the old file";
  }
  const std::size_t before = FilesInFolder();
  for (const BadCase& bad : BadCases)
  {
    const Image image = TurnedImage();
    vtkNew<Writer> writer;
    writer->SetInputData(image);
    writer->SetFileName(InFolder("old.vdb").c_str());
    bad.Break(image, writer);
    vtkNew<ErrorCounter> errors;
    errors->Watch(writer);
    good &= errors->ExpectOneNaming(bad.Word);
    good &= Check(writer->GetErrorCode() != vtkErrorCode::NoError, "No error code");
    good &= Check(BytesOf(InFolder("old.vdb")) == "the old file" && FilesInFolder() == before,
      std::string("The old file has changed, or another is left: ") + bad.Word);
  }
  vtkNew<Writer> empty;
  empty->SetFileName(InFolder("old.vdb").c_str());
  vtkNew<ErrorCounter> errors;
  errors->Watch(empty);
  good &=
    Check(empty->Write() == 0 && errors->Count == 1 && errors->Last.find("there is no input.") != std::string::npos,
      "A writer without input: " + errors->Last);
  return good;
}

/// A folder where nobody may write. (Root may: then there is nothing to see.)
bool CheckUnwritableFolder()
{
  const fs::path closed = folder / "closed";
  fs::create_directory(closed);
  fs::permissions(closed, fs::perms::owner_read | fs::perms::owner_exec);
  const bool allowed = static_cast<bool>(std::ofstream(closed / "probe"));
  bool good = true;
  if (!allowed)
  {
    vtkNew<Writer> writer;
    writer->SetInputData(TurnedImage());
    writer->SetFileName((closed / "x.vdb").string().c_str());
    vtkNew<ErrorCounter> errors;
    errors->Watch(writer);
    good &= errors->ExpectOneNaming("x.vdb: Permission denied");
  }
  fs::permissions(closed, fs::perms::owner_all);
  fs::remove_all(closed);
  return good;
}

/// Files may grow no further for the life of this object, as on a disk that is full.
class FullDisk
{
public:
  explicit FullDisk(rlim_t bytes)
  {
    this->Handler = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &this->Limit);
    const rlimit small{ bytes, this->Limit.rlim_max };
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FullDisk()
  {
    setrlimit(RLIMIT_FSIZE, &this->Limit);
    std::signal(SIGXFSZ, this->Handler);
  }

private:
  rlimit Limit{};
  void (*Handler)(int) = SIG_DFL;
};

/// A symbolic link stays one, and what it leads to is replaced.
bool CheckLink()
{
  fs::create_symlink("led-to.vdb", folder / "link.vdb");
  vtkNew<Writer> writer;
  bool good = Write(writer, Piece(0, 9), "link.vdb");
  good &= Check(fs::is_symlink(folder / "link.vdb"), "The link was replaced");
  good &= Write(writer, Piece(0, 10), "link.vdb");
  good &= Check(fs::is_symlink(folder / "link.vdb"), "The link was replaced by the second file");
  good &= Check(!ReadFile("led-to.vdb").Grids->empty(), "The link leads to nothing");
  return good;
}

/// The disk fills up at the first byte, in the middle, and at the last byte.
bool CheckFullDisk()
{
  vtkNew<Writer> writer;
  bool good = Write(writer, TurnedImage(), "full.vdb");
  const std::string old = BytesOf(InFolder("full.vdb"));
  const std::size_t before = FilesInFolder();
  vtkNew<ErrorCounter> errors;
  errors->Watch(writer);
  const Image image = TurnedImage();
  image->GetPointData()->GetArray("density")->SetComponent(0, 0, 1.5);
  writer->SetInputData(image);
  for (const std::size_t room : { std::size_t{ 0 }, std::size_t{ 20000 }, old.size() - 1 })
  {
    {
      const FullDisk full(room);
      good &= errors->ExpectOneNaming("full.vdb: File too large");
    }
    good &= Check(BytesOf(InFolder("full.vdb")) == old, "The old file has changed");
    good &= Check(FilesInFolder() == before, "A temporary file is left");
  }
  good &= Check(writer->Write() == 1 && BytesOf(InFolder("full.vdb")) != old, "Not written when there is room again");
  return good;
}

/// Stopped at any progress: no message, no file, the old one whole.
bool CheckAbort()
{
  bool good = true;
  for (const double stop : { 0.0, 0.2, 0.5, 0.8 })
  {
    vtkNew<Writer> writer;
    good &= Write(writer, TurnedImage(), "stopped.vdb");
    const std::string old = BytesOf(InFolder("stopped.vdb"));
    const std::size_t before = FilesInFolder();
    double last = -1.0;
    bool rising = true;
    vtkNew<vtkCallbackCommand> watch;
    bool stopped = false;
    auto act = [&](double progress) {
      rising = rising && progress >= last;
      last = stopped ? last : progress; // the executive reports an end in any case
      if (progress >= stop)
      {
        stopped = true;
        writer->SetAbortExecute(1);
      }
    };
    watch->SetClientData(&act);
    watch->SetCallback([](vtkObject*, unsigned long, void* client, void* progress) {
      (*static_cast<decltype(act)*>(client))(*static_cast<double*>(progress));
    });
    writer->AddObserver(vtkCommand::ProgressEvent, watch);
    vtkNew<ErrorCounter> errors;
    errors->Watch(writer);
    const Image image = TurnedImage();
    image->GetPointData()->GetArray("density")->SetComponent(0, 0, 1.5);
    writer->SetInputData(image);
    good &= Check(writer->Write() == 0 && errors->Count == 0, "An abort is no success and no error");
    good &= Check(rising && last >= stop && last < 1.0, "Progress");
    good &= Check(BytesOf(InFolder("stopped.vdb")) == old && FilesInFolder() == before, "The old file after an abort");
  }
  return good;
}

}

int TestVDBVolumeWriter(int argc, char* argv[])
{
  folder = EmptyFolder(argc, argv, "TestVDBVolumeWriter");
  openvdb::initialize();
  const struct
  {
    const char* Name;
    bool (*Run)();
  } checks[] = { { "values and places", CheckValuesAndPlaces }, { "straight maps", CheckStraightMaps },
    { "half precision", CheckHalf }, { "tolerance", CheckTolerance }, { "composites", CheckComposites },
    { "selection", CheckSelection }, { "bytes", CheckBytes }, { "series", CheckSeries }, { "grid name", CheckGridName },
    { "bad input", CheckBadInput }, { "unwritable folder", CheckUnwritableFolder }, { "link", CheckLink },
    { "full disk", CheckFullDisk }, { "abort", CheckAbort } };
  bool good = true;
  for (const auto& check : checks)
  {
    const bool passed = check.Run();
    std::cout << check.Name << ": " << (passed ? "passed" : "FAILED") << std::endl;
    good &= passed;
  }
  fs::remove_all(folder);
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
