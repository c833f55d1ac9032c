// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSceneView_h
#define LittoralSceneView_h

#include <vector>

class vtkSMProxy;
class vtkSMRenderViewProxy;
class vtkSMSessionProxyManager;

namespace littoral
{

/// The active view, or the first one in three dimensions where a table or a chart is active; null if there is none.
vtkSMProxy* ViewOfScene(vtkSMSessionProxyManager* manager);

/// Whether a source, or what is made of it, is visible in a view.
bool Shows(vtkSMProxy* view, vtkSMProxy* source);

/// All views in three dimensions that show a source; the active one is the first, if it is one of them.
std::vector<vtkSMRenderViewProxy*> ViewsThatShow(vtkSMSessionProxyManager* manager, vtkSMProxy* source);

/// The first of them; null if there is none.
vtkSMRenderViewProxy* ViewThatShows(vtkSMSessionProxyManager* manager, vtkSMProxy* source);

/// Makes the view of a scene the active one.
void ActivateViewOfScene(vtkSMSessionProxyManager* manager);

}

#endif
