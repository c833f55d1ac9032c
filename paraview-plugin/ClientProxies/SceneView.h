// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSceneView_h
#define LittoralSceneView_h

class vtkSMProxy;
class vtkSMSessionProxyManager;

namespace littoral
{

/// The active view, or the first one in three dimensions where a table or a chart is active; null if there is none.
vtkSMProxy* ViewOfScene(vtkSMSessionProxyManager* manager);

/// Makes it the active view.
void ActivateViewOfScene(vtkSMSessionProxyManager* manager);

}

#endif
