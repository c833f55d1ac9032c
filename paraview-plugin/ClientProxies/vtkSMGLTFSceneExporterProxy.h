// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMGLTFSceneExporterProxy
 * @brief   what a render view shows as one scene of glTF
 *
 * File, Export Scene. The data of all visible representations go to one vtkGLTFSceneWriter, the subproxy Writer, which is
 * where the data are, on the server if there is one: instances stay instances, and sources keep the names of the
 * pipeline browser. A source that is shown twice is written once; data that are no surfaces, such as texts and charts,
 * are left out. While WriteCamera is on, the scene has the camera of the view, unless its projection is parallel; while
 * WriteSun is on, a sun in the direction of the view's first directional light that stands still in the scene, if there
 * is one. Time is that of the view.
 */
#ifndef vtkSMGLTFSceneExporterProxy_h
#define vtkSMGLTFSceneExporterProxy_h

#include "LittoralClientProxiesModule.h" // for export macro
#include "vtkSMExporterProxy.h"

class LITTORALCLIENTPROXIES_EXPORT vtkSMGLTFSceneExporterProxy : public vtkSMExporterProxy
{
public:
  static vtkSMGLTFSceneExporterProxy* New();
  vtkTypeMacro(vtkSMGLTFSceneExporterProxy, vtkSMExporterProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Write() override;

  /// Render views can be exported.
  bool CanExport(vtkSMProxy* view) override;

protected:
  vtkSMGLTFSceneExporterProxy();
  ~vtkSMGLTFSceneExporterProxy() override;

private:
  vtkSMGLTFSceneExporterProxy(const vtkSMGLTFSceneExporterProxy&) = delete;
  void operator=(const vtkSMGLTFSceneExporterProxy&) = delete;
};

#endif
