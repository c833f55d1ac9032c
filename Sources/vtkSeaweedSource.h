// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSeaweedSource
 * @brief   a seaweed with a skeleton that bends
 *
 * Coulais et al., section 4.2: a skeleton of segments, each with its place and angles on its parent, and meshes that
 * follow the segments. A Tuft has fronds of a stipe and an undivided blade each; a Canopy has long stipes with blades
 * at regular distances, each held up by a float; a Meadow has shoots of narrow leaves on a rhizome. Preset takes the
 * numbers of a species; with Custom all of them can be set.
 *
 * Outputs as in vtkPlantSource, for vtkPlantScatterFilter. `High/Skin` is what is round, `High/Leaves` are the blades.
 * `Medium` has the same stipes with fewer corners (`Trunk`) and blades without waves (`Crown`); `Low` has four upright
 * polygons. Output 1 is a blade in color, for `Crown`, of TextureSize; output 2 is the relief of a blade in grey, for
 * `Leaves`. CrownJitter has no effect.
 *
 * `High/Skeleton` has one root, the holdfast. Beside those of vtkPlantSource it has the point arrays `Tissue` (0 stipe,
 * 1 blade, 2 float, 3 holdfast), `Width`, `Thickness` [m] (the section is an ellipse) and `Across` (the direction of
 * the width), `Length` [m], `YoungModulus` [Pa], `DampingRatio`, `Density` [kg/m3], and the paper's h, theta and phi:
 * `Attachment` [m], `RestTheta`, `RestPhi` [rad]. A node has the values of the segment that starts there, a tip those
 * of the segment that ends there. Mass and stiffness follow from these, so that a plant that is scaled has those of its
 * size.
 */
#ifndef vtkSeaweedSource_h
#define vtkSeaweedSource_h

#include "LittoralSourcesModule.h" // for export macro
#include "vtkPlantSource.h"

