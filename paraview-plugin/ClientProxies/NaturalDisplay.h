// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralNaturalDisplay_h
#define LittoralNaturalDisplay_h

#include "FirstCamera.h"
#include "Observation.h"
#include "SceneDrag.h"

#include "vtkSmartPointer.h" // for the look of a part of a scene
#include "vtkWeakPointer.h"  // for what is watched

#include <vector>

class vtkObject;
class vtkPVDataInformation;
class vtkPVXMLElement;
class vtkSMProxy;
class vtkSMRenderViewProxy;
class vtkSMSessionProxyManager;
class vtkSMSourceProxy;

namespace littoral
{

/**
 * First display of a source in ParaView: in its own colors, lit, and from the side where that is the better view.
 *
 * ParaView colors by a color map, with a legend, and looks down along z unless it is told otherwise. This gives each
 * new representation of a source what the hint of the proxy says:
 *
 *     <NaturalDisplay blocks="/Root/High/Skin /Root/High/Leaves" elevation="12" closer="2" light="land" />
 *
 *  - The point array RGB of the data is taken as it is; `direct-color` names an array of which that is known before
 * there are data, `color` one that a color map shows, `color-map` a preset for it, `legend` the title of
 * its legend.
 *  - A share `ambient` of the light comes from everywhere, for colors that have the sky in them, as those of water; a
 *    share `sky` is added to that of the lights, for leaves in the shade.
 *  - Particles are lit spheres with their radii, whatever the source, enlarged until the largest has the radius
 * `sprite` [diagonals of the data]; points with `dots` are dots of that size [pixels]; `lines` are of that width
 * [pixels], in the color `ink` if there is one, as the volume of the array of `fog` [1/m], of points or cells.
 *  - With `over-inputs` a view that shows nothing but what the filter is made of, as ParaView does, counts as empty.
 *  - What is connected to the property `replaces` is hidden in the view, for a proxy with the hint
 *    `<Visibility replace_input="0" />`, whose other inputs stay.
 *  - Only the properties `panel` of the display are in its panel without the gear.
 *  - `blocks` are the only ones that are shown at first, of the first output; of a scattered forest (field data SiteId)
 *    those of `forest-blocks`, if there are any. With `own-levels` the surface is not decimated while the camera moves:
 *    that would tear leaves and crowns to shreds.
 *  - Where the source is the first thing in its view, the camera looks from `elevation` [degrees] above the horizon, z
 *    upwards, and `closer` times closer than ParaView would go to show all, or from `eye` to `target` [m], with
 *    `view-angle` [degrees] if it is given; and the view gets the background and the sun of `light`, see LightView, if
 * it has ParaView's.
 *  - Parts inside of the hint are made in a view that takes a Landscape Light, see MakeScene.
 *  - A drag leaves the eye above `lowest` and below `highest` [m], and `least-elevation` above the horizon [degrees],
 * see SceneDrag.
 *
 * An output has the hint with its number as `port`, if there is one, else the one without.
 *
 * A source with the hint `<View type="RenderView" />` makes a render view the active one where a table or a chart is,
 * when it is registered, so that Apply shows it in that view and not in a new one.
 *
 * A source with a Scene brings the rest of a pipeline with it when it is first shown, and is hidden itself.
 *
 * Later changes by the user, and those of a state file, stay.
 */
class NaturalDisplay
{
public:
  explicit NaturalDisplay(vtkSMSourceProxy* owner)
    : Owner(owner)
  {
  }
  ~NaturalDisplay();
  NaturalDisplay(const NaturalDisplay&) = delete;
  void operator=(const NaturalDisplay&) = delete;

  /// Starts to follow the session; called when the owner has one, and whenever its properties have changed.
  void Watch();

  /// After undo and redo, which bring back the parts of a scene but not the camera.
  void TakeBack();

  /// Attributes that take the place of the hint.
  void SetLook(vtkPVXMLElement* look);

  /// The rest of the pipeline, see MakeScene. Its attributes are for the view.
  void SetScene(vtkPVXMLElement* scene);

private:
  vtkPVXMLElement* LookOf(int port);
  const char* Hint(const char* name, int port = 0);
  void OnRegister(vtkObject*, unsigned long, void* information);
  void TakeView();
  void HideReplaced();
  void HideOtherLights(vtkSMProxy* light);
  void MakeSceneOf(vtkSMProxy* representation);
  void LookAtInput();
  void Show(vtkSMProxy* representation, int port);
  void ShowBlocks(vtkSMProxy* representation, bool isForest);
  void TakeColors(vtkSMProxy* representation, vtkPVDataInformation* data, int port);
  void WaitForData(vtkSMProxy* representation, int port);
  void OnData(vtkObject*, unsigned long, void*);
  void LookAtFirstData(vtkSMProxy* representation);
  vtkSMRenderViewProxy* ActiveView();
  void WaitForLegend(vtkSMProxy* representation);
  void OnStartOfPicture(vtkObject* view, unsigned long, void*);
  void TakeLegendAway(vtkSMProxy* representation, vtkSMProxy* view);
  void WatchDisplay(vtkSMProxy* representation);
  void OnVisibility(vtkObject* property, unsigned long, void*);
  void OnColors(vtkObject* property, unsigned long, void*);
  void SetUpView(int port);
  void OnState(vtkObject*, unsigned long, void*);
  void KeepSide(vtkSMRenderViewProxy* view);
  double FollowDepth();
  double DepthRatio();

  vtkSMSourceProxy* Owner;
  vtkSmartPointer<vtkPVXMLElement> Look;
  vtkSmartPointer<vtkPVXMLElement> Scene;
  vtkWeakPointer<vtkSMSessionProxyManager> Manager;
  unsigned long RegisterObserver = 0;
  unsigned long StateObserver = 0;
  vtkWeakPointer<vtkSMProxy> Empty; ///< representation of a source that was shown without data
  int EmptyPort = 0;
  unsigned long DataObserver = 0;
  /// Representations whose legends would mean nothing, until the next pictures.
  std::vector<vtkWeakPointer<vtkSMProxy>> Colored;
  vtkWeakPointer<vtkSMProxy> Hidden; ///< representation that has no legend until it is shown
  std::vector<Observation> Pictures; ///< of all views, as long as some are colored or hidden
  std::vector<Observation> Displays; ///< of all representations
  FirstCamera Camera;
  SceneDrag Drag;
  double Depth = 0.0; ///< of the water of a scene that has one, as it was last [m]
};

}

#endif
