// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMNaturalDisplayProxy
 * @brief   a source that is first shown in its own colours
 *
 * ParaView colours by a colour map unless it is told otherwise. This proxy tells each new representation of its first
 * output to take the point array RGB, if there is one, as it is. Where the hint
 *
 *     <NaturalDisplay block="/Root/High" />
 *
 * names a block, only that one is shown at first. Later changes by the user, and those of a state file, stay.
 */
#ifndef vtkSMNaturalDisplayProxy_h
#define vtkSMNaturalDisplayProxy_h

#include "LittoralClientProxiesModule.h" // for export macro
#include "vtkSMSourceProxy.h"

class LITTORALCLIENTPROXIES_EXPORT vtkSMNaturalDisplayProxy : public vtkSMSourceProxy
{
public:
  static vtkSMNaturalDisplayProxy* New();
  vtkTypeMacro(vtkSMNaturalDisplayProxy, vtkSMSourceProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void UpdateVTKObjects() override;

protected:
  vtkSMNaturalDisplayProxy();
  ~vtkSMNaturalDisplayProxy() override;

private:
  vtkSMNaturalDisplayProxy(const vtkSMNaturalDisplayProxy&) = delete;
  void operator=(const vtkSMNaturalDisplayProxy&) = delete;

  void OnRegister(vtkObject* manager, unsigned long event, void* information);

  vtkWeakPointer<vtkObject> Manager;
  unsigned long Observer = 0;
};

#endif
