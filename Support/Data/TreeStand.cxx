// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/StandForms.h"

#include "Data/ArrayReader.h"
#include "Data/Inputs.h"
#include "Numerics/Constants.h"
#include "Plants/CanopyProfile.h"
#include "Plants/CrownCylinder.h"
#include "Plants/StandAllometry.h"

#include "vtkPointSet.h"

#include <algorithm>

namespace littoral
{

namespace
{

constexpr std::size_t TreesAtOnce = 256;
constexpr double TallestTree = 150.0;

/// Trees by their dimensions, as vtkStandInventoryFilter makes them.
class TreeStand : public StandFoliage
{
public:
  TreeStand(vtkPointSet* trees, const StandOptions& options)
    : MaximumHeight(options.MaximumHeight)
  {
    const ArrayReader points = ArrayReader::OfPoints(trees, "The stand");
    vtkDataArray* heights = points.Need("Height", 1);
    vtkDataArray* stems = points.Find("DBH", 1);
    vtkDataArray* widths = stems ? points.Find("CrownDiameter", 1) : points.Need("CrownDiameter", 1);
    vtkDataArray* areas = points.Find("LeafArea", 1);
    vtkDataArray* species = points.Find("Species", 1);
    for (vtkDataArray* array : { heights, stems, widths, areas })
    {
      points.NeedFinite(array);
    }
    points.NeedFinite(trees->GetPoints() ? trees->GetPoints()->GetData() : nullptr);
    points.NeedIds(species, MostKinds, "species");
    const bool isKnown = areas || options.LeafAreaIndex > 0.0 || stems;
    Require(isKnown ? "" : "its trees have neither LeafArea nor DBH; set LeafAreaIndex.");
    double last = 0.0;
    for (vtkIdType tree = 0; species && tree < species->GetNumberOfTuples(); ++tree)
    {
      last = std::max(last, species->GetComponent(tree, 0));
    }
    this->KindList = KindsOf(trees, static_cast<std::size_t>(last) + 1, options);
    for (vtkIdType tree = 0; tree < trees->GetNumberOfPoints(); ++tree)
    {
      const std::string ofTree = " of tree " + std::to_string(tree);
      const int kind = species ? static_cast<int>(species->GetComponent(tree, 0)) : 0;
      StandCrown crown{ {}, static_cast<int>(tree), kind, heights->GetComponent(tree, 0), 0.0, 0.0,
        options.MaximumHeight };
      trees->GetPoint(tree, &crown.Foot.x);
      crown.Foot.z = options.HeightsAboveGround ? 0.0 : crown.Foot.z;
      ParameterCheck check;
      check.Positive("Height" + ofTree, crown.Height, "m", TallestTree);
      const double stem = stems ? stems->GetComponent(tree, 0) : 1.0;
      check.Positive("DBH" + ofTree, stem, "m");
      Require(check.Reason());
      crown.Diameter = widths ? widths->GetComponent(tree, 0) : CrownDiameterOf(stem, crown.Height);
      check.Positive("CrownDiameter" + ofTree, crown.Diameter, "m");
      const LeafTraits& traits = this->KindList[kind].Traits;
      crown.LeafArea = areas          ? areas->GetComponent(tree, 0)
        : options.LeafAreaIndex > 0.0 ? options.LeafAreaIndex * 0.25 * Pi * crown.Diameter * crown.Diameter
                                      : FoliageMassOf(traits, stem) / traits.MassPerArea;
      check.NotNegative("LeafArea" + ofTree, crown.LeafArea, "m2");
      Require(check.Reason());
      this->AreaOfLeaves += crown.LeafArea;
      this->AreaOfWood += traits.WoodPerLeaf * crown.LeafArea;
      this->List.push_back(crown);
    }
  }

  double LeafArea() const override { return this->AreaOfLeaves; }
  double WoodArea() const override { return this->AreaOfWood; }
  std::vector<StandCrown> Crowns() const override { return this->List; }

  void AddTo(CanopyDensity& density, LeafInclination& inclination, const ParallelFor& parallel) const override
  {
    const CanopyProfile profile(this->MaximumHeight);
    ForRanges(parallel, this->List.size(), TreesAtOnce, [&](std::size_t begin, std::size_t end) {
      for (std::size_t tree = begin; tree < end; ++tree)
      {
        const StandCrown& crown = this->List[tree];
        const double wood = this->KindList[crown.Kind].Traits.WoodPerLeaf;
        ShareBetweenCells(density.GetGrid(), { crown.Foot, crown.Height, crown.Diameter }, profile,
          [&](std::size_t cell, double share) {
            density.AddLeaf(crown.Kind, cell, share * crown.LeafArea);
            density.AddWood(cell, share * wood * crown.LeafArea);
          });
      }
    });
    inclination.AddSphere(this->AreaOfLeaves);
  }

private:
  double MaximumHeight;
  std::vector<StandCrown> List;
  double AreaOfLeaves = 0.0;
  double AreaOfWood = 0.0;
};

}

//----------------------------------------------------------------------------
std::unique_ptr<StandFoliage> TreeFoliage(vtkPointSet* trees, const StandOptions& options)
{
  return std::make_unique<TreeStand>(trees, options);
}

}
