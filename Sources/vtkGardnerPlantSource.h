// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGardnerPlantSource
 * @brief   generate a tree or shrub from textured quadric surfaces
 *
 * Model of Gardner (1984): the crown consists of a few ellipsoids, and the leaves are a mathematical texture on them.
 * The texture is transparent where its function is low, and more so near the silhouette,
 *
 *     T(x, y) = k sum C_i [sin(FX_i x + PX_i) + T0] sum C_i [sin(FY_i y + PY_i) + T0],  i = 1 ... n,
 *     opaque where T > T1 + (T2 - T1) (1 - g),  g = 1 at the center of an ellipsoid's outline, 0 at its silhouette.
 *
 * Each ellipsoid is a set of nested triangulated shells, each with its own g, and is attached to a limb of the trunk,
 * whose motion it follows. The texture is output 2 (also field data of `Leaves`) and carries the transparency: without
 * it the ellipsoids are plain and opaque. Preset selects the parameters of a kind of plant; with Custom all of them can
 * be set. Outputs and errors as in vtkPlantSource.
 */
#ifndef vtkGardnerPlantSource_h
#define vtkGardnerPlantSource_h

#include "LittoralSourcesModule.h" // for export macro
#include "vtkPlantSource.h"

class LITTORALSOURCES_EXPORT vtkGardnerPlantSource : public vtkPlantSource
{
public:
  static vtkGardnerPlantSource* New();
  vtkTypeMacro(vtkGardnerPlantSource, vtkPlantSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum PresetType
  {
    Custom = 0,
    Tree = 1,
    Cypress = 2,
    StonePine = 3,
    Bush = 4,
  };

  ///@{
  /**
   * Kind of plant, a PresetType; default Tree. The parameters below are ignored unless it is Custom.
   */
  vtkSetMacro(Preset, int);
  vtkGetMacro(Preset, int);
  void SetPresetToCustom() { this->SetPreset(Custom); }
  void SetPresetToTree() { this->SetPreset(Tree); }
  void SetPresetToCypress() { this->SetPreset(Cypress); }
  void SetPresetToStonePine() { this->SetPreset(StonePine); }
  void SetPresetToBush() { this->SetPreset(Bush); }
  const char* GetPresetAsString() const;
  ///@}

  ///@{
  /**
   * Height of the plant [m], 0.05 to 150; default 11.
   */
  vtkSetMacro(Height, double);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /**
   * Maximum radius of the crown [m], 0.01 to 100; default 4.6.
   */
  vtkSetMacro(CrownRadius, double);
  vtkGetMacro(CrownRadius, double);
  ///@}

  ///@{
  /**
   * Height of the lowest leaves [m], 0 to 0.9 times Height; default 2.
   */
  vtkSetMacro(CrownBase, double);
  vtkGetMacro(CrownBase, double);
  ///@}

  ///@{
  /**
   * Radius of the trunk at the ground [m], 0.001 to 10; default 0.3.
   */
  vtkSetMacro(TrunkRadius, double);
  vtkGetMacro(TrunkRadius, double);
  ///@}

  ///@{
  /**
   * Number of ellipsoids in the crown, 1 to 500; default 24.
   */
  vtkSetMacro(NumberOfQuadrics, int);
  vtkGetMacro(NumberOfQuadrics, int);
  ///@}

  ///@{
  /**
   * Number of nested shells per ellipsoid, 2 to 8; default 3. More shells look softer and need more polygons.
   */
  vtkSetMacro(Shells, int);
  vtkGetMacro(Shells, int);
  ///@}

  ///@{
  /**
   * Number n of terms of each sum of the texture, 4 to 7; default 6. More terms give finer leaves.
   */
  vtkSetMacro(Terms, int);
  vtkGetMacro(Terms, int);
  ///@}

  ///@{
  /**
   * Number FX_1 of periods of the first term around an ellipsoid, even, 2 to 16; default 6. A larger number gives
   * smaller tufts.
   */
  vtkSetMacro(Frequency, int);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /**
   * Offset T0 added to each sine of the texture, 0 to 3; default 1. A smaller offset gives more contrast.
   */
  vtkSetMacro(Offset, double);
  vtkGetMacro(Offset, double);
  ///@}

  ///@{
  /**
   * Threshold T1 of the opaque texture at the center of an ellipsoid's outline, 0 to SilhouetteThreshold; default 0.08.
   * A larger threshold gives more holes.
   */
  vtkSetMacro(CenterThreshold, double);
  vtkGetMacro(CenterThreshold, double);
  ///@}

  ///@{
  /**
   * Threshold T2 of the opaque texture at the silhouette of an ellipsoid, 0 to 1; default 0.4. A larger threshold gives
   * a more ragged and slender outline.
   */
  vtkSetMacro(SilhouetteThreshold, double);
  vtkGetMacro(SilhouetteThreshold, double);
  ///@}

  ///@{
  /**
   * Standard deviation of sizes, positions and colors relative to their means, 0 to 0.5; default 0.2.
   */
  vtkSetMacro(Variation, double);
  vtkGetMacro(Variation, double);
  ///@}

  ///@{
  /**
   * Color of fully lit leaves as red, green, blue, each 0 to 1; default 0.54 0.66 0.33.
   */
  vtkSetVector3Macro(LeafColor, double);
  vtkGetVector3Macro(LeafColor, double);
  ///@}

  ///@{
  /**
   * Color of the bark as red, green, blue, each 0 to 1; default 0.41 0.35 0.27.
   */
  vtkSetVector3Macro(BarkColor, double);
  vtkGetVector3Macro(BarkColor, double);
  ///@}

protected:
  vtkGardnerPlantSource();
  ~vtkGardnerPlantSource() override;

  littoral::PlantPrototype Grow(const littoral::PlantLevelOptions& options) override;
  std::array<int, 2> LeafTextureSize() const override;

  int Preset;
  double Height;
  double CrownRadius;
  double CrownBase;
  double TrunkRadius;
  int NumberOfQuadrics;
  int Shells;
  int Terms;
  int Frequency;
  double Offset;
  double CenterThreshold;
  double SilhouetteThreshold;
  double Variation;
  double LeafColor[3];
  double BarkColor[3];

private:
  vtkGardnerPlantSource(const vtkGardnerPlantSource&) = delete;
  void operator=(const vtkGardnerPlantSource&) = delete;
};

#endif
