// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSeaweedSource
 * @brief   generate a seaweed or seagrass with a flexible skeleton
 *
 * Model of Coulais et al., section 4.2: a skeleton of segments, each with its position and angles relative to its
 * parent, and meshes that follow the segments. A Tuft has fronds that consist of a stipe and an undivided blade; a
 * Canopy has long stipes with blades at regular intervals, each held up by a float; a Meadow has shoots of narrow
 * leaves on a rhizome. Preset selects the parameters of a species; with Custom all of them can be set.
 *
 * Outputs and errors as in vtkPlantSource, for use with vtkPlantScatterFilter. `High/Skin` holds the round parts,
 * `High/Leaves` the blades. `Medium` has the same stipes with fewer corners (`Trunk`) and blades without ruffles
 * (`Crown`); `Low` has four upright polygons. Output 1 is the color texture of a blade, for `Crown`, of size
 * TextureSize; output 2 is the gray relief texture of a blade, for `Leaves`. CrownJitter is not used.
 *
 * `High/Skeleton` has one root, the holdfast. Its point arrays, in addition to those of vtkPlantSource: `Tissue` (0
 * stipe, 1 blade, 2 float, 3 holdfast), `Width` and `Thickness` [m] of the elliptical cross section, `Across`
 * (direction of the width), `Length` [m], `YoungModulus` [Pa], `DampingRatio`, `Density` [kg/m3], and h, theta and phi
 * of the paper: `Attachment` [m], `RestTheta`, `RestPhi` [rad]. A node carries the values of the segment that starts
 * there, a tip those of the segment that ends there. Mass and stiffness are computed from these arrays, so that a
 * scaled plant has those of its size.
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
  /**
   * Species, a PresetType; default SugarKelp. The parameters below but SegmentsPerBranch are ignored unless it is
   * Custom.
   */
  vtkSetMacro(Preset, int);
  vtkGetMacro(Preset, int);
  void SetPresetToCustom() { this->SetPreset(Custom); }
  void SetPresetToSugarKelp() { this->SetPreset(SugarKelp); }
  void SetPresetToGiantKelp() { this->SetPreset(GiantKelp); }
  void SetPresetToEelgrass() { this->SetPreset(Eelgrass); }
  const char* GetPresetAsString() const;
  ///@}

  ///@{
  /**
   * Number of segments per frond or stipe, with any preset, 2 to 64; default 10. Segments of blades are shorter towards
   * the base; the blades of a Canopy have a quarter of the number, at least 2.
   */
  vtkSetMacro(SegmentsPerBranch, int);
  vtkGetMacro(SegmentsPerBranch, int);
  ///@}

  ///@{
  /**
   * Growth form, a FormType; default Tuft. Tuft: fronds that consist of a stipe and an undivided blade. Canopy: long
   * stipes with blades at regular intervals, each on a float. Meadow: shoots of narrow leaves on a rhizome.
   */
  vtkSetMacro(Form, int);
  vtkGetMacro(Form, int);
  void SetFormToTuft() { this->SetForm(Tuft); }
  void SetFormToCanopy() { this->SetForm(Canopy); }
  void SetFormToMeadow() { this->SetForm(Meadow); }
  ///@}

  ///@{
  /**
   * Number of fronds (Tuft), stipes (Canopy) or leaves (Meadow), 1 to 500; default 7.
   */
  vtkSetMacro(NumberOfFronds, int);
  vtkGetMacro(NumberOfFronds, int);
  ///@}

  ///@{
  /**
   * Radius of the holdfast, or of the patch of a Meadow [m], 0.001 to 5; default 0.07.
   */
  vtkSetMacro(HoldfastRadius, double);
  vtkGetMacro(HoldfastRadius, double);
  ///@}

  ///@{
  /**
   * Mean tilt of the fronds from the vertical at their base [degrees], 0 to 60; default 22.
   */
  vtkSetMacro(SpreadAngle, double);
  vtkGetMacro(SpreadAngle, double);
  ///@}

  ///@{
  /**
   * Length of a stipe [m], 0 to 100; default 0.3. A Meadow has no stipes.
   */
  vtkSetMacro(StipeLength, double);
  vtkGetMacro(StipeLength, double);
  ///@}

  ///@{
  /**
   * Radius of a stipe at its base, or of the rhizome of a Meadow [m], 0.0001 to 0.5; default 0.006.
   */
  vtkSetMacro(StipeRadius, double);
  vtkGetMacro(StipeRadius, double);
  ///@}

  ///@{
  /**
   * Mean length of a blade [m], 0.01 to 20; default 1.7.
   */
  vtkSetMacro(BladeLength, double);
  vtkGetMacro(BladeLength, double);
  ///@}

  ///@{
  /**
   * Mean maximum width of a blade [m], 0.0005 to 3; default 0.2.
   */
  vtkSetMacro(BladeWidth, double);
  vtkGetMacro(BladeWidth, double);
  ///@}

  ///@{
  /**
   * Thickness of a blade [m], 0.00001 to 0.1; default 0.002.
   */
  vtkSetMacro(BladeThickness, double);
  vtkGetMacro(BladeThickness, double);
  ///@}

  ///@{
  /**
   * Amplitude of the undulating blade margins relative to half the blade width, 0 to 1; default 0.3.
   */
  vtkSetMacro(Ruffle, double);
  vtkGetMacro(Ruffle, double);
  ///@}

  ///@{
  /**
   * Distance between blades along a stipe [m], 0.01 to 20; default 0.35. Used only by a Canopy.
   */
  vtkSetMacro(BladeSpacing, double);
  vtkGetMacro(BladeSpacing, double);
  ///@}

  ///@{
  /**
   * Radius of the float at the base of a blade [m], 0 (no float) to 0.2; default 0.018. Used only by a Canopy.
   */
  vtkSetMacro(FloatRadius, double);
  vtkGetMacro(FloatRadius, double);
  ///@}

  ///@{
  /**
   * Young's modulus E of stipes and floats [Pa], 1e3 to 1e12; default 3e7. The joint at the base of a segment of length
   * L has the rotational stiffness E I / L.
   */
  vtkSetMacro(StipeModulus, double);
  vtkGetMacro(StipeModulus, double);
  ///@}

  ///@{
  /**
   * Young's modulus of blades [Pa], 1e3 to 1e12; default 4e6.
   */
  vtkSetMacro(BladeModulus, double);
  vtkGetMacro(BladeModulus, double);
  ///@}

  ///@{
  /**
   * Structural damping ratio of the tissue, 0 to 10; default 0.05. The hydrodynamic damping is not part of it.
   */
  vtkSetMacro(DampingRatio, double);
  vtkGetMacro(DampingRatio, double);
  ///@}

  ///@{
  /**
   * Density of stipes [kg/m3], 50 to 3000; default 1020. Sea water has about 1025.
   */
  vtkSetMacro(StipeDensity, double);
  vtkGetMacro(StipeDensity, double);
  ///@}

  ///@{
  /**
   * Density of blades including their gas [kg/m3], 50 to 3000; default 1005.
   */
  vtkSetMacro(BladeDensity, double);
  vtkGetMacro(BladeDensity, double);
  ///@}

  ///@{
  /**
   * Density of floats including their gas [kg/m3], 50 to 3000; default 300. Used only by a Canopy.
   */
  vtkSetMacro(FloatDensity, double);
  vtkGetMacro(FloatDensity, double);
  ///@}

  ///@{
  /**
   * Standard deviation of sizes and angles relative to their means, 0 to 0.5; default 0.18.
   */
  vtkSetMacro(Variation, double);
  vtkGetMacro(Variation, double);
  ///@}

  ///@{
  /**
   * Color of the blades as red, green, blue, each 0 to 1; default 0.745 0.533 0.188.
   */
  vtkSetVector3Macro(BladeColor, double);
  vtkGetVector3Macro(BladeColor, double);
  ///@}

  ///@{
  /**
   * Color of stipes and holdfast as red, green, blue, each 0 to 1; default 0.502 0.353 0.157.
   */
  vtkSetVector3Macro(StipeColor, double);
  vtkGetVector3Macro(StipeColor, double);
  ///@}

protected:
  vtkSeaweedSource();
  ~vtkSeaweedSource() override;

  littoral::PlantPrototype Grow(const littoral::PlantLevelOptions& options) override;

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
