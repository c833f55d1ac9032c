// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/StandFoliage.h"

#include "Data/ArrayReader.h"
#include "Data/Blocks.h"
#include "Data/Inputs.h"
#include "Data/StandForms.h"
#include "Plants/CanopyProfile.h"

#include "vtkPointSet.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace littoral
{

namespace
{

/// Words between semicolons, without the blanks around them.
std::vector<std::string> WordsIn(const std::string& text)
{
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, ';');)
  {
    const std::size_t first = word.find_first_not_of(" \t");
    const std::size_t last = word.find_last_not_of(" \t");
    words.push_back(first == std::string::npos ? "" : word.substr(first, last - first + 1));
  }
  return words;
}

}

//----------------------------------------------------------------------------
std::vector<StandKind> KindsOf(vtkDataObject* data, std::size_t count, const StandOptions& options)
{
  const std::vector<std::string> names = WordsIn(options.SpeciesNames);
  vtkStringArray* own = ArrayReader::OfFields(data, "The stand").FindTexts("Kinds");
  std::vector<StandKind> kinds;
  for (std::size_t n = 0; n < count; ++n)
  {
    StandKind& kind = kinds.emplace_back();
    const auto row = static_cast<vtkIdType>(n);
    kind.Name = n < names.size() ? names[n] : own && row < own->GetNumberOfValues() ? own->GetValue(row) : "";
    kind.Name = kind.Name.empty() ? "Species " + std::to_string(n) : kind.Name;
    const LeafTraits* listed = FindLeafTraits(kind.Name);
    kind.Traits = listed ? *listed : HardwoodTraits();
    kind.Traits.MassPerArea = options.MassPerArea > 0.0 ? options.MassPerArea : kind.Traits.MassPerArea;
  }
  return kinds;
}

//----------------------------------------------------------------------------
double FieldOf(vtkDataObject* data, const char* name, double otherwise)
{
  vtkDataArray* field = ArrayReader::OfFields(data, "The stand", 1).Seek(name, 1);
  return field ? field->GetComponent(0, 0) : otherwise;
}

//----------------------------------------------------------------------------
void RequireWhole(vtkDataObject* data, const WorkShare& share)
{
  const double own = FieldOf(data, "PlantsInAll", 0.0);
  std::vector<double> numbers{ FieldOf(data, "PlantsShown", own), own };
  share.AddUp(numbers);
  const double shown = numbers[0];
  const double all = numbers[1];
  if (shown < all)
  {
    Refuse("only ", shown, " of ", all, " plants are in view; switch UseCulling of the scattered plants off.");
  }
}

//----------------------------------------------------------------------------
void CrownMeasure::Add(const FoliageTriangle& triangle, const Vector3& foot, bool isLeaf)
{
  Vector3 mean(0.0);
  for (const Vector3& corner : triangle.Corners)
  {
    const Vector3 place = corner - foot;
    this->Top = std::max(this->Top, place.z);
    this->Reach = isLeaf ? std::max(this->Reach, std::hypot(place.x, place.y)) : this->Reach;
    mean += place / 3.0;
  }
  const double area = isLeaf ? CountedArea(triangle) : 0.0;
  this->Area += area;
  this->Moment += area * mean.z;
}

//----------------------------------------------------------------------------
StandCrown CrownMeasure::Crown(const Vector3& foot, int plant, int kind) const
{
  const double mean = this->Area > 0.0 && this->Top > 0.0 ? this->Moment / this->Area / this->Top : 0.5;
  return { foot, plant, kind, this->Top, 2.0 * this->Reach, this->Area, MaximumOfMean(mean) };
}

//----------------------------------------------------------------------------
std::unique_ptr<StandFoliage> ReadStand(
  vtkDataObject* data, const char* input, const StandOptions& options, const WorkShare& share)
{
  std::unique_ptr<StandFoliage> stand;
  if (auto* trees = vtkPointSet::SafeDownCast(data))
  {
    RequireFit(trees, input);
    stand = TreeFoliage(trees, options);
  }
  else
  {
    const vtkSmartPointer<vtkMultiBlockDataSet> blocks = BlocksOf(data, input);
    auto* instances = vtkPolyData::SafeDownCast(FindBlock(blocks, "Instances"));
    stand = instances ? InstancedFoliage(blocks, instances, options, share) : MergedFoliage(blocks, options);
  }
  Require(stand->LeafArea() > 0.0 ? "" : "it has no leaf area.");
  const bool isSmall = stand->LeafArea() + stand->WoodArea() < OrderFreeSums::Largest;
  Require(isSmall ? "" : "it has more than 5e8 m2 of leaves and wood; take a part of it.");
  return stand;
}

}
