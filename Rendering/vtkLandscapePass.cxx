// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLandscapePass.h"

#include "CasterState.h"
#include "Geometry/SrgbCode.h"
#include "GlassPass.h"
#include "GroundCover.h"
#include "Light/SunPosition.h"
#include "Lighting.h"
#include "LightingQuad.h"
#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "OpenGL.h"
#include "SurfacePass.h"
#include "Uniforms.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkCommunicator.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkInformationIdTypeKey.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkLightsPass.h"
#include "vtkMapper.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOverlayPass.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkTextureObject.h"
#include "vtkTranslucentPass.h"
#include "vtkVolumetricPass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

namespace
{

/// A pass that calls a function.
class CallPass : public vtkRenderPass
{
public:
  static CallPass* New();
  vtkTypeMacro(CallPass, vtkRenderPass);
  void Render(const vtkRenderState* state) override { this->Call(state); }

  std::function<void(const vtkRenderState*)> Call;
};
vtkStandardNewMacro(CallPass);

vtkSmartPointer<vtkRenderPass> Sequence(const std::vector<vtkRenderPass*>& parts)
{
  vtkNew<vtkRenderPassCollection> passes;
  for (vtkRenderPass* part : parts)
  {
    passes->AddItem(part);
  }
  auto sequence = vtkSmartPointer<vtkSequencePass>::New();
  sequence->SetPasses(passes);
  return sequence;
}

/// Keys of a prop, which it gets if it has none.
vtkInformation* KeysOf(vtkProp* prop)
{
  if (!prop->GetPropertyKeys())
  {
    prop->SetPropertyKeys(vtkNew<vtkInformation>());
  }
  return prop->GetPropertyKeys();
}

constexpr double FastPixelSize = 1.5; // side of the pixels of surfaces in the quality Fast [pixels]

bool IsGround(vtkProp* prop)
{
  return vtkLandscapePass::GetMaterial(prop) == vtkLandscapePass::Ground;
}

bool IsSea(vtkProp* prop)
{
  return vtkLandscapePass::GetMaterial(prop) == vtkLandscapePass::Water;
}

bool IsBark(vtkProp* prop)
{
  return vtkLandscapePass::GetMaterial(prop) == vtkLandscapePass::Bark;
}

bool IsWater(vtkProp* prop)
{
  return IsSea(prop) || vtkLandscapePass::GetMaterial(prop) == vtkLandscapePass::River;
}

/// Lets shaders take the lights' directions anew: VTK keeps those that a map saw until lights or camera change.
void TouchLights(vtkLightCollection* lights)
{
  vtkCollectionSimpleIterator next;
  lights->InitTraversal(next);
  while (vtkLight* light = lights->GetNextLight(next))
  {
    light->Modified();
  }
}

/**
 * Key of a picture of a level white surface of a luminance [kcd/m2]: its place between black and white, which an eye
 * that is used to the light lowers as it gets dark (Krawczyk, Myszkowski, Seidel, Perceptual effects in real-time tone
 * mapping, 2005), over that of a bright day.
 */
double KeyOf(double luminance)
{
  const auto key = [](double candelas) { return 1.03 - 2.0 / (2.0 + std::log10(candelas + 1.0)); };
  constexpr double brightDay = 3e4;
  return key(1e3 * luminance) / key(brightDay);
}

}

vtkInformationKeyMacro(vtkLandscapePass, TRANSMITTANCE, Double);
vtkInformationKeyMacro(vtkLandscapePass, MATERIAL, Integer);
vtkInformationKeyMacro(vtkLandscapePass, COARSE_MAP, Integer);
vtkInformationKeyMacro(vtkLandscapePass, COARSE_SHAPE, IdType);
vtkStandardNewMacro(vtkLandscapePass);

