// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainLevelOfDetailFilter.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/Blocks.h"
#include "Data/FrameArrays.h"
#include "Data/GroundWetness.h"
#include "Data/Inputs.h"
#include "Data/Tables.h"
#include "Geometry/ViewFrustum.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/DataStamp.h"
#include "Pipeline/Pipeline.h"
#include "Pipeline/Ranges.h"
#include "Terrain/GroundColor.h"
#include "Terrain/TerrainLevels.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkTerrainLevelOfDetailFilter);

namespace
{

/// Colors of samples, each found when it is first shown: three bytes and Known. Threads may find the same one at once.
using FoundColors = std::vector<std::atomic<std::uint32_t>>;
constexpr std::uint32_t Known = 1u << 24;

}

/// The pyramid, and what it was made of.
class vtkTerrainLevelOfDetailFilter::vtkInternals
{
public:
  std::optional<littoral::TerrainPyramid> Pyramid;
  std::vector<double> Wetness; ///< of each sample, or none
  FoundColors Colors;
  std::vector<littoral::TerrainPatch> Patches; ///< of all tiles: those of the last view stay where levels do
  littoral::FrameArrays Arrays;
  littoral::DataStamp Image;
  littoral::ArrayStamp Heights;
  int TileSize = 0;
  int Levels = 0;
};

namespace
{

/// A mesh that becomes part of a block, and where in it.
struct Part
{
  const littoral::TerrainMesh* Mesh;
  int Level;
  vtkIdType FirstPoint;
  vtkIdType FirstTriangle;
};

/// The meshes of a block one after the other.
struct Layout
{
  std::vector<Part> Parts;
  vtkIdType Points = 0;
  vtkIdType Triangles = 0;

  void Add(const littoral::TerrainMesh& mesh, int level)
  {
    if (!mesh.Triangles.empty())
    {
      this->Parts.push_back({ &mesh, level, this->Points, this->Triangles });
      this->Points += static_cast<vtkIdType>(mesh.Samples.size());
      this->Triangles += static_cast<vtkIdType>(mesh.Triangles.size() / 3);
    }
  }
};

/// Pairs of an array of the image and its copy in a block.
using CarriedArrays = std::vector<std::pair<vtkDataArray*, vtkSmartPointer<vtkDataArray>>>;

/// Empty copies of what is carried along. Bits are not: threads cannot write neighbouring ones.
CarriedArrays NewCarriedArrays(vtkImageData* image, vtkDataArray* heights, vtkIdType tuples)
{
  CarriedArrays carried;
  vtkPointData* from = image->GetPointData();
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = from->GetArray(i);
    if (!array || !array->GetName() || array == heights || array->GetDataType() == VTK_BIT)
    {
      continue;
    }
    const std::string name = array->GetName();
    const bool isOwn = name == "Elevation" || name == "Normals" || name == "TCoords";
    if (!name.empty() && !isOwn && name != vtkDataSetAttributes::GhostArrayName()) // hidden points are not there
    {
      vtkSmartPointer<vtkDataArray> copy;
      copy.TakeReference(array->NewInstance());
      copy->SetName(array->GetName());
      copy->SetNumberOfComponents(array->GetNumberOfComponents());
      littoral::SetTuples(copy, tuples);
      carried.emplace_back(array, copy);
    }
  }
  return carried;
}

