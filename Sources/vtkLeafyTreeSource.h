// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLeafyTreeSource
 * @brief   base class of the tree generators
 *
 * Properties that all trees share beyond those of other plants: individual variation, trunk and leaves. Defaults that
 * are not given here are those of the subclass. Outputs and errors as in vtkPlantSource.
 *
 * @sa vtkReevesTreeSource vtkAonoKuniiTreeSource
 */
#ifndef vtkLeafyTreeSource_h
#define vtkLeafyTreeSource_h

#include "LittoralSourcesModule.h" // for export macro
#include "vtkPlantSource.h"

#include <array> // for a color

class LITTORALSOURCES_EXPORT vtkLeafyTreeSource : public vtkPlantSource
{
public:
  vtkTypeMacro(vtkLeafyTreeSource, vtkPlantSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum LeafFormType
  {
    Blade = 0,
    Needle = 1,
    Spray = 2,
  };

  ///@{
  /**
   * Standard deviation of lengths and angles relative to their means, 0 to 0.5; the default is that of the subclass.
   */
  vtkSetMacro(Variation, double);
  vtkGetMacro(Variation, double);
  ///@}

  ///@{
  /**
   * Radius of the trunk [m], 0.001 to 10; the default is that of the subclass. It holds at the ground, or at the height
   * that the subclass names.
   */
  vtkSetMacro(TrunkRadius, double);
  vtkGetMacro(TrunkRadius, double);
  ///@}

  ///@{
  /**
   * Color of the bark as red, green, blue, each 0 to 1; default 0.41 0.35 0.27.
   */
  vtkSetVector3Macro(BarkColor, double);
  vtkGetVector3Macro(BarkColor, double);
  ///@}

  ///@{
  /**
   * Number of leaves, 0 to 1000000; the default is that of the subclass.
   */
  vtkSetMacro(NumberOfLeaves, int);
  vtkGetMacro(NumberOfLeaves, int);
  ///@}

  ///@{
  /**
   * Mean length of a leaf, or of a tuft or a spray of leaves [m], 0.001 to 5; the default is that of the subclass.
   */
  vtkSetMacro(LeafSize, double);
  vtkGetMacro(LeafSize, double);
  ///@}

  ///@{
  /**
   * Width of a leaf relative to its length, 0.01 to 2; the default is that of the subclass.
   */
  vtkSetMacro(LeafWidth, double);
  vtkGetMacro(LeafWidth, double);
  ///@}

  ///@{
  /**
   * Form of a leaf on its picture, a LeafFormType; default Spray. Blade: a leaf of a broad-leaved tree; Needle: a tuft
   * of needles; Spray: a twig with seven blades, each 0.3 to 0.4 of its length.
   */
  vtkSetMacro(LeafForm, int);
  vtkGetMacro(LeafForm, int);
  void SetLeafFormToBlade() { this->SetLeafForm(Blade); }
  void SetLeafFormToNeedle() { this->SetLeafForm(Needle); }
  void SetLeafFormToSpray() { this->SetLeafForm(Spray); }
  ///@}

  ///@{
  /**
   * Color of a fully lit leaf as red, green, blue, each 0 to 1; default 0.44 0.57 0.24.
   */
  vtkSetVector3Macro(LeafColor, double);
  vtkGetVector3Macro(LeafColor, double);
  ///@}

protected:
  vtkLeafyTreeSource(double variation, double trunkRadius, int leaves, double leafSize, double leafWidth);
  ~vtkLeafyTreeSource() override;

  /// Converts LeafColor and BarkColor to bytes. Throws littoral::InvalidInput if a component is out of range.
  void TakeColors(std::array<unsigned char, 3>& leaf, std::array<unsigned char, 3>& bark);

  double Variation;
  double TrunkRadius;
  double BarkColor[3];
  int NumberOfLeaves;
  double LeafSize;
  double LeafWidth;
  int LeafForm;
  double LeafColor[3];

private:
  vtkLeafyTreeSource(const vtkLeafyTreeSource&) = delete;
  void operator=(const vtkLeafyTreeSource&) = delete;
};

#endif