/// Parts that the pass keeps from frame to frame.
struct vtkLandscapePass::Internals
{
  littoral::Lighting Light;
  littoral::LightingQuad Quad;
  vtkNew<littoral::SurfacePass> Surfaces;
  vtkNew<littoral::GlassPass> Glass;
  vtkNew<vtkCameraPass> Lit;   ///< a picture by sun and sky
  vtkNew<vtkCameraPass> Plain; ///< one as without this pass
  vtkNew<vtkLightsPass> Lights;
  vtkNew<vtkOpaquePass> Opaque;
  vtkNew<vtkTranslucentPass> Translucent;
  littoral::GroundCover Cover;
  std::vector<vtkProp*> Shown;
  std::vector<vtkProp*> Casters; // of shadows: what is shown but water
  vtkSmartPointer<vtkMultiProcessController> Controller;
  bool HasMaps = false; ///< of the next picture
  bool HasTold = false; ///< what the graphics driver lacks
  std::string Reported; ///< the last mistake

  void DrawCover(vtkRenderer* renderer);
  void DrawOpaque(const vtkRenderState* state, bool isWater);
  void TakeSurfaces(const vtkRenderState* state);
};

//----------------------------------------------------------------------------
void vtkLandscapePass::Internals::DrawCover(vtkRenderer* renderer)
{
  if (!this->Light.Maps.Has(littoral::DepthMaps::Ground))
  {
    return;
  }
  std::vector<vtkProp*> blades = this->Cover.GetProps();
  vtkRenderState state(renderer);
  state.SetPropArrayAndCount(blades.data(), static_cast<int>(blades.size()));
  this->Surfaces->Begin(&state);
  this->Cover.Draw(renderer, this->Light.Maps);
  this->Surfaces->End(&state);
}

//----------------------------------------------------------------------------
void vtkLandscapePass::Internals::DrawOpaque(const vtkRenderState* state, bool isWater)
{
  std::vector<vtkProp*> props;
  std::copy_if(state->GetPropArray(), state->GetPropArray() + state->GetPropArrayCount(), std::back_inserter(props),
    [isWater](vtkProp* prop) { return IsWater(prop) == isWater; });
  vtkRenderState part(state->GetRenderer());
  part.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
  part.SetFrameBuffer(state->GetFrameBuffer());
  this->Surfaces->Begin(&part);
  this->Opaque->Render(&part);
  this->Surfaces->End(&part);
}

//----------------------------------------------------------------------------
void vtkLandscapePass::Internals::TakeSurfaces(const vtkRenderState* state)
{
  const auto drawSurfaces = [&] {
    this->DrawOpaque(state, false);
    this->DrawCover(state->GetRenderer());
  };
  const auto drawWater = [&] { this->DrawOpaque(state, true); };
  this->Quad.TakeSurfaces(
    state->GetRenderer(), drawSurfaces, this->Light.HasWater ? std::function<void()>(drawWater) : nullptr);
  this->Quad.RaiseWoods(state->GetRenderer(), this->Light);
}