class LITTORALSOURCES_EXPORT vtkSeaweedSource : public vtkPlantSource
{
public:
  static vtkSeaweedSource* New();
  vtkTypeMacro(vtkSeaweedSource, vtkPlantSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum PresetType
  {
    Custom = 0,
    SugarKelp = 1, ///< Laminaria (now Saccharina) saccharina (latissima)
    GiantKelp = 2, ///< Macrocystis pyrifera
    Eelgrass = 3,  ///< Zostera marina
  };

  enum FormType
  {
    Tuft = 0,
    Canopy = 1,
    Meadow = 2,
  };

  ///@{
  /// A species, a PresetType. All parameters below but SegmentsPerBranch are then of no effect, except for Custom.
  /// Default SugarKelp.
  vtkSetMacro(Preset, int);
  vtkGetMacro(Preset, int);
  const char* GetPresetAsString() const;
  ///@}

  ///@{
  /// Segments of a frond or stipe, of any preset, 2 to 64; those of blades get shorter towards the foot. The blades of
  /// a Canopy have a quarter of them, at least 2. Default 10.
  vtkSetMacro(SegmentsPerBranch, int);
  vtkGetMacro(SegmentsPerBranch, int);
  ///@}

  ///@{
  /// How the seaweed is built, a FormType. Default Tuft.
  vtkSetMacro(Form, int);
  vtkGetMacro(Form, int);
  ///@}

  ///@{
  /// Number of fronds, of stipes (Canopy) or of leaves (Meadow), 1 to 500. Default 7.
  vtkSetMacro(NumberOfFronds, int);
  vtkGetMacro(NumberOfFronds, int);
  ///@}

  ///@{
  /// Radius of the holdfast, or of the patch (Meadow) [m], 0.001 to 5. Default 0.07.
  vtkSetMacro(HoldfastRadius, double);
  vtkGetMacro(HoldfastRadius, double);
  ///@}

  ///@{
  /// Mean tilt of fronds where they start [degrees], 0 to 60. Default 22.
  vtkSetMacro(SpreadAngle, double);
  vtkGetMacro(SpreadAngle, double);
  ///@}

  ///@{
  /// Length of a stipe [m], 0 to 100. A Meadow has none. Default 0.3.
  vtkSetMacro(StipeLength, double);
  vtkGetMacro(StipeLength, double);
  ///@}

  ///@{
  /// Radius of a stipe at its foot, or of the rhizome [m], 0.0001 to 0.5. Default 0.006.
  vtkSetMacro(StipeRadius, double);
  vtkGetMacro(StipeRadius, double);
  ///@}

  ///@{
  /// Mean length of a blade [m], 0.01 to 20. Default 1.7.
  vtkSetMacro(BladeLength, double);
  vtkGetMacro(BladeLength, double);
  ///@}

  ///@{
  /// Mean width of a blade where it is widest [m], 0.0005 to 3. Default 0.2.
  vtkSetMacro(BladeWidth, double);
  vtkGetMacro(BladeWidth, double);
  ///@}

  ///@{
  /// Thickness of a blade [m], 0.00001 to 0.1. Default 0.002.
  vtkSetMacro(BladeThickness, double);
  vtkGetMacro(BladeThickness, double);
  ///@}

  ///@{
  /// Height of the waves of a blade's edges as part of half its width, 0 to 1. Default 0.3.
  vtkSetMacro(Ruffle, double);
  vtkGetMacro(Ruffle, double);
  ///@}

  ///@{
  /// Distance of blades along a stipe [m], 0.01 to 20. Canopy only. Default 0.35.
  vtkSetMacro(BladeSpacing, double);
  vtkGetMacro(BladeSpacing, double);
  ///@}

  ///@{
  /// Radius of the float at the foot of a blade [m], 0 (none) to 0.2. Canopy only. Default 0.018.
  vtkSetMacro(FloatRadius, double);
  vtkGetMacro(FloatRadius, double);
  ///@}

  ///@{
  /// Young's modulus of stipes and floats [Pa], 1e3 to 1e12. The joint at the foot of a segment has the stiffness E I /
  /// L. Default 3e7.
  vtkSetMacro(StipeModulus, double);
  vtkGetMacro(StipeModulus, double);
  ///@}

  ///@{
  /// Young's modulus of blades [Pa], 1e3 to 1e12. Default 4e6.
  vtkSetMacro(BladeModulus, double);
  vtkGetMacro(BladeModulus, double);
  ///@}

  ///@{
  /// Damping of the tissue alone, as part of critical damping, 0 to 10. Default 0.05.
  vtkSetMacro(DampingRatio, double);
  vtkGetMacro(DampingRatio, double);
  ///@}

  ///@{
  /// Density of stipes [kg/m3], 50 to 3000; sea water has about 1025. Default 1020.
  vtkSetMacro(StipeDensity, double);
  vtkGetMacro(StipeDensity, double);
  ///@}

  ///@{
  /// Density of blades, gas in them included [kg/m3], 50 to 3000. Default 1005.
  vtkSetMacro(BladeDensity, double);
  vtkGetMacro(BladeDensity, double);
  ///@}

  ///@{
  /// Density of floats, gas included [kg/m3], 50 to 3000. Canopy only. Default 300.
  vtkSetMacro(FloatDensity, double);
  vtkGetMacro(FloatDensity, double);
  ///@}

  ///@{
  /// Standard deviation of sizes and angles as part of their means, 0 to 0.5. Default 0.18.
  vtkSetMacro(Variation, double);
  vtkGetMacro(Variation, double);
  ///@}

  ///@{
  /// Color of the blades: red, green, blue, each 0 to 1. Default 0.745 0.533 0.188.
  vtkSetVector3Macro(BladeColor, double);
  vtkGetVector3Macro(BladeColor, double);
  ///@}

  ///@{
  /// Color of stipes and holdfast: red, green, blue, each 0 to 1. Default 0.502 0.353 0.157.
  vtkSetVector3Macro(StipeColor, double);
  vtkGetVector3Macro(StipeColor, double);
  ///@}

protected:
  vtkSeaweedSource();
  ~vtkSeaweedSource() override;

  bool Grow(const littoral::PlantLevelOptions& options, littoral::PlantPrototype& prototype) override;

  int Preset;
  int SegmentsPerBranch;
  int Form;
  int NumberOfFronds;
  double HoldfastRadius;
  double SpreadAngle;
  double StipeLength;
  double StipeRadius;
  double BladeLength;
  double BladeWidth;
  double BladeThickness;
  double Ruffle;
  double BladeSpacing;
  double FloatRadius;
  double StipeModulus;
  double BladeModulus;
  double DampingRatio;
  double StipeDensity;
  double BladeDensity;
  double FloatDensity;
  double Variation;
  double BladeColor[3];
  double StipeColor[3];

private:
  vtkSeaweedSource(const vtkSeaweedSource&) = delete;
  void operator=(const vtkSeaweedSource&) = delete;
};

#endif
