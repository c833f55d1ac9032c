// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAonoKuniiTreeSource
 * @brief   a tree that repeats one fork, by published angles and ratios
 *
 * Aono and Kunii (1984): a segment, a fork into two or three branches, and again from each of them (Setas et al.,
 * section 4.1). Branches are shorter and thinner than their parents by constant ratios, and at constant angles to them.
 * Preset takes the numbers of one of twelve trees published in The Algorithmic Beauty of Plants (Prusinkiewicz and
 * Lindenmayer 1990, figures 2.6, 2.7 and 2.8, a to d) and gives it a size in metres, leaves and colors; with Custom
 * all numbers can be set. Outputs as in vtkPlantSource.
 *
 * With Variation 0 the tree is the published one, and seeds differ by their leaves alone. Leaves are on the segments of
 * the last step. Defaults of what the base has: Variation 0.1, TrunkRadius 0.17, NumberOfLeaves 9000, LeafSize 0.25,
 * LeafWidth 0.6.
 */
#ifndef vtkAonoKuniiTreeSource_h
#define vtkAonoKuniiTreeSource_h

#include "LittoralSourcesModule.h" // for export macro
#include "vtkLeafyTreeSource.h"

class LITTORALSOURCES_EXPORT vtkAonoKuniiTreeSource : public vtkLeafyTreeSource
{
public:
  static vtkAonoKuniiTreeSource* New();
  vtkTypeMacro(vtkAonoKuniiTreeSource, vtkLeafyTreeSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum PresetType
  {
    Custom = 0,
    MonopodialA = 1,
    MonopodialB = 2,
    MonopodialC = 3,
    MonopodialD = 4,
    SympodialA = 5,
    SympodialB = 6,
    SympodialC = 7,
    SympodialD = 8,
    TernaryA = 9,
    TernaryB = 10,
    TernaryC = 11,
    TernaryD = 12,
  };

  enum BranchingType
  {
    Monopodial = 0,
    Sympodial = 1,
    Ternary = 2,
  };

  ///@{
  /// A published tree, a PresetType. All numbers of the tree but Variation are then of no effect. Default MonopodialA.
  vtkSetMacro(Preset, int);
  vtkGetMacro(Preset, int);
  const char* GetPresetAsString() const;
  ///@}

  ///@{
  /// How the tree forks, a BranchingType: a straight axis with side branches, two unequal branches at each fork, or
  /// three equal ones. Default Monopodial.
  vtkSetMacro(Branching, int);
  vtkGetMacro(Branching, int);
  ///@}

  ///@{
  /// Steps of growth: 1 to 15, ternary 1 to 10. Each doubles or triples the tree. Default 10.
  vtkSetMacro(Iterations, int);
  vtkGetMacro(Iterations, int);
  ///@}

  ///@{
  /// Length of the stronger branch of a fork as part of its parent's, 0.3 to 1.2. Not ternary. Default 0.9.
  vtkSetMacro(LengthRatio1, double);
  vtkGetMacro(LengthRatio1, double);
  ///@}

  ///@{
  /// Length of the weaker branch as part of its parent's, 0.3 to 1.2. Not ternary. Default 0.6.
  vtkSetMacro(LengthRatio2, double);
  vtkGetMacro(LengthRatio2, double);
  ///@}

  ///@{
  /// Angle to the parent [degrees], -90 to 90: of side branches on the trunk (monopodial), of the stronger branch
  /// (sympodial), of all three branches (ternary). Default 45.
  vtkSetMacro(Angle1, double);
  vtkGetMacro(Angle1, double);
  ///@}

  ///@{
  /// Angle to the parent [degrees], -90 to 90, of side branches of branches (monopodial) or of the weaker branch
  /// (sympodial). Not ternary. Default 45.
  vtkSetMacro(Angle2, double);
  vtkGetMacro(Angle2, double);
  ///@}

  ///@{
  /// Angle about the trunk [degrees], -360 to 360: from side branch to side branch (monopodial), between the two
  /// branches of the trunk, 180 in the published trees (sympodial), from the first branch of a fork to the second
  /// (ternary). Default 137.5.
  vtkSetMacro(DivergenceAngle, double);
  vtkGetMacro(DivergenceAngle, double);
  ///@}

  ///@{
  /// Ternary: angle about the parent from the second branch of a fork to the third [degrees], -360 to 360. Default
  /// 132.63.
  vtkSetMacro(DivergenceAngle2, double);
  vtkGetMacro(DivergenceAngle2, double);
  ///@}

  ///@{
  /// Radius of a branch as part of its parent's, 0.3 to 1. Sections are kept where its square is 1 by the number of
  /// branches of a fork: 0.707 for two, 0.577 for three. Default 0.707.
  vtkSetMacro(WidthRatio, double);
  vtkGetMacro(WidthRatio, double);
  ///@}

  ///@{
  /// Ternary: by how much a step lengthens all segments that are there, 0.8 to 3. Default 1.109.
  vtkSetMacro(Elongation, double);
  vtkGetMacro(Elongation, double);
  ///@}

  ///@{
  /// Direction that branches bend to, of any length. Default 0 0 -1.
  vtkSetVector3Macro(Tropism, double);
  vtkGetVector3Macro(Tropism, double);
  ///@}

  ///@{
  /// How much a segment bends to it at most [rad], 0 to 1: by this times the sine of the angle between them. Default
  /// 0.
  vtkSetMacro(Susceptibility, double);
  vtkGetMacro(Susceptibility, double);
  ///@}

  ///@{
  /// Length of the first segment of the trunk [m], 0.01 to 50. All others follow from it, so that this is the size of
  /// the tree. Default 1.75.
  vtkSetMacro(TrunkLength, double);
  vtkGetMacro(TrunkLength, double);
  ///@}

protected:
  vtkAonoKuniiTreeSource();
  ~vtkAonoKuniiTreeSource() override;

  bool Grow(const littoral::PlantLevelOptions& options, littoral::PlantPrototype& prototype) override;

  int Preset;
  int Branching;
  int Iterations;
  double LengthRatio1;
  double LengthRatio2;
  double Angle1;
  double Angle2;
  double DivergenceAngle;
  double DivergenceAngle2;
  double WidthRatio;
  double Elongation;
  double Tropism[3];
  double Susceptibility;
  double TrunkLength;

private:
  vtkAonoKuniiTreeSource(const vtkAonoKuniiTreeSource&) = delete;
  void operator=(const vtkAonoKuniiTreeSource&) = delete;
};

#endif
