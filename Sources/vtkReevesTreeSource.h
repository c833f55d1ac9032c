// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkReevesTreeSource
 * @brief   a tree or shrub as a structured particle system
 *
 * Reeves and Blau (1985): a trunk, branches that repeat their parent's rule, with lengths cut by a bounding cone or
 * ellipsoid, and leaves as particles on the twigs, darker within the crown than on its surface (Setas et al., section
 * 4.1). Outputs as in vtkPlantSource. Preset takes the numbers of a species; with Custom all of them can be set.
 *
 * Sections of branches add up to that of the trunk at every fork (da Vinci's rule; the pipe model of Shinozaki et al.
 * 1964), and the trunk's is given: TrunkRadius is its radius at breast height, 1.3 m, or a tenth of the height where
 * that is lower.
 *
 * Defaults of what the base has: Variation 0.2, TrunkRadius 0.3, NumberOfLeaves 10000, LeafSize 0.32, LeafWidth 0.7.
 */
#ifndef vtkReevesTreeSource_h
#define vtkReevesTreeSource_h

#include "LittoralSourcesModule.h" // for export macro
#include "vtkLeafyTreeSource.h"

class LITTORALSOURCES_EXPORT vtkReevesTreeSource : public vtkLeafyTreeSource
{
public:
  static vtkReevesTreeSource* New();
  vtkTypeMacro(vtkReevesTreeSource, vtkLeafyTreeSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum PresetType
  {
    Custom = 0,
    Pine = 1,
    Oak = 2,
    Birch = 3,
    Shrub = 4,
  };

  enum CrownShapeType
  {
    Cone = 0,
    Ellipsoid = 1,
  };

  ///@{
  /// A species, a PresetType. All numbers of the tree but Seed, SpeciesHeight and SpeciesDiameter are then of no
  /// effect, except for Custom. Default Oak.
  vtkSetMacro(Preset, int);
  vtkGetMacro(Preset, int);
  const char* GetPresetAsString() const;
  ///@}

  ///@{
  /// Height of a tree of a species [m], 0.05 to 150; 0: the preset's. Of no effect with Custom. Default 0.
  vtkSetMacro(SpeciesHeight, double);
  vtkGetMacro(SpeciesHeight, double);
  ///@}

  ///@{
  /// Diameter at breast height of a tree of a species [m], 0.002 to 20; 0: the preset's. The trunk is measured at 1.3
  /// m, and at a tenth of the height where that is lower. Crowns are as wide as stems are thick, and slender trees have
  /// short crowns on long trunks. With the height, it decides how fast the tree sways. Of no effect with Custom.
  /// Default 0.
  vtkSetMacro(SpeciesDiameter, double);
  vtkGetMacro(SpeciesDiameter, double);
  ///@}

  ///@{
  /// The volume that bounds the crown, a CrownShapeType. Default Ellipsoid.
  vtkSetMacro(CrownShape, int);
  vtkGetMacro(CrownShape, int);
  ///@}

  ///@{
  /// Height of the tree [m], 0.05 to 150. Default 12.
  vtkSetMacro(Height, double);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /// Largest radius of the crown [m], 0.01 to 100. Default 5.4.
  vtkSetMacro(CrownRadius, double);
  vtkGetMacro(CrownRadius, double);
  ///@}

  ///@{
  /// Height of the lowest leaves [m], from 0 to 0.9 of the trunk. Default 2.2.
  vtkSetMacro(CrownBase, double);
  vtkGetMacro(CrownBase, double);
  ///@}

  ///@{
  /// Part of the height that the trunk grows to, 0.1 to 1. Default 0.65.
  vtkSetMacro(TrunkReach, double);
  vtkGetMacro(TrunkReach, double);
  ///@}

  ///@{
  /// Orders of branches on the trunk, 1 to 4. Default 3.
  vtkSetMacro(Orders, int);
  vtkGetMacro(Orders, int);
  ///@}

  ///@{
  /// Number of branches on the trunk, 1 to 500. Default 22.
  vtkSetMacro(MainBranches, int);
  vtkGetMacro(MainBranches, int);
  ///@}

  ///@{
  /// Number of branches on each branch, 1 to 20. Default 6.
  vtkSetMacro(SideBranches, int);
  vtkGetMacro(SideBranches, int);
  ///@}

  ///@{
  /// Mean angle between a branch and its parent [degrees], 0 to 150. Default 62.
  vtkSetMacro(BranchAngle, double);
  vtkGetMacro(BranchAngle, double);
  ///@}

  ///@{
  /// Bend of branches, up where positive and down where negative, -0.9 to 0.9. Default 0.08.
  vtkSetMacro(Lift, double);
  vtkGetMacro(Lift, double);
  ///@}

protected:
  vtkReevesTreeSource();
  ~vtkReevesTreeSource() override;

  bool Grow(const littoral::PlantLevelOptions& options, littoral::PlantPrototype& prototype) override;

  int Preset;
  double SpeciesHeight;
  double SpeciesDiameter;
  int CrownShape;
  double Height;
  double CrownRadius;
  double CrownBase;
  double TrunkReach;
  int Orders;
  int MainBranches;
  int SideBranches;
  double BranchAngle;
  double Lift;

private:
  vtkReevesTreeSource(const vtkReevesTreeSource&) = delete;
  void operator=(const vtkReevesTreeSource&) = delete;
};

#endif