//----------------------------------------------------------------------------
vtkLandscapePass::vtkLandscapePass()
  : Own(new Internals)
  , Sky(Clear)
  , SunPlacement(Angles)
  , SunElevation(35.0)
  , SunAzimuth(235.0)
  , Date{ 2026, 6, 21 }
  , Hours(9.0)
  , Latitude(54.0)
  , Longitude(8.0)
  , Turbidity(2.5)
  , Visibility(30000.0)
  , FogVisibility(0.0)
  , FogLevel(0.0)
  , FogScaleHeight(10.0)
  , CloudCover(0.3)
  , CloudHeight(1500.0)
  , CloudDrift{ 0.0, 0.0 }
  , Exposure(Incident)
  , ExposureValue(15.0)
  , ExposureCompensation(0.5)
  , FilmCurve(true)
  , LightsColorMaps(false)
  , Aperture(0.0)
  , FocusDistance(10.0)
  , Shadows(true)
  , ShadowDistance(150.0)
  , MapSize(2048)
  , Quality(Good)
  , Draft(false)
  , DraftPixelSize(2)
  , OcclusionRadius(5.0)
  , ContactRadius(0.5)
  , CoverRadius(30.0)
  , CoverHeight(0.3)
  , CoverColor{ 0.46, 0.52, 0.23 }
  , CoverHerbs(0.4)
  , CoverLitter(0.3)
  , CoverStones(0.3)
  , WoodCover(0.0)
  , Wetness(0.0)
  , WaterLevel(0.0)
  , WaterAbsorption{ 0.32, 0.08, 0.06 }
  , WaterScattering{ 0.06, 0.07, 0.07 }
  , WaterSlopeVariance(0.02)
  , WaterMeshVariance(0.0)
  , WaterRipples(true)
  , WaterTime(0.0)
  , FoamThreshold(0.42)
  , ShoreRunUp(0.0)
  , Background(true)
{
  Internals& own = *this->Own;
  vtkNew<vtkVolumetricPass> volumes;
  vtkNew<vtkOverlayPass> overlay;
  vtkNew<CallPass> opaque;
  opaque->Call = [&own](const vtkRenderState* state) {
    own.TakeSurfaces(state);
    own.Quad.Draw(state->GetRenderer(), own.Light);
  };
  vtkNew<CallPass> translucent;
  translucent->Call = [&own](const vtkRenderState* state) {
    vtkProp** props = state->GetPropArray();
    if (std::none_of(props, props + state->GetPropArrayCount(),
          [](vtkProp* prop) { return prop->HasTranslucentPolygonalGeometry() || prop->IsA("vtkVolume"); }))
    {
      return; // depth peeling, which may blend volumes in, takes its pictures of nothing, too
    }
    own.Glass->Begin(state, own.Light);
    // In the order that the renderer is set to, as by depth peeling
    state->GetRenderer()->DeviceRenderTranslucentPolygonalGeometry(state->GetFrameBuffer());
    own.Glass->End(state);
  };
  own.Lit->SetDelegatePass(Sequence({ own.Lights, opaque, translucent, volumes, overlay }));
  own.Plain->SetDelegatePass(Sequence({ own.Lights, own.Opaque, own.Translucent, volumes, overlay }));
}

//----------------------------------------------------------------------------
vtkLandscapePass::~vtkLandscapePass() = default;

//----------------------------------------------------------------------------
void vtkLandscapePass::SetTransmittance(vtkProp* prop, double transmittance)
{
  KeysOf(prop)->Set(TRANSMITTANCE(), std::clamp(transmittance, 0.0, 1.0));
  prop->Modified();
}

//----------------------------------------------------------------------------
double vtkLandscapePass::GetTransmittance(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  return keys && keys->Has(TRANSMITTANCE()) ? keys->Get(TRANSMITTANCE()) : 0.0;
}

//----------------------------------------------------------------------------
void vtkLandscapePass::SetMaterial(vtkProp* prop, int material)
{
  KeysOf(prop)->Set(MATERIAL(), material);
  auto* actor = vtkActor::SafeDownCast(prop);
  auto* mapper = actor ? vtkPolyDataMapper::SafeDownCast(actor->GetMapper()) : nullptr;
  // Those of composites have no such arrays, and since VTK 9.3 say so.
  if ((material == Water || material == River) && mapper && !mapper->IsA("vtkCompositePolyDataMapper"))
  {
    MapWaterArrays(mapper);
  }
  prop->Modified();
}

