// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NaturalDisplay.h"

#include "ColorHelper.h"
#include "Daylight.h"
#include "FirstLook.h"
#include "Scene.h"
#include "SceneView.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkPVDataInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMProxyManager.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMStringListDomain.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace littoral
{
namespace
{

/// The array of natural colors.
constexpr const char* NaturalColors = "RGB";

/// Three numbers of a hint; whether there are as many.
bool ReadPlace(const char* text, double place[3])
{
  std::istringstream numbers(text);
  return static_cast<bool>(numbers >> place[0] >> place[1] >> place[2]);
}

/// Whether bounds are those of a level rectangle.
bool IsLevel(const double bounds[6])
{
  return bounds[0] < bounds[1] && bounds[2] < bounds[3] && bounds[4] == bounds[5];
}

/// Whether bounds are those of a single point.
bool IsPoint(const double bounds[6])
{
  return bounds[0] == bounds[1] && bounds[2] == bounds[3] && bounds[4] == bounds[5];
}

/// Visible representations of a view.
std::vector<vtkSMProxy*> VisibleIn(vtkSMProxy* view)
{
  std::vector<vtkSMProxy*> visible;
  const vtkSMPropertyHelper shown(view, "Representations");
  for (unsigned int k = 0; k < shown.GetNumberOfElements(); ++k)
  {
    vtkSMProxy* one = shown.GetAsProxy(k);
    if (ShowsData(one))
    {
      visible.push_back(one);
    }
  }
  return visible;
}

/// Whether a view shows nothing but what a filter is made of.
bool ShowsUpstream(vtkSMProxy* view, vtkSMProxy* filter)
{
  const std::set<vtkSMProxy*> upstream = UpstreamOf(filter);
  const std::vector<vtkSMProxy*> visible = VisibleIn(view);
  return !visible.empty() && std::all_of(visible.begin(), visible.end(), [&](vtkSMProxy* one) {
    return upstream.count(vtkSMPropertyHelper(one, "Input").GetAsProxy()) == 1;
  });
}

/// Whether proxies are registered by a state file, or by undo and redo.
bool IsLoadingState(vtkSMSessionProxyManager* manager)
{
  return manager->GetInLoadXMLState() || !manager->IsStateUpdateNotificationEnabled();
}

/// Clears a view for what replaces all that it shows.
void HideAll(vtkSMProxy* view)
{
  for (vtkSMProxy* one : VisibleIn(view))
  {
    if (ColorHelper::GetUsingScalarColoring(one))
    {
      ColorHelper::SetScalarBarVisibility(one, view, false);
    }
    vtkSMPropertyHelper(one, "Visibility").Set(0);
    one->UpdateVTKObjects();
  }
}

/// Whether data can be shown in a way: an image has other ways than a surface.
bool Offers(vtkSMProxy* representation, const char* way)
{
  vtkSMProperty* ways = representation->GetProperty("Representation");
  auto* domain = ways ? ways->FindDomain<vtkSMStringListDomain>() : nullptr;
  unsigned int index = 0;
  return domain && domain->IsInDomain(way, index) != 0;
}

bool HasData(vtkPVDataInformation* data)
{
  return data && (data->GetNumberOfPoints() > 0 || data->GetNumberOfRows() > 0);
}

/// Leaves the named properties of a display in its panel, the others behind the gear.
void ShortenPanel(vtkSMProxy* representation, const char* names)
{
  std::istringstream words(names);
  const std::set<std::string> wanted{ std::istream_iterator<std::string>(words), {} };
  auto properties = vtkSmartPointer<vtkSMPropertyIterator>::Take(representation->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    const char* visibility = properties->GetProperty()->GetPanelVisibility();
    const bool isShown = !visibility || std::strcmp(visibility, "default") == 0;
    if (isShown && wanted.count(properties->GetKey()) == 0)
    {
      properties->GetProperty()->SetPanelVisibility("advanced");
    }
  }
}

}

//----------------------------------------------------------------------------
NaturalDisplay::~NaturalDisplay()
{
  StopObserving(this->Pictures);
  StopObserving(this->Displays);
  if (this->Manager)
  {
    this->Manager->RemoveObserver(this->RegisterObserver);
    this->Manager->RemoveObserver(this->StateObserver);
  }
}

//----------------------------------------------------------------------------
void NaturalDisplay::Watch()
{
  if (!this->Manager && this->Owner->GetSession())
  {
    this->Manager = this->Owner->GetSessionProxyManager();
    this->RegisterObserver = this->Manager->AddObserver(vtkCommand::RegisterEvent, this, &NaturalDisplay::OnRegister);
    this->StateObserver = this->Manager->AddObserver(vtkCommand::LoadStateEvent, this, &NaturalDisplay::OnState);
  }
  const double ratio = this->FollowDepth();
  if (ratio != 1.0 && !IsLoadingState(this->Manager))
  {
    ScaleDepths(this->Owner, this->Scene, ratio);
  }
}

//----------------------------------------------------------------------------
void NaturalDisplay::TakeBack()
{
  this->FollowDepth();
}

//----------------------------------------------------------------------------
/// Takes the cameras along with the depth, and tells by how much the depth is another. A state file has its cameras.
double NaturalDisplay::FollowDepth()
{
  const double before = this->Depth;
  this->DepthRatio();
  if (before <= 0.0 || this->Depth <= 0.0 || before == this->Depth || !this->Manager ||
    this->Manager->GetInLoadXMLState())
  {
    return 1.0;
  }
  this->Drag.ScaleDepths(this->Depth / before, ViewsThatShow(this->Manager, this->Owner));
  return this->Depth / before;
}

//----------------------------------------------------------------------------
double NaturalDisplay::DepthRatio()
{
  double ofScene = 0.0;
  if (!this->Scene || this->Scene->GetScalarAttribute("depth", &ofScene) == 0)
  {
    return 1.0;
  }
  this->Depth = vtkSMPropertyHelper(this->Owner, "WaterDepth").GetAsDouble();
  return this->Depth > 0.0 ? this->Depth / ofScene : 1.0;
}

//----------------------------------------------------------------------------
void NaturalDisplay::SetLook(vtkPVXMLElement* look)
{
  this->Look = look;
}

//----------------------------------------------------------------------------
void NaturalDisplay::SetScene(vtkPVXMLElement* scene)
{
  this->Scene = scene;
}

//----------------------------------------------------------------------------
vtkPVXMLElement* NaturalDisplay::LookOf(int port)
{
  vtkPVXMLElement* look = this->Look;
  vtkPVXMLElement* hints = look ? nullptr : this->Owner->GetHints();
  for (unsigned int k = 0; hints && k < hints->GetNumberOfNestedElements(); ++k)
  {
    vtkPVXMLElement* one = hints->GetNestedElement(k);
    const char* of = std::strcmp(one->GetName(), "NaturalDisplay") == 0 ? one->GetAttribute("port") : "";
    const bool isOwn = of && *of && std::strtol(of, nullptr, 10) == port;
    look = isOwn || (!of && !look) ? one : look;
  }
  return look;
}

//----------------------------------------------------------------------------
const char* NaturalDisplay::Hint(const char* name, int port)
{
  vtkPVXMLElement* look = this->LookOf(port);
  return look ? look->GetAttribute(name) : nullptr;
}

//----------------------------------------------------------------------------
void NaturalDisplay::OnRegister(vtkObject*, unsigned long, void* information)
{
  const auto* registered = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(information);
  if (registered->Type != vtkSMProxyManager::RegisteredProxyInformation::PROXY || !registered->GroupName)
  {
    return;
  }
  if (registered->Proxy == this->Owner)
  {
    this->TakeView();
    return;
  }
  if (std::strcmp(registered->GroupName, "representations") != 0)
  {
    return;
  }
  vtkSMProxy* representation = registered->Proxy;
  if (IsLandscapeLight(representation))
  {
    this->HideOtherLights(representation);
    return;
  }
  if (!representation->GetProperty("Input") || !representation->GetProperty("MapScalars"))
  {
    return;
  }
  const vtkSMPropertyHelper input(representation, "Input");
  if (input.GetAsProxy() != this->Owner)
  {
    return;
  }
  this->WatchDisplay(representation);
  if (IsLoadingState(this->Manager))
  {
    return;
  }
  this->KeepSide(vtkSMRenderViewProxy::SafeDownCast(ViewOfScene(this->Manager)));
  if (this->Scene && IsLastOfPipeline(this->Owner))
  {
    this->MakeSceneOf(representation);
    return;
  }
  this->Owner->UpdatePipelineInformation();
  vtkSMRenderViewProxy* view = this->ActiveView();
  if (view && IsEmpty(view))
  {
    this->LookAtInput();
  }
  this->Show(representation, input.GetOutputPort());
  this->SetUpView(input.GetOutputPort());
  this->HideReplaced();
}

//----------------------------------------------------------------------------
/// ParaView shows in a new view what is not for the active one.
void NaturalDisplay::TakeView()
{
  vtkPVXMLElement* hints = this->Owner->GetHints();
  vtkPVXMLElement* view = hints ? hints->FindNestedElementByName("View") : nullptr;
  const char* type = view ? view->GetAttribute("type") : nullptr;
  if (type && std::strcmp(type, "RenderView") == 0 && !IsLoadingState(this->Manager))
  {
    ActivateViewOfScene(this->Manager);
  }
}

//----------------------------------------------------------------------------
/// A view has the light of one Landscape Light, the last that is shown.
void NaturalDisplay::HideOtherLights(vtkSMProxy* light)
{
  vtkSMRenderViewProxy* view = this->ActiveView();
  if (!view || vtkSMPropertyHelper(light, "Input").GetAsProxy() != this->Owner || IsLoadingState(this->Manager))
  {
    return;
  }
  const vtkSMPropertyHelper shown(view, "Representations");
  for (unsigned int k = 0; k < shown.GetNumberOfElements(); ++k)
  {
    vtkSMProxy* other = shown.GetAsProxy(k);
    if (other && other != light && IsLandscapeLight(other))
    {
      vtkSMPropertyHelper(other, "Visibility").Set(0);
      other->UpdateVTKObjects();
    }
  }
}

//----------------------------------------------------------------------------
void NaturalDisplay::HideReplaced()
{
  const char* name = this->Hint("replaces");
  vtkSMRenderViewProxy* view = this->ActiveView();
  if (!name || !view)
  {
    return;
  }
  const vtkSMPropertyHelper replaced(this->Owner, name);
  auto* producer = vtkSMSourceProxy::SafeDownCast(replaced.GetAsProxy());
  if (producer && view->FindRepresentation(producer, replaced.GetOutputPort()))
  {
    vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
    controller->Hide(producer, replaced.GetOutputPort(), view);
  }
}

//----------------------------------------------------------------------------
/// Hides the sources that a scene begins with, as the input of a filter is hidden, and shows the rest.
void NaturalDisplay::MakeSceneOf(vtkSMProxy* representation)
{
  this->Show(representation, 0);
  vtkSMRenderViewProxy* view = this->ActiveView();
  if (!view)
  {
    return;
  }
  this->Look = this->Scene;
  this->SetUpView(0);
  this->Look = nullptr;
  vtkSMPropertyHelper(representation, "Visibility").Set(0);
  representation->UpdateVTKObjects();
  this->Hidden = representation;
  this->WaitForLegend(representation); // which is that of something hidden
  MakeScene(this->Owner, this->Scene, view);
  ScaleDepths(this->Owner, this->Scene, this->DepthRatio());
}

//----------------------------------------------------------------------------
/// A filter that follows the camera has all of its input in sight, before there is a picture from which it could
/// follow.
void NaturalDisplay::LookAtInput()
{
  vtkSMProperty* input = this->Owner->GetProperty("Input");
  const char* elevation = this->Hint("elevation");
  if (!input || !elevation || !this->Owner->GetProperty("FollowCamera") || !this->Owner->GetProperty("ViewPoint") ||
    vtkSMPropertyHelper(this->Owner, "FollowCamera").GetAsInt() == 0)
  {
    return;
  }
  const vtkSMPropertyHelper source(input);
  auto* producer = source.GetNumberOfElements() > 0 ? vtkSMSourceProxy::SafeDownCast(source.GetAsProxy()) : nullptr;
  vtkPVDataInformation* data = producer ? producer->GetDataInformation(source.GetOutputPort()) : nullptr;
  if (!HasData(data))
  {
    return;
  }
  CameraPlace place;
  place.Elevation = std::strtod(elevation, nullptr);
  vtkNew<vtkCamera> camera;
  MoveCamera(camera, place, data->GetBounds());
  vtkSMPropertyHelper(this->Owner, "ViewPoint").Set(camera->GetPosition(), 3);
  vtkSMPropertyHelper(this->Owner, "ViewDirection").Set(camera->GetDirectionOfProjection(), 3);
  vtkSMPropertyHelper(this->Owner, "ViewUp").Set(camera->GetViewUp(), 3);
  this->Owner->UpdateVTKObjects();
}

//----------------------------------------------------------------------------
void NaturalDisplay::Show(vtkSMProxy* representation, int port)
{
  this->Owner->UpdatePipeline();
  vtkPVDataInformation* data = this->Owner->GetDataInformation(port);
  if (const char* panel = this->Hint("panel"))
  {
    ShortenPanel(representation, panel);
  }
  if (!HasData(data))
  {
    this->WaitForData(representation, port);
  }
  if (this->Hint("own-levels", port) && Offers(representation, "Full Surface"))
  {
    vtkSMPropertyHelper(representation, "Representation").Set("Full Surface");
  }
  if (data)
  {
    if (port == 0)
    {
      this->ShowBlocks(representation, data->GetArrayInformation("SiteId", vtkDataObject::FIELD) != nullptr);
    }
    this->TakeColors(representation, data, port);
  }
  representation->UpdateVTKObjects();
}

//----------------------------------------------------------------------------
void NaturalDisplay::ShowBlocks(vtkSMProxy* representation, bool isForest)
{
  const char* blocks = isForest ? this->Hint("forest-blocks") : nullptr;
  blocks = blocks ? blocks : this->Hint("blocks");
  if (!blocks || !representation->GetProperty("BlockSelectors"))
  {
    return;
  }
  vtkSMPropertyHelper selectors(representation, "BlockSelectors");
  std::istringstream names(blocks);
  std::string name;
  for (unsigned int k = 0; names >> name; ++k)
  {
    selectors.Set(k, name.c_str());
  }
}

//----------------------------------------------------------------------------
void NaturalDisplay::TakeColors(vtkSMProxy* representation, vtkPVDataInformation* data, int port)
{
  if (data->GetArrayInformation("Normals", vtkDataObject::POINT) || this->Hint("direct-color", port))
  {
    ShadeSmoothly(representation, "Normals");
  }
  if (data->GetArrayInformation(NaturalColors, vtkDataObject::POINT))
  {
    ColorDirectly(representation, NaturalColors, true);
    this->WaitForLegend(representation);
  }
  else if (this->Hint("direct-color", port))
  {
    this->WaitForLegend(representation); // ParaView asks for the range of the array before it is there
  }
  if (const char* ambient = this->Hint("ambient", port))
  {
    ShadeAsWater(representation, std::strtod(ambient, nullptr));
  }
  if (const char* sky = this->Hint("sky", port))
  {
    ShadeUnderSky(representation, std::strtod(sky, nullptr));
  }
  if (AreParticles(data))
  {
    const char* smallest = this->Hint("sprite", port);
    ShowAsSprites(representation, data, smallest ? std::strtod(smallest, nullptr) : MinimumSprite);
  }
  if (const char* size = this->Hint("dots", port))
  {
    double ink[3] = { 0.16, 0.42, 0.30 };
    if (const char* color = this->Hint("ink", port))
    {
      ReadPlace(color, ink);
    }
    ShowAsDots(representation, std::strtod(size, nullptr), ink);
  }
  double given[3];
  const char* color = this->Hint("ink", port);
  const double* ink = color && ReadPlace(color, given) ? given : nullptr;
  const char* width = this->Hint("lines", port);
  if (width && data->GetDataSetType() == VTK_POLY_DATA)
  {
    DrawLines(representation, std::strtod(width, nullptr), ink);
  }
  const char* fog = this->Hint("fog", port);
  if (fog &&
    (data->GetArrayInformation(fog, vtkDataObject::POINT) || data->GetArrayInformation(fog, vtkDataObject::CELL)))
  {
    ShowAsFog(representation, data, fog, ink);
    this->WaitForLegend(representation);
  }
  const char* array = this->Hint("color", port);
  if (array && data->GetArrayInformation(array, vtkDataObject::POINT))
  {
    ColorByArray(representation, array, this->Hint("color-map", port));
    vtkSMRenderViewProxy* view = this->ActiveView();
    if (view && IsEmpty(view) && this->Hint("light", port))
    {
      ShowDarkLegend(representation, view, this->Hint("legend", port));
    }
  }
}

//----------------------------------------------------------------------------
/// Inputs that are missing at first leave nothing to take colors from.
void NaturalDisplay::WaitForData(vtkSMProxy* representation, int port)
{
  this->Empty = representation;
  this->EmptyPort = port;
  if (this->DataObserver == 0)
  {
    this->DataObserver = this->Owner->AddObserver(vtkCommand::UpdateDataEvent, this, &NaturalDisplay::OnData);
  }
}

//----------------------------------------------------------------------------
void NaturalDisplay::OnData(vtkObject*, unsigned long, void*)
{
  vtkPVDataInformation* data = this->Owner->GetDataInformation(this->EmptyPort);
  if (this->Empty && !HasData(data))
  {
    return;
  }
  this->Owner->RemoveObserver(this->DataObserver);
  this->DataObserver = 0;
  vtkSMProxy* representation = this->Empty;
  this->Empty = nullptr;
  if (!representation)
  {
    return;
  }
  this->Show(representation, this->EmptyPort);
  this->LookAtFirstData(representation);
}

//----------------------------------------------------------------------------
/// Resets the camera where nothing else is shown: it was placed for a picture of nothing, as after a mistake.
void NaturalDisplay::LookAtFirstData(vtkSMProxy* representation)
{
  auto* view = vtkSMRenderViewProxy::SafeDownCast(vtkSMViewProxy::FindView(representation));
  if (!view || this->Hint("eye") || this->Camera.IsWaiting())
  {
    return;
  }
  const std::vector<vtkSMProxy*> visible = VisibleIn(view);
  const bool isAlone = std::all_of(visible.begin(), visible.end(),
    [&](vtkSMProxy* one) { return vtkSMPropertyHelper(one, "Input").GetAsProxy() == this->Owner; });
  if (isAlone)
  {
    const char* closer = this->Hint("closer");
    this->Camera.ShowAll(view, closer ? std::strtod(closer, nullptr) : 1.0);
  }
}

//----------------------------------------------------------------------------
vtkSMRenderViewProxy* NaturalDisplay::ActiveView()
{
  vtkSMProxySelectionModel* active = this->Manager->GetSelectionModel("ActiveView");
  return active ? vtkSMRenderViewProxy::SafeDownCast(active->GetCurrentProxy()) : nullptr;
}

//----------------------------------------------------------------------------
/// ParaView shows the legend once the representation is in its view, which no event names: any of them can be that one.
void NaturalDisplay::WaitForLegend(vtkSMProxy* representation)
{
  if (std::find(this->Colored.begin(), this->Colored.end(), representation) == this->Colored.end())
  {
    this->Colored.emplace_back(representation);
  }
  StopObserving(this->Pictures);
  vtkNew<vtkSMProxyIterator> views; // of which two can have the same name
  views->SetSessionProxyManager(this->Manager);
  for (views->Begin("views"); !views->IsAtEnd(); views->Next())
  {
    if (auto* view = vtkSMRenderViewProxy::SafeDownCast(views->GetProxy()))
    {
      this->Pictures.push_back(
        { view, view->AddObserver(vtkCommand::StartEvent, this, &NaturalDisplay::OnStartOfPicture) });
    }
  }
}

//----------------------------------------------------------------------------
void NaturalDisplay::OnStartOfPicture(vtkObject* object, unsigned long, void*)
{
  vtkSMProxy* view = vtkSMProxy::SafeDownCast(object);
  std::vector<vtkWeakPointer<vtkSMProxy>> waiting;
  waiting.swap(this->Colored);
  for (const auto& one : waiting)
  {
    if (one && vtkSMViewProxy::FindView(one) == view)
    {
      this->TakeLegendAway(one, view);
    }
    else if (one) // in another view, or not yet in this one
    {
      this->Colored.push_back(one);
    }
  }
  if (this->Hidden && vtkSMPropertyHelper(this->Hidden, "Visibility").GetAsInt() != 0)
  {
    this->Hidden = nullptr;
  }
  if (this->Hidden && vtkSMViewProxy::FindView(this->Hidden) == view)
  {
    this->TakeLegendAway(this->Hidden, view); // the window shows it after other pictures of a view that is not empty
  }
  if (this->Colored.empty() && !this->Hidden)
  {
    StopObserving(this->Pictures);
  }
}

//----------------------------------------------------------------------------
void NaturalDisplay::TakeLegendAway(vtkSMProxy* representation, vtkSMProxy* view)
{
  // Colors of an array that was not known have no map, and so no legend.
  if (ColorHelper::GetUsingScalarColoring(representation) &&
    vtkSMPropertyHelper(representation, "LookupTable").GetAsProxy())
  {
    ColorHelper::SetScalarBarVisibility(representation, view, false);
  }
  const char* array = this->Hint("direct-color");
  if (array && vtkSMPropertyHelper(representation, "MapScalars").GetAsInt() != 0)
  {
    ColorDirectly(representation, array, false);
  }
}

//----------------------------------------------------------------------------
void NaturalDisplay::WatchDisplay(vtkSMProxy* representation)
{
  const auto isGone = [](const Observation& one) { return !one.Object; };
  this->Displays.erase(std::remove_if(this->Displays.begin(), this->Displays.end(), isGone), this->Displays.end());
  const auto watch = [&](const char* name, auto answer) {
    vtkSMProperty* property = representation->GetProperty(name);
    this->Displays.push_back({ property, property->AddObserver(vtkCommand::ModifiedEvent, this, answer) });
  };
  watch("Visibility", &NaturalDisplay::OnVisibility);
  watch("ColorArrayName", &NaturalDisplay::OnColors);
}

//----------------------------------------------------------------------------
/// ParaView shows a legend whenever a representation is shown again, though colors that are not mapped have none.
void NaturalDisplay::OnVisibility(vtkObject* object, unsigned long, void*)
{
  vtkSMProxy* representation = vtkSMProperty::SafeDownCast(object)->GetParent();
  if (representation && vtkSMPropertyHelper(representation, "Visibility").GetAsInt() != 0 &&
    vtkSMPropertyHelper(representation, "MapScalars").GetAsInt() == 0)
  {
    this->WaitForLegend(representation);
  }
}

//----------------------------------------------------------------------------
/// Natural colors are drawn as they are, and arrays that a user chooses instead, by their map.
void NaturalDisplay::OnColors(vtkObject* object, unsigned long, void*)
{
  vtkSMProxy* representation = vtkSMProperty::SafeDownCast(object)->GetParent();
  const char* array =
    representation ? vtkSMPropertyHelper(representation, "ColorArrayName").GetInputArrayNameToProcess() : nullptr;
  if (array && *array && !IsLoadingState(this->Manager))
  {
    vtkSMPropertyHelper(representation, "MapScalars").Set(std::strcmp(array, NaturalColors) != 0);
    representation->UpdateProperty("MapScalars");
  }
}

//----------------------------------------------------------------------------
/// Only then a view tells what it shows.
void NaturalDisplay::OnState(vtkObject*, unsigned long, void*)
{
  this->KeepSide(ViewThatShows(this->Manager, this->Owner));
}

//----------------------------------------------------------------------------
void NaturalDisplay::KeepSide(vtkSMRenderViewProxy* view)
{
  vtkPVXMLElement* look =
    this->Scene ? this->Scene.Get() : this->Owner->GetHints()->FindNestedElementByName("NaturalDisplay");
  EyeHeights heights;
  const bool hasLowest = look && look->GetScalarAttribute("lowest", &heights.Lowest) != 0;
  const bool hasHighest = look && look->GetScalarAttribute("highest", &heights.Highest) != 0;
  const bool hasElevation = look && look->GetScalarAttribute("least-elevation", &heights.Elevation) != 0;
  if (view && (hasLowest || hasHighest || hasElevation))
  {
    this->Drag.Keep(view, this->Owner, heights);
  }
}

//----------------------------------------------------------------------------
void NaturalDisplay::SetUpView(int port)
{
  vtkSMRenderViewProxy* view = this->ActiveView();
  const bool isMap = view && ShowsUpstream(view, this->Owner) &&
    (IsMap(view) || IsFlat(view) || (this->Hint("over-inputs", port) && !IsEmpty(view)));
  if (!view || (!IsEmpty(view) && !isMap))
  {
    return;
  }
  if (const char* mood = this->Hint("light"))
  {
    LightView(view, mood);
  }
  const char* eye = this->Hint("eye");
  const char* target = this->Hint("target");
  const char* elevation = this->Hint("elevation");
  const char* closer = this->Hint("closer");
  const char* angle = this->Hint("view-angle");
  vtkPVDataInformation* data = this->Owner->GetDataInformation(port);
  CameraPlace place;
  place.IsFixed = eye && target && ReadPlace(eye, place.Eye) && ReadPlace(target, place.Target);
  const double ratio = this->DepthRatio();
  place.Eye[2] *= ratio;
  place.Target[2] *= ratio;
  const bool isFromSide = place.IsFixed || (elevation && std::strtod(elevation, nullptr) < 90.0);
  place.IsOfFlatData = data && isFromSide && (IsLevel(data->GetBounds()) || IsPoint(data->GetBounds()));
  place.IsOnMap = isMap && isFromSide;
  if (place.IsOnMap)
  {
    HideAll(view); // and what takes its place is alone
  }
  vtkPVXMLElement* look = this->LookOf(0);
  place.IsBesideLight =
    look && look != this->Scene && look->GetNumberOfNestedElements() > 0 && TakesLandscapeLight(view);
  if (place.IsBesideLight)
  {
    MakeScene(this->Owner, look, view);
  }
  place.Elevation = elevation ? std::strtod(elevation, nullptr) : 0.0;
  place.Closer = closer ? std::strtod(closer, nullptr) : 1.0;
  place.Angle = angle ? std::strtod(angle, nullptr) : 0.0;
  if (place.IsFixed && HasFirstCamera(view))
  {
    // Filters that follow the camera have nothing to show before it is there.
    MoveCamera(view->GetActiveCamera(), place);
    TurnAboutFocus(view);
  }
  if (place.IsFixed || elevation)
  {
    this->Camera.WaitFor(view, place);
  }
}

}
