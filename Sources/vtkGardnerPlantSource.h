// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGardnerPlantSource
 * @brief   a tree or shrub of textured quadrics, as an impressionist paints it
 *
 * Gardner (1984): a crown is a few ellipsoids, and leaves are a mathematical texture on them that is transparent where
 * it is low, the more so the closer to the silhouette,
 *
 *     T(x, y) = k sum C_i [sin(FX_i x + PX_i) + T0] sum C_i [sin(FY_i y + PY_i) + T0],  i = 1 ... n,
 *     opaque where T > T1 + (T2 - T1) (1 - g),  g = 1 in the middle of an ellipsoid's outline, 0 at its silhouette.
 *
 * Each ellipsoid is a nest of shells, each with a g of its own, in triangles; it stands on a limb of the trunk and
 * moves with it. The texture is the picture on a leaf (output 2, and field data of `Leaves`) and carries the
 * transparency: without it they are bare. Outputs as in vtkPlantSource. Preset takes the numbers of a kind of
 * plant; with Custom all of them can be set.
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
  /// A kind of plant, a PresetType. All parameters below are then of no effect, except for Custom. Default Tree.
  vtkSetMacro(Preset, int);
  vtkGetMacro(Preset, int);
  const char* GetPresetAsString() const;
  ///@}

  ///@{
  /// Height of the plant [m], 0.05 to 150. Default 11.
  vtkSetMacro(Height, double);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /// Largest radius of the crown [m], 0.01 to 100. Default 4.6.
  vtkSetMacro(CrownRadius, double);
  vtkGetMacro(CrownRadius, double);
  ///@}

  ///@{
  /// Height of the lowest leaves [m], from 0 to 0.9 of the plant's. Default 2.
  vtkSetMacro(CrownBase, double);
  vtkGetMacro(CrownBase, double);
  ///@}

  ///@{
  /// Radius of the trunk at the ground [m], 0.001 to 10. Default 0.3.
  vtkSetMacro(TrunkRadius, double);
  vtkGetMacro(TrunkRadius, double);
  ///@}

  ///@{
  /// Number of ellipsoids that make up the crown, 1 to 500. Default 24.
  vtkSetMacro(NumberOfQuadrics, int);
  vtkGetMacro(NumberOfQuadrics, int);
  ///@}

  ///@{
  /// Nested shells of an ellipsoid, 2 to 8. More look softer and cost more polygons. Default 3.
  vtkSetMacro(Shells, int);
  vtkGetMacro(Shells, int);
  ///@}

  ///@{
  /// Number n of terms of each sum, 4 to 7. More show finer leaves. Default 6.
  vtkSetMacro(Terms, int);
  vtkGetMacro(Terms, int);
  ///@}

  ///@{
  /// FX_1, periods of the first term around an ellipsoid; even, 2 to 16. More make smaller tufts. Default 6.
  vtkSetMacro(Frequency, int);
  vtkGetMacro(Frequency, int);
  ///@}

  ///@{
  /// T0, added to each sine, 0 to 3. Less gives more contrast. Default 1.
  vtkSetMacro(Offset, double);
  vtkGetMacro(Offset, double);
  ///@}

  ///@{
  /// T1, from 0 to SilhouetteThreshold: in the middle of an ellipsoid, leaves are where T is larger. The higher, the
  /// more holes. Default 0.08.
  vtkSetMacro(CenterThreshold, double);
  vtkGetMacro(CenterThreshold, double);
  ///@}

  ///@{
  /// T2, from 0 to 1: the same at the silhouette. The higher, the more ragged and slender. Default 0.4.
  vtkSetMacro(SilhouetteThreshold, double);
  vtkGetMacro(SilhouetteThreshold, double);
  ///@}

  ///@{
  /// Standard deviation of sizes, places and colors as part of their means, 0 to 0.5. Default 0.2.
  vtkSetMacro(Variation, double);
  vtkGetMacro(Variation, double);
  ///@}

  ///@{
  /// Color of leaves in the light: red, green, blue, each 0 to 1. Default 0.54 0.66 0.33.
  vtkSetVector3Macro(LeafColor, double);
  vtkGetVector3Macro(LeafColor, double);
  ///@}

  ///@{
  /// Color of the bark: red, green, blue, each 0 to 1. Default 0.41 0.35 0.27.
  vtkSetVector3Macro(BarkColor, double);
  vtkGetVector3Macro(BarkColor, double);
  ///@}

protected:
  vtkGardnerPlantSource();
  ~vtkGardnerPlantSource() override;

  bool Grow(const littoral::PlantLevelOptions& options, littoral::PlantPrototype& prototype) override;
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