//----------------------------------------------------------------------------
void vtkLandscapePass::MapWaterArrays(vtkPolyDataMapper* mapper)
{
  mapper->MapDataArrayToVertexAttribute("landscapeStretch", "Jacobian", vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
  mapper->MapDataArrayToVertexAttribute("landscapeLeft", "Foam", vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
  mapper->MapDataArrayToVertexAttribute("landscapeWay", "Displacement", vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
  mapper->MapDataArrayToVertexAttribute("landscapeBank", "Bank", vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
  mapper->MapDataArrayToVertexAttribute(
    "landscapeChannel", "ChannelWidth", vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
}

//----------------------------------------------------------------------------
int vtkLandscapePass::GetMaterial(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  return keys && keys->Has(MATERIAL()) && !HasColorMap(prop) ? keys->Get(MATERIAL()) : Surface;
}

//----------------------------------------------------------------------------
bool vtkLandscapePass::HasColorMap(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  return mapper && mapper->GetScalarVisibility() && mapper->GetColorMode() == VTK_COLOR_MODE_MAP_SCALARS;
}

//----------------------------------------------------------------------------
std::string vtkLandscapePass::WhyInvalid() const
{
  littoral::ParameterCheck check;
  check.Range("SunElevation", this->SunElevation, -90.0, 90.0, "degrees");
  check.Finite("SunAzimuth", this->SunAzimuth, "degrees");
  check.Range("Turbidity", this->Turbidity, 1.0, 10.0);
  check.Positive("Visibility", this->Visibility, "m");
  check.NotNegative("FogVisibility", this->FogVisibility, "m");
  check.Finite("FogLevel", this->FogLevel, "m");
  check.Positive("FogScaleHeight", this->FogScaleHeight, "m");
  check.Finite("CloudHeight", this->CloudHeight, "m");
  check.Finite("CloudDrift, x", this->CloudDrift[0], "m");
  check.Finite("CloudDrift, y", this->CloudDrift[1], "m");
  check.Range("ExposureValue", this->ExposureValue, -20.0, 30.0);
  check.Range("ExposureCompensation", this->ExposureCompensation, -20.0, 20.0);
  check.Positive("FocusDistance", this->FocusDistance, "m");
  check.Positive("ShadowDistance", this->ShadowDistance, "m");
  check.Finite("WaterLevel", this->WaterLevel, "m");
  check.Finite("WaterTime", this->WaterTime, "s");
  check.Finite("FoamThreshold", this->FoamThreshold);
  for (int c = 0; c < 3; ++c)
  {
    check.Range("WaterAbsorption", this->WaterAbsorption[c], 0.0, 100.0, "1/m");
    check.Range("WaterScattering", this->WaterScattering[c], 0.0, 100.0, "1/m");
  }
  if (this->SunPlacement == Clock)
  {
    check.Range("Latitude", this->Latitude, -90.0, 90.0, "degrees");
    check.Range("Longitude", this->Longitude, -180.0, 180.0, "degrees");
    check.Require(
      littoral::WhyInvalid(littoral::UniversalTime{ this->Date[0], this->Date[1], this->Date[2], this->Hours }));
  }
  return check.Reason();
}

//----------------------------------------------------------------------------
void vtkLandscapePass::GetSunDirection(double direction[3])
{
  littoral::SunAngles angles{ this->SunElevation, this->SunAzimuth };
  if (this->SunPlacement == Clock)
  {
    angles =
      littoral::SunAt({ this->Date[0], this->Date[1], this->Date[2], this->Hours }, this->Latitude, this->Longitude);
  }
  const littoral::Vector3 sun = littoral::DirectionOf(angles);
  std::copy_n(&sun.x, 3, direction);
}

//----------------------------------------------------------------------------
void vtkLandscapePass::GetSunLight(double light[3])
{
  std::copy_n(&this->Own->Light.Sky.GetTables().SunLight.x, 3, light);
}

//----------------------------------------------------------------------------
void vtkLandscapePass::GetSkyLight(double nx, double ny, double nz, double light[3])
{
  const littoral::Vector3 found = this->Own->Light.Sky.GetTables().LightOn({ nx, ny, nz });
  std::copy_n(&found.x, 3, light);
}

//----------------------------------------------------------------------------
void vtkLandscapePass::GetSkyLuminance(double x, double y, double z, double luminance[3])
{
  const littoral::Vector3 found = this->Own->Light.Sky.GetTables().LuminanceAt({ x, y, z });
  std::copy_n(&found.x, 3, luminance);
}

//----------------------------------------------------------------------------
double vtkLandscapePass::GetExposureFactor()
{
  return this->Own->Light.Exposure;
}

//----------------------------------------------------------------------------
void vtkLandscapePass::TakeShown(vtkRenderer* renderer, vtkMultiProcessController* processes)
{
  Internals& own = *this->Own;
  own.Shown.clear();
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator next;
  props->InitTraversal(next);
  while (vtkProp* prop = props->GetNextProp(next))
  {
    if (prop->GetVisibility())
    {
      own.Shown.push_back(prop);
    }
  }
  own.Casters.clear();
  std::copy_if(
    own.Shown.begin(), own.Shown.end(), std::back_inserter(own.Casters), [](vtkProp* prop) { return !IsWater(prop); });
  renderer->GetActiveCamera()->GetPosition(&own.Light.Eye.x);
  // A process may have no part of what others show.
  std::array<int, 4> are{};
  bool (*const kinds[])(vtkProp*) = { IsGround, IsWater, IsSea, IsBark };
  std::transform(std::begin(kinds), std::end(kinds), are.begin(),
    [&own](bool (*isOne)(vtkProp*)) { return std::any_of(own.Shown.begin(), own.Shown.end(), isOne) ? 1 : 0; });
  if (processes && processes->GetNumberOfProcesses() > 1)
  {
    const std::array<int, 4> here = are;
    processes->AllReduce(here.data(), are.data(), 4, vtkCommunicator::MAX_OP);
  }
  own.Light.HasGround = are[0] > 0;
  own.Light.HasWater = are[1] > 0;
  own.Light.HasSea = are[2] > 0;
  own.Light.HasBark = are[3] > 0;
  own.Light.IsInWater = own.Light.HasSea && own.Light.Eye.z < this->WaterLevel;
}

//----------------------------------------------------------------------------
void vtkLandscapePass::TakeLight()
{
  littoral::Lighting& lighting = this->Own->Light;
  if (this->Sky == Even)
  {
    lighting.Sky.TakeEven();
  }
  else
  {
    littoral::AirParameters air;
    air.Turbidity = this->Turbidity;
    littoral::Vector3 sun;
    this->GetSunDirection(&sun.x);
    lighting.Sky.TakeClear(air, sun);
  }
  // L exp(-k V) = 0.02 L at the visibility V  (Koschmieder)
  lighting.Extinction = this->Sky == Even ? 0.0 : std::log(50.0) / this->Visibility;
  const bool hasFog = this->Sky == Clear && this->FogVisibility > 0.0;
  lighting.FogExtinction = hasFog ? std::log(50.0) / this->FogVisibility : 0.0;
  lighting.FogLevel = this->FogLevel;
  lighting.FogScaleHeight = this->FogScaleHeight;
  lighting.CloudCover = this->Sky == Even ? 0.0 : this->CloudCover;
  lighting.CloudHeight = this->CloudHeight;
  lighting.CloudDrift = { this->CloudDrift[0], this->CloudDrift[1] };
  lighting.FilmCurve = this->FilmCurve;
  lighting.Background = this->Background;
  lighting.OcclusionRadius = this->OcclusionRadius;
  lighting.ContactRadius = this->GetQualityNow() != Fast ? this->ContactRadius : 0.0;
  lighting.Aperture = this->GetQualityNow() != Fast ? this->Aperture : 0.0;
  lighting.FocusDistance = this->FocusDistance;
  lighting.WantsSoftShadows = this->GetQualityNow() == Best;
  lighting.ContactCounts = { 2, this->GetQualityNow() == Best ? 4 : 3 };
  for (int c = 0; c < 3; ++c)
  {
    lighting.CoverColor[c] = littoral::LinearOfSrgb(this->CoverColor[c]);
  }
  const bool hasGrass = this->GetQualityNow() != Fast && this->CoverRadius > 0.0;
  lighting.Turf = { hasGrass ? this->CoverHeight : 0.0, this->CoverRadius };
  lighting.WoodCover = this->WoodCover;
  lighting.Wetness = this->Wetness;
  lighting.WaterLevel = this->WaterLevel;
  std::copy_n(this->WaterAbsorption, 3, &lighting.WaterAbsorption.x);
  std::copy_n(this->WaterScattering, 3, &lighting.WaterScattering.x);
  lighting.WaterSlopeVariance = this->WaterSlopeVariance;
  lighting.WaterMeshVariance = this->WaterMeshVariance;
  lighting.TakeRipples(this->WaterRipples, this->WaterTime);
  lighting.LightsColorMaps = this->LightsColorMaps;
  this->Own->Surfaces->SetLightsColorMaps(this->LightsColorMaps);
  lighting.HasShafts = this->GetQualityNow() != Fast;
  lighting.ShoreRunUp = this->ShoreRunUp;
  lighting.WaterTime = this->WaterTime;
  lighting.FoamBegins = this->FoamThreshold;
  // White on level ground is white, or luminances of 1.2 cd/m2 2^EV are.
  const littoral::SkyTables& sky = lighting.Sky.GetTables();
  const littoral::Vector3 light = sky.LightOn({ 0.0, 0.0, 1.0 }) + std::max(sky.Sun.z, 0.0) * sky.SunLight;
  // In water the eye is used to what light is left there, by its green.
  const double depth = lighting.IsInWater ? this->WaterLevel - lighting.Eye.z : 0.0;
  const double left = depth > 0.0 ? 0.5 * std::exp(-this->WaterAbsorption[1] * depth) : 1.0;
  const double level = std::max(left * littoral::LuminanceOf(light) / littoral::Pi, 1e-9);
  const double white = this->Exposure == Manual ? 1.2e-3 * std::exp2(this->ExposureValue)
    : this->Sky == Even                         ? level
                                                : level / KeyOf(level);
  lighting.Exposure = std::exp2(this->ExposureCompensation) / white;
}

//----------------------------------------------------------------------------
void vtkLandscapePass::RenderMaps(vtkRenderer* renderer, vtkMultiProcessController* processes)
{
  Internals& own = *this->Own;
  // Normals are there only if there is a light; shaders are built for it once.
  if (renderer->GetLights()->GetNumberOfItems() == 0)
  {
    renderer->CreateLight();
  }
  const littoral::SkyTables& sky = own.Light.Sky.GetTables();
  littoral::DepthMaps::Wish wish;
  wish.Sun = sky.Sun;
  wish.HasSun = this->Shadows && littoral::LuminanceOf(sky.SunLight) > 0.0;
  wish.HasZenith = this->OcclusionRadius > 0.0;
  wish.Occlusion = this->OcclusionRadius;
  wish.Distance = this->ShadowDistance;
  wish.Size = this->MapSize;
  wish.IsInHaste = this->GetQualityNow() == Fast;
  wish.GroundRadius =
    own.Light.HasGround && !own.Light.IsInWater && this->GetQualityNow() != Fast && this->CoverHeight > 0.0
    ? this->CoverRadius
    : 0.0;
  own.Cover.SetSize(this->CoverHeight, this->CoverRadius);
  own.Cover.SetDensities(this->CoverHerbs, this->CoverLitter, this->CoverStones);
  own.Cover.SetSeaLevel(own.Light.HasSea ? this->WaterLevel : -1e9);
  // The same shaders as for the picture: none is built anew.
  vtkRenderState all(renderer);
  all.SetPropArrayAndCount(own.Shown.data(), static_cast<int>(own.Shown.size()));
  own.Surfaces->Begin(&all);
  own.Lights->Render(&all);
  const auto drawCasters = [&](int map) {
    for (vtkProp* prop : own.Casters)
    {
      const bool casts = !littoral::CastsNothing(prop) || !own.Light.Maps.IsCoarse(map);
      if (casts && (map != littoral::DepthMaps::Ground || IsGround(prop)))
      {
        prop->RenderOpaqueGeometry(renderer);
      }
    }
  };
  if (own.Light.Maps.Draw(renderer, own.Shown, own.Casters, wish, drawCasters, processes))
  {
    TouchLights(renderer->GetLights());
  }
  own.Surfaces->End(&all);
}

//----------------------------------------------------------------------------
void vtkLandscapePass::SetController(vtkMultiProcessController* controller)
{
  if (this->Own->Controller != controller)
  {
    this->Own->Controller = controller;
    this->Modified();
  }
}

//----------------------------------------------------------------------------
vtkMultiProcessController* vtkLandscapePass::GetController()
{
  return this->Own->Controller;
}

//----------------------------------------------------------------------------
bool vtkLandscapePass::IsDrawnBySoftware(vtkRenderWindow* window)
{
  window->MakeCurrent();
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const auto has = [name](const char* word) { return name && std::strstr(name, word); };
  return has("llvmpipe") || has("softpipe") || has("SWR");
}

//----------------------------------------------------------------------------
void vtkLandscapePass::DrawMaps(vtkRenderer* renderer)
{
  Internals& own = *this->Own;
  if (!renderer->GetSelector() && this->WhyInvalid().empty())
  {
    this->TakeShown(renderer, own.Controller);
    this->TakeLight();
    this->RenderMaps(renderer, own.Controller);
    own.HasMaps = true;
    this->ShareSurfaces(renderer);
  }
}

//----------------------------------------------------------------------------
/// Processes have the shade of all surfaces, what is below water, and their light where pixels are mixed; one alone has
/// its own without this.
void vtkLandscapePass::ShareSurfaces(vtkRenderer* renderer)
{
  Internals& own = *this->Own;
  this->TakeCamera(renderer);
  const bool hasLens = own.Light.HasLens();
  const bool hasContact = own.Light.ContactRadius > 0.0;
  const bool hasBed = own.Light.HasWater && !own.Light.IsInWater;
  if ((!hasContact && !hasLens && !hasBed) || !own.Controller || own.Controller->GetNumberOfProcesses() < 2)
  {
    return;
  }
  vtkRenderState all(renderer);
  all.SetPropArrayAndCount(own.Shown.data(), static_cast<int>(own.Shown.size()));
  own.Light.Activate(static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()));
  own.Lights->Render(&all);
  own.TakeSurfaces(&all);
  if (hasContact)
  {
    own.Quad.ShareContact(renderer, own.Light, own.Controller);
  }
  if (hasBed)
  {
    own.Quad.ShareBed(own.Controller);
  }
  if (own.Quad.IsMixed(own.Light))
  {
    own.Quad.ShareLit(renderer, own.Light, own.Controller);
  }
  own.Light.Deactivate();
}

//----------------------------------------------------------------------------
void vtkLandscapePass::TakeCamera(vtkRenderer* renderer)
{
  Internals& own = *this->Own;
  own.Quad.SetSamples(this->GetQualityNow() == Best ? 2 : 1);
  own.Quad.SetPixelSize(this->GetPixelSize());
  vtkCamera* camera = renderer->GetActiveCamera();
  own.Light.ToWorld = glm::inverse(littoral::MatrixOf(camera->GetModelViewTransformMatrix()));
  own.Light.IsParallel = camera->GetParallelProjection();
}

//----------------------------------------------------------------------------
double vtkLandscapePass::GetPixelSize()
{
  const double sharpest = this->Quality == Fast ? FastPixelSize : 1.0;
  return std::max(sharpest, this->Draft ? this->DraftPixelSize : 1.0);
}

//----------------------------------------------------------------------------
void vtkLandscapePass::Render(const vtkRenderState* state)
{
  vtkRenderer* renderer = state->GetRenderer();
  Internals& own = *this->Own;
  const std::string reason = renderer->GetSelector() ? std::string() : this->WhyInvalid();
  if (!reason.empty() && own.Reported != reason)
  {
    vtkErrorMacro(<< reason);
  }
  own.Reported = renderer->GetSelector() ? own.Reported : reason;
  if (renderer->GetSelector() || !reason.empty())
  {
    own.Plain->Render(state);
    this->NumberOfRenderedProps = own.Plain->GetNumberOfRenderedProps();
    return;
  }
  if (!own.HasMaps)
  {
    this->TakeShown(renderer, nullptr);
    this->TakeLight();
    this->RenderMaps(renderer, nullptr);
  }
  own.HasMaps = false;
  this->TakeCamera(renderer);
  own.Light.Activate(static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()));
  if (own.Light.LacksSoftShadows() && !own.HasTold)
  {
    own.HasTold = true;
    vtkWarningMacro(<< "Shadows are not soft: the graphics driver has no sampler objects (OpenGL 3.3).");
  }
  own.Lit->Render(state);
  own.Light.Deactivate();
  this->NumberOfRenderedProps = own.Lit->GetNumberOfRenderedProps();
}

//----------------------------------------------------------------------------
void vtkLandscapePass::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& own = *this->Own;
  own.Light.ReleaseGraphicsResources(window);
  own.Quad.ReleaseGraphicsResources(window);
  own.Cover.ReleaseGraphicsResources(window);
  own.Lit->ReleaseGraphicsResources(window);
  own.Plain->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//----------------------------------------------------------------------------
void vtkLandscapePass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Sky: " << this->Sky << "\n";
  os << indent << "SunPlacement: " << this->SunPlacement << "\n";
  os << indent << "SunElevation: " << this->SunElevation << "\n";
  os << indent << "SunAzimuth: " << this->SunAzimuth << "\n";
  os << indent << "Date: " << this->Date[0] << " " << this->Date[1] << " " << this->Date[2] << "\n";
  os << indent << "Hours: " << this->Hours << "\n";
  os << indent << "Latitude: " << this->Latitude << "\n";
  os << indent << "Longitude: " << this->Longitude << "\n";
  os << indent << "Turbidity: " << this->Turbidity << "\n";
  os << indent << "Visibility: " << this->Visibility << "\n";
  os << indent << "CloudCover: " << this->CloudCover << "\n";
  os << indent << "FogVisibility: " << this->FogVisibility << "\n";
  os << indent << "FogLevel: " << this->FogLevel << "\n";
  os << indent << "FogScaleHeight: " << this->FogScaleHeight << "\n";
  os << indent << "CloudHeight: " << this->CloudHeight << "\n";
  os << indent << "CloudDrift: " << this->CloudDrift[0] << " " << this->CloudDrift[1] << "\n";
  os << indent << "Exposure: " << this->Exposure << "\n";
  os << indent << "ExposureValue: " << this->ExposureValue << "\n";
  os << indent << "ExposureCompensation: " << this->ExposureCompensation << "\n";
  os << indent << "FilmCurve: " << (this->FilmCurve ? "on" : "off") << "\n";
  os << indent << "LightsColorMaps: " << this->LightsColorMaps << "\n";
  os << indent << "Aperture: " << this->Aperture << "\n";
  os << indent << "FocusDistance: " << this->FocusDistance << "\n";
  os << indent << "Shadows: " << (this->Shadows ? "on" : "off") << "\n";
  os << indent << "ShadowDistance: " << this->ShadowDistance << "\n";
  os << indent << "MapSize: " << this->MapSize << "\n";
  os << indent << "Quality: " << this->Quality << "\n";
  os << indent << "OcclusionRadius: " << this->OcclusionRadius << "\n";
  os << indent << "ContactRadius: " << this->ContactRadius << "\n";
  os << indent << "Draft: " << (this->Draft ? "on" : "off") << "\n";
  os << indent << "DraftPixelSize: " << this->DraftPixelSize << "\n";
  os << indent << "CoverRadius: " << this->CoverRadius << "\n";
  os << indent << "CoverHeight: " << this->CoverHeight << "\n";
  os << indent << "CoverColor: " << this->CoverColor[0] << " " << this->CoverColor[1] << " " << this->CoverColor[2]
     << "\n";
  os << indent << "CoverHerbs: " << this->CoverHerbs << "\n";
  os << indent << "CoverLitter: " << this->CoverLitter << "\n";
  os << indent << "CoverStones: " << this->CoverStones << "\n";
  os << indent << "WoodCover: " << this->WoodCover << "\n";
  os << indent << "Wetness: " << this->Wetness << "\n";
  os << indent << "WaterLevel: " << this->WaterLevel << "\n";
  os << indent << "WaterAbsorption: " << this->WaterAbsorption[0] << " " << this->WaterAbsorption[1] << " "
     << this->WaterAbsorption[2] << "\n";
  os << indent << "WaterScattering: " << this->WaterScattering[0] << " " << this->WaterScattering[1] << " "
     << this->WaterScattering[2] << "\n";
  os << indent << "WaterSlopeVariance: " << this->WaterSlopeVariance << "\n";
  os << indent << "WaterMeshVariance: " << this->WaterMeshVariance << "\n";
  os << indent << "WaterRipples: " << (this->WaterRipples ? "on" : "off") << "\n";
  os << indent << "WaterTime: " << this->WaterTime << "\n";
  os << indent << "FoamThreshold: " << this->FoamThreshold << "\n";
  os << indent << "ShoreRunUp: " << this->ShoreRunUp << "\n";
  os << indent << "Background: " << (this->Background ? "on" : "off") << "\n";
  os << indent << "Controller: " << this->Own->Controller.Get() << "\n";
}