/// Colors of the ground, or nothing where the image has its own or none are wanted.
class GroundPainter
{
public:
  GroundPainter(const littoral::TerrainPyramid& pyramid, const std::vector<double>& wetness, vtkImageData* image,
    bool paints, FoundColors& found)
    : Pyramid(pyramid)
    , Wetness(wetness)
    , Found(found)
    , Reflectance(littoral::ArrayReader::OfPoints(image, "The image").Seek("Reflectance", 1))
    , Paints(paints && !image->GetPointData()->HasArray("RGB"))
  {
    float lowest = std::numeric_limits<float>::infinity();
    float highest = -lowest;
    for (const littoral::TerrainTile& tile : pyramid.GetTiles())
    {
      lowest = tile.IsEmpty ? lowest : std::min(lowest, static_cast<float>(tile.Bounds.Low.z));
      highest = tile.IsEmpty ? highest : std::max(highest, static_cast<float>(tile.Bounds.High.z));
    }
    this->Lowest = lowest;
    this->Relief = std::max(static_cast<double>(highest) - this->Lowest, 1e-9);
    if (this->Paints && found.empty())
    {
      found = FoundColors(pyramid.GetSamples().Values.size());
    }
  }

  explicit operator bool() const { return this->Paints; }

  littoral::Color operator()(std::size_t sample) const
  {
    std::uint32_t color = this->Found[sample].load(std::memory_order_relaxed);
    if (color == 0)
    {
      const littoral::Color own = this->ColorOf(sample);
      color = Known | own[0] << 16 | own[1] << 8 | own[2];
      this->Found[sample].store(color, std::memory_order_relaxed);
    }
    const auto byte = [color](int shift) { return static_cast<unsigned char>(color >> shift & 0xff); };
    return { byte(16), byte(8), byte(0) };
  }

private:
  littoral::Color ColorOf(std::size_t sample) const
  {
    littoral::GroundPlace place;
    place.Slope = std::acos(std::min(1.0, static_cast<double>(this->Pyramid.GetNormal(sample)[2])));
    place.Height = (this->Pyramid.GetSamples().Values[sample] - this->Lowest) / this->Relief;
    if (this->Reflectance)
    {
      place.Reflectance = this->Reflectance->GetComponent(static_cast<vtkIdType>(sample), 0);
    }
    place.Wetness = this->Wetness.empty() ? place.Wetness : this->Wetness[sample];
    return littoral::GroundColor(place);
  }

  const littoral::TerrainPyramid& Pyramid;
  const std::vector<double>& Wetness; ///< of each sample, or none
  FoundColors& Found;
  vtkDataArray* Reflectance;
  bool Paints;
  double Lowest = 0.0;
  double Relief = 1.0;
};

/// The arrays of a block.
class BlockArrays
{
public:
  BlockArrays(const Layout& layout, const littoral::TerrainPyramid& pyramid, const GroundPainter& painter,
    vtkImageData* image, vtkDataArray* heights, littoral::FrameArrays& frame)
    : Pyramid(pyramid)
    , Painter(painter)
    , Positions(New<vtkDoubleArray>(frame, "Points", 3, layout.Points))
    , Elevation(New<vtkFloatArray>(frame, "Elevation", 1, layout.Points))
    , Normals(New<vtkFloatArray>(frame, "Normals", 3, layout.Points))
    , Coordinates(New<vtkFloatArray>(frame, "TCoords", 2, layout.Points))
    , Levels(New<vtkIntArray>(frame, "Level", 1, layout.Triangles))
    , Offsets(New<vtkTypeInt64Array>(frame, "Offsets", 1, layout.Triangles + 1))
    , Connectivity(New<vtkTypeInt64Array>(frame, "Connectivity", 1, 3 * layout.Triangles))
    , Colors(New<vtkUnsignedCharArray>(frame, "RGB", 3, painter ? layout.Points : 0))
    , Carried(NewCarriedArrays(image, heights, layout.Points))
    , Ranges(layout.Parts.size())
  {
    this->Offsets->SetValue(layout.Triangles, 3 * layout.Triangles);
  }

