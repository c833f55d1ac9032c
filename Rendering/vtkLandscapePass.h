// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLandscapePass
 * @brief   light whatever a renderer shows by sun and sky
 *
 * A render pass that any vtkRenderer takes: `renderer->SetPass(pass)`. It lights all surfaces with Lighting on, also
 * those of instances and of composite data, in place of the lights of the renderer; their colors and textures are
 * albedos in the code of sRGB. x is to the east, y to the north and z up; lengths are metres. Surfaces shade each other
 * from the sun, by maps of depths that are drawn anew only where something moved, and from the sky.
 *
 * Shaders of surfaces define LandscapeLight, by which a user's own replacements in them may tell that their color is an
 * albedo. What is picked, what no light changes (Lighting off, or Diffuse 0), volumes and annotations are drawn as
 * without the pass.
 */
#ifndef vtkLandscapePass_h
#define vtkLandscapePass_h

#include "LittoralRenderingModule.h" // for export macro
#include "vtkRenderPass.h"

#include <memory> // for private members
#include <string> // for what is invalid

class vtkInformationDoubleKey;
class vtkInformationIdTypeKey;
class vtkInformationIntegerKey;
class vtkMultiProcessController;
class vtkPolyDataMapper;
class vtkProp;
class vtkRenderWindow;
class vtkRenderer;

