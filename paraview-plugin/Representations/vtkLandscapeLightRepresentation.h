// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLandscapeLightRepresentation
 * @brief   a light in ParaView's render view: a vtkLandscapePass, while it is visible
 *
 * The pass draws what the view shows, on each process that draws surfaces; what is hidden or removed leaves the view as
 * it was. Selections, and processes that only show pictures of others, are drawn as without a light. If several lights
 * are visible in a view, the first one that was shown holds.
 */
#ifndef vtkLandscapeLightRepresentation_h
#define vtkLandscapeLightRepresentation_h

#include "LittoralRepresentationsModule.h" // for export macro
#include "vtkPVDataRepresentation.h"
#include "vtkSmartPointer.h" // for the pass of the view

class vtkLandscapePass;
class vtkPVRenderView;

namespace littoral
{
class ViewLightPass;
}

class LITTORALREPRESENTATIONS_EXPORT vtkLandscapeLightRepresentation : public vtkPVDataRepresentation
{
public:
  static vtkLandscapeLightRepresentation* New();
  vtkTypeMacro(vtkLandscapeLightRepresentation, vtkPVDataRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Light of the view, with all properties; null by default: none. */
  void SetPass(vtkLandscapePass* pass);
  vtkLandscapePass* GetPass();
  ///@}

  ///@{
  /** Whether the sky is the background, or that of the view; default on. */
  void SetShowSky(bool shows);
  bool GetShowSky();
  ///@}

  int ProcessViewRequest(vtkInformationRequestKey* request, vtkInformation* in, vtkInformation* out) override;

  void SetVisibility(bool isVisible) override;

protected:
  vtkLandscapeLightRepresentation();
  ~vtkLandscapeLightRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkLandscapeLightRepresentation(const vtkLandscapeLightRepresentation&) = delete;
  void operator=(const vtkLandscapeLightRepresentation&) = delete;

  void Prepare(vtkPVRenderView* view, bool isRemote);
  void TakeOff(vtkPVRenderView* view);

  vtkSmartPointer<littoral::ViewLightPass> Light;
};

#endif