  void CopyPart(const Part& part, std::size_t index)
  {
    this->CopyPoints(part.Mesh->Samples, part.FirstPoint);
    this->FindRanges(part, this->Ranges[index]);
    const std::vector<int>& corners = part.Mesh->Triangles;
    std::transform(corners.begin(), corners.end(), this->Connectivity->GetPointer(3 * part.FirstTriangle),
      [&part](int corner) { return part.FirstPoint + corner; });
    const auto triangles = static_cast<vtkIdType>(corners.size() / 3);
    vtkTypeInt64* offsets = this->Offsets->GetPointer(0);
    for (vtkIdType i = part.FirstTriangle; i < part.FirstTriangle + triangles; ++i)
    {
      offsets[i] = 3 * i;
    }
    std::fill_n(this->Levels->GetPointer(part.FirstTriangle), triangles, part.Level);
  }

  vtkSmartPointer<vtkPolyData> MakeBlock() const
  {
    this->KeepRanges();
    auto block = vtkSmartPointer<vtkPolyData>::New();
    block->SetPoints(littoral::PointsWithRanges(this->Positions));
    vtkNew<vtkCellArray> triangles;
    triangles->SetData(this->Offsets, this->Connectivity);
    block->SetPolys(triangles);
    vtkPointData* arrays = block->GetPointData();
    for (const auto& pair : this->Carried)
    {
      arrays->AddArray(pair.second);
    }
    arrays->SetScalars(this->Elevation);
    if (this->Painter)
    {
      arrays->AddArray(this->Colors);
    }
    if (arrays->HasArray("RGB"))
    {
      arrays->SetActiveScalars("RGB");
    }
    arrays->SetNormals(this->Normals);
    arrays->SetTCoords(this->Coordinates);
    block->GetCellData()->AddArray(this->Levels);
    return block;
  }

private:
  /// An array of a frame. The next view may need some more.
  template <typename Array>
  static vtkSmartPointer<Array> New(littoral::FrameArrays& frame, const char* name, int components, vtkIdType tuples)
  {
    return frame.New<Array>(name, components, tuples, 0, tuples / 8);
  }

  /// Ranges of a part, found while its points are in the cache.
  struct PartRanges
  {
    littoral::TupleRanges Positions;
    littoral::TupleRanges Elevation;
    littoral::TupleRanges Normals;
    littoral::TupleRanges Coordinates;
    littoral::TupleRanges Colors;
    littoral::TupleRanges Levels;
  };

  void FindRanges(const Part& part, PartRanges& ranges) const
  {
    const auto add = [&part](auto* array, littoral::TupleRanges& range) {
      const vtkIdType components = array->GetNumberOfComponents();
      const auto* first = array->GetPointer(components * part.FirstPoint);
      range.AddTuples(
        first, first + components * static_cast<vtkIdType>(part.Mesh->Samples.size()), static_cast<int>(components));
    };
    add(this->Positions.Get(), ranges.Positions);
    add(this->Normals.Get(), ranges.Normals);
    add(this->Coordinates.Get(), ranges.Coordinates);
    if (this->Painter)
    {
      add(this->Colors.Get(), ranges.Colors);
    }
    ranges.Elevation.Components[0] = ranges.Positions.Components[2];
    ranges.Elevation.AreFinite = ranges.Positions.AreFinite;
    ranges.Levels.Components[0].Add(part.Level);
  }

  void KeepRanges() const
  {
    const auto keep = [this](vtkDataArray* array, littoral::TupleRanges PartRanges::*ranges) {
      std::vector<littoral::TupleRanges> parts;
      std::transform(this->Ranges.begin(), this->Ranges.end(), std::back_inserter(parts),
        [ranges](const PartRanges& part) { return part.*ranges; });
      littoral::KeepRangesOfParts(array, parts);
    };
    keep(this->Positions, &PartRanges::Positions);
    keep(this->Elevation, &PartRanges::Elevation);
    keep(this->Normals, &PartRanges::Normals);
    keep(this->Coordinates, &PartRanges::Coordinates);
    keep(this->Colors, &PartRanges::Colors);
    keep(this->Levels, &PartRanges::Levels);
  }