class LITTORALRENDERING_EXPORT vtkLandscapePass : public vtkRenderPass
{
public:
  static vtkLandscapePass* New();
  vtkTypeMacro(vtkLandscapePass, vtkRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Skies: that of clear air under the sun, or the same luminance from everywhere and no sun. */
  enum SkyType
  {
    Clear,
    Even
  };
  ///@{
  /** Sky; default Clear. */
  vtkSetClampMacro(Sky, int, Clear, Even);
  vtkGetMacro(Sky, int);
  void SetSkyToClear() { this->SetSky(Clear); }
  void SetSkyToEven() { this->SetSky(Even); }
  ///@}

  /** Sources of the sun's place: two angles, or a moment and a place on earth. */
  enum SunPlacementType
  {
    Angles,
    Clock
  };
  ///@{
  /** Source of the sun's place; default Angles. */
  vtkSetClampMacro(SunPlacement, int, Angles, Clock);
  vtkGetMacro(SunPlacement, int);
  void SetSunPlacementToAngles() { this->SetSunPlacement(Angles); }
  void SetSunPlacementToClock() { this->SetSunPlacement(Clock); }
  ///@}
  ///@{
  /** Elevation of the sun above the horizon [degrees], -90 to 90; default 35. */
  vtkSetMacro(SunElevation, double);
  vtkGetMacro(SunElevation, double);
  ///@}
  ///@{
  /** Azimuth of the sun, clockwise from north [degrees]; default 235. */
  vtkSetMacro(SunAzimuth, double);
  vtkGetMacro(SunAzimuth, double);
  ///@}
  ///@{
  /** Year, month and day of Universal Time; default 2026 6 21. */
  vtkSetVector3Macro(Date, int);
  vtkGetVector3Macro(Date, int);
  ///@}
  ///@{
  /** Hours of Universal Time since midnight, also below 0 and above 24; default 9. */
  vtkSetMacro(Hours, double);
  vtkGetMacro(Hours, double);
  ///@}
  ///@{
  /** Latitude [degrees north], -90 to 90; default 54. */
  vtkSetMacro(Latitude, double);
  vtkGetMacro(Latitude, double);
  ///@}
  ///@{
  /** Longitude [degrees east], -180 to 180; default 8. */
  vtkSetMacro(Longitude, double);
  vtkGetMacro(Longitude, double);
  ///@}

  ///@{
  /** Turbidity of the air: 1 without aerosols, 2 very clear, 10 thick haze; default 2.5. */
  vtkSetMacro(Turbidity, double);
  vtkGetMacro(Turbidity, double);
  ///@}
  ///@{
  /** Distance at which 2 % of the contrast of a board with the horizon is left [m], above 0; default 30000. */
  vtkSetMacro(Visibility, double);
  vtkGetMacro(Visibility, double);
  ///@}

  ///@{
  /** Visibility in dense fog [m], not negative; default 0: there is none. */
  vtkSetMacro(FogVisibility, double);
  vtkGetMacro(FogVisibility, double);
  ///@}
  ///@{
  /** Height up to which fog is dense [m]; default 0. */
  vtkSetMacro(FogLevel, double);
  vtkGetMacro(FogLevel, double);
  ///@}
  ///@{
  /** Scale height of fog above FogLevel, where it thins out by exp(-z / FogScaleHeight) [m], above 0; default 10. */
  vtkSetMacro(FogScaleHeight, double);
  vtkGetMacro(FogScaleHeight, double);
  ///@}

  ///@{
  /** Part of the sky that clouds cover, 0 to 1; their shadows are on the ground. Default 0.3. */
  vtkSetClampMacro(CloudCover, double, 0.0, 1.0);
  vtkGetMacro(CloudCover, double);
  ///@}
  ///@{
  /** Height of the clouds [m], above that of the eye; default 1500. */
  vtkSetMacro(CloudHeight, double);
  vtkGetMacro(CloudHeight, double);
  ///@}
  ///@{
  /** Way that the clouds have drifted to the east and to the north [m]; default 0 0. */
  vtkSetVector2Macro(CloudDrift, double);
  vtkGetVector2Macro(CloudDrift, double);
  ///@}

  /** Sources of the exposure: the light on a level ground, or a number. */
  enum ExposureType
  {
    Incident,
    Manual
  };
  ///@{
  /** Source of the exposure; default Incident. */
  vtkSetClampMacro(Exposure, int, Incident, Manual);
  vtkGetMacro(Exposure, int);
  void SetExposureToIncident() { this->SetExposure(Incident); }
  void SetExposureToManual() { this->SetExposure(Manual); }
  ///@}
  ///@{
  /** Exposure value at ISO 100 for the exposure Manual; default 15, of a sunny day. */
  vtkSetMacro(ExposureValue, double);
  vtkGetMacro(ExposureValue, double);
  ///@}
  ///@{
  /** Correction of the exposure by steps of a factor of 2; default 0.5, as most that grows is darker than grey. */
  vtkSetMacro(ExposureCompensation, double);
  vtkGetMacro(ExposureCompensation, double);
  ///@}
  ///@{
  /** Film's curve with a shoulder towards white, off for colors in proportion to luminances; default on. */
  vtkSetMacro(FilmCurve, bool);
  vtkGetMacro(FilmCurve, bool);
  vtkBooleanMacro(FilmCurve, bool);
  ///@}

  ///@{
  /**
   * Whether surfaces with a color map are lit by sun and sky, through air. Default off: the lights of the renderer are
   * theirs, so that they look as without this pass, beside a legend; they cast shadows.
   */
  vtkSetMacro(LightsColorMaps, bool);
  vtkGetMacro(LightsColorMaps, bool);
  vtkBooleanMacro(LightsColorMaps, bool);
  ///@}
  ///@{
  /**
   * Diameter of the lens [m], which blurs what is not in focus, 0 for a sharp picture: of a focal length f and a number
   * N it is f/N. None in the quality Fast and in parallel projection. Default 0.
   */
  vtkSetClampMacro(Aperture, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Aperture, double);
  ///@}
  ///@{
  /** Distance of what is in focus, along the view's axis [m], above 0; default 10. */
  vtkSetMacro(FocusDistance, double);
  vtkGetMacro(FocusDistance, double);
  ///@}

  ///@{
  /** Shadows of the sun; default on. */
  vtkSetMacro(Shadows, bool);
  vtkGetMacro(Shadows, bool);
  vtkBooleanMacro(Shadows, bool);
  ///@}
  ///@{
  /** Distance from the eye within which shadows are sharp [m], above 0; default 150. */
  vtkSetMacro(ShadowDistance, double);
  vtkGetMacro(ShadowDistance, double);
  ///@}
  ///@{
  /** Texels along a side of a map of depths, 16 to 8192; default 2048. */
  vtkSetClampMacro(MapSize, int, 16, 8192);
  vtkGetMacro(MapSize, int);
  ///@}
  /**
   * Qualities. Fast: without grass, shafts of light and shade where things meet, with maps that are coarser near the
   * eye and seldom drawn anew, and surfaces in pixels of 1.5 times the side, for processors that draw. Best: with four
   * samples a pixel, for edges and leaves without steps, and soft shadows.
   */
  enum QualityType
  {
    Fast,
    Good,
    Best
  };
  ///@{
  /** Quality of pictures over their cost; default Good. */
  vtkSetClampMacro(Quality, int, Fast, Best);
  vtkGetMacro(Quality, int);
  void SetQualityToFast() { this->SetQuality(Fast); }
  void SetQualityToGood() { this->SetQuality(Good); }
  void SetQualityToBest() { this->SetQuality(Best); }
  ///@}
  ///@{
  /**
   * Pictures in haste, as while a camera is dragged: as Fast, in pixels of a side of their own; default off.
   */
  vtkSetMacro(Draft, bool);
  vtkGetMacro(Draft, bool);
  vtkBooleanMacro(Draft, bool);
  ///@}
  ///@{
  /** Side of the pixels in which surfaces of pictures in haste are drawn and lit [pixels], 1 to 4; default 2. */
  vtkSetClampMacro(DraftPixelSize, int, 1, 4);
  vtkGetMacro(DraftPixelSize, int);
  ///@}
  /** Side of the pixels in which surfaces of the next picture are drawn and lit [pixels], by Quality and Draft. */
  double GetPixelSize();
  ///@{
  /** Distance of surfaces that hide the sky from a place [m], 0 for none; default 5. */
  vtkSetClampMacro(OcclusionRadius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(OcclusionRadius, double);
  ///@}

  ///@{
  /**
   * Distance of surfaces that hide the sky from what they meet, as under grass and at trunks, by the depths of the
   * picture [m], 0 for none; none in the quality Fast. Default 0.5.
   */
  vtkSetClampMacro(ContactRadius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ContactRadius, double);
  ///@}

  ///@{
  /**
   * Distance from the eye to which grass has blades on props of the material Ground [m], 0 for no grass; default 30. An
   * eye twice as high over the ground sees none.
   */
  vtkSetClampMacro(CoverRadius, double, 0.0, 200.0);
  vtkGetMacro(CoverRadius, double);
  ///@}
  ///@{
  /** Height of the grass [m]; default 0.3. */
  vtkSetClampMacro(CoverHeight, double, 0.0, 3.0);
  vtkGetMacro(CoverHeight, double);
  ///@}
  ///@{
  /** Color of the grass in the code of sRGB; default 0.46 0.52 0.23. */
  vtkSetVector3Macro(CoverColor, double);
  vtkGetVector3Macro(CoverColor, double);
  ///@}

  ///@{
  /** Density of herbs and flowers in the grass, over the largest, 0 to 1; default 0.4. */
  vtkSetClampMacro(CoverHerbs, double, 0.0, 1.0);
  vtkGetMacro(CoverHerbs, double);
  ///@}
  ///@{
  /** Density of fallen leaves, over the largest, 0 to 1; default 0.3. */
  vtkSetClampMacro(CoverLitter, double, 0.0, 1.0);
  vtkGetMacro(CoverLitter, double);
  ///@}
  ///@{
  /** Density of stones, over the largest, 0 to 1; default 0.3. */
  vtkSetClampMacro(CoverStones, double, 0.0, 1.0);
  vtkGetMacro(CoverStones, double);
  ///@}

  ///@{
  /**
   * Part of a level ground that woods cover, as they are seen from a kilometre or more, and more where it slopes: for
   * terrains without trees of their own, 0 to 1; default 0.
   */
  vtkSetClampMacro(WoodCover, double, 0.0, 1.0);
  vtkGetMacro(WoodCover, double);
  ///@}

  ///@{
  /**
   * Part of all surfaces that is wet, as after rain, 0 to 1; default 0. A film of water mirrors the sky and the sun
   * there, and ground is darker, with puddles where it is level.
   */
  vtkSetClampMacro(Wetness, double, 0.0, 1.0);
  vtkGetMacro(Wetness, double);
  ///@}

  ///@{
  /** Mean height of the surfaces of water [m], at which the eye goes under water; default 0. */
  vtkSetMacro(WaterLevel, double);
  vtkGetMacro(WaterLevel, double);
  ///@}
  ///@{
  /** Absorption of red, green and blue light by the water [1/m]; default 0.32 0.08 0.06. */
  vtkSetVector3Macro(WaterAbsorption, double);
  vtkGetVector3Macro(WaterAbsorption, double);
  ///@}
  ///@{
  /** Scattering of red, green and blue light by the water [1/m]; default 0.06 0.07 0.07. */
  vtkSetVector3Macro(WaterScattering, double);
  vtkGetVector3Macro(WaterScattering, double);
  ///@}
  ///@{
  /**
   * Variance of the slopes of the water, in both directions together, that its mesh does not have, 0 to 0.2: that of a
   * wind of U m/s is 0.003 + 0.00512 U in all (Cox and Munk 1954); default 0.02.
   */
  vtkSetClampMacro(WaterSlopeVariance, double, 0.0, 0.2);
  vtkGetMacro(WaterSlopeVariance, double);
  ///@}
  ///@{
  /**
   * Variance of the slopes of the waves that the water's mesh has, in both directions together, 0 to 0.2: they gather
   * the light below it too, but where their statistics tell and not where they are seen; default 0.
   */
  vtkSetClampMacro(WaterMeshVariance, double, 0.0, 0.2);
  vtkGetMacro(WaterMeshVariance, double);
  ///@}
  ///@{
  /**
   * Waves with these slopes, as far as pixels show them, and their light below the surface, in patterns and in shafts;
   * off: slopes by their statistics alone. Default on.
   */
  vtkSetMacro(WaterRipples, bool);
  vtkGetMacro(WaterRipples, bool);
  vtkBooleanMacro(WaterRipples, bool);
  ///@}
  ///@{
  /** Time of these waves [s], any finite one; default 0. */
  vtkSetMacro(WaterTime, double);
  vtkGetMacro(WaterTime, double);
  ///@}

  ///@{
  /** Stretch of the surface of water below which it has foam, by the point array "Jacobian", or 1 - "Foam"; default
   * 0.42. */
  vtkSetMacro(FoamThreshold, double);
  vtkGetMacro(FoamThreshold, double);
  ///@}

  ///@{
  /**
   * Height over WaterLevel to which waves run up the ground of a shore, and depth at which they begin to foam there
   * [m], 0 to 10; default 0: no shore is drawn. Ground below it is wet; fronts of foam run up at WaterTime every 5 s.
   */
  vtkSetClampMacro(ShoreRunUp, double, 0.0, 10.0);
  vtkGetMacro(ShoreRunUp, double);
  ///@}

  ///@{
  /** Part of the light on the far side of a prop that leaves it on the near side, as of leaves, 0 to 1. */
  static vtkInformationDoubleKey* TRANSMITTANCE();
  static void SetTransmittance(vtkProp* prop, double transmittance);
  static double GetTransmittance(vtkProp* prop);
  ///@}

  /**
   * Materials: a surface of the color that it has; a ground, whose color is that of what grows there; grass, whose
   * color is a part of CoverColor; the surface of water, below which what is seen is in the water; that of a river or
   * brook, at any height, whose bed is 0.8 m below it; bark of trees, of the color that it has, with furrows.
   */
  enum MaterialType
  {
    Surface,
    Ground,
    Cover,
    Water,
    River,
    Bark
  };
  ///@{
  /**
   * Material of a prop; Surface for one without this key, and for one with a color map. Water has foam by the point
   * array "Jacobian" of its data, the stretch of its surface, and "Foam", what is left of former ones, if there is one,
   * in strings that "Displacement" carries, if the prop has its mapper; a River grows over at its rims by "Bank", 1 and
   * -1 at its banks, and mirrors these by "ChannelWidth" [m].
   */
  static vtkInformationIntegerKey* MATERIAL();
  static void SetMaterial(vtkProp* prop, int material);
  static int GetMaterial(vtkProp* prop);
  /** Whether a prop maps scalars to colors. */
  static bool HasColorMap(vtkProp* prop);
  /** Lets a mapper of water tell its shaders of the point arrays "Jacobian", "Foam", "Displacement", "Bank" and
   * "ChannelWidth", as SetMaterial() does. */
  static void MapWaterArrays(vtkPolyDataMapper* mapper);
  ///@}
  /**
   * Key of the camera of a map of depths in which leaves are not told apart (vtkCamera::GetInformation()): a mapper may
   * draw coarser shapes in it.
   */
  static vtkInformationIntegerKey* COARSE_MAP();
  /**
   * Key of a prop that casts other shadows in coarse maps: a number that changes with these and not with what else its
   * mapper shows, 0 for none.
   */
  static vtkInformationIdTypeKey* COARSE_SHAPE();
  ///@{
  /** Sky behind the surfaces, off where nothing is drawn there; default on. */
  vtkSetMacro(Background, bool);
  vtkGetMacro(Background, bool);
  vtkBooleanMacro(Background, bool);
  ///@}
  ///@{
  /**
   * Processes of which each draws a part of the surfaces, which shade each other where DrawMaps() is called on all;
   * null by default: this process alone.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}
  /**
   * Draws the maps of depths for the next picture, with the renderer's camera, on all processes of Controller together.
   * Without it Render() draws them, of the surfaces of this process.
   */
  void DrawMaps(vtkRenderer* renderer);

  /** Whether a window is drawn by a processor, as by Mesa's llvmpipe, rather than by a graphics card. */
  static bool IsDrawnBySoftware(vtkRenderWindow* window);

  /** Direction towards the sun, of length 1, by the properties. */
  void GetSunDirection(double direction[3]) VTK_SIZEHINT(3);
  /** Light of the sun at right angles to it in the last picture, by red, green and blue [klx]. */
  void GetSunLight(double light[3]) VTK_SIZEHINT(3);
  /** Light of the sky and the earth on a plane in the last picture by its normal, without the sun [klx]. */
  void GetSkyLight(double nx, double ny, double nz, double light[3]) VTK_SIZEHINT(light, 3);
  /** Luminance of the sky in a direction in the last picture [kcd/m2]. */
  void GetSkyLuminance(double x, double y, double z, double luminance[3]) VTK_SIZEHINT(luminance, 3);
  /** Exposure of the last picture: 1 over the luminance of a white without FilmCurve [m2/kcd]. */
  double GetExposureFactor();

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkLandscapePass();
  ~vtkLandscapePass() override;

private:
  vtkLandscapePass(const vtkLandscapePass&) = delete;
  void operator=(const vtkLandscapePass&) = delete;

  std::string WhyInvalid() const;
  int GetQualityNow() const { return this->Draft ? Fast : this->Quality; }
  void TakeShown(vtkRenderer* renderer, vtkMultiProcessController* processes);
  void TakeLight();
  void TakeCamera(vtkRenderer* renderer);
  void ShareSurfaces(vtkRenderer* renderer);
  void RenderMaps(vtkRenderer* renderer, vtkMultiProcessController* processes);

  struct Internals;
  std::unique_ptr<Internals> Own;

  int Sky;
  int SunPlacement;
  double SunElevation;
  double SunAzimuth;
  int Date[3];
  double Hours;
  double Latitude;
  double Longitude;
  double Turbidity;
  double Visibility;
  double FogVisibility;
  double FogLevel;
  double FogScaleHeight;
  double CloudCover;
  double CloudHeight;
  double CloudDrift[2];
  int Exposure;
  double ExposureValue;
  double ExposureCompensation;
  bool FilmCurve;
  bool LightsColorMaps;
  double Aperture;
  double FocusDistance;
  bool Shadows;
  double ShadowDistance;
  int MapSize;
  int Quality;
  bool Draft;
  int DraftPixelSize;
  double OcclusionRadius;
  double ContactRadius;
  double CoverRadius;
  double CoverHeight;
  double CoverColor[3];
  double CoverHerbs;
  double CoverLitter;
  double CoverStones;
  double WoodCover;
  double Wetness;
  double WaterLevel;
  double WaterAbsorption[3];
  double WaterScattering[3];
  double WaterSlopeVariance;
  double WaterMeshVariance;
  bool WaterRipples;
  double WaterTime;
  double FoamThreshold;
  double ShoreRunUp;
  bool Background;
};

#endif
