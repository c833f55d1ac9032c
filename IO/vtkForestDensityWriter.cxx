// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkForestDensityWriter.h"

#include "Data/ArrayReader.h"
#include "Data/Inputs.h"
#include "GatheredPoints.h"
#include "Numerics/ParameterCheck.h"
#include "PalmFile.h"
#include "Pipeline/Pipeline.h"
#include "Plants/CanopyDensity.h"
#include "Plants/ForestFiles.h"
#include "ReplacedFile.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkForestDensityWriter);

namespace
{

constexpr double UsualMaximum = 0.7;
constexpr double BytesOfRow = 400.0; ///< at most, while the text grows

/// The cells of an image.
littoral::CanopyGrid GridOf(vtkImageData* image)
{
  littoral::RequireUpright(image, "the image");
  int extent[6];
  image->GetExtent(extent);
  littoral::CanopyGrid grid;
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.Spacing[axis] = image->GetSpacing()[axis];
    grid.Count[axis] = extent[2 * axis + 1] - extent[2 * axis];
    grid.Origin[axis] = image->GetOrigin()[axis] + extent[2 * axis] * grid.Spacing[axis];
    littoral::Require(grid.Count[axis] > 0 ? "" : "the image has no cells; it needs two points along each axis");
  }
  littoral::Require(littoral::WhyInvalid(grid));
  return grid;
}

/// Checks densities of cells; the number of those that are not 0.
std::size_t CheckDensities(vtkDataArray* array, const char* unit, const littoral::Poll& poll)
{
  std::size_t filled = 0;
  littoral::SteppedPoll steps(poll);
  for (vtkIdType cell = 0; cell < array->GetNumberOfTuples(); ++cell)
  {
    steps.Step();
    const double density = array->GetComponent(cell, 0);
    if (!(density >= 0.0 && littoral::IsSensible(density)))
    {
      littoral::Refuse(
        array->GetName(), " of cell ", cell, " is ", density, " ", unit, "; it must be finite and not negative");
    }
    filled += density > 0.0 ? 1 : 0;
  }
  return filled;
}

/// Level 0 of PALM is the ground: an image of heights above it must begin there. Throws InvalidInput.
void RequireOnGround(vtkImageData* image, const littoral::CanopyGrid& grid)
{
  const bool isAboveGround = littoral::ArrayReader::OfFields(image, "the image").Has("HeightsAboveGround");
  if (isAboveGround && std::abs(grid.Origin.z) > 1e-6 * grid.Spacing.z)
  {
    littoral::Refuse("the image begins at ", grid.Origin.z,
      " m above the ground, and PALM's levels at the ground; let Bounds begin at z = 0");
  }
}

/// A number of a tree that must be positive.
double PositiveOf(vtkDataArray* array, vtkIdType tree)
{
  littoral::ParameterCheck check;
  check.Positive(std::string(array->GetName()) + " of tree " + std::to_string(tree), array->GetComponent(tree, 0));
  littoral::Require(check.Reason());
  return array->GetComponent(tree, 0);
}

}

//----------------------------------------------------------------------------
vtkForestDensityWriter::vtkForestDensityWriter()
  : vtkSingleFileWriter("a forest")
{
  this->SetOriginTime("2000-06-21 12:00:00 +00");
}

//----------------------------------------------------------------------------
vtkForestDensityWriter::~vtkForestDensityWriter()
{
  this->SetOriginTime(nullptr);
}

//----------------------------------------------------------------------------
int vtkForestDensityWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//----------------------------------------------------------------------------
void vtkForestDensityWriter::WriteWhole(const FillFile& fill)
{
  this->SetProgressText("Writing forest");
  this->Conclude(littoral::WriteFile(this->FileName, [&](littoral::ReplacedFile& file) {
    file.OnWrite([&](std::size_t) {
      if (littoral::IsAborted(this))
      {
        throw littoral::WriteStopped();
      }
    });
    fill(file.Stream());
    return file.Close() && file.Commit();
  }));
}

//----------------------------------------------------------------------------
void vtkForestDensityWriter::WriteImage(vtkImageData* image, const std::string& extension)
{
  littoral::RequireFit(image, "the image");
  const littoral::CanopyGrid grid = GridOf(image);
  vtkDataArray* array = littoral::ArrayReader::OfCells(image, "the image").Need("BulkDensity", 1);
  const std::size_t filled = CheckDensities(array, "kg/m3", littoral::PollOf(this));
  const bool isFds = extension == ".bdf";
  littoral::Require(isFds ? littoral::WhyNoFds(filled) : littoral::WhyNoQuicFire(grid));
  const auto densityOf = [array](std::size_t cell) { return array->GetComponent(static_cast<vtkIdType>(cell), 0); };
  this->WriteWhole([&](std::ostream& file) {
    const littoral::TakeBytes take = [&](const std::string& bytes) {
      file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    };
    isFds ? littoral::WriteFdsDensity(grid, densityOf, take) : littoral::WriteQuicFireDensity(grid, densityOf, take);
  });
}