  /// Copies samples to the points from the first on.
  void CopyPoints(const std::vector<std::size_t>& samples, vtkIdType first)
  {
    const littoral::HeightSamples& grid = this->Pyramid.GetSamples();
    const std::size_t width = static_cast<std::size_t>(grid.Width);
    double* position = this->Positions->GetPointer(3 * first);
    float* elevation = this->Elevation->GetPointer(first);
    float* normal = this->Normals->GetPointer(3 * first);
    float* coordinate = this->Coordinates->GetPointer(2 * first);
    for (const std::size_t sample : samples)
    {
      const auto row = static_cast<double>(sample / width);
      const auto column = static_cast<double>(sample % width);
      *position++ = grid.Origin[0] + column * grid.Spacing[0];
      *position++ = grid.Origin[1] + row * grid.Spacing[1];
      *position++ = grid.Values[sample];
      *elevation++ = grid.Values[sample];
      for (const float part : this->Pyramid.GetNormal(sample))
      {
        *normal++ = part;
      }
      *coordinate++ = static_cast<float>(column / (grid.Width - 1));
      *coordinate++ = static_cast<float>(row / (grid.Height - 1));
    }
    if (this->Painter)
    {
      unsigned char* color = this->Colors->GetPointer(3 * first);
      std::for_each(samples.begin(), samples.end(),
        [&](std::size_t sample) { color = std::copy_n(this->Painter(sample).data(), 3, color); });
    }
    for (const auto& pair : this->Carried)
    {
      vtkIdType point = first;
      std::for_each(samples.begin(), samples.end(),
        [&](std::size_t sample) { pair.second->SetTuple(point++, static_cast<vtkIdType>(sample), pair.first); });
    }
  }

  const littoral::TerrainPyramid& Pyramid;
  const GroundPainter& Painter;
  vtkSmartPointer<vtkDoubleArray> Positions;
  vtkSmartPointer<vtkFloatArray> Elevation;
  vtkSmartPointer<vtkFloatArray> Normals;
  vtkSmartPointer<vtkFloatArray> Coordinates;
  vtkSmartPointer<vtkIntArray> Levels;
  vtkSmartPointer<vtkTypeInt64Array> Offsets; ///< VTK holds the memory of a vtkIdTypeArray, but not the array
  vtkSmartPointer<vtkTypeInt64Array> Connectivity;
  vtkSmartPointer<vtkUnsignedCharArray> Colors;
  CarriedArrays Carried;
  std::vector<PartRanges> Ranges; ///< of parts
};

/// Makes a block of its parts, each on a thread of its own.
vtkSmartPointer<vtkPolyData> MakeBlock(const Layout& layout, const littoral::TerrainPyramid& pyramid,
  const GroundPainter& painter, vtkImageData* image, vtkDataArray* heights, littoral::FrameArrays& frame)
{
  BlockArrays arrays(layout, pyramid, painter, image, heights, frame);
  littoral::SmpFor(layout.Parts.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      arrays.CopyPart(layout.Parts[i], i);
    }
  });
  return arrays.MakeBlock();
}

/// Terrain as a view shows it: the patches of its tiles, sorted into blocks by level, seams last.
struct ShownTerrain
{
  std::vector<Layout> Layouts;
  double Tiles = 0.0;
  double LargestError = 0.0; ///< [pixels]

  explicit ShownTerrain(const littoral::TerrainPyramid& pyramid)
    : Layouts(static_cast<std::size_t>(pyramid.GetLevels()) + 1)
  {
  }

  /// Sorts the patches.
  void Sort(const littoral::TerrainPyramid& pyramid, const std::vector<int>& levels,
    const std::vector<littoral::TerrainPatch>& patches, const littoral::ViewFrustum& view)
  {
    const std::vector<littoral::TerrainTile>& tiles = pyramid.GetTiles();
    for (std::size_t tile = 0; tile < tiles.size(); ++tile)
    {
      const int level = levels[tile];
      if (level != littoral::Culled)
      {
        this->Layouts[static_cast<std::size_t>(level)].Add(patches[tile].Surface, level);
        this->Layouts.back().Add(patches[tile].Seams, level);
        this->LargestError = std::max(this->LargestError, littoral::ScreenErrorOf(tiles[tile], level, view));
        this->Tiles += 1.0;
      }
    }
  }
};

