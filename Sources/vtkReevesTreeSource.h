// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkReevesTreeSource
 * @brief   generate a tree or shrub as a structured particle system
 *
 * Model of Reeves and Blau (1985): a trunk, branches that follow the rule of their parent, with lengths limited by a
 * bounding cone or ellipsoid, and leaves as particles on the twigs, darker inside the crown than on its surface (Setas
 * et al., section 4.1). Preset selects the parameters of a species; with Custom all of them can be set. Outputs and
 * errors as in vtkPlantSource.
 *
 * Cross sections of branches add up to that of the trunk at every fork (da Vinci's rule; pipe model of Shinozaki et al.
 * 1964). TrunkRadius is the radius at breast height, 1.3 m, or at a tenth of the height where that is lower.
 *
 * Defaults of inherited properties: Variation 0.2, TrunkRadius 0.3, NumberOfLeaves 10000, LeafSize 0.32, LeafWidth 0.7.
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
  /**
   * Species, a PresetType; default Oak. All parameters of the tree but Seed, SpeciesHeight, SpeciesDiameter and
   * SpeciesCrown are ignored unless it is Custom.
   */
  vtkSetMacro(Preset, int);
  vtkGetMacro(Preset, int);
  void SetPresetToCustom() { this->SetPreset(Custom); }
  void SetPresetToPine() { this->SetPreset(Pine); }
  void SetPresetToOak() { this->SetPreset(Oak); }
  void SetPresetToBirch() { this->SetPreset(Birch); }
  void SetPresetToShrub() { this->SetPreset(Shrub); }
  const char* GetPresetAsString() const;
  ///@}

  ///@{
  /**
   * Height of a tree of a preset species [m], 0.05 to 150, or 0 for the height of the preset; default 0. Not used if
   * Preset is Custom.
   */
  vtkSetMacro(SpeciesHeight, double);
  vtkGetMacro(SpeciesHeight, double);
  ///@}

  ///@{
  /**
   * Diameter at breast height of a tree of a preset species [m], 0.002 to 20, or 0 for the diameter of the preset;
   * default 0. Breast height is 1.3 m, or a tenth of the height where that is lower. The width of the crown scales with
   * the diameter, and slender trees have short crowns on long trunks. Height and diameter determine the natural
   * frequency of the swaying tree. Not used if Preset is Custom.
   */
  vtkSetMacro(SpeciesDiameter, double);
  vtkGetMacro(SpeciesDiameter, double);
  ///@}

  ///@{
  /**
   * Diameter of the crown of a tree of a preset species [m], 0.02 to 200, or 0 for one that scales with the diameter at
   * breast height; default 0. Not used if Preset is Custom.
   */
  vtkSetMacro(SpeciesCrown, double);
  vtkGetMacro(SpeciesCrown, double);
  ///@}

  ///@{
  /**
   * Bounding volume of the crown, a CrownShapeType; default Ellipsoid.
   */
  vtkSetMacro(CrownShape, int);
  vtkGetMacro(CrownShape, int);
  void SetCrownShapeToCone() { this->SetCrownShape(Cone); }
  void SetCrownShapeToEllipsoid() { this->SetCrownShape(Ellipsoid); }
  ///@}

  ///@{
  /**
   * Height of the tree [m], 0.05 to 150; default 12.
   */
  vtkSetMacro(Height, double);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /**
   * Maximum radius of the crown [m], 0.01 to 100; default 5.4.
   */
  vtkSetMacro(CrownRadius, double);
  vtkGetMacro(CrownRadius, double);
  ///@}

  ///@{
  /**
   * Height of the lowest leaves [m], 0 to 0.9 times TrunkReach times Height; default 2.2.
   */
  vtkSetMacro(CrownBase, double);
  vtkGetMacro(CrownBase, double);
  ///@}

  ///@{
  /**
   * Height of the top of the trunk relative to Height, 0.1 to 1; default 0.65.
   */
  vtkSetMacro(TrunkReach, double);
  vtkGetMacro(TrunkReach, double);
  ///@}

  ///@{
  /**
   * Number of branching orders above the trunk, 1 to 4; default 3.
   */
  vtkSetMacro(Orders, int);
  vtkGetMacro(Orders, int);
  ///@}

  ///@{
  /**
   * Number of branches on the trunk, 1 to 500; default 22.
   */
  vtkSetMacro(MainBranches, int);
  vtkGetMacro(MainBranches, int);
  ///@}

  ///@{
  /**
   * Number of side branches per branch, 1 to 20; default 6.
   */
  vtkSetMacro(SideBranches, int);
  vtkGetMacro(SideBranches, int);
  ///@}

  ///@{
  /**
   * Mean branching angle between a branch and its parent [degrees], 0 to 150; default 62.
   */
  vtkSetMacro(BranchAngle, double);
  vtkGetMacro(BranchAngle, double);
  ///@}

  ///@{
  /**
   * Vertical bend of a branch per segment, upward if positive and downward if negative, -0.9 to 0.9; default 0.08. It
   * is added to the z component of the unit direction.
   */
  vtkSetMacro(Lift, double);
  vtkGetMacro(Lift, double);
  ///@}

protected:
  vtkReevesTreeSource();
  ~vtkReevesTreeSource() override;

  littoral::PlantPrototype Grow(const littoral::PlantLevelOptions& options) override;

  int Preset;
  double SpeciesHeight;
  double SpeciesDiameter;
  double SpeciesCrown;
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
