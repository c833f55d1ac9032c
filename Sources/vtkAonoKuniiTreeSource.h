// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAonoKuniiTreeSource
 * @brief   generate a tree by repeated forking with published angles and length ratios
 *
 * Branching model of Aono and Kunii (1984): a segment forks into two or three branches, and each of these forks again
 * (Setas et al., section 4.1). Ratios of length and radius between a branch and its parent are constant, and so are the
 * branching angles. Preset selects one of twelve trees published in The Algorithmic Beauty of Plants (Prusinkiewicz and
 * Lindenmayer 1990, figures 2.6, 2.7 and 2.8, a to d) and adds a size, leaves and colors; with Custom all parameters
 * can be set. Outputs and errors as in vtkPlantSource.
 *
 * With Variation 0 the tree is the published one, and seeds differ in the leaves alone. Leaves grow on the segments of
 * the last iteration. Defaults of inherited properties: Variation 0.1, TrunkRadius 0.17, NumberOfLeaves 9000, LeafSize
 * 0.25, LeafWidth 0.6.
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
  /**
   * Published tree, a PresetType; default MonopodialA. All parameters of the tree but Seed and Variation are ignored
   * unless it is Custom.
   */
  vtkSetMacro(Preset, int);
  vtkGetMacro(Preset, int);
  void SetPresetToCustom() { this->SetPreset(Custom); }
  void SetPresetToMonopodialA() { this->SetPreset(MonopodialA); }
  void SetPresetToMonopodialB() { this->SetPreset(MonopodialB); }
  void SetPresetToMonopodialC() { this->SetPreset(MonopodialC); }
  void SetPresetToMonopodialD() { this->SetPreset(MonopodialD); }
  void SetPresetToSympodialA() { this->SetPreset(SympodialA); }
  void SetPresetToSympodialB() { this->SetPreset(SympodialB); }
  void SetPresetToSympodialC() { this->SetPreset(SympodialC); }
  void SetPresetToSympodialD() { this->SetPreset(SympodialD); }
  void SetPresetToTernaryA() { this->SetPreset(TernaryA); }
  void SetPresetToTernaryB() { this->SetPreset(TernaryB); }
  void SetPresetToTernaryC() { this->SetPreset(TernaryC); }
  void SetPresetToTernaryD() { this->SetPreset(TernaryD); }
  const char* GetPresetAsString() const;
  ///@}

  ///@{
  /**
   * Type of branching, a BranchingType; default Monopodial. Monopodial: a straight axis with side branches. Sympodial:
   * two unequal branches at each fork. Ternary: three equal branches at each fork.
   */
  vtkSetMacro(Branching, int);
  vtkGetMacro(Branching, int);
  void SetBranchingToMonopodial() { this->SetBranching(Monopodial); }
  void SetBranchingToSympodial() { this->SetBranching(Sympodial); }
  void SetBranchingToTernary() { this->SetBranching(Ternary); }
  ///@}

  ///@{
  /**
   * Number of growth iterations, 1 to 15, or 1 to 10 if Branching is Ternary; default 10. Each iteration doubles or
   * triples the number of segments.
   */
  vtkSetMacro(Iterations, int);
  vtkGetMacro(Iterations, int);
  ///@}

  ///@{
  /**
   * Length of the stronger branch of a fork relative to its parent, 0.3 to 1.2; default 0.9. Not used if Branching is
   * Ternary.
   */
  vtkSetMacro(LengthRatio1, double);
  vtkGetMacro(LengthRatio1, double);
  ///@}

  ///@{
  /**
   * Length of the weaker branch of a fork relative to its parent, 0.3 to 1.2; default 0.6. Not used if Branching is
   * Ternary.
   */
  vtkSetMacro(LengthRatio2, double);
  vtkGetMacro(LengthRatio2, double);
  ///@}

  ///@{
  /**
   * Branching angle to the parent [degrees], -90 to 90; default 45. It holds for the side branches of the trunk
   * (Monopodial), the stronger branch (Sympodial) or all three branches (Ternary).
   */
  vtkSetMacro(Angle1, double);
  vtkGetMacro(Angle1, double);
  ///@}

  ///@{
  /**
   * Branching angle of the weaker branch to its parent [degrees], -90 to 90; default 45. It holds for the side branches
   * of branches (Monopodial) or the weaker branch of a fork (Sympodial) and is not used if Branching is Ternary.
   */
  vtkSetMacro(Angle2, double);
  vtkGetMacro(Angle2, double);
  ///@}

  ///@{
  /**
   * Divergence angle about the trunk [degrees], -360 to 360; default 137.5. It is measured between successive side
   * branches (Monopodial), between the two branches of the trunk, 180 in the published trees (Sympodial), or from the
   * first branch of a fork to the second (Ternary).
   */
  vtkSetMacro(DivergenceAngle, double);
  vtkGetMacro(DivergenceAngle, double);
  ///@}

  ///@{
  /**
   * Divergence angle about the parent from the second branch of a fork to the third [degrees], -360 to 360; default
   * 132.63. Used only if Branching is Ternary.
   */
  vtkSetMacro(DivergenceAngle2, double);
  vtkGetMacro(DivergenceAngle2, double);
  ///@}

  ///@{
  /**
   * Radius of a branch relative to its parent, 0.3 to 1; default 0.707. Cross sections are preserved at a fork of n
   * branches if it is sqrt(1/n): 0.707 for two, 0.577 for three.
   */
  vtkSetMacro(WidthRatio, double);
  vtkGetMacro(WidthRatio, double);
  ///@}

  ///@{
  /**
   * Elongation factor of all existing segments per iteration, 0.8 to 3; default 1.109. Used only if Branching is
   * Ternary.
   */
  vtkSetMacro(Elongation, double);
  vtkGetMacro(Elongation, double);
  ///@}

  ///@{
  /**
   * Tropism vector, the direction that branches bend to, of any length; default 0 0 -1.
   */
  vtkSetVector3Macro(Tropism, double);
  vtkGetVector3Macro(Tropism, double);
  ///@}

  ///@{
  /**
   * Susceptibility to bending [rad], 0 to 1; default 0. Each segment bends towards Tropism by this value times the sine
   * of the angle between them.
   */
  vtkSetMacro(Susceptibility, double);
  vtkGetMacro(Susceptibility, double);
  ///@}

  ///@{
  /**
   * Length of the first segment of the trunk [m], 0.01 to 50; default 1.75. All other lengths scale with it.
   */
  vtkSetMacro(TrunkLength, double);
  vtkGetMacro(TrunkLength, double);
  ///@}

protected:
  vtkAonoKuniiTreeSource();
  ~vtkAonoKuniiTreeSource() override;

  littoral::PlantPrototype Grow(const littoral::PlantLevelOptions& options) override;

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