/// The blocks are the levels, then the seams.
std::string BlockName(int block, int levels)
{
  return block == levels ? "Seams" : "Level" + std::to_string(block);
}

/// The blocks of a piece without tiles.
void AddEmptyBlocks(vtkMultiBlockDataSet* output, int levels)
{
  for (int block = 0; block <= levels; ++block)
  {
    littoral::AddBlock(output, BlockName(block, levels).c_str(), vtkSmartPointer<vtkPolyData>::New());
  }
}

void AddCount(vtkDataObject* data, const char* name, double value)
{
  vtkNew<vtkDoubleArray> field;
  field->SetName(name);
  field->InsertNextValue(value);
  data->GetFieldData()->AddArray(field);
}

/// About what a sample takes at most, here and in the output [bytes].
double BytesASample(vtkImageData* image)
{
  double carried = 0.0;
  for (int i = 0; i < image->GetPointData()->GetNumberOfArrays(); ++i)
  {
    if (vtkDataArray* array = image->GetPointData()->GetArray(i))
    {
      carried += array->GetNumberOfComponents() * array->GetDataTypeSize();
    }
  }
  return 200.0 + carried;
}

}

//----------------------------------------------------------------------------
vtkTerrainLevelOfDetailFilter::vtkTerrainLevelOfDetailFilter()
  : Selection(PixelErrorRule)
  , PixelError(1.0)
  , NumberOfLevels(5)
  , TileSize(32)
  , UseCulling(true)
  , GroundColors(true)
  , Internals(new vtkInternals)
{
  this->NearDistance = 250.0;
  this->FarDistance = 4000.0;
}

//----------------------------------------------------------------------------
vtkTerrainLevelOfDetailFilter::~vtkTerrainLevelOfDetailFilter() = default;

//----------------------------------------------------------------------------
int vtkTerrainLevelOfDetailFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  // Whole, not a block at a time: levels of several blocks do not go into one output, which is then said once.
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//----------------------------------------------------------------------------
int vtkTerrainLevelOfDetailFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  littoral::RequestAll(inputVector[0]->GetInformationObject(0));
  return 1;
}

//----------------------------------------------------------------------------
void vtkTerrainLevelOfDetailFilter::CheckProperties()
{
  const bool isPowerOfTwo = (this->TileSize & (this->TileSize - 1)) == 0;
  littoral::ParameterCheck check;
  check.Choice("Selection", this->Selection, { "distance", "pixel error" });
  check.Positive("PixelError", this->PixelError, "pixels");
  check.Count("NumberOfLevels", this->NumberOfLevels, 1, littoral::MaximumTerrainLevels);
  check.Require(this->TileSize >= 1 && this->TileSize <= 4096 && isPowerOfTwo, "TileSize", this->TileSize, "cells",
    "a power of two from 1 to 4096");
  littoral::Require(check.Reason());
}

//----------------------------------------------------------------------------
vtkDataArray* vtkTerrainLevelOfDetailFilter::FindHeights(vtkImageData* image, vtkInformationVector** inputVector)
{
  littoral::RequireRaster(image, 2);
  vtkInformation* choice = this->GetInputArrayInformation(0);
  const char* name = choice->Get(vtkDataObject::FIELD_NAME());
  const bool isNamed = name && !littoral::NamesNoArray(choice);
  const bool isChosen = isNamed || (!name && choice->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE()));
  vtkDataArray* heights = isChosen ? this->GetInputArrayToProcess(0, inputVector)
                                   : littoral::ArrayReader::OfPoints(image, "The image").Any("Elevation");
  if (!heights && (!isChosen || littoral::NamesDefaultElevation(choice)))
  {
    heights = image->GetPointData()->GetScalars();
  }
  if (!heights)
  {
    littoral::Refuse(
      "The image has no ", isNamed ? "array '" + std::string(name) + "'" : "point scalars", " to take as elevation.");
  }
  if (heights->GetNumberOfTuples() != image->GetNumberOfPoints() || heights->GetNumberOfComponents() != 1)
  {
    littoral::Refuse("The array '", heights->GetName() ? heights->GetName() : "",
      "' is no elevation: it is a vector or lies on cells.");
  }
  return heights;
}

