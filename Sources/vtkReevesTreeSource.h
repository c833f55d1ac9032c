// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkReevesTreeSource
 * @brief   a tree or shrub as a structured particle system
 *
 * Reeves and Blau (1985): a trunk, branches that repeat their parent's rule, with lengths cut by a bounding cone or
 * ellipsoid, and leaves as particles on the twigs, darker within the crown than on its surface (Setas et al., section
 * 4.1). Outputs as in vtkPlantSource. Preset takes the numbers of a species; with Custom all of them can be set.
 */
#ifndef vtkReevesTreeSource_h
#define vtkReevesTreeSource_h

#include "LittoralSourcesModule.h" // for export macro
#include "vtkPlantSource.h"

class LITTORALSOURCES_EXPORT vtkReevesTreeSource : public vtkPlantSource
{
public:
  static vtkReevesTreeSource* New();
  vtkTypeMacro(vtkReevesTreeSource, vtkPlantSource);
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

  enum LeafFormType
  {
    Blade = 0,
    Needle = 1,
  };

  ///@{
  /// A species, a PresetType. All parameters below are then of no effect, except for Custom. Default Oak.
  vtkSetMacro(Preset, int);
  vtkGetMacro(Preset, int);
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
  /// Radius of the trunk at the ground [m], 0.001 to 10. Default 0.3.
  vtkSetMacro(TrunkRadius, double);
  vtkGetMacro(TrunkRadius, double);
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

  ///@{
  /// Standard deviation of lengths and angles as part of their means, 0 to 0.5. Default 0.2.
  vtkSetMacro(Variation, double);
  vtkGetMacro(Variation, double);
  ///@}

  ///@{
  /// Number of leaves, 0 to 1000000. Default 10000.
  vtkSetMacro(NumberOfLeaves, int);
  vtkGetMacro(NumberOfLeaves, int);
  ///@}

  ///@{
  /// Mean length of a leaf, or of a tuft of leaves [m], 0.001 to 5. Default 0.32.
  vtkSetMacro(LeafSize, double);
  vtkGetMacro(LeafSize, double);
  ///@}

  ///@{
  /// Width of a leaf as part of its length, 0.01 to 2. Default 0.7.
  vtkSetMacro(LeafWidth, double);
  vtkGetMacro(LeafWidth, double);
  ///@}

  ///@{
  /// The outline of a leaf, a LeafFormType. Default Blade.
  vtkSetMacro(LeafForm, int);
  vtkGetMacro(LeafForm, int);
  ///@}

  ///@{
  /// Colour of a leaf in the light: red, green, blue, each 0 to 1. Default 0.44 0.57 0.24.
  vtkSetVector3Macro(LeafColor, double);
  vtkGetVector3Macro(LeafColor, double);
  ///@}

  ///@{
  /// Colour of the bark: red, green, blue, each 0 to 1. Default 0.41 0.35 0.27.
  vtkSetVector3Macro(BarkColor, double);
  vtkGetVector3Macro(BarkColor, double);
  ///@}

protected:
  vtkReevesTreeSource();
  ~vtkReevesTreeSource() override;

  bool Grow(const littoral::PlantLevelOptions& options, littoral::PlantPrototype& prototype) override;

  int Preset;
  int CrownShape;
  double Height;
  double CrownRadius;
  double CrownBase;
  double TrunkRadius;
  double TrunkReach;
  int Orders;
  int MainBranches;
  int SideBranches;
  double BranchAngle;
  double Lift;
  double Variation;
  int NumberOfLeaves;
  double LeafSize;
  double LeafWidth;
  int LeafForm;
  double LeafColor[3];
  double BarkColor[3];

private:
  vtkReevesTreeSource(const vtkReevesTreeSource&) = delete;
  void operator=(const vtkReevesTreeSource&) = delete;
};

#endif