//----------------------------------------------------------------------------
void vtkForestDensityWriter::WritePalm(vtkImageData* image)
{
  littoral::ParameterCheck check;
  check.Range("Latitude", this->Latitude, -90.0, 90.0, "degrees");
  check.Range("Longitude", this->Longitude, -180.0, 360.0, "degrees");
  littoral::Require(check.Reason());
  littoral::RequireFit(image, "the image");
  const littoral::CanopyGrid grid = GridOf(image);
  RequireOnGround(image, grid);
  const littoral::ArrayReader cells = littoral::ArrayReader::OfCells(image, "the image");
  vtkDataArray* leaves = cells.Need("LeafAreaDensity", 1);
  vtkDataArray* plants = cells.Find("PlantAreaDensity", 1);
  const littoral::Poll poll = littoral::PollOf(this);
  CheckDensities(leaves, "m2/m3", poll);
  if (plants)
  {
    CheckDensities(plants, "m2/m3", poll);
  }
  const vtkIdType size = static_cast<vtkIdType>(grid.Count[0]) * grid.Count[1];
  const auto layerOf = [&](int layer, float* to, const auto& densityOf) {
    if (littoral::IsAborted(this))
    {
      throw littoral::WriteStopped();
    }
    for (vtkIdType n = 0; n < size; ++n)
    {
      to[n] = static_cast<float>(densityOf(layer * size + n));
    }
  };
  const auto leafOf = [&](vtkIdType cell) { return leaves->GetComponent(cell, 0); };
  // what plants have more than leaves; rounding apart, never less
  const auto woodOf = [&](vtkIdType cell) { return std::max(0.0, plants->GetComponent(cell, 0) - leafOf(cell)); };
  const littoral::LayerOfCells leafLayer = [&](int layer, float* to) { layerOf(layer, to, leafOf); };
  const littoral::LayerOfCells woodLayer = [&](int layer, float* to) { layerOf(layer, to, woodOf); };
  const littoral::PalmPlace place{ this->Latitude, this->Longitude, this->OriginTime ? this->OriginTime : "" };
  this->SetProgressText("Writing forest");
  this->Conclude(
    littoral::WritePalm(this->FileName, grid, place, leafLayer, plants ? woodLayer : littoral::LayerOfCells()));
}

//----------------------------------------------------------------------------
void vtkForestDensityWriter::WriteTrees(vtkPointSet* input)
{
  littoral::RequireFit(input, "the trees");
  // Ranks have the trees of their cells.
  auto* points = vtkPolyData::SafeDownCast(input);
  const vtkSmartPointer<vtkPolyData> sorted = points ? littoral::InOrder(points, "PlantId") : nullptr;
  vtkPointSet* trees = sorted ? sorted.GetPointer() : input;
  const littoral::ArrayReader arrays = littoral::ArrayReader::OfPoints(trees, "the trees");
  vtkDataArray* heights = arrays.Need("Height", 1);
  vtkDataArray* diameters = arrays.Need("CrownDiameter", 1);
  vtkDataArray* indices = arrays.Need("LeafAreaIndex", 1);
  vtkDataArray* maxima = arrays.Find("MaximumHeight", 1);
  arrays.NeedFinite(trees->GetPoints() ? trees->GetPoints()->GetData() : nullptr);
  littoral::RequireMemory(
    BytesOfRow * static_cast<double>(trees->GetNumberOfPoints()), "the text of the trees", "take fewer");
  std::string text;
  for (vtkIdType tree = 0; tree < trees->GetNumberOfPoints(); ++tree)
  {
    const double index = indices->GetComponent(tree, 0);
    const std::string ofTree = " of tree " + std::to_string(tree);
    littoral::ParameterCheck check;
    check.NotNegative("LeafAreaIndex" + ofTree, index);
    const double maximum = maxima ? maxima->GetComponent(tree, 0) : UsualMaximum;
    check.Within("MaximumHeight" + ofTree, maximum, littoral::ValueInterval::Between(0.0, 1.0));
    littoral::Require(check.Reason());
    if (index > 0.0)
    {
      double place[3];
      trees->GetPoint(tree, place);
      text += littoral::TextOfRow(
        { place[0], place[1], PositiveOf(heights, tree), PositiveOf(diameters, tree), index, maximum },
        this->DragCoefficient);
    }
  }
  littoral::Require(text.empty() ? "no tree has leaves" : "");
  this->WriteWhole([&](std::ostream& file) { file << text; });
}

//----------------------------------------------------------------------------
void vtkForestDensityWriter::WriteInput()
{
  const std::string extension = vtksys::SystemTools::GetFilenameLastExtension(this->NeedFileName());
  littoral::ParameterCheck check;
  check.Range("DragCoefficient", this->DragCoefficient, 0.0, 10.0);
  littoral::Require(check.Reason());
  auto* image = vtkImageData::SafeDownCast(this->GetWholeInput());
  auto* trees = vtkPointSet::SafeDownCast(this->GetWholeInput());
  littoral::Require(image || trees ? "" : "there is no input");
  const bool isOfCells = extension == ".bdf" || extension == ".dat" || extension == ".nc";
  littoral::Require(isOfCells || extension == ".amrwind" ? "" : "FileName must end in .bdf, .dat, .nc or .amrwind");
  littoral::Require(isOfCells && !image ? "a " + extension + " is written of the image of densities" : "");
  littoral::Require(!isOfCells && !trees ? "a .amrwind is written of trees, the last output of Forest Density" : "");
  if (extension == ".nc")
  {
    this->WritePalm(image);
    return;
  }
  isOfCells ? this->WriteImage(image, extension) : this->WriteTrees(trees);
}

//----------------------------------------------------------------------------
void vtkForestDensityWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DragCoefficient: " << this->DragCoefficient << "\n";
  os << indent << "Latitude: " << this->Latitude << "\n";
  os << indent << "Longitude: " << this->Longitude << "\n";
  os << indent << "OriginTime: " << (this->OriginTime ? this->OriginTime : "(none)") << "\n";
}