//----------------------------------------------------------------------------
void vtkTerrainLevelOfDetailFilter::CheckHeights(vtkDataArray* heights)
{
  const std::string array = std::string("array '") + (heights->GetName() ? heights->GetName() : "") + "'.";
  bool isAnyThere = false;
  for (vtkIdType i = 0; i < heights->GetNumberOfTuples(); ++i)
  {
    const float height = static_cast<float>(heights->GetComponent(i, 0));
    if (std::isinf(height))
    {
      littoral::Refuse("The elevation is infinite at point ", i, " of the ", array);
    }
    isAnyThere = isAnyThere || !std::isnan(height);
  }
  littoral::Require(isAnyThere ? "" : "The elevation is NaN at all points of the " + array);
}

//----------------------------------------------------------------------------
void vtkTerrainLevelOfDetailFilter::UpdatePyramid(vtkImageData* image, vtkDataArray* heights)
{
  vtkInternals& internals = *this->Internals;
  const littoral::DataStamp stamp = littoral::StampOf(image);
  const littoral::ArrayStamp heightsStamp = littoral::StampOf(heights);
  if (internals.Pyramid && internals.Image == stamp && internals.Heights == heightsStamp &&
    internals.TileSize == this->TileSize && internals.Levels == this->NumberOfLevels)
  {
    return;
  }
  internals.Pyramid.reset();
  internals.Colors.clear();
  internals.Patches.clear();
  const double bytes = BytesASample(image) * static_cast<double>(image->GetNumberOfPoints());
  littoral::RequireMemory(bytes, "the terrain in levels", "take a part of it or a coarser one");
  this->CheckHeights(heights);
  littoral::HeightSamples samples;
  int dimensions[3];
  image->GetDimensions(dimensions);
  samples.Width = dimensions[0];
  samples.Height = dimensions[1];
  double corner[3];
  image->GetPoint(0, corner);
  samples.Origin = { corner[0], corner[1] };
  samples.Spacing = { image->GetSpacing()[0], image->GetSpacing()[1] };
  littoral::SetSize(samples.Values, image->GetNumberOfPoints());
  const littoral::Poll poll = littoral::PollOf(this);
  littoral::SteppedPoll steps(poll);
  for (std::size_t i = 0; i < samples.Values.size(); ++i)
  {
    steps.Step();
    samples.Values[i] = static_cast<float>(heights->GetComponent(static_cast<vtkIdType>(i), 0));
  }
  internals.Wetness = littoral::SpreadWetness(image, heights, littoral::AbortableFor(this));
  // Last, for an abort must not leave it with the stamps of another image.
  internals.Pyramid.emplace(std::move(samples), this->TileSize, this->NumberOfLevels, littoral::AbortableFor(this));
  internals.Patches.resize(internals.Pyramid->GetTiles().size());
  internals.Image = stamp;
  internals.Heights = heightsStamp;
  internals.TileSize = this->TileSize;
  internals.Levels = this->NumberOfLevels;
}

//----------------------------------------------------------------------------
littoral::TerrainRule vtkTerrainLevelOfDetailFilter::MakeRule() const
{
  littoral::TerrainRule rule;
  rule.ByPixelError = this->Selection == PixelErrorRule;
  rule.NearDistance = this->NearDistance;
  rule.FarDistance = this->FarDistance;
  rule.MaximumPixels = this->PixelError / this->DetailFactor;
  rule.UseCulling = this->UseCulling;
  return rule;
}

//----------------------------------------------------------------------------
int vtkTerrainLevelOfDetailFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* image = nullptr;
  littoral::InContext("Cannot make levels: ", [&] {
    image = littoral::InputOf<vtkImageData>(inputVector[0], "Input");
    littoral::RequireUpright(image, "Input");
    if (this->GroundColors)
    {
      littoral::RequireColorable(image, "the image");
    }
  });
  vtkMultiBlockDataSet* output = vtkMultiBlockDataSet::GetData(outputVector);
  this->CheckProperties();
  const littoral::View seen = this->GetView();
  vtkDataArray* heights = this->FindHeights(image, inputVector);
  if (littoral::AsksForLaterPiece(request, outputVector))
  {
    this->CheckHeights(heights);
    AddEmptyBlocks(output, littoral::LevelsOfTiles(this->TileSize, this->NumberOfLevels));
    return 1;
  }
  this->UpdatePyramid(image, heights);
  const littoral::TerrainPyramid& pyramid = *this->Internals->Pyramid;
  const littoral::ViewFrustum view(seen);
  const std::vector<int> levels = littoral::SelectLevels(pyramid, view, this->MakeRule());
  std::vector<littoral::TerrainPatch>& patches = this->Internals->Patches;
  const auto makePatch = [&](std::size_t tile) {
    if (levels[tile] == littoral::Culled)
    {
      patches[tile] = {};
    }
    else if (patches[tile].Levels != littoral::PatchLevelsOf(pyramid, levels, tile))
    {
      patches[tile] = littoral::MakePatch(pyramid, levels, tile);
    }
  };
  if (!littoral::RunWithProgress(this, levels.size(), 0.2, 0.6, makePatch))
  {
    return 1;
  }
  ShownTerrain shown(pyramid);
  shown.Sort(pyramid, levels, patches, view);
  const GroundPainter painter(pyramid, this->Internals->Wetness, image, this->GroundColors, this->Internals->Colors);
  const std::size_t blocks = shown.Layouts.size();
  this->Internals->Arrays.BeginFrame();
  double polygons = 0.0;
  for (std::size_t block = 0; block < blocks; ++block)
  {
    if (littoral::IsAborted(this))
    {
      output->Initialize();
      return 1;
    }
    const std::string name = BlockName(static_cast<int>(block), pyramid.GetLevels());
    littoral::AddBlock(
      output, name.c_str(), MakeBlock(shown.Layouts[block], pyramid, painter, image, heights, this->Internals->Arrays));
    polygons += static_cast<double>(shown.Layouts[block].Triangles);
    this->UpdateProgress(0.6 + 0.4 * static_cast<double>(block + 1) / static_cast<double>(blocks));
  }
  this->Internals->Arrays.EndFrame();
  const littoral::HeightSamples& samples = pyramid.GetSamples();
  AddCount(output, "TilesShown", shown.Tiles);
  AddCount(output, "TilesInAll", static_cast<double>(levels.size()));
  AddCount(output, "PolygonsShown", polygons);
  AddCount(output, "PolygonsAtFullDetail", 2.0 * (samples.Width - 1) * (samples.Height - 1));
  AddCount(output, "MaximumScreenError", shown.LargestError);
  littoral::KeepRanges(output, littoral::PollOf(this));
  return 1;
}

//----------------------------------------------------------------------------
void vtkTerrainLevelOfDetailFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Selection: " << this->Selection << "\n";
  os << indent << "PixelError: " << this->PixelError << "\n";
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
  os << indent << "TileSize: " << this->TileSize << "\n";
  os << indent << "UseCulling: " << (this->UseCulling ? "on" : "off") << "\n";
  os << indent << "GroundColors: " << (this->GroundColors ? "on" : "off") << "\n";
}
